"""Robots: links, base and tool, their kinematics and dynamics, and how they become part of a system.

Homogeneous transformations (4x4 matrices) place links and joints. Lengths in m, angles in rad.
"""

from __future__ import annotations

from copy import copy as copy  # models take these from here
from copy import deepcopy as deepcopy

from dalembert.robotics._actuators import RobotActuator
from dalembert.robotics._constraints import RobotCoupling, RobotLoop
from dalembert.robotics._contacts import RobotContact
from dalembert.robotics._denavit_hartenberg import ModDHKK2HT, StdDH2HT, projectAngleToPMPi
from dalembert.robotics._inverse_kinematics import InverseKinematicsNumerical
from dalembert.robotics._parts import RobotBase, RobotKeyframe, RobotLink, RobotTool, VRobotBase, VRobotLink, VRobotTool
from dalembert.robotics._robot import Robot
from dalembert.robotics._tendons import RobotCable, RobotTendon

__all__ = [
    "InverseKinematicsNumerical",
    "ModDHKK2HT",
    "Robot",
    "RobotActuator",
    "RobotBase",
    "RobotCable",
    "RobotContact",
    "RobotCoupling",
    "RobotKeyframe",
    "RobotLink",
    "RobotLoop",
    "RobotTendon",
    "RobotTool",
    "StdDH2HT",
    "VRobotBase",
    "VRobotLink",
    "VRobotTool",
    "copy",
    "deepcopy",
    "projectAngleToPMPi",
]
