"""A ball swings at the bottom of a ring-shaped tube, and a barrel rocks on the floor; both slide without friction.

The center of the ball moves on a circle, as that of a pendulum does. The barrel is higher over the floor the more it
tilts, by the radius of its outline, and rocks about the point where it touches.
"""

import numpy as np

import dalembert as db
from dalembert.utilities import RigidBodyInertia, RotationMatrixY

g = 9.81  # m/s^2
# m: from the axis of the ring to that of its tube; radius of the tube; radius of the ball
ring, tube, radius = 1.0, 0.15, 0.05
swing = ring + tube - radius  # m: the circle of the center of the ball
tilt, lean = 0.05, 0.01  # rad: initial angles of ball and barrel
mass, moment = 2.0, 0.01  # kg, kg m^2
height, bulge = 0.1, 0.5  # m: radius of the barrel in its middle, and of its outline along the axis

model = db.Model()
ground = model.add(db.MarkerBodyRigid(bodyNumber=model.ground))
inertia = RigidBodyInertia(mass, np.diag([moment] * 3))
ball = model.create_rigid_body(
    reference_position=[swing * np.sin(tilt), -swing * np.cos(tilt), 0],
    inertia=inertia,
    gravity=[0, -g, 0],
    graphics_data_list=[db.graphics.Sphere(radius=radius, color=db.graphics.color.red, nTiles=32)],
)
torus = db.graphics.Torus(
    point=[0, 0, 0], axis=[0, 0, 1], radiusMajor=ring, radiusMinor=tube, color=[0.5, 0.5, 0.6, 0.3], nTilesMajor=64
)
model.create_ground(graphics_data_list=[torus])
model.add(
    db.ObjectContactSphereTorus(
        markerNumbers=[model.add(db.MarkerBodyRigid(bodyNumber=ball)), ground],
        nodeNumber=model.add(db.NodeGenericData(numberOfDataCoordinates=4, initialCoordinates=[0, 0, 0, 0])),
        radiusSphere=radius,
        torusMajorRadius=ring,
        torusMinorRadius=tube,
        torusAxis=[0, 0, 1],
        contactStiffness=1e6,
        contactDamping=1e3,
    )
)

floor = model.create_ground(reference_position=[3, 0, 0])
outline = [[0, 0], *([x + 0.1, height - x**2] for x in np.linspace(-0.1, 0.1, 21)), [0.2, 0]]
barrel = model.create_rigid_body(
    reference_position=[3, 0, bulge - (bulge - height) * np.cos(lean)],
    reference_rotation_matrix=RotationMatrixY(lean),
    inertia=inertia,
    gravity=[0, 0, -g],
    graphics_data_list=[
        db.graphics.SolidOfRevolution([-0.1, 0, 0], [1, 0, 0], outline, color=db.graphics.color.brown, nTiles=32)
    ],
)
model.create_generic_joint(body_numbers=[floor, barrel], position=[3, 0, 0.1], constrained_axes=[0, 1, 0, 1, 0, 1])
model.add(
    db.ObjectContactConvexRoll(
        markerNumbers=[
            model.add(db.MarkerBodyRigid(bodyNumber=floor)),
            model.add(db.MarkerBodyRigid(bodyNumber=barrel)),
        ],
        nodeNumber=model.add(db.NodeGenericData(numberOfDataCoordinates=3, initialCoordinates=[0, 0, 0])),
        rollLength=0.2,
        coefficientsHull=[-1, 0, height],  # a parabola, whose radius in the middle is 1/2 m
        contactStiffness=1e6,
        contactDamping=1e3,
    )
)

settings = db.SimulationSettings()
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.6
solution = model.solve(end_time=4, step_size=1e-3, settings=settings)


def period(values: np.ndarray, time: np.ndarray) -> float:
    """Twice the mean time between two passages through zero."""
    i = np.flatnonzero(values[:-1] * values[1:] < 0)
    passed = time[i] - values[i] * (time[i + 1] - time[i]) / (values[i + 1] - values[i])
    return 2 * (passed[-1] - passed[0]) / (len(passed) - 1)


x = solution[ball].position[:, 0]
print(f"period of the ball: {period(x, solution.times):.4f} s, of a pendulum {2 * np.pi * np.sqrt(swing / g):.4f} s")
rocks = period(solution[barrel].rotation[:, 1], solution.times)
expected = 2 * np.pi * np.sqrt(moment / (mass * g * (bulge - height)))
print(f"period of the barrel: {rocks:.4f} s, by its outline {expected:.4f} s")
solution.plot((ball, "position"), file_name="ring_way.png")
shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = shown.connectors.show = shown.loads.show = False
model.draw(file_name="ring_picture.png")
solution.animate(file_name="ring_motion.gif", window_size=[420, 320], frames_per_second=20, speed=4 / 3)
