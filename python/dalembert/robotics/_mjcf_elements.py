"""Elements of MJCF files before bodies are made of them: included files, repeated elements, misspelt names, options."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from dalembert._checks import FloatArray
from dalembert.robotics._description import Body, Joint
from dalembert.robotics._mjcf_compiler import Compiler
from dalembert.robotics._xml import Element, read

WORLD = "world"
# Kinds of joints by their types in MJCF, and their numbers of positions and rates.
JOINT_KINDS = {"hinge": "revolute", "slide": "prismatic", "ball": "ball", "free": "floating"}
POSITIONS = {"revolute": 1, "prismatic": 1, "ball": 4, "floating": 7}
RATES = {"revolute": 1, "prismatic": 1, "ball": 3, "floating": 6}
_ROTATIONS = "pos quat axisangle euler xyaxes zaxis"
_BODY_PARTS = (
    "inertial joint freejoint geom attach site camera light plugin composite flexcomp body frame replicate include"
)
# Attributes and children of the elements that are read. MuJoCo has more elements, and plugins more attributes;
# similar names are reported as misspelt.
_KNOWN = {
    "compiler": (
        "autolimits boundmass boundinertia settotalmass balanceinertia strippath coordinate angle fitaabb eulerseq "
        "meshdir texturedir assetdir discardvisual usethread fusestatic inertiafromgeom inertiagrouprange alignfree "
        "saveinertial",
        "",
    ),
    "worldbody": ("name childclass", _BODY_PARTS),
    "body": (f"name childclass mocap gravcomp sleep user {_ROTATIONS}", _BODY_PARTS),
    "frame": (f"name childclass {_ROTATIONS}", _BODY_PARTS),
    "attach": ("model body prefix", ""),
    "inertial": (f"mass diaginertia fullinertia {_ROTATIONS}", ""),
    "freejoint": ("name group align", ""),
    "joint": (
        "name class type group pos axis springdamper limited actuatorfrclimited solreflimit solimplimit solreffriction "
        "solimpfriction stiffness range actuatorfrcrange actuatorgravcomp margin ref springref armature damping "
        "frictionloss user",
        "",
    ),
    "geom": (
        "name class type contype conaffinity condim group priority size material rgba friction mass density "
        "shellinertia solmix solref solimp margin gap fromto hfield mesh fitscale fluidshape fluidcoef user "
        f"{_ROTATIONS}",
        "plugin",
    ),
}


def refuse_misspelt(element: Element) -> None:
    """Raise an error for misspelt names in compiler, defaults and bodies; other elements are not read."""
    if element.tag in _KNOWN:
        element.refuse_misspelt(*_KNOWN[element.tag])
    for child in element.children:
        if element.tag in ("mujoco", "default", *_KNOWN) and child.tag in ("default", *_KNOWN):
            refuse_misspelt(child)


def included(element: Element, folder: Path) -> Element:
    """Return an element with the contents of files in the place of <include file>."""
    children = []
    for child in element.children:
        if child.tag == "include":
            path = folder / child.text("file")
            if not path.is_file():
                child.fail(f"there is no file '{child.text('file')}'")
            children += included(read(path), folder).children
        else:
            children.append(included(child, folder))
    return replace(element, children=children)


def limited_range(element: Element, compiler: Compiler, name: str, limited: str) -> tuple[float, float] | None:
    """Return the two limits of an attribute, or None if neither another attribute nor its presence makes them act."""
    given = element.text(limited, "auto")
    if given == "false" or (given == "auto" and not (compiler.of(element).autolimits and name in element.attributes)):
        return None
    lower, upper = element.numbers(name, 2)
    if lower > upper:
        element.fail(f"{name}: expected two numbers that grow, received {lower:g} and {upper:g}")
    return float(lower), float(upper)


def _renamed(element: Element, suffix: str) -> Element:
    """Return a copy of an element in which names have a suffix."""
    attributes = dict(element.attributes)
    if attributes.get("name"):
        attributes["name"] += suffix
    return replace(element, attributes=attributes, children=[_renamed(child, suffix) for child in element.children])


def _frames_of(element: Element, compiler: Compiler) -> Iterator[Element]:
    """Give a <frame> for each copy of a <replicate>: turned by multiples of its angles, each in front of the next."""
    count, place = int(element.number("count")), np.zeros(3)
    angles, offset = element.numbers("euler", 3, "0 0 0"), element.numbers("offset", 3, "0 0 0")
    digits, separator = len(str(count - 1)), element.text("sep", "")
    for i in range(count):
        attributes = {"pos": _text(place), "euler": _text(i * angles)}
        if "childclass" in element.attributes:
            attributes["childclass"] = element.attributes["childclass"]
        copies = [_renamed(child, f"{separator}{i:0{digits}d}") for child in element.children]
        frame = Element("frame", attributes, element.file, element.line, copies)
        yield frame
        place = place + compiler.rotation(frame) @ offset


def _text(values: FloatArray) -> str:
    return " ".join(repr(float(value)) for value in values)


def repeated(element: Element, compiler: Compiler) -> Element:
    """Return an element with the copies that <replicate> makes in its place."""
    children: list[Element] = []
    for child in element.children:
        inner = repeated(child, compiler)
        children += _frames_of(inner, compiler) if child.tag == "replicate" else [inner]
    return replace(element, children=children)


def numbers_of(
    element: Element, name: str, sizes: Sequence[int], models: Sequence[int], compiler: Compiler
) -> list[FloatArray | None]:
    """Return the parts of an attribute that has `size` numbers for each thing of a model and of those attached to it.

    Parts of things of other models are None.
    """
    own = compiler.of(element)
    held = [own.number <= model < own.end for model in models]
    count = sum(size for size, holds in zip(sizes, held, strict=True) if holds)
    values, parts = element.numbers(name, count), list[FloatArray | None]()
    for size, holds in zip(sizes, held, strict=True):
        parts.append(values[:size] if holds else None)
        values = values[size:] if holds else values
    return parts


class Notes:
    """Ignored parts of elements, with the names of the elements."""

    def __init__(self) -> None:
        self.names: dict[str, list[str]] = {}

    def add(self, what: str, name: str) -> None:
        """Record an ignored part of an element."""
        self.names.setdefault(what, []).append(name)

    def texts(self) -> list[str]:
        """Return the texts of the warning."""
        return [f"{what} {', '.join(map(repr, names))}" for what, names in self.names.items()]


class Options:
    """Gravity, and what the flags of <option> switch off; later <option> elements override their attributes only."""

    def __init__(self, root: Element) -> None:
        gravity, flags, groups = np.array([0.0, 0.0, -9.81]), dict[str, str](), ""
        for option in root.every("option"):
            if "gravity" in option.attributes:
                gravity = option.numbers("gravity", 3)
            groups = option.text("actuatorgroupdisable", groups)
            for flag in option.every("flag"):
                flags |= flag.attributes
        off = {name for name, value in flags.items() if value == "disable"}
        if "constraint" in off:
            off |= {"limit", "frictionloss", "equality", "contact"}
        unusual = {("filterparent", "disable"), ("override", "enable")}
        self.contact_flags = [name for name, value in flags.items() if (name, value) in unusual]
        self.groups_off = {int(group) for group in groups.split()}
        self.off, self.gravity = off, gravity * ("gravity" not in off)
        self.passive = not off >= {"spring", "damper"}  # MuJoCo then leaves out all passive forces, gravcomp as well


@dataclass
class Content:
    """The elements of a file with its settings, and the bodies and joints that are made of them."""

    root: Element
    compiler: Compiler
    options: Options
    notes: Notes = field(default_factory=Notes)
    bodies: dict[str, Body] = field(default_factory=dict)
    joints: list[Joint] = field(default_factory=list)

    @property
    def named_joints(self) -> dict[str, Joint]:
        """Return the joints with a name."""
        return {joint.name: joint for joint in self.joints if joint.name}

    @property
    def sites(self) -> list[str]:
        """Return the names of the frames of sites."""
        return [frame for body in self.bodies.values() for frame in body.frames]

    def elements_of(self, section: str) -> Iterator[Element]:
        """Give the elements of all sections of a kind."""
        return (child for group in self.root.every(section) for child in group.children)


# Unsupported elements, in the order of the warning, and settings of <option>.
_ELEMENTS = ("contact", "deformable", "extension")
_MEDIUM = ("density", "viscosity", "wind")


def left_out(root: Element, contacts: bool = False) -> list[str]:
    """Return the unsupported data of a file, in elements outside of the bodies; without contacts if these are read."""
    tags = [tag for tag in _ELEMENTS if not (contacts and tag == "contact")]
    found = [f"<{tag}>" for tag in tags if any(e.children for e in root.every(tag))]
    for option in root.every("option"):
        found += [f"{name} of <option>" for name in _MEDIUM if option.numbers(name, (1, 3), "0").any()]
    if any(compiler.text("alignfree", "false") == "true" for compiler in root.every("compiler")):
        found.append("alignfree of <compiler>")
    return found
