"""Eigenvalues of small systems with constraints: for the motions that constraints permit, without infinite ones."""

from __future__ import annotations

from typing import Any

import numpy as np

from dalembert._checks import ComplexArray, FloatArray

INFINITE = 1e-12  # inverse eigenvalues that belong to constraints and to coordinates without mass
_LEAST_EQUATION, _LEAST_RANK, _MOST_BY_GAPS = 1e-12, 1e-10, 1e-3  # constraints that act by round-off, or follow
_SPURIOUS = 1e-3  # residual of an eigenvalue that rounding has made of an infinite one
_NEAR = 100.0  # distances to the shift, against the smallest one, at which no such eigenvalue lies
_CORRECTIONS = 2  # steps of Newton's method on pairs


def solve_the_equations(M: Any, G: Any, K: Any, values: ComplexArray, vectors: ComplexArray, shift: float) -> Any:
    """Return which pairs fulfil x^H (lambda^2 M + lambda G + K) x = 0, in which forces of constraints do no work."""
    total, largest = np.zeros(len(values), dtype=complex), np.zeros(len(values))
    for matrix, factor in ((M, values**2), (G, values), (K, np.ones(len(values)))):
        total += factor * np.sum(vectors.conj() * (matrix @ vectors), axis=0)
        largest += np.abs(factor) * np.sum(np.abs(vectors) * (abs(matrix) @ np.abs(vectors)), axis=0)
    distances = np.abs(values - shift)
    return (np.abs(total) <= _SPURIOUS * largest) | (distances <= _NEAR * distances.min(initial=np.inf))


def _null_space(equations: FloatArray, apart: float) -> FloatArray:
    """Return an orthonormal basis, in columns, of the motions that equations, in rows, permit."""
    if len(equations) == 0:
        return np.eye(equations.shape[1])
    sizes = np.linalg.norm(equations, axis=1, keepdims=True)
    equations = equations / np.where(sizes > _LEAST_EQUATION * sizes.max(initial=0.0), sizes, np.inf)
    _, values, motions = np.linalg.svd(equations)
    tolerance = max(_LEAST_RANK, min(_MOST_BY_GAPS, 10 * apart))
    return np.asarray(motions[int((values > tolerance * values.max(initial=0.0)).sum()) :].T)


class ReducedPencil:
    """lambda^2 M + lambda G + K on the motions that constraints permit.

    Infinite eigenvalues of constraints come in chains, whose rounding looks like fast motions: these have none.
    apart: part of the gaps of joints that no motion closes; equations with this degree of dependence are redundant.
    """

    def __init__(self, M: Any, G: Any, K: Any, apart: float) -> None:
        n = M.shape[0]
        whole = K.toarray()
        stiffness, forces, equations, own = whole[:n, :n], whole[:n, n:], whole[n:, :n], whole[n:, n:]
        gives_way = np.abs(own).sum(axis=1) > 0  # its multiplier follows from the gap
        if gives_way.any():
            multipliers = np.linalg.solve(own[np.ix_(gives_way, gives_way)], equations[gives_way])
            stiffness = stiffness - forces[:, gives_way] @ multipliers
        self.basis = _null_space(equations[~gives_way], apart)
        left = _null_space(forces[:, ~gives_way].T, apart)
        if left.shape != self.basis.shape:
            left = self.basis
        first, _, second = np.linalg.svd(left.T @ self.basis)
        left = left @ first @ second  # the same basis if forces and gradients of constraints are the same
        self.M, self.G, self.K = (
            np.asarray(left.T @ matrix @ self.basis) for matrix in (M.toarray(), G.toarray(), stiffness)
        )

    def nearest(self, shift: float) -> tuple[ComplexArray, ComplexArray]:
        """Return all finite eigenvalues and their vectors; LinAlgError: the shift is one of them."""
        f = self.basis.shape[1]
        if f == 0:
            return np.zeros(0, dtype=complex), np.zeros((len(self.basis), 0), dtype=complex)
        damped = self.G + shift * self.M
        x = np.linalg.solve(self.K + shift * damped, -np.hstack([damped, self.M]))
        inverses, vectors = np.linalg.eig(np.vstack([x, shift * x + np.eye(f, 2 * f)]))
        finite = np.abs(inverses) > INFINITE * np.abs(inverses).max()
        values, vectors = shift + 1 / inverses[finite], vectors[:f, finite]
        solves = solve_the_equations(self.M, self.G, self.K, values, vectors, shift)
        values, vectors = values[solves], vectors[:, solves]
        vectors = vectors / np.linalg.norm(vectors, axis=0)
        for i in range(len(values)):
            values[i], vectors[:, i] = self._corrected(values[i], vectors[:, i])
        return values, self.basis @ vectors

    def _corrected(self, value: complex, x: ComplexArray) -> tuple[complex, ComplexArray]:
        """Return a pair after steps of Newton's method; rigid motions, which are next to the shift, cost it digits."""
        first: tuple[complex, Any] = value, x
        if value.imag == 0:
            value, x = value.real, np.asarray(x.real, dtype=x.dtype)  # round-off would make it look like one of a pair
        for _ in range(_CORRECTIONS):
            matrix = value**2 * self.M + value * self.G + self.K
            slope = 2 * value * (self.M @ x) + self.G @ x
            bordered = np.block([[matrix, slope[:, None]], [x.conj()[None, :], np.zeros((1, 1))]])
            try:
                step = np.linalg.solve(bordered, np.append(-matrix @ x, 0))
            except np.linalg.LinAlgError:
                return first
            value, x = value + step[-1], x + step[:-1]
        return (value, x) if abs(value - first[0]) <= _SPURIOUS * abs(value) else first
