"""A mast that stands on a rubber mount: how far it leans, and how much of that is due to the mount.

The mast is a chain of beam elements whose nodes carry two directions of their sections; the mount is a spring for all
six motions of its foot. Under a force at the top, a mast of length L bends by F L^3 / (3 EI) + F L / (k G A); the mount
adds F / k for its shift and F L^2 / k for its turning.
"""

from itertools import pairwise

import numpy as np

import dalembert as db

length, side, E, G, density = 3.0, 0.06, 7e10, 2.6e10, 2700.0  # m, m, N/m^2, N/m^2, kg/m^3
shift, turn = 2e6, 8e4  # N/m, Nm/rad of the mount
force, elements = 50.0, 16  # N, 1
area, inertia = side**2, side**4 / 12

section = db.BeamSection()
shear = 5 / 6 * G * area
section.stiffnessMatrix = np.diag([E * area, shear, shear, 0.1406 * G * side**4, E * inertia, E * inertia])
section.massPerLength = density * area
section.inertia = density * np.diag([2 * inertia, inertia, inertia])

model = db.Model()
nodes = [
    model.add(db.NodePointSlope23(referenceCoordinates=[0, 0, z, 1, 0, 0, 0, 1, 0]))
    for z in np.linspace(0, length, elements + 1)
]
for pair in pairwise(nodes):
    model.add(db.ObjectANCFBeam(physicsLength=length / elements, sectionData=section, nodeNumbers=list(pair)))
model.create_ground(
    "foundation", graphics_data_list=[db.graphics.Brick([0, 0, -0.1], [0.6, 0.6, 0.2], db.graphics.color.grey)]
)
foot, top = (model.add(db.MarkerNodeRigid(nodeNumber=node)) for node in (nodes[0], nodes[-1]))
wall = model.add(db.MarkerBodyRigid(bodyNumber=model.ground))
axes = np.array([[0, 1, 0], [0, 0, 1], [1, 0, 0]])  # axes of the sections: the first one points upwards
mount = db.RigidBodySpringDamper(
    "mount",
    markerNumbers=[wall, foot],
    rotationMarker0=axes,
    stiffness=np.diag([shift] * 3 + [turn] * 3),
    damping=np.diag([2e3] * 3 + [50] * 3),
)
model.add(mount)
model.add(db.Force("wind", markerNumber=top, loadVector=[force, 0, 0]))
model.solve_static()
lean = nodes[-1].displacement[0]
of_mast = force * length**3 / (3 * E * inertia) + force * length / shear
of_mount = force / shift + force * length**2 / turn
print(f"lean of the top: {1e3 * lean:.4f} mm, of beam theory {1e3 * (of_mast + of_mount):.4f} mm")
foot_turn = model["mount"].rotation[2]
print(f"turn of the mount: {1e3 * foot_turn:.4f} mrad, F L / k {1e3 * force * length / turn:.4f} mrad")
shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = False
model.draw(file_name="mast_picture.png", view="axonometric")
