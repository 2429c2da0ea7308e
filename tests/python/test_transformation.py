"""exu.HT against scipy, matrix functions, and the properties that define its operations."""

from __future__ import annotations

import copy
import pickle

import numpy as np
import pytest
from scipy.linalg import expm, logm
from scipy.spatial.transform import Rotation

import dalembert as exu
from dalembert.rigidBodyUtilities import HT as array_of_HT

A = Rotation.from_rotvec([0.3, -0.5, 0.8]).as_matrix()
R = [1.0, -2.0, 0.5]
H = exu.HT(A, R)
G = exu.HT(rotationVector=[-1.1, 0.2, 0.4], translation=[0.1, 0.2, -0.3])
ROUND_OFF = {"rtol": 0, "atol": 1e-14}  # products of a few numbers of size one


def matrix_of(vector: np.ndarray) -> np.ndarray:
    """Return the 4 x 4 matrix [[skew(w), u], [0, 0]] of six numbers u, w."""
    x, y, z = vector[3:]
    return np.array([[0, -z, y, vector[0]], [z, 0, -x, vector[1]], [-y, x, 0, vector[2]], [0, 0, 0, 0]])


def test_ways_to_make_one() -> None:
    turn = Rotation.from_matrix(A)
    x, y, z, s = turn.as_quat()
    for made in (
        exu.HT(rotation=A, translation=R),
        exu.HT(np.vstack([np.column_stack([A, R]), [0, 0, 0, 1]])),
        exu.HT(eulerParameters=[s, x, y, z], translation=R),
        exu.HT(rotationVector=[0.3, -0.5, 0.8], translation=R),
        exu.HT(Rxyz=turn.as_euler("XYZ"), translation=R),
        exu.HT().SetCoordinatesRotationVector([*R, 0.3, -0.5, 0.8]),
        exu.HT().SetCoordinatesEP([*R, s, x, y, z]),
        exu.HT().SetCoordinatesRxyz([*R, *turn.as_euler("XYZ")]),
        exu.HT().SetExpR3xSO3([*R, 0.3, -0.5, 0.8]),
        exu.HT().SetTranslation(R) * exu.HT().SetRotationAxis([3, -5, 8], np.linalg.norm([0.3, -0.5, 0.8])),
    ):
        assert np.allclose(made, H, **ROUND_OFF)
    assert np.array_equal(exu.HT(), np.eye(4))
    axes = exu.HT().SetRotationX(0.1) * exu.HT().SetRotationY(0.2) * exu.HT().SetRotationZ(0.3)
    assert np.allclose(axes.rotation, Rotation.from_euler("XYZ", [0.1, 0.2, 0.3]).as_matrix(), **ROUND_OFF)
    assert np.allclose(array_of_HT(A, R), H, **ROUND_OFF)  # the function of 1.11 returns an array


def test_parts() -> None:
    assert np.allclose(H.GetRotationVector(), [0.3, -0.5, 0.8], **ROUND_OFF)
    assert np.allclose(H.GetRxyz(), Rotation.from_matrix(A).as_euler("XYZ"), **ROUND_OFF)
    assert np.allclose(H.GetEP()[1:], Rotation.from_matrix(A).as_quat()[:3], **ROUND_OFF)
    assert np.allclose(H.GetCoordinatesEP(), [*R, *H.GetEP()], **ROUND_OFF)
    assert H.RotationAngle() == pytest.approx(np.sqrt(0.98))
    assert np.allclose(H.RotationAxis() * H.RotationAngle(), [0.3, -0.5, 0.8], **ROUND_OFF)
    assert exu.HT().HasNoRotation()
    assert not H.HasNoRotation()
    rotation, translation = H.Get()
    rotation[0, 0] = translation[0] = 7  # copies
    assert np.allclose(H.Get()[0], A, **ROUND_OFF)
    with pytest.raises(ValueError, match="there is no rotation, and no axis"):
        exu.HT().RotationAxis()
    assert exu.HT().RotationAxis(raiseError=False).tolist() == [0, 0, 0]


