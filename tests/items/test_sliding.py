"""ObjectJointSliding against the motion of beads on wires in space, and against the joint in the plane."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from test_sliding_2d import Wire, bead_on_wire, bend_after_line, straight, valley

import dalembert as exu

Variable = exu.OutputVariableType
TURN = Rotation.from_rotvec([0.5, -0.9, 0.4]).as_matrix()
LEVELS = pytest.mark.parametrize("index2", [False, True], ids=["index3", "index2"])


class Bead:
    """A rigid body of mass 2 on a planar wire that is turned in space."""

    mass = 2.0

    def __init__(
        self, wire: Wire, s: float, force: Any = (0, 0, 0), speed: float = 0.0, fixed: bool = True, **joint: Any
    ) -> None:
        self.mbs = mbs = exu.SystemContainer().AddSystem()
        space = np.kron(np.eye(2), TURN[:, :2])  # position and slope
        self.nodes = [mbs.AddNode(exu.NodePointSlope1(referenceCoordinates=space @ row)) for row in wire.nodes]
        self.cables = [
            mbs.AddObject(
                exu.ObjectANCFCable(
                    physicsLength=length,
                    physicsMassPerLength=1.5,
                    physicsBendingStiffness=3,
                    physicsAxialStiffness=200,
                    strainIsRelativeToReference=1,
                    nodeNumbers=self.nodes[i : i + 2],
                )
            )
            for i, length in enumerate(wire.lengths)
        ]
        if fixed:
            ground = mbs.AddMarker(
                exu.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(exu.NodePointGround()), coordinate=0)
            )
            for node in self.nodes:
                for k in range(6):
                    marker = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=k))
                    mbs.AddObject(exu.ObjectConnectorCoordinate(markerNumbers=[ground, marker]))
        r, t, b = wire.at(s)
        angle = np.arctan2(t[1], t[0])
        frame = TURN @ Rotation.from_rotvec([0, 0, angle]).as_matrix()
        spin = (t[0] * b[1] - t[1] * b[0]) / (t @ t) * speed if any(joint["constrainRotations"]) else 0.0
        p = Rotation.from_matrix(frame).as_quat()[[3, 0, 1, 2]]
        p_t = 0.5 * np.array([-p[3], p[2], -p[1], p[0]]) * spin  # about the own z axis
        self.node = mbs.AddNode(
            exu.NodeRigidBodyEP(
                referenceCoordinates=[*(TURN[:, :2] @ r), *p],
                initialVelocities=[*(TURN[:, :2] @ (speed * t)), *p_t],
            )
        )
        self.body = mbs.AddObject(
            exu.ObjectRigidBody(physicsMass=self.mass, physicsInertia=[0.2, 0.25, 0.3, 0, 0, 0], nodeNumber=self.node)
        )
        slider = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=self.body))
        mbs.AddLoad(exu.LoadForceVector(markerNumber=slider, loadVector=TURN @ np.asarray(force, float)))
        markers = [mbs.AddMarker(exu.MarkerBodyBeamShape(bodyNumber=cable)) for cable in self.cables]
        first = wire.element(s)
        self.data = mbs.AddNode(exu.NodeGenericData(numberOfDataCoordinates=2, initialCoordinates=[first, s]))
        self.joint = mbs.AddObject(
            exu.ObjectJointSliding(
                markerNumbers=[slider, markers[first]],
                slidingMarkerNumbers=markers,
                slidingMarkerOffsets=wire.offsets,
                nodeNumber=self.data,
                **joint,
            )
        )

    def solve(self, end: float, steps: int, index2: bool = False, located: bool = False) -> Bead:
        self.mbs.Assemble()
        settings = exu.SimulationSettings()
        settings.timeIntegration.endTime = end
        settings.timeIntegration.numberOfSteps = steps
        settings.timeIntegration.newton.relativeTolerance = 1e-9
        settings.timeIntegration.discontinuous.iterationTolerance = 1e-6  # m
        settings.events.ofItems = located
        solver = exu.DynamicSolverType.TrapezoidalIndex2 if index2 else exu.DynamicSolverType.GeneralizedAlpha
        self.mbs.SolveDynamic(settings, solverType=solver)
        return self

    def told(self, variable: Any) -> np.ndarray:
        return np.asarray(self.mbs.GetObjectOutput(self.joint, variable))


@LEVELS
@pytest.mark.parametrize("rotations", [[0, 0, 0], [0, 1, 1]], ids=["free", "guided"])
def test_straight_wire(index2: bool, rotations: list[int]) -> None:
    """A force along a straight wire: s = s0 + v t + F/(2m) t^2, over three elements, and the reaction of the force across."""
    bead = Bead(straight(0.3), 0.4, force=(3, 1, -2), speed=0.5, constrainRotations=rotations).solve(0.8, 80, index2)
    along = 3 * np.cos(0.3) + np.sin(0.3)
    assert bead.told(Variable.SlidingCoordinate) == pytest.approx(0.4 + 0.5 * 0.8 + along / 4 * 0.64, abs=1e-8)
    across = np.array([3, 1, -2]) - along * np.array([np.cos(0.3), np.sin(0.3), 0])
    assert np.abs(bead.told(Variable.Force)) == pytest.approx(np.abs(TURN @ across), abs=1e-6)
    assert bead.mbs.GetNodeOutput(bead.data, Variable.Coordinates)[0] == (1 if 0.8 + along / 4 * 0.64 < 1.5 else 2)


def rolling(s: float, speed: float, end: float, guided: bool) -> float:
    """Place of a bead on the valley under gravity 9: computed from its energy, by small steps of its equation of
    motion."""
    from scipy.integrate import solve_ivp

    wire, mass, inertia = valley(), Bead.mass, 0.3 if guided else 0.0

    def energy_terms(s: float) -> tuple[float, float]:
        r, t, b = wire.at(s)
        turn = (t[0] * b[1] - t[1] * b[0]) / (t @ t)
        return mass * t @ t + inertia * turn**2, mass * 9 * r[1]

    def motion(_: float, y: np.ndarray) -> list[float]:
        h = 1e-5
        (m0, v0), (m, _), (m1, v1) = (energy_terms(y[0] + d) for d in (-h, 0, h))
        return [y[1], (-(m1 - m0) / (4 * h) * y[1] ** 2 - (v1 - v0) / (2 * h)) / m]

    return float(solve_ivp(motion, (0, end), [s, speed], rtol=1e-10, atol=1e-12).y[0, -1])


@LEVELS
@pytest.mark.parametrize("rotations", [[0, 0, 0], [0, 1, 1]], ids=["free", "guided"])
def test_valley(index2: bool, rotations: list[int]) -> None:
    """A bead on a parabola in space; if the wire guides its axes, it turns, and its inertia slows it down."""
    force = (0, -Bead.mass * 9, 0)
    errors = [
        float(Bead(valley(), 0.9, force, 0.4, constrainRotations=rotations).solve(0.5, n, index2).told(Variable.SlidingCoordinate))
        - rolling(0.9, 0.4, 0.5, any(rotations))
        for n in (400, 800)
    ]  # fmt: skip
    assert abs(errors[1]) < 2e-4
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.35) or abs(errors[1]) < 1e-6


@LEVELS
def test_steps_end_between_elements(index2: bool) -> None:
    """The wire is straight, then curved: the force that leads the bead jumps. Steps that end there keep their order."""
    wire, start, speed, end = bend_after_line(), 0.3, 2.0, 0.6
    wanted = bead_on_wire(wire, Bead.mass, 0, start, speed, end)

    def error(steps: int, located: bool) -> float:
        bead = Bead(wire, start, (0, -Bead.mass * 9, 0), speed, constrainRotations=[0, 0, 0])
        bead.solve(end, steps, index2, located)
        assert bead.mbs.sys["dynamicSolver"].it.eventsCount == located
        return abs(float(bead.told(Variable.SlidingCoordinate)) - wanted)

    errors = [error(steps, located=True) for steps in (50, 100, 200)]
    for coarse, fine in zip(errors[:-1], errors[1:], strict=True):
        assert np.log2(coarse / fine) == pytest.approx(2, abs=0.3)
    assert error(50, located=False) > 3 * errors[0]  # steps that end anywhere


def test_axial_force_drives_the_body() -> None:
    bead = Bead(straight(0.2), 0.3, axialForce=4.0, constrainRotations=[0, 0, 0]).solve(0.5, 50)
    assert abs(bead.told(Variable.SlidingCoordinate) - 0.3) == pytest.approx(4 / 2 / 2 * 0.25, abs=1e-8)


def test_energy_of_a_free_chain() -> None:
    """A bead that runs along a free cable: nothing is lost, but for the order of the trapezoidal rule."""

    def momentum_and_place(steps: int) -> tuple[np.ndarray, float]:
        bead = Bead(straight(0.1), 0.6, (0, 0, 0), 1.5, fixed=False, constrainRotations=[0, 1, 1]).solve(
            0.4, steps, True
        )
        velocity = np.asarray(bead.mbs.GetNodeOutput(bead.node, Variable.Velocity))
        return velocity, float(bead.told(Variable.SlidingCoordinate))

    direction = TURN @ [np.cos(0.1), np.sin(0.1), 0]
    velocity, place = momentum_and_place(40)
    assert velocity == pytest.approx(1.5 * direction, abs=1e-9)  # frictionless: the cable rests
    assert place == pytest.approx(0.6 + 1.5 * 0.4, abs=1e-9)


@pytest.mark.parametrize(
    ("joint", "expected"),
    [
        ({}, r"constrainRotations.*about the x axis.*0 as first flag"),
        ({"constrainRotations": [0, 0, 0], "slidingMarkerOffsets": [0.0]}, r"slidingMarkerOffsets.*one for each"),
    ],
)
def test_refused(joint: dict[str, Any], expected: str) -> None:
    wire = straight(0.1)
    bead = Bead(wire, 0.4, constrainRotations=[0, 0, 0])
    for name, value in {"constrainRotations": [1, 1, 1], **joint}.items():
        bead.mbs.SetObjectParameter(bead.joint, name, value)
    with pytest.raises(ValueError, match=expected):
        bead.mbs.Assemble()
