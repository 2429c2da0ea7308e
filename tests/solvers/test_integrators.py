"""Order of convergence, energy and drift of every integrator, against solutions in closed form."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from oscillators import MASS, SPEED, START, STIFFNESS, Variable, dynamic_settings, exact_oscillation, oscillator
from scipy.special import ellipk

import dalembert as exu
from dalembert.itemInterface import (
    Force,
    MarkerNodePosition,
    MassPoint,
    NodeGenericODE1,
    NodePoint,
    NodePointGround,
    ObjectConnectorDistance,
    ObjectGenericODE1,
)
from dalembert.utilities import InertiaCuboid

NodeType = exu.NodeType
Solver = exu.DynamicSolverType

# Solver, its order, and the number of steps at which the error is far above round-off and below the range where terms of
# higher order count.
ORDERS = [
    (Solver.GeneralizedAlpha, 2, 200),
    (Solver.TrapezoidalIndex2, 2, 200),
    (Solver.ExplicitEuler, 1, 4000),
    (Solver.ExplicitMidpoint, 2, 200),
    (Solver.VelocityVerlet, 2, 200),
    (Solver.RK33, 3, 100),
    (Solver.ODE23, 3, 100),
    (Solver.RK44, 4, 50),
    (Solver.DOPRI5, 5, 50),
    (Solver.RK67, 6, 25),
    (Solver.DOP853, 8, 3),
]


def error_of(solver: Any, steps: int, damping: float, **options: Any) -> float:
    model = oscillator(damping=damping)
    settings = dynamic_settings(1.0, steps)
    settings.timeIntegration.absoluteTolerance = 1e6  # methods with error control keep to the largest step
    for name, value in options.items():
        setattr(settings.timeIntegration.generalizedAlpha, name, value)
    model.mbs.SolveDynamic(settings, solverType=solver)
    position, speed = exact_oscillation(1.0, damping)
    frequency = np.sqrt(STIFFNESS / MASS)
    return float(np.hypot(model.position - position, (model.speed - speed) / frequency))


@pytest.mark.parametrize("solver", [row[0] for row in ORDERS], ids=[str(row[0]).split(".")[1] for row in ORDERS])
def test_views_of_coordinates_follow(solver: Any) -> None:
    model = oscillator(damping=1.5)
    model.mbs.Assemble()
    data = model.mbs.systemData
    readers = [data.GetODE2Coordinates, data.GetODE2Coordinates_t, data.GetODE2Coordinates_tt]
    views = [read(copy=False) for read in readers]
    model.mbs.SolveDynamic(dynamic_settings(0.1, 3), solverType=solver)
    assert [view.tolist() for view in views] == [read().tolist() for read in readers]


@pytest.mark.parametrize("solver", [Solver.RK44, Solver.DOPRI5, Solver.GeneralizedAlpha])
def test_views_follow_where_joints_are_kept(solver: Any) -> None:
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    mass = mbs.CreateMassPoint(referencePosition=[1, 0, 0], physicsMass=1, gravity=[0, -9.81, 0])
    mbs.CreateDistanceConstraint(bodyNumbers=[ground, mass])
    mbs.Assemble()
    readers = (mbs.systemData.GetODE2Coordinates, mbs.systemData.GetODE2Coordinates_t)
    views = [read(copy=False) for read in readers]
    mbs.SolveDynamic(dynamic_settings(0.1, 10), solverType=solver)
    assert [view.tolist() for view in views] == [read().tolist() for read in readers]
    assert views[0][1] == pytest.approx(-0.049, rel=0.01)  # falls by g t^2 / 2 at first


@pytest.mark.parametrize(("solver", "order", "steps"), ORDERS, ids=[str(row[0]).split(".")[1] for row in ORDERS])
def test_order_of_convergence(solver: Any, order: int, steps: int) -> None:
    # The leap-frog method takes velocities of half steps into damping forces, which costs it an order: no damping there.
    damping = 0.0 if solver == Solver.VelocityVerlet else 1.5
    coarse, fine = (error_of(solver, n, damping) for n in (steps, 2 * steps))
    assert fine > 1e-13  # else round-off is measured
    # Halving the step divides the error by 2^order, up to the next term of the expansion: a few percent.
    assert np.log2(coarse / fine) == pytest.approx(order, abs=0.25)


@pytest.mark.parametrize("radius", [0.0, 0.5, 0.9, 1.0])
def test_generalized_alpha_is_of_second_order_for_every_spectral_radius(radius: float) -> None:
    coarse, fine = (error_of(Solver.GeneralizedAlpha, n, 1.5, spectralRadius=radius) for n in (400, 800))
    assert np.log2(coarse / fine) == pytest.approx(2, abs=0.1)


def test_newmark_with_numerical_damping_is_of_first_order() -> None:
    options = {"useNewmark": True, "newmarkGamma": 0.6, "newmarkBeta": 0.3025}
    coarse, fine = (error_of(Solver.GeneralizedAlpha, n, 1.5, **options) for n in (2000, 4000))
    assert np.log2(coarse / fine) == pytest.approx(1, abs=0.1)


@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.ExplicitEuler, Solver.RK44, Solver.DOPRI5])
def test_first_order_equations(solver: Any) -> None:
    """y' = A y, exact by the exponential; implicit solvers use the trapezoidal rule, from the rates of the start."""
    order = {Solver.GeneralizedAlpha: 2, Solver.ExplicitEuler: 1, Solver.RK44: 4, Solver.DOPRI5: 5}[solver]
    errors = []
    for steps in (100, 200):
        mbs = exu.SystemContainer().AddSystem()
        node = mbs.AddNode(
            NodeGenericODE1(referenceCoordinates=[0, 0], initialCoordinates=[1, 0], numberOfODE1Coordinates=2)
        )
        mbs.AddObject(ObjectGenericODE1(nodeNumbers=[node], systemMatrix=[[-1, 4], [-4, -1]]))
        mbs.Assemble()
        settings = dynamic_settings(1.0, steps)
        settings.timeIntegration.absoluteTolerance = 1e6  # fixed steps with error control too
        mbs.SolveDynamic(settings, solverType=solver)
        exact = np.exp(-1) * np.array([np.cos(4), -np.sin(4)])
        errors.append(np.linalg.norm(mbs.systemData.GetODE1Coordinates() - exact))
    assert np.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.25)


