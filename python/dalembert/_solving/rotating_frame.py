"""Velocities and accelerations of all coordinates of a system that rotates steadily, and their derivatives."""

from __future__ import annotations

from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._core import ConfigurationType

_NAME = "ComputeVibrationModes"
_RELATIVE = {
    "FFRFreducedOrder": 1,
    "FFRF": 1,
    "ALEANCFCable2D": 2,
}  # their nodes from this one on: steady in the rotating frame
_VECTORS = {"Point": 3, "PointSlope1": 3, "PointSlope12": 3, "PointSlope23": 3, "Point2D": 2, "Point2DSlope1": 2}


def _cross(w: FloatArray) -> FloatArray:
    return np.array([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])


class RotatingFrame:
    """Velocities V and accelerations A of all coordinates if everything rotates; they change with the coordinates.

    A state seen from the rotating frame moves by x: rates are V + V' x + x_t, accelerations A + A' x + 2 V' x_t + x_tt.
    Lie-group rotations, which are increments in the axes of the node, have the accelerations x_tt + V' x_t.
    """

    def __init__(self, mbs: Any, speed: FloatArray, center: FloatArray) -> None:
        self.mbs, self.speed, self.center = mbs, speed, center
        self.reference = np.array(mbs.systemData.GetODE2Coordinates(ConfigurationType.Reference))
        items = [mbs.GetObject(number) for number in range(mbs.systemData.NumberOfObjects())]
        relative = {
            int(node)
            for item in items
            if (first := _RELATIVE.get(item["objectType"])) is not None
            for node in item["nodeNumbers"][first:]
        }
        self.moving = [
            node
            for node in range(mbs.systemData.NumberOfNodes())
            if mbs.systemData.GetNodeLTGODE2(node) and node not in relative
        ]
        self.nodes = [(mbs.GetNode(i)["nodeType"], np.array(mbs.systemData.GetNodeLTGODE2(i))) for i in self.moving]
        self.rotates = bool(speed.any())
        if self.rotates:
            self._check()

    def _check(self) -> None:
        known = {*_VECTORS, "RigidBody2D", "RigidBodyEP", "RigidBodyRotVecLG"}
        planar = bool(self.speed[:2].any())
        received = f"{_NAME}: angularVelocity: received {self.speed.tolist()} with"
        for node in self.moving:
            kind = self.mbs.GetNode(node)["nodeType"]
            if kind not in known:
                raise ValueError(
                    f"{received} node {node} ({kind}), whose rotation with the frame is not defined; expected nodes of "
                    + ", ".join(sorted(known))
                )
            if planar and kind in ("Point2D", "Point2DSlope1", "RigidBody2D"):
                raise ValueError(
                    f"{received} node {node} ({kind}), which stays in its plane; expected a rotation about z"
                )

    def blocks(self, q: FloatArray) -> Any:
        """Yield, of each part of a node, its coordinates, V, V', A, A', and the factor of V' x_t in accelerations."""
        spin = _cross(self.speed)
        total = self.reference + q
        for kind, numbers in self.nodes:
            size = _VECTORS.get(kind, 2 if kind == "RigidBody2D" else 3)
            turn = spin[:size, :size]
            count = len(numbers) // size if kind in _VECTORS else 1
            for i in range(count):
                part = numbers[i * size : (i + 1) * size]
                vector = total[part] - (self.center[:size] if i == 0 else 0)
                yield part, turn @ vector, turn, turn @ turn @ vector, turn @ turn, 2
            if kind == "RigidBody2D":
                yield numbers[2:], self.speed[2:], np.zeros((1, 1)), np.zeros(1), np.zeros((1, 1)), 2
            if kind == "RigidBodyEP":
                w = self.speed / 2
                turn = np.block([[np.zeros((1, 1)), -w[None, :]], [w[:, None], _cross(w)]])
                yield numbers[3:], turn @ total[numbers[3:]], turn, turn @ turn @ total[numbers[3:]], turn @ turn, 2
            if kind == "RigidBodyRotVecLG":
                from scipy.spatial.transform import Rotation

                local = Rotation.from_rotvec(total[numbers[3:]]).as_matrix().T @ self.speed
                yield numbers[3:], local, _cross(local), np.zeros(3), np.zeros((3, 3)), 1

    def apply(self, state: Any) -> tuple[Any, Any, Any]:
        """Set V and A of the state; return V', A', and the factor of x_t in accelerations."""
        from scipy.sparse import csr_array

        n = len(state.q)
        if not self.rotates:
            state.v = state.a = np.zeros(n)
            none = csr_array((n, n))
            return none, none, none
        v, a = np.zeros(n), np.zeros(n)
        entries: list[list[FloatArray]] = [[], [], []]
        rows, columns = [], []
        for part, v_part, v_by, a_part, a_by, factor in self.blocks(np.array(state.q)):
            v[part], a[part] = v_part, a_part
            rows.append(np.repeat(part, len(part)))
            columns.append(np.tile(part, len(part)))
            for values, block in zip(entries, (v_by, a_by, factor * v_by), strict=True):
                values.append(block.ravel())
        state.v, state.a = v, a
        places = (np.concatenate(rows), np.concatenate(columns))
        by = [csr_array((np.concatenate(values), places), shape=(n, n)) for values in entries]
        return by[0], by[1], by[2]
