"""Create functions of rigid bodies in the shape of a box, a cylinder or a sphere, with the inertia of this shape."""

from __future__ import annotations

from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._core import MainSystem, ObjectIndex
from dalembert.create._arguments import (
    DEFAULT_COLOR,
    POSITIVE,
    ZERO3,
    Check,
    Vector,
    argument_error,
    vector,
)
from dalembert.create.bodies import CHECKS as BODIES
from dalembert.create.bodies import CreateRigidBody
from dalembert.rigidBodyUtilities import InertiaCuboid, InertiaCylinder, InertiaSphere, RigidBodyInertia


def _density(function: str, density: float | None, mass: float | None, volume: float) -> float:
    """Return the density (kg/m^3) from one of density and mass."""
    if (density is None) == (mass is None):
        raise argument_error(function, "density", "density or mass, one of them", density)
    return float(density) if density is not None else float(mass or 0) / volume


def CreateBox(
    mbs: MainSystem,
    name: str = "",
    size: Vector = [1, 1, 1],
    density: float | None = None,
    mass: float | None = None,
    referencePosition: Vector = ZERO3,
    referenceRotationMatrix: FloatArray = np.eye(3),
    initialVelocity: Vector = ZERO3,
    initialAngularVelocity: Vector = ZERO3,
    gravity: Vector = ZERO3,
    color: Vector = DEFAULT_COLOR,
    show: bool = True,
    create2D: bool = False,
) -> ObjectIndex:
    """Add a homogeneous box, a rigid body, and its weight if there is gravity; return the ObjectIndex.

    The size (m) is along x, y and z of the body, whose frame is in the middle of the box. Without a color, it
    has one of eight, by its number.
    """
    if min(size) <= 0:
        raise argument_error("CreateBox", "size", "a vector with 3 components greater than zero", size)
    x, y, z = (float(length) for length in size)
    inertia = InertiaCuboid(_density("CreateBox", density, mass, x * y * z), [x, y, z])
    return _add("CreateBox", mbs, inertia, **_common(locals()))


def CreateCylinder(
    mbs: MainSystem,
    name: str = "",
    radius: float = 0.5,
    length: float = 1.0,
    axis: Vector = [0, 0, 1],
    innerRadius: float = 0.0,
    density: float | None = None,
    mass: float | None = None,
    referencePosition: Vector = ZERO3,
    referenceRotationMatrix: FloatArray = np.eye(3),
    initialVelocity: Vector = ZERO3,
    initialAngularVelocity: Vector = ZERO3,
    gravity: Vector = ZERO3,
    color: Vector = DEFAULT_COLOR,
    show: bool = True,
    create2D: bool = False,
) -> ObjectIndex:
    """Add a homogeneous cylinder or tube, a rigid body, and its weight if there is gravity; return the ObjectIndex.

    The axis is x, y or z of the body, whose frame is in the middle of the cylinder. innerRadius > 0 makes it a tube.
    """
    along = np.flatnonzero(axis)
    if len(along) != 1:
        expected = "an axis of the body: [1, 0, 0], [0, 1, 0] or [0, 0, 1]; referenceRotationMatrix rotates the body"
        raise argument_error("CreateCylinder", "axis", expected, axis)
    if not 0 <= innerRadius < radius:
        raise argument_error("CreateCylinder", "innerRadius", f"a radius from 0 to less than {radius:g}", innerRadius)
    volume = np.pi * (radius**2 - innerRadius**2) * length
    rho = _density("CreateCylinder", density, mass, volume)
    inertia = InertiaCylinder(rho, length, radius, axis=int(along[0]), innerRadius=innerRadius)
    return _add("CreateCylinder", mbs, inertia, **_common(locals()))


def CreateSphere(
    mbs: MainSystem,
    name: str = "",
    radius: float = 0.5,
    density: float | None = None,
    mass: float | None = None,
    referencePosition: Vector = ZERO3,
    referenceRotationMatrix: FloatArray = np.eye(3),
    initialVelocity: Vector = ZERO3,
    initialAngularVelocity: Vector = ZERO3,
    gravity: Vector = ZERO3,
    color: Vector = DEFAULT_COLOR,
    show: bool = True,
    create2D: bool = False,
) -> ObjectIndex:
    """Add a homogeneous sphere, a rigid body, and its weight if there is gravity; return the ObjectIndex."""
    rho = _density("CreateSphere", density, mass, 4 / 3 * np.pi * radius**3)
    return _add("CreateSphere", mbs, InertiaSphere(radius=radius, density=rho), **_common(locals()))


_COMMON = (
    *("name", "referencePosition", "referenceRotationMatrix", "initialVelocity", "initialAngularVelocity", "gravity"),
    *("color", "show", "create2D"),
)


def _common(arguments: dict[str, Any]) -> dict[str, Any]:
    return {name: arguments[name] for name in _COMMON}


# Colors of bodies without a color of their own, by their numbers.
COLORS = (
    (0.31, 0.47, 0.65), (0.95, 0.56, 0.17), (0.35, 0.63, 0.31), (0.88, 0.34, 0.35),
    (0.46, 0.72, 0.70), (0.93, 0.79, 0.28), (0.69, 0.48, 0.63), (0.61, 0.46, 0.37),
)  # fmt: skip


def _add(function: str, mbs: MainSystem, inertia: RigidBodyInertia, **arguments: Any) -> ObjectIndex:
    if np.array_equal(arguments["color"], DEFAULT_COLOR):
        arguments["color"] = [*COLORS[mbs.systemData.NumberOfObjects() % len(COLORS)], 1.0]
    try:
        index: ObjectIndex = CreateRigidBody(mbs, inertia=inertia, **arguments)
    except ValueError as error:
        raise ValueError(str(error).replace("CreateRigidBody", function)) from None
    return index


_AMOUNT = {"density": "density (kg/m^3), unless the mass is given", "mass": "mass (kg), unless the density is given"}
TEXTS = {
    "CreateBox": {**_AMOUNT, "size": "lengths of the sides along x, y and z of the body (m)"},
    "CreateCylinder": {
        **_AMOUNT,
        "radius": "radius (m)",
        "length": "length along the axis (m)",
        "axis": "axis of the cylinder in the frame of the body: x, y or z",
        "innerRadius": "radius of the bore of a tube (m)",
    },
    "CreateSphere": {**_AMOUNT, "radius": "radius (m)"},
}
_SHAPE: dict[str, Check] = {
    **{name: check for name, check in BODIES["CreateRigidBody"].items() if name in _COMMON},
    "density": POSITIVE.optional(),
    "mass": POSITIVE.optional(),
}
# Requirements on arguments besides those of the mirrored item and COMMON.
CHECKS: dict[str, dict[str, Check]] = {
    "CreateBox": {**_SHAPE, "size": vector(3)},
    "CreateCylinder": {**_SHAPE, "radius": POSITIVE, "length": POSITIVE, "axis": vector(3)},
    "CreateSphere": {**_SHAPE, "radius": POSITIVE},
}
