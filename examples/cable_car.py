"""A cabin is clipped to a hauling rope, which runs at a constant speed over its span and carries it along.

The rope consists of cable elements through which the material moves; one coordinate is its displacement. The cabin
hangs on a joint that moves with the material. The sag of a rope with tension T in the middle of the span is F L / (4 T)
under the weight F of the cabin, and m g L^2 / (8 T) under its own weight.
"""

import numpy as np

import dalembert as db
from dalembert.utilities import GenerateStraightLineANCFCable2D, SmoothStep

span, tension, weight, g = 60.0, 40e3, 3000.0, 9.81  # m, N, N, m/s^2
mass, axial, elements = 0.8, 4e5, 20  # kg/m, N, 1
end = 10.0  # s

model = db.Model()
towers = [db.graphics.Brick([x, -3, 0], [0.8, 6, 0.8], color=db.graphics.color.grey) for x in (-0.4, span + 0.4)]
model.create_ground(graphics_data_list=towers)
haul = model.add(
    db.NodeGenericODE2(
        numberOfODE2Coordinates=1, referenceCoordinates=[0], initialCoordinates=[0], initialCoordinates_t=[0]
    )
)
rope = db.ALECable2D(
    physicsMassPerLength=mass,
    physicsBendingStiffness=20,
    physicsAxialStiffness=axial,
    physicsReferenceAxialStrain=-tension / axial,
    physicsAxialDamping=1e3,
    nodeNumbers=[-1, -1, haul],
    visualization=db.VALECable2D(drawHeight=0.2),
)
nodes, cables, *_ = GenerateStraightLineANCFCable2D(
    model.system, [0, 0, 0], [span, 0, 0], elements, rope, massProportionalLoad=[0, -g, 0],
    fixedConstraintsNode0=[1, 1, 0, 0], fixedConstraintsNode1=[1, 1, 0, 0],
)  # fmt: skip
fixed = model.add(db.MarkerNodeCoordinate(nodeNumber=model.add(db.NodePointGround()), coordinate=0))
hauled = model.add(db.MarkerNodeCoordinate(nodeNumber=haul, coordinate=0))
first = 1.5 * span / elements  # position of boarding
middle = 0.5 * span - first  # m, the way of the cabin


def drive(mbs, t, item, offset):
    """Return the way of the rope, which is driven to the middle of the span and waits there."""
    return SmoothStep(t, 0, end, 0, middle) if travels else 0.0


travels = False
model.add(db.CoordinateConstraint(markerNumbers=[fixed, hauled], offsetUserFunction=drive))
markers = [model.add(db.MarkerBodyCable2DCoordinates(bodyNumber=cable)) for cable in cables]
model.create_mass_point(
    "cabin", reference_position=[first, 0, 0], physics_mass=weight / g, gravity=[0, -g, 0], create_2d=True,
    graphics_data_list=[db.graphics.Brick([0, -1.2, 0], [1.6, 1.6, 1], color=db.graphics.color.orange)],
)  # fmt: skip
clip = model.add(db.MarkerBodyPosition(bodyNumber="cabin"))
element = model.add(db.NodeGenericData(numberOfDataCoordinates=1, initialCoordinates=[1]))
model.add(
    db.ALEMovingJoint2D(
        "clip", markerNumbers=[clip, markers[1]], slidingMarkerNumbers=markers, nodeNumbers=[element, haul],
        slidingMarkerOffsets=[span / elements * i for i in range(elements)], slidingOffset=first,
    )
)  # fmt: skip

model.solve_static(load_steps=5, update_initial_values=True)
travels = True
settings = db.SimulationSettings()
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.5
solution = model.solve(end_time=1.5 * end, step_size=end / 400, settings=settings)

place = solution["cabin"].position[-1]
pull = np.linalg.norm(solution[cables[0]].force_local[-1])
sag = weight * span / (4 * pull) + mass * g * span**2 / (8 * pull)
print(f"way of the cabin: {place[0] - first:.4f} m, of the rope {middle:.4f} m")
print(f"sag in the middle: {-place[1]:.4f} m, of a rope with this tension {sag:.4f} m")
solution.plot("cabin.position", file_name="car_way.png")
shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = shown.connectors.show = shown.loads.show = shown.sensors.show = False
model.draw(file_name="car_picture.png", view="front")
solution.animate(file_name="car_motion.gif", window_size=[420, 320], frames_per_second=20, speed=end / 2, view="front")
