"""Type checks, excitation functions, sparse matrices and HDF5 files."""

import numpy as np
import pytest
from scipy.sparse import csr_matrix, random_array

import dalembert as exu
from dalembert import advancedUtilities as au


@pytest.mark.parametrize(
    ("function", "valid", "invalid"),
    [
        (au.IsValidBool, [True, 1, np.int64(0)], [1.0, "a", None]),
        (au.IsValidRealInt, [1, 1.5, np.float64(1), np.int32(1)], ["1", None, [1], np.float32(1)]),
        (au.IsValidInt, [1, np.int64(2)], [1.0, None]),
        (au.IsValidPRealInt, [1, 1e-9], [0, -1, None]),
        (au.IsValidURealInt, [1, 0], [-1e-9, "a"]),
        (au.IsReal, [1.0, np.float32(1)], [1, None]),
        (au.IsInteger, [1, np.int8(1)], [1.0]),
        (au.IsVector, [[], [1, 2.5], np.ones(3)], [(1, 2), ["a"], 5, np.eye(2)]),
        (au.IsIntVector, [[1, 2], np.array([1])], [[1.0], np.ones(2), None]),
        (au.IsSquareMatrix, [[[1, 2], [3, 4]], np.eye(3), []], [[[1, 2]], [1, 2], np.ones((2, 3))]),
        (au.IsEmptyList, [[], np.array([])], [[1], None, ()]),
        (au.IsListOrArray, [[], np.ones(1)], [(), 1]),
        (au.IsNone, [None], [0, np.ones(2)]),
        (au.IsNotNone, [0, np.ones(2)], [None]),
    ],
)
def test_type_checks(function, valid, invalid):
    assert all(function(x) for x in valid)
    assert not any(function(x) for x in invalid)


def test_sizes_are_checked():
    assert au.IsVector([1, 2], 2)
    assert not au.IsVector([1, 2], 3)
    assert not au.IsIntVector([1, 2], 3)
    assert not au.IsSquareMatrix(np.eye(2), 3)
    assert not au.IsListOrArray([], checkIfNoneEmpty=True)


class ObjectIndex(int):
    """Stands for the index type of the core."""


class NodeIndex(int):
    """Stands for the index type of the core."""


def test_item_indices_have_types(capsys):
    index = type("ObjectIndex", (), {})()
    assert au.IsValidObjectIndex(index)
    assert not au.IsValidNodeIndex(index)
    assert not au.IsValidMarkerIndex(index)
    assert au.IsValidMarkerIndex(3)
    variables = {"wheel": ObjectIndex(2), "nWheel": NodeIndex(2), "n": 2}
    au.FindObjectIndex(2, variables)
    au.FindNodeIndex(3, variables)
    assert capsys.readouterr().out == "variable 'wheel' links to object 2\nno variable links to node 3\n"


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        ({"expectedType": au.ExpectedType.Vector, "dim": 3}, r"expected Vector \(list or numpy array\) of size 3,"),
        ({"expectedType": au.ExpectedType.Matrix, "dim": 3}, r"of size \(3,3\), received \[1\]"),
        ({"expectedType": au.ExpectedType.Matrix, "dim": 3, "cols": 2}, r"of size \(3,2\)"),
        ({"expectedType": "a wheel"}, "expected a wheel, received"),
    ],
)
def test_type_errors_name_everything(arguments, text):
    with pytest.raises(ValueError, match="ERROR in F in argument x: .*" + text):
        au.RaiseTypeError(where="F", argumentName="x", received=[1], **arguments)


def test_line_codes_are_different_and_end_with_dotted_black():
    codes = [au.PlotLineCode(i) for i in range(28)]
    assert len(set(codes)) == 28
    assert codes[:2] + codes[7:8] == ["r-", "g-", "r:"]
    assert au.PlotLineCode(28) == "k:"


def test_sweep_has_the_swept_frequency():
    t, h = 0.7, 1e-6
    phase = 2 * np.pi * au.FrequencySweep(t, 2, 1, 5)
    assert (au.SweepSin(t + h, 2, 1, 5) - au.SweepSin(t - h, 2, 1, 5)) / (2 * h) == pytest.approx(
        phase * au.SweepCos(t, 2, 1, 5), rel=1e-6
    )
    assert au.FrequencySweep(0, 2, 1, 5) == 1
    assert au.FrequencySweep(2, 2, 1, 5) == 5


