"""Machines whose constraints follow from each other: vehicles, robots, ladders; and functions other than solvers that
use them."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import pytest
import scipy.sparse as sp
from scipy.spatial.transform import Rotation
from solving import Solver, Variable, new_system, settings
from test_redundant import Door, assert_smallest, redundancy

import dalembert as exu
from dalembert._core import testing
from dalembert.rigidBodyUtilities import InertiaCuboid, InertiaCylinder


def bar(mbs: Any, start: Any, end: Any, gravity: Any = (0, 0, -9.81)) -> Any:
    start, end = np.array(start, dtype=float), np.array(end, dtype=float)
    length = float(np.linalg.norm(end - start))
    along = (end - start) / length
    side = np.cross([0, 1, 0] if abs(along[2]) > 0.9 else [0, 0, 1], along)
    side /= np.linalg.norm(side)
    return mbs.CreateRigidBody(
        referencePosition=(start + end) / 2,
        referenceRotationMatrix=np.column_stack([along, side, np.cross(along, side)]),
        inertia=InertiaCuboid(1000, [length, 0.05, 0.05]),
        gravity=gravity,
    )


# ---- a vehicle with doubled joints ----------------------------------------------------------------------------------------


def trolley(bearings: int) -> Any:
    """Four wheels, each in so many bearings along its axle; the chassis stands on springs under its corners."""
    mbs = new_system()
    ground = mbs.CreateGround()
    chassis = mbs.CreateRigidBody(
        referencePosition=[0, 0, 1], inertia=InertiaCuboid(200, [2, 1, 0.2]), gravity=[0, 0, -9.81]
    )
    for x in (-0.8, 0.8):
        for y in (-0.5, 0.5):
            mbs.CreateCartesianSpringDamper(
                bodyNumbers=[ground, chassis],
                localPosition0=[x, y, 1],
                localPosition1=[x, y, 0],
                stiffness=[1e4] * 3,
                damping=[300] * 3,
            )
            wheel = mbs.CreateRigidBody(
                referencePosition=[x, y, 0.8],
                inertia=InertiaCylinder(1000, 0.1, 0.2, axis=1),
                initialAngularVelocity=[0, 10 * (x + 1), 0],
                gravity=[0, 0, -9.81],
            )
            for k in range(bearings):
                mbs.CreateRevoluteJoint(bodyNumbers=[chassis, wheel], position=[x, y - 0.1 * k, 0.8], axis=[0, 1, 0])
    mbs.Assemble()
    return mbs


def test_a_vehicle_with_doubled_joints() -> None:
    results = []
    for bearings in (1, 2):
        mbs = trolley(bearings)
        s = settings(0.5, 100, tolerance=1e-12)
        s.redundantConstraints.momentLength = 1.0
        mbs.SolveDynamic(s)
        assert redundancy(mbs)["count"] == 5 * 4 * (bearings - 1)
        counts = mbs.ComputeSystemDegreeOfFreedom()
        assert (counts["degreeOfFreedom"], counts["redundantConstraints"]) == (10, 20 * (bearings - 1))
        results.append(
            [mbs.GetObjectOutputBody(exu.ObjectIndex(1), Variable.Position, [x, 0.4, 0]) for x in (-0.9, 0.9)]
        )
    assert np.array(results[1]) == pytest.approx(np.array(results[0]), abs=1e-9)
    assert_smallest(mbs, 1.0)


# ---- a parallel robot -----------------------------------------------------------------------------------------------------


def delta_robot() -> Any:
    """Three arms with parallelograms of four hinges each, which keep the platform level: far more equations than needed."""
    mbs = new_system()
    ground = mbs.CreateGround()
    platform = mbs.CreateRigidBody(
        referencePosition=[0, 0, -0.8], inertia=InertiaCuboid(1000, [0.2, 0.2, 0.02]), gravity=[0, 0, -9.81]
    )
    for angle in 2 * np.pi / 3 * np.arange(3):
        out, side = np.array([np.cos(angle), np.sin(angle), 0]), np.array([-np.sin(angle), np.cos(angle), 0])
        shoulder, elbow, wrist = 0.3 * out, 0.7 * out + [0, 0, -0.1], 0.1 * out + [0, 0, -0.8]
        normal = np.cross(wrist - elbow, side) / np.linalg.norm(wrist - elbow)
        upper = bar(mbs, shoulder, elbow)
        mbs.CreateRevoluteJoint(bodyNumbers=[ground, upper], position=shoulder, axis=side)
        crossbars = [bar(mbs, place - 0.1 * side, place + 0.1 * side) for place in (elbow, wrist)]
        mbs.CreateRevoluteJoint(bodyNumbers=[upper, crossbars[0]], position=elbow, axis=side)
        mbs.CreateRevoluteJoint(bodyNumbers=[crossbars[1], platform], position=wrist, axis=side)
        for sign in (-0.1, 0.1):
            rod = bar(mbs, elbow + sign * side, wrist + sign * side)
            for crossbar, place in zip(crossbars, (elbow, wrist), strict=True):
                mbs.CreateRevoluteJoint(bodyNumbers=[crossbar, rod], position=place + sign * side, axis=normal)
    mbs.Assemble()
    return mbs


@pytest.mark.parametrize("linear", [exu.LinearSolverType.EXUdense, exu.LinearSolverType.EigenSparse])
def test_a_parallel_robot(linear: Any) -> None:
    """Sixteen bodies in space with 21 hinges: three motions are left."""
    mbs = delta_robot()
    counts = mbs.ComputeSystemDegreeOfFreedom()
    bodies, joints = 1 + 3 * 5, 3 * 7
    assert counts["degreeOfFreedom"] == 3
    assert counts["redundantConstraints"] == 5 * joints - 6 * bodies + 3
    # Forces of 60 N; round-off of 1e-16 m is 1e-12 N in steps of a millisecond. Factors that are less exact leave 1e-10 N.
    s = settings(0.05, 50, tolerance=1e-12)
    s.linearSolverType = linear
    s.redundantConstraints.momentLength = 1.0
    mbs.SolveDynamic(s)
    assert redundancy(mbs)["count"] == counts["redundantConstraints"]
    assert_smallest(mbs, 1.0)
    platform = exu.ObjectIndex(1)
    level = mbs.GetObjectOutputBody(platform, Variable.RotationMatrix, [0, 0, 0]).reshape(3, 3)
    assert level == pytest.approx(np.eye(3), abs=1e-9)
    assert mbs.GetObjectOutputBody(platform, Variable.Position, [0, 0, 0])[:2] == pytest.approx(np.zeros(2), abs=1e-9)


# ---- arms that are trees -------------------------------------------------------------------------------------------------


def closed_arm(closing: list[int]) -> tuple[Any, Any]:
    """System and node of four links that turn about parallel axes, which lean, the last one held at a point of the ground by these axes of a
    joint."""
    mbs = new_system()
    plane, angles, length = Rotation.from_euler("xyz", [0.3, 0.5, -0.4]).as_matrix(), [0.4, 0.7, 0.5, 0.6], 0.7
    along = np.array([length, 0, 0])
    node = mbs.AddNode(
        exu.NodeGenericODE2(
            referenceCoordinates=angles,
            initialCoordinates=[0] * 4,
            initialCoordinates_t=[0] * 4,
            numberOfODE2Coordinates=4,
        )
    )
    arm = mbs.AddObject(
        exu.KinematicTree(
            nodeNumber=node,
            jointTypes=[exu.JointType.RevoluteZ] * 4,
            linkParents=[-1, 0, 1, 2],
            jointTransformations=exu.Matrix3DList([plane, *[np.eye(3)] * 3]),
            jointOffsets=exu.Vector3DList([[0, 0, 0], *[along] * 3]),
            linkInertiasCOM=exu.Matrix3DList([np.diag([0.01, 0.05, 0.05])] * 4),
            linkCOMs=exu.Vector3DList([0.5 * along] * 4),
            linkMasses=[1.0, 2.0, 0.5, 1.0],
            gravity=[2, -3, -9.81],
        )
    )
    bends = np.cumsum(angles)
    tip = plane @ (length * np.array([np.cos(bends).sum(), np.sin(bends).sum(), 0]))
    markers = [
        mbs.AddMarker(exu.MarkerKinematicTreeRigid(objectNumber=arm, linkNumber=3, localPosition=along)),
        mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=mbs.CreateGround(), localPosition=tip)),
    ]
    turned = Rotation.from_euler("z", -bends[-1]).as_matrix()
    mbs.AddObject(
        exu.GenericJoint(markerNumbers=markers, constrainedAxes=closing, rotationMarker0=turned, rotationMarker1=plane)
    )
    mbs.Assemble()
    return mbs, node


@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.TrapezoidalIndex2, Solver.ESDIRK43, Solver.DOPRI5])
def test_an_arm_in_a_plane_that_leans(solver: Any) -> None:
    """A full joint closes it: its out-of-plane constraint acts on its coordinates by round-off only, which made
    multipliers 1e8 times too large."""
    states = []
    for closing in ([1, 1, 1, 1, 1, 0], [1, 1, 0, 0, 0, 0]):
        mbs, node = closed_arm(closing)
        s = settings(0.3, 300)
        s.timeIntegration.automaticStepSize = False
        assert mbs.SolveDynamic(s, solverType=solver) is True
        assert redundancy(mbs)["count"] == (3 if closing[2] else 0)
        states.append(
            np.concatenate([mbs.GetNodeOutput(node, v) for v in (Variable.Coordinates, Variable.Coordinates_t)])
        )
        assert_smallest(mbs, 1)
    # Joints with velocity constraints drift, and along other axes.
    tolerance = 1e-5 if solver == Solver.TrapezoidalIndex2 else 1e-7
    np.testing.assert_allclose(states[0], states[1], rtol=0, atol=tolerance)


# ---- large, and not only solvers --------------------------------------------------------------------------------------------


def ladder(loops: int) -> Any:
    """Each loop stands on the rung of the one below."""
    mbs = new_system()
    below = mbs.CreateGround()
    for k in range(loops):
        left, right, rung = (
            bar(mbs, [0, k, 0], [0, k + 1, 0]),
            bar(mbs, [1, k, 0], [1, k + 1, 0]),
            bar(mbs, [0, k + 1, 0], [1, k + 1, 0]),
        )
        for one, other, place in (
            (below, left, [0, k, 0]),
            (below, right, [1, k, 0]),
            (left, rung, [0, k + 1, 0]),
            (right, rung, [1, k + 1, 0]),
        ):
            mbs.CreateRevoluteJoint(bodyNumbers=[one, other], position=place, axis=[0, 0, 1])
        below = rung
    mbs.Assemble()
    return mbs


def test_many_equations() -> None:
    """A ladder of 1200 loops in space: 24000 equations, of which three per loop follow from others.

    The other constraint of its top is so weak, with the fourth power of its height, that it nearly vanishes as well;
    but loops are looked at
    one by one, so that there is nothing to warn of.
    """
    loops = 1200
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        counts = ladder(loops).ComputeSystemDegreeOfFreedom()
    assert (counts["degreeOfFreedom"], counts["redundantConstraints"]) == (loops, 3 * loops)


def test_a_hundred_thousand_equations() -> None:
    """The same with 5000 loops, from their items: redundancy is detected at the start, and steps use it. Steps keep the
    ladder together."""
    loops, mbs = 5000, new_system()
    ground = mbs.AddObject(exu.ObjectGround())
    half_turn = np.sqrt(0.5)

    def rod(x: float, y: float, upright: bool) -> Any:
        turned = [half_turn, 0, 0, half_turn] if upright else [1, 0, 0, 0]
        node = mbs.AddNode(exu.NodeRigidBodyEP(referenceCoordinates=[x, y, 0, *turned]))
        return mbs.AddObject(exu.RigidBody(physicsMass=2.5, physicsInertia=[1e-3, 0.2, 0.2, 0, 0, 0], nodeNumber=node))

    def join(*ends: tuple[Any, float]) -> None:
        markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=b, localPosition=[x, 0, 0])) for b, x in ends]
        mbs.AddObject(exu.RevoluteJointZ(markerNumbers=markers))

    below = [(ground, 0.0), (ground, 1.0)]
    for k in range(loops):
        sides, rung = [rod(x, k + 0.5, True) for x in (0, 1)], rod(0.5, k + 1, False)
        for foot, side, x in zip(below, sides, (-0.5, 0.5), strict=True):
            join(foot, (side, -0.5))
            join((side, 0.5), (rung, x))
        below = [(rung, -0.5), (rung, 0.5)]
    top = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=rung))
    mbs.AddLoad(exu.Force(markerNumber=top, loadVector=[1e3, 0, 0]))
    mbs.Assemble()
    assert mbs.systemData.SystemSize() > 2e5
    mbs.SolveDynamic(settings(2e-3, 2))
    assert redundancy(mbs)["count"] == 3 * loops
    heights = [mbs.GetObjectOutputBody(rung, Variable.Position, [x, 0, 0])[1] for x in (-0.5, 0.5)]
    assert heights == pytest.approx([loops, loops], abs=1e-6)
    assert mbs.GetObjectOutputBody(rung, Variable.Position, [0, 0, 0])[0] > 0.5


def entries_of_factors(mbs: Any, eps: float) -> int:
    """Matrix of masses and constraints, with eps times the size of each equation on the diagonal."""
    state = testing.State(mbs)
    state.q, state.lam = mbs.systemData.GetODE2Coordinates(exu.ConfigurationType.Initial), np.zeros_like(state.lam)
    n, total = len(state.q), len(state.q) + len(state.lam)
    rows, columns, masses = testing.mass_entries(mbs, state)
    diagonal, own = np.zeros(n), np.zeros(total)
    diagonal[rows[rows == columns]] = masses[rows == columns]
    equations, coordinates, gradients = testing.tangent_entries(mbs, state)
    some = (equations >= n) & (coordinates < n)
    equations, coordinates, gradients = equations[some], coordinates[some], gradients[some]
    heavy = diagonal[coordinates] > 0
    np.add.at(own, equations[heavy], gradients[heavy] ** 2 / diagonal[coordinates[heavy]])
    all_rows = np.r_[rows, equations, coordinates, range(total)]
    all_columns = np.r_[columns, coordinates, equations, range(total)]
    values = np.r_[masses, gradients, gradients, -eps * own]
    matrix = sp.csc_array(sp.coo_array((values, (all_rows, all_columns)), shape=(total, total)))
    solver = testing.LinearSolver(matrix.indptr, matrix.indices)
    assert solver.factorize(matrix.data) == -1
    return int(solver.statistics["entries"])


def test_factors_of_ladders_grow_with_their_length() -> None:
    """No choice of pivots is good there; larger ones would be handed on, for factors of twice the size.

    The numbers of entries are in proportion to those of loops, apart from those at the ends.
    """
    few, many = (entries_of_factors(ladder(loops), 1e-12) for loops in (100, 600))
    assert many / few == pytest.approx(6, abs=1)


def rails(loops: int, gravity: Any = (0, 0, -9.81), turned: float = 0) -> tuple[Any, Any]:
    """A ladder whose rungs lie between two rails, so that all loops hang together; and its last rung. Its first hinge may be turned."""
    mbs = new_system()
    below = [mbs.CreateGround()] * 2
    for k in range(loops):
        above = [bar(mbs, [x, k, 0], [x, k + 1, 0], gravity) for x in (0, 1)]
        rung = bar(mbs, [0, k + 1, 0], [1, k + 1, 0], gravity)
        for x, (one, other) in enumerate(zip(below, above, strict=True)):
            axis = [turned if k + x == 0 else 0, 0, 1]
            mbs.CreateRevoluteJoint(bodyNumbers=[one, other], position=[x, k, 0], axis=axis)
            mbs.CreateRevoluteJoint(bodyNumbers=[other, rung], position=[x, k + 1, 0], axis=[0, 0, 1])
        below = above
    mbs.Assemble()
    return mbs, rung


def rails_in_the_plane(loops: int, gravity: Any) -> tuple[Any, Any]:
    """The same with bodies and joints of the plane, where no equation follows from others."""
    mbs = new_system()
    mass, inertia = 2.5, 2.5 * (1 + 0.05**2) / 12

    def rod(x: float, y: float, angle: float) -> Any:
        node = mbs.AddNode(exu.NodeRigidBody2D(referenceCoordinates=[x, y, angle]))
        body = mbs.AddObject(exu.RigidBody2D(physicsMass=mass, physicsInertia=inertia, nodeNumber=node))
        mbs.AddLoad(exu.Gravity(markerNumber=mbs.AddMarker(exu.MarkerBodyMass(bodyNumber=body)), loadVector=gravity))
        return body

    def join(*ends: tuple[Any, list[float]]) -> None:
        markers = [mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=b, localPosition=p)) for b, p in ends]
        mbs.AddObject(exu.RevoluteJoint2D(markerNumbers=markers))

    ground = mbs.AddObject(exu.ObjectGround())
    below = [(ground, [x, 0, 0]) for x in (0, 1)]
    for k in range(loops):
        above = [rod(x, k + 0.5, np.pi / 2) for x in (0, 1)]
        rung = rod(0.5, k + 1, 0)
        for x, (one, other) in enumerate(zip(below, above, strict=True)):
            join(one, (other, [-0.5, 0, 0]))
            join((other, [0.5, 0, 0]), (rung, [x - 0.5, 0, 0]))
        below = [(body, [0.5, 0, 0]) for body in above]
    mbs.Assemble()
    return mbs, rung


def test_weak_constraints_are_told_from_redundant_ones() -> None:
    """The constraint of the tip of a ladder on rails is weak, with the fourth power of its height: 8e-9 of a joint at
    80 loops."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        counts = rails(80)[0].ComputeSystemDegreeOfFreedom()
    assert (counts["degreeOfFreedom"], counts["redundantConstraints"]) == (80, 3 * 80)
    # Three equations of a loop follow from others, and each of its four joints could lose them.
    assert set(map(tuple, counts["removableEquations"].values())) == {(3, 5)}