def energy(model: Any) -> float:
    return 0.5 * MASS * model.speed**2 + 0.5 * STIFFNESS * model.position**2


START_ENERGY = 0.5 * MASS * SPEED**2 + 0.5 * STIFFNESS * START**2


@pytest.mark.parametrize(
    ("solver", "low", "high"),
    [
        (Solver.TrapezoidalIndex2, -1e-11, 1e-11),  # keeps the energy of linear systems; 1000 steps of round-off
        (Solver.VelocityVerlet, -0.01, 0.01),  # swings by (omega h)^2 / 4 = 0.01, at all times
        (Solver.ExplicitEuler, 1e3, np.inf),  # grows by 1 + (omega h)^2 per step
        (Solver.RK44, -1e-2, -1e-4),  # loses (omega h)^6 / 72 per step: 1e-3 in 1000 steps
    ],
)
def test_energy_of_an_undamped_oscillator(solver: Any, low: float, high: float) -> None:
    model = oscillator(damping=0)
    h = 0.2 / np.sqrt(STIFFNESS / MASS)
    model.mbs.SolveDynamic(dynamic_settings(1000 * h, 1000), solverType=solver)
    assert low < energy(model) / START_ENERGY - 1 < high


def test_generalized_alpha_damps_fast_oscillations_only() -> None:
    ratios = []
    for steps_per_period in (0.05, 500):
        model = oscillator(damping=0)
        period = 2 * np.pi / np.sqrt(STIFFNESS / MASS)
        settings = dynamic_settings(100 * period / steps_per_period, 100)
        settings.timeIntegration.generalizedAlpha.spectralRadius = 0.6
        model.mbs.SolveDynamic(settings)
        ratios.append(energy(model) / START_ENERGY)
    # 0.6^100 = 7e-23 for the amplitude, with a factor that grows linearly; the slow one loses of the order (omega h)^3.
    assert 0 < ratios[0] < 1e-30
    assert ratios[1] == pytest.approx(1, abs=1e-4)


