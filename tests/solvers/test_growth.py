"""Solutions that stop to be numbers, or grow without bound, and errors that no step size keeps small."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest
from oscillators import Oscillator, dynamic_settings, mass, oscillator

import dalembert as exu
from dalembert.beams import GenerateStraightLineANCFCable2D
from dalembert.itemInterface import (
    Cable2D,
    CoordinateSpringDamper,
    LoadCoordinate,
    MarkerNodeCoordinate,
    Mass1D,
    Node1D,
    NodeGenericODE1,
    ObjectGenericODE1,
)
from dalembert.utilities import CreateSymbolicUserFunction

Solver = exu.DynamicSolverType
STEADY = [
    Solver.ExplicitEuler,
    Solver.ExplicitMidpoint,
    Solver.RK33,
    Solver.RK44,
    Solver.RK67,
    Solver.VelocityVerlet,
]
# Largest product of frequency and step size for which a vibration without damping does not grow.
LIMITS = {Solver.RK33: np.sqrt(3), Solver.RK44: np.sqrt(8), Solver.VelocityVerlet: 2.0}
# The same of a rate of decay: Butcher, Numerical Methods for Ordinary Differential Equations, section 238; velocities of Verlet's method as of Euler's.
DECAYS = {Solver.ExplicitEuler: 2.0, Solver.RK33: 2.5127, Solver.RK44: 2.7853, Solver.VelocityVerlet: 2.0}


def settings_of(end: float, steps: int) -> Any:
    settings = dynamic_settings(end, steps)
    settings.timeIntegration.verboseMode = 0
    return settings


def stiff(stiffness: float = 1e7) -> Oscillator:
    """Some 3162 rad/s."""
    model = oscillator(stiffness=stiffness, damping=0, physics_mass=1)
    model.mbs.Assemble()
    return model


def with_law(law: Any, **parameters: float) -> Oscillator:
    """Compiled expressions return any value; results of functions are checked where they arrive."""
    model = oscillator(law=law, **parameters)
    spring = model.mbs.GetObjectNumber("spring")
    symbolic = CreateSymbolicUserFunction(model.mbs, law, "springForceUserFunction", spring)
    model.mbs.SetObjectParameter(spring, "springForceUserFunction", symbolic)
    model.mbs.Assemble()
    return model


def until_0_555(mbs: Any, t: Any, item: Any, u: Any, v: Any, k: Any, d: Any, offset: Any) -> Any:
    return k * u + 1e-3 * exu.symbolic.sqrt(0.555 - t)


def failure(model: Oscillator, settings: Any, solver: Any = Solver.GeneralizedAlpha) -> exu.SolverError:
    with pytest.raises(exu.SolverError) as caught:
        model.mbs.SolveDynamic(settings, solverType=solver)
    return caught.value


def assert_before(model: Oscillator, error: exu.SolverError) -> None:
    """The system is in the state of the step before, a state of numbers."""
    data = model.mbs.systemData
    assert data.GetTime() == pytest.approx(error.time - error.stepSize, abs=1e-12)
    for part in (data.GetODE2Coordinates(), data.GetODE2Coordinates_t(), data.GetODE2Coordinates_tt()):
        assert np.all(np.isfinite(part))


@pytest.mark.parametrize("solver", STEADY)
@pytest.mark.parametrize("steps", [10, 100])
def test_steps_that_are_too_long_for_an_explicit_solver(solver: Any, steps: int) -> None:
    model = stiff()
    error = failure(model, settings_of(steps * 0.01, steps), solver)
    assert error.reason == "unbounded"
    assert "the solution grows without bound in step" in str(error)
    assert error.values[0]["items"] == "node 0 'foot' (Node1D), coordinate 0"
    assert error.values[0]["vector"] == "ODE2_t"  # speeds are larger than positions at 3162 rad/s
    assert "the fastest vibration at the start, 3162.28 rad/s at node 0 'foot'" in error.advice[0]
    assert any("GeneralizedAlpha" in line for line in error.advice)
    assert_before(model, error)


@pytest.mark.parametrize("solver", LIMITS)
def test_the_step_size_that_is_advised_is_stable(solver: Any) -> None:
    model = stiff()
    found = re.search(
        r"steps up to (\S+) s, timeIntegration.numberOfSteps=(\d+)", str(failure(model, settings_of(1, 100), solver))
    )
    assert found is not None
    step, steps = float(found[1]), int(found[2])
    exact = LIMITS[solver] / np.sqrt(1e7)
    assert 0.97 * exact < step <= exact  # it is searched in steps of 2 %
    assert steps == pytest.approx(1 / step, rel=0.01)
    assert model.mbs.SolveDynamic(settings_of(1, steps), solverType=solver)
    assert abs(model.position) < 0.31  # the amplitude at the start is 0.3
    assert failure(model, settings_of(1, int(0.9 * steps)), solver).reason == "unbounded"


@pytest.mark.parametrize("solver", DECAYS)
def test_damping_limits_steps_as_well(solver: Any) -> None:
    model = oscillator(stiffness=100.0, damping=1e4, physics_mass=1)
    model.mbs.Assemble()
    error = failure(model, settings_of(1, 1000), solver)
    assert error.reason == "unbounded"
    assert "what is damped fastest at the start, by a rate of 9999.99 1/s at node 0 'foot'" in error.advice[0]
    found = re.search(r"steps up to (\S+) s, timeIntegration.numberOfSteps=(\d+)", error.advice[0])
    assert found is not None and 0.97 * DECAYS[solver] < 1e4 * float(found[1]) <= 1.001 * DECAYS[solver]
    assert model.mbs.SolveDynamic(settings_of(1, int(found[2])), solverType=solver) is True
    assert abs(model.position) < 0.31


def test_growth_that_a_nonlinear_model_ends_by_itself() -> None:
    """A cable that is bent beyond recognition within some steps, and then only trembles: a support and masses that
    couple all coordinates. Its bending
    is damped by 0.02 of its stiffness, which has a rate of 5e3 1/s and more."""
    mbs = exu.SystemContainer().AddSystem()
    cable = Cable2D(
        physicsMassPerLength=1, physicsBendingStiffness=2, physicsAxialStiffness=400, physicsBendingDamping=0.04
    )
    GenerateStraightLineANCFCable2D(mbs, [0, 0, 0], [1, 0, 0], 3, cable, [0, -9.81, 0], [1, 1, 0, 1], [0, 0, 0, 0])
    mbs.Assemble()
    assert mbs.SolveDynamic(settings_of(0.2, 2000), solverType=Solver.RK44) is True
    with pytest.raises(exu.SolverError) as caught:
        mbs.SolveDynamic(settings_of(0.2, 400), solverType=Solver.RK44)
    assert caught.value.reason == "unbounded" and "damped fastest" in caught.value.advice[0]


@pytest.mark.parametrize("solver", [*STEADY, Solver.DOPRI5, Solver.GeneralizedAlpha])
def test_physical_growth_is_solved(solver: Any) -> None:
    """A spring that pushes: 0.5 (q0 + v0 / 10) e^(10 t) is 4e15 m after 3.7 s."""
    model = oscillator(stiffness=-100, damping=0, physics_mass=1, position=1, speed=10)
    model.mbs.Assemble()
    settings = settings_of(3.7, 3700)
    settings.timeIntegration.absoluteTolerance = settings.timeIntegration.relativeTolerance = 1e-6
    assert model.mbs.SolveDynamic(settings, solverType=solver)
    # Methods of first and second order miss the rate of growth by 10 h / 2 and less, which 37 time constants make a fifth.
    assert np.log(model.position) == pytest.approx(37, abs=0.2)


@pytest.mark.parametrize("solver", [Solver.RK44, Solver.VelocityVerlet])
def test_large_values_are_solved(solver: Any) -> None:
    """1e15 m, as far as the next stars, at a stable step; then as large a speed, with a spring that such steps let grow but that rests."""
    model = oscillator(stiffness=1e4, damping=0, physics_mass=1, position=1e15, speed=0)
    model.mbs.Assemble()
    assert model.mbs.SolveDynamic(settings_of(2 * np.pi / 100, 1000), solverType=solver)
    assert model.position == pytest.approx(1e15, rel=1e-4)
    model = mass(position=0, speed=1e12)
    model.mbs.Assemble()
    assert model.mbs.SolveDynamic(settings_of(1, 10), solverType=solver)
    assert model.position == pytest.approx(1e12, rel=1e-12)


def test_sizes_that_are_meant_can_be_allowed() -> None:
    model = mass(position=0, speed=1e20)
    model.mbs.Assemble()
    settings = settings_of(1, 10)
    error = failure(model, settings, Solver.RK44)
    assert (error.reason, error.stepIndex) == ("unbounded", 1)
    assert "raise timeIntegration.newton.maximumSolutionNorm" in str(error)
    settings.timeIntegration.newton.maximumSolutionNorm = 1e50
    model.mbs.SolveDynamic(settings, solverType=Solver.RK44)
    assert model.position == pytest.approx(1e20, rel=1e-12)


@pytest.mark.parametrize(
    "solver", [*STEADY, Solver.ODE23, Solver.DOPRI5, Solver.GeneralizedAlpha, Solver.TrapezoidalIndex2]
)
def test_a_function_that_gives_no_number_is_named(solver: Any) -> None:
    model = with_law(until_0_555)
    settings = settings_of(1, 10)
    settings.timeIntegration.adaptiveStep = False
    error = failure(model, settings, solver)
    assert error.reason == "notFinite"
    assert error.sources == ["object 1 'spring' (ObjectConnectorCoordinateSpringDamper)"]
    assert "values that are not finite come from:\n    object 1 'spring'" in str(error)
    assert "node 0 'foot'" in error.values[0]["items"]
    assert 0.555 < error.time <= 0.6 + 1e-12
    assert_before(model, error)


@pytest.mark.parametrize("useNewtonSolver", [True, False])
@pytest.mark.parametrize("modified", [True, False])
def test_implicit_steps_end_with_numbers(useNewtonSolver: bool, modified: bool) -> None:
    """A step of Newton's method without iterations accepted any result."""
    model = with_law(until_0_555)
    settings = settings_of(1, 10)
    settings.timeIntegration.newton.useNewtonSolver = useNewtonSolver
    settings.timeIntegration.newton.useModifiedNewton = modified
    error = failure(model, settings)
    assert error.reason == "notFinite"
    assert error.stepSize == pytest.approx(settings.timeIntegration.minimumStepSize)  # several others fail
    assert 0.555 < error.time < 0.5551


