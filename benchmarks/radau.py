"""RADAU IIA of fifth order, which is not among the solvers, against ESDIRK43: what an error at the end takes.

`python benchmarks/radau.py` prints the table of the page about solvers. The method is written here in numpy, with the
equations, projections, norms and tolerances of ESDIRK43, and residuals and tangents of the package. A pair is a real
and a complex factorization, of the tangent at the start of a step; an evaluation is that of one stage.
E. Hairer, G. Wanner: Solving Ordinary Differential Equations II, section IV.8.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from scipy.linalg import lu_factor, lu_solve
from work_precision import Solver, by_tolerance, falling_beam, flyballs, squeezer

import dalembert as exu
from dalembert import testing

ROOT = np.sqrt(6)
A = np.array(
    [
        [(88 - 7 * ROOT) / 360, (296 - 169 * ROOT) / 1800, (-2 + 3 * ROOT) / 225],
        [(296 + 169 * ROOT) / 1800, (88 + 7 * ROOT) / 360, (-2 - 3 * ROOT) / 225],
        [(16 - ROOT) / 36, (16 + ROOT) / 36, 1 / 9],
    ]
)
NODES = np.array([(4 - ROOT) / 10, (4 + ROOT) / 10, 1.0])
VALUES, VECTORS = np.linalg.eig(A)
REAL, PAIR = int(np.argmin(np.abs(VALUES.imag))), int(np.argmax(VALUES.imag))
INVERSE = np.linalg.inv(VECTORS)
GAMMA = float(VALUES[REAL].real)
ERRORS = (
    GAMMA * np.array([-13 - 7 * ROOT, -13 + 7 * ROOT, -1]) / 3
)  # of increments of the stages; of an error of order four

MOST_ITERATIONS, PART_OF_TOLERANCE = 10, 0.01
CASES = (
    ("flyball governor, 1 s", flyballs, 1.0, (1e-6, 1e-9), (1e-7, 1e-8)),
    ("seven-body squeezer, 30 ms", squeezer, 0.03, (1e-8,), (1e-6,)),
    ("falling cable, 1 s", falling_beam, 1.0, (1e-7,), (1e-6,)),
)


class Work(NamedTuple):
    error: float
    factorizations: int
    evaluations: int


def saddle_factors(block: np.ndarray, columns: np.ndarray, rows: np.ndarray, off: np.ndarray) -> Any:
    return lu_factor(np.block([[block, columns], [rows, off]]))


class Motion:
    """Of a system without ODE1 coordinates and without nodes of Lie groups."""

    def __init__(self, mbs: Any, tolerance: float) -> None:
        self.mbs, self.tolerance = mbs, tolerance
        self.state = testing.State(mbs)
        self.state.q = mbs.systemData.GetODE2Coordinates(exu.ConfigurationType.Initial)
        self.state.v = mbs.systemData.GetODE2Coordinates_t(exu.ConfigurationType.Initial)
        self.n, self.m = len(self.state.q), len(self.state.lam)
        self.pairs = self.evaluations = 0
        off = np.diag(np.array(testing.tangent(mbs, self.state))[self.n :, self.n :])
        self.acting = off == 0  # other equations state their multipliers

    def rates(self, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        s = self.state.copy()
        s.rate_level, s.q, s.v, s.a, s.lam = True, q, v, 0 * q, np.zeros(self.m)
        return np.asarray(testing.gaps(self.mbs, s))

    def gap_accelerations(self, q: np.ndarray, v: np.ndarray, a: np.ndarray) -> np.ndarray:
        speed = np.linalg.norm(v)
        change = np.zeros(self.m)
        if speed > 1e-10:
            tau = 1e-5 * max(1.0, np.abs(q).max()) / speed
            change = (self.rates(q + tau * v, v) - self.rates(q - tau * v, v)) / (2 * tau)
        return change + self.rates(q, a) - self.rates(q, 0 * a)

    def residual(self, t: float, q: np.ndarray, v: np.ndarray, a: np.ndarray, lam: np.ndarray) -> np.ndarray:
        self.evaluations += 1
        s = self.state.copy()
        s.t, s.q, s.v, s.a, s.lam = t, q, v, a, lam
        r = np.array(testing.residual(self.mbs, s))
        r[self.n :][self.acting] = self.gap_accelerations(q, v, a)[self.acting]
        return r

    def parts(self, t: float, q: np.ndarray, v: np.ndarray, a: np.ndarray, lam: np.ndarray) -> list[np.ndarray]:
        """Stiffness, damping and mass matrix, columns of multipliers, rates by velocities, equations that are off."""
        s, n = self.state.copy(), self.n
        s.t, s.q, s.v, s.a, s.lam = t, q, v, a, lam
        by_q = np.array(testing.tangent(self.mbs, s))
        by_v = np.array(testing.tangent(self.mbs, s, cq=0, cv=1))[:n, :n]
        masses = np.array(testing.mass_matrix(self.mbs, s))
        s.rate_level, s.lam = True, 0 * lam
        rates_by_v = np.array(testing.tangent(self.mbs, s, cq=0, cv=1))[n:, :n]
        return [by_q[:n, :n], by_v, masses, by_q[:n, n:], rates_by_v, by_q[n:, n:]]

    def start(self) -> tuple[np.ndarray, np.ndarray]:
        s = self.state
        q, v = s.q, s.v
        of_constraints = self.parts(0, q, v, 0 * q, np.zeros(self.m))[2:]
        right = -self.residual(0, q, v, 0 * q, np.zeros(self.m))
        x = lu_solve(saddle_factors(*of_constraints), right)
        return x[: self.n], x[self.n :]

    def norm(self, of_q: np.ndarray, of_v: np.ndarray, q: np.ndarray, v: np.ndarray) -> float:
        weight = lambda x: self.tolerance * (1 + np.abs(x))  # noqa: E731
        return float(np.sqrt(np.mean(np.r_[of_q / weight(q), of_v / weight(v)] ** 2)))

    def project(self, factors: Any, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """With the factors of the step, as long as gaps become smaller."""
        s = self.state.copy()

        def gaps() -> np.ndarray:
            s.rate_level, s.q, s.lam = False, q, np.zeros(self.m)
            return np.asarray(testing.gaps(self.mbs, s))

        for of_rates in (False, True):
            left = np.inf
            for _ in range(10):
                open_now = self.acting * (self.rates(q, v) if of_rates else gaps())
                size = np.abs(open_now).max(initial=0)
                if size <= 1e-13 or not size < 0.5 * left:
                    break
                left = size
                step = lu_solve(factors, np.r_[np.zeros(self.n), -open_now])[: self.n]
                q, v = (q, v + step) if of_rates else (q + step, v)
        return q, v

    def solve(self, end: float, first: float, smallest: float = 1e-12) -> None:
        """To the end, whose state becomes the current one of the system."""
        q, v = self.state.q, self.state.v
        a, lam = self.start()
        t, h, before = 0.0, first, None
        while t < end * (1 - 1e-13):
            h = min(h, end - t, end / 20)
            stage = self.stages(t, h, q, v, a, lam, before)
            if stage is None:
                h, before = h / 3, None
                if h < smallest:
                    raise RuntimeError(f"steps become too small at t = {t}")
                continue
            stage_a, stage_lam, stage_v, stage_q, factors, masses = stage
            of_q = GAMMA * h * v + ERRORS @ (stage_q - q)
            of_v = GAMMA * h * a + ERRORS @ (stage_v - v)
            of_q, of_v = (lu_solve(factors, np.r_[masses @ x, np.zeros(self.m)])[: self.n] for x in (of_q, of_v))
            error = self.norm(of_q, of_v, stage_q[2], stage_v[2])
            wanted = 0.9 * max(error, 1e-12) ** -0.25
            if error > 1:
                h, before = h * max(0.2, wanted), None
                continue
            before = (h, np.vstack([a, stage_a]), np.vstack([lam, stage_lam]))
            t += h
            q, v = self.project(factors, stage_q[2], stage_v[2])
            a, lam = stage_a[2], stage_lam[2]
            h *= min(4.0, max(0.3, wanted))
        self.mbs.systemData.SetODE2Coordinates(q)
        self.mbs.systemData.SetODE2Coordinates_t(v)

    def stages(
        self, t: float, h: float, q: np.ndarray, v: np.ndarray, a: np.ndarray, lam: np.ndarray, before: Any
    ) -> Any:
        """By simplified Newton iterations; None: they do not converge."""
        stiffness, damping, masses, *of_constraints = self.parts(t, q, v, a, lam)
        real, pair = (
            saddle_factors(masses + h * x * damping + (h * x) ** 2 * stiffness, *of_constraints)
            for x in (GAMMA, VALUES[PAIR])
        )
        self.pairs += 1
        if before is None:
            stage_a, stage_lam = np.tile(a, (3, 1)), np.tile(lam, (3, 1))
        else:
            at, places = 1 + NODES * h / before[0], np.r_[0, NODES]
            weights = np.array([[lagrange(places, j, x) for j in range(4)] for x in at])
            stage_a, stage_lam = weights @ before[1], weights @ before[2]
        last, rate = np.inf, 1.0
        for k in range(MOST_ITERATIONS):
            stage_v = v + h * A @ stage_a
            stage_q = q + h * A @ stage_v
            every = zip(NODES, stage_q, stage_v, stage_a, stage_lam, strict=True)
            r = INVERSE @ np.array([self.residual(t + h * c, *x) for c, *x in every])
            if not np.isfinite(r).all():
                return None
            x = np.zeros_like(r)
            x[REAL] = lu_solve(real, r[REAL].real)
            x[PAIR] = lu_solve(pair, r[PAIR])
            x[3 - REAL - PAIR] = x[PAIR].conj()
            step = -(VECTORS @ x).real
            stage_a, stage_lam = stage_a + step[:, : self.n], stage_lam + step[:, self.n :]
            of_v = h * A @ step[:, : self.n]
            of_q = h * A @ of_v
            size = max(self.norm(of_q[i], of_v[i], stage_q[i], stage_v[i]) for i in range(3))
            if k > 0:
                rate = max(0.3 * rate, size / last)
                if size / last > 2:
                    return None
            if size * min(1.0, rate) <= PART_OF_TOLERANCE:
                stage_v = v + h * A @ stage_a
                return stage_a, stage_lam, stage_v, q + h * A @ stage_v, real, masses
            last = size
        return None


def lagrange(places: np.ndarray, j: int, x: float) -> float:
    others = np.delete(places, j)
    return float(np.prod((x - others) / (places[j] - others)))


def by_radau(build: Callable[[], Any], end: float, tolerance: float) -> Work:
    mbs, error = build()
    motion = Motion(mbs, tolerance)
    motion.solve(end, 1e-5 * end)
    return Work(error(), motion.pairs, motion.evaluations)


def by_esdirk(build: Callable[[], Any], end: float, tolerance: float) -> Work:
    mbs, error = build()
    mbs.SolveDynamic(by_tolerance(end, tolerance, Solver.ESDIRK43), solverType=Solver.ESDIRK43)
    it = mbs.sys["dynamicSolver"].it
    return Work(error(), it.newtonJacobiCount, it.newtonStepsCount)


def main() -> None:
    for model, build, end, *tolerances in CASES:
        for method, values in zip((by_esdirk, by_radau), tolerances, strict=True):
            for tolerance in values:
                work = method(build, end, tolerance)
                print(
                    f"{model}, {method.__name__[3:]} {tolerance:.0e}: error {work.error:.1e}, "
                    f"{work.factorizations} factorizations, {work.evaluations} evaluations",
                    flush=True,
                )


if __name__ == "__main__":
    main()
