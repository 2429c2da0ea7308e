"""Arguments that a function cannot use are refused with its name and theirs, not by libraries that it calls."""

from __future__ import annotations

import io
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert import FEM, graphics, interactive, processing, utilities
from dalembert.processing import VariedModel

TRIPLETS = np.array([[0, 1, 2.0], [1, 0, 3.0]])
TABLES = {"mass": np.array([[1.0, 2.0], [3.0, 4.0]])}
SETTINGS = exu.SimulationSettings()
NOTHING = object()


@pytest.fixture
def calls() -> dict[str, tuple[Callable[..., Any], dict[str, Any]]]:
    """Functions with arguments that they take."""
    mbs = exu.SystemContainer().AddSystem()
    ground, mass = mbs.CreateGround(), mbs.CreateMassPoint(physicsMass=1)
    mbs.CreateSpringDamper(bodyNumbers=[ground, mass], stiffness=1, name="spring")
    sensor = mbs.AddSensor(exu.SensorBody(bodyNumber=mass, outputVariableType=exu.OutputVariableType.Position))
    mbs.Assemble()
    file, sensitivity = io.BytesIO(b"\0" * 40), {"valRef": [1, 2], "valuesSorted": TABLES, "sensitivity": [[1, 2]]}
    dialog = {
        "mbs": mbs,
        "simulationSettings": SETTINGS,
        "simulationFunction": lambda mbs, dialog: 0,
        "dialogItems": [],
    }
    varied = {"mbs": mbs, "parameters": {"k": ("spring", "stiffness")}, "result": sensor}
    modes = {"systemContainer": mbs.GetSystemContainer(), "mainSystem": mbs, "nodeNumber": None}
    return {
        "MapSparseMatrixIndices": (FEM.MapSparseMatrixIndices, {"matrix": TRIPLETS.copy(), "sorting": [1, 0]}),
        "RotationMatrix2D": (utilities.RotationMatrix2D, {"angleRad": 0.1}),
        "BinaryReadIndex": (utilities.BinaryReadIndex, {"file": file, "intType": np.int32}),
        "BinaryReadReal": (utilities.BinaryReadReal, {"file": file, "realType": float}),
        "BinaryReadArrayIndex": (utilities.BinaryReadArrayIndex, {"file": file, "intType": "<i4"}),
        "BinaryReadString": (utilities.BinaryReadString, {"file": file, "intType": "<i4"}),
        "BinaryReadRealVector": (utilities.BinaryReadRealVector, {"file": file, "intType": "i4", "realType": "f8"}),
        "DrawSystemGraph": (utilities.DrawSystemGraph, {"mbs": mbs, "showGraph": False}),
        "Cylinder": (graphics.Cylinder, {"radiusInner": 0.05}),
        "InteractiveDialog": (interactive.InteractiveDialog, dialog),
        "VariedModel": (VariedModel, varied),
        "PlotSensitivityResults": (processing.PlotSensitivityResults, sensitivity),
        "LoadBinarySolutionFile": (utilities.LoadBinarySolutionFile, {"fileName": "none.sol"}),
        "RecoverSolutionFile": (utilities.RecoverSolutionFile, {"fileName": "none.txt", "newFileName": "new.txt"}),
        "ConvertImages2Video": (interactive.ConvertImages2Video, {}),
        "SolutionViewer": (interactive.SolutionViewer, {"mainSystem": mbs}),
        "AnimateModes": (interactive.AnimateModes, modes | {"systemEigenVectors": np.eye(3)}),
    }


