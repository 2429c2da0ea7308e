"""Trees of rigid bodies against the same bodies and joints with all their coordinates."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert.itemInterface import SensorBody, SensorNode
from dalembert.rigidBodyUtilities import InertiaCuboid, RotationMatrixX, RotationMatrixZ
from dalembert.treeDynamics import RecogniseTrees

Variable, Node = exu.OutputVariableType, exu.NodeType
DOWN = [0, 0, -9.81]


def solve(mbs: Any, duration: float = 0.5, steps: int = 2000) -> None:
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime = duration
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.generalizedAlpha.spectralRadius = 0.9
    settings.solutionSettings.writeSolutionToFile = False
    mbs.Assemble()
    mbs.SolveDynamic(settings)


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


def test_what_links_do_not_have_leaves_bodies_as_they_are() -> None:
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
