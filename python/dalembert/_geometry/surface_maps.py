"""Maps of a rectangle to surfaces, for meshes of shells."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import as_vector, shape_error, unit_vector
from dalembert._core import symbolic

__all__ = ["SurfaceMap"]

Map = Callable[[Any, Any], list[Any]]


def _positive(**values: float) -> None:
    for name, value in values.items():
        if not np.isfinite(value) or value <= 0:
            raise shape_error(f"SurfaceMap: {name}", "a positive number", value)


def _one_of(name: str, value: str, known: Sequence[str]) -> None:
    if value not in known:
        raise shape_error(f"SurfaceMap: {name}", " or ".join(map(repr, known)), value)


class SurfaceMap:
    """Functions f(x, y) that return [X, Y, Z], as ShellMesh(surfaceMap=...) needs them.

    x runs from 0 to Lx and y from 0 to Ly, so the vertices of the mesh are those of this rectangle.
    """

    @staticmethod
    def SkewParallelogram(skewY: float = 0.0, skewX: float = 0.0) -> Map:
        """Shear the rectangle: skewY*y is added to x, skewX*x to y."""
        return lambda x, y: [x + skewY * y, y + skewX * x, 0.0]

    @staticmethod
    def Trapezoid(Lx: float, Ly: float, topScale: float = 1.0, aboutMidline: bool = True) -> Map:
        """Scale widths linearly from 1 at y=0 to topScale at y=Ly, about x=Lx/2 or, aboutMidline=False, about x=0."""
        _positive(Lx=Lx, Ly=Ly)
        fixed = Lx / 2 if aboutMidline else 0.0
        return lambda x, y: [fixed + (1 + (topScale - 1) * y / Ly) * (x - fixed), y, 0.0]

    @staticmethod
    def CurvedEdge(
        Lx: float, Ly: float, amp: float = 0.0, mode: str = "top", shape: str = "sin", aboutMidline: bool = True
    ) -> Map:
        """Move points along x by amp times a wave over x ('sin': half a sine, or 'parabola'), growing towards an edge.

        mode: that edge, 'top' or 'bottom'; aboutMidline: amp/pi is subtracted there.
        """
        _positive(Lx=Lx, Ly=Ly)
        _one_of("mode", mode, ("top", "bottom"))
        _one_of("shape", shape, ("sin", "parabola"))
        level = 1 / math.pi if aboutMidline else 0.0

        def curved(x: Any, y: Any) -> list[Any]:
            share = y / Ly if mode == "top" else 1 - y / Ly
            wave = symbolic.sin(math.pi / Lx * x) if shape == "sin" else 4 / Lx**2 * x * (Lx - x)
            return [x + amp * share * (wave - level), y, 0.0]

        return curved

    @staticmethod
    def OutOfPlaneWarp(Lx: float, Ly: float, amp: float = 0.0) -> Map:
        """Bend the rectangle to amp*sin(pi*x/Lx)*sin(pi*y/Ly) along z."""
        _positive(Lx=Lx, Ly=Ly)
        return lambda x, y: [x, y, amp * symbolic.sin(math.pi / Lx * x) * symbolic.sin(math.pi / Ly * y)]

    @staticmethod
    def BezierStrip(
        P0: npt.ArrayLike,
        P1: npt.ArrayLike,
        P2: npt.ArrayLike,
        P3: npt.ArrayLike,
        Lx: float,
        Ly: float,
        up: npt.ArrayLike = (0, 0, 1),
        useArcLength: bool = True,
        nArc: int = 400,
    ) -> Map:
        """Lay the strip along a cubic Bezier curve, its width along the cross product of `up` and the tangent.

        useArcLength: equal distances along x are equal lengths of the curve, found by nArc points of it.
        """
        _positive(Lx=Lx, Ly=Ly)
        points = np.array([as_vector("SurfaceMap: P0 to P3", P, 3) for P in (P0, P1, P2, P3)])
        upwards = unit_vector("SurfaceMap: up", up)
        sides = 3 * np.diff(points, axis=0)

        def tangent(t: Any) -> Any:
            return (
                np.multiply.outer((1 - t) ** 2, sides[0])
                + np.multiply.outer(2 * t * (1 - t), sides[1])
                + (np.multiply.outer(t**2, sides[2]))
            )

        places = np.linspace(0.0, 1.0, max(int(nArc), 2))
        speed = np.linalg.norm(tangent(places), axis=1)
        lengths = np.concatenate([[0.0], np.cumsum(np.diff(places) * (speed[1:] + speed[:-1]) / 2)])
        if not lengths[-1] > 0:
            raise ValueError("SurfaceMap: BezierStrip: the curve of P0 to P3 has no length")

        def strip(x: Any, y: Any) -> list[float]:
            t = float(np.interp(float(x) / Lx * lengths[-1], lengths, places)) if useArcLength else float(x) / Lx
            weights = [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t**2 * (1 - t), t**3]
            across = np.cross(upwards, tangent(t))
            if not np.linalg.norm(across) > 1e-12 * lengths[-1]:
                raise ValueError(
                    f"SurfaceMap: BezierStrip: at x={float(x):g}, the curve is parallel to `up` or stands still"
                )
            moved = weights @ points + (float(y) - Ly / 2) * across / np.linalg.norm(across)
            return [float(value) for value in moved]

        return strip

    @staticmethod
    def ConeFrustum(
        Lx: float,
        Ly: float,
        r0: float,
        r1: float,
        phiDeg: float = 20.0,
        thetaCenterDeg: float = 0.0,
        centered: bool = True,
        yMode: str = "arclength",
    ) -> Map:
        """Roll the rectangle to a part of a cone about the x-axis, with radii r0 at x=0 and r1 at x=Lx.

        yMode: 'arclength', y is a length around the axis; 'angle', y=Ly is the angle phiDeg in degrees. The angle
        thetaCenterDeg is that of the middle, or, with centered=False, that of y=0.
        """
        _positive(Lx=Lx, Ly=Ly, r0=r0, r1=r1)
        _one_of("yMode", yMode, ("arclength", "angle"))
        if yMode == "angle" and phiDeg == 0:
            raise shape_error("SurfaceMap: phiDeg", "an angle that is not zero (degrees)", phiDeg)
        start, middle = math.radians(thetaCenterDeg), Ly / 2 if centered else 0.0

        def cone(x: Any, y: Any) -> list[Any]:
            radius = r0 + (r1 - r0) / Lx * x
            angle = start + (
                (y - middle) / radius if yMode == "arclength" else math.radians(phiDeg) / Ly * (y - middle)
            )
            return [x, radius * symbolic.cos(angle), radius * symbolic.sin(angle)]

        return cone

    @staticmethod
    def Cylinder(
        Lx: float,
        Ly: float,
        R: float,
        phiDeg: float = 90.0,
        thetaCenterDeg: float = 0.0,
        centered: bool = False,
        yMode: str = "arclength",
    ) -> Map:
        """Roll the rectangle to a part of a cylinder about the x-axis: ConeFrustum with two equal radii."""
        return SurfaceMap.ConeFrustum(Lx, Ly, R, R, phiDeg, thetaCenterDeg, centered, yMode)

    @staticmethod
    def HemisphericalShell(
        Lx: float,
        Ly: float,
        R: float,
        alpha: float,
        center: npt.ArrayLike = (0.0, 0.0, 0.0),
        thetaOffset: float = 0.0,
        thetaRange: float | None = None,
    ) -> Map:
        """Map to a hemisphere: x to the angle about z, of thetaRange (2 pi) from thetaOffset; y to the angle from z.

        The latter runs from alpha, the edge of a hole at the pole, to pi/2; all angles in rad.
        """
        _positive(Lx=Lx, Ly=Ly, R=R)
        if not 0 <= alpha < math.pi / 2:
            raise shape_error("SurfaceMap: alpha", "an angle from 0 to less than pi/2 (rad)", alpha)
        middle = as_vector("SurfaceMap: center", center, 3).tolist()
        around = 2 * math.pi if thetaRange is None else thetaRange

        def sphere(x: Any, y: Any) -> list[Any]:
            theta, phi = thetaOffset + around / Lx * x, alpha + (math.pi / 2 - alpha) / Ly * y
            distance = R * symbolic.sin(phi)
            return [
                middle[0] + distance * symbolic.cos(theta),
                middle[1] + distance * symbolic.sin(theta),
                middle[2] + R * symbolic.cos(phi),
            ]

        return sphere

    @staticmethod
    def ToroidalPanel(Lx: float, Ly: float, r1: float = 1.5, r2: float = 0.5) -> Map:
        """Map to the outer half of a quarter of a torus of radii r1 and r2 about the z-axis.

        x: from -90 to 90 degrees around the tube; y: from 0 to -90 degrees about z.
        """
        _positive(Lx=Lx, Ly=Ly, r1=r1, r2=r2)

        def torus(x: Any, y: Any) -> list[Any]:
            tube, around = math.pi * (x / Lx - 0.5), math.pi / 2 * (y / Ly)
            distance = r1 + r2 * symbolic.cos(tube)
            return [distance * symbolic.cos(around), -distance * symbolic.sin(around), r2 * symbolic.sin(tube)]

        return torus
