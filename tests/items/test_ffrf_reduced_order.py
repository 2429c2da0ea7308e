"""ObjectFFRFreducedOrder against the full model: mass points, springs between them, and their sums."""

from __future__ import annotations

from itertools import combinations
from typing import Any

import numpy as np
import pytest
from flexible import of_points

import dalembert as exu
from dalembert._core import testing
from dalembert.itemInterface import (
    CoordinateConstraint,
    LoadMassProportional,
    MarkerBodyMass,
    MarkerBodyRigid,
    MarkerNodeCoordinate,
    MarkerNodePosition,
    MarkerSuperElementPosition,
    MarkerSuperElementRigid,
    NodeGenericODE2,
    NodePoint,
    NodePointGround,
    NodeRigidBodyEP,
    NodeRigidBodyRotVecLG,
    NodeRigidBodyRxyz,
    ObjectFFRFreducedOrder,
    ObjectGround,
    ObjectMassPoint,
    ObjectRigidBody,
    SphericalJoint,
    SpringDamper,
)

Variable = exu.OutputVariableType
FRAMES = [NodeRigidBodyEP, NodeRigidBodyRxyz, NodeRigidBodyRotVecLG]
each_frame = pytest.mark.parametrize("frame_type", FRAMES, ids=lambda node: node.__name__)

# A box of eight points with springs along edges and diagonals.
BOX = np.array([[x, y, z] for x in (0, 1.0) for y in (0, 0.6) for z in (0, 0.4)]) - [0.2, 0.3, 0.1]
MASSES = np.array([1.0, 1.5, 0.8, 1.2, 1.1, 0.9, 1.4, 0.7])
STIFFNESS = 2e4


def truss() -> np.ndarray:
    """Stiffness matrix of the springs, for small displacements."""
    k = np.zeros((24, 24))
    for i, j in combinations(range(8), 2):
        axis = (BOX[i] - BOX[j]) / np.linalg.norm(BOX[i] - BOX[j])
        both = np.concatenate([np.arange(3 * i, 3 * i + 3), np.arange(3 * j, 3 * j + 3)])
        k[np.ix_(both, both)] += STIFFNESS * np.kron([[1, -1], [-1, 1]], np.outer(axis, axis))
    return k


def free_modes() -> tuple[np.ndarray, np.ndarray]:
    """Angular frequencies and modes of the free truss, without the six rigid body motions."""
    root = np.sqrt(np.repeat(MASSES, 3))
    squares, modes = np.linalg.eigh(truss() / np.outer(root, root))
    return np.sqrt(squares[6:]), (modes / root[:, None])[:, 6:]


def add_frame(mbs: Any, node: type, velocity: Any = (0, 0, 0), spin: Any = (0, 0, 0)) -> Any:
    """The body at the origin, without rotation."""
    euler = node is NodeRigidBodyEP
    rates = [0, *(0.5 * np.array(spin))] if euler else list(spin)
    reference = [0.0, 0, 0, *([1, 0, 0, 0] if euler else [0, 0, 0])]
    return mbs.AddNode(node(referenceCoordinates=reference, initialVelocities=[*velocity, *rates]))


def add_modes(mbs: Any, count: int, start: Any = 0, rate: Any = 0, reference: Any = 0) -> Any:
    full = lambda values: np.zeros(count) + values  # noqa: E731
    return mbs.AddNode(
        NodeGenericODE2(
            numberOfODE2Coordinates=count,
            referenceCoordinates=full(reference),
            initialCoordinates=full(start),
            initialCoordinates_t=full(rate),
        )
    )


def add_truss(mbs: Any, node: type, *, start: Any = 0, rate: Any = 0, **motion: Any) -> tuple[Any, Any]:
    _, modes = free_modes()
    nodes = [add_frame(mbs, node, **motion), add_modes(mbs, modes.shape[1], start, rate)]
    rows = of_points(BOX, MASSES, modes)
    stiffness = modes.T @ truss() @ modes
    return mbs.AddObject(ObjectFFRFreducedOrder(nodeNumbers=nodes, stiffnessMatrixReduced=stiffness, **rows)), nodes


def mesh(mbs: Any, body: Any, variable: Any, count: int = 8) -> np.ndarray:
    return np.array([mbs.GetObjectOutputSuperElement(body, variable, i) for i in range(count)])


