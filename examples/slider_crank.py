"""A slider-crank in space: three rigid bodies, driven by a torque on the crank, with a spring against the slider.

The place of the slider follows from the angle of the crank in closed form.
"""

import numpy as np

import dalembert as exu
from dalembert.utilities import *

crankLength, rodLength, width = 0.1, 0.3, 0.02  # m
gravity = [0, -9.81, 0]


def bar(length):
    """A steel bar along x with square section."""
    return InertiaCuboid(density=7800, sideLengths=[length, width, width])


mbs = exu.SystemContainer().AddSystem()
ground = mbs.CreateGround()

# bodies: the mechanism is stretched in the reference configuration, the crank along x
crank = mbs.CreateRigidBody(
    referencePosition=[crankLength / 2, 0, 0],
    inertia=bar(crankLength),
    gravity=gravity,
    color=graphics.color.orange,
)
rod = mbs.CreateRigidBody(
    referencePosition=[crankLength + rodLength / 2, 0, 0],
    inertia=bar(rodLength),
    gravity=gravity,
    color=graphics.color.dodgerblue,
)
slider = mbs.CreateRigidBody(
    referencePosition=[crankLength + rodLength, 0, 0],
    inertia=bar(0.05),
    gravity=gravity,
    color=graphics.color.lightgrey,
)

# joints: 5 + 5 + 2 + 5 equations for 18 degrees of freedom
mbs.CreateRevoluteJoint(bodyNumbers=[ground, crank], position=[0, 0, 0], axis=[0, 0, 1])
mbs.CreateRevoluteJoint(bodyNumbers=[crank, rod], position=[crankLength, 0, 0], axis=[0, 0, 1])
pin = mbs.CreateGenericJoint(
    bodyNumbers=[rod, slider], position=[crankLength + rodLength, 0, 0], constrainedAxes=[1, 1, 0, 0, 0, 0]
)
mbs.CreateGenericJoint(
    bodyNumbers=[ground, slider], position=[crankLength + rodLength, 0, 0], constrainedAxes=[0, 1, 1, 1, 1, 1]
)

# drive and resistance
mbs.CreateTorque(bodyNumber=crank, loadVector=[0, 0, 0.5])
mbs.CreateSpringDamper(
    bodyNumbers=[ground, slider],
    localPosition0=[0.6, 0, 0],
    localPosition1=[0, 0, 0],
    referenceLength=0.3,
    stiffness=100,
    damping=2,
)

# sensors
position = mbs.AddSensor(
    SensorBody(bodyNumber=slider, outputVariableType=exu.OutputVariableType.Position, storeInternal=True)
)
angle = mbs.AddSensor(
    SensorBody(bodyNumber=crank, outputVariableType=exu.OutputVariableType.Rotation, storeInternal=True)
)
spin = mbs.AddSensor(
    SensorBody(bodyNumber=crank, outputVariableType=exu.OutputVariableType.AngularVelocity, storeInternal=True)
)
force = mbs.AddSensor(
    SensorObject(objectNumber=pin, outputVariableType=exu.OutputVariableType.ForceLocal, storeInternal=True)
)

mbs.Assemble()
settings = exu.SimulationSettings()
settings.timeIntegration.endTime = 2
settings.timeIntegration.numberOfSteps = 2000
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.8
settings.solutionSettings.sensorsWritePeriod = 5e-3
settings.solutionSettings.solutionWritePeriod = settings.timeIntegration.endTime / 60
mbs.SolveDynamic(settings)

mbs.Draw(fileName="slider_crank_picture.png", view="axonometric")
in_a_second = settings.timeIntegration.endTime / 3
mbs.DrawSolution(
    fileName="slider_crank_motion.gif", windowSize=[420, 320], framesPerSecond=20, speed=in_a_second, view="axonometric"
)
mbs.PlotSensor(position, components=0, yLabel="slider position (m)", fileName="slider_position.png", closeAll=True)
mbs.PlotSensor(spin, components=2, yLabel="crank speed (rad/s)", fileName="crank_speed.png")
mbs.PlotSensor(force, components=[0, 1], yLabel="pin force (N)", fileName="pin_force.png")

# the position of the slider follows from the angle of the crank
reached = mbs.GetSensorStoredData(position)[:, 1]
turned = mbs.GetSensorStoredData(angle)[:, 3]
exact = crankLength * np.cos(turned) + np.sqrt(rodLength**2 - (crankLength * np.sin(turned)) ** 2)
print(f"range of the slider: {np.ptp(reached):.6f} m, closed form {np.ptp(exact):.6f} m")
print(f"slider at the end: {reached[-1]:.6f} m, closed form {exact[-1]:.6f} m")
