"""The pickler of systems: functions that no module holds go along by value."""

from __future__ import annotations

import io
from typing import Any

import cloudpickle

from dalembert._core import MainSystem


class SystemPickler(cloudpickle.Pickler):  # type: ignore[misc]  # cloudpickle has no types
    """Leaves out the system itself and its container, to which user functions may refer as global variables."""

    def __init__(self, file: io.BytesIO, mbs: MainSystem) -> None:
        super().__init__(file)
        self._alive = mbs, mbs.GetSystemContainer()
        self._left_out = dict(zip(map(id, self._alive), ("system", "container"), strict=True))

    def persistent_id(self, thing: Any) -> str | None:  # asked for each of all objects
        return self._left_out.get(id(thing))
