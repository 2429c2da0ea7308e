"""Newton's cradle: five steel balls on wires; the first is released, and the last one leaves with its velocity.

Neighbours have a small gap, so impacts occur one after the other, and each transfers all of the momentum: balls of
equal mass exchange their velocities in elastic impacts. The period is that of a pendulum whose ball swings on one side
for a quarter of it, and the last one on the other side.
"""

from itertools import pairwise

import numpy as np

import dalembert as db

balls, radius, density, wire, g = 5, 0.02, 7800.0, 0.3, 9.81  # 1, m, kg/m^3, m, m/s^2
gap, start = 2e-5, 0.3  # m, rad
mass = density * 4 / 3 * np.pi * radius**3
stiffness = 2e7  # N/m

model = db.Model()
beam = db.graphics.Brick([0.5 * (balls - 1) * 2 * radius, wire, 0], [0.3, 0.01, 0.02], color=db.graphics.color.brown)
ground = model.create_ground("frame", graphics_data_list=[beam])
names = [f"ball {i}" for i in range(balls)]
places = [(2 * radius + gap) * i for i in range(balls)]
for name, x in zip(names, places, strict=True):
    angle = -start if name == "ball 0" else 0.0
    model.create_mass_point(
        name,
        reference_position=[x + wire * np.sin(angle), wire * (1 - np.cos(angle)), 0],
        physics_mass=mass,
        gravity=[0, -g, 0],
        create_2d=True,
        graphics_data_list=[db.graphics.Sphere(radius=radius, color=db.graphics.color.lightgrey, nTiles=32)],
    )
    model.create_distance_constraint(body_numbers=["frame", name], local_position0=[x, wire, 0], draw_size=0.004)
for pair in pairwise(names):
    model.create_sphere_sphere_contact(body_numbers=pair, spheres_radii=[radius, radius], contact_stiffness=stiffness)

settings = db.SimulationSettings()
settings.timeIntegration.generalizedAlpha.spectralRadius = 1
solution = model.solve(end_time=1.1, step_size=5e-5, every=1e-3, settings=settings)

drop = np.sqrt(2 * g * wire * (1 - np.cos(start)))
last = solution[names[-1]]
height = last.position[:, 1]
print(f"the last ball leaves with: {last.velocity[:, 0].max():.4f} m/s, the first arrives with {drop:.4f} m/s")
print(f"it rises by: {1e3 * height.max():.3f} mm, the first was let go from {1e3 * wire * (1 - np.cos(start)):.3f} mm")
solution.plot("ball 0.position", "ball 4.position", file_name="cradle_motion.png")
shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = shown.loads.show = shown.sensors.show = False
model.draw(file_name="cradle_picture.png", view="front")
solution.animate(
    file_name="cradle_motion.gif", window_size=[420, 320], frames_per_second=20, speed=1.1 / 3, view="front"
)
