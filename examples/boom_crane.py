"""A hydraulic cylinder lifts a boom with a load on a rope: length of the cylinder, and swing of the load."""

import numpy as np

import dalembert as db

gravity = [0, -9.81, 0]  # m/s^2

model = db.Model()
boom = model.create_box(size=[3, 0.15, 0.15], mass=200, reference_position=[1.5, 0, 0], color="orange", gravity=gravity)
load = model.create_sphere(radius=0.2, mass=300, reference_position=[3, -1.5, 0], color="steelblue", gravity=gravity)
model.create_revolute_joint(body_numbers=["ground", boom], position=[0, 0, 0], axis="z")
model.create_distance_constraint(body_numbers=[boom, load], local_position0=[1.5, 0, 0])

moment, arm = 9.81 * (200 * 1.5 + 300 * 3), 1 / np.hypot(0.5, 1)  # of the weights and of the cylinder about the hinge
cylinder = model.create_hydraulic_cylinder(
    name="cylinder", body_numbers=["ground", boom], local_position0=[0.5, -1, 0], local_position1=[-0.5, 0, 0],
    piston_diameter=0.12, rod_diameter=0.07, stroke_length=0.8, initial_force=moment / arm, actuator_damping=5e4,
)  # fmt: skip

model.create_sensor(cylinder, "distance", name="length of the cylinder")


def valves(mbs, t):
    opening = float(np.interp(t, [0.5, 1.0, 3.0, 3.5], [0, 1, 1, 0]))
    cylinder.valve_opening0, cylinder.valve_opening1 = opening, -opening  # the pump and the tank
    return True


model.system.SetPreStepUserFunction(valves)
solution = model.solve(end_time=6, step_size=2e-3)
length, place = solution["length of the cylinder"].values, solution[load].position
rise, swing = np.ptp(place[:, 1]), np.ptp(place[-1000:, 0])
print(f"cylinder extends by {np.ptp(length):.3f} m, load rises by {rise:.3f} m, then swings by {swing:.3f} m")
solution.plot("length of the cylinder", file_name="boom_crane.png")
model.draw(file_name="boom_crane_picture.png")
