"""Separate solution of one variation, and mechanisms to vary."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from oscillators import dynamic_settings

import dalembert as exu
from dalembert.itemInterface import (
    LoadTorqueVector,
    MarkerBodyRigid,
    MarkerNodeCoordinate,
    MarkerNodeRigid,
    NodePointGround,
    NodeRigidBody2D,
    ObjectConnectorCoordinate,
    ObjectGround,
    ObjectJointRevolute2D,
    ObjectRigidBody2D,
    SensorNode,
)

Variable = exu.OutputVariableType
Result = tuple[np.ndarray, np.ndarray, np.ndarray]  # values at the end, history and ODE2 coordinates of one variation


def settings(end: float = 0.5, steps: int = 50) -> Any:
    s = dynamic_settings(end, steps)
    s.timeIntegration.verboseMode = 0
    return s


def crank(rod: float) -> tuple[Any, list[Any], list[Any], list[Any]]:
    """A planar slider-crank, assembled: system, nodes, bodies and the markers at both ends of the rod."""
    mbs = exu.SystemContainer().AddSystem()
    length, masses = 0.1, (0.3, 0.5, 0.4)
    places = (length / 2, length + rod / 2, length + rod)
    nodes = [mbs.AddNode(NodeRigidBody2D(referenceCoordinates=[x, 0, 0])) for x in places]
    bodies = [
        mbs.AddObject(ObjectRigidBody2D(nodeNumber=node, physicsMass=m, physicsInertia=1e-3))
        for node, m in zip(nodes, masses, strict=True)
    ]
    ground = mbs.AddObject(ObjectGround())
    ends = []
    for first, x0, second, x1 in (
        (ground, 0.0, bodies[0], -length / 2),
        (bodies[0], length / 2, bodies[1], -rod / 2),
        (bodies[1], rod / 2, bodies[2], 0.0),
    ):
        pair = [
            mbs.AddMarker(MarkerBodyRigid(bodyNumber=b, localPosition=[x, 0, 0]))
            for b, x in ((first, x0), (second, x1))
        ]
        mbs.AddObject(ObjectJointRevolute2D(markerNumbers=pair))
        ends += pair
    rest = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
    for k in (1, 2):
        guided = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=nodes[2], coordinate=k))
        mbs.AddObject(ObjectConnectorCoordinate(markerNumbers=[rest, guided]))
    mbs.AddLoad(
        LoadTorqueVector(markerNumber=mbs.AddMarker(MarkerNodeRigid(nodeNumber=nodes[0])), loadVector=[0, 0, 0.3])
    )
    for variable in (Variable.Position, Variable.Velocity):
        mbs.AddSensor(SensorNode(nodeNumber=nodes[2], outputVariableType=variable, storeInternal=True))
    mbs.Assemble()
    return mbs, nodes, bodies, ends[3:5]


def alone(mbs: Any, solve: Callable[[], Any]) -> Result:
    """Solve one variation by itself; the expected result of SolveVariations."""
    solve()
    sensors = range(mbs.systemData.NumberOfSensors())
    tables = [np.asarray(mbs.GetSensorStoredData(sensor)) for sensor in sensors]
    values = np.hstack([np.atleast_1d(mbs.GetSensorValues(sensor)) for sensor in sensors])
    return values, np.hstack([tables[0], *(table[:, 1:] for table in tables[1:])]), mbs.systemData.GetODE2Coordinates()


def assert_equal(results: Any, wanted: list[Result]) -> None:
    assert results.success.all() and results.messages == [""] * len(wanted)
    for k, (values, history, coordinates) in enumerate(wanted):
        np.testing.assert_array_equal(results.sensorValues[k], values)
        np.testing.assert_array_equal(results.sensorHistories[k], history)
        np.testing.assert_array_equal(results.coordinates["ODE2"][k], coordinates)
