"""Newton's method: full and modified, its counts, and contributions of users to its matrix."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from oscillators import dynamic_settings, oscillator

import dalembert as exu
from dalembert.beams import GenerateStraightLineANCFCable2D
from dalembert.utilities import InertiaCuboid


def double_pendulum(modified: bool, tolerance: float, differences: str = "", **newton: Any) -> tuple[np.ndarray, Any]:
    mbs = exu.SystemContainer().AddSystem()
    previous = mbs.CreateGround()
    for i in range(2):
        body = mbs.CreateRigidBody(
            inertia=InertiaCuboid(1000, [1, 0.1, 0.1]), referencePosition=[i + 0.5, 0, 0], gravity=[0, 0, -9.81]
        )
        mbs.CreateRevoluteJoint(bodyNumbers=[previous, body], position=[i, 0, 0], axis=[0, 1, 0.2])
        previous = body
    mbs.Assemble()
    settings = dynamic_settings(0.5, 100, tolerance)
    settings.timeIntegration.newton.absoluteTolerance = 1e-9
    settings.timeIntegration.newton.useModifiedNewton = modified
    for name, value in newton.items():
        setattr(settings.timeIntegration.newton, name, value)
    if differences:
        setattr(settings.timeIntegration.newton.numericalDifferentiation, differences, True)
    mbs.SolveDynamic(settings)
    return mbs.systemData.GetODE2Coordinates(), mbs.sys["dynamicSolver"].it


def test_modified_newton_agrees_with_full_newton() -> None:
    full, counts = double_pendulum(False, 1e-11)
    modified, modified_counts = double_pendulum(True, 1e-11)
    np.testing.assert_allclose(modified, full, rtol=0, atol=1e-9)  # the tolerance times 100 steps
    assert counts.newtonJacobiCount == counts.newtonStepsCount
    assert 1 <= modified_counts.newtonJacobiCount < 0.5 * counts.newtonJacobiCount
    assert modified_counts.newtonStepsCount >= counts.newtonStepsCount


@pytest.mark.parametrize(("modified", "loads"), [(True, 0), (True, 1), (False, 0)])
def test_forces_of_the_moment_have_no_part_in_the_matrix_of_modified_newton(modified: bool, loads: int) -> None:
    """A rod on a hinge with a force at its end, by hand: beta h^2 times the tangent of residual and constraints."""
    mass, inertia, length, force, h = 2.0, 0.5, 1.5, 3.0, 0.01
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(exu.NodeRigidBody2D(referenceCoordinates=[0, 0, 0.4]))
    rod = mbs.AddObject(exu.RigidBody2D(physicsMass=mass, physicsInertia=inertia, nodeNumber=node))
    ends = [mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=rod, localPosition=[x, 0, 0])) for x in (-length, length)]
    ground = exu.ObjectGround(referencePosition=[-length * np.cos(0.4), -length * np.sin(0.4), 0])
    hinge = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=mbs.AddObject(ground)))
    mbs.AddObject(exu.RevoluteJoint2D(markerNumbers=[hinge, ends[0]]))
    mbs.AddLoad(exu.Force(markerNumber=ends[1], loadVector=[0, -force, 0]))
    mbs.Assemble()
    settings = dynamic_settings(10 * h, 10, tolerance=1e-8)
    settings.timeIntegration.newton.useModifiedNewton = modified
    settings.timeIntegration.computeLoadsJacobian = loads
    solver = exu.MainSolverImplicitSecondOrder()
    solver.InitializeSolver(mbs, settings)
    solver.it.currentStepSize = h
    reaction = np.array([5.0, 7.0])
    mbs.systemData.SetAECoordinates(reaction)
    solver.ComputeNewtonResidual(mbs, settings)
    solver.ComputeNewtonJacobian(mbs, settings)
    beta, rotation = solver.newmarkBeta, np.array([np.cos(0.4), np.sin(0.4)])
    alpha_m, alpha_f = solver.alphaM, solver.alphaF
    stiffness = length * force * -rotation[1] if loads or not modified else 0.0  # of the force at the end
    if not modified:
        stiffness += length * reaction @ rotation  # of the reaction at the hinge
    acceleration = (1 - alpha_m) / (1 - alpha_f)  # times beta h^2
    np.testing.assert_allclose(solver.factJacAlgorithmic * acceleration, 1, rtol=1e-15)
    expected = acceleration * np.diag([mass, mass, inertia]) + beta * h**2 * np.diag([0, 0, stiffness])
    np.testing.assert_allclose(solver.GetSystemJacobian()[:3, :3], expected, rtol=0, atol=1e-12)


def test_full_newton_converges_quadratically() -> None:
    """Exact tangents: three iterations a step are plenty."""
    assert double_pendulum(False, 1e-8)[1].newtonStepsCount <= 3 * 100


def test_a_jacobian_in_every_step() -> None:
    counts = double_pendulum(True, 1e-8, modifiedNewtonJacUpdatePerStep=True)[1]
    assert counts.newtonJacobiCount >= 100
    assert counts.newtonJacobiCount < counts.newtonStepsCount


@pytest.mark.parametrize("differences", ["forAE", "forODE2", "doSystemWideDifferentiation"])
def test_differences_agree_with_exact_derivatives(differences: str) -> None:
    """Jacobians differ by 1e-6 or less: a step that converges quadratically takes no further iteration."""
    exact, counts = double_pendulum(False, 1e-11)
    found, other_counts = double_pendulum(False, 1e-11, differences)
    np.testing.assert_allclose(found, exact, rtol=0, atol=1e-9)  # the tolerance times 100 steps
    assert counts.newtonStepsCount <= other_counts.newtonStepsCount <= counts.newtonStepsCount + 10


def test_groups_of_columns_change_no_bit() -> None:
    """A cable: with a function, dependencies are unknown, and each column is moved by itself."""

    def tip(with_function: bool) -> np.ndarray:
        mbs = exu.SystemContainer().AddSystem()
        cable = exu.Cable2D(
            physicsMassPerLength=1, physicsBendingStiffness=10, physicsAxialStiffness=1e4, physicsBendingDamping=0.1
        )
        made = GenerateStraightLineANCFCable2D(
            mbs, [0, 0, 0], [2, 0, 0], 6, cable, [0, -9.81, 0], fixedConstraintsNode0=[1, 1, 0, 1]
        )
        marker = mbs.AddMarker(exu.MarkerNodePosition(nodeNumber=made[0][-1]))
        force: dict[str, Any] = {"loadVectorUserFunction": lambda mbs, t, load: load} if with_function else {}
        mbs.AddLoad(exu.Force(markerNumber=marker, loadVector=[1, 2, 0], **force))
        mbs.Assemble()
        settings = dynamic_settings(0.1, 20, tolerance=1e-8)
        settings.timeIntegration.newton.numericalDifferentiation.doSystemWideDifferentiation = True
        mbs.SolveDynamic(settings)
        return np.asarray(mbs.systemData.GetODE2Coordinates())

    np.testing.assert_array_equal(tip(False), tip(True))


def test_linear_systems_need_one_iteration() -> None:
    model = oscillator()
    model.mbs.SolveDynamic(dynamic_settings(1.0, 50, tolerance=1e-8))
    it = model.mbs.sys["dynamicSolver"].it
    assert (it.newtonStepsCount, it.newtonJacobiCount) == (50, 50)


def test_linear_systems_need_one_matrix() -> None:
    model = oscillator()
    settings = dynamic_settings(1.0, 50, tolerance=1e-8)
    settings.timeIntegration.newton.useModifiedNewton = True
    model.mbs.SolveDynamic(settings)
    it = model.mbs.sys["dynamicSolver"].it
    assert (it.newtonStepsCount, it.newtonJacobiCount) == (50, 1)


# ---- entries of users in the matrix --------------------------------------------------------------------------------------
def spring_of_a_load(entry: list[float], rows: int = 1, steps: int = 50) -> Any:
    """A load that acts as a spring, with its stiffness in the system's Jacobian function."""
    model = oscillator(stiffness=0.0, damping=0.0)
    model.mbs.AddLoad(
        exu.itemInterface.LoadCoordinate(
            markerNumber=model.marker,
            load=0.0,
            loadUserFunction=lambda mbs, t, load: (
                -80.0 * mbs.GetNodeOutput(model.node, exu.OutputVariableType.Coordinates)
            ),
        )
    )
    model.mbs.Assemble()

    def jacobian(mbs: Any, t: float, q: float, v: float, y: float) -> Any:
        container = exu.MatrixContainer()
        container.SetWithSparseMatrix([[entry[0], entry[1], -80.0 * q]], rows, rows)
        return container

    model.mbs.SetSystemJacobianUserFunction(jacobian)
    settings = dynamic_settings(1.0, steps, tolerance=1e-10)
    settings.timeIntegration.generalizedAlpha.computeInitialAccelerations = False
    model.mbs.SolveDynamic(settings)
    return model


