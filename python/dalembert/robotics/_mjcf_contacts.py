"""Contacts of MJCF files: geoms that are spheres, capsules, cylinders, boxes or planes."""

from __future__ import annotations

import numpy as np

from dalembert._checks import FloatArray
from dalembert.robotics._contacts import RobotContact, effective_masses
from dalembert.robotics._mjcf_elements import WORLD, Content
from dalembert.robotics._robot import Robot
from dalembert.robotics._shapes import Shape
from dalembert.robotics._tendons import place_of
from dalembert.robotics._xml import Element

_SHAPES = ("sphere", "capsule", "cylinder", "box", "plane")
_IMPEDANCES = (1e-4, 0.9999)  # limits of MuJoCo
_LEAST_WIDTH = 1e-15
_DEPTHS = 100  # within the width of an impedance, to find the smallest depth at rest
_LAW = {"solref": "0.02 1", "solimp": "0.9 0.95 0.001 0.5 2"}
_GRAVITY = 9.81  # m/s^2, for files without gravity


def _impedance(depth: float, solimp: FloatArray) -> float:
    """Return the impedance of MuJoCo at a penetration: it grows from the first to the second number within a width."""
    least, most, width, middle, power = solimp
    if width <= _LEAST_WIDTH:
        return float(0.5 * (least + most))
    x = min(depth / width, 1.0)
    part = x**power / middle ** (power - 1) if x <= middle else 1 - (1 - x) ** power / (1 - middle) ** (power - 1)
    return float(least + part * (most - least))


def _stiffness_and_ratio(geom: Element, gravity: float) -> tuple[float, float]:
    """Return the stiffness per mass and the damping ratio of a geom; see Contacts."""
    given = geom.numbers("solimp", (2, 5), _LAW["solimp"])
    solimp = np.array([*given, *np.array(_LAW["solimp"].split(), dtype=float)[len(given) :]])
    solimp[[0, 1, 3]] = np.clip(solimp[[0, 1, 3]], *_IMPEDANCES)
    solimp[4] = max(solimp[4], 1.0)
    first, second = geom.numbers("solref", 2, _LAW["solref"])
    if first > 0 and second > 0:
        stiffness, ratio = 1 / (first * second) ** 2, second
    elif first < 0 and second <= 0:
        stiffness, ratio = -first, -second / (2 * np.sqrt(-first))
    else:
        geom.fail(f"solref: expected two positive or two negative numbers, received {first:g} and {second:g}")

    def per_mass(impedance: float) -> float:
        return float(stiffness * (impedance / solimp[1]) ** 2 / (1 - impedance))

    def carries(depth: float) -> bool:
        return depth * per_mass(_impedance(depth, solimp)) > gravity

    deepest = gravity / per_mass(float(min(solimp[:2])))
    grid = [0.0, *np.linspace(0.0, solimp[2], _DEPTHS)[1:], max(deepest, solimp[2])]  # impedances may also decrease
    first_one = next((i for i, depth in enumerate(grid) if carries(depth)), len(grid) - 1)
    lower, upper = grid[first_one - 1], grid[first_one]
    while lower < (depth := 0.5 * (lower + upper)) < upper:  # until the numbers are neighbors
        lower, upper = (lower, depth) if carries(depth) else (depth, upper)
    return per_mass(_impedance(depth, solimp)), float(ratio)


class Contacts:
    """The contacts of a file; complete() adds them to the robot.

    Contact of MuJoCo is soft: a constraint with an impedance that depends on the penetration. Contact of the robot is a
    spring with a damper. Its stiffness k is that with which a body rests as deep on one contact point as in MuJoCo:
    k = m d^2 / (D^2 (1 - d) T^2 z^2), with solref (T, z), the impedance d at this depth, the second number D of solimp,
    and the effective mass m of the link. The damping is 2 z sqrt(k m). Geoms of the world are rigid.
    """

    def __init__(self, content: Content, wanted: bool) -> None:
        self.content, self.notes = content, content.notes
        self.wanted = wanted
        self.read: list[tuple[RobotContact, Element]] = []

    def take(self, geom: Element, body: str, shape: Shape | None, T: FloatArray) -> None:
        """Take over a geom on a body if it touches others."""
        groups, partners = (int(geom.number(name, "1")) for name in ("contype", "conaffinity"))
        kind = geom.text("type", "sphere")
        name = geom.text("name", kind)
        if not (groups or partners) or "contact" in self.content.options.off:
            return
        if not self.wanted:
            if body == WORLD:
                self.notes.add("contact, without contacts=True, with geoms of the world", name)
            return
        if kind not in _SHAPES:
            self.notes.add(f"contact of geoms of type {kind}", name)
            return
        condim = int(geom.number("condim", "3"))
        if condim > 3:
            self.notes.add("torsional and rolling friction (condim 4 and 6) of geoms", name)
        for what in ("margin", "gap", "priority"):
            if geom.number(what, "0"):
                self.notes.add(f"{what} of geoms", name)
        if name in [other.name for other, _ in self.read]:
            name = f"{name} {len(self.read)}"
        made = RobotContact(
            name,
            body,
            kind,
            shape.size if shape is not None else (),
            T,
            friction=float(geom.numbers("friction", (1, 3), "1")[0]),
            smooth=condim == 1,
            groups=groups,
            partners=partners,
        )
        self.read.append((made, geom))

    def finish(self) -> None:
        """Record differences that depend on several geoms, and on elements outside of the bodies."""
        laws = [tuple(geom.text(what, default).split() for what, default in _LAW.items()) for _, geom in self.read]
        usual = max(laws, key=laws.count, default=None)
        for (made, _), law in zip(self.read, laws, strict=True):
            if law != usual:
                self.notes.add("mixing of different solref and solimp of geoms", made.name)
        for name in self.content.options.contact_flags if self.read else ():
            self.notes.add("flags of <option>", name)
        for element in self.content.elements_of("contact") if self.wanted else ():
            if element.tag != "exclude":
                self.notes.add(f"<{element.tag}> of <contact>", element.text("name", element.text("geom1", "")))

    def complete(self, robot: Robot) -> None:
        """Add the contacts."""
        if not self.read:
            return
        masses = effective_masses(robot)
        gravity = float(np.linalg.norm(self.content.options.gravity)) or _GRAVITY
        for made, geom in self.read:
            link = place_of(robot, made.frame)[0]
            per_mass, ratio = _stiffness_and_ratio(geom, gravity)
            if link >= 0:
                made.stiffness = float(per_mass * masses[link])
                made.damping = float(2 * ratio * np.sqrt(made.stiffness * masses[link]))
            robot.AddContact(made)
        for element in self.content.elements_of("contact"):
            if element.tag == "exclude":
                ends = [element.text(key) for key in ("body1", "body2")]
                for end in ends:
                    if end not in self.content.bodies:
                        element.fail(f"there is no body '{end}'; there are: {', '.join(self.content.bodies)}")
                robot.ExcludeContacts(*ends)
