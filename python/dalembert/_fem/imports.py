"""Meshes and matrices from ABAQUS, ANSYS, and from any format that meshio reads; matrices made here."""

from __future__ import annotations

import contextlib
import io
import os
from collections.abc import Mapping
from typing import Any

import numpy as np

from dalembert._checks import FloatArray, IntArray, shape_error
from dalembert._fem import nastran
from dalembert._fem.abaqus import read_abaqus, read_abaqus_matrix
from dalembert._fem.ansys import (
    ReadElementsFromAnsysTxt,
    ReadMatrixDOFmappingVectorFromAnsysTxt,
    ReadMatrixFromAnsysMMF,
    ReadNodalCoordinatesFromAnsysTxt,
)
from dalembert._fem.assembly import assemble
from dalembert._fem.checks import Names, check_connected, check_elements
from dalembert._fem.elements import KINDS, blocks, turned
from dalembert._fem.materials import as_material
from dalembert._fem.progress import reporter
from dalembert._fem.sparse import MapSparseMatrixIndices
from dalembert._fem.surfaces import Surfaces, surface_triangles
from dalembert._io.files import file_to_read

# Kinds of elements by their names in meshio; all of them order their nodes as VTK does, as we do.
_MESHIO = {
    "tetra": "Tet4",
    "tetra10": "Tet10",
    "hexahedron": "Hex8",
    "hexahedron20": "Hex20",
    "hexahedron27": "Hex27",
    "wedge": "Wedge6",
    "wedge15": "Wedge15",
}


_MOST_REGIONS = 1000  # numbers of elements are no regions


def _read_by_meshio(name: str) -> Any:
    """Return the mesh of a file; all errors of meshio are raised as ValueError."""
    import meshio

    try:
        with contextlib.redirect_stdout(io.StringIO()):
            return meshio.read(name)
    except (Exception, SystemExit) as error:  # meshio ends the process for some files, and has errors without a text
        reason = str(error) if str(error) not in ("", "1") else type(error).__name__
        file_to_read("FEMinterface.ImportFromMeshio: mesh", name)
        raise ValueError(f"FEMinterface.ImportFromMeshio: {name}: meshio cannot read this file ({reason})") from error


