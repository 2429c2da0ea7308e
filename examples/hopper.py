"""Particles run out of a hopper into a box: general contact of spheres with each other and with triangles.

Contact has friction. The number of particles is an argument of the command line: `python examples/hopper.py 10000`
takes minutes. All particles finally lie in the box, which carries their weight.
"""

import itertools
import sys

import numpy as np

import dalembert as db
from dalembert.utilities import InertiaSphere

count = int(sys.argv[1]) if len(sys.argv) > 1 else 400
radius, density, friction, gravity = 0.01, 2500.0, 0.4, 9.81  # m, kg/m^3, 1, m/s^2
stiffness, damping, zone = 1e4, 1.2, 0.02  # N/m, Ns/m, m/s
mass = density * 4 / 3 * np.pi * radius**3

model = db.Model()
ground = model.add(db.MarkerBodyRigid(bodyNumber=model.ground))
contact = model.system.AddGeneralContact()
contact.SetFrictionPairings([[friction]])
contact.SetFrictionProportionalZone(zone)
surface = {"contactStiffness": stiffness, "contactDamping": damping, "frictionMaterialIndex": 0}

# ---- walls: square rings at several heights, joined by quadrilaterals whose normals point inwards
columns = max(6, round(0.9 * count ** (1 / 3)))
half = 1.05 * columns * radius
opening = max(0.05, 0.65 * half)
layers = -(-count // columns**2)
outlet = 0.12 + count / columns**2 * radius / 2  # m, above the final heap in the box
neck = outlet + half - opening
top = neck + 2.2 * radius * (layers + 1)
wide = 1.7 * half


def ring(side, height):
    return np.array([[-side, -side, height], [side, -side, height], [side, side, height], [-side, side, height]])


def walls(lower, upper):
    """Return points and triangles between two rings."""
    corners = np.arange(4)
    right = (corners + 1) % 4
    first = np.stack([corners, corners + 4, right], axis=1)
    second = np.stack([right, corners + 4, right + 4], axis=1)
    return np.concatenate([lower, upper]), np.concatenate([first, second])


floor = ring(wide, 0), np.array([[0, 1, 2], [0, 2, 3]])
funnel, column = walls(ring(opening, outlet), ring(half, neck)), walls(ring(half, neck), ring(half, top))
box = walls(ring(wide, 0), ring(wide, 0.8 * outlet))
shapes = []
for points, triangles in (floor, funnel, column, box):
    contact.AddTrianglesRigidBodyBased(ground, pointList=points, triangleList=triangles, **surface)
for points, triangles in (floor, funnel, column, box):
    shapes.append(db.graphics.FromPointsAndTrigs(points, triangles, color=[0.5, 0.6, 0.7, 0.25]))
model.create_ground("hopper", graphics_data_list=shapes)

# ---- particles, layer by layer, each shaken a little
rng = np.random.default_rng(4)
bodies = []
for i in range(count):
    layer, place = divmod(i, columns**2)
    grid = np.array([*divmod(place, columns), layer], dtype=float)
    corner = [(1 - columns) * 1.04 * radius, (1 - columns) * 1.04 * radius, neck + 1.2 * radius]
    position = corner + 2.08 * radius * grid + rng.uniform(-0.02, 0.02, 3) * radius
    color = db.graphics.colorList[layer % 8]
    body = model.create_rigid_body(
        reference_position=list(position),
        inertia=InertiaSphere(mass, radius),
        gravity=[0, 0, -gravity],
        node_type=db.NodeType.RotationRotationVector,
        graphics_data_list=[db.graphics.Sphere(radius=radius, color=color, nTiles=6)],
    )
    contact.AddSphereWithMarker(model.add(db.MarkerBodyRigid(bodyNumber=body)), radius=radius, **surface)
    bodies.append(body)

# ---- contacts last for 20 steps; first a picture on the way, then until the heap is made
# It still creeps: the force of the walls is the mean over some time.
step = np.pi * np.sqrt(mass / stiffness) / 20
settings = db.SimulationSettings()
settings.parallel.numberOfThreads = 2
view = model.container.visualizationSettings
view.nodes.show = view.markers.show = view.loads.show = False
heaped = 2.0 + 2 * top
times = [0, 0.35 + 0.1 * (outlet + top), *np.linspace(heaped, heaped + 0.2, 41)]
forces = []
for begin, end in itertools.pairwise(times):
    steps = int((end - begin) / step)
    solution = model.solve(
        start_time=begin, end_time=end, step_size=(end - begin) / steps, method="explicit_euler", every=0.02,
        update_initial_values=True, settings=settings,
    )  # fmt: skip
    if begin == 0:
        model.draw(file_name="hopper_picture.png", window_size=[700, 900])
        solution.animate(file_name="hopper_motion.gif", window_size=[320, 420], frames_per_second=20, speed=end / 2)
    if end > heaped:
        forces.append(contact.GetSystemODE2RhsContactForces().reshape(count, 6)[:, 2].sum())

places = np.array([body.position for body in bodies])
inside = (np.abs(places[:, :2]).max(axis=1) < wide) & (places[:, 2] < outlet) & (places[:, 2] > 0)
print(f"particles in the box: {inside.sum():d} pieces, of the hopper {count:d} pieces")
print(f"force of the walls: {np.mean(forces):.3f} N, by the weight {count * mass * gravity:.3f} N")
