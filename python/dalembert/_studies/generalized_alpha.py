"""One step of the generalized alpha method and its linearization, forwards and backwards.

An unknown u = (x, eta, lambda) solves the equations of motion r(q', v', a', y', y_t', lambda') = 0 at the end of the
step, with

    q* = q + h v + h^2 (...),  v* = v + h (...)              prediction, linear in v, a and the algorithmic
    accelerations b
    q' = q* + x,  v' = v* + c_v x,  a' = c_a x               rotations of Lie-group nodes: q' = q* o exp(x)
    y' = y + h/2 y_t + eta,  y_t' = 2/h eta
    b' = (alpha_f a - alpha_m b)/(1 - alpha_m) + (1 - alpha_f)/(1 - alpha_m) a'

Arnold, Bruels: Convergence of the generalized-alpha scheme for constrained mechanical systems, Multibody System
Dynamics 18
(2007). Rotations vary by increments in the body frame: d exp(x) = T(x) dx. The transposed linear maps, applied from
the last step
to the first, give the gradient of an output (discrete adjoint).
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from dalembert._checks import FloatArray
from dalembert._studies.difference_formulas import derivative

_NONE = np.zeros((0, 3), dtype=int)


def skew(x: FloatArray) -> FloatArray:
    """Return skew matrices of rows of vectors."""
    matrix = np.zeros((len(x), 3, 3))
    matrix[:, 0, 1], matrix[:, 0, 2], matrix[:, 1, 2] = -x[:, 2], x[:, 1], -x[:, 0]
    matrix[:, 1, 0], matrix[:, 2, 0], matrix[:, 2, 1] = x[:, 2], -x[:, 1], x[:, 0]
    return matrix


def _cross(x: FloatArray, y: FloatArray) -> FloatArray:
    """Return products of rows of vectors; numpy.cross takes ten times as long for few rows."""
    turned = (1, 2, 0), (2, 0, 1)
    return np.asarray(x[:, turned[0]] * y[:, turned[1]] - x[:, turned[1]] * y[:, turned[0]])


def rotation_operators(x: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return exp(-x) and T(x) of rotation vectors in rows; the angular velocity in the body frame is T(x) dx/dt."""
    n2 = np.einsum("ij,ij->i", x, x)
    small = n2 < 1e-2
    # sin(n)/n, (1 - cos(n))/n^2 and (n - sin(n))/n^3
    s = 1 - n2 / 6 * (1 - n2 / 20 * (1 - n2 / 42 * (1 - n2 / 72)))
    c = 0.5 * (1 - n2 / 12 * (1 - n2 / 30 * (1 - n2 / 56 * (1 - n2 / 90))))
    d = 1 / 6 * (1 - n2 / 20 * (1 - n2 / 42 * (1 - n2 / 72 * (1 - n2 / 110))))
    if not small.all():
        n = np.sqrt(np.where(small, 1.0, n2))
        s = np.where(small, s, np.sin(n) / n)
        c = np.where(small, c, (1 - np.cos(n)) / n**2)
        d = np.where(small, d, (n - np.sin(n)) / n**3)
    k = skew(x)
    square = x[:, :, None] * x[:, None, :]
    square[:, (0, 1, 2), (0, 1, 2)] -= n2[:, None]
    inverse = c[:, None, None] * square - s[:, None, None] * k
    tangent = d[:, None, None] * square - c[:, None, None] * k
    for matrices in (inverse, tangent):
        matrices[:, (0, 1, 2), (0, 1, 2)] += 1.0
    return inverse, tangent


def tangent_operators(x: FloatArray) -> FloatArray:
    """Return T(x)."""
    return rotation_operators(x)[1]


@dataclass
class Variation:
    """Variations of a state, one row each; or the derivatives of outputs with respect to it."""

    q: FloatArray
    v: FloatArray
    a: FloatArray
    b: FloatArray  # algorithmic accelerations
    y: FloatArray
    y_t: FloatArray
    lam: FloatArray

    @staticmethod
    def zeros(rows: int, ode2: int, ode1: int, ae: int) -> Variation:
        return Variation(*(np.zeros((rows, n)) for n in (ode2, ode2, ode2, ode2, ode1, ode1, ae)))

    @property
    def z(self) -> FloatArray:
        """All entries in the order of a state."""
        return np.hstack((self.q, self.v, self.a, self.y, self.y_t, self.lam))

    def add(self, row: int, z: FloatArray) -> None:
        """Add a vector in the order of a state to one row."""
        begin = 0
        for part in (self.q, self.v, self.a, self.y, self.y_t, self.lam):
            part[row] += z[begin : begin + part.shape[1]]
            begin += part.shape[1]


