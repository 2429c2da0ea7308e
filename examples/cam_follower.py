"""A cam lifts a valve against its spring: a roller runs on the outline of an eccentric disc.

The outline is a polygon of many sides, so that any shape is possible. The motion for a circle has a closed form. The
spring keeps contact, as long as the cam is not too fast.
"""

import numpy as np

import dalembert as exu
from dalembert.utilities import *

radius, off, roller = 0.03, 0.008, 0.01  # m: radius of the disc, its eccentricity, radius of the roller
mass, stiffness, preload = 0.1, 8e3, 120  # kg, N/m, N
turns, end, sides = 10, 0.2, 360  # per second, s, 1

mbs = exu.SystemContainer().AddSystem()
ground = mbs.CreateGround()
disc = graphics.Cylinder([off, 0, -0.01], [0, 0, 0.02], radius=radius, color=graphics.color.steelblue, nTiles=64)
shaft = graphics.Cylinder([0, 0, -0.02], [0, 0, 0.04], radius=0.006, color=graphics.color.grey, nTiles=32)
cam = mbs.CreateRigidBody(
    name="cam",
    inertia=InertiaCylinder(density=7800, length=0.02, outerRadius=radius, axis=2),
    initialAngularVelocity=[0, 0, 2 * np.pi * turns],
    nodeType=exu.NodeType.RotationRxyz,
    graphicsDataList=[disc, shaft],
)
mbs.CreateGenericJoint(bodyNumbers=[ground, cam], position=[0, 0, 0], constrainedAxes=[1, 1, 1, 1, 1, 0], show=False)
cold = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
angle = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.GetObject(cam)["nodeNumber"], coordinate=5))
mbs.AddObject(
    CoordinateConstraint(  # the shaft turns evenly
        markerNumbers=[cold, angle],
        velocityLevel=True,
        offset=2 * np.pi * turns,
        visualization=VCoordinateConstraint(show=False),
    )
)


def height(angle):
    """Height of the center of the roller above the shaft."""
    return off * np.sin(angle) + np.sqrt((radius + roller) ** 2 - (off * np.cos(angle)) ** 2)


wheel = graphics.Cylinder([0, 0, -0.008], [0, 0, 0.016], radius=roller, color=graphics.color.orange, nTiles=48)
stem = graphics.Brick([0, 0.04, 0], size=[0.006, 0.08, 0.006], color=graphics.color.grey)
valve = mbs.CreateRigidBody(
    name="valve",
    referencePosition=[0, height(0), 0],
    initialVelocity=[0, 2 * np.pi * turns * off, 0],
    inertia=InertiaCuboid(density=mass / 1e-6, sideLengths=[0.01, 0.01, 0.01]),
    graphicsDataList=[wheel, stem],
)
mbs.CreateGenericJoint(
    bodyNumbers=[ground, valve], position=[0, height(0), 0], constrainedAxes=[1, 0, 1, 1, 1, 1], show=False
)
seat = mbs.AddMarker(MarkerBodyRigid(bodyNumber=ground, localPosition=[0, height(0) + 0.1, 0]))
head = mbs.AddMarker(MarkerBodyRigid(bodyNumber=valve, localPosition=[0, 0.05, 0]))
mbs.AddObject(
    LinearSpringDamper(  # along y; the force vanishes at the end of the preload
        name="valve spring",
        markerNumbers=[seat, head],
        axisMarker0=[0, 1, 0],
        stiffness=stiffness,
        offset=-0.05 - preload / stiffness,
        visualization=VLinearSpringDamper(drawSize=0.012),
    )
)

# corners against the clock would have the inside on their left
corners = -2 * np.pi * np.arange(sides + 1) / sides
outline = np.column_stack([off + radius * np.cos(corners), radius * np.sin(corners)])
axis = mbs.AddMarker(MarkerBodyRigid(bodyNumber=cam))
middle = mbs.AddMarker(MarkerBodyRigid(bodyNumber=valve))
state = mbs.AddNode(NodeGenericData(numberOfDataCoordinates=3 * sides, initialCoordinates=[0, 1e-3, 0] * sides))
contact = mbs.AddObject(
    ObjectContactCurveCircles(
        name="roller on cam",
        markerNumbers=[axis, middle],
        nodeNumber=state,
        circlesRadii=[roller],
        segmentsData=exu.MatrixContainer(np.hstack([outline[:-1], outline[1:]])),
        contactStiffness=2e10,  # per length of the segments
        contactDamping=1e6,
        visualization=VObjectContactCurveCircles(show=False),
    )
)
place = mbs.AddSensor(
    SensorBody(name="valve", bodyNumber=valve, outputVariableType=exu.OutputVariableType.Position, storeInternal=True)
)
mbs.Assemble()

settings = exu.SimulationSettings()
settings.linearSolverType = exu.LinearSolverType.EigenSparse
settings.timeIntegration.endTime = end
settings.timeIntegration.numberOfSteps = 4000
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.6
settings.solutionSettings.sensorsWritePeriod = 1e-3
settings.solutionSettings.solutionWritePeriod = settings.timeIntegration.endTime / 60
mbs.SolveDynamic(settings)

t, y = mbs.GetSensorStoredData(place)[:, [0, 2]].T
lift = y - height(0)
expected = radius + roller + off - height(0)
print(f"largest lift: {1e3 * lift.max():.3f} mm, of a roller on a circle {1e3 * expected:.3f} mm")
print(f"largest difference on the way: {1e6 * np.abs(y - height(2 * np.pi * turns * t)).max():.1f} um")
mbs.PlotSensor(place, components=1, yLabel="height of the valve (m)", fileName="cam_lift.png", closeAll=True)
shown = mbs.GetSystemContainer().visualizationSettings
shown.nodes.show = shown.markers.show = shown.sensors.show = False
mbs.Draw(fileName="cam_picture.png")
in_a_second = settings.timeIntegration.endTime / 3
mbs.DrawSolution(fileName="cam_motion.gif", windowSize=[420, 320], framesPerSecond=20, speed=in_a_second)
