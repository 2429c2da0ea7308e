"""The reference pages build without a warning, and their formulas use plain LaTeX only."""

from __future__ import annotations

import ast
import re
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest

from codegen.model_settings import Specs

# Macros of the reference documentation, which no math renderer knows.
FOREIGN = re.compile(
    r"\\(LUR?|cConfig|cRef|cIni|cCur|cSOS|tp|Rot|Rcal|Ncal|pLocB|pRefG?|mr|vr|vp|mp|vrRow|Null|ind[a-z]+|t(omega|alpha|psi|nu|theta))\b"
)

CONF = """
project = "dalembert"
extensions = ["sphinx.ext.mathjax"]
html_theme = "basic"
"""
INDEX = """
Reference
=========

.. toctree::

   items/index
   planned
   enums
   simulation_settings
   visualization_settings
"""


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


def test_pages_build_without_warnings(root: Path, tmp_path: Path, specs: Specs) -> None:
    pytest.importorskip("sphinx")
    from sphinx.cmd.build import main

    shutil.copytree(root / "generated/docs", tmp_path / "src")
    (tmp_path / "src/conf.py").write_text(CONF)
    elsewhere = ["compiled-functions", *(f"example-{path.stem}" for path in root.glob("examples/*.py"))]
    made = {name for item in specs.items for name in item.create_functions}
    elsewhere += [f"create-{what}{name}" for name in made for what in ("", "example-")]
    titles = (f"\n.. _{label}:\n\n{label}\n{'-' * len(label)}\n" for label in elsewhere)
    (tmp_path / "src/index.rst").write_text(INDEX + "".join(titles))
    warnings = tmp_path / "warnings.txt"
    arguments = ["-q", "-b", "dummy", "-w", str(warnings), str(tmp_path / "src"), str(tmp_path / "out")]
    assert main(arguments) == 0
    assert not warnings.exists() or warnings.read_text() == ""


def test_pages_lead_to_what_uses_an_item(root: Path, specs: Specs) -> None:
    """Each item has an example of its own; its Create functions are named, and their examples linked."""
    for item in specs.items:
        folder = "/".join(item.path.split("/")[-2:]).removesuffix(".toml")
        page = (root / "generated/docs/items" / f"{folder}.rst").read_text()
        assert ("\nMini example\n" in page) == (item.name != "NodeGenericAE"), item.name  # which is planned
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
