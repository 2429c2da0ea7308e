"""Robots from URDF and MJCF files: the mechanism, its names and shapes; and faults in a file, with the line."""

from __future__ import annotations

import re
import shutil
import sys
from pathlib import Path

import numpy as np
import pytest

from dalembert import graphics
from dalembert.rigidBodyUtilities import (
    HTrotateX,
    HTrotateY,
    HTrotateZ,
    HTtranslate,
    InertiaCylinder,
    RotationMatrixX,
    RotationVector2RotationMatrix,
)
from dalembert.robotics import Robot, RobotLink
from dalembert.robotics._shapes import Shape, drawn, inertia
from dalembert.robotics.utilities import (
    AddLidar,
    GetRoboticsToolboxInternalModel,
    GetURDFrobotData,
    LoadURDFrobot,
    ReadRobot,
)

DATA = Path(__file__).parent / "data"
URDF, MJCF = (DATA / "arm.urdf").read_text(), (DATA / "arm.xml").read_text()


@pytest.fixture
def package(tmp_path):
    """Return a folder with a package arm, which has the URDF file and its mesh, a bar of 0.2 x 0.1 x 0.4 m."""
    folder = tmp_path / "packages/arm"
    (folder / "meshes").mkdir(parents=True)
    graphics.ExportSTL(
        graphics.Brick([0, 0, 0], [0.2, 0.1, 0.4]),
        str(folder / "meshes/bar.stl"),
        invertNormals=False,
        invertTriangles=False,
    )
    (folder / "arm.urdf").write_text(URDF)
    return folder.parent


def placed(xyz=(0, 0, 0), rpy=(0, 0, 0)):
    roll, pitch, yaw = rpy
    return HTtranslate(xyz) @ HTrotateZ(yaw) @ HTrotateY(pitch) @ HTrotateX(roll)


# ---- URDF -------------------------------------------------------------------------------------------------------------


def test_poses_of_links_of_a_urdf_file(package):
    robot = ReadRobot(package / "arm/arm.urdf")
    assert robot.name == "arm"
    assert [(link.name, link.jointName) for link in robot.links] == [
        ("column", "yaw"),
        ("slider", "slide"),
        ("wheel", "wheel"),
    ]
    q = np.array([0.3, 0.1, -0.8])
    column = placed([0.1, 0.2, 0.3], [0.4, -0.3, 0.2]) @ HTrotateZ(q[0])
    flange = column @ placed([0, 0, 0.5], [0, 1, 0])
    slider = flange @ HTtranslate(np.array([0.1, 0, 0]) + q[1] * np.array([1, -2, 2]) / 3)
    wheel = column @ HTrotateY(-q[2])
    for name, T in {"column": column, "flange": flange, "slide": slider, "wheel": wheel, "base": np.eye(4)}.items():
        np.testing.assert_allclose(robot.FrameHT(name, q), T, atol=1e-14, err_msg=name)


def test_names_of_links_go_before_those_of_joints():
    """The joint 'shoulder' of the example carries the link 'upper_arm', and the link 'shoulder' rotates in the
    waist."""
    robot = ReadRobot(Path(__file__).parents[2] / "examples/six_axis_arm.urdf", graphics=False)
    assert (robot.GetLinkIndex("shoulder"), robot.GetJointIndex("shoulder")) == (0, 1)
    assert robot.GetLink("elbow").name == "forearm" and robot.LinkNumbers()["shoulder"] == 0


def test_names_stand_for_links_in_dynamics():
    robot = ReadRobot(Path(__file__).parents[2] / "examples/six_axis_arm.urdf", graphics=False)
    q, dynamics = np.full(robot.NumberOfLinks(), 0.3), robot.Dynamics()
    number = robot.GetLinkIndex("forearm")
    for name in ("elbow", "forearm"):  # joint and link
        np.testing.assert_array_equal(dynamics.Jacobian(q, name), dynamics.Jacobian(q, number))
    with pytest.raises(ValueError, match=r"linkNumber: received knee; expected 0 to \d+, or one of .*elbow"):
        dynamics.Jacobian(q, "knee")


