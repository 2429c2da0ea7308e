"""Planned parts raise an error wherever they are used; and their list, made from the specs, agrees with the missing
parts."""

from __future__ import annotations

import ast
import importlib
import inspect
import json
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import pytest

import dalembert as exu
from dalembert import alias, cli, itemInterface
from dalembert._planned_table import FUNCTIONS, ITEMS, MODULES

ROOT = Path(__file__).parents[2]
API = json.loads((ROOT / "tests/data/reference/api.json").read_text())
CORE, METHODS = "(compiled core)", "MainSystem python methods"

# Names of the published list that are no attributes there either: signatures of functions for SetPreStepUserFunction
# etc.
SIGNATURES_OF_USER_FUNCTIONS = {
    f"MainSystem.{name}UserFunction"
    for name in ("PreStep", "PostStep", "PostNewton", "PreNewtonResidual", "SystemJacobian")
}
# Modules that the published list leaves out.
MODULES_BESIDE: set[str] = set()
# The same for classes, methods and functions.
CLASSES_BESIDE = {"SolverFileData", "SolverLocalData"}


def published() -> Iterator[tuple[str, str]]:
    """Give all names of the published interface, module.function or Class.member, with their signatures."""
    for module, members in API.items():
        owner = {CORE: "", METHODS: "MainSystem."}.get(module, f"{module}.")
        for name, value in members.items():
            if not isinstance(value, dict):
                yield f"{owner}{name}", value
            elif name == "(module)":
                yield from value.items()
            else:
                yield f"{owner}{name}", ""
                yield from ((f"{owner}{name}.{member}", text) for member, text in value.items())


def find(name: str) -> Any:
    """Return the object of a published name; AttributeError or ImportError if there is nothing."""
    modules = sorted((m for m in API if name.startswith(f"{m}.")), key=len)
    thing: Any = importlib.import_module(f"dalembert.{modules[-1]}") if modules else exu
    for word in name.removeprefix(f"{modules[-1]}." if modules else "").split("."):
        thing = getattr(thing, word)
    return thing


def is_planned(name: str) -> bool:
    """Whether the list names it, its class or its module; a class with listed members has only these."""
    owner, _, member = name.rpartition(".")
    if owner in FUNCTIONS:
        return not FUNCTIONS[owner].members or member in FUNCTIONS[owner].members
    return name in FUNCTIONS or any(name.startswith(f"{module}.") for module in MODULES)


@cache
def missing() -> frozenset[str]:
    names = set()
    for name, _ in published():
        try:
            find(name)
        except (AttributeError, ImportError):
            names.add(name)
    return frozenset(names)


def test_missing_parts_are_planned() -> None:
    unknown = {name for name in missing() if not is_planned(name)}
    assert unknown == SIGNATURES_OF_USER_FUNCTIONS


def test_modules_that_are_missing_are_planned() -> None:
    modules = set(API) - {CORE, METHODS}
    absent = {name for name in modules if not (ROOT / f"python/dalembert/{name.replace('.', '/')}.py").exists()}
    present = {name for name in absent if (ROOT / f"python/dalembert/{name}/__init__.py").exists()}
    assert absent - present | MODULES_BESIDE == set(MODULES)


def test_planned_parts_are_published() -> None:
    names = {name for name, _ in published()} | CLASSES_BESIDE
    assert {name for name in FUNCTIONS if name not in names} == set()
    members = {f"{name}.{member}" for name, planned in FUNCTIONS.items() for member in planned.members}
    assert members - names == set()


def parameters(signature: str) -> list[str]:
    """Return the names of the parameters of a published signature, whose defaults may be no Python."""
    inside = signature.strip()[1 : signature.rindex(")")]
    while (shorter := re.sub(r"\([^()]*\)|\[[^\[\]]*\]|<[^<>]*>|'[^']*'", "", inside)) != inside:
        inside = shorter
    found = [re.match(r"\s*\*{0,2}(\w+)", part) for part in inside.split(",")]
    return [match[1] for match in found if match]


def test_signatures_are_those_that_are_published() -> None:
    """Arguments in their order; further ones may follow. Compiled functions have their stubs."""
    differing = {}
    for name, signature in published():
        if name in missing() or is_planned(name) or not inspect.isfunction(thing := find(name)):
            continue
        first = name.startswith("MainSystem.")  # is called self or mbs
        wanted, ours = parameters(signature)[first:], list(inspect.signature(thing).parameters)[first:]
        if ours[: len(wanted)] != wanted:
            differing[name] = (wanted, ours)
    assert differing == {}


# ---- messages
# ----------------------------------------------------------------------------------------------------------


