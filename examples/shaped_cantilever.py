"""A cantilever that carries a mass at its tip, shaped for the frequency of a uniform one with least material.

Heights of all elements are parameters. The gradient of the frequency comes from one static solution, and a method for
constraints (SLSQP) finds the lightest beam. For a beam whose own mass does not matter, the shape has a closed form:
with compliances a_i / h_i^3 of elements, the material is used best where h_i is proportional to a_i^(1/4).
"""

from itertools import pairwise

import numpy as np
from scipy.optimize import minimize

import dalembert as db

length, width, elements, tip = 1.2, 0.05, 12, 400.0  # m, m, -, kg
E, density, uniform = 7e10, 2700, 0.04  # N/m^2, kg/m^3, m

model = db.Model()
fixed = model.add(db.MarkerNodeCoordinate(nodeNumber=model.add(db.NodePointGround()), coordinate=0))
names, size = [f"beam {i}" for i in range(elements)], length / elements


def add_beam(y, heights):
    """Add a cantilever with a mass; the first one has names, by which its heights are parameters."""
    nodes = [model.add(db.NodePoint2DSlope1(referenceCoordinates=[i * size, y, 1, 0])) for i in range(elements + 1)]
    for name, ends, h in zip(names, pairwise(nodes), heights, strict=True):
        section = {"physicsMassPerLength": density * width * h, "physicsAxialStiffness": E * width * h}
        model.add(
            db.ObjectANCFCable2D(
                name=name if y == 0 else "", nodeNumbers=ends, physicsLength=size, **section,
                physicsBendingStiffness=E * width * h**3 / 12, visualization=db.VObjectANCFCable2D(drawHeight=h),
            )
        )  # fmt: skip
    for coordinate in (0, 1, 3):
        moving = model.add(db.MarkerNodeCoordinate(nodeNumber=nodes[0], coordinate=coordinate))
        model.add(db.CoordinateConstraint(markerNumbers=[fixed, moving]))
    load = db.graphics.Sphere(radius=0.06, color=db.graphics.color.orange, nTiles=32)
    model.add(db.MassPoint2D(physicsMass=tip, nodeNumber=nodes[-1], visualization=db.VMassPoint2D(graphicsData=[load])))


add_beam(0, np.full(elements, uniform))
model.assemble()
height = {
    name: db.DesignParameter(uniform, {(name, "physicsBendingStiffness"): lambda h: E * width * h**3 / 12,
                                        (name, "physicsAxialStiffness"): E * width,
                                        (name, "physicsMassPerLength"): density * width})
    for name in names
}  # fmt: skip
twin = db.DifferentiableModel(model.system, height, {"omega^2": db.Eigenvalue(0)}, solverType="static")
wanted = twin.Values(twin.x0)["omega^2"]


def frequency(x):
    """Return the square of the frequency and its gradient, relative to the wanted one; x: relative heights."""
    value, gradient = twin.ValueAndGradient(uniform * x)
    return value / wanted - 1, gradient * uniform / wanted


found = minimize(
    np.mean, np.ones(elements), jac=lambda x: np.full(elements, 1 / elements), bounds=[(0.05, 3)] * elements,
    method="SLSQP", options={"ftol": 1e-9},
    constraints={"type": "eq", "fun": lambda x: frequency(x)[0], "jac": lambda x: frequency(x)[1]},
)  # fmt: skip

ends = np.linspace(length, 0, elements + 1) ** 3
compliance = (ends[:-1] - ends[1:]) / ends[0]  # parts of that of the uniform beam
best = compliance**0.25 * np.sum(compliance**0.25) ** (1 / 3)
for where, i in (("clamp", 0), ("tip", -1)):
    print(f"height at the {where}: {1e3 * uniform * found.x[i]:.3f} mm, closed form {1e3 * uniform * best[i]:.3f} mm")
print(f"material: {100 * found.fun:.3f} %, closed form {100 * best.mean():.3f} %")

add_beam(-0.4, uniform * found.x)
model.assemble()
frequencies = model.system.ComputeVibrationModes(2).frequencies
print(f"frequency after: {frequencies[0]:.4f} Hz, before {frequencies[1]:.4f} Hz")
shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = shown.connectors.show = False
model.draw(file_name="shaped_cantilever_picture.png")
