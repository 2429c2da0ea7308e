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
