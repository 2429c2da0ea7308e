"""Robots: recursions against each other and against derivatives, systems of bodies against coordinates of joints."""

from __future__ import annotations

import numpy as np
import pytest
from robots import ALL_JOINTS, arbitrary
from scipy.integrate import solve_ivp

import dalembert as exu
from dalembert import robotics
from dalembert.itemInterface import MarkerBodyRigid, MarkerNodePosition, SensorObject
from dalembert.rigidBodyUtilities import HTrotateX, HTrotateZ, HTtranslate
from dalembert.robotics import (
    InverseKinematicsNumerical,
    ModDHKK2HT,
    Robot,
    RobotBase,
    RobotLink,
    StdDH2HT,
    projectAngleToPMPi,
)


@pytest.fixture(params=[False, True], ids=["chain", "tree"])
def robot(request):
    return arbitrary(seed=3, branches=request.param)


@pytest.fixture
def state(robot):
    return np.random.default_rng(7).normal(size=(3, robot.NumberOfLinks()))


def derivative(function, x, direction, step=1e-5):
    return (function(x + step * direction) - function(x - step * direction)) / (2 * step)


# ---- kinematics -------------------------------------------------------------------------------------------------------


def test_denavit_hartenberg():
    """Products of the elementary transformations that the conventions are made of."""
    theta, d, a, alpha = 0.4, 0.2, 0.3, -0.7
    wanted = HTrotateZ(theta) @ HTtranslate([0, 0, d]) @ HTtranslate([a, 0, 0]) @ HTrotateX(alpha)
    np.testing.assert_allclose(StdDH2HT([theta, d, a, alpha]), wanted, atol=1e-15)
    before, after = ModDHKK2HT([alpha, a, theta, d])
    np.testing.assert_allclose(
        before @ after, HTrotateX(alpha) @ HTtranslate([a, 0, 0]) @ HTrotateZ(theta) @ HTtranslate([0, 0, d])
    )


def test_angles_are_projected_to_one_turn():
    np.testing.assert_allclose(
        projectAngleToPMPi([4, -4, np.pi, -np.pi, 0.5 + 6 * np.pi]), [4 - 2 * np.pi, 2 * np.pi - 4, np.pi, np.pi, 0.5]
    )
    assert projectAngleToPMPi(7.0) == pytest.approx(7 - 2 * np.pi)
    with pytest.raises(ValueError, match="projectAngleToPMPi: q0: expected an array of numbers"):
        projectAngleToPMPi("a")
    with pytest.raises(ValueError, match="VRobotLink: linkColor: expected a vector with 4 components"):
        robotics.VRobotLink(linkColor="red")
    with pytest.raises(ValueError, match="VRobotLink: graphicsData: expected a list of graphicsData"):
        robotics.VRobotLink(graphicsData=exu.graphics.Brick())


@pytest.mark.parametrize("link", [0, 3, "link6", "joint5"])
def test_jacobian_is_the_derivative_of_a_point(robot, state, link):
    q, q_t, _ = state
    local = np.array([0.1, -0.2, 0.3, 1.0])
    index = robot.GetLinkIndex(link)

    def pose(q):
        return robot.LinkHT(q)[index]

    T, T_t = pose(q), derivative(pose, q, q_t)
    J = robot.Jacobian(robot.JointHT(q), (T @ local)[:3], linkIndex=link)
    spin = T_t[:3, :3] @ T[:3, :3].T
    wanted = [*(T_t @ local)[:3], spin[2, 1], spin[0, 2], spin[1, 0]]
    np.testing.assert_allclose(J @ q_t, wanted, atol=1e-8)
    for mode, rows in (("trans", slice(0, 3)), ("rot", slice(3, 6))):
        np.testing.assert_array_equal(robot.Jacobian(robot.JointHT(q), (T @ local)[:3], mode, link), J[rows])


def test_centers_of_mass(robot, state):
    places = [T[:3, 3] for T in robot.COMHT(robot.JointHT(state[0]))]
    masses = [link.mass for link in robot.links]
    np.testing.assert_allclose(robot.CenterOfMass(state[0]), np.average(places, axis=0, weights=masses))


# ---- dynamics ---------------------------------------------------------------------------------------------------------


