"""A hoist: a winch lifts a load by a rope over two sheaves of a bridge and one at the hook.

The rope runs from the winch over the first sheave of the bridge, around the sheave of the hook, over the second
sheave and to its anchor. The hook hangs in two falls: it rises by half of the rope length on the winch, and the rope
carries half of its weight. Sheaves turn without friction, and the rope is elastic.
"""

import numpy as np

import dalembert as exu
from dalembert.utilities import *

mass, g, radius, stiffness = 500, 9.81, 0.15, 1.2e7  # kg, m/s^2, m, N of the rope
drum, turn, end = 0.2, 1.5 * np.pi, 4  # m, rad, s

mbs = exu.SystemContainer().AddSystem()
sheave = graphics.Cylinder(pAxis=[0, 0, -0.02], vAxis=[0, 0, 0.04], radius=radius, color=graphics.color.grey, nTiles=48)
beam = graphics.Brick(centerPoint=[0, 0.25, 0], size=[2.2, 0.12, 0.2], color=graphics.color.steelblue)
ground = mbs.CreateGround(graphicsDataList=[beam, *(graphics.Move(sheave, [x, 0, 0], np.eye(3)) for x in (-0.3, 0.3))])
block = graphics.Brick(centerPoint=[0, -0.45, 0], size=[0.6, 0.5, 0.6], color=graphics.color.orange)
hook = mbs.CreateRigidBody(
    name="hook",
    referencePosition=[0, -2, 0],
    inertia=InertiaCuboid(density=mass / 0.18, sideLengths=[0.6, 0.5, 0.6]),
    graphicsDataList=[sheave, block],
)
# vertical motion only; another example shows a swinging load
mbs.CreateGenericJoint(bodyNumbers=[ground, hook], position=[0, -2, 0], constrainedAxes=[1, 0, 1, 1, 1, 1], show=False)
weight = mbs.AddMarker(MarkerBodyMass(bodyNumber=hook))
mbs.AddLoad(LoadMassProportional(markerNumber=weight, loadVector=[0, -g, 0]))

# the angle of the winch is prescribed; it winds and unwinds the rope
winch = mbs.AddNode(Node1D(name="winch"))
roll = graphics.Cylinder(pAxis=[0, 0, -0.1], vAxis=[0, 0, 0.2], radius=drum, color=graphics.color.dodgerblue, nTiles=48)
mbs.AddObject(
    ObjectRotationalMass1D(
        physicsInertia=2,
        nodeNumber=winch,
        referencePosition=[-1 - drum, -1, 0],
        visualization=VObjectRotationalMass1D(graphicsData=[roll]),
    )
)
start = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
angle = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=winch, coordinate=0))


def wanted(mbs, t, itemNumber, lOffset):
    return SmoothStep(t, 1, 3, 0, turn)


def speed_wanted(mbs, t, itemNumber, lOffset):
    return SmoothStepDerivative(t, 1, 3, 0, turn)


drive = mbs.AddObject(
    CoordinateConstraint(
        name="drive",
        markerNumbers=[start, angle],
        offsetUserFunction=wanted,
        offsetUserFunction_t=speed_wanted,
        visualization=VCoordinateConstraint(show=False),
    )
)

places = [[-1, -1, 0], [-0.3, 0, 0], None, [0.3, 0, 0], [1, -0.5, 0]]
markers = [
    mbs.AddMarker(MarkerBodyRigid(bodyNumber=hook if place is None else ground, localPosition=place or [0, 0, 0]))
    for place in places
]
rope = mbs.AddObject(
    ReevingSystemSprings(
        name="rope",
        markerNumbers=[*markers, start, angle],
        hasCoordinateMarkers=True,
        coordinateFactors=[0, -drum],
        stiffnessPerLength=stiffness,
        dampingPerLength=2e5,
        referenceLength=1,  # until its length over the sheaves is known
        sheavesAxes=exu.Vector3DList([[0, 0, -1], [0, 0, -1], [0, 0, 1], [0, 0, -1], [0, 0, -1]]),
        sheavesRadii=[0, radius, radius, radius, 0],
        visualization=VReevingSystemSprings(ropeRadius=0.012, color=graphics.color.black),
    )
)
mbs.Assemble()
length = mbs.GetObjectOutput(rope, exu.OutputVariableType.Distance)
mbs.SetObjectParameter(rope, "referenceLength", length)

force = mbs.AddSensor(
    SensorObject(
        name="rope", objectNumber=rope, outputVariableType=exu.OutputVariableType.ForceLocal, storeInternal=True
    )
)
height = mbs.AddSensor(
    SensorBody(name="hook", bodyNumber=hook, outputVariableType=exu.OutputVariableType.Position, storeInternal=True)
)
mbs.Assemble()

settings = exu.SimulationSettings()
settings.staticSolver.verboseMode = 0
settings.solutionSettings.sensorsWritePeriod = 0.01
settings.solutionSettings.solutionWritePeriod = end / 60
mbs.SolveStatic(settings, updateInitialValues=True)  # the rope takes the weight, before the winch turns
hung = mbs.GetSensorValues(height)[1]
settings.timeIntegration.endTime = end
settings.timeIntegration.numberOfSteps = 2000
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.7
mbs.SolveDynamic(settings)

rise = mbs.GetSensorValues(height)[1] - hung
print(f"force of the rope: {mbs.GetSensorValues(force):.1f} N, half of the weight {mass * g / 2:.1f} N")
print(f"the hook sinks under its weight by {1e3 * (-2 - hung):.2f} mm")
print(f"the hook rises by: {rise:.4f} m, half of the rope taken in {drum * turn / 2:.4f} m")
mbs.PlotSensor(height, components=1, yLabel="height of the hook (m)", fileName="hoist_height.png", closeAll=True)
mbs.PlotSensor(force, components=0, yLabel="force of the rope (N)", fileName="hoist_force.png", closeAll=True)
shown = mbs.GetSystemContainer().visualizationSettings
shown.nodes.show = shown.markers.show = shown.loads.show = shown.sensors.show = False
mbs.Draw(fileName="hoist_picture.png")
in_a_second = settings.timeIntegration.endTime / 3
mbs.DrawSolution(fileName="hoist_motion.gif", windowSize=[420, 320], framesPerSecond=20, speed=in_a_second)
