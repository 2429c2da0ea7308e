"""ODE2 coordinates in groups of one unit: positions, rotations and slopes of nodes, joints of trees, single ones."""

from __future__ import annotations

from typing import Any

import numpy as np

from dalembert._checks import FloatArray, IntArray
from dalembert._core import testing

_POSITIONS = {
    "Point": 3,
    "Point2D": 2,
    "PointSlope1": 3,
    "PointSlope12": 3,
    "PointSlope23": 3,
    "Point2DSlope1": 2,
    "RigidBody2D": 2,
    "RigidBodyEP": 3,
    "RigidBodyRxyz": 3,
    "RigidBodyRotVecLG": 3,
}
_OTHER, _LENGTH, _TURN = range(3)


class CoordinateParts:
    """The group of each coordinate. Sizes of groups do not depend on the units of others, or on rotation parameters."""

    def __init__(self, mbs: Any, state: Any) -> None:
        data = mbs.systemData
        testing.gaps(mbs, state)  # puts nodes where the state says, which the extent is that of
        self.extent = testing.extent(mbs)
        self.group: IntArray = np.arange(data.ODE2Size())
        kinds, factors = np.full(len(self.group), _OTHER), np.ones(len(self.group))
        self.node: IntArray = np.full(len(self.group), -1)
        for node in range(data.NumberOfNodes()):
            numbers = np.array(data.GetNodeLTGODE2(node), dtype=int)
            if len(numbers) == 0:
                continue
            self.node[numbers] = node
            kind = mbs.GetNode(node)["nodeType"]
            positions = _POSITIONS.get(kind, 0)
            if positions == 0:
                continue
            size = positions if "Slope" in kind else len(numbers)  # slopes are vectors as positions are
            for first, last in [(0, positions), *((i, i + size) for i in range(positions, len(numbers), size))]:
                part = numbers[first : min(last, len(numbers))]
                if len(part):
                    self.group[part] = part[0]
                    kinds[part], factors[part] = (_TURN, 1.0) if first else (_LENGTH, 1.0)
            if kind == "RigidBodyEP":
                factors[numbers[3:]] = 2.0  # turns are twice the increments of Euler parameters
        self._add_trees(mbs, kinds)
        self._is_length, self._is_turn, self._factors = kinds == _LENGTH, kinds == _TURN, factors

    @staticmethod
    def _add_trees(mbs: Any, kinds: IntArray) -> None:
        for number in range(mbs.systemData.NumberOfObjects()):
            item = mbs.GetObject(number)
            if item["objectType"] == "KinematicTree":
                joints = [str(joint) for joint in item["jointTypes"]]
                numbers = mbs.systemData.GetObjectLTGODE2(number)
                kinds[numbers] = [_TURN if "Revolute" in joint else _LENGTH for joint in joints]

    @property
    def turning(self) -> IntArray:
        """Coordinates that are rotations."""
        return np.flatnonzero(self._is_turn)

    def sizes(self, change: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return, for the group of each coordinate, how far it moves in sizes of the model, and turns in rad."""
        squares = np.bincount(self.group, (change * self._factors) ** 2, len(change))
        lengths = np.sqrt(squares)[self.group]
        chords = self._is_turn & (self._factors == 2.0)  # chords of Euler parameters
        turns = np.where(chords, np.where(lengths < 4, 4 * np.arcsin(np.minimum(lengths / 4, 1)), lengths), lengths)
        return np.where(self._is_length, lengths / self.extent, 0.0), np.where(self._is_turn, turns, 0.0)

    def highest_frequency(self, mass: FloatArray, stiffness: FloatArray) -> float:
        """Return the largest of sqrt(k/m) (1/s) over groups, from diagonals of mass and stiffness; 0 without any.

        A single coordinate would not do: the first Euler parameter has no mass next to the reference orientation.
        """
        heaviest, stiffest = np.zeros(len(mass)), np.zeros(len(mass))
        np.maximum.at(heaviest, self.group, mass)
        np.maximum.at(stiffest, self.group, np.abs(stiffness))
        heavy = heaviest > 0
        return float(np.sqrt((stiffest[heavy] / heaviest[heavy]).max(initial=0.0)))
