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
    def of(relative: FloatArray, spin: FloatArray, up: FloatArray) -> ThreeTurns:
        """Choose axes far from where they lock, for a start from given axes in the frame of the carrier.

        The first is vertical, if there is weight: bodies may turn about it as far as they like, and about the last.
        This is the one about which the body spins, unless that stands upright, or else the one that lies most level.
        """
        fastest = int(np.abs(relative.T @ spin).argmax())
        if not up.any():
            last = fastest
            base, first = relative, (last + 1) % 3
        else:
            rise = np.abs(relative.T @ up)
            last = fastest if spin.any() and rise[fastest] < np.sqrt(0.5) else int(rise.argmin())
            first = (last + 1) % 3
            level = relative[:, last] - up * (up @ relative[:, last])
            base = np.zeros((3, 3))
            base[:, first], base[:, last] = up, level / np.linalg.norm(level)
            second = 3 - first - last
            base[:, second] = np.cross(base[:, (second + 1) % 3], base[:, (second + 2) % 3])
        return ThreeTurns(base, (first, 3 - first - last, last))

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
