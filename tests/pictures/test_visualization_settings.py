"""Every setting of VisualizationSettings either says something about pictures, or is on the list of those that do not."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import dalembert as exu
from dalembert._pictures.without_effect import WITHOUT_EFFECT

PACKAGE = Path(exu.__file__).resolve().parent
SOURCES = sorted([*PACKAGE.glob("_pictures/*.py"), *PACKAGE.glob("_live/*.py")])
TEXT = "\n".join(path.read_text() for path in SOURCES if path.stem != "without_effect")


def leaves(settings: Any, path: str = "") -> Iterator[str]:
    """Paths of all settings; views 1 to 3 have those of view 0."""
    for name, value in settings.GetDictionary().items():
        below = getattr(settings, name)
        if re.fullmatch("view[123]", name):
            continue
        if isinstance(value, dict) and hasattr(below, "GetDictionary"):
            yield from leaves(below, f"{path}{name}.")
        else:
            yield path + name


SETTINGS = list(leaves(exu.VisualizationSettings()))


def listed(path: str) -> bool:
    return any(path == known or path.startswith(f"{known}.") for known in WITHOUT_EFFECT)


def read(path: str) -> bool:
    """Whether the sources ask for a setting: its name stands there, or that of its numbered kind."""
    name = path.rpartition(".")[2]
    return re.search(rf"\b{re.sub('[0-9]$', '', name)}(\b|\{{)", TEXT) is not None


def test_there_are_all_of_them() -> None:
    assert len(SETTINGS) > 300


def test_a_setting_is_read_or_on_the_list() -> None:
    assert [path for path in SETTINGS if not listed(path) and not read(path)] == []


def test_the_list_has_no_others() -> None:
    unknown = [k for k in WITHOUT_EFFECT if not any(path == k or path.startswith(f"{k}.") for path in SETTINGS)]
    assert unknown == []


def test_what_is_on_the_list_is_not_read() -> None:
    assert [path for path in WITHOUT_EFFECT if re.search(rf'"{re.escape(path)}["./]', TEXT)] == []