def test_two_recursions_agree(robot, state):
    """Newton and Euler in global vectors, composite bodies in spatial vectors (KinematicTree66)."""
    q, q_t, q_tt = state
    M, f = robot.GetKinematicTree66().ComputeMassMatrixAndForceTerms(q, q_t)
    np.testing.assert_allclose(robot.MassMatrix(q), M, atol=1e-12)
    np.testing.assert_allclose(robot.InverseDynamics(q, q_t, q_tt), M @ q_tt + f, atol=1e-12)
    assert robot.KineticEnergy(q, q_t) == pytest.approx(0.5 * q_t @ M @ q_t)


def test_static_torques_are_those_of_the_weight(robot, state):
    q = state[0]
    gradient = [derivative(robot.PotentialEnergy, q, axis) for axis in np.eye(len(q))]
    np.testing.assert_allclose(robot.StaticTorques(robot.JointHT(q)), -np.array(gradient), atol=1e-9)
    np.testing.assert_allclose(robot.InverseDynamics(q, 0 * q, 0 * q), gradient, atol=1e-9)


@pytest.mark.parametrize("values", [{}, {"damping": 0.3, "friction": 0.2, "rotorInertia": 0.4}])
def test_drives_give_the_power_that_energy_and_resistance_take(state, values):
    robot = arbitrary(seed=3, **values)
    q, q_t, q_tt = state

    def energy(t):
        moved, rate = q + t * q_t + 0.5 * t**2 * q_tt, q_t + t * q_tt
        return robot.KineticEnergy(moved, rate) + robot.PotentialEnergy(moved)

    power = q_t @ (robot.InverseDynamics(q, q_t, q_tt) - robot.JointResistance(q_t))
    assert power == pytest.approx(derivative(energy, 0.0, 1.0), rel=1e-7)


@pytest.mark.parametrize("values", [{}, {"damping": 0.3, "friction": 0.2, "rotorInertia": 0.4}])
@pytest.mark.parametrize("branches", [False, True])
@pytest.mark.parametrize("seed", range(3))
def test_forward_dynamics_is_the_inverse_of_inverse_dynamics(seed, branches, values):
    robot = arbitrary(seed=seed, branches=branches, **values)
    q, q_t, q_tt = np.random.default_rng(seed).normal(size=(3, 7))
    torques = robot.InverseDynamics(q, q_t, q_tt)
    np.testing.assert_allclose(robot.ForwardDynamics(q, q_t, torques), q_tt, atol=1e-12)


def test_many_states_at_once(robot):
    q, q_t, q_tt = np.random.default_rng(1).normal(size=(3, 4, 5, 7))
    one = (2, 3)
    together = {
        "InverseDynamics": (q, q_t, q_tt),
        "ForwardDynamics": (q, q_t, q_tt),
        "MassMatrix": (q,),
        "KineticEnergy": (q, q_t),
        "PotentialEnergy": (q,),
        "CenterOfMass": (q,),
        "JointResistance": (q_t,),
    }
    for name, arguments in together.items():
        function = getattr(robot, name)
        alone = function(*(argument[one] for argument in arguments))
        np.testing.assert_allclose(function(*arguments)[one], alone, atol=1e-12, err_msg=name)
    np.testing.assert_allclose(robot.LinkHT(q)[4][one], robot.LinkHT(q[one])[4])
    np.testing.assert_allclose(robot.Jacobian(robot.JointHT(q))[one], robot.Jacobian(robot.JointHT(q[one])))


# ---- redundant coordinates --------------------------------------------------------------------------------------------


def angles_by_bodies(robot, duration, step):
    """Return the coordinates of the joints after the motion of bodies that joints and spring dampers hold."""
    mbs = exu.SystemContainer().AddSystem()
    base = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.CreateGround(referencePosition=robot.base.HT[:3, 3])))
    items = robot.CreateRedundantCoordinateMBS(mbs, base)
    Variable = exu.OutputVariableType
    sensors = []
    for link, drive in zip(robot.links, items["springDamperList"], strict=True):
        what = Variable.Rotation if link.jointType[0] == "R" else Variable.DisplacementLocal
        sensors.append(mbs.AddSensor(SensorObject(objectNumber=drive, outputVariableType=what, writeToFile=False)))
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = round(duration / step)
    settings.timeIntegration.endTime = duration
    settings.timeIntegration.generalizedAlpha.spectralRadius = 0.9
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveDynamic(settings)
    return np.array([float(mbs.GetSensorValues(sensor)) for sensor in sensors])


