"""Generalized alpha with step sizes from an estimated error."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from solving import Variable, new_system, settings
from test_andrews import END, Squeezer, angles
from test_explicit_joints import carried_mass

import dalembert as exu
from dalembert.solver import SolverError


def tolerances(end: float, tolerance: float, largest_step: float) -> Any:
    s = settings(end, int(round(end / largest_step)), spectral_radius=0.8)
    t = s.timeIntegration
    t.absoluteTolerance = t.relativeTolerance = tolerance
    t.initialStepSize = 1e-5
    s.stepSizeControl.implicitSolvers = True
    return s


def squeezer(tolerance: float) -> tuple[float, Any]:
    mechanism = Squeezer()
    mechanism.mbs.SolveDynamic(tolerances(0.03, tolerance, 0.001))
    return float(np.abs(mechanism.angles() - angles(END)).max()), mechanism.mbs.sys["dynamicSolver"].it


def test_the_squeezer_by_tolerances() -> None:
    """Errors are as small as tolerances, nearly; steps grow by their square root, as the estimate is of second order."""
    results = {tolerance: squeezer(tolerance) for tolerance in (1e-4, 1e-5, 1e-6)}
    for tolerance, (error, it) in results.items():
        assert error < 20 * tolerance
        assert it.rejectedAutomaticStepSizeSteps < it.currentStepIndex / 10
        assert it.currentTime == pytest.approx(0.03, abs=1e-12)
    steps = [it.currentStepIndex for _, it in results.values()]
    for fewer, more in zip(steps[:-1], steps[1:], strict=True):
        assert more / fewer == pytest.approx(np.sqrt(10), rel=0.2)


def test_limits_of_steps() -> None:
    """Loose tolerances leave the largest step; tight ones never reach it. The last step is the rest."""
    mechanism = Squeezer()
    mechanism.mbs.SolveDynamic(tolerances(0.002, 1.0, 1e-4))
    it = mechanism.mbs.sys["dynamicSolver"].it
    assert it.largestStepSize == it.maxStepSize
    assert it.smallestStepSize == 1e-5  # the first one
    growing = 8  # at most: steps grow by half at least
    assert it.currentStepIndex - 1 - growing <= it.stepsAtMaximumStepSize < it.currentStepIndex - 1
    _, it = squeezer(1e-6)
    assert it.stepsAtMaximumStepSize == 0
    assert 0 < it.smallestStepSize < it.largestStepSize < it.maxStepSize
    assert (
        f"step sizes:                        {it.smallestStepSize:.3g} to {it.largestStepSize:.3g} s" in it.ToString()
    )


@pytest.mark.parametrize("cause", ["rejectedNewtonSteps", "rejectedDiscontinuousSteps"])
def test_why_steps_are_repeated(cause: str) -> None:
    """Two iterations are not enough for a large step of a pendulum; a single discontinuous iteration does not include a
    beginning contact."""
    mbs = new_system()
    s = settings(0.5, 5)
    if cause == "rejectedNewtonSteps":
        mass = mbs.CreateMassPoint(physicsMass=1, referencePosition=[1, 0, 0], gravity=[0, -9.81, 0])
        mbs.CreateDistanceConstraint(bodyNumbers=[mbs.CreateGround(), mass])
        s.timeIntegration.newton.maxIterations = 2
    else:
        ground = mbs.AddNode(exu.NodePointGround())
        ball = mbs.AddNode(exu.NodePoint(referenceCoordinates=[0, 1, 0]))
        mbs.AddObject(exu.MassPoint(nodeNumber=ball, physicsMass=1))
        markers = [
            mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=n, coordinate=1 if n == ball else 0))
            for n in (ground, ball)
        ]
        mbs.AddLoad(exu.LoadCoordinate(markerNumber=markers[1], load=-9.81))
        state = mbs.AddNode(exu.NodeGenericData(numberOfDataCoordinates=1, initialCoordinates=[1]))
        mbs.AddObject(
            exu.ObjectContactCoordinate(markerNumbers=markers, nodeNumber=state, contactStiffness=1e4, contactDamping=0)
        )
        s.timeIntegration.discontinuous.maxIterations = 1
        s.timeIntegration.discontinuous.ignoreMaxIterations = False
    mbs.Assemble()
    mbs.SolveDynamic(s)
    it = mbs.sys["dynamicSolver"].it
    counts = {name: getattr(it, name) for name in ("rejectedNewtonSteps", "rejectedDiscontinuousSteps")}
    assert counts.pop(cause) > 0
    assert set(counts.values()) == {0}
    assert it.rejectedAutomaticStepSizeSteps == it.stepsAtMaximumStepSize == it.largestStepSize == 0
    told = {"rejectedNewtonSteps": "by Newton's method", "rejectedDiscontinuousSteps": "by contact or friction"}[cause]
    assert f"steps repeated ({getattr(it, cause)} {told})" in str(mbs.Report())


def mass_on_spring(jump: float) -> Any:
    mbs = new_system()
    mass = mbs.CreateMassPoint(physicsMass=1, referencePosition=[1, 0, 0])
    spring = mbs.CreateSpringDamper(bodyNumbers=[mbs.CreateGround(), mass], stiffness=100, damping=0, referenceLength=1)
    del spring
    marker = mbs.AddMarker(exu.itemInterface.MarkerBodyPosition(bodyNumber=mass))
    mbs.AddLoad(
        exu.itemInterface.LoadForceVector(
            markerNumber=marker,
            loadVector=[1, 0, 0],
            loadVectorUserFunction=lambda mbs, t, load: [10.0 if t > jump else 0.0, 0, 0],
        )
    )
    mbs.Assemble()
    return mbs


def test_a_load_that_jumps() -> None:
    """Large steps before it, small ones at it."""
    mbs = mass_on_spring(0.5)
    s = tolerances(1, 1e-6, 0.1)
    times: list[float] = []
    mbs.SetPostStepUserFunction(lambda mbs, t: bool(times.append(t)) or True)
    mbs.SolveDynamic(s)
    steps = np.diff([0.0, *times])
    assert steps[: np.searchsorted(times, 0.49)].max() == pytest.approx(0.1, rel=0.3)
    assert steps.min() < 2e-3 and times[int(np.argmin(steps))] < 0.52
    wanted = 0.1 * (1 - np.cos(10 * 0.5))
    assert mbs.GetNodeOutput(0, Variable.Displacement)[0] == pytest.approx(wanted, abs=2e-3)
    assert mbs.sys["dynamicSolver"].it.rejectedAutomaticStepSizeSteps > 0


def test_the_smallest_step_is_kept_with_a_warning(capfd: Any) -> None:
    s = tolerances(1, 1e-10, 0.1)
    s.timeIntegration.minimumStepSize = 0.02
    s.timeIntegration.initialStepSize = 0.02
    mass_on_spring(0.0).SolveDynamic(s)
    assert capfd.readouterr().out.count("automatic step size reached timeIntegration.minimumStepSize") == 1


def test_errors_above_the_tolerances_end_the_solution() -> None:
    s = tolerances(20, 1e-10, 0.1)
    s.timeIntegration.minimumStepSize = s.timeIntegration.initialStepSize = 0.02
    with pytest.raises(SolverError) as caught:
        mass_on_spring(0.0).SolveDynamic(s)
    assert caught.value.reason == "errorControl"


def pushed_mass() -> tuple[Any, Any]:
    """The mass of `carried_mass`, which a force moves in the same way."""
    mbs = new_system()
    node = mbs.AddNode(exu.NodePoint2D(referenceCoordinates=[0, 0], initialVelocities=[1.5, 0]))
    mbs.AddObject(exu.MassPoint2D(nodeNumber=node, physicsMass=2.0))
    marker = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
    mbs.AddLoad(exu.LoadCoordinate(markerNumber=marker, loadUserFunction=lambda mbs, t, load: -9 * np.sin(3 * t)))
    mbs.Assemble()
    return mbs, node


@pytest.mark.parametrize("tells_rates", [True, False])
@pytest.mark.parametrize("tolerance", [1e-5, 1e-7])
def test_driven_models_take_the_steps_of_free_ones(tolerance: float, tells_rates: bool) -> None:
    """x = sin(3 t) / 2, by a constraint and by a force. Velocities are known to a few tolerances of a step, or to the sum of its errors."""
    carried, steps = carried_mass(), []
    if not tells_rates:
        carried[0].SetObjectParameter(1, "offsetUserFunction_t", 0)
    for (mbs, node), allowed in ((carried, 4), (pushed_mass(), 25)):
        assert mbs.SolveDynamic(tolerances(1, tolerance, 0.05))
        assert mbs.GetNodeOutput(node, Variable.Velocity)[0] == pytest.approx(1.5 * np.cos(3), abs=allowed * tolerance)
        steps.append(mbs.sys["dynamicSolver"].it.currentStepIndex)
    assert steps[0] == pytest.approx(steps[1], rel=0.02)


def test_without_the_setting_steps_are_equal() -> None:
    s = tolerances(1, 1e-6, 0.1)
    s.stepSizeControl.implicitSolvers = False
    mbs = mass_on_spring(0.5)
    mbs.SolveDynamic(s)
    assert mbs.sys["dynamicSolver"].it.currentStepIndex == 11
