"""Symbols of items without a shape: nodes, markers, loads and sensors."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._core import ConfigurationType, OutputVariableType
from dalembert._pictures import meshes, trees
from dalembert._pictures.contour import Contour
from dalembert._pictures.pen import Pen
from dalembert._pictures.places import frame_along
from dalembert._pictures.scene import Source

Item = dict[str, Any]
Drawing = Callable[[Pen, int, Item, FloatArray], None]


def node(pen: Pen, colors: Contour, number: int, item: Item) -> None:
    """A ball, and the axes of the node if they are wanted."""
    if (place := pen.places.node(number)) is None:
        return
    radius = 0.5 * pen.looks.node_size(item)
    color = pen.looks.color(item, "nodes.defaultColor")
    pen.stick("Node", number)
    value = pen.places.shown_output(number, colors.variable) if colors.active else None
    if value is not None and radius > 0 and pen.looks.setting("contour.nodesColored"):
        ball = meshes.ball(8)
        values = np.full(len(ball.points), colors.number(value))
        pen.mesh(ball, place, radius * np.eye(3), None, values, Source("ball", number))
    else:
        pen.sphere(place, radius, color)
    for draw in besides_ball(pen, item):
        draw(pen, number, item, place)


def besides_ball(pen: Pen, item: Item) -> list[Drawing]:
    """Return the functions that draw further symbols of a node besides a ball; arguments are number, parameters and
    position."""
    nodes = pen.looks.setting("nodes")
    drawn: list[Drawing] = []
    if nodes.showNodalSlopes and "Slope" in item["nodeType"]:
        drawn.append(_slopes)
    if nodes.showBasis:
        drawn.append(_basis)
    return drawn


def _basis(pen: Pen, number: int, item: Item, place: FloatArray) -> None:
    """Draw the axes of a node."""
    rotation = pen.places.node_rotation(number)
    pen.stick("Node", number)
    pen.frame(place, np.eye(3) if rotation is None else rotation, pen.looks.length("nodes.basisSize", 0.1))


def _slopes(pen: Pen, number: int, item: Item, place: FloatArray) -> None:
    """Draw the slope vectors of a node; a slope of 1 is as long as the axes of nodes."""
    pen.stick()
    changes = pen.places.node_output(number, OutputVariableType.Coordinates)
    total = np.asarray(item["referenceCoordinates"], float)
    if changes is not None and pen.places.configuration != ConfigurationType.Reference:
        total = total + changes
    size = 2 if "2D" in item["nodeType"] else 3
    for slope in total[size:].reshape(-1, size):
        vector = np.zeros(3)
        vector[:size] = slope
        length = pen.looks.length("nodes.basisSize", 0.1)
        pen.arrow(place, length * vector, 0.02 * length, pen.looks.color(item, "nodes.defaultColor"))


def marker(pen: Pen, number: int, item: Item) -> None:
    """A small cube; balls at the mesh nodes that the marker is the mean of, and lines to them or between two bodies."""
    if (place := pen.places.marker(number)) is None:
        return
    size = pen.looks.length("markers.defaultSize", 0.009)
    color = pen.looks.color(item, "markers.defaultColor")
    pen.stick(*pen.places.seat(number), turns=pen.places.stands("Marker", number))
    pen.box(place, pen.places.marker_rotation(number), 3 * [size], color)
    pen.stick()
    if "bodyNumbers" in item:
        ends = [pen.places.body(body) for body in item["bodyNumbers"]]
        pen.line([end for end in ends if end is not None], color)
    if item.get("VshowMarkerNodes") and "meshNodeNumbers" in item:
        for mesh_node in item["meshNodeNumbers"]:
            point = pen.places.mesh_output(item["bodyNumber"], OutputVariableType.Position, mesh_node)
            if point is not None:
                pen.sphere(point, 0.35 * size, color)
                pen.line([place, point], color)


def load(pen: Pen, number: int, item: Item) -> None:
    """An arrow along a force, a turning arrow about a torque; its size is fixed, or in proportion to the load."""
    color = pen.looks.color(item, "loads.defaultColor")
    if (known := load_vector(pen, item)) is None or (pen.looks.forces and is_scaled(item)):
        return
    place, vector, turns, axes_turn = known
    strength = float(np.linalg.norm(vector))
    if pen.looks.setting("loads.fixedLoadSize"):
        size = pen.looks.length("loads.defaultSize", 0.08)
    else:
        size = strength * float(pen.looks.setting("loads.loadSizeFactor"))
    radius = pen.looks.length("loads.defaultRadius", 0.003)
    pen.stick(*pen.places.seat(item["markerNumber"]), turns=axes_turn)
    if turns:
        pen.turning_arrow(place, vector, 0.5 * size, color)
    else:
        pen.arrow(place, size / strength * vector, radius, color)


def is_scaled(load: Item) -> bool:
    """Return whether the arrow of a load can be in proportion to it: its value is known, and it is not weight."""
    functions = [value for name, value in load.items() if name.endswith("UserFunction")]
    return load["loadType"] != "MassProportional" and not any(functions)


def load_vector(pen: Pen, item: Item) -> tuple[FloatArray, FloatArray, bool, bool] | None:
    """Return place and global vector of a load, whether it is a torque, and whether its axes rotate with the marker.

    None if it has no place, or if it is zero.
    """
    marker_number = item["markerNumber"]
    if (place := pen.places.marker(marker_number)) is None:
        return None
    vector, turns = _direction(pen, item)
    if not vector.any():
        return None
    if axes_turn := bool(item.get("bodyFixed")):
        vector = pen.places.marker_rotation(marker_number) @ vector
    elif (frame := _frame_of_coordinate(pen, item)) is not None:
        vector, axes_turn = frame @ vector, True
    return place, vector, turns, axes_turn


def _frame_of_coordinate(pen: Pen, item: Item) -> FloatArray | None:
    """Return the axes along which a load acts on a coordinate of a node in a floating frame; None: global ones."""
    node = pen.places.item("Marker", item["markerNumber"]).get("nodeNumber")
    frame = None if item["loadType"] != "Coordinate" or node is None else pen.places.frame_of_output(int(node))
    return None if frame is None else frame[1]


def _direction(pen: Pen, item: Item) -> tuple[FloatArray, bool]:
    """Return the vector of a load, and whether it is a torque."""
    if item["loadType"] != "Coordinate":
        return np.asarray(item["loadVector"], float), item["loadType"] == "TorqueVector"
    marker = pen.places.item("Marker", item["markerNumber"])
    coordinate = int(marker.get("coordinate", marker.get("rotationCoordinate", 0)))
    turns = "rotationCoordinate" in marker
    if "nodeNumber" in marker:
        node_type = pen.places.item("Node", marker["nodeNumber"])["nodeType"]
        planar, spatial = node_type.startswith("RigidBody2D"), node_type.startswith("RigidBody")
        if planar and coordinate == 2:
            return np.array([0, 0, float(item["load"])]), True
        turns = turns or (spatial and not planar and coordinate >= 3)
    return float(item["load"]) * np.eye(3)[coordinate % 3], turns


def sensor(pen: Pen, number: int, item: Item) -> None:
    """A small diamond where something is measured."""
    if (place := sensor_place(pen, item)) is None:
        return
    size = pen.looks.length("sensors.defaultSize", 0.012)
    if "markerNumber" in item:
        pen.stick(*pen.places.seat(item["markerNumber"]), turns=False)
    elif "nodeNumber" in item and "meshNodeNumber" not in item:
        pen.stick("Node", item["nodeNumber"], turns=False)
    diamond = frame_along(np.array([1.0, 1, 1]))
    pen.box(place, diamond, 3 * [0.8 * size], pen.looks.color(item, "sensors.defaultColor"))


def sensor_place(pen: Pen, item: Item) -> FloatArray | None:
    """Return the position at which a sensor measures; None if it has none."""
    if "meshNodeNumber" in item:
        return pen.places.mesh_output(item["bodyNumber"], OutputVariableType.Position, item["meshNodeNumber"])
    if "linkNumber" in item:
        tree = pen.places.item("Object", item["objectNumber"])
        place, rotation = trees.link_frames(pen, tree)[int(item["linkNumber"])]
        return place + rotation @ np.asarray(item["localPosition"], float)
    if "bodyNumber" in item:
        return pen.places.body(item["bodyNumber"], item.get("localPosition", (0, 0, 0)))
    if "nodeNumber" in item:
        return pen.places.node(item["nodeNumber"])
    if "markerNumber" in item:
        return pen.places.marker(item["markerNumber"])
    if "loadNumber" in item:
        return pen.places.marker(pen.places.item("Load", item["loadNumber"])["markerNumber"])
    return pen.places.object(item["objectNumber"]) if "objectNumber" in item else None
