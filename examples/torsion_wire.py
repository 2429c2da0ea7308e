"""Two discs on one wire: torsional vibration moves between them, like that of coupled pendulums.

The wire is clamped at both ends; its parts are springs between the rotations of the discs, which are coordinates of
markers.
The discs turn in phase with w1 = sqrt(k / J), in opposite phase with w2 = sqrt((k + 2 c) / J), where k is the
stiffness of the outer parts and c that of the part between the discs. If one disc is rotated and released, the motion
is the sum of both modes.
"""

import numpy as np

import dalembert as exu
from dalembert.utilities import *

radius, width, mass = 0.1, 0.02, 2.0  # m, m, kg
outer, inner = 0.4, 0.05  # Nm/rad
start = 1.0  # rad
J = 0.5 * mass * radius**2
frequencies = np.sqrt([outer / J, (outer + 2 * inner) / J])
beat = 2 * np.pi / (frequencies[1] - frequencies[0])  # s

mbs = exu.SystemContainer().AddSystem()
wire = graphics.Cylinder([0, 0, -0.3], [0, 0, 0.9], 0.003, graphics.color.grey)
walls = [graphics.Brick([0, 0, z], [0.1, 0.1, 0.01], graphics.color.grey) for z in (-0.3, 0.6)]
ground = mbs.CreateGround("ground", graphicsDataList=[wire, *walls])
inertia = InertiaCylinder(mass / (np.pi * radius**2 * width), width, radius, axis=2)
line = graphics.Brick([0.5 * radius, 0, 0], [radius, 0.01, 1.1 * width], graphics.color.orange)
fixed = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
turns = [fixed]
for name, z, angle in (("first", 0, start), ("second", 0.3, 0)):
    shape = graphics.Cylinder([0, 0, -0.5 * width], [0, 0, width], radius, graphics.color.steelblue, nTiles=64)
    disc = mbs.CreateRigidBody(name, referencePosition=[0, 0, z], initialRotationMatrix=RotationMatrixZ(angle),
                               inertia=inertia, graphicsDataList=[shape, line])  # fmt: skip
    mbs.CreateRevoluteJoint(bodyNumbers=[ground, disc], position=[0, 0, z], axis=[0, 0, 1], show=False)
    turns.append(mbs.AddMarker(MarkerNodeRotationCoordinate(nodeNumber=disc.nodes[0], rotationCoordinate=2)))
    mbs.AddSensor(SensorMarker(name, markerNumber=turns[-1], storeInternal=True,
                               outputVariableType=exu.OutputVariableType.Coordinates))  # fmt: skip
turns.append(fixed)
for i, stiffness in enumerate((outer, inner, outer)):
    mbs.AddObject(CoordinateSpringDamper(markerNumbers=turns[i : i + 2], stiffness=stiffness))
mbs.Assemble()

settings = exu.SimulationSettings()
settings.timeIntegration.endTime = beat
settings.timeIntegration.numberOfSteps = 4000
settings.solutionSettings.writeSolutionToFile = False
settings.solutionSettings.sensorsWritePeriod = beat / 1000
mbs.SolveDynamic(settings)

time, first = mbs.GetSensorStoredData("first").T
second = mbs.GetSensorStoredData("second")[:, 1]
together, against = 0.5 * start * np.cos(np.outer(frequencies, time))
print(f"a beat lasts {beat:.4f} s")
for name, turn, theory in (("first", first, together + against), ("second", second, together - against)):
    middle = np.argmax(np.abs(theory[len(time) // 3 :])) + len(time) // 3  # of the beat
    print(f"largest turn of the {name} disc, later: {turn[middle]:.4f} rad, theory {theory[middle]:.4f} rad")
mbs.PlotSensor(["first", "second"], yLabel="turn (rad)", labels=["first disc", "second disc"],
               fileName="torsion_turns.png", closeAll=True)  # fmt: skip
shown = mbs.GetSystemContainer().visualizationSettings
shown.nodes.show = shown.markers.show = shown.sensors.show = shown.connectors.show = False
mbs.Draw(fileName="torsion_picture.png", view="axonometric")
