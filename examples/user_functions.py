"""User functions: a stiffening spring, a force in time, a controller before each step, and a sensor that computes."""

import numpy as np

import dalembert as db

model = db.Model()
mass = model.create_mass_point("mass", reference_position=[1, 0, 0], mass=1, draw_size=0.1, color="orange")


def stiffening(mbs, t, item_number, elongation, rate, stiffness, damping, force):
    """Force of a Duffing spring."""
    return stiffness * (elongation + 50 * elongation**3) + damping * rate + force


def sweep(mbs, t, load):
    """The load with a frequency that grows in time."""
    return np.sin(2 * np.pi * (0.5 + t / 4) * t) * np.array(load)


def switch_damping(mbs, t):
    """Ten times the damping from 4 s on."""
    spring.damping = 0.2 if t < 4 else 2
    return True


def energy(mbs, t, sensor_numbers, factors, configuration):
    """Kinetic energy, from the velocity sensor."""
    velocity = mbs.GetSensorValues(sensor_numbers[0], configuration)
    return [0.5 * factors[0] * np.dot(velocity, velocity)]


spring = model.create_spring_damper(
    "spring", body_numbers=["ground", mass], reference_length=1, stiffness=100, damping=0.2,
    spring_force_user_function=stiffening,
)  # fmt: skip
model.create_force("push", body_number=mass, load_vector=[2, 0, 0], load_vector_user_function=sweep)
model.system.SetPreStepUserFunction(switch_damping)

velocity = model.create_sensor(mass, "velocity", name="velocity")
kinetic = model.add(
    db.SensorUserFunction(
        name="kinetic", sensorNumbers=[velocity], factors=[1], sensorUserFunction=energy, storeInternal=True
    )
)

solution = model.solve(end_time=6, step_size=5e-3)

model.draw(file_name="user_functions_picture.png")
axes = solution.plot("kinetic")
axes.set_ylabel("kinetic energy (J)")
axes.figure.savefig("user_functions.png")
print(f"largest kinetic energy: {kinetic.values.max():.3f} J")
