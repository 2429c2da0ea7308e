"""Open chains and trees of rigid bodies as kinematic trees: treeDynamics.RecogniseTrees.

Bodies that revolute, prismatic, spherical and fixed joints carry, one after the other, become links; what acts on the
bodies then acts on the links. Items keep their numbers: in the place of bodies, their nodes and joints are ground items
that nobody sees. Joints that close loops, and all that has no counterpart among links, stay as they are.

Joints of trees have one coordinate. Spherical joints are three of them, one after the other, and bodies that nothing
holds stand on six; links between these have no mass.
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
from dalembert._geometry.three_turns import ThreeTurns
from dalembert._solving.quiet import require_system
from dalembert.graphics import Move

GROUND = -1
BEFORE = -2  # the link before, as parent
CLOSED = 1e-6  # m and rad, between the markers of a joint
_LISTS = {"node": NodeIndex, "object": ObjectIndex, "marker": MarkerIndex}
ROTATIONS, ALL_AXES = (3, 4, 5), (0, 1, 2, 3, 4, 5)  # of joints: three translations, then three rotations
_FREE_AXES = {"JointRevoluteZ": (5,), "JointPrismaticX": (0,), "JointSpherical": ROTATIONS}
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
_OF_GROUND = {"Position", "Displacement", "Velocity", "Rotation", "RotationMatrix", "AngularVelocity"}


@dataclass
class Joint:
    """A joint from a body (or GROUND) to another; ends are places and axes in their frames."""

    number: int  # of the object; -1: nothing holds the body
    free: tuple[int, ...]  # of its six axes: one, ROTATIONS, ALL_AXES, or none
    bodies: tuple[int, int]
    places: tuple[FloatArray, FloatArray]
    axes: tuple[FloatArray, FloatArray]

    def backwards(self) -> Joint:
        """Return it as it is seen from the other body."""
        return Joint(self.number, self.free, self.bodies[::-1], self.places[::-1], self.axes[::-1])

    def body_on_carrier(self) -> tuple[FloatArray, FloatArray]:
        """Return axes and origin of the second body in the first, where no axis has moved."""
        turn = self.axes[0] @ self.axes[1].T
        return turn, self.places[0] - turn @ self.places[1]


@dataclass
class Seat:
    """Where a body is in a tree: on the frame of a link, which is told in the frame of the body."""

    body: int
    joint: Joint
    origin: FloatArray  # on the joint that moves the link
    turn: FloatArray  # axes of the link, in those of the body
    sign: float = 1.0  # of the coordinate, as the axis may point backwards
    link: int = GROUND

    @property
    def axis(self) -> int:
        """The axis of the link along which a joint of one coordinate lies."""
        along = self.turn.T @ self.joint.axes[1][:, self.joint.free[0] % 3]
        return int(np.abs(along).argmax())


_ON_GROUND = Seat(GROUND, Joint(-1, (), (GROUND, GROUND), (), ()), np.zeros(3), np.eye(3))  # type: ignore[arg-type]


@dataclass
class TreeLink:
    """One link with its joint, and the state of that: reference value, displacement and rate."""

    kind: JointType
    parent: int
    transformation: FloatArray
    offset: FloatArray
    state: tuple[float, float, float]


@dataclass
class Tree:
    """Bodies in an order in which carriers come first, and the links that they make."""

    seats: list[Seat] = field(default_factory=list)
    links: list[TreeLink] = field(default_factory=list)


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
        if item["markerType"] in {"NodeRigid", "NodePosition"}:
            return next((k for kind, body, k in self.users_of("node", int(item["nodeNumber"])) if _is_body(body)), None)
        if item["markerType"] not in {"BodyRigid", "BodyPosition"}:
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


def _has_counterpart(model: Model, body: int, turned: bool, grounded: bool = False) -> bool:
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
            kept = kept and (not grounded or user["outputVariableType"].name in _OF_GROUND)
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


def _free_axes(item: dict[str, Any]) -> tuple[int, ...] | None:
    """Return the axes along and about which an ideal joint moves; None if trees have no such joint."""
    kind = item["objectType"]
    if kind == "JointGeneric" and not item["offsetUserFunction"]:
        free = tuple(axis for axis in ALL_AXES if not item["constrainedAxes"][axis])
        return free if len(free) < 2 or free == ROTATIONS else None
    if kind == "JointSpherical" and not all(item["constrainedAxes"]):
        return None
    return _FREE_AXES.get(kind)


def _joints(model: Model) -> list[Joint]:
    """Return all joints that trees have, between rigid bodies, or between one of them and the ground."""
    found = []
    for number, item in enumerate(model.items("object")):
        free = _free_axes(item)
        if free is None:
            continue
        markers = [int(marker) for marker in item["markerNumbers"]]
        bodies = [model.body_of(marker) for marker in markers]
        if not item["activeConnector"] or None in bodies or bodies[0] == bodies[1] or model.users_of("object", number):
            continue
        (place0, own0), (place1, own1) = (model.place_of(marker) for marker in markers)
        axes = tuple(own @ np.asarray(item.get(f"rotationMarker{k}", np.eye(3))) for k, own in enumerate((own0, own1)))
        found.append(Joint(number, free, (bodies[0], bodies[1]), (place0, place1), axes))  # type: ignore[arg-type]
    return found


def _nearly(turn: FloatArray) -> FloatArray:
    """Return a rotation matrix, or the unit matrix if it is that up to rounding."""
    return np.eye(3) if np.abs(turn - np.eye(3)).max() < 1e-14 else turn


def _seat(joint: Joint, carrier: Seat) -> Seat:
    """Return how a joint carries a body, if it can in the axes of the body."""
    body = joint.bodies[1]
    if joint.free == ALL_AXES:
        return Seat(body, joint, np.zeros(3), np.eye(3))
    if joint.free == ROTATIONS:
        return Seat(body, joint, joint.places[1], np.eye(3))
    if not joint.free:
        turn, origin = joint.body_on_carrier()
        return Seat(body, joint, turn.T @ (carrier.origin - origin), _nearly(turn.T @ carrier.turn))
    axes = joint.axes[1]
    along = axes[:, joint.free[0] % 3]
    k = int(np.abs(along).argmax())
    aligned = bool(abs(along[k]) > 1 - 1e-14)
    turn, sign = (np.eye(3), float(np.sign(along[k]))) if aligned else (axes, 1.0)
    return Seat(body, joint, joint.places[1], turn, sign)


class _Search:
    """Finds trees: of each body the shortest way to the ground, or to a body that floats."""

    def __init__(self, model: Model) -> None:
        self.model, self.joints, self.taken = model, _joints(model), set[int]()

    def carried_by(self, seat: Seat, on_ground: bool = False, fixed: bool = True) -> Iterator[Seat]:
        """Yield the bodies on a body (or on ground) that are not in a tree yet, which they are from now on.

        On what does not move: those that are fixed there, or those that are not.
        """
        for joint in self.joints:
            ends = joint.bodies
            seen = joint if ends[0] == seat.body else joint.backwards() if ends[1] == seat.body else None
            if seen is None or seen.bodies[1] == GROUND or seen.bodies[1] in self.taken:
                continue
            if on_ground and bool(seen.free) == fixed:
                continue
            found, grounded = _seat(seen, seat), on_ground and fixed
            turned = not grounded and not np.array_equal(found.turn, np.eye(3))
            if _has_counterpart(self.model, found.body, turned, grounded):
                self.taken.add(found.body)
                yield found

    def grounded(self) -> list[Seat]:
        """Return the bodies that are fixed to the ground."""
        found = [_ON_GROUND]
        for seat in found:  # grows meanwhile
            found.extend(self.carried_by(seat, on_ground=True))
        return found[1:]

    def tree_on(self, root: Seat) -> Tree:
        tree = Tree([root])
        for seat in tree.seats:  # grows meanwhile
            tree.seats.extend(self.carried_by(seat))
        return tree

    def floating(self) -> Iterator[Tree]:
        """Yield trees that nothing holds; each stands on the body with the most joints."""
        count = {body: sum(body in joint.bodies for joint in self.joints) for body in self.bodies()}
        for body in sorted(count, key=lambda body: (-count[body], body)):
            if body in self.taken or not _has_counterpart(self.model, body, turned=False):
                continue
            self.taken.add(body)
            zero, one = (np.zeros(3), np.zeros(3)), (np.eye(3), np.eye(3))
            tree = self.tree_on(_seat(Joint(-1, ALL_AXES, (GROUND, body), zero, one), _ON_GROUND))
            if len(tree.seats) > 1:
                yield tree
            else:
                self.taken.remove(body)

    def bodies(self) -> set[int]:
        return {body for joint in self.joints for body in joint.bodies} - {GROUND}


def _trees(model: Model) -> tuple[list[Seat], list[Tree]]:
    """Return the bodies that are fixed to the ground, and the trees, those on the ground first."""
    search = _Search(model)
    grounded = search.grounded()
    roots = [
        root for seat in [_ON_GROUND, *grounded] for root in list(search.carried_by(seat, on_ground=True, fixed=False))
    ]
    trees = [search.tree_on(root) for root in roots]
    trees.extend(search.floating())
    places = {seat.body: seat for seat in grounded} | {GROUND: _ON_GROUND}
    for tree in trees:
        _make_links(model, tree, dict(places))
    return grounded, trees


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


def _opened(model: Model, joint: Joint, configuration: ConfigurationType) -> tuple[FloatArray, FloatArray, float]:
    """Return how the second end of a joint lies in the first, place and axes, and how far the joint is open."""
    (p0, A0, _, _), (p1, A1, _, _) = (_motion(model, body, configuration) for body in joint.bodies)
    J0, J1 = A0 @ joint.axes[0], A1 @ joint.axes[1]
    apart, relative = J0.T @ (p1 + A1 @ joint.places[1] - p0 - A0 @ joint.places[0]), J0.T @ J1
    held = [axis for axis in (0, 1, 2) if axis not in joint.free]
    rest = [apart[held]]
    if len(turning := [axis - 3 for axis in joint.free if axis >= 3]) < 2:
        along = turning or [0, 1, 2]
        rest.append((relative - np.eye(3))[:, along].ravel())
    return apart, relative, max((float(np.abs(part).max()) for part in rest if part.size), default=0.0)


def _coordinate(model: Model, seat: Seat, configuration: ConfigurationType) -> tuple[float, float]:
    """Return coordinate and rate of a joint of one coordinate."""
    joint = seat.joint
    (p0, A0, v0, w0), (p1, A1, v1, w1) = (_motion(model, body, configuration) for body in joint.bodies)
    apart, relative, _ = _opened(model, joint, configuration)
    k = joint.free[0] % 3
    along, y, z = (A0 @ joint.axes[0])[:, k], (k + 1) % 3, (k + 2) % 3
    if joint.free[0] < 3:
        r1 = A1 @ joint.places[1]
        q, rate = apart[k], along @ (v1 + np.cross(w1, r1) - v0 - np.cross(w0, p1 + r1 - p0))
    else:
        q, rate = np.arctan2(relative[z, y], relative[y, y]), along @ (w1 - w0)
    return float(seat.sign * q), float(seat.sign * rate)


def _turning_links(model: Model, seat: Seat, carrier: Seat, parent: int, offset: FloatArray) -> list[TreeLink]:
    """Return three links, the last of which has the axes of the body."""
    body = seat.joint.bodies
    states = []
    for configuration in (ConfigurationType.Initial, ConfigurationType.Reference):
        (_, A0, _, w0), (_, A1, _, w1) = (_motion(model, number, configuration) for number in body)
        frame = A0 @ carrier.turn
        states.append((frame, frame.T @ A1 @ seat.turn, frame.T @ (w1 - w0)))
    (frame, relative, spin), (_, at_rest, _) = states
    weight = model.gravity(seat.body) if carrier.link == GROUND else np.zeros(3)
    up = -frame.T @ weight / np.linalg.norm(weight) if weight.any() else np.zeros(3)
    item, floats = model.items("object")[seat.body], seat.joint.free == ALL_AXES
    arm = np.zeros(3) if floats else np.asarray(item["physicsCenterOfMass"]) - seat.origin
    pull = item["physicsMass"] * np.linalg.norm(weight) * np.linalg.norm(arm)  # Nm, at most
    governs = spin @ spin * np.sum(item["physicsInertia"][:3]) / 3 > 4 * pull
    turns = ThreeTurns.of(relative, spin if governs else np.zeros(3), up, arm)
    angles, reference = turns.angles(relative), turns.angles(at_rest)
    moved = (angles - reference + np.pi) % (2 * np.pi) - np.pi
    rates = turns.rates(angles, spin)
    return [
        TreeLink(
            JointType(1 + axis),
            parent if i == 0 else BEFORE,
            turns.base if i == 0 else np.eye(3),
            offset if i == 0 else np.zeros(3),
            (float(reference[i]), float(moved[i]), float(rates[i])),
        )
        for i, axis in enumerate(turns.axes)
    ]


def _sliding_links(model: Model, seat: Seat) -> list[TreeLink]:
    """Return three links that carry the origin of a body along the global axes."""
    p, _, v, _ = _motion(model, seat.body, ConfigurationType.Initial)
    reference, _, _, _ = _motion(model, seat.body, ConfigurationType.Reference)
    return [
        TreeLink(
            JointType(4 + i),
            GROUND if i == 0 else BEFORE,
            np.eye(3),
            np.zeros(3),
            (float(reference[i]), float(p[i] - reference[i]), float(v[i])),
        )
        for i in range(3)
    ]


def _links_of(model: Model, seat: Seat, carrier: Seat) -> list[TreeLink]:
    """Return the links that a joint adds; the last one is that of the body."""
    joint, initial = seat.joint, ConfigurationType.Initial
    offset = carrier.turn.T @ (joint.places[0] - carrier.origin)
    if not joint.free:
        return []
    if joint.free == ALL_AXES:
        return _sliding_links(model, seat) + _turning_links(model, seat, carrier, BEFORE, np.zeros(3))
    if joint.free == ROTATIONS:
        return _turning_links(model, seat, carrier, carrier.link, offset)
    (q, rate), (reference, _) = (_coordinate(model, seat, c) for c in (initial, ConfigurationType.Reference))
    moved = q - reference
    if joint.free[0] >= 3:
        moved = (moved + np.pi) % (2 * np.pi) - np.pi
    transformation = carrier.turn.T @ joint.axes[0] @ joint.axes[1].T @ seat.turn
    kind = JointType((4 if joint.free[0] < 3 else 1) + seat.axis)
    return [TreeLink(kind, carrier.link, transformation, offset, (reference, moved, rate))]


def _require_closed(model: Model, joint: Joint) -> None:
    opening = _opened(model, joint, ConfigurationType.Initial)[2]
    if opening > CLOSED:
        name = model.items("object")[joint.number]["name"]
        raise ValueError(
            f"RecogniseTrees: joint '{name}' (object {joint.number}) is open by {opening:.3g} at the start; "
            "place the bodies so that their joints are closed"
        )


def _make_links(model: Model, tree: Tree, seats: dict[int, Seat]) -> None:
    """Number links from the base on, and find the state of their joints; `seats` are those of bodies on the ground."""
    for seat in tree.seats:
        if seat.joint.number >= 0:
            _require_closed(model, seat.joint)
        carrier = seats[seat.joint.bodies[0]]
        for link in _links_of(model, seat, carrier):
            if link.parent == BEFORE:
                link.parent = len(tree.links) - 1
            tree.links.append(link)
        seat.link = len(tree.links) - 1 if seat.joint.free else carrier.link
        seats[seat.body] = seat


def _inertia(item: dict[str, Any], seat: Seat) -> RigidBodyInertia:
    J = np.asarray(item["physicsInertia"])
    tensor = np.array([[J[0], J[5], J[4]], [J[5], J[1], J[3]], [J[4], J[3], J[2]]])
    com = np.asarray(item["physicsCenterOfMass"])
    about = RigidBodyInertia(item["physicsMass"], tensor, com, inertiaTensorAtCOM=False)
    back = np.eye(4)
    back[:3, :3], back[:3, 3] = seat.turn.T, -seat.turn.T @ seat.origin
    return about.Transformed(back)


def _weights(model: Model, tree: Tree) -> FloatArray:
    """Return gravity of all links; none if it is not the same for all."""
    all_weights = np.array([model.gravity(seat.body) for seat in tree.seats])
    return (
        all_weights[0]
        if np.array_equal(all_weights, np.broadcast_to(all_weights[0], all_weights.shape))
        else np.zeros(3)
    )


def _locking(model: Model, tree: Tree, node: NodeIndex) -> Iterator[tuple[str, int, int]]:
    """Yield what solvers watch: the name of what turns about three axes, the node, and its first coordinate there."""
    for seat in tree.seats:
        if seat.joint.free in (ROTATIONS, ALL_AXES):
            number, kind = (seat.body, "body") if seat.joint.free == ALL_AXES else (seat.joint.number, "joint")
            name = model.items("object")[number]["name"]
            yield f"{kind} '{name}' (object {number})", int(node), seat.link - 2


def _names(model: Model, tree: Tree) -> dict[str, list[str]]:
    """Return names of links and joints: those of the body that a joint moves, and of the joint."""
    links, joints = ([""] * len(tree.links) for _ in range(2))
    for seat in tree.seats:
        links[seat.link] = links[seat.link] or model.items("object")[seat.body]["name"]
        if seat.joint.free and seat.joint.number >= 0:
            joints[seat.link] = model.items("object")[seat.joint.number]["name"]
    return {"linkNames": links, "jointNames": joints}


def _parameters(model: Model, tree: Tree, node: NodeIndex) -> dict[str, Any]:
    inertias: list[RigidBodyInertia] = [RigidBodyInertia() for _ in tree.links]
    drawn: list[list[Any]] = [[] for _ in tree.links]
    for seat in tree.seats:
        item = model.items("object")[seat.body]
        inertias[seat.link] = inertias[seat.link] + _inertia(item, seat)
        shapes = item["VgraphicsData"] if item["Vshow"] else []
        drawn[seat.link] += [Move(shape, -seat.turn.T @ seat.origin, seat.turn.T) for shape in shapes]
    return {
        "objectType": "KinematicTree",
        "name": f"tree of {model.items('object')[tree.seats[0].body]['name']}",
        "nodeNumber": node,
        "gravity": _weights(model, tree),
        "baseOffset": np.zeros(3),
        "jointTypes": [link.kind for link in tree.links],
        "linkParents": [link.parent for link in tree.links],
        "jointTransformations": Matrix3DList([link.transformation for link in tree.links]),
        "jointOffsets": Vector3DList([link.offset for link in tree.links]),
        "linkInertiasCOM": Matrix3DList([inertia.InertiaCOM() for inertia in inertias]),
        "linkCOMs": Vector3DList([inertia.COM() for inertia in inertias]),
        "linkMasses": [inertia.Mass() for inertia in inertias],
        "VgraphicsDataList": drawn,
        **_names(model, tree),
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


def _on_link(seat: Seat, number: ObjectIndex, user: dict[str, Any], item_type: str) -> dict[str, Any]:
    """Return what tells a sensor or marker of a body, or of its node, where it is on the link."""
    local = seat.turn.T @ (np.asarray(user.get("localPosition", np.zeros(3))) - seat.origin)
    return {item_type: "KinematicTree", "objectNumber": number, "linkNumber": seat.link, "localPosition": local}


def _sensor(user: dict[str, Any], place: dict[str, Any]) -> dict[str, Any]:
    kept = ("name", "writeToFile", "fileName", "outputVariableType", "storeInternal", "Vshow")
    return {**place, **{key: user[key] for key in kept}}


def _replace_weight(model: Model, marker: int, item: dict[str, Any], acts: bool) -> None:
    """Put forces in the place of loads that are proportional to a mass; zero, if they act otherwise."""
    for _, load, m in model.users_of("marker", marker):
        force = item["physicsMass"] * np.asarray(load["loadVector"]) if acts else np.zeros(3)
        model.items("load")[m] = {
            **_hidden(load, loadType="ForceVector", markerNumber=MarkerIndex(marker), loadVector=force),
        }


def _hide_node(model: Model, node: int) -> None:
    place = model.items("node")[node]["referenceCoordinates"][:3]
    model.items("node")[node] = _hidden(model.items("node")[node], nodeType="PointGround", referenceCoordinates=place)


def _replace(model: Model, tree: Tree, number: ObjectIndex) -> None:
    """Put the links in the place of their bodies, for all that refers to these."""
    shared = bool(np.any(_weights(model, tree)))
    for seat in tree.seats:
        body = model.items("object")[seat.body]
        node = int(body["nodeNumber"])
        for kind, user, k in [*model.users_of("object", seat.body), *model.users_of("node", node)]:
            if kind == "sensor":
                model.items(kind)[k] = _sensor(user, _on_link(seat, number, user, "sensorType"))
            elif kind == "marker" and user["markerType"] == "BodyMass":
                at_rest = _hidden(user, markerType="NodePosition", nodeNumber=NodeIndex(node))
                com = {"localPosition": body["physicsCenterOfMass"]}
                at_com = _on_link(seat, number, com, "markerType") | {"markerType": "KinematicTreeRigid"}
                model.items(kind)[k] = at_rest if shared else at_com | {"name": user["name"]}
                _replace_weight(model, k, body, acts=not shared)
            elif kind == "marker":
                for _, other, _ in model.users_of(kind, k):
                    _turn_user(other, k, seat.turn)
                place = _on_link(seat, number, user, "markerType") | {"markerType": "KinematicTreeRigid"}
                model.items(kind)[k] = place | {key: user[key] for key in ("name", "Vshow")}
        _hide_node(model, node)


def _put_on_ground(model: Model, seat: Seat) -> None:
    """Put a ground in the place of a body that is fixed to the ground."""
    body = model.items("object")[seat.body]
    node, number = int(body["nodeNumber"]), ObjectIndex(seat.body)
    for kind, user, k in [*model.users_of("object", seat.body), *model.users_of("node", node)]:
        if kind == "marker" and user["markerType"] == "BodyMass":
            model.items(kind)[k] = _hidden(user, markerType="NodePosition", nodeNumber=NodeIndex(node))
            _replace_weight(model, k, body, acts=False)
        elif kind == "sensor" and user["sensorType"] == "Node":
            place = {"sensorType": "Body", "bodyNumber": number, "localPosition": np.zeros(3)}
            model.items(kind)[k] = _sensor(user, place)
        elif kind == "marker" and user["markerType"].startswith("Node"):
            on_body = {"markerType": user["markerType"].replace("Node", "Body"), "bodyNumber": number}
            model.items(kind)[k] = on_body | {key: user[key] for key in ("name", "Vshow")}
    _hide_node(model, node)
    model.items("object")[seat.body] = {
        "objectType": "Ground",
        "referencePosition": -seat.turn.T @ seat.origin,
        "referenceRotation": seat.turn.T,
        **{key: body[key] for key in ("name", "Vshow", "VgraphicsData")},
    }
    _hide(model.items("object"), [seat.joint.number])


def _hide(items: list[dict[str, Any]], numbers: Sequence[int]) -> None:
    for i in numbers:
        items[i] = _hidden(items[i], objectType="Ground")


def RecogniseTrees(mbs: MainSystem) -> MainSystem:
    """Return a copy of an assembled system in which open chains and trees of rigid bodies are kinematic trees.

    Bodies that revolute, prismatic, spherical and fixed joints carry (RevoluteJointZ, PrismaticJointX, SphericalJoint,
    GenericJoint with one free axis, with three free rotations, or with none), one after the other from the ground on,
    become links, in the state of the initial configuration. So do bodies that joints connect to each other, but not to
    the ground: the one with the most joints then floats. Motion takes as many coordinates as joints have and, in
    explicit solvers, a number of operations that grows with that of the links. Joints that close loops stay as
    constraints.

    A spherical joint becomes three rotations about different axes, as does the rotation of a body that floats. They
    lock where the second has turned by 90 degrees; axes are chosen far from that. On the ground and where a body
    floats, with weight, the first is vertical, so that only the elevation of the last is limited, which is level at the
    start. Solvers tell, naming the joint, where steps are too large for motions that come close to it
    (solver.GetDoubts()); such motions need error control, or are better left to bodies with Euler parameters.

    Markers, loads and sensors keep their numbers and act on the links; where bodies, their nodes and joints were, there
    are ground items; bodies that are fixed to the ground become ground. A body stays as it is if something refers to it
    that links do not have, such as a sensor of its coordinates, a marker of its node's coordinates, or a load of weight
    with a user function; so does a joint that a sensor measures. Weight becomes the gravity of the tree.

    raises ValueError if a joint is open at the start, TypeError if mbs is no system
    """
    require_system("RecogniseTrees", mbs)
    model = Model(mbs)
    grounded, trees = _trees(model)
    for seat in grounded:
        _require_closed(model, seat.joint)
    added = []
    for k, tree in enumerate(trees):
        node = NodeIndex(len(model.items("node")) + k)
        reference, moved, rates = np.array([link.state for link in tree.links]).T
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
    for seat in grounded:
        _put_on_ground(model, seat)
    for tree in trees:
        numbers = [number for seat in tree.seats for number in (seat.body, seat.joint.number) if number >= 0]
        _hide(model.items("object"), numbers)
    for coordinates, parameters in added:
        model.items("node").append(coordinates | {"name": f"coordinates of {parameters['name']}"})
        model.items("object").append(parameters)
    nodes = [parameters["nodeNumber"] for _, parameters in added]
    locking = [turns for tree, node in zip(trees, nodes, strict=True) for turns in _locking(model, tree, node)]
    if locking:
        model.entries["systemVariables"]["lockingTurns"] = locking
    made = MainSystem()
    made.SetDictionary(model.entries)
    return made
