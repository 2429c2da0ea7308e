"""Warnings for changed settings without effect, once for each of them."""

from __future__ import annotations

from functools import lru_cache
from operator import attrgetter
from typing import Any

import numpy as np

from dalembert import _core

Silent = dict[str, tuple[Any, str]]  # defaults of settings, and why they change nothing, by their paths

_told: set[tuple[str, str]] = set()


def tell_settings_without_effect(settings: Any) -> None:
    """Print a notice for settings that have no effect at all."""
    _tell(settings, settings_without_effect())


def tell_settings_of_rays(settings: Any) -> None:
    """Print a notice for settings of lights that images have no part in that are made without the ray tracer."""
    _tell(settings, _settings_of_rays())


def tell_settings_of_pictures(settings: Any) -> None:
    """Print a notice for settings that pages do not follow."""
    _tell(settings, settings_of_pictures(), "on pages ")


def tell_once(text: str) -> None:
    """Print a notice of settings, unless it was printed before."""
    if (text, "") not in _told:
        _told.add((text, ""))
        _core.Print(f"WARNING: {text}")


def settings_without_effect() -> Silent:
    """Return the settings that change nothing that is drawn here."""
    return _silent()[0]


def settings_of_pictures() -> Silent:
    """Return the settings that pictures follow and pages do not."""
    return _silent()[1]


def _settings_of_rays() -> Silent:
    return _silent()[2]


@lru_cache(maxsize=1)
def _silent() -> tuple[Silent, ...]:
    return tuple(_with_defaults(reasons) for reasons in _core._visualization_settings_without_effect())


def _with_defaults(reasons: dict[str, str]) -> Silent:
    defaults = _core.VisualizationSettings()
    return {path: (attrgetter(path)(defaults), reason) for path, reason in reasons.items()}


def _tell(settings: Any, silent: Silent, where: str = "") -> None:
    news: dict[str, list[str]] = {}
    for path, (default, reason) in silent.items():
        if (where, path) not in _told and not np.array_equal(attrgetter(path)(settings), default):
            _told.add((where, path))
            news.setdefault(reason, []).append(path)
    for reason, paths in news.items():
        _core.Print(f"WARNING: visualizationSettings: no effect {where}of {', '.join(paths)}: {reason}")
