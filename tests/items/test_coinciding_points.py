"""Springs and rods between points that coincide: a direction follows from the relative velocity, or there is none."""

from __future__ import annotations

import numpy as np
import pytest

import dalembert as exu
from dalembert._core import testing

LENGTH, STIFFNESS, DAMPING, FORCE, OFFSET = 1.5, 100.0, 10.0, 3.0, 0.25
SPRING = {
    "referenceLength": LENGTH,
    "stiffness": STIFFNESS,
    "damping": DAMPING,
    "force": FORCE,
    "velocityOffset": OFFSET,
}


def law(mbs: object, t: float, item: int, deltaL: float, deltaL_t: float, k: float, d: float, f: float) -> float:
    return k * deltaL + d * deltaL_t + f


def springs(velocities: np.ndarray, functions: bool = False) -> tuple[exu.MainSystem, list[exu.ObjectIndex]]:
    """Two mass points at one position have one spring per velocity component; the second one moves."""
    mbs = exu.SystemContainer().AddSystem()
    made = []
    for velocity in velocities:
        ends = []
        for v in (np.zeros(3), velocity):
            node = mbs.AddNode(exu.NodePoint(referenceCoordinates=[1, 2, 3], initialVelocities=v))
            mbs.AddObject(exu.MassPoint(physicsMass=1, nodeNumber=node))
            ends.append(mbs.AddMarker(exu.MarkerNodePosition(nodeNumber=node)))
        function = law if functions else 0
        made.append(mbs.AddObject(exu.SpringDamper(markerNumbers=ends, springForceUserFunction=function, **SPRING)))
    mbs.Assemble()
    return mbs, made


def expected(velocity: np.ndarray) -> np.ndarray:
    speed = np.linalg.norm(velocity)
    if speed == 0:
        return np.zeros(3)
    return (FORCE - STIFFNESS * LENGTH + DAMPING * (speed - OFFSET)) * velocity / speed


@pytest.mark.parametrize("functions", [False, True], ids=["linear", "user function"])
def test_the_force_follows_the_relative_velocity(functions: bool) -> None:
    """Eleven springs fill lanes and leave a rest; some of them rest, and some are stretched."""
    velocities = np.random.default_rng(5).normal(size=(11, 3))
    velocities[[3, 8]] = 0
    mbs, made = springs(velocities, functions)
    state = testing.State(mbs)
    residual = testing.residual(mbs, state).reshape(11, 2, 3)
    for spring, velocity, (first, second) in zip(made, velocities, residual, strict=True):
        force = expected(velocity)
        np.testing.assert_allclose(first, -force, rtol=1e-14, atol=1e-13)  # forces stand on the left-hand side
        np.testing.assert_allclose(second, force, rtol=1e-14, atol=1e-13)
        output = mbs.GetObjectOutput(spring, exu.OutputVariableType.Force)
        np.testing.assert_allclose(output, force, rtol=1e-14, atol=1e-13)


@pytest.mark.parametrize("functions", [False, True], ids=["linear", "user function"])
def test_the_tangent_by_velocities_is_that_of_the_force(functions: bool) -> None:
    mbs, _ = springs(np.array([[0.4, -0.7, 0.2]]), functions)
    state = testing.State(mbs)
    tangent = testing.tangent(mbs, state, cq=0, cv=1, ca=0)
    step, v = 1e-6, state.v.copy()
    differences = np.empty((6, 6))
    for i in range(6):
        sides = []
        for sign in (1, -1):
            state.v = v + sign * step * np.eye(6)[i]
            sides.append(testing.residual(mbs, state))
        differences[:, i] = (sides[0] - sides[1]) / (2 * step)
    # Central differences: second order in the step, of entries of the size of force over speed, 200. User functions are
    # differentiated by differences as well.
    np.testing.assert_allclose(tangent, differences, rtol=0, atol=1e-5)


def test_a_spring_starts_where_its_points_part() -> None:
    """A relative velocity from rest determines the direction; energy is kept."""
    mbs, made = springs(np.array([[0.0, 2.0, 0.0]]))
    mbs.SetObjectParameter(made[0], "damping", 0)
    mbs.SetObjectParameter(made[0], "force", 0)
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps, settings.timeIntegration.endTime = 2000, 0.1
    settings.timeIntegration.generalizedAlpha.spectralRadius = 1
    mbs.SolveDynamic(settings)
    q, v = mbs.systemData.GetODE2Coordinates(), mbs.systemData.GetODE2Coordinates_t()
    span, rate = (q[3:] - q[:3])[1], (v[3:] - v[:3])[1]
    # Relative motion, reduced mass 1/2: u - L = A sin(w t) - L cos(w t) with w = sqrt(k / m) and u' = 2 at the start.
    w = np.sqrt(2 * STIFFNESS)
    assert span == pytest.approx(LENGTH + 2 / w * np.sin(0.1 * w) - LENGTH * np.cos(0.1 * w), rel=1e-5)
    assert rate == pytest.approx(2 * np.cos(0.1 * w) + LENGTH * w * np.sin(0.1 * w), rel=1e-5)


def test_a_rod_without_length_is_refused() -> None:
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.AddObject(exu.ObjectGround())
    node = mbs.AddNode(exu.NodePoint())
    mbs.AddObject(exu.MassPoint(physicsMass=1, nodeNumber=node))
    ends = [
        mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=ground)),
        mbs.AddMarker(exu.MarkerNodePosition(nodeNumber=node)),
    ]
    mbs.AddObject(exu.DistanceConstraint(markerNumbers=ends, distance=1))
    mbs.Assemble()
    with pytest.raises(ValueError, match=r"object 2 \(ObjectConnectorDistance\).*its markers coincide at time 0"):
        mbs.SolveDynamic()
