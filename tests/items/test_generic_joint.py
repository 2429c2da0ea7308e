"""ObjectJointGeneric with alternativeConstraints."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import dalembert as exu

Variable = exu.OutputVariableType


def body_on_joint(turn: Any, alternative: bool) -> tuple[Any, Any, Any]:
    """A body fixed to ground, but turned away from it at the start; a torque acts."""
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(exu.NodeRigidBodyRotVecLG(initialCoordinates=[0, 0, 0, *turn]))
    body = mbs.AddObject(exu.RigidBody(physicsMass=2, physicsInertia=[1, 1.5, 2, 0, 0, 0], nodeNumber=node))
    ground = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=mbs.AddObject(exu.ObjectGround())))
    marker = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body))
    joint = mbs.AddObject(exu.GenericJoint(markerNumbers=[ground, marker], alternativeConstraints=alternative))
    mbs.AddLoad(exu.Torque(markerNumber=marker, loadVector=[1, 2, 3]))
    mbs.Assemble()
    return mbs, body, joint


def settings() -> Any:
    s = exu.SimulationSettings()
    s.timeIntegration.endTime, s.timeIntegration.numberOfSteps = 0.01, 5
    s.timeIntegration.verboseMode = s.staticSolver.verboseMode = 0
    s.solutionSettings.writeSolutionToFile = False
    return s


@pytest.mark.parametrize("alternative", [False, True])
def test_torque_where_the_frames_agree(alternative: bool) -> None:
    """The multipliers have the same meaning with both kinds of equations."""
    mbs, _, joint = body_on_joint([0, 0, 0], alternative)
    mbs.SolveDynamic(settings())
    np.testing.assert_allclose(mbs.GetObjectOutput(joint, Variable.TorqueLocal), [1, -2, -3], rtol=0, atol=1e-9)


@pytest.mark.parametrize("angle", [0.5, 2.0, 2.9])
def test_static_solution_does_not_flip(angle: float) -> None:
    """The frames come to agree from any start below half a turn; products of axes also vanish after half a turn."""
    turn = angle * np.array([2, -1, 2]) / 3
    mbs, body, _ = body_on_joint(turn, True)
    mbs.SolveStatic(settings())
    rotation = Rotation.from_matrix(mbs.GetObjectOutputBody(body, Variable.RotationMatrix, [0, 0, 0]).reshape(3, 3))
    assert rotation.magnitude() < 1e-8
