"""How notebooks show a system: how many items of each kind there are, and of which types."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from html import escape
from typing import Any

_KINDS = ("node", "object", "marker", "load", "sensor")


def _repr_html_(mbs: Any) -> str:
    """Return a table of the items: a row per kind and type with their number and names."""
    items = mbs.GetDictionary()
    rows = []
    for kind in _KINDS:
        entries = items[f"{kind}List"]
        for name, count in Counter(entry[f"{kind}Type"] for entry in entries).items():
            names = [entry["name"] for entry in entries if entry[f"{kind}Type"] == name]
            rows.append((kind, name, str(count), _shortened(names)))
    title = escape(repr(mbs).strip("<>"))
    return f"<div><p>{title}</p>{_table(('kind', 'type', 'number', 'names'), rows)}</div>"


def _shortened(names: list[str], most: int = 4) -> str:
    """The first names, and three dots for the others."""
    return ", ".join(names[:most]) + (", ..." if len(names) > most else "")


def _table(head: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> str:
    def line(cells: tuple[str, ...], tag: str) -> str:
        return "<tr>" + "".join(f"<{tag}>{escape(cell)}</{tag}>" for cell in cells) + "</tr>"

    body = "".join(line(row, "td") for row in rows)
    return f"<table><thead>{line(head, 'th')}</thead><tbody>{body}</tbody></table>" if rows else ""
