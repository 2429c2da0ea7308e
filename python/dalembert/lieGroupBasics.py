"""Exponential maps, tangent operators and compositions on SO(3), S3, SE(3) and R3xSO(3).

Tangent operators T are those of local (left-invariant) velocities: T(x) @ x_t is the local velocity of Exp(x). Their
coefficients are f_k = sum_n (-1)^n angle^(2n) / (2n+k)!, evaluated by series for small angles. Motion vectors are
[translation, rotation vector] (Bruels, Cardona, Arnold, Mechanism and Machine Theory 48, 2012; Sonneville, Cardona,
Bruels, CMAME 268, 2014).
"""

from __future__ import annotations

from math import atan2, cos, factorial, pi, sin, tan

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, as_matrix, as_rotation, as_vector
from dalembert._geometry.rotations import (
    _GIMBAL,
    EulerParameters2RotationMatrix,
    RotationMatrix2RotationVector,
    RotationMatrix2RotXYZ,
    RotationMatrixX,
    RotationMatrixY,
    RotXYZ2RotationMatrix,
    Skew,
    Skew2Vec,
    quaternion_product,
)
from dalembert._geometry.transformations import HomogeneousTransformation, HT2rotationMatrix, HT2translation


def Sinc(x: float) -> float:
    """Return sin(x)/x, and 1 for x = 0."""
    return sin(x) / x if x != 0.0 else 1.0


def Cot(x: float) -> float:
    """Return the cotangent 1/tan(x)."""
    return 1.0 / tan(x)


def _series(angle: float, k: int) -> float:
    """Return f_k = sum over n of (-1)^n * angle^(2n) / (2n+k)!, for small angles."""
    return sum((-1) ** n * angle ** (2 * n) / factorial(2 * n + k) for n in range(10))


def _coefficients(angle: float) -> tuple[float, float, float, float]:
    """Return f_2, f_3, f_4, f_5, with (1-cos)/angle^2 = f_2 and (angle-sin)/angle^3 = f_3 for large angles."""
    if angle < 1.0:
        return _series(angle, 2), _series(angle, 3), _series(angle, 4), _series(angle, 5)
    square = angle * angle
    f2, f3 = (1 - cos(angle)) / square, (angle - sin(angle)) / (square * angle)
    return f2, f3, (0.5 - f2) / square, (1 / 6 - f3) / square


def R3xSO3Matrix2RotationMatrix(G: npt.ArrayLike) -> FloatArray:
    """Return the 3x3 rotation matrix of a 7x7 matrix of R3xSO(3)."""
    return as_rotation("G[:3, :3]", as_matrix("R3xSO3Matrix2RotationMatrix: G", G, (7, 7))[:3, :3])


def R3xSO3Matrix2Translation(G: npt.ArrayLike) -> FloatArray:
    """Return the translation vector of a 7x7 matrix of R3xSO(3)."""
    return as_matrix("R3xSO3Matrix2Translation: G", G, (7, 7))[3:6, 6]


def R3xSO3Matrix(x: npt.ArrayLike, R: npt.ArrayLike) -> FloatArray:
    """Return the 7x7 matrix of R3xSO(3) of a translation vector x and a 3x3 rotation matrix R."""
    G = np.eye(7)
    G[:3, :3] = as_rotation("R3xSO3Matrix: R", R)
    G[3:6, 6] = as_vector("R3xSO3Matrix: x", x, 3)
    return G


def ExpSO3(Omega: npt.ArrayLike) -> FloatArray:
    """Return the 3x3 rotation matrix of a rotation vector (Rodrigues' formula)."""
    w = as_vector("ExpSO3: Omega", Omega, 3)
    angle, S = float(np.linalg.norm(w)), Skew(w)
    return np.eye(3) + Sinc(angle) * S + 0.5 * Sinc(0.5 * angle) ** 2 * (S @ S)


def ExpS3(Omega: npt.ArrayLike) -> FloatArray:
    """Return the 4 Euler parameters (scalar part first) of a rotation vector."""
    w = as_vector("ExpS3: Omega", Omega, 3)
    half = 0.5 * float(np.linalg.norm(w))
    return np.concatenate([[cos(half)], 0.5 * Sinc(half) * w])


def LogSO3(R: npt.ArrayLike) -> FloatArray:
    """Return the 3x3 skew matrix of the rotation vector of a rotation matrix, for angles in [0, pi]."""
    return Skew(RotationMatrix2RotationVector(R))


def TExpSO3(Omega: npt.ArrayLike) -> FloatArray:
    """Return the 3x3 tangent operator T with (local angular velocity) = T @ Omega_t."""
    w = as_vector("TExpSO3: Omega", Omega, 3)
    S = Skew(w)
    f2, f3, _, _ = _coefficients(float(np.linalg.norm(w)))
    return np.eye(3) - f2 * S + f3 * (S @ S)


