"""Poses of items in the reference configuration, and the markers of connectors and joints on them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from dalembert import itemInterface as items
from dalembert._checks import FloatArray
from dalembert._core import (
    ConfigurationType,
    MarkerIndex,
    ModelError,
    NodeIndex,
    ObjectIndex,
    OutputVariableType,
    Print,
)
from dalembert.create._arguments import (
    ZERO3,
    Vector,
    argument_error,
    is_body,
    require_two_bodies,
    require_two_points,
)


def reference_output(mbs: Any, item: Any, variable: OutputVariableType, localPosition: Vector = ZERO3) -> FloatArray:
    """Return a position or rotation of a body (at a local position), node or marker in the reference configuration."""
    if isinstance(item, MarkerIndex):
        output = mbs.GetMarkerOutput(item, variable, configuration=ConfigurationType.Reference)
    elif isinstance(item, NodeIndex):
        output = mbs.GetNodeOutput(item, variable, configuration=ConfigurationType.Reference)
    else:
        output = mbs.GetObjectOutputBody(
            item, variable, localPosition=localPosition, configuration=ConfigurationType.Reference
        )
    return np.asarray(output, dtype=float)


def reference_position(mbs: Any, item: Any, localPosition: Vector = ZERO3) -> FloatArray:
    """Return the global reference position (m) of an item."""
    return reference_output(mbs, item, OutputVariableType.Position, localPosition)


def reference_rotation(mbs: Any, item: Any) -> FloatArray:
    """Return the 3x3 reference rotation matrix of an item, local to global."""
    return reference_output(mbs, item, OutputVariableType.RotationMatrix).reshape(3, 3)


# By the type of the index: the name of the kind, and the method of SystemData that returns its count.
_COUNTERS = {
    ObjectIndex: ("an object", "NumberOfObjects"),
    NodeIndex: ("a node", "NumberOfNodes"),
    MarkerIndex: ("a marker", "NumberOfMarkers"),
}


def require_items(mbs: Any, function: str, argument: str, numbers: Sequence[Any]) -> None:
    """Raise a ValueError with function and argument if an item does not exist; None is allowed."""
    for i, number in enumerate(numbers):
        if number is None:
            continue
        kind = next((each for each in _COUNTERS if isinstance(number, each)), ObjectIndex)
        noun, counter = _COUNTERS[kind]
        count = getattr(mbs.systemData, counter)()
        if not 0 <= int(number) < count:
            expected = f"{noun} of this MainSystem, which has {count}"
            raise argument_error(function, f"{argument}[{i}]", expected, number)


def marker_names(name: str) -> tuple[str, str]:
    """Return the names of the two markers of a connector; empty if the connector has no name."""
    return (f"Marker0:{name}", f"Marker1:{name}") if name else ("", "")


# ---- connectors: attached to bodies, nodes or markers ---------------------------------------------------------------


class Ends(NamedTuple):
    """The two items that a connector joins, with the local positions on them (bodies only)."""

    argument: str  # that names them
    numbers: list[Any]
    localPositions: list[Vector]


def connector_ends(
    function: str,
    bodyNumbers: Sequence[Any],
    localPosition0: Vector,
    localPosition1: Vector,
    bodyOrNodeList: Sequence[Any],
    bodyList: Sequence[Any],
) -> Ends:
    """Return the ends of a connector from one of the three arguments; the other two are [None, None].

    Bodies take a local position, nodes and markers must not have one. ValueError otherwise.
    """
    candidates = {"bodyNumbers": bodyNumbers, "bodyList": bodyList, "bodyOrNodeList": bodyOrNodeList}
    given = [name for name, pair in candidates.items() if any(entry is not None for entry in pair)]
    name = given[0] if given else "bodyNumbers"
    if len(given) > 1:
        raise argument_error(function, given[1], f"[None, None], as {name} is given", candidates[given[1]])
    if name == "bodyList":
        Print(f"WARNING: {function}: argument bodyList is deprecated, use bodyNumbers")

    numbers, localPositions = list(candidates[name]), [localPosition0, localPosition1]
    for i, (number, local) in enumerate(zip(numbers, localPositions, strict=True)):
        if is_body(number) or isinstance(number, str):
            continue
        if not isinstance(number, (NodeIndex, MarkerIndex)):
            raise argument_error(function, f"{name}[{i}]", "an ObjectIndex, a NodeIndex or a MarkerIndex", number)
        if np.any(np.asarray(local) != 0):
            expected = f"[0,0,0], because {name}[{i}] is the number of a node or marker"
            raise argument_error(function, f"localPosition{i}", expected, local)
    require_two_points(function, numbers, localPositions)
    return Ends(name, numbers, localPositions)


def add_end_marker(mbs: Any, number: Any, localPosition: Vector, name: str, rigid: bool) -> Any:
    """Add a position (or rigid) marker at a body or node and return its number; a marker is returned as it is."""
    if isinstance(number, MarkerIndex):
        return number
    if isinstance(number, NodeIndex):
        node_marker = items.MarkerNodeRigid if rigid else items.MarkerNodePosition
        return mbs.AddMarker(node_marker(name=name, nodeNumber=number))
    body_marker = items.MarkerBodyRigid if rigid else items.MarkerBodyPosition
    return mbs.AddMarker(body_marker(name=name, bodyNumber=number, localPosition=localPosition))


def add_end_markers(mbs: Any, ends: Ends, name: str, rigid: bool = False) -> list[Any]:
    """Add the markers of both ends of a connector and return their numbers."""
    return [
        add_end_marker(mbs, number, local, marker_name, rigid)
        for number, local, marker_name in zip(ends.numbers, ends.localPositions, marker_names(name), strict=True)
    ]


def end_distance(mbs: Any, function: str, ends: Ends) -> float:
    """Return the distance (m) of the two ends in the reference configuration; ValueError if one does not exist."""
    require_items(mbs, function, ends.argument, ends.numbers)
    p0, p1 = (reference_position(mbs, *end) for end in zip(ends.numbers, ends.localPositions, strict=True))
    return float(np.linalg.norm(p1 - p0))


# ---- joints: a point and axes that both bodies share ----------------------------------------------------------------


class JointPlace(NamedTuple):
    """Pose of a joint on its two bodies (or markers)."""

    numbers: list[Any]
    localPositions: list[FloatArray]  # position of the joint in the frame of each body
    rotations: list[FloatArray]  # rotations of the bodies, local to global

    def to_global(self, vector: Vector, useGlobalFrame: bool) -> FloatArray:
        """Return a direction in the global frame; it is given there or, if not useGlobalFrame, in body 0's frame."""
        direction = np.asarray(vector, dtype=float)
        return direction if useGlobalFrame else self.rotations[0] @ direction

    def local_frames(self, axes: FloatArray) -> list[FloatArray]:
        """Return the joint axes, columns given in the global frame, as rotation matrices in both bodies' frames."""
        return [rotation.T @ axes for rotation in self.rotations]


