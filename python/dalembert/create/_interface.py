"""Building blocks of Create functions, for users who write their own Create functions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._core import JointType, MarkerIndex
from dalembert.create._arguments import NO_PAIR, Vector, with_indices
from dalembert.create._frames import (
    Ends,
    add_end_markers,
    connector_ends,
    joint_place,
    reference_position,
    reference_rotation,
)


def JointTypeToAxis(jointType: JointType) -> FloatArray:
    """Return the unit vector along which or about which a joint moves; ValueError if it has no single axis."""
    axis = "XYZ".find(jointType.name[-1])
    if axis < 0 or not jointType.name.startswith(("Revolute", "Prismatic")):
        raise ValueError(f"JointTypeToAxis: jointType: expected a revolute or prismatic joint, received {jointType}")
    return np.eye(3)[axis]


def JointPreCheckCalcBodyMarkers(
    where: str,
    mbs: Any,
    name: str,
    bodyNumbers: Sequence[Any],
    position: Vector,
    show: bool,
    useGlobalFrame: bool,
    requireRotMat: bool = True,
) -> list[Any]:
    """Return [p0, A0, p1, A1, marker0, marker1, position] of a joint between two bodies or markers.

    p and A are position (m) and rotation matrix of both in the reference configuration, markers are None for bodies,
    and the position is global; given in the frame of body 0 if not useGlobalFrame. ValueError names `where`.
    """
    bodyNumbers = with_indices(mbs, where, "bodyNumbers", bodyNumbers)
    place = joint_place(mbs, where, bodyNumbers, position, useGlobalFrame)
    positions = [reference_position(mbs, number) for number in bodyNumbers]
    markers = [number if isinstance(number, MarkerIndex) else None for number in bodyNumbers]
    point = positions[0] + place.rotations[0] @ place.localPositions[0]
    return [positions[0], place.rotations[0], positions[1], place.rotations[1], *markers, point]


def ProcessBodyNodeMarkerLists(
    bodyNumbers: Sequence[Any],
    bodyOrNodeList: Sequence[Any],
    localPosition0: Vector,
    localPosition1: Vector,
    where: str,
    bodyList: Sequence[Any] = NO_PAIR,
) -> list[Any]:
    """Return the numbers of the two bodies, nodes or markers that a connector joins, from the argument that has them.

    Nodes and markers have no local positions. ValueError names `where` and the argument.
    """
    return connector_ends(where, bodyNumbers, localPosition0, localPosition1, bodyOrNodeList, bodyList).numbers


def GetMarkersPosRot(
    mbs: Any,
    name: str,
    internBodyNodeMarkerList: Sequence[Any],
    localPosition0: Vector,
    localPosition1: Vector,
    getPosition: bool = False,
    getRotationMatrix: bool = False,
    useRigidMarker: bool = False,
) -> list[Any]:
    """Add markers at two bodies or nodes; return [marker0, marker1, p0, p1, A0, A1].

    Given markers are used directly. Positions (m) and rotation matrices in the reference configuration
    are None unless asked for.
    """
    numbers = list(with_indices(mbs, "GetMarkersPosRot", "internBodyNodeMarkerList", internBodyNodeMarkerList))
    local = [localPosition0, localPosition1]
    positions = [reference_position(mbs, *end) if getPosition else None for end in zip(numbers, local, strict=True)]
    rotations = [reference_rotation(mbs, number) if getRotationMatrix else None for number in numbers]
    markers = add_end_markers(mbs, Ends("internBodyNodeMarkerList", numbers, local), name, useRigidMarker)
    return [*markers, *positions, *rotations]
