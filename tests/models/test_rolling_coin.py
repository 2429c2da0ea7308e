"""A thin ring that starts nearly upright and turns about the vertical, rolls on a plane, and falls slowly over."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation
from solving import Variable, new_system, settings

import dalembert as exu
from dalembert.rigidBodyUtilities import RigidBodyInertia

MASS, RADIUS, GRAVITY, END = 1.0, 0.01, np.array([0, 0, -9.81]), 0.5
INERTIA = MASS * RADIUS**2 * np.diag([0.5, 0.25, 0.25])
TILT = Rotation.from_euler("y", 1, degrees=True).as_matrix()
SPIN = np.array([0, 0, 10 * np.pi])
CENTRE = RADIUS * np.array([TILT[0, 2], 0, TILT[2, 2]])
UP = np.array([0.0, 0, 1])


def down(axis: np.ndarray) -> np.ndarray:
    """The unit vector in the plane of the ring from its centre to the contact."""
    slope = axis * axis[2] - UP
    return np.asarray(slope / np.linalg.norm(slope))


def down_rate(axis: np.ndarray, rate: np.ndarray) -> np.ndarray:
    slope, slope_rate = axis * axis[2] - UP, rate * axis[2] + axis * rate[2]
    length = np.linalg.norm(slope)
    return np.asarray(slope_rate / length - slope * (slope @ slope_rate) / length**3)


def motion(_: float, state: np.ndarray) -> np.ndarray:
    """Rates of [centre, rotation matrix, angular velocity]: Newton and Euler, with a contact that does not slip."""
    turn, omega = state[3:12].reshape(3, 3), state[12:]
    axis = turn[:, 0]
    arm, arm_rate = RADIUS * down(axis), RADIUS * down_rate(axis, np.cross(omega, axis))
    inertia = turn @ INERTIA @ turn.T
    # acceleration = arm x alpha - omega x arm_rate; inertia alpha + omega x inertia omega = arm x mass (acceleration - gravity)
    known = -np.cross(omega, arm_rate) - GRAVITY
    across = np.cross(np.eye(3), arm).T  # times alpha: alpha x arm
    moment = MASS * np.cross(arm, known) - np.cross(omega, inertia @ omega)
    alpha = np.linalg.solve(inertia + MASS * across.T @ across, moment)
    return np.concatenate([-np.cross(omega, arm), np.cross(omega, turn.T).T.ravel(), alpha])


def exact() -> np.ndarray:
    """The contact point at the end."""
    start = np.concatenate([CENTRE, TILT.ravel(), SPIN])
    end = solve_ivp(motion, (0, END), start, method="DOP853", rtol=1e-12, atol=1e-14).y[:, -1]
    return np.asarray(end[:3] + RADIUS * down(end[3:12].reshape(3, 3)[:, 0]))


def rolled(steps: int, node: exu.NodeType) -> np.ndarray:
    mbs = new_system()
    coin = mbs.CreateRigidBody(
        referencePosition=CENTRE,
        referenceRotationMatrix=TILT,
        initialVelocity=np.cross(SPIN, CENTRE),
        initialAngularVelocity=SPIN,
        inertia=RigidBodyInertia(mass=MASS, inertiaTensor=INERTIA),
        gravity=GRAVITY,
        nodeType=node,
    )
    ground = mbs.CreateGround()
    markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=b)) for b in (ground, coin)]
    joint = mbs.AddObject(exu.ObjectJointRollingDisc(markerNumbers=markers, discRadius=RADIUS))
    mbs.Assemble()
    mbs.SolveDynamic(settings(END, steps), solverType=exu.DynamicSolverType.TrapezoidalIndex2)
    return np.asarray(mbs.GetObjectOutput(joint, Variable.Position))


# Of a thousand steps. Euler parameters drift off unit length meanwhile.
ERRORS = {exu.NodeType.RotationEulerParameters: 7.2e-7, exu.NodeType.RotationRxyz: 1.18e-5}


@pytest.mark.parametrize("node", ERRORS, ids=str)
def test_contact_point_after_half_a_second(node: exu.NodeType) -> None:
    """The trapezoidal rule is of second order: errors are as stated within 2 % and fall to a quarter."""
    errors = [np.linalg.norm(rolled(steps, node) - exact()) for steps in (1000, 2000)]
    np.testing.assert_allclose(errors[0], ERRORS[node], rtol=0.02)
    np.testing.assert_allclose(errors[0] / errors[1], 4, rtol=0.01)
