"""A trolley of a crane starts to run, and the load on its rope swings.

The rope is a chain of cable elements with little mass and hardly any stiffness in bending, pulled straight by the load.
While the trolley accelerates, rope and load swing about a line that leans back; how far they swing when it runs on
depends on how long it took. A pendulum with all of its mass at the end swings by ``2 a / g |sin(omega T / 2)|``.
"""

import matplotlib.pyplot as plt
import numpy as np

import dalembert as db
from dalembert.beams import GenerateStraightLineANCFCable2D

length, elements = 12.0, 12  # m
load, rope = 800.0, 0.9  # kg, kg/m
acceleration, start, duration, end, g = 0.25, 1.0, 2.5, 20.0, 9.81  # m/s^2, s, s, s, m/s^2

model = db.Model()
girder = db.graphics.Brick([6, 0.4, 0], [16, 0.5, 0.5], color=db.graphics.color.lightgrey)
model.create_ground(graphics_data_list=[girder])


def way(t):
    """Displacement of the trolley, with a pause."""
    speed_up = min(max(0.0, t - start), duration)
    return acceleration * (speed_up**2 / 2 + speed_up * max(0.0, t - start - duration))


cable = db.Cable2D(
    physicsMassPerLength=rope,
    physicsBendingStiffness=40.0,
    physicsAxialStiffness=8e6,
    physicsAxialDamping=8e4,
    visualization=db.VCable2D(drawHeight=0.05),
)
nodes, cables, *_ = GenerateStraightLineANCFCable2D(
    model.system, [0, 0, 0], [0, -length, 0], elements, cable, massProportionalLoad=[0, -g, 0],
    fixedConstraintsNode0=[0, 1, 0, 0],
)  # fmt: skip
fixed = model.add(db.MarkerNodeCoordinate(nodeNumber=model.add(db.NodePointGround()), coordinate=0))
trolley = model.add(db.MarkerNodeCoordinate(nodeNumber=nodes[0], coordinate=0))
model.add(
    db.CoordinateConstraint(markerNumbers=[fixed, trolley], offsetUserFunction=lambda mbs, t, item, offset: way(t))
)


def draw_trolley(mbs, item):
    """Return the trolley, where the rope begins."""
    x, y, _ = mbs.GetNodeOutput(nodes[0], db.OutputVariableType.Position, db.ConfigurationType.Visualization)
    return [db.graphics.Brick([x, y + 0.1, 0], [1, 0.25, 0.6], color=db.graphics.color.dodgerblue)]


model.add(db.ObjectGround(visualization=db.VObjectGround(graphicsDataUserFunction=draw_trolley)))
drawing = db.graphics.Brick([0, -0.6, 0], [1.2, 1.2, 1.2], color=db.graphics.color.orange)
weight = model.create_mass_point(
    reference_position=[0, -length, 0], physics_mass=load, gravity=[0, -g, 0], graphics_data_list=[drawing]
)
hook = model.add(db.MarkerNodePosition(nodeNumber=nodes[-1]))
model.add(db.SphericalJoint(markerNumbers=[hook, model.add(db.MarkerBodyPosition(bodyNumber=weight))]))

model.solve_static(update_initial_values=True)  # the rope gets longer
solution = model.solve(end_time=end, step_size=end / 4000, every=0.02)

times, place = solution.times, solution[weight].position
hang = -place[0, 1]
angle = np.arctan2(place[:, 0] - [way(t) for t in times], -place[:, 1])
swing = np.abs(angle[times > start + duration]).max()
pendulum = 2 * acceleration / g * abs(np.sin(np.sqrt(g / hang) * duration / 2))
print(f"the rope is {1e3 * (hang - length):.1f} mm longer under load")
print(f"swing of the load: {np.degrees(swing):.3f} deg, pendulum of that length {np.degrees(pendulum):.3f} deg")
plt.plot(times, np.degrees(angle))
plt.gca().set(xlabel="time (s)", ylabel="swing (deg)")
plt.savefig("crane_swing.png")
shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = shown.loads.show = shown.connectors.show = False
model.draw(file_name="crane_picture.png")
solution.animate(file_name="crane_motion.gif", window_size=[420, 320], frames_per_second=20, speed=end / 3)
