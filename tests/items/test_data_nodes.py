"""Nodes with data coordinates: of the size that the item needs, and only where it needs one."""

from __future__ import annotations

from typing import Any

import pytest
from scenes import DATA_COORDINATES, READY, Scene
from variants import ALL_VARIANTS

import dalembert as exu
from codegen.model import Item

ANY_SIZE = {"ObjectConnectorRigidBodySpringDamper"}  # only its user functions read the data
FRICTION = "ObjectConnectorCoordinateSpringDamperExt"
WITH_DATA = [item for item in READY if item.name in {v.item for v in ALL_VARIANTS if v.data} - ANY_SIZE]


def built(item: Item, **changes: Any) -> Scene:
    scene = next(v for v in ALL_VARIANTS if v.item == item.name and v.data).build()
    for key, value in changes.items():
        scene.mbs.SetObjectParameter(scene.target[1], key, value)
    return scene


@pytest.mark.parametrize("item", WITH_DATA, ids=lambda item: item.name)
@pytest.mark.parametrize("more", [-1, 1], ids=["fewer", "more"])
def test_number_of_data_coordinates(item: Item, more: int) -> None:
    n = DATA_COORDINATES.get(item.name, 3) + more
    scene = built(item)
    node = scene.mbs.AddNode(exu.NodeGenericData(numberOfDataCoordinates=n, initialCoordinates=[0] * n))
    scene.mbs.SetObjectParameter(scene.target[1], "nodeNumber", node)
    with pytest.raises(ValueError, match=rf"\({item.name}\).*'nodeNumber'.*{n} data coordinates.*= {n - more}"):
        scene.mbs.Assemble()


@pytest.mark.parametrize(
    ("changes", "needed"),
    [
        ({"frictionProportionalZone": 0.01}, False),
        ({"frictionProportionalZone": 0.0}, True),
        ({"frictionProportionalZone": 0.0, "fDynamicFriction": 0.0, "fStaticFrictionOffset": 0.0}, False),
        ({"frictionProportionalZone": 0.01, "useLimitStops": True}, True),
    ],
)
def test_friction_needs_data_for_bristles_and_stops_only(changes: dict[str, Any], needed: bool) -> None:
    item = next(item for item in READY if item.name == FRICTION)
    scene = built(item, nodeNumber=exu.NodeIndex(exu.InvalidIndex()), **changes)
    if needed:
        with pytest.raises(ValueError, match=rf"\({FRICTION}\), parameter 'nodeNumber': received the invalid index"):
            scene.mbs.Assemble()
    else:
        scene.mbs.Assemble()
        assert scene.mbs.systemIsConsistent
