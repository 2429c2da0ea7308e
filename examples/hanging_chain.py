"""A hanging chain of forty links, as a kinematic tree: oscillations, compared with Bessel's solution for ropes.

A tree needs one coordinate per link and no constraints. Small motions of a rope that hangs from one end have the
frequencies j sqrt(g / L) / 2, j being the zeros of the Bessel function J0; links of finite length come close. Then the
chain is released from an inclined position.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.special import jn_zeros

import dalembert as db
from dalembert.utilities import HTtranslateX, InertiaCuboid, TreeLink

links, length, density, g = 40, 2.0, 1.5, 9.81  # 1, m, kg/m, m/s^2
size = length / links
start = 0.6  # rad

model = db.Model()
bar = InertiaCuboid(density / (0.02 * 0.02), [size, 0.02, 0.02]).Translated([0.5 * size, 0, 0])
chain = [
    TreeLink(linkInertia=bar, jointType=db.JointType.RevoluteZ, jointHT=HTtranslateX(0 if i == 0 else size))
    for i in range(links)
]
tree = model.create_kinematic_tree(
    "chain", chain, reference_coordinates=[-np.pi / 2] + [0] * (links - 1), gravity=[0, -g, 0], joint_radius=0.008,
    joint_width=0.02, colors=db.graphics.color.steelblue,
    base_graphics_data_list=[db.graphics.Brick(size=[0.3, 0.02, 0.1])],
)  # fmt: skip
end = model.add(
    db.SensorKinematicTree(
        objectNumber=tree, linkNumber=links - 1, localPosition=[size, 0, 0], storeInternal=True,
        outputVariableType=db.OutputVariableType.Position,
    )
)  # fmt: skip
model.assemble()

values, _ = model.system.ComputeODE2Eigenvalues(computeComplexEigenvalues=False)
found = np.sqrt(values) / (2 * np.pi)
for name, frequency, zero in zip(("first", "second", "third"), found[:3], jn_zeros(0, 3), strict=True):
    theory = 0.5 * zero * np.sqrt(g / length) / (2 * np.pi)
    print(f"{name} frequency: {frequency:.5f} Hz, of a rope {theory:.5f} Hz")

model["Node:chain"].initial_coordinates = [start] + [0] * (links - 1)
solution = model.solve(end_time=2, step_size=2e-3)
plt.plot(end.values[:, 0], end.values[:, 1])
plt.gca().set(xlabel="x of the lower end (m)", ylabel="y (m)")
plt.savefig("chain_end.png")
shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = False
shown.sensors.traces.showPositionTrace = True
model.draw(file_name="chain_picture.png", view="front")
solution.animate(file_name="chain_motion.gif", window_size=[420, 320], frames_per_second=20, speed=2 / 3, view="front")
