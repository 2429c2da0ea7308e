"""Springs, actuators and constraints of MJCF files, against MuJoCo at random states where that is installed."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert import itemInterface as items
from dalembert.rigidBodyUtilities import RotXYZ2RotationMatrix
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


def accelerations(robot: Any, q: Any, v: Any, controls: Any = ()) -> Any:
    """Return the accelerations of the assembled tree at a state, which the solver computes at the start."""
    mbs = exu.SystemContainer().AddSystem()
    made = robot.CreateKinematicTree(mbs)
    node = made["nodeGeneric"]
    mbs.SetNodeParameter(node, "initialCoordinates", q - robot.referenceConfiguration)
    mbs.SetNodeParameter(node, "initialCoordinates_t", v)
    robot.SetControls(mbs, made, controls)
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


def tip_of(robot: Any, redundant: bool, site: str = "tip", duration: float = 0.3, steps: int = 300) -> Any:
    """Return where a site is after a motion of a kinematic tree, or of rigid bodies and joints."""
    mbs = exu.SystemContainer().AddSystem()
    place = robot.frames[site][1][:3, 3]
    if redundant:
        base = mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=mbs.AddObject(items.ObjectGround())))
        made = robot.CreateRedundantCoordinateMBS(mbs, base)
        body = made["bodyList"][robot.FrameLink(site)]
        marker = mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=body, localPosition=place))
    else:
        tree = robot.CreateKinematicTree(mbs)["objectKinematicTree"]
        number = robot.FrameLink(site)
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


FREE = """<body name="hull" pos="0 .2 1" euler="10 20 30"><freejoint name="f"/><geom type="box" size=".1 .2 .3"/>
<site name="tip" pos=".1 .2 .3"/><body pos=".2 0 0" gravcomp=".5"><joint axis="0 1 0" damping="2"/><geom size=".1" pos=".2 0 0"/></body></body>"""


def test_free_bodies_move_like_the_tree(tmp_path: Path) -> None:
    """A floating joint needs no joint among rigid bodies, as long as nothing acts on its coordinates."""
    thruster = '<actuator><motor name="r" site="tip" gear="90 0 20 0 3 0"/></actuator>'
    robot, told = read(tmp_path / "robot.xml", model(FREE, "", thruster))
    assert told == []
    robot.actuators["r"].control = 1.5
    tree, bodies = (tip_of(robot, redundant) for redundant in (False, True))
    assert np.linalg.norm(tree - robot.FrameHT("tip", robot.referenceConfiguration)[:3, 3]) > 0.1
    np.testing.assert_allclose(bodies, tree, atol=1e-5)  # as above
    mbs = exu.SystemContainer().AddSystem()
    base = mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=mbs.AddObject(items.ObjectGround())))
    for name, value in (("damping", 2.0), ("stiffness", 3.0), ("PDcontrol", (1.0, 2.0))):
        other, _ = read(tmp_path / "robot.xml", model(FREE))
        setattr(other.links[4], name, value)
        with pytest.raises(ValueError, match="link 0 '' has no mass, which needs the coordinates of the joints"):
            other.CreateRedundantCoordinateMBS(mbs, base)
    other, _ = read(tmp_path / "robot.xml", model(FREE))
    with pytest.raises(ValueError, match="link 0 '' has no mass"):
        other.CreateRedundantCoordinateMBS(mbs, base, jointLoadUserFunctionList=[lambda mbs, t, load: [0, 0, 0]])


RANGES = 'ctrlrange="-.5 .6" forcerange="-2 1.5"'
DEFAULTS = """<default><default class="x"><position kp="40" kv="3"/><default class="y"><general gear="-2" ctrlrange="-.4 .4"/>
</default></default><default class="z"><general gaintype="affine" gainprm="4 .3 -.2" biastype="affine" biasprm=".3 -5 -1"/>
</default><default class="i"><position kp="3" inheritrange=".5"/></default><default class="w"><general gainprm="7" biastype="affine" biasprm="0 -7 -2"/></default></default>"""
ACTUATED = {
    "motors": f'<motor name="a" joint="s" gear="3"/><motor name="b" joint="j" {RANGES}/><motor joint="k" gear="-.5" {RANGES}/>',
    "position controls": f'<position name="a" joint="s" kp="30" kv="2"/><position name="b" joint="j" kp="20" {RANGES} gear="2"/>'
    '<position joint="k" kp="8" dampratio=".7" gear="3"/><position joint="l" kp="4" inheritrange=".5"/>',
    "velocity controls": f'<velocity name="a" joint="s" kv="30"/><velocity name="b" joint="j" kv="2" gear="3" {RANGES}/>',
    "general": f'<general joint="s" gainprm="30" biastype="affine" biasprm="1 -30 -2"/><general joint="j" class="z" {RANGES}/>'
    '<damper joint="k" kv="3" ctrlrange="0 2"/>',
    "defaults": '<position joint="s" class="x"/><position joint="j" class="y"/><motor joint="k" class="y"/>'
    '<general joint="l" class="x" gainprm="2"/><velocity joint="s" class="x"/><position joint="k" class="z" kp="3"/>'
    '<position joint="l" class="w"/><velocity joint="j" class="w"/><position joint="j" class="w" kv="1"/>',
    "inherited ranges": '<position joint="l" class="i"/><motor joint="l" class="i"/><general joint="l" class="i"/>'
    '<position joint="l" class="i" ctrlrange="-.1 .1"/><velocity joint="l" class="i"/>',
    "limits of joints": '<motor name="a" joint="s" gear="-3" forcerange="-9 .2"/><position joint="l" kp="70"/>',
    "clamping switched off": f'<motor joint="s" {RANGES}/><position joint="j" kp="2" {RANGES}/>',
    "switched off": '<motor joint="s" group="3"/><motor joint="j"/>',
}  # fmt: skip
FLAGS = {
    "clamping switched off": '<option><flag clampctrl="disable"/></option>',
    "switched off": '<option actuatorgroupdisable="3"/>',
}


def actuated(name: str) -> str:
    joints = arm('actuatorfrcrange="-1 2"' if name == "limits of joints" else "", "", "", 'range="-20 40" damping="2"')
    before = FLAGS.get(name, "") + (DEFAULTS if name in ("defaults", "general", "inherited ranges") else "")
    return model(joints, before, f"<actuator>{ACTUATED[name]}</actuator>")


@pytest.mark.parametrize("name", ACTUATED)
def test_actuators_are_those_of_mujoco(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    robot, told = read(tmp_path / "robot.xml", actuated(name))
    assert told == []
    mujoco, made, data = in_mujoco(tmp_path / "robot.xml")
    made.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_LIMIT  # stops are elastic in both, in different ways
    on = [i for i in range(made.nu) if made.actuator_group[i] != 3]
    for q, v, u in states(max(made.nv, made.nu)):
        q, v = q[: made.nv], v[: made.nv]
        data.qpos[:], data.qvel[:], data.ctrl[:] = q, v, u[: made.nu]
        mujoco.mj_forward(made, data)
        close = {"rtol": 1e-10, "atol": 1e-10 * np.abs(data.qacc).max()}
        controls = data.ctrl[on]
        forces = robot.ActuatorForces(controls, q, v)
        np.testing.assert_allclose(forces, data.qfrc_actuator, **close)
        np.testing.assert_allclose(robot.ForwardDynamics(q, v, forces), data.qacc, **close)
        np.testing.assert_allclose(accelerations(robot, q, v, controls), data.qacc, **close)


DYNAMIC = (
    '<position name="a" joint="s" kp="30" timeconst=".3"/><intvelocity name="b" joint="j" kp="20" actrange="-1 .2"/>'
    '<general name="c" joint="k" dyntype="filter" dynprm=".2" gainprm="4" ctrlrange="-.1 .1"/>'
    '<cylinder name="d" joint="l" area="3" timeconst=".4" bias="0 -1 -1"/>'
)


def test_activations_are_those_of_mujoco(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Forces by activations, and after 0.2 s activations of filters and integrators, by formulas."""
    monkeypatch.chdir(tmp_path)
    robot, told = read(tmp_path / "robot.xml", model(arm(), "", f"<actuator>{DYNAMIC}</actuator>"))
    assert told == []
    mujoco, made, data = in_mujoco(tmp_path / "robot.xml")
    for q, v, u in states(made.nv):
        data.qpos[:], data.qvel[:], data.act[:] = q, v, u
        mujoco.mj_forward(made, data)
        np.testing.assert_allclose(robot.ActuatorForces(u, q, v), data.qfrc_actuator, rtol=1e-12)
    mbs = exu.SystemContainer().AddSystem()
    created = robot.CreateKinematicTree(mbs)
    robot.SetControls(mbs, created, {"a": 0.5, "b": 2.0, "c": 3.0})
    robot.SetControls(mbs, created, {"d": -1.0})
    solve(mbs, 0.2, 400)
    wanted = [0.5 * (1 - np.exp(-0.2 / 0.3)), 0.2, 0.1 * (1 - np.exp(-1)), -(1 - np.exp(-0.5))]
    for item, value in zip(created["actuators"].values(), wanted, strict=True):
        node = mbs.GetObject(item)["nodeNumbers"][0]
        state = mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates)
        assert state == pytest.approx(value, abs=1e-6)  # (h / 0.2 s)^2 / 12


