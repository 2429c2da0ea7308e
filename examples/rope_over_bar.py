"""A rope slips from a smooth bar: it hangs down on both sides, and its longer side pulls it over.

Contact between the bar and each element of the rope is frictionless, so the tension is equal on both sides of the bar.
Let x be half the difference of the lengths; the weight of 2 x moves the whole rope of length L, and x'' = 2 g x / L:
the displacement grows as cosh(t sqrt(2 g / L)), independently of the radius of the bar.
"""

import matplotlib.pyplot as plt
import numpy as np

import dalembert as db
from dalembert.beams import PointsAndSlopes2ANCFCable2D

length, density, stiffness, g = 3.0, 0.5, 2e4, 9.81  # m, kg/m, N, m/s^2
radius, thickness, start, end = 0.1, 0.01, 0.05, 1.0  # m, m, m, s
elements, segments = 120, 4  # the latter per element
bend = radius + 0.5 * thickness  # radius of the middle line of the rope
longer = 0.5 * (length - np.pi * bend) + start

along = np.linspace(0, length, elements + 1)
angle = np.clip((along - (length - longer - np.pi * bend)) / bend, 0, np.pi)  # angle around the bar, clockwise
straight = np.minimum(along, length - longer - np.pi * bend) - (length - longer - np.pi * bend)  # left, up to the bar
points = np.column_stack([-bend * np.cos(angle), bend * np.sin(angle) + straight, np.sin(angle), np.cos(angle)])
points[:, 1] -= np.maximum(along - (length - longer), 0)  # right, down from the bar

model = db.Model()
disc = db.graphics.Cylinder([0, 0, -0.1], [0, 0, 0.2], radius, db.graphics.color.grey, nTiles=64)
bar = model.add(db.MarkerBodyRigid(bodyNumber=model.create_ground("bar", graphics_data_list=[disc])))
rope = db.Cable2D(
    physicsMassPerLength=density, physicsBendingStiffness=1e-4, physicsAxialStiffness=stiffness,
    physicsAxialDamping=20, visualization=db.VCable2D(drawHeight=thickness),
)  # fmt: skip
nodes, cables, *_ = PointsAndSlopes2ANCFCable2D(
    model.system,
    points,
    [length / elements] * elements,
    rope,
    massProportionalLoad=[0, -g, 0],
    firstNodeIsLastNode=False,
)
for cable in cables:
    shape = model.add(db.MarkerBodyCable2DShape(bodyNumber=cable, numberOfSegments=segments))
    gaps = model.add(db.NodeGenericData(numberOfDataCoordinates=segments, initialCoordinates=[0.1] * segments))
    model.add(
        db.ObjectContactCircleCable2D(
            markerNumbers=[bar, shape], nodeNumber=gaps, numberOfContactSegments=segments, contactStiffness=1e4,
            contactDamping=1, circleRadius=radius, offset=0.5 * thickness,
            visualization=db.VObjectContactCircleCable2D(show=False),
        )
    )  # fmt: skip

settings = db.SimulationSettings()
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.6
solution = model.solve(end_time=end, step_size=end / 1000, every=end / 100, settings=settings)

tip, time = solution[nodes[-1]], solution.times
y = tip.displacement[:, 1]
moved, rate = start - y, np.sqrt(2 * g / length)
theory = start * np.cosh(rate * time)
speed = -tip.velocity[-1, 1]
print(f"x after {end:.0f} s: {moved[-1]:.4f} m, by cosh {theory[-1]:.4f} m")
print(f"speed after {end:.0f} s: {speed:.4f} m/s, by sinh {start * rate * np.sinh(rate * end):.4f} m/s")
plt.plot(time, moved, label="rope")
plt.plot(time, theory, "--", label="cosh")
plt.gca().set(xlabel="time (s)", ylabel="x (m)")
plt.legend()
plt.savefig("rope_way.png")
shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = shown.sensors.show = shown.connectors.show = shown.loads.show = False
shown.contour.outputVariable = db.OutputVariableType.ForceLocal  # tension, as color
model.draw(file_name="rope_picture.png", view="front")
solution.animate(file_name="rope_motion.gif", window_size=[420, 320], frames_per_second=20, speed=end / 3, view="front")
