"""Cholesky factors of large sparse matrices of a mesh: nested dissection by the positions of nodes, dense fronts.

A mesh is cut in two again and again, across its longest direction [George 1973]; the nodes of a cut are eliminated
after those on both of its sides. What remains of a part after its elimination is a dense matrix on the nodes around it
[Duff and Reid 1983], so that nearly all of the work is done by LAPACK.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import scipy.sparse
from scipy.linalg import blas, lapack

from dalembert._checks import FloatArray, IntArray

LEAF = 64  # nodes that are eliminated without a further cut
SIZE = 3  # coordinates per node


class NotPositiveDefiniteError(ValueError):
    """A matrix has no Cholesky factors; `node` is about where that shows."""

    def __init__(self, node: int) -> None:
        super().__init__(f"the matrix is not positive definite, near node {node}")
        self.node = node


@dataclass
class Front:
    """Nodes that are eliminated together, in a row from `begin` to `end`; `around` are later ones that they reach."""

    begin: int
    end: int
    children: list[Front]
    around: IntArray = field(default_factory=lambda: np.zeros(0, dtype=np.int64))
    triangle: Any = None
    below: Any = None


class Cholesky:
    """Factors of a symmetric positive definite matrix with three rows per node."""

    def __init__(self, matrix: Any, positions: FloatArray, progress: Callable[[str], None] = lambda text: None) -> None:
        csr = scipy.sparse.csr_matrix(matrix)
        graph = _graph_of_nodes(csr)
        self._fronts: list[Front] = []
        order: list[IntArray] = []
        _dissect(np.arange(len(positions)), positions, graph, order, self._fronts)
        nodes = np.concatenate(order) if order else np.zeros(0, dtype=np.int64)
        self._order = _coordinates(nodes)
        _find_surroundings(self._fronts, graph[nodes][:, nodes])
        self._factorize(csr[self._order][:, self._order].tocsc(), nodes, progress)

    @property
    def entries(self) -> int:
        """How many numbers the factors have."""
        return sum(front.triangle.size + front.below.size for front in self._fronts)

    def _factorize(self, matrix: Any, nodes: IntArray, progress: Callable[[str], None]) -> None:
        updates: dict[int, FloatArray] = {}
        total = max(sum(_work(front) for front in self._fronts), 1.0)
        done, told = 0.0, 0.0
        for front in self._fronts:
            own, size = SIZE * (front.end - front.begin), SIZE * (front.end - front.begin + len(front.around))
            places = _coordinates(np.concatenate([np.arange(front.begin, front.end), front.around]))
            full = np.zeros((size, size), order="F")
            _scatter(full, matrix, SIZE * front.begin, own, places)
            for child in front.children:
                inner = np.searchsorted(places, _coordinates(child.around))
                full[np.ix_(inner, inner)] += updates.pop(id(child))
            triangle, failed = lapack.dpotrf(full[:own, :own], lower=1, clean=1)
            if failed:
                raise NotPositiveDefiniteError(int(nodes[front.begin + (failed - 1) // SIZE]))
            front.triangle = triangle
            front.below = blas.dtrsm(1.0, triangle, full[own:, :own], side=1, lower=1, trans_a=1)
            if len(front.around):
                rest = blas.dsyrk(-1.0, front.below, beta=1.0, c=full[own:, own:], lower=1)
                updates[id(front)] = np.tril(rest) + np.tril(rest, -1).T
            done += _work(front)
            if done > told + 0.1 * total:
                told = done
                progress(f"factorization: {100 * done / total:.0f} %")

    def solve(self, right: FloatArray) -> FloatArray:
        """Solution for a vector, or for the columns of a matrix."""
        b = np.asarray(right, dtype=float)[self._order]
        vector, x = b.ndim == 1, np.asfortranarray(b.reshape(len(b), -1))
        for front in self._fronts:
            own, around = slice(SIZE * front.begin, SIZE * front.end), _coordinates(front.around)
            x[own] = blas.dtrsm(1.0, front.triangle, x[own], lower=1)
            x[around] -= front.below @ x[own]
        for front in reversed(self._fronts):
            own, around = slice(SIZE * front.begin, SIZE * front.end), _coordinates(front.around)
            x[own] = blas.dtrsm(1.0, front.triangle, x[own] - front.below.T @ x[around], lower=1, trans_a=1)
        result = np.empty_like(x)
        result[self._order] = x
        return result[:, 0] if vector else result


def _coordinates(nodes: IntArray) -> IntArray:
    return np.asarray((SIZE * nodes[:, None] + np.arange(SIZE)).ravel(), dtype=np.int64)


def _graph_of_nodes(matrix: Any) -> Any:
    coordinates = matrix.tocoo()
    count = matrix.shape[0] // SIZE
    ones = np.ones(len(coordinates.row), dtype=np.int8)
    graph = scipy.sparse.csr_matrix((ones, (coordinates.row // SIZE, coordinates.col // SIZE)), shape=(count, count))
    graph.sum_duplicates()
    graph.data = np.ones(len(graph.data))
    return graph


def _dissect(
    part: IntArray, positions: FloatArray, graph: Any, order: list[IntArray], fronts: list[Front]
) -> list[Front]:
    """Order the nodes of a part; return its last front, or nothing if it has no nodes."""
    children: list[Front] = []
    if len(part) > LEAF:
        points = positions[part]
        along = points[:, np.argmax(np.ptp(points, axis=0))]
        ranks = np.argsort(along, kind="stable")
        low, high = part[ranks[: len(part) // 2]], part[ranks[len(part) // 2 :]]
        inside = np.zeros(len(positions))
        inside[low] = 1.0
        touches = (graph[high] @ inside) > 0
        for side in (low, high[~touches]):
            children += _dissect(side, positions, graph, order, fronts)
        part = high[touches]
    begin = sum(map(len, order)) if not fronts else fronts[-1].end
    if len(part) == 0:
        return children
    order.append(part)
    fronts.append(Front(begin, begin + len(part), children))
    return [fronts[-1]]


def _find_surroundings(fronts: list[Front], graph: Any) -> None:
    """Find the later nodes that each front reaches, by its own entries and by what its children leave."""
    for front in fronts:
        reached = graph.indices[graph.indptr[front.begin] : graph.indptr[front.end]]
        nodes = np.unique(np.concatenate([reached, *(child.around for child in front.children)]))
        front.around = nodes[nodes >= front.end].astype(np.int64)


def _work(front: Front) -> float:
    own, around = SIZE * (front.end - front.begin), SIZE * len(front.around)
    return own**3 / 3.0 + float(own) ** 2 * around + float(own) * around**2


def _scatter(full: FloatArray, matrix: Any, first: int, own: int, places: IntArray) -> None:
    """Add the columns of a front, below the diagonal."""
    entries = slice(matrix.indptr[first], matrix.indptr[first + own])
    rows = matrix.indices[entries]
    columns = np.repeat(np.arange(own), np.diff(matrix.indptr[first : first + own + 1]))
    mine = rows >= first
    full[np.searchsorted(places, rows[mine]), columns[mine]] += matrix.data[entries][mine]
