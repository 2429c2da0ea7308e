"""Check of a model for likely mistakes before it is solved, and some statistics."""

from __future__ import annotations

import copy
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from dalembert._core import SimulationSettings, testing

_KINDS = ("Node", "Object", "Marker", "Load", "Sensor")
_TARGETS = {f"{kind.lower()}Number": kind for kind in _KINDS} | {
    "bodyNumber": "Object",
    "slidingMarkerNumber": "Marker",
}
_FREE_NODES = ("GenericData", "GenericAE", "PointGround")  # need no object


def figures(mbs: Any) -> list[tuple[str, str]]:
    """Return names and values: numbers of items, coordinates, degrees of freedom, mass."""
    counts = {kind: getattr(mbs.systemData, f"NumberOf{kind}s")() for kind in _KINDS}
    rows = [("items", ", ".join(f"{n} {kind.lower()}{'' if n == 1 else 's'}" for kind, n in counts.items()))]
    mbs.Assemble()
    counted = mbs.ComputeSystemDegreeOfFreedom()
    rows.append(("coordinates", f"{counted['nODE2']} of second order, {counted['nODE1']} of first order"))
    rows.append(("constraints", f"{counted['nAE']}, of which {counted['redundantConstraints']} are redundant"))
    rows.append(("degrees of freedom", str(counted["degreeOfFreedom"])))
    rows.append(("mass", f"{sum(mass for _, mass in _masses(mbs)):.6g} kg"))
    return rows


def findings(mbs: Any) -> list[str]:
    """Return a sentence on each thing that looks wrong. An error of Assemble() is one, and then the only one."""
    try:
        mbs.Assemble()
    except Exception as error:  # any error of a kernel or a user function
        return [f"Assemble(): {error}"]
    return [*_gaps(mbs), *_redundancy(mbs), *_magnitudes(mbs), *_loads(mbs), *_self_connections(mbs), *_unused(mbs)]


def _gaps(mbs: Any) -> Iterator[str]:
    """Warnings of solvers at the start."""
    trial, tolerated = copy.copy(mbs), SimulationSettings().initialConditions
    trial.Assemble()
    state = testing.State(trial)
    found = testing.open_constraints(trial, state, tolerated.positionTolerance, tolerated.velocityTolerance)
    for *_, text in found:
        yield f"initial values contradict a constraint: {text}"
    if not found:
        return
    try:
        trial.ComputeConsistentInitialConditions()
    except ValueError:
        yield "no values near these fulfil all constraints: are markers at the wrong places, or do joints contradict?"
    else:
        yield "mbs.ComputeConsistentInitialConditions() would mend these."


def _redundancy(mbs: Any) -> Iterator[str]:
    counted = mbs.ComputeSystemDegreeOfFreedom()
    if number := counted["redundantConstraints"]:
        yield (
            f"{number} of {counted['nAE']} constraints are redundant. Solvers find the motion all the same, and the "
            "smallest reactions, see 'Closed loops'; joints that constrain only free motions have unique ones."
        )
    if counted["degreeOfFreedom"] == 0 and counted["nODE2"] and not _is_driven(mbs):
        yield "no degree of freedom is left: nothing can move."


def _is_driven(mbs: Any) -> bool:
    """Return whether a constraint moves something, by a function of time or at a constant speed."""
    items = (mbs.GetObject(number) for number in range(mbs.systemData.NumberOfObjects()))
    return any(
        item.get("offsetUserFunction") or item.get("offsetUserFunction_t") or item.get("velocityLevel")
        for item in items
    )


def _masses(mbs: Any) -> Iterator[tuple[str, float]]:
    for number in range(mbs.systemData.NumberOfObjects()):
        item = mbs.GetObject(number)
        title = f"object {number} '{item['name']}' ({item['objectType']})"
        if "physicsMass" in item:
            yield title, float(item["physicsMass"])
        elif "physicsMassPerLength" in item:
            yield title, float(item["physicsMassPerLength"] * item["physicsLength"])


def _magnitudes(mbs: Any) -> Iterator[str]:
    masses = list(_masses(mbs))
    for title, mass in masses:
        if mass == 0:
            yield f"{title} has no mass."
    known = [(mass, title) for title, mass in masses if mass > 0]
    if known and (most := max(known))[0] > 1e9 * (least := min(known))[0]:
        extremes = f"{least[0]:g} kg of {least[1]}, {most[0]:g} kg of {most[1]}"
        yield f"masses differ by more than 1e9: {extremes}; mixed units?"
    for number in range(mbs.systemData.NumberOfObjects()):
        item = mbs.GetObject(number)
        if item["objectType"] == "RigidBody" and item["physicsMass"] > 0:
            inertia = np.asarray(item["physicsInertia"])[:3].max()
            radius = float(np.sqrt(max(inertia, 0) / item["physicsMass"]))
            if not 1e-6 < radius < 1e3:
                yield (
                    f"object {number} '{item['name']}' has a radius of gyration of {radius:.3g} m; "
                    "is its inertia zero, or in kg mm^2? Units are kg m^2."
                )


