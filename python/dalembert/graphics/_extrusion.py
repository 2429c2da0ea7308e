"""Extruded solids: general outlines, linked cylinders, gears, racks, and the rings of ball bearings."""

from __future__ import annotations

from math import asin, ceil, cos, pi, radians, sin, tan
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._calls import checked
from dalembert._checks import (
    as_matrix,
    as_number,
    as_point_numbers,
    as_points,
    as_positive,
    as_vector,
    check_integer,
    shape_error,
    unit_vector,
)
from dalembert._geometry.rotations import GramSchmidt, RotationMatrix2D, RotationMatrixZ
from dalembert.graphics import _outlines as outlines
from dalembert.graphics._mesh import GraphicsData, triangle_list, unit_rows
from dalembert.graphics._revolution import SolidOfRevolution
from dalembert.graphics._solids import Cylinder


@checked
def SolidExtrusion(
    vertices: npt.ArrayLike,
    segments: npt.ArrayLike,
    height: float,
    rot: npt.ArrayLike = np.diag([1, 1, 1]),
    pOff: npt.ArrayLike = [0, 0, 0],
    relRot: npt.ArrayLike = np.diag([1, 1, 1]),
    relOff: npt.ArrayLike = [0, 0, 0],
    color: npt.ArrayLike = [0, 0, 0, 1],
    smoothNormals: bool = False,
    addEdges: bool | int = False,
    edgeColor: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    addFaces: bool = True,
) -> GraphicsData:
    """Return the solid between a 2D outline in the xy plane and its copy at z = height.

    The segments, pairs of indices of vertices, form closed curves: the outer one counter-clockwise, holes clockwise.
    The copy is turned by relRot and shifted by relOff; then everything is turned by rot and shifted by pOff.
    addEdges = 2 also draws the edges along the mantle.
    """
    outline = as_points("SolidExtrusion: vertices", vertices, 2)
    if len(outline) < 3:
        raise shape_error("SolidExtrusion: vertices", "at least 3 points of an outline", vertices)
    pairs = as_point_numbers("SolidExtrusion: segments", segments, 2, len(outline))
    if len(pairs) == 0:
        raise shape_error("SolidExtrusion: segments", "pairs of numbers of points", segments)
    A = as_matrix("SolidExtrusion: rot", rot, (3, 3))
    relative = as_matrix("SolidExtrusion: relRot", relRot, (3, 3))
    n = len(outline)
    bottom = np.column_stack([outline, np.zeros(n)])
    top = bottom @ relative.T + as_vector("SolidExtrusion: relOff", relOff, 3) + [0.0, 0.0, height]
    points, normals = np.vstack([bottom, top]), None
    mantle = 2 * n if smoothNormals else 0  # the mantle then has points of its own
    if smoothNormals:
        direction = outline[pairs[:, 1]] - outline[pairs[:, 0]]
        outward = unit_rows(np.column_stack([direction[:, 1], -direction[:, 0], np.zeros(len(pairs))]))
        side = np.zeros((n, 3))
        np.add.at(side, pairs, outward[:, None, :])
        flat = np.repeat([[0.0, 0.0, -1.0], relative[:, 2]], n, axis=0)
        normals = unit_rows(np.vstack([flat, side, side])) @ A.T
        points = np.vstack([points, points])
    faces = np.asarray(outlines.ComputeTriangularMesh(outline, pairs).simplices)
    a, b = pairs.T + mantle
    walls = np.column_stack([a, b, b + n, a, b + n, a + n]).reshape(-1, 3)
    triangles = np.vstack([faces[:, ::-1], faces + n, walls])
    edges = None
    if addEdges:
        edges = np.vstack([pairs, pairs + n])
        if addEdges == 2:
            edges = np.vstack([edges, np.column_stack([a, a + n])])
    transformed = points @ A.T + as_vector("SolidExtrusion: pOff", pOff, 3)
    return triangle_list("SolidExtrusion", transformed, triangles if addFaces else [], color, normals, edges, edgeColor)


def _arc(center: npt.ArrayLike, radius: float, start: float, end: float, nTiles: int) -> list[list[float]]:
    """Return the points of a counter-clockwise arc, with nTiles tiles per full circle, both ends included."""
    angle = end - start
    if angle < 0:
        angle += 2 * pi
    n = max(2, ceil(nTiles * angle / (2 * pi)))
    phi = start + angle * np.arange(n + 1) / n
    return (np.asarray(center) + radius * np.column_stack([np.cos(phi), np.sin(phi)])).tolist()


