"""Facts of item types: kinds, parameters, output variables, and which items fit to each other.

items: the facts of all items by their names, such as types.items["ObjectMassPoint"]["outputVariables"].
"""

from __future__ import annotations

from typing import Any

from dalembert._item_table import ITEMS as items

__all__ = [
    "ConnectorsForMarkers",
    "ItemInfo",
    "ItemNames",
    "LoadsForMarker",
    "MarkersForObject",
    "NodesForObject",
    "ObjectsForMarker",
    "Parameters",
    "items",
]

_KINDS = ("Node", "Object", "Marker", "Load", "Sensor")
_SUPER_ELEMENT_MARKERS = ("MarkerSuperElementPosition", "MarkerSuperElementRigid")
# Markers that need one of these objects.
_ONLY_ON = {
    "MarkerKinematicTreeRigid": ("ObjectKinematicTree",),
    "MarkerBodyBeamShape": ("ObjectANCFBeam",),
    "MarkerBodyCable2DShape": ("ObjectANCFCable2D", "ObjectALEANCFCable2D"),
    "MarkerBodyCable2DCoordinates": ("ObjectANCFCable2D", "ObjectALEANCFCable2D"),
}
# Objects without a frame of their own, and bodies whose points have a position only.
_NO_FRAME = ("ObjectGenericODE1", "ObjectGenericODE2", "ObjectKinematicTree")
_POINTS_ONLY = ("ObjectMassPoint", "ObjectMassPoint2D", "ObjectANCFCable", "ObjectANCFThinPlate")


def _facts(name: str, kind: str = "") -> dict[str, Any]:
    if name not in items:
        from dalembert._tools.missing_names import nearest

        hint = nearest(name, items) or "; expected the name of a class, such as ObjectMassPoint"
        raise ValueError(f"exu.types: there is no item {name!r}{hint}")
    if kind and items[name]["kind"] != kind:
        raise ValueError(f"exu.types: {name} is no {kind.lower()}")
    return items[name]


def ItemNames(kind: str | None = None) -> list[str]:
    """Return the names of all items, or of those of a kind: Node, Object, Marker, Load or Sensor."""
    if kind is not None and kind not in _KINDS:
        raise ValueError(f"exu.types.ItemNames: kind: expected one of {', '.join(_KINDS)}; received {kind!r}")
    return [name for name, facts in items.items() if kind in (None, facts["kind"])]


def ItemInfo(name: str) -> dict[str, Any]:
    """Return all facts of an item."""
    return _facts(name)


def Parameters(name: str) -> dict[str, dict[str, str]]:
    """Return type, size, range, default, unit and description of the parameters of an item, by their names."""
    found: dict[str, dict[str, str]] = _facts(name)["parameters"]
    return found


def NodesForObject(objectName: str) -> list[str]:
    """Return the nodes that an object can have."""
    return list(_facts(objectName, "Object")["nodes"])


def _carries(objectName: str, markerName: str) -> bool:
    body, marker = items[objectName]["types"], items[markerName]["types"]
    if "Object" not in marker or "Connector" in body:
        return False
    if markerName in _ONLY_ON:
        return objectName in _ONLY_ON[markerName]
    if markerName in _SUPER_ELEMENT_MARKERS:
        return "SuperElement" in body and objectName != "ObjectKinematicTree"  # whose links are no mesh nodes
    if markerName == "MarkerObjectODE2Coordinates":
        return "Ground" not in body and objectName != "ObjectGenericODE1"
    return objectName not in _NO_FRAME and (markerName != "MarkerBodyRigid" or objectName not in _POINTS_ONLY)


def MarkersForObject(objectName: str) -> list[str]:
    """Return the markers that can be attached to an object."""
    _facts(objectName, "Object")
    return [marker for marker in ItemNames("Marker") if _carries(objectName, marker)]


def ObjectsForMarker(markerName: str) -> list[str]:
    """Return the objects that a marker can be attached to."""
    _facts(markerName, "Marker")
    return [name for name in ItemNames("Object") if _carries(name, markerName)]


def ConnectorsForMarkers(markerName0: str, markerName1: str | None = None) -> list[str]:
    """Return the connectors, constraints and joints that one marker, or both, can be used for."""
    wanted = {name for name in (markerName0, markerName1) if name is not None}
    for name in wanted:
        _facts(name, "Marker")
    return [name for name in ItemNames("Object") if wanted <= set(items[name]["markers"])]


def LoadsForMarker(markerName: str) -> list[str]:
    """Return the loads that can act on a marker."""
    _facts(markerName, "Marker")
    return [name for name in ItemNames("Load") if markerName in items[name]["markers"]]
