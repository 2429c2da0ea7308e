"""Differences from Exudyn: results are compared with formulas, and with the values of Exudyn."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.linalg import expm, logm
from scipy.spatial.transform import Rotation
from solving import Variable, new_system, settings
from test_heavy_top import ERRORS, axis_motion, heavy_top

import dalembert as exu

BODY = Rotation.from_rotvec([0.3, -0.5, 0.7]).as_matrix()
JOINT = Rotation.from_rotvec([-0.4, 0.2, 0.9]).as_matrix()
ALL = Rotation.from_rotvec([1.1, 0.6, -0.8]).as_matrix()
STIFFNESS = np.diag([100.0, 200, 300])
OFFSET = np.array([0.1, -0.2, 0.05])


def spring_force(turn: np.ndarray, offset: np.ndarray) -> np.ndarray:
    """A body of 1 kg at an offset from a rotated ground: its acceleration from rest."""
    mbs = new_system()
    ground = mbs.CreateGround(referenceRotationMatrix=turn)
    node = mbs.AddNode(exu.NodeRigidBodyRotVecLG(referenceCoordinates=[*offset, 0, 0, 0]))
    body = mbs.AddObject(exu.RigidBody(physicsMass=1, physicsInertia=[1, 1, 1, 0, 0, 0], nodeNumber=node))
    markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=b)) for b in (ground, body)]
    stiffness = np.zeros((6, 6))
    stiffness[:3, :3] = STIFFNESS
    mbs.AddObject(exu.RigidBodySpringDamper(markerNumbers=markers, stiffness=stiffness, rotationMarker0=JOINT))
    mbs.Assemble()
    mbs.SolveDynamic(settings(1e-9, 1))
    return np.asarray(mbs.GetObjectOutputBody(body, Variable.Acceleration, [0, 0, 0]))


def force_in(frame: np.ndarray, offset: np.ndarray) -> np.ndarray:
    return np.asarray(-frame @ STIFFNESS @ frame.T @ offset)


def test_frame_of_the_rigid_body_spring_damper() -> None:
    """The joint frame is marker times rotationMarker0, so that a model that is turned as a whole has turned forces. The
    frame does not rotate with its body in the other order."""
    np.testing.assert_allclose(spring_force(BODY, OFFSET), force_in(BODY @ JOINT, OFFSET), rtol=0, atol=1e-9)
    turned = spring_force(ALL @ BODY, ALL @ OFFSET)
    np.testing.assert_allclose(turned, ALL @ spring_force(BODY, OFFSET), rtol=0, atol=1e-9)
    other = ALL @ force_in(JOINT @ BODY, OFFSET) - force_in(JOINT @ ALL @ BODY, ALL @ OFFSET)
    assert np.linalg.norm(other) > 1


def test_intrinsic_spring_by_matrix_functions() -> None:
    """Force and torque on a body from the logarithm of its pose, a matrix of four rows: the mean of the axes is half of
    it. Accelerations from rest of 1 kg and 1 kg m^2 follow from them."""
    stiffness = np.diag([100.0, 200, 300, 5, 7, 9]) + np.diag([4.0] * 5, 1)
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = BODY, OFFSET
    mbs = new_system()
    turn = Rotation.from_matrix(BODY).as_rotvec()
    node = mbs.AddNode(exu.NodeRigidBodyRotVecLG(referenceCoordinates=[*OFFSET, *turn]))
    body = mbs.AddObject(exu.RigidBody(physicsMass=1, physicsInertia=[1, 1, 1, 0, 0, 0], nodeNumber=node))
    markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=b)) for b in (mbs.CreateGround(), body)]
    mbs.AddObject(exu.RigidBodySpringDamper(markerNumbers=markers, stiffness=stiffness, intrinsicFormulation=True))
    mbs.Assemble()
    mbs.SolveDynamic(settings(1e-9, 1))

    motion = np.real(logm(pose))
    shift, skew = motion[:3, 3], motion[:3, :3]
    local = stiffness @ [*shift, skew[2, 1], skew[0, 2], skew[1, 0]]
    middle = expm(motion / 2)[:3, :3]
    force = -middle @ local[:3]
    torque = -middle @ local[3:] - np.cross(middle @ shift / 2, force)
    outputs = ((Variable.Acceleration, force), (Variable.AngularAcceleration, torque))
    for variable, wanted in outputs:
        found = mbs.GetObjectOutputBody(body, variable, [0, 0, 0])
        np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-6)


@pytest.mark.parametrize(("node", "scheme"), ERRORS)
def test_first_force_of_the_heavy_top(node: str, scheme: str) -> None:
    """Reference rotations are not zero. The balance of angular momentum gives 319.5 N inwards and 317.3 N downwards."""
    mbs, _, joint = heavy_top(node)
    force = mbs.AddSensor(exu.SensorObject(objectNumber=joint, outputVariableType=Variable.Force, storeInternal=True))
    mbs.Assemble()
    mbs.SolveDynamic(settings(1e-6, 1))
    start = mbs.GetSensorStoredData(force)[0, 1:]
    np.testing.assert_allclose(start, axis_motion(0.0)[2], rtol=0, atol=1e-6)


def triple_products(turn: Any) -> np.ndarray:
    """x0 . (y1 x z0) - 1 and its cyclic neighbours."""
    frame = Rotation.from_rotvec(turn).as_matrix().T
    axes = np.eye(3)
    return np.array([axes[k] @ np.cross(frame[(k + 1) % 3], axes[(k + 2) % 3]) - 1 for k in range(3)])


def test_alternative_constraints_are_regular() -> None:
    """Triple products have no gradient where the frames agree, so no torque can hold them there; a rotation vector has."""
    h = 1e-5
    slopes = np.array([triple_products(h * e) - triple_products(-h * e) for e in np.eye(3)]) / (2 * h)
    np.testing.assert_allclose(slopes, 0, atol=1e-9)
    mbs = new_system()
    node = mbs.AddNode(exu.NodeRigidBodyRotVecLG())
    body = mbs.AddObject(exu.RigidBody(physicsMass=1, physicsInertia=[1, 1, 1, 0, 0, 0], nodeNumber=node))
    ground = mbs.AddObject(exu.ObjectGround())
    markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=b)) for b in (ground, body)]
    mbs.AddObject(exu.GenericJoint(markerNumbers=markers, alternativeConstraints=True))
    mbs.Assemble()
    gradients = mbs.ComputeLinearizedSystem(returnConstraintJacobian=True)[3]
    np.testing.assert_allclose(np.linalg.svd(gradients, compute_uv=False), 1, rtol=0, atol=1e-9)


def gears(turn: float) -> tuple[exu.MainSystem, np.ndarray]:
    """Two rotors whose rims are coupled by a spring, and its matrix."""
    mbs = new_system()
    factors, stiffness = (0.5, -1.5), 1e4
    nodes = [mbs.AddNode(exu.Node1D(referenceCoordinates=[0], initialCoordinates=[q])) for q in (turn, 0)]
    for node, inertia in zip(nodes, (1.0, 3.0), strict=True):
        mbs.AddObject(exu.Rotor1D(physicsInertia=inertia, nodeNumber=node))
    markers = [mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=n, coordinate=0)) for n in nodes]
    mbs.AddObject(
        exu.CoordinateSpringDamperExt(
            markerNumbers=markers, stiffness=stiffness, factor0=factors[0], factor1=factors[1]
        )
    )
    mbs.Assemble()
    across = np.array([-factors[0], factors[1]])
    return mbs, stiffness * np.outer(across, across)


def test_factors_of_the_coordinate_spring_are_in_its_tangent() -> None:
    """The system is linear, so each step takes one iteration. The trapezoidal rule turns the oscillation by
    2 atan(omega h / 2) a step, with omega^2 = k (f0^2 / J0 + f1^2 / J1)."""
    turn, steps, h = 0.01, 50, 1e-3
    mbs, stiffness = gears(turn)
    np.testing.assert_allclose(mbs.ComputeLinearizedSystem()[1], stiffness, rtol=1e-13)
    chosen = settings(steps * h, steps)
    chosen.timeIntegration.generalizedAlpha.computeInitialAccelerations = True
    mbs.SolveDynamic(chosen, solverType=exu.DynamicSolverType.TrapezoidalIndex2)
    assert mbs.sys["dynamicSolver"].it.newtonStepsCount == steps
    omega = np.sqrt(np.trace(stiffness / np.array([1.0, 3.0])))
    stretch = np.array([-0.5, -1.5]) @ np.array(mbs.systemData.GetODE2Coordinates())
    exact = -0.5 * turn * np.cos(steps * 2 * np.arctan(omega * h / 2))
    np.testing.assert_allclose(stretch, exact, rtol=0, atol=1e-12)  # round-off of the steps


def torus_force(frame: np.ndarray, centre: np.ndarray) -> np.ndarray:
    """A sphere at rest in the tube of a torus whose axis is the third of the frame."""
    mbs = new_system()
    ground = mbs.CreateGround(referenceRotationMatrix=frame)
    sphere = mbs.CreateRigidBody(referencePosition=centre, inertia=exu.utilities.InertiaSphere(1, 0.1))
    markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=b)) for b in (sphere, ground)]
    data = mbs.AddNode(exu.NodeGenericData(initialCoordinates=[-1, 0, 0, 0], numberOfDataCoordinates=4))
    mbs.AddObject(
        exu.ObjectContactSphereTorus(
            markerNumbers=markers, nodeNumber=data, radiusSphere=0.1, torusMajorRadius=1, torusMinorRadius=0.12,
            torusAxis=[0, 0, 1], contactStiffness=1e3,
        )
    )  # fmt: skip
    mbs.Assemble()
    mbs.SolveDynamic(settings(1e-9, 1))
    return np.asarray(mbs.GetObjectOutputBody(sphere, Variable.Acceleration, [0, 0, 0]))


def test_sphere_out_of_the_plane_of_a_torus() -> None:
    """The force points to the circle of radius 1 around the axis, has 1000 N/m times the excess of the distance over
    the clearance of 0.02, and rotates with the torus. Taking the distance from the plane off every coordinate moves the
    foot point along the plane."""
    foot = np.array([np.cos(0.3), np.sin(0.3), 0])
    offset = 0.02 * foot + [0, 0, 0.03]
    distance = np.linalg.norm(offset)
    force = -1e3 * (distance - 0.02) * offset / distance
    for frame in (np.eye(3), ALL):
        np.testing.assert_allclose(torus_force(frame, frame @ (foot + offset)), frame @ force, rtol=0, atol=1e-9)
    shifted = foot + offset - 0.03
    wrong = foot + offset - shifted / np.linalg.norm(shifted)
    assert np.linalg.norm(-1e3 * (np.linalg.norm(wrong) - 0.02) * wrong / np.linalg.norm(wrong) - force) > 1


def falling_pendulum(tolerance: float, modified: bool) -> np.ndarray:
    """The angle of a rod of 1 m and 12 kg that falls from horizontal, with a load at its end."""
    mbs = new_system()
    node = mbs.AddNode(exu.NodeRigidBody2D(referenceCoordinates=[0.5, 0, 0]))
    rod = mbs.AddObject(exu.RigidBody2D(physicsMass=12, physicsInertia=1, nodeNumber=node))
    ground = mbs.AddObject(exu.ObjectGround())
    support, end = (mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=rod, localPosition=[x, 0, 0])) for x in (-0.5, 0.5))
    mbs.AddObject(
        exu.RevoluteJoint2D(markerNumbers=[mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=ground)), support])
    )
    mbs.AddLoad(exu.Force(markerNumber=end, loadVector=[0, -12 * 9.81, 0]))
    angle = mbs.AddSensor(exu.SensorNode(nodeNumber=node, outputVariableType=Variable.Coordinates, storeInternal=True))
    mbs.Assemble()
    chosen = settings(2, 100, spectral_radius=0.5)
    chosen.timeIntegration.newton.useModifiedNewton = modified
    chosen.timeIntegration.newton.relativeTolerance = 1e-4 * tolerance
    chosen.timeIntegration.newton.absoluteTolerance = tolerance
    mbs.SolveDynamic(chosen)
    return np.asarray(mbs.GetSensorStoredData(angle)[:, 3])


def test_difference_of_full_and_modified_newton_is_their_tolerance() -> None:
    """A sum of a hundred differences, with 1e-4 as tolerance of forces and with 1e-9."""
    differences = [np.abs(falling_pendulum(t, True) - falling_pendulum(t, False)).sum() for t in (1e-4, 1e-9)]
    assert 1e-6 < differences[0] < 1e-4
    assert differences[1] < 1e-8


def disc_on_a_free_cable(segment_normals: bool) -> tuple[exu.MainSystem, int, list[int], int]:
    """A disc that spins is pressed into a cable of four elements, both free: disc, nodes of the cable, a sensor of contacts' forces and gaps."""
    mbs = new_system()
    nodes = [mbs.AddNode(exu.NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0])) for x in np.linspace(-0.5, 0.5, 5)]
    disc = mbs.AddNode(
        exu.NodeRigidBody2D(referenceCoordinates=[0.03, 0.195, 0], initialVelocities=[0, -0.2, 5])
    )  # 5 mm deep
    body = mbs.AddObject(exu.RigidBody2D(physicsMass=1, physicsInertia=0.02, nodeNumber=disc))
    centre = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body))
    for pair in zip(nodes[:-1], nodes[1:], strict=True):
        cable = mbs.AddObject(
            exu.Cable2D(
                physicsLength=0.25, physicsMassPerLength=2, physicsBendingStiffness=5, physicsAxialStiffness=1e3, nodeNumbers=list(pair)
            )
        )  # fmt: skip
        shape = mbs.AddMarker(exu.MarkerBodyCable2DShape(bodyNumber=cable, numberOfSegments=4))
        states = mbs.AddNode(
            exu.NodeGenericData(numberOfDataCoordinates=12, initialCoordinates=[0.1] * 4 + [-2] * 4 + [0] * 4)
        )
        contact = mbs.AddObject(
            exu.ObjectContactFrictionCircleCable2D(
                markerNumbers=[centre, shape], nodeNumber=states, numberOfContactSegments=4, contactStiffness=2e3, contactDamping=2,
                frictionVelocityPenalty=20, frictionCoefficient=0.4, circleRadius=0.2, useSegmentNormals=segment_normals,
            )
        )  # fmt: skip
        for variable in (Variable.ForceLocal, Variable.Coordinates):
            mbs.AddSensor(exu.SensorObject(objectNumber=contact, outputVariableType=variable, storeInternal=True))
    mbs.Assemble()
    return mbs, disc, nodes, 8


