"""Open chains and trees of rigid bodies as kinematic trees: treeDynamics.RecogniseTrees.

Bodies that joints of one coordinate carry, one after the other from the ground on, become links; what acts on the
bodies then acts on the links. Items keep their numbers: in the place of bodies, their nodes and joints are ground items
that nobody sees. Joints that close loops, and all that has no counterpart among links, stay as they are.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._core import (
    ConfigurationType,
    JointType,
    MainSystem,
    MarkerIndex,
    Matrix3DList,
    NodeIndex,
    ObjectIndex,
    OutputVariableType,
    Vector3DList,
)
from dalembert._geometry.inertia import RigidBodyInertia
from dalembert.graphics import Move

GROUND = -1
CLOSED = 1e-6  # m and rad, between the markers of a joint
_LISTS = {"node": NodeIndex, "object": ObjectIndex, "marker": MarkerIndex}
_FREE_AXES = {"JointRevoluteZ": 5, "JointPrismaticX": 0}  # three translations, then three rotations
# What links tell of themselves, and which of it does not depend on the axes of the link.
_OUTPUTS = {
    getattr(OutputVariableType, name): name
    in {"Position", "Displacement", "Velocity", "Acceleration", "AngularVelocity"}
    for name in (
        *("Position", "Displacement", "Velocity", "VelocityLocal", "Acceleration", "AccelerationLocal"),
        *("Rotation", "RotationMatrix", "AngularVelocity", "AngularVelocityLocal", "AngularAcceleration"),
    )
}
_PLACES = {"BodyRigid", "BodyPosition", "NodeRigid", "NodePosition"}  # markers that links have


@dataclass
class Joint:
    """A joint of one coordinate, from a body (or GROUND) to another; ends are places and axes in their frames."""

    number: int
    free: int  # of its six axes
    bodies: tuple[int, int]
    places: tuple[FloatArray, FloatArray]
    axes: tuple[FloatArray, FloatArray]

    def backwards(self) -> Joint:
        """Return it as it is seen from the other body."""
        return Joint(self.number, self.free, self.bodies[::-1], self.places[::-1], self.axes[::-1])


@dataclass
class Link:
    """A body in a tree: its frame has the origin on the joint and an axis along that of the joint."""

    body: int
    joint: Joint
    origin: FloatArray  # in the frame of the body
    turn: FloatArray  # axes of the link, in those of the body
    sign: float  # of the coordinate, as the axis may point backwards

    @property
    def axis(self) -> int:
        """The axis of the link along which the joint lies."""
        along = self.turn.T @ self.joint.axes[1][:, self.joint.free % 3]
        return int(np.abs(along).argmax())

    @property
    def kind(self) -> JointType:
        return JointType((4 if self.joint.free < 3 else 1) + self.axis)


@dataclass
class Tree:
    """Links in the order of their numbers."""

    links: list[Link] = field(default_factory=list)

    def number(self, body: int) -> int:
        return next(i for i, link in enumerate(self.links) if link.body == body)


def _references(value: Any) -> Iterator[tuple[str, int]]:
    """Yield the kinds and numbers of items in a parameter."""
    for kind, index in _LISTS.items():
        if isinstance(value, index):
            yield kind, int(value)
    if isinstance(value, (list, tuple)):
        for entry in value:
            yield from _references(entry)


class Model:
    """The items of a system as dictionaries, and who refers to whom."""

    def __init__(self, mbs: MainSystem) -> None:
        self.mbs = mbs
        self.entries = mbs.GetDictionary()
        self.users: dict[tuple[str, int], list[tuple[str, int]]] = {}
        for kind in ("node", "object", "marker", "load", "sensor"):
            for i, item in enumerate(self.items(kind)):
                for reference in (found for value in item.values() for found in _references(value)):
                    self.users.setdefault(reference, []).append((kind, i))

    def items(self, kind: str) -> list[dict[str, Any]]:
        found: list[dict[str, Any]] = self.entries[f"{kind}List"]
        return found

    def users_of(self, kind: str, i: int) -> list[tuple[str, dict[str, Any], int]]:
        return [(what, self.items(what)[k], k) for what, k in self.users.get((kind, i), [])]

    def body_of(self, marker: int) -> int | None:
        """Return the rigid body that a marker is on, GROUND, or None for any other place."""
        item = self.items("marker")[marker]
        if item["markerType"] == "NodeRigid":
            return next((k for kind, body, k in self.users_of("node", int(item["nodeNumber"])) if _is_body(body)), None)
        if item["markerType"] != "BodyRigid":
            return None
        body = self.items("object")[int(item["bodyNumber"])]
        if body["objectType"] == "Ground":
            return GROUND
        return int(item["bodyNumber"]) if _is_body(body) else None

    def place_of(self, marker: int) -> tuple[FloatArray, FloatArray]:
        """Return place and axes of a marker in the frame of its body; on ground, in the global frame."""
        item = self.items("marker")[marker]
        local = np.asarray(item.get("localPosition", np.zeros(3)))
        if self.body_of(marker) != GROUND:
            return local, np.eye(3)
        ground = self.items("object")[int(item["bodyNumber"])]
        A = np.asarray(ground["referenceRotation"])
        return np.asarray(ground["referencePosition"]) + A @ local, A

    def of_node(self, body: int, variable: str, configuration: ConfigurationType) -> FloatArray:
        """Return an output of the node of a body."""
        node = self.items("object")[body]["nodeNumber"]
        return np.asarray(self.mbs.GetNodeOutput(node, getattr(OutputVariableType, variable), configuration))

    def gravity(self, body: int) -> FloatArray:
        """Return the sum of loads that are proportional to the mass of a body."""
        total = np.zeros(3)
        for kind, marker, k in self.users_of("object", body):
            if kind == "marker" and marker["markerType"] == "BodyMass":
                total += sum((np.asarray(load["loadVector"]) for _, load, _ in self.users_of("marker", k)), np.zeros(3))
        return total


def _is_body(item: dict[str, Any]) -> bool:
    return item.get("objectType") == "RigidBody"


# ---- what can be part of a tree --------------------------------------------------------------------------------------


def _is_weight(load: dict[str, Any]) -> bool:
    return load.get("loadType") == "MassProportional" and not load["loadVectorUserFunction"]


def _turns(kind: str, user: dict[str, Any], i: int) -> bool:
    """Return whether what uses a marker can be given in other axes of the body."""
    if kind == "load":
        return not user.get("bodyFixed") or not user["loadVectorUserFunction"]
    at = [int(marker) for marker in user.get("markerNumbers", [])]
    if kind == "object" and user["objectType"] == "ConnectorLinearSpringDamper":
        return at.index(i) != 0
    positions = {"ConnectorSpringDamper", "ConnectorDistance", "ConnectorCartesianSpringDamper", "JointSpherical"}
    return kind == "object" and (f"rotationMarker{at.index(i)}" in user or user["objectType"] in positions)


def _has_counterpart(model: Model, body: int, turned: bool) -> bool:
    """Return whether all that refers to a body, or to its node, can be on a link, whose axes may be others."""
    item = model.items("object")[body]
    node = int(item["nodeNumber"])
    if item["VgraphicsDataUserFunction"]:
        return False
    for kind, user, i in [*model.users_of("object", body), *model.users_of("node", node)]:
        if kind == "object" and i == body:
            continue
        if kind == "sensor":
            kept = user["sensorType"] in {"Body", "Node"} and user["outputVariableType"] in _OUTPUTS
            kept = kept and (not turned or _OUTPUTS[user["outputVariableType"]])
        elif kind != "marker":
            kept = False
        elif user["markerType"] == "BodyMass":
            kept = all(_is_weight(load) for _, load, _ in model.users_of("marker", i))
        else:
            users = model.users_of("marker", i)
            kept = user["markerType"] in _PLACES and (
                not turned or all(_turns(what, other, i) for what, other, _ in users)
            )
        if not kept:
            return False
    return True


def _joints(model: Model) -> list[Joint]:
    """Return all ideal joints of one coordinate between rigid bodies, or between one of them and the ground."""
    found = []
    for number, item in enumerate(model.items("object")):
        kind = item["objectType"]
        if kind == "JointGeneric" and not item["offsetUserFunction"] and sum(item["constrainedAxes"]) == 5:
            free = list(item["constrainedAxes"]).index(0)
        elif kind in _FREE_AXES:
            free = _FREE_AXES[kind]
        else:
            continue
        markers = [int(marker) for marker in item["markerNumbers"]]
        bodies = [model.body_of(marker) for marker in markers]
        if not item["activeConnector"] or None in bodies or bodies[0] == bodies[1] or model.users_of("object", number):
            continue
        (place0, own0), (place1, own1) = (model.place_of(marker) for marker in markers)
        axes = own0 @ np.asarray(item["rotationMarker0"]), own1 @ np.asarray(item["rotationMarker1"])
        found.append(Joint(number, free, (bodies[0], bodies[1]), (place0, place1), axes))  # type: ignore[arg-type]
    return found


def _link(joint: Joint) -> Link:
    """Return the link that a joint carries, in the axes of the body if the joint is along one of these."""
    axes = joint.axes[1]
    along = axes[:, joint.free % 3]
    k = int(np.abs(along).argmax())
    aligned = bool(abs(along[k]) > 1 - 1e-14)
    return Link(
        joint.bodies[1],
        joint,
        joint.places[1],
        np.eye(3) if aligned else axes,
        float(np.sign(along[k])) if aligned else 1.0,
    )


def _trees(model: Model) -> list[Tree]:
    """Return trees from the ground on: of each body the shortest way."""
    joints, taken, trees = _joints(model), set[int](), list[Tree]()

    def next_links(body: int) -> Iterator[Link]:
        for joint in joints:
            seen = joint if joint.bodies[0] == body else joint.backwards() if joint.bodies[1] == body else None
            if seen is None or seen.bodies[1] == GROUND or seen.bodies[1] in taken:
                continue
            link = _link(seen)
            if _has_counterpart(model, link.body, turned=not np.array_equal(link.turn, np.eye(3))):
                taken.add(link.body)
                yield link

    for root in list(next_links(GROUND)):
        tree = Tree([root])
        for link in tree.links:  # grows meanwhile
            tree.links.extend(next_links(link.body))
        trees.append(tree)
    return trees


# ---- parameters of trees ---------------------------------------------------------------------------------------------


def _motion(model: Model, body: int, configuration: ConfigurationType) -> tuple[FloatArray, ...]:
    """Return position, axes, velocity and angular velocity of a body."""
    if body == GROUND:
        return np.zeros(3), np.eye(3), np.zeros(3), np.zeros(3)
    values = [
        model.of_node(body, name, configuration)
        for name in ("Position", "RotationMatrix", "Velocity", "AngularVelocity")
    ]
    return values[0], values[1].reshape(3, 3), values[2], values[3]


def _coordinate(model: Model, link: Link, configuration: ConfigurationType) -> tuple[float, float, float]:
    """Return coordinate and rate of a joint, and how far it is open."""
    joint = link.joint
    (p0, A0, v0, w0), (p1, A1, v1, w1) = (_motion(model, body, configuration) for body in joint.bodies)
    J0, J1 = A0 @ joint.axes[0], A1 @ joint.axes[1]
    r0, r1 = A0 @ joint.places[0], A1 @ joint.places[1]
    k, apart = joint.free % 3, J0.T @ (p1 + r1 - p0 - r0)
    relative, y, z = J0.T @ J1, (k + 1) % 3, (k + 2) % 3
    turned = np.arctan2(relative[z, y], relative[y, y])
    if joint.free < 3:
        q, rate = apart[k], J0[:, k] @ (v1 + np.cross(w1, r1) - v0 - np.cross(w0, p1 + r1 - p0))
        rest = np.delete(apart, k), relative - np.eye(3)
    else:
        q, rate = turned, J0[:, k] @ (w1 - w0)
        rest = apart, relative[:, k] - np.eye(3)[:, k]
    return float(link.sign * q), float(link.sign * rate), max(float(np.abs(part).max()) for part in rest)


def _inertia(item: dict[str, Any], link: Link) -> RigidBodyInertia:
    J = np.asarray(item["physicsInertia"])
    tensor = np.array([[J[0], J[5], J[4]], [J[5], J[1], J[3]], [J[4], J[3], J[2]]])
    com = np.asarray(item["physicsCenterOfMass"])
    about = RigidBodyInertia(item["physicsMass"], tensor, com, inertiaTensorAtCOM=False)
    back = np.eye(4)
    back[:3, :3], back[:3, 3] = link.turn.T, -link.turn.T @ link.origin
    return about.Transformed(back)


def _state(model: Model, tree: Tree) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return coordinates of the joints in the reference configuration, initial displacements, and rates."""
    rows = []
    for link in tree.links:
        q, rate, opening = _coordinate(model, link, ConfigurationType.Initial)
        if opening > CLOSED:
            name = model.items("object")[link.joint.number]["name"]
            raise ValueError(
                f"RecogniseTrees: joint '{name}' (object {link.joint.number}) is open by {opening:.3g} at the start; "
                "place the bodies so that their joints are closed"
            )
        reference = _coordinate(model, link, ConfigurationType.Reference)[0]
        moved = q - reference
        if link.joint.free >= 3:
            moved = (moved + np.pi) % (2 * np.pi) - np.pi
        rows.append((reference, moved, rate))
    reference, moved, rates = np.array(rows).T
    return reference, moved, rates


