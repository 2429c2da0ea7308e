"""ObjectContactCircleCable2D: balance of forces, impacts, and events of contact."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert._core import testing

RADIUS, STIFFNESS, MASS = 0.2, 1e4, 2.0


class Press:
    """A circle above the middle of a cable of several elements between two hinges. `fixed`: the cable does not move."""

    def __init__(
        self, height: float, fixed: bool = False, x: float = 0.0, speed: float = 0.0, load: float = 0.0, **contact: Any
    ) -> None:
        self.mbs = mbs = exu.SystemContainer().AddSystem()
        self.nodes = [
            mbs.AddNode(exu.NodePoint2DSlope1(referenceCoordinates=[x0, 0, 1, 0])) for x0 in np.linspace(-1, 1, 5)
        ]
        ground = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(exu.NodePointGround()), coordinate=0))
        self.supports = []
        for node in self.nodes if fixed else self.nodes[:: len(self.nodes) - 1]:
            for k in range(4 if fixed else 2):
                marker = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=k))
                self.supports.append(mbs.AddObject(exu.ObjectConnectorCoordinate(markerNumbers=[ground, marker])))
        self.circle = mbs.AddNode(exu.NodePoint2D(referenceCoordinates=[x, height], initialVelocities=[0, speed]))
        body = mbs.AddObject(exu.ObjectMassPoint2D(physicsMass=MASS, nodeNumber=self.circle))
        marker = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=body))
        if not fixed:
            guide = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=self.circle, coordinate=0))
            mbs.AddObject(exu.ObjectConnectorCoordinate(markerNumbers=[ground, guide]))
        if load:
            mbs.AddLoad(exu.LoadForceVector(markerNumber=marker, loadVector=[0, load, 0]))
        self.data = []
        for pair in zip(self.nodes[:-1], self.nodes[1:], strict=True):
            cable = mbs.AddObject(
                exu.ObjectANCFCable2D(
                    physicsLength=0.5,
                    physicsMassPerLength=1,
                    physicsBendingStiffness=20,
                    physicsAxialStiffness=1e4,
                    nodeNumbers=list(pair),
                )
            )
            shape = mbs.AddMarker(exu.MarkerBodyCable2DShape(bodyNumber=cable, numberOfSegments=4))
            self.data.append(mbs.AddNode(exu.NodeGenericData(numberOfDataCoordinates=4, initialCoordinates=[0.1] * 4)))
            mbs.AddObject(
                exu.ObjectContactCircleCable2D(
                    markerNumbers=[marker, shape],
                    nodeNumber=self.data[-1],
                    numberOfContactSegments=4,
                    circleRadius=RADIUS,
                    **{"contactStiffness": STIFFNESS, **contact},
                )
            )
        mbs.Assemble()

    def solve(self, end: float, steps: int) -> None:
        settings = exu.SimulationSettings()
        settings.solutionSettings.writeSolutionToFile = False
        time = settings.timeIntegration
        time.endTime, time.numberOfSteps, time.verboseMode = end, steps, 0
        time.generalizedAlpha.spectralRadius = 1
        time.discontinuous.iterationTolerance = 1e-3
        self.mbs.SolveDynamic(settings)

    def gaps(self) -> np.ndarray:
        return np.concatenate([self.mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates) for node in self.data])


def test_supports_carry_the_load() -> None:
    """The cable bends under the circle; sums of forces follow from statics alone."""
    press = Press(RADIUS - 1e-3, load=-50.0)
    s = testing.State(press.mbs)
    testing.post_newton(press.mbs, s)
    press.mbs.systemData.SetDataCoordinates(s.data, exu.ConfigurationType.Initial)  # in contact
    settings = exu.SimulationSettings()
    settings.staticSolver.numberOfLoadSteps, settings.staticSolver.verboseMode = 20, 0
    settings.staticSolver.discontinuous.iterationTolerance = 1e-6
    press.mbs.SolveStatic(settings)
    forces = np.array([press.mbs.GetObjectOutput(c, exu.OutputVariableType.Force) for c in press.supports]).ravel()
    left, right = forces[:2], forces[2:]
    assert abs(left[1]) == pytest.approx(25, rel=1e-6)
    assert left[1] == pytest.approx(right[1], rel=1e-6)
    assert left[0] == pytest.approx(-right[0], rel=1e-6)
    depth = press.mbs.GetNodeOutput(press.circle, exu.OutputVariableType.Displacement)[1]
    assert depth < -0.1  # much more than the contact gives way
    assert (press.gaps() <= 0).any() and (press.gaps() > 0).any()


def test_several_segments_in_contact() -> None:
    """Two segments that meet under the circle press with two springs: evaluated at their common point, and at equal
    gaps."""
    press = Press(RADIUS - 0.002, fixed=True)
    s = testing.State(press.mbs)
    testing.post_newton(press.mbs, s)
    r = testing.residual(press.mbs, s)
    first = press.mbs.GetNodeODE2Index(press.circle)
    np.testing.assert_allclose(r[first : first + 2], [0, -2 * STIFFNESS * 0.002], rtol=0, atol=1e-10)
    assert r[:first].reshape(-1, 4)[:, 1].sum() == pytest.approx(2 * STIFFNESS * 0.002)


@pytest.mark.parametrize("x", [0.0625, 0.3125])
def test_impact_on_a_cable_that_rests(x: float) -> None:
    """Half a period of the contact spring, in the middle of a segment; then the circle leaves with the speed with which it came."""
    frequency, speed, gap = np.sqrt(STIFFNESS / MASS), 0.4, 0.01
    press = Press(RADIUS + gap, fixed=True, x=x, speed=-speed)
    duration = np.pi / frequency
    end = gap / speed + duration + 0.05
    press.solve(end, 4000)
    height, rate = (
        press.mbs.GetNodeOutput(press.circle, kind)
        for kind in (exu.OutputVariableType.Position, exu.OutputVariableType.Velocity)
    )
    assert rate[1] == pytest.approx(speed, rel=2e-3)
    assert height[1] == pytest.approx(RADIUS + speed * 0.05, abs=2e-4)
    np.testing.assert_allclose([height[0], rate[0]], [x, 0], rtol=0, atol=1e-9)
    assert (press.gaps() > 0).all()


@pytest.mark.parametrize("offset", [0.0, 0.01])
def test_force_of_stiffness_damping_and_offset(offset: float) -> None:
    depth, speed, damping = 0.003, -0.7, 30.0
    press = Press(RADIUS + offset - depth, fixed=True, x=0.0625, speed=speed, contactDamping=damping, offset=offset)
    s = testing.State(press.mbs)
    assert testing.post_newton(press.mbs, s)[0] == pytest.approx(STIFFNESS * (depth + 0.1))
    first = press.mbs.GetNodeODE2Index(press.circle)
    force = STIFFNESS * depth - damping * speed
    assert testing.residual(press.mbs, s)[first + 1] == pytest.approx(-force, rel=1e-12)
    again = s.copy()
    assert testing.post_newton(press.mbs, again)[0] == 0
    np.testing.assert_array_equal(again.data, s.data)


def test_offset_of_the_shape_turns_with_the_cable() -> None:
    """Points of a cable that is turned by 0.5 and stretched lie off its axis along the unit normal."""
    mbs = exu.SystemContainer().AddSystem()
    t, n = (np.array(v) for v in ([np.cos(0.5), np.sin(0.5)], [-np.sin(0.5), np.cos(0.5)]))
    nodes = [mbs.AddNode(exu.NodePoint2DSlope1(referenceCoordinates=[*(x * t), *(1.2 * t)])) for x in (0, 1.2)]
    cable = mbs.AddObject(exu.ObjectANCFCable2D(physicsLength=1, nodeNumbers=nodes))
    shape = mbs.AddMarker(exu.MarkerBodyCable2DShape(bodyNumber=cable, numberOfSegments=1, verticalOffset=0.3))
    center = mbs.AddNode(exu.NodePoint2D(referenceCoordinates=0.6 * t + 0.4 * n))
    circle = mbs.AddMarker(
        exu.MarkerBodyPosition(bodyNumber=mbs.AddObject(exu.ObjectMassPoint2D(physicsMass=1, nodeNumber=center)))
    )
    data = mbs.AddNode(exu.NodeGenericData(numberOfDataCoordinates=1, initialCoordinates=[0]))
    mbs.AddObject(
        exu.ObjectContactCircleCable2D(
            markerNumbers=[circle, shape],
            nodeNumber=data,
            numberOfContactSegments=1,
            contactStiffness=100,
            circleRadius=0.15,
        )
    )
    mbs.Assemble()
    r = testing.residual(mbs, testing.State(mbs))
    np.testing.assert_allclose(r[-2:], -100 * 0.05 * n, rtol=0, atol=1e-12)
    np.testing.assert_allclose(r[:2] + r[4:6], 100 * 0.05 * n, rtol=0, atol=1e-12)


def test_segments_of_contact_and_marker_have_to_agree() -> None:
    press = Press(1.0)
    contact = len(press.mbs.GetDictionary()["objectList"]) - 1
    press.mbs.SetObjectParameter(contact, "numberOfContactSegments", 3)
    with pytest.raises(ValueError, match="numberOfContactSegments.*3.*4, as marker m1 has"):
        press.mbs.Assemble()


def test_other_bodies_are_refused() -> None:
    mbs = exu.SystemContainer().AddSystem()
    body = mbs.AddObject(exu.ObjectMassPoint2D(physicsMass=1, nodeNumber=mbs.AddNode(exu.NodePoint2D())))
    mbs.AddMarker(exu.MarkerBodyCable2DShape(bodyNumber=body))
    with pytest.raises(ValueError, match="bodyNumber.*ObjectMassPoint2D.*a planar cable"):
        mbs.Assemble()
