"""Variations without a solution: each has a reason, and others are not affected."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from ensembles import crank, settings
from oscillators import oscillator

import dalembert as exu

Solver = exu.DynamicSolverType
LANES = 8  # variations that go together


def springs(stiffnesses: list[float], solver: Any, **options: Any) -> Any:
    model = oscillator(damping=0)
    model.mbs.Assemble()
    s = settings(1.0, 100)
    for name, value in options.items():
        setattr(s.timeIntegration, name, value)
    return model.mbs.SolveVariations({(model.mbs.GetObjectNumber("spring"), "stiffness"): stiffnesses}, s, solver)


@pytest.mark.parametrize("solver", [Solver.ExplicitEuler, Solver.RK33, Solver.RK44, Solver.RK67, Solver.VelocityVerlet])
def test_steps_that_are_too_long_for_some(solver: Any) -> None:
    results = springs([10.0, 2e7, 20.0], solver)
    assert results.success.tolist() == [True, False, True]
    assert "the solution grows without bound in step" in results.messages[1]
    assert "the fastest vibration at the start, 3162.28 rad/s at node 0 'foot'" in results.messages[1]
    assert np.isnan(results.sensorValues[1]).all()
    assert results.endTimes[1] < 0.1
    assert results.sensorValues[[0, 2]].tolist() == springs([10.0, 20.0], solver).sensorValues.tolist()


def cranks(bad: dict[int, Any], count: int = LANES) -> Any:
    """Slider-cranks that start with different speeds; variations of `bad` are replaced."""
    mbs, *_ = crank(0.3)
    speeds = np.zeros((count, 9))
    speeds[:, 2] = np.linspace(0, 1e-3, count)
    for number, value in bad.items():
        speeds[number] = value
    return mbs.SolveVariations(
        {}, settings(0.1, 20), initialCoordinates={"ODE2_t": speeds}, storeCoordinates=True, numberOfThreads=1
    )


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (np.nan, "a value is not finite at the start"),
        (np.inf, "a value is not finite at the start"),
        (1e120, "the solution grows without bound in step 1"),
        (1e200, "a value is not finite at the start"),  # accelerations: squares of the speed
    ],
)
def test_one_of_those_side_by_side(value: float, text: str) -> None:
    good, results = cranks({}), cranks({3: value})
    assert good.success.all() and good.sideBySide.all()
    fine = np.arange(LANES) != 3
    np.testing.assert_array_equal(results.success, fine)
    np.testing.assert_array_equal(results.sideBySide, fine)
    assert text in results.messages[3]
    assert "(node" in results.messages[3] or "(object" in results.messages[3]
    assert "what to try" in results.messages[3]
    assert np.isnan(results.coordinates["ODE2"][3]).all()
    np.testing.assert_array_equal(results.coordinates["ODE2"][fine], good.coordinates["ODE2"][fine])


@pytest.mark.parametrize("vector", ["ODE2", "ODE2_t", "ODE2_tt"])
@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.RK44, Solver.VelocityVerlet, "static"])
def test_initial_values_that_are_no_numbers_are_named(vector: str, solver: Any) -> None:
    model = oscillator()
    model.mbs.Assemble()
    start = {vector: [[0.1], [np.nan]]}
    results = model.mbs.SolveVariations({}, settings(0.1, 10), solver, initialCoordinates=start)
    assert results.success.tolist() == [True, False]
    assert "a value is not finite at the start, time 0" in results.messages[1]
    assert f"{vector}[0]: nan  (node 0 'foot' (Node1D), coordinate 0)" in results.messages[1]
    assert "set finite initial values" in results.messages[1]
