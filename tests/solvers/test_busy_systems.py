"""A system that is being solved: operations of user functions and other threads on a system in use, and rejected
ones."""

from __future__ import annotations

import copy
import threading
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from oscillators import (
    DAMPING,
    MASS,
    SPEED,
    START,
    STIFFNESS,
    Oscillator,
    Variable,
    dynamic_settings,
    exact_oscillation,
    oscillator,
)

import dalembert as exu
from dalembert import ObjectIndex
from dalembert.itemInterface import LoadCoordinate, NodePoint, SensorNode, SensorUserFunction

END, STEPS = 0.5, 10
Visualization = exu.ConfigurationType.Visualization


def solve(model: Oscillator, **options: Any) -> float:
    model.mbs.Assemble()
    model.mbs.SolveDynamic(dynamic_settings(END, STEPS), **options)
    return model.position


def short_solve(mbs: Any) -> None:
    mbs.SolveDynamic(dynamic_settings(0.1, 2))


def initialize(solver: Any) -> Callable[[Any], None]:
    return lambda mbs: solver.InitializeSolver(mbs, exu.SimulationSettings())


# Calls with the name that the error has: calls that would change the system during a solution, or solve it again.
REFUSED: dict[str, Callable[[Any], Any]] = {
    "mbs.Assemble": lambda mbs: mbs.Assemble(),
    "mbs.AssembleCoordinates": lambda mbs: mbs.AssembleCoordinates(),
    "mbs.Reset": lambda mbs: mbs.Reset(),
    "mbs.SetDictionary": lambda mbs: mbs.SetDictionary(mbs.GetDictionary()),
    "mbs.AddNode": lambda mbs: mbs.AddNode(NodePoint()),
    "mbs.AddSensor": lambda mbs: mbs.AddSensor(SensorNode(nodeNumber=0, outputVariableType=Variable.Coordinates)),
    "mbs.ModifyObject": lambda mbs: mbs.ModifyObject(0, {"physicsMass": 1}),
    "mbs.DeleteObject": lambda mbs: mbs.DeleteObject(0),
    "mbs.DeleteSensor": lambda mbs: mbs.DeleteSensor(0),
    "mbs.SetMarkerParameter": lambda mbs: mbs.SetMarkerParameter(1, "nodeNumber", 1),
    "mbs.systemIsConsistent": lambda mbs: setattr(mbs, "systemIsConsistent", False),
    "SC.Reset": lambda mbs: mbs.GetSystemContainer().Reset(),
    "SC.SetDictionary": lambda mbs: mbs.GetSystemContainer().SetDictionary(mbs.GetSystemContainer().GetDictionary()),
    "mbs.SolveDynamic": short_solve,
    "mbs.SolveStatic": lambda mbs: mbs.SolveStatic(),
    "mbs.SolveVariations": lambda mbs: mbs.SolveVariations(parameters={(ObjectIndex(0), "physicsMass"): [1.0, 2.0]}),
    "mbs.ComputeODE2Eigenvalues": lambda mbs: mbs.ComputeODE2Eigenvalues(),
    "mbs.ComputeLinearizedSystem": lambda mbs: mbs.ComputeLinearizedSystem(),
    "solver.InitializeSolver": initialize(exu.MainSolverStatic()),
    "solver.SolveSystem": lambda mbs: mbs.sys["dynamicSolver"].SolveSystem(mbs, exu.SimulationSettings()),
    "solver.SolveSteps": lambda mbs: mbs.sys["dynamicSolver"].SolveSteps(mbs, exu.SimulationSettings()),
    "testing.residual": lambda mbs: exu.testing.residual(mbs, exu.testing.State(mbs)),
}


def refusals(mbs: Any) -> dict[str, str]:
    """Try everything; the errors by operation, and operations without error."""
    texts = {}
    for call, action in REFUSED.items():
        try:
            action(mbs)
        except RuntimeError as error:
            texts[call] = str(error)
        else:
            texts[call] = "was accepted"
    return texts


class Intruder:
    """A user function that tries everything when it is called for the tenth time."""

    def __init__(self, result: Any) -> None:
        self.result, self.calls, self.texts = result, 0, dict[str, str]()

    def __call__(self, mbs: Any, *arguments: Any) -> Any:
        self.calls += 1
        if self.calls == 10:
            self.texts = refusals(mbs)
        return self.result(*arguments) if callable(self.result) else self.result


def step_function(name: str, result: Any) -> Callable[[], tuple[Oscillator, Intruder]]:
    def make() -> tuple[Oscillator, Intruder]:
        model, intruder = oscillator(), Intruder(result)
        getattr(model.mbs, f"Set{name}UserFunction")(intruder)
        return model, intruder

    return make


