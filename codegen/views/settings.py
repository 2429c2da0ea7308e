"""Settings as structures: one per table of the spec, those of shared tables once, and how members differ from them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from codegen.model import Parameter
from codegen.model_settings import Settings, SettingsGroup
from codegen.names import snake_case
from codegen.views.cpp import cpp_value


@dataclass(frozen=True)
class Member:
    """A structure inside a structure; `changed` are its rows whose default differs from that of the structure."""

    name: str
    struct: str
    changed: tuple[Parameter, ...]


@dataclass(frozen=True)
class Struct:
    name: str
    summary: str
    rows: tuple[Parameter, ...]
    members: tuple[Member, ...]
    paths: tuple[str, ...]  # where users find it, dotted

    @property
    def variable(self) -> str:
        return snake_case(self.name) + "_group"


def structs(settings: Settings) -> list[Struct]:
    """All structures of a settings file, each after those that it contains."""
    found: dict[str, Struct] = {}
    for group in settings.shared:
        _collect(settings, group, group.name, True, found)
    _collect(settings, settings.root, "", False, found)
    paths = list(_paths(settings, settings.root, "", ""))
    return [
        Struct(s.name, s.summary, s.rows, s.members, tuple(p for p, n in paths if n == s.name)) for s in found.values()
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
    found[name] = Struct(name, group.summary, group.rows, tuple(members), ())


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
