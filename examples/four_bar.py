"""A planar four-bar linkage, its crank driven at constant speed: a crank-rocker of steel bars.

The diagonal from the crank pin to the bearing of the rocker divides the linkage into two triangles, which give the
position of the rocker in closed form. The motor does no work over a whole revolution: the energy for lifting and
accelerating the bars is returned.
"""

import numpy as np

import dalembert as db
from dalembert.utilities import InertiaCuboid, RotationMatrixZ

crank, coupler, rocker, base = 0.1, 0.35, 0.25, 0.4  # m, between the pins
speed = 2 * np.pi  # rad/s


def swing(angle):
    """Angle of the rocker in closed form, for the pin between coupler and rocker above the base."""
    across = crank * np.array([np.cos(angle), np.sin(angle)]) - [base, 0]
    diagonal = np.hypot(*across)
    corner = np.arccos((rocker**2 + diagonal**2 - coupler**2) / (2 * rocker * diagonal))
    return np.arctan2(across[1], across[0]) % (2 * np.pi) - corner


model = db.Model()
ground = model.ground


def bar(start, end, layer, color):
    """Add a steel bar of 20 x 10 mm between two pins; they are drawn in layers, one in front of the other."""
    vector = np.subtract(end, start)
    half, z = np.hypot(*vector) / 2, 0.012 * layer
    link = db.graphics.RigidLink(
        [-half, 0, z], [half, 0, z], axis0=[0, 0, 1], axis1=[0, 0, 1], radius=[0.012, 0.012], thickness=0.01,
        width=[0.016, 0.016], color=color, nTiles=32,
    )  # fmt: skip
    return model.create_rigid_body(
        reference_position=[*np.add(start, end) / 2, 0],
        reference_rotation_matrix=RotationMatrixZ(np.arctan2(vector[1], vector[0])),
        inertia=InertiaCuboid(density=7800, sideLengths=[np.hypot(*vector), 0.02, 0.01]),
        gravity=[0, -9.81, 0],
        create_2d=True,
        graphics_data_list=[link],
    )


def pin(body0, place0, body1, place1):
    """Add a revolute joint of two bodies, at places on their axes."""
    ends = [(body0, place0), (body1, place1)]
    markers = [model.add(db.MarkerBodyPosition(bodyNumber=b, localPosition=[x, 0, 0])) for b, x in ends]
    return model.add(db.RevoluteJoint2D(markerNumbers=markers))


bearing, crank_pin, foot = [0, 0], [crank, 0], [base, 0]
rocker_pin = [base + rocker * np.cos(swing(0)), rocker * np.sin(swing(0))]
bars = [
    bar(bearing, crank_pin, 0, db.graphics.color.orange),
    bar(crank_pin, rocker_pin, 1, db.graphics.color.dodgerblue),
    bar(foot, rocker_pin, 0, db.graphics.color.springgreen),
]
pin(ground, 0, bars[0], -crank / 2)
pin(bars[0], crank / 2, bars[1], -coupler / 2)
pin(bars[1], coupler / 2, bars[2], rocker / 2)
pin(ground, base, bars[2], -rocker / 2)


# the motor turns the third coordinate of the crank, from rest to full speed in the first second
def turned(mbs, t, itemNumber, offset):
    return speed * (t**3 - t**4 / 2 if t < 1 else t - 0.5)


def turning(mbs, t, itemNumber, offset):
    return speed * (3 * t**2 - 2 * t**3 if t < 1 else 1)


motor = model.create_coordinate_constraint(
    name="motor",
    body_numbers=[ground, bars[0]],
    coordinates=[None, 2],
    offset_user_function=turned,
    offset_user_function_t=turning,
)

settings = db.SimulationSettings()
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.8
solution = model.solve(end_time=3.5, step_size=1e-3, settings=settings)

model.draw(file_name="four_bar_picture.png", view="axonometric")
solution.animate(file_name="four_bar_motion.gif", window_size=[480, 360], frames_per_second=20)

solution.plot((bars[2], "rotation"), file_name="four_bar_rocker.png")
axes = solution.plot("motor.force")
axes.set_ylabel("torque of the motor (Nm)")
axes.figure.savefig("four_bar_torque.png")

t, rocking = solution.times, solution[bars[2]].rotation
steady = t >= 1.5  # two revolutions at full speed
angles = np.linspace(0, 2 * np.pi, 3601)
exact = np.array([swing(a) for a in angles]) - swing(0)
print(f"swing of the rocker: {np.ptp(rocking[steady]):.6f} rad, closed form {np.ptp(exact):.6f} rad")
power = solution[motor].force[steady] * speed
given, taken = (np.trapezoid(np.maximum(side * power, 0), t[steady]) for side in (1, -1))
print(f"work of the motor: {given:.3f} J, given back {taken:.3f} J")