def spring_function() -> tuple[Oscillator, Intruder]:
    intruder = Intruder(lambda t, item, u, v, k, d, offset: k * u + d * v)
    return oscillator(law=intruder), intruder


def load_function() -> tuple[Oscillator, Intruder]:
    model, intruder = oscillator(), Intruder(0.0)
    model.mbs.AddLoad(LoadCoordinate(markerNumber=model.marker, load=0, loadUserFunction=intruder))
    return model, intruder


def sensor_function() -> tuple[Oscillator, Intruder]:
    model, intruder = oscillator(), Intruder([1.0])
    model.mbs.AddSensor(SensorUserFunction(sensorUserFunction=intruder, storeInternal=True))
    return model, intruder


PLACES = {
    "mbs.PreStepUserFunction": step_function("PreStep", True),
    "mbs.PostStepUserFunction": step_function("PostStep", True),
    "mbs.PostNewtonUserFunction": step_function("PostNewton", [0, -1]),
    "mbs.PreNewtonResidualUserFunction": step_function("PreNewtonResidual", None),
    "mbs.SystemJacobianUserFunction": step_function("SystemJacobian", lambda *_: exu.MatrixContainer()),
    "user function 'springForceUserFunction' of object 1 'spring'": spring_function,
    "user function 'loadUserFunction' of load 0": load_function,
    "user function 'sensorUserFunction' of sensor 1": sensor_function,
}


@pytest.mark.parametrize("place", PLACES)
def test_operations_that_would_remove_the_system_are_rejected(place: str) -> None:
    undisturbed = solve(PLACES[place]()[0])  # an intruder of its own, whose tenth call is refused as well
    model, intruder = PLACES[place]()
    model.mbs.Assemble()
    before = model.mbs.GetDictionary()
    model.mbs.SolveDynamic(dynamic_settings(END, STEPS))
    assert set(intruder.texts) == set(REFUSED)
    for call, text in intruder.texts.items():
        assert text.startswith((call, "solver.SolveSystem(" if call == "mbs.SolveDynamic" else call)), (call, text)
        assert "the system is in use: it is being solved (implicit second order time integration, SolveSystem)" in text
        assert f"this call comes from {place}" in text, call
    assert model.position == undisturbed
    after = model.mbs.GetDictionary()
    assert all(str(after[kind]) == str(before[kind]) for kind in before if kind.endswith("List"))


@pytest.mark.parametrize("solver", [exu.DynamicSolverType.RK44, exu.DynamicSolverType.VelocityVerlet])
def test_explicit_solvers_refuse_as_well(solver: Any) -> None:
    model, intruder = spring_function()
    solve(model, solverType=solver)
    assert all(
        "the system is in use: it is being solved (explicit time integration" in text
        for text in intruder.texts.values()
    )


def test_an_error_that_is_not_caught_ends_the_run() -> None:
    model = oscillator()
    model.mbs.SetPreStepUserFunction(lambda mbs, t: mbs.Assemble() if t > 0.2 else True)
    with pytest.raises(
        RuntimeError, match=r"mbs.Assemble\(\): the system is in use: .* comes from mbs.PreStepUserFunction"
    ):
        solve(model)
    model.mbs.SetPreStepUserFunction(0)
    assert solve(model) == solve(oscillator())  # nothing is left behind


def test_a_solver_calls_itself_in_parts_only() -> None:
    model = oscillator()
    expected = solve(model)
    solver, texts = exu.MainSolverImplicitSecondOrder(), []

    def newton(main_solver: Any, mbs: Any, settings: Any) -> bool:
        for other in (exu.MainSolverStatic().InitializeSolver, main_solver.SolveSystem, main_solver.SolveSteps):
            with pytest.raises(RuntimeError) as caught:
                other(mbs, settings)
            texts.append(str(caught.value))
        return bool(main_solver.Newton(mbs, settings))

    solver.SetUserFunctionNewton(model.mbs, newton)
    assert solver.SolveSystem(model.mbs, dynamic_settings(END, STEPS))
    assert model.position == pytest.approx(expected, abs=1e-14)
    assert len(texts) == 3 * STEPS
    assert all("comes from the user function Newton of the solver" in text for text in texts)


def test_one_solver_does_not_work_on_two_systems_at_once() -> None:
    model, other, solver = oscillator(), oscillator(), exu.MainSolverImplicitSecondOrder()
    for one in (model, other):
        one.mbs.Assemble()

    def pre_step(mbs: Any, t: float) -> bool:
        with pytest.raises(RuntimeError, match="the solver is at work on another system"):
            solver.SolveSystem(other.mbs, exu.SimulationSettings())
        return True

    model.mbs.SetPreStepUserFunction(pre_step)
    assert solver.SolveSystem(model.mbs, dynamic_settings(END, STEPS))


