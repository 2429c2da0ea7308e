"""A coin rolls on a circle, leaning inwards: its speed follows from the balance of moments.

A thin disc of radius R leans by the angle a from the vertical while its contact point moves on a circle of radius c at
the rate w. The weight and the rate of angular momentum balance if

m g R sin a = w^2 cos a (m d R + I3 (c / R - sin a) + I1 sin a)

with the distance d = c - R sin a of its center from the middle, and I3 about its own axis.
"""

import matplotlib.pyplot as plt
import numpy as np

import dalembert as db
from dalembert.utilities import InertiaCylinder

radius, thickness, density, g = 0.1, 0.005, 8000.0, 9.81  # m, m, kg/m^3, m/s^2
lean, circle = 0.4, 0.5  # rad, m

coin = InertiaCylinder(density, thickness, radius, axis=0)
I1, I3 = coin.Inertia()[1, 1], coin.Inertia()[0, 0]
distance = circle - radius * np.sin(lean)
resistance = coin.mass * distance * radius + I3 * (circle / radius - np.sin(lean)) + I1 * np.sin(lean)
rate = np.sqrt(coin.mass * g * radius * np.tan(lean) / resistance)
end = 2 * np.pi / rate

axis, forward = np.array([np.cos(lean), 0, np.sin(lean)]), np.array([0, 1, 0])
upward = np.cross(axis, forward)
model = db.Model()
model.create_ground(
    "table", graphics_data_list=[db.graphics.CheckerBoard(size=1.6, nTiles=8, color=db.graphics.color.lightgrey)]
)
model.create_rigid_body(
    "coin",
    reference_position=[distance, 0, radius * np.cos(lean)],
    reference_rotation_matrix=np.column_stack([axis, forward, upward]),
    initial_velocity=rate * distance * forward,
    initial_angular_velocity=-rate * (circle / radius - np.sin(lean)) * axis + rate * np.cos(lean) * upward,
    inertia=coin,
    gravity=[0, 0, -g],
    graphics_data_list=[
        db.graphics.Cylinder([-0.5 * thickness, 0, 0], [thickness, 0, 0], radius, db.graphics.color.orange, nTiles=48),
        db.graphics.Brick([0, 0, 0.5 * radius], [1.2 * thickness, 0.01, 0.5 * radius], db.graphics.color.brown),
    ],
)
model.create_rolling_disc(
    "contact", ["table", "coin"], axis_position=[0, 0, 0], axis_vector=[1, 0, 0], disc_radius=radius
)
model.create_sensor("coin", "position", name="way")  # its trace is drawn
solution = model.solve(end_time=end, step_size=end / 800)

way = solution["way"].values
angle = np.unwrap(np.arctan2(way[:, 1], way[:, 0]))[-1]
print(f"angle in the time of one turn: {angle:.5f} rad, of steady rolling {2 * np.pi:.5f} rad")
print(f"height at the end: {way[-1, 2]:.6f} m, at the start {way[0, 2]:.6f} m")
plt.plot(way[:, 0], way[:, 1])
plt.gca().set(xlabel="x of the center (m)", ylabel="y (m)")
plt.savefig("coin_way.png")
shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = shown.loads.show = shown.connectors.show = False
shown.sensors.traces.showPositionTrace = True
model.draw(file_name="coin_picture.png", view="axonometric")
solution.animate(
    file_name="coin_motion.gif", window_size=[420, 320], frames_per_second=20, speed=end / 3, view="axonometric"
)
