"""Tendons of robots: sums of joint coordinates, or distances, with springs, dampers and limits."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

import dalembert
from dalembert import itemInterface as items
from dalembert._checks import FloatArray, as_number, as_vector, shape_error
from dalembert.robotics._parts import REGULAR_VELOCITY

if TYPE_CHECKING:
    from dalembert.robotics._robot import Robot


# From a link, -1 for the base, and a transformation in it, to a marker and the rotation from the marker's axes.
AddMarker = Callable[[int, FloatArray], tuple[Any, FloatArray]]


@dataclass
class _Elastic:
    """The law of a tendon: force against growing lengths."""

    name: str
    stiffness: float = field(default=0.0, kw_only=True)
    restLength: Sequence[float] = field(default=(0.0, 0.0), kw_only=True)
    damping: float = field(default=0.0, kw_only=True)
    friction: float = field(default=0.0, kw_only=True)
    limits: Sequence[float] | None = field(default=None, kw_only=True)

    def __post_init__(self) -> None:
        where = f"{type(self).__name__} '{self.name}'"
        for what in ("stiffness", "damping", "friction"):
            as_number(f"{where}: {what}", getattr(self, what), negative=False)
        for what in ("restLength", "limits"):
            given = getattr(self, what)
            if given is not None and np.diff(as_vector(f"{where}: {what}", given, 2))[0] < 0:
                raise shape_error(f"{where}: {what}", "[lower, upper] with lower <= upper", given)

    def HasForce(self, stops: tuple[float, float]) -> bool:
        """Return whether there can be a force, with these stiffness and damping of stops."""
        limited = self.limits is not None and any(stops)
        return bool(self.stiffness or self.damping or self.friction or limited)

    def Tension(self, length: Any, rate: Any, stops: tuple[float, float] = (0.0, 0.0)) -> Any:
        """Return the force against growing lengths; arrays as well. stops are stiffness and damping at the limits."""
        tension = beyond(length, self.restLength, self.stiffness) + self.damping * rate
        if self.friction:
            tension += self.friction * dalembert.laws.maximum(
                dalembert.laws.minimum(rate / REGULAR_VELOCITY, 1.0), -1.0
            )
        if self.limits is not None and any(stops):
            lower, upper = self.limits
            push = stops[0] * (length - upper) + stops[1] * rate
            tension += dalembert.laws.where(length > upper, dalembert.laws.maximum(push, 0.0), 0.0)
            push = stops[0] * (length - lower) + stops[1] * rate
            tension += dalembert.laws.where(length < lower, dalembert.laws.minimum(push, 0.0), 0.0)
        return tension


@dataclass
class RobotTendon(_Elastic):
    """A tendon with the length sum(factor * q) of joints and their factors.

    Its spring has no force between the lengths of restLength. Damping, dry friction and inertia belong to the rate of
    the length; lengths out of limits are pushed back by elastic stops, see Robot.CreateKinematicTree.
    """

    joints: Mapping[str, float]
    inertia: float = field(default=0.0, kw_only=True)

    def __post_init__(self) -> None:
        super().__post_init__()
        as_number(f"RobotTendon '{self.name}': inertia", self.inertia, negative=False)

    def Factors(self, robot: Robot) -> FloatArray:
        """Return one factor per joint of the robot."""
        factors = np.zeros(robot.NumberOfLinks())
        for joint, factor in self.joints.items():
            factors[robot.GetJointIndex(joint)] += as_number(f"RobotTendon '{self.name}': joints", factor)
        return factors


@dataclass
class RobotCable(_Elastic):
    """A tendon between two frames, names as in Robot.FrameHT, or '' for the base; its length is their distance.

    Spring, damping, friction and limits are as those of RobotTendon.
    """

    frame0: str
    frame1: str

    def Kinematics(self, robot: Robot, q: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return the length, and its derivatives by the coordinates."""
        frames, points, jacobians = robot.JointHT(q), [], []
        for frame in (self.frame0, self.frame1):
            link, T = place_of(robot, frame)
            carrier = robot.base.HT if link < 0 else frames[link] @ robot.links[link].localHT
            points.append(np.asarray(np.asarray(carrier) @ T)[..., :3, 3])
            still = np.zeros((*q.shape[:-1], 3, q.shape[-1]))
            jacobians.append(still if link < 0 else robot.Jacobian(frames, points[-1], "trans", link))
        apart = points[1] - points[0]
        length = np.linalg.norm(apart, axis=-1)
        direction = apart / np.where(length > 0, length, 1.0)[..., None]
        return length, np.einsum("...i,...ij->...j", direction, jacobians[1] - jacobians[0])


