"""A flexible body with all coordinates of its mesh, in a floating frame of reference."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._fem.eigen import rigid_motions
from dalembert._names import eii
from dalembert._names import exu as package
from dalembert.rigidBodyUtilities import (
    AngularVelocity2EulerParameters_t,
    EulerParameters2GLocal,
    eulerParameters0,
)


class ObjectFFRFinterface:
    """Mesh, matrices and surface of a body, and the body itself; `femInterface` is a FEMinterface with matrices."""

    def __init__(self, femInterface: Any) -> None:
        self.modeBasis = femInterface.modeBasis.get("matrix")
        self.nodeArray: FloatArray = femInterface.GetNodePositionsAsArray()
        self.trigList = femInterface.GetSurfaceTriangles()
        self.massMatrixSparse = femInterface.GetMassMatrix(sparse=True)
        self.stiffnessMatrixSparse = femInterface.GetStiffnessMatrix(sparse=True)
        self.nNodes, self.dim3D, self.nODE2rot = len(self.nodeArray), 3, 4
        self.nODE2rigid = self.dim3D + self.nODE2rot
        self.nODE2FF = self.dim3D * self.nNodes
        self.nODE2FFRF = self.nODE2rigid + self.nODE2FF
        motions = rigid_motions(self.nodeArray)
        self.Phit, self.xRef = motions[:, :3], self.nodeArray.ravel()
        self.PhitTM = (self.massMatrixSparse @ self.Phit).T
        self.xRefTilde = -motions[:, 3:]
        self.inertiaLocal = self.xRefTilde.T @ (self.massMatrixSparse @ self.xRefTilde)

    def AddObjectFFRF(
        self,
        exu: Any,
        mbs: Any,
        positionRef: Sequence[float] = [0, 0, 0],
        eulerParametersRef: Sequence[float] = [1, 0, 0, 0],
        initialVelocity: Sequence[float] = [0, 0, 0],
        initialAngularVelocity: Sequence[float] = [0, 0, 0],
        gravity: Sequence[float] = [0, 0, 0],
        constrainRigidBodyMotion: bool = True,
        massProportionalDamping: float = 0,
        stiffnessProportionalDamping: float = 0,
        color: Sequence[float] = [0.1, 0.9, 0.1, 1.0],
    ) -> dict[str, Any]:
        """Add frame, mesh nodes, body, weight, and the constraint that holds the frame to the mesh; return numbers.

        constrainRigidBodyMotion prevents the mass-weighted mean translation and rotation of the mesh relative to the
        frame
        (Tisserand frame); otherwise, the model must provide six conditions.
        """
        rates = AngularVelocity2EulerParameters_t(initialAngularVelocity, eulerParametersRef)
        frame = eii.NodeRigidBodyEP(
            referenceCoordinates=[*positionRef, *eulerParametersRef],
            initialVelocities=[*initialVelocity, *np.asarray(rates)],
        )
        self.eulerParametersRef, self.gravity = (
            np.array(eulerParametersRef, dtype=float),
            np.array(gravity, dtype=float),
        )
        self.nRigidBody = mbs.AddNode(frame)
        self.nodeList = [mbs.AddNode(eii.NodePoint(referenceCoordinates=point)) for point in self.nodeArray]
        damping: Any = []
        if massProportionalDamping != 0 or stiffnessProportionalDamping != 0:
            damping = massProportionalDamping * self.massMatrixSparse
            damping = package.MatrixContainer(damping + stiffnessProportionalDamping * self.stiffnessMatrixSparse)
        body = eii.ObjectFFRF(
            nodeNumbers=[self.nRigidBody, *self.nodeList],
            massMatrixFF=package.MatrixContainer(self.massMatrixSparse),
            stiffnessMatrixFF=package.MatrixContainer(self.stiffnessMatrixSparse),
            dampingMatrixFF=damping,
            visualization={"triangleMesh": self.trigList, "color": list(color), "showNodes": True},
        )
        self.oFFRF, self.oRigidBodyConstraint, self.loadGravity = mbs.AddObject(body), -1, None
        if np.any(self.gravity):
            weight = mbs.AddMarker(eii.MarkerBodyMass(bodyNumber=self.oFFRF))
            self.loadGravity = mbs.AddLoad(eii.LoadMassProportional(markerNumber=weight, loadVector=self.gravity))
        if constrainRigidBodyMotion:
            self.oRigidBodyConstraint = self._hold_frame(mbs)
        names = ("nRigidBody", "nodeList", "oFFRF", "oRigidBodyConstraint", "loadGravity")
        return {name: getattr(self, name) for name in names}

    def _hold_frame(self, mbs: Any) -> Any:
        """Six equations: displacements, weighted by mass, have no mean and no mean moment."""
        ground = mbs.AddNode(eii.NodePointGround(visualization={"show": False}))
        markers = [
            mbs.AddMarker(eii.MarkerNodeCoordinates(nodeNumber=ground)),
            mbs.AddMarker(eii.MarkerObjectODE2Coordinates(objectNumber=self.oFFRF)),
        ]
        factors = np.zeros((6, self.nODE2FFRF))
        factors[:3, self.nODE2rigid :] = self.PhitTM
        factors[3:, self.nODE2rigid :] = (self.massMatrixSparse @ self.xRefTilde).T
        offset = factors[:, self.nODE2rigid :] @ self.xRef  # coordinates of the marker are total ones
        constraint = eii.CoordinateVectorConstraint(markerNumbers=markers, scalingMarker1=factors, offset=offset)
        return mbs.AddObject(constraint)

    # -- the equations as user functions of an ObjectGenericODE2 with the same nodes, or of an ObjectFFRF without terms

    def _state(self, mbs: Any, q: Any, q_t: Any) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
        """Rotation matrix, map of rates to the local angular velocity, that velocity, local positions of nodes."""
        rotation = mbs.GetNodeOutput(self.nRigidBody, package.OutputVariableType.RotationMatrix).reshape(3, 3)
        reference = getattr(self, "eulerParametersRef", np.array(eulerParameters0))
        g = np.asarray(EulerParameters2GLocal(np.array(q[3:7]) + reference))
        local = (self.xRef + np.array(q[self.nODE2rigid :])).reshape(-1, 3)
        return rotation, g, g @ np.array(q_t[3:7]), local

    def UFforce(self, exu: Any, mbs: Any, t: float, q: Any, q_t: Any) -> FloatArray:
        """Forces that are quadratic in velocities, for forceUserFunction of a body without floating-frame terms."""
        rotation, g, w, local = self._state(mbs, q, q_t)
        rates = np.array(q_t[self.nODE2rigid :]).reshape(-1, 3)
        accelerations = np.cross(w, np.cross(w, local)) + 2 * np.cross(w, rates)
        forces = -(self.massMatrixSparse @ accelerations.ravel()).reshape(-1, 3)
        moment = np.cross(local, forces).sum(axis=0)
        return np.concatenate([rotation @ forces.sum(axis=0), g.T @ moment, forces.ravel()])

    def UFmassGenericODE2(self, exu: Any, mbs: Any, t: float, q: Any, q_t: Any) -> FloatArray:
        """The parts of the mass matrix that belong to the frame, for massMatrixUserFunction."""
        rotation, g, _, local = self._state(mbs, q, q_t)
        motions = rigid_motions(local)
        to_nodes = np.hstack([motions[:, :3] @ rotation.T, motions[:, 3:] @ g])  # accelerations of nodes, local
        with_mesh = (self.massMatrixSparse @ to_nodes).T
        n, matrix = self.nODE2rigid, np.zeros((self.nODE2FFRF, self.nODE2FFRF))
        matrix[:n, :n], matrix[:n, n:], matrix[n:, :n] = with_mesh @ to_nodes, with_mesh, with_mesh.T
        return matrix