def test_controls_are_numbers_or_functions_of_time(tmp_path: Path) -> None:
    """A motor on a single hinge: the velocity is the integral of its torque over the inertia."""
    hinge = '<body><joint name="j" axis="0 0 1"/><geom size=".1" pos="1 0 0" mass="2"/></body>'
    motor = '<actuator><motor name="m" joint="j" gear="3"/></actuator>'
    robot, _ = read(tmp_path / "robot.xml", model(hinge, "", motor).replace("1 -2 -9", "0 0 -9"))
    inertia = 2 * (1 + 0.4 * 0.1**2)

    def rate(redundant: bool) -> float:
        mbs = exu.SystemContainer().AddSystem()
        if redundant:
            base = mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=mbs.AddObject(items.ObjectGround())))
            created = robot.CreateRedundantCoordinateMBS(mbs, base)
            subject = items.SensorBody(
                bodyNumber=created["bodyList"][0], outputVariableType=exu.OutputVariableType.AngularVelocity
            )
        else:
            created = robot.CreateKinematicTree(mbs)
            subject = items.SensorNode(
                nodeNumber=created["nodeGeneric"], outputVariableType=exu.OutputVariableType.Coordinates_t
            )
        subject.storeInternal, subject.writeToFile = True, False
        sensor = mbs.AddSensor(subject)
        if callable(robot.actuators["m"].control):
            with pytest.raises(ValueError, match="the control of actuator 'm' is a function of time"):
                robot.SetControls(mbs, created, {"m": 1.0})
        else:
            robot.SetControls(mbs, created, [0.5])
            assert mbs.GetObjectParameter(created["actuators"]["m"], created["controls"]["m"]) == 0.5
        solve(mbs, 1.0, 400)
        return float(mbs.GetSensorStoredData(sensor)[-1, -1])

    for redundant in (False, True):
        robot.actuators["m"].control = 0.0
        assert rate(redundant) == pytest.approx(3 * 0.5 / inertia, rel=1e-6)  # bodies integrate Euler parameters
        robot.actuators["m"].control = lambda t: 2 * np.sin(3 * t)
        exact = 3 * 2 * (1 - np.cos(3)) / 3 / inertia
        assert rate(redundant) == pytest.approx(exact, rel=1e-5)  # trapezoidal rule: (w h)^2 / 12 = 5e-6
    with pytest.raises(ValueError, match="there is no actuator 'n'; there are: m"):
        robot.ActuatorForces({"n": 1.0}, [0.0], [0.0])
    with pytest.raises(ValueError, match="expected 1 numbers, one per actuator"):
        robot.ActuatorForces([1.0, 2.0], [0.0], [0.0])


