"""Outputs of planar joints, springs and contacts agree with those of their markers and with the forces in the system."""

from __future__ import annotations

from typing import Any

import numpy as np

import dalembert as exu

V = exu.OutputVariableType


def two_bodies(mbs: exu.MainSystem) -> list[exu.MarkerIndex]:
    """Add two moving planar bodies; return a rigid marker on each."""
    places = ([0.3, 0.2, 0.4], [1, 2, 3], [0.1, 0.2, 0]), ([1.3, 0.7, 0.9], [0.5, -1, 2], [-0.3, 0.1, 0])
    markers = []
    for reference, velocities, point in places:
        node = mbs.AddNode(exu.NodeRigidBody2D(referenceCoordinates=reference, initialVelocities=velocities))
        body = mbs.AddObject(exu.ObjectRigidBody2D(nodeNumber=node, mass=1, inertia=1))
        markers.append(mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body, localPosition=point)))
    return markers


def of(mbs: exu.MainSystem, markers: list[exu.MarkerIndex], name: str) -> list[np.ndarray]:
    return [np.asarray(mbs.GetMarkerOutput(marker, getattr(V, name))) for marker in markers]


def close(value: Any, wanted: Any) -> None:
    np.testing.assert_allclose(value, wanted, rtol=0, atol=1e-13)  # rounding of numbers of size 50


