"""Solutions that are finished but not trusted report it."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest
from oscillators import dynamic_settings, friction_or_stop, mass, oscillator
from tolerances import by_tolerance

import dalembert as exu
from dalembert.utilities import InertiaCuboid, RigidBodyInertia

Solver = exu.DynamicSolverType


def doubts(mbs: Any, settings: Any, solver: Any = Solver.GeneralizedAlpha) -> list[str]:
    result = mbs.SolveDynamic(settings, solverType=solver)
    assert result
    assert result == True  # noqa: E712  as a number, it is
    solved = mbs.sys["dynamicSolver"]
    found: list[str] = solved.GetDoubts()
    told = list(result.doubts) if isinstance(result, exu.FinishedNotTrusted) else []
    assert told == found and (result is True) == (found == [])
    assert solved.output.finishedSuccessfully and solved.output.trusted == (found == [])
    return found


def test_the_returned_value_has_the_reasons() -> None:
    value = exu.FinishedNotTrusted(["one reason", "another one"])
    assert value and repr(value) == str(value) == "finished, not trusted: one reason; another one"
    again = pickle.loads(pickle.dumps(value))
    assert again == value == 1 and again.doubts == value.doubts == ("one reason", "another one")


def test_nothing_speaks_against_a_good_solution() -> None:
    model = oscillator()
    model.mbs.Assemble()
    assert doubts(model.mbs, dynamic_settings(1.0, 100)) == []
    assert not exu.MainSolverImplicitSecondOrder().output.trusted


@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.DOPRI5])
def test_errors_above_the_tolerances(solver: Any, capfd: Any) -> None:
    model = oscillator()
    model.mbs.Assemble()
    settings = by_tolerance(dynamic_settings(1.0, 20), 1e-12)
    settings.timeIntegration.minimumStepSize = 0.04
    settings.timeIntegration.verboseMode = 1
    (doubt,) = doubts(model.mbs, settings, solver)
    steps = model.mbs.sys["dynamicSolver"].it.stepsAboveTolerance
    assert steps > 10 and doubt.startswith(f"errors above the tolerances in {steps} steps")
    assert f"not to be trusted: {doubt}" in capfd.readouterr().out
    assert f"not to be trusted: {doubt}" in model.mbs.Report()


def test_friction_that_has_not_settled() -> None:
    model = mass()
    friction_or_stop(model, slips=-1, fDynamicFriction=20.0, stickingStiffness=1e6)
    model.mbs.Assemble()
    settings = dynamic_settings(1.0, 20)
    settings.timeIntegration.discontinuous.maxIterations = 1
    (doubt,) = doubts(model.mbs, settings)
    assert doubt.startswith("contact or friction that has not settled in ")


def test_gaps_at_the_end() -> None:
    """Constraints of velocities, with steps in which a pendulum turns by up to a radian."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    body = mbs.CreateRigidBody(
        inertia=InertiaCuboid(1000, [1, 0.1, 0.2]), referencePosition=[0.5, 0, 0], gravity=[0, -9.81, 0]
    )
    mbs.CreateRevoluteJoint(name="hinge", bodyNumbers=[ground, body], position=[0, 0, 0], axis=[0, 0, 1])
    mbs.Assemble()
    (doubt,) = doubts(mbs, dynamic_settings(2.0, 15), Solver.TrapezoidalIndex2)
    assert doubt.startswith("open at the end: ") and "'hinge'" in doubt
    assert doubts(mbs, dynamic_settings(2.0, 60), Solver.TrapezoidalIndex2) == []  # a drift of 0.7 mm
    assert doubts(mbs, dynamic_settings(2.0, 30)) == []


TURNS = RigidBodyInertia(1, np.diag([0.01, 0.02, 0.015]))


def turned(node_type: Any, omega: list[float], settings: Any, solver: Any) -> tuple[Any, list[str]]:
    """The rotation of a free body after a second, and doubts."""
    mbs = exu.SystemContainer().AddSystem()
    mbs.CreateRigidBody(name="stone", inertia=TURNS, initialAngularVelocity=omega, nodeType=node_type)
    mbs.Assemble()
    found = doubts(mbs, settings, solver)
    return mbs.GetNodeOutput(0, exu.OutputVariableType.RotationMatrix).reshape(3, 3), found


