"""exu.types: facts of items, and that the combinations that it states can be assembled, or are refused."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert import types


def test_facts_of_an_item() -> None:
    facts = types.ItemInfo("ObjectMassPoint")
    assert facts["kind"] == "Object"
    assert "KineticEnergy" in facts["outputVariables"]
    assert facts["otherNames"] == {"mass": "physicsMass"}
    assert types.Parameters("ObjectMassPoint")["physicsMass"]["unit"] == "kg"
    assert types.Parameters("ObjectMassPoint")["physicsMass"]["range"] == ">= 0"
    assert types.items["ObjectMassPoint"] is facts
    assert set(types.ItemNames("Marker")) < set(types.ItemNames())
    assert len(types.ItemNames()) == len(types.items) > 90
    for name, each in types.items.items():
        assert list(each["parameters"])[0] == "name"
        item = getattr(exu, name)()
        assert all(hasattr(item, parameter) for parameter in each["parameters"])


def test_markers_on_trees() -> None:
    """Links have markers of their own; a tree has no frame, and no mesh nodes."""
    found = types.MarkersForObject("ObjectKinematicTree")
    assert found == ["MarkerKinematicTreeRigid", "MarkerObjectODE2Coordinates"]
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(exu.NodeGenericODE2(numberOfODE2Coordinates=1, referenceCoordinates=[0]))
    tree = mbs.AddObject(
        exu.ObjectKinematicTree(
            nodeNumber=node,
            jointTypes=[exu.JointType.RevoluteZ],
            linkParents=[-1],
            jointTransformations=exu.Matrix3DList([np.eye(3)]),
            jointOffsets=exu.Vector3DList([[0, 0, 0]]),
            linkInertiasCOM=exu.Matrix3DList([np.eye(3)]),
            linkCOMs=exu.Vector3DList([[0, 0, 0]]),
            linkMasses=[1],
        )
    )
    mbs.AddMarker(exu.MarkerSuperElementRigid(bodyNumber=tree, meshNodeNumbers=[0], weightingFactors=[1]))
    with pytest.raises(ValueError, match="meshNodeNumbers"):
        mbs.Assemble()


def test_partners() -> None:
    assert "NodePoint" in types.NodesForObject("ObjectMassPoint")
    assert "ObjectConnectorSpringDamper" in types.ConnectorsForMarkers("MarkerBodyPosition", "MarkerBodyRigid")
    assert "ObjectJointGeneric" not in types.ConnectorsForMarkers("MarkerBodyPosition", "MarkerBodyRigid")
    assert types.LoadsForMarker("MarkerBodyMass") == ["LoadMassProportional"]
    for text, call in {
        "there is no item 'MassPoint'": lambda: types.ItemInfo("MassPoint"),
        "ObjectGround is no marker": lambda: types.LoadsForMarker("ObjectGround"),
        "kind: expected one of Node, Object": lambda: types.ItemNames("Body"),
    }.items():
        with pytest.raises(ValueError, match=text):
            call()


def body(mbs: Any, name: str) -> Any:
    """Add a body of a type with its first kind of node."""
    if name == "ObjectGround":
        return mbs.AddObject(exu.ObjectGround())
    nodes = types.NodesForObject(name)
    node = "Node1D" if "Node1D" in nodes else nodes[0]
    return mbs.AddObject(getattr(exu, name)(nodeNumber=mbs.AddNode(getattr(exu, node)()), physicsMass=1))


@pytest.mark.parametrize(
    "name", ["ObjectGround", "ObjectMassPoint", "ObjectMassPoint2D", "ObjectMass1D", "ObjectRigidBody2D"]
)
@pytest.mark.parametrize("marker", ["MarkerBodyMass", "MarkerBodyPosition", "MarkerBodyRigid"])
def test_markers_on_bodies(name: str, marker: str) -> None:
    mbs = exu.SystemContainer().AddSystem()
    mbs.AddMarker(getattr(exu, marker)(bodyNumber=body(mbs, name)))
    if marker in types.MarkersForObject(name):
        assert name in types.ObjectsForMarker(marker)
        mbs.Assemble()
    else:
        assert name not in types.ObjectsForMarker(marker)
        with pytest.raises(ValueError, match="this combination is not available"):
            mbs.Assemble()
