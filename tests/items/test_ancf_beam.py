"""ObjectANCFBeam on nodes with two slopes, against exact solutions of rods."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from test_ancf_cable_2d import ELASTICA
from test_beam_geometrically_exact import section

import dalembert as exu
from dalembert._core import testing

Variable = exu.OutputVariableType
TURN = Rotation.from_rotvec([0.4, -1.1, 0.7]).as_matrix()


class Beam:
    """A straight beam along the first axis of `turn`."""

    def __init__(self, elements: int, length: float, of: Any, turn: Any = None, **parameters: Any) -> None:
        self.mbs = mbs = exu.SystemContainer().AddSystem()
        self.turn = np.eye(3) if turn is None else turn
        self.nodes = [
            mbs.AddNode(
                exu.NodePointSlope23(
                    referenceCoordinates=[*(self.turn @ [x, 0, 0]), *self.turn[:, 1], *self.turn[:, 2]]
                )
            )
            for x in np.linspace(0, length, elements + 1)
        ]
        self.beams = [
            mbs.AddObject(
                exu.ObjectANCFBeam(
                    physicsLength=length / elements, sectionData=of, nodeNumbers=list(pair), **parameters
                )
            )
            for pair in pairwise(self.nodes)
        ]

    def clamp(self) -> None:
        ground = self.mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=self.mbs.AddObject(exu.ObjectGround())))
        root = self.mbs.AddMarker(exu.MarkerNodeRigid(nodeNumber=self.nodes[0]))
        self.mbs.AddObject(exu.ObjectJointGeneric(markerNumbers=[ground, root], rotationMarker0=self.turn))

    def load(self, load_type: Any, vector: Any) -> None:
        tip = self.mbs.AddMarker(exu.MarkerNodeRigid(nodeNumber=self.nodes[-1]))
        self.mbs.AddLoad(load_type(markerNumber=tip, loadVector=vector))

    def solve_static(self, steps: int = 5) -> None:
        self.mbs.Assemble()
        settings = exu.SimulationSettings()
        settings.staticSolver.numberOfLoadSteps = steps
        settings.staticSolver.newton.relativeTolerance = 1e-10
        self.mbs.SolveStatic(settings, updateInitialValues=True)

    def tip(self, variable: Any = Variable.Displacement) -> np.ndarray:
        return np.asarray(self.mbs.GetNodeOutput(self.nodes[-1], variable))


def test_simple_loads() -> None:
    """Small tension, shear, torsion and bending of a short beam, turned in space: closed forms of Timoshenko's beam."""
    length, stiffness = 0.5, np.array([1e6, 5e5, 4e5, 2e3, 5e3, 6e3])
    force, moment = np.array([2.0, 3.0, -1.0]) * 1e-3, np.array([0.1, -0.2, 0.15]) * 1e-3
    beam = Beam(32, length, section(stiffness), TURN)
    beam.clamp()
    beam.load(exu.LoadForceVector, TURN @ force)
    beam.load(exu.LoadTorqueVector, TURN @ moment)
    beam.solve_static(1)
    u = TURN.T @ beam.tip()
    axial, shear = force[0] * length / stiffness[0], force[1:] * length / stiffness[1:3]
    assert u[0] == pytest.approx(axial, rel=1e-6)
    by_force = force[1:] * length**3 / 3 / stiffness[[5, 4]]
    by_moment = np.array([moment[2] / stiffness[5], -moment[1] / stiffness[4]]) * length**2 / 2
    assert u[1:] == pytest.approx(shear + by_force + by_moment, rel=5e-4)
    turned = Rotation.from_matrix(TURN.T @ np.reshape(beam.tip(Variable.RotationMatrix), (3, 3))).as_rotvec()
    by_force = np.array([0, -force[2], force[1]]) * length**2 / 2 / stiffness[3:]
    assert turned == pytest.approx(by_force + moment * length / stiffness[3:], rel=5e-4)


