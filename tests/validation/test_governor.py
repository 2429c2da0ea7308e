"""Flyball governor with stiff spring-dampers between slider and rods: a spatial closed loop, without joints to close it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from governor_reference import (
    ANGLE,
    CUBE,
    DAMPING,
    FREE,
    GRAVITY,
    HINGE,
    LENGTH,
    OMEGA,
    START,
    STIFFNESS,
    TIP,
    WIDTH,
    block,
    heights_of_slider,
)
from scipy.spatial.transform import Rotation
from solving import Variable, new_system, self_orders, settings

import dalembert as exu


class Governor:
    def __init__(self, node_type: str) -> None:
        self.mbs, self.node_type = new_system(), node_type
        self.ground = self.mbs.AddObject(exu.ObjectGround())
        shaft = self.body([0, 0, LENGTH / 2], np.eye(3), *block([WIDTH, WIDTH, LENGTH]))
        slider = self.body([0, 0, START], np.eye(3), *block([CUBE, CUBE, CUBE]))
        self.slider = slider
        self.join([1, 1, 1, 1, 1, 0], (self.ground, [0, 0, 0]), (shaft, [0, 0, -LENGTH / 2]))
        self.join([1, 1, 0, 1, 1, 1], (shaft, [0, 0, 0]), (slider, [0, 0, 0]))
        for side in (1, -1):
            turn = Rotation.from_euler("Y", ANGLE if side > 0 else np.pi - ANGLE).as_matrix()
            rod = self.rod(side, turn)
            hinge = np.array([side * HINGE, 0, LENGTH / 2])
            self.join([1, 1, 1, 1, 0, 1], (shaft, hinge), (rod, [-LENGTH / 2, 0, 0]), turn.T)
            ends = [self.marker(slider, [side * HINGE, 0, 0]), self.marker(rod, [0, 0, 0])]
            self.mbs.AddObject(
                exu.SpringDamper(markerNumbers=ends, stiffness=STIFFNESS, damping=DAMPING, referenceLength=FREE)
            )
        self.mbs.Assemble()

    def rod(self, side: int, turn: np.ndarray) -> Any:
        """A rod with a tip mass; the body's point is the middle of the rod, not its centre of mass."""
        mass, inertia = block([LENGTH, WIDTH, WIDTH])
        inertia += TIP * (LENGTH / 2) ** 2 * np.array([0, 1, 1])
        middle = np.array([side * HINGE, 0, LENGTH]) + turn @ [LENGTH / 2, 0, 0]
        return self.body(middle, turn, mass + TIP, inertia, [TIP * LENGTH / 2 / (mass + TIP), 0, 0])

    def body(self, position: Any, turn: np.ndarray, mass: float, inertia: np.ndarray, centre: Any = (0, 0, 0)) -> Any:
        """Motion in a rotation about the shaft."""
        omega = turn.T @ [0, 0, OMEGA]
        r = Rotation.from_matrix(turn)
        if self.node_type == "NodeRigidBodyEP":
            p = r.as_quat()[[3, 0, 1, 2]]
            rotation, rates = p, 0.5 * np.array([-p[1:] @ omega, *(p[0] * omega + np.cross(p[1:], omega))])
        else:
            rotation, rates = r.as_rotvec(), omega
        velocity = np.cross([0, 0, OMEGA], position)
        node = self.mbs.AddNode(
            getattr(exu, self.node_type)(
                referenceCoordinates=[*position, *rotation], initialVelocities=[*velocity, *rates]
            )
        )
        rows = {"physicsInertia": [*inertia, 0, 0, 0], "physicsCenterOfMass": centre}
        body = self.mbs.AddObject(exu.RigidBody(physicsMass=mass, nodeNumber=node, **rows))
        load = self.mbs.AddMarker(exu.MarkerBodyMass(bodyNumber=body))
        self.mbs.AddLoad(exu.Gravity(markerNumber=load, loadVector=[0, 0, -GRAVITY]))
        return body

    def marker(self, body: Any, local: Any) -> Any:
        return self.mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body, localPosition=local))

    def join(self, axes: list[int], one: Any, other: Any, turn: np.ndarray | None = None) -> None:
        markers = [self.marker(*one), self.marker(*other)]
        turns = {} if turn is None else {"rotationMarker1": turn}
        self.mbs.AddObject(exu.GenericJoint(markerNumbers=markers, constrainedAxes=axes, **turns))

    def height(self) -> float:
        return float(self.mbs.GetObjectOutputBody(self.slider, Variable.Position, [0, 0, 0])[2])


def final(node_type: str, end: float, steps: int) -> float:
    governor = Governor(node_type)
    governor.mbs.SolveDynamic(settings(end, steps, spectral_radius=0.6))
    return governor.height()


@pytest.mark.parametrize("node_type", ["NodeRigidBodyEP", "NodeRigidBodyRotVecLG"])
@pytest.mark.parametrize("end", heights_of_slider())
def test_height_of_the_slider(node_type: str, end: float) -> None:
    """The slider swings by 0.25 m with some 6 rad/s: (6e-3)^2 / 12 of 0.25 m per radian are 0.75e-6 m for h = 1 ms,
    which add up."""
    error = abs(final(node_type, end, int(1000 * end)) - heights_of_slider()[end])
    assert 1e-9 < error < 1e-6 + 5e-6 * end


@pytest.mark.parametrize("node_type", ["NodeRigidBodyEP", "NodeRigidBodyRotVecLG"])
def test_second_order(node_type: str) -> None:
    assert self_orders(lambda n: final(node_type, 0.5, n), 250) == pytest.approx(2, abs=0.25)
