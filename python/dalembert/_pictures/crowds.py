"""Rigid bodies that have the same meshes, and nodes that are balls: many at once, as arrays."""

from __future__ import annotations

from typing import Any

import numpy as np

from dalembert._pictures.bodies import Bodies
from dalembert._pictures.meshes import Mesh, Rgba
from dalembert._pictures.pen import Pen
from dalembert._pictures.scene import Balls, Herd

RIGID = ("Ground", "RigidBody", "RigidBody2D", "MassPoint", "MassPoint2D", "Mass1D", "RotationalMass1D")
Item = dict[str, Any]


class Crowd:
    """Takes items that look as they always do, and draws them when all are there."""

    def __init__(self, pen: Pen, bodies: Bodies) -> None:
        self._pen, self._bodies = pen, bodies
        self._meshes: dict[int, tuple[Mesh, list[int], list[int]]] = {}  # by id: numbers of bodies, and of the items
        self._nodes: list[tuple[int, int, float, Rgba]] = []  # number, that of the item, radius, color

    def takes(self, kind: str, number: int, item: Item) -> bool:
        """Take the item of which the pen is about to draw; False if it has to be drawn by itself."""
        if kind == "Object":
            return self._takes_body(number, item)
        return kind == "Node" and self._takes_node(number, item)

    def _takes_body(self, number: int, item: Item) -> bool:
        name = item["objectType"]
        if name not in RIGID or name == "Ground" or not self._pen.places.turns("Object", number):
            return False
        meshes = self._bodies.meshes(self._pen, number, item)
        if not meshes:
            return False
        for mesh in meshes:
            _, numbers, items = self._meshes.setdefault(id(mesh), (mesh, [], []))
            numbers.append(number)
            items.append(self._pen.item)
        return True

    def _takes_node(self, number: int, item: Item) -> bool:
        looks = self._pen.looks
        color = looks.color(item, "nodes.defaultColor")
        if color[3] < 1 or not self._pen.places.turns("Node", number):
            return False
        radius = 0.5 * looks.node_size(item)
        if radius > 0:
            self._nodes.append((number, self._pen.item, radius, color))
        return True

    def draw(self) -> None:
        """Draw all that have been taken."""
        pen = self._pen
        for mesh, numbers, items in self._meshes.values():
            rows = np.asarray(pen.places.rows("Object"))[numbers]
            pen.scene.herds.append(Herd(mesh, None, np.array(items), rows))
            pen.stuck.herds.append(pen.frames_of("Object", numbers))
        if self._nodes:
            nodes = [number for number, *_ in self._nodes]
            centers = np.asarray(pen.places.rows("Node"))[nodes, :, 3]
            radii, colors = np.array([node[2] for node in self._nodes]), np.array([node[3] for node in self._nodes])
            pen.scene.balls = Balls(centers, radii, colors, np.array([node[1] for node in self._nodes]))
            pen.stuck.balls = pen.frames_of("Node", nodes)
