"""Linearized steps of Runge-Kutta methods, explicit or diagonally implicit, forwards and backwards.

The stages of a step from (q, v, y) of size h are

    X_i = h sum_j a_ij W_j,   V_i = v + h sum_j a_ij A_j,   Y_i = y + h sum_j a_ij Y'_j,   t_i = t + c_i h

with Q_i = q + X_i and W_i = V_i; rotations of Lie-group nodes are Q_i = q o exp(X_i), W_i = T(X_i)^-1 V_i. The unknowns
A_i, Y'_i and multipliers solve r(Q_i, V_i, A_i, Y_i, Y'_i, lambda_i, t_i) = 0, with constraints of accelerations. The
end follows from weights b_i in the same way; in systems with constraints it is projected onto these. The first stage
of ESDIRK methods is the end of the step before.

The projection takes q by - P g(q), repeatedly, with the inverse matrix P of the last stage; so does the linear map.
Changes of P are not taken into account: they are multiplied by violations of constraints within a step.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from dalembert import _core
from dalembert._checks import FloatArray
from dalembert._core import DynamicSolverType
from dalembert._studies.design_parameters import Variant, weighted
from dalembert._studies.difference_formulas import derivative
from dalembert._studies.generalized_alpha import Variation, rotation_operators, skew
from dalembert._studies.moving_steps import SMALL, Moving, Walk
from dalembert._studies.not_differentiable import NotDifferentiable
from dalembert._studies.stored_rows import Rows

_SAME_END = 1e-8  # of a step that is computed again
_VIOLATED = 1e-5  # corrections by the projection, relative to the motion, whose own derivatives are left out
_PROJECTIONS = 4
_MOST_ITERATIONS = 40
_SOLVED, _SLOW = 1e-13, 0.3  # increments relative to accelerations, and their ratio


class Tableau(NamedTuple):
    """Coefficients of a Runge-Kutta method.

    implicit: the diagonal of `a` is not zero, but in the first stage, which is known from the step before.
    """

    a: FloatArray
    b: FloatArray
    implicit: bool = False

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


def _esdirk_4() -> Tableau:
    g = 1 / 4
    rows = [
        [g, g],
        [8611 / 62500, -1743 / 31250, g],
        [5012029 / 34652500, -654441 / 2922500, 174375 / 388108, g],
        [15267082809 / 155376265600, -71443401 / 120774400, 730878875 / 902184768, 2285395 / 8070912, g],
        [82889 / 524892, 0, 15625 / 83664, 69875 / 102672, -2260 / 8211, g],
    ]
    return _tableau(rows, rows[-1])._replace(implicit=True)


# Hairer, Norsett, Wanner: Solving Ordinary Differential Equations I, tables II.1.2 and II.5.2. Butcher: On Runge-Kutta
# processes of high order, Journal of the Australian Mathematical Society 4 (1964). Bogacki, Shampine: A 3(2) pair of
# Runge-Kutta formulas, Applied Mathematics Letters 2 (1989). Kennedy, Carpenter: Additive Runge-Kutta schemes for
# convection-diffusion-reaction equations, Applied Numerical Mathematics 44 (2003). Stages of error estimates alone are
# left out.
TABLEAUS = {
    DynamicSolverType.ExplicitEuler: _tableau([], [1]),
    DynamicSolverType.ExplicitMidpoint: _tableau([[0.5]], [0, 1]),
    DynamicSolverType.RK33: _tableau([[1 / 3], [0, 2 / 3]], [0.25, 0, 0.75]),
    DynamicSolverType.RK44: _tableau([[0.5], [0, 0.5], [0, 0, 1]], [1 / 6, 1 / 3, 1 / 3, 1 / 6]),
    DynamicSolverType.RK67: _butcher_6(),
    DynamicSolverType.ODE23: _tableau([[1 / 2], [0, 3 / 4]], [2 / 9, 1 / 3, 4 / 9]),
    DynamicSolverType.DOPRI5: _dormand_prince(),
    DynamicSolverType.ESDIRK43: _esdirk_4(),
}


def refuse_driven(derivatives: Any, mbs: Any, states: Rows, times: FloatArray, where: str) -> None:
    """Refuse constraints that user functions prescribe in time: solvers take differences for their accelerations."""
    n, n1, m, _ = derivatives.sizes
    driven = derivatives.driven(states[0], float(times[0]), float(times[-1])) if m > 0 else []
    if driven:
        raise NotDifferentiable(
            f"constraints that functions of time prescribe are not available {where}",
            item=_core.testing.describe_row(mbs, n + n1 + driven[0]),
            advice="use generalized alpha without events",
        )


def inverse_tangent_operators(x: FloatArray, v: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return T(x)^-1 of rotation vectors in rows, and derivatives of T(x)^-1 v with respect to x."""
    u = np.einsum("ij,ij->i", x, x)
    small = u < 0.25
    # k = (1 - n/2 cot(n/2))/n^2 and its derivative with respect to n^2
    series = np.array([1 / 12, 1 / 720, 1 / 30240, 1 / 1209600, 1 / 47900160, 691 / 1307674368000])
    powers = u[:, None] ** np.arange(6)
    k, slope = powers @ series, powers[:, :5] @ (series[1:] * np.arange(1, 6))
    if not small.all():
        n = np.sqrt(np.where(small, 1.0, u))
        cot = 1 / np.tan(0.5 * n)
        f, df = 0.5 * n * cot, (0.5 * cot - 0.25 * n * (1 + cot**2)) / (2 * n)
        k = np.where(small, k, (1 - f) / n**2)
        slope = np.where(small, slope, -df / n**2 - (1 - f) / n**4)
    cross = skew(x)
    square = cross @ cross
    inverse = np.eye(3) + 0.5 * cross + k[:, None, None] * square
    along = np.einsum("ij,ij->i", x, v)
    by_x = x[:, :, None] * v[:, None, :] - 2 * v[:, :, None] * x[:, None, :] + along[:, None, None] * np.eye(3)
    by_k = _times(square, v)[:, :, None] * (2 * slope[:, None] * x)[:, None, :]
    return inverse, -0.5 * skew(v) + k[:, None, None] * by_x + by_k


