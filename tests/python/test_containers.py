"""Lists of vectors and matrices, matrix containers, sections of beams and materials."""

from __future__ import annotations

import copy
import pickle
from typing import Any

import numpy as np
import pytest
from scipy import sparse

import dalembert as exu

LISTS = [(f"Vector{n}DList", (n,)) for n in (2, 3, 6)] + [(f"Matrix{n}DList", (n, n)) for n in (3, 6)]


@pytest.mark.parametrize(("name", "shape"), LISTS)
def test_lists(name: str, shape: tuple[int, ...]) -> None:
    kind = getattr(exu, name)
    first, second = np.arange(np.prod(shape), dtype=float).reshape(shape), np.ones(shape)
    entries = kind()
    entries.Append(first)
    entries.Append(second.tolist())
    assert len(entries) == 2
    np.testing.assert_array_equal(entries[0], first)
    np.testing.assert_array_equal(entries[-1], second)
    np.testing.assert_array_equal(np.array(entries), [first, second])
    assert len(list(entries)) == 2
    for other in (kind([first, second]), kind(np.array([first, second])), kind(entries), copy.copy(entries),
                  copy.deepcopy(entries), pickle.loads(pickle.dumps(entries))):  # fmt: skip
        np.testing.assert_array_equal(other.GetPythonObject(), entries.GetPythonObject())
        other[0] = second
    np.testing.assert_array_equal(entries[0], first)
    entries[0][...] = 7  # a copy
    np.testing.assert_array_equal(entries[0], first)
    assert len(kind(None)) == len(kind([])) == 0
    assert repr(entries) == repr([first, second])


@pytest.mark.parametrize(("name", "shape"), LISTS)
def test_errors_of_lists(name: str, shape: tuple[int, ...]) -> None:
    entries = getattr(exu, name)([np.ones(shape)])
    with pytest.raises(IndexError, match=f"{name}: there is no entry 1. The list has 1 entries"):
        entries[1]
    for wrong in (np.ones(5), "a", 3, np.full(shape, np.nan)):
        with pytest.raises((ValueError, TypeError), match=rf"{name}.Append: received"):
            entries.Append(wrong)
    with pytest.raises((ValueError, TypeError), match=f"{name}, entry 1: received"):
        getattr(exu, name)([np.ones(shape), [1.0]])
    assert len(entries) == 1


def test_one_matrix_is_a_list_of_one() -> None:
    np.testing.assert_array_equal(exu.Matrix3DList(13 * np.eye(3)).GetPythonObject(), [13 * np.eye(3)])


# ---- matrix container ----------------------------------------------------------------------------------------------
class Coordinates:
    """Stands for a scipy sparse matrix."""

    def __init__(self, rows: Any, columns: Any, values: Any, shape: tuple[int, int]) -> None:
        self.row, self.col, self.data, self.shape = np.array(rows), np.array(columns), np.array(values), shape

    def tocoo(self) -> Coordinates:
        return self


def test_dense_container() -> None:
    assert exu.MatrixContainer().UseDenseMatrix() and exu.MatrixContainer([[]]).GetPythonObject().size == 0
    matrix = exu.MatrixContainer([[1, 2], [3, 4]])
    assert matrix.UseDenseMatrix()
    np.testing.assert_array_equal(matrix.GetPythonObject(), [[1, 2], [3, 4]])
    matrix.SetWithDenseMatrix(np.eye(2), factor=3)
    assert not matrix.UseDenseMatrix()
    np.testing.assert_array_equal(matrix.GetPythonObject()["triplets"], [[0, 0, 3], [1, 1, 3]])
    np.testing.assert_array_equal(matrix.Convert2DenseMatrix(), 3 * np.eye(2))
    matrix.Initialize(2, 3)
    matrix.AddSparseMatrix(Coordinates([0, 0], [0, 2], [1.0, 2.0], (1, 3)), factor=10)
    np.testing.assert_array_equal(matrix.GetPythonObject(), [[10, 0, 20], [0, 0, 0]])
    np.testing.assert_array_equal(np.array(matrix), [[10, 0, 20], [0, 0, 0]])
    matrix.SetAllZero()
    np.testing.assert_array_equal(matrix.Convert2DenseMatrix(), np.zeros((2, 3)))


