"""A belt drive: the driven pulley turns a little slower than the driving one, because of the strain of the belt.

The belt consists of axially moving cables: the material runs through fixed elements. The belt sticks to a pulley where
it enters, and slides only on the last part of the arc, where its tension changes from that of one side to that of the
other. The ratio of the speeds is (1 + T2/EA) / (1 + T1/EA) (O. Reynolds), independently of friction.
"""

import matplotlib.pyplot as plt
import numpy as np

import dalembert as db
from dalembert.beams import CreateReevingCurve, PointsAndSlopes2ANCFCable2D

radius, distance, speed = 0.1, 0.3, 50.0  # m, m, rad/s
stiffness, mass, friction = 2e4, 0.5, 0.4  # N, kg/m, 1
pull, moment = 1000.0, 20.0  # N, of both sides together; Nm
elements, segments = 40, 4  # the latter per element
end, steps, run_up = 0.2, 5000, 0.03  # s, 1, s

curve = CreateReevingCurve(
    [[[0, 0], radius, "L"], [[distance, 0], radius, "L"]], closedCurve=True, numberOfANCFnodes=elements
)
stretch = 1 + pull / 2 / stiffness  # the belt was made shorter than its way around the pulleys
length = curve["totalLength"] / elements / stretch
way = radius * speed  # m/s; along the curve, which is clockwise

model = db.Model()
fixed = model.add(db.MarkerNodeCoordinate(nodeNumber=model.add(db.NodePointGround()), coordinate=0))
runs = model.add(db.NodeGenericODE2(numberOfODE2Coordinates=1, referenceCoordinates=[0], initialCoordinates=[0],
                                   initialCoordinates_t=[way / stretch]))  # fmt: skip
belt = db.ALECable2D(
    nodeNumbers=[-1, -1, runs],
    physicsMassPerLength=mass,
    physicsBendingStiffness=1e-3,
    physicsAxialStiffness=stiffness,
    physicsAxialDamping=5,
    strainIsRelativeToReference=False,
    physicsAddALEvariation=False,
    visualization=db.VCable2D(drawHeight=0.006),
)
# one node is fixed along the belt, so that elements stay while the material moves
_, cables, *_ = PointsAndSlopes2ANCFCable2D(
    model.system, np.array(curve["ancfPointsSlopes"]) * [1, 1, stretch, stretch], [length] * elements, belt,
    massProportionalLoad=[0, 0, 0], fixedConstraintsNode0=[1, 0, 0, 0], firstNodeIsLastNode=True,
)  # fmt: skip
part = length / segments
pulleys, contacts = [], []
for x in (0, distance):
    disc = db.graphics.Cylinder([0, 0, -0.02], [0, 0, 0.015], 0.98 * radius, db.graphics.color.steelblue, nTiles=64)
    spoke = db.graphics.Brick([0, 0, -0.004], [1.8 * radius, 0.01, 0.001], db.graphics.color.orange)
    node = model.add(db.NodeRigidBody2D(referenceCoordinates=[x, 0, 0], initialVelocities=[0, 0, -speed]))
    body = model.add(
        db.RigidBody2D(physicsMass=1, physicsInertia=0.005, nodeNumber=node,
                    visualization=db.VRigidBody2D(graphicsData=[disc, spoke]))
    )  # fmt: skip
    pulleys.append(node)
    rim = model.add(db.MarkerBodyRigid(bodyNumber=body))
    contacts.append([])
    for cable in cables:
        shape = model.add(db.MarkerBodyCable2DShape(bodyNumber=cable, numberOfSegments=segments))
        states = model.add(
            db.NodeGenericData(numberOfDataCoordinates=3 * segments,
                            initialCoordinates=[0.1] * segments + [-2] * segments + [0] * segments)
        )  # fmt: skip
        contacts[-1].append(
            model.add(
                db.ObjectContactFrictionCircleCable2D(
                    markerNumbers=[rim, shape], nodeNumber=states, numberOfContactSegments=segments,
                    circleRadius=radius, contactStiffness=1e8 * part, contactDamping=1e4 * part,
                    frictionVelocityPenalty=1e5 * part, frictionCoefficient=friction,
                    visualization=db.VObjectContactFrictionCircleCable2D(show=False),
                )
            )
        )  # fmt: skip
coordinate = [[model.add(db.MarkerNodeCoordinate(nodeNumber=n, coordinate=k)) for k in range(3)] for n in pulleys]
for held in (coordinate[0][0], coordinate[0][1], coordinate[1][1]):
    model.add(db.CoordinateConstraint(markerNumbers=[fixed, held]))
# the first pulley drives; the second one brakes, and tensions the belt: the pull minus the bending force of the belt
model.add(db.CoordinateConstraint(markerNumbers=[fixed, coordinate[0][2]], velocityLevel=True, offset=-speed))
model.add(db.LoadCoordinate(markerNumber=coordinate[1][0], load=pull - 2 * mass * way**2))
model.add(db.CoordinateSpringDamper(markerNumbers=[fixed, coordinate[1][0]], damping=2000))
brake = lambda mbs, t, load: load * min(1.0, t / run_up)  # noqa: E731
model.add(db.LoadCoordinate(markerNumber=coordinate[1][2], load=moment, loadUserFunction=brake))

settings = db.SimulationSettings()
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.5
settings.timeIntegration.discontinuous.iterationTolerance = 1e-3
settings.timeIntegration.discontinuous.maxIterations = 10
solution = model.solve(end_time=end, step_size=end / steps, every=1e-3, settings=settings)
history = 100 * (1 + solution[pulleys[1]].angular_velocity[:, 2] / speed)
creep = np.mean(history[solution.times > 0.75 * end])  # minus the effect of segments that begin and end contact
tension = [solution[cable].force_local_at([length / 2, 0, 0])[-1] for cable in cables]
tight, slack = ((pull + sign * moment / radius) / 2 for sign in (1, -1))
reynolds = 100 * (1 - (1 + slack / stiffness) / (1 + tight / stiffness))
print(f"tension of the tight side: {np.sort(tension)[-8]:.1f} N, by pull and moment {tight:.1f} N")
print(f"creep: {creep:.4f} %, Reynolds {reynolds:.4f} %")
for name, side in zip(("driving", "driven"), contacts, strict=True):
    along, pressed = np.array([contact.force_local for contact in side]).reshape(-1, 2).T
    touching = np.count_nonzero(pressed)
    slides = np.count_nonzero((pressed != 0) & (np.abs(along) > (1 - 1e-9) * friction * np.abs(pressed)))
    print(f"{slides} of {touching} segments slide on the {name} pulley")

plt.plot(solution.times, history)
plt.gca().set(xlabel="time (s)", ylabel="creep (%)")
plt.savefig("belt_creep.png")
shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = shown.loads.show = shown.connectors.show = shown.sensors.show = False
shown.contour.outputVariable = db.OutputVariableType.ForceLocal  # tension, as color
model.draw(file_name="belt_picture.png")
