"""Fixed coordinates whose masses are coupled with others: explicit methods take the forces that hold them into account."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from solving import Solver, Variable, new_system, settings

import dalembert as exu


def beam_tip(solver: Any, steps: int) -> np.ndarray:
    """A cantilever of cable elements, whose consistent masses couple neighbours, falls from the horizontal."""
    mbs = new_system()
    cable = exu.utilities.Cable2D(physicsMassPerLength=1, physicsBendingStiffness=10, physicsAxialStiffness=1e4)
    nodes = exu.utilities.GenerateStraightLineANCFCable2D(
        mbs, [0, 0, 0], [2, 0, 0], 2, cable, massProportionalLoad=[0, -9.81, 0], fixedConstraintsNode0=[1, 1, 0, 1]
    )[0]
    mbs.Assemble()
    mbs.SolveDynamic(settings(0.2, steps), solverType=solver)
    return np.asarray(mbs.GetNodeOutput(nodes[-1], Variable.Displacement))


def test_a_beam_falls_as_with_implicit_solvers() -> None:
    wanted = beam_tip(Solver.TrapezoidalIndex2, 4000)
    assert np.linalg.norm(wanted) > 0.1
    assert beam_tip(Solver.RK44, 1000) == pytest.approx(wanted, abs=2e-5)


def test_methods_that_cannot_say_so(capfd: Any) -> None:
    beam_tip(Solver.VelocityVerlet, 4000)
    assert "masses couple coordinates that are fixed with others" in capfd.readouterr().out
