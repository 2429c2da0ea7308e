"""Kinematic trees against closed forms, published values, other formulations, and conservation laws."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert import itemInterface as items
from dalembert._core import testing
from dalembert.rigidBodyUtilities import RigidBodyInertia, RotationMatrixX, RotationMatrixZ
from dalembert.testing import trees
from dalembert.testing.trees import Link, Tree, box_inertia, forward, in_python, lists, make, random_links

Solver = exu.DynamicSolverType
G = 9.81


def solve(tree: Tree, end: float, steps: int, solver: Any = Solver.RK67) -> None:
    tree.mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.endTime = end
    settings.timeIntegration.newton.relativeTolerance = 1e-11
    settings.timeIntegration.newton.absoluteTolerance = 1e-11
    settings.timeIntegration.generalizedAlpha.spectralRadius = 1
    settings.solutionSettings.writeSolutionToFile = False
    tree.mbs.SolveDynamic(settings, solverType=solver)


def assembled(tree: Tree) -> Tree:
    tree.mbs.Assemble()
    return tree


def state_of(tree: Tree) -> testing.State:
    return testing.State(assembled(tree).mbs)


# ---- equations ----------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("seed", range(6))
def test_mass_matrix_and_forces_are_those_of_spatial_vectors(seed: int) -> None:
    links, rng = random_links(seed), np.random.default_rng(100 + seed)
    q, v, a = rng.uniform(-1, 1, (3, len(links)))
    gravity = [1.0, -2.0, 9.0]
    tree = make(links, q, v, gravity=gravity, baseOffset=[3, 4, 5])
    M, f = in_python(links, gravity).ComputeMassMatrixAndForceTerms(q, v)
    s = state_of(tree)
    assert testing.mass_matrix(tree.mbs, s) == pytest.approx(np.array(M), abs=1e-12)
    s.a = a
    assert testing.residual(tree.mbs, s) == pytest.approx(M @ a + f, abs=1e-11)


@pytest.mark.parametrize("seed", range(6))
# Up to 3 and 7, factors are made in one or two registers per row; up to 16, there is a mass matrix.
@pytest.mark.parametrize("n", [1, 2, 3, 5, 7, 8, 11, 16, 17, 40])
def test_forward_dynamics_are_the_inverse_of_inverse_dynamics(seed: int, n: int) -> None:
    links, rng = random_links(seed, n), np.random.default_rng(seed)
    q, v, torques = rng.uniform(-1, 1, (3, n))
    tree = make(links, q, v, gravity=[0, 0, -G], jointForceVector=torques)
    s = state_of(tree)
    a = forward(tree)
    s.a = a
    scale = np.abs(testing.mass_matrix(tree.mbs, s)).max() * np.abs(a).max() + 1
    assert testing.residual(tree.mbs, s) == pytest.approx(0, abs=1e-12 * scale)


def test_double_pendulum() -> None:
    """Two uniform rods; equations as in any textbook, with absolute angles."""
    m, length = 1.3, 0.8
    rod = {"mass": m, "com": [length / 2, 0, 0], "inertia": np.diag([0, 1, 1]) * m * length**2 / 12}
    links = [Link("Rz", **rod), Link("Rz", 0, offset=[length, 0, 0], **rod)]
    q, v = np.array([0.4, -1.1]), np.array([1.5, -2.5])
    tree = make(links, q, v, gravity=[0, -G, 0])
    first, second = q[0], q[0] + q[1]
    rates = np.array([v[0], v[0] + v[1]])
    coupling = m * length**2 / 2
    M = np.array(
        [
            [4 * m * length**2 / 3, coupling * np.cos(first - second)],
            [coupling * np.cos(first - second), m * length**2 / 3],
        ]
    )
    turning = coupling * np.sin(first - second) * np.array([-(rates[1] ** 2), rates[0] ** 2])
    weight = -m * G * length / 2 * np.array([3 * np.cos(first), np.cos(second)])
    absolute = np.linalg.solve(M, turning + weight)
    assert forward(tree) == pytest.approx([absolute[0], absolute[1] - absolute[0]], rel=1e-12)


def test_cart_with_pendulum() -> None:
    M, m, length, angle, rate, push = 2.0, 0.7, 1.2, 0.5, 1.7, 3.0  # the pendulum hangs at angle 0
    links = [Link("Px", mass=M), Link("Rz", 0, m, com=[0, -length, 0])]
    tree = make(links, [0.3, angle], [0.1, rate], gravity=[0, -G, 0], jointForceVector=[push, 0])
    s, c = np.sin(angle), np.cos(angle)
    cart = (push + m * s * (length * rate**2 + G * c)) / (M + m * s**2)
    swing = (-push * c - m * length * rate**2 * c * s - (M + m) * G * s) / (length * (M + m * s**2))
    assert forward(tree) == pytest.approx([cart, swing], rel=1e-12)


BRANCHED = [
    Link("Rz", -1, 5, [0, 0, 0.1], box_inertia(5, [0.4, 0.4, 0.2])),
    Link("Ry", 0, 2, [0.25, 0, 0], box_inertia(2, [0.5, 0.1, 0.1]), [0, 0, 0.2]),
    Link("Rx", 1, 1, [0.1, 0.2, 0], box_inertia(1, [0.1, 0.4, 0.1]), [0.5, 0.1, 0]),
    Link("Ry", 2, 0.7, [0, 0.05, -0.15], box_inertia(0.7, [0.1, 0.1, 0.3]), [0, 0.4, 0]),
    Link("Px", 1, 0.9, [0.05, -0.1, 0], box_inertia(0.9, [0.2, 0.2, 0.1]), [0.5, -0.1, 0]),
    Link("Rz", 4, 0.6, [0.15, 0, 0.02], box_inertia(0.6, [0.3, 0.05, 0.05]), [0.1, -0.2, 0]),
]


def test_branched_tree_at_a_state() -> None:
    """Values computed by other methods, with 12 digits."""
    tree = make(BRANCHED, [0.3, -0.4, 0.5, -0.6, 0.2, 0.7], [1, -0.5, 0.8, 1.2, -0.3, 0.9], gravity=[0, 0, -G])
    M = testing.mass_matrix(tree.mbs, state_of(tree))
    entries = {
        (0, 0): 1.940807978154, (0, 1): -0.121893458904, (0, 4): 0.278179217339, (1, 1): 1.809591252849, (1, 2): -0.29227759106,
        (2, 2): 0.21099073541, (4, 4): 1.5, (4, 5): -0.057979591851,
    }  # fmt: skip
    assert {at: M[at] for at in entries} == pytest.approx(entries, abs=2e-12)
    expected = [1.994298542827, 12.894586136427, -3.167731143557, 11.397209317307, -3.439292301815, -3.948297156448]
    assert forward(tree) == pytest.approx(expected, abs=2e-11)


MOTION_OF_BRANCHED = {  # coordinates over time (s); uncertainty 2e-9
    0.5: [0.437033464, 1.290105721, -0.847618154, -1.518340184, 0.688320266, 0.052191689],
    1.0: [1.828872817, 1.850289952, -1.025303088, -1.508339974, 2.528036613, 0.471552177],
}


def motion_of_branched_tree(end: float, steps: int, solver: Any = Solver.RK67) -> np.ndarray:
    """Coordinates, from q = 0 with unit velocity of the first joint."""
    control = {"jointPControlVector": np.zeros(6), "jointDControlVector": [0.2, 0.2, 0.2, 0.2, 5, 0.2]}
    tree = make(BRANCHED, v=[1, 0, 0, 0, 0, 0], gravity=[0, 0, -G], **control)
    solve(tree, end, steps, solver)
    return np.array(tree.coordinates)


@pytest.mark.parametrize("end", MOTION_OF_BRANCHED)
def test_motion_of_branched_tree(end: float) -> None:
    found = motion_of_branched_tree(end, round(2000 * end))
    assert found == pytest.approx(MOTION_OF_BRANCHED[end], abs=3e-9)


TIP_OF_CHAIN = {  # x and y (m) over damping (Nms/rad) and time (s); uncertainty 1e-10
    (0.0, 0.5): [4.55618084975, -1.22630291184],
    (0.0, 1.0): [0.57327217864, -4.92983877617],
    (0.5, 1.0): [0.73940093044, -4.94246136942],
}


def tip_of_chain(damping: float, end: float, steps: int, solver: Any = Solver.RK67) -> np.ndarray:
    """Tip of a chain of ten rods that falls from the horizontal."""
    rod = {"mass": 1.0, "com": [0.25, 0, 0], "inertia": np.diag([0, 1, 1]) * 0.25 / 12}
    links = [Link("Rz", i - 1, offset=[0.5 if i else 0, 0, 0], **rod) for i in range(10)]
    tree = make(links, gravity=[0, -G, 0], jointDControlVector=np.full(10, damping))
    solve(tree, end, steps, solver)
    return tree.of_link("Position", 9, [0.5, 0, 0])[:2]


@pytest.mark.parametrize(("damping", "end"), TIP_OF_CHAIN)
def test_chain_of_ten_rods(damping: float, end: float) -> None:
    assert tip_of_chain(damping, end, round(4000 * end)) == pytest.approx(TIP_OF_CHAIN[damping, end], abs=1e-9)


# ---- conserved quantities
# ------------------------------------------------------------------------------------------------
def floating(links: list[Link]) -> list[Link]:
    """The links on a base with six coordinates, which has no mass but in the last of its joints."""
    base = [Link(joint, i - 1) for i, joint in enumerate(["Px", "Py", "Pz", "Rz", "Ry"])]
    body = Link("Rx", 4, 3.0, [0.1, 0.2, -0.1], box_inertia(3, [0.5, 0.6, 0.7]))
    below = [Link(**{**vars(link), "parent": link.parent + 6}) for link in links]
    return [*base, body, *below]


def momentum(tree: Tree) -> np.ndarray:
    """Linear and angular, the latter about the global origin."""
    total = np.zeros(6)
    for i, link in enumerate(tree.links):
        if link.mass == 0:
            continue
        position, velocity = (tree.of_link(variable, i, link.com) for variable in ("Position", "Velocity"))
        rotation, spin = tree.of_link("RotationMatrix", i).reshape(3, 3), tree.of_link("AngularVelocity", i)
        total[:3] += link.mass * velocity
        total[3:] += link.mass * np.cross(position, velocity) + rotation @ link.inertia @ rotation.T @ spin
    return total


def energy(tree: Tree, gravity: np.ndarray) -> float:
    total = 0.0
    for i, link in enumerate(tree.links):
        velocity, spin = tree.of_link("Velocity", i, link.com), tree.of_link("AngularVelocityLocal", i)
        total += 0.5 * link.mass * velocity @ velocity + 0.5 * spin @ link.inertia @ spin
        total -= link.mass * gravity @ tree.of_link("Position", i, link.com)
    return total


@pytest.mark.parametrize("seed", range(2))
def test_floating_tree_keeps_momentum_and_energy(seed: int) -> None:
    links = floating(random_links(seed, 5))
    rng = np.random.default_rng(seed)
    q, v = 0.5 * rng.uniform(-1, 1, (2, len(links)))
    after = [make(links, q, v) for _ in range(2)]
    solve(after[0], 1e-9, 1)
    solve(after[1], 1.0, 1000)
    start, end = (momentum(tree) for tree in after)
    assert end == pytest.approx(start, abs=1e-7)
    assert energy(after[1], np.zeros(3)) == pytest.approx(energy(after[0], np.zeros(3)), rel=1e-8)


@pytest.mark.parametrize("n", [4, 20])
def test_floating_tree_moves_the_same_far_away(n: int) -> None:
    """At 1000 km: inertias about the base would have lost 12 digits."""
    links = floating(random_links(n, n))
    q, v = 0.5 * np.random.default_rng(n).uniform(-1, 1, (2, len(links)))
    here = forward(make(links, q, v))
    q[:3] += 1e6
    there = forward(make(links, q, v))
    assert there == pytest.approx(here, abs=1e-9 * np.abs(here).max())


# ---- other formulations -------------------------------------------------------------------------------------------------
ARM = [
    Link("Rz", -1, 2.0, [0.2, 0.05, 0], box_inertia(2, [0.4, 0.1, 0.2]), [0.1, 0.2, 0.3]),
    Link("Ry", 0, 1.5, [0.15, 0, 0.05], box_inertia(1.5, [0.3, 0.2, 0.1]), [0.4, 0, 0.1], RotationMatrixX(0.4)),
    Link("Px", 1, 1.0, [0.1, 0.1, 0], box_inertia(1, [0.2, 0.3, 0.1]), [0.3, 0.1, 0], RotationMatrixZ(0.7)),
]


def with_redundant_coordinates(mbs: Any, links: list[Link], base: Any, q: Any, v: Any, gravity: Any) -> list[Any]:
    """The links as rigid bodies with joints, in the state that the tree has; returns the bodies."""
    tree = assembled(make(links, q, v, baseOffset=base))
    bodies: list[Any] = []
    for i, link in enumerate(links):
        frame = {name: tree.of_link(name, i) for name in ("Position", "RotationMatrix", "Velocity", "AngularVelocity")}
        rotation = frame["RotationMatrix"].reshape(3, 3)
        inertia = RigidBodyInertia(link.mass, link.inertia, link.com, inertiaTensorAtCOM=True)
        start = {"referencePosition": frame["Position"], "referenceRotationMatrix": rotation}
        rates = {"initialVelocity": frame["Velocity"], "initialAngularVelocity": frame["AngularVelocity"]}
        body = mbs.CreateRigidBody(inertia=inertia, gravity=gravity, **start, **rates)
        before = mbs.CreateGround() if link.parent < 0 else bodies[link.parent]
        free = list(trees.JOINTS).index(link.joint)  # rotations first, in the order of joints
        axes = [0 if axis == (free - 3 if free > 2 else free + 3) else 1 for axis in range(6)]
        mbs.CreateGenericJoint(
            bodyNumbers=[before, body], position=frame["Position"], rotationMatrixAxes=rotation, constrainedAxes=axes
        )
        bodies.append(body)
    return bodies


def test_tree_moves_like_bodies_with_joints() -> None:
    q, v, gravity, base = [0.3, -0.5, 0.2], [1.0, -2.0, 0.5], [0.5, -3, -8], [0.5, -1, 2]
    tree = make(ARM, q, v, gravity=gravity, baseOffset=base)
    solve(tree, 0.4, 400)
    errors = []
    for steps in (100, 200):
        mbs = exu.SystemContainer().AddSystem()
        bodies = with_redundant_coordinates(mbs, ARM, base, q, v, gravity)
        solve(Tree(mbs, None, None, ARM), 0.4, steps, Solver.TrapezoidalIndex2)
        place = [mbs.GetObjectOutputBody(body, exu.OutputVariableType.Position, [0, 0, 0]) for body in bodies]
        errors.append(np.abs(place - np.array([tree.of_link("Position", i) for i in range(3)])).max())
    assert errors[1] < 1e-4
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.05)  # second order: the difference is the integrator's


def test_weight_and_forces_on_links_are_loads_on_markers() -> None:
    links, rng = random_links(3, 6), np.random.default_rng(3)
    q, v = rng.uniform(-1, 1, (2, 6))
    forces, torques = rng.uniform(-5, 5, (2, 6, 3))
    gravity = np.array([1.0, 2.0, -9.0])
    lists_of_vectors = {"linkForces": exu.Vector3DList(list(forces)), "linkTorques": exu.Vector3DList(list(torques))}
    by_parameters = make(links, q, v, gravity=gravity, **lists_of_vectors)
    by_loads = make(links, q, v)
    for i, link in enumerate(links):
        on = {"objectNumber": by_loads.body, "linkNumber": i}
        centre = by_loads.mbs.AddMarker(items.MarkerKinematicTreeRigid(localPosition=link.com, **on))
        origin = by_loads.mbs.AddMarker(items.MarkerKinematicTreeRigid(**on))
        by_loads.mbs.AddLoad(items.Force(markerNumber=centre, loadVector=link.mass * gravity))
        by_loads.mbs.AddLoad(items.Force(markerNumber=origin, loadVector=forces[i]))
        by_loads.mbs.AddLoad(items.Torque(markerNumber=origin, loadVector=torques[i]))
    states = [state_of(tree) for tree in (by_parameters, by_loads)]
    results = [
        (testing.residual(tree.mbs, s), testing.tangent(tree.mbs, s, cq=0.7, cv=0.2, ca=0.1))
        for tree, s in zip((by_parameters, by_loads), states, strict=True)
    ]
    for one, other in zip(*results, strict=True):
        assert one == pytest.approx(other, abs=1e-11)


def test_force_on_a_link_accelerates_it_along() -> None:
    tree = make([Link("Px", mass=2.0)], linkForces=exu.Vector3DList([[3, 0, 0]]))
    solve(tree, 1.0, 10)
    assert tree.coordinates == pytest.approx([0.75])


def test_tree_and_other_bodies_in_one_system() -> None:
    """A mass on a spring at a link moves equally with each solver, with and without the tree's own factors."""
    results = []
    for solver, shared in ((Solver.RK44, False), (Solver.RK44, True), (Solver.GeneralizedAlpha, False)):
        tree = make(ARM, [0.3, -0.5, 0.2], gravity=[0, 0, -G])
        mass = tree.mbs.CreateMassPoint(referencePosition=[0.5, 0.5, 0.5], physicsMass=0.7, gravity=[0, 0, -G])
        place = {"objectNumber": tree.body, "linkNumber": 2, "localPosition": [0.1, 0, 0]}
        on = tree.mbs.AddMarker(items.MarkerKinematicTreeRigid(**place))
        at = tree.mbs.AddMarker(items.MarkerBodyPosition(bodyNumber=mass))
        tree.mbs.AddObject(items.CartesianSpringDamper(markerNumbers=[on, at], stiffness=[50] * 3, damping=[1] * 3))
        if shared:  # a mass matrix of zeros: the coordinates are no longer the tree's alone
            tree.mbs.AddObject(items.ObjectGenericODE2(nodeNumbers=[tree.node], massMatrix=np.zeros((3, 3))))
        solve(tree, 0.2, 400, solver)
        results.append(tree.coordinates)
    assert np.abs(results[0] - [0.3, -0.5, 0.2]).min() > 0.01
    assert results[1] == pytest.approx(results[0], abs=1e-12)
    assert results[2] == pytest.approx(results[0], abs=1e-5)