def test_sparse_container() -> None:
    triplets = [[0, 0, 13.3], [1, 1, 4.2], [1, 2, 42.0]]
    dense = [[13.3, 0, 0], [0, 4.2, 42]]
    matrix = exu.MatrixContainer()
    matrix.SetWithSparseMatrix(triplets, numberOfRows=2, numberOfColumns=3)
    np.testing.assert_array_equal(matrix.GetPythonObject()["triplets"], triplets)
    assert matrix.GetPythonObject()["numberOfColumns"] == 3
    for other in (
        copy.copy(matrix),
        copy.deepcopy(matrix),
        pickle.loads(pickle.dumps(matrix)),
        exu.MatrixContainer(matrix),
    ):
        np.testing.assert_array_equal(other.Convert2DenseMatrix(), dense)
        other.SetAllZero()
        assert len(other.GetPythonObject()["triplets"]) == 0
    matrix.SetWithSparseMatrix(np.array(triplets), useDenseMatrix=True, factor=2)
    np.testing.assert_array_equal(matrix.GetPythonObject(), 2 * np.array(dense))
    matrix.SetWithSparseMatrixCSR(2, 3, triplets)
    np.testing.assert_array_equal(matrix.Convert2DenseMatrix(), dense)
    matrix.AddSparseMatrix(Coordinates([0], [0], [1.0], (1, 1)))
    np.testing.assert_array_equal(matrix.Convert2DenseMatrix()[0, 0], 14.3)
    assert not exu.MatrixContainer(Coordinates([0], [1], [2.0], (2, 2))).UseDenseMatrix()


def test_any_scipy_format() -> None:
    dense = np.array([[0, 1.0], [2, 0]])
    for kind in (sparse.csr_matrix, sparse.csc_matrix, sparse.coo_matrix):
        np.testing.assert_array_equal(exu.MatrixContainer(kind(dense)).Convert2DenseMatrix(), dense)


def test_sparse_matrices_grow_to_hold_their_triplets() -> None:
    """Triplets count in the system even if the size given is that of an item."""
    matrix = exu.MatrixContainer()
    matrix.SetWithSparseMatrix([[4, 5, 2.0]], numberOfRows=3, numberOfColumns=3)
    expected = np.zeros((5, 6))
    expected[4, 5] = 2
    np.testing.assert_array_equal(matrix.Convert2DenseMatrix(), expected)


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda m: exu.MatrixContainer([1, 2]), "MatrixContainer.__init__: received"),
        (lambda m: exu.MatrixContainer(3), "MatrixContainer.__init__: received 3"),
        (lambda m: m.SetWithDenseMatrix([[1, 2], [3]]), "Row 1 has another length than row 0"),
        (lambda m: m.SetWithSparseMatrix([[0, 5, 1.0]], 2, 2, useDenseMatrix=True), "column 5"),
        (lambda m: m.SetWithSparseMatrix([[0, 1.0]]), r"triplets \[row, column, value\]"),
        (lambda m: m.AddSparseMatrix(Coordinates([3], [3], [1.0], (4, 4))), "at most 2 x 2"),
        (lambda m: m.Initialize(-1, 2), "that is not negative"),
    ],
)
def test_errors_of_containers(call: Any, text: str) -> None:
    matrix = exu.MatrixContainer(np.eye(2))
    with pytest.raises((ValueError, TypeError, IndexError), match=text):
        call(matrix)
    np.testing.assert_array_equal(matrix.Convert2DenseMatrix(), np.eye(2))


