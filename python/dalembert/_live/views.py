"""Data of views for the browser: camera, section plane, and style."""

from __future__ import annotations

from typing import Any

from dalembert._pictures.contour import palette
from dalembert._pictures.looks import Looks, clip
from dalembert._pictures.renderer import state_of
from dalembert._pictures.scene import Scene
from dalembert._pictures.studio import Studio


def words(settings: Any, scene: Scene, looks: Looks) -> dict[str, Any]:
    """Return the settings that the browser needs besides the scene."""
    return {
        **looks.of_pages(),
        "contour": {"name": scene.value_name, "colors": palette(looks)} if scene.value_name else None,
        "marks": bool(settings.interactive.advanced.selectionHighlights),
        "steps": [
            float(settings.interactive.advanced.keypressTranslationStep),
            float(settings.interactive.advanced.keypressRotationStep),
            float(settings.interactive.advanced.zoomStepFactor),
        ],
    }


def beside(container: Any, studio: Studio, scene: Scene) -> list[dict[str, Any]]:
    """Return the enabled additional views."""
    states = {number: state_of(container.renderer, number) for number in (1, 2, 3)}
    return [
        {"number": n, "camera": studio.camera(scene, n).words(), "clip": clip(studio.view(n))}
        for n, state in states.items()
        if state.get("viewEnabled")
    ]