@pytest.mark.parametrize("branches", [False, True], ids=["chain", "tree"])
def test_bodies_and_joints_move_as_coordinates_of_joints_do(branches):
    """All joint types, drives, damping and smooth friction; the error falls with the square of the step."""
    robot = arbitrary(
        ("Rx", "Py", "Ry", "Rz", "Px", "Pz"), seed=2, branches=branches, damping=0.5, PDcontrol=(30.0, 1.0)
    )
    start = np.array([0.3, -0.2, 0.5, -0.4, 0.1, 0.2])
    robot.referenceConfiguration = start
    duration = 0.5

    def rates(t, y):
        q, q_t = y.reshape(2, -1)
        return np.concatenate([q_t, robot.ForwardDynamics(q, q_t, -30.0 * q - 1.0 * q_t)])

    wanted = solve_ivp(rates, (0, duration), [*start, *np.zeros(6)], rtol=1e-10, atol=1e-12).y[:6, -1]
    assert np.abs(wanted - start).max() > 0.1
    coarse, fine = (np.abs(angles_by_bodies(robot, duration, h) - wanted).max() for h in (4e-3, 2e-3))
    assert fine < 5e-5
    assert coarse / fine == pytest.approx(4, rel=0.1)


def test_loads_and_markers_of_joints():
    """Data that drives need: a load on each side, in directions that are given; forces on the rotated axes of
    joints."""
    robot = arbitrary(("Rx", "Pz"), seed=4)
    mbs = exu.SystemContainer().AddSystem()
    base = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.CreateGround(referencePosition=robot.base.HT[:3, 3])))
    items = robot.CreateRedundantCoordinateMBS(mbs, base)
    assert [mbs.GetLoad(n)["loadType"] for n in items["jointTorque1List"]] == ["TorqueVector", "ForceVector"]
    assert items["springDamperList"] == [None, None]
    for i, (link, T) in enumerate(zip(robot.links, robot.JointHT([0, 0]), strict=True)):
        axis = T[:3, "xyz".index(link.jointType[1])]
        np.testing.assert_allclose(robot.LinkHT([0, 0])[i][:3, :3] @ items["unitTorque1List"][i], axis, atol=1e-15)
    only = robot.CreateRedundantCoordinateMBS(mbs, base, createJointTorqueLoads=False, name="second ")
    assert only["jointTorque0List"] == [None, None]
    assert mbs.GetObject(only["bodyList"][1])["name"] == "second link1"


def test_static_torques_hold_bodies_at_rest():
    robot = arbitrary(("Rz", "Py", "Rx"), seed=5)
    robot.referenceConfiguration = np.array([0.4, 0.1, -0.6])
    mbs = exu.SystemContainer().AddSystem()
    base = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.CreateGround(referencePosition=robot.base.HT[:3, 3])))
    items = robot.CreateRedundantCoordinateMBS(mbs, base)
    held = -robot.StaticTorques(robot.JointHT(robot.referenceConfiguration))
    for side in "01":
        for load, unit, value in zip(
            items[f"jointTorque{side}List"], items[f"unitTorque{side}List"], held, strict=True
        ):
            mbs.SetLoadParameter(load, "loadVector", value * unit)
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = 10
    settings.timeIntegration.endTime = 0.1
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveDynamic(settings)
    assert np.abs(mbs.systemData.GetODE2Coordinates_t()).max() < 1e-9


# ---- inverse kinematics -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("joints", [("Rz", "Ry", "Ry", "Rz", "Ry", "Rz"), ALL_JOINTS], ids=["six", "seven"])
def test_inverse_kinematics_finds_poses(joints):
    robot = arbitrary(joints, seed=5)
    solver = InverseKinematicsNumerical(robot)
    rng = np.random.default_rng(2)
    for _ in range(10):
        goal = robot.FrameHT("tool", rng.uniform(-1.5, 1.5, len(joints)))
        q, success = solver.SolveSafe(goal)
        assert success
        np.testing.assert_allclose(robot.FrameHT("tool", q), goal, atol=1e-9)
        np.testing.assert_allclose(solver.GetCurrentRobotHT(), goal, atol=1e-9)


def test_a_redundant_robot_moves_as_little_as_it_can():
    """The energy of springs in the joints has no slope along motions that keep the pose."""
    robot = arbitrary(seed=5)
    stiffness = np.linspace(1, 4, 7)
    start = np.full(7, 0.2)
    goal = robot.FrameHT("tool", start + np.linspace(-0.3, 0.4, 7))
    q, success = InverseKinematicsNumerical(robot, stiffness).Solve(goal, start)
    assert success
    J = robot.Jacobian(robot.JointHT(q), robot.FrameHT("tool", q)[:3, 3])
    free = np.linalg.svd(J)[2][-1]
    assert abs(free @ (stiffness * (q - start))) < 1e-6


