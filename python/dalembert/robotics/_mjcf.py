"""Robots from MJCF files, as MuJoCo uses them (https://mujoco.readthedocs.io/en/stable/XMLreference.html).

Bodies, joints, geoms and sites become links, joints, shapes and frames. What has no counterpart in a robot, actuators,
tendons, equality constraints and contacts among it, is left out with a warning.
"""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._geometry.inertia import RigidBodyInertia
from dalembert._geometry.rotations import (
    EulerParameters2RotationMatrix,
    RotationMatrixX,
    RotationMatrixY,
    RotationMatrixZ,
    RotationVector2RotationMatrix,
)
from dalembert.robotics import _drawing, _shapes
from dalembert.robotics._description import Body, Description, Joint, inertia_in_file, translated, turned
from dalembert.robotics._xml import Element, read

_LEFT_OUT = ("actuator", "contact", "deformable", "equality", "tendon")
_TURNS = {"x": RotationMatrixX, "y": RotationMatrixY, "z": RotationMatrixZ}
_JOINTS = {"hinge": "revolute", "slide": "prismatic", "ball": "ball", "free": "floating"}
_SIZES = {"sphere": 1, "capsule": 2, "cylinder": 2, "ellipsoid": 3, "box": 3}
_UNSHAPED = ("plane", "hfield", "sdf")
_WORLD = "world"
_ROTATIONS = "pos quat axisangle euler xyaxes zaxis"
_BODY_PARTS = (
    "inertial joint freejoint geom attach site camera light plugin composite flexcomp body frame replicate include"
)
# Attributes and children of the elements that count. MuJoCo has more elements, and plugins more
# attributes; what is nearly one of these is misspelt.
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


def _refuse_misspelt(element: Element) -> None:
    """Refuse misspelt names in compiler, defaults and bodies; in the others, nothing is read."""
    if element.tag in _KNOWN:
        element.refuse_misspelt(*_KNOWN[element.tag])
    for child in element.children:
        if element.tag in ("mujoco", "default", *_KNOWN) and child.tag in ("default", *_KNOWN):
            _refuse_misspelt(child)


def _included(element: Element, folder: Path) -> Element:
    """Return an element with the contents of files in the place of <include file>."""
    children = []
    for child in element.children:
        if child.tag == "include":
            path = folder / child.text("file")
            if not path.is_file():
                child.fail(f"there is no file '{child.text('file')}'")
            children += _included(read(path), folder).children
        else:
            children.append(_included(child, folder))
    return replace(element, children=children)


