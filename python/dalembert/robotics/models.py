"""Data of standard robots, as dictionaries, and robots made of them.

A dictionary has links, each with Denavit-Hartenberg parameters (stdDH: theta, d, a, alpha; modDHKK: alpha, d, theta,
r), mass (kg), COM (m) and inertia about it (kg*m^2), and data of the joint: jointLimits (rad), jointTorqueMax
(Nm), jointStiffness (Nm/rad). dhMode selects the kind of frames of COM and inertia. Besides there are
base and tool, gravity (m/s^2), referenceConfiguration, and factors of drives, Pcontrol and Dcontrol, which are assumed.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import pi
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from dalembert import graphics
from dalembert._geometry.inertia import RigidBodyInertia
from dalembert._geometry.rigid_transformation import HT
from dalembert._geometry.transformations import HTrotateX, HTrotateY, HTtranslate, InverseHT
from dalembert.robotics.roboticsCore import ModDHKK2HT, Robot, RobotBase, RobotLink, RobotTool, StdDH2HT, VRobotLink

HALF = pi / 2


class _Link(NamedTuple):
    """A row of a table of links; inertia is diagonal, or xx, yy, zz, xy, xz, yz."""

    stdDH: Sequence[float]
    mass: float
    inertia: Sequence[float]
    com: Sequence[float]
    stiffness: float
    torque: float
    limits: Sequence[float] = (-pi, pi)


def _tensor(values: Sequence[float]) -> npt.NDArray[np.float64]:
    xx, yy, zz, xy, xz, yz = (*values, 0.0, 0.0, 0.0)[:6]
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def _robot(
    rows: Sequence[_Link],
    tool: npt.NDArray[np.float64],
    P: Sequence[float],
    D: Sequence[float],
    dhMode: str = "stdDH",
) -> dict[str, Any]:
    """Return the dictionary of a robot with revolute joints.

    The modified parameters of a link begin with those standard ones of the link before that follow its axis.
    """
    before = [(0.0, 0.0), *((row.stdDH[3], row.stdDH[2]) for row in rows)]
    links = [
        {
            "stdDH": list(row.stdDH),
            "modDHKK": [alpha, a, row.stdDH[0], row.stdDH[1]],
            "mass": row.mass,
            "inertia": _tensor(row.inertia),
            "jointStiffness": row.stiffness,
            "jointTorqueMax": row.torque,
            "jointLimits": list(row.limits),
            "COM": list(row.com),
        }
        for row, (alpha, a) in zip(rows, before, strict=False)
    ]
    return {
        "links": links,
        "jointType": [1] * len(rows),
        "jointStiffnessMatrix": np.diag([row.stiffness for row in rows]),
        "joinTorqueMaxMatrix": np.diag([row.torque for row in rows]),
        "base": {"HT": HT()},
        "tool": {"HT": HT(tool)},
        "gravity": [0, 0, -9.81],
        "referenceConfiguration": [0] * len(rows),
        "dhMode": dhMode,
        "Pcontrol": np.array(P),
        "Dcontrol": np.array(D),
    }


def Manipulator4Rsimple() -> dict[str, Any]:
    """Return a planar arm of two bars on a column; masses are round figures, inertias those of a larger robot."""
    rows = (
        _Link([0, 0, 0, 0], 4, [0.70337, 0.70661, 0.009117, -0.000139, 0.006772, 0.0192169], [0, 0, 0], 70000, 50),
        _Link(
            [0, 0, 0.25, 0], 1, [0.007962, 0.02811, 0.025995, -0.003925, 0.010254, 0.000704], [0.125, 0, 0], 70000, 50
        ),
        _Link(
            [0, 0, 0.25, 0], 1, [0.037242, 0.036155, 0.01083, -0.004761, -0.011396, -0.012805], [0.125, 0, 0], 70000, 50
        ),
    )
    return _robot(rows, HTrotateX(HALF) @ HTrotateY(HALF), [1000, 1000, 100, 100], [10, 10, 10, 10])


def Manipulator3RSimple() -> dict[str, Any]:
    """Return an elbow manipulator of a column and two bars of 0.5 m.

    C. Woernle, Mehrkoerpersysteme, Springer, 2016: the example of a manipulator with three revolute joints.
    """
    rows = (
        _Link([0, 0.5, 0, HALF], 3, [0.1, 0.2, 0.3], [0, -0.4, 0], 70000, 50),
        _Link([0, 0, 0.5, 0], 2, [0.5, 0.6, 0.7], [-0.4, 0, 0], 60000, 90),
        _Link([0, 0, 0.5, 0], 1, [0.8, 0.9, 0.1], [-0.4, 0, 0], 20000, 50),
    )
    return _robot(rows, HTtranslate([0, 0, 0.5]), [1000, 1000, 100], [10, 10, 10])


def ManipulatorPANDA() -> dict[str, Any]:
    """Return the Franka Emika Panda with seven joints; COM and inertia in the frames of modified parameters.

    Inertia: C. Gaz, M. Cognetti, A. Oliva, P. Robuffo Giordano, A. De Luca, Dynamic identification of the Franka Emika
    Panda robot with retrieval of feasible parameters using penalty-based optimization, IEEE Robotics and Automation
    Letters 4, 2019. Lengths, limits and torques: data sheet of the robot.
    """
    rows = (
        _Link(
            [0, 0.333, 0, -HALF],
            4.970684,
            [0.703370, 0.706610, 0.009117, -0.000139, 0.006772, 0.0192169],
            [3.875e-03, 2.081e-03, -0.1750],
            1,
            87,
            [-2.8973, 2.8973],
        ),
        _Link(
            [0, 0, 0, HALF],
            0.646926,
            [0.007962, 0.028110, 0.025995, -0.003925, 0.010254, 0.000704],
            [-3.141e-03, -2.872e-02, 3.495e-03],
            1,
            87,
            [-1.7628, 1.7628],
        ),
        _Link(
            [0, 0.316, 0.0825, HALF],
            3.228604,
            [0.037242, 0.036155, 0.010830, -0.004761, -0.011396, -0.012805],
            [2.7518e-02, 3.9252e-02, -6.6502e-02],
            1,
            87,
            [-2.8973, 2.8973],
        ),
        _Link(
            [0, 0, -0.0825, -HALF],
            3.587895,
            [0.025853, 0.019552, 0.028323, 0.007796, -0.001332, 0.008641],
            [-5.317e-02, 1.04419e-01, 2.7454e-02],
            1,
            87,
            [-3.0718, -0.0698],
        ),
        _Link(
            [0, 0.384, 0, HALF],
            1.225946,
            [0.035549, 0.029474, 0.008627, -0.002117, -0.004037, 0.000229],
            [-1.1953e-02, 4.1065e-02, -3.8437e-02],
            1,
            12,
            [-2.8973, 2.8973],
        ),
        _Link(
            [0, 0, 0.088, HALF],
            1.666555,
            [0.001964, 0.004354, 0.005433, 0.000109, -0.001158, 0.000341],
            [6.0149e-02, -1.4117e-02, -1.0517e-02],
            1,
            12,
            [-0.0175, 3.7525],
        ),
        _Link(
            [0, 0.107, 0, 0],
            0.735522,
            [0.012516, 0.010027, 0.004815, -0.000428, -0.001196, -0.000741],
            [1.0517e-02, -4.252e-03, 6.1597e-02],
            1,
            12,
            [-2.8973, 2.8973],
        ),
    )
    P, D = [40000, 40000, 40000, 100, 100, 100, 10], [400, 400, 100, 1, 1, 1, 0.1]
    return _robot(rows, HTtranslate([0, 0, 0.11]), P, D, dhMode="modDHKK")


def ManipulatorUR5() -> dict[str, Any]:
    """Return the Universal Robots UR5 with six joints; stiffnesses are assumed.

    P. M. Kebria, S. Al-wais, H. Abdi, S. Nahavandi, Kinematic and dynamic modelling of UR5 manipulator, IEEE Int. Conf.
    Systems, Man, and Cybernetics, 2016; K. Kufieta, Force estimation in robotic manipulators, NTNU Trondheim, 2014.
    """
    turn = [-2 * pi, 2 * pi]
    rows = (
        _Link([0, 0.089459, 0, HALF], 3.7, [0.0084, 0.0064, 0.0084], [0, -0.02561, 0.00193], 1000, 150, turn),
        _Link([0, 0, -0.425, 0], 8.393, [0.0078, 0.0021, 0.0021], [0.2125, 0, 0.11336], 1000, 150, turn),
        _Link([0, 0, -0.39225, 0], 2.33, [0.0016, 0.0462, 0.0462], [0.15, 0, 0.0265], 1000, 150, turn),
        _Link([0, 0.10915, 0, HALF], 1.219, [0.0016, 0.0016, 0.0009], [0, -0.0018, 0.01634], 1000, 28, turn),
        _Link([0, 0.09465, 0, -HALF], 1.219, [0.0016, 0.0016, 0.0009], [0, -0.0018, 0.01634], 1000, 28, turn),
        _Link([0, 0.0823, 0, 0], 0.1897, [0.0001, 0.0001, 0.0001], [0, 0, -0.001159], 1000, 28, turn),
    )
    return _robot(rows, HTtranslate([0, 0, 0]), [40000, 40000, 40000, 100, 100, 10], [400, 400, 100, 1, 1, 0.1])


def ManipulatorPuma560() -> dict[str, Any]:
    """Return the Unimation Puma 560 with six joints.

    B. Armstrong, O. Khatib, J. Burdick, The explicit dynamic model and inertial parameters of the PUMA 560 arm, IEEE
    ICRA, 1986; P. I. Corke, B. Armstrong-Helouvry, A search for consensus among model parameters reported for the PUMA
    560 robot, IEEE ICRA, 1994. Torques and limits: P. I. Corke, Visual control of robots, 1996; stiffness: Kim, 1995.
    """
    rows = (
        _Link([0, 0, 0, HALF], 20, [0, 0.35, 0], [0, 0, 0], 68000, 56),
        _Link([0, 0, 0.4318, 0], 17.4, [0.13, 0.524, 0.539], [-0.3638, 0.006, 0.2275], 66500, 97, [-2.9671, 2.8798]),
        _Link(
            [0, 0.15005, 0.0203, -HALF],
            4.8,
            [0.066, 0.086, 0.0125],
            [-0.0203, -0.0141, 0.07],
            11650,
            52,
            [-2.79253, 2.61799],
        ),
        _Link([0, 0.4318, 0, HALF], 0.82, [0.0018, 0.0013, 0.0018], [0, 0.019, 0], 2150, 10),
        _Link([0, 0, 0, -HALF], 0.34, [0.0003, 0.0004, 0.0003], [0, 0, 0], 1130, 10, [-0.17453, 1.74533]),
        _Link([0, 0, 0, 0], 0.09, [0.00015, 0.00015, 4e-5], [0, 0, 0.032], 1680, 10),
    )
    return _robot(rows, HTtranslate([0, 0, 0]), [40000, 40000, 40000, 100, 100, 10], [400, 400, 100, 1, 1, 0.1])


def _robot_of(robotLinkDict: dict[str, Any], robotClass: Robot | None) -> Robot:
    """Return the robot that links are added to."""
    if robotClass is not None:
        return robotClass
    return Robot(
        gravity=robotLinkDict.get("gravity", [0, 0, 0]),
        base=RobotBase(HT=robotLinkDict["base"]["HT"]) if "base" in robotLinkDict else None,
        tool=RobotTool(HT=robotLinkDict["tool"]["HT"]) if "tool" in robotLinkDict else None,
        referenceConfiguration=robotLinkDict.get("referenceConfiguration", []),
    )


def _of_joint(robotLinkDict: dict[str, Any], i: int) -> dict[str, Any]:
    """Return the data of a joint, as arguments of RobotLink."""
    link = robotLinkDict["links"][i]
    factors = [robotLinkDict.get(which) for which in ("Pcontrol", "Dcontrol")]
    return {
        "PDcontrol": tuple(None if values is None else values[i] for values in factors),
        "jointLimits": link.get("jointLimits"),
        "maxForce": link.get("jointTorqueMax"),
        "visualization": VRobotLink(linkColor=graphics.colorList[i % len(graphics.colorList)]),
    }


def LinkDict2Robot(robotLinkDict: dict[str, Any], robotClass: Robot | None = None) -> Robot:
    """Return the robot of a dictionary, in the frames that its dhMode names.

    A given robot is extended by the links, and keeps its gravity, base and tool.
    """
    robot, mode = _robot_of(robotLinkDict, robotClass), robotLinkDict.get("dhMode")
    if mode not in ("stdDH", "modDHKK"):
        raise ValueError(f"LinkDict2Robot: dhMode: expected 'stdDH' or 'modDHKK', received {mode!r}")
    for i, link in enumerate(robotLinkDict["links"]):
        before, after = (np.eye(4), StdDH2HT(link["stdDH"])) if mode == "stdDH" else ModDHKK2HT(link["modDHKK"])
        inertia = link["mass"], link["COM"], link["inertia"]
        robot.AddLink(RobotLink(*inertia, localHT=after, preHT=before, **_of_joint(robotLinkDict, i)))
    return robot


def LinkDictModDHKK2Robot(robotLinkDict: dict[str, Any], robotClass: Robot | None = None) -> Robot:
    """Return the robot of a dictionary in frames of modified parameters, for both kinds of frames of its inertias.

    The last link then ends where its axis does: a and alpha of its standard parameters are left to the tool.
    """
    if robotLinkDict.get("dhMode") == "modDHKK":
        return LinkDict2Robot(robotLinkDict, robotClass)
    robot = _robot_of(robotLinkDict, robotClass)
    for i, link in enumerate(robotLinkDict["links"]):
        if "modDHKK" not in link:
            raise ValueError(f"LinkDictModDHKK2Robot: link {i}: there are no parameters 'modDHKK'")
        before, after = ModDHKK2HT(link["modDHKK"])
        inertia = RigidBodyInertia()
        inertia.SetWithCOMinertia(link["mass"], link["inertia"], link["COM"])
        inertia = inertia.Transformed(InverseHT(after) @ StdDH2HT(link["stdDH"]))
        values = inertia.Mass(), inertia.COM(), inertia.InertiaCOM()
        robot.AddLink(RobotLink(*values, localHT=after, preHT=before, **_of_joint(robotLinkDict, i)))
    return robot
