"""A leaf spring of one curved leaf: an axle pushes its middle up.

Its left eye turns on a pin, its right one slides. The forged arc is stress-free. Its stiffness for small loads is that
of a curved bar (Castigliano's theorem); as it flattens, its eyes move apart, and it becomes softer.
"""

import numpy as np

import dalembert as db
from dalembert.beams import GenerateCircularArcANCFCable2D

radius, half = 1.5, 0.45  # m; rad, from the middle to an eye
width, height, young = 0.07, 0.012, 2.06e11  # m, m, N/m^2
EI = young * width * height**3 / 12
elements, axle_load, steps = 16, 4000.0, 20  # N

model = db.Model()
leaf = db.Cable2D(
    physicsMassPerLength=7850 * width * height,
    physicsBendingStiffness=EI,
    physicsAxialStiffness=young * width * height,
    visualization=db.VCable2D(drawHeight=height),
)
# from the left eye down to the middle and up again: an arc around a center above
eye = [-radius * np.sin(half), 0, 0]
nodes, *_ = GenerateCircularArcANCFCable2D(model.system, eye, radius, -half, 2 * half, elements, leaf)

fixed = model.add(db.MarkerNodeCoordinate(nodeNumber=model.add(db.NodePointGround()), coordinate=0))
for node, coordinate in ((nodes[0], 0), (nodes[0], 1), (nodes[-1], 1)):
    held = model.add(db.MarkerNodeCoordinate(nodeNumber=node, coordinate=coordinate))
    model.add(db.ObjectConnectorCoordinate(markerNumbers=[fixed, held]))
middle = nodes[elements // 2]
model.add(db.Force(markerNumber=model.add(db.MarkerNodePosition(nodeNumber=middle)), loadVector=[0, axle_load, 0]))

solution = model.solve_static(load_steps=steps)
travel, apart = (solution[node].displacement for node in (middle, nodes[-1]))

sine = np.sin(half)
bending = half * sine**2 - 2 * sine * (1 - np.cos(half)) + half / 2 - np.sin(2 * half) / 4
theory = 2 * EI / (radius**3 * bending)
load, lift = axle_load * solution.times, travel[:, 1]
start = 2 * load[1] / lift[1] - load[2] / lift[2]  # extrapolated to zero load from two small loads
print(f"stiffness without load: {start / 1e3:.3f} kN/m, curved bar {theory / 1e3:.3f} kN/m")
last = (load[-1] - load[-2]) / (lift[-1] - lift[-2])
raised, spread = 1e3 * lift[-1], 1e3 * apart[-1, 0]
print(f"with {axle_load / 1e3:.0f} kN: axle up {raised:.1f} mm, eyes apart {spread:.1f} mm, {last / 1e3:.1f} kN/m")

shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = False
shown.contour.outputVariable = db.OutputVariableType.TorqueLocal  # bending moment, as color
model.draw(file_name="leaf_spring_picture.png")