# ---- a constrained system: the pendulum ----------------------------------------------------------------------------------
LENGTH, GRAVITY, AMPLITUDE = 0.8, 9.81, 1.2


def pendulum(settings: Any, **solver: Any) -> tuple[np.ndarray, np.ndarray]:
    """Let a point mass swing down from AMPLITUDE at the end of a rod; positions and velocities at the end."""
    mbs = exu.SystemContainer().AddSystem()
    start = LENGTH * np.array([np.sin(AMPLITUDE), -np.cos(AMPLITUDE), 0])
    node = mbs.AddNode(NodePoint(referenceCoordinates=start))
    mbs.AddObject(MassPoint(nodeNumber=node, physicsMass=3))
    pivot = mbs.AddMarker(MarkerNodePosition(nodeNumber=mbs.AddNode(NodePointGround())))
    marker = mbs.AddMarker(MarkerNodePosition(nodeNumber=node))
    mbs.AddObject(ObjectConnectorDistance(name="rod", markerNumbers=[pivot, marker], distance=LENGTH))
    mbs.AddLoad(Force(markerNumber=marker, loadVector=[0, -3 * GRAVITY, 0]))
    mbs.Assemble()
    mbs.SolveDynamic(settings, **solver)
    return mbs.GetNodeOutput(node, Variable.Position), mbs.GetNodeOutput(node, Variable.Velocity)


QUARTER = ellipk(np.sin(AMPLITUDE / 2) ** 2) * np.sqrt(LENGTH / GRAVITY)  # time until it hangs straight


@pytest.mark.parametrize("index2", [False, True])
def test_pendulum(index2: bool) -> None:
    angles, lengths, rates = [], [], []
    for steps in (200, 400):
        settings = dynamic_settings(QUARTER, steps, tolerance=1e-11)
        settings.timeIntegration.generalizedAlpha.useNewmark = index2
        settings.timeIntegration.generalizedAlpha.useIndex2Constraints = index2
        position, velocity = pendulum(settings)
        angles.append(abs(np.arctan2(position[0], -position[1])))
        lengths.append(abs(np.linalg.norm(position) - LENGTH))
        rates.append(abs(position @ velocity))
    assert np.log2(angles[0] / angles[1]) == pytest.approx(2, abs=0.2)
    if index2:  # velocities fit the constraint up to the tolerance; positions drift, with the order of the method
        assert max(rates) < 1e-9
        assert lengths[0] > 1e-8
        assert np.log2(lengths[0] / lengths[1]) == pytest.approx(2, abs=0.2)
    else:  # the other way round
        assert max(lengths) < 1e-9
        assert rates[0] > 1e-10


def test_long_swing_keeps_length_and_energy() -> None:
    """20 quarters with index 3 and little numerical damping."""
    settings = dynamic_settings(20 * QUARTER, 8000, tolerance=1e-11)
    settings.timeIntegration.generalizedAlpha.spectralRadius = 0.95
    position, velocity = pendulum(settings)
    lost = 0.5 * velocity @ velocity + GRAVITY * (position[1] + LENGTH * np.cos(AMPLITUDE))
    assert np.linalg.norm(position) == pytest.approx(LENGTH, abs=1e-9)
    assert abs(lost) < 1e-4 * GRAVITY * LENGTH  # of the order (omega h)^2 = 1e-5


# ---- rotations -----------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.RK44])
def test_rotation_vectors_pass_pi_steadily(solver: Any) -> None:
    """A spin about a fixed axis: the rotation vector is the angle, below a full turn."""
    mbs = exu.SystemContainer().AddSystem()
    spin = np.array([0.0, 0.0, 5.0])
    mbs.CreateRigidBody(
        inertia=InertiaCuboid(1000, [1, 0.2, 0.1]),
        initialAngularVelocity=spin,
        nodeType=NodeType.RotationRotationVector,
    )
    mbs.Assemble()
    mbs.SolveDynamic(dynamic_settings(1.0, 100), solverType=solver)
    # 100 compositions, each with a few rounding errors.
    np.testing.assert_allclose(mbs.systemData.GetODE2Coordinates()[3:], spin, rtol=0, atol=1e-11)


