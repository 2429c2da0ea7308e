"""Type checks of arguments, sweeps and steps for excitation, sparse matrices and HDF5 storage of dictionaries."""

from __future__ import annotations

import inspect
import warnings
from collections.abc import Callable, Mapping, Sequence
from enum import Enum
from math import cos, pi, sin
from typing import Any, NoReturn

import numpy as np
import numpy.typing as npt

from dalembert import _core
from dalembert._checks import FloatArray, as_vector, shape_error
from dalembert._hdf5 import ConvertDictToScipySparse, ConvertScipySparseToDict, LoadDictFromHDF5, SaveDictToHDF5

__all__ = [
    "ConvertDictToScipySparse",
    "ConvertFunctionToSymbolic",
    "ConvertScipySparseToDict",
    "CreateSymbolicUserFunction",
    "ExpectedType",
    "FillInSubMatrix",
    "FindNodeIndex",
    "FindObjectIndex",
    "FrequencySweep",
    "IndexFromValue",
    "IsEmptyList",
    "IsIntVector",
    "IsInteger",
    "IsListOrArray",
    "IsNone",
    "IsNotNone",
    "IsReal",
    "IsSquareMatrix",
    "IsValidBool",
    "IsValidInt",
    "IsValidMarkerIndex",
    "IsValidNodeIndex",
    "IsValidObjectIndex",
    "IsValidPRealInt",
    "IsValidRealInt",
    "IsValidURealInt",
    "IsVector",
    "LoadDictFromHDF5",
    "PlotLineCode",
    "RaiseTypeError",
    "RoundMatrix",
    "SaveDictToHDF5",
    "SmoothStep",
    "SmoothStepDerivative",
    "SweepCos",
    "SweepSin",
]


def PlotLineCode(index: int) -> str:
    """Return a matplotlib colour and line code, e.g. 'r-'; 28 different ones, then 'k:' for larger indices."""
    colors, lines = "rgbkcmy", ("-", ":", "--", "-.")
    if index >= len(colors) * len(lines):
        return "k:"
    line, color = divmod(index % (len(colors) * len(lines)), len(colors))
    return colors[color] + lines[line]


def _find_index(kind: str, i: Any, variables: Mapping[str, Any]) -> None:
    """Print the variables that hold item i; item index types are recognized by their name."""
    found = [
        name for name, value in variables.items() if type(value).__name__ == kind + "Index" and int(value) == int(i)
    ]
    for name in found:
        print(f"variable '{name}' links to {kind.lower()} {i}")
    if not found:
        print(f"no variable links to {kind.lower()} {i}")


def FindObjectIndex(i: Any, globalVariables: Mapping[str, Any]) -> None:
    """Print the names of the variables (e.g. of globals()) that hold the ObjectIndex i."""
    _find_index("Object", i, globalVariables)


def FindNodeIndex(i: Any, globalVariables: Mapping[str, Any]) -> None:
    """Print the names of the variables (e.g. of globals()) that hold the NodeIndex i."""
    _find_index("Node", i, globalVariables)


def IsListOrArray(data: Any, checkIfNoneEmpty: bool = False) -> bool:
    """Return True for a list or numpy array; with checkIfNoneEmpty only if it has entries."""
    return isinstance(data, list | np.ndarray) and not (checkIfNoneEmpty and len(data) == 0)


class ExpectedType(Enum):
    """Names of the argument types in error messages; numbers add the flags Positive or Unsigned."""

    _None = 0
    Positive = 1
    Unsigned = 2
    Bool = 4
    Int = 8
    PInt = 9
    UInt = 10
    Real = 16
    PReal = 17
    UReal = 18
    Vector = 32
    IntVector = 40
    Matrix = 64
    RigidBodyInertia = 128
    NodeIndex = 256
    ObjectIndex = 512
    MarkerIndex = 1024
    LoadIndex = 2048
    SensorIndex = 4096
    String = 8192


_containers = {
    ExpectedType.Vector: " (list or numpy array)",
    ExpectedType.IntVector: " (list or numpy array)",
    ExpectedType.Matrix: " (list of lists or numpy array)",
}


def RaiseTypeError(
    where: str = "",
    argumentName: str = "",
    received: Any = None,
    expectedType: ExpectedType | str | None = None,
    dim: int | None = None,
    cols: int | None = None,
) -> NoReturn:
    """Raise a ValueError that names function, argument, expected type with size, and the received value.

    dim is the length of a vector or the number of rows of a matrix, which is square unless cols is given.
    """
    if isinstance(expectedType, ExpectedType):
        expected = expectedType.name + _containers.get(expectedType, "")
        if dim is not None:
            columns = dim if expectedType is ExpectedType.Matrix and cols is None else cols
            expected += f" of size {dim}" if columns is None else f" of size ({dim},{columns})"
    else:
        expected = str(expectedType)
    raise shape_error(f"ERROR in {where} in argument {argumentName}", expected, received)


