"""Modes and linearized systems with constraints: every node type, as many modes as exist, the equilibrium next to the start."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import pytest
from solving import new_system

import dalembert as exu
from dalembert.utilities import InertiaCuboid, InertiaCylinder, RotationMatrixX, RotationMatrixZ

NODES = [
    exu.NodeType.RotationEulerParameters,
    exu.NodeType.RotationRotationVector,
    exu.NodeType.RotationRxyz,
]
node_types = pytest.mark.parametrize("node", NODES, ids=["EP", "RotVec", "Rxyz"])
G = 9.81


@node_types
@pytest.mark.parametrize("length", [1.0, 1e3], ids=["m", "mm"])
@pytest.mark.parametrize("beside", [0.3, 0.1, 0.03, 0.01])
def test_slider_on_a_spring_off_its_axis(node: Any, length: float, beside: float) -> None:
    """omega^2 = k/m (1 - (d/L)^2) of a spring of length L that is fixed d off the axis, where its force is zero.

    Rotations of the size of round-off gave the first Euler parameter a mass of 1e-34, and the shift drowned all forces.
    """
    mbs = new_system()
    ground = mbs.CreateGround()
    inertia = InertiaCuboid(1000 / length**3, [0.1 * length, 0.2 * length, 0.3 * length])
    slider = mbs.CreateRigidBody(inertia=inertia, nodeType=node, gravity=[0, 0, -G * length])
    mbs.CreatePrismaticJoint(bodyNumbers=[ground, slider], position=[0, 0, 0], axis=[1, 0, 0])
    mbs.CreateSpringDamper(
        bodyNumbers=[ground, slider],
        localPosition0=[-0.5 * length, 0, 0],
        localPosition1=[0, beside * length, 0],
        stiffness=600,
        referenceLength=0.5 * length,
    )
    mbs.Assemble()
    # the spring is longer than 0.5 by this: the slider moves to where its length is that, at cos = sqrt(1 - (d/L)^2)
    found = mbs.ComputeVibrationModes()
    assert len(found.eigenvalues) == 1  # one degree of freedom has one mode
    assert found.eigenvalues[0] == pytest.approx(1j * np.sqrt(100 * (1 - (beside / 0.5) ** 2)), rel=1e-9)


def chain(links: int, node: Any, stiffness: float = 500.0) -> exu.MainSystem:
    """Links on hinges and torsional springs, which weight bends."""
    mbs = new_system()
    before = mbs.CreateGround()
    inertia = InertiaCuboid(1000, [0.4, 0.1, 0.1])
    for i in range(links):
        link = mbs.CreateRigidBody(
            referencePosition=[0.2 + 0.4 * i, 0, 0], inertia=inertia, gravity=[0, 0, -G], nodeType=node
        )
        for add, more in (
            (mbs.CreateRevoluteJoint, {}),
            (mbs.CreateTorsionalSpringDamper, {"stiffness": stiffness, "damping": 0.1}),
        ):
            add(bodyNumbers=[before, link], position=[0.4 * i, 0, 0], axis=[0, 1, 0], **more)
        before = link
    mbs.Assemble()
    return mbs


def planar_chain(links: int, stiffness: float = 500.0, damping: float = 0.1) -> np.ndarray:
    """Eigenvalues of the same chain in absolute angles, linearized about its equilibrium by hand."""
    a, m, J = 0.4, 4.0, 4.0 * (0.4**2 + 0.1**2) / 12
    n = links
    lever = a * np.tri(n, k=-1) + 0.2 * np.eye(n)  # derivative of the position of center i by angle j
    weights = m * G * lever.sum(axis=0)
    difference = np.eye(n) - np.eye(n, k=-1)
    D = stiffness * difference.T @ difference
    angles = np.zeros(n)  # clockwise from horizontal: D angles = weights cos(angles)
    for _ in range(60):
        residual = D @ angles - weights * np.cos(angles)
        step = -np.linalg.solve(D + np.diag(weights * np.sin(angles)), residual)
        angles += step * min(1.0, 0.3 / max(np.abs(step).max(), 1e-300))
    assert np.abs(D @ angles - weights * np.cos(angles)).max() < 1e-9
    cosines = np.cos(angles[:, None] - angles[None, :])
    M = m * (lever.T @ lever) * cosines + J * np.eye(n)
    K = D + np.diag(weights * np.sin(angles))
    C = damping * difference.T @ difference
    inverse = np.linalg.inv(M)
    values = np.linalg.eigvals(np.block([[np.zeros((n, n)), np.eye(n)], [-inverse @ K, -inverse @ C]]))
    values = values[values.imag >= 0]
    return values[np.argsort(np.abs(values))]


@pytest.mark.parametrize("links", [1, 2, 3, 5, 12, 40])
@pytest.mark.parametrize("node", NODES[:2], ids=["EP", "RotVec"])
def test_no_more_modes_than_degrees_of_freedom(node: Any, links: int) -> None:
    """All modes of a chain, and nothing else, from 1 link to the sparse solver's 40; infinite eigenvalues looked like modes."""
    mbs = chain(links, node)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)  # long chains hang far from their start
        found = mbs.ComputeVibrationModes(links + 8).eigenvalues
    wanted = planar_chain(links)
    assert len(found) == len(wanted) == links
    assert np.abs(found - wanted).max() < 1e-6 * np.abs(wanted).max()
    lowest = 1e-7 * np.abs(wanted[0])
    assert np.abs(found[0] - wanted[0]) < lowest


