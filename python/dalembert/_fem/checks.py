"""Errors of a mesh or its matrices, with the file, the element or the node."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from dalembert._checks import FloatArray, IntArray
from dalembert._fem.assembly import geometry
from dalembert._fem.elements import Block


class Names:
    """Names of nodes and elements in errors: their number here, and that of the file if it differs."""

    def __init__(self, metaData: dict[str, Any]) -> None:
        self._file = metaData.get("fileName", "")
        self._labels = {kind: metaData.get(f"{kind}Labels") for kind in ("node", "element")}

    def one(self, kind: str, number: int) -> str:
        """'node 7', or 'node 7 (number 12 in part.inp)'."""
        labels = self._labels[kind]
        if not self._file:
            return f"{kind} {number}"
        label = number + 1 if labels is None else labels[number]
        return f"{kind} {number} (number {label} in {self._file})"

    def some(self, kind: str, numbers: Sequence[int] | IntArray) -> str:
        """The first of several, and how many there are."""
        more = f" and {len(numbers) - 1} more" if len(numbers) > 1 else ""
        return self.one(kind, int(numbers[0])) + more


def check_elements(mesh: Sequence[Block], positions: FloatArray, names: Names, where: str) -> None:
    """Refuse elements with nodes that do not exist, occur twice, or enclose no positive volume."""
    for block in mesh:
        wrong = np.flatnonzero(((block.nodes < 0) | (block.nodes >= len(positions))).any(axis=1))
        if len(wrong):
            text = f"nodes {block.nodes[wrong[0]].tolist()}, but there are {len(positions)} nodes"
            raise ValueError(f"{where}: {names.some('element', wrong + block.first)} has {text}")
        ordered = np.sort(block.nodes, axis=1)
        wrong = np.flatnonzero((np.diff(ordered, axis=1) == 0).any(axis=1))
        if len(wrong):
            text = f"has a node twice: {block.nodes[wrong[0]].tolist()}"
            raise ValueError(f"{where}: {names.some('element', wrong + block.first)} {text}")
        points = block.kind.rule(block.kind.mass_points).points
        worst = np.concatenate(
            [
                geometry(block.kind, positions[block.nodes[start : start + 4000]], points)[1].min(axis=1)
                for start in range(0, len(block.nodes), 4000)
            ]
        )
        wrong = np.flatnonzero(~(worst > 0))
        if len(wrong):
            text = (
                f"of kind {block.kind.name} is inverted or flat (determinant of the Jacobian {worst[wrong[0]]:g}); "
                "nodes must be ordered so that the first face, seen from within, turns counter-clockwise"
            )
            raise ValueError(f"{where}: {names.some('element', wrong + block.first)} {text}")


def check_connected(mesh: Sequence[Block], positions: FloatArray, names: Names, where: str) -> None:
    """Refuse nodes without element."""
    used = np.zeros(len(positions), dtype=bool)
    for block in mesh:
        used[block.nodes.ravel()] = True
    free = np.flatnonzero(~used)
    if len(free):
        text = "belongs to no element; remove it (RemoveUnconnectedNodes), or import the elements that it belongs to"
        raise ValueError(f"{where}: {names.some('node', free)} {text}")


def check_matrices(mass: Any, stiffness: Any, count: int, names: Names, where: str) -> None:
    """Refuse matrices of wrong size, not finite, not symmetric, or with nodes that have no mass or no stiffness."""
    for name, matrix in (("mass matrix", mass), ("stiffness matrix", stiffness)):
        if matrix.shape != (count, count):
            nodes = f"{count // 3} nodes with 3 coordinates need {count} rows and columns"
            raise ValueError(f"{where}: the {name} has {matrix.shape[0]} rows and {matrix.shape[1]} columns; {nodes}")
        if not np.isfinite(matrix.data).all():
            row = int(np.flatnonzero(np.bincount(matrix.tocoo().row[~np.isfinite(matrix.data)], minlength=count))[0])
            raise ValueError(f"{where}: the {name} has entries that are not finite, at {names.one('node', row // 3)}")
        difference = abs(matrix - matrix.T)
        if difference.nnz and difference.max() > 1e-6 * abs(matrix).max():
            row = int(difference.tocoo().row[difference.data.argmax()])
            text = f"is not symmetric, at {names.one('node', row // 3)}: {difference.max():g} of {abs(matrix).max():g}"
            raise ValueError(f"{where}: the {name} {text}")
        diagonal = matrix.diagonal().reshape(-1, 3)
        none = (diagonal < 0).any(axis=1) | (diagonal == 0).all(axis=1)
        if matrix is mass:
            none |= (diagonal == 0).any(axis=1)
        if none.any():
            text = f"has no positive diagonal entry at {names.some('node', np.flatnonzero(none))}"
            raise ValueError(f"{where}: the {name} {text}; it belongs to no element, or matrix and nodes do not fit")
