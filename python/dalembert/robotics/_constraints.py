"""Constraints of robots in addition to their joints: loops that are closed, and couplings of joints."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

import dalembert
from dalembert import itemInterface as items
from dalembert._checks import as_number, as_transformation, as_vector
from dalembert.robotics._tendons import AddMarker, factors_of, place_of

if TYPE_CHECKING:
    from dalembert.robotics._robot import Robot


@dataclass
class RobotLoop:
    """A joint that closes a loop: it keeps two points of links together; with rotation=True also their axes.

    frame0 and frame1 are names as in Robot.FrameHT, or '' for the base; HT0 and HT1 lead from these to the points.
    """

    name: str
    frame0: str
    frame1: str = ""
    HT0: npt.ArrayLike | None = None
    HT1: npt.ArrayLike | None = None
    rotation: bool = False
    active: bool = True

    def __post_init__(self) -> None:
        for what in ("HT0", "HT1"):
            given = getattr(self, what)
            where = f"RobotLoop '{self.name}': {what}"
            setattr(self, what, np.eye(4) if given is None else as_transformation(where, given).copy())

    def check(self, robot: Robot) -> None:
        """Raise a ValueError if a frame does not exist."""
        self.Links(robot)

    def Links(self, robot: Robot) -> list[int]:
        """Return the links of both points, -1 for the base."""
        return [place_of(robot, frame)[0] for frame in (self.frame0, self.frame1)]


@dataclass
class RobotCoupling:
    """A joint whose coordinate is a polynomial of that of another one, c0 + c1 p + c2 p^2 + ..., or a constant c0.

    p = q - leaderReference for the coordinate q of the joint leader; without a leader the coordinate is fixed. Both may
    be tendons, whose coordinate is their length.
    """

    name: str
    joint: str
    leader: str = ""
    coefficients: Sequence[float] = (0.0, 1.0)
    leaderReference: float = 0.0
    active: bool = True

    def __post_init__(self) -> None:
        where = f"RobotCoupling '{self.name}'"
        given = as_vector(f"{where}: coefficients", self.coefficients).tolist()
        if not self.leader and any(given[1:]):
            raise ValueError(f"{where}: coefficients: expected one number without a leader, received {given}")
        self.coefficients = given or [0.0]
        self.leaderReference = as_number(f"{where}: leaderReference", self.leaderReference)

    def check(self, robot: Robot) -> None:
        """Raise a ValueError if a joint does not exist."""
        for joint in filter(None, (self.joint, self.leader)):
            factors_of(robot, joint)

    def Coordinate(self, leader: Any = 0.0) -> Any:
        """Return the coordinate that belongs to that of the leader; arrays as well."""
        value = 0.0
        for coefficient in reversed(self.coefficients):
            value = value * (leader - self.leaderReference) + coefficient
        return value


def add_loop(robot: Robot, mbs: Any, loop: RobotLoop, marker: AddMarker) -> Any:
    """Add the joint of a loop."""
    ends = []
    for frame, T in ((loop.frame0, loop.HT0), (loop.frame1, loop.HT1)):
        link, local = place_of(robot, frame)
        ends.append(marker(link, local @ np.asarray(T)))
    values: dict[str, Any] = {"markerNumbers": [end[0] for end in ends], "activeConnector": loop.active}
    if not loop.rotation:
        return mbs.AddObject(items.SphericalJoint(**values, visualization=items.VObjectJointSpherical(show=False)))
    values |= {f"rotationMarker{i}": end[1] for i, end in enumerate(ends)}
    return mbs.AddObject(items.GenericJoint(**values, visualization=items.VObjectJointGeneric(show=False)))


def add_coupling(robot: Robot, mbs: Any, coupling: RobotCoupling, node: Any, coordinate: Callable[[int], Any]) -> Any:
    """Add the constraint of a coupling between coordinates of a tree."""
    if coupling.joint in robot.tendons or coupling.leader in robot.tendons:
        return _add_vector_coupling(robot, mbs, coupling, node)
    reference = robot.referenceConfiguration  # markers measure from there
    i = robot.GetJointIndex(coupling.joint)
    j = robot.GetJointIndex(coupling.leader) if coupling.leader else -1
    at = reference[j] if coupling.leader else 0.0
    markers = [coordinate(i), coordinate(j)]
    if any(coupling.coefficients[2:]):

        @dalembert.laws.constraint(1, 1)
        def Polynomial(q0: Any, q1: Any, t: Any) -> Any:
            return q0[0] + reference[i] - coupling.Coordinate(q1[0] + at)

        return mbs.AddObject(Polynomial(markers, activeConnector=coupling.active))
    slope = coupling.coefficients[1] if len(coupling.coefficients) > 1 else 0.0
    return mbs.AddObject(
        items.CoordinateConstraint(
            markerNumbers=markers,
            factorValue1=slope,
            offset=reference[i] - coupling.Coordinate(at),
            activeConnector=coupling.active,
            visualization=items.VObjectConnectorCoordinate(show=False),
        )
    )


def _add_vector_coupling(robot: Robot, mbs: Any, coupling: RobotCoupling, node: Any) -> Any:
    """Add the constraint of a coupling with tendons, of all coordinates of a tree."""
    own = factors_of(robot, coupling.joint)
    leading = factors_of(robot, coupling.leader) if coupling.leader else np.zeros(len(own))

    @dalembert.laws.constraint(0, len(own))
    def Polynomial(q0: Any, q1: Any, t: Any) -> Any:
        length, leader = (sum(each[i] * q1[i] for i in np.flatnonzero(each)) for each in (own, leading))
        return length - coupling.Coordinate(leader)

    ground = mbs.AddNode(items.NodePointGround())
    markers = [mbs.AddMarker(items.MarkerNodeCoordinates(nodeNumber=number)) for number in (ground, node)]
    return mbs.AddObject(Polynomial(markers, activeConnector=coupling.active))


def add(
    robot: Robot, mbs: Any, marker: AddMarker, node: Any = None, coordinate: Callable[[int], Any] | None = None
) -> dict[str, Any]:
    """Add all constraints; return their objects by name. Couplings need the node of a tree, and markers on it."""
    return {
        name: add_loop(robot, mbs, each, marker)
        if isinstance(each, RobotLoop)
        else add_coupling(robot, mbs, each, node, coordinate)  # type: ignore[arg-type]
        for name, each in robot.constraints.items()
    }
