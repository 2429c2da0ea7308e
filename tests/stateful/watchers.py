"""Functions of the user that read, write and raise while a solver runs; pickle finds them by their names."""

from __future__ import annotations

import contextlib
import copy
from collections.abc import Iterator
from typing import Any

import dalembert as exu

Configuration = exu.ConfigurationType
REFUSALS = (TypeError, ValueError, IndexError, AttributeError, RuntimeError, NotImplementedError)


@contextlib.contextmanager
def refusals() -> Iterator[None]:
    """Pass over refusals; but a function that is read by itself, which ends at Python's limit of recursion, ends at once."""
    try:
        yield
    except RecursionError:
        raise
    except REFUSALS:
        pass


def read(mbs: Any) -> None:
    """Fast queries of a system."""
    data = mbs.systemData
    repr(mbs)
    data.GetTime()
    data.GetODE2Coordinates(copy=False).sum()
    data.GetSystemStateDict(Configuration.StartOfStep)
    for i in range(data.NumberOfSensors()):
        with refusals():
            mbs.GetSensorValues(i)
            mbs.GetSensorStoredData(i)
    for i in range(data.NumberOfNodes()):
        with refusals():
            mbs.GetNodeOutput(i, exu.OutputVariableType.Position, Configuration.Reference)
            mbs.GetNodeOutput(i, exu.OutputVariableType.Coordinates)
    for i in range(data.NumberOfObjects()):
        with refusals():
            mbs.GetObjectOutput(i, exu.OutputVariableType.Force)


def write(mbs: Any) -> None:
    """Parameters that a model may change in every step: parameters to the values that they have."""
    data = mbs.systemData
    data.SetODE2Coordinates(data.GetODE2Coordinates())
    for i in range(data.NumberOfLoads()):
        vector = mbs.GetLoad(i).get("loadVector")
        if vector is not None:
            mbs.SetLoadParameter(i, "loadVector", vector)
    for i in range(data.NumberOfObjects()):
        value = mbs.GetObject(i).get("stiffness")
        if isinstance(value, float):
            mbs.SetObjectParameter(i, "stiffness", value)
    mbs.variables["time"] = data.GetTime()


def reading_step(mbs: Any, t: float) -> bool:
    read(mbs)
    return True


def writing_step(mbs: Any, t: float) -> bool:
    write(mbs)
    return True


def copying_step(mbs: Any, t: float) -> bool:
    """Solves a copy that calls no functions of the system."""
    other = copy.copy(mbs)
    other.SetPreStepUserFunction(0)
    other.SetPostStepUserFunction(0)
    with contextlib.suppress(*REFUSALS):
        settings = exu.SimulationSettings()
        settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 1e-4, 1
        settings.timeIntegration.verboseMode = 0
        settings.solutionSettings.writeSolutionToFile = False
        other.SolveDynamic(settings)
    return True


def raising_step(mbs: Any, t: float) -> bool:
    raise KeyError("raised in a step")


def stopping_step(mbs: Any, t: float) -> bool:
    return False


def odd_step(mbs: Any, t: float) -> Any:
    return "neither true nor false"


def restructuring_step(mbs: Any, t: float) -> bool:
    """Tries operations that are rejected while a solver runs."""
    for change in (
        mbs.Assemble,
        mbs.Reset,
        lambda: mbs.AddNode(exu.NodePoint()),
        lambda: mbs.DeleteNode(0),
        mbs.SolveStatic,
    ):
        try:
            change()
        except RuntimeError:
            continue
        raise AssertionError("the structure of a system in use was changed")
    return True


STEP_FUNCTIONS = (
    0,
    reading_step,
    writing_step,
    copying_step,
    raising_step,
    stopping_step,
    odd_step,
    restructuring_step,
)


def settled(mbs: Any, t: float) -> Any:
    read(mbs)
    return [0, 1e-3]


def unsettled(mbs: Any, t: float) -> Any:
    return [1.0, -1]


def odd_error(mbs: Any, t: float) -> Any:
    return None


POST_NEWTON_FUNCTIONS = (0, settled, unsettled, odd_error)


def load_vector(mbs: Any, t: float, vector: Any) -> Any:
    mbs.systemData.GetTime()
    return [(1 + t) * x for x in vector] if hasattr(vector, "__len__") else (1 + t) * vector


def zero(mbs: Any, *arguments: Any) -> float:
    return 0.0


def reads_all(mbs: Any, *arguments: Any) -> float:
    read(mbs)
    return 0.5


def raises(mbs: Any, *arguments: Any) -> float:
    raise ZeroDivisionError("raised in the function of an item")


def returns_nan(mbs: Any, *arguments: Any) -> float:
    return float("nan")


def echo(mbs: Any, *arguments: Any) -> Any:
    return arguments[-1]


ITEM_FUNCTIONS = (load_vector, zero, reads_all, raises, returns_nan, echo)
