"""Elements of MJCF and URDF files are read as by MuJoCo and Pinocchio, where these are installed, or named."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from dalembert.robotics.utilities import ReadRobot

BOX = '<geom type="box" size=".1 .2 .3" pos=".3 0 0"/>'  # 48 kg
BOX_ABOUT_Y = 48 * (0.1**2 + 0.3**2) / 3 + 48 * 0.3**2
OTHER = '<body name="c"><joint name="k" axis="1 0 0"/><geom size=".1"/></body>'
BALL = 1000 * 4 / 3 * np.pi * 0.1**3


def hinged(content: str = BOX, before: str = "", joint: str = '<joint name="j" axis="0 1 0"/>', body: str = "") -> str:
    return f'<mujoco>{before}<worldbody><body name="b" {body}>{joint}{content}</body></worldbody></mujoco>'


def actuated(actuator: str, content: str = BOX, joint: str = '<joint name="j" axis="0 1 0"/>') -> str:
    return hinged(content, joint=joint).replace("</mujoco>", f"<actuator>{actuator}</actuator></mujoco>")


def related(constraint: str, content: str = "") -> str:
    third = '<body name="e"><joint name="i" type="ball"/><geom size=".1"/></body>'
    return hinged(BOX + content + OTHER + third).replace("</mujoco>", f"<equality>{constraint}</equality></mujoco>")


# Files with the first entry of their mass matrix, by formulas; nothing is left out of them.
CARRIED = {
    "plain": (hinged(), BOX_ABOUT_Y),
    "joint in a frame": (
        hinged(joint='<frame pos="0 .2 .5" euler="0 0 90"><joint axis="0 1 0" pos=".1 0 0"/></frame>'),
        # about the direction of -x through (0, 0.3, 0.5)
        48 * (0.2**2 + 0.3**2) / 3 + 48 * (0.3**2 + 0.5**2),
    ),
    "class of a frame": (
        hinged(
            before='<default><default class="a"><joint armature="3"/></default></default>',
            joint='<frame childclass="a"><joint axis="0 1 0"/></frame>',
        ),
        BOX_ABOUT_Y + 3,
    ),
    "settotalmass": (hinged(before='<compiler settotalmass="1"/>'), BOX_ABOUT_Y / 48),
    "boundmass and boundinertia": (
        hinged(before='<compiler boundmass="100" boundinertia="50"/>'), 50 + 100 * 0.3**2
    ),
    "inertiagrouprange": (
        hinged(BOX + '<geom type="sphere" size=".5" group="3"/>', '<compiler inertiagrouprange="0 1"/>'),
        BOX_ABOUT_Y,
    ),
    "balanceinertia": (
        hinged('<inertial pos=".1 .2 .3" mass="2" diaginertia="1 .2 .25"/>', '<compiler balanceinertia="true"/>'),
        1.45 / 3 + 2 * (0.1**2 + 0.3**2),
    ),
    "replicate of shapes": (
        hinged(BOX + '<replicate count="3" offset=".3 0 0"><geom type="sphere" size=".1"/></replicate>'),
        BOX_ABOUT_Y + 3 * 0.4 * BALL * 0.1**2 + BALL * (0.3**2 + 0.6**2),
    ),
    "replicate that turns": (
        hinged(
            BOX + '<replicate count="12" offset=".1 0 .02" euler="0 0 30" sep="-"><geom size=".1" pos="1 0 0"/></replicate>'
        ),
        None,
    ),
    "replicate of bodies": (
        '<mujoco><worldbody><replicate count="11" offset="0.5 0 0" euler="10 0 5"><body name="a" pos="0 .2 0">'
        '<joint name="j" axis="0 1 0"/><geom size=".1" pos="0.3 0 0"/></body></replicate></worldbody></mujoco>',
        BALL * (0.4 * 0.1**2 + 0.3**2),
    ),
    "options one after the other": (hinged(before='<option gravity="0 0 -1"/><option timestep="0.01"/>'), BOX_ABOUT_Y),
    "gravity switched off": (hinged(before='<option><flag gravity="disable"/></option>'), BOX_ABOUT_Y),
    "sites": (
        hinged(
            BOX + '<site name="s" type="capsule" size=".01" fromto=".1 0 0 .5 .2 0"/><site name="t" class="at"/>',
            '<default><default class="at"><site pos=".4 0 0"/></default></default>',
        ),
        BOX_ABOUT_Y,
    ),
    "two free bodies without names of joints": (
        '<mujoco><worldbody><body name="a"><freejoint/><geom size=".1"/></body>'
        '<body name="c" pos="1 0 0"><freejoint/><geom size=".1"/></body></worldbody></mujoco>',
        BALL,
    ),
    "shells": (
        hinged(
            "".join(
                f'<geom type="{kind}" size="{size}" pos="0 .1 .2" euler="10 20 30" shellinertia="true"/>'
                for kind, size in (("box", ".1 .2 .3"), ("cylinder", ".1 .3"), ("capsule", ".1 .3"))
            )
        ),
        None,
    ),
    "hollow ball": (hinged('<geom size=".1" mass="3" shellinertia="true"/>'), 2 / 3 * 3 * 0.1**2),
    "mesh of corners": (
        hinged(
            '<geom type="mesh" mesh="cube"/>',
            '<asset><mesh name="cube" vertex="0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1" scale=".2 .4 .6"/></asset>',
        ),
        48 * (0.2**2 + 0.6**2) / 3,
    ),
    "mesh with faces, moved": (
        hinged(
            '<geom type="mesh" mesh="tet"/>',
            '<asset><mesh name="tet" vertex="0 0 0 1 0 0 0 1 0 0 0 1" face="0 2 1 0 1 3 0 3 2 1 2 3" refpos=".1 .2 .3"'
            ' refquat="1 .2 .3 .4"/></asset>',
        ),
        None,
    ),
}  # fmt: skip


def read(path: Path, text: str) -> tuple[Any, list[str]]:
    path.write_text(text)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        robot = ReadRobot(path, graphics=False)
    return robot, [str(warning.message) for warning in told]


@pytest.mark.parametrize("name", CARRIED)
def test_copied_items(name: str, tmp_path: Path) -> None:
    text, wanted = CARRIED[name]
    robot, told = read(tmp_path / "robot.xml", text)
    assert told == []
    if wanted is not None:
        q = np.zeros(robot.NumberOfLinks())
        assert robot.MassMatrix(q)[0, 0] == pytest.approx(wanted, rel=1e-12)


@pytest.mark.parametrize(("name", "gravity"), [("options one after the other", -1.0), ("gravity switched off", 0.0)])
def test_gravity_of_options(name: str, gravity: float, tmp_path: Path) -> None:
    robot, _ = read(tmp_path / "robot.xml", CARRIED[name][0])
    assert robot.InverseDynamics([0.0], [0.0], [0.0]) == pytest.approx([48 * 0.3 * gravity], rel=1e-12)


def test_sites_have_their_defaults_and_ends(tmp_path: Path) -> None:
    robot, _ = read(tmp_path / "robot.xml", CARRIED["sites"][0])
    assert robot.FrameHT("s", [0.0])[:3, 3] == pytest.approx([0.3, 0.1, 0])
    assert robot.FrameHT("s", [0.0])[:3, 2] == pytest.approx(np.array([-2, -1, 0]) / np.sqrt(5))
    assert robot.FrameHT("t", [0.0])[:3, 3] == pytest.approx([0.4, 0, 0])


@pytest.mark.parametrize("name", CARRIED)
def test_agreement_with_mujoco(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Mass matrix, weight, and places of bodies and sites, at the reference configuration and away from it."""
    mujoco = pytest.importorskip("mujoco", reason="mujoco is installed by the extra [oracles]")
    monkeypatch.chdir(tmp_path)  # MuJoCo writes its log there
    robot, _ = read(tmp_path / "robot.xml", CARRIED[name][0])
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "robot.xml"))
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
    data = mujoco.MjData(model)
    assert model.nv == robot.NumberOfLinks()
    hinges = bool((model.jnt_type == mujoco.mjtJoint.mjJNT_HINGE).all())
    q = np.linspace(-0.7, 0.8, model.nv) if hinges else np.zeros(model.nv)
    if hinges:
        data.qpos[:] = q
    mujoco.mj_forward(model, data)
    mass = np.zeros((model.nv, model.nv))
    for row, unit in zip(mass, np.eye(model.nv), strict=True):
        mujoco.mj_mulM(model, data, row, unit)
    order = np.arange(model.nv) if hinges else np.arange(model.nv).reshape(-1, 6)[:, [0, 1, 2, 5, 4, 3]].ravel()
    close = {"rtol": 2e-7 if "mesh" in name else 1e-12, "atol": 1e-12 * np.abs(mass).max()}  # its corners are floats
    np.testing.assert_allclose(robot.MassMatrix(q), mass[np.ix_(order, order)], **close)
    np.testing.assert_allclose(robot.InverseDynamics(q, 0 * q, 0 * q), data.qfrc_bias[order], **close)
    for kind, places in ((mujoco.mjtObj.mjOBJ_BODY, data.xpos), (mujoco.mjtObj.mjOBJ_SITE, data.site_xpos)):
        for i, place in enumerate(places):
            if frame := mujoco.mj_id2name(model, kind, i):
                np.testing.assert_allclose(robot.FrameHT(frame, q)[:3, 3], place, atol=1e-12, err_msg=frame)


