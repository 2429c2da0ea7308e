"""Andrews' squeezing mechanism, a stiff planar seven-body mechanism (Schiehlen 1990; Hairer and Wanner, Solving ODE II, ch. VII.7)."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from solving import Variable, new_system, orders, settings

import dalembert as exu

MASS = [0.04325, 0.00365, 0.02373, 0.00706, 0.07050, 0.00706, 0.05498]
INERTIA = [2.194e-6, 4.410e-7, 5.255e-6, 5.667e-7, 1.169e-5, 5.667e-7, 1.912e-5]
A, B, C = np.array([-0.06934, -0.00227]), np.array([-0.03635, 0.03273]), np.array([0.014, 0.072])
D, DA, E, EA, ZF, FA, RR, RA = 28e-3, 115e-4, 2e-2, 1421e-5, 2e-2, 1421e-5, 7e-3, 92e-5
SS, SA, SB, SC, SD, TA, TB = 35e-3, 1874e-5, 1043e-5, 18e-3, 2e-2, 2308e-5, 916e-5
U, UA, UB, ZT = 4e-2, 1228e-5, 449e-5, 4e-2
STIFFNESS, LENGTH, MOMENT = 4530, 0.07785, 0.033
START = [-0.0617138900142764496, 0, 0.455279819163070380, 0.222668390165885885,
         0.487364979543842550, -0.222668390165885885, 1.23054744454982119]  # fmt: skip
END = [15.81077119629904, -15.75637105984298, 0.04082224013073101, -0.5347301163226948,
       0.5244099658805304, 0.5347301163226948, 1.048080741042263]  # fmt: skip
# Centres of mass in the axes of each body, from its first joint: O, the common point P, B, P, A, P, A.
CENTRES = [(RA, 0), (D - DA, 0), (SB, -SA), (0, EA), (TA, TB), (-FA, 0), (-UB, -UA)]


def angles(q: Any) -> np.ndarray:
    """Data of the bodies, from those of the book: some are relative."""
    beta, theta, gamma, phi, delta, omega, epsilon = q
    return np.array([beta, beta + theta, gamma, phi + delta, delta, omega + epsilon, epsilon])


class Squeezer:
    """Seven bodies and ten revolute joints, three of them at P."""

    def __init__(self) -> None:
        self.mbs = new_system()
        turn = angles(START)
        axes = [np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]]) for a in turn]
        crank = axes[0] @ [RR, 0]
        p = crank - axes[1] @ [D, 0]
        first = [np.zeros(2), p, B, p, A, p, A]
        self.frames = [(x + axis @ np.array(c), axis) for x, axis, c in zip(first, axes, CENTRES, strict=True)]
        self.ground = self.mbs.AddObject(exu.ObjectGround())
        self.nodes, self.bodies = [], []
        for (centre, _), angle, mass, inertia in zip(self.frames, turn, MASS, INERTIA, strict=True):
            self.nodes.append(self.mbs.AddNode(exu.NodeRigidBody2D(referenceCoordinates=[*centre, angle])))
            row = {"physicsMass": mass, "physicsInertia": inertia, "nodeNumber": self.nodes[-1]}
            self.bodies.append(self.mbs.AddObject(exu.RigidBody2D(**row)))
        end5, end7 = A + axes[4] @ [ZT, 0], A + axes[6] @ [0, -U]
        joints = [(None, 0, np.zeros(2)), (0, 1, crank), (1, 2, p), (1, 3, p), (1, 5, p), (None, 2, B)]
        joints += [(3, 4, end5), (None, 4, A), (5, 6, end7), (None, 6, A)]
        for one, other, point in joints:
            self.mbs.AddObject(exu.RevoluteJoint2D(markerNumbers=[self.marker(one, point), self.marker(other, point)]))
        ends = [self.marker(None, C), self.marker(2, B + axes[2] @ [SD, -SC])]
        self.mbs.AddObject(exu.SpringDamper(markerNumbers=ends, stiffness=STIFFNESS, referenceLength=LENGTH))
        drive = self.mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=self.nodes[0], coordinate=2))
        self.mbs.AddLoad(exu.LoadCoordinate(markerNumber=drive, load=MOMENT))
        self.mbs.Assemble()

    def marker(self, body: int | None, point: np.ndarray) -> Any:
        """Force at a global point."""
        if body is None:
            return self.mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=self.ground, localPosition=[*point, 0]))
        position, axes = self.frames[body]
        local = [*(axes.T @ (point - position)), 0]
        return self.mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=self.bodies[body], localPosition=local))

    def angles(self) -> np.ndarray:
        return np.array([self.mbs.GetNodeOutput(node, Variable.CoordinatesTotal)[2] for node in self.nodes])


def final(steps: int) -> np.ndarray:
    squeezer = Squeezer()
    squeezer.mbs.SolveDynamic(settings(0.03, steps, tolerance=1e-12))
    return squeezer.angles()


def test_the_mechanism_is_closed() -> None:
    """Start values of the book meet the constraints to their last digit."""
    squeezer = Squeezer()
    for i in range(10):
        joint = squeezer.mbs.GetObject(8 + i)
        ends = [squeezer.mbs.GetMarkerOutput(m, Variable.Position) for m in joint["markerNumbers"]]
        np.testing.assert_allclose(ends[0], ends[1], rtol=0, atol=1e-16 * 100)


def test_reference_solution() -> None:
    """Second order; the crank makes 15.8 rad in 30 ms, up to 0.01 rad in a step of 7.5 us: (0.01)^2 / 12 per radian."""
    errors = {steps: np.abs(final(steps) - angles(END)) for steps in (1000, 2000, 4000)}
    for order in orders(lambda n: errors[n], [1000, 2000, 4000]):
        assert order == pytest.approx(2, abs=0.05)
    assert 1e-5 < errors[4000].max() < 2e-4
