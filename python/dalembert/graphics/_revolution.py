"""Solids of revolution: general contours, arrows and coordinate systems."""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._calls import checked
from dalembert._checks import FloatArray, as_matrix, as_number, as_points, as_vector, shape_error, unit_vector
from dalembert._geometry.rotations import ComputeOrthonormalBasisVectors
from dalembert._geometry.transformations import HT2rotationMatrix, HT2translation
from dalembert.graphics._elements import Text
from dalembert.graphics._mesh import (
    GraphicsData,
    at_least,
    at_most,
    grid_indices,
    no_unknown,
    ring,
    triangle_list,
    two_colors,
    unit_rows,
)
from dalembert.graphics._operations import MergeTriangleLists


def _contour_normals(contour: FloatArray, smooth: bool, smoothingAngle: float) -> tuple[FloatArray, FloatArray]:
    """Return the (axial, radial) normals at the start and the end of each contour segment."""
    tangents = np.diff(contour, axis=0)
    normals = unit_rows(np.column_stack([-tangents[:, 1], tangents[:, 0]]))
    if not smooth:
        return normals, normals
    closed = np.linalg.norm(contour[0] - contour[-1]) < 1e-10
    following = np.vstack([normals[1:], normals[:1] if closed else normals[-1:]])
    angle = np.arccos(np.clip(np.sum(normals * following, axis=1), -1.0, 1.0))
    average = unit_rows(normals + following)
    isSmooth = (angle < smoothingAngle)[:, None]
    end = np.where(isSmooth, average, normals)
    start = np.vstack([normals[:1], np.where(isSmooth, average, following)[:-1]])
    return start, end