def test_inertias_of_a_urdf_file(package):
    """Against links that are added by hand, with fixed ones as masses of their own."""
    robot = ReadRobot(package / "arm/arm.urdf", graphics=False)
    q, q_t, q_tt = np.random.default_rng(0).normal(size=(3, 3))
    A = placed(rpy=[0.1, 0.2, 0.3])[:3, :3]
    tensor = A @ np.array([[0.1, 0.01, 0.02], [0.01, 0.12, 0.03], [0.02, 0.03, 0.14]]) @ A.T
    column, flange = placed([0.1, 0.2, 0.3], [0.4, -0.3, 0.2]), placed([0, 0, 0.5], [0, 1, 0])
    axis = RotationVector2RotationMatrix(np.arccos(2 / 3) * np.array([2, 1, 0]) / np.sqrt(5))  # z to (1, -2, 2) / 3
    along = flange @ HTtranslate([0.1, 0, 0])
    along[:3, :3] = along[:3, :3] @ axis
    other = Robot()
    other.AddLink(RobotLink(4, [0, 0, 0.1], tensor, preHT=column, damping=0.4, friction=0.2))
    other.AddLink(RobotLink(2, [0, 0, 0], axis.T @ np.diag([0.02, 0.03, 0.02]) @ axis, preHT=along, jointType="Pz"))
    other.AddLink(RobotLink(1, [0, 0, 0], 0.01 * np.eye(3), preHT=HTrotateX(np.pi), jointType="Ry", parent=0))
    own = other.links[0]
    welded = own.JointInertia() + RobotLink(0.5, [0, 0, 0], 0.01 * np.eye(3), localHT=flange).JointInertia()
    own.mass, own.COM, own.inertia = welded.Mass(), welded.COM(), welded.InertiaCOM()
    np.testing.assert_allclose(robot.InverseDynamics(q, q_t, q_tt), other.InverseDynamics(q, q_t, q_tt), atol=1e-12)


def test_limits_of_joints_of_a_urdf_file(package):
    yaw, slide, wheel = ReadRobot(package / "arm/arm.urdf").links
    assert (yaw.damping, yaw.friction, yaw.maxVelocity, yaw.maxForce) == (0.4, 0.2, 3, 80)
    assert yaw.jointLimits.tolist() == [-1.5, 2] and slide.jointLimits.tolist() == [0, 0.3]
    assert wheel.jointLimits is None and wheel.jointType == "Rz"


def test_shapes_of_a_urdf_file(package):
    robot = ReadRobot(package / "arm/arm.urdf", baseHT=HTtranslate([1, 0, 0]), gravity=[0, 0, -1.62])
    mesh, ball, plate = robot.links[0].visualization.graphicsData
    points = np.asarray(mesh["points"], dtype=float).reshape(-1, 3)
    np.testing.assert_allclose(
        [points.min(axis=0), points.max(axis=0)], [[-0.2, -0.05, 0], [0.2, 0.05, 0.4]], atol=1e-7
    )
    np.testing.assert_allclose(np.asarray(mesh["colors"]).reshape(-1, 4)[0], [1, 0, 0, 1])
    assert graphics.BoundingBoxSingle(plate)[1][2] > 0.5 and graphics.BoundingBoxSingle(ball)[1][2] == pytest.approx(
        0.05
    )
    assert len(robot.base.visualization.graphicsData) == 1
    assert robot.GetBaseHT()[0, 3] == 1 and robot.gravity[2] == -1.62
    for packages in (package, [package], {"arm": package / "arm"}):
        (package.parent / "elsewhere.urdf").write_text(URDF)
        again = ReadRobot(package.parent / "elsewhere.urdf", packages=packages)
        assert len(again.links[0].visualization.graphicsData) == 3


FLOATING = """<robot name="floating"><link name="world"/>
<link name="body"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
<joint name="free" type="{}"><parent link="world"/><child link="body"/><axis xyz="0 0 1"/></joint></robot>"""


@pytest.mark.parametrize(("kind", "count"), [("floating", 6), ("planar", 3)])
def test_joints_of_several_coordinates(kind, count, tmp_path):
    (tmp_path / "robot.urdf").write_text(FLOATING.format(kind))
    robot = ReadRobot(tmp_path / "robot.urdf")
    assert [link.jointName for link in robot.links] == [f"free:{i}" for i in range(count)]
    assert [link.mass for link in robot.links] == [0] * (count - 1) + [1]
    q = np.linspace(0.1, 0.6, count)
    J = robot.Jacobian(robot.JointHT(q), linkIndex="body")
    assert np.linalg.matrix_rank(J) == count
    np.testing.assert_allclose(J[2:5] if kind == "planar" else 0, 0, atol=1e-15)
    weight = robot.InverseDynamics(q, 0 * q, 0 * q)
    np.testing.assert_allclose(weight, [0, 0, 9.81, 0, 0, 0] if kind == "floating" else 0, atol=1e-14)


