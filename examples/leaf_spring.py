"""A leaf spring of one curved leaf: an axle pushes its middle up.

Its left eye turns on a pin, its right one slides. The forged arc is stress-free. Its stiffness for small loads is
that of a curved bar (Castigliano's theorem); as it
flattens, its eyes move apart, and it becomes softer.
"""

import numpy as np

import dalembert as exu
from dalembert.beams import GenerateCircularArcANCFCable2D
from dalembert.utilities import *

radius, half = 1.5, 0.45  # m; rad, from the middle to an eye
width, height, young = 0.07, 0.012, 2.06e11  # m, m, N/m^2
EI = young * width * height**3 / 12
elements, axle_load, steps = 16, 4000.0, 20  # N

mbs = exu.SystemContainer().AddSystem()
leaf = Cable2D(
    physicsMassPerLength=7850 * width * height,
    physicsBendingStiffness=EI,
    physicsAxialStiffness=young * width * height,
    visualization=VCable2D(drawHeight=height),
)
# from the left eye down to the middle and up again: an arc around a center above
eye = [-radius * np.sin(half), 0, 0]
nodes, *_ = GenerateCircularArcANCFCable2D(mbs, eye, radius, -half, 2 * half, elements, leaf)

fixed = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
for node, coordinate in ((nodes[0], 0), (nodes[0], 1), (nodes[-1], 1)):
    held = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=coordinate))
    mbs.AddObject(ObjectConnectorCoordinate(markerNumbers=[fixed, held]))
middle = nodes[elements // 2]
mbs.AddLoad(Force(markerNumber=mbs.AddMarker(MarkerNodePosition(nodeNumber=middle)), loadVector=[0, axle_load, 0]))
sensors = [
    mbs.AddSensor(SensorNode(nodeNumber=n, outputVariableType=exu.OutputVariableType.Displacement, storeInternal=True))
    for n in (middle, nodes[-1])
]
mbs.Assemble()

settings = exu.SimulationSettings()
settings.solutionSettings.writeSolutionToFile = False
settings.solutionSettings.sensorsWritePeriod = 1 / steps
settings.staticSolver.numberOfLoadSteps = steps
settings.staticSolver.verboseMode = 0
mbs.SolveStatic(settings)
travel, apart = (mbs.GetSensorStoredData(sensor) for sensor in sensors)

sine = np.sin(half)
bending = half * sine**2 - 2 * sine * (1 - np.cos(half)) + half / 2 - np.sin(2 * half) / 4
theory = 2 * EI / (radius**3 * bending)
load, lift = axle_load * travel[:, 0], travel[:, 2]
start = 2 * load[1] / lift[1] - load[2] / lift[2]  # extrapolated to zero load from two small loads
print(f"stiffness without load: {start / 1e3:.3f} kN/m, curved bar {theory / 1e3:.3f} kN/m")
last = (load[-1] - load[-2]) / (lift[-1] - lift[-2])
raised, spread = 1e3 * lift[-1], 1e3 * apart[-1, 1]
print(f"with {axle_load / 1e3:.0f} kN: axle up {raised:.1f} mm, eyes apart {spread:.1f} mm, {last / 1e3:.1f} kN/m")

SC = mbs.GetSystemContainer()
SC.visualizationSettings.nodes.show = SC.visualizationSettings.markers.show = False
SC.visualizationSettings.contour.outputVariable = exu.OutputVariableType.TorqueLocal  # bending moment, as color
mbs.Draw(fileName="leaf_spring_picture.png")
