"""A cam lifts a valve against its spring: a roller runs on the outline of an eccentric disc.

The outline is a polygon of many sides, so that any shape is possible. The motion for a circle has a closed form. The
spring keeps contact, as long as the cam is not too fast.
"""

import numpy as np

import dalembert as db
from dalembert.utilities import InertiaCuboid, InertiaCylinder

radius, off, roller = 0.03, 0.008, 0.01  # m: radius of the disc, its eccentricity, radius of the roller
mass, stiffness, preload = 0.1, 8e3, 120  # kg, N/m, N
turns, end, sides = 10, 0.2, 360  # per second, s, 1

model = db.Model()
ground = model.ground
disc = db.graphics.Cylinder([off, 0, -0.01], [0, 0, 0.02], radius=radius, color=db.graphics.color.steelblue, nTiles=64)
shaft = db.graphics.Cylinder([0, 0, -0.02], [0, 0, 0.04], radius=0.006, color=db.graphics.color.grey, nTiles=32)
cam = model.create_rigid_body(
    name="cam",
    inertia=InertiaCylinder(density=7800, length=0.02, outerRadius=radius, axis=2),
    initial_angular_velocity=[0, 0, 2 * np.pi * turns],
    node_type=db.NodeType.RotationRxyz,
    graphics_data_list=[disc, shaft],
)
model.create_generic_joint(
    body_numbers=[ground, cam], position=[0, 0, 0], constrained_axes=[1, 1, 1, 1, 1, 0], show=False
)
cold = model.add(db.MarkerNodeCoordinate(nodeNumber=model.add(db.NodePointGround()), coordinate=0))
angle = model.add(db.MarkerNodeCoordinate(nodeNumber=cam.node_number, coordinate=5))
model.add(
    db.CoordinateConstraint(  # the shaft turns evenly
        markerNumbers=[cold, angle],
        velocityLevel=True,
        offset=2 * np.pi * turns,
        visualization=db.VCoordinateConstraint(show=False),
    )
)


def height(angle):
    """Height of the center of the roller above the shaft."""
    return off * np.sin(angle) + np.sqrt((radius + roller) ** 2 - (off * np.cos(angle)) ** 2)


wheel = db.graphics.Cylinder([0, 0, -0.008], [0, 0, 0.016], radius=roller, color=db.graphics.color.orange, nTiles=48)
stem = db.graphics.Brick([0, 0.04, 0], size=[0.006, 0.08, 0.006], color=db.graphics.color.grey)
valve = model.create_rigid_body(
    name="valve",
    reference_position=[0, height(0), 0],
    initial_velocity=[0, 2 * np.pi * turns * off, 0],
    inertia=InertiaCuboid(density=mass / 1e-6, sideLengths=[0.01, 0.01, 0.01]),
    graphics_data_list=[wheel, stem],
)
model.create_generic_joint(
    body_numbers=[ground, valve], position=[0, height(0), 0], constrained_axes=[1, 0, 1, 1, 1, 1], show=False
)
seat = model.add(db.MarkerBodyRigid(bodyNumber=ground, localPosition=[0, height(0) + 0.1, 0]))
head = model.add(db.MarkerBodyRigid(bodyNumber=valve, localPosition=[0, 0.05, 0]))
model.add(
    db.LinearSpringDamper(  # along y; the force vanishes at the end of the preload
        name="valve spring",
        markerNumbers=[seat, head],
        axisMarker0=[0, 1, 0],
        stiffness=stiffness,
        offset=-0.05 - preload / stiffness,
        visualization=db.VLinearSpringDamper(drawSize=0.012),
    )
)

# corners against the clock would have the inside on their left
corners = -2 * np.pi * np.arange(sides + 1) / sides
outline = np.column_stack([off + radius * np.cos(corners), radius * np.sin(corners)])
axis = model.add(db.MarkerBodyRigid(bodyNumber=cam))
middle = model.add(db.MarkerBodyRigid(bodyNumber=valve))
state = model.add(db.NodeGenericData(numberOfDataCoordinates=3 * sides, initialCoordinates=[0, 1e-3, 0] * sides))
contact = model.add(
    db.ObjectContactCurveCircles(
        name="roller on cam",
        markerNumbers=[axis, middle],
        nodeNumber=state,
        circlesRadii=[roller],
        segmentsData=db.MatrixContainer(np.hstack([outline[:-1], outline[1:]])),
        contactStiffness=2e10,  # per length of the segments
        contactDamping=1e6,
        visualization=db.VObjectContactCurveCircles(show=False),
    )
)

settings = db.SimulationSettings()
settings.linearSolverType = db.LinearSolverType.EigenSparse
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.6
solution = model.solve(end_time=end, step_size=end / 4000, settings=settings)

t, y = solution.times, solution[valve].position[:, 1]
lift = y - height(0)
expected = radius + roller + off - height(0)
print(f"largest lift: {1e3 * lift.max():.3f} mm, of a roller on a circle {1e3 * expected:.3f} mm")
print(f"largest difference on the way: {1e6 * np.abs(y - height(2 * np.pi * turns * t)).max():.1f} um")
solution.plot("valve.position", file_name="cam_lift.png")
shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = shown.sensors.show = False
model.draw(file_name="cam_picture.png")
solution.animate(file_name="cam_motion.gif", window_size=[420, 320], frames_per_second=20, speed=end / 3)