# ---- MJCF -------------------------------------------------------------------------------------------------------------


def test_mjcf_file_against_mujoco():
    """Values of MuJoCo 4.0.0: qM, qfrc_bias - qfrc_passive, site xpos and subtree_com of the file."""
    robot = ReadRobot(DATA / "arm.xml")
    assert [link.jointName for link in robot.links] == ["yaw", "pitch", "slide", "", ""]
    q, q_t = np.linspace(0.3, 0.7, 5), np.linspace(1, -1, 5)
    mass = np.zeros((5, 5))
    mass[np.tril_indices(5)] = [
        16.82316043708,
        *(0.5184752037579, 18.70389279513),
        *(1.128728992773, 11.49574482031, 36.42477796077),
        *(0.04368287435108, 0.1977657479412, 0, 0.25),
        *(0.01543252507876, 0, 0, 0, 0.01675516081915),
    ]
    np.testing.assert_allclose(np.tril(robot.MassMatrix(q)), mass, atol=1e-11)
    bias = [110.7906981096, -177.5904913845, -287.7093765500, -0.06659417177084, -0.3032623834757]
    np.testing.assert_allclose(robot.InverseDynamics(q, q_t, 0 * q), bias, rtol=1e-11)
    np.testing.assert_allclose(
        robot.FrameHT("tip", q)[:3, 3], [1.053078500291, 0.370770483963, 0.141367881818], rtol=1e-11
    )
    np.testing.assert_allclose(robot.CenterOfMass(q), [0.459853689816, 0.259270365965, 0.181274398592], rtol=1e-11)


def test_limits_of_joints_of_an_mjcf_file():
    yaw, pitch, slide, _, wheel = ReadRobot(DATA / "arm.xml").links
    np.testing.assert_allclose(yaw.jointLimits, [-np.pi / 2, np.pi / 2])
    assert pitch.jointLimits is None and (pitch.damping, pitch.rotorInertia) == (0.3, 0.2)
    assert slide.damping == 0 and wheel.name == "wheel"
    assert [len(link.visualization.graphicsData) for link in (yaw, pitch, slide, wheel)] == [0, 4, 3, 1]
    assert ReadRobot(DATA / "arm.xml").referenceConfiguration[0] == pytest.approx(np.radians(20))


def test_parts_of_mjcf_files(tmp_path, package):
    """Included files, meshes with a mass by their volume, free and ball joints, other ways to give rotations."""
    (tmp_path / "assets.xml").write_text(
        '<mujocoinclude><asset><mesh name="bar" file="bar.stl" scale="1 1 -1"/>'
        '<material name="blue" rgba="0 0 1 1"/></asset></mujocoinclude>'
    )
    path = tmp_path / "robot.xml"
    path.write_text(
        f"""<mujoco><include file="assets.xml"/><compiler angle="radian" meshdir="{package / "arm/meshes"}"/>
        <worldbody><body name="free" quat="1 0 0 1"><freejoint name="root"/>
        <geom type="mesh" mesh="bar" material="blue" density="2000"/>
        <body name="limb" euler="0.1 0.2 0.3"><joint name="hip" type="ball" pos="0 0 0.1" damping="0.5"/>
        <geom type="cylinder" size="0.1 0.2" mass="3"/></body></body></worldbody></mujoco>"""
    )
    with pytest.warns(UserWarning, match="damping against angular velocities, which acts on rates of angles"):
        robot = ReadRobot(path)
    assert [link.jointType for link in robot.links] == ["Px", "Py", "Pz", "Rz", "Ry", "Rx", "Rz", "Ry", "Rx"]
    bar = robot.GetLink("free")
    assert bar.mass == pytest.approx(2000 * 0.2 * 0.1 * 0.4)
    np.testing.assert_allclose(np.diag(bar.inertia), bar.mass / 12 * np.array([0.17, 0.2, 0.05]), rtol=1e-6)
    assert robot.GetLink("limb").mass == pytest.approx(3)
    np.testing.assert_allclose(bar.visualization.graphicsData[0]["colors"][:4], [0, 0, 1, 1])
    turned = RotationMatrixX(0.1) @ HTrotateY(0.2)[:3, :3] @ HTrotateZ(0.3)[:3, :3]
    np.testing.assert_allclose(robot.LinkHT(np.zeros(9))[-1][:3, :3], HTrotateZ(np.pi / 2)[:3, :3] @ turned, atol=1e-15)
    assert robot.GetLink("hip:0").damping == 0.5
    with pytest.warns(UserWarning, match="ignored elements: <contact>, stiffness of ball and free joints 'hip'"):
        text = path.read_text().replace("<worldbody>", "<contact><pair/></contact><worldbody>")
        path.write_text(text.replace(' damping="0.5"', ' stiffness="2"'))
        ReadRobot(path)


