"""What has finished and is not to be trusted says so."""

from __future__ import annotations

import pickle
from typing import Any

import pytest
from oscillators import dynamic_settings, friction_or_stop, mass, oscillator

import dalembert as exu
from dalembert.utilities import InertiaCuboid

Solver = exu.DynamicSolverType


def doubts(mbs: Any, settings: Any, solver: Any = Solver.GeneralizedAlpha) -> list[str]:
    result = mbs.SolveDynamic(settings, solverType=solver)
    assert result
    assert result == True  # noqa: E712  as a number, it is
    solved = mbs.sys["dynamicSolver"]
    found: list[str] = solved.GetDoubts()
    told = list(result.doubts) if isinstance(result, exu.FinishedNotTrusted) else []
    assert told == found and (result is True) == (found == [])
    assert solved.output.finishedSuccessfully and solved.output.trusted == (found == [])
    return found


def test_the_value_that_is_returned_tells() -> None:
    value = exu.FinishedNotTrusted(["one reason", "another one"])
    assert value and repr(value) == str(value) == "finished, not trusted: one reason; another one"
    again = pickle.loads(pickle.dumps(value))
    assert again == value == 1 and again.doubts == value.doubts == ("one reason", "another one")


def test_nothing_speaks_against_a_good_solution() -> None:
    model = oscillator()
    model.mbs.Assemble()
    assert doubts(model.mbs, dynamic_settings(1.0, 100)) == []
    assert not exu.MainSolverImplicitSecondOrder().output.trusted


@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.DOPRI5])
def test_errors_above_the_tolerances(solver: Any, capfd: Any) -> None:
    model = oscillator()
    model.mbs.Assemble()
    settings = dynamic_settings(1.0, 20)
    settings.timeIntegration.automaticStepSize = settings.stepSizeControl.implicitSolvers = True
    settings.timeIntegration.minimumStepSize = 0.04
    settings.timeIntegration.absoluteTolerance = settings.timeIntegration.relativeTolerance = 1e-12
    settings.timeIntegration.verboseMode = 1
    (doubt,) = doubts(model.mbs, settings, solver)
    steps = model.mbs.sys["dynamicSolver"].it.stepsAboveTolerance
    assert steps > 10 and doubt.startswith(f"errors above the tolerances in {steps} steps")
    assert f"not to be trusted: {doubt}" in capfd.readouterr().out
    assert f"not to be trusted: {doubt}" in model.mbs.Report()


def test_friction_that_has_not_settled() -> None:
    model = mass()
    friction_or_stop(model, slips=-1, fDynamicFriction=20.0, stickingStiffness=1e6)
    model.mbs.Assemble()
    settings = dynamic_settings(1.0, 20)
    settings.timeIntegration.discontinuous.maxIterations = 1
    (doubt,) = doubts(model.mbs, settings)
    assert doubt.startswith("contact or friction that has not settled in ")


def test_gaps_at_the_end() -> None:
    """Constraints of velocities, with steps in which a pendulum turns by half a radian."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    body = mbs.CreateRigidBody(
        inertia=InertiaCuboid(1000, [1, 0.1, 0.2]), referencePosition=[0.5, 0, 0], gravity=[0, -9.81, 0]
    )
    mbs.CreateRevoluteJoint(name="hinge", bodyNumbers=[ground, body], position=[0, 0, 0], axis=[0, 0, 1])
    mbs.Assemble()
    (doubt,) = doubts(mbs, dynamic_settings(2.0, 30), Solver.TrapezoidalIndex2)
    assert doubt.startswith("open at the end: ") and "'hinge'" in doubt
    assert doubts(mbs, dynamic_settings(2.0, 30)) == []
