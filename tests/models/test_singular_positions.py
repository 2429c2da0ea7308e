"""Four-bars that pass their flat position with steps by tolerances: on the branch that velocities take, or with a word."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from solving import Solver, Variable, settings
from test_four_bar import Bars, parallelogram

import dalembert as exu
from dalembert.solver import SolverError

END = 5.0


def by_tolerance(tolerance: float) -> Any:
    s = settings(END, 50)
    s.timeIntegration.absoluteTolerance = s.timeIntegration.relativeTolerance = tolerance
    s.timeIntegration.automaticStepSize = s.stepSizeControl.implicitSolvers = True
    return s


def error_of(bars: Bars) -> float:
    return float(np.linalg.norm(bars.tip_output(Variable.Position) - parallelogram(bars.loops, [END])[0][:2]))


@pytest.mark.parametrize("loops", [1, 2, 5])
@pytest.mark.parametrize(
    ("solver", "tolerance", "most"),
    [
        # Second order: errors of some 6 rad are 2 tolerance^(2/3), four times as large with numerical damping.
        (Solver.GeneralizedAlpha, 1e-6, 5e-4),
        (Solver.GeneralizedAlpha, 1e-7, 5e-5),
        (Solver.TrapezoidalIndex2, 1e-6, 4e-4),
        # Of higher order: ten to a hundred times the tolerance per second, and what 1e-11 of differences leave beside the flat position.
        (Solver.ODE23, 1e-6, 5e-4),
        (Solver.DOPRI5, 1e-8, 1e-6),
        (Solver.DOP853, 1e-8, 1e-6),
    ],
)
def test_the_flat_position_is_passed(solver: Any, tolerance: float, most: float, loops: int) -> None:
    bars = Bars(loops)
    bars.mbs.SolveDynamic(by_tolerance(tolerance), solverType=solver)
    assert error_of(bars) < most
    assert bars.mbs.sys["dynamicSolver"].output.trusted


@pytest.mark.parametrize("loops", [1, 2, 5])
@pytest.mark.parametrize(
    ("solver", "tolerance"),
    [
        *((Solver.TrapezoidalIndex2, tolerance) for tolerance in (1e-7, 1e-8)),
        *((Solver.ODE23, tolerance) for tolerance in (1e-8, 1e-10)),
        (Solver.DOPRI5, 1e-10),
        (Solver.DOP853, 1e-10),
    ],
)
def test_no_other_branch_without_a_word(solver: Any, tolerance: float, loops: int) -> None:
    """Steps as small as these end beside the flat position, or in it."""
    bars = Bars(loops)
    try:
        bars.mbs.SolveDynamic(by_tolerance(tolerance), solverType=solver)
    except SolverError as error:
        assert error.reason in ("errorControl", "newton", "singularPosition")
        return
    solver = bars.mbs.sys["dynamicSolver"]
    assert error_of(bars) < max(1e-3, 200 * tolerance) or (not solver.output.trusted and len(solver.GetDoubts()) > 0)


@pytest.mark.parametrize("loops", [1, 2, 5])
@pytest.mark.parametrize("tolerance", [1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10])
def test_all_tolerances_pass_with_matrices_that_follow_the_motion(tolerance: float, loops: int) -> None:
    """Ten passages' worth of errors may be a hundred times the tolerance each; parallelograms stay parallelograms."""
    bars = Bars(loops)
    bars.mbs.SolveDynamic(by_tolerance(tolerance), solverType=Solver.ESDIRK43)
    assert error_of(bars) < 1000 * tolerance
    angles = [bars.mbs.GetObjectOutputBody(bars.tip + i, Variable.Rotation, [0, 0, 0]) for i in range(loops + 1)]
    assert np.ptp(angles) < 1e-9
    assert bars.mbs.sys["dynamicSolver"].output.trusted


def test_steps_that_pass_it_are_told(capfd: Any) -> None:
    bars, s = Bars(2), by_tolerance(1e-7)
    s.timeIntegration.verboseMode = 1
    bars.mbs.SolveDynamic(s)
    steps = bars.mbs.sys["dynamicSolver"].it.singularPositionSteps
    assert 0 < steps < 100 and "passing a singular position" in capfd.readouterr().out
    assert f"singular positions were passed in {steps} steps" in bars.mbs.Report()


@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.TrapezoidalIndex2, Solver.ESDIRK43])
def test_stiff_loops_are_not_taken_for_singular_positions(solver: Any) -> None:
    """Springs along couplers of constant length do nothing, but make matrices those of another mechanism as steps grow from 1e-8 s."""
    bars = Bars(2)
    tips = [exu.MarkerBodyPosition(bodyNumber=bars.tip + i, localPosition=[0.5, 0, 0]) for i in range(3)]
    markers = [bars.mbs.AddMarker(tip) for tip in tips]
    for i, j in ((0, 1), (1, 2), (0, 2)):
        spring = exu.SpringDamper(markerNumbers=[markers[i], markers[j]], referenceLength=j - i, stiffness=1e11)
        bars.mbs.AddObject(spring)
    bars.mbs.Assemble()
    s = by_tolerance(1e-6)
    s.timeIntegration.endTime, s.timeIntegration.numberOfSteps = 0.5, 50
    s.timeIntegration.initialStepSize, s.timeIntegration.minimumStepSize = 1e-8, 1e-12
    bars.mbs.SolveDynamic(s, solverType=solver)
    assert bars.mbs.sys["dynamicSolver"].it.singularPositionSteps == 0
    error = np.linalg.norm(bars.tip_output(Variable.Position) - parallelogram(2, [0.5])[0][:2])
    assert error < 1e-4
