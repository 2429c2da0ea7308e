"""Triangle meshes: those of graphics data, and unit shapes that are scaled and moved to where an item is."""

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
    """Points, triangles and what belongs to them; without normals, triangles are flat. Never changed when made."""

    points: FloatArray  # n x 3
    triangles: IntArray  # m x 3
    normals: FloatArray | None = None  # n x 3
    colors: FloatArray | None = None  # n x 4; None: the instance says it
    edges: IntArray = field(default_factory=lambda: np.empty((0, 2), int))  # pairs of points
    edge_color: Rgba = (0.2, 0.2, 0.2, 1.0)


def rows(values: npt.ArrayLike, columns: int, kind: Any = float) -> npt.NDArray[Any]:
    """Return values as an array with so many columns."""
    return np.asarray(values, dtype=kind).reshape(-1, columns)


def grid_triangles(rows: int, columns: int) -> IntArray:
    """Return the triangles between rows of points, numbered row by row."""
    index = np.arange(rows * columns).reshape(rows, columns)
    a, b, c, d = (part.ravel() for part in (index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]))
    return np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])


def joined(*meshes: Mesh) -> Mesh:
    """Return one mesh of several; all of them have normals, or none of them."""
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
    return Mesh(np.concatenate(points), np.concatenate(triangles), np.concatenate(normals))


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
    return Mesh(points, grid_triangles(tiles + 1, 2 * tiles + 1), points)


@lru_cache(maxsize=64)
def torus(minor: float, tiles: int, angle: float = 2 * np.pi) -> Mesh:
    """Return a torus about z of major radius 1, or a part of it."""
    angles = np.linspace(0, angle, 3 * tiles + 1)
    return swept(np.stack([np.cos(angles), np.sin(angles), np.zeros_like(angles)], 1), minor, tiles)


@lru_cache(maxsize=256)
def helix(slenderness: float, windings: int, wire: float, tiles: int) -> Mesh:
    """Return a spring about z from 0 to 1, its ends on the axis, of radius 1; wire is the radius of its wire.

    `slenderness`, length by radius, is that at which the wire is round.
    """
    s = np.linspace(0, 1, 16 * windings + 1)
    radius = np.minimum(1, np.minimum(s, 1 - s) / 0.08)
    z = np.clip((s - 0.1) / 0.8, 0, 1) * 0.8 + 0.1
    z = np.where(s < 0.1, s, np.where(s > 0.9, s, z))
    angle = 2 * np.pi * windings * s
    line = np.stack([radius * np.cos(angle), radius * np.sin(angle), slenderness * z], 1)
    mesh = swept(line, wire, tiles)
    stretch = np.array([1, 1, 1 / slenderness])
    assert mesh.normals is not None
    return Mesh(mesh.points * stretch, mesh.triangles, mesh.normals / stretch)
