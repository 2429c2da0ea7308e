"""Robots from files, and lidar sensors.

ReadRobot reads URDF and MJCF files, with nothing but Python; LoadURDFrobot and GetURDFrobotData give the same as data
for models that make their links themselves.
"""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, as_rotation, as_vector, shape_error
from dalembert._core import ContactTypeIndex
from dalembert._io.files import file_to_read, path_name
from dalembert.robotics import _drawing, _tree
from dalembert.robotics._description import robot_of
from dalembert.robotics._mjcf import read_mjcf
from dalembert.robotics._parts import GraphicsList
from dalembert.robotics._urdf import Packages, read_urdf
from dalembert.robotics._xml import read
from dalembert.robotics.roboticsCore import Robot, RobotBase


def ReadRobot(
    fileName: str | Path,
    baseHT: npt.ArrayLike | None = None,
    gravity: npt.ArrayLike | None = None,
    packages: Packages | None = None,
    graphics: bool = True,
    contacts: bool = False,
) -> Robot:
    """Return the robot of a URDF or MJCF file, with the names of its links and joints.

    Limits, damping, dry friction and inertias of rotors are those of the file, shapes are its graphics. Links that do
    not move are joined to those that carry them, and stay frames of the robot (Robot.FrameHT); joints with several
    coordinates become several joints, joint:0, joint:1 and so on, with links without mass between them. baseHT places
    the robot; gravity (m/s^2) is -9.81 along z, or that of the file. packages has the folders of meshes in URDF files,
    or a dictionary of these by name; graphics=False leaves shapes out. Meshes are STL files, or others with pymeshlab.
    contacts=True lets shapes of an MJCF file touch each other: spheres, capsules, cylinders, boxes and planes, see
    RobotContact. Their springs and dampers have about the penetrations and the damping of MuJoCo's soft contact, which
    is another law.

    ValueError names file, line and element of an error.
    """
    fileName = file_to_read("ReadRobot: fileName", fileName)
    if read(fileName).tag == "mujoco":
        robot = robot_of(read_mjcf(fileName, graphics, contacts))
    elif contacts:
        raise ValueError(
            "ReadRobot: contacts: received True, but URDF files have neither stiffness nor friction of contacts; add "
            "shapes by Robot.AddContact"
        )
    else:
        robot = robot_of(read_urdf(fileName, packages, graphics))
    if gravity is not None:
        robot.gravity = as_vector("ReadRobot: gravity", gravity, 3).copy()
    if baseHT is not None:
        robot.base = RobotBase(baseHT, robot.base.visualization)
    return robot


def LoadURDFrobot(
    urdfFilePath: str | Path,
    urdfBasePath: str | Path,
    gripperLinks: Sequence[int] | None = None,
    manufacturer: str = "",
) -> dict[str, Any]:
    """Return a dict with robot, the Robot of a URDF file below the folder urdfBasePath, where packages of meshes are.

    Its entries urdf, urdfBasePath and urdfFilePath are for GetURDFrobotData; further arguments change nothing.
    """
    folder = path_name("LoadURDFrobot: urdfBasePath", urdfBasePath, "the name of a folder")
    path = Path(folder) / path_name("LoadURDFrobot: urdfFilePath", urdfFilePath)
    if path.suffix == ".xacro":
        raise ValueError(f"LoadURDFrobot: {path}: a xacro file is a program; run xacro of ROS, and load its URDF file")
    robot = ReadRobot(file_to_read("LoadURDFrobot: urdfFilePath", path), packages=urdfBasePath)
    return {"robot": robot, "urdf": robot, "urdfBasePath": str(urdfBasePath), "urdfFilePath": str(urdfFilePath)}


