"""Create functions of sensors that measure the distance to contact geometry along a line, and of such geometry."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert import itemInterface as items
from dalembert._checks import FloatArray
from dalembert._core import ConfigurationType, ContactTypeIndex, MarkerIndex, OutputVariableType
from dalembert._tools.found_items import index_of
from dalembert.create._arguments import (
    FLAG,
    NOT_NEGATIVE,
    NUMBER,
    Check,
    argument_error,
    color,
    refined,
    vector,
)

RED = [1.0, 0.0, 0.0, 1.0]


def _is_table(value: Any, whole: bool) -> bool:
    """Return whether the value has rows of three finite, or whole and not negative, numbers."""
    try:
        array = np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        return False
    rows = array.ndim == 2 and array.shape[1] == 3 and len(array) > 0 and bool(np.isfinite(array).all())
    return rows and (not whole or bool(((array >= 0) & (array == np.floor(array))).all()))


def _is_position_or_marker(value: Any) -> bool:
    return isinstance(value, (str, MarkerIndex)) or vector(3).test(value)


_NUMBER_OF_CONTACT = Check(
    lambda value: isinstance(value, (int, np.integer)) and not isinstance(value, bool),
    "the number of a GeneralContact",
    lambda value: "mbs.CreateDistanceSensorGeometry(...) returns one.",
)
_CELLS = refined(
    vector(3), "three whole numbers greater than zero", lambda cells: "" if _are_cells(cells) else "One is not."
)
_DIRECTION = refined(
    vector(3), "a vector with 3 finite components that is not zero", lambda value: "" if value.any() else "It is zero."
)


def _are_cells(cells: FloatArray) -> bool:
    return bool(((cells > 0) & (cells == np.floor(cells))).all())


CHECKS: dict[str, dict[str, Check]] = {
    "CreateDistanceSensorGeometry": {
        "meshPoints": Check(lambda value: _is_table(value, False), "a list of points with 3 finite coordinates each"),
        "meshTrigs": Check(lambda value: _is_table(value, True), "a list of triangles, with 3 indices of points each"),
        "searchTreeCellSize": _CELLS,
    },
    "CreateDistanceSensor": {
        "generalContactIndex": _NUMBER_OF_CONTACT,
        "positionOrMarker": Check(_is_position_or_marker, "a MarkerIndex, the name of a marker, or a point [x, y, z]"),
        "dirSensor": _DIRECTION,
        "minDistance": NUMBER,
        "maxDistance": NUMBER,
        "cylinderRadius": NOT_NEGATIVE,
        "selectedTypeIndex": Check(
            lambda value: isinstance(value, ContactTypeIndex),
            "a member of ContactTypeIndex",
            lambda value: "Write exu.ContactTypeIndex.IndexTrigsRigidBodyBased, for instance.",
        ),
        "measureVelocity": FLAG,
        "addGraphicsObject": FLAG,
        "drawDisplaced": FLAG,
        "color": color(),
    },
}
TEXTS = {
    "CreateDistanceSensorGeometry": {
        "meshPoints": "corners of triangles in the frame of the marker (m), such as those of a mesh of graphics",
        "meshTrigs": "three indices of points per triangle; a ray sees both sides",
        "rigidBodyMarkerIndex": "rigid marker that carries the triangles, by its index or name",
        "searchTreeCellSize": "without effect, as the search finds its cells by itself",
    },
    "CreateDistanceSensor": {
        "generalContactIndex": "contact whose geometry is seen, such as CreateDistanceSensorGeometry returns",
        "positionOrMarker": "start of the ray: a point in the global frame (m), or a marker by its index or name",
        "dirSensor": "direction of the ray, of any length, in the frame of a rigid marker or else in the global frame",
        "minDistance": "least distance that counts (m); below zero, the ray looks backwards too",
        "maxDistance": "greatest distance (m), which is the value where nothing is seen",
        "cylinderRadius": "radius of the ray (m); one above zero sees spheres alone, as selectedTypeIndex has to say",
        "selectedTypeIndex": "kind of contact partners that are seen; IndexEndOfEnumList stands for all",
        "measureVelocity": "True: the velocity of the surface, along the ray (m/s), is the second value",
        "addGraphicsObject": "True: a ground object shows the ray",
        "drawDisplaced": "True: the ray is drawn at its end, where something is seen",
        "color": "RGBA color of the drawn ray",
    },
}


def CreateDistanceSensorGeometry(
    mbs: Any,
    meshPoints: npt.ArrayLike,
    meshTrigs: npt.ArrayLike,
    rigidBodyMarkerIndex: Any,
    searchTreeCellSize: list[int] = [8, 8, 8],
) -> int:
    """Add triangles on a rigid marker as geometry for distance sensors; return the number of the GeneralContact.

    Rays see both sides of triangles; no contact forces arise.
    """
    where, points, triangles = "CreateDistanceSensorGeometry", np.asarray(meshPoints, float), np.asarray(meshTrigs)
    marker = index_of(mbs, "Marker", rigidBodyMarkerIndex, f"MainSystem.{where}(...): argument 'rigidBodyMarkerIndex'")
    if "Rigid" not in (kind := mbs.GetMarker(marker)["markerType"]):
        expected = "a marker with an orientation, such as MarkerBodyRigid"
        raise argument_error(where, "rigidBodyMarkerIndex", expected, f"{marker!r}, a Marker{kind}")
    if triangles.max() >= len(points):
        expected = f"indices of the {len(points)} points of meshPoints, from 0 to {len(points) - 1}"
        raise argument_error(where, "meshTrigs", expected, int(triangles.max()))
    contact, number = mbs.AddGeneralContact(), int(mbs.NumberOfGeneralContacts()) - 1
    try:
        contact.SetFrictionPairings(np.zeros((1, 1)))
        contact.SetSearchTreeCellSize(numberOfCells=searchTreeCellSize)
        contact.AddTrianglesRigidBodyBased(
            rigidBodyMarkerIndex=marker,
            contactStiffness=1,
            contactDamping=1,
            frictionMaterialIndex=0,
            pointList=points,
            triangleList=triangles,
        )
    except BaseException:  # a triangle without area, for instance
        mbs.DeleteGeneralContact(number)
        raise
    contact.isActive = False
    return number


def _measure(mbs: Any, t: float, sensorNumbers: list[Any], factors: FloatArray, configuration: Any) -> list[float]:
    """Sensor user function: return [distance] or [distance, velocity along the line]; factors as packed below."""
    contactNumber, marker = int(factors[0]), int(factors[1])
    start, direction = np.array(factors[2:5]), np.array(factors[5:8])
    minimum, maximum, cylinderRadius = factors[8:11]
    typeIndex, withVelocity, graphicsObject, drawDisplaced = (int(value) for value in factors[11:15])
    rotation = None
    if marker != -1:
        start = np.asarray(mbs.GetMarkerOutput(marker, variableType=OutputVariableType.Position))
        if "Rigid" in mbs.GetMarker(marker)["markerType"]:
            output = mbs.GetMarkerOutput(marker, variableType=OutputVariableType.RotationMatrix)
            rotation = np.asarray(output).reshape(3, 3)
            direction = rotation @ direction
    data = mbs.GetGeneralContact(contactNumber).ShortestDistanceAlongLine(
        pStart=start,
        direction=direction,
        minDistance=minimum,
        maxDistance=maximum,
        cylinderRadius=cylinderRadius,
        asDictionary=bool(withVelocity),
        typeIndex=ContactTypeIndex(typeIndex),
    )
    values = [data["distance"], data["velocityAlongLine"]] if withVelocity else [data]
    if graphicsObject != -1:
        along = values[0] * direction / np.linalg.norm(direction) if drawDisplaced else np.zeros(3)
        mbs.SetObjectParameter(graphicsObject, "referencePosition", start + along)
        if rotation is not None:
            mbs.SetObjectParameter(graphicsObject, "referenceRotation", rotation)
    return values


def CreateDistanceSensor(
    mbs: Any,
    generalContactIndex: int,
    positionOrMarker: Any,
    dirSensor: Any,
    minDistance: float = -1e7,
    maxDistance: float = 1e7,
    cylinderRadius: float = 0,
    selectedTypeIndex: Any = ContactTypeIndex.IndexEndOfEnumList,
    storeInternal: bool = False,
    fileName: str = "",
    measureVelocity: bool = False,
    addGraphicsObject: bool = False,
    drawDisplaced: bool = True,
    color: list[float] = RED,
) -> Any:
    """Add a sensor for the distance (m) from a point along a direction to contact geometry; return its SensorIndex.

    A marker moves the start of the ray, and a rigid marker turns its direction too. The value is maxDistance where
    nothing is seen.
    """
    _require_seen(mbs, generalContactIndex, selectedTypeIndex, cylinderRadius)
    if not minDistance < maxDistance:
        raise argument_error(_SENSOR, "minDistance", f"less than maxDistance, which is {maxDistance}", minDistance)
    marker, start = _start(mbs, positionOrMarker)
    direction = [float(x) for x in dirSensor]
    ray = _drawn_ray(mbs, start, direction, cylinderRadius, drawDisplaced, color) if addGraphicsObject else -1
    limits = [minDistance, maxDistance, cylinderRadius]
    options = [int(selectedTypeIndex), measureVelocity, ray, drawDisplaced]
    factors = [float(x) for x in (generalContactIndex, marker, *start, *direction, *limits, *options)]
    return mbs.AddSensor(
        items.SensorUserFunction(
            sensorNumbers=[],
            factors=factors,
            storeInternal=storeInternal,
            fileName=fileName,
            sensorUserFunction=_measure,
        )
    )


_SENSOR = "CreateDistanceSensor"


def _require_seen(mbs: Any, number: int, kind: ContactTypeIndex, radius: float) -> None:
    """Raise a ValueError if there is no such contact, or nothing in it that such a ray sees."""
    count = int(mbs.NumberOfGeneralContacts())
    if not 0 <= number < count:
        expected = f"the number of a GeneralContact, of which this system has {count}"
        advice = "" if count else ". Make one by mbs.CreateDistanceSensorGeometry(...) or mbs.AddGeneralContact()"
        raise argument_error(_SENSOR, "generalContactIndex", expected + advice, number)
    if radius == 0:
        return
    if kind != ContactTypeIndex.IndexSpheresMarkerBased:
        expected = "0, or selectedTypeIndex=exu.ContactTypeIndex.IndexSpheresMarkerBased, as it sees spheres alone"
        raise argument_error(_SENSOR, "cylinderRadius", expected, radius)
    contact = mbs.GetGeneralContact(number).GetPythonObject()
    if contact["numberOfSpheresMarkerBased"] == 0 and contact["numberOfTrigsRigidBodyBased"] > 0:
        expected = f"0, as it sees spheres alone, and GeneralContact {number} has triangles and no spheres"
        raise argument_error(_SENSOR, "cylinderRadius", expected, radius)


def _start(mbs: Any, positionOrMarker: Any) -> tuple[int, list[float]]:
    """Return the number of the marker, or -1, and where the ray starts."""
    if not isinstance(positionOrMarker, (str, MarkerIndex)):
        return -1, [float(x) for x in positionOrMarker]
    marker = index_of(mbs, "Marker", positionOrMarker, f"MainSystem.{_SENSOR}(...): argument 'positionOrMarker'")
    kind = mbs.GetMarker(marker)["markerType"]
    if "Position" not in kind and "Rigid" not in kind:
        expected = "a marker with a position, such as MarkerBodyRigid"
        raise argument_error(_SENSOR, "positionOrMarker", expected, f"{marker!r}, a Marker{kind}")
    try:
        position = mbs.GetMarkerOutput(marker, OutputVariableType.Position, ConfigurationType.Reference)
    except (RuntimeError, ValueError):  # markers that know their position after Assemble() only
        position = np.zeros(3)
    return int(marker), [float(x) for x in position]


def _drawn_ray(
    mbs: Any, start: list[float], direction: list[float], radius: float, atEnd: bool, color: list[float]
) -> int:
    """Add a ground object that shows the ray, and return its number."""
    from dalembert import graphics

    ray = (-1.0 if atEnd else 1.0) * np.array(direction)
    if radius == 0:
        shape = graphics.Lines([[0, 0, 0], list(ray)], color=color)
    else:
        shape = graphics.Cylinder([0, 0, 0], ray, radius=radius, color=color)
    view = items.VObjectGround(graphicsData=[shape])
    return int(mbs.AddObject(items.ObjectGround(referencePosition=start, visualization=view)))
