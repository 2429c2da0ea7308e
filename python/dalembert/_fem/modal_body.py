"""ObjectFFRFreducedOrder from a mesh with matrices and modes."""

from __future__ import annotations

import pickle
from collections.abc import Sequence
from typing import Any

import numpy.typing as npt

from dalembert._checks import FloatArray, shape_error
from dalembert._io.files import file_name, file_to_read, file_to_write, replacing
from dalembert._io.hdf5 import LoadDictFromHDF5, SaveDictToHDF5
from dalembert._names import eii, exu, np
from dalembert.physics import VonMisesStress
from dalembert.rigidBodyUtilities import (
    ComputeSkewMatrix,
    EulerParameters2GLocal,
    GetRigidBodyNode,
    RotationVector2GLocal,
    RotXYZ2GLocal,
    RotXYZ2GLocal_t,
    Skew,
    StrNodeType2NodeType,
)

INTEGRALS = ("mPsiTildePsi", "mPsiTildePsiTilde", "mPhitTPsi", "mPhitTPsiTilde", "mXRefTildePsi", "mXRefTildePsiTilde")
KEPT = (
    *(
        "modeBasis",
        "trigList",
        "postProcessingModes",
        "massMatrixReduced",
        "stiffnessMatrixReduced",
        "rigidBodyNodeType",
    ),
    *("xRef", "inertiaLocal", "Mtt", "totalMass", "chiU", "chiUtilde", *INTEGRALS),
)


def without_noise(matrix: FloatArray, relative: float) -> FloatArray:
    """Set entries that are small compared with the largest one to zero."""
    return np.where(np.abs(matrix) < relative * np.abs(matrix).max(initial=0), 0.0, matrix)


def blocks_of(coordinates: Any) -> FloatArray:
    """A multiple of the 3 x 3 identity for each coordinate, one below the other."""
    values = np.ravel(coordinates)
    blocks = np.zeros((len(values), 3, 3))
    for i in range(3):
        blocks[:, i, i] = values
    return blocks.reshape(-1, 3)


def triangles_of(femInterface: Any) -> list[Any]:
    """Triangles of the surface; an empty list if the mesh has matrices only."""
    try:
        return list(femInterface.GetSurfaceTriangles())
    except (AttributeError, NotImplementedError):
        return []


