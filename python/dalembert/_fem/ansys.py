"""Readers for matrices, nodes and elements that ANSYS exports."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray
from dalembert._fem.elements import KINDS
from dalembert._io.files import file_to_read
from dalembert._tools.later import scipy


def ReadMatrixFromAnsysMMF(fileName: str, verbose: bool = False) -> FloatArray:
    """Array of [row, column, value] of a matrix that ANSYS exported in the Matrix Market format (MMF)."""
    from scipy.io import mmread

    fileName = file_to_read("ReadMatrixFromAnsysMMF: fileName", fileName)
    try:
        matrix = scipy.sparse.coo_matrix(mmread(fileName))
    except ValueError as error:
        raise ValueError(f"ReadMatrixFromAnsysMMF: {fileName}: {error}") from None
    if verbose:
        print(f"matrix of {matrix.shape[0]} x {matrix.shape[1]}, {matrix.nnz} entries")
    return np.column_stack((matrix.row, matrix.col, matrix.data)).astype(float)


def ReadMatrixDOFmappingVectorFromAnsysTxt(fileName: str) -> npt.NDArray[np.int_]:
    """Order of the coordinates, 3 per node, that belongs to the matrices which ANSYS exports.

    The file has comments that begin with '%', a line with the number of nodes and 1, and one node number per line,
    counted from 1.
    """
    fileName = file_to_read("ReadMatrixDOFmappingVectorFromAnsysTxt: fileName", fileName)
    with open(fileName, encoding="utf-8") as file:
        lines = [line.split() for line in file if line.strip() and not line.startswith("%")]
    header, numbers = [int(word) for word in lines[0]], [int(line[0]) for line in lines[1:]]
    if header[1:] != [1] or header[0] != len(numbers):
        raise ValueError(
            f"ReadMatrixDOFmappingVectorFromAnsysTxt: {fileName}: expected a line 'n 1' and n numbers, "
            f"found {lines[0]} and {len(numbers)} numbers"
        )
    order: npt.NDArray[np.int_] = (3 * (np.asarray(numbers, dtype=int)[:, None] - 1) + np.arange(3)).ravel()
    return order


def ReadNodalCoordinatesFromAnsysTxt(fileName: str, verbose: bool = False) -> FloatArray:
    """Positions of nodes, ordered by node number, of an exported list: a title, then number, x, y, z per line."""
    fileName = file_to_read("ReadNodalCoordinatesFromAnsysTxt: fileName", fileName)
    with open(fileName, encoding="utf-8") as file:
        lines = [line.replace(",", ".").split() for line in file.readlines()[1:] if line.strip()]
    table = np.array([[float(word) for word in line[:4]] for line in lines])
    if table.ndim != 2 or table.shape[1] != 4:
        raise ValueError(f"ReadNodalCoordinatesFromAnsysTxt: {fileName}: expected lines with a node number, x, y and z")
    if verbose:
        print(f"{len(table)} nodes")
    positions: FloatArray = table[np.argsort(table[:, 0], kind="stable"), 1:]
    return positions


def ReadElementsFromAnsysTxt(fileName: str, verbose: bool = False) -> dict[str, Any]:
    """Elements of an exported list: a title, then number, type (Tet4, Hex8, ...) and nodes per line.

    A dictionary with 'Name' and, for each type, an array of nodes, counted from 0.
    """
    fileName = file_to_read("ReadElementsFromAnsysTxt: fileName", fileName)
    expected = "an element number, counted from 1, a type and nodes"
    by_type: dict[str, list[list[int]]] = {}
    with open(fileName, encoding="utf-8", errors="replace") as file:
        lines = [(number, line.split()) for number, line in enumerate(file, 1) if number > 1 and line.strip()]
    for count, (number, words) in enumerate(lines, 1):
        place = f"ReadElementsFromAnsysTxt: {fileName}, line {number}"
        try:
            label, nodes = int(words[0]), [int(word) - 1 for word in words[2:]]
        except ValueError:
            raise ValueError(f"{place}: expected {expected}, found '{' '.join(words)}'") from None
        if label != count or not nodes:
            raise ValueError(f"{place}: expected {expected}, found '{' '.join(words)}'")
        if words[1] in KINDS and len(nodes) != KINDS[words[1]].count:
            raise ValueError(f"{place}: expected {KINDS[words[1]].count} nodes of {words[1]}, found {len(nodes)}")
        by_type.setdefault(words[1], []).append(nodes)
    if verbose:
        print(f"{len(lines)} elements")
    return {"Name": "elements"} | {name: np.array(rows, dtype=np.int64) for name, rows in by_type.items()}
