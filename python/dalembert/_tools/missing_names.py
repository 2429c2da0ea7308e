"""Error texts for missing names: the nearest one, or the object that has it."""

from __future__ import annotations

import enum
import sys
from collections.abc import Callable, Iterable, Mapping
from types import ModuleType
from typing import Any, NoReturn

from dalembert import _core
from dalembert._core import MainSystem, Renderer, SystemContainer, SystemData


def nearest(name: str, known: Iterable[str]) -> str:
    """Return '. Did you mean ...?' for the nearest known name; '' if no name is near."""
    import difflib

    public = [each for each in known if not each.startswith("_")]
    parts = [each for each in public if len(name) >= 4 and name.lower() in each.lower()]
    close = difflib.get_close_matches(name, public, n=1, cutoff=0.7) or sorted(parts, key=len)
    return f". Did you mean '{close[0]}'?" if close else ""


def left_out(name: str) -> str:
    """Return '; left out here, instead: ...' for a name of the interface, module.function or Class.member; else ''."""
    from dalembert._planned_table import LEFT_OUT

    words = name.split(".")
    for i in range(len(words), 0, -1):
        tried = ".".join(words[:i])
        for entry in (f"{tried}.*", tried if i == len(words) else ""):
            if entry in LEFT_OUT:
                return f"; left out here, instead: {LEFT_OUT[entry]}"
    return ""


def missing(text: str, hint: str, name: str, owner: object) -> AttributeError:
    """Return the error of a missing attribute. If there is a hint, Python must not add its own."""
    return AttributeError(text + hint, name=name, obj=None if hint else owner)


# How a method of each class is called in models.
_OWNERS = {MainSystem: "mbs", SystemContainer: "SC", SystemData: "mbs.systemData", Renderer: "SC.renderer"}
_IN_WORDS = {
    "mbs": "a system",
    "SC": "a system container",
    "mbs.systemData": "the data of a system",
    "SC.renderer": "the renderer of a container",
}


# Objects that have names which users look for in a system.
_ELSEWHERE = {
    "gravity": "; weight acts on bodies, by gravity=[0, 0, -9.81] of mbs.CreateRigidBody(...) and the like",
    "time": "; it belongs to the data of a system: mbs.systemData.GetTime()",
    "step": "; solvers move a system: mbs.SolveDynamic(simulationSettings)",
    "Simulate": "; solvers move a system: mbs.SolveDynamic(simulationSettings)",
}


def _belongs_to(cls: type, name: str) -> str:
    if cls is MainSystem and name in _ELSEWHERE:
        return _ELSEWHERE[name]
    owner = next((spelt for other, spelt in _OWNERS.items() if other is not cls and hasattr(other, name)), None)
    return f"; it belongs to {_IN_WORDS[owner]}: {owner}.{name}" if owner else ""


def _explaining(cls: type) -> Callable[[Any, str], NoReturn]:
    def __getattr__(self: Any, name: str) -> NoReturn:
        text = f"'{cls.__name__}' object has no attribute '{name}'"
        found = "" if name.startswith("_") else left_out(f"{cls.__name__}.{name}") or _belongs_to(cls, name)
        hint = "" if name.startswith("_") else found or nearest(name, dir(cls))
        raise missing(text, hint, name, self)

    return __getattr__


class _ExplainingEnum(enum.EnumType):
    """Type of enumerations whose errors for missing values suggest the nearest one."""

    def __getattr__(cls, name: str) -> NoReturn:
        hint = "" if name.startswith("_") else nearest(name, cls.__members__)
        raise missing(f"{cls.__name__} has no value '{name}'", hint, name, cls)


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
            members: Mapping[str, Any] = made.__members__
            for name, member in members.items():
                type.__setattr__(made, name, member)  # as from Python 3.12 on; before, a function returns them
    _core._look_up_directly(_ExplainingEnum)


# ---- modules ---------------------------------------------------------------------------------------------------------


def _offers(module: ModuleType, name: str) -> bool:
    if public := vars(module).get("__all__"):
        return name in public  # also if it is loaded when it is first used
    return getattr(vars(module).get(name), "__module__", "") == module.__name__


def _module_with(name: str) -> str:
    """Return '; it belongs to dalembert....' for a name that a module of the package has."""
    from importlib import import_module

    for each in sorted(sys.modules["dalembert"]._submodules):
        try:
            module = import_module(f"dalembert.{each}")
        except ImportError:  # the module needs a package that is not installed
            continue
        if _offers(module, name):
            return f"; it belongs to {module.__name__}"
    return ""


def _names_in(module: ModuleType) -> list[str]:
    names = vars(module)
    return dir(module) if "__dir__" in names else names.get("__all__") or [n for n in names if not n.startswith("_")]


def _hint(module: ModuleType, name: str) -> str:
    if not name or name.startswith("_"):
        return ""
    if found := left_out(f"{module.__name__.removeprefix('dalembert.')}.{name}"):
        return found
    if hasattr(MainSystem, name):
        return f"; it is a method of a system: mbs.{name}(...)"
    if hasattr(_core, name) and module.__name__ != "dalembert":
        return "; it belongs to dalembert"
    return nearest(name, _names_in(module)) or _module_with(name)


_FEW = 60  # up to this number, all names are listed


def missing_in(module: ModuleType, name: str) -> AttributeError:
    """Return the error of a name missing in a module, for its __getattr__."""
    known, hint = _names_in(module), _hint(module, name)
    if not hint and len(known) <= _FEW and not name.startswith("_"):
        hint = f"; known are: {', '.join(known)}"
    return missing(f"module '{module.__name__}' has no attribute '{name}'", hint, name, module)


def refuse_import(module: ModuleType, name: str) -> None:
    """Raise the ImportError of a name missing in a module, if there is a hint."""
    where = module.__name__
    if where == "dalembert" and not name.startswith("_") and (near := nearest(name, sys.modules[where]._submodules)):
        raise ModuleNotFoundError(f"No module named '{where}.{name}'{near}", name=where)
    if hint := _hint(module, name):
        raise ImportError(f"cannot import name '{name}' from '{where}'{hint}", name=where, path=module.__file__)


class ExplainingPackage(ModuleType):
    """A package whose modules suggest the nearest name for a missing one."""

    def __setattr__(self, name: str, value: Any) -> None:
        if isinstance(value, ModuleType) and value.__name__ == f"{self.__name__}.{name}" and not name.startswith("_"):
            explain_module(value)
        super().__setattr__(name, value)

    def __reduce__(self) -> Any:
        from importlib import import_module

        return import_module, (self.__name__,)  # same method as in cloudpickle for plain modules


# Python finds names of modules with a __getattr__ in ten times as long, and of this one many.
_QUICK = ("dalembert.itemInterface",)


def explain_module(module: ModuleType) -> None:
    """Make a module explain missing names; for a package, this includes its current and future modules."""
    if "__getattr__" not in vars(module) and module.__name__ not in _QUICK:

        def __getattr__(name: str) -> NoReturn:
            raise missing_in(module, name)

        module.__getattr__ = __getattr__  # type: ignore[method-assign]
    if "__path__" not in vars(module):
        module.__path__ = []  # `from module import name` asks the finders of _planned.py for missing names
    elif not isinstance(module, ExplainingPackage):
        module.__class__ = ExplainingPackage
        for name, part in list(vars(module).items()):
            setattr(module, name, part)


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
