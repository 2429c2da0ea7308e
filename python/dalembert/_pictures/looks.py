"""Sizes and colors: those of the item, of the settings, or in proportion to the scene."""

from __future__ import annotations

import copy
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import lru_cache
from math import log2
from typing import Any

from dalembert import _core
from dalembert._pictures.meshes import Rgba
from dalembert.graphics import material


@lru_cache(maxsize=1)
def _defaults() -> Any:
    return _core.VisualizationSettings()


@lru_cache
def _default(path: str) -> Any:
    return _below(_defaults(), path)


def _below(settings: Any, path: str) -> Any:
    for name in path.split("."):
        settings = getattr(settings, name)
    return settings


def clip(view: Any) -> list[float]:
    """Return normal and distance of the plane that cuts a view."""
    return [*(float(x) for x in view.camera.clippingPlaneNormal), float(view.camera.clippingPlaneDistance)]


MOST_WINDINGS = 500  # larger numbers are not distinguishable


@dataclass
class Looks:
    """Settings, and the size of the scene: lengths that nobody has chosen are in proportion to it."""

    settings: Any
    size: float = 1.0
    crowd: int = 0  # how many objects there are
    forces: bool = False  # arrows of forces are drawn, in place of those of loads
    _windings: dict[int, int] = field(default_factory=dict)  # by number of the spring
    _slenderness: dict[int, float] = field(default_factory=dict)
    _known: Any = None  # a copy of the settings
    _kept: dict[str, Any] = field(default_factory=dict)  # cache of derived values
    _keeps: bool = False

    @contextmanager
    def kept(self) -> Iterator[None]:
        """Ask for every setting once, until some have changed; they stay as they are while one scene is made."""
        if not self._keeps and (self._known is None or not self.settings._equals(self._known)):
            self._known, self._kept = copy.copy(self.settings), {}
        before, self._keeps = self._keeps, True
        try:
            yield
        finally:
            self._keeps = before

    def setting(self, path: str) -> Any:
        """Return a setting, such as connectors.defaultSize."""
        if not self._keeps:
            return _below(self.settings, path)
        if path not in self._kept:
            self._kept[path] = _below(self._known, path)
        return self._kept[path]

    def derived(self, name: str, make: Callable[[], Any]) -> Any:
        """Return a cached value that depends only on settings."""
        if not self._keeps:
            return make()
        if name not in self._kept:
            self._kept[name] = make()
        return self._kept[name]

    def of_pages(self) -> dict[str, Any]:
        """Return the global settings for the viewer."""
        view = self.settings.view0
        return {
            "background": list(self.settings.general.backgroundColor)[:3],
            "transparent": float(self.settings.openGL.faceTransparencyGlobal) if view.scene.facesTransparent else 1.0,
            "edges": bool(view.scene.showFaceEdges),
            "faces": bool(view.scene.showFaces),
            "clip": clip(view),
        }

    def is_default(self, path: str) -> bool:
        """Return whether a setting has its default."""
        return bool(_default(path) == self.setting(path))

    def length(self, path: str, part: float) -> float:
        """Return a length of the settings; the default is a fraction of the scene size."""
        value = float(self.setting(path))
        return part * self.size if value < 0 or self.is_default(path) else value

    def item_length(self, value: float, default: float, part: float) -> float:
        """Return a length of an item; a part of the scene if it is the default."""
        return part * self.size if abs(value - default) < 1e-6 else value

    def slenderness(self, number: int, value: float) -> float:
        """Return the slenderness for drawing a spring: one of a few values, kept until the spring is much longer or
        shorter.
        """
        known, much = self._slenderness.get(number, 0.0), _core._MovingParts.stretch**0.7
        if not known / much < value < known * much:
            known = self._slenderness[number] = float(2.0 ** (0.5 * round(2 * log2(max(value, 1e-3)))))
        return known

    def windings(self, number: int, slenderness: float) -> int:
        """Return how many windings a spring has in all pictures of a film; unless it is set, more if it is long."""
        wanted = min(max(int(self.setting("connectors.springNumberOfWindings")), 1), MOST_WINDINGS)
        if not self.is_default("connectors.springNumberOfWindings"):
            return wanted
        return self._windings.setdefault(number, int(min(max(0.7 * slenderness, wanted), 5 * wanted)))

    def draw_size(self, item: dict[str, Any], path: str, part: float) -> float:
        """Return VdrawSize of an item, or the default size of its kind."""
        value = float(item.get("VdrawSize", -1.0))
        return value if value >= 0 else self.length(path, part)

    def crowded(self, part: float) -> float:
        """Return the part of the scene that a ball takes: a smaller one where many could hide each other."""
        return float(part * min(1.0, 7 / max(self.crowd, 1) ** (1 / 3)))

    def node_size(self, item: dict[str, Any]) -> float:
        """Return the diameter of a node."""
        return self.draw_size(item, "nodes.defaultSize", self.crowded(0.02))

    def color(self, item: dict[str, Any], path: str, name: str = "Vcolor") -> Rgba:
        """Return the color of an item, or the default color of its kind."""
        value = item.get(name, (-1.0,))
        return rgba(value) if value[0] >= 0 else self.default_color(path)

    def default_color(self, path: str) -> Rgba:
        """Return the default color of a kind."""
        color: Rgba = self.derived(f"{path} as color", lambda: rgba(self.setting(path)))
        return color


@lru_cache(maxsize=1)
def _materials() -> Any:
    return _core.GraphicsMaterialList()


def rgba(value: Any, default: Rgba = (0.4, 0.4, 0.9, 1.0)) -> Rgba:
    """Return red, green, blue and opacity.

    A negative red stands for the color of the material, whose index is in the place of the opacity, or for the default.
    """
    r, g, b, a = (float(v) for v in value)
    if a >= material.indexBase:
        chosen = _materials()[min(int(a) - material.indexBase, len(_materials()) - 1)]
        r, g, b = chosen.baseColor if r < 0 else (r, g, b)
        return (float(r), float(g), float(b), float(chosen.alpha))
    return default if r < 0 else (r, g, b, min(max(a, 0.0), 1.0))