def test_a_smaller_step_may_avoid_nan() -> None:
    """There is no root beyond 0.1 m, where a long step is predicted to end; the wall in front of it is stiff but finite."""

    def law(mbs: Any, t: Any, item: Any, u: Any, v: Any, k: Any, d: Any, offset: Any) -> Any:
        return 200 - 200 * exu.symbolic.sqrt(1 - 10 * u)

    model = with_law(law, position=0, speed=1, physics_mass=1)
    settings = settings_of(0.3, 1)
    assert model.mbs.SolveDynamic(settings)
    assert model.mbs.sys["dynamicSolver"].it.currentStepIndex > 2
    assert model.position < 0.1


def test_static_equilibrium_without_numbers() -> None:
    model = with_law(lambda mbs, t, item, u, v, k, d, offset: exu.symbolic.sqrt(-1 - u))
    settings = settings_of(1, 1)
    settings.staticSolver.verboseMode = 0
    with pytest.raises(exu.SolverError) as caught:
        model.mbs.SolveStatic(settings)
    assert caught.value.reason == "notFinite"
    assert caught.value.sources == ["object 1 'spring' (ObjectConnectorCoordinateSpringDamper)"]
    assert model.position == 0.3


@pytest.mark.parametrize("solver", [Solver.RK44, Solver.DOPRI5, Solver.GeneralizedAlpha])
def test_loads_without_numbers(solver: Any) -> None:
    model = oscillator()
    load = model.mbs.AddLoad(LoadCoordinate(name="gust", markerNumber=model.marker, load=1))
    root = CreateSymbolicUserFunction(
        model.mbs, lambda mbs, t, value: value * exu.symbolic.sqrt(0.25 - t), "loadUserFunction", load
    )
    model.mbs.SetLoadParameter(load, "loadUserFunction", root)
    model.mbs.Assemble()
    error = failure(model, settings_of(1, 10), solver)
    assert (error.reason, error.sources) == ("notFinite", ["load 0 'gust' (LoadCoordinate)"])


