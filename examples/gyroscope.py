"""A gyroscope: a spinning steel disc on a shaft whose foot rests in a ball joint, released in two ways.

The axis keeps its inclination for a certain rate of precession, a root of a quadratic equation. If it is released with
its axis at rest, the gyroscope nutates while it precesses; conservation of energy and of two angular momenta gives the
amplitude.
"""

import matplotlib.pyplot as plt
import numpy as np

import dalembert as db
from dalembert.utilities import InertiaCylinder, RotationMatrixY

radius, width, arm, spin = 0.1, 0.02, 0.15, 2 * np.pi * 25  # m, m, m from foot to disc, rad/s about the axis
tilt, g = np.radians(60), 9.81  # of the axis, from the vertical
disc = InertiaCylinder(density=7800, length=width, outerRadius=radius, axis=2)
axial = disc.inertiaTensor[2, 2]
across = disc.inertiaTensor[0, 0] + disc.mass * arm**2  # about the foot
weight = disc.mass * g * arm

# steady precession at rate w: across cos(tilt) w^2 - axial spin w + weight = 0, the slow root
precession = min(np.roots([across * np.cos(tilt), -axial * spin, weight]))
# let go at rest, it turns round where the cosine u of its inclination fulfils 1 - u^2 = 2 k (cos(tilt) - u)
k = (axial * spin) ** 2 / (4 * weight * across)
lowest = k - np.sqrt(k**2 - 2 * k * np.cos(tilt) + 1)

model = db.Model()
feet = np.array([[0, 0, 0], [0, 0.4, 0]])  # m, side by side
stands = [db.graphics.Cylinder(foot - [0, 0, 0.12], [0, 0, 0.12], 0.008, color=db.graphics.color.grey) for foot in feet]
ground = model.create_ground("stands", graphics_data_list=stands)
turn = RotationMatrixY(tilt)
axis = turn @ [0, 0, 1]


def gyroscope(foot, rate, color):
    """Add a disc on its shaft, with spin and rate of precession about the vertical; return its body."""
    omega = (spin - rate * np.cos(tilt)) * axis + np.array([0, 0, rate])
    body = model.create_rigid_body(
        reference_position=foot + arm * axis,
        reference_rotation_matrix=turn,
        initial_velocity=np.cross(omega, arm * axis),
        initial_angular_velocity=omega,
        inertia=disc,
        gravity=[0, 0, -g],
        graphics_data_list=[
            db.graphics.Cylinder([0, 0, -width / 2], [0, 0, width], radius, color=color, nTiles=64),
            db.graphics.Cylinder([0, 0, -arm], [0, 0, 1.3 * arm], 0.006, color=db.graphics.color.lightgrey, nTiles=24),
        ],
    )
    model.create_spherical_joint(body_numbers=[ground, body], position=foot)
    return body


steady = gyroscope(feet[0], precession, db.graphics.color.dodgerblue)
nodding = gyroscope(feet[1], 0, db.graphics.color.orange)
solution = model.solve(end_time=2, step_size=2.5e-4, every=1e-3)

model.draw(file_name="gyroscope_picture.png")
solution.animate(file_name="gyroscope_motion.gif", window_size=[420, 320], frames_per_second=20, speed=2 / 3)
paths = [solution[body].position - foot for body, foot in zip((steady, nodding), feet, strict=True)]
for name, quantities, x, y in (
    ("height", ("time (s)", "height of the disc (m)"), [solution.times] * 2, [path[:, 2] for path in paths]),
    ("path", ("x (m)", "y from the foot (m)"), [path[:, 0] for path in paths], [path[:, 1] for path in paths]),
):
    figure, axes = plt.subplots()
    axes.plot(x[0], y[0], label="steady")
    axes.plot(x[1], y[1], label="let go at rest")
    axes.set(xlabel=quantities[0], ylabel=quantities[1])
    axes.legend()
    figure.savefig(f"gyroscope_{name}.png")

t, (x, y, z) = solution.times, paths[0].T
azimuth = np.unwrap(np.arctan2(y, x))
print(f"rate of precession: {(azimuth[-1] - azimuth[0]) / t[-1]:.5f} rad/s, closed form {precession:.5f} rad/s")
print(f"height in steady precession: {z[-1]:.6f} m, closed form {arm * np.cos(tilt):.6f} m")
height = paths[1][:, 2]
print(f"lowest point of nodding: {height.min():.6f} m, closed form {arm * lowest:.6f} m")