def joint_place(
    mbs: Any, function: str, bodyNumbers: Sequence[Any], position: Vector, useGlobalFrame: bool
) -> JointPlace:
    """Return the place of a joint between two bodies or markers.

    The position (m) is global or, if not useGlobalFrame, in the frame of body 0. A marker sets the position itself:
    `position` must then be empty. ValueError otherwise.
    """
    require_two_bodies(function, bodyNumbers)
    has_marker = False
    for i, number in enumerate(bodyNumbers):
        if isinstance(number, MarkerIndex):
            has_marker = True
        elif not is_body(number):
            raise argument_error(function, f"bodyNumbers[{i}]", "an ObjectIndex or a MarkerIndex", number)
    size = 0 if has_marker else 3
    if np.shape(position) != (size,):
        expected = "[], because a marker sets the position" if has_marker else "a vector with 3 components"
        raise argument_error(function, "position", expected, position)

    require_items(mbs, function, "bodyNumbers", bodyNumbers)
    positions, rotations = [], []
    for i, number in enumerate(bodyNumbers):
        try:
            positions.append(reference_position(mbs, number))
            rotations.append(reference_rotation(mbs, number))
        except ModelError as error:
            name = mbs.GetMarker(number)["name"] if isinstance(number, MarkerIndex) else mbs.GetObject(number)["name"]
            raise argument_error(
                function, f"bodyNumbers[{i}]", "a body or marker with position and orientation", name
            ) from error
    if has_marker:
        point = next(p for p, n in zip(positions, bodyNumbers, strict=True) if isinstance(n, MarkerIndex))
    else:
        point = np.asarray(position, dtype=float)
        if not useGlobalFrame:
            point = positions[0] + rotations[0] @ point
    local = [rotation.T @ (point - p) for rotation, p in zip(rotations, positions, strict=True)]
    return JointPlace(list(bodyNumbers), local, rotations)


