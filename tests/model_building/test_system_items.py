"""Items in a system: adding, finding, reading and changing them."""

from __future__ import annotations

import pickle
import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert.utilities import InertiaSphere


def test_indices_and_default_names(mbs: exu.MainSystem) -> None:
    node = mbs.AddNode(exu.NodePoint())
    assert (type(node), int(node)) == (exu.NodeIndex, 0)
    assert mbs.AddNode(exu.NodePoint(name="foot")) == exu.NodeIndex(1)
    assert [mbs.GetNode(i)["name"] for i in range(2)] == ["node0", "foot"]
    assert mbs.GetNodeNumber("node0") == exu.NodeIndex(0)
    assert mbs.GetNodeNumber("foot") == exu.NodeIndex(1)
    assert mbs.GetNodeNumber("nobody") == exu.NodeIndex(-1)
    assert mbs.GetNodeNumber("node1") == exu.NodeIndex(-1)


@pytest.mark.parametrize(
    ("add", "text"),
    [
        (lambda mbs: mbs.AddNode(exu.NodePoint("foot")), "node 1 (NodePoint), parameter 'name': received 'foot', but expected a name that no other node has. The name belongs to node 0 'foot' (NodePoint); choose another one."),
        (lambda mbs: mbs.AddNode(exu.NodePoint("node7")), "node 1 (NodePoint), parameter 'name': received 'node7', but expected a name that is not of the form 'node' + number. Such names are given to items without a name; choose another one, or leave the name empty."),
        (lambda mbs: mbs.AddNode({"nodeType": "Pont"}), "mbs.AddNode(...): there is no node type 'Pont'. Did you mean 'Point'?"),
        (lambda mbs: mbs.AddNode({"nodeType": "MassPoint"}), "mbs.AddNode(...): there is no node type 'MassPoint'."),
        (lambda mbs: mbs.AddNode({}), "mbs.AddNode(...): the dictionary has no key 'nodeType'; received {} (dict), but expected a dictionary of a node. Name the type, e.g. {'nodeType': 'Point', ...}."),
        (lambda mbs: mbs.AddNode({"nodeType": "Point", "referenceCoordinates": [1]}), "mbs.AddNode(...): NodePoint, parameter 'referenceCoordinates': received [1] (list of length 1), but expected 3 finite numbers"),
        (lambda mbs: mbs.AddNode(exu.MassPoint()), "mbs.AddNode(...): received ObjectMassPoint() (ObjectMassPoint), but expected a node item or its dictionary. ObjectMassPoint is an object; use mbs.AddObject(...)."),
        (lambda mbs: mbs.AddNode(exu.NodePoint), "Put parentheses behind the class to make an item of it."),
        (lambda mbs: mbs.AddNode(3), "mbs.AddNode(...): received 3 (int), but expected a node item or its dictionary. Items are made by their classes"),
        (lambda mbs: mbs.GetNode(9), "mbs.GetNode(...): there is no node with number 9: expected a number from 0 to 0. Use the index that AddNode(...) returned."),
        (lambda mbs: mbs.GetNode(-1), "mbs.GetNode(...): there is no node with number -1: expected a number from 0 to 0."),
        (lambda mbs: mbs.GetLoad(0), "mbs.GetLoad(...): there is no load with number 0: expected nothing: the system has no loads yet."),
        (lambda mbs: mbs.GetNode(exu.ObjectIndex(0)), "mbs.GetNode(...), parameter 'nodeNumber': received 0 (ObjectIndex), but expected a NodeIndex, an integer or a name. It is an ObjectIndex: it counts objects, not nodes."),
        (lambda mbs: mbs.GetNode("fot"), "mbs.GetNode(...), parameter 'nodeNumber': received 'fot', but expected the name of a node of this system. Did you mean 'foot'?"),
        (lambda mbs: mbs.GetNodeParameter(0, "refCoordinates"), "node 0 'foot' (NodePoint): there is no parameter 'refCoordinates'. Did you mean 'referenceCoordinates'?"),
        (lambda mbs: mbs.SetNodeParameter(0, "drawSize", 1), "node 0 'foot' (NodePoint): there is no parameter 'drawSize'. Did you mean 'VdrawSize'?"),
        (lambda mbs: mbs.SetNodeParameter(0, "initialVelocities", [1, 2]), "node 0 'foot' (NodePoint), parameter 'initialVelocities': received [1, 2] (list of length 2), but expected 3 finite numbers"),
        (lambda mbs: mbs.SetNodeParameter(0, "name", "node4"), "node 0 (NodePoint), parameter 'name': received 'node4'"),
        (lambda mbs: mbs.ModifyNode(0, {"nodeType": "Point2D"}), "node 0 'foot' (NodePoint), parameter 'nodeType': received 'Point2D', but expected 'Point'. The type of an item cannot change; delete the item and add another one."),
        (lambda mbs: mbs.GetNodeDefaults("Pont"), "mbs.GetNodeDefaults(...): there is no node type 'Pont'. Did you mean 'Point'?"),
        (lambda mbs: mbs.GetNodeOutput(0, exu.OutputVariableType.Position), "mbs.GetNodeOutput(...): the system is not assembled. Call mbs.Assemble() after the last change of items and before this call."),
        (lambda mbs: mbs.SetPreStepUserFunction(3), "mbs.SetPreStepUserFunction(...), parameter 'value': received 3 (int), but expected a function, or 0 for none."),
    ],
)  # fmt: skip
def test_refusals_leave_the_system_as_it_was(mbs: exu.MainSystem, add: Any, text: str) -> None:
    mbs.AddNode(exu.NodePoint("foot", [1, 2, 3]))
    before = repr(mbs.GetDictionary())
    with pytest.raises((TypeError, ValueError, IndexError, RuntimeError)) as caught:
        add(mbs)
    assert text in str(caught.value)
    assert repr(mbs.GetDictionary()) == before