def settings_for(steps: int, end: float) -> Any:
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.endTime = end
    settings.timeIntegration.generalizedAlpha.spectralRadius = 1
    settings.timeIntegration.newton.relativeTolerance = 1e-10
    return settings


def random_state(mbs: Any, seed: int) -> testing.State:
    rng, s = np.random.default_rng(seed), testing.State(mbs)
    s.q = testing.compose(mbs, s, 0.3 * rng.normal(size=len(s.q)))
    s.v, s.a = rng.normal(size=(2, len(s.q)))
    return s


def show(mbs: Any, s: testing.State) -> None:
    mbs.systemData.SetODE2Coordinates(s.q)
    mbs.systemData.SetODE2Coordinates_t(s.v)
    mbs.systemData.SetODE2Coordinates_tt(s.a)


@each_frame
def test_inertia_is_that_of_the_mass_points(mbs: Any, frame_type: type) -> None:
    """r = sum of J^T m a over the mesh nodes, with J = d velocity / d rates, in a random state."""
    rng = np.random.default_rng(7)
    modes = rng.normal(size=(24, 5))
    nodes = [add_frame(mbs, frame_type), add_modes(mbs, 5)]
    body = mbs.AddObject(ObjectFFRFreducedOrder(nodeNumbers=nodes, **of_points(BOX, MASSES, modes)))
    mbs.Assemble()
    s = random_state(mbs, 8)
    if frame_type is NodeRigidBodyEP:  # parameters of unit length
        e = s.q[3:7] + [1, 0, 0, 0]
        s.q = np.concatenate([s.q[:3], e / np.linalg.norm(e) - [1, 0, 0, 0], s.q[7:]])
        e /= np.linalg.norm(e)
        s.v = np.concatenate([s.v[:3], s.v[3:7] - e * (e @ s.v[3:7]), s.v[7:]])
    show(mbs, s)
    forces = MASSES[:, None] * mesh(mbs, body, Variable.Acceleration)
    expected = np.zeros(len(s.q))
    for i in range(len(s.q)):  # velocities are linear in the rates
        unit = s.copy()
        unit.v = np.eye(len(s.q))[i]
        show(mbs, unit)
        expected[i] = np.sum(forces * mesh(mbs, body, Variable.Velocity))
    r = testing.residual(mbs, s)[: len(s.q)]
    np.testing.assert_allclose(r, expected, rtol=0, atol=1e-12 * np.abs(expected).max())


@each_frame
def test_without_deformation_it_is_a_rigid_body(mbs: Any, frame_type: type) -> None:
    rows = of_points(BOX, MASSES, np.random.default_rng(9).normal(size=(24, 3)))
    j, spin = rows["physicsInertia"], [1.0, -2, 0.5]
    frames = [add_frame(mbs, frame_type, (1, 2, 3), spin) for _ in range(2)]
    modes = add_modes(mbs, 3)
    mbs.AddObject(ObjectFFRFreducedOrder(nodeNumbers=[frames[0], modes], **rows))
    inertia = [j[0, 0], j[1, 1], j[2, 2], j[1, 2], j[0, 2], j[0, 1]]
    mbs.AddObject(
        ObjectRigidBody(
            nodeNumber=frames[1],
            physicsMass=rows["physicsMass"],
            physicsCenterOfMass=rows["physicsCenterOfMass"],
            physicsInertia=inertia,
        )
    )
    ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
    for i in range(3):
        mode = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=modes, coordinate=i))
        mbs.AddObject(CoordinateConstraint(markerNumbers=[ground, mode]))
    mbs.Assemble()
    mbs.SolveDynamic(settings_for(200, 0.5))
    flexible, rigid = (mbs.GetNodeOutput(frame, Variable.Coordinates) for frame in frames)
    assert flexible == pytest.approx(rigid, abs=1e-9)
    assert np.abs(rigid).max() > 0.5


def test_frequencies_are_those_of_the_free_truss(mbs: Any) -> None:
    add_truss(mbs, NodeRigidBodyRxyz)
    mbs.Assemble()
    squares, _ = mbs.ComputeODE2Eigenvalues()
    found = np.sqrt(np.sort(np.abs(squares)))
    assert found[:6] == pytest.approx(np.zeros(6), abs=1e-4)
    assert found[6:] == pytest.approx(free_modes()[0], rel=1e-9)


