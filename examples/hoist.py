"""A hoist: a winch lifts a load by a rope over two sheaves of a bridge and one at the hook.

The rope runs from the winch over the first sheave of the bridge, around the sheave of the hook, over the second sheave
and to its anchor. The hook hangs in two falls: it rises by half of the rope length on the winch, and the rope carries
half of its weight. Sheaves turn without friction, and the rope is elastic.
"""

import numpy as np

import dalembert as db
from dalembert.utilities import InertiaCuboid, SmoothStep, SmoothStepDerivative

mass, g, radius, stiffness = 500, 9.81, 0.15, 1.2e7  # kg, m/s^2, m, N of the rope
drum, turn, end = 0.2, 1.5 * np.pi, 4  # m, rad, s

model = db.Model()
sheave = db.graphics.Cylinder(
    pAxis=[0, 0, -0.02], vAxis=[0, 0, 0.04], radius=radius, color=db.graphics.color.grey, nTiles=48
)
beam = db.graphics.Brick(centerPoint=[0, 0.25, 0], size=[2.2, 0.12, 0.2], color=db.graphics.color.steelblue)
ground = model.create_ground(
    "bridge", graphics_data_list=[beam, *(db.graphics.Move(sheave, [x, 0, 0], np.eye(3)) for x in (-0.3, 0.3))]
)
block = db.graphics.Brick(centerPoint=[0, -0.45, 0], size=[0.6, 0.5, 0.6], color=db.graphics.color.orange)
hook = model.create_rigid_body(
    name="hook",
    reference_position=[0, -2, 0],
    inertia=InertiaCuboid(density=mass / 0.18, sideLengths=[0.6, 0.5, 0.6]),
    graphics_data_list=[sheave, block],
)
# vertical motion only; another example shows a swinging load
model.create_generic_joint(
    body_numbers=[ground, hook], position=[0, -2, 0], constrained_axes=[1, 0, 1, 1, 1, 1], show=False
)
weight = model.add(db.MarkerBodyMass(bodyNumber=hook))
model.add(db.LoadMassProportional(markerNumber=weight, loadVector=[0, -g, 0]))

# the angle of the winch is prescribed; it winds and unwinds the rope
winch = model.add(db.Node1D(name="winch"))
roll = db.graphics.Cylinder(
    pAxis=[0, 0, -0.1], vAxis=[0, 0, 0.2], radius=drum, color=db.graphics.color.dodgerblue, nTiles=48
)
model.add(
    db.ObjectRotationalMass1D(
        physicsInertia=2,
        nodeNumber=winch,
        referencePosition=[-1 - drum, -1, 0],
        visualization=db.VObjectRotationalMass1D(graphicsData=[roll]),
    )
)
start = model.add(db.MarkerNodeCoordinate(nodeNumber=model.add(db.NodePointGround()), coordinate=0))
angle = model.add(db.MarkerNodeCoordinate(nodeNumber=winch, coordinate=0))


def wanted(mbs, t, itemNumber, lOffset):
    return SmoothStep(t, 1, 3, 0, turn)


def speed_wanted(mbs, t, itemNumber, lOffset):
    return SmoothStepDerivative(t, 1, 3, 0, turn)


drive = model.add(
    db.CoordinateConstraint(
        name="drive",
        markerNumbers=[start, angle],
        offsetUserFunction=wanted,
        offsetUserFunction_t=speed_wanted,
        visualization=db.VCoordinateConstraint(show=False),
    )
)

places = [[-1, -1, 0], [-0.3, 0, 0], None, [0.3, 0, 0], [1, -0.5, 0]]
markers = [
    model.add(db.MarkerBodyRigid(bodyNumber=hook if place is None else ground, localPosition=place or [0, 0, 0]))
    for place in places
]
rope = model.add(
    db.ReevingSystemSprings(
        name="rope",
        markerNumbers=[*markers, start, angle],
        hasCoordinateMarkers=True,
        coordinateFactors=[0, -drum],
        stiffnessPerLength=stiffness,
        dampingPerLength=2e5,
        referenceLength=1,  # until its length over the sheaves is known
        sheavesAxes=db.Vector3DList([[0, 0, -1], [0, 0, -1], [0, 0, 1], [0, 0, -1], [0, 0, -1]]),
        sheavesRadii=[0, radius, radius, radius, 0],
        visualization=db.VReevingSystemSprings(ropeRadius=0.012, color=db.graphics.color.black),
    )
)
rope.reference_length = rope.distance

model.solve_static(update_initial_values=True)  # the rope takes the weight, before the winch turns
hung = hook.position[1]
settings = db.SimulationSettings()
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.7
solution = model.solve(end_time=end, step_size=2e-3, settings=settings)

rise = hook.position[1] - hung
print(f"force of the rope: {rope.force_local:.1f} N, half of the weight {mass * g / 2:.1f} N")
print(f"the hook sinks under its weight by {1e3 * (-2 - hung):.2f} mm")
print(f"the hook rises by: {rise:.4f} m, half of the rope taken in {drum * turn / 2:.4f} m")
solution.plot("hook.position", file_name="hoist_height.png")
solution.plot("rope.force_local", file_name="hoist_force.png")
shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = shown.loads.show = shown.sensors.show = False
model.draw(file_name="hoist_picture.png")
solution.animate(file_name="hoist_motion.gif", window_size=[420, 320], frames_per_second=20, speed=end / 3)