SUPPORT = '<asset><mesh name="m" inertia="convex" vertex="0 0 0 1 0 0 0 1 0 0 0 1"/></asset>'
LEFT_OUT = {
    "actuators <muscle>: 'm'": actuated('<muscle name="m" joint="j"/>'),
    "actuators with dyntype muscle: 'm'": actuated('<general name="m" joint="j" dyntype="muscle"/>'),
    "actuators on sites other than motors without refsite: 'actuator 0', 'm'": actuated(
        '<motor site="t" refsite="t"/><velocity name="m" site="t"/>', BOX + '<site name="t"/>'
    ),
    "actuators that act on body: 'actuator 0'": actuated('<general body="b"/>'),
    "actuators of ball joints: 'j'": actuated('<motor joint="j"/>', joint='<joint name="j" type="ball"/>'),
    "armature of actuators 'j'": actuated('<motor joint="j" armature="2"/>'),
    "actuatorfrcrange of joints with several actuators, or with those of tendons: 'j'": actuated(
        '<motor joint="j"/><motor joint="j"/>', joint='<joint name="j" actuatorfrcrange="-1 2"/>'
    ),
    "actuatorgravcomp of joints with actuatorfrcrange: 'j'": hinged(
        joint='<joint name="j" actuatorfrcrange="-1 2" actuatorgravcomp="true"/>'
    ),
    "spatial tendons that are not between two sites: 'u', constraints of tendons that are not fixed: 't'": related(
        '<tendon name="t" tendon1="u"/>'
    ).replace("</mujoco>", '<tendon><spatial name="u"/></tendon></mujoco>'),
    "constraints of ball joints: 'joint-i'": related('<joint joint1="i"/>'),
    "constraints with torquescale 0: 'weld-b'": related('<weld body1="b" torquescale="0"/>'),
    "actuators <dcmotor>: 'm', act of keyframes with actuators 'm'": actuated('<dcmotor name="m" joint="j"/>').replace(
        "</mujoco>", '<keyframe><key act="1"/></keyframe></mujoco>'
    ),
    "contact, without contacts=True, with geoms of the world 'floor', 'box'": hinged(BOX).replace(
        "<worldbody>",
        '<worldbody><geom name="floor" type="plane" size="1 1 1"/><geom type="box" size="1 1 1" contype="0"/>'
        '<geom size=".1" contype="0" conaffinity="0"/>',
    ),
    "density of <option>, wind of <option>": hinged(before='<option density="1.2" wind="1 0 0"/>'),
    "alignfree of <compiler>": hinged(before='<compiler alignfree="true"/>'),
    "align of free joints 'f'": hinged(joint='<freejoint name="f" align="true"/>'),
    "<composite> in bodies 'b'": hinged(BOX + '<composite type="cable"/>'),
    "<flexcomp> in bodies 'b'": hinged(BOX + '<flexcomp type="grid"/>'),
    "shellinertia of ellipsoids and meshes, which are taken for solid, of bodies 'b'": hinged(
        '<geom type="ellipsoid" size=".1 .2 .3" shellinertia="true"/>'
    ),
    "mass of geoms of type sdf of bodies 'b'": hinged(BOX + '<geom type="sdf" mesh="m"/>'),
    "coefficients of higher order of stiffness of joints 'j'": hinged(joint='<joint name="j" stiffness="2 1"/>'),
    "springdamper of ball and free joints 'j'": hinged(joint='<joint name="j" type="ball" springdamper=".1 1"/>'),
    "frictionloss of ball and free joints 'j'": hinged(joint='<joint name="j" type="ball" frictionloss="1"/>'),
    "range of ball joints 'j'": hinged(joint='<joint name="j" type="ball" range="0 30"/>'),
    "armature against angular velocities, which acts on rates of angles, of joints 'j'": hinged(
        joint='<joint name="j" type="ball" armature=".5"/>'
    ),
    "names of sites that are names of bodies (the sites are called 'name (site)') 'b'": hinged(
        BOX + '<site name="b" pos="1 0 0"/>'
    ),
    "convex inertia of meshes, which exact volumes replace, of bodies 'b'": hinged(
        '<geom type="mesh" mesh="m"/>', SUPPORT
    ),
}  # fmt: skip