@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.TrapezoidalIndex2, Solver.ESDIRK43])
def test_gears_whose_inertias_differ_by_decades(solver: Any) -> None:
    """Gears on a tree of pairs, with two further pairs that mesh: all turn together, with the acceleration r.tau / (r^2.J).

    The weakest combination of constraints has a strength of 2e-10 in their metric. Where the regularization is not small
    against it, velocities are wrong by a third; where it is, by 1e-5.
    """
    inertia = np.array([4.5e-4, 8.7e-5, 4.8e-4, 1.3, 3.6e-3, 6900, 160, 1e4, 1.7e-3])
    radius = np.array([1.1, 2.5, 0.1, -5.5, -5.7, -3.4, 0.17, -4.3, 6.7])
    torque = inertia * np.array([2.4, -0.29, -0.48, 0.056, -0.83, -0.023, -1.0, -0.55, 0.98])
    mbs = new_system()
    nodes, markers = [], []
    for inertia_of, torque_of in zip(inertia, torque, strict=True):
        nodes.append(mbs.AddNode(exu.Node1D(referenceCoordinates=[0])))
        mbs.AddObject(exu.ObjectRotationalMass1D(nodeNumber=nodes[-1], physicsInertia=inertia_of))
        markers.append(mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=nodes[-1], coordinate=0)))
        mbs.AddLoad(exu.LoadCoordinate(markerNumber=markers[-1], load=torque_of))
    for a, b in [(1, 0), (2, 0), (3, 1), (4, 2), (5, 2), (6, 0), (7, 4), (8, 2), (7, 8), (7, 6)]:
        mbs.AddObject(
            exu.ObjectConnectorCoordinate(markerNumbers=[markers[b], markers[a]], factorValue1=radius[b] / radius[a])
        )
    mbs.Assemble()
    end = 0.05
    assert mbs.SolveDynamic(settings(end, 20), solverType=solver)
    velocities = np.array([mbs.GetNodeOutput(node, Variable.Coordinates_t) for node in nodes]).ravel()
    right = radius * (radius @ torque) / (radius**2 @ inertia) * end
    np.testing.assert_allclose(velocities, right, rtol=1e-4)


