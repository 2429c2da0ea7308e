"""Solutions with sparse matrices of the whole system, whose constraints may be redundant."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._core import testing

# Replaces the zeros of redundant multipliers, relative to the size of their equations.
_IDLE = 1e-11
# Gaps of joints make redundant equations independent by the square of the gap. This multiple of it, within limits,
# makes their effect negligible, as in solvers.
_MISALIGNED, _LEAST_APART, _MOST_APART = 1e6, 1e-8, 1e-7
_FITS = 1e-11
_REFINEMENTS, _SETTLED = 5, 1e-8  # corrections of the regularization error, and the change after which they end

Solve = Callable[[FloatArray], FloatArray]


def sparse_solver(matrix: Any) -> Solve:
    """Return the function that solves with this square matrix, for vectors or columns; LinAlgError: it is singular.

    Uses the factors of the solvers: SuperLU does not always reject a singular matrix, and may crash the process.
    """
    columns = matrix.tocsc()
    factors = testing.LinearSolver(columns.indptr, columns.indices)
    singular = factors.factorize(columns.data)
    if singular >= 0:
        raise np.linalg.LinAlgError(f"the matrix is singular at unknown {singular}")

    def solve(right: FloatArray) -> FloatArray:
        if right.ndim == 1:
            return factors.solve(right)
        return np.stack([factors.solve(column) for column in right.T], axis=1)

    return solve


class ConstrainedSolver:
    """Solutions with a matrix of n coordinates and of constraints, perhaps redundant ones; LinAlgError: it is singular.

    Springs along the constraints, as stiff as their bodies, do not change the solution; in addition, the same small
    number replaces the zeros of all multipliers.

    apart: part of the gaps of joints that no motion closes, relative to the size of their mechanism, or in rad.
    """

    def __init__(self, matrix: Any, n: int, apart: float = 0.0) -> None:
        from scipy.sparse import block_array, diags_array

        self._matrix, self._n = matrix, n
        if matrix.shape[0] == n:
            self._solve = sparse_solver(matrix)
            return
        resistance, states_itself = np.abs(matrix.diagonal()[:n]), matrix.diagonal()[n:] != 0
        forces, gradients = matrix[:n, n:], matrix[n:, :n]
        acting = abs(forces).sign()
        largest = (diags_array(resistance) @ acting).max(axis=0).toarray().ravel()
        squares = np.asarray(forces.power(2).sum(axis=0)).ravel()
        held = (largest > 0) & (squares > 0) & ~states_itself
        springs = np.where(held, np.divide(largest, squares, out=np.ones(len(squares)), where=squares > 0), 0.0)
        compliance = np.divide(1.0, springs, out=np.where(states_itself, 0.0, 1.0), where=springs > 0)
        self._stiffer = forces @ diags_array(springs)
        idle = _IDLE if apart <= _FITS else min(_MOST_APART, max(_LEAST_APART, _MISALIGNED * apart**2))
        self._solve = sparse_solver(
            matrix
            + block_array([[self._stiffer @ gradients, None], [None, diags_array(-idle * compliance)]], format="csr")
        )

    def _step(self, right: FloatArray) -> FloatArray:
        n = self._n
        return self._solve(np.concatenate([right[:n] + self._stiffer @ right[n:], right[n:]]))

    def left_open(self, right: FloatArray) -> FloatArray:
        """Return the part of the constraints that no motion fulfils."""
        n = self._n
        if len(right) == n:
            return right[n:]
        return np.asarray((right - self._matrix @ self._step(right))[n:])

    def solve(self, right: FloatArray) -> FloatArray:
        """Return the solution; the regularization error is corrected iteratively."""
        n = self._n
        if len(right) == n:
            return self._solve(right)
        x = self._step(right)
        for _ in range(_REFINEMENTS):
            change = self._step(right - self._matrix @ x)
            x = x + change
            if np.linalg.norm(change[:n]) <= _SETTLED * np.linalg.norm(x[:n]):  # the next one is that much smaller
                break
        return x
