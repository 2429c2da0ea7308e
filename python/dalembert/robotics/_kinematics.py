"""Kinematics of joints, for one state or many: the last axis of coordinates counts joints, axes before it count
states."""

from __future__ import annotations

import numpy as np

from dalembert._checks import FloatArray
from dalembert.robotics._parts import is_revolute

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
