"""Items of a package of its own: `python -m codegen.item_package DIRECTORY MODULE OUTPUT` generates their files.

DIRECTORY has specs/<folder>/<stem>.toml and kernels/<folder>/<stem>.hpp. OUTPUT gets C++ sources in src/ and include/,
stubs and tables in python/, and a page of each item in docs/. `python -m codegen.item_package new DIRECTORY KIND NAME`
starts an item, and the package if there is none.
"""

from __future__ import annotations

import json
import sys
from dataclasses import replace
from pathlib import Path

from codegen.__main__ import ROOT, write
from codegen.load import check_references, known_specs, load_items
from codegen.model import Item, SpecError
from codegen.model_settings import Specs
from codegen.names import FOLDERS, nearest
from codegen.new_item import create, full_name
from codegen.render import environment, fill, holes
from codegen.views import cpp, python, schema


def load(directory: Path, home: Path = ROOT) -> tuple[Specs, list[Item]]:
    """The specs of the core, and the items of a package."""
    specs = directory / "specs"
    if not specs.is_dir():
        raise SpecError(f"{directory}: there is no folder specs/; `dalembert items new` makes a package")
    for entry in sorted(specs.iterdir()):
        if entry.name not in (*FOLDERS, "groups") and not entry.name.startswith("."):
            raise SpecError(f"specs/{entry.name}: not a folder of items; {nearest(entry.name, (*FOLDERS, 'groups'))}")
    core, groups, enums = known_specs(home)
    own = load_items(directory, enums, groups)
    if not own:
        raise SpecError(f"{directory}: there are no items in specs/")
    names = {name: item.path for item in core for name in (item.name, *item.short_names)}
    check_references(own, core, enums, directory, names)
    for item in own:
        if item.create_functions:
            raise SpecError(f"{item.path}: create_functions: functions of the core create items of the core only")
        if item.ready and not item.irregular and not (directory / "kernels" / f"{item.stem}.hpp").is_file():
            raise SpecError(f"{item.path}: there is no kernel kernels/{item.stem}.hpp")
    return Specs(tuple(core), tuple(enums.values()), (), ()), own


def files_of(directory: Path, module: str, home: Path = ROOT) -> dict[str, str]:
    """Map each path of the output to its text."""
    core, own = load(directory, home)
    specs = replace(core, items=(*core.items, *own))
    kernels = {item.name: cpp.kernel_header(item) for item in core.items}
    kernels |= {item.name: f"{item.stem}.hpp" for item in own}
    files = {
        "src/registry.cpp": fill("registry.cpp.j2", items=own),
        "src/item_texts.cpp": fill("item_texts.cpp.j2", items=own),
        "src/item_transformations.cpp": fill(
            "item_transformations.cpp.j2", items=[item for item in own if item.transformations]
        ),
        "python/_items.pyi": fill("package_items.pyi.j2", items=own),
        "python/_items.json": json.dumps(facts(specs, own), indent=1, ensure_ascii=False) + "\n",
        "docs/index.rst": fill("package_index.rst.j2", items=own, module=module),
    }
    for item in own:
        files[f"include/dalembert/{item.stem}_parameters.hpp"] = fill("parameters.hpp.j2", item=item)
        files[f"src/{item.stem}.cpp"] = fill("item.cpp.j2", item=item, kernels=kernels)
        files[f"docs/{item.stem}.rst"] = fill("item.rst.j2", item=item, items=specs.items)
    return files


def facts(specs: Specs, own: list[Item]) -> dict[str, object]:
    """Facts that Python needs of items: sizes of user functions, Create functions, the schema of model files."""
    sizes = [
        (item.name, function.name, python.array_sizes(function, item))
        for item in own
        for function in item.user_functions
        if python.has_arrays(function)
    ]
    return {
        "drawings": {item.type_name: (item.folder, item.scene.drawing) for item in own if item.kind == "object"},
        "sizes": sizes,
        "schema": schema.definitions(replace(specs, items=tuple(own))),
    }


PACKAGE_FILES = {
    "pyproject.toml": "package/pyproject.toml.j2",
    ".gitignore": "package/gitignore.j2",
    "CMakeLists.txt": "package/CMakeLists.txt.j2",
    "{module}/__init__.py": "package/init.py.j2",
    "tests/test_items.py": "package/test_items.py.j2",
}


def start(directory: Path, kind: str, name: str, version: str) -> list[str]:
    """Write the files of a package that do not exist, and an item; returns the paths written."""
    module = directory.resolve().name.replace("-", "_")
    if not module.isidentifier():
        raise SpecError(f"{directory.name!r} is not the name of a package: use letters, digits and underscores")
    made = create(directory, kind, name, kernels="kernels")
    if kind == "node":  # which is tested with a body
        node = full_name("nodes", name)
        made += create(directory, "body", f"{node.removeprefix('Node')}Mass", kernels="kernels", node=node)
    given = {"module": module, "version": version}
    for path, template in PACKAGE_FILES.items():
        file = directory / path.format(module=module)
        if not file.exists():
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(fill(template, **{key: given[key] for key in holes(environment(), template)}), "utf-8")
            made.append(file.relative_to(directory).as_posix())
    return made


def main(arguments: list[str]) -> int:
    try:
        if arguments[0] == "new":
            directory, kind, name, version = arguments[1:]
            print("\n".join(start(Path(directory), kind, name, version)))
        else:
            directory, module, output = arguments
            write(Path(output), files_of(Path(directory), module))
    except SpecError as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
