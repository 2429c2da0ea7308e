"""How notebooks show a system: how many items of each kind there are, and of which types."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from io import BytesIO
from typing import Any

_LARGE = 2000  # items, of which a picture takes longer than a table
_KINDS = ("node", "object", "marker", "load", "sensor")


def _repr_html_(mbs: Any) -> str:
    """Return a table of the items: a row per kind and type with their number and names."""
    items = mbs.GetDictionary()
    return _page(mbs, items, _picture(mbs, items))


def _ipython_display_(mbs: Any) -> None:
    """Show the live view and the table of the items; NotImplementedError where there are no widgets."""
    from importlib import import_module

    from dalembert._pictures.showing import show_widget

    show_widget(mbs.GetSystemContainer())
    shown = import_module("IPython.display")
    shown.display(shown.HTML(_page(mbs, mbs.GetDictionary(), "")))


def _page(mbs: Any, items: dict[str, Any], picture: str) -> str:
    from html import escape

    rows = []
    for kind in _KINDS:
        entries = items[f"{kind}List"]
        for name, count in Counter(entry[f"{kind}Type"] for entry in entries).items():
            names = [entry["name"] for entry in entries if entry[f"{kind}Type"] == name]
            rows.append((kind, name, str(count), _shortened(names)))
    title = escape(repr(mbs).strip("<>"))
    return f"<div><p>{title}</p>{picture}{_table(('kind', 'type', 'number', 'names'), rows)}</div>"


def _picture(mbs: Any, items: dict[str, Any]) -> str:
    """Return a small picture of the system; nothing for large systems, or if it cannot be drawn."""
    number = sum(len(items[f"{kind}List"]) for kind in _KINDS)
    if not 0 < number <= _LARGE:
        return ""
    from base64 import b64encode

    file = BytesIO()
    try:
        mbs.Draw(windowSize=[480, 320]).save(file, "png")
    except Exception:  # a table is better than an error, which Draw() reports
        return ""
    return f'<img alt="the system" src="data:image/png;base64,{b64encode(file.getvalue()).decode()}" />'


def _shortened(names: list[str], most: int = 4) -> str:
    """The first names, and three dots for the others."""
    return ", ".join(names[:most]) + (", ..." if len(names) > most else "")


def _table(head: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> str:
    from html import escape

    def line(cells: tuple[str, ...], tag: str) -> str:
        return "<tr>" + "".join(f"<{tag}>{escape(cell)}</{tag}>" for cell in cells) + "</tr>"

    body = "".join(line(row, "td") for row in rows)
    return f"<table><thead>{line(head, 'th')}</thead><tbody>{body}</tbody></table>" if rows else ""