def test_actuators_move_rigid_bodies_like_the_tree(tmp_path: Path) -> None:
    drives = '<position joint="s" kp="300" kv="10" forcerange="-40 50"/><position joint="j" kp="40" kv="2" gear="2"/>'
    text = model(arm(), "", f'<actuator>{drives}<motor joint="k"/></actuator>').replace('armature=".1"', "")
    robot, _ = read(tmp_path / "robot.xml", text)
    for actuator, control in zip(robot.actuators.values(), (0.3, -0.5, 0.4), strict=True):
        actuator.control = control
    tree, bodies = (tip_of(robot, redundant) for redundant in (False, True))
    np.testing.assert_allclose(bodies, tree, atol=3e-5)  # as above, of a motion of 0.3 m


def test_wrong_actuators_are_refused(tmp_path: Path) -> None:
    from dalembert.robotics import RobotActuator

    robot, _ = read(tmp_path / "robot.xml", model(arm()))
    with pytest.raises(ValueError, match="Robot: there is no joint 'm'; there are: s, j, k, l"):
        robot.AddActuator(RobotActuator("a", "m"))
    robot.AddActuator(RobotActuator("a", "j", dynamics="integrator"))
    with pytest.raises(ValueError, match="Robot.AddActuator: there is another 'a' already; names must differ"):
        robot.AddActuator(RobotActuator("a", "k"))
    with pytest.raises(ValueError, match="RobotActuator 'a': expected a gear and a gain that are not zero"):
        RobotActuator("a", "j", gear=0)
    with pytest.raises(ValueError, match=r"forceRange: expected \[lower, upper\] with lower <= upper"):
        RobotActuator("a", "j", forceRange=(2, 1))
    with pytest.raises(ValueError, match="RobotActuator 'a': expected a joint, a tendon or a frame, received '', ''"):
        RobotActuator("a")
    with pytest.raises(ValueError, match="dynamics, and forces that depend on lengths, need a joint, not a frame"):
        RobotActuator("a", frame="tip", bias=(0, -1, 0))
    with pytest.raises(ValueError, match="there is no link or joint 'z'"):
        robot.AddActuator(RobotActuator("z", frame="z"))
    with pytest.raises(ValueError, match="dynamics: expected one of none, filter, integrator"):
        RobotActuator("a", "j", dynamics="muscle")
    mbs = exu.SystemContainer().AddSystem()
    base = mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=mbs.AddObject(items.ObjectGround())))
    robot.links[0].rotorInertia = 0
    with pytest.raises(ValueError, match="actuator 'a' has dynamics, which need .* use CreateKinematicTree"):
        robot.CreateRedundantCoordinateMBS(mbs, base)
    with pytest.raises(ValueError, match=r"line 9: <motor>: there is no joint 'm'; there are: s, j, k, l"):
        read(tmp_path / "robot.xml", model(arm(), "", '\n<actuator><motor joint="m"/></actuator>'))


