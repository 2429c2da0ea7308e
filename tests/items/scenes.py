"""Small random models around an item, made from its spec: bodies in rotated and moving states, markers on them, and what acts on
the markers."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from motions import EZ, KINDS, Array, Motion, NodeKind, Place, random_motion, random_rotation
from user_functions import functions_of

import dalembert as exu
from codegen.load import load
from codegen.model import Item, Parameter
from dalembert._core import testing

if TYPE_CHECKING:
    from variants import Variant

ITEMS: dict[str, Item] = {item.name: item for item in load(Path(__file__).parents[2]).items}
READY = [item for item in ITEMS.values() if item.ready]
ON_NODES = [(item.name, node) for item in READY for node in item.nodes]
# Bodies on ground nodes rest, and have no equations.
RESTING = [carrier for carrier in ON_NODES if "Ground" in ITEMS[carrier[1]].provides]
BODIES = [carrier for carrier in ON_NODES if carrier not in RESTING]
SCALAR_BODIES = ("ObjectMass1D", "ObjectRotationalMass1D")  # one coordinate, and a frame of their own
GENERIC = ("ObjectGenericODE2", "Points")
CABLE = ("ObjectANCFCable2D", "NodePoint2DSlope1")
CABLE_3D = ("ObjectANCFCable", "NodePointSlope1")
BEAM = "ObjectBeamGeometricallyExact"
EP, RXYZ, LIE = (("ObjectRigidBody", f"NodeRigidBody{frame}") for frame in ("EP", "Rxyz", "RotVecLG"))
POINT, POINT_2D, RIGID_2D = (
    ("ObjectMassPoint", "NodePoint"),
    ("ObjectMassPoint2D", "NodePoint2D"),
    ("ObjectRigidBody2D", "NodeRigidBody2D"),
)
MASS_1D, ROTOR_1D = ((name, "Node1D") for name in SCALAR_BODIES)
GROUND, GROUND_NODE = ("ObjectGround", ""), ("", "NodePointGround")
RESTING_POINT = ("ObjectMassPoint", "NodePointGround")
GENERIC_NODE = ("", "NodeGenericODE2")
FIRST_ORDER = ("ObjectGenericODE1", "NodeGenericODE1")
DATA_COORDINATES = {  # others: 3
    "ObjectConnectorRigidBodySpringDamper": 2,
    "ObjectConnectorTorsionalSpringDamper": 1,
    "ObjectContactCoordinate": 1,
    "ObjectContactSphereTorus": 4,
}


def on_markers(item: Item) -> bool:
    """Connectors, contacts, constraints, joints and loads."""
    return item.kind in ("object", "load") and any(row.type.storage in ("marker", "markers") for row in item.parameters)


def draw(rng: np.random.Generator, row: Parameter, planar: bool = False) -> Any:
    """A random value of a parameter, within its check; None: leave the default."""
    storage = row.type.storage
    if storage == "real":
        return rng.uniform(*(row.typical or (0.5, 1.5)))
    if row.effective_check in ("rotation", "orthogonal"):
        return random_rotation(rng, planar)
    if row.effective_check == "unit_vector":
        return random_direction(rng)
    if storage == "matrix6":
        root = rng.normal(size=(6, 6))
        return root @ root.T / 6 + np.eye(6)
    if storage.startswith("vector") and row.shape[0]:
        return rng.uniform(-1, 1, row.shape[0])
    return None


def random_direction(rng: np.random.Generator, planar: bool = False) -> Array:
    vector = rng.normal(size=3) * ([1, 1, 0] if planar else 1)
    return vector / np.linalg.norm(vector)


@dataclass
class Carrier:
    """Something that markers sit on."""

    body: Any = None
    nodes: list[Any] = field(default_factory=list)
    motion: Motion | None = None
    length: float = 0.0  # of a cable or beam
    centred: bool = False  # local positions count from its middle
    thin: bool = False  # points beside the axis have no position
    coordinates: int = 0  # ODE2, of all nodes
    point_mass: bool = False


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
        if not kind.resting:
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
            return self._scalar_body(body, node, motion)
        if body == "ObjectGenericODE2":
            return self._generic(reference)
        if body == "ObjectGenericODE1":
            return self._first_order()
        if body in (CABLE[0], CABLE_3D[0]):
            return self._cable(body, node, reference, motion)
        if body == BEAM:
            return self._beam(node, reference, motion)
        kind = KINDS[node]
        if kind.resting:
            reference = motion = motion.at_rest()
        number = self.node(node, reference, motion)
        made = self.mbs.AddObject(getattr(exu, body)(nodeNumber=number, **self._inertia(body)))
        self.bodies.append(made)
        point = kind.frame == "point"
        frame = replace(motion, rotation=np.eye(3)) if point else motion
        coordinates = 0 if kind.resting else len(kind.total(motion))
        return Carrier(made, [number], frame, coordinates=coordinates, point_mass=point)

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
            resting = replace(motion.at_rest(), rotation=np.eye(3))
            return Carrier(None, [self.node(name, motion, motion)], resting)
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

    def _scalar_body(self, body: str, node_type: str, motion: Motion) -> Carrier:
        rng, placed = self.rng, motion.at(self.place)
        q, v = rng.uniform(-1, 1, 2), 0.0 if self.resting else rng.uniform(-1, 1)
        start: dict[str, Any] = {"referenceCoordinates": q[:1], "initialCoordinates": q[1:]}
        if node_type == "Node1D":
            node = self.mbs.AddNode(exu.Node1D(**start, initialVelocities=[v]))
        else:
            node = self.mbs.AddNode(exu.NodeGenericODE2(numberOfODE2Coordinates=1, **start, initialCoordinates_t=[v]))
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

    def _cable(self, body: str, node: str, reference: Motion, motion: Motion) -> Carrier:
        rng, length, planar = self.rng, 1.5, KINDS[node].planar
        along = np.array([length, 0, 0])
        end = self.motion()
        end = replace(end, position=motion.point(1.1 * along), rotation=motion.rotation @ random_rotation(rng, planar))
        ends = [replace(reference, position=reference.point(along)), end]
        nodes = [self.node(node, r, m) for r, m in zip([reference, ends[0]], [motion, ends[1]], strict=True)]
        rows = {row.name: draw(rng, row) for row in ITEMS[body].parameters if row.type.storage == "real"}
        special = {"physicsLength": length, "physicsReferenceAxialStrain": 0.05, "physicsReferenceCurvature": 0.1}
        rows |= {key: value for key, value in special.items() if key in rows}
        rows |= self.options.get(body, {})
        made = self.mbs.AddObject(getattr(exu, body)(nodeNumbers=nodes, **rows))
        self.bodies.append(made)
        coordinates = 2 * len(KINDS[node].total(motion))
        return Carrier(made, nodes, motion, length, coordinates=coordinates, thin=not planar)

    def _beam(self, node: str, reference: Motion, motion: Motion) -> Carrier:
        """Of a section without any symmetry, bent and twisted already in its reference configuration."""
        rng, length = self.rng, 1.5
        section = exu.BeamSection()
        roots = rng.uniform(-0.5, 0.5, (3, 6, 6))
        stiffness, damping, inertia = (root @ root.T + np.eye(6) for root in roots)
        section.stiffnessMatrix, section.dampingMatrix, section.inertia = stiffness, damping, inertia[:3, :3]
        section.massPerLength = rng.uniform(1, 2)
        ends = [
            replace(
                self.motion(),
                position=start.point(stretch * np.array([length, 0.1, 0])),
                rotation=start.rotation @ turn,
            )
            for start, stretch, turn in ((reference, 1.0, random_rotation(rng)), (motion, 1.1, random_rotation(rng)))
        ]
        nodes = [self.node(node, r, m) for r, m in zip([reference, ends[0]], [motion, ends[1]], strict=True)]
        made = self.mbs.AddObject(
            exu.ObjectBeamGeometricallyExact(nodeNumbers=nodes, physicsLength=length, sectionData=section)
        )
        self.bodies.append(made)
        return Carrier(made, nodes, motion, length, coordinates=2 * len(KINDS[node].total(motion)), centred=True)

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
                start = -0.5 * on.length if on.centred else 0.0
                local = np.array([start + rng.uniform(0, on.length), 0 if on.thin else rng.uniform(-0.1, 0.1), 0])
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
        rows = {
            "axis0": random_direction(self.rng, self.planar),
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
            rows["axisMarker0"] = random_direction(rng, planar=True)
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
