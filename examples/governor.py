"""A centrifugal governor of Watt and Porter: the sleeve on its spindle rises with the speed.

Two arms with balls hang on the spindle; links lift the sleeve, whose weight increases the required speed. The height of
the cone of the arms is (1 + M / m) g / w^2, with the masses M of the sleeve and m of a ball, independently of the
length of the arms.
"""

import numpy as np

import dalembert as db
from dalembert.utilities import InertiaCylinder, InertiaSphere, RotationMatrixY

arm, ball, sleeve, g = 0.3, 1.0, 4.0, 9.81  # m, kg, kg, m/s^2
speeds = [15.0, 20.0]  # rad/s
ramp, rest = 0.5, 2.5  # s
height = (1 + sleeve / ball) * g / speeds[0] ** 2  # height of the cone, from the pivots down to the balls
angle = np.arccos(height / arm)

model = db.Model()
model.create_ground(
    "foot", graphics_data_list=[db.graphics.Cylinder([0, 0, -0.7], [0, 0, 0.05], 0.15, db.graphics.color.grey)]
)
spindle = model.create_rigid_body(
    "spindle",
    initial_angular_velocity=[0, 0, speeds[0]],
    inertia=InertiaCylinder(7800, 0.7, 0.01, axis=2),
    node_type=db.NodeType.RotationRxyz,
    graphics_data_list=[db.graphics.Cylinder([0, 0, -0.65], [0, 0, 0.7], 0.01, color=db.graphics.color.grey)],
)
model.create_revolute_joint(body_numbers=["ground", "spindle"], position=[0, 0, 0], axis=[0, 0, 1], show=False)
place = [0, 0, -2 * height]
model.create_rigid_body(
    "sleeve",
    reference_position=place,
    initial_angular_velocity=[0, 0, speeds[0]],
    inertia=InertiaCylinder(sleeve / (np.pi * 0.04**2 * 0.06), 0.06, 0.04, axis=2),
    gravity=[0, 0, -g],
    graphics_data_list=[db.graphics.Cylinder([0, 0, -0.03], [0, 0, 0.06], 0.04, color=db.graphics.color.steelblue)],
)
model.create_prismatic_joint("guide", ["spindle", "sleeve"], position=place, axis=[0, 0, 1], show=False)
for side in (1, -1):
    name, direction = f"arm {side}", np.array([side * np.sin(angle), 0, -np.cos(angle)])
    model.create_rigid_body(
        name,
        reference_position=arm * direction,
        reference_rotation_matrix=RotationMatrixY(-side * angle),
        initial_velocity=np.cross([0, 0, speeds[0]], arm * direction),
        initial_angular_velocity=[0, 0, speeds[0]],
        inertia=InertiaSphere(ball, 1e-3),  # of points
        gravity=[0, 0, -g],
        graphics_data_list=[
            db.graphics.Sphere(radius=0.05, color=db.graphics.color.orange, nTiles=24),
            db.graphics.Cylinder([0, 0, 0], [0, 0, arm], 0.008, color=db.graphics.color.grey),
        ],
    )
    model.create_revolute_joint(body_numbers=["spindle", name], position=[0, 0, 0], axis=[0, 1, 0], show=False)
    model.create_distance_constraint(body_numbers=[name, "sleeve"], draw_size=0.008)


def motor(mbs, t, itemNumber, offset):
    """Return the angle of the spindle, whose speed grows between two spells of rest."""
    u = np.clip(t - rest, 0, ramp)
    gained = (speeds[1] - speeds[0]) * (0.5 * u**2 / ramp + max(0.0, t - rest - ramp))
    return speeds[0] * t + gained


fixed = model.add(db.MarkerNodeCoordinate(nodeNumber=model.add(db.NodePointGround()), coordinate=0))
counter = model.add(db.NodeGenericData(numberOfDataCoordinates=1, initialCoordinates=[0]))
turned = model.add(
    db.MarkerBodiesRelativeRotationCoordinate(bodyNumbers=["ground", "spindle"], nodeNumber=counter, axis0=[0, 0, 1])
)
model.add(db.CoordinateConstraint(markerNumbers=[fixed, turned], offsetUserFunction=motor))
lift = model.add(db.MarkerBodiesRelativeTranslationCoordinate(bodyNumbers=["spindle", "sleeve"], axis0=[0, 0, 1]))
model.add(db.CoordinateSpringDamper(markerNumbers=[fixed, lift], damping=40))  # damping of the oil in the sleeve
model.create_sensor(lift, "coordinates", name="lift")

settings = db.SimulationSettings()
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.8
solution = model.solve(end_time=rest + ramp + 2, step_size=2.5e-3, settings=settings)

time, way = solution.times, solution["lift"].values
for speed, at in zip(speeds, (np.interp(rest, time, way), way[-1]), strict=True):
    theory = (1 + sleeve / ball) * g / speed**2
    print(f"height of the cone at {speed:.0f} rad/s: {-0.5 * at:.5f} m, Porter {theory:.5f} m")
solution.plot("lift", file_name="governor_sleeve.png")
shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = shown.loads.show = shown.sensors.show = False
model.draw(file_name="governor_picture.png", view="axonometric")
solution.animate(
    file_name="governor_motion.gif",
    window_size=[420, 320],
    frames_per_second=20,
    speed=(rest + ramp + 2) / 3,
    view="axonometric",
)
