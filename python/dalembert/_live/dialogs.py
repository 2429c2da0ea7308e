"""An InteractiveDialog on the live page: its widgets, its curves, and the loop that runs the simulation."""

from __future__ import annotations

import time
from collections import deque
from typing import Any

import numpy as np

from dalembert._live.viewer import Viewer

RUN = "start or stop"
POINTS = 500  # points of a curve, unless the dialog sets another number
LOOKS = 0.05  # s between looks at widgets while nothing runs
CURVES = 0.1  # s between pictures of curves


def run(dialog: Any, viewer: Viewer, runs: bool) -> None:
    """Show a dialog, and simulate in periods of real time when readers want it, until they close the page."""
    viewer.show_controls(controls(dialog), dialog.values)
    curves = Curves(dialog)
    dialog.mbs.SetRenderEngineStopFlag(False)
    if runs:
        _start_or_stop(dialog)
    told, texts = 0.0, _texts(dialog)
    while viewer.watched and not (dialog.checkRenderStop and dialog.mbs.GetRenderEngineStopFlag()):
        begin = time.monotonic()
        dialog.values.update({name: viewer.values[name] for name in dialog.values})
        while viewer.pressed:
            _press(dialog, viewer.pressed.pop(0))
        dialog.ProcessWidgetStates()
        if dialog.simulationStopped:
            viewer.idle(LOOKS, False)
            continue
        dialog.RunSimulationPeriod()
        dialog.counter += 1
        curves.measure()
        if begin - told > CURVES:
            told = begin
            viewer.tell({"kind": "plots", "curves": curves.curves()})
            if texts != (texts := _texts(dialog)):
                viewer.show_controls(controls(dialog), dialog.values)
        viewer.idle(max(dialog.period / dialog.realtimeFactor - (time.monotonic() - begin), 0.0), False)
        if not dialog.doTimeIntegration:
            dialog.OnQuit()
    dialog.OnQuit()
    viewer.show_controls({}, {})


def _texts(dialog: Any) -> list[str]:
    return [label.get() for label in dialog.labelStringVariables]


def _start_or_stop(dialog: Any) -> None:
    dialog.simulationStopped = not dialog.simulationStopped
    if dialog.userStartSimulation is not None:
        dialog.userStartSimulation(dialog.simulationStopped)


def _press(dialog: Any, name: str) -> None:
    """Perform the action of a button, which is identified by its number."""
    if name == RUN:
        _start_or_stop(dialog)
    elif name.isdecimal() and int(name) < len(dialog.dialogItems):
        dialog.dialogItems[int(name)]["callFunction"]()


def controls(dialog: Any) -> dict[str, Any]:
    """Return title and widgets as the page takes them."""
    widgets: list[dict[str, Any]] = [{"type": "button", "text": RUN, "name": RUN}]
    for number, item in enumerate(dialog.dialogItems):
        widget = {"type": item["type"], "text": str(item.get("text", "")), "name": item.get("variable", str(number))}
        if "variable" in item:
            widget["value"] = dialog.values[item["variable"]]
        if item["type"] == "slider":
            low, high = (float(x) for x in item.get("range", (0, 1)))
            widget |= {"low": low, "high": high, "step": (high - low) / max(int(item.get("steps", 100)), 1)}
        elif item["type"] == "radio":
            widget["options"] = [[str(text), value] for text, value in item["textValueList"]]
        grid = item.get("grid")
        if grid is not None:
            row, column = (grid[0] if isinstance(grid[0], (tuple, list)) else grid)[:2]
            widget["grid"] = [int(row) + 1, int(column)]
        widgets.append(widget)
    return {"title": dialog.title or "simulation", "widgets": widgets}


class Curves:
    """The last values of the sensors in the plots of a dialog; each plot has [(sensor, component), (sensor,
    component), ...].

    Components count from 1; 0 is the time.
    """

    def __init__(self, dialog: Any) -> None:
        self.mbs = dialog.mbs
        plots = dialog.plots or {}
        self.plots = list(plots.get("sensors", [])) if isinstance(plots, dict) else []
        points = int(plots.get("nPoints", POINTS)) if self.plots else POINTS
        self.rows: list[deque[list[float]]] = [deque(maxlen=points) for _ in self.plots]

    def measure(self) -> None:
        """Take the present values."""
        for plot, rows in zip(self.plots, self.rows, strict=True):
            rows.append([self._value(*pair) for pair in plot[:2]])

    def _value(self, sensor: Any, component: int) -> float:
        if component == 0:
            return float(self.mbs.systemData.GetTime())
        values = np.atleast_1d(self.mbs.GetSensorValues(sensor))
        if component > len(values):
            raise ValueError(
                f"InteractiveDialog: plots['sensors']: sensor {sensor} has components 1 to {len(values)}, "
                f"received {component}"
            )
        return float(values[component - 1])

    def curves(self) -> list[dict[str, Any]]:
        """Return the data of the curves."""
        result = []
        for plot, rows in zip(self.plots, self.rows, strict=True):
            title = f"{plot[3]} over {plot[2]}" if len(plot) > 3 else ""
            result.append({"title": title, "x": [row[0] for row in rows], "y": [[row[1] for row in rows]]})
        return result