@pytest.fixture
def exudyn() -> Iterator[None]:
    alias.install("exudyn")
    yield
    alias.uninstall("exudyn")


@pytest.mark.parametrize("package", ["dalembert", "exudyn"])
@pytest.mark.parametrize("name", MODULES)
def test_planned_modules_say_so(exudyn: None, package: str, name: str) -> None:
    shown = next(module for module in MODULES if name == module or name.startswith(f"{module}."))
    wanted = rf"dalembert\.{re.escape(shown)} is planned and not available yet: .+"
    if MODULES[shown].instead:
        wanted += f"; until then: {re.escape(MODULES[shown].instead)}"
    for code in (
        f"import {package}.{name}",
        f"from {package}.{name} import *",
        f"from {package}.{name} import anything",
    ):
        with pytest.raises(ModuleNotFoundError, match=wanted):
            exec(code, {})
    if name == shown:
        with pytest.raises(AttributeError, match=wanted):
            getattr(importlib.import_module(package), name)


def test_other_modules_are_not_found_as_usual() -> None:
    with pytest.raises(ModuleNotFoundError, match="No module named 'dalembert.robotic'"):
        importlib.import_module("dalembert.robotic")


@pytest.mark.parametrize("name", sorted(FUNCTIONS))
def test_planned_functions_say_so(name: str) -> None:
    planned = FUNCTIONS[name]
    if planned.members:
        instance = find(name)(None)
        calls = [lambda m=m: getattr(instance, m)() for m in planned.members]
    else:
        needed = [p for p in inspect.signature(find(name)).parameters.values() if p.default is p.empty]
        count = sum(p.kind is p.POSITIONAL_OR_KEYWORD for p in needed)
        calls = [lambda: find(name)(*[None] * count)]
    for call in calls:
        with pytest.raises(NotImplementedError, match=f"is planned and not available yet: {re.escape(planned.what)}"):
            call()


def test_the_readme_counts_as_the_specs_do() -> None:
    every = cli._item_names()
    total, run = sum(map(len, every.values())), sum(name not in ITEMS for names in every.values() for name in names)
    assert total - run == len(ITEMS)
    page = (ROOT / "generated/docs/planned.rst").read_text()
    assert f"{run} of {total} item types run." in page
    assert f"{run} of {total} item types run" in (ROOT / "README.md").read_text()
    assert f"{run} of {total} item types run" in (ROOT / "docs/index.rst").read_text()


# ---- hints ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ITEMS)
def test_hints_do_not_lead_to_planned_items(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    kind = next(kind for kind in ("Node", "Object", "Marker", "Load", "Sensor") if name.startswith(kind))
    type_name = dict(getattr(itemInterface, name)())[f"{kind.lower()}Type"]
    mbs = exu.SystemContainer().AddSystem()
    types = {
        item: dict(getattr(itemInterface, item)())[f"{kind.lower()}Type"] for item in ITEMS if item.startswith(kind)
    }
    with pytest.raises(ValueError, match="there is no") as caught:
        getattr(mbs, f"Add{kind}")({f"{kind.lower()}Type": type_name + "x", "name": ""})
    advice = str(caught.value).partition(f"'{type_name}x'")[2]
    assert not [planned for planned in types.values() if re.search(rf"\b{planned}\b", advice)]
    assert cli.main(["items", name + "x"]) == 2
    hints = capsys.readouterr().err.partition(f"'{name}x'")[2]
    assert not [planned for planned in ITEMS if re.search(rf"\b{planned}\b", hints)]


def texts() -> Iterator[tuple[str, str]]:
    """Return the signatures that the package publishes: strings of its Python and C++ sources, with the file."""
    for path in (ROOT / "python/dalembert").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                yield path.name, node.value
    for path in (ROOT / "core").rglob("*.[ch]pp"):
        for text in re.findall(r'"((?:[^"\\\n]|\\.)*)"', path.read_text()):
            yield path.name, text
    for name, planned in (MODULES | FUNCTIONS).items():
        yield f"specs/interface/planned.toml, {name}", planned.instead


def test_no_text_leads_to_planned_items_or_modules() -> None:
    """A single word is a name in a table, not advice; a text that says of it that it is planned is none either."""
    names = [*ITEMS, *(rf"(?:dalembert|exudyn|exu)\.{module}" for module in MODULES)]
    pattern = re.compile(rf"\b(?:{'|'.join(names) or '(?!)'})\b")
    found = [(file, text) for file, text in texts() if " " in text.strip() and pattern.search(text)]
    assert [(file, text) for file, text in found if not re.search("planned|NotImplementedError", text)] == []
