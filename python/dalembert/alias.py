"""Run models that import the package under another name: install("exudyn") makes that name mean dalembert."""

from __future__ import annotations

import importlib
import importlib.util
import sys
from collections.abc import Sequence
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec
from types import ModuleType

_PACKAGE = "dalembert"
_RENAMED = {
    "exudynCPP": "_core",
    "misc.GUI": "GUI",
    "misc.mainSystemExtensions": "mainSystemExtensions",
    "misc.resultsMonitor": "resultsMonitor",
}


class _AliasLoader(Loader):
    """Gives an already existing module under a second name."""

    def __init__(self, target: str) -> None:
        self.target = target
        self.spec: ModuleSpec | None = None

    def create_module(self, spec: ModuleSpec) -> ModuleType:
        module = importlib.import_module(self.target)
        self.spec = module.__spec__
        return module

    def exec_module(self, module: ModuleType) -> None:
        module.__spec__ = self.spec  # the import system has put the alias' own there


class _AliasFinder(MetaPathFinder):
    """Finds `name` and `name.sub` as dalembert and dalembert.sub."""

    def __init__(self, name: str) -> None:
        self.name = name

    def target(self, fullname: str) -> str | None:
        """Return the module of an alias, or None if the name is not an alias."""
        if fullname == self.name:
            return _PACKAGE
        if not fullname.startswith(self.name + "."):
            return None
        rest = fullname.removeprefix(self.name + ".")
        return f"{_PACKAGE}.{_RENAMED.get(rest, rest)}"

    def find_spec(
        self, fullname: str, path: Sequence[str] | None = None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        name = self.target(fullname)
        if name is None or (name not in sys.modules and importlib.util.find_spec(name) is None):
            return None
        is_package = hasattr(sys.modules.get(name), "__path__")
        return ModuleSpec(fullname, _AliasLoader(name), is_package=is_package)


def _finder(name: str) -> _AliasFinder | None:
    return next((f for f in sys.meta_path if isinstance(f, _AliasFinder) and f.name == name), None)


def install(name: str = "exudyn", interface: str | None = None) -> None:
    """Make `import name`, including submodules, import dalembert and its submodules; may be called again.

    interface: release whose defaults models rely on, "1.11" or "1.13", see RequireVersion; None: no change.
    RuntimeError if another package of that name has been imported before: its objects and ours must not be mixed.
    """
    package = importlib.import_module(_PACKAGE)
    if interface is not None:
        importlib.import_module(f"{_PACKAGE}._version").use_interface(interface)
    present = sys.modules.get(name)
    if present is not None and present is not package:
        where = getattr(present, "__file__", None) or "unknown location"
        raise RuntimeError(
            f"alias.install('{name}'): another package '{name}' ({where}) has been imported already; "
            "install the alias before anything imports it"
        )
    if _finder(name) is None:
        sys.meta_path.insert(0, _AliasFinder(name))
    sys.modules[name] = package


def uninstall(name: str = "exudyn") -> None:
    """Remove the alias: later imports of `name` find the installed package."""
    finder = _finder(name)
    if finder is None:
        return
    sys.meta_path.remove(finder)
    for module in [m for m in sys.modules if m == name or m.startswith(name + ".")]:
        del sys.modules[module]
