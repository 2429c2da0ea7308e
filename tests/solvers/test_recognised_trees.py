"""Trees of rigid bodies against the same bodies and joints with all their coordinates."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert.itemInterface import SensorBody, SensorNode
from dalembert.rigidBodyUtilities import (
    InertiaCuboid,
    InertiaSphere,
    RotationMatrixX,
    RotationMatrixZ,
    RotationVector2RotationMatrix,
)
from dalembert.treeDynamics import RecogniseTrees

Variable, Node, Solver = exu.OutputVariableType, exu.NodeType, exu.DynamicSolverType
DOWN = [0, 0, -9.81]


def solve(mbs: Any, duration: float = 0.5, steps: int = 2000, solver: Any = Solver.GeneralizedAlpha) -> None:
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime = duration
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.generalizedAlpha.spectralRadius = 0.9
    settings.solutionSettings.writeSolutionToFile = False
    mbs.Assemble()
    mbs.SolveDynamic(settings, solverType=solver)


def types(mbs: Any) -> list[str]:
    return [item["objectType"] for item in mbs.GetDictionary()["objectList"]]


def chain(node: Any = Node.RotationEulerParameters, branch: bool = False) -> tuple[Any, list[Any]]:
    """A chain with all that may act on it, about axes along those of bodies and others, from both sides of joints."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround(referencePosition=[0, 0, 1], referenceRotationMatrix=RotationMatrixZ(0.2))
    bodies = [ground]
    for i, axis in enumerate([[0, 1, 0], [0, 0, -1], [1, 0, 0], [1, 1, 0]]):
        before = bodies[1] if branch and i == 3 else bodies[-1]
        body = mbs.CreateRigidBody(
            referencePosition=[0.5 + i, 0, 0],
            referenceRotationMatrix=RotationMatrixX(0.3 * i),
            inertia=InertiaCuboid(1000, [1, 0.1, 0.2]).Translated([0.1, 0, 0.02]),
            initialAngularVelocity=[0, 0.4, 0],
            initialVelocity=np.cross([0, 0.4, 0], [0.5 + i, 0, 0]),
            gravity=DOWN,
            nodeType=node,
        )
        create = mbs.CreatePrismaticJoint if i == 2 else mbs.CreateRevoluteJoint
        create(bodyNumbers=[body, before] if i % 2 else [before, body], position=[i, 0, 0], axis=axis)
        bodies.append(body)
    mbs.CreateForce(bodyNumber=bodies[-1], localPosition=[0.5, 0, 0], loadVector=[0, 30, 10], bodyFixed=True)
    mbs.CreateSpringDamper(bodyNumbers=[ground, bodies[3]], stiffness=300, damping=5, referenceLength=1)
    place = {"localPosition": [0.5, 0.1, 0.2], "storeInternal": True}
    sensors = [
        mbs.AddSensor(SensorBody(bodyNumber=body, outputVariableType=kind, **place))
        for body in bodies[1:]
        for kind in (Variable.Position, Variable.Velocity, Variable.AngularVelocity, Variable.Displacement)
    ]
    mbs.Assemble()
    return mbs, sensors


@pytest.mark.parametrize("branch", [False, True])
@pytest.mark.parametrize("node", [Node.RotationEulerParameters, Node.RotationRotationVector])
def test_trees_move_as_their_bodies_do(node: Any, branch: bool) -> None:
    mbs, sensors = chain(node, branch)
    trees = RecogniseTrees(mbs)
    assert types(trees)[:9] == ["Ground"] * 9 and types(trees)[9:] == ["ConnectorSpringDamper", "KinematicTree"]
    trees.Assemble()
    for sensor in sensors:
        assert trees.GetSensorValues(sensor) == pytest.approx(mbs.GetSensorValues(sensor), abs=1e-13)
    for system in (mbs, trees):
        solve(system)
    assert len(trees.systemData.GetODE2Coordinates()) == 4 and len(trees.systemData.GetAECoordinates()) == 0
    for sensor in sensors:
        assert trees.GetSensorValues(sensor) == pytest.approx(mbs.GetSensorValues(sensor), abs=1e-5)
    assert "KinematicTree" not in types(mbs)


