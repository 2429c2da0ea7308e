"""Each kind of failure that solvers tell apart: what it says, whom it names, and what it advises."""

from __future__ import annotations

from typing import Any

import pytest
from oscillators import dynamic_settings, mass, oscillator

import dalembert as exu
from dalembert.itemInterface import Mass1D, Node1D
from dalembert.solver import SolverError
from dalembert.utilities import InertiaCuboid

Solver = exu.DynamicSolverType


def quiet(end: float, steps: int, tolerance: float | None = None) -> Any:
    s = dynamic_settings(end, steps)
    s.timeIntegration.verboseMode = s.staticSolver.verboseMode = 0
    if tolerance is not None:
        s.timeIntegration.automaticStepSize = s.stepSizeControl.implicitSolvers = True
        s.timeIntegration.absoluteTolerance = s.timeIntegration.relativeTolerance = tolerance
    return s


def failure(solve: Any, *arguments: Any, **options: Any) -> SolverError:
    with pytest.raises(SolverError) as caught:
        solve(*arguments, **options)
    return caught.value


def test_a_massless_coordinate() -> None:
    """Of two nodes without mass, both are named, and nobody else."""
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
