"""Read the [scene] table of an item; see codegen/scene.py."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import fields
from typing import Any

from codegen.model import MARKER_CAPABILITIES, SpecError
from codegen.names import nearest
from codegen.scene import EXEMPT, FRAMES, End, NodePlace, SceneTable

WORD = " on "
LEAST_WORDS = 5  # of a reason
KEYS = tuple(f.name for f in fields(SceneTable))
_KINDS: dict[str, tuple[type, str]] = {
    **dict.fromkeys(("frame", "second_body"), (str, "a string")),
    **dict.fromkeys(("small_deformations", "every_body", "planar"), (bool, "true or false")),
    **dict.fromkeys(("data", "force_equations"), (int, "an integer")),
    **dict.fromkeys(("nodes", "local", "beside", "fits", "power", "pairs", "options"), (list, "a list")),
    **dict.fromkeys(
        ("isotropic", "per_marker", "closed", "values", "exempt", "exempt_outputs"), (dict, "a table { ... }")
    ),
}
# Which kinds of items, besides those of the comments above, a key is for.
_ONLY: dict[str, tuple[str, ...]] = {
    "frame": ("node",),
    "isotropic": ("object",), "local": ("object",), "small_deformations": ("object",), "nodes": ("object",),
    "every_body": ("marker",), "beside": ("marker",),
    "fits": ("object", "load"), "planar": ("object",), "data": ("object",), "per_marker": ("object",),
    "closed": ("object",),
    "power": ("object",), "force_equations": ("object",), "second_body": ("object",),
}  # fmt: skip


def read_scene(raw: Mapping[str, Any], kind: str, rows: Iterable[str], outputs: Iterable[str]) -> SceneTable:
    """The table, checked against the rows and outputs of its item; whom it names is checked when all items are read."""
    for key, value in raw.items():
        _known("key", key, KEYS)
        wanted, words = _KINDS[key]
        if not isinstance(value, wanted) or (wanted is int and isinstance(value, bool)):
            raise SpecError(f"{key}: {value!r} is not {words}")
        if kind not in _ONLY.get(key, (kind,)):
            raise SpecError(f"{key}: not for a {kind}, but for a {' or '.join(_ONLY[key])}")
    _check_words(raw)
    _check_rows(raw, list(rows), list(outputs))
    made = dict(raw)
    for key, make in _MAKE.items():
        if key in made:
            made[key] = tuple(make(key, entry) for entry in made[key])
    return SceneTable(**made)


def _known(what: str, word: str, known: Iterable[str]) -> None:
    if word not in (names := list(known)):
        raise SpecError(f"unknown {what} {word!r}; {nearest(word, names)}")


def _check_words(raw: Mapping[str, Any]) -> None:
    if "frame" in raw:
        _known("frame", raw["frame"], FRAMES)
    for word in raw.get("fits", ()):
        _known("word in fits:", word, MARKER_CAPABILITIES)
    for check in raw.get("exempt", {}):
        _known("check in exempt:", check, EXEMPT)
    for table in ("exempt", "exempt_outputs"):
        for name, reason in raw.get(table, {}).items():
            if not isinstance(reason, str) or len(reason.split()) < LEAST_WORDS:
                raise SpecError(f"{table}.{name}: {reason!r} is not a reason of at least {LEAST_WORDS} words")


def _check_rows(raw: Mapping[str, Any], rows: list[str], outputs: list[str]) -> None:
    """Parameters and outputs that the table names are those of the item."""
    tables = [(key, raw.get(key, {})) for key in ("values", "isotropic", "per_marker", "closed")]
    tables += [("options", option) for option in raw.get("options", ())]
    for key, table in tables:
        for name in table:
            _known(f"parameter in {key}:", name, rows)
    for name in raw.get("exempt_outputs", {}):
        _known("output in exempt_outputs:", name, outputs)
    told = [name for pair in raw.get("power", ()) for name in pair]
    told += [raw["second_body"]] if "second_body" in raw else []
    for name in told:
        _known("output:", name.removeprefix("rate of ").removeprefix("-"), outputs)


def read_end(text: Any) -> End:
    kinds = ("Marker", "Object", "Node")
    found = dict.fromkeys(kinds, "")
    words = text.split(WORD) if isinstance(text, str) else []
    order = [next((k for k in kinds if word.startswith(k)), "") for word in words]
    if not words or order != [k for k in kinds if k in order]:
        raise SpecError(f"{text!r} is not a place such as 'MarkerBodyRigid on ObjectRigidBody on NodeRigidBodyEP'")
    found |= zip(order, words, strict=True)
    return End(found["Marker"], found["Object"], found["Node"])


def _pair(key: str, entry: Any) -> tuple[End, ...]:
    if not isinstance(entry, list) or not entry:
        raise SpecError(f"{key}: {entry!r} is not a list of places, one per marker")
    return tuple(read_end(text) for text in entry)


def _node(key: str, entry: Any) -> NodePlace:
    known = [f.name for f in fields(NodePlace)]
    if not isinstance(entry, Mapping):
        raise SpecError(f"{key}: {entry!r} is not a table of {', '.join(known)}")
    for name in entry:
        _known(f"key in {key}:", name, known)
    return NodePlace(entry.get("type", ""), tuple(entry.get("at", NodePlace.at)), entry.get("values", {}))


def _tuple(key: str, entry: Any) -> Any:
    return tuple(entry) if isinstance(entry, list) else entry


_MAKE: dict[str, Any] = {
    "pairs": _pair,
    "beside": lambda key, entry: read_end(entry),
    "nodes": _node,
    "local": _tuple,
    "power": _tuple,
    "fits": _tuple,
    "options": _tuple,
}
