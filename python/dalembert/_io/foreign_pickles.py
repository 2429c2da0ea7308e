"""Pickles of the package that the interface is shared with: their enumerations become ours."""

from __future__ import annotations

import pickle
from enum import Enum
from typing import IO, Any

from dalembert import _core

_FOREIGN = "exudyn"


class _Value:
    """Stands for a member of an enumeration until its number is known."""

    kind: type[Enum]

    def __setstate__(self, state: Any) -> None:
        self.number = int(state[0] if isinstance(state, tuple) else state)


class _Unpickler(pickle.Unpickler):
    def find_class(self, module: str, name: str) -> Any:
        if module.partition(".")[0] != _FOREIGN:
            return super().find_class(module, name)
        found = getattr(_core, name, None)
        if isinstance(found, type) and issubclass(found, Enum):
            return type(name, (_Value,), {"kind": found})
        raise pickle.UnpicklingError(f"{module}.{name} is not known here")


def load(file: IO[bytes]) -> Any:
    """Load a pickle, ours or of the other package; as with all pickles, code in it is run."""
    return _ours(_Unpickler(file).load())


def _ours(value: Any) -> Any:
    if isinstance(value, _Value):
        return value.kind(value.number)
    if isinstance(value, dict):
        return {key: _ours(entry) for key, entry in value.items()}
    if isinstance(value, list):
        return [_ours(entry) for entry in value]
    return value
