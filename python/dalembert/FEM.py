"""Finite element data from other programs: matrices, nodes, materials, and flexible bodies with modes made of them.

What needs flexible-body items (ObjectFFRF and relatives) raises NotImplementedError.
"""

from __future__ import annotations

import os
import warnings
from collections.abc import Sequence
from enum import Enum
from typing import Any, NoReturn

import numpy.typing as npt
import scipy.sparse

from dalembert._checks import FloatArray
from dalembert._io.fem_files import (
    ReadElementsFromAnsysTxt,
    ReadMatrixDOFmappingVectorFromAnsysTxt,
    ReadMatrixFromAnsysMMF,
    ReadNodalCoordinatesFromAnsysTxt,
    ReadNodesFromAbaqusInp,
)
from dalembert._names import eii, exu, np
from dalembert._planned import refuse
from dalembert._planned_table import FUNCTIONS
from dalembert._tools.modal_body import CMSObjectComputeNorm, ObjectFFRFreducedOrderInterface
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


def CheckForSciPyMatrix(data: Any, stringWhere: str) -> bool:
    """True for a sparse matrix of scipy, False for an array of [row, column, value]; raises ValueError for others."""
    if scipy.sparse.issparse(data):
        return True
    if np.ndim(data) == 2 and np.shape(data)[1] == 3:
        return False
    raise ValueError(f"{stringWhere}: expected a scipy sparse matrix or an array of [row, column, value]")


# ---- sparse matrices; the triplet format is an array with one line [row, column, value] per entry


def SparseTripletsToScipySparseCSR(sparseTriplets: npt.ArrayLike) -> Any:
    """scipy csr matrix of an array of [row, column, value]; entries of the same place are added."""
    triplets = np.asarray(sparseTriplets, dtype=float)
    if triplets.ndim != 2 or triplets.shape[1] != 3:
        raise ValueError(
            f"SparseTripletsToScipySparseCSR: expected lines [row, column, value], received shape {triplets.shape}"
        )
    rows, columns = triplets[:, 0].astype(int), triplets[:, 1].astype(int)
    return scipy.sparse.csr_matrix((triplets[:, 2], (rows, columns)))


def CSRtoScipySparseCSR(sparseMatrixCSR: npt.ArrayLike) -> Any:
    """scipy csr matrix of an array of [row, column, value]."""
    return SparseTripletsToScipySparseCSR(sparseMatrixCSR)


def ScipySparseCSRtoCSR(scipyCSR: Any) -> FloatArray:
    """Array of [row, column, value] of a sparse matrix of scipy."""
    entries = scipy.sparse.csr_matrix(scipyCSR).tocoo()
    return np.column_stack((entries.row, entries.col, entries.data)).astype(float)


def ConvertDenseToCompressedRowMatrix(denseMatrix: npt.ArrayLike) -> FloatArray:
    """Array of [row, column, value] of the entries of a matrix that are not zero."""
    return ScipySparseCSRtoCSR(np.asarray(denseMatrix, dtype=float))


def CompressedRowSparseToDenseMatrix(sparseData: Any) -> FloatArray:
    """Dense matrix of an array of [row, column, value], or of a sparse matrix of scipy."""
    matrix = sparseData if scipy.sparse.issparse(sparseData) else SparseTripletsToScipySparseCSR(sparseData)
    return np.asarray(matrix.toarray(), dtype=float)


def CSRtoRowsAndColumns(sparseMatrixCSR: npt.ArrayLike) -> tuple[int, int]:
    """The largest row and column index of an array of [row, column, value]."""
    entries = np.asarray(sparseMatrixCSR, dtype=float)
    return int(entries[:, 0].max()), int(entries[:, 1].max())


def MapSparseMatrixIndices(matrix: FloatArray, sorting: npt.ArrayLike) -> None:
    """Replace the indices in an array of [row, column, value] by sorting[index], in place."""
    order = np.asarray(sorting, dtype=int)
    matrix[:, :2] = order[matrix[:, :2].astype(int)]


