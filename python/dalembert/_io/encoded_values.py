"""Values of parameters as JSON and back: plain if the type of the parameter determines the rest, else marked by a key.

{"array": [...]}       an array inside of a list of graphics, with "dtype"; "shape" where it is empty
{"npz": "name"}        an array in a separate file with the same name and the ending .npz
{"sparse": [[i, j, value], ...], "shape": [n, m]}   a sparse matrix
{"tuple": [...]}, {"entries": [[key, value], ...]}, {"enumeration": "Type.Name"}   other things in lists of graphics
{"function": "module:name"}, {"source": "def ...", "name": "..."}   a user function
{"recorded": {...}}    a recorded user function: its operations, which are data and no code
"""

from __future__ import annotations

import importlib
import inspect
import textwrap
from collections.abc import Callable, Mapping
from enum import Enum
from typing import Any, cast

import numpy as np

import dalembert
from dalembert import _core
from dalembert._core import MatrixContainer

LARGE = 1000  # entries; larger arrays are stored in the separate file
_MARKS = ("array", "npz", "sparse", "tuple", "entries", "enumeration", "function", "source", "recorded")
_SECTIONS: dict[str, Any] = {"BeamSection": _core.BeamSection, "BeamSectionGeometry": _core.BeamSectionGeometry}
_INDICES = (_core.NodeIndex, _core.ObjectIndex, _core.MarkerIndex, _core.LoadIndex, _core.SensorIndex)


class Refused(ValueError):
    """A value that cannot be written or read; the caller says where it stands."""


class Encoder:
    """Converts values to JSON; `arrays` collects the arrays of the separate file."""

    def __init__(self, withSource: bool) -> None:
        self.arrays: dict[str, Any] = {}
        self._with_source = withSource

    def value(self, value: Any, kind: str, place: str) -> Any:
        """Return the value of a parameter; `kind` is its type as text, 'object' for values that only Python reads."""
        if isinstance(value, Enum):
            return value.name if kind != "object" else {"enumeration": f"{type(value).__name__}.{value.name}"}
        if value is None or isinstance(value, (bool, str)):
            return value
        if isinstance(value, _INDICES):
            return int(value)
        if isinstance(value, (int, np.integer)):
            return int(value)
        if isinstance(value, (float, np.floating)):
            return float(value)
        if isinstance(value, MatrixContainer):
            return self._matrix(value, place)
        if isinstance(value, tuple(_SECTIONS.values())):
            entries = cast(Any, value).GetDictionary()
            return {key: self.value(entry, "", f"{place}.{key}") for key, entry in entries.items()}
        if isinstance(value, np.ndarray):
            return self._array(value, kind, place)
        if isinstance(value, _core.symbolic.UserFunction):
            return {"recorded": value._Stored()}
        if callable(value):
            return self._function(value)
        if kind == "object":
            return self._thing(value, place)
        return [self.value(entry, kind, f"{place}[{i}]") for i, entry in enumerate(value)]

    def _array(self, array: Any, kind: str, place: str) -> Any:
        if array.size > LARGE:
            name = place.replace("[", ".").replace("]", "")
            self.arrays[name] = array
            return {"npz": name}
        if kind != "object" and (array.size or array.ndim == 1):
            return array.tolist()
        shape = {} if array.size else {"shape": list(array.shape)}
        return {"array": array.tolist(), "dtype": array.dtype.str} | shape

    def _matrix(self, matrix: Any, place: str) -> Any:
        if matrix.UseDenseMatrix():
            return self._array(matrix.Convert2DenseMatrix(), "matrix", place)
        found = matrix.GetPythonObject()
        entries, shape = found["triplets"], [found["numberOfRows"], found["numberOfColumns"]]
        if entries.size > LARGE:
            return {"sparse": self._array(entries, "matrix", place), "shape": shape}
        return {"sparse": [[int(row), int(column), value] for row, column, value in entries.tolist()], "shape": shape}

    def _thing(self, value: Any, place: str) -> Any:
        if isinstance(value, Mapping):
            if all(isinstance(key, str) for key in value) and not set(value).intersection(_MARKS):
                return {key: self.value(entry, "object", f"{place}.{key}") for key, entry in value.items()}
            pairs = [self.value(list(pair), "object", place) for pair in value.items()]
            return {"entries": pairs}
        if isinstance(value, (list, tuple)):
            entries = [self.value(entry, "object", f"{place}[{i}]") for i, entry in enumerate(value)]
            return entries if isinstance(value, list) else {"tuple": entries}
        raise Refused(f"{type(value).__name__} {value!r} has no form in JSON; use numbers, texts, lists and arrays")

    def _function(self, function: Any) -> Any:
        module, name = getattr(function, "__module__", None), getattr(function, "__qualname__", "")
        if module and module != "__main__" and _imported(module, name) is function:
            return {"function": f"{module}:{name}"}
        if inspect.ismethod(function):
            raise Refused(f"function '{name}' is a method of an object, which files of models do not have")
        if not self._with_source:
            raise Refused(
                f"function {name or function!r} is in no module that could be imported; put it into a file of its own, "
                "or call Save(..., sourceOfFunctions=True), which writes its code"
            )
        try:
            source = textwrap.dedent(inspect.getsource(function))
        except (OSError, TypeError):
            raise Refused(f"the code of function {name or function!r} is not known") from None
        if not source.startswith("def ") or function.__closure__:
            raise Refused(f"function '{name}' is a lambda expression, a method or a closure; write it with def")
        return {"source": source, "name": function.__name__}


