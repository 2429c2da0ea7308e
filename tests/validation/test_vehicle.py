"""A car with steered front wheels on four rolling discs without slip: it has one degree of freedom, with constant inertia."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from solving import Solver, Variable, new_system, settings

import dalembert as exu
from dalembert.rigidBodyUtilities import InertiaCuboid, InertiaCylinder, RotationMatrixZ

BASE, TRACK, HEIGHT, RADIUS = 2.6, 1.5, 0.55, 0.3
BODY = InertiaCuboid(density=1200 / (3.6 * 1.6 * 1.2), sideLengths=[3.6, 1.6, 1.2])
WHEEL = InertiaCylinder(density=20 / (np.pi * RADIUS**2 * 0.2), length=0.2, outerRadius=RADIUS, axis=1)
CIRCLE, SPEED, TORQUE, END = (
    12.0,
    2.0,
    250.0,
    3.0,
)  # radius and speed of the middle of the rear axle; torque at each rear wheel
PLACES = np.array(
    [[BASE, TRACK / 2], [BASE, -TRACK / 2], [0, TRACK / 2], [0, -TRACK / 2]]
)  # of the wheels, from that middle
CENTRE = np.array([0, CIRCLE])


def radii() -> np.ndarray:
    """Distances of the wheels from the centre of their circles."""
    return np.asarray(np.linalg.norm(PLACES - CENTRE, axis=1))


def acceleration() -> float:
    """Acceleration of the middle of the rear axle, from the power of the torques: the inertia per its speed does not
    change."""
    yaw = 1 / CIRCLE
    body = BODY.mass * ((BASE / 2) ** 2 + CIRCLE**2) + BODY.inertiaTensor[2, 2]
    around = WHEEL.mass * radii() ** 2 + WHEEL.inertiaTensor[0, 0] + WHEEL.inertiaTensor[1, 1] * (radii() / RADIUS) ** 2
    power = TORQUE * yaw * (radii()[2:] / RADIUS).sum()
    return float(power / (yaw**2 * (body + around.sum())))


def yaw_angle() -> float:
    return (SPEED * END + acceleration() * END**2 / 2) / CIRCLE


class Car:
    """Redundant conditions are left out: one wheel per axle prevents sideways sliding, three wheels carry it."""

    FLAGS = ([1, 1, 1], [0, 1, 1], [1, 1, 1], [0, 1, 0])  # lateral, forward, normal

    def __init__(self) -> None:
        self.mbs = new_system()
        ground = self.mbs.CreateGround()
        self.body = self.rigid(BODY, np.array([BASE / 2, 0, HEIGHT]), 0.0, 0.0)
        self.contacts = []
        for (x, y), radius, flags in zip(PLACES, radii(), self.FLAGS, strict=True):
            steer = np.arctan2(x, CIRCLE - y)
            wheel = self.rigid(WHEEL, np.array([x, y, RADIUS]), steer, SPEED / CIRCLE * radius / RADIUS)
            axis = RotationMatrixZ(steer) @ [0, 1, 0]
            self.mbs.CreateRevoluteJoint(bodyNumbers=[self.body, wheel], position=[x, y, RADIUS], axis=axis)
            if x == 0:
                for turned, sign in ((wheel, 1), (self.body, -1)):
                    marker = self.mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=turned))
                    self.mbs.AddLoad(exu.Torque(markerNumber=marker, loadVector=[0, sign * TORQUE, 0], bodyFixed=True))
            rolling = {
                "axisPosition": [0, 0, 0],
                "axisVector": [0, 1, 0],
                "discRadius": RADIUS,
                "constrainedAxes": flags,
            }
            self.contacts.append(self.mbs.CreateRollingDisc(bodyNumbers=[ground, wheel], **rolling))
        self.mbs.Assemble()

    def rigid(self, inertia: Any, place: np.ndarray, turn: float, spin: float) -> Any:
        yaw = np.array([0, 0, SPEED / CIRCLE])
        axes = RotationMatrixZ(turn)
        return self.mbs.CreateRigidBody(
            referencePosition=place,
            referenceRotationMatrix=axes,
            initialVelocity=np.cross(yaw, place - [*CENTRE, 0]),
            initialAngularVelocity=yaw + axes @ [0, spin, 0],
            inertia=inertia,
            gravity=[0, 0, -9.81],
        )

    def output(self, variable: Any) -> np.ndarray:
        """Motion of the middle of the rear axle."""
        return np.asarray(self.mbs.GetObjectOutputBody(self.body, variable, [-BASE / 2, 0, 0]))


@pytest.fixture(scope="module")
def car() -> Car:
    car = Car()
    car.mbs.SolveDynamic(settings(END, 1500), solverType=Solver.TrapezoidalIndex2)
    return car


def test_one_degree_of_freedom() -> None:
    counts = Car().mbs.ComputeSystemDegreeOfFreedom()
    assert (counts["degreeOfFreedom"], counts["redundantConstraints"]) == (1, 0)


def test_speed_and_place(car: Car) -> None:
    """Second order: the wheels rotate by 0.04 rad in a step of 2 ms at the end, which gives an error of 0.04^2 / 12 =
    1e-4 of angles."""
    speed, turned = SPEED + acceleration() * END, yaw_angle()
    assert 1e-7 < np.linalg.norm(car.output(Variable.VelocityLocal) - [speed, 0, 0]) < 1e-4
    place = CIRCLE * np.array([np.sin(turned), 1 - np.cos(turned), 0])
    assert 1e-7 < np.linalg.norm((car.output(Variable.Position) - place)[:2]) < 1e-4


def test_forces(car: Car) -> None:
    """Contact forces carry the weight, and accelerate the centre of mass along its circle; 1e-5 of 3000 N is the error of the angle."""
    total = np.zeros(3)
    for contact in car.contacts:
        axes = car.mbs.GetObjectOutput(contact, Variable.RotationMatrix).reshape(3, 3)
        total += axes @ car.mbs.GetObjectOutput(contact, Variable.ForceLocal)
    mass = BODY.mass + 4 * WHEEL.mass
    centre = mass * np.array([BASE / 2, -CIRCLE])  # all centres of mass lie symmetrically about that of the body
    speed = SPEED + acceleration() * END
    yaw, yaw_rate = speed / CIRCLE, acceleration() / CIRCLE
    wanted = [*(yaw_rate * np.array([-centre[1], centre[0]]) - yaw**2 * centre), mass * 9.81]
    np.testing.assert_allclose(total, RotationMatrixZ(yaw_angle()) @ wanted, rtol=0, atol=0.2)