def _weights(model: Model, tree: Tree) -> FloatArray:
    """Return gravity of all links; none if it is not the same for all."""
    all_weights = np.array([model.gravity(link.body) for link in tree.links])
    return (
        all_weights[0]
        if np.array_equal(all_weights, np.broadcast_to(all_weights[0], all_weights.shape))
        else np.zeros(3)
    )


def _parameters(model: Model, tree: Tree, node: NodeIndex) -> dict[str, Any]:
    parents, transformations, offsets, inertias, drawn = [], [], [], [], []
    for link in tree.links:
        base, item = link.joint.bodies[0], model.items("object")[link.body]
        parents.append(-1 if base == GROUND else tree.number(base))
        carrier = None if base == GROUND else tree.links[parents[-1]]
        turn, origin = (np.eye(3), np.zeros(3)) if carrier is None else (carrier.turn, carrier.origin)
        transformations.append(turn.T @ link.joint.axes[0] @ link.joint.axes[1].T @ link.turn)
        offsets.append(turn.T @ (link.joint.places[0] - origin))
        inertias.append(_inertia(item, link))
        shapes = item["VgraphicsData"] if item["Vshow"] else []
        drawn.append([Move(shape, -link.turn.T @ link.origin, link.turn.T) for shape in shapes])
    return {
        "objectType": "KinematicTree",
        "name": f"tree of {model.items('object')[tree.links[0].body]['name']}",
        "nodeNumber": node,
        "gravity": _weights(model, tree),
        "baseOffset": np.zeros(3),
        "jointTypes": [link.kind for link in tree.links],
        "linkParents": parents,
        "jointTransformations": Matrix3DList(transformations),
        "jointOffsets": Vector3DList(offsets),
        "linkInertiasCOM": Matrix3DList([inertia.InertiaCOM() for inertia in inertias]),
        "linkCOMs": Vector3DList([inertia.COM() for inertia in inertias]),
        "linkMasses": [inertia.Mass() for inertia in inertias],
        "VgraphicsDataList": drawn,
    }


