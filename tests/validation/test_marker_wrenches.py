"""Forces of joints on their bodies, against balances of forces written down by hand: a single sign, in statics and
dynamics."""

from __future__ import annotations

import copy
import pickle
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from solving import Variable, new_system, settings

import dalembert as exu
import dalembert.itemInterface as items
from dalembert.rigidBodyUtilities import InertiaCuboid

WRENCH = (Variable.WrenchOnMarker0, Variable.WrenchOnMarker1)
LOCAL = (Variable.WrenchOnMarker0Local, Variable.WrenchOnMarker1Local)
FORCE, TORQUE = np.array([3.0, 5.0, 7.0]), np.array([1.0, 2.0, -4.0])
PLACE = np.array([0.3, -0.2, 0.5])  # of the joint on the body, whose loads act at its origin


def wrench(mbs: exu.MainSystem, joint: Any, marker: int, local: bool = False, **where: Any) -> np.ndarray:
    return np.asarray(mbs.GetObjectOutput(joint, (LOCAL if local else WRENCH)[marker], **where))


def solve(mbs: exu.MainSystem, static: bool) -> None:
    mbs.Assemble()
    s = settings(1e-4, 1)
    s.staticSolver.verboseMode = 0
    if static:
        mbs.SolveStatic(s)
    else:
        mbs.SolveDynamic(s)


Joint = Callable[[exu.MainSystem, Any, Any, np.ndarray], Any]


def weld(mbs: exu.MainSystem, ground: Any, body: Any, turn: np.ndarray) -> Any:
    return mbs.CreateGenericJoint(bodyNumbers=[ground, body], position=turn @ PLACE)


def alternative_weld(mbs: exu.MainSystem, ground: Any, body: Any, turn: np.ndarray) -> Any:
    joint = weld(mbs, ground, body, turn)
    mbs.SetObjectParameter(joint, "alternativeConstraints", True)
    return joint


def locked_hinge(mbs: exu.MainSystem, ground: Any, body: Any, turn: np.ndarray) -> Any:
    """Free motions are held by a stiff spring, which takes the moment about the axis."""
    return mbs.CreateRevoluteJoint(bodyNumbers=[ground, body], position=turn @ PLACE, axis=turn @ [0.6, 0.8, 0])


def locked_slider(mbs: exu.MainSystem, ground: Any, body: Any, turn: np.ndarray) -> Any:
    return mbs.CreatePrismaticJoint(bodyNumbers=[ground, body], position=turn @ PLACE, axis=turn @ [0, 0.8, 0.6])


def ball(mbs: exu.MainSystem, ground: Any, body: Any, turn: np.ndarray) -> Any:
    return mbs.CreateSphericalJoint(bodyNumbers=[ground, body], position=turn @ PLACE)


def universal(mbs: exu.MainSystem, ground: Any, body: Any, turn: np.ndarray) -> Any:
    return mbs.CreateGenericJoint(
        bodyNumbers=[ground, body],
        position=turn @ PLACE,
        rotationMatrixAxes=turn,
        constrainedAxes=[1, 0, 1, 0, 0, 1],
    )


