"""Explicit Euler moves large systems in one pass over memory: bit-identical to steps that evaluate their ends as
well."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert import itemInterface as eii

EULER = exu.DynamicSolverType.ExplicitEuler
STEPS, END = 20, 0.1


def settings(steps: int = STEPS, ends: bool = False, threads: int = 1) -> Any:
    result = exu.SimulationSettings()
    result.solutionSettings.writeSolutionToFile = False
    result.parallel.numberOfThreads = threads
    time = result.timeIntegration
    time.endTime, time.numberOfSteps, time.verboseMode = END, steps, 0
    time.explicitIntegration.computeEndOfStepAccelerations = ends
    return result


def points(count: int) -> Any:
    """Points on springs to the ground, which swing with their own frequencies."""
    rng, mbs = np.random.default_rng(count), exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    for place, speed, mass in zip(
        rng.uniform(-1, 1, (count, 3)), rng.uniform(-1, 1, (count, 3)), rng.uniform(1, 2, count), strict=True
    ):
        body = mbs.CreateMassPoint(referencePosition=list(place), initialVelocity=list(speed), physicsMass=mass)
        mbs.CreateCartesianSpringDamper(bodyNumbers=[ground, body], stiffness=[100, 200, 300], damping=[1, 2, 3])
    mbs.Assemble()
    return mbs


def bodies(count: int, node: Any) -> Any:
    """Bodies that turn and are not round, on springs to the ground."""
    rng, mbs = np.random.default_rng(count), exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    for place, spin in zip(rng.uniform(-1, 1, (count, 3)), rng.uniform(-5, 5, (count, 3)), strict=True):
        body = mbs.CreateRigidBody(
            referencePosition=list(place), initialAngularVelocity=list(spin), nodeType=node,
            inertia=exu.utilities.InertiaCuboid(1000, [0.1, 0.2, 0.3]), gravity=[0, 0, -9.81],
        )  # fmt: skip
        mbs.CreateCartesianSpringDamper(
            bodyNumbers=[ground, body], localPosition1=[0, 0, 0.05], stiffness=[1e3, 2e3, 3e3]
        )
    mbs.Assemble()
    return mbs


def motion(mbs: Any, **options: Any) -> tuple[bytes, bytes]:
    mbs.SolveDynamic(settings(**options), solverType=EULER)
    data = mbs.systemData
    return data.GetODE2Coordinates().tobytes(), data.GetODE2Coordinates_t().tobytes()


@pytest.mark.parametrize("count", [2, 3, 5, 41, 3500])
def test_points_move_as_with_ends_that_are_evaluated(count: int) -> None:
    """Numbers of coordinates that fill registers and that do not; one is large enough for threads."""
    found = motion(points(count), ends=True)
    for threads in (1, 2, 3) if count > 1000 else (1,):
        assert motion(points(count), threads=threads) == found


@pytest.mark.parametrize("node", [exu.NodeType.RotationRotationVector, exu.NodeType.RotationEulerParameters])
@pytest.mark.parametrize("count", [3, 50])
def test_bodies_move_as_with_ends_that_are_evaluated(node: Any, count: int) -> None:
    assert motion(bodies(count, node)) == motion(bodies(count, node), ends=True)


def test_accelerations_are_those_at_the_start_of_the_last_step() -> None:
    mbs, before = points(10), points(10)
    mbs.SolveDynamic(settings(), solverType=EULER)
    shorter = settings(STEPS - 1, ends=True)
    shorter.timeIntegration.endTime = END * (STEPS - 1) / STEPS
    before.SolveDynamic(shorter, solverType=EULER)
    np.testing.assert_allclose(
        mbs.systemData.GetODE2Coordinates_tt(), before.systemData.GetODE2Coordinates_tt(), rtol=1e-12
    )


@pytest.mark.parametrize("steps", [1, 2, 5])
def test_views_show_the_configuration_that_they_were_asked_for(steps: int) -> None:
    """States change places at each step only where nobody looks at them."""
    mbs, alone = points(10), points(10)
    data, current, start = mbs.systemData, exu.ConfigurationType.Current, exu.ConfigurationType.StartOfStep
    views = [data.GetODE2Coordinates(current, copy=False), data.GetODE2Coordinates_t(current, copy=False)]
    before = data.GetODE2Coordinates(start, copy=False)
    assert motion(mbs, steps=steps) == motion(alone, steps=steps)
    assert tuple(view.tobytes() for view in views) == (
        data.GetODE2Coordinates().tobytes(),
        data.GetODE2Coordinates_t().tobytes(),
    )
    assert before.tobytes() == alone.systemData.GetODE2Coordinates(start).tobytes()
    assert steps == 1 or before.tobytes() != views[0].tobytes()


def test_an_energy_that_grows_is_seen() -> None:
    """Explicit Euler multiplies energies by 1 + (h omega)^2 at each step without damping."""
    mbs = points(10)
    coarse = settings(400)
    coarse.timeIntegration.endTime = 400.0
    with pytest.raises(exu.SolverError, match="grows with these steps"):
        mbs.SolveDynamic(coarse, solverType=EULER)


def test_failed_evaluations_leave_the_last_step() -> None:
    """Two balls fly through each other; contact refuses the step in which they have one centre."""
    mbs = exu.SystemContainer().AddSystem()
    contact = mbs.AddGeneralContact()
    contact.SetFrictionPairings([[0.0]])
    for k in range(4):
        body = mbs.CreateMassPoint(referencePosition=[k, 0, 0], initialVelocity=[-k, 0, 0], physicsMass=1)
        marker = mbs.AddMarker(eii.MarkerBodyPosition(bodyNumber=body))
        contact.AddSphereWithMarker(
            marker, radius=1e-3, contactStiffness=1e-9, contactDamping=0, frictionMaterialIndex=0
        )
    mbs.Assemble()
    steps = settings(16)
    steps.timeIntegration.endTime = 2.0  # steps of 1/8: all are at the origin after eight steps
    with pytest.raises(ValueError, match="one and the same centre"):
        mbs.SolveDynamic(steps, solverType=EULER)
    data = mbs.systemData
    assert data.GetTime() == 1.0
    assert data.GetODE2Coordinates()[::3].tolist() == [-k for k in range(4)]
    assert data.GetODE2Coordinates_t()[::3].tolist() == [-k for k in range(4)]
