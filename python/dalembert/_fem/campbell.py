"""Frequencies of a rotating body as a function of its speed.

The eigenfrequencies of M a + W G v + K q = 0, W being the speed, split.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._fem.eigen import SHIFT, first_deformation
from dalembert._tools.later import scipy


def gyroscopic_matrix(mass: Any, axis: int) -> Any:
    """The cross product with the axis for each node, times the mass matrix: sparse."""
    turn = np.zeros((3, 3))
    turn[(axis + 2) % 3, (axis + 1) % 3], turn[(axis + 1) % 3, (axis + 2) % 3] = 1.0, -1.0
    return (scipy.sparse.kron(scipy.sparse.eye(mass.shape[0] // 3), turn) @ mass).tocsr()


def dense_frequencies(mass: FloatArray, stiffness: FloatArray, gyroscopic: FloatArray, count: int) -> FloatArray:
    """Frequencies in Hz in ascending order; a single 0 represents all rigid-body modes."""
    size = len(mass)
    right = np.hstack([-stiffness, -gyroscopic])
    matrix = np.vstack(
        [np.hstack([np.zeros((size, size)), np.eye(size)]), scipy.linalg.solve(mass, right, assume_a="pos")]
    )
    return _different(np.linalg.eigvals(matrix), count)


def sparse_frequencies(mass: Any, stiffness: Any, gyroscopic: Any, points: FloatArray, count: int) -> FloatArray:
    """Variant for large matrices: frequencies close to zero, by shift-invert with a small imaginary shift."""
    size = mass.shape[0]
    shift = np.sqrt(SHIFT * first_deformation(mass, stiffness, points))
    # a real shift s needs K + s G + s^2 M for (A - s)^-1 of A = [[0, 1], [-M^-1 K, -M^-1 G]]
    system = scipy.sparse.csc_matrix(stiffness + shift * gyroscopic + shift**2 * mass)
    factors = scipy.sparse.linalg.splu(system)

    def solve(right: FloatArray) -> FloatArray:
        p, v = right[:size], right[size:]
        position = -factors.solve(mass @ (v + shift * p) + gyroscopic @ p)
        return np.concatenate([position, shift * position + p])

    inverse = scipy.sparse.linalg.LinearOperator((2 * size, 2 * size), matvec=solve, dtype=float)
    start = np.random.default_rng(1).standard_normal(2 * size)
    wanted = min(2 * (count + 7), 2 * size - 2)
    found = scipy.sparse.linalg.eigs(inverse, k=wanted, which="LM", v0=solve(start), return_eigenvectors=False)
    return _different(shift + 1.0 / found, count)


def _different(values: Any, count: int) -> FloatArray:
    """A frequency per conjugate pair, in ascending order; all rigid-body modes are represented by one 0."""
    frequencies = np.sort(np.imag(values)) / (2 * np.pi)
    above = frequencies[frequencies > 1e-5 * frequencies[-1] * min(1.0, 100 / len(frequencies))]
    moving = above[: count + 1]
    still = len(values) > 2 * len(above)
    return np.concatenate([[0.0], moving])[: count + 1] if still else moving


def plot_campbell(speeds: Sequence[float], frequencies: Sequence[Sequence[float]]) -> None:
    """Draw the frequencies over the speed, and the line on which they are equal."""
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots()
    axes.plot(speeds, np.array(frequencies))
    axes.plot(speeds, speeds, "k--", label="rotor speed")
    axes.set_xlabel("rotor speed (Hz)")
    axes.set_ylabel("eigenfrequency (Hz)")
    axes.grid(True)
    axes.legend()
    plt.show()
