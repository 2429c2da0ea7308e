"""Meshes of NGsolve, with the matrices that it makes; and nonlinear elasticity by NGsolve as user functions.

NGsolve is imported where it is used. It orders coordinates as all x, all y, all z.
"""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from dalembert._checks import IntArray, shape_error
from dalembert._fem.elements import KINDS, turned
from dalembert._fem.imports import Imports
from dalembert._fem.materials import as_material, coefficient_functions
from dalembert._fem.sparse import ResortIndicesExudyn2NGvector, ResortIndicesOfNGvector
from dalembert._tools.later import scipy


def _ngsolve(function: str) -> Any:
    try:
        import ngsolve
    except ImportError:
        text = "the package ngsolve is needed; install it with 'pip install ngsolve'"
        raise ImportError(f"FEMinterface.{function}: {text}") from None
    return ngsolve


def _matrix(form: Any) -> Any:
    """Matrix of a bilinear form, with coordinates ordered node by node."""
    matrix = scipy.sparse.csr_matrix(form.mat.CSR(), copy=True)
    order = np.arange(matrix.shape[0]).reshape(3, -1).T.ravel()
    return matrix[order][:, order].tocsr()


def _tetrahedra(ngmesh: Any, positions: Any, order: int) -> tuple[IntArray, IntArray]:
    """Nodes of the elements in our order, and the region of each."""
    kind = KINDS["Tet4" if order == 1 else "Tet10"]
    rows, regions = [], []
    for number, element in enumerate(ngmesh.Elements3D()):
        if len(element.points) != kind.count:
            raise ValueError(
                f"FEMinterface.ImportMeshFromNGsolve: element {number} has {len(element.points)} nodes, "
                f"tetrahedra with {kind.count} are needed for meshOrder={order}"
            )
        rows.append([point.nr - 1 for point in element.points])
        regions.append(element.index - 1)
    if not rows:
        raise ValueError(
            "FEMinterface.ImportMeshFromNGsolve: the mesh has no tetrahedra. Netgen makes none where a surface is not "
            "closed or has triangles without area, and says so when it makes the mesh"
        )
    nodes = np.array(rows, dtype=np.int64)
    nodes[:, :4] = turned("Tet4", nodes[:, :4], positions)
    if order == 2:  # nodes on edges in our order, found by where they are
        middles = positions[nodes[:, 4:]]
        for place, (i, j) in enumerate(kind.edges):
            target = 0.5 * (positions[nodes[:, i]] + positions[nodes[:, j]])
            nearest = np.linalg.norm(middles - target[:, None], axis=2).argmin(axis=1)
            rows_of = np.array(rows, dtype=np.int64)[:, 4:]
            nodes[:, 4 + place] = rows_of[np.arange(len(nodes)), nearest]
    return nodes, np.array(regions, dtype=np.int64)


