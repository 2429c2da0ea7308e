"""Traces of sensors: the curves that measured positions leave, with vectors and triads along them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._core import OutputVariableType
from dalembert._pictures.looks import Looks, rgba
from dalembert._pictures.pen import Pen

Stored = Callable[[int], Any]  # time and values, row by row, that a sensor has stored


def wanted(looks: Looks) -> bool:
    """Return whether visualizationSettings.sensors.traces asks for anything."""
    traces = looks.setting("sensors.traces")
    return bool(traces.showPositionTrace or traces.showVectors or traces.showTriads)


def draw(pen: Pen, time: float, stored: Stored) -> None:
    """Draw what visualizationSettings.sensors.traces asks for, of sensors that store their values."""
    traces = pen.looks.setting("sensors.traces")
    numbers = [int(n) for n in traces.listOfPositionSensors] or _position_sensors(pen)
    palette = np.asarray(traces.traceColors, float).reshape(-1, 4)
    for order, number in enumerate(numbers):
        rows = _rows(stored, traces, number, time)
        if rows is None or len(rows) < 2:
            continue
        color = rgba(palette[order % len(palette)]) if len(palette) else (0.2, 0.2, 0.2, 1.0)
        positions = _turned(pen, number, rows[:, 1:4], True)
        if traces.showPositionTrace:
            pen.line(positions[:: max(int(traces.positionsShowEvery), 1)], color, float(traces.lineWidth))
        if traces.showVectors and order < len(traces.listOfVectorSensors):
            vectors = _rows(stored, traces, int(traces.listOfVectorSensors[order]), time)
            for i in _chosen(rows, vectors, traces.vectorsShowEvery, traces.showCurrent):
                assert vectors is not None
                vector = _turned(pen, int(traces.listOfVectorSensors[order]), vectors[i, 1:4], False)
                pen.arrow(positions[i], float(traces.vectorScaling) * vector, 0.002 * pen.looks.size, color)
        if traces.showTriads and order < len(traces.listOfTriadSensors):
            turned = _rows(stored, traces, int(traces.listOfTriadSensors[order]), time)
            for i in _chosen(rows, turned, traces.triadsShowEvery, traces.showCurrent):
                assert turned is not None
                pen.frame(positions[i], turned[i, 1:10].reshape(3, 3), float(traces.triadSize))


def _turned(pen: Pen, number: int, values: FloatArray, are_places: bool) -> FloatArray:
    """Return values of a sensor in global components: nodes in a floating frame tell theirs in its present axes."""
    node = pen.places.item("Sensor", number).get("nodeNumber")
    frame = None if node is None else pen.places.frame_of_output(int(node))
    if frame is None:
        return values
    return values @ frame[1].T + (frame[0] if are_places else 0)


def _position_sensors(pen: Pen) -> list[int]:
    """Return all sensors that store positions."""
    mbs = pen.places.mbs
    sensors = ((n, mbs.GetSensor(n)) for n in range(mbs.systemData.NumberOfSensors()))
    return [
        n for n, s in sensors if s.get("storeInternal") and s.get("outputVariableType") == OutputVariableType.Position
    ]


def _rows(stored: Stored, traces: Any, number: int, time: float) -> FloatArray | None:
    """Return time and values of a sensor, as much of the past and the future as is to be shown."""
    try:
        rows = np.atleast_2d(np.asarray(stored(number), float))
    except (RuntimeError, ValueError):
        return None
    if rows.ndim != 2 or rows.shape[1] < 4:
        return None
    span = float(traces.timeSpan) or np.inf
    wanted = np.abs(rows[:, 0] - time) <= span
    wanted &= (rows[:, 0] <= time + 1e-12) if not traces.showFuture else True
    wanted &= (rows[:, 0] >= time - 1e-12) if not traces.showPast else True
    return rows[wanted]


def _chosen(rows: FloatArray, others: FloatArray | None, every: int, current: bool) -> list[int]:
    """Return which rows have an arrow or a triad: every so many, and the last one."""
    if others is None or len(others) != len(rows):
        return []
    chosen = set(range(0, len(rows), max(int(every), 1)))
    return sorted(chosen | {len(rows) - 1} if current else chosen)
