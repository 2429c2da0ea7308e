"""A trolley oscillates on a tight rope, only because of the sag by its own weight.

The sag of a rope of length L and tension T under a force F at x is F x (L - x) / (L T); half of the work of the
weight is
stored in the rope. The other half drives the trolley to the middle like a spring: it oscillates with the frequency
g sqrt(m / (L T)).
"""

import numpy as np

import dalembert as exu
from dalembert.utilities import *

length, tension, mass, g = 20.0, 20e3, 100.0, 9.81  # m, N, kg, m/s^2
axial = 1e5  # N: a rope that stretches easily keeps its tension
elements, start = 12, 4.0  # m

mbs = exu.SystemContainer().AddSystem()
cable = Cable2D(
    physicsMassPerLength=0.05,
    physicsBendingStiffness=1,
    physicsAxialStiffness=axial,
    physicsReferenceAxialStrain=-tension / axial,
    physicsAxialDamping=2e3,
    visualization=VCable2D(drawHeight=0.1),
)
nodes, cables, *_ = GenerateStraightLineANCFCable2D(
    mbs,
    [0, 0, 0],
    [length, 0, 0],
    elements,
    cable,
    fixedConstraintsNode0=[1, 1, 0, 0],
    fixedConstraintsNode1=[1, 1, 0, 0],
)
sliding = [mbs.AddMarker(MarkerBodyCable2DCoordinates(bodyNumber=each)) for each in cables]
trolley = mbs.CreateMassPoint(
    referencePosition=[start, 0, 0],
    physicsMass=mass,
    gravity=[0, -g, 0],
    create2D=True,
    graphicsDataList=[graphics.Brick(size=[1, 0.5, 0.5], color=graphics.color.orange)],
)
wheel = mbs.AddMarker(MarkerBodyPosition(bodyNumber=trolley))
step = length / elements
place = mbs.AddNode(NodeGenericData(numberOfDataCoordinates=2, initialCoordinates=[int(start / step), start]))
mbs.AddObject(
    SlidingJoint2D(
        markerNumbers=[wheel, sliding[int(start / step)]],
        slidingMarkerNumbers=sliding,
        slidingMarkerOffsets=[step * i for i in range(elements)],
        nodeNumber=place,
    )
)
brake = mbs.CreateCoordinateConstraint(bodyNumbers=[None, trolley], coordinates=[None, 0])
way = mbs.AddSensor(
    SensorBody(bodyNumber=trolley, outputVariableType=exu.OutputVariableType.Position, storeInternal=True)
)
mbs.Assemble()

frequency = g * np.sqrt(mass / (length * tension))  # rad/s
period = 2 * np.pi / frequency
settings = exu.SimulationSettings()
settings.staticSolver.numberOfLoadSteps = 5
mbs.SolveStatic(settings, updateInitialValues=True)  # held by its brake
mbs.SetObjectParameter(brake, "activeConnector", False)
settings.timeIntegration.endTime = period
settings.timeIntegration.numberOfSteps = 1500
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.5
settings.solutionSettings.sensorsWritePeriod = period / 300
settings.solutionSettings.solutionWritePeriod = settings.timeIntegration.endTime / 60
mbs.SolveDynamic(settings)

time, x, y, _ = mbs.GetSensorStoredData(way).T
passing = np.flatnonzero((x[:-1] < length / 2) & (x[1:] >= length / 2))[0]
quarter = np.interp(length / 2, x[passing : passing + 2], time[passing : passing + 2])
print(f"it passes the middle after: {quarter:.3f} s, a quarter of the period {period / 4:.3f} s")
print(
    f"sag in the middle: {-np.interp(quarter, time, y):.4f} m, of a tight rope {mass * g * length / 4 / tension:.4f} m"
)
mbs.PlotSensor(
    way, componentsX=0, components=1, xLabel="way (m)", yLabel="height (m)", labels="trolley",
    fileName="trolley_way.png", closeAll=True,
)  # fmt: skip
shown = mbs.GetSystemContainer().visualizationSettings
shown.nodes.show = shown.markers.show = shown.connectors.show = shown.loads.show = False
shown.sensors.traces.showPositionTrace = True
mbs.Draw(fileName="trolley_picture.png")
in_a_second = settings.timeIntegration.endTime / 3
mbs.DrawSolution(fileName="trolley_motion.gif", windowSize=[420, 320], framesPerSecond=20, speed=in_a_second)