def test_products_are_those_of_matrices() -> None:
    h, g = np.array(H), np.array(G)
    assert np.allclose(H * G, h @ g, **ROUND_OFF)
    assert np.allclose(H @ G, h @ g, **ROUND_OFF)
    assert np.allclose(H * [1, 2, 3], (h @ [1, 2, 3, 1])[:3], **ROUND_OFF)
    assert np.allclose(H @ [1, 2, 3, 1], h @ [1, 2, 3, 1], **ROUND_OFF)
    assert np.allclose(g @ H, g @ h, **ROUND_OFF)
    assert np.allclose(H.Inverse(), np.linalg.inv(h), **ROUND_OFF)
    assert np.allclose(H.Relative(G), np.linalg.inv(h) @ g, **ROUND_OFF)
    assert np.allclose(H.RotateVector([1, 2, 3]), A @ [1, 2, 3], **ROUND_OFF)
    assert np.allclose(H.RotateVectorTransposed([1, 2, 3]), A.T @ [1, 2, 3], **ROUND_OFF)
    inverted = copy.copy(H)
    inverted.Invert()
    assert inverted == H.Inverse() != H


def test_logarithms_and_exponentials() -> None:
    vector = H.LogSE3()
    assert np.allclose(matrix_of(vector), logm(np.array(H)), rtol=0, atol=1e-13)
    assert np.allclose(exu.HT().SetExpSE3(vector), expm(matrix_of(vector)), rtol=0, atol=1e-13)
    assert np.allclose(H.LogR3xSO3(), [*R, 0.3, -0.5, 0.8], **ROUND_OFF)


def test_interpolation() -> None:
    for interpolate in (H.InterpolateSE3, H.InterpolateSO3):
        assert np.allclose(interpolate(G, 0), H, **ROUND_OFF)
        assert np.allclose(interpolate(G, 1), G, rtol=0, atol=1e-13)
    half = H.InterpolateSE3(G, 0.5)
    assert np.allclose(H.Relative(half), half.Relative(G), rtol=0, atol=1e-13)  # equal screws
    half = H.InterpolateSO3(G, 0.5)
    assert np.allclose(half.translation, (H.translation + G.translation) / 2, **ROUND_OFF)
    assert np.allclose(H.Relative(half).rotation, half.Relative(G).rotation, rtol=0, atol=1e-13)


def test_an_HT_is_used_like_its_matrix() -> None:
    """Models that get an HT instead of a 4 x 4 array go on running."""
    matrix, x = np.array(H), np.array([1.0, 2, 3, 1])
    for found, expected in (
        (H - np.eye(4), matrix - np.eye(4)),
        (np.eye(4) - H, np.eye(4) - matrix),
        (H + H, 2 * matrix),
        (2 * H, 2 * matrix),
        (H * 2, 2 * matrix),
        (-H, -matrix),
        (H.T, matrix.T),
        (H.dot(x), matrix @ x),
        (np.dot(H, x), matrix @ x),
        (np.linalg.inv(H), np.linalg.inv(matrix)),
        (np.array([H, H]), [matrix, matrix]),
        (np.vstack(list(H)), matrix),
        (H.copy(), matrix),
        (matrix @ H, matrix @ matrix),
    ):
        assert isinstance(found, np.ndarray)
        np.testing.assert_allclose(found, expected, atol=1e-15)
    assert H.shape == (4, 4) and len(H) == 4 and H.tolist() == matrix.tolist()
    with pytest.raises(AttributeError, match="'HT' object has no attribute 'rotate'"):
        H.rotate  # noqa: B018


def test_entries_copies_and_pickles() -> None:
    own = copy.deepcopy(H)
    own[0:3, 3] = [4, 5, 6]
    assert own.translation.tolist() == [4, 5, 6]
    assert H.translation.tolist() == R
    assert own[0, 3] == 4
    assert H[:3, :3].tolist() == H.rotation.tolist()
    assert pickle.loads(pickle.dumps(H)) == H
    assert repr(exu.HT(translation=[1, 2, 3])) == "HT(rotation=[[1,0,0],[0,1,0],[0,0,1]], translation=[1,2,3])"
    with pytest.raises(ValueError, match=r"the last row is \[0, 0, 0, 1\]"):
        own[3, 0] = 1
    with pytest.raises(TypeError):
        hash(H)


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        ({"rotation": 2 * np.eye(3)}, "HT.rotation: expected a 3x3 rotation matrix"),
        ({"rotation": np.eye(3), "Rxyz": [0, 0, 0]}, "HT: rotation is given more than once, by rotation and Rxyz"),
        ({"rotation": np.eye(4), "translation": R}, "HT: translation is given twice, also by the 4 x 4 matrix"),
        ({"translation": [1, 2]}, "HT.translation"),
    ],
)
def test_mistakes(arguments: dict[str, object], text: str) -> None:
    with pytest.raises(ValueError, match=text):
        exu.HT(**arguments)  # type: ignore[arg-type]
