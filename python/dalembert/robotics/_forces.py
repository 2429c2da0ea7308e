"""Forces in the joints of robots as functions of states: springs, supported masses, tendons, cables and actuators."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dalembert._checks import FloatArray
from dalembert.robotics._tendons import factors_of, place_of

if TYPE_CHECKING:
    from dalembert.robotics._actuators import RobotActuator
    from dalembert.robotics._robot import Robot


def passive(robot: Robot, q: FloatArray, q_t: FloatArray, weight: FloatArray) -> FloatArray:
    """Return the passive forces; weight is the force that supports a mass of 1 kg."""
    k, q0 = (np.array([getattr(link, what) for link in robot.links]) for what in ("stiffness", "springReference"))
    forces = -k * (q - q0) - robot.JointResistance(q_t)
    for tendon in robot.tendons.values():
        factors = tendon.Factors(robot)
        forces = forces - np.multiply.outer(tendon.Tension(q @ factors, q_t @ factors), factors)
    for cable in robot.cables.values():
        length, factors = cable.Kinematics(robot, q)
        tension = cable.Tension(length, np.sum(q_t * factors, axis=-1))
        forces = forces - np.asarray(tension)[..., None] * factors
    if any(link.supported for link in robot.links):
        forces = forces + _support(robot, q, weight)
    return np.asarray(forces)


def _support(robot: Robot, q: FloatArray, weight: FloatArray) -> FloatArray:
    """Return the forces in the joints that carry the weight of supported masses."""
    frames, total = robot.JointHT(q), np.zeros_like(q)
    for i, link in enumerate(robot.links):
        for mass, place in link.supported:
            T = np.asarray(frames[i] @ link.localHT)
            point = T[..., :3, 3] + T[..., :3, :3] @ place
            total += mass * (weight @ robot.Jacobian(frames, point, "trans", i))
    return total


def of_actuators(robot: Robot, controls: FloatArray, q: FloatArray, q_t: FloatArray) -> FloatArray:
    """Return the forces of the actuators; the first axis of controls counts them."""
    total = np.zeros(np.broadcast_shapes(q.shape, (*controls.shape[1:], len(robot.links))))
    for actuator, u in zip(robot.actuators.values(), controls, strict=True):
        if actuator.frame:
            total += np.asarray(actuator.Force(u, 0.0, 0.0))[..., None] * _wrench(robot, actuator, q)
            continue
        factors = actuator.gear * factors_of(robot, actuator.joint)
        total += np.multiply.outer(actuator.Force(u, q @ factors, q_t @ factors), factors)
    return total


def _wrench(robot: Robot, actuator: RobotActuator, q: FloatArray) -> FloatArray:
    """Return the forces in the joints of a thruster with a force of one."""
    link, T = place_of(robot, actuator.frame)
    if link < 0:
        return np.zeros_like(q)
    frames = robot.JointHT(q)
    place = np.asarray(frames[link] @ robot.links[link].localHT @ T)
    force, torque = (place[..., :3, :3] @ part for part in np.reshape(actuator.wrench, (2, 3)))
    J = robot.Jacobian(frames, place[..., :3, 3], "all", link)
    return np.einsum("...i,...ij->...j", np.concatenate([force, torque], axis=-1), J)
