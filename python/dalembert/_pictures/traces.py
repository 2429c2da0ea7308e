"""Traces of sensors: the curves that measured positions leave, with vectors and triads along them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._core import OutputVariableType
from dalembert._pictures.looks import Looks, rgba
from dalembert._pictures.notices import tell_once
from dalembert._pictures.pen import Pen

# Time and values, row by row, that a sensor has stored; and position and rotation of the floating frame of each row if
# the values are in its components, not in global ones.
Stored = Callable[[int], tuple[Any, FloatArray | None]]


def wanted(looks: Looks) -> bool:
    """Return whether visualizationSettings.sensors.traces asks for anything."""
    traces = looks.setting("sensors.traces")
    return bool(traces.showPositionTrace or traces.showVectors or traces.showTriads)


def draw(pen: Pen, time: float, stored: Stored) -> None:
    """Draw the traces of visualizationSettings.sensors.traces, for sensors that store their values."""
    traces = pen.looks.setting("sensors.traces")
    _require_sensors(pen, traces)
    numbers = [int(n) for n in traces.listOfPositionSensors] or _position_sensors(pen)
    palette = np.asarray(traces.traceColors, float).reshape(-1, 4)
    for order, number in enumerate(numbers):
        known = _rows(pen, stored, number, time)
        if known is None or len(known[0]) < 2:
            continue
        rows = known[0]
        color = rgba(palette[order % len(palette)]) if len(palette) else (0.2, 0.2, 0.2, 1.0)
        positions = _in_space(*known, are_places=True)
        if traces.showPositionTrace:
            pen.line(positions[:: max(int(traces.positionsShowEvery), 1)], color, float(traces.lineWidth))
        if traces.showVectors and order < len(traces.listOfVectorSensors):
            measured = _rows(pen, stored, int(traces.listOfVectorSensors[order]), time)
            chosen = _chosen(rows, measured, traces.vectorsShowEvery, traces.showCurrent)
            vectors = float(traces.vectorScaling) * _in_space(*measured) if measured else rows[:0]
            for i in chosen:
                pen.arrow(positions[i], vectors[i], 0.002 * pen.looks.size, color)
        if traces.showTriads and order < len(traces.listOfTriadSensors):
            turned = _rows(pen, stored, int(traces.listOfTriadSensors[order]), time, 9)
            for i in _chosen(rows, turned, traces.triadsShowEvery, traces.showCurrent):
                assert turned is not None
                pen.frame(positions[i], turned[0][i, 1:10].reshape(3, 3), float(traces.triadSize))


def _in_space(rows: FloatArray, frames: FloatArray | None, are_places: bool = False) -> FloatArray:
    """Return vectors of rows in global components, as they were at the time of each row."""
    vectors = rows[:, 1:4]
    if frames is None:
        return vectors
    turned = np.einsum("nij,nj->ni", frames[:, 3:].reshape(-1, 3, 3), vectors)
    return turned + frames[:, :3] if are_places else turned


def _require_sensors(pen: Pen, traces: Any) -> None:
    """Refuse numbers of sensors that are not there."""
    count = pen.places.mbs.systemData.NumberOfSensors()
    for what in ("Position", "Vector", "Triad"):
        for number in getattr(traces, f"listOf{what}Sensors"):
            if number >= count:
                raise ValueError(
                    f"visualizationSettings.sensors.traces.listOf{what}Sensors: expected numbers of the {count} "
                    f"sensors of system {traces.sensorsMbsNumber}, received {number}"
                )


def _position_sensors(pen: Pen) -> list[int]:
    """Return all sensors that store positions."""
    mbs = pen.places.mbs
    sensors = ((n, mbs.GetSensor(n)) for n in range(mbs.systemData.NumberOfSensors()))
    return [
        n for n, s in sensors if s.get("storeInternal") and s.get("outputVariableType") == OutputVariableType.Position
    ]


def _rows(
    pen: Pen, stored: Stored, number: int, time: float, least: int = 3
) -> tuple[FloatArray, FloatArray | None] | None:
    """Return time and values of a sensor, with frames, for the visible part of the past and the future.

    None if it has not stored enough values per row; if it never will, a warning is given.
    """
    here = f"visualizationSettings.sensors.traces: sensor {number}"
    try:
        values, frames = stored(number)
    except (RuntimeError, ValueError):
        if not pen.places.mbs.GetSensor(number)["storeInternal"]:
            tell_once(f"{here} stores nothing that could be drawn: it needs storeInternal=True")
        return None
    rows, traces = np.atleast_2d(np.asarray(values, float)), pen.looks.setting("sensors.traces")
    if rows.ndim != 2 or rows.shape[1] <= least:
        if len(rows) and rows.size:
            tell_once(f"{here} has {rows.shape[1] - 1} values at a time, where {least} are to be drawn")
        return None
    span = float(traces.timeSpan) or np.inf
    wanted = np.abs(rows[:, 0] - time) <= span
    wanted &= (rows[:, 0] <= time + 1e-12) if not traces.showFuture else True
    wanted &= (rows[:, 0] >= time - 1e-12) if not traces.showPast else True
    return rows[wanted], None if frames is None else frames[wanted]


def _chosen(rows: FloatArray, others: tuple[FloatArray, Any] | None, every: int, current: bool) -> list[int]:
    """Return which rows have an arrow or a triad: every so many, and the last one."""
    if others is None or len(others[0]) != len(rows):
        return []
    chosen = set(range(0, len(rows), max(int(every), 1)))
    return sorted(chosen | {len(rows) - 1} if current else chosen)