@pytest.mark.parametrize("static", [True, False])
@pytest.mark.parametrize("turned", [False, True])
@pytest.mark.parametrize(
    "joint", [weld, alternative_weld, locked_hinge, locked_slider, ball, universal], ids=lambda f: f.__name__
)
def test_a_loaded_body_on_a_joint_and_a_spring(joint: Joint, turned: bool, static: bool) -> None:
    """The joint and the spring of its free motions carry the load; turned with the model, nothing else changes."""
    turn = Rotation.from_rotvec([0.4, -1.1, 0.7] if turned else [0, 0, 0]).as_matrix()
    mbs = new_system()
    ground = mbs.CreateGround()
    inertia = InertiaCuboid(1000, [0.1, 0.2, 0.3])
    body = mbs.CreateRigidBody(inertia=inertia, referenceRotationMatrix=turn)
    number = joint(mbs, ground, body, turn)
    m = [mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=b)) for b in (ground, body)]
    spring = mbs.AddObject(
        items.RigidBodySpringDamper(
            markerNumbers=m, stiffness=1e9 * np.eye(6), rotationMarker0=turn, rotationMarker1=np.eye(3)
        )
    )
    mbs.CreateForce(bodyNumber=body, loadVector=turn @ FORCE)
    mbs.CreateTorque(bodyNumber=body, loadVector=turn @ TORQUE)
    solve(mbs, static)
    on_body, of_spring = wrench(mbs, number, 1), wrench(mbs, spring, 1)
    arm = turn @ PLACE
    held = np.concatenate([turn @ FORCE, turn @ TORQUE])
    both = on_body + of_spring + np.concatenate([np.zeros(3), np.cross(arm, on_body[:3])])
    # all balances, including accelerations; tolerance: tolerances of Newton's method and of positions, 1e-8 m
    a, alpha = (
        np.asarray(mbs.GetObjectOutputBody(body, v)) for v in (Variable.Acceleration, Variable.AngularAcceleration)
    )
    J = turn @ inertia.InertiaCOM() @ turn.T
    inertia_forces = np.concatenate([inertia.Mass() * a, J @ alpha]) if not static else np.zeros(6)
    assert held + both == pytest.approx(inertia_forces, abs=1e-5)
    if joint in (weld, alternative_weld):
        assert both == pytest.approx(-held, abs=1e-5)
    # action and reaction, about the same point: the frames of the joint agree within 1e-8 m
    assert wrench(mbs, number, 0) == pytest.approx(-on_body, abs=1e-6)
    axes = turn if joint is universal else None
    if axes is not None:
        for marker in (0, 1):
            own = wrench(mbs, number, marker, local=True).reshape(2, 3)
            assert own == pytest.approx(wrench(mbs, number, marker).reshape(2, 3) @ axes, abs=1e-5)
            assert own[0, 1] == pytest.approx(0, abs=1e-6) and own[1, 0] == pytest.approx(0, abs=1e-6)


def test_statics_and_dynamics_have_one_sign() -> None:
    """A mass of 2 kg hangs on a rod, a second one on a coordinate that is held; multipliers change their sign."""
    forces = []
    for static in (True, False):
        mbs = new_system()
        ground = mbs.CreateGround()
        mass = mbs.CreateMassPoint(referencePosition=[0, -1, 0], physicsMass=2, gravity=[0, -9.81, 0])
        rod = mbs.CreateDistanceConstraint(bodyNumbers=[ground, mass], distance=1)
        for axis in (0, 2):
            mbs.CreateCoordinateConstraint(bodyNumbers=[ground, mass], coordinates=[None, axis])
        held = mbs.CreateMassPoint(physicsMass=2, gravity=[0, -9.81, 0])
        constraints = [
            mbs.CreateCoordinateConstraint(bodyNumbers=[None, held], coordinates=[None, k]) for k in range(3)
        ]
        solve(mbs, static)
        assert wrench(mbs, rod, 1) == pytest.approx([0, 19.62, 0, 0, 0, 0], abs=1e-6)
        assert wrench(mbs, rod, 0) == pytest.approx([0, -19.62, 0, 0, 0, 0], abs=1e-6)
        assert wrench(mbs, constraints[1], 1) == pytest.approx(19.62, abs=1e-6)
        forces.append(mbs.GetObjectOutput(rod, Variable.Force))
        with pytest.raises(
            ValueError, match="no output variable WrenchOnMarker1Local, because marker 2 .* has no axes"
        ):
            wrench(mbs, rod, 1, local=True)
    assert forces == pytest.approx([-19.62, 19.62], abs=1e-6)  # as in Exudyn