class ObjectFFRFreducedOrderInterface:
    """Constant matrices of a flexible body with modes, and the body itself.

    `femInterface` has the attributes modeBasis and postProcessingModes and the methods GetNodePositionsAsArray,
    GetMassMatrix and GetStiffnessMatrix of FEMinterface; otherwise, LoadFromFile or SetWithDictionary provide the data.
    """

    def __init__(
        self,
        femInterface: Any = None,
        rigidBodyNodeType: Any = "NodeType.RotationEulerParameters",
        roundMassMatrix: float = 1e-13,
        roundStiffnessMatrix: float = 1e-13,
    ) -> None:
        self.rigidBodyNodeType = rigidBodyNodeType
        if femInterface is None:
            return
        if "matrix" not in getattr(femInterface, "modeBasis", {}):
            expected = "an FEMinterface with modes, as its ComputeEigenmodes(...) makes them"
            raise shape_error("ObjectFFRFreducedOrderInterface: femInterface", expected, femInterface)
        modes, mass = np.asarray(femInterface.modeBasis["matrix"], dtype=float), femInterface.GetMassMatrix(sparse=True)
        points = np.asarray(femInterface.GetNodePositionsAsArray(), dtype=float)
        self.modeBasis, self.xRef, self.trigList = modes, points.ravel(), triangles_of(femInterface)
        self.postProcessingModes = femInterface.postProcessingModes
        self.massMatrixReduced = without_noise(modes.T @ (mass @ modes), roundMassMatrix)
        stiffness = modes.T @ (femInterface.GetStiffnessMatrix(sparse=True) @ modes)
        self.stiffnessMatrixReduced = without_noise(stiffness, roundStiffnessMatrix)
        translations, arms, tilde = (
            np.tile(np.eye(3), (len(points), 1)),
            ComputeSkewMatrix(self.xRef),
            ComputeSkewMatrix(modes),
        )
        mass_modes, mass_tilde = mass @ modes, mass @ tilde
        self.Mtt = translations.T @ (mass @ translations)
        self.totalMass = self.Mtt[0, 0]
        self.chiU = translations.T @ (mass @ self.xRef) / self.totalMass
        self.chiUtilde = Skew(self.chiU)
        self.inertiaLocal = arms.T @ (mass @ arms)
        self.mPhitTPsi, self.mPhitTPsiTilde = translations.T @ mass_modes, translations.T @ mass_tilde
        self.mXRefTildePsi, self.mXRefTildePsiTilde = arms.T @ mass_modes, arms.T @ mass_tilde
        self.mPsiTildePsi, self.mPsiTildePsiTilde = tilde.T @ mass_modes, tilde.T @ mass_tilde
        self._count()

    def _count(self) -> None:
        self.nModes, self.nNodes, self.dim3D = self.modeBasis.shape[1], len(self.xRef) // 3, 3
        self.nODE2rot = 4 if str(self.rigidBodyNodeType) == "NodeType.RotationEulerParameters" else 3
        self.nODE2rigid = self.dim3D + self.nODE2rot
        self.nODE2FFRFreduced = self.nODE2rigid + self.nModes
        self.massMatrixFFRFreduced = np.zeros((self.nODE2FFRFreduced, self.nODE2FFRFreduced))
        self.massMatrixFFRFreduced[:3, :3] = self.Mtt
        self.massMatrixFFRFreduced[self.nODE2rigid :, self.nODE2rigid :] = self.massMatrixReduced

    # -- data

    def GetDictionary(self) -> dict[str, Any]:
        """All data as a dictionary."""
        return {key: getattr(self, key) for key in KEPT} | {"rigidBodyNodeType": str(self.rigidBodyNodeType)}

    def SetWithDictionary(self, data: Any) -> None:
        """Set all data from a dictionary."""
        for key in KEPT:
            value = data[key]
            plain = isinstance(value, np.ndarray) and (value.ndim == 0 or value.dtype == object)
            setattr(self, key, value.tolist() if plain else value)
        self.trigList = [list(row) for row in self.trigList]
        self.rigidBodyNodeType = StrNodeType2NodeType(str(self.rigidBodyNodeType))
        self._count()

    def SaveToFile(self, fileName: str, fileVersion: int = 1) -> None:
        """Save all data; the format is that of the ending: .npz (default), .pkl or .hdf5."""
        where = "ObjectFFRFreducedOrderInterface.SaveToFile: fileName"
        stem, ending, mode = self._file(file_name(where, fileName), None)
        file_to_write(where, stem + ending)
        data = self.GetDictionary() | {"fileVersion": int(fileVersion), "type": "ObjectFFRFreducedOrderInterface"}
        if mode == "HDF5":
            SaveDictToHDF5(stem + ending, data)
        elif mode == "PKL":
            with replacing(stem + ending) as written, open(written, "wb") as file:
                pickle.dump(data, file)
        else:
            with replacing(stem + ending) as written:
                np.savez(written, **data)

    def LoadFromFile(self, fileName: str, mode: str | None = None) -> int:
        """Load a file of SaveToFile; returns its version."""
        where = "ObjectFFRFreducedOrderInterface.LoadFromFile: fileName"
        stem, ending, mode = self._file(file_name(where, fileName), mode)
        file_to_read(where, stem + ending)
        data: Any
        if mode == "HDF5":
            data = LoadDictFromHDF5(stem + ending)
        elif mode == "PKL":
            with open(stem + ending, "rb") as file:
                data = pickle.load(file)
        else:
            with np.load(stem + ending, allow_pickle=True) as file:
                data = dict(file)
        self.SetWithDictionary(data)
        return int(data["fileVersion"])

    @staticmethod
    def _file(fileName: str, mode: str | None) -> list[str]:
        from dalembert.FEM import FileNameToMode

        stem, ending, found = FileNameToMode(fileName, mode)
        if found == "NPY":
            raise ValueError("ObjectFFRFreducedOrderInterface: files are .npz, .pkl or .hdf5, received '.npy'")
        return [stem, ending, found]

    # -- body

    def AddObjectFFRFreducedOrder(
        self,
        mbs: Any,
        positionRef: npt.ArrayLike = (0, 0, 0),
        initialVelocity: npt.ArrayLike = (0, 0, 0),
        rotationMatrixRef: npt.ArrayLike = (),
        initialAngularVelocity: npt.ArrayLike = (0, 0, 0),
        massProportionalDamping: float = 0,
        stiffnessProportionalDamping: float = 0,
        gravity: npt.ArrayLike = (0, 0, 0),
        color: Sequence[float] = (0.1, 0.9, 0.1, 1.0),
        name: str = "",
    ) -> dict[str, Any]:
        """Add the nodes, the body and its weight; returns their numbers."""
        return self.AddObjectFFRFreducedOrderWithUserFunctions(
            exu,
            mbs,
            positionRef,
            initialVelocity,
            rotationMatrixRef,
            initialAngularVelocity,
            gravity,
            massProportionalDamping=massProportionalDamping,
            stiffnessProportionalDamping=stiffnessProportionalDamping,
            color=color,
            name=name,
        )

    def AddObjectFFRFreducedOrderWithUserFunctions(
        self,
        exu: Any,
        mbs: Any,
        positionRef: npt.ArrayLike = (0, 0, 0),
        initialVelocity: npt.ArrayLike = (0, 0, 0),
        rotationMatrixRef: npt.ArrayLike = (),
        initialAngularVelocity: npt.ArrayLike = (0, 0, 0),
        gravity: npt.ArrayLike = (0, 0, 0),
        UFforce: Any = 0,
        UFmassMatrix: Any = 0,
        massProportionalDamping: float = 0,
        stiffnessProportionalDamping: float = 0,
        color: Sequence[float] = (0.1, 0.9, 0.1, 1.0),
        eulerParametersRef: npt.ArrayLike = (),
        name: str = "",
    ) -> dict[str, Any]:
        """Variant with user functions: two functions replace all forces, a single one is added."""
        turned, euler = np.asarray(rotationMatrixRef, dtype=float), list(np.asarray(eulerParametersRef, dtype=float))
        if turned.size and euler:
            raise ValueError("AddObjectFFRFreducedOrder: give either rotationMatrixRef or eulerParametersRef")
        where = {"rotationParameters": euler} if euler else {"rotationMatrix": turned if turned.size else np.eye(3)}
        frame = GetRigidBodyNode(
            self.rigidBodyNodeType,
            position=positionRef,
            velocity=initialVelocity,
            angularVelocity=initialAngularVelocity,
            **where,
        )
        frame.name = f"NodeRigidBody:{name}" if name else ""
        self.rotationParameters0, self.gravity = (
            np.array(frame.referenceCoordinates[3:]),
            np.array(gravity, dtype=float),
        )
        self.nRigidBody = mbs.AddNode(frame)
        zeros = np.zeros(self.nModes)
        modes: dict[str, Any] = {
            "referenceCoordinates": zeros,
            "initialCoordinates": zeros,
            "initialCoordinates_t": zeros,
        }
        self.nGenericODE2 = mbs.AddNode(
            eii.NodeGenericODE2(
                name=f"NodeGeneric:{name}" if name else "", numberOfODE2Coordinates=self.nModes, **modes
            )
        )
        self.dampingMatrixReduced = (
            massProportionalDamping * self.massMatrixReduced
            + stiffnessProportionalDamping * self.stiffnessMatrixReduced
        )
        alone = bool(UFforce) and bool(UFmassMatrix)
        self.oFFRFreducedOrder = mbs.AddObject(
            eii.ObjectFFRFreducedOrder(
                name=name,
                nodeNumbers=[self.nRigidBody, self.nGenericODE2],
                massMatrixReduced=self.massMatrixReduced,
                stiffnessMatrixReduced=self.stiffnessMatrixReduced,
                dampingMatrixReduced=self.dampingMatrixReduced,
                forceUserFunction=UFforce,
                massMatrixUserFunction=UFmassMatrix,
                computeFFRFterms=not alone,
                visualization={"triangleMesh": self.trigList, "color": list(color), "showNodes": True},
                **self._constants(),
            )
        )
        self.loadGravity = None
        if np.any(self.gravity) and not alone:
            weight = mbs.AddMarker(eii.MarkerBodyMass(bodyNumber=self.oFFRFreducedOrder))
            self.loadGravity = mbs.AddLoad(eii.LoadMassProportional(markerNumber=weight, loadVector=self.gravity))
        names = ("nRigidBody", "nGenericODE2", "oFFRFreducedOrder", "loadGravity")
        return {name: getattr(self, name) for name in names}

    def _constants(self) -> dict[str, Any]:
        rows = {name: getattr(self, name) for name in ("modeBasis", *INTEGRALS)}
        rows |= {"referencePositions": self.xRef, "physicsMass": self.totalMass}
        rows |= {"physicsInertia": self.inertiaLocal, "physicsCenterOfMass": self.chiU}
        if "matrix" in self.postProcessingModes:
            variable = str(self.postProcessingModes["outputVariableType"]).split(".")[-1]
            rows["outputVariableModeBasis"] = self.postProcessingModes["matrix"]
            rows["outputVariableTypeModeBasis"] = getattr(exu.OutputVariableType, variable)
        return rows

    # -- the equations as user functions

    def _kinematics(self, mbs: Any, q: Any, q_t: Any) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Rotation matrix, map of rates to the local angular velocity, and its rate without accelerations."""
        turned = mbs.GetNodeOutput(self.nRigidBody, exu.OutputVariableType.RotationMatrix).reshape(3, 3)
        parameters = np.array(q[3 : self.nODE2rigid]) + self.rotationParameters0
        kind = str(self.rigidBodyNodeType)
        if kind == "NodeType.RotationEulerParameters":
            return turned, EulerParameters2GLocal(parameters), np.zeros(3)
        if kind == "NodeType.RotationRotationVector":
            return turned, RotationVector2GLocal(parameters), np.zeros(3)
        rates = np.array(q_t[3 : self.nODE2rigid])
        return turned, RotXYZ2GLocal(parameters), RotXYZ2GLocal_t(parameters, rates) @ rates

    def UFmassFFRFreducedOrder(self, exu: Any, mbs: Any, t: float, qReduced: Any, qReduced_t: Any) -> FloatArray:
        """The mass matrix, for massMatrixUserFunction."""
        turned, g, _ = self._kinematics(mbs, qReduced, qReduced_t)
        n, rotations = self.nODE2rigid, slice(3, self.nODE2rigid)
        zeta = blocks_of(qReduced[n:])
        moment = self.totalMass * self.chiUtilde + self.mPhitTPsiTilde @ zeta
        arms = self.mXRefTildePsi + zeta.T @ self.mPsiTildePsi
        blocks = {(0, 1): -turned @ moment @ g, (0, 2): turned @ self.mPhitTPsi, (1, 2): -g.T @ arms}
        parts, m = (slice(0, 3), rotations, slice(n, None)), self.massMatrixFFRFreduced
        for (i, j), block in blocks.items():
            m[parts[i], parts[j]], m[parts[j], parts[i]] = block, block.T
        m[rotations, rotations] = g.T @ self._inertia(zeta) @ g
        return m

    def _inertia(self, zeta: FloatArray) -> FloatArray:
        linear = self.mXRefTildePsiTilde @ zeta
        return self.inertiaLocal + linear + linear.T + zeta.T @ self.mPsiTildePsiTilde @ zeta

    def UFforceFFRFreducedOrder(self, exu: Any, mbs: Any, t: float, qReduced: Any, qReduced_t: Any) -> FloatArray:
        """Weight, elastic forces and those that are quadratic in velocities, for forceUserFunction."""
        turned, g, bias = self._kinematics(mbs, qReduced, qReduced_t)
        n = self.nODE2rigid
        u, u_t = np.array(qReduced[n:]), np.array(qReduced_t[n:])
        zeta, zeta_t = blocks_of(u), blocks_of(u_t)
        w, weight = g @ np.array(qReduced_t[3:n]), turned.T @ self.gravity
        spin, moment = Skew(w), self.totalMass * self.chiUtilde + self.mPhitTPsiTilde @ zeta
        inertia, by_modes = self._inertia(zeta), self.mXRefTildePsiTilde.T + self.mPsiTildePsiTilde @ zeta
        changing = (self.mXRefTildePsiTilde + zeta.T @ self.mPsiTildePsiTilde) @ zeta_t
        arms = self.mXRefTildePsi + zeta.T @ self.mPsiTildePsi
        translation = spin @ moment @ w + 2 * self.mPhitTPsiTilde @ zeta_t @ w + moment @ bias + self.totalMass * weight
        rotation = -spin @ inertia @ w - 2 * changing @ w - inertia @ bias + moment @ weight
        modes = (
            (by_modes @ w).reshape(-1, 3) @ w
            + 2 * self.mPsiTildePsi.T @ (zeta_t @ w)
            + arms.T @ bias
            + self.mPhitTPsi.T @ weight
        )
        elastic = self.stiffnessMatrixReduced @ u + self.dampingMatrixReduced @ u_t
        return np.concatenate([turned @ translation, g.T @ rotation, modes - elastic])


def CMSObjectComputeNorm(
    mbs: Any, objectNumber: Any, outputVariableType: Any, norm: str = "max", nodeNumberList: Sequence[int] = ()
) -> Any:
    """Norm of an output variable over mesh nodes of a flexible body with modes, by default all of them.

    The variable is one of GetObjectOutputSuperElement. 'max' and 'min': of each component; 'maxNorm': the largest
    length of the vectors; 'Mises': the largest equivalent stress.
    """
    count = len(mbs.GetObjectParameter(objectNumber, "referencePositions")) // 3
    nodes = list(nodeNumberList) or range(count)
    values = np.array([mbs.GetObjectOutputSuperElement(objectNumber, outputVariableType, node) for node in nodes])
    if norm == "max":
        return values.max(axis=0)
    if norm == "min":
        return values.min(axis=0)
    if norm == "maxNorm":
        return np.linalg.norm(values, axis=1).max()
    if norm == "Mises" and outputVariableType == exu.OutputVariableType.StressLocal:
        return max(VonMisesStress(value) for value in values)
    raise ValueError(f"CMSObjectComputeNorm: norm must be max, min, maxNorm, or Mises of stresses, received {norm!r}")