def test_entries_of_users_keep_convergence() -> None:
    model = spring_of_a_load([0, 0])
    assert model.mbs.sys["dynamicSolver"].it.newtonStepsCount == 50  # as many as with a spring
    plain = oscillator(damping=0.0)
    settings = dynamic_settings(1.0, 50, tolerance=1e-10)
    settings.timeIntegration.generalizedAlpha.computeInitialAccelerations = False
    plain.mbs.SolveDynamic(settings)
    assert model.position == pytest.approx(plain.position, abs=1e-12)


def test_entries_of_users_outside_the_system_are_refused() -> None:
    with pytest.raises(IndexError, match="entry in row 3, column 0; expected indices below 1"):
        spring_of_a_load([3, 0], rows=4)


def swinging_rod(steps: int, tolerance: float | None) -> np.ndarray:
    """Coordinates after 1/8 s; the initial tolerances of settings, unless one is given."""
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(exu.NodeRigidBody2D(referenceCoordinates=[0.5, 0, 0]))
    rod = mbs.AddObject(exu.RigidBody2D(physicsMass=1, physicsInertia=0.1, nodeNumber=node))
    hinge = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=mbs.AddObject(exu.ObjectGround())))
    end = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=rod, localPosition=[-0.5, 0, 0]))
    mbs.AddObject(exu.RevoluteJoint2D(markerNumbers=[hinge, end]))
    weight = mbs.AddMarker(exu.MarkerBodyMass(bodyNumber=rod))
    mbs.AddLoad(exu.LoadMassProportional(markerNumber=weight, loadVector=[0, -9.81, 0]))
    mbs.Assemble()
    settings = dynamic_settings(0.125, steps, tolerance or 1e-8)
    settings.timeIntegration.newton = exu.SimulationSettings().timeIntegration.newton
    if tolerance is not None:
        settings.timeIntegration.newton.relativeTolerance = settings.timeIntegration.newton.absoluteTolerance = (
            tolerance
        )
    mbs.SolveDynamic(settings)
    return mbs.systemData.GetODE2Coordinates()