@pytest.mark.parametrize(("steps", "trusted"), [(50, False), (5000, True)])
def test_light_bodies_in_doubled_joints_that_drift(steps: int, trusted: bool) -> None:
    """A body of 1 kg carries one of 1000 t. Joints drift apart if velocities alone are constrained: reactions are lost in the
    regularization, which is a reason not to trust them. With small steps they are those of single joints."""
    found = []
    for joints in (1, 2):
        mbs = new_system()
        bodies, hinges = [mbs.CreateGround()], []
        for i, mass in enumerate((1.0, 1e6)):
            inertia = InertiaCuboid(mass / 0.01, [1, 0.1, 0.1])
            bodies.append(
                mbs.CreateRigidBody(referencePosition=[i + 0.5, 0, 0], inertia=inertia, gravity=[0, -9.81, 0])
            )
            for _ in range(joints):
                hinges.append(mbs.CreateRevoluteJoint(bodyNumbers=bodies[-2:], position=[i, 0, 0], axis=[0, 0, 1]))
        mbs.Assemble()
        ended = mbs.SolveDynamic(settings(0.5, steps), solverType=Solver.TrapezoidalIndex2)
        found.append(sum(np.asarray(mbs.GetObjectOutput(hinge, Variable.ForceLocal)) for hinge in hinges[:joints]))
    assert (ended is True) == trusted
    if trusted:
        np.testing.assert_allclose(found[1], found[0], rtol=1e-5, atol=1e-5 * np.linalg.norm(found[0]))
    else:
        assert any("reactions of light bodies" in doubt for doubt in ended.doubts)