def test_nothing_moves() -> None:
    """A body that is welded to ground has no mode."""
    mbs = new_system()
    body = mbs.CreateRigidBody(inertia=InertiaCuboid(1000, [0.1, 0.2, 0.3]))
    mbs.CreateGenericJoint(bodyNumbers=[mbs.CreateGround(), body], position=[0, 0, 0], constrainedAxes=[1] * 6)
    mbs.Assemble()
    assert len(mbs.ComputeVibrationModes().eigenvalues) == 0


def pendulum(node: Any, stiffness: float, gravity: Any) -> exu.MainSystem:
    mbs = new_system()
    ground = mbs.CreateGround()
    body = mbs.CreateRigidBody(
        referencePosition=[0, -1, 0], inertia=InertiaCuboid(1000, [0.1, 0.2, 0.3]), gravity=gravity, nodeType=node
    )
    mbs.CreateRevoluteJoint(bodyNumbers=[ground, body], position=[0, 0, 0], axis=[0, 0, 1])
    if stiffness:
        mbs.CreateTorsionalSpringDamper(
            bodyNumbers=[ground, body], position=[0, 0, 0], axis=[0, 0, 1], stiffness=stiffness
        )
    mbs.Assemble()
    return mbs


@node_types
@pytest.mark.parametrize("stiffness", [0.0, 20.0, 200.0])
def test_equilibrium_next_to_the_start(node: Any, stiffness: float) -> None:
    """A pendulum that hangs off the direction of gravity rotates to it by 0.3 rad, not to the inverted position."""
    found = pendulum(node, stiffness, [3, -G, 0]).ComputeVibrationModes(1)
    m, J, g = 6.0, 6.0 * (0.1**2 + 0.2**2) / 12 + 6.0, np.hypot(3, G)
    angle, direction = 0.0, np.arctan2(3, G)
    for _ in range(50):
        angle -= (stiffness * angle + m * g * np.sin(angle - direction)) / (
            stiffness + m * g * np.cos(angle - direction)
        )
    wanted = 1j * np.sqrt((stiffness + m * g * np.cos(angle - direction)) / J)
    assert found.eigenvalues == pytest.approx([wanted], rel=1e-9)
    assert found.coordinates[:2] == pytest.approx([np.sin(angle), 1 - np.cos(angle)], abs=1e-9)


