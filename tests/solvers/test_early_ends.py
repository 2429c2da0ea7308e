"""The state of a system when a solution ends early, and the outputs that report the end."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from oscillators import Oscillator, dynamic_settings, friction_or_stop, oscillator

import dalembert as exu
from dalembert.itemInterface import (
    LoadCoordinate,
    MarkerNodeCoordinate,
    Mass1D,
    Node1D,
    NodeGenericODE1,
    ObjectConnectorCoordinate,
    ObjectGenericODE1,
)
from dalembert.solver import SolverError, SolverSuccess

Solver = exu.DynamicSolverType
IMPLICIT = [Solver.GeneralizedAlpha, Solver.TrapezoidalIndex2]
EXPLICIT = [Solver.RK44, Solver.VelocityVerlet]
GOOD_STEPS = 3
PARTS = (
    "ODE2Coordinates",
    "ODE2Coordinates_t",
    "ODE2Coordinates_tt",
    "ODE1Coordinates",
    "AECoordinates",
    "DataCoordinates",
)


def settings_of(steps: int, adaptive: bool = False) -> Any:
    settings = dynamic_settings(0.01 * steps, steps)
    settings.timeIntegration.adaptiveStep = settings.staticSolver.adaptiveStep = adaptive
    settings.timeIntegration.minimumStepSize = settings.staticSolver.minimumStepSize = 1e-5
    settings.timeIntegration.verboseMode = settings.staticSolver.verboseMode = 0
    settings.timeIntegration.discontinuous.ignoreMaxIterations = False
    return settings


def everything(law: Any) -> Oscillator:
    """A model with coordinates of all kinds; `law(t, u)` is the force of a spring."""
    model = oscillator(law=lambda mbs, t, item, u, *rest: law(t, u))
    friction_or_stop(model, fDynamicFriction=0.5, frictionProportionalZone=1e-3)
    mbs = model.mbs
    tank = mbs.AddNode(NodeGenericODE1(referenceCoordinates=[0], initialCoordinates=[1], numberOfODE1Coordinates=1))
    mbs.AddObject(ObjectGenericODE1(nodeNumbers=[tank], systemMatrix=[[-2]]))
    return model


def with_constraint(law: Any) -> Oscillator:
    model = everything(law)
    mbs = model.mbs
    node = mbs.AddNode(Node1D(referenceCoordinates=[0], initialCoordinates=[0.3], initialVelocities=[-0.7]))
    mbs.AddObject(Mass1D(nodeNumber=node, physicsMass=1))
    marker = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
    mbs.AddObject(ObjectConnectorCoordinate(markerNumbers=[model.marker, marker]))
    return model


def state_of(mbs: Any) -> dict[str, Any]:
    data = mbs.systemData
    return {"time": data.GetTime()} | {part: np.array(getattr(data, f"Get{part}")()) for part in PARTS}


def assert_state_of_step(model: Oscillator, build: Callable[[], Oscillator], solver: Any) -> None:
    """Bit for bit the state that the good steps alone lead to."""
    good = build()
    good.mbs.Assemble()
    settings = settings_of(GOOD_STEPS)
    good.mbs.SolveStatic(settings) if solver == "static" else good.mbs.SolveDynamic(settings, solverType=solver)
    found, expected = state_of(model.mbs), state_of(good.mbs)
    assert found.pop("time") == pytest.approx(expected.pop("time"), abs=1e-14)
    assert found.keys() == expected.keys()
    for part, values in expected.items():
        np.testing.assert_array_equal(found[part], values, err_msg=part)


def calm(t: float, u: float) -> float:
    return 80 * u


def hopeless(t: float, u: float) -> float:
    """No equilibrium exists from 0.03 s on."""
    return 80 * u if t < 0.0301 else 1e7 * (1 if u > 0.1 * np.sin(1e5 * u) else -1)


@pytest.mark.parametrize("solver", IMPLICIT)
def test_newtons_method_without_convergence(solver: Any) -> None:
    model = with_constraint(hopeless)
    model.mbs.Assemble()
    with pytest.raises(SolverError) as caught:
        model.mbs.SolveDynamic(settings_of(10), solverType=solver)
    assert (caught.value.reason, caught.value.stepIndex) == ("newton", GOOD_STEPS + 1)
    assert_state_of_step(model, lambda: with_constraint(calm), solver)


@pytest.mark.parametrize("solver", [*IMPLICIT, *EXPLICIT])
@pytest.mark.parametrize("adaptive", [True, False])
def test_discontinuous_iterations_that_do_not_settle(solver: Any, adaptive: bool) -> None:
    model = everything(calm)
    model.mbs.Assemble()
    model.mbs.SetPostNewtonUserFunction(lambda mbs, t: [0.0 if t < 0.03001 else 5.0, -1])
    with pytest.raises(SolverError) as caught:
        model.mbs.SolveDynamic(settings_of(10, adaptive), solverType=solver)
    assert caught.value.reason == "discontinuousIteration"
    if not adaptive:
        assert caught.value.stepIndex == GOOD_STEPS + 1
        assert_state_of_step(model, lambda: everything(calm), solver)


@pytest.mark.parametrize("solver", [*IMPLICIT, *EXPLICIT])
def test_recommended_steps_that_are_not_allowed(solver: Any) -> None:
    """A step that should be smaller, but must not."""
    model = everything(calm)
    model.mbs.Assemble()
    model.mbs.SetPostNewtonUserFunction(lambda mbs, t: [0.0, -1] if t < 0.03001 else [5.0, 1e-3])
    settings = settings_of(10)
    settings.timeIntegration.discontinuous.useRecommendedStepSize = True
    with pytest.raises(SolverError, match="did not settle in step 4"):
        model.mbs.SolveDynamic(settings, solverType=solver)
    assert_state_of_step(model, lambda: everything(calm), solver)


@pytest.mark.parametrize("solver", [*IMPLICIT, *EXPLICIT])
@pytest.mark.parametrize("adaptive", [True, False])
def test_exceptions_of_items(solver: Any, adaptive: bool) -> None:
    def law(t: float, u: float) -> float:
        if t > 0.0301:
            raise LookupError
        return calm(t, u)

    model = everything(law)
    model.mbs.Assemble()
    with pytest.raises(LookupError):
        model.mbs.SolveDynamic(settings_of(10, adaptive), solverType=solver)
    assert_state_of_step(model, lambda: everything(calm), solver)


@pytest.mark.parametrize("solver", [*IMPLICIT, *EXPLICIT])
@pytest.mark.parametrize("name", ["PreStep", "PostNewton"])
def test_exceptions_of_system_functions(solver: Any, name: str) -> None:
    def function(mbs: Any, t: float) -> Any:
        if t > 0.0301:
            mbs.systemData.SetODE2Coordinates(7 + mbs.systemData.GetODE2Coordinates())
            raise LookupError
        return [0, -1] if name == "PostNewton" else True

    model = everything(calm)
    model.mbs.Assemble()
    getattr(model.mbs, f"Set{name}UserFunction")(function)
    with pytest.raises(LookupError):
        model.mbs.SolveDynamic(settings_of(10), solverType=solver)
    assert_state_of_step(model, lambda: everything(calm), solver)


@pytest.mark.parametrize("adaptive", [True, False])
def test_load_steps_without_convergence(adaptive: bool) -> None:
    """The load of a spring that gives way at 35 % of it."""

    def weak(t: float, u: float) -> float:
        return 10 * (u - 0.3) if abs(u - 0.3) < 0.35 else 3.5

    model = oscillator(law=lambda mbs, t, item, u, *rest: weak(t, u))
    model.mbs.AddLoad(LoadCoordinate(markerNumber=model.marker, load=10))
    model.mbs.Assemble()
    with pytest.raises(SolverError) as caught:
        model.mbs.SolveStatic(with_load_steps(10, adaptive))
    assert caught.value.reason in ("newton", "singularMatrix", "freeDirection", "notFinite", "unbounded")
    assert 0.25 < model.mbs.systemData.GetTime() < 0.36
    assert 10 * (model.position - 0.3) == pytest.approx(10 * model.mbs.systemData.GetTime(), rel=1e-9)


def with_load_steps(steps: int, adaptive: bool = False) -> Any:
    settings = settings_of(10, adaptive)
    settings.staticSolver.numberOfLoadSteps = steps
    return settings


@pytest.mark.parametrize("solver", [*IMPLICIT, *EXPLICIT, Solver.DOPRI5])
def test_an_interrupt_between_steps_keeps_the_last_one(solver: Any) -> None:
    """Exceptions of functions between steps, including Ctrl-C, leave the state that sensors have written last."""

    def post_step(mbs: Any, t: float) -> bool:
        if t > 0.02 and not sent:
            sent.append(t)
            os.kill(os.getpid(), signal.SIGINT)
        return True

    sent: list[float] = []
    model = everything(calm)
    model.mbs.Assemble()
    model.mbs.SetPostStepUserFunction(post_step)
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt):
            settings = settings_of(1000000)
            settings.solutionSettings.sensorsWritePeriod = 0.01
            model.mbs.SolveDynamic(settings, solverType=solver)
    finally:
        signal.signal(signal.SIGINT, before)
    time, position = model.table()[-1]
    assert model.mbs.systemData.GetTime() == pytest.approx(time, abs=0.0101)
    assert abs(model.position) < 0.4


@pytest.fixture
def time_limit() -> Iterator[Callable[[float], None]]:
    def limit(seconds: float) -> None:
        exu.special.solver.timeout = seconds

    yield limit
    exu.special.solver.timeout = -1


@pytest.mark.parametrize("solver", [*IMPLICIT, *EXPLICIT, Solver.DOPRI5, "static"])
def test_time_limit(solver: Any, time_limit: Any, capfd: pytest.CaptureFixture[str]) -> None:
    model = oscillator()
    model.mbs.Assemble()
    settings = with_load_steps(10**7)
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 100.0, 10**7
    settings.solutionSettings.sensorsWritePeriod = 10.0
    time_limit(0.05)
    if solver == "static":
        assert model.mbs.SolveStatic(settings, updateInitialValues=True) is False
    else:
        assert model.mbs.SolveDynamic(settings, solverType=solver, updateInitialValues=True) is False
    shown = capfd.readouterr()
    assert (shown.out + shown.err).count("the time limit of 0.05 seconds (exu.special.solver.timeout) is reached") == 1
    kept = model.mbs.sys["staticSolver" if solver == "static" else "dynamicSolver"]
    assert kept.output.simulationTimeout and not kept.output.finishedSuccessfully
    success, text = SolverSuccess(kept)
    assert not success and "the time limit is reached" in text
    assert "raise exu.special.solver.timeout" in kept.GetDiagnosis()
    assert kept.GetDiagnosisDictionary()["reason"] == "timeLimit"
    data = model.mbs.systemData
    assert 0 < data.GetTime() < settings.timeIntegration.endTime
    assert data.GetODE2Coordinates(exu.ConfigurationType.Initial) == [0.3]
    time_limit(-1)
    settings.timeIntegration.numberOfSteps = settings.staticSolver.numberOfLoadSteps = 10
    assert model.mbs.SolveStatic(settings) is True
    assert SolverSuccess(model.mbs.sys["staticSolver"]) == [True, ""]


def test_time_limit_of_variations(time_limit: Any) -> None:
    model = oscillator()
    model.mbs.Assemble()
    settings = settings_of(10)
    time_limit(0.05)
    spring = (model.mbs.GetObjectNumber("spring"), "stiffness")
    steps = {"timeIntegration.endTime": [0.1, 1e3], "timeIntegration.numberOfSteps": [10, 10**7]}
    results = model.mbs.SolveVariations({spring: [10.0, 20.0]}, settings, settings=steps)
    assert results.success.tolist() == [True, False]
    assert "the time limit is reached" in results.messages[1]


@pytest.mark.parametrize("solver", [*IMPLICIT, *EXPLICIT])
@pytest.mark.parametrize("name", ["PreStep", "PostStep"])
def test_functions_that_end_a_simulation(solver: Any, name: str) -> None:
    """That is a success, as in Exudyn; the solver reports the kind of end."""
    model = oscillator()
    model.mbs.Assemble()
    getattr(model.mbs, f"Set{name}UserFunction")(lambda mbs, t: t < 0.0301)
    assert model.mbs.SolveDynamic(settings_of(10), solverType=solver) is True
    output = model.mbs.sys["dynamicSolver"].output
    assert output.finishedSuccessfully and output.simulationStoppedByUserFunction
    assert not (output.simulationTimeout or output.simulationStoppedByUser)
    assert model.mbs.systemData.GetTime() == pytest.approx(0.04)


@pytest.mark.parametrize("solver", [*IMPLICIT, *EXPLICIT])
def test_the_stop_flag_ends_a_simulation(solver: Any) -> None:
    def pre_step(mbs: Any, t: float) -> bool:
        if t > 0.0301:
            mbs.SetRenderEngineStopFlag(True)
        return True

    model = oscillator()
    model.mbs.Assemble()
    model.mbs.SetPreStepUserFunction(pre_step)
    assert model.mbs.SolveDynamic(settings_of(100000), solverType=solver) is True
    output = model.mbs.sys["dynamicSolver"].output
    assert output.finishedSuccessfully and output.simulationStoppedByUser
    assert not (output.simulationTimeout or output.simulationStoppedByUserFunction)
    assert 0.03 < model.mbs.systemData.GetTime() < 1000
