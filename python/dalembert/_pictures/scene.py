"""A scene: what is to be drawn, as data, in global coordinates; no item and no camera is known here."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from dalembert._checks import FloatArray, IntArray
from dalembert._pictures.meshes import Mesh, Rgba, extremes, sharp_edges

WIDE = 3.0  # ground that is larger than all the rest by this factor is a floor to stand on


@dataclass(frozen=True)
class DrawnItem:
    """What a part of a picture belongs to."""

    kind: str  # Node, Object, Marker, Load, Sensor
    number: int
    type_name: str
    name: str
    system: int = 0  # its number in the container


@dataclass
class Instance:
    """A mesh where it stands: x = matrix @ point + place. Values are numbers per point, to be shown as colors."""

    mesh: Mesh
    matrix: FloatArray
    place: FloatArray
    color: Rgba | None
    item: int
    values: FloatArray | None = None


@dataclass
class Label:
    """A text at a point; size in pixels, 0 for the usual one; shift in parts of its size."""

    place: FloatArray
    text: str
    color: Rgba
    size: float = 0.0
    shift: tuple[float, float] = (0.0, 0.0)


@dataclass
class Scene:
    """Meshes, spheres, lines and texts; `item` is a position in the list of items."""

    items: list[DrawnItem] = field(default_factory=list)
    instances: list[Instance] = field(default_factory=list)
    spheres: list[tuple[FloatArray, float, Rgba, int]] = field(default_factory=list)
    lines: list[tuple[FloatArray, Rgba, float, int]] = field(
        default_factory=list
    )  # points, color, width in pixels, item
    labels: list[Label] = field(default_factory=list)
    time: float = 0.0
    information: list[str] = field(default_factory=list)  # for the corner of the picture
    value_name: str = ""  # what the values are; "" if there are none
    value_range: tuple[float, float] = (0.0, 1.0)

    def box(self) -> FloatArray | None:
        """Return the smallest and largest coordinates of what is drawn; None if there is nothing.

        Symbols of nodes, markers and sensors count only where there is nothing else, ground unless it is wide.
        """
        kinds = [(item.kind in ("Object", "Load", "Trace")) + (item.type_name == "Ground") for item in self.items]
        moving = self._corners(lambda item: item < 0 or kinds[item] == 1)
        objects = self._corners(lambda item: item < 0 or kinds[item] > 0)
        if moving is None or objects is None:
            return self._corners(lambda item: True) if objects is None else objects
        wide = np.linalg.norm(objects[1] - objects[0]) > WIDE * np.linalg.norm(moving[1] - moving[0])
        return moving if wide else objects

    def box_of(self, objects: list[int]) -> FloatArray | None:
        """Return the same for these objects alone."""
        chosen = [item.kind == "Object" and item.number in objects for item in self.items]
        return self._corners(lambda item: chosen[item])

    def _corners(self, counts: Callable[[int], bool]) -> FloatArray | None:
        parts = [extremes(i.mesh) @ i.matrix.T + i.place for i in self.instances if counts(i.item)]
        parts += [points for points, _, _, item in self.lines if counts(item)]
        for center, radius, _, item in self.spheres:
            if counts(item):
                parts.append(np.array([center - radius, center + radius]))
        points = np.concatenate([np.zeros((0, 3)), *parts])
        points = points[np.isfinite(points).all(axis=1)]
        return np.array([points.min(axis=0), points.max(axis=0)]) if len(points) else None

    def values(self) -> FloatArray:
        """Return all numbers that are shown as colors."""
        shown = [instance.values for instance in self.instances if instance.values is not None]
        return np.concatenate(shown) if shown else np.empty(0)


@dataclass
class Faces:
    """Triangles of many meshes in global coordinates."""

    points: FloatArray
    normals: FloatArray | None
    colors: FloatArray
    triangles: IntArray
    items: IntArray


def faces(scene: Scene, smooth: bool, color_of: dict[int, FloatArray]) -> Faces | None:
    """Return the triangles of all meshes with normals, or of those without; color_of: colors of single instances."""
    groups: dict[int, list[tuple[int, Instance]]] = defaultdict(list)
    for number, instance in enumerate(scene.instances):
        if (instance.mesh.normals is not None) == smooth and len(instance.mesh.triangles):
            groups[id(instance.mesh)].append((number, instance))
    if not groups:
        return None
    points, normals, colors, triangles, items = [], [], [], [], []
    start = 0
    for group in groups.values():
        mesh = group[0][1].mesh
        matrices = np.array([instance.matrix for _, instance in group])
        places = np.array([instance.place for _, instance in group])
        points.append((np.einsum("nij,kj->nki", matrices, mesh.points) + places[:, None]).reshape(-1, 3))
        if mesh.normals is not None:
            normals.append(np.einsum("nij,kj->nki", _cofactors(matrices), mesh.normals).reshape(-1, 3))
        colors += [color_of.get(number, _colors(instance)) for number, instance in group]
        count = len(mesh.points)
        starts = start + count * np.arange(len(group))
        triangles.append((mesh.triangles[None] + starts[:, None, None]).reshape(-1, 3))
        items.append(np.repeat([instance.item for _, instance in group], len(mesh.triangles)))
        start += count * len(group)
    return Faces(
        np.concatenate(points),
        np.concatenate(normals) if smooth else None,
        np.concatenate(colors),
        np.concatenate(triangles),
        np.concatenate(items),
    )


def _cofactors(m: FloatArray) -> FloatArray:
    """Return what turns normals when points are multiplied by the matrices m, up to a factor per matrix."""
    a, b, c = m[:, :, 0], m[:, :, 1], m[:, :, 2]
    turned = np.stack([np.cross(b, c), np.cross(c, a), np.cross(a, b)], axis=2)
    return turned / np.maximum(np.linalg.norm(turned, axis=(1, 2), keepdims=True), 1e-300)


def _colors(instance: Instance) -> FloatArray:
    if instance.color is None and instance.mesh.colors is not None:
        return instance.mesh.colors
    return np.tile(np.array(instance.color or (0.5, 0.5, 0.5, 1.0)), (len(instance.mesh.points), 1))


def mesh_edges(scene: Scene, sharp: Rgba | None = None) -> list[tuple[FloatArray, Rgba, int]]:
    """Return the edges of meshes in global coordinates: end points (n x 6), color and item.

    With a color for them, edges where faces meet at an angle are among them.
    """
    result = []
    for instance in scene.instances:
        mesh = instance.mesh
        wanted = [(mesh.edges, mesh.edge_color)]
        if sharp is not None and len(mesh.triangles) and not len(mesh.edges):
            wanted.append((sharp_edges(mesh), sharp))
        for edges, color in wanted:
            if len(edges):
                points = mesh.points @ instance.matrix.T + instance.place
                result.append((points[edges].reshape(-1, 6), color, instance.item))
    return result
