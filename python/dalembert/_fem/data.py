"""Data of FEMinterface: nodes, elements, matrices, sets, modes; and their files."""

from __future__ import annotations

import os
import pickle
import warnings
from typing import Any

import numpy as np

from dalembert._checks import FloatArray, shape_error
from dalembert._fem.elements import blocks
from dalembert._fem.sparse import CheckForSciPyMatrix, ScipySparseCSRtoCSR, SparseTripletsToScipySparseCSR
from dalembert._io import foreign_pickles
from dalembert._io.files import file_name, file_to_read, file_to_write
from dalembert._io.hdf5 import LoadDictFromHDF5, SaveDictToHDF5
from dalembert._tools.later import scipy

KEPT = (
    *("metaData", "nodes", "elements", "massMatrix", "stiffnessMatrix", "surface", "nodeSets", "elementSets"),
    *("modeBasis", "eigenValues", "postProcessingModes"),
)
_ENDINGS = {"NPZ": ".npz", "NPY": ".npy", "PKL": ".pkl", "HDF5": ".hdf5"}


def FileNameToMode(fileName: str, mode: str | None) -> list[str]:
    """[name without ending, ending, mode]; mode is 'NPZ', 'NPY', 'PKL' or 'HDF5', by default that of the ending."""
    if mode is not None and mode not in _ENDINGS:
        raise ValueError(f"FileNameToMode: mode must be one of {', '.join(_ENDINGS)}, received {mode!r}")
    stem, ending = os.path.splitext(fileName)
    known = {value: key for key, value in _ENDINGS.items()}
    if ending not in known:
        stem = fileName
    elif mode is None:
        mode = known[ending]
    return [stem, _ENDINGS[mode or "NPZ"], mode or "NPZ"]