# Equality constraints: a four-bar linkage closed by three equations, of which one is redundant, and more.
BARS = """<body name="a"><joint name="p" axis="0 1 0"/><geom type="capsule" fromto="0 0 0 0 0 .4" size=".03"/>
<body name="b" pos="0 0 .4" euler="0 10 0"><joint name="q" axis="0 1 0"/><geom type="capsule" fromto="0 0 0 .5 0 0" size=".03"/></body></body>
<body name="c" pos=".5 0 0"><joint name="r" axis="0 1 0"/><geom type="capsule" fromto="0 0 0 0 0 .35" size=".03"/><site name="top" pos="0 .02 .35"/></body>
<body name="pin" pos="0 0 .2"/>"""
CUT = BARS.replace(
    '<site name="top" pos="0 .02 .35"/>',
    '<body name="e" pos="0 0 .35" euler="0 10 0"><joint name="h" axis="0 1 0"/><geom size=".04" pos=".1 0 0"/></body>',
)
CLOSED = {
    "four bars": (BARS, '<connect body1="b" body2="c" anchor=".48 0 0"/>'),
    "polynomial of joints": (arm(), '<joint joint1="j" joint2="l" polycoef=".2 -.5 .3 .2 -.1"/>'),
    "gear and lock": (arm(), '<joint joint1="j" joint2="l" polycoef=".2 -.5"/><joint joint1="k" polycoef=".1"/>'),
    "chain of gears": (arm(), '<joint joint1="j" joint2="l" polycoef="0 2"/><joint joint1="l" joint2="k"/>'),
    "connected to the world": (arm(), '<connect body1="c" anchor=".2 0 .1"/>'),
    "connected sites, one with the name of a body": (
        BARS.replace('"top"', '"a"'),
        '<connect site1="a" site2="end"/>',
    ),
    "connected sites": (BARS, '<connect site1="top" site2="end"/>'),
    "welded": (CUT, '<weld body1="b" body2="e"/>'),
    "welded with a pose": (CUT, '<weld body1="b" body2="e" relpose=".48 0 -.01 1 0 .1 0" anchor=".1 0 .02"/>'),
    "welded with an anchor": (CUT, '<weld body1="e" body2="b" anchor=".1 .1 .2"/>'),
    "switched off": (arm(), '<connect body1="c" anchor=".2 0 .1" active="false"/>'),
}  # fmt: skip


def closed(name: str) -> str:
    bodies, constraints = CLOSED[name]
    bodies = bodies.replace(
        'size=".03"/></body></body>', 'size=".03"/><site name="end" pos=".49 .02 0"/></body></body>'
    )
    return model(bodies, "", f"<equality>{constraints}</equality>")


def equations(mujoco: Any, made: Any, data: Any, q: Any) -> tuple[Any, Any]:
    """Return residuals and Jacobian of the equality constraints."""
    data.qpos[:] = q
    mujoco.mj_forward(made, data)
    return data.efc_pos[: data.ne].copy(), np.reshape(data.efc_J, (-1, made.nv))[: data.ne].copy()


