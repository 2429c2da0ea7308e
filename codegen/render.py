"""Turn specs into the text of every generated file. Pure: nothing is read or written here, except templates."""

from __future__ import annotations

import inspect
import re
from collections.abc import Mapping
from functools import cache
from itertools import chain
from types import ModuleType
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined, meta

from codegen import names
from codegen.model import Item
from codegen.model_settings import Specs
from codegen.names import FOLDERS
from codegen.views import cpp, handles, python, rst, schema, settings

_TRAILING_SPACE = re.compile(r"[ \t]+$", re.MULTILINE)
_BLANK_LINES = re.compile(r"\n{3,}")


class TemplateError(RuntimeError):
    """A template and its variables do not agree."""


@cache
def environment() -> Environment:
    env = Environment(
        loader=PackageLoader("codegen"),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
    )
    for module in (cpp, handles, python, rst, schema, settings):
        env.filters |= filters_of(module)
    return env


def filters_of(module: ModuleType) -> dict[str, Any]:
    """The public functions of a view, by name."""
    return {
        name: function
        for name, function in inspect.getmembers(module, inspect.isfunction)
        if function.__module__ == module.__name__ and not name.startswith("_")
    }


def fill(template: str, **context: Any) -> str:
    """Render a template. A hole without a value fails, and so does a value without a hole."""
    env = environment()
    if unused := context.keys() - holes(env, template):
        raise TemplateError(f"{template}: no hole for {', '.join(sorted(unused))}")
    text = _TRAILING_SPACE.sub("", env.get_template(template).render(**context))
    return _BLANK_LINES.sub("\n\n", text).rstrip("\n") + "\n" if template.endswith(".rst.j2") else text


@cache
def holes(env: Environment, template: str) -> frozenset[str]:
    """Names that a template, or one that it extends, needs values for."""
    assert env.loader is not None
    parsed = env.parse(env.loader.get_source(env, template)[0])
    above = (holes(env, name) for name in meta.find_referenced_templates(parsed) if name)
    return frozenset(meta.find_undeclared_variables(parsed)).union(*above)


def render(specs: Specs) -> dict[str, str]:
    """Map each path under generated/ to its text."""
    return {**_cpp_files(specs), **_python_files(specs), **_docs_files(specs), "README.md": fill("README.md.j2")}


def _cpp_files(specs: Specs) -> dict[str, str]:
    kernels = {item.name: cpp.kernel_header(item) for item in specs.items}
    numbers = {enum.name: number for number, enum in enumerate(specs.enums)}
    files = {
        "src/registry.cpp": fill("registry.cpp.j2", items=specs.items),
        "src/item_texts.cpp": fill("item_texts.cpp.j2", items=specs.items),
        "src/item_transformations.cpp": fill(
            "item_transformations.cpp.j2", items=[item for item in specs.items if item.transformations]
        ),
        "src/settings_texts.cpp": fill(
            "settings_texts.cpp.j2", structs=list(chain(*map(settings.structs, specs.settings))), enums=specs.enums
        ),
        "include/dalembert/enums.hpp": fill("enums.hpp.j2", enums=specs.enums),
        "src/enums.cpp": fill("enums.cpp.j2", enums=specs.enums),
    }
    for item in specs.items:
        files[f"include/dalembert/{item.stem}_parameters.hpp"] = fill("parameters.hpp.j2", item=item)
        files[f"src/{item.stem}.cpp"] = fill("item.cpp.j2", item=item, kernels=kernels)
    for each in specs.settings:
        parts = settings.structs(each)
        files[f"include/dalembert/{each.stem}.hpp"] = fill("settings.hpp.j2", settings=each, structs=parts)
        files[f"src/{each.stem}.cpp"] = fill("settings.cpp.j2", settings=each, structs=parts, enum_numbers=numbers)
    return files


def _python_files(specs: Specs) -> dict[str, str]:
    parts = [settings.structs(each) for each in specs.settings]
    return {
        "python/dalembert/_core_items.pyi": fill("core_items.pyi.j2", items=specs.items),
        "python/dalembert/_core_enums.pyi": fill("core_enums.pyi.j2", enums=specs.enums),
        "python/dalembert/_core_settings.pyi": fill("core_settings.pyi.j2", files=parts),
        "python/dalembert/_item_table.py": fill("item_table.py.j2", items=specs.items),
        "python/dalembert/_item_handles.pyi": fill("item_handles.pyi.j2", items=specs.items),
        "python/dalembert/_create_methods.pyi": fill(
            "create_methods.pyi.j2", functions=specs.create_functions, items=specs.items
        ),
        "python/dalembert/_snake_case.py": fill(
            "snake_case.py.j2", words=names.WORD.pattern, rule=inspect.getsource(names.snake_case)
        ),
        "python/dalembert/_create_table.py": fill("create_table.py.j2", functions=python.create_functions(specs.items)),
        "python/dalembert/_function_sizes.py": fill(
            "function_sizes.py.j2",
            functions=[(item, f) for item in specs.items for f in item.user_functions if python.has_arrays(f)],
        ),
        "python/dalembert/model.schema.json": fill("model_schema.json.j2", specs=specs),
        "python/dalembert/_planned_table.py": fill(
            "planned_table.py.j2",
            items=[item for item in specs.items if not item.ready],
            planned=specs.planned,
            left_out=specs.left_out,
        ),
    }


def _docs_files(specs: Specs) -> dict[str, str]:
    files = {"docs/enums.rst": fill("enums.rst.j2", enums=specs.enums)}
    folders: Mapping[str, list[Item]] = {folder: [i for i in specs.items if i.folder == folder] for folder in FOLDERS}
    files["docs/items/index.rst"] = fill("items_index.rst.j2", folders=folders)
    files["docs/planned.rst"] = fill("planned.rst.j2", folders=folders, planned=specs.planned, left_out=specs.left_out)
    for folder, items in folders.items():
        files[f"docs/items/{folder}/index.rst"] = fill("folder_index.rst.j2", folder=folder, items=items)
    for item in specs.items:
        files[f"docs/items/{item.stem}.rst"] = fill("item.rst.j2", item=item, items=specs.items)
    for each in specs.settings:
        parts = settings.structs(each)
        files[f"docs/{each.stem}.rst"] = fill("settings.rst.j2", settings=each, structs=parts)
    return files
