"""A pole on a cart that swings up: the force on the cart with the least effort, found by its gradient.

The force is a polygon over time, whose corners are named numbers of a recorded function. At the end, the pole has to
stand still upright, above the start. These conditions and their derivatives come from solutions by the adjoint method;
a method for constraints (SLSQP) does the rest.
"""

import numpy as np
from scipy.optimize import minimize

import dalembert as exu
from dalembert.utilities import *

masses, half, g = {"cart": 1.0, "pole": 0.3}, 0.5, 9.81  # kg, m (half of the length of the pole), m/s^2
end, steps, corners = 1.6, 80, 9  # s, -, -
interval = end / (corners - 1)
kinds = {"": exu.OutputVariableType.Coordinates, " speed": exu.OutputVariableType.Coordinates_t}

mbs = exu.SystemContainer().AddSystem()
fixed = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
pins = []
for (name, mass), y in zip(masses.items(), (0, -half), strict=True):
    node = mbs.AddNode(NodeRigidBody2D(name=f"{name} node", referenceCoordinates=[0, y, 0]))
    solid = mbs.AddObject(RigidBody2D(physicsMass=mass, physicsInertia=mass * half**2 / 3, nodeNumber=node))
    pins.append(mbs.AddMarker(MarkerBodyRigid(bodyNumber=solid, localPosition=[0, -y, 0])))
    mbs.AddLoad(Force(markerNumber=mbs.AddMarker(MarkerBodyPosition(bodyNumber=solid)), loadVector=[0, -mass * g, 0]))
    for kind, variable in kinds.items():
        mbs.AddSensor(SensorNode(name=name + kind, nodeNumber=node, outputVariableType=variable))
mbs.AddObject(RevoluteJoint2D(markerNumbers=pins))
moving = [mbs.AddMarker(MarkerNodeCoordinate(nodeNumber="cart node", coordinate=i)) for i in range(3)]
for coordinate in moving[1:]:
    mbs.AddObject(CoordinateConstraint(markerNumbers=[fixed, coordinate]))
forces = [exu.symbolic.Real(f"u{k}", 0.0) for k in range(corners)]


def polygon(mbs, t, load):
    return sum(u * exu.symbolic.max(1 - exu.symbolic.abs(t / interval - k), 0) for k, u in enumerate(forces))


push = mbs.AddLoad(LoadCoordinate(name="push", markerNumber=moving[0], load=0))
mbs.SetLoadParameter(push, "loadUserFunction", CreateSymbolicUserFunction(mbs, polygon, "loadUserFunction", push))
mbs.Assemble()

settings = exu.SimulationSettings()
settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = end, steps
parameters = {f"u{k}": ("push", "loadUserFunction", f"u{k}") for k in range(corners)}
places = {"cart": 0, "pole": 2, "cart speed": 0, "pole speed": 2}  # sensors, and their values that matter
outputs = {name: exu.At(name, component=component) for name, component in places.items()}
missed, slopes = exu.DifferentiableModel(mbs, parameters, outputs, settings, method="adjoint").LeastSquares(
    {name: np.pi if name == "pole" else 0.0 for name in outputs}
)

first = 4 * np.sin(2 * np.pi * np.linspace(0, 1, corners))
found = minimize(lambda u: (u @ u / corners, 2 * u / corners), first, jac=True, method="SLSQP",
                 options={"ftol": 1e-4}, constraints={"type": "eq", "fun": missed, "jac": slopes})  # fmt: skip

times = np.linspace(0, end, steps + 1)
way = exu.DifferentiableModel(mbs, parameters, {"turn": exu.At("pole", times, component=2)}, settings)
turns = [np.degrees(way.Values(u)["turn"]) for u in (first, found.x)]
print(f"angle of the pole at the end: {turns[1][-1]:.3f} deg, upright 180.000 deg")
print(f"largest speed, and way of the cart, that remain: {np.max(np.abs(missed(found.x))):.1e}")
mbs.PlotSensor([np.column_stack([times, turn]) for turn in turns], labels=["before", "after"],
               yLabel="angle of the pole (deg)", fileName="swing_up.png", closeAll=True)  # fmt: skip