@dataclass(frozen=True)
class Scheme:
    """Coefficients of steps of one size.

    rotations: coordinates of the rotations of Lie-group nodes, a row of three each.
    """

    h: float
    beta: float
    gamma: float
    alpha_m: float
    alpha_f: float
    newmark: bool  # no algorithmic accelerations
    simplified: bool  # increments of rotations are summed up before they are composed
    rotations: NDArray[np.int_] = field(default_factory=lambda: _NONE)

    @property
    def c_v(self) -> float:
        return self.gamma / (self.h * self.beta)

    @property
    def c_a(self) -> float:
        return (1 - self.alpha_m) / (self.h**2 * self.beta * (1 - self.alpha_f))

    @property
    def c_b(self) -> float:
        return 1.0 if self.newmark else (1 - self.alpha_f) / (1 - self.alpha_m)

    @property
    def memory(self) -> tuple[float, float]:
        """Factors of a and b in the prediction of b'."""
        if self.newmark:
            return 0.0, 0.0
        return self.alpha_f / (1 - self.alpha_m), -self.alpha_m / (1 - self.alpha_m)

    @property
    def of_positions(self) -> tuple[float, float]:
        """Factors of a and b in the prediction of q'."""
        h2 = self.h**2
        if self.newmark:
            return h2 * (0.5 - self.beta), 0.0
        m_a, m_b = self.memory
        return h2 * self.beta * m_a, h2 * (0.5 - self.beta + self.beta * m_b)

    @property
    def of_velocities(self) -> tuple[float, float]:
        """Factors of a and b in the prediction of v'."""
        if self.newmark:
            return self.h * (1 - self.gamma), 0.0
        m_a, m_b = self.memory
        return self.h * self.gamma * m_a, self.h * (1 - self.gamma + self.gamma * m_b)

    @cached_property
    def coefficients(self) -> tuple[float, ...]:
        """h, c_v, c_a, c_b, and the factors of a and b in predictions of q', v' and b'."""
        return (self.h, self.c_v, self.c_a, self.c_b, *self.of_positions, *self.of_velocities, *self.memory)

    def increments(self, v: FloatArray, a: FloatArray, b: FloatArray) -> FloatArray:
        """Return predicted increments of q."""
        p_a, p_b = self.of_positions
        return np.asarray(self.h * v + p_a * a + p_b * b)

    def velocities(self, v: FloatArray, a: FloatArray, b: FloatArray) -> FloatArray:
        """Return predicted velocities."""
        r_a, r_b = self.of_velocities
        return np.asarray(v + r_a * a + r_b * b)

    def algorithmic(self, a: FloatArray, b: FloatArray, a_end: FloatArray) -> FloatArray:
        """Return algorithmic accelerations at the end."""
        m_a, m_b = self.memory
        return np.asarray(m_a * a + m_b * b + self.c_b * a_end)

    def increment_of_step(self, v: FloatArray, a: FloatArray, b: FloatArray, a_end: FloatArray) -> list[FloatArray]:
        """Return increments whose compositions with q, one after the other, give q at the end; steps may be in rows."""
        predicted = self._turned(v, a, b)
        x = a_end / self.c_a
        return [predicted + x] if self.simplified else [predicted, x]

    @property
    def _half_step(self) -> float:
        return -0.5 * self.h * self.beta / self.gamma

    def _turned(self, v: FloatArray, a: FloatArray, b: FloatArray) -> FloatArray:
        """Return predicted increments; those of rotations are turned by half a step of the velocity."""
        dq = self.increments(v, a, b)
        if len(self.rotations) and not self.simplified:
            dq, r = dq.copy(), self.rotations
            shape = (*dq.shape[:-1], len(r), 3)
            speed, turned = self.velocities(v, a, b)[..., r].reshape(-1, 3), dq[..., r].reshape(-1, 3)
            dq[..., r] += (self._half_step * _cross(speed, turned)).reshape(shape)
        return dq


@dataclass(frozen=True)
class _BySize:
    """Derivatives of a step by its size, at a fixed start and fixed unknowns."""

    q: FloatArray
    turned: FloatArray  # increments, of which those of rotations are turned by half a step
    v: FloatArray
    a: FloatArray
    y: FloatArray
    y_t: FloatArray


class Turns(NamedTuple):
    """Derivatives of rotations at the end of a step, one matrix for each rotation.

    by_x: with respect to the unknown increment; by_q, by_increment, by_velocity: to rotations at the start, predicted
    increments, and predicted velocities; by_turned: to increments that are turned by half a step.
    """

    by_x: FloatArray
    by_q: FloatArray
    by_increment: FloatArray
    by_velocity: FloatArray
    by_turned: FloatArray

    def of_step(self, number: int) -> Turns:
        return Turns(*(part[number] for part in self))


