"""A planar slider-crank driven at constant speed: kinematics in closed form, drive torque from the power balance."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from solving import Variable, new_system, settings

import dalembert as exu

CRANK, ROD, SPEED = 0.3, 0.8, 5.0
MASS_ROD, MASS_SLIDER = 1.2, 2.0


def angle(t: Any) -> Any:
    return 0.4 + SPEED * np.asarray(t)


def slider_position(t: Any) -> Any:
    return CRANK * np.cos(angle(t)) + np.sqrt(ROD**2 - (CRANK * np.sin(angle(t))) ** 2)


def kinetic_energy(t: float, h: float = 1e-4) -> float:
    """Angles of rod and slider, with rates by central differences of the closed form."""

    def places(t: float) -> np.ndarray:
        crank = CRANK * np.array([np.cos(angle(t)), np.sin(angle(t))])
        end = np.array([slider_position(t), 0])
        turn = -np.arcsin(crank[1] / ROD)
        return np.array([*(crank + end) / 2, turn, end[0]])

    x, y, turn, slider = (places(t + h) - places(t - h)) / (2 * h)
    rod = MASS_ROD * (x**2 + y**2) + MASS_ROD * ROD**2 / 12 * turn**2
    return float(0.5 * (rod + MASS_SLIDER * slider**2))


class SliderCrank:
    def __init__(self) -> None:
        self.mbs = new_system()
        ground = self.mbs.AddObject(exu.ObjectGround())
        start = float(angle(0))
        pin = CRANK * np.array([np.cos(start), np.sin(start)])
        end = np.array([float(slider_position(0)), 0])
        lean = -np.arcsin(pin[1] / ROD)
        lean_rate = -CRANK * np.cos(start) * SPEED / (ROD * np.cos(lean))
        pin_rate = SPEED * np.array([-pin[1], pin[0]])
        end_rate = np.array([pin_rate[0] - ROD * np.sin(lean) * lean_rate, 0])
        crank, self.crank_node = self.body([*pin / 2, start], [*pin_rate / 2, SPEED], 0.5, 0.01)
        rod, _ = self.body(
            [*(pin + end) / 2, lean], [*(pin_rate + end_rate) / 2, lean_rate], MASS_ROD, MASS_ROD * ROD**2 / 12
        )
        node = self.mbs.AddNode(exu.NodePoint2D(referenceCoordinates=end, initialVelocities=end_rate))
        self.slider = self.mbs.AddObject(exu.MassPoint2D(physicsMass=MASS_SLIDER, nodeNumber=node))
        self.join((ground, 0), (crank, -CRANK / 2))
        self.join((crank, CRANK / 2), (rod, -ROD / 2))
        self.join((rod, ROD / 2), (self.slider, 0))
        fixed = self.mbs.AddMarker(
            exu.MarkerNodeCoordinate(nodeNumber=self.mbs.AddNode(exu.NodePointGround()), coordinate=0)
        )
        guide = self.mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=1))
        self.mbs.AddObject(exu.CoordinateConstraint(markerNumbers=[fixed, guide]))
        turn = self.mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=self.crank_node, coordinate=2))
        self.drive = self.mbs.AddObject(
            exu.CoordinateConstraint(
                markerNumbers=[fixed, turn],
                offsetUserFunction=lambda mbs, t, item, offset: SPEED * t,
                offsetUserFunction_t=lambda mbs, t, item, offset: SPEED,
            )
        )
        self.mbs.Assemble()

    def body(self, place: Any, rates: Any, mass: float, inertia: float) -> tuple[Any, Any]:
        node = self.mbs.AddNode(exu.NodeRigidBody2D(referenceCoordinates=place, initialVelocities=rates))
        return self.mbs.AddObject(exu.RigidBody2D(physicsMass=mass, physicsInertia=inertia, nodeNumber=node)), node

    def join(self, *ends: tuple[Any, float]) -> None:
        markers = [self.mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=b, localPosition=[x, 0, 0])) for b, x in ends]
        self.mbs.AddObject(exu.RevoluteJoint2D(markerNumbers=markers))


@pytest.mark.parametrize("index2", [False, True], ids=["index3", "index2"])
def test_slider_crank(index2: bool) -> None:
    """Positions: to the tolerance of Newton's method if they are constrained, else with the second order of the method.
    The
    torque has the error of accelerations, of second order as well: (n h)^2 with n = 5/s, 10/s, ... and h = 0.5 ms."""
    model = SliderCrank()
    s = settings(1.0, 2000, spectral_radius=0.8)
    s.timeIntegration.generalizedAlpha.useIndex2Constraints = index2
    s.timeIntegration.generalizedAlpha.useNewmark = index2
    model.mbs.SolveDynamic(s)
    end = model.mbs.GetObjectOutputBody(model.slider, Variable.Position, [0, 0, 0])
    assert end[0] == pytest.approx(float(slider_position(1.0)), abs=1e-5 if index2 else 1e-9)
    torque = model.mbs.GetObjectOutput(model.drive, Variable.Force)
    power = (kinetic_energy(1.0 + 1e-3) - kinetic_energy(1.0 - 1e-3)) / 2e-3
    assert abs(power) > 1
    assert abs(torque) * SPEED == pytest.approx(abs(power), rel=1e-3)
