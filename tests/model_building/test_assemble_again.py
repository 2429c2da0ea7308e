"""Assemble of a model that has not changed: only the configurations start anew, with the results of a new system."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert.utilities import InertiaCuboid

INITIAL, REFERENCE = exu.ConfigurationType.Initial, exu.ConfigurationType.Reference
KINDS = ("ODE2Coordinates", "ODE2Coordinates_t", "ODE2Coordinates_tt", "ODE1Coordinates", "AECoordinates")


def friction(mbs: exu.MainSystem) -> None:
    """A mass that sticks and slips, with data coordinates of its friction."""
    node = mbs.AddNode(exu.Node1D(initialVelocities=[2]))
    mbs.AddObject(exu.Mass1D(nodeNumber=node, physicsMass=1))
    data = mbs.AddNode(exu.NodeGenericData(initialCoordinates=[1, 0, 0], numberOfDataCoordinates=3))
    markers = [
        mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(exu.NodePointGround()), coordinate=0)),
        mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=0)),
    ]
    spring = exu.CoordinateSpringDamperExt(
        markerNumbers=markers,
        nodeNumber=data,
        stiffness=300,
        fDynamicFriction=5,
        fStaticFrictionOffset=2,
        stickingStiffness=1e4,
        stickingDamping=10,
        exponentialDecayStatic=0.01,
    )
    mbs.AddObject(spring)


def pendulum(mbs: exu.MainSystem) -> None:
    """A rigid body at a joint, and a load by a user function that depends on the motion."""
    inertia = InertiaCuboid(1000, [0.1, 0.1, 0.4])
    body = mbs.CreateRigidBody(
        inertia=inertia, referencePosition=[0.2, 0, 0], initialAngularVelocity=[0, 0, 3], gravity=[0, -9.81, 0]
    )
    mbs.CreateSphericalJoint(bodyNumbers=[body, mbs.CreateGround()], position=[0, 0, 0])
    tip = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body, localPosition=[0.2, 0, 0]))
    speed = mbs.AddSensor(
        exu.SensorBody(bodyNumber=body, outputVariableType=exu.OutputVariableType.Velocity, storeInternal=True)
    )

    def drag(mbs: exu.MainSystem, t: float, load: Any) -> Any:
        return -3.0 * mbs.GetSensorValues(speed) + [0, np.sin(20 * t), 0]

    mbs.AddLoad(exu.LoadForceVector(markerNumber=tip, loadVectorUserFunction=drag))


def first_order(mbs: exu.MainSystem) -> None:
    node = mbs.AddNode(
        exu.NodeGenericODE1(numberOfODE1Coordinates=2, referenceCoordinates=[1, 2], initialCoordinates=[3, 4])
    )
    mbs.AddObject(exu.ObjectGenericODE1(nodeNumbers=[node], systemMatrix=[[-1, 2], [-2, -1]]))


MODELS = [friction, pendulum, first_order]
Model = Callable[[exu.MainSystem], None]


def state(mbs: exu.MainSystem, *configuration: exu.ConfigurationType) -> list[Any]:
    data = mbs.systemData
    kinds = [kind for kind in (*KINDS, "DataCoordinates") if not (configuration and kind.endswith("_tt"))]
    return [getattr(data, "Get" + kind)(*configuration).tolist() for kind in kinds] + [data.GetTime()]


def solve(mbs: exu.MainSystem) -> list[Any]:
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps, settings.timeIntegration.endTime = 200, 0.4
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveDynamic(settings)
    return state(mbs)


def assembled_anew(model: Model) -> exu.MainSystem:
    mbs = exu.SystemContainer().AddSystem()
    model(mbs)
    mbs.Assemble()
    return mbs


@pytest.mark.parametrize("model", MODELS)
def test_all_configurations_start_anew(mbs: exu.MainSystem, model: Model) -> None:
    model(mbs)
    mbs.Assemble()
    start, initial = state(mbs), state(mbs, INITIAL)
    data = mbs.systemData
    moved = solve(mbs)
    assert moved != start
    data.SetODE2Coordinates(np.array(data.GetODE2Coordinates(INITIAL)) + 1, INITIAL)
    data.SetODE1Coordinates(np.array(data.GetODE1Coordinates(INITIAL)) + 1, INITIAL)
    mbs.Assemble()
    assert state(mbs) == start
    assert state(mbs, INITIAL) == initial
    assert start[-1] == 0.0


@pytest.mark.parametrize("model", MODELS)
def test_results_are_those_of_a_new_system(mbs: exu.MainSystem, model: Model) -> None:
    model(mbs)
    mbs.Assemble()
    solve(mbs)
    mbs.Assemble()
    mbs.Assemble()
    assert solve(mbs) == solve(assembled_anew(model))


def test_changed_parameters_and_start_values_are_taken_over(mbs: exu.MainSystem) -> None:
    def changed(system: exu.MainSystem) -> None:
        system.SetObjectParameter(0, "physicsMass", 1.5)
        system.SetNodeParameter(0, "initialVelocities", [1.0])

    friction(mbs)
    mbs.Assemble()
    solve(mbs)
    mbs.Assemble()
    changed(mbs)
    mbs.Assemble()
    expected = exu.SystemContainer().AddSystem()
    friction(expected)
    changed(expected)
    expected.Assemble()
    assert state(mbs) == state(expected)
    assert solve(mbs) == solve(expected)


def test_added_items_are_taken_over(mbs: exu.MainSystem) -> None:
    def push(system: exu.MainSystem) -> None:
        marker = system.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=0, coordinate=0))
        system.AddLoad(exu.LoadCoordinate(markerNumber=marker, load=7.0))

    friction(mbs)
    mbs.Assemble()
    before = solve(mbs)
    mbs.Assemble()
    push(mbs)
    mbs.Assemble()
    expected = exu.SystemContainer().AddSystem()
    friction(expected)
    push(expected)
    expected.Assemble()
    after = solve(mbs)
    assert after == solve(expected)
    assert after != before


@pytest.mark.parametrize("copy", [True, False])
def test_arrays_of_states_keep_their_values(mbs: exu.MainSystem, copy: bool) -> None:
    pendulum(mbs)
    mbs.Assemble()
    solve(mbs)
    array = mbs.systemData.GetODE2Coordinates(copy=copy)
    before = array.tolist()
    for _ in range(2):
        mbs.Assemble()
        assert array.tolist() == before
        assert mbs.systemData.GetODE2Coordinates().tolist() != before
