"""Mecanum wheels: kinematics, the shape of rollers, and a platform that goes where its wheels say."""

from __future__ import annotations

import numpy as np
import pytest

import dalembert as exu
from dalembert.itemInterface import MarkerBodyRigid, NodeGenericData, SensorBody, TorsionalSpringDamper
from dalembert.rigidBodyUtilities import HTtranslate
from dalembert.robotics.mobile import (
    FunDDiffPoly,
    FunDiffPoly,
    Generatrix2Polynomial,
    GeneratrixRoll,
    MecanumWheelVelocity2XYphi,
    MecanumXYphi2WheelVelocities,
    MobileKinematics,
    MobileRobot2MBS,
)

R, BASE, TRACK = 0.0762, 0.4, 0.39


def platform(**changes):
    return {
        "gravity": [0, 0, -9.81],
        "platformDimensions": [0.5, 0.7, 0.216],
        "platformMass": 42.5,
        "platformInitialPose": HTtranslate([0, 0, 0.1532]),
        "platformInitialOmega": [0, 0, 0],
        "platformInitialVelocity": [0, 0, 0],
        "platformCOM": [0, 0, 0],
        "platformRepresentation": "box",
        "wheelType": 0,
        "friction": [1.0, 0.0, 0.0],
        "frictionAngle": np.pi / 4,
        "wheelBase": BASE,
        "wheelTrack": TRACK,
        "wheelRadius": R,
        "wheelWidth": 0.076,
        "wheelMass": 2.406,
        "wheelNumbers": 4,
        "serialRobotMountpoint": HTtranslate([0.211, 0, -0.105]),
        "debugOffset": 0,
        "wheelContactStiffness": 5e4,
        "wheelContactDamping": 5e2,
        "viscousFrictionWheel": [0, 0],
        "proportionalZone": 0.005,
    } | changes


@pytest.mark.parametrize(("wheeltype", "adjusted"), [(0, False), (1, False), (0, True)])
def test_velocities_there_and_back(wheeltype, adjusted):
    kinematics = MobileKinematics(R, 0.2, 0.13, adjusted, 0.02, 0.01, wheeltype)
    wanted = np.random.default_rng(0).normal(size=(5, 3))
    wheels = kinematics.GetWheelVelocities(wanted)
    assert wheels.shape == (5, 4)
    np.testing.assert_allclose(kinematics.GetWheelVelocities(wanted.T), wheels)
    np.testing.assert_allclose(kinematics.GetWheelVelocities(wanted[2]), wheels[2])
    np.testing.assert_allclose(kinematics.GetCartesianVelocities(wheels), wanted, atol=1e-13)


def test_wheels_forward_sideways_and_turning():
    """v / R forward; wheels of a diagonal rotate equally in sideways motion; turning, those of a side, by (lx + ly) /
    R."""
    kinematics = MobileKinematics(R, BASE / 2, TRACK / 2)
    arm = (BASE + TRACK) / 2
    np.testing.assert_allclose(kinematics.GetWheelVelocities([R, 0, 0]), [1, 1, 1, 1])
    np.testing.assert_allclose(kinematics.GetWheelVelocities([0, R, 0]), [-1, 1, 1, -1])
    np.testing.assert_allclose(kinematics.GetWheelVelocities([0, 0, R / arm]), [-1, 1, -1, 1])
    velocity = 0.3, -0.2, 0.5
    wheels = MecanumXYphi2WheelVelocities(*velocity, R, BASE, TRACK, 0)
    np.testing.assert_allclose(wheels, kinematics.GetWheelVelocities(velocity))
    np.testing.assert_allclose(MecanumWheelVelocity2XYphi(wheels, R, BASE, TRACK, 0), velocity)
    with pytest.raises(ValueError, match="wheeltype: expected 0 .O-configuration. or 1 .X-configuration., received 2"):
        MobileKinematics(R, 1, 1, wheeltype=2)
    with pytest.raises(ValueError, match="vDes: expected 3 numbers, or rows of 3"):
        kinematics.GetWheelVelocities([1, 2])


