"""Robots of arbitrary links, for tests."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from dalembert.robotics import Robot, RobotBase, RobotLink, RobotTool

ALL_JOINTS = ("Rx", "Py", "Rz", "Ry", "Px", "Pz", "Rz")


def placed(rng):
    """Return a transformation."""
    T = np.eye(4)
    T[:3, :3] = Rotation.random(rng=rng).as_matrix()
    T[:3, 3] = rng.uniform(-0.5, 0.5, 3)
    return T


def arbitrary(joints=ALL_JOINTS, seed=0, branches=False, **values):
    """Return a robot with these joints, frames anywhere, on a base that is turned and shifted."""
    rng = np.random.default_rng(seed)
    robot = Robot(gravity=rng.normal(size=3), base=RobotBase(placed(rng)), tool=RobotTool(placed(rng)))
    for i, joint in enumerate(joints):
        a = 0.2 * rng.normal(size=(3, 3))
        robot.AddLink(
            RobotLink(
                mass=rng.uniform(1, 2),
                COM=rng.uniform(-0.3, 0.3, 3),
                inertia=np.trace(a @ a.T) * np.eye(3) - a @ a.T + 0.05 * np.eye(3),
                localHT=placed(rng),
                preHT=placed(rng),
                jointType=joint,
                parent=int(rng.integers(-1, i)) if branches and i else -2,
                name=f"link{i}",
                jointName=f"joint{i}",
                **values,
            )
        )
    return robot
