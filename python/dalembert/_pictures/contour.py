"""Outputs as colors: selection of the numbers, and their colors."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert import _core
from dalembert._checks import FloatArray
from dalembert._core import OutputVariableType
from dalembert._pictures.looks import Looks
from dalembert._tools.sensor_facts import unit_on_bodies

ROUND_OFF = 1e-13  # relative width of a range that is one number: outputs are sums of some hundred products
LEAST_RANGE = 1e-6  # width of the range with which one number is colored, relative to it or to 1


class Contour:
    """The quantity shown as colors: one component of an output variable, or its norm (component -1)."""

    def __init__(self, looks: Looks) -> None:
        self.looks = looks
        self.variable = looks.setting("contour.outputVariable")
        self.component = int(looks.setting("contour.outputVariableComponent"))
        self.active = self.variable != OutputVariableType._None

    @property
    def name(self) -> str:
        """Return the title of the color bar."""
        if not self.active:
            return ""
        unit = unit_on_bodies(self.variable.name)
        part = "norm" if self.component < 0 else f"component {self.component}"
        return f"{self.variable.name}, {part}{f' ({unit})' if unit else ''}"

    def number(self, output: FloatArray | None) -> float:
        """Return the number of an output; 0 if the item does not have it."""
        if output is None or len(output) == 0:
            return 0.0
        if self.component < 0:
            return float(np.linalg.norm(output))
        return float(output[self.component]) if self.component < len(output) else 0.0

    def range(self, values: FloatArray) -> tuple[float, float]:
        """Return the smallest and the largest number on the bar of colors."""
        if not self.looks.setting("contour.automaticRange") or len(values) == 0:
            return self.fixed_range()
        low, high = float(values.min()), float(values.max())
        return (low, high) if high - low > ROUND_OFF * max(abs(low), abs(high)) else (low, low)

    def fixed_range(self) -> tuple[float, float]:
        """Return the numbers at the ends of the bar that the settings name."""
        return float(self.looks.setting("contour.minValue")), float(self.looks.setting("contour.maxValue"))


KEYS = (*(f"contourColor{i}" for i in range(5)), "contourColorMin", "contourColorMax")
Shade = tuple[float, ...]


def _keys(looks: Looks) -> tuple[Shade, ...]:
    """Return the colors in equal parts of the range, and those below and above it."""

    def read() -> tuple[Shade, ...]:
        advanced = looks.setting("contour.advanced")
        return tuple(tuple(map(float, getattr(advanced, key))) for key in KEYS)

    found: tuple[Shade, ...] = looks.derived("colors of numbers", read)
    return found


def colors(looks: Looks, values: FloatArray, limits: tuple[float, float]) -> FloatArray:
    """Return a color (RGBA) for each number: five of them in equal parts of the range, others beyond it."""
    low, high = limits
    width = high - low or LEAST_RANGE * max(abs(low), 1.0)  # one number has the lowest color
    result = _colored((np.asarray(values, float) - low) / width, _keys(looks))
    result[:, 3] = opacity(looks)
    return result


def palette(looks: Looks) -> list[list[int]]:
    """Return the colors of the bar on pages, from its lower end to its upper one."""
    shades: FloatArray = colors(looks, np.linspace(0, 1, 13), (0.0, 1.0))
    return np.round(255 * shades[:, :3]).astype(int).tolist()


def opacity(looks: Looks) -> float:
    """Return the opacity of all colors of numbers."""
    return float(min(max(looks.setting("contour.alphaTransparency"), 0.0), 1.0))


def _colored(part: FloatArray, keys: tuple[Shade, ...]) -> FloatArray:
    """Return colors for parts of the range, numbers from 0 to 1."""
    table = np.array(keys)
    place = np.clip(part, 0, 1) * 4
    index = np.minimum(place.astype(int), 3)
    rest = (place - index)[:, None]
    result: FloatArray = (1 - rest) * table[index] + rest * table[index + 1]
    result[part < -1e-9], result[part > 1 + 1e-9] = table[5], table[6]
    return result


STEPS = 1024  # steps of the range, for many numbers


def shades(looks: Looks, values: FloatArray, limits: tuple[float, float]) -> npt.NDArray[np.uint8]:
    """Return colors as bytes (RGB), by a table that is accurate to rounding."""
    return _core._shades(values, *limits, table(looks))


def table(looks: Looks) -> npt.NDArray[np.uint8]:
    """Return the colors (RGB) of steps of the range, as _core._shades has them."""
    return _table(_keys(looks))


@lru_cache(maxsize=4)
def _table(keys: tuple[Shade, ...]) -> npt.NDArray[np.uint8]:
    """Return a color for values below the range, colors of steps within it, and a color for values above."""
    parts: FloatArray = np.arange(-1.0, STEPS + 2) / STEPS
    return np.round(255 * np.clip(_colored(parts, keys)[:, :3], 0, 1)).astype(np.uint8)


def of_body(pen: Any, contour: Contour, number: int) -> Any:
    """Return the function of local points that gives the numbers of a rigid body, or None if it has no colors."""
    if not contour.active or not contour.looks.setting("contour.rigidBodiesColored"):
        return None
    if pen.places.body_output(number, contour.variable) is None:
        return None

    def values(points: FloatArray) -> FloatArray:
        unique, which = np.unique(points, axis=0, return_inverse=True)
        numbers = [contour.number(pen.places.body_output(number, contour.variable, point)) for point in unique]
        return np.array(numbers)[which.ravel()]

    return values
