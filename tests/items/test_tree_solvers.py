"""Trees with all that acts on them, under all solvers, on ground and floating."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert.testing.trees import Link, Tree, make, random_links

Solver = exu.DynamicSolverType
FIRST_ORDER = {Solver.ExplicitEuler, Solver.VelocityVerlet}  # forces depend on velocities
SECOND_ORDER = {Solver.GeneralizedAlpha, Solver.TrapezoidalIndex2, Solver.ExplicitMidpoint}
REFUSED = {Solver.DVERK6}  # there is none
END = 0.2


def friction(mbs: Any, t: float, itemNumber: int, q: Any, v: Any) -> Any:
    return -0.3 * np.array(v) + 0.5 * np.sin(10 * t)


def tree(floating: bool) -> Tree:
    """Weight, forces on joints and links, drives, a user function; a floating base has six joints without mass."""
    links = random_links(5, 4)
    if floating:
        base = [Link(joint, i - 1) for i, joint in enumerate(("Px", "Py", "Pz", "Rz", "Ry"))]
        base.append(Link("Rx", 4, 2.0, [0.1, 0, 0.05], np.diag([0.3, 0.4, 0.5])))
        for link in links:
            link.parent += 6
        links = base + links
    n, rng = len(links), np.random.default_rng(3)
    drives = np.arange(n) > (5 if floating else -1)
    return make(
        links,
        rng.uniform(-0.3, 0.3, n),
        rng.uniform(-1, 1, n),
        gravity=[1, -2, -9],
        baseOffset=[0.3, 0.2, 0.1],
        jointForceVector=rng.uniform(-2, 2, n),
        jointPControlVector=20.0 * drives,
        jointDControlVector=2.0 * drives,
        jointPositionOffsetVector=rng.uniform(-0.3, 0.3, n),
        jointVelocityOffsetVector=rng.uniform(-0.3, 0.3, n),
        linkForces=exu.Vector3DList(list(rng.uniform(-2, 2, (n, 3)))),
        linkTorques=exu.Vector3DList(list(rng.uniform(-0.5, 0.5, (n, 3)))),
        forceUserFunction=friction,
    )


def state_at_end(floating: bool, solver: Any, steps: int) -> np.ndarray:
    made = tree(floating)
    made.mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime = END
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.automaticStepSize = False
    settings.timeIntegration.generalizedAlpha.spectralRadius = 0.9
    settings.timeIntegration.newton.relativeTolerance = 1e-11
    settings.timeIntegration.newton.absoluteTolerance = 1e-11
    settings.solutionSettings.writeSolutionToFile = False
    made.mbs.SolveDynamic(settings, solverType=solver)
    return np.concatenate([made.coordinates, made.rates])


@pytest.fixture(scope="module", params=[False, True], ids=["fixed base", "floating base"])
def reference(request: pytest.FixtureRequest) -> tuple[bool, np.ndarray]:
    return request.param, state_at_end(request.param, Solver.RK67, 400)


@pytest.mark.parametrize("solver", sorted(set(Solver) - REFUSED, key=int), ids=lambda solver: solver.name)
def test_all_solvers_agree(reference: tuple[bool, np.ndarray], solver: Any) -> None:
    """Errors fall with the order: error ratio 2 or 4 for half of the step, or 8 or more down to the tolerance of
    Newton's method."""
    floating, exact = reference
    errors = [np.abs(state_at_end(floating, solver, steps) - exact).max() for steps in (100, 200)]
    if solver in FIRST_ORDER:
        assert errors[1] < 0.05 and errors[0] / errors[1] == pytest.approx(2, rel=0.2)
    elif solver in SECOND_ORDER:
        assert errors[1] < 1e-3 and errors[0] / errors[1] == pytest.approx(4, rel=0.2)
    else:
        assert errors[1] < 1e-6 and (errors[1] < 1e-8 or errors[0] / errors[1] > 7)