def test_inverse_kinematics_keeps_limits():
    robot = arbitrary(("Rz", "Ry", "Ry", "Rz", "Ry", "Rz", "Rx"), seed=5)
    inside = np.array([0.3, -0.4, 0.5, 0.2, -0.3, 0.4, 0.1])
    goal = robot.FrameHT("tool", inside)
    free, _ = InverseKinematicsNumerical(robot).Solve(goal)
    for link, value in zip(robot.links, inside, strict=True):
        link.jointLimits = np.array([value - 0.02, value + 0.02])
    assert np.abs(free - inside).max() > 0.02
    q, success = InverseKinematicsNumerical(robot, limits=True).Solve(goal)
    assert success and np.abs(q - inside).max() <= 0.02
    assert InverseKinematicsNumerical(robot, limits=True).Solve(goal @ HTtranslate([3, 0, 0])) == [None, False]


def test_poses_between_poses():
    robot = arbitrary(seed=5)
    solver = InverseKinematicsNumerical(robot)
    T1, T2 = HTtranslate([1, 0, 0]), HTtranslate([2, 1, 0]) @ HTrotateZ(1.0)
    between = solver.InterpolateHTs(T1, T2, rotStep=0.3)
    assert len(between) == 4
    np.testing.assert_allclose(between[1], HTtranslate([1.5, 0.5, 0]) @ HTrotateZ(0.5), atol=1e-15)
    np.testing.assert_array_equal(between[-1], T2)


# ---- rejected arguments
# -------------------------------------------------------------------------------------------------


def test_invalid_robots_are_rejected():
    body = {"mass": 1, "COM": [0, 0, 0], "inertia": np.eye(3)}
    with pytest.raises(
        ValueError, match=r"RobotLink: jointType: expected one of Rx, Ry, Rz, Px, Py, Pz, received 'Ra'"
    ):
        RobotLink(**body, jointType="Ra")
    with pytest.raises(ValueError, match="RobotLink: mass: expected a finite number that is not negative, received -1"):
        RobotLink(**body | {"mass": -1})
    with pytest.raises(ValueError, match="RobotLink: mass: expected a finite number .*, received '1'"):
        RobotLink(**body | {"mass": "1"})
    with pytest.raises(ValueError, match="RobotLink: PDcontrol: expected two numbers, received 5"):
        RobotLink(**body, PDcontrol=5)
    with pytest.raises(TypeError, match="CreateKinematicTree: mbs: received None, but expected a MainSystem"):
        Robot().CreateKinematicTree(None)
    with pytest.raises(ValueError, match="RobotLink: jointLimits: expected .* lower <= upper"):
        RobotLink(**body, jointLimits=[1, 0])
    with pytest.raises(ValueError, match="RobotLink 'arm': there is no PDcontrol; set it by SetPDcontrol"):
        RobotLink(**body, name="arm").GetPDcontrol()
    robot = Robot()
    robot.AddLink(RobotLink(**body, name="arm", jointName="shoulder"))
    with pytest.raises(ValueError, match="AddLink: name: there is another 'arm' already"):
        robot.AddLink(RobotLink(**body, name="arm"))
    with pytest.raises(ValueError, match="link 1: expected a parent from -1 .base. to 0, .* received 4"):
        robot.AddLink(RobotLink(**body, parent=4))
    with pytest.raises(ValueError, match="there is no link or joint 'hand'; there are: shoulder, arm"):
        robot.GetLink("hand")
    with pytest.raises(ValueError, match="there is no joint 'arm'; there are: shoulder"):
        robot.GetJointIndex("arm")
    with pytest.raises(ValueError, match="Robot: q: expected 1 numbers, one per link"):
        robot.JointHT([1, 2])
    robot.AddLink(RobotLink(**body | {"mass": 0}))
    mbs = exu.SystemContainer().AddSystem()
    base = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.CreateGround()))
    with pytest.raises(ValueError, match="link 1 '' has no mass, .* use CreateKinematicTree"):
        robot.CreateRedundantCoordinateMBS(mbs, base)
    robot.links[1].mass, robot.links[0].preHT[0, 3] = 1, 0.5
    node = mbs.CreateMassPoint(physicsMass=1, returnDict=True)["nodeNumber"]
    point = mbs.AddMarker(MarkerNodePosition(nodeNumber=node))
    with pytest.raises(ValueError, match="needs a MarkerBodyRigid, received a marker of type NodePosition"):
        robot.CreateRedundantCoordinateMBS(mbs, point)
    with pytest.raises(ValueError, match="RobotLink 'arm': there is no PDcontrol"):
        robot.CreateRedundantCoordinateMBS(mbs, base, jointSpringDamperUserFunctionList=[0])
    robot.links[1].follows = ("elbow", 1.0, 0.0)
    with pytest.raises(ValueError, match="there is no joint 'elbow'; there are: shoulder"):
        robot.CreateKinematicTree(mbs)
    assert (mbs.systemData.NumberOfObjects(), mbs.systemData.NumberOfNodes()) == (2, 1)  # ground and mass point


