"""Argument checks shared by the Python utility modules."""

from __future__ import annotations

import math
import operator
from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._core import (
    _floats,
    _is_plain_not_negative,
    _is_plain_number,
    _is_rotation,
    _is_transformation,
    _problem_of,
)

ComplexArray = npt.NDArray[np.complex128]
FloatArray = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.int64]


def shape_error(name: str, expected: str, received: Any) -> ValueError:
    """Return a ValueError with the argument, the expected and the received value."""
    if isinstance(received, np.number):
        received = received.item()
    try:
        text = repr(received)
    except Exception:  # a broken __repr__ must not hide the argument error
        text = f"<{type(received).__name__} without text>"
    if len(text) > 120:
        text = text[:117] + "..."
    shape = getattr(received, "shape", None)
    detail = f" of shape {shape}" if shape is not None else ""
    return ValueError(f"{name}: expected {expected}, received {text} ({type(received).__name__}{detail})")


_FLOAT, _INTEGER = np.dtype(float), np.dtype(np.int64)


def as_array(name: str, value: Any, expected: str = "an array of numbers") -> FloatArray:
    """Convert to a float array; ValueError names the argument if that is not possible."""
    if type(value) is np.ndarray and value.dtype is _FLOAT:
        return value
    try:
        array = np.asarray(value)
        if array.dtype.kind not in "USc":  # numpy reads numbers from texts, and leaves out imaginary parts
            return array.astype(float, copy=False)
    except (TypeError, ValueError, OverflowError):
        pass
    raise shape_error(name, expected, value)


def as_number(name: str, value: Any, negative: bool = True) -> float:
    """Convert to a finite float, which is not negative if that is asked for; ValueError otherwise, for texts too."""
    if (_is_plain_number if negative else _is_plain_not_negative)(value):
        return float(value)
    expected = "a finite number" if negative else "a finite number that is not negative"
    array = as_array(name, value, expected)
    if array.ndim != 0:
        raise shape_error(name, expected, value)
    number = float(array)
    if not np.isfinite(number) or (number < 0 and not negative):
        raise shape_error(name, expected, value)
    return number


def as_positive(name: str, value: Any) -> float:
    """Convert to a positive finite float; ValueError otherwise."""
    number = as_number(name, value)
    if number <= 0:
        raise shape_error(name, "a positive number", value)
    return number


def check_integer(name: str, value: Any, low: int, high: int | None = None) -> None:
    """Raise TypeError if the value is not an integer, ValueError if it is out of range."""
    expected = f"an integer, {low} or more" if high is None else f"an integer from {low} to {high}"
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(str(shape_error(name, expected, value))) from None
    if number < low or (high is not None and number > high):
        raise shape_error(name, expected, value)


def check_type(name: str, value: Any, kind: type) -> None:
    """Raise TypeError if the value does not have this type."""
    if not isinstance(value, kind):
        raise TypeError(str(shape_error(name, f"a {kind.__name__}", value)))


def check_system(name: str, value: Any) -> None:
    """Raise TypeError if the value is not a system."""
    if not hasattr(value, "GetSensor"):
        raise shape_error(name, "a system, of SC.AddSystem()", value)


def as_vector(name: str, value: Any, size: int | None = None) -> FloatArray:
    """Convert to a 1D float array, of the given size if there is one; ValueError otherwise."""
    expected = "a vector of numbers" if size is None else f"a vector with {size} components"
    array = as_array(name, value, expected)
    if array.ndim != 1 or (size is not None and array.shape[0] != size):
        raise shape_error(name, expected, value)
    return array


def floats(name: str, value: Any, size: int) -> Sequence[float]:
    """Return the numbers of a vector of the given size; ValueError if it is none."""
    found = _floats(value, size)
    return as_vector(name, value, size).tolist() if found is None else found


def as_matrix(name: str, value: Any, shape: tuple[int, int]) -> FloatArray:
    """Convert to a 2D float array of the given shape; ValueError otherwise."""
    expected = f"a {shape[0]}x{shape[1]} matrix"
    array = as_array(name, value, expected)
    if array.shape != shape:
        raise shape_error(name, expected, value)
    return array


ROTATION = "a 3x3 rotation matrix, orthogonal and with determinant 1"
TRANSFORMATION = "a 4x4 homogeneous transformation [[A, r], [0, 1]]"


def as_rotation(name: str, value: Any) -> FloatArray:
    """Convert to a 3x3 array; ValueError unless it is a rotation matrix to 1e-8: no scaling, shear or reflection."""
    if _is_rotation(value):  # the usual case
        return value
    array = as_matrix(name, value, (3, 3))
    if problem := rotation_problem(array):
        raise ValueError(f"{shape_error(name, ROTATION, value)}. {problem}")
    return array


