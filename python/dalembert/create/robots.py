"""Robots of files, as parts of a system."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy.typing as npt

from dalembert._checks import as_vector
from dalembert._io.files import file_to_read


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
) -> dict[str, Any]:
    """Add the robot of a URDF or MJCF file; return a dict with robot, the Robot, and the items that were added.

    It becomes a kinematic tree; with a rigid baseMarker, which may move, rigid bodies and joints. The dict has what
    Robot.CreateKinematicTree or Robot.CreateRedundantCoordinateMBS returns; its entry links has the indices of links
    and joints by name. Damping and dry friction act, and with limitStiffness or limitDamping limits are stops. baseHT,
    gravity, packages and graphics are those of robotics.utilities.ReadRobot; referenceConfiguration has the coordinates
    of the joints; those that follow others (<mimic>) go with these.
    """
    from dalembert.robotics.utilities import ReadRobot  # a system without robots does without

    fileName = file_to_read("CreateRobot: fileName", fileName)
    if baseMarker is not None and (forceUserFunction or limitStiffness or limitDamping):
        raise ValueError(
            "CreateRobot: forceUserFunction, limitStiffness and limitDamping belong to kinematic trees; leave out "
            "either these or baseMarker"
        )
    robot = ReadRobot(fileName, baseHT, gravity, packages, graphics)
    if referenceConfiguration is not None:
        where = "CreateRobot: referenceConfiguration"
        given = as_vector(where, referenceConfiguration, robot.NumberOfLinks())
        robot.referenceConfiguration = robot.FollowedCoordinates(given)
    if baseMarker is None:
        made = robot.CreateKinematicTree(mbs, name, forceUserFunction, limitStiffness, limitDamping)
    else:
        made = robot.CreateRedundantCoordinateMBS(mbs, baseMarker, createJointTorqueLoads=False, name=name)
    return {"robot": robot, **made}
