"""Operations on graphicsData: conversion, transformation, merging, checks, bounding boxes, edges."""

from __future__ import annotations

import copy
import warnings
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._calls import checked
from dalembert._checks import (
    FloatArray,
    IntArray,
    as_array,
    as_color,
    as_matrix,
    as_number,
    as_one_each,
    as_point_numbers,
    as_rows,
    as_vector,
    shape_error,
)
from dalembert.graphics._mesh import (
    PLACES,
    GraphicsData,
    entry_of,
    mesh_of,
    place_of,
    require_type,
    triangle_list,
    triangle_normals,
    unit_rows,
)


@checked
def BoundingBoxSingle(graphicsData: GraphicsData) -> list[FloatArray | None]:
    """Return [lower, upper] corner (3D vectors) of one graphicsData, or [None, None] if it has no points."""
    where = "BoundingBoxSingle"
    points = place_of(where, graphicsData)
    if graphicsData["type"] == "Circle":
        radius = as_number(f"{where}: graphicsData['radius']", entry_of(where, graphicsData, "radius"), negative=False)
        extent = np.array([radius, radius, 0.0])
        points = np.concatenate([points - extent, points + extent])
    if points.size == 0:
        return [None, None]
    return [points.min(axis=0), points.max(axis=0)]


@checked
def BoundingBox(graphicsData: GraphicsData | list[GraphicsData]) -> list[FloatArray | None]:
    """Return [lower, upper] corner of one or several graphicsData, or [None, None] if there are no points."""
    if not isinstance(graphicsData, dict | list):
        raise shape_error("BoundingBox: graphicsData", "a dictionary or a list of dictionaries", graphicsData)
    single = [graphicsData] if isinstance(graphicsData, dict) else graphicsData
    corners = [corner for g in single for corner in BoundingBoxSingle(g) if corner is not None]
    if not corners:
        return [None, None]
    return [np.min(corners, axis=0), np.max(corners, axis=0)]


@checked
def FromPointsAndTrigs(
    points: npt.ArrayLike,
    triangles: npt.ArrayLike,
    color: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    normals: npt.ArrayLike | None = None,
) -> GraphicsData:
    """Return a TriangleList from n points, triangles of indices, one colour or n colours, and optional n normals."""
    p = as_rows("FromPointsAndTrigs: points", points, 3).copy()
    corners = as_point_numbers("FromPointsAndTrigs: triangles", triangles, 3, len(p))
    rgba = as_array("FromPointsAndTrigs: color", color)
    if rgba.size != 4 and rgba.size != 4 * len(p):
        expected = f"4 RGBA values or 4 values for each of the {len(p)} points"
        raise shape_error("FromPointsAndTrigs: color", expected, color)
    n = as_one_each("FromPointsAndTrigs: normals", () if normals is None else normals, 3, len(p))
    colors = rgba.ravel() if rgba.size == 4 else rgba.reshape(-1, 4)
    return triangle_list("FromPointsAndTrigs", p, corners, colors, None if n is None else n.copy())


@checked
def ToPointsAndTrigs(g: GraphicsData) -> list[list[npt.NDArray[Any]]]:
    """Return [points, triangles] of a TriangleList, both as lists of arrays with 3 entries."""
    points, triangles = mesh_of("ToPointsAndTrigs", g)
    return [list(points), list(triangles)]


def _normalized(normals: FloatArray, where: str, warn: bool = True) -> FloatArray:
    nZero = int(np.count_nonzero(~normals.any(axis=1)))
    if nZero and warn:
        warnings.warn(f"{where}: {nZero} normals have length zero and are left as zeros", stacklevel=4)
    return unit_rows(normals)


@checked
def Transform(
    graphicsData: GraphicsData,
    translation: npt.ArrayLike | None = None,
    rotation: npt.ArrayLike | None = None,
    scale: float = 1,
    normalizeNormals: bool = False,
    invertNormals: bool = False,
    invertTriangles: bool = False,
    warn: bool = True,
) -> GraphicsData:
    """Return new graphicsData with the points translation + scale * rotation @ p, and turned normals.

    normalizeNormals gives normals length one (warn reports zero ones); invertNormals and invertTriangles turn the
    normals and the orientation of the triangles round.
    """
    r = np.zeros(3) if translation is None else as_vector("Transform: translation", translation, 3)
    A = np.eye(3) if rotation is None else as_matrix("Transform: rotation", rotation, (3, 3))
    factor = as_number("Transform: scale", scale)
    points = place_of("Transform", graphicsData)
    kind = graphicsData["type"]
    result = copy.deepcopy(graphicsData)
    result[PLACES[kind]] = (r + factor * points @ A.T).ravel()
    if "radius" in result:
        result["radius"] = factor * as_number("Transform: graphicsData['radius']", result["radius"])
    if "normal" in result:
        result["normal"] = A @ as_vector("Transform: graphicsData['normal']", result["normal"], 3)
    if kind != "TriangleList":
        return result
    for name in {"colors", "triangles", "edges", "edgeColor"} & result.keys():
        result[name] = np.array(result[name])
    if invertTriangles:
        result["triangles"] = mesh_of("Transform", graphicsData)[1][:, [1, 0, 2]].ravel()
    if "normals" in result:
        normals = as_rows("graphics.Transform: graphicsData['normals']", graphicsData["normals"], 3)
        if normalizeNormals:
            normals = _normalized(normals, "graphics.Transform", warn)
        result["normals"] = ((-normals if invertNormals else normals) @ A.T).ravel()
    return result


