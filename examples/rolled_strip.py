"""A strip of steel that is clamped at one end and rolled up by a moment at the other, to a closed ring.

A moment bends it to a circle: its curvature is the moment divided by the bending stiffness, along all of its length,
however far it bends.
"""

import numpy as np

import dalembert as exu
from dalembert.utilities import *

length, width, thickness, modulus = 1.0, 0.02, 0.5e-3, 2.1e11  # m, N/m^2
area, bending = width * thickness, modulus * width * thickness**3 / 12
ring = 2 * np.pi * bending / length  # Nm: the moment that closes it
elements = 8

mbs = exu.SystemContainer().AddSystem()
nodes = [mbs.AddNode(NodeRigidBody2D(referenceCoordinates=[x, 0, 0])) for x in np.linspace(0, length, 2 * elements + 1)]
for i in range(0, 2 * elements, 2):
    mbs.AddObject(
        Beam2D(
            nodeNumbers=nodes[i : i + 3],
            physicsLength=length / elements,
            physicsMassPerLength=7850 * area,
            physicsCrossSectionInertia=7850 * width * thickness**3 / 12,
            physicsBendingStiffness=bending,
            physicsAxialStiffness=modulus * area,
            physicsShearStiffness=modulus / 2.6 * 5 / 6 * area,
        )
    )
wall = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
for coordinate in range(3):
    held = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=nodes[0], coordinate=coordinate))
    mbs.AddObject(CoordinateConstraint(markerNumbers=[wall, held]))
end = mbs.AddMarker(MarkerNodeRigid(nodeNumber=nodes[-1]))
mbs.AddLoad(Torque(markerNumber=end, loadVector=[0, 0, ring]))
position = exu.OutputVariableType.Position
tip = mbs.AddSensor(SensorNode(nodeNumber=nodes[-1], outputVariableType=position, storeInternal=True))
middle = mbs.AddSensor(SensorNode(nodeNumber=nodes[elements], outputVariableType=position, storeInternal=True))
mbs.Assemble()

settings = exu.SimulationSettings()
settings.staticSolver.numberOfLoadSteps = 40
settings.solutionSettings.sensorsWritePeriod = 1 / 40
settings.solutionSettings.solutionWritePeriod = 1 / 40
mbs.SolveStatic(settings)

half = mbs.GetSensorStoredData(tip)[20]
print(f"height of the tip under half of the moment: {half[2]:.5f} m, of half a circle {2 * length / np.pi:.5f} m")
top = mbs.GetSensorStoredData(middle)[-1]
print(f"height of the middle under all of it: {top[2]:.5f} m, of a circle {length / np.pi:.5f} m")
mbs.PlotSensor(
    tip, componentsX=0, components=1, labels="tip", xLabel="x (m)", yLabel="y (m)", fileName="strip_tip.png",
    closeAll=True,
)  # fmt: skip
shown = mbs.GetSystemContainer().visualizationSettings
shown.nodes.show = shown.markers.show = shown.connectors.show = shown.loads.show = False
shown.sensors.traces.showPositionTrace = True
mbs.Draw(fileName="strip_picture.png")
mbs.DrawSolution(fileName="strip_motion.gif", windowSize=[420, 320], framesPerSecond=20, speed=1 / 2)
