"""Helpers for triangle meshes and extrusions, and the colours by their older names (color4red, ...)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert import graphics
from dalembert._checks import (
    FloatArray,
    IntArray,
    as_point_numbers,
    as_points,
    shape_error,
)
from dalembert.graphics._mesh import GraphicsData, triangle_normals
from dalembert.graphics._outlines import (
    CirclePointsAndSegments as CirclePointsAndSegments,
)
from dalembert.graphics._outlines import (
    Compute6NodeTrigsNormals as Compute6NodeTrigsNormals,
)
from dalembert.graphics._outlines import (
    ComputeTriangularMesh as ComputeTriangularMesh,
)
from dalembert.graphics._outlines import (
    SegmentsFromPoints as SegmentsFromPoints,
)
from dalembert.graphics._styles import color, colorList

color4red = color.red
color4green = color.green
color4blue = color.blue
color4cyan = color.cyan
color4magenta = color.magenta
color4yellow = color.yellow
color4orange = color.orange
color4pink = color.pink
color4lawngreen = color.lawngreen
color4springgreen = color.springgreen
color4violet = color.violet
color4dodgerblue = color.dodgerblue
color4lightred = color.lightred
color4lightgreen = color.lightgreen
color4steelblue = color.steelblue
color4brown = color.brown
color4black = color.black
color4darkgrey = color.darkgrey
color4darkgrey2 = color.darkgrey2
color4grey = color.grey
color4lightgrey = color.lightgrey
color4lightgrey2 = color.lightgrey2
color4white = color.white
color4default = color.default
color4list = colorList
color4listSize = len(color4list)


def SwitchTripletOrder(vector: Sequence[Any]) -> list[Any]:
    """Return a list of 3 entries with the last two exchanged."""
    if not hasattr(vector, "__len__") or len(vector) != 3:
        raise shape_error("SwitchTripletOrder: vector", "3 entries", vector)
    first, second, third = vector
    return [first, third, second]


def ComputeTriangleNormal(p0: npt.ArrayLike, p1: npt.ArrayLike, p2: npt.ArrayLike) -> FloatArray:
    """Return the unit normal of a triangle with 3 counter-clockwise points; zeros if it has no area."""
    return triangle_normals(as_points("p0, p1, p2", [p0, p1, p2]), np.array([[0, 1, 2]]))[0]


def ComputeTriangleArea(p0: npt.ArrayLike, p1: npt.ArrayLike, p2: npt.ArrayLike) -> float:
    """Return the area of a triangle with three 3D points."""
    a, b, c = as_points("p0, p1, p2", [p0, p1, p2])
    return 0.5 * float(np.linalg.norm(np.cross(b - a, c - a)))


def RefineMesh(points: npt.ArrayLike, triangles: npt.ArrayLike) -> list[list[npt.NDArray[Any]]]:
    """Return [points, triangles] of the mesh with each triangle divided into 4; new points are shared on edges."""
    newPoints = list(as_points("RefineMesh: points", points))
    corners = as_point_numbers("RefineMesh: triangles", triangles, 3, len(newPoints))
    newTriangles: list[IntArray] = []
    middles: dict[frozenset[int], int] = {}

    def middle(a: int, b: int) -> int:
        key = frozenset((a, b))
        if key not in middles:
            middles[key] = len(newPoints)
            newPoints.append(0.5 * (newPoints[a] + newPoints[b]))
        return middles[key]

    for a, b, c in corners.tolist():
        ca, ab, bc = middle(c, a), middle(a, b), middle(b, c)
        newTriangles += [np.array(t) for t in ([a, ab, ca], [b, bc, ab], [c, ca, bc], [ca, ab, bc])]
    return [newPoints, newTriangles]


def ShrinkMeshNormalToSurface(
    points: npt.ArrayLike, triangles: npt.ArrayLike, distance: float
) -> list[list[npt.NDArray[Any]]]:
    """Return [points, triangles] with each point moved inwards, per axis by the largest shift of its triangles.

    The shift of a triangle is distance along its inner normal; points must not be duplicated.
    """
    p = as_points("ShrinkMeshNormalToSurface: points", points)
    t = as_point_numbers("ShrinkMeshNormalToSurface: triangles", triangles, 3, len(p))
    shifts = np.repeat(-distance * triangle_normals(p, t), 3, axis=0)
    lower, upper = np.zeros_like(p), np.zeros_like(p)
    np.minimum.at(lower, t.ravel(), shifts)
    np.maximum.at(upper, t.ravel(), shifts)
    return [list(p + np.where(-lower > upper, lower, upper)), list(t)]


def GraphicsDataRectangle(
    xMin: float, yMin: float, xMax: float, yMax: float, color: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0]
) -> GraphicsData:
    """Return the outline of a rectangle in the xy plane; deprecated, use graphics.Lines."""
    return graphics.Lines([[xMin, yMin, 0], [xMax, yMin, 0], [xMax, yMax, 0], [xMin, yMax, 0], [xMin, yMin, 0]], color)


def GraphicsDataOrthoCubeLines(
    xMin: float,
    yMin: float,
    zMin: float,
    xMax: float,
    yMax: float,
    zMax: float,
    color: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
) -> GraphicsData:
    """Return the edges of a block as one line; deprecated, use graphics.Brick with addEdges."""
    corners = [[x, y, z] for x in (xMin, xMax) for y in (yMin, yMax) for z in (zMin, zMax)]
    path = [0, 2, 0, 4, 6, 4, 5, 7, 5, 1, 3, 1, 0, 2, 6, 7, 3, 2]
    return graphics.Lines([corners[k] for k in path], color)