def test_inertia_and_graphics_of_shapes():
    """A capsule is a cylinder and a ball cut in two; it is a ball if the length is zero. All are drawn as large as they
    are."""
    ball = inertia(Shape("sphere", (0.3,)), 1000)
    np.testing.assert_allclose(inertia(Shape("capsule", (0.3, 1e-9)), 1000).Inertia(), ball.Inertia(), rtol=1e-7)
    np.testing.assert_allclose(inertia(Shape("ellipsoid", (0.3, 0.3, 0.3)), 1000).Inertia(), ball.Inertia())
    long = inertia(Shape("capsule", (0.01, 10.0)), 1000)
    np.testing.assert_allclose(long.Inertia(), InertiaCylinder(1000, 10.0, 0.01, 2).Inertia(), rtol=5e-3)
    extents = {
        Shape("box", (1, 2, 3)): [1, 2, 3],
        Shape("sphere", (0.5,)): [1, 1, 1],
        Shape("ellipsoid", (0.5, 1, 1.5)): [1, 2, 3],
        Shape("cylinder", (0.5, 3)): [1, 1, 3],
        Shape("capsule", (0.5, 2)): [1, 1, 3],
    }
    for shape, size in extents.items():
        lower, upper = graphics.BoundingBox(drawn(shape, [1, 0, 0, 1]))
        np.testing.assert_allclose(np.array(upper) - lower, size, rtol=0.05, err_msg=shape.kind)


# ---- data for models of their own ---------------------------------------------------------------------------------------


def test_links_from_data_make_the_same_robot(package):
    loaded = LoadURDFrobot("arm/arm.urdf", package)
    assert loaded["urdfBasePath"] == str(package)
    colors = [graphics.color.red, graphics.color.green, graphics.color.blue]
    data = GetURDFrobotData(loaded["robot"], loaded["urdf"], colors, returnStaticGraphicsList=True)
    robot = Robot()
    numbers = {"None": -1} | {link["name"]: i for i, link in enumerate(data["linkList"])}
    for link in data["linkList"]:
        robot.AddLink(
            RobotLink(
                link["mass"],
                link["com"],
                link["inertiaCOM"],
                preHT=link["preHT"],
                jointType=link["jointType"],
                parent=numbers[link["parentName"]],
                damping=link["motorViscousFriction"],
                friction=link["motorCoulombFriction"][0],
            )
        )
    q, q_t, q_tt = np.random.default_rng(0).normal(size=(3, 3))
    wanted = loaded["robot"].InverseDynamics(q, q_t, q_tt)
    np.testing.assert_allclose(robot.InverseDynamics(q, q_t, q_tt), wanted, atol=1e-12)
    assert len(data["staticGraphicsList"]) == 4 and data["numberOfJoints"] == 3
    np.testing.assert_allclose(data["linkList"][0]["graphicsDataList"][1]["colors"][:4], graphics.color.red)
    np.testing.assert_allclose(data["linkList"][0]["staticHT"], placed([0.1, 0.2, 0.3], [0.4, -0.3, 0.2]))


