"""A rubber bar spins about its middle, with all coordinates of its mesh, and becomes longer.

The stress of a cross section at the distance x from the middle, at the speed w, is density w^2 (L^2 / 4 - x^2) / 2. The
elongation of the bar for small strains is density w^2 L^3 / (12 E).
"""

import matplotlib.pyplot as plt
import numpy as np

import dalembert as db
from dalembert.FEM import FEMinterface, KirchhoffMaterial, ObjectFFRFinterface

length, width, speed = 1.0, 0.04, 40.0  # m, m, rad/s
rubber = KirchhoffMaterial(youngsModulus=2e8, poissonsRatio=0.0, density=1100)
elements = 20

fem = FEMinterface()
places = np.linspace(-0.5 * length, 0.5 * length, elements + 1)
section = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)]
corners = [[x, width * y, width * z] for x in places for y, z in section]
fem.SetMesh(corners, {"Hex8": [[4 * i + k for k in (0, 1, 2, 3, 4, 5, 6, 7)] for i in range(elements)]})
fem.AssembleMatrices(rubber)

model = db.Model()
made = ObjectFFRFinterface(fem).AddObjectFFRF(
    db, model.system, initialAngularVelocity=[0, 0, speed], stiffnessProportionalDamping=2e-3
)
faces = [[n for n, corner in enumerate(corners) if abs(corner[0] - x) < 1e-9] for x in (-0.5 * length, 0, 0.5 * length)]
left, right = (
    model.add(
        db.MarkerSuperElementPosition(bodyNumber=made["oFFRF"], meshNodeNumbers=face, weightingFactors=[0.25] * 4)
    )
    for face in (faces[0], faces[2])
)
middle = model.add(
    db.MarkerSuperElementRigid(bodyNumber=made["oFFRF"], meshNodeNumbers=faces[1], weightingFactors=[0.25] * 4)
)
shaft = model.add(db.MarkerBodyRigid(bodyNumber=model.ground))
model.add(
    db.GenericJoint(
        "motor", markerNumbers=[shaft, middle],
        offsetUserFunction=lambda mbs, t, item, offset: [0, 0, 0, 0, 0, speed * t],
    )
)  # fmt: skip

settings = db.SimulationSettings()
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.6
solution = model.solve(end_time=0.08, step_size=2e-4, settings=settings)

longer = np.linalg.norm(solution[right].position - solution[left].position, axis=1) - length
theory = rubber.density * speed**2 * length**3 / (12 * rubber.youngsModulus)
print(f"it gets longer by: {1e3 * longer[-1]:.4f} mm, of small strains {1e3 * theory:.4f} mm")
plt.plot(solution.times, 1e3 * longer)
plt.gca().set(xlabel="time (s)", ylabel="growth of length (mm)")
plt.savefig("bar_growth.png")
shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = shown.loads.show = shown.sensors.show = shown.connectors.show = False
shown.contour.outputVariable = db.OutputVariableType.DisplacementLocal
model.draw(file_name="bar_picture.png", view="axonometric")
solution.animate(
    file_name="bar_motion.gif", window_size=[420, 320], frames_per_second=20, speed=0.08 / 3, view="axonometric"
)
