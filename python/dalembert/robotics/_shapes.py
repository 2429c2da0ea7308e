"""Shapes of links in robot files: their graphics, and their inertia if the file has none."""

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
    """Return the mesh of a file: STL, OBJ, or a format of PyMeshLab."""
    if path.suffix.lower() == ".stl":
        corners = _read_facets(str(path))[1]
    elif path.suffix.lower() == ".obj":
        corners = _read_obj(path)
    else:
        points, triangles = graphics.ToPointsAndTrigs(graphics.FromPyMeshlabFile(str(path)))
        corners = np.asarray(points, dtype=float)[np.asarray(triangles)]
    corners = corners * scale
    return Shape("mesh", corners=corners if scale.prod() > 0 else corners[:, ::-1])


def _read_obj(path: Path) -> FloatArray:
    """Return the corners of the triangles of an OBJ file; faces with more corners are cut into triangles."""
    points: list[list[float]] = []
    triangles: list[list[int]] = []
    for line in path.read_text(errors="replace").replace("\\\n", " ").splitlines():
        kind, *words = line.split() or [""]
        if kind == "v":
            points.append([float(word) for word in words[:3]])
        elif kind == "f":
            numbers = [int(word.split("/")[0]) for word in words]
            face = [number - 1 if number > 0 else len(points) + number for number in numbers]
            triangles += [[face[0], face[i], face[i + 1]] for i in range(1, len(face) - 1)]
    if not triangles:
        raise ValueError(f"{path}: expected faces (lines that begin with f) in this OBJ file")
    return np.array(points)[np.array(triangles)]


def volumes(corners: FloatArray) -> tuple[float, float]:
    """Return the volume of a mesh, and the sum of absolute volumes between its facets and the middle of these."""
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    middle = (areas[:, None] * corners.mean(axis=1)).sum(axis=0) / areas.sum()
    each = np.linalg.det(corners - middle) / 6
    return float(abs(each.sum())), float(np.abs(each).sum())


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


def shell_inertia(shape: Shape, density: float) -> RigidBodyInertia | None:
    """Return the inertia of the surface of a shape about the origin, for kg/m^2; None for ellipsoids and meshes."""
    match shape.kind, shape.size:
        case "box", sides:
            a = np.array(sides)
            areas = 2 * a.prod() / a  # areas of both faces normal to each axis
            squares = a**2 * (areas / 4 + (areas.sum() - areas) / 12)  # integrals of x^2, y^2 and z^2
            return RigidBodyInertia(float(density * areas.sum()), density * np.diag(squares.sum() - squares))
        case "sphere", (r,):
            mass = 4 * np.pi * r**2 * density
            return RigidBodyInertia(mass, 2 / 3 * mass * r**2 * np.eye(3))
        case ("cylinder" | "capsule") as kind, (r, length):
            side = 2 * np.pi * r * length * density
            across, along = side * (r**2 / 2 + length**2 / 12), side * r**2
            ends = (2 if kind == "cylinder" else 4) * np.pi * r**2 * density
            if kind == "cylinder":  # two discs
                across, along = across + ends * (r**2 + length**2) / 4, along + ends * r**2 / 2
            else:  # two half spheres, whose centres of mass are half of the radius beyond the ends
                across += ends * (5 / 12 * r**2 + (length + r) ** 2 / 4)
                along += 2 / 3 * ends * r**2
            return RigidBodyInertia(side + ends, np.diag([across, across, along]))
    return None


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
