"""Homogeneous transformations (4x4) and Pluecker coordinate transformations (6x6).

A homogeneous transformation T = [[A, r], [0, 1]] maps local to global points. The 6x6 transformations act on spatial
vectors with the rotational part first (Featherstone, Rigid Body Dynamics Algorithms, chapter 2); built from A and v
they read [[A, 0], [Skew(v) @ A, A]]. Lengths in m, angles in rad.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, as_matrix, as_rotation, as_transformation, as_vector, floats
from dalembert._core import _array, _is_transformation
from dalembert._geometry.rotations import RotationMatrixX, RotationMatrixY, RotationMatrixZ, Skew, Skew2Vec


def HomogeneousTransformation(A: npt.ArrayLike, r: npt.ArrayLike) -> FloatArray:
    """Return the 4x4 homogeneous transformation of a 3x3 rotation matrix A and a translation vector r."""
    return _assembled(as_rotation("HomogeneousTransformation: A", A), as_vector("HomogeneousTransformation: r", r, 3))


def _assembled(A: FloatArray, r: FloatArray) -> FloatArray:
    T = np.zeros((4, 4))
    T[:3, :3] = A
    T[:3, 3] = r
    T[3, 3] = 1.0
    return T


HT = HomogeneousTransformation


def HTtranslate(r: npt.ArrayLike) -> FloatArray:
    """Return the 4x4 homogeneous transformation of a translation by the 3D vector r."""
    x, y, z = floats("HTtranslate: r", r, 3)
    return _array(4, 1.0, 0.0, 0.0, x, 0.0, 1.0, 0.0, y, 0.0, 0.0, 1.0, z, 0.0, 0.0, 0.0, 1.0)


def HTtranslateX(x: float) -> FloatArray:
    """Return the 4x4 homogeneous transformation of a translation by x along the x axis."""
    return HTtranslate([x, 0.0, 0.0])


def HTtranslateY(y: float) -> FloatArray:
    """Return the 4x4 homogeneous transformation of a translation by y along the y axis."""
    return HTtranslate([0.0, y, 0.0])


def HTtranslateZ(z: float) -> FloatArray:
    """Return the 4x4 homogeneous transformation of a translation by z along the z axis."""
    return HTtranslate([0.0, 0.0, z])


def HT0() -> FloatArray:
    """Return the 4x4 identity transformation."""
    return np.eye(4)


def HTrotateX(angle: float) -> FloatArray:
    """Return the 4x4 homogeneous transformation of a rotation about the x axis."""
    return _assembled(RotationMatrixX(angle), np.zeros(3))


def HTrotateY(angle: float) -> FloatArray:
    """Return the 4x4 homogeneous transformation of a rotation about the y axis."""
    return _assembled(RotationMatrixY(angle), np.zeros(3))


def HTrotateZ(angle: float) -> FloatArray:
    """Return the 4x4 homogeneous transformation of a rotation about the z axis."""
    return _assembled(RotationMatrixZ(angle), np.zeros(3))


def HT2translation(T: npt.ArrayLike) -> FloatArray:
    """Return the translation of a 4x4 homogeneous transformation, or of its logarithm (a view of a float array)."""
    matrix: Any = T
    if _is_transformation(matrix):  # the usual case
        return matrix[:3, 3]
    return as_matrix("HT2translation: T", T, (4, 4))[:3, 3]


def HT2rotationMatrix(T: npt.ArrayLike) -> FloatArray:
    """Return the 3x3 rotation matrix of a 4x4 homogeneous transformation (a view if T is a float array)."""
    return as_transformation("HT2rotationMatrix: T", T)[:3, :3]


def InverseHT(T: npt.ArrayLike) -> FloatArray:
    """Return the inverse of a 4x4 homogeneous transformation."""
    A, r = _parts(T)
    back = A.T
    return _assembled(back, -back @ r)


def _parts(T: npt.ArrayLike) -> tuple[FloatArray, FloatArray]:
    checked = as_transformation("T", T)
    return checked[:3, :3], checked[:3, 3]


def RotationX2T66(angle: float) -> FloatArray:
    """Return the 6x6 transformation of a rotation about the x axis."""
    return RotationTranslation2T66(RotationMatrixX(angle), np.zeros(3))


def RotationY2T66(angle: float) -> FloatArray:
    """Return the 6x6 transformation of a rotation about the y axis."""
    return RotationTranslation2T66(RotationMatrixY(angle), np.zeros(3))


def RotationZ2T66(angle: float) -> FloatArray:
    """Return the 6x6 transformation of a rotation about the z axis."""
    return RotationTranslation2T66(RotationMatrixZ(angle), np.zeros(3))


def Translation2T66(translation3D: npt.ArrayLike) -> FloatArray:
    """Return the 6x6 transformation [[I, 0], [-Skew(translation3D), I]] of a translation.

    Note the sign: RotationTranslation2T66 has +Skew(v) in the same place.
    """
    T66 = np.eye(6)
    T66[3:, :3] = -Skew(as_vector("Translation2T66: translation3D", translation3D, 3))
    return T66


def TranslationX2T66(translation: float) -> FloatArray:
    """Return the 6x6 transformation of a translation along the x axis."""
    return Translation2T66([translation, 0.0, 0.0])


def TranslationY2T66(translation: float) -> FloatArray:
    """Return the 6x6 transformation of a translation along the y axis."""
    return Translation2T66([0.0, translation, 0.0])


def TranslationZ2T66(translation: float) -> FloatArray:
    """Return the 6x6 transformation of a translation along the z axis."""
    return Translation2T66([0.0, 0.0, translation])


def T66toRotationTranslation(T66: npt.ArrayLike) -> list[FloatArray]:
    """Return [A, v] such that RotationTranslation2T66(A, v) is the 6x6 matrix T66."""
    X = as_matrix("T66toRotationTranslation: T66", T66, (6, 6))
    A = as_rotation("T66[:3, :3]", X[:3, :3])
    return [A, Skew2Vec(X[3:, :3] @ A.T)]


def InverseT66toRotationTranslation(T66: npt.ArrayLike) -> list[FloatArray]:
    """Return [A, v] such that RotationTranslation2T66Inverse(A, v) is the 6x6 matrix T66."""
    X = as_matrix("InverseT66toRotationTranslation: T66", T66, (6, 6))
    A = as_rotation("T66[:3, :3]", X[:3, :3]).T
    return [A, -Skew2Vec(A @ X[3:, :3])]


def RotationTranslation2T66(A: npt.ArrayLike, v: npt.ArrayLike) -> FloatArray:
    """Return the 6x6 transformation [[A, 0], [Skew(v) @ A, A]]."""
    rotation = as_rotation("RotationTranslation2T66: A", A)
    return lower_block(rotation, Skew(as_vector("RotationTranslation2T66: v", v, 3)) @ rotation)


def RotationTranslation2T66Inverse(A: npt.ArrayLike, v: npt.ArrayLike) -> FloatArray:
    """Return the inverse of RotationTranslation2T66(A, v): [[A.T, 0], [-A.T @ Skew(v), A.T]]."""
    rotation = as_rotation("RotationTranslation2T66Inverse: A", A)
    return lower_block(rotation.T, -rotation.T @ Skew(as_vector("RotationTranslation2T66Inverse: v", v, 3)))


def T66Inverse(T66: npt.ArrayLike) -> FloatArray:
    """Return the inverse of a 6x6 transformation, using its structure."""
    return RotationTranslation2T66Inverse(*T66toRotationTranslation(T66))


def T66toHT(T66: npt.ArrayLike) -> FloatArray:
    """Return the 4x4 homogeneous transformation of rotation and translation of T66.

    This is the inverse of the transformation that Featherstone's pluho() returns.
    """
    return HomogeneousTransformation(*T66toRotationTranslation(T66))


def HT2T66Inverse(T: npt.ArrayLike) -> FloatArray:
    """Return the inverse 6x6 transformation of a 4x4 homogeneous transformation."""
    return RotationTranslation2T66Inverse(*_parts(T))


def InertiaTensor2Inertia6D(inertiaTensor: npt.ArrayLike) -> list[float]:
    """Return the list [Jxx, Jyy, Jzz, Jyz, Jxz, Jxy] of a symmetric 3x3 inertia tensor."""
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = as_matrix(
        "InertiaTensor2Inertia6D: inertiaTensor", inertiaTensor, (3, 3)
    ).tolist()
    return [xx, yy, zz, yz, xz, xy]


def Inertia6D2InertiaTensor(inertia6D: npt.ArrayLike) -> FloatArray:
    """Return the symmetric 3x3 inertia tensor of [Jxx, Jyy, Jzz, Jyz, Jxz, Jxy]."""
    xx, yy, zz, yz, xz, xy = as_vector("Inertia6D2InertiaTensor: inertia6D", inertia6D, 6)
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def lower_block(diagonal: FloatArray, lower: FloatArray) -> FloatArray:
    """Return the 6x6 matrix [[diagonal, 0], [lower, diagonal]]."""
    result: npt.NDArray[Any] = np.zeros((6, 6))
    result[:3, :3] = result[3:, 3:] = diagonal
    result[3:, :3] = lower
    return result