def test_four_bar_of_two_trees() -> None:
    """Two trees that meet in a joint keep it closed, and their energy."""
    rod = {"mass": 1.0, "com": [0.25, 0, 0], "inertia": np.diag([0, 1, 1]) * 0.25 / 12}
    pair = [Link("Rz", -1, **rod), Link("Rz", 0, offset=[0.5, 0, 0], **rod)]
    mbs = exu.SystemContainer().AddSystem()
    gravity = [0, -G, 0]
    left = make(pair, [np.pi / 2, -np.pi / 2], mbs=mbs, gravity=gravity)
    right = make(pair[:1], [np.pi / 2], mbs=mbs, gravity=gravity, baseOffset=[0.5, 0, 0])
    ends = [(left, 1), (right, 0)]
    markers = [
        mbs.AddMarker(items.MarkerKinematicTreeRigid(objectNumber=t.body, linkNumber=i, localPosition=[0.5, 0, 0]))
        for t, i in ends
    ]
    mbs.AddObject(items.SphericalJoint(markerNumbers=markers, constrainedAxes=[1, 1, 0]))
    mbs.AddLoad(items.Force(markerNumber=markers[0], loadVector=[2, 0, 0]))
    solve(left, 0.6, 600, Solver.GeneralizedAlpha)
    corners = [t.of_link("Position", i, [0.5, 0, 0]) for t, i in ends]
    assert corners[0] == pytest.approx(corners[1], abs=1e-7)
    assert left.coordinates[0] == pytest.approx(right.coordinates[0], abs=1e-6)  # a parallelogram
    # of three rods: two turn with the crank, one moves along with its end
    inertia, angle, rate = (2 / 3 + 1) * 0.25, left.coordinates[0], left.rates[0]
    fallen = G * 0.5 * 2 * (1 - np.sin(angle)) + 2 * 0.5 * np.cos(angle)
    assert 0.5 * inertia * rate**2 == pytest.approx(fallen, rel=1e-4)


