"""Meshes of plane outlines, and the segments of outlines."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from math import pi
from typing import Any

import numpy as np
import numpy.typing as npt

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
from dalembert.graphics._mesh import unit_rows


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
