"""Values for every parameter type of the specs: one that is not the default, and rejected ones."""

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


# Values of checks that numbers alone do not pass.
CHECKED: dict[str, Any] = {
    "rotation": [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
    "orthogonal": [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
    "unit_vector": [0.0, 0.6, 0.8],
    "color": [0.5, 0.0, 1.0, 0.25],
}


def function(*arguments: Any) -> float:
    """A user function that pickle finds."""
    return 0.0


def section() -> Any:
    made = exu.BeamSection()
    made.massPerLength, made.stiffnessMatrix = 2.0, np.diag([1.0, 2.0, 3.0, 4.0, 5.0, 6.0])
    return made


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
    if row.effective_check in CHECKED:
        value = CHECKED[row.effective_check]
        return [value] if storage.endswith("s") else value
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
        "texts": ["first", "second"],
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
        "beam_section": section(),
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


SHEAR = [[1.0, 0.1, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
_NO_ROTATION = {
    "scaled": (2 * np.eye(3)).tolist(),
    "sheared": SHEAR,
    "rotation of six digits": [[0.866025, -0.5, 0.0], [0.5, 0.866025, 0.0], [0.0, 0.0, 1.0]],
}
_BY_CHECK: dict[str, dict[str, Any]] = {
    "none": {},
    "non_negative": {"negative": -3},
    "positive": {"negative": -3, "zero": 0},
    "rotation": _NO_ROTATION | {"mirrored": np.diag([1.0, 1.0, -1.0])},
    "orthogonal": _NO_ROTATION,
    "unit_vector": {"too long": [0.0, 0.0, 2.0], "almost of length 1": [0.0, 0.707, 0.707]},
    "color": {"of bytes": [255.0, 128.0, 0.0, 255.0], "negative green": [0.5, -0.5, 0.0, 1.0]},
}
HUGE = 2**40  # more than an int holds
TOO_LARGE = 10**400  # more than a double holds


def bad_values(row: Parameter) -> dict[str, Any]:
    """Values by kind: values that a parameter refuses at the call that brings them."""
    storage = row.type.storage
    if storage == "opaque":
        return {}
    bad: dict[str, Any] = {"dictionary": {"a": 1}}
    if storage != "text" and not row.type.index and row.named == "no":  # numbers may be names, which a system knows
        bad["string"] = "words"
    bad |= _bad_entries(row) if row.shape and storage != "matrix_container" else _bad_scalars(row)
    if storage in ("matrix", "matrix_container", "integer_matrix"):
        bad |= {"list of numbers": [1.0, 2.0], "ragged": [[1.0, 2.0], [3.0]], "cube": np.zeros((2, 2, 2))}
    if row.shape and not row.type.takes_number:
        bad["number"] = 1.0
    checked = _BY_CHECK[row.effective_check]
    if storage.endswith("s") and row.shape and row.effective_check in CHECKED:
        checked = {kind: [value] for kind, value in checked.items()}
    default = -1 if row.default == "invalid" else row.default  # means: not set
    return bad | {kind: value for kind, value in checked.items() if np.ndim(value) or value != default}


def _bad_scalars(row: Parameter) -> dict[str, Any]:
    storage = row.type.storage
    if storage == "matrix_container":
        return {"not finite": [[1.0, float("nan")], [0.0, 1.0]], "nested None": [[None, 1.0], [0.0, 1.0]]}
    if storage == "user_function":
        return {"number": 1.5, "integer": 5, "list": [function]}
    bad: dict[str, Any] = {"None": None, "list": [1, 2], "empty": []}
    if storage == "text":
        return bad | {"number": 5, "bytes": b"words"}
    bad |= {"not a number": float("nan"), "complex": 1j}
    match storage:
        case "boolean":
            bad |= {"integer": 2, "real": 0.5}
        case "real":
            bad |= {"infinite": float("inf"), "too large": TOO_LARGE}
        case "output_variable":
            bad |= {"integer": 3, "other enumeration": exu.ConfigurationType.Current}
        case _:
            bad |= {"real": 1.5, "numpy real": np.float64(1), "huge": HUGE}
    if row.type.index:
        bad |= {"negative": -2, "flag": True}
        bad |= {f"{kind} index": index(0) for kind, index in INDEX.items() if kind != storage}
    return bad


def _bad_entries(row: Parameter) -> dict[str, Any]:
    """Values of vectors, matrices and lists: wrong entries, and wrong lengths."""
    storage, valid = row.type.storage, sample(row)
    kind = storage.removesuffix("s")
    wrong: dict[str, Any] = {"nested None": None, "nested dictionary": {}}
    if not row.type.index:
        wrong["nested string"] = "3"
    if row.type.real:
        wrong |= {"not a number": float("nan"), "infinite": float("inf"), "too large": TOO_LARGE}
    elif kind in INDEX:
        wrong |= {"real": 1.5, "huge": HUGE, "negative": -2}
        wrong |= {f"{other} index": index(0) for other, index in INDEX.items() if other != kind}
    elif storage == "texts":
        del wrong["nested string"]
        wrong |= {"integer": 3, "bytes": b"words"}
    elif storage == "joint_types":
        wrong |= {"integer": 3, "other enumeration": exu.ConfigurationType.Current}
    else:
        wrong |= {"real": 1.5, "huge": HUGE}
    bad = {name: _with_last(valid, entry) for name, entry in wrong.items()}
    if storage not in ("matrix", "integer_matrix", "vector3s", "vector6s", "matrix3s"):
        bad["None"] = None  # else: empty
    if row.shape[0]:
        bad |= {"empty": [], "too short": valid[:-1], "too many": [*valid, valid[0]]}
    if row.type.real and len(row.shape) == 1:
        bad["nested"] = [valid]
    return bad


def _with_last(values: list[Any], entry: Any) -> list[Any]:
    """The same nested list with another last number."""
    if isinstance(values[-1], list):
        return [*values[:-1], _with_last(values[-1], entry)]
    return [*values[:-1], entry]


def wrong_type(row: Parameter) -> Any:
    """Values that no parameter of this type accepts, for any length."""
    if row.type.storage == "text":
        return 5
    if row.named != "no" or row.type.index and not row.type.shape:
        return 0.5  # a text is a name
    return {"a": 1} if row.type.storage == "user_function" else "words"
