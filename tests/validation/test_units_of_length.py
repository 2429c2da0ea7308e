"""Units of length do not change results of closed mechanisms: consistent values and motions of doors, eigenvalues of
chains, numbers of constraints."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from solving import Solver, new_system, settings
from test_redundant import NODES, ClosedChain, redundancy

import dalembert as exu
from dalembert._core import testing
from dalembert.rigidBodyUtilities import InertiaCuboid, RotationMatrixX, RotationMatrixZ

MASS = 30.0


def hung_door(length: float, misplaced: float, turned: float, heights: Sequence[float] = (0.3, 1.7)) -> Any:
    """A model with this number of units of length per metre, off its hinges, of which the second one does not fit."""
    mbs = new_system()
    ground = mbs.CreateGround()
    size, center = length * np.array([0.9, 0.04, 2.0]), length * np.array([0.45, 0, 1])
    door = mbs.CreateRigidBody(
        referencePosition=center,
        inertia=InertiaCuboid(density=MASS / np.prod(size), sideLengths=size),
        initialDisplacement=length * np.array([3e-4, 1e-4, -2e-4]),
        initialRotationMatrix=RotationMatrixZ(0.01) @ RotationMatrixX(0.003),
        initialAngularVelocity=[0.1, 0.2, 1],
        gravity=length * np.array([0, 2, -9.6]),
    )
    for i, height in enumerate(heights):
        place = length * np.array([0, 0, height])
        ends = ((ground, place + [length * misplaced * (i == 1), 0, 0]), (door, place - center))
        markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body, localPosition=p)) for body, p in ends]
        mbs.AddObject(exu.RevoluteJointZ(markerNumbers=markers, rotationMarker0=RotationMatrixX(turned * (i == 1))))
    mbs.Assemble()
    return mbs


def coordinates(mbs: Any, length: float, configuration: Any) -> np.ndarray:
    """Values in m, rotations, and their rates."""
    q = np.array(mbs.systemData.GetODE2Coordinates(configuration))
    v = np.array(mbs.systemData.GetODE2Coordinates_t(configuration))
    for values in (q, v):
        values[:3] /= length
    return np.concatenate([q, v])


def consistent(mbs: Any) -> Any:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # gaps of inconsistent joints
        return mbs.ComputeConsistentInitialConditions()


@pytest.mark.parametrize("length", [1e3, 1e-3], ids=["mm", "km"])
@pytest.mark.parametrize(
    ("misplaced", "turned", "heights"),
    [(0, 0, (0.3, 1.7)), (1e-6, 0, (0.3, 1.7)), (0, 1e-6, (0.3, 1.7)), (1e-6, 1e-6, (0.3, 0.4, 1.7))],
    ids=["fits", "misplaced", "turned", "both, of three"],
)
def test_consistent_values(misplaced: float, turned: float, heights: Sequence[float], length: float) -> None:
    """Gaps are relative to the size of a mechanism, and joints that do not fit share them as in solvers.

    Rates of hinges rotated by 1e-6 differed by 1e-4 when all equations had equal weights.
    """
    in_metres, other = (hung_door(unit, misplaced, turned, heights) for unit in (1, length))
    found, same = consistent(in_metres), consistent(other)
    assert found.iterations == same.iterations and found.redundantEquations == same.redundantEquations
    initial = exu.ConfigurationType.Initial
    np.testing.assert_allclose(
        coordinates(other, length, initial), coordinates(in_metres, 1, initial), rtol=0, atol=1e-9
    )


@pytest.mark.parametrize("length", [1e3, 1e-3], ids=["mm", "km"])
@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.TrapezoidalIndex2, Solver.DOPRI5, Solver.ESDIRK43])
def test_motions(solver: Any, length: float) -> None:
    """Doors with hinges that hardly fit, from consistent values."""
    ends = []
    for unit in (1, length):
        mbs = hung_door(unit, 1e-7, 0)
        consistent(mbs)
        s = settings(0.5, 100, tolerance=1e-12)
        s.timeIntegration.automaticStepSize = False  # tolerances of errors are those of numbers
        mbs.SolveDynamic(s, solverType=solver)
        ends.append(coordinates(mbs, unit, exu.ConfigurationType.Current))
    np.testing.assert_allclose(ends[1], ends[0], rtol=0, atol=1e-9)


def hung_chain(length: float, hinges: int, links: int = 10) -> Any:
    """Links of 1 m, each on so many hinges of one axis and a torsional spring."""
    mbs = new_system()
    before, size = mbs.CreateGround(), length * np.array([1, 0.05, 0.05])
    for i in range(links):
        link = mbs.CreateRigidBody(
            referencePosition=[(i + 0.5) * length, 0, 0],
            inertia=InertiaCuboid(density=2 / np.prod(size), sideLengths=size),
        )
        for k in range(hinges):
            place = length * np.array([i, 0, 0.1 * k])
            mbs.CreateRevoluteJoint(bodyNumbers=[before, link], position=place, axis=[0, 0, 1])
        ends = ((before, 0.5 * length * (i > 0)), (link, -0.5 * length))
        markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body, localPosition=[x, 0, 0])) for body, x in ends]
        mbs.AddObject(exu.TorsionalSpringDamper(markerNumbers=markers, stiffness=1e3 * length**2))
        before = link
    mbs.Assemble()
    return mbs


@pytest.mark.parametrize("length", [1e-3, 1e3, 1e4, 1e6], ids=["km", "mm", "0.1 mm", "um"])
def test_eigenvalues(length: float) -> None:
    """Modes, as many as there are links. Round-off of hinges that follow from others was taken for constraints: seven
    of ten modes were missing without a message in 0.1 mm."""
    wanted = np.asarray(hung_chain(1, 1).ComputeODE2Eigenvalues()[0])
    assert len(wanted) == 10
    for hinges in (1, 2, 3):
        mbs = hung_chain(length, hinges)
        assert np.asarray(mbs.ComputeODE2Eigenvalues()[0]) == pytest.approx(wanted, rel=1e-7)
        assert mbs.ComputeSystemDegreeOfFreedom(useSVD=True)["degreeOfFreedom"] == 10
        mass, _, _, gradients, motions = mbs.ComputeLinearizedSystem(
            projectIntoConstraintNullspace=True, returnConstraintJacobian=True, returnConstraintNullspace=True
        )
        assert mass.shape == (10, 10)
        assert motions @ motions.T == pytest.approx(np.eye(10), abs=1e-12)
        assert np.abs(motions @ gradients).max() < 1e-12 * np.abs(gradients).max()


UNITS = pytest.mark.parametrize("length", [1e-3, 1, 10, 1e3, 1e6], ids=["km", "m", "0.1 m", "mm", "um"])


def counts_of(mbs: Any) -> tuple[int, int]:
    """Redundant equations and degrees of freedom, without a warning."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        counts = mbs.ComputeSystemDegreeOfFreedom()
    return counts["redundantConstraints"], counts["degreeOfFreedom"]


