"""Actuators of MJCF files: motor, position, velocity, intvelocity, damper, cylinder, and general without muscles."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from dalembert.robotics._actuators import RobotActuator
from dalembert.robotics._mjcf_elements import Content, limited_range
from dalembert.robotics._mjcf_tendons import Tendons, site_frame
from dalembert.robotics._robot import Robot
from dalembert.robotics._tendons import factors_of
from dalembert.robotics._xml import Element

_NOT_READ = ("muscle", "adhesion", "dcmotor", "plugin")
_DYNAMICS = {"none": "none", "integrator": "integrator", "filter": "filter", "filterexact": "filter"}
_FURTHER = ("armature", "damping", "delay")  # attributes of actuators that are named
_RANGES = {"ctrlrange": "ctrllimited", "forcerange": "forcelimited", "actrange": "actlimited"}


@dataclass
class _Law:
    """Gain, bias and dynamics of an actuator with the names of MJCF, and the shortcut that has set them."""

    kind: str = ""
    gain_type: str = "fixed"
    gain: list[float] = field(default_factory=lambda: [1.0, 0.0, 0.0])
    bias_type: str = "none"
    bias: list[float] = field(default_factory=lambda: [0.0, 0.0, 0.0])
    dynamics: str = "none"
    time: float = 1.0
    ratio: float = 0.0
    inherits: float = 0.0  # part of the range of a joint that is the range of the control, or of an integrator


def _numbers(element: Element, name: str, old: list[float]) -> list[float]:
    """Return three numbers of an attribute; those that are not given stay."""
    given = element.numbers(name, (1, 100), " ".join(map(repr, old)))[:3].tolist()
    return [*given, *old[len(given) :]]


def _general(element: Element, law: _Law) -> _Law:
    """Return a law with the attributes that <general> gives."""
    return replace(
        law,
        gain_type=element.text("gaintype", law.gain_type),
        gain=_numbers(element, "gainprm", law.gain),
        bias_type=element.text("biastype", law.bias_type),
        bias=_numbers(element, "biasprm", law.bias),
        dynamics=element.text("dyntype", law.dynamics),
        time=float(element.numbers("dynprm", (1, 100), repr(law.time))[0]),
        ratio=0.0 if "biasprm" in element.attributes else law.ratio,
        inherits=0.0 if "ctrlrange" in element.attributes else law.inherits,
    )


def _next(element: Element, law: _Law) -> _Law:
    """Return the law after an element, one of the defaults or the actuator itself.

    Shortcuts go on with what a default of their own kind, or of <general>, has set.
    """
    if element.tag == "general":
        return _general(element, law)
    kept = law.kind == element.tag or (not law.kind and (law.gain_type, law.dynamics) == ("fixed", "none"))
    old = law if kept else _Law()
    match element.tag:
        case "motor":
            return _Law("motor")
        case "position" | "intvelocity":
            k, d = element.number("kp", repr(old.gain[0])), element.number("kv", repr(-old.bias[2]))
            ratio = element.number("dampratio", "0" if "kv" in element.attributes else repr(old.ratio))
            time = element.number("timeconst", repr(old.time if old.dynamics == "filterexact" else 0.0))
            if element.tag == "intvelocity":
                dynamics, time = "integrator", 1.0
            else:
                dynamics, time = ("filterexact", time) if time else ("none", 1.0)
            own = "actrange" if element.tag == "intvelocity" else "ctrlrange"
            inherits = 0.0 if own in element.attributes else element.number("inheritrange", repr(old.inherits))
            bias = [0.0, -k, 0.0 - d]
            return _Law(element.tag, "fixed", [k, 0.0, 0.0], "affine", bias, dynamics, time, ratio, inherits)
        case "velocity":
            k = element.number("kv", repr(old.gain[0]))
            return _Law("velocity", "fixed", [k, 0.0, 0.0], "affine", [0.0, 0.0, -k])
        case "damper":
            k = element.amount("kv", repr(-old.gain[2]))
            return _Law("damper", "affine", [0.0, 0.0, 0.0 - k])
        case "cylinder":
            area = element.number("area", repr(old.gain[0]))
            if "diameter" in element.attributes:
                area = np.pi / 4 * element.number("diameter") ** 2
            time = element.number("timeconst", repr(old.time))
            return _Law(
                "cylinder", "fixed", [area, 0.0, 0.0], "affine", _numbers(element, "bias", old.bias), "filter", time
            )
    return replace(law, kind=element.tag)


def _wrench(element: Element) -> list[float]:
    """Return the six components of the gear of an actuator on a site."""
    given = element.numbers("gear", (1, 6), "1").tolist()
    return [*given, *[0.0] * (6 - len(given))]


class Actuators:
    """The actuators of a file; complete() adds them to the robot."""

    def __init__(self, content: Content, tendons: Tendons) -> None:
        self.compiler, self.options, self.notes = content.compiler, content.options, content.notes
        self.joints, self.tendons = content.named_joints, tendons
        self.models: dict[str, int] = {}  # numbers of the models that actuators belong to, by their names
        self.with_activation: list[str] = []
        self.unknown_activations: list[str] = []  # actuators with a number of activations that is not known here
        self.read: list[tuple[RobotActuator, _Law]] = []
        for element in content.elements_of("actuator"):
            self._take(element)
        targets = [actuator.joint for actuator, _ in self.read if actuator.joint]
        acted = [joint for target in targets for joint in tendons.factors.get(target, [target])]
        self.several = {target for target in targets if targets.count(target) > 1 or acted.count(target) > 1}
        for joint in dict.fromkeys(acted):
            if self.joints[joint].force_range is not None and (joint in self.several or joint not in targets):
                self.notes.add("actuatorfrcrange of joints with several actuators, or with those of tendons:", joint)
        for tendon in dict.fromkeys(targets):
            if tendon in self.several and tendon in tendons.factors and self._range_of_tendon(tendon) is not None:
                self.notes.add("actuatorfrcrange of tendons with several actuators:", tendon)

    def _take(self, element: Element) -> None:
        name = element.text("name", element.text("joint", element.text("tendon", "")))
        if not name or name in self.models:
            name = f"actuator {len(self.models)}"
        self.models[name] = element.model
        compiler = self.compiler.of(element)
        defaults = compiler.actuator_defaults[compiler.class_of(element, "main")]
        law, common = _Law(), dict[str, str]()
        for each in (*defaults, element):
            law = _next(each, law)
            common |= each.attributes
        element = replace(element, attributes=common | element.attributes)
        if element.tag in ("plugin", "dcmotor") or law.dynamics not in (*_DYNAMICS, "muscle"):
            self.unknown_activations.append(name)
        elif element.tag == "muscle" or law.dynamics != "none":
            self.with_activation.append(name)
        target = self._target(element)
        if reason := self._unsupported(element, law, target):
            self.notes.add(f"actuators {reason}:", name)
            return
        group = int(element.number("group", "0"))
        if "actuation" in self.options.off or group in self.options.groups_off:
            return
        for what in _FURTHER:
            if element.number(what, "0"):
                self.notes.add(f"{what} of actuators", name)
        gear = float(element.numbers("gear", (1, 6), "1")[0])
        is_thruster = "site" in element.attributes
        if not (any(_wrench(element)) if is_thruster else gear) or not any(law.gain):
            self.notes.add("actuators without a gear or gain:", name)
            return
        actuator = RobotActuator(
            name,
            "" if is_thruster else target,
            1.0 if is_thruster else gear,
            law.gain if law.gain_type == "affine" else (law.gain[0], 0.0, 0.0),
            law.bias if law.bias_type == "affine" else (0.0, 0.0, 0.0),
            None if "clampctrl" in self.options.off else self._range(element, "ctrlrange"),
            self._range(element, "forcerange"),
            dynamics=_DYNAMICS[law.dynamics],
            timeConstant=law.time,
            activationRange=self._range(element, "actrange"),
            frame=target if is_thruster else "",
            wrench=_wrench(element) if is_thruster else [0.0] * 6,
        )
        self.read.append((actuator, law))

    def _target(self, element: Element) -> str:
        """Return the name of the joint or tendon that an actuator acts on; empty if it acts on something else."""
        name = element.text("joint", element.text("jointinparent", ""))
        if name and name not in self.joints:
            element.fail(f"there is no joint '{name}'; there are: {', '.join(self.joints) or 'none with a name'}")
        if "site" in element.attributes:
            name = site_frame(element.text("site"), self.tendons.bodies)
            if name not in self.tendons.sites:
                element.fail(f"there is no site '{name}'; there are: {', '.join(self.tendons.sites) or 'none'}")
            return name
        tendon = element.text("tendon", "")
        return name or (tendon if tendon in self.tendons.factors else "")

    def _unsupported(self, element: Element, law: _Law, target: str) -> str:
        """Return what is not supported; empty if everything is."""
        if element.tag in _NOT_READ:
            return f"<{element.tag}>"
        if law.gain_type not in ("fixed", "affine") or law.bias_type not in ("none", "affine"):
            return f"with gaintype {law.gain_type} and biastype {law.bias_type}"
        if law.dynamics not in _DYNAMICS:
            return f"with dyntype {law.dynamics}"
        if not target:
            others = ("tendon", "site", "body")
            return "that act on " + next((what for what in others if what in element.attributes), "others")
        if "site" in element.attributes:
            linear = law.dynamics == "none" and law.bias_type == "none" and law.gain_type == "fixed"
            return (
                "" if linear and "refsite" not in element.attributes else "on sites other than motors without refsite"
            )
        if target in self.tendons.factors:
            return f"with dyntype {law.dynamics} on tendons" if law.dynamics != "none" else ""
        kind = self.joints[target].kind
        return f"of {kind} joints" if kind in ("ball", "floating") else ""

    def _range(self, element: Element, name: str) -> tuple[float, float] | None:
        return limited_range(element, self.compiler, name, _RANGES[name])

    def complete(self, robot: Robot) -> None:
        """Add the actuators; some depend on the inertias and the limits of their joints."""
        for actuator, law in self.read:
            if actuator.frame:
                robot.AddActuator(actuator)
                continue
            target, factors = actuator.joint, actuator.gear * factors_of(robot, actuator.joint)
            if law.ratio > 0:  # of the motion of the transmission alone
                mass = robot.MassMatrix(robot.referenceConfiguration)
                damping = 2 * law.ratio * np.sqrt(actuator.gain[0] / (factors @ np.linalg.solve(mass, factors)))
                actuator.bias = (*actuator.bias[:2], -float(damping))
            of_tendon = target in self.tendons.factors
            limits: Any = robot.tendons[target].limits if of_tendon else robot.GetLink(target).jointLimits
            if law.inherits > 0 and limits is not None:
                middle, half = 0.5 * (limits[0] + limits[1]), 0.5 * law.inherits * (limits[1] - limits[0])
                what = "activationRange" if law.kind == "intvelocity" else "controlRange"
                setattr(actuator, what, (float(middle - half), float(middle + half)))
            found = self._range_of_tendon(target) if of_tendon else self.joints[target].force_range
            if found is not None and target not in self.several:
                lower, upper = found if of_tendon else sorted(np.array(found) / actuator.gear)
                own = actuator.forceRange or (-np.inf, np.inf)
                actuator.forceRange = tuple(float(np.clip(value, lower, upper)) for value in own)
            robot.AddActuator(actuator)

    def _range_of_tendon(self, name: str) -> tuple[float, float] | None:
        return self.tendons.range_of(name, "actuatorfrcrange", "actuatorfrclimited")
