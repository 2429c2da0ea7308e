"""The class Robot: a tree of links on a base, its kinematics and dynamics, and how it becomes part of a system."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from copy import copy
from dataclasses import replace
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, as_array, as_number, as_vector, shape_error
from dalembert._core import NodeType, _joint_poses, _robot_jacobian, _static_torques
from dalembert._geometry.rigid_transformation import HT as HomogeneousTransformation
from dalembert._geometry.rigid_transformation import sharing
from dalembert._geometry.transformations import HTtranslate, RotationTranslation2T66Inverse
from dalembert.kinematicTree import Inertia2T66, KinematicTree66
from dalembert.robotics import _drawing, _forces, _redundant, _tree
from dalembert.robotics._actuators import RobotActuator
from dalembert.robotics._constraints import RobotCoupling, RobotLoop
from dalembert.robotics._contacts import RobotContact
from dalembert.robotics._denavit_hartenberg import StdDH2HT
from dalembert.robotics._parts import (
    PREVIOUS_LINK,
    GraphicsList,
    RobotBase,
    RobotKeyframe,
    RobotLink,
    RobotTool,
    VRobotLink,
)
from dalembert.robotics._tendons import RobotCable, RobotTendon, factors_of, place_of
from dalembert.treeDynamics import TreeDynamics

_MODES = {"all": slice(0, 6), "trans": slice(0, 3), "rot": slice(3, 6)}


def _transformations(arrays: Iterable[FloatArray]) -> list[Any]:
    """Return transformations as HT; those of many states stay arrays."""
    return [sharing(T) if T.ndim == 2 else T for T in arrays]


class Robot:
    """A serial robot or a tree of links, with gravity (m/s^2, in the global frame), a base, a tool at the last link.

    referenceConfiguration has the coordinates of the joints in which bodies are placed, zeros where it is too short.
    Functions of coordinates take arrays as well: the last axis counts joints, axes before it count states, and results
    have the same leading axes.
    """

    def __init__(
        self,
        gravity: npt.ArrayLike = [0, 0, -9.81],
        base: RobotBase | None = None,
        tool: RobotTool | None = None,
        referenceConfiguration: npt.ArrayLike = [],
    ) -> None:
        self.gravity = as_vector("Robot: gravity", gravity, 3).copy()
        self.base = base if base is not None else RobotBase()
        self.tool = tool if tool is not None else RobotTool()
        self.referenceConfiguration = as_vector("Robot: referenceConfiguration", referenceConfiguration).copy()
        self.links: list[RobotLink] = []
        self.isSerialRobot = True
        self.name = ""
        self.frames: dict[str, tuple[int, FloatArray]] = {}
        self.actuators: dict[str, RobotActuator] = {}
        self.constraints: dict[str, RobotLoop | RobotCoupling] = {}
        self.tendons: dict[str, RobotTendon] = {}
        self.cables: dict[str, RobotCable] = {}
        self.keyframes: dict[str, RobotKeyframe] = {}
        self.contacts: dict[str, RobotContact] = {}
        self.contactExclusions: list[tuple[str, str]] = []

    def __repr__(self) -> str:
        parts = {"base": self.base, "tool": self.tool, "links": self.links}
        head = f"gravity = {self.gravity}\nreferenceConfiguration = {self.referenceConfiguration}"
        return "\n".join([head, *(f"{name}:\n{part}" for name, part in parts.items())])

    # ---- links -------------------------------------------------------------------------------------------------------

    def AddLink(self, robotLink: RobotLink) -> int:
        """Add a copy of a link, and return its index; its parent must have been added before."""
        if not isinstance(robotLink, RobotLink):
            raise TypeError(f"Robot.AddLink: robotLink: received {robotLink!r}, but expected a RobotLink(...)")
        link, i = robotLink._copied(), len(self.links)
        for what, name in (("name", link.name), ("jointName", link.jointName)):
            if name and any(name == getattr(other, what) for other in self.links):
                raise ValueError(f"Robot.AddLink: {what}: there is another '{name}' already; names must differ")
        if isinstance(link.parent, str):
            link.parent = self.GetLinkIndex(link.parent)
        if link.parent == PREVIOUS_LINK:
            link.parent = i - 1
        if not -1 <= link.parent < i:
            raise ValueError(
                f"Robot.AddLink: link {i}: expected a parent from -1 (base) to {i - 1}, or -2 for the link before, "
                f"received {link.parent}; parents are added first"
            )
        if len(self.referenceConfiguration) == i:
            self.referenceConfiguration = np.append(self.referenceConfiguration, 0.0)
        self.isSerialRobot = self.isSerialRobot and link.parent == i - 1
        self.links.append(link)
        return i

    def AddActuator(self, actuator: RobotActuator) -> None:
        """Add an actuator, whose joint or tendon must be there; robot.actuators has all of them by name."""
        if not isinstance(actuator, RobotActuator):
            raise TypeError(f"Robot.AddActuator: received {actuator!r}, but expected a RobotActuator(...)")
        if actuator.name in self.actuators:
            raise ValueError(f"Robot.AddActuator: there is another '{actuator.name}' already; names must differ")
        _ = place_of(self, actuator.frame) if actuator.frame else factors_of(self, actuator.joint)
        self.actuators[actuator.name] = actuator

    def AddTendon(self, tendon: RobotTendon) -> None:
        """Add a tendon, whose joints must be there; robot.tendons has all of them by name.

        Actuators and couplings take the name of a tendon in the place of that of a joint.
        """
        if not isinstance(tendon, RobotTendon):
            raise TypeError(f"Robot.AddTendon: received {tendon!r}, but expected a RobotTendon(...)")
        if tendon.name in self.tendons or any(tendon.name == link.jointName for link in self.links):
            raise ValueError(f"Robot.AddTendon: there is another '{tendon.name}' already; names must differ")
        tendon.Factors(self)
        self.tendons[tendon.name] = tendon

    def AddCable(self, cable: RobotCable) -> None:
        """Add a cable, whose frames must be there; robot.cables has all of them by name."""
        if not isinstance(cable, RobotCable):
            raise TypeError(f"Robot.AddCable: received {cable!r}, but expected a RobotCable(...)")
        if cable.name in self.cables or cable.name in self.tendons:
            raise ValueError(f"Robot.AddCable: there is another '{cable.name}' already; names must differ")
        for frame in (cable.frame0, cable.frame1):
            place_of(self, frame)
        self.cables[cable.name] = cable

    def AddConstraint(self, constraint: RobotLoop | RobotCoupling) -> None:
        """Add a loop or a coupling of joints, whose links must be there; robot.constraints has all of them by name."""
        if not isinstance(constraint, RobotLoop | RobotCoupling):
            expected = "a RobotLoop(...) or a RobotCoupling(...)"
            raise TypeError(f"Robot.AddConstraint: received {constraint!r}, but expected {expected}")
        if constraint.name in self.constraints:
            raise ValueError(f"Robot.AddConstraint: there is another '{constraint.name}' already; names must differ")
        constraint.check(self)
        self.constraints[constraint.name] = constraint

    def AddContact(self, contact: RobotContact) -> None:
        """Add a shape that touches others, whose frame must be there; robot.contacts has all of them by name."""
        if not isinstance(contact, RobotContact):
            raise TypeError(f"Robot.AddContact: received {contact!r}, but expected a RobotContact(...)")
        if contact.name in self.contacts:
            raise ValueError(f"Robot.AddContact: there is another '{contact.name}' already; names must differ")
        place_of(self, contact.frame)
        self.contacts[contact.name] = contact

    def ExcludeContacts(self, frame0: str, frame1: str) -> None:
        """Let shapes on one frame never touch those on another one."""
        for frame in (frame0, frame1):
            place_of(self, frame)
        self.contactExclusions.append((frame0, frame1))

    def IsSerialRobot(self) -> bool:
        """Return whether each link is carried by the one before."""
        return self.isSerialRobot

    def GetLinkIndex(self, link: int | str) -> int:
        """Return the index of a link from itself, its name, or, if no link is called so, the name of its joint."""
        if isinstance(link, str):
            names = self.LinkNumbers()
            if link not in names:
                raise ValueError(f"Robot: there is no link or joint '{link}'; there are: {', '.join(names) or 'none'}")
            return names[link]
        if not 0 <= link < len(self.links):
            raise ValueError(f"Robot: expected a link from 0 to {len(self.links) - 1}, or its name, received {link}")
        return int(link)

    def GetJointIndex(self, joint: str) -> int:
        """Return the index of the link that a joint carries, by the name of the joint, even if a link is called so."""
        names = [link.jointName for link in self.links]
        if joint not in names or not joint:
            raise ValueError(
                f"Robot: there is no joint '{joint}'; there are: {', '.join(filter(None, names)) or 'none'}"
            )
        return names.index(joint)

    def LinkNumbers(self) -> dict[str, int]:
        """Return the indices of links by their names and those of their joints."""
        of_joints = {link.jointName: i for i, link in enumerate(self.links) if link.jointName}
        return of_joints | {link.name: i for i, link in enumerate(self.links) if link.name}

    def GetLink(self, i: int | str) -> RobotLink:
        """Return a link."""
        return self.links[self.GetLinkIndex(i)]

    def HasParent(self, i: int | str) -> bool:
        """Return whether a link is carried by another link; else the base carries it."""
        return self.GetParentIndex(i) >= 0

    def GetParentIndex(self, i: int | str) -> int:
        """Return the index of the link that carries a link, -1 for the base."""
        parent = self.GetLink(i).parent
        assert isinstance(parent, int)
        return parent

    def NumberOfLinks(self) -> int:
        """Return the number of links, which is that of the coordinates."""
        return len(self.links)

    def GetBaseHT(self) -> HomogeneousTransformation:
        """Return the transformation from the global frame to the base."""
        return self.base.HT

    def GetToolHT(self) -> HomogeneousTransformation:
        """Return the transformation from the last link to the tool."""
        return self.tool.HT

    # ---- kinematics --------------------------------------------------------------------------------------------------

    def _coordinates(self, name: str, values: npt.ArrayLike) -> FloatArray:
        """Return coordinates, rates, accelerations or torques as array, or ValueError if there is not one per joint."""
        array = as_array(f"Robot: {name}", values)
        if array.ndim == 0 or array.shape[-1] != len(self.links):
            raise shape_error(f"Robot: {name}", f"{len(self.links)} numbers, one per link", values)
        return array

    def FollowedCoordinates(self, q: npt.ArrayLike) -> FloatArray:
        """Return coordinates in which joints that follow others, or are coupled to them, are where those take them."""
        result = self._coordinates("q", q).copy()
        for i, link in enumerate(self.links):
            if link.follows is not None:
                leader, factor, offset = link.follows
                result[..., i] = factor * result[..., self.GetJointIndex(leader)] + offset
        couplings = [each for each in self.constraints.values() if isinstance(each, RobotCoupling) and each.active]
        for coupling in couplings * len(couplings):  # leaders may follow others, in any order
            if coupling.joint not in self.tendons:
                at = result @ factors_of(self, coupling.leader) if coupling.leader else 0.0
                result[..., self.GetJointIndex(coupling.joint)] = coupling.Coordinate(at)
        return result

    def JointHT(self, q: npt.ArrayLike) -> list[Any]:
        """Return the transformations from the global frame to all joints, after their motion: a list of exu.HT.

        If q has one row per state, each is an array of 4 x 4 matrices.
        """
        return _transformations(_joint_poses(self.links, self.base.HT, self._coordinates("q", q)))

    def LinkHT(self, q: npt.ArrayLike) -> list[Any]:
        """Return the transformations from the global frame to all links, like JointHT."""
        return [T @ link.localHT for T, link in zip(self.JointHT(q), self.links, strict=True)]

    def COMHT(self, HT: Sequence[npt.ArrayLike]) -> list[Any]:
        """Return the transformations to the centres of mass, in the axes of the links, from those of JointHT."""
        return _transformations(
            np.asarray(T) @ link.localHT @ HTtranslate(link.COM) for T, link in zip(HT, self.links, strict=False)
        )

    def FrameHT(self, frame: str, q: npt.ArrayLike) -> Any:
        """Return the transformation to a link, to a frame of a file that the robot has been read from, or to 'tool'."""
        index = self.FrameLink(frame)
        carrier = self.JointHT(q)[index] @ self.links[index].localHT if index >= 0 else self.base.HT
        return _transformations([np.asarray(carrier @ self._frameLocalHT(frame))])[0]

    def _frameLocalHT(self, frame: str) -> Any:
        """Return the transformation from the link that carries a frame, see FrameHT, to the frame."""
        return self.frames[frame][1] if frame in self.frames else self.tool.HT if frame == "tool" else np.eye(4)

    def FrameLink(self, frame: str) -> int:
        """Return the index of the link that carries a frame, see FrameHT; -1 for the base."""
        if frame in self.frames:
            return self.frames[frame][0]
        return len(self.links) - 1 if frame == "tool" else self.GetLinkIndex(frame)

    def Jacobian(
        self,
        HT: Sequence[FloatArray],
        toolPosition: npt.ArrayLike = [],
        mode: str = "all",
        linkIndex: int | str | None = None,
    ) -> FloatArray:
        """Return the Jacobian of a point on a link: from joint rates to velocity and angular velocity.

        HT is the result of JointHT, toolPosition the point in the global frame, [] the origin of the link; the
        default of
        linkIndex is the last link of HT. mode is 'all', 'trans' for the three rows of the velocity, or 'rot'.
        """
        if mode not in _MODES:
            raise shape_error("Robot.Jacobian: mode", "'all', 'trans' or 'rot'", mode)
        if len(HT) > len(self.links):
            expected = f"at most {len(self.links)} transformations"
            raise ValueError(f"Robot.Jacobian: HT: expected {expected}, received {len(HT)}")
        last = len(HT) - 1 if linkIndex is None else self.GetLinkIndex(linkIndex)
        point = as_array("Robot.Jacobian: toolPosition", toolPosition)
        J = _robot_jacobian(self.links, HT, last, point if point.size > 0 else None)
        return J if mode == "all" else J[..., _MODES[mode], :]

    # ---- dynamics ----------------------------------------------------------------------------------------------------

    def StaticTorques(self, HT: Sequence[FloatArray]) -> FloatArray:
        """Return the forces and torques of gravity in all joints, from the transformations of JointHT.

        Static drive forces have the opposite sign.
        """
        return _static_torques(self.links, HT, self.gravity)

    def Dynamics(self, gravity: npt.ArrayLike | None = None) -> TreeDynamics:
        """Return dynamics of the rigid links as functions of states, among them exact derivatives; see treeDynamics.

        Damping, friction and rotors are not in there. gravity is that of the robot unless it is given.
        """
        given = self.gravity if gravity is None else as_vector("Robot: gravity", gravity, 3)
        found = _tree.dynamics(self, given)
        found.linkNumbers = self.LinkNumbers()
        return found

    def _rotors(self) -> FloatArray:
        return np.array([link.rotorInertia for link in self.links])

    def _added_mass(self) -> FloatArray:
        """Return the mass matrix of rotors and tendons."""
        M = np.diag(self._rotors())
        for tendon in self.tendons.values():
            factors = tendon.Factors(self)
            M = M + tendon.inertia * np.outer(factors, factors)
        return M

    def InverseDynamics(
        self, q: npt.ArrayLike, q_t: npt.ArrayLike, q_tt: npt.ArrayLike, gravity: npt.ArrayLike | None = None
    ) -> FloatArray:
        """Return forces and torques of the drives for a motion: inertia, gravity, and minus PassiveForces."""
        at, rates, seconds = (self._coordinates(*each) for each in (("q", q), ("q_t", q_t), ("q_tt", q_tt)))
        rigid = self.Dynamics(gravity).InverseDynamics(at, rates, seconds)
        return rigid - self.PassiveForces(at, rates, gravity) + seconds @ self._added_mass()

    def JointResistance(self, q_t: npt.ArrayLike) -> FloatArray:
        """Return forces and torques of damping and dry friction, which drives have to overcome."""
        rates = self._coordinates("q_t", q_t)
        damping, friction = (np.array([getattr(link, what) for link in self.links]) for what in ("damping", "friction"))
        return np.asarray(damping * rates + friction * np.sign(rates))

    def PassiveForces(self, q: npt.ArrayLike, q_t: npt.ArrayLike, gravity: npt.ArrayLike | None = None) -> FloatArray:
        """Return forces in the joints: springs, damping and friction of joints, tendons, cables; supported masses."""
        at, rates = self._coordinates("q", q), self._coordinates("q_t", q_t)
        weight = -(self.gravity if gravity is None else as_vector("Robot: gravity", gravity, 3))
        return _forces.passive(self, at, rates, weight)

    def ActuatorForces(
        self, controls: npt.ArrayLike | Mapping[str, float], q: npt.ArrayLike, q_t: npt.ArrayLike
    ) -> FloatArray:
        """Return forces and torques of the actuators in the joints; ForwardDynamics takes them as torques.

        controls are one number per actuator, in the order of robot.actuators, or numbers by name, zero for others;
        actuators with dynamics take their activation.
        """
        at, rates = self._coordinates("q", q), self._coordinates("q_t", q_t)
        values = np.moveaxis(self._controls("Robot.ActuatorForces", controls), -1, 0)
        return _forces.of_actuators(self, values, at, rates)

    def _controls(self, where: str, controls: npt.ArrayLike | Mapping[str, float]) -> FloatArray:
        """Return controls in the order of the actuators."""
        if isinstance(controls, Mapping):
            for name in controls:
                if name not in self.actuators:
                    names = ", ".join(self.actuators) or "none"
                    raise ValueError(f"{where}: controls: there is no actuator '{name}'; there are: {names}")
            return np.array([as_number(f"{where}: controls", controls.get(name, 0.0)) for name in self.actuators])
        values = as_array(f"{where}: controls", controls)
        if values.ndim == 0 or values.shape[-1] != len(self.actuators):
            raise shape_error(f"{where}: controls", f"{len(self.actuators)} numbers, one per actuator", controls)
        return values

    def SetControls(self, mbs: Any, made: dict[str, Any], controls: npt.ArrayLike | Mapping[str, float]) -> None:
        """Set the controls of the actuators of a created robot: one number per actuator, or some of them by name.

        made is the result of CreateKinematicTree, CreateRedundantCoordinateMBS or CreateRobot. It may be called before
        a step of a solution as well.
        """
        values = self._controls("Robot.SetControls", controls)
        names = list(controls) if isinstance(controls, Mapping) else list(self.actuators)
        for name, value in zip(self.actuators, values, strict=True):
            if name not in names:
                continue
            if not made["controls"][name]:
                raise ValueError(f"Robot.SetControls: the control of actuator '{name}' is a function of time")
            items = made["actuators"][name]
            for item in items if isinstance(items, list) else [items]:
                change = mbs.SetLoadParameter if isinstance(items, list) else mbs.SetObjectParameter
                change(item, made["controls"][name], float(value))

    def MassMatrix(self, q: npt.ArrayLike) -> FloatArray:
        """Return the mass matrix in the coordinates of the joints."""
        return self.Dynamics().MassMatrix(self._coordinates("q", q)) + self._added_mass()

    def ForwardDynamics(self, q: npt.ArrayLike, q_t: npt.ArrayLike, torques: npt.ArrayLike) -> FloatArray:
        """Return the accelerations that forces and torques of drives bring about, the inverse of InverseDynamics."""
        rates = self._coordinates("q_t", q_t)
        applied = self._coordinates("torques", torques) + self.PassiveForces(q, rates)
        if not self._added_mass().any():
            return self.Dynamics().ForwardDynamics(self._coordinates("q", q), rates, applied)
        bias = self.Dynamics().BiasForces(self._coordinates("q", q), rates)
        return np.asarray(np.linalg.solve(self.MassMatrix(q), (applied - bias)[..., None])[..., 0])

    def KineticEnergy(self, q: npt.ArrayLike, q_t: npt.ArrayLike) -> FloatArray:
        """Return the kinetic energy (J)."""
        rates = self._coordinates("q_t", q_t)
        rotors = 0.5 * np.sum(rates @ self._added_mass() * rates, axis=-1)
        return self.Dynamics().KineticEnergy(self._coordinates("q", q), rates) + rotors

    def PotentialEnergy(self, q: npt.ArrayLike) -> FloatArray:
        """Return the potential energy of the weight (J), zero with all centres of mass in the global origin.

        Springs and supported masses are not in there.
        """
        return self.Dynamics().PotentialEnergy(self._coordinates("q", q))

    def CenterOfMass(self, q: npt.ArrayLike) -> FloatArray:
        """Return the centre of mass of all links in the global frame."""
        return self.Dynamics().CenterOfMass(self._coordinates("q", q))

    # ---- robots as part of a system ----------------------------------------------------------------------------------

    def CreateKinematicTree(
        self,
        mbs: Any,
        name: str = "",
        forceUserFunction: Callable[..., Any] | int = 0,
        limitStiffness: float = 0.0,
        limitDamping: float = 0.0,
        keyframe: str = "",
    ) -> dict[str, Any]:
        """Add the robot to a system as a kinematic tree, on a node with the coordinates of the joints.

        Factors of PDcontrol become those of the tree; jointPositionOffsetVector and jointVelocityOffsetVector of the
        object are the set values of the drives. limitStiffness or limitDamping make joint limits elastic stops.
        keyframe is the name of a state of robot.keyframes, which gives initial values and controls.

        Returns a dict with nodeGeneric, objectKinematicTree, baseObject (the ground that draws the base, or None),
        links (the indices of links and joints by name), resistances (a connector per joint with spring, damping,
        friction or stops, else None), couplings (a constraint per joint that follows another, else None), rotors (an
        object with the inertia of rotors, or None), supports (the loads that carry supported masses), actuators,
        constraints and tendons (their objects by name, of tendons those with forces), controls (the names of the
        parameters of actuators that are the controls, see SetControls), and contacts (the general contacts of
        robot.contacts: as many as the pairs of shapes that touch need, as general contact has no filter of pairs).
        """
        start = self._keyframe("Robot.CreateKinematicTree", keyframe)
        stops = limitStiffness, limitDamping
        return _tree.create(self._driven(start), mbs, name, forceUserFunction, stops, start)

    def _keyframe(self, where: str, name: str) -> RobotKeyframe | None:
        """Return a keyframe by its name, or None for an empty name."""
        if not name:
            return None
        if name not in self.keyframes:
            names = ", ".join(self.keyframes) or "none"
            raise ValueError(f"{where}: keyframe: there is no '{name}'; there are: {names}")
        return self.keyframes[name]

    def _driven(self, start: RobotKeyframe | None) -> Robot:
        """Return the robot with controls and activations of a keyframe."""
        if start is None:
            return self
        robot = copy(self)
        robot.actuators = {
            name: replace(
                actuator,
                control=start.controls.get(name, actuator.control),
                activation=start.activations.get(name, actuator.activation),
            )
            for name, actuator in self.actuators.items()
        }
        return robot

    def CreateRedundantCoordinateMBS(
        self,
        mbs: Any,
        baseMarker: Any,
        jointSpringDamperUserFunctionList: Sequence[Any] = [],
        jointLoadUserFunctionList: Sequence[Any] = [],
        createJointTorqueLoads: bool = True,
        rotationMarkerBase: npt.ArrayLike | None = None,
        rigidBodyNodeType: NodeType = NodeType.RotationEulerParameters,
        name: str = "",
        keyframe: str = "",
    ) -> dict[str, Any]:
        """Add the robot to a system as rigid bodies and joints, on a rigid marker that may move.

        Links with PDcontrol get a torsional, or linear, spring damper with these factors and, where the list has one,
        its user function. Each joint gets two loads, on what carries the link and on the link, given by the user
        functions of loads, or zero until mbs.SetLoadParameter sets them (unitTorque0List and unitTorque1List have their
        directions); with createJointTorqueLoads=False there are only the former. rotationMarkerBase turns the base
        against its marker; without it the base is as base.HT says. Bodies and joints have the names of links and their
        joints, after a name, which tells several robots apart. keyframe is as in CreateKinematicTree, without
        rates. Links of floating joints are free bodies without a joint, as long as nothing acts on the coordinates
        of these joints; their entries in lists are None, but node and body of the last one. Returns a dict with lists
        of one entry per link:
        nodeList, bodyList, jointList, markerList0, markerList1, springDamperList, jointTorque0List, jointTorque1List,
        unitTorque0List, unitTorque1List, springList (springs of joints, or None); baseObject, the ground that draws the
        base, or -1; links, the indices of links and joints by name; supports, the loads that carry supported masses;
        actuators, controls, constraints, tendons and contacts as in CreateKinematicTree.
        """
        robot, start = self, self._keyframe("Robot.CreateRedundantCoordinateMBS", keyframe)
        if start is not None:
            if start.q_t.any():
                raise ValueError(
                    f"Robot.CreateRedundantCoordinateMBS: keyframe '{keyframe}' has rates, which need the "
                    "coordinates of the joints; use CreateKinematicTree"
                )
            robot = self._driven(start)
            robot.referenceConfiguration = start.q.copy()
        return _redundant.create(
            robot,
            mbs,
            baseMarker,
            _redundant.Options(
                jointSpringDamperUserFunctionList,
                jointLoadUserFunctionList,
                createJointTorqueLoads,
                rotationMarkerBase,
                rigidBodyNodeType,
                name,
            ),
        )

    def GetKinematicTree66(self) -> KinematicTree66:
        """Return the robot as KinematicTree66, with inertias in the frames of the joints."""
        transformations, inertias = [], []
        for i, link in enumerate(self.links):
            T = _tree.joint_in_parent(self, i)
            transformations.append(RotationTranslation2T66Inverse(T[:3, :3], T[:3, 3]))
            inertias.append(Inertia2T66(link.JointInertia()))
        parents = [self.GetParentIndex(i) for i in range(len(self.links))]
        types = [link.jointType for link in self.links]
        return KinematicTree66(types, transformations, inertias, parents, self.gravity)

    def GetLinkGraphicsData(
        self,
        i: int | str,
        p0: npt.ArrayLike,
        p1: npt.ArrayLike,
        axis0: npt.ArrayLike,
        axis1: npt.ArrayLike,
        linkVisualization: VRobotLink,
    ) -> GraphicsList:
        """Return how a link is drawn between two joints at p0 and p1, in its frame."""
        index = self.GetLinkIndex(i)
        points = as_vector("p0", p0, 3), as_vector("p1", p1, 3)
        axes = as_vector("axis0", axis0, 3), as_vector("axis1", axis1, 3)
        return _drawing.link_between(self.links[index].COM, points, axes, linkVisualization, is_first=index == 0)

    def BuildFromDictionary(self, robotDict: dict[str, Any]) -> None:
        """Add the links of a dictionary with standard Denavit-Hartenberg parameters; prefer models.LinkDict2Robot."""
        warnings.warn("Robot.BuildFromDictionary is deprecated; use robotics.models.LinkDict2Robot", stacklevel=2)
        for part in ("base", "tool"):
            if part in robotDict:
                getattr(self, part).HT = np.array(robotDict[part]["HT"], dtype=float)
        for vector in ("gravity", "referenceConfiguration"):
            if vector in robotDict:
                setattr(self, vector, np.array(robotDict[vector], dtype=float))
        for i, link in enumerate(robotDict["links"]):
            if "stdDH" not in link:
                raise ValueError(f"Robot.BuildFromDictionary: link {i}: there are no parameters 'stdDH'")
            self.AddLink(RobotLink(link["mass"], link["COM"], link["inertia"], localHT=StdDH2HT(link["stdDH"])))
