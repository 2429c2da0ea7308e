"""Drawing of general contact: spheres and triangles that move with markers, forces, and boxes of the search."""

from __future__ import annotations

import functools
import itertools
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from dalembert import _core
from dalembert._checks import FloatArray
from dalembert._pictures import meshes
from dalembert._pictures.looks import Looks, rgba
from dalembert._pictures.meshes import Mesh, Rgba
from dalembert._pictures.pen import Pen
from dalembert._pictures.scene import DrawnItem

KIND = "GeneralContact"
# the first kind is rigid; the other ones are drawn anew in each scene
SHAPES, SEARCH, FORCES = "shapes", "search", "Force"  # the last one is the kind of all forces as well
PUSHING = (0.85, 0.1, 0.1, 1.0)
CROWDED = (1.0, 0.0, 0.0)  # the cell that holds most


def drawn_items(mbs: Any, looks: Looks) -> list[DrawnItem]:
    """Return the visible parts of all general contacts, according to the settings."""
    contact = looks.setting("contact")
    parts = [SHAPES] if contact.showSpheres or contact.showTriangles else []
    if contact.showBoundingBoxes or contact.showSearchTree or contact.showSearchTreeCells:
        parts.append(SEARCH)
    if contact.showContactForces:
        parts.append(FORCES)
    return (
        [DrawnItem(KIND, k, part, "") for k in range(mbs.NumberOfGeneralContacts()) for part in parts] if parts else []
    )


def draw(pen: Pen, item: DrawnItem) -> None:
    """Draw a part of one general contact, once the system is assembled."""
    if pen.places.source is None:
        return
    if item.type_name == SHAPES:
        _draw_shapes(pen, item.number)
    elif item.type_name == FORCES:
        _draw_forces(pen, item.number)
    else:
        _draw_search(pen, item.number)