def test_loops_are_closed_by_the_remaining_joint() -> None:
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    corners = np.array([[0, 0, 0], [0.2, 0, 1], [1.4, 0, 1.2], [1.5, 0, 0]])
    bodies = [ground]
    for a, b in zip(corners, corners[1:], strict=False):
        x = (b - a) / np.linalg.norm(b - a)
        A = np.column_stack([x, [0, 1, 0], np.cross(x, [0, 1, 0])])
        bar = InertiaCuboid(1000, [np.linalg.norm(b - a), 0.05, 0.05])
        body = mbs.CreateRigidBody(referencePosition=(a + b) / 2, referenceRotationMatrix=A, inertia=bar, gravity=DOWN)
        mbs.CreateRevoluteJoint(bodyNumbers=[bodies[-1], body], position=a, axis=[0, 1, 0])
        bodies.append(body)
    free = {"constrainedAxes": [1, 0, 1, 0, 0, 0]}  # the plane holds the rest
    mbs.CreateGenericJoint(bodyNumbers=[bodies[-1], ground], position=corners[-1], **free)
    sensor = mbs.AddSensor(SensorBody(bodyNumber=bodies[2], outputVariableType=Variable.Position))
    mbs.Assemble()
    trees = RecogniseTrees(mbs)
    assert types(trees).count("JointGeneric") == 1
    for system in (mbs, trees):
        solve(system, 1.0)
    assert len(trees.systemData.GetODE2Coordinates()) == 3
    assert trees.GetSensorValues(sensor) == pytest.approx(mbs.GetSensorValues(sensor), abs=1e-5)


def watched(
    mbs: Any, bodies: list[Any], kinds: tuple[str, ...] = ("Position", "Velocity", "AngularVelocity")
) -> list[Any]:
    place = {"localPosition": [0.2, 0.1, -0.1], "storeInternal": True}
    sensors = [
        mbs.AddSensor(SensorBody(bodyNumber=body, outputVariableType=getattr(Variable, kind), **place))
        for body in bodies
        for kind in kinds
    ]
    mbs.Assemble()
    return sensors


def compare(mbs: Any, sensors: list[Any], coordinates: int, duration: float = 0.5, tolerance: float = 1e-5) -> Any:
    """Positions, velocities and angular velocities at the start and at the end; 2000 steps of second order."""
    trees = RecogniseTrees(mbs)
    trees.Assemble()
    assert len(trees.systemData.GetODE2Coordinates()) == coordinates
    for sensor in sensors:
        assert trees.GetSensorValues(sensor) == pytest.approx(mbs.GetSensorValues(sensor), abs=1e-13)
    for system in (mbs, trees):
        solve(system, duration)
    for sensor in sensors:
        assert trees.GetSensorValues(sensor) == pytest.approx(mbs.GetSensorValues(sensor), abs=tolerance)
    return trees


def rod(mbs: Any, place: Any, spin: Any, about: Any, gravity: Any, turned: float = 0.3) -> Any:
    """A body that turns about a point as all others do."""
    return mbs.CreateRigidBody(
        referencePosition=place,
        referenceRotationMatrix=RotationMatrixX(turned),
        inertia=InertiaCuboid(1000, [1, 0.1, 0.2]).Translated([0.1, 0, 0.02]),
        initialAngularVelocity=spin,
        initialVelocity=np.cross(spin, np.subtract(place, about)),
        gravity=gravity,
    )


