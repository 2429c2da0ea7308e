"""What sensors of a system have measured, for their traces on pages.

A copy of a system that follows it stores nothing. While a solver works on the system, what its sensors store is out of
reach: traces go then through the states that pages have been shown.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._core import ConfigurationType

LONGEST = 4096  # rows of a track


class Track:
    """Rows one after the other, the first number of each a time, of which never more than LONGEST are kept.

    Where there is no more room, those that are too old go; if there are none, every second one goes, and from then on
    half as many are taken. The last one is always there.
    """

    def __init__(self, columns: int) -> None:
        """`columns`: numbers in a row."""
        self._rows = np.empty((LONGEST + 1, columns))
        self._count, self._every = 0, 1  # of all that were added, every so manieth is kept
        self._kept, self._waits = 0, 0  # 1: the last row is not one of those that are kept

    def add(self, row: FloatArray, since: float = -np.inf) -> None:
        """Add a row; rows from before `since` are of no use any more."""
        if self._kept == LONGEST and self._count % self._every == 0:
            old = int(np.searchsorted(self._rows[:LONGEST, 0], since))
            used = self._rows[old:LONGEST] if old else self._rows[:LONGEST:2]
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
    """The rows of sensors of one system: those that they have stored, or the ones of the states that were seen."""

    def __init__(self, original: Any, shadow: Any, settings: Any) -> None:
        self._original, self._shadow, self._settings = original, shadow, settings
        self._seen: dict[int, Track] = {}

    def rows(self, number: int) -> Any:
        """Return time and values of a sensor, row by row; ValueError if it is not to store anything."""
        if not self._shadow.solving:
            self._seen.pop(number, None)
            return self._original.GetSensorStoredData(number)
        system, track = self._shadow.system, self._seen.get(number)
        if not system.GetSensor(number)["storeInternal"]:
            raise ValueError(f"sensor {number} stores nothing")
        time = system.systemData.GetTime(ConfigurationType.Visualization)
        last = -np.inf if track is None else float(track.rows()[-1, 0])
        if track is None or time != last:
            values = np.ravel(system.GetSensorValues(number, ConfigurationType.Visualization))
            if track is None or time < last:  # another solution
                track = self._seen[number] = Track(1 + len(values))
            track.add(np.array([time, *values]), time - (float(self._settings.sensors.traces.timeSpan) or np.inf))
        return track.rows()
