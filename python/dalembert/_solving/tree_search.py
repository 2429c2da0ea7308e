"""Search for open chains and trees of rigid bodies in a system, and the poses of bodies in them.

A body belongs to a tree if it is connected by revolute, prismatic, spherical or fixed joints, and all items that refer
to it have a counterpart among links.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._core import (
    ConfigurationType,
    JointType,
    MainSystem,
    MarkerIndex,
    NodeIndex,
    ObjectIndex,
    OutputVariableType,
)

GROUND = -1
_LISTS = {"node": NodeIndex, "object": ObjectIndex, "marker": MarkerIndex}
ROTATIONS, ALL_AXES = (3, 4, 5), (0, 1, 2, 3, 4, 5)  # of joints: three translations, then three rotations
_FREE_AXES = {"JointRevoluteZ": (5,), "JointPrismaticX": (0,), "JointSpherical": ROTATIONS}
# Outputs of links, and whether they depend on the axes of the link.
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

    number: int  # number of the object; -1: a floating body
    free: tuple[int, ...]  # free axes among its six axes: one, ROTATIONS, ALL_AXES, or empty
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
    """Pose of a body in a tree: the frame of its link, given in the frame of the body."""

    body: int
    joint: Joint
    origin: FloatArray  # on the joint that moves the link
    turn: FloatArray  # axes of the link, in those of the body
    sign: float = 1.0  # sign of the coordinate, because the axis may point backwards
    link: int = GROUND

    @property
    def axis(self) -> int:
        """The axis of the link along which a joint of one coordinate lies."""
        along = self.turn.T @ self.joint.axes[1][:, self.joint.free[0] % 3]
        return int(np.abs(along).argmax())


ON_GROUND = Seat(GROUND, Joint(-1, (), (GROUND, GROUND), (), ()), np.zeros(3), np.eye(3))  # type: ignore[arg-type]


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
        """Return the rigid body of a marker, GROUND, or None for other carriers."""
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
        """Return position and axes of a marker in the frame of its body; markers on ground use the global frame."""
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


# ---- items that can be part of a tree --------------------------------------------------------------------------------


def _is_weight(load: dict[str, Any]) -> bool:
    return load.get("loadType") == "MassProportional" and not load["loadVectorUserFunction"]


def _turns(kind: str, user: dict[str, Any], i: int) -> bool:
    """Return whether an item that uses a marker can be transformed to other axes of the body."""
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
    """Return the free axes of an ideal joint; None if trees have no such joint."""
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
    """Finds trees: the shortest path of each body to the ground, or to a floating body."""

    def __init__(self, model: Model) -> None:
        self.model, self.joints, self.taken = model, _joints(model), set[int]()

    def carried_by(self, seat: Seat, on_ground: bool = False, fixed: bool = True) -> Iterator[Seat]:
        """Yield the bodies on a body (or on ground) that are not in a tree yet, which they are from now on.

        On fixed carriers: either fixed bodies, or moving ones.
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
        found = [ON_GROUND]
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
            tree = self.tree_on(_seat(Joint(-1, ALL_AXES, (GROUND, body), zero, one), ON_GROUND))
            if len(tree.seats) > 1:
                yield tree
            else:
                self.taken.remove(body)

    def bodies(self) -> set[int]:
        return {body for joint in self.joints for body in joint.bodies} - {GROUND}


def find_trees(model: Model) -> tuple[list[Seat], list[Tree]]:
    """Return the bodies that are fixed to the ground, and the trees, those on the ground first."""
    search = _Search(model)
    grounded = search.grounded()
    roots = [
        root for seat in [ON_GROUND, *grounded] for root in list(search.carried_by(seat, on_ground=True, fixed=False))
    ]
    trees = [search.tree_on(root) for root in roots]
    trees.extend(search.floating())
    return grounded, trees
