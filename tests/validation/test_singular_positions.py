"""Four-bars that pass their flat position with steps by tolerances: they follow the branch of the velocities, or
warn."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from solving import Solver, Variable, new_system, settings
from test_four_bar import GRAVITY, Bars, parallelogram
from tolerances import by_tolerance

import dalembert as exu
from dalembert.solver import SolverError

END = 5.0
# Of a motion of 0.5 m: a thousand times the error of steps of 0.1 ms, and a hundred times the tolerance 1e-6.
OF_SLOW_STARTS = 1e-4


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
        # Errors of higher order: ten to a hundred times the tolerance per second, and the effect of differences of
        # 1e-11 close to the flat position.
        (Solver.ODE23, 1e-6, 5e-4),
        (Solver.DOPRI5, 1e-8, 1e-6),
        (Solver.DOP853, 1e-8, 1e-6),
    ],
)
def test_the_flat_position_is_passed(solver: Any, tolerance: float, most: float, loops: int) -> None:
    bars = Bars(loops)
    bars.mbs.SolveDynamic(by_tolerance(settings(END, 50), tolerance), solverType=solver)
    assert error_of(bars) < most
    assert bars.mbs.sys["dynamicSolver"].output.trusted


@pytest.mark.parametrize("loops", [1, 2, 5])
@pytest.mark.parametrize(
    ("solver", "tolerance"),
    [
        *((Solver.TrapezoidalIndex2, tolerance) for tolerance in (1e-7, 1e-8)),
        (Solver.GeneralizedAlpha, 1e-8),
        *((Solver.ODE23, tolerance) for tolerance in (1e-8, 1e-10)),
        (Solver.DOPRI5, 1e-10),
        (Solver.DOP853, 1e-10),
    ],
)
def test_no_other_branch_without_a_word(solver: Any, tolerance: float, loops: int) -> None:
    """Small steps end close to the flat position, or in it."""
    bars = Bars(loops)
    try:
        bars.mbs.SolveDynamic(by_tolerance(settings(END, 50), tolerance), solverType=solver)
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
    bars.mbs.SolveDynamic(by_tolerance(settings(END, 50), tolerance), solverType=Solver.ESDIRK43)
    assert error_of(bars) < 1000 * tolerance
    angles = [bars.mbs.GetObjectOutputBody(bars.tip + i, Variable.Rotation, [0, 0, 0]) for i in range(loops + 1)]
    assert np.ptp(angles) < 1e-9
    assert bars.mbs.sys["dynamicSolver"].output.trusted


def test_steps_that_pass_it_are_reported(capfd: Any) -> None:
    """Of 63 000."""
    bars, s = Bars(2), by_tolerance(settings(END, 50), 1e-8)
    s.timeIntegration.verboseMode = 1
    bars.mbs.SolveDynamic(s)
    steps = bars.mbs.sys["dynamicSolver"].it.singularPositionSteps
    assert 0 < steps < 1000 and "passing a singular position" in capfd.readouterr().out
    assert f"singular configurations were passed in {steps} steps" in bars.mbs.Report()


@pytest.mark.parametrize(
    ("rest", "tolerance", "times"), [(1e-4, 1e-5, 1), (1e-5, 1e-4, 1), (1e-6, 1e-4, 1), (-0.2, 1e-4, 0)]
)
def test_rests_beside_the_flat_position_are_told(rest: float, tolerance: float, times: int, capfd: Any) -> None:
    """Two loops rise from 0.3 rad below: errors determine how a mechanism at rest just beyond it falls back."""
    start, loops = -0.3, 2
    factor = ((loops + 1) / 2 + loops) / ((loops + 1) / 3 + loops)
    rate = float(np.sqrt(2 * GRAVITY * factor * (np.sin(rest) - np.sin(start))))
    bars = Bars(loops, angle=start, rate=rate)
    bars.mbs.SolveDynamic(by_tolerance(settings(0.5, 50), tolerance), solverType=Solver.DOP853)
    told = capfd.readouterr().out
    assert told.count("comes nearly to rest beside a singular position") == times
    assert (told.count("follow from others in this position") > 0) == (times > 0)


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
    s = by_tolerance(settings(END, 50), 1e-6)
    s.timeIntegration.endTime, s.timeIntegration.numberOfSteps = 0.5, 50
    s.timeIntegration.initialStepSize, s.timeIntegration.minimumStepSize = 1e-8, 1e-12
    bars.mbs.SolveDynamic(s, solverType=solver)
    assert bars.mbs.sys["dynamicSolver"].it.singularPositionSteps == 0
    error = np.linalg.norm(bars.tip_output(Variable.Position) - parallelogram(2, [0.5])[0][:2])
    assert error < 1e-4


def test_starts_in_the_flat_position_that_round_off_spoils_name_methods_that_do_not_suffer() -> None:
    """Errors of positions at 1e-10 are those of round-off by the sine of a small angle; acceleration constraints have
    none."""
    bars = Bars(2, angle=0, rate=-3)
    s = by_tolerance(settings(END, 50), 1e-10)
    s.timeIntegration.endTime = 0.03
    with pytest.raises(SolverError) as refused:
        bars.mbs.SolveDynamic(s, solverType=Solver.GeneralizedAlpha)
    assert refused.value.reason == "toleranceBelowRoundOff"
    assert "ESDIRK43" in refused.value.advice[0] and "singular position" in refused.value.advice[0]
    wanted = parallelogram(2, [0.03], (0, -3))[0][:2]
    for solver in (Solver.ESDIRK43, Solver.DOPRI5):
        bars = Bars(2, angle=0, rate=-3)
        assert bars.mbs.SolveDynamic(s, solverType=solver)
        np.testing.assert_allclose(bars.tip_output(Variable.Position), wanted, rtol=0, atol=1e-9)


@pytest.mark.parametrize(
    ("solver", "loops", "angle", "rate", "steps", "tolerance"),
    [
        (Solver.GeneralizedAlpha, 1, 1e-5, 0, 3000, None),
        (Solver.GeneralizedAlpha, 5, 1e-6, 1e-3, 300, None),
        (Solver.GeneralizedAlpha, 2, 0, -1e-3, 3000, None),
        (Solver.GeneralizedAlpha, 5, 0, 0, 30, 1e-6),
        (Solver.DOP853, 5, 1e-12, 1e-6, 30, 1e-8),
        (Solver.ESDIRK43, 2, 1e-6, 1e-3, 300, None),
    ],
)
def test_singular_positions_that_end_a_solution_are_named(
    solver: Any, loops: int, angle: float, rate: float, steps: int, tolerance: float | None
) -> None:
    """Weight takes slow links through the flat position within a millisecond, at most 1e-5 rad away from it, where
    round-off decides whether a solver passes: then it continues correctly. Otherwise, the error names the joints."""
    bars, s = Bars(loops, angle=angle, rate=rate), by_tolerance(settings(END, 50), tolerance or 1e-6)
    s.timeIntegration.automaticStepSize = tolerance is not None
    s.timeIntegration.endTime, s.timeIntegration.numberOfSteps = 0.3, steps
    try:
        bars.mbs.SolveDynamic(s, solverType=solver)
    except SolverError as refused:
        error = refused
    else:
        wanted = parallelogram(loops, [0.3], (angle, rate))[0][:2]
        np.testing.assert_allclose(bars.tip_output(Variable.Position), wanted, rtol=0, atol=OF_SLOW_STARTS)
        return
    assert error.reason == "singularPosition"
    assert len(error.dependentEquations) > 2 * loops
    assert all("follow from others" in text or "more" in text for text in error.dependentEquations)
    assert "JointRevolute2D" in error.dependentEquations[0] and len(error.advice) > 1
    names_positions = any("keep the constraints of positions" in text for text in error.advice)
    assert names_positions == (solver != Solver.GeneralizedAlpha)


def test_failures_elsewhere_are_not_those_of_singular_positions() -> None:
    """A single iteration does not suffice in the upright position, where no joint is redundant."""
    bars, s = Bars(2), settings(0.1, 1)
    s.timeIntegration.newton.maxIterations = 1
    s.timeIntegration.adaptiveStep = False
    with pytest.raises(SolverError) as refused:
        bars.mbs.SolveDynamic(s)
    assert refused.value.reason == "newton" and refused.value.dependentEquations == []


@pytest.mark.parametrize("rate", [0, -1e-5, -1e-3, -1e-1])
@pytest.mark.parametrize(
    "solver", [Solver.GeneralizedAlpha, Solver.TrapezoidalIndex2, Solver.DOPRI5, Solver.DOP853, Solver.ESDIRK43]
)
@pytest.mark.parametrize("by", ["steps", "tolerance"])
def test_slow_starts_in_the_flat_position_do_not_contradict(solver: Any, rate: float, by: str, capfd: Any) -> None:
    """Constraints that are redundant in the flat position are independent close to it, for any duration of the
    approach."""
    bars, s = Bars(2, angle=0, rate=rate), by_tolerance(settings(END, 50), 1e-6)
    s.timeIntegration.endTime, s.timeIntegration.numberOfSteps = 0.3, 3000
    s.timeIntegration.automaticStepSize = by == "tolerance"
    reason = ""
    try:
        bars.mbs.SolveDynamic(s, solverType=solver)
    except SolverError as error:
        reason = error.reason
    told = capfd.readouterr().out
    assert "contradict" not in told
    if reason:
        assert reason in ("errorControl", "newton", "singularPosition")
        return
    error = np.linalg.norm(bars.tip_output(Variable.Position) - parallelogram(2, [0.3], (0, rate))[0][:2])
    solved = bars.mbs.sys["dynamicSolver"]
    assert error < OF_SLOW_STARTS or not solved.output.trusted or "starts in a singular position" in told


@pytest.mark.parametrize("rate", [-1e-2, -1e-3, -1e-5])
@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.ESDIRK43])
def test_slow_starts_follow_their_velocities(solver: Any, rate: float) -> None:
    """Weight turns them within a millisecond, before they have led away from the flat position, but in the same way out of it."""
    bars, s = Bars(2, angle=0, rate=rate), by_tolerance(settings(END, 50), 1e-6)
    s.timeIntegration.endTime, s.timeIntegration.numberOfSteps = 0.3, 30
    bars.mbs.SolveDynamic(s, solverType=solver)
    wanted = parallelogram(2, [0.3], (0, rate))[0][:2]
    np.testing.assert_allclose(bars.tip_output(Variable.Position), wanted, rtol=0, atol=1e-5)


@pytest.mark.parametrize(
    ("solver", "loops", "rate", "steps"),
    [
        (Solver.GeneralizedAlpha, 1, 1e-3, 3000),
        (Solver.ESDIRK43, 2, -1e-3, 300),
        (Solver.ESDIRK43, 5, -1e-3, None),
    ],
)
def test_branches_that_round_off_decides_are_told(solver: Any, loops: int, rate: float, steps: Any, capfd: Any) -> None:
    """Weight turns velocities within 0.1 ms, in which they lead 1e-7 rad away from the flat position: its square is
    round-off. The motion continues correctly, or a warning is given."""
    bars, s = Bars(loops, angle=0, rate=rate), by_tolerance(settings(END, 50), 1e-4)
    s.timeIntegration.endTime = 0.3
    s.timeIntegration.automaticStepSize = steps is None
    s.timeIntegration.numberOfSteps = steps or 30
    try:
        assert bars.mbs.SolveDynamic(s, solverType=solver)
    except SolverError as error:
        assert error.reason == "singularPosition"
        return
    wanted = parallelogram(loops, [0.3], (0, rate))[0][:2]
    error_at_end = np.linalg.norm(bars.tip_output(Variable.Position) - wanted)
    assert error_at_end < OF_SLOW_STARTS or capfd.readouterr().out.count("starts in a singular position") == 1


class SliderCrank:
    """Crank and rod of one meter, upright together, where the slider may pass or stay: the crank turns on at 2 rad/s and takes it along."""

    def __init__(self, stiffness: float, rate: float = 2.0) -> None:
        self.mbs, self.rate = new_system(), rate
        ground = self.mbs.AddObject(exu.ObjectGround())
        crank = self.bar([0, 0.5, np.pi / 2], [-self.rate / 2, 0, self.rate])
        rod = self.bar([0, 0.5, -np.pi / 2], [-1.5 * self.rate, 0, -self.rate])
        node = self.mbs.AddNode(exu.NodePoint2D(initialVelocities=[-2 * self.rate, 0]))
        self.slider = self.mbs.AddObject(exu.MassPoint2D(physicsMass=1, nodeNumber=node))
        self.join((ground, [0, 0, 0]), (crank, [-0.5, 0, 0]))
        self.join((crank, [0.5, 0, 0]), (rod, [-0.5, 0, 0]))
        self.join((rod, [0.5, 0, 0]), (self.slider, [0, 0, 0]))
        fixed, along, across = (
            self.mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=n, coordinate=i))
            for n, i in ((self.mbs.AddNode(exu.NodePointGround()), 0), (node, 0), (node, 1))
        )
        self.mbs.AddObject(exu.CoordinateConstraint(markerNumbers=[fixed, across]))
        self.mbs.AddObject(exu.CoordinateSpringDamper(markerNumbers=[fixed, along], stiffness=stiffness))
        self.mbs.Assemble()

    def bar(self, reference: list[float], velocities: list[float]) -> Any:
        node = self.mbs.AddNode(exu.NodeRigidBody2D(referenceCoordinates=reference, initialVelocities=velocities))
        return self.mbs.AddObject(exu.RigidBody2D(physicsMass=1, physicsInertia=1 / 12, nodeNumber=node))

    def join(self, *ends: tuple[Any, list[float]]) -> None:
        markers = [self.mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=b, localPosition=p)) for b, p in ends]
        self.mbs.AddObject(exu.RevoluteJoint2D(markerNumbers=markers))

    def place(self) -> float:
        return float(self.mbs.GetObjectOutputBody(self.slider, Variable.Position, [0, 0, 0])[0])

    def reference(self, stiffness: float, end: float) -> float:
        """Solution in one coordinate, the angle: inertia 2/3 + 6 sin^2, slider at 2 cos."""

        def rates(t: float, x: np.ndarray) -> list[float]:
            sin, cos = np.sin(x[0]), np.cos(x[0])
            return [x[1], (4 * stiffness * sin * cos - 6 * sin * cos * x[1] ** 2) / (2 / 3 + 6 * sin**2)]

        return float(
            2 * np.cos(solve_ivp(rates, [0, end], [np.pi / 2, self.rate], "DOP853", rtol=1e-12, atol=1e-12).y[0, -1])
        )


@pytest.mark.parametrize("rate", [2.0, -2.0])
@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.DOPRI5, Solver.ESDIRK43])
def test_a_slider_crank_that_starts_in_its_dead_centre(solver: Any, rate: float, capfd: Any) -> None:
    """A spring of 1 kN/m leaves time to determine the branch; one of 1 MN/m, of 800 rad/s, changes accelerations within
    the first moments."""
    model = SliderCrank(1e3, rate)
    s = settings(0.02, 100)
    s.timeIntegration.automaticStepSize = False
    model.mbs.SolveDynamic(s, solverType=solver)
    # Generalized alpha: (omega h)^2 / 12 of 25 rad/s in steps of 0.2 ms is 2e-6, of 8 cm.
    assert model.place() == pytest.approx(
        model.reference(1e3, 0.02), abs=3e-7 if solver == Solver.GeneralizedAlpha else 1e-8
    )
    assert "starts in a singular position" not in capfd.readouterr().out
    s = settings(0.01, 20)
    s.timeIntegration.automaticStepSize = False
    SliderCrank(1e6, rate).mbs.SolveDynamic(s, solverType=solver)
    assert capfd.readouterr().out.count("starts in a singular position") == 1


@pytest.mark.parametrize("stiffness", [1e6, 1e7, 1e8])
@pytest.mark.parametrize("steps", [20, 200, 2000])
@pytest.mark.parametrize("solver", [Solver.DOPRI5, Solver.DOP853, Solver.ESDIRK43])
def test_stiff_springs_in_the_dead_centre_lead_nowhere_else_without_a_word(
    solver: Any, steps: int, stiffness: float, capfd: Any
) -> None:
    """The slider swings, by twice the rate over the square root of 0.6 times the stiffness; it remains at rest on the
    other branch."""
    model, s = SliderCrank(stiffness), settings(0.01, steps)
    s.timeIntegration.automaticStepSize = False
    try:
        model.mbs.SolveDynamic(s, solverType=solver)
    except SolverError as error:
        assert error.reason in ("singularPosition", "newton")
        return
    told = capfd.readouterr().out
    assert "contradict" not in told
    swing = 2 * model.rate / np.sqrt(0.6 * stiffness)
    assert abs(model.place() - model.reference(stiffness, 0.01)) < swing / 5 or "starts in a singular position" in told
