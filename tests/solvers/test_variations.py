"""mbs.SolveVariations: results of variations are bit-identical to separate solutions, for any number of threads."""

from __future__ import annotations

import signal
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from ensembles import Variable, alone, assert_equal, crank, settings
from oscillators import START, STIFFNESS, Oscillator, friction_or_stop, oscillator

import dalembert as exu
from dalembert.itemInterface import (
    LoadCoordinate,
    MarkerNodeCoordinate,
    NodePoint,
    ObjectMassPoint,
    SensorNode,
    SensorObject,
)
from dalembert.utilities import CreateSymbolicUserFunction

Solver = exu.DynamicSolverType
STIFFNESSES = np.linspace(20, 200, 7)
DAMPINGS = np.linspace(0, 4, 7)
COORDINATES = {
    "ODE2": "ODE2Coordinates",
    "ODE2_t": "ODE2Coordinates_t",
    "ODE2_tt": "ODE2Coordinates_tt",
    "AE": "AECoordinates",
    "Data": "DataCoordinates",
}


def spring(model: Oscillator) -> Any:
    return model.mbs.GetObjectNumber("spring")


def with_sensors(build: Callable[[], Oscillator]) -> Oscillator:
    model = build()
    model.mbs.AddSensor(SensorObject(objectNumber=spring(model), outputVariableType=Variable.Force, storeInternal=True))
    model.mbs.Assemble()
    return model


def rubbing() -> Oscillator:
    model = oscillator()
    friction_or_stop(model, fDynamicFriction=0.5, frictionProportionalZone=1e-3)
    return model


@pytest.mark.parametrize(
    "kind", [Solver.GeneralizedAlpha, Solver.TrapezoidalIndex2, Solver.RK44, Solver.DOPRI5, "static"]
)
@pytest.mark.parametrize("build", [oscillator, rubbing], ids=["smooth", "friction"])
@pytest.mark.parametrize("threads", [1, 2, 5])
def test_variations_agree_with_separate_solutions(build: Any, kind: Any, threads: int) -> None:
    if build is rubbing and kind not in (Solver.GeneralizedAlpha, "static"):
        build = oscillator  # history is moved on by implicit solvers
    wanted = []
    for k, d in zip(STIFFNESSES, DAMPINGS, strict=True):
        model = with_sensors(build)
        model.mbs.SetObjectParameter(spring(model), "stiffness", k)
        model.mbs.SetObjectParameter(spring(model), "damping", d)
        single = settings()
        if kind == "static":
            wanted.append(alone(model.mbs, lambda mbs=model.mbs, s=single: mbs.SolveStatic(s)))
        else:
            wanted.append(alone(model.mbs, lambda mbs=model.mbs, s=single: mbs.SolveDynamic(s, solverType=kind)))
    model = with_sensors(build)
    results = model.mbs.SolveVariations(
        {(spring(model), "stiffness"): STIFFNESSES, (spring(model), "damping"): DAMPINGS}, settings(), kind,
        storeHistories=True, storeCoordinates=True, numberOfThreads=threads,
    )  # fmt: skip
    assert_equal(results, wanted)
    np.testing.assert_array_equal(results.SensorHistory(3, 1), wanted[3][1][:, [0, 2]])
    np.testing.assert_array_equal(results.SensorValues(1)[:, 0], [values[1] for values, _, _ in wanted])


def test_parameters_of_nodes_and_markers_vary_as_in_a_model_built_for_them() -> None:
    rods, length = np.linspace(0.25, 0.35, 5), 0.1
    wanted = []
    for rod in rods:
        mbs = crank(rod)[0]
        wanted.append(alone(mbs, lambda mbs=mbs: mbs.SolveDynamic(settings(0.1, 100))))
    mbs, nodes, _, (left, right) = crank(0.3)
    zero = np.zeros_like(rods)
    results = mbs.SolveVariations(
        {
            (nodes[1], "referenceCoordinates"): np.column_stack([length + rods / 2, zero, zero]),
            (nodes[2], "referenceCoordinates"): np.column_stack([length + rods, zero, zero]),
            (left, "localPosition"): np.column_stack([-rods / 2, zero, zero]),
            (right, "localPosition"): np.column_stack([rods / 2, zero, zero]),
        },
        settings(0.1, 100),
        storeHistories=True,
        storeCoordinates=True,
    )
    assert_equal(results, wanted)


