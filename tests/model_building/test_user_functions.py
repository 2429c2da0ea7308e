"""User functions of items: kept as they are, called with the system, and their errors keep their own type."""

from __future__ import annotations

import gc
import threading
import weakref
from typing import Any

import pytest

import dalembert as exu


def load(mbs: exu.MainSystem, function: Any) -> exu.LoadIndex:
    node = mbs.AddNode(exu.NodePoint())
    body = mbs.AddObject(exu.MassPoint(physicsMass=1, nodeNumber=node))
    marker = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=body))
    return mbs.AddLoad(exu.Force("wind", markerNumber=marker, loadVector=[1, 2, 3], loadVectorUserFunction=function))


def test_function_is_kept_and_gets_the_system(mbs: exu.MainSystem) -> None:
    calls = []

    def wind(system: exu.MainSystem, t: float, vector: Any) -> list[float]:
        calls.append((system, t, list(vector)))
        return [2 * x for x in vector]

    number = load(mbs, wind)
    assert mbs.GetLoadParameter(number, "loadVectorUserFunction") is wind
    assert mbs.GetLoad(number)["loadVectorUserFunction"] is wind
    mbs.Assemble()
    assert mbs.GetLoadValues(number).tolist() == [2, 4, 6]
    assert calls[-1][0] is mbs
    assert calls[-1][1:] == (0.0, [1, 2, 3])


@pytest.mark.parametrize("nothing", [0, None, 0.0 == 1])
def test_no_function(mbs: exu.MainSystem, nothing: Any) -> None:
    number = load(mbs, nothing)
    assert mbs.GetLoadParameter(number, "loadVectorUserFunction") == 0
    mbs.Assemble()
    assert mbs.GetLoadValues(number).tolist() == [1, 2, 3]


def test_set_and_remove(mbs: exu.MainSystem) -> None:
    number = load(mbs, 0)
    mbs.Assemble()
    mbs.SetLoadParameter(
        number, "loadVectorUserFunction", lambda system, t, vector: [7, 8, 9] if system is mbs else None
    )
    assert mbs.GetLoadValues(number).tolist() == [7, 8, 9]
    mbs.SetLoadParameter(number, "loadVectorUserFunction", 0)
    assert mbs.GetLoadValues(number).tolist() == [1, 2, 3]


def test_exception_keeps_its_type_and_names_the_place(mbs: exu.MainSystem) -> None:
    class Calm(Exception):
        pass

    def wind(system: exu.MainSystem, t: float, vector: Any) -> list[float]:
        raise Calm("no wind today")

    number = load(mbs, wind)
    mbs.Assemble()
    with pytest.raises(Calm, match="no wind today") as caught:
        mbs.GetLoadValues(number)
    assert caught.value.__notes__ == [
        "in user function 'loadVectorUserFunction' of load 0 'wind' (LoadForceVector), at time 0.000000"
    ]


@pytest.mark.parametrize(
    ("result", "error", "text"),
    [
        (
            [1, 2],
            ValueError,
            "received [1, 2] (list of length 2) as result, but expected a list or array of 3 numbers.",
        ),
        (None, TypeError, "received None as result, but expected a list or array of 3 numbers"),
        ([1, 2, "x"], TypeError, "Entry 2 is 'x' (str), not a number."),
        ([1, 2, float("nan")], ValueError, "Entry 2 is nan (float), not a finite number."),
    ],
)
def test_wrong_results(mbs: exu.MainSystem, result: Any, error: type[Exception], text: str) -> None:
    number = load(mbs, lambda system, t, vector: result)
    mbs.Assemble()
    with pytest.raises(error) as caught:
        mbs.GetLoadValues(number)
    assert str(caught.value).startswith("user function 'loadVectorUserFunction' of load 0 'wind' (LoadForceVector): ")
    assert text in str(caught.value)


def test_functions_are_released_with_the_system() -> None:
    def make() -> weakref.ref[Any]:
        mbs = exu.SystemContainer().AddSystem()

        def wind(system: exu.MainSystem, t: float, vector: Any) -> Any:
            return vector

        load(mbs, wind)
        return weakref.ref(wind)

    reference = make()
    gc.collect()
    assert reference() is None


def solve(mbs: exu.MainSystem, steps: int, **options: Any) -> None:
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps, settings.timeIntegration.endTime = steps, 1e-3 * steps
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveDynamic(settings, **options)


