"""Generated files for readers and editors: formulas in plain LaTeX, links to examples, stubs that parse."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

from codegen.model_settings import Specs

# Macros of the reference documentation, which no math renderer knows.
FOREIGN = re.compile(
    r"\\(LUR?|cConfig|cRef|cIni|cCur|cSOS|tp|Rot|Rcal|Ncal|pLocB|pRefG?|mr|vr|vp|mp|vrRow|Null|ind[a-z]+|t(omega|alpha|psi|nu|theta))\b"
)


def formulas(specs: Specs) -> Iterator[tuple[str, str]]:
    for item in specs.items:
        yield from ((f"{item.path}: {row.name}", row.symbol) for row in (*item.rows, *item.outputs, *item.quantities))
        yield f"{item.path}: equations", item.equations


def test_formulas_are_plain_latex_with_balanced_braces(specs: Specs) -> None:
    for place, text in formulas(specs):
        assert not FOREIGN.search(text), place
        depth = 0
        for brace in re.findall(r"(?<!\\)[{}]", text):
            depth += 1 if brace == "{" else -1
            assert depth >= 0, place
        assert depth == 0, place


def test_pages_link_to_users_of_an_item(root: Path, specs: Specs) -> None:
    """Each item has an example of its own; its Create functions are named, and their examples linked."""
    for item in specs.items:
        folder = "/".join(item.path.split("/")[-2:]).removesuffix(".toml")
        page = (root / "generated/docs/items" / f"{folder}.rst").read_text()
        assert ("\nMini example\n" in page) == (item.name != "NodeGenericAE"), item.name  # a planned item
        for name in item.create_functions:
            assert f":ref:`mbs.{name}(...) <create-{name}>`" in page, item.name
            assert f":ref:`mbs.{name}(...) <create-example-{name}>`" in page.split("\nSee also\n")[1], item.name


def test_stubs_are_valid_python(root: Path, specs: Specs) -> None:
    stubs = {path.stem: ast.parse(path.read_text()) for path in (root / "generated/python").rglob("*.pyi")}
    classes = {node.name for node in stubs["_core_items"].body if isinstance(node, ast.ClassDef)}
    names = {item.name for item in specs.items}
    bases = {"_Item", "_Visualization", *(f"_{item.kind.capitalize()}" for item in specs.items)}
    assert classes == names | {f"V{name}" for name in names} | bases
    shorts = {
        node.targets[0].id
        for node in stubs["_core_items"].body
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name)
    }
    wanted = {name for item in specs.items for name in item.short_names if name != item.name}
    assert shorts == wanted | {f"V{name}" for name in wanted}
