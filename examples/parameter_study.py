"""A wheel suspension over a thousand dampers and springs: overshoot after a step of the road.

All variations are solved by compiled code on all processors at once.
"""

import matplotlib.pyplot as plt
import numpy as np

import dalembert as db
from dalembert.utilities import RotationMatrixY

mass, static, step = 400, 0.2, 0.05  # kg; m of deflection at rest; m
damping_ratios, frequencies = np.linspace(0.05, 0.8, 50), np.linspace(1, 3, 20)  # ratio, Hz

# one model: a mass that is guided vertically, spring and damper below it
model = db.Model()
node = model.add(db.Node1D(referenceCoordinates=[0]))
angles = np.linspace(0, 12 * np.pi, 200)
coil = db.graphics.Lines(np.column_stack([angles / angles[-1] * 0.7 - 0.6, 0.1 * np.cos(angles), 0.1 * np.sin(angles)]))
shapes = [coil, db.graphics.Brick([0.25, 0, 0], [0.3, 0.6, 0.6], color=db.graphics.color.dodgerblue)]
model.add(
    db.Mass1D(
        nodeNumber=node,
        physicsMass=mass,
        referencePosition=[0, 0, 0.6],  # position in pictures, with the coordinate upwards
        referenceRotation=RotationMatrixY(-np.pi / 2),
        visualization=db.VMass1D(graphicsData=shapes),
    )
)
model.create_ground("road", graphics_data_list=[db.graphics.CheckerBoard(size=2)])
road = model.add(db.MarkerNodeCoordinate(nodeNumber=model.add(db.NodePointGround()), coordinate=0))
body = model.add(db.MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
suspension = model.add(db.CoordinateSpringDamper(markerNumbers=[road, body], stiffness=1, damping=1, offset=step))
height = model.create_sensor(node, "coordinates")
model.draw(file_name="parameter_study_picture.png", view="axonometric")

settings = db.SimulationSettings()
settings.timeIntegration.endTime = 2  # s
settings.timeIntegration.numberOfSteps = 2000
settings.solutionSettings.sensorsWritePeriod = 0.002

# a row per variation: every damping ratio with every frequency
ratio, frequency = (grid.ravel() for grid in np.meshgrid(damping_ratios, frequencies, indexing="ij"))
stiffness = mass * (2 * np.pi * frequency) ** 2
damping = 2 * ratio * np.sqrt(stiffness * mass)
results = model.system.SolveVariations(
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

for k in (20 * 5 + 2, 20 * 15 + 2, 20 * 35 + 2):
    plt.plot(*results.SensorHistory(k, height).T, label=f"damping ratio {ratio[k]:.2f}")
plt.gca().set(xlabel="time (s)", ylabel="height (m)")
plt.legend()
plt.savefig("step_responses.png")