def _draw_shapes(pen: Pen, number: int) -> None:
    contact, held = pen.looks.setting("contact"), _held(pen, number)
    if contact.showSpheres:
        for marker, center, radius in _spheres(pen, held):
            pen.stick("Marker", marker)
            pen.sphere(center, radius, rgba(contact.colorSpheres))
    if contact.showSpheres:
        for marker, place, rotation, mesh in _convex(pen, held):
            pen.stick("Marker", marker)
            pen.mesh(mesh, place, rotation, rgba(contact.colorSpheres))
    if contact.showTriangles:
        for marker, place, rotation, corners in _triangles(pen, held):
            pen.stick("Marker", marker)
            mesh = Mesh(corners.reshape(-1, 3), np.arange(corners.size // 3).reshape(-1, 3))
            pen.mesh(mesh, place, rotation, rgba(contact.colorTriangles))


def _held(pen: Pen, number: int) -> dict[str, Any]:
    """Return the definition of a general contact."""
    return dict(pen.places.mbs.GetDictionary()["generalContactList"][number])


def _spheres(pen: Pen, held: dict[str, Any]) -> Iterator[tuple[int, FloatArray, float]]:
    """Yield marker, center and radius of spheres that have a place."""
    for marker, radius in zip(held["spheres"]["markerIndex"], held["spheres"]["radius"], strict=True):
        if (center := pen.places.marker(marker)) is not None:
            yield int(marker), center, float(radius)


def _triangles(pen: Pen, held: dict[str, Any]) -> Iterator[tuple[int, FloatArray, FloatArray, FloatArray]]:
    """Yield marker, place and rotation of bodies, and the corners (n x 3 x 3) of their triangles in their frames."""
    owner, corners = held["triangles"]["contactRigidBodyIndex"], held["triangles"]["points"]
    for k, marker in enumerate(held["triangleBodies"]["rigidBodyMarkerIndex"]):
        if (place := pen.places.marker(marker)) is not None:
            yield int(marker), place, pen.places.marker_rotation(marker), corners[owner == k]


def _convex(pen: Pen, held: dict[str, Any]) -> Iterator[tuple[int, FloatArray, FloatArray, Mesh]]:
    """Yield marker, place, rotation and mesh of convex shapes; planes, which have no end, are not drawn."""
    if "convexShapes" not in held:
        return
    shapes = held["convexShapes"]
    points = np.stack([held["convexPoints"][axis] for axis in "xyz"], axis=1)
    triangles = np.stack([held["convexTriangles"][axis] for axis in "xyz"], axis=1)
    first_point, first_triangle = 0, 0
    for k, marker in enumerate(shapes["markerIndex"]):
        own = points[first_point : first_point + shapes["points"][k]]
        corners = triangles[first_triangle : first_triangle + shapes["triangles"][k]]
        first_point, first_triangle = first_point + len(own), first_triangle + len(corners)
        if (place := pen.places.marker(marker)) is not None:
            mesh = (
                Mesh(own, corners) if len(corners) else _round(own, float(shapes["radius"][k]), shapes["kind"][k] == 1)
            )
            yield int(marker), place, pen.places.marker_rotation(marker), mesh


def _round(ends: FloatArray, radius: float, is_capsule: bool, tiles: int = 24) -> Mesh:
    """Return a cylinder or a capsule between two points."""
    axis = ends[1] - ends[0]
    length = float(np.linalg.norm(axis))
    if is_capsule:
        angles = np.linspace(0, np.pi / 2, 7)
        radii = radius * np.concatenate([np.sin(angles), np.cos(angles)])
        heights = np.concatenate([-radius * np.cos(angles), length + radius * np.sin(angles)])
    else:
        radii, heights = radius * np.array([0, 1, 1, 0]), length * np.array([0, 0, 1, 1])
    mesh = meshes.revolved(radii, heights, tiles)
    across = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
    across /= np.linalg.norm(across)
    turn = np.stack([across, np.cross(axis / length, across), axis / length])
    return replace(
        mesh, points=ends[0] + mesh.points @ turn, normals=None if mesh.normals is None else mesh.normals @ turn
    )


def _draw_forces(pen: Pen, number: int) -> None:
    """Draw contact points, and the force on the sphere at each; if they are unknown, report the reason once."""
    settings = pen.looks.setting("contact")
    size = pen.looks.length("contact.contactPointsDefaultSize", 0.01)
    points, forces = pushes(pen, number)
    pen.stick()
    for point, force in zip(points, forces, strict=True):
        strength = float(np.linalg.norm(force))
        pen.sphere(point, 0.5 * size, PUSHING)
        if strength > 0:
            pen.arrow(point, float(settings.contactForcesFactor) * force, 0.25 * size, PUSHING)
            if settings.showContactForcesValues:
                pen.label(point, f"{strength:.4g} N", PUSHING)


def pushes(pen: Pen, number: int) -> tuple[FloatArray, FloatArray]:
    """Return contact points, and the force on the sphere at each; none if they are unknown."""
    try:
        _, points, forces = pen.places.mbs.GetGeneralContact(number)._pushes(pen.places.configuration)
    except (RuntimeError, ValueError) as error:  # another thread solves the system, or two spheres have one center
        _notice_once(f"WARNING: forces of general contact {number} are not drawn: {error}")
        return np.zeros((0, 3)), np.zeros((0, 3))
    return points, forces


@functools.cache
def _notice_once(text: str) -> None:
    _core.Print(text)


def _draw_search(pen: Pen, number: int) -> None:
    settings = pen.looks.setting("contact")
    if settings.showBoundingBoxes:
        color, held = rgba(settings.colorBoundingBoxes), _held(pen, number)
        for _, center, radius in _spheres(pen, held):
            _draw_box(pen, np.array([center - radius, center + radius]), color)
        for _, place, rotation, mesh in _convex(pen, held):
            corners = mesh.points @ rotation.T + place
            _draw_box(pen, np.array([corners.min(axis=0), corners.max(axis=0)]), color)
        for _, place, rotation, corners in _triangles(pen, held):
            turned = corners @ rotation.T + place
            for box in np.stack([turned.min(axis=1), turned.max(axis=1)], axis=1):
                _draw_box(pen, box, color)
    if not (settings.showSearchTree or settings.showSearchTreeCells):
        return
    contact = pen.places.mbs.GetGeneralContact(number)
    now = contact.GetPythonObject()
    whole, sizes = np.array(now["searchTreeBox"], float).reshape(2, 3), [int(n) for n in now["searchTreeSize"]]
    if not np.all(whole[1] > whole[0]):
        return  # it is chosen by itself
    color = rgba(settings.colorSearchTree)
    if settings.showSearchTree:
        _draw_box(pen, whole, color)
    if settings.showSearchTreeCells and all(sizes):
        step = (whole[1] - whole[0]) / sizes
        firsts = [whole[0] + step * np.array(cell) for cell in itertools.product(*map(range, sizes))]
        cells = [np.array([first, first + step]) for first in firsts]
        counts = [sum(map(len, (contact.GetItemsInBox(*cell) or {}).values())) for cell in cells]
        most = max(counts)
        for cell, count in zip(cells, counts, strict=True):
            share = count / most if most else 0.0
            mixed = np.array(color[:3]) + share * (np.array(CROWDED) - color[:3])
            _draw_box(pen, cell, (float(mixed[0]), float(mixed[1]), float(mixed[2]), color[3]))


def _draw_box(pen: Pen, box: FloatArray, color: Rgba) -> None:
    pen.stick()
    for edge in meshes.edges_of_box(box):
        pen.line(edge, color)
