"""A planar cable element chain as cantilever: bent statically by a force at its tip, then let go.

The bent shape is the elastica, whose tip is known in terms of elliptic integrals.
"""

from itertools import pairwise

import numpy as np
from scipy.optimize import brentq
from scipy.special import ellipe, ellipeinc, ellipk, ellipkinc

import dalembert as db

length, elements = 2.0, 8
EI, EA, mass, force = 5.0, 1e4, 0.5, 3.0  # N m^2, N, kg/m, N


def elastica():
    """Displacement of the tip of an inextensible beam: components along the beam and along the force."""
    load = force * length**2 / EI

    def begin(m):
        """Amplitude at the clamp, for the parameter m = (1 + sin(angle of the tip)) / 2."""
        return np.arcsin(np.sqrt(0.5 / m))

    m = brentq(lambda m: ellipk(m) - ellipkinc(begin(m), m) - np.sqrt(load), 0.5 + 1e-12, 1 - 1e-12)
    across = 1 - 2 / np.sqrt(load) * (ellipe(m) - ellipeinc(begin(m), m))
    return (1 - np.sqrt((4 * m - 2) / load)) * length, across * length


model = db.Model()
h = length / elements
nodes = [model.add(db.NodePoint2DSlope1(referenceCoordinates=[i * h, 0, 1, 0])) for i in range(elements + 1)]
for left, right in pairwise(nodes):
    model.add(
        db.ObjectANCFCable2D(
            nodeNumbers=[left, right],
            physicsLength=h,
            physicsMassPerLength=mass,
            physicsBendingStiffness=EI,
            physicsBendingDamping=0.02,
            physicsAxialStiffness=EA,
            visualization=db.VObjectANCFCable2D(drawHeight=0.03),
        )
    )

# the clamp holds position and direction of the first node: three of its four coordinates
fixed = model.add(db.MarkerNodeCoordinate(nodeNumber=model.add(db.NodePointGround()), coordinate=0))
for coordinate in (0, 1, 3):
    moving = model.add(db.MarkerNodeCoordinate(nodeNumber=nodes[0], coordinate=coordinate))
    model.add(db.ObjectConnectorCoordinate(markerNumbers=[fixed, moving]))

tip = nodes[-1]
load = model.add(
    db.LoadForceVector(markerNumber=model.add(db.MarkerNodePosition(nodeNumber=tip)), loadVector=[0, -force, 0])
)

settings = db.SimulationSettings()
settings.linearSolverType = db.LinearSolverType.EigenSparse
settings.staticSolver.verboseMode = 0
model.solve_static(load_steps=5, update_initial_values=True, settings=settings)
for value, exact in zip(tip.displacement, elastica(), strict=False):
    print(f"static displacement: {-value:.5f} m, elastica {exact:.5f} m")

model.container.visualizationSettings.contour.outputVariable = (
    db.OutputVariableType.TorqueLocal
)  # bending moment, as color
model.draw(file_name="cantilever_picture.png")
load.load_vector = [0, 0, 0]
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.8
solution = model.solve(end_time=3, step_size=5e-3, settings=settings)
solution.plot((tip, "displacement"), file_name="cantilever.png")
print("displacement at the end", tip.displacement[:2])