class _Compiler:
    """What a file says of all its elements: units, defaults of classes, assets."""

    def __init__(self, root: Element, folder: Path, shapes: bool) -> None:
        settings: dict[str, str] = {}
        for element in root.every("compiler"):
            settings |= element.attributes
        if settings.get("coordinate", "local") != "local":
            root.fail("compiler: coordinate='global' is of the past; write the file anew with MuJoCo 2.3")
        self.degrees = settings.get("angle", "degree") == "degree"
        self.autolimits = settings.get("autolimits", "true") == "true"
        self.sequence = settings.get("eulerseq", "xyz")
        self.from_shapes = settings.get("inertiafromgeom", "auto")
        self.folder, self.shapes = folder / settings.get("meshdir", settings.get("assetdir", "")), shapes
        self.classes: dict[str, dict[str, dict[str, str]]] = {"main": {}}
        for element in root.every("default"):
            name = element.text("class", "main")
            self._add_class(element, {}, name)
            self.classes["main"] = self.classes[name]
        assets = [asset for group in root.every("asset") for asset in group.children]
        self.materials = {asset.text("name"): asset for asset in assets if asset.tag == "material"}
        self.meshes = {self._asset_name(asset): asset for asset in assets if asset.tag == "mesh"}

    @staticmethod
    def _asset_name(asset: Element) -> str:
        return asset.text("name", Path(asset.text("file", "")).stem)

    def _add_class(self, element: Element, inherited: dict[str, dict[str, str]], name: str) -> None:
        own = {tag: dict(values) for tag, values in inherited.items()}
        for child in element.children:
            if child.tag != "default":
                own[child.tag] = own.get(child.tag, {}) | child.attributes
        self.classes[name] = own
        for child in element.every("default"):
            self._add_class(child, own, child.text("class"))

    def complete(self, element: Element, child_class: str) -> Element:
        """Return an element with the defaults of its class."""
        name = element.attributes.get("class", child_class)
        if name not in self.classes:
            element.fail(f"class: there is no default class '{name}'; there are: {', '.join(self.classes)}")
        return replace(element, attributes=self.classes[name].get(element.tag, {}) | element.attributes)

    def angle(self, values: Any) -> Any:
        """Return angles of the file in rad."""
        return np.deg2rad(values) if self.degrees else values

    def rotation(self, element: Element) -> FloatArray:
        """Return the rotation of an element, in whatever way it is given."""
        given = element.attributes.keys() & {"quat", "axisangle", "euler", "xyaxes", "zaxis"}
        if len(given) > 1:
            element.fail(f"expected one way to give a rotation, received {', '.join(sorted(given))}")
        match next(iter(given), ""):
            case "quat":
                q = element.numbers("quat", 4)
                return EulerParameters2RotationMatrix(q / self.length(element, "quat", q))
            case "axisangle":
                *axis, angle = element.numbers("axisangle", 4)
                return RotationVector2RotationMatrix(
                    self.angle(angle) * np.array(axis) / self.length(element, "axisangle", axis)
                )
            case "euler":
                return self._euler(self.angle(element.numbers("euler", 3)))
            case "xyaxes":
                x, y = element.numbers("xyaxes", 6).reshape(2, 3)
                x = x / self.length(element, "xyaxes", x)
                y = y - (x @ y) * x
                y = y / self.length(element, "xyaxes", y)
                return np.column_stack([x, y, np.cross(x, y)])
            case "zaxis":
                return self.from_z(element.numbers("zaxis", 3), element)
        return np.eye(3)

    def _euler(self, angles: FloatArray) -> FloatArray:
        A = np.eye(3)
        for letter, angle in zip(self.sequence, angles, strict=True):
            turn = _TURNS[letter.lower()](angle)
            A = A @ turn if letter.islower() else turn @ A
        return A

    @staticmethod
    def length(element: Element, name: str, vector: Any) -> float:
        length = float(np.linalg.norm(vector))
        return length if length > 0 else element.fail(f"{name}: expected a vector that is not zero")

    def from_z(self, direction: FloatArray, element: Element) -> FloatArray:
        """Return the smallest rotation that turns the z axis to a direction."""
        d = direction / self.length(element, "zaxis", direction)
        axis = np.cross([0, 0, 1], d)
        sine = np.linalg.norm(axis)
        if sine < 1e-12:
            return np.eye(3) if d[2] > 0 else RotationMatrixX(np.pi)
        return RotationVector2RotationMatrix(np.arctan2(sine, d[2]) * axis / sine)

    def place(self, element: Element) -> FloatArray:
        """Return the transformation of pos and rotation."""
        return translated(element.numbers("pos", 3, "0 0 0")) @ turned(self.rotation(element))

    def mesh(self, geom: Element) -> _shapes.Shape:
        """Return the mesh of a geom."""
        name = geom.text("mesh")
        if name not in self.meshes:
            geom.fail(f"mesh: there is no <mesh name='{name}'> among the assets")
        asset = self.complete(self.meshes[name], "main")
        path = self.folder / asset.text("file")
        if not path.is_file():
            asset.fail(f"there is no file '{path}'; graphics=False leaves shapes out")
        try:
            return _shapes.mesh(path, asset.numbers("scale", 3, "1 1 1"))
        except ImportError as error:
            asset.fail(f"{error}; graphics=False leaves shapes out")


