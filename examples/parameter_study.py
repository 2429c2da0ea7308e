"""A wheel suspension over a thousand dampers and springs: overshoot after a step of the road.

All variations are solved by compiled code on all processors at once.
"""

import numpy as np

import dalembert as exu
from dalembert.utilities import *

mass, static, step = 400, 0.2, 0.05  # kg; m of deflection at rest; m
dampingRatios, frequencies = np.linspace(0.05, 0.8, 50), np.linspace(1, 3, 20)  # ratio, Hz

# one model: a mass that is guided vertically, spring and damper below it
mbs = exu.SystemContainer().AddSystem()
node = mbs.AddNode(Node1D(referenceCoordinates=[0]))
angles = np.linspace(0, 12 * np.pi, 200)
coil = graphics.Lines(np.column_stack([angles / angles[-1] * 0.7 - 0.6, 0.1 * np.cos(angles), 0.1 * np.sin(angles)]))
shapes = [coil, graphics.Brick([0.25, 0, 0], [0.3, 0.6, 0.6], color=graphics.color.dodgerblue)]
mbs.AddObject(
    Mass1D(
        nodeNumber=node,
        physicsMass=mass,
        referencePosition=[0, 0, 0.6],  # position in pictures, with the coordinate upwards
        referenceRotation=RotationMatrixY(-np.pi / 2),
        visualization=VMass1D(graphicsData=shapes),
    )
)
mbs.CreateGround(graphicsDataList=[graphics.CheckerBoard(size=2)])
road = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
body = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
suspension = mbs.AddObject(CoordinateSpringDamper(markerNumbers=[road, body], stiffness=1, damping=1, offset=step))
height = mbs.AddSensor(
    SensorNode(nodeNumber=node, outputVariableType=exu.OutputVariableType.Coordinates, storeInternal=True)
)
mbs.Assemble()
mbs.Draw(fileName="parameter_study_picture.png", view="axonometric")

settings = exu.SimulationSettings()
settings.timeIntegration.endTime = 2  # s
settings.timeIntegration.numberOfSteps = 2000
settings.solutionSettings.sensorsWritePeriod = 0.002

# a row per variation: every damping ratio with every frequency
ratio, frequency = (grid.ravel() for grid in np.meshgrid(dampingRatios, frequencies, indexing="ij"))
stiffness = mass * (2 * np.pi * frequency) ** 2
damping = 2 * ratio * np.sqrt(stiffness * mass)
results = mbs.SolveVariations(
    {(suspension, "stiffness"): stiffness, (suspension, "damping"): damping}, settings, storeHistories=True
)

highest = results.sensorHistories[:, :, 1].max(axis=1)
overshoot = 100 * (highest / step - 1)
exact = 100 * np.exp(-np.pi * ratio / np.sqrt(1 - ratio**2))
for k in (0, 500):
    print(
        f"overshoot with {frequency[k]:.1f} Hz and damping ratio {ratio[k]:.3f}: {overshoot[k]:.2f} %, "
        f"according to theory {exact[k]:.3f} %"
    )

mbs.PlotSensor(
    sensorNumbers=[results.SensorHistory(k, height) for k in (20 * 5 + 2, 20 * 15 + 2, 20 * 35 + 2)],
    labels=[f"damping ratio {ratio[k]:.2f}" for k in (20 * 5 + 2, 20 * 15 + 2, 20 * 35 + 2)],
    yLabel="height (m)",
    fileName="step_responses.png",
)
