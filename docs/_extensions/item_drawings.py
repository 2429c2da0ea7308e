"""Annotated drawings for the pages of items: markers, frames and dimensions with the symbols of their equations."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
from sketches import EDGE, FILL, GREY, RED, SECOND, Sketch, save, styled

FOLDER = Path(__file__).parents[1] / "_generated/reference/items/drawings"


def two_bodies() -> Sketch:
    s = Sketch(9, 4.4)
    s.blob((1.5, 2.0), 1.3, 1.0, angle=0.4)
    s.blob((7.4, 2.2), 1.3, 1.0, SECOND, angle=-0.3)
    return s


def spring_damper() -> Sketch:
    s = two_bodies()
    p, q = (2.2, 2.3), (6.6, 2.5)
    s.spring_damper(p, q, "k", "d")
    s.marker(p, "m0", (-0.4, 0.3))
    s.marker(q, "m1", (0.4, 0.35))
    s.dimension(p, q, r"L = L_0 + \Delta L", (-0.05, 1.25))
    s.arrow((2.3, 1.35), (3.3, 1.4), "f_{SD}", (0, -0.35), RED)
    s.arrow((6.5, 1.55), (5.5, 1.5), "f_{SD}", (0, -0.35), RED)
    return s


def cartesian_spring_damper() -> Sketch:
    s = Sketch(9, 5.2)
    s.blob((1.8, 1.6), 1.3, 1.0, angle=0.4)
    s.blob((7.0, 3.8), 1.2, 0.9, SECOND, angle=-0.3)
    p, q = np.array([2.4, 1.8]), np.array([6.4, 3.7])
    corner = np.array([q[0], p[1]])
    s.spring(p, corner, "k_x", 0.2, -0.5)
    s.spring(corner, q, "k_y", 0.2, -0.5)
    s.marker(p, "m0", (-0.3, 0.4))
    s.marker(q, "m1", (0.4, 0.35))
    s.arrow(p, q, r"\Delta\mathbf{p}", (-0.3, 0.35), GREY)
    s.frame((0.6, 3.6), 0, ("x", "y"), 0.9, "z")
    s.text((1.7, 3.3), "global axes", GREY, fontsize=9)
    return s


def rigid_body_spring_damper() -> Sketch:
    s = two_bodies()
    p, q = np.array([2.2, 2.2]), np.array([6.6, 2.5])
    s.spring(p, q, r"\mathbf{K},\ \mathbf{D}", 0.22, -0.6)
    s.marker(p, "m0", (-0.4, -0.3))
    s.marker(q, "m1", (0.4, -0.3))
    s.frame(p, 0.15, ("x_{J0}", "y_{J0}"), 0.95)
    s.frame(q, 0.45, ("x_{J1}", "y_{J1}"), 0.95)
    s.arrow(p + [0, -1.0], q + [0, -1.3], r"\Delta\mathbf{p},\ \theta_0, \theta_1, \theta_2", (0, -0.4), GREY)
    return s


def torsional_spring_damper() -> Sketch:
    s = Sketch(8, 4.6)
    s.blob((2.0, 2.2), 1.6, 1.2, angle=0.2)
    s.body([(3.6, 1.9), (7.2, 3.0), (7.0, 3.6), (3.4, 2.5)], SECOND)
    c = np.array([3.5, 2.2])
    t = np.linspace(0, 3.6 * np.pi, 200)
    r = 0.18 + 0.05 * t
    s.line(np.column_stack([c[0] + r * np.cos(t), c[1] + r * np.sin(t)]), "black", 1.3)
    s.marker(c, "m0,\\ m1", (0.1, -1.1))
    s.line([c, c + [3.4, 0]], GREY, 0.9, "--")
    s.angle(c, 2.6, 0, 17, r"\ \Delta\theta", GREY)
    s.frame((0.8, 0.5), 0, ("x_{J0}", "y_{J0}"), 0.8, "z_{J0}")
    law = r"$\tau = k\,(\Delta\theta - \theta_{off}) + d\,(\Delta\omega - \omega_{off}) + \tau_c$"
    s.text((4.9, 0.7), law, fontsize=10)
    return s


def coordinate_spring_damper() -> Sketch:
    s = Sketch(8, 3.6)
    s.ground(np.array([0.8, 1.9]), 2.2, np.pi / 2 * 3)
    s.body([(5.2, 0.9), (7.2, 0.9), (7.2, 2.9), (5.2, 2.9)], SECOND)
    p, q = (0.8, 1.9), (5.2, 1.9)
    s.spring_damper(p, q)
    s.marker(p, "m0", (0.35, 0.9))
    s.marker(q, "m1", (-0.3, 0.9))
    s.arrow((5.4, 3.15), (6.9, 3.15), "q_{m1}", (0, 0.28))
    s.text((3.1, 0.5), r"$f = k\,(\Delta q - l_{off}) + d\,\Delta v$", fontsize=10)
    return s


def distance() -> Sketch:
    s = two_bodies()
    p, q = (2.2, 2.3), (6.6, 2.5)
    s.line([p, q], EDGE, 3)
    s.marker(p, "m0", (-0.3, 0.4))
    s.marker(q, "m1", (0.35, 0.4))
    s.dimension(p, q, "d_0", (-0.05, 0.9))
    return s


def coordinate() -> Sketch:
    s = Sketch(8, 4.6)
    s.circle((2.4, 2.7), 1.2, FILL)
    s.circle((5.2, 2.7), 1.6, SECOND)
    s.marker((2.4, 2.7), "m0", (0, -0.4))
    s.marker((5.2, 2.7), "m1", (0, -0.4))
    s.angle((2.4, 2.7), 0.85, 30, 150, "", RED)
    s.angle((5.2, 2.7), 1.15, 30, 150, "", RED)
    s.text((2.4, 3.15), "$q_{m0}$", RED)
    s.text((5.2, 3.35), "$q_{m1}$", RED)
    s.text((3.9, 0.5), "$k_{m1}\\, q_{m1} - q_{m0} - l_{off} = 0$")
    return s


def revolute_z() -> Sketch:
    s = Sketch(8, 4.6)
    s.blob((2.0, 2.0), 1.7, 1.2, angle=0.2)
    s.body([(3.6, 1.85), (7.2, 3.1), (7.0, 3.7), (3.4, 2.45)], SECOND)
    c = np.array([3.5, 2.15])
    s.circle(c, 0.32, "white")
    s.frame(c, 0, ("x_0", "y_0"), 1.7, "\\ ")
    s.text(c + [-0.2, -0.75], "$z_0 = z_1$", GREY, fontsize=10)
    for angle, name in ((19, "x_1"), (109, "y_1")):
        d = np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
        s.arrow(c, c + 1.7 * d, color=RED)
        s.text(c + 2.0 * d, f"${name}$", RED, fontsize=10)
    s.angle(c, 1.2, 0, 19, "", RED)
    s.text(c + [1.45, 0.25], r"$\varphi$", RED)
    s.text((1.3, 2.2), "$m0$", RED)
    s.text((6.4, 3.9), "$m1$", RED)
    return s


def prismatic_x() -> Sketch:
    s = Sketch(9, 4.0)
    s.body([(0.5, 1.1), (8.5, 1.1), (8.5, 1.6), (0.5, 1.6)], FILL)
    s.body([(5.0, 0.7), (7.4, 0.7), (7.4, 2.0), (5.0, 2.0)], SECOND)
    p, q = np.array([1.6, 1.35]), np.array([6.2, 1.35])
    s.frame(p, 0, ("x_0", "y_0"), 1.1)
    s.frame(q, 0, ("x_1", "y_1"), 1.1)
    s.marker(p, "m0", (-0.45, -0.55))
    s.marker(q, "m1", (-0.5, 0.3))
    s.dimension(p, q, r"\Delta\mathbf{p}", (0, 2.0))
    return s


def spherical() -> Sketch:
    s = Sketch(7, 4.2)
    s.blob((1.9, 2.0), 1.6, 1.1, angle=0.2)
    s.blob((5.0, 2.2), 1.6, 1.1, SECOND, angle=-0.4)
    s.circle((3.45, 2.1), 0.28, "white")
    s.marker((3.45, 2.1), "m0,\\ m1", (0, 1.35))
    s.text((3.5, 0.5), r"$\Delta\mathbf{p} = \mathbf{p}_{m1} - \mathbf{p}_{m0} = \mathbf{0}$")
    return s


def generic() -> Sketch:
    s = Sketch(9, 4.6)
    s.blob((1.7, 2.0), 1.4, 1.1, angle=0.4)
    s.blob((7.2, 2.4), 1.4, 1.1, SECOND, angle=-0.3)
    p, q = np.array([2.5, 2.0]), np.array([6.3, 2.5])
    s.frame(p, 0.1, ("x_0", "y_0"), 1.0, "z_0")
    s.frame(q, 0.5, ("x_1", "y_1"), 1.0, "z_1")
    s.marker(p, "m0", (-0.3, -0.7))
    s.marker(q, "m1", (0.3, -0.6))
    s.line([p, q], GREY, 0.9, "--")
    s.text((4.5, 2.6), r"$\Delta\mathbf{p}$", GREY)
    s.text((4.5, 0.5), "constrainedAxes: $[x_0,\\ y_0,\\ z_0,\\ \\theta_x,\\ \\theta_y,\\ \\theta_z]$", fontsize=10)
    return s


def revolute_2d() -> Sketch:
    s = Sketch(7.6, 4.2)
    s.body([(0.8, 0.8), (1.2, 0.4), (3.9, 2.1), (3.6, 2.6)])
    s.body([(3.5, 2.1), (3.8, 2.6), (6.9, 1.5), (6.7, 1.0)], SECOND)
    s.circle((3.7, 2.35), 0.26, "white")
    s.marker((3.7, 2.35), "m0,\\ m1", (0, 0.65))
    s.frame((0.5, 2.9), 0, ("x", "y"), 0.8)
    s.text((5.0, 3.5), r"$\Delta p_x = \Delta p_y = 0$", fontsize=10)
    return s


def prismatic_2d() -> Sketch:
    s = Sketch(8.6, 4.2)
    t, n = np.array([np.cos(0.3), np.sin(0.3)]), np.array([-np.sin(0.3), np.cos(0.3)])
    a, q = np.array([0.9, 1.2]), np.array([0.9, 1.2]) + 4.6 * t
    s.body([a - 0.5 * t - 0.15 * n, a + 7 * t - 0.15 * n, a + 7 * t + 0.15 * n, a - 0.5 * t + 0.15 * n])
    s.body([q - 0.8 * t - 0.5 * n, q + 0.8 * t - 0.5 * n, q + 0.8 * t + 0.5 * n, q - 0.8 * t + 0.5 * n], SECOND)
    s.marker(a, "m0", (0, -0.5))
    s.marker(q, "m1", (0.3, -0.35))
    s.arrow(a, a + 1.6 * t, "", color=RED)
    s.arrow(q, q + 1.3 * n, "", color=RED)
    s.text(a + 1.8 * t + 0.45 * n, r"$\mathbf{t}_0$", RED)
    s.text(q + 1.6 * n, r"$\mathbf{n}_1$", RED)
    s.text((4.0, 0.45), r"$\mathbf{n}_1^T \Delta\mathbf{p} = 0,\ \ \mathbf{t}_0^T \mathbf{n}_1 = 0$")
    return s


def rolling_disc() -> Sketch:
    s = Sketch(8, 5.0)
    s.ground(np.array([4, 0.9]), 7)
    c, r = np.array([4.2, 2.8]), 1.9
    s.circle(c, r, SECOND)
    s.marker(c, "m1", (0.4, 0.3))
    s.marker((1.0, 0.9), "m0", (0, 0.4))
    s.dimension(c, c - [0, r], "r", (0, 0), (0.25, 0.1))
    s.circle(c - [0, r], 0.09, "black", "black", zorder=7)
    s.text(c + [0.9, -r + 0.25], "$C$")
    s.arrow(c + [0, 0], c + [1.5, 0], "", color=GREY)
    s.text(c + [1.1, 0.3], r"$\mathbf{v}$", GREY)
    t = np.radians(np.linspace(170, 105, 40))
    s.line(c + 1.3 * np.column_stack([np.cos(t), np.sin(t)]), RED, 1.3)
    s.arrow(c + [-0.45, 1.22], c + [-0.22, 1.28], color=RED)
    s.text(c + [-0.65, 0.65], r"$\omega$", RED)
    s.arrow((6.9, 0.9), (6.9, 2.0), r"\mathbf{n}", (0.35, 0.3), GREY)
    return s


def rigid_body() -> Sketch:
    s = Sketch(8, 5.0)
    s.blob((4.8, 2.9), 2.5, 1.5, angle=0.2)
    o, p, com = np.array([0.8, 0.7]), np.array([4.0, 2.5]), np.array([5.3, 3.3])
    s.frame(o, 0, ("x", "y"), 1.0, "z")
    s.arrow(o, p, r"\mathbf{p}", (-0.3, 0.3))
    s.frame(p, 0.35, ("x_b", "y_b"), 1.1, "z_b")
    s.arrow(p, com, "", color=RED)
    s.text((4.45, 3.15), r"$\mathbf{b}$", RED)
    s.circle(com, 0.13, "black", "black", zorder=6)
    s.text(com + [0.75, 0.25], "COM $m,\\ \\mathbf{J}$", fontsize=10)
    return s


def mass_point() -> Sketch:
    s = Sketch(6, 4.0)
    o, p = np.array([0.8, 0.7]), np.array([4.4, 2.7])
    s.frame(o, 0, ("x", "y"), 1.0, "z")
    s.arrow(o, p, r"\mathbf{p} = \mathbf{p}_{ref} + \mathbf{u}", (0.9, -0.5))
    s.circle(p, 0.35, SECOND)
    s.text(p + [0.65, 0.4], "$m$")
    return s


def cable() -> Sketch:
    s = Sketch(10, 4.6)
    t = np.linspace(0, 1, 80)
    p, q, dp, dq = np.array([1.2, 1.4]), np.array([7.6, 2.6]), np.array([7, 5.5]), np.array([7.5, -3.5])
    h = [1 - 3 * t**2 + 2 * t**3, t - 2 * t**2 + t**3, 3 * t**2 - 2 * t**3, t**3 - t**2]
    axis = sum(np.outer(a, b) for a, b in zip(h, (p, dp, q, dq), strict=True))
    s.line(axis, EDGE, 5)
    for point, slope, k, side in ((p, dp, 0, 1), (q, dq, 1, 1)):
        d = slope / np.linalg.norm(slope)
        s.marker(point)
        s.text(point + [0, -0.5], rf"$\mathbf{{r}}_{k}$", RED)
        s.arrow(point, point + 1.3 * d, color=RED)
        s.text(point + 1.6 * d + [-0.25, 0.3 * side], rf"$\mathbf{{r}}'_{k}$", RED)
    middle = axis[40]
    s.text(middle + [0, 0.45], r"$\mathbf{r}(x),\ 0 \leq x \leq L$")
    s.frame((0.6, 3.2), 0, ("x", "y"), 0.8)
    return s


def beam_2d() -> Sketch:
    s = Sketch(9, 4.6)
    t = np.linspace(0, 1, 60)
    axis = np.column_stack([1.2 + 6.4 * t, 1.4 + 1.7 * np.sin(1.9 * t)])
    s.line(axis, EDGE, 2.5)
    for k, (i, angle) in enumerate(((0, 0.75), (-1, 0.1))):
        c, d = axis[i], np.array([-np.sin(angle), np.cos(angle)])
        s.line([c - 0.6 * d, c + 0.6 * d], RED, 2)
        s.marker(c)
        s.text(c + [0.1, -0.95], rf"$\mathbf{{r}}_{k},\ \theta_{k}$", RED)
    i, angle = 30, 0.25
    c, d = axis[i], np.array([-np.sin(angle), np.cos(angle)])
    s.line([c - 0.6 * d, c + 0.6 * d], GREY, 1.5)
    s.arrow(c, c + 1.2 * np.array([np.cos(angle), np.sin(angle)]), r"\mathbf{n}", (0.45, -0.3), GREY)
    s.text(c + [0.3, 1.0], "cross section", GREY, fontsize=9)
    s.frame((0.6, 3.2), 0, ("x", "y"), 0.8)
    return s


def sphere_sphere() -> Sketch:
    s = Sketch(8, 5.0)
    a, b = np.array([2.4, 2.6]), np.array([5.3, 3.2])
    n = (b - a) / np.linalg.norm(b - a)
    s.circle(a, 1.7, FILL)
    s.circle(b, 1.5, SECOND, alpha=0.8)
    s.marker(a, "m0", (-0.35, 0.3))
    s.marker(b, "m1", (0.4, 0.3))
    s.line([a, b], GREY, 0.8, "--")
    for c, radius, angle, name in ((a, 1.7, 2.2, "r_0"), (b, 1.5, -0.9, "r_1")):
        d = np.array([np.cos(angle), np.sin(angle)])
        s.arrow(c, c + radius * d, "", color=GREY)
        s.text(c + 0.65 * radius * d + [0.3, 0.12], f"${name}$", GREY)
    s.arrow(a, a + 1.1 * n, r"\mathbf{n}", (0.1, -0.35), RED)
    s.text((4.0, 0.4), r"$\delta = -g = r_0 + r_1 - |\Delta\mathbf{p}|$", fontsize=10)
    return s


def contact_coordinate() -> Sketch:
    s = Sketch(8, 3.6)
    s.ground(np.array([7.2, 1.9]), 2.4, np.pi / 2)
    s.body([(1.0, 1.0), (3.2, 1.0), (3.2, 2.8), (1.0, 2.8)], SECOND)
    s.spring_damper((5.0, 1.9), (7.2, 1.9), "k_c", "d_c")
    s.line([(5.0, 1.3), (5.0, 2.5)], "black", 2)
    s.marker((3.2, 1.9), "m0", (-0.4, 0))
    s.marker((7.2, 1.9), "m1", (-0.35, 0.9))
    s.dimension((3.2, 1.9), (5.0, 1.9), "g", (0, -1.1))
    return s


def hydraulic() -> Sketch:
    s = Sketch(10, 4.6)
    s.body([(1.6, 1.6), (6.4, 1.6), (6.4, 3.0), (1.6, 3.0)], "white")
    s.body([(1.6, 1.6), (4.0, 1.6), (4.0, 3.0), (1.6, 3.0)], FILL)
    s.body([(4.3, 1.6), (6.4, 1.6), (6.4, 3.0), (4.3, 3.0)], "#eef3ea")
    s.body([(4.0, 1.6), (4.3, 1.6), (4.3, 3.0), (4.0, 3.0)], GREY)
    s.body([(4.3, 2.15), (8.6, 2.15), (8.6, 2.45), (4.3, 2.45)], SECOND)
    s.line([(0.8, 2.3), (1.6, 2.3)], "black", 2)
    s.marker((0.8, 2.3), "m0", (0, 0.45))
    s.marker((8.6, 2.3), "m1", (0.2, 0.45))
    s.text((2.8, 2.3), "$p_0,\\ A_0$")
    s.text((5.4, 2.75), "$p_1,\\ A_1$", fontsize=10)
    for x, name in ((2.2, r"\mathrm{valve\ 0}"), (5.8, r"\mathrm{valve\ 1}")):
        s.arrow((x, 4.2), (x, 3.0), color=RED, head="<|-|>")
        s.text((x + 1.0, 3.7), f"${name}$", RED, fontsize=10)
    s.dimension((0.8, 2.3), (8.6, 2.3), "L = L_o + s", (0, -1.5))
    return s


def ffrf() -> Sketch:
    s = Sketch(9, 5.0)
    o, p = np.array([0.7, 0.6]), np.array([2.6, 2.0])
    x = np.linspace(0, 1, 40)
    top, low = 2.5 + 1.1 * x + 1.1 * x**2, 1.5 + 1.1 * x + 1.1 * x**2
    s.body(np.vstack([np.column_stack([2.6 + 5 * x, top]), np.column_stack([2.6 + 5 * x, low])[::-1]]))
    for k in (8, 16, 24, 32):
        s.line([(2.6 + 5 * x[k], top[k]), (2.6 + 5 * x[k], low[k])], EDGE, 0.6)
    t, n = np.array([np.cos(0.217), np.sin(0.217)]), np.array([-np.sin(0.217), np.cos(0.217)])
    corner = [p - 0.5 * n, p + 5.1 * t - 0.5 * n, p + 5.1 * t + 0.5 * n, p + 0.5 * n, p - 0.5 * n]
    s.line(corner, GREY, 1.0, "--")
    s.frame(o, 0, ("x", "y"), 0.8)
    s.arrow(o, p, r"\mathbf{p}", (-0.3, 0.25))
    s.frame(p, 0.217, ("x_b", "y_b"), 1.2)
    ref, node = p + 3.9 * t + 0.5 * n, np.array([2.6 + 5 * x[30], top[30]])
    s.arrow(p, ref, r"\mathbf{x}_{ref}^{(i)}", (0.3, -0.75), GREY)
    s.arrow(ref, node, "", color=RED)
    s.text((ref + node) / 2 + [-0.9, 0.15], r"$\mathbf{\Psi}^{(i)} \mathbf{\zeta}$", RED)
    return s


def kinematic_tree() -> Sketch:
    s = Sketch(8.4, 5.0)
    s.ground(np.array([1.6, 0.6]), 2)
    joints = [np.array([1.6, 0.9]), np.array([2.6, 3.0]), np.array([5.2, 3.7]), np.array([7.3, 2.7])]
    for k in range(3):
        a, b = joints[k], joints[k + 1]
        d = (b - a) / np.linalg.norm(b - a)
        n = 0.22 * np.array([-d[1], d[0]])
        s.body([a - n, b - n, b + n, a + n], (FILL, SECOND, FILL)[k])
        s.text((a + b) / 2 + 3.0 * np.array([-d[1], d[0]]) * 0.22, f"link {k}", fontsize=9)
    for k in range(3):
        s.circle(joints[k], 0.25, "white")
        s.text(joints[k] + [(0.65, 0.1), (0.45, -0.4), (-0.1, -0.55)][k], f"$q_{k}$", RED)
    s.line([(1.6, 0.6), (1.6, 0.7)], "black", 3)
    s.marker(joints[3], "m", (0.4, 0.1))
    return s


def force() -> Sketch:
    s = Sketch(7, 4.0)
    s.blob((2.8, 1.8), 1.9, 1.2, angle=0.2)
    p = np.array([3.9, 2.3])
    s.arrow(p, p + [2.0, 0.9], r"\mathbf{f}", (0, 0.4), RED)
    s.marker(p, "m", (-0.35, 0.25))
    s.frame((0.5, 0.6), 0, ("x", "y"), 0.8)
    return s


def torque() -> Sketch:
    s = Sketch(7, 4.0)
    s.blob((3.2, 1.9), 2.0, 1.3, angle=0.2)
    p = np.array([3.5, 2.0])
    s.angle(p, 0.8, -40, 200, "", RED)
    s.text(p + [1.15, 0.3], r"$\tau$", RED)
    s.marker(p, "m", (0.1, -0.4))
    s.frame((0.5, 0.6), 0, ("x", "y"), 0.8, "z")
    return s


def marker_body() -> Sketch:
    s = Sketch(8, 4.8)
    s.blob((4.6, 2.7), 2.4, 1.5, angle=0.2)
    o, p, q = np.array([0.8, 0.7]), np.array([3.6, 2.2]), np.array([6.0, 3.5])
    s.frame(o, 0, ("x", "y"), 0.9)
    s.arrow(o, p, r"\mathbf{p}", (-0.2, 0.35))
    s.frame(p, 0.35, ("x_b", "y_b"), 1.1)
    s.arrow(p, q, "", color=RED)
    s.text((5.7, 2.3), "localPosition", RED, fontsize=9)
    s.marker(q, "m", (0.3, 0.3))
    return s


DRAWINGS: dict[str, Callable[[], Sketch]] = {
    "LoadForceVector": force,
    "LoadTorqueVector": torque,
    "MarkerBodyPosition": marker_body,
    "MarkerBodyRigid": marker_body,
    "ObjectANCFCable": cable,
    "ObjectANCFCable2D": cable,
    "ObjectBeamGeometricallyExact2D": beam_2d,
    "ObjectConnectorCartesianSpringDamper": cartesian_spring_damper,
    "ObjectConnectorCoordinate": coordinate,
    "ObjectConnectorCoordinateSpringDamper": coordinate_spring_damper,
    "ObjectConnectorDistance": distance,
    "ObjectConnectorHydraulicActuatorSimple": hydraulic,
    "ObjectConnectorRigidBodySpringDamper": rigid_body_spring_damper,
    "ObjectConnectorRollingDiscPenalty": rolling_disc,
    "ObjectConnectorSpringDamper": spring_damper,
    "ObjectConnectorTorsionalSpringDamper": torsional_spring_damper,
    "ObjectContactCoordinate": contact_coordinate,
    "ObjectContactSphereSphere": sphere_sphere,
    "ObjectFFRFreducedOrder": ffrf,
    "ObjectJointGeneric": generic,
    "ObjectJointPrismatic2D": prismatic_2d,
    "ObjectJointPrismaticX": prismatic_x,
    "ObjectJointRevolute2D": revolute_2d,
    "ObjectJointRevoluteZ": revolute_z,
    "ObjectJointRollingDisc": rolling_disc,
    "ObjectJointSpherical": spherical,
    "ObjectKinematicTree": kinematic_tree,
    "ObjectMassPoint": mass_point,
    "ObjectRigidBody": rigid_body,
}


def draw_items() -> None:
    """Draw all items, unless the drawings are newer than this file."""
    source = max(Path(__file__).with_name(name).stat().st_mtime for name in ("item_drawings.py", "sketches.py"))
    for item, function in DRAWINGS.items():
        path = FOLDER / f"{item}.svg"
        if path.exists() and path.stat().st_mtime > source:
            continue
        with styled():
            save(function().figure, path)
