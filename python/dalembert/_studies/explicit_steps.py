"""Linearized steps of explicit Runge-Kutta methods, forwards and backwards.

The stages of a step from (q, v, y) of size h are

    Q_i = q + h sum_j a_ij V_j,   V_i = v + h sum_j a_ij A_j,   Y_i = y + h sum_j a_ij Y'_j,   t_i = t + c_i h

with r(Q_i, V_i, A_i, Y_i, Y'_i, t_i) = 0, and its end is q' = q + h sum_i b_i V_i, and so on. From K, D and M at a
stage follow dA_i = - M^-1 (K dQ_i + D dV_i + dr/dp + dr/dt dt_i), and transposed.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from dalembert import _core
from dalembert._checks import FloatArray
from dalembert._core import DynamicSolverType
from dalembert._studies.design_parameters import describe
from dalembert._studies.difference_formulas import derivative
from dalembert._studies.generalized_alpha import Variation
from dalembert._studies.moving_steps import SMALL, Moving, Walk
from dalembert._studies.not_differentiable import NotDifferentiable

_SAME_END = 1e-8  # of a step that is computed again
_MASS = (0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0)


class Tableau(NamedTuple):
    """Coefficients of a Runge-Kutta method."""

    a: FloatArray
    b: FloatArray

    @property
    def c(self) -> FloatArray:
        return np.asarray(self.a.sum(axis=1))


def _tableau(rows: list[list[float]], b: list[float]) -> Tableau:
    a = np.zeros((len(b), len(b)))
    for i, row in enumerate(rows, 1):
        a[i, : len(row)] = row
    return Tableau(a, np.array(b))


def _butcher_6() -> Tableau:
    r = np.sqrt(5.0)
    low = 0.5 - r / 10
    rows = [
        [low],
        [-r / 10, 0.5 + r / 5],
        [7 * r / 20 - 0.75, r / 4 - 0.25, 1.5 - 7 * r / 10],
        [1 / 12 - r / 60, 0, 1 / 6, 7 * r / 60 + 0.25],
        [1 / 12 + r / 60, 0, 0.75 - 5 * r / 12, 1 / 6, 3 * r / 10 - 0.5],
        [1 / 6, 0, 25 * r / 12 - 55 / 12, -7 * r / 12 - 25 / 12, 5 - 2 * r, 2.5 + r / 2],
    ]
    return _tableau(rows, [1 / 12, 0, 0, 0, 5 / 12, 5 / 12, 1 / 12])


def _dormand_prince() -> Tableau:
    rows = [
        [1 / 5],
        [3 / 40, 9 / 40],
        [44 / 45, -56 / 15, 32 / 9],
        [19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729],
        [9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656],
    ]
    return _tableau(rows, [35 / 384, 0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84])


# Hairer, Norsett, Wanner: Solving Ordinary Differential Equations I, tables II.1.2 and II.5.2. Butcher: On Runge-Kutta
# processes of high order, Journal of the Australian Mathematical Society 4 (1964). Bogacki, Shampine: A 3(2) pair of
# Runge-Kutta formulas, Applied Mathematics Letters 2 (1989). Stages of error estimates alone are left out.
TABLEAUS = {
    DynamicSolverType.ExplicitEuler: _tableau([], [1]),
    DynamicSolverType.ExplicitMidpoint: _tableau([[0.5]], [0, 1]),
    DynamicSolverType.RK33: _tableau([[1 / 3], [0, 2 / 3]], [0.25, 0, 0.75]),
    DynamicSolverType.RK44: _tableau([[0.5], [0, 0.5], [0, 0, 1]], [1 / 6, 1 / 3, 1 / 3, 1 / 6]),
    DynamicSolverType.RK67: _butcher_6(),
    DynamicSolverType.ODE23: _tableau([[1 / 2], [0, 3 / 4]], [2 / 9, 1 / 3, 4 / 9]),
    DynamicSolverType.DOPRI5: _dormand_prince(),
}


def refuse_for_stages(derivatives: Any, mbs: Any) -> None:
    """Refuse systems whose stages have more than accelerations of free coordinates."""
    n, n1, m, _ = derivatives.sizes
    if m > 0:
        raise NotDifferentiable(
            "constraints are not available with explicit methods",
            item=_core.testing.describe_row(mbs, n + n1),
            advice="use generalized alpha, or minimal coordinates",
        )
    if len(derivatives.rotations):
        node = next(
            number
            for number in range(mbs.systemData.NumberOfNodes())
            if derivatives.rotations[0] in mbs.systemData.GetNodeLTGODE2(number)
        )
        raise NotDifferentiable(
            "rotation vectors of Lie-group nodes are not available with explicit methods",
            item=describe(mbs, _core.NodeIndex(node)),
            advice="use generalized alpha, or a node with Euler or Tait-Bryan angles",
        )


class ExplicitWalk(Walk):
    """Linearized steps of a motion by an explicit Runge-Kutta method."""

    tableau: Tableau

    def stages(self, i: int, h: float | None = None) -> list[tuple[FloatArray, float]]:
        """Return the states, with accelerations and rates, and times of all stages of a step."""
        n, n1, d = self.n, self.n1, self.derivatives
        start, data = self.states[i - 1], self.data(i - 1)
        h = float(self.steps.sizes[i]) if h is None else h
        q, v, y = start[:n], start[n : 2 * n], start[3 * n : 3 * n + n1]
        made: list[tuple[FloatArray, float]] = []
        for s in range(len(self.tableau.b)):
            z = np.zeros(len(start))
            z[: 2 * n], z[3 * n : 3 * n + n1] = np.concatenate((q, v)), y
            for j, (other, _) in enumerate(made):
                factor = h * self.tableau.a[s, j]
                if factor != 0:
                    z[:n] += factor * other[n : 2 * n]
                    z[n : 2 * n] += factor * other[2 * n : 3 * n]
                    z[3 * n : 3 * n + n1] += factor * other[3 * n + n1 : 3 * n + 2 * n1]
            if self.nd:
                z[self.count :] = data
            time = float(self.times[i - 1]) + float(self.tableau.c[s]) * h
            residual = np.asarray(d.residual(z, time, h))
            d.linearize(z, time, h)
            self._factorize(False, time)
            z[2 * n : 3 * n] = -np.asarray(d.solve(self._padded(residual[None])))[0, :n]
            z[3 * n + n1 : 3 * n + 2 * n1] = residual[n : n + n1]
            made.append((z, time))
        return made

    def _padded(self, rows: FloatArray) -> FloatArray:
        padded = np.zeros((len(rows), self.n + self.n1 + self.m))
        padded[:, : self.n] = rows[:, : self.n]
        return padded

    def _factorize(self, transposed: bool, time: float) -> None:
        failed = self.derivatives.factorize(_MASS, transposed=transposed)
        if failed >= 0:
            raise NotDifferentiable(
                "the mass matrix is singular",
                item=_core.testing.describe_row(self.parameters.base.mbs, failed),
                time=time,
            )

    def _by_time(self, z: FloatArray, time: float, h: float) -> FloatArray:
        return np.asarray(derivative(lambda e: self.derivatives.residual(z, time + e, h), SMALL * h))

    def _by_data(self, z: FloatArray, time: float, h: float) -> FloatArray:
        rates = [self._along_data(lambda at: self.derivatives.residual(at, time, h), z, each) for each in self.tracked]
        return np.array(rates)

    def check_ends(self) -> None:
        """Refuse steps that are not those of the method at fixed data."""
        n, n1 = self.n, self.n1
        for i in range(1, len(self.times)):
            h, start, end = float(self.steps.sizes[i]), self.states[i - 1], self.states[i]
            found = self.stages(i)
            rates = [np.concatenate((z[n : 3 * n], z[3 * n + n1 : 3 * n + 2 * n1])) for z, _ in found]
            parts = np.concatenate((start[: 2 * n], start[3 * n : 3 * n + n1])) + h * self.tableau.b @ np.array(rates)
            wanted = np.concatenate((end[: 2 * n], end[3 * n : 3 * n + n1]))
            size = np.abs(wanted).max(initial=0.0) + np.abs(h * np.array(rates)).max(initial=0.0)
            if np.abs(parts - wanted).max(initial=0.0) > _SAME_END * size:
                raise NotDifferentiable(
                    "the step is not that of the method, such as where contact or friction switch in it",
                    item="time integration",
                    time=float(self.times[i]),
                    advice="set simulationSettings.events.ofItems = True",
                )

    def _vary(self, i: int, change: Moving, sizes: FloatArray, with_parameters: bool) -> Moving:
        """Return the variation at the end of a step; sizes: variations of the size of the step."""
        n, n1, h, tableau = self.n, self.n1, float(self.steps.sizes[i]), self.tableau
        s, d = change.state, self.derivatives
        found = self.stages(i)
        rates: list[tuple[FloatArray, FloatArray, FloatArray]] = []
        for k, (z, time) in enumerate(found):
            q, v, y = s.q.copy(), s.v.copy(), s.y.copy()
            for j, (other, _) in enumerate(found[:k]):
                factor = float(tableau.a[k, j])
                if factor == 0:
                    continue
                for part, known, value in zip((q, v, y), rates[j], self._rates_of(other), strict=True):
                    part += h * factor * known + np.outer(factor * sizes, value)
            d.linearize(z, time, h)
            self._factorize(False, time)
            by_time = self._by_time(z, time, h)
            right = d.product("K", np.hstack((q, y))) + d.product("D", v)
            right += np.outer(change.t + tableau.c[k] * sizes, by_time)
            if with_parameters:
                right += self.parameters.rates(self.parameters.residual_at(z, time, h))
            if self.tracked:
                by_data = self._by_data(z, time, h)
                right += change.data @ by_data
            a = -np.asarray(d.solve(self._padded(right)))[:, :n]
            rates.append((v, a, right[:, n : n + n1]))
        parts = [s.q.copy(), s.v.copy(), s.y.copy()]
        for weight, of_stage, (z, _) in zip(tableau.b, rates, found, strict=True):
            for part, one, value in zip(parts, of_stage, self._rates_of(z), strict=True):
                part += h * weight * one + np.outer(weight * sizes, value)
        zero = np.zeros_like(s.q)
        state = Variation(parts[0], parts[1], zero, zero.copy(), parts[2], np.zeros_like(s.y), np.zeros_like(s.lam))
        return Moving(state, change.t + sizes, sizes.copy(), change.data)

    def _rates_of(self, z: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        n, n1 = self.n, self.n1
        return z[n : 2 * n], z[2 * n : 3 * n], z[3 * n + n1 : 3 * n + 2 * n1]

    # ---- what steps of generalized alpha do otherwise ----------------------------------------------------------------

    def fixed_and_size(self, i: int, change: Moving, sized: bool) -> tuple[Moving, Moving | None]:
        none = np.zeros(len(change.t))
        fixed = self._vary(i, change, none, True)
        fixed.h = none
        return fixed, self.size_alone(i) if sized else None

    def size_alone(self, i: int) -> Moving:
        still = Moving.of(Variation.zeros(1, self.n, self.n1, self.m), len(self.tracked))
        return self._vary(i, still, np.ones(1), False)

    def step_back(self, i: int, bar: Moving, matrix: FloatArray) -> Moving:
        n, n1, h, tableau, d = self.n, self.n1, float(self.steps.sizes[i]), self.tableau, self.derivatives
        found, s = self.stages(i), bar.state
        count = len(found)
        of_rates = [[h * b * part for part in (s.q, s.v, s.y)] for b in tableau.b]
        q, v, y, t, data = s.q.copy(), s.v.copy(), s.y.copy(), bar.t.copy(), bar.data.copy()
        for k in range(count - 1, -1, -1):
            z, time = found[k]
            d.linearize(z, time, h)
            self._factorize(True, time)
            w = -np.asarray(d.solve(self._padded(of_rates[k][1])))
            w[:, n:] = 0.0
            w[:, n : n + n1] = of_rates[k][2]
            by_k = d.product("K", w, transposed=True)
            stage = [by_k[:, :n], of_rates[k][0] + d.product("D", w, transposed=True), by_k[:, n : n + n1]]
            by_time = self._by_time(z, time, h)
            t += w @ by_time
            matrix += self.parameters.weighted_rates(self.parameters.residual_at(z, time, h), w)
            if self.tracked:
                by_data = self._by_data(z, time, h)
                data += w @ by_data.T
            for part, one in zip((q, v, y), stage, strict=True):
                part += one
            for j in range(k):
                factor = h * float(tableau.a[k, j])
                if factor != 0:
                    for part, one in zip(of_rates[j], stage, strict=True):
                        part += factor * one
        zero = np.zeros_like(q)
        state = Variation(q, v, zero, zero.copy(), y, np.zeros_like(s.y_t), np.zeros_like(s.lam))
        return Moving(state, t, np.zeros_like(t), data)

    def renewed(self, i: int, change: Moving) -> Moving:
        return change

    def renew_back(self, i: int, bar: Moving, matrix: FloatArray) -> None:
        pass
