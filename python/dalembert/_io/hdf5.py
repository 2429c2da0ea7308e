"""Storage of nested dictionaries in HDF5 files.

Every dataset or group carries the attribute 'datatype' with the name of the Python type. Lists become groups with the
members item_0, item_1, ...; scipy matrices groups of their CSR arrays; Python user functions groups with their name.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from dalembert._checks import as_array, shape_error
from dalembert._io.files import file_to_read, file_to_write, naming, replacing

_numbers = (bool, int, float, np.bool_, np.integer, np.floating)
_enumerations = (
    "ObjectIndex",
    "NodeIndex",
    "LoadIndex",
    "MarkerIndex",
    "SensorIndex",
    "OutputVariableType",
    "ConfigurationType",
    "ItemType",
    "NodeType",
    "JointType",
    "DynamicSolverType",
    "CrossSectionType",
    "LinearSolverType",
    "ContactTypeIndex",
)


def _h5py(where: str) -> Any:
    try:
        import h5py
    except ImportError:
        raise ImportError(f"{where}: the package h5py is needed; install it with 'pip install h5py'") from None
    return h5py


def ConvertScipySparseToDict(sparseMatrix: Any) -> dict[str, Any]:
    """Return the CSR arrays data, indices and indptr and the shape of a scipy sparse matrix."""
    if not hasattr(sparseMatrix, "tocsr"):
        raise shape_error("ConvertScipySparseToDict: sparseMatrix", "a scipy sparse matrix", sparseMatrix)
    csr = sparseMatrix.tocsr()
    return {"data": csr.data, "indices": csr.indices, "indptr": csr.indptr, "shape": csr.shape}


def ConvertDictToScipySparse(sparseDict: Mapping[str, Any]) -> Any:
    """Return the scipy csr_matrix of a dictionary with data, indices, indptr and shape."""
    from scipy.sparse import csr_matrix

    arrays = (sparseDict["data"], sparseDict["indices"], sparseDict["indptr"])
    rows, columns = as_array("ConvertDictToScipySparse: shape", sparseDict["shape"])
    return csr_matrix(arrays, shape=(int(rows), int(columns)))


def _user_function(value: Any) -> Any:
    """The Python function of a user function, given as itself or as a dictionary with its type; None otherwise."""
    if isinstance(value, dict) and "function" in value and "type" in value:
        if value["type"] == "Symbolic":
            raise ValueError("SaveDictToHDF5: symbolic user functions cannot be stored; use a Python function")
        value = value["function"] if value["type"] == "Python" else None
    return value if hasattr(value, "__code__") else None


def _store_group(parent: Any, key: str, datatype: str, members: Mapping[str, Any], path: str) -> None:
    group = parent.create_group(key)
    group.attrs["datatype"] = datatype
    for name, member in members.items():
        _store(group, str(name), member, f"{path}/{name}")


def _store(parent: Any, key: str, value: Any, path: str) -> None:
    """Store one value of any supported type below an HDF5 group."""
    from scipy.sparse import issparse

    name = type(value).__name__
    if (called := _user_function(value)) is not None:
        function = {
            "functionName": called.__name__,
            "functionVarNames": str(called.__code__.co_varnames),
            "type": "Python",
        }
        _store_group(parent, key, "exuFunction", function, path)
    elif isinstance(value, dict):
        _store_group(parent, key, "dict", value, path)
    elif isinstance(value, list):
        _store_group(parent, key, "list", {f"item_{i}": entry for i, entry in enumerate(value)}, path)
    elif issparse(value):
        group = parent.create_group(key)
        group.attrs["datatype"] = "csr_matrix"
        for part, array in ConvertScipySparseToDict(value).items():
            group.create_dataset(part, data=array)
    else:
        data: Any = value
        if value is None:
            data = 0
        elif name in _enumerations:
            data = int(value)
        elif not isinstance(value, (str, np.ndarray, *_numbers)):
            raise shape_error(f"SaveDictToHDF5: {path}", "a number, str, list, dict, array or sparse matrix", value)
        parent.create_dataset(key, data=data).attrs["datatype"] = name


def SaveDictToHDF5(fileName: str, dataDict: Mapping[str, Any]) -> None:
    """Write a dictionary to an HDF5 file; LoadDictFromHDF5 reads it.

    Values are numbers, None, str, numpy arrays, scipy sparse matrices, item indices, enumerations, and lists and
    dictionaries of them; Python functions are stored by name. Raises ValueError for other types.
    """
    fileName = file_to_write("SaveDictToHDF5: fileName", fileName)
    with replacing(fileName) as written, _h5py("SaveDictToHDF5").File(written, "w") as file:
        for key, value in dataDict.items():
            _store(file, str(key), value, str(key))


def _load_function(members: Mapping[str, Any], callerGlobals: Mapping[str, Any] | None, path: str) -> dict[str, Any]:
    name = members["functionName"]
    if members["type"] != "Python":
        raise ValueError(f"LoadDictFromHDF5: {path}: expected a function of type Python, received {members['type']}")
    if callerGlobals is None or name not in callerGlobals:
        raise ValueError(f"LoadDictFromHDF5: {path}: function '{name}' is not in callerGlobals; pass globals()")
    function = callerGlobals[name]
    if members["functionVarNames"] != str(function.__code__.co_varnames):
        raise ValueError(
            f"LoadDictFromHDF5: {path}: function '{name}' was stored with the variables "
            f"{members['functionVarNames']}, but has {function.__code__.co_varnames}"
        )
    return {"function": function, "type": "Python"}


def _load_dataset(node: Any, datatype: str, path: str) -> Any:
    value = node[()]
    if datatype == "str":
        return value.decode("utf-8")
    if datatype == "ndarray":
        return np.array(value)
    if datatype == "NoneType":
        return None
    if datatype in ("bool", "bool_"):
        return bool(value)
    if datatype in _enumerations:
        import dalembert as exu

        return getattr(exu, datatype)(int(value))
    for prefix, convert in (("int", int), ("uint", int), ("float", float)):
        if datatype.startswith(prefix):
            return convert(value)
    raise ValueError(f"LoadDictFromHDF5: {path}: unknown datatype '{datatype}'")


def _load(node: Any, callerGlobals: Mapping[str, Any] | None, path: str) -> Any:
    datatype = node.attrs.get("datatype", None)
    if datatype is None:
        raise ValueError(f"LoadDictFromHDF5: {path}: the attribute 'datatype' is missing")
    if not hasattr(node, "items"):
        return _load_dataset(node, datatype, path)
    if datatype == "csr_matrix":
        return ConvertDictToScipySparse({key: member[()] for key, member in node.items()})
    members = {key: _load(member, callerGlobals, f"{path}/{key}") for key, member in node.items()}
    if datatype == "dict":
        return members
    if datatype == "list":
        return [members[f"item_{i}"] for i in range(len(members))]
    if datatype == "exuFunction":
        return _load_function(members, callerGlobals, path)
    raise ValueError(f"LoadDictFromHDF5: {path}: unknown datatype '{datatype}' of a group")


def LoadDictFromHDF5(fileName: str, callerGlobals: Mapping[str, Any] | None = None) -> dict[str, Any]:
    """Return the dictionary that SaveDictToHDF5 wrote; callerGlobals=globals() is needed for user functions."""
    fileName = file_to_read("LoadDictFromHDF5: fileName", fileName)
    with naming(fileName), _h5py("LoadDictFromHDF5").File(fileName, "r") as file:
        return {key: _load(member, callerGlobals, key) for key, member in file.items()}
