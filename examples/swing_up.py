"""A pole on a cart that swings up: the force on the cart with the least effort, found by its gradient.

The force is a polygon over time, whose corners are named numbers of a recorded function. At the end, the pole has to
stand still upright, above the start. These conditions and their derivatives come from solutions by the adjoint method;
a method for constraints (SLSQP) does the rest.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import minimize

import dalembert as db
from dalembert.utilities import CreateSymbolicUserFunction

masses, half, g = {"cart": 1.0, "pole": 0.3}, 0.5, 9.81  # kg, m (half of the length of the pole), m/s^2
end, steps, corners = 1.6, 80, 9  # s, -, -
interval = end / (corners - 1)
kinds = {"": db.OutputVariableType.Coordinates, " speed": db.OutputVariableType.Coordinates_t}

model = db.Model()
fixed = model.add(db.MarkerNodeCoordinate(nodeNumber=model.add(db.NodePointGround()), coordinate=0))
pins = []
for (name, mass), y in zip(masses.items(), (0, -half), strict=True):
    node = model.add(db.NodeRigidBody2D(name=f"{name} node", referenceCoordinates=[0, y, 0]))
    solid = model.add(db.RigidBody2D(physicsMass=mass, physicsInertia=mass * half**2 / 3, nodeNumber=node))
    pins.append(model.add(db.MarkerBodyRigid(bodyNumber=solid, localPosition=[0, -y, 0])))
    model.add(db.Force(markerNumber=model.add(db.MarkerBodyPosition(bodyNumber=solid)), loadVector=[0, -mass * g, 0]))
    for kind, variable in kinds.items():
        model.add(db.SensorNode(name=name + kind, nodeNumber=node, outputVariableType=variable))
model.add(db.RevoluteJoint2D(markerNumbers=pins))
moving = [model.add(db.MarkerNodeCoordinate(nodeNumber="cart node", coordinate=i)) for i in range(3)]
for coordinate in moving[1:]:
    model.add(db.CoordinateConstraint(markerNumbers=[fixed, coordinate]))
forces = [db.symbolic.Real(f"u{k}", 0.0) for k in range(corners)]


def polygon(mbs, t, load):
    return sum(u * db.symbolic.max(1 - db.symbolic.abs(t / interval - k), 0) for k, u in enumerate(forces))


push = model.add(db.LoadCoordinate(name="push", markerNumber=moving[0], load=0))
push.load_user_function = CreateSymbolicUserFunction(model.system, polygon, "loadUserFunction", push)
model.assemble()

settings = db.SimulationSettings()
settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = end, steps
parameters = {f"u{k}": ("push", "loadUserFunction", f"u{k}") for k in range(corners)}
places = {"cart": 0, "pole": 2, "cart speed": 0, "pole speed": 2}  # sensors, and their values that matter
outputs = {name: db.At(name, component=component) for name, component in places.items()}
missed, slopes = db.DifferentiableModel(model.system, parameters, outputs, settings, method="adjoint").LeastSquares(
    {name: np.pi if name == "pole" else 0.0 for name in outputs}
)

first = 4 * np.sin(2 * np.pi * np.linspace(0, 1, corners))
found = minimize(lambda u: (u @ u / corners, 2 * u / corners), first, jac=True, method="SLSQP",
                 options={"ftol": 1e-4}, constraints={"type": "eq", "fun": missed, "jac": slopes})  # fmt: skip

times = np.linspace(0, end, steps + 1)
way = db.DifferentiableModel(model.system, parameters, {"turn": db.At("pole", times, component=2)}, settings)
turns = [np.degrees(way.Values(u)["turn"]) for u in (first, found.x)]
print(f"angle of the pole at the end: {turns[1][-1]:.3f} deg, upright 180.000 deg")
print(f"largest speed, and way of the cart, that remain: {np.max(np.abs(missed(found.x))):.1e}")
plt.plot(times, np.transpose(turns), label=["before", "after"])
plt.gca().set(xlabel="time (s)", ylabel="angle of the pole (deg)")
plt.legend()
plt.savefig("swing_up.png")
