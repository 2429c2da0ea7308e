"""Graphics data, the dictionaries of the graphics module, as shapes that can be drawn at any place."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from dalembert._checks import (
    FloatArray,
    IntArray,
    as_array,
    as_number,
    as_one_each,
    as_point_numbers,
    as_rows,
    as_vector,
    shape_error,
)
from dalembert._pictures.looks import rgba
from dalembert._pictures.meshes import Mesh, Rgba
from dalembert._pictures.pen import Pen
from dalembert._pictures.places import frame_along
from dalembert.graphics import material

Shape = tuple[str, Any, Any]  # kind, geometry, and its color or size
NEEDED = {
    "TriangleList": ("points", "triangles"),
    "Line": ("data",),
    "Circle": ("position", "radius"),
    "Text": ("position", "text"),
}


@dataclass
class Known:
    """Cache of meshes: by their contents, and by their dictionary."""

    meshes: dict[tuple[bytes, ...], Mesh] = field(default_factory=dict)
    entries: dict[int, tuple[dict[str, Any], Mesh]] = field(
        default_factory=dict
    )  # by id, which remains that of the first


def shapes(data: Any, default: Rgba, owner: str, known: Known | None = None) -> list[Shape]:
    """Return shapes of a list of graphics data; raises ValueError with the owner for invalid data.

    Data equal to a `known` mesh returns the same mesh.
    """
    known = known or Known()
    if not isinstance(data, (list, tuple)) or not all(isinstance(entry, dict) for entry in data):
        raise shape_error(owner, "a list of graphics data, such as [graphics.Sphere(radius=0.1)]", data)
    return [_shape(entry, default, f"{owner}: graphicsData[{number}]", known) for number, entry in enumerate(data)]


def _shape(entry: dict[str, Any], default: Rgba, where: str, known: Known) -> Shape:
    kind = entry.get("type")
    if kind not in NEEDED:
        raise ValueError(f"{where}: 'type': expected TriangleList, Line, Circle or Text, received {kind!r}")
    for name in NEEDED[kind]:
        if name not in entry:
            raise ValueError(f"{where}: a {kind} needs '{name}'")
    if kind == "TriangleList":
        if id(entry) not in known.entries:
            parts = ("points", "triangles", "colors", "normals", "edges", "edgeColor")
            key = tuple(as_array(f"{where}: '{part}'", entry.get(part, ())).tobytes() for part in parts)
            if key not in known.meshes:
                known.meshes[key] = _mesh(entry, default, where)
            known.entries[id(entry)] = entry, known.meshes[key]
        return "mesh", known.entries[id(entry)][1], None
    color = rgba(entry.get("color", (-1, -1, -1, 1)), default)
    if kind == "Line":
        return "line", as_rows(f"{where}: 'data'", entry["data"], 3), color
    position = as_vector(f"{where}: 'position'", entry["position"], 3)
    if kind == "Circle":
        angles = np.linspace(0, 2 * np.pi, 33)
        circle = np.stack([np.cos(angles), np.sin(angles), np.zeros_like(angles)], 1)
        normal = as_vector(f"{where}: 'normal'", entry.get("normal", (0, 0, 1)), 3)
        radius = as_number(f"{where}: 'radius'", entry["radius"])
        return "line", position + radius * circle @ frame_along(normal).T, color
    return "text", (position, str(entry["text"])), (color, entry.get("fontSize", 0.0))


def _mesh(entry: dict[str, Any], default: Rgba, where: str) -> Mesh:
    points = as_rows(f"{where}: 'points'", entry["points"], 3)
    triangles = as_point_numbers(f"{where}: 'triangles'", entry["triangles"], 3, len(points))
    colors = as_one_each(f"{where}: 'colors'", entry.get("colors", ()), 4, len(points))
    if colors is None:
        colors = np.tile(np.array(default), (len(points), 1))
    materials = _materials(colors)
    if len(colors) and (colors.min() < 0 or colors[:, 3].max() > 1):
        unique, which = np.unique(colors, axis=0, return_inverse=True)
        colors = np.array([rgba(color, default) for color in unique])[which.ravel()]
    normals = as_one_each(f"{where}: 'normals'", entry.get("normals", ()), 3, len(points))
    if normals is not None and not normals.any(axis=1).all():
        normals = None  # some are zero: nobody has computed them
    edges = as_point_numbers(f"{where}: 'edges'", entry.get("edges", ()), 2, len(points))
    edge_color = rgba(entry.get("edgeColor", (0.2, 0.2, 0.2, 1.0)))
    return Mesh(points, triangles, normals, colors, edges, edge_color, materials)


def _materials(colors: FloatArray) -> IntArray | None:
    """Return the materials that replace the opacity of colors, as in Mesh; None if there are none."""
    named = colors[:, 3] >= material.indexBase
    if not named.any():
        return None
    numbers = np.where(named, colors[:, 3].astype(int) - material.indexBase + 1, 0)
    return np.where(colors[:, 0] < 0, -numbers, numbers)


def draw(pen: Pen, all_shapes: list[Shape], place: FloatArray, rotation: FloatArray, values: Any = None) -> None:
    """Draw shapes in a frame; values(points) returns the numbers for colors, or None."""
    for kind, what, look in all_shapes:
        if kind == "mesh":
            pen.mesh(what, place, rotation, None, None if values is None else values(what.points))
        elif kind == "line":
            pen.line(what @ rotation.T + place, look)
        else:
            pen.label(rotation @ what[0] + place, what[1], *look)