def test_rays_of_lidars_form_a_fan():
    import dalembert as exu

    mbs = exu.SystemContainer().AddSystem()
    mbs.AddGeneralContact()
    sensors = AddLidar(
        mbs, 0, [1, 2, 3], numberOfSensors=5, angleEnd=np.pi, inclination=0.1, lineLength=2, addGraphicsObject=False
    )
    rays = np.array([mbs.GetSensor(sensor)["factors"][5:8] for sensor in sensors])
    np.testing.assert_allclose(np.arctan2(rays[:, 1], rays[:, 0]), np.linspace(0, np.pi, 5), atol=1e-15)
    np.testing.assert_allclose(rays[:, 2], 2 * np.sin(0.1))
    np.testing.assert_allclose(np.linalg.norm(rays, axis=1), 2)
    with pytest.raises(ValueError, match="AddLidar: numberOfSensors: expected a number greater than 1, received 1"):
        AddLidar(mbs, 0, [0, 0, 0], numberOfSensors=1)


# ---- rejected files
# -----------------------------------------------------------------------------------------------------

WRONG_URDF = {
    "line 26: <dynamics>: there is no attribute 'dampin'; did you mean 'damping'": ("damping=", "dampin="),
    "line 29: <inertal>: there is no element 'inertal'; did you mean 'inertial'": (
        '<inertial><mass value="0.5"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>',
        "<inertal/>",
    ),
    "line 1: <a>: expected <robot> as the first element": (URDF[URDF.index("<?xml") :], "<a/>"),
    "line 20: no XML: junk after document element": ("</link>\n  <joint", "</link></robot>\n  <joint"),
    "line 25: <limit>: expected lower <= upper, received 3 and 2": ('lower="-1.5"', 'lower="3"'),
    "line 24: <axis>: xyz: expected a vector that is not zero": ('<axis xyz="0 0 1"/>', '<axis xyz="0 0 0"/>'),
    "line 24: <axis>: xyz: expected 3 finite numbers, received '0 0'": ('<axis xyz="0 0 1"/>', '<axis xyz="0 0"/>'),
    "line 21: <origin>: xyz: expected 3 finite numbers, received '0 x 1'": ('xyz="0.1 0.2 0.3"', 'xyz="0 x 1"'),
    "line 20: <joint>: joint 'yaw': type: expected one of revolute, continuous, .* received 'hinge'": (
        "revolute",
        "hinge",
    ),
    "line 20: <joint>: joint 'yaw': there is no link 'bas'; there are: base, column,": (
        '<parent link="base"/>',
        '<parent link="bas"/>',
    ),
    "line 22: <parent>: expected the attribute 'link'": ('<parent link="base"/>', "<parent/>"),
    "line 32: <joint>: joint 'weld': link 'column' is carried by joint 'yaw' in line 20 already": (
        '<child link="flange"/>',
        '<child link="column"/>',
    ),
    "line 28: <link>: there is a link 'column' in line 7 already": ('<link name="flange">', '<link name="column">'),
    "line 37: <link>: expected one link that no joint carries, received 'base', 'other'": (
        '<link name="slider">',
        '<link name="other"/><link name="slider">',
    ),
    "line 10: <mass>: value: expected a number that is not negative, received -4": ('value="4"', 'value="-4"'),
    "line 11: <inertia>: expected the attribute 'ixx'": ('ixx="0.1" ', ""),
    "line 11: <inertia>: RigidBodyInertia: inertiaTensor: expected a tensor without negative": (
        'ixx="0.1"',
        'ixx="-0.1"',
    ),
    "line 8: <inertial>: expected an element <mass> in it": ('<mass value="4"/>', ""),
    "line 15: <mesh>: there is no file 'package://legs/meshes/bar.stl'; give the folder of its package": (
        "package://arm",
        "package://legs",
    ),
    "line 15: <geometry>: expected <box>, <cylinder>, <sphere> or <mesh> in it": ("<mesh filename", "<cone filename"),
    "line 40: <joint>: joint 'slide' of type prismatic: expected an element <limit>": (
        '<limit lower="0" upper="0.3" effort="200" velocity="1"/>',
        "",
    ),
    "line 20: <joint>: joint 'yaw': mimic: expected a joint that moves by itself, of slide, wheel": (
        '<axis xyz="0 0 1"/>',
        '<axis xyz="0 0 1"/><mimic joint="weld"/>',
    ),
    "line 23: <child>: there is one in line 23 already": (
        '<child link="column"/>',
        '<child link="column"/><child link="base"/>',
    ),
}


