"""Tendons of robots: lengths that are sums of joint coordinates, with springs, dampers and limits."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from dalembert import itemInterface as items
from dalembert import laws
from dalembert._checks import FloatArray, as_number, as_vector, shape_error
from dalembert.robotics._parts import REGULAR_VELOCITY

if TYPE_CHECKING:
    from dalembert.robotics._robot import Robot


@dataclass
class RobotTendon:
    """A tendon with the length sum(factor * q) of joints and their factors.

    Its spring has no force between the lengths of restLength. Damping, dry friction and inertia belong to the rate of
    the length; lengths out of limits are pushed back by elastic stops, see Robot.CreateKinematicTree.
    """

    name: str
    joints: Mapping[str, float]
    stiffness: float = 0.0
    restLength: Sequence[float] = (0.0, 0.0)
    damping: float = 0.0
    friction: float = 0.0
    inertia: float = 0.0
    limits: Sequence[float] | None = None

    def __post_init__(self) -> None:
        where = f"RobotTendon '{self.name}'"
        for what in ("stiffness", "damping", "friction", "inertia"):
            as_number(f"{where}: {what}", getattr(self, what), negative=False)
        for what in ("restLength", "limits"):
            given = getattr(self, what)
            if given is not None and np.diff(as_vector(f"{where}: {what}", given, 2))[0] < 0:
                raise shape_error(f"{where}: {what}", "[lower, upper] with lower <= upper", given)

    def Factors(self, robot: Robot) -> FloatArray:
        """Return one factor per joint of the robot."""
        factors = np.zeros(robot.NumberOfLinks())
        for joint, factor in self.joints.items():
            factors[robot.GetJointIndex(joint)] += as_number(f"RobotTendon '{self.name}': joints", factor)
        return factors

    def Tension(self, length: Any, rate: Any, stops: tuple[float, float] = (0.0, 0.0)) -> Any:
        """Return the force against growing lengths; arrays as well. stops are stiffness and damping at the limits."""
        tension = beyond(length, self.restLength, self.stiffness) + self.damping * rate
        if self.friction:
            tension += self.friction * laws.maximum(laws.minimum(rate / REGULAR_VELOCITY, 1.0), -1.0)
        if self.limits is not None and any(stops):
            lower, upper = self.limits
            push = stops[0] * (length - upper) + stops[1] * rate
            tension += laws.where(length > upper, laws.maximum(push, 0.0), 0.0)
            push = stops[0] * (length - lower) + stops[1] * rate
            tension += laws.where(length < lower, laws.minimum(push, 0.0), 0.0)
        return tension


def beyond(length: Any, rest: Sequence[float], stiffness: float) -> Any:
    """Return the force of a spring without force between two lengths."""
    lower, upper = rest
    if lower == upper:
        return stiffness * (length - lower)
    return stiffness * (laws.maximum(length - upper, 0.0) + laws.minimum(length - lower, 0.0))


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

    law = laws.forces_of_coordinates(forces, len(factors), constants)
    view = items.VObjectGenericODE2(show=False)
    mass: Any = {"massMatrix": inertia * np.outer(factors, factors)} if inertia else {}
    return mbs.AddObject(items.ObjectGenericODE2(nodeNumbers=[node], forceUserFunction=law, visualization=view, **mass))


def add(robot: Robot, mbs: Any, node: Any, stops: tuple[float, float]) -> dict[str, Any]:
    """Add the tendons with their own forces or inertia; return their objects by name."""
    added = {}
    for name, tendon in robot.tendons.items():
        limited = tendon.limits is not None and any(stops)
        if tendon.stiffness or tendon.damping or tendon.friction or tendon.inertia or limited:

            def tension(length: Any, rate: Any, t: Any, tendon: RobotTendon = tendon) -> Any:
                return tendon.Tension(length, rate, stops)

            added[name] = add_force(robot, mbs, node, tendon.Factors(robot), tension, {}, tendon.inertia)
    return added