@pytest.mark.parametrize("what", LEFT_OUT)
def test_ignored_elements_are_named(what: str, tmp_path: Path) -> None:
    path = tmp_path / "robot.xml"
    _, told = read(path, LEFT_OUT[what])
    assert told == [f"{path}: ignored elements: {what}"]


def test_names_of_bodies_go_before_those_of_sites(tmp_path: Path) -> None:
    robot, _ = read(tmp_path / "robot.xml", hinged(BOX + '<site name="b" pos="1 0 0"/>'))
    assert robot.FrameHT("b", [0.0])[:3, 3] == pytest.approx([0, 0, 0])
    assert robot.FrameHT("b (site)", [0.0])[:3, 3] == pytest.approx([1, 0, 0])


def test_meshes_that_lie_in_themselves_are_named(tmp_path: Path) -> None:
    """MuJoCo sums absolute volumes; those of an L, which is not convex about its middle, are larger."""
    points = [[x, y, z] for z in (0, 1) for x, y in ((0, 0), (3, 0), (3, 0.1), (0.1, 0.1), (0.1, 3), (0, 3))]
    faces = [[0, 2, 1], [0, 3, 2], [0, 4, 3], [0, 5, 4]]
    faces += [[6 + a, 6 + c, 6 + b] for a, b, c in faces]
    faces += [f for i in range(6) for f in ([i, (i + 1) % 6, 6 + i], [(i + 1) % 6, 6 + (i + 1) % 6, 6 + i])]
    numbers = [" ".join(str(v) for row in rows for v in row) for rows in (points, faces)]
    asset = f'<asset><mesh name="m" vertex="{numbers[0]}" face="{numbers[1]}"/></asset>'
    robot, told = read(tmp_path / "robot.xml", hinged('<geom type="mesh" mesh="m"/>', asset))
    assert robot.links[0].mass == pytest.approx(1000 * (0.3 + 0.29), rel=1e-12)
    assert len(told) == 1 and "legacy inertia of meshes, which exact volumes replace, of bodies 'b'" in told[0]


