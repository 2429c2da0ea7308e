"""Sensors with storeInternal: stored data of many sensors, over long and continued simulations."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu

VELOCITY = np.array([0.5, -2.0, 3.0])
STEP = 1e-3
VARIABLES = ("Position", "Velocity", "Coordinates")


def free_points() -> tuple[Any, list[Any]]:
    """Two free mass points; every other sensor stores."""
    mbs = exu.SystemContainer().AddSystem()
    sensors = []
    for i in range(2):
        node = mbs.AddNode(exu.NodePoint(referenceCoordinates=[i, 0, 0], initialVelocities=VELOCITY))
        mbs.AddObject(exu.ObjectMassPoint(physicsMass=1, nodeNumber=node))
        for name in VARIABLES:
            for store in (True, False):
                variable = getattr(exu.OutputVariableType, name)
                number = mbs.AddSensor(
                    exu.SensorNode(nodeNumber=node, outputVariableType=variable, storeInternal=store, writeToFile=False)
                )
                sensors.append((number, i, name, store))
    mbs.Assemble()
    return mbs, sensors


def solve(mbs: Any, steps: int, **changes: Any) -> None:
    settings = exu.SimulationSettings()
    time = settings.timeIntegration
    time.numberOfSteps, time.verboseMode = steps, 0
    time.endTime = time.startTime = changes.pop("startTime", 0.0)
    time.endTime += steps * STEP
    settings.solutionSettings.writeSolutionToFile = False
    settings.solutionSettings.sensorsWritePeriod = 0.9 * STEP
    for name, value in changes.items():
        setattr(settings.solutionSettings, name, value)
    mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.ExplicitEuler)


def check(mbs: Any, sensors: list[Any], times: np.ndarray[Any, Any]) -> None:
    """Free flight is uniform: explicit Euler adds up to it but for round-off, 1e-16 a step."""
    for number, point, name, store in sensors:
        if not store:
            with pytest.raises(ValueError, match="stored no values"):
                mbs.GetSensorStoredData(number)
            continue
        data = mbs.GetSensorStoredData(number)
        way = np.outer(times, VELOCITY)
        expected = {"Position": way + [point, 0, 0], "Velocity": 0 * way + VELOCITY, "Coordinates": way}[name]
        np.testing.assert_allclose(data, np.column_stack([times, expected]), rtol=0, atol=1e-10)


@pytest.mark.parametrize("steps", [3, 12_000])  # the latter are more rows than memory is reserved for at once
def test_rows_of_all_sensors(steps: int) -> None:
    mbs, sensors = free_points()
    solve(mbs, steps)
    check(mbs, sensors, STEP * np.arange(steps + 1))
    solve(mbs, 2)  # begins anew
    check(mbs, sensors, STEP * np.arange(3))


def test_appended_rows_follow() -> None:
    mbs, sensors = free_points()
    solve(mbs, 3)
    state = mbs.systemData.GetSystemState()
    mbs.systemData.SetSystemState(state, configuration=exu.ConfigurationType.Initial)
    solve(mbs, 2, startTime=3 * STEP, sensorsAppendToFile=True)
    check(mbs, sensors, STEP * np.array([0, 1, 2, 3, 3, 4, 5]))
