"""Items by their names, where it is open which kind of item is meant."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from dalembert import _core

_COUNTS = {kind: f"NumberOf{kind}s" for kind in ("Object", "Marker", "Node", "Load", "Sensor")}


def names_of(mbs: Any, kinds: Iterable[str]) -> list[str]:
    """Return the names of all items of these kinds."""
    return [
        getattr(mbs, f"Get{kind}Parameter")(number, "name")
        for kind in kinds
        for number in range(getattr(mbs.systemData, _COUNTS[kind])())
    ]


def index_of(mbs: Any, kind: str, item: Any, where: str) -> Any:
    """Return the index of an item of a kind, such as 'Marker', given by its index, number or name."""
    if isinstance(item, str):
        return find_item(mbs, item, (kind,), where)
    try:
        getattr(mbs, f"Get{kind}Parameter")(item, "name")  # raises an error if there is no such item
    except (IndexError, TypeError, ValueError) as error:
        told = str(error).removeprefix(f"mbs.Get{kind}Parameter(...): ")
        raise type(error)(f"{where}: {told}") from None
    return getattr(_core, f"{kind}Index")(int(item))


def find_item(mbs: Any, name: str, kinds: Iterable[str], where: str) -> Any:
    """Return the index of the only item with this name; ValueError, which begins with `where`, otherwise."""
    kinds = tuple(kinds)
    found = [getattr(mbs, f"Get{kind}Number")(name) for kind in kinds]
    found = [index for index in found if int(index) >= 0]
    if len(found) == 1:
        return found[0]
    noun = " or ".join(kind.lower() for kind in kinds)
    if found:
        several = " and ".join(f"{index.GetTypeString().removesuffix('Index').lower()} {index}" for index in found)
        raise ValueError(f"{where}: received '{name}', the name of {several}. Pass the index of the one you mean.")
    import difflib

    near = difflib.get_close_matches(name, names_of(mbs, kinds), 1)
    advice = f"Did you mean '{near[0]}'?" if near else "Names are given by name='...' when an item is added."
    raise ValueError(f"{where}: received '{name}', but no {noun} of the system has this name. {advice}")
