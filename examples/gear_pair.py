"""A pinion drives a gear: involute teeth are convex, so each of them is the hull of points of its flanks.

No ratio is prescribed: teeth push teeth, in general contact. Over whole pitches, the gear turns as the numbers of teeth
say. How many pairs of teeth touch at a time, in the mean, is the contact ratio, which follows from the circles of tips
and bases.
"""

import numpy as np

import dalembert as db
from dalembert.utilities import InertiaCylinder

module, teeth, pressure_angle = 4e-3, [18, 36], np.radians(20)  # m, 1, rad
width, backlash, points = 0.02, 1e-4, 24  # m, m, per flank
stiffness, damping, density = 4e7, 4e3, 7800.0  # N/m, Ns/m, kg/m^3
speed, torque = 20.0, 4.0  # speed of the pinion: rad/s; torque on the gear: Nm

pitch_radii = [module * z / 2 for z in teeth]
base_radii = [r * np.cos(pressure_angle) for r in pitch_radii]
tip_radii = [r + module for r in pitch_radii]
distance = sum(pitch_radii)


def involute(angle):
    return np.tan(angle) - angle


def tooth(pitch, base, tip):
    """Points of both flanks of a tooth along x, from the base circle to the tip, counterclockwise."""
    half = (np.pi * module / 2 - backlash) / (2 * pitch) + involute(pressure_angle)  # as an angle at the base circle
    roll = np.linspace(0, np.sqrt((tip / base) ** 2 - 1), points)  # steps of equal turns of the normal
    radii, angles = base * np.sqrt(1 + roll**2), half - involute(np.arctan(roll))
    flank = np.stack([radii * np.cos(angles), radii * np.sin(angles)], axis=1)
    return np.concatenate([flank * [1, -1], flank[::-1]])


model = db.Model()
contact = model.system.AddGeneralContact()
contact.SetFrictionPairings([[0.0]])
surface = {"contactStiffness": 2 * stiffness, "contactDamping": damping / 2, "frictionMaterialIndex": 0}
nodes = []
for number, color in enumerate([db.graphics.color.orange, db.graphics.color.steelblue]):
    count, radius = teeth[number], pitch_radii[number]
    profile = tooth(radius, base_radii[number], tip_radii[number])
    turns = 2 * np.pi / count * (np.arange(count) + 0.5 * number)  # teeth of the pinion meet gaps of the gear
    # points on the root circle, for the picture
    feet = (radius - 1.25 * module) / base_radii[number] * profile[[0, -1]]
    whole = np.vstack([feet[:1], profile, feet[1:]])
    turned = [whole @ np.array([[np.cos(t), np.sin(t)], [-np.sin(t), np.cos(t)]]) for t in turns]
    rim = np.concatenate(turned)
    drawn = db.graphics.SolidExtrusion(
        vertices=rim,
        segments=[[i, (i + 1) % len(rim)] for i in range(len(rim))],
        pOff=[0, 0, -width / 2],
        height=width,
        color=color,
        addEdges=True,
    )
    velocity = speed if number == 0 else -speed * teeth[0] / teeth[1]
    node = model.add(db.Node1D(referenceCoordinates=[0], initialVelocities=[velocity]))
    body = model.add(
        db.ObjectRotationalMass1D(
            nodeNumber=node,
            physicsInertia=InertiaCylinder(density, width, radius, axis=2).GetInertia6D()[2],
            referencePosition=[number * distance, 0, 0],
            visualization=db.VObjectRotationalMass1D(graphicsData=[drawn]),
        )
    )
    marker = model.add(db.MarkerBodyRigid(bodyNumber=body))
    for outline in turned:
        both = [[x, y, z] for z in (-width / 2, width / 2) for x, y in outline[1:-1]]
        contact.AddConvexHullWithMarker(marker, pointList=both, **surface)
    on_shaft = model.add(db.MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
    share = teeth[number] / teeth[1]  # both torques act against the clock: the wheels turn against each other
    model.add(db.LoadCoordinate(markerNumber=on_shaft, load=torque * share))
    nodes.append(node)


def solve(begin, end):
    model.solve(
        start_time=begin, end_time=end, step_size=5e-6, every=end - begin, method="velocity_verlet",
        update_initial_values=True,
    )  # fmt: skip


def touching():
    pairs = contact.GetConvexContacts()["pairs"]
    return len(np.unique(pairs, axis=0)) if len(pairs) else 0


pitch_time = 2 * np.pi / teeth[0] / speed
solve(0, 2 * pitch_time)  # the flanks come to rest on each other
angles, numbers, samples, pitches = [], [], 60, 3
for k in range(samples * pitches + 1):
    begin = (2 + k / samples) * pitch_time
    angles.append([node.coordinates for node in nodes])
    numbers.append(touching())
    solve(begin, begin + pitch_time / samples)
angles = np.array(angles)
turned = angles - angles[0]
print(f"ratio of turns: {-turned[-1, 1] / turned[-1, 0]:.5f} 1, by the numbers of teeth {teeth[0] / teeth[1]:.5f} 1")
path = sum(np.sqrt(tip**2 - base**2) for tip, base in zip(tip_radii, base_radii, strict=True))
path -= distance * np.sin(pressure_angle)
expected = path / (np.pi * module * np.cos(pressure_angle))
print(f"contact ratio: {np.mean(numbers[:-1]):.3f} pairs, by the circles {expected:.3f} pairs")
view = model.container.visualizationSettings
view.nodes.show = view.markers.show = view.loads.show = False
model.draw(file_name="gear_pair_picture.png")
