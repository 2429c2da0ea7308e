"""Units of length do not change what closed mechanisms do: consistent values and motions of doors in m, mm and km."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest
from solving import Solver, new_system, settings

import dalembert as exu
from dalembert.rigidBodyUtilities import InertiaCuboid, RotationMatrixX, RotationMatrixZ

MASS = 30.0


def hung_door(length: float, misplaced: float, turned: float, heights: Sequence[float] = (0.3, 1.7)) -> Any:
    """With so many units of length per metre, off its hinges, of which the second one does not fit the others."""
    mbs = new_system()
    ground = mbs.CreateGround()
    size, center = length * np.array([0.9, 0.04, 2.0]), length * np.array([0.45, 0, 1])
    door = mbs.CreateRigidBody(
        referencePosition=center,
        inertia=InertiaCuboid(density=MASS / np.prod(size), sideLengths=size),
        initialDisplacement=length * np.array([3e-4, 1e-4, -2e-4]),
        initialRotationMatrix=RotationMatrixZ(0.01) @ RotationMatrixX(0.003),
        initialAngularVelocity=[0.1, 0.2, 1],
        gravity=length * np.array([0, 2, -9.6]),
    )
    for i, height in enumerate(heights):
        place = length * np.array([0, 0, height])
        ends = ((ground, place + [length * misplaced * (i == 1), 0, 0]), (door, place - center))
        markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body, localPosition=p)) for body, p in ends]
        mbs.AddObject(exu.RevoluteJointZ(markerNumbers=markers, rotationMarker0=RotationMatrixX(turned * (i == 1))))
    mbs.Assemble()
    return mbs


def coordinates(mbs: Any, length: float, configuration: Any) -> np.ndarray:
    """In m, and what counts rotations, with their rates."""
    q = np.array(mbs.systemData.GetODE2Coordinates(configuration))
    v = np.array(mbs.systemData.GetODE2Coordinates_t(configuration))
    for values in (q, v):
        values[:3] /= length
    return np.concatenate([q, v])


def consistent(mbs: Any) -> Any:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of joints that do not fit
        return mbs.ComputeConsistentInitialConditions()


@pytest.mark.parametrize("length", [1e3, 1e-3], ids=["mm", "km"])
@pytest.mark.parametrize(
    ("misplaced", "turned", "heights"),
    [(0, 0, (0.3, 1.7)), (1e-6, 0, (0.3, 1.7)), (0, 1e-6, (0.3, 1.7)), (1e-6, 1e-6, (0.3, 0.4, 1.7))],
    ids=["fits", "misplaced", "turned", "both, of three"],
)
def test_consistent_values(misplaced: float, turned: float, heights: Sequence[float], length: float) -> None:
    """Gaps are relative to the size of a mechanism, and joints that do not fit share them as in solvers.

    Where each equation counted as much as any other, rates differed by 1e-4 of hinges that are turned by 1e-6.
    """
    in_metres, other = (hung_door(unit, misplaced, turned, heights) for unit in (1, length))
    found, same = consistent(in_metres), consistent(other)
    assert found.iterations == same.iterations and found.redundantEquations == same.redundantEquations
    initial = exu.ConfigurationType.Initial
    np.testing.assert_allclose(
        coordinates(other, length, initial), coordinates(in_metres, 1, initial), rtol=0, atol=1e-9
    )


@pytest.mark.parametrize("length", [1e3, 1e-3], ids=["mm", "km"])
@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.TrapezoidalIndex2, Solver.DOPRI5, Solver.ESDIRK43])
def test_motions(solver: Any, length: float) -> None:
    """Of hinges that hardly fit, from consistent values."""
    ends = []
    for unit in (1, length):
        mbs = hung_door(unit, 1e-7, 0)
        consistent(mbs)
        s = settings(0.5, 100, tolerance=1e-12)
        s.timeIntegration.automaticStepSize = False  # tolerances of errors are those of numbers
        mbs.SolveDynamic(s, solverType=solver)
        ends.append(coordinates(mbs, unit, exu.ConfigurationType.Current))
    np.testing.assert_allclose(ends[1], ends[0], rtol=0, atol=1e-9)
