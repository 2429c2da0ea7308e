"""Nodes with data coordinates: it has the size that the item needs, and is required only by items that need one."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from codegen.model import Item
from dalembert.testing.exemptions import DATA_OF_ANY_SIZE
from dalembert.testing.scenes import READY, Scene
from dalembert.testing.variants import ALL_VARIANTS

FRICTION = "ObjectConnectorCoordinateSpringDamperExt"
WITH_DATA = [item for item in READY if item.name in {v.item for v in ALL_VARIANTS if v.data} - set(DATA_OF_ANY_SIZE)]


def built(item: Item, **changes: Any) -> Scene:
    scene = next(v for v in ALL_VARIANTS if v.item == item.name and v.data).build()
    for key, value in changes.items():
        scene.mbs.SetObjectParameter(scene.target[1], key, value)
    return scene


def check_number_of_data_coordinates(item: Item, more: int) -> None:
    n = item.scene.data + more
    scene = built(item)
    node = scene.mbs.AddNode(exu.NodeGenericData(numberOfDataCoordinates=n, initialCoordinates=[0] * n))
    scene.mbs.SetObjectParameter(scene.target[1], "nodeNumber", node)
    with pytest.raises(ValueError, match=rf"\({item.name}\).*'nodeNumber'.*{n} data coordinates.*= {n - more}"):
        scene.mbs.Assemble()


@pytest.mark.parametrize("item", WITH_DATA, ids=lambda item: item.name)
@pytest.mark.parametrize("more", [-1, 1], ids=["fewer", "more"])
def test_number_of_data_coordinates(item: Item, more: int) -> None:
    check_number_of_data_coordinates(item, more)


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


def test_function_after_newton_reads_and_writes_the_data_of_its_connector() -> None:
    """Two data coordinates: how many steps were completed, and how far the body fell in all of them."""

    def update(mbs: Any, t: float, item: int, data: list[float], displacement: list[float], *rest: Any) -> list[float]:
        return [0, -1, data[0] + 1, displacement[0]]

    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(exu.NodeRigidBodyRxyz(initialVelocities=[2, 0, 0, 0, 0, 0]))
    body = mbs.AddObject(exu.ObjectRigidBody(nodeNumber=node, physicsMass=1, physicsInertia=[1, 1, 1, 0, 0, 0]))
    markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=b)) for b in (mbs.AddObject(exu.ObjectGround()), body)]
    data = mbs.AddNode(exu.NodeGenericData(initialCoordinates=[0, 0], numberOfDataCoordinates=2))
    mbs.AddObject(
        exu.ObjectConnectorRigidBodySpringDamper(
            markerNumbers=markers, nodeNumber=data, postNewtonStepUserFunction=update
        )
    )
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = 4
    settings.timeIntegration.endTime = 0.5
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveDynamic(settings)
    # The body moves at 2 m/s without forces; round-off of four steps.
    np.testing.assert_allclose(mbs.systemData.GetDataCoordinates(), [4, 1], rtol=0, atol=1e-14)
