"""Triangles that fill a cross section, with nodes on their edges, and denser around inner corners.

Stresses are singular at re-entrant corners (more than 180 degrees); triangles there halve in size from ring to ring, so
that integrals converge.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from dalembert._checks import FloatArray, IntArray
from dalembert._fem.section_outlines import Loop, SectionOutline

RINGS = 9


@dataclass(frozen=True)
class SectionMesh:
    """Points [y, z], and triangles with three corners and three nodes on edges: 01, 12, 20."""

    points: FloatArray
    triangles: IntArray


def mesh_of(outline: SectionOutline, fineness: float) -> SectionMesh:
    """Triangles about as long as a `fineness`-th of the section, or of three times its wall."""
    outer = outline.loops[0].points
    area = abs(sum(loop.signed_area for loop in outline.loops))
    length = sum(np.linalg.norm(loop.points - np.roll(loop.points, 1, axis=0), axis=1).sum() for loop in outline.loops)
    wall = 2 * area / length
    h = min(float(np.ptp(outer, axis=0).max()) / fineness, 8 * wall / fineness)
    for _ in range(5):
        divided = SectionOutline(tuple(Loop(_along(loop, h), loop.circle) for loop in outline.loops))
        points, triangles = _fill(outline, divided, h)
        a, b, c = (points[triangles[:, i]] for i in range(3))
        sizes = 0.5 * ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])
        whole = sum(loop.signed_area for loop in divided.loops)
        if abs(float(np.abs(sizes).sum()) - whole) < 1e-9 * whole:
            return _quadratic(outline, points, np.where((sizes < 0)[:, None], triangles[:, [0, 2, 1]], triangles))
        h *= 0.6
    raise ValueError("the outline of the section crosses itself, or has walls that are too thin to be meshed")


def _fill(outline: SectionOutline, divided: SectionOutline, h: float) -> tuple[FloatArray, IntArray]:
    from scipy.spatial import Delaunay, cKDTree  # here, as all models import this file and few need sections

    rings = [ring for loop in outline.loops for ring in _rings(loop, h)]
    border = np.vstack([*(loop.points for loop in divided.loops), *(ring[divided.contains(ring)] for ring in rings)])
    low, high = border.min(axis=0), border.max(axis=0)
    y = np.arange(low[0], high[0] + h, h)
    z = np.arange(low[1], high[1] + h, h * np.sqrt(0.75))
    grid = np.stack(np.meshgrid(y, z, indexing="ij"), axis=-1)
    grid[:, 1::2, 0] += 0.5 * h
    candidates = grid.reshape(-1, 2)
    far = cKDTree(border).query(candidates)[0] > 0.75 * h
    candidates = candidates[far]
    points = np.vstack([border, candidates[divided.contains(candidates)]])
    triangles = Delaunay(points).simplices.astype(np.int64)
    corners = points[triangles]
    edges = corners[:, [1, 2]] - corners[:, [0]]
    sizes = np.abs(edges[:, 0, 0] * edges[:, 1, 1] - edges[:, 0, 1] * edges[:, 1, 0])
    longest = np.max(np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2), axis=1)
    kept = divided.contains(corners.mean(axis=1)) & (sizes > 1e-10 * longest**2)
    return points, triangles[kept]


def _inner_corners(loop: Loop) -> list[int]:
    """Corners with more than 190 degrees inside; the section lies on the left of the loop."""
    if loop.circle is not None:
        return []
    before, after = loop.points - np.roll(loop.points, 1, axis=0), np.roll(loop.points, -1, axis=0) - loop.points
    cross = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    turn = np.arctan2(cross, np.sum(before * after, axis=1))
    return [int(i) for i in np.flatnonzero(turn < -np.pi / 18)]


def _first_ring(loop: Loop, i: int, h: float) -> float:
    n = len(loop.points)
    sides = (loop.points[i] - loop.points[i - 1], loop.points[(i + 1) % n] - loop.points[i])
    return min(h, *(float(np.linalg.norm(side)) / 3 for side in sides))


def _along(loop: Loop, h: float) -> FloatArray:
    """Points on the boundary, with those of the rings around inner corners."""
    if loop.circle is not None:
        y, z, radius = loop.circle
        count = max(len(loop.points), int(np.ceil(2 * np.pi * radius / h)))
        angles = np.sign(loop.signed_area) * 2 * np.pi * np.arange(count) / count
        return np.array([y, z]) + radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    inner, n, parts = set(_inner_corners(loop)), len(loop.points), []
    for i in range(n):
        start, end = loop.points[i], loop.points[(i + 1) % n]
        length = float(np.linalg.norm(end - start))
        marks = [0.0]
        low, high = 0.0, length
        if i in inner:
            low = _first_ring(loop, i, h)
            marks += [low * 0.5**k for k in range(RINGS - 1, 0, -1)]
        tail = []
        if (i + 1) % n in inner:
            ring = _first_ring(loop, (i + 1) % n, h)
            high = length - ring
            tail = [length - ring * 0.5**k for k in range(RINGS)]
        count = max(1, int(np.ceil((high - low) / h - 1e-9)))
        middle = np.linspace(low, high, count + 1)
        marks += list(middle[1:-1] if low == 0 else middle[:-1]) + tail
        parts.append(start + np.array(marks)[:, None] / length * (end - start))
    return np.vstack(parts)


def _rings(loop: Loop, h: float) -> list[FloatArray]:
    """Points between the two sides of each inner corner, at the distances of those on the sides."""
    rings = []
    for i in _inner_corners(loop):
        corner, after = loop.points[i], loop.points[(i + 1) % len(loop.points)] - loop.points[i]
        before = loop.points[i - 1] - loop.points[i]
        first = np.arctan2(after[1], after[0])
        angle = (np.arctan2(before[1], before[0]) - first) % (2 * np.pi)
        angles = first + angle * np.arange(1, 6) / 6
        directions = np.stack([np.cos(angles), np.sin(angles)], axis=1)
        radius = _first_ring(loop, i, h)
        rings += [corner + radius * 0.5**k * directions for k in range(RINGS)]
    return rings


def _quadratic(outline: SectionOutline, points: FloatArray, triangles: IntArray) -> SectionMesh:
    """Add nodes on edges; those on the boundary of a circle are moved to it."""
    edges = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    unique, inverse, times = np.unique(edges, axis=0, return_inverse=True, return_counts=True)
    middles = points[unique].mean(axis=1)
    for loop in outline.loops:
        if loop.circle is not None:
            y, z, radius = loop.circle
            ends = np.linalg.norm(points[unique] - [y, z], axis=2)
            on_circle = (times == 1) & (np.abs(ends - radius) < 0.01 * radius).all(axis=1)
            offsets = middles[on_circle] - [y, z]
            middles[on_circle] = [y, z] + radius * offsets / np.linalg.norm(offsets, axis=1, keepdims=True)
    used = len(points) + inverse.reshape(-1, 3)
    return SectionMesh(np.vstack([points, middles]), np.hstack([triangles, used]))