def test_obj_files_need_no_other_package(tmp_path: Path) -> None:
    """A cuboid of quadrangles, with indices of normals, and with indices that count from the end."""
    points = [[x, y, z] for z in (0, 0.6) for x, y in ((0, 0), (0.2, 0), (0.2, 0.4), (0, 0.4))]
    faces = [[4, 3, 2, 1], [5, 6, 7, 8], [1, 2, 6, 5], [2, 3, 7, 6], [3, 4, 8, 7], [-5, -8, -4, -1]]
    lines = ["# cuboid", *(f"v {x} {y} {z}" for x, y, z in points), "vn 0 0 1"]
    lines += ["f " + " ".join(f"{i}//1" if i > 0 else str(i) for i in face) for face in faces]
    (tmp_path / "box.obj").write_text("\n".join(lines))
    text = hinged('<geom type="mesh" mesh="box"/>', '<asset><mesh file="box.obj"/></asset>')
    robot, told = read(tmp_path / "robot.xml", text)
    assert told == []
    assert robot.MassMatrix([0.0])[0, 0] == pytest.approx(48 * (0.2**2 + 0.6**2) / 3, rel=1e-12)


def test_missing_mesh_names_the_remedy(tmp_path: Path) -> None:
    text = hinged('<geom type="mesh" mesh="box"/>', '<asset><mesh file="box.stl"/></asset>')
    with pytest.raises(
        ValueError, match="there is no file .*box.stl'; a body without <inertial> is weighed by its meshes"
    ):
        read(tmp_path / "robot.xml", text)


