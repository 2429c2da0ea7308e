"""Where things are: positions and rotations of nodes, bodies and markers in one configuration."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._core import ConfigurationType, OutputVariableType

Position, RotationMatrix = OutputVariableType.Position, OutputVariableType.RotationMatrix


class Places:
    """Asks a system for outputs; None where an item has no place, or no orientation."""

    def __init__(self, mbs: Any, configuration: ConfigurationType) -> None:
        self.mbs, self.configuration = mbs, configuration
        self.items: dict[tuple[str, int], dict[str, Any]] = {}

    def item(self, kind: str, number: int) -> dict[str, Any]:
        """Return the parameters of an item; they are asked for once."""
        key = (kind, int(number))
        if key not in self.items:
            self.items[key] = getattr(self.mbs, f"Get{kind}")(int(number))
        return self.items[key]

    def _asked(self, method: str, number: int, variable: Any, *arguments: Any) -> FloatArray | None:
        try:
            value = getattr(self.mbs, method)(int(number), variable, *arguments, self.configuration)
        except (RuntimeError, ValueError, NotImplementedError, IndexError):
            return None
        array = np.asarray(value, float).reshape(-1)
        return array if math.isfinite(array @ array) else None

    def node(self, number: int) -> FloatArray | None:
        """Return the position of a node; that of its body if it has none itself."""
        place = self._asked("GetNodeOutput", number, Position)
        if place is not None:
            return place
        body = self._bodies_of_nodes().get(int(number))
        return None if body is None else self.body(body)

    def node_rotation(self, number: int) -> FloatArray | None:
        """Return the rotation matrix of a node."""
        return _matrix(self._asked("GetNodeOutput", number, RotationMatrix))

    def body(self, number: int, local: Any = (0.0, 0.0, 0.0)) -> FloatArray | None:
        """Return the position of a point of a body."""
        return self._asked("GetObjectOutputBody", number, Position, np.asarray(local, float))

    def body_rotation(self, number: int, local: Any = (0.0, 0.0, 0.0)) -> FloatArray | None:
        """Return the rotation matrix of a body at one of its points."""
        return _matrix(self._asked("GetObjectOutputBody", number, RotationMatrix, np.asarray(local, float)))

    def body_output(self, number: int, variable: Any, local: Any = (0.0, 0.0, 0.0)) -> FloatArray | None:
        """Return any output of a body at one of its points."""
        return self._asked("GetObjectOutputBody", number, variable, np.asarray(local, float))

    def mesh_output(self, number: int, variable: Any, mesh_node: int) -> FloatArray | None:
        """Return an output of a super element at a mesh node."""
        return self._asked("GetObjectOutputSuperElement", number, variable, int(mesh_node))

    def node_output(self, number: int, variable: Any) -> FloatArray | None:
        """Return any output of a node."""
        return self._asked("GetNodeOutput", number, variable)

    def marker(self, number: int) -> FloatArray | None:
        """Return the position of a marker; that of its node or body if it stands for coordinates."""
        place = self._asked("GetMarkerOutput", number, Position)
        if place is not None and len(place) == 3:
            return place
        marker = self.item("Marker", number)
        if "nodeNumber" in marker:
            return self.node(marker["nodeNumber"])
        for name in ("bodyNumber", "objectNumber"):
            if name in marker:
                return self.object(marker[name])
        return self.body(marker["bodyNumbers"][0]) if "bodyNumbers" in marker else None

    def marker_rotation(self, number: int) -> FloatArray:
        """Return the rotation matrix of a marker; no rotation if it has no orientation."""
        matrix = _matrix(self._asked("GetMarkerOutput", number, RotationMatrix))
        return np.eye(3) if matrix is None else matrix

    def object(self, number: int) -> FloatArray | None:
        """Return where an object is: a body its reference point, others the middle of what they join."""
        place = self.body(number)
        if place is not None:
            return place
        parameters = self.item("Object", number)
        if "nodeNumber" in parameters and "markerNumbers" not in parameters:
            return self.node(parameters["nodeNumber"])
        asked = [self.marker(m) for m in parameters.get("markerNumbers", [])] or [
            self.node(n) for n in parameters.get("nodeNumbers", [])
        ]
        known = [place for place in asked if place is not None]
        return np.mean(known, axis=0) if known else None

    def _bodies_of_nodes(self) -> dict[int, int]:
        """Return the body on each node without position, such as that of a mass that moves along a line."""
        if not hasattr(self, "_bodies"):
            self._bodies: dict[int, int] = {}
            for number in range(self.mbs.systemData.NumberOfObjects()):
                parameters = self.item("Object", number)
                if "nodeNumber" in parameters and parameters["objectType"].startswith(("Mass1D", "RotationalMass1D")):
                    self._bodies[int(parameters["nodeNumber"])] = number
        return self._bodies


def _matrix(values: FloatArray | None) -> FloatArray | None:
    return None if values is None or len(values) != 9 else values.reshape(3, 3)


def frame_along(axis: FloatArray, across: FloatArray | None = None) -> FloatArray:
    """Return a rotation matrix whose third column is along an axis; its first one is near `across`, if given."""
    z = axis / max(float(np.linalg.norm(axis)), 1e-300)
    x = np.eye(3)[np.argmin(np.abs(z))] if across is None or abs(across @ z) > 0.999 else across
    x = x - (x @ z) * z
    x = x / np.linalg.norm(x)
    return np.stack([x, np.cross(z, x), z], axis=1)