def test_counts_that_are_not_certain_say_so() -> None:
    """A misaligned hinge adds constraints that are weak with the square of its angle; an error names it, and the
    joints."""
    mbs = rails(40, (9.81, 0, 0), turned=1e-4)[0]
    with pytest.warns(UserWarning, match="hardly independent of others"):
        mbs.ComputeSystemDegreeOfFreedom()
    s = settings(0.5, 5)
    s.timeIntegration.newton.maxIterations, s.timeIntegration.adaptiveStep = 1, False
    with pytest.raises(
        exu.SolverError, match=r"JointRevoluteZ\): 3 of 5 could be left out(.|\n)*hardly independent of others"
    ):
        mbs.SolveDynamic(s)


@pytest.mark.parametrize("solver", [exu.DynamicSolverType.DOPRI5, exu.DynamicSolverType.ESDIRK43])
def test_other_solvers_say_so_as_well(solver: Any) -> None:
    """A step of 0.5 s is too large for the one, and a single iteration is not enough for the other."""
    mbs = rails(40, (9.81, 0, 0), turned=1e-4)[0]
    s = settings(0.5, 1)
    s.timeIntegration.newton.maxIterations = 1
    s.timeIntegration.adaptiveStep = s.timeIntegration.automaticStepSize = False
    with pytest.raises(
        exu.SolverError, match=r"JointRevoluteZ\): 3 of 5 could be left out(.|\n)*hardly independent of others"
    ):
        mbs.SolveDynamic(s, solverType=solver)


