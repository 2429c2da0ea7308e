"""Names in place of indices: names in items, methods, Create functions, variations and plots; and results of Create
functions."""

from __future__ import annotations

import copy
import pickle
from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert.rigidBodyUtilities import InertiaCuboid


@pytest.fixture
def mbs() -> Any:
    """A weight on a spring, item by item, by names alone."""
    mbs = exu.SystemContainer().AddSystem()
    mbs.AddNode(exu.NodePoint("foot", referenceCoordinates=[1, 0, 0]))
    mbs.AddObject(exu.ObjectMassPoint("weight", physicsMass=2, nodeNumber="foot"))
    mbs.AddObject(exu.ObjectGround("ground"))
    mbs.AddMarker(exu.MarkerBodyPosition("hook", bodyNumber="ground"))
    mbs.AddMarker(exu.MarkerNodePosition("load", nodeNumber="foot"))
    mbs.AddObject(
        exu.ObjectConnectorSpringDamper("spring", markerNumbers=["hook", "load"], referenceLength=1, stiffness=80)
    )
    mbs.AddLoad(exu.LoadForceVector("push", markerNumber="load", loadVector=[4, 0, 0]))
    kind = exu.OutputVariableType.Displacement
    mbs.AddSensor(exu.SensorBody("way", bodyNumber="weight", outputVariableType=kind, storeInternal=True))
    return mbs


def hold(mbs: Any) -> None:
    """Leave the weight one degree of freedom."""
    for coordinate in (1, 2):
        mbs.CreateCoordinateConstraint(bodyNumbers=[None, "weight"], coordinates=[None, coordinate])


def test_names_are_resolved_when_an_item_is_added(mbs: Any) -> None:
    assert mbs.GetObject("weight")["nodeNumber"] == exu.NodeIndex(0)
    assert mbs.GetObject("spring")["markerNumbers"] == [exu.MarkerIndex(0), exu.MarkerIndex(1)]
    mbs.SetNodeParameter("foot", "name", "toe")  # it is the item that is meant, not the name
    assert mbs.GetMarker("load")["nodeNumber"] == exu.NodeIndex(0)
    hold(mbs)
    mbs.Assemble()
    mbs.SolveStatic()
    assert mbs.GetSensorValues("way")[0] == pytest.approx(4 / 80)
    assert mbs.GetNodeOutput("toe", exu.OutputVariableType.Position)[0] == pytest.approx(1.05)
    assert mbs.systemData.GetObjectLTGODE2("weight") == [0, 1, 2]


def test_default_names_count(mbs: Any) -> None:
    marker = mbs.AddMarker(exu.MarkerNodePosition(nodeNumber="foot"))
    mbs.AddLoad(exu.LoadForceVector(markerNumber=f"marker{marker}"))
    assert mbs.GetLoad(1)["markerNumber"] == marker


def test_parameters_are_set_by_names(mbs: Any) -> None:
    other = mbs.AddMarker(exu.MarkerBodyPosition("other", bodyNumber="ground", localPosition=[0, 1, 0]))
    mbs.SetObjectParameter("spring", "markerNumbers", ["other", "load"])
    assert mbs.GetObject("spring")["markerNumbers"][0] == other
    mbs.ModifyObject("spring", {"markerNumbers": ["hook", "load"], "stiffness": 3})
    assert mbs.GetObjectParameter("spring", "markerNumbers")[0] == exu.MarkerIndex(0)
    mbs.AddMarker({"markerType": "NodePosition", "nodeNumber": "foot"})
    mbs.DeleteMarker("other")
    assert int(mbs.GetMarkerNumber("other")) == -1


