"""A quarter car on a measured road: body and wheel on springs, and the acceleration that passengers feel.

The road is a table of times and heights. A plate follows it by a prescribed motion, and carries wheel and body.
"""

import numpy as np

import dalembert as db

# a measurement at 15 m/s: a bump of 5 cm, and roughness that grows with the length of the waves
times = np.linspace(0, 4, 401)
roughness = np.cumsum(np.random.default_rng(1).normal(scale=2e-4, size=401))
heights = 0.05 * np.exp(-(((times - 1) / 0.06) ** 2)) + roughness * np.clip(times - 0.2, 0, 1)

model = db.Model()
road = model.create_box(name="road", size=[1, 0.4, 0.02], mass=1, color="grey")
wheel = model.create_cylinder(
    name="wheel", radius=0.3, length=0.2, axis="y", mass=40, reference_position=[0, 0, 0.3], color="black"
)
body = model.create_box(name="body", size=[1.2, 0.6, 0.3], mass=400, reference_position=[0, 0, 0.9], color="steelblue")
for part in (road, wheel, body):
    model.create_prismatic_joint(body_numbers=["ground", part], position=[0, 0, 0], axis="z", show=False)
model.create_prescribed_motion(
    body_numbers=["ground", road], position=[0, 0, 0], axis="z", motion=np.column_stack([times, heights]), show=False
)
model.create_spring_damper(name="tyre", body_numbers=[road, wheel], stiffness=2e5, damping=200, draw_size=0.1)
model.create_spring_damper(name="suspension", body_numbers=[wheel, body], stiffness=2e4, damping=1500, draw_size=0.2)

solution = model.solve(end_time=4, step_size=1e-3)
acceleration = solution[body].acceleration[:, 2]
print(f"largest acceleration {np.abs(acceleration).max():.2f} m/s^2, root mean square {acceleration.std():.2f} m/s^2")
solution.plot("body.displacement", file_name="quarter_car.png")
model.draw(file_name="quarter_car_picture.png")
