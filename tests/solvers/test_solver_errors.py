"""SolverError: its text, its attributes, and that they survive pickling."""

from __future__ import annotations

import copy
import multiprocessing
import pickle
from typing import Any

import numpy as np
import pytest
from oscillators import dynamic_settings, mass, oscillator

import dalembert as exu
from dalembert.itemInterface import CoordinateConstraint, Mass1D, Node1D
from dalembert.solver import SolverError

Solver = exu.DynamicSolverType


def settings_of(steps: int = 10) -> Any:
    settings = dynamic_settings(1.0, steps)
    settings.timeIntegration.verboseMode = settings.staticSolver.verboseMode = 0
    settings.redundantConstraints.treat = False
    return settings


def redundant() -> Any:
    model = oscillator()
    for name in ("first", "second"):
        model.mbs.AddObject(CoordinateConstraint(name=name, markerNumbers=[model.ground, model.marker]))
    model.mbs.Assemble()
    return model.mbs


def massless() -> Any:
    model = oscillator()
    node = model.mbs.AddNode(Node1D(name="loose", referenceCoordinates=[0]))
    model.mbs.AddObject(Mass1D(nodeNumber=node, physicsMass=0))
    model.mbs.Assemble()
    return model.mbs


def fail(_: Any = None) -> None:
    redundant().SolveDynamic(settings_of())


def error_of(solve: Any, *arguments: Any, **options: Any) -> SolverError:
    with pytest.raises(SolverError) as caught:
        solve(*arguments, **options)
    return caught.value


def test_one_class_under_all_names() -> None:
    assert exu.SolverError is SolverError
    assert issubclass(SolverError, ValueError)
    assert f"{SolverError.__module__}.{SolverError.__qualname__}" == "dalembert.SolverError"


def test_the_text_is_the_whole_diagnosis() -> None:
    error = error_of(fail)
    text = str(error)
    assert text.startswith("SolveDynamic terminated due to errors: dynamic solver failed\n")
    assert "equations that depend on each other:\n    rows 1: object 2 'first'" in text
    assert all(line in text for line in error.dependentEquations)
    assert len(error.advice) == 3 and all(line in text for line in error.advice)  # the last one on the gap at the start
    assert error.diagnosis in text


def test_attributes() -> None:
    error = error_of(fail)
    assert (error.reason, error.solverName) == ("singularMatrix", "implicit second order time integration")
    assert (error.stepIndex, error.time, error.stepSize) == (1, pytest.approx(0.1), pytest.approx(0.1))
    assert error.causingRow in (1, 2) and "(ObjectConnectorCoordinate)" in error.causingItems
    assert len(error.dependentEquations) == 2
    assert error.relativeTolerance == error.absoluteTolerance == 1e-12
    assert error.solver.GetDiagnosis() in error.diagnosis


def test_values_of_newtons_method() -> None:
    model = oscillator(law=lambda mbs, t, item, u, *rest: 1e7 * (1 if u > 0.1 * np.sin(1e5 * u) else -1))
    model.mbs.Assemble()
    settings = settings_of()
    settings.timeIntegration.adaptiveStep = False
    error = error_of(model.mbs.SolveDynamic, settings)
    assert error.reason == "newton"
    assert error.newtonSteps == settings.timeIntegration.newton.maxIterations
    worst = error.values[0]
    assert (worst["vector"], worst["index"]) == ("equation", 0)
    assert worst["items"] == "node 0 'foot' (Node1D), coordinate 0"
    assert abs(worst["value"]) > 1e5
    assert error.residual > 1e5
    assert "equation 0: " in str(error) and "what to try:\n    - use smaller steps" in str(error)


def test_error_of_discontinuous_iterations() -> None:
    model = mass()
    model.mbs.Assemble()
    model.mbs.SetPostNewtonUserFunction(lambda mbs, t: [5.0, -1])
    settings = settings_of()
    settings.timeIntegration.adaptiveStep = False
    settings.timeIntegration.discontinuous.ignoreMaxIterations = False
    error = error_of(model.mbs.SolveDynamic, settings)
    assert (error.reason, error.residual) == ("discontinuousIteration", 5)
    assert (error.newtonSteps, error.absoluteTolerance) == (
        5,
        settings.timeIntegration.discontinuous.iterationTolerance,
    )
    assert "error 5 after 5 iterations" in str(error)


@pytest.mark.parametrize("duplicate", [copy.copy, copy.deepcopy, lambda error: pickle.loads(pickle.dumps(error))])
def test_copies_have_everything_but_the_solver(duplicate: Any) -> None:
    error = error_of(fail)
    error.add_note("a note")
    twin = duplicate(error)
    assert type(twin) is SolverError and str(twin) == str(error)
    assert twin.solver is None and error.solver is not None
    assert {**vars(twin), "solver": None} == {**vars(error), "solver": None}
    assert twin.__notes__ == ["a note"]


def test_processes_pass_it_on() -> None:
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        error = error_of(pool.map, fail, [0])
    assert (error.reason, error.solver) == ("singularMatrix", None)
    assert "'second' (ObjectConnectorCoordinate)" in str(error)


