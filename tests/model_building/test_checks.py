"""Models that Assemble() rejects."""

from __future__ import annotations

import re
from contextlib import nullcontext
from typing import Any

import numpy as np
import pytest

import dalembert as exu


def wrong_node_number(mbs: exu.MainSystem) -> None:
    mbs.AddNode(exu.NodePoint())
    mbs.AddObject(exu.MassPoint(nodeNumber=5, physicsMass=1))


def no_node(mbs: exu.MainSystem) -> None:
    mbs.AddObject(exu.MassPoint("ball", nodeNumber=0, physicsMass=1))


def node_not_set(mbs: exu.MainSystem) -> None:
    mbs.AddObject(exu.MassPoint(physicsMass=1))


def wrong_node_type(mbs: exu.MainSystem) -> None:
    node = mbs.AddNode(exu.NodePoint())
    mbs.AddObject(exu.Mass1D(nodeNumber=node, physicsMass=1))


def node_too_large(mbs: exu.MainSystem) -> None:
    node = mbs.AddNode(exu.NodeGenericODE2(numberOfODE2Coordinates=2))
    mbs.AddObject(exu.Mass1D(nodeNumber=node, physicsMass=1))


def wrong_marker_type(mbs: exu.MainSystem) -> None:
    node = mbs.AddNode(exu.NodePoint())
    body = mbs.AddObject(exu.MassPoint(nodeNumber=node, physicsMass=1))
    marker = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=body))
    mbs.AddLoad(exu.LoadTorqueVector(markerNumber=marker, loadVector=[0, 0, 1]))


def follower_without_orientation(mbs: exu.MainSystem) -> None:
    node = mbs.AddNode(exu.NodeRigidBody2D())
    mbs.AddObject(exu.RigidBody2D(nodeNumber=node, physicsMass=1, physicsInertia=1))
    marker = mbs.AddMarker(exu.MarkerNodePosition(nodeNumber=node))
    mbs.AddLoad(exu.LoadForceVector(markerNumber=marker, loadVector=[0, 1, 0], bodyFixed=True))


def marker_on_connector(mbs: exu.MainSystem) -> None:
    ground = mbs.AddObject(exu.ObjectGround())
    marker = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=ground))
    other = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=ground))
    spring = mbs.AddObject(exu.SpringDamper(markerNumbers=[marker, other]))
    mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=spring))


def wrong_number_of_coordinates(mbs: exu.MainSystem) -> None:
    mbs.AddNode(exu.NodeGenericODE2(numberOfODE2Coordinates=2, referenceCoordinates=[0, 0, 0]))


def deleted_marker(mbs: exu.MainSystem) -> None:
    ground = mbs.AddObject(exu.ObjectGround())
    marker = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=ground))
    other = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=ground))
    mbs.AddObject(exu.SpringDamper(markerNumbers=[marker, other]))
    mbs.DeleteMarker(marker, suppressWarnings=True)


@pytest.mark.parametrize(
    ("build", "text"),
    [
        (wrong_node_number, "object 0 'object0' (ObjectMassPoint), parameter 'nodeNumber': received 5, but expected a number from 0 to 0. Add the node first and pass the index that AddNode(...) returned."),
        (no_node, "object 0 'ball' (ObjectMassPoint), parameter 'nodeNumber': received 0, but expected an existing node, and there is none."),
        (node_not_set, "object 0 'object0' (ObjectMassPoint), parameter 'nodeNumber': received the invalid index -1, but expected the number of a node."),
        (wrong_node_type, "object 0 'object0' (ObjectMass1D), parameter 'nodeNumber': received node 0 'node0' (NodePoint), which provides Position, but expected a node that provides GenericODE2."),
        (node_too_large, "object 0 'object0' (ObjectMass1D), parameter 'nodeNumber': received nodes with 2 coordinates together, but expected 1."),
        (wrong_marker_type, "load 0 'load0' (LoadTorqueVector), parameter 'markerNumber': received marker 0 'marker0' (MarkerBodyPosition), which provides Object, Body, Position, but expected a marker that provides Orientation."),
        (follower_without_orientation, "load 0 'load0' (LoadForceVector), parameter 'markerNumber': received marker 0 'marker0' (MarkerNodePosition), which has no orientation, but expected with bodyFixed = True a marker that provides Orientation."),
        (marker_on_connector, "marker 2 'marker2' (MarkerBodyPosition), parameter 'bodyNumber': received object 1 'object1' (ObjectConnectorSpringDamper), but expected a body (also ground, a finite element or a super element)."),
        (wrong_number_of_coordinates, "node 0 'node0' (NodeGenericODE2), parameter 'referenceCoordinates': received 3 values, but expected 2 values as numberOfODE2Coordinates is 2."),
        (deleted_marker, "object 1 'object1' (ObjectConnectorSpringDamper), parameter 'markerNumbers': received the invalid index -1, but expected the number of a marker."),
    ],
    ids=lambda value: getattr(value, "__name__", ""),
)  # fmt: skip
def test_assemble_refuses(mbs: exu.MainSystem, build: Any, text: str) -> None:
    build(mbs)
    with pytest.raises(ValueError, match="^" + re.escape(text)):
        mbs.Assemble()
    assert mbs.systemIsConsistent is False


