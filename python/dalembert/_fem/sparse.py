"""Sparse matrices: those of scipy, and arrays with one line [row, column, value] per entry (triplets)."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, as_array, as_number, as_vector, check_integer, check_type, shape_error
from dalembert._tools.later import scipy


def _triplets(name: str, value: Any) -> FloatArray:
    """Convert to an array with lines of row, column and value; ValueError otherwise."""
    expected = "lines [row, column, value], of which row and column are integers from 0"
    triplets = as_array(name, value, expected)
    if triplets.ndim != 2 or triplets.shape[1] != 3:
        raise shape_error(name, expected, value)
    places = triplets[:, :2]
    wrong = ~((places >= 0) & (places == np.floor(places))).all(axis=1)
    if wrong.any():
        raise shape_error(name, expected, triplets[wrong][0].tolist())
    return triplets


def CheckForSciPyMatrix(data: Any, stringWhere: str) -> bool:
    """True for a sparse matrix of scipy, False for an array of [row, column, value]; raises ValueError for others."""
    if scipy.sparse.issparse(data):
        return True
    if np.ndim(data) == 2 and np.shape(data)[1] == 3:
        return False
    raise ValueError(f"{stringWhere}: expected a scipy sparse matrix or an array of [row, column, value]")


def SparseTripletsToScipySparseCSR(sparseTriplets: npt.ArrayLike) -> Any:
    """scipy csr matrix of an array of [row, column, value]; entries of the same place are added."""
    triplets = _triplets("SparseTripletsToScipySparseCSR: sparseTriplets", sparseTriplets)
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
    matrix = as_array("ConvertDenseToCompressedRowMatrix: denseMatrix", denseMatrix, "a matrix of numbers")
    if matrix.ndim != 2:
        raise shape_error("ConvertDenseToCompressedRowMatrix: denseMatrix", "a matrix of numbers", denseMatrix)
    return ScipySparseCSRtoCSR(matrix)


def CompressedRowSparseToDenseMatrix(sparseData: Any) -> FloatArray:
    """Dense matrix of an array of [row, column, value], or of a sparse matrix of scipy."""
    matrix = sparseData if scipy.sparse.issparse(sparseData) else SparseTripletsToScipySparseCSR(sparseData)
    return np.asarray(matrix.toarray(), dtype=float)


def CSRtoRowsAndColumns(sparseMatrixCSR: npt.ArrayLike) -> tuple[int, int]:
    """The largest row and column index of an array of [row, column, value]."""
    entries = _triplets("CSRtoRowsAndColumns: sparseMatrixCSR", sparseMatrixCSR)
    if len(entries) == 0:
        raise shape_error("CSRtoRowsAndColumns: sparseMatrixCSR", "one line or more", sparseMatrixCSR)
    return int(entries[:, 0].max()), int(entries[:, 1].max())


def MapSparseMatrixIndices(matrix: FloatArray, sorting: npt.ArrayLike) -> None:
    """Replace the indices in an array of [row, column, value] by sorting[index], in place."""
    where = "MapSparseMatrixIndices"
    check_type(f"{where}: matrix", matrix, np.ndarray)
    places = _triplets(f"{where}: matrix", matrix)[:, :2].astype(int)
    expected = f"an index, 0 or more, for each of {places.max(initial=-1) + 1} rows and columns"
    order = as_array(f"{where}: sorting", sorting, expected)
    if order.ndim != 1 or len(order) <= places.max(initial=-1) or not ((order >= 0) & (order == np.floor(order))).all():
        raise shape_error(f"{where}: sorting", expected, sorting)
    matrix[:, :2] = order[places]


def AddEntryToCompressedRowSparseArray(sparseData: FloatArray, row: int, column: int, value: float) -> FloatArray:
    """Add value to an entry of an array of [row, column, value]; a new line is appended if there is no such entry."""
    where = "AddEntryToCompressedRowSparseArray"
    check_integer(f"{where}: row", row, 0)
    check_integer(f"{where}: column", column, 0)
    as_number(f"{where}: value", value)
    _triplets(f"{where}: sparseData", sparseData)
    found = np.flatnonzero((sparseData[:, 0] == row) & (sparseData[:, 1] == column))
    if len(found) == 0:
        return np.vstack((sparseData, [row, column, value]))
    sparseData[found[0], 2] += value
    return sparseData


def _of_points(name: str, value: npt.ArrayLike) -> FloatArray:
    vector = as_vector(name, value)
    if vector.size % 3 != 0:
        raise shape_error(name, "three numbers for each node", value)
    return vector


def ResortIndicesOfNGvector(vXXYYZZ: npt.ArrayLike) -> FloatArray:
    """Convert (x0, x1, ..., y0, y1, ..., z0, z1, ...) to (x0, y0, z0, x1, ...)."""
    return _of_points("ResortIndicesOfNGvector: vXXYYZZ", vXXYYZZ).reshape(3, -1).T.ravel()


def ResortIndicesExudyn2NGvector(vXYZXYZ: npt.ArrayLike) -> FloatArray:
    """Convert (x0, y0, z0, x1, ...) to (x0, x1, ..., y0, y1, ..., z0, z1, ...)."""
    return _of_points("ResortIndicesExudyn2NGvector: vXYZXYZ", vXYZXYZ).reshape(-1, 3).T.ravel()


def ResortIndicesOfCSRmatrix(mXXYYZZ: FloatArray, numberOfRows: int) -> None:
    """The same reordering for the indices of an array of [row, column, value], in place."""
    check_integer("ResortIndicesOfCSRmatrix: numberOfRows", numberOfRows, 0)
    _triplets("ResortIndicesOfCSRmatrix: mXXYYZZ", mXXYYZZ)
    if numberOfRows % 3 != 0 or (len(mXXYYZZ) > 0 and mXXYYZZ[:, :2].max() >= numberOfRows):
        expected = "three rows for each node, more than the largest index"
        raise shape_error("ResortIndicesOfCSRmatrix: numberOfRows", expected, numberOfRows)
    n = numberOfRows // 3
    index = np.arange(numberOfRows)
    MapSparseMatrixIndices(mXXYYZZ, 3 * (index % n) + index // n)