@checked
def LinkedCylinders(
    point0: npt.ArrayLike,
    point1: npt.ArrayLike,
    axisCylinder: npt.ArrayLike,
    radius0: float,
    radius1: float,
    radiusInner0: float = 0,
    radiusInner1: float = 0,
    nTiles: int = 32,
    color: npt.ArrayLike = [0, 0, 0, 1],
    addEdges: bool | int = 0,
    edgeColor: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    addFaces: bool = True,
    smoothNormals: bool = True,
    **kwargs: Any,
) -> GraphicsData:
    """Return two parallel cylinders joined by their common tangents, with optional holes, e.g. a connecting rod.

    axisCylinder gives direction and height, starting at the points. If one circle contains the other, only the
    larger cylinder is drawn. Further arguments go to SolidExtrusion.
    """
    p0, p1 = as_vector("LinkedCylinders: point0", point0, 3), as_vector("LinkedCylinders: point1", point1, 3)
    axis = as_vector("LinkedCylinders: axisCylinder", axisCylinder, 3)
    e3, e1, e2 = GramSchmidt(axis, p1 - p0)
    L = float((p1 - p0) @ e1)
    if abs(radius1 - radius0) >= L:
        start, radius = (p0, radius0) if radius0 > radius1 else (p1, radius1)
        return Cylinder(start, axis, radius, color, nTiles, addEdges=addEdges)
    tangent = pi - np.arccos((radius1 - radius0) / L)  # direction of the upper tangent point in both circles
    centers = [[0.0, 0.0], [L, 0.0]]
    outline = _arc(centers[1], radius1, -tangent, tangent, nTiles)
    outline += _arc(centers[0], radius0, tangent, -tangent, nTiles)
    segments = outlines.SegmentsFromPoints(outline).tolist()
    for center, inner, outer in zip(centers, (radiusInner0, radiusInner1), (radius0, radius1), strict=True):
        if 0 < inner < outer:
            hole = _arc(center, inner, 0, 2 * pi, nTiles)[:-1]
            segments += outlines.SegmentsFromPoints(hole, len(outline), invert=True).tolist()
            outline += hole
    return SolidExtrusion(
        outline,
        segments,
        float(np.linalg.norm(axis)),
        rot=np.column_stack([e1, e2, e3]),
        pOff=p0,
        color=color,
        smoothNormals=smoothNormals,
        addEdges=addEdges,
        edgeColor=edgeColor,
        addFaces=addFaces,
        **kwargs,
    )


@checked
def InvoluteGear(
    involuteGear: Any,
    width: float,
    centerPoint: npt.ArrayLike = np.zeros(3),
    rotationMatrix: npt.ArrayLike = np.eye(3),
    helixAngleDeg: float = 0,
    radius: float = 0,
    relativeAngleOffset: float = 0,
    color: npt.ArrayLike = [0, 0, 0, 1],
    nTilesCylinder: int = 32,
    smoothNormals: bool = False,
    addEdges: bool | int = False,
    edgeColor: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    addFaces: bool = True,
) -> GraphicsData:
    """Return the gear of a machines.InvoluteGear about the z axis, with its centre in the middle of the width.

    radius is that of the bore, or the outer one of an internal gear; relativeAngleOffset turns the gear by parts of
    the angle of a tooth; helixAngleDeg (degrees) makes it helical.
    """
    if not hasattr(involuteGear, "GenerateGear"):
        raise shape_error("InvoluteGear: involuteGear", "a machines.InvoluteGear", involuteGear)
    outline = involuteGear.GenerateGear() @ RotationMatrix2D(relativeAngleOffset * involuteGear.angleToothAndGap)
    segments = outlines.SegmentsFromPoints(outline)
    if radius != 0 or involuteGear.isInternalGear:
        circle, circleSegments = outlines.CirclePointsAndSegments(radius=radius, nTiles=nTilesCylinder)
        segments = np.vstack([segments, np.array(circleSegments) + len(outline)])
        outline = np.vstack([outline, circle])
    if involuteGear.isInternalGear:
        segments = segments[::-1, ::-1]
    twist = width / (0.5 * involuteGear.module * involuteGear.nTeeth) * tan(radians(helixAngleDeg))
    A = as_matrix("InvoluteGear: rotationMatrix", rotationMatrix, (3, 3))
    return SolidExtrusion(
        outline,
        segments,
        width,
        rot=A @ RotationMatrixZ(-0.5 * twist),
        pOff=as_vector("InvoluteGear: centerPoint", centerPoint, 3) - [0.0, 0.0, 0.5 * width],
        relRot=RotationMatrixZ(0.5 * twist),
        color=color,
        smoothNormals=smoothNormals,
        addEdges=addEdges,
        edgeColor=edgeColor,
        addFaces=addFaces,
    )


