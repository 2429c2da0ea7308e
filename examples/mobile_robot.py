"""A vehicle with mecanum wheels drives through a room, sideways and turning, and maps it by a lidar.

Drives keep the wheels at the speeds of the kinematics of mecanum wheels; friction along the axles of the rollers moves
the vehicle. Odometry computes the pose of the vehicle from the wheel angles, up to their slip. The lidar measures
distances along 72 rays five times a second; the poses of odometry convert them to points of a map. The room is known,
so the last scan also gives the final pose of the vehicle, to the tenth of a millimeter.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import least_squares

import dalembert as db
from dalembert.robotics.mobile import MobileKinematics, MobileRobot2MBS
from dalembert.robotics.motion import ProfileConstantAcceleration, Trajectory
from dalembert.robotics.utilities import AddLidar
from dalembert.utilities import HTtranslate

radius, base, track, height = 0.0762, 0.4, 0.39, 0.1532  # m, of wheels, between axles, between wheels, of the platform
room = np.array([6.0, 4.0])  # m
step, scan, rays = 4e-3, 0.2, 72  # s, s, 1
start = np.array([-2.0, -1.0, 0.0])  # m, m, rad

trajectory = Trajectory(start)
for pose, duration in [
    ([0, -1, 0], 5),
    ([0.5, 0.8, np.pi / 2], 8),
    ([2, 0.8, np.pi / 2], 5),
    ([2, -0.5, np.pi], 7),
]:
    trajectory.Add(ProfileConstantAcceleration(pose, duration))
end = trajectory.GetTimes()[-1]

model = db.Model()

# ---- the room: walls, a box and a column, which the lidar sees
x, y = room / 2
shapes = [
    db.graphics.Brick(centerPoint=center, size=size, color=db.graphics.color.steelblue)
    for center, size in [
        ([0, y + 0.1, 0.25], [2 * x + 0.4, 0.2, 0.5]),
        ([0, -y - 0.1, 0.25], [2 * x + 0.4, 0.2, 0.5]),
        ([x + 0.1, 0, 0.25], [0.2, 2 * y, 0.5]),
        ([-x - 0.1, 0, 0.25], [0.2, 2 * y, 0.5]),
    ]
]
box, column = [np.array([-1.2, 1.2]), np.array([0.8, 0.6])], [np.array([1.2, -1.2]), 0.3]
shapes.append(db.graphics.Brick(centerPoint=[*box[0], 0.25], size=[*box[1], 0.5], color=db.graphics.color.orange))
shapes.append(db.graphics.Cylinder([*column[0], 0], [0, 0, 0.5], column[1], nTiles=96, color=db.graphics.color.orange))
floor = db.graphics.CheckerBoard(size=room[0] + 0.4, nTiles=16)
ground = model.add(db.MarkerBodyRigid(bodyNumber=model.create_ground("room", graphics_data_list=[*shapes, floor])))
points, triangles = np.empty((0, 3)), np.empty((0, 3), dtype=int)
for shape in shapes:
    more_points, more_triangles = db.graphics.ToPointsAndTrigs(shape)
    triangles = np.vstack([triangles, np.array(more_triangles) + len(points)])
    points = np.vstack([points, more_points])
seen = model.create_distance_sensor_geometry(points, triangles, ground, search_tree_cell_size=[16, 16, 1])

# ---- the vehicle, and drives on its axles
made = MobileRobot2MBS(
    model.system,
    {
        "gravity": [0, 0, -9.81],
        "platformDimensions": [0.5, 0.7, 0.2],
        "platformMass": 42.5,
        "platformInitialPose": HTtranslate([*start[:2], height]),
        "platformInitialOmega": [0, 0, 0],
        "platformInitialVelocity": [0, 0, 0],
        "platformCOM": [0, 0, 0],
        "platformRepresentation": "box",
        "serialRobotMountpoint": HTtranslate([0, 0, 0.1]),
        "wheelType": 0,
        "wheelNumbers": 4,
        "wheelBase": base,
        "wheelTrack": track,
        "wheelRadius": radius,
        "wheelWidth": 0.076,
        "wheelMass": 2.4,
        "wheelContactStiffness": 5e4,
        "wheelContactDamping": 5e2,
        "friction": [1.0, 0.0, 0.0],
        "frictionAngle": np.pi / 4,
        "viscousFrictionWheel": [0, 0],
        "proportionalZone": 1e-3,
        "debugOffset": 0,
    },
    ground,
)
platform = made["bPlatformList"][0]
drives = []
for joint in made["oAxlesList"]:
    axle = model.system.GetObject(joint)
    same = {name: axle[name] for name in ("markerNumbers", "rotationMarker0", "rotationMarker1")}
    turns = model.add(db.NodeGenericData(initialCoordinates=[0], numberOfDataCoordinates=1))
    drives.append(model.add(db.TorsionalSpringDamper(**same, nodeNumber=turns, damping=5.0)))
kinematics = MobileKinematics(radius, base / 2, track / 2)


def drive(mbs, t):
    """Turn the wheels along the trajectory, whose velocities are those along the axes of the room."""
    (_, _, heading), (v_x, v_y, omega), _ = trajectory.Evaluate(t)
    along = np.cos(heading) * v_x + np.sin(heading) * v_y
    across = np.cos(heading) * v_y - np.sin(heading) * v_x
    for number, speed in zip(drives, kinematics.GetWheelVelocities([along, across, omega]), strict=True):
        mbs.SetObjectParameter(number, "velocityOffset", speed)
    return True


model.system.SetPreStepUserFunction(drive)

# ---- sensors ---------------------------------------------------------------------------------------------------------
lidar = model.add(db.MarkerBodyRigid(bodyNumber=platform, localPosition=[0, 0, 0.15]))
angles = np.linspace(-np.pi, np.pi, rays, endpoint=False)
sensors = AddLidar(
    model.system,
    seen,
    lidar,
    0.0,
    20.0,
    numberOfSensors=rays,
    angleStart=angles[0],
    angleEnd=angles[-1],
    storeInternal=True,
)
wheels = [model.create_sensor(drive, "rotation") for drive in drives]
settings = db.SimulationSettings()
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.5
solution = model.solve(end_time=end, step_size=step, every=scan, settings=settings)

# ---- odometry: straight lines in each interval, at the heading of its middle -----------------------------------------
t, place, rotation = solution.times, solution[platform].position, solution[platform].rotation
true = np.column_stack([place[:, :2], np.unwrap(rotation[:, 2])])
turned = np.column_stack([sensor.values for sensor in wheels])
steps = kinematics.GetCartesianVelocities(np.diff(turned, axis=0))
odometry = [start]
for along, across, turn in steps:
    px, py, heading = odometry[-1]
    middle = heading + turn / 2
    chord = np.sinc(turn / (2 * np.pi))  # ratio of chord to arc length
    odometry.append(
        [
            px + chord * (np.cos(middle) * along - np.sin(middle) * across),
            py + chord * (np.sin(middle) * along + np.cos(middle) * across),
            heading + turn,
        ]
    )
odometry = np.array(odometry)

# ---- the map
distances = np.column_stack([solution[sensor].values for sensor in sensors])


def on_map(poses):
    """Return points that the rays of the last scans have hit, for given poses of the vehicle."""
    direction = poses[:, 2:] + angles
    return poses[:, None, :2] + distances[-len(poses) :, :, None] * np.stack(
        [np.cos(direction), np.sin(direction)], axis=-1
    )


def distance_to_shapes(p):
    """Return how far points are from walls, box and column."""
    walls = np.abs(np.abs(p) - room / 2).min(axis=-1)
    beyond = np.abs(p - box[0]) - box[1] / 2
    outside = np.linalg.norm(np.maximum(beyond, 0), axis=-1) + np.minimum(beyond.max(axis=-1), 0)
    round_column = np.linalg.norm(p - column[0], axis=-1) - column[1]
    return np.minimum(walls, np.minimum(np.abs(outside), np.abs(round_column)))


exact, mapped = on_map(true), on_map(odometry)
off = np.linalg.norm(odometry[-1, :2] - true[-1, :2])
print(f"Scanned points lie within {1e3 * distance_to_shapes(exact).max():.2f} mm of what they were taken from.")
print(f"After {end:.0f} s, odometry is off by {1e3 * off:.0f} mm: rollers slip when the vehicle accelerates.")
print(f"Points of the map lie within {1e3 * distance_to_shapes(mapped).max():.0f} mm of what they show.")

# ---- the lidar gives a more accurate pose: the last scan is fitted to the room ---------------------------------------
found = least_squares(lambda pose: distance_to_shapes(on_map(pose[None])[-1]), odometry[-1]).x
for name, unit, value, real in zip(["x", "y", "heading"], ["m", "m", "rad"], found, true[-1], strict=True):
    print(f"{name} at the end by the lidar: {value:.5f} {unit}, real pose {real:.5f} {unit}")

plan = mapped.reshape(-1, 2)
plt.plot(plan[:, 0], plan[:, 1], ".", label="map")
plt.plot(true[:, 0], true[:, 1], label="way")
plt.gca().set(xlabel="x (m)", ylabel="y (m)")
plt.legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncols=2)
plt.savefig("mobile_robot_map.png")
view = model.container.visualizationSettings
view.nodes.show = view.markers.show = view.connectors.show = view.sensors.show = False
model.draw(file_name="mobile_robot_picture.png", around=platform, zoom=0.5)
for item in model:
    if item.type == "ObjectGround" and item.name != "room":  # rays are those of the last scan
        item.hide()
solution.animate(file_name="mobile_robot_motion.gif", window_size=[420, 320], frames_per_second=20, speed=end / 6)
