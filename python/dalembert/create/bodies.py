"""Create functions of ground, mass points and rigid bodies: node, body, and gravity load in one call."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from dalembert import itemInterface as items
from dalembert._checks import FloatArray
from dalembert._core import MainSystem, NodeType, ObjectIndex
from dalembert._geometry.rigid_transformation import parts
from dalembert.create._arguments import (
    DEFAULT_COLOR,
    FLAG,
    ZERO3,
    Check,
    Matrix,
    UserFunction,
    Vector,
    argument_error,
    rotation_matrix,
    vector,
)
from dalembert.rigidBodyUtilities import (
    AngularVelocity2EulerParameters_t,
    AngularVelocity2RotXYZ_t,
    RigidBodyInertia,
    RotationMatrix2EulerParameters,
    RotationMatrix2RotationVector,
    RotationMatrix2RotXYZ,
)


def _parts(function: str, name: str, value: Any, given: dict[str, Any]) -> tuple[FloatArray, FloatArray]:
    """Return translation and rotation of an HT, a 4 x 4 matrix or its 16 values, with which no part may be given."""
    for part, other in given.items():
        if other is not None and not np.array_equal(other, np.eye(3) if np.ndim(other) == 2 else ZERO3):
            raise argument_error(function, part, f"nothing, as {name} is given", other)
    position, rotation = parts(f"MainSystem.{function}(...): {name}", value, False, True)
    return position, rotation


def CreateGround(
    mbs: MainSystem,
    name: str = "",
    referencePosition: Vector = ZERO3,
    referenceRotationMatrix: Matrix = np.eye(3),
    graphicsDataList: list[dict[str, Any]] = [],
    graphicsDataUserFunction: UserFunction = 0,
    show: bool = True,
    referenceHT: Any = None,
) -> ObjectIndex:
    """Add a ground object and return its ObjectIndex.

    Position (m) and rotation (local to global) are those of the ground's frame, in the global frame; referenceHT gives
    both.
    """
    if referenceHT is not None:
        given = {"referencePosition": referencePosition, "referenceRotationMatrix": referenceRotationMatrix}
        referencePosition, referenceRotationMatrix = _parts("CreateGround", "referenceHT", referenceHT, given)
    visualization = items.VObjectGround(
        show=show, graphicsDataUserFunction=graphicsDataUserFunction, graphicsData=graphicsDataList
    )
    return mbs.AddObject(
        items.ObjectGround(
            name=name,
            referencePosition=referencePosition,
            referenceRotation=np.asarray(referenceRotationMatrix),
            visualization=visualization,
        )
    )


# How items are drawn; read only.
_AS_EVER: dict[str, Any] = {}
_HIDDEN = {"show": False}


def _node_view(show: bool, drawSize: float, color: Vector) -> dict[str, Any]:
    """Return how a node is drawn, as far as it is not drawn by default. Graphics replaces its symbol: drawSize is 0."""
    if show is True and drawSize == -1 and color is DEFAULT_COLOR:
        return _AS_EVER
    return {"show": show, "drawSize": drawSize, "color": color}


def _add_gravity(mbs: Any, node: Any, body: Any, gravity: Vector, returnDict: bool) -> Any:
    """Add the weight of a body, if there is gravity, and return the result of its Create function."""
    if not any(gravity):
        return {"nodeNumber": node, "bodyNumber": body} if returnDict else body
    marker = mbs.AddMarker(items.MarkerBodyMass(bodyNumber=body))
    load = mbs.AddLoad(items.LoadMassProportional(markerNumber=marker, loadVector=gravity))
    if not returnDict:
        return body
    return {"nodeNumber": node, "bodyNumber": body, "markerBodyMass": marker, "loadNumber": load}


def CreateMassPoint(
    mbs: Any,
    name: str = "",
    referencePosition: Vector = ZERO3,
    initialDisplacement: Vector = ZERO3,
    initialVelocity: Vector = ZERO3,
    physicsMass: float = 0,
    gravity: Vector = ZERO3,
    graphicsDataList: list[Any] = [],
    drawSize: float = -1,
    color: Vector = DEFAULT_COLOR,
    show: bool = True,
    create2D: bool = False,
    returnDict: bool = False,
) -> Any:
    """Add a mass point with its node, and its weight if there is gravity; return the body's ObjectIndex.

    Planar points use only x and y of vectors. returnDict=True returns a dict with nodeNumber, bodyNumber and, if
    there is
    gravity, markerBodyMass and loadNumber.
    """
    node_type: Any = items.NodePoint
    body_type: Any = items.ObjectMassPoint
    if create2D:
        node_type, body_type = items.NodePoint2D, items.ObjectMassPoint2D
        referencePosition, initialDisplacement = referencePosition[:2], initialDisplacement[:2]
        initialVelocity = initialVelocity[:2]
    node_view = _node_view(show, 0 if graphicsDataList else drawSize, color)
    node = mbs.AddNode(
        node_type(
            name=f"Node:{name}" if name else "",
            referenceCoordinates=referencePosition,
            initialCoordinates=initialDisplacement,
            initialVelocities=initialVelocity,
            visualization=node_view,
        )
    )
    body_view = {"graphicsData": graphicsDataList} if graphicsDataList else _HIDDEN
    body = mbs.AddObject(body_type(name=name, physicsMass=physicsMass, nodeNumber=node, visualization=body_view))
    return _add_gravity(mbs, node, body, gravity, returnDict)


class _RotationParameters(NamedTuple):
    """How a node type describes rotations: its item, and the maps to its parameters and their rates."""

    item: str
    of_matrix: Callable[[FloatArray], FloatArray]
    rates: Callable[
        [FloatArray, FloatArray, FloatArray], FloatArray
    ]  # arguments: global omega, initial parameters and matrix


_ROTATION_PARAMETERS = {
    NodeType.RotationEulerParameters: _RotationParameters(
        "NodeRigidBodyEP",
        RotationMatrix2EulerParameters,
        lambda omega, parameters, A: AngularVelocity2EulerParameters_t(omega, parameters),
    ),
    NodeType.RotationRxyz: _RotationParameters(
        "NodeRigidBodyRxyz",
        RotationMatrix2RotXYZ,
        lambda omega, parameters, A: AngularVelocity2RotXYZ_t(omega, parameters),
    ),
    NodeType.RotationRotationVector: _RotationParameters(
        "NodeRigidBodyRotVecLG",
        RotationMatrix2RotationVector,
        lambda omega, parameters, A: A.T @ omega,  # local angular velocity
    ),
}


def _node_3d(
    nodeType: Any,
    position: Vector,
    A: FloatArray,
    velocity: Vector,
    omega: FloatArray,
    displacement: Vector | None,
    rotation: FloatArray | None,
) -> tuple[str, dict[str, Any]]:
    """Return item name and coordinates of a spatial node; the initial rotation counts from the reference."""
    if nodeType not in _ROTATION_PARAMETERS:
        known = ", ".join(str(key) for key in _ROTATION_PARAMETERS)
        raise argument_error("CreateRigidBody", "nodeType", f"one of {known}", nodeType)
    kind = _ROTATION_PARAMETERS[nodeType]
    reference = np.asarray(kind.of_matrix(A))
    initial = np.zeros(3 + len(reference))
    total, turned = reference, A
    if displacement is not None:
        initial[:3] = displacement
    if rotation is not None:
        turned = A @ rotation
        total = np.asarray(kind.of_matrix(turned))
        initial[3:] = total - reference
    return kind.item, {
        "referenceCoordinates": [*position, *reference],
        "initialCoordinates": list(initial),
        "initialVelocities": [*velocity, *kind.rates(omega, total, turned)],
    }


def _turns_about_z(A: FloatArray) -> bool:
    return bool(np.abs([A[2, 0], A[2, 1], A[0, 2], A[1, 2], A[2, 2] - 1.0]).sum() <= 1e-13)


def _node_2d(
    position: Vector,
    A: FloatArray,
    velocity: Vector,
    omega: FloatArray,
    displacement: Vector | None,
    rotation: FloatArray | None,
) -> tuple[str, dict[str, Any]]:
    """Return item name and coordinates of a planar node; the initial rotation is the total one, about z.

    ValueError names the argument that leaves the plane.
    """

    def stays_in_plane(argument: str, value: Any, condition: bool, expected: str) -> None:
        if not condition:
            raise argument_error("CreateRigidBody", argument, f"{expected} (create2D=True)", value)

    for argument, value in {
        "referencePosition": position,
        "initialVelocity": velocity,
        "initialDisplacement": ZERO3 if displacement is None else displacement,
    }.items():
        stays_in_plane(argument, value, abs(value[2]) <= 1e-14, "a vector without z component")
    stays_in_plane("initialAngularVelocity", omega, np.abs(omega[:2]).sum() <= 1e-14, "a vector along z")
    stays_in_plane("referenceRotationMatrix", A, _turns_about_z(A), "a rotation about z")

    angle = float(np.arctan2(A[1, 0], A[0, 0]))
    initial = [0.0, 0.0, 0.0]
    if displacement is not None:
        initial[:2] = displacement[0], displacement[1]
    if rotation is not None:
        stays_in_plane("initialRotationMatrix", rotation, _turns_about_z(rotation), "a rotation about z")
        initial[2] = float(np.arctan2(rotation[1, 0], rotation[0, 0])) - angle
    return "NodeRigidBody2D", {
        "referenceCoordinates": [position[0], position[1], angle],
        "initialCoordinates": initial,
        "initialVelocities": [velocity[0], velocity[1], omega[2]],
    }


def CreateRigidBody(
    mbs: Any,
    name: str = "",
    referencePosition: Vector = ZERO3,
    referenceRotationMatrix: FloatArray = np.eye(3),
    initialVelocity: Vector = ZERO3,
    initialAngularVelocity: Vector = ZERO3,
    initialDisplacement: Vector | None = None,
    initialRotationMatrix: FloatArray | None = None,
    inertia: RigidBodyInertia | None = None,
    gravity: Vector = ZERO3,
    nodeType: Any = NodeType.RotationEulerParameters,
    graphicsDataList: list[Any] = [],
    graphicsDataUserFunction: Any = 0,
    drawSize: float = -1,
    color: Vector = DEFAULT_COLOR,
    show: bool = True,
    create2D: bool = False,
    returnDict: bool = False,
    referenceHT: Any = None,
    initialHT: Any = None,
) -> Any:
    """Add a rigid body with its node, and its weight if there is gravity; return the body's ObjectIndex.

    If graphicsDataList is not given, the body is drawn in the shape of its inertia, and its node if drawSize is given.
    returnDict=True returns a dict with nodeNumber, bodyNumber and, if there is gravity, markerBodyMass and loadNumber.
    """
    if referenceHT is not None:
        given = {"referencePosition": referencePosition, "referenceRotationMatrix": referenceRotationMatrix}
        referencePosition, referenceRotationMatrix = _parts("CreateRigidBody", "referenceHT", referenceHT, given)
    if initialHT is not None:
        start = {"initialDisplacement": initialDisplacement, "initialRotationMatrix": initialRotationMatrix}
        initialDisplacement, initialRotationMatrix = _parts("CreateRigidBody", "initialHT", initialHT, start)
    if not isinstance(inertia, RigidBodyInertia):
        raise argument_error("CreateRigidBody", "inertia", "a RigidBodyInertia, e.g. InertiaCuboid(...)", inertia)
    if create2D and np.linalg.norm(inertia.com) > 1e-14:
        expected = "an inertia with its centre of mass at [0,0,0] (create2D=True)"
        raise argument_error("CreateRigidBody", "inertia", expected, inertia.com)
    A, omega = np.asarray(referenceRotationMatrix, dtype=float), np.asarray(initialAngularVelocity, dtype=float)
    rotation = None if initialRotationMatrix is None else np.asarray(initialRotationMatrix, dtype=float)
    motion = (referencePosition, A, initialVelocity, omega, initialDisplacement, rotation)
    node_type, coordinates = _node_2d(*motion) if create2D else _node_3d(nodeType, *motion)

    hides_node = bool(graphicsDataList)
    if not graphicsDataList and (shape := inertia.GetGraphics(color)):
        graphicsDataList, hides_node = [shape], drawSize == -1
    node_view = _node_view(show, 0 if hides_node else drawSize, color)
    node = mbs.AddNode(
        getattr(items, node_type)(name=f"Node:{name}" if name else "", visualization=node_view, **coordinates)
    )
    suffix = "2D" if create2D else ""
    tensor = inertia.GetInertia6D()
    mass = (
        {"physicsInertia": tensor[2]}
        if create2D
        else {
            "physicsInertia": tensor,
            "physicsCenterOfMass": inertia.com,
        }
    )
    body_view = getattr(items, "VObjectRigidBody" + suffix)(
        show=show, graphicsDataUserFunction=graphicsDataUserFunction, graphicsData=graphicsDataList
    )
    body = mbs.AddObject(
        getattr(items, "ObjectRigidBody" + suffix)(
            name=name, physicsMass=inertia.mass, nodeNumber=node, visualization=body_view, **mass
        )
    )
    return _add_gravity(mbs, node, body, gravity, returnDict)


# Requirements on arguments besides those of the mirrored item and COMMON.
CHECKS: dict[str, dict[str, Check]] = {
    "CreateGround": {
        "referencePosition": vector(3),
        "referenceRotationMatrix": rotation_matrix(),
    },
    "CreateMassPoint": {
        "referencePosition": vector(3),
        "initialDisplacement": vector(3),
        "initialVelocity": vector(3),
        "gravity": vector(3),
        "create2D": FLAG,
        "returnDict": FLAG,
    },
    "CreateRigidBody": {
        "referencePosition": vector(3),
        "referenceRotationMatrix": rotation_matrix(),
        "initialVelocity": vector(3),
        "initialAngularVelocity": vector(3),
        "initialDisplacement": vector(3).optional(),
        "initialRotationMatrix": rotation_matrix().optional(),
        "gravity": vector(3),
        "create2D": FLAG,
        "returnDict": FLAG,
    },
}
