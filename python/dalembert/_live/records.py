"""Recorded states of a system, which the viewer shows again: its time slider, and plots of outputs."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._core import ConfigurationType
from dalembert._live import details
from dalembert._live.histories import LONGEST, Track

PARTS = (
    "ODE2Coordinates", "ODE2Coordinates_t", "ODE2Coordinates_tt", "ODE1Coordinates", "ODE1Coordinates_t",
    "AECoordinates", "DataCoordinates",
)  # fmt: skip
ROOM = 2e8  # bytes of the states of one system; if there are more, every second one is dropped
RATE = 1.6e7  # bytes per second
SHOWN = ConfigurationType.Visualization


class Record:
    """States of one system that the viewer has received."""

    def __init__(self, system: Any) -> None:
        self._data = system.systemData
        self._track: Track | None = None
        self._sizes: list[int] = []
        self._next = 0.0
        self.begun = 0  # number of solutions that have been recorded

    @property
    def times(self) -> FloatArray:
        """Return the times of the recorded states."""
        return np.empty(0) if self._track is None else self._track.rows()[:, 0]

    def is_due(self, now: float) -> bool:
        """Return whether a state is to be recorded: states of large systems are recorded less often."""
        return now >= self._next

    def add(self, now: float) -> bool:
        """Record the state that is shown; return whether it begins another solution: its time is an earlier one."""
        row, sizes = self._row()
        last = float(self.times[-1]) if self._track is not None else np.inf
        again = sizes != self._sizes or row[0] < last
        if again or self._track is None:
            self.begun += 1
            self._sizes, self._track = sizes, Track(len(row), int(np.clip(ROOM // row.nbytes, 2, LONGEST)))
        self._track.add(row, replaces=not again and row[0] == last)
        self._next = now + row.nbytes / RATE
        return again

    def show(self, when: float, step: int = 0) -> float:
        """Let the system show the recorded state nearest to a time, or so many states later; return its time."""
        if self._track is None:
            return when
        rows = self._track.rows()
        number = int(np.clip(np.argmin(np.abs(rows[:, 0] - when)) + step, 0, len(rows) - 1))
        self._put(rows[number])
        return float(rows[number, 0])

    def at(self, when: float, function: Callable[[], Any]) -> Any:
        """Return the result of a function in the state that was shown at a time: a recorded one, or the present one."""
        present = self._row()[0]
        if not len(self.times) or abs(present[0] - when) <= np.abs(self.times - when).min():
            return function()
        try:
            self.show(when)
            return function()
        finally:
            self._put(present)

    def evaluated(self, function: Callable[[], Any], since: float = -np.inf) -> list[tuple[float, Any]]:
        """Return the times and the results of a function in all recorded states after a time."""
        if self._track is None or self.times[-1] <= since:
            return []
        present, results = self._row()[0], []
        try:
            for row in self._track.rows()[self.times > since]:
                self._put(row)
                results.append((float(row[0]), function()))
        finally:
            self._put(present)
        return results

    def _row(self) -> tuple[FloatArray, list[int]]:
        """Return the state that is shown as one array, and the sizes of its parts."""
        data = self._data
        parts = [np.asarray(getattr(data, f"Get{name}")(SHOWN), float) for name in PARTS]
        return np.concatenate([[data.GetTime(SHOWN), data._GetMultiplierSign(SHOWN)], *parts]), [*map(len, parts)]

    def _put(self, row: FloatArray) -> None:
        """Show a state."""
        data = self._data
        for name, part in zip(PARTS, np.split(row[2:], np.cumsum(self._sizes)[:-1]), strict=True):
            getattr(data, f"Set{name}")(part, SHOWN)
        data._SetMultiplierSign(int(row[1]), SHOWN)
        data.SetTime(float(row[0]), SHOWN)


class Past:
    """Recorded states of all systems, and the one that readers look back to."""

    def __init__(self) -> None:
        self._records: list[Record] = []
        self._shadows: list[Any] = []
        self._sought = False  # another state is to be shown
        self.time: float | None = None  # of the state that is shown; None: the present one
        self._speed = 1.0  # simulated time per time, of the replay
        self._plays: float | None = None  # when the replay was last moved

    def record_of(self, system: int) -> Record:
        """Return the record of a system, by its number."""
        return self._records[system]

    def begin(self, shadows: list[Any]) -> None:
        """Forget everything: there are other systems, or other items."""
        self._shadows, self._records = shadows, [Record(shadow.system) for shadow in shadows]
        self.time, self._plays = None, None
        for shadow, record in zip(shadows, self._records, strict=True):
            if shadow.system.systemIsConsistent:
                record.add(time.monotonic())

    def is_due(self) -> bool:
        """Return whether a state is to be recorded."""
        now = time.monotonic()
        return any(record.is_due(now) for record in self._records)

    def take(self, moved: list[bool]) -> bool:
        """Record states that have just been received; return whether another state is to be shown than before."""
        now, back = time.monotonic(), self.time is not None
        for record, shadow, has_moved in zip(self._records, self._shadows, moved, strict=True):
            if has_moved and shadow.complete and (back or record.is_due(now)) and record.add(now):
                self.time = self._plays = None  # another solution has begun
        if self.time is not None:
            if self._plays is not None:
                self._replay(now)
            elif any(moved):
                self._show(self.time)
        news, self._sought = self._sought or (self.time is None and any(moved)), False
        return news

    def seek(self, when: float | None, step: int = 0, plays: bool = False, speed: float = 1.0) -> None:
        """Look back to the state nearest to a time, or so many states later; None: show the present state."""
        if not self._records or not len(self._longest().times):
            return
        if self.time is None:
            for record, shadow in zip(self._records, self._shadows, strict=True):
                if shadow.complete:
                    record.add(time.monotonic())  # the present state, to which readers return
        self._show(self._longest().times[-1] if when is None else when, step)
        self._speed, self._plays = speed, time.monotonic() if plays and when is not None else None
        if when is None:
            self.time = None

    def words(self) -> dict[str, Any]:
        """Return what pages show of it: first and last time, number of states, and whether readers look back."""
        times = self._longest().times if self._records else np.empty(0)
        first, last = (float(times[0]), float(times[-1])) if len(times) else (0.0, 0.0)
        back, plays = self.time is not None, self._plays is not None
        return {"kind": "times", "first": first, "last": last, "count": len(times), "back": back, "plays": plays}

    def _longest(self) -> Record:
        return max(self._records, key=lambda record: len(record.times))

    def _replay(self, now: float) -> None:
        """Move on by the time that has passed, in the end to the present state."""
        assert self.time is not None and self._plays is not None
        when, self._plays = self.time + self._speed * (now - self._plays), now
        if when < self._longest().times[-1]:
            self._show(when)
            self.time = when  # between two states
        else:
            self.seek(None)

    def _show(self, when: float, step: int = 0) -> None:
        """Show the recorded state of all systems."""
        longest = self._longest()
        self.time = longest.show(when, step)
        for record in self._records:
            if record is not longest:
                record.show(self.time)
        self._sought = True


@dataclass
class Plot:
    """An output over the times of the recorded states."""

    system: int
    kind: str
    number: int
    name: str
    begun: int = -1  # the solution that the values are of
    values: list[tuple[float, Any]] = field(default_factory=list)

    def renew(self, mbs: Any, record: Record) -> bool:
        """Add the values of the states that have been recorded meanwhile; return whether there are some."""
        if record.begun != self.begun:
            self.values, self.begun = [], record.begun
        last = self.values[-1][0] if self.values else -np.inf
        found = record.evaluated(lambda: details.output(mbs, self.kind, self.number, self.name), last)
        self.values += [(time, value) for time, value in found if value is not None]
        return bool(found)


class Plots:
    """The outputs that readers have chosen."""

    def __init__(self) -> None:
        self._plots: list[Plot] = []
        self._changed = False

    def choose(self, system: int, kind: str, number: int, name: str) -> None:
        """Plot an output."""
        if (system, kind, number, name) not in [(p.system, p.kind, p.number, p.name) for p in self._plots]:
            self._plots.append(Plot(system, kind, number, name))
            self._changed = True

    def drop(self, order: int | None = None) -> None:
        """Remove a plot, by its order, or all."""
        self._plots = [] if order is None else self._plots[:order] + self._plots[order + 1 :]
        self._changed = True

    def renewed(self, shadows: list[Any], past: Past) -> list[dict[str, Any]] | None:
        """Return all plots if they have changed."""
        news = [p.renew(shadows[p.system].system, past.record_of(p.system)) for p in self._plots]
        changed, self._changed = self._changed or any(news), False
        return self.curves(shadows) if changed else None

    def curves(self, shadows: list[Any]) -> list[dict[str, Any]]:
        """Return all plots, as pages draw them."""
        return [details.curves(shadows[p.system].system, p.kind, p.number, p.name, p.values) for p in self._plots]
