"""The flyball governor in three coordinates, by Lagrange's equations: angle of the shaft, angle of the rods below the horizontal,
height of the slider. The angular momentum about the shaft is constant, so that two equations of second order remain."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

DENSITY, LENGTH, WIDTH, CUBE = 3000, 1.0, 0.01, 0.1
TIP, HINGE, OMEGA, GRAVITY = 5.0, 0.05, 2 * np.pi, 9.81
STIFFNESS, DAMPING, FREE = 8e5, 4e4, 0.5
ANGLE = np.radians(30)  # of the rods below the horizontal, at the start
START = 0.5  # height of the slider


def block(size: Any) -> tuple[float, np.ndarray]:
    """Mass and inertia about the centre."""
    mass = DENSITY * np.prod(size)
    squares = np.square(size)
    return mass, mass / 12 * (squares.sum() - squares)


ROD, ROD_INERTIA = block([LENGTH, WIDTH, WIDTH])
SLIDER, SLIDER_INERTIA = block([CUBE, CUBE, CUBE])
AXIAL = block([WIDTH, WIDTH, LENGTH])[1][2] + SLIDER_INERTIA[2]
SWING = 2 * (ROD_INERTIA[1] + ROD * LENGTH**2 / 4 + TIP * LENGTH**2)  # inertia of both rods about their hinges


def about_shaft(angle: float) -> tuple[float, float]:
    """Moment of inertia about the shaft, and its derivative by the angle of the rods."""
    s, c = np.sin(angle), np.cos(angle)
    arms = ((ROD, LENGTH / 2), (TIP, LENGTH))
    inertia = ROD_INERTIA[0] * s**2 + ROD_INERTIA[2] * c**2 + sum(m * (HINGE + x * c) ** 2 for m, x in arms)
    slope = 2 * (ROD_INERTIA[0] - ROD_INERTIA[2]) * s * c - sum(2 * m * (HINGE + x * c) * x * s for m, x in arms)
    return AXIAL + 2 * inertia, 2 * slope


MOMENTUM = about_shaft(ANGLE)[0] * OMEGA


def derivative(_: float, state: np.ndarray) -> list[float]:
    angle, height, angle_t, height_t = state
    s, c = np.sin(angle), np.cos(angle)
    inertia, slope = about_shaft(angle)
    across, up = LENGTH / 2 * c, LENGTH - LENGTH / 2 * s - height  # from the slider to the middle of the rod
    span = np.hypot(across, up)
    by_angle, by_height = (-across * s - up * c) * LENGTH / 2 / span, -up / span
    force = STIFFNESS * (span - FREE) + DAMPING * (by_angle * angle_t + by_height * height_t)
    weight = 2 * GRAVITY * (ROD * LENGTH / 2 + TIP * LENGTH) * c
    swing = 0.5 * slope * (MOMENTUM / inertia) ** 2 + weight - 2 * force * by_angle
    return [angle_t, height_t, swing / SWING, -GRAVITY - 2 * force * by_height / SLIDER]


@cache
def heights_of_slider() -> dict[float, float]:
    """Values at some times (s), to ten digits."""
    heights, state, before = {}, [ANGLE, START, 0, 0], 0.0
    for end in (0.1, 0.5, 1.0, 2.0, 5.0):
        state = solve_ivp(derivative, (before, end), state, method="Radau", rtol=1e-10, atol=1e-12).y[:, -1]
        heights[end], before = float(state[1]), end
    return heights
