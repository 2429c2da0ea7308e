"""Lowest eigenvalues and modes of matrices, the shift for those of large ones, and factors for it.

The shift lies a little below zero, so that the shifted matrix is positive definite although rigid motions have no
stiffness. How little is found by Ritz's method, with polynomials as displacements.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._fem.cholesky import Cholesky, NotPositiveDefiniteError
from dalembert._fem.lanczos import Solve, inverse_lanczos
from dalembert._tools.later import scipy

DENSE = 300  # coordinates up to which matrices are dense
SHIFT = 1e-3  # relative to the first squared frequency of a deformation


def rigid_motions(points: FloatArray, origin: Any = (0.0, 0.0, 0.0)) -> FloatArray:
    """Displacements of points for unit translations and unit rotations about the axes through the origin."""
    arms = np.asarray(points, dtype=float) - np.asarray(origin, dtype=float)
    result = np.zeros((len(arms), 3, 6))
    result[:, :, :3] = np.eye(3)
    for axis in range(3):
        result[:, :, 3 + axis] = np.cross(np.eye(3)[axis], arms)
    return result.reshape(-1, 6)


def ritz_frequencies(mass: Any, stiffness: Any, points: FloatArray) -> FloatArray:
    """Squared circular frequencies with displacements that are quadratic in x, y and z: estimates from above."""
    scaled = (points - points.mean(axis=0)) / max(float(np.ptp(points, axis=0).max()), 1e-300)
    x, y, z = scaled.T
    terms = np.stack([np.ones(len(x)), x, y, z, x * x, y * y, z * z, x * y, y * z, x * z], axis=1)
    fields = scipy.linalg.orth(np.kron(terms, np.eye(3)), rcond=1e-8)
    reduced = (fields.T @ (mass @ fields), fields.T @ (stiffness @ fields))
    return np.asarray(scipy.linalg.eigh(reduced[1], reduced[0], eigvals_only=True), dtype=float)


def first_deformation(mass: Any, stiffness: Any, points: FloatArray) -> float:
    """About the first squared circular frequency of a deformation, 1/s^2."""
    values = ritz_frequencies(mass, stiffness, points)
    deformed = values[values > 1e-10 * values[-1]]
    return float(deformed[0] if len(deformed) else max(abs(values[-1]), 1.0))


def factorize(matrix: Any, points: FloatArray, progress: Callable[[str], None]) -> Solve:
    """Return a solver for linear systems with a symmetric matrix; uses LU if it is not positive definite."""
    try:
        return Cholesky(matrix, points, progress).solve
    except NotPositiveDefiniteError:
        progress("the matrix is not positive definite, factorization is repeated by LU")
        return scipy.sparse.linalg.splu(scipy.sparse.csc_matrix(matrix)).solve


def lowest_modes(
    where: str,
    mass: Any,
    stiffness: Any,
    points: FloatArray,
    count: int,
    progress: Callable[[str], None],
    dense: bool = False,
) -> tuple[FloatArray, FloatArray]:
    """Eigenvalues and modes, normalized to unit modal masses; small systems are solved completely."""
    size = mass.shape[0]
    if not 0 < count <= size:
        raise ValueError(f"{where}: {count} modes are asked for, but there are {size} coordinates")
    scale = first_deformation(mass, stiffness, points)
    if dense or size <= DENSE or count > size // 2:
        values, modes = dense_modes(where, mass, stiffness, count)
    else:
        shift = SHIFT * scale
        solve = factorize(stiffness + shift * mass, points, progress)
        values, modes = inverse_lanczos(mass, solve, shift, count)
    refuse_negative(where, values, scale)
    return values, signed(modes)


def dense_modes(where: str, mass: Any, stiffness: Any, count: int) -> tuple[FloatArray, FloatArray]:
    """Eigenvalues and modes of dense matrices."""
    try:
        return scipy.linalg.eigh(stiffness.toarray(), mass.toarray(), subset_by_index=(0, count - 1))
    except scipy.linalg.LinAlgError as error:
        raise ValueError(f"{where}: the mass matrix is not positive definite ({error})") from None


def refuse_negative(where: str, values: FloatArray, scale: float) -> None:
    """Refuse eigenvalues that are negative beyond round-off; `scale` is one of a deformation."""
    if len(values) and values.min() < -1e-2 * scale:
        text = f"the eigenvalue {values.min():g} 1/s^2 is negative; the stiffness matrix is not positive semidefinite"
        raise ValueError(f"{where}: {text}: it is wrong, or does not belong to these nodes")


def signed(modes: FloatArray) -> FloatArray:
    """Modes whose largest entry is positive, so that signs do not depend on the start of an iteration."""
    largest = np.argmax(np.abs(modes) > 0.999 * np.abs(modes).max(axis=0), axis=0)
    return np.asarray(modes * np.where(modes[largest, np.arange(modes.shape[1])] < 0, -1.0, 1.0), dtype=float)
