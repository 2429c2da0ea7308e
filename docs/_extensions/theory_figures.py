"""Figures of the theory pages, computed and drawn when pages are built, below docs/_generated/figures."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from scipy.integrate import solve_bvp
from scipy.optimize import brentq
from sketches import GREY, RED, SECOND, Sketch, save, styled

FOLDER = Path(__file__).parents[1] / "_generated/figures"
COLORS = ("#2b4c6f", "#b03a2e", "#3a7d44", "#b8860b", "#6a4c93")


def axes(count: int = 1, width: float = 5.4, height: float = 2.9) -> tuple[Figure, Any]:
    figure = Figure(figsize=(width, height), layout="constrained")
    return figure, figure.subplots(1, count)


def equations_of_motion() -> Figure:
    s = Sketch(13, 5.6)
    s.blob((3, 2.6), 2.0, 1.3, angle=0.3)
    s.blob((10, 2.7), 2.0, 1.4, SECOND, angle=-0.2)
    s.frame((2.3, 2.2), 0.35, ("x_b", "y_b"), 0.9)
    s.frame((10.4, 2.6), -0.3, ("x_b", "y_b"), 0.9)
    p, q = (4.5, 3.1), (8.5, 3.2)
    s.spring_damper(p, q)
    s.marker(p, "m_0", (-0.1, 0.45))
    s.marker(q, "m_1", (0.1, 0.45))
    s.arrow((4.6, 2.4), (5.7, 2.42), r"\mathbf{F}", (0, -0.35), RED)
    s.arrow((8.4, 2.45), (7.3, 2.43), r"-\mathbf{F}", (0, -0.35), RED)
    s.text((3, 0.65), r"$\mathbf{Q}_0 = \mathbf{J}_{m0}^T\, \mathbf{F}$")
    s.text((10, 0.65), r"$\mathbf{Q}_1 = -\mathbf{J}_{m1}^T\, \mathbf{F}$")
    s.text(
        (6.5, 5.1), r"connector: $\mathbf{F}(\mathbf{p}_{m1} - \mathbf{p}_{m0},\ \mathbf{v}_{m1} - \mathbf{v}_{m0})$"
    )
    return s.figure


def index_reduction() -> Figure:
    """A mass of 1 kg on a rod of 1 m that turns over, by the midpoint rule with constraints of accelerations."""
    weight, h, end = np.array([0, -9.81]), 5e-3, 10

    def acceleration(q: Any, v: Any) -> Any:
        return weight - (q @ weight + v @ v) / (q @ q) * q

    figure, ax = axes()
    levels = ("accelerations (index 1)", "velocities (index 2)", "positions and velocities")
    for level, name in enumerate(levels):
        q, v, violations = np.array([1.0, 0.0]), np.array([0.0, -6.0]), []
        for _ in range(round(end / h)):
            qm, vm = q + h / 2 * v, v + h / 2 * acceleration(q, v)
            q, v = q + h * vm, v + h * acceleration(qm, vm)
            if level == 2:
                q /= np.linalg.norm(q)
            if level:
                v -= (q @ v) / (q @ q) * q
            violations.append(abs(np.linalg.norm(q) - 1))
        time = h * np.arange(1, len(violations) + 1)
        ax.semilogy(time, np.maximum(violations, 1e-16), color=COLORS[level], lw=1.3, label=name)
    ax.set(xlabel="time (s)", ylabel="constraint violation (m)", ylim=(3e-17, 1))
    ax.legend(fontsize=9, loc="center right")
    return figure


def generalized_alpha() -> Figure:
    """Eigenvalues of the map of (q, h v, h^2 a) for a'' = -w^2 q."""
    figure, ax = axes()
    x = np.logspace(-2, 3, 300)
    for color, rho in zip(COLORS, (1.0, 0.9, 0.6, 0.0), strict=False):
        alpha_m, alpha_f = (2 * rho - 1) / (rho + 1), rho / (rho + 1)
        gamma = 0.5 + alpha_f - alpha_m
        beta = 0.25 * (gamma + 0.5) ** 2
        radius = []
        for w in x**2:
            new = np.array([[1, 0, -beta], [0, 1, -gamma], [(1 - alpha_f) * w, 0, 1 - alpha_m]])
            old = np.array([[1, 1, 0.5 - beta], [0, 1, 1 - gamma], [-alpha_f * w, 0, -alpha_m]])
            radius.append(np.abs(np.linalg.eigvals(np.linalg.solve(new, old))).max())
        ax.semilogx(x, radius, color=color, label=f"spectralRadius = {rho:g}")
    ax.set(xlabel=r"$h\, \omega$", ylabel="amplification per step", ylim=(-0.03, 1.06))
    ax.legend(fontsize=9)
    return figure


def constraints() -> Figure:
    figure, ax = axes(width=4.6, height=3.2)
    ax.plot([-0.5, 1.5], [1.5, -0.5], color=COLORS[0], label="reactions in equilibrium")
    ax.annotate("", (0.5, 0.5), (0, 0), arrowprops={"arrowstyle": "-|>", "color": RED, "lw": 1.5})
    ax.plot(0.5, 0.5, "o", color=RED, label="minimum norm")
    ax.annotate("", (1.15, -0.15), (0.8, 0.2), arrowprops={"arrowstyle": "-|>", "color": GREY, "lw": 1.5})
    ax.text(1.12, 0.1, r"null space $\mathbf{z} = (1, -1)$", color=GREY, fontsize=10)
    ax.axhline(0, color="black", lw=0.6)
    ax.axvline(0, color="black", lw=0.6)
    ax.set(
        xlabel=r"$\lambda_1 / F$ (lower hinge)",
        ylabel=r"$\lambda_2 / F$ (upper hinge)",
        aspect="equal",
        xlim=(-0.5, 2.1),
    )
    ax.legend(fontsize=9, loc="upper right")
    return figure


def rotations() -> Figure:
    """Singular values of the velocity transformations: angles x, y, z; Euler parameters; increments on the group."""
    figure, ax = axes()
    degrees = np.linspace(-180, 180, 721)
    conditions = []
    for angle in np.radians(degrees):
        s, c = np.sin(angle), np.cos(angle)
        columns = np.array([[1, 0, s], [0, 1, 0], [0, 0, c]])  # axes of the three rotations, after the first one
        conditions.append(np.linalg.cond(columns))
    ax.semilogy(degrees, np.minimum(conditions, 1e4), color=COLORS[1], label="Tait-Bryan angles")
    ax.semilogy(degrees, np.ones_like(degrees), color=COLORS[0], label="Euler parameters, Lie group")
    ax.set(xlabel="second angle (degrees)", ylabel="condition number", xticks=range(-180, 181, 90), ylim=(0.7, 1e3))
    ax.legend(fontsize=9, loc="center")
    return figure


def beams() -> Figure:
    """EI theta'' = -F cos(theta) with theta(0) = 0 and theta'(L) = 0."""
    figure, ax = axes(width=5.0, height=3.4)
    s, guess = np.linspace(0, 1, 60), np.zeros((2, 60))
    for color, force in zip(COLORS, (0, 1, 2, 4, 8), strict=True):
        found = solve_bvp(
            lambda s, y, f=force: np.vstack([y[1], -f * np.cos(y[0])]), lambda a, b: np.array([a[0], b[1]]), s, guess
        )
        t = np.linspace(0, 1, 200)
        angle = found.sol(t)[0]
        x, y = (np.append(0, np.cumsum(np.diff(t) * (f[1:] + f[:-1]) / 2)) for f in (np.cos(angle), np.sin(angle)))
        ax.plot(x, -y, color=color, lw=1.8, label=f"{force}")
        if force in (1, 2):
            ax.plot(t, -force * (t**2 / 2 - t**3 / 6), "--", color=color, lw=1)
        guess = found.sol(s)
    ax.set(xlabel="$x / L$", ylabel="$y / L$", aspect="equal")
    ax.legend(title="$F L^2 / EI$", fontsize=9)
    return figure