def _shape(geom: Element, compiler: _Compiler) -> tuple[_shapes.Shape | None, FloatArray]:
    """Return the shape of a geom and where it is; None for shapes without an extent that could be drawn or weighed."""
    kind = geom.text("type", "mesh" if "mesh" in geom.attributes and "type" not in geom.attributes else "sphere")
    place = compiler.place(geom)
    if kind in _UNSHAPED:
        return None, place
    if kind == "mesh":
        return compiler.mesh(geom), place
    if kind not in _SIZES:
        geom.fail(f"type: expected one of {', '.join([*_SIZES, 'mesh', *_UNSHAPED])}, received '{kind}'")
    if "fromto" in geom.attributes and kind != "sphere":
        start, end = geom.numbers("fromto", 6).reshape(2, 3)
        place = translated(0.5 * (start + end)) @ turned(compiler.from_z(start - end, geom))
        size = geom.numbers("size", (1, 3))[: _SIZES[kind] - 1]
        size = np.append(np.resize(size, _SIZES[kind] - 1), 0.5 * np.linalg.norm(end - start))
    else:
        size = geom.numbers("size", (_SIZES[kind], 3))[: _SIZES[kind]]
    if (size <= 0).any():
        geom.fail(f"size: expected positive numbers, received {size.tolist()}")
    factors = {"box": (2, 2, 2), "capsule": (1, 2), "cylinder": (1, 2)}.get(kind, (1, 1, 1))  # halves of lengths
    return _shapes.Shape(kind, tuple(float(a * b) for a, b in zip(factors, size, strict=False))), place


def _weighed(geom: Element, shape: _shapes.Shape) -> RigidBodyInertia:
    """Return the inertia of a geom with its mass or density."""
    inertia = _shapes.inertia(shape, geom.amount("density", "1000"))
    if "mass" not in geom.attributes:
        return inertia
    whole = _shapes.inertia(shape, 1.0)
    return _shapes.inertia(shape, geom.amount("mass") / whole.Mass())


def _inertial(element: Element, compiler: _Compiler) -> RigidBodyInertia:
    if "fullinertia" in element.attributes:
        xx, yy, zz, xy, xz, yz = element.numbers("fullinertia", 6)
        tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    else:
        tensor = np.diag(element.numbers("diaginertia", 3))
    return inertia_in_file(element, element.amount("mass"), tensor).Transformed(compiler.place(element))