def test_outputs_before_assembling_name_the_item(mbs: exu.MainSystem) -> None:
    """The item alone is assembled then, as the first of its kind; errors still have its number and name."""
    for i in range(4):
        node = mbs.AddNode(exu.NodePoint(referenceCoordinates=[i, 0, 0]))
        mbs.AddObject(exu.MassPoint(nodeNumber=node, physicsMass=1, name="end" if i == 3 else ""))
    for body, title in ((2, "object 2 'object2' (ObjectMassPoint)"), (3, "object 3 'end' (ObjectMassPoint)")):
        with pytest.raises(ValueError, match=re.escape(title) + ": has no output variable Force"):
            mbs.GetObjectOutputBody(body, exu.OutputVariableType.Force, [0, 0, 0], exu.ConfigurationType.Reference)


def test_entries_of_old_releases_are_ignored_with_a_warning(mbs: exu.MainSystem) -> None:
    """Models of Exudyn 1.11 give markers an entry that has had no effect for years."""
    body = mbs.AddObject(exu.itemInterface.ObjectGround())
    with pytest.warns(UserWarning, match="MarkerBodyPosition: 'bodyFixed' has no effect on markers"):
        marker = mbs.AddMarker({"markerType": "BodyPosition", "bodyNumber": body, "bodyFixed": False})
    assert "bodyFixed" not in mbs.GetMarker(marker)


def test_unknown_keys_of_dictionaries_are_refused(mbs: exu.MainSystem) -> None:
    text = r"mbs\.AddNode\(\.\.\.\): NodePoint: there is no parameter 'initialVelocity'\. Did you mean 'initialVelocities'\?"
    before = mbs.systemData.NumberOfNodes()
    with pytest.raises(ValueError, match=text):
        mbs.AddNode({"nodeType": "Point", "referenceCoordinates": [1, 2, 3], "initialVelocity": [1, 0, 0]})
    assert mbs.systemData.NumberOfNodes() == before
    number = mbs.AddNode({"nodeType": "Point", "referenceCoordinates": [1, 2, 3]})
    with pytest.raises(ValueError, match="there is no parameter 'initialVelocity'"):
        mbs.ModifyNode(number, {"initialVelocity": [1, 0, 0]})


def test_later_changes_of_the_python_item_stay_outside(mbs: exu.MainSystem) -> None:
    node = exu.NodePoint(referenceCoordinates=[1, 2, 3])
    first = mbs.AddNode(node)
    node.referenceCoordinates[0] = 9
    view = node.referenceCoordinates
    node.initialVelocities = [4, 4, 4]
    node.visualization.show = False
    second = mbs.AddNode(node)
    view[1] = 7
    assert mbs.GetNode(first)["referenceCoordinates"].tolist() == [1, 2, 3]
    assert mbs.GetNode(first)["initialVelocities"].tolist() == [0, 0, 0]
    assert mbs.GetNode(first)["Vshow"] is True
    assert mbs.GetNode(second)["referenceCoordinates"].tolist() == [9, 2, 3]
    assert node.referenceCoordinates.tolist() == [9, 7, 3]