@pytest.mark.parametrize("solver", [*STEADY, Solver.DOPRI5, Solver.GeneralizedAlpha])
def test_first_order_equations_without_numbers(solver: Any) -> None:
    """y' = 1e170 y has no number after two steps of a hundredth."""
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(
        NodeGenericODE1(name="tank", referenceCoordinates=[0], initialCoordinates=[1e160], numberOfODE1Coordinates=1)
    )
    mbs.AddObject(ObjectGenericODE1(nodeNumbers=[node], systemMatrix=[[1e170]]))
    mbs.Assemble()
    with pytest.raises(exu.SolverError) as caught:
        mbs.SolveDynamic(settings_of(1, 100), solverType=solver)
    assert caught.value.reason in ("notFinite", "unbounded")
    assert "node 0 'tank' (NodeGenericODE1)" in caught.value.values[0]["items"]
    assert mbs.systemData.GetODE1Coordinates() == pytest.approx([1e160])


@pytest.mark.parametrize("solver", [Solver.ODE23, Solver.DOPRI5])
def test_tolerances_that_no_step_size_holds(solver: Any) -> None:
    """Dry friction without a transition zone holds a mass: its force jumps in every step, at every step size."""

    def law(mbs: Any, t: float, item: int, u: float, v: float, k: float, d: float, offset: float) -> float:
        return 1e4 if v > 0 else -1e4

    model = oscillator(law=law)
    model.mbs.Assemble()
    settings = settings_of(1, 10)
    settings.timeIntegration.automaticStepSize = True
    error = failure(model, settings, solver)
    assert error.reason == "errorControl"
    assert error.stepSize == settings.timeIntegration.minimumStepSize
    assert error.values[0]["items"] == "node 0 'foot' (Node1D), coordinate 0"
    assert error.values[0]["value"] > 1  # tolerances
    assert model.mbs.sys["dynamicSolver"].it.currentStepIndex < 1000
    assert any("minimumStepSize" in line for line in error.advice)
    assert_before(model, error)


