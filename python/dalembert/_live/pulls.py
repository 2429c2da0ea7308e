"""Pulling a body with the mouse: a spring from a point of the body to the mouse acts on the solver.

The solver computes the force from its own state (_core._Shadow); here, the body and its point are found.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from dalembert._checks import FloatArray
from dalembert._live.records import Record
from dalembert._pictures.making import SceneMaker
from dalembert._pictures.scene import DrawnItem


def released(name: str) -> dict[str, Any]:
    """Return the message for pages that nobody holds this any more."""
    return {"kind": "grip", "id": name, "point": None}


class Pull:
    """A body that a page holds at a point; the constructor raises a ValueError for items that cannot be pulled."""

    def __init__(
        self,
        page: int,
        name: str,
        shadow: Any,
        maker: SceneMaker,
        picked: DrawnItem,
        point: FloatArray,
        record: Record,
        time: float,
    ) -> None:
        """`name` is that of the page for this drag.

        `point` is that of the picked item in the state that was shown at a time: it has moved on since then.
        """
        self.page, self.name, self._shadow, self._target = page, name, shadow, list[float]()
        body = body_of(shadow.system, picked)
        record.at(time, lambda: shadow.grab(body, point.tolist(), maker.link_at(body, point)))

    def pull(self, target: Sequence[float], strength: float) -> None:
        """Pull the point to another; `strength` is the stiffness of the spring per mass, in 1/s^2."""
        self._target = list(target)
        self._shadow.pull(target, strength)

    def end(self) -> None:
        """Remove the force."""
        self._shadow.release()

    def words(self) -> dict[str, Any]:
        """Return what pages show of it: the line from the point in the state that is shown to the mouse."""
        point = self._shadow.gripped
        if point is None or not self._target:
            return released(self.name)
        return {"kind": "grip", "id": self.name, "point": point, "target": self._target}


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
