"""Helpers for triangle meshes and extrusions, and the colours by their older names (color4red, ...)."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from math import pi
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert import graphics
from dalembert._checks import (
    FloatArray,
    IntArray,
    as_matrix,
    as_number,
    as_point_numbers,
    as_points,
    as_vector,
    check_integer,
    shape_error,
)
from dalembert.graphics._mesh import GraphicsData, triangle_normals, unit_rows
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


def Compute6NodeTrigsNormals(elementNodes: npt.ArrayLike) -> FloatArray:
    """Return the 6 unit normals at the nodes of a quadratic triangle, as 6x3 matrix.

    Nodes: 3 corners, then the middles of the sides opposite to corner 0, 1 and 2.
    """
    nodes = as_matrix("Compute6NodeTrigsNormals: elementNodes", elementNodes, (6, 3))
    xi, eta = np.array([[0, 0], [1, 0], [0, 1], [0.5, 0.5], [0, 0.5], [0.5, 0]]).T
    zeta = 1 - xi - eta
    zero = 0 * xi
    dXi = np.column_stack([1 - 4 * zeta, 4 * xi - 1, zero, 4 * eta, -4 * eta, 4 * (zeta - xi)])
    dEta = np.column_stack([1 - 4 * zeta, zero, 4 * eta - 1, 4 * xi, 4 * (zeta - eta), -4 * xi])
    return unit_rows(np.cross(dXi @ nodes, dEta @ nodes))


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


def _inside(simplices: IntArray, neighbors: IntArray, segments: IntArray) -> npt.NDArray[np.bool_]:
    """Return which triangles are left of the segments, or connected with such a triangle."""
    owner = {}
    for t, (a, b, c) in enumerate(simplices.tolist()):
        owner.update({(a, b): t, (b, c): t, (c, a): t})
    state = np.full(len(simplices) + 1, -1)  # 1 inside, 0 outside, -1 not known; the last one is beyond the hull
    for s0, s1 in segments.tolist():
        for edge, value in (((s0, s1), 1), ((s1, s0), 0)):
            if edge in owner:
                state[owner[edge]] = value
    while True:
        unknown = np.flatnonzero(state[:-1] == -1)
        found = state[neighbors[unknown]].max(axis=1)
        if not np.any(found != -1):
            return state[:-1] == 1
        state[unknown] = found


def ComputeTriangularMesh(vertices: npt.ArrayLike, segments: npt.ArrayLike) -> Any:
    """Return a scipy Delaunay triangulation of 2D vertices, whose simplices are those left of the segments.

    The segments, pairs of indices of vertices, form closed curves: the outer one counter-clockwise, holes clockwise.
    Duplicated vertices are reported by a warning.
    """
    from scipy.spatial import Delaunay

    tri = Delaunay(as_points("ComputeTriangularMesh: vertices", vertices, 2))
    if len(np.unique(tri.simplices)) < len(tri.points):
        warnings.warn("ComputeTriangularMesh: some vertices are in no triangle; are vertices duplicated?", stacklevel=2)
    ends = as_point_numbers("ComputeTriangularMesh: segments", segments, 2, len(tri.points))
    inside = _inside(tri.simplices, tri.neighbors, ends)
    tri.simplices = tri.simplices[inside]
    return tri


def SegmentsFromPoints(
    points: Sequence[Any] | npt.NDArray[Any],
    pointIndexOffset: int = 0,
    invert: bool = False,
    closeCurve: bool = True,
) -> IntArray:
    """Return the pairs of indices that connect n points one after the other, and the last with the first if closed."""
    if not hasattr(points, "__len__"):
        raise shape_error("SegmentsFromPoints: points", "a list of points", points)
    check_integer("SegmentsFromPoints: pointIndexOffset", pointIndexOffset, 0)
    n = len(points)
    start = np.arange(n if closeCurve else n - 1)
    pairs = np.column_stack([start, (start + 1) % n]) + pointIndexOffset
    return pairs[:, ::-1] if invert else pairs


def CirclePointsAndSegments(
    center: npt.ArrayLike = [0, 0],
    radius: float = 0.1,
    invert: bool = False,
    pointIndexOffset: int = 0,
    nTiles: int = 16,
) -> list[list[Any]]:
    """Return [points, segments] of a circle in the plane as lists, for SolidExtrusion.

    Points are sorted clockwise, so the circle is a hole; invert makes it an outer curve.
    """
    check_integer("CirclePointsAndSegments: nTiles", nTiles, 3)
    r = as_number("CirclePointsAndSegments: radius", radius)
    phi = 2 * pi * np.arange(nTiles) / nTiles
    points = as_vector("CirclePointsAndSegments: center", center, 2) + r * np.column_stack([np.sin(phi), np.cos(phi)])
    return [points.tolist(), SegmentsFromPoints(points, pointIndexOffset, invert).tolist()]


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