def test_high_ladders_on_rails_fall_as_in_the_plane() -> None:
    """Both are integrated equally; differences are round-off, constraint violations, and Newton's tolerances."""
    gravity, places = [9.81, -1, -9.81], []
    for build in (rails, rails_in_the_plane):
        mbs, rung = build(100, gravity)
        mbs.SolveDynamic(settings(0.05, 10))
        places.append(mbs.GetObjectOutputBody(rung, Variable.Position, [0, 0, 0]))
    moved = places[1] - [0.5, 100, 0]
    assert np.linalg.norm(moved) > 1e-3
    assert places[0] == pytest.approx(places[1], abs=1e-7)


def test_eigenvalues_do_not_see_the_second_hinge() -> None:
    values = []
    for heights in ((1.0,), (0.3, 1.7), (0.3, 1.0, 1.7)):
        door = Door(heights)
        door.add_spring()
        found = np.asarray(door.mbs.ComputeODE2Eigenvalues()[0])
        values.append(found[np.isfinite(found)])
    assert len(values[0]) == len(values[1]) == len(values[2]) == 1
    assert values[1] == pytest.approx(values[0], rel=1e-6) and values[2] == pytest.approx(values[0], rel=1e-6)


def test_linearizations_do_not_see_the_second_hinge() -> None:
    """Whichever bases are chosen, the spring acts on one motion."""
    found = []
    for heights in ((1.0,), (0.3, 1.7), (0.3, 1.0, 1.7)):
        door = Door(heights)
        door.add_spring()
        mass, stiffness, damping, *_ = door.mbs.ComputeLinearizedSystem(projectIntoConstraintNullspace=True)
        assert mass.shape == stiffness.shape == damping.shape == (1, 1)
        found.append([mass[0, 0], stiffness[0, 0]])
    assert found[1] == pytest.approx(found[0], rel=1e-6) and found[2] == pytest.approx(found[0], rel=1e-6)


