"""Two discs on one wire: torsional vibration moves between them, like that of coupled pendulums.

The wire is clamped at both ends; its parts are springs between the rotations of the discs, which are coordinates of
markers. The discs turn in phase with w1 = sqrt(k / J), in opposite phase with w2 = sqrt((k + 2 c) / J), where k is the
stiffness of the outer parts and c that of the part between the discs. If one disc is rotated and released, the motion
is the sum of both modes.
"""

import numpy as np

import dalembert as db
from dalembert.utilities import InertiaCylinder, RotationMatrixZ

radius, width, mass = 0.1, 0.02, 2.0  # m, m, kg
outer, inner = 0.4, 0.05  # Nm/rad
start = 1.0  # rad
J = 0.5 * mass * radius**2
frequencies = np.sqrt([outer / J, (outer + 2 * inner) / J])
beat = 2 * np.pi / (frequencies[1] - frequencies[0])  # s

model = db.Model()
wire = db.graphics.Cylinder([0, 0, -0.3], [0, 0, 0.9], 0.003, db.graphics.color.grey)
walls = [db.graphics.Brick([0, 0, z], [0.1, 0.1, 0.01], db.graphics.color.grey) for z in (-0.3, 0.6)]
ground = model.create_ground("walls", graphics_data_list=[wire, *walls])
inertia = InertiaCylinder(mass / (np.pi * radius**2 * width), width, radius, axis=2)
line = db.graphics.Brick([0.5 * radius, 0, 0], [radius, 0.01, 1.1 * width], db.graphics.color.orange)
fixed = model.add(db.MarkerNodeCoordinate(nodeNumber=model.add(db.NodePointGround()), coordinate=0))
turns = [fixed]
for name, z, angle in (("first", 0, start), ("second", 0.3, 0)):
    shape = db.graphics.Cylinder([0, 0, -0.5 * width], [0, 0, width], radius, db.graphics.color.steelblue, nTiles=64)
    disc = model.create_rigid_body(name, reference_position=[0, 0, z], initial_rotation_matrix=RotationMatrixZ(angle),
                               inertia=inertia, graphics_data_list=[shape, line])  # fmt: skip
    model.create_revolute_joint(body_numbers=[ground, disc], position=[0, 0, z], axis=[0, 0, 1], show=False)
    turns.append(model.add(db.MarkerNodeRotationCoordinate(nodeNumber=disc.nodes[0], rotationCoordinate=2)))
    model.create_sensor(turns[-1], "coordinates", name=f"turn of the {name} disc")
turns.append(fixed)
for i, stiffness in enumerate((outer, inner, outer)):
    model.add(db.CoordinateSpringDamper(markerNumbers=turns[i : i + 2], stiffness=stiffness))

solution = model.solve(end_time=beat, step_size=beat / 4000, every=beat / 1000)

time = solution.times
first, second = (solution[f"turn of the {name} disc"].values for name in ("first", "second"))
together, against = 0.5 * start * np.cos(np.outer(frequencies, time))
print(f"a beat lasts {beat:.4f} s")
for name, turn, theory in (("first", first, together + against), ("second", second, together - against)):
    middle = np.argmax(np.abs(theory[len(time) // 3 :])) + len(time) // 3  # of the beat
    print(f"largest turn of the {name} disc, later: {turn[middle]:.4f} rad, theory {theory[middle]:.4f} rad")
solution.plot("turn of the first disc", "turn of the second disc", file_name="torsion_turns.png")
shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = shown.sensors.show = shown.connectors.show = False
model.draw(file_name="torsion_picture.png", view="axonometric")
