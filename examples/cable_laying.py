"""A ship lays a cable: a catenary between the sea bed and the stern, which heaves in the waves.

The cable starts on the bottom, with one end fixed; the other end is lifted to the surface and moved back to its final
position. The free part is a catenary: the tension at the stern is that at the bottom plus the weight of a cable whose
length is the depth of the sea. Then the ship heaves, and the touchdown point oscillates.
"""

import numpy as np

import dalembert as exu
from dalembert.beams import GenerateStraightLineANCFCable2D
from dalembert.utilities import *

length, elements, depth = 300.0, 60, 100.0  # m
weight, mass = 50.0, 8.0  # N/m under water, kg/m with the water that moves along
bending, stretching = 2e3, 2e7  # Nm^2, N
slack, heave, period = 33.0, 1.5, 8.0  # m, m, s
ground_stiffness, ground_damping = 2e3, 1e3  # N/m, Ns/m per node

mbs = exu.SystemContainer().AddSystem()
water = exu.graphics.Brick([150, depth, -2], [360, 0.4, 1], color=exu.graphics.color.dodgerblue)
bed = exu.graphics.Brick([150, -2, -2], [360, 4, 1], color=exu.graphics.color.brown)
mbs.CreateGround(graphicsDataList=[water, bed])
cable = Cable2D(
    physicsMassPerLength=mass,
    physicsBendingStiffness=bending,
    physicsAxialStiffness=stretching,
    physicsAxialDamping=1e5,
    physicsBendingDamping=200,
    visualization=VCable2D(drawHeight=1.0),
)
g = weight / mass  # gravity minus buoyancy in water
nodes, cables, *_ = GenerateStraightLineANCFCable2D(
    mbs, [0, 0, 0], [length, 0, 0], elements, cable, massProportionalLoad=[0, -g, 0], fixedConstraintsNode0=[1, 1, 0, 0]
)

fixed = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
for node in nodes[1:]:
    height = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=1))
    gap = mbs.AddNode(NodeGenericData(numberOfDataCoordinates=1, initialCoordinates=[0]))
    mbs.AddObject(
        ObjectContactCoordinate(
            markerNumbers=[fixed, height], nodeNumber=gap, contactStiffness=ground_stiffness,
            contactDamping=ground_damping,
        )
    )  # fmt: skip

heaves = False


def stern(coordinate):
    """Motion of the end of the cable: first to its position, then up and down with the waves."""
    place = -slack if coordinate == 0 else depth

    def offset(mbs, t, item, value):
        if not heaves:
            return place * (t * t if coordinate == 0 else t)
        return place + (heave * np.sin(2 * np.pi * t / period) * min(1.0, t / period) if coordinate == 1 else 0.0)

    return offset


held = [mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=nodes[-1], coordinate=k)) for k in range(2)]
ends = [
    mbs.AddObject(CoordinateConstraint(markerNumbers=[fixed, held[k]], offsetUserFunction=stern(k))) for k in range(2)
]
force = exu.OutputVariableType.Force
pulls = [mbs.AddSensor(SensorObject(objectNumber=end, outputVariableType=force, storeInternal=True)) for end in ends]
mbs.Assemble()

settings = exu.SimulationSettings()
settings.solutionSettings.writeSolutionToFile = False
settings.solutionSettings.sensorsWritePeriod = 0.05
settings.staticSolver.numberOfLoadSteps = 100
settings.staticSolver.verboseMode = 0
settings.timeIntegration.verboseMode = 0
mbs.SolveStatic(settings, updateInitialValues=True)

at = lambda node: mbs.GetNodeOutput(node, exu.OutputVariableType.Position)  # noqa: E731
horizontal, vertical = (abs(mbs.GetObjectOutput(end, force)) for end in ends)
pull, bottom = np.hypot(horizontal, vertical), horizontal
hanging = np.sqrt(depth**2 + 2 * depth * bottom / weight)
touches = next(i for i, node in enumerate(nodes) if at(node)[1] > 0)  # the first that does not touch
print(f"pull at the stern: {pull / 1e3:.4f} kN, catenary {(bottom + weight * depth) / 1e3:.4f} kN")
print(f"weight that the stern carries: {vertical / 1e3:.4f} kN, catenary {weight * hanging / 1e3:.4f} kN")
print(f"the cable touches the ground about {touches * length / elements:.0f} m from its begin")

heaves = True
settings.timeIntegration.endTime = 40
settings.timeIntegration.numberOfSteps = 2000
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.6
mbs.SolveDynamic(settings)
told = [mbs.GetSensorStoredData(sensor) for sensor in pulls]
history = np.column_stack([told[0][:, 0], np.hypot(told[0][:, 1], told[1][:, 1]) / 1e3])
swell = history[history[:, 0] > 2 * period, 1]
print(f"pull while the ship heaves by {heave} m: {swell.min():.2f} to {swell.max():.2f} kN")
mbs.PlotSensor([history], components=[0], yLabel="pull at the stern (kN)", fileName="cable_pull.png", closeAll=True)
SC = mbs.GetSystemContainer()
shown = SC.visualizationSettings
shown.nodes.show = shown.markers.show = shown.loads.show = shown.connectors.show = shown.sensors.show = False
shown.contour.outputVariable = exu.OutputVariableType.ForceLocal  # tension, as color
mbs.Draw(fileName="cable_laying_picture.png")
