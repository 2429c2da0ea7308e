"""Solutions with sparse matrices of the whole system, whose constraints may be redundant."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._core import testing

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


def constrained_factors(matrix: Any, metric: FloatArray, eps: float) -> testing.ProximalSolver:
    """Return the factors of [[A, G^T], [G, -eps D]]; LinAlgError: it is singular.

    matrix: that for eps = 0. metric: the diagonal of D.
    """
    columns = matrix.tocsc()
    factors = testing.ProximalSolver(columns.indptr, columns.indices, metric)
    singular = factors.factorize(columns.data, eps)
    if singular >= 0:
        raise np.linalg.LinAlgError(f"the matrix is singular at unknown {singular}")
    return factors