def test_rollers_complete_the_wheel():
    """The lowest point of a roller touches the ground: points of its surface are at most R from the axle of the
    wheel."""
    delta, d = np.pi / 4, 0.75 * R
    roller = {"r": R, "lRoll": 0.076, "delta": delta, "rRoll": 0.25 * R, "dRoll": d}
    x, y = GeneratrixRoll(np.linspace(-0.6, 0.6, 13), roller)
    angle = np.linspace(-np.pi, np.pi, 4001)[:, None]
    across, down = y * np.sin(angle), d + y * np.cos(angle)
    distance = np.hypot(x * np.sin(delta) + across * np.cos(delta), down)
    np.testing.assert_allclose(distance.max(axis=0), R, rtol=1e-6)
    Generatrix2Polynomial(roller, GeneratrixRoll, tol=1e-8)
    inside = np.abs(x) < 0.5 * roller["lRoll"]
    np.testing.assert_allclose(np.polyval(roller["aPoly"], x[inside]), y[inside], atol=1e-8)
    assert roller["xBoundary"] == [-0.038, 0.038] and roller["dyBoundary"][0] == pytest.approx(-roller["dyBoundary"][1])
    with pytest.warns(UserWarning, match="the error .* m is above tol=1e-30"):
        Generatrix2Polynomial(roller, GeneratrixRoll, tol=1e-30)


def test_derivatives_of_polynomials():
    assert FunDiffPoly(2.0, [3, 4, 5, 6]) == 3 * 3 * 4 + 2 * 4 * 2 + 5
    assert FunDDiffPoly(2.0, [3, 4, 5, 6]) == 6 * 3 * 2 + 2 * 4


@pytest.mark.parametrize("velocity", [[0.2, 0, 0], [0, 0.15, 0], [0, 0, 0.4], [0.1, -0.1, 0.2]])
def test_platform_goes_where_its_wheels_say(velocity):
    """Wheels that drives keep at the speeds of MobileKinematics; friction slips by a part of its proportional zone."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.CreateGround()))
    made = MobileRobot2MBS(mbs, platform(), ground, flagGraphicsRollers=False)
    speeds = MobileKinematics(R, BASE / 2, TRACK / 2).GetWheelVelocities(velocity)
    for joint, speed in zip(made["oAxlesList"], speeds, strict=True):
        axle = mbs.GetObject(joint)
        turns = mbs.AddNode(NodeGenericData(initialCoordinates=[0], numberOfDataCoordinates=1))
        same = {name: axle[name] for name in ("markerNumbers", "rotationMarker0", "rotationMarker1")}
        mbs.AddObject(TorsionalSpringDamper(**same, nodeNumber=turns, damping=5.0, velocityOffset=speed))
    Variable = exu.OutputVariableType
    sensors = [
        mbs.AddSensor(SensorBody(bodyNumber=made["bPlatformList"][0], outputVariableType=what, writeToFile=False))
        for what in (Variable.VelocityLocal, Variable.AngularVelocityLocal)
    ]
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime = 1.0
    settings.timeIntegration.numberOfSteps = 500
    settings.timeIntegration.generalizedAlpha.spectralRadius = 0.5
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveDynamic(settings)
    linear, angular = (mbs.GetSensorValues(sensor) for sensor in sensors)
    np.testing.assert_allclose([linear[0], linear[1], angular[2]], velocity, atol=4e-3)


@pytest.mark.parametrize("rollers", [False, True])
def test_created_items(rollers, tmp_path):
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.CreateGround()))
    robot = platform(wheelType=1, debugOffset=-1e-4)
    made = MobileRobot2MBS(mbs, robot, ground, rollers)
    assert {name: len(items) for name, items in made.items() if name.startswith(("nW", "bW", "mW", "o"))} == {
        "oPlatformList": 1, "nWheelsList": 4, "bWheelsList": 4, "mWheelsList": 4, "oAxlesList": 4, "oRollingDiscsList": 4,
    }  # fmt: skip
    angles = [mbs.GetObject(n)["dryFrictionAngle"] for n in made["oRollingDiscsList"]]
    np.testing.assert_allclose(angles, np.array([-1, 1, 1, -1]) * np.pi / 4)
    assert mbs.variables["mobileRobot"] is robot and robot["platformInitialPose"][2, 3] == 0.1532
    total = sum(mbs.GetObject(n)["physicsMass"] for n in (*made["bPlatformList"], *made["bWheelsList"]))
    assert total == pytest.approx(robot["platformMass"])
    mbs.Assemble()
    exu.graphics.ExportSTL(exu.graphics.Brick(), str(tmp_path / "shape.stl"))
    shape = {"platformRepresentation": "stl", "platformStlFile": str(tmp_path / "shape.stl"), "wheelType": 2}
    other = exu.SystemContainer().AddSystem()
    ground = other.AddMarker(MarkerBodyRigid(bodyNumber=other.CreateGround()))
    still = MobileRobot2MBS(other, platform(**shape), ground, rollers)
    assert [other.GetObject(n)["dryFrictionAngle"] for n in still["oRollingDiscsList"]] == [0] * 4
    with pytest.raises(ValueError, match="mobileRobot: there is no 'wheelBase', 'friction'"):
        MobileRobot2MBS(mbs, {k: v for k, v in platform().items() if k not in ("friction", "wheelBase")}, ground)
