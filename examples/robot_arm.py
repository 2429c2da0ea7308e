"""A robot arm with three joints that follow prescribed motions: it lifts a load and turns it to its other side.

Column, upper arm and forearm are connected by motors, which are joints with prescribed angles. Forward kinematics gives
the position of the hand. The arm starts and ends at rest, so the work of its motors is the change of potential energy.
"""

import numpy as np

import dalembert as exu
from dalembert.utilities import *

column, upper, fore, width = 0.5, 0.6, 0.5, 0.08  # m
payload, g, duration = 5.0, 9.81, 2.0  # kg, m/s^2, s
start, end = (
    np.radians([0, -20, -60]),
    np.radians([120, 60, -40]),
)  # about z, and up from the horizontal and the upper arm
Variable = exu.OutputVariableType


def smooth(t):
    """A step from 0 to 1 with zero rates and accelerations at both ends; and its rate."""
    s = min(t / duration, 1)
    return s**3 * (10 - 15 * s + 6 * s**2), 30 * s**2 * (1 - s) ** 2 / duration


def places(angles):
    """Forward kinematics: elbow and hand."""
    yaw, shoulder, elbow = angles
    radial = np.array([np.cos(yaw), np.sin(yaw), 0])

    def along(length, pitch):
        return length * (np.cos(pitch) * radial + np.sin(pitch) * np.array([0, 0, 1]))

    knee = np.array([0, 0, column]) + along(upper, shoulder)
    return knee, knee + along(fore, shoulder + elbow)


def motor(k):
    """The angle of joint k against its start, about the third axis of the joint, as a user function."""
    return lambda mbs, t, itemNumber, parameters: [0, 0, 0, 0, 0, smooth(t)[0] * (end[k] - start[k])]


mbs = exu.SystemContainer().AddSystem()
ground = mbs.CreateGround(graphicsDataList=[graphics.CheckerBoard(size=1.6, nTiles=8)])
elbow, hand = places(start)
shoulder = np.array([0, 0, column])
pitch = RotationMatrixY(-start[1]), RotationMatrixY(-start[1] - start[2])
bar = {"density": 1500}
tube = [InertiaCuboid(**bar, sideLengths=[length, width, width]) for length in (upper, fore)]
load = InertiaSphere(payload, 0.05).Translated([fore / 2, 0, 0])
links = [
    (shoulder / 2, np.eye(3), InertiaCylinder(**bar, length=column, outerRadius=width, axis=2)),
    ((shoulder + elbow) / 2, pitch[0], tube[0]),
    ((elbow + hand) / 2, pitch[1], tube[1] + load),
]
shapes = [
    [graphics.Cylinder([0, 0, -column / 2], [0, 0, column], width, color=graphics.color.lightgrey, nTiles=48)],
    [graphics.RigidLink([-upper / 2, 0, 0], [upper / 2, 0, 0], [0, 1, 0], [0, 1, 0], [width] * 2, width,
                        [2 * width] * 2, color=graphics.color.orange, nTiles=48)],
    [graphics.RigidLink([-fore / 2, 0, 0], [fore / 2, 0, 0], [0, 1, 0], [0, 0, 0], [0.06, 0], 0.07, [0.14, 0.0],
                        color=graphics.color.orange, nTiles=48),
     graphics.Sphere([fore / 2, 0, 0], radius=0.07, color=graphics.color.darkgrey2, nTiles=32)],
]  # fmt: skip
bodies = [ground] + [
    mbs.CreateRigidBody(
        referencePosition=p, referenceRotationMatrix=A, inertia=inertia, gravity=[0, 0, -g], graphicsDataList=shape
    )
    for (p, A, inertia), shape in zip(links, shapes, strict=True)
]
upwards = RotationMatrixX(np.pi / 2)  # its third axis is -y: arms turn upwards
joints = [
    mbs.CreateGenericJoint(
        bodyNumbers=bodies[k : k + 2], position=place, rotationMatrixAxes=axes, offsetUserFunction=motor(k)
    )
    for k, (place, axes) in enumerate([([0, 0, 0], np.eye(3)), (shoulder, upwards), (elbow, upwards)])
]
torques = [
    mbs.AddSensor(SensorObject(objectNumber=joint, outputVariableType=Variable.TorqueLocal, storeInternal=True))
    for joint in joints
]
tip = mbs.AddSensor(
    SensorBody(
        bodyNumber=bodies[3], localPosition=[fore / 2, 0, 0], outputVariableType=Variable.Position, storeInternal=True
    )
)
mbs.Assemble()

settings = exu.SimulationSettings()
settings.timeIntegration.endTime = duration
settings.timeIntegration.numberOfSteps = 2000
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.8
settings.solutionSettings.solutionWritePeriod = settings.timeIntegration.endTime / 60
settings.solutionSettings.sensorsWritePeriod = duration / 2000
mbs.SolveDynamic(settings)
mbs.Draw(fileName="robot_picture.png")
in_a_second = settings.timeIntegration.endTime / 3
mbs.DrawSolution(fileName="robot_motion.gif", windowSize=[420, 320], framesPerSecond=20, speed=in_a_second)

names = ["column", "shoulder", "elbow"]
mbs.PlotSensor(
    torques,
    components=[2] * 3,
    labels=names,
    yLabel="torque of the motor (Nm)",
    fileName="robot_torques.png",
    closeAll=True,
)
mbs.PlotSensor(tip, components=[0, 1, 2], yLabel="position of the hand (m)", fileName="robot_hand.png")

halfway = len(mbs.GetSensorStoredData(tip)) // 2
time, *reached = mbs.GetSensorStoredData(tip)[halfway]
_, wanted = places(start + smooth(time)[0] * (end - start))
for name, is_at, should in zip("xyz", reached, wanted, strict=True):
    print(f"hand halfway, {name}: {is_at:.6f} m, forward kinematics {should:.6f} m")

t = mbs.GetSensorStoredData(torques[0])[:, 0]
rates = np.array([smooth(time)[1] for time in t])
# the third multiplier of a locked joint is the torque about -z
work = sum(np.trapezoid(mbs.GetSensorStoredData(torques[k])[:, 3] * rates, t) * (end[k] - start[k]) for k in range(3))


def potential(angles):
    knee, hand = places(angles)
    return g * (tube[0].mass * (column + knee[2]) / 2 + tube[1].mass * (knee[2] + hand[2]) / 2 + payload * hand[2])


print(f"work of the motors: {work:.4f} J, gain of height {potential(end) - potential(start):.4f} J")