def _inverse_coefficients(angle: float) -> tuple[float, float]:
    """Return c = (1 - angle/2*cot(angle/2))/angle^2 and its derivative with respect to angle^2/2."""
    square = angle * angle
    if angle < 1.0:  # series of x*cot(x), from the Bernoulli numbers B_2 ... B_18
        bernoulli = [1 / 6, 1 / 30, 1 / 42, 1 / 30, 5 / 66, 691 / 2730, 7 / 6, 3617 / 510, 43867 / 798]
        terms = [b / factorial(2 * n) for n, b in enumerate(bernoulli, start=1)]
        c = sum(term * square**n for n, term in enumerate(terms))
        return c, sum(2 * n * term * square ** (n - 1) for n, term in enumerate(terms) if n > 0)
    half = 0.5 * angle
    c = (1 - half * Cot(half)) / square
    slope = (half / sin(half) ** 2 - Cot(half)) / (2 * square) - 2 * c / angle
    return c, slope / angle


def TExpSO3Inv(Omega: npt.ArrayLike) -> FloatArray:
    """Return the inverse of TExpSO3; singular for rotations by 2*pi."""
    w = as_vector("TExpSO3Inv: Omega", Omega, 3)
    S = Skew(w)
    c, _ = _inverse_coefficients(float(np.linalg.norm(w)))
    return np.eye(3) + 0.5 * S + c * (S @ S)


def ExpSE3(x: npt.ArrayLike) -> FloatArray:
    """Return the 4x4 homogeneous transformation of a motion vector with 6 components."""
    motion = as_vector("ExpSE3: x", x, 6)
    return HomogeneousTransformation(ExpSO3(motion[3:]), TExpSO3(motion[3:]).T @ motion[:3])


def LogSE3(H: npt.ArrayLike) -> FloatArray:
    """Return the 4x4 matrix [[Skew(rotation vector), translation part], [0, 0]] with ExpSE3 of it equal to H."""
    result = np.zeros((4, 4))
    result[:3, :3] = LogSO3(HT2rotationMatrix(H))
    result[:3, 3] = TExpSO3Inv(Skew2Vec(result[:3, :3])).T @ HT2translation(H)
    return result


def _block(T: FloatArray, coupling: FloatArray) -> FloatArray:
    return np.block([[T, coupling], [np.zeros((3, 3)), T]])


def TExpSE3(x: npt.ArrayLike) -> FloatArray:
    """Return the 6x6 tangent operator of ExpSE3; its upper right block is the directional derivative of TExpSO3."""
    motion = as_vector("TExpSE3: x", x, 6)
    U, S = Skew(motion[:3]), Skew(motion[3:])
    f2, f3, f4, f5 = _coefficients(float(np.linalg.norm(motion[3:])))
    along = motion[:3] @ motion[3:]
    coupling = -f2 * U + f3 * (U @ S + S @ U) + along * ((f3 - 2 * f4) * S - (f4 - 3 * f5) * (S @ S))
    return _block(TExpSO3(motion[3:]), coupling)


def TExpSE3Inv(x: npt.ArrayLike) -> FloatArray:
    """Return the inverse of TExpSE3; singular for rotations by 2*pi."""
    motion = as_vector("TExpSE3Inv: x", x, 6)
    U, S = Skew(motion[:3]), Skew(motion[3:])
    c, slope = _inverse_coefficients(float(np.linalg.norm(motion[3:])))
    coupling = 0.5 * U + c * (U @ S + S @ U) + slope * (motion[:3] @ motion[3:]) * (S @ S)
    return _block(TExpSO3Inv(motion[3:]), coupling)


def ExpR3xSO3(x: npt.ArrayLike) -> FloatArray:
    """Return the 7x7 matrix of R3xSO(3) of a motion vector with 6 components."""
    motion = as_vector("ExpR3xSO3: x", x, 6)
    return R3xSO3Matrix(motion[:3], ExpSO3(motion[3:]))


def _on_rotations(T: FloatArray) -> FloatArray:
    result = np.eye(6)
    result[3:, 3:] = T
    return result


def TExpR3xSO3(x: npt.ArrayLike) -> FloatArray:
    """Return the 6x6 tangent operator of ExpR3xSO3."""
    return _on_rotations(TExpSO3(as_vector("TExpR3xSO3: x", x, 6)[3:]))


def TExpR3xSO3Inv(x: npt.ArrayLike) -> FloatArray:
    """Return the inverse of TExpR3xSO3."""
    return _on_rotations(TExpSO3Inv(as_vector("TExpR3xSO3Inv: x", x, 6)[3:]))


def _split(q0: npt.ArrayLike, size: int, increment: npt.ArrayLike) -> tuple[FloatArray, ...]:
    """Return position and rotation parameters of q0, and position and rotation increments."""
    q, dq = as_vector("q0", q0, size), as_vector("incrementalMotionVector", increment, 6)
    return q[:3], q[3:], dq[:3], dq[3:]


