"""A mass on a spring and a damper, released from rest under gravity: the motion decays towards static equilibrium."""

import dalembert as db

model = db.Model()
mass = model.create_mass_point("mass", reference_position=[0, -1, 0], mass=2, gravity=[0, -9.81, 0], draw_size=0.2)
spring = model.create_spring_damper(body_numbers=["ground", mass], reference_length=1, stiffness=800, damping=8)

solution = model.solve(end_time=2, step_size=2e-3)
print(solution[mass].displacement[-1])  # y tends to -2 * 9.81 / 800
solution.plot("mass.displacement", file_name="first_model.png")
model.draw(file_name="first_model_picture.png")
