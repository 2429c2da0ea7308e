"""The Create function of robots of files, as parts of a system."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy.typing as npt

from dalembert._checks import TRANSFORMATION, FloatArray, as_vector, rotation_problem
from dalembert._io.files import file_to_read
from dalembert._tools.found_items import index_of
from dalembert.create._arguments import FLAG, NOT_NEGATIVE, Check, argument_error, matrix, refined, vector


def _transformation_problem(value: FloatArray) -> str:
    if not (value[3] == [0, 0, 0, 1]).all():
        return f"Its last row is {value[3].tolist()}."
    return rotation_problem(value[:3, :3])


CHECKS: dict[str, dict[str, Check]] = {
    "CreateRobot": {
        "baseHT": refined(matrix(4), TRANSFORMATION, _transformation_problem).optional(),
        "gravity": vector(3).optional(),
        "graphics": FLAG,
        "contacts": FLAG,
        "limitStiffness": NOT_NEGATIVE,
        "limitDamping": NOT_NEGATIVE,
    },
}
TEXTS = {
    "CreateRobot": {
        "fileName": "URDF or MJCF file of the robot",
        "name": "prefix of the names of links and joints, which distinguishes several robots",
        "baseHT": "homogeneous transformation from the base to the global frame; None: as in the file",
        "gravity": "acceleration of gravity (m/s^2); None: that of the file, or 9.81 against z",
        "referenceConfiguration": "coordinates of the joints (m, rad) without those that follow; None: as in the file",
        "packages": "folders of meshes in URDF files, or a dictionary of these by the name of the package",
        "graphics": "True: links are drawn with the shapes of the file",
        "baseMarker": "rigid marker that carries the base, which may move, by its index or name; None for ground",
        "forceUserFunction": "function or controller for the forces in the joints, as that of the kinematic tree",
        "limitStiffness": "stiffness of stops at the limits of the joints (N/m, Nm/rad); 0 for none",
        "limitDamping": "damping of stops at the limits of the joints (Ns/m, Nms/rad)",
        "contacts": "True: spheres, capsules, cylinders, boxes and planes of an MJCF file touch each other",
        "keyframe": "name of a keyframe of the file, which gives initial values and controls; empty: none",
    },
}


def CreateRobot(
    mbs: Any,
    fileName: str | Path,
    name: str = "",
    baseHT: npt.ArrayLike | None = None,
    gravity: npt.ArrayLike | None = None,
    referenceConfiguration: npt.ArrayLike | None = None,
    packages: Any = None,
    graphics: bool = True,
    baseMarker: Any = None,
    forceUserFunction: Callable[..., Any] | int = 0,
    limitStiffness: float = 0.0,
    limitDamping: float = 0.0,
    keyframe: str = "",
    contacts: bool = False,
) -> dict[str, Any]:
    """Add the robot of a URDF or MJCF file; return a dict with robot, the Robot, and the items that were added.

    The default is a kinematic tree, and the dict also has the result of Robot.CreateKinematicTree. If baseMarker is
    given, the robot consists of rigid bodies and joints, and the dict has the result of
    Robot.CreateRedundantCoordinateMBS. Its entry links has the indices of links and joints by name. Springs, damping
    and dry friction of the file are included, and contacts if they are wanted: their law is not that of MuJoCo, see
    ReadRobot. Bodies that float freely should have a baseMarker, as trees have singular positions.
    """
    from dalembert.robotics.utilities import ReadRobot  # a system without robots does without

    fileName = file_to_read("CreateRobot: fileName", fileName)
    if baseMarker is not None:
        of_trees = {
            "forceUserFunction": forceUserFunction,
            "limitStiffness": limitStiffness,
            "limitDamping": limitDamping,
        }
        if wrong := next((name for name, value in of_trees.items() if value), ""):
            expected = "0 with a baseMarker, as it belongs to kinematic trees"
            raise argument_error("CreateRobot", wrong, expected, of_trees[wrong])
        baseMarker = index_of(mbs, "Marker", baseMarker, "MainSystem.CreateRobot(...): argument 'baseMarker'")
    robot = ReadRobot(fileName, baseHT, gravity, packages, graphics, contacts)
    if robot.NumberOfLinks() == 0:
        raise argument_error("CreateRobot", "fileName", "a robot with a joint that moves", fileName)
    if referenceConfiguration is not None:
        where = "CreateRobot: referenceConfiguration"
        given = as_vector(where, referenceConfiguration, robot.NumberOfLinks())
        robot.referenceConfiguration = robot.FollowedCoordinates(given)
    if baseMarker is None:
        made = robot.CreateKinematicTree(mbs, name, forceUserFunction, limitStiffness, limitDamping, keyframe)
    else:
        made = robot.CreateRedundantCoordinateMBS(
            mbs, baseMarker, createJointTorqueLoads=False, name=name, keyframe=keyframe
        )
    return {"robot": robot, **made}
