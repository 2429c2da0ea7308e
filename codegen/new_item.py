"""Start a new item: its spec, and the skeleton of its kernel.

A kind has two templates in templates/new/, `<kind>.toml.j2` and `<kind>.hpp.j2`: a complete small item, to be modified.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path

from codegen.model import SpecError
from codegen.names import FOLDERS, nearest, stem_of
from codegen.render import fill

# Kind -> folder of specs/, and type of objects.
KINDS = {
    "node": ("nodes", ""),
    "body": ("bodies", "Body"),
    "super_element": ("super_elements", "SuperElement"),
    "finite_element": ("finite_elements", "FiniteElement"),
    "connector": ("connectors", "Connector"),
    "contact": ("contacts", "Connector"),
    "constraint": ("constraints", "Constraint"),
    "joint": ("joints", "Joint"),
    "marker": ("markers", ""),
    "load": ("loads", ""),
    "sensor": ("sensors", ""),
}


@dataclass(frozen=True)
class NewItem:
    """Variables of the templates."""

    name: str
    type_name: str
    object_type: str
    folder: str
    stem: str
    kernel: str  # path of its header
    short_names: tuple[str, ...] = ()
    node: str = "NodePoint"  # of bodies


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("kind", choices=KINDS)
    parser.add_argument("name", help="name of the item, with or without what the names of its kind begin with")


def full_name(folder: str, name: str) -> str:
    """`ObjectJointUniversal` of `Universal`, `JointUniversal` or itself."""
    longest, shortest = FOLDERS[folder][1][0], FOLDERS[folder][1][-1]
    if name.startswith(shortest):
        return name
    own = longest.removeprefix(shortest)
    return shortest + name if own and name.startswith(own) else longest + name


def create(root: Path, kind: str, name: str, kernels: str = "", node: str = "NodePoint") -> list[str]:
    """Write spec and kernel skeleton; returns the paths written. Existing files are never touched.

    `kernels` is the folder of the kernels of a package, whose items get a short name. `node` is that of a body.
    """
    if kind not in KINDS:
        raise SpecError(f"kind: there is no kind {kind!r} of items; {nearest(kind, KINDS)}")
    folder, object_type = KINDS[kind]
    longest, shortest = FOLDERS[folder][1][0], FOLDERS[folder][1][-1]
    full = full_name(folder, name)
    if not full.isidentifier() or full in (longest, shortest):
        raise SpecError(f"name: {name!r} does not make the name of an item")
    stem = stem_of(full, folder)
    kernel = f"{kernels or 'core/include/dalembert/items'}/{stem}.hpp"
    short = (full.removeprefix(longest),) if kernels and longest != full.removeprefix(longest) else ()
    item = NewItem(full, full.removeprefix(shortest), object_type, folder, stem, kernel, short, node)
    files = {
        f"specs/{stem}.toml": fill(f"new/{kind}.toml.j2", item=item),
        kernel: fill(f"new/{kind}.hpp.j2", item=item),
    }
    for path in files:
        if (root / path).exists():
            raise SpecError(f"{path}: exists already")
    for path, content in files.items():
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(content, "utf-8")
    return list(files)
