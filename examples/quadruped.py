"""A quadruped trots: a kinematic tree that floats on six virtual joints and stands on the ground by friction alone.

Diagonal legs step together. The joint drives track the positions of the feet relative to their hips; the legs on the
ground share the weight, by torques from the transposed Jacobians of their feet. The controller updates set values and
torques every 2 ms. The balance of momentum gives the ground force: its mean over whole periods of a steady gait is the
weight.
"""

import matplotlib.pyplot as plt
import numpy as np

import dalembert as db
from dalembert.robotics import Robot, RobotLink, VRobotLink
from dalembert.treeDynamics import TreeDynamics
from dalembert.utilities import HTtranslate

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
    return db.graphics.Cylinder([0, 0, -size], [0, 0, size], radius, color)


dark, bright = db.graphics.color.darkgrey, db.graphics.color.orange
trunk = drawn(db.graphics.Brick(size=[length + 0.1, width - 0.06, 0.1], color=bright))
robot.AddLink(
    RobotLink(trunk_mass, [0, 0, 0], np.diag([0.02, 0.07, 0.08]), jointType="Rx", name="trunk", visualization=trunk)
)
tip_of_leg = db.graphics.Sphere([0, 0, -shank], foot, dark)
for leg, (x, y) in hips.items():
    parts = [  # joint, place in the frame of the link before, centre of mass (m), inertia (kg m^2), graphics
        ("hip", "Rx", [x, y, 0], 0, 5e-4, drawn(db.graphics.Sphere(radius=0.04, color=dark))),
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
    """Return angles of hip, thigh and shank for a foot that is x before and z above the point below its hip."""
    down = stance - z
    knee = -np.arccos((x**2 + down**2 - thigh**2 - shank**2) / (2 * thigh * shank))
    return [0, -np.arctan2(x, down) - np.arctan2(shank * np.sin(knee), thigh + shank * np.cos(knee)), knee]


def foot_place(phase):
    """Return the set position of a foot: constant speed along the ground, then through the air."""
    step = speed * period / 2
    if phase < 0.5:
        return step * (0.5 - 2 * phase), 0
    s = 2 * phase - 1
    return step * (2 * s**2 * (3 - 2 * s) - s - 0.5), lift * np.sin(np.pi * s) ** 2


def phase_of(leg, t):
    return ((t - start) / period + phases[leg]) % 1


def aims(t):
    """Return angles of all joints, and whether a foot is to carry; steps grow within the first period."""
    grown = np.clip((t - start) / period, 0, 1)
    places = [foot_place(phase_of(leg, t)) for leg in range(4)]
    angles = np.concatenate([leg_angles(grown * x, grown * z) for x, z in places])
    return angles, [t < start or phase_of(leg, t) < 0.5 for leg in range(4)]


# model
q0 = np.r_[0, 0, stance + foot, 0, 0, 0, aims(0)[0]]
model = db.Model()
ground = model.create_ground("floor", graphics_data_list=[db.graphics.CheckerBoard(size=4)])
made = robot.CreateKinematicTree(model.system)
tree, links = made["objectKinematicTree"], made["links"]
model.system.SetNodeParameter(made["nodeGeneric"], "referenceCoordinates", q0)
contacts, square = [], [[-5, -5, 0], [5, -5, 0], [5, 5, 0], [-5, 5, 0]]
for leg in hips:
    tip = model.add(
        db.MarkerKinematicTreeRigid(objectNumber=tree, linkNumber=links[f"{leg} shank"], localPosition=[0, 0, -shank])
    )
    touching = model.create_sphere_quad_contact(
        name=leg, body_numbers=[tip, ground], radius_sphere=foot, quad_points=square,
        dynamic_friction=0.8, friction_proportional_zone=0.01, contact_stiffness=1e4, contact_damping=50,
    )  # fmt: skip
    contacts += touching.values()
sensor = model.add(
    db.SensorKinematicTree(
        objectNumber=tree,
        linkNumber=links["trunk"],
        storeInternal=True,
        outputVariableType=db.OutputVariableType.Position,
    )
)
forces = [model.create_sensor(contact, "force") for contact in contacts]
model.assemble()
dynamics = TreeDynamics(model.system, tree)


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


control(model.system, 0)  # initial accelerations are those with drives
model.system.SetPreStepUserFunction(control)
settings = db.SimulationSettings()
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.6  # contacts open and close
solution = model.solve(end_time=end, step_size=sample, every=sample, settings=settings)

times, way = solution.times, sensor.values
force = sum(sensor.values for sensor in forces)
steady = times >= end - 5 * period - 1e-9
mean = np.trapezoid(force[steady, 2], times[steady]) / np.ptp(times[steady])
print(f"mean force of the ground over five periods: {mean:.2f} N, weight {weight:.2f} N")
travelled = way[-1, 0] - np.interp(end - 5 * period, times, way[:, 0])
print(f"The quadruped trots at {travelled / (5 * period):.3f} m/s; its feet are moved back at {speed} m/s.")
for name, values, quantity in (("forces", force, "force of the ground (N)"), ("way", way, "position of the trunk (m)")):
    figure, axes = plt.subplots()
    axes.plot(times, values, label=["forward", "sideways", "up"])
    axes.set(xlabel="time (s)", ylabel=quantity)
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncols=3)
    figure.savefig(f"quadruped_{name}.png")
shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = shown.loads.show = shown.connectors.show = shown.sensors.show = False
model.draw(file_name="quadruped_picture.png")
solution.animate(
    file_name="quadruped_motion.gif",
    window_size=[420, 320],
    frames_per_second=20,
    speed=end / 3,
    view="axonometric",
)