# ---- the other system ------------------------------------------------------------------------------------------------


def _turn_user(user: dict[str, Any], marker: int, turn: FloatArray) -> None:
    """Give what uses a marker in the axes of the link."""
    at = [int(number) for number in user.get("markerNumbers", [])]
    if user.get("bodyFixed"):
        user["loadVector"] = turn.T @ user["loadVector"]
    elif marker in at and f"rotationMarker{at.index(marker)}" in user:
        user[f"rotationMarker{at.index(marker)}"] = turn.T @ user[f"rotationMarker{at.index(marker)}"]


def _hidden(item: dict[str, Any], **values: Any) -> dict[str, Any]:
    return {"name": item["name"], **values, "Vshow": False}


def _replace(model: Model, tree: Tree, number: ObjectIndex) -> None:
    """Put the links in the place of their bodies, for all that refers to these."""
    common = _weights(model, tree)
    for i, link in enumerate(tree.links):
        body = model.items("object")[link.body]
        node = int(body["nodeNumber"])
        on_link = {"objectNumber": number, "linkNumber": i}
        com = link.turn.T @ (np.asarray(body["physicsCenterOfMass"]) - link.origin)
        for kind, user, k in [*model.users_of("object", link.body), *model.users_of("node", node)]:
            local = link.turn.T @ (np.asarray(user.get("localPosition", np.zeros(3))) - link.origin)
            if kind == "sensor":
                kept = {
                    key: user[key]
                    for key in ("name", "writeToFile", "fileName", "outputVariableType", "storeInternal", "Vshow")
                }
                model.items(kind)[k] = {"sensorType": "KinematicTree", **kept, **on_link, "localPosition": local}
            elif kind == "marker" and user["markerType"] == "BodyMass":
                shared = bool(np.any(common))
                at_rest = _hidden(user, markerType="NodePosition", nodeNumber=NodeIndex(node))
                at_com = {"markerType": "KinematicTreeRigid", "name": user["name"], **on_link, "localPosition": com}
                model.items(kind)[k] = at_rest if shared else at_com
                for _, load, m in model.users_of(kind, k):
                    force = np.zeros(3) if shared else body["physicsMass"] * np.asarray(load["loadVector"])
                    model.items("load")[m] = {
                        **_hidden(load, loadType="ForceVector", markerNumber=MarkerIndex(k), loadVector=force),
                    }
            elif kind == "marker":
                for _, other, _ in model.users_of(kind, k):
                    _turn_user(other, k, link.turn)
                model.items(kind)[k] = {
                    "markerType": "KinematicTreeRigid",
                    **{key: user[key] for key in ("name", "Vshow")},
                    **on_link,
                    "localPosition": local,
                }
        place = model.items("node")[node]["referenceCoordinates"][:3]
        model.items("node")[node] = _hidden(
            model.items("node")[node], nodeType="PointGround", referenceCoordinates=place
        )