def IsNone(x: Any) -> bool:
    """Return True if x is None; safe for arrays."""
    return x is None


def IsNotNone(x: Any) -> bool:
    """Return True if x is not None; safe for arrays."""
    return x is not None


def IsValidBool(x: Any) -> bool:
    """Return True if x is a bool or can stand for one (int or numpy integer)."""
    return isinstance(x, bool | int | np.integer)


def IsValidRealInt(x: Any) -> bool:
    """Return True if x is an int or float of Python, or a numpy integer or double."""
    return isinstance(x, float | int | np.integer)


def IsValidInt(x: Any) -> bool:
    """Return True if x is an int or numpy integer."""
    return isinstance(x, int | np.integer)


def IsValidPRealInt(x: Any) -> bool:
    """Return True if x is a positive number."""
    return IsValidRealInt(x) and bool(x > 0)


def IsValidURealInt(x: Any) -> bool:
    """Return True if x is a non-negative number."""
    return IsValidRealInt(x) and bool(x >= 0)


def IsReal(x: Any) -> bool:
    """Return True if x is a float of Python or numpy."""
    return isinstance(x, float | np.floating)


def IsInteger(x: Any) -> bool:
    """Return True if x is an integer of Python or numpy."""
    return isinstance(x, int | np.integer)


def _has_size(v: Any, expectedSize: int | None) -> bool:
    return isinstance(v, list | np.ndarray) and (expectedSize is None or len(v) == expectedSize)


def IsVector(v: Any, expectedSize: int | None = None) -> bool:
    """Return True if v is a list or array of numbers, with expectedSize components if it is given."""
    return _has_size(v, expectedSize) and all(IsValidRealInt(x) for x in v)


def IsIntVector(v: Any, expectedSize: int | None = None) -> bool:
    """Return True if v is a list or array of integers, with expectedSize components if it is given."""
    return _has_size(v, expectedSize) and all(IsInteger(x) for x in v)


def IsSquareMatrix(m: Any, expectedSize: int | None = None) -> bool:
    """Return True if m is a list of lists or array of numbers, with as many columns as rows (expectedSize if given)."""
    return _has_size(m, expectedSize) and all(IsVector(row, len(m)) for row in m)


def _is_item_index(x: Any, kind: str) -> bool:
    return IsInteger(x) or type(x).__name__ == kind


def IsValidObjectIndex(x: Any) -> bool:
    """Return True if x is an ObjectIndex or an integer."""
    return _is_item_index(x, "ObjectIndex")


def IsValidNodeIndex(x: Any) -> bool:
    """Return True if x is a NodeIndex or an integer."""
    return _is_item_index(x, "NodeIndex")


def IsValidMarkerIndex(x: Any) -> bool:
    """Return True if x is a MarkerIndex or an integer."""
    return _is_item_index(x, "MarkerIndex")


def IsEmptyList(x: Any) -> bool:
    """Return True if x is a list or array without entries."""
    return isinstance(x, list | np.ndarray) and len(x) == 0


def FillInSubMatrix(
    subMatrix: npt.NDArray[Any], destinationMatrix: npt.NDArray[Any], destRow: int, destColumn: int
) -> None:
    """Write subMatrix into destinationMatrix, its first entry at (destRow, destColumn); ValueError if too large."""
    rows, columns = subMatrix.shape
    available = destinationMatrix[destRow : destRow + rows, destColumn : destColumn + columns]
    if available.shape != subMatrix.shape:
        raise shape_error("FillInSubMatrix: subMatrix", f"a matrix not larger than {available.shape}", subMatrix)
    available[...] = subMatrix


def FrequencySweep(t: float, t1: float, f0: float, f1: float) -> float:
    """Return the frequency in Hz at time t of a linear sweep from f0 at time 0 to f1 at time t1."""
    return f0 + (f1 - f0) * t / t1


def _sweep_phase(t: float, t1: float, f0: float, f1: float) -> float:
    """Return the phase of the sweep in rad, the integral of its angular frequency."""
    return 2.0 * pi * t * (f0 + 0.5 * (f1 - f0) * t / t1)


def SweepSin(t: float, t1: float, f0: float, f1: float) -> float:
    """Return the sine sweep at time t with a frequency linear from f0 at time 0 to f1 (in Hz) at time t1."""
    return sin(_sweep_phase(t, t1, f0, f1))


def SweepCos(t: float, t1: float, f0: float, f1: float) -> float:
    """Return the cosine sweep at time t with a frequency linear from f0 at time 0 to f1 (in Hz) at time t1."""
    return cos(_sweep_phase(t, t1, f0, f1))


