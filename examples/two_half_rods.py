"""Two halves of a rod, each a system of matrices, are joined at their ends: the frequencies are those of the whole.

The matrices may come from other programs, or from measurements. A vector constraint uses markers with all coordinates
of each half, and couples them by a row of factors; modes of the free rod are c n / (2 L).
"""

import matplotlib.pyplot as plt
import numpy as np

import dalembert as db

length, area, modulus, density = 1.0, 1e-4, 2.1e11, 7850.0  # m, m^2, N/m^2, kg/m^3
elements = 40  # per half
h = 0.5 * length / elements

ends = np.array([[1, -1], [-1, 1]]) * modulus * area / h
masses = np.array([[2, 1], [1, 2]]) * density * area * h / 6
stiffness, mass = np.zeros((2, elements + 1, elements + 1))
for i in range(elements):
    stiffness[i : i + 2, i : i + 2] += ends
    mass[i : i + 2, i : i + 2] += masses
damping = 2e-8 * stiffness

model = db.Model()
zeros = [0.0] * (elements + 1)
halves = []
for name in ("left half", "right half"):
    node = model.add(
        db.NodeGenericODE2(
            referenceCoordinates=zeros, initialCoordinates=zeros, initialCoordinates_t=zeros,
            numberOfODE2Coordinates=elements + 1,
        )
    )  # fmt: skip
    halves.append(
        model.add(
            db.ObjectGenericODE2(
                name, nodeNumbers=[node], massMatrix=mass, stiffnessMatrix=stiffness, dampingMatrix=damping
            )
        )
    )
markers = [model.add(db.MarkerObjectODE2Coordinates(objectNumber=half)) for half in halves]
last, first = np.eye(elements + 1)[[-1]], np.eye(elements + 1)[[0]]
weld = model.add(db.CoordinateVectorConstraint(markerNumbers=markers, scalingMarker0=last, scalingMarker1=first))
pull = model.add(db.MarkerNodeCoordinate(nodeNumber=1, coordinate=elements))
model.add(db.LoadCoordinate(markerNumber=pull, loadUserFunction=lambda mbs, t, load: 1e3 if t < 2e-5 else 0.0))
model.assemble()

values, _ = model.system.ComputeODE2Eigenvalues(computeComplexEigenvalues=False)
found = np.sqrt(np.maximum(values, 0)) / (2 * np.pi)
speed = np.sqrt(modulus / density)  # of sound
for i, name in enumerate(("first", "second", "third"), 1):
    print(f"{name} frequency: {found[i]:.2f} Hz, of the whole rod {i * speed / (2 * length):.2f} Hz")

solution = model.solve(end_time=4e-4, step_size=5e-7)
plt.plot(solution.times, solution[model.nodes[1]].coordinates[:, elements])
plt.gca().set(xlabel="time (s)", ylabel="displacement of the pulled end (m)")
plt.savefig("rod_end.png")
