"""Cholesky factors of large sparse matrices of a mesh: a dense front for each cut of its dissection.

The Schur complement of a part is a dense matrix on the surrounding nodes [Duff and Reid 1983], so that LAPACK does
nearly all of the work.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from dalembert._checks import FloatArray, IntArray
from dalembert._fem.dissection import Front, dissect
from dalembert._tools.later import scipy

SIZE = 3  # coordinates per node


class NotPositiveDefiniteError(ValueError):
    """A matrix has no Cholesky factors; `node` is about where that shows."""

    def __init__(self, node: int) -> None:
        super().__init__(f"the matrix is not positive definite, near node {node}")
        self.node = node


@dataclass(frozen=True)
class Factors:
    """Columns of the factors of a front: a triangle, and the rows below it."""

    triangle: FloatArray
    below: FloatArray
    own: slice
    around: IntArray


class _Memory:
    """Memory of updates that were added, for new ones: pages that the system has not to clear again."""

    def __init__(self) -> None:
        self._free: list[FloatArray] = []

    def zeros(self, size: int) -> FloatArray:
        """A symmetric matrix, column by column."""
        fitting = [i for i, numbers in enumerate(self._free) if len(numbers) >= size**2]
        numbers = self._free.pop(min(fitting, key=lambda i: len(self._free[i]))) if fitting else np.empty(size**2)
        matrix = numbers[: size**2].reshape((size, size), order="F")
        matrix.fill(0.0)
        return matrix

    def give_back(self, matrix: Any) -> None:
        """Take the memory of a matrix that is no longer read."""
        self._free.append(matrix.base)


class Cholesky:
    """Factors of a symmetric positive definite matrix with three rows per node."""

    def __init__(self, matrix: Any, positions: FloatArray, progress: Callable[[str], None] = lambda text: None) -> None:
        csr = scipy.sparse.csr_matrix(matrix)
        nodes, fronts = dissect(positions, _graph_of_nodes(csr))
        self._order = _coordinates(nodes)
        self._factors: list[Factors] = []
        self._factorize(fronts, csr[self._order][:, self._order].tocsc(), nodes, progress)

    @property
    def entries(self) -> int:
        """How many numbers the factors have."""
        return sum(factors.triangle.size + factors.below.size for factors in self._factors)

    def _factorize(self, fronts: list[Front], matrix: Any, nodes: IntArray, progress: Callable[[str], None]) -> None:
        updates: dict[int, Any] = {}
        memory = _Memory()
        total = max(sum(_work(front) for front in fronts), 1.0)
        done, told = 0.0, 0.0
        for front in fronts:
            own = slice(SIZE * front.begin, SIZE * front.end)
            around = _coordinates(front.around)
            triangle, below, rest = _sum_of_front(front, matrix, around, updates, memory)
            triangle, failed = scipy.linalg.lapack.dpotrf(triangle, lower=1, clean=1, overwrite_a=1)
            if failed:
                raise NotPositiveDefiniteError(int(nodes[front.begin + (failed - 1) // SIZE]))
            below = scipy.linalg.blas.dtrsm(1.0, triangle, below, side=1, lower=1, trans_a=1, overwrite_b=1)
            self._factors.append(Factors(triangle, below, own, around))
            if len(around):
                updates[id(front)] = scipy.linalg.blas.dsyrk(-1.0, below, beta=1.0, c=rest, lower=1, overwrite_c=1)
            done += _work(front)
            if done > told + 0.1 * total:
                told = done
                progress(f"factorization: {100 * done / total:.0f} %")

    def solve(self, right: FloatArray) -> FloatArray:
        """Solution for a vector, or for the columns of a matrix."""
        b = np.asarray(right, dtype=float)[self._order]
        x = b.reshape(len(b), -1)
        for part in self._factors:
            own = scipy.linalg.blas.dtrsm(1.0, part.triangle, x[part.own], lower=1)
            x[part.own] = own
            if len(part.around):
                x[part.around] -= scipy.linalg.blas.dgemm(1.0, part.below, own)
        for part in reversed(self._factors):
            own = x[part.own]
            if len(part.around):
                own = scipy.linalg.blas.dgemm(-1.0, part.below, x[part.around], trans_a=1, beta=1.0, c=own)
            x[part.own] = scipy.linalg.blas.dtrsm(1.0, part.triangle, own, lower=1, trans_a=1)
        result = np.empty_like(x)
        result[self._order] = x
        return result[:, 0] if b.ndim == 1 else result


def _coordinates(nodes: IntArray) -> IntArray:
    return np.asarray((SIZE * nodes[:, None] + np.arange(SIZE)).ravel(), dtype=np.int64)


def _graph_of_nodes(matrix: Any) -> Any:
    """An entry for each pair of nodes with one, and for each node with itself."""
    blocks = matrix.tobsr((SIZE, SIZE))
    count = matrix.shape[0] // SIZE
    ones = np.ones(len(blocks.indices), dtype=np.int8)
    graph = scipy.sparse.csr_matrix((ones, blocks.indices, blocks.indptr), shape=(count, count))
    return graph + scipy.sparse.eye(count, dtype=np.int8, format="csr")


def _work(front: Front) -> float:
    own, around = SIZE * (front.end - front.begin), SIZE * len(front.around)
    return own**3 / 3.0 + float(own) ** 2 * around + float(own) * around**2


def _sum_of_front(
    front: Front, matrix: Any, around: IntArray, updates: dict[int, FloatArray], memory: _Memory
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Entries of a front and updates of its children: its triangle, the rows below it, and the update matrix."""
    first, own = SIZE * front.begin, SIZE * (front.end - front.begin)
    triangle, below = (np.zeros((height, own), order="F") for height in (own, len(around)))
    rest = memory.zeros(len(around))
    entries = slice(matrix.indptr[first], matrix.indptr[first + own])
    rows, values = matrix.indices[entries], matrix.data[entries]
    columns = np.repeat(np.arange(own), np.diff(matrix.indptr[first : first + own + 1]))
    inside, outside = (rows >= first) & (rows < first + own), rows >= first + own
    triangle[rows[inside] - first, columns[inside]] = values[inside]
    below[np.searchsorted(around, rows[outside]), columns[outside]] = values[outside]
    for child in front.children:
        update, places = updates.pop(id(child)), _coordinates(child.around)
        mine = int(np.searchsorted(places, first + own))
        inner, outer = _rows_of(places[:mine] - first), _rows_of(np.searchsorted(around, places[mine:]))
        _add(triangle, inner, inner, update[:mine, :mine])
        _add(below, outer, inner, update[mine:, :mine])
        _add(rest, outer, outer, update[mine:, mine:])
        memory.give_back(update)
    return triangle, below, rest


def _rows_of(places: IntArray) -> list[tuple[int, int, int]]:
    """Contiguous runs of rows: begin, end, and the position of the first."""
    ends = np.flatnonzero(np.diff(places, append=-1) != 1) + 1 if len(places) else np.zeros(0, dtype=np.int64)
    begins = np.append(0, ends)[: len(ends)]
    return list(zip(begins.tolist(), ends.tolist(), places[begins].tolist(), strict=True))


def _add(full: FloatArray, rows: Any, columns: Any, update: FloatArray) -> None:
    """Add an update at its positions; only the lower triangle of a symmetric update is read."""
    for begin, end, column in columns:
        for top, bottom, row in rows:
            if rows is not columns or bottom > begin:
                place = full[row : row + bottom - top, column : column + end - begin]
                place += update[top:bottom, begin:end]