class MeshData:
    """Data of a mesh, as dictionary and in files."""

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

    # -- dictionaries and files

    def ConvertElementsLists2Numpy(self) -> None:
        """Lists of elements become arrays."""
        _lists_to_arrays(self.elements)

    def ConvertSurfaceLists2Numpy(self) -> None:
        """Lists of triangles and quadrangles become arrays."""
        _lists_to_arrays(self.surface)

    def NumpyArray2ListOfLists(self, matrix: Any) -> Any:
        """Convert an array to a list of lists; other values are returned unchanged."""
        return matrix.tolist() if isinstance(matrix, np.ndarray) else matrix

    def GetDictionary(self) -> dict[str, Any]:
        """All data as a dictionary."""
        return {name: getattr(self, name) for name in KEPT}

    def SetWithDictionary(self, dictData: dict[str, Any], warn: bool = True, fromNPZ: bool = False) -> None:
        """Set the data that the dictionary has; fromNPZ: they are wrapped as numpy does it in its files."""
        for key, value in dictData.items():
            if key in KEPT:
                setattr(self, key, _unwrapped(value) if fromNPZ else value)
            elif warn and key not in ("fileVersion", "type"):
                text = f"FEMinterface.SetWithDictionary: the key '{key}' is unknown and ignored"
                warnings.warn(text, stacklevel=2)
        self.ConvertElementsLists2Numpy()
        self.ConvertSurfaceLists2Numpy()

    def SaveToFile(self, fileName: str, fileVersion: int = 4, mode: str | None = None) -> None:
        """Save all data; the format is that of the ending, .npz (default), .pkl, .hdf5 or .npy, or that of `mode`."""
        where = "FEMinterface.SaveToFile: fileName"
        stem, ending, mode = FileNameToMode(file_name(where, fileName), mode)
        file_to_write(where, stem + ending, newFolder=True)
        if fileVersion != int(fileVersion) or not 1 <= fileVersion <= 4:
            raise shape_error("FEMinterface.SaveToFile: fileVersion", "an integer from 1 to 4", fileVersion)
        data = self.GetDictionary() | {"fileVersion": int(fileVersion), "type": "FEMinterface"}
        os.makedirs(os.path.dirname(stem) or ".", exist_ok=True)
        if mode == "NPZ":
            np.savez(stem + ending, **{key: _as_object(value) for key, value in data.items()})
        elif mode == "PKL":
            with open(stem + ending, "wb") as file:
                pickle.dump(data, file)
        elif mode == "HDF5":
            SaveDictToHDF5(stem + ending, data)
        else:
            self._save_npy(stem + ending, int(fileVersion))

    def LoadFromFile(self, fileName: str, forceVersion: int | None = None, mode: str | None = None) -> int | None:
        """Load a file of SaveToFile, and return its version; pickles run code: load only your own."""
        where = "FEMinterface.LoadFromFile: fileName"
        stem, ending, mode = FileNameToMode(file_name(where, fileName), mode)
        file_to_read(where, stem + ending)
        if mode == "NPY":
            return self._load_npy(stem + ending, forceVersion)
        data: dict[str, Any]
        if mode == "HDF5":
            data = LoadDictFromHDF5(stem + ending)
        elif mode == "PKL":
            with open(stem + ending, "rb") as file:
                data = foreign_pickles.load(file)
        else:
            with np.load(stem + ending, allow_pickle=True) as arrays:
                data = dict(arrays)
        if missing := [name for name in KEPT if name not in data and name != "metaData"]:
            raise ValueError(f"FEMinterface.LoadFromFile: {stem + ending}: there is no {', no '.join(missing)}")
        self.SetWithDictionary(data, fromNPZ=mode == "NPZ")
        version = data.get("fileVersion")
        return None if version is None else int(version)

    def _save_npy(self, name: str, version: int) -> None:
        matrices = [ScipySparseCSRtoCSR(self.GetMassMatrix()), ScipySparseCSRtoCSR(self.GetStiffnessMatrix())]
        pair = dict(zip(("massMatrix", "stiffnessMatrix"), matrices, strict=True)) | {"type": "sparseTriplets"}
        parts = [self.nodes, self.elements, *([pair] if version >= 2 else matrices)]
        parts += [getattr(self, key) for key in KEPT[5:]] + ([self.metaData] if version >= 4 else [])
        with open(name, "wb") as file:
            np.save(file, np.array([version]))
            for part in parts:
                np.save(file, part if isinstance(part, np.ndarray) else _as_object(part), allow_pickle=True)

    def _load_npy(self, name: str, version: int | None) -> int | None:
        with open(name, "rb") as file:

            def part() -> Any:
                return _unwrapped(np.load(file, allow_pickle=True))

            if version is None or version > 0:
                found = int(np.load(file)[0])
                version = found if version is None else version
            self.nodes, self.elements = part(), list(part())
            if version >= 2:
                matrices = part()
                pair = [matrices["massMatrix"], matrices["stiffnessMatrix"]]
            else:
                pair = [np.load(file), np.load(file)]
            self.massMatrix, self.stiffnessMatrix = map(SparseTripletsToScipySparseCSR, pair)
            for key in KEPT[5:]:
                setattr(self, key, part())
            if version >= 4:
                self.metaData = part()
        self.ConvertElementsLists2Numpy()
        self.ConvertSurfaceLists2Numpy()
        return version

    # -- sizes

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

    def NumberOfElements(self) -> int:
        """The number of solid elements."""
        return sum(len(block.nodes) for block in blocks(self.elements))

    # -- matrices

    def _matrix(self, matrix: Any, name: str, sparse: bool) -> Any:
        if matrix is None:
            raise ValueError(f"FEMinterface: there is no {name} yet; import or set it first, or call AssembleMatrices")
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

    def _add_at_node(self, function: str, matrix: Any, nodeNumber: int, values: Any) -> Any:
        if not 0 <= nodeNumber < self.NumberOfNodes():
            expected = f"a node number from 0 to {self.NumberOfNodes() - 1}"
            raise shape_error(f"FEMinterface.{function}: nodeNumber", expected, nodeNumber)
        diagonal = np.zeros(matrix.shape[0])
        diagonal[3 * nodeNumber : 3 * nodeNumber + 3] = values
        return (matrix + scipy.sparse.diags(diagonal)).tocsr()

    def AddElasticSupportAtNode(self, nodeNumber: int, springStiffness: Any = (1e8, 1e8, 1e8)) -> None:
        """Add springs (N/m) between a node and the ground to the stiffness matrix."""
        matrix = self.GetStiffnessMatrix()
        self.stiffnessMatrix = self._add_at_node("AddElasticSupportAtNode", matrix, nodeNumber, springStiffness)

    def AddNodeMass(self, nodeNumber: int, addedMass: float) -> None:
        """Add a mass (kg) at a node to the mass matrix."""
        self.massMatrix = self._add_at_node("AddNodeMass", self.GetMassMatrix(), nodeNumber, addedMass)


def _lists_to_arrays(groups: list[Any]) -> None:
    for group in groups:
        for key, value in group.items():
            if isinstance(value, list):
                group[key] = np.array(value)


def _as_object(value: Any) -> Any:
    """Dictionaries and lists as arrays with one entry, so that numpy does not look into them."""
    if isinstance(value, np.ndarray):
        return value
    box = np.empty((), dtype=object)
    box[()] = value
    return box


def _unwrapped(value: Any) -> Any:
    if isinstance(value, np.ndarray) and value.dtype == object:
        return value.item() if value.ndim == 0 else value.tolist()
    return value
