"""The data model of an item: the contents of its spec file.

Every entity is a frozen dataclass that checks itself on construction, so a template never meets an invalid one.
This module is independent of C++, Python and RST, which are in `views`.
"""

from __future__ import annotations

import keyword
import re
from dataclasses import dataclass, field
from typing import Any

from codegen.names import FOLDERS, nearest, stem_of
from codegen.scene import SceneTable
from codegen.types import ParameterType, ValueType

# Storages of a check; empty: any.
CHECKS: dict[str, tuple[str, ...]] = {
    "none": (),
    "non_negative": ("integer", "real"),
    "positive": ("integer", "real"),
    "rotation": ("matrix3", "matrix3s"),
    "orthogonal": ("matrix3",),
    "unit_vector": ("vector3", "vector3s"),
    "color": ("vector4",),
}
CHANGES = ("any", "assemble")
# Kinds of named integers.
NAMED = ("no", "links", "joints")
SOURCES = ("frame", "coordinates", "kernel")
PHYSICS = ("ready", "planned")
BODY_FOLDERS = ("bodies", "super_elements", "finite_elements")
OBJECT_TYPES = ("Body", "Object", "SuperElement", "FiniteElement", "Connector", "Constraint", "Joint")
# Capabilities of a node or marker: an entry of `Capability` in reflection/item_type.hpp, or unchecked.
NODE_CAPABILITIES = {
    "Position": "position", "Orientation": "orientation",
    "Position2D": "position_2d", "Orientation2D": "orientation_2d",
    "GenericODE2": "generic_ode2", "GenericData": "generic_data", "RigidBody": None, "Point2DSlope1": None,
}  # fmt: skip
MARKER_CAPABILITIES = {
    "Position": "position", "Orientation": "orientation",
    "Coordinate": "coordinate", "BodyMass": "body_mass", "Body": None,
}  # fmt: skip
PROVIDED = {
    *NODE_CAPABILITIES, *MARKER_CAPABILITIES, "Node", "Object", "Ground", "Connector", "Constraint", "SingleNoded",
    "MultiNoded",
    "SuperElement", "RotationEulerParameters", "RotationRxyz", "RotationRotationVector",
}  # fmt: skip
NO_UNIT = "unit: empty; write '1' if dimensionless, 'various' if it depends on the component"
# Arguments that user functions share, named by a string alone.
STANDARD_ARGUMENTS = ("mbs", "t", "itemNumber")

_IDENTIFIER = re.compile(r"[A-Za-z_]\w*\Z")


class SpecError(ValueError):
    """A spec file that says something it may not. The message starts with where."""


def _one_of(key: str, value: str, allowed: Any) -> None:
    if value not in allowed:
        raise SpecError(f"{key}: {value!r} is not allowed; {nearest(str(value), allowed)}")


def check_identifier(name: str) -> None:
    if not _IDENTIFIER.match(name) or keyword.iskeyword(name):
        raise SpecError(f"{name!r} is not an identifier")


def check_documented(doc: str, key: str = "doc") -> None:
    if not doc.strip():
        raise SpecError(f"{key}: empty; a phrase in your own words is required")


@dataclass(frozen=True)
class Parameter:
    """A row of [parameters] or [visualization], or a setting."""

    name: str
    type: ParameterType
    doc: str = ""
    default: Any = None  # None: the type's own (index not set, no function, empty)
    unit: str = ""
    symbol: str = ""
    check: str = ""
    size: int = 0
    optional: bool = False
    internal: bool = False
    change: str = ""
    aliases: tuple[str, ...] = ()
    named: str = "no"
    beyond_reference: str = ""  # description of the addition
    typical: tuple[float, ...] = ()  # lower and upper bound of values that show in a small model; tests draw from them

    def __post_init__(self) -> None:
        check_identifier(self.name)
        check_documented(self.doc)
        _one_of("check", self.check or "none", CHECKS)
        if (fitting := CHECKS[self.check or "none"]) and self.type.storage not in fitting:
            raise SpecError(f"check: {self.check!r} is not for {self.type.name}")
        _one_of("change", self.change or "any", CHANGES)
        _one_of("named", self.named, NAMED)
        if self.named != "no" and self.type.storage != "integer":
            raise SpecError(f"named: {self.type.name} is not one integer")
        if self.size and self.type.shape[:1] != (None,):
            raise SpecError(f"size: {self.type.name} has no free length")
        if self.unit and not self.type.real:
            raise SpecError(f"unit: {self.type.name} is not made of floating point numbers")
        if self.type.real and not self.unit:
            raise SpecError(NO_UNIT)
        if problem := default_problem(self.type, self.default, self.size):
            raise SpecError(f"default: {problem}")
        if self.typical:
            self._check_typical()

    def _check_typical(self) -> None:
        if self.type.storage != "real":
            raise SpecError(f"typical: {self.type.name} is not one floating point number")
        if _array_problem(self.type, list(self.typical), (2,)) or self.typical[0] > self.typical[1]:
            raise SpecError(f"typical: {list(self.typical)!r} is not a lower and an upper bound")

    @property
    def effective_check(self) -> str:
        return self.check or self.type.check

    @property
    def needs_assemble(self) -> bool:
        return (self.change or ("assemble" if self.type.index else "any")) == "assemble"

    @property
    def shape(self) -> tuple[int | None, ...]:
        return (self.size, *self.type.shape[1:]) if self.size else self.type.shape


