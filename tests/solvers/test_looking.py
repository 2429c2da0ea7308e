"""The visualized state is updated for readers, at the end, and not otherwise: then nothing is paid for it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from oscillators import dynamic_settings, oscillator

import dalembert as exu

Visualization = exu.ConfigurationType.Visualization
STEPS = 300_000  # a few microseconds: many of the looks that are 2 ms apart


def looks(model: Any, times: list[float]) -> list[float]:
    """Solve; return the times of the visualized state as they are read when the simulation has reached `times`."""
    seen, data, due = [], model.mbs.systemData, list(times)

    def look(mbs: Any, t: float) -> bool:
        if due and t >= due[0]:
            due.pop(0)
            seen.append(data.GetTime(Visualization))
        return True

    model.mbs.SetPostStepUserFunction(look)
    settings = dynamic_settings(30.0, STEPS)
    model.mbs.SolveDynamic(settings)
    return seen


def test_no_reader() -> None:
    """The first reader gets the state before the simulation; it is updated from then on."""
    model = oscillator()
    model.mbs.Assemble()
    first, second = looks(model, [15.0, 25.0])
    assert first == 0
    assert 15 < second <= 25
    assert model.mbs.systemData.GetTime(Visualization) == pytest.approx(30.0)


def test_views_are_always_renewed() -> None:
    model = oscillator()
    model.mbs.Assemble()
    view = model.mbs.systemData.GetODE2Coordinates(Visualization, copy=False)
    before = float(view[0])
    seen = []
    model.mbs.SetPostStepUserFunction(lambda mbs, t: bool(seen.append(float(view[0])) or True))
    model.mbs.SolveDynamic(dynamic_settings(1.0, 50_000))
    assert len(set(seen)) > 3
    assert seen[0] == before
    assert view[0] == model.position


def test_parts_of_a_solution_end_with_the_state_that_they_reach() -> None:
    model = oscillator()
    model.mbs.Assemble()
    solver, settings = exu.MainSolverImplicitSecondOrder(), dynamic_settings(1.0, 10)
    solver.InitializeSolver(model.mbs, settings)
    solver.SolveSteps(model.mbs, settings)
    assert model.mbs.systemData.GetTime(Visualization) == pytest.approx(1.0)
    solver.FinalizeSolver(model.mbs, settings)


def test_a_solution_that_fails_leaves_the_last_state() -> None:
    model = oscillator()
    model.mbs.Assemble()

    def stop(mbs: Any, t: float) -> bool:
        if t > 0.55:
            raise ArithmeticError("enough")
        return True

    model.mbs.SetPreStepUserFunction(stop)
    with pytest.raises(ArithmeticError):
        model.mbs.SolveDynamic(dynamic_settings(1.0, 10))
    data = model.mbs.systemData
    assert data.GetTime(Visualization) == data.GetTime() > 0.4
    np.testing.assert_array_equal(data.GetODE2Coordinates(Visualization), data.GetODE2Coordinates())
