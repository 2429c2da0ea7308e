"""mbs.ComputeItem against differences, balances of forces, and momentum."""

from __future__ import annotations

import numpy as np
import pytest

import dalembert as exu
from dalembert._core import testing
from dalembert.advancedUtilities import ItemODE2Coordinates, NumericalJacobian
from dalembert.itemInterface import CoordinateConstraint, MarkerBodyRigid, MarkerNodeCoordinate, NodePointGround
from dalembert.rigidBodyUtilities import InertiaCuboid

Type = exu.ComputeItemType


@pytest.fixture
def model() -> tuple[exu.MainSystem, exu.ObjectIndex, exu.ObjectIndex]:
    """A body with its center of mass beside its origin, on a hinge, at an angle and in motion."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    body = mbs.CreateRigidBody(
        referencePosition=[1, 0, 0],
        inertia=InertiaCuboid(1000, [1, 0.1, 0.1]).Translated([0.2, 0.1, 0]),
        nodeType=exu.NodeType.RotationRxyz,
        gravity=[0, 0, -9.81],
    )
    joint = mbs.CreateRevoluteJoint(bodyNumbers=[ground, body], position=[0.5, 0, 0], axis=[0, 1, 0])
    mbs.Assemble()
    mbs.systemData.SetODE2Coordinates([0.1, -0.2, 0.3, 0.4, -0.3, 0.2])
    mbs.systemData.SetODE2Coordinates_t([1, 2, 3, -1, 0.5, 2])
    return mbs, body, joint


def test_constraint_jacobians_are_the_derivatives_of_the_equations(
    model: tuple[exu.MainSystem, exu.ObjectIndex, exu.ObjectIndex],
) -> None:
    mbs, body, joint = model
    coordinates = ItemODE2Coordinates(mbs, body)
    assert [each.name for each in mbs.ComputeItem(joint)] == [
        "AlgebraicEquations",
        "ConstraintJacobian",
        "ReactionForces",
    ]
    found = mbs.ComputeItem(joint, Type.ConstraintJacobian)
    expected = NumericalJacobian(mbs, lambda: mbs.ComputeItem(joint, Type.AlgebraicEquations), coordinates)
    assert found.shape == (5, 6)
    np.testing.assert_allclose(found, expected, atol=1e-8)  # differences of 1e-6
    multipliers = np.arange(1.0, 6.0)
    mbs.systemData.SetAECoordinates(multipliers)
    np.testing.assert_allclose(mbs.ComputeItem(joint, Type.ReactionForces), found.T @ multipliers, atol=1e-12)


def test_reactions_hold_a_weight() -> None:
    mbs = exu.SystemContainer().AddSystem()
    mass = mbs.CreateMassPoint(physicsMass=2, gravity=[0, 0, -10])
    node = mbs.GetObject(mass)["nodeNumber"]
    ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
    markers = [mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=i)) for i in range(3)]
    fixed = [mbs.AddObject(CoordinateConstraint(markerNumbers=[ground, marker])) for marker in markers]
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveStatic(settings)
    assert abs(mbs.ComputeItem(fixed[2], Type.ReactionForces)) == pytest.approx(np.array([20.0]), rel=1e-12)
    assert mbs.ComputeItem(fixed[0], Type.ReactionForces) == pytest.approx(np.array([0.0]), abs=1e-12)
    np.testing.assert_array_equal(mbs.ComputeItem(markers[1], Type.CoordinateJacobian), [[0, 1, 0]])


def test_mass_weighted_jacobians_give_the_momentum(
    model: tuple[exu.MainSystem, exu.ObjectIndex, exu.ObjectIndex],
) -> None:
    mbs, body, _ = model
    velocities = np.array(mbs.systemData.GetODE2Coordinates_t())
    center = mbs.GetObjectParameter(body, "physicsCenterOfMass")
    momentum = 10 * np.array(mbs.GetObjectOutputBody(body, exu.OutputVariableType.Velocity, center))
    found = mbs.ComputeItem(body, Type.MassWeightedPositionJacobian)
    np.testing.assert_allclose(found @ velocities, momentum, rtol=1e-10)
    rows = mbs.ComputeItem(body, Type.MassMatrix)[:3]  # momentum of translations
    np.testing.assert_allclose(found, rows, atol=1e-8)


def test_derivatives_of_forces_are_those_of_their_work(
    model: tuple[exu.MainSystem, exu.ObjectIndex, exu.ObjectIndex],
) -> None:
    """A constant force has the potential f.p: its forces on coordinates have the second derivatives of that."""
    mbs, body, _ = model
    place, force = [0.1, 0.2, 0.3], np.array([1.0, -2.0, 3.0])
    coordinates = ItemODE2Coordinates(mbs, body)
    found = mbs.ComputeItem(body, Type.JacobianTTimesVectorDerivative, place, [*force, 0, 0, 0])

    def work() -> float:
        return float(force @ mbs.GetObjectOutputBody(body, exu.OutputVariableType.Position, place))

    second = NumericalJacobian(
        mbs, lambda: NumericalJacobian(mbs, work, coordinates, epsilon=1e-4)[0], coordinates, epsilon=1e-4
    )
    np.testing.assert_allclose(found, second, atol=1e-6)
    np.testing.assert_allclose(found, found.T, atol=1e-8)
    marker_free = [each.name for each in mbs.ComputeItem(body)]
    assert "ConstraintJacobian" not in marker_free and "JacobianTTimesVectorDerivative" in marker_free
    with pytest.raises(ValueError, match="vector: expected a vector with 6 components, received None"):
        mbs.ComputeItem(body, Type.JacobianTTimesVectorDerivative)
    with pytest.raises(
        ValueError, match="what: CoordinateJacobian is not available for object 1; available: PositionJacobian"
    ):
        mbs.ComputeItem(body, Type.CoordinateJacobian)


@pytest.mark.parametrize("node", [exu.NodeType.RotationRxyz, exu.NodeType.RotationEulerParameters])
def test_terms_of_objects_are_those_of_the_equations_of_motion(node: exu.NodeType) -> None:
    """The terms of two bodies and two springs add up to those of the system; Jacobians are their derivatives."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    inertia = InertiaCuboid(1000, [0.2, 0.1, 0.3]).Translated([0.1, 0.05, 0])
    bodies = [
        mbs.CreateRigidBody(
            referencePosition=[i, 0.2, 0], inertia=inertia, nodeType=node, initialAngularVelocity=[1, 2, -i],
            initialVelocity=[0, i, 1],
        )
        for i in range(2)
    ]  # fmt: skip
    springs = [
        mbs.CreateCartesianSpringDamper(bodyNumbers=[ground, bodies[0]], stiffness=[70, 80, 90], damping=[1, 2, 3],
                                        localPosition1=[0.3, 0.1, 0.2]),
        mbs.CreateSpringDamper(bodyNumbers=bodies, stiffness=300, damping=5, localPosition1=[0, 0.2, 0.1]),
    ]  # fmt: skip
    mbs.Assemble()
    if node == exu.NodeType.RotationRxyz:
        mbs.systemData.SetODE2Coordinates(0.1 * np.arange(1.0, 13.0) % 0.7)
    total = np.zeros(mbs.systemData.ODE2Size())
    M = np.zeros((len(total), len(total)))
    for number in (*bodies, *springs):
        coordinates = ItemODE2Coordinates(mbs, number)
        total[coordinates] += mbs.ComputeItem(number, Type.ODE2LHS)
        for kind, velocities in ((Type.JacobianODE2, False), (Type.JacobianODE2_t, True)):
            found = mbs.ComputeItem(number, kind)
            expected = NumericalJacobian(
                mbs, lambda number=number: mbs.ComputeItem(number, Type.ODE2LHS), coordinates, velocities
            )
            scale = max(1.0, float(np.abs(expected).max()))
            np.testing.assert_allclose(found, expected, atol=1e-8 * scale)  # differences of 1e-6
        if number in bodies:
            M[np.ix_(coordinates, coordinates)] += mbs.ComputeItem(number, Type.MassMatrix)
    state = testing.State(mbs)
    state.a, state.lam = np.zeros_like(state.a), np.zeros_like(state.lam)
    np.testing.assert_allclose(total, -testing.forces(mbs, state), rtol=1e-12, atol=1e-10)
    np.testing.assert_allclose(M, testing.mass_matrix(mbs, state), rtol=1e-12, atol=1e-12)


def test_markers_on_bodies() -> None:
    mbs = exu.SystemContainer().AddSystem()
    body = mbs.CreateRigidBody(inertia=InertiaCuboid(1000, [1, 1, 1]), initialAngularVelocity=[0, 0, 2])
    marker = mbs.AddMarker(MarkerBodyRigid(bodyNumber=body, localPosition=[1, 0, 0]))
    mbs.Assemble()
    found = mbs.ComputeItem(marker, Type.Kinematics)
    np.testing.assert_allclose(found["velocity"], [0, 2, 0], atol=1e-12)
    velocities = np.array(mbs.systemData.GetODE2Coordinates_t())
    np.testing.assert_allclose(mbs.ComputeItem(marker, Type.PositionJacobian) @ velocities, [0, 2, 0], atol=1e-12)