@checked
def Move(g: GraphicsData, pOff: npt.ArrayLike, Aoff: npt.ArrayLike | None = None) -> GraphicsData:
    """Return new graphicsData with the points pOff + Aoff @ p."""
    as_vector("Move: pOff", pOff, 3)
    if Aoff is not None:
        as_matrix("Move: Aoff", Aoff, (3, 3))
    return Transform(g, pOff, Aoff)


@checked
def Triangles6ToTriangles(graphicsData: GraphicsData) -> GraphicsData:
    """Return a TriangleList whose curved triangles and edges are replaced by flat triangles and straight edges.

    'triangles6' has six points for each triangle, the corners and the middles of the sides 0-1, 1-2 and 2-0, which
    make four triangles; 'edges3' has the ends and the middle of each edge. Other dictionaries are returned as they are.
    """
    curved = {"triangles6": 6, "edges3": 3}
    if graphicsData.get("type") != "TriangleList" or not curved.keys() & graphicsData.keys():
        return graphicsData
    count = len(place_of("Triangles6ToTriangles", graphicsData))

    def rows(key: str, size: int) -> IntArray:
        where = f"Triangles6ToTriangles: graphicsData['{key}']"
        return as_point_numbers(where, graphicsData.get(key, ()), size, count)

    found = {key: value for key, value in graphicsData.items() if key not in curved}
    parts = rows("triangles6", 6)[:, [0, 3, 5, 3, 1, 4, 5, 4, 2, 3, 4, 5]]
    found["triangles"] = np.concatenate([rows("triangles", 3).ravel(), parts.ravel()])
    if "edges3" in graphicsData:
        found["edges"] = np.concatenate([rows("edges", 2).ravel(), rows("edges3", 3)[:, [0, 2, 2, 1]].ravel()])
    return found


@checked
def MergeTriangleLists(g1: GraphicsData, g2: GraphicsData) -> GraphicsData:
    """Return one TriangleList of two; colors and normals are kept if both have them, the edge colour is the first."""
    parts: dict[str, list[npt.NDArray[Any]]] = {
        key: [] for key in ("colors", "points", "normals", "triangles", "edges")
    }
    before = 0
    for name, g in (("g1", g1), ("g2", g2)):
        where = f"MergeTriangleLists: {name}"
        require_type(where, g, "TriangleList")
        points = place_of(where, g)
        triangles = as_point_numbers(
            f"{where}: graphicsData['triangles']", entry_of(where, g, "triangles"), 3, len(points)
        )
        parts["points"].append(points.ravel())
        parts["triangles"].append(triangles.ravel() + before)
        for key, size in (("colors", 4), ("normals", 3)):
            each = as_one_each(f"{where}: graphicsData['{key}']", g.get(key, ()), size, len(points))
            if each is not None or len(points) == 0:
                parts[key].append(np.zeros(0) if each is None else each.ravel())
        if "edges" in g:
            edges = as_point_numbers(f"{where}: graphicsData['edges']", g["edges"], 2, len(points))
            parts["edges"].append(edges.ravel() + before)
        before += len(points)
    merged: GraphicsData = {"type": "TriangleList"}
    for key, both in parts.items():
        if len(both) == 2 or (both and key == "edges"):
            merged[key] = np.concatenate(both)
    edgeColors = [g["edgeColor"] for g in (g1, g2) if "edgeColor" in g]
    if edgeColors:
        merged["edgeColor"] = np.array(edgeColors[0], dtype=float)
    return merged


@checked
def InvertTriangles(
    graphicsData: GraphicsData, invertTriangles: bool = True, invertNormals: bool = True
) -> GraphicsData:
    """Return a copy of a TriangleList with inverted orientation of the triangles, of the normals, or of both."""
    require_type("InvertTriangles", graphicsData, "TriangleList")
    if invertNormals and "normals" not in graphicsData:
        raise ValueError("InvertTriangles: graphicsData has no normals; use invertNormals=False")
    return Transform(graphicsData, invertTriangles=invertTriangles, invertNormals=invertNormals)