@each_frame
def test_free_flight_keeps_energy_and_momentum(mbs: Any, frame_type: type) -> None:
    stiffness = truss()
    start = np.random.default_rng(3).normal(size=18) * 1e-3
    body, _ = add_truss(mbs, frame_type, velocity=(1, 2, 3), spin=(2, 3, -1), start=start)
    mbs.Assemble()

    def measures() -> np.ndarray:
        p, v = mesh(mbs, body, Variable.Position), mesh(mbs, body, Variable.Velocity)
        u = mesh(mbs, body, Variable.DisplacementLocal).ravel()
        momentum = MASSES[:, None] * v
        energy = 0.5 * np.sum(momentum * v) + 0.5 * u @ stiffness @ u
        return np.array([energy, *momentum.sum(axis=0), *np.cross(p, momentum).sum(axis=0)])

    before = measures()
    settings = settings_for(4000, 0.2)
    mbs.SolveDynamic(settings)
    elastic = 0.5 * start @ np.diag(free_modes()[0] ** 2) @ start
    # the trapezoidal rule at 400 steps per period of the lowest mode, 50 per period of the highest one
    np.testing.assert_allclose(measures()[0], before[0], rtol=0, atol=2e-3 * elastic)
    np.testing.assert_allclose(measures()[1:], before[1:], rtol=0, atol=2e-5 * np.abs(before).max())
    u = mesh(mbs, body, Variable.DisplacementLocal)
    assert np.abs(u).max() > 1e-4


def test_explicit_solver(mbs: Any) -> None:
    body, (frame, _) = add_truss(mbs, NodeRigidBodyRxyz, spin=(2, 3, -1), start=1e-3)
    other = exu.SystemContainer().AddSystem()
    twin, _ = add_truss(other, NodeRigidBodyRotVecLG, spin=(2, 3, -1), start=1e-3)
    for system in (mbs, other):
        system.Assemble()
    mbs.SolveDynamic(settings_for(2000, 0.05), solverType=exu.DynamicSolverType.RK44)
    other.SolveDynamic(settings_for(4000, 0.05))
    positions = [mesh(system, number, Variable.Position) for system, number in ((mbs, body), (other, twin))]
    np.testing.assert_allclose(positions[0], positions[1], rtol=0, atol=2e-6)


def test_spinning_truss_moves_as_its_points_do(mbs: Any) -> None:
    """All modes against nonlinear springs between mass points: they differ by terms of the strain, some 1e-3."""
    spin, end = np.array([3.0, -4, 5]), 0.1
    body, _ = add_truss(mbs, NodeRigidBodyEP, spin=spin)
    mbs.Assemble()
    mbs.SolveDynamic(settings_for(2000, end))
    points = exu.SystemContainer().AddSystem()
    nodes = [points.AddNode(NodePoint(referenceCoordinates=x, initialVelocities=np.cross(spin, x))) for x in BOX]
    for node, mass in zip(nodes, MASSES, strict=True):
        points.AddObject(ObjectMassPoint(nodeNumber=node, physicsMass=mass))
    markers = [points.AddMarker(MarkerNodePosition(nodeNumber=node)) for node in nodes]
    for i, j in combinations(range(8), 2):
        length = np.linalg.norm(BOX[i] - BOX[j])
        points.AddObject(
            SpringDamper(markerNumbers=[markers[i], markers[j]], stiffness=STIFFNESS, referenceLength=length)
        )
    points.Assemble()
    points.SolveDynamic(settings_for(2000, end))
    expected = np.array([points.GetNodeOutput(node, Variable.Position) for node in nodes])
    deformation = np.abs(mesh(mbs, body, Variable.DisplacementLocal)).max()
    assert deformation > 5e-4
    np.testing.assert_allclose(mesh(mbs, body, Variable.Position), expected, rtol=0, atol=0.02 * deformation)


@each_frame
def test_weight_deforms_nothing_in_free_fall(mbs: Any, frame_type: type) -> None:
    gravity = np.array([1.0, 2, -9.81])
    body, _ = add_truss(mbs, frame_type)
    marker = mbs.AddMarker(MarkerBodyMass(bodyNumber=body))
    mbs.AddLoad(LoadMassProportional(markerNumber=marker, loadVector=gravity))
    mbs.Assemble()
    mbs.SolveDynamic(settings_for(10, 0.1))
    np.testing.assert_allclose(
        mesh(mbs, body, Variable.Displacement), np.tile(0.005 * gravity, (8, 1)), rtol=0, atol=1e-10
    )
    np.testing.assert_allclose(mesh(mbs, body, Variable.DisplacementLocal), 0, rtol=0, atol=1e-10)


