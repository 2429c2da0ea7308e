"""A planar cable element chain as cantilever: bent statically by a force at its tip, then let go."""

from itertools import pairwise

import dalembert as exu
from dalembert.utilities import *

length, elements = 2.0, 8
EI, EA, mass = 5.0, 1e4, 0.5  # N m^2, N, kg/m

mbs = exu.SystemContainer().AddSystem()
ground = mbs.CreateGround()

h = length / elements
nodes = [mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[i * h, 0, 1, 0])) for i in range(elements + 1)]
for left, right in pairwise(nodes):
    mbs.AddObject(
        ObjectANCFCable2D(
            nodeNumbers=[left, right],
            physicsLength=h,
            physicsMassPerLength=mass,
            physicsBendingStiffness=EI,
            physicsBendingDamping=0.02,
            physicsAxialStiffness=EA,
        )
    )

# the clamp holds position and direction of the first node: three of its four coordinates
fixed = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
for coordinate in (0, 1, 3):
    moving = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=nodes[0], coordinate=coordinate))
    mbs.AddObject(ObjectConnectorCoordinate(markerNumbers=[fixed, moving]))

tip = mbs.AddMarker(MarkerNodePosition(nodeNumber=nodes[-1]))
load = mbs.AddLoad(LoadForceVector(markerNumber=tip, loadVector=[0, -3, 0]))
sensor = mbs.AddSensor(
    SensorNode(nodeNumber=nodes[-1], outputVariableType=exu.OutputVariableType.Displacement, storeInternal=True)
)
mbs.Assemble()

settings = exu.SimulationSettings()
settings.linearSolverType = exu.LinearSolverType.EigenSparse
settings.solutionSettings.writeSolutionToFile = False
settings.staticSolver.numberOfLoadSteps = 5
mbs.SolveStatic(settings, updateInitialValues=True)
print("static", mbs.GetNodeOutput(nodes[-1], exu.OutputVariableType.Displacement))

mbs.SetLoadParameter(load, "loadVector", [0, 0, 0])
settings.timeIntegration.endTime = 3
settings.timeIntegration.numberOfSteps = 600
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.8
mbs.SolveDynamic(settings)
mbs.PlotSensor(
    sensor, components=[0, 1], yLabel="displacement of the tip (m)", fileName="cantilever.png", closeAll=True
)
print("end", mbs.GetSensorValues(sensor))
