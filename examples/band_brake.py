"""A band around a turning drum brakes it: contact of a cable with a circle, with dry friction.

A weight pulls at one end of the band, a spring holds the other end. If the drum slips everywhere, the tension grows
along the angle of wrap by the factor exp(coefficient * angle) (Euler and Eytelwein), independently of the radius and of
the stiffness of the band.
"""

import numpy as np

import dalembert as db
from dalembert.beams import GenerateCircularArcANCFCable2D
from dalembert.utilities import GenerateStraightLineANCFCable2D

radius, wrap, friction, weight = 0.5, np.pi, 0.3, 20.0  # m, rad, 1, N
speed, elements, free = 2.0, 32, 0.4  # rad/s, 1, m

model = db.Model()
band = db.Cable2D(
    physicsMassPerLength=0.2,
    physicsBendingStiffness=1e-4,
    physicsAxialStiffness=1e5,
    physicsAxialDamping=1e3,
    physicsBendingDamping=1e-3,
    visualization=db.VCable2D(drawHeight=0.02),
)
# upwards on the right side, around the drum, and down on the left
right, left, down = [radius, 0, 0], [-radius, 0, 0], np.array([0, -free, 0])
begin = GenerateStraightLineANCFCable2D(model.system, list(right + down), right, 4, band)
around = GenerateCircularArcANCFCable2D(
    model.system,
    right,
    radius,
    np.pi / 2,
    wrap,
    elements,
    band,
    nodeNumber0=begin[0][-1],
    setCurvedReferenceConfiguration=False,
)
end = GenerateStraightLineANCFCable2D(model.system, left, list(left + down), 4, band, nodeNumber0=around[0][-1])

ground = model.add(db.ObjectGround(referencePosition=list(right + down)))
hold = model.add(
    db.CartesianSpringDamper(
        markerNumbers=[
            model.add(db.MarkerBodyPosition(bodyNumber=ground)),
            model.add(db.MarkerNodePosition(nodeNumber=begin[0][0])),
        ],
        stiffness=[1e5] * 3,
        damping=[50] * 3,
    )
)
model.add(db.Force(markerNumber=model.add(db.MarkerNodePosition(nodeNumber=end[0][-1])), loadVector=[0, -weight, 0]))

shape = db.graphics.Cylinder(
    [0, 0, -0.05], [0, 0, 0.1], radius=0.97 * radius, nTiles=64, color=db.graphics.color.steelblue
)
drum = model.add(db.NodeRigidBody2D(initialVelocities=[0, 0, speed]))
model.add(
    db.RigidBody2D(
        physicsMass=1, physicsInertia=1, nodeNumber=drum, visualization=db.VRigidBody2D(graphicsData=[shape])
    )
)
fixed = model.add(db.MarkerNodeCoordinate(nodeNumber=model.add(db.NodePointGround()), coordinate=0))
drives = []
for coordinate in range(3):  # its axis rests, and it turns at a constant speed
    held = model.add(db.MarkerNodeCoordinate(nodeNumber=drum, coordinate=coordinate))
    turns = coordinate == 2
    drives.append(
        model.add(
            db.CoordinateConstraint(markerNumbers=[fixed, held], velocityLevel=turns, offset=speed if turns else 0)
        )
    )

contact = model.system.AddGeneralContact()
contact.SetFrictionPairings([[friction]])
contact.SetFrictionProportionalZone(0.01)  # the drum slips a hundred times faster
surface = {"contactStiffness": 1e6, "contactDamping": 200, "frictionMaterialIndex": 0}
contact.AddSphereWithMarker(model.add(db.MarkerNodeRigid(nodeNumber=drum)), radius=radius, **surface)
for element in [*begin[1], *around[1], *end[1]]:
    contact.AddANCFCable(element, halfHeight=0, **surface)

settings = db.SimulationSettings()
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.6
model.solve(end_time=1.5, step_size=1e-3, settings=settings)

tension = np.linalg.norm(hold.force)
theory = weight * np.exp(friction * wrap)
torque = abs(drives[2].force)
print(f"tension of the tight side: {tension:.3f} N, by Euler and Eytelwein {theory:.3f} N")
print(f"torque of the drive: {torque:.3f} Nm, by the difference of tensions {radius * (theory - weight):.3f} Nm")

shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = shown.connectors.show = False
shown.contour.outputVariable = db.OutputVariableType.ForceLocal  # normal force, as color
model.draw(file_name="band_brake_picture.png")
