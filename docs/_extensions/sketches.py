"""Elements of technical sketches, drawn with matplotlib: bodies, springs, joints, frames, dimensions."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure
from matplotlib.patches import Arc, Circle, FancyArrowPatch, Polygon

EDGE, FILL, SECOND, RED, GREY = "#2b4c6f", "#dfe8f2", "#f5e3c8", "#b03a2e", "#555555"
STYLE = {"svg.hashsalt": "dalembert", "svg.fonttype": "path", "font.size": 11, "mathtext.fontset": "cm"}


def save(figure: Figure, path: Path) -> None:
    """Write an SVG file that is the same for the same drawing."""
    path.parent.mkdir(parents=True, exist_ok=True)
    FigureCanvasSVG(figure)
    figure.savefig(path, metadata={"Date": None}, facecolor="white")


@contextmanager
def styled() -> Iterator[None]:
    with matplotlib.rc_context(STYLE):
        yield


class Sketch:
    """A drawing in the plane with equal scales and without axes; lengths are those of the drawing."""

    def __init__(self, width: float, height: float) -> None:
        self.figure = Figure(figsize=(0.48 * width, 0.48 * height))
        self.ax: Any = self.figure.add_axes((0, 0, 1, 1))
        self.ax.set(xlim=(0, width), ylim=(0, height), aspect="equal")
        self.ax.axis("off")

    def text(self, p: Any, words: str, color: str = "black", **options: Any) -> None:
        self.ax.text(*p, words, ha="center", va="center", color=color, **options)

    def line(self, points: Any, color: str = EDGE, width: float = 1.5, style: str = "-", **options: Any) -> None:
        self.ax.plot(*np.transpose(points), color=color, lw=width, ls=style, solid_capstyle="round", **options)

    def body(self, points: Any, color: str = FILL) -> None:
        self.ax.add_patch(Polygon(points, closed=True, fc=color, ec=EDGE, lw=1.5, joinstyle="round"))

    def blob(self, center: Any, a: float, b: float, color: str = FILL, angle: float = 0, wave: float = 0.08) -> None:
        """A body of any shape."""
        t = np.linspace(0, 2 * np.pi, 120)
        r = 1 + wave * np.cos(3 * t + 0.5) + 0.5 * wave * np.sin(2 * t)
        c, s = np.cos(angle), np.sin(angle)
        x, y = a * r * np.cos(t), b * r * np.sin(t)
        self.body(np.column_stack([center[0] + c * x - s * y, center[1] + s * x + c * y]), color)

    def circle(self, center: Any, radius: float, color: str = FILL, edge: str = EDGE, **options: Any) -> None:
        self.ax.add_patch(Circle(center, radius, fc=color, ec=edge, lw=1.5, **options))

    def ground(self, p: Any, width: float = 1.6, angle: float = 0) -> None:
        """A hatched line in the middle of which p is; at angle 0, the ground is below it."""
        along, down = np.array([np.cos(angle), np.sin(angle)]), np.array([np.sin(angle), -np.cos(angle)])
        self.line([p - width / 2 * along, p + width / 2 * along], "black", 1.5)
        for s in np.linspace(-width / 2, width / 2 - 0.2, round(width / 0.2)):
            start = p + (s + 0.2) * along
            self.line([start, start - 0.2 * along + 0.2 * down], "black", 0.8)

    def marker(self, p: Any, name: str = "", offset: Any = (0, 0.4)) -> None:
        self.circle(p, 0.1, RED, RED, zorder=5)
        if name:
            self.text(np.add(p, offset), f"${name}$", RED)

    def arrow(
        self, p: Any, q: Any, name: str = "", offset: Any = (0, 0.3), color: str = "black", head: str = "-|>"
    ) -> None:
        style = {"arrowstyle": head, "mutation_scale": 12, "color": color, "lw": 1.4, "shrinkA": 0, "shrinkB": 0}
        self.ax.add_patch(FancyArrowPatch(p, q, zorder=6, **style))
        if name:
            self.text(np.add(np.mean([p, q], axis=0), offset), f"${name}$", color)

    def dimension(self, p: Any, q: Any, name: str, shift: Any = (0, 0), offset: Any = (0, 0.28)) -> None:
        """A length between two points, with extension lines up to the shifted arrow."""
        p, q, shift = np.array(p, float), np.array(q, float), np.array(shift, float)
        if np.any(shift):
            for end in (p, q):
                self.line([end, end + 1.15 * shift], GREY, 0.6)
        self.arrow(p + shift, q + shift, name, offset, GREY, "<|-|>")

    def frame(
        self, p: Any, angle: float, names: tuple[str, str] = ("x", "y"), size: float = 1.0, out: str = ""
    ) -> None:
        """Two axes in the plane, and the name of one that points to the reader."""
        p = np.array(p, float)
        for k, name in enumerate(names):
            d = np.array([np.cos(angle + k * np.pi / 2), np.sin(angle + k * np.pi / 2)])
            self.arrow(p, p + size * d, color=GREY)
            self.text(p + (size + 0.28) * d, f"${name}$", GREY, fontsize=10)
        if out:
            self.circle(p, 0.13, "white", GREY, zorder=6)
            self.circle(p, 0.04, GREY, GREY, zorder=7)
            d = np.array([np.cos(angle - 2.3), np.sin(angle - 2.3)])
            self.text(p + 0.42 * d, f"${out}$", GREY, fontsize=10)

    def angle(self, center: Any, radius: float, start: float, end: float, name: str = "", color: str = "black") -> None:
        """An arc with an arrow, from an angle to another one in degrees."""
        self.ax.add_patch(Arc(center, 2 * radius, 2 * radius, theta1=start, theta2=end, color=color, lw=1.3))
        e = np.radians(end)
        tip = np.add(center, radius * np.array([np.cos(e), np.sin(e)]))
        back = tip - 0.12 * np.array([-np.sin(e), np.cos(e)])
        self.arrow(back, tip + 0.06 * np.array([-np.sin(e), np.cos(e)]), color=color)
        if name:
            m = np.radians((start + end) / 2)
            self.text(np.add(center, (radius + 0.35) * np.array([np.cos(m), np.sin(m)])), f"${name}$", color)

    def spring(self, p: Any, q: Any, name: str = "", width: float = 0.25, offset: float = 0.5) -> None:
        p, q = np.array(p, float), np.array(q, float)
        length = np.linalg.norm(q - p)
        t = (q - p) / length
        n = np.array([-t[1], t[0]])
        lead = 0.18 * length
        inner = [p + (lead + (length - 2 * lead) * (k + 0.5) / 9) * t + width * (-1) ** k * n for k in range(9)]
        self.line([p, p + lead * t, *inner, q - lead * t, q], "black", 1.3)
        if name:
            self.text((p + q) / 2 + offset * n, f"${name}$")

    def damper(self, p: Any, q: Any, name: str = "", width: float = 0.2, offset: float = -0.5) -> None:
        p, q = np.array(p, float), np.array(q, float)
        length = np.linalg.norm(q - p)
        t = (q - p) / length
        n = np.array([-t[1], t[0]])
        a, b = p + 0.4 * length * t, p + 0.65 * length * t
        self.line([p, a], "black", 1.3)
        self.line([b + width * n, a + width * n, a - width * n, b - width * n], "black", 1.3)
        piston = p + 0.53 * length * t
        self.line([piston + 0.8 * width * n, piston - 0.8 * width * n], "black", 1.3)
        self.line([piston, q], "black", 1.3)
        if name:
            self.text((p + q) / 2 + offset * n, f"${name}$")

    def spring_damper(self, p: Any, q: Any, spring: str = "k", damper: str = "d", apart: float = 0.32) -> None:
        """A spring and a damper side by side, with bars at both ends."""
        p, q = np.array(p, float), np.array(q, float)
        length = np.linalg.norm(q - p)
        t = (q - p) / length
        n = np.array([-t[1], t[0]])
        a, b = p + 0.12 * length * t, q - 0.12 * length * t
        for end, bar in ((p, a), (q, b)):
            self.line([end, bar], "black", 1.3)
            self.line([bar + apart * n, bar - apart * n], "black", 1.3)
        self.spring(a + apart * n, b + apart * n, spring, 0.18, 0.42)
        self.damper(a - apart * n, b - apart * n, damper, 0.16, -0.42)
