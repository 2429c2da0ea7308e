"""A Scotch yoke: a crank that turns evenly moves a sliding yoke as a cosine, without any connecting rod.

The pin of the crank carries a block, which slides up and down in the slot of the yoke; the yoke slides along x. A
coordinate constraint drives the angle between ground and crank. Forces are those of m r w^2 cos(w t) of the yoke; the
motor gives and takes its work.
"""

import numpy as np

import dalembert as db
from dalembert.utilities import InertiaCuboid

radius, speed, mass = 0.1, 20.0, 3.0  # m, rad/s, kg of the yoke
end = 2 * np.pi / speed

model = db.Model()
small = InertiaCuboid(7800, [0.02, 0.02, 0.01])
shape_of_yoke = [
    db.graphics.Brick([x, 0, -0.02], [0.02, 0.3, 0.01], color=db.graphics.color.steelblue) for x in (-0.02, 0.02)
] + [db.graphics.Brick([0.15, 0, -0.02], [0.24, 0.02, 0.01], color=db.graphics.color.steelblue)]
crank = model.create_rigid_body(
    "crank",
    reference_position=[0, 0, 0],
    initial_angular_velocity=[0, 0, speed],
    inertia=InertiaCuboid(7800, [0.2, 0.02, 0.01]),
    create_2d=True,
    graphics_data_list=[
        db.graphics.Brick([0.5 * radius, 0, 0], [radius + 0.02, 0.03, 0.01], color=db.graphics.color.orange)
    ],
)
block = model.create_rigid_body(
    "block", reference_position=[radius, 0, 0], initial_velocity=[0, radius * speed, 0], inertia=small, create_2d=True,
    graphics_data_list=[db.graphics.Brick(size=[0.02, 0.03, 0.03], color=db.graphics.color.grey)],
)  # fmt: skip
yoke = model.create_rigid_body(
    "yoke", reference_position=[radius, 0, 0], inertia=InertiaCuboid(mass / 6e-4, [0.2, 0.3, 0.01]), create_2d=True,
    graphics_data_list=shape_of_yoke,
)  # fmt: skip


def at(body, place=(0, 0, 0)):
    return model.add(db.MarkerBodyRigid(bodyNumber=body, localPosition=place))


model.add(db.RevoluteJoint2D(markerNumbers=[at("ground"), at("crank")]))
model.add(db.RevoluteJoint2D(markerNumbers=[at("crank", [radius, 0, 0]), at("block")]))
slot = db.PrismaticJoint2D(
    "slot", markerNumbers=[at("yoke"), at("block")], axisMarker0=[0, 1, 0], normalMarker1=[1, 0, 0]
)
guide = db.PrismaticJoint2D(
    "guide", markerNumbers=[at("ground"), at("yoke")], axisMarker0=[1, 0, 0], normalMarker1=[0, 1, 0]
)
model.add(slot)
model.add(guide)

turns = model.add(db.NodeGenericData(numberOfDataCoordinates=1, initialCoordinates=[0]))  # counts them
angle = model.add(
    db.MarkerBodiesRelativeRotationCoordinate(bodyNumbers=["ground", "crank"], nodeNumber=turns, axis0=[0, 0, 1])
)
slide = model.add(db.MarkerBodiesRelativeTranslationCoordinate(bodyNumbers=["ground", "yoke"], axis0=[1, 0, 0]))
fixed = model.add(db.MarkerNodeCoordinate(nodeNumber=model.add(db.NodePointGround()), coordinate=0))
motor = model.add(
    db.CoordinateConstraint(
        "motor", markerNumbers=[fixed, angle], offset=0, offsetUserFunction=lambda mbs, t, item, offset: speed * t
    )
)
way, torque = model.create_sensor(slide, "coordinates", name="way"), model.create_sensor(motor, "force")
solution = model.solve(end_time=end, step_size=end / 2000, every=end / 200)

print(f"way of the yoke: {np.ptp(way.values):.6f} m, two radii {2 * radius:.6f} m")
print(
    f"largest torque: {np.abs(torque.values).max():.4f} Nm, that of a cosine {0.5 * mass * radius**2 * speed**2:.4f} Nm"
)
solution.plot("way", file_name="yoke_way.png")
shown = model.container.visualizationSettings
shown.nodes.show = shown.markers.show = shown.sensors.show = shown.connectors.show = False
model.draw(file_name="yoke_picture.png", view="axonometric")
solution.animate(
    file_name="yoke_motion.gif", window_size=[420, 320], frames_per_second=20, speed=end / 3, view="axonometric"
)
