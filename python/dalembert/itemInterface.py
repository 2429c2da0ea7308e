"""The item classes: nodes, objects, markers, loads and sensors, their V... visualization classes and short names."""

from __future__ import annotations

import copy
from typing import TYPE_CHECKING, Any

import numpy as np

import dalembert
from dalembert import _core

exudyn = exu = dalembert  # names under which models refer to the package after a star import

_bases = (_core.Item, _core.Visualization)
_classes: dict[str, type] = {
    name: value
    for name, value in vars(_core).items()
    if isinstance(value, type) and issubclass(value, _bases) and value not in _bases
}
globals().update(_classes)


def IIDiagMatrix(rowsColumns: int, value: float) -> list[list[float]]:
    """Return a square matrix, as list of rows, with `value` on the diagonal."""
    return [[value if i == j else 0 for j in range(rowsColumns)] for i in range(rowsColumns)]


__all__ = [*_classes, "IIDiagMatrix", "copy", "exu", "exudyn", "np"]  # noqa: PLE0604

if TYPE_CHECKING:

    def __getattr__(name: str) -> Any: ...
