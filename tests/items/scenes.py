"""Small random models around every ready item, made from its spec: bodies on each node type, in rotated and moving states;
connectors, constraints, joints and loads on every kind of marker; all options of an item, and its user functions."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np
from motions import EZ, KINDS, Array, Motion, NodeKind, Place, random_motion, random_rotation
from user_functions import functions_of

import dalembert as exu
from codegen.load import load
from codegen.model import Item, Parameter
from dalembert._core import testing

ITEMS: dict[str, Item] = {item.name: item for item in load(Path(__file__).parents[2]).items}
READY = [item for item in ITEMS.values() if item.ready]
BODIES = [(item.name, node) for item in READY for node in item.nodes]
SCALAR_BODIES = (
    "ObjectMass1D",
    "ObjectRotationalMass1D",
)  # one coordinate, and a frame of their own that the model's place turns
GENERIC = ("ObjectGenericODE2", "Points")
CABLE = ("ObjectANCFCable2D", "NodePoint2DSlope1")
EP, RXYZ, LIE = (("ObjectRigidBody", f"NodeRigidBody{frame}") for frame in ("EP", "Rxyz", "RotVecLG"))
POINT, POINT_2D, RIGID_2D = (
    ("ObjectMassPoint", "NodePoint"),
    ("ObjectMassPoint2D", "NodePoint2D"),
    ("ObjectRigidBody2D", "NodeRigidBody2D"),
)
MASS_1D, ROTOR_1D = ((name, "Node1D") for name in SCALAR_BODIES)
GROUND, GROUND_NODE = ("ObjectGround", ""), ("", "NodePointGround")
GENERIC_NODE = ("", "NodeGenericODE2")
FIRST_ORDER = ("ObjectGenericODE1", "NodeGenericODE1")
DATA_COORDINATES = {  # others: 3
    "ObjectConnectorRigidBodySpringDamper": 2,
    "ObjectConnectorTorsionalSpringDamper": 1,
    "ObjectContactCoordinate": 1,
}

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
    "ObjectConnectorCoordinate": [{"velocityLevel": False}, {"velocityLevel": True}],
    "ObjectConnectorCoordinateVector": [{"velocityLevel": False}, {"velocityLevel": True}],
    "ObjectANCFCable2D": [
        {"useReducedOrderIntegration": 0, "strainIsRelativeToReference": 0.0},
        {"useReducedOrderIntegration": 1, "strainIsRelativeToReference": 1.0},
        {"useReducedOrderIntegration": 2, "strainIsRelativeToReference": 0.5},
    ],
    "ObjectConnectorHydraulicActuatorSimple": [{"useChamberVolumeChange": False}, {"useChamberVolumeChange": True}],
    "LoadForceVector": [{}, {"bodyFixed": True}],
    "LoadTorqueVector": [{}, {"bodyFixed": True}],
    "NodeRigidBodyEP": [{}, {"addConstraintEquation": False}],
}


def on_markers(item: Item) -> bool:
    """Connectors, contacts, constraints, joints and loads."""
    return item.kind in ("object", "load") and any(row.type.storage in ("marker", "markers") for row in item.parameters)


def optional_data(item: Item) -> bool:
    """May the data node be left out?"""
    rows = [row for row in item.parameters if row.type.storage == "node"]
    return all(row.optional for row in rows) or item.name == "ObjectConnectorCoordinateSpringDamperExt"


def draw(rng: np.random.Generator, row: Parameter, planar: bool = False) -> Any:
    """A random value of a parameter, within its check; None: leave the default."""
    storage = row.type.storage
    if storage == "real":
        return rng.uniform(0.5, 1.5)
    if row.name.startswith(("rotation", "referenceRotation")):
        return random_rotation(rng, planar)
    if storage == "matrix6":
        root = rng.normal(size=(6, 6))
        return root @ root.T / 6 + np.eye(6)
    if storage.startswith("vector") and row.shape[0]:
        return rng.uniform(-1, 1, row.shape[0])
    return None


@dataclass
class Carrier:
    """Something that markers sit on."""

    body: Any = None
    nodes: list[Any] = field(default_factory=list)
    motion: Motion | None = None
    length: float = 0.0  # of a cable
    coordinates: int = 0  # ODE2, of all nodes
    point_mass: bool = False


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


class Scene:
    """A model in the making. `target`: (kind, number) of the item under test."""

    def __init__(self, seed: int, place: Place, planar: bool, resting: bool) -> None:
        self.mbs = exu.SystemContainer().AddSystem()
        self.rng = np.random.default_rng(seed)
        self.place, self.planar, self.resting = place, planar, resting
        self.nodes: list[tuple[Any, NodeKind, Motion]] = []
        self.bodies: list[Any] = []
        self.target: tuple[str, Any] = ("", None)
        self.options: dict[str, dict[str, Any]] = {}

    # ---- carriers ------------------------------------------------------------------------------------------------------
    def motion(self) -> Motion:
        m = random_motion(self.rng, self.planar)
        return replace(m, velocity=0 * m.velocity, angular_velocity=0 * m.angular_velocity) if self.resting else m

    def node(self, name: str, reference: Motion, motion: Motion) -> Any:
        kind = KINDS[name]
        item = kind.item(reference.at(self.place), motion.at(self.place))
        for key, value in self.options.get(name, {}).items():
            setattr(item, key, value)
        number = self.mbs.AddNode(item)
        if name != "NodePointGround":
            self.nodes.append((number, kind, motion.at(self.place)))
        return number

    def carrier(self, body: str, node: str, position: Array | None = None) -> Carrier:
        reference, motion = self.motion(), self.motion()
        if position is not None:
            motion = replace(motion, position=position)
        if body == "ObjectGround":
            frame = {
                "referencePosition": motion.at(self.place).position,
                "referenceRotation": motion.at(self.place).rotation,
            }
            return Carrier(self.mbs.AddObject(exu.ObjectGround(**frame)), [], motion)
        if body == "":
            return self._bare_node(node, reference, motion)
        if body in SCALAR_BODIES:
            return self._scalar_body(body, motion)
        if body == "ObjectGenericODE2":
            return self._generic(reference)
        if body == "ObjectGenericODE1":
            return self._first_order()
        if body == "ObjectANCFCable2D":
            return self._cable(reference, motion)
        number = self.node(node, reference, motion)
        made = self.mbs.AddObject(getattr(exu, body)(nodeNumber=number, **self._inertia(body)))
        self.bodies.append(made)
        point = KINDS[node].frame == "point"
        frame = replace(motion, rotation=np.eye(3)) if point else motion
        return Carrier(made, [number], frame, coordinates=len(KINDS[node].total(motion)), point_mass=point)

    def _inertia(self, body: str) -> dict[str, Any]:
        rng, size = self.rng, 2 if body == "ObjectRigidBody2D" else 3
        mass, arm = rng.uniform(1, 2), rng.uniform(-0.5, 0.5, size)
        if body == "ObjectRigidBody":
            root = rng.uniform(-0.5, 0.5, (3, 3))
            j = root @ root.T + np.eye(3) + mass * (arm @ arm * np.eye(3) - np.outer(arm, arm))
            inertia: Any = [j[0, 0], j[1, 1], j[2, 2], j[1, 2], j[0, 2], j[0, 1]]
        elif body == "ObjectRigidBody2D":
            inertia = rng.uniform(1, 2) + mass * arm @ arm
        else:
            return {"physicsMass": mass}
        return {"physicsMass": mass, "physicsInertia": inertia, "physicsCenterOfMass": arm}

    def _bare_node(self, name: str, reference: Motion, motion: Motion) -> Carrier:
        if name == "NodePointGround":
            return Carrier(
                None, [self.node(name, motion, motion)], Motion(motion.position, np.eye(3), *(np.zeros(3),) * 4)
            )
        return Carrier(None, [self._free_coordinates(3)], coordinates=3)

    def _free_coordinates(self, n: int) -> Any:
        """A node with n coordinates, and the mass, stiffness and damping that go with it."""
        rng = self.rng
        start = {
            key: rng.uniform(-1, 1, n) for key in ("referenceCoordinates", "initialCoordinates", "initialCoordinates_t")
        }
        if self.resting:
            start["initialCoordinates_t"] = np.zeros(n)
        node = self.mbs.AddNode(exu.NodeGenericODE2(numberOfODE2Coordinates=n, **start))
        self.mbs.AddObject(exu.ObjectGenericODE2(nodeNumbers=[node], **self._matrices(n)))
        return node

    def _matrices(self, n: int) -> dict[str, Any]:
        names = ("massMatrix", "stiffnessMatrix", "dampingMatrix")
        roots = {name: self.rng.uniform(-1, 1, (n, n)) for name in names}
        return {name: root @ root.T + np.eye(n) for name, root in roots.items()}

    def _scalar_body(self, body: str, motion: Motion) -> Carrier:
        rng, placed = self.rng, motion.at(self.place)
        q, v = rng.uniform(-1, 1, 2), 0.0 if self.resting else rng.uniform(-1, 1)
        node = self.mbs.AddNode(exu.Node1D(referenceCoordinates=q[:1], initialCoordinates=q[1:], initialVelocities=[v]))
        inertia = {"physicsMass" if body == "ObjectMass1D" else "physicsInertia": rng.uniform(1, 2)}
        made = self.mbs.AddObject(
            getattr(exu, body)(
                nodeNumber=node, referencePosition=placed.position, referenceRotation=placed.rotation, **inertia
            )
        )
        self.bodies.append(made)
        return Carrier(made, [node], coordinates=1)

    def _generic(self, reference: Motion) -> Carrier:
        """A super element of four points in a slightly deformed state: springs and dampers that act alike in all directions,
        so that the law has no frame."""
        nodes = []
        for corner in np.array([[1.0, 0, 0], [0, 1, 0], [-1, 0, 0.5], [0, -1, -0.5]]):
            m, noise = self.motion(), 0.1 * self.rng.normal(size=3)
            start = replace(reference, position=reference.point(corner))
            nodes.append(self.node("NodePoint", start, replace(m, position=start.position + noise)))
        ring = 2 * np.eye(4) - np.roll(np.eye(4), 1, axis=0) - np.roll(np.eye(4), -1, axis=0)
        matrices = {
            "massMatrix": np.diag([1.5, 2.5, 1.0, 2.0]),
            "stiffnessMatrix": 3 * ring,
            "dampingMatrix": 0.5 * ring,
        }
        made = self.mbs.AddObject(
            exu.ObjectGenericODE2(nodeNumbers=nodes, **{k: np.kron(m, np.eye(3)) for k, m in matrices.items()})
        )
        self.bodies.append(made)
        return Carrier(made, nodes, reference, coordinates=12)

    def _first_order(self) -> Carrier:
        start = {"referenceCoordinates": [0.1, 0.2], "initialCoordinates": [0.5, -0.3]}
        node = self.mbs.AddNode(exu.NodeGenericODE1(numberOfODE1Coordinates=2, **start))
        rows = {"systemMatrix": [[-1.0, 2.0], [-3.0, -0.5]], "rhsVector": [0.3, 0.7]}
        return Carrier(self.mbs.AddObject(exu.ObjectGenericODE1(nodeNumbers=[node], **rows)), [node], coordinates=2)

    def _cable(self, reference: Motion, motion: Motion) -> Carrier:
        rng, length = self.rng, 1.5
        along = np.array([length, 0, 0])
        end = self.motion()
        end = replace(end, position=motion.point(1.1 * along), rotation=motion.rotation @ random_rotation(rng, True))
        ends = [replace(reference, position=reference.point(along)), end]
        nodes = [
            self.node("NodePoint2DSlope1", r, m) for r, m in zip([reference, ends[0]], [motion, ends[1]], strict=True)
        ]
        rows = {row.name: draw(rng, row) for row in ITEMS["ObjectANCFCable2D"].parameters if row.type.storage == "real"}
        rows |= {"physicsLength": length, "physicsReferenceAxialStrain": 0.05, "physicsReferenceCurvature": 0.1}
        rows |= self.options.get("ObjectANCFCable2D", {})
        made = self.mbs.AddObject(exu.ObjectANCFCable2D(nodeNumbers=nodes, **rows))
        self.bodies.append(made)
        return Carrier(made, nodes, motion, length, coordinates=8)

    # ---- markers -------------------------------------------------------------------------------------------------------
    def marker(self, name: str, on: Carrier, point: Array | None = None) -> Any:
        """`point`: global position, where the marker is to sit."""
        rng, cls = self.rng, getattr(exu, name)
        if name.startswith("MarkerNode"):
            key, number = "nodeNumber", on.nodes[0]
        elif name.startswith("MarkerBodiesRelative"):
            return self._relative_marker(cls, on)
        else:
            key, number = ("objectNumber" if name == "MarkerObjectODE2Coordinates" else "bodyNumber"), on.body
        rows: dict[str, Any] = {key: number}
        if name in ("MarkerBodyPosition", "MarkerBodyRigid"):
            local = rng.uniform(-0.5, 0.5, 3)
            if on.length:
                local = np.array([rng.uniform(0, on.length), rng.uniform(-0.1, 0.1), 0])
            if self.planar:
                local[2] = 0
            if on.point_mass:
                local = np.zeros(3)  # a force beside a mass point would act like one at the mass
            if point is not None and on.motion is not None:
                local = on.motion.rotation.T @ (point - on.motion.position)
            rows["localPosition"] = local
        elif name in ("MarkerNodeCoordinate", "MarkerNodeODE1Coordinate"):
            rows["coordinate"] = int(rng.integers(on.coordinates // len(on.nodes))) if on.coordinates else 0
        elif name == "MarkerNodeRotationCoordinate":
            rows["rotationCoordinate"] = int(rng.integers(3))
        elif name.startswith("MarkerSuperElement"):
            rows |= {"meshNodeNumbers": [0, 1, 2, 3], "weightingFactors": [0.25, 0.35, 0.3, 0.1]}
        return self.mbs.AddMarker(cls(**rows))

    def _relative_marker(self, cls: Any, on: Carrier) -> Any:
        """Between a carrier and another body."""
        other = self.carrier(*(RIGID_2D if self.planar else RXYZ))
        flat = np.array([1, 1, 0]) if self.planar else 1
        local = [self.rng.uniform(-0.5, 0.5, 3) * flat for _ in range(2)]
        axis = self.rng.normal(size=3) * flat
        rows = {
            "axis0": axis / np.linalg.norm(axis),
            "offset": 0.1,
            "localPosition0": local[0],
            "localPosition1": local[1],
        }
        return self.mbs.AddMarker(cls(bodyNumbers=[on.body, other.body], **rows))

    def marker_point(self, number: Any, on: Carrier) -> Array:
        """Global position of a marker before the model is placed."""
        assert on.motion is not None
        return on.motion.point(self.mbs.GetMarker(number).get("localPosition", np.zeros(3)))

    # ---- the whole -----------------------------------------------------------------------------------------------------
    def build(self, variant: Variant, closed: bool) -> None:
        item, options = ITEMS[variant.item], dict(variant.options)
        self.options = {variant.item: options}
        carriers: list[Carrier] = []
        markers: list[Any] = []
        for name, (body, node) in variant.pairs:
            frames = item.name != "ObjectConnectorDistance" and "Coordinate" not in item.requested_markers
            together = closed and markers and frames
            point = self.marker_point(markers[0], carriers[0]) if together else None
            at_node = name.startswith("MarkerNode") or KINDS.get(node, KINDS["NodeRigidBodyEP"]).frame == "point"
            carriers.append(self.carrier(body, node, point if at_node else None))
            if name:
                markers.append(self.marker(name, carriers[-1], point))
        if on_markers(item):
            self._add_target(variant, carriers, markers, closed, options)
        self._finish(item, carriers, variant.functions)
        self.mbs.Assemble()
        if closed:
            self._close(item)

    def _finish(self, item: Item, carriers: list[Carrier], functions: bool) -> None:
        """Bodies: the first carrier is the target."""
        if item.kind != "object" or self.target[0] or not carriers:
            return
        self.target = ("Object", carriers[0].body)
        if functions:
            for key, function in functions_of(item, {}).items():
                self.mbs.SetObjectParameter(carriers[0].body, key, function)

    def _add_target(
        self, variant: Variant, carriers: list[Carrier], markers: list[Any], closed: bool, options: dict[str, Any]
    ) -> None:
        item, rng = ITEMS[variant.item], self.rng
        rows = {
            row.name: draw(rng, row, self.planar) for row in item.parameters if not row.internal and row.name != "name"
        }
        rows = {key: value for key, value in rows.items() if value is not None} | options
        if item.name == "ObjectConnectorCoordinateVector":
            rows |= self._coordinate_vector(markers, carriers, variant.functions)
        rows |= self._special(item, rows, len(markers))
        if closed and "rotationMarker1" in rows:
            first, second = (c.motion.rotation for c in carriers if c.motion is not None)
            rows["rotationMarker1"] = second.T @ first @ rows["rotationMarker0"]
        if item.name == "ObjectJointPrismatic2D":
            rows["axisMarker0"][2] = 0
            first, second = (c.motion.rotation for c in carriers if c.motion is not None)
            rows["normalMarker1"] = second.T @ first @ np.cross(EZ, rows["axisMarker0"])
        if "loadVector" in rows and not rows.get("bodyFixed"):
            rows["loadVector"] = self.place.turn @ rows["loadVector"]
        if variant.data:
            n = DATA_COORDINATES.get(item.name, 3)
            rows["nodeNumber"] = self.mbs.AddNode(
                exu.NodeGenericData(numberOfDataCoordinates=n, initialCoordinates=np.zeros(n))
            )
        if variant.functions:
            rows |= functions_of(item, rows)
        if item.kind == "load":
            self.target = ("Load", self.mbs.AddLoad(getattr(exu, item.name)(markerNumber=markers[0], **rows)))
        else:
            self.target = ("Object", self.mbs.AddObject(getattr(exu, item.name)(markerNumbers=markers, **rows)))

    def _special(self, item: Item, rows: dict[str, Any], markers: int) -> dict[str, Any]:
        """Parameters that have to fit others."""
        if item.name == "ObjectConnectorCoordinateSpringDamperExt":
            return {"limitStopsLower": -rows["limitStopsUpper"]}
        if item.name == "ObjectConnectorReevingSystemSprings":
            radii = [0.0, *[0.1] * (markers - 2), 0.0]
            axes = [(axis / np.linalg.norm(axis)).tolist() for axis in self.rng.normal(size=(markers, 3))]
            return {"sheavesRadii": radii, "sheavesAxes": axes, "regularizationForce": 0.5, "referenceLength": 0.1}
        if item.name == "ObjectConnectorHydraulicActuatorSimple":
            start = {"referenceCoordinates": [0, 0], "initialCoordinates": [2.0, 3.0]}
            node = self.mbs.AddNode(exu.NodeGenericODE1(numberOfODE1Coordinates=2, **start))
            return {
                "nodeNumbers": [node],
                "offsetLength": 0.01,
                "strokeLength": 20.0,
                "systemPressure": 20.0,
                "tankPressure": -9.0,
            }
        return {}

    def _coordinate_vector(self, markers: list[Any], carriers: list[Carrier], functions: bool) -> dict[str, Any]:
        """Two equations on all coordinates."""
        rng, sizes = self.rng, [carrier.coordinates for carrier in carriers]
        names = ("scalingMarker0", "scalingMarker1", "quadraticTermMarker0", "quadraticTermMarker1")
        made: dict[str, Any] = {name: rng.uniform(-1, 1, (2, n)) for name, n in zip(names, 2 * sizes, strict=True) if n}
        made["offset"] = rng.uniform(-1, 1, 2)
        if functions:
            made = {"scalingMarker0": np.zeros((2, sizes[0])), "scalingMarker1": np.zeros((2, sizes[1]))}
        return made

    def _close(self, item: Item) -> None:
        """Choose what a constraint prescribes such that the present state meets it."""
        if item.name == "ObjectConnectorDistance":
            span = self.mbs.GetObjectOutput(self.target[1], exu.OutputVariableType.Distance)
            self.mbs.SetObjectParameter(self.target[1], "distance", span)
        elif item.name in ("ObjectConnectorCoordinate", "ObjectConnectorCoordinateVector"):
            gap = testing.gaps(self.mbs, testing.State(self.mbs))[self.mbs.systemData.GetObjectLTGAE(self.target[1])]
            before = self.mbs.GetObjectParameter(self.target[1], "offset")
            self.mbs.SetObjectParameter(self.target[1], "offset", before + (gap if np.ndim(before) else gap[0]))

    def state(self) -> testing.State:
        """The start, with accelerations of the bodies' motions."""
        s = testing.State(self.mbs)
        a = s.a
        for number, kind, motion in self.nodes:
            first = self.mbs.GetNodeODE2Index(number)
            values = kind.accelerations(motion)
            a[first : first + len(values)] = values
        s.a = a
        return s

    def wrenches(self, r: Array) -> Array:
        """Per node with a frame: force and moment about the node, in global axes, of generalised forces."""
        rows = []
        for number, kind, motion in self.nodes:
            first, twists = self.mbs.GetNodeODE2Index(number), kind.twists(motion)
            rows.append(twists.T @ r[first : first + len(twists)])
        return np.array(rows).reshape(-1, 6)


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
    else:
        yield (body, POINT), ("MarkerSuperElementPosition", GENERIC)
        yield (node, GROUND_NODE), (body, POINT)
        yield (body, POINT_2D), (body, CABLE)
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


def vector_pairs() -> Iterator[tuple[tuple[str, tuple[str, str]], ...]]:
    vector, whole = "MarkerNodeCoordinates", "MarkerObjectODE2Coordinates"
    yield (vector, POINT), (vector, EP)
    yield (vector, RXYZ), (vector, GENERIC_NODE)
    yield (whole, CABLE), (vector, RIGID_2D)
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
        pairs = [(("MarkerBodyMass", body), ("", POINT)) for body in BODIES if body != ROTOR_1D]
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
