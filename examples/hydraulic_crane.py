"""A crane whose boom is lifted by a hydraulic cylinder: valves open and close, and the oil carries the load.

While the valves are open, the speed of the piston is in equilibrium with the flows through both valves, and pressures
carry the load. After closing, the boom oscillates on the oil until the friction of the cylinder has damped it. The
moments about the bearing of the boom balance at rest: pressures times areas times lever equal weights times levers.
"""

import numpy as np

import dalembert as exu
from dalembert.utilities import *

length, load, g = 4.0, 800, 9.81  # m of the boom, kg at its tip, m/s^2
bearing, foot = np.array([0, 2.0, 0]), np.array([0.5, 0.4, 0])  # m, of the boom and of the cylinder, on the column
lug = 1.2  # m from the bearing to where the cylinder pushes
areas = np.pi / 4 * np.array([0.1**2, 0.1**2 - 0.05**2])  # m^2, of a piston of 100 mm with a rod of 50 mm
supply, tank, flow = 160e5, 1e5, 3e-7  # Pa, Pa, m^3/(s sqrt(Pa))
friction = 6e4  # Ns/m


def geometry(angle):
    """Length of the cylinder, and its lever about the bearing, at an angle of the boom."""
    arm = lug * np.array([np.cos(angle), np.sin(angle), 0])
    cylinder = bearing + arm - foot
    distance = np.linalg.norm(cylinder)
    return distance, np.cross(arm, cylinder)[2] / distance


mbs = exu.SystemContainer().AddSystem()
column = graphics.Brick([0.1, 1.0, 0], [0.3, 2.0, 0.5], color=graphics.color.darkgrey2)
foundation = graphics.Brick([0.3, -0.05, 0], [1.6, 0.1, 1.2], color=graphics.color.lightgrey)
bracket = graphics.Brick([0.35, 0.3, 0], [0.5, 0.2, 0.2], color=graphics.color.darkgrey2)
ground = mbs.CreateGround(graphicsDataList=[column, foundation, bracket])
boom = mbs.CreateRigidBody(
    referencePosition=bearing + [length / 2, 0, 0],
    inertia=InertiaCuboid(
        density=1200, sideLengths=[length, 0.2, 0.2]
    ),  # hollow: the mean density of a box of sheet steel
    gravity=[0, -g, 0],
    create2D=True,
    color=graphics.color.orange,
)


def marker(body, place):
    return mbs.AddMarker(MarkerBodyPosition(bodyNumber=body, localPosition=place))


mbs.AddObject(RevoluteJoint2D(markerNumbers=[marker(ground, bearing), marker(boom, [-length / 2, 0, 0])]))
tip = mbs.CreateMassPoint(
    referencePosition=bearing + [length, 0, 0], physicsMass=load, gravity=[0, -g, 0], create2D=True, drawSize=0.5
)
mbs.AddObject(RevoluteJoint2D(markerNumbers=[marker(boom, [length / 2, 0, 0]), marker(tip, [0, 0, 0])]))

weights = g * (mbs.GetObjectParameter(boom, "physicsMass") / 2 + load) * length  # moment of the horizontal boom
initial, lever = geometry(0)
pressures = mbs.AddNode(
    NodeGenericODE1(
        referenceCoordinates=[0, 0],
        initialCoordinates=[(weights / lever + tank * areas[1]) / areas[0], tank],
        numberOfODE1Coordinates=2,
    )
)
cylinder = mbs.AddObject(
    HydraulicActuatorSimple(
        markerNumbers=[marker(ground, foot), marker(boom, [lug - length / 2, 0, 0])],
        nodeNumbers=[pressures],
        offsetLength=1.5,
        strokeLength=0.8,
        chamberCrossSection0=areas[0],
        chamberCrossSection1=areas[1],
        hoseVolume0=5e-4,
        hoseVolume1=5e-4,
        oilBulkModulus=1.5e9,
        actuatorDamping=friction,
        nominalFlow=flow,
        systemPressure=supply,
        tankPressure=tank,
        useChamberVolumeChange=True,
        visualization=VHydraulicActuatorSimple(cylinderRadius=0.06, rodRadius=0.04, pistonRadius=0.055),
    )
)


def operate(mbs, t):
    """The valves open and close within 0.2 s; oil flows from 0.5 s to 3.5 s."""
    opening = np.interp(t, [0.5, 0.7, 3.3, 3.5], [0, 1, 1, 0])
    mbs.SetObjectParameter(cylinder, "valveOpening0", opening)  # valve to the supply
    mbs.SetObjectParameter(cylinder, "valveOpening1", -opening)  # valve to the tank
    return True


mbs.SetPreStepUserFunction(operate)
Variable = exu.OutputVariableType
angle = mbs.AddSensor(SensorBody(bodyNumber=boom, outputVariableType=Variable.Rotation, storeInternal=True))
pressure = mbs.AddSensor(SensorNode(nodeNumber=pressures, outputVariableType=Variable.Coordinates, storeInternal=True))
speed = mbs.AddSensor(
    SensorObject(objectNumber=cylinder, outputVariableType=Variable.VelocityLocal, storeInternal=True)
)
mbs.Assemble()

settings = exu.SimulationSettings()
settings.timeIntegration.endTime = 8
settings.timeIntegration.numberOfSteps = 8000
settings.solutionSettings.sensorsWritePeriod = 5e-3
settings.solutionSettings.solutionWritePeriod = settings.timeIntegration.endTime / 60
mbs.SolveDynamic(settings)

mbs.Draw(fileName="crane_picture.png", view="axonometric")
in_a_second = settings.timeIntegration.endTime / 3
mbs.DrawSolution(
    fileName="crane_motion.gif", windowSize=[420, 320], framesPerSecond=20, speed=in_a_second, view="axonometric"
)
mbs.PlotSensor(
    angle, factors=[180 / np.pi], yLabel="angle of the boom (deg)", fileName="crane_angle.png", closeAll=True
)
mbs.PlotSensor(
    pressure, components=[0, 1], factors=[1e-5] * 2, labels=["piston", "rod side"], yLabel="pressure (bar)",
    fileName="crane_pressures.png",
)  # fmt: skip

# flow sqrt(supply - p0) = areas[0] v, flow sqrt(p1 - tank) = areas[1] v, and the pressures carry load and friction
t, turned = mbs.GetSensorStoredData(angle).T
k = np.searchsorted(t, 3.2)
_, lever = geometry(turned[k])
free = [np.sum(areas**3) / flow**2, friction, weights * np.cos(turned[k]) / lever + tank * areas[1] - supply * areas[0]]
print(
    f"speed of the piston: {mbs.GetSensorStoredData(speed)[k, 1]:.4f} m/s, from the flows {max(np.roots(free)):.4f} m/s"
)

_, lever = geometry(turned[-1])
p0, p1 = mbs.GetSensorStoredData(pressure)[-1, 1:]
held = (p0 * areas[0] - p1 * areas[1]) * lever
print(f"moment of the cylinder at rest: {held:.1f} Nm, of the weights {weights * np.cos(turned[-1]):.1f} Nm")
