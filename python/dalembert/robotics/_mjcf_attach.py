"""Attached models of MJCF files: parts of other files, with a prefix of their names and with their own settings."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from dalembert.robotics._mjcf_compiler import Compiler
from dalembert.robotics._mjcf_elements import (
    JOINT_KINDS,
    POSITIONS,
    RATES,
    WORLD,
    Notes,
    Options,
    included,
    left_out,
    numbers_of,
    refuse_misspelt,
    repeated,
)
from dalembert.robotics._xml import Element, read

_SECTIONS = ("tendon", "equality", "actuator", "contact", "keyframe")
# Attributes of elements in these sections, by the kind of item that they name.
_NAMED = {
    "joint": ("joint", "joint1", "joint2", "jointinparent"),
    "body": ("body", "body1", "body2"),
    "geom": ("geom", "geom1", "geom2"),
    "site": ("site", "site1", "site2", "refsite", "cranksite", "slidersite", "sidesite"),
    "tendon": ("tendon", "tendon1", "tendon2"),
}
_KIND_OF = {attribute: kind for kind, attributes in _NAMED.items() for attribute in attributes}


def opened(
    fileName: str | Path, shapes: bool, notes: Notes, others: list[Compiler] | None = None, path: tuple[Path, ...] = ()
) -> tuple[Element, Compiler]:
    """Return the root of a file with everything that it includes, attaches and repeats, and its settings.

    others are the settings of the files that attach this one, and path has their names.
    """
    file = Path(fileName).resolve()
    root = read(fileName)
    if root.tag != "mujoco":
        root.fail("expected <mujoco> as the first element of an MJCF file")
    root = included(root, file.parent)
    refuse_misspelt(root)
    compiler = Compiler(root, file.parent, shapes, others)
    root = _Attachments(root, compiler, notes, (*path, file)).attached()
    root = repeated(root, compiler)
    for element in _within(root):
        element.model = element.model or compiler.number
    compiler.end = len(compiler.models)
    return root, compiler


def _within(element: Element) -> Iterator[Element]:
    """Give an element and all elements in it."""
    yield element
    for child in element.children:
        yield from _within(child)


class _Attachments:
    """Replaces <attach> in a file by frames with parts of other models."""

    def __init__(self, root: Element, compiler: Compiler, notes: Notes, path: tuple[Path, ...]) -> None:
        self.root, self.compiler, self.notes, self.path = root, compiler, notes, path
        self.options = Options(root)
        self.acting: list[Element] = []  # sections with what acts on attached bodies

    def attached(self) -> Element:
        """Return the root with attached bodies, and with the elements that act on them in sections at its end."""
        root = self._replaced(self.root)
        return replace(root, children=root.children + self.acting)

    def _replaced(self, element: Element) -> Element:
        children = [self._frame(each) if each.tag == "attach" else self._replaced(each) for each in element.children]
        return replace(element, children=children)

    def _frame(self, attach: Element) -> Element:
        """Return the frame with an attached body, or with all that is in the world of a model."""
        name, prefix = attach.text("model"), attach.text("prefix")
        file = self._file(attach, name)
        if file in self.path:
            attach.fail(f"model '{name}' in the file '{file.name}' attaches itself")
        root, compiler = opened(file, self.compiler.shapes, self.notes, self.compiler.models, self.path)
        self._note(root, name)
        world = Element("body", {"name": WORLD}, root.file, root.line, model=compiler.number)
        for each in root.every("worldbody"):
            world.attributes |= each.attributes
            world.children += each.children
        body = attach.text("body", "")
        parts = {part.text("name", ""): (part, own_class) for part, own_class in _bodies(world, "main")}
        if body and body not in parts:
            attach.fail(f"there is no body '{body}' in model '{name}'; there are: {', '.join(filter(None, parts))}")
        part, own_class = parts[body] if body else (world, world.text("childclass", "main"))
        self.acting += _Part(root, world, part, compiler, self.notes).sections(prefix)
        children = [part] if body else part.children
        frame = Element("frame", {"childclass": own_class}, attach.file, attach.line, children, compiler.number)
        for element in _within(part):
            _rename(element, prefix)
        return frame

    def _file(self, attach: Element, name: str) -> Path:
        """Return the file of a model of the assets, by its name there or in the file."""
        names = []
        for asset in (each for group in self.root.every("asset") for each in group.every("model")):
            file = self.path[-1].parent / asset.text("file")
            if not file.is_file():
                asset.fail(f"there is no file '{asset.text('file')}' in '{self.path[-1].parent}'")
            names.append(asset.text("name", "") or read(file).text("model", ""))
            if names[-1] == name:
                return file.resolve()
        attach.fail(f"there is no model '{name}' among the assets; there are: {', '.join(names) or 'none'}")

    def _note(self, root: Element, name: str) -> None:
        """Record settings of an attached model that those of the file replace, as in MuJoCo, and its ignored parts."""
        own, *others = (
            (options.off, options.groups_off, options.gravity.tolist())
            for options in (Options(root), self.options, Options(replace(root, children=[])))
        )
        if own not in others:
            self.notes.add("<option> of attached models", name)
        rest = [each for each in root.children if each.tag not in _SECTIONS]
        for what in left_out(replace(root, children=rest)):
            self.notes.add(f"{what} of attached models", name)


def _parts(element: Element, own_class: str) -> Iterator[tuple[Element, str]]:
    """Give the parts of a body, also those in frames, with the class around them."""
    own_class = element.text("childclass", own_class)
    for child in element.children:
        if child.tag == "frame":
            yield from _parts(child, own_class)
        else:
            yield child, own_class


def _bodies(element: Element, own_class: str) -> Iterator[tuple[Element, str]]:
    """Give a body and those on it, with the class around them."""
    yield element, own_class
    for part, inner in _parts(element, own_class):
        if part.tag == "body":
            yield from _bodies(part, inner)


def _joints(world: Element, compiler: Compiler) -> Iterator[tuple[Element, str]]:
    """Give the joints of bodies with their kinds, in the order of coordinates."""
    for body, own_class in _bodies(world, "main"):
        for part, inner in _parts(body, own_class):
            if part.tag == "freejoint":
                yield part, "floating"
            elif part.tag == "joint":
                kind = compiler.of(part).complete(part, inner).text("type", "hinge")
                yield part, JOINT_KINDS.get(kind, "revolute")


def _rename(element: Element, prefix: str) -> None:
    """Put a prefix before the names that an element has or refers to."""
    for attribute, name in element.attributes.items():
        kind = _KIND_OF.get(attribute)
        if name and (attribute == "name" or (kind and (kind, name) != ("body", WORLD))):
            element.attributes[attribute] = prefix + name


class _Part:
    """A part of a model that is attached, and the elements that act on nothing but this part."""

    def __init__(self, root: Element, world: Element, part: Element, compiler: Compiler, notes: Notes) -> None:
        self.root, self.compiler, self.notes = root, compiler, notes
        kept = {id(element) for element in _within(part)} if part is not world else None
        self.joints = list(_joints(world, compiler))
        self.is_kept = [kept is None or id(joint) in kept for joint, _ in self.joints]
        self.outside = {  # names in the model that are not in the part
            (element.tag.replace("freejoint", "joint"), element.attributes.get("name", ""))
            for element in _within(world)
            if kept is not None and id(element) not in kept
        } - {("body", WORLD)}

    def sections(self, prefix: str) -> list[Element]:
        """Return the elements that act on the part, with a prefix of their names."""
        found = []
        for tag in _SECTIONS:  # tendons before the elements that refer to them
            elements = [child for group in self.root.every(tag) for child in group.children]
            if tag == "tendon":
                self.outside |= {("tendon", each.text("name", "")) for each in elements if not self._acts(each)}
            if tag == "keyframe":
                elements = [self._key(element) for element in elements if element.tag == "key"]
            if kept := [element for element in elements if self._acts(element)]:
                found.append(Element(tag, {}, self.root.file, self.root.line, kept, self.compiler.number))
        for section in found:
            for element in _within(section):
                _rename(element, prefix)
        return found

    def _acts(self, element: Element) -> bool:
        """Return whether an element refers to nothing outside of the part."""
        given = [pair for each in _within(element) for pair in each.attributes.items() if pair[0] in _KIND_OF]
        return not self.outside.intersection((_KIND_OF[key], name) for key, name in given)

    def _key(self, key: Element) -> Element:
        """Return a keyframe of the joints and actuators of the part."""
        actuators = [child for group in self.root.every("actuator") for child in group.children]
        acting = [self._acts(each) for each in actuators]
        attributes = {name: value for name, value in key.attributes.items() if name in ("name", "time")}
        models = [joint.model for joint, _ in self.joints]
        for name, sizes, taken, owners in (
            ("qpos", [POSITIONS[kind] for _, kind in self.joints], self.is_kept, models),
            ("qvel", [RATES[kind] for _, kind in self.joints], self.is_kept, models),
            ("ctrl", [1] * len(actuators), acting, [each.model for each in actuators]),
        ):
            if name in key.attributes:
                parts = numbers_of(key, name, sizes, owners, self.compiler)
                kept = [part for part, holds in zip(parts, taken, strict=True) if holds and part is not None]
                attributes[name] = " ".join(repr(float(value)) for part in kept for value in part)
        if "act" in key.attributes and all(acting):
            attributes["act"] = key.attributes["act"]
        elif "act" in key.attributes:
            self.notes.add("act of keyframes of attached models", key.text("name", ""))
        return replace(key, attributes=attributes)
