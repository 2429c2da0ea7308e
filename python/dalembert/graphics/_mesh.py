"""Building blocks of triangle lists: the flat arrays of the interface from arrays with one point per row."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import (
    FloatArray,
    IntArray,
    as_array,
    as_color,
    as_point_numbers,
    as_rows,
    as_vector,
    check_colors,
    shape_error,
)

GraphicsData = dict[str, Any]


def triangle_list(
    where: str,
    points: FloatArray,
    triangles: npt.ArrayLike,
    colors: npt.ArrayLike,
    normals: FloatArray | None = None,
    edges: npt.ArrayLike | None = None,
    edgeColor: npt.ArrayLike | None = None,
) -> GraphicsData:
    """Return graphicsData of the type TriangleList; colors is one RGBA colour or one per point.

    where: the name of the called function, for errors.
    """
    if not np.isfinite(points).all():
        finite = np.isfinite(points).all(axis=-1)
        raise shape_error(f"{where}: points", "finite coordinates", points[~finite][0].tolist())
    name = f"{where}: color"
    rgba = as_array(name, colors, "4 numbers, red, green, blue and opacity from 0 to 1, such as graphics.color.red")
    if rgba.ndim != 2:
        rgba = as_color(name, rgba)[None].repeat(len(points), axis=0)
    else:
        if rgba.shape != (len(points), 4):
            raise shape_error(name, f"4 numbers, or 4 for each of {len(points)} points", colors)
        check_colors(name, rgba)
    data: GraphicsData = {"type": "TriangleList", "colors": rgba.ravel(), "points": points.ravel()}
    if normals is not None:
        data["normals"] = normals.ravel()
    data["triangles"] = np.asarray(triangles, dtype=int).ravel()
    if edges is not None:
        data["edges"] = np.asarray(edges, dtype=int).ravel()
        data["edgeColor"] = as_color(f"{where}: edgeColor", edgeColor).copy()
    return data


def unit_rows(vectors: FloatArray) -> FloatArray:
    """Return the rows divided by their lengths; zero rows stay zero."""
    lengths = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return np.divide(vectors, lengths, out=np.zeros_like(vectors), where=lengths != 0)


def triangle_normals(points: FloatArray, triangles: IntArray) -> FloatArray:
    """Return the unit normals of triangles with counter-clockwise corners; zero for degenerate triangles."""
    a, b, c = points[triangles[:, 0]], points[triangles[:, 1]], points[triangles[:, 2]]
    return unit_rows(np.cross(b - a, c - a))


def grid_indices(rows: int, columns: int, wrapRows: bool = False, wrapColumns: bool = True) -> tuple[IntArray, ...]:
    """Return the indices of the corners (i,j), (i+1,j), (i,j+1), (i+1,j+1) of the cells of a grid of points."""
    index = np.arange(rows * columns).reshape(rows, columns)
    if wrapRows:
        index = np.vstack([index, index[:1]])
    if wrapColumns:
        index = np.hstack([index, index[:, :1]])
    corners = index[:-1, :-1], index[1:, :-1], index[:-1, 1:], index[1:, 1:]
    return tuple(corner.ravel() for corner in corners)


def ring(n1: FloatArray, n2: FloatArray, angles: FloatArray) -> FloatArray:
    """Return the unit vectors sin(angle)*n1 + cos(angle)*n2, one per row."""
    return np.outer(np.sin(angles), n1) + np.outer(np.cos(angles), n2)


MOST_TILES = 10_000  # along a line: larger numbers exceed the memory, or are not visible


def at_least(where: str, nTiles: int, minimum: int, name: str = "nTiles") -> int:
    """Return nTiles, or the minimum with a warning if it is too small; ValueError if it is too large."""
    if nTiles < minimum:
        warnings.warn(f"{where}: {name} = {nTiles} is too small, using {minimum}", stacklevel=4)
        return minimum
    return at_most(where, nTiles, name)


def at_most(where: str, nTiles: int, name: str = "nTiles") -> int:
    """Return nTiles; ValueError if it is too large."""
    if nTiles > MOST_TILES:
        raise shape_error(f"{where}: {name}", f"an integer up to {MOST_TILES}", nTiles)
    return int(nTiles)


def two_colors(where: str, rgba: npt.ArrayLike, alternating: npt.ArrayLike | None, n: int) -> FloatArray:
    """Return n colours of which the second half is the alternating colour, if there is one."""
    first = as_color(f"{where}: color", rgba)
    second = first if alternating is None else as_color(f"{where}: alternatingColor", alternating)
    return np.vstack([np.tile(first, (n // 2, 1)), np.tile(second, (n - n // 2, 1))])


def no_unknown(where: str, arguments: dict[str, Any], known: tuple[str, ...]) -> None:
    """Warn about optional keyword arguments that a function does not know; they have no effect."""
    for name in sorted(set(arguments) - set(known)):
        warnings.warn(f"{where}: argument '{name}' is unknown; known are {', '.join(known)}", stacklevel=4)


PLACES = {"TriangleList": "points", "Line": "data", "Text": "position", "Circle": "position"}  # the entry with points


def require_type(where: str, graphicsData: GraphicsData, *kinds: str) -> None:
    """Raise an error if the value is not graphicsData, or of another type."""
    if not isinstance(graphicsData, dict):
        raise shape_error(f"{where}: graphicsData", "a dictionary, such as graphics.Sphere(radius=0.1)", graphicsData)
    received = graphicsData.get("type")
    if received not in kinds:
        *most, last = (f"'{kind}'" for kind in kinds)
        raise shape_error(f"{where}: graphicsData['type']", f"{', '.join(most)} or {last}" if most else last, received)


def entry_of(where: str, graphicsData: GraphicsData, key: str) -> Any:
    """Return an entry that graphicsData of this type needs; ValueError if it is not there."""
    if key not in graphicsData:
        raise ValueError(
            f"{where}: graphicsData: a {graphicsData['type']} needs '{key}', received {list(graphicsData)}"
        )
    return graphicsData[key]


def place_of(where: str, graphicsData: GraphicsData) -> FloatArray:
    """Return the points of graphicsData of any type, one per row: a text and a circle have one."""
    require_type(where, graphicsData, *PLACES)
    kind = graphicsData["type"]
    key = PLACES[kind]
    name, value = f"{where}: graphicsData['{key}']", entry_of(where, graphicsData, key)
    return as_vector(name, value, 3)[None] if key == "position" else as_rows(name, value, 3)


def mesh_of(where: str, graphicsData: GraphicsData) -> tuple[FloatArray, IntArray]:
    """Return copies of the points and the triangles of a TriangleList, one per row."""
    require_type(where, graphicsData, "TriangleList")
    points = place_of(where, graphicsData).copy()
    triangles = entry_of(where, graphicsData, "triangles")
    return points, as_point_numbers(f"{where}: graphicsData['triangles']", triangles, 3, len(points))
