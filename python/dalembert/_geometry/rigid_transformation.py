"""The class HT: rotation and translation of a frame, with products, inverse, logarithms and interpolation."""

from __future__ import annotations

from typing import Any, overload

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, as_array, as_rotation, as_transformation, as_vector, shape_error
from dalembert._geometry.rotations import (
    EulerParameters2RotationMatrix,
    RotationMatrix2EulerParameters,
    RotationMatrix2RotationVector,
    RotationMatrix2RotXYZ,
    RotationMatrixX,
    RotationMatrixY,
    RotationMatrixZ,
    RotationVector2RotationMatrix,
    RotXYZ2RotationMatrix,
)

_FROM = {
    "eulerParameters": (4, EulerParameters2RotationMatrix),
    "Rxyz": (3, RotXYZ2RotationMatrix),
    "rotationVector": (3, RotationVector2RotationMatrix),
}


class HT:
    """Rigid transformation: x -> rotation @ x + translation, from a local frame to another one.

    HT() is the identity, HT(H) that of a 4 x 4 matrix; otherwise give at most one of rotation (3 x 3 matrix),
    eulerParameters, Rxyz (Tait-Bryan angles) and rotationVector, and a translation. H1*H2 is the composition, H*v the
    transformed point. Otherwise an HT is used like its 4 x 4 matrix: np.array(H), H[i, j], H @ array, H1 - H2, H.T, ...
    """

    __slots__ = ("_matrix",)
    __hash__ = None  # type: ignore[assignment]
    __array_priority__ = 100  # array @ HT calls __rmatmul__
    __module__ = "dalembert"

    def __init__(
        self,
        rotation: Any = None,
        translation: npt.ArrayLike | None = None,
        eulerParameters: npt.ArrayLike | None = None,
        Rxyz: npt.ArrayLike | None = None,
        rotationVector: npt.ArrayLike | None = None,
    ) -> None:
        self._matrix: FloatArray = np.eye(4)
        self.Set(rotation, translation, eulerParameters, Rxyz, rotationVector)

    # ---- parts ----

    @property
    def rotation(self) -> FloatArray:
        """Rotation matrix, 3 x 3, a copy."""
        return self._matrix[:3, :3].copy()

    @rotation.setter
    def rotation(self, value: npt.ArrayLike) -> None:
        self._matrix[:3, :3] = as_rotation("HT.rotation", value)

    @property
    def translation(self) -> FloatArray:
        """Translation, 3 numbers, a copy."""
        return self._matrix[:3, 3].copy()

    @translation.setter
    def translation(self, value: npt.ArrayLike) -> None:
        self._matrix[:3, 3] = as_vector("HT.translation", value, 3)

    def Get(self) -> list[FloatArray]:
        """Return [rotation, translation]."""
        return [self.rotation, self.translation]

    def HT44(self) -> FloatArray:
        """Return the 4 x 4 matrix."""
        return self._matrix.copy()

    def Set(
        self,
        rotation: Any = None,
        translation: npt.ArrayLike | None = None,
        eulerParameters: npt.ArrayLike | None = None,
        Rxyz: npt.ArrayLike | None = None,
        rotationVector: npt.ArrayLike | None = None,
    ) -> HT:
        """Set the given parts; other ones stay. Return the HT."""
        given = {"eulerParameters": eulerParameters, "Rxyz": Rxyz, "rotationVector": rotationVector}
        names = [name for name, value in given.items() if value is not None]
        if len(names) + (rotation is not None) > 1:
            every = ["rotation"] * (rotation is not None) + names
            raise ValueError(f"HT: rotation is given more than once, by {' and '.join(every)}")
        if isinstance(rotation, HT) or (rotation is not None and np.shape(rotation) == (4, 4)):
            if translation is not None:
                raise ValueError("HT: translation is given twice, also by the 4 x 4 matrix")
            self._matrix[:] = as_transformation("HT", np.asarray(rotation))
            return self
        if rotation is not None:
            self.rotation = rotation
        for name in names:
            size, function = _FROM[name]
            self._matrix[:3, :3] = function(as_vector(f"HT: {name}", given[name], size))
        if translation is not None:
            self.translation = translation
        return self

    def _of(self, rotation: npt.ArrayLike, translation: npt.ArrayLike = (0.0, 0.0, 0.0)) -> HT:
        self._matrix[:3, :3] = rotation
        self._matrix[:3, 3] = translation
        return self

    def SetIdentity(self) -> HT:
        """Set no rotation and no translation."""
        return self._of(np.eye(3))

    def SetTranslation(self, translation: npt.ArrayLike) -> HT:
        """Set a translation without rotation."""
        return self._of(np.eye(3), as_vector("HT.SetTranslation: translation", translation, 3))

    def SetRotationX(self, angle: float) -> HT:
        """Set a rotation about x without translation."""
        return self._of(RotationMatrixX(angle))

    def SetRotationY(self, angle: float) -> HT:
        """Set a rotation about y without translation."""
        return self._of(RotationMatrixY(angle))

    def SetRotationZ(self, angle: float) -> HT:
        """Set a rotation about z without translation."""
        return self._of(RotationMatrixZ(angle))

    def SetRotationAxis(self, axis: npt.ArrayLike, angle: float) -> HT:
        """Set a rotation about an axis of any length but zero, without translation."""
        direction = as_vector("HT.SetRotationAxis: axis", axis, 3)
        length = float(np.linalg.norm(direction))
        if length == 0:
            raise shape_error("HT.SetRotationAxis: axis", "a vector that is not zero", axis)
        return self._of(RotationVector2RotationMatrix(angle / length * direction))

    # ---- coordinates of rigid body nodes ----

    def GetEP(self) -> FloatArray:
        """Return the Euler parameters of the rotation."""
        return RotationMatrix2EulerParameters(self._matrix[:3, :3])

    def GetRxyz(self) -> FloatArray:
        """Return the Tait-Bryan angles of the rotation."""
        return RotationMatrix2RotXYZ(self._matrix[:3, :3])

    def GetRotationVector(self) -> FloatArray:
        """Return the rotation vector, of a length up to pi."""
        return RotationMatrix2RotationVector(self._matrix[:3, :3])

    def GetCoordinatesEP(self) -> FloatArray:
        """Return translation and Euler parameters: coordinates of NodeRigidBodyEP."""
        return np.concatenate([self.translation, self.GetEP()])

    def GetCoordinatesRxyz(self) -> FloatArray:
        """Return translation and Tait-Bryan angles: coordinates of NodeRigidBodyRxyz."""
        return np.concatenate([self.translation, self.GetRxyz()])

    def GetCoordinatesRotationVector(self) -> FloatArray:
        """Return translation and rotation vector: coordinates of NodeRigidBodyRotVecLG."""
        return np.concatenate([self.translation, self.GetRotationVector()])

    def _set_coordinates(self, function: str, name: str, coordinates: npt.ArrayLike) -> HT:
        size, rotation = _FROM[name]
        q = as_vector(f"HT.{function}: coordinates", coordinates, 3 + size)
        return self._of(rotation(q[3:]), q[:3])

    def SetCoordinatesEP(self, coordinates: npt.ArrayLike) -> HT:
        """Set translation and Euler parameters."""
        return self._set_coordinates("SetCoordinatesEP", "eulerParameters", coordinates)

    def SetCoordinatesRxyz(self, coordinates: npt.ArrayLike) -> HT:
        """Set translation and Tait-Bryan angles."""
        return self._set_coordinates("SetCoordinatesRxyz", "Rxyz", coordinates)

    def SetCoordinatesRotationVector(self, coordinates: npt.ArrayLike) -> HT:
        """Set translation and rotation vector."""
        return self._set_coordinates("SetCoordinatesRotationVector", "rotationVector", coordinates)

    # ---- operations ----

    def Inverse(self) -> HT:
        """Return the inverse transformation."""
        A = self._matrix[:3, :3].T
        return HT()._of(A, -A @ self._matrix[:3, 3])

    def Invert(self) -> None:
        """Replace the transformation by its inverse."""
        self._matrix[:] = self.Inverse()._matrix

    def Relative(self, other: HT) -> HT:
        """Return the frame of `other` as seen from this one, Inverse()*other."""
        return self.Inverse() * _transformation("HT.Relative: other", other)

    def RotateVector(self, vector: npt.ArrayLike) -> FloatArray:
        """Return rotation @ vector."""
        return np.asarray(self._matrix[:3, :3] @ as_vector("HT.RotateVector: vector", vector, 3))

    def RotateVectorTransposed(self, vector: npt.ArrayLike) -> FloatArray:
        """Return the transposed rotation matrix times vector."""
        return np.asarray(self._matrix[:3, :3].T @ as_vector("HT.RotateVectorTransposed: vector", vector, 3))

    def RotationAngle(self) -> float:
        """Return the angle of the rotation, from 0 to pi."""
        return float(np.linalg.norm(self.GetRotationVector()))

    def RotationAxis(self, raiseError: bool = True) -> FloatArray:
        """Return the unit axis of the rotation. Without rotation: ValueError, or zero unless raiseError."""
        vector = self.GetRotationVector()
        angle = float(np.linalg.norm(vector))
        if angle == 0 and raiseError:
            raise ValueError("HT.RotationAxis: there is no rotation, and no axis; use raiseError=False to obtain zero")
        return vector if angle == 0 else vector / angle

    def HasNoRotation(self) -> bool:
        """Return whether the rotation matrix is exactly the identity."""
        return bool((self._matrix[:3, :3] == np.eye(3)).all())

    def InterpolateSO3(self, other: HT, factor: float) -> HT:
        """Return a frame on the way to `other` (factor 1): straight translation, and rotation about a fixed axis."""
        end = _transformation("HT.InterpolateSO3: other", other)
        turn = RotationVector2RotationMatrix(factor * self.Relative(end).GetRotationVector())
        way = (1 - factor) * self._matrix[:3, 3] + factor * end._matrix[:3, 3]
        return HT()._of(self._matrix[:3, :3] @ turn, way)

    def InterpolateSE3(self, other: HT, factor: float) -> HT:
        """Return a frame on the way to `other` (factor 1): a screw motion."""
        end = _transformation("HT.InterpolateSE3: other", other)
        return self * HT().SetExpSE3(factor * self.Relative(end).LogSE3())

    def LogSE3(self) -> FloatArray:
        """Return the logarithm, 6 numbers: the part of the translation, and the rotation vector."""
        from dalembert.lieGroupBasics import TExpSO3Inv

        vector = self.GetRotationVector()
        return np.concatenate([TExpSO3Inv(vector).T @ self._matrix[:3, 3], vector])

    def SetExpSE3(self, vector: npt.ArrayLike) -> HT:
        """Set the transformation of which LogSE3 is `vector`."""
        from dalembert.lieGroupBasics import TExpSO3

        motion = as_vector("HT.SetExpSE3: vector", vector, 6)
        return self._of(RotationVector2RotationMatrix(motion[3:]), TExpSO3(motion[3:]).T @ motion[:3])

    def LogR3xSO3(self) -> FloatArray:
        """Return translation and rotation vector, 6 numbers."""
        return self.GetCoordinatesRotationVector()

    def SetExpR3xSO3(self, vector: npt.ArrayLike) -> HT:
        """Set translation and rotation vector, 6 numbers."""
        return self._set_coordinates("SetExpR3xSO3", "rotationVector", vector)

    @overload
    def __mul__(self, other: HT) -> HT: ...
    @overload
    def __mul__(self, other: npt.ArrayLike) -> FloatArray: ...
    def __mul__(self, other: HT | npt.ArrayLike) -> HT | FloatArray:
        if isinstance(other, HT):
            return sharing(self._matrix @ other._matrix)
        if np.ndim(other) == 0:
            return self._matrix * np.asarray(other, dtype=float)
        point = as_vector("HT * point", other, 3)
        return np.asarray(self._matrix[:3, :3] @ point + self._matrix[:3, 3])

    def __rmul__(self, other: npt.ArrayLike) -> FloatArray:
        return as_array("array * HT", other) * self._matrix

    def __add__(self, other: npt.ArrayLike) -> FloatArray:
        return self._matrix + as_array("HT + array", other)

    __radd__ = __add__

    def __sub__(self, other: npt.ArrayLike) -> FloatArray:
        return self._matrix - as_array("HT - array", other)

    def __rsub__(self, other: npt.ArrayLike) -> FloatArray:
        return as_array("array - HT", other) - self._matrix

    def __neg__(self) -> FloatArray:
        return -self._matrix

    @overload
    def __matmul__(self, other: HT) -> HT: ...
    @overload
    def __matmul__(self, other: npt.ArrayLike) -> FloatArray: ...
    def __matmul__(self, other: HT | npt.ArrayLike) -> HT | FloatArray:
        return self * other if isinstance(other, HT) else np.asarray(self._matrix @ as_array("HT @ array", other))

    def __rmatmul__(self, other: npt.ArrayLike) -> FloatArray:
        return np.asarray(as_array("array @ HT", other) @ self._matrix)

    def __eq__(self, other: object) -> bool:
        return bool((self._matrix == other._matrix).all()) if isinstance(other, HT) else NotImplemented

    def __getattr__(self, name: str) -> Any:
        """Return an attribute of the 4 x 4 matrix, a copy: shape, T, dot, tolist, ..."""
        if name.startswith("_") or not hasattr(np.ndarray, name):
            raise AttributeError(f"'HT' object has no attribute {name!r}")
        return getattr(self._matrix.copy(), name)

    def __len__(self) -> int:
        return 4

    def __getitem__(self, key: Any) -> Any:
        found = self._matrix[key]
        return found.copy() if isinstance(found, np.ndarray) else float(found)

    def __setitem__(self, key: Any, value: npt.ArrayLike) -> None:
        changed = self._matrix.copy()
        changed[key] = value
        if not np.array_equal(changed[3], [0, 0, 0, 1]):
            raise ValueError(f"HT: the last row is [0, 0, 0, 1]; received {changed[3].tolist()}")
        self._matrix[:] = changed

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> FloatArray:
        if copy is False:
            raise ValueError("HT: its matrix cannot be used without a copy")
        return np.array(self._matrix, dtype=dtype)

    def __copy__(self) -> HT:
        return of_matrix(self._matrix)

    def __deepcopy__(self, memo: dict[int, Any]) -> HT:
        return self.__copy__()

    def __reduce__(self) -> Any:
        return of_matrix, (self._matrix,)

    def __repr__(self) -> str:
        rows = ",".join("[" + ",".join(f"{x:.6g}" for x in row) + "]" for row in self._matrix[:3, :3])
        return f"HT(rotation=[{rows}], translation=[{','.join(f'{x:.6g}' for x in self._matrix[:3, 3])}])"


