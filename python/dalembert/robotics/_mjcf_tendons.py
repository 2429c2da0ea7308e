"""Tendons of MJCF files: fixed ones, which are sums of joint coordinates."""

from __future__ import annotations

from dataclasses import replace

from dalembert.robotics._description import Joint
from dalembert.robotics._mjcf_compiler import Compiler
from dalembert.robotics._mjcf_elements import Notes, Options
from dalembert.robotics._robot import Robot
from dalembert.robotics._tendons import RobotTendon
from dalembert.robotics._xml import Element


class Tendons:
    """The tendons of a file; complete() adds them to the robot."""

    def __init__(self, root: Element, compiler: Compiler, options: Options, notes: Notes, joints: list[Joint]) -> None:
        self.compiler, self.options, self.notes = compiler, options, notes
        self.joints = {joint.name for joint in joints if joint.name}
        self.elements: dict[str, Element] = {}
        self.factors: dict[str, dict[str, float]] = {}
        for element in (child for group in root.every("tendon") for child in group.children):
            self._take(element)

    def _take(self, element: Element) -> None:
        defaults = self.compiler.classes[self.compiler.class_of(element, "main")].get("tendon", {})
        element = replace(element, attributes=defaults | element.attributes)
        name = element.text("name", f"tendon {len(self.elements)}")
        if element.tag != "fixed":
            self.notes.add(f"<{element.tag}> tendons", name)
            return
        self.elements[name], self.factors[name] = element, {}
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
        element = self.elements[name]
        given = element.text(limited, "auto")
        if given == "false" or (given == "auto" and not (self.compiler.autolimits and attribute in element.attributes)):
            return None
        lower, upper = element.numbers(attribute, 2)
        if lower > upper:
            element.fail(f"{attribute}: expected two numbers that grow, received {lower:g} and {upper:g}")
        return float(lower), float(upper)

    def complete(self, robot: Robot) -> None:
        """Add the tendons.

        A spring without a length is relaxed with the joints where their own springs are relaxed.
        """
        off = self.options.off
        for name, element in self.elements.items():
            factors = self.factors[name]
            rest = element.numbers("springlength", (1, 2), "-1").tolist()
            if rest[0] < 0:
                rest = [
                    sum(f * robot.links[robot.GetJointIndex(joint)].springReference for joint, f in factors.items())
                ]
            robot.AddTendon(
                RobotTendon(
                    name,
                    factors,
                    stiffness=0.0 if "spring" in off else float(element.numbers("stiffness", (1, 3), "0")[0]),
                    restLength=(rest[0], rest[-1]),
                    damping=0.0 if "damper" in off else float(element.numbers("damping", (1, 3), "0")[0]),
                    friction=0.0 if "frictionloss" in off else element.amount("frictionloss", "0"),
                    inertia=element.amount("armature", "0"),
                    limits=None if "limit" in off else self.range_of(name, "range", "limited"),
                )
            )
