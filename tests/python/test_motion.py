"""Trajectories: closed forms of their profiles, limits, and continuity."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.interpolate import PPoly

from dalembert.robotics.motion import (
    BasicProfileLinearAcceleration,
    ProfileConstantAcceleration,
    ProfileLinearAccelerationsList,
    ProfilePTP,
    Trajectory,
)

TIMES = np.linspace(-0.2, 4.2, 2201)


def sampled(trajectory, times=TIMES):
    """Return coordinates, velocities and accelerations as arrays with one row per time."""
    return (np.array(values) for values in zip(*(trajectory.Evaluate(t) for t in times), strict=True))


def mixed():
    trajectory = Trajectory([0.1, -0.2], initialTime=0.3, maxVelocities=[1.5, 0.7], maxAccelerations=[4, 5])
    trajectory.Add(ProfilePTP([1, 0.4], syncAccTimes=False))
    trajectory.Add(ProfileConstantAcceleration([-0.5, -0.2], 0.8))
    trajectory.Add(ProfilePTP([0.2, 1.0], maxAccelerations=[2, 9]))
    return trajectory


def test_constant_acceleration():
    """Half the way at the middle, with the largest velocity 2 d / T; acceleration 4 d / T^2."""
    trajectory = Trajectory([1.0, 2.0], initialTime=1)
    trajectory.Add(ProfileConstantAcceleration([2.0, -1.0], 2))
    distance = np.array([1, -3])
    for t, wanted in {
        1.5: ([1, 2] + distance / 8, distance / 2, distance),
        2.0: ([1.5, 0.5], distance, -distance),
        2.5: ([1, 2] + distance * 7 / 8, distance / 2, -distance),
        0.5: ([1, 2], [0, 0], [0, 0]),
        9.0: ([2, -1], [0, 0], [0, 0]),
    }.items():
        np.testing.assert_allclose(trajectory.Evaluate(t), wanted, err_msg=str(t))


def test_point_to_point_with_and_without_a_phase_of_constant_velocity():
    """d / v + v / a where the velocity v is reached, else 2 sqrt(d / a)."""
    for distance, duration in ((2.0, 2 / 0.5 + 0.5 / 4), (0.01, 2 * np.sqrt(0.01 / 4))):
        for synchronous in (True, False):
            trajectory = Trajectory([1.0], 0, [0.5], [4])
            trajectory.Add(ProfilePTP([1.0 - distance], synchronous))
            assert trajectory.GetTimes() == pytest.approx([0, duration])


@pytest.mark.parametrize("synchronous", [True, False])
def test_coordinates_arrive_together_and_within_limits(synchronous):
    limits = np.array([0.8, 2, 1]), np.array([3, 4, 5])
    trajectory = Trajectory([0, 0, 1], 0, *limits)
    trajectory.Add(ProfilePTP([1, -2, 1], synchronous))
    profile = trajectory[0]
    s, v, a = sampled(trajectory)
    np.testing.assert_allclose(s[-1], [1, -2, 1])
    for values, limit in zip((v, a), limits, strict=True):
        assert (np.abs(values) <= limit * (1 + 1e-12)).all()
    assert profile.finalTime == pytest.approx(1 / 0.8 + 0.8 / 3 if not synchronous else 1 / 0.8 + 0.8 / 2)
    ramps = profile["accelerationTimes"][:2]
    assert (np.ptp(ramps) < 1e-12) == synchronous
    if synchronous:  # along the straight line
        np.testing.assert_allclose(s[:, 1], -2 * s[:, 0], atol=1e-12)


def test_velocities_and_accelerations_are_the_derivatives():
    trajectory = mixed()
    trajectory.Add(ProfileLinearAccelerationsList([(0, [1, 2]), (0.5, [-1, -2]), (0.8, [0, 1])]))
    s, v, a = sampled(trajectory)
    step = TIMES[1] - TIMES[0]
    smooth = np.abs(np.diff(a, axis=0)).max(axis=1) < 0.1  # accelerations jump where profiles change
    between = smooth[:-1] & smooth[1:]
    np.testing.assert_allclose(
        (np.diff(s, axis=0)[1:] - np.diff(s, axis=0)[:-1])[between] / step**2, a[1:-1][between], atol=1e-8
    )
    np.testing.assert_allclose(((s[2:] - s[:-2]) / (2 * step))[between], v[1:-1][between], atol=3e-5)
    assert np.abs(np.diff(s, axis=0)).max() < 5 * step  # no jumps


def test_accelerations_that_jump():
    """1 m/s^2 for 1 s and -1 m/s^2 for 1 s: 1 m, and no velocity at the end."""
    profile = BasicProfileLinearAcceleration([0], 0.0, [(0, [1]), (1, [1]), (1, [-1]), (2, [-1])])
    np.testing.assert_allclose(np.ravel(profile.Evaluate(2.0))[:2], [1, 0], atol=1e-14)
    np.testing.assert_allclose(np.ravel(profile.Evaluate(0.999))[2], 1)
    np.testing.assert_allclose(np.ravel(profile.Evaluate(1.001))[2], -1)


def test_linear_accelerations():
    """Against the integral of the piecewise polynomial."""
    times, accelerations = np.array([0, 0.4, 1.0]), np.array([[0.0, 1.0], [3, -2], [-1, 0]])
    slopes = np.diff(accelerations, axis=0) / np.diff(times)[:, None]
    a = PPoly(np.array([slopes, accelerations[:-1]]), times)
    v = a.antiderivative()
    s = v.antiderivative()
    profile = BasicProfileLinearAcceleration([1, 2], 5.0, list(zip(times, accelerations, strict=True)))
    assert profile.finalTime == 6.0
    for t in (0, 0.2, 0.4, 0.7, 1.0):
        np.testing.assert_allclose(profile.Evaluate(5 + t), [[1, 2] + s(t), v(t), a(t)], atol=1e-14)
    np.testing.assert_allclose(profile.GetFinalCoordinates(), [1, 2] + s(1.0))
    np.testing.assert_allclose(dict(profile)["distances"], s(1.0))


def test_one_coordinate_alone():
    trajectory = mixed()
    for t in np.linspace(-1, 5, 61):
        alone = [trajectory.EvaluateCoordinate(t, i) for i in range(2)]
        np.testing.assert_array_equal(np.array(trajectory.Evaluate(t)).T, alone)
    assert len(trajectory) == 3 and [profile.finalTime for profile in trajectory] == trajectory.GetTimes()[1:]
    assert Trajectory([3.0]).Evaluate(1.0)[0] == [3.0]


def test_no_way_to_go():
    trajectory = Trajectory([1.0, 2.0], maxAccelerations=[1, 1])
    for synchronous in (True, False):
        trajectory.Add(ProfilePTP([1.0, 2.0], synchronous))
    assert trajectory.GetTimes() == [0, 0, 0]
    np.testing.assert_array_equal(trajectory.Evaluate(0.0), [[1, 2], [0, 0], [0, 0]])


def test_invalid_trajectories_are_rejected():
    with pytest.raises(ValueError, match="Trajectory: maxVelocities: expected positive numbers"):
        Trajectory([0], maxVelocities=[0])
    trajectory = Trajectory([0, 0])
    with pytest.raises(TypeError, match="Trajectory.Add: profile: expected a profile, .* received 5"):
        trajectory.Add(5)
    with pytest.raises(ValueError, match="ProfilePTP: no limits of acceleration; give maxAccelerations"):
        trajectory.Add(ProfilePTP([1, 1]))
    with pytest.raises(ValueError, match="ProfilePTP: maxAccelerations: expected 2 numbers, one per coordinate"):
        trajectory.Add(ProfilePTP([1, 1], maxAccelerations=[1, 2, 3]))
    with pytest.raises(
        ValueError, match="ProfileConstantAcceleration: coordinates: expected a vector with 3 components"
    ):
        trajectory.Add(ProfileConstantAcceleration([1, 2, 3], 1))
    with pytest.raises(ValueError, match="expected times that start with zero and do not decrease, received"):
        ProfileLinearAccelerationsList([(0, [1]), (-1, [2])])
    with pytest.raises(ValueError, match="expected at least two pairs of time and accelerations"):
        ProfileLinearAccelerationsList([(0, [1])])
