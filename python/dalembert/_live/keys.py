"""Effect of keys on settings, and the settings that the viewer may change."""

from __future__ import annotations

from enum import Enum
from typing import Any

import numpy as np

from dalembert.GUI import Edit

GROUPS = {"n": "nodes", "c": "connectors", "b": "bodies", "m": "markers", "l": "loads", "s": "sensors"}
INTERVALS = {"1": 0.02, "2": 0.1, "3": 0.5, "4": 2.0, "5": 100.0}  # s between pictures
# faces transparent, edges of faces, faces
FACES = ((False, False, True), (True, False, True), (True, True, True), (False, True, False), (False, True, True))

# Names of the keys of a browser, and their numbers for functions of the user.
NAMED = {
    "Escape": 256, "Enter": 257, "Tab": 258, "Backspace": 259, "Insert": 260, "Delete": 261, "ArrowRight": 262,
    "ArrowLeft": 263, "ArrowDown": 264, "ArrowUp": 265, "PageUp": 266, "PageDown": 267, "Home": 268, "End": 269,
    **{f"F{n}": 289 + n for n in range(1, 13)},
}  # fmt: skip


def code(key: str) -> int:
    """Return the number of a key; letters use the codes of capital letters; 0 if it has none."""
    if key in NAMED:
        return NAMED[key]
    return ord(key.upper()) if len(key) == 1 and key.isprintable() else 0


def press(settings: Any, key: str, with_numbers: bool) -> bool:
    """Let a key change settings; return whether it has."""
    letter = key.lower()
    if letter in GROUPS:
        group = getattr(settings, GROUPS[letter])
        name = "showNumbers" if with_numbers else "show"
        setattr(group, name, not getattr(group, name))
        return True
    if letter == "r":
        settings.nodes.showBasis = not settings.nodes.showBasis
        return True
    if letter == "j":
        settings.connectors.showJointAxes = not settings.connectors.showJointAxes
        return True
    if letter in INTERVALS:
        settings.general.graphicsUpdateInterval = INTERVALS[letter]
        return True
    if letter == "t":
        scene = settings.view0.scene
        now = (scene.facesTransparent, scene.showFaceEdges, scene.showFaces)
        place = FACES.index(now) if now in FACES else -1
        scene.facesTransparent, scene.showFaceEdges, scene.showFaces = FACES[(place + 1) % len(FACES)]
        return True
    if key == "F2":
        settings.interactive.ignoreKeys = not settings.interactive.ignoreKeys
        return True
    return False


def rows(settings: Any) -> list[dict[str, Any]]:
    """Return the settings that the viewer may change: path, value, possible values, help."""
    edit, result = Edit(settings), list[dict[str, Any]]()
    for path, value, words in edit.rows():
        try:
            known = edit.value(path)
        except (AttributeError, KeyError):
            continue
        if hasattr(known, "GetDictionary"):
            result.append({"path": ".".join(path), "branch": True})
        elif _may_be_changed(known):
            entry = {"path": ".".join(path), "value": value, "choices": edit.choices(path), "help": words}
            result.append(entry)
    return result


def change(settings: Any, path: str, value: str) -> str:
    """Set a setting from a text; return "" or the reason of the rejection."""
    edit = Edit(settings)
    names = tuple(path.split("."))
    try:
        if not _may_be_changed(edit.value(names)):
            return f"{path} cannot be changed by a page"
        edit.set(names, value)
    except (AttributeError, KeyError, TypeError, ValueError, SyntaxError) as error:
        return str(error)
    return ""


def _may_be_changed(value: Any) -> bool:
    """Return whether a value is numbers, flags or choices: names of files and functions are not for pages."""
    return isinstance(value, Enum) or np.asarray(value).dtype.kind in "biuf"