def default_problem(type_: ParameterType, default: Any, size: int) -> str:
    """Return the error of a default value, or ''."""
    if default is None:
        return "" if type_.complete else f"missing; {type_.name} needs one"
    if type_.function or type_.opaque or type_.storage == "beam_section" or (type_.index and not type_.shape):
        return f"{type_.name} has none of its own; leave it out"
    if type_.storage == "boolean":
        return "" if isinstance(default, bool) else f"{default!r} is not true or false"
    if type_.storage in ("text", "output_variable", "enumeration"):
        return "" if isinstance(default, str) else f"{default!r} is not a string"
    if type_.storage == "texts":
        strings = isinstance(default, list) and all(isinstance(entry, str) for entry in default)
        return "" if strings else f"{default!r} is not a list of strings"
    if not type_.shape:
        return _number_problem(type_, default)
    shape = (size, *type_.shape[1:]) if size else type_.shape
    return _array_problem(type_, default, shape)


def _number_problem(type_: ParameterType, value: Any) -> str:
    if value == "invalid" and type_.storage == "integer":
        return ""
    wanted = int if not type_.real else float
    if isinstance(value, bool) or not isinstance(value, wanted):
        return f"{value!r} is not {'an integer' if wanted is int else 'a number with a decimal point'}"
    return ""


def _array_problem(type_: ParameterType, value: Any, shape: tuple[int | None, ...]) -> str:
    if not shape:
        return _number_problem(type_, value)
    if not isinstance(value, list):
        return f"{value!r} is not a list"
    if shape[0] is not None and len(value) != shape[0]:
        return f"has {len(value)} entries instead of {shape[0]}"
    return next((p for entry in value if (p := _array_problem(type_, entry, shape[1:]))), "")


@dataclass(frozen=True)
class Output:
    """An output variable; `size` is 'n' where it depends on the item."""

    name: str
    size: int | str
    unit: str
    source: str
    doc: str = ""
    symbol: str = ""
    beyond_reference: str = ""  # description of the addition

    def __post_init__(self) -> None:
        check_documented(self.doc)
        _one_of("from", self.source, SOURCES)
        if not self.unit:
            raise SpecError(NO_UNIT)
        if self.size != "n" and (not isinstance(self.size, int) or self.size < 1):
            raise SpecError(f"size: {self.size!r} is neither a positive integer nor 'n'")


@dataclass(frozen=True)
class Argument:
    name: str
    type: ValueType
    doc: str = ""
    unit: str = ""
    size: int = 0

    def __post_init__(self) -> None:
        check_identifier(self.name)
        check_documented(self.doc)
        if self.type.real and not self.unit:
            raise SpecError(NO_UNIT)
        if self.size and self.type.shape != (None,):
            raise SpecError(f"size: {self.type.name} has no free length")

    @property
    def shape(self) -> tuple[int | None, ...]:
        return (self.size,) if self.size else self.type.shape


@dataclass(frozen=True)
class UserFunction:
    """`standard` are those of mbs, t, itemNumber that it takes, in this order, before `arguments`."""

    name: str
    standard: tuple[str, ...]
    arguments: tuple[Argument, ...]
    returns: Argument
    doc: str = ""
    example: str = ""

    def __post_init__(self) -> None:
        check_documented(self.doc)
        if self.standard != tuple(a for a in STANDARD_ARGUMENTS if a in self.standard) or self.standard[:1] != ("mbs",):
            raise SpecError("arguments: they start with 'mbs', then 't' and 'itemNumber' if taken, in this order")

    @property
    def argument_names(self) -> tuple[str, ...]:
        return (*self.standard, *(a.name for a in self.arguments))

    @property
    def compilable(self) -> bool:
        """Whether a C function can take the arguments and give the result."""
        return self.returns.type.real and all(a.type.real or a.type.plain for a in self.arguments)


@dataclass(frozen=True)
class Quantity:
    name: str
    symbol: str
    doc: str


@dataclass(frozen=True)
class Transformation:
    """A rigid transformation, or a list of them, as another way to give a position and a rotation."""

    name: str
    position: str  # parameters; '' if it only rotates
    rotation: str

    def __post_init__(self) -> None:
        check_identifier(self.name)


@dataclass(frozen=True)
class Example:
    """The mini example: code that ends with `result = ...`, and the value that result has."""

    code: str
    value: float | list[float]
    tolerance: float

    def __post_init__(self) -> None:
        if not re.search(r"^result\s*=", self.code, re.MULTILINE):
            raise SpecError("code: does not set `result`")
        if not self.tolerance >= 0:
            raise SpecError(f"expect.tolerance: {self.tolerance!r} is negative")