class _Reader:
    """Goes through the bodies of a file."""

    def __init__(self, compiler: _Compiler) -> None:
        self.compiler = compiler
        self.bodies: dict[str, Body] = {}
        self.joints: list[Joint] = []
        self.springs: list[str] = []

    def _body(self, element: Element, name: str) -> Body:
        if name in self.bodies:
            element.fail(f"there is a body '{name}' in line {self.bodies[name].where.line} already")
        self.bodies[name] = Body(name, element)
        return self.bodies[name]

    def _parts(self, element: Element, T: FloatArray, child_class: str) -> Iterator[tuple[Element, FloatArray, str]]:
        """Give the children of a body, also those in <frame>, with the transformation from the body and their class."""
        for child in element.children:
            if child.tag == "frame":
                inner = child.text("childclass", child_class)
                yield from self._parts(child, T @ self.compiler.place(child), inner)
            else:
                yield child, T, child_class

    def bodies_of(self, element: Element, name: str, child_class: str) -> None:
        """Take over a body with its shapes, joints and the bodies on it."""
        body = self._body(element, name)
        weighed = RigidBodyInertia()
        given = element.only("inertial")
        for part, T, own_class in list(self._parts(element, np.eye(4), child_class)):
            if part.tag == "geom":
                geom = self.compiler.complete(part, own_class)
                needs_inertia = name != _WORLD and (given is None or self.compiler.from_shapes == "true")
                weighed = weighed + self._geom(geom, T, body, needs_inertia)
            elif part.tag == "site":
                body.frames[part.text("name", f"{name} site {len(body.frames)}")] = T @ self.compiler.place(part)
            elif part.tag == "body":
                self._carried(part, T, name, part.text("childclass", own_class))
        if given is not None and self.compiler.from_shapes != "true":
            body.inertia = _inertial(given, self.compiler)
        elif self.compiler.from_shapes != "false":
            body.inertia = weighed

    def _geom(self, geom: Element, T: FloatArray, body: Body, needs_inertia: bool) -> RigidBodyInertia:
        """Draw a geom, and return its inertia if it counts."""
        kind = geom.attributes.get("type", "mesh" if "mesh" in geom.attributes else "sphere")
        if not self.compiler.shapes and (kind == "mesh") and not needs_inertia:
            return RigidBodyInertia()
        shape, place = _shape(geom, self.compiler)
        if shape is None:
            return RigidBodyInertia()
        if self.compiler.shapes:
            material = self.compiler.materials.get(geom.text("material", ""))
            color = material.text("rgba", "1 1 1 1") if material is not None else "0.5 0.5 0.5 1"
            body.drawn += _drawing.moved(_shapes.drawn(shape, geom.numbers("rgba", 4, color).tolist()), T @ place)
        return _weighed(geom, shape).Transformed(T @ place) if needs_inertia else RigidBodyInertia()

    def _carried(self, element: Element, T: FloatArray, parent: str, child_class: str) -> None:
        """Add the joints between a body and its parent, with a body without mass between two of them."""
        name = element.text("name", f"body{len(self.bodies)}")
        place = T @ self.compiler.place(element)
        parts = [
            part for part, _, _ in self._parts(element, np.eye(4), child_class) if part.tag in ("joint", "freejoint")
        ]
        joints = [self._joint(part, child_class) for part in parts]
        if not joints:
            joints = [Joint("", "fixed", "", "", np.eye(4), element)]
        for i, joint in enumerate(joints):
            last = i == len(joints) - 1
            child = name if last else f"{name}:{i}"
            if not last:
                self._body(element, child)
            self.joints.append(replace(joint, parent=parent, child=child, T=place))
            parent, place = child, np.eye(4)
        self.bodies_of(element, name, child_class)

    def _joint(self, element: Element, child_class: str) -> Joint:
        if element.tag == "freejoint":
            return Joint(element.text("name", ""), "floating", "", "", np.eye(4), element)
        element = self.compiler.complete(element, child_class)
        kind = element.text("type", "hinge")
        if kind not in _JOINTS:
            element.fail(f"type: expected one of {', '.join(_JOINTS)}, received '{kind}'")
        joint = Joint(element.text("name", ""), _JOINTS[kind], "", "", np.eye(4), element)
        if kind in ("ball", "free"):
            joint.place = element.numbers("pos", 3, "0 0 0") if kind == "ball" else np.zeros(3)
            joint.values = {"damping": element.amount("damping", "0"), "rotorInertia": element.amount("armature", "0")}
            return joint
        turns = self.compiler.angle if kind == "hinge" else float
        axis = element.numbers("axis", 3, "0 0 1")
        joint.axis = axis / self.compiler.length(element, "axis", axis)
        joint.place = element.numbers("pos", 3, "0 0 0")
        joint.reference = float(turns(element.number("ref", "0")))
        amounts = {"damping": "damping", "frictionloss": "friction", "armature": "rotorInertia"}
        joint.values = {argument: element.amount(name, "0") for name, argument in amounts.items()}
        limited = element.text("limited", "auto")
        if limited == "true" or (limited == "auto" and self.compiler.autolimits and "range" in element.attributes):
            lower, upper = element.numbers("range", 2)
            if lower > upper:
                element.fail(f"range: expected two numbers that grow, received {lower:g} and {upper:g}")
            joint.values["jointLimits"] = [float(turns(lower)), float(turns(upper))]
        if "actuatorfrcrange" in element.attributes:
            joint.values["maxForce"] = float(np.abs(element.numbers("actuatorfrcrange", 2)).max())
        if element.number("stiffness", "0"):
            self.springs.append(joint.name)
        return joint


def read_mjcf(fileName: str | Path, shapes: bool = True) -> Description:
    """Return what an MJCF file says; ValueError with file and line of what is wrong."""
    folder = Path(fileName).resolve().parent
    root = read(fileName)
    if root.tag != "mujoco":
        root.fail("expected <mujoco> as the first element of an MJCF file")
    root = _included(root, folder)
    _refuse_misspelt(root)
    reader = _Reader(_Compiler(root, folder, shapes))
    worlds = list(root.every("worldbody"))
    world = replace(root, tag="worldbody", children=[child for element in worlds for child in element.children])
    reader.bodies_of(world, _WORLD, world.text("childclass", "main"))
    if len(reader.bodies) == 1:
        root.fail("expected an element <body> in <worldbody>")
    left = [f"<{tag}>" for tag in _LEFT_OUT if any(element.children for element in root.every(tag))]
    if reader.springs:
        left.append(f"stiffness of joints {', '.join(map(repr, reader.springs))}")
    if left:
        warnings.warn(f"{fileName}: left out, as a robot has none of it: {', '.join(left)}", stacklevel=3)
    gravity = np.array([0.0, 0.0, -9.81])
    for option in root.every("option"):
        gravity = option.numbers("gravity", 3, "0 0 -9.81")
    return Description(root.text("model", ""), reader.bodies, reader.joints, _WORLD, gravity)
