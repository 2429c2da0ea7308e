"""Attached models of MJCF files, against MuJoCo at random states where that is installed."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from test_mjcf_dynamics import accelerations, equations, gaps, in_mujoco, read, states

# A hand with settings of its own: units, classes, a folder of meshes, ranges without autolimits. Bodies 'palm' and
# 'thumb' belong together; 'other' is on its own.
HAND = """<mujoco model="hand"><compiler angle="radian" eulerseq="zyx" autolimits="false" boundmass=".5" meshdir="shapes"
inertiagrouprange="0 2"/>
<default><joint damping=".3"/><geom contype="0" conaffinity="0" density="300"/><motor gear="7"/><tendon damping=".4"/>
<default class="stiff"><joint stiffness="4" armature=".2"/><geom density="700"/></default></default>
<asset><mesh file="tet.obj" scale=".3 .3 .3"/></asset>
<worldbody><geom name="plate" type="box" size=".2 .1 .05" pos="0 .1 0"/><site name="fixed" pos="0 0 .3"/>
<frame childclass="stiff" pos="0 0 .1">
<body name="palm" pos=".2 0 0" euler=".2 .5 -.3"><joint name="wrist" axis="0 1 .2" ref=".1" range="-1 1" limited="true"/>
<geom name="g" type="box" size=".1 .2 .05"/><geom size=".3" group="3"/><site name="s" pos="0 .1 .1"/>
<replicate count="2" euler="0 0 1" offset=".1 0 0"><body name="finger"><joint name="bend" axis="1 0 0" springref=".4"/>
<geom type="mesh" mesh="tet"/></body></replicate>
<body name="thumb" pos="0 .2 0"><joint name="slide" type="slide" axis="1 1 0" class="main"/><geom size=".07" pos=".1 0 0"/><site name="t"/></body></body>
</frame><body name="other" pos="0 -1 0"><joint name="free hinge" axis="0 1 0"/><geom size=".2" pos=".3 0 0"/></body></worldbody>
<tendon><fixed name="flexor"><joint joint="wrist" coef=".7"/><joint joint="slide" coef="-2"/></fixed>
<fixed name="across"><joint joint="wrist" coef="1"/><joint joint="free hinge" coef="1"/></fixed>
<spatial name="cord" stiffness="3" springlength=".1"><site site="s"/><site site="t"/></spatial></tendon>
<equality><joint name="gear" joint1="bend0" joint2="bend1" polycoef="0 .5"/><joint joint1="slide" joint2="free hinge"/>
<connect name="pin" body1="thumb" body2="other" anchor="0 0 0" active="false"/>
<connect name="ground" body1="world" body2="thumb" anchor="0 0 0" active="false"/></equality>
<actuator><motor name="m" joint="wrist"/><position name="o" joint="free hinge" kp="30"/><motor name="pull" tendon="flexor"/>
<motor name="both" tendon="across" gear="2"/></actuator>
<keyframe><key name="home" time="2" qpos=".1 .2 .3 .4 .5" qvel="1 2 3 4 5" ctrl=".6 .7 .8 .9"/><key ctrl="1 2 3 4"/></keyframe></mujoco>"""
EQUALITY = HAND[HAND.index("<equality>") : HAND.index("</equality>") + len("</equality>")]
ARM = """<mujoco><compiler angle="degree"/>{0}<default><joint damping="9"/><default class="q"><joint armature="5"/></default></default>
<asset><model name="tool" file="hands/hand.xml"/><model file="hands/hand.xml"/></asset>
<worldbody><body name="arm" pos="0 0 1" childclass="q"><joint name="shoulder" axis="0 1 0" range="-90 90"/>
<geom size=".2" pos=".2 0 0" contype="0" conaffinity="0"/>{1}<body name="tail"><joint name="last" axis="1 0 0"/><geom contype="0" conaffinity="0" size=".1" pos="0 0 .2"/></body>
</body></worldbody>{2}</mujoco>"""
DRIVE = '<actuator><motor name="own" joint="shoulder"/></actuator>'
TET = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
ATTACHED = {
    "body": ARM.format("", '<attach model="tool" body="palm" prefix="left/"/>', DRIVE),
    "named by the model": ARM.format("", '<attach model="hand" body="palm" prefix="left/"/>', ""),
    "in a frame": ARM.format("", '<frame pos="1 0 0" euler="90 0 30" childclass="q"><attach model="tool" body="palm" prefix="l"/></frame>', ""),
    "inner body": ARM.format("", '<attach model="tool" body="thumb" prefix="l"/>', DRIVE),
    "world": ARM.format("", '<attach model="tool" prefix="l"/>', DRIVE),
    "world as a body": ARM.format("", '<attach model="tool" body="world" prefix="l"/>', ""),
    "empty prefix": ARM.format("", '<attach model="tool" body="palm" prefix=""/>', ""),
    "twice": ARM.format("", '<attach model="tool" body="palm" prefix="l"/><attach model="tool" body="thumb" prefix="r"/>', DRIVE),
    "total mass": ARM.format('<compiler settotalmass="7"/>', '<attach model="tool" body="palm" prefix="l"/>', ""),
    "copies": ARM.format("", '<replicate count="2" offset="0 .1 0"><attach model="tool" body="other" prefix="l"/></replicate>', "").replace("hand.xml", "bare.xml"),
    "of a model with an attached one": ARM.format("", '<attach model="tool" body="mount" prefix="l"/>', DRIVE).replace("hand.xml", "mount.xml"),
}  # fmt: skip
# A model between the arm and the hand: its file is in the same folder as that of the hand.
MOUNT = """<mujoco><asset><model name="inner" file="hand.xml"/></asset><worldbody><body name="mount"><joint name="turn" axis="0 0 1" ref="20"/>
<geom size=".1" pos="0 .1 0" contype="0" conaffinity="0"/><attach model="inner" body="palm" prefix="in/"/></body>
<body name="left out"><joint name="no"/><geom size=".1"/></body></worldbody>
<actuator><motor name="first" joint="turn"/><motor joint="in/wrist" name="second"/><motor name="third" joint="no"/></actuator>
<keyframe><key name="all" qpos="1 2 3 4 5 6" ctrl="7 8 9 10 11"/></keyframe></mujoco>"""


def write(file: Path, text: str) -> None:
    """Write a file and the mesh of the hand, in a folder beside it."""
    (file.parent / "shapes").mkdir(parents=True, exist_ok=True)
    (file.parent / "shapes" / "tet.obj").write_text(TET)
    file.write_text(text)


def attached(folder: Path, name: str, constrained: bool = True) -> tuple[Any, list[str]]:
    """Return the robot of a file and its warnings."""
    hand = HAND if constrained else HAND.replace(EQUALITY, "")
    write(folder / "hands" / "hand.xml", hand)
    write(folder / "hands" / "mount.xml", MOUNT)
    bare = HAND[: HAND.index("<tendon><fixed name")] + "</mujoco>"
    write(folder / "hands" / "bare.xml", bare)
    return read(folder / "robot.xml", ATTACHED[name])


@pytest.mark.parametrize("name", ATTACHED)
def test_motion_is_that_of_mujoco(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Mass matrix, forces of springs and actuators, accelerations of the assembled tree; round-off apart.

    MuJoCo stores corners of meshes as single-precision numbers, which gives relative errors of 2e-7.
    """
    monkeypatch.chdir(tmp_path)
    robot, told = attached(tmp_path, name, constrained=False)
    assert told == []
    mujoco, made, data = in_mujoco(tmp_path / "robot.xml")
    made.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_LIMIT  # stops are elastic in both, in different ways
    kinds = [mujoco.mjtObj.mjOBJ_JOINT, mujoco.mjtObj.mjOBJ_ACTUATOR]
    joints, actuators = (
        [mujoco.mj_id2name(made, kind, i) for i in range(n)]
        for kind, n in zip(kinds, (made.njnt, made.nu), strict=True)
    )
    assert [link.jointName for link in robot.links] == joints
    assert list(robot.actuators) == actuators
    for q, v, u in states(max(made.nv, made.nu)):
        q, v, u = q[: made.nv], v[: made.nv], u[: made.nu]
        data.qpos[:], data.qvel[:], data.ctrl[:] = q, v, u
        mujoco.mj_forward(made, data)
        mass = np.zeros((made.nv, made.nv))
        for row, unit in zip(mass, np.eye(made.nv), strict=True):
            mujoco.mj_mulM(made, data, row, unit)
        close = {"rtol": 2e-7, "atol": 2e-7 * np.abs(data.qacc).max()}
        np.testing.assert_allclose(robot.MassMatrix(q), mass, rtol=2e-7, atol=2e-7 * np.abs(mass).max())
        forces = robot.ActuatorForces(u, q, v)
        np.testing.assert_allclose(forces, data.qfrc_actuator, rtol=1e-12, atol=1e-12)
        np.testing.assert_allclose(robot.PassiveForces(q, v), data.qfrc_passive, rtol=1e-10, atol=1e-10)
        np.testing.assert_allclose(robot.ForwardDynamics(q, v, forces), data.qacc, **close)
        np.testing.assert_allclose(accelerations(robot, q, v, u), data.qacc, **close)
        for i in range(made.nsite):
            frame = mujoco.mj_id2name(made, mujoco.mjtObj.mjOBJ_SITE, i)
            np.testing.assert_allclose(robot.FrameHT(frame, q)[:3, 3], data.site_xpos[i], atol=1e-12)


