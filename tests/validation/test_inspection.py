"""Gaps and energies in the course of a solution, against closed forms."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from solving import Solver, Variable, new_system, settings

import dalembert as exu
from dalembert.rigidBodyUtilities import InertiaCuboid

MASS, STIFFNESS, DAMPING = 2.0, 80.0, 3.0


def solved(mbs: Any, s: Any, path: Path, solver: Any = Solver.GeneralizedAlpha) -> Any:
    s.solutionSettings.writeSolutionToFile = True
    s.solutionSettings.coordinatesSolutionFileName = str(path / "solution.txt")
    s.solutionSettings.solutionWritePeriod = 0
    mbs.SolveDynamic(s, solverType=solver)
    return mbs.InspectSolution(path / "solution.txt")


def oscillator(force: Any = None) -> tuple[Any, Any]:
    mbs = new_system()
    ground = mbs.CreateGround()
    mass = mbs.CreateMassPoint(referencePosition=[1.3, 0, 0], physicsMass=MASS)
    mbs.CreateCartesianSpringDamper(
        bodyNumbers=[ground, mass], localPosition0=[1, 0, 0], stiffness=[STIFFNESS] * 3, damping=[DAMPING] * 3
    )
    if force is not None:
        mbs.CreateForce(bodyNumber=mass, loadVectorUserFunction=force)
    mbs.Assemble()
    return mbs, mass


def test_energy_of_a_damper(tmp_path: Path) -> None:
    """The initial energy of the spring, less the remainder; trapezoidal rule with 2000 steps."""
    mbs, _ = oscillator()
    found = solved(mbs, settings(2, 2000), tmp_path)
    assert len(found.times) == 2001 and found.times[-1] == pytest.approx(2)
    total = found.kinetic + found.potential
    assert total[0] == pytest.approx(0, abs=1e-12)  # potential energy counts from the reference configuration
    stored = STIFFNESS * 0.3**2 / 2
    assert found.dissipated[-1] == pytest.approx(-total[-1], abs=1e-5 * stored)
    assert 0.9 * stored < found.dissipated[-1] < stored and np.abs(found.supplied).max() < 1e-5 * stored
    assert found.gaps == {} and "supplied" in str(found)


def test_energy_of_a_motor(tmp_path: Path) -> None:
    """A force of 5 N that grows with time: the work along the way."""

    def force(mbs: Any, t: float, load: list[float]) -> list[float]:
        return [5 * t, 0, 0]

    mbs, mass = oscillator(force)
    sensor = mbs.AddSensor(
        exu.SensorBody(bodyNumber=mass, outputVariableType=Variable.Displacement, storeInternal=True)
    )
    mbs.Assemble()
    s = settings(1, 2000)
    s.solutionSettings.sensorsWritePeriod = 0
    found = solved(mbs, s, tmp_path)
    times, way = mbs.GetSensorStoredData(sensor)[:, :2].T
    forces = 5 * times
    work = np.sum((forces[1:] + forces[:-1]) / 2 * np.diff(way))
    # The load counts as potential -F(t) u at each time; stored energy is not supplied work.
    supplied = found.supplied[-1] + 5 * times[-1] * way[-1]
    assert supplied == pytest.approx(work, rel=1e-4) and abs(work) > 0.01


def test_which_joint_drifts(tmp_path: Path) -> None:
    """Constraints of velocities alone, with large steps: the gap of the hinge grows; constraints of positions keep it."""

    def pendulum(solver: Any) -> Any:
        mbs = new_system()
        ground = mbs.CreateGround()
        body = mbs.CreateRigidBody(
            inertia=InertiaCuboid(1000, [1, 0.1, 0.2]), referencePosition=[0.5, 0, 0], gravity=[0, -9.81, 0]
        )
        mbs.CreateRevoluteJoint(name="hinge", bodyNumbers=[ground, body], position=[0, 0, 0], axis=[0, 0, 1])
        mbs.Assemble()
        return solved(mbs, settings(1, 30), tmp_path, solver)

    drifting, kept = pendulum(Solver.TrapezoidalIndex2), pendulum(Solver.GeneralizedAlpha)
    item = next(iter(drifting.gaps))  # the largest first
    assert "'hinge'" in item and 0 < drifting.gaps[item].time <= 1
    assert abs(drifting.gaps[item].value) > 1e-3
    assert all(abs(drift.value) < 1e-8 for drift in kept.gaps.values())
    assert f"largest gap of {item}, equation {drifting.gaps[item].equation}" in str(drifting)


def test_wrong_solutions_are_refused(tmp_path: Path) -> None:
    mbs, _ = oscillator()
    s = settings(0.1, 10)
    s.solutionSettings.exportVelocities = False
    with pytest.raises(ValueError, match="exportVelocities=True"):
        solved(mbs, s, tmp_path)
    s.solutionSettings.exportVelocities = True
    solved(mbs, s, tmp_path)
    with pytest.raises(ValueError, match="every=0"):
        mbs.InspectSolution(tmp_path / "solution.txt", every=0)