def test_items_keep_names_until_they_are_added() -> None:
    item = exu.MarkerBodyPosition(bodyNumber="arm")
    assert item.bodyNumber == "arm" and "bodyNumber='arm'" in repr(item)
    for other in (pickle.loads(pickle.dumps(item)), copy.copy(item), exu.MarkerBodyPosition(bodyNumber="arm")):
        assert other == item and other.bodyNumber == "arm"
    assert dict(item)["bodyNumber"] == "arm"


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda m: m.AddMarker(exu.MarkerNodePosition(nodeNumber="fot")), "marker 2 .*'nodeNumber': received 'fot', but expected the name of a node .*Did you mean 'foot'"),
        (lambda m: m.AddObject(exu.ObjectConnectorSpringDamper("s", markerNumbers=["hook", "foot"])), "object 3 's' .*'markerNumbers': received 'foot', but expected the name of a marker"),
        (lambda m: m.SetObjectParameter("spring", "markerNumbers", ["hook", "lod"]), "object 2 'spring' .*Did you mean 'load'"),
        (lambda m: m.SetObjectParameter("sprong", "stiffness", 1), r"mbs.SetObjectParameter\(...\), parameter 'objectNumber': received 'sprong'.*Did you mean 'spring'"),
        (lambda m: m.GetSensorValues("wey"), "received 'wey'.*Did you mean 'way'"),
        (lambda m: m.AddLoad(exu.LoadForceVector(markerNumber="")), "expected a MarkerIndex, an integer or a name"),
        (lambda m: (m.Assemble(), m.systemData.GetNodeLTGODE2("fod")), "received 'fod', but expected the name of a node"),
        (lambda m: m.CreateForce(bodyNumber="wight"), r"CreateForce\(...\): argument 'bodyNumber': received 'wight', but no object or marker or node .*'weight'"),
        (lambda m: m.CreateSpringDamper(bodyNumbers=["ground", "wight"]), r"argument 'bodyNumbers\[1\]': received 'wight'"),
        (lambda m: m.SolveVariations({("sprig", "stiffness"): [1.0]}), "SolveVariations: parameters: received 'sprig'.*Did you mean 'spring'"),
        (lambda m: m.AddObject(exu.ObjectGround("weight")), "expected a name that no other object has"),
    ],
)  # fmt: skip
def test_wrong_names_change_nothing(mbs: Any, call: Any, text: str) -> None:
    before = repr(dict(mbs.GetDictionary()))
    with pytest.raises((ValueError, TypeError, IndexError), match=text):
        call(mbs)
    assert repr(dict(mbs.GetDictionary())) == before


def test_create_functions_take_names() -> None:
    mbs = exu.SystemContainer().AddSystem()
    mbs.CreateGround("base")
    bar = {"inertia": InertiaCuboid(1000, [1, 0.1, 0.1])}
    mbs.CreateRigidBody("arm", [0.5, 0, 0], **bar)
    mbs.CreateRigidBody("hand", [1.5, 0, 0], **bar)
    mbs.CreateRevoluteJoint("shoulder", ["base", "arm"], [0, 0, 0], [0, 0, 1])
    mbs.CreateRevoluteJoint(
        name="wrist", bodyNumbers=["arm", mbs.GetObjectNumber("hand")], position=[1, 0, 0], axis=[0, 0, 1]
    )
    mbs.CreateTorque(bodyNumber="hand", loadVector=[0, 0, 1])
    mbs.CreateForce("", "Marker1:wrist", [1, 0, 0])
    mbs.CreateCoordinateConstraint(bodyNumbers=[None, "arm"], coordinates=[None, 2])
    mbs.Assemble()
    assert int(mbs.GetMarker("Marker0:wrist")["bodyNumber"]) == 1
    mbs.AddMarker(exu.MarkerNodePosition("twice", nodeNumber=0))
    mbs.AddNode(exu.NodePoint("twice"))
    with pytest.raises(ValueError, match="the name of marker .* and node .*Pass the index of the one you mean"):
        mbs.CreateSpringDamper(bodyNumbers=["twice", "arm"])


def test_created_objects_have_their_parts() -> None:
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround("base")
    arm = mbs.CreateRigidBody("arm", [0.5, 0, 0], inertia=InertiaCuboid(1000, [1, 0.1, 0.1]), gravity=[0, -9.81, 0])
    hinge = mbs.CreateRevoluteJoint("hinge", [ground, arm], [0, 0, 0], [0, 0, 1])
    assert isinstance(arm, exu.ObjectIndex) and (repr(arm), str(arm), arm) == (
        "ObjectIndex(1)",
        "1",
        exu.ObjectIndex(1),
    )
    assert arm.nodes == [exu.NodeIndex(0)] and ground.nodes == []
    assert [mbs.GetLoad(load)["loadType"] for load in arm.loads] == ["MassProportional"]
    assert hinge.markers == mbs.GetObject(hinge)["markerNumbers"] and hinge.markers[1] in arm.markers
    assert type(pickle.loads(pickle.dumps(arm))) is exu.ObjectIndex
    assert type(copy.deepcopy(mbs)) is type(mbs)


def test_variations_by_names(mbs: Any) -> None:
    hold(mbs)
    mbs.Assemble()
    found = mbs.SolveVariations({("spring", "stiffness"): [40.0, 80.0]}, solverType="static", sensors=["way"])
    assert np.allclose(found.SensorValues("way")[:, 0], [0.1, 0.05])
    with pytest.raises(ValueError, match="sensor 'wy' was not among those"):
        found.SensorValues("wy")
