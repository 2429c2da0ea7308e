"""Mistakes that the stubs show before a model runs. Behind each: the code of mypy's error."""

import dalembert as exu
from dalembert.utilities import *

SC = exu.SystemContainer()
mbs = SC.AddSystem()
node = mbs.AddNode(NodePoint())
marker = mbs.AddMarker(MarkerNodePosition(nodeNumber=node))


def force(mbs: exu.MainSystem, t: float, itemNumber: int, u: str) -> float:
    return 0.0


SC.AddSystems()  # attr-defined
exu.SystemContaner()  # attr-defined
exu.NodeType.RotationEulerParameter  # attr-defined
exu.SimulationSettings().timeIntegration.numberOfStep = 1  # attr-defined
exu.SimulationSettings().timeIntegration.verboseMode = "a lot"  # assignment
mbs.AddNode(ObjectMassPoint())  # arg-type
mbs.AddObject(ObjectMassPoint(weight=1))  # call-arg
mbs.AddObject(ObjectMassPoint(nodeNumber=marker))  # arg-type
mbs.AddObject(ObjectConnectorSpringDamper(springForceUserFunction=force))  # arg-type
mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType="Position"))  # arg-type
mbs.GetNodeOutput(marker, exu.OutputVariableType.Position)  # arg-type
mbs.CreateGround(position=[0, 0, 0])  # call-arg
mbs.CreateRevoluteJoint(bodyNumbers=[0.5, "body"])  # list-item
mbs.CreateMassPoint(physicsMass="1")  # call-overload
mbs.SolveDynamic(settings=exu.SimulationSettings())  # call-arg
mbs.systemData.SetODE2Coordinates()  # call-arg
mbs.Assemble(True)  # call-arg
count: int = mbs.CreateForce(bodyNumber=1)  # assignment