@checked
def ToothedRack(
    module: float,
    nTeeth: int,
    width: float,
    toothHeight: float,
    rackBaseHeight: float,
    pressureAngleDeg: float = 20,
    centerPoint: npt.ArrayLike = np.zeros(3),
    rotationMatrix: npt.ArrayLike = np.eye(3),
    color: npt.ArrayLike = [0, 0, 0, 1],
    nTilesCylinder: int = 32,
    addEdges: bool | int = False,
    edgeColor: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    addFaces: bool = True,
) -> GraphicsData:
    """Return a rack with trapezoidal teeth along x, starting at the origin, with its middle plane at z = 0."""
    for name, value in (("module", module), ("width", width), ("toothHeight", toothHeight)):
        as_positive(f"ToothedRack: {name}", value)
    as_number("ToothedRack: rackBaseHeight", rackBaseHeight, negative=False)
    check_integer("ToothedRack: nTeeth", int(nTeeth), 1)
    pitch = module * pi
    flank = toothHeight * tan(radians(pressureAngleDeg))
    start = -0.5 * (0.5 * pitch - flank)
    low, high = rackBaseHeight, toothHeight + rackBaseHeight
    profile: list[list[float]] = [[nTeeth * pitch, 0.0], [0.0, 0.0]]
    for i in range(int(nTeeth)):
        x = i * pitch + start
        profile.append([max(0.0, x), low])
        profile.append([x + 0.5 * pitch - flank, low])
        profile.append([x + 0.5 * pitch, high])
        profile.append([x + pitch - flank, high])
    profile += [[nTeeth * pitch + start, low], [nTeeth * pitch, low]]
    return SolidExtrusion(
        profile,
        outlines.SegmentsFromPoints(profile, invert=True),
        width,
        rot=rotationMatrix,
        pOff=as_vector("ToothedRack: centerPoint", centerPoint, 3) - [0.0, 0.0, 0.5 * width],
        color=color,
        addEdges=addEdges,
        edgeColor=edgeColor,
        addFaces=addFaces,
    )


def _groove_angle(name: str, depth: float, grooveRadius: float) -> float:
    """Return the angle between the shoulder and the end of the groove in its section."""
    as_positive(f"BallBearingRings: {name}GrooveRadius", grooveRadius)
    if abs(depth) > grooveRadius:
        raise ValueError(
            f"BallBearingRings: expected a distance between {name}GrooveTorusRadius and {name}RingShoulderRadius of "
            f"at most {name}GrooveRadius={grooveRadius}, received {abs(depth)}"
        )
    return asin(depth / grooveRadius)


def _ring_section(
    width: float, shoulder: float, rim: float, chamfer: float, groove: list[list[float]], sign: int
) -> list[list[float]]:
    """Return the closed section of a ring: shoulder, chamfered rim (sign +1: inner ring), shoulder, groove."""
    w, c = 0.5 * width, chamfer
    half = [[w, shoulder], [w, rim + sign * c], [w - c, rim]]
    section = half + [[-x, r] for x, r in reversed(half)]
    return [[sign * x, r] for x, r in section] + groove + [[sign * w, shoulder]]


@checked
def BallBearingRings(
    axis: npt.ArrayLike,
    outsideDiameter: float,
    boreDiameter: float,
    width: float,
    radiusCage: float,
    innerRingShoulderRadius: float,
    outerRingShoulderRadius: float,
    widthCage: float,
    heightCage: float,
    innerEdgeChamfer: float,
    outerEdgeChamfer: float,
    innerGrooveRadius: float,
    outerGrooveRadius: float,
    innerGrooveTorusRadius: float,
    outerGrooveTorusRadius: float,
    nTilesRings: int = 32,
    nTilesGrooves: int = 12,
    colorCage: npt.ArrayLike = [0.6, 0.5, 0.5, 0.4],
    colorInnerRing: npt.ArrayLike = [0.5, 0.5, 0.5, 0.5],
    colorOuterRing: npt.ArrayLike = [0.5, 0.5, 0.5, 0.5],
    **kwargs: Any,
) -> dict[str, GraphicsData]:
    """Return innerRingGraphics, outerRingGraphics and cageGraphics of a ball bearing about an axis through the origin.

    The parameters are those of machines.GetBallBearingData, whose further entries are ignored. Raises ValueError if
    the groove does not reach the shoulder of its ring.
    """
    e = unit_vector("BallBearingRings: axis", axis)
    check_integer("BallBearingRings: nTilesGrooves", int(nTilesGrooves), 1)
    rings = {}
    for name, sign, grooveRadius, torusRadius, shoulder, rim, chamfer, rgba in (
        ("inner", 1, innerGrooveRadius, innerGrooveTorusRadius, innerRingShoulderRadius, 0.5 * boreDiameter,
         innerEdgeChamfer, colorInnerRing),
        ("outer", -1, outerGrooveRadius, outerGrooveTorusRadius, outerRingShoulderRadius, 0.5 * outsideDiameter,
         outerEdgeChamfer, colorOuterRing),
    ):  # fmt: skip
        start = _groove_angle(name, sign * (torusRadius - shoulder), grooveRadius)
        phi = [start + i / nTilesGrooves * (pi - 2 * start) for i in range(nTilesGrooves + 1)]
        groove = [[-sign * grooveRadius * cos(p), torusRadius - sign * grooveRadius * sin(p)] for p in phi]
        contour = _ring_section(width, shoulder, rim, chamfer, groove, sign)
        rings[name] = SolidOfRevolution(
            [0, 0, 0], e, contour, rgba, nTilesRings, smoothContour=True, smoothingAngle=0.24 * pi
        )
    cage = Cylinder(
        -0.5 * widthCage * e,
        widthCage * e,
        radiusCage + 0.5 * heightCage,
        colorCage,
        nTilesRings,
        radiusInner=radiusCage - 0.5 * heightCage,
    )
    return {"innerRingGraphics": rings["inner"], "outerRingGraphics": rings["outer"], "cageGraphics": cage}
