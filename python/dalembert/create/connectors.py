"""Create functions of spring-dampers, and of distance and coordinate constraints."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from dalembert import itemInterface as items
from dalembert._checks import FloatArray
from dalembert._core import InvalidIndex, MainSystem, NodeIndex, ObjectIndex, Print
from dalembert.create._arguments import (
    DEFAULT_COLOR,
    FLAG,
    NO_PAIR,
    NOT_NEGATIVE,
    ZERO3,
    Check,
    Connected,
    Matrix,
    UserFunction,
    Vector,
    argument_error,
    is_body,
    list_of,
    require_axis,
    rotation_matrix,
    vector,
)
from dalembert.create._frames import (
    add_end_marker,
    add_end_markers,
    add_joint_markers,
    connector_ends,
    end_distance,
    joint_place,
    marker_names,
    reference_rotation,
    require_items,
)
from dalembert.rigidBodyUtilities import ComputeOrthonormalBasisVectors


def CreateSpringDamper(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[Connected] = NO_PAIR,
    localPosition0: Vector = ZERO3,
    localPosition1: Vector = ZERO3,
    referenceLength: float | None = None,
    stiffness: float = 0.0,
    damping: float = 0.0,
    force: float = 0.0,
    velocityOffset: float = 0.0,
    springForceUserFunction: UserFunction = 0,
    bodyOrNodeList: Sequence[Connected] = NO_PAIR,
    bodyList: Sequence[Connected] = NO_PAIR,
    show: bool = True,
    drawSize: float = -1,
    color: Vector = DEFAULT_COLOR,
) -> ObjectIndex:
    """Add a spring-damper along the line between two points of bodies, nodes or markers; return its ObjectIndex.

    The default of referenceLength is the distance in the reference configuration.
    """
    ends = connector_ends("CreateSpringDamper", bodyNumbers, localPosition0, localPosition1, bodyOrNodeList, bodyList)
    if referenceLength is None:
        referenceLength = end_distance(mbs, "CreateSpringDamper", ends)
    return mbs.AddObject(
        items.ObjectConnectorSpringDamper(
            name=name,
            markerNumbers=add_end_markers(mbs, ends, name),
            referenceLength=referenceLength,
            stiffness=stiffness,
            damping=damping,
            force=force,
            velocityOffset=velocityOffset,
            springForceUserFunction=springForceUserFunction,
            visualization=items.VObjectConnectorSpringDamper(show=show, drawSize=drawSize, color=color),
        )
    )


def CreateCartesianSpringDamper(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[Connected] = NO_PAIR,
    localPosition0: Vector = ZERO3,
    localPosition1: Vector = ZERO3,
    stiffness: Vector = ZERO3,
    damping: Vector = ZERO3,
    offset: Vector = ZERO3,
    springForceUserFunction: UserFunction = 0,
    bodyOrNodeList: Sequence[Connected] = NO_PAIR,
    bodyList: Sequence[Connected] = NO_PAIR,
    show: bool = True,
    drawSize: float = -1,
    color: Vector = DEFAULT_COLOR,
) -> ObjectIndex:
    """Add a spring-damper along the global axes between points of bodies, nodes or markers; return its ObjectIndex."""
    ends = connector_ends(
        "CreateCartesianSpringDamper", bodyNumbers, localPosition0, localPosition1, bodyOrNodeList, bodyList
    )
    return mbs.AddObject(
        items.ObjectConnectorCartesianSpringDamper(
            name=name,
            markerNumbers=add_end_markers(mbs, ends, name),
            stiffness=stiffness,
            damping=damping,
            offset=offset,
            springForceUserFunction=springForceUserFunction,
            visualization=items.VObjectConnectorCartesianSpringDamper(show=show, drawSize=drawSize, color=color),
        )
    )


def CreateRigidBodySpringDamper(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[Connected] = NO_PAIR,
    localPosition0: Vector = ZERO3,
    localPosition1: Vector = ZERO3,
    stiffness: Matrix = np.zeros((6, 6)),
    damping: Matrix = np.zeros((6, 6)),
    offset: Vector = [0.0] * 6,
    rotationMatrixJoint: Matrix = np.eye(3),
    useGlobalFrame: bool = True,
    intrinsicFormulation: bool = True,
    springForceTorqueUserFunction: UserFunction = 0,
    postNewtonStepUserFunction: UserFunction = 0,
    bodyOrNodeList: Sequence[Connected] = NO_PAIR,
    bodyList: Sequence[Connected] = NO_PAIR,
    show: bool = True,
    drawSize: float = -1,
    color: Vector = DEFAULT_COLOR,
) -> ObjectIndex:
    """Add a spring-damper in six directions (three translations, three rotations); return its ObjectIndex.

    Stiffness, damping and offset count along the joint axes, the columns of rotationMatrixJoint.
    """
    ends = connector_ends(
        "CreateRigidBodySpringDamper", bodyNumbers, localPosition0, localPosition1, bodyOrNodeList, bodyList
    )
    require_items(mbs, "CreateRigidBodySpringDamper", ends.argument, ends.numbers)
    axes = np.asarray(rotationMatrixJoint, dtype=float)
    rotations = [reference_rotation(mbs, number) for number in ends.numbers]
    if not useGlobalFrame:
        axes = rotations[0] @ axes
    # The second end gets two markers, of which the connector uses the last: marker numbers that models rely on.
    first, _, second = (
        add_end_marker(mbs, ends.numbers[i], ends.localPositions[i], marker_name, rigid=True)
        for i, marker_name in ((0, marker_names(name)[0]), (1, ""), (1, marker_names(name)[1]))
    )
    return mbs.AddObject(
        items.ObjectConnectorRigidBodySpringDamper(
            name=name,
            markerNumbers=[first, second],
            stiffness=np.asarray(stiffness),
            damping=np.asarray(damping),
            offset=offset,
            rotationMarker0=rotations[0].T @ axes,
            rotationMarker1=rotations[1].T @ axes,
            intrinsicFormulation=intrinsicFormulation,
            springForceTorqueUserFunction=springForceTorqueUserFunction,
            postNewtonStepUserFunction=postNewtonStepUserFunction,
            visualization=items.VObjectConnectorRigidBodySpringDamper(show=show, drawSize=drawSize, color=color),
        )
    )


def frame_with_z(axis: FloatArray) -> FloatArray:
    """Return a rotation matrix whose third column is along the axis."""
    along, first, second = ComputeOrthonormalBasisVectors(axis)
    return np.array([-second, first, along]).T


def CreateTorsionalSpringDamper(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[Connected] = NO_PAIR,
    position: Vector = ZERO3,
    axis: Vector = ZERO3,
    stiffness: float = 0.0,
    damping: float = 0.0,
    offset: float = 0.0,
    velocityOffset: float = 0.0,
    torque: float = 0.0,
    useGlobalFrame: bool = True,
    springTorqueUserFunction: UserFunction = 0,
    unlimitedRotations: bool = True,
    show: bool = True,
    drawSize: float = -1,
    color: Vector = DEFAULT_COLOR,
) -> ObjectIndex:
    """Add a torsional spring-damper about an axis between two bodies or markers; return its ObjectIndex."""
    require_axis("CreateTorsionalSpringDamper", axis)
    place = joint_place(mbs, "CreateTorsionalSpringDamper", bodyNumbers, position, useGlobalFrame)
    rotation0, rotation1 = place.local_frames(frame_with_z(place.to_global(axis, useGlobalFrame)))
    markers = add_joint_markers(mbs, place, name)
    turns: NodeIndex | int = InvalidIndex()
    if unlimitedRotations:
        turns = mbs.AddNode(items.NodeGenericData(initialCoordinates=[0], numberOfDataCoordinates=1))
    return mbs.AddObject(
        items.ObjectConnectorTorsionalSpringDamper(
            name=name,
            markerNumbers=markers,
            nodeNumber=turns,
            stiffness=stiffness,
            damping=damping,
            offset=offset,
            velocityOffset=velocityOffset,
            torque=torque,
            rotationMarker0=rotation0,
            rotationMarker1=rotation1,
            springTorqueUserFunction=springTorqueUserFunction,
            visualization=items.VObjectConnectorTorsionalSpringDamper(show=show, drawSize=drawSize, color=color),
        )
    )


def CreateLinearSpringDamper(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[Connected] = NO_PAIR,
    position: Vector = ZERO3,
    axis: Vector = (1.0, 0.0, 0.0),
    stiffness: float = 0.0,
    damping: float = 0.0,
    offset: float = 0.0,
    velocityOffset: float = 0.0,
    force: float = 0.0,
    useGlobalFrame: bool = True,
    springForceUserFunction: UserFunction = 0,
    show: bool = True,
    drawSize: float = -1,
    color: Vector = DEFAULT_COLOR,
) -> ObjectIndex:
    """Add a spring-damper along an axis that is fixed to the first of two bodies or markers; return its ObjectIndex.

    Displacements count along the axis, from the position. A prismatic joint may guide the bodies along it.
    """
    require_axis("CreateLinearSpringDamper", axis)
    place = joint_place(mbs, "CreateLinearSpringDamper", bodyNumbers, position, useGlobalFrame)
    direction = place.to_global(axis, useGlobalFrame)
    return mbs.AddObject(
        items.ObjectConnectorLinearSpringDamper(
            name=name,
            markerNumbers=add_joint_markers(mbs, place, name),
            stiffness=stiffness,
            damping=damping,
            axisMarker0=place.rotations[0].T @ direction / np.linalg.norm(direction),
            offset=offset,
            velocityOffset=velocityOffset,
            force=force,
            springForceUserFunction=springForceUserFunction,
            visualization=items.VObjectConnectorLinearSpringDamper(show=show, drawSize=drawSize, color=color),
        )
    )


def CreateDistanceConstraint(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[Connected] = NO_PAIR,
    localPosition0: Vector = ZERO3,
    localPosition1: Vector = ZERO3,
    distance: float | None = None,
    bodyOrNodeList: Sequence[Connected] = NO_PAIR,
    bodyList: Sequence[Connected] = NO_PAIR,
    show: bool = True,
    drawSize: float = -1.0,
    color: Vector = DEFAULT_COLOR,
) -> ObjectIndex:
    """Keep the distance (m) of two points of bodies, nodes or markers constant; return the constraint's ObjectIndex.

    The default of `distance` is that of the reference configuration. A distance of zero has no direction: a spherical
    joint is added instead, in the xy plane if one of the bodies is planar.
    """
    ends = connector_ends(
        "CreateDistanceConstraint", bodyNumbers, localPosition0, localPosition1, bodyOrNodeList, bodyList
    )
    if distance is None:
        distance = end_distance(mbs, "CreateDistanceConstraint", ends)
    markers = add_end_markers(mbs, ends, name)
    if distance != 0:
        view = items.VObjectConnectorDistance(show=show, drawSize=drawSize, color=color)
        return mbs.AddObject(
            items.ObjectConnectorDistance(name=name, markerNumbers=markers, distance=distance, visualization=view)
        )
    Print("WARNING: CreateDistanceConstraint: the distance is 0, a spherical joint is created instead")
    planar = any(is_body(n) and "2D" in mbs.GetObject(n)["objectType"] for n in ends.numbers)
    return mbs.AddObject(
        items.ObjectJointSpherical(
            name=name,
            markerNumbers=markers,
            constrainedAxes=[1, 1, 0 if planar else 1],
            visualization=items.VObjectJointSpherical(show=show, jointRadius=0.5 * drawSize, color=color),
        )
    )


_NODES_WITHOUT_ODE2 = {"PointGround", "GenericODE1", "GenericAE", "GenericData"}


def _coordinate_marker(mbs: Any, function: str, i: int, body: Any, coordinate: Any, name: str) -> Any:
    """Add the marker on one of a body's coordinates, counted over all of its nodes."""
    body_data = mbs.GetObject(body)
    if isinstance(coordinate, str) and body_data["objectType"] == "KinematicTree":
        joint = items.MarkerNodeCoordinate(name=name, nodeNumber=body_data["nodeNumber"], coordinate=coordinate)
        return mbs.AddMarker(joint)
    if not isinstance(coordinate, (int, np.integer)) or coordinate < 0:
        raise argument_error(function, f"coordinates[{i}]", "the index of a coordinate of the body", coordinate)
    nodes = body_data["nodeNumbers"] if "nodeNumbers" in body_data else [body_data["nodeNumber"]]
    first = 0
    for node in nodes:
        node_data = mbs.GetNode(node)
        has_ode2 = node_data["nodeType"] not in _NODES_WITHOUT_ODE2
        size = len(node_data["referenceCoordinates"]) if has_ode2 else 0
        if coordinate < first + size:
            marker = items.MarkerNodeCoordinate(name=name, nodeNumber=node, coordinate=int(coordinate) - first)
            return mbs.AddMarker(marker)
        first += size
    expected = f"less than {first}, the number of coordinates of {body_data['objectType']} {int(body)}"
    raise argument_error(function, f"coordinates[{i}]", expected, coordinate)