def test_arrays_that_a_function_keeps_stay_as_they_were(mbs: exu.MainSystem) -> None:
    kept = []

    def wind(system: exu.MainSystem, t: float, vector: Any) -> Any:
        kept.append((t, vector))
        vector[0] += t  # its own from now on
        return vector

    load(mbs, wind)
    mbs.Assemble()
    solve(mbs, 10)
    assert len(kept) > 10
    assert all(vector.tolist() == [1 + t, 2, 3] for t, vector in kept)


def test_numbers_that_a_function_keeps_stay_as_they_were(mbs: exu.MainSystem) -> None:
    kept, seen = [], []

    def wind(system: exu.MainSystem, t: float, vector: Any) -> Any:
        kept.append(t)
        seen.append(f"{t:.17g}")
        return vector

    load(mbs, wind)
    mbs.Assemble()
    solve(mbs, 10)
    assert len(set(seen)) > 10
    assert [f"{t:.17g}" for t in kept] == seen


def test_empty_vectors_are_passed_again(mbs: exu.MainSystem) -> None:
    """A sensor of a sensor, both without factors."""
    body = mbs.CreateMassPoint(physicsMass=1, initialVelocity=[1, 0, 0])
    position = mbs.AddSensor(exu.SensorBody(bodyNumber=body, outputVariableType=exu.OutputVariableType.Position))
    seen = []

    def doubled(system: exu.MainSystem, t: float, numbers: Any, factors: Any, configuration: Any) -> Any:
        seen.append((len(numbers), factors.tolist()))
        return 2 * system.GetSensorValues(numbers[0])

    sensors = [position]
    for _ in range(2):
        sensor = exu.SensorUserFunction(sensorNumbers=sensors[-1:], sensorUserFunction=doubled, writeToFile=False)
        sensors.append(mbs.AddSensor(sensor))
    mbs.Assemble()
    solve(mbs, 100)
    assert len(seen) > 20
    assert all(call == (1, []) for call in seen)
    assert mbs.GetSensorValues(sensors[-1]).tolist() == pytest.approx([0.4, 0, 0], rel=1e-12)


def test_function_that_is_called_while_it_runs(mbs: exu.MainSystem) -> None:
    def wind(system: exu.MainSystem, t: float, vector: Any) -> Any:
        if t == 0:
            return [7, 8, 9]
        system.systemData.SetTime(0)
        inner = system.GetLoadValues(number)
        return vector - inner

    number = load(mbs, wind)
    mbs.Assemble()
    mbs.systemData.SetTime(0.5)
    assert mbs.GetLoadValues(number).tolist() == [-6, -6, -6]


def test_no_function_is_called_twice_for_one_value(mbs: exu.MainSystem) -> None:
    calls = []

    def force(system: exu.MainSystem, t: float, item: int, u: float, v: float, *parameters: float) -> float:
        calls.append((t, u, v))
        return 100 * u + v

    node = mbs.AddNode(exu.NodePoint(initialCoordinates=[0.1, 0, 0]))
    mbs.AddObject(exu.MassPoint(physicsMass=1, nodeNumber=node))
    ground = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(exu.NodePointGround()), coordinate=0))
    marker = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
    mbs.AddObject(exu.CoordinateSpringDamper(markerNumbers=[ground, marker], springForceUserFunction=force))
    mbs.Assemble()
    solve(mbs, 10)
    # Two residuals and two derivatives for the one Newton iteration of a linear step; more only before the first step.
    assert 4 * 10 <= len(calls) <= 4 * 10 + 4
    assert not any(first == second for first, second in zip(calls[4:], calls[5:], strict=False))


def test_other_threads_run_between_functions(mbs: exu.MainSystem) -> None:
    running, done = threading.Event(), threading.Event()

    def other() -> None:
        running.wait()
        done.set()

    def wind(system: exu.MainSystem, t: float, vector: Any) -> Any:
        running.set()
        return vector

    load(mbs, wind)
    mbs.SetPostStepUserFunction(lambda system, t: not done.is_set())
    mbs.Assemble()
    thread = threading.Thread(target=other)
    thread.start()
    steps = 10**7  # would take much longer than a thread needs to get its turn
    solve(mbs, steps, solverType=exu.DynamicSolverType.ExplicitEuler)
    thread.join()
    assert mbs.systemData.GetTime(exu.ConfigurationType.Current) < 1e-3 * steps
