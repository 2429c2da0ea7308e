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


START = np.concatenate([CENTRE, TILT.ravel(), SPIN])


def contact(state: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The contact point, and the force there by Newton's law, in the axes (lateral, forward, up) of the contact."""
    turn, omega, alpha = state[3:12].reshape(3, 3), state[12:], motion(0, state)[12:]
    axis = turn[:, 0]
    arm, arm_rate = RADIUS * down(axis), RADIUS * down_rate(axis, np.cross(omega, axis))
    force = MASS * (-np.cross(alpha, arm) - np.cross(omega, arm_rate) - GRAVITY)
    along = np.cross(axis, UP)
    forward = along / np.linalg.norm(along)
    return state[:3] + arm, np.array([np.cross(UP, forward), forward, UP]) @ force


def exact() -> tuple[np.ndarray, np.ndarray]:
    """Contact point and force at the end."""
    return contact(solve_ivp(motion, (0, END), START, method="DOP853", rtol=1e-12, atol=1e-14).y[:, -1])


def rolled(steps: int, node: exu.NodeType) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Contact point at the end; forces at the start and at the end."""
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
    force = mbs.AddSensor(
        exu.SensorObject(
            objectNumber=joint, outputVariableType=Variable.ForceLocal, storeInternal=True, writeToFile=False
        )
    )
    mbs.Assemble()
    mbs.SolveDynamic(settings(END, steps), solverType=exu.DynamicSolverType.TrapezoidalIndex2)
    stored = mbs.GetSensorStoredData(force)
    return np.asarray(mbs.GetObjectOutput(joint, Variable.Position)), stored[0, 1:], stored[-1, 1:]


# Mean of a thousand steps. Euler parameters drift off unit length in each, and are brought back.
ERRORS = {exu.NodeType.RotationEulerParameters: 6.71e-7, exu.NodeType.RotationRxyz: 1.18e-5}


@pytest.mark.parametrize("node", ERRORS, ids=str)
def test_contact_point_after_half_a_second(node: exu.NodeType) -> None:
    """The trapezoidal rule is of second order: errors are as stated within 2 % and fall to a quarter."""
    errors = [np.linalg.norm(rolled(steps, node)[0] - exact()[0]) for steps in (1000, 2000)]
    np.testing.assert_allclose(errors[0], ERRORS[node], rtol=0.02)
    np.testing.assert_allclose(errors[0] / errors[1], 4, rtol=0.01)


@pytest.mark.parametrize("node", ERRORS, ids=str)
def test_contact_force(node: exu.NodeType) -> None:
    """Accuracy at the start is that of differences. The trapezoidal rule has no damping: forces that began with an
    error would
    swing for ever."""
    results = [rolled(steps, node) for steps in (1000, 2000)]
    for _, start, _ in results:
        np.testing.assert_allclose(start, contact(START)[1], rtol=0, atol=1e-6)
    errors = [np.linalg.norm(end - exact()[1]) for _, _, end in results]
    np.testing.assert_allclose(errors[0] / errors[1], 4, rtol=0.02)
    assert 1e-5 < errors[0] < 1e-2
