"""Beads on a wire that is bent to a cycloid: wherever they start, they are at its lowest point at the same time.

Huygens found it for clocks: the time is pi sqrt(a / g), the circle that rolls having the radius a. The wire is made of
spatial cable elements, all of whose coordinates are held by constraints of vectors; sliding joints let the beads move
along it without friction.
"""

from itertools import pairwise

import numpy as np

import dalembert as exu
from dalembert.utilities import *

a, g, elements, mass = 0.5, 9.81, 24, 0.2  # m, m/s^2, 1, kg
time = np.pi * np.sqrt(a / g)  # s
starts = [0.15, 0.5, 0.8]  # parts of the arc from the top to the lowest point

# arc length s between the cusps: 4 a (1 - cos(angle / 2)), equally spaced
arc = np.linspace(0.1 * a, 7.9 * a, elements + 1)  # the cusps are excluded, because their curvature is infinite
angles = 2 * np.arccos(1 - arc / (4 * a))
points = np.column_stack([a * (angles - np.sin(angles)), 0 * angles, -a * (1 - np.cos(angles))])
slopes = np.column_stack([np.sin(angles / 2), 0 * angles, -np.cos(angles / 2)])

mbs = exu.SystemContainer().AddSystem()
nodes = [mbs.AddNode(NodePointSlope1(referenceCoordinates=[*p, *s])) for p, s in zip(points, slopes, strict=True)]
fixed = mbs.AddMarker(MarkerNodeCoordinates(nodeNumber=mbs.AddNode(NodePointGround())))
for node, p, s in zip(nodes, points, slopes, strict=True):
    held = mbs.AddMarker(MarkerNodeCoordinates(nodeNumber=node))  # measures total coordinates
    mbs.AddObject(CoordinateVectorConstraint(markerNumbers=[fixed, held], scalingMarker1=np.eye(6), offset=[*p, *s]))
length = arc[1] - arc[0]
wires = [
    mbs.AddObject(
        ObjectANCFCable(
            physicsLength=length, physicsMassPerLength=0.1, physicsBendingStiffness=1, physicsAxialStiffness=1e3,
            strainIsRelativeToReference=1, nodeNumbers=[n0, n1], visualization=VObjectANCFCable(radius=0.005),
        )
    )
    for n0, n1 in pairwise(nodes)
]  # fmt: skip
shapes = [mbs.AddMarker(MarkerBodyBeamShape(bodyNumber=wire)) for wire in wires]
offsets = [length * i for i in range(elements)]
sensors = []
for part, color in zip(starts, (graphics.color.red, graphics.color.green, graphics.color.blue), strict=True):
    s = 4 * a * part
    angle = 2 * np.arccos(1 - s / (4 * a))
    place = [a * (angle - np.sin(angle)), 0, -a * (1 - np.cos(angle))]
    bead = mbs.CreateMassPoint(
        referencePosition=place, physicsMass=mass, gravity=[0, 0, -g],
        graphicsDataList=[graphics.Sphere(radius=0.03, color=color)],
    )  # fmt: skip
    slider = mbs.AddMarker(MarkerBodyPosition(bodyNumber=bead))
    element = int((s - arc[0]) / length)
    state = mbs.AddNode(NodeGenericData(numberOfDataCoordinates=2, initialCoordinates=[element, s - arc[0]]))
    joint = mbs.AddObject(
        SlidingJoint(
            markerNumbers=[slider, shapes[element]], slidingMarkerNumbers=shapes, slidingMarkerOffsets=offsets,
            nodeNumber=state, constrainRotations=[0, 0, 0],
        )
    )  # fmt: skip
    sensors.append(
        mbs.AddSensor(
            SensorObject(
                objectNumber=joint, outputVariableType=exu.OutputVariableType.SlidingCoordinate, storeInternal=True
            )
        )
    )
mbs.Assemble()
mbs.ComputeConsistentInitialConditions()  # the wire is as close to the cycloid as its elements can be

settings = exu.SimulationSettings()
settings.timeIntegration.endTime = 1.2 * time
settings.timeIntegration.numberOfSteps = 1200
settings.solutionSettings.solutionWritePeriod = settings.timeIntegration.endTime / 60
mbs.SolveDynamic(settings)

lowest = 4 * a - arc[0]
for part, sensor in zip(starts, sensors, strict=True):
    t, way = mbs.GetSensorStoredData(sensor)[:, :2].T
    down = np.interp(lowest, way, t)
    print(f"bead from {100 * part:.0f} % of the arc is down after: {down:.4f} s, Huygens {time:.4f} s")
mbs.PlotSensor(
    sensors, yLabel="way along the wire (m)", labels=[f"from {100 * part:.0f} %" for part in starts],
    fileName="beads_way.png", closeAll=True,
)  # fmt: skip
shown = mbs.GetSystemContainer().visualizationSettings
shown.nodes.show = shown.markers.show = shown.loads.show = shown.sensors.show = shown.connectors.show = False
mbs.Draw(fileName="beads_picture.png", view=[[1, 0, 0], [0, 0, 1], [0, -1, 0]])
in_a_second = settings.timeIntegration.endTime / 3
mbs.DrawSolution(
    fileName="beads_motion.gif",
    windowSize=[420, 320],
    framesPerSecond=20,
    speed=in_a_second,
    view=[[1, 0, 0], [0, 0, 1], [0, -1, 0]],
)