@pytest.mark.parametrize("name", CLOSED)
def test_closed_loops_are_those_of_mujoco(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Residuals of translations at random states; accelerations at states that fit, against the equations of motion.

    MuJoCo's own constraints are soft. Its mass matrix, forces and Jacobians give those of rigid ones; the derivative of
    the Jacobian is a central difference, which has an error of about 1e-9.
    """
    monkeypatch.chdir(tmp_path)
    robot, told = read(tmp_path / "robot.xml", closed(name))
    assert told == [] or "name of a body" in name
    mujoco, made, data = in_mujoco(tmp_path / "robot.xml")
    made.opt.jacobian = mujoco.mjtJacobian.mjJAC_DENSE
    n = made.nv
    for q, _, _ in states(n):
        residual, _ = equations(mujoco, made, data, q)
        mine = gaps(robot, q)
        if len(residual) == 6:  # of a weld, MuJoCo has the vector part of a quaternion
            residual, mine = (np.linalg.norm(each.reshape(2, 3), axis=1) for each in (residual, mine))
        np.testing.assert_allclose(np.abs(mine), np.abs(residual), atol=1e-12)
    for q, v, _ in states(n):
        q = robot.referenceConfiguration + 0.4 * q
        for _ in range(60):
            residual, J = equations(mujoco, made, data, q)
            q = q - np.linalg.pinv(J, rcond=1e-8) @ residual if len(residual) else q
        assert np.abs(residual).max(initial=0.0) < 1e-12
        v = v - np.linalg.pinv(J, rcond=1e-8) @ (J @ v)
        h = 1e-5
        J_t = (equations(mujoco, made, data, q + h * v)[1] - equations(mujoco, made, data, q - h * v)[1]) / (2 * h)
        data.qvel[:] = v
        equations(mujoco, made, data, q)
        mass = np.zeros((n, n))
        for row, unit in zip(mass, np.eye(n), strict=True):
            mujoco.mj_mulM(made, data, row, unit)
        inverse = np.linalg.inv(mass)
        free = inverse @ data.qfrc_smooth
        push = np.linalg.pinv(J @ inverse @ J.T, rcond=1e-9) @ (-J_t @ v - J @ free)
        wanted = free + inverse @ J.T @ push
        np.testing.assert_allclose(accelerations(robot, q, v), wanted, atol=1e-7 * np.abs(wanted).max())


def gaps(robot: Any, q: Any) -> Any:
    """Return the residuals of all constraints that are switched on."""
    mbs = exu.SystemContainer().AddSystem()
    created = robot.CreateKinematicTree(mbs)
    mbs.SetNodeParameter(created["nodeGeneric"], "initialCoordinates", q - robot.referenceConfiguration)
    mbs.Assemble()
    found = []
    for item in created["constraints"].values():
        parameters = mbs.GetObject(item)
        if not parameters["activeConnector"]:
            continue
        kind = parameters["objectType"]
        names = {"Generic": ["DisplacementLocal", "Rotation"], "Spherical": ["Displacement"]}
        for variable in names.get(kind.removeprefix("Joint"), ["ConstraintEquation"]):
            value = np.atleast_1d(mbs.GetObjectOutput(item, getattr(exu.OutputVariableType, variable)))
            if variable == "Rotation":  # the vector part of the quaternion is as long as the sine of half of the angle
                A = RotXYZ2RotationMatrix(value)
                value = np.array([np.sqrt(np.maximum(3 - np.trace(A), 0)) / 2, 0, 0])
            found.append(value)
    return np.concatenate([*found, []])


@pytest.mark.parametrize("name", ["four bars", "welded", "connected to the world"])
def test_closed_loops_of_rigid_bodies_move_like_the_tree(name: str, tmp_path: Path) -> None:
    robot, _ = read(tmp_path / "robot.xml", closed(name).replace('armature=".1"', ""))
    site = "side" if "world" in name else "end"
    tree, bodies = (tip_of(robot, redundant, site) for redundant in (False, True))
    assert np.linalg.norm(tree - robot.FrameHT(site, robot.referenceConfiguration)[:3, 3]) > 0.01
    np.testing.assert_allclose(bodies, tree, atol=3e-5)  # as above


def test_couplings_determine_coordinates(tmp_path: Path) -> None:
    """The reference configuration fits, and joints that are coupled in a chain follow the first one."""
    robot, _ = read(tmp_path / "robot.xml", closed("chain of gears"))
    q = robot.FollowedCoordinates([0.1, 0, 0.3, 0])
    assert q == pytest.approx([0.1, np.deg2rad(20) + 0.6, 0.3, 0.3])
    robot, _ = read(tmp_path / "robot.xml", closed("gear and lock"))
    assert robot.referenceConfiguration == pytest.approx([0, np.deg2rad(20) + 0.2, 0.1, 0])


def test_constraints_of_own_robots(tmp_path: Path) -> None:
    from dalembert.robotics import RobotCoupling, RobotLoop

    robot, _ = read(tmp_path / "robot.xml", model(arm().replace('armature=".1"', "")))
    robot.AddConstraint(RobotLoop("hook", "tip", HT1=robot.FrameHT("tip", robot.referenceConfiguration)))
    robot.AddConstraint(RobotLoop("weld", "fixed", "c", HT1=robot.frames["fixed"][1], rotation=True))
    assert gaps(robot, robot.referenceConfiguration) == pytest.approx(np.zeros(9), abs=1e-15)
    with pytest.raises(ValueError, match="there is another 'hook' already"):
        robot.AddConstraint(RobotLoop("hook", "tip"))
    with pytest.raises(ValueError, match="there is no link or joint 'nose'"):
        robot.AddConstraint(RobotLoop("other", "nose"))
    with pytest.raises(ValueError, match="there is no joint 'tip'"):
        robot.AddConstraint(RobotCoupling("other", "j", "tip"))
    with pytest.raises(ValueError, match="coefficients: expected one number without a leader"):
        RobotCoupling("other", "j")
    mbs = exu.SystemContainer().AddSystem()
    point = mbs.AddMarker(items.MarkerBodyPosition(bodyNumber=mbs.AddObject(items.ObjectGround())))
    robot.base.HT = np.eye(4)
    with pytest.raises(ValueError, match="a loop or cable that ends at the base needs a MarkerBodyRigid"):
        robot.CreateRedundantCoordinateMBS(mbs, point, rotationMarkerBase=np.eye(3))
    robot.AddConstraint(RobotCoupling("gear", "j", "k"))
    with pytest.raises(
        ValueError, match="constraint 'gear' needs the coordinates of the joints; use CreateKinematicTree"
    ):
        robot.CreateRedundantCoordinateMBS(mbs, point)


def test_wrong_constraints_are_refused(tmp_path: Path) -> None:
    for constraint, problem in {
        '<connect body1="z" anchor="0 0 0"/>': "<connect>: there is no body 'z'; there are: world, a, b, c, fixed, d",
        '<weld site1="z" site2="tip"/>': "<weld>: there is no site 'z'; there are: tip, side",
        '<joint joint1="j" joint2="z"/>': "<joint>: there is no joint 'z'; there are: s, j, k, l",
        '<connect body1="a"/>': "<connect>: expected the attribute 'anchor'",
        '<joint polycoef="1"/>': "<joint>: expected the attribute 'joint1'",
    }.items():
        with pytest.raises(ValueError, match=problem):
            read(tmp_path / "robot.xml", model(arm(), "", f"<equality>{constraint}</equality>"))


FLYING = """<body name="f" pos=".1 .2 .3" euler="10 20 30"><freejoint/><geom type="box" size=".1 .2 .3"/>
<body name="g" pos=".3 0 0"><joint type="ball" pos=".1 0 0"/><geom size=".1" pos=".2 0 0"/>
<body name="h"><joint name="h" axis="0 1 0" ref="30"/><geom size=".1" pos=".2 0 0"/><site name="tip" pos=".3 0 0"/></body></body></body>"""
KEYS = (
    '<key name="flight" time="2" qpos="1 2 3 .6 .2 -.3 .4 .9 .1 .3 -.2 .7" qvel="1 -2 3 .5 -.7 .3 .2 .4 -.6 .8" ctrl="5 .2 7" '
    'act=".4"/><key qvel="0 0 0 0 0 0 0 0 0 2"/>'
)
FLYERS = '<motor name="m" joint="h"/><position name="p" joint="h" timeconst=".1" kp="3"/><motor joint="h" group="3"/>'


def flying() -> str:
    text = model(
        FLYING, '<option actuatorgroupdisable="3"/>', f"<actuator>{FLYERS}</actuator><keyframe>{KEYS}</keyframe>"
    )
    return text


def test_keyframes_are_states_of_mujoco(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Poses and velocities of free, ball and hinge joints, and what the actuators do there."""
    monkeypatch.chdir(tmp_path)
    robot, told = read(tmp_path / "robot.xml", flying())
    assert told == []
    key = robot.keyframes["flight"]
    assert key.controls == {"m": 5, "p": 0.2} and key.activations == {"p": 0.4} and key.time == 2
    rest = robot.keyframes["key 1"]
    assert rest.q == pytest.approx(robot.referenceConfiguration) and rest.q_t == pytest.approx([0] * 9 + [2])
    mujoco, made, data = in_mujoco(tmp_path / "robot.xml")
    mujoco.mj_resetDataKeyframe(made, data, 0)
    mujoco.mj_forward(made, data)
    velocity = np.zeros(6)
    for name in ("f", "g", "h"):
        T = robot.FrameHT(name, key.q)
        np.testing.assert_allclose(T[:3, 3], data.body(name).xpos, atol=1e-12)
        np.testing.assert_allclose(T[:3, :3].ravel(), data.body(name).xmat, atol=1e-12)
        body = mujoco.mj_name2id(made, mujoco.mjtObj.mjOBJ_BODY, name)
        mujoco.mj_objectVelocity(made, data, mujoco.mjtObj.mjOBJ_XBODY, body, velocity, 0)
        J = robot.Jacobian(robot.JointHT(key.q), T[:3, 3], "all", name)
        np.testing.assert_allclose(J @ key.q_t, [*velocity[3:], *velocity[:3]], atol=1e-12)
    mbs = exu.SystemContainer().AddSystem()
    created = mbs.CreateRobot(tmp_path / "robot.xml", graphics=False, keyframe="flight")
    mbs.Assemble()
    coordinates = mbs.GetNodeOutput(created["nodeGeneric"], exu.OutputVariableType.CoordinatesTotal)
    np.testing.assert_allclose(coordinates, key.q, atol=1e-15)
    rates = mbs.GetNodeOutput(created["nodeGeneric"], exu.OutputVariableType.Coordinates_t)
    np.testing.assert_allclose(rates, key.q_t, atol=1e-15)
    forces = [mbs.GetObjectOutput(item, exu.OutputVariableType.Force) for item in created["actuators"].values()]
    np.testing.assert_allclose(np.ravel(forces), data.actuator_force[:2], rtol=1e-12)


def test_keyframes_of_rigid_bodies(tmp_path: Path) -> None:
    key = '<keyframe><key name="home" qpos=".1 .2 .3 .4" ctrl="3"/><key name="run" qvel="1 0 0 0"/></keyframe>'
    text = model(arm(), "", f'<actuator><motor name="m" joint="j"/></actuator>{key}').replace('armature=".1"', "")
    (tmp_path / "robot.xml").write_text(text)
    mbs = exu.SystemContainer().AddSystem()
    base = mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=mbs.AddObject(items.ObjectGround())))
    created = mbs.CreateRobot(tmp_path / "robot.xml", baseMarker=base, keyframe="home", graphics=False)
    mbs.Assemble()
    robot = created["robot"]
    for body, T in zip(created["bodyList"], robot.LinkHT([0.1, 0.2, 0.3, 0.4]), strict=True):
        place = mbs.GetObjectOutputBody(body, exu.OutputVariableType.Position, [0, 0, 0])
        np.testing.assert_allclose(place, T[:3, 3], atol=1e-14)
    assert mbs.GetObjectParameter(created["actuators"]["m"], created["controls"]["m"]) == 3
    with pytest.raises(ValueError, match="keyframe: there is no 'away'; there are: home, run"):
        robot.CreateKinematicTree(mbs, keyframe="away")
    with pytest.raises(ValueError, match="keyframe 'run' has rates, which need the coordinates of the joints"):
        robot.CreateRedundantCoordinateMBS(mbs, base, keyframe="run")
    (tmp_path / "robot.xml").write_text(text.replace("qpos=", 'qpos="1 2" mpos='))
    with pytest.raises(ValueError, match="<key>: qpos: expected 4 finite numbers, received '1 2'"):
        ReadRobot(tmp_path / "robot.xml")


