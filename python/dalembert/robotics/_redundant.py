"""A robot as rigid bodies and joints: redundant coordinates, on a base that may move."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import numpy.typing as npt

import dalembert
from dalembert import itemInterface as items
from dalembert._checks import FloatArray, as_rotation, shape_error
from dalembert._core import NodeType
from dalembert._geometry.inertia import RigidBodyInertia
from dalembert._geometry.transformations import InverseHT
from dalembert._solving.quiet import require_system
from dalembert._tools.found_items import index_of
from dalembert.create._frames import reference_rotation
from dalembert.robotics import _actuators, _constraints, _contacts, _drawing, _kinematics, _tendons
from dalembert.robotics._constraints import RobotCoupling, RobotLoop
from dalembert.robotics._parts import JOINT_AXES, REGULAR_VELOCITY, GraphicsList, RobotLink, is_revolute
from dalembert.robotics._tendons import AddMarker, place_of
from dalembert.robotics._tree import add_supports

if TYPE_CHECKING:
    from dalembert.robotics._robot import Robot

# Turns the third axis, about which torsional springs turn, to the axis of a joint; and the third cyclically.
_FROM_Z = {"x": np.eye(3)[:, [1, 2, 0]], "y": np.eye(3)[:, [2, 0, 1]], "z": np.eye(3)}


_FLOATING = ["Px", "Py", "Pz", "Rz", "Ry", "Rx"]  # joints of one coordinate that make a floating joint


class Options(NamedTuple):
    """Arguments of Robot.CreateRedundantCoordinateMBS."""

    springUserFunctions: Sequence[Any]
    loadUserFunctions: Sequence[Any]
    torqueLoads: bool
    rotationMarkerBase: npt.ArrayLike | None
    nodeType: NodeType
    name: str

    def named(self, part: str) -> str:
        """Return the name of an item; empty for parts without a name."""
        return f"{self.name}{part}" if part else ""


class Ends(NamedTuple):
    """The two markers of a joint, and the rotations from these to the axes of the joint."""

    markers: list[Any]
    rotations: tuple[FloatArray, FloatArray]


def _graphics(robot: Robot, i: int) -> GraphicsList:
    """Return the graphics of a link, in its frame: its own, or bars to the joints of the links that it carries."""
    link = robot.links[i]
    parts = list(link.visualization.graphicsData)
    if not parts:
        back = InverseHT(link.localHT)
        for j, following in enumerate(robot.links):
            if robot.GetParentIndex(j) == i:
                axis = following.preHT[:3, :3] @ JOINT_AXES[following.jointType]
                ends = (back[:3, 3], following.preHT[:3, 3]), (back[:3, :3] @ JOINT_AXES[link.jointType], axis)
                parts += _drawing.link_between(link.COM, *ends, link.visualization, is_first=i == 0)
    return parts + _drawing.tool(robot, i)


def _floating(robot: Robot, options: Options) -> dict[int, range]:
    """Return the links that float freely, with all links of their joint; the links between these have no mass.

    Nothing acts on their coordinates, so that they need no joint.
    """
    listed = max(len(options.springUserFunctions), len(options.loadUserFunctions))
    driven = {actuator.joint for actuator in robot.actuators.values()} - {""}
    parents = [robot.GetParentIndex(i) for i in range(len(robot.links))]
    found = {}
    for i in range(5, len(robot.links)):
        chain = range(i - 5, i + 1)
        links = [robot.links[j] for j in chain]
        acting = any(
            link.damping or link.friction or link.stiffness or link.rotorInertia or link.follows or link.HasPDcontrol()
            for link in links
        )
        inner = [j for j, parent in enumerate(parents) if parent in chain[:-1]]
        if (
            [link.jointType for link in links] == _FLOATING
            and parents[chain[0]] == -1
            and inner == list(chain[1:])
            and not any(link.mass for link in links[:-1])
            and not acting
            and not driven.intersection(link.jointName for link in links)
            and listed <= chain[0]
        ):
            found[i] = chain
    return found


def _check(robot: Robot, mbs: Any, baseMarker: Any, options: Options) -> None:
    """Raise a ValueError for unsupported robots, before anything is added."""
    where = "Robot.CreateRedundantCoordinateMBS"
    require_system(where, mbs)
    if len(options.springUserFunctions) > len(robot.links):
        expected = f"at most {len(robot.links)} entries"
        raise shape_error(f"{where}: jointSpringDamperUserFunctionList", expected, options.springUserFunctions)
    floating = {i for chain in _floating(robot, options).values() for i in chain}
    for i, link in enumerate(robot.links):
        if i in floating:
            continue
        reasons = {
            "no mass": link.mass == 0,
            "the inertia of a rotor": link.rotorInertia,
            "a joint to follow": link.follows,
        }
        for what in (reason for reason, holds in reasons.items() if holds):
            raise ValueError(
                f"{where}: link {i} '{link.name}' has {what}, which needs the coordinates of the joints; use "
                "CreateKinematicTree"
            )
        if i < len(options.springUserFunctions):
            link.GetPDcontrol()
    of_coordinates = {f"tendon '{name}'" for name in robot.tendons} | {
        f"constraint '{name}'" for name, each in robot.constraints.items() if isinstance(each, RobotCoupling)
    }
    for what in sorted(of_coordinates):
        raise ValueError(f"{where}: {what} needs the coordinates of the joints; use CreateKinematicTree")
    for actuator in robot.actuators.values():
        if actuator.dynamics != "none" and is_revolute(robot.GetLink(robot.GetJointIndex(actuator.joint)).jointType):
            raise ValueError(
                f"{where}: actuator '{actuator.name}' has dynamics, which need the coordinate of a joint that "
                "turns; use CreateKinematicTree"
            )
    beside = any(
        not robot.HasParent(i) and np.any(link.preHT[:3, 3]) for i, link in enumerate(robot.links) if i not in floating
    )
    kind = mbs.GetMarker(baseMarker)["markerType"]
    loops = [each for each in robot.constraints.values() if isinstance(each, RobotLoop)]
    ends = {name for loop in loops for name in (loop.frame0, loop.frame1)}
    ends |= {name for cable in robot.cables.values() for name in (cable.frame0, cable.frame1)}
    if kind != "BodyRigid" and any(place_of(robot, name)[0] < 0 for name in ends):
        raise ValueError(
            f"{where}: baseMarker: a loop or cable that ends at the base needs a MarkerBodyRigid, received a marker "
            f"of type {kind}"
        )
    if beside and kind != "BodyRigid":
        raise ValueError(
            f"{where}: baseMarker: a joint beside the origin of the base (preHT) needs a MarkerBodyRigid, received a "
            f"marker of type {kind}"
        )


def _add_body(robot: Robot, mbs: Any, i: int, T: FloatArray, options: Options) -> dict[str, Any]:
    link = robot.links[i]
    created: dict[str, Any] = mbs.CreateRigidBody(
        name=options.named(link.name),
        referencePosition=T[:3, 3],
        referenceRotationMatrix=T[:3, :3],
        inertia=RigidBodyInertia(link.mass, link.inertia).Translated(link.COM),
        gravity=robot.gravity,
        nodeType=options.nodeType,
        graphicsDataList=_graphics(robot, i),
        returnDict=True,
    )
    return created


def _base_rotation(robot: Robot, mbs: Any, marker: Any, given: npt.ArrayLike | None) -> FloatArray:
    """Return the rotation of the base against its marker."""
    if given is not None:
        return as_rotation("rotationMarkerBase", given)
    return np.asarray(reference_rotation(mbs, marker).T @ robot.base.HT[:3, :3])


def _base_marker(mbs: Any, marker: Any, offset: FloatArray) -> Any:
    """Return the marker of the base, or an additional one for a first joint that is not in its origin."""
    if not np.any(offset):
        return marker
    given = mbs.GetMarker(marker)
    place = np.asarray(given["localPosition"]) + offset
    return mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=given["bodyNumber"], localPosition=place))


def _add_joint(robot: Robot, mbs: Any, link: RobotLink, ends: Ends, options: Options) -> Any:
    """Add the joint, with its name; a link of the same name, which files may have, leaves it Joint:name."""
    taken = any(link.jointName == other.name for other in robot.links)
    constrained = [1] * 6
    constrained["xyz".index(link.jointType[1]) + 3 * is_revolute(link.jointType)] = 0
    view = items.VObjectJointGeneric(
        show=link.visualization.showMBSjoint,
        axesRadius=0.25 * link.visualization.jointRadius,
        axesLength=1.1 * link.visualization.jointWidth,
        color=dalembert.graphics.color.grey,
    )
    return mbs.AddObject(
        items.GenericJoint(
            name=options.named(f"Joint:{link.jointName}" if taken and link.jointName else link.jointName),
            markerNumbers=ends.markers,
            constrainedAxes=constrained,
            rotationMarker0=ends.rotations[0],
            rotationMarker1=ends.rotations[1],
            visualization=view,
        )
    )


def _add_loads(mbs: Any, link: RobotLink, i: int, ends: Ends, units: list[FloatArray], options: Options) -> list[Any]:
    """Add the loads of a drive on both sides of a joint, in the axes of the bodies; None if there are none."""
    Load = items.LoadTorqueVector if is_revolute(link.jointType) else items.LoadForceVector
    if i < len(options.loadUserFunctions):
        values: list[dict[str, Any]] = [
            {"loadVector": unit, "loadVectorUserFunction": options.loadUserFunctions[i]} for unit in units
        ]
    elif options.torqueLoads:
        values = [{"loadVector": [0, 0, 0]}] * 2
    else:
        return [None, None]
    return [
        mbs.AddLoad(Load(markerNumber=marker, bodyFixed=True, **value))
        for marker, value in zip(ends.markers, values, strict=True)
    ]


def _drive_law(link: RobotLink, userFunction: Any) -> Any:
    """Return the user function of a spring-damper with additional dry friction; the given one if there is no
    friction."""
    if not link.friction:
        return userFunction

    def law(mbs: Any, t: float, item: int, u: float, v: float, k: float, d: float, offset: float) -> float:
        given = userFunction(mbs, t, item, u, v, k, d, offset) if userFunction else k * (u - offset) + d * v
        return float(given + link.friction * np.clip(v / REGULAR_VELOCITY, -1.0, 1.0))

    return law


def _add_spring_damper(mbs: Any, link: RobotLink, q: float, ends: Ends, i: int, options: Options) -> Any:
    """Add drive, damping and friction of a joint as one spring-damper; None if it has none of these."""
    listed = i < len(options.springUserFunctions)
    if not (listed or link.HasPDcontrol() or link.damping or link.friction):
        return None
    factors = link.GetPDcontrol() if listed or link.HasPDcontrol() else (0.0, 0.0)
    law = _drive_law(link, options.springUserFunctions[i] if listed else 0)
    return _add_connector(mbs, link, q, ends, law, stiffness=factors[0], damping=factors[1] + link.damping)


def _add_connector(mbs: Any, link: RobotLink, q: float, ends: Ends, law: Any, **values: Any) -> Any:
    """Add a spring-damper about, or along, the axis of a joint, which measures the coordinate of the joint."""
    values["markerNumbers"] = ends.markers
    if not is_revolute(link.jointType):
        axis = ends.rotations[0] @ JOINT_AXES[link.jointType]
        view = items.VLinearSpringDamper(show=False)
        return mbs.AddObject(
            items.LinearSpringDamper(**values, axisMarker0=axis, springForceUserFunction=law, visualization=view)
        )
    turns = mbs.AddNode(items.NodeGenericData(initialCoordinates=[q], numberOfDataCoordinates=1))
    turned = [A @ _FROM_Z[link.jointType[1]] for A in ends.rotations]
    return mbs.AddObject(
        items.TorsionalSpringDamper(
            **values,
            nodeNumber=turns,
            rotationMarker0=turned[0],
            rotationMarker1=turned[1],
            springTorqueUserFunction=law,
            visualization=items.VTorsionalSpringDamper(show=False),
        )
    )


def _add_actuators(robot: Robot, mbs: Any, ends_of: dict[int, Ends], marker: AddMarker) -> dict[str, Any]:
    """Add the actuators between the markers of their joints, or on frames."""
    objects: dict[str, Any] = {}
    for name, actuator in robot.actuators.items():
        if actuator.frame:
            objects[name] = _actuators.add_thruster(robot, mbs, actuator, marker)
            continue
        i = robot.GetJointIndex(actuator.joint)
        link, ends = robot.links[i], ends_of[i]
        if is_revolute(link.jointType):
            made = _actuators.law(actuator, "rotation", lambda phi, omega: (phi, omega), lambda torque: -torque)
            turned = [A @ _FROM_Z[link.jointType[1]] for A in ends.rotations]
            turns = items.NodeGenericData(
                initialCoordinates=[robot.referenceConfiguration[i]], numberOfDataCoordinates=1
            )
            further = {"nodeNumber": mbs.AddNode(turns)}
        else:
            axis = JOINT_AXES[link.jointType]

            def motion(u: Any, phi: Any, v: Any, omega: Any, axis: FloatArray = axis) -> tuple[Any, Any]:
                return u @ axis, v @ axis

            def result(force: Any, axis: FloatArray = axis) -> Any:
                return [-force * component for component in axis], [0.0] * 3

            made, turned, further = _actuators.law(actuator, "frames", motion, result), list(ends.rotations), {}
        objects[name] = _actuators.add(
            mbs, made, ends.markers, rotationMarker0=turned[0], rotationMarker1=turned[1], **further
        )
    return {"actuators": objects, "controls": _actuators.control_parameters(mbs, objects)}


def create(robot: Robot, mbs: Any, baseMarker: Any, options: Options) -> dict[str, Any]:
    """Add bodies, joints and drives; see Robot.CreateRedundantCoordinateMBS."""
    baseMarker = index_of(mbs, "Marker", baseMarker, "Robot.CreateRedundantCoordinateMBS: baseMarker")
    _check(robot, mbs, baseMarker, options)
    lists = "nodeList bodyList jointList markerList0 markerList1 springDamperList jointTorque0List jointTorque1List"
    lists += " unitTorque0List unitTorque1List springList"
    result: dict[str, Any] = {name: [] for name in lists.split()}
    base = _drawing.add_base(robot, mbs)
    q = robot.referenceConfiguration
    at_base = _base_rotation(robot, mbs, baseMarker, options.rotationMarkerBase)
    placed: list[FloatArray] = []
    ends_of: dict[int, Ends] = {}
    floating = _floating(robot, options)
    inner = {j for chain in floating.values() for j in chain[:-1]}  # without bodies
    for i, link in enumerate(robot.links):
        parent = robot.GetParentIndex(i)
        before = robot.base.HT if parent < 0 else placed[parent]
        placed.append(before @ link.preHT @ _kinematics.joint_transformation(link.jointType, q[i]) @ link.localHT)
        if i in inner or i in floating:
            made = {} if i in inner else _add_body(robot, mbs, i, placed[i], options)
            for name, entries in result.items():
                entries.append(made.get({"nodeList": "nodeNumber", "bodyList": "bodyNumber"}.get(name, "")))
            continue
        body = _add_body(robot, mbs, i, placed[i], options)
        back = InverseHT(link.localHT)
        marker1 = mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=body["bodyNumber"], localPosition=back[:3, 3]))
        if parent < 0:
            marker0, turned = _base_marker(mbs, baseMarker, at_base @ link.preHT[:3, 3]), at_base @ link.preHT[:3, :3]
        else:
            carrier, turned = result["bodyList"][parent], link.preHT[:3, :3]
            marker0 = mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=carrier, localPosition=link.preHT[:3, 3]))
        ends = Ends([marker0, marker1], (turned, back[:3, :3]))
        ends_of[i] = ends
        joint = _add_joint(robot, mbs, link, ends, options)
        units = [-turned @ JOINT_AXES[link.jointType], back[:3, :3] @ JOINT_AXES[link.jointType]]
        loads = _add_loads(mbs, link, i, ends, units, options)
        drive = _add_spring_damper(mbs, link, q[i], ends, i, options)
        spring = None
        if link.stiffness:
            spring = _add_connector(mbs, link, q[i], ends, 0, stiffness=link.stiffness, offset=link.springReference)
        row = [body["nodeNumber"], body["bodyNumber"], joint, marker0, marker1, drive, *loads, *units, spring]
        for entries, entry in zip(result.values(), row, strict=True):
            entries.append(entry)

    def marker(i: int, T: FloatArray) -> tuple[Any, FloatArray]:
        if i < 0:
            return _base_marker(mbs, baseMarker, at_base @ T[:3, 3]), at_base @ T[:3, :3]
        made = items.MarkerBodyRigid(bodyNumber=result["bodyList"][i], localPosition=T[:3, 3])
        return mbs.AddMarker(made), T[:3, :3]

    return {
        **result,
        "baseObject": -1 if base is None else base,
        "links": robot.LinkNumbers(),
        "supports": add_supports(robot, mbs, marker),
        "constraints": _constraints.add(robot, mbs, marker),
        "contacts": _contacts.add(robot, mbs, marker),
        "tendons": _tendons.add_cables(robot, mbs, marker, (0.0, 0.0)),
        **_add_actuators(robot, mbs, ends_of, marker),
    }
