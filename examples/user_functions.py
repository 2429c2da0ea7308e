"""User functions: a stiffening spring, a force in time, a controller before each step, and a sensor that computes."""

import numpy as np

import dalembert as exu
from dalembert.utilities import *

mbs = exu.SystemContainer().AddSystem()
ground = mbs.CreateGround()
mass = mbs.CreateMassPoint(referencePosition=[1, 0, 0], physicsMass=1, drawSize=0.1, color=graphics.color.orange)


def stiffening(mbs, t, itemNumber, elongation, rate, stiffness, damping, force):
    """Force of a Duffing spring."""
    return stiffness * (elongation + 50 * elongation**3) + damping * rate + force


def sweep(mbs, t, load):
    """The load with a frequency that grows in time."""
    return np.sin(2 * np.pi * (0.5 + t / 4) * t) * np.array(load)


def switchDamping(mbs, t):
    """Ten times the damping from 4 s on."""
    mbs.SetObjectParameter(spring, "damping", 0.2 if t < 4 else 2)
    return True


def energy(mbs, t, sensorNumbers, factors, configuration):
    """Kinetic energy, from the velocity sensor."""
    velocity = mbs.GetSensorValues(sensorNumbers[0], configuration)
    return [0.5 * factors[0] * np.dot(velocity, velocity)]


spring = mbs.CreateSpringDamper(
    bodyNumbers=[ground, mass],
    referenceLength=1,
    stiffness=100,
    damping=0.2,
    springForceUserFunction=stiffening,
)
marker = mbs.AddMarker(MarkerBodyPosition(bodyNumber=mass))
mbs.AddLoad(LoadForceVector(markerNumber=marker, loadVector=[2, 0, 0], loadVectorUserFunction=sweep))
mbs.SetPreStepUserFunction(switchDamping)

velocity = mbs.AddSensor(
    SensorBody(bodyNumber=mass, outputVariableType=exu.OutputVariableType.Velocity, storeInternal=True)
)
kinetic = mbs.AddSensor(
    SensorUserFunction(sensorNumbers=[velocity], factors=[1], sensorUserFunction=energy, storeInternal=True)
)

mbs.Assemble()
settings = exu.SimulationSettings()
settings.timeIntegration.endTime = 6
settings.timeIntegration.numberOfSteps = 1200
settings.solutionSettings.writeSolutionToFile = False
mbs.SolveDynamic(settings)

mbs.Draw(fileName="user_functions_picture.png")
mbs.PlotSensor(kinetic, yLabel="kinetic energy (J)", closeAll=True, fileName="user_functions.png")
print(f"largest kinetic energy: {mbs.GetSensorStoredData(kinetic)[:, 1].max():.3f} J")