def place_of(robot: Robot, frame: str) -> tuple[int, FloatArray]:
    """Return the link that carries a frame, -1 for the base, and the transformation from the link to it."""
    if not frame:
        return -1, np.eye(4)
    return robot.FrameLink(frame), np.asarray(robot._frameLocalHT(frame))


def beyond(length: Any, rest: Sequence[float], stiffness: float) -> Any:
    """Return the force of a spring without force between two lengths."""
    lower, upper = rest
    if lower == upper:
        return stiffness * (length - lower)
    return stiffness * (dalembert.laws.maximum(length - upper, 0.0) + dalembert.laws.minimum(length - lower, 0.0))


def factors_of(robot: Robot, name: str) -> FloatArray:
    """Return the derivatives of the length of a tendon, or of the coordinate of a joint, by the coordinates."""
    if name in robot.tendons:
        return robot.tendons[name].Factors(robot)
    factors = np.zeros(robot.NumberOfLinks())
    factors[robot.GetJointIndex(name)] = 1.0
    return factors


def add_force(
    robot: Robot,
    mbs: Any,
    node: Any,
    factors: FloatArray,
    tension: Callable[..., Any],
    constants: dict[str, float],
    inertia: float = 0.0,
) -> Any:
    """Add an object with a force on the coordinates of a tree: tension(length, rate, t, **constants) against growing
    lengths."""
    offset = float(factors @ robot.referenceConfiguration)  # coordinates of nodes are relative to it
    acting = np.flatnonzero(factors)

    def forces(q: Any, q_t: Any, t: Any, **symbols: Any) -> list[Any]:
        length, rate = (sum(factors[i] * each[i] for i in acting) for each in (q, q_t))
        value = tension(length + offset, rate, t, **symbols)
        return [-float(factor) * value if factor else 0.0 for factor in factors]

    law = dalembert.laws.forces_of_coordinates(forces, len(factors), constants)
    view = items.VObjectGenericODE2(show=False)
    mass: Any = {"massMatrix": inertia * np.outer(factors, factors)} if inertia else {}
    return mbs.AddObject(items.ObjectGenericODE2(nodeNumbers=[node], forceUserFunction=law, visualization=view, **mass))


def add(robot: Robot, mbs: Any, node: Any, stops: tuple[float, float]) -> dict[str, Any]:
    """Add the tendons of a tree with their own forces or inertia; return their objects by name."""
    added = {}
    for name, tendon in robot.tendons.items():
        if tendon.HasForce(stops) or tendon.inertia:

            def tension(length: Any, rate: Any, t: Any, tendon: RobotTendon = tendon) -> Any:
                return tendon.Tension(length, rate, stops)

            added[name] = add_force(robot, mbs, node, tendon.Factors(robot), tension, {}, tendon.inertia)
    return added


def _tension(cable: RobotCable, stops: tuple[float, float]) -> Callable[..., Any]:
    def tension(L: Any, L_t: Any, t: Any) -> Any:
        return cable.Tension(L, L_t, stops)

    return tension


def add_cables(robot: Robot, mbs: Any, marker: AddMarker, stops: tuple[float, float]) -> dict[str, Any]:
    """Add the cables with forces; return their objects by name."""
    added = {}
    for name, cable in robot.cables.items():
        if not cable.HasForce(stops):
            continue

        made = dalembert.laws.connector("line")(_tension(cable, stops))
        ends = [marker(*place_of(robot, frame))[0] for frame in (cable.frame0, cable.frame1)]
        added[name] = mbs.AddObject(made(ends))
    return added
