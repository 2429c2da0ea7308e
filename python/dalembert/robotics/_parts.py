"""Parts of robots: links with their joints, base and tool, and their graphics."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy, deepcopy
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, as_color, as_matrix, as_number, as_transformation, as_vector, shape_error
from dalembert._core import JointType
from dalembert._geometry.inertia import RigidBodyInertia
from dalembert._geometry.rigid_transformation import HT as HomogeneousTransformation
from dalembert._geometry.rigid_transformation import sharing
from dalembert._geometry.transformations import HT0

GraphicsList = list[dict[str, Any]]

# Joints by their short names: revolute about, or prismatic along, a local axis.
JOINT_TYPES = {
    f"{letter}{axis}": JointType.__members__[f"{name}{axis.upper()}"]
    for letter, name in (("R", "Revolute"), ("P", "Prismatic"))
    for axis in "xyz"
}
JOINT_AXES: dict[str, FloatArray] = {name: np.eye(3)["xyz".index(name[1])] for name in JOINT_TYPES}

REGULAR_VELOCITY = 1e-2  # rad/s or m/s: below it dry friction is proportional to velocity
PREVIOUS_LINK = -2  # as parent: the link that was added before


def _transformation(name: str, HT: npt.ArrayLike | None) -> FloatArray:
    """Return a copy of a homogeneous transformation, such as exu.HT or a 4x4 matrix; None is the unit matrix."""
    return HT0() if HT is None else as_transformation(name, HT).copy()


class _Transformation:
    """Attribute that is an HT; its matrix, for computations, has the same name after an underscore."""

    def __set_name__(self, owner: type, name: str) -> None:
        self._where, self._stored = f"{owner.__name__}: {name}", f"_{name}"

    def __get__(self, part: Any, owner: type | None = None) -> HomogeneousTransformation:
        if part is None:
            raise AttributeError(f"{self._where} is an attribute of objects, not of their class")
        return sharing(vars(part)[self._stored])

    def __set__(self, part: Any, value: npt.ArrayLike | None) -> None:
        vars(part)[self._stored] = _transformation(self._where, value)


def is_revolute(jointType: str) -> bool:
    """Whether a joint turns; else it slides."""
    return jointType[0] == "R"


class VRobotLink:
    """Graphics of a link: sizes (m) of its joint and of the bar to the next joint, or graphicsData in its frame.

    graphicsData replaces the bar; showMBSjoint and showCOM also draw joint and center of mass.
    """

    def __init__(
        self,
        jointRadius: float = 0.06,
        jointWidth: float = 0.12,
        linkWidth: float = 0.1,
        showMBSjoint: bool = True,
        showCOM: bool = True,
        linkColor: Sequence[float] = [0.4, 0.4, 0.4, 1],
        graphicsData: GraphicsList = [],
    ) -> None:
        if not isinstance(graphicsData, (list, tuple)):
            raise shape_error("VRobotLink: graphicsData", "a list of graphicsData", graphicsData)
        self.jointRadius = jointRadius
        self.jointWidth = jointWidth
        self.linkWidth = linkWidth
        self.showMBSjoint = showMBSjoint
        self.showCOM = showCOM
        self.linkColor = as_color("VRobotLink: linkColor", linkColor).tolist()
        self.graphicsData = list(graphicsData)

    def copied(self) -> VRobotLink:
        """Return graphics that share nothing with these; quicker than deepcopy, which asks what each number is."""
        made = copy(self)
        made.linkColor, made.graphicsData = list(self.linkColor), deepcopy(self.graphicsData)
        return made

    def __repr__(self) -> str:
        values = vars(self) | {"graphicsData": "[...]" if self.graphicsData else "[]"}
        return "\n".join(f"  {name} = {value}" for name, value in values.items())


class RobotLink:
    """A link and its parent joint.

    preHT is the transformation from the frame of the parent link to the joint; the joint rotates about ('Rx', 'Ry',
    'Rz')
    or translates along ('Px', 'Py', 'Pz') its own axis (rad or m); localHT is the transformation to the frame of the
    link, in which COM (m) and
    inertia (kg*m^2, about the centre of mass) are given. parent is the index or name of another link, -1 the base, -2
    the link before. PDcontrol are the factors of position and velocity of a drive.

    Besides, a joint may have limits of its coordinate, of its velocity and of the force or torque of its drive; viscous
    damping (Nms/rad or Ns/m), dry friction (Nm or N), and the inertia of a rotor as it acts at the joint. It may follow
    another joint: follows=(joint, factor, offset), as the second finger of a gripper does. A spring of the given
    stiffness (Nm/rad or N/m) has no force at the coordinate springReference. A mechanism that is not part of the model
    may carry the weight of masses in the link: supported has tuples of a mass (kg) and its position in the link. Names
    of link and joint may be given wherever a robot takes the index of a link.
    """

    localHT = _Transformation()
    preHT = _Transformation()

    def __init__(
        self,
        mass: float,
        COM: npt.ArrayLike,
        inertia: npt.ArrayLike,
        localHT: npt.ArrayLike | None = None,
        jointType: str = "Rz",
        parent: int | str = PREVIOUS_LINK,
        preHT: npt.ArrayLike | None = None,
        PDcontrol: Sequence[float | None] | None = (None, None),
        visualization: VRobotLink | None = None,
        name: str = "",
        jointName: str = "",
        jointLimits: Sequence[float] | None = None,
        maxVelocity: float | None = None,
        maxForce: float | None = None,
        damping: float = 0.0,
        friction: float = 0.0,
        rotorInertia: float = 0.0,
        follows: tuple[str, float, float] | None = None,
        stiffness: float = 0.0,
        springReference: float = 0.0,
        supported: Sequence[tuple[float, npt.ArrayLike]] = (),
    ) -> None:
        amounts = {
            "mass": mass,
            "damping": damping,
            "friction": friction,
            "rotorInertia": rotorInertia,
            "stiffness": stiffness,
        }
        for what, value in amounts.items():
            as_number(f"RobotLink: {what}", value, negative=False)
        if jointType not in JOINT_TYPES:
            raise shape_error("RobotLink: jointType", f"one of {', '.join(JOINT_TYPES)}", jointType)
        self.mass = mass
        self.COM = as_vector("RobotLink: COM", COM, 3).copy()
        self.inertia = as_matrix("RobotLink: inertia", inertia, (3, 3)).copy()
        self.localHT = localHT
        self.preHT = preHT
        self.jointType = jointType
        self.parent = parent
        self.visualization = visualization.copied() if visualization is not None else VRobotLink()
        self.PDcontrol: tuple[float, float] | None = None
        if PDcontrol is not None and not (hasattr(PDcontrol, "__len__") and len(PDcontrol) == 2):
            raise shape_error("RobotLink: PDcontrol", "two numbers", PDcontrol)
        if PDcontrol is not None and PDcontrol[0] is not None:
            self.SetPDcontrol(*PDcontrol)
        self.name, self.jointName = name, jointName
        self.jointLimits = None if jointLimits is None else as_vector("RobotLink: jointLimits", jointLimits, 2).copy()
        if self.jointLimits is not None and not self.jointLimits[0] <= self.jointLimits[1]:
            raise shape_error("RobotLink: jointLimits", "[lower, upper] with lower <= upper", jointLimits)
        self.maxVelocity, self.maxForce = maxVelocity, maxForce
        self.damping, self.friction, self.rotorInertia = damping, friction, rotorInertia
        self.follows = follows
        self.stiffness, self.springReference = stiffness, as_number("RobotLink: springReference", springReference)
        self.supported = [
            (as_number("RobotLink: supported", m), as_vector("RobotLink: supported", r, 3)) for m, r in supported
        ]

    def _copied(self) -> RobotLink:
        """Return a link that shares no array with this one; quicker than deepcopy, which asks what each number is."""
        made = copy(self)
        for name, value in vars(self).items():
            if isinstance(value, np.ndarray | list):
                setattr(made, name, value.copy())
        made.visualization = self.visualization.copied()
        return made

    def SetPDcontrol(self, Pvalue: float | None, Dvalue: float | None) -> None:
        """Set the factors of position and velocity of the drive of the joint."""
        if Pvalue is None or Dvalue is None:
            raise shape_error("RobotLink: PDcontrol", "two numbers", (Pvalue, Dvalue))
        for value in (Pvalue, Dvalue):
            as_number("RobotLink: PDcontrol", value)
        self.PDcontrol = (Pvalue, Dvalue)

    def HasPDcontrol(self) -> bool:
        """Return whether the joint has a drive."""
        return self.PDcontrol is not None

    def GetPDcontrol(self) -> tuple[float, float]:
        """Return the factors of the drive; ValueError if there is none."""
        if self.PDcontrol is None:
            raise ValueError(f"RobotLink{self._called()}: there is no PDcontrol; set it by SetPDcontrol")
        return self.PDcontrol

    def JointInertia(self) -> RigidBodyInertia:
        """Return mass, centre of mass and inertia in the frame of the joint, as it is after its motion."""
        inertia = RigidBodyInertia()
        inertia.SetWithCOMinertia(self.mass, self.inertia, self.COM)
        return inertia.Transformed(self.localHT)

    def _called(self) -> str:
        return f" '{self.name}'" if self.name else ""

    def __repr__(self) -> str:
        shown = {name.lstrip("_"): str(value) for name, value in vars(self).items() if value is not None}
        lines = [f"  {name} = {value}" for name, value in shown.items() if value and name != "visualization"]
        return "\n".join([*lines, "  visualization:", repr(self.visualization)])


@dataclass
class RobotKeyframe:
    """A state of a robot: coordinates and rates of the joints, controls and activations of actuators by name."""

    name: str
    q: FloatArray
    q_t: FloatArray
    controls: dict[str, float] = field(default_factory=dict)
    activations: dict[str, float] = field(default_factory=dict)
    time: float = 0.0


class VRobotTool:
    """How a tool is drawn: graphicsData in its frame."""

    def __init__(self, graphicsData: GraphicsList = []) -> None:
        self.graphicsData = copy(graphicsData)


class VRobotBase:
    """How a base is drawn: graphicsData in its frame."""

    def __init__(self, graphicsData: GraphicsList = []) -> None:
        self.graphicsData = copy(graphicsData)


class RobotTool:
    """The tool: HT leads from the frame of the last link to it."""

    HT = _Transformation()

    def __init__(self, HT: npt.ArrayLike | None = None, visualization: VRobotTool | None = None) -> None:
        self.HT = HT
        self.visualization = visualization if visualization is not None else VRobotTool()

    def __repr__(self) -> str:
        return f"  HT = {self.HT}"


class RobotBase:
    """The base: HT leads from the global frame to it."""

    HT = _Transformation()

    def __init__(self, HT: npt.ArrayLike | None = None, visualization: VRobotBase | None = None) -> None:
        self.HT = HT
        self.visualization = visualization if visualization is not None else VRobotBase()

    def __repr__(self) -> str:
        return f"  HT = {self.HT}"
