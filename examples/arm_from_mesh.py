"""A flexible arm from a finite element mesh: meshed, reduced to few modes, and moved by a motor.

The mesh has quadratic tetrahedra and tapers towards its end, where a mass is attached. Static modes of both ends and
six eigenmodes replace 5145 coordinates; deflections and stresses are available for every node.
"""

import matplotlib.pyplot as plt
import numpy as np
import skfem
from scipy.linalg import eigh
from skfem.io.meshio import to_meshio

import dalembert as db
from dalembert.FEM import FEMinterface, HCBstaticModeSelection, KirchhoffMaterial
from dalembert.utilities import SmoothStep

length, root_height, tip_height, width = 0.8, 0.06, 0.03, 0.02  # m
aluminium = KirchhoffMaterial(youngsModulus=7e10, poissonsRatio=0.33, density=2700)
payload = 1.5  # kg

# the mesh: a block of tetrahedra with nodes on their edges, that becomes less high towards its end
grid = [np.linspace(0, length, 25), np.linspace(-0.5, 0.5, 4), np.linspace(-width / 2, width / 2, 3)]
mesh = to_meshio(skfem.MeshTet2.from_mesh(skfem.MeshTet.init_tensor(*grid)))
along = mesh.points[:, 0] / length
mesh.points[:, 1] *= root_height + (tip_height - root_height) * along

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
fem.ComputePostProcessingModes(aluminium, db.OutputVariableType.StressLocal)

# the body, on a motor that turns it by a right angle in 0.3 s, with the mass in its hand
model = db.Model()
arm = model.create_ffrf_reduced_order_object("arm", fem, stiffness_proportional_damping=2e-5)
body = arm["FFRFReducedOrderObjectDict"]["oFFRFreducedOrder"]


def motor(mbs, t, itemNumber, offset):
    return [0, 0, 0, 0, 0, SmoothStep(t, 0, 0.3, 0, np.pi / 2)]


ground = model.add(db.MarkerBodyRigid(bodyNumber=model.ground))
model.add(db.ObjectJointGeneric(markerNumbers=[ground, arm["arm:hub"]], offsetUserFunction=motor))
mass = model.create_mass_point(reference_position=[length, 0, 0], physics_mass=payload)
hand = model.add(db.MarkerBodyPosition(bodyNumber=mass))
model.add(db.ObjectJointSpherical(markerNumbers=[arm["arm:hand"], hand]))

tip = fem.GetNodeAtPoint([length, 0, 0], tolerance=0.01)
root = fem.GetNodeAtPoint([0.1 * length, 0.5 * (0.9 * root_height + 0.1 * tip_height), 0], tolerance=0.01)
deflection = model.create_sensor(body, "displacement_local", mesh_node=tip, name="deflection of the hand")
stress = model.create_sensor(body, "stress_local", mesh_node=root, name="stress near the hub")

settings = db.SimulationSettings()
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.8
solution = model.solve(end_time=0.6, step_size=5e-4, every=1e-3, settings=settings)

# results, compared with those of the whole mesh
section = 0.5 * (root_height + tip_height) * width
print(f"mass of the arm: {fem.GetRigidBodyInertia().mass:.4f} kg, of a tapered bar {2700 * section * length:.4f} kg")

modes = fem.modeBasis["matrix"]
K, M = (modes.T @ matrix @ modes for matrix in (fem.GetStiffnessMatrix(), fem.GetMassMatrix()))
frequencies = np.sqrt(eigh(K, M, eigvals_only=True)) / (2 * np.pi)
fem.ComputeEigenModesWithBoundaryNodes(interfaces[0], 3)
whole = fem.GetEigenFrequenciesHz()
print(f"first frequency with the hub held: {frequencies[0]:.3f} Hz, of the whole mesh {whole[0]:.3f} Hz")
print(f"second frequency: {frequencies[1]:.3f} Hz, of the whole mesh {whole[1]:.3f} Hz")

t, along_arm = stress.time, stress.values[:, 0]
acceleration = np.gradient(np.gradient([SmoothStep(ti, 0, 0.3, 0, np.pi / 2) for ti in t], t), t)
print(f"largest stress: {np.abs(along_arm).max() / 1e6:.1f} MPa")
print(f"largest angular acceleration: {acceleration.max():.0f} rad/s^2")
solution.plot(deflection, file_name="arm_deflection.png")
plt.figure()
plt.plot(t, along_arm)
plt.gca().set(xlabel="time (s)", ylabel="stress near the hub (Pa)")
plt.savefig("arm_stress.png")
model.system.SetObjectParameter(body, "VshowNodes", False)
view = model.container.visualizationSettings
view.nodes.show = view.markers.show = view.connectors.show = False
view.view0.scene.showMeshEdges = False
view.contour.outputVariable, view.contour.outputVariableComponent = db.OutputVariableType.StressLocal, 0  # along it
view.contour.automaticRange, view.contour.minValue, view.contour.maxValue = False, -1.5e7, 1.5e7
model.draw(file_name="arm_picture.png")
solution.animate(file_name="arm_motion.gif", window_size=[480, 360], frames_per_second=20, speed=0.15, view="front")
