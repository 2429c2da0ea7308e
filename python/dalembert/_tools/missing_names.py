"""What to say of a name that an object does not have: the nearest one, or where it belongs."""

from __future__ import annotations

import enum
from collections.abc import Callable, Iterable
from typing import Any, NoReturn

from dalembert import _core
from dalembert._core import MainSystem, Renderer, SystemContainer, SystemData


def nearest(name: str, known: Iterable[str]) -> str:
    """Return '. Did you mean ...?' for the nearest known name; nothing if none is near."""
    import difflib

    public = [each for each in known if not each.startswith("_")]
    parts = [each for each in public if len(name) >= 4 and name.lower() in each.lower()]
    close = difflib.get_close_matches(name, public, n=1, cutoff=0.7) or sorted(parts, key=len)
    return f". Did you mean '{close[0]}'?" if close else ""


# How a method of each class is called in models.
_OWNERS = {MainSystem: "mbs", SystemContainer: "SC", SystemData: "mbs.systemData", Renderer: "SC.renderer"}
_IN_WORDS = {
    "mbs": "a system",
    "SC": "a system container",
    "mbs.systemData": "the data of a system",
    "SC.renderer": "the renderer of a container",
}


def _belongs_to(cls: type, name: str) -> str:
    owner = next((spelt for other, spelt in _OWNERS.items() if other is not cls and hasattr(other, name)), None)
    return f"; it belongs to {_IN_WORDS[owner]}: {owner}.{name}" if owner else ""


def _explaining(cls: type) -> Callable[[Any, str], NoReturn]:
    def __getattr__(self: Any, name: str) -> NoReturn:
        text = f"'{cls.__name__}' object has no attribute '{name}'"
        hint = "" if name.startswith("_") else _belongs_to(cls, name) or nearest(name, dir(cls))
        raise AttributeError(text + hint, name=name, obj=self)

    return __getattr__


class _ExplainingEnum(enum.EnumType):
    """Type of enumerations; of a value that is not there, it tells the nearest."""

    def __getattr__(cls, name: str) -> NoReturn:
        hint = "" if name.startswith("_") else nearest(name, cls.__members__)
        raise AttributeError(f"{cls.__name__} has no value '{name}'{hint}", name=name, obj=cls)


def _explain_setting(cls: type) -> None:
    """Let a class name the nearest attribute when one is set that it has not."""

    def __setattr__(self: Any, name: str, value: Any) -> None:
        try:
            object.__setattr__(self, name, value)
        except AttributeError:
            if not hasattr(type(self), name):
                getattr(self, name)  # which explains
            raise

    cls.__setattr__ = __setattr__  # type: ignore[assignment]


def explain() -> None:
    """Let the classes of the core explain themselves."""
    switches = {type(each) for each in (_core.config, _core.special, _core.special.solver, _core.experimental)}
    _core._explain_missing_attributes(_explaining(MainSystem))  # models call its methods very often
    for cls in {*_OWNERS, *switches} - {MainSystem}:
        cls.__getattr__ = _explaining(cls)  # type: ignore[attr-defined]
    for cls in {*_OWNERS, *switches}:
        _explain_setting(cls)
    for made in vars(_core).values():
        if type(made) is enum.EnumType:
            made.__class__ = _ExplainingEnum


def paths_of_setting(name: str) -> list[str]:
    """Return the paths of the settings of a simulation that have this name, in any group."""
    found: list[str] = []

    def look(group: dict[str, Any], path: str) -> None:
        for key, value in group.items():
            if isinstance(value, dict):
                look(value, f"{path}{key}.")
            elif key == name:
                found.append(path + key)

    look(_core.SimulationSettings().GetDictionary(), "")
    return found
