"""Outlines of cross sections in the plane of y and z: closed loops of points, some of them circles."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from dalembert._calls import checked
from dalembert._checks import FloatArray, as_points, shape_error


@dataclass(frozen=True)
class Loop:
    """Points of a closed polygon, not repeated; `circle` is (y, z, radius) of the circle that they lie on, if any."""

    points: FloatArray
    circle: tuple[float, float, float] | None = None

    @property
    def signed_area(self) -> float:
        """Area, positive if the points run counter-clockwise (from y to z)."""
        y, z = self.points.T
        return float(0.5 * np.sum(y * np.roll(z, -1) - np.roll(y, -1) * z))


@dataclass(frozen=True)
class SectionOutline:
    """A cross section: the first loop is its outer boundary, others are holes."""

    loops: tuple[Loop, ...]

    def contains(self, points: FloatArray) -> npt.NDArray[np.bool_]:
        """Return a mask of the points inside."""
        from matplotlib.path import Path  # here, as all models import this file and few need sections

        inside = np.zeros(len(points), dtype=bool)
        for loop in self.loops:
            inside ^= Path(loop.points).contains_points(points)
        return inside


def _positive(function: str, **lengths: float) -> None:
    for name, value in lengths.items():
        if not np.isfinite(value) or value <= 0:
            raise shape_error(f"{function}: {name}", "a positive length (m)", value)


def _circle(radius: float, corners: int) -> Loop:
    angles = 2 * np.pi * np.arange(corners) / corners
    return Loop(radius * np.stack([np.cos(angles), np.sin(angles)], axis=1), (0.0, 0.0, radius))


@checked
def SectionPolygon(points: npt.ArrayLike, holes: Sequence[npt.ArrayLike] = ()) -> SectionOutline:
    """A section with corners [y, z] (m) in order, and holes, whose corners are given in the same way."""
    loops = []
    for i, given in enumerate((points, *holes)):
        name = f"SectionPolygon: {'points' if i == 0 else f'holes[{i - 1}]'}"
        corners = as_points(name, given, 2)
        if len(corners) > 1 and (corners[0] == corners[-1]).all():
            corners = corners[:-1]
        loop = Loop(corners)
        if len(corners) < 3 or not np.isfinite(corners).all() or loop.signed_area == 0:
            raise shape_error(name, "at least 3 corners that enclose an area", given)
        if (np.linalg.norm(corners - np.roll(corners, 1, axis=0), axis=1) == 0).any():
            raise shape_error(name, "corners without repetition", given)
        forward = (loop.signed_area > 0) == (i == 0)
        loops.append(loop if forward else Loop(corners[::-1]))
    outline = SectionOutline(tuple(loops))
    outer = SectionOutline(outline.loops[:1])
    for i, loop in enumerate(outline.loops[1:]):
        if not outer.contains(loop.points).all():
            raise shape_error(f"SectionPolygon: holes[{i}]", "corners inside of the outer boundary", holes[i])
    return outline


@checked
def SectionRectangle(widthY: float, widthZ: float) -> SectionOutline:
    """A rectangle with its centre in the origin."""
    _positive("SectionRectangle", widthY=widthY, widthZ=widthZ)
    y, z = 0.5 * widthY, 0.5 * widthZ
    return SectionPolygon([[-y, -z], [y, -z], [y, z], [-y, z]])


@checked
def SectionCircle(radius: float) -> SectionOutline:
    """A circle with its centre in the origin."""
    _positive("SectionCircle", radius=radius)
    return SectionOutline((_circle(radius, 64),))


@checked
def SectionTube(outerRadius: float, innerRadius: float) -> SectionOutline:
    """A circular tube with its centre in the origin."""
    _positive("SectionTube", outerRadius=outerRadius, innerRadius=innerRadius)
    if innerRadius >= outerRadius:
        raise shape_error("SectionTube: innerRadius", f"a radius less than outerRadius={outerRadius:g}", innerRadius)
    corners = int(np.clip(24 * outerRadius / (outerRadius - innerRadius), 64, 1200))
    hole = _circle(innerRadius, corners)
    return SectionOutline((_circle(outerRadius, corners), Loop(hole.points[::-1], hole.circle)))


@checked
def SectionI(
    height: float, width: float, webThickness: float, flangeThickness: float, widthBottom: float | None = None
) -> SectionOutline:
    """A doubly or singly symmetric I profile with sharp corners; the web lies along z, its middle in the origin.

    width is that of the upper flange, widthBottom that of the lower one if it differs.
    """
    bottom = width if widthBottom is None else widthBottom
    lengths = {"height": height, "width": width, "webThickness": webThickness, "flangeThickness": flangeThickness}
    _positive("SectionI", **lengths, widthBottom=bottom)
    if 2 * flangeThickness >= height:
        raise shape_error("SectionI: flangeThickness", f"less than half of height={height:g}", flangeThickness)
    if webThickness >= min(width, bottom):
        raise shape_error("SectionI: webThickness", f"less than {min(width, bottom):g}, the width", webThickness)
    h, b, c, w, f = 0.5 * height, 0.5 * width, 0.5 * bottom, 0.5 * webThickness, 0.5 * height - flangeThickness
    right: list[list[float]] = [[c, -h], [c, -f], [w, -f], [w, f], [b, f], [b, h]]
    return SectionPolygon(np.vstack([right, np.array(right[::-1]) * [-1, 1]]))


@checked
def SectionL(height: float, width: float, webThickness: float, flangeThickness: float | None = None) -> SectionOutline:
    """An L profile with sharp corners: the outer corner in the origin, legs along y (width) and z (height)."""
    thickness = webThickness if flangeThickness is None else flangeThickness
    _positive("SectionL", height=height, width=width, webThickness=webThickness, flangeThickness=thickness)
    if webThickness >= width or thickness >= height:
        raise shape_error("SectionL: webThickness, flangeThickness", "less than the legs", (webThickness, thickness))
    t, s = webThickness, thickness
    return SectionPolygon(np.array([[0, 0], [width, 0], [width, s], [t, s], [t, height], [0, height]]))