# ---- sections and materials ------------------------------------------------------------------------------------------
def test_sections() -> None:
    section = exu.BeamSection()
    section.stiffnessMatrix = np.diag([1, 2, 3, 4, 5, 6])
    section.massPerLength = 3
    for other in (copy.copy(section), copy.deepcopy(section), pickle.loads(pickle.dumps(section))):
        np.testing.assert_array_equal(other.stiffnessMatrix, np.diag([1, 2, 3, 4, 5, 6]))
        assert other.massPerLength == 3 and other.inertia.shape == (3, 3)
    with pytest.raises(ValueError, match="BeamSection, parameter 'massPerLength': received -1"):
        section.massPerLength = -1
    with pytest.raises((ValueError, TypeError), match="parameter 'dampingMatrix': received 1"):
        section.dampingMatrix = 1
    with pytest.raises(AttributeError):
        section.mass = 1
    with pytest.raises(AttributeError, match="Did you mean 'inertia'?"):
        section.SetDictionary({"massPerLength": 7, "inerta": np.eye(3)})
    assert section.massPerLength == 3
    geometry = exu.BeamSectionGeometry()
    geometry.polygonalPoints = [[1, 2], [3, 4]]
    geometry.crossSectionType = exu.CrossSectionType.Circular
    assert geometry.crossSectionType == exu.CrossSectionType.Circular
    np.testing.assert_array_equal(pickle.loads(pickle.dumps(geometry)).polygonalPoints[1], [3, 4])
    with pytest.raises(TypeError, match="a member of CrossSectionType"):
        geometry.crossSectionType = 1


def test_materials() -> None:
    materials = exu.GraphicsMaterialList()
    assert len(materials) == 10
    new = materials.New()
    new.name = "mine"
    assert materials.Append(new) == 10 and materials.Get("mine").name == "mine"
    assert materials.Append(materials.GetDict(0) | {"name": "other"}) == 11
    materials[1].name = "changed"
    assert materials.Get(1).name == "changed"
    with pytest.raises(ValueError, match="there is no material 'minee'. Did you mean 'mine'?"):
        materials.Get("minee")
    with pytest.raises(IndexError, match="there is no material 12"):
        materials[12]
    materials.Reset()
    assert len(materials) == 10


def test_matrices_of_items_are_not_those_of_the_user() -> None:
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(
        exu.NodeGenericODE2(
            numberOfODE2Coordinates=2,
            referenceCoordinates=[0, 0],
            initialCoordinates=[0, 0],
            initialCoordinates_t=[0, 0],
        )
    )
    given = exu.MatrixContainer(np.eye(2))
    body = mbs.AddObject(exu.ObjectGenericODE2(nodeNumbers=[node], massMatrix=given, stiffnessMatrix=given))
    mbs.Assemble()
    read = mbs.GetObjectParameter(body, "massMatrix")
    for matrix in (given, read):
        matrix.AddSparseMatrix(exu.MatrixContainer(np.ones((2, 2))))
        np.testing.assert_array_equal(matrix.GetPythonObject(), np.eye(2) + 1)
    mbs.SetObjectParameter(body, "forceVector", [1.0, 2.0])
    for name in ("massMatrix", "stiffnessMatrix"):
        np.testing.assert_array_equal(mbs.GetObjectParameter(body, name).GetPythonObject(), np.eye(2))
    mbs.SetObjectParameter(body, "stiffnessMatrix", 3 * np.eye(2))
    np.testing.assert_array_equal(mbs.GetObjectParameter(body, "massMatrix").GetPythonObject(), np.eye(2))
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveStatic(settings)
    # Two equations with pivots of one: exact but for the rounding of a division.
    np.testing.assert_allclose(mbs.systemData.GetODE2Coordinates(), [1 / 3, 2 / 3], rtol=1e-14, atol=0)


def test_a_single_matrix_is_a_list_with_one() -> None:
    plate = exu.ObjectANCFThinPlate(physicsStrainCoefficients=np.diag([1.0, 2, 3]))
    assert np.array(plate.physicsStrainCoefficients[0]).tolist() == [[1, 0, 0], [0, 2, 0], [0, 0, 3]]
    assert len(plate.physicsStrainCoefficients) == 1
    with pytest.raises(ValueError, match="physicsStrainCoefficients"):
        exu.ObjectANCFThinPlate(physicsStrainCoefficients=np.eye(2))
