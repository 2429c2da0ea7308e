"""ObjectBeamGeometricallyExact against exact solutions of rods, on nodes with all kinds of rotation coordinates."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.spatial.transform import Rotation
from test_ancf_cable_2d import ELASTICA

import dalembert as exu
from dalembert._core import testing
from dalembert.itemInterface import (
    Force,
    GenericJoint,
    LoadMassProportional,
    MarkerBodyMass,
    MarkerBodyRigid,
    MarkerNodeRigid,
    NodeRigidBodyEP,
    NodeRigidBodyRotVecLG,
    NodeRigidBodyRxyz,
    ObjectBeamGeometricallyExact,
    ObjectGround,
    Torque,
)

Variable = exu.OutputVariableType
NODES = {"EP": NodeRigidBodyEP, "Rxyz": NodeRigidBodyRxyz, "RotVecLG": NodeRigidBodyRotVecLG}
each_node = pytest.mark.parametrize("kind", list(NODES))
TURN = Rotation.from_rotvec([0.4, -1.1, 0.7]).as_matrix()


def coordinates(kind: str, position: Any, rotation: Any) -> np.ndarray:
    """Position and rotation coordinates of a node type."""
    turn = Rotation.from_matrix(rotation)
    rotation_coordinates = {
        "EP": lambda: turn.as_quat()[[3, 0, 1, 2]],
        "Rxyz": lambda: turn.as_euler("XYZ"),
        "RotVecLG": turn.as_rotvec,
    }[kind]()
    return np.concatenate([position, rotation_coordinates])


def section(stiffness: Any, mass: float = 0.0, inertia: Any = (0.0, 0.0, 0.0), damping: Any = None) -> Any:
    made = exu.BeamSection()
    made.stiffnessMatrix = np.diag(stiffness)
    made.massPerLength, made.inertia = mass, np.diag(inertia)
    if damping is not None:
        made.dampingMatrix = np.diag(damping)
    return made


class Beam:
    """Elements along given frames (positions and rotations), on nodes of one kind."""

    def __init__(self, kind: str, frames: Any, length: float, of: Any) -> None:
        self.mbs = mbs = exu.SystemContainer().AddSystem()
        self.nodes = [mbs.AddNode(NODES[kind](referenceCoordinates=coordinates(kind, r, a))) for r, a in frames]
        self.beams = [
            mbs.AddObject(ObjectBeamGeometricallyExact(physicsLength=length, sectionData=of, nodeNumbers=list(pair)))
            for pair in pairwise(self.nodes)
        ]
        self.rotations = [a for _, a in frames]

    @classmethod
    def straight(cls, kind: str, elements: int, length: float, of: Any, turn: Any = None) -> Beam:
        turn = np.eye(3) if turn is None else turn
        frames = [(turn @ [x, 0, 0], turn) for x in np.linspace(0, length, elements + 1)]
        return cls(kind, frames, length / elements, of)

    def clamp(self) -> None:
        ground = self.mbs.AddMarker(MarkerBodyRigid(bodyNumber=self.mbs.AddObject(ObjectGround())))
        root = self.mbs.AddMarker(MarkerNodeRigid(nodeNumber=self.nodes[0]))
        axes = self.rotations[0]
        self.mbs.AddObject(GenericJoint(markerNumbers=[ground, root], rotationMarker0=axes))

    def load(self, load_type: Any, vector: Any) -> None:
        tip = self.mbs.AddMarker(MarkerNodeRigid(nodeNumber=self.nodes[-1]))
        self.mbs.AddLoad(load_type(markerNumber=tip, loadVector=vector))

    def solve_static(self, steps: int, tolerance: float = 1e-10) -> None:
        self.mbs.Assemble()
        settings = exu.SimulationSettings()
        settings.staticSolver.numberOfLoadSteps = steps
        settings.staticSolver.newton.relativeTolerance = tolerance
        self.mbs.SolveStatic(settings, updateInitialValues=True)

    def tip(self, variable: Any = Variable.Displacement) -> np.ndarray:
        return np.asarray(self.mbs.GetNodeOutput(self.nodes[-1], variable))


@each_node
@pytest.mark.parametrize("elements", [2, 5])
def test_circle(kind: str, elements: int) -> None:
    """A moment bends any number of elements exactly into an arc, here of a third of a circle, out of the coordinate planes."""
    length, stiffness, angle = 2.0, 3.0, 2 * np.pi / 3
    beam = Beam.straight(kind, elements, length, section([1e3, 500, 400, 2, 5, stiffness]), TURN)
    beam.clamp()
    beam.load(Torque, TURN @ [0, 0, angle * stiffness / length])
    beam.solve_static(6)
    radius = length / angle
    expected = TURN @ [radius * np.sin(angle), radius * (1 - np.cos(angle)), 0]
    assert beam.tip(Variable.Position) == pytest.approx(expected, abs=1e-8)
    curvature = beam.mbs.GetObjectOutputBody(beam.beams[0], Variable.CurvatureLocal, [0, 0, 0])
    assert np.asarray(curvature) == pytest.approx([0, 0, angle / length], abs=1e-8)
    middle = beam.mbs.GetObjectOutputBody(beam.beams[0], Variable.Position, [0, 0.1, 0])
    half = angle / (2 * elements)
    wanted = TURN @ [(radius - 0.1) * np.sin(half), radius - (radius - 0.1) * np.cos(half), 0]
    assert np.asarray(middle) == pytest.approx(wanted, abs=1e-8)


def test_strains_of_simple_loads() -> None:
    """Tension, shear and torsion have strain outputs force by stiffness."""
    length, stiffness = 0.5, np.array([1e3, 500, 400, 2, 500, 600])
    beam = Beam.straight("EP", 1, length, section(stiffness))
    beam.clamp()
    beam.load(Force, [2, 0, 0])
    beam.load(Torque, [0.1, 0, 0])
    beam.solve_static(1)
    strain = np.asarray(beam.mbs.GetObjectOutputBody(beam.beams[0], Variable.StrainLocal, [0, 0, 0]))
    assert strain == pytest.approx([2e-3, 0, 0, 0, 0, 0], abs=1e-10)
    curvature = np.asarray(beam.mbs.GetObjectOutputBody(beam.beams[0], Variable.CurvatureLocal, [0, 0, 0]))
    assert curvature == pytest.approx([0.05, 0, 0], abs=1e-10)


def elastica_errors(kind: str, load: int, meshes: tuple[int, ...]) -> list[float]:
    length, stiffness, side = 2.0, 3.0, np.array([0, 0.6, -0.8])
    deflection, shortening, _ = ELASTICA[load]
    errors = []
    for elements in meshes:
        beam = Beam.straight(kind, elements, length, section([1e6, 1e6, 1e6, 5, stiffness, stiffness]))
        beam.clamp()
        beam.load(Force, load * stiffness / length**2 * side)
        beam.solve_static(10)
        wanted = length * (deflection * side - [shortening, 0, 0])
        errors.append(float(np.linalg.norm(beam.tip() - wanted)) / length)
    return errors


@each_node
def test_elastica_converges_with_the_square(kind: str) -> None:
    errors = elastica_errors(kind, 5, (4, 8, 16))
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert orders == pytest.approx([2, 2], abs=0.2)
    assert errors[-1] < 2e-3


# Tip displacements (x, y, z) of a clamped arc of 45 degrees, radius 100, under a force across its plane: solutions of the rod's
# differential equations, to all digits.
BEND = {
    300: (-11.9323642572, -7.0449803355, 40.1932664427),
    600: (-23.5612967857, -13.6050230096, 53.4761081403),
}


def bend(kind: str, elements: int, force: float) -> np.ndarray:
    angles = np.linspace(0, np.pi / 4, elements + 1)
    frames = [
        (100 * np.array([np.sin(a), 1 - np.cos(a), 0]), Rotation.from_rotvec([0, 0, a]).as_matrix()) for a in angles
    ]
    stiffness = [1e7, 41.6667e5, 41.6667e5, 8.333e5, 8.333e5, 8.333e5]
    beam = Beam(kind, frames, 100 * np.pi / 4 / elements, section(stiffness))
    beam.clamp()
    beam.load(Force, [0, 0, force])
    beam.solve_static(20, 1e-8)
    return beam.tip()


@each_node
@pytest.mark.parametrize("force", list(BEND))
def test_bathe_bend(kind: str, force: float) -> None:
    """The reference configuration is curved, and free of stress."""
    errors = [float(np.linalg.norm(bend(kind, elements, force) - BEND[int(force)])) for elements in (8, 16)]
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2, abs=0.1)
    assert errors[1] < 1e-3 * 60


# Tip displacements in mm (axial, in the stiff and in the soft direction) of the Princeton beam, 0.508 m long, by load in N and its angle
# bending about the stiff direction: solutions of the rod's differential equations, to all digits.
PRINCETON = {
    (8.896, 0): (-0.1355343, 10.7135971, 0),
    (8.896, 30): (-7.6599334, 10.1455436, 79.4516879),
    (8.896, 45): (-14.3877697, 8.8873962, 109.0358771),
    (8.896, 60): (-20.4710889, 6.6532875, 129.9170624),
    (8.896, 90): (-26.0216815, 0, 146.2530396),
    (13.345, 0): (-0.3047078, 16.0624258, 0),
    (13.345, 30): (-17.1614704, 16.7752345, 117.8959888),
    (13.345, 45): (-30.3580555, 15.3398470, 156.5803966),
    (13.345, 60): (-41.2025865, 11.7146494, 181.9132980),
    (13.345, 90): (-50.4013592, 0, 200.6848179),
}


@pytest.mark.parametrize(("load", "angle"), list(PRINCETON))
def test_princeton_beam(load: float, angle: float) -> None:
    """Errors decrease with the square of the element length, so that two meshes give the limit."""
    stiffness = [2842069.442616, 903966.107702, 903966.107702, 3.1035479832842, 2.4288718041122, 36.285519395400]
    tips = []
    for elements in (12, 24):
        beam = Beam.straight("RotVecLG", elements, 0.508, section(stiffness))
        beam.clamp()
        beam.load(Force, load * np.array([0, np.cos(np.radians(angle)), np.sin(np.radians(angle))]))
        beam.solve_static(5)
        tips.append(1e3 * beam.tip())
    wanted = np.array(PRINCETON[load, angle])
    errors = [float(np.linalg.norm(tip - wanted)) for tip in tips]
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2, abs=0.1)
    assert (4 * tips[1] - tips[0]) / 3 == pytest.approx(wanted, abs=5e-3)


@each_node
@pytest.mark.parametrize(("side", "published"), [(1, 1.754e-3), (2, 5.424e-3)])
def test_twisted_beam(kind: str, side: int, published: float) -> None:
    """A cantilever twisted by a right angle when it is made (R. H. MacNeal, R. L. Harder, 1985), under a small force at its tip: the flexibility of
    its sections is that of a rectangle that turns along the axis, integrated. Published values, of solids, differ from rods by 3e-3 at most."""
    length, width, depth, young, poisson, force = 12.0, 1.1, 0.32, 29e6, 0.22, 1.0
    shear = 5 / 6 * young / (2 * (1 + poisson)) * width * depth
    soft, stiff = young * width * depth**3 / 12, young * depth * width**3 / 12
    stiffness = [young * width * depth, shear, shear, 1e6, soft, stiff]

    def flexibility(x: float) -> float:
        turn = np.pi / 2 * x / length
        share = np.sin(turn) ** 2 if side == 1 else np.cos(turn) ** 2  # about the soft axis
        return (length - x) ** 2 * (share / soft + (1 - share) / stiff) + 1 / shear

    exact = force * quad(flexibility, 0, length, epsabs=0, epsrel=1e-12)[0]
    tips = []
    for elements in (16, 32):
        places = np.linspace(0, 1, elements + 1)
        frames = [
            (np.array([length * s, 0, 0]), Rotation.from_rotvec([np.pi / 2 * s, 0, 0]).as_matrix()) for s in places
        ]
        beam = Beam(kind, frames, length / elements, section(stiffness))
        beam.clamp()
        beam.load(Force, force * np.eye(3)[side])
        beam.solve_static(1)
        tips.append(beam.tip()[side])
    errors = [abs(tip / exact - 1) for tip in tips]
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2, abs=0.1)
    assert (4 * tips[1] - tips[0]) / 3 == pytest.approx(exact, rel=5e-6)  # its error falls with the fourth power
    assert exact == pytest.approx(published, rel=3e-3)


@each_node
def test_rigid_motion_causes_no_strain(kind: str) -> None:
    """Forces of a deformed element rotate with it, and its local outputs remain."""
    random = np.random.default_rng(3)
    of = section([1e3, 500, 400, 2, 5, 3])
    ends = [
        (np.zeros(3), Rotation.from_rotvec(0.4 * random.normal(size=3)).as_matrix()),
        (np.array([1.1, 0.2, -0.1]), Rotation.from_rotvec(0.4 * random.normal(size=3)).as_matrix()),
    ]
    told = []
    for place in (np.eye(3), TURN, Rotation.from_rotvec([2.0, 1.0, -0.5]).as_matrix()):
        beam = Beam.straight(kind, 1, 1.0, of)
        for node, (r, a), start in zip(beam.nodes, ends, ([0, 0, 0], [1, 0, 0]), strict=True):
            change = coordinates(kind, place @ r + [1, 2, 3], place @ a) - coordinates(kind, np.array(start), np.eye(3))
            beam.mbs.SetNodeParameter(node, "initialCoordinates", change)
        beam.mbs.Assemble()
        state = testing.State(beam.mbs)
        n = len(state.q) // 2
        forces = [place.T @ testing.residual(beam.mbs, state)[n * i : n * i + 3] for i in range(2)]
        outputs = [
            np.asarray(beam.mbs.GetObjectOutputBody(beam.beams[0], v, [0.1, 0, 0]))
            for v in (Variable.StrainLocal, Variable.CurvatureLocal)
        ]
        told.append(np.concatenate([*forces, *outputs]))
    assert np.abs(told[0]).max() > 100
    for others in told[1:]:
        assert others == pytest.approx(told[0], abs=1e-10)


@each_node
def test_free_free_beam(kind: str) -> None:
    """Frequencies of a slender free beam; shear and rotary inertia are negligible."""
    length, stiffness, mass = 2.0, 3.0, 0.7
    inertia = 1e-7 * np.ones(3)
    beam = Beam.straight(kind, 64, length, section([1e6, 1e6, 1e6, 1e3, stiffness, stiffness], mass, inertia))
    beam.mbs.Assemble()
    values, *_ = beam.mbs.ComputeODE2Eigenvalues()
    frequencies = np.sort(np.sqrt(np.abs(np.asarray(values).real)))
    bending = np.sort(frequencies[frequencies > 1.0])[:4]
    roots = np.repeat([4.730040744862704, 7.853204624095838], 2)
    assert bending == pytest.approx((roots / length) ** 2 * np.sqrt(stiffness / mass), rel=4e-3)


def swing(kind: str, damping: Any = None, steps: int = 200, solver: str = "GeneralizedAlpha") -> Beam:
    """A clamped beam that falls and is pushed aside and twisted."""
    of = section([300, 200, 200, 0.5, 0.6, 0.8], 0.8, [2e-2, 1e-2, 1e-2], damping)
    beam = Beam.straight(kind, 4, 1.0, of)
    if solver == "GeneralizedAlpha":
        beam.clamp()
    for element in beam.beams:
        weight = beam.mbs.AddMarker(MarkerBodyMass(bodyNumber=element))
        beam.mbs.AddLoad(LoadMassProportional(markerNumber=weight, loadVector=[0, -9.81, 0]))
    beam.load(Force, [0, 0, 0.5])
    beam.load(Torque, [0.3, 0, 0])
    beam.mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.endTime = 0.4
    settings.timeIntegration.newton.relativeTolerance = 1e-9
    beam.mbs.SolveDynamic(settings, solverType=getattr(exu.DynamicSolverType, solver))
    return beam


@pytest.mark.parametrize("damping", [None, [1, 1, 1, 0.02, 0.02, 0.02]], ids=["elastic", "damped"])
def test_motion_does_not_depend_on_rotation_coordinates(damping: Any) -> None:
    tips = {kind: swing(kind, damping, 800).tip() for kind in NODES}
    assert np.linalg.norm(tips["EP"]) > 0.3
    for kind in ("Rxyz", "RotVecLG"):
        assert tips[kind] == pytest.approx(tips["EP"], abs=2e-4)


@pytest.mark.parametrize("kind", ["Rxyz", "RotVecLG"])
def test_explicit_solver(kind: str) -> None:
    explicit, implicit = (swing(kind, steps=4000, solver=solver) for solver in ("RK44", "TrapezoidalIndex2"))
    assert explicit.tip() == pytest.approx(implicit.tip(), abs=1e-5)


def test_energy_is_kept() -> None:
    """A thrown, free beam without loads: kinetic and strain energy together stay, but for the order of the trapezoidal rule."""
    stiffness, mass, inertia = np.array([300, 200, 200, 0.5, 0.6, 0.8]), 0.8, np.array([2e-2, 1e-2, 1e-2])
    beam = Beam.straight("RotVecLG", 3, 0.9, section(stiffness, mass, inertia))
    random = np.random.default_rng(7)
    for node in beam.nodes:
        beam.mbs.SetNodeParameter(node, "initialVelocities", random.normal(scale=1.0, size=6))
    beam.mbs.Assemble()

    def energy() -> float:
        total = 0.0
        for i, node in enumerate(beam.nodes):
            share = 0.3 if 0 < i < len(beam.nodes) - 1 else 0.15
            v = np.asarray(beam.mbs.GetNodeOutput(node, Variable.Velocity))
            w = np.asarray(beam.mbs.GetNodeOutput(node, Variable.AngularVelocityLocal))
            total += 0.5 * share * (mass * v @ v + w @ (inertia * w))
        for element in beam.beams:
            e = np.asarray(beam.mbs.GetObjectOutputBody(element, Variable.StrainLocal, [0, 0, 0]))[[0, 5, 4]]
            k = np.asarray(beam.mbs.GetObjectOutputBody(element, Variable.CurvatureLocal, [0, 0, 0]))
            strains = np.concatenate([e, k])
            total += 0.5 * 0.3 * strains @ (stiffness * strains)
        return float(total)

    before = energy()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = 4000
    settings.timeIntegration.endTime = 0.5
    settings.timeIntegration.newton.relativeTolerance = 1e-10
    beam.mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.TrapezoidalIndex2)
    assert energy() == pytest.approx(before, rel=1e-4)


def test_nodes_of_two_kinds_are_refused() -> None:
    mbs = exu.SystemContainer().AddSystem()
    nodes = [
        mbs.AddNode(NODES[kind](referenceCoordinates=coordinates(kind, [x, 0, 0], np.eye(3))))
        for kind, x in (("EP", 0), ("Rxyz", 1))
    ]
    mbs.AddObject(ObjectBeamGeometricallyExact(physicsLength=1, nodeNumbers=nodes))
    with pytest.raises(
        ValueError, match="not available: ObjectBeamGeometricallyExact with NodeRigidBodyEP, NodeRigidBodyRxyz"
    ):
        mbs.Assemble()


def test_length_is_asked_for() -> None:
    mbs = exu.SystemContainer().AddSystem()
    nodes = [mbs.AddNode(NodeRigidBodyRotVecLG(referenceCoordinates=[x, 0, 0, 0, 0, 0])) for x in (0, 1)]
    mbs.AddObject(ObjectBeamGeometricallyExact(nodeNumbers=nodes))
    with pytest.raises(ValueError, match=r"ObjectBeamGeometricallyExact.*physicsLength.*a positive length"):
        mbs.Assemble()
