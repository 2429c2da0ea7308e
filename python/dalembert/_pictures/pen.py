"""Drawing functions: they add shapes at positions to a scene, with the item as owner."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from dalembert import _core
from dalembert._checks import FloatArray, IntArray
from dalembert._pictures import meshes
from dalembert._pictures.looks import Looks, rgba
from dalembert._pictures.meshes import Mesh, Rgba
from dalembert._pictures.places import Places, frame_along
from dalembert._pictures.scene import DrawnItem, Instance, Label, Scene, Source

RED, GREEN, BLUE = (0.85, 0.15, 0.15, 1.0), (0.15, 0.65, 0.2, 1.0), (0.2, 0.35, 0.9, 1.0)

# Numbers of springs from which on springs have fewer corners per winding and around the wire, or are lines.
CROWD = (100, 500, 2000)
QUALITY = ((16, 8), (12, 5), (8, 3))


FRAMES = {kind: number for number, kind in enumerate(_core._MovingParts.kinds)}


class Frames:
    """Frames of attached parts: kind, number, and the second marker of a span; -1 for other kinds."""

    def __init__(self) -> None:
        self._known: dict[tuple[str, int, int], int] = {}
        self._rows: list[IntArray] = []
        self._count = 0

    def number(self, kind: str, number: int, other: int) -> int:
        """Return the number of a frame."""
        key = (kind, number, other)
        if key not in self._known:
            self._known[key] = self._take(np.array([[FRAMES[kind], number, other]]))
        return self._known[key]

    def numbers(self, kind: str, numbers: IntArray) -> IntArray:
        """Return the numbers of the frames of many items."""
        first = self._take(np.stack(np.broadcast_arrays(FRAMES[kind], numbers, -1), axis=1))
        return np.arange(first, self._count)

    def rows(self) -> IntArray:
        """Return all frames (n x 3), with the numbers of their kinds."""
        return np.concatenate([np.empty((0, 3), int), *self._rows])

    def _take(self, rows: IntArray) -> int:
        self._rows.append(rows)
        self._count += len(rows)
        return self._count - len(rows)


@dataclass
class Stuck:
    """Frames of the parts of a scene, in their order; -1: unattached."""

    instances: list[int] = field(default_factory=list)
    spheres: list[int] = field(default_factory=list)
    lines: list[int] = field(default_factory=list)
    labels: list[tuple[int, int]] = field(default_factory=list)  # item and frame
    herds: list[IntArray] = field(default_factory=list)
    balls: IntArray = field(default_factory=lambda: np.empty(0, int))


class Pen:
    """Adds to a scene; knows where things are and how large they should look."""

    def __init__(self, scene: Scene, places: Places, looks: Looks) -> None:
        self.scene, self.places, self.looks = scene, places, looks
        self.tiles = max(int(looks.setting("general.cylinderTiling")), 3)
        self._item = -1
        self._key: tuple[str, int, int] | None = None
        self.frames = Frames()
        self.stuck = Stuck()

    def stick(self, kind: str = "", number: int = -1, turns: bool = True) -> None:
        """Attach parts drawn from now on to the frame of an item; no kind, or no frame, means unattached.

        If `turns` is not set, they move with the item and do not rotate.
        """
        there = bool(kind) and (self.places.turns if turns else self.places.stands)(kind, number)
        self._key = (kind if turns else f"{kind}Place", int(number), -1) if there else None

    def stick_between(self, begin: int, end: int) -> None:
        """Attach parts drawn from now on to the span between two markers."""
        there = self.places.stands("Marker", begin) and self.places.stands("Marker", end)
        self._key = ("Span", int(begin), int(end)) if there else None

    def _frame(self) -> int:
        """Return the number of the frame to which things stick now."""
        return -1 if self._key is None else self.frames.number(*self._key)

    @property
    def item(self) -> int:
        """Return in whose name it draws: the position of an item in the scene."""
        return self._item

    def take(self, item: DrawnItem) -> None:
        """Draw from now on in the name of this item."""
        self.scene.items.append(item)
        self._item, self._key = len(self.scene.items) - 1, None

    def take_many(self, items: list[DrawnItem]) -> IntArray:
        """Add items; return their positions in the scene."""
        first = len(self.scene.items)
        self.scene.items += items
        return np.arange(first, len(self.scene.items))

    def go_on(self, item: int) -> None:
        """Draw from now on in the name of an item that the scene has already."""
        self._item, self._key = item, None

    def mesh(
        self,
        mesh: Mesh,
        place: Any = (0.0, 0.0, 0.0),
        matrix: FloatArray | None = None,
        color: Rgba | None = None,
        values: FloatArray | None = None,
        source: Source | None = None,
    ) -> None:
        """Add a mesh."""
        where = np.asarray(place, float)
        self.scene.instances.append(
            Instance(mesh, np.eye(3) if matrix is None else matrix, where, color, self._item, values, source)
        )
        self.stuck.instances.append(self._frame())

    def sphere(self, center: FloatArray, radius: float, color: Rgba) -> None:
        """Add a sphere; transparent spheres are meshes."""
        if radius <= 0:
            return
        if color[3] < 1:
            self.mesh(meshes.ball(16), center, radius * np.eye(3), color)
        else:
            self.scene.spheres.append((np.asarray(center, float), float(radius), color, self._item))
            self.stuck.spheres.append(self._frame())

    def line(self, points: Any, color: Rgba, width: float = 0.0) -> None:
        """Add a line through points; width in pixels, 0: that of the settings."""
        self.scene.lines.append((meshes.rows(points, 3), color, width, self._item))
        self.stuck.lines.append(self._frame())

    def cylinder(self, begin: FloatArray, end: FloatArray, radius: float, color: Rgba, inner: float = 0.0) -> None:
        """Add a cylinder between two points; inner: radius of a hole, as part of the radius."""
        axis = end - begin
        length = float(np.linalg.norm(axis))
        if length > 0 and radius > 0:
            matrix = frame_along(axis) * np.array([radius, radius, length])
            self.mesh(meshes.cylinder(self.tiles, inner), begin, matrix, color)

    def box(self, center: FloatArray, rotation: FloatArray, sizes: Any, color: Rgba) -> None:
        """Add a box, its sides along the columns of the rotation matrix."""
        self.mesh(meshes.cube(), center, rotation * np.asarray(sizes, float), color)

    def arrow(self, begin: FloatArray, vector: FloatArray, radius: float, color: Rgba) -> None:
        """Add an arrow; its head is at most half of it."""
        length = float(np.linalg.norm(vector))
        if length <= 0:
            return
        head = min(6 * radius, 0.5 * length)
        neck = begin + vector * (1 - head / length)
        self.cylinder(begin, neck, radius, color)
        matrix = frame_along(vector) * np.array([2.4 * radius, 2.4 * radius, head])
        self.mesh(meshes.cone(self.tiles), neck, matrix, color)

    def turning_arrow(self, center: FloatArray, axis: FloatArray, size: float, color: Rgba) -> None:
        """Add an arrow of three quarters of a circle about an axis."""
        rotation = frame_along(axis)
        self.mesh(meshes.torus(0.06, 12, 1.5 * np.pi), center, size * rotation, color)
        tip = center + rotation @ np.array([0, -size, 0])
        self.mesh(
            meshes.cone(self.tiles), tip, frame_along(rotation[:, 0]) * (size * np.array([0.16, 0.16, 0.45])), color
        )

    def spring(self, begin: FloatArray, end: FloatArray, radius: float, color: Rgba) -> None:
        """Add a helix between two points."""
        axis = end - begin
        length = float(np.linalg.norm(axis))
        if length <= 0 or radius <= 0:
            return
        number = self.scene.items[self._item].number
        slenderness = self.looks.slenderness(number, length / radius)
        windings = self.looks.windings(number, slenderness)
        if self.looks.crowd > CROWD[-1]:
            self.line([begin, end], color)
            return
        corners, tiles = QUALITY[int(np.searchsorted(CROWD, self.looks.crowd))]
        mesh = meshes.helix(slenderness, windings, 0.13, corners, tiles)
        self.mesh(mesh, begin, frame_along(axis) * np.array([radius, radius, length]), color)

    def frame(self, origin: FloatArray, rotation: FloatArray, size: float) -> None:
        """Add the three axes of a frame: red, green, blue."""
        tiles, self.tiles = self.tiles, max(int(self.looks.setting("general.axesTiling")), 3)
        for axis, color in zip(rotation.T, (RED, GREEN, BLUE), strict=True):
            self.arrow(origin, size * axis, 0.03 * size, color)
        self.tiles = tiles

    def label(self, place: FloatArray, text: str, color: Rgba | None = None, size: float = 0.0) -> None:
        """Add a text."""
        color = rgba(self.looks.setting("general.textColor")) if color is None else color
        self.scene.labels.append(Label(np.asarray(place, float), text, color, size))
        self.stuck.labels.append((self._item, self._frame()))
