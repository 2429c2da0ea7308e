"""ObjectJointSliding2D against the motion of beads on wires, and conserved quantities."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import dalembert as exu
from dalembert._core import testing

FORMULATIONS = pytest.mark.parametrize("classical", [True, False], ids=["classical", "other"])
LEVELS = pytest.mark.parametrize("index2", [False, True], ids=["index3", "index2"])
ROTATIONS = pytest.mark.parametrize("rotation", [False, True], ids=["free", "guided"])


def hermite(x: float, length: float) -> np.ndarray:
    """Weights of the nodes for position, slope and second derivative at a place: one row each."""
    s, h = x / length, length
    return np.array(
        [
            [1 - 3 * s**2 + 2 * s**3, h * (s - 2 * s**2 + s**3), 3 * s**2 - 2 * s**3, h * (s**3 - s**2)],
            [(6 * s**2 - 6 * s) / h, 1 - 4 * s + 3 * s**2, (6 * s - 6 * s**2) / h, 3 * s**2 - 2 * s],
            [(12 * s - 6) / h**2, (6 * s - 4) / h, (6 - 12 * s) / h**2, (6 * s - 2) / h],
        ]
    )


@dataclass
class Wire:
    """A chain of cable elements through nodes with given positions and slopes."""

    nodes: np.ndarray  # rows: position, slope
    lengths: np.ndarray

    @property
    def offsets(self) -> np.ndarray:
        return np.concatenate([[0], np.cumsum(self.lengths)[:-1]])

    def element(self, s: float) -> int:
        return int(np.clip(np.searchsorted(self.offsets, s, side="right") - 1, 0, len(self.lengths) - 1))

    def at(self, s: float) -> np.ndarray:
        """Rows: position, slope, second derivative."""
        i = self.element(s)
        return hermite(s - self.offsets[i], self.lengths[i]) @ self.nodes[i : i + 2].reshape(4, 2)


def straight(angle: float, lengths: tuple[float, ...] = (1.0, 0.5, 2.0, 1.5)) -> Wire:
    direction = np.array([np.cos(angle), np.sin(angle)])
    places = np.concatenate([[0], np.cumsum(lengths)])
    return Wire(np.array([np.concatenate([x * direction, direction]) for x in places]), np.array(lengths))


def valley(elements: int = 6) -> Wire:
    """A parabola, which cubic polynomials follow exactly in x; the slope has a varying length."""
    x = np.linspace(-1.5, 1.5, elements + 1)
    return Wire(np.array([x, 0.5 * x**2, np.ones_like(x), x]).T, np.full(elements, 3 / elements))


class Bead:
    """A rigid body of mass 2 and inertia 0.3 on a wire. `fixed`: the wire does not move."""

    mass, inertia = 2.0, 0.3

    def __init__(
        self, wire: Wire, s: float, fixed: bool = True, gravity: float = 9.0, speed: float = 0.0, **joint: Any
    ) -> None:
        self.mbs = mbs = exu.SystemContainer().AddSystem()
        self.wire = wire
        self.nodes = [mbs.AddNode(exu.NodePoint2DSlope1(referenceCoordinates=row)) for row in wire.nodes]
        self.cables = [
            mbs.AddObject(
                exu.ObjectANCFCable2D(
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
                for k in range(4):
                    marker = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=k))
                    mbs.AddObject(exu.ObjectConnectorCoordinate(markerNumbers=[ground, marker]))
        r, t, b = wire.at(s)
        turn = (t[0] * b[1] - t[1] * b[0]) / (t @ t) * speed if joint.get("constrainRotation") else 0.0
        self.node = mbs.AddNode(
            exu.NodeRigidBody2D(
                referenceCoordinates=[*r, np.arctan2(t[1], t[0])], initialVelocities=[*(speed * t), turn]
            )
        )
        self.body = mbs.AddObject(
            exu.ObjectRigidBody2D(physicsMass=self.mass, physicsInertia=self.inertia, nodeNumber=self.node)
        )
        slider = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=self.body))
        if gravity:
            mbs.AddLoad(exu.LoadForceVector(markerNumber=slider, loadVector=[0, -self.mass * gravity, 0]))
        markers = [mbs.AddMarker(exu.MarkerBodyCable2DCoordinates(bodyNumber=cable)) for cable in self.cables]
        first = wire.element(s)
        self.data = mbs.AddNode(exu.NodeGenericData(numberOfDataCoordinates=2, initialCoordinates=[first, s]))
        self.joint = mbs.AddObject(
            exu.ObjectJointSliding2D(
                markerNumbers=[slider, markers[first]],
                slidingMarkerNumbers=markers,
                slidingMarkerOffsets=wire.offsets,
                nodeNumber=self.data,
                **joint,
            )
        )
        mbs.Assemble()

    def solve(self, end: float, steps: int, index2: bool = False, located: bool = False) -> None:
        settings = exu.SimulationSettings()
        settings.solutionSettings.writeSolutionToFile = False
        settings.events.ofItems = located
        time = settings.timeIntegration
        time.endTime, time.numberOfSteps, time.verboseMode = end, steps, 0
        time.newton.relativeTolerance = 1e-10
        time.discontinuous.iterationTolerance = 1e-6  # m: the step that leaves an element ends on the next one
        time.generalizedAlpha.spectralRadius = 1
        time.generalizedAlpha.useIndex2Constraints = time.generalizedAlpha.useNewmark = index2
        self.mbs.SolveDynamic(settings)

    def place(self) -> float:
        return float(self.mbs.GetObjectOutput(self.joint, exu.OutputVariableType.SlidingCoordinate))

    def force(self) -> np.ndarray:
        return np.array(self.mbs.GetObjectOutput(self.joint, exu.OutputVariableType.Force))

    def energy(self, gravity: float = 9.0) -> float:
        """Energy of the bead alone."""
        x, v = (
            np.array(self.mbs.GetNodeOutput(self.node, kind))
            for kind in (exu.OutputVariableType.CoordinatesTotal, exu.OutputVariableType.Coordinates_t)
        )
        return float(self.mass * (v[:2] @ v[:2] / 2 + gravity * x[1]) + self.inertia * v[2] ** 2 / 2)


@FORMULATIONS
@LEVELS
@ROTATIONS
@pytest.mark.parametrize("angle", [0.0, -0.7, 2.5])
def test_along_a_straight_cable(classical: bool, index2: bool, rotation: bool, angle: float) -> None:
    """Constant acceleration, which the integrators follow exactly; elements of different length, passed forwards or backwards."""
    start, speed, end = (0.3, 1.0, 0.8) if np.sin(angle) <= 0 else (4.5, -0.5, 0.7)
    bead = Bead(straight(angle), start, speed=speed, classicalFormulation=classical, constrainRotation=rotation)
    bead.solve(end, 40, index2)
    wanted = start + speed * end - 9 * np.sin(angle) * end**2 / 2
    assert bead.wire.element(wanted) != bead.wire.element(start)
    assert bead.place() == pytest.approx(wanted, abs=1e-9)
    x = bead.mbs.GetNodeOutput(bead.node, exu.OutputVariableType.CoordinatesTotal)
    np.testing.assert_allclose(x, [*bead.wire.at(wanted)[0], angle], rtol=0, atol=1e-9)
    normal = bead.mass * 9 * np.cos(angle)  # that the cable has to carry
    weight = [-normal * np.sin(angle), normal * np.cos(angle), 0] if classical else [0, normal, 0]
    np.testing.assert_allclose(bead.force(), weight, rtol=0, atol=1e-7)


def bead_on_wire(wire: Wire, mass: float, inertia: float, s: float, speed: float, end: float) -> float:
    """Position of a bead at the end: (m t.t + J phi'^2) s'' + (m t.b + J phi' phi'') s'^2 + m g y' = 0; phi'' by a
    difference."""

    def turn(s: float) -> float:
        _, t, b = wire.at(s)
        return float((t[0] * b[1] - t[1] * b[0]) / (t @ t))

    def rate(_: float, x: np.ndarray) -> list[float]:
        _, t, b = wire.at(x[0])
        h = 1e-6
        bend = (turn(x[0] + h) - turn(x[0] - h)) / (2 * h)
        force = (mass * t @ b + inertia * turn(x[0]) * bend) * x[1] ** 2 + mass * 9 * t[1]
        return [x[1], -force / (mass * t @ t + inertia * turn(x[0]) ** 2)]

    return float(solve_ivp(rate, (0, end), [s, speed], rtol=1e-10, atol=1e-10, max_step=0.01).y[0, -1])


@FORMULATIONS
@LEVELS
@ROTATIONS
def test_along_a_curved_cable(classical: bool, index2: bool, rotation: bool) -> None:
    """The error falls with the square of the step, towards a bead on the same wire."""
    start, speed, end = 0.2, 0.8, 1.2
    wanted = bead_on_wire(valley(), Bead.mass, Bead.inertia * rotation, start, speed, end)
    errors = []
    for steps in (400, 1600):
        bead = Bead(valley(), start, speed=speed, classicalFormulation=classical, constrainRotation=rotation)
        energy = bead.energy()
        bead.solve(end, steps, index2)
        errors.append([abs(bead.place() - wanted), abs(bead.energy() - energy)])
    assert bead.wire.element(wanted) != bead.wire.element(start)
    coarse, fine = np.array(errors)
    assert coarse[0] < 1e-3 and coarse[1] < 1e-3 * energy
    # Second order: 1/16. Energies change with the place within a step where the bead comes to another element.
    assert 0.04 * coarse[0] - 1e-9 < fine[0] < 0.08 * coarse[0] + 1e-9
    assert fine[1] < 0.1 * coarse[1] + 1e-9


def bend_after_line() -> Wire:
    """Straight, then curved: the force that leads a bead jumps."""
    return Wire(np.array([[0, 0, 1, 0], [1, 0, 1, 0], [2, 0.6, 1, 1.2]], float), np.ones(2))


@FORMULATIONS
@LEVELS
def test_steps_end_between_elements(classical: bool, index2: bool) -> None:
    """The force jumps there; steps end there, to keep their order."""
    wire = bend_after_line()
    start, speed, end = 0.3, 2.0, 0.6
    wanted = bead_on_wire(wire, Bead.mass, 0, start, speed, end)
    errors = []
    for steps in (50, 100, 200):
        bead = Bead(wire, start, speed=speed, classicalFormulation=classical)
        bead.solve(end, steps, index2, located=True)
        assert bead.mbs.sys["dynamicSolver"].it.eventsCount == 1
        errors.append(abs(bead.place() - wanted))
    for coarse, fine in zip(errors[:-1], errors[1:], strict=True):
        assert np.log2(coarse / fine) == pytest.approx(2, abs=0.3)
    bead = Bead(wire, start, speed=speed, classicalFormulation=classical)
    bead.solve(end, 50, index2)
    assert abs(bead.place() - wanted) > 3 * errors[0]  # steps that end anywhere


@pytest.mark.parametrize("force", [3.0, -5.0])
def test_axial_force_drives_the_body(force: float) -> None:
    bead = Bead(straight(0.4), 2.0, gravity=0, axialForce=force)
    bead.solve(0.5, 20)
    assert bead.place() == pytest.approx(2 + force / bead.mass * 0.5**2 / 2, abs=1e-9)


@FORMULATIONS
@ROTATIONS
def test_with_a_cable_that_floats(classical: bool, rotation: bool) -> None:
    """Nothing acts from outside: linear momentum stays. Forces of the joint on body and cable are in equilibrium, and
    do no work."""
    bead = Bead(
        valley(), 0.4, fixed=False, gravity=0, speed=1.0, classicalFormulation=classical, constrainRotation=rotation
    )
    mbs = bead.mbs
    mass = testing.mass_matrix(mbs, testing.State(mbs))
    reference = mbs.systemData.GetODE2Coordinates(exu.ConfigurationType.Reference)

    def motions() -> np.ndarray:
        """Translations and the rotation of the whole."""
        q = reference + mbs.systemData.GetODE2Coordinates()
        rows = np.zeros((3, len(q)))
        for first in range(0, len(q) - 3, 4):
            rows[:2, first : first + 2] = np.eye(2)
            for k in (first, first + 2):
                rows[2, k : k + 2] = [-q[k + 1], q[k]]
        rows[:2, -3:-1], rows[2, -3:] = np.eye(2), [-q[-2], q[-3], 1]
        return rows

    before = motions()[:2] @ mass @ mbs.systemData.GetODE2Coordinates_t()
    bead.solve(0.4, 100, index2=True)
    assert bead.place() > bead.wire.offsets[bead.wire.element(0.4) + 1]
    np.testing.assert_allclose(motions()[:2] @ mass @ mbs.systemData.GetODE2Coordinates_t(), before, rtol=0, atol=1e-9)
    s = testing.State(mbs)
    forces = testing.residual(mbs, s)[: len(s.q)]
    s.lam = 0 * s.lam
    forces -= testing.residual(mbs, s)[: len(s.q)]
    assert np.abs(forces).max() > 0.1
    np.testing.assert_allclose(motions() @ forces, 0, atol=1e-5)  # index 2: the gap itself is not zero
    np.testing.assert_allclose(forces @ s.v, 0, atol=1e-7)


@FORMULATIONS
@ROTATIONS
def test_rest_on_a_curved_cable(classical: bool, rotation: bool) -> None:
    """A spring along x, without force at the start, and the weight: their components along y = x^2 / 2 are in balance."""
    bead, stiffness = Bead(valley(), 2.6, classicalFormulation=classical, constrainRotation=rotation), 30.0
    mbs, start = bead.mbs, bead.wire.at(2.6)[0][0]
    ground = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(exu.NodePointGround()), coordinate=0))
    x, turn = (mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=bead.node, coordinate=k)) for k in (0, 2))
    mbs.AddObject(exu.ObjectConnectorCoordinateSpringDamper(markerNumbers=[ground, x], stiffness=stiffness))
    if not rotation:
        mbs.AddObject(exu.ObjectConnectorCoordinate(markerNumbers=[ground, turn]))
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.staticSolver.numberOfLoadSteps, settings.staticSolver.verboseMode = 10, 0
    settings.staticSolver.newton.relativeTolerance = 1e-10
    mbs.SolveStatic(settings)
    rest = mbs.GetNodeOutput(bead.node, exu.OutputVariableType.CoordinatesTotal)
    wanted = stiffness * start / (stiffness + bead.mass * 9)
    np.testing.assert_allclose(rest[:2], [wanted, wanted**2 / 2], rtol=0, atol=1e-7)
    assert bead.wire.element(bead.place()) != bead.wire.element(2.6)


@FORMULATIONS
def test_beyond_the_ends(classical: bool) -> None:
    """The last element goes on; its index and the place that is kept stay within the cable."""
    bead = Bead(straight(0.0, (1.0, 1.0)), 1.8, speed=1.0, gravity=0, classicalFormulation=classical)
    bead.solve(0.5, 10)
    x = bead.mbs.GetNodeOutput(bead.node, exu.OutputVariableType.CoordinatesTotal)
    np.testing.assert_allclose(x, [2.3, 0, 0], rtol=0, atol=1e-9)
    data = bead.mbs.GetNodeOutput(bead.data, exu.OutputVariableType.Coordinates)
    np.testing.assert_allclose(data, [1, 2], rtol=0, atol=1e-12)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"slidingMarkerOffsets": [0.0]}, "slidingMarkerOffsets.*1 offsets.*4, one for each"),
        ({"slidingMarkerNumbers": []}, "slidingMarkerNumbers.*an empty list"),
        (
            {"slidingMarkerNumbers": [exu.MarkerIndex(0)] * 4},
            "slidingMarkerNumbers.*MarkerNodeCoordinate.*MarkerBodyCable2DCoordinates",
        ),
    ],
)
def test_refusals(change: dict[str, Any], message: str) -> None:
    bead = Bead(straight(0.0), 0.5)
    with pytest.raises(ValueError, match=message):
        for key, value in change.items():
            bead.mbs.SetObjectParameter(bead.joint, key, value)
        bead.mbs.Assemble()


def test_rotation_asks_for_a_rigid_body() -> None:
    bead = Bead(straight(0.0), 0.5)
    mbs = bead.mbs
    point = mbs.AddObject(exu.ObjectMassPoint2D(physicsMass=1, nodeNumber=mbs.AddNode(exu.NodePoint2D())))
    marker = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=point))
    item = dict(mbs.GetObject(bead.joint))
    mbs.SetObjectParameter(bead.joint, "markerNumbers", [marker, item["markerNumbers"][1]])
    mbs.Assemble()
    mbs.SetObjectParameter(bead.joint, "constrainRotation", True)
    with pytest.raises(ValueError, match="MarkerBodyPosition.*a rigid body marker"):
        mbs.Assemble()
