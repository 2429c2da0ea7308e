"""Loads at which an equilibrium becomes unstable, by linearization."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._core import ConfigurationType, testing
from dalembert._solving.consistent import _Nodes
from dalembert._solving.diagnosis import SolverError
from dalembert._solving.quiet import assemble_if_needed
from dalembert._solving.sparse_factors import sparse_solver

_NAME = "ComputeBucklingLoads"
_PROBE = 1e-4  # size of the displacements that the matrix is differentiated by, relative to the model; rad
_IN_BALANCE = 1e-6  # forces without loads, relative to those of the loads
_DENSE = 400  # unknowns up to which all eigenvalues are computed
_REAL = 1e-4  # imaginary parts, relative, that come from multiplicity and rounding


@dataclass(frozen=True)
class BucklingLoads:
    """Results of ComputeBucklingLoads.

    factors: factors of all loads at which a neighbouring equilibrium exists, the smallest magnitude first; negative
        ones belong to reversed loads.
    modes: displacements to that equilibrium, one column of ODE2 coordinates for each factor; its largest entry is 1.
    displacements: ODE2 coordinates, linear in the loads, for factor 1.
    """

    factors: FloatArray
    modes: FloatArray
    displacements: FloatArray


def _matrix(mbs: Any, state: Any) -> Any:
    from scipy.sparse import csc_array

    rows, columns, values = testing.tangent_entries(mbs, state, cq=1, cv=0)
    return csc_array((values, (rows, columns)), shape=(len(state.q) + len(state.lam),) * 2)


def _error(reason: str, problem: str, advice: str) -> SolverError:
    return SolverError(f"{_NAME}: {problem}", advice, reason=reason, solverName=_NAME, advice=[advice])


def _start(mbs: Any) -> Any:
    """Return the initial state at rest, without loads."""
    data, initial, state = mbs.systemData, ConfigurationType.Initial, testing.State(mbs)
    if len(state.y) > 0:
        raise ValueError(f"{_NAME}: expected a system without ODE1 coordinates, received {len(state.y)} of them")
    state.q, state.data, state.t = (
        data.GetODE2Coordinates(initial),
        data.GetDataCoordinates(initial),
        data.GetTime(initial),
    )
    state.v = state.a = np.zeros(len(state.q))
    state.lam = np.zeros(len(state.lam))
    state.inertia, state.load_factor = False, 0.0
    return state


def _inverse_factors(A0: Any, solve: Any, A1: Any, count: int) -> tuple[FloatArray, FloatArray]:
    """Return eigenvalues -1/p and eigenvectors of (A0 + p A1) x = 0, those of the largest magnitude among them."""
    from scipy.sparse.linalg import LinearOperator, eigs

    size = A0.shape[0]
    if size <= max(_DENSE, 2 * count + 3):
        return np.linalg.eig(solve(A1.toarray()))
    operator = LinearOperator((size, size), matvec=lambda x: solve(A1 @ np.ravel(x)), dtype=float)
    return eigs(operator, k=2 * count + 2, v0=np.random.default_rng(1).normal(size=size))


def ComputeBucklingLoads(mbs: Any, numberOfLoads: int = 1, autoAssemble: bool = True) -> BucklingLoads:
    """Return factors of all loads at which the equilibrium buckles, and the modes, by linearized theory.

    The initial state has to be an equilibrium without loads. Stiffness, geometric terms of forces in bodies, connectors
    and constraints, and those of loads are taken as linear in the factor, in the displacements that loads cause by
    linear theory. Constraints may be redundant. If bodies move much before they buckle, follow the path by
    SolveStatic with a small imperfection.
    """
    if numberOfLoads < 1:
        raise ValueError(f"{_NAME}: numberOfLoads: expected a positive number, received {numberOfLoads}")
    assemble_if_needed(_NAME, mbs, autoAssemble)
    start = _start(mbs)
    n = len(start.q)
    without = np.asarray(testing.residual(mbs, start))
    full = start.copy()
    full.load_factor = 1.0
    load = np.asarray(testing.residual(mbs, full)) - without
    if not np.abs(load).max(initial=0.0) > 0:
        raise _error("noLoads", "no load acts in the initial state", "add the loads whose factor is looked for")
    if np.abs(without).max() > _IN_BALANCE * np.abs(load).max():
        advice = (
            "start from the unloaded equilibrium: SolveStatic(updateInitialValues=True) without these loads finds it"
        )
        raise _error("notInBalance", "forces act in the initial state without loads", advice)
    redundant = testing.redundant_constraints(mbs, start)
    kept = np.setdiff1d(np.arange(len(load)), n + np.array(redundant["dependent"], dtype=int))

    def independent(matrix: Any) -> Any:
        return matrix[kept][:, kept]

    A0 = independent(_matrix(mbs, start))
    try:
        solve = sparse_solver(A0)
    except np.linalg.LinAlgError as error:
        advice = "hold the motions that nothing resists; mbs.ComputeSystemDegreeOfFreedom() counts them"
        raise _error(
            "singularMatrix", f"the system is no structure: its matrix is singular ({error})", advice
        ) from error
    response = np.zeros(len(load))
    response[kept] = -solve(load[kept])
    nodes = _Nodes(mbs, (), ())
    size = max(nodes.largest_turn(response[:n]), np.abs(response[:n]).max() / testing.extent(mbs))
    step = _PROBE / size

    def loaded(factor: float) -> Any:
        state = start.copy()
        state.q, state.lam = testing.compose(mbs, start, factor * response[:n]), factor * response[n:]
        state.load_factor = factor
        if redundant["count"] > 0 and testing.redundant_constraints(mbs, state)["count"] != redundant["count"]:
            problem = "constraints follow from others in the initial state, and not beside it"
            raise _error("singularPosition", problem, "free equations that others state as well in this state alone")
        return independent(_matrix(mbs, state))

    A1 = (loaded(step) - loaded(-step)) / (2 * step)
    inverse, vectors = _inverse_factors(A0, solve, A1, numberOfLoads)
    real = np.abs(inverse.imag) <= _REAL * np.abs(inverse)
    order = [i for i in np.argsort(-np.abs(inverse)) if real[i] and inverse[i] != 0][:numberOfLoads]
    modes = vectors[:n, order].real
    return BucklingLoads(-1 / inverse[order].real, modes / np.abs(modes).max(axis=0, initial=0.0), response[:n])