def test_robots_do_not_share_their_parts():
    one, other = Robot(), Robot()
    one.base.HT[0, 3] = 1
    assert other.base.HT[0, 3] == 0
    link = RobotLink(1, [0, 0, 0], np.eye(3))
    one.AddLink(link)
    one.links[0].mass = 2
    assert link.mass == 1 and "mass = 2" in repr(one)


def test_dictionaries_of_old_models():
    robot = Robot()
    links = [{"stdDH": [0, 0.1, 0.2, 0.3], "mass": 1, "COM": [0, 0, 0], "inertia": np.eye(3)}]
    with pytest.warns(UserWarning, match="use robotics.models.LinkDict2Robot"):
        robot.BuildFromDictionary({"links": links, "gravity": [0, 0, -1], "tool": {"HT": HTtranslate([0, 0, 1])}})
    np.testing.assert_allclose(robot.LinkHT([0.0])[0], StdDH2HT([0, 0.1, 0.2, 0.3]))
    assert robot.gravity[2] == -1 and robot.GetToolHT()[2, 3] == 1


def test_drawn_links():
    robot = arbitrary(("Rz", "Ry"), seed=1)
    parts = robot.GetLinkGraphicsData(0, [0, 0, 0], [1, 0, 0], [0, 0, 1], [0, 1, 0], robotics.VRobotLink())
    assert len(parts) == 3  # centre of mass, next joint, bar
    base = Robot(base=RobotBase(visualization=robotics.VRobotBase(parts)))
    mbs = exu.SystemContainer().AddSystem()
    base.AddLink(RobotLink(1, [0, 0, 0], np.eye(3)))
    ground = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.CreateGround()))
    assert int(base.CreateRedundantCoordinateMBS(mbs, ground)["baseObject"]) == 1


def test_transformations_of_parts():
    """Parts take exu.HT, a matrix, or None for the unit matrix."""
    HT = exu.HT(translation=[1, 2, 3])
    for make in (robotics.RobotTool, robotics.RobotBase):
        np.testing.assert_array_equal(make(HT=HT).HT, np.array(HT))
        np.testing.assert_array_equal(make().HT, np.eye(4))
        np.testing.assert_array_equal(make(HT=None).HT, np.eye(4))
    link = RobotLink(1, [0, 0, 0], np.eye(3), localHT=None, preHT=HT)
    np.testing.assert_array_equal([link.localHT, link.preHT], [np.eye(4), np.array(HT)])


def test_transformations_are_HT():
    """Results are exu.HT; attributes of parts are, too, and changes of their entries change the robot."""
    robot = arbitrary(seed=2)
    q = np.linspace(0.1, 0.7, robot.NumberOfLinks())
    HT = robot.JointHT(q)
    assert robot.JointHT(q) == HT
    for T in (*HT, *robot.LinkHT(q), *robot.COMHT(HT), robot.GetBaseHT(), robot.GetToolHT(), robot.FrameHT("tool", q)):
        assert isinstance(T, exu.HT)
    for T in (robotics.StdDH2HT([1, 2, 3, 4]), *robotics.ModDHKK2HT([1, 2, 3, 4])):
        assert isinstance(T, exu.HT)
    np.testing.assert_allclose(robot.Jacobian(HT), robot.Jacobian([np.array(T) for T in HT]), atol=1e-15)
    robot.base.HT[0:3, 3] += [1, 2, 3]
    np.testing.assert_allclose(robot.JointHT(q)[-1].translation, HT[-1].translation + [1, 2, 3], atol=1e-14)
    robot.links[0].localHT = exu.HT(translation=[0, 0, 1])
    assert robot.links[0].localHT.translation.tolist() == [0, 0, 1]
    with pytest.raises(ValueError, match="RobotBase: HT"):
        robot.base.HT = np.zeros((4, 4))
