"""Inverse kinematics in closed form: all rows reach the pose, and one of them is where the pose was made."""

from __future__ import annotations

import sys
from types import SimpleNamespace

import numpy as np
import pytest

from dalembert.rigidBodyUtilities import HTtranslate
from dalembert.robotics import future, models, projectAngleToPMPi

CASES = {
    "ComputeIK3R": ("Manipulator3RSimple", 4),
    "ComputeIKPuma560": ("ManipulatorPuma560", 8),
    "ComputeIKUR": ("ManipulatorUR5", 8),
}


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("seed", range(20))
def test_all_branches_reach_the_pose(name, seed):
    model, count = CASES[name]
    data = getattr(models, model)()
    robot = models.LinkDict2Robot(data)
    q = np.random.default_rng(seed).uniform(-np.pi, np.pi, len(robot.links))
    goal = robot.LinkHT(q)[-1]
    solutions = getattr(future, name)(data, goal)
    assert solutions.shape == (count, len(q))
    reached = solutions[~np.isnan(solutions).any(axis=1)]
    assert len(reached) >= 2
    compared = slice(None) if len(q) == 6 else (slice(0, 3), 3)  # three joints reach a position
    for row in reached:
        np.testing.assert_allclose(robot.LinkHT(row)[-1][compared], goal[compared], atol=1e-8)
    assert np.abs(projectAngleToPMPi(reached - q)).max(axis=1).min() < 1e-7
    differences = np.abs(projectAngleToPMPi(reached[:, None] - reached)).max(axis=2)
    assert (differences + np.eye(len(reached)) > 1e-6).all()


@pytest.mark.parametrize("name", CASES)
def test_poses_out_of_reach_are_not_a_number(name):
    data = getattr(models, CASES[name][0])()
    assert np.isnan(getattr(future, name)(data, HTtranslate([3, 0, 0]))[:, 1:]).any(axis=1).all()


def test_wrists_in_line():
    """An angle is arbitrary if axes coincide: it is zero, and the pose is reached."""
    for name, model in (("ComputeIKPuma560", "ManipulatorPuma560"), ("ComputeIKUR", "ManipulatorUR5")):
        data = getattr(models, model)()
        robot = models.LinkDict2Robot(data)
        goal = robot.LinkHT([0.3, -0.7, 0.9, 0.2, 0, 0.4])[-1]
        solutions = getattr(future, name)(data, goal)
        errors = [np.abs(robot.LinkHT(row)[-1] - goal).max() for row in solutions if not np.isnan(row).any()]
        assert min(errors) < 1e-7


def test_other_robots_are_refused():
    with pytest.raises(ValueError, match="ComputeIKUR: robotDic: expected 6 links with standard parameters"):
        future.ComputeIKUR(models.Manipulator3RSimple(), np.eye(4))
    with pytest.raises(ValueError, match=r"ComputeIKUR: robotDic: expected alpha \[1.5708, 0.0, 0.0, 1.5708"):
        future.ComputeIKUR(models.ManipulatorPuma560(), np.eye(4))
    with pytest.raises(ValueError, match="ComputeIK3R: robotDic: expected 3 links"):
        future.ComputeIK3R(models.ManipulatorPANDA(), np.eye(4))


def test_robots_for_the_toolbox(monkeypatch):
    monkeypatch.setitem(sys.modules, "roboticstoolbox", None)
    with pytest.raises(ImportError, match="the package roboticstoolbox-python is needed"):
        future.MakeCorkeRobot(models.ManipulatorUR5())
    recorder = SimpleNamespace(RevoluteDH=dict, RevoluteMDH=lambda **values: ("modified", values), DHRobot=list)
    monkeypatch.setitem(sys.modules, "roboticstoolbox", recorder)
    assert future.MakeCorkeRobot(models.ManipulatorUR5())[1] == {"d": 0, "a": -0.425, "alpha": 0}
    assert future.MakeCorkeRobot(models.ManipulatorPANDA())[6] == (
        "modified",
        {"d": 0.107, "a": 0.088, "alpha": np.pi / 2},
    )
