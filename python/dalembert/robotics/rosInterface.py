"""Publishers and subscribers of ROS 1, for models that talk to ROS while they are solved; needs the package rospy."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from dalembert._checks import FloatArray, shape_error
from dalembert._core import OutputVariableType
from dalembert.rigidBodyUtilities import RotationMatrix2EulerParameters, RotXYZ2RotationMatrix

_INTERVAL = 0.01  # s between two messages of a kind, in time of the simulation


def _ros() -> tuple[Any, Any, Any]:
    """Return rospy and its modules of messages for geometry and of standard messages."""
    try:
        import rospy
        from geometry_msgs import msg as geometry
        from std_msgs import msg as standard
    except ImportError as error:
        raise ImportError(f"ROSInterface: rospy and its messages are needed, which come with ROS 1 ({error})") from None
    return rospy, geometry, standard


class ROSInterface:
    """A node of ROS with publishers of time, texts, twists, poses, wrenches and states; derive from it for more.

    Topics are below /exudyn/. The last message of a subscriber is the attribute with the name of its topic. Publish
    functions may be called at every step; they send every 10 ms of the simulation. getData 'node' sends position and
    rotation of the node mbs.variables['nodeNumber'], 'sensor' those of sensors: pos and ori (RotXYZ),
    and velt and velr for velocities.
    """

    def __init__(self, name: str = "ExudynRobotInterface") -> None:
        self._rospy, self._geometry, self._standard = _ros()
        self.CheckROSversion()
        self._rospy.init_node(name, anonymous=True)
        self.topicBase = "/exudyn/"
        self.t0 = self._rospy.get_time()
        self.rosPoseSendInterval = self.rosTwistSendInterval = self.systemStateUpdateInterval = _INTERVAL
        self.lastPoseSendTime = self.lastTwistSendTime = self.lastSystemStateUpdateTime = -_INTERVAL
        self.lastStepTime = 0.0
        geometry, standard = self._geometry, self._standard
        self.exuTimePublisher = self.InitPublisher("SimiulationTime", standard.Time)
        self.exuStringPublisher = self.InitPublisher("SimpleString", standard.String)
        self.exuTwistPublisher = self.InitPublisher("Twist", geometry.Twist)
        self.exuPosePublisher = self.InitPublisher("Pose", geometry.PoseStamped)
        self.exuWrenchPublisher = self.InitPublisher("Wrensh", geometry.WrenchStamped)
        self.exuSystemstatePublisher = self.InitPublisher("Systemstate", standard.Float64MultiArray, 1)

    def InitPublisher(self, pubTopicName: str = "", pubType: Any = None, queueSize: int = 10) -> Any:
        """Return a publisher of messages of a type (std_msgs.msg.Empty by default) below /exudyn/."""
        kind = self._standard.Empty if pubType is None else pubType
        return self._rospy.Publisher(self.topicBase + pubTopicName, kind, queue_size=queueSize)

    def InitSubscriber(self, subTopicNameSpace: str, subTopicName: str, subType: Any) -> Any:
        """Return a subscriber; the last message becomes the attribute subTopicName."""
        topic = subTopicNameSpace + subTopicName
        return self._rospy.Subscriber(topic, subType, lambda data: self.ExuCallbackGeneric(subTopicName, data))

    def ExuCallbackGeneric(self, subTopicName: str, data: Any) -> bool:
        """Keep a message as the attribute subTopicName."""
        setattr(self, subTopicName, data)
        return True

    def CheckROSversion(self) -> bool:
        """Return whether the environment defines the version of ROS, and store it."""
        self.myROSversionEnvInt = int(os.getenv("ROS_VERSION", "0"))
        self.myROSdistriEnv = os.getenv("ROS_DISTRO", "unknown")
        self._rospy.loginfo(f"-ROS{self.myROSversionEnvInt} {self.myROSdistriEnv}-")
        return self.myROSversionEnvInt != 0

    def _measured(self, mbs: Any, getData: str, sensors: tuple[str, str], outputs: tuple[Any, Any]) -> list[FloatArray]:
        """Return two values of sensors, or of the node."""
        if getData == "sensor":
            return [np.asarray(mbs.GetSensorValues(mbs.variables[name])) for name in sensors]
        if getData == "node":
            return [np.asarray(mbs.GetNodeOutput(mbs.variables["nodeNumber"], output)) for output in outputs]
        raise shape_error("ROSInterface: getData", "'node' or 'sensor'", getData)

    def PublishPoseUpdate(self, mbs: Any, tExu: float, getData: str = "node") -> None:
        """Publish position and orientation, a quaternion, at the time tExu (s)."""
        if tExu - self.lastPoseSendTime < self.rosPoseSendInterval:
            return
        self.lastPoseSendTime = tExu
        outputs = OutputVariableType.Position, OutputVariableType.RotationMatrix
        position, rotation = self._measured(mbs, getData, ("pos", "ori"), outputs)
        A = RotXYZ2RotationMatrix(rotation) if rotation.size == 3 else rotation.reshape(3, 3)
        w, x, y, z = RotationMatrix2EulerParameters(A)
        message = self._geometry.PoseStamped()
        _set(message.pose.position, position)
        _set(message.pose.orientation, [x, y, z, w])
        message.header.stamp = self._rospy.Time.now()
        self.exuPosePublisher.publish(message)

    def PublishTwistUpdate(self, mbs: Any, tExu: float, getData: str = "node") -> None:
        """Publish velocity and angular velocity at the time tExu (s)."""
        if tExu - self.lastTwistSendTime < self.rosTwistSendInterval:
            return
        self.lastTwistSendTime = tExu
        outputs = OutputVariableType.Velocity, OutputVariableType.AngularVelocity
        velocity, angular = self._measured(mbs, getData, ("velt", "velr"), outputs)
        message = self._geometry.Twist()
        _set(message.linear, velocity)
        _set(message.angular, angular)
        self.exuTwistPublisher.publish(message)

    def PublishSystemStateUpdate(self, mbs: Any, tExu: float) -> None:
        """Publish the time tExu (s) and the state of the system: each of its vectors after its length."""
        if tExu - self.lastSystemStateUpdateTime < self.systemStateUpdateInterval:
            return
        self.lastSystemStateUpdateTime = tExu
        message = self._standard.Float64MultiArray()
        message.data = [tExu]
        for values in mbs.systemData.GetSystemState():
            message.data += [float(len(values)), *map(float, values)]
        self.exuSystemstatePublisher.publish(message)


def _set(target: Any, values: Any) -> None:
    """Set x, y, z and perhaps w of a message."""
    for name, value in zip("xyzw", values, strict=False):
        setattr(target, name, float(value))
