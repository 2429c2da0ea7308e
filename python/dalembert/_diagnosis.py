"""Why a solver gave up: the state in which it stopped, the items behind it, and what to try."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

import numpy as np

from dalembert import _core

_ALLOCATION_THRESHOLD = 10000  # fewer allocations than this are of no concern
_COUNTED = (0, 2, 4)  # entries of InfoStat: new arrays, vectors, matrices

# Parts of the text that the compiled solver gives: the start of the advice, and the items behind an equation.
_ADVICE = "  what to try:"
_ITEMS = re.compile(r"^(\s*(?:no pivot for unknown \d+|rows [\d, ]+|equation \d+: \S+))(?:: |  \().*$")


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


def SolverErrorMessage(
    solver: Any,
    mbs: Any,
    isStatic: bool = False,
    showCausingObjects: bool = True,
    showCausingNodes: bool = True,
    showHints: bool = True,
) -> str:
    """Return the diagnosis of a failed solver: where it stopped, which items are involved and, on request, what to try.

    Without showCausingObjects and showCausingNodes, the equations are named by their numbers alone.
    """
    lines = [f"{'static' if isStatic else 'dynamic'} solver failed"]
    text, _, advice = solver.GetDiagnosis().partition(_ADVICE)
    if text:
        lines += text.strip().splitlines()
    else:  # stopped by an exception
        it = solver.it
        lines.append(f"in step {it.currentStepIndex} at time {it.currentTime:.6g} (step size {it.currentStepSize:.3g})")
    if not (showCausingObjects or showCausingNodes):
        lines = [_ITEMS.sub(r"\1", line) for line in lines]
    if advice.strip():
        lines.append(_ADVICE + advice.rstrip() if showHints else "  showHints=True tells what to try")
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
