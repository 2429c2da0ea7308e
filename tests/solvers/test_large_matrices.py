"""Matrices whose entries int cannot count are refused before they take memory."""

from __future__ import annotations

import numpy as np
import pytest
from oscillators import dynamic_settings

import dalembert as exu
from dalembert.itemInterface import NodeGenericODE2, ObjectGenericODE2

MOST = 46340  # its square is the largest below 2^31


def test_dense_matrices_are_refused_in_time() -> None:
    column_start = np.zeros(MOST + 2, dtype=np.int32)
    with pytest.raises(ValueError, match=r"dense system matrix of 46341 unknowns: .* 17 GB.*EigenSparse"):
        exu.testing.LinearSolver(column_start, np.zeros(0, dtype=np.int32), dense=True)


@pytest.mark.parametrize("solve", ["SolveDynamic", "SolveStatic"])
def test_solvers_name_the_setting(solve: str) -> None:
    mbs = exu.SystemContainer().AddSystem()
    zeros = [0.0] * 100
    for _ in range(MOST // 100 + 1):
        node = mbs.AddNode(
            NodeGenericODE2(
                referenceCoordinates=zeros,
                initialCoordinates=zeros,
                initialCoordinates_t=zeros,
                numberOfODE2Coordinates=100,
            )
        )
        mbs.AddObject(ObjectGenericODE2(nodeNumbers=[node], massMatrix=np.eye(100)))
    mbs.Assemble()
    settings = dynamic_settings(1.0, 10)
    settings.timeIntegration.verboseMode = 0
    settings.linearSolverType = exu.LinearSolverType.EXUdense
    with pytest.raises(ValueError, match=r"46400 unknowns.*it would take 17 GB.*linearSolverType.*EigenSparse"):
        getattr(mbs, solve)(settings)
    settings.linearSolverType = exu.LinearSolverType.EigenSparse
    solver = exu.MainSolverStatic()
    solver.InitializeSolver(mbs, settings)
    with pytest.raises(ValueError, match=r"GetSystemJacobian\(\): an array of shape \(46400, 46400\) is too large"):
        solver.GetSystemJacobian()


@pytest.mark.parametrize(("bodies", "kind"), [(10, "dense (EXUdense)"), (11, "sparse (EigenSparse)")])
def test_solvers_report_the_selected_matrices(bodies: int, kind: str, capfd: pytest.CaptureFixture[str]) -> None:
    """Up to 32 unknowns, dense ones; settings of the user cause no message."""
    for is_set in (False, True):
        mbs = exu.SystemContainer().AddSystem()
        for _ in range(bodies):
            mbs.CreateMassPoint(physicsMass=1)
        mbs.Assemble()
        settings = exu.SimulationSettings()
        settings.solutionSettings.writeSolutionToFile = False
        settings.timeIntegration.numberOfSteps, settings.timeIntegration.verboseMode = 1, 1
        if is_set:
            settings.linearSolverType = exu.LinearSolverType.EXUdense
        mbs.SolveDynamic(settings)
        said = f"linear solver: {kind}, as linearSolverType has not been set"
        assert (said in capfd.readouterr().out) is not is_set
