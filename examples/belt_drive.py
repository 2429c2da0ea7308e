"""A belt drive: the driven pulley turns a little slower than the driving one, because of the strain of the belt.

The belt consists of axially moving cables: the material runs through fixed elements. The belt sticks to a pulley
where it
enters, and slides only on the last part of the arc, where its tension changes from that of one side to that of the
other.
The ratio of the speeds is (1 + T2/EA) / (1 + T1/EA) (O. Reynolds), independently of friction.
"""

import numpy as np

import dalembert as exu
from dalembert.beams import CreateReevingCurve, PointsAndSlopes2ANCFCable2D
from dalembert.utilities import *

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

mbs = exu.SystemContainer().AddSystem()
fixed = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
runs = mbs.AddNode(NodeGenericODE2(numberOfODE2Coordinates=1, referenceCoordinates=[0], initialCoordinates=[0],
                                   initialCoordinates_t=[way / stretch]))  # fmt: skip
belt = ALECable2D(
    nodeNumbers=[-1, -1, runs],
    physicsMassPerLength=mass,
    physicsBendingStiffness=1e-3,
    physicsAxialStiffness=stiffness,
    physicsAxialDamping=5,
    strainIsRelativeToReference=False,
    physicsAddALEvariation=False,
    visualization=VCable2D(drawHeight=0.006),
)
# one node is fixed along the belt, so that elements stay while the material moves
_, cables, *_ = PointsAndSlopes2ANCFCable2D(
    mbs, np.array(curve["ancfPointsSlopes"]) * [1, 1, stretch, stretch], [length] * elements, belt,
    massProportionalLoad=[0, 0, 0], fixedConstraintsNode0=[1, 0, 0, 0], firstNodeIsLastNode=True,
)  # fmt: skip
part = length / segments
pulleys, contacts = [], []
for x in (0, distance):
    disc = exu.graphics.Cylinder([0, 0, -0.02], [0, 0, 0.015], 0.98 * radius, exu.graphics.color.steelblue, nTiles=64)
    spoke = exu.graphics.Brick([0, 0, -0.004], [1.8 * radius, 0.01, 0.001], exu.graphics.color.orange)
    node = mbs.AddNode(NodeRigidBody2D(referenceCoordinates=[x, 0, 0], initialVelocities=[0, 0, -speed]))
    body = mbs.AddObject(
        RigidBody2D(physicsMass=1, physicsInertia=0.005, nodeNumber=node,
                    visualization=VRigidBody2D(graphicsData=[disc, spoke]))
    )  # fmt: skip
    pulleys.append(node)
    rim = mbs.AddMarker(MarkerBodyRigid(bodyNumber=body))
    contacts.append([])
    for cable in cables:
        shape = mbs.AddMarker(MarkerBodyCable2DShape(bodyNumber=cable, numberOfSegments=segments))
        states = mbs.AddNode(
            NodeGenericData(numberOfDataCoordinates=3 * segments,
                            initialCoordinates=[0.1] * segments + [-2] * segments + [0] * segments)
        )  # fmt: skip
        contacts[-1].append(
            mbs.AddObject(
                ObjectContactFrictionCircleCable2D(
                    markerNumbers=[rim, shape], nodeNumber=states, numberOfContactSegments=segments,
                    circleRadius=radius, contactStiffness=1e8 * part, contactDamping=1e4 * part,
                    frictionVelocityPenalty=1e5 * part, frictionCoefficient=friction,
                    visualization=VObjectContactFrictionCircleCable2D(show=False),
                )
            )
        )  # fmt: skip
coordinate = [[mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=n, coordinate=k)) for k in range(3)] for n in pulleys]
for held in (coordinate[0][0], coordinate[0][1], coordinate[1][1]):
    mbs.AddObject(CoordinateConstraint(markerNumbers=[fixed, held]))
# the first pulley drives; the second one brakes, and tensions the belt: the pull minus the bending force of the belt
mbs.AddObject(CoordinateConstraint(markerNumbers=[fixed, coordinate[0][2]], velocityLevel=True, offset=-speed))
mbs.AddLoad(LoadCoordinate(markerNumber=coordinate[1][0], load=pull - 2 * mass * way**2))
mbs.AddObject(CoordinateSpringDamper(markerNumbers=[fixed, coordinate[1][0]], damping=2000))
brake = lambda mbs, t, load: load * min(1.0, t / run_up)  # noqa: E731
mbs.AddLoad(LoadCoordinate(markerNumber=coordinate[1][2], load=moment, loadUserFunction=brake))
turning = mbs.AddSensor(
    SensorNode(nodeNumber=pulleys[1], outputVariableType=exu.OutputVariableType.AngularVelocity, storeInternal=True)
)
mbs.Assemble()

settings = exu.SimulationSettings()
settings.solutionSettings.writeSolutionToFile = False
settings.solutionSettings.sensorsWritePeriod = 1e-3
settings.timeIntegration.endTime = end
settings.timeIntegration.numberOfSteps = steps
settings.timeIntegration.verboseMode = 0
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.5
settings.timeIntegration.discontinuous.iterationTolerance = 1e-3
settings.timeIntegration.discontinuous.maxIterations = 10
mbs.SolveDynamic(settings)
told = mbs.GetSensorStoredData(turning)
history = np.column_stack([told[:, 0], 100 * (1 + told[:, 3] / speed)])
creep = np.mean(history[history[:, 0] > 0.75 * end, 1])  # minus the effect of segments that begin and end contact
force = exu.OutputVariableType.ForceLocal
tension = np.array([mbs.GetObjectOutputBody(cable, force, [length / 2, 0, 0]) for cable in cables])
tight, slack = ((pull + sign * moment / radius) / 2 for sign in (1, -1))
reynolds = 100 * (1 - (1 + slack / stiffness) / (1 + tight / stiffness))
print(f"tension of the tight side: {np.sort(tension)[-8]:.1f} N, by pull and moment {tight:.1f} N")
print(f"creep: {creep:.4f} %, Reynolds {reynolds:.4f} %")
for name, side in zip(("driving", "driven"), contacts, strict=True):
    along, pressed = np.array([mbs.GetObjectOutput(contact, force) for contact in side]).reshape(-1, 2).T
    touching = np.count_nonzero(pressed)
    slides = np.count_nonzero((pressed != 0) & (np.abs(along) > (1 - 1e-9) * friction * np.abs(pressed)))
    print(f"{slides} of {touching} segments slide on the {name} pulley")

mbs.PlotSensor([history], components=[0], yLabel="creep (%)", fileName="belt_creep.png", closeAll=True)
SC = mbs.GetSystemContainer()
shown = SC.visualizationSettings
shown.nodes.show = shown.markers.show = shown.loads.show = shown.connectors.show = shown.sensors.show = False
shown.contour.outputVariable = force  # tension, as color
mbs.Draw(fileName="belt_picture.png")
