"""Measures of manipulability against their definitions."""

from __future__ import annotations

import numpy as np
import pytest
from robots import arbitrary

from dalembert.robotics import special
from dalembert.robotics.models import LinkDict2Robot, Manipulator3RSimple, ManipulatorPuma560


def test_elbow_manipulator():
    """det J = l2 l3 sin(q3) (l2 cos(q2) + l3 cos(q2 + q3)) of the arm with two bars of 0.5 m."""
    robot = LinkDict2Robot(Manipulator3RSimple())
    q = [0.3, 0.4, 0.9]
    volume = 0.25 * np.sin(q[2]) * 0.5 * (np.cos(q[1]) + np.cos(q[1] + q[2]))
    HT = robot.JointHT(q)
    assert special.VelocityManipulability(robot, HT, "trans") == pytest.approx(volume)
    assert special.ForceManipulability(robot, HT, "trans") == pytest.approx(1 / volume)
    assert special.VelocityManipulability(robot, robot.JointHT([0, 0.2, 0]), "trans") == pytest.approx(0, abs=1e-8)


def test_singular_configurations_have_the_weight_that_is_given():
    robot = LinkDict2Robot(Manipulator3RSimple())
    HT = robot.JointHT([0, 0, 0])
    HT[0][:3, 3] = HT[1][:3, 3] = HT[2][:3, 3] = (HT[2] @ robot.links[2].localHT)[:3, 3]  # no arm, no motion
    assert special.ForceManipulability(robot, HT, "trans", singularWeight=7) == 7
    smallest, matrix = special.StiffnessManipulability(robot, np.eye(3), HT, "trans", singularWeight=7)
    assert (matrix == 7).all() and smallest == pytest.approx(0, abs=1e-12)


@pytest.mark.parametrize("robot", [arbitrary(("Rz", "Ry", "Px", "Rz", "Rx", "Ry"), seed=1), arbitrary(seed=2)])
def test_mass_matrix_of_jacobians(robot):
    q = np.linspace(-1, 1, robot.NumberOfLinks())
    HT = robot.JointHT(q)
    jacobians = special.JointJacobian(robot, HT, robot.LinkHT(q))
    np.testing.assert_allclose(special.MassMatrix(robot, HT, jacobians), robot.MassMatrix(q), atol=1e-12)


def test_stiffness_and_acceleration_of_the_tool():
    """A force on the tool bends the joints; torques at their limits accelerate it to the border of the ellipsoid."""
    data = ManipulatorPuma560()
    robot = LinkDict2Robot(data)
    q = np.array([0.2, 0.5, -0.9, 0.3, 0.8, -0.4])
    HT = robot.JointHT(q)
    J = robot.Jacobian(HT)
    results = special.CalculateAllMeasures(robot, data, q, "all", [1, 1, 1, 1])
    force = np.array([1.0, -2, 3, 0.1, 0.2, -0.3])
    bent = J @ np.linalg.solve(data["jointStiffnessMatrix"], J.T @ force)
    np.testing.assert_allclose(results[3] @ bent, force, rtol=1e-9)
    assert results[2] == pytest.approx(np.linalg.eigvalsh(results[3]).min())
    torques = data["joinTorqueMaxMatrix"] @ (force / np.linalg.norm(force))
    acceleration = J @ np.linalg.solve(robot.MassMatrix(q), torques)
    assert acceleration @ results[5] @ acceleration == pytest.approx(1)
    assert results[0] * results[1] == pytest.approx(1)
    assert special.CalculateAllMeasures(robot, data, q, "trans") == [[]] * 6
    with pytest.raises(ValueError, match="flag: expected 4 numbers that are 0 or 1, received"):
        special.CalculateAllMeasures(robot, data, q, "trans", [1])
