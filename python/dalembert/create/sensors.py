"""Create functions of sensors that measure the distance to contact geometry along a line, and of such geometry."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert import itemInterface as items
from dalembert._checks import FloatArray
from dalembert._core import ConfigurationType, ContactTypeIndex, MarkerIndex, OutputVariableType
from dalembert._tools.found_items import find_item
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


def _is_row(value: Any, length: int) -> bool:
    """Return whether the value has any number of rows of so many finite numbers."""
    try:
        array = np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        return False
    return array.ndim == 2 and array.shape[1] == length and len(array) > 0 and bool(np.isfinite(array).all())


def _rows(length: int, what: str) -> Check:
    return Check(lambda value: _is_row(value, length), f"a list of {what}, each with {length} numbers")


_DIRECTION = refined(
    vector(3), "a vector with 3 finite components that is not zero", lambda value: "" if value.any() else "It is zero"
)

CHECKS: dict[str, dict[str, Check]] = {
    "CreateDistanceSensorGeometry": {
        "meshPoints": _rows(3, "points"),
        "meshTrigs": _rows(3, "triangles"),
    },
    "CreateDistanceSensor": {
        "dirSensor": _DIRECTION,
        "minDistance": NUMBER,
        "maxDistance": NUMBER,
        "cylinderRadius": NOT_NEGATIVE,
        "measureVelocity": FLAG,
        "addGraphicsObject": FLAG,
        "drawDisplaced": FLAG,
        "color": color(),
    },
}
TEXTS = {
    "CreateDistanceSensorGeometry": {
        "meshPoints": "corners of triangles in the frame of the marker (m), such as those of a triangle mesh of graphics",
        "meshTrigs": "three indices of points per triangle; a ray sees both sides",
        "rigidBodyMarkerIndex": "rigid marker that carries the triangles, by its index or name",
        "searchTreeCellSize": "numbers of cells of the search along x, y and z",
    },
    "CreateDistanceSensor": {
        "generalContactIndex": "number of the GeneralContact whose spheres and triangles are seen",
        "positionOrMarker": "start of the ray: a point in the global frame (m), or a marker by its index or name",
        "dirSensor": "direction of the ray, of any length; in the frame of a rigid marker, otherwise in the global frame",
        "minDistance": "least distance that counts (m); below zero, the ray looks backwards too",
        "maxDistance": "greatest distance (m), which is the value where nothing is seen",
        "cylinderRadius": "radius of the ray (m); above zero, only spheres are seen",
        "selectedTypeIndex": "kind of contact that is seen, such as exu.ContactTypeIndex.IndexTrigsRigidBodyBased; all",
        "measureVelocity": "True: the velocity along the ray (m/s) is the second value",
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

    Points (m) are in the frame of the marker, triangles hold three point indices each; no contact forces arise.
    """
    contact = mbs.AddGeneralContact()
    contact.SetFrictionPairings(np.zeros((1, 1)))
    contact.SetSearchTreeCellSize(numberOfCells=searchTreeCellSize)
    contact.AddTrianglesRigidBodyBased(
        rigidBodyMarkerIndex=rigidBodyMarkerIndex,
        contactStiffness=1,
        contactDamping=1,
        frictionMaterialIndex=0,
        pointList=meshPoints,
        triangleList=meshTrigs,
    )
    contact.isActive = False
    return int(mbs.NumberOfGeneralContacts()) - 1


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

    Start point and direction are global; a marker moves the start point, and a rigid marker turns the direction too.
    A cylinder radius (m) widens the ray. measureVelocity adds the velocity (m/s) along the line as second value.
    addGraphicsObject draws the ray as a ground object, at its end if drawDisplaced.
    """
    marker = -1
    if isinstance(positionOrMarker, str):
        positionOrMarker = find_item(mbs, positionOrMarker, ("Marker",), "CreateDistanceSensor: positionOrMarker")
    if isinstance(positionOrMarker, MarkerIndex):
        marker = int(positionOrMarker)
        try:
            position = mbs.GetMarkerOutput(
                positionOrMarker, OutputVariableType.Position, configuration=ConfigurationType.Reference
            )
        except (RuntimeError, ValueError):  # markers that know their position after Assemble() only
            position = np.zeros(3)
    elif isinstance(positionOrMarker, (list, tuple, np.ndarray)) and len(positionOrMarker) == 3:
        position = positionOrMarker
    else:
        raise ValueError(
            "CreateDistanceSensor: positionOrMarker: expected a MarkerIndex, a name or a position with 3 components, "
            f"received {positionOrMarker!r} ({type(positionOrMarker).__name__})"
        )
    start, direction = [float(x) for x in position], [float(x) for x in dirSensor]

    graphicsObject = -1
    if addGraphicsObject:
        from dalembert import graphics

        ray = (-1.0 if drawDisplaced else 1.0) * np.array(direction)
        if cylinderRadius == 0:
            shape = graphics.Lines([[0, 0, 0], list(ray)], color=color)
        else:
            shape = graphics.Cylinder([0, 0, 0], ray, radius=cylinderRadius, color=color)
        view = items.VObjectGround(graphicsData=[shape])
        graphicsObject = int(mbs.AddObject(items.ObjectGround(referencePosition=start, visualization=view)))

    limits = [minDistance, maxDistance, cylinderRadius]
    options = [int(selectedTypeIndex), measureVelocity, graphicsObject, drawDisplaced]
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