@pytest.mark.parametrize("generic", [False, True])
def test_spherical_joints(generic: bool) -> None:
    """A chain of three, seen from both sides of its joints, with a branch on a hinge."""
    mbs = exu.SystemContainer().AddSystem()
    bodies, spin = [mbs.CreateGround()], [0.5, 1.0, -0.7]
    for i in range(4):
        before = bodies[1] if i == 3 else bodies[-1]
        body = rod(mbs, [0.5 + i, 0, 0], spin, [0, 0, 0], DOWN, 0.4 * i)
        place = {"position": [1.0 if i == 3 else i, 0, 0], "bodyNumbers": [body, before] if i % 2 else [before, body]}
        if i == 3:
            mbs.CreateRevoluteJoint(axis=[0, 1, 0], **place)
        elif generic:
            mbs.CreateGenericJoint(constrainedAxes=[1, 1, 1, 0, 0, 0], **place)
        else:
            mbs.CreateSphericalJoint(**place)
        bodies.append(body)
    sensors = watched(mbs, bodies[1:])
    trees = compare(mbs, sensors, 10)
    assert types(trees).count("KinematicTree") == 1 and len(trees.systemData.GetAECoordinates()) == 0


@pytest.mark.parametrize("spin", [[0, 0, 0], [0, 0, 0.5], [0.3, 0, 0.2], [60.0, 0, 0], [0, 60, 0]], ids=str)
@pytest.mark.parametrize("level", [True, False])
def test_pendulums_and_tops_on_spherical_joints(spin: Any, level: bool) -> None:
    """Released when they are level or steep: they hang down at times, precess, and turn more than once."""
    mbs = exu.SystemContainer().AddSystem()
    bodies = [mbs.CreateGround()]
    slope = 0.0 if level else 1.2
    A = np.array([[np.cos(slope), 0, -np.sin(slope)], [0, 1, 0], [np.sin(slope), 0, np.cos(slope)]])
    cube = InertiaCuboid(1000, [0.2, 0.2, 0.2])
    for i in range(2):
        motion = {"initialAngularVelocity": A @ spin, "initialVelocity": np.cross(A @ spin, A @ [0.3 + 0.6 * i, 0, 0])}
        place = {"referencePosition": A @ [0.3 + 0.6 * i, 0, 0], "referenceRotationMatrix": A}
        body = mbs.CreateRigidBody(inertia=cube, gravity=DOWN, **motion, **place)
        mbs.CreateSphericalJoint(bodyNumbers=[bodies[-1], body], position=A @ [0.6 * i, 0, 0])
        bodies.append(body)
    sensors = watched(mbs, bodies[1:], ("Position",))
    compare(mbs, sensors, 6, duration=1.0, tolerance=1e-2 if max(np.abs(spin)) > 1 else 2e-4)


def beside_the_lock(apart: float, floats: bool = False) -> tuple[Any, Any]:
    """A ball under a constant torque: its z axis has the distance `apart` from the first axis of rotation."""
    mbs = exu.SystemContainer().AddSystem()
    ball = {"inertia": InertiaSphere(2.5, 1.0)}  # 1 kg m^2
    bodies = [mbs.CreateRigidBody(name="ball", **ball)]
    if floats:  # another one, on a joint through its center, that rotates with it
        bodies.append(mbs.CreateRigidBody(name="core", inertia=InertiaSphere(1e-9, 0.01)))
        mbs.CreateGenericJoint(bodyNumbers=bodies, position=[0, 0, 0], constrainedAxes=[1] * 6)
    else:
        mbs.CreateSphericalJoint(name="hip", bodyNumbers=[mbs.CreateGround(), bodies[0]], position=[0, 0, 0])
    mbs.CreateTorque(bodyNumber=bodies[0], loadVector=[1.0, apart, 0])
    sensor = mbs.AddSensor(SensorBody(bodyNumber=bodies[0], outputVariableType=Variable.RotationMatrix))
    mbs.Assemble()
    return RecogniseTrees(mbs), sensor


