"""A mass that stretches a plastic spring: its force over its length, as a plot."""

import matplotlib.pyplot as plt
from plastic_spring import PlasticSpring

import dalembert as exu
from dalembert.itemInterface import *

mass, speed, stiffness, yieldForce = 2.0, 3.0, 1000.0, 20.0
mbs = exu.SystemContainer().AddSystem()
ground = mbs.CreateGround()
slider = mbs.CreateMassPoint(referencePosition=[1, 0, 0], physicsMass=mass, initialVelocity=[speed, 0, 0])
markers = [mbs.AddMarker(MarkerBodyPosition(bodyNumber=body)) for body in (ground, slider)]
data = mbs.AddNode(NodeGenericData(initialCoordinates=[0], numberOfDataCoordinates=1))
spring = mbs.AddObject(
    PlasticSpring(markerNumbers=markers, nodeNumber=data, referenceLength=1, stiffness=stiffness, yieldForce=yieldForce)
)
length, force = (
    mbs.AddSensor(SensorObject(objectNumber=spring, storeInternal=True, writeToFile=False, outputVariableType=variable))
    for variable in (exu.OutputVariableType.Distance, exu.OutputVariableType.Force)
)
mbs.Assemble()
settings = exu.SimulationSettings()
settings.timeIntegration.endTime = 0.6
settings.timeIntegration.numberOfSteps = 6000
settings.solutionSettings.writeSolutionToFile = False
settings.solutionSettings.sensorsWritePeriod = 1e-3
mbs.SolveDynamic(settings)

# The yield force takes up the kinetic energy, except for the part that is stored elastically.
elastic = yieldForce**2 / (2 * stiffness)
expected = (0.5 * mass * speed**2 - elastic) / yieldForce
plastic = float(mbs.GetNodeOutput(data, exu.OutputVariableType.Coordinates))
print(f"plastic elongation {plastic:.6f} m, by the balance of energy {expected:.6f} m")

plt.plot(mbs.GetSensorStoredData(length)[:, 1], mbs.GetSensorStoredData(force)[:, 1])
plt.xlabel("length (m)")
plt.ylabel("force (N)")
plt.savefig("plastic_spring.png")
