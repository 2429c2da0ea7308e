"""Open chains and trees of rigid bodies as kinematic trees: treeDynamics.RecogniseTrees.

Chains of bodies with revolute, prismatic, spherical and fixed joints become links; connectors and loads on the bodies
then
act on the links. Items keep their numbers: bodies, their nodes and joints are replaced by invisible ground items.
Joints
that close loops, and items without a counterpart among links, remain.

Joints of trees have one coordinate. Spherical joints are three of them in series, and floating bodies have six;
intermediate links have no mass.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

import dalembert
from dalembert._checks import FloatArray
from dalembert._core import (
    ConfigurationType,
    JointType,
    MainSystem,
    MarkerIndex,
    Matrix3DList,
    NodeIndex,
    ObjectIndex,
    Vector3DList,
)
from dalembert._geometry.inertia import RigidBodyInertia
from dalembert._geometry.three_turns import ThreeTurns
from dalembert._solving.quiet import require_system
from dalembert._solving.tree_search import (
    ALL_AXES,
    GROUND,
    ON_GROUND,
    ROTATIONS,
    Joint,
    Model,
    Seat,
    Tree,
    TreeLink,
    find_trees,
)

BEFORE = -2  # the link before, as parent
CLOSED = 1e-6  # m and rad, between the markers of a joint


# ---- links and parameters of trees -----------------------------------------------------------------------------------


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
    """Return gravity of all links; zero if it differs between links."""
    all_weights = np.array([model.gravity(seat.body) for seat in tree.seats])
    return (
        all_weights[0]
        if np.array_equal(all_weights, np.broadcast_to(all_weights[0], all_weights.shape))
        else np.zeros(3)
    )


def _locking(model: Model, tree: Tree, node: NodeIndex) -> Iterator[tuple[str, int, int]]:
    """Yield data of gimbal lock for solvers: the name of the joint or body with three angles, the node, and its first
    coordinate."""
    for seat in tree.seats:
        if seat.joint.free in (ROTATIONS, ALL_AXES):
            number, kind = (seat.body, "body") if seat.joint.free == ALL_AXES else (seat.joint.number, "joint")
            name = model.items("object")[number]["name"]
            yield f"{kind} '{name}' (object {number})", int(node), seat.link - 2


def _names(model: Model, tree: Tree) -> dict[str, list[str]]:
    """Return names of links and joints: the name of the body that a joint moves, and the name of the joint."""
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
        drawn[seat.link] += [
            dalembert.graphics.Move(shape, -seat.turn.T @ seat.origin, seat.turn.T) for shape in shapes
        ]
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
    """Transform the data of an item that uses a marker to the axes of the link."""
    at = [int(number) for number in user.get("markerNumbers", [])]
    if user.get("bodyFixed"):
        user["loadVector"] = turn.T @ user["loadVector"]
    elif marker in at and f"rotationMarker{at.index(marker)}" in user:
        user[f"rotationMarker{at.index(marker)}"] = turn.T @ user[f"rotationMarker{at.index(marker)}"]


def _hidden(item: dict[str, Any], **values: Any) -> dict[str, Any]:
    return {"name": item["name"], **values, "Vshow": False}


def _on_link(seat: Seat, number: ObjectIndex, user: dict[str, Any], item_type: str) -> dict[str, Any]:
    """Return the parameters with the position on the link for a sensor or marker of a body, or of its node."""
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
    grounded, trees = find_trees(model)
    places = {seat.body: seat for seat in grounded} | {GROUND: ON_GROUND}
    for tree in trees:
        _make_links(model, tree, dict(places))
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
