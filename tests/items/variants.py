"""Which random models are tested: every ready item on each node type or kind of marker, with all its options and user functions."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from motions import KINDS, Place
from scenes import (
    BEAM,
    BODIES,
    CABLE,
    CABLE_3D,
    EP,
    FIRST_ORDER,
    GENERIC,
    GENERIC_NODE,
    GROUND,
    GROUND_NODE,
    ITEMS,
    LIE,
    MASS_1D,
    POINT,
    POINT_2D,
    READY,
    RESTING_POINT,
    RIGID_2D,
    ROTOR_1D,
    RXYZ,
    Scene,
    on_markers,
)

from codegen.model import Item

# Options that change the equations of an item; every one is tested on the item's first pair of markers.
OPTIONS: dict[str, list[dict[str, Any]]] = {
    "ObjectJointGeneric": [
        {"constrainedAxes": [1, 1, 1, 1, 1, 1]},
        {"constrainedAxes": [1, 1, 1, 1, 1, 1], "alternativeConstraints": True},
        {"constrainedAxes": [1, 1, 1, 1, 1, 0]},
        {"constrainedAxes": [1, 0, 1, 1, 0, 1]},
        {"constrainedAxes": [0, 1, 0, 0, 1, 1]},
        {"constrainedAxes": [0, 0, 1, 1, 0, 0]},
        {"constrainedAxes": [1, 1, 0, 0, 1, 0]},
        {"constrainedAxes": [0, 0, 0, 0, 0, 1]},
    ],
    "ObjectJointSpherical": [{"constrainedAxes": [1, 1, 1]}, {"constrainedAxes": [1, 0, 1]}],
    "ObjectConnectorRigidBodySpringDamper": [{}, {"intrinsicFormulation": True}],
    "ObjectConnectorCoordinateSpringDamperExt": [
        {"frictionProportionalZone": 0.01},
        {"frictionProportionalZone": 0.0},
        {"frictionProportionalZone": 20.0, "useLimitStops": True},
    ],
    "ObjectContactSphereTorus": [{}, {"impactModel": 1}, {"impactModel": 2, "contactStiffnessExponent": 1.0}],
    "ObjectConnectorCoordinate": [{"velocityLevel": False}, {"velocityLevel": True}],
    "ObjectConnectorCoordinateVector": [{"velocityLevel": False}, {"velocityLevel": True}],
    "ObjectANCFCable2D": [
        {"useReducedOrderIntegration": 0, "strainIsRelativeToReference": 0.0},
        {"useReducedOrderIntegration": 1, "strainIsRelativeToReference": 1.0},
        {"useReducedOrderIntegration": 2, "strainIsRelativeToReference": 0.5},
    ],
    "ObjectANCFCable": [
        {"useReducedOrderIntegration": 0, "strainIsRelativeToReference": 0.0},
        {"useReducedOrderIntegration": 1, "strainIsRelativeToReference": 1.0},
        {"useReducedOrderIntegration": 2, "strainIsRelativeToReference": 0.5},
    ],
    "ObjectConnectorHydraulicActuatorSimple": [{"useChamberVolumeChange": False}, {"useChamberVolumeChange": True}],
    "LoadForceVector": [{}, {"bodyFixed": True}],
    "LoadTorqueVector": [{}, {"bodyFixed": True}],
    "NodeRigidBodyEP": [{}, {"addConstraintEquation": False}],
}


def optional_data(item: Item) -> bool:
    """May the data node be left out?"""
    rows = [row for row in item.parameters if row.type.storage == "node"]
    return all(row.optional for row in rows) or item.name == "ObjectConnectorCoordinateSpringDamperExt"


@dataclass(frozen=True)
class Variant:
    """Which model: items on markers (class names) on carriers (body, node)."""

    item: str
    pairs: tuple[tuple[str, tuple[str, str]], ...] = ()
    options: tuple[tuple[str, Any], ...] = ()
    functions: bool = False
    data: bool = False

    @property
    def id(self) -> str:
        words = [
            f"{marker.removeprefix('Marker')}({body.removeprefix('Object') or node}{'/' + node if body else ''})"
            for marker, (body, node) in self.pairs
        ]
        words += [f"{key}={value}".replace(" ", "") for key, value in self.options]
        return "-".join(
            [self.item, *words, *(["functions"] if self.functions else []), *(["data"] if self.data else [])]
        )

    @property
    def uses(self) -> set[str]:
        """Names of the items in the model, as far as the variant decides them."""
        names = {
            self.item,
            *(marker for marker, _ in self.pairs),
            *(name for _, carrier in self.pairs for name in carrier),
        }
        return (names | ({"NodeGenericData"} if self.data else set())) - {"", "Points"}

    @property
    def planar(self) -> bool:
        return any(node in KINDS and KINDS[node].planar for _, (_, node) in self.pairs)

    def build(self, seed: int = 0, place: Place | None = None, closed: bool = False, resting: bool = False) -> Scene:
        scene = Scene(seed, place or Place(), self.planar, resting)
        scene.build(self, closed)
        return scene


# ---- which models --------------------------------------------------------------------------------------------------------
def frame_pairs(rigid: bool) -> Iterator[tuple[tuple[str, tuple[str, str]], ...]]:
    body, node = ("MarkerBodyRigid", "MarkerNodeRigid") if rigid else ("MarkerBodyPosition", "MarkerNodePosition")
    yield (body, EP), (body, RXYZ)
    yield (body, RXYZ), (body, LIE)
    yield (node, LIE), (node, EP)
    yield (body, GROUND), (body, LIE)
    yield (body, EP), (body, GROUND)
    yield (body, RIGID_2D), (body, RIGID_2D)
    yield ("MarkerBodyRigid", LIE), (node, RXYZ)
    if rigid:
        yield (node, RIGID_2D), (body, CABLE)
        yield (body, ROTOR_1D), (body, EP)
        yield ("MarkerSuperElementRigid", GENERIC), (body, LIE)
        yield (body, CABLE), (body, RIGID_2D)
        yield (body, (BEAM, EP[1])), (node, (BEAM, LIE[1]))
    else:
        yield (body, POINT), ("MarkerSuperElementPosition", GENERIC)
        yield (node, GROUND_NODE), (body, POINT)
        yield (body, POINT), (body, RESTING_POINT)
        yield (body, POINT_2D), (body, CABLE)
        yield (body, CABLE_3D), (body, EP)
        yield (node, CABLE_3D), (node, POINT)
        yield (body, (BEAM, LIE[1])), (body, (BEAM, RXYZ[1]))
        yield (body, MASS_1D), (body, ROTOR_1D)
        yield (node, CABLE), ("MarkerBodyRigid", RIGID_2D)


def planar_pairs(rigid: bool) -> Iterator[tuple[tuple[str, tuple[str, str]], ...]]:
    body, node = ("MarkerBodyRigid", "MarkerNodeRigid") if rigid else ("MarkerBodyPosition", "MarkerNodePosition")
    yield (body, RIGID_2D), (body, RIGID_2D)
    yield (node, RIGID_2D), (body, GROUND)
    yield (body, CABLE), (body, RIGID_2D)
    if not rigid:
        yield (body, POINT_2D), ("MarkerBodyRigid", RIGID_2D)


def coordinate_pairs() -> Iterator[tuple[tuple[str, tuple[str, str]], ...]]:
    one, turn = "MarkerNodeCoordinate", "MarkerNodeRotationCoordinate"
    yield (one, MASS_1D), (one, ROTOR_1D)
    yield (one, EP), (one, RXYZ)
    yield (one, GROUND_NODE), (one, GENERIC_NODE)
    yield (turn, RXYZ), (turn, LIE)
    yield (one, POINT_2D), (turn, EP)
    yield (one, RIGID_2D), (one, CABLE)
    yield (one, CABLE_3D), (one, POINT)


def vector_pairs() -> Iterator[tuple[tuple[str, tuple[str, str]], ...]]:
    vector, whole = "MarkerNodeCoordinates", "MarkerObjectODE2Coordinates"
    yield (vector, POINT), (vector, EP)
    yield (vector, RXYZ), (vector, GENERIC_NODE)
    yield (whole, CABLE), (vector, RIGID_2D)
    yield (whole, CABLE_3D), (vector, POINT)
    yield (vector, MASS_1D), (whole, GENERIC)


def relative_pairs() -> Iterator[tuple[tuple[str, tuple[str, str]], ...]]:
    turning, sliding = (f"MarkerBodiesRelative{motion}Coordinate" for motion in ("Rotation", "Translation"))
    yield (sliding, EP), ("MarkerNodeCoordinate", MASS_1D)
    yield (turning, LIE), ("MarkerNodeCoordinate", MASS_1D)
    yield (turning, EP), (sliding, LIE)
    yield (sliding, RIGID_2D), ("MarkerNodeCoordinate", GROUND_NODE)


def pairs_of(item: Item) -> list[tuple[tuple[str, tuple[str, str]], ...]]:
    requested = set(item.requested_markers)
    if item.name == "ObjectConnectorCoordinateVector":
        return list(vector_pairs())
    if item.name == "ObjectConnectorReevingSystemSprings":
        body = "MarkerBodyRigid"
        return [((body, EP), (body, RXYZ), (body, LIE)), *frame_pairs(True)]
    if "Coordinate" in requested:
        pairs = [*coordinate_pairs(), *relative_pairs()]
        if item.kind == "load":
            pairs.append((("MarkerNodeODE1Coordinate", FIRST_ORDER), ("", POINT)))
    elif "BodyMass" in requested:
        pairs = [(("MarkerBodyMass", body), ("", POINT)) for body in BODIES if body[0] != ROTOR_1D[0]]
    elif item.name.endswith("2D"):
        pairs = list(planar_pairs("Orientation" in requested))
    else:
        pairs = list(frame_pairs("Orientation" in requested))
    pairs = [pair for pair in pairs if all(not marker or ITEMS[marker].ready for marker, _ in pair)]
    if item.kind != "load":
        return pairs
    return [(pair[0], *(("", carrier) for _, carrier in pair[1:])) for pair in pairs if pair[0][1] != GROUND]


def variants_about(item: Item) -> Iterator[Variant]:
    """The models whose target is the item."""
    if item.name == "ObjectGenericODE1":
        yield Variant(item.name, (("", FIRST_ORDER),))
        yield Variant(item.name, (("", FIRST_ORDER),), functions=True)
    elif on_markers(item):
        options = [tuple(o.items()) for o in OPTIONS.get(item.name, [{}])]
        pairs = pairs_of(item)
        data = "GenericData" in item.requested_nodes
        if item.name == "LoadForceVector":  # a follower force needs an orientation
            pairs = [(("MarkerBodyRigid", EP), ("", POINT)), *pairs]
        yield from (Variant(item.name, pairs[0], o, data=data) for o in options)
        optional = data and optional_data(item)
        if optional:
            yield Variant(item.name, pairs[0], options[0])
        yield from (Variant(item.name, pair, options[0], data=data and not optional) for pair in pairs[1:])
        if item.user_functions:
            yield Variant(item.name, pairs[0], options[0], functions=True, data=data)
    elif item.kind == "object" and item.name != "ObjectGround":
        carriers = [body for body in [*BODIES, GENERIC] if body[0] == item.name]
        yield from (
            Variant(item.name, (("", carrier), ("", carrier)), tuple(o.items()))
            for carrier in carriers
            for o in OPTIONS.get(item.name, [{}])
        )
        if any(row.type.function for row in item.parameters):
            yield Variant(item.name, (("", carriers[0]),), functions=True)
    elif item.name in OPTIONS:
        yield from (Variant(item.name, (("", EP), ("", EP)), tuple(o.items())) for o in OPTIONS[item.name])


ALL_VARIANTS = [variant for item in READY for variant in variants_about(item)]


def variants_with(item: Item) -> list[Variant]:
    """All models that use the item."""
    return [variant for variant in ALL_VARIANTS if item.name in variant.uses]
