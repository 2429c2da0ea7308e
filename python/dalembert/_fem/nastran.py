"""Coordinate systems of grid points in bulk data of NASTRAN, which meshio takes for global ones."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from dalembert._checks import FloatArray

SUFFIXES = (".bdf", ".fem", ".nas", ".dat")
_KNOWN = ("CORD2R", "CORD2C", "CORD2S")
_WIDTHS = {False: 8, True: 16}


def _fields(line: str) -> list[str]:
    """Return the fields of a line in free, small or large format; a large field ends its name by *."""
    if "," in line:
        return [word.strip() for word in line.split(",")]
    width = _WIDTHS[line[:8].rstrip().endswith("*")]
    count = 4 if width == 16 else 8
    return [line[:8].strip(), *(line[8 + i * width : 8 + (i + 1) * width].strip() for i in range(count))]


def _cards(fileName: str) -> Iterator[tuple[str, list[str]]]:
    """Give name and values of each card of the bulk data."""
    name, values = "", list[str]()
    with open(fileName, encoding="utf-8", errors="replace") as file:
        for line in file:
            text = line.split("$")[0].rstrip().expandtabs()
            if not text:
                continue
            first, *more = _fields(text)
            if first[:1] in ("", "+", "*"):
                values += more
                continue
            yield name, values
            name, values = first.rstrip("*").upper(), more[:8] if "," in text else more
    yield name, values


def _number(text: str) -> float:
    """Return a number of NASTRAN, such as 1.5, 2.-3 or 1.D+2."""
    text = text.upper().replace("D", "E")
    for sign in "+-":
        at = text.rfind(sign)
        if at > 0 and text[at - 1] != "E":
            text = f"{text[:at]}E{text[at:]}"
    return float(text or 0)


class _Systems:
    def __init__(self, fileName: str) -> None:
        self.cards: dict[str, tuple[str, list[str]]] = {}
        self.grids: list[tuple[str, str]] = []
        for name, values in _cards(fileName):
            if name.startswith("CORD") and values:
                self.cards[values[0]] = name, values
            elif name == "GRID":
                self.grids.append((values[0], values[1] if len(values) > 1 else ""))

    def position(self, point: FloatArray, system: str, path: tuple[str, ...] = ()) -> FloatArray:
        """Return the global position of a point of a coordinate system."""
        if system in ("", "0"):
            return point
        name, values = self.cards.get(system, ("", []))
        if name not in _KNOWN or system in path:
            raise ValueError(f"coordinate system {system} ({name or 'not in the file'}), which is not read")
        a, b, c = (np.array([_number(v) for v in (values + [""] * 11)[2 + 3 * i : 5 + 3 * i]]) for i in range(3))
        a, b, c = (self.position(corner, values[1], (*path, system)) for corner in (a, b, c))
        z = (b - a) / np.linalg.norm(b - a)
        y = np.cross(z, c - a)
        y /= np.linalg.norm(y)
        first, second, third = point[0], *np.deg2rad(point[1:])
        if name == "CORD2C":
            point = np.array([first * np.cos(second), first * np.sin(second), point[2]])
        elif name == "CORD2S":
            around = np.array([np.cos(third), np.sin(third)])
            point = first * np.array([*(np.sin(second) * around), np.cos(second)])
        return a + np.column_stack([np.cross(y, z), y, z]) @ point


def global_positions(fileName: str, points: FloatArray) -> FloatArray:
    """Return where grid points are, of the coordinates that their cards have."""
    systems = _Systems(fileName)
    if all(system in ("", "0") for _, system in systems.grids):
        return points
    if len(systems.grids) != len(points):
        raise ValueError(f"{fileName}: {len(systems.grids)} cards GRID, but {len(points)} points were read")
    result = points.copy()
    for i, (grid, system) in enumerate(systems.grids):
        try:
            result[i] = systems.position(points[i], system)
        except ValueError as error:
            raise ValueError(f"{fileName}: GRID {grid} is in {error}") from None
    return result