# ---- URDF --------------------------------------------------------------------------------------------------------------

LINK = '<link name="{}"><inertial><mass value="1"/><inertia ixx="1" ixy="{}" ixz="0" iyy="{}" iyz="0" izz="1"/></inertial></link>'
JOINT = '<joint name="{}" type="{}"><parent link="{}"/><child link="{}"/><axis xyz="0 0 1"/>{}</joint>'
LIMIT = '<limit lower="-1" upper="1" effort="1" velocity="1"/>'


def urdf(*parts: str) -> str:
    return "<robot name='r'><link name='base'/>" + "".join(parts) + "</robot>"


def test_followers_of_followers(tmp_path: Path) -> None:
    """The last of three fingers follows the second, which follows the first: factors multiply, offsets add up."""
    fingers = [
        LINK.format(name, 0, 1) + JOINT.format(f"j{name}", "revolute", "base", name, LIMIT + mimic)
        for name, mimic in (
            ("a", ""),
            ("b", '<mimic joint="ja" multiplier="2" offset="0.1"/>'),
            ("c", '<mimic joint="jb" multiplier="-3" offset="0.2"/>'),
        )
    ]
    for order in (fingers, fingers[::-1]):
        robot, _ = read(tmp_path / "robot.urdf", urdf(*order))
        follows = robot.GetLink("c").follows
        assert follows == ("ja", -6.0, pytest.approx(0.2 - 0.3))
    circle = urdf(fingers[1].replace('joint="ja"', 'joint="jc"'), fingers[2])
    with pytest.raises(ValueError, match="mimic: expected a joint that moves by itself"):
        read(tmp_path / "robot.urdf", circle)


def test_transmissions_are_named(tmp_path: Path) -> None:
    path = tmp_path / "robot.urdf"
    drive = '<transmission name="{}"><joint name="j"/><actuator name="m"/></transmission>'
    text = urdf(LINK.format("a", 0, 1), JOINT.format("j", "revolute", "base", "a", LIMIT), *map(drive.format, "de"))
    _, told = read(path, text)
    assert told == [f"{path}: left out: <transmission> 'd', 'e'"]


