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
from dalembert.robotics._mjcf_elements import Content
from dalembert.robotics._parts import RobotKeyframe
from dalembert.robotics._robot import Robot
from dalembert.robotics._xml import Element

_POSITIONS = {"revolute": 1, "prismatic": 1, "ball": 4, "floating": 7}
_RATES = {"revolute": 1, "prismatic": 1, "ball": 3, "floating": 6}


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
        self.joints = [joint for joint in content.joints if joint.kind in _POSITIONS]
        self.actuators = actuators
        self.elements = [element for element in content.elements_of("keyframe") if element.tag == "key"]
        if any("act" in element.attributes for element in self.elements) and actuators.unknown_activations:
            content.notes.add("act of keyframes with actuators", ", ".join(actuators.unknown_activations))

    def complete(self, robot: Robot) -> None:
        """Add the keyframes."""
        for i, element in enumerate(self.elements):
            name = element.text("name", f"key {i}")
            q, q_t = self._coordinates(element, robot.referenceConfiguration)
            known = self.actuators
            controls = _by_name(element, "ctrl", known.names)
            activations = {} if known.unknown_activations else _by_name(element, "act", known.with_activation)
            controls, activations = (
                {key: value for key, value in values.items() if key in robot.actuators}
                for values in (controls, activations)
            )
            time = element.number("time", "0")
            robot.keyframes[name] = RobotKeyframe(name, q, q_t, controls, activations, time)

    def _coordinates(self, element: Element, reference: FloatArray) -> tuple[FloatArray, FloatArray]:
        counts = np.array([(_POSITIONS[joint.kind], _RATES[joint.kind]) for joint in self.joints]).reshape(-1, 2)
        sizes, ends = counts.sum(axis=0), np.cumsum(counts, axis=0)
        rest = " ".join(repr(float(each)) for joint in self.joints for each in _rest(joint))
        qpos = element.numbers("qpos", int(sizes[0]), rest)
        qvel = element.numbers("qvel", int(sizes[1]), " ".join("0" * int(sizes[1])))
        parts = zip(self.joints, np.split(qpos, ends[:-1, 0]), np.split(qvel, ends[:-1, 1]), strict=True)
        states = [_state(*part) for part in parts]
        q, q_t = (np.concatenate([state[k] for state in states]) for k in (0, 1))
        return (q if "qpos" in element.attributes else reference.copy()), q_t


def _rest(joint: Joint) -> FloatArray:
    """Return the position of a joint at its reference."""
    if joint.kind == "ball":
        return np.array([1.0, 0, 0, 0])
    if joint.kind == "floating":
        return np.concatenate([joint.T[:3, 3], RotationMatrix2EulerParameters(joint.T[:3, :3])])
    return np.full(1, joint.reference)


def _by_name(element: Element, attribute: str, names: list[str]) -> dict[str, float]:
    """Return numbers by the names of what they belong to; none if they are not given."""
    if attribute not in element.attributes:
        return {}
    return dict(zip(names, element.numbers(attribute, len(names)).tolist(), strict=True))
