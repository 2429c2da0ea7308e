"""Rotations as three angles about axes that are chosen for a motion."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from dalembert._checks import FloatArray


def _about(axis: int, angle: float) -> FloatArray:
    turn, y, z = np.eye(3), (axis + 1) % 3, (axis + 2) % 3
    turn[[y, z], [y, z]] = np.cos(angle)
    turn[z, y] = np.sin(angle)
    turn[y, z] = -turn[z, y]
    return turn


@dataclass
class ThreeTurns:
    """Three rotations, one after the other, about different axes; the last is an axis of the body.

    They lock where the second has turned by 90 degrees: the last axis then lies along the first.
    """

    base: FloatArray  # axes of the first, where all angles are zero, in the frame of the carrier
    axes: tuple[int, int, int]

    @staticmethod
    def of(relative: FloatArray, spin: FloatArray, up: FloatArray, arm: FloatArray) -> ThreeTurns:
        """Choose axes far from gimbal lock, for given initial axes in the frame of the carrier.

        spin: the spin of the body, if it dominates the weight; up: direction against the weight, or zero; both in
        that frame.
        arm: vector from the joint to the body, in body axes; zero if there is none.
        The first axis is vertical if there is weight: the first and the last rotation are unlimited. The last axis is
        that
        of the spin, unless it is vertical, or else the most horizontal axis, except that of the arm, which may hang
        down.
        If there is no weight, the second axis is that of the arm, because bodies swing more than they twist.
        """
        fastest = int(np.abs(relative.T @ spin).argmax()) if spin.any() else None
        along = int(np.abs(arm).argmax()) if arm.any() else None
        if not up.any():
            last = fastest if fastest is not None else (2 if along is None else (along + 1) % 3)
            second = along if along not in (None, last) else (last + 1) % 3
            return ThreeTurns(relative, (3 - second - last, second, last))
        rise = np.abs(relative.T @ up)
        last = min((k for k in range(3) if k != along), key=lambda k: rise[k])
        if fastest is not None and rise[fastest] < np.sqrt(0.5):
            last = fastest
        level = relative[:, last] - up * (up @ relative[:, last])
        first, second, base = (last + 1) % 3, (last + 2) % 3, np.zeros((3, 3))
        base[:, first], base[:, last] = up, level / np.linalg.norm(level)
        base[:, second] = np.cross(base[:, (second + 1) % 3], base[:, (second + 2) % 3])
        return ThreeTurns(base, (first, second, last))

    def angles(self, relative: FloatArray) -> FloatArray:
        """Return the angles that lead to given axes in the frame of the carrier."""
        i, j, k = self.axes
        turn = self.base.T @ relative
        sign = 1.0 if (j - i) % 3 == 1 else -1.0  # turn = R_i(a) R_j(b) R_k(c)
        return np.array(
            [
                np.arctan2(-sign * turn[j, k], turn[k, k]),
                np.arctan2(sign * turn[i, k], np.hypot(turn[i, i], turn[i, j])),
                np.arctan2(-sign * turn[i, j], turn[i, i]),
            ]
        )

    def rates(self, angles: FloatArray, spin: FloatArray) -> FloatArray:
        """Return the rates of the angles for an angular velocity, in the frame of the carrier."""
        turn, columns = self.base, []
        for axis, angle in zip(self.axes, angles, strict=True):
            columns.append(turn[:, axis])
            turn = turn @ _about(axis, angle)
        return np.asarray(np.linalg.solve(np.column_stack(columns), spin))