def test_smooth_step_and_its_derivative():
    arguments = (1, 3, -2, 4)
    assert [au.SmoothStep(x, *arguments) for x in (0, 1, 2, 3, 9)] == pytest.approx([-2, -2, 1, 4, 4])
    for x in (0.5, 1.3, 2.2, 3.5):
        numerical = (au.SmoothStep(x + 1e-6, *arguments) - au.SmoothStep(x - 1e-6, *arguments)) / 2e-6
        assert au.SmoothStepDerivative(x, *arguments) == pytest.approx(numerical, abs=1e-8)


def test_index_from_value():
    data = np.linspace(0, 1, 11)
    assert au.IndexFromValue(data, 0.3) == 3
    assert au.IndexFromValue(data, 0.349, assumeConstantSampleRate=True) == 3
    with pytest.warns(UserWarning, match="using index 10"):
        assert au.IndexFromValue(data, 5, assumeConstantSampleRate=True) == 10
    assert au.IndexFromValue(data, -5, assumeConstantSampleRate=True, rangeWarning=False) == 0
    with pytest.raises(ValueError, match=r"0.35 is not in data within the tolerance 1e-07"):
        au.IndexFromValue(data, 0.35)


def test_matrices_are_changed_in_place():
    matrix = np.array([[1e-15, -1e-15], [1.0, 2e-14]])
    au.RoundMatrix(matrix)
    assert matrix.tolist() == [[0, 0], [1, 2e-14]]
    au.FillInSubMatrix(np.array([[5.0]]), matrix, 1, 0)
    assert matrix[1, 0] == 5
    with pytest.raises(ValueError, match=r"subMatrix: expected a matrix not larger than \(1, 2\)"):
        au.FillInSubMatrix(np.eye(2), matrix, 1, 0)


def test_sparse_matrices_survive_as_dictionary():
    matrix = random_array((5, 7), density=0.3, rng=1)
    again = au.ConvertDictToScipySparse(au.ConvertScipySparseToDict(matrix))
    assert again.shape == (5, 7)
    assert (again.toarray() == matrix.toarray()).all()
    with pytest.raises(ValueError, match="expected a scipy sparse matrix"):
        au.ConvertScipySparseToDict([[1]])


def spring_force(mbs, t, itemNumber):
    return t


def test_hdf5_file_returns_the_dictionary(tmp_path):
    data = {
        "numbers": [1, 2.5, True, None, "text"],
        "nested": {"array": np.arange(6.0).reshape(2, 3), "list": [[1, [2, 3]], {"a": np.float64(1)}]},
        "matrix": csr_matrix(np.eye(3)),
        "integer": np.int64(7),
        "force": {"function": spring_force, "type": "Python"},
        "empty": [],
    }
    fileName = str(tmp_path / "data.h5")
    au.SaveDictToHDF5(fileName, data)
    loaded = au.LoadDictFromHDF5(fileName, callerGlobals=globals())
    assert set(loaded) == set(data)
    assert loaded["numbers"] == data["numbers"]
    assert [type(x) for x in loaded["numbers"]] == [type(x) for x in data["numbers"]]
    assert (loaded["nested"]["array"] == data["nested"]["array"]).all()
    assert loaded["nested"]["list"] == [[1, [2, 3]], {"a": 1.0}]
    assert (loaded["matrix"] != data["matrix"]).nnz == 0
    assert loaded["integer"] == 7
    assert loaded["force"]["function"] is spring_force
    assert loaded["empty"] == []
    with pytest.raises(ValueError, match="function 'spring_force' is not in callerGlobals"):
        au.LoadDictFromHDF5(fileName)
    with pytest.raises(ValueError, match="SaveDictToHDF5: a/b: expected a number"):
        au.SaveDictToHDF5(fileName, {"a": {"b": object()}})


def constant_force(mbs, t, loadVector):
    return [0, 0, 2 * t]


def before_step(mbs, t):
    return True


def test_hdf5_file_of_a_system(tmp_path):
    """The system comes back with its user functions, those of items and those that solvers call."""
    mbs = exu.SystemContainer().AddSystem()
    body = mbs.CreateMassPoint(physicsMass=1)
    mbs.CreateForce(bodyNumber=body, loadVectorUserFunction=constant_force)
    mbs.SetPreStepUserFunction(before_step)
    mbs.interactiveMode = True
    fileName = str(tmp_path / "mbs.h5")
    au.SaveDictToHDF5(fileName, mbs.GetDictionary())
    again = exu.SystemContainer().AddSystem()
    again.SetDictionary(au.LoadDictFromHDF5(fileName, globals()))
    assert again.GetLoadParameter(0, "loadVectorUserFunction") is constant_force
    assert again.GetPreStepUserFunction() is before_step
    assert again.GetPostStepUserFunction() == 0
    assert again.interactiveMode
    assert repr(again) == repr(mbs)
