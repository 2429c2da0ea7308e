"""Pulling a body with the mouse: a spring from a point of the body to the mouse acts on the solver.

The solver computes the force from its own state; here, the point and the body are found, and the viewer learns where
the point is.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._core import ConfigurationType, OutputVariableType
from dalembert._pictures.scene import DrawnItem

SHOWN = ConfigurationType.Visualization
STEPS = 20  # of Newton's method for a local point; rigid bodies need one
NEAR = 1e-9  # relative tolerance of a local point


class Push:
    """A body that a page holds at a point."""

    def __init__(self, page: int, shadow: Any, body: int, local: FloatArray) -> None:
        """`local`: the point of the body that is held, in local coordinates."""
        self.page, self.shadow, self.body, self.local = page, shadow, body, local
        self.target: list[float] = []

    def pull(self, target: FloatArray, strength: float) -> None:
        """Pull the point to another; `strength` is the stiffness of the spring per mass, in 1/s^2."""
        self.target = target.tolist()
        self.shadow.push(self.body, tuple(self.local.tolist()), tuple(self.target), strength)

    def end(self) -> None:
        """Remove the force."""
        self.shadow.release()

    def words(self) -> dict[str, Any]:
        """Return what pages show of it: the line from the point in the state that is shown to the mouse."""
        return {
            "kind": "grip",
            "point": _place(self.shadow.system, self.body, self.local).tolist(),
            "target": self.target,
        }


RELEASED = {"kind": "grip", "point": None}


def body_of(mbs: Any, picked: DrawnItem) -> int:
    """Return the number of a picked object, or of the body on a picked node; ValueError for other items."""
    kind, number, type_name, name, _ = picked
    if kind == "Object":
        return number
    if kind == "Node":
        for body in range(mbs.systemData.NumberOfObjects()):
            item = mbs.GetObject(body)
            if number in (item.get("nodeNumber"), *item.get("nodeNumbers", ())) and "markerNumbers" not in item:
                return body
    raise ValueError(f"{kind.lower()} {number} '{name}' ({kind}{type_name}) belongs to no body; pull a body")


def local_point(mbs: Any, body: int, point: FloatArray) -> FloatArray:
    """Return the local position of a global point of a body in the state that is shown.

    Points beside a line or a surface, such as those on the skin of a beam without sections, get the nearest local one.
    """
    local = np.zeros(3)
    for _ in range(STEPS):
        place = _place(mbs, body, local)
        gap = point - place
        step = float(np.linalg.norm(gap)) or 1.0
        rates = [(_place(mbs, body, local + step * axis) - place) / step for axis in np.eye(3)]
        change = np.linalg.lstsq(np.transpose(rates), gap, rcond=NEAR)[0]
        local = local + change
        if np.linalg.norm(change) <= NEAR * np.linalg.norm(local):
            break
    return local


def _place(mbs: Any, body: int, local: FloatArray) -> FloatArray:
    return np.asarray(mbs.GetObjectOutputBody(body, OutputVariableType.Position, local, SHOWN), float)
