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


@pytest.mark.parametrize(("solver", "steps"), [(Solver.RK44, 1000), (Solver.VelocityVerlet, 4000)])
def test_a_beam_falls_as_with_implicit_solvers(solver: Any, steps: int) -> None:
    """Masses of fixed coordinates, left out, would cost 3 cm of 25."""
    wanted = beam_tip(Solver.TrapezoidalIndex2, 4000)
    assert np.linalg.norm(wanted) > 0.1
    assert beam_tip(solver, steps) == pytest.approx(wanted, abs=2e-5)
