"""A strip of steel that is clamped at one end and rolled up by a moment at the other, to a closed ring.

A moment bends it to a circle: its curvature is the moment divided by the bending stiffness, along all of its length,
however far it bends.
"""

import matplotlib.pyplot as plt
import numpy as np

import dalembert as db

length, width, thickness, modulus = 1.0, 0.02, 0.5e-3, 2.1e11  # m, N/m^2
area, bending = width * thickness, modulus * width * thickness**3 / 12
ring = 2 * np.pi * bending / length  # Nm: the moment that closes it
elements = 8

model = db.Model()
nodes = [
    model.add(db.NodeRigidBody2D(referenceCoordinates=[x, 0, 0])) for x in np.linspace(0, length, 2 * elements + 1)
]
for i in range(0, 2 * elements, 2):
    model.add(
        db.Beam2D(
            nodeNumbers=nodes[i : i + 3],
            physicsLength=length / elements,
            physicsMassPerLength=7850 * area,
            physicsCrossSectionInertia=7850 * width * thickness**3 / 12,
            physicsBendingStiffness=bending,
            physicsAxialStiffness=modulus * area,
            physicsShearStiffness=modulus / 2.6 * 5 / 6 * area,
        )
    )
wall = model.add(db.MarkerNodeCoordinate(nodeNumber=model.add(db.NodePointGround()), coordinate=0))
for coordinate in range(3):
    held = model.add(db.MarkerNodeCoordinate(nodeNumber=nodes[0], coordinate=coordinate))
    model.add(db.CoordinateConstraint(markerNumbers=[wall, held]))
end = model.add(db.MarkerNodeRigid(nodeNumber=nodes[-1]))
model.add(db.Torque(markerNumber=end, loadVector=[0, 0, ring]))

solution = model.solve_static(load_steps=40)

tip, middle = solution[nodes[-1]].position, solution[nodes[elements]].position
print(f"height of the tip under half of the moment: {tip[20, 1]:.5f} m, of half a circle {2 * length / np.pi:.5f} m")
print(f"height of the middle under all of it: {middle[-1, 1]:.5f} m, of a circle {length / np.pi:.5f} m")
plt.plot(tip[:, 0], tip[:, 1])
plt.gca().set(xlabel="x of the tip (m)", ylabel="y (m)")
plt.savefig("strip_tip.png")
shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = shown.connectors.show = shown.loads.show = False
model.draw(file_name="strip_picture.png")
solution.animate(file_name="strip_motion.gif", window_size=[420, 320], frames_per_second=20, speed=1 / 2)
