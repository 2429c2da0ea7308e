"""Rotation parameters and their rates: Euler parameters, rotation vector, Tait-Bryan and Euler angles.

A rotation matrix A maps components in the rotated (local) frame to components in the global frame. The rate matrices
map parameter rates to the angular velocity, G in the global and GLocal in the local frame (Shabana, Dynamics of
Multibody Systems, chapter 2). Angles in rad, angular velocities in rad/s.
"""

from __future__ import annotations

from math import atan2, cos, hypot, sin, sqrt

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, as_array, as_rotation, as_vector, floats, shape_error, unit_vector
from dalembert._core import _array

eulerParameters0: list[float] = [1.0, 0.0, 0.0, 0.0]  # rotation by the angle zero

_GIMBAL = 1e-14  # below this, the two outer axes of a sequence of angles count as parallel


def _cross(a: FloatArray, b: FloatArray) -> FloatArray:
    """Return the cross product of two 3D vectors; np.cross takes longer for its many other cases."""
    (a0, a1, a2), (b0, b1, b2) = a.tolist(), b.tolist()
    return np.array([a1 * b2 - a2 * b1, a2 * b0 - a0 * b2, a0 * b1 - a1 * b0])


def ComputeOrthonormalBasisVectors(vector0: npt.ArrayLike) -> list[FloatArray]:
    """Return the right-handed triad [vector0 normalized, normal1, normal2]; [zeros, e_x, e_y] for a zero vector."""
    v = as_vector("ComputeOrthonormalBasisVectors: vector0", vector0, 3)
    length = np.linalg.norm(v)
    if length == 0.0:
        return [v.copy(), np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])]
    v = v / length
    alongX = abs(v[0]) > 0.5 and abs(v[1]) < 0.1 and abs(v[2]) < 0.1
    helper = np.array([0.0, 1.0, 0.0]) if alongX else np.array([1.0, 0.0, 0.0])
    normal1 = helper - (helper @ v) * v
    normal1 /= np.linalg.norm(normal1)
    return [v, normal1, _cross(v, normal1)]


def ComputeOrthonormalBasis(vector0: npt.ArrayLike) -> FloatArray:
    """Return the 3x3 rotation matrix with the normalized vector0 as its first column (the other two are not unique)."""
    return np.column_stack(ComputeOrthonormalBasisVectors(vector0))


def GramSchmidt(vector0: npt.ArrayLike, vector1: npt.ArrayLike) -> list[FloatArray]:
    """Return the orthonormal triad [e0, e1, e0 x e1] with e0 along vector0 and e1 in the plane of both vectors.

    Raises ValueError if a vector is zero or if both are parallel.
    """
    e0 = unit_vector("GramSchmidt: vector0", vector0)
    e1 = unit_vector("GramSchmidt: vector1", vector1)
    e1 = e1 - (e1 @ e0) * e0
    length = np.linalg.norm(e1)
    if length == 0.0:
        raise shape_error("GramSchmidt: vector1", "a vector not parallel to vector0", vector1)
    e1 = e1 / length
    return [e0, e1, _cross(e0, e1)]


def Skew(vector: npt.ArrayLike) -> FloatArray:
    """Return the 3x3 matrix S of a 3D vector v, such that S @ w = v x w."""
    x, y, z = floats("Skew: vector", vector, 3)
    return _array(3, 0.0, -z, y, z, 0.0, -x, -y, x, 0.0)


def Skew2Vec(skew: npt.ArrayLike) -> FloatArray:
    """Return the vector of a skew matrix: 3 components for so(3) (3x3), [translation, rotation] for se(3) (4x4)."""
    s = as_array("Skew2Vec: skew", skew)
    if s.shape not in ((3, 3), (4, 4)):
        raise shape_error("Skew2Vec: skew", "a 3x3 or 4x4 matrix", skew)
    rotation = np.array([s[2, 1], s[0, 2], -s[0, 1]])
    return rotation if s.shape == (3, 3) else np.concatenate([s[:3, 3], rotation])


