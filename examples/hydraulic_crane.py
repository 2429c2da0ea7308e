"""A crane whose boom is lifted by a hydraulic cylinder: valves open and close, and the oil carries the load.

While the valves are open, the speed of the piston is in equilibrium with the flows through both valves, and pressures
carry the load. After closing, the boom oscillates on the oil until the friction of the cylinder has damped it. The
moments about the bearing of the boom balance at rest: pressures times areas times lever equal weights times levers.
"""

import matplotlib.pyplot as plt
import numpy as np

import dalembert as db
from dalembert.utilities import InertiaCuboid

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


model = db.Model()
column = db.graphics.Brick([0.1, 1.0, 0], [0.3, 2.0, 0.5], color=db.graphics.color.darkgrey2)
foundation = db.graphics.Brick([0.3, -0.05, 0], [1.6, 0.1, 1.2], color=db.graphics.color.lightgrey)
bracket = db.graphics.Brick([0.35, 0.3, 0], [0.5, 0.2, 0.2], color=db.graphics.color.darkgrey2)
ground = model.create_ground("column", graphics_data_list=[column, foundation, bracket])
boom = model.create_rigid_body(
    reference_position=bearing + [length / 2, 0, 0],
    inertia=InertiaCuboid(density=1200, sideLengths=[length, 0.2, 0.2]),  # hollow: the mean density of a box of steel
    gravity=[0, -g, 0],
    create_2d=True,
    color=db.graphics.color.orange,
)


def marker(body, place):
    return model.add(db.MarkerBodyPosition(bodyNumber=body, localPosition=place))


model.add(db.RevoluteJoint2D(markerNumbers=[marker(ground, bearing), marker(boom, [-length / 2, 0, 0])]))
tip = model.create_mass_point(
    reference_position=bearing + [length, 0, 0], physics_mass=load, gravity=[0, -g, 0], create_2d=True, draw_size=0.5
)
model.add(db.RevoluteJoint2D(markerNumbers=[marker(boom, [length / 2, 0, 0]), marker(tip, [0, 0, 0])]))

weights = g * (boom.mass / 2 + load) * length  # moment of the horizontal boom
initial, lever = geometry(0)
pressures = model.add(
    db.NodeGenericODE1(
        referenceCoordinates=[0, 0],
        initialCoordinates=[(weights / lever + tank * areas[1]) / areas[0], tank],
        numberOfODE1Coordinates=2,
    )
)
cylinder = model.add(
    db.HydraulicActuatorSimple(
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
        visualization=db.VHydraulicActuatorSimple(cylinderRadius=0.06, rodRadius=0.04, pistonRadius=0.055),
    )
)


def operate(mbs, t):
    """Open and close the valves within 0.2 s; oil flows from 0.5 s to 3.5 s."""
    opening = np.interp(t, [0.5, 0.7, 3.3, 3.5], [0, 1, 1, 0])
    mbs.SetObjectParameter(cylinder, "valveOpening0", opening)  # valve to the supply
    mbs.SetObjectParameter(cylinder, "valveOpening1", -opening)  # valve to the tank
    return True


model.system.SetPreStepUserFunction(operate)
speed = model.create_sensor(cylinder, "velocity_local")
solution = model.solve(end_time=8, step_size=1e-3, every=5e-3)

model.draw(file_name="crane_picture.png", view="axonometric")
solution.animate(
    file_name="crane_motion.gif", window_size=[420, 320], frames_per_second=20, speed=8 / 3, view="axonometric"
)
solution.plot((boom, "rotation"), file_name="crane_angle.png")
plt.figure()
plt.plot(solution.times, 1e-5 * solution[pressures].coordinates, label=["piston", "rod side"])
plt.gca().set(xlabel="time (s)", ylabel="pressure (bar)")
plt.legend()
plt.savefig("crane_pressures.png")

# flow sqrt(supply - p0) = areas[0] v, flow sqrt(p1 - tank) = areas[1] v, and the pressures carry load and friction
turned = solution[boom].rotation
k = np.searchsorted(solution.times, 3.2)
_, lever = geometry(turned[k])
free = [np.sum(areas**3) / flow**2, friction, weights * np.cos(turned[k]) / lever + tank * areas[1] - supply * areas[0]]
print(f"speed of the piston: {speed.values[k]:.4f} m/s, from the flows {max(np.roots(free)):.4f} m/s")

_, lever = geometry(turned[-1])
p0, p1 = pressures.coordinates
held = (p0 * areas[0] - p1 * areas[1]) * lever
print(f"moment of the cylinder at rest: {held:.1f} Nm, of the weights {weights * np.cos(turned[-1]):.1f} Nm")
