"""The data model of enumerations and of settings structures, and the collection of all specs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from codegen.load_create import CreateFunction
from codegen.model import Item, Parameter, SpecError, check_documented, check_identifier
from codegen.names import nearest
from codegen.ranges import Range
from codegen.types import TYPES, VALUE_TYPES, ParameterType, ValueType

# Keys for settings without effect: never, in the viewer, or without the ray tracer; the value is the reason.
REASONS = ("no_effect", "no_effect_on_pages", "no_effect_without_rays")


@dataclass(frozen=True)
class EnumValue:
    name: str
    value: int
    doc: str = ""
    beyond_reference: str | None = None  # addition to the values of Exudyn; None: it is one of them

    def __post_init__(self) -> None:
        check_identifier(self.name)
        check_documented(self.doc)
        if self.beyond_reference is not None:
            check_documented(self.beyond_reference, "beyond_reference")
        if not 0 <= self.value < 2**63:
            raise SpecError(f"value: {self.value} does not fit into 63 bits")


@dataclass(frozen=True)
class Enum:
    path: str
    name: str
    summary: str
    values: tuple[EnumValue, ...]

    def __post_init__(self) -> None:
        check_documented(self.summary, "summary")
        numbers = [v.value for v in self.values]
        if len(set(numbers)) != len(numbers):
            raise SpecError("values: a number is used twice")

    @property
    def bits(self) -> int:
        """Size of the numbers in C++."""
        return 32 if all(v.value < 2**32 for v in self.values) else 64

    @property
    def type(self) -> ParameterType:
        """The type of a row that holds a value of this enumeration."""
        return TYPES.get(self.name) or ParameterType(self.name, self.name, "enumeration", self.name)


@dataclass(frozen=True)
class Setting(Parameter):
    """A row of a structure of settings."""

    range: Range | None = None
    no_effect: str = ""
    no_effect_on_pages: str = ""
    no_effect_without_rays: str = ""
    acts_with: tuple[str, ...] = ()  # related flags, one of which has to be true for it to have an effect
    only_in: str = ""  # the structure of the root whose own counts, for all structures like it

    @property
    def elsewhere(self) -> str:
        """Why those in other structures have no effect."""
        return f"that of {self.only_in} is for all {self.only_in.rstrip('0123456789')}s" if self.only_in else ""

    def __post_init__(self) -> None:
        super().__post_init__()
        for key in REASONS:
            reason = getattr(self, key)
            if reason != reason.strip(" ."):
                raise SpecError(f"{key}: a reason is a phrase without a full stop")
        if self.no_effect and (self.no_effect_on_pages or self.no_effect_without_rays or self.only_in):
            raise SpecError("no_effect: what has no effect at all needs no reasons for less")
        if self.range is None:
            return
        if self.type.storage not in ("integer", "real"):
            raise SpecError(f"range: {self.type.name} is not one number")
        if self.effective_check != "none" and self.range.lower < 0:
            raise SpecError(f"range: {self.type.name} is never negative")
        if self.default not in self.range:
            raise SpecError(f"default: {self.default!r} is not {self.range.words}")


@dataclass(frozen=True)
class SettingsGroup:
    """A structure of settings. Groups that come from one [shared.*] table have its name as `shared`."""

    name: str
    summary: str
    rows: tuple[Setting, ...]
    children: tuple[SettingsGroup, ...]
    shared: str = ""
    beyond_reference: str | None = None  # addition to the settings of Exudyn; None: it is one of them

    def __post_init__(self) -> None:
        check_documented(self.summary, "summary")
        if self.beyond_reference is not None:
            check_documented(self.beyond_reference, "beyond_reference")
        flags = [row.name for row in self.rows if row.type.storage == "boolean"]
        for row in self.rows:
            for flag in row.acts_with:
                if flag not in flags or flag == row.name:
                    raise SpecError(f"{row.name}: acts_with: {flag!r} is no flag beside it; {nearest(flag, flags)}")

    def walk(self, prefix: str = "") -> Iterator[tuple[str, SettingsGroup]]:
        """This group and all below it, with their dotted paths, children first."""
        for child in self.children:
            yield from child.walk(f"{prefix}.{child.name}" if prefix else child.name)
        yield prefix, self


@dataclass(frozen=True)
class Settings:
    """A file of specs/settings."""

    path: str
    root: SettingsGroup
    shared: tuple[SettingsGroup, ...] = ()

    def __post_init__(self) -> None:
        known = [child.name for child in self.root.children]
        for path, group in self.root.walk():
            for row in group.rows:
                if row.only_in and row.only_in not in known:
                    where = f"{path}.{row.name}" if path else row.name
                    raise SpecError(f"{where}: only_in: {row.only_in!r} is no structure; {nearest(row.only_in, known)}")

    @property
    def name(self) -> str:
        return self.root.name

    @property
    def stem(self) -> str:
        return self.path.removeprefix("specs/settings/").removesuffix(".toml")


@dataclass(frozen=True)
class Planned:
    """A module, class or function that is not there yet; if it has `members`, only these are not."""

    name: str
    is_module: bool
    what: str
    instead: str
    members: tuple[str, ...]

    def __post_init__(self) -> None:
        check_documented(self.what, "what")
        for word in (*self.name.split("."), *self.members):
            check_identifier(word)


@dataclass(frozen=True)
class LeftOut:
    """Names of the interface that are left out, what they are for, and what there is instead."""

    purpose: str
    instead: str
    names: tuple[str, ...]

    def __post_init__(self) -> None:
        check_documented(self.instead, "instead")


@dataclass(frozen=True)
class Specs:
    """Everything under specs/, and the Create functions, which are written in Python."""

    items: tuple[Item, ...]
    enums: tuple[Enum, ...]
    settings: tuple[Settings, ...]
    planned: tuple[Planned, ...] = ()
    left_out: tuple[LeftOut, ...] = ()
    create_functions: tuple[CreateFunction, ...] = ()


def parameter_type(name: str, enums: Mapping[str, Enum]) -> ParameterType:
    if name in TYPES:
        return TYPES[name]
    if name in enums:
        return enums[name].type
    raise SpecError(f"type: unknown type {name!r}; {nearest(name, [*TYPES, *enums])}")


def value_type(name: str) -> ValueType:
    if name not in VALUE_TYPES:
        raise SpecError(f"type: unknown type {name!r}; {nearest(name, VALUE_TYPES)}")
    return VALUE_TYPES[name]