@checked
def SolidOfRevolution(
    pAxis: npt.ArrayLike,
    vAxis: npt.ArrayLike,
    contour: npt.ArrayLike,
    color: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    nTiles: int = 16,
    smoothContour: bool = False,
    addEdges: bool | int = False,
    edgeColor: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    addFaces: bool = True,
    smoothingAngle: float = 6.283185307179586,
    **kwargs: Any,
) -> GraphicsData:
    """Return the surface that a contour of points [axial, radial] sweeps about the axis vAxis through pAxis.

    Looking along increasing axial coordinates, the solid is to the right of the contour. smoothContour averages the
    normals of neighbouring segments with an angle below smoothingAngle; addEdges is the number of lines along the
    contour, True draws the circles only; alternatingColor is the colour of the second half.
    """
    no_unknown("graphics.SolidOfRevolution", kwargs, ("alternatingColor",))
    nTiles = at_least("graphics.SolidOfRevolution", nTiles, 3)
    profile = as_points("SolidOfRevolution: contour", contour, 2)
    if len(profile) < 2:
        raise shape_error("SolidOfRevolution: contour", "at least 2 points", contour)
    e, n1, n2 = ComputeOrthonormalBasisVectors(vAxis)
    radial = ring(n1, n2, 2 * pi * np.arange(nTiles) / nTiles)

    def swept(start: FloatArray, end: FloatArray) -> FloatArray:
        """Return two rings per segment, from its (axial, radial) values at start and end."""
        both = np.stack([start, end], axis=1).reshape(-1, 2)
        return (both[:, :1, None] * e + both[:, 1:, None] * radial).reshape(-1, 3)

    points = as_vector("SolidOfRevolution: pAxis", pAxis, 3) + swept(profile[:-1], profile[1:])
    normals = swept(*_contour_normals(profile, smoothContour, smoothingAngle))
    nSegments = len(profile) - 1
    p, other, following, diagonal = grid_indices(2, nTiles)
    offset = 2 * nTiles * np.arange(nSegments)[:, None, None]
    triangles = (np.column_stack([p, other, diagonal, p, diagonal, following]) + offset).reshape(-1, 3)
    corners = points[triangles]
    on_axis = (corners == np.roll(corners, 1, axis=1)).all(axis=2).any(axis=1)  # these have no area
    triangles = triangles[~on_axis]
    rgba = np.tile(two_colors("SolidOfRevolution", color, kwargs.get("alternatingColor"), nTiles), (2 * nSegments, 1))
    edges: list[list[int]] | None = None
    if addEdges:
        circles = np.column_stack([p, following]) + offset
        edges = circles.reshape(-1, 2).tolist()
        lines = 0 if addEdges is True else int(addEdges)
        step = max(nTiles // max(lines, 1), 1)
        for i in range(0, min(lines * step, nTiles), step):
            edges += [[i + 2 * nTiles * k, i + 2 * nTiles * k + nTiles] for k in range(nSegments)]
    return triangle_list("SolidOfRevolution", points, triangles if addFaces else [], rgba, normals, edges, edgeColor)


@checked
def Arrow(
    pAxis: npt.ArrayLike,
    vAxis: npt.ArrayLike,
    radius: float,
    color: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    headFactor: float = 2,
    headStretch: float = 4,
    nTiles: int = 12,
) -> GraphicsData:
    """Return an arrow from pAxis along vAxis with its length; the head is headFactor times as thick as the shaft.

    The length of the head is headStretch times its radius.
    """
    unit_vector("Arrow: vAxis", vAxis)
    L = float(np.linalg.norm(as_vector("Arrow: vAxis", vAxis, 3)))
    head = radius * headFactor
    neck = L - headStretch * head
    contour = np.array([[0, 0], [0, radius], [neck, radius], [neck, head], [L, 0]])
    return SolidOfRevolution(pAxis, vAxis, contour, color, nTiles)


@checked
def Basis(
    origin: npt.ArrayLike = [0, 0, 0],
    rotationMatrix: npt.ArrayLike = np.eye(3),
    length: float = 1,
    colors: list[Any] = [[1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0]],
    headFactor: float = 2,
    headStretch: float = 4,
    nTiles: int = 12,
    **kwargs: Any,
) -> GraphicsData | list[GraphicsData]:
    """Return three arrows along the columns of a rotation matrix, or a list with texts if there are labels.

    Optional arguments: radius of the shafts (default: 0.01*length), labels (three texts). If length is zero, the
    result is empty.
    """
    no_unknown("graphics.Basis", kwargs, ("radius", "labels"))
    nTiles = at_most("graphics.Basis", nTiles)
    p = as_vector("Basis: origin", origin, 3)
    axes = as_number("Basis: length", length) * as_matrix("Basis: rotationMatrix", rotationMatrix, (3, 3)).T
    radius = kwargs.get("radius", 0.01 * length)
    if not isinstance(colors, (list, tuple, np.ndarray)) or len(colors) != 3:
        raise shape_error("Basis: colors", "three colors, one for each axis", colors)
    if length == 0:
        return triangle_list("Basis", np.zeros((0, 3)), [], np.zeros((0, 4)), np.zeros((0, 3)))
    x, y, z = (
        Arrow(p, axis, radius, rgba, headFactor, headStretch, nTiles) for axis, rgba in zip(axes, colors, strict=True)
    )
    arrows = MergeTriangleLists(MergeTriangleLists(x, y), z)
    labels = kwargs.get("labels")
    if labels is None:
        return arrows
    return [arrows, *(Text(p + axis, label) for axis, label in zip(axes, labels, strict=True))]


@checked
def Frame(
    HT: npt.ArrayLike = np.eye(4),
    length: float = 1,
    colors: list[Any] = [[1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0]],
    headFactor: float = 2,
    headStretch: float = 4,
    nTiles: int = 12,
    **kwargs: Any,
) -> GraphicsData:
    """Return three arrows along the axes of the frame of a 4x4 homogeneous transformation.

    Optional argument: radius of the shafts (default: 0.01*length).
    """
    no_unknown("graphics.Frame", kwargs, ("radius",))
    nTiles = at_most("graphics.Frame", nTiles)
    A, p = HT2rotationMatrix(HT), HT2translation(HT)
    frame = Basis(p, A, length, colors, headFactor, headStretch, nTiles, **kwargs)
    assert isinstance(frame, dict)
    return frame