def test_a_load_turns_a_free_arm_by_a_quarter_turn_only() -> None:
    """An arm on a hinge without springs ends in the direction of its load, however small that is, and a warning says how far."""
    mbs = new_system()
    ground = mbs.CreateGround()
    arm = mbs.CreateRigidBody(referencePosition=[1, 0, 0], inertia=InertiaCuboid(1000, [2, 0.1, 0.1]))
    mbs.CreateRevoluteJoint(bodyNumbers=[ground, arm], position=[0, 0, 0], axis=[0, 0, 1])
    mbs.CreateForce(bodyNumber=arm, localPosition=[1, 0, 0], loadVector=[0, -1, 0])
    mbs.Assemble()
    with pytest.warns(RuntimeWarning, match=r"the equilibrium found is 1\.57 rad away from the initial state"):
        found = mbs.ComputeVibrationModes(1)
    J = 20.0 * (2**2 + 0.1**2) / 12 + 20.0
    assert found.eigenvalues == pytest.approx([1j * np.sqrt(2 / J)], rel=1e-8)
    assert found.coordinates[:2] == pytest.approx([-1, -1], abs=1e-9)


def test_rolling_disc_that_stands() -> None:
    """An upright disc at rest tips over with sqrt(m g r / (J + m r^2)); constraints of velocities made matrices singular."""
    radius, inertia = 0.5, InertiaCylinder(1000, 0.02, 0.5, axis=0)
    mbs = new_system()
    disc = mbs.CreateRigidBody(referencePosition=[0, 0, radius], inertia=inertia, gravity=[0, 0, -G])
    mbs.CreateRollingDisc(
        bodyNumbers=[mbs.CreateGround(), disc], axisPosition=[0, 0, 0], axisVector=[1, 0, 0], discRadius=radius
    )
    mbs.Assemble()
    wanted = np.sqrt(inertia.mass * G * radius / (inertia.inertiaTensor[1, 1] + inertia.mass * radius**2))
    for found in (
        mbs.ComputeVibrationModes().eigenvalues,
        mbs.ComputeODE2Eigenvalues(computeComplexEigenvalues=True, useAbsoluteValues=False)[0],
    ):
        assert np.abs(found - wanted).min() < 1e-8 * wanted and np.abs(found + wanted).min() < 1e-8 * wanted
        assert np.sort(np.abs(found))[-3] < 1e-6  # it may roll and turn about the vertical


def test_rotors_that_turn_initially_are_named() -> None:
    mbs = new_system()
    rotor = mbs.CreateRigidBody(
        inertia=InertiaCylinder(1000, 0.1, 0.2, axis=0), initialAngularVelocity=[100, 0, 0], name="rotor"
    )
    for x in (-0.3, 0.3):
        mbs.CreateCartesianSpringDamper(
            bodyNumbers=[mbs.CreateGround(), rotor],
            localPosition0=[x, 0, 0],
            localPosition1=[x, 0, 0],
            stiffness=[2000] * 3,
        )
    mbs.Assemble()
    with pytest.warns(RuntimeWarning, match=r"initial velocities are ignored.*Node:rotor"):
        mbs.ComputeVibrationModes(3)
    with pytest.warns(UserWarning, match=r"bodies turn in the initial state .*Node:rotor.*ComputeVibrationModes"):
        mbs.ComputeODE2Eigenvalues()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        mbs.ComputeVibrationModes(3, angularVelocity=[100, 0, 0])


# ---- linearized systems ------------------------------------------------------------------------------------------------


@node_types
@pytest.mark.parametrize("tilt", [0.0, 0.3])
@pytest.mark.parametrize("solved", [False, True])
def test_a_pendulum_has_a_frequency(node: Any, tilt: float, solved: bool) -> None:
    """omega^2 = m g l / J of a hanging body, whose stiffness is that of the force in its hinge; it was 0."""
    A, inertia = RotationMatrixZ(0.4) @ RotationMatrixX(tilt), InertiaCuboid(1000, [0.1, 0.2, 0.3])
    mbs = new_system()
    ground = mbs.CreateGround()
    body = mbs.CreateRigidBody(
        referencePosition=[0, -1, 0], referenceRotationMatrix=A, inertia=inertia, gravity=[0, -G, 0], nodeType=node
    )
    mbs.CreateRevoluteJoint(bodyNumbers=[ground, body], position=[0, 0, 0], axis=[0, 0, 1])
    mbs.Assemble()
    if solved:
        settings = exu.SimulationSettings()
        settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 1e-3, 10
        settings.solutionSettings.writeSolutionToFile = False
        mbs.SolveDynamic(settings, updateInitialValues=True)
    J = (A @ inertia.inertiaTensor @ A.T)[2, 2] + inertia.mass
    wanted = np.sqrt(inertia.mass * G / J)
    tolerance = 1e-6 if solved else 1e-9  # steps move the body by the tolerance of their Newton iterations
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert mbs.ComputeODE2Eigenvalues()[0] ** 0.5 == pytest.approx([wanted], rel=tolerance)
        M, K, D, *_ = mbs.ComputeLinearizedSystem(projectIntoConstraintNullspace=True)
    assert pytest.approx(np.array([[wanted**2]]), rel=tolerance) == K / M


