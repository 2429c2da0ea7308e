"""SolveStatic, SolveDynamic and the linearized system, on models with known answers."""

import numpy as np
import pytest

import dalembert as exu
from dalembert import itemInterface as items
from dalembert import solver
from dalembert.rigidBodyUtilities import InertiaCuboid

MASS, STIFFNESS, DAMPING, FORCE = 2.0, 800.0, 4.0, 10.0


def quiet_settings(endTime=1.0, steps=200):
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime = endTime
    settings.timeIntegration.numberOfSteps = steps
    settings.solutionSettings.writeSolutionToFile = False
    return settings


@pytest.fixture
def oscillator():
    """A mass that moves along x between spring and damper, with a constant force."""
    container = exu.SystemContainer()
    mbs = container.AddSystem()
    ground = mbs.CreateGround()
    mass = mbs.CreateMassPoint(physicsMass=MASS)
    mbs.CreateCartesianSpringDamper(
        bodyNumbers=[ground, mass], stiffness=[STIFFNESS, STIFFNESS, STIFFNESS], damping=[DAMPING, 0, 0]
    )
    mbs.CreateForce(bodyNumber=mass, loadVector=[FORCE, 0, 0])
    mbs.Assemble()
    yield mbs, mass


def displacement(mbs, body):
    return mbs.GetObjectOutputBody(body, exu.OutputVariableType.Displacement, [0, 0, 0])


def chain(number):
    """Return masses in a row with springs between them, each of 1 kg and 100 N/m, along x."""
    container = exu.SystemContainer()
    mbs = container.AddSystem()
    last = mbs.CreateGround()
    for i in range(number):
        mass = mbs.CreateMassPoint(referencePosition=[i + 1, 0, 0], physicsMass=1)
        mbs.CreateCartesianSpringDamper(bodyNumbers=[last, mass], stiffness=[100, 200, 300], offset=[1, 0, 0])
        last = mass
    mbs.Assemble()
    return container, mbs


def pendulum():
    """Return a bar on a hinge about z at the origin."""
    container = exu.SystemContainer()
    mbs = container.AddSystem()
    ground = mbs.CreateGround()
    bar = mbs.CreateRigidBody(referencePosition=[0.5, 0, 0], inertia=InertiaCuboid(1000, [1, 0.1, 0.2]))
    mbs.CreateRevoluteJoint(bodyNumbers=[ground, bar], position=[0, 0, 0], axis=[0, 0, 1])
    mbs.CreateCartesianSpringDamper(
        bodyNumbers=[ground, bar], localPosition0=[1, 0, 0], localPosition1=[0.5, 0, 0], stiffness=[0, 50, 0]
    )
    mbs.Assemble()
    return container, mbs


def test_static_equilibrium(oscillator):
    mbs, mass = oscillator
    assert mbs.SolveStatic(quiet_settings()) is True
    assert displacement(mbs, mass)[0] == pytest.approx(FORCE / STIFFNESS, rel=1e-10)
    assert mbs.sys["staticSolver"].GetSolverName()
    assert exu.SolverSuccess(mbs.sys["staticSolver"])[0]


@pytest.mark.parametrize(
    "kind", ["GeneralizedAlpha", "TrapezoidalIndex2", "ExplicitMidpoint", "RK33", "RK44", "RK67", "DOPRI5"]
)
def test_damped_oscillation(oscillator, kind):
    mbs, mass = oscillator
    settings = quiet_settings(0.5, 4000)
    before = settings.timeIntegration.generalizedAlpha.useNewmark
    assert mbs.SolveDynamic(settings, solverType=getattr(exu.DynamicSolverType, kind)) is True
    omega, decay = np.sqrt(STIFFNESS / MASS), DAMPING / (2 * MASS)
    damped = np.sqrt(omega**2 - decay**2)
    t = 0.5
    free = np.exp(-decay * t) * (np.cos(damped * t) + decay / damped * np.sin(damped * t))
    assert displacement(mbs, mass)[0] == pytest.approx(FORCE / STIFFNESS * (1 - free), rel=1e-4)
    assert settings.timeIntegration.generalizedAlpha.useNewmark == before


