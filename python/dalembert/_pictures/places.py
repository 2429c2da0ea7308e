"""Positions and rotations of nodes, bodies and markers in one configuration."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert import _core
from dalembert._checks import FloatArray
from dalembert._core import ConfigurationType, OutputVariableType

Parameters = dict[tuple[str, int], dict[str, Any]]  # key: kind and number of an item
KINDS = ("Node", "Object", "Marker")
ORIGIN = (0.0, 0.0, 0.0)
frame_along = _core._frame_along
Position, RotationMatrix = OutputVariableType.Position, OutputVariableType.RotationMatrix


class Places:
    """Queries outputs of a system; None if an item has no position, or no orientation."""

    def __init__(
        self,
        mbs: Any,
        configuration: ConfigurationType,
        source: Any = None,
        items: Parameters | None = None,
        coarse: bool = False,
    ) -> None:
        """`source`, a _ScenePlaces of an assembled system, computes the poses of all items of a kind at once.

        `items` are cached parameters. `coarse`: points of meshes may have single precision, as in the viewer.
        """
        self._coarse = coarse
        self.mbs, self.configuration, self.source = mbs, configuration, source
        self.items: Parameters = {} if items is None else items
        self._rows: dict[str, FloatArray] = {}
        self._places: dict[str, list[bool]] = {}
        self._turns: dict[str, list[bool]] = {}

    def rows(self, kind: str) -> FloatArray | None:
        """Return rotation and position (n x 3 x 4) of all nodes, objects or markers, nan if undefined.

        None if the system is not assembled.
        """
        if self.source is None:
            return None
        if kind not in self._rows:
            self._rows[kind] = self.source.rows(KINDS.index(kind), self.configuration)
        return self._rows[kind]

    def turning(self, kind: str) -> npt.NDArray[np.bool_]:
        """Return for all items of a kind whether rows() has position and rotation."""
        rows = self.rows(kind)
        known = np.isfinite(np.zeros((0, 3, 4)) if rows is None else rows)
        return np.asarray(known.all(axis=(1, 2)))

    def turns(self, kind: str, number: int) -> bool:
        """Return whether rows() has position and rotation of an item."""
        return self.stands(kind, number) and self._turns[kind][int(number)]

    def stands(self, kind: str, number: int) -> bool:
        """Return whether rows() has the position of an item."""
        if kind not in self._places:
            if (rows := self.rows(kind)) is None:
                return False
            known = np.isfinite(rows)
            self._places[kind] = [bool(flag) for flag in np.all(known[:, :, 3], axis=1)]
            self._turns[kind] = [bool(flag) for flag in np.all(known, axis=(1, 2))]
        return self._places[kind][int(number)]

    def _place(self, kind: str, number: int) -> FloatArray | None:
        return self._rows[kind][number, :, 3] if self.stands(kind, number) else None

    def _turn(self, kind: str, number: int) -> FloatArray | None:
        return self._rows[kind][number, :, :3] if self.turns(kind, number) else None

    def item(self, kind: str, number: int) -> dict[str, Any]:
        """Return the parameters of an item; they are asked for once."""
        key = (kind, int(number))
        if key not in self.items:
            self.items[key] = getattr(self.mbs, f"Get{kind}")(int(number))
        return self.items[key]

    def forget(self, kind: str, number: int) -> None:
        """Remove the parameters of an item from the cache, which would become too large."""
        self.items.pop((kind, number), None)

    def _asked(self, method: str, number: int, variable: Any, *arguments: Any) -> FloatArray | None:
        try:
            value = getattr(self.mbs, method)(int(number), variable, *arguments, self.configuration)
        except (RuntimeError, ValueError, NotImplementedError, IndexError):
            return None
        array = np.asarray(value, float).reshape(-1)
        return array if math.isfinite(array.dot(array)) else None

    def node(self, number: int) -> FloatArray | None:
        """Return the position of a node; that of its body if it has no position."""
        if (place := self._place("Node", int(number))) is not None:
            return place
        if (place := self._asked("GetNodeOutput", number, Position)) is not None:
            frame = self._frame_of_node(int(number)) if self.source is None else None
            return place if frame is None else frame[0] + frame[1] @ place
        body = self._bodies_of_nodes().get(int(number))
        return None if body is None else self.body(body)

    def frame_of_output(self, node: int) -> tuple[FloatArray, FloatArray] | None:
        """Return position and rotation of the frame in whose components a node has its outputs; None for global
        ones."""
        return self._frame_of_node(node) if self._is_moved(node) else None

    def _is_moved(self, node: int) -> bool:
        """Return whether a node is elsewhere than its own output says."""
        own = self._asked("GetNodeOutput", node, Position)
        return own is not None and not np.array_equal(own, np.asarray(self.node(node)))

    def node_rotation(self, number: int) -> FloatArray | None:
        """Return the rotation matrix of a node: the axes of its coordinates."""
        if (known := self._turn("Node", int(number))) is not None:
            return known
        frame = self._frame_of_node(int(number)) if self.source is None else None
        return _matrix(self._asked("GetNodeOutput", number, RotationMatrix)) if frame is None else frame[1]

    def body(self, number: int, local: Any = ORIGIN) -> FloatArray | None:
        """Return the position of a point of a body."""
        if local is ORIGIN and (known := self._place("Object", int(number))) is not None:
            return known
        return self._asked("GetObjectOutputBody", number, Position, np.asarray(local, float))

    def body_rotation(self, number: int, local: Any = ORIGIN) -> FloatArray | None:
        """Return the rotation matrix of a body at one of its points."""
        if local is ORIGIN and (known := self._turn("Object", int(number))) is not None:
            return known
        return _matrix(self._asked("GetObjectOutputBody", number, RotationMatrix, np.asarray(local, float)))

    def body_output(self, number: int, variable: Any, local: Any = ORIGIN) -> FloatArray | None:
        """Return any output of a body at one of its points."""
        return self._asked("GetObjectOutputBody", number, variable, np.asarray(local, float))

    def mesh_output(self, number: int, variable: Any, mesh_node: int) -> FloatArray | None:
        """Return an output of a super element at a mesh node."""
        return self._asked("GetObjectOutputSuperElement", number, variable, int(mesh_node))

    def mesh_outputs(self, number: int, variable: Any) -> FloatArray | None:
        """Return an output of all mesh nodes of a super element, row by row; None if it has no mesh of its own."""
        if self.source is None:
            return None
        found = self.source.mesh(int(number), variable, self.configuration)
        return None if found is None else np.asarray(found)

    def mesh_points(self, number: int) -> FloatArray | None:
        """Return the positions of all mesh nodes of a super element."""
        if self._coarse and self.turns("Object", number):
            points = self.source.mesh_points(int(number), self._rows["Object"][number], self.configuration)
            if points is not None:
                return np.asarray(points)
        return self.mesh_outputs(number, OutputVariableType.Position)

    def mesh_numbers(self, number: int, variable: Any, component: int) -> FloatArray | None:
        """Return one number for each of them: a component of the output, or its length (-1)."""
        if self.source is None:
            return None
        return self.source.mesh_numbers(int(number), variable, component, self.configuration)

    def node_output(self, number: int, variable: Any) -> FloatArray | None:
        """Return any output of a node."""
        return self._asked("GetNodeOutput", number, variable)

    def shown_output(self, node: int, variable: Any) -> FloatArray | None:
        """Return an output of a node in global components, also of one that moves in a floating frame."""
        if self._is_moved(node) and (known := self._nodes_in_frames().get(node)) is not None:
            body, number, _ = known
            return self.mesh_output(body, variable, number)
        return self.node_output(node, variable)

    def marker(self, number: int) -> FloatArray | None:
        """Return the position of a marker; that of its node or body if it stands for coordinates."""
        if self.rows("Marker") is not None:
            place = self._place("Marker", int(number))
        else:
            place = self._asked("GetMarkerOutput", number, Position)
        if place is not None and len(place) == 3:
            return place
        kind, owner = self._owner(number)
        if kind == "Node":
            return self.node(owner)
        # Markers are on bodies; a marker on a connector, which Assemble rejects, could cause an infinite recursion.
        if kind == "Object" and "markerNumbers" not in self.item("Object", owner):
            return self.object(owner)
        return None

    def _owner(self, marker: int) -> tuple[str, int]:
        """Return the carrier of a marker."""
        parameters = self.item("Marker", marker)
        if "nodeNumber" in parameters:
            return "Node", int(parameters["nodeNumber"])
        for name in ("bodyNumber", "objectNumber"):
            if name in parameters:
                return "Object", int(parameters[name])
        return ("Object", int(parameters["bodyNumbers"][0])) if "bodyNumbers" in parameters else ("", -1)

    def seat(self, marker: int) -> tuple[str, int]:
        """Return the item that moves with a marker: itself, or its carrier if it refers to coordinates or a mass."""
        return ("Marker", int(marker)) if self.stands("Marker", marker) else self._owner(marker)

    def marker_rotation(self, number: int) -> FloatArray:
        """Return the rotation matrix of a marker; no rotation if it has no orientation."""
        if self.rows("Marker") is not None:
            matrix = self._turn("Marker", int(number))
        else:
            matrix = _matrix(self._asked("GetMarkerOutput", number, RotationMatrix))
        return np.eye(3) if matrix is None else matrix

    def object(self, number: int) -> FloatArray | None:
        """Return the position of an object: the reference point of a body, the middle of the markers of other
        objects."""
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

    def _frame_of_node(self, number: int) -> tuple[FloatArray, FloatArray] | None:
        """Return position and rotation of the floating frame of a mesh node; None if it has none."""
        known = self._nodes_in_frames().get(number)
        return None if known is None else self.frame(known[2])

    def _nodes_in_frames(self) -> dict[int, tuple[int, int, int]]:
        """Return body, number of the mesh node, and node of the frame, for all nodes of meshes in floating frames."""
        if not hasattr(self, "_meshes"):
            self._meshes: dict[int, tuple[int, int, int]] = {}
            for body in range(self.mbs.systemData.NumberOfObjects()):
                parameters = self.item("Object", body)
                if parameters["objectType"] == "FFRF" and len(parameters["nodeNumbers"]):
                    frame, *mesh = (int(node) for node in parameters["nodeNumbers"])
                    self._meshes |= {node: (body, number, frame) for number, node in enumerate(mesh)}
        return self._meshes

    def frame(self, node: int) -> tuple[FloatArray, FloatArray] | None:
        """Return position and rotation of a node; None if it does not have both."""
        place, rotation = self.node(node), self.node_rotation(node)
        return None if place is None or rotation is None else (place, rotation)

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