def _colored(parts: GraphicsList, color: Sequence[float] | None) -> GraphicsList:
    """Return graphics in one colour, where there is one."""
    if color is None:
        return list(parts)
    return [part | {"colors": np.tile(color, len(part["points"]) // 3)} for part in parts]


def GetURDFrobotData(
    robot: Robot,
    urdf: Any = None,
    linkColorList: Sequence[Sequence[float]] | None = None,
    staticJointValues: npt.ArrayLike | None = None,
    returnStaticGraphicsList: bool = False,
    exportMesh: bool = False,
    verbose: int = 1,
) -> dict[str, Any]:
    """Return a dict with linkList, numberOfJoints, graphicsBaseList, graphicsToolList and staticJointValues of a robot.

    linkList has a dict per link: name, jointNumber, parentNumber and parentName (-1 and 'None' for the base), preHT,
    jointType, mass, com, inertiaCOM, graphicsDataList, jointLimits, motorViscousFriction, motorCoulombFriction,
    motorGearRatio, motorInertia, and staticHT, its place at staticJointValues. Frames of links are those of their
    joints, so that no localHT is needed. linkColorList gives links other colours; returnStaticGraphicsList adds
    staticGraphicsList, all graphics at their places. exportMesh and verbose change nothing.
    """
    if not isinstance(robot, Robot):
        raise TypeError(
            str(shape_error("GetURDFrobotData: robot", "a Robot, such as LoadURDFrobot(...)['robot']", robot))
        )
    n = robot.NumberOfLinks()
    q = (
        np.zeros(n)
        if staticJointValues is None
        else as_vector("GetURDFrobotData: staticJointValues", staticJointValues, n)
    )
    links, drawn = [], list(_drawing.moved(robot.base.visualization.graphicsData, robot.base.HT))
    for i, (link, T) in enumerate(zip(robot.links, robot.JointHT(q), strict=True)):
        inertia, parent = link.JointInertia(), robot.GetParentIndex(i)
        color = None if linkColorList is None else linkColorList[i]
        parts = _drawing.moved(_colored(link.visualization.graphicsData, color), link.localHT)
        drawn += _drawing.moved(parts, T)
        links.append(
            {
                "name": link.name or f"link{i}",
                "jointNumber": i,
                "parentNumber": parent,
                "parentName": "None" if parent < 0 else robot.links[parent].name or f"link{parent}",
                "preHT": _tree.joint_in_parent(robot, i),
                "inertiaCOM": inertia.InertiaCOM(),
                "com": inertia.COM(),
                "mass": link.mass,
                "jointType": link.jointType,
                "motorViscousFriction": link.damping,
                "motorCoulombFriction": np.array([link.friction, -link.friction]),
                "motorGearRatio": 0,
                "motorInertia": link.rotorInertia,
                "jointLimits": list(np.zeros(2) if link.jointLimits is None else link.jointLimits),
                "staticHT": T,
                "graphicsDataList": parts,
            }
        )
    return {
        "linkList": links,
        "numberOfJoints": n,
        "graphicsBaseList": robot.base.visualization.graphicsData,
        "graphicsToolList": robot.tool.visualization.graphicsData,
        "staticJointValues": q,
        "staticGraphicsList": drawn if returnStaticGraphicsList else [],
    }


def GetRoboticsToolboxInternalModel(modelName: str = "", ignoreURDFerrors: bool = True) -> dict[str, Any]:
    """Return the same as LoadURDFrobot, of a model that the package roboticstoolbox-python knows by name, as 'Puma560'.

    The package must be installed (ImportError). It fetches some models from the internet when they are first used.
    ignoreURDFerrors skips unreadable shapes with a warning; otherwise they raise a ValueError.
    """
    from dalembert.robotics._toolbox import toolbox_model

    model = toolbox_model(modelName)
    try:
        robot = robot_of(read_urdf(model.file, model.packages, True, model.text))
    except ValueError as error:
        if not ignoreURDFerrors:
            raise
        robot = robot_of(read_urdf(model.file, model.packages, False, model.text))
        warnings.warn(f"GetRoboticsToolboxInternalModel: shapes are left out: {error}", stacklevel=2)
    return {"robot": robot, "urdf": robot, "urdfBasePath": str(model.packages), "urdfFilePath": str(model.file)}


def AddLidar(
    mbs: Any,
    generalContactIndex: int,
    positionOrMarker: Any,
    minDistance: float = 0,
    maxDistance: float = 1e7,
    cylinderRadius: float = 0,
    lineLength: float = 1,
    numberOfSensors: int = 100,
    angleStart: float = 0,
    angleEnd: float = 2 * np.pi,
    inclination: float = 0,
    rotation: npt.ArrayLike = np.eye(3),
    selectedTypeIndex: Any = ContactTypeIndex.IndexEndOfEnumList,
    storeInternal: bool = False,
    fileName: str = "",
    measureVelocity: bool = False,
    addGraphicsObject: bool = True,
    drawDisplaced: bool = True,
    color: Sequence[float] = [1.0, 0.0, 0.0, 1.0],
) -> list[Any]:
    """Add distance sensors whose rays form a fan or a cone about the z axis, and return their numbers.

    Rays are lineLength (m) long where they are drawn. They begin at a position or a marker, from angleStart to angleEnd
    (rad, from the x axis), and rise by inclination (rad); rotation turns them all. Other arguments are those of
    mbs.CreateDistanceSensor.
    """
    if numberOfSensors <= 1:
        raise shape_error("AddLidar: numberOfSensors", "a number greater than 1", numberOfSensors)
    A = as_rotation("AddLidar: rotation", rotation)
    return [
        mbs.CreateDistanceSensor(
            generalContactIndex,
            positionOrMarker=positionOrMarker,
            dirSensor=A @ _ray(lineLength, angle, inclination),
            minDistance=minDistance,
            maxDistance=maxDistance,
            cylinderRadius=cylinderRadius,
            selectedTypeIndex=selectedTypeIndex,
            storeInternal=storeInternal,
            fileName=fileName,
            measureVelocity=measureVelocity,
            addGraphicsObject=addGraphicsObject,
            drawDisplaced=drawDisplaced,
            color=color,
        )
        for angle in np.linspace(angleStart, angleEnd, numberOfSensors)
    ]


def _ray(length: float, angle: float, inclination: float) -> FloatArray:
    """Return a ray from its angles."""
    flat = np.cos(inclination)
    return length * np.array([flat * np.cos(angle), flat * np.sin(angle), np.sin(inclination)])
