"""Restarts of generalized alpha at events in systems with constraints.

Equal steps have velocities across the constraints of C h^2 times the rate of accelerations. After an event, the solver
starts with the state (v+, a1, b), where D are the new data coordinates:

    v1 = P v                           projection: M (v1 - v) + G^T mu = 0, gap rates(q, v1) = 0
    a1 = a(q, v1, D)                   accelerations of the equations of motion
    a2 = a(q2, v1 + tau a1, D)         those at q2 = q + tau v1 + tau^2/2 a1, a moment tau = h/100 later
    s = 100 (a2 - a1)                  their change within a step
    b = a1 + (alpha_m - alpha_f) s     algorithmic accelerations
    v+ = v1 - C h (1 - P2) (v1 + s)    C = beta + (alpha_m - alpha_f)/2 - 1/6; P2 has M and G^T at q2

A step of the size ratio r to the one before starts with v - (1 - r^2) (1 - P) v.

Arnold, Bruels, Cardona: Error analysis of generalized-alpha Lie group time integration methods for constrained
mechanical systems, Numerische Mathematik 129 (2015).
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from dalembert._checks import FloatArray
from dalembert._studies.design_parameters import Variant, weighted
from dalembert._studies.generalized_alpha import Scheme, rotation_operators
from dalembert._studies.not_differentiable import NotDifferentiable

if TYPE_CHECKING:
    from dalembert._studies.moving_steps import Moving, Walk

OF_MASS = (0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)  # weights of derivatives in the matrix of the accelerations
_MOMENT = 1e-2  # part of a step
_PROJECTIONS = 4  # the error of the matrix at another place is a thousandth


@contextmanager
def of_accelerations(*systems: Any) -> Iterator[None]:
    """Take constraints of accelerations."""
    before = [system.acceleration_level for system in systems]
    for system in systems:
        system.acceleration_level = True
    try:
        yield
    finally:
        for system, level in zip(systems, before, strict=True):
            system.acceleration_level = level


def accelerations(derivatives: Any, z: FloatArray, time: float, h: float) -> tuple[FloatArray, FloatArray]:
    """Return accelerations and multipliers of the equations of motion, with constraints of accelerations."""
    n, n1, m, _ = derivatives.sizes
    still = z.copy()
    still[2 * n : 3 * n] = still[3 * n + 2 * n1 : 3 * n + 2 * n1 + m] = 0.0
    found = over_mass(derivatives, still, time, h, np.asarray(derivatives.residual(still, time, h))[None])[0]
    return found[:n], found[n + n1 :]


def over_mass(derivatives: Any, z: FloatArray, time: float, h: float, right: FloatArray) -> FloatArray:
    """Return solutions a and lambda of M a + G^T lambda = - right, G a = - right, in rows."""
    n, n1, _, _ = derivatives.sizes
    factorize_mass(derivatives, z, time, h)
    padded = right.copy()
    padded[:, n : n + n1] = 0.0
    return -np.asarray(derivatives.solve(padded))


def factorize_mass(derivatives: Any, z: FloatArray, time: float, h: float, transposed: bool = False) -> None:
    """Compute derivatives at a state, and factors of [M, G^T; G, 0] or of its transposed."""
    derivatives.linearize(z, time, h)
    if derivatives.factorize(OF_MASS, transposed=transposed) >= 0:
        raise NotDifferentiable("the mass matrix is singular", item="accelerations after an event", time=time)


class Projection(NamedTuple):
    """A projection of velocities: M (v' - v) + G^T mu = 0, gap rates(q, v') = 0.

    state, time: those of the gap rates; forces_at, forces_time: those of M and G^T.
    """

    state: FloatArray
    time: float
    forces_at: FloatArray
    forces_time: float
    h: float
    before: FloatArray
    after: FloatArray
    impulses: FloatArray

    @staticmethod
    def of(
        derivatives: Any,
        state: FloatArray,
        time: float,
        v: FloatArray,
        h: float,
        forces: tuple[FloatArray, float] | None = None,
    ) -> Projection:
        """Project velocities; derivatives: at the level of accelerations."""
        n, n1, m, _ = derivatives.sizes
        at, (forces_at, forces_time) = _still(state, n, n1, m), forces or (state, time)
        factorize_mass(derivatives, _still(forces_at, n, n1, m), forces_time, h)
        after, impulses = v.copy(), np.zeros(m)
        for _ in range(_PROJECTIONS):
            at[n : 2 * n] = after
            rates = np.concatenate((np.zeros(n + n1), derivatives.gaps(at, time, True)))
            step = np.asarray(derivatives.solve(rates[None]))[0]
            after, impulses = after - step[:n], impulses - step[n + n1 :]
        at[n : 2 * n] = after
        return Projection(at, time, _still(forces_at, n, n1, m), forces_time, h, v, after, impulses)

    def _with_impulses(self, walk: Walk) -> FloatArray:
        """Return the state of the forces, with accelerations and multipliers that are impulses within a step."""
        n, z = walk.n, self.forces_at.copy()
        z[2 * n : 3 * n] = (self.after - self.before) / self.h
        z[3 * n + 2 * walk.n1 : walk.count] = self.impulses / self.h
        return z

    def _values(self, walk: Walk) -> Any:
        """Return what parameters.rates evaluates: balances of impulses, and gap rates."""
        n, first, shifted = walk.n, walk.n + walk.n1, walk.parameters.shifted
        loaded = self._with_impulses(walk)

        def values(variant: Variant) -> FloatArray:
            d, found = variant.derivatives, np.zeros(first + walk.m)
            for z, sign in ((loaded, self.h), (self.forces_at, -self.h)):
                found[:n] += sign * np.asarray(d.residual(shifted(variant, z), self.forces_time, self.h))[:n]
            found[first:] = d.gaps(shifted(variant, self.state), self.time, True)
            return found

        return weighted(values)

    def _by_place(self, walk: Walk, x: FloatArray, transposed: bool) -> FloatArray:
        """Return products with the derivative of the balance of impulses by q: M and G^T depend on it."""
        d, n, found = walk.derivatives, walk.n, np.zeros_like(x)
        padded = np.hstack((x, np.zeros((len(x), walk.n1 + walk.m))))
        for z, sign in ((self._with_impulses(walk), self.h), (self.forces_at, -self.h)):
            d.linearize(z, self.forces_time, self.h)
            found += sign * np.asarray(d.product("K", padded, transposed=transposed))[:, :n]
        return found

    def vary(self, walk: Walk, forces_q: FloatArray, q: FloatArray, v: FloatArray) -> FloatArray:
        """Return variations of the projected velocities, with those by all parameters."""
        d, n, first = walk.derivatives, walk.n, walk.n + walk.n1
        by_parameters = walk.parameters.rates(self._values(walk))
        impulses = self._by_place(walk, forces_q, False) + by_parameters[:, :n]
        factorize_mass(d, self.forces_at, self.forces_time, self.h)
        none = np.zeros((len(q), walk.n1 + walk.m))

        def coordinates(right: FloatArray) -> FloatArray:
            return np.asarray(d.solve(right))[:, :n]

        v = v - coordinates(np.hstack((impulses, none)))
        d.linearize(self.state, self.time, self.h, True)
        at_v = np.asarray(d.product("K", np.hstack((q, none))))[:, first:] + by_parameters[:, first:]
        for _ in range(_PROJECTIONS):
            rates = at_v + np.asarray(d.product("D", v))[:, first:]
            v = v - coordinates(np.hstack((np.zeros((len(q), first)), rates)))
        return v

    def back(self, walk: Walk, v: FloatArray, matrix: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Return derivatives with respect to q of the forces, q and v, from those with respect to the result."""
        d, n, first = walk.derivatives, walk.n, walk.n + walk.n1
        factorize_mass(d, self.forces_at, self.forces_time, self.h, True)
        d.linearize(self.state, self.time, self.h, True)
        none, total = np.zeros((len(v), walk.n1 + walk.m)), np.zeros((len(v), first + walk.m))
        for _ in range(_PROJECTIONS):
            w = np.asarray(d.solve(np.hstack((v, none))))
            w[:, :first] = 0.0
            total += w
            v = v - np.asarray(d.product("D", w, transposed=True))
        q = -np.asarray(d.product("K", total, transposed=True))[:, :n]
        w = np.asarray(d.solve(np.hstack((v, none))))
        w[:, n:] = 0.0
        matrix -= walk.parameters.weighted_rates(self._values(walk), w + total)
        return -self._by_place(walk, w[:, :n], True), q, v


