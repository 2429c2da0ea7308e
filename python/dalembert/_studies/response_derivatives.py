"""Derivatives of frequency responses with respect to parameters.

A load r_b exp(i w t) moves the state by X exp(i w t) about the static equilibrium, and a sensor by H exp(i w t):

    Z X = - r_b,   Z = K + i w D - w^2 M,   H = s^T X,   s = s_q + i w s_v - w^2 s_a.

With Z^T y = s,  dH = ds^T X - y^T (dZ X + dr_b)  and  d|H| = Re(conj(H) dH)/|H|. Z and s are polynomials of w.
"""

from __future__ import annotations

import copy
from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np

from dalembert import _core
from dalembert._checks import FloatArray
from dalembert._core import testing
from dalembert._studies.design_parameters import Parameters, Variant, describe
from dalembert._studies.difference_formulas import STEP, derivative
from dalembert._studies.differentiable_outputs import entries_read
from dalembert._studies.not_differentiable import NotDifferentiable

_AMPLITUDES = ("load", "loadVector")
_ZERO = 1e-12  # amplitude, relative to its terms, that has no direction

Response = tuple[int, int, int, float | str]  # the frequency, or the name of the parameter that it is


class _Harmonic:
    """Matrices of one model for one response."""

    def __init__(self, mbs: Any, response: Response, entries: Sequence[int]) -> None:
        self.load, self.sensor, self.component, _ = response
        self.derivatives, self.entries = testing.SystemDerivatives(mbs), list(entries)
        self.n, _, self.m, _ = self.derivatives.sizes
        unloaded = copy.copy(mbs)
        item = _core.LoadIndex(self.load)
        entries_of = unloaded.GetLoad(item)
        name = next((each for each in _AMPLITUDES if each in entries_of), None)
        if name is None:
            raise NotDifferentiable("it has no value that could oscillate", item=describe(mbs, item))
        unloaded.SetLoadParameter(
            item, name, np.zeros(np.shape(entries_of[name])) if np.ndim(entries_of[name]) else 0.0
        )
        unloaded.Assemble()
        self.unloaded = testing.SystemDerivatives(unloaded)

    def terms(self, z: FloatArray, time: float, steps: FloatArray, w: float) -> tuple[Any, FloatArray, Any]:
        """Return Z, r_b and s at a state and a circular frequency."""
        d, n, size = self.derivatives, self.n, self.n + self.m
        d.linearize(z, time, 0.0)
        matrix = d.product("K", np.eye(size)).T.astype(complex)
        matrix[:, :n] += 1j * w * d.product("D", np.eye(n)).T
        matrix[:n, :n] -= w**2 * d.product("M", np.eye(n)).T
        load = np.asarray(d.residual(z, time, 0.0)) - np.asarray(self.unloaded.residual(z, time, 0.0))
        by = d.sensor_gradient(self.sensor, z, time, self.entries, [float(steps[i]) for i in self.entries])[
            self.component
        ]
        s = np.zeros(size, dtype=complex)
        for i, value in zip(self.entries, by, strict=True):
            if i < 3 * n:
                s[i % n] += value * (1.0, 1j * w, -(w**2))[i // n]
            else:
                s[n + i - 3 * n] += value
        return matrix, load, s


def response_derivatives(
    parameters: Parameters,
    z: FloatArray,
    time: float,
    changes: FloatArray,
    steps: FloatArray,
    responses: Sequence[Response],
) -> dict[Response, tuple[float, FloatArray]]:
    """Return {response: (amplitude, derivatives)}; changes: derivatives of [q, lambda] of the equilibrium, in rows."""
    base, n = parameters.base, parameters.base.derivatives.sizes[0]
    found = {}
    for response in responses:
        _, sensor, component, given = response
        column = next((k for k, parameter in enumerate(parameters.all) if parameter.name == given), None)
        omega = float(given) if column is None else parameters.all[column].value
        if omega < 0:
            raise ValueError(f"FrequencyResponse: omega: parameter '{given}' is {omega:g}, but expected 0 or more")
        values = len(np.asarray(base.derivatives.sensor(sensor, z, time)))
        if not 0 <= component < values:
            raise ValueError(f"FrequencyResponse: component: received {component}, but the sensor has {values} values")
        entries = entries_read(base.mbs, sensor, parameters.reads[sensor])
        known: dict[int, _Harmonic] = {}

        def terms(
            variant: Variant,
            at: FloatArray,
            more: float = 0.0,
            known: dict[int, _Harmonic] = known,
            response: Response = response,
            entries: Sequence[int] = entries,
            omega: float = omega,
        ) -> tuple[Any, FloatArray, Any]:
            if id(variant.mbs) not in known:
                known[id(variant.mbs)] = _Harmonic(variant.mbs, response, entries)
            return known[id(variant.mbs)].terms(at, time, steps, omega + more)

        matrix, load, s = terms(base, z)
        x, y = np.linalg.solve(matrix, -load), np.linalg.solve(matrix.T, s)
        total = complex(s @ x)
        if abs(total) <= _ZERO * float(np.abs(s * x).sum()) or total == 0:
            raise NotDifferentiable("the amplitude is zero, where it has a kink", item="frequency response")
        factor = total.conjugate() / abs(total)

        def moved(
            variant: Variant,
            at: FloatArray,
            more: float = 0.0,
            terms: Any = terms,
            x: Any = x,
            y: Any = y,
            factor: complex = factor,
        ) -> float:
            own_matrix, own_load, own_s = terms(variant, at, more)
            return float((factor * (own_s @ x - y @ (own_matrix @ x + own_load))).real)

        rates = parameters.scalar_rates(lambda variant, moved=moved: moved(variant, parameters.shifted(variant, z)))  # type: ignore[misc]
        if column is not None:
            rates[column] += derivative(partial(moved, base, z), STEP * (omega or 1.0))
        for k, change in enumerate(changes):
            size = float(np.abs(change[:n]).max(initial=0.0))
            if size > 0:

                def along(e: float, change: FloatArray = change, moved: Any = moved) -> float:
                    at = z.copy()
                    at[:n] = base.derivatives.compose(z[:n], e * change[:n])
                    at[3 * n : 3 * n + len(change) - n] += e * change[n:]
                    return float(moved(base, at))

                rates[k] += derivative(along, STEP * min(1.0, float(testing.extent(base.mbs))) / size)
        found[response] = abs(total), rates
    return found
