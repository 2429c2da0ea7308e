"""Links and joints as files of robots have them, and the robot that they make.

Fixed joints join links to one; floating and planar joints become several joints of one coordinate, with links without
mass between them; axes in any direction become axes of turned joints.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray
from dalembert._geometry.inertia import RigidBodyInertia
from dalembert._geometry.rotations import ComputeOrthonormalBasis
from dalembert._geometry.transformations import InverseHT
from dalembert.robotics import _drawing
from dalembert.robotics._kinematics import joint_transformation
from dalembert.robotics._parts import GraphicsList, RobotBase, RobotLink, VRobotBase, VRobotLink
from dalembert.robotics._robot import Robot
from dalembert.robotics._xml import Element

_ROUNDED = 1e-3  # relative to principal moments, and, twice, to a mass in kg: negative moments from rounding in files


@dataclass
class Body:
    """A link of a file, in its own frame; frames are further frames on it by name.

    supported is the part of its weight that is carried.
    """

    name: str
    where: Element
    inertia: RigidBodyInertia | None = None
    drawn: GraphicsList = field(default_factory=list)
    frames: dict[str, FloatArray] = field(default_factory=dict)
    supported: float = 0.0


@dataclass
class Joint:
    """A joint of a file: T leads from the parent to the child at coordinate `reference`; axis and place in the child.

    kind is revolute, prismatic, fixed, floating or planar; values are further arguments of RobotLink. per_inertia are
    stiffness and damping, divided by the inertia of the joint at the reference configuration; force_range limits the
    force of actuators.
    """

    name: str
    kind: str
    parent: str
    child: str
    T: FloatArray
    where: Element
    axis: FloatArray = field(default_factory=lambda: np.array([1.0, 0.0, 0.0]))
    place: FloatArray = field(default_factory=lambda: np.zeros(3))
    reference: float = 0.0
    values: dict[str, Any] = field(default_factory=dict)
    per_inertia: tuple[float, float] | None = None
    force_range: tuple[float, float] | None = None


@dataclass
class Description:
    """Description of a robot in a file; the root is the link that is fixed to the ground.

    later are functions that complete the robot when all of its links are there.
    """

    name: str
    bodies: dict[str, Body]
    joints: list[Joint]
    root: str
    gravity: npt.ArrayLike = (0.0, 0.0, -9.81)
    later: list[Callable[[Robot], None]] = field(default_factory=list)


@dataclass
class _Moving:
    """A link of the robot while bodies are joined to it."""

    parent: int
    before: FloatArray
    kind: str
    after: FloatArray
    body: str = ""
    joint: str = ""
    reference: float = 0.0
    values: dict[str, Any] = field(default_factory=dict)
    inertia: RigidBodyInertia = field(default_factory=RigidBodyInertia)
    drawn: GraphicsList = field(default_factory=list)
    supported: list[tuple[float, FloatArray]] = field(default_factory=list)
    per_inertia: tuple[float, float] | None = None


def inertia_in_file(element: Element, mass: float, tensor: FloatArray) -> RigidBodyInertia:
    """Return the inertia that an element gives; errors and warnings have its file and line."""
    moments, axes = np.linalg.eigh(tensor) if np.isfinite(tensor).all() else (np.zeros(3), np.eye(3))
    if -_ROUNDED * max(moments[-1], _ROUNDED * mass) <= moments[0] < 0:
        warnings.warn(
            f"{element.file}, line {element.line}: <{element.tag}>: a principal moment of {moments[0]:.3g} is taken "
            "for zero",
            stacklevel=2,
        )
        tensor = axes @ np.diag(np.maximum(moments, 0.0)) @ axes.T
    try:
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            inertia = RigidBodyInertia(mass, tensor)
    except ValueError as error:
        element.fail(str(error))
    for warning in told:
        warnings.warn(f"{element.file}, line {element.line}: <{element.tag}>: {warning.message}", stacklevel=2)
    return inertia


def translated(r: npt.ArrayLike) -> FloatArray:
    """Return the transformation of a translation."""
    T = np.eye(4)
    T[:3, 3] = r
    return T


def turned(A: FloatArray) -> FloatArray:
    """Return the transformation of a rotation."""
    T = np.eye(4)
    T[:3, :3] = A
    return T


def _axis_frame(letter: str, axis: FloatArray) -> tuple[str, FloatArray]:
    """Return the short name of a joint, and the rotation that turns its own axis to the given one."""
    for name, unit in zip("xyz", np.eye(3), strict=True):
        if np.allclose(axis, unit, atol=1e-12):
            return letter + name, np.eye(3)
    return letter + "z", ComputeOrthonormalBasis(axis)[:, [1, 2, 0]]


def _elementary(joint: Joint) -> list[tuple[str, FloatArray]]:
    """Return the joints of one coordinate that a joint is made of, with their axes in the frame of the child."""
    x, y, z = np.eye(3)
    match joint.kind:
        case "revolute":
            return [("R", joint.axis)]
        case "prismatic":
            return [("P", joint.axis)]
        case "planar":
            basis = ComputeOrthonormalBasis(joint.axis)
            return [("P", basis[:, 1]), ("P", basis[:, 2]), ("R", basis[:, 0])]
        case "ball":
            return [("R", z), ("R", y), ("R", x)]
    return [("P", x), ("P", y), ("P", z), ("R", z), ("R", y), ("R", x)]


def _moving(joint: Joint, carrier: int, T: FloatArray, number: int) -> list[_Moving]:
    """Return the links that a joint adds, the last of which is the child; T leads from the carrier to the child."""
    parts = _elementary(joint)
    result = []
    for i, (letter, axis) in enumerate(parts):
        kind, A = _axis_frame(letter, axis)
        to_axis = translated(joint.place) @ turned(A)
        back = joint_transformation(kind, np.array(-joint.reference))
        before = (T if i == 0 else np.eye(4)) @ to_axis @ back
        name = f"{joint.name}:{i}" if joint.name and len(parts) > 1 else joint.name
        own = _Moving(carrier if i == 0 else number + i - 1, before, kind, InverseHT(to_axis), joint=name)
        own.reference, own.values, own.per_inertia = joint.reference, joint.values, joint.per_inertia
        result.append(own)
    return result


class _Builder:
    """Goes through the tree of links from its root."""

    def __init__(self, description: Description) -> None:
        self.description = description
        self.children: dict[str, list[Joint]] = {}
        for joint in description.joints:
            self.children.setdefault(joint.parent, []).append(joint)
        self.moving: list[_Moving] = []
        self.base: GraphicsList = []
        self.frames: dict[str, tuple[int, FloatArray]] = {}
        self._place(description.root, -1, np.eye(4), fixed=True)

    def _place(self, name: str, carrier: int, T: FloatArray, fixed: bool) -> None:
        """Join a body to the link that carries it, and go on with its joints; T leads from the link to the body."""
        body = self.description.bodies[name]
        drawn = _drawing.moved(body.drawn, T)
        if carrier < 0:
            self.base += drawn
        else:
            link = self.moving[carrier]
            link.drawn += drawn
            if body.inertia is not None:
                moved = body.inertia.Transformed(T)
                link.inertia = link.inertia + moved
                if body.supported:
                    link.supported.append((body.supported * moved.Mass(), moved.COM()))
        if fixed:
            self.frames[name] = (carrier, T)
        links = self.description.bodies  # their names go before those of other frames
        self.frames |= {frame: (carrier, T @ local) for frame, local in body.frames.items() if frame not in links}
        for joint in self.children.get(name, []):
            if joint.kind == "fixed":
                self._place(joint.child, carrier, T @ joint.T, fixed=True)
                continue
            self.moving += _moving(joint, carrier, T @ joint.T, len(self.moving))
            self.moving[-1].body = self.description.bodies[joint.child].name
            self._place(joint.child, len(self.moving) - 1, np.eye(4), fixed=False)

    def robot(self) -> Robot:
        """Return the robot."""
        base = RobotBase(visualization=VRobotBase(self.base))
        robot = Robot(self.description.gravity, base, referenceConfiguration=[link.reference for link in self.moving])
        robot.name, robot.frames = self.description.name, self.frames
        for link in self.moving:
            view = VRobotLink(graphicsData=link.drawn, showMBSjoint=not link.drawn, showCOM=not link.drawn)
            inertia = link.inertia
            robot.AddLink(
                RobotLink(
                    inertia.Mass(),
                    inertia.COM(),
                    inertia.InertiaCOM(),
                    localHT=link.after,
                    jointType=link.kind,
                    parent=link.parent,
                    preHT=link.before,
                    visualization=view,
                    name=link.body,
                    jointName=link.joint,
                    supported=link.supported,
                    **link.values,
                )
            )
        robot.referenceConfiguration = robot.FollowedCoordinates(robot.referenceConfiguration)
        self._tune(robot)
        return robot

    def _tune(self, robot: Robot) -> None:
        """Set spring and damper of joints that are given per inertia."""
        for i, moving in enumerate(self.moving):
            if moving.per_inertia is not None:
                link = robot.links[i]
                link.stiffness, link.damping = (float(free_inertias(robot)[i] * each) for each in moving.per_inertia)


def free_inertias(robot: Robot) -> FloatArray:
    """Return the inertias that joints have at the reference configuration if all other joints are free to move.

    These are the inverse values of the diagonal of the inverse mass matrix.
    """
    return np.asarray(1 / np.diag(np.linalg.inv(robot.MassMatrix(robot.referenceConfiguration))))


def robot_of(description: Description) -> Robot:
    """Return the robot that links and joints make."""
    robot = _Builder(description).robot()
    for complete in description.later:
        complete(robot)
    return robot


def root_of(bodies: dict[str, Body], joints: list[Joint]) -> str:
    """Return the name of the one link that no joint carries; ValueError if links are carried twice or go round."""
    carried: dict[str, Joint] = {}
    for joint in joints:
        for end in (joint.parent, joint.child):
            if end not in bodies:
                joint.where.fail(f"joint '{joint.name}': there is no link '{end}'; there are: {', '.join(bodies)}")
        if joint.child in carried:
            other = carried[joint.child]
            joint.where.fail(
                f"joint '{joint.name}': link '{joint.child}' is carried by joint '{other.name}' in line "
                f"{other.where.line} already; loops need a constraint, not a second joint"
            )
        carried[joint.child] = joint
    roots = [body for body in bodies.values() if body.name not in carried]
    if len(roots) > 1:
        names = ", ".join(f"'{body.name}'" for body in roots)
        roots[1].where.fail(f"expected one link that no joint carries, received {names}")
    for joint in joints:  # joints that do not lead to the root form a cycle
        seen, name = {joint.child}, joint.parent
        while name in carried:
            if name in seen:
                joint.where.fail(f"joint '{joint.name}': its links carry each other in a circle")
            seen.add(name)
            name = carried[name].parent
    return roots[0].name
