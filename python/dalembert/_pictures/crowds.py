"""Rigid bodies that have the same meshes or are balls, and nodes that are balls: many at once, as arrays."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cached_property
from itertools import repeat
from typing import Any

import numpy as np

from dalembert._checks import FloatArray, IntArray
from dalembert._pictures import symbols
from dalembert._pictures.bodies import Bodies
from dalembert._pictures.meshes import Mesh, Rgba
from dalembert._pictures.pen import Pen
from dalembert._pictures.places import Places
from dalembert._pictures.scene import Balls, DrawnItem, Herd

RIGID = ("RigidBody", "RigidBody2D", "MassPoint", "MassPoint2D", "Mass1D", "RotationalMass1D")
Item = dict[str, Any]


MANY = 200  # number of items of a kind from which on items with equal appearance are grouped
KINDS = ("Node", "Object")


@dataclass
class Group:
    """Items of equal appearance, represented by one of them."""

    first: Item
    numbers: IntArray


def groups(places: Places, kind: str, count: int) -> list[Group]:
    """Return the groups of items with equal appearance and a frame, for kinds with many items."""
    if kind not in KINDS or count < MANY or places.source is None:
        return []
    first, turning = places.source.alike(KINDS.index(kind)), places.turning(kind)
    found = []
    for number, size in zip(*np.unique(first, return_counts=True), strict=True):
        if size >= MANY:
            numbers = np.flatnonzero((first == number) & turning)
            found.append(Group(places.item(kind, int(number)), numbers))
    return found


@dataclass
class Members:
    """Numbers of items, and their positions in the scene."""

    numbers: list[IntArray] = field(default_factory=list)
    items: list[IntArray] = field(default_factory=list)

    def add(self, numbers: IntArray, items: IntArray) -> None:
        """Add some."""
        self.numbers.append(numbers)
        self.items.append(items)


@contextmanager
def _without_collector() -> Iterator[None]:
    """Disable the garbage collector while very many objects are created, which it would inspect repeatedly."""
    was_on = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_on:
            gc.enable()


class Crowd:
    """Takes items that look as they always do, and draws them when all are there."""

    def __init__(self, pen: Pen, bodies: Bodies) -> None:
        self._pen, self._bodies = pen, bodies
        self._meshes: dict[int, tuple[Mesh, Members]] = {}  # by id
        self._balls = {kind: Members() for kind in KINDS}
        self._radii: dict[str, list[FloatArray]] = {kind: [] for kind in KINDS}
        self._colors: dict[str, list[FloatArray]] = {kind: [] for kind in KINDS}

    def takes_all(self, kind: str, group: Group) -> bool:
        """Take a group of which the pen has not drawn anything; False if its items have to be drawn one by one."""
        return len(group.numbers) > 0 and self._takes(kind, group.first, group.numbers, None)

    def takes(self, kind: str, number: int, item: Item) -> bool:
        """Take the item of which the pen is about to draw; False if it has to be drawn by itself."""
        there = kind in KINDS and self._pen.places.turns(kind, number)
        return there and self._takes(kind, item, np.array([number]), np.array([self._pen.item]))

    def _takes(self, kind: str, item: Item, numbers: IntArray, items: IntArray | None) -> bool:
        return (self._takes_bodies if kind == "Object" else self._takes_nodes)(item, numbers, items)

    def _items(self, kind: str, item: Item, numbers: IntArray) -> IntArray:
        """Add items that the scene does not have yet; return their positions."""
        with _without_collector():
            names = self._pen.places.source.names(KINDS.index(kind), numbers)
            of_type = repeat(item[f"{kind.lower()}Type"])
            rows = zip(repeat(kind), numbers.tolist(), of_type, names, repeat(0), strict=False)
            return self._pen.take_many(list(map(DrawnItem._make, rows)))

    def _takes_bodies(self, item: Item, numbers: IntArray, items: IntArray | None) -> bool:
        if item["objectType"] not in RIGID:
            return False
        meshes = self._bodies.meshes(self._pen, int(numbers[0]), item)
        if meshes is None:
            return False
        if not meshes:
            radius, color = self._bodies.ball(self._pen)
            if color[3] < 1 or self._nodes_have_colors or self._bodies.with_markers(numbers).any():
                return False
            self._add_balls("Object", item, numbers, items, radius, color)
            return True
        items = self._items("Object", item, numbers) if items is None else items
        for mesh in meshes:
            self._meshes.setdefault(id(mesh), (mesh, Members()))[1].add(numbers, items)
        return True

    @cached_property
    def _nodes_have_colors(self) -> bool:
        """Whether any node has a color of its own, which is that of its body."""
        places = self._pen.places
        alike = np.unique(places.source.alike(KINDS.index("Node")))
        return any(places.item("Node", node).get("Vcolor", [-1.0])[0] >= 0 for node in alike.tolist())

    def _takes_nodes(self, item: Item, numbers: IntArray, items: IntArray | None) -> bool:
        looks = self._pen.looks
        color = looks.color(item, "nodes.defaultColor")
        if color[3] < 1 or symbols.besides_ball(self._pen, item):
            return False
        self._add_balls("Node", item, numbers, items, 0.5 * looks.node_size(item), color)
        return True

    def _add_balls(
        self, kind: str, item: Item, numbers: IntArray, items: IntArray | None, radius: float, color: Rgba
    ) -> None:
        items = self._items(kind, item, numbers) if items is None else items
        if radius > 0:
            self._balls[kind].add(numbers, items)
            self._radii[kind].append(np.full(len(numbers), radius))
            self._colors[kind].append(np.tile(np.array(color), (len(numbers), 1)))

    def draw(self) -> None:
        """Draw all that have been taken."""
        pen = self._pen
        for mesh, members in self._meshes.values():
            chosen = np.concatenate(members.numbers)
            rows = np.asarray(pen.places.rows("Object"))[chosen]
            pen.scene.herds.append(Herd(mesh, None, np.concatenate(members.items), rows))
            pen.stuck.herds.append(pen.frames.numbers("Object", chosen))
        if kinds := [kind for kind in KINDS if self._balls[kind].numbers]:
            of_kind = {kind: np.concatenate(self._balls[kind].numbers) for kind in kinds}
            pen.scene.balls = Balls(
                np.concatenate([np.asarray(pen.places.rows(kind))[of_kind[kind], :, 3] for kind in kinds]),
                np.concatenate([radii for kind in kinds for radii in self._radii[kind]]),
                np.concatenate([colors for kind in kinds for colors in self._colors[kind]]),
                np.concatenate([items for kind in kinds for items in self._balls[kind].items]),
            )
            pen.stuck.balls = np.concatenate([pen.frames.numbers(kind, of_kind[kind]) for kind in kinds])
