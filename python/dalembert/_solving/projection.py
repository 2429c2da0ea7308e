"""Smallest changes, in the metric of the mass matrix, that fulfil linearized constraints, redundant ones among them.

The step solves [[M, G^T], [G, -eps D]] (x, y) = (0, b), which has a solution for any rank of G. In well-conditioned
directions, x is that of eps = 0; the next step corrects the rest. A large eps damps the step (Levenberg-Marquardt).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from dalembert._checks import FloatArray, IntArray
from dalembert._solving.sparse_factors import constrained_factors

REGULAR, SMALLER, SMALLEST = 1e-10, 1e-12, 1e-14  # default eps; values for slow convergence
_LARGEST_BLOCK = 12  # coordinates of a mass matrix block that is searched for motions without inertia
_MASSLESS = 1e-10  # share of the largest inertia in a block


def _without_inertia(blocks: FloatArray) -> tuple[IntArray, FloatArray]:
    """Return motions of coordinates with mass that have no kinetic energy: numbers of blocks, and a unit vector each.

    The lengthening of Euler parameters is one: weights of such motions must not touch those normal to them.
    """
    masses = np.diagonal(blocks, axis1=1, axis2=2)
    massive = masses > 0
    scale = np.where(massive, 1 / np.sqrt(np.where(massive, masses, 1.0)), 0.0)
    scaled = blocks * scale[:, :, None] * scale[:, None, :] + np.eye(blocks.shape[1]) * ~massive[:, :, None]
    inertia, motions = np.linalg.eigh(scaled)
    null = inertia < _MASSLESS * inertia[:, -1:]
    vanishing = np.where(null[:, None, :], scale[:, :, None] * motions, 0.0)
    orthonormal = np.linalg.qr(vanishing)[0]  # the motions without inertia come first
    block, column = np.nonzero(null)
    return block, orthonormal[block, :, column]


def weights(mass: Any) -> Any:
    """Return the mass matrix with weights for massless coordinates: 1 for coordinates, the largest of the body for
    motions."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    size = mass.shape[0]
    entries = mass.tocoo()
    rows, columns, values = [np.arange(size)], [np.arange(size)], [np.where(mass.diagonal() > 0, 0.0, 1.0)]
    labels = connected_components(mass, directed=False)[1]
    counts = np.bincount(labels)
    order = np.argsort(labels, kind="stable")
    place = np.empty(size, dtype=int)  # position of each coordinate in its block
    place[order] = np.arange(size) - np.repeat(np.cumsum(counts) - counts, counts)
    for count in range(2, _LARGEST_BLOCK + 1):
        numbers = np.cumsum(counts == count) - 1  # numbers of the blocks of this size
        members = order[counts[labels[order]] == count].reshape(-1, count)
        inside = counts[labels[entries.row]] == count
        blocks = np.zeros((len(members), count, count))
        row, column = entries.row[inside], entries.col[inside]
        blocks[numbers[labels[row]], place[row], place[column]] = entries.data[inside]
        if len(blocks):
            block, motion = _without_inertia(blocks)
            weight = blocks[block].max(axis=(1, 2))
            rows.append(np.repeat(members[block], count, axis=1).ravel())
            columns.append(np.tile(members[block], count).ravel())
            values.append((weight[:, None, None] * motion[:, :, None] * motion[:, None, :]).ravel())
    added = coo_array((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))), shape=mass.shape)
    return (mass + added).tocsr()


class LinearizedConstraints:
    """Equations G x = b at one state; `held` coordinates are fixed. Rows without a free coordinate are ignored.

    If no x fulfils all rows, `shares` weights the remaining error of each; rows with zero share keep their own error.
    """

    def __init__(self, mass: Any, gradient: Any, held: FloatArray, shares: FloatArray) -> None:
        from scipy.sparse import block_array, diags_array

        free = diags_array(1.0 - held)
        mass, gradient = free @ mass @ free + diags_array(held), gradient @ free
        squares = gradient.multiply(gradient) @ (1 / mass.diagonal())
        self._acts, self._coordinates = squares > 0, len(held)
        self._metric = np.where(self._acts, np.where(shares > 0, shares, squares), 1.0)
        self.scale = np.where(self._acts, 1 / np.sqrt(self._metric), 1.0)  # of gaps, by row
        self._matrix = block_array([[mass, gradient.T], [gradient, None]], format="csc")

    def solver(self, eps: float) -> Callable[[FloatArray], FloatArray]:
        """Return the function that finds the smallest x with G x = b."""
        factors = constrained_factors(self._matrix, self._metric, eps)

        def solve(right: FloatArray) -> FloatArray:
            return factors.step(np.append(np.zeros(self._coordinates), self._acts * right))[: self._coordinates]

        return solve

    def left_open(self, right: FloatArray) -> tuple[FloatArray, float]:
        """Return the part of b that no x fulfils, and its relative size, for scaled equations."""
        right = self._acts * right
        left = constrained_factors(self._matrix, self._metric, REGULAR).misfit(right)
        sizes = [float(np.linalg.norm(self.scale * b)) for b in (left, right)]
        return left, sizes[0] / max(sizes[1], 1e-300)
