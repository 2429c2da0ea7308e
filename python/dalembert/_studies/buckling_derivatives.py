"""Derivatives of buckling loads with respect to parameters.

The load factor P and its mode x fulfil (A0 + P A1) x = 0 with the stiffness A0 of the unloaded state, and A1, the
derivative of the stiffness along the linear response to the loads. With the left vector y,

    dP = - y^T (dA0 + P dA1) x / (y^T A1 x),

where A1 changes with the response as well.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._core import testing
from dalembert._solving.buckling import ComputeBucklingLoads, _matrix, _start
from dalembert._studies.design_parameters import Parameters, Variant
from dalembert._studies.difference_formulas import CENTRAL
from dalembert._studies.not_differentiable import NotDifferentiable

_EQUAL = 1e-8  # relative distance of factors that are taken as one
_LARGEST = 2000  # unknowns
_PROBE = 1e-3  # displacements that the matrix is differentiated by, relative to the model; rad


class _Pencil:
    """A0 and A1 of one model."""

    def __init__(self, mbs: Any, size: float | None = None) -> None:
        self.start = _start(mbs)
        n = len(self.start.q)
        if testing.redundant_constraints(mbs, self.start)["count"] > 0:
            raise NotDifferentiable(
                "constraint equations follow from others", item="buckling load", advice="remove redundant constraints"
            )
        without = np.asarray(testing.residual(mbs, self.start))
        full = self.start.copy()
        full.load_factor = 1.0
        load = np.asarray(testing.residual(mbs, full)) - without
        self.a0 = _matrix(mbs, self.start).toarray()
        response = -np.linalg.solve(self.a0, load)
        self.size = np.abs(response[:n]).max() if size is None else size
        step = _PROBE * min(1.0, float(testing.extent(mbs))) / self.size
        self.a1 = np.zeros_like(self.a0)
        for multiple, weight in CENTRAL.items():
            state, factor = self.start.copy(), multiple * step
            state.q = testing.compose(mbs, self.start, factor * response[:n])
            state.lam, state.load_factor = factor * response[n:], factor
            self.a1 += weight / step * _matrix(mbs, state).toarray()


def buckling_derivatives(parameters: Parameters, numbers: Sequence[int]) -> dict[int, tuple[float, FloatArray]]:
    """Return {number: (load factor, derivatives)}."""
    base = parameters.base.mbs
    if base.systemData.SystemSize() > _LARGEST:
        raise NotDifferentiable(f"the system has more than {_LARGEST} unknowns", item="buckling load")
    ComputeBucklingLoads(base)  # reports states that are not in balance, and systems that are no structure
    pencil = _Pencil(base)
    known: dict[int, _Pencil] = {id(base): pencil}

    def of(variant: Variant) -> _Pencil:
        if id(variant.mbs) not in known:
            known[id(variant.mbs)] = _Pencil(variant.mbs, pencil.size)
        return known[id(variant.mbs)]

    from scipy.linalg import eig

    inverse, left, right = eig(np.linalg.solve(pencil.a0, pencil.a1), left=True)
    real = [
        i for i in np.argsort(-np.abs(inverse)) if abs(inverse[i].imag) <= 1e-4 * abs(inverse[i]) and inverse[i] != 0
    ]
    found = {}
    for number in numbers:
        if number >= len(real):
            raise ValueError(f"BucklingLoad: number: received {number}, but the system has {len(real)} buckling loads")
        chosen = real[number]
        for other in real:
            if other != chosen and abs(inverse[other] - inverse[chosen]) < _EQUAL * abs(inverse[chosen]):
                raise NotDifferentiable(
                    "it coincides with another one",
                    item=f"buckling load {number}",
                    advice="derivatives of single loads do not exist there",
                )
        factor = -1 / inverse[chosen].real
        x, y = right[:, chosen].real, np.linalg.solve(pencil.a0.T, left[:, chosen].real)
        scale = -y @ pencil.a1 @ x

        def applied(variant: Variant, x: FloatArray = x, y: FloatArray = y, factor: float = factor) -> float:
            own = of(variant)
            return float(y @ (own.a0 @ x + factor * (own.a1 @ x)))

        found[number] = factor, parameters.scalar_rates(applied) / scale
    return found