@dataclass(frozen=True)
class Item:
    """A complete item type, including the rows of groups."""

    path: str  # path of the spec file, for banners and messages
    name: str
    type_name: str
    summary: str
    physics: str
    parameters: tuple[Parameter, ...]
    visualization: tuple[Parameter, ...]
    outputs: tuple[Output, ...] = ()
    transformations: tuple[Transformation, ...] = ()
    user_functions: tuple[UserFunction, ...] = ()
    object_type: str = ""
    short_names: tuple[str, ...] = ()
    create_functions: tuple[str, ...] = ()  # methods of MainSystem whose arguments mirror the parameters of this item
    provides: tuple[str, ...] = ()
    requested_nodes: tuple[str, ...] = ()
    requested_markers: tuple[str, ...] = ()
    nodes: tuple[str, ...] = ()
    sized: str = ""  # a body with a number of coordinates that is known at run time only: the reason
    irregular: str = ""
    beyond_reference: str | None = None  # addition to the items of Exudyn; None: it is one of them
    equations: str = ""
    quantities: tuple[Quantity, ...] = ()
    examples: tuple[str, ...] = ()
    example: Example | None = None
    scene: SceneTable = field(default_factory=SceneTable)

    def __post_init__(self) -> None:
        check_identifier(self.name)
        check_documented(self.summary, "summary")
        if self.beyond_reference is not None:
            check_documented(self.beyond_reference, "beyond_reference")
        _one_of("physics", self.physics, PHYSICS)
        self._check_name()
        for key, words, allowed in (
            ("provides", self.provides, PROVIDED),
            ("requested_nodes", self.requested_nodes, NODE_CAPABILITIES),
            ("requested_markers", self.requested_markers, MARKER_CAPABILITIES),
        ):
            for word in words:
                _one_of(key, word, allowed)
        self._check_rows()
        self._check_functions()
        if (
            self.ready
            and self.folder in BODY_FOLDERS
            and not (self.nodes or self.sized or self.irregular or self.name == "ObjectGround")
        ):
            raise SpecError("nodes: a ready body names the nodes that its kernel is compiled for")
        if self.nodes and self.folder not in BODY_FOLDERS:
            raise SpecError(f"nodes: only for {', '.join(BODY_FOLDERS)}")
        if self.ready and self.example is None:
            raise SpecError("[example]: a ready item has one")

    def _check_name(self) -> None:
        expected = stem_of(self.name, self.folder)
        if expected != self.stem:
            raise SpecError(f"name: the file of {self.name} is specs/{expected}.toml")
        if (self.kind == "object") != bool(self.object_type):
            raise SpecError("object_type: objects, and only objects, have one")
        if self.object_type:
            _one_of("object_type", self.object_type, OBJECT_TYPES)

    def _check_rows(self) -> None:
        """A name stands for one thing: parameters and aliases among themselves, visualization rows among themselves."""
        for table, rows in (("parameters", self.parameters), ("visualization", self.visualization)):
            seen: set[str] = {"visualization"} if table == "parameters" else set()
            for row in rows:
                for name in (row.name, *row.aliases):
                    if name in seen:
                        raise SpecError(f"{table}.{row.name}: {name!r} is declared twice")
                    seen.add(name)
        names = [row.name for row in self.parameters]
        for each in self.transformations:
            if each.name in {name for row in self.parameters for name in (row.name, *row.aliases)}:
                raise SpecError(f"transformations.{each.name}: {each.name!r} is declared twice")
            for part in (each.position, each.rotation):
                if part and part not in names:
                    raise SpecError(f"transformations.{each.name}: no parameter {part!r}; {nearest(part, names)}")

    def _check_functions(self) -> None:
        rows = {r.name for r in self.rows if r.type.function or r.type.name == "PyFunctionGraphicsData"}
        described = {f.name for f in self.user_functions}
        for name in sorted(rows ^ described):
            where = "user_functions: missing table" if name in rows else "user_functions: no parameter is named so:"
            raise SpecError(f"{where} {name!r}")

    @property
    def rows(self) -> tuple[Parameter, ...]:
        return self.parameters + self.visualization

    @property
    def provisions(self) -> tuple[str, ...]:
        """Capabilities for other items: a marker of a coordinate does not provide the frames between which it
        measures."""
        frames = {"Position", "Orientation"} if self.kind == "marker" and "Coordinate" in self.provides else set()
        return tuple(word for word in self.provides if word not in frames)

    @property
    def kind(self) -> str:
        return FOLDERS[self.folder][0]

    @property
    def folder(self) -> str:
        return self.stem.split("/")[0]

    @property
    def stem(self) -> str:
        """`bodies/mass_point`: the path shared by spec, kernel and generated files."""
        return self.path.removeprefix("specs/").removesuffix(".toml")

    @property
    def ready(self) -> bool:
        return self.physics == "ready"

    def used_in(self, code: str) -> bool:
        """Whether a model makes this item by its class."""
        return bool(re.search(rf"(?<!\w)({'|'.join((self.name, *self.short_names))})\(", code))