# The joints of the first one are in one chain: MuJoCo's mass matrix has no entries for inertia between branches.
FIXED = '<fixed name="t" {}><joint joint="j" coef="2"/><joint joint="k" coef="-1.5"/></fixed><fixed name="u"><joint joint="l" coef="3"/></fixed>'
TENDONS = {
    "spring and damper": 'stiffness="30" damping="2"',
    "spring of a given length": 'stiffness="30" springlength=".3"',
    "spring with slack": 'stiffness="30" springlength=".1 .4" armature=".3"',
    "inertia": 'armature="2" damping="1"',
}


def with_tendon(attributes: str, after: str = "", before: str = "") -> str:
    joints = arm("", 'springref="15" stiffness="2"', 'springref="-8"')
    return model(joints, before, f"<tendon>{FIXED.format(attributes)}</tendon>{after}")


@pytest.mark.parametrize("name", TENDONS)
def test_fixed_tendons_are_those_of_mujoco(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    drives = (
        '<motor tendon="t" gear="2" ctrlrange="-1 2"/><position tendon="u" kp="4" dampratio="1" forcerange="-2 3"/>'
        '<velocity joint="l" kv="3"/>'
    )
    attributes = TENDONS[name] + (' actuatorfrcrange="-.3 .2"' if name == "inertia" else "")
    robot, told = read(tmp_path / "robot.xml", with_tendon(attributes, f"<actuator>{drives}</actuator>"))
    assert told == []
    mujoco, made, data = in_mujoco(tmp_path / "robot.xml")
    for q, v, u in states(made.nv):
        data.qpos[:], data.qvel[:], data.ctrl[:] = q, v, u[:3]
        mujoco.mj_forward(made, data)
        close = {"rtol": 1e-10, "atol": 1e-10 * np.abs(data.qacc).max()}
        forces = robot.ActuatorForces(u[:3], q, v)
        np.testing.assert_allclose(robot.PassiveForces(q, v), data.qfrc_passive, **close)
        np.testing.assert_allclose(forces, data.qfrc_actuator, **close)
        np.testing.assert_allclose(robot.ForwardDynamics(q, v, forces), data.qacc, **close)
        np.testing.assert_allclose(accelerations(robot, q, v, u[:3]), data.qacc, **close)
        np.testing.assert_allclose(robot.InverseDynamics(q, v, data.qacc), forces, **close)
        mujoco.mj_energyVel(made, data)
        assert robot.KineticEnergy(q, v) == pytest.approx(data.energy[1], rel=1e-10)


def test_couplings_of_tendons(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    equality = '<tendon tendon1="t" tendon2="u" polycoef=".1 .5 .2"/><tendon tendon1="u" polycoef=".3"/>'
    robot, told = read(tmp_path / "robot.xml", with_tendon("", f"<equality>{equality}</equality>"))
    assert told == []
    mujoco, made, data = in_mujoco(tmp_path / "robot.xml")
    for q, _, _ in states(made.nv):
        np.testing.assert_allclose(gaps(robot, q), equations(mujoco, made, data, q)[0], atol=1e-12)


def test_stops_and_friction_of_tendons(tmp_path: Path) -> None:
    """A tendon out of its limits is pushed back; friction acts against the rate."""
    from dalembert.robotics import RobotTendon

    text = with_tendon('range="-.2 .3" frictionloss="2"').replace('stiffness="2"', "")
    robot, told = read(tmp_path / "robot.xml", text)
    assert told == []
    tendon = robot.tendons["t"]
    assert tendon.limits == (-0.2, 0.3)
    assert tendon.Tension(0.5, 1.0, (100, 3)) == pytest.approx(2 + 20 + 3)
    assert tendon.Tension(-0.5, 1.0, (100, 3)) == pytest.approx(2 - 30 + 3)
    assert tendon.Tension(0.301, -1.0, (100, 3)) == pytest.approx(-2)  # a stop does not pull
    mbs = exu.SystemContainer().AddSystem()
    created = robot.CreateKinematicTree(mbs, limitStiffness=100, limitDamping=3)
    assert list(created["tendons"]) == ["t"]
    base = mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=mbs.AddObject(items.ObjectGround())))
    robot.links[0].rotorInertia = 0
    with pytest.raises(ValueError, match="tendon 't' needs the coordinates of the joints; use CreateKinematicTree"):
        robot.CreateRedundantCoordinateMBS(mbs, base)
    with pytest.raises(ValueError, match="there is another 't' already"):
        robot.AddTendon(RobotTendon("t", {"j": 1}))
    with pytest.raises(ValueError, match="there is no joint 'z'"):
        robot.AddTendon(RobotTendon("v", {"z": 1}))
    with pytest.raises(ValueError, match="restLength: expected"):
        RobotTendon("v", {"j": 1}, restLength=(2, 1))
    with pytest.raises(ValueError, match="<joint>: there is no joint 'z'; there are: j, k, l, s"):
        read(tmp_path / "robot.xml", model(arm(), "", '<tendon><fixed><joint joint="z" coef="1"/></fixed></tendon>'))