SLIDER = {"type": "slider", "variable": "speed"}
RADIO = {"type": "radio", "variable": "speed"}
ITEMS: list[Any] = [
    5, {}, {"type": ["label"]}, {"type": "entry", "variable": 5}, {"type": "entry", "variable": "speed", "value": NOTHING},
    {"type": "button", "callFunction": 5}, *({"type": "label", "text": "x", "grid": grid} for grid in (5, (1,), (0, "x"), [(0, -1)])),
    *(SLIDER | {"range": ends} for ends in (5, (1,), ("x", "y"), (2, 1))), SLIDER | {"value": "x"}, SLIDER | {"steps": 0},
    *(RADIO | {"textValueList": pairs} for pairs in (5, [], [5], [("x",)], [("x", NOTHING)])),
]  # fmt: skip
WRONG: dict[str, dict[str, list[Any]]] = {
    "MapSparseMatrixIndices": {"matrix": [None, [[0, 1, 2.0]], TRIPLETS[0]], "sorting": [None, [0], [-1, 0], "ab"]},
    "RotationMatrix2D": {"angleRad": [None, "x", 10**400]},
    "BinaryReadIndex": {"file": [None, "name", io.StringIO()], "intType": [None, "no type", float]},
    "BinaryReadReal": {"file": [1], "realType": [None, str]},
    "BinaryReadArrayIndex": {"file": [[]], "intType": [float]},
    "BinaryReadString": {"file": [{}], "intType": [NOTHING]},
    "BinaryReadRealVector": {"file": [None], "intType": ["f8"], "realType": [NOTHING]},
    "DrawSystemGraph": {
        "mbs": [None, 3], "showLoads": ["yes"], "fontSizeFactor": [None, 10**30, 0], "layoutDistanceFactor": [0, "x"],
        "layoutIterations": [-1, 10**30, 1.5],
    },
    "Cylinder": {
        "pAxis": [None, [1, 2]], "color": ["red"], "edgeColor": [[1, 0]], "radiusInner": [-1, "x"],
        "nTiles": [10**30], "angleRange": [1],
    },
    "InteractiveDialog": {
        "mbs": [None, 3], "simulationFunction": [None], "period": [0, "x"], "realtimeFactor": [-1], "title": [[1], 1j],
        "plots": [
            "x", [1], {"sensors": 5}, {"sensors": ["a"]}, {"sensors": [[(0, 0)]]}, {"sensors": [[(0, 0), (99, 1)]]},
            {"sensors": [[(0, 0), (0, -1)]]}, {"nPoints": 0},
        ],
        "dialogItems": [None, 5, *([item] for item in ITEMS)], "userOnChange": [3], "userStartSimulation": ["x"], "fontSize": [10**30], "runOnStart": ["x"],
    },
    "VariedModel": {
        "mbs": [None], "parameters": ["x", [1], {}], "result": [None, 99, "none"], "simulationSettings": [1],
        "solverType": ["RK44"], "numberOfThreads": [1.5],
    },
    "PlotSensitivityResults": {
        "valRef": [None, [1], [None, "x"]], "valuesSorted": [None, {}, {"mass": [[1], [2]]}, {"mass": "x"}],
        "sensitivity": ["x", [], np.zeros((2, 2))], "fVar": ["x", np.nan, [1, 2]], "strYAxis": [3, ["a"], [1, 2]],
    },
    "LoadBinarySolutionFile": {"fileName": [None, 3], "maxRows": [1.5, 10**30, -2], "safeMode": ["x"]},
    "RecoverSolutionFile": {"fileName": [None], "verbose": ["x", 1.5]},
    "ConvertImages2Video": {
        "workingDir": [None, 5, ""], "inputPattern": [None, 7, "", "frame.png"], "outputFile": [5, ""],
        "inputFrameRate": [0, "x", np.nan], "outputFrameRate": [-3, "x"], "compressionCRF": [-1, 52, "x", 2.5],
        "startNumber": [-1, "x"], "totalFrames": [0, "x"],
    },
    "SolutionViewer": {
        "solution": [5, {}, {"data": "x", "nRows": 1, "columnsExported": [0] * 7}], "mainSystem": [None], "fontSize": ["x"], "runOnStart": ["x"], "timeout": [0],
    },
    "AnimateModes": {
        "systemContainer": [None], "mainSystem": [3], "stepsPerPeriod": [0, 10**30], "showTime": ["x"],
        "renderWindowText": [3], "systemEigenVectors": [None, "x"],
    },
}  # fmt: skip


@pytest.mark.parametrize("name", WRONG)
def test_refusals_name_function_and_argument(calls: dict[str, Any], name: str) -> None:
    function, arguments = calls[name]
    for argument, values in WRONG[name].items():
        for value in values:
            with pytest.raises((ValueError, TypeError, IndexError)) as refused:
                function(**(arguments | {argument: value}))
            assert str(refused.value).removeprefix("graphics.").startswith(f"{name}: {argument}"), (argument, value)