def test_markers_move_as_the_mesh(mbs: Any) -> None:
    """A rigid motion and the mean of nodes; a local point is one of the frame."""
    body, (frame, _) = add_truss(mbs, NodeRigidBodyEP, velocity=(1, 2, 3), spin=(2, 3, -1), start=1e-3, rate=0.1)
    nodes, weights = [4, 5, 6, 7], np.array([0.1, 0.2, 0.3, 0.4])
    rows = {"bodyNumber": body, "meshNodeNumbers": nodes, "weightingFactors": weights}
    mean = mbs.AddMarker(MarkerSuperElementPosition(**rows))
    rigid = mbs.AddMarker(MarkerSuperElementRigid(**rows, offset=[0.1, 0, 0]))
    local = mbs.AddMarker(MarkerBodyRigid(bodyNumber=body, localPosition=[1, 0, 0]))
    mbs.Assemble()
    for variable in (Variable.Position, Variable.Velocity, Variable.Acceleration):
        expected = weights @ mesh(mbs, body, variable)[nodes]
        assert mbs.GetMarkerOutput(mean, variable) == pytest.approx(expected, abs=1e-12)
    assert mbs.GetMarkerOutput(rigid, Variable.Position) == pytest.approx(
        mbs.GetMarkerOutput(mean, Variable.Position) + [0.1, 0, 0]
    )
    assert mbs.GetMarkerOutput(local, Variable.Velocity) == pytest.approx([1, 2 - 1, 3 - 3])
    # its rotation turns the reference positions into those of the deformed nodes, as closely as a rigid body does
    turn = mbs.GetMarkerOutput(rigid, Variable.RotationMatrix).reshape(3, 3)
    assert turn @ turn.T == pytest.approx(np.eye(3), abs=1e-12)
    arms = BOX[nodes] - weights @ BOX[nodes]
    moved = mesh(mbs, body, Variable.Position)[nodes]
    left = moved - weights @ moved - arms @ turn.T
    assert np.einsum("n,na->a", weights, np.cross(arms, left)) == pytest.approx(np.zeros(3), abs=1e-6)


def test_pendulum_swings_with_its_energy(mbs: Any) -> None:
    body, (frame, _) = add_truss(mbs, NodeRigidBodyEP)
    ground = mbs.AddObject(ObjectGround(referencePosition=BOX[:4].mean(axis=0)))
    ends = [
        mbs.AddMarker(MarkerBodyRigid(bodyNumber=ground)),
        mbs.AddMarker(
            MarkerSuperElementRigid(bodyNumber=body, meshNodeNumbers=[0, 1, 2, 3], weightingFactors=[0.25] * 4)
        ),
    ]
    mbs.AddObject(SphericalJoint(markerNumbers=ends))
    weight = mbs.AddMarker(MarkerBodyMass(bodyNumber=body))
    mbs.AddLoad(LoadMassProportional(markerNumber=weight, loadVector=[0, 0, -9.81]))
    mbs.Assemble()
    mbs.SolveDynamic(settings_for(2000, 0.4))
    p, v = mesh(mbs, body, Variable.Position), mesh(mbs, body, Variable.Velocity)
    u = mesh(mbs, body, Variable.DisplacementLocal).ravel()
    kinetic, fallen = 0.5 * np.sum(MASSES * np.sum(v * v, axis=1)), 9.81 * MASSES @ (BOX - p)[:, 2]
    assert fallen > 10
    assert kinetic + 0.5 * u @ truss() @ u == pytest.approx(fallen, rel=1e-4)
    gap = [mbs.GetMarkerOutput(end, Variable.Position) for end in ends]
    assert gap[0] == pytest.approx(gap[1], abs=1e-8)