# ---- forces of joints ---------------------------------------------------------------------------------------------------
def test_controllers_and_user_functions() -> None:
    n = 3
    q, v = np.array([0.3, -0.5, 0.2]), np.array([1.0, -2.0, 0.5])
    P, D, u, w, f = np.random.default_rng(5).uniform(1, 2, (5, n))
    control = {"jointPControlVector": P, "jointDControlVector": D}
    goal = {"jointPositionOffsetVector": u, "jointVelocityOffsetVector": w, "jointForceVector": f}
    plain = testing.residual((tree := make(ARM, q, v)).mbs, state_of(tree))
    controlled = testing.residual((tree := make(ARM, q, v, **control, **goal)).mbs, state_of(tree))
    assert plain - controlled == pytest.approx(P * (u - q) + D * (w - v) + f, rel=1e-13)

    def law(mbs: Any, t: float, item: int, q: Any, q_t: Any) -> Any:
        return P * (u - np.array(q)) + D * (w - np.array(q_t)) + f

    by_function = make(ARM, q, v, forceUserFunction=law)
    assert testing.residual(by_function.mbs, state_of(by_function)) == pytest.approx(controlled, rel=1e-13)
    s = state_of(tree)
    tangents = [testing.tangent(t.mbs, state_of(t), cq=1, cv=0.5, ca=0.1) for t in (tree, by_function)]
    assert tangents[1] == pytest.approx(tangents[0], abs=1e-6)
    force = tree.mbs.GetObjectOutput(tree.body, exu.OutputVariableType.Force)
    assert force == pytest.approx(testing.residual(tree.mbs, s), rel=1e-13)