@pytest.mark.parametrize("message", WRONG_URDF)
def test_wrong_urdf_files_are_refused_with_their_line(message, package):
    old, new = WRONG_URDF[message]
    assert old in URDF
    path = package / "arm/arm.urdf"
    path.write_text(URDF.replace(old, new, 1))
    with pytest.raises(ValueError, match=re.escape(f"{path}, ") + message):
        ReadRobot(path)


WRONG_MJCF = {
    "line 14: <joint>: there is no attribute 'armatur'; did you mean 'armature'": ("armature=", "armatur="),
    "line 5: <joint>: there is no attribute 'dampin'; did you mean 'damping'": ('<joint damping="0.3"', '<joint dampin="0.3"'),
    "line 26: <joit>: there is no element 'joit'; did you mean 'joint'": ('<joint axis="1 0 0"/>', '<joit axis="1 0 0"/>'),
    "line 13: <joint>: type: expected one of hinge, slide, ball, free, received 'hook'": ('axis="0 0 1" pos="0.01', 'type="hook" pos="0.01'),
    "line 15: <geom>: class: there is no default class 'bar'; there are: main, bars": ('<geom class="bars"', '<geom class="bar"'),
    "line 16: <geom>: size: expected 1 to 3 finite numbers, received ''": ('size="0.04"', 'size=""'),
    "line 16: <geom>: type: expected one of sphere, .*, received 'cone'": ('type="capsule" fromto', 'type="cone" fromto'),
    "line 17: <body>: there is a body 'column' in line 12 already": ('<body name="fore"', '<body name="column"'),
    "line 12: <body>: expected one way to give a rotation, received euler, quat": ('euler="10 20 30"', 'euler="10 20 30" quat="1 0 0 0"'),
    "line 13: <joint>: range: expected two numbers that grow, received 90 and -90": ('range="-90 90"', 'range="90 -90"'),
    "line 35: <geom>: mesh: there is no <mesh name='bar'> among the assets": ('<geom type="sphere" size="0.1"/>', '<geom type="mesh" mesh="bar"/>'),
    "line 35: <geom>: mesh: MuJoCo fits a sphere to this mesh, .* use type='mesh'": ('<geom type="sphere" size="0.1"/>', '<geom mesh="bar"/>'),
    "line 4: <include>: there is no file 'more.xml'": ("<default>", '<include file="more.xml"/><default>'),
}  # fmt: skip


@pytest.mark.parametrize("message", WRONG_MJCF)
def test_wrong_mjcf_files_are_refused_with_their_line(message, tmp_path):
    old, new = WRONG_MJCF[message]
    assert old in MJCF
    path = tmp_path / "arm.xml"
    path.write_text(MJCF.replace(old, new, 1))
    with pytest.raises(ValueError, match=re.escape(f"{path}, ") + message):
        ReadRobot(path)


def test_elements_of_other_programs_are_ignored(tmp_path):
    path = tmp_path / "arm.urdf"
    path.write_text(
        URDF.replace("</robot>", '<gazebo reference="base"><damping>1</damping></gazebo></robot>').replace(
            "<dynamics ", '<dynamics stick="1" '
        )
    )
    assert ReadRobot(path, graphics=False).NumberOfLinks() == 3


def test_impossible_inertias_are_reported_with_their_line(tmp_path):
    path = tmp_path / "arm.urdf"
    path.write_text(URDF.replace('ixx="0.02"', 'ixx="0.2"'))
    with pytest.warns(UserWarning, match=re.escape(f"{path}, line 38: <inertia>: RigidBodyInertia: principal moments")):
        ReadRobot(path, graphics=False)


def test_links_in_a_circle_and_other_refusals(tmp_path):
    joints = "".join(
        f'<joint name="{a}{b}" type="fixed"><parent link="{a}"/><child link="{b}"/></joint>\n' for a, b in ("bc", "cb")
    )
    path = tmp_path / "circle.urdf"
    path.write_text(f'<robot>\n<link name="a"/><link name="b"/><link name="c"/>\n{joints}</robot>')
    with pytest.raises(ValueError, match="line 3: <joint>: joint 'bc': its links carry each other in a circle"):
        ReadRobot(path)
    with pytest.raises(ValueError, match="a xacro file is a program; run xacro of ROS"):
        LoadURDFrobot("robot.urdf.xacro", tmp_path)
    with pytest.raises(FileNotFoundError):
        ReadRobot(tmp_path / "nothing.urdf")