def test_changes_of_the_system_stay_inside(mbs: exu.MainSystem) -> None:
    node = exu.NodePoint(referenceCoordinates=[1, 2, 3])
    number = mbs.AddNode(node)
    mbs.SetNodeParameter(number, "referenceCoordinates", [5, 5, 5])
    mbs.GetNodeParameter(number, "referenceCoordinates")[0] = 8
    assert mbs.GetNodeParameter(number, "referenceCoordinates").tolist() == [5, 5, 5]
    assert node.referenceCoordinates.tolist() == [1, 2, 3]


def test_set_and_get_parameters(mbs: exu.MainSystem) -> None:
    number = mbs.AddNode(exu.NodePoint())
    mbs.SetNodeParameter(number, "Vshow", False)
    mbs.SetNodeParameter(number, "Vcolor", np.array([1, 0, 0, 1]))
    mbs.SetNodeParameter(number, "name", "foot")
    assert mbs.GetNodeParameter(number, "Vshow") is False
    assert mbs.GetNodeParameter(number, "Vcolor") == [1, 0, 0, 1]
    assert mbs.GetNodeNumber("foot") == number
    assert mbs.GetNodeNumber("node0") == exu.NodeIndex(-1)
    mbs.ModifyNode(number, {"initialVelocities": [1, 2, 3]})
    assert mbs.GetNode(number)["initialVelocities"].tolist() == [1, 2, 3]
    assert mbs.GetNode(number)["name"] == "foot"
    mbs.ModifyNode(number, mbs.GetNode(number))


def test_graphics_are_shown_on_request_and_kept(mbs: exu.MainSystem) -> None:
    line = {"type": "Line", "data": [0, 0, 0, 1, 0, 0]}
    ground = mbs.AddObject(exu.ObjectGround(visualization=exu.VObjectGround(graphicsData=[line])))
    short = mbs.GetObject(ground)
    assert short["VgraphicsData"] == [{"graphicsData": "<not requested>"}]
    mbs.ModifyObject(ground, short)
    assert mbs.GetObject(ground, addGraphicsData=True)["VgraphicsData"] == [line]


def test_objects_that_become_dictionaries_are_accepted(mbs: exu.MainSystem) -> None:
    class Own:
        def __iter__(self) -> Any:
            yield "nodeType", "Point"
            yield "referenceCoordinates", [1, 2, 3]

    assert mbs.GetNode(mbs.AddNode(Own()))["referenceCoordinates"].tolist() == [1, 2, 3]


def model(mbs: exu.MainSystem) -> None:
    ground = mbs.AddObject(exu.ObjectGround())
    nodes = [mbs.AddNode(exu.NodePoint(referenceCoordinates=[i, 0, 0])) for i in range(3)]
    bodies = [mbs.AddObject(exu.MassPoint(physicsMass=1, nodeNumber=node)) for node in nodes]
    markers = [mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=body)) for body in [ground, *bodies]]
    for first, second in zip(markers[:-1], markers[1:], strict=True):
        mbs.AddObject(exu.SpringDamper(markerNumbers=[first, second], stiffness=10, referenceLength=1))
    for marker in markers[1:]:
        mbs.AddLoad(exu.Force(markerNumber=marker, loadVector=[0, 0, 1]))
    for node in nodes:
        mbs.AddSensor(
            exu.SensorNode(nodeNumber=node, outputVariableType=exu.OutputVariableType.Position, writeToFile=False)
        )


def references(mbs: exu.MainSystem) -> list[list[int]]:
    """References of items, by kind: nodes of bodies, markers of springs, bodies of markers, ..."""
    data = mbs.GetDictionary()
    result = []
    for key in ("objectList", "markerList", "loadList", "sensorList"):
        for item in data[key]:
            result += [[int(i) for i in np.ravel(v)] for k, v in item.items() if k.endswith(("Number", "Numbers"))]
    return result


def test_delete_node_shifts_and_invalidates(mbs: exu.MainSystem) -> None:
    model(mbs)
    with pytest.warns(
        UserWarning,
        match=r"mbs.DeleteNode\(...\): object 2 'object2' .ObjectMassPoint.: parameter 'nodeNumber' referred to the deleted node 1 and is invalid now",
    ):
        mbs.DeleteNode(1)
    assert references(mbs)[:3] == [[0], [-1], [1]]
    assert references(mbs)[-3:] == [[0], [-1], [1]]
    assert [node["name"] for node in mbs.GetDictionary()["nodeList"]] == ["node0", "node1"]