def _hide(items: list[dict[str, Any]], numbers: Sequence[int]) -> None:
    for i in numbers:
        items[i] = _hidden(items[i], objectType="Ground")


def RecogniseTrees(mbs: MainSystem) -> MainSystem:
    """Return a copy of an assembled system in which open chains and trees of rigid bodies are kinematic trees.

    Bodies that joints of one coordinate carry (RevoluteJointZ, PrismaticJointX, GenericJoint with one free axis), one
    after the other from the ground on, become links, in the state of the initial configuration. Their motion then takes
    as many coordinates as joints and, in explicit solvers, a number of operations that grows with that of the links.
    Joints that close loops stay as constraints. Markers, loads and sensors keep their numbers and act on the links;
    where bodies, their nodes and joints were, there are ground items. A body stays as it is if something refers to it
    that links do not have, such as a sensor of its coordinates, a marker of its node's coordinates, or a load of weight
    with a user function; so does a joint that a sensor measures. Weight becomes the gravity of the tree.
    """
    model = Model(mbs)
    trees = _trees(model)
    added = []
    for k, tree in enumerate(trees):
        node = NodeIndex(len(model.items("node")) + k)
        reference, moved, rates = _state(model, tree)
        coordinates = {
            "nodeType": "GenericODE2",
            "referenceCoordinates": reference,
            "initialCoordinates": moved,
            "initialCoordinates_t": rates,
            "numberOfODE2Coordinates": len(tree.links),
        }
        added.append((coordinates, _parameters(model, tree, node)))
    first = len(model.items("object"))
    for k, tree in enumerate(trees):
        _replace(model, tree, ObjectIndex(first + k))
    for tree in trees:
        _hide(model.items("object"), [number for link in tree.links for number in (link.body, link.joint.number)])
    for coordinates, parameters in added:
        model.items("node").append(coordinates | {"name": f"coordinates of {parameters['name']}"})
        model.items("object").append(parameters)
    made = MainSystem()
    made.SetDictionary(model.entries)
    return made