def test_solver_is_kept_on_request_only(oscillator):
    mbs, _ = oscillator
    settings = quiet_settings(0.01, 10)
    mbs.SolveDynamic(settings, storeSolver=False)
    assert "dynamicSolver" not in mbs.sys
    mbs.SolveDynamic(settings)
    assert mbs.sys["dynamicSolver"].GetODE2size() == 3 and "simulationSettings" in mbs.sys


def test_results_become_initial_values_on_request(oscillator):
    mbs, mass = oscillator
    settings = quiet_settings(0.1, 100)
    mbs.SolveDynamic(settings, updateInitialValues=True)
    first = displacement(mbs, mass)[0]
    settings.timeIntegration.startTime, settings.timeIntegration.endTime = 0.1, 0.2
    mbs.SolveDynamic(settings)
    assert displacement(mbs, mass)[0] != pytest.approx(first, rel=1e-3)
    initial = mbs.GetObjectOutputBody(
        mass, exu.OutputVariableType.Displacement, [0, 0, 0], exu.ConfigurationType.Initial
    )
    assert initial[0] == pytest.approx(first, rel=1e-14)


def test_systems_are_assembled_if_needed(oscillator):
    mbs, _ = oscillator
    mbs.CreateMassPoint(physicsMass=1)
    assert not mbs.systemIsConsistent
    mbs.SolveDynamic(quiet_settings(0.01, 10))
    assert mbs.systemIsConsistent


def test_unknown_solver_type_is_refused(oscillator):
    with pytest.raises(ValueError, match="solverType.*GeneralizedAlpha"):
        oscillator[0].SolveDynamic(quiet_settings(), solverType=17)


def test_failure_carries_the_diagnosis(oscillator):
    mbs, _ = oscillator
    mbs.AddNode(items.NodePoint())  # a node without mass
    mbs.Assemble()
    with pytest.raises(ValueError, match="SolveStatic terminated") as caught:
        mbs.SolveStatic(quiet_settings())
    error = caught.value
    assert isinstance(error, solver.SolverError)
    assert error.solver is mbs.sys["staticSolver"]
    assert "static solver failed" in error.diagnosis and "singular" in error.diagnosis
    assert "node 1" in error.diagnosis and "what to try" in error.diagnosis
    brief = solver.SolverErrorMessage(error.solver, mbs, True, False, False, showHints=False)
    assert "node 1" not in brief and "showHints=True" in brief


def test_errors_of_user_functions_surface_as_themselves(oscillator):
    mbs, mass = oscillator

    def load(mbs, t, vector):
        raise KeyError("no such table")

    mbs.CreateForce(bodyNumber=mass, loadVectorUserFunction=load)
    mbs.Assemble()
    with pytest.raises(KeyError, match="no such table") as caught:
        mbs.SolveDynamic(quiet_settings(0.01, 10))
    assert any("SolveDynamic" in note for note in caught.value.__notes__)


def test_linearized_matrices(oscillator):
    M, K, D = oscillator[0].ComputeLinearizedSystem()
    assert np.allclose(M, MASS * np.eye(3), rtol=1e-12)
    assert np.allclose(K, STIFFNESS * np.eye(3), rtol=1e-6)
    assert np.allclose(D, np.diag([DAMPING, 0, 0]), rtol=1e-6, atol=1e-6)


def test_constraints_are_projected_out():
    _container, mbs = pendulum()
    M, K, D, C, N = mbs.ComputeLinearizedSystem(
        projectIntoConstraintNullspace=True, returnConstraintJacobian=True, returnConstraintNullspace=True
    )
    assert M.shape == K.shape == D.shape == (1, 1)
    assert C.shape == (7, 6) and N.shape == (1, 7)
    assert np.allclose(N @ C, 0, atol=1e-12) and np.allclose(N @ N.T, 1)
    assert mbs.ComputeLinearizedSystem(projectIntoConstraintNullspace=True)[3:] == [[], []]


def test_settings_are_restored_even_after_an_error():
    _container, mbs = pendulum()
    settings = exu.SimulationSettings()
    settings.staticSolver.verboseMode = 2
    mbs.ComputeSystemDegreeOfFreedom(settings)
    assert settings.staticSolver.verboseMode == 2 and settings.solutionSettings.writeSolutionToFile