def test_a_copy_may_be_solved_in_a_user_function() -> None:
    expected = solve(oscillator())
    model, ends = oscillator(), []

    def pre_step(mbs: Any, t: float) -> bool:
        ahead = copy.copy(mbs)
        ahead.SetPreStepUserFunction(0)
        ahead.Assemble()
        ahead.SolveDynamic(dynamic_settings(END, STEPS))
        ends.append(float(ahead.GetNodeOutput(0, Variable.Coordinates)))
        return True

    model.mbs.SetPreStepUserFunction(pre_step)
    assert solve(model) == expected
    assert ends == [expected] * STEPS


def test_parameters_set_in_the_middle_of_an_evaluation_count_from_the_next() -> None:
    """The damper acts from the first evaluation after 0.2 s on, whichever function switches it."""

    def switching(mbs: Any, t: float) -> None:
        if t > 0.2 + 1e-9:
            mbs.SetObjectParameter(1, "damping", DAMPING)

    def by_load(mbs: Any, t: float, load: float) -> float:
        switching(mbs, t)
        return 0.0

    def by_step(mbs: Any, t: float) -> bool:
        switching(mbs, t)
        return True

    ends = []
    for where in ("load", "step"):
        model = oscillator(damping=0)
        if where == "load":
            model.mbs.AddLoad(LoadCoordinate(markerNumber=model.marker, load=0, loadUserFunction=by_load))
        else:
            model.mbs.SetPreStepUserFunction(by_step)
        ends.append(solve(model))
    free, damped = solve(oscillator(damping=0)), solve(oscillator())
    assert ends[0] == pytest.approx(ends[1], abs=1e-10)  # tolerance of Newton's method
    assert abs(ends[0] - free) > 0.1 * abs(free - damped)


@pytest.mark.parametrize("solver", [exu.DynamicSolverType.GeneralizedAlpha, exu.DynamicSolverType.ExplicitMidpoint])
def test_functions_that_replace_themselves(solver: Any) -> None:
    """m a = F with F = 3 until the load, the spring and the sensor have taken their own functions away, then 1."""
    model = oscillator(stiffness=0, damping=0, position=0, speed=0)
    calls = []

    def law(mbs: Any, t: float, item: int, *arguments: float) -> float:
        calls.append("spring")
        mbs.SetObjectParameter(item, "springForceUserFunction", 0)
        return 0.0

    def force(mbs: Any, t: float, load: float) -> float:
        calls.append("load")
        mbs.SetLoadParameter(0, "loadUserFunction", 0)
        mbs.systemData.AddODE2LoadDependencies(0, [0])
        return 3 * load

    def measure(mbs: Any, t: float, *arguments: Any) -> list[float]:
        calls.append("sensor")
        mbs.SetSensorParameter(1, "sensorUserFunction", lambda *_: [7.0])
        return [5.0]

    model.mbs.SetObjectParameter(1, "springForceUserFunction", law)
    model.mbs.AddLoad(LoadCoordinate(markerNumber=model.marker, load=1, loadUserFunction=force))
    sensor = model.mbs.AddSensor(SensorUserFunction(sensorUserFunction=measure, storeInternal=True))
    solve(model, solverType=solver)
    assert sorted(calls) == ["load", "sensor", "spring"]
    assert model.position == pytest.approx(0.5 / MASS * END**2, rel=0.2)  # one evaluation has 3 values
    assert model.mbs.GetSensorStoredData(sensor)[1:, 1] == pytest.approx(7)


def test_outside_of_solvers_functions_of_items_guard_the_system_too() -> None:
    texts = []

    def law(mbs: Any, t: float, item: int, u: float, *arguments: float) -> float:
        with pytest.raises(RuntimeError) as caught:
            mbs.Assemble()
        texts.append(str(caught.value))
        return u

    model = oscillator(law=law)
    model.mbs.Assemble()
    assert model.mbs.GetObjectOutput(1, Variable.Force) == pytest.approx(START)
    assert "its items are being evaluated, and this call comes from user function 'springForceUserFunction'" in texts[0]
    model.mbs.Assemble()


# ---- other threads ------------------------------------------------------------------------------------------------------