def test_whole_numbers_vary_and_assemble_anew() -> None:
    """A force along one coordinate after the other: x = x0 + F t^2 / (2 m), exact for the trapezoidal rule."""
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(NodePoint())
    mbs.AddObject(ObjectMassPoint(nodeNumber=node, physicsMass=2))
    marker = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
    mbs.AddLoad(LoadCoordinate(markerNumber=marker, load=6))
    mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=Variable.Displacement))
    mbs.Assemble()
    start = np.array([0.1, 0.2, 0.3])
    mbs.systemData.SetODE2Coordinates(start, configuration=exu.ConfigurationType.Initial)
    results = mbs.SolveVariations({(marker, "coordinate"): [2, 0, 1, 3]}, settings(0.5, 10))
    axes = np.array([[0, 0, 1], [1, 0, 0], [0, 1, 0]])
    np.testing.assert_allclose(results.sensorValues[:3], start + axes * 6 / (2 * 2) * 0.5**2, rtol=1e-12)
    assert results.success.tolist() == [True, True, True, False]
    assert "expected a coordinate from 0 to 2" in results.messages[3]


def test_initial_coordinates_and_settings_vary() -> None:
    starts, ends = np.linspace(-0.2, 0.4, 5), np.array([0.1, 0.2, 0.3, 0.2, 0.1])
    steps = np.array([10, 20, 40, 80, 5])
    wanted = []
    for start, end, n in zip(starts, ends, steps, strict=True):
        model = with_sensors(lambda start=start: oscillator(position=start))
        single = settings()
        single.timeIntegration.endTime, single.timeIntegration.numberOfSteps = end, n
        wanted.append(alone(model.mbs, lambda mbs=model.mbs, s=single: mbs.SolveDynamic(s)))
    model = with_sensors(oscillator)
    results = model.mbs.SolveVariations(
        {}, settings(), initialCoordinates={"ODE2": starts[:, None]},
        settings={"timeIntegration.endTime": ends, "timeIntegration.numberOfSteps": steps}, storeHistories=True,
    )  # fmt: skip
    np.testing.assert_array_equal(results.sensorValues, [values for values, _, _ in wanted])
    np.testing.assert_allclose(results.endTimes, ends, rtol=1e-14)
    for k, (_, history, _) in enumerate(wanted):
        rows = results.historyRows[k]
        np.testing.assert_array_equal(results.sensorHistories[k, :rows], history)
        assert np.isnan(results.sensorHistories[k, rows:]).all()


def test_variations_start_from_the_initial_state_and_leave_the_system_alone() -> None:
    model = with_sensors(oscillator)
    model.mbs.systemData.SetODE2Coordinates([0.1], configuration=exu.ConfigurationType.Initial)
    before = model.mbs.systemData.GetSystemState()
    results = model.mbs.SolveVariations({(spring(model), "stiffness"): STIFFNESSES}, settings())
    assert model.mbs.systemIsConsistent and model.mbs.GetObjectParameter(spring(model), "stiffness") == STIFFNESS
    for x, y in zip(model.mbs.systemData.GetSystemState(), before, strict=True):
        np.testing.assert_array_equal(x, y)
    model.mbs.SetObjectParameter(spring(model), "stiffness", STIFFNESSES[2])
    model.mbs.SolveDynamic(settings())
    assert results.SensorValues(model.sensor)[2, 0] == model.position


def test_amplitudes_and_frequencies_of_oscillators() -> None:
    """The solution without damping is x = x0 cos(wt) with w^2 = k/m; the error of the trapezoidal rule is w^3 h^2 t /
    12 in the phase."""
    stiffness, weight = np.meshgrid([20.0, 80.0, 180.0], [0.5, 2.0, 8.0])
    masses, stiffnesses = weight.ravel(), stiffness.ravel()
    model = with_sensors(lambda: oscillator(damping=0, speed=0))
    end, steps = 1.0, 1000
    s = settings(end, steps)
    s.timeIntegration.generalizedAlpha.spectralRadius = 1
    results = model.mbs.SolveVariations(
        {(spring(model), "stiffness"): stiffnesses, (exu.ObjectIndex(0), "physicsMass"): masses}, s, sensors=[model.sensor],
        storeHistories=True, storeCoordinates=True,
    )  # fmt: skip
    w = np.sqrt(stiffnesses / masses)
    phase_error = w**3 * (end / steps) ** 2 * end / 12
    assert np.all(np.abs(results.sensorValues[:, 0] - START * np.cos(w * end)) < START * 1.01 * phase_error)
    energy = masses * results.coordinates["ODE2_t"][:, 0] ** 2 + stiffnesses * results.coordinates["ODE2"][:, 0] ** 2
    np.testing.assert_allclose(energy, stiffnesses * START**2, rtol=1e-9)  # kept by the trapezoidal rule
    assert results.sensorHistories.shape == (9, steps + 1, 2)


