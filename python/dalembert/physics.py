"""Friction laws and equivalent stresses."""

from __future__ import annotations

from collections.abc import Sequence
from math import copysign, exp
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, as_array, shape_error


def StribeckFunction(
    vel: float,
    muDynamic: float,
    muStaticOffset: float,
    muViscous: float = 0,
    expVel: float = 1e-3,
    regVel: float = 1e-3,
) -> float:
    """Return the friction coefficient (or force) at a velocity: dynamic, plus a static offset that decays with expVel.

    Below regVel it is linear in the velocity; above, muViscous adds a linear part (Armstrong-Helouvry, Control of
    Machines with Friction, 1991).
    """
    speed = abs(vel)
    if speed <= regVel and regVel != 0:
        return (muDynamic + muStaticOffset) * vel / regVel
    if vel == 0:
        return 0.0
    beyond = speed - regVel
    return copysign(1.0, vel) * (muDynamic + muStaticOffset * exp(-beyond / expVel) + muViscous * beyond)


def RegularizedFrictionStep(x: float, x0: float, h0: float, x1: float, h1: float) -> float:
    """Return h0 below x0, h1 above x1, and the cubic step with horizontal ends between."""
    if x <= x0:
        return h0
    if x >= x1:
        return h1
    s = (x - x0) / (x1 - x0)
    return h0 + (h1 - h0) * s * s * (3 - 2 * s)


def RegularizedFriction(
    vel: float, muDynamic: float, muStaticOffset: float, velStatic: float, velDynamic: float, muViscous: float = 0
) -> float:
    """Return a smooth friction coefficient (or force): static at velStatic, dynamic at velDynamic, viscous above.

    The parts are joined by cubic steps (Qian, Zhang, Jin, Nonlinear Dynamics 2018, with the steps in ascending order).
    """
    speed, static = abs(vel), muDynamic + muStaticOffset
    if speed < velStatic:
        return RegularizedFrictionStep(vel, -velStatic, -static, velStatic, static)
    if speed <= velDynamic:
        size = RegularizedFrictionStep(speed, velStatic, static, velDynamic, muDynamic)
    else:
        size = muDynamic + (speed - velDynamic) * muViscous
    return copysign(size, vel) if vel != 0 else 0.0


def VonMisesStress(stress6D: npt.ArrayLike) -> np.float64 | FloatArray:
    """Return the von Mises stress of [Sxx, Syy, Szz, Syz, Sxz, Sxy], or of each row of an (n x 6) matrix."""
    s = as_array("VonMisesStress: stress6D", stress6D)
    if s.ndim not in (1, 2) or s.shape[-1] != 6:
        raise shape_error("VonMisesStress: stress6D", "6 stress components, or rows of them", stress6D)
    normal, shear = s[..., :3], s[..., 3:]
    differences = normal - np.roll(normal, 1, axis=-1)
    return np.sqrt(0.5 * np.sum(differences**2, axis=-1) + 3.0 * np.sum(shear**2, axis=-1))


def UFvonMisesStress(
    mbs: Any, t: float, sensorNumbers: Sequence[Any], factors: Sequence[float], configuration: Any
) -> list[float]:
    """Return [the largest von Mises stress] of sensors with 6 stress components, as user function of a sensor.

    A sensor with a single value is taken as a von Mises stress itself; the factors are not used.
    """
    largest = 0.0
    for sensor in sensorNumbers:
        values = np.atleast_1d(mbs.GetSensorValues(sensor, configuration))
        largest = max(largest, float(values[0] if values.size == 1 else VonMisesStress(values)))
    return [largest]
