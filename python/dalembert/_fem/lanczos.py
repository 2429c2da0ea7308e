"""Block Lanczos iteration with shift and inversion [Grimes, Lewis and Simon 1994], for eigenvalues next to the shift.

A solution for a block of vectors takes hardly longer than one for a single vector, since it is the factors that have to
be read; and modes of the same frequency, as those of a round shaft, are found by a block as surely as others.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._tools.later import scipy

BLOCK = 12  # vectors that are solved for at once
TOLERANCE = 1e-10  # norm of a residual, as part of the eigenvalue of the inverse, whose error is about its square
ROUND_OFF = 1e-15  # the same, as part of the largest of them
ORTHOGONAL = 1e-9  # the error after a second orthogonalization is the square of this
DEPENDENT = 1e-12  # a vector of which less than that is left when the others are taken off
Solve = Callable[[FloatArray], FloatArray]


def inverse_lanczos(mass: Any, solve: Solve, shift: float, count: int) -> tuple[FloatArray, FloatArray]:
    """Eigenvalues of the stiffness next to -shift, in rising order, and modes with unit modal masses.

    `solve` gives the displacements of columns of forces with the stiffness K + shift M; it may hold constraints.
    """
    basis, projected = _Basis(mass), np.zeros((0, 0))
    random = np.random.default_rng(1)  # results do not change from run to run
    basis.extend(_start(mass, solve, random))
    while True:
        new = solve(basis.massive[:, len(projected) :])
        projected = _bordered(projected, basis.massive.T @ new)
        coupling = basis.extend(new)
        values, vectors = scipy.linalg.eigh(projected)
        nearest = np.argsort(-np.abs(values))[:count]
        residuals = np.linalg.norm(coupling @ vectors[-coupling.shape[1] :, nearest], axis=0)
        bounds = TOLERANCE * np.abs(values[nearest]) + ROUND_OFF * np.abs(values).max()
        if len(nearest) == count and (residuals <= bounds).all():
            found = basis.massive[:, : len(vectors)] @ vectors[:, nearest]
            return _modes(mass, solve, found, 1.0 / values[nearest] - shift)
        if basis.size == len(projected):  # nothing but modes so far, and others are wanted
            basis.extend(_start(mass, solve, random))
        if basis.size == len(projected):
            raise ValueError(f"{count} modes are asked for, but there are only {len(projected)} with a mass")


def _start(mass: Any, solve: Solve, random: np.random.Generator) -> FloatArray:
    return solve(mass @ random.standard_normal((mass.shape[0], min(BLOCK, mass.shape[0]))))


def _modes(mass: Any, solve: Solve, found: FloatArray, eigenvalues: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Modes with unit modal masses; a further solution removes massless components [Nour-Omid et al. 1987]."""
    modes = np.hstack([solve(part) for part in np.array_split(found, -(-found.shape[1] // BLOCK), axis=1)])
    modes /= np.sqrt(np.einsum("ij,ij->j", modes, mass @ modes))
    order = np.argsort(eigenvalues)
    return eigenvalues[order], modes[:, order]


class _Basis:
    """Vectors that are orthonormal by the mass matrix, and their products with it, as rows."""

    def __init__(self, mass: Any) -> None:
        self._mass = mass
        self.size = 0
        self._vectors, self._massive = (np.empty((8 * BLOCK, mass.shape[0])) for _ in range(2))

    @property
    def massive(self) -> FloatArray:
        """Products of the mass matrix with the vectors, as columns."""
        return self._massive[: self.size].T

    def extend(self, new: FloatArray) -> FloatArray:
        """Add the independent part of vectors; returns its coefficients in the added vectors."""
        vectors, massive = self._vectors[: self.size], self._massive[: self.size]
        rows, coupling, longest = np.ascontiguousarray(new.T), np.eye(new.shape[1]), 0.0
        while True:
            known = rows @ massive.T
            rows -= known @ vectors
            moved = np.ascontiguousarray((self._mass @ rows.T).T)
            squares, axes = np.linalg.eigh(rows @ moved.T)
            if not longest:  # norms of the original vectors; later vectors have unit length
                longest = float(np.sqrt(squares.max(initial=0.0) + np.square(known).sum(axis=1).max(initial=0.0)))
            kept = squares > (DEPENDENT * longest) ** 2
            lengths, turn = np.sqrt(squares[kept]), axes.T[kept]
            scaled = turn / lengths[:, None]
            rows, moved = scaled @ rows, scaled @ moved
            coupling = (lengths[:, None] * turn) @ coupling
            # A vector is not orthogonal enough after a large part has been subtracted [Parlett 1980].
            if np.abs(known).max(initial=0.0) < ORTHOGONAL and np.abs(lengths - 1.0).max(initial=0.0) < ORTHOGONAL:
                self._append(rows, moved)
                return coupling
            longest = 1.0

    def _append(self, rows: FloatArray, moved: FloatArray) -> None:
        size = self.size + len(rows)
        if size > len(self._vectors):
            self._vectors, self._massive = (_doubled(numbers, self.size) for numbers in (self._vectors, self._massive))
        self._vectors[self.size : size], self._massive[self.size : size] = rows, moved
        self.size = size


def _doubled(rows: FloatArray, used: int) -> FloatArray:
    """Twice as many rows, of which the first ones are taken over."""
    result = np.empty((2 * len(rows), rows.shape[1]))
    result[:used] = rows[:used]
    return result


def _bordered(projected: FloatArray, columns: FloatArray) -> FloatArray:
    """The projected matrix with the columns of new vectors, and their rows, which are the same."""
    known, size = len(projected), len(columns)
    result = np.zeros((size, size))
    result[:known, :known] = projected
    result[:, known:], result[known:, :] = columns, columns.T
    result[known:, known:] = 0.5 * (columns[known:] + columns[known:].T)
    return result
