"""A scene: drawing data in global coordinates, independent of items and cameras."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, IntArray
from dalembert._pictures.meshes import Mesh, Rgba, extremes, sharp_edges

BLOCK = 4096  # number of poses processed together: intermediate results stay in the cache
WIDE = 3.0  # ground that is larger than all the rest by this factor is a floor to stand on


class DrawnItem(NamedTuple):
    """The owner of a part of a picture."""

    kind: str  # Node, Object, Marker, Load, Sensor, GeneralContact
    number: int
    type_name: str
    name: str
    system: int = 0  # its number in the container


class Source(NamedTuple):
    """Source of points and values of an instance, so that messages need not draw it again."""

    kind: str  # mesh: a mesh that deforms by modes, of an object; ball: around a node, in the color of its output
    number: int


@dataclass(slots=True)
class Instance:
    """A mesh where it stands: x = matrix @ point + place. Values are numbers per point, to be shown as colors."""

    mesh: Mesh
    matrix: FloatArray
    place: FloatArray
    color: Rgba | None
    item: int
    values: FloatArray | None = None
    source: Source | None = None

    def is_seen(self) -> bool:
        """Return whether there is something to draw."""
        return bool(len(self.mesh.triangles) or len(self.mesh.edges))


@dataclass(slots=True)
class Label:
    """A text at a point; size in pixels, 0 for the usual one; shift in parts of its size."""

    place: FloatArray
    text: str
    color: Rgba
    size: float = 0.0
    shift: tuple[float, float] = (0.0, 0.0)


@dataclass(eq=False)
class Herd:
    """A mesh at many places: x = rows @ (point, 1).

    The array of items is the same object in all scenes as long as only places change.
    """

    mesh: Mesh
    color: Rgba | None
    items: IntArray  # n
    rows: FloatArray  # n x 3 x 4


@dataclass(eq=False)
class Balls:
    """Many spheres."""

    centers: FloatArray = field(default_factory=lambda: np.zeros((0, 3)))
    radii: FloatArray = field(default_factory=lambda: np.zeros(0))
    colors: FloatArray = field(default_factory=lambda: np.zeros((0, 4)))
    items: IntArray = field(default_factory=lambda: np.zeros(0, int))


@dataclass(eq=False)
class Threads:
    """Many lines: the points of one after those of the other, and how many each has."""

    points: FloatArray = field(default_factory=lambda: np.zeros((0, 3)))
    counts: IntArray = field(default_factory=lambda: np.zeros(0, int))
    colors: list[Rgba] = field(default_factory=list)
    widths: list[float] = field(default_factory=list)  # pixels
    items: IntArray = field(default_factory=lambda: np.zeros(0, int))


@dataclass
class Scene:
    """Meshes, spheres, lines and texts; `item` is a position in the list of items.

    Parts that are moved as arrays (flow.py) are in herds, balls and threads, all other parts in lists.
    """

    items: list[DrawnItem] = field(default_factory=list)
    instances: list[Instance] = field(default_factory=list)
    spheres: list[tuple[FloatArray, float, Rgba, int]] = field(default_factory=list)
    lines: list[tuple[FloatArray, Rgba, float, int]] = field(
        default_factory=list
    )  # points, color, width in pixels, item
    labels: list[Label] = field(default_factory=list)
    herds: list[Herd] = field(default_factory=list)
    balls: Balls = field(default_factory=Balls)
    threads: Threads = field(default_factory=Threads)
    time: float = 0.0
    of_motion: bool = False  # frame of a motion, whose times are shown from the first on
    information: list[str] = field(default_factory=list)  # shown in the corner of the picture
    value_name: str = ""  # name of the values; "" if there are none
    value_range: tuple[float, float] = (0.0, 1.0)

    def unbound(self) -> Scene:
        """Return the same scene with everything in lists, for code that processes parts one by one."""
        balls, threads = self.balls, self.threads
        whole = replace(self, herds=[], balls=Balls(), threads=Threads())
        whole.instances = [
            Instance(herd.mesh, rows[:, :3], rows[:, 3], herd.color, int(item))
            for herd in self.herds
            for rows, item in zip(herd.rows, herd.items, strict=True)
        ] + self.instances
        whole.spheres = [
            (center, float(radius), (float(r), float(g), float(b), float(a)), int(item))
            for center, radius, (r, g, b, a), item in zip(
                balls.centers, balls.radii, balls.colors, balls.items, strict=True
            )
        ] + self.spheres
        parts = np.split(threads.points, np.cumsum(threads.counts)[:-1]) if len(threads.counts) else []
        whole.lines = [
            (points, color, width, int(item))
            for points, color, width, item in zip(parts, threads.colors, threads.widths, threads.items, strict=True)
        ] + self.lines
        return whole

    def box(self) -> FloatArray | None:
        """Return the smallest and largest coordinates of the scene; None if it is empty.

        Symbols of nodes, markers and sensors count only if there are no other parts, ground unless it is wide.
        """
        counted = [
            (item.kind in ("Object", "Load", "Trace", "GeneralContact")) + (item.type_name == "Ground")
            for item in self.items
        ]
        kinds = np.array([*counted, 1])  # the last one is for parts without an item, -1
        moving, objects = self._corners(kinds == 1), self._corners(kinds > 0)
        if moving is None or objects is None:
            return self._corners(kinds >= 0) if objects is None else objects
        wide = np.linalg.norm(objects[1] - objects[0]) > WIDE * np.linalg.norm(moving[1] - moving[0])
        return moving if wide else objects

    def extent(self) -> FloatArray | None:
        """Return the smallest and largest coordinates of all parts, or None if the scene is empty."""
        return self._corners(np.ones(len(self.items) + 1, bool))

    def box_of(self, objects: list[int]) -> FloatArray | None:
        """Return the same for these objects alone."""
        return self._corners(
            np.array([*(item.kind == "Object" and item.number in objects for item in self.items), False])
        )

    def _corners(self, counts: npt.NDArray[np.bool_]) -> FloatArray | None:
        """Return the smallest and the largest coordinates of those items that count."""
        parts = [extremes(i.mesh) @ i.matrix.T + i.place for i in self.instances if counts[i.item]]
        parts += [points for points, _, _, item in self.lines if counts[item]]
        for center, radius, _, item in self.spheres:
            if counts[item]:
                parts.append(np.array([center - radius, center + radius]))
        balls, threads = self.balls, self.threads
        chosen = counts[balls.items]
        parts += [balls.centers[chosen] + sign * balls.radii[chosen, None] for sign in (-1, 1)]
        parts.append(threads.points[np.repeat(counts[threads.items], threads.counts)])
        for herd in self.herds:
            parts.append(_bounds_of_herd(herd, counts[herd.items]))
        return _bounds(np.concatenate([np.zeros((0, 3)), *parts]))

    def values(self) -> FloatArray:
        """Return all numbers that are shown as colors."""
        shown = [instance.values for instance in self.instances if instance.values is not None]
        return shown[0] if len(shown) == 1 else np.concatenate([np.empty(0), *shown])


def _bounds(points: FloatArray) -> FloatArray | None:
    """Return the smallest and the largest coordinates of points that are finite; None if there are none."""
    columns = np.ascontiguousarray(points.T)  # numpy is ten times as fast along these
    if not columns.size:
        return None
    bounds: FloatArray = np.array([columns.min(axis=1), columns.max(axis=1)])
    if not np.isfinite(bounds).all():
        columns = columns[:, np.isfinite(columns).all(axis=0)]
        return np.array([columns.min(axis=1), columns.max(axis=1)]) if columns.size else None
    return bounds


def _bounds_of_herd(herd: Herd, chosen: npt.NDArray[np.bool_]) -> FloatArray:
    """Return the smallest and the largest coordinates of a mesh at many positions (2 x 3; 0 x 3 if there are none)."""
    rows = herd.rows if chosen.all() else herd.rows[chosen]
    points = extremes(herd.mesh)
    if not len(rows) or not len(points):
        return np.zeros((0, 3))
    matrix = np.vstack([points.T, np.ones(len(points))])
    bounds = np.array([np.full(3, np.inf), np.full(3, -np.inf)])
    for first in range(0, len(rows), BLOCK):
        found = (rows[first : first + BLOCK].reshape(-1, 4) @ matrix).reshape(-1, 3 * len(points))
        low, high = (extreme.reduce(found, axis=0).reshape(3, -1) for extreme in (np.fmin, np.fmax))
        bounds = np.array([np.fmin(bounds[0], low.min(axis=1)), np.fmax(bounds[1], high.max(axis=1))])
    return bounds


@dataclass
class Faces:
    """Triangles of many meshes in global coordinates."""

    points: FloatArray
    normals: FloatArray | None
    colors: FloatArray
    triangles: IntArray
    items: IntArray
    materials: IntArray | None  # one per point, as in Mesh


@dataclass
class _Crowd:
    """A mesh at many places, with the colors of all points."""

    mesh: Mesh
    matrices: FloatArray
    places: FloatArray
    colors: FloatArray
    items: IntArray
    plain: list[bool]  # or one for all: without the materials of the mesh, because its colors differ

    @staticmethod
    def of_herd(herd: Herd) -> _Crowd:
        colors = np.tile(_colors(herd.mesh, herd.color), (len(herd.items), 1))
        plain = [herd.color is not None]
        return _Crowd(herd.mesh, herd.rows[:, :, :3], herd.rows[:, :, 3], colors, herd.items, plain)

    def points(self) -> FloatArray:
        """Return all points."""
        if self._is_one_unturned() and not self.places.any():
            return self.mesh.points
        return (self.mesh.points @ self.matrices.transpose(0, 2, 1) + self.places[:, None]).reshape(-1, 3)

    def normals(self, normals: FloatArray) -> FloatArray:
        """Return the normals at all points."""
        if self._is_one_unturned():
            return normals
        return (normals @ _cofactors(self.matrices).transpose(0, 2, 1)).reshape(-1, 3)

    def _is_one_unturned(self) -> bool:
        return len(self.items) == 1 and np.array_equal(self.matrices[0], np.eye(3))

    def materials(self) -> IntArray:
        """Return the materials of all points."""
        size, count = len(self.mesh.points), len(self.items)
        if self.mesh.materials is None or all(self.plain):
            return np.zeros(size * count, int)
        return (np.where(self.plain, 0, 1)[:, None] * np.tile(self.mesh.materials, (count, 1))).ravel()


def faces(scene: Scene, smooth: bool, color_of: dict[int, FloatArray]) -> Faces | None:
    """Return the triangles of all meshes with normals, or of those without; color_of: colors of single instances."""
    crowds = [
        _Crowd.of_herd(h) for h in scene.herds if (h.mesh.normals is not None) == smooth and len(h.mesh.triangles)
    ]
    groups: dict[int, list[tuple[int, Instance]]] = defaultdict(list)
    for number, instance in enumerate(scene.instances):
        if (instance.mesh.normals is not None) == smooth and len(instance.mesh.triangles):
            groups[id(instance.mesh)].append((number, instance))
    for group in groups.values():
        colored = [color_of[n] if n in color_of else _colors(i.mesh, i.color) for n, i in group]
        crowds.append(
            _Crowd(
                group[0][1].mesh,
                np.array([instance.matrix for _, instance in group]),
                np.array([instance.place for _, instance in group]),
                _joined(colored),
                np.array([instance.item for _, instance in group]),
                [n in color_of or i.color is not None for n, i in group],
            )
        )
    if not crowds:
        return None
    any_named = any(crowd.mesh.materials is not None for crowd in crowds)
    points, normals, colors, triangles, items = [], [], [], [], []
    start = 0
    for crowd in crowds:
        mesh, many = crowd.mesh, len(crowd.items)
        points.append(crowd.points())
        if mesh.normals is not None:
            normals.append(crowd.normals(mesh.normals))
        colors.append(crowd.colors)
        numbers = mesh.triangles.astype(np.int32)
        if start or many > 1:
            starts = start + len(mesh.points) * np.arange(many, dtype=np.int32)
            numbers = (numbers[None] + starts[:, None, None]).reshape(-1, 3)
        triangles.append(numbers)
        items.append(np.repeat(np.asarray(crowd.items, np.int32), len(mesh.triangles)))
        start += len(mesh.points) * many
    return Faces(
        _joined(points),
        _joined(normals) if smooth else None,
        _joined(colors),
        _joined(triangles),
        _joined(items),
        _joined([crowd.materials() for crowd in crowds]) if any_named else None,
    )


def _joined(parts: list[Any]) -> Any:
    """Return arrays as one."""
    return parts[0] if len(parts) == 1 else np.concatenate(parts)


def _cofactors(m: FloatArray) -> FloatArray:
    """Return the matrices that transform normals if points are multiplied by m, up to a factor per matrix."""
    a, b, c = m[:, :, 0], m[:, :, 1], m[:, :, 2]
    turned = np.stack([np.cross(b, c), np.cross(c, a), np.cross(a, b)], axis=2)
    return turned / np.maximum(np.linalg.norm(turned, axis=(1, 2), keepdims=True), 1e-300)


def _colors(mesh: Mesh, color: Rgba | None) -> FloatArray:
    if color is None and mesh.colors is not None:
        return mesh.colors
    return np.tile(np.array(color or (0.5, 0.5, 0.5, 1.0), np.float32), (len(mesh.points), 1))


def mesh_edges(scene: Scene, sharp: Rgba | None = None) -> list[tuple[FloatArray, Rgba, int]]:
    """Return the edges of meshes in global coordinates: end points (n x 6), color and item.

    A color for sharp edges adds edges at which faces meet at an angle.
    """
    result = []
    for instance in scene.unbound().instances if scene.herds else scene.instances:
        mesh = instance.mesh
        wanted = [(mesh.edges, mesh.edge_color)]
        if sharp is not None and len(mesh.triangles) and not len(mesh.edges):
            wanted.append((sharp_edges(mesh), sharp))
        for edges, color in wanted:
            if len(edges):
                points = mesh.points @ instance.matrix.T + instance.place
                result.append((points[edges].reshape(-1, 6), color, instance.item))
    return result