@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.TrapezoidalIndex2])
def test_angles_that_lock(solver: Any) -> None:
    """A body that turns about its middle axis, almost: its first and third angle change by half a turn within a few
    milliseconds at a quarter turn.
    Error control finds them, equal steps miss them, and say so; Euler parameters do not notice."""
    omega = [0.03, 10.0, 0.02]
    right, found = turned(
        exu.NodeType.RotationEulerParameters, omega, by_tolerance(dynamic_settings(1.0, 100), 1e-11), Solver.DOP853
    )
    assert found == []
    angles = exu.NodeType.RotationRxyz
    wrong, (doubt,) = turned(angles, omega, dynamic_settings(1.0, 1000), solver)
    assert np.abs(wrong - right).max() > 0.01  # it is 2e-5 for Euler parameters with these steps
    assert doubt.startswith(
        "node 0 'Node:stone' (NodeRigidBodyRxyz) turns by three angles, which lock where the second is at 90 degrees; it came to "
    )
    assert "RotationEulerParameters" in doubt and 0.15 < float(doubt.split("at time ")[1].split(";")[0]) < 0.17
    for method, tolerance, error in [(Solver.DOPRI5, 1e-8, 1e-6), (Solver.ESDIRK43, 1e-8, 2e-6), (solver, 1e-5, 3e-4)]:
        rotation, found = turned(angles, omega, by_tolerance(dynamic_settings(1.0, 100), tolerance), method)
        assert found == [] and np.abs(rotation - right).max() < error


def test_angles_that_lock_are_advised_on() -> None:
    with pytest.raises(exu.SolverError) as caught:
        turned(exu.NodeType.RotationRxyz, [0.03, 10.0, 0.02], dynamic_settings(1.0, 1000), Solver.RK44)
    assert caught.value.advice[0].startswith(
        "node 0 'Node:stone' (NodeRigidBodyRxyz) turns by three angles, which lock"
    )


def test_angles_that_are_in_equilibrium_alone() -> None:
    """A rod on a ball joint, and two springs. Newton's method for three angles ends at gimbal lock, and springs rotate
    the rod about the lost direction; springs do not rotate it with Euler parameters."""
    springs = [([-0.5, -0.4, 0.6], [-0.2, 0.1, 0.1]), ([-0.6, -0.9, -0.5], [0.1, 0.0, -0.2])]

    def rest(node_type: Any) -> tuple[Any, float]:
        """Return the result of the solver, and the moment of the springs about the joint."""
        mbs = exu.SystemContainer().AddSystem()
        ground = mbs.CreateGround()
        rod = mbs.CreateRigidBody(
            referencePosition=[0.3, 0, 0], inertia=InertiaCuboid(1000, [0.6, 0.1, 0.1]), nodeType=node_type
        )
        mbs.CreateSphericalJoint(bodyNumbers=[ground, rod], position=[0, 0, 0])
        for of_ground, of_rod in springs:
            mbs.CreateCartesianSpringDamper(
                bodyNumbers=[ground, rod], localPosition0=of_ground, localPosition1=of_rod, stiffness=[100] * 3
            )
        mbs.Assemble()
        settings = exu.SimulationSettings()
        settings.staticSolver.numberOfLoadSteps = 1
        settings.solutionSettings.writeSolutionToFile = False
        result = mbs.SolveStatic(settings)
        moment = np.zeros(3)
        for of_ground, of_rod in springs:
            place = mbs.GetObjectOutputBody(rod, exu.OutputVariableType.Position, of_rod)
            moment += np.cross(place, 100 * (np.array(of_ground) - place))
        return result, float(np.linalg.norm(moment))

    result, moment = rest(exu.NodeType.RotationRxyz)
    assert moment > 0.1
    (doubt,) = result.doubts
    assert "lock where the second is at 90 degrees" in doubt and "RotationEulerParameters" in doubt
    result, moment = rest(exu.NodeType.RotationEulerParameters)
    assert result is True and moment < 1e-6


@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.RK44])
def test_angles_that_go_straight_through(solver: Any) -> None:
    """About one axis, and in a gimbal, whose inner ring turns by the first two angles: the third stays."""
    angles = exu.NodeType.RotationRxyz
    rotation, found = turned(angles, [0.0, 10.0, 0.0], dynamic_settings(1.0, 100), solver)
    assert (
        found == []
        and np.abs(rotation - [[np.cos(10), 0, np.sin(10)], [0, 1, 0], [-np.sin(10), 0, np.cos(10)]]).max() < 1e-9
    )

    def inner_ring(node_type: Any) -> Any:
        mbs = exu.SystemContainer().AddSystem()
        ground = mbs.CreateGround()
        outer = mbs.CreateRigidBody(inertia=TURNS, initialAngularVelocity=[1, 0, 0], nodeType=node_type)
        inner = mbs.CreateRigidBody(inertia=TURNS, initialAngularVelocity=[1, 10, 0], nodeType=node_type)
        mbs.CreateRevoluteJoint(bodyNumbers=[ground, outer], position=[0, 0, 0], axis=[1, 0, 0], useGlobalFrame=True)
        mbs.CreateRevoluteJoint(bodyNumbers=[outer, inner], position=[0, 0, 0], axis=[0, 1, 0], useGlobalFrame=True)
        mbs.Assemble()
        assert doubts(mbs, dynamic_settings(1.0, 1000), solver) == []
        return mbs.GetNodeOutput(1, exu.OutputVariableType.RotationMatrix)

    # Errors of second order: 3e-6 of angles, 2e-5 of Euler parameters.
    assert np.abs(inner_ring(angles) - inner_ring(exu.NodeType.RotationEulerParameters)).max() < 1e-4