@node_types
def test_loads_of_rods_and_balls_count(node: Any) -> None:
    """A stone on a rod, and a body on a ball joint, swing in two directions."""
    rod = new_system()
    stone = rod.CreateMassPoint(referencePosition=[0, -1, 0], physicsMass=2, gravity=[0, -G, 0])
    rod.CreateDistanceConstraint(bodyNumbers=[rod.CreateGround(), stone])
    rod.Assemble()
    assert rod.ComputeODE2Eigenvalues()[0] == pytest.approx([G, G], rel=1e-9)
    ball = new_system()
    body = ball.CreateRigidBody(
        referencePosition=[0, -1, 0], inertia=InertiaCuboid(1000, [0.2, 0.1, 0.2]), gravity=[0, -G, 0], nodeType=node
    )
    ball.CreateSphericalJoint(bodyNumbers=[ball.CreateGround(), body], position=[0, 0, 0])
    ball.Assemble()
    J = 4.0 * (0.1**2 + 0.2**2) / 12 + 4.0
    assert ball.ComputeODE2Eigenvalues()[0] == pytest.approx([0, 4 * G / J, 4 * G / J], rel=1e-9, abs=1e-9)


def test_states_that_are_no_equilibrium_are_named() -> None:
    """Forces of constraints are unknown there: a warning names the function to call. There is none without preload."""
    horizontal = pendulum(NODES[0], 0.0, [G, 0, 0])
    with pytest.warns(UserWarning, match=r"no equilibrium: forces of constraints.*ComputeVibrationModes"):
        horizontal.ComputeODE2Eigenvalues()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        pendulum(NODES[0], 20.0, [0, 0, 0]).ComputeODE2Eigenvalues()
        horizontal.ComputeSystemDegreeOfFreedom(useSVD=True)  # no question of stiffness


@node_types
def test_loaded_beam(node: Any) -> None:
    """Both analyses agree after SolveStatic, for each node type; forces of the clamp bend rotation parameters."""
    item = {NODES[0]: exu.NodeRigidBodyEP, NODES[1]: exu.NodeRigidBodyRotVecLG, NODES[2]: exu.NodeRigidBodyRxyz}[node]
    mbs = new_system()
    section = exu.BeamSection()
    section.stiffnessMatrix = np.diag([1e4, 4e3, 4e3, 20, 30, 30.0])
    section.massPerLength, section.inertia = 1.0, np.diag([2e-3, 1e-3, 1e-3])
    rotation = [1, 0, 0, 0] if node == NODES[0] else [0, 0, 0]
    nodes = [mbs.AddNode(item(referenceCoordinates=[x, 0, 0, *rotation])) for x in (0, 0.5, 1.0)]
    for pair in ((0, 1), (1, 2)):
        beam = mbs.AddObject(
            exu.ObjectBeamGeometricallyExact(
                nodeNumbers=[nodes[i] for i in pair], physicsLength=0.5, sectionData=section
            )
        )
        marker = mbs.AddMarker(exu.MarkerBodyMass(bodyNumber=beam))
        mbs.AddLoad(exu.LoadMassProportional(markerNumber=marker, loadVector=[0, 0, -G]))
    clamp = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=mbs.CreateGround()))
    mbs.AddObject(exu.GenericJoint(markerNumbers=[clamp, mbs.AddMarker(exu.MarkerNodeRigid(nodeNumber=nodes[0]))]))
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.staticSolver.numberOfLoadSteps = 5
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveStatic(settings, updateInitialValues=True)
    frequencies = mbs.ComputeODE2Eigenvalues(numberOfEigenvalues=3, convert2Frequencies=True)[0]
    assert frequencies == pytest.approx(mbs.ComputeVibrationModes(3).frequencies, rel=1e-6)
    # rotation vectors on the Lie group, without constraints of parameters
    assert frequencies == pytest.approx([2.82021898, 2.82134407, 18.26966846], rel=1e-6)


