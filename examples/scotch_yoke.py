"""A Scotch yoke: a crank that turns evenly moves a sliding yoke as a cosine, without any connecting rod.

The pin of the crank carries a block, which slides up and down in the slot of the yoke; the yoke slides along x. A
coordinate constraint drives the angle between ground and crank. Forces are those of m r w^2 cos(w t) of the yoke; the
motor gives and takes its work.
"""

import numpy as np

import dalembert as exu
from dalembert.utilities import *

radius, speed, mass = 0.1, 20.0, 3.0  # m, rad/s, kg of the yoke
end = 2 * np.pi / speed

mbs = exu.SystemContainer().AddSystem()
small = InertiaCuboid(7800, [0.02, 0.02, 0.01])
yokeShape = [
    graphics.Brick([x, 0, -0.02], [0.02, 0.3, 0.01], color=graphics.color.steelblue) for x in (-0.02, 0.02)
] + [graphics.Brick([0.15, 0, -0.02], [0.24, 0.02, 0.01], color=graphics.color.steelblue)]
ground = mbs.CreateGround("ground")
crank = mbs.CreateRigidBody(
    "crank",
    referencePosition=[0, 0, 0],
    inertia=InertiaCuboid(7800, [0.2, 0.02, 0.01]),
    create2D=True,
    graphicsDataList=[graphics.Brick([0.5 * radius, 0, 0], [radius + 0.02, 0.03, 0.01], color=graphics.color.orange)],
)
block = mbs.CreateRigidBody(
    "block", referencePosition=[radius, 0, 0], inertia=small, create2D=True,
    graphicsDataList=[graphics.Brick(size=[0.02, 0.03, 0.03], color=graphics.color.grey)],
)  # fmt: skip
yoke = mbs.CreateRigidBody(
    "yoke", referencePosition=[radius, 0, 0], inertia=InertiaCuboid(mass / 6e-4, [0.2, 0.3, 0.01]), create2D=True,
    graphicsDataList=yokeShape,
)  # fmt: skip


def at(body, place=(0, 0, 0)):
    return mbs.AddMarker(MarkerBodyRigid(bodyNumber=body, localPosition=place))


mbs.AddObject(RevoluteJoint2D(markerNumbers=[at("ground"), at("crank")]))
mbs.AddObject(RevoluteJoint2D(markerNumbers=[at("crank", [radius, 0, 0]), at("block")]))
slot = PrismaticJoint2D("slot", markerNumbers=[at("yoke"), at("block")], axisMarker0=[0, 1, 0], normalMarker1=[1, 0, 0])
guide = PrismaticJoint2D(
    "guide", markerNumbers=[at("ground"), at("yoke")], axisMarker0=[1, 0, 0], normalMarker1=[0, 1, 0]
)
mbs.AddObject(slot)
mbs.AddObject(guide)

turns = mbs.AddNode(NodeGenericData(numberOfDataCoordinates=1, initialCoordinates=[0]))  # counts them
angle = mbs.AddMarker(
    MarkerBodiesRelativeRotationCoordinate(bodyNumbers=["ground", "crank"], nodeNumber=turns, axis0=[0, 0, 1])
)
slide = mbs.AddMarker(MarkerBodiesRelativeTranslationCoordinate(bodyNumbers=["ground", "yoke"], axis0=[1, 0, 0]))
fixed = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
motor = mbs.AddObject(
    CoordinateConstraint(
        "motor", markerNumbers=[fixed, angle], offset=0, offsetUserFunction=lambda mbs, t, item, offset: speed * t
    )
)
mbs.AddSensor(SensorMarker("way", markerNumber=slide, outputVariableType=exu.OutputVariableType.Coordinates,
                           storeInternal=True))  # fmt: skip
mbs.AddSensor(SensorObject("torque", objectNumber="motor", outputVariableType=exu.OutputVariableType.Force,
                           storeInternal=True))  # fmt: skip
for node, velocity in (("Node:crank", [0, 0, speed]), ("Node:block", [0, radius * speed, 0])):
    mbs.SetNodeParameter(node, "initialVelocities", velocity)
mbs.Assemble()

settings = exu.SimulationSettings()
settings.timeIntegration.endTime = end
settings.timeIntegration.numberOfSteps = 2000
settings.solutionSettings.solutionWritePeriod = settings.timeIntegration.endTime / 60
settings.solutionSettings.sensorsWritePeriod = end / 200
mbs.SolveDynamic(settings)

time, way = mbs.GetSensorStoredData("way").T
torque = np.abs(mbs.GetSensorStoredData("torque")[:, 1]).max()
print(f"way of the yoke: {np.ptp(way):.6f} m, two radii {2 * radius:.6f} m")
print(f"largest torque: {torque:.4f} Nm, that of a cosine {0.5 * mass * radius**2 * speed**2:.4f} Nm")
mbs.PlotSensor(["way"], yLabel="way of the yoke (m)", fileName="yoke_way.png", closeAll=True)
shown = mbs.GetSystemContainer().visualizationSettings
shown.nodes.show = shown.markers.show = shown.sensors.show = shown.connectors.show = False
mbs.Draw(fileName="yoke_picture.png", view="axonometric")
in_a_second = settings.timeIntegration.endTime / 3
mbs.DrawSolution(
    fileName="yoke_motion.gif", windowSize=[420, 320], framesPerSecond=20, speed=in_a_second, view="axonometric"
)
