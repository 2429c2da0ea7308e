"""Create functions of ropes and belts over pulleys."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import Any

import numpy as np

from dalembert import itemInterface as items
from dalembert._checks import FloatArray
from dalembert._core import MainSystem, ObjectIndex, OutputVariableType, SystemContainer, Vector3DList
from dalembert.create._arguments import (
    DEFAULT_COLOR,
    FLAG,
    NOT_NEGATIVE,
    POSITIVE,
    Check,
    Vector,
    argument_error,
    require_axis,
    vector,
    with_indices,
)
from dalembert.create._arguments import color as color_check
from dalembert.create._frames import reference_position, reference_rotation, require_items

_SLANTED = 30.0  # degrees between a rope and the plane of its pulley; fleet angles of winches are 4 at most


def _points(function: str, positions: Sequence[Vector], count: int) -> FloatArray:
    """Return the positions as a matrix with a row for each of the bodies; ValueError otherwise."""
    try:
        points = np.array([*positions], dtype=float)
    except ValueError:
        points = np.zeros(0)
    if points.shape != (count, 3) or not np.isfinite(points).all():
        raise argument_error(function, "positions", f"a point for each of the {count} bodies", positions)
    return points


def _require_tangents(function: str, points: FloatArray, radii: FloatArray, pairs: Sequence[tuple[int, int]]) -> None:
    """Raise a ValueError if the pulleys of a pair have no common tangent; radii have the sign of the rotation."""
    for i, j in pairs:
        needed = abs(radii[i] - radii[j])
        if np.linalg.norm(points[j] - points[i]) <= needed:
            expected = f"points {i} and {j} more than {needed:g} m apart, so that the rope runs from one to the other"
            raise argument_error(function, "positions", expected, points[[i, j]].tolist())


def _warn_of_slanted_lines(function: str, points: FloatArray, radii: FloatArray, axis: Vector) -> None:
    """Warn if a rope runs far out of the planes of its pulleys, as it does with an axis of another direction."""
    unit = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    lines = np.diff(points, axis=0)
    slant = np.degrees(np.arcsin(np.abs(lines @ unit) / np.linalg.norm(lines, axis=1)))
    for i in range(1, len(points) - 1):
        side = i - 1 if slant[i - 1] > slant[i] else i
        if radii[i] != 0 and slant[side] > _SLANTED:
            text = (
                f"{function}: axis: the line from point {side} to point {side + 1} is inclined by {slant[side]:.0f} "
                f"degrees to the plane of pulley {i}. The axis should be normal to the rope"
            )
            warnings.warn(text, stacklevel=4)
            return


def _distance(points: FloatArray, parameters: dict[str, Any]) -> float:
    """Return the length of a rope over pulleys at these centers."""
    mbs = SystemContainer().AddSystem()
    ground = mbs.AddObject(items.ObjectGround())
    markers = [mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=ground, localPosition=point)) for point in points]
    rope = mbs.AddObject(items.ObjectConnectorReevingSystemSprings(markerNumbers=markers, **parameters))
    mbs.Assemble()
    return float(mbs.GetObjectOutput(rope, OutputVariableType.Distance))


def _add_marker(mbs: Any, name: str, body: Any, point: FloatArray) -> Any:
    """Add a rigid marker at a point, given in the global frame of the reference configuration."""
    local = reference_rotation(mbs, body).T @ (point - reference_position(mbs, body))
    return mbs.AddMarker(items.MarkerBodyRigid(name=name, bodyNumber=body, localPosition=local))


def _axes(
    mbs: Any, axis: Vector, radii: FloatArray, bodies: Sequence[Any]
) -> tuple[list[FloatArray], list[FloatArray]]:
    """Return the unit axes of pulleys in the global frame, opposite for negative radii, and those in their bodies."""
    unit = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    axes = [-unit if radius < 0 else unit for radius in radii]
    return axes, [reference_rotation(mbs, body).T @ each for body, each in zip(bodies, axes, strict=True)]


def CreateRope(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[ObjectIndex | int | str] = (),
    positions: Sequence[Vector] = (),
    radii: Vector = (),
    axis: Vector = (0.0, 0.0, 1.0),
    stiffness: float = 1e6,
    damping: float = 0.0,
    length: float | None = None,
    diameter: float = 0.01,
    show: bool = True,
    color: Vector = DEFAULT_COLOR,
) -> ObjectIndex:
    """Add a massless elastic rope between points of two bodies, which runs without friction over pulleys between them.

    The first and the last of bodyNumbers and positions are the ends; those between are pulleys with their centers.
    Along the rope, it turns about the axis at pulleys of positive radius, and about the opposite one at negative radii;
    0: a ring. It carries no compression. Its force is ForceLocal, its length Distance. Returns the ObjectIndex.
    """
    function, count = "CreateRope", len(bodyNumbers)
    points = _points(function, positions, count)
    if np.shape(radii) != (count - 2,) or not np.isfinite(radii).all():
        expected = f"a radius for each of the {count - 2} pulleys between the ends"
        raise argument_error(function, "radii", expected, list(radii))
    require_axis(function, axis)
    require_items(mbs, function, "bodyNumbers", bodyNumbers)
    turns = np.array([0.0, *radii, 0.0])
    _require_tangents(function, points, turns, [(i, i + 1) for i in range(count - 1)])
    _warn_of_slanted_lines(function, points, turns, axis)
    axes, local_axes = _axes(mbs, axis, turns, bodyNumbers)
    common = {"sheavesRadii": np.abs(turns), "stiffnessPerLength": stiffness}
    if length is None:
        length = _distance(points, {**common, "sheavesAxes": Vector3DList(axes), "referenceLength": 1.0})
    markers = [
        _add_marker(mbs, f"Marker{i}:{name}" if name else "", body, point)
        for i, (body, point) in enumerate(zip(bodyNumbers, points, strict=True))
    ]
    return mbs.AddObject(
        items.ObjectConnectorReevingSystemSprings(
            name=name,
            markerNumbers=markers,
            dampingPerLength=damping,
            referenceLength=length,
            sheavesAxes=Vector3DList(local_axes),
            visualization=items.VObjectConnectorReevingSystemSprings(show=show, ropeRadius=diameter / 2, color=color),
            **common,
        )
    )


def _require_axes_of_joints(
    mbs: Any, function: str, carrier: Any, pulleys: Sequence[Any], points: FloatArray, axis: FloatArray
) -> None:
    """Raise a ValueError if a revolute joint between a pulley and the carrier has another axis than the belt."""
    of_marker = {
        number: (int(marker["bodyNumber"]), marker["localPosition"])
        for number in range(mbs.systemData.NumberOfMarkers())
        if (marker := mbs.GetMarker(number))["markerType"] == "BodyRigid"
    }
    places = {int(pulley): i for i, pulley in enumerate(pulleys)}
    for number in range(mbs.systemData.NumberOfObjects()):
        joint = mbs.GetObject(number)
        if joint["objectType"] != "JointRevoluteZ":
            continue
        markers = [int(marker) for marker in joint["markerNumbers"]]
        bodies = [of_marker[marker][0] for marker in markers if marker in of_marker]
        ends = [end for end, body in enumerate(bodies) if body in places]
        if len(bodies) != 2 or int(carrier) not in bodies or not ends:
            continue
        i, frame = places[bodies[ends[0]]], joint[f"rotationMarker{ends[0]}"]
        body, local = of_marker[markers[ends[0]]]
        turned = reference_rotation(mbs, body)
        along = turned @ frame[:, 2]
        apart = reference_position(mbs, body) + turned @ local - points[i]
        if np.linalg.norm(np.cross(along, axis)) > 1e-6:
            raise argument_error(function, "axis", f"the axis of joint {number} of pulley {i}, {along.round(6)}", axis)
        if np.linalg.norm(np.cross(axis, apart)) > 1e-6 * np.ptp(points, axis=0).max():
            expected = f"a point on the axis of joint {number}"
            raise argument_error(function, f"positions[{i}]", expected, points[i].tolist())


def CreateBelt(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[ObjectIndex | int | str] = (),
    positions: Sequence[Vector] = (),
    radii: Vector = (),
    axis: Vector = (0.0, 0.0, 1.0),
    carrierNumber: ObjectIndex | int | str = "ground",
    stiffness: float = 1e6,
    damping: float = 0.0,
    pretension: float = 0.0,
    diameter: float = 0.01,
    show: bool = True,
    color: Vector = DEFAULT_COLOR,
) -> list[ObjectIndex]:
    """Add a massless elastic belt that runs around pulleys without slip, as a toothed belt or a chain does.

    The bodies are pulleys, in their order along the belt, which comes back to the first one. Revolute joints hold them
    on one carrier, which may move: the ground or a frame. The belt acts on the pulleys where it touches them, so that
    the forces of these joints contain its pull.

    Along the belt, it turns about the axis at pulleys of positive radius, and about the opposite one at negative radii,
    as in a crossed belt or at idlers outside. Each span between two pulleys has a tension of its own: the pretension at
    the start, never compression. Returns the list of spans, ObjectIndex, span i from pulley i to the next one: their
    tension is ForceLocal, their length Distance.
    """
    function, count = "CreateBelt", len(bodyNumbers)
    points = _points(function, positions, count)
    if np.shape(radii) != (count,) or not np.isfinite(radii).all() or not np.all(radii):
        raise argument_error(function, "radii", f"a radius other than 0 for each of the {count} pulleys", list(radii))
    require_axis(function, axis)
    require_items(mbs, function, "bodyNumbers", bodyNumbers)
    carrier = with_indices(mbs, function, "carrierNumber", carrierNumber)  # the default is a name
    require_items(mbs, function, "carrierNumber", [carrier])
    if len({int(each) for each in (*bodyNumbers, carrier)}) != count + 1:
        raise argument_error(function, "bodyNumbers", "different pulleys, without the carrier", bodyNumbers)
    turns, spans = np.array(radii, dtype=float), [(i, (i + 1) % count) for i in range(count)]
    unit = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    _require_tangents(function, points, turns, spans)
    area = sum(unit @ np.cross(points[i] - points[0], points[j] - points[0]) for i, j in spans)
    if (turns > 0).all() and area < 0 or (turns < 0).all() and area > 0:
        expected = "pulleys in the order in which the belt turns about the axis; opposite radii reverse it"
        raise argument_error(function, "bodyNumbers", expected, bodyNumbers)
    _require_axes_of_joints(mbs, function, carrier, bodyNumbers, points, unit)
    axes, local_axes = _axes(mbs, axis, turns, bodyNumbers)
    _, carrier_axes = _axes(mbs, axis, turns, [carrier] * count)
    centers, angles = [], []
    for i, pulley in enumerate(bodyNumbers):
        label = f"Marker{i}:{name}" if name else ""
        centers.append(_add_marker(mbs, label, pulley, points[i]))
        turned = mbs.AddNode(items.NodeGenericData(numberOfDataCoordinates=1, initialCoordinates=[0]))
        angles.append(
            mbs.AddMarker(
                items.MarkerBodiesRelativeRotationCoordinate(
                    name=f"{label}:angle" if name else "",
                    bodyNumbers=[carrier, pulley],
                    nodeNumber=turned,
                    axis0=carrier_axes[i],
                )
            )
        )
    strands = []
    for i, j in spans:
        common = {"sheavesRadii": np.abs(turns[[i, j]]), "stiffnessPerLength": stiffness}
        distance = _distance(points[[i, j]], {**common, "sheavesAxes": Vector3DList([axes[i], axes[j]])})
        strands.append(
            mbs.AddObject(
                items.ObjectConnectorReevingSystemSprings(
                    name=f"{name}:{i}" if name else "",
                    markerNumbers=[centers[i], centers[j], angles[i], angles[j]],
                    hasCoordinateMarkers=True,
                    turningEnds=True,
                    # pulley i feeds the belt into the span, pulley j takes it out
                    coordinateFactors=[abs(turns[i]), -abs(turns[j])],
                    dampingPerLength=damping,
                    referenceLength=distance / (1 + pretension / stiffness),
                    sheavesAxes=Vector3DList([local_axes[i], local_axes[j]]),
                    visualization=items.VObjectConnectorReevingSystemSprings(
                        show=show, ropeRadius=diameter / 2, color=color
                    ),
                    **common,
                )
            )
        )
    return strands


_COMMON_TEXTS = {
    "axis": "axis of all pulleys, in the global frame; the body of a pulley carries it along",
    "stiffness": "EA (N)",
    "damping": "force per rate of strain (Ns)",
    "diameter": "diameter of the drawing (m)",
}
TEXTS = {
    "CreateRope": {
        **_COMMON_TEXTS,
        "bodyNumbers": "bodies that carry the ends and the pulleys, along the rope",
        "positions": "ends and centers of pulleys at the reference configuration, in the global frame (m)",
        "radii": "radii of the pulleys (m), without the ends; negative: the rope turns about the opposite axis",
        "length": "length without force (m); None: that of the reference configuration",
    },
    "CreateBelt": {
        **_COMMON_TEXTS,
        "bodyNumbers": "pulleys, along the belt",
        "positions": "centers of the pulleys at the reference configuration, in the global frame (m)",
        "radii": "radii of the pulleys (m); negative: the belt turns about the opposite axis",
        "axis": "axis of all pulleys, in the global frame; that of the joints that hold them",
        "carrierNumber": "body that carries the bearings of all pulleys",
        "pretension": "tension of all spans in the reference configuration (N)",
    },
}
_COMMON_CHECKS: dict[str, Check] = {
    "axis": vector(3),
    "stiffness": POSITIVE,
    "damping": NOT_NEGATIVE,
    "diameter": POSITIVE,
    "show": FLAG,
    "color": color_check(),
}


_BODIES = Check(
    lambda value: isinstance(value, (list, tuple)) and len(value) >= 2, "a list of at least two body numbers"
)
# Requirements on arguments besides those of the mirrored item and COMMON.
CHECKS: dict[str, dict[str, Check]] = {
    "CreateRope": {**_COMMON_CHECKS, "bodyNumbers": _BODIES, "length": POSITIVE.optional()},
    "CreateBelt": {
        **_COMMON_CHECKS,
        "bodyNumbers": _BODIES,
        "pretension": NOT_NEGATIVE,
    },
}
