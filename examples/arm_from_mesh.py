"""A flexible arm from a finite element mesh: meshed, reduced to few modes, and moved by a motor.

The mesh has quadratic tetrahedra and tapers towards its end, where a mass is attached. Static modes of both ends and
six eigenmodes replace 5145 coordinates; deflections and stresses are available for every
node.
"""

import numpy as np
import skfem
from scipy.linalg import eigh
from skfem.io.meshio import to_meshio

import dalembert as exu
from dalembert.FEM import FEMinterface, HCBstaticModeSelection, KirchhoffMaterial
from dalembert.utilities import *

length, rootHeight, tipHeight, width = 0.8, 0.06, 0.03, 0.02  # m
aluminium = KirchhoffMaterial(youngsModulus=7e10, poissonsRatio=0.33, density=2700)
payload = 1.5  # kg

# the mesh: a block of tetrahedra with nodes on their edges, that becomes less high towards its end
grid = [np.linspace(0, length, 25), np.linspace(-0.5, 0.5, 4), np.linspace(-width / 2, width / 2, 3)]
mesh = to_meshio(skfem.MeshTet2.from_mesh(skfem.MeshTet.init_tensor(*grid)))
along = mesh.points[:, 0] / length
mesh.points[:, 1] *= rootHeight + (tipHeight - rootHeight) * along

fem = FEMinterface()
fem.ImportFromMeshio(mesh)  # or the name of a file
fem.VolumeToSurfaceElements()  # surface for pictures
fem.AssembleMatrices(aluminium)
for name, x in (("hub", 0.0), ("hand", length)):
    fem.AddBoundary(name, fem.GetNodesInPlane(point=[x, 0, 0], normal=[1, 0, 0]))

# modes: both ends move as rigid bodies, the frame of reference sits in the hub
interfaces, weights = fem.GetBoundaryNodeSetsAsLists()
fem.ComputeHurtyCraigBamptonModes(
    interfaces, nEigenModes=6, boundaryNodesWeights=weights, computationMode=HCBstaticModeSelection.RBE2
)
fem.ComputePostProcessingModes(aluminium, exu.OutputVariableType.StressLocal)

# the body, on a motor that turns it by a right angle in 0.3 s, with the mass in its hand
mbs = exu.SystemContainer().AddSystem()
arm = mbs.CreateFFRFReducedOrderObject("arm", fem, stiffnessProportionalDamping=2e-5)
body = arm["FFRFReducedOrderObjectDict"]["oFFRFreducedOrder"]


def motor(mbs, t, itemNumber, offset):
    return [0, 0, 0, 0, 0, SmoothStep(t, 0, 0.3, 0, np.pi / 2)]


ground = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.CreateGround()))
mbs.AddObject(ObjectJointGeneric(markerNumbers=[ground, arm["arm:hub"]], offsetUserFunction=motor))
mass = mbs.CreateMassPoint(referencePosition=[length, 0, 0], physicsMass=payload)
hand = mbs.AddMarker(MarkerBodyPosition(bodyNumber=mass))
mbs.AddObject(ObjectJointSpherical(markerNumbers=[arm["arm:hand"], hand]))

tip = fem.GetNodeAtPoint([length, 0, 0], tolerance=0.01)
root = fem.GetNodeAtPoint([0.1 * length, 0.5 * (0.9 * rootHeight + 0.1 * tipHeight), 0], tolerance=0.01)
sensors = [
    mbs.AddSensor(
        SensorSuperElement(bodyNumber=body, meshNodeNumber=node, outputVariableType=variable, storeInternal=True)
    )
    for node, variable in (
        (tip, exu.OutputVariableType.DisplacementLocal),
        (root, exu.OutputVariableType.StressLocal),
    )
]
mbs.Assemble()

settings = exu.SimulationSettings()
settings.timeIntegration.endTime = 0.6
settings.timeIntegration.numberOfSteps = 1200
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.8
settings.solutionSettings.sensorsWritePeriod = 1e-3
mbs.SolveDynamic(settings)

# results, compared with those of the whole mesh
section = 0.5 * (rootHeight + tipHeight) * width
print(f"mass of the arm: {fem.GetRigidBodyInertia().mass:.4f} kg, of a tapered bar {2700 * section * length:.4f} kg")

modes = fem.modeBasis["matrix"]
K, M = (modes.T @ matrix @ modes for matrix in (fem.GetStiffnessMatrix(), fem.GetMassMatrix()))
frequencies = np.sqrt(eigh(K, M, eigvals_only=True)) / (2 * np.pi)
fem.ComputeEigenModesWithBoundaryNodes(interfaces[0], 3)
whole = fem.GetEigenFrequenciesHz()
print(f"first frequency with the hub held: {frequencies[0]:.3f} Hz, of the whole mesh {whole[0]:.3f} Hz")
print(f"second frequency: {frequencies[1]:.3f} Hz, of the whole mesh {whole[1]:.3f} Hz")

t, stress = mbs.GetSensorStoredData(sensors[1])[:, :2].T
acceleration = np.gradient(np.gradient([SmoothStep(ti, 0, 0.3, 0, np.pi / 2) for ti in t], t), t)
print(f"largest stress: {np.abs(stress).max() / 1e6:.1f} MPa")
print(f"largest angular acceleration: {acceleration.max():.0f} rad/s^2")
mbs.PlotSensor(sensors[0], components=1, yLabel="deflection of the hand (m)", fileName="arm_deflection.png")
mbs.PlotSensor(sensors[1], components=0, yLabel="stress near the hub (Pa)", fileName="arm_stress.png")
mbs.SetObjectParameter(body, "VshowNodes", False)
view = mbs.GetSystemContainer().visualizationSettings
view.nodes.show = view.markers.show = view.connectors.show = False
view.view0.scene.showMeshEdges = False
view.contour.outputVariable, view.contour.outputVariableComponent = exu.OutputVariableType.StressLocal, 0  # along it
view.contour.automaticRange, view.contour.minValue, view.contour.maxValue = False, -1.5e7, 1.5e7
mbs.Draw(fileName="arm_picture.png")
in_a_second = settings.timeIntegration.endTime / 4
mbs.DrawSolution(fileName="arm_motion.gif", windowSize=[480, 360], framesPerSecond=20, speed=in_a_second, view="front")