class WithNGsolve(Imports):
    """Functions that need NGsolve."""

    def GetNodesOfNGsolveBoundary(self, mesh: Any, boundaryName: str) -> list[int]:
        """Nodes of the boundary with a name."""
        names = mesh.GetBoundaries()
        if boundaryName not in names:
            known = ", ".join(map(repr, dict.fromkeys(names)))
            raise ValueError(f"FEMinterface: the mesh has no boundary '{boundaryName}'; there are {known}")
        parts = (
            e for e in mesh.ngmesh.Elements2D() if 0 < e.index <= len(names) and names[e.index - 1] == boundaryName
        )
        return sorted({node.nr - 1 for element in parts for node in element.points})

    def CreateNGsolveBoundaryNodeSets(
        self, mesh: Any, boundaryNamesList: Sequence[str] | None = None, warnNodeSets: bool = True
    ) -> list[dict[str, Any]]:
        """Node sets of boundaries of the mesh, all of them if no names are given, weighted by surface areas."""
        names = list(dict.fromkeys(mesh.GetBoundaries())) if boundaryNamesList is None else boundaryNamesList
        sets = []
        for name in names:
            nodes = np.array(self.GetNodesOfNGsolveBoundary(mesh, name), dtype=np.int64)
            try:
                weights = self.GetNodeWeightsFromSurfaceAreas(nodes)
            except ValueError:  # a boundary inside of the mesh, between two regions
                if warnNodeSets:
                    print(f"FEMinterface: boundary '{name}' is not on the surface: all of its nodes count the same")
                weights = np.full(len(nodes), 1.0 / max(len(nodes), 1))
            sets.append({"Name": name, "NodeNumbers": nodes, "NodeWeights": weights, "type": "boundary"})
        return sets

    def ImportMeshFromNGsolve(
        self,
        mesh: Any,
        density: float | None = None,
        youngsModulus: float | None = None,
        poissonsRatio: float | None = None,
        materials: Mapping[str, Mapping[str, float]] | None = None,
        createBoundaryNodeSets: bool = True,
        boundaryNamesList: Sequence[str] | None = None,
        verbose: bool = False,
        meshOrder: int = 1,
        **kwargs: Any,
    ) -> list[Any]:
        """Take nodes, tetrahedra, matrices and named boundaries of a mesh; return [mass form, stiffness form, space].

        The material is a single one, or a dictionary with youngsModulus, poissonsRatio and density for each region.
        meshOrder 2 makes quadratic tetrahedra, which are much more accurate. Regions become element sets.
        """
        where = "FEMinterface.ImportMeshFromNGsolve"
        ngs = _ngsolve("ImportMeshFromNGsolve")
        if kwargs:
            warnings.warn(f"{where}: {', '.join(kwargs)}: unknown arguments, ignored", stacklevel=2)
        if meshOrder not in (1, 2):
            raise shape_error(f"{where}: meshOrder", "1 or 2", meshOrder)
        constants: Any = (density, youngsModulus, poissonsRatio)
        if materials is None:
            as_material(where, {"youngsModulus": youngsModulus, "poissonsRatio": poissonsRatio, "density": density})
        elif any(value is not None for value in constants):
            raise ValueError(f"{where}: give either materials, or density, youngsModulus and poissonsRatio")
        if meshOrder == 2:
            mesh.ngmesh.SecondOrder()
        space = ngs.VectorH1(mesh, order=1) if meshOrder == 1 else ngs.NodalFESpace(mesh, order=2) ** 3
        rho, modulus, ratio = constants if materials is None else coefficient_functions(where, mesh, materials)
        mu, lame = modulus / (2 * (1 + ratio)), modulus * ratio / ((1 + ratio) * (1 - 2 * ratio))
        u, v = space.TnT()
        strain = ngs.Sym(ngs.Grad(u))
        stress = 2 * mu * strain + lame * ngs.Trace(strain) * ngs.Id(3)
        stiffness = ngs.BilinearForm(space)
        stiffness += ngs.InnerProduct(stress, ngs.Sym(ngs.Grad(v))) * ngs.dx
        mass = ngs.BilinearForm(space)
        mass += rho * u * v * ngs.dx
        with ngs.TaskManager():
            stiffness.Assemble()
            mass.Assemble()
        self._take_ngmesh(mesh, meshOrder)
        self.massMatrix, self.stiffnessMatrix = _matrix(mass), _matrix(stiffness)
        if createBoundaryNodeSets:
            self.nodeSets = self.CreateNGsolveBoundaryNodeSets(mesh, boundaryNamesList)
        if verbose:
            print(f"NGsolve: {self.NumberOfNodes()} nodes, {self.NumberOfElements()} elements")
        return [mass, stiffness, space]

    def _take_ngmesh(self, mesh: Any, order: int) -> None:
        points = mesh.vertices if order == 1 else mesh.ngmesh.Points()
        positions = np.array([point.point if order == 1 else list(point) for point in points], dtype=float)
        nodes, regions = _tetrahedra(mesh.ngmesh, positions, order)
        self._new_mesh("NGsolve", "", positions)
        self.elements = [{"Name": "NGsolve", "Tet4" if order == 1 else "Tet10": nodes}]
        names = mesh.GetMaterials()
        for name in dict.fromkeys(names):
            chosen = np.flatnonzero(np.isin(regions, [i for i, other in enumerate(names) if other == name]))
            self.elementSets.append({"Name": name, "ElementNumbers": chosen})
        self.VolumeToSurfaceElements()

    def ComputeEigenmodesNGsolve(
        self,
        bfM: Any,
        bfK: Any,
        nModes: int,
        maxEigensolveIterations: int = 40,
        excludeRigidBodyModes: int = 0,
        verbose: bool = False,
    ) -> None:
        """The same as ComputeEigenmodes, with the matrices of bilinear forms of NGsolve."""
        self.massMatrix, self.stiffnessMatrix = _matrix(bfM), _matrix(bfK)
        self.ComputeEigenmodes(nModes, excludeRigidBodyModes)  # type: ignore[attr-defined]

    def ComputeHurtyCraigBamptonModesNGsolve(
        self,
        bfM: Any,
        bfK: Any,
        boundaryNodesList: Sequence[Sequence[int]],
        nEigenModes: int,
        maxEigensolveIterations: int = 40,
        verbose: bool = False,
    ) -> None:
        """The same as ComputeHurtyCraigBamptonModes with rigid interfaces, with the matrices of NGsolve."""
        self.massMatrix, self.stiffnessMatrix = _matrix(bfM), _matrix(bfK)
        self.ComputeHurtyCraigBamptonModes(boundaryNodesList, nEigenModes, verboseMode=verbose)  # type: ignore[attr-defined]

    def ComputePostProcessingModesNGsolve(
        self,
        fes: Any,
        material: Any = 0,
        outputVariableType: Any = "OutputVariableType.StressLocal",
        verbose: bool = False,
    ) -> None:
        """The same as ComputePostProcessingModes; material may be one with the regions of the mesh."""
        if getattr(material, "useMaterials", False):
            material = dict(material.materials)
        self.ComputePostProcessingModes(material, outputVariableType)  # type: ignore[attr-defined]

    def CreateNonlinearFEMObjectGenericODE2NGsolve(
        self,
        mbs: Any,
        mesh: Any,
        density: float,
        youngsModulus: float,
        poissonsRatio: float,
        meshOrder: int = 1,
        color: Sequence[float] = [0.9, 0.4, 0.4, 1.0],
    ) -> list[Any]:
        """Add a mesh with large deformations as ObjectGenericODE2 with a NodePoint for each node: [object, nodes].

        The material is that of Saint-Venant and Kirchhoff; forces and their derivatives are computed by NGsolve.
        """
        from dalembert._names import eii, exu

        ngs = _ngsolve("CreateNonlinearFEMObjectGenericODE2NGsolve")
        self.ImportMeshFromNGsolve(mesh, density, youngsModulus, poissonsRatio, meshOrder=meshOrder)
        mu, lame = as_material(
            "density, youngsModulus, poissonsRatio",
            {"youngsModulus": youngsModulus, "poissonsRatio": poissonsRatio, "density": density},
        ).LameParameters()
        space = ngs.NodalFESpace(mesh, order=meshOrder) ** 3
        gradient = ngs.Grad(space.TrialFunction())
        strain = ngs.Sym(gradient) + 0.5 * gradient.trans * gradient
        energy = mu * ngs.InnerProduct(strain, strain) + 0.5 * lame * ngs.Trace(strain) ** 2
        form = ngs.BilinearForm(space)
        form += ngs.Variation(energy.Compile() * ngs.dx)
        field = ngs.GridFunction(space)
        forces = field.vec.CreateVector()

        def force(mbs: Any, t: float, itemNumber: Any, q: Any, q_t: Any) -> Any:
            field.vec.FV().NumPy()[:] = ResortIndicesExudyn2NGvector(q)
            form.Apply(field.vec, forces)
            return ResortIndicesOfNGvector(-forces.FV().NumPy())

        def jacobian(mbs: Any, t: float, itemNumber: Any, q: Any, q_t: Any, fODE2: float, fODE2_t: float) -> Any:
            field.vec.FV().NumPy()[:] = ResortIndicesExudyn2NGvector(q)
            form.AssembleLinearization(field.vec)
            return exu.MatrixContainer(fODE2 * _matrix(form))

        nodes = [mbs.AddNode(eii.NodePoint(referenceCoordinates=point)) for point in self.GetNodePositionsAsArray()]
        body = eii.ObjectGenericODE2(
            nodeNumbers=nodes,
            massMatrix=exu.MatrixContainer(self.GetMassMatrix()),
            forceUserFunction=force,
            jacobianUserFunction=jacobian,
            visualization={"triangleMesh": self.GetSurfaceTriangles(), "color": list(color)},
        )
        return [mbs.AddObject(body), nodes]
