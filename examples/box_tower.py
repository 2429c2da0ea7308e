"""A ball hits a tower of ten boxes: general contact of convex shapes with each other, with a sphere and a plane.

Static friction holds the tower while it stands. Every box rests on one contact stiffness, for any number of corners:
the lowest one penetrates by the total weight divided
by the stiffness. All boxes finally lie on the ground, which carries their weight.
"""

import numpy as np

import dalembert as exu
from dalembert.utilities import *

count, size, density, gravity = 10, [0.12, 0.12, 0.08], 500.0, 9.81  # 1, m, kg/m^3, m/s^2
stiffness, damping, friction = 2e5, 400.0, 0.5  # N/m, Ns/m, 1
radius, speed = 0.08, 4.0  # radius and speed of the ball: m, m/s
mass, ball_mass = density * np.prod(size), 3.0  # kg

mbs = exu.SystemContainer().AddSystem()
floor = graphics.CheckerBoard(point=[0.3, 0, 0], size=1.8, nTiles=12)
ground = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.CreateGround(graphicsDataList=[floor])))
contact = mbs.AddGeneralContact()
contact.SetFrictionPairings([[friction]])
contact.SetFrictionBristles(stiffnessRatio=0.8, dampingRatio=1.0)
surface = {"contactStiffness": 2 * stiffness, "contactDamping": damping / 2, "frictionMaterialIndex": 0}
contact.AddPlane(ground, normal=[0, 0, 1], **surface)

# ---- initial penetrations of the tower in equilibrium ----------------------------------------------------------------
sinks = mass * gravity / stiffness * np.arange(count, 0, -1)
heights = size[2] * (np.arange(count) + 0.5) - np.cumsum(sinks)
boxes = []
for number, height in enumerate(heights):
    body = mbs.CreateRigidBody(
        referencePosition=[0, 0, height],
        inertia=InertiaCuboid(density, size),
        gravity=[0, 0, -gravity],
        nodeType=exu.NodeType.RotationRotationVector,
        graphicsDataList=[graphics.Brick(size=size, color=graphics.colorList[number % 8], addEdges=True)],
    )
    contact.AddBoxWithMarker(mbs.AddMarker(MarkerBodyRigid(bodyNumber=body)), size=size, **surface)
    boxes.append(body)
start = [-0.6, 0.02, 0.45]
ball = mbs.CreateRigidBody(
    referencePosition=start,
    inertia=InertiaSphere(ball_mass, radius),
    nodeType=exu.NodeType.RotationRotationVector,
    graphicsDataList=[graphics.Sphere(radius=radius, color=graphics.color.dodgerblue, nTiles=32)],
)
ball_marker = mbs.AddMarker(MarkerBodyRigid(bodyNumber=ball))
contact.AddSphereWithMarker(ball_marker, radius=radius, **surface)
weight = mbs.AddLoad(Force(markerNumber=ball_marker, loadVector=[0, 0, 0]))
mbs.Assemble()

settings = exu.SimulationSettings()
settings.solutionSettings.solutionWritePeriod = 5e-3
settings.timeIntegration.verboseMode = 0


def solve(begin, end):
    settings.timeIntegration.startTime, settings.timeIntegration.endTime = begin, end
    settings.timeIntegration.numberOfSteps = round((end - begin) / 1e-4)
    mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.VelocityVerlet)
    state = mbs.systemData.GetSystemState(exu.ConfigurationType.Current)
    mbs.systemData.SetSystemState(state, exu.ConfigurationType.Initial)


solve(0, 1)  # the ball waits
lowest = mbs.GetObjectOutputBody(boxes[0], exu.OutputVariableType.Position, [0, 0, -size[2] / 2])[2]
print(f"depth of the lowest box: {-1e3 * lowest:.4f} mm, by the weight of all {1e3 * sinks[0]:.4f} mm")

mbs.SetLoadParameter(weight, "loadVector", [0, 0, -ball_mass * gravity])
velocity = mbs.systemData.GetODE2Coordinates_t(exu.ConfigurationType.Initial)
velocity[mbs.systemData.GetObjectLTGODE2(ball)[:3]] = [speed, 0, 0.8]
mbs.systemData.SetODE2Coordinates_t(velocity, exu.ConfigurationType.Initial)
solve(1, 1.35)
SC = mbs.GetSystemContainer()
view = SC.visualizationSettings
view.nodes.show = view.markers.show = view.loads.show = False
mbs.Draw(fileName="box_tower_picture.png")
mbs.DrawSolution(fileName="box_tower_motion.gif", windowSize=[420, 320], framesPerSecond=20, speed=0.15)
solve(1.35, 4)
force = 0.0
for pair, push in zip(*(contact.GetConvexContacts()[key] for key in ("pairs", "forces")), strict=True):
    force += push[2] if pair.max() == count + 1 else 0  # the plane, behind the ball and the boxes
print(f"force of the ground: {force:.2f} N, by the weight {(count * mass + ball_mass) * gravity:.2f} N")
