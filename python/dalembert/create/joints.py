"""Create functions of joints and rolling discs between two bodies."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from dalembert import itemInterface as items
from dalembert._checks import FloatArray
from dalembert._core import MainSystem, MarkerIndex, ObjectIndex
from dalembert.create._arguments import (
    DEFAULT_COLOR,
    NO_PAIR,
    Check,
    Connected,
    Matrix,
    UserFunction,
    Vector,
    argument_error,
    flags,
    is_body,
    require_axis,
    require_two_bodies,
    rotation_matrix,
    vector,
)
from dalembert.create._frames import (
    JointPlace,
    add_joint_markers,
    is_planar,
    joint_place,
    marker_names,
    reference_position,
    require_axis_of_plane,
    require_items,
)
from dalembert.create.connectors import frame_with_z
from dalembert.rigidBodyUtilities import ComputeOrthonormalBasis


def CreateRevoluteJoint(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[Connected] = NO_PAIR,
    position: Vector = [],
    axis: Vector = [],
    useGlobalFrame: bool = True,
    show: bool = True,
    axisRadius: float = 0.1,
    axisLength: float = 0.4,
    color: Vector = DEFAULT_COLOR,
) -> ObjectIndex:
    """Add a hinge between two bodies or markers and return its ObjectIndex.

    If one of them is a marker, it sets the position: then position must be []. Bodies in the xy plane (create2D=True)
    get the planar joint, ObjectJointRevolute2D.
    """
    require_axis("CreateRevoluteJoint", axis)
    place = joint_place(mbs, "CreateRevoluteJoint", bodyNumbers, position, useGlobalFrame)
    direction = place.to_global(axis, useGlobalFrame)
    require_axis_of_plane(mbs, "CreateRevoluteJoint", place, direction, normal=True)
    if is_planar(mbs, place):
        view = items.VObjectJointRevolute2D(show=show, drawSize=2 * axisRadius, color=color)
        markers = add_joint_markers(mbs, place, name, rigid=False)
        return mbs.AddObject(items.ObjectJointRevolute2D(name=name, markerNumbers=markers, visualization=view))
    rotation0, rotation1 = place.local_frames(frame_with_z(direction))
    return mbs.AddObject(
        items.ObjectJointRevoluteZ(
            name=name,
            markerNumbers=add_joint_markers(mbs, place, name),
            rotationMarker0=rotation0,
            rotationMarker1=rotation1,
            visualization=items.VObjectJointRevoluteZ(
                show=show, axisRadius=axisRadius, axisLength=axisLength, color=color
            ),
        )
    )


def CreatePrismaticJoint(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[Connected] = NO_PAIR,
    position: Vector = [],
    axis: Vector = [],
    useGlobalFrame: bool = True,
    show: bool = True,
    axisRadius: float = 0.1,
    axisLength: float = 0.4,
    color: Vector = DEFAULT_COLOR,
) -> ObjectIndex:
    """Add a slider between two bodies or markers and return its ObjectIndex.

    If one of them is a marker, it sets the position: then position must be []. Bodies in the xy plane (create2D=True)
    get the planar joint, ObjectJointPrismatic2D.
    """
    require_axis("CreatePrismaticJoint", axis)
    place = joint_place(mbs, "CreatePrismaticJoint", bodyNumbers, position, useGlobalFrame)
    direction = place.to_global(axis, useGlobalFrame)
    require_axis_of_plane(mbs, "CreatePrismaticJoint", place, direction, normal=False)
    if is_planar(mbs, place):
        along = direction / np.linalg.norm(direction)
        return mbs.AddObject(
            items.ObjectJointPrismatic2D(
                name=name,
                markerNumbers=add_joint_markers(mbs, place, name),
                axisMarker0=place.rotations[0].T @ along,
                normalMarker1=place.rotations[1].T @ np.cross([0, 0, 1], along),
                visualization=items.VObjectJointPrismatic2D(show=show, drawSize=2 * axisRadius, color=color),
            )
        )
    rotation0, rotation1 = place.local_frames(ComputeOrthonormalBasis(direction))
    return mbs.AddObject(
        items.ObjectJointPrismaticX(
            name=name,
            markerNumbers=add_joint_markers(mbs, place, name),
            rotationMarker0=rotation0,
            rotationMarker1=rotation1,
            visualization=items.VObjectJointPrismaticX(
                show=show, axisRadius=axisRadius, axisLength=axisLength, color=color
            ),
        )
    )


def CreateSphericalJoint(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[Connected] = NO_PAIR,
    position: Vector = [],
    constrainedAxes: Sequence[int] = [1, 1, 1],
    useGlobalFrame: bool = True,
    show: bool = True,
    jointRadius: float = 0.1,
    color: Vector = DEFAULT_COLOR,
) -> ObjectIndex:
    """Add a ball joint between two bodies or markers and return its ObjectIndex.

    If one of them is a marker, it sets the position: then position must be [].
    """
    place = joint_place(mbs, "CreateSphericalJoint", bodyNumbers, position, useGlobalFrame)
    return mbs.AddObject(
        items.ObjectJointSpherical(
            name=name,
            markerNumbers=add_joint_markers(mbs, place, name, rigid=False),
            constrainedAxes=constrainedAxes,
            visualization=items.VObjectJointSpherical(show=show, jointRadius=jointRadius, color=color),
        )
    )


def CreateGenericJoint(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[Connected] = NO_PAIR,
    position: Vector = [],
    rotationMatrixAxes: Matrix = np.eye(3),
    constrainedAxes: Sequence[int] = [1, 1, 1, 1, 1, 1],
    useGlobalFrame: bool = True,
    offsetUserFunction: UserFunction = 0,
    offsetUserFunction_t: UserFunction = 0,
    show: bool = True,
    axesRadius: float = 0.1,
    axesLength: float = 0.4,
    color: Vector = DEFAULT_COLOR,
) -> ObjectIndex:
    """Add a joint with freely chosen constrained directions between two bodies or markers; return its ObjectIndex.

    Translations and rotations count along the joint axes, the columns of rotationMatrixAxes. If one of the bodies is a
    marker, it sets the position: then position must be [].
    """
    place = joint_place(mbs, "CreateGenericJoint", bodyNumbers, position, useGlobalFrame)
    axes = np.asarray(rotationMatrixAxes, dtype=float)
    rotation0, rotation1 = place.local_frames(axes if useGlobalFrame else place.rotations[0] @ axes)
    return mbs.AddObject(
        items.ObjectJointGeneric(
            name=name,
            markerNumbers=add_joint_markers(mbs, place, name),
            constrainedAxes=constrainedAxes,
            rotationMarker0=rotation0,
            rotationMarker1=rotation1,
            offsetUserFunction=offsetUserFunction,
            offsetUserFunction_t=offsetUserFunction_t,
            visualization=items.VObjectJointGeneric(
                show=show, axesRadius=axesRadius, axesLength=axesLength, color=color
            ),
        )
    )


def _add_generic(
    mbs: Any, name: str, place: JointPlace, axes: FloatArray, constrainedAxes: Sequence[int], view: dict[str, Any]
) -> ObjectIndex:
    """Add a generic joint with these axes, the columns of a matrix in the global frame."""
    rotation0, rotation1 = place.local_frames(axes)
    index: ObjectIndex = mbs.AddObject(
        items.ObjectJointGeneric(
            name=name,
            markerNumbers=add_joint_markers(mbs, place, name),
            constrainedAxes=constrainedAxes,
            rotationMarker0=rotation0,
            rotationMarker1=rotation1,
            visualization=items.VObjectJointGeneric(**view),
        )
    )
    return index


def CreateFixedJoint(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[Connected] = NO_PAIR,
    position: Vector | None = None,
    useGlobalFrame: bool = True,
    show: bool = True,
    axesRadius: float = 0.1,
    axesLength: float = 0.4,
    color: Vector = DEFAULT_COLOR,
) -> ObjectIndex:
    """Connect two bodies or markers rigidly, as they are in the reference configuration; return the ObjectIndex.

    The default of position is that of the second body. Bodies in the xy plane get the three equations of the plane.
    """
    if position is None or len(position) == 0:
        has_marker = any(isinstance(number, MarkerIndex) for number in bodyNumbers)
        require_items(mbs, "CreateFixedJoint", "bodyNumbers", [] if None in bodyNumbers else bodyNumbers)
        at_body = not has_marker and is_body(bodyNumbers[1])
        position, useGlobalFrame = (reference_position(mbs, bodyNumbers[1]) if at_body else []), True
    place = joint_place(mbs, "CreateFixedJoint", bodyNumbers, position, useGlobalFrame)
    constrained = [1, 1, 0, 0, 0, 1] if is_planar(mbs, place) else [1, 1, 1, 1, 1, 1]
    view = {"show": show, "axesRadius": axesRadius, "axesLength": axesLength, "color": color}
    return _add_generic(mbs, name, place, np.eye(3), constrained, view)


def CreateCylindricalJoint(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[Connected] = NO_PAIR,
    position: Vector = [],
    axis: Vector = [],
    useGlobalFrame: bool = True,
    show: bool = True,
    axesRadius: float = 0.1,
    axesLength: float = 0.4,
    color: Vector = DEFAULT_COLOR,
) -> ObjectIndex:
    """Let two bodies or markers move along an axis and rotate about it, and nothing else; return the ObjectIndex.

    If one of them is a marker, it sets the position: then position must be [].
    """
    require_axis("CreateCylindricalJoint", axis)
    place = joint_place(mbs, "CreateCylindricalJoint", bodyNumbers, position, useGlobalFrame)
    _require_space(mbs, "CreateCylindricalJoint", place)
    view = {"show": show, "axesRadius": axesRadius, "axesLength": axesLength, "color": color}
    axes = frame_with_z(place.to_global(axis, useGlobalFrame))
    return _add_generic(mbs, name, place, axes, [1, 1, 0, 1, 1, 0], view)


def CreateUniversalJoint(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[Connected] = NO_PAIR,
    position: Vector = [],
    axis0: Vector = [1, 0, 0],
    axis1: Vector = [0, 1, 0],
    useGlobalFrame: bool = True,
    show: bool = True,
    axesRadius: float = 0.1,
    axesLength: float = 0.4,
    color: Vector = DEFAULT_COLOR,
) -> ObjectIndex:
    """Connect two bodies or markers by the cross of a universal (Cardan) joint; return the ObjectIndex.

    axis0 is the pin of the cross in the first body, axis1 that in the second body; they are perpendicular. If one of
    the bodies is a marker, it sets the position: then position must be [].
    """
    for argument, pin in (("axis0", axis0), ("axis1", axis1)):
        if not any(pin):
            raise argument_error("CreateUniversalJoint", argument, "a vector with 3 components that is not zero", pin)
    place = joint_place(mbs, "CreateUniversalJoint", bodyNumbers, position, useGlobalFrame)
    _require_space(mbs, "CreateUniversalJoint", place)
    x, y = (pin / np.linalg.norm(pin) for pin in (place.to_global(each, useGlobalFrame) for each in (axis0, axis1)))
    if abs(x @ y) > 1e-8:
        raise argument_error("CreateUniversalJoint", "axis1", f"an axis perpendicular to axis0={list(axis0)}", axis1)
    view = {"show": show, "axesRadius": axesRadius, "axesLength": axesLength, "color": color}
    return _add_generic(mbs, name, place, np.column_stack([x, y, np.cross(x, y)]), [1, 1, 1, 0, 0, 1], view)


def _require_space(mbs: Any, function: str, place: JointPlace) -> None:
    if is_planar(mbs, place):
        expected = "bodies in space: bodies in the xy plane (create2D=True) have revolute, prismatic and fixed joints"
        raise argument_error(function, "bodyNumbers", expected, place.numbers)


def _rolling_markers(
    mbs: Any,
    function: str,
    name: str,
    bodyNumbers: Sequence[Any],
    planePosition: Vector,
    axisPosition: Vector,
    discRadius: float,
) -> list[Any]:
    """Add the rigid markers of a rolling disc: a marker on the body of the plane, and a marker on the disc."""
    require_two_bodies(function, bodyNumbers)
    for i, body in enumerate(bodyNumbers):
        if not is_body(body):
            raise argument_error(function, f"bodyNumbers[{i}]", "an ObjectIndex", body)
    if len(axisPosition) != 3:
        raise argument_error(function, "axisPosition", "a vector with 3 components", axisPosition)
    if discRadius <= 0:
        raise argument_error(function, "discRadius", "a finite number greater than zero", discRadius)
    return [
        mbs.AddMarker(items.MarkerBodyRigid(name=marker_name, bodyNumber=body, localPosition=local))
        for marker_name, body, local in zip(marker_names(name), bodyNumbers, (planePosition, axisPosition), strict=True)
    ]


_ROLLING_CHECKS = {"axisPosition": vector(3), "planePosition": vector(3)}


def CreateRollingDisc(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[Connected] = NO_PAIR,
    axisPosition: Vector = [],
    axisVector: Vector = [1, 0, 0],
    discRadius: float = 0.0,
    planePosition: Vector = [0, 0, 0],
    planeNormal: Vector = [0, 0, 1],
    constrainedAxes: Sequence[int] = [1, 1, 1],
    activeConnector: bool = True,
    show: bool = True,
    discWidth: float = 0.1,
    color: Vector = DEFAULT_COLOR,
) -> ObjectIndex:
    """Let a disc, fixed to the second body, roll without slip on a plane of the first body; return the ObjectIndex.

    Markers are added at the axis position and at the plane position; axis and normal are in the frames of the bodies.
    """
    markers = _rolling_markers(mbs, "CreateRollingDisc", name, bodyNumbers, planePosition, axisPosition, discRadius)
    return mbs.AddObject(
        items.ObjectJointRollingDisc(
            name=name,
            markerNumbers=markers,
            constrainedAxes=constrainedAxes,
            discRadius=discRadius,
            discAxis=axisVector,
            planeNormal=planeNormal,
            activeConnector=activeConnector,
            visualization=items.VObjectJointRollingDisc(show=show, discWidth=discWidth, color=color),
        )
    )


def CreateRollingDiscPenalty(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[Connected] = NO_PAIR,
    axisPosition: Vector = [],
    axisVector: Vector = [1, 0, 0],
    discRadius: float = 0.0,
    planePosition: Vector = [0, 0, 0],
    planeNormal: Vector = [0, 0, 1],
    contactStiffness: float = 0.0,
    contactDamping: float = 0.0,
    dryFriction: Vector = [0, 0],
    dryFrictionAngle: float = 0.0,
    dryFrictionProportionalZone: float = 0.0,
    viscousFriction: Vector = [0, 0],
    rollingFrictionViscous: float = 0.0,
    useLinearProportionalZone: bool = False,
    activeConnector: bool = True,
    show: bool = True,
    discWidth: float = 0.1,
    color: Vector = DEFAULT_COLOR,
) -> ObjectIndex:
    """Let a disc, fixed to the second body, roll with contact and friction forces on a plane of the first body.

    Frames as in CreateRollingDisc. Returns the ObjectIndex.
    """
    markers = _rolling_markers(
        mbs, "CreateRollingDiscPenalty", name, bodyNumbers, planePosition, axisPosition, discRadius
    )
    history = mbs.AddNode(items.NodeGenericData(initialCoordinates=[0, 0, 0], numberOfDataCoordinates=3))
    return mbs.AddObject(
        items.ObjectConnectorRollingDiscPenalty(
            name=name,
            markerNumbers=markers,
            nodeNumber=history,
            discRadius=discRadius,
            discAxis=axisVector,
            planeNormal=planeNormal,
            contactStiffness=contactStiffness,
            contactDamping=contactDamping,
            dryFriction=dryFriction,
            dryFrictionAngle=dryFrictionAngle,
            dryFrictionProportionalZone=dryFrictionProportionalZone,
            viscousFriction=viscousFriction,
            rollingFrictionViscous=rollingFrictionViscous,
            useLinearProportionalZone=useLinearProportionalZone,
            activeConnector=activeConnector,
            visualization=items.VObjectConnectorRollingDiscPenalty(show=show, discWidth=discWidth, color=color),
        )
    )


# Requirements on arguments besides those of the mirrored item and COMMON.
CHECKS: dict[str, dict[str, Check]] = {
    "CreateRevoluteJoint": {"axis": vector(3)},
    "CreatePrismaticJoint": {"axis": vector(3)},
    "CreateSphericalJoint": {"constrainedAxes": flags(3)},
    "CreateGenericJoint": {"rotationMatrixAxes": rotation_matrix(), "constrainedAxes": flags(6)},
    "CreateFixedJoint": {
        "position": Check(
            lambda value: value is None or np.shape(value) == (0,) or vector(3).test(value),
            "a vector with 3 finite components, or None",
        )
    },
    "CreateCylindricalJoint": {"axis": vector(3)},
    "CreateUniversalJoint": {"axis0": vector(3), "axis1": vector(3)},
    "CreateRollingDisc": {**_ROLLING_CHECKS, "constrainedAxes": flags(3)},
    "CreateRollingDiscPenalty": _ROLLING_CHECKS,
}
