"""Keyframes of MJCF files: states by name, in the coordinates of the joints."""

from __future__ import annotations

import numpy as np

from dalembert._checks import FloatArray
from dalembert._geometry.rotations import (
    EulerParameters2RotationMatrix,
    RotationMatrix2EulerParameters,
    RotationMatrix2RotXYZ,
    RotationMatrixX,
    RotationMatrixY,
)
from dalembert.robotics._description import Joint
from dalembert.robotics._mjcf_actuators import Actuators
from dalembert.robotics._mjcf_elements import POSITIONS, RATES, Content, numbers_of
from dalembert.robotics._parts import RobotKeyframe
from dalembert.robotics._robot import Robot
from dalembert.robotics._xml import Element


def _angles(quaternion: FloatArray, A0: FloatArray) -> FloatArray:
    """Return the angles about z, y and x, one after the other, that turn axes A0 to those of a quaternion."""
    length = np.linalg.norm(quaternion)
    A = A0.T @ EulerParameters2RotationMatrix(quaternion / length if length > 0 else np.array([1.0, 0, 0, 0]))
    return np.asarray(-RotationMatrix2RotXYZ(A.T)[::-1])


def _angle_rates(angles: FloatArray, omega: FloatArray) -> FloatArray:
    """Return the rates of angles about z, y and x for an angular velocity in the turned axes."""
    _, y, x = angles
    A = RotationMatrixX(x).T
    axes = np.column_stack([(A @ RotationMatrixY(y).T)[:, 2], A[:, 1], [1.0, 0, 0]])
    return np.linalg.solve(axes, omega)


def _state(joint: Joint, qpos: FloatArray, qvel: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return coordinates and rates of a joint."""
    if joint.kind == "ball":
        angles = _angles(qpos, np.eye(3))
        return angles, _angle_rates(angles, qvel)
    if joint.kind == "floating":
        A0 = joint.T[:3, :3]
        angles = _angles(qpos[3:], A0)
        q = np.concatenate([A0.T @ (qpos[:3] - joint.T[:3, 3]), angles])
        return q, np.concatenate([A0.T @ qvel[:3], _angle_rates(angles, qvel[3:])])
    return qpos, qvel


class Keyframes:
    """The keyframes of a file; complete() adds them to the robot. Missing positions are those of the reference."""

    def __init__(self, content: Content, actuators: Actuators) -> None:
        self.joints = [joint for joint in content.joints if joint.kind in POSITIONS]
        self.actuators, self.compiler = actuators, content.compiler
        self.elements = [element for element in content.elements_of("keyframe") if element.tag == "key"]
        if any("act" in element.attributes for element in self.elements) and actuators.unknown_activations:
            content.notes.add("act of keyframes with actuators", ", ".join(actuators.unknown_activations))

    def complete(self, robot: Robot) -> None:
        """Add the keyframes."""
        for i, element in enumerate(self.elements):
            name = element.text("name", f"key {i}")
            q, q_t = self._coordinates(element, robot.referenceConfiguration)
            known = self.actuators
            controls = self._by_name(element, "ctrl", list(known.models))
            activations = {} if known.unknown_activations else self._by_name(element, "act", known.with_activation)
            controls, activations = (
                {key: value for key, value in values.items() if key in robot.actuators}
                for values in (controls, activations)
            )
            time = element.number("time", "0")
            robot.keyframes[name] = RobotKeyframe(name, q, q_t, controls, activations, time)

    def _coordinates(self, element: Element, reference: FloatArray) -> tuple[FloatArray, FloatArray]:
        rates = [np.zeros(RATES[joint.kind]) for joint in self.joints]
        q_parts = self._of_joints(element, "qpos", POSITIONS, [_rest(joint) for joint in self.joints])
        v_parts = self._of_joints(element, "qvel", RATES, rates)
        states = [_state(*part) for part in zip(self.joints, q_parts, v_parts, strict=True)]
        q, q_t = (np.concatenate([state[k] for state in states]) for k in (0, 1))
        return (q if "qpos" in element.attributes else reference.copy()), q_t

    def _of_joints(
        self, element: Element, attribute: str, counts: dict[str, int], rest: list[FloatArray]
    ) -> list[FloatArray]:
        """Return the numbers of each joint, or those in rest for joints without any."""
        if attribute not in element.attributes:
            return rest
        sizes, models = [counts[joint.kind] for joint in self.joints], [joint.where.model for joint in self.joints]
        parts = numbers_of(element, attribute, sizes, models, self.compiler)
        return [own if part is None else part for part, own in zip(parts, rest, strict=True)]

    def _by_name(self, element: Element, attribute: str, names: list[str]) -> dict[str, float]:
        """Return numbers by the names of actuators; none if they are not given."""
        if attribute not in element.attributes:
            return {}
        models = [self.actuators.models[name] for name in names]
        parts = numbers_of(element, attribute, [1] * len(names), models, self.compiler)
        return {name: float(part[0]) for name, part in zip(names, parts, strict=True) if part is not None}


def _rest(joint: Joint) -> FloatArray:
    """Return the position of a joint at its reference."""
    if joint.kind == "ball":
        return np.array([1.0, 0, 0, 0])
    if joint.kind == "floating":
        return np.concatenate([joint.T[:3, 3], RotationMatrix2EulerParameters(joint.T[:3, :3])])
    return np.full(1, joint.reference)
