"""Finite element meshes: import, matrices, modes and stresses, and flexible bodies made of them.

FEMinterface holds a mesh with its matrices; it reads files of ABAQUS and ANSYS, meshes of NGsolve and all formats of
meshio, or computes the matrices. ObjectFFRFreducedOrderInterface makes a flexible body from the modes.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from enum import Enum
from typing import Any

import numpy.typing as npt

from dalembert._checks import FloatArray, as_array, shape_error
from dalembert._fem.abaqus import ReadNodesFromAbaqusInp
from dalembert._fem.ansys import (
    ReadElementsFromAnsysTxt,
    ReadMatrixDOFmappingVectorFromAnsysTxt,
    ReadMatrixFromAnsysMMF,
    ReadNodalCoordinatesFromAnsysTxt,
)
from dalembert._fem.campbell import dense_frequencies, gyroscopic_matrix, plot_campbell, sparse_frequencies
from dalembert._fem.checks import Names, check_matrices
from dalembert._fem.data import FileNameToMode
from dalembert._fem.eigen import lowest_modes
from dalembert._fem.elements import blocks
from dalembert._fem.floating_frame import ObjectFFRFinterface
from dalembert._fem.interfaces import averaged_modes, exact_modes, interfaces_of
from dalembert._fem.materials import FiniteElement, KirchhoffMaterial, MaterialBaseClass, Tet4, as_material
from dalembert._fem.modal_body import CMSObjectComputeNorm, ObjectFFRFreducedOrderInterface
from dalembert._fem.ngsolve import WithNGsolve
from dalembert._fem.node_selection import NodeSelection
from dalembert._fem.progress import reporter
from dalembert._fem.sparse import (
    AddEntryToCompressedRowSparseArray,
    CheckForSciPyMatrix,
    CompressedRowSparseToDenseMatrix,
    ConvertDenseToCompressedRowMatrix,
    CSRtoRowsAndColumns,
    CSRtoScipySparseCSR,
    MapSparseMatrixIndices,
    ResortIndicesExudyn2NGvector,
    ResortIndicesOfCSRmatrix,
    ResortIndicesOfNGvector,
    ScipySparseCSRtoCSR,
    SparseTripletsToScipySparseCSR,
)
from dalembert._fem.stresses import nodal_strains
from dalembert._fem.surfaces import ConvertHexToTrigs, ConvertTetToTrigs
from dalembert._names import eii, exu, np
from dalembert._tools.later import scipy
from dalembert.advancedUtilities import IsListOrArray, IsValidURealInt, PlotLineCode, RoundMatrix
from dalembert.graphicsDataUtilities import ComputeTriangleArea
from dalembert.rigidBodyUtilities import (
    AngularVelocity2EulerParameters_t,
    ComputeSkewMatrix,
    EulerParameters2GLocal,
    GetRigidBodyNode,
    RigidBodyInertia,
    RotationVector2GLocal,
    RotXYZ2GLocal,
    RotXYZ2GLocal_t,
    Skew,
    StrNodeType2NodeType,
    eulerParameters0,
)

__all__ = [
    "AddEntryToCompressedRowSparseArray",
    "AngularVelocity2EulerParameters_t",
    "CMSObjectComputeNorm",
    "CSRtoRowsAndColumns",
    "CSRtoScipySparseCSR",
    "CheckForSciPyAndError",
    "CheckForSciPyAndWarn",
    "CheckForSciPyMatrix",
    "CompressedRowSparseToDenseMatrix",
    "ComputeSkewMatrix",
    "ComputeTriangleArea",
    "ConvertDenseToCompressedRowMatrix",
    "ConvertHexToTrigs",
    "ConvertTetToTrigs",
    "CyclicCompareReversed",
    "Enum",
    "EulerParameters2GLocal",
    "FEMinterface",
    "FileNameToMode",
    "FiniteElement",
    "GetRigidBodyNode",
    "HCBstaticModeSelection",
    "IsListOrArray",
    "IsValidURealInt",
    "KirchhoffMaterial",
    "MapSparseMatrixIndices",
    "MaterialBaseClass",
    "ObjectFFRFinterface",
    "ObjectFFRFreducedOrderInterface",
    "PlotLineCode",
    "ReadElementsFromAnsysTxt",
    "ReadMatrixDOFmappingVectorFromAnsysTxt",
    "ReadMatrixFromAnsysMMF",
    "ReadNodalCoordinatesFromAnsysTxt",
    "ReadNodesFromAbaqusInp",
    "ResortIndicesExudyn2NGvector",
    "ResortIndicesOfCSRmatrix",
    "ResortIndicesOfNGvector",
    "RigidBodyInertia",
    "RotXYZ2GLocal",
    "RotXYZ2GLocal_t",
    "RotationVector2GLocal",
    "RoundMatrix",
    "ScipySparseCSRtoCSR",
    "Skew",
    "SparseTripletsToScipySparseCSR",
    "StrNodeType2NodeType",
    "Tet4",
    "VectorDiadicUnitMatrix3D",
    "WarnNumpy2",
    "eii",
    "eulerParameters0",
    "exu",
    "np",
    "os",
]


def WarnNumpy2() -> bool:
    """Whether numpy 2 is installed; it needs no warning here."""
    return int(np.__version__.split(".")[0]) >= 2


def CheckForSciPyAndWarn() -> None:
    """scipy is always installed together with this package."""


def CheckForSciPyAndError(stringWhere: str = "") -> None:
    """scipy is always installed together with this package."""


def VectorDiadicUnitMatrix3D(v: npt.ArrayLike) -> FloatArray:
    """v times the 3x3 unit matrix, one below the other: 3n rows, 3 columns."""
    column = as_array("VectorDiadicUnitMatrix3D: v", v).reshape(-1, 1)
    return np.asarray(np.kron(column, np.eye(3)), np.float64)


def CyclicCompareReversed(list1: Sequence[int], list2: Sequence[int]) -> bool:
    """Whether list2 read backwards is list1, up to a rotation."""
    for name, values in (("list1", list1), ("list2", list2)):
        if not isinstance(values, (list, tuple, np.ndarray)):
            raise shape_error(f"CyclicCompareReversed: {name}", "a list of numbers", values)
    backwards, n = list(list2)[::-1], len(list1)
    return len(backwards) == n and any(backwards[i:] + backwards[:i] == list(list1) for i in range(max(n, 1)))


class HCBstaticModeSelection(Enum):
    """Static modes of boundaries in the method of Hurty, Craig and Bampton."""

    allBoundaryNodes = 1
    RBE2 = 2
    RBE3 = 3
    noStaticModes = 4


class FEMinterface(NodeSelection, WithNGsolve):
    """Nodes, elements, matrices and modes of a finite element mesh.

    nodes: {'Position': x, y, z of each node}; elements: [{'Name': ..., 'Tet10': nodes of each element, ...}], kinds are
    Tet4, Tet10, Hex8, Hex20, Hex27, Wedge6, Wedge15; surface: [{'Name': ..., 'Trigs': nodes of each triangle}];
    nodeSets: [{'Name': ..., 'NodeNumbers': ..., 'NodeWeights': ..., 'type': 'boundary'}]; elementSets: [{'Name': ...,
    'ElementNumbers': ...}]; modeBasis: {'matrix': one column per mode, 'type': ...}; eigenValues (1/s^2);
    postProcessingModes: {'matrix': 6 columns per mode, one row per node, 'outputVariableType': ...}.
    """

    def _mode_matrices(self, where: str) -> tuple[Any, Any, FloatArray]:
        """Mass and stiffness matrix and positions of nodes, checked."""
        mass, stiffness = self.GetMassMatrix(), self.GetStiffnessMatrix()
        size = self.NumberOfCoordinates() or mass.shape[0]
        check_matrices(mass, stiffness, size, Names(self.metaData), f"FEMinterface.{where}")
        if "Position" in self.nodes:
            return mass, stiffness, self.GetNodePositionsAsArray()
        in_a_row = np.arange(size // 3, dtype=float)  # matrices alone: next to each other are nodes of similar numbers
        return mass, stiffness, np.stack([in_a_row, 0 * in_a_row, 0 * in_a_row], axis=1)

    def CheckConsistency(self) -> None:
        """Refuse matrices that do not fit the nodes, are not symmetric, or have nodes without mass or stiffness."""
        self._check_elements("FEMinterface.CheckConsistency")
        self._mode_matrices("CheckConsistency")

    def GetRigidBodyInertia(self) -> RigidBodyInertia:
        """Mass, centre of mass and inertia about the origin, by the mass matrix."""
        mass, points = self.GetMassMatrix(), self.GetNodePositionsAsArray()
        arms = ComputeSkewMatrix(points.ravel())
        translations = np.tile(np.eye(3), (len(points), 1))
        total = float((translations.T @ (mass @ translations))[0, 0])
        centre = translations.T @ (mass @ points.ravel()) / total
        return RigidBodyInertia(total, arms.T @ (mass @ arms), centre)

    # -- modes

    def ComputeEigenmodes(self, nModes: int, excludeRigidBodyModes: int = 0, useSparseSolver: bool = True) -> None:
        """Lowest eigenvalues and modes, with unit modal masses, into eigenValues and modeBasis.

        The mesh is free unless it has elastic supports; excludeRigidBodyModes=6 leaves out the modes of rigid motions.
        The dense solver stores all eigenvalues in eigenValues, also those of modes that are not kept.
        """
        where = "FEMinterface.ComputeEigenmodes"
        mass, stiffness, points = self._mode_matrices("ComputeEigenmodes")
        count, progress = nModes + excludeRigidBodyModes, reporter(len(points), False)
        dense = not useSparseSolver
        found = mass.shape[0] if dense else count
        values, modes = lowest_modes(where, mass, stiffness, points, found, progress, dense)
        kept = values if dense else values[excludeRigidBodyModes:]
        self._set_modes(modes[:, excludeRigidBodyModes:count], "NormalModes", kept)

    def ComputeEigenModesWithBoundaryNodes(
        self, boundaryNodes: Sequence[int], nEigenModes: int, useSparseSolver: bool = True
    ) -> None:
        """Lowest eigenvalues and modes with all coordinates of the given nodes fixed."""
        if len(boundaryNodes) == 0:
            self.ComputeEigenmodes(nEigenModes, useSparseSolver=useSparseSolver)
            return
        where = "FEMinterface.ComputeEigenModesWithBoundaryNodes"
        mass, stiffness, points = self._mode_matrices("ComputeEigenModesWithBoundaryNodes")
        fixed, progress = interfaces_of(where, [boundaryNodes], [], points), reporter(len(points), False)
        found = exact_modes(where, mass, stiffness, points, fixed, nEigenModes, True, False, progress)
        self._set_modes(found[0], "NormalModes", found[1])

    def ComputeHurtyCraigBamptonModes(
        self,
        boundaryNodesList: Sequence[Sequence[int]],
        nEigenModes: int,
        useSparseSolver: bool = True,
        computationMode: HCBstaticModeSelection = HCBstaticModeSelection.RBE2,
        boundaryNodesWeights: Sequence[Sequence[float]] = [],
        excludeRigidBodyMotion: bool = True,
        RBE3secondMomentOfAreaWeighting: bool = True,
        numberOfRigidBodyModes: int | None = None,
        verboseMode: bool = False,
        timerTreshold: int = 20000,
    ) -> None:
        """Static modes of interfaces, each a list of nodes, and eigenmodes with interfaces held, into modeBasis.

        RBE2: interfaces are rigid; RBE3: weighted means of displacements and their moments are held; both give three
        translations and three rotations of each interface, those of the first left out by excludeRigidBodyMotion.
        allBoundaryNodes: one mode for each coordinate of all nodes, rigid motions among them; noStaticModes:
        eigenmodes only. GetNodeWeightsFromSurfaceAreas computes suitable weights. If there are no interfaces,
        nEigenModes free modes are computed, and the first numberOfRigidBodyModes (6) of them are omitted.
        """
        where = "FEMinterface.ComputeHurtyCraigBamptonModes"
        mass, stiffness, points = self._mode_matrices("ComputeHurtyCraigBamptonModes")
        progress = reporter(mass.shape[0], verboseMode, timerTreshold)
        interfaces = interfaces_of(where, boundaryNodesList, boundaryNodesWeights, points)
        if not interfaces:
            left_out = (6 if numberOfRigidBodyModes is None else numberOfRigidBodyModes) * bool(excludeRigidBodyMotion)
            self.ComputeEigenmodes(max(nEigenModes - left_out, 0), left_out, useSparseSolver)
            return
        if computationMode == HCBstaticModeSelection.RBE3:
            by_moments = RBE3secondMomentOfAreaWeighting
            modes, values = averaged_modes(
                where, mass, stiffness, points, interfaces, nEigenModes, by_moments, progress
            )
            static = 6
        else:
            rigid = computationMode == HCBstaticModeSelection.RBE2
            with_static = computationMode != HCBstaticModeSelection.noStaticModes
            arguments = (mass, stiffness, points, interfaces, nEigenModes, rigid, with_static, progress)
            modes, values, sizes = exact_modes(where, *arguments)
            static = sizes[0] if rigid else 0
        first = static if excludeRigidBodyMotion else 0
        if modes.shape[1] == first:
            raise ValueError(f"{where}: there is no mode: give another interface, or nEigenModes > 0")
        self._set_modes(modes[:, first:], "HCBmodes", values)

    def AddModes(self, modes: npt.ArrayLike, tolerance: float = 1e-8) -> int:
        """Add shapes of the user's choice (one column each) to the modes; return how many columns were added.

        Each shape is orthogonalized with respect to the previous modes; dependent shapes are omitted, and remaining
        ones
        are scaled to unit modal mass. Eigenvalues of the previous modes do not change.
        """
        mass = self.GetMassMatrix()
        given = np.asarray(modes, dtype=float).reshape(mass.shape[0], -1)
        basis = np.asarray(self.modeBasis.get("matrix", np.zeros((mass.shape[0], 0))), dtype=float)
        before = basis.shape[1]
        span = basis
        if before:
            gram = np.linalg.cholesky(basis.T @ (mass @ basis))
            span = np.linalg.solve(gram, basis.T).T
        for column in given.T:
            size = np.sqrt(column @ (mass @ column))
            rest = column - span @ (span.T @ (mass @ column))
            rest = rest - span @ (span.T @ (mass @ rest))
            length = np.sqrt(rest @ (mass @ rest))
            if length > tolerance * size:
                span = np.column_stack([span, rest / length])
        added = span[:, before:]
        self._set_modes(np.hstack([basis, added]), self.modeBasis.get("type", "UserModes"), self.eigenValues)
        return int(added.shape[1])

    def _set_modes(self, modes: FloatArray, kind: str, values: Any) -> None:
        self.modeBasis = {"matrix": modes, "type": kind}
        self.eigenValues = np.abs(np.asarray(values, dtype=float))
        self.postProcessingModes = {}

    def GetEigenFrequenciesHz(self) -> FloatArray:
        """Frequencies of the computed eigenmodes in Hz."""
        return np.sqrt(np.asarray(self.eigenValues, dtype=float)) / (2 * np.pi)

    # -- stresses and strains

    def ComputePostProcessingModes(
        self, material: Any = 0, outputVariableType: Any = "OutputVariableType.StressLocal", numberOfThreads: int = 1
    ) -> None:
        """Stresses (Pa) or strains at all nodes for each mode, which flexible bodies superpose.

        `material` is a KirchhoffMaterial, or a dictionary with one for each element set; strains need none. Values are
        means over the elements at a node. One thread is always used.
        """
        where = "FEMinterface.ComputePostProcessingModes"
        kind = str(outputVariableType)
        if kind not in ("OutputVariableType.StressLocal", "OutputVariableType.StrainLocal"):
            expected = "OutputVariableType.StressLocal or StrainLocal"
            raise shape_error(f"{where}: outputVariableType", expected, outputVariableType)
        if "matrix" not in self.modeBasis:
            raise ValueError(f"{where}: there are no modes; compute them first, by ComputeEigenmodes for instance")
        mesh, points = list(blocks(self.elements)), self.GetNodePositionsAsArray()
        if not mesh:
            raise ValueError(f"{where}: there are no solid elements, from which strains could be computed")
        laws = None if kind.endswith("StrainLocal") else self._laws(where, material)
        modes = np.asarray(self.modeBasis["matrix"], dtype=float)
        values = nodal_strains(mesh, points, modes, laws, reporter(len(points), False))
        self.postProcessingModes = {"matrix": values, "outputVariableType": outputVariableType}

    def _laws(self, where: str, material: Any) -> list[FloatArray]:
        """Elasticity matrix of each element."""
        count = self.NumberOfElements()
        if isinstance(material, dict) and "youngsModulus" not in material:
            laws: list[Any] = [None] * count
            sets = {s["Name"]: s["ElementNumbers"] for s in self.elementSets}
            for name, chosen in material.items():
                if name not in sets:
                    raise ValueError(f"{where}: material: there is no element set '{name}'")
                law = as_material(f"{where}: material['{name}']", chosen).elasticityTensor
                for number in sets[name]:
                    laws[number] = law
            if missing := [i for i, law in enumerate(laws) if law is None]:
                raise ValueError(f"{where}: {Names(self.metaData).some('element', missing)} has no material")
            return laws
        if isinstance(material, (int, float)):
            raise ValueError(f"{where}: stresses need a material, KirchhoffMaterial(...); strains do not")
        return [as_material(f"{where}: material", material).elasticityTensor] * count

    def InternalComputePostprocessingMode(self, parameterList: Sequence[Any]) -> FloatArray:
        """Stresses or strains of one mode: [mode, positions, modes, nodes of Tet4 elements, material, strains only]."""
        number, positions, modes, elements, material, strains = parameterList
        mesh = list(blocks([{"Tet4": elements}]))
        laws = None if strains else [material.elasticityTensor] * len(elements)
        column = np.asarray(modes, dtype=float)[:, [number]]
        return nodal_strains(mesh, np.asarray(positions, dtype=float), column, laws, lambda text: None)

    # -- rotors

    def GetGyroscopicMatrix(self, rotationAxis: int = 2, sparse: bool = True) -> Any:
        """Gyroscopic matrix for a speed of 1 rad/s about x (0), y (1) or z (2)."""
        if rotationAxis not in (0, 1, 2):
            raise shape_error("FEMinterface.GetGyroscopicMatrix: rotationAxis", "0, 1 or 2", rotationAxis)
        matrix = gyroscopic_matrix(self.GetMassMatrix(), rotationAxis)
        return matrix if sparse else matrix.toarray()

    def ComputeCampbellDiagram(
        self,
        terminalFrequency: float,
        nEigenfrequencies: int = 10,
        frequencySteps: int = 25,
        rotationAxis: int = 2,
        plotDiagram: bool = False,
        verbose: bool | int = False,
        useCorotationalFrame: bool = False,
        useSparseSolver: bool = False,
        centrifugalTerms: bool = False,
    ) -> list[Any]:
        """Eigenfrequencies (Hz) for rotor speeds up to terminalFrequency (Hz): [speeds, list of them for each speed].

        The equations for the speed W are M a + W G v + K q = 0, G from GetGyroscopicMatrix; useCorotationalFrame uses
        2 W G,
        the Coriolis forces in rotating coordinates. centrifugalTerms then adds the terms with W^2, - W^2 M for
        displacements normal to the axis, which lowers frequencies. Stresses by rotation are not taken into account.
        """
        mass, stiffness, points = self._mode_matrices("ComputeCampbellDiagram")
        if not useSparseSolver and mass.shape[0] > 5000:
            text = f"{mass.shape[0]} coordinates are too many for dense matrices; use useSparseSolver=True"
            raise ValueError(f"FEMinterface.ComputeCampbellDiagram: {text}")
        gyroscopic = gyroscopic_matrix(mass, rotationAxis) * (2.0 if useCorotationalFrame else 1.0)
        turning = np.tile(np.delete(np.eye(3), rotationAxis, axis=0).sum(axis=0), len(points))
        across = scipy.sparse.diags(turning) @ mass if centrifugalTerms else 0 * mass
        speeds = [i * terminalFrequency / frequencySteps for i in range(frequencySteps + 1)]
        lists = []
        for speed in speeds:
            turned, softened = 2 * np.pi * speed * gyroscopic, stiffness - (2 * np.pi * speed) ** 2 * across
            if useSparseSolver:
                found = sparse_frequencies(mass, softened, turned, points, nEigenfrequencies)
            else:
                dense = (mass.toarray(), softened.toarray(), turned.toarray())
                found = dense_frequencies(*dense, nEigenfrequencies)
            lists.append(found.tolist())
            if verbose:
                print(f"speed {speed:g} Hz" + (f": {lists[-1]}" if verbose == 2 else ""))
        shortest = min(map(len, lists))
        lists = [row[:shortest] for row in lists]
        if plotDiagram:
            plot_campbell(speeds, lists)
        return [speeds, lists]

    # -- as bodies

    def CreateLinearFEMObjectGenericODE2(self, mbs: Any, color: Sequence[float] = [0.9, 0.4, 0.4, 1.0]) -> list[Any]:
        """Add the mesh as ObjectGenericODE2 with a NodePoint for each node: [object, list of nodes].

        Displacements are those of linear elasticity: small, and rotations as well.
        """
        points = self.GetNodePositionsAsArray()
        nodes = [mbs.AddNode(eii.NodePoint(referenceCoordinates=point)) for point in points]
        body = eii.ObjectGenericODE2(
            nodeNumbers=nodes,
            massMatrix=exu.MatrixContainer(self.GetMassMatrix()),
            stiffnessMatrix=exu.MatrixContainer(self.GetStiffnessMatrix()),
            visualization={"triangleMesh": self.GetSurfaceTriangles(), "color": list(color)},
        )
        return [mbs.AddObject(body), nodes]