CABLES = {
    "spring and damper": 'stiffness="300" damping="20"',
    "spring of a given length": 'stiffness="300" springlength=".5"',
    "spring with slack": 'stiffness="300" springlength=".6 .8"',
}


@pytest.mark.parametrize("name", CABLES)
def test_cables_are_those_of_mujoco(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Springs between two sites on branches, and between a site and the world."""
    monkeypatch.chdir(tmp_path)
    spatial = '<spatial name="{}" {}><site site="tip"/><site site="{}"/></spatial>'
    tendons = spatial.format("x", CABLES[name], "side") + spatial.format("y", 'stiffness="50"', "far")
    bodies = arm("", 'springref="15"', "", 'springref="-8"').replace('armature=".1"', "")
    text = model(bodies + '<site name="far" pos="1 1 1"/>', "", f"<tendon>{tendons}</tendon>")
    robot, told = read(tmp_path / "robot.xml", text)
    assert told == []
    mujoco, made, data = in_mujoco(tmp_path / "robot.xml")
    for q, v, _ in states(made.nv):
        data.qpos[:], data.qvel[:] = q, v
        mujoco.mj_forward(made, data)
        close = {"rtol": 1e-10, "atol": 1e-10 * np.abs(data.qacc).max()}
        np.testing.assert_allclose(robot.PassiveForces(q, v), data.qfrc_passive, **close)
        np.testing.assert_allclose(accelerations(robot, q, v), data.qacc, **close)
    tree, rigid = (tip_of(robot, redundant) for redundant in (False, True))
    np.testing.assert_allclose(rigid, tree, atol=1e-4)  # as above; the springs oscillate


THRUSTERS = (
    '<motor name="a" site="tip" gear="1 2 -3 .5 -.2 .7"/><motor name="b" site="side" gear="0 0 1" ctrlrange="-.4 .3"/>'
    '<general name="c" site="turned" gear="0 0 0 0 2 1" gainprm="3" forcerange="-2 1"/>'
)


def test_thrusters_are_those_of_mujoco(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Forces and torques on sites, in their axes; also of rigid bodies, after a motion."""
    monkeypatch.chdir(tmp_path)
    bodies = arm().replace(
        '<body name="fixed"', '<site name="turned" pos=".1 0 .2" euler="40 50 60"/><body name="fixed"'
    )
    text = model(bodies.replace('armature=".1"', ""), "", f"<actuator>{THRUSTERS}</actuator>")
    robot, told = read(tmp_path / "robot.xml", text)
    assert told == []
    mujoco, made, data = in_mujoco(tmp_path / "robot.xml")
    for q, v, u in states(made.nv):
        data.qpos[:], data.qvel[:], data.ctrl[:] = q, v, u[:3]
        mujoco.mj_forward(made, data)
        close = {"rtol": 1e-10, "atol": 1e-10 * np.abs(data.qacc).max()}
        np.testing.assert_allclose(robot.ActuatorForces(u[:3], q, v), data.qfrc_actuator, **close)
        np.testing.assert_allclose(accelerations(robot, q, v, u[:3]), data.qacc, **close)
    robot.actuators["a"].control, robot.actuators["b"].control = 1.0, lambda t: 0.2 * np.cos(t)
    tree, rigid = (tip_of(robot, redundant) for redundant in (False, True))
    np.testing.assert_allclose(rigid, tree, atol=1e-4)  # as above


def test_forces_of_many_states(tmp_path: Path) -> None:
    """Arrays of states give the forces of each state: springs, weight, tendons, cables and actuators."""
    drives = '<motor joint="s"/><position tendon="t" kp="3"/><motor site="tip" gear="1 2 3 4 5 6"/>'
    joints = arm('stiffness="3"', "", "", "", bodies=('gravcomp="1"', 'gravcomp=".5"', ""))
    spatial = '<spatial name="c" stiffness="30" damping="2"><site site="tip"/><site site="side"/></spatial>'
    fixed = FIXED.format('stiffness="3"')
    tendons = f"<tendon>{fixed}{spatial}</tendon><actuator>{drives}</actuator>"
    robot, told = read(tmp_path / "robot.xml", model(joints, "", tendons))
    assert told == []
    q, v, u = np.random.default_rng(2).uniform(-1, 1, (3, 5, 2, 4))
    passive, driven = robot.PassiveForces(q, v), robot.ActuatorForces(u[..., :3], q, v)
    assert passive.shape == driven.shape == q.shape
    for i in np.ndindex(5, 2):
        np.testing.assert_allclose(passive[i], robot.PassiveForces(q[i], v[i]), atol=1e-12)
        np.testing.assert_allclose(driven[i], robot.ActuatorForces(u[i][:3], q[i], v[i]), atol=1e-12)
