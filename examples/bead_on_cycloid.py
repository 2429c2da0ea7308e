"""Beads on a wire that is bent to a cycloid: wherever they start, they are at its lowest point at the same time.

Huygens found it for clocks: the time is pi sqrt(a / g), the circle that rolls having the radius a. The wire is made of
spatial cable elements, all of whose coordinates are held by constraints of vectors; sliding joints let the beads move
along it without friction.
"""

from itertools import pairwise

import numpy as np

import dalembert as db

a, g, elements, mass = 0.5, 9.81, 24, 0.2  # m, m/s^2, 1, kg
time = np.pi * np.sqrt(a / g)  # s
starts = [0.15, 0.5, 0.8]  # parts of the arc from the top to the lowest point

# arc length s between the cusps: 4 a (1 - cos(angle / 2)), equally spaced
arc = np.linspace(0.1 * a, 7.9 * a, elements + 1)  # the cusps are excluded, because their curvature is infinite
angles = 2 * np.arccos(1 - arc / (4 * a))
points = np.column_stack([a * (angles - np.sin(angles)), 0 * angles, -a * (1 - np.cos(angles))])
slopes = np.column_stack([np.sin(angles / 2), 0 * angles, -np.cos(angles / 2)])

model = db.Model()
nodes = [model.add(db.NodePointSlope1(referenceCoordinates=[*p, *s])) for p, s in zip(points, slopes, strict=True)]
fixed = model.add(db.MarkerNodeCoordinates(nodeNumber=model.add(db.NodePointGround())))
for node, p, s in zip(nodes, points, slopes, strict=True):
    held = model.add(db.MarkerNodeCoordinates(nodeNumber=node))  # measures total coordinates
    model.add(db.CoordinateVectorConstraint(markerNumbers=[fixed, held], scalingMarker1=np.eye(6), offset=[*p, *s]))
length = arc[1] - arc[0]
wires = [
    model.add(
        db.ObjectANCFCable(
            physicsLength=length, physicsMassPerLength=0.1, physicsBendingStiffness=1, physicsAxialStiffness=1e3,
            strainIsRelativeToReference=1, nodeNumbers=[n0, n1], visualization=db.VObjectANCFCable(radius=0.005),
        )
    )
    for n0, n1 in pairwise(nodes)
]  # fmt: skip
shapes = [model.add(db.MarkerBodyBeamShape(bodyNumber=wire)) for wire in wires]
offsets = [length * i for i in range(elements)]
joints = []
for part, color in zip(starts, (db.graphics.color.red, db.graphics.color.green, db.graphics.color.blue), strict=True):
    s = 4 * a * part
    angle = 2 * np.arccos(1 - s / (4 * a))
    place = [a * (angle - np.sin(angle)), 0, -a * (1 - np.cos(angle))]
    bead = model.create_mass_point(
        reference_position=place, physics_mass=mass, gravity=[0, 0, -g],
        graphics_data_list=[db.graphics.Sphere(radius=0.03, color=color)],
    )  # fmt: skip
    slider = model.add(db.MarkerBodyPosition(bodyNumber=bead))
    element = int((s - arc[0]) / length)
    state = model.add(db.NodeGenericData(numberOfDataCoordinates=2, initialCoordinates=[element, s - arc[0]]))
    joints.append(
        model.add(
            db.SlidingJoint(
                name=f"from {100 * part:.0f} %", markerNumbers=[slider, shapes[element]], slidingMarkerNumbers=shapes,
                slidingMarkerOffsets=offsets, nodeNumber=state, constrainRotations=[0, 0, 0],
            )
        )
    )  # fmt: skip
model.assemble()
model.system.ComputeConsistentInitialConditions()  # the wire is as close to the cycloid as its elements can be

solution = model.solve(end_time=1.2 * time, step_size=1e-3 * time)

lowest = 4 * a - arc[0]
for part, joint in zip(starts, joints, strict=True):
    down = np.interp(lowest, solution[joint].sliding_coordinate, solution.times)
    print(f"bead from {100 * part:.0f} % of the arc is down after: {down:.4f} s, Huygens {time:.4f} s")
solution.plot(*((joint, "sliding_coordinate") for joint in joints), file_name="beads_way.png")
shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = shown.loads.show = shown.sensors.show = shown.connectors.show = False
model.draw(file_name="beads_picture.png", view=[[1, 0, 0], [0, 0, 1], [0, -1, 0]])
solution.animate(
    file_name="beads_motion.gif",
    window_size=[420, 320],
    frames_per_second=20,
    speed=0.4 * time,
    view=[[1, 0, 0], [0, 0, 1], [0, -1, 0]],
)