def turned_ball(apart: float, time: float) -> Any:
    """Its axes: it turns about the torque."""
    axis = np.array([1.0, apart, 0])
    return RotationVector2RotationMatrix(axis * time**2 / 2)


def doubts(trees: Any) -> list[str]:
    found: list[str] = trees.sys["dynamicSolver"].GetDoubts()
    return found


@pytest.mark.parametrize(("floats", "name"), [(False, "joint 'hip' (object 2)"), (True, "body 'ball' (object 0)")])
@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.RK44])
@pytest.mark.parametrize("apart", [0.03, 0.001])
def test_locked_joints_are_named(apart: float, solver: Any, floats: bool, name: str, capfd: Any) -> None:
    """State at the time of a quarter turn: steps there turn the body by about as much as it is apart, or by far
    more."""
    trees, sensor = beside_the_lock(apart, floats)
    try:
        solve(trees, 2.5, 200, solver)
    except exu.SolverError as error:
        text = error.advice[0]
    else:
        (text,) = doubts(trees)
        assert not trees.sys["dynamicSolver"].output.trusted
        time = float(text.partition("at time ")[2].partition(";")[0])
        assert abs(time - np.sqrt(np.pi)) < 0.05
    assert name in text and "lock where the second is at 90 degrees; it came to" in text
    assert "RecogniseTrees" in text and 70 < abs(float(text.partition("it came to ")[2].split()[0].rstrip(":"))) < 110


@pytest.mark.parametrize("apart", [0.03, 0.001, 0.0])
def test_small_steps_pass_where_turns_lock(apart: float) -> None:
    """Solutions with error control: about one axis, in any steps: there is nothing to see."""
    trees, sensor = beside_the_lock(apart)
    if apart:
        settings = exu.SimulationSettings()
        settings.timeIntegration.endTime = 2.5
        settings.timeIntegration.numberOfSteps = 1
        settings.timeIntegration.relativeTolerance = settings.timeIntegration.absoluteTolerance = 1e-10
        trees.Assemble()
        trees.SolveDynamic(settings, solverType=Solver.DOPRI5)
    else:
        solve(trees, 2.5, 200, Solver.RK44)
    assert trees.GetSensorValues(sensor).reshape(3, 3) == pytest.approx(turned_ball(apart, 2.5), abs=1e-6)
    assert not doubts(trees)


@pytest.mark.parametrize("solver", [Solver.DOPRI5, Solver.ESDIRK43, Solver.GeneralizedAlpha])
@pytest.mark.parametrize("tolerance", [1e-2, 1e-5])
def test_error_control_reports_a_skipped_lock(tolerance: float, solver: Any, capfd: Any) -> None:
    """A step from one side of the lock to the other: the motion of the first angle there was missed.

    Error control resolves the motion if it was detected: no more error than the tolerance in each step.
    """
    trees, sensor = beside_the_lock(0.001)
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime = 2.5
    settings.timeIntegration.numberOfSteps = 1
    settings.stepSizeControl.implicitSolvers = True
    settings.timeIntegration.relativeTolerance = settings.timeIntegration.absoluteTolerance = tolerance
    trees.Assemble()
    trees.SolveDynamic(settings, solverType=solver)
    found, told = doubts(trees), tolerance == 1e-2
    assert trees.sys["dynamicSolver"].output.trusted != told and len(found) == told
    assert all("joint 'hip' (object 2)" in text and "use smaller tolerances" in text for text in found)
    if not told:
        errors = tolerance * trees.sys["dynamicSolver"].it.currentStepIndex
        assert trees.GetSensorValues(sensor).reshape(3, 3) == pytest.approx(turned_ball(0.001, 2.5), abs=errors)


