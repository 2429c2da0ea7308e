"""A planar cable element chain as cantilever: bent statically by a force at its tip, then let go.

The bent shape is the elastica, whose tip is known in terms of elliptic integrals.
"""

from itertools import pairwise

import numpy as np
from scipy.optimize import brentq
from scipy.special import ellipe, ellipeinc, ellipk, ellipkinc

import dalembert as exu
from dalembert.utilities import *

length, elements = 2.0, 8
EI, EA, mass, force = 5.0, 1e4, 0.5, 3.0  # N m^2, N, kg/m, N


def elastica():
    """Displacement of the tip of an inextensible beam: components along the beam and along the force."""
    load = force * length**2 / EI

    def begin(m):
        """Amplitude at the clamp, for the parameter m = (1 + sin(angle of the tip)) / 2."""
        return np.arcsin(np.sqrt(0.5 / m))

    m = brentq(lambda m: ellipk(m) - ellipkinc(begin(m), m) - np.sqrt(load), 0.5 + 1e-12, 1 - 1e-12)
    across = 1 - 2 / np.sqrt(load) * (ellipe(m) - ellipeinc(begin(m), m))
    return (1 - np.sqrt((4 * m - 2) / load)) * length, across * length


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
            visualization=VObjectANCFCable2D(drawHeight=0.03),
        )
    )

# the clamp holds position and direction of the first node: three of its four coordinates
fixed = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
for coordinate in (0, 1, 3):
    moving = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=nodes[0], coordinate=coordinate))
    mbs.AddObject(ObjectConnectorCoordinate(markerNumbers=[fixed, moving]))

tip = mbs.AddMarker(MarkerNodePosition(nodeNumber=nodes[-1]))
load = mbs.AddLoad(LoadForceVector(markerNumber=tip, loadVector=[0, -force, 0]))
sensor = mbs.AddSensor(
    SensorNode(nodeNumber=nodes[-1], outputVariableType=exu.OutputVariableType.Displacement, storeInternal=True)
)
mbs.Assemble()

settings = exu.SimulationSettings()
settings.linearSolverType = exu.LinearSolverType.EigenSparse
settings.solutionSettings.writeSolutionToFile = False
settings.staticSolver.numberOfLoadSteps = 5
settings.staticSolver.verboseMode = 0
mbs.SolveStatic(settings, updateInitialValues=True)
for value, exact in zip(mbs.GetNodeOutput(nodes[-1], exu.OutputVariableType.Displacement), elastica(), strict=False):
    print(f"static displacement: {-value:.5f} m, elastica {exact:.5f} m")

SC = mbs.GetSystemContainer()
SC.visualizationSettings.contour.outputVariable = exu.OutputVariableType.TorqueLocal  # bending moment, as color
mbs.Draw(fileName="cantilever_picture.png")
mbs.SetLoadParameter(load, "loadVector", [0, 0, 0])
settings.timeIntegration.endTime = 3
settings.timeIntegration.numberOfSteps = 600
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.8
mbs.SolveDynamic(settings)
mbs.PlotSensor(
    sensor, components=[0, 1], yLabel="displacement of the tip (m)", fileName="cantilever.png", closeAll=True
)
print("displacement at the end", mbs.GetSensorValues(sensor)[:2])
