"""A quadruped trots: a kinematic tree that floats on six virtual joints and stands on the ground by friction alone.

Diagonal legs step together. The joint drives track the positions of the feet relative to their hips; the legs on the
ground share the weight, by
torques from the transposed Jacobians of their feet. The controller updates set values and torques every 2 ms. The
balance of momentum gives the ground force: its mean over whole periods of a steady gait is the weight.
"""

import numpy as np

import dalembert as exu
from dalembert.robotics import Robot, RobotLink, VRobotLink
from dalembert.treeDynamics import TreeDynamics
from dalembert.utilities import *

thigh, shank, foot, stance = 0.2, 0.2, 0.02, 0.28  # lengths of the legs, radius of feet, height of hips over feet (m)
length, width, trunk_mass, masses, g = 0.38, 0.22, 6, (0.5, 0.8, 0.2), 9.81  # m, kg, m/s^2
period, speed, lift = 0.4, 0.4, 0.05  # s, m/s, m
start, sample, end = 0.4, 0.002, 4.4  # s: a pause, then ten periods
stiffness, damping = 200, 5  # of the drives: Nm/rad, Nms/rad
hips = {
    f"{x} {y}": (i * length / 2, j * width / 2)
    for x, i in (("front", 1), ("hind", -1))
    for y, j in (("left", 1), ("right", -1))
}
phases = [0.25, 0.75, 0.75, 0.25]  # phases of the legs, in periods; the foot is on the ground in the first half

# robot
robot = Robot(gravity=[0, 0, -g])
nothing, hidden = np.zeros((3, 3)), VRobotLink(showMBSjoint=False, showCOM=False, linkWidth=0)
for joint in ("Px", "Py", "Pz", "Rz", "Ry"):
    robot.AddLink(RobotLink(mass=0, COM=[0, 0, 0], inertia=nothing, jointType=joint, visualization=hidden))


def drawn(*graphics):
    return VRobotLink(showMBSjoint=False, showCOM=False, graphicsData=list(graphics))


def bar(size, radius, color):
    return exu.graphics.Cylinder([0, 0, -size], [0, 0, size], radius, color)


dark, bright = exu.graphics.color.darkgrey, exu.graphics.color.orange
trunk = drawn(exu.graphics.Brick(size=[length + 0.1, width - 0.06, 0.1], color=bright))
robot.AddLink(
    RobotLink(trunk_mass, [0, 0, 0], np.diag([0.02, 0.07, 0.08]), jointType="Rx", name="trunk", visualization=trunk)
)
tip_of_leg = exu.graphics.Sphere([0, 0, -shank], foot, dark)
for leg, (x, y) in hips.items():
    parts = [  # joint, place in the frame of the link before, centre of mass (m), inertia (kg m^2), graphics
        ("hip", "Rx", [x, y, 0], 0, 5e-4, drawn(exu.graphics.Sphere(radius=0.04, color=dark))),
        ("thigh", "Ry", [0, 0, 0], -0.04, 2.7e-3, drawn(bar(thigh, 0.02, dark))),
        ("shank", "Ry", [0, 0, -thigh], -0.1, 7e-4, drawn(bar(shank, 0.012, bright), tip_of_leg)),
    ]  # fmt: skip
    parent = "trunk"
    for mass, (part, joint, place, com, inertia, graphics) in zip(masses, parts, strict=True):
        link = RobotLink(
            mass, [0, 0, com], inertia * np.diag([1, 1, 0.1]), jointType=joint, parent=parent, name=f"{leg} {part}",
            preHT=HTtranslate(place), PDcontrol=(stiffness, damping), visualization=graphics,
        )  # fmt: skip
        robot.AddLink(link)
        parent = link.name
weight = g * (trunk_mass + 4 * sum(masses))
of_legs = np.arange(6, 18).reshape(4, 3)  # coordinates


# gait
def leg_angles(x, z):
    """Angles of hip, thigh and shank for a foot that is x before and z above the point below its hip."""
    down = stance - z
    knee = -np.arccos((x**2 + down**2 - thigh**2 - shank**2) / (2 * thigh * shank))
    return [0, -np.arctan2(x, down) - np.arctan2(shank * np.sin(knee), thigh + shank * np.cos(knee)), knee]


def foot_place(phase):
    """Set position of a foot: constant speed along the ground, then through the air, with continuous velocity."""
    step = speed * period / 2
    if phase < 0.5:
        return step * (0.5 - 2 * phase), 0
    s = 2 * phase - 1
    return step * (2 * s**2 * (3 - 2 * s) - s - 0.5), lift * np.sin(np.pi * s) ** 2


def phase_of(leg, t):
    return ((t - start) / period + phases[leg]) % 1


def aims(t):
    """Angles of all joints, and whether a foot is to carry; steps grow within the first period."""
    grown = np.clip((t - start) / period, 0, 1)
    places = [foot_place(phase_of(leg, t)) for leg in range(4)]
    angles = np.concatenate([leg_angles(grown * x, grown * z) for x, z in places])
    return angles, [t < start or phase_of(leg, t) < 0.5 for leg in range(4)]


