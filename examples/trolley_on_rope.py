"""A trolley oscillates on a tight rope, only because of the sag by its own weight.

The sag of a rope of length L and tension T under a force F at x is F x (L - x) / (L T); half of the work of the weight
is stored in the rope. The other half drives the trolley to the middle like a spring: it oscillates with the frequency g
sqrt(m / (L T)).
"""

import matplotlib.pyplot as plt
import numpy as np

import dalembert as db
from dalembert.utilities import GenerateStraightLineANCFCable2D

length, tension, mass, g = 20.0, 20e3, 100.0, 9.81  # m, N, kg, m/s^2
axial = 1e5  # N: a rope that stretches easily keeps its tension
elements, start = 12, 4.0  # m

model = db.Model()
cable = db.Cable2D(
    physicsMassPerLength=0.05,
    physicsBendingStiffness=1,
    physicsAxialStiffness=axial,
    physicsReferenceAxialStrain=-tension / axial,
    physicsAxialDamping=2e3,
    visualization=db.VCable2D(drawHeight=0.1),
)
nodes, cables, *_ = GenerateStraightLineANCFCable2D(
    model.system, [0, 0, 0], [length, 0, 0], elements, cable, fixedConstraintsNode0=[1, 1, 0, 0],
    fixedConstraintsNode1=[1, 1, 0, 0],
)  # fmt: skip
sliding = [model.add(db.MarkerBodyCable2DCoordinates(bodyNumber=each)) for each in cables]
trolley = model.create_mass_point(
    reference_position=[start, 0, 0],
    physics_mass=mass,
    gravity=[0, -g, 0],
    create_2d=True,
    graphics_data_list=[db.graphics.Brick(size=[1, 0.5, 0.5], color=db.graphics.color.orange)],
)
wheel = model.add(db.MarkerBodyPosition(bodyNumber=trolley))
step = length / elements
place = model.add(db.NodeGenericData(numberOfDataCoordinates=2, initialCoordinates=[int(start / step), start]))
model.add(
    db.SlidingJoint2D(
        markerNumbers=[wheel, sliding[int(start / step)]],
        slidingMarkerNumbers=sliding,
        slidingMarkerOffsets=[step * i for i in range(elements)],
        nodeNumber=place,
    )
)
brake = model.create_coordinate_constraint(body_numbers=[None, trolley], coordinates=[None, 0])
model.create_sensor(trolley, "position")  # its trace is drawn

frequency = g * np.sqrt(mass / (length * tension))  # rad/s
period = 2 * np.pi / frequency
model.solve_static(load_steps=5, update_initial_values=True)  # held by its brake
brake.active_connector = False
settings = db.SimulationSettings()
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.5
solution = model.solve(end_time=period, step_size=period / 1500, every=period / 300, settings=settings)

time, (x, y, _) = solution.times, solution[trolley].position.T
passing = np.flatnonzero((x[:-1] < length / 2) & (x[1:] >= length / 2))[0]
quarter = np.interp(length / 2, x[passing : passing + 2], time[passing : passing + 2])
print(f"it passes the middle after: {quarter:.3f} s, a quarter of the period {period / 4:.3f} s")
print(
    f"sag in the middle: {-np.interp(quarter, time, y):.4f} m, of a tight rope {mass * g * length / 4 / tension:.4f} m"
)
plt.plot(x, y)
plt.gca().set(xlabel="way of the trolley (m)", ylabel="height (m)")
plt.savefig("trolley_way.png")
shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = shown.connectors.show = shown.loads.show = False
shown.sensors.traces.showPositionTrace = True
model.draw(file_name="trolley_picture.png")
solution.animate(file_name="trolley_motion.gif", window_size=[420, 320], frames_per_second=20, speed=period / 3)