def test_eigenvalues_of_a_chain():
    _container, mbs = chain(4)
    rows = np.arange(4)
    exact = 400 * np.sin((2 * rows + 1) * np.pi / 18) ** 2  # along x; y and z: 2 and 3 times as much
    values, vectors = mbs.ComputeODE2Eigenvalues()
    assert np.allclose(values, np.sort(np.concatenate([exact, 2 * exact, 3 * exact])), rtol=1e-7)
    assert vectors.shape == (12, 12)
    frequencies, vectors = mbs.ComputeODE2Eigenvalues(convert2Frequencies=True, numberOfEigenvalues=2)
    assert frequencies[0] == pytest.approx(np.sqrt(exact[0]) / (2 * np.pi)) and vectors.shape == (12, 2)
    sparse, _ = mbs.ComputeODE2Eigenvalues(useSparseSolver=True, numberOfEigenvalues=3)
    assert np.allclose(sparse, values[:3], rtol=1e-7)


def test_held_coordinates_do_not_move():
    _container, mbs = chain(4)
    values, vectors = mbs.ComputeODE2Eigenvalues(constrainedCoordinates=[0, 1, 2])
    assert len(values) == 9 and vectors.shape == (12, 9)
    assert not vectors[:3].any()
    with pytest.raises(ValueError, match="constrainedCoordinates"):
        mbs.ComputeODE2Eigenvalues(constrainedCoordinates=[12])


def test_complex_eigenvalues(oscillator):
    values, vectors = oscillator[0].ComputeODE2Eigenvalues(computeComplexEigenvalues=True, useAbsoluteValues=False)
    decay = DAMPING / (2 * MASS)
    expected = -decay + 1j * np.sqrt(STIFFNESS / MASS - decay**2)
    assert np.min(np.abs(values - expected)) < 1e-5 * abs(expected)
    assert vectors.shape == (6, 6)
    assert np.allclose(vectors[3:], vectors[:3] * values, atol=1e-6)


def test_eigenvalue_with_a_hinge():
    _container, mbs = pendulum()
    values, vectors = mbs.ComputeODE2Eigenvalues()
    inertia = InertiaCuboid(1000, [1, 0.1, 0.2]).Translated([0.5, 0, 0]).InertiaCOM()
    bar = InertiaCuboid(1000, [1, 0.1, 0.2])
    about_hinge = inertia[2, 2] + bar.mass * 0.25
    assert values[0] == pytest.approx(50 / about_hinge, rel=1e-6)
    assert vectors.shape == (7, 1)
    with pytest.raises(ValueError, match="useSparseSolver"):
        mbs.ComputeODE2Eigenvalues(useSparseSolver=True)


def test_massless_coordinates_are_named():
    container = exu.SystemContainer()
    mbs = container.AddSystem()
    mbs.CreateMassPoint(physicsMass=1)
    mbs.CreateMassPoint(physicsMass=0)
    mbs.Assemble()
    with pytest.raises(ValueError, match=r"mass matrix.*\[3, 4, 5\]"):
        mbs.ComputeODE2Eigenvalues()


@pytest.mark.parametrize("useSVD", [False, True])
def test_degrees_of_freedom_and_redundancy(useSVD):
    _container, mbs = pendulum()
    counted = mbs.ComputeSystemDegreeOfFreedom(useSVD=useSVD)
    assert counted["degreeOfFreedom"] == 1 and counted["redundantConstraints"] == 0
    mbs.CreateRevoluteJoint(bodyNumbers=[exu.ObjectIndex(0), exu.ObjectIndex(1)], position=[0, 0, 1], axis=[0, 0, 1])
    mbs.Assemble()
    counted = mbs.ComputeSystemDegreeOfFreedom(useSVD=useSVD, verbose=True)
    assert counted["degreeOfFreedom"] == 1 and counted["redundantConstraints"] == 5


def test_allocations_are_reported(monkeypatch, capfd):
    monkeypatch.setattr("dalembert._solving.diagnosis._ALLOCATION_THRESHOLD", 10)
    stat = np.array(exu.special.InfoStat(False), dtype=float)
    stat[[0, 2, 4]] -= 100
    solver.CheckSolverInfoStatistics("some solver", stat, 50)
    solver.CheckSolverInfoStatistics("another solver", stat, 500)
    out = capfd.readouterr().out
    assert "some solver" in out and "another solver" not in out
