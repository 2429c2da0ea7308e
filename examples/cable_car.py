"""A cabin is clipped to a hauling rope, which runs at a constant speed over its span and carries it along.

The rope consists of cable elements through which the material moves; one coordinate is its displacement. The cabin
hangs
on a joint that moves with the material. The sag of a rope with tension T in the middle of the span is F L / (4 T) under
the weight F of the cabin, and m g L^2 / (8 T) under its own weight.
"""

import numpy as np

import dalembert as exu
from dalembert.utilities import *

span, tension, weight, g = 60.0, 40e3, 3000.0, 9.81  # m, N, N, m/s^2
mass, axial, elements = 0.8, 4e5, 20  # kg/m, N, 1
end = 10.0  # s

mbs = exu.SystemContainer().AddSystem()
towers = [graphics.Brick([x, -3, 0], [0.8, 6, 0.8], color=graphics.color.grey) for x in (-0.4, span + 0.4)]
mbs.CreateGround(graphicsDataList=towers)
haul = mbs.AddNode(
    NodeGenericODE2(
        numberOfODE2Coordinates=1, referenceCoordinates=[0], initialCoordinates=[0], initialCoordinates_t=[0]
    )
)
rope = ALECable2D(
    physicsMassPerLength=mass,
    physicsBendingStiffness=20,
    physicsAxialStiffness=axial,
    physicsReferenceAxialStrain=-tension / axial,
    physicsAxialDamping=1e3,
    nodeNumbers=[-1, -1, haul],
    visualization=VALECable2D(drawHeight=0.2),
)
nodes, cables, *_ = GenerateStraightLineANCFCable2D(
    mbs, [0, 0, 0], [span, 0, 0], elements, rope, massProportionalLoad=[0, -g, 0],
    fixedConstraintsNode0=[1, 1, 0, 0], fixedConstraintsNode1=[1, 1, 0, 0],
)  # fmt: skip
fixed = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
hauled = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=haul, coordinate=0))
first = 1.5 * span / elements  # position of boarding
middle = 0.5 * span - first  # m, the way of the cabin


def drive(mbs, t, item, offset):
    """Return the way of the rope, which is driven to the middle of the span and waits there."""
    return SmoothStep(t, 0, end, 0, middle) if travels else 0.0


travels = False
mbs.AddObject(CoordinateConstraint(markerNumbers=[fixed, hauled], offsetUserFunction=drive))
markers = [mbs.AddMarker(MarkerBodyCable2DCoordinates(bodyNumber=cable)) for cable in cables]
mbs.CreateMassPoint(
    "cabin", referencePosition=[first, 0, 0], physicsMass=weight / g, gravity=[0, -g, 0], create2D=True,
    graphicsDataList=[graphics.Brick([0, -1.2, 0], [1.6, 1.6, 1], color=graphics.color.orange)],
)  # fmt: skip
clip = mbs.AddMarker(MarkerBodyPosition(bodyNumber="cabin"))
element = mbs.AddNode(NodeGenericData(numberOfDataCoordinates=1, initialCoordinates=[1]))
mbs.AddObject(
    ALEMovingJoint2D(
        "clip", markerNumbers=[clip, markers[1]], slidingMarkerNumbers=markers, nodeNumbers=[element, haul],
        slidingMarkerOffsets=[span / elements * i for i in range(elements)], slidingOffset=first,
    )
)  # fmt: skip
mbs.AddSensor(
    SensorBody("cabin", bodyNumber="cabin", outputVariableType=exu.OutputVariableType.Position, storeInternal=True)
)
mbs.Assemble()

settings = exu.SimulationSettings()
settings.staticSolver.numberOfLoadSteps = 5
mbs.SolveStatic(settings, updateInitialValues=True)
travels = True
settings.timeIntegration.endTime = 1.5 * end
settings.timeIntegration.numberOfSteps = 600
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.5
settings.solutionSettings.solutionWritePeriod = settings.timeIntegration.endTime / 60
settings.solutionSettings.sensorsWritePeriod = 0.02
mbs.SolveDynamic(settings)

place = mbs.GetObjectOutputBody("cabin", exu.OutputVariableType.Position)
pull = np.linalg.norm(mbs.GetObjectOutputBody(cables[0], exu.OutputVariableType.ForceLocal, [0, 0, 0]))
sag = weight * span / (4 * pull) + mass * g * span**2 / (8 * pull)
print(f"way of the cabin: {place[0] - first:.4f} m, of the rope {middle:.4f} m")
print(f"sag in the middle: {-place[1]:.4f} m, of a rope with this tension {sag:.4f} m")
mbs.PlotSensor(
    "cabin", componentsX=0, components=1, xLabel="x (m)", yLabel="height (m)", labels="cabin", fileName="car_way.png",
    closeAll=True,
)  # fmt: skip
shown = mbs.GetSystemContainer().visualizationSettings
shown.nodes.show = shown.markers.show = shown.connectors.show = shown.loads.show = shown.sensors.show = False
mbs.Draw(fileName="car_picture.png", view="front")
in_a_second = settings.timeIntegration.endTime / 3
mbs.DrawSolution(fileName="car_motion.gif", windowSize=[420, 320], framesPerSecond=20, speed=in_a_second, view="front")