@pytest.mark.parametrize("name", ["body", "twice", "world", "inner body", "of a model with an attached one"])
def test_constraints_are_those_of_mujoco(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Constraints between attached bodies come along, and those with other bodies of the model do not."""
    monkeypatch.chdir(tmp_path)
    robot, _ = attached(tmp_path, name)
    mujoco, made, data = in_mujoco(tmp_path / "robot.xml")
    names = [mujoco.mj_id2name(made, mujoco.mjtObj.mjOBJ_EQUALITY, i) for i in range(made.neq)]
    assert [key for key in robot.constraints if "joint-" not in key] == [key for key in names if key]
    assert len(robot.constraints) == made.neq
    assert [each.active for each in robot.constraints.values()] == made.eq_active0.astype(bool).tolist()
    for q, _, _ in states(made.nv):
        residual, _ = equations(mujoco, made, data, q)
        np.testing.assert_allclose(np.abs(gaps(robot, q)), np.abs(residual), atol=1e-12)


@pytest.mark.parametrize("name", ["body", "twice", "world", "inner body", "of a model with an attached one"])
def test_keyframes_are_those_of_mujoco(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Joints and actuators that are not attached leave the keyframes of a model; those of the arm are at rest.

    MuJoCo lacks the prefix of a model around another one in the names of its keyframes, and calls those without a name
    like the prefix.
    """
    monkeypatch.chdir(tmp_path)
    robot, _ = attached(tmp_path, name, constrained=False)
    mujoco, made, _ = in_mujoco(tmp_path / "robot.xml")
    assert len(robot.keyframes) == made.nkey > 0
    for i, key in enumerate(robot.keyframes.values()):
        given = mujoco.mj_id2name(made, mujoco.mjtObj.mjOBJ_KEY, i)
        assert key.name == f"key {i}" or (key.name.endswith(given) and key.name[0] in "lr")
        assert key.time == made.key_time[i]
        np.testing.assert_allclose(key.q, made.key_qpos[i], atol=1e-15)
        np.testing.assert_allclose(key.q_t, made.key_qvel[i], atol=1e-15)
        assert [key.controls.get(each, 0.0) for each in robot.actuators] == made.key_ctrl[i].tolist()


def test_keyframes_of_the_file_have_all_joints(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Attached joints and actuators are after those that the file has before them."""
    monkeypatch.chdir(tmp_path)
    keyframe = '<keyframe><key name="k" qpos=".1 .2 .3 .4 .5 .6" ctrl=".7 .8 .9"/></keyframe>'
    monkeypatch.setitem(ATTACHED, "keyed", ATTACHED["body"].replace("</mujoco>", f"{keyframe}</mujoco>"))
    robot, _ = attached(tmp_path, "keyed", constrained=False)
    _, made, _ = in_mujoco(tmp_path / "robot.xml")
    np.testing.assert_allclose(robot.keyframes["k"].q, made.key_qpos[0], atol=1e-15)
    assert list(robot.keyframes["k"].controls.values()) == made.key_ctrl[0].tolist()
    text = (tmp_path / "robot.xml").read_text().replace(".1 .2 .3 .4 .5 .6", ".1 .2")
    with pytest.raises(ValueError, match="<key>: qpos: expected 6 finite numbers, received '.1 .2'"):
        read(tmp_path / "robot.xml", text)


def test_settings_that_the_file_replaces_are_named(tmp_path: Path) -> None:
    """Like MuJoCo, the reader takes gravity and flags from the file that attaches."""
    write(tmp_path / "a.xml", HAND.replace("<asset>", '<option gravity="0 0 -1" wind="1 0 0"/><asset>'))
    write(tmp_path / "plain.xml", HAND)
    text = ARM.format("", '<attach model="tool" body="palm" prefix="p"/>', "").replace("hands/hand.xml", "a.xml")
    own = text.replace("<asset>", '<option gravity="0 0 -2"/><asset>')
    robot, told = read(tmp_path / "robot.xml", own.replace("a.xml", "plain.xml"))
    assert told == []
    assert robot.gravity.tolist() == [0, 0, -2]
    robot, told = read(tmp_path / "robot.xml", text)
    what = "<option> of attached models 'tool', wind of <option> of attached models 'tool'"
    assert told == [f"{tmp_path / 'robot.xml'}: ignored elements: {what}"]
    assert robot.gravity.tolist() == [0, 0, -9.81]


def test_activations_of_incomplete_keyframes_are_named(tmp_path: Path) -> None:
    drives = '<actuator><intvelocity name="i" joint="no" kp="3" actrange="-1 1"/></actuator><keyframe><key name="k" act="1"/></keyframe></mujoco>'
    (tmp_path / "a.xml").write_text(
        MOUNT[: MOUNT.index("<actuator>")].replace('<attach model="inner" body="palm" prefix="in/"/>', "") + drives
    )
    text = ARM.format("", '<attach model="tool" body="mount" prefix="p"/>', "").replace("hands/hand.xml", "a.xml")
    _, told = read(tmp_path / "robot.xml", text)
    assert told == [f"{tmp_path / 'robot.xml'}: ignored elements: act of keyframes of attached models 'k'"]


WRONG = {
    "line 4: <attach>: there is no model 'hook' among the assets; there are: tool, hand": '<attach model="hook" prefix="p"/>',
    "line 4: <attach>: there is no body 'fist' in model 'tool'; there are: world, palm, finger0, finger1, thumb, other": '<attach model="tool" body="fist" prefix="p"/>',
    "line 4: <attach>: expected the attribute 'prefix'": '<attach model="tool" body="palm"/>',
    "line 4: <attach>: there is no attribute 'prefx'; did you mean 'prefix'?": '<attach model="tool" prefx="p"/>',
    "line 13: <body>: there is a body 'arm' in line 3 of 'robot.xml' already": '<attach model="tool" body="m" prefix="ar"/>',
    "there is another 'shoulder' already; names must differ": '<attach model="tool" body="thumb" prefix="shoul"/>',
}  # fmt: skip


@pytest.mark.parametrize("text", WRONG)
def test_wrong_attachments_are_refused(text: str, tmp_path: Path) -> None:
    hand = (
        HAND.replace('name="slide"', 'name="der"').replace('="slide" coef', '="der" coef')
        if "'shoulder'" in text
        else HAND
    )
    hand = hand.replace('name="other"', 'name="m"') if "'arm'" in text else hand
    write(tmp_path / "hands" / "hand.xml", hand)
    with pytest.raises(ValueError) as error:
        read(tmp_path / "robot.xml", ARM.format("", WRONG[text], ""))
    assert text in str(error.value)


def test_files_that_are_not_there_or_attach_themselves_are_refused(tmp_path: Path) -> None:
    text = ARM.format("", '<attach model="tool" body="arm" prefix="p"/>', "")
    with pytest.raises(ValueError, match=r"line 2: <model>: there is no file 'hands/hand.xml' in '"):
        read(tmp_path / "robot.xml", text)
    with pytest.raises(ValueError, match=r"line 4: <attach>: model 'tool' in the file 'robot.xml' attaches itself"):
        read(tmp_path / "robot.xml", text.replace("hands/hand.xml", "robot.xml"))
    (tmp_path / "second.xml").write_text(text.replace("hands/hand.xml", "robot.xml"))
    with pytest.raises(
        ValueError, match=r"second.xml, line 4: <attach>: model 'tool' in the file 'robot.xml' attaches"
    ):
        read(tmp_path / "robot.xml", text.replace("hands/hand.xml", "second.xml"))
    (tmp_path / "other.xml").write_text("<robot/>")
    with pytest.raises(ValueError, match=r"other.xml, line 1: <robot>: expected <mujoco> as the first element"):
        read(tmp_path / "robot.xml", text.replace("hands/hand.xml", "other.xml"))