def _imported(module: str, name: str) -> Any:
    """Return the object with a dotted name in an imported module; None if it does not exist."""
    import sys

    found = sys.modules.get(module)
    for part in name.split("."):
        found = getattr(found, part, None)
    return found


class Decoder:
    """Turns JSON into values; functions only if `allowCode`."""

    def __init__(self, arrays: Mapping[str, Any], allowCode: bool) -> None:
        self._arrays = arrays
        self._allow_code = allowCode

    def value(self, value: Any, kind: str) -> Any:
        """Return the value of a parameter of a kind, in the words of Encoder.value."""
        if kind in ("OutputVariableType", "list of JointType"):
            enumeration = getattr(dalembert, kind.removeprefix("list of "))
            return [_member(enumeration, v) for v in value] if isinstance(value, list) else _member(enumeration, value)
        if isinstance(value, list):
            return [self.value(entry, kind) for entry in value]
        if not isinstance(value, dict):
            return value
        if kind.startswith("BeamSection") and kind in _SECTIONS:
            return self._section(value, _SECTIONS[kind])
        mark = next((key for key in _MARKS if key in value), None)
        if mark is not None:
            return getattr(self, f"_{mark}")(value)
        if kind != "object":
            raise Refused(f"received {value!r}, but expected one of the keys {', '.join(_MARKS)}")
        return {key: self.value(entry, kind) for key, entry in value.items()}

    def _array(self, value: Any) -> Any:
        array = np.array(value["array"], dtype=_plain_dtype(value.get("dtype", "<f8")))
        return array.reshape(value["shape"]) if "shape" in value else array

    def _npz(self, value: Any) -> Any:
        if value["npz"] not in self._arrays:
            known = ", ".join(self._arrays) or "nothing"
            raise Refused(f"there is no array '{value['npz']}' in the separate file, which has {known}")
        return self._arrays[value["npz"]]

    def _sparse(self, value: Any) -> Any:
        import scipy.sparse

        found = value["sparse"]
        rows = np.asarray(self._npz(found) if isinstance(found, dict) else found, dtype=float).reshape(-1, 3)
        places = rows[:, :2].astype(int).T
        matrix = MatrixContainer()
        n, m = value["shape"]
        matrix.SetWithSparseMatrix(scipy.sparse.csr_matrix((rows[:, 2], places), shape=(n, m)), n, m, False)
        return matrix

    def _tuple(self, value: Any) -> Any:
        return tuple(self.value(value["tuple"], "object"))

    def _entries(self, value: Any) -> Any:
        return dict(self.value(pair, "object") for pair in value["entries"])

    def _enumeration(self, value: Any) -> Any:
        cls, _, name = value["enumeration"].partition(".")
        enumeration = getattr(_core, cls, None)
        if not (isinstance(enumeration, type) and issubclass(enumeration, Enum)):
            raise Refused(f"there is no enumeration '{cls}'")
        return _member(enumeration, name)

    def _section(self, value: Any, cls: Any) -> Any:
        section = cls()
        entries = {key: self.value(entry, "object") for key, entry in value.items()}
        if "crossSectionType" in entries:
            entries["crossSectionType"] = _member(dalembert.CrossSectionType, entries["crossSectionType"])
        section.SetDictionary(entries)
        return section

    def _function(self, value: Any) -> Any:
        self._require_permission(f"the function {value['function']}")
        module, _, name = value["function"].partition(":")
        found: Any = importlib.import_module(module)
        for part in name.split("."):
            found = getattr(found, part)
        return found

    def _source(self, value: Any) -> Callable[..., Any]:
        self._require_permission(f"the code of function '{value['name']}'")
        scope: dict[str, Any] = {"np": np, "exu": dalembert, "exudyn": dalembert}
        exec(value["source"], scope)
        made: Callable[..., Any] = scope[value["name"]]
        return made

    def _recorded(self, value: Any) -> Any:
        if not isinstance(value["recorded"], dict):
            raise Refused(f"received {value!r}, which is no recorded function")
        return _core.symbolic.UserFunction._FromStored(value["recorded"])

    def _require_permission(self, what: str) -> None:
        if not self._allow_code:
            raise Refused(f"is {what}: loading it runs code. Pass allowCode=True if you trust the file")


def _member(enumeration: Any, name: Any) -> Any:
    if isinstance(name, str) and name in enumeration.__members__:
        return enumeration[name]
    raise Refused(f"received {name!r}, but expected one of {', '.join(enumeration.__members__)}")


def _plain_dtype(name: str) -> Any:
    dtype = np.dtype(name)
    if dtype.hasobject:
        raise Refused(f"arrays of {name} are refused: they may hold code")
    return dtype
