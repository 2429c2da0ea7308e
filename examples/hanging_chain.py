"""A hanging chain of forty links, as a kinematic tree: oscillations, compared with Bessel's solution for ropes.

A tree needs one coordinate per link and no constraints. Small motions of a rope that hangs from one end have the
frequencies j sqrt(g / L) / 2, j being the zeros of the Bessel function J0; links of finite length come close. Then
the chain is released from an inclined position.
"""

import numpy as np
from scipy.special import jn_zeros

import dalembert as exu
from dalembert.utilities import *

links, length, density, g = 40, 2.0, 1.5, 9.81  # 1, m, kg/m, m/s^2
size = length / links
start = 0.6  # rad

mbs = exu.SystemContainer().AddSystem()
bar = InertiaCuboid(density / (0.02 * 0.02), [size, 0.02, 0.02]).Translated([0.5 * size, 0, 0])
chain = [
    TreeLink(linkInertia=bar, jointType=exu.JointType.RevoluteZ, jointHT=HTtranslateX(0 if i == 0 else size))
    for i in range(links)
]
tree = mbs.CreateKinematicTree(
    "chain", chain, referenceCoordinates=[-np.pi / 2] + [0] * (links - 1), gravity=[0, -g, 0], jointRadius=0.008,
    jointWidth=0.02, colors=graphics.color.steelblue, baseGraphicsDataList=[graphics.Brick(size=[0.3, 0.02, 0.1])],
)  # fmt: skip
end = mbs.AddSensor(
    SensorKinematicTree(
        objectNumber=tree, linkNumber=links - 1, localPosition=[size, 0, 0], storeInternal=True,
        outputVariableType=exu.OutputVariableType.Position,
    )
)  # fmt: skip
mbs.Assemble()

values, _ = mbs.ComputeODE2Eigenvalues(computeComplexEigenvalues=False)
found = np.sqrt(values) / (2 * np.pi)
for name, frequency, zero in zip(("first", "second", "third"), found[:3], jn_zeros(0, 3), strict=True):
    theory = 0.5 * zero * np.sqrt(g / length) / (2 * np.pi)
    print(f"{name} frequency: {frequency:.5f} Hz, of a rope {theory:.5f} Hz")

mbs.SetNodeParameter("Node:chain", "initialCoordinates", [start] + [0] * (links - 1))
mbs.Assemble()
settings = exu.SimulationSettings()
settings.timeIntegration.endTime = 2.0
settings.timeIntegration.numberOfSteps = 1000
settings.solutionSettings.solutionWritePeriod = settings.timeIntegration.endTime / 60
mbs.SolveDynamic(settings)
mbs.PlotSensor(
    end, componentsX=0, components=1, xLabel="x (m)", yLabel="y (m)", labels="lower end", fileName="chain_end.png",
    closeAll=True,
)  # fmt: skip
shown = mbs.GetSystemContainer().visualizationSettings
shown.nodes.show = shown.markers.show = False
shown.sensors.traces.showPositionTrace = True
mbs.Draw(fileName="chain_picture.png", view="front")
in_a_second = settings.timeIntegration.endTime / 3
mbs.DrawSolution(
    fileName="chain_motion.gif", windowSize=[420, 320], framesPerSecond=20, speed=in_a_second, view="front"
)