def test_parameter_lists_pass_it_on() -> None:
    error = error_of(exu.processing.ProcessParameterList, fail, [{}, {}], True, numberOfThreads=1)
    assert "in evaluation 0 of 2" in error.__notes__[-1]
    assert "'second' (ObjectConnectorCoordinate)" in str(error)


@pytest.mark.parametrize("part", ["InitializeSolver", "SolveSteps"])
def test_parts_of_an_explicit_solver(part: str) -> None:
    mbs, settings, solver = massless(), settings_of(), exu.MainSolverExplicit()
    settings.timeIntegration.explicitIntegration.dynamicSolverType = Solver.RK44
    settings.timeIntegration.reuseConstantMassMatrix = part == "InitializeSolver"
    if part == "SolveSteps":
        assert solver.InitializeSolver(mbs, settings)
    assert getattr(solver, part)(mbs, settings) is False
    assert SolverError.FromSolver(part, solver).reason == "massMatrix"


@pytest.mark.parametrize("solver", [Solver.ExplicitEuler, Solver.RK44, Solver.DOPRI5, Solver.VelocityVerlet])
@pytest.mark.parametrize("reuse", [True, False])
def test_mass_matrix_of_explicit_solvers(solver: Any, reuse: bool) -> None:
    mbs, settings = massless(), settings_of()
    settings.timeIntegration.reuseConstantMassMatrix = reuse
    error = error_of(mbs.SolveDynamic, settings, solverType=solver)
    assert error.reason == "massMatrix"
    assert error.causingRow == 1 and "'loose'" in error.causingItems
    assert "give every coordinate of these items mass or inertia" in str(error)
    assert mbs.systemData.GetODE2Coordinates() == pytest.approx([0.3, 0])


def test_it_is_said_once(capfd: pytest.CaptureFixture[str]) -> None:
    """The error has the text; the console does not repeat it."""
    settings = settings_of()
    settings.staticSolver.verboseMode = 1
    error = error_of(massless().SolveStatic, settings)
    shown = capfd.readouterr()
    assert str(error).count("singular at unknown 1") == 1
    assert "singular at" not in shown.out + shown.err
    assert shown.out.count("can move without inertia or stiffness in step 1") == 1  # how the solver has ended


def test_items_can_be_left_out() -> None:
    error = error_of(massless().SolveStatic, settings_of(), showCausingItems=False)
    assert "'loose'" not in str(error) and "singular at unknown 1" in str(error)
    assert "'loose'" in error.causingItems


@pytest.mark.parametrize("solver", [exu.MainSolverStatic, exu.MainSolverImplicitSecondOrder])
def test_solvers_called_by_hand(solver: Any) -> None:
    mbs, settings = massless(), settings_of()
    settings.timeIntegration.generalizedAlpha.computeInitialAccelerations = False
    by_hand = solver()
    assert by_hand.SolveSystem(mbs, settings) is False
    error = SolverError.FromSolver("my function", by_hand)
    assert str(error).startswith("my function terminated")
    assert (error.reason, error.solver) == ("freeDirection", by_hand)
    assert by_hand.GetErrorString() in by_hand.GetDiagnosis()
    by_hand = solver()
    assert by_hand.InitializeSolver(mbs, settings)
    assert by_hand.SolveSteps(mbs, settings) is False
    assert SolverError.FromSolver("steps", by_hand).causingRow == 1


def test_success_leaves_no_diagnosis_of_steps_that_were_repeated() -> None:
    model = oscillator()
    model.mbs.Assemble()
    calls: list[float] = []

    def settles_with_small_steps(mbs: Any, t: float) -> list[float]:
        calls.append(t)
        return [5.0 if len(calls) < 8 else 0.0, -1]

    model.mbs.SetPostNewtonUserFunction(settles_with_small_steps)
    settings = settings_of()
    settings.timeIntegration.discontinuous.ignoreMaxIterations = False
    assert model.mbs.SolveDynamic(settings)
    solver = model.mbs.sys["dynamicSolver"]
    assert solver.it.currentStepIndex > 11
    assert solver.GetDiagnosis() == solver.GetErrorString() == ""
    assert solver.GetDiagnosisDictionary()["reason"] == ""


def test_eigenvalues() -> None:
    for options in ({}, {"computeComplexEigenvalues": True}):
        error = error_of(massless().ComputeODE2Eigenvalues, **options)
        assert error.reason == "massMatrix"
        assert "coordinates without: [1]" in str(error)
    free = mass()
    free.mbs.AddObject(Mass1D(nodeNumber=free.mbs.AddNode(Node1D(referenceCoordinates=[0])), physicsMass=1))
    free.mbs.Assemble()
    error = error_of(free.mbs.ComputeODE2Eigenvalues, useSparseSolver=True, numberOfEigenvalues=1)
    assert error.reason == "singularMatrix"
    assert "useSparseSolver=False" in error.advice[0]
