"""Work against accuracy: what solvers with error control need for the error that is left at the end.

`python benchmarks/work_precision.py docs/data/work_precision.csv docs/_static/work_precision.png` writes table and
diagrams of the documentation. Work is the number of factorizations, one per stage of explicit methods and one per
Jacobian of implicit ones: it does not depend on the machine. Models and references are those of the tests.
"""

from __future__ import annotations

import csv
import sys
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1] / "tests/validation"))
sys.path.insert(0, str(Path(__file__).parents[1] / "tests/solvers"))

import test_andrews as andrews
import test_explicit_joints as joints
import test_four_bar as four_bar
import test_governor as governor
from solving import Solver, Variable, new_system, settings
from test_events import AFTER_TWO_SECONDS, Ball

import dalembert as exu

HEADER = ("model", "method", "tolerance", "steps", "repeated", "factorizations", "error")
IMPLICIT = (Solver.GeneralizedAlpha, Solver.TrapezoidalIndex2)
STIFF = (*IMPLICIT, Solver.ESDIRK43)
METHODS = (*STIFF, Solver.ODE23, Solver.DOPRI5, Solver.DOP853)


class Case(NamedTuple):
    model: str
    end: float  # s
    build: Callable[[], tuple[Any, Callable[[], float]]]  # the system, and what tells the error
    tolerances: tuple[float, ...] = (1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8)
    methods: tuple[Any, ...] = METHODS


def parallelogram() -> tuple[Any, Callable[[], float]]:
    bars, wanted = four_bar.Bars(2), four_bar.PUBLISHED[5]
    return bars.mbs, lambda: float(np.linalg.norm(bars.tip_output(Variable.Position) - wanted))


def squeezer() -> tuple[Any, Callable[[], float]]:
    mechanism, wanted = andrews.Squeezer(), andrews.angles(andrews.END)
    return mechanism.mbs, lambda: float(np.abs(mechanism.angles() - wanted).max())


def flyballs() -> tuple[Any, Callable[[], float]]:
    mechanism, wanted = governor.Governor("NodeRigidBodyEP"), governor.heights_of_slider()[1.0]
    return mechanism.mbs, lambda: abs(mechanism.height() - wanted)


def cart_pole() -> tuple[Any, Callable[[], float]]:
    mbs, cart, mass = joints.cart_pole()
    x, y = joints.CART, joints.MASS

    def error() -> float:
        place = [mbs.GetNodeOutput(cart, Variable.Position)[0], mbs.GetNodeOutput(mass, Variable.Position)[1]]
        return float(np.hypot(place[0] - x, place[1] - y))

    return mbs, error


def beam() -> tuple[Any, Any]:
    """A cantilever of four cable elements that falls from the horizontal."""
    mbs = new_system()
    cable = exu.utilities.Cable2D(
        physicsMassPerLength=1,
        physicsBendingStiffness=10,
        physicsAxialStiffness=1e4,
        physicsBendingDamping=0.01,
        physicsAxialDamping=1,
    )
    nodes = exu.utilities.GenerateStraightLineANCFCable2D(
        mbs, [0, 0, 0], [2, 0, 0], 4, cable, massProportionalLoad=[0, -9.81, 0], fixedConstraintsNode0=[1, 1, 0, 1]
    )[0]
    mbs.Assemble()
    return mbs, nodes[-1]


@cache
def beam_reference() -> np.ndarray:
    mbs, tip = beam()
    s = by_tolerance(1.0, 1e-11, Solver.DOP853)
    mbs.SolveDynamic(s, solverType=Solver.DOP853)
    return np.array(mbs.GetNodeOutput(tip, Variable.Position))


def falling_beam() -> tuple[Any, Callable[[], float]]:
    mbs, tip = beam()
    return mbs, lambda: float(np.linalg.norm(mbs.GetNodeOutput(tip, Variable.Position) - beam_reference()))


def bouncing_ball() -> tuple[Any, Callable[[], float]]:
    ball = Ball()
    ball.floor()
    return ball.mbs, lambda: abs(ball.model.position - AFTER_TWO_SECONDS)


CASES = (
    Case("A02 four-bar with two loops, 5 s", 5, parallelogram),
    Case("A03 Andrews' squeezer, 30 ms", 0.03, squeezer),
    Case("A05 governor, 1 s", 1, flyballs, methods=STIFF),
    Case("Heavy pole on a light cart, 10 s", 10, cart_pole, methods=METHODS[2:]),
    Case("Flexible beam, 1 s", 1, falling_beam),
    Case("Ball on a stiff floor, events, 2 s", 2, bouncing_ball),
)


def by_tolerance(end: float, tolerance: float, method: Any) -> Any:
    s = settings(end, 20, spectral_radius=0.8)
    s.timeIntegration.absoluteTolerance = s.timeIntegration.relativeTolerance = tolerance
    s.timeIntegration.initialStepSize = 1e-5 * end
    s.timeIntegration.minimumStepSize = 1e-10
    s.stepSizeControl.implicitSolvers = method in IMPLICIT
    return s


def run(case: Case, method: Any, tolerance: float) -> tuple[str, ...]:
    """A method that gives up has no error."""
    mbs, error = case.build()
    try:
        mbs.SolveDynamic(by_tolerance(case.end, tolerance, method), solverType=method)
        left = f"{error():.2e}"
    except exu.SolverError:
        left = "stops"
    solver = mbs.sys["dynamicSolver"]
    steps, rejected = solver.it.currentStepIndex - 1, solver.it.rejectedAutomaticStepSizeSteps
    work = solver.it.newtonJacobiCount
    if method not in STIFF:
        work = (steps + rejected + solver.it.eventSolutions) * solver.GetNumberOfStages()
    return case.model, method.name, f"{tolerance:.0e}", str(steps), str(rejected), str(work), left


def rows() -> Iterator[tuple[str, ...]]:
    for case in CASES:
        for method in case.methods:
            for tolerance in case.tolerances:
                yield run(case, method, tolerance)


def draw(table: list[tuple[str, ...]], file_name: str) -> None:
    import matplotlib.pyplot as plt

    figure, places = plt.subplots(3, 2, figsize=(9, 11), layout="constrained")
    colors = dict(zip((m.name for m in METHODS), plt.rcParams["axes.prop_cycle"].by_key()["color"], strict=False))
    for case, place in zip(CASES, places.flat, strict=True):
        for method in case.methods:
            lines = [row for row in table if row[:2] == (case.model, method.name) and row[6] != "stops"]
            work, error = ([float(row[k]) for row in lines] for k in (5, 6))
            place.loglog(work, error, "o-", markersize=3, label=method.name, color=colors[method.name])
        place.set_title(case.model, fontsize="medium")
        place.grid(alpha=0.3)
    places[0, 0].legend(fontsize="small")
    figure.supxlabel("factorizations")
    figure.supylabel("error at the end (m, or rad)")
    figure.savefig(file_name, dpi=80, metadata={"Software": None})


if __name__ == "__main__":
    table = list(rows())
    with open(sys.argv[1], "w", newline="", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows([HEADER, *table])
    draw(table, sys.argv[2])
