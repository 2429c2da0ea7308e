"""Entries of arrays: found, filled in, rounded."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, as_number, as_vector, shape_error


def FillInSubMatrix(
    subMatrix: npt.NDArray[Any], destinationMatrix: npt.NDArray[Any], destRow: int, destColumn: int
) -> None:
    """Write subMatrix into destinationMatrix, its first entry at (destRow, destColumn); ValueError if too large."""
    rows, columns = subMatrix.shape
    available = destinationMatrix[destRow : destRow + rows, destColumn : destColumn + columns]
    if available.shape != subMatrix.shape:
        raise shape_error("FillInSubMatrix: subMatrix", f"a matrix not larger than {available.shape}", subMatrix)
    available[...] = subMatrix


def IndexFromValue(
    data: Sequence[float] | FloatArray,
    value: float,
    tolerance: float = 1e-7,
    assumeConstantSampleRate: bool = False,
    rangeWarning: bool = True,
) -> int:
    """Return the index of the entry of data that is closest to value, e.g. of a time in the vector of times.

    assumeConstantSampleRate computes the index from the first two entries, rounded down and limited to the
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
    if not isinstance(matrix, np.ndarray) or matrix.dtype.kind not in "biufc":
        raise shape_error("RoundMatrix: matrix", "an array of numbers, which is changed", matrix)
    matrix[np.abs(matrix) < as_number("RoundMatrix: treshold", treshold)] = 0
