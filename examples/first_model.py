"""A mass on a spring and a damper, released from rest under gravity: the motion decays towards static equilibrium."""

import dalembert as exu
from dalembert.utilities import *

mbs = exu.SystemContainer().AddSystem()
ground = mbs.CreateGround()
mass = mbs.CreateMassPoint(referencePosition=[0, -1, 0], physicsMass=2, gravity=[0, -9.81, 0], drawSize=0.2)
mbs.CreateSpringDamper(bodyNumbers=[ground, mass], referenceLength=1, stiffness=800, damping=8)
height = mbs.AddSensor(
    SensorBody(bodyNumber=mass, outputVariableType=exu.OutputVariableType.Displacement, storeInternal=True)
)
mbs.Assemble()

settings = exu.SimulationSettings()
settings.timeIntegration.endTime = 2
settings.timeIntegration.numberOfSteps = 1000
mbs.SolveDynamic(settings)
mbs.Draw(fileName="first_model_picture.png")
mbs.PlotSensor(height, components=1, fileName="first_model.png", closeAll=True)
print(mbs.GetSensorValues(height))  # y tends to -2 * 9.81 / 800
