"""For every parameter type of the specs: a value that is not the default, and what each type refuses."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

import dalembert as exu
from codegen.load import load
from codegen.model import Item, Parameter

ITEMS: tuple[Item, ...] = load(Path(__file__).parents[2]).items
CLASSES = {item.name: getattr(exu, item.name) for item in ITEMS}
FIXED = {"vector2": 2, "vector3": 3, "vector4": 4, "vector6": 6, "vector7": 7, "vector9": 9}
SQUARE = {"matrix3": 3, "matrix6": 6}
INDEX = {
    "node": exu.NodeIndex,
    "object": exu.ObjectIndex,
    "marker": exu.MarkerIndex,
    "load": exu.LoadIndex,
    "sensor": exu.SensorIndex,
}


def function(*arguments: Any) -> float:
    """A user function that pickle finds."""
    return 0.0


def parameters(item: Item) -> list[Parameter]:
    """The constructor's arguments of an item, without the name."""
    return [row for row in item.parameters if not row.internal and row.name != "name"]


def rows(condition: Any = lambda row: True) -> Iterator[tuple[Item, Parameter]]:
    return ((item, row) for item in ITEMS for row in parameters(item) if condition(row))


def length(row: Parameter, free: int = 3) -> int:
    return (row.shape[0] if row.shape else None) or free


def sample(row: Parameter) -> Any:
    """A valid value, as a user would write it."""
    storage = row.type.storage
    if storage in FIXED:
        return [0.5 + i for i in range(FIXED[storage])]
    if storage in SQUARE:
        return (np.arange(1.0, SQUARE[storage] ** 2 + 1).reshape(SQUARE[storage], -1)).tolist()
    if storage in INDEX:
        return INDEX[storage](2)
    if storage.removesuffix("s") in INDEX:
        return [INDEX[storage.removesuffix("s")](i + 1) for i in range(length(row))]
    values: dict[str, Any] = {
        "boolean": row.default is not True,
        "integer": 7,
        "real": 0.125,
        "text": "words",
        "vector": [0.25 * (i + 1) for i in range(length(row))],
        "matrix": [[1.0, 2.0], [3.0, 4.0]],
        "integer_matrix": [[1, 2, 3], [4, 5, 6]],
        "matrix_container": [[1.0, 2.0], [3.0, 4.0]],
        "integers": [i + 1 for i in range(length(row))],
        "vector3s": [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]],
        "vector6s": [[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]],
        "matrix3s": [np.eye(3).tolist()],
        "output_variable": exu.OutputVariableType.Position,
        "joint_types": [exu.JointType.RevoluteZ],
        "user_function": function,
        "opaque": [{"type": "Line"}],
    }
    return values[storage]


def plain(value: Any) -> Any:
    """Arrays and lists of the module as nested lists, for comparison."""
    if hasattr(value, "Convert2DenseMatrix"):
        value = value.Convert2DenseMatrix()
    elif hasattr(value, "GetPythonObject"):
        value = value.GetPythonObject()
    elif hasattr(value, "GetDictionary"):  # beam sections
        value = value.GetDictionary()
    if isinstance(value, dict):
        return {key: plain(entry) for key, entry in value.items()}
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, (list, tuple)):
        return [plain(entry) for entry in value]
    return value


def wrong_type(row: Parameter) -> Any:
    """What no parameter of this type accepts, whatever its length."""
    if row.type.storage == "text":
        return 5
    return {"a": 1} if row.type.storage == "user_function" else "words"
