"""Rigid bodies that have the same meshes, and nodes that are balls: many at once, as arrays."""

from __future__ import annotations

from typing import Any

import numpy as np

from dalembert._pictures import symbols
from dalembert._pictures.bodies import Bodies
from dalembert._pictures.meshes import Mesh, Rgba
from dalembert._pictures.pen import Pen
from dalembert._pictures.scene import Balls, Herd

RIGID = ("RigidBody", "RigidBody2D", "MassPoint", "MassPoint2D", "Mass1D", "RotationalMass1D")
Item = dict[str, Any]


class Crowd:
    """Takes items that look as they always do, and draws them when all are there."""

    def __init__(self, pen: Pen, bodies: Bodies) -> None:
        self._pen, self._bodies = pen, bodies
        self._meshes: dict[int, tuple[Mesh, list[int], list[int]]] = {}  # by id: numbers of bodies, and of the items
        self._nodes: list[int] = []  # numbers, and those of the items
        self._items: list[int] = []
        self._radii: list[float] = []
        self._colors: list[Rgba] = []

    def takes(self, kind: str, number: int, item: Item) -> bool:
        """Take the item of which the pen is about to draw; False if it has to be drawn by itself."""
        if kind == "Object":
            return self._takes_body(number, item)
        return kind == "Node" and self._takes_node(number, item)

    def _takes_body(self, number: int, item: Item) -> bool:
        if item["objectType"] not in RIGID or not self._pen.places.turns("Object", number):
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
        if color[3] < 1 or not self._pen.places.turns("Node", number) or symbols.besides_ball(self._pen, item):
            return False
        radius = 0.5 * looks.node_size(item)
        if radius > 0:
            self._nodes.append(number)
            self._items.append(self._pen.item)
            self._radii.append(radius)
            self._colors.append(color)
        return True

    def draw(self) -> None:
        """Draw all that have been taken."""
        pen = self._pen
        for mesh, numbers, items in self._meshes.values():
            chosen = np.array(numbers)
            rows = np.asarray(pen.places.rows("Object"))[chosen]
            pen.scene.herds.append(Herd(mesh, None, np.array(items), rows))
            pen.stuck.herds.append(pen.frames.numbers("Object", chosen))
        if self._nodes:
            chosen = np.array(self._nodes)
            centers = np.asarray(pen.places.rows("Node"))[chosen, :, 3]
            pen.scene.balls = Balls(centers, np.array(self._radii), np.array(self._colors), np.array(self._items))
            pen.stuck.balls = pen.frames.numbers("Node", chosen)
