"""How an item's name becomes the stem of its files, and how a misspelt name finds its nearest known one."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable

# Folders of specs/: kind of items, and prefixes of their names.
FOLDERS: dict[str, tuple[str, tuple[str, ...]]] = {
    "nodes": ("node", ("Node",)),
    "bodies": ("object", ("Object",)),
    "super_elements": ("object", ("Object",)),
    "finite_elements": ("object", ("Object",)),
    "connectors": ("object", ("ObjectConnector", "Object")),
    "constraints": ("object", ("ObjectConnector", "Object")),
    "contacts": ("object", ("ObjectContact", "Object")),
    "joints": ("object", ("ObjectJoint", "Object")),
    "markers": ("marker", ("Marker",)),
    "loads": ("load", ("Load",)),
    "sensors": ("sensor", ("Sensor",)),
}

WORD = re.compile(r"ANCF|ALE|FFRF|COMs|\d+D|[A-Z]+(?![a-z])(?:\d+(?![\dD]))?|[A-Z]?[a-z]+(?:\d+(?![\dD]))?|\d+")


def snake_case(name: str) -> str:
    """`ANCFCable2D` -> `ancf_cable_2d`."""
    return "_".join(WORD.findall(name)).lower()


def stem_of(name: str, folder: str) -> str:
    """`bodies/mass_point` of `ObjectMassPoint`: the path that spec, kernel and generated files share."""
    prefix = next((p for p in FOLDERS[folder][1] if name.startswith(p)), "")
    stem = snake_case(name.removeprefix(prefix))
    return f"{folder}/{'one_' + stem[1:] if stem[:1].isdigit() else stem}"


def nearest(name: str, known: Iterable[str]) -> str:
    """'; did you mean ...?' with the known name next to `name`, or the known names if none is near."""
    names = list(known)
    match = difflib.get_close_matches(name, names, n=1, cutoff=0.6)
    if match:
        return f"did you mean {match[0]!r}?"
    return "known are " + ", ".join(sorted(names))
