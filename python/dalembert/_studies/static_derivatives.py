"""Derivatives of a static equilibrium.

From r(q, lambda; p) = 0 follows K du = - dr/dp; or, for an output J, K^T w = dJ/du and dJ/dp = - w dr/dp.
"""

from __future__ import annotations

import copy
import time as clock
from typing import Any

import numpy as np

from dalembert import _core, solver
from dalembert._checks import FloatArray
from dalembert._studies.buckling_derivatives import buckling_derivatives
from dalembert._studies.design_parameters import Parameters, Variant, weighted
from dalembert._studies.differentiable_outputs import COMPUTED, BucklingLoad, Context
from dalembert._studies.eigenvalue_derivatives import eigenvalue_derivatives
from dalembert._studies.exact_sensitivities import (
    Problem,
    Samples,
    Sensitivities,
    chosen,
    row_names,
    typical_steps,
)
from dalembert._studies.generalized_alpha import Variation
from dalembert._studies.not_differentiable import NotDifferentiable
from dalembert._studies.recorded_motion import refuse_redundant
from dalembert._studies.response_derivatives import response_derivatives
from dalembert._studies.stored_rows import Rows

_WHOLE = (1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0)  # factors of K alone
_MOST_RANKED = 1000  # unknowns of matrices whose condition is computed
_SINGULAR = 1e-13
_NEARBY = 1e-7  # a motion, relative to the size of the model
_OPEN = 1e-6  # residual, relative to its largest terms


def solve_static(problem: Problem, method: Any) -> Sensitivities:
    begin = clock.perf_counter()
    solved = copy.copy(problem.mbs)
    if problem.n1 > 0:
        raise NotDifferentiable("coordinates of first order are not available", item="static solution")
    only_buckling = all(isinstance(output, BucklingLoad) for output in problem.outputs.values())
    if not only_buckling:  # which belongs to the state without loads
        solver.SolveStatic(solved, problem.settings)
        refuse_redundant(solved.sys["staticSolver"])
    seconds = clock.perf_counter() - begin
    begin = clock.perf_counter()
    z, time = _equilibrium(problem, solved)
    samples = Samples(problem, Context(problem.mbs, np.array([time]), True), Rows.of(z))
    wanted: dict[str, list[Any]] = {kind: [] for kind in COMPUTED}
    for sample in samples.wanted:
        if not isinstance(sample.source, int) and sample.source[0] in COMPUTED:
            wanted[sample.source[0]].append(sample.source[1])
    alone = bool(wanted["buckling"] or wanted["response"])  # these depend on all equations
    parameters = Parameters(
        problem.mbs, problem.parameters, samples.read_by_outputs, {"inertia": False}, (z, time), together=not alone
    )
    base, n, m = parameters.base.derivatives, problem.n, problem.m
    computed: dict[Any, Any] = {}

    def add(kind: str, found: Any) -> None:
        computed.update({(kind, key): value for key, value in found.items()})

    if wanted["buckling"]:
        add("buckling", buckling_derivatives(parameters, sorted(wanted["buckling"])))
    size = sum(output.size for output in problem.outputs.values())
    how = (
        "forward"
        if computed or wanted["eigenvalue"] or wanted["response"]
        else chosen(method, len(parameters.all), size)
    )
    if only_buckling:
        rates, u = np.zeros((len(parameters.all), n + m)), np.zeros((len(parameters.all), n + m))
    else:
        _check(problem, base, z, time)
        if base.factorize(_WHOLE, transposed=how == "adjoint") >= 0:
            raise _singular(problem, None)
        rates = parameters.rates(weighted(lambda variant: _residual(parameters, variant, z, time)))
        u = -base.solve(rates) if how == "forward" else np.zeros((0, n + m))
    if wanted["eigenvalue"]:
        add("eigenvalue", eigenvalue_derivatives(parameters, z, time, u, sorted(wanted["eigenvalue"])))
    if wanted["response"]:
        steps = typical_steps(problem, z)
        add("response", response_derivatives(parameters, z, time, u, steps, wanted["response"]))
    samples.read(parameters, computed)
    matrix = np.zeros((samples.size, len(parameters.all)))
    if how == "forward":
        change = Variation.zeros(len(u), n, 0, m)
        change.q[:], change.lam[:] = u[:, :n], u[:, n:]
        samples.add_variations(0, change, matrix)
    else:
        bar = Variation.zeros(samples.size, n, 0, m)
        samples.add_seeds(0, bar, matrix)
        matrix -= base.solve(np.hstack((bar.q, bar.lam))) @ rates.T
    cost = {"solution": seconds, "derivatives": clock.perf_counter() - begin}
    return Sensitivities(
        samples.outputs(),
        matrix,
        row_names(problem.outputs),
        [p.name for p in parameters.all],
        how,
        "differences",
        cost,
        samples.rows,
    )