def test_variations_of_a_door() -> None:
    """Each as if it had been solved alone."""
    door = Door()
    hinge = int(door.hinges[0])
    door.mbs.AddSensor(
        exu.itemInterface.SensorObject(objectNumber=hinge, outputVariableType=Variable.ForceLocal, storeInternal=True)
    )
    door.mbs.Assemble()
    masses = [10.0, 30.0, 50.0]
    results = door.mbs.SolveVariations({(door.door, "physicsMass"): masses}, settings(0.2, 20))
    assert results.success.all()
    weights = np.array(masses) * 9.81 * np.cos(0.2) / 2
    assert np.abs(results.sensorValues[:, 2]) == pytest.approx(weights, abs=1e-6)


def test_variations_do_not_know_what_others_have_found() -> None:
    """Explicit solvers count redundant equations at the start: each variation has its own number from the first row on."""
    door = Door()
    mbs = door.mbs
    mbs.AddSensor(
        exu.itemInterface.SensorObject(
            objectNumber=door.hinges[0], outputVariableType=Variable.NonUniqueReactions, storeInternal=True
        )
    )
    mbs.Assemble()
    results = mbs.SolveVariations(
        {(door.door, "physicsMass"): [10.0, 30.0, 50.0]},
        settings(0.1, 10),
        solverType=Solver.DOPRI5,
        storeHistories=True,
        numberOfThreads=1,
    )
    told = np.array([history[:, 1] for history in results.sensorHistories])
    assert (told == 5).all()


