"""Springs, actuators and constraints of MJCF files, against MuJoCo at random states where that is installed."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert import itemInterface as items
from dalembert.robotics.utilities import ReadRobot

# A chain of a slider and two hinges about skew axes, and a hinge beside it; {} are further attributes of the joints.
ARM = """<body name="a" pos="0 0 1"><joint name="s" type="slide" axis="1 0 .2" armature=".1" {0}/>
<geom type="box" size=".1 .2 .3" density="200"/>
<body name="b" pos=".3 0 0" {4}><joint name="j" axis="0 1 .3" ref="20" {1}/>
<geom type="capsule" fromto="0 0 0 .4 0 .1" size=".05"/>
<body name="c" pos=".4 0 .1" {5}><joint name="k" axis="1 0 1" {2}/><geom size=".1" pos=".2 .1 0"/><site name="tip" pos=".3 0 .1"/>
<body name="fixed" pos="0 .3 0" {6}><geom size=".08" pos=".1 0 0"/></body></body></body>
<body name="d" pos="-.4 0 .1"><joint name="l" axis="0 0 1" pos="0 .1 0" {3}/><geom type="box" size=".2 .1 .05" pos=".2 0 0"/>
<site name="side" pos=".4 0 0"/></body></body>"""


def model(arm: str, before: str = "", after: str = "") -> str:
    option = '<option gravity="1 -2 -9"/>'  # no contact: MuJoCo would have one
    return f'<mujoco>{option}<default><geom contype="0" conaffinity="0"/></default>{before}<worldbody>{arm}</worldbody>{after}</mujoco>'


def arm(*joints: str, bodies: tuple[str, str, str] = ("", "", "")) -> str:
    return ARM.format(*[*joints, "", "", "", ""][:4], *bodies)


def read(path: Path, text: str) -> tuple[Any, list[str]]:
    path.write_text(text)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        robot = ReadRobot(path, graphics=False)
    return robot, [str(warning.message) for warning in told]


def in_mujoco(path: Path) -> tuple[Any, Any, Any]:
    mujoco = pytest.importorskip("mujoco", reason="mujoco is installed by the extra [oracles]")
    made = mujoco.MjModel.from_xml_path(str(path))
    return mujoco, made, mujoco.MjData(made)


def states(n: int, count: int = 3) -> Any:
    return np.random.default_rng(7).uniform(-1, 1, (count, 3, n))


def accelerations(robot: Any, q: Any, v: Any) -> Any:
    """Return the accelerations of the assembled tree at a state, which the solver computes at the start."""
    mbs = exu.SystemContainer().AddSystem()
    made = robot.CreateKinematicTree(mbs)
    node = made["nodeGeneric"]
    mbs.SetNodeParameter(node, "initialCoordinates", q - robot.referenceConfiguration)
    mbs.SetNodeParameter(node, "initialCoordinates_t", v)
    sensor = mbs.AddSensor(
        items.SensorNode(
            nodeNumber=node,
            outputVariableType=exu.OutputVariableType.Coordinates_tt,
            storeInternal=True,
            writeToFile=False,
        )
    )
    solve(mbs, 1e-6, 1)
    return mbs.GetSensorStoredData(sensor)[0, 1:]


def solve(mbs: Any, duration: float, steps: int) -> None:
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = settings.solutionSettings.sensorsWriteFileHeader = False
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = duration, steps
    mbs.SolveDynamic(settings)


CARRIED = {
    "springs": model(arm('stiffness="30" springref=".2"', 'stiffness="4" springref="50" damping="2"', 'stiffness="3"')),
    "oscillators": model(arm('springdamper=".2 .7"', 'springdamper=".5 1"', 'stiffness="3"', 'springdamper=".1 2"')),
    "supported weight": model(arm(bodies=('gravcomp="1"', 'gravcomp=".5"', 'gravcomp="1.2"'))),
    "springs switched off": model(arm('stiffness="30" springdamper=".2 .7"'), '<option><flag spring="disable"/></option>'),
    "dampers switched off": model(arm('damping="30" springdamper=".2 .7"'), '<option><flag damper="disable"/></option>'),
    "passive forces switched off": model(
        arm('damping="30" stiffness="2"', bodies=('gravcomp="1"', "", "")),
        '<option><flag damper="disable" spring="disable"/></option>',
    ),
    "constraints switched off": model(arm('range="0 .1" frictionloss="2"'), '<option><flag constraint="disable"/></option>'),
    "friction switched off": model(arm('frictionloss="2"'), '<option><flag frictionloss="disable"/></option>'),
}  # fmt: skip


@pytest.mark.parametrize("name", CARRIED)
def test_motion_is_that_of_mujoco(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Inverse dynamics, forward dynamics, and the accelerations of the assembled tree; round-off apart."""
    monkeypatch.chdir(tmp_path)
    robot, told = read(tmp_path / "robot.xml", CARRIED[name])
    assert told == []
    mujoco, made, data = in_mujoco(tmp_path / "robot.xml")
    for q, v, a in states(made.nv):
        data.qpos[:], data.qvel[:] = q, v
        mujoco.mj_forward(made, data)
        close = {"rtol": 1e-10, "atol": 1e-10 * np.abs(data.qacc).max()}
        np.testing.assert_allclose(robot.PassiveForces(q, v), data.qfrc_passive, **close)
        np.testing.assert_allclose(robot.ForwardDynamics(q, v, 0 * q), data.qacc, **close)
        np.testing.assert_allclose(accelerations(robot, q, v), data.qacc, **close)
        data.qacc[:] = a
        mujoco.mj_inverse(made, data)
        np.testing.assert_allclose(robot.InverseDynamics(q, v, a), data.qfrc_inverse, **close)


def tip_of(robot: Any, redundant: bool, duration: float = 0.3, steps: int = 300) -> Any:
    """Return where the site 'tip' is after a motion of a kinematic tree, or of rigid bodies and joints."""
    mbs = exu.SystemContainer().AddSystem()
    place = robot.frames["tip"][1][:3, 3]
    if redundant:
        base = mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=mbs.AddObject(items.ObjectGround())))
        made = robot.CreateRedundantCoordinateMBS(mbs, base)
        body = made["bodyList"][robot.FrameLink("tip")]
        marker = mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=body, localPosition=place))
    else:
        tree = robot.CreateKinematicTree(mbs)["objectKinematicTree"]
        number = robot.FrameLink("tip")
        link = robot.links[number]
        place = (np.asarray(link.localHT) @ [*place, 1.0])[:3]
        marker = mbs.AddMarker(
            items.MarkerKinematicTreeRigid(objectNumber=tree, linkNumber=number, localPosition=place)
        )
    sensor = mbs.AddSensor(
        items.SensorMarker(
            markerNumber=marker,
            outputVariableType=exu.OutputVariableType.Position,
            storeInternal=True,
            writeToFile=False,
        )
    )
    solve(mbs, duration, steps)
    return mbs.GetSensorStoredData(sensor)[-1, 1:]


@pytest.mark.parametrize("name", ["springs", "supported weight"])
def test_rigid_bodies_move_like_the_tree(name: str, tmp_path: Path) -> None:
    """Both are integrated with errors of second order, about 1e-5 of the motion at these steps."""
    robot, _ = read(tmp_path / "robot.xml", CARRIED[name].replace('armature=".1"', ""))
    tree, bodies = (tip_of(robot, redundant) for redundant in (False, True))
    assert np.linalg.norm(tree - robot.FrameHT("tip", robot.referenceConfiguration)[:3, 3]) > 0.01
    np.testing.assert_allclose(bodies, tree, atol=1e-5)
