"""Friction and stops, with the discontinuous iteration and without."""

from __future__ import annotations

import numpy as np
import pytest
from oscillators import MASS, dynamic_settings, friction_or_stop, mass, oscillator

import dalembert as exu
from dalembert.solver import SolverError

Solver = exu.DynamicSolverType


@pytest.mark.parametrize("speed", [2.0, -2.0])
def test_friction_stops_a_mass(speed: float) -> None:
    """It slides v^2 m / (2 F), and stays where it came to rest."""
    model = mass(position=0.0, speed=speed)
    friction_or_stop(
        model, np.sign(speed), stiffness=0.0, fDynamicFriction=5.0, stickingStiffness=1e6, stickingDamping=1e3
    )
    model.mbs.Assemble()
    settings = dynamic_settings(2.0, 2000, tolerance=1e-10)
    settings.timeIntegration.discontinuous.iterationTolerance = 1e-6
    model.mbs.SolveDynamic(settings)
    slid = np.sign(speed) * speed**2 * MASS / (2 * 5.0)
    # Sticking begins within one step h of standstill, after at most F h^2 / m, and springs by F / stiffness.
    assert model.position == pytest.approx(slid, abs=2e-5)
    assert abs(model.speed) < 1e-4
    halfway = model.table()[400]  # before the end of sliding, at 0.8 s
    exact = speed * 0.4 - np.sign(speed) * 0.5 * 5.0 / MASS * 0.4**2
    assert halfway[1] == pytest.approx(exact, abs=1e-9)  # constant accelerations are exact


def test_a_load_below_static_friction_moves_nothing() -> None:
    model = mass(position=0.0, speed=0.0)
    friction_or_stop(model, stiffness=0.0, fDynamicFriction=5.0, stickingStiffness=1e4, stickingDamping=100.0)
    model.load(3.0)
    model.mbs.Assemble()
    settings = dynamic_settings(1.0, 1000, tolerance=1e-10)
    model.mbs.SolveDynamic(settings)
    assert model.position == pytest.approx(3.0 / 1e4, rel=1e-3)  # oscillations have died out


@pytest.mark.parametrize("recommended", [True, False])
def test_a_stop_throws_back(recommended: bool) -> None:
    """A stop without damping returns the speed; steps divide the contact time of pi sqrt(m / k) = 4.4 ms by 88."""
    model = mass(position=0.2, speed=-1.0)
    friction_or_stop(
        model,
        useLimitStops=True,
        limitStopsLower=0.0,
        limitStopsUpper=10.0,
        limitStopsStiffness=1e6,
        limitStopsDamping=0.0,
    )
    model.mbs.Assemble()
    settings = dynamic_settings(0.4, 8000, tolerance=1e-10)
    settings.timeIntegration.generalizedAlpha.spectralRadius = 1.0
    settings.timeIntegration.discontinuous.iterationTolerance = 1e-6
    settings.timeIntegration.discontinuous.useRecommendedStepSize = recommended
    model.mbs.SolveDynamic(settings)
    assert model.speed == pytest.approx(1.0, abs=0.02)
    contact = np.pi * np.sqrt(MASS / 1e6)
    assert model.position == pytest.approx(0.4 - 0.2 - contact, abs=0.005)
    assert model.table()[:, 1].min() == pytest.approx(-np.sqrt(MASS / 1e6), rel=0.02)


def test_post_newton_function_repeats_the_step() -> None:
    calls: list[float] = []

    def twice(mbs: object, t: float) -> list[float]:
        calls.append(t)
        return [5.0 if len(calls) % 2 else 0.0, -1]

    model = mass()
    model.mbs.Assemble()
    model.mbs.SetPostNewtonUserFunction(twice)
    model.mbs.SolveDynamic(dynamic_settings(1.0, 5))
    np.testing.assert_allclose(calls, np.repeat([0.2, 0.4, 0.6, 0.8, 1.0], 2), rtol=1e-14)
    assert model.position == pytest.approx(0.3 - 0.7, abs=1e-14)  # repeated steps start from the same state


def test_a_step_that_does_not_settle() -> None:
    model = mass()
    model.mbs.Assemble()
    model.mbs.SetPostNewtonUserFunction(lambda mbs, t: [5.0, -1])
    settings = dynamic_settings(1.0, 5)
    settings.timeIntegration.verboseMode = 0
    settings.timeIntegration.adaptiveStep = False
    settings.timeIntegration.discontinuous.ignoreMaxIterations = False
    with pytest.raises(SolverError, match="did not settle in step 1 at time 0.2"):
        model.mbs.SolveDynamic(settings)
    settings.timeIntegration.discontinuous.ignoreMaxIterations = True
    model.mbs.SolveDynamic(settings)
    assert model.position == pytest.approx(0.3 - 0.7, abs=1e-14)


@pytest.mark.parametrize("solver", [Solver.ODE23, Solver.DOPRI5, Solver.GeneralizedAlpha, Solver.TrapezoidalIndex2])
def test_repeated_steps_are_the_same_steps(solver: exu.DynamicSolverType) -> None:
    """A discontinuous iteration without changes gives the same result, for any step size that error control has
    selected for the next step."""
    tables = []
    for repeats in (False, True):
        model = oscillator()
        asked = 0

        def twice(mbs: exu.MainSystem, t: float, repeats: bool = repeats) -> list[float]:
            nonlocal asked
            asked += 1
            return [2.0 if repeats and asked % 2 else 0.0, -1.0]

        model.mbs.SetPostNewtonUserFunction(twice)
        model.mbs.Assemble()
        settings = dynamic_settings(1.0, 1)
        settings.timeIntegration.automaticStepSize = True
        settings.timeIntegration.absoluteTolerance = settings.timeIntegration.relativeTolerance = 1e-7
        settings.timeIntegration.discontinuous.iterationTolerance = 1.0
        model.mbs.SolveDynamic(settings, solverType=solver)
        tables.append(model.table())
    np.testing.assert_array_equal(*tables)
