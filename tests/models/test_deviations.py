"""Where the seed system is not followed: what is computed here against formulas that are written out, and what theirs would give."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from solving import Variable, new_system, settings
from test_heavy_top import ERRORS, axis_motion, heavy_top

import dalembert as exu

BODY = Rotation.from_rotvec([0.3, -0.5, 0.7]).as_matrix()
JOINT = Rotation.from_rotvec([-0.4, 0.2, 0.9]).as_matrix()
ALL = Rotation.from_rotvec([1.1, 0.6, -0.8]).as_matrix()
STIFFNESS = np.diag([100.0, 200, 300])
OFFSET = np.array([0.1, -0.2, 0.05])


def spring_force(turn: np.ndarray, offset: np.ndarray) -> np.ndarray:
    """On a body of 1 kg at an offset from a turned ground: its acceleration from rest."""
    mbs = new_system()
    ground = mbs.CreateGround(referenceRotationMatrix=turn)
    node = mbs.AddNode(exu.NodeRigidBodyRotVecLG(referenceCoordinates=[*offset, 0, 0, 0]))
    body = mbs.AddObject(exu.RigidBody(physicsMass=1, physicsInertia=[1, 1, 1, 0, 0, 0], nodeNumber=node))
    markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=b)) for b in (ground, body)]
    stiffness = np.zeros((6, 6))
    stiffness[:3, :3] = STIFFNESS
    mbs.AddObject(exu.RigidBodySpringDamper(markerNumbers=markers, stiffness=stiffness, rotationMarker0=JOINT))
    mbs.Assemble()
    mbs.SolveDynamic(settings(1e-9, 1))
    return np.asarray(mbs.GetObjectOutputBody(body, Variable.Acceleration, [0, 0, 0]))


def force_in(frame: np.ndarray, offset: np.ndarray) -> np.ndarray:
    return np.asarray(-frame @ STIFFNESS @ frame.T @ offset)


def test_frame_of_the_rigid_body_spring_damper() -> None:
    """The joint frame is marker times rotationMarker0, so that a model that is turned as a whole has turned forces. In the other
    order, the frame does not turn with its body."""
    np.testing.assert_allclose(spring_force(BODY, OFFSET), force_in(BODY @ JOINT, OFFSET), rtol=0, atol=1e-9)
    turned = spring_force(ALL @ BODY, ALL @ OFFSET)
    np.testing.assert_allclose(turned, ALL @ spring_force(BODY, OFFSET), rtol=0, atol=1e-9)
    other = ALL @ force_in(JOINT @ BODY, OFFSET) - force_in(JOINT @ ALL @ BODY, ALL @ OFFSET)
    assert np.linalg.norm(other) > 1


@pytest.mark.parametrize(("node", "scheme"), ERRORS)
def test_first_force_of_the_heavy_top(node: str, scheme: str) -> None:
    """With reference rotations that are not zero. From the balance of angular momentum, 319.5 N inwards and 317.3 N downwards."""
    mbs, _, joint = heavy_top(node)
    force = mbs.AddSensor(exu.SensorObject(objectNumber=joint, outputVariableType=Variable.Force, storeInternal=True))
    mbs.Assemble()
    mbs.SolveDynamic(settings(1e-6, 1))
    start = mbs.GetSensorStoredData(force)[0, 1:]
    np.testing.assert_allclose(start, axis_motion(0.0)[2], rtol=0, atol=1e-6)


def triple_products(turn: Any) -> np.ndarray:
    """x0 . (y1 x z0) - 1 and its cyclic neighbours."""
    frame = Rotation.from_rotvec(turn).as_matrix().T
    axes = np.eye(3)
    return np.array([axes[k] @ np.cross(frame[(k + 1) % 3], axes[(k + 2) % 3]) - 1 for k in range(3)])


def test_alternative_constraints_are_regular() -> None:
    """Triple products have no gradient where the frames agree, so no torque can hold them there; a rotation vector has."""
    h = 1e-5
    slopes = np.array([triple_products(h * e) - triple_products(-h * e) for e in np.eye(3)]) / (2 * h)
    np.testing.assert_allclose(slopes, 0, atol=1e-9)
    mbs = new_system()
    node = mbs.AddNode(exu.NodeRigidBodyRotVecLG())
    body = mbs.AddObject(exu.RigidBody(physicsMass=1, physicsInertia=[1, 1, 1, 0, 0, 0], nodeNumber=node))
    ground = mbs.AddObject(exu.ObjectGround())
    markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=b)) for b in (ground, body)]
    mbs.AddObject(exu.GenericJoint(markerNumbers=markers, alternativeConstraints=True))
    mbs.Assemble()
    gradients = mbs.ComputeLinearizedSystem(returnConstraintJacobian=True)[3]
    np.testing.assert_allclose(np.linalg.svd(gradients, compute_uv=False), 1, rtol=0, atol=1e-9)