def angular_momentum(mbs: exu.MainSystem, disc: int, nodes: list[int], length: float) -> float:
    """About the origin: of the disc, and of the axis of the cable by four points per element."""
    value = lambda node, name: np.array(mbs.GetNodeOutput(node, getattr(Variable, name)))  # noqa: E731
    place, speed = value(disc, "Position"), value(disc, "Velocity")
    sum_ = 0.02 * value(disc, "AngularVelocity")[2] + np.cross(place, speed)[2]
    start = np.array([[x, 0, 1, 0] for x in np.linspace(-0.5, 0.5, len(nodes))])
    q = start + [value(node, "Coordinates") for node in nodes]
    v = np.array([value(node, "Coordinates_t") for node in nodes])
    for x, weight in zip(*np.polynomial.legendre.leggauss(4), strict=True):
        s = (1 + x) / 2
        shapes = [1 - 3 * s**2 + 2 * s**3, length * (s - 2 * s**2 + s**3), 3 * s**2 - 2 * s**3, length * (s**3 - s**2)]
        r, w = (
            sum(n * part for n, part in zip(shapes, (c[:-1, :2], c[:-1, 2:], c[1:, :2], c[1:, 2:]), strict=True))
            for c in (q, v)
        )
        sum_ += 2 * length * weight / 2 * (r[:, 0] * w[:, 1] - r[:, 1] * w[:, 0]).sum()
    return float(sum_)


@pytest.mark.parametrize("segment_normals", [True, False])
def test_friction_on_a_cable_keeps_angular_momentum(segment_normals: bool) -> None:
    """Nothing acts from outside. The sum would grow by friction times gap if the radius, without the gap, was the lever
    arm of friction."""
    mbs, disc, nodes, sensors = disc_on_a_free_cable(segment_normals)
    before = angular_momentum(mbs, disc, nodes, 0.25)
    chosen = settings(0.05, 500)
    chosen.solutionSettings.sensorsWritePeriod = 1e-4
    mbs.SolveDynamic(chosen)
    assert angular_momentum(mbs, disc, nodes, 0.25) == pytest.approx(
        before, abs=2e-8
    )  # 4e-9, a quarter with half the steps
    data = [np.asarray(mbs.GetSensorStoredData(i))[:, 1:] for i in range(sensors)]
    wrong = sum((force[:, ::2] * gap[:, 1::2]).sum() * 1e-4 for force, gap in zip(data[::2], data[1::2], strict=True))
    assert abs(wrong) > 1e-4
