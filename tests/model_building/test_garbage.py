"""Systems that nobody uses any more are freed, with everything that their user functions hold."""

from __future__ import annotations

import gc
import weakref
from typing import Any

import pytest

import dalembert as exu


class Mark:
    """Something to watch."""


def attach(mbs: Any, where: str, mark: Mark) -> None:
    """Let the system refer to itself, and to the mark."""

    def law(*arguments: Any) -> Any:
        assert mbs is not None and mark is not None
        return arguments[-1]

    if where == "load":
        marker = mbs.AddMarker(exu.MarkerNodePosition(nodeNumber=0))
        mbs.AddLoad(exu.LoadForceVector(markerNumber=marker, loadVector=[1, 0, 0], loadVectorUserFunction=law))
    elif where == "step":
        mbs.SetPreStepUserFunction(lambda system, t: law(True))
    else:
        getattr(mbs, where)["law"] = law


def system(container: Any) -> Any:
    mbs = container.AddSystem()
    mbs.AddObject(exu.ObjectMassPoint(physicsMass=1, nodeNumber=mbs.AddNode(exu.NodePoint())))
    return mbs


def solve(mbs: Any) -> None:
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = 2
    settings.timeIntegration.verboseMode = 0
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveDynamic(settings)


@pytest.mark.parametrize("solved", [False, True])
@pytest.mark.parametrize("where", ["load", "step", "variables", "sys"])
def test_a_system_that_refers_to_itself_is_freed(where: str, solved: bool) -> None:
    mbs, mark = system(exu.SystemContainer()), Mark()
    attach(mbs, where, mark)
    if solved:
        solve(mbs)
    watched = weakref.ref(mark)
    del mbs, mark
    gc.collect()
    assert watched() is None


def test_a_solved_system_is_freed_at_once() -> None:
    """It keeps its solver; the solver does not keep it."""
    mbs, mark = system(exu.SystemContainer()), Mark()
    mbs.variables["mark"] = mark
    solve(mbs)
    watched = weakref.ref(mark)
    del mbs, mark
    assert watched() is None


def test_a_solver_without_its_system_raises() -> None:
    mbs = system(exu.SystemContainer())
    mbs.Assemble()
    solver = exu.MainSolverImplicitSecondOrder()
    solver.InitializeSolver(mbs, exu.SimulationSettings())
    solver.ComputeMassMatrix(mbs)
    assert solver.GetSystemMassMatrix().shape == (3, 3)
    del mbs
    with pytest.raises(RuntimeError, match="does not exist any more|ComputeMassMatrix"):
        solver.GetSystemMassMatrix()


def test_a_system_that_its_container_holds_stays_whole() -> None:
    container = exu.SystemContainer()
    mbs, mark = system(container), Mark()
    attach(mbs, "load", mark)
    watched = weakref.ref(mark)
    del mbs, mark
    gc.collect()
    assert watched() is not None
    solve(container.GetSystem(0))
    velocity = container.GetSystem(0).GetNodeOutput(0, exu.OutputVariableType.Velocity)
    assert velocity[0] == pytest.approx(1.0, rel=1e-9)  # unit force on unit mass for one second
