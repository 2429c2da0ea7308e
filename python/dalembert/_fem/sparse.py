"""Sparse matrices: those of scipy, and arrays with one line [row, column, value] per entry (triplets)."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt
import scipy.sparse

from dalembert._checks import FloatArray


def CheckForSciPyMatrix(data: Any, stringWhere: str) -> bool:
    """True for a sparse matrix of scipy, False for an array of [row, column, value]; raises ValueError for others."""
    if scipy.sparse.issparse(data):
        return True
    if np.ndim(data) == 2 and np.shape(data)[1] == 3:
        return False
    raise ValueError(f"{stringWhere}: expected a scipy sparse matrix or an array of [row, column, value]")


def SparseTripletsToScipySparseCSR(sparseTriplets: npt.ArrayLike) -> Any:
    """scipy csr matrix of an array of [row, column, value]; entries of the same place are added."""
    triplets = np.asarray(sparseTriplets, dtype=float)
    if triplets.ndim != 2 or triplets.shape[1] != 3:
        raise ValueError(
            f"SparseTripletsToScipySparseCSR: expected lines [row, column, value], received shape {triplets.shape}"
        )
    rows, columns = triplets[:, 0].astype(int), triplets[:, 1].astype(int)
    return scipy.sparse.csr_matrix((triplets[:, 2], (rows, columns)))


def CSRtoScipySparseCSR(sparseMatrixCSR: npt.ArrayLike) -> Any:
    """scipy csr matrix of an array of [row, column, value]."""
    return SparseTripletsToScipySparseCSR(sparseMatrixCSR)


def ScipySparseCSRtoCSR(scipyCSR: Any) -> FloatArray:
    """Array of [row, column, value] of a sparse matrix of scipy."""
    entries = scipy.sparse.csr_matrix(scipyCSR).tocoo()
    return np.column_stack((entries.row, entries.col, entries.data)).astype(float)


def ConvertDenseToCompressedRowMatrix(denseMatrix: npt.ArrayLike) -> FloatArray:
    """Array of [row, column, value] of the entries of a matrix that are not zero."""
    return ScipySparseCSRtoCSR(np.asarray(denseMatrix, dtype=float))


def CompressedRowSparseToDenseMatrix(sparseData: Any) -> FloatArray:
    """Dense matrix of an array of [row, column, value], or of a sparse matrix of scipy."""
    matrix = sparseData if scipy.sparse.issparse(sparseData) else SparseTripletsToScipySparseCSR(sparseData)
    return np.asarray(matrix.toarray(), dtype=float)


def CSRtoRowsAndColumns(sparseMatrixCSR: npt.ArrayLike) -> tuple[int, int]:
    """The largest row and column index of an array of [row, column, value]."""
    entries = np.asarray(sparseMatrixCSR, dtype=float)
    return int(entries[:, 0].max()), int(entries[:, 1].max())


def MapSparseMatrixIndices(matrix: FloatArray, sorting: npt.ArrayLike) -> None:
    """Replace the indices in an array of [row, column, value] by sorting[index], in place."""
    order = np.asarray(sorting, dtype=int)
    matrix[:, :2] = order[matrix[:, :2].astype(int)]


def AddEntryToCompressedRowSparseArray(sparseData: FloatArray, row: int, column: int, value: float) -> FloatArray:
    """Add value to an entry of an array of [row, column, value]; a new line is appended if there is no such entry."""
    found = np.flatnonzero((sparseData[:, 0] == row) & (sparseData[:, 1] == column))
    if len(found) == 0:
        return np.vstack((sparseData, [row, column, value]))
    sparseData[found[0], 2] += value
    return sparseData


def ResortIndicesOfNGvector(vXXYYZZ: npt.ArrayLike) -> FloatArray:
    """From (x0, x1, ..., y0, y1, ..., z0, z1, ...) to (x0, y0, z0, x1, ...)."""
    return np.asarray(vXXYYZZ).reshape(3, -1).T.ravel()


def ResortIndicesExudyn2NGvector(vXYZXYZ: npt.ArrayLike) -> FloatArray:
    """From (x0, y0, z0, x1, ...) to (x0, x1, ..., y0, y1, ..., z0, z1, ...)."""
    return np.asarray(vXYZXYZ).reshape(-1, 3).T.ravel()


def ResortIndicesOfCSRmatrix(mXXYYZZ: FloatArray, numberOfRows: int) -> None:
    """The same reordering for the indices of an array of [row, column, value], in place."""
    n = numberOfRows // 3
    index = np.arange(numberOfRows)
    MapSparseMatrixIndices(mXXYYZZ, 3 * (index % n) + index // n)
