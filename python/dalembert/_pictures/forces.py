"""Forces and torques of loads, joints, connectors and contacts as arrows in proportion to them.

They are drawn on request, and anew in each scene. The scale is one for all arrows; it follows the largest force so far.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from dalembert._checks import FloatArray
from dalembert._core import OutputVariableType
from dalembert._pictures import contacts, symbols
from dalembert._pictures.pen import Pen
from dalembert._pictures.scene import DrawnItem

KIND = contacts.FORCES
LONGEST = 0.2  # part of the size of the scene: length of the arrow of the reference force
COLOR = (0.85, 0.33, 0.0, 1.0)
STEPS = np.array([1.0, 2.0, 5.0, 10.0])
NOTHING = 1e-9  # part of the largest force: less is rounding


class Action(NamedTuple):
    """A force and a torque at a point, in global axes."""

    place: FloatArray
    force: FloatArray
    torque: FloatArray


class Forces:
    """Forces in one system: of loads except weight, of objects on the body of their second marker, and of contacts."""

    def __init__(self) -> None:
        self.references = np.zeros(2)  # force (N) and torque (Nm) of the arrows of full length
        self._actions: dict[tuple[str, int], list[Action]] = {}

    def measure(self, pen: Pen) -> None:
        """Find all forces in the state that is drawn."""
        mbs, none = pen.places.mbs, np.zeros(3)
        self._actions = {}
        for number in range(mbs.systemData.NumberOfObjects()):
            markers = pen.places.item("Object", number).get("markerNumbers")
            if markers is not None and len(markers) > 1 and (place := pen.places.marker(markers[1])) is not None:
                variable, configuration = OutputVariableType.WrenchOnMarker1, pen.places.configuration
                try:
                    wrench = np.asarray(mbs.GetObjectOutput(number, variable, configuration), float)
                except (RuntimeError, ValueError):  # an object without forces on markers, or an unknown multiplier
                    continue
                self._actions["Object", number] = [Action(place, wrench[:3], wrench[3:])]
        for number in range(mbs.systemData.NumberOfLoads()):
            item = pen.places.item("Load", number)
            if symbols.is_scaled(item) and (known := symbols.load_vector(pen, item)) is not None:
                place, vector, turns, _ = known
                self._actions["Load", number] = [Action(place, *((none, vector) if turns else (vector, none)))]
        for number in range(mbs.NumberOfGeneralContacts()):
            pairs = zip(*contacts.pushes(pen, number), strict=True)
            self._actions[contacts.KIND, number] = [Action(point, force, none) for point, force in pairs]
        for part in (0, 1):
            vectors = [action[1 + part] for many in self._actions.values() for action in many]
            largest = float(np.linalg.norm(vectors, axis=1).max()) if vectors else 0.0
            if np.isfinite(largest) and largest > self.references[part]:
                power = 10 ** np.floor(np.log10(largest))
                self.references[part] = power * STEPS[np.searchsorted(STEPS, largest / power * (1 - 1e-12))]

    def drawn_items(self, pen: Pen) -> list[DrawnItem]:
        """Return the forces as items of the scene: one for each item that can have one."""
        result = []
        for kind, number in self._actions:
            item = {} if kind == contacts.KIND else pen.places.item(kind, number)
            type_name = kind + item.get(f"{kind.lower()}Type", "")
            result.append(DrawnItem(KIND, number, type_name, item.get("name", "")))
        return result

    def draw(self, pen: Pen, item: DrawnItem) -> None:
        """Draw one of them."""
        length = LONGEST * pen.looks.size
        for action in self._actions.get((owner(item), item.number), []):
            for vector, reference, turns in zip(action[1:], self.references, (False, True), strict=True):
                part = float(np.linalg.norm(vector)) / reference if reference else 0.0
                if part <= NOTHING:
                    continue
                if turns:
                    pen.turning_arrow(action.place, vector, 0.5 * length * part, COLOR)
                else:
                    pen.arrow(action.place, length / reference * vector, 0.006 * pen.looks.size, COLOR)

    def words(self, size: float) -> str:
        """Return the scale of the arrows, for a scene of a size."""
        force, torque = self.references
        scales = [f"{value:g} {unit}" for value, unit in ((force, "N"), (torque, "Nm")) if value]
        return f"arrows: {LONGEST * size:.3g} m for {' or '.join(scales)}" if scales else "no forces"


def owner(item: DrawnItem) -> str:
    """Return the kind of the item that a force belongs to."""
    return next(kind for kind in ("Object", "Load", contacts.KIND) if item.type_name.startswith(kind))