@pytest.mark.parametrize("node", [exu.NodeType.RotationEulerParameters, exu.NodeType.RotationRotationVector])
def test_inverse_dynamics_of_a_driven_body(node: Any) -> None:
    """A body rotates by a prescribed angle about an oblique axis off its center: Newton's and Euler's equations give
    all."""
    turn = Rotation.from_rotvec([0.5, 0.2, -0.3]).as_matrix()  # axes of the joint
    start = Rotation.from_rotvec([0.1, 0.9, 0.4]).as_matrix()  # of the body
    inertia = InertiaCuboid(1000, [0.3, 0.1, 0.2])
    gravity = np.array([1.0, -2.0, 9.0])
    mbs = new_system()
    ground = mbs.CreateGround()
    body = mbs.CreateRigidBody(
        referencePosition=[0.4, 0.1, -0.2],
        referenceRotationMatrix=start,
        inertia=inertia,
        gravity=gravity,
        nodeType=node,
    )
    joint = mbs.CreateGenericJoint(bodyNumbers=[ground, body], position=[0, 0, 0], rotationMatrixAxes=turn)

    def angle(mbs: Any, t: float, item: int, p: Any) -> list[float]:
        return [0, 0, 0, 0, 0, 0.8 * t**2]

    mbs.SetObjectParameter(joint, "offsetUserFunction", angle)
    sensors = [
        mbs.AddSensor(items.SensorObject(objectNumber=joint, outputVariableType=v, storeInternal=True)) for v in WRENCH
    ]
    mbs.Assemble()
    s = settings(1.0, 2000)
    s.solutionSettings.sensorsWritePeriod = 1 / 2000
    mbs.SolveDynamic(s)
    position, rotation = (
        np.asarray(mbs.GetObjectOutputBody(body, v)) for v in (Variable.Position, Variable.RotationMatrix)
    )
    A, axis = rotation.reshape(3, 3), turn[:, 2]
    J = A @ inertia.InertiaCOM() @ A.T
    spin, spin_rate = 1.6 * axis, 1.6 * axis
    acceleration = np.cross(spin_rate, position) + np.cross(spin, np.cross(spin, position))
    force = inertia.Mass() * (acceleration - gravity)
    torque = J @ spin_rate + np.cross(spin, J @ spin) + np.cross(position, force)  # about the joint
    found = wrench(mbs, joint, 1)
    # errors of 2000 steps of second order, relative to the largest component
    assert found[:3] == pytest.approx(force, abs=1e-5 * np.abs(force).max())
    assert found[3:] == pytest.approx(torque, abs=1e-4 * np.abs(torque).max())
    assert wrench(mbs, joint, 0) == pytest.approx(-found, abs=1e-9 * np.abs(found).max())
    for marker in (0, 1):
        assert mbs.GetSensorStoredData(sensors[marker])[-1, 1:] == pytest.approx(wrench(mbs, joint, marker))
    assert wrench(mbs, joint, 0, local=True).reshape(2, 3) == pytest.approx(-found.reshape(2, 3) @ turn)


@pytest.mark.parametrize("static", [True, False])
def test_planar_joints(static: bool) -> None:
    """A beam on a hinge, whose axis slides over a point near its other end: balances of moments about the hinge."""
    mbs = new_system()
    ground = mbs.CreateGround()
    beam = mbs.CreateRigidBody(inertia=InertiaCuboid(1e9, [4, 0.1, 0.1]), referencePosition=[2, 0, 0], create2D=True)
    markers = [
        mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=b, localPosition=p))
        for b, p in ((ground, [0, 0, 0]), (beam, [-2, 0, 0]), (ground, [5, 0, 0]), (beam, [2, 0, 0]))
    ]
    hinge = mbs.AddObject(items.RevoluteJoint2D(markerNumbers=markers[:2]))
    slider = mbs.AddObject(
        items.PrismaticJoint2D(
            markerNumbers=markers[2:], axisMarker0=[1, 0, 0], normalMarker1=[0, 1, 0], constrainRotation=False
        )
    )
    mbs.CreateForce(bodyNumber=beam, localPosition=[-1, 0, 0], loadVector=[30, -80, 0])
    solve(mbs, static)
    assert wrench(mbs, hinge, 1) == pytest.approx([-30, 64, 0, 0, 0, 0], abs=1e-5)
    # the force of the point, 80 N * 1 m / 5 m, acts 1 m off the marker of the beam
    assert wrench(mbs, slider, 1) == pytest.approx([0, 16, 0, 0, 0, 16], abs=1e-5)
    assert wrench(mbs, slider, 0) == pytest.approx([0, -16, 0, 0, 0, 0], abs=1e-5)


