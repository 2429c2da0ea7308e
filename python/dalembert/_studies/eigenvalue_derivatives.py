"""Derivatives of eigenvalues of the undamped system at a static equilibrium.

With A = [K, G^T; G, 0] and B = [M, 0; 0, 0], a right and a left vector fulfil A x = mu B x and A^T y = mu B^T y, and

    dmu = y^T (dA - mu dB) x / (y^T B x),

where A and B change with the parameter, and with the equilibrium that it moves.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from dalembert._checks import FloatArray
from dalembert._studies.design_parameters import Parameters, Variant, weighted
from dalembert._studies.difference_formulas import STEP, derivative
from dalembert._studies.not_differentiable import NotDifferentiable

_EQUAL = 1e-8  # relative distance of eigenvalues that are taken as one
_MOVES = 1e-9  # singular values of constraints below this part of the largest one
_LARGEST = 2000  # unknowns


class _Mode(NamedTuple):
    mu: float
    x: FloatArray
    y: FloatArray


def eigenvalue_derivatives(
    parameters: Parameters, z: FloatArray, time: float, changes: FloatArray, modes: Sequence[int]
) -> dict[int, tuple[float, FloatArray]]:
    """Return {mode: (eigenvalue, derivatives)}; changes: derivatives of [q, lambda] of the equilibrium, in rows."""
    base = parameters.base.derivatives
    n = base.sizes[0]
    if len(changes[0]) > _LARGEST:
        raise NotDifferentiable(f"the system has more than {_LARGEST} unknowns", item="eigenvalues")
    system = _Moving(parameters, n)
    found = {}
    for number in modes:
        mode = _mode(system, z, time, number)

        def applied(variant: Variant, mode: _Mode = mode) -> FloatArray:
            return system.applied(variant, z, time, mode)

        rates = parameters.rates(weighted(applied)) @ mode.y
        for k, change in enumerate(changes):
            size = np.abs(change).max()
            if size > 0:

                def along(e: float, change: FloatArray = change, mode: _Mode = mode) -> float:
                    moved = z.copy()
                    moved[:n] = base.compose(z[:n], e * change[:n])
                    moved[3 * n : 3 * n + len(change) - n] += e * change[n:]
                    return float(mode.y @ system.applied(parameters.base, moved, time, mode))

                rates[k] += derivative(along, STEP * system.typical(z) / size)
        found[number] = mode.mu, rates
    return found


class _Moving:
    """The system with inertia, of which static solutions have none."""

    def __init__(self, parameters: Parameters, n: int) -> None:
        self.parameters, self.n = parameters, n
        self.known: dict[int, Any] = {}

    def derivatives(self, variant: Variant) -> Any:
        from dalembert._core import testing

        if id(variant.mbs) not in self.known:
            self.known[id(variant.mbs)] = testing.SystemDerivatives(variant.mbs)
        return self.known[id(variant.mbs)]

    def typical(self, z: FloatArray) -> float:
        """Return a length of the model."""
        from dalembert._core import testing

        return min(1.0, float(testing.extent(self.parameters.base.mbs)))

    def applied(self, variant: Variant, z: FloatArray, time: float, mode: _Mode) -> FloatArray:
        """Return (A - mu B) x at a state."""
        found = self.derivatives(variant)
        found.linearize(self.parameters.shifted(variant, z), time, 0.0)
        result = found.product("K", mode.x[None])[0].copy()
        result[: self.n] -= mode.mu * found.product("M", mode.x[None, : self.n])[0]
        return np.asarray(result)


def _mode(system: _Moving, z: FloatArray, time: float, number: int) -> _Mode:
    """Return an eigenvalue with its vectors, in the directions that the constraints leave."""
    from scipy.linalg import eig

    n, derivatives = system.n, system.derivatives(system.parameters.base)
    derivatives.linearize(z, time, 0.0)
    size = derivatives.sizes[0] + derivatives.sizes[2]
    a = derivatives.product("K", np.eye(size)).T
    mass = derivatives.product("M", np.eye(n)).T
    constraints = a[n:, :n]
    free = np.eye(n)
    if size > n:
        _, singular, directions = np.linalg.svd(constraints)
        free = directions[int(np.sum(singular > _MOVES * singular[0])) :].T
    values, left, right = eig(free.T @ a[:n, :n] @ free, free.T @ mass @ free, left=True)
    finite = np.flatnonzero(np.isfinite(values))
    order = finite[np.argsort(values[finite].real)]
    if number >= len(order):
        raise ValueError(f"Eigenvalue: mode: received {number}, but the system has {len(order)} eigenvalues")
    mu = values[order[number]]
    largest = abs(mu)
    if abs(mu.imag) > _EQUAL * largest:
        raise NotDifferentiable("it is complex", item=f"eigenvalue {number}")
    for other in order:
        if other != order[number] and abs(values[other] - mu) < _EQUAL * largest:
            raise NotDifferentiable(
                f"it coincides with another one (relative distance {abs(values[other] - mu) / largest:.1e})",
                item=f"eigenvalue {number}",
                advice="derivatives of single eigenvalues do not exist there",
            )
    x, y = (free @ vectors[:, order[number]].real for vectors in (right, left))
    shifted = a[:n, :n] - mu.real * mass
    y = y / (y @ mass @ x)
    if size == n:
        return _Mode(float(mu.real), x, y)
    of_x = np.linalg.lstsq(a[:n, n:], -shifted @ x, rcond=None)[0]
    of_y = np.linalg.lstsq(constraints.T, -shifted.T @ y, rcond=None)[0]
    return _Mode(float(mu.real), np.concatenate((x, of_x)), np.concatenate((y, of_y)))
