"""A coin rolls on a circle, leaning inwards: its speed follows from the balance of moments.

A thin disc of radius R leans by the angle a from the vertical while its contact point moves on a circle of radius c
at the
rate w. The weight and the rate of angular momentum balance if

    m g R sin a = w^2 cos a (m d R + I3 (c / R - sin a) + I1 sin a)

with the distance d = c - R sin a of its center from the middle, and I3 about its own axis.
"""

import numpy as np

import dalembert as exu
from dalembert.utilities import *

radius, thickness, density, g = 0.1, 0.005, 8000.0, 9.81  # m, m, kg/m^3, m/s^2
lean, circle = 0.4, 0.5  # rad, m

coin = InertiaCylinder(density, thickness, radius, axis=0)
I1, I3 = coin.Inertia()[1, 1], coin.Inertia()[0, 0]
distance = circle - radius * np.sin(lean)
resistance = coin.mass * distance * radius + I3 * (circle / radius - np.sin(lean)) + I1 * np.sin(lean)
rate = np.sqrt(coin.mass * g * radius * np.tan(lean) / resistance)
end = 2 * np.pi / rate

axis, forward = np.array([np.cos(lean), 0, np.sin(lean)]), np.array([0, 1, 0])
upward = np.cross(axis, forward)
mbs = exu.SystemContainer().AddSystem()
mbs.CreateGround("table", graphicsDataList=[graphics.CheckerBoard(size=1.6, nTiles=8, color=graphics.color.lightgrey)])
mbs.CreateRigidBody(
    "coin",
    referencePosition=[distance, 0, radius * np.cos(lean)],
    referenceRotationMatrix=np.column_stack([axis, forward, upward]),
    initialVelocity=rate * distance * forward,
    initialAngularVelocity=-rate * (circle / radius - np.sin(lean)) * axis + rate * np.cos(lean) * upward,
    inertia=coin,
    gravity=[0, 0, -g],
    graphicsDataList=[
        graphics.Cylinder([-0.5 * thickness, 0, 0], [thickness, 0, 0], radius, graphics.color.orange, nTiles=48),
        graphics.Brick([0, 0, 0.5 * radius], [1.2 * thickness, 0.01, 0.5 * radius], graphics.color.brown),
    ],
)
mbs.CreateRollingDisc("contact", ["table", "coin"], axisPosition=[0, 0, 0], axisVector=[1, 0, 0], discRadius=radius)
mbs.AddSensor(
    SensorBody("way", bodyNumber="coin", outputVariableType=exu.OutputVariableType.Position, storeInternal=True)
)
mbs.Assemble()

settings = exu.SimulationSettings()
settings.timeIntegration.endTime = end
settings.timeIntegration.numberOfSteps = 800
settings.solutionSettings.solutionWritePeriod = settings.timeIntegration.endTime / 60
settings.solutionSettings.sensorsWritePeriod = end / 200
mbs.SolveDynamic(settings)

way = mbs.GetSensorStoredData("way")
angle = np.unwrap(np.arctan2(way[:, 2], way[:, 1]))[-1]
print(f"angle in the time of one turn: {angle:.5f} rad, of steady rolling {2 * np.pi:.5f} rad")
print(f"height at the end: {way[-1, 3]:.6f} m, at the start {way[0, 3]:.6f} m")
mbs.PlotSensor(
    "way", componentsX=0, components=1, xLabel="x (m)", yLabel="y (m)", labels="center", fileName="coin_way.png",
    closeAll=True,
)  # fmt: skip
shown = mbs.GetSystemContainer().visualizationSettings
shown.nodes.show = shown.markers.show = shown.loads.show = shown.connectors.show = False
shown.sensors.traces.showPositionTrace = True
mbs.Draw(fileName="coin_picture.png", view="axonometric")
in_a_second = settings.timeIntegration.endTime / 3
mbs.DrawSolution(
    fileName="coin_motion.gif", windowSize=[420, 320], framesPerSecond=20, speed=in_a_second, view="axonometric"
)
