"""Names of links and joints of kinematic trees stand for their numbers: names in items, outputs, functions of robots
and trees."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert.rigidBodyUtilities import HTtranslate, InertiaCuboid, TreeLink
from dalembert.robotics import InverseKinematicsNumerical, Robot, RobotLink, VRobotLink
from dalembert.treeDynamics import RecogniseTrees, TreeDynamics

Variable = exu.OutputVariableType
Q = np.array([0.4, -0.3, 0.2])


def arm() -> Robot:
    """Column, upper arm, and forearm, on joints yaw, shoulder and elbow."""
    robot = Robot(gravity=[0, 0, -9.81])
    for name, joint, kind in (("column", "yaw", "Rz"), ("upper", "shoulder", "Ry"), ("forearm", "elbow", "Ry")):
        values = {
            "mass": 2.0,
            "COM": [0.2, 0, 0.1],
            "inertia": np.diag([0.1, 0.2, 0.3]),
            "preHT": HTtranslate([0.4, 0, 0.1]),
        }
        robot.AddLink(RobotLink(jointType=kind, name=name, jointName=joint, **values))
    return robot


def system(names: bool = True) -> tuple[Any, dict[str, Any]]:
    mbs, robot = exu.SystemContainer().AddSystem(), arm()
    robot.referenceConfiguration = Q
    if not names:
        for link in robot.links:
            link.name = link.jointName = ""
    return mbs, robot.CreateKinematicTree(mbs, "arm")


def sensor(mbs: Any, item: Any) -> Any:
    number = mbs.AddSensor(item)
    mbs.Assemble()
    return mbs.GetSensorValues(number)


def force_on(marker: Callable[[Any, dict[str, Any], Any], Any]) -> Callable[..., Any]:
    """Return a measure of the effect of a load on the motion of the arm."""

    def call(mbs: Any, made: dict[str, Any], place: Any) -> Any:
        item, load = marker(mbs, made, place)
        mbs.AddLoad(load | {"markerNumber": mbs.AddMarker(item)})
        mbs.Assemble()
        return moved(mbs)

    return call


def moved(mbs: Any, solver: Any = exu.DynamicSolverType.RK44) -> Any:
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps, settings.timeIntegration.endTime = 1, 1e-3
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveDynamic(settings, solverType=solver)
    return mbs.systemData.GetODE2Coordinates()


def edited(mbs: Any, made: dict[str, Any], place: Any) -> Any:
    marker = mbs.AddMarker(exu.MarkerKinematicTreeRigid(objectNumber=made["objectKinematicTree"], linkNumber=0))
    mbs.SetMarkerParameter(marker, "linkNumber", place)
    return mbs.GetMarkerParameter(marker, "linkNumber")


def from_dictionary(mbs: Any, made: dict[str, Any], place: Any) -> Any:
    item = exu.SensorKinematicTree(objectNumber="arm", linkNumber=place, outputVariableType=Variable.Position)
    assert item.linkNumber == pickle.loads(pickle.dumps(item)).linkNumber == place
    return sensor(mbs, dict(item))


def of_tree_links(mbs: Any, parent: Any) -> Any:
    rod = InertiaCuboid(1000, [1, 0.1, 0.1])
    names = (("column", "yaw", -1), ("upper", "shoulder", 0), ("forearm", "elbow", "upper"), ("hand", "wrist", parent))
    links = [TreeLink(rod, parent=before, name=name, jointName=joint) for name, joint, before in names]
    return mbs.CreateKinematicTree("hand", links)


# Listed by function or parameter: a call with a link, or a joint; the result is the same for number and name.
CASES: dict[str, Callable[[Any, dict[str, Any], Any], Any]] = {
    "MarkerKinematicTreeRigid.linkNumber": force_on(
        lambda mbs, made, i: (
            exu.MarkerKinematicTreeRigid(objectNumber="arm", linkNumber=i, localPosition=[0.3, 0, 0]),
            {"loadType": "ForceVector", "loadVector": [1, 2, 3]},
        )
    ),
    "MarkerNodeCoordinate.coordinate": force_on(
        lambda mbs, made, i: (
            exu.MarkerNodeCoordinate(nodeNumber=made["nodeGeneric"], coordinate=i),
            {"loadType": "Coordinate", "load": 2},
        )
    ),
    "SetMarkerParameter": edited,
    "SensorKinematicTree.linkNumber": lambda mbs, made, i: sensor(
        mbs, exu.SensorKinematicTree(objectNumber="arm", linkNumber=i, outputVariableType=Variable.RotationMatrix)
    ),
    "SensorSuperElement.meshNodeNumber": lambda mbs, made, i: sensor(
        mbs, exu.SensorSuperElement(bodyNumber="arm", meshNodeNumber=i, outputVariableType=Variable.Position)
    ),
    "dictionary": from_dictionary,
    "GetObjectOutputSuperElement.meshNodeNumber": lambda mbs, made, i: (
        mbs.Assemble(),
        mbs.GetObjectOutputSuperElement("arm", Variable.Position, i),
    )[1],
    "CreateCoordinateConstraint.coordinates": lambda mbs, made, i: (
        mbs.CreateCoordinateConstraint(bodyNumbers=[None, "arm"], coordinates=[None, i]),
        mbs.Assemble(),
        moved(mbs, exu.DynamicSolverType.GeneralizedAlpha),
    )[2],
    "TreeDynamics.Jacobian.linkNumber": lambda mbs, made, i: (
        mbs.Assemble(),
        TreeDynamics(mbs, "arm").Jacobian(Q, i, [0.1, 0.2, 0.3]),
    )[1],
    "Robot.Dynamics.Jacobian.linkNumber": lambda mbs, made, i: arm().Dynamics().Jacobian(Q, i),
    "Robot.GetLink.i": lambda mbs, made, i: arm().GetLink(i).name,
    "Robot.GetLinkIndex.link": lambda mbs, made, i: arm().GetLinkIndex(i),
    "Robot.GetParentIndex.i": lambda mbs, made, i: arm().GetParentIndex(i),
    "Robot.HasParent.i": lambda mbs, made, i: arm().HasParent(i),
    "Robot.GetLinkGraphicsData.i": lambda mbs, made, i: len(
        arm().GetLinkGraphicsData(i, [0, 0, 0], [1, 0, 0], [0, 0, 1], [0, 0, 1], VRobotLink())
    ),
    "Robot.Jacobian.linkIndex": lambda mbs, made, i: arm().Jacobian(arm().JointHT(Q), linkIndex=i),
    "Robot.FrameHT.frame": lambda mbs, made, i: arm().FrameHT(i, Q),
    "RobotLink.parent": lambda mbs, made, i: (
        robot := arm(),
        robot.AddLink(RobotLink(1, [0, 0, 0], np.eye(3), parent=i)),
        robot.GetParentIndex(3),
    )[-1],
    "TreeLink.parent": lambda mbs, made, i: mbs.GetObjectParameter(of_tree_links(mbs, i), "linkParents"),
    "InverseKinematicsNumerical.link": lambda mbs, made, i: InverseKinematicsNumerical(arm(), link=i).robot.name,
}


@pytest.mark.parametrize("where", CASES)
@pytest.mark.parametrize("name", ["forearm", "elbow"])
def test_names_stand_for_numbers(where: str, name: str) -> None:
    with_number, with_name = (CASES[where](*system(), place) for place in (2, name))
    assert np.array_equal(with_number, with_name)
    other = CASES[where](*system(), 0)
    assert where in ("Robot.GetLinkGraphicsData.i", "InverseKinematicsNumerical.link") or not np.array_equal(
        with_number, other
    )


@pytest.mark.parametrize("where", CASES)
def test_names_that_are_not_there_are_refused(where: str) -> None:
    with pytest.raises((ValueError, IndexError), match="forearn"):
        CASES[where](*system(), "forearn")


OF_ITEMS = [where for where in CASES if where.startswith(("Marker", "Sensor", "SetMarker", "GetObject"))]


@pytest.mark.parametrize("where", OF_ITEMS)
def test_the_nearest_name_is_suggested(where: str) -> None:
    with pytest.raises(IndexError, match=r"received 'forearn'.*link.*Did you mean 'forearm'"):
        CASES[where](*system(), "forearn")
    with pytest.raises(IndexError, match=r"'forearm'.*linkNames and jointNames"):
        CASES[where](*system(names=False), "forearm")


def test_a_node_that_no_tree_stands_on_has_no_joints() -> None:
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(exu.NodeGenericODE2(numberOfODE2Coordinates=2, referenceCoordinates=[0, 0]))
    with pytest.raises(IndexError, match="'coordinate': received 'elbow'.*not on a kinematic tree"):
        mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate="elbow"))


@pytest.mark.parametrize("counted", ["links", "joints"])
def test_counted_items_come_first(counted: str) -> None:
    """Link 0 is called as the joint of link 1."""
    tree = {
        "linkNames": ["a", ""],
        "jointNames": ["", "a"],
        "jointTypes": [exu.JointType.RevoluteZ] * 2,
        "linkParents": [-1, 0],
    }
    tree |= {"jointTransformations": [np.eye(3)] * 2, "jointOffsets": [[1, 0, 0]] * 2, "linkMasses": [1, 1]}
    tree |= {"linkInertiasCOM": [np.eye(3)] * 2, "linkCOMs": [[0, 0, 0]] * 2}
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(exu.NodeGenericODE2(numberOfODE2Coordinates=2, referenceCoordinates=[0, 0]))
    body = mbs.AddObject(exu.ObjectKinematicTree(nodeNumber=node, **tree))
    item, row = (
        (exu.MarkerKinematicTreeRigid(objectNumber=body, linkNumber="a"), "linkNumber")
        if counted == "links"
        else (exu.MarkerNodeCoordinate(nodeNumber=node, coordinate="a"), "coordinate")
    )
    assert mbs.GetMarkerParameter(mbs.AddMarker(item), row) == (0 if counted == "links" else 1)
    assert TreeDynamics(exu.ObjectKinematicTree(**tree)).linkNumbers == {"a": 0}


@pytest.mark.parametrize(
    ("names", "text"),
    [
        ({"linkNames": ["a", "b"]}, "'linkNames': received a list of length 2"),
        ({"jointNames": ["a", "", "a"]}, "'jointNames': received 'a' twice"),
        ({"linkNames": "abc"}, "'linkNames': received 'abc'.*a list of strings"),
    ],
)
def test_wrong_names_are_refused(names: dict[str, Any], text: str) -> None:
    mbs, made = system()
    with pytest.raises((ValueError, TypeError), match=text):
        mbs.SetObjectParameter(made["objectKinematicTree"], *next(iter(names.items())))
        mbs.Assemble()


def test_names_stay_with_systems() -> None:
    mbs, made = system()
    other = exu.SystemContainer().AddSystem()
    other.SetDictionary(mbs.GetDictionary())
    for one in (other, pickle.loads(pickle.dumps(mbs))):
        marker = one.AddMarker(exu.MarkerKinematicTreeRigid(objectNumber="arm", linkNumber="elbow"))
        assert one.GetMarkerParameter(marker, "linkNumber") == 2
        assert one.GetObjectParameter("arm", "jointNames") == ["yaw", "shoulder", "elbow"]


def test_recognised_trees_have_the_names_of_bodies_and_joints() -> None:
    mbs = exu.SystemContainer().AddSystem()
    ground, rod = mbs.CreateGround(name="wall"), InertiaCuboid(1000, [1, 0.1, 0.1])
    before = ground
    for i, name in enumerate(("thigh", "shank")):
        body = mbs.CreateRigidBody(name, [i + 0.5, 0, 0], inertia=rod)
        mbs.CreateRevoluteJoint(("hip", "knee")[i], [before, body], [i, 0, 0], [0, 0, 1])
        before = body
    mbs.Assemble()
    trees = RecogniseTrees(mbs)
    tree = next(
        i for i in range(trees.systemData.NumberOfObjects()) if trees.GetObject(i)["objectType"] == "KinematicTree"
    )
    tip = trees.AddSensor(
        exu.SensorKinematicTree(objectNumber=tree, linkNumber="knee", outputVariableType=Variable.Position)
    )
    trees.Assemble()
    assert trees.GetSensorValues(tip) == pytest.approx([1, 0, 0], abs=1e-14)
    assert trees.GetObjectParameter(tree, "linkNames") == ["thigh", "shank"]


def test_links_of_create_functions_have_names() -> None:
    mbs = exu.SystemContainer().AddSystem()
    tree = of_tree_links(mbs, "elbow")
    assert mbs.GetObjectParameter(tree, "linkParents") == [-1, 0, 1, 2]
    marker = mbs.AddMarker(exu.MarkerKinematicTreeRigid(objectNumber="hand", linkNumber="wrist"))
    assert mbs.GetMarkerParameter(marker, "linkNumber") == 3
    with pytest.raises(ValueError, match="name of a link before, link 3 among them.*Did you mean 'forearm'"):
        of_tree_links(exu.SystemContainer().AddSystem(), "forearn")
