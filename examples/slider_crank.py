"""A slider-crank in space: three rigid bodies, driven by a torque on the crank, with a spring against the slider.

The position of the slider follows from the angle of the crank in closed form.
"""

import numpy as np

import dalembert as db

crank_length, rod_length, width = 0.1, 0.3, 0.02  # m
steel = {"density": 7800, "gravity": [0, -9.81, 0]}

model = db.Model()

# bodies: the mechanism is stretched in the reference configuration, the crank along x
crank = model.create_box(
    "crank", size=[crank_length, width, width], reference_position=[crank_length / 2, 0, 0], color="orange", **steel
)
rod = model.create_box(
    "rod", size=[rod_length, width, width], reference_position=[crank_length + rod_length / 2, 0, 0],
    color="dodgerblue", **steel
)  # fmt: skip
end = [crank_length + rod_length, 0, 0]
slider = model.create_box("slider", size=[0.05, width, width], reference_position=end, color="lightgrey", **steel)

# joints: 5 + 5 + 2 + 5 equations for 18 degrees of freedom
model.create_revolute_joint(body_numbers=["ground", crank], position=[0, 0, 0], axis="z")
model.create_revolute_joint(body_numbers=[crank, rod], position=[crank_length, 0, 0], axis="z")
pin = model.create_generic_joint("pin", body_numbers=[rod, slider], position=end, constrained_axes=[1, 1, 0, 0, 0, 0])
model.create_generic_joint("guide", body_numbers=["ground", slider], position=end, constrained_axes=[0, 1, 1, 1, 1, 1])

# drive and resistance
model.create_torque(body_number=crank, load_vector=[0, 0, 0.5])  # Nm
model.create_spring_damper(
    body_numbers=["ground", slider], local_position0=[0.6, 0, 0], reference_length=0.3, stiffness=100, damping=2
)

# sensor
place = model.create_sensor(slider, "position", name="place")

settings = db.SimulationSettings()
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.8
solution = model.solve(end_time=2, step_size=1e-3, every=5e-3, settings=settings)

model.draw(file_name="slider_crank_picture.png", view="axonometric")
solution.animate(
    "slider_crank_motion.gif", window_size=[420, 320], frames_per_second=20, speed=2 / 3, view="axonometric"
)
solution.plot(place, file_name="slider_position.png")
solution.plot("crank.angular_velocity", file_name="crank_speed.png")
solution.plot("pin.force", file_name="pin_force.png")

# the position of the slider follows from the angle of the crank
reached, angle = place.values[:, 0], solution[crank].rotation[:, 2]
exact = crank_length * np.cos(angle) + np.sqrt(rod_length**2 - (crank_length * np.sin(angle)) ** 2)
print(f"range of the slider: {np.ptp(reached):.6f} m, closed form {np.ptp(exact):.6f} m")
print(f"slider at the end: {reached[-1]:.6f} m, closed form {exact[-1]:.6f} m")
