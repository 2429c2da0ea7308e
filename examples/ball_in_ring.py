"""A ball swings at the bottom of a ring-shaped tube, and a barrel rocks on the floor; both slide without friction.

The center of the ball moves on a circle, as that of a pendulum does. The barrel is higher over the floor the more it
tilts, by the radius of its outline, and rocks about the point where it touches.
"""

import numpy as np

import dalembert as exu
from dalembert.utilities import *

g = 9.81  # m/s^2
# m: from the axis of the ring to that of its tube; radius of the tube; radius of the ball
ring, tube, radius = 1.0, 0.15, 0.05
swing = ring + tube - radius  # m: the circle of the center of the ball
tilt, lean = 0.05, 0.01  # rad: initial angles of ball and barrel
mass, moment = 2.0, 0.01  # kg, kg m^2
height, bulge = 0.1, 0.5  # m: radius of the barrel in its middle, and of its outline along the axis

mbs = exu.SystemContainer().AddSystem()
ground = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.CreateGround()))
inertia = RigidBodyInertia(mass, np.diag([moment] * 3))
ball = mbs.CreateRigidBody(
    referencePosition=[swing * np.sin(tilt), -swing * np.cos(tilt), 0],
    inertia=inertia,
    gravity=[0, -g, 0],
    graphicsDataList=[graphics.Sphere(radius=radius, color=graphics.color.red, nTiles=32)],
)
torus = graphics.Torus(
    point=[0, 0, 0], axis=[0, 0, 1], radiusMajor=ring, radiusMinor=tube, color=[0.5, 0.5, 0.6, 0.3], nTilesMajor=64
)
mbs.CreateGround(graphicsDataList=[torus])
mbs.AddObject(
    ObjectContactSphereTorus(
        markerNumbers=[mbs.AddMarker(MarkerBodyRigid(bodyNumber=ball)), ground],
        nodeNumber=mbs.AddNode(NodeGenericData(numberOfDataCoordinates=4, initialCoordinates=[0, 0, 0, 0])),
        radiusSphere=radius,
        torusMajorRadius=ring,
        torusMinorRadius=tube,
        torusAxis=[0, 0, 1],
        contactStiffness=1e6,
        contactDamping=1e3,
    )
)

floor = mbs.CreateGround(referencePosition=[3, 0, 0])
outline = [[0, 0], *([x + 0.1, height - x**2] for x in np.linspace(-0.1, 0.1, 21)), [0.2, 0]]
barrel = mbs.CreateRigidBody(
    referencePosition=[3, 0, bulge - (bulge - height) * np.cos(lean)],
    referenceRotationMatrix=RotationMatrixY(lean),
    inertia=inertia,
    gravity=[0, 0, -g],
    graphicsDataList=[
        graphics.SolidOfRevolution([-0.1, 0, 0], [1, 0, 0], outline, color=graphics.color.brown, nTiles=32)
    ],
)
mbs.CreateGenericJoint(bodyNumbers=[floor, barrel], position=[3, 0, 0.1], constrainedAxes=[0, 1, 0, 1, 0, 1])
mbs.AddObject(
    ObjectContactConvexRoll(
        markerNumbers=[
            mbs.AddMarker(MarkerBodyRigid(bodyNumber=floor)),
            mbs.AddMarker(MarkerBodyRigid(bodyNumber=barrel)),
        ],
        nodeNumber=mbs.AddNode(NodeGenericData(numberOfDataCoordinates=3, initialCoordinates=[0, 0, 0])),
        rollLength=0.2,
        coefficientsHull=[-1, 0, height],  # a parabola, whose radius in the middle is 1/2 m
        contactStiffness=1e6,
        contactDamping=1e3,
    )
)
position, rotation = exu.OutputVariableType.Position, exu.OutputVariableType.Rotation
way = mbs.AddSensor(SensorBody(bodyNumber=ball, outputVariableType=position, storeInternal=True))
pitch = mbs.AddSensor(SensorBody(bodyNumber=barrel, outputVariableType=rotation, storeInternal=True))
mbs.Assemble()

settings = exu.SimulationSettings()
settings.timeIntegration.endTime = 4
settings.timeIntegration.numberOfSteps = 4000
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.6
settings.solutionSettings.sensorsWritePeriod = 1e-3
settings.solutionSettings.solutionWritePeriod = settings.timeIntegration.endTime / 60
mbs.SolveDynamic(settings)


def period(values: np.ndarray, time: np.ndarray) -> float:
    """Twice the mean time between two passages through zero."""
    i = np.flatnonzero(values[:-1] * values[1:] < 0)
    passed = time[i] - values[i] * (time[i + 1] - time[i]) / (values[i + 1] - values[i])
    return 2 * (passed[-1] - passed[0]) / (len(passed) - 1)


time, x = mbs.GetSensorStoredData(way).T[:2]
print(f"period of the ball: {period(x, time):.4f} s, of a pendulum {2 * np.pi * np.sqrt(swing / g):.4f} s")
rocks = period(mbs.GetSensorStoredData(pitch)[:, 2], time)
expected = 2 * np.pi * np.sqrt(moment / (mass * g * (bulge - height)))
print(f"period of the barrel: {rocks:.4f} s, by its outline {expected:.4f} s")
mbs.PlotSensor(way, components=0, yLabel="way of the ball (m)", labels="ball", fileName="ring_way.png", closeAll=True)
shown = mbs.GetSystemContainer().visualizationSettings
shown.nodes.show = shown.markers.show = shown.connectors.show = shown.loads.show = False
mbs.Draw(fileName="ring_picture.png")
in_a_second = settings.timeIntegration.endTime / 3
mbs.DrawSolution(fileName="ring_motion.gif", windowSize=[420, 320], framesPerSecond=20, speed=in_a_second)