def _times(matrices: FloatArray, x: FloatArray) -> FloatArray:
    return np.asarray((matrices @ x[..., None])[..., 0])


def _transposed(matrices: FloatArray, x: FloatArray) -> FloatArray:
    return np.asarray((x[..., None, :] @ matrices)[..., 0, :])


class _Turn(NamedTuple):
    """Rotations of a stage: exp(-X), T(X), T(X)^-1, d(T^-1 V)/dX, and (1 - g d(T^-1 V)/dX)^-1, one matrix each."""

    back: FloatArray
    tangent: FloatArray
    inverse: FloatArray
    by_x: FloatArray
    solved: FloatArray

    @staticmethod
    def of(x: FloatArray, v: FloatArray, g: float) -> _Turn:
        if len(x) == 0:
            return _NO_TURN
        back, tangent = rotation_operators(x)
        inverse, by_x = inverse_tangent_operators(x, v)
        return _Turn(back, tangent, inverse, by_x, np.asarray(np.linalg.inv(np.eye(3) - g * by_x)))


_NO_TURN = _Turn(*(np.zeros((0, 3, 3)) for _ in range(5)))


class _Stage(NamedTuple):
    """A stage: its state, time, g = h a_ii, rates (W, A, Y'), and what it does to rotations."""

    z: FloatArray
    time: float
    g: float
    rates: tuple[FloatArray, FloatArray, FloatArray]
    turn: _Turn


