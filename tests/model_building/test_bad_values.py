"""Every parameter of every ready item refuses every kind of bad value, on every way to it, and leaves all as it was."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from sample_values import CLASSES, ITEMS, bad_values, parameters

import dalembert as exu
from codegen.model import Item, Parameter

READY = [item for item in ITEMS if item.ready]
Route = Callable[[Any], Any]


def routes(mbs: exu.MainSystem, item: Item, name: str) -> Iterator[tuple[str, Route]]:
    """Ways to a parameter: names of the item, and of a system in which it has the number 0."""
    title, made = item.kind.title(), CLASSES[item.name]()
    add, put, modify = (getattr(mbs, method) for method in (f"Add{title}", f"Set{title}Parameter", f"Modify{title}"))
    if not name.startswith("V") or name in {row.name for row in item.parameters}:
        yield "construction", lambda value: CLASSES[item.name](**{name: value})
        yield "attribute", lambda value: setattr(made, name, value)
    yield "dictionary", lambda value: add({f"{item.kind}Type": item.type_name, name: value})
    yield "Set", lambda value: put(0, name, value)
    yield "Modify", lambda value: modify(0, {name: value})


def rows(item: Item) -> Iterator[tuple[str, Parameter]]:
    yield from ((row.name, row) for row in parameters(item))
    yield from (("V" + row.name, row) for row in item.visualization)


@pytest.mark.parametrize("item", READY, ids=[item.name for item in READY])
def test_bad_values(mbs: exu.MainSystem, item: Item) -> None:
    getattr(mbs, f"Add{item.kind.title()}")(CLASSES[item.name]())
    before = repr(mbs.GetDictionary())
    accepted, unnamed = [], []
    for name, row in rows(item):
        for kind, value in bad_values(row).items():
            for route, bring in routes(mbs, item, name):
                try:
                    bring(value)
                except (TypeError, ValueError) as error:
                    text = str(error)
                    if item.name not in text or f"parameter '{name}'" not in text or "received " not in text:
                        unnamed.append((name, kind, route, text))
                else:
                    accepted.append((name, kind, route, value))
    assert accepted == []
    assert unnamed == []
    assert repr(mbs.GetDictionary()) == before


INDICES = [(item, row) for item in READY for row in parameters(item) if row.type.index]


@pytest.mark.parametrize(("item", "row"), INDICES, ids=[f"{item.name}.{row.name}" for item, row in INDICES])
def test_numbers_of_items_that_never_come_are_refused_at_assemble(
    mbs: exu.MainSystem, item: Item, row: Parameter
) -> None:
    """An item may be added before the one that it names: whether that exists is asked when the system is assembled."""
    several = row.type.storage.endswith("s")
    beyond = 1_000_000
    made = CLASSES[item.name](**{row.name: [beyond] * (row.shape[0] or 2) if several else beyond})
    for other in parameters(item):  # that are asked for first
        if other.type.index and other is not row:
            return
    getattr(mbs, f"Add{item.kind.title()}")(made)
    noun = row.type.storage.removesuffix("s")
    expected = "a number from 0 to 0" if noun == item.kind else f"an existing {noun}, and there is none"
    where = f"{item.kind} 0 '{item.kind}0' ({item.name}), parameter '{row.name}': "
    with pytest.raises(ValueError, match=re.escape(f"{where}received 1000000, but expected {expected}")):
        mbs.Assemble()
