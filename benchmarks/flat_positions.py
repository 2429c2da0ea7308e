"""Count which solutions of a parallelogram find their way back after a rest close to its flat position.

`python benchmarks/flat_positions.py` lets two loops rise from 0.3 rad below, through the flat position, with the speed
that brings them to rest beside it: a little further, they fall back through it as they came, or turn into another
figure. Each solver that chooses steps by tolerances tries all rests and tolerances; those that end with an error, are
not trusted or warn have said so.
"""

from __future__ import annotations

import contextlib
import io
import sys
from collections import Counter
from itertools import product
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))
sys.path.insert(0, str(Path(__file__).parents[1] / "tests/validation"))

from solving import Solver, Variable, settings
from test_four_bar import GRAVITY, Bars, parallelogram
from tolerances import by_tolerance

from dalembert.solver import SolverError

SOLVERS = (
    Solver.GeneralizedAlpha,
    Solver.TrapezoidalIndex2,
    Solver.ODE23,
    Solver.DOPRI5,
    Solver.DOP853,
    Solver.ESDIRK43,
)
RESTS = (1e-3, 1e-4, 1e-5, 1e-6)  # rad
TOLERANCES = (1e-4, 1e-5, 1e-6, 1e-7, 1e-8)
LOOPS, START, END = 2, -0.3, 0.5  # rad, s
ANOTHER_FIGURE = 0.02  # m
WARNING = "beside a singular position"


def outcome(solver: Solver, rest: float, tolerance: float) -> str:
    """Return how a solution has ended."""
    factor = ((LOOPS + 1) / 2 + LOOPS) / ((LOOPS + 1) / 3 + LOOPS)
    rate = float(np.sqrt(2 * GRAVITY * factor * (np.sin(rest) - np.sin(START))))
    bars = Bars(LOOPS, angle=START, rate=rate)
    try:
        bars.mbs.SolveDynamic(by_tolerance(settings(END, 50), tolerance), solverType=solver)
    except SolverError as error:
        return error.reason
    if not bars.mbs.sys["dynamicSolver"].output.trusted:
        return "not trusted"
    wanted = parallelogram(LOOPS, [END], (START, rate))[0][:2]
    return "right" if np.linalg.norm(bars.tip_output(Variable.Position) - wanted) < ANOTHER_FIGURE else "wrong"


def main() -> None:
    """Count and print; all that is not right with its numbers."""
    counts: Counter[str] = Counter()
    for case in product(SOLVERS, RESTS, TOLERANCES):
        with contextlib.redirect_stdout(io.StringIO()) as told:
            found = outcome(*case) + (", with a warning" if WARNING in told.getvalue() else "")
        counts[found] += 1
        if not found.startswith("right"):
            solver, rest, tolerance = case
            print(f"{solver.name}, rest at {rest:g} rad, tolerance {tolerance:g}: {found}")
    print(", ".join(f"{found}: {count}" for found, count in counts.most_common()))


if __name__ == "__main__":
    main()
