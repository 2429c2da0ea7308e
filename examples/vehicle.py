"""A car on four rolling discs: it accelerates with its rear wheels, then its front wheels steer it into a circle.

The discs have contact with friction, like rigid tyres. The thrust accelerates the car and its wheels and increases the
load of the rear axle, in agreement with the balances of momentum and angular momentum, which neglect the small pitch.
The front wheels are steered so that all axles meet in one point, the centre of the circle; at low slip the car follows
it.
"""

import matplotlib.pyplot as plt
import numpy as np

import dalembert as db
from dalembert.utilities import InertiaCuboid, InertiaCylinder

base, track, height, radius = 2.6, 1.5, 0.55, 0.3  # m, height of the body's centre of mass, radius of the wheels
mass, wheel_mass, torque, circle, g = 1200, 20, 300, 40, 9.81  # kg, kg, Nm at each rear wheel, m, m/s^2
speed = 5.0  # m/s, at the beginning
total = mass + 4 * wheel_mass
stiffness = 2e5  # N/m, of a tyre
sinking = total * g / 4 / stiffness  # penetration of a disc

model = db.Model()
road = db.graphics.CheckerBoard([30, 10, 0], size=140, nTiles=70, color=[0.82, 0.82, 0.82, 1])
ground = model.create_ground("road", graphics_data_list=[road])
box = [3.6, 1.6, 1.2]
body = model.create_rigid_body(
    reference_position=[0, 0, height - sinking],
    initial_velocity=[speed, 0, 0],
    inertia=InertiaCuboid(density=mass / np.prod(box), sideLengths=box),
    gravity=[0, 0, -g],
    graphics_data_list=[
        db.graphics.Brick([0, 0, -0.12], [3.9, 1.3, 0.3], color=db.graphics.color.dodgerblue, roundness=0.25),
        db.graphics.Brick([-0.25, 0, 0.22], [2.0, 1.2, 0.5], color=[0.55, 0.75, 0.95, 1], roundness=0.5),
    ],
)
disc = InertiaCylinder(density=wheel_mass / (np.pi * radius**2 * 0.2), length=0.2, outerRadius=radius, axis=1)


def thrust(mbs, t, load):
    """Return the thrust from 0.5 s to 3.5 s, with a short ramp."""
    return np.interp(t, [0.4, 0.6, 3.4, 3.6], [0, 1, 1, 0]) * np.array(load)


def steering(side):
    """Return the angle of a front wheel, as a user function: from 4 s to 5 s it turns to the centre of the circle."""
    angle = np.arctan(base / (circle - side * track / 2))
    return lambda mbs, t, itemNumber, parameters: [0, 0, 0, 0, 0, angle * np.interp(t, [4, 5], [0, 1])]


joints, contacts = [], []
for x, side in ((base / 2, 1), (base / 2, -1), (-base / 2, 1), (-base / 2, -1)):
    hub = [x, side * track / 2, radius - sinking]
    wheel = model.create_rigid_body(
        reference_position=hub,
        initial_velocity=[speed, 0, 0],
        initial_angular_velocity=[0, speed / radius, 0],
        inertia=disc,
        gravity=[0, 0, -g],
        graphics_data_list=[
            db.graphics.Cylinder([0, -0.11, 0], [0, 0.22, 0], 0.6 * radius, color=db.graphics.color.lightgrey)
        ],
    )
    free_about_y = {"position": hub, "constrained_axes": [1, 1, 1, 1, 0, 1]}
    turn = {"offset_user_function": steering(side)} if x > 0 else {}
    joints.append(model.create_generic_joint(body_numbers=[body, wheel], **free_about_y, **turn))
    if x < 0:
        for turned, sign in ((wheel, 1), (body, -1)):
            at = model.add(db.MarkerBodyRigid(bodyNumber=turned))
            drive = [0, sign * torque, 0]
            model.add(db.Torque(markerNumber=at, loadVector=drive, bodyFixed=True, loadVectorUserFunction=thrust))
    contacts.append(
        model.create_rolling_disc_penalty(
            body_numbers=[ground, wheel],
            axis_position=[0, 0, 0],
            axis_vector=[0, 1, 0],
            disc_radius=radius,
            contact_stiffness=stiffness,
            contact_damping=4e3,
            dry_friction=[0.9, 0.9],
            dry_friction_proportional_zone=0.05,
            disc_width=0.2,
            color=db.graphics.color.darkgrey,
        )
    )

middle = [-base / 2, 0, 0]  # between the rear wheels
position = model.create_sensor(body, "position", local_position=middle, name="path")
forces = [model.create_sensor(contact, "force_local") for contact in contacts]

settings = db.SimulationSettings()
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.6
solution = model.solve(end_time=10, step_size=2.5e-3, every=1e-2, settings=settings)

shown = model.container.visualizationSettings
shown.loads.show = shown.markers.show = False
shown.sensors.traces.showPositionTrace = True
model.draw(file_name="vehicle_picture.png", view="axonometric", around=body, zoom=0.35)
# camera follows the car
shown.view0.camera.trackMarker = joints[0].markers[0]
# the whole way fits into the picture with zoom=1
film = {"window_size": [420, 320], "frames_per_second": 20, "view": "axonometric", "zoom": 18}
solution.animate("vehicle_motion.gif", speed=2, **film)

plt.plot(position.values[:, 0], position.values[:, 1])
plt.gca().set(xlabel="x (m)", ylabel="y (m)")
plt.savefig("vehicle_path.png")
load = [force.values for force in forces]
plt.figure()
for name, force in zip(("front left", "front right", "rear left", "rear right"), load, strict=True):
    plt.plot(solution.times, force[:, 2], label=name)
plt.gca().set(xlabel="time (s)", ylabel="load of the wheel (N)", ylim=[2000, 4000])
plt.legend()
plt.savefig("vehicle_loads.png")

t, forward = solution.times, solution[body].velocity_local_at(middle)[:, 0]
spin = disc.inertiaTensor[1, 1] / radius
acceleration = 2 * torque / radius / (total + 4 * spin / radius)
one, two = np.searchsorted(t, [2, 3])
reached = (forward[two] - forward[one]) / (t[two] - t[one])
print(f"acceleration: {reached:.4f} m/s^2, balance of momentum {acceleration:.4f} m/s^2")
transfer = (load[2] + load[3] - load[0] - load[1])[two, 2] / 2
moment = acceleration * (mass * height + 4 * wheel_mass * radius + 4 * spin)
print(f"load moved to the rear axle: {transfer:.1f} N, balance of angular momentum {moment / base:.1f} N")
turning = solution[body].angular_velocity[-1, 2]
print(f"radius of the circle: {forward[-1] / turning:.3f} m, steered {circle:.3f} m")
lateral, inertia = (load[2] + load[3])[-1, 0], total * turning * forward[-1]
print(f"lateral force of the rear wheels: {lateral:.1f} N, half of m v^2 / r {inertia / 2:.1f} N")