def test_fixed_joints_merge_links_and_ground() -> None:
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround(referencePosition=[0, 0, 1], referenceRotationMatrix=RotationMatrixZ(0.2))
    fixed = {"constrainedAxes": [1] * 6}
    base = rod(mbs, [0.5, 0, 0], [0, 0, 0], [0, 0, 0], DOWN)
    second = rod(mbs, [1.5, 0.2, 0], [0, 0, 0], [0, 0, 0], DOWN, 1.2)
    arm = rod(mbs, [2.5, 0, 0], [0, 0.4, 0], [2, 0, 0], DOWN, 0.7)
    tool = rod(mbs, [3.5, 0, 0], [0, 0.4, 0], [2, 0, 0], DOWN, -0.5)
    tip = rod(mbs, [4.5, 0, 0], [0, 0.4, 0], [2, 0, 0], DOWN, 0.2)
    mbs.CreateGenericJoint(bodyNumbers=[base, ground], position=[0, 0, 0], **fixed)
    mbs.CreateGenericJoint(
        bodyNumbers=[base, second], position=[1, 0, 0], rotationMatrixAxes=RotationMatrixZ(0.4), **fixed
    )
    mbs.CreateRevoluteJoint(bodyNumbers=[second, arm], position=[2, 0, 0], axis=[0, 1, 0])
    swing = rod(mbs, [2.5, 0.3, 0], [0, 0.4, 0], [2, 0, 0], DOWN)  # a link between the arm and the fixed link
    mbs.CreateRevoluteJoint(bodyNumbers=[arm, swing], position=[2.5, 0.1, 0], axis=[0, 0, 1])
    mbs.CreateGenericJoint(
        bodyNumbers=[tool, arm], position=[3, 0, 0], rotationMatrixAxes=RotationMatrixZ(0.4), **fixed
    )
    mbs.CreateRevoluteJoint(bodyNumbers=[tool, tip], position=[4, 0, 0], axis=[1, 1, 0])
    mbs.CreateForce(bodyNumber=tool, localPosition=[0.5, 0, 0], loadVector=[0, 30, 10], bodyFixed=True)
    mbs.CreateSpringDamper(bodyNumbers=[second, tip], stiffness=300, damping=5, referenceLength=1)
    sensors = watched(mbs, [base, second, arm, tool, tip, swing])
    trees = compare(mbs, sensors, 3)
    assert types(trees).count("RigidBody") == 0 and types(trees).count("KinematicTree") == 1


@pytest.mark.parametrize("gravity", [[0, 0, 0], DOWN, [3, 0, -4]], ids=str)
@pytest.mark.parametrize("spin", [[0, 0, 6.0], [5.0, 0.3, 0.2]], ids=str)
def test_bodies_that_nothing_holds_float(spin: Any, gravity: Any) -> None:
    """Five bodies: the middle one floats, and turns about its vertical axis, or about the one that lies level, by more than 2 rad."""
    mbs = exu.SystemContainer().AddSystem()
    bodies = []
    for i in range(5):
        bodies.append(rod(mbs, [0.5 + i, 0, 0], spin, [2.5, 0, 0], gravity, 0.2 * i))
        if i:
            mbs.CreateRevoluteJoint(bodyNumbers=bodies[-2:], position=[i, 0, 0], axis=[[0, 1, 0], [0, 0, 1]][i % 2])
    middle = bodies[2]
    last = rod(mbs, [2.5, 0.5, 0], spin, [2.5, 0, 0], gravity)
    mbs.CreatePrismaticJoint(bodyNumbers=[middle, last], position=[2.5, 0.2, 0], axis=[1, 0, 0])
    sensors = watched(mbs, [*bodies, last])
    compare(mbs, sensors, 11, tolerance=1e-4)
    explicit = RecogniseTrees(mbs)  # forward dynamics without a mass matrix
    solve(explicit, steps=500, solver=Solver.RK44)
    for sensor in sensors:
        assert explicit.GetSensorValues(sensor) == pytest.approx(mbs.GetSensorValues(sensor), abs=1e-4)