def test_planar_joints() -> None:
    """An arm turns about a hinge; a body slides along it. Forces are those on the markers, which come from the residual."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=mbs.AddObject(exu.ObjectGround())))
    turn = 0.3
    along = np.array([np.cos(turn), np.sin(turn)])
    bodies = []
    for distance in (0.5, 0.8):
        node = mbs.AddNode(exu.NodeRigidBody2D(referenceCoordinates=[*(distance * along), turn]))
        bodies.append(mbs.AddObject(exu.ObjectRigidBody2D(nodeNumber=node, mass=1, inertia=0.1)))
        weight = mbs.AddMarker(exu.MarkerBodyMass(bodyNumber=bodies[-1]))
        mbs.AddLoad(exu.LoadMassProportional(markerNumber=weight, loadVector=[0, -9.81, 0]))
    base = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=bodies[0], localPosition=[-0.5, 0, 0]))
    markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body)) for body in bodies]
    hinge = mbs.AddObject(exu.ObjectJointRevolute2D(markerNumbers=[ground, base]))
    slide = mbs.AddObject(
        exu.ObjectJointPrismatic2D(markerNumbers=markers, axisMarker0=[1, 0, 0], normalMarker1=[0, 1, 0])
    )
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps, settings.timeIntegration.endTime = 100, 0.2
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveDynamic(settings)
    (p0, p1), (v0, _) = of(mbs, markers, "Position"), of(mbs, markers, "Velocity")
    rotations = [np.reshape(R, (3, 3)) for R in of(mbs, markers, "RotationMatrix")]

    def read(joint: Any, name: str) -> Any:
        return mbs.GetObjectOutput(joint, getattr(V, name))

    close(read(hinge, "Position"), [0, 0, 0])
    close(read(hinge, "Velocity"), [0, 0, 0])
    close(read(hinge, "Displacement"), of(mbs, [base], "Position")[0])
    close(read(hinge, "Force"), read(hinge, "WrenchOnMarker0")[:3])
    assert np.linalg.norm(read(hinge, "Force")) > 1
    close(read(slide, "Position"), p0)
    close(read(slide, "Velocity"), v0)
    local = rotations[0].T @ (p1 - p0)
    close(read(slide, "DisplacementLocal"), local)
    close(read(slide, "Distance"), local[0])
    assert abs(local[0] - 0.3) > 0.01 > 1e-6 > abs(local[1])  # it has moved, along the axis
    assert abs(read(slide, "Rotation")) < 1e-6  # Newton's tolerance
    close(read(slide, "ForceLocal"), rotations[0].T @ read(slide, "WrenchOnMarker0")[:3])
    assert abs(read(slide, "ForceLocal")[1]) > 0.5
    close(read(slide, "HomogeneousTransformation"), exu.HT(rotations[0], p0))
    between = exu.HT(rotations[0], p0).Inverse() * exu.HT(rotations[1], p1)
    close(read(slide, "HomogeneousTransformationLocal"), between)


def test_displacements_of_springs() -> None:
    mbs = exu.SystemContainer().AddSystem()
    markers = two_bodies(mbs)
    springs = [
        mbs.AddObject(exu.ObjectConnectorLinearSpringDamper(markerNumbers=markers, stiffness=1)),
        mbs.AddObject(exu.ObjectConnectorRigidBodySpringDamper(markerNumbers=markers, stiffness=np.eye(6))),
    ]
    mbs.Assemble()
    first, second = of(mbs, markers, "Position")
    for spring in springs:
        close(mbs.GetObjectOutput(spring, V.Displacement), second - first)


def test_velocities_of_contacts() -> None:
    """For a sphere that does not rotate, the rate of the span to the nearest point is normal to the triangle.

    The tangential part is that of the carrier. A sphere fixed to the tube does not slip in it.
    """
    mbs = exu.SystemContainer().AddSystem()
    inertia = exu.utilities.InertiaSphere(1, 0.5)
    omega, turn = np.array([4.0, 5, 6]), exu.utilities.RotationMatrixX(0.1)
    carrier = mbs.CreateRigidBody(
        inertia=inertia, referencePosition=[1, 2, 0.4], referenceRotationMatrix=turn, initialVelocity=[1, 2, 3],
        initialAngularVelocity=omega,
    )  # fmt: skip
    start = np.array([1.7, 2.1, 0.8])
    drift = np.array([1, 2, 3]) + np.cross(omega, start - [1, 2, 0.4])
    spheres = [
        mbs.CreateRigidBody(inertia=inertia, referencePosition=start, initialVelocity=v, initialAngularVelocity=w)
        for v, w in (([-1, 0.3, 0.2], [0, 0, 0]), (drift, omega))
    ]
    on_carrier, *on_spheres = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body)) for body in (carrier, *spheres)]

    def data() -> exu.NodeIndex:
        return mbs.AddNode(exu.NodeGenericData(numberOfDataCoordinates=4, initialCoordinates=[1, 0, 0, 0]))

    corners = exu.Vector3DList([[-1, -1, 0.1], [2, -1, 0.1], [0, 2, 0.2]])
    triangle = mbs.AddObject(
        exu.ObjectContactSphereTriangle(
            markerNumbers=[on_spheres[0], on_carrier], nodeNumber=data(), sphereRadius=0.2, trianglePoints=corners
        )
    )
    torus = mbs.AddObject(
        exu.ObjectContactSphereTorus(
            markerNumbers=[on_spheres[1], on_carrier], nodeNumber=data(), sphereRadius=0.1, torusMajorRadius=0.8,
            torusMinorRadius=0.4, torusAxis=[0, 0, 1],
        )
    )  # fmt: skip
    mbs.Assemble()
    point = start + mbs.GetObjectOutput(triangle, V.Displacement)
    wanted = np.array([1, 2, 3]) + np.cross(omega, point - [1, 2, 0.4]) - [-1, 0.3, 0.2]
    close(mbs.GetObjectOutput(triangle, V.Velocity), wanted)
    close(mbs.GetObjectOutput(torus, V.Velocity), [0, 0, 0])


def test_forces_and_rates_of_a_geometrically_exact_beam() -> None:
    """A straight beam: strain 0.05 and shear 0.02; its nodes rotate alike."""
    mbs = exu.SystemContainer().AddSystem()
    nodes = [
        mbs.AddNode(exu.NodeRigidBodyRxyz(referenceCoordinates=[x, 0, 0, 0, 0, 0], initialCoordinates=q, initialVelocities=v))
        for x, q, v in ((0, [0] * 6, [0, 0, 0, 1, 2, 3]), (1, [0.05, 0.02, 0, 0, 0, 0], [0, 0, 0, 1, 2, 3]))
    ]  # fmt: skip
    section = exu.BeamSection()
    section.stiffnessMatrix = np.diag([1e3, 2e3, 3e3, 4, 5, 6])
    section.inertia, section.massPerLength = np.eye(3), 1
    beam = mbs.AddObject(exu.ObjectBeamGeometricallyExact(nodeNumbers=nodes, length=1, sectionData=section))
    mbs.Assemble()

    def read(name: str) -> Any:
        return mbs.GetObjectOutputBody(beam, getattr(V, name), [0.1, 0, 0])

    close(read("ForceLocal"), [1e3 * 0.05, 2e3 * 0.02, 0])
    close(read("TorqueLocal"), [0, 0, 0])
    close(read("RotationMatrix"), np.eye(3).ravel())
    close(read("AngularVelocity"), [1, 2, 3])
    close(read("AngularVelocityLocal"), [1, 2, 3])
