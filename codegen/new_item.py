"""Start a new item: its spec, and the skeleton of its kernel."""

from __future__ import annotations

import argparse
from pathlib import Path

from codegen.model import SpecError
from codegen.names import FOLDERS, nearest, stem_of
from codegen.render import fill

# The folder of a kind, where none is asked for.
DEFAULT_FOLDERS = {"node": "nodes", "object": "bodies", "marker": "markers", "load": "loads", "sensor": "sensors"}
OBJECT_TYPES = {
    "bodies": "Body", "super_elements": "SuperElement", "finite_elements": "FiniteElement", "connectors": "Connector",
    "contacts": "Connector", "constraints": "Constraint", "joints": "Joint",
}  # fmt: skip


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("kind", choices=DEFAULT_FOLDERS)
    parser.add_argument("name", help="name of the item, with or without the kind in front: MyItem or ObjectMyItem")
    parser.add_argument("--folder", default="", help="folder of specs/: " + ", ".join(FOLDERS))


def create(root: Path, kind: str, name: str, folder: str = "") -> list[str]:
    """Write spec and kernel skeleton; returns the paths written. Existing files are never touched."""
    folder = folder or DEFAULT_FOLDERS[kind]
    if folder not in FOLDERS or FOLDERS[folder][0] != kind:
        of_kind = [f for f, (k, _) in FOLDERS.items() if k == kind]
        raise SpecError(f"--folder: no folder {folder!r} of {kind} items; {nearest(folder, of_kind)}")
    prefix = kind.capitalize()
    full = name if name.startswith(prefix) else prefix + name
    if not full.isidentifier() or full == prefix:
        raise SpecError(f"name: {name!r} does not make the name of an item")
    stem = stem_of(full, folder)
    context = {"name": full, "type_name": full.removeprefix(prefix), "stem": stem, "folder": folder}
    files = {f"specs/{stem}.toml": fill("new_spec.toml.j2", **context, object_type=OBJECT_TYPES.get(folder, ""))}
    if kind != "sensor":
        files[f"core/include/dalembert/items/{stem}.hpp"] = fill(
            "new_kernel.hpp.j2", name=full, stem=stem, folder=folder
        )
    for path in files:
        if (root / path).exists():
            raise SpecError(f"{path}: exists already")
    for path, content in files.items():
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(content, "utf-8")
    return list(files)