def test_delete_object_takes_nodes_and_markers_along(mbs: exu.MainSystem) -> None:
    model(mbs)
    mbs.DeleteObject(2, suppressWarnings=True)
    assert (mbs.systemData.NumberOfObjects(), mbs.systemData.NumberOfNodes()) == (6, 2)
    assert references(mbs)[:2] == [[0], [1]]
    mbs.DeleteObject(3, suppressWarnings=True)  # the first spring: between ground and the first body
    assert (mbs.systemData.NumberOfObjects(), mbs.systemData.NumberOfMarkers()) == (5, 2)
    mbs.DeleteObject(1, deleteDependentItems=False, suppressWarnings=True)
    assert mbs.systemData.NumberOfNodes() == 2


def test_delete_load_marker_and_sensor(mbs: exu.MainSystem) -> None:
    model(mbs)
    mbs.DeleteLoad(1, suppressWarnings=True)
    assert (mbs.systemData.NumberOfLoads(), mbs.systemData.NumberOfMarkers()) == (2, 3)
    mbs.DeleteLoad(0, deleteDependentMarkers=False)
    assert (mbs.systemData.NumberOfLoads(), mbs.systemData.NumberOfMarkers()) == (1, 3)
    mbs.DeleteMarker(0, suppressWarnings=True)
    assert mbs.systemData.NumberOfMarkers() == 2
    mbs.DeleteSensor(0)
    assert mbs.systemData.NumberOfSensors() == 2


def test_warnings_as_errors_do_not_break_deletion(mbs: exu.MainSystem) -> None:
    model(mbs)
    with pytest.raises(IndexError, match=r"mbs.DeleteNode\(...\): there is no node with number 7"):
        mbs.DeleteNode(7)
    assert mbs.systemData.NumberOfNodes() == 3


def same(a: Any, b: Any) -> bool:
    return repr(a) == repr(b)


def test_dictionary_pickle_and_reset(mbs: exu.MainSystem) -> None:
    model(mbs)
    mbs.variables["length"] = 3
    data = mbs.GetDictionary()
    copy = pickle.loads(pickle.dumps(mbs))
    assert same(copy.GetDictionary(), data)
    assert copy.variables == {"length": 3}
    other = exu.SystemContainer().AddSystem()
    other.SetDictionary(data)
    assert same(other.GetDictionary(), data)
    mbs.Reset()
    assert (mbs.systemData.NumberOfNodes(), mbs.systemData.NumberOfObjects(), mbs.variables) == (0, 0, {})
    assert mbs.AddNode(exu.NodePoint()) == 0


def test_set_dictionary_is_all_or_nothing(mbs: exu.MainSystem) -> None:
    model(mbs)
    before = mbs.GetDictionary()
    broken = mbs.GetDictionary()
    broken["objectList"][2]["physicsMass"] = "heavy"
    with pytest.raises(
        TypeError, match=r"SetDictionary\(...\), objectList\[2\]: ObjectMassPoint, parameter 'physicsMass'"
    ):
        mbs.SetDictionary(broken)
    assert same(mbs.GetDictionary(), before)


def test_containers() -> None:
    container = exu.SystemContainer()
    mbs = container.AddSystem()
    assert container.GetSystem(0) is mbs
    assert mbs.GetSystemContainer() is container
    with pytest.raises(
        IndexError,
        match=r"SC.GetSystem\(...\), parameter 'systemNumber': received 3, but expected a number from 0 to 0",
    ):
        container.GetSystem(3)
    with pytest.raises(ValueError, match="parameter 'mainSystem': the system already belongs to a SystemContainer"):
        container.Append(mbs)
    alone = exu.MainSystem()
    assert alone.GetSystemContainer().GetSystem(0) is alone
    assert container.Append(exu.MainSystem()) == 1
    model(mbs)
    other = pickle.loads(pickle.dumps(container))
    assert other.NumberOfSystems() == 2
    assert same(other.GetSystem(0).GetDictionary(), mbs.GetDictionary())
    container.Reset()
    assert container.NumberOfSystems() == 0


@pytest.mark.parametrize("make", [lambda: exu.SystemContainer().AddSystem(), exu.MainSystem])
def test_settings_of_pictures_outlive_the_container(make: Callable[[], exu.MainSystem]) -> None:
    """A model that keeps its system alone has one set of settings, which pictures take."""
    mbs = make()
    mbs.GetSystemContainer().visualizationSettings.nodes.show = False
    assert not mbs.GetSystemContainer().visualizationSettings.nodes.show
    container = mbs.GetSystemContainer()
    container.visualizationSettings = exu.VisualizationSettings()
    del container
    assert mbs.GetSystemContainer().visualizationSettings.nodes.show


