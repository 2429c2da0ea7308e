"""A model of handles as a user would write it, fully typed: mypy --strict has nothing to say about it."""

import dalembert as db

model = db.Model()
mass: db.handles.ObjectMassPoint = model.create_mass_point(name="mass", reference_position=[0, -1, 0], mass=2)
spring = model.create_spring_damper(
    name="spring", body_numbers=["ground", mass], stiffness=800, damping=8, color="steelblue"
)
arm = model.create_rigid_body(name="arm", inertia=db.rigidBodyUtilities.InertiaRodX(1, 0.5), node_type="RotationRxyz")
hinge = model.create_revolute_joint(body_numbers=["ground", arm], position=[0, 0, 0], axis="z")
spring.stiffness = 500
spring.visualization.color = "red"
weight: float = mass.mass * 9.81
model.create_force(name="weight", body_number=mass, load_vector=[0, -weight, 0])
index: db.ObjectIndex = mass
height = model.create_sensor(mass, "displacement", name="height")

solution: db.Solution = model.solve(end_time=0.1, step_size=1e-3, outputs=[(mass, "position")])
y = solution[mass].position[:, 1]
reaction: float = hinge.force_on(arm)[1] + solution[hinge].force[-1, 1]
last: float = mass.position_at([0, 0, 0])[1] + y[-1] + spring.potential_energy
names: list[str] = [body.name for body in model.bodies]
print("iterations:", solution.statistics["newton_iterations"], names, last, height.values[-1])
if isinstance(model["mass"], db.handles.ObjectMassPoint):
    print(model["mass"].physics_mass)