def test_static_deflection(mbs: Any) -> None:
    """Held at the frame, under weight: K zeta = forces on the modes."""
    body, nodes = add_truss(mbs, NodeRigidBodyRxyz)
    weight = mbs.AddMarker(MarkerBodyMass(bodyNumber=body))
    ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
    for i in range(6):
        mbs.AddObject(
            CoordinateConstraint(
                markerNumbers=[ground, mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=nodes[0], coordinate=i))]
            )
        )
    spring = mbs.AddMarker(MarkerSuperElementPosition(bodyNumber=body, meshNodeNumbers=[7], weightingFactors=[1.0]))
    mbs.AddLoad(exu.Force(markerNumber=spring, loadVector=[0, 0, -50]))
    mbs.AddLoad(LoadMassProportional(markerNumber=weight, loadVector=[0, 0, -9.81]))
    mbs.Assemble()
    mbs.SolveStatic()
    frequencies, modes = free_modes()
    force = np.zeros(24)
    force[2::3] = -9.81 * MASSES
    force[23] -= 50
    expected = modes @ (modes.T @ force / frequencies**2)
    assert mesh(mbs, body, Variable.DisplacementLocal).ravel() == pytest.approx(expected, abs=1e-9)


def test_stresses_are_linear_in_the_modes(mbs: Any) -> None:
    rng = np.random.default_rng(4)
    stresses, zeta = rng.normal(size=(8, 12)), np.array([0.3, -0.5])
    rows = of_points(BOX, MASSES, rng.normal(size=(24, 2)))
    for variable in (Variable.StressLocal, Variable.StrainLocal):
        system = exu.SystemContainer().AddSystem()
        nodes = [add_frame(system, NodeRigidBodyEP), add_modes(system, 2, zeta)]
        body = system.AddObject(
            ObjectFFRFreducedOrder(
                nodeNumbers=nodes, outputVariableModeBasis=stresses, outputVariableTypeModeBasis=variable, **rows
            )
        )
        sensor = system.AddSensor(
            exu.SensorSuperElement(bodyNumber=body, meshNodeNumber=5, outputVariableType=variable, writeToFile=False)
        )
        system.Assemble()
        expected = zeta @ stresses[5].reshape(2, 6)
        assert system.GetSensorValues(sensor) == pytest.approx(expected)
        together, shown = exu._core._ScenePlaces(system), exu.ConfigurationType.Visualization
        all_nodes = np.einsum("m,nmi->ni", zeta, stresses.reshape(8, 2, 6))
        assert together.mesh(body, variable, shown) == pytest.approx(all_nodes)
        for component, numbers in (
            (0, all_nodes[:, 0]),
            (5, all_nodes[:, 5]),
            (6, np.zeros(8)),
            (-1, np.hypot.reduce(all_nodes, axis=1)),
        ):
            halves_of_units = np.abs(zeta) @ np.abs(stresses.reshape(8, 2, 6)).max(axis=(0, 2)) / (2 * 32767)
            found = together.mesh_numbers(body, variable, component, shown)
            assert found == pytest.approx(numbers, abs=1e-6 + 6**0.5 * halves_of_units), component
        assert together.mesh_numbers(body, Variable.Rotation, 0, shown) is None
        with pytest.raises(ValueError, match="mesh nodes have no output variable Rotation"):
            system.GetObjectOutputSuperElement(body, Variable.Rotation, 0)
        with pytest.raises(ValueError, match="a mesh node from 0 to 7"):
            system.GetObjectOutputSuperElement(body, variable, 8)


def dense_mesh(mbs: Any, angle: float = 0.0, modes: Any = None) -> tuple[int, Any]:
    """A bar along x with far more mesh nodes than coordinates, bent by two modes; returns its object and the modes."""
    rng = np.random.default_rng(7)
    points = rng.uniform([-1, -0.1, -0.2], [1, 0.1, 0.2], (700, 3))
    masses = np.full(700, MASSES.sum() / 700)
    modes = rng.normal(size=(2100, 2)) if modes is None else modes
    frame = mbs.AddNode(NodeRigidBodyRxyz(referenceCoordinates=[0, 0, 0, 0, 0, angle]))
    nodes = [frame, add_modes(mbs, 2, np.array([0.02, -0.03]))]
    body = mbs.AddObject(ObjectFFRFreducedOrder(nodeNumbers=nodes, **of_points(points, masses, modes)))
    mbs.Assemble()
    return body, modes


