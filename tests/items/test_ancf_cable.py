"""ObjectANCFCable against beam theory, and against the planar cable."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from test_ancf_cable_2d import ELASTICA

import dalembert as exu
from dalembert.itemInterface import (
    Cable2D,
    CoordinateConstraint,
    Force,
    LoadMassProportional,
    MarkerBodyMass,
    MarkerBodyPosition,
    MarkerBodyRigid,
    MarkerNodeCoordinate,
    MarkerNodePosition,
    NodePoint2DSlope1,
    NodePointGround,
    NodePointSlope1,
    ObjectANCFCable,
    Torque,
)

Variable = exu.OutputVariableType
TURN = Rotation.from_rotvec([0.4, -1.1, 0.7]).as_matrix()  # independent of the position of the model


class Beam:
    """A straight beam along the first axis of `turn`, of equal elements; the axes are rows of coordinates for clamps if not turned."""

    def __init__(self, elements: int, length: float, turn: Any = None, planar: bool = False, **parameters: Any) -> None:
        self.mbs = mbs = exu.SystemContainer().AddSystem()
        self.turn = np.eye(3) if turn is None else turn
        axis, n = self.turn[:, 0], 2 if planar else 3
        node, cable = (NodePoint2DSlope1, Cable2D) if planar else (NodePointSlope1, ObjectANCFCable)
        self.element_length = length / elements
        self.nodes = [
            mbs.AddNode(node(referenceCoordinates=[*(x * axis[:n]), *axis[:n]]))
            for x in np.linspace(0, length, elements + 1)
        ]
        self.cables = [
            mbs.AddObject(cable(physicsLength=self.element_length, nodeNumbers=list(pair), **parameters))
            for pair in zip(self.nodes[:-1], self.nodes[1:], strict=True)
        ]

    def clamp(self, coordinates: tuple[int, ...] = (0, 1, 2, 4, 5), node: int = 0) -> None:
        mbs = self.mbs
        ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
        for coordinate in coordinates:
            marker = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=self.nodes[node], coordinate=coordinate))
            mbs.AddObject(CoordinateConstraint(markerNumbers=[ground, marker]))

    def weight(self, gravity: Any) -> None:
        for cable in self.cables:
            marker = self.mbs.AddMarker(MarkerBodyMass(bodyNumber=cable))
            self.mbs.AddLoad(LoadMassProportional(markerNumber=marker, loadVector=gravity))

    def push(self, force: Any) -> None:
        end = MarkerBodyPosition(bodyNumber=self.cables[-1], localPosition=[self.element_length, 0, 0])
        self.mbs.AddLoad(Force(markerNumber=self.mbs.AddMarker(end), loadVector=force))

    def solve_static(self, steps: int) -> None:
        self.mbs.Assemble()
        settings = exu.SimulationSettings()
        settings.staticSolver.numberOfLoadSteps = steps
        settings.staticSolver.newton.relativeTolerance = 1e-10
        self.mbs.SolveStatic(settings, updateInitialValues=True)

    def tip(self, variable: Any = Variable.Displacement) -> np.ndarray:
        return np.asarray(self.mbs.GetNodeOutput(self.nodes[-1], variable))


@pytest.mark.parametrize("load", list(ELASTICA))
def test_elastica(load: int) -> None:
    """Bent out of both coordinate planes."""
    length, stiffness, side = 2.0, 3.0, np.array([0, 0.6, -0.8])
    beam = Beam(64, length, physicsBendingStiffness=stiffness, physicsAxialStiffness=1e7 * stiffness)
    beam.clamp()
    beam.push(load * stiffness / length**2 * side)
    beam.solve_static(10)
    deflection, shortening, _ = ELASTICA[load]
    assert beam.tip() / length == pytest.approx(deflection * side - [shortening, 0, 0], rel=1e-5, abs=1e-9)
    moment = beam.mbs.GetObjectOutputBody(beam.cables[0], Variable.TorqueLocal, [0, 0, 0])
    root = load * stiffness / length**2 * length * (1 - shortening)
    assert np.asarray(moment) == pytest.approx(root * np.cross([1, 0, 0], side), rel=2e-3, abs=1e-9)


def swing(planar: bool, turn: Any = None, **settings_of_solver: Any) -> np.ndarray:
    """A damped cable falls from the horizontal; its tip, in its own axes."""
    parameters: dict[str, float] = {
        "physicsMassPerLength": 0.8,
        "physicsBendingStiffness": 0.3,
        "physicsAxialStiffness": 500,
    }
    if turn is None:
        parameters |= {"physicsBendingDamping": 0.01, "physicsAxialDamping": 2, "physicsReferenceAxialStrain": 0.02}
    beam = Beam(6, 1.5, turn, planar, **parameters)
    beam.clamp((0, 1) if planar else (0, 1, 2))
    beam.weight(beam.turn @ [0, -9.81, 0])
    beam.mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = 100
    settings.timeIntegration.endTime = 0.5
    settings.timeIntegration.newton.relativeTolerance = 1e-10
    beam.mbs.SolveDynamic(settings, **settings_of_solver)
    return beam.turn.T @ beam.tip(Variable.Position)


def test_planar_motion_is_that_of_the_planar_cable() -> None:
    planar = swing(planar=True)
    assert planar[1] < -0.5
    assert swing(planar=False) == pytest.approx(planar, abs=1e-9)


def test_motion_does_not_depend_on_axes() -> None:
    assert swing(planar=False, turn=TURN) == pytest.approx(swing(planar=False, turn=np.eye(3)), abs=1e-8)


def test_explicit_solver() -> None:
    """Runge-Kutta steps agree with implicit ones of the same, small size."""
    beam = [
        Beam(3, 0.6, physicsMassPerLength=0.8, physicsBendingStiffness=0.3, physicsAxialStiffness=50) for _ in range(2)
    ]
    for b, kind in zip(beam, ("RK44", "TrapezoidalIndex2"), strict=True):
        b.weight([1, -9.81, 2])
        b.push([0, 0, 3])
        b.mbs.Assemble()
        settings = exu.SimulationSettings()
        settings.timeIntegration.numberOfSteps = 2000
        settings.timeIntegration.endTime = 0.1
        b.mbs.SolveDynamic(settings, solverType=getattr(exu.DynamicSolverType, kind))
    assert beam[0].tip() == pytest.approx(beam[1].tip(), abs=1e-5)
    assert np.linalg.norm(beam[0].tip()) > 0.05


def test_free_free_beam() -> None:
    """Rigid body motions without rotation about the axis, then the frequencies of a free beam in both planes."""
    length, stiffness, mass = 2.0, 3.0, 0.7
    beam = Beam(
        16, length, TURN, physicsMassPerLength=mass, physicsBendingStiffness=stiffness, physicsAxialStiffness=1e7
    )
    beam.mbs.Assemble()
    values, *_ = beam.mbs.ComputeODE2Eigenvalues()
    frequencies = np.sqrt(np.abs(np.sort(np.asarray(values).real)))
    roots = np.repeat([4.730040744862704, 7.853204624095838, 10.99560783800167], 2)
    expected = (roots / length) ** 2 * np.sqrt(stiffness / mass)
    assert frequencies[:5] == pytest.approx(0, abs=1e-2)
    assert frequencies[5:11] == pytest.approx(expected, rel=2e-4)


def test_tensioned_string() -> None:
    """A cable without bending stiffness: a string under its tension swings at n pi / l sqrt(N / rho), about its
    stretched length."""
    length, tension, stiffness, mass = 2.0, 40.0, 2e3, 0.7
    beam = Beam(32, length, physicsMassPerLength=mass, physicsAxialStiffness=stiffness, physicsBendingStiffness=1e-8)
    beam.clamp((0, 1, 2))
    beam.clamp((1, 2), node=-1)
    beam.push([tension, 0, 0])
    beam.solve_static(1)
    assert beam.tip() == pytest.approx([tension / stiffness * length, 0, 0], rel=1e-8)
    values, *_ = beam.mbs.ComputeODE2Eigenvalues(useAbsoluteValues=True)
    frequencies = np.sort(np.sqrt(np.abs(np.asarray(values))))
    # tension per slope: the transverse force on an element is N r'_y / |r'|
    wave = np.sqrt(tension / (1 + tension / stiffness) / mass)
    expected = np.repeat(np.arange(1, 4) * np.pi / length * wave, 2)
    assert frequencies[:6] == pytest.approx(expected, rel=1e-4)


def test_energy_is_kept() -> None:
    """A free cable that was thrown, bent and stretched: the trapezoidal rule keeps kinetic and strain energy, but for its order."""
    length, elements, mass, axial, bending = 1.0, 4, 0.5, 300.0, 2.0
    beam = Beam(
        elements, length, physicsMassPerLength=mass, physicsAxialStiffness=axial, physicsBendingStiffness=bending
    )
    random = np.random.default_rng(5)
    for node in beam.nodes:
        beam.mbs.SetNodeParameter(node, "initialVelocities", random.normal(scale=[1, 1, 1, 2, 2, 2]))
    beam.mbs.Assemble()
    at, weights = np.polynomial.legendre.leggauss(8)
    x, w = 0.5 * beam.element_length * (at + 1), 0.5 * beam.element_length * weights

    def energy() -> float:
        total = 0.0
        for cable in beam.cables:
            for position, weight in zip(x, w, strict=True):
                told = [
                    np.asarray(beam.mbs.GetObjectOutputBody(cable, variable, [position, 0, 0]))
                    for variable in (Variable.Velocity, Variable.StrainLocal, Variable.CurvatureLocal)
                ]
                factors = (mass, axial, bending)
                total += 0.5 * weight * sum(f * float(np.sum(v * v)) for f, v in zip(factors, told, strict=True))
        return total

    before = energy()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = 4000
    settings.timeIntegration.endTime = 0.4
    settings.timeIntegration.newton.relativeTolerance = 1e-10
    drift = []
    for _ in range(2):
        beam.mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.TrapezoidalIndex2, updateInitialValues=True)
        drift.append(abs(energy() / before - 1))
    assert max(drift) < 2e-4


@pytest.mark.parametrize("reduced", [0, 1, 2])
def test_arc_of_a_circle(reduced: int) -> None:
    """A curved reference configuration has moments, or none if its strains are free of stress; its curvature is that of the circle."""
    angle, stiffness = 0.3, 3.0
    moments = []
    for relative in (0.0, 1.0, 0.25):
        mbs = exu.SystemContainer().AddSystem()
        nodes = [
            mbs.AddNode(
                NodePointSlope1(
                    referenceCoordinates=[*(TURN @ [np.sin(s), 1 - np.cos(s), 0]), *(TURN @ [np.cos(s), np.sin(s), 0])]
                )
            )
            for s in (0, angle)
        ]
        cable = mbs.AddObject(
            ObjectANCFCable(
                physicsLength=angle,
                physicsBendingStiffness=stiffness,
                physicsAxialStiffness=1e3,
                strainIsRelativeToReference=relative,
                useReducedOrderIntegration=reduced,
                nodeNumbers=nodes,
            )
        )
        mbs.Assemble()
        middle = [angle / 2, 0, 0]
        moments.append(np.asarray(mbs.GetObjectOutputBody(cable, Variable.TorqueLocal, middle)))
        curvature = np.asarray(mbs.GetObjectOutputBody(cable, Variable.CurvatureLocal, middle))
        assert curvature == pytest.approx(TURN[:, 2], rel=1e-2, abs=1e-12)
    assert moments[0] == pytest.approx(stiffness * TURN[:, 2], rel=1e-2)
    assert moments[1] == pytest.approx(np.zeros(3), abs=1e-12)
    assert moments[2] == pytest.approx(0.75 * moments[0], rel=1e-12)


def test_markers_have_no_orientation() -> None:
    """A torque finds nothing to turn: markers with orientation are refused on cable and node."""
    for on_node in (False, True):
        beam = Beam(1, 1.0, physicsMassPerLength=1)
        marker = (
            exu.MarkerNodeRigid(nodeNumber=beam.nodes[0]) if on_node else MarkerBodyRigid(bodyNumber=beam.cables[0])
        )
        with pytest.raises(ValueError, match=r"not available|Orientation"):
            number = beam.mbs.AddMarker(marker)
            beam.mbs.AddLoad(Torque(markerNumber=number, loadVector=[0, 0, 1]))
            beam.mbs.Assemble()


@pytest.mark.parametrize("variable", ["RotationMatrix", "AngularVelocity", "VelocityLocal"])
def test_there_is_no_orientation(variable: str) -> None:
    beam = Beam(1, 1.0, physicsMassPerLength=1)
    marker = beam.mbs.AddMarker(MarkerBodyPosition(bodyNumber=beam.cables[0], localPosition=[0.5, 0, 0]))
    beam.mbs.Assemble()
    with pytest.raises(ValueError, match=rf"{variable}"):
        beam.mbs.GetObjectOutputBody(beam.cables[0], getattr(exu.OutputVariableType, variable), [0.5, 0, 0])
    with pytest.raises(ValueError, match=rf"{variable}"):
        beam.mbs.GetMarkerOutput(marker, getattr(exu.OutputVariableType, variable))


def test_position_marker_on_the_node() -> None:
    """A force on the node's position has the same effect as a force at the end of the element."""
    tips = []
    for on_node in (False, True):
        beam = Beam(2, 1.0, physicsBendingStiffness=2, physicsAxialStiffness=100)
        beam.clamp()
        if on_node:
            marker = beam.mbs.AddMarker(MarkerNodePosition(nodeNumber=beam.nodes[-1]))
            beam.mbs.AddLoad(Force(markerNumber=marker, loadVector=[1, 2, -1]))
        else:
            beam.push([1, 2, -1])
        beam.solve_static(2)
        tips.append(beam.tip())
    assert tips[0] == pytest.approx(tips[1], rel=1e-12)


@pytest.mark.parametrize(
    ("parameter", "value", "expected"),
    [("physicsLength", 0, "positive"), ("useReducedOrderIntegration", 3, "0, 1 or 2")],
)
def test_refused(parameter: str, value: float, expected: str) -> None:
    mbs = exu.SystemContainer().AddSystem()
    nodes = [mbs.AddNode(NodePointSlope1(referenceCoordinates=[x, 0, 0, 1, 0, 0])) for x in (0, 1)]
    mbs.AddObject(ObjectANCFCable(**{"physicsLength": 1, "nodeNumbers": nodes, parameter: value}))
    with pytest.raises(ValueError, match=expected) as error:
        mbs.Assemble()
    assert parameter in str(error.value)
    assert "ObjectANCFCable" in str(error.value)
