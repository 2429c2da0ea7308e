"""Values of sensors agree with outputs of their items, at any time and in stored data; two successive runs store the
same data as two new systems."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import dalembert as exu
from codegen.model import Item
from dalembert.testing.output_rates import items_of
from dalembert.testing.outputs import CONFIGURATIONS
from dalembert.testing.repeated_solves import build, settings, solvable
from dalembert.testing.scenes import ITEMS, RIGID, UNDER_TEST, Scene, is_ground
from dalembert.testing.variants import Variant, variants_with

SENSED = [item for item in UNDER_TEST if item.outputs]
Read = Callable[[Any], np.ndarray]
LOCAL = [0.1, 0.2, 0]


def numbers(value: Any) -> Any:
    """The value as a sensor has it: a rigid transformation has its 16 numbers row by row."""
    return value.HT44().ravel() if isinstance(value, exu.HT) else value


def model_with(item: Item, seed: int) -> Scene:
    if is_ground((item.name, "")):
        scene = build(Variant("ObjectMassPoint", (("", RIGID["NodeRigidBodyEP"]),) * 2), seed)
        scene.mbs.AddObject(exu.ObjectGround(referencePosition=[1, 2, 3]))
        return scene
    return build(next(v for v in variants_with(item) if solvable(v)), seed)


def sensors_of(scene: Scene) -> list[tuple[Any, Read]]:
    """A sensor for each output of each item, with the function that reads the output."""
    mbs, pairs = scene.mbs, []

    def add(cls: Any, read: Read, **rows: Any) -> None:
        pairs.append((mbs.AddSensor(cls(storeInternal=True, writeToFile=False, **rows)), read))

    for kind, number, item in items_of(scene):
        for output in item.outputs:
            variable = getattr(exu.OutputVariableType, output.name)
            row = {"outputVariableType": variable}
            if kind == "Node":
                add(
                    exu.SensorNode, lambda c, n=number, v=variable: mbs.GetNodeOutput(n, v, c), nodeNumber=number, **row
                )
            elif item.object_type in ("Body", "FiniteElement"):
                add(
                    exu.SensorBody,
                    lambda c, n=number, v=variable: mbs.GetObjectOutputBody(n, v, LOCAL, c),
                    bodyNumber=number,
                    localPosition=LOCAL,
                    **row,
                )
            else:
                add(
                    exu.SensorObject,
                    lambda c, n=number, v=variable: mbs.GetObjectOutput(n, v, c),
                    objectNumber=number,
                    **row,
                )
        if item.object_type == "SuperElement" and "MarkerSuperElementPosition" in ITEMS:
            variable = exu.OutputVariableType.Velocity
            add(
                exu.SensorSuperElement,
                lambda c, n=number, v=variable: mbs.GetObjectOutputSuperElement(n, v, 1, c),
                bodyNumber=number,
                meshNodeNumber=1,
                outputVariableType=variable,
            ) if len(mbs.GetObject(number).get("nodeNumbers", [])) > 1 else None
    for number, entry in enumerate(mbs.GetDictionary()["markerList"]):
        if "Position" in ITEMS[f"Marker{entry['markerType']}"].provides:
            variable = exu.OutputVariableType.Position
            add(
                exu.SensorMarker,
                lambda c, n=number, v=variable: mbs.GetMarkerOutput(n, v, c),
                markerNumber=number,
                outputVariableType=variable,
            )
    for number in range(len(mbs.GetDictionary()["loadList"])):
        add(exu.SensorLoad, lambda c, n=number: mbs.GetLoadValues(n), loadNumber=number)

    def twice(mbs: Any, t: float, sensors: Any, factors: Any, configuration: Any) -> Any:
        return 2 * np.atleast_1d(mbs.GetSensorValues(sensors[0], configuration))

    first, read = pairs[0]
    add(
        exu.SensorUserFunction,
        lambda c: 2 * np.atleast_1d(read(c)),
        sensorNumbers=[first],
        sensorUserFunction=twice,
    )
    mbs.Assemble()
    return pairs


@pytest.mark.parametrize("item", SENSED, ids=lambda item: item.name)
def test_sensors_agree_with_outputs(item: Item) -> None:
    scene = model_with(item, seed=81)
    for sensor, read in sensors_of(scene):
        for configuration in CONFIGURATIONS:
            np.testing.assert_array_equal(
                scene.mbs.GetSensorValues(sensor, configuration), numbers(read(configuration))
            )


@pytest.mark.parametrize("item", SENSED, ids=lambda item: item.name)
def test_stored_values_of_sensors(item: Item) -> None:
    """The sensor agrees with a function that is called after every step; the second of two runs stores the same data as
    a new system."""
    histories = []
    for runs in (2, 1):
        scene = model_with(item, seed=82)
        pairs = sensors_of(scene)
        for _ in range(runs):
            told: list[list[np.ndarray]] = []
            scene.mbs.SetPostStepUserFunction(
                lambda mbs, t, pairs=pairs, told=told: bool(
                    told.append([np.ravel(read(exu.ConfigurationType.Current)) for _, read in pairs]) is None
                )
            )
            s = settings()
            s.solutionSettings.sensorsWritePeriod = 0
            scene.mbs.SolveDynamic(s)
        stored = [scene.mbs.GetSensorStoredData(sensor) for sensor, _ in pairs]
        for k, history in enumerate(stored):
            np.testing.assert_array_equal(history[:, 1:], [values[k] for values in told])
        histories.append(stored)
    for first, second in zip(*histories, strict=True):
        np.testing.assert_array_equal(first, second)
