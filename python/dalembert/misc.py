"""Modules by the names of later releases of Exudyn: misc.GUI, misc.mainSystemExtensions and misc.resultsMonitor.

Here they are GUI, mainSystemExtensions and resultsMonitor; with the alias, `import exudyn.misc.GUI` works too.
"""

from __future__ import annotations

import sys
from importlib import import_module
from typing import Any

from dalembert._tools.missing_names import left_out, missing, nearest

__path__: list[str] = []  # dotted imports through the alias need a package
MODULES = ("GUI", "mainSystemExtensions", "resultsMonitor")


def __getattr__(name: str) -> Any:
    if name in MODULES:
        return import_module(f"dalembert.{name}")
    text = f"module '{__name__}' has no attribute '{name}'"
    raise missing(text, left_out(f"misc.{name}") or nearest(name, MODULES), name, sys.modules[__name__])


def __dir__() -> list[str]:
    return sorted({*globals(), *MODULES})
