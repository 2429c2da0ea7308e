"""Robots as kinematic trees in systems: the motion that coordinates of joints follow, with all that acts in joints."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from robots import ALL_JOINTS, arbitrary
from scipy.integrate import solve_ivp

import dalembert as exu
from dalembert import graphics
from dalembert.itemInterface import MarkerBodyRigid, MarkerKinematicTreeRigid, SensorKinematicTree
from dalembert.rigidBodyUtilities import HTtranslate
from dalembert.robotics import Robot, RobotLink, VRobotBase, VRobotLink

DATA = Path(__file__).parent / "data"
START = np.array([0.3, -0.2, 0.5, -0.4, 0.1, 0.2, -0.3])


def settings(duration, steps):
    result = exu.SimulationSettings()
    result.timeIntegration.numberOfSteps = steps
    result.timeIntegration.endTime = duration
    result.timeIntegration.generalizedAlpha.spectralRadius = 1
    result.solutionSettings.writeSolutionToFile = False
    return result


def moved(robot, duration=0.4, steps=400, solver=exu.DynamicSolverType.RK44, force=0, **stops):
    """Return the coordinates of the joints after a motion from rest."""
    mbs = exu.SystemContainer().AddSystem()
    made = robot.CreateKinematicTree(mbs, forceUserFunction=force, **stops)
    mbs.Assemble()
    mbs.SolveDynamic(settings(duration, steps), solverType=solver)
    return np.atleast_1d(mbs.GetObjectOutput(made["objectKinematicTree"], exu.OutputVariableType.Coordinates))


def integrated(robot, torques, duration=0.4):
    """Return the same by the equations of the robot."""

    def rates(t, y):
        q, q_t = y.reshape(2, -1)
        return np.concatenate([q_t, robot.ForwardDynamics(q, q_t, torques(q, q_t))])

    start = robot.referenceConfiguration
    return solve_ivp(rates, (0, duration), [*start, *np.zeros(len(start))], rtol=1e-11, atol=1e-13).y[: len(start), -1]


@pytest.mark.parametrize("branches", [False, True], ids=["chain", "tree"])
def test_trees_move_as_the_equations_of_the_robot_say(branches):
    """All joint types, on a base that is turned, with drives and damping."""
    robot = arbitrary(ALL_JOINTS, seed=3, branches=branches, damping=0.4, PDcontrol=(20.0, 1.5))
    robot.referenceConfiguration = START
    wanted = integrated(robot, lambda q, q_t: -20 * q - 1.5 * q_t)
    assert np.abs(wanted - START).max() > 0.1
    np.testing.assert_allclose(moved(robot), wanted, atol=1e-9)


def test_rotors_and_forces_of_the_user():
    """Inertias of rotors are added to the mass matrix; implicit steps of second order."""
    robot = arbitrary(ALL_JOINTS, seed=4, rotorInertia=0.7)
    robot.referenceConfiguration = START
    wanted = integrated(robot, lambda q, q_t: 3 - q_t)
    solver = exu.DynamicSolverType.GeneralizedAlpha
    errors = [
        np.abs(moved(robot, steps=n, solver=solver, force=lambda mbs, t, i, q, q_t: 3 - np.array(q_t)) - wanted).max()
        for n in (50, 100)
    ]
    assert errors[1] < 1e-4 and errors[0] / errors[1] == pytest.approx(4, rel=0.1)


def slider(**values):
    """Return a mass of 2 kg on a slide along x."""
    robot = Robot(gravity=[0, 0, 0])
    robot.AddLink(RobotLink(2, [0, 0, 0], np.eye(3), jointType="Px", name="mass", jointName="slide", **values))
    return robot


def test_dry_friction_takes_its_part_of_a_force():
    """(F - friction) t^2 / (2 m), but for the way in which friction grows below 0.01 m/s."""
    (x,) = moved(slider(friction=1.5), force=lambda *_: [4.0])
    assert x == pytest.approx((4 - 1.5) * 0.4**2 / 4, rel=1e-2)


def test_limits_are_stops():
    robot = slider(jointLimits=[-0.2, 0.1], damping=20.0)
    robot.referenceConfiguration = np.array([0.05])
    (x,) = moved(robot, 4.0, 4000, exu.DynamicSolverType.GeneralizedAlpha, lambda *_: [4.0], limitStiffness=1e4)
    assert x == pytest.approx(0.1 + 4 / 1e4, abs=1e-6)
    (free,) = moved(robot, 1.0, 1000, force=lambda *_: [4.0])
    assert free > 0.15


GRIPPER = """<robot name="gripper"><link name="palm"/>
<link name="left"><inertial><mass value="0.2"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
<link name="right"><inertial><mass value="0.3"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
<joint name="first" type="prismatic"><parent link="palm"/><child link="left"/><axis xyz="1 0 0"/><limit lower="0" upper="1"/></joint>
<joint name="second" type="prismatic"><parent link="palm"/><child link="right"/><axis xyz="-1 0 0"/><limit lower="0" upper="9"/>
<mimic joint="first" multiplier="2" offset="0.1"/></joint></robot>"""


def test_joints_that_follow_others(tmp_path):
    """x2 = 2 x1 + 0.1, so a force on the first moves the mass m1 + 4 m2."""
    (tmp_path / "gripper.urdf").write_text(GRIPPER)
    mbs = exu.SystemContainer().AddSystem()
    made = mbs.CreateRobot(
        tmp_path / "gripper.urdf",
        gravity=[0, 0, 0],
        referenceConfiguration=[0.05, 0],
        forceUserFunction=lambda *_: [3.0, 0.0],
    )
    np.testing.assert_allclose(made["robot"].referenceConfiguration, [0.05, 0.2])
    assert made["couplings"][0] is None
    mbs.Assemble()
    mbs.SolveDynamic(settings(0.2, 100))
    first, second = mbs.GetObjectOutput(made["objectKinematicTree"], exu.OutputVariableType.Coordinates)
    assert second == pytest.approx(2 * first + 0.1, abs=1e-12)
    assert first == pytest.approx(0.05 + 0.5 * 3 / (0.2 + 4 * 0.3) * 0.2**2, rel=1e-6)
    ground = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.CreateGround()))
    with pytest.raises(ValueError, match="link 1 'right' has a joint to follow, .* use CreateKinematicTree"):
        mbs.CreateRobot(tmp_path / "gripper.urdf", name="again ", baseMarker=ground)
    refused = {
        r"'limitStiffness': expected 0 with a baseMarker, .* received 1": {"baseMarker": ground, "limitStiffness": 1},
        r"'forceUserFunction': expected 0 with a baseMarker": {"baseMarker": ground, "forceUserFunction": max},
        r"'limitDamping': expected .* not negative, received -1": {"limitDamping": -1},
        r"'baseMarker': received 'ground', but no marker": {"baseMarker": "ground"},
        r"'baseHT': expected a 4x4 homogeneous transformation .* Its last row": {"baseHT": np.ones((4, 4))},
        r"'baseHT': .* determinant": {"baseHT": np.diag([1, 1, -1, 1])},
        r"'gravity': expected a vector with 3 .* received 9.81": {"gravity": 9.81},
        r"referenceConfiguration: expected a vector with 2": {"referenceConfiguration": [1, 2, 3]},
    }
    counts = mbs.systemData.NumberOfObjects(), mbs.systemData.NumberOfNodes()
    for text, arguments in refused.items():
        with pytest.raises(ValueError, match=f"(?s)CreateRobot.*{text}"):
            mbs.CreateRobot(tmp_path / "gripper.urdf", **arguments)
    assert counts == (mbs.systemData.NumberOfObjects(), mbs.systemData.NumberOfNodes())


def test_static_torques_hold_a_tree():
    robot = arbitrary(ALL_JOINTS, seed=6, branches=True)
    robot.referenceConfiguration = START
    held = -robot.StaticTorques(robot.JointHT(START))
    np.testing.assert_allclose(moved(robot, force=lambda *_: held), START, atol=1e-10)


def test_energy_of_a_robot_that_swings():
    """A system and the robot say the same energy, which stays."""
    robot = arbitrary(ALL_JOINTS, seed=3, branches=True)
    mbs = exu.SystemContainer().AddSystem()
    robot.CreateKinematicTree(mbs)
    mbs.Assemble()
    mbs.SolveDynamic(settings(0.4, 400), solverType=exu.DynamicSolverType.RK44)
    q, q_t = mbs.systemData.GetODE2Coordinates(), mbs.systemData.GetODE2Coordinates_t()
    kinetic, potential = robot.KineticEnergy(q, q_t), robot.PotentialEnergy(q)
    assert kinetic > 0.05
    assert kinetic + potential == pytest.approx(robot.PotentialEnergy(np.zeros(7)), abs=1e-9)


def test_links_of_a_tree_are_those_of_the_robot():
    robot = arbitrary(ALL_JOINTS, seed=3, branches=True)
    mbs = exu.SystemContainer().AddSystem()
    made = robot.CreateKinematicTree(mbs)
    mbs.SetNodeParameter(made["nodeGeneric"], "initialCoordinates", START)
    Variable, sensors = exu.OutputVariableType, {}
    for name in ("link2", "joint6"):
        place = {"objectNumber": made["objectKinematicTree"], "linkNumber": made["links"][name]}
        sensors[name] = mbs.AddSensor(
            SensorKinematicTree(**place, outputVariableType=Variable.Position, writeToFile=False)
        )
        mbs.AddMarker(MarkerKinematicTreeRigid(**place))
    mbs.Assemble()
    for name, sensor in sensors.items():
        wanted = robot.JointHT(START)[robot.GetLinkIndex(name)][:3, 3]
        np.testing.assert_allclose(mbs.GetSensorValues(sensor), wanted, atol=1e-14)


def test_robots_of_files_in_systems(tmp_path):
    """Results as a tree and as bodies: the same motion, names, and a base elsewhere."""
    text = (DATA / "arm.urdf").read_text().replace('friction="0.2"', "")
    (tmp_path / "arm.urdf").write_text(text)
    ends = []
    for bodies in (False, True):
        mbs = exu.SystemContainer().AddSystem()
        ground = mbs.CreateGround(referencePosition=[0, 0, 1])
        base = mbs.AddMarker(MarkerBodyRigid(bodyNumber=ground)) if bodies else None
        made = mbs.CreateRobot(
            tmp_path / "arm.urdf",
            name="arm ",
            baseHT=HTtranslate([0, 0, 1]),
            referenceConfiguration=[0.5, 0.1, 0.2],
            graphics=False,
            baseMarker=base,
        )
        assert made["links"] == {"column": 0, "yaw": 0, "slider": 1, "slide": 1, "wheel": 2}
        robot = made["robot"]
        assert (robot.NumberOfLinks(), robot.GetBaseHT()[2, 3]) == (3, 1)
        mbs.Assemble()
        mbs.SolveDynamic(settings(0.3, 600))
        if bodies:
            assert mbs.GetObject(made["bodyList"][1])["name"] == "arm slider"
            assert mbs.GetObject(made["jointList"][2])["name"] == "arm Joint:wheel"
            ends.append(mbs.GetObjectOutputBody(made["bodyList"][1], exu.OutputVariableType.Position))
        else:
            q = mbs.GetObjectOutput(made["objectKinematicTree"], exu.OutputVariableType.Coordinates)
            ends.append(robot.FrameHT("slider", np.asarray(q))[:3, 3])
    np.testing.assert_allclose(*ends, atol=2e-6)


def test_graphics_of_trees():
    """Bars on the links that carry others, joints, centres of mass, and the tool on the last link; the base on ground."""
    view = VRobotLink(linkColor=[1, 0, 0, 1])
    robot = Robot()
    robot.base.visualization = VRobotBase([graphics.Brick()])
    robot.tool.visualization.graphicsData = [graphics.Sphere(radius=0.1)]
    for T in (np.eye(4), HTtranslate([0, 0, 1])):
        robot.AddLink(RobotLink(1, [0, 0, 0.5], np.eye(3), preHT=T, visualization=view))
    mbs = exu.SystemContainer().AddSystem()
    made = robot.CreateKinematicTree(mbs)
    shapes = mbs.GetObjectParameter(made["objectKinematicTree"], "VgraphicsDataList")
    assert [len(parts) for parts in shapes] == [3, 3]
    assert len(mbs.GetObjectParameter(made["baseObject"], "VgraphicsData")) == 1