# model
q0 = np.r_[0, 0, stance + foot, 0, 0, 0, aims(0)[0]]
mbs = exu.SystemContainer().AddSystem()
ground = mbs.CreateGround(graphicsDataList=[exu.graphics.CheckerBoard(size=4)])
made = robot.CreateKinematicTree(mbs)
tree, links = made["objectKinematicTree"], made["links"]
mbs.SetNodeParameter(made["nodeGeneric"], "referenceCoordinates", q0)
contacts, square = [], [[-5, -5, 0], [5, -5, 0], [5, 5, 0], [-5, 5, 0]]
for leg in hips:
    tip = mbs.AddMarker(
        MarkerKinematicTreeRigid(objectNumber=tree, linkNumber=links[f"{leg} shank"], localPosition=[0, 0, -shank])
    )
    touching = mbs.CreateSphereQuadContact(
        name=leg, bodyNumbers=[tip, ground], radiusSphere=foot, quadPoints=square,
        dynamicFriction=0.8, frictionProportionalZone=0.01, contactStiffness=1e4, contactDamping=50,
    )  # fmt: skip
    contacts += touching.values()
sensor = mbs.AddSensor(
    SensorKinematicTree(
        objectNumber=tree,
        linkNumber=links["trunk"],
        storeInternal=True,
        outputVariableType=exu.OutputVariableType.Position,
    )
)
forces = [
    mbs.AddSensor(SensorObject(objectNumber=c, storeInternal=True, outputVariableType=exu.OutputVariableType.Force))
    for c in contacts
]
mbs.Assemble()
dynamics = TreeDynamics(mbs, tree)


def control(mbs, t):
    q = q0 + mbs.systemData.GetODE2Coordinates()
    (angles, carrying), (later, _) = aims(t), aims(t + sample)
    torques = np.zeros(18)
    for name, coordinates, carries in zip(hips, of_legs, carrying, strict=True):
        if carries:
            upwards = dynamics.Jacobian(q, links[f"{name} shank"], [0, 0, -shank])[2, coordinates]
            torques[coordinates] = -weight / sum(carrying) * upwards
    mbs.SetObjectParameter(tree, "jointForceVector", torques)
    mbs.SetObjectParameter(tree, "jointPositionOffsetVector", np.r_[np.zeros(6), angles])
    mbs.SetObjectParameter(tree, "jointVelocityOffsetVector", np.r_[np.zeros(6), (later - angles) / sample])
    return True


control(mbs, 0)  # initial accelerations are those with drives
mbs.SetPreStepUserFunction(control)
settings = exu.SimulationSettings()
settings.solutionSettings.sensorsWritePeriod = 0.002
settings.timeIntegration.verboseMode = 0
settings.timeIntegration.endTime = end
settings.solutionSettings.solutionWritePeriod = settings.timeIntegration.endTime / 60
settings.timeIntegration.numberOfSteps = round(end / sample)
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.6  # contacts open and close
mbs.SolveDynamic(settings)

way = mbs.GetSensorStoredData(sensor)
force = mbs.GetSensorStoredData(forces[0])
force[:, 1:] = sum(mbs.GetSensorStoredData(number)[:, 1:] for number in forces)
steady = force[:, 0] >= end - 5 * period - 1e-9
mean = np.trapezoid(force[steady, 3], force[steady, 0]) / np.ptp(force[steady, 0])
print(f"mean force of the ground over five periods: {mean:.2f} N, weight {weight:.2f} N")
travelled = way[-1, 1] - np.interp(end - 5 * period, way[:, 0], way[:, 1])
print(f"The quadruped trots at {travelled / (5 * period):.3f} m/s; its feet are moved back at {speed} m/s.")
mbs.PlotSensor(
    [force] * 3,
    components=[0, 1, 2],
    labels=["forward", "sideways", "up"],
    yLabel="force of the ground (N)",
    legendArgs={"loc": "lower center", "bbox_to_anchor": (0.5, 1), "ncols": 3},
    fileName="quadruped_forces.png",
    closeAll=True,
)
mbs.PlotSensor(
    [way] * 3,
    components=[0, 1, 2],
    labels=["x", "y", "z"],
    yLabel="position of the trunk (m)",
    fileName="quadruped_way.png",
)
shown = mbs.GetSystemContainer().visualizationSettings
shown.nodes.show = shown.markers.show = shown.loads.show = shown.connectors.show = shown.sensors.show = False
mbs.Draw(fileName="quadruped_picture.png")
in_a_second = settings.timeIntegration.endTime / 3
mbs.DrawSolution(
    fileName="quadruped_motion.gif", windowSize=[420, 320], framesPerSecond=20, speed=in_a_second, view="axonometric"
)
