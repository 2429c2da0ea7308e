"""Robots from URDF files, as ROS uses them (http://wiki.ros.org/urdf/XML)."""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._geometry.inertia import RigidBodyInertia
from dalembert._geometry.rotations import RotXYZ2RotationMatrix
from dalembert.robotics import _drawing, _shapes
from dalembert.robotics._description import Body, Description, Joint, inertia_in_file, root_of, translated, turned
from dalembert.robotics._xml import Element, read

_KINDS = {
    "revolute": "revolute",
    "continuous": "revolute",
    "prismatic": "prismatic",
    "fixed": "fixed",
    "floating": "floating",
    "planar": "planar",
}
# Attributes and children of elements. Other programs use further ones; similar names are reported as misspelt.
_KNOWN = {
    "robot": ("name version", "link joint material transmission gazebo sensor"),
    "link": ("name type", "inertial visual collision"),
    "inertial": ("", "origin mass inertia"),
    "mass": ("value", ""),
    "inertia": ("ixx ixy ixz iyy iyz izz", ""),
    "origin": ("xyz rpy", ""),
    "visual": ("name", "origin geometry material"),
    "geometry": ("", "box sphere cylinder capsule mesh"),
    "box": ("size", ""),
    "sphere": ("radius", ""),
    "cylinder": ("radius length", ""),
    "capsule": ("radius length", ""),
    "mesh": ("filename scale", ""),
    "material": ("name", "color texture"),
    "color": ("rgba", ""),
    "joint": ("name type", "origin parent child axis calibration dynamics limit mimic safety_controller"),
    "parent": ("link", ""),
    "child": ("link", ""),
    "axis": ("xyz", ""),
    "dynamics": ("damping friction", ""),
    "limit": ("lower upper effort velocity acceleration deceleration jerk", ""),
    "mimic": ("joint multiplier offset", ""),
}
_SPRINGS = ("springStiffness", "springReference", "spring_stiffness", "spring_reference")
_GREY = (0.7, 0.7, 0.7, 1.0)

Packages = str | Path | Sequence[str | Path] | Mapping[str, str | Path]


def _refuse_misspelt(element: Element) -> None:
    """Raise an error for misspelt names in the elements that are read."""
    if element.tag in _KNOWN:
        element.refuse_misspelt(*_KNOWN[element.tag])
        for child in element.children:
            _refuse_misspelt(child)


def _origin(element: Element) -> FloatArray:
    """Return the transformation of <origin xyz rpy>: turned about fixed x, y and z axes."""
    origin = element.only("origin")
    if origin is None:
        return np.eye(4)
    roll, pitch, yaw = origin.numbers("rpy", 3, "0 0 0")
    about_z, about_y, about_x = (RotXYZ2RotationMatrix(angles) for angles in ([0, 0, yaw], [0, pitch, 0], [roll, 0, 0]))
    return translated(origin.numbers("xyz", 3, "0 0 0")) @ turned(about_z @ about_y @ about_x)


def _inertial(link: Element) -> RigidBodyInertia | None:
    element = link.only("inertial")
    if element is None:
        return None
    mass = element.needed("mass").amount("value")
    tensor = element.needed("inertia")
    xx, xy, xz, yy, yz, zz = (tensor.number(f"i{pair}") for pair in ("xx", "xy", "xz", "yy", "yz", "zz"))
    return inertia_in_file(tensor, mass, np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])).Transformed(
        _origin(element)
    )


