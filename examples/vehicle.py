"""A car on four rolling discs: it accelerates with its rear wheels, then its front wheels steer it into a circle.

The discs have contact with friction, like rigid tyres. The thrust accelerates the car and its wheels and increases
the load
of the rear axle, in agreement with the balances of momentum and angular momentum, which neglect the small pitch. The
front wheels are steered so that all axles meet in one point, the centre
of the circle; at low slip the car follows it.
"""

import numpy as np

import dalembert as exu
from dalembert.utilities import *

base, track, height, radius = 2.6, 1.5, 0.55, 0.3  # m, height of the body's centre of mass, radius of the wheels
mass, wheel_mass, torque, circle, g = 1200, 20, 300, 40, 9.81  # kg, kg, Nm at each rear wheel, m, m/s^2
speed = 5.0  # m/s, at the beginning
total = mass + 4 * wheel_mass
stiffness = 2e5  # N/m, of a tyre
sinking = total * g / 4 / stiffness  # penetration of a disc

mbs = exu.SystemContainer().AddSystem()
road = graphics.CheckerBoard([30, 10, 0], size=140, nTiles=70, color=[0.82, 0.82, 0.82, 1])
ground = mbs.CreateGround(graphicsDataList=[road])
box = [3.6, 1.6, 1.2]
body = mbs.CreateRigidBody(
    referencePosition=[0, 0, height - sinking],
    initialVelocity=[speed, 0, 0],
    inertia=InertiaCuboid(density=mass / np.prod(box), sideLengths=box),
    gravity=[0, 0, -g],
    graphicsDataList=[
        graphics.Brick([0, 0, -0.12], [3.9, 1.3, 0.3], color=graphics.color.dodgerblue, roundness=0.25),
        graphics.Brick([-0.25, 0, 0.22], [2.0, 1.2, 0.5], color=[0.55, 0.75, 0.95, 1], roundness=0.5),
    ],
)
disc = InertiaCylinder(density=wheel_mass / (np.pi * radius**2 * 0.2), length=0.2, outerRadius=radius, axis=1)


def thrust(mbs, t, load):
    """Thrust from 0.5 s to 3.5 s, with a short ramp."""
    return np.interp(t, [0.4, 0.6, 3.4, 3.6], [0, 1, 1, 0]) * np.array(load)


def steering(side):
    """The angle of a front wheel, as a user function: from 4 s to 5 s it turns to the centre of the circle."""
    angle = np.arctan(base / (circle - side * track / 2))
    return lambda mbs, t, itemNumber, parameters: [0, 0, 0, 0, 0, angle * np.interp(t, [4, 5], [0, 1])]


joints, contacts = [], []
for x, side in ((base / 2, 1), (base / 2, -1), (-base / 2, 1), (-base / 2, -1)):
    hub = [x, side * track / 2, radius - sinking]
    wheel = mbs.CreateRigidBody(
        referencePosition=hub,
        initialVelocity=[speed, 0, 0],
        initialAngularVelocity=[0, speed / radius, 0],
        inertia=disc,
        gravity=[0, 0, -g],
        graphicsDataList=[graphics.Cylinder([0, -0.11, 0], [0, 0.22, 0], 0.6 * radius, color=graphics.color.lightgrey)],
    )
    free_about_y = {"position": hub, "constrainedAxes": [1, 1, 1, 1, 0, 1]}
    turn = {"offsetUserFunction": steering(side)} if x > 0 else {}
    joints.append(mbs.CreateGenericJoint(bodyNumbers=[body, wheel], **free_about_y, **turn))
    if x < 0:
        for turned, sign in ((wheel, 1), (body, -1)):
            at = mbs.AddMarker(MarkerBodyRigid(bodyNumber=turned))
            drive = [0, sign * torque, 0]
            mbs.AddLoad(Torque(markerNumber=at, loadVector=drive, bodyFixed=True, loadVectorUserFunction=thrust))
    contacts.append(
        mbs.CreateRollingDiscPenalty(
            bodyNumbers=[ground, wheel],
            axisPosition=[0, 0, 0],
            axisVector=[0, 1, 0],
            discRadius=radius,
            contactStiffness=stiffness,
            contactDamping=4e3,
            dryFriction=[0.9, 0.9],
            dryFrictionProportionalZone=0.05,
            discWidth=0.2,
            color=graphics.color.darkgrey,
        )
    )


def of_body(variable):
    """A sensor in the middle between the rear wheels."""
    return mbs.AddSensor(
        SensorBody(bodyNumber=body, localPosition=[-base / 2, 0, 0], outputVariableType=variable, storeInternal=True)
    )


Variable = exu.OutputVariableType
position, velocity, yaw = of_body(Variable.Position), of_body(Variable.VelocityLocal), of_body(Variable.AngularVelocity)
forces = [
    mbs.AddSensor(SensorObject(objectNumber=contact, outputVariableType=Variable.ForceLocal, storeInternal=True))
    for contact in contacts
]
mbs.Assemble()

settings = exu.SimulationSettings()
settings.timeIntegration.endTime = 10
settings.timeIntegration.numberOfSteps = 4000
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.6
settings.solutionSettings.sensorsWritePeriod = 1e-2
settings.solutionSettings.solutionWritePeriod = 0.05
mbs.SolveDynamic(settings)

SC = mbs.GetSystemContainer()
SC.visualizationSettings.loads.show = SC.visualizationSettings.markers.show = False
SC.visualizationSettings.sensors.traces.showPositionTrace = True
mbs.Draw(fileName="vehicle_picture.png", view="axonometric", around=body, zoom=0.35)
# camera follows the car
SC.visualizationSettings.view0.camera.trackMarker = mbs.GetObject(joints[0])["markerNumbers"][0]
in_a_second = settings.timeIntegration.endTime / 5
film = {"windowSize": [420, 320], "framesPerSecond": 20, "speed": in_a_second, "view": "axonometric", "zoom": 18}
mbs.DrawSolution(fileName="vehicle_motion.gif", **film)

mbs.PlotSensor(position, componentsX=[0], components=[1], xLabel="x (m)", yLabel="y (m)",
               fileName="vehicle_path.png", closeAll=True)  # fmt: skip
mbs.PlotSensor(forces, components=[2] * 4, labels=["front left", "front right", "rear left", "rear right"],
               yLabel="load of the wheel (N)", rangeY=[2000, 4000], fileName="vehicle_loads.png")  # fmt: skip

t, forward = mbs.GetSensorStoredData(velocity)[:, :2].T
spin = disc.inertiaTensor[1, 1] / radius
acceleration = 2 * torque / radius / (total + 4 * spin / radius)
one, two = np.searchsorted(t, [2, 3])
reached = (forward[two] - forward[one]) / (t[two] - t[one])
print(f"acceleration: {reached:.4f} m/s^2, balance of momentum {acceleration:.4f} m/s^2")
load = [mbs.GetSensorStoredData(force)[:, 1:] for force in forces]
transfer = (load[2] + load[3] - load[0] - load[1])[two, 2] / 2
moment = acceleration * (mass * height + 4 * wheel_mass * radius + 4 * spin)
print(f"load moved to the rear axle: {transfer:.1f} N, balance of angular momentum {moment / base:.1f} N")
turning = mbs.GetSensorStoredData(yaw)[-1, 3]
print(f"radius of the circle: {forward[-1] / turning:.3f} m, steered {circle:.3f} m")
lateral, inertia = (load[2] + load[3])[-1, 0], total * turning * forward[-1]
print(f"lateral force of the rear wheels: {lateral:.1f} N, half of m v^2 / r {inertia / 2:.1f} N")