@pytest.fixture
def solving() -> Iterator[tuple[Oscillator, Callable[[Callable[[], Any]], Any]]]:
    """A system that is solved in another thread, at the moment in its PreStep function, until the test is over."""
    model = oscillator()
    waits, go_on, errors = threading.Event(), threading.Event(), list[BaseException]()

    def pre_step(mbs: Any, t: float) -> bool:
        if t > 0.2:
            waits.set()
            go_on.wait(20)
        return True

    def run() -> None:
        try:
            solve(model)
        except BaseException as error:  # the test reports it
            errors.append(error)

    model.mbs.SetPreStepUserFunction(pre_step)
    thread = threading.Thread(target=run)
    thread.start()
    assert waits.wait(20)
    yield model
    go_on.set()
    thread.join(20)
    assert errors == []
    model.mbs.SetPreStepUserFunction(0)
    position = model.position
    assert position == solve(model)


def test_other_threads_are_refused(solving: Any) -> None:
    texts = refusals(solving.mbs)
    for call, text in texts.items():
        assert "the system is in use" in text or "the solver is at work" in text, (call, text)
        assert "in another thread" in text, (call, text)
    assert "at the moment in mbs.PreStepUserFunction" in texts["mbs.Assemble"]


def test_other_threads_change_no_parameter_and_read_no_results(solving: Any) -> None:
    mbs = solving.mbs
    for action in (
        lambda: mbs.SetObjectParameter(1, "stiffness", 1.0),
        lambda: mbs.SetObjectParameter(1, "Vshow", False),
        lambda: mbs.SetNodeParameter(0, "name", "other"),
        lambda: mbs.GetNodeOutput(0, Variable.Coordinates),
        lambda: mbs.GetObjectOutput(1, Variable.Force),
        lambda: mbs.GetSensorValues(0),
        lambda: mbs.GetSensorStoredData(0),
        lambda: mbs.systemData.GetTime(),
        lambda: mbs.systemData.GetODE2Coordinates(),
        lambda: mbs.systemData.SetODE2Coordinates([1.0]),
        lambda: mbs.systemData.GetSystemState(),
        lambda: mbs.sys["dynamicSolver"].GetSystemJacobian(),
        lambda: mbs.sys["dynamicSolver"].GetNewtonSolution(),
    ):
        with pytest.raises(RuntimeError, match=r"the system is in use: .*in another thread.*Visualization"):
            action()


def test_reads_of_other_threads(solving: Any) -> None:
    mbs, data = solving.mbs, solving.mbs.systemData
    assert mbs.GetObjectParameter(1, "stiffness") == STIFFNESS
    mbs.variables["message"] = "seen"
    assert data.ODE2Size() == 1
    assert data.GetObjectLTGODE2(0) == [0]
    assert mbs.GetNodeODE2Index(0) == 0
    assert 0 <= data.GetTime(Visualization) <= END
    assert data.GetODE2Coordinates(Visualization).shape == (1,)
    assert data.GetODE2Coordinates(exu.ConfigurationType.Reference) == [0]
    assert len(copy.copy(mbs).GetDictionary()["objectList"]) == 2


def test_threads_that_solve_one_system_at_once() -> None:
    """One thread at a time gets it; no result is mixed up."""
    model = oscillator()
    expected = solve(model)
    settings = [dynamic_settings(END, 4000) for _ in range(4)]
    solved, refused = [], []
    together = threading.Barrier(4)

    def run(own: Any) -> None:
        together.wait(20)
        try:
            model.mbs.SolveDynamic(own)
            solved.append(True)
        except RuntimeError as error:
            refused.append(str(error))

    threads = [threading.Thread(target=run, args=[own]) for own in settings]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(60)
    assert len(solved) + len(refused) == 4
    assert len(solved) >= 1
    assert all("the system is in use" in text and "in another thread" in text for text in refused)
    assert model.position == pytest.approx(
        exact_oscillation(END)[0], abs=1e-6
    )  # (h omega)^2 / 12 of the amplitude: 5e-8
    assert solve(model) == expected


def test_a_thread_that_watches_a_long_run() -> None:
    """The visualized state goes on while the solver works without the interpreter, and is always of one step."""
    model = oscillator()
    model.mbs.Assemble()
    settings = dynamic_settings(40.0, 400_000)
    settings.solutionSettings.sensorsWritePeriod = 1.0
    data, over, times = model.mbs.systemData, threading.Event(), list[float]()

    def watch() -> None:
        while not over.wait(0.002):
            times.append(data.GetTime(Visualization))

    watcher = threading.Thread(target=watch)
    watcher.start()
    model.mbs.SolveDynamic(settings)
    over.set()
    watcher.join(20)
    assert times == sorted(times)
    assert len(set(times)) > 3
    assert data.GetTime(Visualization) == pytest.approx(40.0)
    assert np.isfinite(model.position) and SPEED < 0
