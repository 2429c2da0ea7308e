"""Drawing of rigid bodies, masses and ground: by graphics data, or by rods to their markers."""

from __future__ import annotations

from contextvars import ContextVar
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import IntArray
from dalembert._pictures import contour, graphics_data
from dalembert._pictures.contour import Contour
from dalembert._pictures.meshes import Mesh, Rgba
from dalembert._pictures.pen import Pen
from dalembert._pictures.places import Places

Item = dict[str, Any]
# Systems and numbers of objects whose functions are being asked.
_drawing: ContextVar[tuple[tuple[Any, int], ...]] = ContextVar("_drawing", default=())


class Bodies:
    """Draws bodies; graphics data are read once."""

    def __init__(self, mbs: Any) -> None:
        self.mbs = mbs
        self._shapes: dict[int, list[graphics_data.Shape]] = {}
        self._known = graphics_data.Known()
        self._default: Rgba | None = None
        self._markers: dict[int, list[int]] | None = None

    def shapes(self, pen: Pen, number: int, item: Item) -> list[graphics_data.Shape]:
        """Return the shapes of a body, and those that its user function gives for this picture."""
        default = pen.looks.default_color("bodies.defaultColor")
        if default != self._default:  # default color of meshes without colors
            self._default, self._shapes, self._known = default, {}, graphics_data.Known()
        if not callable(item.get("VgraphicsDataUserFunction")) and (known := self._shapes.get(number)) is not None:
            return known
        owner = f"object {number} '{item['name']}'"
        if number not in self._shapes:
            data = self.mbs.GetObject(number, True)
            self._shapes[number] = graphics_data.shapes(data.get("VgraphicsData") or [], default, owner, self._known)
        return self._shapes[number] + user_shapes(self.mbs, number, item, default, owner)

    def meshes(self, pen: Pen, number: int, item: Item) -> list[Mesh] | None:
        """Return the meshes of a body; [] if it has no shape, None if it also has other graphics."""
        if callable(item.get("VgraphicsDataUserFunction")):
            return None
        shapes = self.shapes(pen, number, item)
        if not shapes:
            return None if self._markers_of(number) else []
        return [what for _, what, _ in shapes] if all(shape[0] == "mesh" for shape in shapes) else None

    def draw(self, pen: Pen, colors: Contour, number: int, item: Item) -> None:
        """Draw a body in its frame."""
        place = pen.places.body(number)
        if place is None:
            return
        rotation = pen.places.body_rotation(number)
        rotation = np.eye(3) if rotation is None else rotation
        if not callable(item.get("VgraphicsDataUserFunction")):
            pen.stick("Object", number)
        if shapes := self.shapes(pen, number, item):
            values = None if item["objectType"] == "Ground" else contour.of_body(pen, colors, number)
            graphics_data.draw(pen, shapes, place, rotation, values)
        elif item["objectType"] != "Ground":
            self._draw_bare(pen, number, item)

    def _draw_bare(self, pen: Pen, number: int, item: Item) -> None:
        """Draw rods from the reference point to the markers of a body; a ball for a mass.

        They hide the node, and have its color, if it has one of its own.
        """
        place = pen.places.body(number)
        (radius, color), thick = self.ball(pen), self._thick(pen)
        if 0 <= (node := int(item["nodeNumber"])) < self.mbs.systemData.NumberOfNodes():
            color = pen.looks.color(pen.places.item("Node", node), "bodies.defaultColor")
        if place is None:
            return
        ends = [pen.places.marker(marker) for marker in self._markers_of(number)]
        far = [end for end in ends if end is not None and np.linalg.norm(end - place) > thick]
        if item["objectType"].startswith("Mass") or not far:
            pen.sphere(place, radius, color)
        for end in far:
            pen.cylinder(place, end, thick, color)
            pen.sphere(end, thick, color)
        if far:
            pen.sphere(place, thick, color)

    def ball(self, pen: Pen) -> tuple[float, Rgba]:
        """Return radius and color of the ball that stands for a body without shapes and markers."""
        return 2.2 * self._thick(pen), pen.looks.default_color("bodies.defaultColor")

    @staticmethod
    def _thick(pen: Pen) -> float:
        """Return the radius of rods."""
        return float(pen.looks.crowded(0.007) * pen.looks.size)

    def with_markers(self, numbers: IntArray) -> npt.NDArray[np.bool_]:
        """Return which bodies have markers."""
        return np.array([bool(self._markers_of(number)) for number in numbers.tolist()], bool)

    def forget_markers(self) -> None:
        """Look again which markers are on which body: items have changed."""
        self._markers = None

    def _markers_of(self, body: int) -> list[int]:
        if self._markers is None:
            self._markers = {}
            for marker in range(self.mbs.systemData.NumberOfMarkers()):
                parameters = self.mbs.GetMarker(marker)
                if "bodyNumber" in parameters:
                    self._markers.setdefault(int(parameters["bodyNumber"]), []).append(marker)
        return self._markers.get(body, [])


def node_in_place_of(places: Places, item: Item) -> int | None:
    """Return the node that represents a mass without shape, as made by CreateMassPoint; None for other bodies."""
    if item.get("Vshow", True) or not item.get("objectType", "").startswith("MassPoint"):
        return None
    node = int(item["nodeNumber"])
    return node if places.item("Node", node).get("Vshow", True) else None


def user_shapes(mbs: Any, number: int, item: Item, default: Any, owner: str) -> list[graphics_data.Shape]:
    """Return the result of the graphicsDataUserFunction of an object."""
    function = item.get("VgraphicsDataUserFunction")
    if not callable(function):
        return []
    if any(system is mbs and other == number for system, other in _drawing.get()):
        raise RuntimeError(
            f"{owner}: its graphicsDataUserFunction draws the system that it belongs to, and would be called again "
            "without end; let it return graphics data"
        )
    begun = _drawing.set((*_drawing.get(), (mbs, number)))
    try:
        drawn = function(mbs, number)
    except Exception as error:
        error.add_note(f"raised by the graphicsDataUserFunction of {owner}")
        raise
    finally:
        _drawing.reset(begun)
    return graphics_data.shapes(drawn, default, f"{owner}: graphicsDataUserFunction")