def counts_of_solver(mbs: Any) -> int:
    mbs.SolveDynamic(settings(0.01, 2))
    return int(mbs.sys["dynamicSolver"].GetRedundantConstraints()["count"])


@UNITS
@pytest.mark.parametrize("hinges", [1, 2, 3])
def test_numbers_of_redundant_constraints(hinges: int, length: float) -> None:
    """Numbers of constraints of a door, and of chains. Two moments of a single hinge were taken for round-off of forces
    in micrometres."""
    door = hung_door(length, 0, 0, np.linspace(0.3, 1.7, hinges))
    consistent(door)
    assert counts_of(door) == (5 * (hinges - 1), 1)
    assert counts_of_solver(door) == 5 * (hinges - 1)
    for links in (2, 10, 40):
        assert counts_of(hung_chain(length, hinges, links)) == (5 * (hinges - 1) * links, links)


def closed_tree(length: float, node: Any) -> Any:
    """Three links in a plane that leans. The last one carries a coupler by two hinges, and this hangs on the ground by a hinge and a ball joint.

    The coupler closes a planar loop of five joints, which has two degrees of freedom: the 18 equations of joints on 10
    coordinates (3 of the tree, 6 and a rotation parameter more, or 9) leave 2 if 11 are redundant (one unit-length
    condition fixes that parameter).
    """
    mbs = new_system()
    ground = mbs.CreateGround()
    lean, angles = Rotation.from_euler("xyz", [0.4, -0.7, 0.3]).as_matrix(), np.array([0.5, 0.6, -1.8])
    along, gravity = np.array([length, 0, 0]), np.array([2, -3, -9.81]) * length
    coordinates = mbs.AddNode(exu.NodeGenericODE2(referenceCoordinates=angles, numberOfODE2Coordinates=3))
    tree = mbs.AddObject(
        exu.KinematicTree(
            nodeNumber=coordinates,
            jointTypes=[exu.JointType.RevoluteZ] * 3,
            linkParents=[-1, 0, 1],
            jointTransformations=exu.Matrix3DList([lean, np.eye(3), np.eye(3)]),
            jointOffsets=exu.Vector3DList([np.zeros(3), along, along]),
            linkInertiasCOM=exu.Matrix3DList([np.diag([0.01, 0.05, 0.05]) * length**2] * 3),
            linkCOMs=exu.Vector3DList([along / 2] * 3),
            linkMasses=[1.0, 2.0, 0.5],
            gravity=gravity,
        )
    )
    heading = np.cumsum(angles)
    tip = lean @ [length * np.cos(heading).sum(), length * np.sin(heading).sum(), 0]
    center, end = (tip + lean @ np.array(place) * length for place in ([0.5, -0.3, 0], [1, -0.6, 0]))
    size = np.array([1, 0.05, 0.05]) * length
    coupler = mbs.CreateRigidBody(
        referencePosition=center,
        referenceRotationMatrix=lean,
        inertia=InertiaCuboid(density=2.5 / np.prod(size), sideLengths=size),
        gravity=gravity,
        nodeType=node,
    )
    up, turned = np.array([0, 0, length]), Rotation.from_euler("z", -heading[-1]).as_matrix()

    def join(on: Any, place: Any, axes: Sequence[int], turn: Any, from_center: Any) -> None:
        at = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=coupler, localPosition=lean.T @ from_center + place))
        mbs.AddObject(exu.GenericJoint(markerNumbers=[on, at], constrainedAxes=[*axes, 0], rotationMarker0=turn))

    for height in (0, 0.2):
        on = mbs.AddMarker(
            exu.MarkerKinematicTreeRigid(objectNumber=tree, linkNumber=2, localPosition=along + height * up)
        )
        join(on, height * up, [1] * 5, turned, tip - center)
    for height, axes in ((0, [1] * 5), (0.3, [1, 1, 1, 0, 0])):
        on = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=ground, localPosition=end + lean @ up * height))
        join(on, height * up, axes, lean, end - center)
    mbs.Assemble()
    return mbs