def SmoothStep(x: float, x0: float, x1: float, value0: float, value1: float) -> float:
    """Return value0 before x0, value1 after x1, and half a cosine wave between, with a continuous derivative."""
    if x <= x0:
        return value0
    if x >= x1:
        return value1
    return value0 + 0.5 * (value1 - value0) * (1.0 - cos(pi * (x - x0) / (x1 - x0)))


def SmoothStepDerivative(x: float, x0: float, x1: float, value0: float, value1: float) -> float:
    """Return the derivative of SmoothStep with respect to x."""
    if not x0 < x < x1:
        return 0.0
    width = x1 - x0
    return 0.5 * (value1 - value0) * pi / width * sin(pi * (x - x0) / width)


def IndexFromValue(
    data: Sequence[float] | FloatArray,
    value: float,
    tolerance: float = 1e-7,
    assumeConstantSampleRate: bool = False,
    rangeWarning: bool = True,
) -> int:
    """Return the index of the entry of data that is closest to value, e.g. of a time in the vector of times.

    With assumeConstantSampleRate the index is computed from the first two entries, rounded down and limited to the
    range of data (with a warning). Otherwise ValueError is raised if no entry is closer than tolerance.
    """
    samples = as_vector("IndexFromValue: data", data)
    if assumeConstantSampleRate and len(samples) > 1:
        dt = samples[1] - samples[0]
        if dt == 0.0:
            raise shape_error("IndexFromValue: data", "different first and second entries", data)
        index = int((value - samples[0]) / dt)
        limited = min(max(index, 0), len(samples) - 1)
        if limited != index and rangeWarning:
            warnings.warn(f"IndexFromValue: value {value} is out of range, using index {limited}", stacklevel=2)
        return limited
    distance = np.abs(samples - value)
    best = int(np.argmin(distance)) if len(samples) else -1
    if best < 0 or not distance[best] < tolerance:
        raise ValueError(f"IndexFromValue: value {value} is not in data within the tolerance {tolerance}")
    return best


def RoundMatrix(matrix: npt.NDArray[Any], treshold: float = 1e-14) -> None:
    """Set the entries of the array matrix with a magnitude below treshold to zero, in place."""
    matrix[np.abs(matrix) < treshold] = 0


# Sizes of vectors and matrices that are passed to user functions; all other vectors have 3 components.
# None: as many as the item's nodes have coordinates.
_SYMBOLIC_SIZES: dict[tuple[str, str], list[int | None]] = {
    ("ObjectConnectorRigidBodySpringDamper", "springForceTorqueUserFunction"): [3, 3, 3, 3, 6, 6, 3, 3, 6],
    ("ObjectJointGeneric", "offsetUserFunction"): [6],
    ("ObjectJointGeneric", "offsetUserFunction_t"): [6],
    ("ObjectGenericODE1", "rhsUserFunction"): [None],
    ("ObjectGenericODE2", "forceUserFunction"): [None, None],
    ("ObjectGenericODE2", "massMatrixUserFunction"): [None, None],
    ("ObjectGenericODE2", "jacobianUserFunction"): [None, None],
    ("ObjectFFRF", "forceUserFunction"): [None, None],
    ("ObjectFFRFreducedOrder", "forceUserFunction"): [None, None],
    ("ObjectKinematicTree", "forceUserFunction"): [None, None],
}
# User functions whose vectors have sizes that are not known before the system is assembled.
_NOT_SYMBOLIC = {
    ("ObjectConnectorRigidBodySpringDamper", "postNewtonStepUserFunction"),
    ("ObjectConnectorCoordinateVector", "constraintUserFunction"),
    ("ObjectConnectorCoordinateVector", "jacobianUserFunction"),
    ("SensorUserFunction", "sensorUserFunction"),
}
_SYMBOLIC_TYPES = {
    "scalar": "Real",
    "boolean": "Bool",
    "integer": "Index",
    "vector": "StdVector",
    "matrix": "NumpyMatrix",
}
_MAIN_SYSTEM_FUNCTIONS = {"preStepUserFunction": "Bool", "postNewtonFunction": "StdVector2D"}


def _item_with_function(mbs: Any, itemIndex: Any) -> tuple[str, Any]:
    """Type name and dictionary of an item, e.g. ObjectConnectorSpringDamper."""
    kind = type(itemIndex).__name__.removesuffix("Index")
    if kind not in ("Node", "Object", "Marker", "Load", "Sensor"):
        raise TypeError(f"CreateSymbolicUserFunction: itemIndex must be an ObjectIndex or the like, not {itemIndex!r}")
    data = getattr(mbs, "Get" + kind)(itemIndex)
    name: str = data[kind.lower() + "Type"]
    return kind + name, data


