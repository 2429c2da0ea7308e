"""Newton's cradle: five steel balls on wires; the first is released, and the last one leaves with its velocity.

Neighbours have a small gap, so impacts occur one after the other, and each transfers all of the momentum: balls of
equal
mass exchange their velocities in elastic impacts. The period is that of a pendulum whose ball
swings on one side for a quarter of it, and the last one on the other side.
"""

from itertools import pairwise

import numpy as np

import dalembert as exu
from dalembert.utilities import *

balls, radius, density, wire, g = 5, 0.02, 7800.0, 0.3, 9.81  # 1, m, kg/m^3, m, m/s^2
gap, start = 2e-5, 0.3  # m, rad
mass = density * 4 / 3 * np.pi * radius**3
stiffness = 2e7  # N/m

mbs = exu.SystemContainer().AddSystem()
beam = graphics.Brick([0.5 * (balls - 1) * 2 * radius, wire, 0], [0.3, 0.01, 0.02], color=graphics.color.brown)
ground = mbs.CreateGround("frame", graphicsDataList=[beam])
names = [f"ball {i}" for i in range(balls)]
places = [(2 * radius + gap) * i for i in range(balls)]
for name, x in zip(names, places, strict=True):
    angle = -start if name == "ball 0" else 0.0
    mbs.CreateMassPoint(
        name,
        referencePosition=[x + wire * np.sin(angle), wire * (1 - np.cos(angle)), 0],
        physicsMass=mass,
        gravity=[0, -g, 0],
        create2D=True,
        graphicsDataList=[graphics.Sphere(radius=radius, color=graphics.color.lightgrey, nTiles=32)],
    )
    mbs.CreateDistanceConstraint(bodyNumbers=["frame", name], localPosition0=[x, wire, 0], drawSize=0.004)
for pair in pairwise(names):
    mbs.CreateSphereSphereContact(bodyNumbers=pair, spheresRadii=[radius, radius], contactStiffness=stiffness)
position, velocity = exu.OutputVariableType.Position, exu.OutputVariableType.Velocity
ways, speeds = (
    [mbs.AddSensor(SensorBody(bodyNumber=name, outputVariableType=kind, storeInternal=True)) for name in names]
    for kind in (position, velocity)
)
mbs.Assemble()

settings = exu.SimulationSettings()
settings.timeIntegration.endTime = 1.1
settings.timeIntegration.numberOfSteps = 22000
settings.timeIntegration.generalizedAlpha.spectralRadius = 1
settings.solutionSettings.solutionWritePeriod = settings.timeIntegration.endTime / 60
settings.solutionSettings.sensorsWritePeriod = 1e-3
mbs.SolveDynamic(settings)

drop = np.sqrt(2 * g * wire * (1 - np.cos(start)))
last = mbs.GetSensorStoredData(speeds[-1])
height = mbs.GetSensorStoredData(ways[-1])[:, 2]
print(f"the last ball leaves with: {last[:, 1].max():.4f} m/s, the first arrives with {drop:.4f} m/s")
print(f"it rises by: {1e3 * height.max():.3f} mm, the first was let go from {1e3 * wire * (1 - np.cos(start)):.3f} mm")
mbs.PlotSensor(ways, components=0, yLabel="position (m)", labels=names, fileName="cradle_motion.png", closeAll=True)
shown = mbs.GetSystemContainer().visualizationSettings
shown.nodes.show = shown.markers.show = shown.loads.show = shown.sensors.show = False
mbs.Draw(fileName="cradle_picture.png", view="front")
in_a_second = settings.timeIntegration.endTime / 3
mbs.DrawSolution(
    fileName="cradle_motion.gif", windowSize=[420, 320], framesPerSecond=20, speed=in_a_second, view="front"
)
