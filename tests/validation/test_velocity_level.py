"""Joints whose velocities are constrained, on bodies that spin fast. Euler parameters leave unit length there, by the square of the step
times the change of the spin, and their matrix would be no rotation any more: axes would tilt, and joints turn that into motion."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from solving import Solver, Variable, new_system, settings

import dalembert as exu
from dalembert.rigidBodyUtilities import RigidBodyInertia

EULER, VECTOR = exu.NodeType.RotationEulerParameters, exu.NodeType.RotationRotationVector
QUARTER = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])  # turns x to y
Z_TO_Y = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])  # columns: joint axes whose third is y
SPIN = 60.0  # rad/s


def generic(*rotations: int) -> Callable[..., Any]:
    """Locked translations and these locked rotations about x, y and z."""

    def make(markers: list[Any], turns: list[np.ndarray]) -> Any:
        return exu.GenericJoint(
            markerNumbers=markers,
            constrainedAxes=[1, 1, 1, *rotations],
            rotationMarker0=turns[0],
            rotationMarker1=turns[1],
        )

    return make


def turned(item: Any, axes: np.ndarray) -> Callable[..., Any]:
    """A joint whose own axes are these columns."""

    def make(markers: list[Any], turns: list[np.ndarray]) -> Any:
        return item(markerNumbers=markers, rotationMarker0=turns[0] @ axes, rotationMarker1=turns[1] @ axes)

    return make


def spherical(markers: list[Any], _: list[np.ndarray]) -> Any:
    return exu.SphericalJoint(markerNumbers=markers)


HINGES = {"generic": generic(1, 0, 1), "revolute z": turned(exu.ObjectJointRevoluteZ, Z_TO_Y)}
# The wheel turns about y against its carrier, or with it.
LOOSE = HINGES | {
    "one locked rotation": generic(1, 0, 0),
    "another locked rotation": generic(0, 0, 1),
    "no locked rotation": generic(0, 0, 0),
    "spherical": spherical,
}
TIGHT = {
    "three locked rotations": generic(1, 1, 1),
    "two others": generic(1, 1, 0),
    "locked spin": generic(0, 1, 0),
    "prismatic": turned(exu.ObjectJointPrismaticX, QUARTER),
}


def body(mbs: Any, node: Any, turn: np.ndarray, mass: float, moments: list[float], **motion: Any) -> Any:
    inertia = RigidBodyInertia(mass, np.diag(moments))
    return mbs.CreateRigidBody(referenceRotationMatrix=turn, inertia=inertia, nodeType=node, **motion)


def connect(mbs: Any, joint: Callable[..., Any], ends: list[tuple[Any, Any, np.ndarray]]) -> list[Any]:
    """The joint between bodies at local positions; rotations turn global axes to those of the bodies. Returns its markers."""
    markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=b, localPosition=p)) for b, p, _ in ends]
    mbs.AddObject(joint(markers, [turn for *_, turn in ends]))
    return markers


each_order = pytest.mark.parametrize("wheel_first", [True, False], ids=["wheel first", "wheel second"])


def driven_wheel(joint: Callable[..., Any], wheel_first: bool, steps: int) -> tuple[np.ndarray, np.ndarray]:
    """A wheel on an axle along y that rests, driven from rest by 3 Nm for half a second: its rotation and angular velocity."""
    mbs = new_system()
    wheel = body(mbs, EULER, QUARTER, 2.0, [0.02, 0.012, 0.012])
    ends = [(wheel, [0, 0, 0], QUARTER.T), (mbs.CreateGround(), [0, 0, 0], np.eye(3))]
    connect(mbs, joint, ends if wheel_first else ends[::-1])
    drive = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=wheel))
    mbs.AddLoad(exu.LoadTorqueVector(markerNumber=drive, loadVector=[0, 3.0, 0]))
    mbs.Assemble()
    mbs.SolveDynamic(settings(0.5, steps, tolerance=1e-12), solverType=Solver.TrapezoidalIndex2)
    turn = np.reshape(mbs.GetObjectOutputBody(wheel, Variable.RotationMatrix), (3, 3))
    return turn, np.asarray(mbs.GetObjectOutputBody(wheel, Variable.AngularVelocity))


@each_order
@pytest.mark.parametrize("joint", HINGES.values(), ids=HINGES)
def test_wheel_on_an_axle_that_rests(joint: Callable[..., Any], wheel_first: bool) -> None:
    """Its axis, the first, stays along y but for a third-order error, and its speed is T t / J = 75 rad/s. If
    parameters drift to 1.8e-4 from unit length, the axis rotates by 3e-3 rad with 500 steps, and by a quarter of that
    with 1000."""
    tilts = []
    for steps in (500, 1000):
        turn, speed = driven_wheel(joint, wheel_first, steps)
        np.testing.assert_allclose(turn @ turn.T, np.eye(3), rtol=0, atol=1e-13)
        np.testing.assert_allclose(speed, [0, 75, 0], rtol=0, atol=0.01)
        tilts.append(np.linalg.norm(turn[:, 0] - [0, 1, 0]))
    assert tilts[0] < 3e-5
    assert tilts[1] < max(tilts[0] / 7, 1e-9)


def gyroscope(joint: Callable[..., Any], wheel_first: bool, carrier_spin: float, node: Any, steps: int) -> np.ndarray:
    """A carrier on a ball and a wheel at its end, which gravity and a torque on the wheel move: place and axes of the wheel."""
    mbs = new_system()
    gravity, arm = [0, 0, -9.81], np.array([0, 0.2, 0])
    carrier = body(
        mbs,
        node,
        np.eye(3),
        1.0,
        [0.02, 0.01, 0.02],
        referencePosition=arm / 2,
        gravity=gravity,
        initialAngularVelocity=[0, carrier_spin, 0],
    )
    wheel = body(
        mbs,
        node,
        QUARTER,
        2.0,
        [0.02, 0.012, 0.012],
        referencePosition=arm,
        gravity=gravity,
        initialAngularVelocity=[0, SPIN, 0],
    )
    connect(mbs, spherical, [(mbs.CreateGround(), [0, 0, 0], np.eye(3)), (carrier, -arm / 2, np.eye(3))])
    ends = [(wheel, [0, 0, 0], QUARTER.T), (carrier, arm / 2, np.eye(3))]
    connect(mbs, joint, ends if wheel_first else ends[::-1])
    drive = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=wheel))
    mbs.AddLoad(exu.LoadTorqueVector(markerNumber=drive, bodyFixed=True, loadVector=[2.0, 0, 0]))
    mbs.Assemble()
    mbs.SolveDynamic(settings(0.2, steps, tolerance=1e-11), solverType=Solver.TrapezoidalIndex2)
    turn = np.reshape(mbs.GetObjectOutputBody(wheel, Variable.RotationMatrix), (3, 3))
    return np.concatenate([mbs.GetObjectOutputBody(wheel, Variable.Position), turn[:, 0]])


@each_order
@pytest.mark.parametrize("name", [*LOOSE, *TIGHT])
def test_driven_gyroscope(name: str, wheel_first: bool) -> None:
    """Errors with Euler parameters and with rotation vectors are of one size; they would be up to 130 times as large with parameters that
    are left to drift. The reference has a sixteenth of the error, and both kinds of nodes tend to it."""
    joint, carrier_spin = (LOOSE[name], 0.0) if name in LOOSE else (TIGHT[name], SPIN)
    exact = gyroscope(joint, wheel_first, carrier_spin, VECTOR, 800)
    of_euler, of_vector, of_fine_euler = (
        np.linalg.norm(gyroscope(joint, wheel_first, carrier_spin, node, steps) - exact)
        for node, steps in ((EULER, 200), (VECTOR, 200), (EULER, 400))
    )
    assert of_euler < 8 * of_vector
    assert of_fine_euler < 0.35 * of_euler


@pytest.mark.parametrize("steps", [2000, 4000])
def test_rotor_that_runs_up(steps: int) -> None:
    """Constant torque about a fixed axis, 20 s, 711 revolutions: angle and speed are those of uniform acceleration.

    Euler parameters are divided by their length l after each step. Rates divided by l instead of its square would lose speed in each step: 1e-3 of the values below.
    """
    mass, torque, end = 2.0, 0.2, 20.0
    inertia = RigidBodyInertia(mass=mass, inertiaTensor=np.diag([0.5, 0.25 + 1 / 150, 0.25 + 1 / 150]) * mass * 0.5625)
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    rotor = mbs.CreateRigidBody(inertia=inertia)
    for x, stiffness in ((-0.5, [800, 800, 800]), (0.5, [0, 800, 800])):
        mbs.CreateCartesianSpringDamper(
            bodyNumbers=[ground, rotor], localPosition0=[x, 0, 0], localPosition1=[x, 0, 0], stiffness=stiffness
        )
    mbs.CreateTorque(bodyNumber=rotor, loadVector=[torque, 0, 0])
    parameters = mbs.AddSensor(
        exu.SensorBody(bodyNumber=rotor, outputVariableType=Variable.Rotation, storeInternal=True)
    )
    mbs.Assemble()
    s = settings(end, steps)
    s.solutionSettings.sensorsWritePeriod = end / steps
    mbs.SolveDynamic(s, solverType=exu.DynamicSolverType.TrapezoidalIndex2)
    angle = np.unwrap(mbs.GetSensorStoredData(parameters)[:, 1])[-1]
    speed = mbs.GetObjectOutputBody(rotor, Variable.AngularVelocity, localPosition=[0, 0, 0])[0]
    acceleration = torque / (0.5 * mass * 0.5625)
    assert angle - 0.5 * acceleration * end**2 == pytest.approx(
        -9.358e-4 * (4000 / steps) ** 2, rel=0.01
    )  # published for 4000 steps
    assert abs(speed - acceleration * end) < 2e-6 * (4000 / steps) ** 2
