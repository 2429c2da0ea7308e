"""A band around a turning drum brakes it: contact of a cable with a circle, with dry friction.

A weight pulls at one end of the band, a spring holds the other end. If the drum slips everywhere, the tension grows
along the angle of wrap by the factor exp(coefficient * angle) (Euler and Eytelwein), independently of the radius and of
the stiffness of the band.
"""

import numpy as np

import dalembert as exu
from dalembert.beams import GenerateCircularArcANCFCable2D
from dalembert.utilities import *

radius, wrap, friction, weight = 0.5, np.pi, 0.3, 20.0  # m, rad, 1, N
speed, elements, free = 2.0, 32, 0.4  # rad/s, 1, m

mbs = exu.SystemContainer().AddSystem()
band = Cable2D(
    physicsMassPerLength=0.2,
    physicsBendingStiffness=1e-4,
    physicsAxialStiffness=1e5,
    physicsAxialDamping=1e3,
    physicsBendingDamping=1e-3,
    visualization=VCable2D(drawHeight=0.02),
)
# upwards on the right side, around the drum, and down on the left
right, left, down = [radius, 0, 0], [-radius, 0, 0], np.array([0, -free, 0])
begin = GenerateStraightLineANCFCable2D(mbs, list(right + down), right, 4, band)
around = GenerateCircularArcANCFCable2D(
    mbs, right, radius, np.pi / 2, wrap, elements, band, nodeNumber0=begin[0][-1], setCurvedReferenceConfiguration=False
)
end = GenerateStraightLineANCFCable2D(mbs, left, list(left + down), 4, band, nodeNumber0=around[0][-1])

ground = mbs.AddObject(ObjectGround(referencePosition=list(right + down)))
hold = mbs.AddObject(
    CartesianSpringDamper(
        markerNumbers=[
            mbs.AddMarker(MarkerBodyPosition(bodyNumber=ground)),
            mbs.AddMarker(MarkerNodePosition(nodeNumber=begin[0][0])),
        ],
        stiffness=[1e5] * 3,
        damping=[50] * 3,
    )
)
mbs.AddLoad(Force(markerNumber=mbs.AddMarker(MarkerNodePosition(nodeNumber=end[0][-1])), loadVector=[0, -weight, 0]))

shape = graphics.Cylinder([0, 0, -0.05], [0, 0, 0.1], radius=0.97 * radius, nTiles=64, color=graphics.color.steelblue)
drum = mbs.AddNode(NodeRigidBody2D(initialVelocities=[0, 0, speed]))
mbs.AddObject(
    RigidBody2D(physicsMass=1, physicsInertia=1, nodeNumber=drum, visualization=VRigidBody2D(graphicsData=[shape]))
)
fixed = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
drives = []
for coordinate in range(3):  # its axis rests, and it turns at a constant speed
    held = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=drum, coordinate=coordinate))
    turns = coordinate == 2
    drives.append(
        mbs.AddObject(
            CoordinateConstraint(markerNumbers=[fixed, held], velocityLevel=turns, offset=speed if turns else 0)
        )
    )

contact = mbs.AddGeneralContact()
contact.SetFrictionPairings([[friction]])
contact.SetFrictionProportionalZone(0.01)  # the drum slips a hundred times faster
surface = {"contactStiffness": 1e6, "contactDamping": 200, "frictionMaterialIndex": 0}
contact.AddSphereWithMarker(mbs.AddMarker(MarkerNodeRigid(nodeNumber=drum)), radius=radius, **surface)
for element in [*begin[1], *around[1], *end[1]]:
    contact.AddANCFCable(element, halfHeight=0, **surface)
mbs.Assemble()

settings = exu.SimulationSettings()
settings.solutionSettings.writeSolutionToFile = False
settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 1.5, 1500
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.6
settings.timeIntegration.verboseMode = 0
mbs.SolveDynamic(settings)

tension = np.linalg.norm(mbs.GetObjectOutput(hold, exu.OutputVariableType.Force))
theory = weight * np.exp(friction * wrap)
torque = abs(mbs.GetObjectOutput(drives[2], exu.OutputVariableType.Force))
print(f"tension of the tight side: {tension:.3f} N, by Euler and Eytelwein {theory:.3f} N")
print(f"torque of the drive: {torque:.3f} Nm, by the difference of tensions {radius * (theory - weight):.3f} Nm")

SC = mbs.GetSystemContainer()
SC.visualizationSettings.nodes.show = SC.visualizationSettings.markers.show = False
SC.visualizationSettings.connectors.show = False
SC.visualizationSettings.contour.outputVariable = exu.OutputVariableType.ForceLocal  # normal force, as color
mbs.Draw(fileName="band_brake_picture.png")
