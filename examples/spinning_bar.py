"""A rubber bar spins about its middle, with all coordinates of its mesh, and becomes longer.

The stress of a cross section at the distance x from the middle, at the speed w, is density w^2 (L^2 / 4 - x^2) / 2. The
elongation of the bar for small strains is density w^2 L^3 / (12 E).
"""

import numpy as np

import dalembert as exu
from dalembert.FEM import FEMinterface, KirchhoffMaterial, ObjectFFRFinterface
from dalembert.utilities import *

length, width, speed = 1.0, 0.04, 40.0  # m, m, rad/s
rubber = KirchhoffMaterial(youngsModulus=2e8, poissonsRatio=0.0, density=1100)
elements = 20

fem = FEMinterface()
places = np.linspace(-0.5 * length, 0.5 * length, elements + 1)
section = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)]
corners = [[x, width * y, width * z] for x in places for y, z in section]
fem.SetMesh(corners, {"Hex8": [[4 * i + k for k in (0, 1, 2, 3, 4, 5, 6, 7)] for i in range(elements)]})
fem.AssembleMatrices(rubber)

mbs = exu.SystemContainer().AddSystem()
made = ObjectFFRFinterface(fem).AddObjectFFRF(
    exu, mbs, initialAngularVelocity=[0, 0, speed], stiffnessProportionalDamping=2e-3
)
faces = [[n for n, corner in enumerate(corners) if abs(corner[0] - x) < 1e-9] for x in (-0.5 * length, 0, 0.5 * length)]
left, right = (
    mbs.AddMarker(
        MarkerSuperElementPosition(bodyNumber=made["oFFRF"], meshNodeNumbers=face, weightingFactors=[0.25] * 4)
    )
    for face in (faces[0], faces[2])
)
middle = mbs.AddMarker(
    MarkerSuperElementRigid(bodyNumber=made["oFFRF"], meshNodeNumbers=faces[1], weightingFactors=[0.25] * 4)
)
mbs.CreateGround("ground")
shaft = mbs.AddMarker(MarkerBodyRigid(bodyNumber="ground"))
mbs.AddObject(
    GenericJoint(
        "motor", markerNumbers=[shaft, middle],
        offsetUserFunction=lambda mbs, t, item, offset: [0, 0, 0, 0, 0, speed * t],
    )
)  # fmt: skip
position = exu.OutputVariableType.Position
ends = [
    mbs.AddSensor(SensorMarker(markerNumber=marker, outputVariableType=position, storeInternal=True))
    for marker in (left, right)
]
mbs.Assemble()

settings = exu.SimulationSettings()
settings.timeIntegration.endTime = 0.08
settings.timeIntegration.numberOfSteps = 400
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.6
settings.solutionSettings.solutionWritePeriod = settings.timeIntegration.endTime / 60
settings.solutionSettings.sensorsWritePeriod = 4e-4
mbs.SolveDynamic(settings)

first, second = (mbs.GetSensorStoredData(end) for end in ends)
longer = np.linalg.norm(second[:, 1:] - first[:, 1:], axis=1) - length
theory = rubber.density * speed**2 * length**3 / (12 * rubber.youngsModulus)
print(f"it gets longer by: {1e3 * longer[-1]:.4f} mm, of small strains {1e3 * theory:.4f} mm")
mbs.PlotSensor(
    [np.column_stack([first[:, 0], 1e3 * longer])], components=[0], yLabel="growth of length (mm)", labels="bar",
    fileName="bar_growth.png", closeAll=True,
)  # fmt: skip
shown = mbs.GetSystemContainer().visualizationSettings
shown.nodes.show = shown.markers.show = shown.loads.show = shown.sensors.show = shown.connectors.show = False
shown.contour.outputVariable = exu.OutputVariableType.DisplacementLocal
mbs.Draw(fileName="bar_picture.png", view="axonometric")
in_a_second = settings.timeIntegration.endTime / 3
mbs.DrawSolution(
    fileName="bar_motion.gif", windowSize=[420, 320], framesPerSecond=20, speed=in_a_second, view="axonometric"
)
