"""A rope slips from a smooth bar: it hangs down on both sides, and its longer side pulls it over.

Contact between the bar and each element of the rope is frictionless, so the tension is equal on both sides of the
bar. Let
x be half the difference of the lengths; the weight of 2 x moves the whole rope of length L, and x'' = 2 g x / L: the
displacement grows as cosh(t sqrt(2 g / L)), independently of the radius of the bar.
"""

import numpy as np

import dalembert as exu
from dalembert.beams import PointsAndSlopes2ANCFCable2D
from dalembert.utilities import *

length, density, stiffness, g = 3.0, 0.5, 2e4, 9.81  # m, kg/m, N, m/s^2
radius, thickness, start, end = 0.1, 0.01, 0.05, 1.0  # m, m, m, s
elements, segments = 120, 4  # the latter per element
bend = radius + 0.5 * thickness  # radius of the middle line of the rope
longer = 0.5 * (length - np.pi * bend) + start

along = np.linspace(0, length, elements + 1)
angle = np.clip((along - (length - longer - np.pi * bend)) / bend, 0, np.pi)  # angle around the bar, clockwise
straight = np.minimum(along, length - longer - np.pi * bend) - (length - longer - np.pi * bend)  # left, up to the bar
points = np.column_stack([-bend * np.cos(angle), bend * np.sin(angle) + straight, np.sin(angle), np.cos(angle)])
points[:, 1] -= np.maximum(along - (length - longer), 0)  # right, down from the bar

mbs = exu.SystemContainer().AddSystem()
disc = graphics.Cylinder([0, 0, -0.1], [0, 0, 0.2], radius, graphics.color.grey, nTiles=64)
bar = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.CreateGround(graphicsDataList=[disc])))
rope = Cable2D(
    physicsMassPerLength=density, physicsBendingStiffness=1e-4, physicsAxialStiffness=stiffness,
    physicsAxialDamping=20, visualization=VCable2D(drawHeight=thickness),
)  # fmt: skip
nodes, cables, *_ = PointsAndSlopes2ANCFCable2D(
    mbs, points, [length / elements] * elements, rope, massProportionalLoad=[0, -g, 0], firstNodeIsLastNode=False
)
for cable in cables:
    shape = mbs.AddMarker(MarkerBodyCable2DShape(bodyNumber=cable, numberOfSegments=segments))
    gaps = mbs.AddNode(NodeGenericData(numberOfDataCoordinates=segments, initialCoordinates=[0.1] * segments))
    mbs.AddObject(
        ObjectContactCircleCable2D(
            markerNumbers=[bar, shape], nodeNumber=gaps, numberOfContactSegments=segments, contactStiffness=1e4,
            contactDamping=1, circleRadius=radius, offset=0.5 * thickness,
            visualization=VObjectContactCircleCable2D(show=False),
        )
    )  # fmt: skip
way = mbs.AddSensor(SensorNode("end of the rope", nodeNumber=nodes[-1], storeInternal=True,
                               outputVariableType=exu.OutputVariableType.Displacement))  # fmt: skip
mbs.Assemble()

settings = exu.SimulationSettings()
settings.solutionSettings.sensorsWritePeriod = end / 100
settings.timeIntegration.endTime = end
settings.timeIntegration.numberOfSteps = 1000
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.6
settings.solutionSettings.solutionWritePeriod = settings.timeIntegration.endTime / 60
mbs.SolveDynamic(settings)

time, _, y, _ = mbs.GetSensorStoredData(way).T
moved, rate = start - y, np.sqrt(2 * g / length)
theory = start * np.cosh(rate * time)
speed = -mbs.GetNodeOutput(nodes[-1], exu.OutputVariableType.Velocity)[1]
print(f"x after {end:.0f} s: {moved[-1]:.4f} m, by cosh {theory[-1]:.4f} m")
print(f"speed after {end:.0f} s: {speed:.4f} m/s, by sinh {start * rate * np.sinh(rate * end):.4f} m/s")
mbs.PlotSensor(
    [np.column_stack([time, moved]), np.column_stack([time, theory])], components=[0, 0], yLabel="x (m)",
    labels=["rope", "cosh"], lineStyles=["-", "--"], fileName="rope_way.png", closeAll=True,
)  # fmt: skip
shown = mbs.GetSystemContainer().visualizationSettings
shown.nodes.show = shown.markers.show = shown.sensors.show = shown.connectors.show = shown.loads.show = False
shown.contour.outputVariable = exu.OutputVariableType.ForceLocal  # tension, as color
mbs.Draw(fileName="rope_picture.png", view="front")
in_a_second = settings.timeIntegration.endTime / 3
mbs.DrawSolution(fileName="rope_motion.gif", windowSize=[420, 320], framesPerSecond=20, speed=in_a_second, view="front")
