"""Panel of an item: its parameters and current outputs."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from dalembert._core import ConfigurationType, OutputVariableType

KINDS = ("Node", "Object", "Marker", "Load", "Sensor")
LONGEST = 160  # characters of a value


def parameters(mbs: Any, kind: str, number: int, with_graphics: bool) -> list[list[str]]:
    """Return names and values, as texts; the lists of graphics data can be very long."""
    rows = []
    for name, value in getattr(mbs, f"Get{kind}")(number).items():
        if with_graphics or name != "VgraphicsData":
            rows.append([str(name), text(value)])
    return rows


def outputs(mbs: Any, kind: str, number: int) -> list[list[str]]:
    """Return the names of all outputs that an item has, and their values in the state that is shown."""
    shown = ConfigurationType.Visualization
    if kind == "Sensor":
        return _asked("values", lambda: mbs.GetSensorValues(number, shown))
    if kind == "Load":
        return []
    rows = []
    for variable in _variables():
        if kind == "Node":
            rows += _asked(variable.name, lambda v=variable: mbs.GetNodeOutput(number, v, shown))
        elif kind == "Marker":
            rows += _asked(variable.name, lambda v=variable: mbs.GetMarkerOutput(number, v, shown))
        else:
            rows += _asked(
                variable.name, lambda v=variable: mbs.GetObjectOutputBody(number, v, [0, 0, 0], shown)
            ) or _asked(variable.name, lambda v=variable: mbs.GetObjectOutput(number, v, shown))
    return rows


def _variables() -> list[Any]:
    return [variable for name, variable in OutputVariableType.__members__.items() if not name.startswith(("_", "End"))]


def _asked(name: str, ask: Any) -> list[list[str]]:
    try:
        value = ask()
    except (RuntimeError, ValueError, NotImplementedError, IndexError, TypeError):
        return []
    return [[name, text(value)]] if np.size(value) else []


def text(value: Any) -> str:
    """Return a value in few characters."""
    if isinstance(value, (float, np.floating)):
        return f"{value:.6g}"
    if isinstance(value, np.ndarray):
        shown = np.round(value, 5) + 0.0 if value.dtype.kind == "f" and np.abs(value).max(initial=0.0) < 1e4 else value
        result = np.array2string(shown, precision=5, separator=", ", threshold=40, suppress_small=True)
    elif isinstance(value, (list, tuple)) and value and all(isinstance(entry, (int, float)) for entry in value):
        result = "[" + ", ".join(text(entry) for entry in value[:40]) + (", ...]" if len(value) > 40 else "]")
    elif isinstance(value, (list, Mapping)) and len(value) > 8:
        result = f"{type(value).__name__} with {len(value)} entries"
    else:
        result = str(value)
    return result if len(result) <= LONGEST else result[: LONGEST - 3] + "..."
