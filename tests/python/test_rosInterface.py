"""Messages to ROS, with a stand-in for rospy that stores published messages."""

from __future__ import annotations

import sys
from collections import defaultdict
from types import ModuleType, SimpleNamespace

import numpy as np
import pytest

import dalembert as exu
from dalembert.itemInterface import SensorBody
from dalembert.rigidBodyUtilities import InertiaCuboid, RotationMatrix2EulerParameters, RotationMatrixX
from dalembert.robotics.rosInterface import ROSInterface


class Message(SimpleNamespace):
    """Has all parts that are asked for."""

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        self.__dict__[name] = Message()
        return self.__dict__[name]


@pytest.fixture
def sent(monkeypatch):
    """Return messages by topic; and callbacks of subscribers by topic."""
    topics = defaultdict(list)
    rospy = ModuleType("rospy")
    rospy.init_node = lambda name, anonymous: None
    rospy.get_time = lambda: 5.0
    rospy.loginfo = lambda text: topics["log"].append(text)
    rospy.Time = SimpleNamespace(now=lambda: 7.0)
    rospy.Publisher = lambda topic, kind, queue_size: SimpleNamespace(publish=topics[topic].append)
    rospy.Subscriber = lambda topic, kind, callback: topics[topic].append(callback)
    monkeypatch.setitem(sys.modules, "rospy", rospy)
    for name in ("geometry_msgs", "std_msgs"):
        kinds = ("Twist", "PoseStamped", "WrenchStamped", "Time", "String", "Float64MultiArray", "Empty")
        messages = SimpleNamespace(**dict.fromkeys(kinds, Message))
        module = ModuleType(name)
        module.msg = messages
        monkeypatch.setitem(sys.modules, name, module)
        monkeypatch.setitem(sys.modules, f"{name}.msg", messages)
    return topics


@pytest.fixture
def mbs():
    system = exu.SystemContainer().AddSystem()
    body = system.CreateRigidBody(
        inertia=InertiaCuboid(1000, [0.1, 0.2, 0.3]),
        referencePosition=[1, 2, 3],
        referenceRotationMatrix=RotationMatrixX(0.5),
        initialVelocity=[0.1, 0.2, 0.3],
        initialAngularVelocity=[0.4, 0, 0],
        returnDict=True,
    )
    system.variables["nodeNumber"] = body["nodeNumber"]
    Variable = exu.OutputVariableType
    outputs = {
        "pos": Variable.Position,
        "ori": Variable.Rotation,
        "velt": Variable.Velocity,
        "velr": Variable.AngularVelocity,
    }
    for name, output in outputs.items():
        sensor = SensorBody(bodyNumber=body["bodyNumber"], outputVariableType=output, writeToFile=False)
        system.variables[name] = system.AddSensor(sensor)
    system.Assemble()
    return system


@pytest.mark.parametrize("source", ["node", "sensor"])
def test_poses_and_twists(sent, mbs, source):
    ros = ROSInterface()
    for t in (0.0, 0.005, 0.01):  # the second one is too early
        ros.PublishPoseUpdate(mbs, t, source)
        ros.PublishTwistUpdate(mbs, t, source)
    pose, twist = (sent[f"/exudyn/{topic}"] for topic in ("Pose", "Twist"))
    assert len(pose) == len(twist) == 2
    at, turned = pose[0].pose.position, pose[0].pose.orientation
    np.testing.assert_allclose([at.x, at.y, at.z], [1, 2, 3])
    wanted = RotationMatrix2EulerParameters(RotationMatrixX(0.5))
    np.testing.assert_allclose([turned.w, turned.x, turned.y, turned.z], wanted, atol=1e-15)
    linear, angular = twist[0].linear, twist[0].angular
    np.testing.assert_allclose([linear.x, linear.y, linear.z, angular.x], [0.1, 0.2, 0.3, 0.4])
    with pytest.raises(ValueError, match="getData: expected 'node' or 'sensor', received 'body'"):
        ros.PublishPoseUpdate(mbs, 1.0, "body")


def test_states_and_subscribers(sent, mbs, monkeypatch):
    monkeypatch.setenv("ROS_VERSION", "1")
    ros = ROSInterface()
    ros.PublishSystemStateUpdate(mbs, 0.5)
    ros.PublishSystemStateUpdate(mbs, 0.505)
    (message,) = sent["/exudyn/Systemstate"]
    state = mbs.systemData.GetSystemState()
    assert message.data[:2] == [0.5, len(state[0])]
    np.testing.assert_array_equal(message.data[2 : 2 + len(state[0])], state[0])
    ros.InitSubscriber("robot/", "command", Message)
    sent["robot/command"][0]("go")
    assert ros.command == "go" and ros.CheckROSversion() and sent["log"][0] == "-ROS1 unknown-"


def test_without_ros(monkeypatch):
    monkeypatch.setitem(sys.modules, "rospy", None)
    with pytest.raises(ImportError, match="ROSInterface: rospy and its messages are needed, which come with ROS 1"):
        ROSInterface()