def _moves_in_plane(mbs: Any, body: Any) -> bool | None:
    """Whether a body moves in the xy plane; None: it rests, as ground does, or is not known."""
    if isinstance(body, MarkerIndex):
        return None
    item = mbs.GetObject(body)
    if item["objectType"] == "Ground" or "nodeNumber" not in item:
        return None
    return "2D" in str(mbs.GetNode(item["nodeNumber"])["nodeType"])


def is_planar(mbs: Any, place: JointPlace) -> bool:
    """Return whether a joint is between two bodies in the xy plane, or between one and the ground."""
    if any(isinstance(number, MarkerIndex) for number in place.numbers):
        return False
    planar = [_moves_in_plane(mbs, number) for number in place.numbers]
    return any(planar) and False not in planar


def require_axis_of_plane(mbs: Any, function: str, place: JointPlace, axis: FloatArray, normal: bool) -> None:
    """Raise the ValueError for an axis about or along which bodies in the xy plane cannot move.

    Nothing is required if one of the bodies moves in space.
    """
    planar = [_moves_in_plane(mbs, number) for number in place.numbers]
    if not any(planar) or False in planar:
        return
    off = np.linalg.norm(axis[:2]) if normal else abs(axis[2])
    if off <= 1e-8 * np.linalg.norm(axis):
        return
    body = place.numbers[planar.index(True)]
    motion = "turns about z only: [0, 0, 1]" if normal else "moves in x and y only: [x, y, 0]"
    raise argument_error(
        function, "axis", f"an axis of the plane, because body {body!r} (create2D=True) {motion}", axis.tolist()
    )


def require_axis_of_joint(mbs: Any, function: str, bodies: Sequence[Any], axis: FloatArray, is_rotation: bool) -> None:
    """Raise the ValueError for a rotation or translation that a joint between two bodies does not allow.

    Joints are revolute, prismatic and fixed ones. The axis is given in the global frame. Joints that are switched off
    allow any motion. Points of bodies on a hinge may also be driven in other directions.
    """
    wanted = {int(number) for number in bodies if not isinstance(number, MarkerIndex)}
    if len(wanted) != 2:
        return
    for number in mbs._ConstraintsBetween(list(wanted)):
        joint = mbs.GetObject(number)
        kind = joint["objectType"]
        if kind not in ("JointRevoluteZ", "JointPrismaticX", "JointGeneric") or not joint["activeConnector"]:
            continue
        text = f"joint {number} '{joint['name']}' between these bodies"
        if kind == "JointGeneric":
            if all(joint["constrainedAxes"]) and not joint["offsetUserFunction"]:
                expected = f"bodies that can move, which the fixed {text} does not allow"
                raise argument_error(function, "bodyNumbers", expected, bodies)
            continue
        if kind == "JointPrismaticX" and is_rotation:
            expected = f"bodies that can turn, which the prismatic {text} does not allow"
            raise argument_error(function, "bodyNumbers", expected, bodies)
        body = mbs.GetMarker(joint["markerNumbers"][0])["bodyNumber"]
        frame = reference_rotation(mbs, body) @ joint["rotationMarker0"]
        along = frame[:, 0 if kind == "JointPrismaticX" else 2]
        expected = f"the axis {along.round(6) + 0.0} (global frame) of {text}"  # + 0.0: no negative zeros
        if is_rotation and np.linalg.norm(np.cross(along, axis)) > 1e-6 * np.linalg.norm(axis):
            raise argument_error(function, "axis", expected, axis.tolist())
        if kind == "JointPrismaticX" and abs(along @ axis) < 1e-6 * np.linalg.norm(axis):
            raise argument_error(function, "axis", expected, axis.tolist())


def add_joint_markers(mbs: Any, place: JointPlace, name: str, rigid: bool = True) -> list[Any]:
    """Add the markers of a joint on both bodies and return their numbers; markers are returned as they are."""
    return [
        add_end_marker(mbs, number, local, marker_name, rigid)
        for number, local, marker_name in zip(place.numbers, place.localPositions, marker_names(name), strict=True)
    ]