def test_goals_of_controllers_can_change_while_a_solver_runs() -> None:
    zeros = np.zeros(1)
    control = {"jointPControlVector": [100.0], "jointDControlVector": [20.0], "jointPositionOffsetVector": zeros}
    tree = make([Link("Rz", mass=1.0, inertia=np.eye(3))], **control)

    def move(mbs: Any, t: float) -> bool:
        mbs.SetObjectParameter(tree.body, "jointPositionOffsetVector", [0.5])
        return True

    tree.mbs.SetPreStepUserFunction(move)
    solve(tree, 5.0, 1000, Solver.RK44)
    assert tree.coordinates == pytest.approx([0.5], abs=1e-9)


def test_joint_that_nothing_resists_is_named() -> None:
    tree = make([Link("Rz", mass=1.0, inertia=np.eye(3)), Link("Rx", 0)], gravity=[0, -G, 0])
    with pytest.raises(exu.SolverError, match="coordinate 1"):
        solve(tree, 0.1, 10, Solver.RK44)


# ---- refusals -----------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("change", "text"),
    [
        ({"linkMasses": [1.0, 2.0]}, "linkMasses.*list of length 2.*length 3"),
        ({"jointTypes": []}, "jointTypes.*length 0.*length 3"),
        ({"jointForceVector": [1.0]}, "jointForceVector.*length 1.*or none"),
        ({"linkParents": [-1, 1, 0]}, "linkParents.*entry 1: 1.*smaller number"),
        ({"linkParents": [-1, 0, -2]}, "linkParents.*entry 2: -2"),
        ({"linkMasses": [1.0, -2.0, 1.0]}, "linkMasses.*entry 1: -2"),
        ({"linkInertiasCOM": [np.eye(3), -np.eye(3), np.eye(3)]}, "linkInertiasCOM.*entry 1"),
        ({"jointTypes": [exu.JointType.RevoluteX] * 2 + [exu.JointType._None]}, "jointTypes.*entry 2"),
    ],
    ids=lambda value: next(iter(value)) if isinstance(value, dict) else "",
)
def test_wrong_parameters_are_refused(change: dict[str, Any], text: str) -> None:
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(items.NodeGenericODE2(numberOfODE2Coordinates=3))
    mbs.AddObject(items.ObjectKinematicTree(nodeNumber=node, **lists(ARM) | change))
    with pytest.raises(ValueError, match=text):
        mbs.Assemble()


