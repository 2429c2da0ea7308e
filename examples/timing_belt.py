"""A toothed belt drives a flywheel: the tensions of both spans while the motor accelerates."""

import numpy as np

import dalembert as db

radii, distance, width = np.array([0.03, 0.09]), 0.3, 0.02  # m
stiffness, pretension, speed, run_up = 4e4, 400.0, 150.0, 0.3  # N, N, rad/s, s

model = db.Model()
motor = model.create_cylinder(name="motor", radius=radii[0], length=width, axis="z", density=7850, color="orange")
wheel = model.create_cylinder(
    name="wheel", radius=radii[1], length=width, axis="z", density=7850, reference_position=[distance, 0, 0]
)
for pulley in (motor, wheel):
    model.create_revolute_joint(body_numbers=["ground", pulley], position=pulley.position, axis="z")
belt = model.create_belt(
    name="belt", body_numbers=[motor, wheel], positions=[motor.position, wheel.position], radii=radii,
    carrier_number="ground", stiffness=stiffness, damping=20, pretension=pretension,
)  # fmt: skip
model.create_motor(body_numbers=["ground", motor], position=[0, 0, 0], axis="z", speed=speed, ramp=run_up, damping=20)

solution = model.solve(end_time=0.5, step_size=1e-4)
tensions = np.column_stack([solution[span].force_local for span in belt])
inertia = 7850 * np.pi * width * radii[1] ** 4 / 2
acceleration = np.pi / 2 * speed / run_up * radii[0] / radii[1]  # the largest one: the speed grows as 1 - cos does
pull = inertia * acceleration / radii[1]
print(f"largest difference of tensions: {np.ptp(tensions, axis=1).max():.2f} N, by the moment of inertia {pull:.2f} N")
speeds = [solution[pulley].angular_velocity[-1, 2] for pulley in (motor, wheel)]
print(f"ratio of speeds: {speeds[0] / speeds[1]:.5f}, of radii {radii[1] / radii[0]:.5f}")
solution.plot("belt:0.force_local", "belt:1.force_local", file_name="timing_belt.png")
model.draw(file_name="timing_belt_picture.png")
