"""Inertia of bodies of MJCF files: from <inertial>, from geoms, and the options of <compiler>."""

from __future__ import annotations

import numpy as np

from dalembert._checks import FloatArray
from dalembert._geometry.inertia import RigidBodyInertia
from dalembert.robotics import _shapes
from dalembert.robotics._description import Body, inertia_in_file
from dalembert.robotics._mjcf_compiler import Compiler
from dalembert.robotics._xml import Element


def of_geom(geom: Element, shape: _shapes.Shape) -> RigidBodyInertia:
    """Return the inertia of a geom from its mass or density; a shell has that of its surface."""

    def inertia(density: float) -> RigidBodyInertia:
        shell = _shapes.shell_inertia(shape, density) if is_shell(geom) else None
        return shell if shell is not None else _shapes.inertia(shape, density)

    if "mass" not in geom.attributes:
        return inertia(geom.amount("density", "1000"))
    return inertia(geom.amount("mass") / inertia(1.0).Mass())


def is_shell(geom: Element) -> bool:
    """Return whether the mass of a geom is on its surface."""
    return geom.text("shellinertia", "false") == "true"


def of_element(element: Element, compiler: Compiler) -> RigidBodyInertia:
    """Return the inertia of <inertial>; missing moments are zero."""
    if "fullinertia" in element.attributes:
        xx, yy, zz, xy, xz, yz = element.numbers("fullinertia", 6)
        tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    else:
        tensor = np.diag(element.numbers("diaginertia", 3, "0 0 0"))
    if compiler.balances:
        tensor = _balanced(tensor)
    return inertia_in_file(element, element.amount("mass"), tensor).Transformed(compiler.place(element))


def _balanced(tensor: FloatArray) -> FloatArray:
    """Return equal moments in the place of principal moments one of which is larger than the other two together."""
    moments = np.sort(np.linalg.eigvalsh(tensor))
    return np.eye(3) * moments.mean() if moments[0] + moments[1] < moments[2] else tensor


def finish(bodies: list[Body], compiler: Compiler) -> None:
    """Apply least masses and moments, and the total mass, to all bodies."""
    for body in bodies:
        own = compiler.of(body.where)
        if own.least_mass > 0 or own.least_inertia > 0:
            body.inertia = _at_least(body.inertia or RigidBodyInertia(), own)
    total = sum(body.inertia.Mass() for body in bodies if body.inertia is not None)
    if compiler.total_mass > 0 and total > 0:
        factor = compiler.total_mass / total
        for body in bodies:
            if body.inertia is not None:
                scaled = RigidBodyInertia()
                scaled.SetWithCOMinertia(
                    factor * body.inertia.Mass(), factor * body.inertia.InertiaCOM(), body.inertia.COM()
                )
                body.inertia = scaled


def _at_least(inertia: RigidBodyInertia, compiler: Compiler) -> RigidBodyInertia:
    moments, axes = np.linalg.eigh(inertia.InertiaCOM())
    tensor = axes @ np.diag(np.maximum(moments, compiler.least_inertia)) @ axes.T
    bounded = RigidBodyInertia()
    bounded.SetWithCOMinertia(max(inertia.Mass(), compiler.least_mass), tensor, inertia.COM())
    return bounded