# ---- models that are regular for all iterates of Newton's method
# ---------------------------------------------------------


def kicked_pendulum(treat: bool, solver: Any, size: float, begin: float, end: float, steps: int) -> tuple[Any, Any]:
    """Two bars that a blow turns by a radian per step or more, so that steps fail and are repeated with half of their size."""
    mbs = new_system()
    upper, lower = (bar(mbs, [x, 0, 0], [x + 1, 0, 0], gravity=[0, -9.81, 0]) for x in (0, 1))
    mbs.CreateSphericalJoint(bodyNumbers=[mbs.CreateGround(), upper], position=[0, 0, 0])
    mbs.CreateSphericalJoint(bodyNumbers=[upper, lower], position=[1, 0, 0])
    blow = lambda mbs, t, load: [0, 0, size if 0 < t - begin < 0.0199 else 0]  # noqa: E731
    mbs.CreateForce(bodyNumber=lower, localPosition=[0.5, 0, 0], loadVectorUserFunction=blow)
    mbs.Assemble()
    s = settings(end, steps, tolerance=1e-8)
    s.redundantConstraints.treat = treat
    return mbs.SolveDynamic(s, solverType=solver), mbs.systemData.GetODE2Coordinates()


@pytest.mark.parametrize(
    ("solver", "size", "begin", "end", "steps"),
    [
        (exu.DynamicSolverType.GeneralizedAlpha, 1e4, 0.1, 0.5, 50),
        (exu.DynamicSolverType.ESDIRK43, 1e8, -0.01, 0.02, 1),  # already in the first stage
        (exu.DynamicSolverType.DOPRI5, 1e4, 0.1, 0.5, 500),
    ],
)
def test_what_is_tried_is_not_taken_for_redundancy(
    solver: Any, size: float, begin: float, end: float, steps: int
) -> None:
    """Bodies that are thrown apart look as if joints did not matter, which would leave the joints apart for good."""
    (treated, coordinates), (plain, same) = (
        kicked_pendulum(treat, solver, size, begin, end, steps) for treat in (True, False)
    )
    assert treated and plain
    np.testing.assert_array_equal(coordinates, same)
