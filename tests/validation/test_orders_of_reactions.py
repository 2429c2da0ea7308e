"""Forces of joints are of the order of the methods, also where steps follow from tolerances, from the first step on and after events."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.ndimage import maximum_filter1d
from solving import Solver, Variable, new_system, settings

import dalembert as exu

MASS, LENGTH, GRAVITY, ANGLE, RATE, END = 2.0, 1.3, 9.81, 1.2, 0.4, 2.0


@cache
def motion() -> Any:
    """Angle and rate of the pendulum, by a method of order 8 with tolerances near rounding."""
    return solve_ivp(
        lambda t, x: [x[1], -GRAVITY / LENGTH * np.sin(x[0])],
        [0, END],
        [ANGLE, RATE],
        "DOP853",
        rtol=1e-13,
        atol=1e-13,
        dense_output=True,
    ).sol


def errors_of_reactions(s: Any, solver: Any, events: bool = False) -> tuple[np.ndarray, np.ndarray]:
    """Sizes of steps, and at their ends how much the force along a mathematical pendulum is off."""
    mbs = new_system()
    place, speed = [LENGTH * np.sin(ANGLE), -LENGTH * np.cos(ANGLE)], LENGTH * RATE
    node = mbs.AddNode(
        exu.NodePoint2D(referenceCoordinates=place, initialVelocities=[speed * np.cos(ANGLE), speed * np.sin(ANGLE)])
    )
    mbs.AddObject(exu.MassPoint2D(physicsMass=MASS, nodeNumber=node))
    ground = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=mbs.AddObject(exu.ObjectGround())))
    end = mbs.AddMarker(exu.MarkerNodePosition(nodeNumber=node))
    rod = mbs.AddObject(exu.DistanceConstraint(markerNumbers=[ground, end], distance=LENGTH))
    mbs.AddLoad(exu.Force(markerNumber=end, loadVector=[0, -MASS * GRAVITY, 0]))
    mbs.Assemble()
    if events:
        mbs.SetEventsUserFunction(lambda mbs, t: [(t - at, 1) for at in (0.3001, 0.3002, 0.9)])
    found = []

    def note(mbs: Any, t: float) -> bool:
        found.append([t, np.linalg.norm(mbs.GetObjectOutput(rod, Variable.Force))])
        return True

    mbs.SetPostStepUserFunction(note)
    mbs.SolveDynamic(s, solverType=solver)
    times, forces = np.array(found).T
    angle, rate = motion()(times)
    exact = MASS * (LENGTH * rate**2 + GRAVITY * np.cos(angle))
    return np.diff(times), np.abs(forces - exact)[1:]


def by_tolerance(tolerance: float, spectral_radius: float) -> Any:
    s = settings(END, 10, spectral_radius, tolerance=1e-11)
    s.timeIntegration.automaticStepSize = s.stepSizeControl.implicitSolvers = True
    s.timeIntegration.absoluteTolerance = s.timeIntegration.relativeTolerance = tolerance
    return s


@pytest.mark.parametrize("events", [False, True])
@pytest.mark.parametrize(
    ("solver", "spectral_radius"),
    [(Solver.GeneralizedAlpha, 0.6), (Solver.GeneralizedAlpha, 1), (Solver.TrapezoidalIndex2, 1)],
)
def test_reactions_are_of_second_order_in_steps_by_tolerances(
    solver: Any, spectral_radius: float, events: bool
) -> None:
    """Steps become longer while accelerations hardly change: errors are compared with squares of sizes there.

    A tenth of the tolerance is a third of the step; they would be three times as large if they were of first order.
    """
    sizes = []
    for tolerance in (1e-5, 1e-6, 1e-7):
        steps, errors = errors_of_reactions(by_tolerance(tolerance, spectral_radius), solver, events)
        sizes.append([np.median(errors), np.max(errors / maximum_filter1d(steps, 11) ** 2)])
    medians, multiples = np.array(sizes).T
    assert (medians[:-1] > 8 * medians[1:]).all()
    assert multiples[2] < 1.5 * multiples[0] and multiples[0] < 1000  # N/s^2


def test_reactions_of_the_diagonally_implicit_method_are_of_fourth_order() -> None:
    def largest(steps: int) -> float:
        s = settings(END, steps, tolerance=1e-12)
        s.timeIntegration.automaticStepSize = False
        return float(errors_of_reactions(s, Solver.ESDIRK43)[1].max())

    errors = [largest(steps) for steps in (25, 50, 100)]
    observed = np.log2(np.divide(errors[:-1], errors[1:]))
    assert observed == pytest.approx([4, 4], abs=0.2)


@pytest.mark.parametrize("tolerance", [1e-4, 1e-6, 1e-8])
def test_reactions_of_the_diagonally_implicit_method_follow_tolerances(tolerance: float) -> None:
    """Errors of forces of up to 45 N."""
    errors = errors_of_reactions(by_tolerance(tolerance, 1), Solver.ESDIRK43)[1]
    assert tolerance < errors.max() < 1000 * tolerance
