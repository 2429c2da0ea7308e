"""An arm with six axes carries a load from one pose to another, under computed torque.

The arm is read from a URDF file. Inverse kinematics finds its joints for two poses of the gripper, a trajectory leads
from one to the other within limits of velocity and acceleration. Every 2 ms, inverse dynamics computes the torques of
this motion, with a feedback of the errors; for comparison, drives with
gravity compensation only follow the same trajectory with the same gains. The arm finally rests, so the work of its
drives
is the change of potential energy plus the dissipation in its bearings.
"""

from pathlib import Path

import numpy as np

import dalembert as exu
from dalembert.robotics import InverseKinematicsNumerical
from dalembert.robotics.motion import ProfilePTP, Trajectory
from dalembert.robotics.utilities import ReadRobot
from dalembert.utilities import *

file = Path(__file__).parent / "six_axis_arm.urdf"
sample, duration = 0.002, 1.6  # s
stiffness, damping = 400, 40  # feedback gains: two poles at 20 rad/s
arm = ReadRobot(file)
names = [link.jointName for link in arm.links]

# trajectory
inverse = InverseKinematicsNumerical(arm, link="gripper", limits=True)
low = HTtranslate([0.45, -0.35, 0.25]) @ HTrotateY(np.pi)  # the gripper points down
high = HTtranslate([0.3, 0.4, 0.75]) @ HTrotateY(np.pi / 2)
start, found = inverse.SolveSafe(low, q0=[-0.6, 0.5, 1.2, 0, 1.2, 0])
end, found_too = inverse.SolveSafe(high, q0=start)
assert found and found_too
trajectory = Trajectory(start, maxVelocities=[link.maxVelocity for link in arm.links], maxAccelerations=[8] * 6)
trajectory.Add(ProfilePTP(end))


def computed_torque(q, q_t, wanted):
    """Torques of the motion, such that errors decay like a damped oscillator."""
    s, v, a = wanted
    return arm.InverseDynamics(q, q_t, a + damping * (v - q_t) + stiffness * (s - q))


inertias = np.diag(arm.MassMatrix(start))


def drives_alone(q, q_t, wanted):
    """The same correction for each drive by itself, with the weight that it carries."""
    s, v, _ = wanted
    return inertias * (damping * (v - q_t) + stiffness * (s - q)) - arm.StaticTorques(arm.JointHT(q))


# model
def follow(law):
    """Run the motion; return errors (mrad), torques, the work that is not lost, where the arm ends, and the system."""
    mbs = exu.SystemContainer().AddSystem()
    mbs.CreateGround(graphicsDataList=[exu.graphics.CheckerBoard(size=1.2, nTiles=6)])
    made = mbs.CreateRobot(file, referenceConfiguration=start)
    tree, rows = made["objectKinematicTree"], []

    def control(mbs, t):
        q = np.array(mbs.systemData.GetODE2Coordinates()) + start
        q_t = np.array(mbs.systemData.GetODE2Coordinates_t())
        wanted = trajectory.Evaluate(t)
        torques = law(q, q_t, wanted)
        mbs.SetObjectParameter(tree, "jointForceVector", torques)
        rows.append([t, *(wanted[0] - q), *q, *q_t, *torques])
        return True

    mbs.SetPreStepUserFunction(control)
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime = duration
    settings.timeIntegration.numberOfSteps = round(duration / sample)
    settings.solutionSettings.coordinatesSolutionFileName = f"{law.__name__}.txt"
    mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.RK44)
    last = np.array(mbs.systemData.GetODE2Coordinates()) + start
    t, errors, q, q_t, torques = np.split(np.array(rows), [1, 7, 13, 19], axis=1)
    work = (torques * np.diff([*q, last], axis=0)).sum()
    taken = np.trapezoid((q_t * arm.JointResistance(q_t)).sum(axis=1), t[:, 0])
    return np.hstack([t, 1e3 * errors]), np.hstack([t, torques]), work - taken, last, mbs


errors, torques, gained, last, moved = follow(computed_torque)
others, *_ = follow(drives_alone)
mbs = exu.SystemContainer().AddSystem()
beside = {"loc": "center left", "bbox_to_anchor": (1, 0.5)}
common = {
    "components": list(range(6)),
    "labels": names,
    "newFigure": True,
    "legendArgs": beside,
    "sizeInches": [9, 4.8],
}
mbs.PlotSensor([torques] * 6, **common, yLabel="torque (Nm)", fileName="arm_torques.png", closeAll=True)
mbs.PlotSensor(
    [errors] * 6, **common, yLabel="error (mrad)", title="computed torque", fileName="arm_computed_torque.png"
)
mbs.PlotSensor([others] * 6, **common, yLabel="error (mrad)", title="drives alone", fileName="arm_drives_alone.png")

largest, larger = (np.abs(rows[:, 1:]).max() for rows in (errors, others))
print(f"Largest error under computed torque {largest:.2f} mrad, of drives alone {larger:.1f} mrad.")
reached = arm.FrameHT("gripper", last)
for name, is_at, should in zip("xyz", reached[:3, 3], high[:3, 3], strict=True):
    print(f"gripper at the end, {name}: {is_at:.6f} m, wanted pose {should:.6f} m")
height = arm.PotentialEnergy(end) - arm.PotentialEnergy(start)
print(f"work of the drives, less that of bearings: {gained:.3f} J, gain of height {height:.3f} J")
moved.Draw(fileName="arm_picture.png")
moved.DrawSolution(fileName="arm_motion.gif", windowSize=[420, 320], framesPerSecond=20, speed=duration / 4)
