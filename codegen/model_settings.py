"""The data model of enumerations and of settings structures, and the collection of all specs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from codegen.model import Item, Parameter, SpecError, check_documented, check_identifier
from codegen.names import nearest
from codegen.types import TYPES, VALUE_TYPES, ParameterType, ValueType


@dataclass(frozen=True)
class EnumValue:
    name: str
    value: int
    doc: str = ""

    def __post_init__(self) -> None:
        check_identifier(self.name)
        check_documented(self.doc)
        if not 0 <= self.value < 2**32:
            raise SpecError(f"value: {self.value} does not fit into 32 bits")


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
    def type(self) -> ParameterType:
        """The type of a row that holds a value of this enumeration."""
        return TYPES.get(self.name) or ParameterType(self.name, self.name, "enumeration", self.name)


@dataclass(frozen=True)
class SettingsGroup:
    """A structure of settings. Groups that come from one [shared.*] table have its name as `shared`."""

    name: str
    summary: str
    rows: tuple[Parameter, ...]
    children: tuple[SettingsGroup, ...]
    shared: str = ""

    def __post_init__(self) -> None:
        check_documented(self.summary, "summary")

    def walk(self, prefix: str = "") -> Iterator[tuple[str, SettingsGroup]]:
        """This group and all below it, with their dotted paths, children first."""
        for child in self.children:
            yield from child.walk(f"{prefix}.{child.name}" if prefix else child.name)
        yield prefix, self


@dataclass(frozen=True)
class Settings:
    """One file of specs/settings."""

    path: str
    root: SettingsGroup
    shared: tuple[SettingsGroup, ...] = ()

    @property
    def name(self) -> str:
        return self.root.name

    @property
    def stem(self) -> str:
        return self.path.removeprefix("specs/settings/").removesuffix(".toml")


@dataclass(frozen=True)
class Specs:
    """Everything under specs/."""

    items: tuple[Item, ...]
    enums: tuple[Enum, ...]
    settings: tuple[Settings, ...]


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
