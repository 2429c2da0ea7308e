"""Robots from MJCF files, as MuJoCo uses them (https://mujoco.readthedocs.io/en/stable/XMLreference.html).

Bodies, joints, geoms and sites become links, joints, shapes and frames; actuators, tendons, equality constraints and
keyframes are added to the robot that these make, and contacts if they are wanted. A warning lists ignored elements,
such as muscles.
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
from dalembert.robotics import _drawing, _mjcf_inertia, _shapes
from dalembert.robotics._description import Body, Description, Joint, translated, turned
from dalembert.robotics._mjcf_actuators import Actuators
from dalembert.robotics._mjcf_attach import opened
from dalembert.robotics._mjcf_compiler import Compiler
from dalembert.robotics._mjcf_contacts import Contacts
from dalembert.robotics._mjcf_elements import JOINT_KINDS, WORLD, Content, Notes, Options, left_out
from dalembert.robotics._mjcf_equality import Equality
from dalembert.robotics._mjcf_keyframes import Keyframes
from dalembert.robotics._mjcf_tendons import Tendons, site_frame
from dalembert.robotics._xml import Element

_SIZES = {"sphere": 1, "capsule": 2, "cylinder": 2, "ellipsoid": 3, "box": 3}
_UNSHAPED = ("plane", "hfield", "sdf")
_NOT_READ = ("composite", "flexcomp", "plugin")
_SAME_VOLUME = 1e-6  # relative differences between ways to weigh meshes that do not count


def _shape(geom: Element, compiler: Compiler) -> tuple[_shapes.Shape | None, FloatArray]:
    """Return the shape of a geom and its pose; None for shapes without a finite extent."""
    kind = geom.text("type", "sphere")
    place = compiler.place(geom)
    if kind in _UNSHAPED:
        return None, place
    if kind == "mesh":
        return compiler.mesh(geom), place
    if kind not in _SIZES:
        geom.fail(f"type: expected one of {', '.join([*_SIZES, 'mesh', *_UNSHAPED])}, received '{kind}'")
    if "mesh" in geom.attributes:
        geom.fail(
            f"mesh: MuJoCo fits a {kind} to this mesh, because its type is '{kind}' (default: 'sphere'), which is not "
            "supported; use type='mesh', or remove mesh and give size"
        )
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


class _Reader:
    """Goes through the bodies of a file."""

    def __init__(self, content: Content, contacts: Contacts) -> None:
        self.contacts = contacts
        self.compiler, self.options, self.notes = content.compiler, content.options, content.notes
        self.bodies, self.joints = content.bodies, content.joints

    def _body(self, element: Element, name: str) -> Body:
        if name in self.bodies:
            other = self.bodies[name].where
            file = "" if other.file == element.file else f" of '{Path(other.file).name}'"
            element.fail(f"there is a body '{name}' in line {other.line}{file} already")
        self.bodies[name] = Body(name, element)
        return self.bodies[name]

    def _parts(self, element: Element, T: FloatArray, child_class: str) -> Iterator[tuple[Element, FloatArray, str]]:
        """Give the children of a body, also those in <frame>, with the transformation from the body and their class."""
        for child in element.children:
            if child.tag == "frame":
                inner = child.text("childclass", child_class)
                yield from self._parts(child, T @ self.compiler.of(child).place(child), inner)
            else:
                yield child, T, child_class

    def bodies_of(self, element: Element, name: str, child_class: str) -> None:
        """Take over a body with its shapes, joints and the bodies on it."""
        body = self._body(element, name)
        weighed = RigidBodyInertia()
        given, from_shapes = element.only("inertial"), self.compiler.of(element).from_shapes
        for part, T, own_class in list(self._parts(element, np.eye(4), child_class)):
            compiler = self.compiler.of(part)
            if part.tag == "geom":
                geom = compiler.complete(part, own_class)
                needs_inertia = name != WORLD and (given is None or from_shapes == "true")
                weighed = weighed + self._geom(geom, T, body, needs_inertia)
            elif part.tag == "site":
                site = compiler.complete(part, own_class)
                body.frames[site.text("name", f"{name} site {len(body.frames)}")] = T @ _site(site, compiler)
            elif part.tag in _NOT_READ:
                self.notes.add(f"<{part.tag}> in bodies", name)
            elif part.tag == "body":
                self._carried(part, T, name, part.text("childclass", own_class))
        if given is not None and from_shapes != "true":
            body.inertia = _mjcf_inertia.of_element(given, self.compiler.of(given))
        elif from_shapes != "false":
            body.inertia = weighed

    def rename_sites(self) -> None:
        """Give sites with the name of a body another name: frames of robots have one name space for both."""
        for body in self.bodies.values():
            for name in [frame for frame in body.frames if frame in self.bodies]:
                self.notes.add("names of sites that are names of bodies (the sites are called 'name (site)')", name)
                body.frames[site_frame(name, self.bodies)] = body.frames.pop(name)

    def _geom(self, geom: Element, T: FloatArray, body: Body, needs_inertia: bool) -> RigidBodyInertia:
        """Draw a geom, and return its inertia if it counts."""
        compiler = self.compiler.of(geom)
        kind = geom.text("type", "sphere")
        needs_inertia = needs_inertia and int(geom.number("group", "0")) in compiler.weighed_groups
        if needs_inertia and kind == "sdf":
            self.notes.add("mass of geoms of type sdf of bodies", body.name)
        if kind == "mesh" and not (compiler.shapes or needs_inertia):
            shape, place = None, np.eye(4)
        else:
            shape, place = _shape(geom, compiler)
        self.contacts.take(geom, body.name, shape, T @ place)
        if shape is None:
            return RigidBodyInertia()
        if compiler.shapes:
            material = compiler.materials.get(geom.text("material", ""))
            color = material.text("rgba", "1 1 1 1") if material is not None else "0.5 0.5 0.5 1"
            body.drawn += _drawing.moved(_shapes.drawn(shape, geom.numbers("rgba", 4, color).tolist()), T @ place)
        if not needs_inertia:
            return RigidBodyInertia()
        if _mjcf_inertia.is_shell(geom) and _shapes.shell_inertia(shape, 1.0) is None:
            self.notes.add("shellinertia of ellipsoids and meshes, which are taken for solid, of bodies", body.name)
        if shape.kind == "mesh" and (other := self._other_volume(geom, shape)):
            self.notes.add(f"{other} of meshes, which exact volumes replace, of bodies", body.name)
        return _mjcf_inertia.of_geom(geom, shape).Transformed(T @ place)

    def _other_volume(self, geom: Element, shape: _shapes.Shape) -> str:
        """Return how MuJoCo weighs a mesh if that makes a difference."""
        assert shape.corners is not None
        compiler = self.compiler.of(geom)
        asset = compiler.complete(compiler.meshes[geom.text("mesh")], "main")
        way = asset.text("inertia", "legacy")
        if way == "legacy" and "mass" not in geom.attributes:
            exact, legacy = _shapes.volumes(shape.corners)
            return "legacy inertia" if abs(exact - legacy) > _SAME_VOLUME * legacy else ""
        return f"{way} inertia" if way in ("convex", "shell") else ""

    def _carried(self, element: Element, T: FloatArray, parent: str, child_class: str) -> None:
        """Add the joints between a body and its parent, with a body without mass between two of them."""
        name = element.text("name", f"body{len(self.bodies)}")
        place = T @ self.compiler.of(element).place(element)
        if element.text("mocap", "false") == "true":
            self.notes.add("mocap of bodies", name)
        joints = [
            self._joint(part, own_class, frame)
            for part, frame, own_class in self._parts(element, np.eye(4), child_class)
            if part.tag in ("joint", "freejoint")
        ]
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
        if self.options.passive:
            self.bodies[name].supported = element.number("gravcomp", "0")

    def _joint(self, element: Element, child_class: str, frame: FloatArray) -> Joint:
        """Return a joint; frame leads from the body to the <frame> that it is in."""
        if element.tag == "freejoint":
            if element.text("align", "auto") == "true":
                self.notes.add("align of free joints", element.text("name", ""))
            return Joint(element.text("name", ""), "floating", "", "", np.eye(4), element)
        compiler = self.compiler.of(element)
        element = compiler.complete(element, child_class)
        kind = element.text("type", "hinge")
        if kind not in JOINT_KINDS:
            element.fail(f"type: expected one of {', '.join(JOINT_KINDS)}, received '{kind}'")
        joint = Joint(element.text("name", ""), JOINT_KINDS[kind], "", "", np.eye(4), element)
        place = (frame @ np.append(element.numbers("pos", 3, "0 0 0"), 1))[:3]
        if kind in ("ball", "free"):
            joint.place = place if kind == "ball" else np.zeros(3)
            damping = 0.0 if "damper" in self.options.off else self._linear(element, "damping", joint)
            joint.values = {"damping": damping, "rotorInertia": element.amount("armature", "0")}
            self._note_of_several(element, joint)
            return joint
        turns = compiler.angle if kind == "hinge" else float
        axis = element.numbers("axis", 3, "0 0 1")
        joint.axis = frame[:3, :3] @ axis / compiler.length(element, "axis", axis)
        joint.place = place
        joint.reference = float(turns(element.number("ref", "0")))
        joint.values = self._resistance(element, joint, turns)
        if self._is_limited(element) and "limit" not in self.options.off:
            lower, upper = element.numbers("range", 2)
            if lower > upper:
                element.fail(f"range: expected two numbers that grow, received {lower:g} and {upper:g}")
            joint.values["jointLimits"] = [float(turns(lower)), float(turns(upper))]
        limited = element.text("actuatorfrclimited", "auto")
        given = compiler.autolimits and "actuatorfrcrange" in element.attributes
        if limited == "true" or (limited == "auto" and given):
            lower, upper = element.numbers("actuatorfrcrange", 2)
            joint.force_range = float(lower), float(upper)
            if element.text("actuatorgravcomp", "false") == "true":
                self.notes.add("actuatorgravcomp of joints with actuatorfrcrange:", joint.name)
            joint.values["maxForce"] = float(max(abs(lower), abs(upper)))
        return joint

    def _linear(self, element: Element, name: str, joint: Joint) -> float:
        """Return the constant of a linear law; polynomials have further coefficients."""
        first, *further = element.numbers(name, (1, 3), "0")
        if any(further):
            self.notes.add(f"coefficients of higher order of {name} of joints", joint.name)
        return float(first) if first >= 0 else element.amount(name)

    def _resistance(self, element: Element, joint: Joint, turns: Any) -> dict[str, Any]:
        """Return rotor, spring, damping and friction of a joint of one coordinate as arguments of a link."""
        values: dict[str, Any] = {"rotorInertia": element.amount("armature", "0")}
        if "frictionloss" not in self.options.off:
            values["friction"] = element.amount("frictionloss", "0")
        if "damper" not in self.options.off:
            values["damping"] = self._linear(element, "damping", joint)
        if "spring" not in self.options.off:
            values["stiffness"] = self._linear(element, "stiffness", joint)
        values["springReference"] = float(turns(element.number("springref", "0")))
        time, ratio = element.numbers("springdamper", 2, "0 0")
        if time > 0 and ratio > 0:
            stiffness = 0.0 if "spring" in self.options.off else 1 / (time * ratio) ** 2
            joint.per_inertia = stiffness, 0.0 if "damper" in self.options.off else 2 / time
        return values

    def _is_limited(self, element: Element) -> bool:
        limited = element.text("limited", "auto")
        return limited == "true" or (
            limited == "auto" and self.compiler.of(element).autolimits and "range" in element.attributes
        )

    def _note_of_several(self, element: Element, joint: Joint) -> None:
        """Record differences of ball and free joints, whose coordinates are angles here."""
        for name in ("frictionloss", "stiffness", "springdamper"):
            if element.numbers(name, (1, 3), "0").any():
                self.notes.add(f"{name} of ball and free joints", joint.name)
        if joint.kind == "ball" and self._is_limited(element):
            self.notes.add("range of ball joints", joint.name)
        for name, value in joint.values.items():
            if value:
                own = {"rotorInertia": "armature"}.get(name, name)
                self.notes.add(
                    f"{own} against angular velocities, which acts on rates of angles, of joints", joint.name
                )


def _site(site: Element, compiler: Compiler) -> FloatArray:
    """Return where a site is, which may be given by the ends of its z axis."""
    if "fromto" not in site.attributes:
        return compiler.place(site)
    start, end = site.numbers("fromto", 6).reshape(2, 3)
    return translated(0.5 * (start + end)) @ turned(compiler.from_z(start - end, site))


def read_mjcf(fileName: str | Path, shapes: bool = True, contacts: bool = False) -> Description:
    """Return the description in an MJCF file; errors are raised as ValueError with file and line."""
    notes = Notes()
    root, compiler = opened(fileName, shapes, notes)
    content = Content(root, compiler, Options(root), notes)
    touching = Contacts(content, contacts)
    reader = _Reader(content, touching)
    worlds = list(root.every("worldbody"))
    world = replace(root, tag="worldbody", children=[child for element in worlds for child in element.children])
    reader.bodies_of(world, WORLD, world.text("childclass", "main"))
    if len(content.bodies) == 1:
        root.fail("expected an element <body> in <worldbody>")
    _mjcf_inertia.finish([body for name, body in content.bodies.items() if name != WORLD], compiler)
    reader.rename_sites()
    tendons = Tendons(content)
    actuators = Actuators(content, tendons)
    equality, keyframes = Equality(content, tendons), Keyframes(content, actuators)
    touching.finish()
    left = left_out(root, contacts) + content.notes.texts()
    if left:
        warnings.warn(f"{fileName}: ignored elements: {', '.join(left)}", stacklevel=3)
    later = [each.complete for each in (tendons, actuators, equality, keyframes, touching)]
    name, gravity = root.text("model", ""), content.options.gravity
    return Description(name, content.bodies, content.joints, WORLD, gravity, [*later])