class Imports(Surfaces):
    """Read meshes and matrices."""

    # -- ABAQUS

    def ImportFromAbaqusInputFile(
        self,
        fileName: str,
        typeName: str = "Part",
        name: str = "Part-1",
        verbose: bool = False,
        createSurfaceTrigs: bool = True,
        surfaceTrigsAll: bool = False,
    ) -> FloatArray:
        """Read nodes and solid elements of a part (or typeName='Instance'), with sets and materials; return positions.

        Numbers follow the order in the file, from 0. Positions are those of the part: the position of an instance in
        the assembly is ignored. Element sets with a section keep its material for AssembleMatrices, which
        integrates all elements fully, also those of types with reduced integration (C3D20R). Names of sets and
        materials may differ in case. Elements other than solids are ignored with a warning.
        """
        fileName = file_to_read("FEMinterface.ImportFromAbaqusInputFile: fileName", fileName)
        mesh = read_abaqus(fileName, typeName, name)
        self._new_mesh("ABAQUS", fileName, mesh.positions)
        if (mesh.node_labels != np.arange(1, len(mesh.positions) + 1)).any():
            self.metaData["nodeLabels"] = mesh.node_labels
        if (mesh.element_labels != np.arange(1, len(mesh.element_labels) + 1)).any():
            self.metaData["elementLabels"] = mesh.element_labels
        self.elements = [{"Name": "elements", **mesh.elements}]
        self.nodeSets = [_node_set(key, nodes) for key, nodes in mesh.node_sets.items()]
        for key, elements in mesh.element_sets.items():
            material = mesh.material_of(key)
            more = {"Material": material} if len(material) == 3 else {}
            self.elementSets.append({"Name": key, "ElementNumbers": elements, **more})
        if verbose:
            print(f"{fileName}: {len(mesh.positions)} nodes, {self.NumberOfElements()} elements")
        self._check_elements(fileName)
        if createSurfaceTrigs:
            self._set_surface(surface_triangles(list(blocks(self.elements)), interior=surfaceTrigsAll), verbose)
        return mesh.positions

    def ReadMassMatrixFromAbaqus(self, fileName: str, type: str = "SparseRowColumnValue") -> None:
        """Read a mass matrix that ABAQUS writes with *MATRIX OUTPUT, FORMAT=COORDINATE (or MATRIX INPUT)."""
        self.massMatrix = self._from_abaqus("ReadMassMatrixFromAbaqus", fileName)

    def ReadStiffnessMatrixFromAbaqus(self, fileName: str, type: str = "SparseRowColumnValue") -> None:
        """Read a stiffness matrix that ABAQUS writes with *MATRIX OUTPUT, FORMAT=COORDINATE (or MATRIX INPUT)."""
        self.stiffnessMatrix = self._from_abaqus("ReadStiffnessMatrixFromAbaqus", fileName)

    def _from_abaqus(self, function: str, fileName: str) -> Any:
        fileName = file_to_read(f"FEMinterface.{function}: fileName", fileName)
        return self._exported(function, fileName, read_abaqus_matrix(fileName))

    # -- ANSYS

    def ReadMassMatrixFromAnsys(
        self, fileName: str, dofMappingVectorFile: str, sparse: bool = True, verbose: bool = False
    ) -> None:
        """Read a mass matrix in the Matrix Market format; with sparse=False a dense one, separated by commas."""
        self.massMatrix = self._from_ansys("ReadMassMatrixFromAnsys", fileName, dofMappingVectorFile, sparse, verbose)

    def ReadStiffnessMatrixFromAnsys(
        self, fileName: str, dofMappingVectorFile: str, sparse: bool = True, verbose: bool = False
    ) -> None:
        """Read a stiffness matrix in the Matrix Market format; with sparse=False a dense one, separated by commas."""
        function = "ReadStiffnessMatrixFromAnsys"
        self.stiffnessMatrix = self._from_ansys(function, fileName, dofMappingVectorFile, sparse, verbose)

    def ReadNodalCoordinatesFromAnsys(self, fileName: str, verbose: bool = False) -> None:
        """Read nodes of an exported list."""
        self.nodes["Position"] = ReadNodalCoordinatesFromAnsysTxt(fileName, verbose)
        self.metaData |= {"source": "Ansys", "fileName": os.path.basename(fileName)}

    def ReadElementsFromAnsys(self, fileName: str, verbose: bool = False) -> None:
        """Read elements of an exported list, after the nodes, and make the surface."""
        self.elements.append(ReadElementsFromAnsysTxt(fileName, verbose))
        self.metaData |= {"source": "Ansys", "fileName": os.path.basename(fileName)}
        if "Position" in self.nodes:
            self._check_elements(fileName)
        self.VolumeToSurfaceElements(verbose)

    def _from_ansys(self, function: str, fileName: str, mapping: str, sparse: bool, verbose: bool) -> Any:
        fileName = file_to_read(f"FEMinterface.{function}: fileName", fileName)
        mapping = file_to_read(f"FEMinterface.{function}: dofMappingVectorFile", mapping)
        order = ReadMatrixDOFmappingVectorFromAnsysTxt(mapping)
        if sparse:
            triplets = ReadMatrixFromAnsysMMF(fileName, verbose)
        else:
            dense = np.loadtxt(fileName, delimiter=",", ndmin=2)
            rows, columns = np.nonzero(dense)
            triplets = np.column_stack([rows, columns, dense[rows, columns]])
        if len(triplets) and triplets[:, :2].max() >= len(order):
            text = f"{fileName} has {int(triplets[:, :2].max()) + 1} rows, but {mapping} has {len(order)} coordinates"
            raise ValueError(f"FEMinterface.{function}: {text}")
        MapSparseMatrixIndices(triplets, order)
        return self._exported(function, fileName, triplets)

    def _exported(self, function: str, fileName: str, triplets: FloatArray) -> Any:
        """A matrix of a file, as large as the mesh that has been read before."""
        from dalembert._fem.sparse import SparseTripletsToScipySparseCSR

        matrix = SparseTripletsToScipySparseCSR(triplets)
        size = self.NumberOfCoordinates() or max(matrix.shape)
        if max(matrix.shape) > size:
            text = f"{fileName} has {max(matrix.shape)} rows, but {self.NumberOfNodes()} nodes have {size} coordinates"
            raise ValueError(f"FEMinterface.{function}: {text}")
        matrix.resize(size, size)
        return matrix

    # -- meshio

    def ImportFromMeshio(self, mesh: Any, verbose: bool = False, scale: float = 1.0) -> FloatArray:
        """Read a mesh in any format that meshio knows, from a file or from a meshio.Mesh; return the positions.

        `scale` turns the unit of the file into m, 1e-3 for instance. Solid elements, point and cell sets are taken;
        elements of surfaces and lines are left out, and so are nodes that belong to them alone. Tetrahedra may be
        listed in either orientation. Regions with numbers, such as properties of NASTRAN, become element sets of names
        like 'nastran:ref:1'.
        """
        try:
            import meshio
        except ImportError:
            text = "the package meshio is needed; install it with 'pip install meshio'"
            raise ImportError(f"FEMinterface.ImportFromMeshio: {text}") from None
        name = "" if isinstance(mesh, meshio.Mesh) else os.fspath(mesh)
        read = _read_by_meshio(name) if name else mesh
        solid = [(i, cells) for i, cells in enumerate(read.cells) if cells.type in _MESHIO]
        if not solid:
            found = ", ".join(sorted({cells.type for cells in read.cells})) or "none"
            raise ValueError(f"FEMinterface.ImportFromMeshio: {name}: there are no solid elements; found: {found}")
        positions = np.asarray(read.points, dtype=float)[:, :3]
        if name.lower().endswith(nastran.SUFFIXES):
            positions = nastran.global_positions(name, positions)
        self._new_mesh("meshio", name, scale * positions)
        kinds = sorted({_MESHIO[cells.type] for _, cells in solid}, key=list(KINDS).index)
        grouped = {kind: [(i, cells.data) for i, cells in solid if _MESHIO[cells.type] == kind] for kind in kinds}
        points = self.GetNodePositionsAsArray()
        joined = {kind: np.vstack([data for _, data in part]) for kind, part in grouped.items()}
        self.elements = [{"Name": "elements"} | {kind: turned(kind, nodes, points) for kind, nodes in joined.items()}]
        starts, start = {}, 0
        for i, data in (entry for part in grouped.values() for entry in part):
            starts[i], start = start, start + len(data)
        for key, members in read.cell_sets_dict.items() if hasattr(read, "cell_sets_dict") else ():
            self._add_cell_set(key, members, read, starts)
        self.nodeSets = [_node_set(key, np.asarray(nodes, dtype=np.int64)) for key, nodes in read.point_sets.items()]
        self._regions(read, starts)
        self.RemoveUnconnectedNodes()
        self._check_elements(name or "meshio.Mesh")
        self.VolumeToSurfaceElements(verbose)
        if verbose:
            print(f"{name}: {self.NumberOfNodes()} nodes, {self.NumberOfElements()} elements")
        return self.GetNodePositionsAsArray()

    def _add_cell_set(self, name: str, members: Any, read: Any, starts: Mapping[int, int]) -> None:
        found: list[IntArray] = []
        for kind, numbers in members.items():
            same = [i for i, cells in enumerate(read.cells) if cells.type == kind]
            sizes = np.cumsum([0, *(len(read.cells[i].data) for i in same)])
            for i, low, high in zip(same, sizes[:-1], sizes[1:], strict=True):
                inside = numbers[(numbers >= low) & (numbers < high)]
                if i in starts and len(inside):
                    found.append(inside - low + starts[i])
        if found and not name.startswith("gmsh:"):
            self.elementSets.append({"Name": name, "ElementNumbers": np.concatenate(found).astype(np.int64)})

    def _regions(self, read: Any, starts: Mapping[int, int]) -> None:
        """Physical groups of gmsh, and other regions with numbers, such as properties of NASTRAN, as element sets."""
        for key, values in read.cell_data.items():
            if not key.startswith("gmsh:") and np.issubdtype(np.asarray(values[0]).dtype, np.integer):
                self._numbered_regions(key, values, starts)
        tags = read.cell_data.get("gmsh:physical")
        names = {int(value[0]): key for key, value in read.field_data.items() if int(value[1]) == 3}
        for tag, key in names.items() if tags is not None else ():
            parts = [np.flatnonzero(np.asarray(tags[i]) == tag) + start for i, start in starts.items()]
            if numbers := [part for part in parts if len(part)]:
                self.elementSets = [s for s in self.elementSets if s["Name"] != key]
                self.elementSets.append({"Name": key, "ElementNumbers": np.concatenate(numbers)})

    def _numbered_regions(self, key: str, values: Any, starts: Mapping[int, int]) -> None:
        numbers = np.unique(np.concatenate([np.ravel(values[i]) for i in starts]))
        for number in numbers if len(numbers) <= _MOST_REGIONS else ():
            members = [np.flatnonzero(np.ravel(values[i]) == number) + start for i, start in starts.items()]
            self.elementSets.append({"Name": f"{key}:{number}", "ElementNumbers": np.concatenate(members)})

    # -- meshes

    def SetMesh(self, positions: Any, elements: Mapping[str, Any], source: str = "user") -> None:
        """Take nodes (one line of x, y, z each, in m) and elements by kind, such as {'Tet10': array of nodes}.

        Kinds are Tet4, Tet10, Hex8, Hex20, Hex27, Wedge6 and Wedge15, nodes in the order of ABAQUS and VTK. The mesh is
        checked, and its surface is made; matrices and modes of a former mesh are removed.
        """
        if unknown := [kind for kind in elements if kind not in KINDS]:
            raise shape_error("FEMinterface.SetMesh: elements", f"kinds of {', '.join(KINDS)}", unknown[0])
        points = np.asarray(positions, dtype=float)
        if points.ndim != 2 or points.shape[1] != 3 or not np.isfinite(points).all():
            raise shape_error("FEMinterface.SetMesh: positions", "finite x, y and z of each node", positions)
        self._new_mesh(source, "", points)
        self.elements = [{"Name": "elements"} | {kind: np.asarray(elements[kind], dtype=np.int64) for kind in elements}]
        self._check_elements("FEMinterface.SetMesh")
        self.VolumeToSurfaceElements()

    def RemoveUnconnectedNodes(self) -> IntArray:
        """Remove nodes that belong to no element, before matrices are made; return the former numbers of the others."""
        positions, mesh = self.GetNodePositionsAsArray(), list(blocks(self.elements))
        kept = np.unique(np.concatenate([block.nodes.ravel() for block in mesh]))
        if len(kept) == len(positions):
            return kept
        if self.massMatrix is not None or self.stiffnessMatrix is not None:
            raise ValueError("FEMinterface.RemoveUnconnectedNodes: call it before matrices are read or made")
        new = np.full(len(positions), -1, dtype=np.int64)
        new[kept] = np.arange(len(kept))
        self.nodes["Position"] = positions[kept]
        for group in self.elements:
            group |= {kind: new[np.asarray(group[kind])] for kind in KINDS if kind in group}
        for part in self.surface:
            part |= {key: new[np.asarray(part[key])] for key in ("Trigs", "Quads") if key in part}
        for nodeSet in self.nodeSets:
            numbers = new[np.asarray(nodeSet["NodeNumbers"], dtype=np.int64)]
            nodeSet |= {"NodeWeights": np.asarray(nodeSet["NodeWeights"])[numbers >= 0]}
            nodeSet["NodeNumbers"] = numbers[numbers >= 0]
        if "nodeLabels" in self.metaData:
            self.metaData["nodeLabels"] = np.asarray(self.metaData["nodeLabels"])[kept]
        return kept

    def AssembleMatrices(
        self, material: Any = None, materials: Mapping[str, Any] | None = None, verbose: bool = False
    ) -> None:
        """Make mass and stiffness matrix of all solid elements by linear elasticity, with consistent masses.

        `material` is a KirchhoffMaterial, or a dictionary with youngsModulus (Pa), poissonsRatio and density (kg/m^3);
        `materials` has one for each element set, by name. Materials that an imported file has need neither.
        """
        mesh, where = list(blocks(self.elements)), "FEMinterface.AssembleMatrices"
        if not mesh:
            raise ValueError(f"{where}: there are no solid elements; import a mesh, or call SetMesh")
        positions = self.GetNodePositionsAsArray()
        self._check_elements(where)
        check_connected(mesh, positions, Names(self.metaData), where)
        constants = self._constants(where, material, materials)
        self.massMatrix, self.stiffnessMatrix = assemble(mesh, positions, constants, reporter(len(positions), verbose))

    def _constants(self, where: str, material: Any, materials: Mapping[str, Any] | None) -> FloatArray:
        """Shear modulus, Lame's constant and density of each element."""
        count = self.NumberOfElements()
        constants = np.full((count, 3), np.nan)
        if material is not None:
            constants[:] = _lame(where, material)
        sets = {s["Name"]: s for s in self.elementSets}
        if unknown := [name for name in materials or {} if name not in sets]:
            known = ", ".join(map(repr, sets)) or "none"
            raise ValueError(f"{where}: materials: there is no element set '{unknown[0]}'; there are: {known}")
        from_file = {name: s["Material"] for name, s in sets.items() if "Material" in s} if material is None else {}
        for name, chosen in (from_file | dict(materials or {})).items():
            constants[np.asarray(sets[name]["ElementNumbers"], dtype=np.int64)] = _lame(f"{where}: '{name}'", chosen)
        missing = np.flatnonzero(np.isnan(constants[:, 0]))
        if len(missing):
            text = f"{Names(self.metaData).some('element', missing)} has no material"
            raise ValueError(f"{where}: {text}; give `material`, or `materials` for its element set")
        return constants

    def _new_mesh(self, source: str, fileName: str, positions: FloatArray) -> None:
        self.metaData = {"source": source}
        if fileName:
            self.metaData["fileName"] = os.path.basename(fileName)
        self.nodes = {"Position": positions}
        self.elements, self.surface, self.nodeSets, self.elementSets = [], [], [], []
        self.massMatrix = self.stiffnessMatrix = None
        self.modeBasis, self.eigenValues, self.postProcessingModes = {}, [], {}

    def _check_elements(self, where: str) -> None:
        check_elements(list(blocks(self.elements)), self.GetNodePositionsAsArray(), Names(self.metaData), where)


def _lame(where: str, material: Any) -> list[float]:
    chosen = as_material(f"{where}: material", material)
    return [*chosen.LameParameters(), chosen.density]


def _node_set(name: str, nodes: IntArray) -> dict[str, Any]:
    return {"Name": name, "NodeNumbers": nodes, "NodeWeights": np.full(len(nodes), 1.0 / max(len(nodes), 1))}
