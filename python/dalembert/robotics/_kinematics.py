"""Kinematics of joints, for one state or many: the last axis of coordinates counts joints, axes before it count
states."""

from __future__ import annotations

from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert.robotics._parts import JOINT_AXES, RobotLink, is_revolute

_UNMOVED = np.eye(4)


def joint_transformation(jointType: str, q: FloatArray) -> FloatArray:
    """Return the 4x4 transformations of a joint with coordinates q, stacked as these are."""
    T = np.empty((*np.shape(q), 4, 4))
    T[...] = _UNMOVED
    axis = "xyz".index(jointType[1])
    if not is_revolute(jointType):
        T[..., axis, 3] = q
        return T
    first, second = (axis + 1) % 3, (axis + 2) % 3
    cosine, sine = np.cos(q), np.sin(q)
    T[..., first, first] = T[..., second, second] = cosine
    T[..., second, first], T[..., first, second] = sine, -sine
    return T


def joint_axis(link: RobotLink, T: FloatArray) -> FloatArray:
    """Return the axis of a joint in the global frame, from the transformation of the joint."""
    return np.asarray(T[..., :3, :3] @ JOINT_AXES[link.jointType])


_NEXT, _LAST = [1, 2, 0], [2, 0, 1]


def cross(a: Any, b: Any) -> FloatArray:
    """Return the vector products along the last axis; several times faster than numpy's for single vectors."""
    return np.asarray(a[..., _NEXT] * b[..., _LAST] - a[..., _LAST] * b[..., _NEXT])