def test_the_current_state_stays() -> None:
    """Analyses about the initial state put the current one back, with its accelerations and forces."""
    mbs = pendulum(NODES[0], 20.0, [G, 0, 0])
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 0.1, 100
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveDynamic(settings)
    data = mbs.systemData

    def state() -> list[np.ndarray]:
        values = [data.GetODE2Coordinates(), data.GetODE2Coordinates_t(), data.GetODE2Coordinates_tt()]
        return [*values, data.GetAECoordinates(), np.array([data.GetTime(), mbs.ComputeEnergies().kinetic])]

    before = state()
    assert before[-1][1] > 0.1
    for analysis in (
        lambda: mbs.ComputeODE2Eigenvalues(),
        lambda: mbs.ComputeLinearizedSystem(),
        lambda: mbs.ComputeSystemDegreeOfFreedom(useSVD=True),
        lambda: mbs.ComputeVibrationModes(1),
    ):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            analysis()
        for now, then in zip(state(), before, strict=True):
            np.testing.assert_array_equal(now, then)


@pytest.mark.parametrize("joint", ["free", "ball", "hinge"])
@pytest.mark.parametrize("seed", range(4))
def test_node_types_agree_under_preload(seed: int, joint: str) -> None:
    """A body turned at random on preloaded springs, weight and a joint, in equilibrium: both analyses, all node types."""
    random = np.random.default_rng(seed)
    anchors, points = random.uniform(-1, 1, (2, 12, 3)) * np.array([[[2.0]], [[0.5]]])
    stiffness, turn = random.uniform(800, 2000, 12), random.uniform(-0.5, 0.5, 3)
    A = exu.utilities.RotationVector2RotationMatrix(turn)
    lengths = np.linalg.norm(anchors - points @ A.T, axis=1) * random.uniform(0.85, 0.95, 12)  # they pull
    results = []
    for node in NODES:
        mbs = new_system()
        ground = mbs.CreateGround()
        body = mbs.CreateRigidBody(
            referenceRotationMatrix=A,
            inertia=InertiaCuboid(1000, [0.1, 0.2, 0.3]),
            gravity=[1, 2, -G],
            nodeType=node,
        )
        for anchor, point, length, k in zip(anchors, points, lengths, stiffness, strict=True):
            mbs.CreateSpringDamper(
                bodyNumbers=[ground, body],
                localPosition0=anchor,
                localPosition1=point,
                referenceLength=length,
                stiffness=k,
            )
        if joint == "ball":
            mbs.CreateSphericalJoint(bodyNumbers=[ground, body], position=[0.1, 0.2, 0])
        if joint == "hinge":
            mbs.CreateRevoluteJoint(bodyNumbers=[ground, body], position=[0.1, 0.2, 0], axis=[1, 2, 3])
        mbs.Assemble()
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", RuntimeWarning)  # some turn far
            found = mbs.ComputeVibrationModes(updateInitialValues=True)
        squares = (-(found.eigenvalues**2)).real  # an unstable pair has two real ones
        eigenvalues = np.sort(mbs.ComputeODE2Eigenvalues(useAbsoluteValues=False)[0])
        assert len(eigenvalues) == {"free": 6, "ball": 3, "hinge": 1}[joint]
        scale = np.abs(eigenvalues).max()
        distances = np.abs(squares[:, None] - eigenvalues[None, :]) / scale
        assert distances.min(axis=0).max() < 1e-7 and distances.min(axis=1).max() < 1e-7
        results.append(eigenvalues)
    for other in results[1:]:
        np.testing.assert_allclose(other, results[0], atol=1e-8 * scale)
