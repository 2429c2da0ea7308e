"""A servo drive: a motor with its current, a gear, and a table that friction brakes.

The current follows the voltage and the induced voltage of the rotor, by a first-order equation; it drives the rotor,
which a gear connects with the table. The bearing of the table has dry and viscous friction. Voltage, current, speeds
and friction are in balance after the start.
"""

import matplotlib.pyplot as plt

import dalembert as db

resistance, inductance, constant = 0.8, 2e-3, 0.05  # ohm, H, and Vs/rad, which is Nm/A as well
rotor, table, ratio = 2e-5, 4e-3, 12  # kg m^2, kg m^2, turns of the rotor for one of the table
dry, viscous, voltage = 0.3, 0.02, 24  # Nm, Nms/rad, V

model = db.Model()
start = model.add(db.MarkerNodeCoordinate(nodeNumber=model.add(db.NodePointGround()), coordinate=0))


def add_rotor(name, inertia, position, radius, color):
    node = model.add(db.Node1D(name=f"angle of the {name}"))
    disc = db.graphics.Cylinder(pAxis=[0, 0, -0.01], vAxis=[0, 0, 0.02], radius=radius, color=color, nTiles=48)
    spoke = db.graphics.Brick(
        centerPoint=[0.5 * radius, 0, 0.011], size=[radius, 0.006, 0.004], color=db.graphics.color.black
    )
    model.add(
        db.ObjectRotationalMass1D(
            name=name,
            physicsInertia=inertia,
            nodeNumber=node,
            referencePosition=position,
            visualization=db.VObjectRotationalMass1D(graphicsData=[disc, spoke]),
        )
    )
    return node, model.add(db.MarkerNodeCoordinate(nodeNumber=node, coordinate=0))


motor, motor_angle = add_rotor("motor", rotor, [-0.14, 0, 0], 0.03, db.graphics.color.steelblue)
load, load_angle = add_rotor("table", table, [0, 0, 0], 0.1, db.graphics.color.orange)
model.add(db.CoordinateConstraint(name="gear", markerNumbers=[motor_angle, load_angle], factorValue1=ratio))
bearing = model.add(
    db.CoordinateSpringDamperExt(
        name="bearing",
        markerNumbers=[start, load_angle],
        damping=viscous,
        fDynamicFriction=dry,
        frictionProportionalZone=0.01,
    )
)


# the current: L di/dt = U - R i - k omega; the voltage is a load on this equation
def induced(mbs, t, itemNumber, q):
    return [-constant / inductance * mbs.GetNodeOutput(motor, db.OutputVariableType.Coordinates_t)]


current = model.add(
    db.NodeGenericODE1(name="current", referenceCoordinates=[0], initialCoordinates=[0], numberOfODE1Coordinates=1)
)
model.add(
    db.ObjectGenericODE1(nodeNumbers=[current], systemMatrix=[[-resistance / inductance]], rhsUserFunction=induced)
)
winding = model.add(db.MarkerNodeODE1Coordinate(nodeNumber=current, coordinate=0))
model.add(db.LoadCoordinate(name="voltage", markerNumber=winding, load=voltage / inductance))


def motor_torque(mbs, t, load):
    return constant * mbs.GetNodeOutput(current, db.OutputVariableType.Coordinates)


torque = model.add(db.LoadCoordinate(name="torque", markerNumber=motor_angle, loadUserFunction=motor_torque))
drive = model.create_sensor(torque, name="motor torque")
speed = model.create_sensor(load, "coordinates_t", name="speed of the table")
solution = model.solve(end_time=0.6, step_size=2e-4, every=1e-3)

# steady state: k i n = dry + viscous omega, and U = R i + k n omega
balance = (constant * ratio * voltage / resistance - dry) / (viscous + (constant * ratio) ** 2 / resistance)
drawn = (dry + viscous * balance) / (constant * ratio)
print(f"speed of the table: {speed.value:.4f} rad/s, balance {balance:.4f} rad/s")
print(f"torque of the motor: {drive.value:.5f} Nm, balance {constant * drawn:.5f} Nm")
for sensor, name, quantity in ((speed, "speed", "speed of the table (rad/s)"), (drive, "torque", "torque (Nm)")):
    figure, axes = plt.subplots()
    axes.plot(sensor.time, sensor.values)
    axes.set(xlabel="time (s)", ylabel=quantity)
    figure.savefig(f"servo_{name}.png")
shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = shown.connectors.show = shown.loads.show = False
model.draw(file_name="servo_picture.png", view="axonometric")
