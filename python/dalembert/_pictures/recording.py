"""Images that a solver records: simulationSettings.solutionSettings.recordImagesInterval."""

from __future__ import annotations

import weakref
from typing import Any

from dalembert._pictures.studio import Studio, save_next

_last: tuple[weakref.ref[Any], int, float, Studio] | None = None


def record(mbs: Any) -> None:
    """Save an image of the visualization state; called by solvers between two steps."""
    studio = _studio_of(mbs)
    scene = studio.scene()
    save_next(studio.settings.exportImages, studio.image(scene, studio.camera(scene)), quickly=True)


def _studio_of(mbs: Any) -> Studio:
    """Return the studio of the last image, as long as it was one of the same solution."""
    global _last
    data = mbs.systemData
    items = sum(getattr(data, f"NumberOf{kind}s")() for kind in ("Node", "Object", "Marker", "Load", "Sensor"))
    time = float(data.GetTime())
    if _last is not None and _last[0]() is mbs and _last[1] == items and time > _last[2]:
        studio = _last[3]
    else:
        studio = Studio(mbs.GetSystemContainer())
        studio.show()
    _last = (weakref.ref(mbs), items, time, studio)
    return studio
