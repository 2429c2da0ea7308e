"""The mechanism of Bricard in one coordinate, the angle of its first joint. The loop is closed numerically for each angle; kinetic and
potential energy, as functions of the angle, are interpolated by Chebyshev polynomials, from which the equation of motion follows."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.polynomial import Chebyshev
from numpy.polynomial.chebyshev import chebpts1
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

CORNERS = np.array([[0, 0, 0], [1, 0, 0], [1, -1, 0], [1, -1, 1], [0, -1, 1], [0, 0, 1]], dtype=float)
AXES = "yzxyzx"
GRAVITY = 9.81
MASS, WIDTH = 1.0, 0.1  # of a rod of length 1
INTERVAL, POINTS = (-0.05, 1.5), 60  # angles that the first second passes


def chain(angles: np.ndarray) -> tuple[list[np.ndarray], list[np.ndarray]]:
    """Rotations of the five rods and places of all corners, when each joint has turned about its axis."""
    turns, places = [], [CORNERS[0]]
    turn = np.eye(3)
    for i, (axis, angle) in enumerate(zip(AXES, angles, strict=True)):
        turn = turn @ Rotation.from_rotvec(angle * np.eye(3)["xyz".index(axis)]).as_matrix()
        if i < 5:
            turns.append(turn)
            places.append(places[-1] + turn @ (CORNERS[i + 1] - CORNERS[i]))
    return [*turns, turn], places


def gaps(angles: np.ndarray) -> np.ndarray:
    """Place of the last corner and rotation behind the last joint, which belong to the ground."""
    turns, places = chain(angles)
    return np.concatenate([places[-1] - CORNERS[-1], Rotation.from_matrix(turns[-1]).as_rotvec()])


def joint_axes(turns: list[np.ndarray]) -> np.ndarray:
    before = [np.eye(3), *turns[:-1]]
    return np.array([turn["xyz".index(axis)] for turn, axis in zip(np.swapaxes(before, 1, 2), AXES, strict=True)])


def slopes(angles: np.ndarray) -> np.ndarray:
    """Velocity of the loop's end, as a point of the ground, and its angular velocity, per rate of each joint."""
    turns, places = chain(angles)
    axes = joint_axes(turns)
    return np.array([[*np.cross(a, places[-1] - p), *a] for a, p in zip(axes, places, strict=True)]).T


def closed(first: float, guess: np.ndarray) -> np.ndarray:
    """The other five angles, by Newton's method in the sense of least squares: one of the six equations is
    redundant."""
    angles = np.array([first, *guess[1:]])
    for _ in range(50):
        step = np.linalg.lstsq(slopes(angles)[:, 1:], -gaps(angles), rcond=1e-8)[0]
        angles[1:] += step
        if np.abs(step).max() < 1e-14:
            break
    assert np.abs(gaps(angles)).max() < 1e-12
    return angles


def energies(angles: np.ndarray) -> tuple[float, float, np.ndarray]:
    """Generalised mass, potential energy, and the third corner."""
    turns, places = chain(angles)
    rates = np.array([1, *np.linalg.lstsq(slopes(angles)[:, 1:], -slopes(angles)[:, 0], rcond=1e-8)[0]])
    axes = joint_axes(turns)
    mass = potential = 0.0
    for k in range(5):
        centre = (places[k] + places[k + 1]) / 2
        along = CORNERS[k + 1] - CORNERS[k]
        inertia = MASS / 12 * np.where(along == 0, 1 + WIDTH**2, 2 * WIDTH**2)
        velocity = sum(rates[i] * np.cross(axes[i], centre - places[i]) for i in range(k + 1))
        omega = turns[k].T @ (rates[: k + 1] @ axes[: k + 1])
        mass += MASS * velocity @ velocity + inertia @ omega**2
        potential += MASS * GRAVITY * centre[1]
    return mass, potential, places[3]


@cache
def third_corners() -> dict[float, np.ndarray]:
    """Values at some times (s), to ten digits."""
    first_angles = (INTERVAL[1] + INTERVAL[0] + (INTERVAL[1] - INTERVAL[0]) * chebpts1(POINTS)) / 2
    angles, values = np.zeros(6), []
    for first in first_angles:
        angles = closed(first, angles)
        mass, potential, corner = energies(angles)
        values.append([mass, potential, *corner])
    fits = [Chebyshev.fit(first_angles, column, POINTS - 1, domain=INTERVAL) for column in np.transpose(values)]
    mass, potential, *corner = fits
    mass_slope, weight = mass.deriv(), potential.deriv()

    def derivative(_: float, state: np.ndarray) -> list[float]:
        angle, rate = state
        return [rate, -(weight(angle) + 0.5 * mass_slope(angle) * rate**2) / mass(angle)]

    result, state, before = {}, [0.0, 0.0], 0.0
    for end in (0.5, 1.0):
        path = solve_ivp(derivative, (before, end), state, method="DOP853", rtol=1e-12, atol=1e-13)
        assert INTERVAL[0] < path.y[0].min() and path.y[0].max() < INTERVAL[1]
        state, before = path.y[:, -1], end
        result[end] = np.array([component(state[0]) for component in corner])
    return result