def ComputeSkewMatrix(v: npt.ArrayLike) -> FloatArray:
    """Return the skew matrices of the 3D vectors in v, one below the other.

    A vector with 3n components gives a (3n x 3) matrix; a (3n x m) matrix gives a (3n x 3m) matrix, three columns per
    column of v.
    """
    a = as_array("ComputeSkewMatrix: v", v)
    if a.ndim not in (1, 2) or a.size == 0 or a.shape[0] % 3 != 0:
        raise shape_error("ComputeSkewMatrix: v", "a vector with 3*n components or a matrix with 3*n rows", v)
    x, y, z = a.reshape(a.shape[0] // 3, 3, -1).transpose(1, 0, 2)
    skew = np.zeros((x.shape[0], 3, x.shape[1], 3))
    skew[:, 0, :, 1], skew[:, 0, :, 2] = -z, y
    skew[:, 1, :, 0], skew[:, 1, :, 2] = z, -x
    skew[:, 2, :, 0], skew[:, 2, :, 1] = -y, x
    return skew.reshape(a.shape[0], -1)


def EulerParameters2G(eulerParameters: npt.ArrayLike) -> FloatArray:
    """Return the 3x4 matrix G with (global) angular velocity = G @ eulerParameters_t."""
    s, u, v, w = (2.0 * p for p in floats("EulerParameters2G: eulerParameters", eulerParameters, 4))
    return _array(3, -u, s, -w, v, -v, w, s, -u, -w, -v, u, s)


def EulerParameters2GLocal(eulerParameters: npt.ArrayLike) -> FloatArray:
    """Return the 3x4 matrix GLocal with (local) angular velocity = GLocal @ eulerParameters_t."""
    s, u, v, w = (2.0 * p for p in floats("EulerParameters2GLocal: eulerParameters", eulerParameters, 4))
    return _array(3, -u, s, w, -v, -v, -w, s, u, -w, v, -u, s)


def EulerParameters2RotationMatrix(eulerParameters: npt.ArrayLike) -> FloatArray:
    """Return the 3x3 rotation matrix of 4 Euler parameters (scalar part first); they are not normalized here."""
    return _of_quaternion(*floats("EulerParameters2RotationMatrix: eulerParameters", eulerParameters, 4))


def _of_quaternion(s: float, u: float, v: float, w: float) -> FloatArray:
    """Return I + 2 (s S + S S) with S = Skew([u, v, w])."""
    return _array(
        3,
        *(1.0 - 2.0 * (v * v + w * w), 2.0 * (u * v - s * w), 2.0 * (u * w + s * v)),
        *(2.0 * (u * v + s * w), 1.0 - 2.0 * (u * u + w * w), 2.0 * (v * w - s * u)),
        *(2.0 * (u * w - s * v), 2.0 * (v * w + s * u), 1.0 - 2.0 * (u * u + v * v)),
    )


def RotationMatrix2EulerParameters(rotationMatrix: npt.ArrayLike) -> FloatArray:
    """Return the 4 normalized Euler parameters of a 3x3 rotation matrix, with a non-negative scalar part.

    All products 4*p_i*p_j are linear in the matrix entries; the row of the largest p_i gives p without cancellation
    (Shepperd, J. Guidance and Control 1, 1978).
    """
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = as_rotation(
        "RotationMatrix2EulerParameters: rotationMatrix", rotationMatrix
    ).tolist()
    trace = xx + yy + zz
    products = [
        [1.0 + trace, zy - yz, xz - zx, yx - xy],
        [zy - yz, 1.0 + 2.0 * xx - trace, xy + yx, xz + zx],
        [xz - zx, xy + yx, 1.0 + 2.0 * yy - trace, yz + zy],
        [yx - xy, xz + zx, yz + zy, 1.0 + 2.0 * zz - trace],
    ]
    largest = max(range(4), key=lambda i: products[i][i])
    s, u, v, w = products[largest]
    length = sqrt(s * s + u * u + v * v + w * w)
    if s < 0.0:
        length = -length
    return _array(1, s / length, u / length, v / length, w / length)


def AngularVelocity2EulerParameters_t(angularVelocity: npt.ArrayLike, eulerParameters: npt.ArrayLike) -> FloatArray:
    """Return the 4 rates of unit Euler parameters from the angular velocity in the global frame."""
    x, y, z = as_vector("AngularVelocity2EulerParameters_t: angularVelocity", angularVelocity, 3).tolist()
    s, u, v, w = as_vector("AngularVelocity2EulerParameters_t: eulerParameters", eulerParameters, 4).tolist()
    return 0.5 * np.array([
        -u * x - v * y - w * z,
        s * x + w * y - v * z,
        -w * x + s * y + u * z,
        v * x - u * y + s * z,
    ])  # fmt: skip


def RotationVector2RotationMatrix(rotationVector: npt.ArrayLike) -> FloatArray:
    """Return the 3x3 rotation matrix of a rotation vector (axis times angle); exact for angles of any size."""
    x, y, z = floats("RotationVector2RotationMatrix: rotationVector", rotationVector, 3)
    angle = hypot(x, y, z)
    factor = sin(0.5 * angle) / angle if angle > 0.0 else 0.5
    return _of_quaternion(cos(0.5 * angle), factor * x, factor * y, factor * z)


def RotationMatrix2RotationVector(rotationMatrix: npt.ArrayLike) -> FloatArray:
    """Return the rotation vector of a 3x3 rotation matrix, with an angle in [0, pi]."""
    s, u, v, w = RotationMatrix2EulerParameters(rotationMatrix).tolist()
    halfSine = hypot(u, v, w)
    factor = 2.0 * atan2(halfSine, s) / halfSine if halfSine > 0.0 else 0.0
    return _array(1, factor * u, factor * v, factor * w)


def ComputeRotationAxisFromRotationVector(rotationVector: npt.ArrayLike) -> FloatArray:
    """Return the unit vector of the rotation axis; zeros for the zero rotation."""
    v = as_vector("ComputeRotationAxisFromRotationVector: rotationVector", rotationVector, 3)
    angle = np.linalg.norm(v)
    return np.zeros(3) if angle == 0.0 else v / angle


def RotationVector2G(rotationVector: npt.ArrayLike) -> FloatArray:
    """Return the 3x3 matrix that maps the rate of the Lie group node, the local angular velocity, to the global one."""
    return RotationVector2RotationMatrix(rotationVector)


def RotationVector2GLocal(eulerParameters: npt.ArrayLike) -> FloatArray:
    """Return the 3x3 identity: the rate of the Lie group node is the local angular velocity itself."""
    as_vector("RotationVector2GLocal: eulerParameters", eulerParameters, 3)
    return np.eye(3)


def RotXYZ2RotationMatrix(rot: npt.ArrayLike) -> FloatArray:
    """Return the 3x3 matrix Ax @ Ay @ Az of successive rotations about the x, the rotated y and the rotated z axis."""
    angles = floats("RotXYZ2RotationMatrix: rot", rot, 3)
    cx, cy, cz = map(cos, angles)
    sx, sy, sz = map(sin, angles)
    return _array(
        3,
        *(cy * cz, -cy * sz, sy),
        *(sx * sy * cz + cx * sz, cx * cz - sx * sy * sz, -sx * cy),
        *(sx * sz - cx * sy * cz, cx * sy * sz + sx * cz, cx * cy),
    )


def RotationMatrix2RotXYZ(rotationMatrix: npt.ArrayLike) -> FloatArray:
    """Return the Tait-Bryan angles [x, y, z] of a 3x3 rotation matrix, y in [-pi/2, pi/2].

    Only the sum or difference of x and z is determined at y = +-pi/2 (gimbal lock); x = 0 is used there.
    """
    A = as_rotation("RotationMatrix2RotXYZ: rotationMatrix", rotationMatrix)
    cosY = hypot(A[1, 2], A[2, 2])
    angleY = atan2(A[0, 2], cosY)
    if cosY > _GIMBAL:
        return np.array([atan2(-A[1, 2], A[2, 2]), angleY, atan2(-A[0, 1], A[0, 0])])
    return np.array([0.0, angleY, atan2(A[1, 0], A[1, 1])])


def RotXYZ2G(rot: npt.ArrayLike) -> FloatArray:
    """Return the 3x3 matrix G with (global) angular velocity = G @ rot_t; its columns are the three rotation axes."""
    a, b, _ = floats("RotXYZ2G: rot", rot, 3)
    return _array(3, 1.0, 0.0, sin(b), 0.0, cos(a), -sin(a) * cos(b), 0.0, sin(a), cos(a) * cos(b))


def RotXYZ2G_t(rot: npt.ArrayLike, rot_t: npt.ArrayLike) -> FloatArray:
    """Return the time derivative of the 3x3 matrix of RotXYZ2G."""
    a, b, _ = as_vector("RotXYZ2G_t: rot", rot, 3)
    a_t, b_t, _ = as_vector("RotXYZ2G_t: rot_t", rot_t, 3)
    G = RotXYZ2G(rot)
    G_t = np.zeros((3, 3))
    G_t[1:, 1:] = a_t * np.array([-G[2, 1:], G[1, 1:]])  # turning about x exchanges the rows
    G_t[:, 2] += b_t * np.array([cos(b), sin(a) * sin(b), -cos(a) * sin(b)])
    return G_t


def RotXYZ2GLocal(rot: npt.ArrayLike) -> FloatArray:
    """Return the 3x3 matrix GLocal with (local) angular velocity = GLocal @ rot_t."""
    _, b, c = floats("RotXYZ2GLocal: rot", rot, 3)
    return _array(3, cos(b) * cos(c), sin(c), 0.0, -cos(b) * sin(c), cos(c), 0.0, sin(b), 0.0, 1.0)


def RotXYZ2GLocal_t(rot: npt.ArrayLike, rot_t: npt.ArrayLike) -> FloatArray:
    """Return the time derivative of the 3x3 matrix of RotXYZ2GLocal."""
    _, b, c = as_vector("RotXYZ2GLocal_t: rot", rot, 3)
    _, b_t, c_t = as_vector("RotXYZ2GLocal_t: rot_t", rot_t, 3)
    G = RotXYZ2GLocal(rot)
    G_t = np.zeros((3, 3))
    G_t[:2, :2] = c_t * np.array([G[1, :2], -G[0, :2]])  # turning about z exchanges the rows
    G_t[:, 0] += b_t * np.array([-sin(b) * cos(c), sin(b) * sin(c), cos(b)])
    return G_t


def AngularVelocity2RotXYZ_t(angularVelocity: npt.ArrayLike, rotation: npt.ArrayLike) -> FloatArray:
    """Return the rates of the Tait-Bryan angles from the angular velocity in the global frame.

    Raises ValueError at rotation[1] = +-pi/2 if the angular velocity has a part that no rates can represent.
    """
    omega = as_vector("AngularVelocity2RotXYZ_t: angularVelocity", angularVelocity, 3)
    a, b, _ = as_vector("AngularVelocity2RotXYZ_t: rotation", rotation, 3)
    rateY = cos(a) * omega[1] + sin(a) * omega[2]
    throughZ = cos(a) * omega[2] - sin(a) * omega[1]
    if abs(cos(b)) > _GIMBAL:
        rateZ = throughZ / cos(b)
    elif abs(throughZ) <= _GIMBAL * np.linalg.norm(omega):
        rateZ = 0.0
    else:
        raise shape_error(
            "AngularVelocity2RotXYZ_t: rotation",
            "angles with rotation[1] different from +-pi/2 (singular position)",
            rotation,
        )
    return np.array([omega[0] - sin(b) * rateZ, rateY, rateZ])


def quaternion_product(q: FloatArray, p: FloatArray) -> FloatArray:
    """Return the Hamilton product of two quaternions, scalar part first: the rotation q followed by p in its frame."""
    a, b, c, d = q.tolist()
    s, u, v, w = p.tolist()
    return _array(
        1,
        a * s - (b * u + c * v + d * w),
        a * u + s * b + (c * w - d * v),
        a * v + s * c + (d * u - b * w),
        a * w + s * d + (b * v - c * u),
    )


def RotXYZ2EulerParameters(alpha: npt.ArrayLike) -> FloatArray:
    """Return the 4 Euler parameters (scalar part first) of Tait-Bryan angles, smooth in the angles."""
    halves = [0.5 * angle for angle in floats("RotXYZ2EulerParameters: alpha", alpha, 3)]
    cx, cy, cz = map(cos, halves)
    sx, sy, sz = map(sin, halves)
    s, u, v, w = cx * cy, sx * cy, cx * sy, sx * sy  # about x and y
    return _array(1, s * cz - w * sz, u * cz + v * sz, v * cz - u * sz, s * sz + w * cz)


def RotationMatrix2RotZYZ(rotationMatrix: npt.ArrayLike, flip: bool) -> FloatArray:
    """Return the Euler angles [z, y, z] of a 3x3 rotation matrix A = Az @ Ay @ Az.

    The middle angle is positive, or negative if flip is True (the first angle then differs by pi). If both z axes
    coincide, the first angle is zero.
    """
    A = as_rotation("RotationMatrix2RotZYZ: rotationMatrix", rotationMatrix)
    sign = -1.0 if flip else 1.0
    parallel = abs(A[0, 2]) < _GIMBAL and abs(A[1, 2]) < _GIMBAL
    first = 0.0 if parallel else atan2(sign * A[1, 2], sign * A[0, 2])
    rest = RotationMatrixZ(first).T @ A
    return np.array([first, atan2(rest[0, 2], A[2, 2]), atan2(rest[1, 0], rest[1, 1])])


def _cosine_and_sine(function: str, angleRad: float) -> tuple[float, float]:
    try:
        return cos(angleRad), sin(angleRad)
    except (TypeError, ValueError, OverflowError):
        raise shape_error(f"{function}: angleRad", "a finite number, the angle in rad", angleRad) from None


def RotationMatrixX(angleRad: float) -> FloatArray:
    """Return the 3x3 rotation matrix about the x axis for an angle in rad."""
    c, s = _cosine_and_sine("RotationMatrixX", angleRad)
    return _array(3, 1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c)


def RotationMatrixY(angleRad: float) -> FloatArray:
    """Return the 3x3 rotation matrix about the y axis for an angle in rad."""
    c, s = _cosine_and_sine("RotationMatrixY", angleRad)
    return _array(3, c, 0.0, s, 0.0, 1.0, 0.0, -s, 0.0, c)


def RotationMatrixZ(angleRad: float) -> FloatArray:
    """Return the 3x3 rotation matrix about the z axis for an angle in rad."""
    c, s = _cosine_and_sine("RotationMatrixZ", angleRad)
    return _array(3, c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0)


def RotationMatrix2D(angleRad: float) -> FloatArray:
    """Return the 2x2 rotation matrix in the plane for an angle in rad."""
    c, s = _cosine_and_sine("RotationMatrix2D", angleRad)
    return np.array([[c, -s], [s, c]])
