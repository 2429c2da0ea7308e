"""Measures of how well a robot moves, pushes, holds and accelerates its tool in a configuration.

mode says which part of the Jacobian counts: 'trans', 'rot' or 'all'. HT is the result of Robot.JointHT.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, as_matrix
from dalembert.robotics.roboticsCore import Robot


def VelocityManipulability(robot: Robot, HT: Sequence[FloatArray], mode: str) -> float:
    """Return sqrt(det(J J')): the volume of velocities of the tool per unit velocity of the joints.

    T. Yoshikawa, Manipulability of robotic mechanisms, Int. J. Robotics Research 4, 1985.
    """
    J = robot.Jacobian(HT, mode=mode)
    return float(np.sqrt(max(0.0, np.linalg.det(J @ J.T))))


def ForceManipulability(robot: Robot, HT: Sequence[FloatArray], mode: str, singularWeight: float = 100) -> float:
    """Return 1 / sqrt(det(J J')), the volume of forces; singularWeight in singular configurations."""
    volume = VelocityManipulability(robot, HT, mode)
    return 1.0 / volume if volume > 0.0 else float(singularWeight)


def _smallest(inverse: FloatArray, singularWeight: float) -> list[Any]:
    """Return the smallest eigenvalue of the inverse of a matrix, and the inverse; singularWeight if it is singular."""
    try:
        matrix = np.linalg.inv(inverse)
    except np.linalg.LinAlgError:
        matrix = np.full(inverse.shape, float(singularWeight))
    return [float(np.linalg.eigvals(matrix).real.min()), matrix]


def StiffnessManipulability(
    robot: Robot, JointStiffness: npt.ArrayLike, HT: Sequence[FloatArray], mode: str, singularWeight: float = 1000
) -> list[Any]:
    """Return [smallest eigenvalue, matrix] of the stiffness that the tool has on elastic joints.

    JointStiffness is the matrix of the joints (Nm/rad or N/m). The tool cannot move in some direction of a singular
    configuration; all entries of the matrix are then singularWeight.
    """
    J = robot.Jacobian(HT, mode=mode)
    stiffness = as_matrix("StiffnessManipulability: JointStiffness", JointStiffness, (len(HT), len(HT)))
    return _smallest(J @ np.linalg.solve(stiffness, J.T), singularWeight)


def JointJacobian(robot: Robot, HTJoint: Sequence[FloatArray], HTLink: Sequence[FloatArray]) -> list[FloatArray]:
    """Return for each link the Jacobians [rotation, translation] of its centre of mass, in the axes of the link."""
    result = []
    for i, (place, link) in enumerate(zip(robot.COMHT(HTJoint), HTLink, strict=True)):
        J = robot.Jacobian(HTJoint, place[:3, 3], linkIndex=i)
        axes = link[:3, :3].T
        result.append(np.array([axes @ J[3:], axes @ J[:3]]))
    return result


def MassMatrix(robot: Robot, HT: Sequence[FloatArray], jointJacobian: Sequence[FloatArray]) -> FloatArray:
    """Return the mass matrix from the result of JointJacobian; Robot.MassMatrix needs coordinates only."""
    M = np.zeros((len(robot.links), len(robot.links)))
    for link, (rotation, translation) in zip(robot.links, jointJacobian, strict=True):
        M += rotation.T @ link.inertia @ rotation + link.mass * translation.T @ translation
    return M


def DynamicManipulability(
    robot: Robot,
    HT: Sequence[FloatArray],
    MassMatrix: npt.ArrayLike,
    Tmax: npt.ArrayLike,
    mode: str,
    singularWeight: float = 1000,
) -> list[Any]:
    """Return [smallest eigenvalue, matrix N]: accelerations a of the tool within the torques have a' N a <= 1.

    Tmax is the diagonal matrix of the largest torques. All entries are singularWeight in singular configurations.
    P. Chiacchio, M. Concilio, The dynamic manipulability ellipsoid for redundant manipulators, IEEE ICRA, 1998.
    """
    n = len(HT)
    J = robot.Jacobian(HT, mode=mode)
    scaled = np.linalg.solve(
        as_matrix("DynamicManipulability: Tmax", Tmax, (n, n)),
        as_matrix("DynamicManipulability: MassMatrix", MassMatrix, (n, n)),
    )
    reach = np.linalg.solve(scaled.T, J.T)  # J inv(scaled' scaled) J' is its square
    return _smallest(reach.T @ reach, singularWeight)


def CalculateAllMeasures(
    robot: Robot, robotDic: dict[str, Any], q: npt.ArrayLike, mode: str, flag: Sequence[int] = [0, 0, 0, 0]
) -> list[Any]:
    """Return [velocity, force, stiffness, its matrix, acceleration, its matrix] of a robot and its dictionary.

    Each of the four flags that is zero omits a measure, which is [].
    """
    if len(flag) != 4:
        raise ValueError(f"CalculateAllMeasures: flag: expected 4 numbers that are 0 or 1, received {flag!r}")
    HT, links = robot.JointHT(q), robot.LinkHT(q)
    result: list[Any] = [[] for _ in range(6)]
    if flag[0]:
        result[0] = VelocityManipulability(robot, HT, mode)
    if flag[1]:
        result[1] = ForceManipulability(robot, HT, mode)
    if flag[2]:
        result[2:4] = StiffnessManipulability(robot, robotDic["jointStiffnessMatrix"], HT, mode)
    if flag[3]:
        M = MassMatrix(robot, HT, JointJacobian(robot, HT, links))
        result[4:6] = DynamicManipulability(robot, HT, M, robotDic["joinTorqueMaxMatrix"], mode)
    return result
