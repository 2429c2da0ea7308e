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
        self._left_out = {"system": mbs, "container": mbs.GetSystemContainer()}

    def persistent_id(self, thing: Any) -> str | None:
        return next((name for name, known in self._left_out.items() if thing is known), None)