def test_static_solutions_start_dynamic_ones() -> None:
    """The sign belongs to the multipliers of a configuration, wherever they go."""
    mbs = new_system()
    ground = mbs.CreateGround()
    mass = mbs.CreateMassPoint(referencePosition=[0, -1, 0], physicsMass=2, gravity=[0, -9.81, 0])
    rod = mbs.CreateDistanceConstraint(bodyNumbers=[ground, mass], distance=1)
    for axis in (0, 2):
        mbs.CreateCoordinateConstraint(bodyNumbers=[ground, mass], coordinates=[None, axis])
    sensor = mbs.AddSensor(items.SensorObject(objectNumber=rod, outputVariableType=WRENCH[1], storeInternal=True))
    mbs.Assemble()
    s = settings(0.1, 10)
    s.staticSolver.verboseMode = 0
    mbs.SolveStatic(s, updateInitialValues=True)
    expected = pytest.approx([0, 19.62, 0, 0, 0, 0], abs=1e-6)
    made = [mbs, copy.copy(mbs), copy.deepcopy(mbs), pickle.loads(pickle.dumps(mbs))]
    for system in made:
        for configuration in (exu.ConfigurationType.Current, exu.ConfigurationType.Initial):
            assert wrench(system, rod, 1, configuration=configuration) == expected
    mbs.SolveDynamic(s)
    for row in mbs.GetSensorStoredData(sensor)[1:]:
        assert row[1:] == expected
    assert wrench(mbs, rod, 1) == expected
    assert wrench(mbs, rod, 1, configuration=exu.ConfigurationType.Initial) == expected
    state = mbs.systemData.GetSystemState()
    mbs.systemData.SetSystemState(state, exu.ConfigurationType.Initial)
    assert wrench(mbs, rod, 1, configuration=exu.ConfigurationType.Initial) == expected
    mbs.systemData.SetAECoordinates(2 * state[3])
    with pytest.raises(RuntimeError, match="Lagrange multipliers were set by mbs.systemData"):
        wrench(mbs, rod, 1)


def test_a_rolling_disc_and_a_penalty_one() -> None:
    """A disc that rolls down an incline: normal force m g cos, friction m g sin / 3; the same by a constraint and by springs."""
    slope, mass, g, radius = 0.3, 3.0, 9.81, 0.25
    gravity = [g * np.sin(slope), 0, -g * np.cos(slope)]
    inertia = exu.rigidBodyUtilities.RigidBodyInertia(mass, mass * radius**2 * np.diag([0.25, 0.5, 0.25]))
    for penalty in (False, True):
        mbs = new_system()
        ground = mbs.CreateGround()
        disc = mbs.CreateRigidBody(
            inertia=inertia,
            referencePosition=[0, 0, radius],
            gravity=gravity,
            nodeType=exu.NodeType.RotationRotationVector,
        )
        joint = (mbs.CreateRollingDiscPenalty if penalty else mbs.CreateRollingDisc)(
            bodyNumbers=[ground, disc],
            axisPosition=[0, 0, 0],
            axisVector=[0, 1, 0],
            planePosition=[0, 0, 0],
            planeNormal=[0, 0, 1],
            discRadius=radius,
            **(
                {
                    "contactStiffness": 1e7,
                    "contactDamping": 3e3,
                    "dryFriction": [0.5, 0.5],
                    "dryFrictionProportionalZone": 1e-3,
                }
                if penalty
                else {}
            ),
        )
        mbs.Assemble()
        mbs.SolveDynamic(settings(0.2, 2000))
        on_disc = wrench(mbs, joint, 1)
        normal, friction = mass * g * np.cos(slope), mass * g * np.sin(slope) / 3
        # the springs of the penalty method are still 1e-3 off after 0.2 s
        tolerance = 2e-3 * mass * g if penalty else 1e-4 * mass * g
        assert on_disc[:3] == pytest.approx([-friction, 0, normal], abs=tolerance)
        assert on_disc[3:] == pytest.approx([0, radius * friction, 0], abs=radius * tolerance)
