"""What sensors of a system have measured, for their traces on pages.

A copy of a system that follows it stores nothing. While a solver works on the system, what its sensors store is out of
reach: traces go then through the states that pages have been shown.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._core import ConfigurationType


class History:
    """The rows of sensors of one system: those that they have stored, or the ones of the states that were seen."""

    def __init__(self, original: Any, shadow: Any) -> None:
        self._original, self._shadow = original, shadow
        self._seen: dict[int, list[FloatArray]] = {}

    def rows(self, number: int) -> Any:
        """Return time and values of a sensor, row by row; ValueError if it is not to store anything."""
        if not self._shadow.solving:
            self._seen.pop(number, None)
            return self._original.GetSensorStoredData(number)
        system, seen = self._shadow.system, self._seen.setdefault(number, [])
        if not system.GetSensor(number)["storeInternal"]:
            raise ValueError(f"sensor {number} stores nothing")
        time = system.systemData.GetTime(ConfigurationType.Visualization)
        if seen and time < seen[-1][0]:
            seen.clear()  # another solution
        if not seen or time > seen[-1][0]:
            values = system.GetSensorValues(number, ConfigurationType.Visualization)
            seen.append(np.concatenate([[time], np.ravel(values)]))
        return np.array(seen)