def test_points_of_pages_are_those_of_the_mesh(mbs: Any) -> None:
    """Single precision has rounding errors of 1e-6 of a size of some meters; modes have units of 1 / 32767 of their
    largest values."""
    body, modes = dense_mesh(mbs, 0.7)
    places, shown = exu._core._ScenePlaces(mbs), exu.ConfigurationType.Visualization
    with_zeros = modes.reshape(700, 3, 2).copy()  # gravity in all nodes of a block, which is not stored
    with_zeros[:256, 1, 0] = with_zeros[256:512, :, 1] = with_zeros[512:, 2] = 0
    for basis in (modes, 2 * modes, with_zeros.reshape(2100, 2)):
        mbs.SetObjectParameter(body, "modeBasis", basis)
        mbs.Assemble()
        for state in ([0.5, 0, 0, 0.1, 0.2, 0.3, 0.05, 0.01], np.zeros(8)):
            mbs.systemData.SetODE2Coordinates(state, shown)
            exact = places.mesh(body, Variable.Position, shown)
            found = places.mesh_points(body, places.rows(1, shown)[body], shown)
            halves_of_units = np.abs(state[-2:]) @ np.abs(basis).max(axis=0) / (2 * 32767)  # in each direction
            assert found.dtype == np.float32 and found == pytest.approx(exact, abs=1e-6 + 3**0.5 * halves_of_units)
    assert places.mesh_points(body, places.rows(1, shown)[body], exu.ConfigurationType.Current) is None


def test_displacements_for_colors_are_those_of_the_mesh(mbs: Any) -> None:
    """Their errors are in proportion to the displacements, not to where the mesh is."""
    body, modes = dense_mesh(mbs, 0.7)
    places, shown = exu._core._ScenePlaces(mbs), exu.ConfigurationType.Visualization
    deformed = np.array([0.05, 0.01])
    for frame, scale in ((np.zeros(6), 1e-6), (np.zeros(6), 1.0), (np.array([0.5, 0, 0, 0.1, 0.2, 0.3]), 1.0)):
        mbs.systemData.SetODE2Coordinates([*frame, *(scale * deformed)], shown)
        for method in (lambda: places.mesh_points(body, places.rows(1, shown)[body], shown), lambda: None):
            method()  # it computes the deformation; otherwise it is found for the numbers
            exact = places.mesh(body, Variable.Displacement, shown)
            bound = 1e-6 * np.abs(exact).max() + 3**0.5 * scale * (deformed @ np.abs(modes).max(axis=0)) / (2 * 32767)
            for component, numbers in (
                (0, exact[:, 0]),
                (2, exact[:, 2]),
                (3, np.zeros(700)),
                (-1, np.linalg.norm(exact, axis=1)),
            ):
                found = places.mesh_numbers(body, Variable.Displacement, component, shown)
                assert found == pytest.approx(numbers, abs=bound), component


def test_few_nodes_stand_for_the_size_of_a_mesh(mbs: Any) -> None:
    """The farthest points in 26 directions have a bounding box that is as large as that of all points up to a tenth,
    for any rotation."""
    for angle in (0.0, 0.4, 2.0):
        system = exu.SystemContainer().AddSystem()
        body, _ = dense_mesh(system, angle, np.zeros((2100, 2)))
        node = system.GetNodeOutput(0, Variable.Position)
        points = np.vstack(
            [exu._core._ScenePlaces(system).mesh(body, Variable.Position, exu.ConfigurationType.Current), node]
        )
        box = np.linalg.norm(np.ptp(points, axis=0))
        assert 0.9 * box < exu._core.testing.extent(system) <= box * (1 + 1e-12)


def test_user_functions_alone(mbs: Any) -> None:
    """Nothing but the functions acts if computeFFRFterms is False."""
    nodes = [add_frame(mbs, NodeRigidBodyRxyz), add_modes(mbs, 1, 0.1)]
    body = mbs.AddObject(
        ObjectFFRFreducedOrder(
            nodeNumbers=nodes,
            computeFFRFterms=False,
            stiffnessMatrixReduced=[[1000.0]],
            forceUserFunction=lambda mbs, t, item, q, q_t: [0, 0, -2.0, 0, 0, 0, -100 * q[6]],
            massMatrixUserFunction=lambda mbs, t, item, q, q_t: np.eye(7),
        )
    )
    mbs.Assemble()
    mbs.SolveDynamic(settings_for(1000, 0.5))
    assert mbs.GetObjectOutput(body, Variable.Coordinates)[[2, 6]] == pytest.approx([-0.25, 0.1 * np.cos(5)], abs=1e-5)


