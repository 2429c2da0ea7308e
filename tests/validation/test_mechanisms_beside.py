"""Mechanisms with redundant constraints do not notice others that are a thousand times larger."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from solving import Solver, Variable, new_system, settings
from test_redundant import LEAN

import dalembert as exu
from dalembert.rigidBodyUtilities import InertiaCuboid


def add_door(mbs: Any, ground: Any, length: float, place: Any, misplaced: float) -> tuple[Any, list[Any]]:
    """A door on two hinges, the second one misplaced by that part of the length; a mass that does not affect Newton's
    tolerances."""
    size = length * np.array([0.45, 0.02, 1.0])
    center, start = length * np.array([0.225, 0, 0.5]), np.asarray(place, dtype=float)
    door = mbs.CreateRigidBody(
        referencePosition=start + center,
        inertia=InertiaCuboid(density=800 / length**3, sideLengths=size),
        gravity=[0, 9.81 * np.sin(LEAN), -9.81 * np.cos(LEAN)],
    )
    hinges = []
    for height, apart in ((0.15, 0.0), (0.85, misplaced)):
        at = length * np.array([0, 0, height])
        ends = ((ground, start + at + [length * apart, 0, 0]), (door, at - center))
        markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body, localPosition=p)) for body, p in ends]
        hinges.append(mbs.AddObject(exu.RevoluteJointZ(markerNumbers=markers)))
    return door, hinges


def motion_and_reactions(beside: float, solver: Any, misplaced: float) -> tuple[np.ndarray, np.ndarray]:
    """A door of 1 m, with another one of that length, if any."""
    mbs = new_system()
    ground = mbs.CreateGround()
    door, hinges = add_door(mbs, ground, 1, [0, 0, 0], misplaced)
    if beside > 0:
        add_door(mbs, ground, beside, [3, 0, 0], 0)
    mbs.Assemble()
    s = settings(0.5, 100, tolerance=1e-12)
    s.timeIntegration.automaticStepSize = False  # steps would be those of both
    mbs.SolveDynamic(s, solverType=solver)
    edge = [mbs.GetObjectOutputBody(door, v, [0.225, 0, 0]) for v in (Variable.Position, Variable.Velocity)]
    carried = [mbs.GetObjectOutput(h, v) for h in hinges for v in (Variable.ForceLocal, Variable.TorqueLocal)]
    return np.concatenate(edge), np.concatenate(carried)


@pytest.mark.parametrize("misplaced", [0, 1e-6], ids=["fits", "misplaced"])
@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.TrapezoidalIndex2, Solver.DOPRI5, Solver.ESDIRK43])
def test_a_large_mechanism_beside_changes_nothing(solver: Any, misplaced: float) -> None:
    """Edges of misplaced hinges were 1e-7 m off with the size of the model for both, and moments were distributed
    differently."""
    motion, reactions = motion_and_reactions(0, solver, misplaced)
    beside, reactions_beside = motion_and_reactions(1000, solver, misplaced)
    np.testing.assert_allclose(beside, motion, rtol=0, atol=1e-9)
    np.testing.assert_allclose(reactions_beside, reactions, rtol=0, atol=1e-6 * np.abs(reactions).max())


def add_four_bar(mbs: Any, ground: Any, length: float, place: Any) -> None:
    """A planar mechanism in space, so that three equations are redundant."""
    corners = np.asarray(place) + length * np.array([[0, 0, 0], [0.3, 0, 0.9], [1.5, 0, 1.2], [1.6, 0, 0]])
    bodies = [ground]
    for start, end in zip(corners[:-1], corners[1:], strict=True):
        along = (end - start) / np.linalg.norm(end - start)
        body = mbs.CreateRigidBody(
            referencePosition=(start + end) / 2,
            referenceRotationMatrix=np.column_stack([along, np.cross([0, 1, 0], along), [0, 1, 0]]),
            inertia=InertiaCuboid(1000, length * np.array([1, 0.1, 0.05])),
            gravity=[3, 0, -9.81],
        )
        bodies.append(body)
    for corner, pair in zip(corners, zip(bodies, [*bodies[1:], ground], strict=True), strict=True):
        mbs.CreateRevoluteJoint(bodyNumbers=list(pair), position=corner, axis=[0, 1, 0])


def doubts_of_drift(beside: float) -> str:
    mbs = new_system()
    ground = mbs.CreateGround()
    add_four_bar(mbs, ground, 0.07, [0, 0, 0])
    if beside > 0:
        add_four_bar(mbs, ground, beside, [1, 0, 0])
    mbs.Assemble()
    s = settings(0.3, 300)
    s.initialConditions.positionTolerance = 1e-8  # drift may be 1000 times as large
    doubts = mbs.SolveDynamic(s, solverType=Solver.TrapezoidalIndex2).doubts
    (doubt,) = (each for each in doubts if each.startswith("open at the end"))
    return str(doubt).split("\n")[0]


def test_drift_of_a_small_mechanism_is_told() -> None:
    """Constraints of velocities let joints of a linkage of 7 cm drift apart: a little by the neighbour, by more than
    1e-5 by itself."""
    told = doubts_of_drift(0)
    assert told.startswith("open at the end: ")
    assert doubts_of_drift(6) == told