class _Files:
    """Finds the meshes of a file: in its folder, and in packages."""

    def __init__(self, file: Path, packages: Packages | None) -> None:
        self.folder = file.resolve().parent
        self.named: dict[str, Path] = {}
        self.folders: list[Path] = []
        if isinstance(packages, Mapping):
            self.named = {name: Path(folder) for name, folder in packages.items()}
        elif isinstance(packages, str | Path):
            self.folders = [Path(packages)]
        elif packages is not None:
            self.folders = [Path(folder) for folder in packages]

    def find(self, element: Element) -> Path:
        """Return the path of <mesh filename>."""
        name = element.text("filename")
        tried = [path for path in self._candidates(name) if path.is_file()]
        if not tried:
            element.fail(
                f"there is no file '{name}'; give the folder of its package as packages, or graphics=False to leave "
                "shapes out"
            )
        return tried[0]

    def _candidates(self, name: str) -> list[Path]:
        if not name.startswith("package://"):
            own = Path(name.removeprefix("file://"))
            return [self.folder / own, *(folder / own for folder in self.folders)]
        package, _, rest = name.removeprefix("package://").partition("/")
        if package in self.named:
            return [self.named[package] / rest]
        around = [*self.folders, self.folder, *self.folder.parents]
        inside = [folder / rest for folder in around if folder.name == package]
        return [folder / package / rest for folder in around] + inside


def _shape(geometry: Element, files: _Files) -> _shapes.Shape:
    for element in geometry.children:
        match element.tag:
            case "box":
                return _shapes.Shape("box", tuple(element.numbers("size", 3)))
            case "sphere":
                return _shapes.Shape("sphere", (element.amount("radius"),))
            case "cylinder" | "capsule":
                return _shapes.Shape(element.tag, (element.amount("radius"), element.amount("length")))
            case "mesh":
                try:
                    return _shapes.mesh(files.find(element), element.numbers("scale", 3, "1 1 1"))
                except ImportError as error:
                    element.fail(f"{error}; or give graphics=False to leave shapes out")
    geometry.fail("expected <box>, <cylinder>, <sphere> or <mesh> in it")


def _color(visual: Element, materials: dict[str, FloatArray]) -> Any:
    material = visual.only("material")
    if material is None:
        return _GREY
    own = material.only("color")
    return own.numbers("rgba", 4) if own is not None else materials.get(material.text("name", ""), _GREY)


def _link(element: Element, materials: dict[str, FloatArray], files: _Files | None) -> Body:
    body = Body(element.text("name"), element, _inertial(element))
    for visual in element.every("visual") if files is not None else ():
        assert files is not None
        parts = _shapes.drawn(_shape(visual.needed("geometry"), files), _color(visual, materials))
        body.drawn += _drawing.moved(parts, _origin(visual))
    return body


def _joint_values(element: Element, kind: str) -> dict[str, Any]:
    """Return limits, damping and friction as arguments of RobotLink."""
    values: dict[str, Any] = {}
    limit, dynamics = element.only("limit"), element.only("dynamics")
    if limit is None and kind in ("revolute", "prismatic"):
        element.fail(f"joint '{element.text('name')}' of type {kind}: expected an element <limit> in it")
    if limit is not None:
        if kind != "continuous":
            lower, upper = limit.number("lower", "0"), limit.number("upper", "0")
            if lower > upper:
                limit.fail(f"expected lower <= upper, received {lower:g} and {upper:g}")
            values["jointLimits"] = [lower, upper]
        for name, argument in (("velocity", "maxVelocity"), ("effort", "maxForce")):
            if name in limit.attributes:
                values[argument] = limit.amount(name)
    if dynamics is not None:
        values |= {name: dynamics.amount(name, "0") for name in ("damping", "friction")}
    return values


def _joint(element: Element) -> Joint:
    name, kind = element.text("name"), element.text("type")
    if kind not in _KINDS:
        element.fail(f"joint '{name}': type: expected one of {', '.join(_KINDS)}, received '{kind}'")
    parent, child = (element.needed(end).text("link") for end in ("parent", "child"))
    joint = Joint(name, _KINDS[kind], parent, child, _origin(element), element)
    if kind in ("revolute", "continuous", "prismatic"):
        joint.values = _joint_values(element, kind)
        mimic = element.only("mimic")
        if mimic is not None:
            factors = mimic.number("multiplier", "1"), mimic.number("offset", "0")
            joint.values["follows"] = (mimic.text("joint"), *factors)
    axis = element.only("axis")
    if axis is not None and kind not in ("fixed", "floating"):
        direction = axis.numbers("xyz", 3)
        if not np.any(direction):
            axis.fail("xyz: expected a vector that is not zero")
        joint.axis = direction / np.linalg.norm(direction)
    return joint


