"""Packages with items of their own: they are found and loaded; item_builds.py builds them.

A package names its module in the group 'dalembert.items' of its entry points.
"""

from __future__ import annotations

import os
import sys
import warnings
from collections.abc import Iterable, Iterator
from functools import cache
from importlib import import_module
from typing import Any, NamedTuple

from dalembert import _core

GROUP = "dalembert.items"


class Package(NamedTuple):
    module: str
    distribution: str
    version: str


def installed() -> list[Package]:
    """Return the item packages that are installed, by the names of their modules."""
    from importlib import metadata  # here, as it imports email and most models need no packages

    found = {}
    for entry in metadata.entry_points(group=GROUP):
        distribution = entry.dist
        name, version = (distribution.name, distribution.version) if distribution is not None else ("", "")
        found[entry.value] = Package(entry.value, name, version)
    return [found[module] for module in sorted(found)]


def load_installed() -> None:
    """Import all installed item packages; those that fail give a warning."""
    for package in installed():
        if package.module in sys.modules:
            continue
        try:
            import_module(package.module)
        except ImportError as error:
            warnings.warn(f"the item package '{package.module}' cannot be imported: {error}", stacklevel=2)


def load(modules: Iterable[str], what: str) -> None:
    """Import these item packages, which something such as 'model.json' needs; ImportError names a missing one.

    A file can name any module, but only item packages are imported.
    """
    known: set[str] | None = None
    for module in modules:
        if module in sys.modules:
            continue
        known = {package.module for package in installed()} if known is None else known
        if module not in known:
            raise ImportError(
                f"{what} has items of the package '{module}', which is not installed. Install it "
                f"(pip install {module}), or import it before."
            )
        import_module(module)


def module_of(cls: type) -> str:
    """Return the module of the package of an item class; '' for those of the core."""
    return "" if cls.__module__ == "dalembert._core" else cls.__module__


def item_classes() -> dict[str, type]:
    """Return all classes of items and of their visualization, of packages too, by their full and short names."""
    return _core._item_classes()


def item_class(name: str) -> Any:
    """Return a class by its name."""
    return _core._item_classes()[name]


@cache
def _facts_of(module: str) -> dict[str, Any]:
    import json

    folder = os.path.dirname(str(import_module(f"{module}._items").__file__))
    with open(os.path.join(folder, "_items.json"), encoding="utf-8") as file:
        facts: dict[str, Any] = json.load(file)
    return facts


def facts(table: str) -> Iterator[Any]:
    """Return the entries of a table that the generator made for the items of each imported package."""
    modules = {module_of(cls) for cls in item_classes().values()} - {""}
    for module in sorted(modules):
        yield _facts_of(module)[table]


def drawings_of_packages() -> dict[str, tuple[str, str]]:
    """Return the folder, and the drawing that the spec names, by the type names of objects of packages."""
    return {name: (folder, drawing) for table in facts("drawings") for name, (folder, drawing) in table.items()}