def test_summary(mbs: exu.MainSystem) -> None:
    model(mbs)
    assert repr(mbs) == "<MainSystem: 3 nodes, 7 objects, 4 markers, 3 loads, 3 sensors; not assembled>"
    mbs.Assemble()
    assert repr(mbs).endswith("; coordinates: 9 ODE2, 0 ODE1, 0 AE, 0 data>")


def test_system_functions(mbs: exu.MainSystem) -> None:
    def before_step(mbs: exu.MainSystem, t: float) -> bool:
        return True

    for name in (
        *("PreStep", "PostStep", "PostNewton", "PreNewtonResidual", "SystemJacobian"),
        *("Events", "EventAction", "ItemEventAction"),
    ):
        get, put = getattr(mbs, f"Get{name}UserFunction"), getattr(mbs, f"Set{name}UserFunction")
        assert get() == 0
        put(before_step)
        assert get() is before_step
        assert get(asDict=True)["function"] is before_step
        put(0)
        assert get() == 0


def test_available_types(mbs: exu.MainSystem) -> None:
    types = mbs.GetAvailableFactoryItems()
    assert list(types) == ["Node", "Object", "Marker", "Load", "Sensor"]
    assert types["Load"] == ["LoadCoordinate", "LoadForceVector", "LoadMassProportional", "LoadTorqueVector"]


@pytest.mark.parametrize("load", ["LoadForceVector", "LoadTorqueVector"])
def test_a_load_turns_with_its_body_from_the_next_assembly_on(mbs: exu.MainSystem, load: str) -> None:
    """A quarter turn about z takes the first axis of the body into the second one."""
    turned = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    body = mbs.CreateRigidBody(inertia=InertiaSphere(2, 0.1), referenceRotationMatrix=turned)
    marker = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body))
    number = mbs.AddLoad(getattr(exu, load)(markerNumber=marker, loadVector=[3, 0, 0]))
    mbs.Assemble()
    node = mbs.GetObjectParameter(body, "nodeNumber")
    mbs.SetLoadParameter(number, "bodyFixed", True)
    with pytest.raises(RuntimeError, match=r"since mbs.Assemble\(\)\. Call mbs.Assemble\(\)"):
        mbs.GetNodeOutput(node, exu.OutputVariableType.Position)
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps, settings.timeIntegration.endTime = 10, 1e-3
    settings.timeIntegration.verboseMode = 0
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveDynamic(settings)
    kind = "Velocity" if load == "LoadForceVector" else "AngularVelocity"
    rate = mbs.GetNodeOutput(node, getattr(exu.OutputVariableType, kind))
    inertia = 2 if load == "LoadForceVector" else 0.4 * 2 * 0.1**2
    # The force turns no further; the torque turns the body about its own axis: both are constant.
    np.testing.assert_allclose(rate, [0, 3 * 1e-3 / inertia, 0], rtol=1e-7, atol=1e-12)


def test_reference_outputs_before_assembly_follow_every_change(mbs: exu.MainSystem) -> None:
    def position(body: Any) -> list[float]:
        reference = exu.ConfigurationType.Reference
        return mbs.GetObjectOutputBody(body, exu.OutputVariableType.Position, configuration=reference).tolist()

    nodes = [mbs.AddNode(exu.NodePoint(referenceCoordinates=[x, 0, 0])) for x in range(3)]
    bodies = [mbs.AddObject(exu.MassPoint(physicsMass=1, nodeNumber=node)) for node in nodes]
    assert [position(body) for body in bodies] == [[0, 0, 0], [1, 0, 0], [2, 0, 0]]
    mbs.SetNodeParameter(nodes[1], "referenceCoordinates", [5, 0, 0])
    assert [position(body) for body in bodies] == [[0, 0, 0], [5, 0, 0], [2, 0, 0]]
    mbs.ModifyObject(bodies[0], {"nodeNumber": nodes[2]})
    assert [position(body) for body in bodies] == [[2, 0, 0], [5, 0, 0], [2, 0, 0]]
    mbs.ModifyObject(bodies[0], {"nodeNumber": nodes[0]})
    mbs.DeleteObject(bodies[0])  # the others and their nodes move up
    assert [position(body) for body in bodies[:2]] == [[5, 0, 0], [2, 0, 0]]
    mbs.Reset()
    mbs.AddNode(exu.NodePoint(referenceCoordinates=[7, 0, 0]))
    assert position(mbs.AddObject(exu.MassPoint(physicsMass=1, nodeNumber=0))) == [7, 0, 0]


