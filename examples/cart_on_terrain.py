"""A cart rolls through hilly terrain: its wheels are spheres in contact with a mesh of triangles.

The wheels turn in joints, and creep a little by friction. The cart has neither brake nor drive: its potential energy is
converted to kinetic energy, including the spin of the wheels.
"""

import numpy as np

import dalembert as exu
from dalembert.utilities import *

radius, wheel_mass, frame_mass, gravity = 0.15, 2.0, 20.0, 9.81  # m, kg, kg, m/s^2
long, wide, friction, stiffness = 0.8, 0.6, 0.8, 2e5  # m, m, 1, N/m


def height(x, y):
    return 0.5 * np.cos(0.9 * x) + 0.03 * np.sin(1.5 * x) * np.cos(2 * y)


mbs = exu.SystemContainer().AddSystem()

# ---- the terrain: two triangles per cell
x, y = np.meshgrid(np.linspace(-1, 8, 181), np.linspace(-1.5, 1.5, 61), indexing="ij")
points = np.stack([x, y, height(x, y)], axis=-1).reshape(-1, 3)
corner = np.add.outer(np.arange(180) * 61, np.arange(60)).ravel()
triangles = np.concatenate(
    [np.stack([corner, corner + 61, corner + 62], axis=1), np.stack([corner, corner + 62, corner + 1], axis=1)]
)
ground = mbs.CreateGround(graphicsDataList=[graphics.FromPointsAndTrigs(points, triangles, color=[0.5, 0.65, 0.4, 1])])
contact = mbs.AddGeneralContact()
contact.SetFrictionPairings([[friction]])
contact.SetFrictionProportionalZone(0.005)
surface = {"contactStiffness": stiffness, "contactDamping": 300, "frictionMaterialIndex": 0}
contact.AddTrianglesRigidBodyBased(
    mbs.AddMarker(MarkerBodyRigid(bodyNumber=ground)), pointList=points, triangleList=triangles, **surface
)

# ---- the cart, above the begin of a slope
begin = np.array([0.9, 0.0])
slope = np.arctan((height(begin[0] + long / 2, 0) - height(begin[0] - long / 2, 0)) / long)
turn = RotationMatrixY(-slope)
middle = np.array([*begin, height(*begin) + radius + 0.05])
inertia = InertiaCuboid(frame_mass / (long * wide * 0.2), [long, wide, 0.2])
shape = graphics.Brick(size=[long, 0.6 * wide, 0.1], color=graphics.color.orange)
frame = mbs.CreateRigidBody(
    "frame",
    referencePosition=list(middle),
    referenceRotationMatrix=turn,
    inertia=inertia,
    gravity=[0, 0, -gravity],
    graphicsDataList=[shape],
)
wheels = []
for side_x in (-1, 1):
    for side_y in (-1, 1):
        place = middle + turn @ [side_x * long / 2, side_y * wide / 2, 0]
        wheel = mbs.CreateRigidBody(
            referencePosition=list(place),
            referenceRotationMatrix=turn,
            inertia=InertiaSphere(wheel_mass, radius),
            gravity=[0, 0, -gravity],
            graphicsDataList=[graphics.Sphere(radius=radius, color=graphics.color.steelblue, nTiles=24)],
        )
        mbs.CreateRevoluteJoint(bodyNumbers=[frame, wheel], position=list(place), axis=[0, 1, 0])
        contact.AddSphereWithMarker(mbs.AddMarker(MarkerBodyRigid(bodyNumber=wheel)), radius=radius, **surface)
        wheels.append(wheel)
mbs.Assemble()

# ---- it first settles on its wheels; the energy balance starts then --------------------------------------------------
settings = exu.SimulationSettings()
settings.solutionSettings.solutionWritePeriod = 0.02
settings.timeIntegration.verboseMode = 0
settings.timeIntegration.discontinuous.iterationTolerance = 0.1
step, energies = 1e-3, []
for start, end in ((0, 0.3), (0.3, 1.5)):
    settings.timeIntegration.startTime, settings.timeIntegration.endTime = start, end
    settings.timeIntegration.numberOfSteps = round((end - start) / step)
    mbs.SolveDynamic(settings)
    energies.append(mbs.ComputeEnergies())
    mbs.systemData.SetSystemState(mbs.systemData.GetSystemState(), exu.ConfigurationType.Initial)
    mbs.systemData.SetODE2Coordinates_tt(mbs.systemData.GetODE2Coordinates_tt(), exu.ConfigurationType.Initial)

gained, lost = energies[1].kinetic - energies[0].kinetic, energies[0].potential - energies[1].potential
print(f"energy of motion: {gained:.2f} J, by the height that was lost {lost:.2f} J")

SC = mbs.GetSystemContainer()
view = SC.visualizationSettings
view.nodes.show = view.markers.show = view.loads.show = view.connectors.show = False
mbs.Draw(fileName="cart_on_terrain_picture.png")
mbs.DrawSolution(fileName="cart_motion.gif", windowSize=[420, 320], framesPerSecond=20, speed=0.4)
