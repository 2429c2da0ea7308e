"""Read the planned parts of the interface: specs/interface/planned.toml."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from codegen.model import SpecError
from codegen.model_settings import Planned
from codegen.rows import at, check_keys, parse, text

TABLES = ("modules", "functions")
KEYS = ("what", "instead", "members")


def load_planned(path: str, content: str) -> tuple[Planned, ...]:
    with at(path):
        raw = parse(content)
        check_keys(raw, TABLES)
        return tuple(_planned(table, name, row) for table in TABLES for name, row in raw.get(table, {}).items())


def _planned(table: str, name: str, row: Mapping[str, Any]) -> Planned:
    with at(f"{table}.{name}"):
        check_keys(row, KEYS)
        members = row.get("members", [])
        if members != sorted(set(members)):
            raise SpecError("members: not in order, or one twice")
        return Planned(name, table == "modules", text(row, "what"), row.get("instead", ""), tuple(members))
