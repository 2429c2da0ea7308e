"""An arm of two links in a vertical plane: PID controllers move it along a path in joint angles."""

import numpy as np

import dalembert as db

times = np.linspace(0, 3, 61)
smooth = 0.5 - 0.5 * np.cos(np.pi * np.clip(times / 2, 0, 1))
paths = {"shoulder": 1.2 * smooth, "elbow": -0.8 * smooth}  # rad
gains = {"shoulder": {"P": 2000, "I": 4000, "D": 150}, "elbow": {"P": 800, "I": 1500, "D": 50}}

model = db.Model()
size, gravity = [0.5, 0.06, 0.06], [0, -9.81, 0]  # m, m/s^2
for name, x, color in (("upper arm", 0.25, "orange"), ("lower arm", 0.75, "steelblue")):
    model.create_box(name, size=size, density=2700, reference_position=[x, 0, 0], gravity=gravity, color=color)
pairs = {"shoulder": ["ground", "upper arm"], "elbow": ["upper arm", "lower arm"]}
for name, bodies in pairs.items():
    position = [0.5 if name == "elbow" else 0, 0, 0]
    model.create_revolute_joint(name, bodies, position=position, axis="z", axis_radius=0.05, axis_length=0.1)
    path, gain = np.column_stack([times, paths[name]]), gains[name]
    model.create_pid_controller(
        f"{name} drive", bodies, position=position, axis="z", set_point=path, smooth=True, limit=80, show=False,
        p=gain["P"], i=gain["I"], d=gain["D"],
    )  # fmt: skip

solution = model.solve(end_time=3, step_size=1e-3)
for name in pairs:
    angle, torque = solution[name].rotation[:, 2], solution[f"{name} drive"].force[:, 5]
    print(f"{name}: {angle[-1]:.4f} of {paths[name][-1]:.1f} rad, largest torque {np.abs(torque).max():.1f} Nm")
solution.plot("shoulder.rotation", "elbow.rotation", file_name="two_link_arm.png")
model.draw(file_name="two_link_arm_picture.png")
