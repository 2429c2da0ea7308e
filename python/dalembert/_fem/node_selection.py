"""Nodes by where they are."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, unit_vector
from dalembert._fem.data import MeshData


class NodeSelection(MeshData):
    """Find nodes in planes, boxes, on lines, cylinders and circles."""

    def GetNodePositionsMean(self, nodeNumberList: Sequence[int]) -> FloatArray:
        """The mean of the positions of some nodes."""
        if len(nodeNumberList) == 0:
            raise ValueError("FEMinterface.GetNodePositionsMean: nodeNumberList has no nodes")
        return np.asarray(self.GetNodePositionsAsArray()[list(nodeNumberList)].mean(axis=0), dtype=float)

    def GetNodeAtPoint(self, point: npt.ArrayLike, tolerance: float = 1e-5, raiseException: bool = True) -> int:
        """The node at a point; -1 or ValueError if it does not exist."""
        distance = np.linalg.norm(self.GetNodePositionsAsArray() - np.asarray(point, dtype=float), axis=1)
        found = np.flatnonzero(distance <= tolerance)
        if len(found) > 0:
            return int(found[0])
        if raiseException:
            raise ValueError(
                f"FEMinterface.GetNodeAtPoint: no node is within {tolerance} of {np.asarray(point).tolist()}; "
                f"the closest is node {int(distance.argmin())} at a distance of {distance.min():g}"
            )
        return -1

    def GetNodesInPlane(self, point: npt.ArrayLike, normal: npt.ArrayLike, tolerance: float = 1e-5) -> list[int]:
        """Nodes whose distance from a plane is at most the tolerance."""
        direction = unit_vector("FEMinterface.GetNodesInPlane: normal", normal)
        distance = (self.GetNodePositionsAsArray() - np.asarray(point, dtype=float)) @ direction
        return _indices(np.abs(distance) <= tolerance)

    def GetNodesInCube(self, pMin: npt.ArrayLike, pMax: npt.ArrayLike) -> list[int]:
        """Nodes in a box that is aligned with the axes."""
        positions = self.GetNodePositionsAsArray()
        return _indices(np.all((positions >= np.asarray(pMin)) & (positions <= np.asarray(pMax)), axis=1))

    def _along(self, p1: npt.ArrayLike, p2: npt.ArrayLike) -> tuple[FloatArray, FloatArray, float]:
        """Coordinates along p1-p2, distances from the line, and its length."""
        start, end = np.asarray(p1, dtype=float), np.asarray(p2, dtype=float)
        length = float(np.linalg.norm(end - start))
        offset = self.GetNodePositionsAsArray() - start
        axis = unit_vector("FEMinterface: p2 - p1, or normal", end - start)
        along = offset @ axis
        return along, np.linalg.norm(offset - np.outer(along, axis), axis=1), length

    def GetNodesOnLine(self, p1: npt.ArrayLike, p2: npt.ArrayLike, tolerance: float = 1e-5) -> list[int]:
        """Nodes on the line from p1 to p2."""
        return self.GetNodesOnCylinder(p1, p2, 0.0, tolerance)

    def GetNodesOnCylinder(
        self, p1: npt.ArrayLike, p2: npt.ArrayLike, radius: float, tolerance: float = 1e-5
    ) -> list[int]:
        """Nodes on the lateral surface of a cylinder with the axis from p1 to p2."""
        along, distance, length = self._along(p1, p2)
        inside = (along >= -tolerance) & (along <= length + tolerance)
        return _indices(inside & (np.abs(distance - radius) <= tolerance))

    def GetNodesOnCircle(
        self, point: npt.ArrayLike, normal: npt.ArrayLike, r: float, tolerance: float = 1e-5
    ) -> list[int]:
        """Nodes on a circle around a point, in the plane with the given normal."""
        along, distance, _ = self._along(point, np.asarray(point, dtype=float) + np.asarray(normal, dtype=float))
        return _indices((np.abs(along) <= tolerance) & (np.abs(distance - r) <= tolerance))


def _indices(mask: npt.NDArray[np.bool_]) -> list[int]:
    return [int(i) for i in np.flatnonzero(mask)]
