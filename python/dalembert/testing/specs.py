"""The specs of the items that are tested: those of the core, or of an item package with those of the core."""

from __future__ import annotations

import tomllib
from pathlib import Path

from codegen.load import known_specs
from codegen.model import Item
from dalembert._tools.item_builds import home, module_name
from dalembert._tools.item_packages import GROUP, load_installed


def _package() -> Path | None:
    """Return the directory of the item package that is tested: the working directory, or the next one above it."""
    for directory in (Path.cwd(), *Path.cwd().parents):
        project = directory / "pyproject.toml"
        if project.is_file():
            entry_points = tomllib.loads(project.read_text("utf-8")).get("project", {}).get("entry-points", {})
            return directory if GROUP in entry_points else None
    return None


def _items() -> tuple[dict[str, Item], set[str]]:
    """Return all items, and the names of those that are tested."""
    directory = _package()
    if directory is None:
        core = {item.name: item for item in known_specs(home())[0]}
        return core, set(core)
    from importlib import import_module

    from codegen.item_package import load

    load_installed()
    import_module(module_name(directory))
    specs, own = load(directory)
    return {item.name: item for item in (*specs.items, *own)}, {item.name for item in own}


ITEMS, TESTED = _items()
