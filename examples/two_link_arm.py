"""An arm of two links in a vertical plane: PID controllers move it along a path in joint angles."""

import numpy as np

import dalembert as db

times = np.linspace(0, 3, 61)
smooth = 0.5 - 0.5 * np.cos(np.pi * np.clip(times / 2, 0, 1))
paths = {"shoulder": 1.2 * smooth, "elbow": -0.8 * smooth}  # rad
gains = {"shoulder": {"P": 2000, "I": 4000, "D": 150}, "elbow": {"P": 800, "I": 1500, "D": 50}}

model = db.Model()
common = {"size": [0.5, 0.06, 0.06], "density": 2700, "gravity": [0, -9.81, 0]}
upper = model.create_box(name="upper arm", reference_position=[0.25, 0, 0], color="orange", **common)
lower = model.create_box(name="lower arm", reference_position=[0.75, 0, 0], color="steelblue", **common)
places = {"shoulder": (["ground", upper], [0, 0, 0]), "elbow": ([upper, lower], [0.5, 0, 0])}
for name, (bodies, position) in places.items():
    place = {"body_numbers": bodies, "position": position, "axis": "z"}
    model.create_revolute_joint(name=name, axis_radius=0.05, axis_length=0.1, **place)
    path = np.column_stack([times, paths[name]])
    model.create_pid_controller(
        name=f"{name} drive", set_point=path, smooth=True, limit=80, show=False, **place, **gains[name]
    )

solution = model.solve(end_time=3, step_size=1e-3)
for name in places:
    angle, torque = solution[name].rotation[:, 2], solution[f"{name} drive"].force[:, 5]
    print(f"{name}: {angle[-1]:.4f} of {paths[name][-1]:.1f} rad, largest torque {np.abs(torque).max():.1f} Nm")
solution.plot("shoulder.rotation", "elbow.rotation", file_name="two_link_arm.png")
model.draw(file_name="two_link_arm_picture.png")
