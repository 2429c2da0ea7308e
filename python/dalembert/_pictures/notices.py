"""Words for settings that are not at their defaults and change nothing of what is made: once for each of them."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from operator import attrgetter
from typing import Any

import numpy as np

from dalembert import _core

Silent = dict[str, tuple[Any, str]]  # defaults of settings, and why they change nothing, by their paths

LIGHTS, VIEWS = range(4), range(4)
OF_RAYS = ("shadow", "lightRadius", "useCameraFrame", "linearAttenuation", "quadraticAttenuation")
OF_LIGHTS = (*OF_RAYS, "constantAttenuation", "diffuse", "enable", "position", "specular")
# Why pages do not follow settings that pictures follow.
OF_PICTURES = {
    "pages have lights, lines and words of their own": (
        *("contour.advanced.colorBarPrecision", "contour.advanced.colorBarTiling", "general.backgroundColorBottom"),
        *("general.coordinateSystemSize", "general.renderWindowString", "general.rendererPrecision"),
        *("general.showSolverTime", "general.textHasBackground", "general.useGradientBackground"),
        *("openGL.advanced.enableLighting", "openGL.advanced.shadeModelSmooth", "openGL.faceEdgesColor"),
        *("openGL.lightModelAmbient", "openGL.lineWidth", "openGL.materialShininess", "openGL.materialSpecular"),
        *("openGL.multiSampling", "sensors.traces.lineWidth"),
        *(f"openGL.light{i}.{name}" for i in LIGHTS for name in OF_LIGHTS),
        *(f"view{i}.scene.{name}" for i in VIEWS for name in ("drawCoordinateSystem", "showLines")),
        *(f"view{i}.window.{name}" for i in VIEWS for name in ("globalFontSize", "showComputationInfo")),
    ),
    "pages have no rays": tuple(f"view{i}.camera.useRaytracer" for i in VIEWS),
    "pages look from where their readers want": tuple(
        f"view0.camera.trackMarker{what}" for what in ("", "MbsNumber", "Orientation", "Position")
    ),
}

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


@lru_cache(maxsize=1)
def settings_without_effect() -> Silent:
    """Return the settings that change nothing that is drawn here."""
    return _with_defaults(_core._visualization_settings_without_effect().items())


@lru_cache(maxsize=1)
def _settings_of_rays() -> Silent:
    reason = "only the ray tracer has it, see view0.camera.useRaytracer"
    return _with_defaults((f"openGL.light{i}.{name}", reason) for i in LIGHTS for name in OF_RAYS)


@lru_cache(maxsize=1)
def settings_of_pictures() -> Silent:
    """Return the settings that pictures follow and pages do not."""
    return _with_defaults(
        (path, reason)
        for reason, paths in OF_PICTURES.items()
        for path in paths
        if path not in settings_without_effect()
    )


def _with_defaults(reasons: Iterable[tuple[str, str]]) -> Silent:
    defaults = _core.VisualizationSettings()
    return {path: (attrgetter(path)(defaults), reason) for path, reason in reasons}


def _tell(settings: Any, silent: Silent, where: str = "") -> None:
    news: dict[str, list[str]] = {}
    for path, (default, reason) in silent.items():
        if (where, path) not in _told and not np.array_equal(attrgetter(path)(settings), default):
            _told.add((where, path))
            news.setdefault(reason, []).append(path)
    for reason, paths in news.items():
        _core.Print(f"WARNING: visualizationSettings: no effect {where}of {', '.join(paths)}: {reason}")
