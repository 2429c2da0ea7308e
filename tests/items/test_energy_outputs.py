"""KineticEnergy and PotentialEnergy against closed forms, other computations, and conservation in motion."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert.advancedUtilities import CreateLoadEnergySensor, LoadPotentialEnergy, SystemEnergy
from dalembert.rigidBodyUtilities import InertiaCuboid, InertiaSphere, RotXYZ2RotationMatrix

V = exu.OutputVariableType


@pytest.fixture
def mbs() -> exu.MainSystem:
    return exu.SystemContainer().AddSystem()


def settings_for(steps: int, end: float = 1.0) -> Any:
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime = end
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.newton.relativeTolerance = 1e-11
    settings.solutionSettings.writeSolutionToFile = False
    settings.solutionSettings.sensorsWritePeriod = 0
    return settings


@pytest.mark.parametrize(
    "node_type", [exu.NodeType.RotationEulerParameters, exu.NodeType.RotationRxyz, exu.NodeType.RotationRotationVector]
)
def test_kinetic_energy_of_a_rigid_body(mbs: exu.MainSystem, node_type: exu.NodeType) -> None:
    """m v^2/2 + w J w/2 about the centre of mass, which is not the origin of the body."""
    inertia = InertiaCuboid(density=1000, sideLengths=[0.1, 0.2, 0.3]).Translated([0.05, 0.02, -0.1])
    A, v, w = RotXYZ2RotationMatrix([0.3, -0.5, 0.8]), np.array([1.0, 2, 3]), np.array([4.0, -5, 6])
    body = mbs.CreateRigidBody(
        inertia=inertia, referenceRotationMatrix=A, initialVelocity=v, initialAngularVelocity=w, nodeType=node_type
    )
    mbs.Assemble()
    com = A @ inertia.com
    J = A @ (inertia.InertiaCOM()) @ A.T
    expected = inertia.mass * np.sum((v + np.cross(w, com)) ** 2) / 2 + w @ J @ w / 2
    # sums of 20 products of numbers of the size of the result
    assert mbs.GetObjectOutput(body, V.KineticEnergy) == pytest.approx(expected, rel=1e-13, abs=0)
    assert mbs.GetObjectOutputBody(body, V.PotentialEnergy) == 0


def test_energies_of_springs(mbs: exu.MainSystem) -> None:
    """Closed forms, and the work of the force along a path between two states."""
    mass = mbs.AddNode(exu.NodePoint(referenceCoordinates=[1, 0, 0], initialCoordinates=[0.3, 0.4, 0]))
    body = mbs.AddObject(exu.MassPoint(nodeNumber=mass, mass=1))
    markers = [mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=b)) for b in (mbs.AddObject(exu.ObjectGround()), body)]
    spring = mbs.AddObject(exu.SpringDamper(markerNumbers=markers, stiffness=50, referenceLength=0.9, force=3))
    cartesian = mbs.AddObject(
        exu.CartesianSpringDamper(markerNumbers=markers, stiffness=[1, 2, 3], offset=[0.5, 0, 0.1])
    )
    planet = mbs.AddObject(
        exu.ConnectorGravity(
            markerNumbers=markers, gravitationalConstant=2, mass0=3, mass1=4, minDistanceRegularization=2
        )
    )
    mbs.Assemble()
    stretch = np.hypot(1.3, 0.4) - 0.9
    assert mbs.GetObjectOutput(spring, V.PotentialEnergy) == pytest.approx(25 * stretch**2 + 3 * stretch, rel=1e-14)
    expected = 0.5 * (0.8**2 + 2 * 0.4**2 + 3 * 0.1**2)
    assert mbs.GetObjectOutput(cartesian, V.PotentialEnergy) == pytest.approx(expected, rel=1e-14)
    way = np.array([[0.0, 0, 0], [0.1, -0.2, 0.3]])
    for item in (spring, cartesian, planet):
        ends, work = [], 0.0
        points, weights = np.polynomial.legendre.leggauss(8)
        for q in way:
            mbs.systemData.SetODE2Coordinates(q)
            ends.append(mbs.GetObjectOutput(item, V.PotentialEnergy))
        for s, weight in zip((points + 1) / 2, weights / 2, strict=True):
            mbs.systemData.SetODE2Coordinates(way[0] + s * (way[1] - way[0]))
            work += weight * mbs.GetObjectOutput(item, V.Force) @ (way[1] - way[0])
        assert ends[1] - ends[0] == pytest.approx(work, rel=1e-11)  # 8 Gauss points on a smooth force


def test_an_inactive_spring_and_one_with_a_user_function(mbs: exu.MainSystem) -> None:
    a, b = (mbs.CreateMassPoint(mass=1, referencePosition=[i, 0, 0]) for i in range(2))
    spring = mbs.CreateSpringDamper(itemNumbers=[a, b], stiffness=10, referenceLength=0.5)
    mbs.Assemble()
    assert mbs.GetObjectOutput(spring, V.PotentialEnergy) == pytest.approx(1.25)
    mbs.SetObjectParameter(spring, "activeConnector", False)
    assert mbs.GetObjectOutput(spring, V.PotentialEnergy) == 0
    mbs.SetObjectParameter(spring, "springForceUserFunction", lambda mbs, t, n, x, v, k, d, f: k * x)
    with pytest.raises(
        ValueError, match="PotentialEnergy is not available, because a user function defines its forces"
    ):
        mbs.GetObjectOutput(spring, V.PotentialEnergy)


def cantilever(mbs: Any, kind: str) -> Any:
    """Add a cable or beam of two elements, clamped at x = 0 and moving; return the elements."""
    section = [1.0 * i for i in range(3)]
    if kind == "ANCFCable2D":
        nodes = [
            mbs.AddNode(
                exu.NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0], initialVelocities=[0, 0.4 * x * x, 0, 0.8 * x])
            )
            for x in section
        ]
        cable = exu.Cable2D(
            length=1, massPerLength=2, bendingStiffness=3, axialStiffness=400, strainIsRelativeToReference=0
        )
        held = range(4)
    else:
        nodes = [
            mbs.AddNode(
                exu.NodePointSlope1(
                    referenceCoordinates=[x, 0, 0, 1, 0, 0],
                    initialVelocities=[0, 0.4 * x * x, 0.2 * x * x, 0, 0.8 * x, 0.4 * x],
                )
            )
            for x in section
        ]
        cable = exu.ObjectANCFCable(length=1, massPerLength=2, bendingStiffness=3, axialStiffness=400)
        held = range(6)
    elements = []
    for i in range(2):
        cable.nodeNumbers = nodes[i : i + 2]
        elements.append(mbs.AddObject(cable))
    ground = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(exu.NodePointGround()), coordinate=0))
    for i in held:
        marker = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=nodes[0], coordinate=i))
        mbs.AddObject(exu.CoordinateConstraint(markerNumbers=[ground, marker]))
    return elements


@pytest.mark.parametrize("kind", ["ANCFCable2D", "ANCFCable"])
def test_energy_of_a_moving_cable_is_constant(mbs: exu.MainSystem, kind: str) -> None:
    cantilever(mbs, kind)
    mbs.Assemble()
    energy = SystemEnergy(mbs)
    start = energy.ComputeSystemEnergies()
    assert start[1] == pytest.approx(0, abs=1e-14)
    assert mbs.ComputeEnergies().kinetic == pytest.approx(start[0], rel=1e-12)
    mbs.SolveDynamic(settings_for(2000), solverType=exu.DynamicSolverType.ESDIRK43)
    end = energy.ComputeSystemEnergies()
    assert end[1] > 0.1 * start[0]  # a part of the motion is strain now
    assert end[3] == pytest.approx(start[3], rel=1e-6)  # error of the integrator at this step size
    assert mbs.ComputeEnergies().potential == pytest.approx(end[1], rel=1e-9)  # work of the forces along a path


def test_energy_of_a_pendulum_with_weight_and_spring(mbs: exu.MainSystem) -> None:
    ground = mbs.CreateGround()
    body = mbs.CreateRigidBody(
        inertia=InertiaCuboid(density=1000, sideLengths=[1, 0.1, 0.1]),
        referencePosition=[0.5, 0, 0],
        gravity=[0, -9.81, 0],
    )
    mbs.CreateRevoluteJoint(itemNumbers=[ground, body], position=[0, 0, 0], axis=[0, 0, 1])
    mbs.CreateTorsionalSpringDamper(
        itemNumbers=[ground, body], position=[0, 0, 0], axis=[0, 0, 1], stiffness=20, offset=0.3
    )
    mbs.Assemble()
    energy = SystemEnergy(mbs)
    assert energy.unavailable == []
    sensor = energy.AddSensor()
    of_load = CreateLoadEnergySensor(mbs, 0)
    mbs.Assemble()
    start = energy.ComputeSystemEnergies()
    assert start == pytest.approx([0, 0.5 * 20 * 0.3**2, 0, 0.9], abs=1e-13)
    mbs.SolveDynamic(settings_for(2000))
    history = mbs.GetSensorStoredData(sensor)
    assert np.ptp(history[:, 1]) > 1  # J, of motion
    # generalized alpha with 0.5 ms: dissipation and phase error of w h about 1e-3
    assert np.abs(history[:, 4] - 0.9).max() < 1e-4 * np.ptp(history[:, 1])
    height = mbs.GetObjectOutputBody(body, V.Position)[1]
    assert mbs.GetSensorStoredData(of_load)[-1, 1] == pytest.approx(10 * 9.81 * height, rel=1e-12)


def test_loads_whose_potential_is_not_known(mbs: exu.MainSystem) -> None:
    body = mbs.CreateRigidBody(
        inertia=InertiaSphere(mass=1, radius=1), referencePosition=[1, 0, 0], initialDisplacement=[0, 2, 0]
    )
    force = mbs.CreateForce(itemNumber=body, loadVector=[3, 4, 5])
    follower = mbs.CreateForce(itemNumber=body, loadVector=[1, 0, 0], bodyFixed=True)
    torque = mbs.CreateTorque(itemNumber=body, loadVector=[1, 0, 0])
    mbs.Assemble()
    assert LoadPotentialEnergy(mbs, force) == pytest.approx(-8)
    assert LoadPotentialEnergy(mbs, follower) is None
    assert LoadPotentialEnergy(mbs, torque) is None
    assert [entry[0] for entry in SystemEnergy(mbs).unavailable] == [int(follower), int(torque)]
    with pytest.raises(ValueError, match=r"the potential energy of load 'load2' \(TorqueVector\) is not known"):
        CreateLoadEnergySensor(mbs, torque)
    with pytest.raises(ValueError, match="SystemEnergy: PotentialEnergy of item 1"):
        SystemEnergy(mbs, skipUnavailable=False)


def test_energies_of_a_kinematic_tree(mbs: exu.MainSystem) -> None:
    """One link about z: J w^2/2 about the joint, and the height of its centre of mass; the spring of its controller."""
    node = mbs.AddNode(
        exu.NodeGenericODE2(
            numberOfODE2Coordinates=1, referenceCoordinates=[0.2], initialCoordinates=[0.3], initialCoordinates_t=[2]
        )
    )
    tree = exu.ObjectKinematicTree(
        nodeNumber=node, jointTypes=[exu.JointType.RevoluteZ], linkParents=[-1],
        jointTransformations=exu.Matrix3DList([np.eye(3)]), jointOffsets=exu.Vector3DList([[0, 0.5, 0]]),
        linkInertiasCOM=exu.Matrix3DList([np.eye(3)]), linkCOMs=exu.Vector3DList([[0.5, 0, 0]]), linkMasses=[2],
        gravity=[0, -9.81, 0], jointPControlVector=[10], jointPositionOffsetVector=[0.1],
        jointDControlVector=[0], jointVelocityOffsetVector=[0], jointForceVector=[7],
    )  # fmt: skip
    number = mbs.AddObject(tree)
    mbs.Assemble()
    assert mbs.GetObjectOutput(number, V.KineticEnergy) == pytest.approx(0.5 * (1 + 2 * 0.25) * 4, rel=1e-14)
    weight = 2 * 9.81 * 0.5 * (np.sin(0.5) - np.sin(0.2))
    expected = weight + 0.5 * 10 * 0.4**2 - 7 * 0.3
    assert mbs.GetObjectOutput(number, V.PotentialEnergy) == pytest.approx(expected, rel=1e-13)


def test_energies_of_matrices(mbs: exu.MainSystem) -> None:
    nodes = [mbs.AddNode(exu.NodePoint(initialCoordinates=[0.1, 0, i], initialVelocities=[1, 2, 3])) for i in range(2)]
    M, K = np.diag([1.0, 2, 3, 4, 5, 6]), np.eye(6) * 100 - np.ones((6, 6))
    body = mbs.AddObject(
        exu.ObjectGenericODE2(nodeNumbers=nodes, massMatrix=M, stiffnessMatrix=K, forceVector=[1, 0, 0, 0, 0, 2])
    )
    mbs.Assemble()
    u, v = np.array([0.1, 0, 0, 0.1, 0, 1]), np.array([1.0, 2, 3, 1, 2, 3])
    assert mbs.GetObjectOutput(body, V.KineticEnergy) == pytest.approx(v @ M @ v / 2, rel=1e-14)
    assert mbs.GetObjectOutput(body, V.PotentialEnergy) == pytest.approx(u @ K @ u / 2 - 0.1 - 2, rel=1e-13)


def test_transformations_of_bodies_and_joints(mbs: exu.MainSystem) -> None:
    A = RotXYZ2RotationMatrix([0.1, 0.2, 0.3])
    ground = mbs.CreateGround()
    body = mbs.CreateRigidBody(
        inertia=InertiaSphere(mass=1, radius=1), referencePosition=[1, 2, 3], referenceRotationMatrix=A
    )
    joint = mbs.CreateGenericJoint(itemNumbers=[ground, body], position=[1, 2, 4], constrainedAxes=[0] * 6)
    sensor = mbs.AddSensor(exu.SensorBody(bodyNumber=body, outputVariableType=V.HomogeneousTransformation))
    mbs.Assemble()
    H = mbs.GetObjectOutputBody(body, V.HomogeneousTransformation, [0, 0, 1])
    assert isinstance(H, exu.HT)
    assert np.allclose(H.rotation, A, rtol=0, atol=1e-15)
    assert np.allclose(H.translation, [1, 2, 3] + A[:, 2], rtol=0, atol=1e-15)
    assert np.allclose(mbs.GetNodeOutput(0, V.HomogeneousTransformation) * [0, 0, 1], H.translation, rtol=0, atol=1e-15)
    assert np.allclose(mbs.GetSensorValues(sensor), exu.HT(A, [1, 2, 3]).HT44().ravel(), rtol=0, atol=1e-15)
    assert np.allclose(
        mbs.GetObjectOutput(joint, V.HomogeneousTransformation), exu.HT(translation=[1, 2, 4]), rtol=0, atol=1e-15
    )
    turn, way = exu.HT(rotationVector=[0.1, 0.2, 0.3]), np.array([0.01, 0.02, 0.03])
    q = mbs.systemData.GetODE2Coordinates()
    q[:3] += way
    mbs.systemData.SetODE2Coordinates(q)
    local = mbs.GetObjectOutput(joint, V.HomogeneousTransformationLocal)
    assert np.allclose(local.translation, way, rtol=0, atol=1e-15)
    assert local.RotationAngle() == pytest.approx(0, abs=1e-7)
    assert turn.RotationAngle() == pytest.approx(np.sqrt(0.14))
