"""Packages that are imported when they are first used."""

from __future__ import annotations

from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any


class _Later(ModuleType):
    """Stands for a package: it is imported when an attribute is read."""

    def __getattr__(self, name: str) -> Any:
        return getattr(import_module(self.__name__), name)


if TYPE_CHECKING:
    import scipy as scipy
else:
    scipy = _Later("scipy")  # it imports subprocess and more, which takes as long as all of our own modules for meshes
