"""Checks of the types of arguments, and the error that names them."""

from __future__ import annotations

from enum import Enum
from typing import Any, NoReturn

import numpy as np

from dalembert._checks import shape_error


def IsListOrArray(data: Any, checkIfNoneEmpty: bool = False) -> bool:
    """Return True for a list or numpy array; if checkIfNoneEmpty is set, only if it has entries."""
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
