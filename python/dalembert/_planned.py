"""Errors for planned modules when they are imported, and for planned classes and functions when they are called.

The list is generated from the specs, see _planned_table.py.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from types import ModuleType
from typing import Any, NoReturn

from dalembert._planned_table import FUNCTIONS, MODULES, Planned

__all__ = ["SolverFileData", "SolverLocalData"]

_PACKAGE = "dalembert"


def _text(name: str, planned: Planned) -> str:
    instead = f"; until then: {planned.instead}" if planned.instead else ""
    return f"{name} is planned and not available yet: {planned.what}{instead}"


def refuse(name: str, member: str = "") -> NoReturn:
    """Raise the NotImplementedError of a planned class or function, given by its name in the list."""
    shown = name.removeprefix("FEM.").removeprefix("shells.")
    raise NotImplementedError(_text(f"{shown}.{member}" if member else shown, FUNCTIONS[name]))


def _planned_method(name: str) -> Callable[..., NoReturn]:
    """Return a method of MainSystem that does nothing but refuse."""

    def method(mbs: Any, *args: Any, **kwargs: Any) -> NoReturn:
        refuse(name)

    method.__name__ = name.rpartition(".")[2]
    method.__qualname__ = name
    method.__doc__ = f"Planned: {FUNCTIONS[name].what}; raises NotImplementedError."
    return method


# Methods of MainSystem, by name.
methods = {
    name.removeprefix("MainSystem."): _planned_method(name) for name in FUNCTIONS if name.startswith("MainSystem.")
}


def module_text(name: str) -> str:
    """Return the message of a planned module of the package, for example robotics.models; "" if it is not planned."""
    return _text(f"the module {_PACKAGE}.{name}", MODULES[name]) if name in MODULES else ""


class _Finder:
    """Is asked last, for modules that nobody else has found."""

    def find_spec(self, fullname: str, path: Sequence[str] | None = None, target: ModuleType | None = None) -> None:
        package, _, name = fullname.partition(".")
        if package == _PACKAGE and (text := module_text(name)):
            raise ModuleNotFoundError(text, name=fullname)
        parent, _, missing = fullname.rpartition(".")
        if package == _PACKAGE and parent in sys.modules:
            from dalembert._tools.missing_names import refuse_import

            refuse_import(sys.modules[parent], missing)


if not any(type(finder).__qualname__ == _Finder.__qualname__ for finder in sys.meta_path):
    sys.meta_path.append(_Finder())


class _PlannedClass:
    def __init__(self, *args: Any, **kwargs: Any) -> NoReturn:
        refuse(type(self).__name__)


class SolverFileData(_PlannedClass):
    """Files of a solver; planned."""


class SolverLocalData(_PlannedClass):
    """Vectors and matrices of a solver; planned."""