def _unique(things: Sequence[Body | Joint], what: str) -> None:
    seen: dict[str, Body | Joint] = {}
    for thing in things:
        if thing.name in seen:
            thing.where.fail(f"there is a {what} '{thing.name}' in line {seen[thing.name].where.line} already")
        seen[thing.name] = thing


def _resolve_followers(joints: list[Joint]) -> None:
    """Let joints that follow followers follow the joint at the end of the chain, which moves by itself."""
    movable = {joint.name: joint for joint in joints if joint.kind in ("revolute", "prismatic")}
    followers = {joint.name: joint.values["follows"] for joint in joints if "follows" in joint.values}
    for joint in joints:
        if "follows" not in joint.values:
            continue
        leader, factor, offset = joint.values["follows"]
        seen = {joint.name}
        while leader in followers and leader not in seen:
            seen.add(leader)
            leader, own_factor, own_offset = followers[leader]
            factor, offset = factor * own_factor, offset + factor * own_offset
        if leader not in movable or leader in followers:
            known = ", ".join(name for name in movable if name not in followers)
            joint.where.fail(f"joint '{joint.name}': mimic: expected a joint that moves by itself, of {known}")
        joint.values["follows"] = (leader, factor, offset)


def _descendants(element: Element) -> Iterator[Element]:
    for child in element.children:
        yield child
        yield from _descendants(child)


def _warn_of_what_is_left_out(fileName: str | Path, root: Element) -> None:
    """Warn of unsupported elements that affect the motion in other programs; reject macros."""
    left = []
    for element in _descendants(root):
        if element.tag.startswith("xacro:"):
            element.fail("this is a macro; run xacro of ROS on the file first")
    for joint in root.every("joint"):
        kind, name = joint.text("type"), joint.text("name")
        given = [tag for tag in ("limit", "dynamics", "mimic") if joint.only(tag)]
        if kind in ("planar", "floating") and given:
            left.append(f"<{'>, <'.join(given)}> of joint '{name}' ({kind})")
    for gazebo in root.every("gazebo"):
        if any(element.tag in _SPRINGS for element in _descendants(gazebo)):
            left.append(f"springs of <gazebo reference='{gazebo.text('reference', '')}'>")
    transmissions = [element.text("name", "") for element in root.every("transmission")]
    if transmissions:
        left.append(f"<transmission> {', '.join(map(repr, transmissions))}")
    if left:
        warnings.warn(f"{fileName}: left out: {', '.join(left)}", stacklevel=4)


def read_urdf(
    fileName: str | Path, packages: Packages | None = None, shapes: bool = True, text: str | None = None
) -> Description:
    """Return the description in a URDF file, or in a text; errors are raised as ValueError with file and line."""
    root = read(fileName, text)
    if root.tag != "robot":
        root.fail("expected <robot> as the first element of a URDF file")
    _refuse_misspelt(root)
    files = _Files(Path(fileName), packages) if shapes else None
    colored = ((material, material.only("color")) for material in root.every("material"))
    materials = {material.text("name"): color.numbers("rgba", 4) for material, color in colored if color is not None}
    bodies = [_link(element, materials, files) for element in root.every("link")]
    joints = [_joint(element) for element in root.every("joint")]
    _unique(bodies, "link")
    _unique(joints, "joint")
    _resolve_followers(joints)
    _warn_of_what_is_left_out(fileName, root)
    if not bodies:
        root.fail("expected an element <link> in it")
    named = {body.name: body for body in bodies}
    return Description(root.text("name", ""), named, joints, root_of(named, joints))
