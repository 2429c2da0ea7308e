"""A viewer pulls a point of an item while a solver runs: equilibria that are known, and what cannot be pulled."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert import _core
from dalembert.itemInterface import NodeGenericODE2, ObjectKinematicTree
from dalembert.rigidBodyUtilities import InertiaCuboid

Types = exu.DynamicSolverType
SOLVERS = [Types.GeneralizedAlpha, Types.TrapezoidalIndex2, Types.RK44, Types.VelocityVerlet, Types.DOPRI5]
LONG = 1e5  # s of simulated time: the test ends solutions
PATIENCE = 60.0  # s for a solution of a second


def settings(step: float = 1e-3, end: float = LONG) -> Any:
    made = exu.SimulationSettings()
    made.timeIntegration.numberOfSteps, made.timeIntegration.endTime = round(end / step), end
    made.timeIntegration.verboseMode = 0
    made.solutionSettings.writeSolutionToFile = False
    return made


class Pulling:
    """Pulls in a thread while a solution runs, until `rests(point)`; the solution then goes on for 100 s without the pull."""

    def __init__(self, mbs: Any, target: list[float], strength: float, grab: tuple[Any, ...]) -> None:
        mbs.Assemble()
        self.mbs, self.target, self.strength = mbs, target, strength
        self.shadow = _core._Shadow(mbs)
        self.shadow.follow()
        self.shadow.grab(*grab)
        self.end: Any = self.shadow.gripped  # where the pulled point came to rest
        self._time, self._released = 0.0, float("inf")
        self._done = threading.Event()

    def solve(self, rests: Callable[[Any], bool], solver: Any = Types.GeneralizedAlpha, step: float = 1e-3) -> None:
        puller = threading.Thread(target=self._pull, args=(rests,))
        puller.start()
        self.mbs.SetPreStepUserFunction(self._goes_on)
        try:
            self.mbs.SolveDynamic(settings(step), solverType=solver)
        finally:
            self._done.set()
            puller.join()

    def _goes_on(self, mbs: Any, t: float) -> bool:
        self._time = t
        return t < self._released + 100

    def _pull(self, rests: Callable[[Any], bool]) -> None:
        end = time.monotonic() + PATIENCE
        while not self.shadow.solving and not self._done.wait(1e-3):
            pass
        self.shadow.pull(self.target, self.strength)
        while not self._done.wait(1e-2) and time.monotonic() < end and not rests(self.end):
            self.shadow.follow()
            self.end = self.shadow.gripped
        self.shadow.release()
        self._released = self._time


@pytest.mark.parametrize("solver", SOLVERS)
def test_a_spring_balances_the_pull(mbs: Any, solver: Any) -> None:
    mass, stiffness, strength, target = 2.0, 50.0, 100.0, 0.6
    ground = mbs.CreateGround()
    body = mbs.CreateMassPoint(physicsMass=mass)
    mbs.CreateCartesianSpringDamper(bodyNumbers=[ground, body], stiffness=[stiffness] * 3, damping=[5.0] * 3)
    pulling = Pulling(mbs, [target, 0, 0], strength, (body, [0, 0, 0]))
    expected = mass * strength * target / (mass * strength + stiffness)
    # forces that are held for a step of 1 ms do not move the equilibrium
    pulling.solve(lambda point: abs(point[0] - expected) < 1e-9, solver)
    np.testing.assert_allclose(pulling.end, [expected, 0, 0], atol=1e-9)
    # after the release it goes back: 100 s are 125 time constants of the damper
    np.testing.assert_allclose(mbs.GetObjectOutputBody(body, exu.OutputVariableType.Position), 0, atol=1e-9)


def hinged_rod(mbs: Any) -> tuple[Any, ...]:
    ground = mbs.CreateGround()
    rod = mbs.CreateRigidBody(inertia=InertiaCuboid(1000, [1, 0.1, 0.1]), referencePosition=[0.5, 0, 0])
    mbs.CreateRevoluteJoint(bodyNumbers=[ground, rod], position=[0, 0, 0], axis=[0, 0, 1])
    mbs.CreateTorsionalSpringDamper(
        bodyNumbers=[ground, rod], position=[0, 0, 0], axis=[0, 0, 1], stiffness=0, damping=20
    )
    return rod, [1, 0, 0]


def hinged_link(mbs: Any) -> tuple[Any, ...]:
    node = mbs.AddNode(
        NodeGenericODE2(
            numberOfODE2Coordinates=1, referenceCoordinates=[0], initialCoordinates=[0], initialCoordinates_t=[0]
        )
    )
    tree = mbs.AddObject(
        ObjectKinematicTree(
            nodeNumber=node,
            jointTypes=[exu.JointType.RevoluteZ],
            linkParents=[-1],
            jointTransformations=[np.eye(3)],
            jointOffsets=[[0, 0, 0]],
            linkInertiasCOM=[np.diag([1.0, 8.0, 8.0])],
            linkCOMs=[[0.5, 0, 0]],
            linkMasses=[100.0],
            jointDControlVector=[20.0],
            jointPControlVector=[0.0],
            jointVelocityOffsetVector=[0.0],
        )
    )
    return tree, [1, 0, 0], 0


@pytest.mark.parametrize("make", [hinged_rod, hinged_link])
def test_hinged_rods_turn_to_the_target(mbs: Any, make: Callable[[Any], tuple[Any, ...]]) -> None:
    """The force on the tip has no moment about the hinge when the rod points to the target, 1.5 m away."""
    pulling = Pulling(mbs, [0.9, 1.2, 0], 100.0, make(mbs))
    # solved to 1e-7 of the largest residual
    pulling.solve(lambda tip: abs(tip[0] - 0.6) + abs(tip[1] - 0.8) < 1e-7)
    np.testing.assert_allclose(pulling.end, [0.6, 0.8, 0], atol=1e-7)


def test_steps_far_longer_than_the_spring_allows_stay_stable(mbs: Any) -> None:
    """1e4 rad/s with steps of 10 ms: the pull is weaker instead."""
    body = mbs.CreateMassPoint(physicsMass=2)
    pulling = Pulling(mbs, [1, 2, 3], 1e8, (body, [0, 0, 0]))
    pulling.solve(lambda point: bool(np.allclose(point, [1, 2, 3], rtol=0, atol=1e-9)), step=1e-2)
    np.testing.assert_allclose(pulling.end, [1, 2, 3], atol=1e-9)


def test_pulls_end_with_the_solution(mbs: Any) -> None:
    body = mbs.CreateMassPoint(physicsMass=2)
    mbs.Assemble()
    shadow = _core._Shadow(mbs)
    shadow.follow()
    shadow.grab(body, [0, 0, 0])

    def pull(mbs: Any, t: float) -> bool:
        shadow.pull([1, 0, 0], 100.0)
        return bool(mbs.GetObjectOutput(body, exu.OutputVariableType.Velocity)[0] < 0.5)

    mbs.SetPreStepUserFunction(pull)
    mbs.SolveDynamic(settings())
    assert mbs.GetObjectOutput(body, exu.OutputVariableType.Velocity)[0] > 0.5
    mbs.SetPreStepUserFunction(0)
    mbs.SolveDynamic(settings(end=1.0))
    np.testing.assert_array_equal(mbs.GetObjectOutput(body, exu.OutputVariableType.Position), 0)


def test_refused_grips(mbs: Any) -> None:
    ground = mbs.CreateGround()
    mass = mbs.CreateMassPoint(physicsMass=1)
    spring = mbs.CreateSpringDamper(bodyNumbers=[ground, mass], stiffness=1, referenceLength=1)
    mbs.Assemble()
    shadow = _core._Shadow(mbs)
    shadow.follow()
    with pytest.raises(ValueError, match=r"object 0 .*ObjectGround.*: cannot be pulled, because it does not move"):
        shadow.grab(ground, [0, 0, 0])
    with pytest.raises(ValueError, match="cannot be pulled, because it has no position"):
        shadow.grab(spring, [0, 0, 0])
    with pytest.raises(IndexError):
        shadow.grab(99, [0, 0, 0])
    assert shadow.gripped is None