def AddEntryToCompressedRowSparseArray(sparseData: FloatArray, row: int, column: int, value: float) -> FloatArray:
    """Add value to an entry of an array of [row, column, value]; a new line is appended if there is no such entry."""
    found = np.flatnonzero((sparseData[:, 0] == row) & (sparseData[:, 1] == column))
    if len(found) == 0:
        return np.vstack((sparseData, [row, column, value]))
    sparseData[found[0], 2] += value
    return sparseData


def VectorDiadicUnitMatrix3D(v: npt.ArrayLike) -> FloatArray:
    """v times the 3x3 unit matrix, one below the other: 3n rows, 3 columns."""
    return np.kron(np.asarray(v, dtype=float).reshape(-1, 1), np.eye(3))


def CyclicCompareReversed(list1: Sequence[int], list2: Sequence[int]) -> bool:
    """Whether list2 read backwards is list1, up to a rotation."""
    backwards, n = list(list2)[::-1], len(list1)
    return len(backwards) == n and any(backwards[i:] + backwards[:i] == list(list1) for i in range(max(n, 1)))


def ResortIndicesOfNGvector(vXXYYZZ: npt.ArrayLike) -> FloatArray:
    """From (x0, x1, ..., y0, y1, ..., z0, z1, ...) to (x0, y0, z0, x1, ...)."""
    return np.asarray(vXXYYZZ).reshape(3, -1).T.ravel()


def ResortIndicesExudyn2NGvector(vXYZXYZ: npt.ArrayLike) -> FloatArray:
    """From (x0, y0, z0, x1, ...) to (x0, x1, ..., y0, y1, ..., z0, z1, ...)."""
    return np.asarray(vXYZXYZ).reshape(-1, 3).T.ravel()