def _is_grounded(mbs: Any, body: Any) -> bool:
    return body is None or mbs.GetObject(body)["objectType"] == "Ground"


def CreateCoordinateConstraint(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[ObjectIndex | int | str | None] = NO_PAIR,
    coordinates: Sequence[int | str | None] = NO_PAIR,
    offset: float = 0.0,
    factorValue1: float = 1.0,
    velocityLevel: bool = False,
    offsetUserFunction: UserFunction = 0,
    offsetUserFunction_t: UserFunction = 0,
    show: bool = True,
    drawSize: float = -1.0,
    color: Vector = DEFAULT_COLOR,
) -> ObjectIndex:
    """Constrain a coordinate of one body to that of another, or to ground; return the constraint's ObjectIndex.

    A body number of None, or of a ground object, means ground: its coordinate does not count. Coordinates of
    kinematic trees can be given by names of joints. The constraint reads factorValue1*q1 - q0 - offset = 0, or its
    rate if
    velocityLevel. At least one of the bodies must not be ground.
    """
    function = "CreateCoordinateConstraint"
    for i, body in enumerate(bodyNumbers):
        if body is not None and not isinstance(body, ObjectIndex):
            raise argument_error(function, f"bodyNumbers[{i}]", "an ObjectIndex, or None for ground", body)
    require_items(mbs, function, "bodyNumbers", bodyNumbers)
    if all(_is_grounded(mbs, body) for body in bodyNumbers):
        raise argument_error(function, "bodyNumbers", "at least one body that is not ground", bodyNumbers)

    markers = []
    for i, (body, coordinate, marker_name) in enumerate(zip(bodyNumbers, coordinates, marker_names(name), strict=True)):
        if _is_grounded(mbs, body):
            node = mbs.AddNode(items.NodePointGround(visualization=items.VNodePointGround(show=False)))
            markers.append(mbs.AddMarker(items.MarkerNodeCoordinate(name=marker_name, nodeNumber=node, coordinate=0)))
        else:
            markers.append(_coordinate_marker(mbs, function, i, body, coordinate, marker_name))
    return mbs.AddObject(
        items.ObjectConnectorCoordinate(
            name=name,
            markerNumbers=markers,
            offset=offset,
            factorValue1=factorValue1,
            velocityLevel=velocityLevel,
            offsetUserFunction=offsetUserFunction,
            offsetUserFunction_t=offsetUserFunction_t,
            visualization=items.VObjectConnectorCoordinate(show=show, drawSize=drawSize, color=color),
        )
    )


# Requirements on arguments besides those of the mirrored item and COMMON.
CHECKS: dict[str, dict[str, Check]] = {
    "CreateRigidBodySpringDamper": {"rotationMatrixJoint": rotation_matrix()},
    "CreateTorsionalSpringDamper": {"axis": vector(3), "unlimitedRotations": FLAG},
    "CreateLinearSpringDamper": {"axis": vector(3)},
    "CreateDistanceConstraint": {"distance": NOT_NEGATIVE.optional()},
    "CreateCoordinateConstraint": {
        "bodyNumbers": list_of(2, "body numbers"),
        "coordinates": list_of(2, "indices of coordinates of the bodies"),
    },
}
