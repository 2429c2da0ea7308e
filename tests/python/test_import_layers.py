"""Modules of the package import each other in one direction: no circles when they are loaded, and layers of private packages."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

ROOT = Path(__file__).parents[2] / "python"
# Private packages, the lowest first. A package imports lower ones, and public modules that do so.
LAYERS = (
    "_checks",
    "_calls",
    "_geometry",
    "_tools",
    "_io",
    "_fem",
    "_solving",
    "_plots",
    "_studies",
    "_pictures",
    "_live",
    "_model",
)


def modules() -> dict[str, Path]:
    paths = (ROOT / "dalembert").rglob("*.py")
    return {".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__"): path for path in paths}


def loaded_statements(node: ast.AST) -> Iterator[ast.stmt]:
    """Yield the imports that run when the module is loaded: not those of functions and of type checkers."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.If) and "TYPE_CHECKING" in ast.dump(child.test):
            for other in child.orelse:
                yield from loaded_statements(other)
        elif isinstance(child, (ast.Import, ast.ImportFrom)):
            yield child
        elif not isinstance(child, (ast.FunctionDef, ast.AsyncFunctionDef)):
            yield from loaded_statements(child)


def imports() -> dict[str, set[str]]:
    """Return the modules that each module imports, by their names; extension modules are left out."""
    known = modules()
    graph: dict[str, set[str]] = {name: set() for name in known}
    for name, path in known.items():
        for statement in loaded_statements(ast.parse(path.read_text())):
            if isinstance(statement, ast.Import):
                wanted = {alias.name for alias in statement.names}
            else:
                full = {alias: f"{statement.module}.{alias}" for alias in (each.name for each in statement.names)}
                wanted = {text if text in known else str(statement.module) for text in full.values()}
                wanted = {text for text in wanted if not set(full) & {"_core"} or text != "dalembert"}
            graph[name] |= (wanted & set(known)) - {name}
    return graph


def test_modules_load_without_circles() -> None:
    graph = imports()
    assert sum(map(len, graph.values())) > 500, "imports are not found"
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        raise AssertionError(" imports ".join(reversed(error.args[1]))) from None


def test_private_packages_import_lower_ones() -> None:
    wrong = []
    for name, wanted in imports().items():
        parts = name.split(".")
        if len(parts) < 2 or parts[1] not in LAYERS:
            continue
        for other in wanted:
            target = (other.split(".") + [""])[1]
            if target in LAYERS and LAYERS.index(target) > LAYERS.index(parts[1]):
                wrong.append(f"{name} imports {other}")
    assert not wrong, "\n".join(wrong)


def test_circles_are_seen() -> None:
    graph = imports()
    graph["dalembert._checks"].add("dalembert.FEM")
    try:
        TopologicalSorter(graph).prepare()
    except CycleError:
        return
    raise AssertionError("a circle was not found")