def as_transformation(name: str, value: Any) -> FloatArray:
    """Convert to a 4x4 array; ValueError unless it is a homogeneous transformation of a rotation and a translation."""
    if _is_transformation(value):
        return value
    array = as_matrix(name, value, (4, 4))
    last = array[3].tolist()
    if last != [0.0, 0.0, 0.0, 1.0] and not np.allclose(last, [0.0, 0.0, 0.0, 1.0], rtol=0.0, atol=1e-8):
        raise ValueError(f"{shape_error(name, TRANSFORMATION, value)}. Its last row is {array[3].tolist()}.")
    if problem := rotation_problem(array[:3, :3]):
        raise ValueError(f"{shape_error(name, TRANSFORMATION, value)}. Of its rotation matrix: {problem}")
    return array


def rotation_problem(array: FloatArray) -> str:
    """Return the reason why a 3x3 array is not a rotation matrix; empty if it is one."""
    return _problem_of("rotation", array) if np.isfinite(array).all() else "An entry is not finite."


COLOR = "red, green, blue and opacity, each from 0 to 1"


def as_color(name: str, value: Any) -> FloatArray:
    """Convert to four numbers from 0 to 1; ValueError otherwise. A negative red stands for a default color."""
    array = as_vector(name, value, 4)
    if problem := color_problem(array):
        raise ValueError(f"{shape_error(name, COLOR, value)}. {problem}")
    return array


def check_colors(name: str, colors: FloatArray) -> None:
    """Refuse an array with four numbers for each point if those of a point are no color."""
    rows = colors.reshape(-1, 4)
    if len(rows) > 0:
        as_color(name, rows[rows.max(axis=1).argmax()])


def color_problem(array: FloatArray) -> str:
    """Return the reason why four numbers are not a color; empty if they are one."""
    return _problem_of("color", array) if all(map(math.isfinite, array.tolist())) else "A component is not finite."


def as_points(name: str, value: Any, columns: int = 3) -> FloatArray:
    """Convert a list of points to an array with one point per row; ValueError otherwise."""
    expected = f"a list of points with {columns} coordinates each"
    array = as_array(name, value, expected)
    if array.size == 0:
        return np.zeros((0, columns))
    if array.ndim != 2 or array.shape[1] != columns:
        raise shape_error(name, expected, value)
    return array


def as_rows(name: str, value: Any, columns: int) -> FloatArray:
    """Convert rows of so many numbers, or all of them one after the other, to rows; ValueError otherwise."""
    expected = f"rows of {columns} numbers each, or all of these numbers one after the other"
    array = as_array(name, value, expected)
    if array.size > 0 and (array.ndim == 0 or (array.size if array.ndim == 1 else array.shape[-1]) % columns != 0):
        raise shape_error(name, expected, value)
    return array.reshape(-1, columns)


def as_one_each(name: str, value: Any, columns: int, points: int) -> FloatArray | None:
    """Convert `columns` numbers per point to rows, or an empty value to None; raises ValueError otherwise."""
    rows = as_rows(name, value, columns)
    if len(rows) == 0:
        return None
    if len(rows) != points:
        expected = f"{columns} numbers for each of {points} points, or none"
        raise ValueError(f"{name}: expected {expected}, received {rows.size}")
    return rows


def _are_point_numbers(value: Any, columns: int, points: int) -> bool:
    """Return whether the value is a flat array of integers from 0 to points - 1, in whole rows; False if unsure."""
    if type(value) is not np.ndarray or value.dtype is not _INTEGER or value.ndim != 1 or value.size == 0:
        return False
    return value.size % columns == 0 and bool(np.maximum.reduce(value.view(np.uint64)) < points)  # -1: very large


def as_point_numbers(name: str, value: Any, columns: int, points: int) -> IntArray:
    """Convert numbers of points, of which there are so many, to rows; ValueError otherwise."""
    if _are_point_numbers(value, columns, points):  # the usual case
        rows: IntArray = value.reshape(-1, columns).copy()
        return rows
    numbers = as_rows(name, value, columns)
    wrong = numbers[~((numbers >= 0) & (numbers < points) & (numbers == np.floor(numbers)))]
    if wrong.size > 0:
        known = f"0 to {points - 1}" if points > 0 else "of which there are none"
        raise ValueError(f"{name}: expected numbers of points, {known}, received {wrong[0]:g}")
    return numbers.astype(int)


def unit_vector(name: str, value: Any, size: int = 3) -> FloatArray:
    """Return the vector divided by its length; raises ValueError for a zero vector."""
    vector = as_vector(name, value, size)
    length = np.linalg.norm(vector)
    if length == 0.0:
        raise shape_error(name, "a vector of non-zero length", value)
    return vector / length
