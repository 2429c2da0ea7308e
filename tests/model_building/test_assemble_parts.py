"""The parts of Assemble: numbering follows the items, start values are taken over when they are asked for."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu

V, POSITION = exu.OutputVariableType.Velocity, exu.OutputVariableType.Position
INITIAL = exu.ConfigurationType.Initial


@pytest.fixture
def point(mbs: exu.MainSystem) -> exu.NodeIndex:
    node = mbs.AddNode(exu.NodePoint(initialVelocities=[1, 0, 0]))
    mbs.AddObject(exu.MassPoint(nodeNumber=node, physicsMass=1))
    mbs.Assemble()
    return node


def velocities(mbs: exu.MainSystem) -> list[Any]:
    return [mbs.systemData.GetODE2Coordinates_t().tolist(), mbs.systemData.GetODE2Coordinates_t(INITIAL).tolist()]


def test_initial_values_are_taken_over_on_request(mbs: exu.MainSystem, point: exu.NodeIndex) -> None:
    mbs.SetNodeParameter(point, "initialVelocities", [2, 0, 0])
    mbs.SetNodeParameter(point, "initialCoordinates", [0, 5, 0])
    assert velocities(mbs) == [[1, 0, 0], [1, 0, 0]]
    mbs.AssembleInitializeSystemCoordinates()
    assert velocities(mbs) == [[2, 0, 0], [2, 0, 0]]
    assert mbs.GetNodeOutput(point, POSITION).tolist() == [0, 5, 0]
    mbs.SetNodeParameter(point, "initialVelocities", [3, 0, 0])
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = 1
    mbs.SolveDynamic(settings)
    np.testing.assert_allclose(mbs.GetNodeOutput(point, POSITION), [2, 5, 0], rtol=1e-14)
    mbs.AssembleInitializeSystemCoordinates()
    mbs.SolveDynamic(settings)
    np.testing.assert_allclose(mbs.GetNodeOutput(point, POSITION), [3, 5, 0], rtol=1e-14)


def test_the_other_parts_keep_the_state(mbs: exu.MainSystem, point: exu.NodeIndex) -> None:
    mbs.systemData.SetODE2Coordinates_t([7, 7, 7])
    for part in ("AssembleCoordinates", "AssembleLTGLists", "AssembleSystemInitialize"):
        getattr(mbs, part)()
        assert velocities(mbs) == [[7, 7, 7], [1, 0, 0]]
    mbs.AssembleInitializeSystemCoordinates()
    assert velocities(mbs) == [[1, 0, 0], [1, 0, 0]]


def test_the_parts_together_assemble(mbs: exu.MainSystem, point: exu.NodeIndex) -> None:
    mbs.AddObject(exu.MassPoint(nodeNumber=mbs.AddNode(exu.NodePoint()), physicsMass=1))
    assert not mbs.systemIsConsistent
    mbs.AssembleCoordinates()
    mbs.AssembleLTGLists()
    mbs.AssembleInitializeSystemCoordinates()
    mbs.AssembleSystemInitialize()
    assert mbs.systemIsConsistent
    assert mbs.systemData.GetObjectLTGODE2(1) == [3, 4, 5]


def test_reference_coordinates_ask_for_assemble(mbs: exu.MainSystem, point: exu.NodeIndex) -> None:
    mbs.SetNodeParameter(point, "referenceCoordinates", [5, 0, 0])
    assert not mbs.systemIsConsistent
    with pytest.raises(RuntimeError, match=r"Call mbs\.Assemble\(\)"):
        mbs.GetNodeOutput(point, POSITION)
    mbs.AssembleInitializeSystemCoordinates()
    assert mbs.GetNodeOutput(point, POSITION).tolist() == [5, 0, 0]


def test_ground_nodes_move_at_once(mbs: exu.MainSystem, point: exu.NodeIndex) -> None:
    ground = mbs.AddNode(exu.NodePointGround())
    markers = [mbs.AddMarker(exu.MarkerNodePosition(nodeNumber=node)) for node in (ground, point)]
    spring = mbs.AddObject(exu.SpringDamper(markerNumbers=markers))
    mbs.Assemble()
    mbs.SetNodeParameter(ground, "referenceCoordinates", [3, 4, 0])
    assert mbs.systemIsConsistent
    assert mbs.GetNodeOutput(ground, POSITION).tolist() == [3, 4, 0]
    assert mbs.GetObjectOutput(spring, exu.OutputVariableType.Distance) == 5


@pytest.mark.parametrize(
    ("most", "node"), [(2**31 - 1, exu.NodePoint()), (2**31 - 3, exu.NodePoint()), (2**31 - 1, exu.NodeGenericData())]
)
def test_more_coordinates_than_numbers_are_refused(mbs: exu.MainSystem, most: int, node: Any) -> None:
    """Checked before memory is allocated; the node at which the limit is passed is named."""
    node.name = "last"
    first = mbs.AddNode(exu.NodeGenericData(initialCoordinates=[]))
    mbs.AddNode(node)
    mbs.SetNodeParameter(first, "numberOfDataCoordinates", most)
    if isinstance(node, exu.NodeGenericData):
        mbs.SetNodeParameter(1, "numberOfDataCoordinates", 2**31 - 1)
        mbs.SetNodeParameter(1, "initialCoordinates", [])
    with pytest.raises(
        ValueError, match=r"node 1 'last' \(Node.*the system has \d+: expected at most 2147483647 coordinates"
    ):
        mbs.Assemble()
