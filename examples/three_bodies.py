"""Three equal masses chase each other along an eight, held by nothing but their gravitation.

Chenciner and Montgomery found this orbit in 2000. Each mass passes every place a third of the period after the one
before it; energy and angular momentum, which is zero, stay.
"""

import matplotlib.pyplot as plt
import numpy as np

import dalembert as db

period, corner = 6.32591398, [0.97000436, -0.24308753, 0]  # valid for masses of 1 kg and a gravitational constant of 1
speed = np.array([-0.93240737, -0.86473146, 0])  # m/s, of the mass in the middle

model = db.Model()
places = [corner, [-x for x in corner], [0, 0, 0]]
colors = [db.graphics.color.red, db.graphics.color.green, db.graphics.color.blue]
masses = [
    model.create_mass_point(
        name=f"mass {i}",
        reference_position=places[i],
        initial_velocity=velocity,
        physics_mass=1,
        graphics_data_list=[db.graphics.Sphere(radius=0.05, color=colors[i], nTiles=32)],
    )
    for i, velocity in enumerate([-speed / 2, -speed / 2, speed])
]
markers = [model.add(db.MarkerBodyPosition(bodyNumber=mass)) for mass in masses]
for pair in ([0, 1], [1, 2], [2, 0]):
    ends = [markers[i] for i in pair]
    model.add(db.ConnectorGravity(markerNumbers=ends, gravitationalConstant=1, mass0=1, mass1=1))
for mass in masses:
    model.create_sensor(mass, "position")  # their traces are drawn

settings = db.SimulationSettings()
settings.timeIntegration.relativeTolerance = 1e-10
settings.timeIntegration.absoluteTolerance = 1e-10
step = period / 300
solution = model.solve(end_time=period, step_size=step, method="dop853", every=step, settings=settings)

first, second, third = ways = [solution[mass].position for mass in masses]
print(f"first mass after one period: {first[-1, 0]:.6f} m, at the start {corner[0]:.6f} m")
follower = min((second, third), key=lambda way: abs(way[100, 0] - corner[0]))
print(f"the next mass a third of the period later: {follower[100, 1]:.6f} m, where the first was {corner[1]:.6f} m")
for way, name, style in zip(ways, ("first", "second", "third"), ("-", "--", ":"), strict=True):
    plt.plot(way[:, 0], way[:, 1], style, label=name)
plt.gca().set(xlabel="x (m)", ylabel="y (m)")
plt.legend()
plt.savefig("eight.png")
shown = model.container.visualizationSettings
shown.connectors.show = shown.nodes.show = shown.markers.show = False
shown.sensors.traces.showPositionTrace = True
model.draw(file_name="eight_picture.png")
solution.animate(file_name="eight_motion.gif", window_size=[420, 320], frames_per_second=20, speed=period / 3)
