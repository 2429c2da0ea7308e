"""Modes of Hurty, Craig and Bampton [Hurty 1965, Craig and Bampton 1968] for interfaces that move as rigid bodies.

Static modes are the deformations for a unit value of one coordinate of one interface; eigenmodes are computed with all
interfaces fixed. An interface is fixed exactly (RBE2), or in the mean (RBE3): its translation is the weighted
mean of displacements, its rotation that of the moments of displacements about the weighted mean of positions.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from dalembert._checks import FloatArray, IntArray, shape_error
from dalembert._fem.eigen import (
    DENSE,
    SHIFT,
    dense_modes,
    factorize,
    first_deformation,
    refuse_negative,
    rigid_motions,
    signed,
)
from dalembert._fem.lanczos import Solve, inverse_lanczos
from dalembert._tools.later import scipy


@dataclass(frozen=True)
class Interface:
    """Nodes of an interface and their weights, whose sum is 1."""

    nodes: IntArray
    weights: FloatArray
    positions: FloatArray

    @property
    def middle(self) -> FloatArray:
        """The weighted mean of the positions."""
        return np.asarray(self.weights @ self.positions, dtype=float)

    @property
    def motions(self) -> FloatArray:
        """Displacements of the nodes for unit motions of the interface."""
        return rigid_motions(self.positions, self.middle)

    @property
    def coordinates(self) -> IntArray:
        """Coordinates of the nodes."""
        return np.asarray((3 * self.nodes[:, None] + np.arange(3)).ravel(), dtype=np.int64)

    def averages(self, by_moments: bool) -> FloatArray:
        """Translation and rotation by displacements of the nodes: 6 rows, exact for rigid motions if by_moments."""
        weighted = self.motions.T * np.repeat(self.weights, 3)
        arms = self.positions - self.middle
        if by_moments:
            moments = (weighted @ self.motions)[3:, 3:]
        else:
            moments = float(self.weights @ np.sum(arms**2, axis=1)) * np.eye(3)
        weighted[3:] = np.linalg.solve(moments, weighted[3:])
        return np.asarray(weighted, dtype=float)


def interfaces_of(where: str, nodeLists: Any, weightLists: Any, positions: FloatArray) -> list[Interface]:
    """Check lists of nodes and weights; the default is equal weights of all nodes of an interface."""
    result: list[Interface] = []
    taken = np.zeros(len(positions), dtype=bool)
    if len(weightLists) not in (0, len(nodeLists)):
        expected = f"one list of weights for each of the {len(nodeLists)} interfaces, or none at all"
        raise shape_error(f"{where}: boundaryNodesWeights", expected, weightLists)
    for i, given in enumerate(nodeLists):
        name = f"{where}: boundaryNodesList[{i}]"
        nodes = np.asarray(given)
        if nodes.ndim != 1 or len(nodes) == 0 or not np.issubdtype(nodes.dtype, np.integer):
            raise shape_error(name, "a list of node numbers that is not empty", given)
        if nodes.min() < 0 or nodes.max() >= len(positions):
            raise shape_error(name, f"node numbers from 0 to {len(positions) - 1}", given)
        twice = taken[nodes]
        if twice.any() or len(np.unique(nodes)) < len(nodes):
            node = nodes[twice][0] if twice.any() else nodes[np.flatnonzero(np.bincount(nodes)[nodes] > 1)[0]]
            raise ValueError(f"{name}: node {node} is listed twice; interfaces must not share nodes")
        taken[nodes] = True
        weights = np.ones(len(nodes)) if len(weightLists) == 0 else np.asarray(weightLists[i], dtype=float)
        if weights.shape != nodes.shape or (weights < 0).any() or not weights.sum() > 0:
            expected = f"{len(nodes)} weights that are not negative, not all of them 0"
            raise shape_error(f"{where}: boundaryNodesWeights[{i}]", expected, weightLists[i])
        result.append(Interface(nodes.astype(np.int64), weights / weights.sum(), positions[nodes]))
    return result


def _inner(interfaces: Sequence[Interface], count: int) -> tuple[IntArray, IntArray]:
    """Coordinates of interfaces, and all others."""
    outer = np.concatenate([interface.coordinates for interface in interfaces])
    free = np.ones(count, dtype=bool)
    free[outer] = False
    return outer, np.flatnonzero(free)


def _check_held(where: str, interfaces: Sequence[Interface], stiffness: Any, positions: FloatArray) -> None:
    """Refuse interfaces about whose nodes the mesh could turn freely."""
    points = np.vstack([interface.positions for interface in interfaces])
    _, sizes, directions = np.linalg.svd(rigid_motions(points, points.mean(axis=0)))
    loose = directions[(np.append(sizes, np.zeros(6 - len(sizes))) < 1e-8 * np.sqrt(len(points)))]
    for direction in loose:
        motion = rigid_motions(positions, points.mean(axis=0)) @ direction
        if motion @ (stiffness @ motion) < 1e-8 * (motion**2) @ stiffness.diagonal():
            text = "nodes of all interfaces lie on one line, about which the mesh can turn freely; add nodes"
            raise ValueError(f"{where}: boundaryNodesList: {text}")


def exact_modes(
    where: str,
    mass: Any,
    stiffness: Any,
    positions: FloatArray,
    interfaces: Sequence[Interface],
    count: int,
    rigid: bool,
    static: bool,
    progress: Callable[[str], None],
) -> tuple[FloatArray, FloatArray, list[int]]:
    """Static modes of rigid interfaces (or of all their coordinates) and eigenmodes with all of their nodes fixed.

    Returns modes, eigenvalues, and the number of static modes of each interface.
    """
    _check_held(where, interfaces, stiffness, positions)
    outer, inner = _inner(interfaces, mass.shape[0])
    if len(inner) == 0:
        raise ValueError(f"{where}: all nodes of the mesh belong to interfaces")
    inside, points = stiffness[inner][:, inner], positions[inner[::3] // 3]
    solve = factorize(inside, points, progress)
    sizes = [6 if rigid else len(interface.coordinates) for interface in interfaces]
    parts: list[FloatArray] = []
    if static:
        motions = [interface.motions if rigid else np.eye(len(interface.coordinates)) for interface in interfaces]
        prescribed = scipy.linalg.block_diag(*motions)
        modes = np.zeros((mass.shape[0], prescribed.shape[1]))
        modes[outer] = prescribed
        modes[inner] = solve(-(stiffness[inner][:, outer] @ prescribed))
        parts.append(modes)
        progress(f"{prescribed.shape[1]} static modes")
    values = np.zeros(0)
    if count:
        values, found = _modes_inside(where, mass[inner][:, inner], inside, solve, count)
        eigenmodes = np.zeros((mass.shape[0], count))
        eigenmodes[inner] = found
        parts.append(eigenmodes)
        progress(f"{count} eigenmodes with fixed interfaces")
    return np.hstack([np.zeros((mass.shape[0], 0)), *parts]), values, sizes if static else [0] * len(sizes)


def _modes_inside(where: str, mass: Any, stiffness: Any, solve: Solve, count: int) -> tuple[FloatArray, FloatArray]:
    if count > mass.shape[0]:
        raise ValueError(f"{where}: nEigenModes: {count} are asked for, but {mass.shape[0]} coordinates are inside")
    if mass.shape[0] <= DENSE or count > mass.shape[0] // 2:
        values, modes = dense_modes(where, mass, stiffness, count)
    else:
        values, modes = inverse_lanczos(mass, solve, 0.0, count)
    refuse_negative(where, values, float(np.abs(values).max()))
    return values, signed(modes)


class _Averaged:
    """Linear systems with averages of interfaces prescribed, C u = d; reactions are multipliers."""

    def __init__(self, solve: Solve, constraints: FloatArray) -> None:
        self._solve, self._constraints = solve, constraints
        self._compliances = solve(np.ascontiguousarray(constraints.T))
        self._gram = scipy.linalg.cho_factor(constraints @ self._compliances)

    def __call__(self, forces: FloatArray, prescribed: Any = 0.0) -> tuple[FloatArray, FloatArray]:
        free = self._solve(forces)
        reactions = scipy.linalg.cho_solve(self._gram, self._constraints @ free - prescribed)
        return free - self._compliances @ reactions, reactions


def averaged_modes(
    where: str,
    mass: Any,
    stiffness: Any,
    positions: FloatArray,
    interfaces: Sequence[Interface],
    count: int,
    by_moments: bool,
    progress: Callable[[str], None],
) -> tuple[FloatArray, FloatArray]:
    """Static modes and eigenmodes of interfaces whose averages are held."""
    constraints = np.zeros((6 * len(interfaces), mass.shape[0]))
    for i, interface in enumerate(interfaces):
        if np.linalg.matrix_rank(interface.motions, tol=1e-8 * max(1.0, np.abs(interface.motions).max())) < 6:
            text = "has nodes on one line, by which no rotation is defined; add nodes, or use RBE2"
            raise ValueError(f"{where}: boundaryNodesList[{i}]: RBE3: the interface {text}")
        constraints[6 * i : 6 * i + 6, interface.coordinates] = interface.averages(by_moments)
    scale = first_deformation(mass, stiffness, positions)
    shift = SHIFT * scale
    solver = _Averaged(factorize(stiffness + shift * mass, positions, progress), constraints)
    unit = np.eye(len(constraints))
    modes, reactions = solver(np.zeros((mass.shape[0], len(unit))), unit)
    for _ in range(20):  # the solver uses a slightly increased stiffness, which the residual corrects
        residual = stiffness @ modes + constraints.T @ reactions
        change, more = solver(-residual, unit - constraints @ modes)
        modes, reactions = modes + change, reactions + more
        if np.abs(change).max() < 1e-13 * np.abs(modes).max():
            break
    progress(f"{len(unit)} static modes")
    if not count:
        return modes, np.zeros(0)
    values, found = inverse_lanczos(mass, lambda force: solver(force)[0], shift, count)
    refuse_negative(where, values, scale)
    progress(f"{count} eigenmodes with averages of interfaces held")
    return np.hstack([modes, signed(found)]), values
