"""Solvers that give up, are stopped, or meet errors of user functions."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from oscillators import dynamic_settings, exact_oscillation, mass, oscillator

import dalembert as exu
from dalembert.itemInterface import CoordinateConstraint, Mass1D, Node1D
from dalembert.solver import SolverError


def settings_of(end: float, steps: int) -> Any:
    settings = dynamic_settings(end, steps, tolerance=1e-10)
    settings.timeIntegration.verboseMode = 0
    return settings


def test_singular_matrix_names_the_coordinate() -> None:
    model = oscillator()
    model.mbs.AddObject(
        Mass1D(nodeNumber=model.mbs.AddNode(Node1D(name="loose", referenceCoordinates=[0])), physicsMass=0)
    )
    model.mbs.Assemble()
    with pytest.raises(SolverError) as caught:
        model.mbs.SolveStatic(settings_of(1.0, 10))
    assert (caught.value.causingRow, caught.value.stepIndex) == (1, 1)
    assert "can move without inertia or stiffness in step 1" in caught.value.diagnosis
    assert "'loose'" in caught.value.diagnosis


def test_redundant_constraints() -> None:
    model = oscillator()
    for name in ("first", "second"):
        model.mbs.AddObject(CoordinateConstraint(name=name, markerNumbers=[model.ground, model.marker]))
    model.mbs.Assemble()
    settings = settings_of(1.0, 10)
    settings.redundantConstraints.treat = False
    with pytest.raises(SolverError) as caught:
        model.mbs.SolveDynamic(settings)
    _, _, dependent = caught.value.diagnosis.partition("equations that depend on each other:")
    assert "'first' (ObjectConnectorCoordinate), equation 0" in dependent
    assert "'second' (ObjectConnectorCoordinate), equation 0" in dependent
    settings.linearSolverSettings.ignoreSingularJacobian = True
    settings.linearSolverType = exu.LinearSolverType.EigenDense
    model.mbs.SolveDynamic(settings)
    assert model.position == pytest.approx(0, abs=1e-10)


def hopeless(mbs: Any, t: float, item: int, u: float, v: float, k: float, d: float, offset: float) -> float:
    """No equilibrium exists from 0.35 s on."""
    return k * u if t < 0.35 else 1e7 * (1 if u > 0.1 * np.sin(1e5 * u) else -1)


def test_newton_without_convergence_reports_items_and_remedies() -> None:
    model = oscillator(law=hopeless)
    model.mbs.Assemble()
    settings = settings_of(1.0, 10)
    settings.timeIntegration.adaptiveStep = False
    with pytest.raises(SolverError) as caught:
        model.mbs.SolveDynamic(settings)
    error = caught.value
    assert "Newton's method did not converge in step 4 at time 0.4 (step size 0.1)" in error.diagnosis
    assert error.stepIndex == 4
    assert error.time == pytest.approx(0.4)
    assert error.newtonSteps == settings.timeIntegration.newton.maxIterations
    assert error.residual > 1
    assert "'foot'" in error.diagnosis  # the node whose equation is off


def test_smaller_steps_are_tried_down_to_the_minimum() -> None:
    model = oscillator(law=hopeless)
    model.mbs.Assemble()
    settings = settings_of(1.0, 10)
    settings.timeIntegration.minimumStepSize = 1e-3
    with pytest.raises(SolverError) as caught:
        model.mbs.SolveDynamic(settings)
    assert caught.value.stepSize == pytest.approx(1e-3)
    assert 0.3 <= caught.value.time < 0.36  # steps up to 0.35 s succeed


@pytest.mark.parametrize("solver", [exu.DynamicSolverType.GeneralizedAlpha, exu.DynamicSolverType.RK44])
def test_exception_of_an_item_surfaces_as_itself(solver: Any) -> None:
    def law(mbs: Any, t: float, item: int, u: float, v: float, k: float, d: float, offset: float) -> float:
        if t > 0.55:
            raise LookupError("no such spring")
        return k * u

    model = oscillator(law=law)
    model.mbs.Assemble()
    with pytest.raises(LookupError, match="no such spring") as caught:
        model.mbs.SolveDynamic(settings_of(1.0, 10), solverType=solver)
    notes = "\n".join(caught.value.__notes__)
    assert "springForceUserFunction" in notes
    assert "'spring' (ObjectConnectorCoordinateSpringDamper)" in notes
    assert "in step 6 at time 0.6" in notes
    assert model.table()[-1, 0] == pytest.approx(0.5)  # the last completed step
    assert model.mbs.systemData.GetTime() == pytest.approx(0.5)


@pytest.mark.parametrize("name", ["PreStep", "PostStep", "PostNewton", "PreNewtonResidual", "SystemJacobian", "Events"])
def test_exception_of_a_system_function(name: str) -> None:
    def function(*arguments: Any) -> Any:
        raise ArithmeticError("mine")

    model = oscillator()
    model.mbs.Assemble()
    getattr(model.mbs, f"Set{name}UserFunction")(function)
    with pytest.raises(ArithmeticError, match="mine") as caught:
        model.mbs.SolveDynamic(settings_of(1.0, 10))
    assert f"mbs.{name}UserFunction" in "\n".join(caught.value.__notes__)


@pytest.mark.parametrize("result", ["text", None])
def test_wrong_results_of_a_system_function(result: Any) -> None:
    model = oscillator()
    model.mbs.Assemble()
    model.mbs.SetPostNewtonUserFunction(lambda mbs, t: result)
    with pytest.raises(ValueError, match=r"PostNewtonUserFunction.*expected a list \[error, recommended step size\]"):
        model.mbs.SolveDynamic(settings_of(1.0, 10))


@pytest.fixture
def interruptible() -> Iterator[None]:
    """Python ignores interrupts at the start if tests run in the background."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.mark.usefixtures("interruptible")
