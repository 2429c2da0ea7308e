"""An arm with six axes carries a load from one pose to another, under computed torque.

The arm is read from a URDF file. Inverse kinematics finds its joints for two poses of the gripper, a trajectory leads
from one to the other within limits of velocity and acceleration. Every 2 ms, inverse dynamics computes the torques of
this motion, with a feedback of the errors; for comparison, drives with gravity compensation only follow the same
trajectory with the same gains. The arm finally rests, so the work of its drives is the change of potential energy plus
the dissipation in its bearings.
"""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import dalembert as db
from dalembert.robotics import InverseKinematicsNumerical
from dalembert.robotics.motion import ProfilePTP, Trajectory
from dalembert.robotics.utilities import ReadRobot
from dalembert.utilities import HTrotateY, HTtranslate

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
    """Return torques of the motion, such that errors decay like a damped oscillator."""
    s, v, a = wanted
    return arm.InverseDynamics(q, q_t, a + damping * (v - q_t) + stiffness * (s - q))


inertias = np.diag(arm.MassMatrix(start))


def drives_alone(q, q_t, wanted):
    """Return the same correction for each drive by itself, with the weight that it carries."""
    s, v, _ = wanted
    return inertias * (damping * (v - q_t) + stiffness * (s - q)) - arm.StaticTorques(arm.JointHT(q))


# model
def follow(law):
    """Run the motion; return times, errors (mrad), torques, work without losses, last state, model and solution."""
    model = db.Model()
    model.create_ground("floor", graphics_data_list=[db.graphics.CheckerBoard(size=1.2, nTiles=6)])
    made = model.create_robot(file, reference_configuration=start)
    tree, rows = made["objectKinematicTree"], []

    def control(mbs, t):
        q = np.array(mbs.systemData.GetODE2Coordinates()) + start
        q_t = np.array(mbs.systemData.GetODE2Coordinates_t())
        wanted = trajectory.Evaluate(t)
        torques = law(q, q_t, wanted)
        mbs.SetObjectParameter(tree, "jointForceVector", torques)
        rows.append([t, *(wanted[0] - q), *q, *q_t, *torques])
        return True

    model.system.SetPreStepUserFunction(control)
    solution = model.solve(end_time=duration, step_size=sample, method="rk44")
    last = np.array(model.system.systemData.GetODE2Coordinates()) + start
    t, errors, q, q_t, torques = np.split(np.array(rows), [1, 7, 13, 19], axis=1)
    work = (torques * np.diff([*q, last], axis=0)).sum()
    taken = np.trapezoid((q_t * arm.JointResistance(q_t)).sum(axis=1), t[:, 0])
    return t[:, 0], 1e3 * errors, torques, work - taken, last, model, solution


times, errors, torques, gained, last, model, solution = follow(computed_torque)
_, others, *_ = follow(drives_alone)
for name, values, quantity, title in (
    ("torques", torques, "torque (Nm)", ""),
    ("computed_torque", errors, "error (mrad)", "computed torque"),
    ("drives_alone", others, "error (mrad)", "drives alone"),
):
    figure, axes = plt.subplots(figsize=[9, 4.8], layout="tight")
    axes.plot(times, values, label=names)
    axes.set(xlabel="time (s)", ylabel=quantity, title=title)
    axes.legend(loc="center left", bbox_to_anchor=(1, 0.5))
    figure.savefig(f"arm_{name}.png")

largest, larger = (np.abs(rows).max() for rows in (errors, others))
print(f"Largest error under computed torque {largest:.2f} mrad, of drives alone {larger:.1f} mrad.")
reached = arm.FrameHT("gripper", last)
for name, is_at, should in zip("xyz", reached[:3, 3], high[:3, 3], strict=True):
    print(f"gripper at the end, {name}: {is_at:.6f} m, wanted pose {should:.6f} m")
height = arm.PotentialEnergy(end) - arm.PotentialEnergy(start)
print(f"work of the drives, less that of bearings: {gained:.3f} J, gain of height {height:.3f} J")
model.draw(file_name="arm_picture.png")
solution.animate("arm_motion.gif", window_size=[420, 320], frames_per_second=20, speed=duration / 4)
