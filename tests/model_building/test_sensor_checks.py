"""A sensor of something that its item does not have is refused by Assemble, not by a solver hours later."""

from __future__ import annotations

from typing import Any

import pytest

import dalembert as exu

Variable = exu.OutputVariableType


@pytest.fixture
def mbs() -> Any:
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(exu.NodePoint(name="tip"))
    body = mbs.AddObject(exu.ObjectMassPoint(name="ball", physicsMass=1, nodeNumber=node))
    ends = [mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=b)) for b in (mbs.AddObject(exu.ObjectGround()), body)]
    mbs.AddObject(exu.ObjectConnectorCartesianSpringDamper(name="spring", markerNumbers=ends))
    return mbs


REFUSED = [
    (exu.SensorNode(nodeNumber=0, outputVariableType=Variable.StressLocal), "StressLocal", "node 0 'tip'"),
    (exu.SensorBody(bodyNumber=0, outputVariableType=Variable.Force), "Force", "object 0 'ball'"),
    (
        exu.SensorObject(objectNumber=2, outputVariableType=Variable.RotationMatrix),
        "RotationMatrix",
        "object 2 'spring'",
    ),
    (exu.SensorMarker(markerNumber=0, outputVariableType=Variable.Force), "Force", "marker 0"),
    (exu.SensorNode(nodeNumber=0), "_None", "node 0 'tip'"),
]


@pytest.mark.parametrize(("sensor", "variable", "item"), REFUSED, ids=[f"{i} {v}" for _, v, i in REFUSED])
def test_refused_at_assemble(mbs: Any, sensor: Any, variable: str, item: str) -> None:
    mbs.AddSensor(sensor)
    text = rf"sensor 0 '.*' \(\w+\), parameter 'outputVariableType': received {variable}, .*output variable of {item}"
    with pytest.raises(ValueError, match=text):
        mbs.Assemble()
    assert not mbs.systemIsConsistent
    mbs.DeleteSensor(0)
    mbs.Assemble()


def test_values_that_follow_from_motion_are_accepted(mbs: Any) -> None:
    for sensor in (
        exu.SensorNode(nodeNumber=0, outputVariableType=Variable.Coordinates_tt),
        exu.SensorBody(bodyNumber=0, outputVariableType=Variable.VelocityLocal),
        exu.SensorObject(objectNumber=2, outputVariableType=Variable.Force),
        exu.SensorMarker(markerNumber=1, outputVariableType=Variable.Displacement),
    ):
        mbs.AddSensor(sensor)
    mbs.Assemble()
    assert [mbs.GetSensorValues(i).tolist() for i in range(4)] == [[0, 0, 0]] * 4


@pytest.mark.parametrize("configuration", [exu.ConfigurationType._None, exu.ConfigurationType.EndOfEnumList])
def test_configurations_without_a_state_are_refused(mbs: Any, configuration: Any) -> None:
    mbs.AddSensor(exu.SensorNode(nodeNumber=0, outputVariableType=Variable.Position))
    mbs.Assemble()
    for method, arguments in (("GetNodeOutput", (0, Variable.Position)), ("GetSensorValues", (0,))):
        text = rf"mbs\.{method}\(\.\.\.\), parameter 'configuration': .*Current, Initial, Reference"
        with pytest.raises(ValueError, match=text):
            getattr(mbs, method)(*arguments, configuration)
