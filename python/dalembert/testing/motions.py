"""Motions of frames, and the coordinates of each node type for a given motion; the specs say of which frame they
are."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from dalembert._tools.item_packages import item_class
from dalembert.testing.specs import ITEMS

Array = NDArray[np.float64]
EZ = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True)
class Place:
    """A rigid displacement of a whole model: turn about the origin, then shift."""

    turn: Array = field(default_factory=lambda: np.eye(3))
    shift: Array = field(default_factory=lambda: np.zeros(3))

    def point(self, x: Any) -> Array:
        return self.turn @ np.asarray(x) + self.shift


@dataclass(frozen=True)
class Motion:
    """A frame in motion; all vectors in global axes."""

    position: Array
    rotation: Array
    velocity: Array
    angular_velocity: Array
    acceleration: Array
    angular_acceleration: Array

    def at(self, place: Place) -> Motion:
        q = place.turn
        vectors = (self.velocity, self.angular_velocity, self.acceleration, self.angular_acceleration)
        return Motion(place.point(self.position), q @ self.rotation, *(q @ v for v in vectors))

    def at_rest(self) -> Motion:
        return Motion(self.position, self.rotation, *(np.zeros(3) for _ in range(4)))

    def point(self, local: Any) -> Array:
        return self.position + self.rotation @ np.asarray(local)


def random_rotation(rng: np.random.Generator, planar: bool = False) -> Array:
    """Planar: about z. The angle stays well below pi, where rotation vectors and angles are regular."""
    axis = EZ if planar else rng.normal(size=3)
    return Rotation.from_rotvec(axis / np.linalg.norm(axis) * rng.uniform(0.2, 1.2)).as_matrix()


def random_motion(rng: np.random.Generator, planar: bool = False) -> Motion:
    plane, axis = (np.array([1.0, 1, 0]), EZ) if planar else (np.ones(3), np.ones(3))
    vectors = rng.normal(size=(5, 3))
    rotation = random_rotation(rng, planar)
    position, velocity, acceleration = vectors[:3] * plane
    return Motion(position, rotation, velocity, vectors[3] * axis, acceleration, vectors[4] * axis)


def quaternion(rotation: Array) -> Array:
    """Euler parameters, the scalar first and positive."""
    q = Rotation.from_matrix(rotation).as_quat()[[3, 0, 1, 2]]
    return q if q[0] >= 0 else -q


def times(p: Array, vector: Array) -> Array:
    """Quaternion p times the quaternion of a vector."""
    return np.array([-p[1:] @ vector, *(p[0] * vector + np.cross(p[1:], vector))])


def tait_bryan(rotation: Array) -> Array:
    """Angles of successive rotations about x, y and z of the turned frame."""
    return Rotation.from_matrix(rotation).as_euler("XYZ")


def tait_bryan_axes(rotation: Array) -> Array:
    """Global axes of the three rotations as columns."""
    angles = tait_bryan(rotation)
    first = Rotation.from_euler("X", angles[0]).as_matrix()
    second = first @ Rotation.from_euler("Y", angles[1]).as_matrix()
    return np.column_stack([[1.0, 0, 0], first[:, 1], second[:, 2]])


# Slope vectors of nodes that have some, in the axes of the node: neither of unit length nor normal to each other.
SLOPES = {
    "slope": np.array([[1.25, 0, 0]]),
    "slopes12": np.array([[1.2, 0, 0], [0.2, 0.9, 0]]),
    "slopes23": np.array([[0, 1.1, 0.2], [0, 0, 0.9]]),
}


class NodeKind:
    """`twists`: rates of the coordinates for the six unit twists (velocity, angular velocity) of the node's frame; its
    transpose turns residuals into global forces and moments. `others`: directions that do not turn with a model."""

    def __init__(self, name: str, frame: str, planar: bool = False, resting: bool = False) -> None:
        self.name, self.frame, self.planar, self.resting = name, frame, planar, resting

    def total(self, m: Motion) -> Array:
        position = m.position[:2] if self.planar else m.position
        angle = np.arctan2(m.rotation[1, 0], m.rotation[0, 0]) % (
            2 * np.pi
        )  # turns about z are positive: none passes 0
        rotation = {
            "ep": lambda: quaternion(m.rotation),
            "rxyz": lambda: tait_bryan(m.rotation),
            "rotation_vector": lambda: Rotation.from_matrix(m.rotation).as_rotvec(),
            "angle": lambda: [angle],
            "point": list,
        }
        slopes = [m.rotation @ slope for slope in SLOPES.get(self.frame, ())]
        return np.concatenate([position, self._flat(slopes) if slopes else rotation[self.frame]()])

    def _flat(self, vectors: list[Array]) -> Array:
        """Return coordinates in order, without those that are zero in the plane."""
        return np.concatenate([v[:2] if self.planar else v for v in vectors])

    def twists(self, m: Motion) -> Array:
        columns = [np.concatenate([e[:2] if self.planar else e, self._turning(m, np.zeros(3))]) for e in np.eye(3)]
        zeros = np.zeros(2 if self.planar else 3)
        return np.column_stack(columns + [np.concatenate([zeros, self._turning(m, e)]) for e in np.eye(3)])

    def _turning(self, m: Motion, omega: Array) -> Array:
        """Rates of the rotation coordinates at an angular velocity."""
        rates = {
            "ep": lambda: 0.5 * times(quaternion(m.rotation), m.rotation.T @ omega),
            "rxyz": lambda: np.linalg.solve(tait_bryan_axes(m.rotation), omega),
            "rotation_vector": lambda: m.rotation.T @ omega,
            "angle": lambda: omega[2:],
            "point": list,
        }
        slopes = [np.cross(omega, m.rotation @ slope) for slope in SLOPES.get(self.frame, ())]
        return self._flat(slopes) if slopes else np.asarray(rates[self.frame]())

    def velocities(self, m: Motion) -> Array:
        return self.twists(m) @ np.concatenate([m.velocity, m.angular_velocity])

    def accelerations(self, m: Motion) -> Array:
        a = self.twists(m) @ np.concatenate([m.acceleration, m.angular_acceleration])
        if self.frame == "ep":
            p_t = self._turning(m, m.angular_velocity)
            a[3:] += 0.5 * times(p_t, m.rotation.T @ m.angular_velocity)
        elif self.frame == "rxyz":
            axes, omega = tait_bryan_axes(m.rotation), np.zeros(3)
            for axis, rate in zip(axes.T, self._turning(m, m.angular_velocity), strict=True):
                a[3:] -= np.linalg.solve(axes, rate * np.cross(omega, axis))
                omega = omega + rate * axis
        elif self.frame in SLOPES:
            turning = [np.cross(m.angular_velocity, m.rotation @ slope) for slope in SLOPES[self.frame]]
            swing = self._flat([np.cross(m.angular_velocity, rate) for rate in turning])
            a[-len(swing) :] += swing
        return a

    def others(self, m: Motion) -> Array:
        """Slope vectors that lengthen or lean towards each other."""
        slopes = [m.rotation @ slope for slope in SLOPES.get(self.frame, ())]
        still = [np.zeros(3)] * (len(slopes) + 1)
        columns = [
            self._flat([*still[: i + 1], slopes[j], *still[i + 2 :]]) for i in range(len(slopes)) for j in range(i + 1)
        ]
        return np.array(columns).T if columns else np.zeros((len(self.total(m)), 0))

    def item(self, reference: Motion, m: Motion) -> Any:
        start = self.total(reference)
        made = {"referenceCoordinates": start}
        if not self.resting:
            made |= {"initialCoordinates": self.total(m) - start, "initialVelocities": self.velocities(m)}
        return item_class(self.name)(**made)


KINDS = {
    item.name: NodeKind(
        item.name, item.scene.frame, planar="Position2D" in item.provides and not grounded, resting=grounded
    )
    for item in ITEMS.values()
    if item.ready and item.scene.frame
    for grounded in ["Ground" in item.provides]
}
