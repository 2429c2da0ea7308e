"""Diagnosis of a failed solver: its last state, the items involved, and remedies."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any, Self

import numpy as np

from dalembert import _core

_ALLOCATION_THRESHOLD = 10000  # fewer allocations than this are of no concern
_COUNTED = (0, 2, 4)  # entries of InfoStat: new arrays, vectors, matrices

# Static solutions that are singular at the start, such as those of pendulums.
_NEEDS_STABILIZER = ("freeDirection", "singularMatrix")
_STABILIZER = (
    "if weight or another load holds it, as a pendulum, set staticSolver.numberOfLoadSteps = 20 and "
    "staticSolver.stabilizerODE2term = 1: this adds inertia that fades out until the full load is reached"
)

# Parts of the text that the compiled solver gives: the start of the advice, and the items behind a number.
_ADVICE = "  what to try:"
_ITEMS = r"^(\s*(?:singular at unknown \d+|rows [\d, ]+|equation \d+: \S+|\w+\[\d+\]: \S+))(?:: |  \().*$"


class SolverError(_core.ExudynError, RuntimeError, ValueError):
    """Error of a solver, also a RuntimeError and a ValueError.

    Its text is the whole diagnosis with advice; its parts are attributes.

    reason: 'newton', 'openConstraints', 'singularMatrix', 'freeDirection', 'contradictoryConstraints', 'massMatrix',
        'discontinuousIteration', 'eventChatter', 'errorControl', 'stiffForMethod', 'singularPosition',
        'toleranceBelowRoundOff', 'notFinite', 'unbounded', 'pathTooLong' or 'timeLimit'.
    solverName, stepIndex, time (s), stepSize (s), loadFactor: where it happened; step 0 is the start.
    newtonSteps, residual, relativeResidual, relativeTolerance, absoluteTolerance: the last iteration, and its
        tolerances; those of discontinuous iterations if they did not converge.
    values: the worst ones (residuals, errors or numbers that are not finite), each a dict with vector, index, value,
        items.
    sources: items that give values that are not finite.
    causingRow (-1: none), causingItems, dependentEquations: the unknown without a pivot, and linearly dependent
        equations; for contradictory constraints, the gap of each item when all other constraints are fulfilled.
    freeDirections: coordinates that can move together without inertia, stiffness or constraint, item by item.
    advice: remedies, one sentence each.
    message, diagnosis: the parts of the text. solver: the compiled solver, None after copying or pickling.
    """

    reason: str = ""
    solverName: str = ""
    stepIndex: int = 0
    time: float = 0.0
    stepSize: float = 0.0
    loadFactor: float = 1.0
    newtonSteps: int = 0
    residual: float = 0.0
    relativeResidual: float = 0.0
    relativeTolerance: float = 0.0
    absoluteTolerance: float = 0.0
    values: Sequence[dict[str, Any]] = ()
    sources: Sequence[str] = ()
    causingRow: int = -1
    causingItems: str = ""
    dependentEquations: Sequence[str] = ()
    freeDirections: Sequence[str] = ()
    advice: Sequence[str] = ()

    def __init__(self, message: str, diagnosis: str = "", solver: Any = None, **parts: Any) -> None:
        super().__init__(message, diagnosis)
        self.message = message
        self.diagnosis = diagnosis
        self.solver = solver
        vars(self).update(parts)

    def __str__(self) -> str:
        return f"{self.message}: {self.diagnosis}" if self.diagnosis else self.message

    def __reduce__(self) -> Any:
        return type(self), self.args, vars(self) | {"solver": None}

    @classmethod
    def FromSolver(cls, function: str, solver: Any, showCausingItems: bool = True) -> SolverError:
        """Return the error of a solver that has failed, to be raised where its parts are called one by one."""
        text = SolverErrorMessage(solver, None, solver.IsStaticSolver(), showCausingItems, showCausingItems)
        parts = solver.GetDiagnosisDictionary()
        if solver.IsStaticSolver() and parts.get("reason") in _NEEDS_STABILIZER:
            text += f"\n    - {_STABILIZER}"
            parts["advice"] = [*parts["advice"], _STABILIZER]
        return cls(f"{function} terminated due to errors", text, solver, **parts)

    def with_causes(self, gaps: Sequence[str]) -> SolverError:
        """Return the error with gaps at the start as its likely cause, if there are any."""
        if gaps:
            lines = [
                "  constraints were open at the start, which is a likely cause:",
                *listed([f"  {g}" for g in gaps]),
            ]
            advice = "call mbs.ComputeConsistentInitialConditions() before, or correct the positions of these joints"
            self.diagnosis = "\n".join([self.diagnosis, *lines, f"    - {advice}"])
            self.args = (self.message, self.diagnosis)
            self.advice = [*self.advice, advice]
        return self


SolverError.__module__ = "dalembert"  # shown as dalembert.SolverError to users


class FinishedNotTrusted(int):
    """Return value of SolveDynamic and SolveStatic instead of True if a check of the result failed.

    It is true and equals True, because the solution has finished; doubts: the reasons, one sentence each.
    """

    doubts: tuple[str, ...]

    def __new__(cls, doubts: Sequence[str]) -> Self:
        """Return the value with these doubts."""
        value = super().__new__(cls, True)
        value.doubts = tuple(doubts)
        return value

    def __getnewargs__(self) -> tuple[Any, ...]:
        return (self.doubts,)

    def __repr__(self) -> str:
        return "finished, not trusted: " + "; ".join(self.doubts)

    __str__ = __repr__


FinishedNotTrusted.__module__ = "dalembert"


def SolverErrorMessage(
    solver: Any,
    mbs: Any,
    isStatic: bool = False,
    showCausingObjects: bool = True,
    showCausingNodes: bool = True,
    showHints: bool = True,
) -> str:
    """Return the diagnosis of a failed solver: where it stopped, the items involved and, on request, remedies.

    If showCausingObjects and showCausingNodes are False, equations are given by their numbers only.
    """
    lines = [f"{'static' if isStatic else 'dynamic'} solver failed"]
    text, _, advice = solver.GetDiagnosis().partition(_ADVICE)
    if text:
        lines += text.strip().splitlines()
    else:  # stopped by an exception
        it = solver.it
        lines.append(f"in step {it.currentStepIndex} at time {it.currentTime:.6g} (step size {it.currentStepSize:.3g})")
    if not (showCausingObjects or showCausingNodes):
        sources = solver.GetDiagnosisDictionary()["sources"]
        lines = [re.sub(_ITEMS, r"\1", line) for line in lines if line.strip() not in sources]
    if advice.strip():
        lines.append(_ADVICE + advice.rstrip() if showHints else "  showHints=True adds remedies")
    return "\n".join(lines)


def listed(lines: Sequence[str], most: int = 5) -> list[str]:
    """Return the first lines, indented, and dots if there are more."""
    return [f"  {line}" for line in lines[:most]] + ["  ..."] * (len(lines) > most)


def CheckSolverInfoStatistics(solverName: str, infoStat: Sequence[float], numberOfEvaluations: int) -> None:
    """Warn if memory was allocated in every evaluation since infoStat = special.InfoStat(False) was taken."""
    counts = _core.special.InfoStat(False)
    if counts == list(infoStat):
        return
    now = np.asarray(counts, dtype=float)
    before = np.asarray(infoStat, dtype=float)
    if now.size <= max(_COUNTED) or before.shape != now.shape:
        return
    allocations = int((now - before)[list(_COUNTED)].max())
    if allocations > _ALLOCATION_THRESHOLD and allocations >= numberOfEvaluations:
        _core.Print(
            f"WARNING: {solverName}: {allocations} memory allocations in {numberOfEvaluations} evaluations; "
            "user functions may be the reason, the solver may be slow"
        )
