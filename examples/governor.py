"""A centrifugal governor of Watt and Porter: the sleeve on its spindle rises with the speed.

Two arms with balls hang on the spindle; links lift the sleeve, whose weight increases the required speed. The height
of the
cone of the arms is (1 + M / m) g / w^2, with the masses M of the sleeve and m of a ball, independently of the length
of the arms.
"""

import numpy as np

import dalembert as exu
from dalembert.utilities import *

arm, ball, sleeve, g = 0.3, 1.0, 4.0, 9.81  # m, kg, kg, m/s^2
speeds = [15.0, 20.0]  # rad/s
ramp, rest = 0.5, 2.5  # s
height = (1 + sleeve / ball) * g / speeds[0] ** 2  # height of the cone, from the pivots down to the balls
angle = np.arccos(height / arm)

mbs = exu.SystemContainer().AddSystem()
mbs.CreateGround("ground", graphicsDataList=[graphics.Cylinder([0, 0, -0.7], [0, 0, 0.05], 0.15, graphics.color.grey)])
spindle = mbs.CreateRigidBody(
    "spindle",
    initialAngularVelocity=[0, 0, speeds[0]],
    inertia=InertiaCylinder(7800, 0.7, 0.01, axis=2),
    nodeType=exu.NodeType.RotationRxyz,
    graphicsDataList=[graphics.Cylinder([0, 0, -0.65], [0, 0, 0.7], 0.01, color=graphics.color.grey)],
)
mbs.CreateRevoluteJoint(bodyNumbers=["ground", "spindle"], position=[0, 0, 0], axis=[0, 0, 1], show=False)
place = [0, 0, -2 * height]
mbs.CreateRigidBody(
    "sleeve",
    referencePosition=place,
    initialAngularVelocity=[0, 0, speeds[0]],
    inertia=InertiaCylinder(sleeve / (np.pi * 0.04**2 * 0.06), 0.06, 0.04, axis=2),
    gravity=[0, 0, -g],
    graphicsDataList=[graphics.Cylinder([0, 0, -0.03], [0, 0, 0.06], 0.04, color=graphics.color.steelblue)],
)
mbs.CreatePrismaticJoint("guide", ["spindle", "sleeve"], position=place, axis=[0, 0, 1], show=False)
for side in (1, -1):
    name, direction = f"arm {side}", np.array([side * np.sin(angle), 0, -np.cos(angle)])
    mbs.CreateRigidBody(
        name,
        referencePosition=arm * direction,
        referenceRotationMatrix=RotationMatrixY(-side * angle),
        initialVelocity=np.cross([0, 0, speeds[0]], arm * direction),
        initialAngularVelocity=[0, 0, speeds[0]],
        inertia=InertiaSphere(ball, 1e-3),  # of points
        gravity=[0, 0, -g],
        graphicsDataList=[
            graphics.Sphere(radius=0.05, color=graphics.color.orange, nTiles=24),
            graphics.Cylinder([0, 0, 0], [0, 0, arm], 0.008, color=graphics.color.grey),
        ],
    )
    mbs.CreateRevoluteJoint(bodyNumbers=["spindle", name], position=[0, 0, 0], axis=[0, 1, 0], show=False)
    mbs.CreateDistanceConstraint(bodyNumbers=[name, "sleeve"], drawSize=0.008)


def motor(mbs, t, itemNumber, offset):
    """Return the angle of the spindle, whose speed grows between two spells of rest."""
    u = np.clip(t - rest, 0, ramp)
    gained = (speeds[1] - speeds[0]) * (0.5 * u**2 / ramp + max(0.0, t - rest - ramp))
    return speeds[0] * t + gained


fixed = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
turns = mbs.AddNode(NodeGenericData(numberOfDataCoordinates=1, initialCoordinates=[0]))
angle = mbs.AddMarker(
    MarkerBodiesRelativeRotationCoordinate(bodyNumbers=["ground", "spindle"], nodeNumber=turns, axis0=[0, 0, 1])
)
mbs.AddObject(CoordinateConstraint(markerNumbers=[fixed, angle], offsetUserFunction=motor))
lift = mbs.AddMarker(MarkerBodiesRelativeTranslationCoordinate(bodyNumbers=["spindle", "sleeve"], axis0=[0, 0, 1]))
mbs.AddObject(CoordinateSpringDamper(markerNumbers=[fixed, lift], damping=40))  # damping of the oil in the sleeve
mbs.AddSensor(
    SensorMarker("lift", markerNumber=lift, outputVariableType=exu.OutputVariableType.Coordinates, storeInternal=True)
)
mbs.Assemble()

settings = exu.SimulationSettings()
settings.timeIntegration.endTime = rest + ramp + 2.0
settings.timeIntegration.numberOfSteps = 2000
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.8
settings.solutionSettings.solutionWritePeriod = settings.timeIntegration.endTime / 60
settings.solutionSettings.sensorsWritePeriod = 5e-3
mbs.SolveDynamic(settings)

time, way = mbs.GetSensorStoredData("lift").T
for speed, at in zip(speeds, (np.interp(rest, time, way), way[-1]), strict=True):
    theory = (1 + sleeve / ball) * g / speed**2
    print(f"height of the cone at {speed:.0f} rad/s: {-0.5 * at:.5f} m, Porter {theory:.5f} m")
mbs.PlotSensor(
    ["lift"], yLabel="place of the sleeve (m)", labels="sleeve", fileName="governor_sleeve.png", closeAll=True
)
shown = mbs.GetSystemContainer().visualizationSettings
shown.nodes.show = shown.markers.show = shown.loads.show = shown.sensors.show = False
mbs.Draw(fileName="governor_picture.png", view="axonometric")
in_a_second = settings.timeIntegration.endTime / 3
mbs.DrawSolution(
    fileName="governor_motion.gif", windowSize=[420, 320], framesPerSecond=20, speed=in_a_second, view="axonometric"
)
