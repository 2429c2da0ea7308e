"""Triangle meshes: those of graphics data, and unit shapes that are scaled and moved to the position of an item."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, IntArray

Rgba = tuple[float, float, float, float]


@dataclass(eq=False)
class Mesh:
    """Points and triangles with their data; triangles are flat if there are no normals. Immutable."""

    points: FloatArray  # n x 3
    triangles: IntArray  # m x 3
    normals: FloatArray | None = None  # n x 3
    colors: FloatArray | None = None  # n x 4; None: the instance says it
    edges: IntArray = field(default_factory=lambda: np.empty((0, 2), int))  # pairs of points
    edge_color: Rgba = (0.2, 0.2, 0.2, 1.0)
    # one per point, for the ray tracer: 0: default; 1 + number; -1 - number: with its own color
    materials: IntArray | None = None
    sharp: IntArray | None = None  # see sharp_edges
    extreme: FloatArray | None = None  # see extremes
    is_round: bool = False  # looks the same when it is turned about its z axis


def same_form(a: Mesh, b: Mesh) -> bool:
    """Return whether two meshes differ in the places of their points alone."""
    parts: list[tuple[Any, Any]] = [(a.triangles, b.triangles), (a.colors, b.colors), (a.edges, b.edges)]
    return a.points.shape == b.points.shape and all(one is other or np.array_equal(one, other) for one, other in parts)


_DIRECTIONS = np.array([[x, y, z] for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1) if x or y or z], float)


def extremes(mesh: Mesh) -> FloatArray:
    """Return the points that lie farthest in 26 directions: few that stand for the size of all; computed once."""
    if mesh.extreme is None:
        points = mesh.points[np.isfinite(mesh.points).all(axis=1)]
        small = len(points) <= len(_DIRECTIONS)
        mesh.extreme = points if small else points[np.unique(np.argmax(points @ _DIRECTIONS.T, axis=0))]
    return mesh.extreme


def sharp_edges(mesh: Mesh) -> IntArray:
    """Return the edges where faces meet at more than 30 degrees or end, as pairs of points; computed once per mesh."""
    if mesh.sharp is None:
        size = float(np.abs(mesh.points).max(initial=0)) or 1.0
        _, same = np.unique(np.round(mesh.points / size, 9), axis=0, return_inverse=True)
        a, b, c = (same.ravel()[mesh.triangles[:, k]] for k in range(3))
        triangles = mesh.triangles[(a != b) & (b != c) & (c != a)]
        a, b, c = (mesh.points[triangles[:, k]] for k in range(3))
        normals = np.cross(b - a, c - a)
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
        sides = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
        face = np.tile(np.arange(len(triangles)), 3)
        welded = np.sort(same.ravel()[sides], axis=1)
        _, first, which, count = np.unique(welded, axis=0, return_index=True, return_inverse=True, return_counts=True)
        total = np.zeros((len(first), 3))
        np.add.at(total, which.ravel(), normals[face])
        # the sum of two unit normals at an angle x has the length 2 cos(x / 2)
        blunt = (count == 2) & (np.linalg.norm(total, axis=1) > 2 * np.cos(np.radians(15)))
        mesh.sharp = sides[first[~blunt]]
    return mesh.sharp


def edges_of_box(box: FloatArray) -> FloatArray:
    """Return the ends (12 x 2 x 3) of the edges of a box, which is given by its smallest and largest coordinates."""
    corner = np.array([[box[i, 0], box[j, 1], box[k, 2]] for i in (0, 1) for j in (0, 1) for k in (0, 1)])
    return corner[[(a, a | bit) for bit in (1, 2, 4) for a in range(8) if not a & bit]]


def rows(values: npt.ArrayLike, columns: int, kind: Any = float) -> npt.NDArray[Any]:
    """Return values as an array with so many columns."""
    return np.asarray(values, dtype=kind).reshape(-1, columns)


def grid_triangles(rows: int, columns: int) -> IntArray:
    """Return the triangles between rows of points, numbered row by row."""
    index = np.arange(rows * columns).reshape(rows, columns)
    a, b, c, d = (part.ravel() for part in (index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]))
    return np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])


def filled(polygon: FloatArray) -> IntArray:
    """Return triangles that fill a polygon without holes: corner by corner is cut off where no other is inside."""
    rest = list(range(len(polygon)))
    x, y = polygon.T
    if np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)) < 0:
        rest.reverse()
    triangles = []
    while len(rest) > 3:
        for k, here in enumerate(rest):
            before, after = rest[k - 1], rest[(k + 1) % len(rest)]
            corner = polygon[[before, here, after]]
            others = polygon[[i for i in rest if i not in (before, here, after)]]
            if _turn(*corner) > 0 and not _inside(others, corner):
                break
        else:
            k = 0  # it crosses itself: any way is as good
        triangles.append([rest[k - 1], rest[k], rest[(k + 1) % len(rest)]])
        del rest[k]
    return np.array([*triangles, rest], int).reshape(-1, 3)


def _turn(a: FloatArray, b: FloatArray, c: FloatArray) -> float:
    return float((b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]))


def _inside(points: FloatArray, corner: FloatArray) -> bool:
    """Return whether any point lies in a triangle that turns to the left."""
    sides = [(corner[k], corner[(k + 1) % 3]) for k in range(3)]
    return any(all(_turn(a, b, point) >= 0 for a, b in sides) for point in points)


def joined(*meshes: Mesh) -> Mesh:
    """Join several meshes; either all of them have normals, or no mesh has."""
    starts = np.cumsum([0, *(len(mesh.points) for mesh in meshes)])[:-1]
    normals = [mesh.normals for mesh in meshes if mesh.normals is not None]
    return Mesh(
        np.concatenate([mesh.points for mesh in meshes]),
        np.concatenate([mesh.triangles + start for mesh, start in zip(meshes, starts, strict=True)]),
        np.concatenate(normals) if normals else None,
    )


def revolved(radii: npt.ArrayLike, heights: npt.ArrayLike, tiles: int) -> Mesh:
    """Return the surface that a polygon in the half plane (radius, height) sweeps about z; its corners stay sharp."""
    angles = np.linspace(0, 2 * np.pi, tiles + 1)
    circle = np.stack([np.cos(angles), np.sin(angles), np.zeros_like(angles)], 1)
    points, normals, triangles = [], [], []
    profile = np.stack([np.asarray(radii, float), np.asarray(heights, float)], 1)
    for number, (begin, end) in enumerate(zip(profile[:-1], profile[1:], strict=True)):
        along = (end - begin) / np.linalg.norm(end - begin)
        normal = circle * along[1] + np.array([0, 0, -along[0]])
        for r, z in (begin, end):
            points.append(circle * r + np.array([0, 0, z]))
            normals.append(normal)
        triangles.append(grid_triangles(2, tiles + 1) + 2 * number * (tiles + 1))
    return Mesh(np.concatenate(points), np.concatenate(triangles), np.concatenate(normals), is_round=True)


def swept(line: FloatArray, radius: float, tiles: int) -> Mesh:
    """Return a tube along a line through points; its section is carried along without twist."""
    tangents = np.gradient(line, axis=0)
    tangents /= np.maximum(np.linalg.norm(tangents, axis=1, keepdims=True), 1e-300)
    side = np.eye(3)[np.argmin(np.abs(tangents[0]))]
    sides = np.empty_like(line)
    for i, tangent in enumerate(tangents):
        side = side - (side @ tangent) * tangent
        side /= max(float(np.linalg.norm(side)), 1e-300)
        sides[i] = side
    others = np.cross(tangents, sides)
    angles = np.linspace(0, 2 * np.pi, tiles + 1)[:, None, None]
    normals = (np.cos(angles) * sides + np.sin(angles) * others).transpose(1, 0, 2)
    points = line[:, None, :] + radius * normals
    return Mesh(points.reshape(-1, 3), grid_triangles(len(line), tiles + 1)[:, ::-1], normals.reshape(-1, 3))


@lru_cache(maxsize=64)
def cylinder(tiles: int, inner: float = 0.0) -> Mesh:
    """Return a cylinder about z from 0 to 1 of radius 1, with a hole of the inner radius."""
    if inner > 0:
        return revolved([inner, 1, 1, inner, inner], [0, 0, 1, 1, 0], tiles)
    return revolved([0, 1, 1, 0], [0, 0, 1, 1], tiles)


@lru_cache(maxsize=16)
def cone(tiles: int) -> Mesh:
    """Return a cone about z from 0 to 1, of radius 1 at its base."""
    return revolved([0, 1, 0], [0, 0, 1], tiles)


@lru_cache(maxsize=1)
def cube() -> Mesh:
    """Return a cube of side 1 about the origin, flat."""
    corners = np.array([[x, y, z] for z in (-0.5, 0.5) for y in (-0.5, 0.5) for x in (-0.5, 0.5)])
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return Mesh(corners, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]))


@lru_cache(maxsize=16)
def ball(tiles: int) -> Mesh:
    """Return a sphere of radius 1."""
    theta, phi = np.meshgrid(np.linspace(0, np.pi, tiles + 1), np.linspace(0, 2 * np.pi, 2 * tiles + 1), indexing="ij")
    points = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], -1).reshape(-1, 3)
    return Mesh(points, grid_triangles(tiles + 1, 2 * tiles + 1), points, is_round=True)


@lru_cache(maxsize=64)
def torus(minor: float, tiles: int, angle: float = 2 * np.pi) -> Mesh:
    """Return a torus about z of major radius 1, or a part of it."""
    angles = np.linspace(0, angle, 3 * tiles + 1)
    return swept(np.stack([np.cos(angles), np.sin(angles), np.zeros_like(angles)], 1), minor, tiles)


@lru_cache(maxsize=256)
def helix(slenderness: float, windings: int, wire: float, corners: int, tiles: int) -> Mesh:
    """Return a spring about z from 0 to 1, its ends on the axis, of radius 1; wire is the radius of its wire.

    `slenderness`, length by radius, is that at which the wire is round.
    """
    s = np.linspace(0, 1, corners * windings + 1)
    radius = np.minimum(1, np.minimum(s, 1 - s) / 0.08)
    z = np.clip((s - 0.1) / 0.8, 0, 1) * 0.8 + 0.1
    z = np.where(s < 0.1, s, np.where(s > 0.9, s, z))
    angle = 2 * np.pi * windings * s
    line = np.stack([radius * np.cos(angle), radius * np.sin(angle), slenderness * z], 1)
    mesh = swept(line, wire, tiles)
    stretch = np.array([1, 1, 1 / slenderness])
    assert mesh.normals is not None
    return Mesh(mesh.points * stretch, mesh.triangles, mesh.normals / stretch)
