"""A robot as kinematic tree: a single object in joint coordinates."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any
from weakref import WeakKeyDictionary

import numpy as np

from dalembert import itemInterface as items
from dalembert._checks import FloatArray
from dalembert._core import Matrix3DList, Vector3DList
from dalembert._geometry.transformations import HTtranslate
from dalembert._solving.quiet import require_system
from dalembert.robotics import _actuators, _constraints, _contacts, _drawing, _tendons
from dalembert.robotics._parts import JOINT_AXES, JOINT_TYPES, REGULAR_VELOCITY, GraphicsList, RobotKeyframe
from dalembert.robotics._tendons import AddMarker
from dalembert.treeDynamics import TreeDynamics

if TYPE_CHECKING:
    from dalembert.robotics._robot import Robot


def joint_in_parent(robot: Robot, i: int) -> FloatArray:
    """Return the transformation to joint i from that of its parent, after its motion, or from the base, unturned."""
    link, parent = robot.links[i], robot.GetParentIndex(i)
    if parent >= 0:
        return np.asarray(robot.links[parent].localHT @ link.preHT)
    turned = np.eye(4)
    turned[:3, :3] = robot.base.HT[:3, :3]
    return np.asarray(turned @ link.preHT)


def _graphics(robot: Robot) -> list[GraphicsList]:
    """Return the graphics of all links in the frames of their joints; bars are drawn by the links that they lie on."""
    drawn: list[GraphicsList] = []
    for i, link in enumerate(robot.links):
        view, parent = link.visualization, robot.GetParentIndex(i)
        own = _drawing.center_of_mass(link.JointInertia().COM(), view)
        own += _drawing.joint(JOINT_AXES[link.jointType], view)
        own += _drawing.moved(view.graphicsData + _drawing.tool(robot, i), link.localHT)
        drawn.append(own)
        if parent >= 0 and not robot.links[parent].visualization.graphicsData:
            drawn[parent] += _drawing.bar(np.zeros(3), joint_in_parent(robot, i)[:3, 3], view)
    return drawn


def _control(robot: Robot) -> dict[str, Any]:
    """Return the control of the drives, as far as there are any."""
    if not any(link.HasPDcontrol() for link in robot.links):
        return {}
    factors = np.array([link.PDcontrol or (0.0, 0.0) for link in robot.links], dtype=float)
    rest = np.zeros(len(robot.links))
    return {
        "jointPControlVector": factors[:, 0],
        "jointDControlVector": factors[:, 1],
        "jointPositionOffsetVector": rest,
        "jointVelocityOffsetVector": rest,
    }


def _resistance(robot: Robot, i: int, stops: tuple[float, float]) -> dict[str, Any]:
    """Return spring, damping, friction and stops of a joint as parameters of a connector; empty if there are none."""
    link, parameters = robot.links[i], dict[str, Any]()
    reference = robot.referenceConfiguration[i]  # markers measure from there
    if link.stiffness:
        parameters |= {"stiffness": link.stiffness, "offset": link.springReference - reference}
    if link.damping:
        parameters["damping"] = link.damping
    if link.friction:
        parameters |= {"fDynamicFriction": link.friction, "frictionProportionalZone": REGULAR_VELOCITY}
    if link.jointLimits is not None and any(stops) and np.isfinite(link.jointLimits).all():
        lower, upper = link.jointLimits - reference
        parameters |= {"useLimitStops": True, "limitStopsLower": lower, "limitStopsUpper": upper}
        parameters |= {"limitStopsStiffness": stops[0], "limitStopsDamping": stops[1]}
    return parameters


def _add_resistances(robot: Robot, mbs: Any, coordinate: Callable[[int], Any], stops: tuple[float, float]) -> list[Any]:
    """Add a connector from ground to each coordinate whose joint has a spring, damping, friction or stops.

    It is None for other joints.
    """
    added: list[Any] = []
    for i, parameters in enumerate(_resistance(robot, i, stops) for i in range(len(robot.links))):
        if not parameters:
            added.append(None)
            continue
        if "useLimitStops" in parameters:
            history = items.NodeGenericData(numberOfDataCoordinates=3, initialCoordinates=[0, 0, 0])
            parameters["nodeNumber"] = mbs.AddNode(history)
        view = items.VObjectConnectorCoordinateSpringDamperExt(show=False)
        connector = items.ObjectConnectorCoordinateSpringDamperExt(
            markerNumbers=[coordinate(-1), coordinate(i)], visualization=view, **parameters
        )
        added.append(mbs.AddObject(connector))
    return added


def _add_coupling(robot: Robot, mbs: Any, coordinate: Callable[[int], Any], i: int) -> Any:
    """Add the constraint of a joint that follows another; None if it does not."""
    follows = robot.links[i].follows
    if follows is None:
        return None
    leader, factor, offset = robot.GetJointIndex(follows[0]), *follows[1:]
    reference = robot.referenceConfiguration  # reference of the markers
    markers = [coordinate(i), coordinate(leader)]
    apart = reference[i] - factor * reference[leader] - offset
    view = items.VObjectConnectorCoordinate(show=False)
    return mbs.AddObject(
        items.CoordinateConstraint(markerNumbers=markers, factorValue1=factor, offset=apart, visualization=view)
    )


def _add_rotors(robot: Robot, mbs: Any, node: Any) -> Any:
    """Add the inertia of rotors to the coordinates of the joints; None if there are none."""
    inertias = [link.rotorInertia for link in robot.links]
    if not any(inertias):
        return None
    view = items.VObjectGenericODE2(show=False)
    return mbs.AddObject(items.ObjectGenericODE2(nodeNumbers=[node], massMatrix=np.diag(inertias), visualization=view))


def _coordinate_of(mbs: Any, node: Any) -> Callable[[int], Any]:
    """Return the function that gives the markers of coordinates, with one for ground at -1."""
    markers: dict[int, Any] = {}

    def marker(i: int) -> Any:
        if i not in markers:
            owner = mbs.AddNode(items.NodePointGround()) if i < 0 else node
            markers[i] = mbs.AddMarker(items.MarkerNodeCoordinate(nodeNumber=owner, coordinate=max(i, 0)))
        return markers[i]

    return marker


def _add_actuators(
    robot: Robot, mbs: Any, node: Any, coordinate: Callable[[int], Any], place: AddMarker
) -> dict[str, Any]:
    """Add the actuators between their joints and ground, on the coordinates of tendons, or on frames."""
    objects: dict[str, Any] = {}
    for name, actuator in robot.actuators.items():
        if actuator.frame:
            objects[name] = _actuators.add_thruster(robot, mbs, actuator, place)
            continue
        if actuator.joint in robot.tendons:
            objects[name] = _actuators.add_to_tendon(robot, mbs, node, actuator)
            continue
        i = robot.GetJointIndex(actuator.joint)
        reference = robot.referenceConfiguration[i]  # markers measure from there; ground is the second one

        def motion(q: Any, q_t: Any, reference: float = reference) -> tuple[Any, Any]:
            return reference - q, -q_t

        made = _actuators.law(actuator, "coordinates", motion, lambda force: force)
        objects[name] = _actuators.add(mbs, made, [coordinate(i), coordinate(-1)])
    return {"actuators": objects, "controls": _actuators.control_parameters(mbs, objects)}


def _marker_of(robot: Robot, mbs: Any, tree: Any) -> AddMarker:
    """Return the function that adds markers on links of a tree, and on ground for its base."""
    ground: list[Any] = []

    def marker(i: int, T: FloatArray) -> tuple[Any, FloatArray]:
        made: Any
        if i < 0:
            if not ground:
                ground.append(mbs.AddObject(items.ObjectGround(visualization=items.VObjectGround(show=False))))
            T = np.asarray(robot.base.HT) @ T
            made = items.MarkerBodyRigid(bodyNumber=ground[0], localPosition=T[:3, 3])
        else:
            T = np.asarray(robot.links[i].localHT) @ T
            made = items.MarkerKinematicTreeRigid(objectNumber=tree, linkNumber=i, localPosition=T[:3, 3])
        return mbs.AddMarker(made), T[:3, :3]

    return marker


def add_supports(robot: Robot, mbs: Any, marker: AddMarker) -> list[Any]:
    """Add the forces that carry supported masses."""
    return [
        mbs.AddLoad(
            items.LoadForceVector(markerNumber=marker(i, HTtranslate(place))[0], loadVector=-mass * robot.gravity)
        )
        for i, link in enumerate(robot.links)
        for mass, place in link.supported
    ]


def _mechanics(robot: Robot, gravity: FloatArray) -> dict[str, Any]:
    """Return links, joints and weight as parameters of a kinematic tree."""
    in_parents = [joint_in_parent(robot, i) for i in range(len(robot.links))]
    inertias = [link.JointInertia() for link in robot.links]
    return {
        "gravity": gravity,
        "baseOffset": robot.base.HT[:3, 3],
        "jointTypes": [JOINT_TYPES[link.jointType] for link in robot.links],
        "linkParents": [link.parent for link in robot.links],
        "linkMasses": [link.mass for link in robot.links],
        "jointTransformations": Matrix3DList([T[:3, :3] for T in in_parents]),
        "jointOffsets": Vector3DList([T[:3, 3] for T in in_parents]),
        "linkInertiasCOM": Matrix3DList([inertia.InertiaCOM() for inertia in inertias]),
        "linkCOMs": Vector3DList([inertia.COM() for inertia in inertias]),
    }


def _names(robot: Robot) -> dict[str, Any]:
    """Return the names of links and joints as parameters of a kinematic tree, as far as there are any."""
    names = {
        "linkNames": [link.name for link in robot.links],
        "jointNames": [link.jointName for link in robot.links],
    }
    return {key: given for key, given in names.items() if any(given)}


def _fingerprint(robot: Robot, gravity: FloatArray) -> tuple[Any, ...]:
    """Return a key of the mechanical properties."""
    links = []
    for link in robot.links:
        arrays = link.COM, link.inertia, link.localHT, link.preHT
        links.append((link.jointType, link.parent, link.mass, *(array.tobytes() for array in arrays)))
    return gravity.tobytes(), robot.base.HT.tobytes(), *links


_dynamics: WeakKeyDictionary[Robot, tuple[tuple[Any, ...], TreeDynamics]] = WeakKeyDictionary()


def dynamics(robot: Robot, gravity: FloatArray) -> TreeDynamics:
    """Return the functions of the current rigid links; cached until something changes."""
    now = _fingerprint(robot, gravity)
    known = _dynamics.get(robot)
    if known is None or known[0] != now:
        known = _dynamics[robot] = now, TreeDynamics(items.ObjectKinematicTree(**_mechanics(robot, gravity)))
    return known[1]


def create(
    robot: Robot,
    mbs: Any,
    name: str,
    forceUserFunction: Any,
    stops: tuple[float, float],
    start: RobotKeyframe | None = None,
) -> dict[str, Any]:
    """Add node, tree and the items that act on its joints; see Robot.CreateKinematicTree."""
    require_system("Robot.CreateKinematicTree", mbs)
    n = len(robot.links)
    robot.FollowedCoordinates(robot.referenceConfiguration[:n])  # rejects joints that follow an unknown joint
    item = items.ObjectKinematicTree(
        name=name,
        forceUserFunction=forceUserFunction,
        visualization=items.VObjectKinematicTree(graphicsDataList=_graphics(robot)),
        **_mechanics(robot, robot.gravity),
        **_control(robot),
        **_names(robot),
    )
    coordinates = items.NodeGenericODE2(
        referenceCoordinates=robot.referenceConfiguration[:n],
        initialCoordinates=np.zeros(n) if start is None else start.q - robot.referenceConfiguration[:n],
        initialCoordinates_t=np.zeros(n) if start is None else start.q_t,
        numberOfODE2Coordinates=n,
    )
    base = _drawing.add_base(robot, mbs)
    node = item.nodeNumber = mbs.AddNode(coordinates)
    tree = mbs.AddObject(item)
    marker, coordinate = _marker_of(robot, mbs, tree), _coordinate_of(mbs, node)
    return {
        "nodeGeneric": node,
        "objectKinematicTree": tree,
        "baseObject": base,
        "links": robot.LinkNumbers(),
        "resistances": _add_resistances(robot, mbs, coordinate, stops),
        "couplings": [_add_coupling(robot, mbs, coordinate, i) for i in range(n)],
        "rotors": _add_rotors(robot, mbs, node),
        "tendons": _tendons.add(robot, mbs, node, stops) | _tendons.add_cables(robot, mbs, marker, stops),
        "supports": add_supports(robot, mbs, marker),
        "constraints": _constraints.add(robot, mbs, marker, node, coordinate),
        "contacts": _contacts.add(robot, mbs, marker),
        **_add_actuators(robot, mbs, node, coordinate, marker),
    }
