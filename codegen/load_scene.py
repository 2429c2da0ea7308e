"""Read the [scene] table of an item; see codegen/scene.py."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import fields
from typing import Any

from codegen.model import MARKER_CAPABILITIES, SpecError
from codegen.names import nearest
from codegen.scene import DRAWINGS, EXEMPT, FRAMES, End, NodePlace, SceneTable

WORD = " on "
GAP = "gap"  # gap of the constraint equations, in `closed`
LEAST_WORDS = 5  # minimum number of words of a reason
KEYS = tuple(f.name for f in fields(SceneTable))
_KINDS: dict[str, tuple[type, str]] = {
    **dict.fromkeys(("frame", "second_body", "drawing"), (str, "a string")),
    **dict.fromkeys(("small_deformations", "bent", "every_body", "planar"), (bool, "true or false")),
    **dict.fromkeys(("data", "force_equations"), (int, "an integer")),
    **dict.fromkeys(("nodes", "local", "beside", "fits", "power", "pairs", "options"), (list, "a list")),
    **dict.fromkeys(("global_outputs", "relative_outputs"), (list, "a list")),
    **dict.fromkeys(
        ("isotropic", "per_marker", "closed", "values", "exempt", "exempt_outputs", "exempt_parameters"),
        (dict, "a table { ... }"),
    ),
}
# Kinds of items of a key; other keys are for all.
_ONLY: dict[str, tuple[str, ...]] = {
    "frame": ("node",),
    "isotropic": ("object",), "local": ("object",), "small_deformations": ("object",), "nodes": ("object",),
    "bent": ("object",),
    "every_body": ("marker",), "beside": ("marker",),
    "fits": ("object", "load"), "planar": ("object",), "data": ("object",), "per_marker": ("object",),
    "closed": ("object",),
    "power": ("object",), "force_equations": ("object",), "second_body": ("object",), "drawing": ("object",),
    "global_outputs": ("object",), "relative_outputs": ("object",),
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
    made = dict(raw)
    for key in raw.keys() & _ENTRIES.keys():
        made[key] = tuple(_ENTRIES[key](key, entry) for entry in raw[key])
    table = SceneTable(**made)
    _check_words(table)
    _check_rows(table, list(rows), list(outputs))
    return table


def _known(what: str, word: str, known: Iterable[str], key: str = "") -> None:
    if word not in (names := list(known)):
        raise SpecError(f"{key + ': ' if key else ''}unknown {what} {word!r}; {nearest(word, names)}")


def _check_words(scene: SceneTable) -> None:
    if scene.frame:
        _known("frame", scene.frame, FRAMES)
    if scene.drawing:
        _known("drawing", scene.drawing, DRAWINGS)
    for word in scene.fits or ():
        _known("capability", word, MARKER_CAPABILITIES, "fits")
    for check in scene.exempt:
        _known("check", check, EXEMPT, "exempt")
    for key in ("exempt", "exempt_outputs", "exempt_parameters"):
        for name, reason in getattr(scene, key).items():
            if not isinstance(reason, str) or len(reason.split()) < LEAST_WORDS:
                raise SpecError(f"{key}.{name}: {reason!r} is not a reason of at least {LEAST_WORDS} words")


def _check_rows(scene: SceneTable, rows: list[str], outputs: list[str]) -> None:
    """Parameters and outputs that the table names are those of the item."""
    if scene.drawing and "markerNumbers" not in rows:
        raise SpecError(
            "drawing: for objects with markerNumbers; a body has the graphics of its node, or a line through its nodes"
        )
    keys = ("values", "isotropic", "per_marker", "closed", "exempt_parameters")
    tables = [(key, getattr(scene, key)) for key in keys]
    for key, table in [*tables, *(("options", option) for option in scene.options)]:
        for name in table:
            _known("parameter", name, rows, key)
    told = [("power", name.removeprefix("rate of ")) for pair in scene.power for name in pair]
    told += [(key, name) for key in ("global_outputs", "relative_outputs") for name in getattr(scene, key)]
    told += [("second_body", scene.second_body.removeprefix("-"))] if scene.second_body else []
    told += [("closed", name) for name in scene.closed.values() if name != GAP]
    for key, name in [*told, *(("exempt_outputs", name) for name in scene.exempt_outputs)]:
        _known("output", name, outputs, key)


def read_end(key: str, text: Any) -> End:
    kinds = ("Marker", "Object", "Node")
    found = dict.fromkeys(kinds, "")
    words = text.split(WORD) if isinstance(text, str) else []
    order = [next((k for k in kinds if word.startswith(k)), "") for word in words]
    if not words or order != [k for k in kinds if k in order]:
        raise SpecError(
            f"{key}: {text!r} is not a place such as 'MarkerBodyRigid on ObjectRigidBody on NodeRigidBodyEP'"
        )
    found |= zip(order, words, strict=True)
    return End(found["Marker"], found["Object"], found["Node"])


def _pair(key: str, entry: Any) -> tuple[End, ...]:
    if not isinstance(entry, list) or not entry:
        raise SpecError(f"{key}: {entry!r} is not a list of places, one per marker")
    return tuple(read_end(key, text) for text in entry)


def _node(key: str, entry: Any) -> NodePlace:
    known = [f.name for f in fields(NodePlace)]
    for name in _table(key, entry):
        _known("key", name, known, key)
    lists = {name: tuple(entry[name]) for name in ("at", "mesh") if name in entry}
    return NodePlace(**{**entry, **lists})


def _table(key: str, entry: Any) -> Any:
    if not isinstance(entry, Mapping):
        raise SpecError(f"{key}: {entry!r} is not a table {{ ... }}")
    return entry


def _power(key: str, entry: Any) -> Any:
    if not isinstance(entry, list) or [type(name) for name in entry] != [str, str]:
        raise SpecError(f"{key}: {entry!r} is not a pair [force, velocity] of outputs")
    return tuple(entry)


def _local(key: str, entry: Any) -> Any:
    if not isinstance(entry, list) or len(entry) != 3 or not all(isinstance(x, float) for x in entry):
        raise SpecError(f"{key}: {entry!r} is not a place [x, y, z]")
    return tuple(entry)


# Entries of lists.
_ENTRIES: dict[str, Any] = {
    "pairs": _pair,
    "beside": read_end,
    "nodes": _node,
    "local": _local,
    "power": _power,
    **dict.fromkeys(("fits", "global_outputs", "relative_outputs"), lambda key, entry: entry),
    "options": _table,
}
