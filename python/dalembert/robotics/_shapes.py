"""Shapes of links in files of robots: how they are drawn, and their inertia where a file gives none."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from dalembert import graphics
from dalembert._checks import FloatArray
from dalembert._geometry.inertia import InertiaCuboid, InertiaCylinder, InertiaSphere, RigidBodyInertia
from dalembert.graphics._import import _mass_properties, _read_facets
from dalembert.robotics._parts import GraphicsList


class Shape(NamedTuple):
    """A shape about the origin: its kind, with sizes as fields of `size` say, or the corners of triangles of a mesh.

    box: three sides; sphere: radius; ellipsoid: three radii; cylinder, capsule: radius and length along z.
    """

    kind: str
    size: tuple[float, ...] = ()
    corners: FloatArray | None = None


def mesh(path: Path, scale: FloatArray) -> Shape:
    """Return the mesh of a file: STL, or what PyMeshLab reads."""
    if path.suffix.lower() == ".stl":
        corners = _read_facets(str(path))[1]
    else:
        points, triangles = graphics.ToPointsAndTrigs(graphics.FromPyMeshlabFile(str(path)))
        corners = np.asarray(points, dtype=float)[np.asarray(triangles)]
    corners = corners * scale
    return Shape("mesh", corners=corners if scale.prod() > 0 else corners[:, ::-1])


def drawn(shape: Shape, color: Sequence[float]) -> GraphicsList:
    """Return the graphics of a shape."""
    rgba = list(color)
    match shape.kind, shape.size:
        case "mesh", _:
            assert shape.corners is not None
            index = np.arange(3 * len(shape.corners)).reshape(-1, 3)
            return [graphics.FromPointsAndTrigs(shape.corners.reshape(-1, 3), index, rgba)]
        case "box", sides:
            return [graphics.Brick([0, 0, 0], sides, rgba)]
        case "sphere", (radius,):
            return [graphics.Sphere([0, 0, 0], radius, rgba, nTiles=12)]
        case "ellipsoid", radii:
            points, triangles = graphics.ToPointsAndTrigs(graphics.Sphere([0, 0, 0], 1.0, rgba, nTiles=12))
            return [graphics.FromPointsAndTrigs(np.asarray(points) * radii, triangles, rgba)]
        case kind, (radius, length):
            ends = [graphics.Sphere([0, 0, z], radius, rgba, nTiles=12) for z in (-length / 2, length / 2)]
            bar = graphics.Cylinder([0, 0, -length / 2], [0, 0, length], radius, rgba)
            return [bar, *ends] if kind == "capsule" else [bar]
    raise ValueError(f"unknown shape {shape.kind}")


def _capsule(density: float, radius: float, length: float) -> RigidBodyInertia:
    """A cylinder between two halves of a ball, whose centres are 3/8 of the radius beyond its ends."""
    ball = InertiaSphere(radius=radius, density=density)
    middle = length / 2 + 3 / 8 * radius
    across = ball.inertiaTensor[0, 0] + ball.mass * (middle**2 - (3 / 8 * radius) ** 2)
    ends = RigidBodyInertia(ball.mass, np.diag([across, across, ball.inertiaTensor[2, 2]]))
    return InertiaCylinder(density, length, radius, axis=2) + ends


def inertia(shape: Shape, density: float) -> RigidBodyInertia:
    """Return the inertia of a homogeneous shape about the origin."""
    match shape.kind, shape.size:
        case "mesh", _:
            assert shape.corners is not None
            found = _mass_properties(shape.corners, density)
            return RigidBodyInertia(found["mass"], found["inertia"], found["COM"], inertiaTensorAtCOM=True)
        case "box", sides:
            return InertiaCuboid(density, sides)
        case "sphere", (radius,):
            return InertiaSphere(radius=radius, density=density)
        case "ellipsoid", radii:
            mass, squares = float(density * 4 / 3 * np.pi * np.prod(radii)), np.square(radii)
            return RigidBodyInertia(mass, np.diag(mass / 5 * (squares.sum() - squares)))
        case "capsule", (radius, length):
            return _capsule(density, radius, length)
        case _, (radius, length):
            return InertiaCylinder(density, length, radius, axis=2)
    raise ValueError(f"unknown shape {shape.kind}")
