"""Elementary vector helpers on lists, numerical integration rules and a few constants."""

from __future__ import annotations

import inspect
import math
import sys
import warnings
from collections.abc import Callable, Sequence
from importlib import import_module
from typing import Any

import numpy as np

from dalembert._checks import check_integer, shape_error
from dalembert._io.output_paths import CreateDirectoryForFile, OutputFilePath
from dalembert._tools.missing_names import missing_in
from dalembert._tools.user_interface import UIWindowSuppressed

__all__ = [
    "ClearWorkspace",
    "CreateDirectoryForFile",
    "DiagonalMatrix",
    "GaussIntegrate",
    "LobattoIntegrate",
    "NormL2",
    "Normalize",
    "OutputFilePath",
    "ScalarMult",
    "SmartRound2String",
    "Tilde2Vec",
    "UIWindowSuppressed",
    "VAdd",
    "VMult",
    "VSub",
    "VSum",
    "Vec2Tilde",
    "eye2D",
    "eye3D",
    "g",
    "gaussIntegrationPoints",
    "gaussIntegrationWeights",
    "lobattoIntegrationPoints",
    "lobattoIntegrationWeights",
    "pi",
    "sqrt2",
]

pi = math.pi
sqrt2 = math.sqrt(2.0)
g = 9.81  # standard value of gravity in m/s^2, as used in examples


def _deletable(name: str, value: Any) -> bool:
    text = str(value)
    return not name.startswith("_") and "func" not in text and "module" not in text


def ClearWorkspace() -> None:
    """Delete the global variables of the caller, the stored variables of the package, and close matplotlib figures.

    Names with a leading underscore, functions and modules are kept, and so is the stored view of the renderer.
    """
    frame = inspect.currentframe()
    caller = frame.f_back if frame is not None else None
    if caller is not None:
        variables = caller.f_globals
        for name in [name for name, value in variables.items() if _deletable(name, value)]:
            del variables[name]
    package = sys.modules.get("dalembert")
    for key in list(getattr(package, "sys", {})):
        if key != "renderState":
            del package.sys[key]  # type: ignore[union-attr]
    getattr(package, "variables", {}).clear()
    if "matplotlib" in sys.modules:
        import matplotlib.pyplot as plt

        plt.close("all")


def SmartRound2String(x: float, prec: int = 3) -> str:
    """Return x as text with prec significant digits, keeping a decimal point for fractions and short integers exact."""
    check_integer("SmartRound2String: prec", prec, 0)
    try:
        text = f"{x:.{prec}g}"
    except (TypeError, ValueError):
        raise shape_error("SmartRound2String: x", "a number", x) from None
    if not math.isfinite(x):
        return text
    if abs(x) > 1 and x != int(x) and "." not in text and "e" not in text:
        text += "."
    if x == int(x) and len(text) > len(str(x)):
        text = str(x)
    return text


def DiagonalMatrix(rowsColumns: int, value: float = 1) -> list[list[float]]:
    """Return a square diagonal matrix as list of lists, with value on the diagonal."""
    return [[value if row == column else 0 for column in range(rowsColumns)] for row in range(rowsColumns)]


eye2D = DiagonalMatrix(2, 1.0)
eye3D = DiagonalMatrix(3, 1.0)


def _has_length(name: str, v: Sequence[Any], size: int | None = None, like: str = "") -> None:
    if not hasattr(v, "__len__") or (size is not None and len(v) != size):
        raise shape_error(name, f"a vector with {size} components{like}" if size is not None else "a vector", v)


def _same_length(where: str, v0: Sequence[Any], v1: Sequence[Any]) -> None:
    _has_length(f"{where}: v0", v0)
    _has_length(f"{where}: v1", v1, len(v0), " as v0")


def _numbers(v: Sequence[Any]) -> Sequence[Any]:
    """Return an array as list: Python calculates with numbers of lists in a third of the time."""
    return v.tolist() if isinstance(v, np.ndarray) else v


def NormL2(vector: Sequence[float]) -> float:
    """Return the Euclidean norm of a vector."""
    try:
        return math.sqrt(sum([x * x for x in _numbers(vector)]))
    except TypeError:
        raise shape_error("NormL2: vector", "a vector of numbers", vector) from None


def VSum(vector: Sequence[float]) -> float:
    """Return the sum of the components of a vector."""
    try:
        return sum(_numbers(vector))
    except TypeError:
        raise shape_error("VSum: vector", "a vector of numbers", vector) from None


def VAdd(v0: Sequence[float], v1: Sequence[float]) -> list[float]:
    """Return the sum of two vectors of the same length as list."""
    _same_length("VAdd", v0, v1)
    return [a + b for a, b in zip(_numbers(v0), _numbers(v1), strict=True)]


def VSub(v0: Sequence[float], v1: Sequence[float]) -> list[float]:
    """Return the difference v0 - v1 of two vectors of the same length as list."""
    _same_length("VSub", v0, v1)
    return [a - b for a, b in zip(_numbers(v0), _numbers(v1), strict=True)]


def VMult(v0: Sequence[float], v1: Sequence[float]) -> float:
    """Return the scalar product of two vectors of the same length."""
    _same_length("VMult", v0, v1)
    return sum([a * b for a, b in zip(_numbers(v0), _numbers(v1), strict=True)])