def test_results_do_not_depend_on_the_number_of_threads() -> None:
    rng = np.random.default_rng(3)
    reference = None
    for threads in (1, 2, 3, 8):
        model = with_sensors(rubbing)
        n = 23
        rng = np.random.default_rng(3)
        results = model.mbs.SolveVariations(
            {(spring(model), "stiffness"): rng.uniform(10, 300, n), (spring(model), "offset"): rng.uniform(-1, 1, n)},
            settings(), storeHistories=True, storeCoordinates=True, numberOfThreads=threads,
        )  # fmt: skip
        found = [results.sensorValues, results.sensorHistories, *results.coordinates.values()]
        reference = reference or found
        for x, y in zip(found, reference, strict=True):
            np.testing.assert_array_equal(x, y)


def test_a_variation_that_fails_leaves_the_others_alone() -> None:
    """The coordinate is singular without mass and stiffness; the settings of another variation are refused by the
    solver."""
    model = with_sensors(lambda: oscillator(damping=0))
    stiffness, masses = np.full(6, STIFFNESS), np.array([1, 0, 2, 3, 0, 4.0])
    stiffness[masses == 0] = 0
    steps = np.array([50, 50, 50, 50.5, 50, 50])
    results = model.mbs.SolveVariations(
        {(spring(model), "stiffness"): stiffness, (exu.ObjectIndex(0), "physicsMass"): masses}, settings(),
        settings={"timeIntegration.numberOfSteps": steps}, storeHistories=True, storeCoordinates=True,
    )  # fmt: skip
    failed = np.array([False, True, False, True, True, False])
    np.testing.assert_array_equal(results.success, ~failed)
    np.testing.assert_array_equal(np.isnan(results.sensorValues).all(axis=1), failed)
    np.testing.assert_array_equal(np.isnan(results.coordinates["ODE2"]).all(axis=1), failed)
    assert [bool(text) for text in results.messages] == failed.tolist()
    assert "singular" in results.messages[1] and "'foot'" in results.messages[1]
    assert "expected a whole number" in results.messages[3]
    good = model.mbs.SolveVariations(
        {(exu.ObjectIndex(0), "physicsMass"): masses[~failed]},
        settings(),
        settings={"timeIntegration.numberOfSteps": steps[~failed]},
    )
    np.testing.assert_array_equal(results.sensorValues[~failed], good.sensorValues)


def test_constraints_of_a_node_may_be_changed_and_multipliers_are_reported() -> None:
    mbs, *_ = crank(0.3)
    mbs.SolveDynamic(settings(0.1, 100))
    results = mbs.SolveVariations(
        {(exu.LoadIndex(0), "loadVector"): [[0, 0, 0.3]]}, settings(0.1, 100), storeCoordinates=True
    )
    for key, name in COORDINATES.items():
        np.testing.assert_array_equal(results.coordinates[key][0], getattr(mbs.systemData, f"Get{name}")())


def test_ctrl_c_ends_all_variations() -> None:
    """A thousand times a hundred thousand seconds: they would not end by themselves."""
    model = with_sensors(oscillator)
    before = signal.signal(signal.SIGALRM, signal.default_int_handler)
    signal.setitimer(signal.ITIMER_REAL, 0.1)
    try:
        with pytest.raises(KeyboardInterrupt):
            model.mbs.SolveVariations({(spring(model), "stiffness"): np.full(1000, 50.0)}, settings(1e5, 100_000_000))
    finally:
        signal.signal(signal.SIGALRM, before)
    model.mbs.SolveDynamic(settings())  # the system is as good as before


def test_no_variations_give_no_rows() -> None:
    model = with_sensors(oscillator)
    results = model.mbs.SolveVariations({(spring(model), "stiffness"): []}, settings(), storeHistories=True)
    assert results.sensorValues.shape == (0, 2) and results.sensorHistories.shape == (0, 0, 3)


def hardening(mbs: Any, t: Any, item: Any, u: Any, v: Any, k: Any, d: Any, offset: Any) -> Any:
    return k * u + d * v + 300 * u * u * u


def with_hardening_spring() -> Oscillator:
    model = with_sensors(oscillator)
    name = "springForceUserFunction"
    law = CreateSymbolicUserFunction(model.mbs, hardening, name, spring(model))
    model.mbs.SetObjectParameter(spring(model), name, law)
    return model