@checked
def InconsistentTriangles(graphicsData: GraphicsData) -> int:
    """Return the number of triangle corners whose point normal is opposed to the normal of the triangle."""
    points, triangles = mesh_of("InconsistentTriangles", graphicsData)
    name = "InconsistentTriangles: graphicsData['normals']"
    normals = as_one_each(name, graphicsData.get("normals", ()), 3, len(points))
    if normals is None:
        raise ValueError("InconsistentTriangles: graphicsData has no normals")
    return int(np.count_nonzero(np.einsum("tci,ti->tc", normals[triangles], triangle_normals(points, triangles)) < 0))


def _merged_points(points: FloatArray, roundDigits: int) -> tuple[FloatArray, IntArray, IntArray]:
    """Return points without duplicates, the index of the first duplicate of each, and the new index of each old one."""
    extent = float(np.linalg.norm(points.max(axis=0) - points.min(axis=0))) or 1.0
    rounded = extent * np.round(points / extent, roundDigits)
    unique, first, inverse = np.unique(rounded, axis=0, return_index=True, return_inverse=True)
    return unique, first, inverse.ravel()


def _sharp_edges(triangles: IntArray, normals: FloatArray, edgeAngle: float) -> list[list[int]]:
    """Return the edges where triangles meet at edgeAngle or more, and those with a triangle on one side only."""
    owner: dict[tuple[int, int], int] = {}
    for t, (a, b, c) in enumerate(triangles.tolist()):
        for edge in ((a, b), (b, c), (c, a)):
            owner.setdefault(edge, t)
    sharp = []
    for t, (a, b, c) in enumerate(triangles.tolist()):
        for i, j in ((a, b), (b, c), (c, a)):
            neighbour = owner.get((j, i))
            if neighbour is None or (
                i > j and np.arccos(np.clip(normals[t] @ normals[neighbour], -1.0, 1.0)) >= edgeAngle
            ):
                sharp.append([i, j])
    return sharp


def _point_colors(graphicsData: GraphicsData, nPoints: int, triangleColor: npt.ArrayLike) -> FloatArray:
    """Return one colour per point: the given one, or the colours of the data, or its first one if they do not fit."""
    where = "AddEdgesAndSmoothenNormals"
    given = as_array(where + ": triangleColor", triangleColor)
    if given.size:
        return np.tile(as_color(where + ": triangleColor", given), (nPoints, 1))
    colors = np.asarray(graphicsData["colors"], dtype=float)
    if colors.size != 4 * nPoints:
        warnings.warn(f"{where}: expected one colour for each of the {nPoints} points, using the first", stacklevel=4)
        return np.tile(colors[:4], (nPoints, 1))
    return colors.reshape(-1, 4)


@checked
def AddEdgesAndSmoothenNormals(
    graphicsData: GraphicsData,
    edgeColor: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    edgeAngle: float = 0.7853981633974483,
    addEdges: bool = True,
    smoothNormals: bool = True,
    roundDigits: int = 5,
    triangleColor: npt.ArrayLike = [],
) -> GraphicsData:
    """Return a TriangleList with edges where triangles meet at edgeAngle (rad) or more, and smooth normals elsewhere.

    Points that agree in roundDigits digits relative to the size of the geometry are merged. Normals are averaged
    with the areas of the triangles; triangles do not share points at edges. An empty triangleColor keeps
    the colours.
    """
    points, triangles = mesh_of("AddEdgesAndSmoothenNormals", graphicsData)
    colors = _point_colors(graphicsData, len(points), triangleColor)
    points, first, inverse = _merged_points(points, roundDigits)
    triangles, colors = inverse[triangles], colors[first]
    a, b, c = points[triangles[:, 0]], points[triangles[:, 1]], points[triangles[:, 2]]
    areaNormals = 0.5 * np.cross(b - a, c - a)
    normals = unit_rows(areaNormals)
    edges = _sharp_edges(triangles, normals, edgeAngle)

    pointNormals = None
    if smoothNormals:
        hasEdge = np.zeros(len(points), dtype=bool)
        hasEdge[np.array(edges, dtype=int).ravel()] = True
        pointNormals = np.zeros_like(points)
        np.add.at(pointNormals, triangles.ravel(), np.repeat(areaNormals, 3, axis=0))
        pointNormals = np.where(hasEdge[:, None], 0.0, unit_rows(pointNormals))
        split = hasEdge[triangles]
        old = triangles[split]
        triangles[split] = len(points) + np.arange(len(old))
        points, colors = np.vstack([points, points[old]]), np.vstack([colors, colors[old]])
        pointNormals = np.vstack([pointNormals, np.repeat(normals, 3, axis=0)[split.ravel()]])
    return triangle_list(
        "AddEdgesAndSmoothenNormals", points, triangles, colors, pointNormals, edges if addEdges else None, edgeColor
    )
