"""Rotations, transformations and inertia of rigid bodies, and helpers that add bodies and joints to a MainSystem."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, as_rotation, as_vector, shape_error
from dalembert._geometry.inertia import (
    InertiaCuboid,
    InertiaCylinder,
    InertiaHollowSphere,
    InertiaMassPoint,
    InertiaRodX,
    InertiaSphere,
    RigidBodyInertia,
    TreeLink,
)
from dalembert._geometry.rotations import (
    AngularVelocity2EulerParameters_t,
    AngularVelocity2RotXYZ_t,
    ComputeOrthonormalBasis,
    ComputeOrthonormalBasisVectors,
    ComputeRotationAxisFromRotationVector,
    ComputeSkewMatrix,
    EulerParameters2G,
    EulerParameters2GLocal,
    EulerParameters2RotationMatrix,
    GramSchmidt,
    RotationMatrix2D,
    RotationMatrix2EulerParameters,
    RotationMatrix2RotationVector,
    RotationMatrix2RotXYZ,
    RotationMatrix2RotZYZ,
    RotationMatrixX,
    RotationMatrixY,
    RotationMatrixZ,
    RotationVector2G,
    RotationVector2GLocal,
    RotationVector2RotationMatrix,
    RotXYZ2EulerParameters,
    RotXYZ2G,
    RotXYZ2G_t,
    RotXYZ2GLocal,
    RotXYZ2GLocal_t,
    RotXYZ2RotationMatrix,
    Skew,
    Skew2Vec,
    eulerParameters0,
)
from dalembert._geometry.transformations import (
    HT,
    HT0,
    HomogeneousTransformation,
    HT2rotationMatrix,
    HT2T66Inverse,
    HT2translation,
    HTrotateX,
    HTrotateY,
    HTrotateZ,
    HTtranslate,
    HTtranslateX,
    HTtranslateY,
    HTtranslateZ,
    Inertia6D2InertiaTensor,
    InertiaTensor2Inertia6D,
    InverseHT,
    InverseT66toRotationTranslation,
    RotationTranslation2T66,
    RotationTranslation2T66Inverse,
    RotationX2T66,
    RotationY2T66,
    RotationZ2T66,
    T66Inverse,
    T66toHT,
    T66toRotationTranslation,
    Translation2T66,
    TranslationX2T66,
    TranslationY2T66,
    TranslationZ2T66,
)
from dalembert.advancedUtilities import IsValidBool, IsValidObjectIndex, IsValidRealInt

__all__ = [
    "AddPrismaticJoint",
    "AddRevoluteJoint",
    "AddRigidBody",
    "AngularVelocity2EulerParameters_t",
    "AngularVelocity2RotXYZ_t",
    "ComputeOrthonormalBasis",
    "ComputeOrthonormalBasisVectors",
    "ComputeRotationAxisFromRotationVector",
    "ComputeSkewMatrix",
    "EulerParameters2G",
    "EulerParameters2GLocal",
    "EulerParameters2RotationMatrix",
    "GetRigidBodyNode",
    "GramSchmidt",
    "HT",
    "HT0",
    "HT2T66Inverse",
    "HT2rotationMatrix",
    "HT2translation",
    "HTrotateX",
    "HTrotateY",
    "HTrotateZ",
    "HTtranslate",
    "HTtranslateX",
    "HTtranslateY",
    "HTtranslateZ",
    "HomogeneousTransformation",
    "Inertia6D2InertiaTensor",
    "InertiaCuboid",
    "InertiaCylinder",
    "InertiaHollowSphere",
    "InertiaMassPoint",
    "InertiaRodX",
    "InertiaSphere",
    "InertiaTensor2Inertia6D",
    "InverseHT",
    "InverseT66toRotationTranslation",
    "RigidBodyInertia",
    "RotXYZ2EulerParameters",
    "RotXYZ2G",
    "RotXYZ2GLocal",
    "RotXYZ2GLocal_t",
    "RotXYZ2G_t",
    "RotXYZ2RotationMatrix",
    "RotationMatrix2D",
    "RotationMatrix2EulerParameters",
    "RotationMatrix2RotXYZ",
    "RotationMatrix2RotZYZ",
    "RotationMatrix2RotationVector",
    "RotationMatrixX",
    "RotationMatrixY",
    "RotationMatrixZ",
    "RotationTranslation2T66",
    "RotationTranslation2T66Inverse",
    "RotationVector2G",
    "RotationVector2GLocal",
    "RotationVector2RotationMatrix",
    "RotationX2T66",
    "RotationY2T66",
    "RotationZ2T66",
    "Skew",
    "Skew2Vec",
    "StrNodeType2NodeType",
    "T66Inverse",
    "T66toHT",
    "T66toRotationTranslation",
    "Translation2T66",
    "TranslationX2T66",
    "TranslationY2T66",
    "TranslationZ2T66",
    "TreeLink",
    "eulerParameters0",
]

_nodeTypes = ("RotationEulerParameters", "RotationRxyz", "RotationRotationVector", "LieGroupWithDirectUpdate")


def _node_type_name(nodeType: Any) -> str:
    """Return the name of a node type given as enumeration value, 'NodeType.Name' or 'Name'."""
    name = getattr(nodeType, "name", nodeType)
    return str(name).rsplit(".", maxsplit=1)[-1]


def StrNodeType2NodeType(sNodeType: Any) -> Any:
    """Return the NodeType of a text such as 'NodeType.RotationEulerParameters' or 'RotationEulerParameters'.

    Raises ValueError for an unknown name.
    """
    import dalembert as exu

    name = _node_type_name(sNodeType)
    members = exu.NodeType.__members__
    if name not in members:
        raise shape_error("StrNodeType2NodeType: sNodeType", "one of " + ", ".join(members), sNodeType)
    return members[name]


def GetRigidBodyNode(
    nodeType: Any,
    position: npt.ArrayLike = [0, 0, 0],
    velocity: npt.ArrayLike = [0, 0, 0],
    rotationMatrix: npt.ArrayLike = [],
    rotationParameters: npt.ArrayLike = [],
    angularVelocity: npt.ArrayLike = [0, 0, 0],
) -> Any:
    """Return the rigid body node item of a node type with its reference coordinates and initial velocities.

    Position, velocity and angular velocity are in the global frame; the reference rotation is given either by a 3x3
    rotationMatrix or by the rotationParameters of the node type (default: no rotation). Raises ValueError if both are
    given, or if the node type is not that of a rigid body.
    """
    from dalembert import itemInterface as eii

    where = "GetRigidBodyNode: "
    name = _node_type_name(nodeType)
    if name not in _nodeTypes:
        raise shape_error(where + "nodeType", "one of " + ", ".join(_nodeTypes), nodeType)
    x = as_vector(where + "position", position, 3)
    v = as_vector(where + "velocity", velocity, 3)
    omega = as_vector(where + "angularVelocity", angularVelocity, 3)
    hasMatrix, hasParameters = np.size(rotationMatrix) != 0, np.size(rotationParameters) != 0
    if hasMatrix and hasParameters:
        raise ValueError(where + "expected either rotationMatrix or rotationParameters, received both")
    A = as_rotation(where + "rotationMatrix", rotationMatrix) if hasMatrix else np.eye(3)
    nParameters = 4 if name == "RotationEulerParameters" else 3
    given = as_vector(where + "rotationParameters", rotationParameters, nParameters) if hasParameters else None

    node: Any
    if name == "RotationEulerParameters":
        node = eii.NodeRigidBodyEP
        rotation = RotationMatrix2EulerParameters(A) if given is None else given
        rate = AngularVelocity2EulerParameters_t(omega, rotation)
    elif name == "RotationRxyz":
        node = eii.NodeRigidBodyRxyz
        rotation = RotationMatrix2RotXYZ(A) if given is None else given
        rate = AngularVelocity2RotXYZ_t(omega, rotation)
    else:
        node = eii.NodeRigidBodyRotVecLG
        rotation = RotationMatrix2RotationVector(A) if given is None else given
        rate = RotationVector2RotationMatrix(rotation).T @ omega
    return node(
        referenceCoordinates=np.concatenate([x, rotation]).tolist(),
        initialVelocities=np.concatenate([v, rate]).tolist(),
    )


def AddRigidBody(
    mainSys: Any,
    inertia: RigidBodyInertia,
    nodeType: Any = None,
    position: npt.ArrayLike = [0, 0, 0],
    velocity: npt.ArrayLike = [0, 0, 0],
    rotationMatrix: npt.ArrayLike = [],
    rotationParameters: npt.ArrayLike = [],
    angularVelocity: npt.ArrayLike = [0, 0, 0],
    gravity: npt.ArrayLike = [0, 0, 0],
    graphicsDataList: list[dict[str, Any]] = [],
) -> list[Any]:
    """Add a node, an ObjectRigidBody and, if there is gravity, its load; return [nodeNumber, bodyNumber].

    nodeType None means NodeType.RotationEulerParameters; vectors are in the global frame, gravity in m/s^2; the
    rotation is given as in GetRigidBodyNode. MainSystem.CreateRigidBody replaces this function.
    """
    from dalembert import itemInterface as eii

    if not isinstance(inertia, RigidBodyInertia):
        raise shape_error("AddRigidBody: inertia", "a RigidBodyInertia", inertia)
    if not isinstance(graphicsDataList, list):
        raise shape_error("AddRigidBody: graphicsDataList", "a list of graphicsData dictionaries", graphicsDataList)
    acceleration = as_vector("AddRigidBody: gravity", gravity, 3)
    kind = "RotationEulerParameters" if nodeType is None else nodeType
    node = GetRigidBodyNode(kind, position, velocity, rotationMatrix, rotationParameters, angularVelocity)

    nodeNumber = mainSys.AddNode(node)
    body = eii.ObjectRigidBody(
        physicsMass=inertia.mass,
        physicsInertia=inertia.GetInertia6D(),
        physicsCenterOfMass=inertia.com,
        nodeNumber=nodeNumber,
        visualization=eii.VObjectRigidBody(graphicsData=graphicsDataList),
    )
    bodyNumber = mainSys.AddObject(body)
    if np.any(acceleration != 0.0):
        markerNumber = mainSys.AddMarker(eii.MarkerBodyMass(bodyNumber=bodyNumber))
        mainSys.AddLoad(eii.LoadMassProportional(markerNumber=markerNumber, loadVector=acceleration))
    return [nodeNumber, bodyNumber]


def _joint_frames(
    where: str, mbs: Any, bodies: list[Any], point: npt.ArrayLike, axis: npt.ArrayLike, useGlobalFrame: bool
) -> tuple[FloatArray, list[FloatArray], list[FloatArray]]:
    """Return the global joint axis, and per body the local joint position and rotation matrix (local to global)."""
    import dalembert as exu
    from dalembert._tools.found_items import index_of

    p, a = as_vector(where + "point", point, 3), as_vector(where + "axis", axis, 3)
    if not IsValidBool(useGlobalFrame):
        raise shape_error(where + "useGlobalFrame", "a bool", useGlobalFrame)
    positions, rotations = [], []
    for i, body in enumerate(bodies):
        if isinstance(body, str):
            body = bodies[i] = index_of(mbs, "Object", body, f"{where}body{i}")
        if not IsValidObjectIndex(body):
            raise shape_error(f"{where}body{i}", "an ObjectIndex or a name", body)
        where_ = {"localPosition": [0, 0, 0], "configuration": exu.ConfigurationType.Reference}
        output = exu.OutputVariableType
        positions.append(np.asarray(mbs.GetObjectOutputBody(body, output.Position, **where_)))
        rotations.append(np.asarray(mbs.GetObjectOutputBody(body, output.RotationMatrix, **where_)).reshape(3, 3))
    if not useGlobalFrame:
        p, a = rotations[0] @ p + positions[0], rotations[0] @ a
    local = [A.T @ (p - x) for A, x in zip(rotations, positions, strict=True)]
    return a, local, rotations


def _add_axis_joint(
    where: str,
    mbs: Any,
    kind: str,
    visualization: dict[str, Any],
    bodies: list[Any],
    local: list[FloatArray],
    markerRotations: list[FloatArray],
) -> list[Any]:
    """Add a rigid marker per body and the joint between them; return [joint, marker0, marker1]."""
    from dalembert import itemInterface as eii

    for key in ("axisRadius", "axisLength"):
        if not IsValidRealInt(visualization[key]):
            raise shape_error(where + key, "a number", visualization[key])
    if not IsValidBool(visualization["show"]):
        raise shape_error(where + "showJoint", "a bool", visualization["show"])
    markers = [
        mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=body, localPosition=x))
        for body, x in zip(bodies, local, strict=True)
    ]
    joint = getattr(eii, kind)(
        markerNumbers=markers,
        rotationMarker0=markerRotations[0],
        rotationMarker1=markerRotations[1],
        visualization=getattr(eii, "V" + kind)(**visualization),
    )
    return [mbs.AddObject(joint), *markers]


def AddRevoluteJoint(
    mbs: Any,
    body0: Any,
    body1: Any,
    point: npt.ArrayLike,
    axis: npt.ArrayLike,
    useGlobalFrame: bool = True,
    showJoint: bool = True,
    axisRadius: float = 0.1,
    axisLength: float = 0.4,
) -> list[Any]:
    """Add a revolute joint between two rigid (or ground) bodies; return [joint, marker0, marker1].

    Point and axis are given in the reference configuration, in the global frame or, if useGlobalFrame is False, in
    the frame of body0. Deprecated: MainSystem.CreateRevoluteJoint replaces this function.
    """
    warnings.warn("AddRevoluteJoint is deprecated; use mbs.CreateRevoluteJoint", DeprecationWarning, stacklevel=2)
    where, bodies = "AddRevoluteJoint: ", [body0, body1]
    rotationAxis, local, A = _joint_frames(where, mbs, bodies, point, axis, useGlobalFrame)
    e0, e1, e2 = ComputeOrthonormalBasisVectors(rotationAxis)
    frame = np.column_stack([-e2, e1, e0])  # the joint turns about its local z axis
    visualization = {"show": showJoint, "axisRadius": axisRadius, "axisLength": axisLength}
    markerRotations = [A[0].T @ frame, A[1].T @ frame]
    return _add_axis_joint(where, mbs, "ObjectJointRevoluteZ", visualization, bodies, local, markerRotations)


def AddPrismaticJoint(
    mbs: Any,
    body0: Any,
    body1: Any,
    point: npt.ArrayLike,
    axis: npt.ArrayLike,
    useGlobalFrame: bool = True,
    showJoint: bool = True,
    axisRadius: float = 0.1,
    axisLength: float = 0.4,
) -> list[Any]:
    """Add a prismatic joint between two rigid (or ground) bodies; return [joint, marker0, marker1].

    Point and axis are given in the reference configuration, in the global frame or, if useGlobalFrame is False, in
    the frame of body0. Deprecated: MainSystem.CreatePrismaticJoint replaces this function.
    """
    warnings.warn("AddPrismaticJoint is deprecated; use mbs.CreatePrismaticJoint", DeprecationWarning, stacklevel=2)
    where, bodies = "AddPrismaticJoint: ", [body0, body1]
    slideAxis, local, A = _joint_frames(where, mbs, bodies, point, axis, useGlobalFrame)
    frame = ComputeOrthonormalBasis(slideAxis)  # the joint slides along its local x axis
    visualization = {"show": showJoint, "axisRadius": axisRadius, "axisLength": axisLength}
    markerRotations = [A[0].T @ frame, A[1].T @ frame]
    return _add_axis_joint(where, mbs, "ObjectJointPrismaticX", visualization, bodies, local, markerRotations)
