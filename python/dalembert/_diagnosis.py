"""Why a solver gave up: the state in which it stopped, the items behind it, and what to try."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from dalembert import _core

_ALLOCATION_THRESHOLD = 10000  # fewer allocations than this are of no concern
_COUNTED = (0, 2, 4)  # entries of InfoStat: new arrays, vectors, matrices


class SolverError(ValueError):
    """A solver that gave up; `diagnosis` is the full text, `solver` the compiled solver with all its numbers."""

    def __init__(self, message: str, diagnosis: str, solver: Any) -> None:
        super().__init__(message)
        self.message = message
        self.diagnosis = diagnosis
        self.solver = solver
        self.stepIndex = int(solver.it.currentStepIndex)
        self.time = float(solver.it.currentTime)
        self.stepSize = float(solver.it.currentStepSize)
        self.newtonSteps = int(solver.it.newtonSteps)
        self.residual = float(solver.conv.residual)
        self.causingRow = int(solver.conv.linearSolverCausingRow)

    def __str__(self) -> str:
        return f"{self.message}: {'; '.join(self.diagnosis.splitlines()[1:4])}"


def _row_kind(solver: Any, row: int) -> tuple[str, int, str] | None:
    """Return what a system equation belongs to: words, its number among its kind, and the reader of LTG lists."""
    sizes = (
        ("ODE2 coordinate", solver.GetODE2size(), "GetObjectLTGODE2"),
        ("ODE1 coordinate", solver.GetODE1size(), "GetObjectLTGODE1"),
        ("algebraic variable (Lagrange multiplier)", solver.GetAEsize(), "GetObjectLTGAE"),
    )
    first = 0
    for words, size, reader in sizes:
        if first <= row < first + size:
            return words, row - first, reader
        first += size
    return None


def _causing_items(solver: Any, mbs: Any, show: bool) -> list[str]:
    """Return lines on the equation at which the linear solver failed, and on the objects that take part in it."""
    row = solver.conv.linearSolverCausingRow
    kind = _row_kind(solver, row) if solver.conv.linearSolverFailed else None
    if kind is None:
        return []
    words, number, reader = kind
    lines = [f"the linear solver failed at system equation {row}: {words} {number}"]
    if not show:
        return lines
    ltg = getattr(mbs.systemData, reader)
    objects = [i for i in range(mbs.systemData.NumberOfObjects()) if number in ltg(i)]
    for i in objects:
        data = mbs.GetObject(i)
        lines.append(f"  object {i} '{data['name']}' ({data['objectType']}) takes part in it")
    if not objects:
        lines.append("  no object takes part in it: a node without a body, or a body without a node's mass?")
    return lines


def _hints(solver: Any, isStatic: bool) -> list[str]:
    """Return what may be wrong and what to try, by the way in which the solver failed."""
    conv = solver.conv
    newton_failed = conv.stepReductionFailed or conv.newtonSolutionDiverged
    settings = "staticSolver" if isStatic else "timeIntegration"
    hints = []
    if conv.linearSolverFailed:
        hints += [
            "look for nodes that no body uses",
            "look for constraints that repeat each other: mbs.ComputeSystemDegreeOfFreedom(verbose=True) counts them",
            "if they are wanted: linearSolverSettings.ignoreSingularJacobian = True and the solver EigenDense",
            "hold every coordinate by a constraint or a spring"
            if isStatic
            else "give every coordinate mass or inertia",
        ]
    if newton_failed:
        hints += [
            "take smaller load steps" if isStatic else "take a smaller step size",
            f"allow smaller steps where needed: {settings}.adaptiveStep = True",
            "start closer to the solution: initial values, loads that grow slowly, softer penalty stiffness",
        ]
        if not conv.newtonSolutionDiverged and conv.residual < 1e-3:
            hints.append(
                f"the residual {conv.residual:.3g} is small: {settings}.newton.relativeTolerance and "
                "absoluteTolerance may ask for more than round-off permits"
            )
    hints.append("check that the initial values satisfy the constraints and that joint axes fit together")
    if not isStatic:
        hints.append("compare index 2 and index 3 constraints: generalizedAlpha.useIndex2Constraints")
    return hints


def SolverErrorMessage(
    solver: Any,
    mbs: Any,
    isStatic: bool = False,
    showCausingObjects: bool = True,
    showCausingNodes: bool = True,
    showHints: bool = True,
) -> str:
    """Return the diagnosis of a failed solver: where it stopped, which items are involved and what to try."""
    conv, it = solver.conv, solver.it
    lines = [f"{'static' if isStatic else 'dynamic'} solver failed"]
    if text := solver.GetErrorString().strip():
        lines.append(text)
    lines.append(
        f"step {it.currentStepIndex} at time {it.currentTime:.6g} with step size {it.currentStepSize:.3g}: "
        f"{it.newtonSteps} Newton iterations, residual {conv.residual:.6g}"
    )
    if conv.massMatrixNotInvertible:
        lines.append("the mass matrix cannot be inverted: some coordinate has no mass or inertia")
    lines += _causing_items(solver, mbs, showCausingObjects or showCausingNodes)
    if showHints:
        lines += ["what to try:", *(f"  - {hint}" for hint in _hints(solver, isStatic))]
    else:
        lines.append("showHints=True tells what to try")
    return "\n".join(lines)


def CheckSolverInfoStatistics(solverName: str, infoStat: Sequence[float], numberOfEvaluations: int) -> None:
    """Warn if memory was allocated in every evaluation since infoStat = special.InfoStat(False) was taken."""
    now = np.asarray(_core.special.InfoStat(False), dtype=float)
    before = np.asarray(infoStat, dtype=float)
    if now.size <= max(_COUNTED) or before.shape != now.shape:
        return
    allocations = int((now - before)[list(_COUNTED)].max())
    if allocations > _ALLOCATION_THRESHOLD and allocations >= numberOfEvaluations:
        _core.Print(
            f"WARNING: {solverName}: {allocations} memory allocations in {numberOfEvaluations} evaluations; "
            "user functions may be the reason, the solver may be slow"
        )
