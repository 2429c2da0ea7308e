"""Each kind of failure of solvers: text, named items, and advice."""

from __future__ import annotations

from typing import Any

import pytest
from oscillators import dynamic_settings, mass, oscillator
from tolerances import by_tolerance

import dalembert as exu
from dalembert.itemInterface import Mass1D, Node1D
from dalembert.solver import SolverError
from dalembert.utilities import InertiaCuboid

Solver = exu.DynamicSolverType


def quiet(end: float, steps: int, tolerance: float | None = None) -> Any:
    s = dynamic_settings(end, steps)
    s.timeIntegration.verboseMode = s.staticSolver.verboseMode = 0
    return s if tolerance is None else by_tolerance(s, tolerance)


def failure(solve: Any, *arguments: Any, **options: Any) -> SolverError:
    with pytest.raises(SolverError) as caught:
        solve(*arguments, **options)
    return caught.value


def test_a_massless_coordinate() -> None:
    """Two nodes without mass are both named, and no others."""
    model = oscillator()
    for name in ("loose", "looser"):
        node = model.mbs.AddNode(Node1D(name=name, referenceCoordinates=[0]))
        model.mbs.AddObject(Mass1D(nodeNumber=node, physicsMass=0))
    model.mbs.Assemble()
    error = failure(model.mbs.SolveDynamic, quiet(1, 10))
    assert error.reason == "freeDirection" and error.stepIndex == 1
    assert len(error.freeDirections) == 2 and "'foot'" not in str(error.freeDirections)
    assert "'loose'" in error.freeDirections[0] and "'looser'" in error.freeDirections[1]
    assert "what can move freely:" in str(error) and "without inertia or stiffness" in error.advice[1]


def test_a_body_that_nothing_holds() -> None:
    """A static solver: the door can turn about its hinge, and no spring holds it."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    door = mbs.CreateRigidBody(
        name="door",
        referencePosition=[0.5, 0, 0],
        inertia=InertiaCuboid(100, [1, 0.1, 2]),
        gravity=[0, 0, -9.81],
        nodeType=exu.NodeType.RotationRxyz,
    )
    mbs.CreateRevoluteJoint(bodyNumbers=[ground, door], position=[0, 0, 0], axis=[0, 0, 1])
    mbs.Assemble()
    error = failure(mbs.SolveStatic, quiet(1, 1))
    assert error.reason == "freeDirection"
    (free,) = error.freeDirections  # the node moves sideways and turns about z
    assert "rows 1, 5:" in free and "NodeRigidBodyRxyz" in free


def test_redundant_equations_alone_are_no_free_direction() -> None:
    model = oscillator()
    for name in ("first", "second"):
        model.mbs.AddObject(
            exu.itemInterface.CoordinateConstraint(name=name, markerNumbers=[model.ground, model.marker])
        )
    model.mbs.Assemble()
    s = quiet(1, 10)
    s.redundantConstraints.treat = False
    error = failure(model.mbs.SolveDynamic, s)
    assert error.reason == "singularMatrix" and list(error.freeDirections) == []
    assert "'first'" in error.dependentEquations[0] and "'second'" in error.dependentEquations[1]


def pendulum() -> Any:
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    bob = mbs.CreateMassPoint(physicsMass=2, referencePosition=[1, 0, 0], gravity=[0, -9.81, 0])
    mbs.CreateDistanceConstraint(bodyNumbers=[ground, bob], distance=1)
    mbs.Assemble()
    return mbs


def test_tolerances_below_round_off_of_accelerations() -> None:
    """Index 3: positions with 1e-16 give accelerations with 1e-16 / h^2."""
    error = failure(pendulum().SolveDynamic, quiet(1, 100, 1e-14))
    assert error.reason == "toleranceBelowRoundOff"
    assert "absoluteTolerance=1e-14" in error.advice[0] and "DOP853" in error.advice[1]
    assert "the tolerances are below round-off" in str(error)
    pendulum().SolveDynamic(quiet(0.1, 100, 1e-7))


def test_tolerances_below_round_off_of_coordinates() -> None:
    model = mass(position=1.0)
    model.load(3.0)
    model.mbs.Assemble()
    s = quiet(1, 100, 1e-17)
    s.timeIntegration.minimumStepSize = 1e-4
    mbs = pendulum()
    error = failure(mbs.SolveDynamic, s, solverType=Solver.DOPRI5)
    assert error.reason == "toleranceBelowRoundOff" and "no more digits" in error.advice[0]
    assert len(error.values) > 0


EXPLICIT = [Solver.ODE23, Solver.DOPRI5, Solver.DOP853]


def stiff_pendulum() -> Any:
    """A slow swing on a spring whose own vibration, of 1e4 rad/s with critical damping, has died."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    bob = mbs.CreateMassPoint(name="bob", physicsMass=1, referencePosition=[1, 0, 0], gravity=[0, -1, 0])
    mbs.CreateSpringDamper(bodyNumbers=[ground, bob], stiffness=1e8, damping=2e4)
    mbs.Assemble()
    return mbs


@pytest.mark.parametrize("solver", EXPLICIT)
def test_steps_that_stability_keeps_small(solver: Any, capfd: Any) -> None:
    """A single warning, with the step size: 3 to 6 through 1e4 rad/s; the solution goes on."""
    stiff_pendulum().SolveDynamic(quiet(0.3, 10, 1e-4), solverType=solver)
    (line,) = (line for line in capfd.readouterr().out.splitlines() if "the system is stiff for this method" in line)
    assert 2e-4 < float(line.split("steps of ")[1].split()[0]) < 8e-4
    assert "ESDIRK43" in line


@pytest.mark.parametrize("solver", EXPLICIT)
def test_steps_that_accuracy_keeps_small_are_not_stiff(solver: Any, capfd: Any) -> None:
    """An oscillation that is to be seen, over a thousand steps."""
    model = oscillator(damping=0)
    model.mbs.Assemble()
    model.mbs.SolveDynamic(quiet(150, 40, 1e-7), solverType=solver)
    assert model.mbs.sys["dynamicSolver"].it.currentStepIndex > 400
    assert "stiff" not in capfd.readouterr().out


@pytest.mark.parametrize("solver", EXPLICIT)
def test_smallest_steps_that_are_not_stable(solver: Any) -> None:
    mbs, settings = stiff_pendulum(), quiet(1, 10, 1e-6)
    settings.timeIntegration.minimumStepSize = settings.timeIntegration.initialStepSize = 1e-3
    error = failure(mbs.SolveDynamic, settings, solverType=solver)
    assert error.reason == "stiffForMethod" and error.stepSize == pytest.approx(1e-3)
    assert "'Node:bob'" in error.values[0]["items"] and "ESDIRK43" in error.advice[0]
    assert mbs.SolveDynamic(settings, solverType=Solver.ESDIRK43)  # the advice helps