class Restart(NamedTuple):
    """The start of steps after an event.

    size: of the next step, which is that of regular steps, or (to_end) the time that was left before the event.
    state: with v1, a1 and multipliers; ahead: the state of a2, at q2; step: from q to q2; v, b: of the next step.
    """

    size: float
    to_end: bool
    time: float
    first: Projection
    state: FloatArray
    ahead: FloatArray
    step: FloatArray
    second: Projection
    left_out: float
    shift: float
    v: FloatArray
    b: FloatArray

    @property
    def tau(self) -> float:
        return _MOMENT * self.size

    @staticmethod
    def of(
        derivatives: Any, scheme: Scheme, z: FloatArray, time: float, h: float, size: float, to_end: bool
    ) -> Restart:
        """Restart at a state that ends a step of size h; derivatives: at the level of accelerations."""
        d, n = derivatives, derivatives.sizes[0]
        tau = _MOMENT * size
        first = Projection.of(d, z, time, z[n : 2 * n], h)
        state = _with_accelerations(d, first.state, time, h)
        v, a = state[n : 2 * n], state[2 * n : 3 * n]
        step = tau * (v + 0.5 * tau * a)
        ahead = state.copy()
        ahead[:n], ahead[n : 2 * n] = d.compose(z[:n], step), v + tau * a
        ahead = _with_accelerations(d, ahead, time + tau, h)
        change = (ahead[2 * n : 3 * n] - a) / _MOMENT
        second = Projection.of(d, first.state, time, v + change, h, (ahead, time + tau))
        shift = 0.0 if scheme.newmark else scheme.alpha_m - scheme.alpha_f
        left_out = scheme.beta + 0.5 * (scheme.alpha_m - scheme.alpha_f) - 1 / 6
        v_end = v - left_out * size * (second.before - second.after)
        return Restart(
            size, to_end, time, first, state, ahead, step, second, left_out, shift, v_end, a + shift * change
        )

    def _sizes(self, walk: Walk, change: Moving) -> FloatArray:
        """Return variations of the size of the next step, from those of time and size of the step before the event."""
        sizes = change.h - change.t if self.to_end else np.zeros_like(change.t)
        if walk.end_time is not None:
            sizes[walk.end_time] += self._part(walk)
        return sizes

    def _part(self, walk: Walk) -> float:
        return 1.0 if self.to_end else self.size / float(walk.times[-1] - walk.times[0])

    def vary(self, walk: Walk, change: Moving) -> Moving:
        """Return the variation of the start of the next step."""
        s, n, r, tau = change.state, walk.n, walk.scheme.rotations, self.tau
        h, sizes = self.first.h, self._sizes(walk, change)
        v1_value, a1_value = self.state[n : 2 * n], self.state[2 * n : 3 * n]
        v1 = self.first.vary(walk, s.q, s.q, s.v)
        a1, y_t = walk.vary_accelerations(self.state, self.time, h, s.q, v1, s.y, change.t, change.data)
        of_tau = _MOMENT * sizes
        step = tau * (v1 + 0.5 * tau * a1) + np.outer(of_tau, v1_value + tau * a1_value)
        q2, v2 = s.q + step, v1 + tau * a1 + np.outer(of_tau, a1_value)
        if len(r):
            back, tangent = rotation_operators(self.step[r])
            q2[:, r] = _times(back, s.q[:, r]) + _times(tangent, step[:, r])
        t2 = change.t + of_tau
        a2, _ = walk.vary_accelerations(self.ahead, self.second.forces_time, h, q2, v2, s.y, t2, change.data)
        within = (a2 - a1) / _MOMENT
        across = v1 + within - self.second.vary(walk, q2, s.q, v1 + within)
        v = v1 - self.left_out * (self.size * across + np.outer(sizes, self.second.before - self.second.after))
        return replace(change, state=replace(s, v=v, a=a1, b=a1 + self.shift * within, y_t=y_t), h=sizes)

    def back(self, walk: Walk, bar: Moving, matrix: FloatArray) -> None:
        """Replace derivatives with respect to the start of the next step by those with respect to the event."""
        s, n, r, tau, h = bar.state, walk.n, walk.scheme.rotations, self.tau, self.first.h
        v1_value, a1_value = self.state[n : 2 * n], self.state[2 * n : 3 * n]
        of_across = -self.left_out * self.size * s.v
        size = bar.h - self.left_out * (s.v @ (self.second.before - self.second.after))
        q2, q, of_sum = self.second.back(walk, -of_across, matrix)
        of_sum = of_sum + of_across
        of_change = (self.shift * s.b + of_sum) / _MOMENT
        v1, a1 = s.v + of_sum, s.a + s.b - of_change
        ahead = walk.accelerations_back(self.ahead, self.second.forces_time, h, of_change, None, matrix)
        q2, v2, q = q2 + ahead.q, ahead.v, q + s.q
        v1, a1 = v1 + v2, a1 + tau * v2
        of_tau = ahead.t + v2 @ a1_value
        step = q2.copy()
        if len(r):
            back, tangent = rotation_operators(self.step[r])
            step[:, r] = _transposed(tangent, q2[:, r])
            q2 = q2.copy()
            q2[:, r] = _transposed(back, q2[:, r])
        q = q + q2
        v1, a1 = v1 + tau * step, a1 + 0.5 * tau**2 * step
        of_tau = of_tau + step @ (v1_value + tau * a1_value)
        size = size + _MOMENT * of_tau
        now = walk.accelerations_back(self.state, self.time, h, a1, s.y_t, matrix)
        forces_q, place, v = self.first.back(walk, v1 + now.v, matrix)
        zero = np.zeros_like(v)
        bar.state = replace(
            s, q=q + now.q + forces_q + place, v=v, a=zero, b=zero, y=s.y + now.y + ahead.y, y_t=np.zeros_like(s.y_t)
        )
        bar.t = bar.t + now.t + ahead.t
        bar.data = bar.data + now.data + ahead.data
        bar.h = np.zeros_like(size)
        if self.to_end:
            bar.t, bar.h = bar.t - size, size
        if walk.end_time is not None:
            matrix[:, walk.end_time] += self._part(walk) * size


def _still(z: FloatArray, n: int, n1: int, m: int) -> FloatArray:
    """Return a state without accelerations and multipliers."""
    made = np.array(z)
    made[2 * n : 3 * n] = 0.0
    made[3 * n + 2 * n1 : 3 * n + 2 * n1 + m] = 0.0
    return made


def _with_accelerations(derivatives: Any, z: FloatArray, time: float, h: float) -> FloatArray:
    """Return a state with the accelerations and multipliers of the equations of motion."""
    (n, n1, m, _), made = derivatives.sizes, z.copy()
    made[2 * n : 3 * n], made[3 * n + 2 * n1 : 3 * n + 2 * n1 + m] = accelerations(derivatives, z, time, h)
    return made


def _times(matrices: FloatArray, x: FloatArray) -> FloatArray:
    return np.asarray((matrices @ x[..., None])[..., 0])


def _transposed(matrices: FloatArray, x: FloatArray) -> FloatArray:
    return np.asarray((x[..., None, :] @ matrices)[..., 0, :])
