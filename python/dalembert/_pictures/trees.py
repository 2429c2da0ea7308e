"""How kinematic trees are drawn: frames of links from the joint coordinates, graphics data, joints and rods."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._core import ConfigurationType, JointType, OutputVariableType
from dalembert._pictures import graphics_data
from dalembert._pictures.looks import rgba
from dalembert._pictures.pen import Pen

Item = dict[str, Any]
TINY = 1e-300  # of squares of lengths, in place of zero


class Trees:
    """Draws kinematic trees; graphics data are read once."""

    def __init__(self, mbs: Any) -> None:
        self.mbs = mbs
        self._shapes: dict[int, list[list[graphics_data.Shape]]] = {}
        self._ends: dict[int, list[tuple[int, FloatArray]]] | None = None  # by tree: link and place of markers

    def shapes(self, pen: Pen, number: int, name: str) -> list[list[graphics_data.Shape]]:
        """Return the shapes of each link; an empty list if there are no graphics data."""
        if number not in self._shapes:
            default = rgba(pen.looks.setting("bodies.defaultColor"))
            data = self.mbs.GetObject(number, True).get("VgraphicsDataList") or []
            self._shapes[number] = [
                graphics_data.shapes(link or [], default, f"object {number} '{name}', link {k}")
                for k, link in enumerate(data)
            ]
        return self._shapes[number]

    def forget_markers(self) -> None:
        """Look again which markers are on which tree: items have changed."""
        self._ends = None

    def draw(self, pen: Pen, number: int, item: Item) -> None:
        """Draw links, as their graphics data or as rods between the joints; joints where there are no graphics data."""
        draw(pen, item, self.shapes(pen, number, item["name"]), self._ends_of(number))

    def link_at(self, pen: Pen, number: int, item: Item, point: FloatArray) -> int:
        """Return the link that is nearest to a point, or -1 for the base; the pen has an empty scene."""
        links, carrier, scene = list[int](), [-1], pen.scene

        def carries(link: int) -> None:
            links.extend(carrier * (len(scene.instances) - len(links)))
            carrier[0] = link

        draw(pen, item, self.shapes(pen, number, item["name"]), self._ends_of(number), carries)
        carries(-1)
        distances = [
            distance((part.mesh.points @ part.matrix.T + part.place)[part.mesh.triangles], point)
            for part in scene.instances
        ]
        return links[int(np.argmin(distances))] if distances else -1

    def _ends_of(self, tree: int) -> list[tuple[int, FloatArray]]:
        """Return the links that markers are on, and where, in the frames of the links."""
        if self._ends is None:
            self._ends = {}
            for marker in range(self.mbs.systemData.NumberOfMarkers()):
                item = self.mbs.GetMarker(marker)
                if item["markerType"] == "KinematicTreeRigid":
                    end = int(item["linkNumber"]), np.asarray(item["localPosition"], float)
                    self._ends.setdefault(int(item["objectNumber"]), []).append(end)
        return self._ends.get(tree, [])


def distance(triangles: FloatArray, point: FloatArray) -> float:
    """Return the distance of a point from the nearest of some triangles (n x 3 x 3)."""
    found = [np.inf]
    first, sides = triangles, np.roll(triangles, -1, axis=1) - triangles
    along = np.einsum("nki,nki->nk", point - first, sides) / np.maximum(np.einsum("nki,nki->nk", sides, sides), TINY)
    nearest = first + np.clip(along, 0, 1)[:, :, None] * sides
    found.extend(np.linalg.norm(nearest - point, axis=2).min(axis=1))
    normals = np.cross(sides[:, 0], sides[:, 1])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), TINY)
    inside = normals.any(axis=1) & (
        np.einsum("nki,nki->nk", np.cross(normals[:, None], sides), point - first) >= 0
    ).all(axis=1)
    found.extend(np.abs(np.einsum("ni,ni->n", point - first[:, 0], normals))[inside])
    return float(min(found))


def draw(
    pen: Pen,
    item: Item,
    data: list[list[graphics_data.Shape]],
    ends: list[tuple[int, FloatArray]] | None = None,
    carries: Callable[[int], object] = lambda link: None,
) -> None:
    """Draw the links and joints of a tree; links without graphics data reach to these ends, too.

    `carries` is called with the link, or -1 for the base, with which the parts that are drawn next move.
    """
    frames = link_frames(pen, item)
    color, joint = pen.looks.color(item, "bodies.defaultColor"), rgba(pen.looks.setting("connectors.defaultColor"))
    thick, size = 0.008 * pen.looks.size, pen.looks.length("connectors.jointAxesLength", 0.04)
    base, settings = np.asarray(item["baseOffset"], float), pen.looks.setting("bodies.kinematicTree")
    for link, (place, rotation) in enumerate(frames):
        carries(link)
        if data and item["VshowLinks"] and link < len(data):
            graphics_data.draw(pen, data[link], place, rotation)
        elif item["VshowLinks"]:
            parent = int(item["linkParents"][link])
            carries(parent)
            pen.cylinder(frames[parent][0] if parent >= 0 else base, place, thick, color)
            carries(link)
            if link not in item["linkParents"]:  # last link of a chain: to its center of mass
                pen.cylinder(place, place + rotation @ np.asarray(item["linkCOMs"][link], float), thick, color)
            for _, end in (end for end in ends or [] if end[0] == link):
                pen.cylinder(place, place + rotation @ end, thick, color)
        if item["VshowJoints"] and not data:
            half = 0.5 * size * rotation[:, _axis(item, link)]
            pen.cylinder(place - half, place + half, 1.6 * thick, joint)
        if settings.showJointFrames and not data:
            pen.frame(place, rotation, pen.looks.length("bodies.kinematicTree.frameSize", 0.06))
        if settings.showCOMframes:
            center = place + rotation @ np.asarray(item["linkCOMs"][link], float)
            pen.frame(center, rotation, pen.looks.length("bodies.kinematicTree.frameSize", 0.06))
        if settings.showFramesNumbers:
            pen.label(place, f"{item['name']}: {link}")


def link_frames(pen: Pen, item: Item) -> list[tuple[FloatArray, FloatArray]]:
    """Return position and rotation of each link: those of its parent, the joint's transformation, and its motion."""
    q = _coordinates(pen, int(item["nodeNumber"]))
    frames: list[tuple[FloatArray, FloatArray]] = []
    for link, parent in enumerate(item["linkParents"]):
        place, rotation = frames[parent] if parent >= 0 else (np.asarray(item["baseOffset"], float), np.eye(3))
        place = place + rotation @ np.asarray(item["jointOffsets"][link], float)
        rotation = rotation @ np.asarray(item["jointTransformations"][link], float)
        axis = _axis(item, link)
        if int(item["jointTypes"][link]) <= int(JointType.RevoluteZ):
            rotation = rotation @ _about(axis, float(q[link]))
        else:
            place = place + q[link] * rotation[:, axis]
        frames.append((place, rotation))
    return frames


def _axis(item: Item, link: int) -> int:
    """Return the axis of a joint: 0, 1 or 2."""
    return (int(item["jointTypes"][link]) - int(JointType.RevoluteX)) % 3


def _coordinates(pen: Pen, node: int) -> FloatArray:
    """Return the joint coordinates, with those of the reference configuration."""
    reference = np.asarray(pen.places.item("Node", node)["referenceCoordinates"], float)
    if pen.places.configuration == ConfigurationType.Reference:
        return reference
    values = pen.places.node_output(node, OutputVariableType.Coordinates)
    return reference if values is None else reference + values


def _about(axis: int, angle: float) -> FloatArray:
    j, k = (axis + 1) % 3, (axis + 2) % 3
    matrix = np.eye(3)
    matrix[j, j] = matrix[k, k] = np.cos(angle)
    matrix[j, k], matrix[k, j] = -np.sin(angle), np.sin(angle)
    return matrix