def ScalarMult(scalar: float, v: Sequence[float]) -> list[float]:
    """Return the vector v times a scalar as list."""
    return [scalar * x for x in _numbers(v)]


def Normalize(v: Sequence[float]) -> list[float]:
    """Return the vector v divided by its Euclidean norm as list; a zero vector stays zero."""
    norm = NormL2(v)
    return ScalarMult(1.0 / norm if norm != 0 else 0.0, v)


def Vec2Tilde(v: Sequence[float]) -> list[list[float]]:
    """Return the skew matrix of a 3D vector as list of lists; deprecated, use rigidBodyUtilities.Skew."""
    warnings.warn("Vec2Tilde is deprecated; use rigidBodyUtilities.Skew", DeprecationWarning, stacklevel=2)
    _has_length("Vec2Tilde: v", v, 3)
    x, y, z = v
    return [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]


def Tilde2Vec(m: Sequence[Sequence[float]]) -> list[float]:
    """Return the vector of a 3x3 skew matrix as list; deprecated, use rigidBodyUtilities.Skew2Vec."""
    warnings.warn("Tilde2Vec is deprecated; use rigidBodyUtilities.Skew2Vec", DeprecationWarning, stacklevel=2)
    _has_length("Tilde2Vec: m", m, 3)
    for row in m:
        _has_length("Tilde2Vec: a row of m", row, 3)
    return [-m[1][2], m[0][2], -m[0][1]]


# Points and weights in [-1, 1]; list k is for the order 2*k+1. They are those of numpy's leggauss, bit by bit.
gaussIntegrationPoints = [
    [0.0],
    [-0.5773502691896257, 0.5773502691896257],
    [-0.7745966692414834, 0.0, 0.7745966692414834],
    [-0.8611363115940526, -0.33998104358485626, 0.33998104358485626, 0.8611363115940526],
    [-0.906179845938664, -0.5384693101056831, 0.0, 0.5384693101056831, 0.906179845938664],
]
gaussIntegrationWeights = [
    [2.0],
    [1.0, 1.0],
    [0.5555555555555557, 0.8888888888888888, 0.5555555555555557],
    [0.34785484513745357, 0.6521451548625464, 0.6521451548625464, 0.34785484513745357],
    [0.23692688505618928, 0.4786286704993663, 0.5688888888888887, 0.4786286704993663, 0.23692688505618928],
]
lobattoIntegrationPoints = [[-1.0, 1.0], [-1.0, 0.0, 1.0], [-1.0, -math.sqrt(0.2), math.sqrt(0.2), 1.0]]
lobattoIntegrationWeights = [[1.0, 1.0], [1 / 3, 4 / 3, 1 / 3], [1 / 6, 5 / 6, 5 / 6, 1 / 6]]


def _integrate(
    where: str,
    functionOfX: Callable[[float], Any],
    integrationOrder: int,
    interval: tuple[float, float],
    rule: tuple[list[list[float]], list[list[float]]],
) -> Any:
    points, weights = rule
    if integrationOrder % 2 != 1 or not 0 < integrationOrder < 2 * len(points):
        allowed = ", ".join(str(2 * k + 1) for k in range(len(points)))
        raise shape_error(f"{where}: integrationOrder", f"one of {allowed}", integrationOrder)
    half, middle = 0.5 * (interval[1] - interval[0]), 0.5 * (interval[0] + interval[1])
    k = integrationOrder // 2
    return sum(half * w * functionOfX(half * p + middle) for p, w in zip(points[k], weights[k], strict=True))


def GaussIntegrate(functionOfX: Callable[[float], Any], integrationOrder: int, a: float, b: float) -> Any:
    """Return the Gauss-Legendre integral of a scalar, vector or matrix function over [a, b].

    The rule is exact for polynomials up to the integration order, which is 1, 3, 5, 7 or 9; ValueError otherwise.
    """
    rule = (gaussIntegrationPoints, gaussIntegrationWeights)
    return _integrate("GaussIntegrate", functionOfX, integrationOrder, (a, b), rule)


def LobattoIntegrate(functionOfX: Callable[[float], Any], integrationOrder: int, a: float, b: float) -> Any:
    """Return the Gauss-Lobatto integral of a scalar, vector or matrix function over [a, b], using both end points.

    The rule is exact for polynomials up to the integration order, which is 1, 3 or 5; ValueError otherwise.
    """
    rule = (lobattoIntegrationPoints, lobattoIntegrationWeights)
    return _integrate("LobattoIntegrate", functionOfX, integrationOrder, (a, b), rule)


# Names that are here in release 1.13, and in utilities before.
_IN_UTILITIES = (
    "AddSensorRecorder",
    "AnimateSolution",
    "BinaryReadArrayIndex",
    "BinaryReadIndex",
    "BinaryReadReal",
    "BinaryReadRealVector",
    "BinaryReadString",
    "GetJointArgs",
    "GetOtherMarker",
    "HighlightItem",
    "LoadBinarySolutionFile",
    "LoadSolutionFile",
    "NumpyInt8ArrayToString",
    "RecoverSolutionFile",
    "SetSolutionState",
    "ShowOnlyObjects",
    "UFsensorRecord",
)


def __getattr__(name: str) -> Any:
    if name in _IN_UTILITIES:
        return getattr(import_module("dalembert.utilities"), name)
    raise missing_in(sys.modules[__name__], name)
