"""Derivatives of the start of a time integration: initial values, and initial accelerations and multipliers.

Accelerations and multipliers of the start solve

    M a + f(q, v) + G^T lambda = 0,   d^2 g/dt^2 = (dg/dt)_q v + G a + ... = 0

so that their derivatives follow from the same matrix, and right-hand sides that are differences of both equations at
fixed a and
lambda, with the initial values of each varied model.
"""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np

from dalembert import _core
from dalembert._checks import FloatArray
from dalembert._core import testing
from dalembert._studies.design_parameters import Parameters, Variant, weighted
from dalembert._studies.difference_formulas import derivative
from dalembert._studies.generalized_alpha import Variation, tangent_operators
from dalembert._studies.not_differentiable import NotDifferentiable
from dalembert._studies.recorded_motion import Motion

_REFERENCE = _core.ConfigurationType.Reference
_OPEN = 1e-6  # rates of gaps, relative to those of the initial values, that are more than rounding errors


class Start:
    """The start of a motion."""

    def __init__(self, parameters: Parameters, motion: Motion, consistent: bool) -> None:
        self.parameters, self.motion, self.consistent = parameters, motion, consistent
        base = parameters.base.derivatives
        self.n, self.n1, self.m, _ = base.sizes
        self.z, self.time, self.h = motion.states[0], float(motion.times[0]), motion.scheme.h
        if motion.computes_start:
            self._check(base)

    def _check(self, derivatives: Any) -> None:
        """Refuse a start whose accelerations come from other equations."""
        n = self.n
        found = self.gap_accelerations(derivatives, self.z)
        still = self.z.copy()
        still[2 * n : 3 * n] = 0.0
        terms = np.abs(self.gap_accelerations(derivatives, still)).max(initial=0.0) + np.abs(self.z[2 * n : 3 * n]).max(
            initial=0.0
        )
        round_off = 1e-8 * (
            np.abs(self.z[n : 2 * n]).max(initial=0.0) / self.h + float(testing.extent(self.parameters.base.mbs))
        )
        if np.any(np.abs(found) > 1e-5 * terms + round_off):
            raise NotDifferentiable(
                "accelerations of the start do not fulfil the constraints, which initial velocities "
                "violate, or which are singular there",
                item="initial accelerations",
                time=self.time,
                advice="choose initial velocities that fulfil all constraints",
            )

    def gap_accelerations(self, derivatives: Any, z: FloatArray) -> FloatArray:
        """Return second derivatives of gaps along the motion; of constraints of velocities, first derivatives.

        As in solvers, those by time at a fixed state, of constraints that user functions prescribe, are not contained.
        """
        n = self.n
        if self.m == 0:
            return np.zeros(0)
        derivatives.linearize(z, self.time, self.h, True)
        along = np.zeros((1, n + self.n1 + self.m))
        along[0, :n] = z[n : 2 * n]
        by_q = derivatives.product("K", along)[0, n + self.n1 :]
        by_v = derivatives.product("D", z[None, 2 * n : 3 * n])[0, n + self.n1 :]
        return np.asarray(by_q + by_v)

    def equations(self, derivatives: Any, z: FloatArray) -> FloatArray:
        """Return the residual, with second derivatives of gaps instead of gaps."""
        values = np.asarray(derivatives.residual(z, self.time, self.h))
        values[self.n + self.n1 :] = self.gap_accelerations(derivatives, z)
        return values

    def _state_of(self, variant: Variant) -> FloatArray:
        """Return the start of a varied model, with the same accelerations and multipliers."""
        z = self.z.copy()
        z[: 2 * self.n] = variant.start[: 2 * self.n]
        z[3 * self.n : 3 * self.n + self.n1] = variant.start[2 * self.n :]
        return z

    def variations(self) -> Variation:
        """Return derivatives of the start with respect to all parameters."""
        parameters, n, n1 = self.parameters, self.n, self.n1
        result = Variation.zeros(len(parameters.all), n, n1, self.m)
        moves = np.zeros(len(parameters.all), dtype=bool)
        for k, change in self._initial_values():
            result.q[k], result.v[k], result.y[k] = change[:n], change[n : 2 * n], change[2 * n :]
            moves[k] = bool(np.any(change))
        rotations = self.motion.scheme.rotations
        if len(rotations):
            data = parameters.base.mbs.systemData
            total = data.GetODE2Coordinates(_REFERENCE) + self.z[:n]
            result.q[:, rotations] = np.einsum(
                "bij,kbj->kbi", tangent_operators(total[rotations]), result.q[:, rotations]
            )
        corrections = self._close(result) if self.m else np.zeros((len(parameters.all), 2 * n))
        if not self.motion.computes_start:
            return result
        rates = parameters.rates(weighted(lambda variant: self.equations(variant.derivatives, self._state_of(variant))))
        self._add_corrections(rates, corrections)
        base = parameters.base.derivatives
        self._factorize(base)
        solution = -base.solve(np.hstack((rates[:, :n], np.zeros((len(rates), n1)), rates[:, n + n1 :])))
        result.a[:] = result.b[:] = solution[:, :n]
        if self.motion.tableau is not None:
            result.y_t[:] = rates[:, n : n + n1]
        if np.any(self.z[3 * n + 2 * n1 :]):  # otherwise multipliers of the start are not stored
            result.lam[:] = solution[:, n + n1 :]
        return result

    def _initial_values(self) -> Any:
        """Yield (parameter, derivatives of q, v, y); rotations by their coordinates, with those of the reference."""
        for group in self.parameters.groups:
            total = sum(
                weight * self._values_of(group.variants[multiple]) for multiple, weight in group.formula.items()
            )
            if np.any(np.asarray(total)):  # parameters of nodes are alone in their group
                yield group.members[0], np.asarray(total) / self.parameters.steps[group.members[0]]

    def _values_of(self, variant: Variant) -> FloatArray:
        values = variant.start - self.parameters.base.start
        if variant.shift is not None:
            values[: self.n] -= variant.shift
        return values

    def _factorize(self, derivatives: Any) -> None:
        """Factorize [M, G^T; G, 0]."""
        derivatives.linearize(self.z, self.time, self.h, True)
        failed = derivatives.factorize((0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0))
        if failed >= 0:
            raise NotDifferentiable(
                f"mass matrix and constraints are singular at unknown {failed}",
                item="initial accelerations",
                time=self.time,
                advice="give all coordinates inertia, or set generalizedAlpha.computeInitialAccelerations = False",
            )

    def _close(self, result: Variation) -> FloatArray:
        """Return corrections of q and v, which initial values that parameters vary need to fulfil the constraints.

        They are added to the variations if consistent initial values are asked for; otherwise, there is a warning.
        """
        parameters, n, first = self.parameters, self.n, self.n + self.n1
        count = len(parameters.all)

        def gap_rates(level: bool) -> FloatArray:
            def values(variant: Variant) -> FloatArray:
                padded = np.zeros(first + self.m)
                padded[first:] = variant.derivatives.gaps(self._state_of(variant), self.time, level)
                return padded

            return parameters.rates(weighted(values))[:, first:]

        gaps, speeds = gap_rates(False), gap_rates(True)
        derivatives = parameters.base.derivatives
        derivatives.linearize(self.z, self.time, self.h, True)
        padded = np.hstack((result.q, np.zeros((count, self.n1 + self.m))))
        size = np.abs(derivatives.product("D", result.q)[:, first:]).max(axis=1, initial=0.0)
        size_v = np.abs(derivatives.product("D", result.v)[:, first:]).max(axis=1, initial=0.0) + np.abs(
            derivatives.product("K", padded)[:, first:]
        ).max(axis=1, initial=0.0)
        open_q = np.abs(gaps).max(axis=1, initial=0.0) > _OPEN * np.maximum(size, 1e-3)
        open_v = np.abs(speeds).max(axis=1, initial=0.0) > _OPEN * np.maximum(size_v, 1e-3)
        corrections = np.zeros((count, 2 * n))
        if self.motion.scheme.newmark and not self.consistent:
            open_q[:] = False  # constraints of velocities alone are fulfilled in steps
        if not np.any(open_q | open_v):
            return corrections
        if not self.consistent:
            names = ", ".join(f"'{p.name}'" for p, q, v in zip(parameters.all, open_q, open_v, strict=True) if q or v)
            warnings.warn(
                "ComputeSensitivities: initial values do not fulfil the constraints any more if "
                f"{names} vary, so that the first step jumps; "
                "let a DesignParameter move the initial values as well, or use consistentStart=True",
                stacklevel=6,
            )
            return corrections
        self._factorize(derivatives)
        zeros = np.zeros((count, first))
        corrections[:, :n] = derivatives.solve(np.hstack((zeros, -gaps)))[:, :n]
        padded[:, :n] = corrections[:, :n]
        speeds += derivatives.product("K", padded)[:, first:]
        corrections[:, n:] = derivatives.solve(np.hstack((zeros, -speeds)))[:, :n]
        result.q += corrections[:, :n]
        result.v += corrections[:, n:]
        return corrections

    def _add_corrections(self, rates: FloatArray, corrections: FloatArray) -> None:
        """Add the changes of the equations by corrections of the initial values."""
        derivatives, n = self.parameters.base.derivatives, self.n
        for k in np.flatnonzero(np.any(corrections != 0, axis=1)):
            change = corrections[k]
            size = np.abs(change).max()

            def values(e: float, change: FloatArray = change) -> FloatArray:
                z = self.z.copy()
                z[:n] = derivatives.compose(z[:n], e * change[:n])
                z[n : 2 * n] += e * change[n:]
                return self.equations(derivatives, z)

            rates[k] += derivative(values, 1e-3 / size)
