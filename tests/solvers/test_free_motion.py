"""Static equilibria of which there are many: zero-energy modes are named, soft ones are not."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert.beams import GenerateStraightLineANCFCable2D
from dalembert.itemInterface import (
    CartesianSpringDamper,
    CoordinateConstraint,
    Force,
    MarkerBodyPosition,
    MarkerBodyRigid,
    MarkerNodeCoordinate,
    MarkerNodePosition,
    NodePointGround,
    NodeRigidBody2D,
    ObjectANCFCable2D,
    ObjectGround,
    ObjectRigidBody2D,
    TorsionalSpringDamper,
)
from dalembert.rigidBodyUtilities import InertiaCuboid

WORDS = "other states are in balance as well"
SOLVERS = [exu.LinearSolverType.EXUdense, exu.LinearSolverType.EigenSparse]


def solve(mbs: Any, linear: Any = exu.LinearSolverType.EXUdense, **newton: Any) -> None:
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    settings.linearSolverType = linear
    settings.staticSolver.newton.relativeTolerance = 1e-10
    for name, value in newton.items():
        setattr(settings.staticSolver.newton, name, value)
    assert mbs.SolveStatic(settings)


def swivel(hold: float, angle: float = 1.1) -> tuple[Any, int]:
    """A body on springs at one of its points, pulled there: it turns about that point as it likes."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.AddObject(ObjectGround())
    node = mbs.AddNode(NodeRigidBody2D(name="swivel", referenceCoordinates=[0.2, 0.1, angle]))
    body = mbs.AddObject(ObjectRigidBody2D(physicsMass=1, physicsInertia=0.1, nodeNumber=node))
    point = mbs.AddMarker(MarkerBodyPosition(bodyNumber=body, localPosition=[-0.2, -0.1, 0]))
    fixed = mbs.AddMarker(MarkerBodyPosition(bodyNumber=ground))
    mbs.AddObject(CartesianSpringDamper(markerNumbers=[fixed, point], stiffness=[200, 300, 0]))
    mbs.AddLoad(Force(markerNumber=point, loadVector=[2, 0, 0]))
    if hold > 0:
        frames = [mbs.AddMarker(MarkerBodyRigid(bodyNumber=one)) for one in (ground, body)]
        mbs.AddObject(TorsionalSpringDamper(markerNumbers=frames, stiffness=hold, offset=angle + 0.2))
    return mbs, body


@pytest.mark.parametrize("linear", SOLVERS, ids=str)
@pytest.mark.parametrize("modified", [False, True])
def test_a_body_that_turns_freely(linear: Any, modified: bool, capfd: Any) -> None:
    mbs, body = swivel(hold=0)
    solve(mbs, linear, useModifiedNewton=modified)
    told = capfd.readouterr().out
    assert told.count(WORDS) == 1
    assert "swivel" in told
    # The springs carry the force at this position, to the tolerance of Newton's method, for any angle.
    where = mbs.GetObjectOutputBody(body, exu.OutputVariableType.Position, [-0.2, -0.1, 0])
    np.testing.assert_allclose(where, [2 / 200, 0, 0], rtol=0, atol=1e-10)


@pytest.mark.parametrize("linear", SOLVERS, ids=str)
def test_a_weak_spring_holds_it(linear: Any, capfd: Any) -> None:
    mbs, body = swivel(hold=1e-6)  # of 60 N m/rad about the point by the springs, which is far above rounding
    solve(mbs, linear)
    assert WORDS not in capfd.readouterr().out
    turned = mbs.GetObjectOutputBody(body, exu.OutputVariableType.Rotation, [0, 0, 0])
    assert float(turned) == pytest.approx(0.2, abs=1e-3)  # residuals of 1e-10 of 2 N turn it by 2e-4 rad


def test_a_pendulum_is_held_by_its_load(capfd: Any) -> None:
    """Springs need not be there: the pull at its end has a stiffness, 5 N times 1 m per rad."""
    mbs = exu.SystemContainer().AddSystem()
    bar = mbs.CreateRigidBody(referencePosition=[0, 0, -0.5], inertia=InertiaCuboid(1000, [0.1, 0.1, 1]))
    mbs.CreateRevoluteJoint(bodyNumbers=[mbs.CreateGround(), bar], position=[0, 0, 0], axis=[0, 1, 0])
    mbs.CreateForce(bodyNumber=bar, localPosition=[0, 0, -0.5], loadVector=[0, 0, -5])
    solve(mbs)
    assert WORDS not in capfd.readouterr().out


def test_slender_beams_are_soft_but_held(capfd: Any) -> None:
    """Axial stiffness over bending stiffness and length squared is 1e8, in 64 elements that lie askew."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
    cable = ObjectANCFCable2D(physicsMassPerLength=1, physicsBendingStiffness=1e-2, physicsAxialStiffness=1e6)
    end = np.array([0.6, 0.8, 0])
    nodes = GenerateStraightLineANCFCable2D(mbs, [0, 0, 0], end, 64, cable, [0, 0, 0], [0] * 4, [0] * 4)[0]
    for coordinate in range(4):
        marker = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=nodes[0], coordinate=coordinate))
        mbs.AddObject(CoordinateConstraint(markerNumbers=[ground, marker]))
    tip = mbs.AddMarker(MarkerNodePosition(nodeNumber=nodes[-1]))
    force = 1e-4 * np.array([-0.8, 0.6, 0])
    mbs.AddLoad(Force(markerNumber=tip, loadVector=force))
    solve(mbs, exu.LinearSolverType.EigenSparse)
    assert WORDS not in capfd.readouterr().out
    moved = mbs.GetNodeOutput(nodes[-1], exu.OutputVariableType.Displacement)
    bent = 1e-4 / 3e-2  # F L^3 / (3 EI), to the square of bent / L
    assert np.dot(moved, [-0.8, 0.6, 0]) == pytest.approx(bent, rel=3e-5)
    # The tip comes nearer by the integral of half the squared slope, 3/5 bent^2 / L; remaining errors of 64 elements
    # and of the series: 1 %.
    assert np.dot(moved, [0.6, 0.8, 0]) == pytest.approx(-0.6 * bent**2, rel=0.01)