def test_interrupt_stops_after_a_complete_step() -> None:
    def law(mbs: Any, t: float, item: int, u: float, v: float, k: float, d: float, offset: float) -> float:
        if t > 0.5 and not sent:
            sent.append(t)
            os.kill(os.getpid(), signal.SIGINT)
        return k * u

    sent: list[float] = []
    model = oscillator(law=law)
    model.mbs.Assemble()
    with pytest.raises(KeyboardInterrupt):
        model.mbs.SolveDynamic(settings_of(1000.0, 1000000))
    time = model.mbs.systemData.GetTime()
    assert 0.49 < time < 100  # soon
    exact = exact_oscillation(time, damping=0.0)  # a state of the solution, not one between
    assert (model.position, model.speed) == pytest.approx(exact, abs=1e-3)


def test_pre_step_function_stops_the_solver() -> None:
    model = oscillator()
    model.mbs.Assemble()
    model.mbs.SetPreStepUserFunction(lambda mbs, t: t < 0.35)
    model.mbs.SolveDynamic(settings_of(1.0, 10))
    assert model.mbs.systemData.GetTime() == pytest.approx(0.4)  # the step in which it was asked for is completed


def test_systems_that_cannot_be_solved_are_refused() -> None:
    model = mass()
    with pytest.raises(RuntimeError, match="not assembled"):
        model.mbs.SolveDynamic(settings_of(1.0, 10), autoAssemble=False)
    empty = exu.SystemContainer().AddSystem()
    empty.Assemble()
    with pytest.raises((ValueError, RuntimeError), match="no unknowns"):
        empty.SolveDynamic(settings_of(1.0, 10))


@pytest.mark.parametrize("solver", ["GeneralizedAlpha", "TrapezoidalIndex2", "ESDIRK43", "ExplicitEuler", "DOPRI5"])
def test_the_state_stays_finite_when_no_step_is_possible(solver: str) -> None:
    """The square of this velocity is not a number, and with it the force of the rod; the initial state remains."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    fast = mbs.CreateMassPoint(
        referencePosition=[1, 0, 0], initialDisplacement=[0, 0.1, 0], initialVelocity=[0, 1e300, 0], physicsMass=1
    )
    mbs.CreateDistanceConstraint(bodyNumbers=[ground, fast], distance=1.0)
    mbs.Assemble()
    before = mbs.systemData.GetSystemState(exu.ConfigurationType.Initial)
    with pytest.raises(SolverError, match="not finite"):
        mbs.SolveDynamic(settings_of(1.0, 10), solverType=getattr(exu.DynamicSolverType, solver))
    for left, initial in zip(mbs.systemData.GetSystemState(), before, strict=True):
        np.testing.assert_array_equal(left, initial)