@pytest.mark.parametrize("solver", [Solver.ODE23, Solver.DOPRI5])
def test_a_jump_is_passed(solver: Any) -> None:
    """A force that is switched on at 0.4 s: q = (t - 0.4)^2 / 2 behind it, for 1 N on 1 kg."""
    model = oscillator(law=lambda mbs, t, *rest: -1.0 if t >= 0.4 else 0.0, physics_mass=1, position=0, speed=0)
    model.mbs.Assemble()
    settings = settings_of(1, 10)
    settings.timeIntegration.automaticStepSize = True
    assert model.mbs.SolveDynamic(settings, solverType=solver)
    assert model.position == pytest.approx(0.18, abs=1e-6)


@pytest.mark.parametrize("solver", [Solver.ODE23, Solver.DOPRI5])
def test_tolerances_that_cancel_with_a_value(solver: Any) -> None:
    """Absolute and relative tolerance give a scale of zero at -1: nothing over nothing is no error."""
    model = mass(position=-1, speed=0)
    model.mbs.Assemble()
    settings = settings_of(1, 10)
    settings.timeIntegration.automaticStepSize = True
    settings.timeIntegration.absoluteTolerance = settings.timeIntegration.relativeTolerance = 1e-8
    assert model.mbs.SolveDynamic(settings, solverType=solver)
    assert model.mbs.sys["dynamicSolver"].it.currentStepIndex <= 20
    assert model.position == -1


@pytest.mark.parametrize("solver", [Solver.ODE23, Solver.DOPRI5])
def test_constant_steps_of_methods_with_error_control(solver: Any) -> None:
    model = oscillator()
    model.mbs.Assemble()
    settings = settings_of(1, 10)
    settings.timeIntegration.absoluteTolerance = settings.timeIntegration.relativeTolerance = 1e-14
    assert model.mbs.SolveDynamic(settings, solverType=solver)  # automaticStepSize is False
    assert model.mbs.sys["dynamicSolver"].it.currentStepIndex == 11


def test_the_coordinate_that_grows_is_named_among_many() -> None:
    model = oscillator()
    others = [model.mbs.AddNode(Node1D(name=f"other{i}", referenceCoordinates=[0])) for i in range(20)]
    for node in others:
        model.mbs.AddObject(Mass1D(nodeNumber=node, physicsMass=1e-9 if node == others[7] else 1))
    for node in others:
        marker = model.mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
        model.mbs.AddObject(CoordinateSpringDamper(markerNumbers=[model.ground, marker], stiffness=100))
        model.mbs.AddLoad(LoadCoordinate(markerNumber=marker, load=1))
    model.mbs.Assemble()
    error = failure(model, settings_of(1, 100), Solver.VelocityVerlet)
    assert "'other7'" in error.values[0]["items"]
    assert "316228 rad/s at node 9 'other7'" in error.advice[0]
