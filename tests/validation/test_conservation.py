"""Energy and momentum of closed systems over many steps."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from solving import Solver, Variable, new_system, settings

import dalembert as exu

MASSES, STIFFNESS, LENGTH = (1.5, 2.0, 1.2), 50.0, 0.8
INERTIA = ([1.0, 2.0, 3.0], [0.5, 0.8, 0.9], [1.0, 1.5, 0.7])
ARMS = ([0.3, 0.2, -0.1], [-0.2, 0.4, 0.1])


class Chain:
    """Three rigid bodies in space, free to fly, with springs or spherical joints between them."""

    def __init__(self, node_type: str, joints: bool = False, damping: float = 0.0) -> None:
        self.mbs = new_system()
        self.bodies: list[Any] = []
        rng = np.random.default_rng(5)
        position = np.zeros(3)
        drift, spin = rng.normal(size=3), rng.normal(size=3)
        for mass, inertia in zip(MASSES, INERTIA, strict=True):
            velocity = drift + np.cross(spin, position) if joints else rng.normal(size=3)
            omega = spin if joints else rng.normal(size=3)
            rates = [0, *(0.5 * omega)] if node_type == "NodeRigidBodyEP" else omega
            turn = [1, 0, 0, 0] if node_type == "NodeRigidBodyEP" else [0, 0, 0]
            node = self.mbs.AddNode(
                getattr(exu, node_type)(referenceCoordinates=[*position, *turn], initialVelocities=[*velocity, *rates])
            )
            rows = {"physicsInertia": [*inertia, 0, 0, 0]}
            self.bodies.append(self.mbs.AddObject(exu.RigidBody(physicsMass=mass, nodeNumber=node, **rows)))
            position = position + np.array(ARMS[0]) - np.array(ARMS[1])
        for one, other in zip(self.bodies[:-1], self.bodies[1:], strict=True):
            ends = [
                self.mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=b, localPosition=a))
                for b, a in zip((one, other), ARMS, strict=True)
            ]
            if joints:
                self.mbs.AddObject(exu.SphericalJoint(markerNumbers=ends))
            else:
                ends = [ends[0], self.mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=other))]
                self.mbs.AddObject(
                    exu.SpringDamper(markerNumbers=ends, stiffness=STIFFNESS, referenceLength=LENGTH, damping=damping)
                )
        self.mbs.Assemble()

    def told(self, body: Any, variable: Any) -> np.ndarray:
        return self.mbs.GetObjectOutputBody(body, variable, [0, 0, 0])

    def momentum(self) -> np.ndarray:
        """Linear, and angular about the origin."""
        linear, angular = np.zeros(3), np.zeros(3)
        for body, mass, inertia in zip(self.bodies, MASSES, INERTIA, strict=True):
            p = mass * self.told(body, Variable.Velocity)
            turn = self.told(body, Variable.RotationMatrix).reshape(3, 3)
            linear += p
            angular += np.cross(self.told(body, Variable.Position), p)
            angular += turn @ np.diag(inertia) @ turn.T @ self.told(body, Variable.AngularVelocity)
        return np.concatenate([linear, angular])

    def energy(self) -> float:
        total = 0.0
        for body, mass, inertia in zip(self.bodies, MASSES, INERTIA, strict=True):
            omega = self.told(body, Variable.AngularVelocityLocal)
            total += 0.5 * mass * np.sum(self.told(body, Variable.Velocity) ** 2) + 0.5 * np.array(inertia) @ omega**2
        for number in range(self.mbs.systemData.NumberOfObjects()):
            if self.mbs.GetObject(number)["objectType"] == "ConnectorSpringDamper":
                total += 0.5 * STIFFNESS * (self.mbs.GetObjectOutput(number, Variable.Distance) - LENGTH) ** 2
        return float(total)


NODES = ["NodeRigidBodyEP", "NodeRigidBodyRxyz", "NodeRigidBodyRotVecLG"]


@pytest.mark.parametrize("node_type", NODES[1:])
def test_springs_keep_energy_and_momentum(node_type: str) -> None:
    """RK67 with steps of 2.5 ms: errors of sixth order are some 1e-11 after two seconds, rounding 1e-13."""
    chain = Chain(node_type)
    before = chain.energy(), chain.momentum()
    chain.mbs.SolveDynamic(settings(2.0, 800), solverType=Solver.RK67)
    assert chain.energy() == pytest.approx(before[0], rel=1e-9)
    np.testing.assert_allclose(chain.momentum(), before[1], rtol=0, atol=1e-9)
    assert np.abs(before[1]).max() > 1


@pytest.mark.parametrize("node_type", NODES[1:])
def test_dampers_keep_momentum_and_take_energy(node_type: str) -> None:
    chain = Chain(node_type, damping=2.0)
    before = chain.energy(), chain.momentum()
    chain.mbs.SolveDynamic(settings(2.0, 800), solverType=Solver.RK67)
    assert 0.2 * before[0] < chain.energy() < 0.98 * before[0]
    np.testing.assert_allclose(chain.momentum(), before[1], rtol=0, atol=1e-9)


@pytest.mark.parametrize("node_type", NODES)
@pytest.mark.parametrize("joints", [False, True], ids=["springs", "joints"])
def test_implicit(node_type: str, joints: bool) -> None:
    """Linear momentum to rounding; angular momentum and energy with the second order of the method: a quarter of the drift with
    half the step."""
    drifts = []
    for steps in (1000, 2000):
        chain = Chain(node_type, joints)
        before = chain.energy(), chain.momentum()
        chain.mbs.SolveDynamic(settings(1.0, steps, spectral_radius=0.8, tolerance=1e-12))
        np.testing.assert_allclose(chain.momentum()[:3], before[1][:3], rtol=0, atol=1e-12)
        drifts.append([abs(chain.energy() - before[0]), np.linalg.norm(chain.momentum()[3:] - before[1][3:])])
    coarse, fine = np.array(drifts)
    assert np.all((fine > 1e-9) & (fine < 1e-5))
    np.testing.assert_allclose(fine, coarse / 4, rtol=0.1)


def test_joints_stay_closed() -> None:
    """Position constraints are met in every step, to the tolerance of Newton's method."""
    chain = Chain("NodeRigidBodyRotVecLG", joints=True)
    chain.mbs.SolveDynamic(settings(1.0, 500, spectral_radius=0.8))
    ends = [chain.mbs.GetMarkerOutput(i, Variable.Position) for i in range(4)]
    np.testing.assert_allclose(ends[0], ends[1], rtol=0, atol=1e-9)
    np.testing.assert_allclose(ends[2], ends[3], rtol=0, atol=1e-9)
    turn = chain.told(chain.bodies[0], Variable.RotationMatrix).reshape(3, 3)
    assert Rotation.from_matrix(turn).magnitude() > 0.1
