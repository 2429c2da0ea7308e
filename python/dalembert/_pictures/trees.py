"""How kinematic trees are drawn: frames of links from the joint coordinates, graphics data, joints and rods."""

from __future__ import annotations

from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._core import ConfigurationType, JointType, OutputVariableType
from dalembert._pictures import graphics_data
from dalembert._pictures.looks import rgba
from dalembert._pictures.pen import Pen

Item = dict[str, Any]


def draw(pen: Pen, number: int, item: Item) -> None:
    """Draw links, as their graphics data or as rods between the joints; joints where there are no graphics data."""
    frames = link_frames(pen, item)
    data = list(item.get("VgraphicsDataList") or [])
    color, joint = pen.looks.color(item, "bodies.defaultColor"), rgba(pen.looks.setting("connectors.defaultColor"))
    thick, size = 0.008 * pen.looks.size, pen.looks.length("connectors.jointAxesLength", 0.04)
    base = np.asarray(item["baseOffset"], float)
    for link, (place, rotation) in enumerate(frames):
        if data and item["VshowLinks"] and link < len(data):
            owner = f"object {number} '{item['name']}', link {link}"
            shapes = graphics_data.shapes(data[link] or [], rgba(pen.looks.setting("bodies.defaultColor")), owner)
            graphics_data.draw(pen, shapes, place, rotation)
        elif item["VshowLinks"]:
            parent = int(item["linkParents"][link])
            pen.cylinder(frames[parent][0] if parent >= 0 else base, place, thick, color)
        if item["VshowJoints"] and not data:
            half = 0.5 * size * rotation[:, _axis(item, link)]
            pen.cylinder(place - half, place + half, 1.6 * thick, joint)
        if pen.looks.setting("bodies.kinematicTree.showJointFrames") and not data:
            pen.frame(place, rotation, pen.looks.length("bodies.kinematicTree.frameSize", 0.06))


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