class RungeKuttaWalk(Walk):
    """Linearized steps of a motion by a Runge-Kutta method."""

    tableau: Tableau
    tolerance: tuple[float, float] = (0.0, 0.0)  # absolute and relative, of step-size control
    _known: tuple[int, list[_Stage], _Turn] | None = None
    _velocity_constraints: Any = None

    # ---- stages ------------------------------------------------------------------------------------------------------

    def stages(self, i: int) -> tuple[list[_Stage], _Turn]:
        """Return the stages of a step, computed again, and rotations at its end; refuse another end than recorded."""
        if self._known is not None and self._known[0] == i:
            return self._known[1:]
        n, n1, t, h = self.n, self.n1, self.tableau, float(self.steps.sizes[i])
        start, made = self.states[i - 1], []
        if t.implicit:
            first = self._first_stage(i)
            made.append(first)
        guess = start[2 * n : 3 * n], start[3 * n + n1 : 3 * n + 2 * n1], start[3 * n + 2 * n1 : self.count]
        if not t.implicit:
            guess = (np.zeros(n), np.zeros(n1), np.zeros(self.m))
        fresh = False
        for s in range(len(made), len(t.b)):
            base = self._combined(start, made, h * t.a[s, :s])
            stage, guess, fresh = self._solved(i, s, base, guess, fresh)
            made.append(stage)
            if not t.implicit:
                guess = (np.zeros(n), np.zeros(n1), np.zeros(self.m))
        turn = self._check_end(i, made)
        self._known = i, made, turn
        return made, turn

    def _first_stage(self, i: int) -> _Stage:
        n = self.n
        z = np.array(self.states[i - 1])
        z[2 * n : 3 * n] = self.steps.a[i]
        time = float(self.times[i - 1])
        rotations = len(self.scheme.rotations)
        turn = _Turn.of(np.zeros((rotations, 3)), z[n : 2 * n][self.scheme.rotations], 0.0)
        return _Stage(z, time, 0.0, self._rates_of(z, turn), turn)

    def _combined(
        self, start: FloatArray, made: list[_Stage], weights: FloatArray
    ) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Return X, V and Y of weighted rates of stages."""
        n, n1 = self.n, self.n1
        x, v, y = np.zeros(n), start[n : 2 * n].copy(), start[3 * n : 3 * n + n1].copy()
        for weight, stage in zip(weights, made, strict=True):
            if weight != 0:
                for part, rate in zip((x, v, y), stage.rates, strict=True):
                    part += weight * rate
        return x, v, y

    def _state(self, i: int, base: Any, guess: Any, g: float) -> tuple[FloatArray, _Turn]:
        """Return the state of a stage with accelerations, rates and multipliers."""
        n, r, start = self.n, self.scheme.rotations, self.states[i - 1]
        x, v, y = base
        a, y_t, lam = guess
        v = v + g * a
        made = x + g * v
        if len(r):
            turned = x[r]
            for _ in range(_MOST_ITERATIONS):
                before, turned = turned, x[r] + g * _times(inverse_tangent_operators(turned, v[r])[0], v[r])
                if np.abs(turned - before).max() <= 1e-16:
                    break
            made[r] = turned
        z = np.concatenate((self.derivatives.compose(start[:n], made), v, a, y + g * y_t, y_t, lam, self.data(i - 1)))
        return z, _Turn.of(made[r], v[r], g)

    def _solved(self, i: int, s: int, base: Any, guess: Any, fresh: bool) -> tuple[_Stage, Any, bool]:
        """Return a stage, solved by Newton's method, its unknowns, and whether there are factors for the next one."""
        n, n1, h, d = self.n, self.n1, float(self.steps.sizes[i]), self.derivatives
        g, time = h * float(self.tableau.a[s, s]), float(self.times[i - 1]) + float(self.tableau.c[s]) * h
        last = np.inf
        for iteration in range(_MOST_ITERATIONS):
            z, turn = self._state(i, base, guess, g)
            if not fresh or g == 0:
                self._linearize(z, time, h, g, turn)
                fresh = True
            u = np.asarray(d.solve(np.asarray(d.residual(z, time, h))[None]))[0]
            guess = guess[0] - u[:n], guess[1] - u[n : n + n1], guess[2] - u[n + n1 :]
            size = np.abs(u[: n + n1]).max(initial=0.0)
            terms = max(np.abs(guess[0]).max(initial=0.0), np.abs(guess[1]).max(initial=0.0))
            if g == 0 or size <= _SOLVED * terms or (size <= 1e-9 * terms and size > 0.5 * last) or size == 0:
                z, turn = self._state(i, base, guess, g)
                return _Stage(z, time, g, self._rates_of(z, turn), turn), guess, fresh
            fresh = size <= _SLOW * last if iteration > 0 else True
            last = size
        raise NotDifferentiable("a stage cannot be solved again", item="time integration", time=time)

    def _rates_of(self, z: FloatArray, turn: _Turn) -> tuple[FloatArray, FloatArray, FloatArray]:
        n, n1, r = self.n, self.n1, self.scheme.rotations
        w = z[n : 2 * n].copy()
        if len(r):
            w[r] = _times(turn.inverse, w[r])
        return w, z[2 * n : 3 * n], z[3 * n + n1 : 3 * n + 2 * n1]

    def _linearize(self, z: FloatArray, time: float, h: float, g: float, turn: _Turn, transposed: bool = False) -> None:
        self.derivatives.linearize(z, time, h)
        self._factorize(time, g, turn, transposed, (g * g, g))

    def _factorize(self, time: float, g: float, turn: _Turn, transposed: bool, of_gaps: tuple[float, float]) -> None:
        """of_gaps: factors of K and D in rows of constraints; without them, these are gradients."""
        blocks = turn.tangent @ turn.solved @ turn.inverse if len(self.scheme.rotations) else None
        failed = self.derivatives.factorize((g * g, g, 1.0, *of_gaps, g, 1.0), blocks, transposed=transposed)
        if failed >= 0:
            raise NotDifferentiable(
                "the matrix of a stage is singular, such as a mass matrix of an explicit method",
                item=_core.testing.describe_row(self.parameters.base.mbs, failed),
                time=time,
            )

    def _check_end(self, i: int, made: list[_Stage]) -> _Turn:
        """Refuse steps that are not those of the method at fixed data; return rotations at the end."""
        n, n1, h, r, d = self.n, self.n1, float(self.steps.sizes[i]), self.scheme.rotations, self.derivatives
        start, end, time = self.states[i - 1], self.end(i), float(self.times[i])
        x, v, y = self._combined(start, made, h * self.tableau.b)
        turn = _Turn.of(x[r], np.zeros((len(r), 3)), 0.0)
        q = np.asarray(d.compose(start[:n], x))
        corrected = 0.0
        if self.m:
            last = made[-1]
            self._factorize(time, last.g, last.turn, False, (0.0, 0.0))
            at = end.copy()
            for rates in (False, True):
                for _ in range(_PROJECTIONS):
                    at[:n], at[n : 2 * n] = q, v
                    step = self._coordinates(self._masked(np.asarray(d.gaps(at, time, rates))[None], rates))[0]
                    q, v = (q, v - step) if rates else (np.asarray(d.compose(q, -step)), v)
                    corrected = max(corrected, float(np.abs(step).max(initial=0.0)))
        found, wanted = np.concatenate((q, v, y)), np.concatenate((end[: 2 * n], end[3 * n : 3 * n + n1]))
        size = np.abs(wanted).max(initial=0.0) + max(
            np.abs(h * rate).max(initial=0.0) for stage in made for rate in stage.rates
        )
        if corrected > _VIOLATED * size:
            raise NotDifferentiable(
                f"constraints are violated by {corrected / size:.1e} of the motion within the step, so that the "
                "projection onto them changes the derivatives",
                item="time integration",
                time=time,
                advice="choose initial velocities that fulfil all constraints and smaller steps, or generalized alpha",
            )
        absolute, relative = self.tolerance
        allowed = _SAME_END * size + 0.1 * (absolute + relative * size) + 0.1 * corrected
        if np.abs(found - wanted).max(initial=0.0) > allowed:
            raise NotDifferentiable(
                "the step is not that of the method, such as where contact or friction switch in it"
                + (", or where explicit methods eliminate fixed coordinates" if self.m else ""),
                item="time integration",
                time=time,
                advice="set simulationSettings.events.ofItems = True"
                + (", or use generalized alpha" if self.m else ""),
            )
        return turn

    # ---- projection ------------------------------------------------------------------------------------------------

    def _coordinates(self, gaps: FloatArray) -> FloatArray:
        """Return P times gaps in rows."""
        zeros = np.zeros((len(gaps), self.n + self.n1))
        return np.asarray(self.derivatives.solve(np.hstack((zeros, gaps))))[:, : self.n]

    def _masked(self, gaps: FloatArray, rates: bool) -> FloatArray:
        """Positions are not projected onto constraints of velocities."""
        return gaps if rates else np.where(self._of_velocities(), 0.0, gaps)

    def _of_velocities(self) -> Any:
        if self._velocity_constraints is None:
            d, first = self.derivatives, self.n + self.n1
            d = _core.testing.SystemDerivatives(self.parameters.base.mbs)
            d.linearize(self.states[0], float(self.times[0]), float(self.steps.sizes[1]), False)
            along = np.cos(np.arange(self.n) + 1.0)[None]
            self._velocity_constraints = np.asarray(d.product("D", along))[0, first:] != 0
        return self._velocity_constraints

    def _gap_values(self, z: FloatArray, time: float, rates: bool) -> Any:
        """Return what parameters.rates evaluates for gaps."""
        first = self.n + self.n1

        def values(variant: Variant) -> FloatArray:
            padded = np.zeros(first + self.m)
            padded[first:] = variant.derivatives.gaps(self.parameters.shifted(variant, z), time, rates)
            return padded

        return weighted(values)

    def _project(
        self, i: int, stage: _Stage, q: FloatArray, v: FloatArray, with_parameters: bool
    ) -> tuple[FloatArray, FloatArray]:
        """Return variations of q and v after the projection."""
        d, z, time, h, first = self.derivatives, self.end(i), float(self.times[i]), float(self.steps.sizes[i]), self.n
        first += self.n1
        d.linearize(stage.z, stage.time, h)
        self._factorize(time, stage.g, stage.turn, False, (0.0, 0.0))
        zeros = np.zeros((len(q), self.n1 + self.m))
        for rates in (False, True):
            d.linearize(z, time, h, rates)
            by_parameters = np.zeros((len(q), self.m))
            if with_parameters:
                by_parameters = self.parameters.rates(self._gap_values(z, time, rates))[:, first:]
            for _ in range(_PROJECTIONS):
                gaps = np.asarray(d.product("K", np.hstack((q, zeros))))[:, first:] + by_parameters
                if rates:
                    v = v - self._coordinates(gaps + np.asarray(d.product("D", v))[:, first:])
                else:
                    q = q - self._coordinates(self._masked(gaps, False))
        return q, v

    def _project_back(
        self, i: int, stage: _Stage, q: FloatArray, v: FloatArray, matrix: FloatArray
    ) -> tuple[FloatArray, FloatArray]:
        d, z, time, h, n = self.derivatives, self.end(i), float(self.times[i]), float(self.steps.sizes[i]), self.n
        first = n + self.n1
        d.linearize(stage.z, stage.time, h)
        self._factorize(time, stage.g, stage.turn, True, (0.0, 0.0))
        zeros = np.zeros((len(q), self.n1 + self.m))
        for rates in (True, False):
            d.linearize(z, time, h, rates)
            total = np.zeros((len(q), first + self.m))
            for _ in range(_PROJECTIONS):
                w = np.asarray(d.solve(np.hstack((v if rates else q, zeros))))
                w[:, :first] = 0.0
                w[:, first:] = self._masked(w[:, first:], rates)
                total += w
                if rates:
                    v = v - d.product("D", w, transposed=True)
                else:
                    q = q - np.asarray(d.product("K", w, transposed=True))[:, :n]
            if rates:
                q = q - np.asarray(d.product("K", total, transposed=True))[:, :n]
            matrix -= self.parameters.weighted_rates(self._gap_values(z, time, rates), total)
        return q, v

    # ---- forwards ----------------------------------------------------------------------------------------------------

    @property
    def _time_varies(self) -> bool:
        return self.steps.moves or self.end_time is not None

    def _by_time(self, z: FloatArray, time: float, h: float) -> FloatArray:
        return np.asarray(derivative(lambda e: self.derivatives.residual(z, time + e, h), SMALL * h))

    def _by_size(self, z: FloatArray, time: float, h: float) -> FloatArray:
        return np.asarray(derivative(lambda e: self.derivatives.residual(z, time, h + e), SMALL * h))

    def _by_data(self, z: FloatArray, time: float, h: float) -> FloatArray:
        rates = [self._along_data(lambda at: self.derivatives.residual(at, time, h), z, each) for each in self.tracked]
        return np.array(rates)

    def _increments(
        self, turn: _Turn, q: FloatArray, x: FloatArray, v: FloatArray, g: float
    ) -> tuple[FloatArray, FloatArray]:
        """Return variations of X, and of Q by increments, from those of q, of X without V, and of V."""
        r = self.scheme.rotations
        made = x + g * v
        if len(r):
            made[:, r] = _times(turn.solved, x[:, r] + g * _times(turn.inverse, v[:, r]))
        found = q + made
        if len(r):
            found[:, r] = _times(turn.back, q[:, r]) + _times(turn.tangent, made[:, r])
        return made, found

    def _vary(self, i: int, change: Moving, sizes: FloatArray, with_parameters: bool) -> Moving:
        """Return the variation at the end of a step; sizes: variations of the size of the step."""
        n, n1, h, tableau, r = self.n, self.n1, float(self.steps.sizes[i]), self.tableau, self.scheme.rotations
        s, d, varies = change.state, self.derivatives, bool(np.any(sizes))
        stages, turn_of_end = self.stages(i)
        rates: list[tuple[FloatArray, FloatArray, FloatArray]] = []
        none = np.zeros((len(s.q), self.m))
        q, v, y, u = s.q, s.v, s.y, np.zeros((len(s.q), n + n1 + self.m))

        def combined(weights: FloatArray) -> list[FloatArray]:
            parts = [np.zeros_like(s.q), s.v.copy(), s.y.copy()]
            for weight, own in zip(weights, rates, strict=False):
                for part, known in zip(parts, own, strict=True):
                    part += h * weight * known
            for weight, stage in zip(weights, stages, strict=False):
                if varies and weight != 0:
                    for part, value in zip(parts, stage.rates, strict=True):
                        part += np.outer(weight * sizes, value)
            return parts

        for k, stage in enumerate(stages):
            if k == 0 and tableau.implicit:
                rates.append((s.v, s.a, s.y_t))
                continue
            x, v, y = combined(tableau.a[k, : k + 1])
            self._linearize(stage.z, stage.time, h, stage.g, stage.turn)
            _, q = self._increments(stage.turn, s.q, x, v, stage.g)
            right = d.product("K", np.hstack((q, y, none))) + d.product("D", v)
            if self._time_varies:
                right += np.outer(change.t + tableau.c[k] * sizes, self._by_time(stage.z, stage.time, h))
            if varies:
                right += np.outer(sizes, self._by_size(stage.z, stage.time, h))
            if with_parameters:
                right += self.parameters.rates(self.parameters.residual_at(stage.z, stage.time, h))
            if self.tracked:
                right += change.data @ self._by_data(stage.z, stage.time, h)
            u = -np.asarray(d.solve(right))
            v = v + stage.g * u[:, :n]
            y = y + stage.g * u[:, n : n + n1]
            made, q = self._increments(stage.turn, s.q, x, v, stage.g)
            w = v.copy()
            if len(r):
                w[:, r] = _times(stage.turn.inverse, v[:, r]) + _times(stage.turn.by_x, made[:, r])
            rates.append((w, u[:, :n], u[:, n : n + n1]))
        if not tableau.implicit:
            x, v, y = combined(tableau.b)
            _, q = self._increments(turn_of_end, s.q, x, v, 0.0)
            u = np.zeros_like(u)
        if self.m:
            q, v = self._project(i, stages[-1], q, v, with_parameters)
        state = Variation(q, v, u[:, :n], np.zeros_like(q), y, u[:, n : n + n1], u[:, n + n1 :])
        return Moving(state, change.t + sizes, sizes.copy(), change.data)

    # ---- backwards ---------------------------------------------------------------------------------------------------

    def _increments_back(
        self, turn: _Turn, of_q: FloatArray, of_w: FloatArray, of_v: FloatArray, g: float
    ) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Return derivatives with respect to q, X without V, and V, from those with respect to Q, W and V."""
        r = self.scheme.rotations
        q, x, v = of_q.copy(), of_q.copy(), of_v + of_w + g * of_q
        if len(r):
            q[:, r] = _transposed(turn.back, of_q[:, r])
            made = _transposed(turn.tangent, of_q[:, r]) + _transposed(turn.by_x, of_w[:, r])
            x[:, r] = _transposed(turn.solved, made)
            v[:, r] = of_v[:, r] + _transposed(turn.inverse, of_w[:, r] + g * x[:, r])
        return q, x, v

    def step_back(self, i: int, bar: Moving, matrix: FloatArray) -> Moving:
        n, n1, h, tableau, d = self.n, self.n1, float(self.steps.sizes[i]), self.tableau, self.derivatives
        stages, turn_of_end = self.stages(i)
        s, parameters = bar.state, self.parameters
        q, v, y, t, data = s.q, s.v, s.y, bar.t.copy(), bar.data.copy()
        if self.m:
            q, v = self._project_back(i, stages[-1], q, v, matrix)
        rows = len(q)
        of_rates = [[np.zeros((rows, n)), np.zeros((rows, n)), np.zeros((rows, n1))] for _ in stages]
        start_q, start_v, start_y = np.zeros((rows, n)), np.zeros((rows, n)), np.zeros((rows, n1))
        end: Any = None

        def add(weights: FloatArray, parts: tuple[FloatArray, FloatArray, FloatArray]) -> None:
            nonlocal start_v, start_y
            start_v, start_y = start_v + parts[1], start_y + parts[2]
            for weight, own in zip(weights, of_rates, strict=False):
                if weight != 0:
                    for part, one in zip(own, parts, strict=True):
                        part += h * weight * one

        if tableau.implicit:
            end = q, v, y, s.lam
            of_rates[-1][1] += s.a
            of_rates[-1][2] += s.y_t
        else:
            of_start, x, v = self._increments_back(turn_of_end, q, np.zeros_like(q), v, 0.0)
            start_q = start_q + of_start
            add(tableau.b, (x, v, y))
        for k in range(len(stages) - 1, 0 if tableau.implicit else -1, -1):
            stage, g = stages[k], stages[k].g
            of_w, of_a, of_y_t = of_rates[k]
            if end is None:
                end = np.zeros((rows, n)), np.zeros((rows, n)), np.zeros((rows, n1)), np.zeros((rows, self.m))
            of_q, of_v, of_y, of_lam = end
            end = None
            self._linearize(stage.z, stage.time, h, g, stage.turn, True)
            _, _, all_v = self._increments_back(stage.turn, of_q, of_w, of_v, g)
            w = np.asarray(d.solve(np.hstack((of_a + g * all_v, of_y_t + g * of_y, of_lam))))
            by_k = np.asarray(d.product("K", w, transposed=True))
            of_q, of_y = of_q - by_k[:, :n], of_y - by_k[:, n : n + n1]
            of_v = of_v - d.product("D", w, transposed=True)
            of_start, x, all_v = self._increments_back(stage.turn, of_q, of_w, of_v, g)
            start_q = start_q + of_start
            add(tableau.a[k, :k], (x, all_v, of_y))
            if self._time_varies:
                t -= w @ self._by_time(stage.z, stage.time, h)
            matrix -= parameters.weighted_rates(parameters.residual_at(stage.z, stage.time, h), w)
            if self.tracked:
                data -= w @ self._by_data(stage.z, stage.time, h).T
        start_a, start_y_t = np.zeros((rows, n)), np.zeros((rows, n1))
        if tableau.implicit:
            of_w, start_a, start_y_t = of_rates[0]
            start_v = start_v + of_w
        zero = np.zeros_like(start_q)
        state = Variation(start_q, start_v, start_a, zero, start_y, start_y_t, np.zeros_like(s.lam))
        return Moving(state, t, np.zeros_like(t), data)

    # ---- what steps of generalized alpha do otherwise ----------------------------------------------------------------

    def fixed_and_size(self, i: int, change: Moving, sized: bool) -> tuple[Moving, Moving | None]:
        none = np.zeros(len(change.t))
        fixed = self._vary(i, change, none, True)
        fixed.h = none
        return fixed, self.size_alone(i) if sized else None

    def size_alone(self, i: int) -> Moving:
        still = Moving.of(Variation.zeros(1, self.n, self.n1, self.m), len(self.tracked))
        return self._vary(i, still, np.ones(1), False)

    def renewed(self, i: int, change: Moving) -> Moving:
        return super().renewed(i, change) if self.tableau.implicit else change

    def renew_back(self, i: int, bar: Moving, matrix: FloatArray) -> None:
        if self.tableau.implicit:
            super().renew_back(i, bar, matrix)