@pytest.mark.parametrize("side", [[0, 1, 0], [0, 0, 1], [0, 0.6, -0.8]])
def test_elastica_converges_with_the_square(side: list[float]) -> None:
    length, stiffness, load = 2.0, 3.0, 5
    deflection, shortening, _ = ELASTICA[load]
    errors = []
    for elements in (16, 32):
        beam = Beam(elements, length, section([1e5, 1e5, 1e5, 5, stiffness, stiffness]), TURN)
        beam.clamp()
        beam.load(exu.LoadForceVector, load * stiffness / length**2 * (TURN @ side))
        beam.solve_static(10)
        wanted = TURN @ (length * (deflection * np.array(side) - [shortening, 0, 0]))
        errors.append(float(np.linalg.norm(beam.tip() - wanted)) / length)
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2, abs=0.2)
    assert errors[1] < 2e-3


# K. Nachbagauer et al., 2013: short cantilever under a dead force across, displacement along and across.
def test_short_cantilever_with_shear() -> None:
    height, width, young, poisson = 0.5, 0.1, 2.07e11, 0.3
    correction = 10 * (1 + poisson) / (12 + 11 * poisson)
    area = height * width
    shear = correction * area * young / (2 * (1 + poisson))
    bending = young * width * height**3 / 12
    beam = Beam(128, 2.0, section([young * area, shear, shear, 1e8, 1e8, bending]))
    beam.clamp()
    beam.load(exu.LoadForceVector, [0, -5e8 * height**3, 0])
    beam.solve_static(10)
    assert -beam.tip()[:2] == pytest.approx([0.15097103, 0.71056837], rel=1e-3)


def test_reference_without_stress() -> None:
    """A curved and twisted reference configuration stays as it is."""
    mbs = exu.SystemContainer().AddSystem()
    nodes = []
    for s in np.linspace(0, 1, 5):
        frame = Rotation.from_rotvec([0.3 * s, -0.4 * s, 0.8 * s]).as_matrix()
        nodes.append(
            mbs.AddNode(exu.NodePointSlope23(referenceCoordinates=[s, 0.3 * s**2, -0.1 * s, *frame.T[1:].ravel()]))
        )
    of = section([1e3, 500, 400, 2, 5, 6], 1.0, [2e-3, 1e-3, 1e-3])
    for pair in pairwise(nodes):
        mbs.AddObject(exu.ObjectANCFBeam(physicsLength=0.3, sectionData=of, nodeNumbers=list(pair)))
    mbs.Assemble()
    assert np.abs(testing.residual(mbs, testing.State(mbs))).max() < 1e-12


def test_rigid_rotation_has_the_inertia_of_the_section() -> None:
    """The kinetic energy of a beam that spins about an axis through its middle, with any inertia of its section."""
    inertia = np.array([[5e-3, 0, 0], [0, 2e-3, -0.7e-3], [0, -0.7e-3, 3e-3]])
    of = section([1e3, 500, 400, 2, 5, 6], 1.2)
    of.inertia = inertia
    length, omega = 0.8, np.array([1.0, -2.0, 0.5])
    mbs = Beam(1, length, of).mbs
    mbs.Assemble()
    state = testing.State(mbs)
    ends = [np.array([x, 0.0, 0.0]) for x in (0, length)]
    v = np.concatenate([np.cross(omega, a) for x in ends for a in (x - [length / 2, 0, 0], [0, 1, 0], [0, 0, 1])])
    energy = 0.5 * v @ testing.mass_matrix(mbs, state) @ v
    about_middle = length * inertia + np.diag([0, 1, 1]) * 1.2 * length**3 / 12
    assert energy == pytest.approx(0.5 * omega @ about_middle @ omega, rel=1e-12)


def test_length_and_slopes_are_asked_for() -> None:
    mbs = exu.SystemContainer().AddSystem()
    with pytest.raises(ValueError, match=r"NodePointSlope23.*referenceCoordinates.*slope vectors are parallel"):
        mbs.AddNode(exu.NodePointSlope23())
        mbs.Assemble()
