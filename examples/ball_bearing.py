"""A ball bearing under a radial load: the speed of its cage while balls roll, and the load of each ball."""

import numpy as np

import dalembert as db

bore, outside, width, balls, ball, pitch = 0.03, 0.062, 0.016, 9, 9.525e-3, 0.046  # m; a bearing of type 6206
speed, load = 100.0, 1000.0  # rad/s, N

model = db.Model()
shaft = model.create_cylinder(name="shaft", radius=bore / 2, length=0.03, axis="z", density=7850, color="grey")
model.create_generic_joint(
    body_numbers=["ground", shaft], position=[0, 0, 0], constrained_axes=[0, 0, 1, 1, 1, 0], show=False
)
model.create_motor(body_numbers=["ground", shaft], position=[0, 0, 0], axis="z", speed=speed, ramp=0.02, damping=1)
model.create_force(body_number=shaft, load_vector=[0, -load, 0])

data = db.machines.GetBallBearingData(
    [0, 0, 1], outside, bore, width, balls, radiusBalls=ball / 2, radiusCage=pitch / 2, ballsAngleOffset=np.pi / 2
)
inner, outer = (model.add(db.MarkerBodyRigid(bodyNumber=body)) for body in (shaft, model.ground))
contact = {"contactStiffness": 1e10, "contactDamping": 2000, "dynamicFriction": 0.1, "contactStiffnessExponent": 1.5}
parts = db.machines.CreateBallBearing(
    model.system, data, inner, outer, densityBalls=7850, densityCage=8500, springStiffnessCage=1e4, springDampingCage=1,
    contactParametersRingBalls=contact,
)  # fmt: skip

solution = model.solve(end_time=0.1, step_size=2e-5, every=2e-4)
late = solution.times > 0.05
cage = solution[parts["objectCage"]].angular_velocity[late, 2].mean()
forces = [np.linalg.norm(solution[contact].force[late], axis=1) for contact in parts["outerRingBallContacts"]]
print(f"speed of the cage: {cage:.3f} rad/s, balls that roll {speed / 2 * (1 - ball / pitch):.3f} rad/s")
print(f"largest load of a ball: {np.max(forces):.0f} N, Stribeck {4.37 * load / balls:.0f} N")
solution.plot("shaft.displacement", file_name="ball_bearing.png")
model.draw(file_name="ball_bearing_picture.png")
