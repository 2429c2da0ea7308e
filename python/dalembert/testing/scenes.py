"""Small random models around an item, made from its spec: bodies in rotated and moving states, markers on them, and
items that act on the markers. The [scene] tables of the specs define these nodes, markers and values."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

import dalembert as exu
from codegen.model import Item, Parameter
from codegen.scene import End, NodePlace
from dalembert._core import testing
from dalembert._tools.item_packages import item_class
from dalembert.testing.motions import EZ, ITEMS, KINDS, Array, Motion, NodeKind, Place, random_motion, random_rotation
from dalembert.testing.specs import TESTED
from dalembert.testing.trees import link_frame
from dalembert.testing.user_functions import functions_of


def output_of(read: Callable[..., Any], *arguments: Any) -> Any:
    """Return the output variable of the object; return None if a user function defines the energy asked for."""
    try:
        return read(*arguments)
    except exu.ModelError as error:
        assert "Energy is not available, because a user function defines" in str(error)
        return None


# Parameters with which an item needs one more data coordinate.
MORE_DATA = {"ObjectContactCoordinate": "impactModel"}

if TYPE_CHECKING:
    from variants import Variant

READY = [item for item in ITEMS.values() if item.ready]
UNDER_TEST = [item for item in READY if item.name in TESTED]  # those of a package, or all


def nodes_label(item: Item) -> str:
    """The nodes of a body that does not choose among types: `NodeGenericODE1`, `Points`, `RigidBodyEP+GenericODE2`."""
    types = [node.type.removeprefix("Node") for node in item.scene.nodes]
    if len(types) < 2:
        return f"Node{types[0]}" if types else ""
    return f"{types[0]}s" if len(set(types)) == 1 else "+".join(dict.fromkeys(types))


def carriers_of(item: Item) -> list[tuple[str, str]]:
    """A body on each type of node that it is made for."""
    return [(item.name, node) for node in item.nodes or [nodes_label(item)]]


def placed(end: End) -> tuple[str, tuple[str, str]]:
    """A marker and the carrier that it is on."""
    if not end.body:
        return end.marker, ("", end.node)
    return end.marker, (end.body, end.node or carriers_of(ITEMS[end.body])[0][1])


def rests(carrier: tuple[str, str]) -> bool:
    """Marker on a ground node, without equations."""
    return carrier[1] in ITEMS and "Ground" in ITEMS[carrier[1]].provides


def in_plane(carrier: tuple[str, str]) -> bool:
    types = [node.type for node in ITEMS[carrier[0]].scene.nodes] if carrier[0] else []
    return any(node in KINDS and KINDS[node].planar for node in [carrier[1], *types])


def is_ground(carrier: tuple[str, str]) -> bool:
    return carrier[0] in ITEMS and {"Ground", "Body"} <= set(ITEMS[carrier[0]].provides)


def of_one_coordinate(carrier: tuple[str, str]) -> bool:
    """A body with a frame of its own, which one coordinate moves."""
    return carrier[0] in ITEMS and not is_ground(carrier) and has_row(ITEMS[carrier[0]], "referencePosition")


def on_one_frame(carrier: tuple[str, str]) -> bool:
    """A body that moves as its node does."""
    body, node = carrier
    if not body or node not in KINDS or ITEMS[body].scene.nodes:
        return False
    return not moves_as_point(ITEMS[body]) or KINDS[node].frame == "point"


def moves_as_point(item: Item) -> bool:
    """A body without orientation."""
    return any(node in KINDS and KINDS[node].frame == "point" and not item.scene.nodes for node in item.nodes)


def has_row(item: Item, name: str) -> bool:
    return any(row.name == name for row in item.parameters)


ON_NODES = [carrier for item in READY if item.nodes for carrier in carriers_of(item)]
RESTING = [carrier for carrier in ON_NODES if rests(carrier)]
BODIES = [carrier for carrier in ON_NODES if not rests(carrier)]
RIGID = {node: carrier for carrier in reversed(BODIES) for node in carrier[1:] if on_one_frame(carrier)}  # by node


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
    return random_section(rng) if storage == "beam_section" else None


def random_section(rng: np.random.Generator) -> Any:
    """Values without symmetry."""
    section = exu.BeamSection()
    stiffness, damping, inertia = (root @ root.T + np.eye(6) for root in rng.uniform(-0.5, 0.5, (3, 6, 6)))
    section.stiffnessMatrix, section.dampingMatrix, section.inertia = stiffness, damping, inertia[:3, :3]
    section.massPerLength = rng.uniform(1, 2)
    return section


def one_for_each(values: list[Any], markers: int) -> list[Any]:
    """Return an evenly spaced selection of a list with values of markers: it includes the first and the last one."""
    return [values[round(i * (len(values) - 1) / (markers - 1))] for i in range(markers)]


def random_direction(rng: np.random.Generator, planar: bool = False) -> Array:
    vector = rng.normal(size=3) * ([1, 1, 0] if planar else 1)
    return vector / np.linalg.norm(vector)


BOX = np.array([[-0.5] * 3, [0.5] * 3])


@dataclass
class Carrier:
    """Something that markers sit on."""

    body: Any = None
    nodes: list[Any] = field(default_factory=list)
    motion: Motion | None = None
    local: Array = field(default_factory=lambda: BOX)  # bounds of local points at which loads may act
    coordinates: int = 0  # of all nodes


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
        """A body on nodes of a type, or a node alone."""
        reference, motion = self.motion(), self.motion()
        if position is not None:
            motion = replace(motion, position=position)
        if body == "":
            return self._bare_node(node, reference, motion)
        item, at = ITEMS[body], motion.at(self.place)
        if is_ground((body, node)):
            frame = {"referencePosition": at.position, "referenceRotation": at.rotation}
            return Carrier(self.mbs.AddObject(item_class(body)(**frame)), [], motion)
        if item.scene.nodes:
            return self._on_many_nodes(item, node, reference, motion)
        if of_one_coordinate((body, node)):
            return self._scalar_body(item, node, at)
        kind = KINDS[node]
        if kind.resting:
            reference = motion = motion.at_rest()
        number = self.node(node, reference, motion)
        made = self.mbs.AddObject(item_class(body)(nodeNumber=number, **self._inertia(item) | self._fixed(item)))
        self.bodies.append(made)
        point = moves_as_point(item)
        frame_motion = replace(motion, rotation=np.eye(3)) if point else motion
        coordinates = 0 if kind.resting else len(kind.total(motion))
        if point and kind.frame != "point":
            self._slopes_with_mass(number, coordinates, 2 if kind.planar else 3)
        return Carrier(made, [number], frame_motion, coordinates=coordinates, local=np.zeros((2, 3)) if point else BOX)

    def _slopes_with_mass(self, node: Any, coordinates: int, dimensions: int) -> None:
        """Values for slopes, which a cable or plate would define, if a point mass is on their node."""
        of_vectors = np.r_[0, self.rng.uniform(0.5, 1.5, coordinates // dimensions - 1)]
        mass = np.diag(np.repeat(of_vectors, dimensions))
        self.mbs.AddObject(exu.ObjectGenericODE2(nodeNumbers=[node], massMatrix=mass))

    def _fixed(self, item: Item) -> dict[str, Any]:
        """Values of the spec and of the variant."""
        alike = {name: np.kron(matrix, np.eye(3)) for name, matrix in item.scene.isotropic.items()}
        joints = {row.name for row in item.parameters if row.type.storage == "joint_types"}
        values = {
            name: [exu.JointType[joint] for joint in value] if name in joints else value
            for name, value in item.scene.values.items()
        }
        return {**values, **alike, **self.options.get(item.name, {})}

    def _inertia(self, item: Item) -> dict[str, Any]:
        """Mass, centre of mass and moments of inertia about the node, as far as the body has them."""
        rng, shapes = self.rng, {row.name: row.type.shape for row in item.parameters}
        mass, arm = rng.uniform(1, 2), rng.uniform(-0.5, 0.5, shapes.get("physicsCenterOfMass", (3,))[0])
        if "physicsInertia" not in shapes:
            return {"physicsMass": mass}
        if shapes["physicsInertia"]:
            root = rng.uniform(-0.5, 0.5, (3, 3))
            j = root @ root.T + np.eye(3) + mass * (arm @ arm * np.eye(3) - np.outer(arm, arm))
            inertia: Any = [j[0, 0], j[1, 1], j[2, 2], j[1, 2], j[0, 2], j[0, 1]]
        else:
            inertia = rng.uniform(1, 2) + mass * arm @ arm
        return {"physicsMass": mass, "physicsInertia": inertia, "physicsCenterOfMass": arm}

    def _bare_node(self, name: str, reference: Motion, motion: Motion) -> Carrier:
        if name in KINDS:
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

    def _scalar_body(self, item: Item, node_type: str, placed: Motion) -> Carrier:
        rng = self.rng
        q, v = rng.uniform(-1, 1, 2), 0.0 if self.resting else rng.uniform(-1, 1)
        start: dict[str, Any] = {"referenceCoordinates": q[:1], "initialCoordinates": q[1:]}
        rates = next(name for name in ("initialVelocities", "initialCoordinates_t") if has_row(ITEMS[node_type], name))
        sizes = {row.name: 1 for row in ITEMS[node_type].parameters if row.name.startswith("numberOf")}
        node = self.mbs.AddNode(item_class(node_type)(**sizes, **start, **{rates: [v]}))
        inertia = {row.name: rng.uniform(1, 2) for row in item.parameters if row.name.startswith("physics")}
        frame = {"referencePosition": placed.position, "referenceRotation": placed.rotation}
        made = self.mbs.AddObject(item_class(item.name)(nodeNumber=node, **frame, **inertia))
        self.bodies.append(made)
        return Carrier(made, [node], coordinates=1)

    def _on_many_nodes(self, item: Item, node: str, reference: Motion, motion: Motion) -> Carrier:
        """A body on the nodes of its spec: near their places in the reference, or in any deformed state."""
        nodes, coordinates = [], 0
        for entry in item.scene.nodes:
            name = entry.type or node
            if entry.mesh:
                nodes.append(self._mesh_node(name, entry))
                coordinates += len(entry.mesh)
                continue
            if name not in KINDS:
                nodes.append(self._generalized_node(name, entry))
                coordinates += next(value for key, value in entry.values.items() if key.startswith("numberOf"))
                continue
            start = replace(reference, position=reference.point(entry.at))
            if item.scene.bent:
                start = replace(start, rotation=start.rotation @ random_rotation(self.rng, KINDS[name].planar))
            here = self._near(start) if item.scene.small_deformations else self._deformed(motion, entry, KINDS[name])
            nodes.append(self.node(name, start, here))
            coordinates += len(KINDS[name].total(here))
        drawn = ("real", "beam_section")
        rows = {r.name: draw(self.rng, r) for r in item.parameters if r.type.storage in drawn and not r.internal}
        key = "nodeNumbers" if has_row(item, "nodeNumbers") else "nodeNumber"
        numbers = nodes if key == "nodeNumbers" else nodes[0]
        made = self.mbs.AddObject(item_class(item.name)(**{key: numbers}, **rows | self._fixed(item)))
        if item.object_type != "Object":
            self.bodies.append(made)
        if any(entry.mesh for entry in item.scene.nodes):  # a mesh that moves back as its frame moves on has no inertia
            self.mbs.AddObject(
                exu.ObjectRigidBody(physicsMass=1, physicsInertia=[1, 1, 1, 0, 0, 0], nodeNumber=nodes[0])
            )
        frame = reference if item.scene.small_deformations else motion
        if has_row(item, "linkParents"):
            frame = self._motion_of_link(made, nodes[0])
        return Carrier(made, nodes, frame, np.array(item.scene.local or BOX), coordinates)

    def _motion_of_link(self, tree: Any, node: Any) -> Motion:
        """Position of the link that carries markers."""
        values = self.mbs.GetNode(node)
        q = np.add(values["referenceCoordinates"], values["initialCoordinates"])
        link = ITEMS["MarkerKinematicTreeRigid"].scene.values["linkNumber"]
        rotation, position = link_frame(self.mbs.GetObject(tree), q, link)
        return replace(self.motion(), position=position, rotation=rotation)

    def _near(self, start: Motion) -> Motion:
        """Slightly displaced."""
        m, noise = self.motion(), 0.1 * self.rng.normal(size=3)
        return replace(m, position=start.position + noise)

    def _deformed(self, motion: Motion, entry: NodePlace, kind: NodeKind) -> Motion:
        """The node in the origin of the body moves with it, others have been pulled and turned away."""
        if not any(entry.at):
            return motion
        position = motion.point(1.1 * np.array(entry.at))
        m = self.motion()
        return replace(m, position=position, rotation=motion.rotation @ random_rotation(self.rng, kind.planar))

    def _mesh_node(self, name: str, entry: NodePlace) -> Any:
        """A node that is displaced a little in the frame of its body."""
        displacement, velocity = 0.1 * self.rng.normal(size=(2, len(entry.mesh)))
        start = {"initialCoordinates": displacement, "initialVelocities": (not self.resting) * velocity}
        return self.mbs.AddNode(item_class(name)(referenceCoordinates=entry.mesh, **start))

    def _generalized_node(self, name: str, entry: NodePlace) -> Any:
        """A node whose coordinates belong to no frame; values without a row in the spec are random."""
        n = next(value for key, value in entry.values.items() if key.startswith("numberOf"))
        rows = ("referenceCoordinates", "initialCoordinates", "initialCoordinates_t")
        drawn = {
            key: 0.1 * self.rng.uniform(-1, 1, n)
            for key in rows
            if has_row(ITEMS[name], key) and key not in entry.values
        }
        if self.resting and "initialCoordinates_t" in drawn:
            drawn["initialCoordinates_t"] = np.zeros(n)
        return self.mbs.AddNode(item_class(name)(**drawn, **entry.values))

    # ---- markers -------------------------------------------------------------------------------------------------------
    def marker(self, name: str, on: Carrier, point: Array | None = None) -> Any:
        """`point`: global position, where the marker is to sit."""
        rng, item = self.rng, ITEMS[name]
        rows: dict[str, Any] = {}
        for row in item.parameters:
            storage = row.type.storage
            if storage in ("node", "object") and not row.optional:
                rows[row.name] = on.nodes[0] if storage == "node" else on.body
        if has_row(item, "bodyNumbers"):
            rows = self._two_bodies(item, on)
        elif has_row(item, "localPosition"):
            rows["localPosition"] = self._local_position(on, point)
        elif has_row(item, "coordinate"):
            rows["coordinate"] = int(rng.integers(on.coordinates // len(on.nodes))) if on.coordinates else 0
        elif has_row(item, "rotationCoordinate"):
            rows["rotationCoordinate"] = int(rng.integers(3))
        return self.mbs.AddMarker(item_class(name)(**rows | self._fixed(item)))

    def _local_position(self, on: Carrier, point: Array | None) -> Array:
        """That of a point, or a random one."""
        local = np.array([self.rng.uniform(a, b) if a < b else a for a, b in np.transpose(on.local)])
        if point is not None and on.motion is not None:
            local = on.motion.rotation.T @ (point - on.motion.position)
        elif self.planar:
            local[2] = 0
        return local

    def _two_bodies(self, item: Item, on: Carrier) -> dict[str, Any]:
        """Rows of a marker between a carrier and another body."""
        others = [placed(end)[1] for end in item.scene.beside]
        other = self.carrier(*next(carrier for carrier in others if KINDS[carrier[1]].planar == self.planar))
        flat = np.array([1, 1, 0]) if self.planar else 1
        local = [self.rng.uniform(-0.5, 0.5, 3) * flat for _ in range(2)]
        return {
            "bodyNumbers": [on.body, other.body],
            "axis0": random_direction(self.rng, self.planar),
            "localPosition0": local[0],
            "localPosition1": local[1],
        }

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
            together = closed and markers and not item.scene.closed and "Coordinate" not in item.requested_markers
            point = self.marker_point(markers[0], carriers[0]) if together else None
            carriers.append(self.carrier(body, node, point if name and self._sits_at_node(name, body, node) else None))
            if name:
                markers.append(self.marker(name, carriers[-1], point))
        if on_markers(item):
            self._add_target(variant, carriers, markers, closed, options)
        self._finish(item, carriers, variant.functions)
        self.mbs.Assemble()
        if closed:
            self._close(item)

    def _sits_at_node(self, marker: str, body: str, node: str) -> bool:
        """Whether a marker can be brought to a point only together with its carrier."""
        long = bool(body and ITEMS[body].scene.local)
        return long or has_row(ITEMS[marker], "nodeNumber") or (node in KINDS and KINDS[node].frame == "point")

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
        rows = {key: value for key, value in rows.items() if value is not None} | item.scene.values | options
        rows |= {key: one_for_each(values, len(markers)) for key, values in item.scene.per_marker.items()}
        # lists of markers besides: those of the second and all further places
        lists = [row.name for row in item.parameters if row.type.storage == "markers"]
        rows |= {name: markers[1:] for name in lists if name != "markerNumbers"}
        if has_row(item, "scalingMarker0"):
            rows |= self._coordinate_vector(carriers, variant.functions)
        if item.scene.nodes:
            rows["nodeNumbers"] = [
                self._generalized_node(entry.type, entry) if entry.below < 0 else carriers[entry.below].nodes[-1]
                for entry in item.scene.nodes
            ]
        if closed and "rotationMarker1" in rows:
            first, second = (c.motion.rotation for c in carriers if c.motion is not None)
            rows["rotationMarker1"] = second.T @ first @ rows["rotationMarker0"]
        if has_row(item, "normalMarker1"):
            rows["axisMarker0"] = random_direction(rng, planar=True)
            first, second = (c.motion.rotation for c in carriers if c.motion is not None)
            rows["normalMarker1"] = second.T @ first @ np.cross(EZ, rows["axisMarker0"])
        if "loadVector" in rows and not rows.get("bodyFixed"):
            rows["loadVector"] = self.place.turn @ rows["loadVector"]
        if variant.data:
            n = item.scene.data + (rows.get(MORE_DATA.get(item.name, ""), 0) > 0)
            rows["nodeNumber"] = self.mbs.AddNode(
                exu.NodeGenericData(numberOfDataCoordinates=n, initialCoordinates=np.zeros(n))
            )
        if variant.functions:
            rows |= functions_of(item, rows)
        if item.kind == "load":
            self.target = ("Load", self.mbs.AddLoad(item_class(item.name)(markerNumber=markers[0], **rows)))
        else:
            self.target = ("Object", self.mbs.AddObject(item_class(item.name)(markerNumbers=markers, **rows)))

    def _coordinate_vector(self, carriers: list[Carrier], functions: bool) -> dict[str, Any]:
        """Two equations on all coordinates."""
        rng, sizes = self.rng, [carrier.coordinates for carrier in carriers]
        names = ("scalingMarker0", "scalingMarker1", "quadraticTermMarker0", "quadraticTermMarker1")
        made: dict[str, Any] = {name: rng.uniform(-1, 1, (2, n)) for name, n in zip(names, 2 * sizes, strict=True) if n}
        made["offset"] = rng.uniform(-1, 1, 2)
        if functions:
            made = {"scalingMarker0": np.zeros((2, sizes[0])), "scalingMarker1": np.zeros((2, sizes[1]))}
        return made

    def _close(self, item: Item) -> None:
        """Choose the prescribed values of a constraint such that the present state fulfils it."""
        for parameter, output in item.scene.closed.items():
            if output == "gap":
                rows = self.mbs.systemData.GetObjectLTGAE(self.target[1])
                gap = testing.gaps(self.mbs, testing.State(self.mbs))[rows]
                before = self.mbs.GetObjectParameter(self.target[1], parameter)
                value = before + (gap if np.ndim(before) else gap[0])
            else:
                value = self.mbs.GetObjectOutput(self.target[1], getattr(exu.OutputVariableType, output))
            self.mbs.SetObjectParameter(self.target[1], parameter, value)

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