@pytest.mark.parametrize("node_type", ["RotationEulerParameters", "RotationRxyz", "RotationRotationVector"])
def test_free_symmetric_top(node_type: str) -> None:
    """The angular velocity of a symmetric top turns about its axis at the rate (J3 - J1) / J1 omega3."""
    mbs = exu.SystemContainer().AddSystem()
    inertia = InertiaCuboid(1000, [0.2, 0.2, 0.05])
    j1, j3 = inertia.inertiaTensor[0, 0], inertia.inertiaTensor[2, 2]
    body = mbs.CreateRigidBody(
        inertia=inertia, initialAngularVelocity=[0.4, 0, 3], nodeType=getattr(NodeType, node_type)
    )
    mbs.Assemble()
    mbs.SolveDynamic(dynamic_settings(1.0, 2000, tolerance=1e-10))
    angle = (j3 - j1) / j1 * 3
    exact = [0.4 * np.cos(angle), 0.4 * np.sin(angle), 3]
    # Second order: (omega h)^2 / 12 of the turning part is 1e-7.
    np.testing.assert_allclose(mbs.GetObjectOutputBody(body, Variable.AngularVelocityLocal), exact, rtol=0, atol=2e-6)


@pytest.mark.parametrize("solver", [Solver.ODE23, Solver.DOPRI5, Solver.DOP853])
def test_automatic_steps_follow_the_tolerance(solver: Any) -> None:
    errors, counts = [], []
    for tolerance in (1e-5, 1e-7, 1e-9):
        model = oscillator()
        settings = dynamic_settings(1.0, 1)
        integration = settings.timeIntegration
        integration.automaticStepSize, integration.initialStepSize = True, 1e-3
        integration.absoluteTolerance = integration.relativeTolerance = tolerance
        model.mbs.SolveDynamic(settings, solverType=solver)
        errors.append(abs(model.position - exact_oscillation(1.0)[0]) / tolerance)
        counts.append(model.mbs.sys["dynamicSolver"].it.currentStepIndex)
    assert max(errors) < 100  # the error of single steps adds up
    assert max(errors) > 1e-3  # no steps are wasted
    assert counts[0] < counts[1] < counts[2]


def test_euler_parameters_with_velocity_level_constraints_converge() -> None:
    """A body on a ball joint, whose Euler parameters drift off unit length, against Tait-Bryan angles."""
    ends = {}
    for node_type in ("RotationEulerParameters", "RotationRxyz"):
        for steps in (200, 400):
            mbs = exu.SystemContainer().AddSystem()
            ground = mbs.CreateGround()
            body = mbs.CreateRigidBody(
                inertia=InertiaCuboid(1000, [1, 0.1, 0.2]),
                referencePosition=[0.5, 0, 0],
                initialVelocity=[0, 1.5, 0],
                initialAngularVelocity=[0, 0, 3],
                gravity=[0, 0, -9.81],
                nodeType=getattr(NodeType, node_type),
            )
            mbs.CreateSphericalJoint(bodyNumbers=[ground, body], position=[0, 0, 0])
            mbs.Assemble()
            mbs.SolveDynamic(dynamic_settings(0.5, steps, tolerance=1e-11), solverType=Solver.TrapezoidalIndex2)
            ends[node_type, steps] = mbs.GetObjectOutputBody(body, Variable.Position)
    coarse, fine = (np.linalg.norm(ends["RotationEulerParameters", n] - ends["RotationRxyz", n]) for n in (200, 400))
    assert coarse > 1e-9  # different unknowns, different errors
    assert np.log2(coarse / fine) == pytest.approx(2, abs=0.3)  # the differences vanish with the order of the method
