"""Difference formulas of fourth order for first derivatives: {multiple of the step: weight}."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from dalembert._checks import FloatArray

CENTRAL = {-2: 1 / 12, -1: -8 / 12, 1: 8 / 12, 2: -1 / 12}
FORWARD = {0: -25 / 12, 1: 48 / 12, 2: -36 / 12, 3: 16 / 12, 4: -3 / 12}
BACKWARD = {-multiple: -weight for multiple, weight in FORWARD.items()}
STEP = 1e-3  # relative: truncation errors of about 1e-12, and rounding errors of 1e-13


def derivative(function: Callable[[float], Any], step: float) -> Any:
    """Return the derivative at 0 by central differences."""
    return sum(weight * np.asarray(function(multiple * step)) for multiple, weight in CENTRAL.items()) / step


def gradient(function: Callable[[FloatArray], float], x: FloatArray) -> FloatArray:
    """Return the gradient of a function of a vector."""
    result = np.zeros(len(x))
    for i, value in enumerate(x):
        unit = np.eye(len(x))[i]

        def along(e: float, unit: FloatArray = unit) -> float:
            return function(x + e * unit)

        result[i] = derivative(along, STEP * max(1.0, abs(value)))
    return result
