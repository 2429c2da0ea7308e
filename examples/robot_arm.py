"""A robot arm with three joints that follow prescribed motions: it lifts a load and turns it to its other side.

Column, upper arm and forearm are connected by motors, which are joints with prescribed angles. Forward kinematics gives
the position of the hand. The arm starts and ends at rest, so the work of its motors is the change of potential energy.
"""

import matplotlib.pyplot as plt
import numpy as np

import dalembert as db
from dalembert.utilities import InertiaCuboid, InertiaCylinder, InertiaSphere, RotationMatrixX, RotationMatrixY

column, upper, fore, width = 0.5, 0.6, 0.5, 0.08  # m
payload, g, duration = 5.0, 9.81, 2.0  # kg, m/s^2, s
# about z, and up from the horizontal and the upper arm
start, end = np.radians([0, -20, -60]), np.radians([120, 60, -40])


def smooth(t):
    """Return a step from 0 to 1 with zero rates and accelerations at both ends; and its rate."""
    s = min(t / duration, 1)
    return s**3 * (10 - 15 * s + 6 * s**2), 30 * s**2 * (1 - s) ** 2 / duration


def places(angles):
    """Return the places of elbow and hand."""
    yaw, shoulder, elbow = angles
    radial = np.array([np.cos(yaw), np.sin(yaw), 0])

    def along(length, pitch):
        return length * (np.cos(pitch) * radial + np.sin(pitch) * np.array([0, 0, 1]))

    knee = np.array([0, 0, column]) + along(upper, shoulder)
    return knee, knee + along(fore, shoulder + elbow)


def motor(k):
    """Return the angle of joint k against its start, about the third axis of the joint, as a user function."""
    return lambda mbs, t, itemNumber, parameters: [0, 0, 0, 0, 0, smooth(t)[0] * (end[k] - start[k])]


model = db.Model()
ground = model.create_ground("floor", graphics_data_list=[db.graphics.CheckerBoard(size=1.6, nTiles=8)])
elbow, hand = places(start)
shoulder = np.array([0, 0, column])
pitch = RotationMatrixY(-start[1]), RotationMatrixY(-start[1] - start[2])
bar = {"density": 1500}
tube = [InertiaCuboid(**bar, sideLengths=[length, width, width]) for length in (upper, fore)]
load = InertiaSphere(payload, 0.05).Translated([fore / 2, 0, 0])
links = [
    (shoulder / 2, np.eye(3), InertiaCylinder(**bar, length=column, outerRadius=width, axis=2)),
    ((shoulder + elbow) / 2, pitch[0], tube[0]),
    ((elbow + hand) / 2, pitch[1], tube[1] + load),
]
shapes = [
    [db.graphics.Cylinder([0, 0, -column / 2], [0, 0, column], width, color=db.graphics.color.lightgrey, nTiles=48)],
    [db.graphics.RigidLink([-upper / 2, 0, 0], [upper / 2, 0, 0], [0, 1, 0], [0, 1, 0], [width] * 2, width,
                        [2 * width] * 2, color=db.graphics.color.orange, nTiles=48)],
    [db.graphics.RigidLink([-fore / 2, 0, 0], [fore / 2, 0, 0], [0, 1, 0], [0, 0, 0], [0.06, 0], 0.07, [0.14, 0.0],
                        color=db.graphics.color.orange, nTiles=48),
     db.graphics.Sphere([fore / 2, 0, 0], radius=0.07, color=db.graphics.color.darkgrey2, nTiles=32)],
]  # fmt: skip
bodies = [ground] + [
    model.create_rigid_body(
        reference_position=p, reference_rotation_matrix=A, inertia=inertia, gravity=[0, 0, -g], graphics_data_list=shape
    )
    for (p, A, inertia), shape in zip(links, shapes, strict=True)
]
upwards = RotationMatrixX(np.pi / 2)  # its third axis is -y: arms turn upwards
joints = [
    model.create_generic_joint(
        body_numbers=bodies[k : k + 2], position=place, rotation_matrix_axes=axes, offset_user_function=motor(k)
    )
    for k, (place, axes) in enumerate([([0, 0, 0], np.eye(3)), (shoulder, upwards), (elbow, upwards)])
]

settings = db.SimulationSettings()
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.8
solution = model.solve(end_time=duration, step_size=duration / 2000, settings=settings)
model.draw(file_name="robot_picture.png")
solution.animate(file_name="robot_motion.gif", window_size=[420, 320], frames_per_second=20, speed=duration / 3)

torques = [solution[joint].torque_local[:, 2] for joint in joints]
for name, torque in zip(("column", "shoulder", "elbow"), torques, strict=True):
    plt.plot(solution.times, torque, label=name)
plt.gca().set(xlabel="time (s)", ylabel="torque of the motor (Nm)")
plt.legend()
plt.savefig("robot_torques.png")
solution.plot((bodies[3], "position", [fore / 2, 0, 0]), file_name="robot_hand.png")

halfway = len(solution) // 2
time, reached = solution.times[halfway], solution[bodies[3]].position_at([fore / 2, 0, 0])[halfway]
_, wanted = places(start + smooth(time)[0] * (end - start))
for name, is_at, should in zip("xyz", reached, wanted, strict=True):
    print(f"hand halfway, {name}: {is_at:.6f} m, forward kinematics {should:.6f} m")

rates = np.array([smooth(time)[1] for time in solution.times])
# the third multiplier of a locked joint is the torque about -z
work = sum(np.trapezoid(torques[k] * rates, solution.times) * (end[k] - start[k]) for k in range(3))


def potential(angles):
    knee, hand = places(angles)
    return g * (tube[0].mass * (column + knee[2]) / 2 + tube[1].mass * (knee[2] + hand[2]) / 2 + payload * hand[2])


print(f"work of the motors: {work:.4f} J, gain of height {potential(end) - potential(start):.4f} J")
