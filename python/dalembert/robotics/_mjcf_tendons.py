"""Tendons of MJCF files: fixed ones, which are sums of joint coordinates, and spatial ones between two sites."""

from __future__ import annotations

from collections.abc import Container
from dataclasses import replace
from typing import Any

import numpy as np

from dalembert.robotics._mjcf_elements import Content, limited_range
from dalembert.robotics._robot import Robot
from dalembert.robotics._tendons import RobotCable, RobotTendon
from dalembert.robotics._xml import Element


def site_frame(site: str, bodies: Container[str]) -> str:
    """Return the name of the frame of a site."""
    return f"{site} (site)" if site in bodies else site


class Tendons:
    """The tendons of a file; complete() adds them to the robot."""

    def __init__(self, content: Content) -> None:
        self.compiler, self.options, self.notes = content.compiler, content.options, content.notes
        self.joints, self.bodies, self.sites = content.named_joints, content.bodies, content.sites
        self.elements: dict[str, Element] = {}
        self.ends: dict[str, tuple[str, str]] = {}  # of spatial tendons
        self.factors: dict[str, dict[str, float]] = {}
        for element in content.elements_of("tendon"):
            self._take(element)

    def _take(self, element: Element) -> None:
        compiler = self.compiler.of(element)
        defaults = compiler.classes[compiler.class_of(element, "main")].get("tendon", {})
        element = replace(element, attributes=defaults | element.attributes)
        name = element.text("name", f"tendon {len(self.elements)}")
        if element.tag == "spatial":
            sites = [site_frame(part.text("site"), self.bodies) for part in element.every("site")]
            for part, site in zip(element.every("site"), sites, strict=True):
                if site not in self.sites:
                    part.fail(f"there is no site '{part.text('site')}'; there are: {', '.join(self.sites) or 'none'}")
            if len(sites) != 2 or len(element.children) > 2:
                self.notes.add("spatial tendons that are not between two sites:", name)
                return
            self.ends[name] = sites[0], sites[1]
            if element.number("armature", "0"):
                self.notes.add("armature of spatial tendons", name)
        else:
            self.factors[name] = {}
        self.elements[name] = element
        for part in element.every("joint"):
            joint = part.text("joint")
            if joint not in self.joints:
                part.fail(f"there is no joint '{joint}'; there are: {', '.join(sorted(self.joints)) or 'none'}")
            factors = self.factors[name]
            factors[joint] = factors.get(joint, 0.0) + part.number("coef")
        for what in ("stiffness", "damping"):
            if element.numbers(what, (1, 3), "0")[1:].any():
                self.notes.add(f"coefficients of higher order of {what} of tendons", name)

    def range_of(self, name: str, attribute: str, limited: str) -> tuple[float, float] | None:
        """Return a range of a tendon, if it is limited."""
        return limited_range(self.elements[name], self.compiler, attribute, limited)

    def complete(self, robot: Robot) -> None:
        """Add the tendons.

        A spring without a length is relaxed with the joints where their own springs are relaxed.
        """
        off = self.options.off
        relaxed = np.array([link.springReference for link in robot.links])
        for name, element in self.elements.items():
            rest = element.numbers("springlength", (1, 2), "-1").tolist()
            law: dict[str, Any] = {
                "stiffness": 0.0 if "spring" in off else float(element.numbers("stiffness", (1, 3), "0")[0]),
                "damping": 0.0 if "damper" in off else float(element.numbers("damping", (1, 3), "0")[0]),
                "friction": 0.0 if "frictionloss" in off else element.amount("frictionloss", "0"),
                "limits": None if "limit" in off else self.range_of(name, "range", "limited"),
            }
            if name in self.ends:
                cable = RobotCable(name, *self.ends[name], **law)
                own = float(cable.Kinematics(robot, relaxed)[0])
                cable.restLength = (own, own) if rest[0] < 0 else (rest[0], rest[-1])
                robot.AddCable(cable)
            else:
                tendon = RobotTendon(name, self.factors[name], inertia=element.amount("armature", "0"), **law)
                own = float(relaxed @ tendon.Factors(robot))
                tendon.restLength = (own, own) if rest[0] < 0 else (rest[0], rest[-1])
                robot.AddTendon(tendon)
