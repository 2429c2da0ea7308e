"""A ship lays a cable: a catenary between the sea bed and the stern, which heaves in the waves.

The cable starts on the bottom, with one end fixed; the other end is lifted to the surface and moved back to its final
position. The free part is a catenary: the tension at the stern is that at the bottom plus the weight of a cable whose
length is the depth of the sea. Then the ship heaves, and the touchdown point oscillates.
"""

import matplotlib.pyplot as plt
import numpy as np

import dalembert as db
from dalembert.beams import GenerateStraightLineANCFCable2D

length, elements, depth = 300.0, 60, 100.0  # m
weight, mass = 50.0, 8.0  # N/m under water, kg/m with the water that moves along
bending, stretching = 2e3, 2e7  # Nm^2, N
slack, heave, period = 33.0, 1.5, 8.0  # m, m, s
ground_stiffness, ground_damping = 2e3, 1e3  # N/m, Ns/m per node

model = db.Model()
water = db.graphics.Brick([150, depth, -2], [360, 0.4, 1], color=db.graphics.color.dodgerblue)
bed = db.graphics.Brick([150, -2, -2], [360, 4, 1], color=db.graphics.color.brown)
model.create_ground(graphics_data_list=[water, bed])
cable = db.Cable2D(
    physicsMassPerLength=mass,
    physicsBendingStiffness=bending,
    physicsAxialStiffness=stretching,
    physicsAxialDamping=1e5,
    physicsBendingDamping=200,
    visualization=db.VCable2D(drawHeight=1.0),
)
g = weight / mass  # gravity minus buoyancy in water
nodes, cables, *_ = GenerateStraightLineANCFCable2D(
    model.system,
    [0, 0, 0],
    [length, 0, 0],
    elements,
    cable,
    massProportionalLoad=[0, -g, 0],
    fixedConstraintsNode0=[1, 1, 0, 0],
)

fixed = model.add(db.MarkerNodeCoordinate(nodeNumber=model.add(db.NodePointGround()), coordinate=0))
for node in nodes[1:]:
    height = model.add(db.MarkerNodeCoordinate(nodeNumber=node, coordinate=1))
    gap = model.add(db.NodeGenericData(numberOfDataCoordinates=1, initialCoordinates=[0]))
    model.add(
        db.ObjectContactCoordinate(
            markerNumbers=[fixed, height], nodeNumber=gap, contactStiffness=ground_stiffness,
            contactDamping=ground_damping,
        )
    )  # fmt: skip

heaves = False


def stern(coordinate):
    """Motion of the end of the cable: first to its position, then up and down with the waves."""
    place = -slack if coordinate == 0 else depth

    def offset(mbs, t, item, value):
        if not heaves:
            return place * (t * t if coordinate == 0 else t)
        return place + (heave * np.sin(2 * np.pi * t / period) * min(1.0, t / period) if coordinate == 1 else 0.0)

    return offset


held = [model.add(db.MarkerNodeCoordinate(nodeNumber=nodes[-1], coordinate=k)) for k in range(2)]
for name, coordinate in (("horizontal", 0), ("vertical", 1)):
    markers = [fixed, held[coordinate]]
    model.add(db.CoordinateConstraint(name=name, markerNumbers=markers, offsetUserFunction=stern(coordinate)))

laid = model.solve_static(load_steps=100, update_initial_values=True)
horizontal, vertical = abs(model["horizontal"].force), abs(model["vertical"].force)
pull, bottom = np.hypot(horizontal, vertical), horizontal
hanging = np.sqrt(depth**2 + 2 * depth * bottom / weight)
touches = next(i for i, node in enumerate(nodes) if laid[node].position[-1, 1] > 0)  # the first that does not touch
print(f"pull at the stern: {pull / 1e3:.4f} kN, catenary {(bottom + weight * depth) / 1e3:.4f} kN")
print(f"weight that the stern carries: {vertical / 1e3:.4f} kN, catenary {weight * hanging / 1e3:.4f} kN")
print(f"the cable touches the ground about {touches * length / elements:.0f} m from its begin")

heaves = True
settings = db.SimulationSettings()
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.6
pulls = [model.create_sensor(name, "force") for name in ("horizontal", "vertical")]
solution = model.solve(end_time=40, step_size=0.02, every=0.1, settings=settings)
times, history = pulls[0].time, np.hypot(*(sensor.values for sensor in pulls)) / 1e3
swell = history[times > 2 * period]
print(f"pull while the ship heaves by {heave} m: {swell.min():.2f} to {swell.max():.2f} kN")
plt.plot(times, history)
plt.gca().set(xlabel="time (s)", ylabel="pull at the stern (kN)")
plt.savefig("cable_pull.png")
shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = shown.loads.show = shown.connectors.show = shown.sensors.show = False
shown.contour.outputVariable = db.OutputVariableType.ForceLocal  # tension, as color
model.draw(file_name="cable_laying_picture.png")
