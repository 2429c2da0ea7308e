"""Solver objects that are kept: solvers that are not initialized, whose system was assembled again, or is gone."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from oscillators import dynamic_settings, oscillator

import dalembert as exu

SOLVERS = [
    exu.MainSolverStatic,
    exu.MainSolverImplicitSecondOrder,
    exu.MainSolverDiagonallyImplicit,
    exu.MainSolverExplicit,
]


def run_in_process(*arguments: str) -> None:
    """Run the script in this folder; a crash shows the last call."""
    script = Path(__file__).parent / "call_everything.py"
    done = subprocess.run(
        [sys.executable, script, *arguments], capture_output=True, text=True, timeout=120, check=False
    )
    assert done.returncode == 0, (done.stdout.splitlines()[-1:], done.stderr[-2000:])
    assert len(done.stdout.splitlines()) > 40  # something was called


@pytest.mark.parametrize("state", ["new", "solved", "failed", "assembled again", "orphaned", "of another system"])
@pytest.mark.parametrize("solver", [solver.__name__ for solver in SOLVERS])
def test_no_method_ends_the_process(solver: str, state: str) -> None:
    run_in_process(solver, state)


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("method", ["Newton", "SolveSteps", "FinishStep", "ComputeMassMatrix", "GetSystemMassMatrix"])
def test_the_error_has_a_remedy(solver: Any, method: str) -> None:
    model, settings, kept = oscillator(), dynamic_settings(1.0, 10), solver()
    model.mbs.Assemble()
    takes = {"ComputeMassMatrix": [model.mbs], "GetSystemMassMatrix": []}.get(method, [model.mbs, settings])
    with pytest.raises(RuntimeError, match=rf"solver.{method}\(...\): .*not initialized.*InitializeSolver\(mbs"):
        getattr(kept, method)(*takes)
    assert kept.InitializeSolver(model.mbs, settings)
    model.mbs.Assemble()
    with pytest.raises(
        RuntimeError, match=rf"solver.{method}\(...\): the system was assembled again .*InitializeSolver"
    ):
        getattr(kept, method)(*takes)
    assert kept.InitializeSolver(model.mbs, settings)
    getattr(kept, method)(*takes)


def test_a_failed_initialization_leaves_no_solver() -> None:
    mbs = exu.SystemContainer().AddSystem()
    mbs.Assemble()
    solver = exu.MainSolverStatic()
    with pytest.raises(RuntimeError, match="no unknowns"):
        solver.InitializeSolver(mbs, exu.SimulationSettings())
    with pytest.raises(RuntimeError, match="not initialized"):
        solver.Newton(mbs, exu.SimulationSettings())


def test_refused_matrices_change_nothing() -> None:
    model, solver = oscillator(), exu.MainSolverStatic()
    model.mbs.Assemble()
    solver.InitializeSolver(model.mbs, exu.SimulationSettings())
    solver.SetSystemMassMatrix(np.array([[3.0]]))
    with pytest.raises(ValueError, match="shape"):
        solver.SetSystemMassMatrix(np.eye(2))
    assert solver.GetSystemMassMatrix() == [[3.0]]


def test_settings_that_change_while_a_static_solver_runs() -> None:
    """The last load step has no stabilizer, if it was set in the middle: the deflection is that of statics."""
    model = oscillator(speed=0)
    model.load(8.0)
    settings = dynamic_settings(1.0, 1)
    settings.staticSolver.numberOfLoadSteps = 5
    settings.staticSolver.newton.relativeTolerance = settings.staticSolver.newton.absoluteTolerance = 1e-10

    def pre_step(mbs: Any, t: float) -> bool:
        settings.staticSolver.stabilizerODE2term = 100.0
        settings.linearSolverType = exu.LinearSolverType.EigenSparse
        settings.parallel.numberOfThreads = 3
        return True

    model.mbs.SetPreStepUserFunction(pre_step)
    model.mbs.Assemble()
    model.mbs.SolveStatic(settings)
    assert model.position == pytest.approx(8.0 / 80.0, rel=1e-8)


def test_solvers_speak_without_a_system() -> None:
    for solver in SOLVERS:
        kept = solver()
        kept.VerboseWrite(0, "x")
        model = oscillator()
        model.mbs.Assemble()
        kept.InitializeSolver(model.mbs, dynamic_settings(1.0, 10))
        del model
        kept.VerboseWrite(0, "x")
        assert "solver" in repr(kept)


def test_a_solver_speaks_after_its_solution(capsys: pytest.CaptureFixture[str]) -> None:
    model = oscillator()
    model.mbs.Assemble()
    model.mbs.SolveDynamic(dynamic_settings(1.0, 10))
    model.mbs.sys["dynamicSolver"].VerboseWrite(0, "nobody listens any more")
    assert "listens" not in capsys.readouterr().out
