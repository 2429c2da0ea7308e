"""Equations of motion of a robot by recursion over its links, for one state or many.

Coordinates, rates and accelerations are arrays whose last axis counts the joints; the axes before it count states.
The recursion is that of J. Y. S. Luh, M. W. Walker, R. P. C. Paul, On-line computational scheme for mechanical
manipulators, J. Dynamic Systems, Measurement, and Control 102, 1980, with all vectors in the global frame: outwards for
velocities and accelerations, inwards for forces. Gravity is an acceleration of the base.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from dalembert._checks import FloatArray
from dalembert.robotics._parts import JOINT_AXES, RobotLink, is_revolute


def joint_transformation(jointType: str, q: FloatArray) -> FloatArray:
    """Return the 4x4 transformations of a joint with coordinates q, stacked as these are."""
    T = np.zeros((*np.shape(q), 4, 4))
    T[..., range(4), range(4)] = 1.0
    axis = "xyz".index(jointType[1])
    if not is_revolute(jointType):
        T[..., axis, 3] = q
        return T
    first, second = (axis + 1) % 3, (axis + 2) % 3
    T[..., first, first] = T[..., second, second] = np.cos(q)
    T[..., second, first] = np.sin(q)
    T[..., first, second] = -T[..., second, first]
    return T


def joint_axis(link: RobotLink, T: FloatArray) -> FloatArray:
    """Return the axis of a joint in the global frame, from the transformation of the joint."""
    return np.asarray(T[..., :3, :3] @ JOINT_AXES[link.jointType])


_NEXT, _LAST = [1, 2, 0], [2, 0, 1]


def cross(a: Any, b: Any) -> FloatArray:
    """Return the vector products along the last axis; several times faster than numpy's for single vectors."""
    return np.asarray(a[..., _NEXT] * b[..., _LAST] - a[..., _LAST] * b[..., _NEXT])


def dot(a: FloatArray, b: FloatArray) -> FloatArray:
    """Return the products of vectors along the last axis."""
    return np.asarray((a * b).sum(axis=-1))


class Places(NamedTuple):
    """A link in the global frame: origin of its joint, centre of mass from there, axis, tensor about the centre."""

    position: FloatArray
    com: FloatArray
    axis: FloatArray
    inertia: FloatArray


def places(links: Sequence[RobotLink], jointHT: Sequence[FloatArray]) -> list[Places]:
    """Return where all links are, from the transformations of their joints."""
    result = []
    for link, T in zip(links, jointHT, strict=True):
        com = link.localHT[:3, :3] @ link.COM + link.localHT[:3, 3]
        A = T[..., :3, :3] @ link.localHT[:3, :3]
        inertia = A @ link.inertia @ np.swapaxes(A, -1, -2)
        result.append(Places(T[..., :3, 3], T[..., :3, :3] @ com, joint_axis(link, T), inertia))
    return result


class Motion(NamedTuple):
    """Velocity and acceleration of the origin of a joint, with what turns around it."""

    velocity: Any
    acceleration: Any
    angularVelocity: Any
    angularAcceleration: Any


def motions(
    links: Sequence[RobotLink], at: Sequence[Places], q_t: FloatArray, q_tt: FloatArray, base: Motion
) -> list[Motion]:
    """Return the motions of all links, outwards from the base."""
    result: list[Motion] = []
    for i, (link, place) in enumerate(zip(links, at, strict=True)):
        parent, r = base, np.zeros(3)
        if isinstance(link.parent, int) and link.parent >= 0:
            parent, r = result[link.parent], place.position - at[link.parent].position
        omega, alpha = parent.angularVelocity, parent.angularAcceleration
        v = parent.velocity + cross(omega, r)
        a = parent.acceleration + cross(alpha, r) + cross(omega, cross(omega, r))
        rate, second = place.axis * q_t[..., i, None], place.axis * q_tt[..., i, None]
        if is_revolute(link.jointType):
            alpha = alpha + second + cross(omega, rate)
            omega = omega + rate
        else:
            v = v + rate
            a = a + second + 2.0 * cross(omega, rate)
        result.append(Motion(v, a, omega, alpha))
    return result


def inverse_dynamics(
    links: Sequence[RobotLink], jointHT: Sequence[FloatArray], q_t: FloatArray, q_tt: FloatArray, gravity: FloatArray
) -> FloatArray:
    """Return the forces and torques in the joints that belong to a motion of the rigid links."""
    none = np.zeros(3)
    at = places(links, jointHT)
    moving = motions(links, at, q_t, q_tt, Motion(none, -gravity, none, none))
    forces: list[Any] = [none] * len(links)  # from the parent on the link, and its moment about the joint
    moments: list[Any] = [none] * len(links)
    torques = np.empty(np.broadcast_shapes(q_t.shape, q_tt.shape, (*jointHT[0].shape[:-2], len(links))))
    for i in reversed(range(len(links))):
        link, place, move = links[i], at[i], moving[i]
        omega, alpha = move.angularVelocity, move.angularAcceleration
        spun = cross(omega, cross(omega, place.com))
        F = link.mass * (move.acceleration + cross(alpha, place.com) + spun)
        turning = (place.inertia @ omega[..., None])[..., 0]
        N = (place.inertia @ alpha[..., None])[..., 0] + cross(omega, turning)
        forces[i] = forces[i] + F
        moments[i] = moments[i] + N + cross(place.com, F)
        torques[..., i] = dot(place.axis, moments[i] if is_revolute(link.jointType) else forces[i])
        if isinstance(link.parent, int) and link.parent >= 0:
            arm = place.position - at[link.parent].position
            forces[link.parent] = forces[link.parent] + forces[i]
            moments[link.parent] = moments[link.parent] + moments[i] + cross(arm, forces[i])
    return torques


def energies(
    links: Sequence[RobotLink], jointHT: Sequence[FloatArray], q_t: FloatArray, gravity: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return kinetic energy, and potential energy with its zero at the global origin."""
    none = np.zeros(3)
    at = places(links, jointHT)
    moving = motions(links, at, q_t, np.zeros_like(q_t), Motion(none, none, none, none))
    kinetic, potential = np.zeros(q_t.shape[:-1]), np.zeros(q_t.shape[:-1])
    for link, place, move in zip(links, at, moving, strict=True):
        omega = move.angularVelocity
        velocity = move.velocity + cross(omega, place.com)
        turning = (place.inertia @ omega[..., None])[..., 0]
        kinetic = kinetic + 0.5 * (link.mass * dot(velocity, velocity) + dot(omega, turning))
        potential = potential - link.mass * dot(place.position + place.com, gravity)
    return kinetic, potential
