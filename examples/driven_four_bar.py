"""A four-bar linkage with a motor: the torque that it needs, and the reactions in its bearings."""

import numpy as np

import dalembert as db

points = {"O": [0.0, 0, 0], "A": [0, 0.2, 0], "B": [0.7, 0.5, 0], "C": [0.6, 0, 0]}  # m

model = db.Model()
bars = {}
for name, ends in {"crank": "OA", "coupler": "AB", "rocker": "BC"}.items():
    start, end = (np.array(points[point]) for point in ends)
    line = end - start
    bars[name] = model.create_box(
        name=name,
        size=[float(np.linalg.norm(line)), 0.04, 0.02],
        density=7850,
        reference_position=(start + end) / 2,
        reference_rotation_matrix=db.rigidBodyUtilities.RotationMatrixZ(np.arctan2(line[1], line[0])),
        gravity=[0, -9.81, 0],
    )
pairs = {"O": ["ground", "crank"], "A": ["crank", "coupler"], "B": ["coupler", "rocker"], "C": ["rocker", "ground"]}
for name, pair in pairs.items():
    model.create_revolute_joint(name=name, body_numbers=pair, position=points[name], axis="z", axis_radius=0.03)
motor = model.create_motor(
    name="motor", body_numbers=pairs["O"], position=points["O"], axis="z", speed=10, ramp=0.5, damping=100, show=False
)

solution = model.solve(end_time=2, step_size=1e-3)
torque = -solution[motor].torque_local
forces = {name: np.linalg.norm(solution[name].force, axis=1).max() for name in pairs}
print(f"the motor needs {np.abs(torque).max():.1f} Nm; largest forces:", {k: f"{v:.0f} N" for k, v in forces.items()})
solution.plot("motor.torque_local", file_name="driven_four_bar.png")
model.draw(file_name="driven_four_bar_picture.png")