def turns_of_steps(scheme: Scheme, v: FloatArray, a: FloatArray, b: FloatArray, a_end: FloatArray) -> Turns:
    """Return the derivatives of rotations for several steps, whose starts (v, a, b) and ends are in rows."""
    shape = (len(v), len(scheme.rotations), 3)

    def of(x: FloatArray) -> FloatArray:
        return x[:, scheme.rotations].reshape(-1, 3)

    def steps(matrices: FloatArray) -> FloatArray:
        return matrices.reshape(*shape, 3)

    dq, x = of(scheme.increments(v, a, b)), of(a_end / scheme.c_a)
    if scheme.simplified:
        turn, blocks = (steps(part) for part in rotation_operators(dq + x))
        return Turns(blocks, turn, blocks, np.zeros_like(blocks), blocks)
    speed = of(scheme.velocities(v, a, b))
    turn, blocks = rotation_operators(x)
    first_turn, first_blocks = rotation_operators(dq + scheme._half_step * _cross(speed, dq))
    by_turned = turn @ first_blocks
    found = (
        blocks,
        turn @ first_turn,
        by_turned @ (np.eye(3) + scheme._half_step * skew(speed)),
        by_turned @ (-scheme._half_step * skew(dq)),
        by_turned,
    )
    return Turns(*(steps(part) for part in found))


class LinearStep:
    """The linearized step from a state to its end, where the derivatives of the equations have been computed.

    derivatives: a SystemDerivatives at the end of the step.
    """

    def __init__(self, scheme: Scheme, derivatives: Any, turns: Turns) -> None:
        self.scheme, self.derivatives, self.turns = scheme, derivatives, turns

    def factorize(self, transposed: bool) -> int:
        s = self.scheme
        factors = (1.0, s.c_v, s.c_a, 1.0, s.c_v, 1.0, 2 / s.h)
        found = self.derivatives.factorize(
            factors, self.turns.by_x if len(s.rotations) else None, s.beta * s.h**2, transposed
        )
        return int(found)

    def _times(self, matrices: FloatArray, x: FloatArray) -> FloatArray:
        """Return M x for the rotations in rows of x."""
        return np.asarray((matrices @ x[..., None])[..., 0])

    def forward(self, start: Variation, rates: FloatArray, by_size: _BySize | None = None) -> Variation:
        """Return variations at the end; rates: derivatives of the residual with respect to the parameters, in rows."""
        s, d, r = self.scheme, self.derivatives, self.scheme.rotations
        p_a, p_b = s.of_positions
        dq = s.h * start.v + p_a * start.a + p_b * start.b
        v = s.velocities(start.v, start.a, start.b)
        q = start.q + dq
        if by_size is not None:
            q = q + by_size.q
        if len(r):
            q[:, r] = (
                self._times(self.turns.by_q, start.q[:, r])
                + self._times(self.turns.by_increment, dq[:, r])
                + self._times(self.turns.by_velocity, v[:, r])
            )
            if by_size is not None:
                q[:, r] += self._times(self.turns.by_turned, by_size.turned[r])
        y = start.y + 0.5 * s.h * start.y_t
        n, n1 = q.shape[1], y.shape[1]
        if by_size is not None:
            v, y = v + by_size.v, y + by_size.y
            rates = rates.copy()
            rates[:, :n] += d.product("M", by_size.a[None])[:, :n]
            rates[:, n : n + n1] -= by_size.y_t
        right = d.product("K", np.hstack((q, y, np.zeros((len(q), start.lam.shape[1]))))) + d.product("D", v) + rates
        u = -d.solve(right)
        x, eta = u[:, :n], u[:, n : n + n1]
        moved = x.copy()
        if len(r):
            moved[:, r] = self._times(self.turns.by_x, x[:, r])
        a, y_t = s.c_a * x, 2 / s.h * eta
        if by_size is not None:
            a, y_t = a + by_size.a, y_t + by_size.y_t
        return Variation(q + moved, v + s.c_v * x, a, s.algorithmic(start.a, start.b, a), y + eta, y_t, u[:, n + n1 :])

    def forward_by_size(
        self,
        start: Variation,
        rates: FloatArray,
        v: FloatArray,
        a: FloatArray,
        b: FloatArray,
        a_end: FloatArray,
        y_t: FloatArray,
        y_t_end: FloatArray,
    ) -> Variation:
        """Return the variation of the end by the size of the step.

        start: variation of the start; rates: derivative of the residual at a fixed state, both in one row.
        """
        s = self.scheme
        x, step = a_end / s.c_a, 1e-3 * s.h

        def of(function: Any) -> FloatArray:
            return np.asarray(derivative(lambda e: function(replace(s, h=s.h + e)), step))

        explicit = _BySize(
            q=of(lambda at: at.increments(v, a, b)),
            turned=of(lambda at: at._turned(v, a, b)),
            v=of(lambda at: at.velocities(v, a, b) + at.c_v * x),
            a=of(lambda at: at.c_a * x),
            y=0.5 * y_t,
            y_t=-y_t_end / s.h,
        )
        return self.forward(start, rates, explicit)

    def backward(self, end: Variation) -> tuple[Variation, FloatArray]:
        """Return derivatives with respect to the start of the step, and w: parameters contribute - w dr/dp."""
        s = self.scheme
        turns = self.turns[:4] if len(s.rotations) else None
        ends = end.q, end.v, end.a, end.b, end.y, end.y_t, end.lam
        q, v, a, b, y, y_t, w = self.derivatives.step_back(s.coefficients, ends, turns)
        return Variation(q, v, a, b, y, y_t, np.zeros_like(end.lam)), w