def test_sensors_added_after_assembling_may_be_declared_consistent() -> None:
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(exu.NodePoint(referenceCoordinates=[1, 2, 3]))
    mbs.AddObject(exu.ObjectMassPoint(nodeNumber=node, physicsMass=1))
    mbs.Assemble()
    sensor = mbs.AddSensor(exu.SensorNode(nodeNumber=node, outputVariableType=exu.OutputVariableType.Position))
    with pytest.raises(RuntimeError, match=r"Call mbs.Assemble\(\)"):
        mbs.GetSensorValues(sensor)
    mbs.systemIsConsistent = True
    assert list(mbs.GetSensorValues(sensor)) == [1, 2, 3]
    mbs.AddNode(exu.NodePoint())
    with pytest.raises(RuntimeError, match=r"mbs.systemIsConsistent: .* the equations are not those of the items"):
        mbs.systemIsConsistent = True
    assert not mbs.systemIsConsistent
    with pytest.raises(RuntimeError, match=r"Call mbs.Assemble\(\)"):
        mbs.GetNodeOutput(1, exu.OutputVariableType.Position)


def test_parameters_are_set_by_position_and_by_name() -> None:
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(exu.NodePoint(name="tip"))
    for given, named in (
        ((node, "referenceCoordinates", [1, 2, 3]), {}),
        (("tip", "referenceCoordinates"), {"value": (1.0, 2, 3)}),
        ((node,), {"value": np.array([1.0, 2.0, 3.0]), "parameterName": "referenceCoordinates"}),
        ((), {"nodeNumber": 0, "parameterName": "referenceCoordinates", "value": np.array([1, 2, 3])}),
    ):
        mbs.SetNodeParameter(node, "referenceCoordinates", [0, 0, 0])
        assert mbs.SetNodeParameter(*given, **named) is None
        np.testing.assert_array_equal(mbs.GetNodeParameter(node, "referenceCoordinates"), [1, 2, 3])
    with pytest.raises(TypeError, match="there is no argument 'val'. Did you mean 'value'"):
        mbs.SetNodeParameter(node, "referenceCoordinates", val=[0, 0, 0])
    with pytest.raises(TypeError, match="the argument 'parameterName' must be a text, received 3"):
        mbs.SetNodeParameter(node, 3, [0, 0, 0])


def test_entries_of_the_drawing_without_their_letter_have_no_effect() -> None:
    """Models of Exudyn have them, where they are ignored."""
    mbs = exu.SystemContainer().AddSystem()
    with pytest.warns(UserWarning, match="ObjectGround: 'graphicsData' has no effect, VgraphicsData has"):
        mbs.AddObject({"objectType": "Ground", "graphicsData": []})
    with pytest.raises(ValueError, match="there is no parameter 'graphics'"):
        mbs.AddObject({"objectType": "Ground", "graphics": []})


def test_open_contacts_of_cables_refuse_unknown_outputs() -> None:
    mbs = exu.SystemContainer().AddSystem()
    nodes = [mbs.AddNode(exu.NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0])) for x in (0, 1)]
    cable = mbs.AddObject(
        exu.Cable2D(
            physicsLength=1,
            physicsMassPerLength=1,
            physicsBendingStiffness=1,
            physicsAxialStiffness=1,
            nodeNumbers=nodes,
        )
    )
    disc = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=mbs.AddObject(exu.ObjectGround(referencePosition=[0, 3, 0]))))
    shape = mbs.AddMarker(exu.MarkerBodyCable2DShape(bodyNumber=cable, numberOfSegments=3))
    states = mbs.AddNode(
        exu.NodeGenericData(numberOfDataCoordinates=9, initialCoordinates=[1] * 3 + [-2] * 3 + [0] * 3)
    )
    contact = mbs.AddObject(
        exu.ObjectContactFrictionCircleCable2D(
            markerNumbers=[disc, shape], nodeNumber=states, contactStiffness=1e3, circleRadius=0.2
        )
    )
    mbs.Assemble()
    assert len(mbs.GetObjectOutput(contact, exu.OutputVariableType.ForceLocal)) == 6
    with pytest.raises(ValueError, match="has no output variable Position"):
        mbs.GetObjectOutput(contact, exu.OutputVariableType.Position)