def _loads(mbs: Any) -> Iterator[str]:
    accelerations: dict[float, list[str]] = {}
    weights: dict[int, list[str]] = {}
    on_ground: list[str] = []
    for number in range(mbs.systemData.NumberOfLoads()):
        load = mbs.GetLoad(number)
        title = f"load {number} '{load['name']}'"
        marker = mbs.GetMarker(load["markerNumber"])
        body = marker.get("bodyNumber")
        if load["loadType"] != "MassProportional":
            if body is not None and mbs.GetObject(body)["objectType"] == "Ground":
                on_ground.append(title)
            continue
        weights.setdefault(int(body), []).append(title)
        if (g := float(np.linalg.norm(load["loadVector"]))) > 100:
            accelerations.setdefault(g, []).append(title)
    for g, titles in accelerations.items():
        yield f"{_all_of(titles)} an acceleration of {g:g} m/s^2; gravity in mm/s^2?"
    for body, titles in weights.items():
        if len(titles) > 1:
            name = mbs.GetObject(body)["name"]
            yield f"{' and '.join(titles)} both act on the mass of object {body} '{name}': is its weight there twice?"
    if on_ground:
        yield f"{_all_of(on_ground)} on ground, and without effect."


def _all_of(titles: list[str]) -> str:
    """Return the beginning of a sentence on similar items."""
    if len(titles) == 1:
        return f"{titles[0]} is"
    return f"{titles[0]} and {len(titles) - 1} other{'s' if len(titles) > 2 else ''} are"


def _self_connections(mbs: Any) -> Iterator[str]:
    """Springs, joints and the like whose markers sit in one place of one body."""
    for number in range(mbs.systemData.NumberOfObjects()):
        item = mbs.GetObject(number)
        markers = [dict(mbs.GetMarker(marker)) for marker in item.get("markerNumbers", []) if int(marker) >= 0]
        places = [repr({k: v for k, v in m.items() if k != "name" and not k.startswith("V")}) for m in markers]
        if len(places) > 1 and len(set(places)) == 1:
            yield (
                f"object {number} '{item['name']}' ({item['objectType']}) joins a place with itself: its markers "
                f"{' and '.join(repr(m['name']) for m in markers)} are alike. Did you give one body twice?"
            )


def _references(item: dict[str, Any]) -> Iterator[tuple[str, list[int]]]:
    """Give the kinds and numbers of items that an item refers to."""
    for key, value in item.items():
        if target := _TARGETS.get(key.removesuffix("s")):
            yield target, [int(number) for number in (value if isinstance(value, list) else [value])]


def _nodes_of_objects(mbs: Any) -> set[int]:
    """Return the nodes that have an object, or on which one acts by a marker."""
    found: set[int] = set()
    for number in range(mbs.systemData.NumberOfObjects()):
        for target, numbers in _references(mbs.GetObject(number)):
            if target == "Node":
                found.update(numbers)
            elif target == "Marker":
                acted = [dict(_references(mbs.GetMarker(marker))) for marker in numbers if marker >= 0]
                found.update(node for each in acted for node in each.get("Node", []))
    return found


def _markers_of_contacts(mbs: Any) -> Iterator[int]:
    """Give the markers of spheres, triangles and other shapes of general contact."""
    for contact in mbs.GetDictionary().get("generalContactList", []):
        for table in contact.values():
            for name, column in table.items() if isinstance(table, Mapping) else ():
                if name.lower().endswith("markerindex"):
                    yield from map(int, column)


def _unused(mbs: Any) -> Iterator[str]:
    used: dict[str, set[int]] = {kind: set() for kind in _KINDS}
    for kind in _KINDS:
        for number in range(getattr(mbs.systemData, f"NumberOf{kind}s")()):
            for target, numbers in _references(getattr(mbs, f"Get{kind}")(number)):
                used[target].update(numbers)
    moved = _nodes_of_objects(mbs)
    for number in range(mbs.systemData.NumberOfNodes()):
        node = mbs.GetNode(number)
        if number not in moved and node["nodeType"] not in _FREE_NODES:
            title = f"node {number} '{node['name']}' ({node['nodeType']})"
            user = "belongs to no object" if number in used["Node"] else "is used by nothing"
            yield f"{title} {user}: its coordinates have no equations."
    used["Marker"].update(_markers_of_contacts(mbs))
    titles = [
        f"marker {number} '{mbs.GetMarkerParameter(number, 'name')}'"
        for number in range(mbs.systemData.NumberOfMarkers())
        if number not in used["Marker"]
    ]
    if titles:
        yield f"{_all_of(titles)} used by nothing."
    for number in range(mbs.systemData.NumberOfSensors()):
        sensor = mbs.GetSensor(number)
        if not sensor["storeInternal"] and not (sensor["writeToFile"] and sensor["fileName"]):
            yield f"sensor {number} '{sensor['name']}' keeps nothing: it has neither storeInternal=True nor a fileName."
