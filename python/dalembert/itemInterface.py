"""The item classes: nodes, objects, markers, loads and sensors, their V... visualization classes and short names."""

from __future__ import annotations

import copy
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

import dalembert
from dalembert import _core

exudyn = exu = dalembert  # names under which models refer to the package after a star import

_classes = _core._item_classes()
globals().update(_classes)


def IIDiagMatrix(rowsColumns: int, value: float) -> list[list[float]]:
    """Return a square matrix, as list of rows, with `value` on the diagonal."""
    return [[value if i == j else 0 for j in range(rowsColumns)] for i in range(rowsColumns)]


def IsValidNumber(x: Any) -> bool:
    """Whether x is a number of Python or numpy."""
    return isinstance(x, (int, float, np.integer, np.floating))


def _checked(value: Any, parameterName: str, objectName: str, kinds: Any, lowest: str) -> Any:
    """Return a value of one of the kinds that is not below the lowest; ValueError otherwise."""
    valid = IsValidNumber(value) and bool(np.isfinite(value)) and isinstance(value, kinds)
    if not valid or value < 0 or (lowest == "positive" and value == 0):
        noun = "integer" if kinds is _INTEGERS else "number"
        expected = f"a finite {noun} that is {lowest}"
        raise ValueError(f"{objectName}, parameter '{parameterName}': received {value!r}, but expected {expected}")
    return value


_INTEGERS = (int, np.integer)
_NUMBERS = (*_INTEGERS, float, np.floating)


def CheckForValidUInt(value: Any, parameterName: str, objectName: str) -> Any:
    """Return an integer that is not negative; ValueError with the names of parameter and object otherwise."""
    return _checked(value, parameterName, objectName, _INTEGERS, "not negative")


def CheckForValidPInt(value: Any, parameterName: str, objectName: str) -> Any:
    """Return a positive integer; ValueError with the names of parameter and object otherwise."""
    return _checked(value, parameterName, objectName, _INTEGERS, "positive")


def CheckForValidUReal(value: Any, parameterName: str, objectName: str) -> Any:
    """Return a number that is not negative; ValueError with the names of parameter and object otherwise."""
    return _checked(value, parameterName, objectName, _NUMBERS, "not negative")


def CheckForValidPReal(value: Any, parameterName: str, objectName: str) -> Any:
    """Return a positive number; ValueError with the names of parameter and object otherwise."""
    return _checked(value, parameterName, objectName, _NUMBERS, "positive")


def CheckForValidNumpyArray(value: Any) -> Any:
    """Return a number as it is and a list as an array; ValueError if its rows are not of one length."""
    return value if IsValidNumber(value) else np.array(value)


def CopyDictLevel1(originalDict: Mapping[str, Any]) -> dict[str, Any]:
    """Return a copy of a dictionary with copied dictionaries and lists, but not deeper levels."""
    return {key: copy.copy(value) if isinstance(value, dict | list) else value for key, value in originalDict.items()}


_functions = [
    *("CheckForValidNumpyArray", "CheckForValidPInt", "CheckForValidPReal", "CheckForValidUInt", "CheckForValidUReal"),
    *("CopyDictLevel1", "IIDiagMatrix", "IsValidNumber"),
]
__all__ = [*_classes, *_functions, "copy", "exu", "exudyn", "np"]  # noqa: PLE0604

if TYPE_CHECKING:

    def __getattr__(name: str) -> Any: ...