def ResortIndicesOfCSRmatrix(mXXYYZZ: FloatArray, numberOfRows: int) -> None:
    """The same reordering for the indices of an array of [row, column, value], in place."""
    n = numberOfRows // 3
    index = np.arange(numberOfRows)
    MapSparseMatrixIndices(mXXYYZZ, 3 * (index % n) + index // n)


# ---- files and faces


def FileNameToMode(fileName: str, mode: str | None) -> list[str]:
    """[name without ending, ending, mode]; mode is 'NPZ', 'NPY', 'PKL' or 'HDF5', by default that of the ending."""
    endings = {"NPZ": ".npz", "NPY": ".npy", "PKL": ".pkl", "HDF5": ".hdf5"}
    if mode is not None and mode not in endings:
        raise ValueError(f"FileNameToMode: mode must be one of {', '.join(endings)}, received {mode!r}")
    stem, ending = os.path.splitext(fileName)
    known = {value: key for key, value in endings.items()}
    if ending not in known:
        stem = fileName
    elif mode is None:
        mode = known[ending]
    return [stem, endings[mode or "NPZ"], mode or "NPZ"]


def ConvertHexToTrigs(nodeNumbers: Sequence[int]) -> list[list[int]]:
    """The 12 triangles on the faces of a hexahedron with 8 nodes, normals pointing outwards."""
    corners = (
        *((0, 1, 2), (0, 2, 3), (6, 5, 4), (6, 4, 7), (0, 4, 1), (1, 4, 5)),
        *((1, 5, 2), (2, 5, 6), (2, 6, 3), (3, 6, 7), (3, 7, 0), (0, 7, 4)),
    )
    return [[nodeNumbers[i] for i in corner] for corner in corners]


def ConvertTetToTrigs(nodeNumbers: Sequence[int]) -> list[list[int]]:
    """The 4 triangles on the faces of a tetrahedron; nodes on edges are left out."""
    return [[nodeNumbers[i] for i in corner] for corner in ((0, 1, 2), (0, 3, 1), (1, 3, 2), (0, 2, 3))]


# ---- materials and elements


class MaterialBaseClass:
    """Young's modulus, Poisson's ratio and density of a material."""

    def __init__(self, youngsModulus: float | None, poissonsRatio: float | None, density: float) -> None:
        self.youngsModulus = youngsModulus
        self.poissonsRatio = poissonsRatio
        self.density = density


class KirchhoffMaterial(MaterialBaseClass):
    """Linear elastic material; strain vectors are (xx, yy, zz, yz, xz, xy), with engineering shear strains."""

    def __init__(
        self,
        youngsModulus: float | None = None,
        poissonsRatio: float | None = None,
        density: float = 0,
        materials: Any = None,
        fes: Any = None,
        planeStress: bool = True,
    ) -> None:
        super().__init__(youngsModulus, poissonsRatio, density)
        if materials is not None or fes is not None:
            refuse("FEM.KirchhoffMaterial")
        if youngsModulus is None or poissonsRatio is None:
            raise ValueError("KirchhoffMaterial: youngsModulus and poissonsRatio are needed")
        self.planeStress = planeStress
        self.useMaterials = False
        mu, lame = self.LameParameters()
        self.elasticityTensor = np.diag([2 * mu] * 3 + [mu] * 3)
        self.elasticityTensor[:3, :3] += lame
        coupling = 2 * mu * lame / (2 * mu + lame) if planeStress else lame
        self.elasticityTensor2D = np.diag([2 * mu, 2 * mu, mu])
        self.elasticityTensor2D[:2, :2] += coupling

    def LameParameters(self) -> list[float]:
        """[mu, lambda]: shear modulus and first Lame parameter."""
        assert self.youngsModulus is not None and self.poissonsRatio is not None
        E, nu = self.youngsModulus, self.poissonsRatio
        return [E / (2 * (1 + nu)), E * nu / ((1 + nu) * (1 - 2 * nu))]

    def Strain2Stress(self, strain: npt.ArrayLike) -> FloatArray:
        """Stress tensor (3x3) of a strain tensor (3x3)."""
        mu, lame = self.LameParameters()
        tensor = np.asarray(strain, dtype=float)
        return 2 * mu * tensor + lame * np.trace(tensor) * np.eye(3)

    def StrainVector2StressVector(self, strainVector: npt.ArrayLike) -> FloatArray:
        """Stress vector (6) of a strain vector (6)."""
        return self.elasticityTensor @ np.asarray(strainVector, dtype=float)

    def StrainVector2StressVector2D(self, strainVector2D: npt.ArrayLike) -> FloatArray:
        """Stress vector (3) of a strain vector (xx, yy, xy) in the plane."""
        return self.elasticityTensor2D @ np.asarray(strainVector2D, dtype=float)


class FiniteElement:
    """A finite element of a material."""

    def __init__(self, material: KirchhoffMaterial) -> None:
        self.material = material


class Tet4(FiniteElement):
    """Tetrahedron with 4 nodes and linear displacements."""

    def ComputeMatrices(self, nodalReferenceCoordinates: npt.ArrayLike, nodalDisplacements: npt.ArrayLike) -> NoReturn:
        """Element matrices; planned."""
        refuse("FEM.Tet4", "ComputeMatrices")


class HCBstaticModeSelection(Enum):
    """Which static modes the method of Hurty, Craig and Bampton takes at boundaries."""

    allBoundaryNodes = 1
    RBE2 = 2
    RBE3 = 3
    noStaticModes = 4


# ---- flexible bodies: planned


class ObjectFFRFinterface:
    """Flexible body with all coordinates of its mesh; planned."""

    def __init__(self, femInterface: Any) -> None:
        refuse("FEM.ObjectFFRFinterface")


class FEMinterface:
    """Nodes, elements, matrices and modes of a finite element model."""

    def __getattr__(self, name: str) -> Any:
        """Methods that are planned are refused when they are called."""
        if name not in FUNCTIONS["FEM.FEMinterface"].members:
            raise AttributeError(f"FEMinterface has no attribute '{name}'")
        return lambda *args, **kwargs: refuse("FEM.FEMinterface", name)

    def __init__(self) -> None:
        self.metaData: dict[str, Any] = {"source": "unknown"}
        self.nodes: dict[str, Any] = {}
        self.elements: list[Any] = []
        self.massMatrix: Any = None
        self.stiffnessMatrix: Any = None
        self.surface: list[Any] = []
        self.nodeSets: list[Any] = []
        self.elementSets: list[Any] = []
        self.modeBasis: dict[str, Any] = {}
        self.eigenValues: Any = []
        self.postProcessingModes: dict[str, Any] = {}
        self.coordinatesPerNodeType = {"Position": 3, "Position2D": 2, "RigidBodyRxyz": 6, "RigidBodyEP": 7}

    # -- data

    def GetDictionary(self) -> dict[str, Any]:
        """All data as a dictionary."""
        return dict(vars(self))

    def SetWithDictionary(self, dictData: dict[str, Any], warn: bool = True, fromNPZ: bool = False) -> None:
        """Set the data that the dictionary has."""
        for key, value in dictData.items():
            if key not in vars(self):
                if warn:
                    warnings.warn(
                        f"FEMinterface.SetWithDictionary: the key '{key}' is unknown and ignored", stacklevel=2
                    )
                continue
            setattr(self, key, value)

    def _matrix(self, matrix: Any, name: str, sparse: bool) -> Any:
        if matrix is None:
            raise ValueError(f"FEMinterface: there is no {name} yet; import or set it first")
        if not CheckForSciPyMatrix(matrix, name):
            matrix = SparseTripletsToScipySparseCSR(matrix)
            n = max(self.NumberOfCoordinates(), *matrix.shape)  # the last rows and columns may have no entries
            matrix.resize(n, n)
        return matrix if sparse else matrix.toarray()

    def GetMassMatrix(self, sparse: bool = True) -> Any:
        """Mass matrix as scipy csr matrix, or dense."""
        return self._matrix(self.massMatrix, "mass matrix", sparse)

    def GetStiffnessMatrix(self, sparse: bool = True) -> Any:
        """Stiffness matrix as scipy csr matrix, or dense."""
        return self._matrix(self.stiffnessMatrix, "stiffness matrix", sparse)

    def ScaleMassMatrix(self, factor: float) -> None:
        """Multiply the mass matrix with a factor."""
        self.massMatrix = self.GetMassMatrix() * factor

    def ScaleStiffnessMatrix(self, factor: float) -> None:
        """Multiply the stiffness matrix with a factor."""
        self.stiffnessMatrix = self.GetStiffnessMatrix() * factor

    def _add_at_node(self, matrix: Any, nodeNumber: int, values: npt.ArrayLike) -> Any:
        diagonal = np.zeros(matrix.shape[0])
        diagonal[3 * nodeNumber : 3 * nodeNumber + 3] = values
        return (matrix + scipy.sparse.diags(diagonal)).tocsr()

    def AddElasticSupportAtNode(self, nodeNumber: int, springStiffness: npt.ArrayLike = (1e8, 1e8, 1e8)) -> None:
        """Add springs between a node and the ground to the stiffness matrix."""
        self.stiffnessMatrix = self._add_at_node(self.GetStiffnessMatrix(), nodeNumber, springStiffness)

    def AddNodeMass(self, nodeNumber: int, addedMass: float) -> None:
        """Add a mass at a node to the mass matrix."""
        self.massMatrix = self._add_at_node(self.GetMassMatrix(), nodeNumber, addedMass)

    # -- nodes

    def GetNodePositionsAsArray(self) -> FloatArray:
        """Positions of all nodes, one line each."""
        if "Position" not in self.nodes:
            raise ValueError("FEMinterface: there are no nodes yet; import nodes or set nodes['Position'] first")
        return np.asarray(self.nodes["Position"], dtype=float)

    def NumberOfNodes(self) -> int:
        """The number of nodes."""
        return sum(len(nodes) for nodes in self.nodes.values())

    def NumberOfCoordinates(self) -> int:
        """The number of coordinates of all nodes."""
        return sum(self.coordinatesPerNodeType[name] * len(nodes) for name, nodes in self.nodes.items())

    def GetNodePositionsMean(self, nodeNumberList: Sequence[int]) -> FloatArray:
        """The mean of the positions of some nodes."""
        return np.asarray(self.GetNodePositionsAsArray()[list(nodeNumberList)].mean(axis=0), dtype=float)

    def GetNodeAtPoint(self, point: npt.ArrayLike, tolerance: float = 1e-5, raiseException: bool = True) -> int:
        """The node at a point; -1 or ValueError if there is none."""
        distance = np.linalg.norm(self.GetNodePositionsAsArray() - np.asarray(point, dtype=float), axis=1)
        found = np.flatnonzero(distance <= tolerance)
        if len(found) > 0:
            return int(found[0])
        if raiseException:
            raise ValueError(
                f"FEMinterface.GetNodeAtPoint: no node is within {tolerance} of {np.asarray(point).tolist()}; "
                f"the closest is node {int(distance.argmin())} at a distance of {distance.min():g}"
            )
        return -1

    def GetNodesInPlane(self, point: npt.ArrayLike, normal: npt.ArrayLike, tolerance: float = 1e-5) -> list[int]:
        """Nodes whose distance from a plane is at most the tolerance."""
        direction = np.asarray(normal, dtype=float)
        direction = direction / np.linalg.norm(direction)
        distance = (self.GetNodePositionsAsArray() - np.asarray(point, dtype=float)) @ direction
        return _indices(np.abs(distance) <= tolerance)

    def GetNodesInCube(self, pMin: npt.ArrayLike, pMax: npt.ArrayLike) -> list[int]:
        """Nodes in a box that is aligned with the axes."""
        positions = self.GetNodePositionsAsArray()
        return _indices(np.all((positions >= np.asarray(pMin)) & (positions <= np.asarray(pMax)), axis=1))

    def _along(self, p1: npt.ArrayLike, p2: npt.ArrayLike) -> tuple[FloatArray, FloatArray, float]:
        """Coordinates along p1-p2, distances from the line, and its length."""
        start, end = np.asarray(p1, dtype=float), np.asarray(p2, dtype=float)
        length = float(np.linalg.norm(end - start))
        offset = self.GetNodePositionsAsArray() - start
        along = offset @ ((end - start) / length)
        return along, np.linalg.norm(offset - np.outer(along, (end - start) / length), axis=1), length

    def GetNodesOnLine(self, p1: npt.ArrayLike, p2: npt.ArrayLike, tolerance: float = 1e-5) -> list[int]:
        """Nodes on the line from p1 to p2."""
        return self.GetNodesOnCylinder(p1, p2, 0.0, tolerance)

    def GetNodesOnCylinder(
        self, p1: npt.ArrayLike, p2: npt.ArrayLike, radius: float, tolerance: float = 1e-5
    ) -> list[int]:
        """Nodes on the lateral surface of a cylinder with the axis from p1 to p2."""
        along, distance, length = self._along(p1, p2)
        inside = (along >= -tolerance) & (along <= length + tolerance)
        return _indices(inside & (np.abs(distance - radius) <= tolerance))

    def GetNodesOnCircle(
        self, point: npt.ArrayLike, normal: npt.ArrayLike, r: float, tolerance: float = 1e-5
    ) -> list[int]:
        """Nodes on a circle around a point, in the plane with the given normal."""
        along, distance, _ = self._along(point, np.asarray(point, dtype=float) + np.asarray(normal, dtype=float))
        return _indices((np.abs(along) <= tolerance) & (np.abs(distance - r) <= tolerance))

    # -- modes

    def ComputeEigenmodes(self, nModes: int, excludeRigidBodyModes: int = 0, useSparseSolver: bool = True) -> None:
        """Lowest eigenvalues and modes of the free body, into eigenValues and modeBasis."""
        mass, stiffness = self.GetMassMatrix(), self.GetStiffnessMatrix()
        count = nModes + excludeRigidBodyModes
        if useSparseSolver and count < mass.shape[0] - 1:
            from scipy.sparse.linalg import eigsh

            shift = -1e-6 * abs(stiffness).sum() / abs(mass).sum()
            values, vectors = eigsh(stiffness, k=count, M=mass, sigma=shift, which="LM")
        else:
            from scipy.linalg import eigh

            values, vectors = eigh(stiffness.toarray(), mass.toarray())
        order = np.argsort(values)[excludeRigidBodyModes:count]
        self.eigenValues = np.abs(values[order])
        self.modeBasis = {"matrix": vectors[:, order], "type": "NormalModes"}

    def GetEigenFrequenciesHz(self) -> FloatArray:
        """Frequencies of the computed modes in Hz."""
        return np.sqrt(np.asarray(self.eigenValues, dtype=float)) / (2 * np.pi)


def _indices(mask: npt.NDArray[np.bool_]) -> list[int]:
    return [int(i) for i in np.flatnonzero(mask)]
