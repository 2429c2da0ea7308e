"""A trolley of a crane starts to run, and the load on its rope swings.

The rope is a chain of cable elements with little mass and hardly any stiffness in bending, pulled straight by the load.
While the trolley accelerates, rope and load swing about a line that leans back; how far they swing when it runs on
depends on how long it took. A pendulum with all of its mass at the end swings by ``2 a / g |sin(omega T / 2)|``.
"""

import numpy as np

import dalembert as exu
from dalembert.beams import GenerateStraightLineANCFCable2D
from dalembert.utilities import *

length, elements = 12.0, 12  # m
load, rope = 800.0, 0.9  # kg, kg/m
acceleration, start, duration, end, g = 0.25, 1.0, 2.5, 20.0, 9.81  # m/s^2, s, s, s, m/s^2

mbs = exu.SystemContainer().AddSystem()
girder = exu.graphics.Brick([6, 0.4, 0], [16, 0.5, 0.5], color=exu.graphics.color.lightgrey)
mbs.CreateGround(graphicsDataList=[girder])


def way(t):
    """Displacement of the trolley, with a pause."""
    speed_up = min(max(0.0, t - start), duration)
    return acceleration * (speed_up**2 / 2 + speed_up * max(0.0, t - start - duration))


cable = Cable2D(
    physicsMassPerLength=rope,
    physicsBendingStiffness=40.0,
    physicsAxialStiffness=8e6,
    physicsAxialDamping=8e4,
    visualization=VCable2D(drawHeight=0.05),
)
nodes, cables, *_ = GenerateStraightLineANCFCable2D(
    mbs,
    [0, 0, 0],
    [0, -length, 0],
    elements,
    cable,
    massProportionalLoad=[0, -g, 0],
    fixedConstraintsNode0=[0, 1, 0, 0],
)
fixed = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
trolley = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=nodes[0], coordinate=0))
mbs.AddObject(
    CoordinateConstraint(markerNumbers=[fixed, trolley], offsetUserFunction=lambda mbs, t, item, offset: way(t))
)


def draw_trolley(mbs, item):
    """Return the trolley, where the rope begins."""
    x, y, _ = mbs.GetNodeOutput(nodes[0], exu.OutputVariableType.Position, exu.ConfigurationType.Visualization)
    return [exu.graphics.Brick([x, y + 0.1, 0], [1, 0.25, 0.6], color=exu.graphics.color.dodgerblue)]


mbs.AddObject(ObjectGround(visualization=VObjectGround(graphicsDataUserFunction=draw_trolley)))
drawing = exu.graphics.Brick([0, -0.6, 0], [1.2, 1.2, 1.2], color=exu.graphics.color.orange)
weight = mbs.CreateMassPoint(
    referencePosition=[0, -length, 0], physicsMass=load, gravity=[0, -g, 0], graphicsDataList=[drawing]
)
hook = mbs.AddMarker(MarkerNodePosition(nodeNumber=nodes[-1]))
mbs.AddObject(SphericalJoint(markerNumbers=[hook, mbs.AddMarker(MarkerBodyPosition(bodyNumber=weight))]))
sensor = mbs.AddSensor(
    SensorBody(bodyNumber=weight, outputVariableType=exu.OutputVariableType.Position, storeInternal=True)
)
mbs.Assemble()

settings = exu.SimulationSettings()
settings.solutionSettings.sensorsWritePeriod = 0.02
settings.staticSolver.verboseMode = 0
settings.timeIntegration.verboseMode = 0
mbs.SolveStatic(settings, updateInitialValues=True)  # the rope gets longer
settings.timeIntegration.endTime = end
settings.solutionSettings.solutionWritePeriod = settings.timeIntegration.endTime / 60
settings.timeIntegration.numberOfSteps = 4000
mbs.SolveDynamic(settings)

told = mbs.GetSensorStoredData(sensor)
times, hang = told[:, 0], -told[0, 2]
angle = np.arctan2(told[:, 1] - [way(t) for t in times], -told[:, 2])
swing = np.abs(angle[times > start + duration]).max()
pendulum = 2 * acceleration / g * abs(np.sin(np.sqrt(g / hang) * duration / 2))
print(f"the rope is {1e3 * (hang - length):.1f} mm longer under load")
print(f"swing of the load: {np.degrees(swing):.3f} deg, pendulum of that length {np.degrees(pendulum):.3f} deg")
mbs.PlotSensor(
    [np.column_stack([times, np.degrees(angle)])],
    components=[0],
    labels=["load"],
    yLabel="swing (deg)",
    fileName="crane_swing.png",
    closeAll=True,
)
SC = mbs.GetSystemContainer()
shown = SC.visualizationSettings
shown.nodes.show = shown.markers.show = shown.loads.show = shown.connectors.show = False
mbs.Draw(fileName="crane_picture.png")
in_a_second = settings.timeIntegration.endTime / 3
mbs.DrawSolution(fileName="crane_motion.gif", windowSize=[420, 320], framesPerSecond=20, speed=in_a_second)