def of_matrix(matrix: FloatArray) -> HT:
    """Return the HT of 16 numbers, which are not checked."""
    return sharing(matrix.reshape(4, 4).copy())


def sharing(matrix: FloatArray) -> HT:
    """Return an HT whose memory is that of a 4 x 4 array, which is not checked."""
    made = HT.__new__(HT)
    made._matrix = matrix
    return made


def parts(where: str, value: Any, many: bool, has_position: bool) -> tuple[Any, Any]:
    """Return translation and rotation of an HT, a 4 x 4 matrix or its 16 values, or lists of them if `many`."""
    if many:
        if isinstance(value, (HT, str, dict)) or not hasattr(value, "__len__"):
            raise shape_error(where, "a list of HT", value)
        each = [parts(f"{where}[{i}]", one, False, True) for i, one in enumerate(value)]
        return [position for position, _ in each], [rotation for _, rotation in each]
    array = np.asarray(value, dtype=float)
    array = as_transformation(where, array.reshape(4, 4) if array.size == 16 else array)
    if not has_position and array[:3, 3].any():
        raise shape_error(where, "a rotation without translation: the item has no local position", value)
    return array[:3, 3], array[:3, :3]


def of_parts(position: Any, rotation: Any, many: bool) -> Any:
    """Return the HT of a translation (None: zero) and a rotation, or a list of them."""
    if many:
        return [of_parts(p, A, False) for p, A in zip(position, rotation, strict=True)]
    matrix = np.eye(4)
    matrix[:3, :3] = rotation
    if position is not None:
        matrix[:3, 3] = position
    return of_matrix(matrix)


def _transformation(where: str, value: Any) -> HT:
    if not isinstance(value, HT):
        raise shape_error(where, "an HT", value)
    return value
