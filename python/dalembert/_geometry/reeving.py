"""Reeving curves: a belt or rope around circles, as tangent lines and arcs, with nodes at equal distances."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import asin, atan2, cos, pi, sin
from typing import Any, NamedTuple

import numpy as np

from dalembert._checks import FloatArray, shape_error
from dalembert._core import Print


class _Circle(NamedTuple):
    center: FloatArray
    radius: float
    side: str  # 'L': the curve passes on the left of the centre, 'R': on the right

    @property
    def sign(self) -> int:
        return -1 if self.side == "R" else 1


def _circles(circleList: Sequence[Any], radialOffset: float, closedCurve: bool) -> list[_Circle]:
    circles = []
    for i, (center, radius, side) in enumerate(circleList):
        if radius <= 0:
            raise shape_error(f"CreateReevingCurve: circleList[{i}] radius", "a positive number", radius)
        circles.append(_Circle(np.array(center[:2], dtype=float), radius + radialOffset, side))
    return circles + circles[:2] if closedCurve else circles


def _tangent(start: _Circle, end: _Circle) -> tuple[FloatArray, FloatArray]:
    """Return the ends of the line that leaves one circle and arrives at the next, on their sides."""
    line = end.center - start.center
    distance = float(np.linalg.norm(line))
    if distance == 0:
        raise shape_error("CreateReevingCurve: circleList", "neighbours with different centres", start.center)
    along = line / distance
    normal = np.array([-along[1], along[0]])
    angle = asin((end.sign * end.radius - start.sign * start.radius) / distance)
    first, second = (
        circle.center + circle.sign * circle.radius * (cos(angle) * normal - sin(angle) * along)
        for circle in (start, end)
    )
    return first, second


def _arc(circle: _Circle, start: FloatArray, end: FloatArray) -> dict[str, Any]:
    """Return the arc on a circle between two of its points, clockwise on the left side."""
    angles = [atan2(*reversed((point - circle.center).tolist())) - circle.sign * 0.5 * pi for point in (start, end)]
    turn = angles[1] - angles[0]
    if turn < 0 and circle.side == "R":
        turn += 2 * pi
    if turn > 0 and circle.side == "L":
        turn -= 2 * pi
    return {
        "type": "ARC",
        "point0": start,
        "radius": circle.radius,
        "startAngle": angles[0],
        "endAngle": angles[1],
        "arcAngle": turn,
    }


def _segments(circles: list[_Circle], removeFirstLine: bool, removeLastLine: bool) -> Iterator[dict[str, Any]]:
    """Give lines and arcs in the order in which the curve runs through them."""
    arrival: FloatArray | None = None
    for i, (start, end) in enumerate(pairwise(circles), 1):
        p0, p1 = _tangent(start, end)
        if arrival is not None:
            yield _arc(start, arrival, p0)
        if not (removeFirstLine and i == 1) and not (removeLastLine and i == len(circles) - 1):
            if not np.any(p1 != p0):
                Print("WARNING: CreateReevingCurve: a line has no length, check the circles")
            yield {"type": "LINE", "point0": p0, "point1": p1}
        arrival = p1


def _length(segment: dict[str, Any]) -> float:
    if segment["type"] == "LINE":
        return float(np.linalg.norm(segment["point1"] - segment["point0"]))
    return float(abs(segment["radius"] * segment["arcAngle"]))


def _curvature(segment: dict[str, Any]) -> float:
    return 0.0 if segment["type"] == "LINE" else float(np.copysign(1 / segment["radius"], segment["arcAngle"]))


def _point_and_slope(segment: dict[str, Any], fraction: float) -> FloatArray:
    """Return [x, y, x', y'] at a fraction of a segment."""
    p0 = segment["point0"]
    if segment["type"] == "LINE":
        line = segment["point1"] - p0
        return np.concatenate([p0 + fraction * line, line / np.linalg.norm(line)])
    signed = np.copysign(segment["radius"], segment["arcAngle"])
    start = segment["startAngle"]
    angle = start + fraction * segment["arcAngle"]
    center = p0 + signed * np.array([-sin(start), cos(start)])
    return np.array([center[0] + signed * sin(angle), center[1] - signed * cos(angle), cos(angle), sin(angle)])


def _drawing(segments: list[dict[str, Any]], perCircle: int) -> list[float]:
    """Return the curve as points x, y, 0 one after the other."""
    data: list[float] = []
    for segment in segments:
        if segment["type"] == "LINE":
            fractions = [0.0, 1.0]
        else:
            parts = int(abs(segment["arcAngle"]) * perCircle / (2 * pi)) + 1
            fractions = [(i + 1) / parts for i in range(parts)]
        for fraction in fractions:
            data += [*_point_and_slope(segment, fraction)[:2].tolist(), 0]
    return data


def CreateReevingCurve(
    circleList: Sequence[Any],
    drawingLinesPerCircle: int = 64,
    numberOfANCFnodes: int = -1,
    removeLastLine: bool = False,
    removeFirstLine: bool = False,
    radialOffset: float = 0.0,
    closedCurve: bool = False,
    graphicsElementsPerCircle: int = 64,
    graphicsNodeSize: float = 0,
    colorCircles: Sequence[float] = [0.0, 0.5, 1.0, 1.0],
    colorLines: Sequence[float] = [1.0, 0.5, 0.0, 1.0],
) -> dict[str, Any]:
    """Lead a belt or rope around circles [centre, radius, side 'L' or 'R'] and place nodes at equal distances.

    Lengths in m; radialOffset enlarges all circles. The dict has ancfPointsSlopes (rows x, y, x', y'), elementLengths,
    elementCurvatures, totalLength, circleData (lines and arcs), lineData, graphicsDataLines and graphicsDataCircles.
    numberOfANCFnodes=-1 places no nodes.
    """
    if numberOfANCFnodes != -1 and numberOfANCFnodes < 2:
        raise shape_error("CreateReevingCurve: numberOfANCFnodes", "-1 (no nodes) or at least 2", numberOfANCFnodes)
    circles = _circles(circleList, radialOffset, closedCurve)
    segments = list(_segments(circles, removeFirstLine and not closedCurve, removeLastLine or closedCurve))
    total = sum(_length(segment) for segment in segments)

    nodes: list[list[float]] = []
    lengths: list[float] = []
    curvatures: list[float] = []
    if numberOfANCFnodes != -1:
        step = total / (numberOfANCFnodes - (0 if closedCurve else 1))
        reached = 0.0  # arc length at the start of the segment
        for segment in segments:
            end = reached + _length(segment)
            while len(nodes) * step <= end * (1 + 1e-10):
                if nodes:
                    lengths.append(step)
                    curvatures.append(_curvature(segment))
                fraction = (len(nodes) * step - reached) / _length(segment)
                nodes.append(_point_and_slope(segment, fraction).tolist())
            reached = end

    line = _drawing(segments, graphicsElementsPerCircle)
    graphics: list[dict[str, Any]] = [{"type": "Line", "color": colorLines, "data": line}]
    if graphicsNodeSize != 0:
        size = {"type": "Circle", "color": colorLines, "radius": graphicsNodeSize}
        graphics += [size | {"position": [x, y, 0]} for x, y, _, _ in nodes]
    disc = {"type": "Circle", "color": colorCircles}
    return {
        "ancfPointsSlopes": nodes,
        "elementLengths": lengths,
        "elementCurvatures": curvatures,
        "totalLength": total,
        "circleData": segments,
        "lineData": line,
        "graphicsDataLines": graphics,
        "graphicsDataCircles": [disc | {"position": [*c.center.tolist(), 0], "radius": c.radius} for c in circles],
    }
