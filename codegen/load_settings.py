"""Read enumerations and settings structures."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import nullcontext
from typing import Any

from codegen.model import SpecError
from codegen.model_settings import REASONS, Enum, EnumValue, Setting, Settings, SettingsGroup
from codegen.names import nearest, snake_case
from codegen.ranges import read_range
from codegen.rows import PARAMETER_KEYS, at, check_keys, parameter_fields, parse, text

Shared = Mapping[str, Mapping[str, Any]]


def load_enum(path: str, content: str) -> Enum:
    with at(path):
        raw = parse(content)
        check_keys(raw, ("name", "summary", "values"))
        name = text(raw, "name")
        if path != f"specs/enums/{snake_case(name)}.toml":
            raise SpecError(f"name: the file of {name} is specs/enums/{snake_case(name)}.toml")
        return Enum(path, name, text(raw, "summary"), tuple(_value(n, row) for n, row in raw.get("values", {}).items()))


def _value(name: str, row: Mapping[str, Any]) -> EnumValue:
    with at(f"values.{name}"):
        check_keys(row, ("value", "doc", "beyond_reference"))
        value = row.get("value")
        if not isinstance(value, int) or isinstance(value, bool):
            raise SpecError(f"value: {value!r} is not an integer")
        return EnumValue(name, value, row.get("doc", ""), row.get("beyond_reference"))


def load_settings(path: str, content: str, enums: Mapping[str, Enum]) -> Settings:
    with at(path):
        raw = parse(content)
        name = text(raw, "name")
        if path != f"specs/settings/{snake_case(name)}.toml":
            raise SpecError(f"name: the file of {name} is specs/settings/{snake_case(name)}.toml")
        tree = {key: value for key, value in raw.items() if key not in ("name", "shared")}
        shared = raw.get("shared", {})
        groups = tuple(_group(key, f"shared.{key}", table, {}, enums) for key, table in shared.items())
        return Settings(path, _group(name, "", tree, shared, enums), groups)


def _group(name: str, path: str, table: Mapping[str, Any], shared: Shared, enums: Mapping[str, Enum]) -> SettingsGroup:
    """One structure; entries with a `type` are its rows, other tables its children."""
    with at(path) if path else nullcontext():
        origin = table.get("use", "")
        full = _splice(table, shared)
        rows: list[Setting] = []
        children: list[SettingsGroup] = []
        for key, value in full.items():
            if key in ("summary", "beyond_reference"):
                continue
            if not isinstance(value, Mapping):
                raise SpecError(f"{key}: a row {{ type = ... }} or a table belongs here, not {value!r}")
            if isinstance(value.get("type"), str):
                with at(key):
                    rows.append(_setting(key, value, enums))
            else:
                children.append(_group(key, key, value, shared, enums))
        beyond = full.get("beyond_reference")
        return SettingsGroup(name, text(full, "summary"), tuple(rows), tuple(children), origin, beyond)


def _setting(name: str, row: Mapping[str, Any], enums: Mapping[str, Enum]) -> Setting:
    check_keys(row, (*PARAMETER_KEYS, "range", *REASONS, "acts_with", "only_in"))
    fields = parameter_fields(row, enums)
    if "range" in fields:
        fields["range"] = read_range(fields["range"])
    fields["acts_with"] = tuple(fields.get("acts_with", ()))
    result = Setting(name=name, **fields)
    if result.type.storage in ("enumeration", "output_variable"):
        values = [v.name for v in enums[result.type.name].values]
        if result.default not in values:
            raise SpecError(
                f"default: {result.default!r} is not in {result.type.name}; {nearest(result.default, values)}"
            )
    return result


def _splice(table: Mapping[str, Any], shared: Shared) -> dict[str, Any]:
    """The table with the shared one that it uses below it; a row given in both takes keys from both."""
    if "use" not in table:
        return dict(table)
    if table["use"] not in shared:
        raise SpecError(f"use: unknown table shared.{table['use']}; {nearest(str(table['use']), shared)}")
    return _overlay(shared[table["use"]], {key: value for key, value in table.items() if key != "use"})


def _overlay(base: Mapping[str, Any], top: Mapping[str, Any]) -> dict[str, Any]:
    result = dict(base)
    for key, value in top.items():
        if key not in base:
            raise SpecError(f"{key}: not in the shared table; {nearest(key, base)}")
        if not isinstance(value, Mapping):
            result[key] = value
        elif "type" in base[key]:
            result[key] = dict(base[key]) | dict(value)
        else:
            result[key] = _overlay(base[key], value)
    return result
