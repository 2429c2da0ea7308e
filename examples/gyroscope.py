"""A gyroscope: a spinning steel disc on a shaft whose foot rests in a ball joint, released in two ways.

The axis keeps its inclination for a certain rate of precession, a root of a quadratic equation. If it is released with
its axis at rest, the gyroscope nutates while it precesses; conservation of energy and of two angular momenta gives the
amplitude.
"""

import numpy as np

import dalembert as exu
from dalembert.utilities import *

radius, width, arm, spin = 0.1, 0.02, 0.15, 2 * np.pi * 25  # m, m, m from foot to disc, rad/s about the axis
tilt, g = np.radians(60), 9.81  # of the axis, from the vertical
disc = InertiaCylinder(density=7800, length=width, outerRadius=radius, axis=2)
axial = disc.inertiaTensor[2, 2]
across = disc.inertiaTensor[0, 0] + disc.mass * arm**2  # about the foot
weight = disc.mass * g * arm

# steady precession at rate w: across cos(tilt) w^2 - axial spin w + weight = 0, the slow root
precession = min(np.roots([across * np.cos(tilt), -axial * spin, weight]))
# let go at rest, it turns round where the cosine u of its inclination fulfils 1 - u^2 = 2 k (cos(tilt) - u)
k = (axial * spin) ** 2 / (4 * weight * across)
lowest = k - np.sqrt(k**2 - 2 * k * np.cos(tilt) + 1)

mbs = exu.SystemContainer().AddSystem()
feet = np.array([[0, 0, 0], [0, 0.4, 0]])  # m, side by side
stands = [graphics.Cylinder(foot - [0, 0, 0.12], [0, 0, 0.12], 0.008, color=graphics.color.grey) for foot in feet]
ground = mbs.CreateGround(graphicsDataList=stands)
turn = RotationMatrixY(tilt)
axis = turn @ [0, 0, 1]


def gyroscope(foot, rate, color):
    """The disc on its shaft, with spin and rate of precession about the vertical; returns a sensor of its place."""
    omega = (spin - rate * np.cos(tilt)) * axis + np.array([0, 0, rate])
    body = mbs.CreateRigidBody(
        referencePosition=foot + arm * axis,
        referenceRotationMatrix=turn,
        initialVelocity=np.cross(omega, arm * axis),
        initialAngularVelocity=omega,
        inertia=disc,
        gravity=[0, 0, -g],
        graphicsDataList=[
            graphics.Cylinder([0, 0, -width / 2], [0, 0, width], radius, color=color, nTiles=64),
            graphics.Cylinder([0, 0, -arm], [0, 0, 1.3 * arm], 0.006, color=graphics.color.lightgrey, nTiles=24),
        ],
    )
    mbs.CreateSphericalJoint(bodyNumbers=[ground, body], position=foot)
    return mbs.AddSensor(
        SensorBody(bodyNumber=body, outputVariableType=exu.OutputVariableType.Position, storeInternal=True)
    )


steady = gyroscope(feet[0], precession, graphics.color.dodgerblue)
nodding = gyroscope(feet[1], 0, graphics.color.orange)
mbs.Assemble()

settings = exu.SimulationSettings()
settings.timeIntegration.endTime = 2
settings.timeIntegration.numberOfSteps = 8000
settings.solutionSettings.sensorsWritePeriod = 1e-3
settings.solutionSettings.solutionWritePeriod = settings.timeIntegration.endTime / 60
mbs.SolveDynamic(settings)

mbs.Draw(fileName="gyroscope_picture.png")
in_a_second = settings.timeIntegration.endTime / 3
mbs.DrawSolution(fileName="gyroscope_motion.gif", windowSize=[420, 320], framesPerSecond=20, speed=in_a_second)
mbs.PlotSensor(
    [steady, nodding], components=[2, 2], labels=["steady", "let go at rest"], yLabel="height of the disc (m)",
    fileName="gyroscope_height.png", closeAll=True,
)  # fmt: skip
mbs.PlotSensor(
    [steady, nodding], componentsX=[0, 0], components=[1, 1], offsets=list(-feet[:, 1]), xLabel="x (m)",
    yLabel="y from the foot (m)", labels=["steady", "let go at rest"], fileName="gyroscope_path.png",
)  # fmt: skip

t, x, y, z = mbs.GetSensorStoredData(steady).T
azimuth = np.unwrap(np.arctan2(y, x))
print(f"rate of precession: {(azimuth[-1] - azimuth[0]) / t[-1]:.5f} rad/s, closed form {precession:.5f} rad/s")
print(f"height in steady precession: {z[-1]:.6f} m, closed form {arm * np.cos(tilt):.6f} m")
height = mbs.GetSensorStoredData(nodding)[:, 3]
print(f"lowest point of nodding: {height.min():.6f} m, closed form {arm * lowest:.6f} m")