def _moved_locally(x: FloatArray, R: FloatArray, dx: FloatArray, w: FloatArray) -> FloatArray:
    """Return the position after an increment of SE(3) in the frame with the rotation matrix R."""
    return x + R @ (TExpSO3(w).T @ dx)


def CompositionRuleDirectProductR3AndS3(q0: npt.ArrayLike, incrementalMotionVector: npt.ArrayLike) -> FloatArray:
    """Return [position, Euler parameters] q0 (7) after an increment (6): global translation, local rotation vector."""
    x, p, dx, w = _split(q0, 7, incrementalMotionVector)
    return np.concatenate([x + dx, quaternion_product(p, ExpS3(w))])


def CompositionRuleSemiDirectProductR3AndS3(q0: npt.ArrayLike, incrementalMotionVector: npt.ArrayLike) -> FloatArray:
    """Return [position, Euler parameters] q0 (7) after an increment (6) of SE(3), in the local frame."""
    x, p, dx, w = _split(q0, 7, incrementalMotionVector)
    R = EulerParameters2RotationMatrix(p)
    return np.concatenate([_moved_locally(x, R, dx, w), quaternion_product(p, ExpS3(w))])


def CompositionRuleDirectProductR3AndR3RotVec(q0: npt.ArrayLike, incrementalMotionVector: npt.ArrayLike) -> FloatArray:
    """Return [position, rotation vector] q0 (6) after an increment (6): global translation, local rotation vector."""
    x, v, dx, w = _split(q0, 6, incrementalMotionVector)
    return np.concatenate([x + dx, CompositionRuleForRotationVectors(v, w)])


def CompositionRuleSemiDirectProductR3AndR3RotVec(
    q0: npt.ArrayLike, incrementalMotionVector: npt.ArrayLike
) -> FloatArray:
    """Return [position, rotation vector] q0 (6) after an increment (6) of SE(3), in the local frame."""
    x, v, dx, w = _split(q0, 6, incrementalMotionVector)
    return np.concatenate([_moved_locally(x, ExpSO3(v), dx, w), CompositionRuleForRotationVectors(v, w)])


def CompositionRuleDirectProductR3AndR3RotXYZAngles(
    q0: npt.ArrayLike, incrementalMotionVector: npt.ArrayLike
) -> FloatArray:
    """Return [position, Tait-Bryan angles] q0 (6) after an increment (6): global translation, local rotation vector."""
    x, a, dx, w = _split(q0, 6, incrementalMotionVector)
    return np.concatenate([x + dx, CompositionRuleRotXYZAnglesRotationVector(a, w)])


def CompositionRuleSemiDirectProductR3AndR3RotXYZAngles(
    q0: npt.ArrayLike, incrementalMotionVector: npt.ArrayLike
) -> FloatArray:
    """Return [position, Tait-Bryan angles] q0 (6) after an increment (6) of SE(3), in the local frame."""
    x, a, dx, w = _split(q0, 6, incrementalMotionVector)
    position = _moved_locally(x, RotXYZ2RotationMatrix(a), dx, w)
    return np.concatenate([position, CompositionRuleRotXYZAnglesRotationVector(a, w)])


def CompositionRuleForEulerParameters(q: npt.ArrayLike, p: npt.ArrayLike) -> FloatArray:
    """Return the product of two quaternions (scalar part first): rotation q followed by p in the rotated frame."""
    return quaternion_product(
        as_vector("CompositionRuleForEulerParameters: q", q, 4), as_vector("CompositionRuleForEulerParameters: p", p, 4)
    )


def CompositionRuleForRotationVectors(v0: npt.ArrayLike, Omega: npt.ArrayLike) -> FloatArray:
    """Return the rotation vector of v0 followed by Omega in the rotated frame, with an angle in [0, 2*pi]."""
    p = quaternion_product(ExpS3(v0), ExpS3(Omega))
    halfSine = float(np.linalg.norm(p[1:]))
    return np.zeros(3) if halfSine == 0.0 else 2 * atan2(halfSine, p[0]) / halfSine * p[1:]


def CompositionRuleRotXYZAnglesRotationVector(alpha0: npt.ArrayLike, Omega: npt.ArrayLike) -> FloatArray:
    """Return the Tait-Bryan angles of alpha0 followed by the local rotation vector Omega, within pi of alpha0.

    If the first and last axis coincide, the first angle keeps its value.
    """
    a = as_vector("CompositionRuleRotXYZAnglesRotationVector: alpha0", alpha0, 3)
    R = RotXYZ2RotationMatrix(a) @ ExpSO3(Omega)
    angles = RotationMatrix2RotXYZ(R)
    if np.hypot(R[1, 2], R[2, 2]) <= _GIMBAL:
        rest = (RotationMatrixX(a[0]) @ RotationMatrixY(angles[1])).T @ R
        angles = np.array([a[0], angles[1], atan2(rest[1, 0], rest[1, 1])])
    return a + (angles - a + pi) % (2 * pi) - pi
