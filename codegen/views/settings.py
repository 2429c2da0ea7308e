"""Settings as structures: one per table of the spec, shared tables once, and differences of members."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

from codegen.model_settings import REASONS, Setting, Settings, SettingsGroup
from codegen.ranges import Range
from codegen.views.cpp import cpp_string, cpp_value
from codegen.views.python import doc_text, row_note
from codegen.views.rst import remarks, sentence


@dataclass(frozen=True)
class Member:
    """A structure inside a structure; `changed` are its rows whose default differs from that of the structure."""

    name: str
    struct: str
    changed: tuple[Setting, ...]


@dataclass(frozen=True)
class Struct:
    name: str
    summary: str
    rows: tuple[Setting, ...]
    members: tuple[Member, ...]
    paths: tuple[str, ...]  # dotted paths for users
    beyond_reference: str | None = None

    @property
    def ruled(self) -> tuple[Setting, ...]:
        """Rows of which more is known than types and signs."""
        return tuple(row for row in self.rows if row.range or row.acts_with or row.only_in or any(reasons(row)))

    @property
    def flagged(self) -> tuple[Setting, ...]:
        """Rows that require a flag."""
        return tuple(row for row in self.rows if row.acts_with)


def structs(settings: Settings) -> list[Struct]:
    """All structures of a settings file, each after those that it contains."""
    found: dict[str, Struct] = {}
    for group in settings.shared:
        _collect(settings, group, group.name, True, found)
    _collect(settings, settings.root, "", False, found)
    paths = list(_paths(settings, settings.root, "", ""))
    return [
        replace(struct, paths=tuple(path for path, name in paths if name == struct.name)) for struct in found.values()
    ]


def _collect(settings: Settings, group: SettingsGroup, path: str, shared: bool, found: dict[str, Struct]) -> None:
    members = []
    for child in group.children:
        name = _child_name(settings, path, child)
        if name not in found:
            _collect(settings, child, f"{path}.{child.name}" if path else child.name, shared, found)
        base = found[name]
        changed = tuple(a for a, b in zip(child.rows, base.rows, strict=True) if a.default != b.default)
        members.append(Member(child.name, name, changed))
    name = settings.name if not path else struct_name(settings, path)
    found[name] = Struct(name, group.summary, group.rows, tuple(members), (), group.beyond_reference)


def _child_name(settings: Settings, path: str, child: SettingsGroup) -> str:
    return struct_name(settings, child.shared or (f"{path}.{child.name}" if path else child.name))


def struct_name(settings: Settings, path: str) -> str:
    """`timeIntegration.newton` -> `TimeIntegrationNewtonSettings`; drawing has `VSettingsNodes` instead."""
    words = "".join(word[0].upper() + word[1:] for word in path.split("."))
    if settings.name == "VisualizationSettings":
        return f"VSettings{words}"
    return words if words.endswith("Settings") else f"{words}Settings"


def _paths(settings: Settings, group: SettingsGroup, path: str, below: str) -> Iterator[tuple[str, str]]:
    """Pairs of a dotted path and the name of the structure there; `below`: the path that names the structure."""
    yield path, settings.name if not path else struct_name(settings, below)
    for child in group.children:
        inner = f"{path}.{child.name}" if path else child.name
        origin = child.shared or (f"{below}.{child.name}" if below else child.name)
        yield from _paths(settings, child, inner, origin)


def cpp_struct_member(member: Member) -> str:
    """`VSettingsMaterial material1{.name = "matt"};`"""
    changes = ", ".join(f".{row.name} = {cpp_value(row)}" for row in member.changed)
    return f"{member.struct} {member.name}{{{changes}}};"


def reasons(row: Setting) -> tuple[str, ...]:
    """Why it has no effect, in the order of REASONS; empty where it has."""
    return tuple(getattr(row, key) for key in REASONS)


def cpp_flags(row: Setting, struct: Struct) -> str:
    """The name of the array of the flags that a row acts with."""
    return f"{struct.name}_flags_of_{row.name}"


def cpp_rule(row: Setting, struct: Struct) -> str:
    """Return the `SettingRule` of a row, with the fields that differ from the defaults."""
    fields = [f".name = {cpp_string(row.name)}"]
    if row.range:
        fields += [*_cpp_bounds(row.range), f".words = {cpp_string(row.range.words)}"]
    told = zip(REASONS, (row.elsewhere or row.no_effect, *reasons(row)[1:]), strict=True)
    fields += [f".{key} = {cpp_string(reason)}" for key, reason in told if reason]
    if row.acts_with:
        fields.append(f".acts_with = {cpp_flags(row, struct)}")
    if row.only_in:
        fields.append(f".only_in = {cpp_string(row.only_in)}")
    return "{" + ", ".join(fields) + "}"


def _cpp_bounds(bounds: Range) -> list[str]:
    sides = [side for side in ("lower", "upper") if not math.isinf(getattr(bounds, side))]
    values = [f".{side} = {getattr(bounds, side)!r}" for side in sides]
    return values + [f".{side}_open = true" for side in sides if getattr(bounds, f"{side}_open")]


def setting_notes(row: Setting) -> str:
    """Return ` [s; greater than 0]; no effect: ...`, the addition to a description in a docstring."""
    note = row_note(row, row.range.words if row.range else "")
    note += f"; acts with {' or '.join(row.acts_with)} only" if row.acts_with else ""
    note += f"; {row.elsewhere}" if row.only_in else ""
    told = zip(REASONS, reasons(row), strict=True)
    return note + "".join(f"; {_words(key)}: {doc_text(reason)}" for key, reason in told if reason)


def _words(key: str) -> str:
    return key.replace("_", " ")


def described_setting(row: Setting) -> str:
    """Description, range and remarks as sentences."""
    note = f"**No effect here:** {row.no_effect}. " if row.no_effect else ""
    refusal = f"Must be {row.range.words}." if row.range else remarks(row)
    flags = " or ".join(f"``{flag}``" for flag in row.acts_with)
    condition = f" Acts with {flags} only." if flags else ""
    doc = f"{row.doc}; {row.elsewhere}" if row.only_in else row.doc
    told = zip(REASONS[1:], reasons(row)[1:], strict=True)
    lesser = "".join(f" {_words(key).capitalize()}: {reason}." for key, reason in told if reason)
    return f"{note}{sentence(doc)}{condition} {refusal}".strip() + lesser
