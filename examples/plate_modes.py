"""Vibrations of a square plate whose edges rest on a frame, and its deflection under weight.

Elements of thin plates have nodes with two slopes. Edges are simply supported: fixed coordinates are sufficient.
Frequencies and deflection are those of Kirchhoff's theory, up to the error of the mesh.
"""

import numpy as np

import dalembert as db

side, h, E, nu, density, g = 0.6, 2e-3, 70e9, 0.3, 2700, 9.81  # m, m, Pa, 1, kg/m^3, m/s^2
elements = 12  # per side
stretch = E * h / (1 - nu**2) * np.array([[1, nu, 0], [nu, 1, 0], [0, 0, (1 - nu) / 2]])
bending = h**2 / 12 * stretch

model = db.Model()
places = np.linspace(0, side, elements + 1)
nodes = [
    [model.add(db.NodePointSlope12(referenceCoordinates=[x, y, 0, 1, 0, 0, 0, 1, 0])) for y in places] for x in places
]
plates = []
for i in range(elements):
    for j in range(elements):
        corners = [nodes[i][j], nodes[i + 1][j], nodes[i + 1][j + 1], nodes[i][j + 1]]
        plate = model.add(
            db.ObjectANCFThinPlate(
                nodeNumbers=corners,
                physicsThickness=[h],
                physicsDensity=density,
                physicsStrainCoefficients=[stretch],
                physicsCurvatureCoefficients=[bending],
            )
        )
        weight = model.add(db.MarkerBodyMass(bodyNumber=plate))
        model.add(db.LoadMassProportional(markerNumber=weight, loadVector=[0, 0, -g]))
        plates.append(plate)

# the frame: no edge moves up or down, nor does its slope along the edge; two corners hold the plate in its plane
ground = model.add(db.MarkerNodeCoordinate(nodeNumber=model.add(db.NodePointGround()), coordinate=0))
held = set()
for k in range(elements + 1):
    held |= {(0, k, 2), (elements, k, 2), (k, 0, 2), (k, elements, 2)}  # z of the edges
    held |= {(0, k, 8), (elements, k, 8), (k, 0, 5), (k, elements, 5)}  # z of the slope along them
held |= {(0, 0, 0), (0, 0, 1), (elements, 0, 1)}
for i, j, coordinate in sorted(held):
    marker = model.add(db.MarkerNodeCoordinate(nodeNumber=nodes[i][j], coordinate=coordinate))
    model.add(
        db.CoordinateConstraint(markerNumbers=[ground, marker], visualization=db.VCoordinateConstraint(show=False))
    )
model.assemble()

values, _ = model.system.ComputeODE2Eigenvalues(computeComplexEigenvalues=False)
frequencies = np.sqrt(np.maximum(values, 0)) / (2 * np.pi)
flexural = np.sqrt(bending[0, 0] / (density * h)) * np.pi / (2 * side**2)  # times m^2 + n^2 half waves
for name, waves in (("first", 2), ("second", 5), ("third, with four bulges,", 8)):
    theory = waves * flexural
    found = frequencies[np.abs(frequencies - theory).argmin()]
    print(f"{name} frequency: {found:.3f} Hz, theory of Kirchhoff {theory:.3f} Hz")

model.solve_static()
deflection = -nodes[elements // 2][elements // 2].displacement[2]
odd = np.arange(1, 60, 2)
m, n = np.meshgrid(odd, odd)
series = (np.sin(m * np.pi / 2) * np.sin(n * np.pi / 2) / (m * n * (m**2 + n**2) ** 2)).sum()
theory = 16 * density * h * g * side**4 / (np.pi**6 * bending[0, 0]) * series  # Navier
print(f"deflection of the middle: {1e3 * deflection:.4f} mm, series of Navier {1e3 * theory:.4f} mm")

shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = shown.loads.show = False
shown.contour.outputVariable = db.OutputVariableType.Displacement
shown.contour.outputVariableComponent = 2
model.draw(file_name="plate_picture.png", view="axonometric")