def test_symbolic_functions_need_no_interpreter() -> None:
    wanted = []
    for k in STIFFNESSES:
        model = with_hardening_spring()
        model.mbs.SetObjectParameter(spring(model), "stiffness", k)
        wanted.append(alone(model.mbs, lambda mbs=model.mbs: mbs.SolveDynamic(settings())))
    model = with_hardening_spring()
    varied = {(spring(model), "stiffness"): STIFFNESSES}
    assert_equal(model.mbs.SolveVariations(varied, settings(), storeHistories=True, storeCoordinates=True), wanted)


PYTHON = "function 'springForceUserFunction', and variations are solved without the interpreter"


def test_python_functions_are_refused() -> None:
    model = oscillator(law=lambda mbs, t, item, u, v, k, d, offset: k * u)
    model.mbs.Assemble()
    with pytest.raises(RuntimeError, match=PYTHON) as caught:
        model.mbs.SolveVariations({(spring(model), "damping"): [1.0]}, settings())
    assert "'spring' (ObjectConnectorCoordinateSpringDamper)" in str(caught.value)
    assert "ParameterVariation" in str(caught.value)
    model = with_sensors(oscillator)
    model.mbs.SetPreStepUserFunction(lambda mbs, t: True)
    with pytest.raises(RuntimeError, match="variations call no PreStepUserFunction"):
        model.mbs.SolveVariations({(spring(model), "damping"): [1.0]}, settings())


@pytest.mark.parametrize(
    ("name", "values"),
    [("stiffness", [80, np.nan]), ("activeConnector", [1, 7]), ("markerNumbers", [[0, 1], [0, -7]])],
)
def test_values_are_refused_as_by_set_object_parameter(name: str, values: Any) -> None:
    model = with_sensors(oscillator)
    with pytest.raises(ValueError) as alone_refused:
        model.mbs.SetObjectParameter(spring(model), name, np.array(values)[1])
    with pytest.raises(ValueError) as refused:
        model.mbs.SolveVariations({(spring(model), name): values}, settings())
    assert str(refused.value) == f"mbs.SolveVariations(...), variation 1: {alone_refused.value}"


def refusals(model: Oscillator) -> list[tuple[dict[str, Any], type, str]]:
    one = {(spring(model), "stiffness"): [1.0]}
    return [
        ({}, ValueError, "nothing varies"),
        ({"parameters": {(3, "stiffness"): [1.0]}}, TypeError, "expected .index of an item, name of a parameter."),
        ({"parameters": {"stiffness": [1.0]}}, TypeError, "expected keys .item index, parameter name.; received 'stiffness'"),
        ({"parameters": {(spring(model), "stiffnes"): [1.0]}}, ValueError, "no parameter 'stiffnes'.*'stiffness'"),
        ({"parameters": {(exu.ObjectIndex(9), "stiffness"): [1.0]}}, IndexError, "no object with number 9"),
        ({"parameters": {(spring(model), "name"): [1.0]}}, TypeError, "expected a parameter that is made of numbers"),
        ({"parameters": {(spring(model), "springForceUserFunction"): [0]}}, TypeError, "made of numbers"),
        ({"parameters": {(spring(model), "stiffness"): 1.0}}, ValueError, "an array of numbers with a row per variation"),
        ({"parameters": one, "settings": {"timeIntegration.endTime": [1, 2]}}, ValueError, "one row per variation; the numbers of rows differ"),
        ({"parameters": one, "settings": {"timeIntegration.endTim": [1]}}, AttributeError, "endTime"),
        ({"parameters": one, "settings": {"timeIntegration": [1]}}, TypeError, "a setting that is made of numbers"),
        ({"settings": {"timeIntegration.endTime": [-1.0]}}, ValueError, "variation 0: .*endTime"),
        ({"initialCoordinates": {"ODE3": [[1.0]]}}, ValueError, "received 'ODE3'.*ODE2"),
        ({"initialCoordinates": {"ODE2": [[1.0, 2.0]]}}, ValueError, r"received an array of shape \(1, 2\), but expected shape \(1, 1\)"),
        ({"parameters": one, "sensors": [8]}, IndexError, "no sensor with number 8"),
        ({"parameters": one, "solverType": 17}, ValueError, "SolveVariations: solverType"),
        ({"parameters": one, "numberOfThreads": 0}, ValueError, "numberOfThreads must be at least 1"),
    ]  # fmt: skip


@pytest.mark.parametrize("case", range(17))
def test_refusals(case: int) -> None:
    model = with_sensors(oscillator)
    arguments, error, text = refusals(model)[case]
    with pytest.raises(error, match=text):
        model.mbs.SolveVariations(**{"parameters": {}, "simulationSettings": settings()} | arguments)