def test_a_loop_that_floats_is_closed_by_its_last_joint() -> None:
    """A ring of five bars, whose last joint constrains motion in the plane only."""
    mbs = exu.SystemContainer().AddSystem()
    angles = 2 * np.pi / 5 * np.arange(6)
    corners = np.column_stack([np.cos(angles), 0 * angles, np.sin(angles)])
    bodies, spin = [], np.array([0.5, 3.0, 0.2])
    for a, b in zip(corners, corners[1:], strict=False):
        x, middle = (b - a) / np.linalg.norm(b - a), (a + b) / 2
        bar = InertiaCuboid(1000, [np.linalg.norm(b - a), 0.05, 0.05])
        frame = np.column_stack([x, [0, 1, 0], np.cross(x, [0, 1, 0])])
        motion = {"initialAngularVelocity": spin, "initialVelocity": np.cross(spin, middle)}
        bodies.append(
            mbs.CreateRigidBody(referencePosition=middle, referenceRotationMatrix=frame, inertia=bar, **motion)
        )
    for i in range(1, 5):
        mbs.CreateRevoluteJoint(bodyNumbers=[bodies[i - 1], bodies[i]], position=corners[i], axis=[0, 1, 0])
    free = {"constrainedAxes": [1, 0, 1, 0, 0, 0]}
    mbs.CreateGenericJoint(bodyNumbers=[bodies[4], bodies[0]], position=corners[0], **free)
    mbs.CreateSpringDamper(bodyNumbers=[bodies[0], bodies[2]], stiffness=300, referenceLength=1)
    trees = compare(mbs, watched(mbs, bodies), 10, tolerance=5e-5)
    assert types(trees).count("JointGeneric") == 1 and len(trees.systemData.GetAECoordinates()) == 6


def test_unsupported_features_keep_bodies() -> None:
    mbs, _ = chain()
    mbs.AddSensor(SensorNode(nodeNumber=2, outputVariableType=Variable.Coordinates))
    mbs.Assemble()
    trees = RecogniseTrees(mbs)
    assert types(trees).count("RigidBody") == 2 and types(trees).count("KinematicTree") == 1
    for system in (mbs, trees):
        solve(system, 0.2, 1000)
    assert trees.GetNodeOutput(2, Variable.Position) == pytest.approx(mbs.GetNodeOutput(2, Variable.Position), abs=1e-6)


def test_weights_that_differ_stay_loads() -> None:
    mbs = exu.SystemContainer().AddSystem()
    bodies = [mbs.CreateGround()]
    for i in range(2):
        cube = InertiaCuboid(1000, [0.1, 0.2, 0.3]).Translated([0.1, 0, 0])
        body = mbs.CreateRigidBody(referencePosition=[i + 1, 0, 0], inertia=cube, gravity=[i, 0, -9.81])
        mbs.CreateRevoluteJoint(bodyNumbers=[bodies[-1], body], position=[i, 0, 0], axis=[0, 1, 0])
        bodies.append(body)
    sensor = mbs.AddSensor(SensorBody(bodyNumber=bodies[-1], outputVariableType=Variable.Position))
    mbs.Assemble()
    trees = RecogniseTrees(mbs)
    for system in (mbs, trees):
        solve(system)
    assert trees.GetSensorValues(sensor) == pytest.approx(mbs.GetSensorValues(sensor), abs=1e-6)


def test_open_joints_are_refused() -> None:
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    body = mbs.CreateRigidBody(inertia=InertiaCuboid(1000, [1, 1, 1]), initialDisplacement=[0.1, 0, 0])
    mbs.CreateRevoluteJoint(name="hinge", bodyNumbers=[ground, body], position=[0, 0, 0], axis=[0, 0, 1])
    mbs.Assemble()
    with pytest.raises(ValueError, match=r"RecogniseTrees: joint 'hinge' \(object 2\) is open by 0.1 at the start"):
        RecogniseTrees(mbs)
