"""Three equal masses chase each other along an eight, held by nothing but their gravitation.

Chenciner and Montgomery found this orbit in 2000. Each mass passes every place a third of the period after the one
before it; energy and angular momentum, which is zero, stay.
"""

import numpy as np

import dalembert as exu
from dalembert.utilities import *

period, corner = 6.32591398, [0.97000436, -0.24308753, 0]  # valid for masses of 1 kg and a gravitational constant of 1
speed = np.array([-0.93240737, -0.86473146, 0])  # m/s, of the mass in the middle

mbs = exu.SystemContainer().AddSystem()
places = [corner, [-x for x in corner], [0, 0, 0]]
colors = [graphics.color.red, graphics.color.green, graphics.color.blue]
masses = [
    mbs.CreateMassPoint(
        name=f"mass {i}",
        referencePosition=places[i],
        initialVelocity=velocity,
        physicsMass=1,
        graphicsDataList=[graphics.Sphere(radius=0.05, color=colors[i], nTiles=32)],
    )
    for i, velocity in enumerate([-speed / 2, -speed / 2, speed])
]
markers = [mbs.AddMarker(MarkerBodyPosition(bodyNumber=mass)) for mass in masses]
for pair in ([0, 1], [1, 2], [2, 0]):
    ends = [markers[i] for i in pair]
    mbs.AddObject(ConnectorGravity(markerNumbers=ends, gravitationalConstant=1, mass0=1, mass1=1))
ways = [
    mbs.AddSensor(
        SensorMarker(markerNumber=marker, outputVariableType=exu.OutputVariableType.Position, storeInternal=True)
    )
    for marker in markers
]
mbs.Assemble()

settings = exu.SimulationSettings()
settings.timeIntegration.endTime = period
settings.timeIntegration.numberOfSteps = 300
settings.timeIntegration.relativeTolerance = 1e-10
settings.timeIntegration.absoluteTolerance = 1e-10
settings.solutionSettings.sensorsWritePeriod = period / 300
settings.solutionSettings.solutionWritePeriod = settings.timeIntegration.endTime / 60
mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.DOP853)

first, second, third = (mbs.GetSensorStoredData(way) for way in ways)
print(f"first mass after one period: {first[-1, 1]:.6f} m, at the start {corner[0]:.6f} m")
follower = min((second, third), key=lambda way: abs(way[100, 1] - corner[0]))
print(f"the next mass a third of the period later: {follower[100, 2]:.6f} m, where the first was {corner[1]:.6f} m")
mbs.PlotSensor(
    ways, componentsX=[0] * 3, components=[1] * 3, labels=["first", "second", "third"], lineStyles=["-", "--", ":"],
    xLabel="x (m)", yLabel="y (m)", fileName="eight.png", closeAll=True,
)  # fmt: skip
shown = mbs.GetSystemContainer().visualizationSettings
shown.connectors.show = shown.nodes.show = shown.markers.show = False
shown.sensors.traces.showPositionTrace = True
mbs.Draw(fileName="eight_picture.png")
in_a_second = settings.timeIntegration.endTime / 3
mbs.DrawSolution(fileName="eight_motion.gif", windowSize=[420, 320], framesPerSecond=20, speed=in_a_second)
