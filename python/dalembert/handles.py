# ruff: noqa: I001  `as` says to type checkers what users import from here

"""Classes of handles, by the names of item classes, for annotations and isinstance: handles.ObjectRigidBody.

Model returns handles; see dalembert._model.handle for what they are.
"""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

from dalembert._item_table import ITEMS
from dalembert._model.handle import Handle as Handle, LoadHandle as LoadHandle, MarkerHandle as MarkerHandle
from dalembert._model.handle import NodeHandle as NodeHandle, ObjectHandle as ObjectHandle, handle_class
from dalembert._model.handle import SensorHandle as SensorHandle
from dalembert._tools.missing_names import missing_in

if TYPE_CHECKING:
    from dalembert._item_handles import *

_BASES = ("Handle", "LoadHandle", "MarkerHandle", "NodeHandle", "ObjectHandle", "SensorHandle")
if not TYPE_CHECKING:
    __all__ = [*_BASES, *ITEMS]  # noqa: PLE0604


def __getattr__(name: str) -> Any:
    if name.startswith(("Node", "Object", "Marker", "Load", "Sensor")):
        from dalembert._tools.item_packages import item_classes

        if name in ITEMS or name in item_classes():
            return handle_class(name)
    raise missing_in(sys.modules[__name__], name)


def __dir__() -> list[str]:
    return sorted([*_BASES, *ITEMS])
