"""The bicycle of the benchmark by Meijaard, Papadopoulos, Ruina and Schwab (2007): four rigid bodies on two rolling discs."""

from __future__ import annotations

from typing import Any

import numpy as np
from solving import Solver, Variable, new_system, settings

import dalembert as exu
from dalembert.rigidBodyUtilities import RigidBodyInertia

GRAVITY, TILT, BASE, TRAIL = 9.81, np.pi / 10, 1.02, 0.08
# Data of the paper, with x forward and z upward: place of the centre of mass, mass, inertia xx, yy, zz, xz.
REAR, FRONT = 0.3, 0.35
BODIES = {
    "rear wheel": ((0, REAR), 2, (0.0603, 0.12, 0.0603, 0)),
    "frame": ((0.3, 0.9), 85, (9.2, 11, 2.8, -2.4)),
    "fork": ((0.9, 0.7), 4, (0.05892, 0.06, 0.00708, 0.00756)),
    "front wheel": ((BASE, FRONT), 3, (0.1405, 0.28, 0.1405, 0)),
}
STEERING = np.array([-np.sin(TILT), 0, np.cos(TILT)])


class Bicycle:
    """Upright, with a forward speed and a rate of roll about the line of contact."""

    def __init__(self, speed: float, roll_rate: float) -> None:
        self.mbs, self.bodies = new_system(), {}
        ground = self.mbs.CreateGround()
        for name, ((x, z), mass, (xx, yy, zz, xz)) in BODIES.items():
            spin = {"rear wheel": speed / REAR, "front wheel": speed / FRONT}.get(name, 0.0)
            tensor = np.array([[xx, 0, xz], [0, yy, 0], [xz, 0, zz]])
            self.bodies[name] = self.mbs.CreateRigidBody(
                referencePosition=[x, 0, z],
                initialVelocity=[speed, -roll_rate * z, 0],
                initialAngularVelocity=[roll_rate, spin, 0],
                inertia=RigidBodyInertia(mass, tensor),
                gravity=[0, 0, -GRAVITY],
            )
        rear, frame, fork, front = self.bodies.values()
        self.mbs.CreateRevoluteJoint(bodyNumbers=[frame, rear], position=[0, 0, REAR], axis=[0, 1, 0])
        self.mbs.CreateRevoluteJoint(bodyNumbers=[fork, front], position=[BASE, 0, FRONT], axis=[0, 1, 0])
        head = np.array([BASE + TRAIL, 0, 0]) + STEERING
        self.head = self.mbs.CreateRevoluteJoint(bodyNumbers=[frame, fork], position=head, axis=STEERING)
        for wheel, radius in ((rear, REAR), (front, FRONT)):
            self.mbs.CreateRollingDisc(
                bodyNumbers=[ground, wheel], axisPosition=[0, 0, 0], axisVector=[0, 1, 0], discRadius=radius
            )
        self.sensors = [
            self.body_sensor("frame", Variable.Rotation),
            self.joint_sensor(Variable.Rotation),
            self.body_sensor("frame", Variable.AngularVelocityLocal),
            self.joint_sensor(Variable.AngularVelocityLocal),
        ]
        self.motions = [
            [self.body_sensor(name, v) for v in (Variable.Position, Variable.Velocity, Variable.AngularVelocityLocal)]
            for name in BODIES
        ]
        self.mbs.Assemble()

    def body_sensor(self, name: str, variable: Any) -> Any:
        sensor = exu.SensorBody(bodyNumber=self.bodies[name], outputVariableType=variable, storeInternal=True)
        return self.mbs.AddSensor(sensor)

    def joint_sensor(self, variable: Any) -> Any:
        sensor = exu.SensorObject(objectNumber=self.head, outputVariableType=variable, storeInternal=True)
        return self.mbs.AddSensor(sensor)

    def ride(self, end: float, steps: int) -> None:
        s = settings(end, steps, tolerance=1e-12)
        s.solutionSettings.sensorsWritePeriod = end / steps
        self.mbs.SolveDynamic(s, solverType=Solver.TrapezoidalIndex2)

    def values(self, sensor: Any) -> np.ndarray:
        return np.asarray(self.mbs.GetSensorStoredData(sensor)[:, 1:])

    def lean_and_steer(self) -> np.ndarray:
        """Rows of lean and steer angle, and their rates, for small angles."""
        lean, steer, lean_rate, steer_rate = (self.values(sensor) for sensor in self.sensors)
        return np.column_stack([lean[:, 0], steer[:, 2], lean_rate[:, 0], steer_rate[:, 2]])

    def energy(self) -> np.ndarray:
        total = 0.0
        for (_, mass, (xx, yy, zz, xz)), sensors in zip(BODIES.values(), self.motions, strict=True):
            place, velocity, (x, y, z) = (self.values(sensor).T for sensor in sensors)
            total += mass * (GRAVITY * place[2] + (velocity**2).sum(axis=0) / 2)
            total += (xx * x**2 + yy * y**2 + zz * z**2 + 2 * xz * x * z) / 2
        return np.asarray(total)


def eigenvalues(speed: float, steps: int = 240, period: float = 0.06, samples: int = 8) -> np.ndarray:
    """Eigenvalues of small motions about straight running: those of the map of lean, steer and their rates over a
    period of some steps."""
    bicycle = Bicycle(speed, 1e-3)
    bicycle.ride(period * samples, steps * samples)
    states = bicycle.lean_and_steer()[::steps]
    scaled = states / np.abs(states).max(axis=0)
    flow = np.linalg.lstsq(scaled[:-1], scaled[1:], rcond=None)[0]
    values = np.log(np.linalg.eigvals(flow).astype(complex)) / period
    return np.asarray(np.sort_complex(values))