@pytest.mark.parametrize(
    ("body", "node", "refused"),
    [
        (exu.MassPoint, exu.NodePoint, True),
        (exu.MassPoint2D, exu.NodePoint2D, True),
        (exu.Mass1D, exu.Node1D, False),  # its frame is a parameter
        (exu.RigidBody2D, exu.NodeRigidBody2D, False),
    ],
)
def test_points_have_no_orientation(mbs: exu.MainSystem, body: Any, node: Any, refused: bool) -> None:
    number = mbs.AddNode(node())
    marker = exu.MarkerBodyRigid(bodyNumber=mbs.AddObject(body(physicsMass=1, nodeNumber=number)))
    mbs.AddMarker(marker)
    text = f"(MarkerBodyRigid): this combination is not available: {body.__name__} with {node.__name__}."
    with pytest.raises(ValueError, match=re.escape(text)) if refused else nullcontext():
        mbs.Assemble()
    assert mbs.systemIsConsistent is not refused


@pytest.mark.parametrize("node", [exu.NodePoint, exu.NodePoint2D, exu.Node1D])
def test_points_have_no_rigid_frame(mbs: exu.MainSystem, node: Any) -> None:
    mbs.AddMarker(exu.MarkerNodeRigid(nodeNumber=mbs.AddNode(node())))
    with pytest.raises(ValueError, match=rf"\(MarkerNodeRigid\): this combination is not available: {node.__name__}\."):
        mbs.Assemble()


def test_reading_rejects_references_to_itself(mbs: exu.MainSystem) -> None:
    """A marker that is moved onto the connector that it belongs to, and read before Assemble."""
    ground = mbs.AddObject(exu.ObjectGround())
    markers = [mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=ground)) for _ in range(2)]
    spring = mbs.AddObject(exu.SpringDamper(markerNumbers=markers))
    mbs.ModifyMarker(markers[0], {"bodyNumber": spring})
    with pytest.raises(ValueError, match=r"marker 0 .* parameter 'bodyNumber': received object 1 .*SpringDamper"):
        mbs.GetMarkerOutput(markers[0], exu.OutputVariableType.Position, exu.ConfigurationType.Reference)


def test_values_that_do_not_fit_each_other_are_refused_when_set(mbs: exu.MainSystem) -> None:
    node = mbs.AddNode(exu.NodeRigidBodyRxyz())
    body = mbs.AddObject(exu.RigidBody(physicsMass=2, physicsInertia=[1, 1, 1, 0, 0, 0], nodeNumber=node))
    data = mbs.AddNode(exu.NodeGenericData(numberOfDataCoordinates=3, initialCoordinates=[0, 0, 0]))
    mbs.Assemble()
    with pytest.raises(ValueError, match="a principal moment about the center of mass is negative"):
        mbs.SetObjectParameter(body, "physicsCenterOfMass", [0, 0, 1])
    with pytest.raises(ValueError, match="received 2 values, but expected 3 values as numberOfDataCoordinates is 3"):
        mbs.SetNodeParameter(data, "initialCoordinates", [1, 2])
    np.testing.assert_array_equal(mbs.GetObject(body)["physicsCenterOfMass"], [0, 0, 0])
    np.testing.assert_array_equal(mbs.GetNode(data)["initialCoordinates"], [0, 0, 0])


def test_memory_that_is_not_there_is_named() -> None:
    with pytest.raises(MemoryError, match="there is not enough memory for this call"):
        exu.MatrixContainer().Initialize(2**31 - 1, 2**31 - 1)


def test_consistency_follows_the_structure(mbs: exu.MainSystem) -> None:
    node = mbs.AddNode(exu.NodePoint())
    mbs.AddObject(exu.MassPoint(nodeNumber=node, physicsMass=1))
    assert not mbs.systemIsConsistent
    mbs.Assemble()
    assert mbs.systemIsConsistent
    mbs.SetObjectParameter(0, "physicsMass", 2)
    assert mbs.systemIsConsistent
    mbs.AddNode(exu.NodePoint())
    assert not mbs.systemIsConsistent
    with pytest.raises(RuntimeError, match="items were added, deleted or connected differently since mbs.Assemble"):
        mbs.GetNodeOutput(0, exu.OutputVariableType.Position)
