"""A ball hits a tower of ten boxes: general contact of convex shapes with each other, with a sphere and a plane.

Static friction holds the tower while it stands. Every box rests on one contact stiffness, for any number of corners:
the lowest one penetrates by the total weight divided by the stiffness. All boxes finally lie on the ground, which
carries their weight.
"""

import numpy as np

import dalembert as db
from dalembert.utilities import InertiaCuboid, InertiaSphere

count, size, density, gravity = 10, [0.12, 0.12, 0.08], 500.0, 9.81  # 1, m, kg/m^3, m/s^2
stiffness, damping, friction = 2e5, 400.0, 0.5  # N/m, Ns/m, 1
radius, speed = 0.08, 4.0  # radius and speed of the ball: m, m/s
mass, ball_mass = density * np.prod(size), 3.0  # kg

model = db.Model()
floor = db.graphics.CheckerBoard(point=[0.3, 0, 0], size=1.8, nTiles=12)
ground = model.add(db.MarkerBodyRigid(bodyNumber=model.create_ground("floor", graphics_data_list=[floor])))
contact = model.system.AddGeneralContact()
contact.SetFrictionPairings([[friction]])
contact.SetFrictionBristles(stiffnessRatio=0.8, dampingRatio=1.0)
surface = {"contactStiffness": 2 * stiffness, "contactDamping": damping / 2, "frictionMaterialIndex": 0}
contact.AddPlane(ground, normal=[0, 0, 1], **surface)

# ---- initial penetrations of the tower in equilibrium ----------------------------------------------------------------
sinks = mass * gravity / stiffness * np.arange(count, 0, -1)
heights = size[2] * (np.arange(count) + 0.5) - np.cumsum(sinks)
boxes = []
for number, height in enumerate(heights):
    body = model.create_rigid_body(
        reference_position=[0, 0, height],
        inertia=InertiaCuboid(density, size),
        gravity=[0, 0, -gravity],
        node_type=db.NodeType.RotationRotationVector,
        graphics_data_list=[db.graphics.Brick(size=size, color=db.graphics.colorList[number % 8], addEdges=True)],
    )
    contact.AddBoxWithMarker(model.add(db.MarkerBodyRigid(bodyNumber=body)), size=size, **surface)
    boxes.append(body)
start = [-0.6, 0.02, 0.45]
ball = model.create_rigid_body(
    reference_position=start,
    inertia=InertiaSphere(ball_mass, radius),
    node_type=db.NodeType.RotationRotationVector,
    graphics_data_list=[db.graphics.Sphere(radius=radius, color=db.graphics.color.dodgerblue, nTiles=32)],
)
ball_marker = model.add(db.MarkerBodyRigid(bodyNumber=ball))
contact.AddSphereWithMarker(ball_marker, radius=radius, **surface)
weight = model.add(db.Force(markerNumber=ball_marker, loadVector=[0, 0, 0]))
common = {"step_size": 1e-4, "every": 5e-3, "method": "velocity_verlet", "update_initial_values": True}
model.solve(end_time=1, **common)  # the ball waits
lowest = boxes[0].position_at([0, 0, -size[2] / 2])[2]
print(f"depth of the lowest box: {-1e3 * lowest:.4f} mm, by the weight of all {1e3 * sinks[0]:.4f} mm")

weight.load_vector = [0, 0, -ball_mass * gravity]
data = model.system.systemData
velocity = data.GetODE2Coordinates_t(db.ConfigurationType.Initial)
velocity[data.GetObjectLTGODE2(ball)[:3]] = [speed, 0, 0.8]
data.SetODE2Coordinates_t(velocity, db.ConfigurationType.Initial)
solution = model.solve(start_time=1, end_time=1.35, **common)
view = model.container.visualizationSettings
view.nodes.show = view.markers.show = view.loads.show = False
model.draw(file_name="box_tower_picture.png")
solution.animate(file_name="box_tower_motion.gif", window_size=[420, 320], frames_per_second=20, speed=0.15)
model.solve(start_time=1.35, end_time=4, **common)
force = 0.0
for pair, push in zip(*(contact.GetConvexContacts()[key] for key in ("pairs", "forces")), strict=True):
    force += push[2] if pair.max() == count + 1 else 0  # the plane, behind the ball and the boxes
print(f"force of the ground: {force:.2f} N, by the weight {(count * mass + ball_mass) * gravity:.2f} N")