# ---- roboticstoolbox-python --------------------------------------------------------------------------------------------


@pytest.fixture
def toolbox(tmp_path, monkeypatch):
    """Put a stand-in of the toolbox into a folder that imports find: its models read texts, as those of the toolbox do."""
    files = {
        "rtbdata/__init__.py": "",
        "rtbdata/xacro/arm/__init__.py": "",
        "roboticstoolbox/__init__.py": "from roboticstoolbox import models",
        "roboticstoolbox/models/__init__.py": "from roboticstoolbox.models import URDF",
        "roboticstoolbox/tools/__init__.py": "",
        "roboticstoolbox/tools/urdf.py": "class URDF:\n    @staticmethod\n    def loadstr(text, file): return text, file\n",
        "roboticstoolbox/models/URDF.py": f"""
from roboticstoolbox.tools.urdf import URDF
class URDFRobot:
    count = 1
    def __init__(self):
        for i in range(self.count):
            self.urdf_filepath = URDF.loadstr(TEXT, 'arm.urdf.xacro')[1]
class Arm(URDFRobot): pass
class TwoArms(URDFRobot): count = 2
class Distant(URDFRobot):
    def __init__(self): raise OSError('no internet')
TEXT = {URDF!r}
""",
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    for name in [name for name in sys.modules if name.split(".")[0] in ("roboticstoolbox", "rtbdata")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.syspath_prepend(tmp_path)
    yield tmp_path / "rtbdata/xacro"
    for name in [name for name in sys.modules if name.split(".")[0] in ("roboticstoolbox", "rtbdata")]:
        del sys.modules[name]


def test_models_of_the_toolbox_are_read_as_it_reads_them(toolbox, package):
    with pytest.warns(UserWarning, match="shapes are left out: .*arm.urdf.xacro, line .* there is no file"):
        found = GetRoboticsToolboxInternalModel("Arm")
    assert found["urdfFilePath"] == "arm.urdf.xacro" and found["urdfBasePath"] == str(toolbox)
    with pytest.raises(ValueError, match="there is no file 'package://arm/meshes/bar.stl'"):
        GetRoboticsToolboxInternalModel("Arm", ignoreURDFerrors=False)
    shutil.copytree(package / "arm", toolbox / "arm", dirs_exist_ok=True)
    robot = GetRoboticsToolboxInternalModel("Arm", ignoreURDFerrors=False)["robot"]
    data = [
        GetURDFrobotData(each, returnStaticGraphicsList=True) for each in (robot, ReadRobot(package / "arm/arm.urdf"))
    ]
    assert repr(data[0]) == repr(data[1]) and len(data[0]["staticGraphicsList"]) > 0


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("TwoArm", "modelName: expected one of Arm, Distant, TwoArms, received 'TwoArm'. Did you mean 'TwoArms'"),
        ("TwoArms", "'TwoArms' is made of 2 URDF files"),
        ("Distant", "the toolbox cannot make its model 'Distant': no internet"),
    ],
)
def test_models_that_the_toolbox_does_not_have_or_make_are_refused(toolbox, name, message):
    with pytest.raises(ValueError, match=message):
        GetRoboticsToolboxInternalModel(name)


def test_without_the_toolbox_the_error_names_the_package(monkeypatch):
    monkeypatch.setitem(sys.modules, "roboticstoolbox", None)
    with pytest.raises(ImportError, match="pip install roboticstoolbox-python.*given to ReadRobot or LoadURDFrobot"):
        GetRoboticsToolboxInternalModel("UR5")


def test_frames_of_a_model_are_those_of_the_toolbox():
    rtb = pytest.importorskip("roboticstoolbox")
    robot, other = GetRoboticsToolboxInternalModel("vx300")["robot"], rtb.models.URDF.vx300()
    q = np.linspace(-1, 1, robot.NumberOfLinks())
    numbers, theirs = robot.LinkNumbers(), np.zeros(other.n)
    for link in other.links:
        if link.isjoint:
            theirs[link.jindex] = q[numbers[link.name]]
    for link, T in zip(other.links, other.fkine_all(theirs)[1:], strict=True):
        np.testing.assert_allclose(robot.FrameHT(link.name, q), np.asarray(T), atol=1e-14)
