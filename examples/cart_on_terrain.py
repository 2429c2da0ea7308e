"""A cart rolls through hilly terrain: its wheels are spheres in contact with a mesh of triangles.

The wheels turn in joints, and creep a little by friction. The cart has neither brake nor drive: its potential energy is
converted to kinetic energy, including the spin of the wheels.
"""

import numpy as np

import dalembert as db
from dalembert.utilities import InertiaCuboid, InertiaSphere, RotationMatrixY

radius, wheel_mass, frame_mass, gravity = 0.15, 2.0, 20.0, 9.81  # m, kg, kg, m/s^2
long, wide, friction, stiffness = 0.8, 0.6, 0.8, 2e5  # m, m, 1, N/m


def height(x, y):
    return 0.5 * np.cos(0.9 * x) + 0.03 * np.sin(1.5 * x) * np.cos(2 * y)


model = db.Model()

# ---- the terrain: two triangles per cell
x, y = np.meshgrid(np.linspace(-1, 8, 181), np.linspace(-1.5, 1.5, 61), indexing="ij")
points = np.stack([x, y, height(x, y)], axis=-1).reshape(-1, 3)
corner = np.add.outer(np.arange(180) * 61, np.arange(60)).ravel()
triangles = np.concatenate(
    [np.stack([corner, corner + 61, corner + 62], axis=1), np.stack([corner, corner + 62, corner + 1], axis=1)]
)
ground = model.create_ground(
    "terrain", graphics_data_list=[db.graphics.FromPointsAndTrigs(points, triangles, color=[0.5, 0.65, 0.4, 1])]
)
contact = model.system.AddGeneralContact()
contact.SetFrictionPairings([[friction]])
contact.SetFrictionProportionalZone(0.005)
surface = {"contactStiffness": stiffness, "contactDamping": 300, "frictionMaterialIndex": 0}
contact.AddTrianglesRigidBodyBased(
    model.add(db.MarkerBodyRigid(bodyNumber=ground)), pointList=points, triangleList=triangles, **surface
)

# ---- the cart, above the begin of a slope
begin = np.array([0.9, 0.0])
slope = np.arctan((height(begin[0] + long / 2, 0) - height(begin[0] - long / 2, 0)) / long)
turn = RotationMatrixY(-slope)
middle = np.array([*begin, height(*begin) + radius + 0.05])
inertia = InertiaCuboid(frame_mass / (long * wide * 0.2), [long, wide, 0.2])
shape = db.graphics.Brick(size=[long, 0.6 * wide, 0.1], color=db.graphics.color.orange)
frame = model.create_rigid_body(
    "frame",
    reference_position=list(middle),
    reference_rotation_matrix=turn,
    inertia=inertia,
    gravity=[0, 0, -gravity],
    graphics_data_list=[shape],
)
wheels = []
for side_x in (-1, 1):
    for side_y in (-1, 1):
        place = middle + turn @ [side_x * long / 2, side_y * wide / 2, 0]
        wheel = model.create_rigid_body(
            reference_position=list(place),
            reference_rotation_matrix=turn,
            inertia=InertiaSphere(wheel_mass, radius),
            gravity=[0, 0, -gravity],
            graphics_data_list=[db.graphics.Sphere(radius=radius, color=db.graphics.color.steelblue, nTiles=24)],
        )
        model.create_revolute_joint(body_numbers=[frame, wheel], position=list(place), axis=[0, 1, 0])
        contact.AddSphereWithMarker(model.add(db.MarkerBodyRigid(bodyNumber=wheel)), radius=radius, **surface)
        wheels.append(wheel)

# ---- it first settles on its wheels; the energy balance starts then --------------------------------------------------
settings = db.SimulationSettings()
settings.timeIntegration.discontinuous.iterationTolerance = 0.1
common = {"step_size": 1e-3, "every": 0.02, "settings": settings}
model.solve(end_time=0.3, update_initial_values=True, **common)
before = model.system.ComputeEnergies()
solution = model.solve(start_time=0.3, end_time=1.5, **common)
after = model.system.ComputeEnergies()
gained, lost = after.kinetic - before.kinetic, before.potential - after.potential
print(f"energy of motion: {gained:.2f} J, by the height that was lost {lost:.2f} J")

view = model.container.visualizationSettings
view.nodes.show = view.markers.show = view.loads.show = view.connectors.show = False
model.draw(file_name="cart_on_terrain_picture.png")
solution.animate(file_name="cart_motion.gif", window_size=[420, 320], frames_per_second=20, speed=0.4)