def ffrf() -> Figure:
    figure, (left, right) = axes(2, 6.4, 2.6)
    x = np.linspace(0, 1, 200)
    left.plot(x, 3 * x**2 - 2 * x**3, color=COLORS[0], label="unit displacement")
    left.plot(x, x**3 - x**2, color=COLORS[1], label="unit rotation")
    left.set(title="static modes", xlabel="$x / L$")
    for color, start in zip(COLORS, (4.7, 7.9, 11.0), strict=False):
        k = brentq(lambda k: np.cos(k) * np.cosh(k) - 1, start - 0.2, start + 0.2)
        ratio = (np.cosh(k) - np.cos(k)) / (np.sinh(k) - np.sin(k))
        shape = np.cosh(k * x) - np.cos(k * x) - ratio * (np.sinh(k * x) - np.sin(k * x))
        right.plot(x, shape / np.abs(shape).max(), color=color)
    right.set(title="eigenmodes, interfaces fixed", xlabel="$x / L$")
    left.legend(fontsize=8)
    return figure


def contact() -> Figure:
    figure, (left, right) = axes(2, 6.8, 2.8)
    stiffness, mass, speed, h = 1e4, 1.0, 1.0, 1e-5

    def impact(law: Any) -> Any:
        """Penetrations, forces and velocities until the bodies separate."""
        x, v, rows = 0.0, speed, []
        while x >= 0:
            force = max(0.0, law(x, v))
            rows.append((x, force, v))
            v -= h * force / mass
            x += h * v
        return np.array([*rows, (0.0, 0.0, v)])

    damped = {
        "linear damper": lambda d: lambda x, v: stiffness * x + 100 * d * v,
        "Hunt and Crossley": lambda d: lambda x, v: stiffness * x * (1 + d * v),
    }
    for color, (name, family) in zip(COLORS, damped.items(), strict=False):
        factor = brentq(lambda d, family=family: -impact(family(d))[-1, 2] - 0.5 * speed, 0.1, 5, xtol=1e-3)
        rows = impact(family(factor))[::10]
        left.plot(1e3 * rows[:, 0], rows[:, 1], color=color, label=name)
    left.set(xlabel=r"penetration $\delta$ (mm)", ylabel="normal force (N)")
    left.legend(fontsize=8)
    v = np.linspace(-3, 3, 400)
    right.plot(v, np.clip(v, -1, 1), color=COLORS[0], label="regularized")
    right.plot([-3, 0, 0, 3], [-1, -1, 1, 1], "--", color=COLORS[1], label="bristle at rest")
    right.set(xlabel="$v_t / v_{reg}$", ylabel=r"$f_t / (\mu f_n)$")
    right.legend(fontsize=8)
    return figure


FIGURES = (equations_of_motion, index_reduction, generalized_alpha, constraints, rotations, beams, ffrf, contact)


def draw_figures() -> None:
    """Draw all figures, unless they are newer than this file."""
    source = max(Path(__file__).with_name(name).stat().st_mtime for name in ("theory_figures.py", "sketches.py"))
    for function in FIGURES:
        path = FOLDER / f"{function.__name__}.svg"
        if path.exists() and path.stat().st_mtime > source:
            continue
        with styled():
            save(function(), path)
