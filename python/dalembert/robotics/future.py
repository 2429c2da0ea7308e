"""Inverse kinematics in closed form of elbow manipulators, Puma-like robots and robots of Universal Robots.

Robots are dictionaries of robotics.models with standard Denavit-Hartenberg parameters; poses are those of the last link
against the base. All branches are returned, one per row, with angles between -pi and pi; rows of branches that do not
reach the pose are not a number. robotics.InverseKinematicsNumerical takes any robot, with its limits and tool.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import pi
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, as_transformation
from dalembert._geometry.rotations import RotationMatrix2RotZYZ
from dalembert.robotics.roboticsCore import StdDH2HT, projectAngleToPMPi

_SMALL = 1e-9  # sines below it count as zero


def _parameters(where: str, robotDic: dict[str, Any], twists: Sequence[float], lengths: Sequence[int]) -> FloatArray:
    """Return one row [theta, d, a, alpha] per link; ValueError for robots of another kind."""
    rows = np.array([link["stdDH"] for link in robotDic["links"]], dtype=float)
    if robotDic.get("dhMode", "stdDH") != "stdDH" or len(rows) != len(twists):
        raise ValueError(f"{where}: robotDic: expected {len(twists)} links with standard parameters (dhMode 'stdDH')")
    others = [i for i in range(len(rows)) if i not in lengths]
    if not np.allclose(rows[:, 3], twists, atol=1e-6) or np.any(rows[others, 2]) or np.any(rows[:, 0]):
        raise ValueError(
            f"{where}: robotDic: expected alpha {np.round(twists, 4).tolist()}, theta 0, and lengths a in links "
            f"{list(lengths)} only, received rows [theta, d, a, alpha] {rows.round(4).tolist()}"
        )
    return rows


def _between(rows: FloatArray, q: Sequence[float], first: int) -> FloatArray:
    """Return the transformation over some links, from the first of them."""
    T = np.eye(4)
    for row, angle in zip(rows[first:], q, strict=False):
        T = T @ StdDH2HT([angle, *row[1:]])
    return T


def _elbow(x: float, y: float, a: float, b: float, sign: int) -> tuple[float, float]:
    """Return the angles of two bars a and b that reach a point of their plane; sign is that of the second angle."""
    cosine = (x * x + y * y - a * a - b * b) / (2 * a * b)
    second = sign * float(np.arccos(cosine)) if abs(cosine) <= 1 else np.nan
    return float(np.arctan2(y, x) - np.arctan2(b * np.sin(second), a + b * np.cos(second))), second


def ComputeIK3R(robotDic: dict[str, Any], HT: npt.ArrayLike) -> FloatArray:
    """Return the 4 x 3 angles of an elbow manipulator whose last link reaches the position of HT.

    Rows: facing the point with the second angle positive, turned away and negative, facing it and negative, turned away
    and positive. A point on the first axis is faced with the first angle zero.
    """
    rows = _parameters("ComputeIK3R", robotDic, [pi / 2, 0, 0], (1, 2))
    x, y, z = as_transformation("ComputeIK3R: HT", HT)[:3, 3]
    radius, height = np.hypot(x, y), z - rows[0, 1]
    facing = float(np.arctan2(y, x)) if radius > _SMALL else 0.0
    solutions = []
    for side, sign in ((1, 1), (-1, -1), (1, -1), (-1, 1)):
        first = facing if side > 0 else facing + pi
        solutions.append([first, *_elbow(side * radius, height, rows[1, 2], rows[2, 2], sign)])
    return np.asarray(projectAngleToPMPi(solutions))


def ComputeIKPuma560(robotDic: dict[str, Any], HT: npt.ArrayLike) -> FloatArray:
    """Return the 8 x 6 angles of a robot with a spherical wrist like the Puma 560.

    Rows: left and right shoulder (four each); within these, elbow up and down (two each); then wrist flipped and not.
    If the fourth and sixth axis are in line, one of the angles of the wrist is zero.
    R. P. Paul, H. Zhang, Computationally efficient kinematics for manipulators with spherical wrists, Int. J. Robotics
    Research 5, 1986.
    """
    rows = _parameters("ComputeIKPuma560", robotDic, [pi / 2, 0, -pi / 2, pi / 2, -pi / 2, 0], (1, 2))
    T = as_transformation("ComputeIKPuma560: HT", HT)
    x, y, z = T[:3, 3] - rows[5, 1] * T[:3, 2]
    radius, side = np.hypot(x, y), rows[1, 1] + rows[2, 1]
    lean = float(np.arcsin(side / radius)) if radius >= abs(side) and radius > 0 else np.nan
    fore, bent = np.hypot(rows[2, 2], rows[3, 1]), np.arctan2(rows[3, 1], rows[2, 2])
    solutions = []
    for first in (np.arctan2(y, x) + pi - lean, np.arctan2(y, x) + lean):
        forward = np.cos(first) * x + np.sin(first) * y
        for sign in (-1, 1):
            second, third = _elbow(forward, z - rows[0, 1], rows[1, 2], fore, sign)
            arm = [float(first), second, third - float(bent)]
            for flip in (True, False):
                solutions.append([*arm, *_wrist(rows, arm, T[:3, :3], flip)])
    return np.asarray(projectAngleToPMPi(solutions))


def _wrist(rows: FloatArray, arm: list[float], A: FloatArray, flip: bool) -> list[float]:
    """Return the last three angles: Rz(q4) Ry(-q5) Rz(q6) is the remaining rotation after the arm."""
    if np.isnan(arm).any():
        return [np.nan] * 3
    a, b, c = RotationMatrix2RotZYZ(_between(rows, arm, 0)[:3, :3].T @ A, flip)
    return [float(a), -float(b), float(c)]


def ComputeIKUR(robotDic: dict[str, Any], HTdes: npt.ArrayLike) -> FloatArray:
    """Return the 8 x 6 angles of a robot like UR3, UR5 and UR10.

    Rows: left and right shoulder (four each); within these, the fifth angle positive and negative (two each); then the
    third positive and negative. If the last axis is parallel to the second, the sixth angle is zero.
    """
    rows = _parameters("ComputeIKUR", robotDic, [pi / 2, 0, 0, pi / 2, -pi / 2, 0], (1, 2))
    T = as_transformation("ComputeIKUR: HTdes", HTdes)
    x, y, _ = T[:3, 3] - rows[5, 1] * T[:3, 2]
    side, radius = rows[1:4, 1].sum(), np.hypot(x, y)
    lean = float(np.arccos(side / radius)) if radius >= abs(side) and radius > 0 else np.nan
    solutions = []
    for first in (np.arctan2(y, x) + pi / 2 + lean, np.arctan2(y, x) + pi / 2 - lean):
        z1 = np.array([np.sin(first), -np.cos(first), 0.0])  # the axis of the three joints of the arm
        cosine = (z1 @ T[:3, 3] - side) / rows[5, 1]
        tilt = float(np.arccos(np.clip(cosine, -1, 1))) if abs(cosine) <= 1 + _SMALL else np.nan
        for fifth in (tilt, -tilt):
            seen = T[:3, :3].T @ z1  # (s5 c6, -s5 s6, c5)
            sine = np.sign(fifth) if abs(np.sin(fifth)) > _SMALL else 0.0
            sixth = float(np.arctan2(-sine * seen[1], sine * seen[0])) if sine else 0.0 * fifth
            wrist = _between(rows, [fifth, sixth], 4)
            ahead = np.linalg.inv(_between(rows, [float(first)], 0)) @ T @ np.linalg.inv(wrist)
            for sign in (1, -1):
                arm = _elbow(ahead[0, 3], ahead[1, 3], rows[1, 2], rows[2, 2], sign)
                left = _between(rows, arm, 1)[:3, :3].T @ ahead[:3, :3]
                fourth = float(np.arctan2(left[1, 0], left[0, 0]))
                solutions.append([float(first), *arm, fourth, fifth, sixth])
    result = np.asarray(projectAngleToPMPi(solutions))
    result[np.isnan(result).any(axis=1)] = np.nan
    return result


def MakeCorkeRobot(robotDic: dict[str, Any]) -> Any:
    """Return the robot of a dictionary as DHRobot of the package roboticstoolbox-python, which it needs."""
    try:
        import roboticstoolbox as toolbox
    except ImportError:
        raise ImportError(
            "MakeCorkeRobot: the package roboticstoolbox-python is needed: pip install roboticstoolbox-python"
        ) from None
    if robotDic["dhMode"] == "stdDH":
        parameters = [link["stdDH"] for link in robotDic["links"]]
        links = [toolbox.RevoluteDH(d=d, a=a, alpha=alpha) for _, d, a, alpha in parameters]
    else:
        parameters = [link["modDHKK"] for link in robotDic["links"]]
        links = [toolbox.RevoluteMDH(d=r, a=d, alpha=alpha) for alpha, d, _, r in parameters]
    return toolbox.DHRobot(links)
