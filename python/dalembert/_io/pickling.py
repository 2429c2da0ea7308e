"""Pickles and copies of a MainSystem: user functions that no module holds go along by value."""

from __future__ import annotations

import copy
import io
from collections.abc import Callable
from contextlib import suppress
from pickle import Unpickler
from typing import Any, Self

from dalembert._core import ConfigurationType, MainSystem

_dictionary: Callable[[MainSystem], dict[str, Any]] = MainSystem.GetDictionary  # the compiled one, replaced below
_variables = ("variables", "systemVariables")
_STATES = "systemStates"  # states of an assembled system: coordinates and times, by configuration
_CONFIGURATIONS = ("Initial", "StartOfStep", "Current")
_PARTS = (
    "ODE2Coordinates",
    "ODE2Coordinates_t",
    "ODE2Coordinates_tt",
    "ODE1Coordinates",
    "ODE1Coordinates_t",
    "AECoordinates",
    "_MultiplierSign",
    "DataCoordinates",
    "Time",
)


class _Unpickler(Unpickler):
    """Puts another system and its container in the place of those left out."""

    def __init__(self, file: io.BytesIO, mbs: MainSystem) -> None:
        super().__init__(file)
        self._mbs = mbs

    def persistent_load(self, name: str) -> Any:
        return self._mbs if name == "system" else self._mbs.GetSystemContainer()


def _dumps(mbs: MainSystem, content: Any) -> bytes:
    from dalembert._io.system_pickler import SystemPickler  # its package takes long to load

    file = io.BytesIO()
    SystemPickler(file, mbs).dump(content)
    return file.getvalue()


def _restored_dictionary(content: bytes) -> SystemDictionary:
    """The dictionary; functions in it that refer to the system get one that is made of the dictionary."""
    mbs = MainSystem()
    entries = _Unpickler(io.BytesIO(content), mbs).load()
    mbs.SetDictionary(entries)
    return SystemDictionary(mbs, entries)


def _restored_system(content: bytes) -> MainSystem:
    mbs = MainSystem()
    _restore(mbs, _Unpickler(io.BytesIO(content), mbs).load())
    return mbs


def _restore(mbs: MainSystem, entries: dict[str, Any]) -> None:
    """Give a new system the items and, if the one that they are from was assembled, its coordinates."""
    states = entries.pop(_STATES, None)
    mbs.SetDictionary(entries)
    if states is None:
        return
    mbs.Assemble()
    for configuration, parts in states.items():
        for part, values in parts.items():
            _method(mbs, "Set", part)(values, getattr(ConfigurationType, configuration))


def _states(mbs: MainSystem) -> dict[str, dict[str, Any]]:
    return {
        configuration: {part: _method(mbs, "Get", part)(getattr(ConfigurationType, configuration)) for part in _PARTS}
        for configuration in _CONFIGURATIONS
    }


def _method(mbs: MainSystem, verb: str, part: str) -> Callable[..., Any]:
    name = f"_{verb}{part[1:]}" if part.startswith("_") else f"{verb}{part}"
    method: Callable[..., Any] = getattr(mbs.systemData, name)
    return method


class SystemDictionary(dict[str, Any]):
    """Result of GetDictionary(): a dictionary whose pickle stores functions by value if no module has them."""

    __slots__ = ("_mbs",)

    def __init__(self, mbs: MainSystem, entries: dict[str, Any]) -> None:
        super().__init__(entries)
        self._mbs = mbs

    def __reduce__(self) -> tuple[Callable[[bytes], SystemDictionary], tuple[bytes]]:
        return _restored_dictionary, (_dumps(self._mbs, dict(self)),)

    def __copy__(self) -> Self:
        return type(self)(self._mbs, self)

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        return type(self)(self._mbs, copy.deepcopy(dict(self), memo))


def GetDictionary(mbs: MainSystem) -> dict[str, Any]:
    """Return all items, user functions and variables as one dictionary.

    It can be pickled, with the user functions: those of modules by their names, others, such as functions of the main
    program, lambda expressions and closures, with their code and the global variables that they use.
    """
    return SystemDictionary(mbs, _dictionary(mbs))


def _state(mbs: MainSystem) -> dict[str, Any]:
    """The dictionary without variables that cannot be pickled, as solvers kept there, and with coordinates."""
    entries = GetDictionary(mbs)
    for name in _variables:
        entries[name] = {key: value for key, value in entries[name].items() if _can_be_pickled(mbs, value)}
    if mbs.systemIsConsistent:
        with suppress(RuntimeError):  # another thread is solving it, and coordinates change
            entries[_STATES] = _states(mbs)
    return entries


def _can_be_pickled(mbs: MainSystem, value: Any) -> bool:
    try:
        _dumps(mbs, value)
    except Exception:  # any exception of the class of the value
        return False
    return True


def __reduce__(mbs: MainSystem) -> tuple[Callable[[bytes], MainSystem], tuple[bytes]]:
    return _restored_system, (_dumps(mbs, dict(_state(mbs))),)


def __copy__(mbs: MainSystem) -> MainSystem:
    made = MainSystem()
    _restore(made, _state(mbs))
    return made


def copier(mbs: MainSystem) -> Callable[[], MainSystem]:
    """Return a function that makes copies of a system as it is now; copy.copy reads the system for each of them."""
    state = _state(mbs)

    def made() -> MainSystem:
        copied = MainSystem()
        _restore(copied, state | {name: dict(state[name]) for name in _variables})
        return copied

    return made


def __deepcopy__(mbs: MainSystem, memo: dict[int, Any]) -> MainSystem:
    made = memo[id(mbs)] = MainSystem()
    _restore(made, copy.deepcopy(_state(mbs), memo))
    return made