def test_assemble_computes_derived_parameters(mbs: Any) -> None:
    body, _ = add_truss(mbs, NodeRigidBodyEP)
    mbs.Assemble()
    _, modes = free_modes()
    shapes, found = modes.reshape(8, 3, 18), mbs.GetObject(body)
    assert found["objectIsInitialized"]
    centre = found["physicsCenterOfMass"]
    assert found["physicsCenterOfMassTilde"] @ [1, 2, 3] == pytest.approx(np.cross(centre, [1, 2, 3]))
    arms = -np.einsum("p,paj->aj", MASSES, np.cross(BOX[:, :, None], shapes, axis=1))
    np.testing.assert_allclose(found["mXRefTildePsi"], arms, rtol=0, atol=1e-12)
    crossed = -np.einsum(
        "p,piaj->iaj", MASSES, np.cross(shapes.transpose(0, 2, 1)[:, :, :, None], shapes[:, None], axis=2)
    )
    np.testing.assert_allclose(found["mPsiTildePsi"], crossed.reshape(54, 18), rtol=0, atol=1e-12)
    mbs.SetObjectParameter(body, "physicsCenterOfMass", [0, 0, 0.01])
    mbs.SolveDynamic(settings_for(1, 1e-3))
    assert mbs.GetObject(body)["physicsCenterOfMassTilde"][1, 0] == 0.01
    again = exu.SystemContainer().AddSystem()
    again.SetDictionary(mbs.GetDictionary())
    again.Assemble()


def test_weight_of_a_body_without_mesh(mbs: Any) -> None:
    """Functions alone give its inertia; weight acts on the frame, and there is no mesh node to ask."""
    nodes = [add_frame(mbs, NodeRigidBodyRxyz), add_modes(mbs, 2)]
    body = mbs.AddObject(
        ObjectFFRFreducedOrder(
            nodeNumbers=nodes,
            computeFFRFterms=False,
            physicsMass=3,
            massMatrixUserFunction=lambda mbs, t, item, q, q_t: 3 * np.eye(8),
        )
    )
    weight = mbs.AddMarker(MarkerBodyMass(bodyNumber=body))
    mbs.AddLoad(LoadMassProportional(markerNumber=weight, loadVector=[0, 0, -2]))
    mbs.Assemble()
    mbs.SolveDynamic(settings_for(100, 1))
    assert mbs.GetObjectOutput(body, Variable.Coordinates) == pytest.approx([0, 0, -1, 0, 0, 0, 0, 0], abs=1e-9)
    with pytest.raises(ValueError, match="this one has none"):
        mbs.GetObjectOutputSuperElement(body, Variable.Position, 0)


WRONG: dict[str, tuple[dict[str, Any], str]] = {
    "one node": ({"nodeNumbers": [0]}, "1 nodes, but expected two"),
    "other nodes": ({"nodeNumbers": [0, 2]}, "not available: ObjectFFRFreducedOrder with NodeRigidBodyEP, NodePoint"),
    "deformed reference": ({"nodeNumbers": [0, 3]}, "without deformation"),
    "stiffness": ({"stiffnessMatrixReduced": np.eye(2)}, "for the 3 modal coordinates"),
    "modes": ({"modeBasis": np.ones((24, 2))}, "a matrix of 24 x 3"),
    "integrals": ({"mPhitTPsi": []}, "a matrix of 3 x 3"),
    "contradiction": ({"mPhitTPsiTilde": np.ones((3, 9))}, "does not belong to mPhitTPsi"),
    "stress": ({"outputVariableTypeModeBasis": Variable.Position}, "StressLocal, StrainLocal or _None"),
    "stress modes": ({"outputVariableTypeModeBasis": Variable.StressLocal}, "a matrix of 8 x 18"),
    "positions": ({"referencePositions": np.ones(23)}, "three for each mesh node"),
    "inertia": ({"physicsInertia": np.diag([1.0, 1, -3])}, "inertia"),
}


@pytest.mark.parametrize("case", list(WRONG))
def test_inconsistent_values_are_rejected(mbs: Any, case: str) -> None:
    wrong, message = WRONG[case]
    rows = of_points(BOX, MASSES, np.random.default_rng(5).normal(size=(24, 3)))
    nodes = [
        add_frame(mbs, NodeRigidBodyEP),
        add_modes(mbs, 3),
        mbs.AddNode(NodePoint()),
        add_modes(mbs, 3, reference=0.1),
    ]
    numbers = {"nodeNumbers": [nodes[i] for i in wrong.get("nodeNumbers", [0, 1])]}
    mbs.AddObject(ObjectFFRFreducedOrder(**(rows | wrong | numbers)))
    with pytest.raises(ValueError, match=message):
        mbs.Assemble()
