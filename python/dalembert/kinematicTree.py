"""Kinematic trees in minimal coordinates: mass matrix and forces, with spatial vectors (6D) or pairs of 3D vectors.

Spatial vectors have the rotational part first; coordinate transformations X map from the parent's to the link's joint
frame. The equations of motion are M(q) @ q_tt + f(q, q_t) = torques (Featherstone, Rigid Body Dynamics Algorithms,
2008, tables 5.1 and 6.2). Joint types are 'Rx', 'Ry', 'Rz', 'Px', 'Py', 'Pz'.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, as_matrix, as_rotation, as_vector, shape_error
from dalembert._geometry.inertia import RigidBodyInertia
from dalembert._geometry.rotations import RotationMatrixX, RotationMatrixY, RotationMatrixZ, Skew, Skew2Vec
from dalembert._geometry.transformations import (
    RotationTranslation2T66Inverse,
    RotationX2T66,
    RotationY2T66,
    RotationZ2T66,
    Translation2T66,
    lower_block,
)


def RotationX2T66Inverse(angle: float) -> FloatArray:
    """Return the inverse 6x6 transformation of a rotation about the x axis."""
    return RotationX2T66(angle).T


def RotationY2T66Inverse(angle: float) -> FloatArray:
    """Return the inverse 6x6 transformation of a rotation about the y axis."""
    return RotationY2T66(angle).T


def RotationZ2T66Inverse(angle: float) -> FloatArray:
    """Return the inverse 6x6 transformation of a rotation about the z axis."""
    return RotationZ2T66(angle).T


def TranslationX2T66Inverse(translation: float) -> FloatArray:
    """Return the inverse 6x6 transformation of a translation along the x axis."""
    return Translation2T66([-translation, 0.0, 0.0])


def TranslationY2T66Inverse(translation: float) -> FloatArray:
    """Return the inverse 6x6 transformation of a translation along the y axis."""
    return Translation2T66([0.0, -translation, 0.0])


def TranslationZ2T66Inverse(translation: float) -> FloatArray:
    """Return the inverse 6x6 transformation of a translation along the z axis."""
    return Translation2T66([0.0, 0.0, -translation])


def MassCOMinertia2T66(mass: float, centerOfMass: npt.ArrayLike, inertia: npt.ArrayLike) -> FloatArray:
    """Return the 6x6 inertia of a mass (kg) with centre of mass and 3x3 inertia tensor about the centre of mass."""
    C = Skew(as_vector("MassCOMinertia2T66: centerOfMass", centerOfMass, 3))
    J = as_matrix("MassCOMinertia2T66: inertia", inertia, (3, 3))
    return np.block([[J + mass * (C @ C.T), mass * C], [mass * C.T, mass * np.eye(3)]])


def Inertia2T66(inertia: RigidBodyInertia) -> FloatArray:
    """Return the 6x6 inertia of a RigidBodyInertia about its reference point."""
    return MassCOMinertia2T66(inertia.mass, inertia.com, inertia.InertiaCOM())


def Inertia66toMassCOMinertia(inertia66: npt.ArrayLike) -> list[Any]:
    """Return [mass, centre of mass, 3x3 inertia tensor about the centre of mass] of a 6x6 inertia."""
    I66 = as_matrix("Inertia66toMassCOMinertia: inertia66", inertia66, (6, 6))
    mass, moment = I66[5, 5], I66[:3, 3:]
    return [mass, Skew2Vec(moment) / mass, I66[:3, :3] - moment @ moment.T / mass]


_rotations = (RotationMatrixX, RotationMatrixY, RotationMatrixZ)


def JointTransformMotionSubspace(jointType: str, q: float) -> list[FloatArray]:
    """Return [rotation matrix from parent to link, translation, rotation axis, translation axis] of a joint."""
    if jointType not in ("Rx", "Ry", "Rz", "Px", "Py", "Pz"):
        raise shape_error("JointTransformMotionSubspace: jointType", "one of Rx, Ry, Rz, Px, Py, Pz", jointType)
    k = "xyz".index(jointType[1])
    axis, none = np.eye(3)[k], np.zeros(3)
    if jointType[0] == "R":
        return [_rotations[k](q).T, none, axis, none]
    return [np.eye(3), q * axis, none, axis]


def JointTransformMotionSubspace66(jointType: str, q: float) -> list[FloatArray]:
    """Return [6x6 transformation from parent to link, 6D motion direction] of a joint with the coordinate q."""
    A, p, rotationAxis, translationAxis = JointTransformMotionSubspace(jointType, q)
    return [lower_block(A, -A @ Skew(p)), np.concatenate([rotationAxis, translationAxis])]


def CRM(v: npt.ArrayLike) -> FloatArray:
    """Return the 6x6 matrix of the cross product of the motion vector v with motion vectors."""
    motion = as_vector("CRM: v", v, 6)
    W, V = Skew(motion[:3]), Skew(motion[3:])
    return lower_block(W, V)


def CRF(v: npt.ArrayLike) -> FloatArray:
    """Return the 6x6 matrix of the cross product of the motion vector v with force vectors."""
    return -CRM(v).T


def _parents(where: str, n: int, listOfParents: Sequence[int]) -> npt.NDArray[Any]:
    """Return the parent of each link, the previous one if the list is empty; ValueError if not sorted."""
    if len(listOfParents) == 0:
        return np.arange(-1, n - 1)
    for i, parent in enumerate(listOfParents):
        if not -1 <= parent < i:
            raise shape_error(f"{where}: listOfParents[{i}]", f"a parent index from -1 to {i - 1}", parent)
    return np.array(listOfParents)


def _require_lengths(where: str, n: int, **lists: Sequence[Any] | npt.NDArray[Any]) -> None:
    for name, entries in lists.items():
        if len(entries) != n:
            raise shape_error(f"{where}: {name}", f"{n} entries, one per joint type", entries)


class KinematicTree66:
    """Kinematic tree of links with 6x6 transformations (parent to joint, for q = 0) and 6x6 inertias.

    Without listOfParents the links form a chain; -1 is the ground; gravity (m/s^2) is in the ground frame.
    """

    def __init__(
        self,
        listOfJointTypes: Sequence[str],
        listOfTransformations: Sequence[npt.ArrayLike],
        listOfInertias: Sequence[npt.ArrayLike],
        listOfParents: Sequence[int] = [],
        gravity: npt.ArrayLike = [0, 0, -9.81],
    ) -> None:
        n = len(listOfJointTypes)
        self.jointTypes = listOfJointTypes
        self.transformations = [
            as_matrix("KinematicTree66: listOfTransformations", X, (6, 6)) for X in listOfTransformations
        ]
        self.inertias = [as_matrix("KinematicTree66: listOfInertias", inertia, (6, 6)) for inertia in listOfInertias]
        self.parents = _parents("KinematicTree66", n, listOfParents)
        self.gravity = as_vector("KinematicTree66: gravity", gravity, 3)
        _require_lengths(
            "KinematicTree66",
            n,
            listOfTransformations=self.transformations,
            listOfInertias=self.inertias,
            listOfParents=self.parents,
        )

    def Size(self) -> int:
        """Return the number of joints."""
        return len(self.jointTypes)

    def XL(self, i: int) -> FloatArray:
        """Return the constant 6x6 transformation of joint i."""
        return self.transformations[i]

    def ForwardDynamicsCRB(
        self,
        q: npt.ArrayLike = [],
        q_t: npt.ArrayLike = [],
        torques: npt.ArrayLike = [],
        forces: npt.ArrayLike = [],
    ) -> FloatArray:
        """Return the joint accelerations from coordinates, velocities and joint torques (forces must be empty)."""
        return _forward_dynamics(self, q, q_t, torques, forces)

    def ComputeMassMatrixAndForceTerms(
        self, q: npt.ArrayLike, q_t: npt.ArrayLike, externalForces: Sequence[npt.ArrayLike] = []
    ) -> list[FloatArray]:
        """Return [M, f] of M @ q_tt + f = torques; f has gravity, velocity terms and external forces.

        Raises ValueError if q or q_t have not one entry per joint.
        """
        n = self.Size()
        coordinates, rates = (
            as_vector("KinematicTree66.ComputeMassMatrixAndForceTerms: q", q, n),
            as_vector("KinematicTree66.ComputeMassMatrixAndForceTerms: q_t", q_t, n),
        )
        S, X, v, a, fv = ([np.zeros(6)] * n for _ in range(5))
        for i, parent in enumerate(self.parents):
            XJ, S[i] = JointTransformMotionSubspace66(self.jointTypes[i], coordinates[i])
            X[i] = XJ @ self.XL(i)
            vJ = S[i] * rates[i]
            v[i] = vJ if parent == -1 else X[i] @ v[parent] + vJ
            base = np.concatenate([np.zeros(3), -self.gravity]) if parent == -1 else a[parent]
            a[i] = X[i] @ base + CRM(v[i]) @ vJ
            fv[i] = self.inertias[i] @ a[i] + CRF(v[i]) @ (self.inertias[i] @ v[i])
        fv = self.AddExternalForces(X, fv, externalForces)
        f, M = np.zeros(n), np.zeros((n, n))
        composite = [inertia.copy() for inertia in self.inertias]
        for i in reversed(range(n)):
            f[i] = S[i] @ fv[i]
            if self.parents[i] != -1:
                fv[self.parents[i]] = fv[self.parents[i]] + X[i].T @ fv[i]
                composite[self.parents[i]] += X[i].T @ composite[i] @ X[i]
        for i in range(n):
            force = composite[i] @ S[i]
            M[i, i] = S[i] @ force
            j = i
            while self.parents[j] != -1:
                force = X[j].T @ force
                j = self.parents[j]
                M[i, j] = M[j, i] = S[j] @ force
        return [M, f]

    def AddExternalForces(
        self, Xup: Sequence[FloatArray], fvp: Sequence[FloatArray], externalForces: Sequence[npt.ArrayLike] = []
    ) -> list[FloatArray]:
        """Return the link forces fvp plus 6D external forces, one per link, given in ground coordinates.

        They are added to the left-hand side of the equations, thus act with opposite sign; an empty list adds none.
        """
        result = list(fvp)
        if len(externalForces) == 0:
            return result
        _require_lengths("AddExternalForces", len(self.parents), externalForces=externalForces)
        fromGround: list[FloatArray] = []
        for i, parent in enumerate(self.parents):
            fromGround.append(Xup[i] if parent == -1 else Xup[i] @ fromGround[parent])
            force = as_vector(f"externalForces[{i}]", externalForces[i], 6)
            result[i] = result[i] + np.linalg.solve(fromGround[i].T, force)
        return result


class KinematicTree33:
    """Kinematic tree of links with 3x3 rotation matrices and 3D offsets (joint relative to parent, for q = 0).

    Inertia tensors are about the joint origin, centres of mass relative to it, in the link frame. Without listOfParents
    the links form a chain; -1 is the ground; gravity (m/s^2) is in the ground frame.
    """

    def __init__(
        self,
        listOfJointTypes: Sequence[str],
        listOfRotations: Sequence[npt.ArrayLike],
        listOfOffsets: Sequence[npt.ArrayLike],
        listOfInertia3D: Sequence[npt.ArrayLike],
        listOfCOM: Sequence[npt.ArrayLike],
        listOfMass: Sequence[float],
        listOfParents: Sequence[int] = [],
        gravity: npt.ArrayLike = [0, 0, -9.81],
    ) -> None:
        n = len(listOfJointTypes)
        self.listOfJointTypes = listOfJointTypes
        self.listOfRotations = [as_rotation("KinematicTree33: listOfRotations", A) for A in listOfRotations]
        self.listOfOffsets = [as_vector("KinematicTree33: listOfOffsets", offset, 3) for offset in listOfOffsets]
        self.listOfInertia3D = [
            as_matrix("KinematicTree33: listOfInertia3D", inertia, (3, 3)) for inertia in listOfInertia3D
        ]
        self.listOfCOM = [as_vector("KinematicTree33: listOfCOM", com, 3) for com in listOfCOM]
        self.listOfMass = list(listOfMass)
        self.listOfParents = _parents("KinematicTree33", n, listOfParents)
        self.gravity = as_vector("KinematicTree33: gravity", gravity, 3)
        _require_lengths(
            "KinematicTree33",
            n,
            listOfRotations=self.listOfRotations,
            listOfOffsets=self.listOfOffsets,
            listOfInertia3D=self.listOfInertia3D,
            listOfCOM=self.listOfCOM,
            listOfMass=self.listOfMass,
            listOfParents=self.listOfParents,
        )

    def Size(self) -> int:
        """Return the number of joints."""
        return len(self.listOfJointTypes)

    def XL(self, i: int) -> list[FloatArray]:
        """Return [rotation matrix, offset] of joint i."""
        return [self.listOfRotations[i], self.listOfOffsets[i]]

    def ForwardDynamicsCRB(
        self,
        q: npt.ArrayLike = [],
        q_t: npt.ArrayLike = [],
        torques: npt.ArrayLike = [],
        forces: npt.ArrayLike = [],
    ) -> FloatArray:
        """Return the joint accelerations from coordinates, velocities and joint torques (forces must be empty)."""
        return _forward_dynamics(self, q, q_t, torques, forces)

    def _spatial(self) -> KinematicTree66:
        """Return the same tree in terms of spatial vectors."""
        transformations = [RotationTranslation2T66Inverse(*self.XL(i)) for i in range(self.Size())]
        inertias = []
        for mass, com, J in zip(self.listOfMass, self.listOfCOM, self.listOfInertia3D, strict=True):
            C = Skew(com)
            inertias.append(np.block([[J, mass * C], [mass * C.T, mass * np.eye(3)]]))
        parents = self.listOfParents.tolist()
        return KinematicTree66(self.listOfJointTypes, transformations, inertias, parents, self.gravity)

    def ComputeMassMatrixAndForceTerms(
        self, q: npt.ArrayLike, q_t: npt.ArrayLike, externalForces: Sequence[npt.ArrayLike] = []
    ) -> list[FloatArray]:
        """Return [M, f] of M @ q_tt + f = torques, see KinematicTree66.ComputeMassMatrixAndForceTerms."""
        return self._spatial().ComputeMassMatrixAndForceTerms(q, q_t, externalForces)


def _forward_dynamics(
    tree: KinematicTree33 | KinematicTree66,
    q: npt.ArrayLike,
    q_t: npt.ArrayLike,
    torques: npt.ArrayLike,
    forces: npt.ArrayLike,
) -> FloatArray:
    if np.size(forces):
        raise ValueError("ForwardDynamicsCRB: forces are not implemented; use ComputeMassMatrixAndForceTerms")
    n = tree.Size()
    M, f = tree.ComputeMassMatrixAndForceTerms(q, q_t)
    applied = as_vector("torques", torques, n) if np.size(torques) else np.zeros(n)
    return np.asarray(np.linalg.solve(M, applied - f), dtype=float)
