"""Solid and planar primitives. Lengths in m, angles in rad; points and axes are given in the frame of the body."""

from __future__ import annotations

from collections.abc import Sequence
from math import asin, inf, pi, sin, sqrt
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._calls import checked
from dalembert._checks import (
    FloatArray,
    IntArray,
    as_array,
    as_color,
    as_number,
    as_points,
    as_vector,
    check_integer,
    shape_error,
    unit_vector,
)
from dalembert._geometry.rotations import ComputeOrthonormalBasisVectors, RotationVector2RotationMatrix
from dalembert.graphics._mesh import (
    MOST_TILES,
    GraphicsData,
    at_least,
    grid_indices,
    no_unknown,
    ring,
    triangle_list,
    triangle_normals,
    two_colors,
)
from dalembert.graphics._operations import MergeTriangleLists
from dalembert.graphics._revolution import SolidOfRevolution
from dalembert.graphics._styles import color as colors


def _outward(index: tuple[npt.NDArray[Any], ...]) -> npt.NDArray[Any]:
    """Return two triangles per grid cell, rows first, with normals towards (row direction) x (column direction)."""
    p, next_row, next_column, diagonal = index
    return np.column_stack([p, next_row, diagonal, p, diagonal, next_column]).reshape(-1, 3)


def _sphere_edges(nTiles: int, level: int) -> list[int]:
    """Return edges along meridians and, from level 2 on, circles of latitude of a sphere."""
    columns = 2 * nTiles
    meridians = 2 if level == 1 else 4 if level <= 3 else 8
    if meridians > nTiles:
        meridians = max(2, 2 * (nTiles // 2))
    rowStep = max(nTiles // max(level - 1, 1), 1)
    edges: list[int] = []
    if level > 1:
        for row in range(0, nTiles, rowStep):
            for j in range(columns):
                edges += [row * columns + j, row * columns + (j + 1) % columns]
    last = [nTiles * columns + k * (columns // meridians) for k in range(meridians)]
    for k in range(meridians):
        j = k * (columns // meridians)
        for row in range(nTiles):
            edges += [row * columns + j, (row + 1) * columns + j]
        edges += [last[k], last[max(k, (k + meridians // 2) % meridians)]]  # opposite meridians meet at the pole
    return edges


@checked
def Sphere(
    point: npt.ArrayLike = [0, 0, 0],
    radius: float = 0.1,
    color: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    nTiles: int = 8,
    addEdges: bool | int = False,
    edgeColor: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    addFaces: bool = True,
    majorAngleMin: float = -1.5707963267948966,
    majorAngleMax: float = 1.5707963267948966,
    innerRadius: float | None = None,
) -> GraphicsData:
    """Return a sphere, a zone of it between two latitudes (about z), or with innerRadius a thick-walled shell.

    nTiles is the number of tiles along a meridian, the equator has twice as many; addEdges (True stands for 3) sets
    the number of circles drawn on a full sphere.
    """
    nTiles = at_least("graphics.Sphere", nTiles, 2)
    radius = as_number("Sphere: radius", radius, negative=False)
    if not -0.5 * pi <= majorAngleMin < majorAngleMax <= 0.5 * pi:
        received = [majorAngleMin, majorAngleMax]
        raise shape_error("Sphere: majorAngleMin, majorAngleMax", "increasing angles in [-pi/2, pi/2]", received)
    ex, ey, ez = np.eye(3)
    equator = ring(ex, ey, 2 * pi * np.arange(2 * nTiles) / (2 * nTiles))

    def directions(latitudes: FloatArray) -> FloatArray:
        parallels = np.cos(latitudes)[:, None, None] * equator + np.sin(latitudes)[:, None, None] * ez
        return parallels.reshape(-1, 3)

    def zone(start: float, end: float) -> FloatArray:
        return directions(np.linspace(start, end, nTiles + 1))

    normals = zone(majorAngleMin, majorAngleMax)
    points = radius * normals
    cells = _outward(grid_indices(nTiles + 1, 2 * nTiles))
    triangles = [cells]
    if innerRadius is not None:
        if not 0 < innerRadius < radius:
            raise shape_error("Sphere: innerRadius", f"a number between 0 and radius={radius}", innerRadius)
        heights = [radius * sin(majorAngleMin), radius * sin(majorAngleMax)]
        innerLatitudes = [asin(min(max(z / innerRadius, -1.0), 1.0)) for z in heights]
        inner = zone(innerLatitudes[1], innerLatitudes[0])
        triangles.append(cells + len(points))
        points = np.vstack([points, innerRadius * inner])
        normals = np.vstack([normals, -inner])
        rim = _outward(grid_indices(2, 2 * nTiles))
        for k, latitude in enumerate([majorAngleMin, majorAngleMax]):
            innerLatitude = latitude if heights[k] >= innerRadius else innerLatitudes[k]
            outerRim = radius * directions(np.array([latitude]))
            innerRim = innerRadius * directions(np.array([innerLatitude]))
            if abs(heights[k]) < innerRadius:  # otherwise the inner sphere is closed there
                triangles.append(rim + len(points))
            points = np.vstack([points, innerRim, outerRim] if k == 0 else [points, outerRim, innerRim])
            normals = np.vstack([normals, np.tile((2 * k - 1) * ez, (4 * nTiles, 1))])
    level = 3 if addEdges is True else int(addEdges or 0)
    isFull = innerRadius is None and abs(majorAngleMax - majorAngleMin - pi) <= 1e-7
    edges = _sphere_edges(nTiles, level) if level > 0 and isFull else None
    center = as_vector("Sphere: point", point, 3)
    return triangle_list(
        "Sphere", points + center, np.vstack(triangles) if addFaces else [], color, normals, edges, edgeColor
    )


_CUBOID_TRIANGLES = np.array(
    [
        [[0, 2, 1], [0, 3, 2]],
        [[6, 4, 5], [6, 7, 4]],
        [[0, 1, 4], [1, 5, 4]],
        [[1, 2, 5], [2, 6, 5]],
        [[2, 3, 6], [3, 7, 6]],
        [[3, 0, 7], [0, 4, 7]],
    ]
)
_CUBOID_EDGES = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]]


_ALL_FACES = np.arange(6)
_IS_HIGH = np.array([[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))], dtype=bool)


def _cuboid_corner_edges(faces: Sequence[int] | IntArray) -> list[list[int]]:
    """Return each edge of a cuboid once, in terms of the 6 corners that every drawn face has of its own."""
    edges, seen = [], set()
    for n, face in enumerate(faces):
        corners = _CUBOID_TRIANGLES[face].ravel().tolist()
        for i, a in enumerate(corners):
            b = corners[i - i % 3 + (i + 1) % 3]
            if sorted([a, b]) in map(sorted, _CUBOID_EDGES) and frozenset((a, b)) not in seen:
                seen.add(frozenset((a, b)))
                edges.append([6 * n + i, 6 * n + i - i % 3 + (i + 1) % 3])
    return edges


@checked
def Spheres(
    points: npt.ArrayLike,
    radii: npt.ArrayLike = 0.1,
    colors: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    nTiles: int = -1,
) -> GraphicsData:
    """Return the triangles of many spheres; radii and colors are one for all or one per point.

    nTiles is the number of tiles along a meridian, -1 for 8.
    """
    centers = as_points("Spheres: points", points)
    count = len(centers)
    sizes = np.ravel(as_array("Spheres: radii", radii, "numbers"))
    shades = np.ravel(as_array("Spheres: colors", colors, "RGBA values"))
    if len(sizes) not in (1, count) or (sizes < 0).any():
        raise shape_error("Spheres: radii", f"one radius, or {count}, that are not negative", radii)
    if len(shades) not in (4, 4 * count):
        raise shape_error("Spheres: colors", f"4 RGBA values, or those of {count} points", colors)
    unit = Sphere(radius=1.0, nTiles=8 if nTiles == -1 else nTiles)
    directions = np.reshape(unit["points"], (-1, 3))
    places = centers[:, None, :] + np.broadcast_to(sizes, count)[:, None, None] * directions
    each = np.broadcast_to(shades.reshape(-1, 4), (count, 4)).repeat(len(directions), axis=0)
    corners = np.reshape(unit["triangles"], (-1, 3))
    triangles = (np.arange(count)[:, None, None] * len(directions) + corners).reshape(-1, 3)
    return triangle_list("Spheres", places.reshape(-1, 3), triangles, each, np.tile(directions, (count, 1)))


@checked
def SpheresToTriangleList(graphicsData: GraphicsData) -> GraphicsData:
    """Return a dictionary of the type Spheres, with points, radii and colors, as triangles; others as they are."""
    if graphicsData.get("type") != "Spheres":
        return graphicsData
    points = np.reshape(graphicsData.get("points", ()), (-1, 3))
    given = {key: graphicsData[key] for key in ("radii", "colors") if key in graphicsData}
    return Spheres(points, nTiles=int(graphicsData.get("resolution", -1)), **given)


@checked
def Cuboid(
    pList: npt.ArrayLike,
    color: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    faces: npt.ArrayLike = [1, 1, 1, 1, 1, 1],
    addNormals: bool = False,
    addEdges: bool | int = False,
    edgeColor: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    addFaces: bool = True,
) -> GraphicsData:
    """Return a block with 8 given corners: 4 of the bottom, counter-clockwise seen from above, and 4 of the top.

    faces switches bottom, top and the 4 sides on; if addNormals is set, faces have their own corners and normals.
    """
    points = as_points("Cuboid: pList", pList)
    if len(points) != 8:
        raise shape_error("Cuboid: pList", "a list of 8 points", pList)
    drawn = [i for i, on in enumerate(as_vector("Cuboid: faces", faces, 6)) if on]
    return _cuboid("Cuboid", points, color, drawn, addNormals, addEdges, edgeColor, addFaces)


def _cuboid(
    where: str,
    points: FloatArray,
    color: npt.ArrayLike,
    drawn: Sequence[int] | IntArray,
    addNormals: bool,
    addEdges: bool | int,
    edgeColor: npt.ArrayLike,
    addFaces: bool,
) -> GraphicsData:
    """Return some faces of a block with 8 given corners."""
    triangles = _CUBOID_TRIANGLES[drawn].reshape(-1, 3)
    if not addNormals:
        edges = _CUBOID_EDGES if addEdges else None
        return triangle_list(where, points, triangles if addFaces else [], color, None, edges, edgeColor)
    normals = np.repeat(triangle_normals(points, triangles), 3, axis=0)
    edges = _cuboid_corner_edges(drawn) if addEdges else None
    own = range(triangles.size) if addFaces else range(0)
    return triangle_list(where, points[triangles.ravel()], own, color, normals, edges, edgeColor)


@checked
def BrickXYZ(
    xMin: float,
    yMin: float,
    zMin: float,
    xMax: float,
    yMax: float,
    zMax: float,
    color: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    addNormals: bool = False,
    addEdges: bool | int = False,
    edgeColor: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    addFaces: bool = True,
) -> GraphicsData:
    """Return a block between minimal and maximal coordinates; Brick replaces this function."""
    corners = _corners([xMin, yMin, zMin], [xMax, yMax, zMax])
    return _cuboid("BrickXYZ", corners, color, _ALL_FACES, addNormals, addEdges, edgeColor, addFaces)


def _corners(low: npt.ArrayLike, high: npt.ArrayLike) -> FloatArray:
    """Return the corners of a block between minimal and maximal coordinates: 4 of the bottom, and 4 of the top."""
    return np.where(_IS_HIGH, np.asarray(high, float), np.asarray(low, float))


def _rounded_radius(angles: FloatArray, roundness: float) -> FloatArray:
    """Return the radius of a curve between square (roundness 0) and circle (1), with corners cut off."""
    exponent = 1 + min(max(roundness, 0), 1)
    power = np.abs(np.cos(angles + pi / 4)) ** exponent + np.abs(np.sin(angles + pi / 4)) ** exponent
    cut = pi / 4 * (min(roundness, 0.2) if roundness <= 0.2 else sqrt(0.2 * roundness))
    limit = sqrt(2.0) / (abs(np.cos(cut)) + abs(np.sin(cut)))
    return np.minimum(2 * 0.5 ** (exponent / 2) / power, limit)


@checked
def Brick(
    centerPoint: npt.ArrayLike = [0, 0, 0],
    size: npt.ArrayLike = [0.1, 0.1, 0.1],
    color: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    addNormals: bool = False,
    addEdges: bool | int = False,
    edgeColor: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    addFaces: bool = True,
    roundness: float = 0,
    nTiles: int = 12,
) -> GraphicsData:
    """Return a block with a centre and three side lengths; roundness from 0 to 1 turns it into an ellipsoid.

    A rounded block has nTiles tiles along its equator, and no edges.
    """
    center = as_vector("Brick: centerPoint", centerPoint, 3)
    half = 0.5 * as_vector("Brick: size", size, 3)
    if not all(0 <= length < inf for length in half.tolist()):
        raise shape_error("Brick: size", "finite side lengths that are not negative", size)
    if roundness == 0:
        corners = _corners(center - half, center + half)
        return _cuboid("Brick", corners, color, _ALL_FACES, addNormals, addEdges, edgeColor, addFaces)
    nTiles = at_least("graphics.Brick", nTiles, 8)
    nRows = nTiles // 2 + 1
    u = np.linspace(0, 2 * pi, nTiles, endpoint=False)[None, :]
    v = np.linspace(0, pi, nRows)[:, None]
    radiusU, radiusV = _rounded_radius(u, roundness), _rounded_radius(v, roundness)
    around = np.sin(v) * radiusV * radiusU
    shape = np.stack([around * np.cos(u), around * np.sin(u), np.cos(v) * radiusV + 0 * u], axis=-1).reshape(-1, 3)
    triangles = _outward(grid_indices(nRows, nTiles)).reshape(nRows - 1, nTiles, 2, 3)
    keep = np.ones(triangles.shape[:3], dtype=bool)
    keep[0, :, 1] = keep[-1, :, 0] = False  # triangles without area at the poles
    normals = shape / np.linalg.norm(shape, axis=1, keepdims=True)
    return triangle_list("Brick", center + half * shape, triangles[keep], color, normals)


@checked
def Cylinder(
    pAxis: npt.ArrayLike = [0, 0, 0],
    vAxis: npt.ArrayLike = [0, 0, 1],
    radius: float = 0.1,
    color: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    nTiles: int = 16,
    radiusInner: float | None = None,
    angleRange: npt.ArrayLike = [0, 6.283185307179586],
    lastFace: bool = True,
    cutPlain: bool = True,
    addEdges: bool | int = False,
    edgeColor: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    addFaces: bool = True,
    **kwargs: Any,
) -> GraphicsData:
    """Return a cylinder from the point pAxis along vAxis, whose length is the length of the cylinder.

    A positive radiusInner makes it hollow (and always complete). angleRange cuts out a part of it, closed by a plane
    through
    the two cut lines (cutPlain) or by planes to the axis; lastFace=False leaves it open. addEdges is the number of
    lines along the lateral surface, True draws the circles only. alternatingColor is the colour of the second half.
    """
    no_unknown("graphics.Cylinder", kwargs, ("alternatingColor",))
    nTiles = at_least("graphics.Cylinder", nTiles, 3)
    axis = as_vector("Cylinder: vAxis", vAxis, 3)
    unit_vector("Cylinder: vAxis", axis)
    radius = as_number("Cylinder: radius", radius, negative=False)
    start, whole = as_vector("Cylinder: pAxis", pAxis, 3), as_color("Cylinder: color", color)
    first, last = as_vector("Cylinder: angleRange", angleRange, 2)
    if radiusInner is not None:
        radiusInner = as_number("Cylinder: radiusInner", radiusInner, negative=False)
        as_color("Cylinder: edgeColor", edgeColor)
        L = float(np.linalg.norm(axis))
        contour = [[0, radius], [L, radius], [L, radiusInner], [0, radiusInner], [0, radius]]
        return SolidOfRevolution(
            pAxis, vAxis, contour, color, nTiles, addEdges=addEdges, edgeColor=edgeColor, addFaces=addFaces
        )
    ends = np.array([start, start + axis])
    e, n1, n2 = ComputeOrthonormalBasisVectors(axis)
    steps = nTiles - 1 if last - first < 2 * pi else nTiles
    radial = ring(n1, n2, first + (last - first) * np.arange(nTiles) / steps)
    rims = [end + radius * radial for end in ends]
    points = np.vstack([ends[0], rims[0], ends[1], rims[1], rims[0], rims[1]])
    normals = np.vstack([-e, radial, e, radial, np.tile(-e, (nTiles, 1)), np.tile(e, (nTiles, 1))])
    rgba = two_colors("Cylinder", color, kwargs.get("alternatingColor"), nTiles)
    pointColors = np.vstack([np.tile(whole, (2, 1)), *[rgba] * 4])

    n, i = nTiles + 1, np.arange(nTiles)
    following = (i + 1) % nTiles
    mantle = np.column_stack([1 + i, n + 1 + i, n + 1 + following, 1 + i, n + 1 + following, 1 + following])
    zeros, bottom, top = 0 * i, 2 * n, 2 * n + nTiles
    caps = np.column_stack([zeros, bottom + i, bottom + following, zeros + n, top + following, top + i])
    triangles = [
        mantle[: nTiles if lastFace and cutPlain else -1].reshape(-1, 3),
        caps[: nTiles if cutPlain else -1].reshape(-1, 3),
    ]
    if lastFace and not cutPlain:
        triangles.append(len(points) + np.array([[0, 1, 3], [0, 3, 2], [5, 4, 6], [5, 6, 7]]))
        for k, sign in ((0, 1.0), (-1, -1.0)):
            points = np.vstack([points, *ends, rims[0][k], rims[1][k]])
            normals = np.vstack([normals, np.tile(sign * np.cross(e, radial[k]), (4, 1))])
        pointColors = np.vstack([pointColors, np.tile(whole, (8, 1))])
    edges = None
    if addEdges:
        previous = np.column_stack([(i - 1) % nTiles, i]) + 1
        edges = np.vstack([previous, previous + n]).tolist()
        lines = 0 if addEdges is True else int(addEdges)
        edges += [[1 + k * (nTiles // lines), n + 1 + k * (nTiles // lines)] for k in range(lines)]
    return triangle_list(
        "Cylinder", points, np.vstack(triangles) if addFaces else [], pointColors, normals, edges, edgeColor
    )


@checked
def Tube(
    points: npt.ArrayLike,
    axes: npt.ArrayLike,
    radius: float = 0.1,
    color: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    nTiles: int = 16,
) -> GraphicsData:
    """Return a tube through points with the given axis at each of them, without twist and with open ends."""
    nTiles = at_least("graphics.Tube", nTiles, 3)
    radius, color = as_number("Tube: radius", radius), as_color("Tube: color", color)
    centers, tangents = as_points("Tube: points", points), as_points("Tube: axes", axes)
    if len(centers) < 2 or len(centers) != len(tangents):
        raise ValueError(
            f"Tube: expected at least 2 points and as many axes, received {len(centers)} points, {len(tangents)} axes"
        )
    z = unit_vector("Tube: axes[0]", tangents[0])
    x = np.cross([0.0, 0.0, 1.0] if abs(z[2]) < 0.9 else [1.0, 0.0, 0.0], z)
    x /= np.linalg.norm(x)
    y = np.cross(z, x)
    angles = 2 * pi * np.arange(nTiles) / nTiles
    rings = []
    for i, tangent in enumerate(tangents):
        previous, z = z, unit_vector(f"Tube: axes[{i}]", tangent)
        turn = np.cross(previous, z)
        sine = np.linalg.norm(turn)
        if sine >= 1e-6:  # carry the frame along with the smallest rotation
            A = RotationVector2RotationMatrix(np.arctan2(sine, previous @ z) / sine * turn)
            x, y = A @ x, A @ y
        rings.append(ring(y, x, angles))
    normals = np.vstack(rings)
    p, next_ring, following, diagonal = grid_indices(len(centers), nTiles)
    triangles = np.column_stack([p, following, next_ring, following, diagonal, next_ring])
    return triangle_list("Tube", np.repeat(centers, nTiles, axis=0) + radius * normals, triangles, color, normals)


@checked
def Torus(
    point: npt.ArrayLike,
    axis: npt.ArrayLike,
    radiusMajor: float = 0.5,
    radiusMinor: float = 0.1,
    color: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    nTilesMajor: int = 24,
    nTilesMinor: int = 12,
    minorAngleStart: float = 0,
    minorAngleEnd: float = 6.283185307179586,
    smoothNormals: bool = True,
    invert: bool = False,
) -> GraphicsData:
    """Return a torus about an axis through its centre point.

    The angle of the smaller circle starts in the plane of the torus at its outside; a part of the circle gives an
    open surface, and invert turns its visible side inwards.
    """
    nTilesMajor = at_least("graphics.Torus", nTilesMajor, 3, "nTilesMajor")
    nTilesMinor = at_least("graphics.Torus", nTilesMinor, 3, "nTilesMinor")
    if minorAngleStart >= minorAngleEnd:
        received = [minorAngleStart, minorAngleEnd]
        raise shape_error("Torus: minorAngleStart, minorAngleEnd", "increasing angles", received)
    isOpen = minorAngleEnd - minorAngleStart < 2 * pi - 1e-10
    columns = nTilesMinor + isOpen
    e, n1, n2 = ComputeOrthonormalBasisVectors(axis)
    radial = ring(n2, n1, 2 * pi * np.arange(nTilesMajor) / nTilesMajor)[:, None, :]
    theta = minorAngleStart + (minorAngleEnd - minorAngleStart) * np.arange(columns)[None, :, None] / nTilesMinor
    normals = np.cos(theta) * radial + np.sin(theta) * e
    points = as_vector("Torus: point", point, 3) + radiusMajor * radial + radiusMinor * normals
    p, next_row, following, diagonal = grid_indices(nTilesMajor, columns, wrapRows=True, wrapColumns=not isOpen)
    if invert:
        triangles = np.column_stack([p, following, next_row, following, diagonal, next_row])
    else:
        triangles = np.column_stack([p, next_row, following, following, next_row, diagonal])
    sign = -1.0 if invert else 1.0
    return triangle_list("Torus", points.reshape(-1, 3), triangles, color, sign * normals if smoothNormals else None)


@checked
def RigidLink(
    p0: npt.ArrayLike,
    p1: npt.ArrayLike,
    axis0: npt.ArrayLike = [0, 0, 0],
    axis1: npt.ArrayLike = [0, 0, 0],
    radius: npt.ArrayLike = [0.1, 0.1],
    thickness: float = 0.05,
    width: npt.ArrayLike = [0.05, 0.05],
    color: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    nTiles: int = 16,
) -> GraphicsData:
    """Return a bar between two joints, drawn as cylinders along their axes or, for a zero axis, as spheres.

    thickness is the diameter of the bar, width the length of the joint cylinders.
    """
    ends = np.array([as_vector("RigidLink: p0", p0, 3), as_vector("RigidLink: p1", p1, 3)])
    axes = [as_vector("RigidLink: axis0", axis0, 3), as_vector("RigidLink: axis1", axis1, 3)]
    radii, widths = as_vector("RigidLink: radius", radius, 2), as_vector("RigidLink: width", width, 2)
    link = Cylinder(ends[0], ends[1] - ends[0], 0.5 * thickness, color, nTiles)
    for end, axis, r, w in zip(ends, axes, radii, widths, strict=True):
        if np.any(axis != 0.0):
            v = w * unit_vector("axis", axis)
            joint = Cylinder(end - 0.5 * v, v, r, color, nTiles)
        else:
            joint = Sphere(end, r, color, nTiles)
        link = MergeTriangleLists(link, joint)
    return link


@checked
def Quad(pList: npt.ArrayLike, color: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0], **kwargs: Any) -> GraphicsData:
    """Return a surface between 4 points (counter-clockwise), divided into nTiles x nTilesY tiles.

    Optional arguments: alternatingColor draws a checkerboard (nTiles is 10 then), nTiles, nTilesY (default: nTiles).
    """
    no_unknown("graphics.Quad", kwargs, ("alternatingColor", "nTiles", "nTilesY"))
    corners = as_points("Quad: pList", pList)
    if len(corners) != 4:
        raise shape_error("Quad: pList", "a list of 4 points", pList)
    nx = kwargs.get("nTiles", 10 if "alternatingColor" in kwargs else 1)
    ny = kwargs.get("nTilesY", nx)
    check_integer("Quad: nTiles", nx, 1, MOST_TILES)
    check_integer("Quad: nTilesY", ny, 1, MOST_TILES)
    u, v = (np.linspace(0.0, 1.0, n + 1) for n in (nx, ny))
    left = np.outer(1 - v, corners[0]) + np.outer(v, corners[3])
    right = np.outer(1 - v, corners[1]) + np.outer(v, corners[2])
    grid = ((1 - u)[None, :, None] * left[:, None] + u[None, :, None] * right[:, None]).reshape(-1, 3)
    p, above, following, diagonal = grid_indices(ny + 1, nx + 1, wrapColumns=False)
    tiles = np.column_stack([p, following, diagonal, above])
    normals = triangle_normals(grid, tiles[:, :3])
    triangles = 4 * np.arange(nx * ny)[:, None] + np.array([0, 1, 2, 0, 2, 3])
    both = two_colors("Quad", color, kwargs.get("alternatingColor"), 2)
    odd = (np.arange(ny)[:, None] + np.arange(nx)[None, :]).ravel() % 2
    return triangle_list(
        "Quad", grid[tiles.ravel()], triangles, np.repeat(both[odd], 4, axis=0), np.repeat(normals, 4, axis=0)
    )


@checked
def CheckerBoard(
    point: npt.ArrayLike = [0, 0, 0],
    normal: npt.ArrayLike = [0, 0, 1],
    size: float = 1,
    color: npt.ArrayLike = colors.lightgrey,
    alternatingColor: npt.ArrayLike = colors.lightgrey2,
    nTiles: int = 10,
    **kwargs: Any,
) -> GraphicsData:
    """Return a square checkerboard with a centre point, normal and side length.

    Optional arguments: size2 and nTiles2 for the second direction, materialIndex (in the place of alpha).
    """
    no_unknown("graphics.CheckerBoard", kwargs, ("nTiles2", "size2", "materialIndex"))
    for name, number in (("nTiles", nTiles), ("nTiles2", kwargs.get("nTiles2", nTiles))):
        check_integer(f"CheckerBoard: {name}", number, 1, MOST_TILES)
    both = np.array(
        [as_color("CheckerBoard: color", color), as_color("CheckerBoard: alternatingColor", alternatingColor)]
    )
    if "materialIndex" in kwargs:
        both[:, 3] = kwargs["materialIndex"]
    _, n1, n2 = ComputeOrthonormalBasisVectors(normal)
    a, b = 0.5 * size * n1, 0.5 * kwargs.get("size2", size) * n2
    corners = as_vector("CheckerBoard: point", point, 3) + np.array([-a - b, a - b, a + b, b - a])
    return Quad(corners, both[0], alternatingColor=both[1], nTiles=nTiles, nTilesY=kwargs.get("nTiles2", nTiles))
