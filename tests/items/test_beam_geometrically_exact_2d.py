"""ObjectBeamGeometricallyExact2D, on two and on three nodes, against exact solutions of rods."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from test_ancf_cable_2d import ELASTICA

import dalembert as exu
from dalembert._core import testing

Variable = exu.OutputVariableType
each_degree = pytest.mark.parametrize("degree", [1, 2], ids=["linear", "quadratic"])


class Beam:
    """Elements of a polynomial degree through nodes at given points with given angles."""

    def __init__(self, degree: int, points: Any, angles: Any, length: float, **section: Any) -> None:
        self.mbs = mbs = exu.SystemContainer().AddSystem()
        places = zip(np.asarray(points), angles, strict=True)
        self.nodes = [mbs.AddNode(exu.NodeRigidBody2D(referenceCoordinates=[*r, a])) for r, a in places]
        self.elements = [
            mbs.AddObject(
                exu.ObjectBeamGeometricallyExact2D(
                    nodeNumbers=self.nodes[i : i + degree + 1], physicsLength=length, **section
                )
            )
            for i in range(0, len(self.nodes) - 1, degree)
        ]
        self.ground = mbs.AddMarker(
            exu.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(exu.NodePointGround()), coordinate=0)
        )

    @classmethod
    def straight(cls, degree: int, elements: int, length: float, **section: Any) -> Beam:
        x = np.linspace(0, length, degree * elements + 1)
        return cls(degree, np.column_stack([x, 0 * x]), 0 * x, length / elements, **section)

    def fix(self, node: Any, *coordinates: int) -> None:
        for coordinate in coordinates:
            marker = self.mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=coordinate))
            self.mbs.AddObject(exu.ObjectConnectorCoordinate(markerNumbers=[self.ground, marker]))

    def load(self, node: Any, force: Any = (0, 0), moment: float = 0.0) -> None:
        marker = self.mbs.AddMarker(exu.MarkerNodeRigid(nodeNumber=node))
        self.mbs.AddLoad(exu.LoadForceVector(markerNumber=marker, loadVector=[*force, 0]))
        self.mbs.AddLoad(exu.LoadTorqueVector(markerNumber=marker, loadVector=[0, 0, moment]))

    def solve_static(self, steps: int = 5) -> None:
        self.mbs.Assemble()
        settings = exu.SimulationSettings()
        settings.staticSolver.numberOfLoadSteps = steps
        settings.staticSolver.newton.relativeTolerance = 1e-10
        self.mbs.SolveStatic(settings, updateInitialValues=True)

    def tip(self, variable: Any = Variable.Displacement) -> np.ndarray:
        return np.asarray(self.mbs.GetNodeOutput(self.nodes[-1], variable))


def stiffnesses(axial: float, shear: float, bending: float) -> dict[str, float]:
    return {"physicsAxialStiffness": axial, "physicsShearStiffness": shear, "physicsBendingStiffness": bending}


@pytest.mark.parametrize(("degree", "order", "error"), [(1, 2, 6.3e-4), (2, 4, 7.5e-6)], ids=["linear", "quadratic"])
def test_elastica(degree: int, order: float, error: float) -> None:
    """A dead force across: errors fall with the square of the element length, and with its fourth power on three nodes."""
    length, stiffness, load = 2.0, 3.0, 5
    deflection, shortening, angle = ELASTICA[load]
    errors = []
    for elements in (4, 8) if degree == 2 else (8, 16):
        beam = Beam.straight(degree, elements, length, **stiffnesses(1e7, 1e7, stiffness))
        beam.fix(beam.nodes[0], 0, 1, 2)
        beam.load(beam.nodes[-1], [0, load * stiffness / length**2])
        beam.solve_static(10)
        wanted = [-shortening * length, deflection * length, angle]
        told = [*beam.tip()[:2], beam.tip(Variable.Rotation)[2]]
        errors.append(float(np.linalg.norm(np.subtract(told, wanted))) / length)
    assert np.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.2)
    assert errors[1] == pytest.approx(error, rel=0.3)


# K. Nachbagauer et al., 2011 and 2013: short cantilever under a dead force across, displacement along and across.
SHORT = {5e5: (1.88847418e-7, 8.09900305e-4), 5e8: (0.15097103, 0.71056837)}


@pytest.mark.parametrize("load", list(SHORT))
def test_short_cantilever_with_shear(load: float) -> None:
    height, width, young, poisson = 0.5, 0.1, 2.07e11, 0.3
    correction = 10 * (1 + poisson) / (12 + 11 * poisson)
    area = height * width
    shear = correction * area * young / (2 * (1 + poisson))
    section = stiffnesses(young * area, shear, young * width * height**3 / 12)
    beam = Beam.straight(2, 32, 2.0, **section)
    beam.fix(beam.nodes[0], 0, 1, 2)
    beam.load(beam.nodes[-1], [0, -load * height**3])
    beam.solve_static(10)
    assert -beam.tip()[:2] == pytest.approx(SHORT[load], rel=1e-5)  # of finite elements themselves


@each_degree
def test_roll_up(degree: int) -> None:
    """The moment 2 pi EI / L bends the beam into a full circle: its angle is exact, on two nodes the polygon closes, too."""
    length, stiffness, elements = 3.0, 2.0, 24
    beam = Beam.straight(degree, elements, length, **stiffnesses(1e6, 1e6, stiffness))
    beam.fix(beam.nodes[0], 0, 1, 2)
    beam.load(beam.nodes[-1], moment=2 * np.pi * stiffness / length)
    beam.solve_static(10)
    assert beam.tip(Variable.Rotation)[2] == pytest.approx(2 * np.pi, rel=1e-7)
    assert beam.tip(Variable.Position)[:2] == pytest.approx([0, 0], abs=1e-6 if degree == 1 else 1e-3)
    moment = beam.mbs.GetObjectOutputBody(beam.elements[3], Variable.TorqueLocal, [0.01, 0, 0])
    assert np.asarray(moment) == pytest.approx([0, 0, 2 * np.pi * stiffness / length], rel=1e-7)


def frequencies(beam: Beam, count: int) -> np.ndarray:
    beam.mbs.Assemble()
    state = testing.State(beam.mbs)
    stiffness = testing.tangent(beam.mbs, state, cq=1, cv=0, ca=0)
    mass = testing.mass_matrix(beam.mbs, state)
    free = np.arange(3, len(mass))  # the first node is clamped
    values = np.linalg.eigvals(np.linalg.solve(mass[np.ix_(free, free)], stiffness[np.ix_(free, free)]))
    return np.sqrt(np.sort(values.real)[:count]) / (2 * np.pi)


def test_frequencies_of_a_cantilever() -> None:
    """Timoshenko: E = 2.1e11, density 7850, Poisson ratio 0.3, shear factor 5/6, 1 m by 0.1 m by 0.1 m."""
    area, young = 0.01, 2.1e11
    section = stiffnesses(young * area, 5 / 6 * area * young / 2.6, young * 1e-4 / 12)
    mass = {"physicsMassPerLength": 7850 * area, "physicsCrossSectionInertia": 7850 * 1e-4 / 12}
    found = frequencies(Beam.straight(2, 24, 1.0, **section, **mass), 5)
    bending = found[np.abs(found - np.sqrt(young / 7850) / 4) > 1]  # the other one stretches
    assert bending[:4] == pytest.approx([82.89436, 496.81453, 1306.69807, 2370.30841], rel=1e-4)


# A free beam from (6, 0) to (0, 8) under a force and a moment at its first end: positions of both ends (a rod of degree 12).
SPAGHETTI = {
    2.5: (8.51245, 6.26851, -0.09514, 4.08832),
    5: (11.96529, -0.88323, 14.76871, 8.64959),
    10: (33.01535, 9.01258, 32.80606, -1.00917),
}


@pytest.mark.parametrize("end", list(SPAGHETTI))
def test_flying_spaghetti(end: float) -> None:
    elements, angle = 20, np.arctan2(8, -6)
    x = np.linspace(0, 1, 2 * elements + 1)[:, None]
    beam = Beam(
        2,
        (1 - x) * [6, 0] + x * [0, 8],
        np.full(len(x), angle),
        10 / elements,
        physicsMassPerLength=1,
        physicsCrossSectionInertia=10,
        includeReferenceRotations=True,
        **stiffnesses(1e4, 1e4, 500),
    )
    mbs = beam.mbs

    def pulse(t: float) -> float:
        return max(0.0, min(t, 5 - t)) / 2.5

    marker = mbs.AddMarker(exu.MarkerNodeRigid(nodeNumber=beam.nodes[0]))
    mbs.AddLoad(
        exu.LoadForceVector(
            markerNumber=marker,
            loadVector=[16, 0, 0],
            loadVectorUserFunction=lambda _, t, v: [pulse(t) * v[0], 0, 0],
        )
    )
    mbs.AddLoad(
        exu.LoadTorqueVector(
            markerNumber=marker,
            loadVector=[0, 0, 160],
            loadVectorUserFunction=lambda _, t, v: [0, 0, pulse(t) * v[2]],
        )
    )
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime = end
    settings.timeIntegration.numberOfSteps = int(200 * end)
    mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.TrapezoidalIndex2)
    ends = [*beam.mbs.GetNodeOutput(beam.nodes[0], Variable.Position)[:2], *beam.tip(Variable.Position)[:2]]
    assert ends == pytest.approx(SPAGHETTI[end], abs=2e-3)


@each_degree
@pytest.mark.parametrize("turned", [False, True], ids=["from the axis", "from the nodes"])
def test_arc_without_stress(degree: int, turned: bool) -> None:
    """A curved reference configuration with the angles of the arc and its curvature has no moments, and little else."""
    radius, elements = 2.0, 6
    angles = np.linspace(0, 1.2, degree * elements + 1)
    points = radius * np.column_stack([np.sin(angles), 1 - np.cos(angles)])
    beam = Beam(
        degree,
        points,
        angles,
        radius * 1.2 / elements,
        physicsReferenceCurvature=1 / radius,
        includeReferenceRotations=turned,
        **stiffnesses(1.0, 1.0, 1.0),
    )
    beam.mbs.Assemble()
    point = radius * 1.2 / elements / np.sqrt(12) if degree == 2 else 0.0  # of integration
    strain = beam.mbs.GetObjectOutputBody(beam.elements[2], Variable.StrainLocal, [point, 0, 0])
    moment = beam.mbs.GetObjectOutputBody(beam.elements[2], Variable.TorqueLocal, [point, 0, 0])
    assert np.asarray(moment) == pytest.approx([0, 0, 0], abs=1e-13)
    assert np.abs(strain).max() < (2e-3 if degree == 1 else 2e-4)
    angle = beam.mbs.GetObjectOutputBody(beam.elements[2], Variable.Rotation, [0, 0, 0])
    assert angle[2] == pytest.approx(0.5, abs=1e-12)


def test_tangent_on_three_nodes() -> None:
    points = [[0, 0], [0.5, 0.1], [1.1, 0.05]]
    damping = {"physicsAxialDamping": 2, "physicsShearDamping": 1.5, "physicsBendingDamping": 0.7}
    beam = Beam(
        2, points, [0.1, 0.2, -0.1], 1.1, physicsMassPerLength=2, physicsCrossSectionInertia=0.3, **damping,
        **stiffnesses(30, 20, 5),
    )  # fmt: skip
    beam.mbs.Assemble()
    state, random = testing.State(beam.mbs), np.random.default_rng(3)
    state.q, state.v, state.a = random.normal(size=(3, 9))
    weights = {"cq": 0.7, "cv": 1.3, "ca": 2.0}
    tangent, by_differences = testing.tangent(beam.mbs, state, **weights), np.zeros((9, 9))
    h = 1e-6
    for i in range(9):
        ends = []
        for sign in (1, -1):
            s = state.copy()
            for name, weight in (("q", 0.7), ("v", 1.3), ("a", 2.0)):
                values = np.array(getattr(s, name))
                values[i] += sign * h * weight
                setattr(s, name, values)
            ends.append(testing.residual(beam.mbs, s))
        by_differences[:, i] = (ends[0] - ends[1]) / (2 * h)
    assert tangent == pytest.approx(by_differences, abs=1e-7)


@pytest.mark.parametrize(
    ("nodes", "length", "expected"),
    [(4, 1.0, r"nodeNumbers.*4 nodes.*two or three"), (1, 1.0, r"nodeNumbers"), (2, 0.0, r"physicsLength.*positive")],
)
def test_refused(nodes: int, length: float, expected: str) -> None:
    mbs = exu.SystemContainer().AddSystem()
    numbers = [mbs.AddNode(exu.NodeRigidBody2D(referenceCoordinates=[x, 0, 0])) for x in range(nodes)]
    with pytest.raises(ValueError, match=expected):
        mbs.AddObject(exu.ObjectBeamGeometricallyExact2D(nodeNumbers=numbers, physicsLength=length))
        mbs.Assemble()