def test_finer_steps_come_nearer_at_default_tolerances() -> None:
    """The error of Newton's method is below a hundredth of the error of the step, which decreases with its square.
    It would be a third with 1000 steps and more without the correction at the end of fine steps, where one iteration
    meets the tolerance."""
    for steps in (500, 1000, 2000):
        precise, finer = (swinging_rod(n, 1e-13) for n in (steps, 2 * steps))
        error = 4 / 3 * np.linalg.norm(precise - finer)
        left = np.linalg.norm(swinging_rod(steps, None) - precise)
        assert left < 0.01 * error, steps


def chain(count: int, differences: str = "") -> tuple[np.ndarray, float, Any]:
    """Masses in a row with springs of the user between them; coordinates, calls per spring, and counts of the solver."""
    calls = 0

    def force(mbs: Any, t: float, item: int, u: float, v: float, k: float, d: float, offset: float) -> float:
        nonlocal calls
        calls += 1
        return k * u + 10 * k * u**3 + d * v

    mbs = exu.SystemContainer().AddSystem()
    before = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(exu.NodePointGround()), coordinate=0))
    for i in range(count):
        node = mbs.AddNode(exu.Node1D(referenceCoordinates=[0], initialVelocities=[0.1 * (i % 3)]))
        mbs.AddObject(exu.Mass1D(physicsMass=1 + 0.1 * i, nodeNumber=node))
        marker = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
        mbs.AddObject(
            exu.CoordinateSpringDamper(
                markerNumbers=[before, marker], stiffness=100, damping=0.5, springForceUserFunction=force
            )
        )
        before = marker
    mbs.Assemble()
    settings = dynamic_settings(0.05, 10, 1e-10)
    if differences:
        setattr(settings.timeIntegration.newton.numericalDifferentiation, differences, True)
    settings.linearSolverType = exu.LinearSolverType.EigenSparse
    mbs.SolveDynamic(settings)
    return mbs.systemData.GetODE2Coordinates(), calls / count, mbs.sys["dynamicSolver"].it


def test_columns_that_share_no_row_are_differentiated_together() -> None:
    short, long = chain(9, "forODE2"), chain(36, "forODE2")
    # Three groups of columns, for any length of the chain: two residuals each.
    assert long[1] / long[2].newtonJacobiCount == pytest.approx(short[1] / short[2].newtonJacobiCount, rel=0.1)
    for count, found in ((9, short), (36, long)):
        expected = chain(count)
        assert found[2].newtonStepsCount == expected[2].newtonStepsCount
        np.testing.assert_allclose(found[0], expected[0], rtol=0, atol=1e-10)  # the tolerance of Newton's method


def test_differences_of_constraints_call_no_forces() -> None:
    """A chain without constraints has no entries of the matrix that `forAE` selects."""
    assert chain(9, "forAE")[1] == chain(9)[1]