@pytest.mark.parametrize(
    "change", [{"linkInertiasCOM": [np.eye(3)]}, {"linkParents": []}, {"jointOffsets": [[0, 0, 0]]}]
)
def test_markers_do_not_read_behind_short_lists(change: dict[str, Any]) -> None:
    """Markers are placed before objects, and read the parameters of their trees."""
    tree = make(ARM)
    tree.mbs.AddMarker(items.MarkerKinematicTreeRigid(objectNumber=tree.body, linkNumber=2))
    tree.mbs.Assemble()
    tree.mbs.ModifyObject(tree.body, change)
    with pytest.raises(ValueError, match=f"{next(iter(change))}.*length [01].*length 3"):
        tree.mbs.Assemble()


def test_links_that_are_not_there_are_refused() -> None:
    tree = make(ARM)
    tree.mbs.AddMarker(items.MarkerKinematicTreeRigid(objectNumber=tree.body, linkNumber=3))
    with pytest.raises(ValueError, match=r"linkNumber.*3.*a link from 0 to 2"):
        tree.mbs.Assemble()
    with pytest.raises(ValueError, match=r"linkNumber.*5.*a link from 0 to 2"):
        assembled(make(ARM)).of_link("Position", 5)
    with pytest.raises(ValueError, match="StressLocal.*an output variable of links"):
        assembled(make(ARM)).of_link("StressLocal", 0)