@UNITS
@pytest.mark.parametrize("node", [exu.NodeType.RotationEulerParameters, exu.NodeType.RotationRotationVector])
def test_numbers_of_redundant_constraints_of_a_closed_tree(node: Any, length: float) -> None:
    """19 equations counted as redundant in mm without a message, because moments are small next to forces there."""
    mbs = closed_tree(length, node)
    assert counts_of(mbs) == (11, 2)
    assert counts_of_solver(mbs) == 11


@pytest.mark.parametrize("node", NODES)
@pytest.mark.parametrize("length", [1e-3, 1e3, 1e6], ids=["km", "mm", "um"])
def test_reactions_of_random_mechanisms(length: float, node: Any) -> None:
    """Planar loops in space, with three redundant equations: the smallest reactions are the same forces and moments."""
    for bars in (3, 4, 5, 7):
        told = []
        for unit in (1, length):
            chain = ClosedChain(np.random.default_rng(bars), bars, node, unit)
            assert counts_of(chain.mbs) == (3, bars - 2)
            s = settings(0.02, 20, tolerance=1e-12)
            s.redundantConstraints.momentLength = unit
            chain.mbs.SolveDynamic(s)
            assert redundancy(chain.mbs)["count"] == 3
            forces, moments = (
                np.array([chain.mbs.GetObjectOutput(joint, of) for joint in chain.joints])
                for of in (exu.OutputVariableType.ForceLocal, exu.OutputVariableType.TorqueLocal)
            )
            told.append(np.concatenate([forces / unit, moments / unit**2]))
        assert np.linalg.norm(told[1] - told[0]) < 1e-6 * np.linalg.norm(told[0])  # the norm that they minimize


@pytest.mark.parametrize("length", [1, 1e3], ids=["m", "mm"])
@pytest.mark.parametrize("off", [-1, 0, 1])
def test_wrong_numbers_of_redundant_constraints_say_so(
    off: int, length: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Singular values count in small systems."""
    mbs, found = hung_chain(length, 2, links=3), testing.redundant_constraints
    monkeypatch.setattr(testing, "redundant_constraints", lambda *a: (r := found(*a)) | {"count": r["count"] + off})
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        counts = mbs.ComputeSystemDegreeOfFreedom()
    assert counts["redundantConstraints"] == 15 + off
    assert ["do not tell as many redundant ones" in str(w.message) for w in told] == [True] * abs(off)
