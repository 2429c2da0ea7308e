"""ObjectANCFCable2D against closed-form beam theory."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

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
    Torque,
)

Variable = exu.OutputVariableType


class Beam:
    """A straight beam along x, of equal elements."""

    def __init__(self, elements: int, length: float, **parameters: Any) -> None:
        self.mbs = mbs = exu.SystemContainer().AddSystem()
        x = np.linspace(0, length, elements + 1)
        self.element_length = length / elements
        self.nodes = [mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[at, 0, 1, 0])) for at in x]
        self.cables = [
            mbs.AddObject(Cable2D(physicsLength=self.element_length, nodeNumbers=list(pair), **parameters))
            for pair in zip(self.nodes[:-1], self.nodes[1:], strict=True)
        ]

    def clamp(self, node: int = 0, coordinates: tuple[int, ...] = (0, 1, 3)) -> None:
        mbs = self.mbs
        ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
        for coordinate in coordinates:
            marker = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=self.nodes[node], coordinate=coordinate))
            mbs.AddObject(CoordinateConstraint(markerNumbers=[ground, marker]))

    def solve_static(self, steps: int) -> None:
        self.mbs.Assemble()
        settings = exu.SimulationSettings()
        settings.staticSolver.numberOfLoadSteps = steps
        settings.staticSolver.newton.relativeTolerance = 1e-10
        self.mbs.SolveStatic(settings)

    def tip(self, variable: Any) -> np.ndarray:
        return np.asarray(self.mbs.GetNodeOutput(self.nodes[-1], variable))


ELASTICA = {  # load P L^2 / EI: deflection w / L, shortening u / L, angle; inextensible
    1: (0.3017207738, 0.0564332363, 0.4613519497),
    2: (0.4934574804, 0.1606417208, 0.7817498316),
    5: (0.7137915236, 0.3876283607, 1.2153681176),
    10: (0.8106090249, 0.5549955978, 1.4302855388),
}


@pytest.mark.parametrize("load", list(ELASTICA))
def test_elastica(load: int) -> None:
    length, stiffness = 2.0, 3.0
    beam = Beam(64, length, physicsBendingStiffness=stiffness, physicsAxialStiffness=1e7 * stiffness)
    beam.clamp()
    tip = beam.mbs.AddMarker(MarkerNodePosition(nodeNumber=beam.nodes[-1]))
    beam.mbs.AddLoad(Force(markerNumber=tip, loadVector=[0, load * stiffness / length**2, 0]))
    beam.solve_static(10)
    deflection, shortening, angle = ELASTICA[load]
    displacement = beam.tip(Variable.Displacement)
    assert displacement[1] / length == pytest.approx(deflection, rel=1e-5)
    assert displacement[0] / length == pytest.approx(-shortening, rel=1e-5)
    end = beam.mbs.GetObjectOutputBody(beam.cables[-1], Variable.Rotation, [beam.element_length, 0, 0])
    assert float(end) == pytest.approx(angle, rel=1e-5)


@pytest.mark.parametrize("reduced", [0, 1, 2])
def test_roll_up(reduced: int) -> None:
    length, stiffness = 2.0, 3.0
    beam = Beam(
        16, length, physicsBendingStiffness=stiffness, physicsAxialStiffness=1e5, useReducedOrderIntegration=reduced
    )
    beam.clamp()
    tip = beam.mbs.AddMarker(MarkerBodyRigid(bodyNumber=beam.cables[-1], localPosition=[beam.element_length, 0, 0]))
    moment = 2 * np.pi * stiffness / length
    beam.mbs.AddLoad(Torque(markerNumber=tip, loadVector=[0, 0, moment]))
    beam.solve_static(20)
    assert beam.tip(Variable.Displacement) == pytest.approx([-length, 0, 0], abs=2e-3 * length)
    middle = [beam.element_length / 2, 0, 0]
    assert float(beam.mbs.GetObjectOutputBody(beam.cables[4], Variable.TorqueLocal, middle)) == pytest.approx(
        moment, rel=8e-3
    )
    curvature = beam.mbs.GetObjectOutputBody(beam.cables[4], Variable.CurvatureLocal, middle)
    assert float(curvature) == pytest.approx(2 * np.pi / length, rel=8e-3)


def test_free_free_beam() -> None:
    """Three rigid body motions, then the frequencies of a free beam; axial modes lie far above."""
    length, stiffness, mass = 2.0, 3.0, 0.7
    beam = Beam(16, length, physicsMassPerLength=mass, physicsBendingStiffness=stiffness, physicsAxialStiffness=1e7)
    beam.mbs.Assemble()
    values, *_ = beam.mbs.ComputeODE2Eigenvalues()
    frequencies = np.sqrt(np.abs(np.sort(np.asarray(values).real)))
    roots = np.array([4.730040744862704, 7.853204624095838, 10.99560783800167])
    expected = (roots / length) ** 2 * np.sqrt(stiffness / mass)
    assert frequencies[:3] == pytest.approx(0, abs=1e-2)
    assert frequencies[3:6] == pytest.approx(expected, rel=2e-4)


def test_sagging_cable() -> None:
    """A beam under its own weight, hinged at both ends: the reactions of gravity and the deflection of a stiff beam."""
    length, stiffness, mass, gravity = 1.0, 1e4, 2.0, 9.81
    beam = Beam(8, length, physicsMassPerLength=mass, physicsBendingStiffness=stiffness, physicsAxialStiffness=1e8)
    beam.clamp(0, (0, 1))
    beam.clamp(-1, (1,))
    for cable in beam.cables:
        marker = beam.mbs.AddMarker(MarkerBodyMass(bodyNumber=cable))
        beam.mbs.AddLoad(LoadMassProportional(markerNumber=marker, loadVector=[0, -gravity, 0]))
    beam.solve_static(1)
    middle = beam.mbs.GetNodeOutput(beam.nodes[4], Variable.Displacement)[1]
    assert middle == pytest.approx(-5 * mass * gravity * length**4 / (384 * stiffness), rel=1e-5)


def test_reference_strain_and_curvature() -> None:
    """A beam without loads takes the strain and the curvature of zero force."""
    length, strain, curvature = 2.0, 0.01, 0.5
    beam = Beam(
        8,
        length,
        physicsBendingStiffness=3,
        physicsAxialStiffness=1e3,
        physicsReferenceAxialStrain=strain,
        physicsReferenceCurvature=curvature,
    )
    beam.clamp()
    beam.solve_static(4)
    radius = (1 + strain) / curvature
    angle = curvature * length
    expected = [radius * np.sin(angle), radius * (1 - np.cos(angle)), 0]
    assert beam.tip(Variable.Position) == pytest.approx(expected, abs=1e-4)
    local = [beam.element_length / 2, 0, 0]
    assert float(beam.mbs.GetObjectOutputBody(beam.cables[3], Variable.TorqueLocal, local)) == pytest.approx(
        0, abs=1e-3
    )


def bent(relative: float) -> float:
    """The moment in an element that is curved in its reference configuration."""
    mbs = exu.SystemContainer().AddSystem()
    angle = 0.3
    nodes = [
        mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[np.sin(s), 1 - np.cos(s), np.cos(s), np.sin(s)]))
        for s in (0, angle)
    ]
    cable = mbs.AddObject(
        Cable2D(
            physicsLength=angle,
            physicsBendingStiffness=3,
            physicsAxialStiffness=1e3,
            strainIsRelativeToReference=relative,
            nodeNumbers=nodes,
        )
    )
    mbs.Assemble()
    return float(mbs.GetObjectOutputBody(cable, Variable.TorqueLocal, [angle / 2, 0, 0]))


def test_strain_relative_to_reference() -> None:
    assert bent(0) == pytest.approx(3, rel=1e-2)
    assert bent(1) == pytest.approx(0, abs=1e-12)
    assert bent(0.25) == pytest.approx(0.75 * bent(0), rel=1e-12)


def test_point_of_the_cross_section() -> None:
    """Motion of a point off the axis is that of a rigid cross section."""
    mbs = exu.SystemContainer().AddSystem()
    velocities = [[1, 2, 0, 0.5], [1, 2.5, 0, 0.5]]
    nodes = [
        mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0], initialVelocities=v))
        for x, v in zip((0, 1), velocities, strict=True)
    ]
    cable = mbs.AddObject(Cable2D(physicsLength=1, physicsMassPerLength=1, nodeNumbers=nodes))
    mbs.Assemble()

    def output(variable: Any) -> np.ndarray:
        return np.asarray(mbs.GetObjectOutputBody(cable, variable, [0.25, 0.1, 0]))

    assert output(Variable.Position) == pytest.approx([0.25, 0.1, 0])
    assert output(Variable.AngularVelocity) == pytest.approx([0, 0, 0.5])
    assert output(Variable.Velocity) == pytest.approx([1 - 0.1 * 0.5, 2.125, 0])
    assert output(Variable.Director1) == pytest.approx([1, 0, 0])


def test_user_functions_replace_the_linear_laws() -> None:
    def swing(**functions: Any) -> np.ndarray:
        beam = Beam(
            2,
            1.0,
            physicsMassPerLength=1,
            physicsBendingStiffness=2,
            physicsBendingDamping=0.05,
            physicsAxialStiffness=1e3,
            physicsAxialDamping=2,
            **functions,
        )
        beam.clamp()
        tip = beam.mbs.AddMarker(MarkerBodyPosition(bodyNumber=beam.cables[-1], localPosition=[0.5, 0, 0]))
        beam.mbs.AddLoad(Force(markerNumber=tip, loadVector=[0, -1, 0]))
        beam.mbs.Assemble()
        settings = exu.SimulationSettings()
        settings.timeIntegration.numberOfSteps = 50
        settings.timeIntegration.endTime = 0.5
        beam.mbs.SolveDynamic(settings)
        return beam.tip(Variable.Position)

    def force(
        mbs: Any, t: float, item: int, x: float, e: float, e_t: float, e_0: float, k: float, d: float, *_: float
    ) -> float:
        return k * (e - e_0) + d * e_t

    plain = swing()
    assert plain[1] < -0.05
    assert swing(axialForceUserFunction=force) == pytest.approx(plain, abs=1e-7)
    assert swing(bendingMomentUserFunction=force) == pytest.approx(plain, abs=1e-7)


@pytest.mark.parametrize(
    ("parameter", "value", "expected"),
    [("physicsLength", 0, "positive"), ("useReducedOrderIntegration", 3, "0, 1 or 2")],
)
def test_refused(parameter: str, value: float, expected: str) -> None:
    mbs = exu.SystemContainer().AddSystem()
    nodes = [mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0])) for x in (0, 1)]
    mbs.AddObject(Cable2D(**{"physicsLength": 1, "nodeNumbers": nodes, parameter: value}))
    with pytest.raises(ValueError, match=expected) as error:
        mbs.Assemble()
    assert parameter in str(error.value)
    assert "ObjectANCFCable2D" in str(error.value)