def test_followers_are_those_of_pinocchio(tmp_path: Path) -> None:
    """Inverse dynamics in the coordinates that are free; Pinocchio has one coordinate for both joints."""
    pin = pytest.importorskip("pinocchio", reason="pin is installed by the extra [oracles]", exc_type=ImportError)
    offset = '<origin xyz="0.3 0.1 0.2" rpy="0.4 0.5 0.6"/>'
    heavy = '<inertial><origin xyz=".1 .2 .3"/>'
    parts = [LINK.format("a", 0.1, 1), LINK.format("b", 0.2, 1), LINK.format("c", 0, 1)]
    joints = [
        JOINT.format("ja", "revolute", "base", "a", LIMIT),
        JOINT.format("jb", "revolute", "a", "b", LIMIT + offset),
        JOINT.format("jc", "revolute", "b", "c", LIMIT + offset + '<mimic joint="ja" multiplier="-1.5" offset="0.3"/>'),
    ]
    text = urdf(*parts, *joints).replace("<inertial>", heavy)
    robot, told = read(tmp_path / "robot.urdf", text)
    assert told == []
    model = pin.buildModelFromXML(text, mimic=True)
    assert model.nv == 2
    factors = np.array([[1, 0], [0, 1], [-1.5, 0]])
    for q, v, a in np.random.default_rng(3).uniform(-1, 1, (4, 3, 2)):
        wanted = pin.rnea(model, model.createData(), q, v, a)
        forces = robot.InverseDynamics(robot.FollowedCoordinates([*q, 0]), factors @ v, factors @ a)
        np.testing.assert_allclose(factors.T @ forces, wanted, rtol=1e-12, atol=1e-12)


def test_extensions_of_vendors_are_ignored(tmp_path: Path) -> None:
    text = urdf(LINK.format("a", 0, 1), JOINT.format("j", "revolute", "base", "a", LIMIT))
    robot, told = read(tmp_path / "robot.urdf", text.replace("velocity=", 'gear_velocity="7" velocity='))
    assert told == [] and robot.links[0].maxVelocity == 1
    with pytest.raises(ValueError, match="there is no attribute 'gear_velocity'; did you mean 'velocity'"):
        read(tmp_path / "robot.urdf", text.replace("velocity=", "gear_velocity="))


def test_moments_that_are_negative_by_rounding(tmp_path: Path) -> None:
    """Files have products of inertia of 1e-4 next to a moment of zero, due to rounding: a warning, no refusal."""
    hinge = JOINT.format("j", "revolute", "base", "a", LIMIT)
    robot, told = read(tmp_path / "robot.urdf", urdf(LINK.format("a", 1e-4, 0), hinge))
    assert "<inertia>: a principal moment of -1e-08 is taken for zero" in told[0]
    assert np.linalg.eigvalsh(robot.links[0].inertia).min() > -1e-15
    with pytest.raises(ValueError, match="without negative principal moments"):
        read(tmp_path / "robot.urdf", urdf(LINK.format("a", 0, -0.1), hinge))


@pytest.mark.parametrize("kind", ["planar", "floating"])
def test_lost_features_of_joints_are_named(kind: str, tmp_path: Path) -> None:
    path = tmp_path / "robot.urdf"
    joint = JOINT.format("j", kind, "base", "a", LIMIT + '<dynamics damping="1"/>')
    _, told = read(path, urdf(LINK.format("a", 0, 1), joint))
    assert told == [f"{path}: left out: <limit>, <dynamics> of joint 'j' ({kind})"]


def test_springs_of_gazebo_are_named_and_macros_refused(tmp_path: Path) -> None:
    path = tmp_path / "robot.urdf"
    robot = LINK.format("a", 0, 1) + JOINT.format("j", "revolute", "base", "a", LIMIT)
    spring = '<gazebo reference="j"><springStiffness>3</springStiffness></gazebo>'
    _, told = read(path, urdf(robot, spring))
    assert told == [f"{path}: left out: springs of <gazebo reference='j'>"]
    with pytest.raises(ValueError, match="<xacro:wheel>: this is a macro; run xacro of ROS"):
        read(path, urdf(robot, '<xacro:wheel side="left"/>'))
