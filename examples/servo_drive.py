"""A servo drive: a motor with its current, a gear, and a table that friction brakes.

The current follows the voltage and the induced voltage of the rotor, by a first-order equation; it drives the rotor,
which
a gear connects with the table. The bearing of the table has dry and viscous friction. Voltage, current, speeds and
friction are in balance after the start.
"""

import dalembert as exu
from dalembert.utilities import *

resistance, inductance, constant = 0.8, 2e-3, 0.05  # ohm, H, and Vs/rad, which is Nm/A as well
rotor, table, ratio = 2e-5, 4e-3, 12  # kg m^2, kg m^2, turns of the rotor for one of the table
dry, viscous, voltage = 0.3, 0.02, 24  # Nm, Nms/rad, V

mbs = exu.SystemContainer().AddSystem()
start = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))


def add_rotor(name, inertia, position, radius, color):
    node = mbs.AddNode(Node1D(name=f"angle of the {name}"))
    disc = graphics.Cylinder(pAxis=[0, 0, -0.01], vAxis=[0, 0, 0.02], radius=radius, color=color, nTiles=48)
    spoke = graphics.Brick(
        centerPoint=[0.5 * radius, 0, 0.011], size=[radius, 0.006, 0.004], color=graphics.color.black
    )
    mbs.AddObject(
        ObjectRotationalMass1D(
            name=name,
            physicsInertia=inertia,
            nodeNumber=node,
            referencePosition=position,
            visualization=VObjectRotationalMass1D(graphicsData=[disc, spoke]),
        )
    )
    return node, mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0))


motor, motorMarker = add_rotor("motor", rotor, [-0.14, 0, 0], 0.03, graphics.color.steelblue)
load, loadMarker = add_rotor("table", table, [0, 0, 0], 0.1, graphics.color.orange)
mbs.AddObject(CoordinateConstraint(name="gear", markerNumbers=[motorMarker, loadMarker], factorValue1=ratio))
bearing = mbs.AddObject(
    CoordinateSpringDamperExt(
        name="bearing",
        markerNumbers=[start, loadMarker],
        damping=viscous,
        fDynamicFriction=dry,
        frictionProportionalZone=0.01,
    )
)


# the current: L di/dt = U - R i - k omega; the voltage is a load on this equation
def induced(mbs, t, itemNumber, q):
    return [-constant / inductance * mbs.GetNodeOutput(motor, exu.OutputVariableType.Coordinates_t)]


current = mbs.AddNode(
    NodeGenericODE1(name="current", referenceCoordinates=[0], initialCoordinates=[0], numberOfODE1Coordinates=1)
)
mbs.AddObject(
    ObjectGenericODE1(nodeNumbers=[current], systemMatrix=[[-resistance / inductance]], rhsUserFunction=induced)
)
winding = mbs.AddMarker(MarkerNodeODE1Coordinate(nodeNumber=current, coordinate=0))
mbs.AddLoad(LoadCoordinate(name="voltage", markerNumber=winding, load=voltage / inductance))


def motor_torque(mbs, t, load):
    return constant * mbs.GetNodeOutput(current, exu.OutputVariableType.Coordinates)


torque = mbs.AddLoad(LoadCoordinate(name="torque", markerNumber=motorMarker, loadUserFunction=motor_torque))
torqueSensor = mbs.AddSensor(SensorLoad(name="motor torque", loadNumber=torque, storeInternal=True))
speed = mbs.AddSensor(
    SensorNode(
        name="table",
        nodeNumber=load,
        outputVariableType=exu.OutputVariableType.Coordinates_t,
        storeInternal=True,
    )
)
mbs.Assemble()

settings = exu.SimulationSettings()
settings.timeIntegration.endTime = 0.6
settings.timeIntegration.numberOfSteps = 3000
settings.solutionSettings.sensorsWritePeriod = 1e-3
settings.solutionSettings.writeSolutionToFile = False
mbs.SolveDynamic(settings)

# steady state: k i n = dry + viscous omega, and U = R i + k n omega
balance = (constant * ratio * voltage / resistance - dry) / (viscous + (constant * ratio) ** 2 / resistance)
drawn = (dry + viscous * balance) / (constant * ratio)
print(f"speed of the table: {mbs.GetSensorValues(speed):.4f} rad/s, balance {balance:.4f} rad/s")
print(f"torque of the motor: {mbs.GetSensorValues(torqueSensor):.5f} Nm, balance {constant * drawn:.5f} Nm")
mbs.PlotSensor(speed, components=0, yLabel="speed of the table (rad/s)", fileName="servo_speed.png", closeAll=True)
mbs.PlotSensor(
    torqueSensor, components=0, yLabel="torque of the motor (Nm)", fileName="servo_torque.png", closeAll=True
)
shown = mbs.GetSystemContainer().visualizationSettings
shown.nodes.show = shown.markers.show = shown.connectors.show = shown.loads.show = False
mbs.Draw(fileName="servo_picture.png", view="axonometric")
