"""A model as a user would write it, fully typed: mypy --strict has nothing to say about it."""

import dalembert as exu
import dalembert.graphics as graphics
from dalembert.utilities import *

SC: exu.SystemContainer = exu.SystemContainer()
mbs: exu.MainSystem = SC.AddSystem()


def spring_force(
    mbs: exu.MainSystem, t: float, itemNumber: int, u: float, v: float, k: float, d: float, offset: float
) -> float:
    return k * (u - offset) + d * v + k * u**3


def pre_step(mbs: exu.MainSystem, t: float) -> bool:
    return bool(mbs.systemData.GetODE2Coordinates()[0] < 10)


ground: exu.ObjectIndex = mbs.CreateGround(graphicsDataList=[graphics.Brick(size=[1, 1, 0.1])])
node: exu.NodeIndex = mbs.AddNode(NodePoint(referenceCoordinates=[1, 0, 0], visualization=VNodePoint(drawSize=0.1)))
point: exu.ObjectIndex = mbs.AddObject(ObjectMassPoint(physicsMass=2, nodeNumber=node))
marker: exu.MarkerIndex = mbs.AddMarker(MarkerBodyPosition(bodyNumber=point, localPosition=np.zeros(3)))
load: exu.LoadIndex = mbs.AddLoad(Force(markerNumber=marker, loadVector=[0, 0, -9.81]))
sensor: exu.SensorIndex = mbs.AddSensor(
    SensorBody(bodyNumber=point, storeInternal=True, outputVariableType=exu.OutputVariableType.Position)
)
coordinate = [mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=i)) for i in range(2)]
spring = CoordinateSpringDamper(markerNumbers=coordinate, stiffness=100, springForceUserFunction=spring_force)
mbs.AddObject(spring)

body = mbs.CreateRigidBody(
    referencePosition=[1, 0, 0],
    inertia=InertiaCuboid(density=1000, sideLengths=[1, 0.1, 0.1]),
    nodeType=exu.NodeType.RotationEulerParameters,
    gravity=np.array([0, 0, -9.81]),
)
numbers = mbs.CreateMassPoint(physicsMass=1, returnDict=True)
joint = mbs.CreateRevoluteJoint(bodyNumbers=[ground, body], position=[0, 0, 0], axis=[0, 0, 1])
mbs.CreateSpringDamper(bodyNumbers=[ground, numbers["bodyNumber"]], stiffness=10)
mbs.SetPreStepUserFunction(pre_step)
mbs.variables["joint"] = joint
mbs.Assemble()

settings: exu.SimulationSettings = exu.SimulationSettings()
settings.timeIntegration.numberOfSteps = 100
settings.timeIntegration.endTime = 1
settings.timeIntegration.newton.useModifiedNewton = True
settings.linearSolverType = exu.LinearSolverType.EigenSparse
SC.visualizationSettings.bodies.beams.crossSectionFilled = True
mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.GeneralizedAlpha)

stored: "np.ndarray[tuple[int, ...], np.dtype[np.float64]]" = mbs.GetSensorStoredData(sensor)
position: float = stored[-1, 1] + mbs.systemData.GetTime() + spring.stiffness + pi * sin(0.1)
shown: bool = spring.visualization.show and exu.config.suppressWarnings
parameters: dict[str, object] = dict(spring)
solver = exu.MainSolverImplicitSecondOrder()
if solver.SolveSystem(mbs, settings):
    exu.Print("iterations:", solver.it.newtonStepsCount, solver.GetSystemJacobian().shape)
mbs.PlotSensor([sensor], components=[0], closeAll=True)
