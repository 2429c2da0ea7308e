"""Common parts of reading specs: location of an error, allowed keys of a table, and the row of a parameter."""

from __future__ import annotations

import tomllib
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any

from codegen.model import Parameter, SpecError
from codegen.model_settings import Enum, parameter_type
from codegen.names import nearest

PARAMETER_KEYS = (
    "type", "default", "unit", "symbol", "check", "size", "optional", "internal", "change", "aliases", "typical",
    "named", "beyond_reference", "doc",
)  # fmt: skip
_KEY_TYPES: dict[str, type] = {
    "size": int, "optional": bool, "internal": bool, "aliases": list, "typical": list, "acts_with": list,
    "range": str, "no_effect": str, "no_effect_on_pages": str, "no_effect_without_rays": str, "only_in": str,
    "doc": str, "unit": str, "symbol": str, "check": str, "change": str, "named": str,
    "summary": str, "beyond_reference": str,
}  # fmt: skip
_KINDS: dict[type, str] = {str: "a string", bool: "true or false", list: "a list"}


def parse(content: str) -> dict[str, Any]:
    try:
        return tomllib.loads(content)
    except tomllib.TOMLDecodeError as error:
        raise SpecError(f"not valid TOML: {error}") from error


@contextmanager
def at(place: str) -> Iterator[None]:
    """Put `place` in front of the message of a SpecError."""
    try:
        yield
    except SpecError as error:
        raise SpecError(f"{place}: {error}") from error


def known_key(key: str, known: Iterable[str]) -> None:
    names = list(known)
    if key not in names:
        raise SpecError(f"unknown name {key!r}; {nearest(key, names)}")


def check_keys(table: Any, known: Iterable[str], place: str = "") -> None:
    """Refuse unknown keys, and values of the wrong kind."""
    names = list(known)
    prefix = f"{place}: " if place else ""
    if not isinstance(table, Mapping):
        raise SpecError(f"{prefix}a table {{ ... }} belongs here, not {table!r}")
    for key, value in table.items():
        if key not in names:
            raise SpecError(f"{prefix}unknown key {key!r}; {nearest(key, names)}")
        wanted = _KEY_TYPES.get(key)
        if wanted in _KINDS and not isinstance(value, wanted):
            raise SpecError(f"{prefix}{key}: {value!r} is not {_KINDS[wanted]}")


def text(table: Mapping[str, Any], key: str) -> str:
    if key not in table:
        raise SpecError(f"missing key {key!r}")
    value = table[key]
    if not isinstance(value, str):
        raise SpecError(f"{key}: {value!r} is not a string")
    return value


def parameter(name: str, row: Mapping[str, Any], enums: Mapping[str, Enum]) -> Parameter:
    check_keys(row, PARAMETER_KEYS)
    return Parameter(name=name, **parameter_fields(row, enums))


def parameter_fields(row: Mapping[str, Any], enums: Mapping[str, Enum]) -> dict[str, Any]:
    """Return the fields of `Parameter` from a row; checks its keys."""
    fields: dict[str, Any] = {"type": parameter_type(text(row, "type"), enums)}
    fields |= {key: value for key, value in row.items() if key != "type"}
    return fields | {key: tuple(fields.get(key, ())) for key in ("aliases", "typical")}
