"""Texts in place of values: 'Position' for an enumeration, 'z' for an axis, 'red' or '#1f77b4' for a color."""

from __future__ import annotations

from enum import Enum
from typing import Any, TypeVar

from dalembert import _core
from dalembert._tools.missing_names import nearest

_Member = TypeVar("_Member", bound=Enum)

AXES: dict[str, list[float]] = {
    sign + name: [(-1.0 if sign == "-" else 1.0) * (i == k) + 0.0 for k in range(3)]
    for i, name in enumerate("xyz")
    for sign in ("", "+", "-")
}
# Red, green, blue from 0 to 255: names and values as in CSS, so that users know them from other programs.
_COLORS = {
    "black": (0, 0, 0),
    "blue": (0, 0, 255),
    "brown": (165, 42, 42),
    "cyan": (0, 255, 255),
    "darkblue": (0, 0, 139),
    "darkgreen": (0, 100, 0),
    "darkgrey": (169, 169, 169),
    "darkred": (139, 0, 0),
    "dodgerblue": (30, 144, 255),
    "gold": (255, 215, 0),
    "green": (0, 128, 0),
    "grey": (128, 128, 128),
    "lightblue": (173, 216, 230),
    "lightgreen": (144, 238, 144),
    "lightgrey": (211, 211, 211),
    "lime": (0, 255, 0),
    "magenta": (255, 0, 255),
    "navy": (0, 0, 128),
    "olive": (128, 128, 0),
    "orange": (255, 165, 0),
    "pink": (255, 192, 203),
    "purple": (128, 0, 128),
    "red": (255, 0, 0),
    "silver": (192, 192, 192),
    "steelblue": (70, 130, 180),
    "teal": (0, 128, 128),
    "violet": (238, 130, 238),
    "white": (255, 255, 255),
    "yellow": (255, 255, 0),
}


def member(kind: type[_Member], value: Any, where: str) -> _Member:
    """Return the member of an enumeration that a text names: 'RigidEP' or 'rigid_ep'; members stay as they are."""
    if not isinstance(value, str):
        return value
    names = {_plain(name): name for name in kind.__members__ if not name.startswith("_") and "EndOf" not in name}
    if found := names.get(_plain(value)):
        return kind[found]
    known = ", ".join(repr(name) for name in names.values())
    raise ValueError(f"{where}: received {value!r}{nearest(value, names.values()) or '.'} Expected one of {known}")


def _plain(name: str) -> str:
    return name.replace("_", "").lower()


def axis(value: Any, where: str) -> Any:
    """Return the unit vector of 'x', 'y', 'z', '-x', ...; other values stay as they are."""
    if not isinstance(value, str):
        return value
    if value.lower() not in AXES:
        raise ValueError(f"{where}: received {value!r}, but expected 'x', 'y', 'z', '-x', '-y', '-z' or 3 numbers")
    return list(AXES[value.lower()])


def color(value: Any, where: str) -> Any:
    """Return red, green, blue and opacity of a color name or of '#rrggbb', '#rgb', '#rrggbbaa'; others stay."""
    if not isinstance(value, str):
        return value
    name = value.lower().replace("gray", "grey")
    if name in _COLORS:
        return [part / 255 for part in _COLORS[name]] + [1.0]
    digits = name.removeprefix("#")
    if name.startswith("#") and set(digits) <= set("0123456789abcdef"):
        if len(digits) == 3:
            digits = "".join(2 * digit for digit in digits)
        if len(digits) in (6, 8):
            parts = [int(digits[i : i + 2], 16) / 255 for i in range(0, len(digits), 2)]
            return parts if len(parts) == 4 else [*parts, 1.0]
    hint = nearest(name, _COLORS) or f". Known are {', '.join(_COLORS)}"
    raise ValueError(f"{where}: received {value!r}, but expected '#rrggbb', the name of a color or 4 numbers{hint}")


def value_of(value: Any, kind: str, check: str, where: str) -> Any:
    """Return the value of a parameter for the core: texts become enumerations, axes and colors where these are meant.

    kind and check describe the parameter, as in the tables of the core.
    """
    if check == "color":
        return color(value, where)
    if check == "unit_vector" and kind == "3 numbers":
        return axis(value, where)
    if kind == "OutputVariableType":
        return member(_core.OutputVariableType, value, where)
    if kind == "list of JointType" and isinstance(value, (list, tuple)):
        return [member(_core.JointType, each, where) for each in value]
    return value
