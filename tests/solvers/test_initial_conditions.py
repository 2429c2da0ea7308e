"""Inconsistent initial values cause a warning, and can be made consistent."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from oscillators import dynamic_settings

import dalembert as exu
from dalembert.itemInterface import (
    CoordinateConstraint,
    DistanceConstraint,
    MarkerBodyPosition,
    MarkerBodyRigid,
    MarkerNodeCoordinate,
    Mass1D,
    Node1D,
    NodePointGround,
    ObjectJointRevolute2D,
    ObjectJointRevoluteZ,
    ObjectJointSpherical,
)
from dalembert.rigidBodyUtilities import InertiaCuboid, RigidBodyInertia

Variable = exu.OutputVariableType
Node = exu.NodeType
Solver = exu.DynamicSolverType
Initial = exu.ConfigurationType.Initial
ROUND_OFF = 1e-12
ROD = RigidBodyInertia(mass=2, inertiaTensor=np.diag([1e-3, 2 / 12, 2 / 12]))  # of 1 m along x


def new_system() -> Any:
    return exu.SystemContainer().AddSystem()


def settings() -> Any:
    s = dynamic_settings(1e-3, 1, tolerance=1e-10)
    s.timeIntegration.verboseMode = 0
    return s


def position(mbs: Any, body: Any, place: Any = (0, 0, 0)) -> np.ndarray:
    return np.asarray(mbs.GetObjectOutputBody(body, Variable.Position, list(place), Initial))


def velocity(mbs: Any, body: Any, place: Any = (0, 0, 0)) -> np.ndarray:
    return np.asarray(mbs.GetObjectOutputBody(body, Variable.Velocity, list(place), Initial))


def point_markers(mbs: Any, *bodies: Any) -> list[Any]:
    return [mbs.AddMarker(MarkerBodyPosition(bodyNumber=body)) for body in bodies]


def two_masses(span: Any, masses: Any, joint: Any) -> tuple[Any, Any, Any, Any]:
    mbs = new_system()
    a = mbs.CreateMassPoint(referencePosition=[1, 2, 3], physicsMass=masses[0])
    b = mbs.CreateMassPoint(referencePosition=np.array([1, 2, 3]) + span, physicsMass=masses[1])
    connection = mbs.AddObject(joint(markerNumbers=point_markers(mbs, a, b)))
    mbs.Assemble()
    return mbs, a, b, connection


def hinged_rod(gap: float, nodeType: Any = Node.RotationEulerParameters, **motion: Any) -> tuple[Any, Any]:
    """A rod along x, hinged about z at its left end, which is `gap` above the hinge."""
    mbs = new_system()
    ground = mbs.CreateGround()
    rod = mbs.CreateRigidBody(referencePosition=[0.5, gap, 0], inertia=ROD, nodeType=nodeType, **motion)
    markers = [
        mbs.AddMarker(MarkerBodyRigid(bodyNumber=b, localPosition=p))
        for b, p in ((ground, [0, 0, 0]), (rod, [-0.5, 0, 0]))
    ]
    mbs.AddObject(ObjectJointRevoluteZ(name="hinge", markerNumbers=markers))
    mbs.Assemble()
    return mbs, rod


def coordinate_of(mass: Any, start: float = 0.0) -> tuple[Any, Any, Any]:
    mbs = new_system()
    node = mbs.AddNode(Node1D(referenceCoordinates=[0], initialCoordinates=[start]))
    mbs.AddObject(mass(nodeNumber=node, physicsMass=2))
    ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
    return mbs, ground, mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0))


# ---- warnings at the start of a solution
# ---------------------------------------------------------------------------------


def test_a_hinge_with_a_gap_is_named_once(capfd: pytest.CaptureFixture[str]) -> None:
    mbs, _ = hinged_rod(0.05)
    mbs.SolveDynamic(settings())
    text = capfd.readouterr().out
    assert text.count("contradict") == 1
    assert "object 2 'hinge' (ObjectJointRevoluteZ), equation 1: gap 0.05 m" in text
    assert "ComputeConsistentInitialConditions" in text


@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.TrapezoidalIndex2])
def test_velocities_against_a_joint_are_named(solver: Any, capfd: pytest.CaptureFixture[str]) -> None:
    mbs, _ = hinged_rod(0, initialVelocity=[0, 0, 3])
    mbs.SolveDynamic(settings(), solverType=solver)
    text = capfd.readouterr().out
    assert (
        "'hinge' (ObjectJointRevoluteZ), equation 2: rate of the gap 3 m/s" in text
        and text.count("rate of the gap") == 1
    )


def test_angles_are_in_radians(capfd: pytest.CaptureFixture[str]) -> None:
    mbs, _ = hinged_rod(0, initialAngularVelocity=[0.25, 0, 7])
    mbs.SolveDynamic(settings())
    text = capfd.readouterr().out
    assert ": rate of the gap 0.25 rad/s" in text or ": rate of the gap -0.25 rad/s" in text


def test_consistent_values_pass_in_silence(capfd: pytest.CaptureFixture[str]) -> None:
    mbs, _ = hinged_rod(0, initialVelocity=[0, 0.5, 0], initialAngularVelocity=[0, 0, 1])
    for solver in (Solver.GeneralizedAlpha, Solver.TrapezoidalIndex2):
        mbs.SolveDynamic(settings(), solverType=solver)
    assert capfd.readouterr().out == ""


def test_tolerances_errors_and_silence(capfd: pytest.CaptureFixture[str]) -> None:
    mbs, _ = hinged_rod(1e-3)
    s = settings()
    s.initialConditions.positionTolerance = 4e-3  # of a model of 0.5 m
    mbs.SolveDynamic(s)
    s.initialConditions.positionTolerance, s.initialConditions.checkConstraints = 1e-4, False
    mbs.SolveDynamic(s)
    assert capfd.readouterr().out == ""
    s.initialConditions.checkConstraints = s.initialConditions.inconsistentIsError = True
    with pytest.raises(ValueError, match="'hinge' .*, equation 1: gap 0.001 m"):
        mbs.SolveDynamic(s)


def test_solvers_used_step_by_step_and_explicit_ones_report_it(capfd: pytest.CaptureFixture[str]) -> None:
    mbs, ground, coordinate = coordinate_of(Mass1D, start=0.3)
    mbs.AddObject(CoordinateConstraint(name="fix", markerNumbers=[ground, coordinate]))
    mbs.Assemble()
    exu.MainSolverImplicitSecondOrder().InitializeSolver(mbs, settings())
    mbs.SolveDynamic(settings(), solverType=Solver.RK44)
    assert capfd.readouterr().out.count("'fix' (ObjectConnectorCoordinate), equation 0: gap 0.3\n") == 2


def test_joints_that_are_off_have_no_gap(capfd: pytest.CaptureFixture[str]) -> None:
    mbs, _ = hinged_rod(0.05)
    mbs.SetObjectParameter(2, "activeConnector", False)
    mbs.SolveDynamic(settings())
    assert capfd.readouterr().out == ""


def test_static_solutions_close_gaps(capfd: pytest.CaptureFixture[str]) -> None:
    """Which may be what they are asked for: no warning, a line among those of the solver."""
    mbs, ground, coordinate = coordinate_of(Mass1D)
    mbs.AddObject(CoordinateConstraint(name="pull", markerNumbers=[ground, coordinate], offset=0.1))
    mbs.Assemble()
    s = settings()
    s.staticSolver.verboseMode = 0
    mbs.SolveStatic(s)
    assert capfd.readouterr().out == ""
    s.staticSolver.verboseMode = 1
    mbs.SolveStatic(s)
    text = capfd.readouterr().out
    assert "'pull' (ObjectConnectorCoordinate), equation 0: gap -0.1" in text and "WARNING" not in text


def test_variations_report_inconsistent_ones() -> None:
    mbs, _, _, rope = two_masses(
        [1.0, 0, 0], (1, 3), lambda **rows: DistanceConstraint(name="rope", distance=1, **rows)
    )
    found = mbs.SolveVariations({(rope, "distance"): [1.0, 0.95, 1.0]}, settings())
    assert found.success.all() and found.messages == ["", "", ""]
    assert found.warnings[0] == found.warnings[2] == ""
    assert "'rope' (ObjectConnectorDistance), equation 0: gap 0.05 m" in found.warnings[1]


# ---- consistent positions ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("span", "joint", "change"), [
    ([1.05, 0, 0], lambda **rows: DistanceConstraint(distance=1, **rows), [0.05, 0, 0]),
    ([0.03, 0, 0.04], ObjectJointSpherical, [0.03, 0, 0.04]),
], ids=["distance", "spherical"])  # fmt: skip
def test_the_heavy_move_less(span: Any, joint: Any, change: Any) -> None:
    """Displacements u of least sum m u^2 that close a gap are to each other as 1 / m."""
    mbs, a, b, _ = two_masses(span, (1, 3), joint)
    found = mbs.ComputeConsistentInitialConditions()
    np.testing.assert_allclose(position(mbs, a) - [1, 2, 3], 0.75 * np.array(change), rtol=0, atol=ROUND_OFF)
    np.testing.assert_allclose(position(mbs, b) - span - [1, 2, 3], -0.25 * np.array(change), rtol=0, atol=ROUND_OFF)
    assert found.positionGaps[0] == pytest.approx(max(change)) and found.positionGaps[1] < ROUND_OFF
    assert found.displacements == pytest.approx({0: 0.75 * max(change), 1: 0.25 * max(change)})
    assert found.redundantEquations == 0


@pytest.mark.parametrize("nodeType", [Node.RotationEulerParameters, Node.RotationRotationVector, Node.RotationRxyz])
@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.TrapezoidalIndex2])
def test_no_gap_is_left_to_a_solver(nodeType: Any, solver: Any, capfd: pytest.CaptureFixture[str]) -> None:
    mbs, rod = hinged_rod(0.05, nodeType, initialVelocity=[0, 0, 3])
    assert mbs.ComputeConsistentInitialConditions().positionGaps[1] < ROUND_OFF
    np.testing.assert_allclose(position(mbs, rod, [-0.5, 0, 0]), 0, rtol=0, atol=ROUND_OFF)
    mbs.SolveDynamic(settings(), solverType=solver)
    assert capfd.readouterr().out == ""
    np.testing.assert_allclose(mbs.GetObjectOutputBody(rod, Variable.Position, [-0.5, 0, 0]), 0, rtol=0, atol=1e-9)


def test_it_survives_assembling_if_stored_in_the_nodes() -> None:
    for stored in (True, False):
        mbs, rod = hinged_rod(0.05)
        mbs.ComputeConsistentInitialConditions(storeInNodes=stored)
        found = position(mbs, rod)
        mbs.Assemble()
        assert np.array_equal(position(mbs, rod), found) == stored


def test_consistent_values_do_not_change() -> None:
    mbs, _ = hinged_rod(0, initialVelocity=[0, 0.5, 0], initialAngularVelocity=[0, 0, 1])
    before = mbs.systemData.GetSystemState(Initial)
    found = mbs.ComputeConsistentInitialConditions()
    assert found.displacements == found.velocityChanges == {} and found.iterations == 0
    for was, now in zip(before, mbs.systemData.GetSystemState(Initial), strict=True):
        np.testing.assert_array_equal(was, now)


# ---- consistent velocities --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("nodeType", [Node.RotationEulerParameters, Node.RotationRotationVector, Node.RotationRxyz])
def test_velocities_change_as_by_a_plastic_impact(nodeType: Any) -> None:
    """A rod that moves across its axis with 3 m/s and is caught at its end: m v l / 2 = m l^2 / 3 omega about that end."""
    mbs, rod = hinged_rod(0, nodeType, initialVelocity=[0, 3, 0])
    found = mbs.ComputeConsistentInitialConditions(positions=False)
    omega = mbs.GetObjectOutputBody(rod, Variable.AngularVelocity, [0, 0, 0], Initial)
    np.testing.assert_allclose(omega, [0, 0, 1.5 * 3], rtol=0, atol=1e-11)
    np.testing.assert_allclose(velocity(mbs, rod), [0, 0.75 * 3, 0], rtol=0, atol=1e-11)
    assert found.velocityGaps[0] == pytest.approx(3) and found.velocityGaps[1] < 1e-11


def test_prescribed_motion_gives_velocities() -> None:
    """Also where nobody says how the offset changes, here with 4 cos(2 t) at t = 0.5."""
    mbs, ground, coordinate = coordinate_of(Mass1D)
    mbs.AddObject(
        CoordinateConstraint(
            markerNumbers=[ground, coordinate], offsetUserFunction=lambda mbs, t, item, offset: 2 * np.sin(2 * t)
        )
    )
    mbs.Assemble()
    s = settings()
    s.timeIntegration.startTime = 0.5
    mbs.ComputeConsistentInitialConditions(s)
    assert mbs.systemData.GetODE2Coordinates(Initial) == pytest.approx([2 * np.sin(1)], abs=1e-12)
    assert mbs.systemData.GetODE2Coordinates_t(Initial) == pytest.approx([4 * np.cos(1)], abs=1e-5)  # by differences


# ---- loops ------------------------------------------------------------------------------------------------------------

CRANK, COUPLER, ROCKER, BASE = 1.0, 3.0, 2.0, 3.0


def circles_meet(a: np.ndarray, ra: float, b: np.ndarray, rb: float) -> np.ndarray:
    """The upper of two points at distances ra from a and rb from b."""
    d = np.linalg.norm(b - a)
    along = (ra**2 - rb**2 + d**2) / (2 * d)
    axis = (b - a) / d
    return np.asarray(a + along * axis + np.sqrt(ra**2 - along**2) * np.array([-axis[1], axis[0]]))


class FourBar:
    """Crank at 50 degrees, coupler and rocker roughly placed; a mechanism in the plane, or of hinges in space."""

    def __init__(self, nodeType: Any = None, rough: float = 0.1) -> None:
        self.mbs = mbs = new_system()
        angle, planar = np.radians(50), nodeType is None
        pin = CRANK * np.array([np.cos(angle), np.sin(angle)])
        base = np.array([BASE, 0])
        self.joint = circles_meet(pin, COUPLER, base, ROCKER)
        bars = [(np.zeros(2), pin, CRANK, 0), (pin, self.joint, COUPLER, rough), (base, self.joint, ROCKER, -rough)]
        options = {"create2D": True} if planar else {"nodeType": nodeType}
        self.bodies = []
        for start, end, length, turned in bars:
            phi = np.arctan2(*(end - start)[::-1]) + turned
            self.bodies.append(
                mbs.CreateRigidBody(
                    referencePosition=[*(start + 0.5 * length * np.array([np.cos(phi), np.sin(phi)])), 0],
                    referenceRotationMatrix=[[np.cos(phi), -np.sin(phi), 0], [np.sin(phi), np.cos(phi), 0], [0, 0, 1]],
                    inertia=InertiaCuboid(density=1000, sideLengths=[length, 0.1, 0.1]),
                    **options,
                )
            )
        ground = mbs.CreateGround()
        crank, coupler, rocker = self.bodies
        for name, (b0, p0), (b1, p1) in (
            ("A", (ground, 0), (crank, -CRANK / 2)),
            ("B", (crank, CRANK / 2), (coupler, -COUPLER / 2)),
            ("C", (coupler, COUPLER / 2), (rocker, ROCKER / 2)),
            ("D", (ground, BASE), (rocker, -ROCKER / 2)),
        ):
            marker = MarkerBodyPosition if planar else MarkerBodyRigid
            markers = [mbs.AddMarker(marker(bodyNumber=b, localPosition=[p, 0, 0])) for b, p in ((b0, p0), (b1, p1))]
            mbs.AddObject((ObjectJointRevolute2D if planar else ObjectJointRevoluteZ)(name=name, markerNumbers=markers))
        mbs.Assemble()

    def end_of_rocker(self) -> np.ndarray:
        return position(self.mbs, self.bodies[2], [ROCKER / 2, 0, 0])


@pytest.mark.parametrize(
    "nodeType", [None, Node.RotationEulerParameters, Node.RotationRotationVector, Node.RotationRxyz]
)
def test_a_four_bar_closes_around_its_crank(nodeType: Any) -> None:
    """Three equations of hinges in space are redundant for each loop. Fixed coordinates do not change at all."""
    bar = FourBar(nodeType)
    crank = bar.mbs.systemData.GetNodeLTGODE2(0)
    before = bar.mbs.systemData.GetODE2Coordinates(Initial)[crank]
    found = bar.mbs.ComputeConsistentInitialConditions(fixedNodes=[0])
    np.testing.assert_allclose(bar.end_of_rocker(), [*bar.joint, 0], rtol=0, atol=1e-11)
    np.testing.assert_array_equal(bar.mbs.systemData.GetODE2Coordinates(Initial)[crank], before)
    assert found.positionGaps[0] > 0.1 and found.positionGaps[1] < ROUND_OFF and found.iterations < 10
    assert 0 not in found.displacements and set(found.displacements) == {1, 2}


@pytest.mark.parametrize("nodeType", [Node.RotationEulerParameters, Node.RotationRotationVector])
def test_redundant_equations_are_counted(nodeType: Any) -> None:
    assert FourBar(nodeType).mbs.ComputeConsistentInitialConditions().redundantEquations == 3


def test_rotation_parameters_do_not_matter() -> None:
    """Increments of Euler parameters and of rotation vectors are the same turns: dependent values agree to
    round-off."""
    ends = []
    for nodeType in (Node.RotationEulerParameters, Node.RotationRotationVector):
        bar = FourBar(nodeType, rough=0.2)
        bar.mbs.ComputeConsistentInitialConditions()
        ends.append([position(bar.mbs, body, [0.5, 0, 0]) for body in bar.bodies])
    np.testing.assert_allclose(ends[0], ends[1], rtol=0, atol=1e-9)
    assert np.linalg.norm(ends[0][1][:2] - bar.joint) > 0.01


def test_contradictory_loops_are_refused() -> None:
    """A door whose hinges are 1 m apart, in a frame where they are 2 cm more: half of that is left in each at best."""
    mbs = new_system()
    ground = mbs.CreateGround()
    door = mbs.CreateRigidBody(inertia=InertiaCuboid(density=600, sideLengths=[0.8, 0.04, 1.2]))
    for name, z, on_ground in (("upper", 0.5, 0.51), ("lower", -0.5, -0.51)):
        places = ((ground, [-0.4, 0, on_ground]), (door, [-0.4, 0, z]))
        mbs.AddObject(
            ObjectJointRevoluteZ(
                name=name,
                markerNumbers=[mbs.AddMarker(MarkerBodyRigid(bodyNumber=b, localPosition=p)) for b, p in places],
            )
        )
    mbs.Assemble()
    before = mbs.systemData.GetSystemState(Initial)
    with pytest.raises(ValueError) as caught:
        mbs.ComputeConsistentInitialConditions()
    for name in ("upper", "lower"):
        assert f"'{name}' (ObjectJointRevoluteZ), equation 2: gap" in str(caught.value)
    assert "0.01 m" in str(caught.value)
    for was, now in zip(before, mbs.systemData.GetSystemState(Initial), strict=True):
        np.testing.assert_array_equal(was, now)


def test_impossible_fixed_coordinates_are_rejected() -> None:
    mbs, rod = hinged_rod(0.05, Node.RotationRotationVector)
    with pytest.raises(ValueError, match=r"a part of \[3, 4, 5\], the rotation vector of a Lie group node"):
        mbs.ComputeConsistentInitialConditions(fixedCoordinates=[4])
    with pytest.raises(ValueError, match="expected ODE2 indices below 6, received 6"):
        mbs.ComputeConsistentInitialConditions(fixedCoordinates=[6])
    with pytest.raises(ValueError, match="'hinge' .*, equation 1: gap 0.05 m"):
        mbs.ComputeConsistentInitialConditions(fixedNodes=[0])


def test_coordinates_without_mass_count_as_one() -> None:
    """A massless coordinate and one of 3 kg, tied to each other with a gap of 4: they move by 3 and 1."""
    mbs = new_system()
    nodes = [mbs.AddNode(Node1D(referenceCoordinates=[0], initialCoordinates=[u])) for u in (0, 4)]
    for node, m in zip(nodes, (0, 3), strict=True):
        mbs.AddObject(Mass1D(nodeNumber=node, physicsMass=m))
    mbs.AddObject(
        CoordinateConstraint(
            markerNumbers=[mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=n, coordinate=0)) for n in nodes]
        )
    )
    mbs.Assemble()
    mbs.ComputeConsistentInitialConditions()
    np.testing.assert_allclose(mbs.systemData.GetODE2Coordinates(Initial), [3, 3], rtol=0, atol=1e-11)