def _coordinates_of_nodes(mbs: Any, data: Any) -> int:
    if data is None:
        raise ValueError(
            "ConvertFunctionToSymbolic: the number of coordinates is needed; pass itemIndex instead of itemTypeName"
        )
    numbers = data["nodeNumbers"] if "nodeNumbers" in data else [data["nodeNumber"]]
    return sum(len(mbs.GetNode(n)["referenceCoordinates"]) for n in numbers)


def ConvertFunctionToSymbolic(
    mbs: Any,
    function: Callable[..., Any],
    userFunctionName: str,
    itemIndex: Any = None,
    itemTypeName: str | None = None,
    verbose: int = 0,
) -> dict[str, Any]:
    """Call a Python user function once with symbolic arguments and record what it computes.

    userFunctionName is the parameter of the item, e.g. 'springForceUserFunction'. Either itemIndex or itemTypeName
    (e.g. 'ObjectConnectorSpringDamper' or 'MainSystem') says which item. The result is a dictionary with functionName,
    argList, argTypeList, returnValue and returnType, as UserFunction.SetUserFunctionFromDict(...) takes it.
    The function must be made of operators and of functions of exudyn.symbolic; 'if' cannot be recorded, use
    exudyn.symbolic.IfThenElse.
    """
    symbolic = _core.symbolic
    data = None
    if itemTypeName is None:
        if itemIndex is None:
            raise ValueError("ConvertFunctionToSymbolic: either itemIndex or itemTypeName is needed")
        itemTypeName, data = _item_with_function(mbs, itemIndex)
    elif itemIndex is not None:
        raise ValueError("ConvertFunctionToSymbolic: pass itemIndex or itemTypeName, but not both")
    if itemTypeName == "MainSystem":
        kinds = ["scalar"] if userFunctionName in _MAIN_SYSTEM_FUNCTIONS else None
        result_type = _MAIN_SYSTEM_FUNCTIONS.get(userFunctionName, "")
    else:
        signature = symbolic._signature(itemTypeName, userFunctionName)
        kinds, result_kind = signature if signature is not None else (None, "")
        result_type = _SYMBOLIC_TYPES.get(result_kind, result_kind)
    if kinds is None:
        raise ValueError(f"ConvertFunctionToSymbolic: {itemTypeName} has no user function '{userFunctionName}'")
    if (itemTypeName, userFunctionName) in _NOT_SYMBOLIC:
        raise NotImplementedError(
            f"ConvertFunctionToSymbolic: {itemTypeName}, '{userFunctionName}': the sizes of its vectors are known at "
            "Assemble() only; pass the Python function itself"
        )
    names = list(inspect.signature(function).parameters)
    if len(names) != len(kinds) + 1:
        raise ValueError(
            f"ConvertFunctionToSymbolic: {itemTypeName}, '{userFunctionName}' is called with mbs and {len(kinds)} "
            f"further arguments, but the function has the parameters {', '.join(names)}"
        )
    sizes = iter(_SYMBOLIC_SIZES.get((itemTypeName, userFunctionName), []))
    arguments: list[Any] = [mbs]
    stored = symbolic.GetRecording()
    symbolic.SetRecording(True)
    try:
        for name, kind in zip(names[1:], kinds, strict=True):
            if kind not in ("vector", "matrix"):
                arguments.append(symbolic.Real(name, 0.0))
                continue
            size = next(sizes, 3)
            n = _coordinates_of_nodes(mbs, data) if size is None else size
            zeros = np.zeros(n if kind == "vector" else (n, n))
            arguments.append((symbolic.Vector if kind == "vector" else symbolic.Matrix)(name, zeros))
        returned = function(*arguments)
        if isinstance(returned, (list, tuple)):
            nested = len(returned) > 0 and isinstance(returned[0], (list, tuple))
            returned = symbolic.Matrix(returned) if nested else symbolic.Vector(returned)
    finally:
        symbolic.SetRecording(stored)
    if verbose:
        _core.Print("return value=", returned)
    return {
        "functionName": function.__name__,
        "argList": arguments,
        "argTypeList": ["MainSystem", *(_SYMBOLIC_TYPES.get(kind, kind) for kind in kinds)],
        "returnValue": returned,
        "returnType": result_type,
    }


def CreateSymbolicUserFunction(
    mbs: Any,
    function: Callable[..., Any],
    userFunctionName: str,
    itemIndex: Any = None,
    itemTypeName: str | None = None,
    verbose: int = 0,
) -> Any:
    """Make a symbolic user function of a Python function, to be set as parameter of an item."""
    data = ConvertFunctionToSymbolic(mbs, function, userFunctionName, itemIndex, itemTypeName, verbose)
    symbolic_function = _core.symbolic.UserFunction()
    symbolic_function.SetUserFunctionFromDict(mbs, data, userFunctionName, itemIndex, str(itemTypeName))
    return symbolic_function
