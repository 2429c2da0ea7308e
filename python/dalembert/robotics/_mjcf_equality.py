"""Equality constraints of MJCF files: connect, weld, joint, and those of fixed tendons."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._geometry.rotations import EulerParameters2RotationMatrix
from dalembert._geometry.transformations import InverseHT
from dalembert.robotics._constraints import RobotCoupling, RobotLoop
from dalembert.robotics._description import translated, turned
from dalembert.robotics._mjcf_elements import WORLD, Content
from dalembert.robotics._mjcf_tendons import Tendons, site_frame
from dalembert.robotics._robot import Robot
from dalembert.robotics._tendons import factors_of
from dalembert.robotics._xml import Element

_READ = ("connect", "weld", "joint", "tendon")


class Equality:
    """The constraints of a file; complete() adds them to the robot.

    Points and poses that are not given are those of the reference configuration.
    """

    def __init__(self, content: Content, tendons: Tendons) -> None:
        self.compiler, self.notes, self.tendons = content.compiler, content.notes, tendons
        self.joints, self.bodies, self.sites = content.named_joints, content.bodies, content.sites
        self.elements: list[tuple[str, Element]] = []
        if "equality" in content.options.off:
            return
        for element in content.elements_of("equality"):
            self._take(element)

    def _take(self, element: Element) -> None:
        compiler = self.compiler.of(element)
        defaults = compiler.classes[compiler.class_of(element, "main")].get("equality", {})
        element = replace(element, attributes=defaults | element.attributes)
        ends = [element.text(key) for key in _ends(element) if key in element.attributes]
        name = element.text("name", "-".join([element.tag, *ends]))
        if name in [other for other, _ in self.elements]:
            name = f"{name} {len(self.elements)}"
        if reason := self._unsupported(element, ends):
            self.notes.add(f"constraints {reason}:", name)
            return
        self.elements.append((name, element))

    def _unsupported(self, element: Element, ends: list[str]) -> str:
        """Return what is not supported; empty if everything is. An unknown name is an error."""
        if element.tag not in _READ:
            return f"<{element.tag}>"
        if element.tag == "joint":
            self._require("joint", element, ends, self.joints)
            several = [end for end in ends if self.joints[end].kind in ("ball", "floating")]
            return f"of {self.joints[several[0]].kind} joints" if several else ""
        if element.tag == "tendon":
            return "" if all(end in self.tendons.factors for end in ends) else "of tendons that are not fixed"
        if "site1" in element.attributes:
            self._require("site", element, [site_frame(end, self.bodies) for end in ends], self.sites)
            return ""
        self._require("body", element, ends, self.bodies)
        return "with torquescale 0" if element.number("torquescale", "1") == 0 else ""

    @staticmethod
    def _require(what: str, element: Element, ends: list[str], names: Any) -> None:
        if not ends:
            element.fail(f"expected the attribute '{_ends(element)[0]}'")
        for end in ends:
            if end not in names:
                element.fail(f"there is no {what} '{end}'; there are: {', '.join(filter(None, names)) or 'none'}")

    def complete(self, robot: Robot) -> None:
        """Add the constraints, and move coupled joints of the reference configuration to where they have to be."""
        for name, element in self.elements:
            active = element.text("active", "true") == "true"
            made = self._coupling if element.tag in ("joint", "tendon") else self._loop
            robot.AddConstraint(made(robot, name, element, active))
        robot.referenceConfiguration = robot.FollowedCoordinates(robot.referenceConfiguration)

    @staticmethod
    def _coupling(robot: Robot, name: str, element: Element, active: bool) -> RobotCoupling:
        first, second = element.text(f"{element.tag}1"), element.text(f"{element.tag}2", "")
        coefficients = element.numbers("polycoef", (1, 5), "0 1 0 0 0")
        reference = robot.referenceConfiguration
        coefficients[0] += reference @ factors_of(robot, first)
        if not second:
            return RobotCoupling(name, first, "", coefficients[:1].tolist(), active=active)
        at = reference @ factors_of(robot, second)
        return RobotCoupling(name, first, second, coefficients.tolist(), float(at), active)

    def _loop(self, robot: Robot, name: str, element: Element, active: bool) -> RobotLoop:
        rotation = element.tag == "weld"
        if "site1" in element.attributes:
            first, second = (site_frame(element.text(key), self.bodies) for key in ("site1", "site2"))
            return RobotLoop(name, first, second, rotation=rotation, active=active)
        first, second = element.text("body1"), element.text("body2", WORLD)
        between = InverseHT(_pose(robot, first)) @ _pose(robot, second)  # from the second to the first
        if not rotation:
            T0 = translated(element.numbers("anchor", 3))
            return RobotLoop(name, first, second, T0, translated((InverseHT(between) @ T0)[:3, 3]), active=active)
        T1 = translated(element.numbers("anchor", 3, "0 0 0"))
        pose = element.numbers("relpose", 7, "0 1 0 0 0 0 0")
        if pose[3:].any():  # the first part is where the anchor is in the first body
            q = pose[3:] / np.linalg.norm(pose[3:])
            T0 = translated(pose[:3]) @ turned(EulerParameters2RotationMatrix(q))
        else:
            T0 = between @ T1
        return RobotLoop(name, first, second, T0, T1, True, active)


def _ends(element: Element) -> list[str]:
    """Return the attributes that name what a constraint connects."""
    if element.tag in ("joint", "tendon"):
        return [f"{element.tag}1", f"{element.tag}2"]
    kind = "site" if "site1" in element.attributes else "body"
    return [f"{kind}1", f"{kind}2"]


def _pose(robot: Robot, body: str) -> FloatArray:
    return np.asarray(robot.FrameHT(body, robot.referenceConfiguration))