def _equilibrium(problem: Problem, solved: Any) -> tuple[FloatArray, float]:
    """Return the state, with multipliers of the sign of dynamics, and the time."""
    data = solved.systemData
    signs = np.asarray(_core.testing.SystemDerivatives(solved, inertia=False).static_signs)
    q, v = data.GetODE2Coordinates(), data.GetODE2Coordinates_t()
    return np.concatenate(
        (q, v, np.zeros(problem.n), signs * data.GetAECoordinates(), data.GetDataCoordinates())
    ), data.GetTime()


def _residual(parameters: Parameters, variant: Variant, z: FloatArray, time: float) -> FloatArray:
    """Return the residual with the initial velocities of the varied model, which stay in static solutions."""
    n = len(variant.start) // 2
    moved = parameters.shifted(variant, z).copy()
    moved[n : 2 * n] = variant.start[n : 2 * n]
    return np.asarray(variant.derivatives.residual(moved, time, 0.0))


def _singular(problem: Problem, row: int | None) -> NotDifferentiable:
    item = "static solution" if row is None else _core.testing.describe_row(problem.mbs, row)
    return NotDifferentiable(
        "the stiffness matrix is singular: a limit point, a bifurcation, or a motion without stiffness",
        item=item,
        advice="choose another load, or hold what can move",
    )


def _changes_nearby(problem: Problem, derivatives: Any, z: FloatArray, time: float, soft: FloatArray) -> bool:
    """Return whether the stiffness along the softest motion is another one at a state that cannot be told apart."""
    n = problem.n
    step = _NEARBY * min(1.0, float(_core.testing.extent(problem.mbs))) / max(np.abs(soft[:n]).max(initial=0.0), 1e-300)
    here = derivatives.product("K", soft[None])[0]
    moved = z.copy()
    moved[:n] = derivatives.compose(z[:n], step * soft[:n])
    moved[3 * n : 3 * n + problem.m] += step * soft[n:]
    derivatives.linearize(moved, time, 0.0)
    change = derivatives.product("K", soft[None])[0] - here
    derivatives.linearize(z, time, 0.0)
    return bool(np.abs(change).max(initial=0.0) > np.abs(here).max(initial=0.0))


def _check(problem: Problem, derivatives: Any, z: FloatArray, time: float) -> None:
    """Refuse states that are no equilibrium, and singular matrices."""
    size = problem.n + problem.m
    residual = np.abs(derivatives.residual(z, time, 0.0))
    derivatives.linearize(z, time, 0.0)
    if size <= _MOST_RANKED:
        matrix = derivatives.product("K", np.eye(size), transposed=True)
        scale = np.ones(size)  # of columns
        for _ in range(3):  # equilibrate
            rows = np.sqrt(np.abs(matrix).max(axis=1))
            matrix = matrix / np.where(rows > 0, rows, 1.0)[:, None]
            columns = np.sqrt(np.abs(matrix).max(axis=0))
            columns = np.where(columns > 0, columns, 1.0)
            matrix, scale = matrix / columns, scale * columns
        left, singular, right = np.linalg.svd(matrix)
        if singular[-1] < _SINGULAR * singular[0] or _changes_nearby(problem, derivatives, z, time, right[-1] / scale):
            raise _singular(problem, int(np.argmax(np.abs(left[:, -1]))))
    total = z[: problem.n] + problem.mbs.systemData.GetODE2Coordinates(_core.ConfigurationType.Reference)
    u = np.concatenate((total, z[3 * problem.n : 3 * problem.n + problem.m]))
    terms = np.abs(derivatives.product("K", np.eye(size) * u)).max(initial=0.0)
    if residual.max(initial=0.0) > _OPEN * max(terms, 1e-300):
        raise NotDifferentiable(
            "the solution does not fulfil the static equations at full load",
            item="static solution",
            advice="check load steps, and arcLength",
        )
