"""Histories of sensors, for their traces in the viewer.

A shadow copy of a system stores no sensor values. The stored values of the original are not accessible while a solver
runs: traces then use the states that the viewer has shown.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from dalembert import _core
from dalembert._checks import FloatArray
from dalembert._core import ConfigurationType, OutputVariableType

LONGEST = 4096  # rows of a track
FRAME = 12  # numbers of a frame: position and rotation matrix


class Track:
    """A limited number of rows; the first number of each is a time.

    If the list is full, outdated rows are removed; if there are none, every second row is removed, and the sampling
    rate
    is halved. The last row is always kept.
    """

    def __init__(self, columns: int, longest: int = LONGEST) -> None:
        """`columns`: numbers in a row; `longest`: maximum number of rows."""
        self._rows, self._longest = np.empty((longest + 1, columns)), longest
        self._count, self._every = 0, 1  # every n-th row is kept
        self._kept, self._waits = 0, 0  # 1: the last row is not one of those that are kept

    def add(self, row: FloatArray, since: float = -np.inf, replaces: bool = False) -> None:
        """Add a row, or replace the last one; rows from before `since` are of no use any more."""
        if replaces:
            self.rows()[-1] = row
            return
        if self._kept == self._longest and self._count % self._every == 0:
            old = int(np.searchsorted(self._rows[: self._longest, 0], since))
            used = self._rows[old : self._longest] if old else self._rows[: self._longest : 2]
            self._every *= 1 if old else 2
            self._kept = len(used)
            self._rows[: self._kept] = used.copy()
        self._rows[self._kept] = row
        self._waits = int(self._count % self._every != 0)
        self._kept += 1 - self._waits
        self._count += 1

    def rows(self) -> FloatArray:
        """Return the rows; valid until the next one is added."""
        return self._rows[: self._kept + self._waits]


class History:
    """The rows of sensors of one system: stored ones, or those of the shown states."""

    def __init__(self, original: Any, shadow: Any, settings: Any) -> None:
        self._original, self._shadow, self._settings = original, shadow, settings
        self._seen: dict[int, Track] = {}
        self._frames: dict[int, int | None] = {}  # nodes of floating frames in whose components rows of sensors are
        self._frames_now: list[int] = []  # -1: no frame, for all sensors
        self.rests = False  # an earlier state is shown: nothing is added

    def rows(self, number: int) -> tuple[Any, FloatArray | None]:
        """Return time and values of a sensor, row by row, and their floating frames if the values are not global.

        ValueError if it is not to store anything.
        """
        if not self._shadow.solving:
            self._seen.pop(number, None)
            stored = self._original.GetSensorStoredData(number)
            return stored, _core._ScenePlaces(self._original).stored_frames(number)
        system, track = self._shadow.system, self._seen.get(number)
        if not system.GetSensor(number)["storeInternal"]:
            raise ValueError(f"sensor {number} stores nothing")
        time = system.systemData.GetTime(ConfigurationType.Visualization)
        last = -np.inf if track is None else float(track.rows()[-1, 0])
        if track is None or (time != last and not self.rests):
            values = np.ravel(system.GetSensorValues(number, ConfigurationType.Visualization))
            again = track is None or time < last  # another solution
            if again:
                self._frames[number] = self._frame_of(number)
            row = np.array([time, *values, *self._frame(self._frames[number])])
            if track is None or again:
                track = self._seen[number] = Track(len(row))
            track.add(row, time - (float(self._settings.sensors.traces.timeSpan) or np.inf))
        rows = track.rows()
        return (rows, None) if self._frames[number] is None else (rows[:, :-FRAME], rows[:, -FRAME:])

    def forget_frames(self) -> None:
        """Look anew for the floating frames of sensors: the system has other items."""
        self._frames_now = []

    def _frame_of(self, number: int) -> int | None:
        """Return the node of the floating frame in whose components a sensor measures; None for global components."""
        self._frames_now = self._frames_now or _core._ScenePlaces(self._shadow.system).frames_of_sensors()
        node = self._frames_now[number]
        return None if node < 0 else node

    def _frame(self, node: int | None) -> list[float]:
        """Return position and rotation of a node as it is shown."""
        if node is None:
            return []
        outputs = (OutputVariableType.Position, OutputVariableType.RotationMatrix)
        ask = self._shadow.system.GetNodeOutput
        return [x for output in outputs for x in ask(node, output, ConfigurationType.Visualization)]
