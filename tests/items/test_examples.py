"""The mini example of every ready item gives the value that its spec states; each item has its page and its stub."""

from __future__ import annotations

import ast
from functools import cache
from pathlib import Path

from codegen.model import Item
from dalembert.testing.examples import each_item, test_mini_example  # noqa: F401

GENERATED = Path(__file__).parents[2] / "generated"


@each_item
def test_page(item: Item) -> None:
    text = (GENERATED / "docs" / "items" / f"{item.stem}.rst").read_text(encoding="utf-8")
    assert item.name in text
    for row in (*item.parameters, *item.visualization, *item.outputs):
        if not getattr(row, "internal", False):
            assert row.name in text, row.name


@cache
def stubs() -> dict[str, ast.ClassDef]:
    return {
        node.name: node
        for path in (GENERATED / "python" / "dalembert").glob("_core_items*.pyi")
        for node in ast.parse(path.read_text(encoding="utf-8")).body
        if isinstance(node, ast.ClassDef)
    }


@each_item
def test_stub(item: Item) -> None:
    """A class with the arguments of the spec, in the stubs."""
    init = next(n for n in stubs()[item.name].body if isinstance(n, ast.FunctionDef) and n.name == "__init__")
    arguments = [a.arg for a in (*init.args.args, *init.args.kwonlyargs)][1:]
    rows = [row.name for row in item.parameters if not row.internal and row.name != "name"]
    others = [alias for row in item.parameters if not row.internal for alias in row.aliases]
    assert arguments == ["name", *rows, "visualization", *others, *(each.name for each in item.transformations)]
