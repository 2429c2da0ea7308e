"""Docstrings of the package are plain text, not RST: lines `name: what it is` are a list.

autodoc hands each docstring to `as_rst`, which marks up these lists and escapes what RST would read as markup.
"""

from __future__ import annotations

import re
from typing import Any

from sphinx.application import Sphinx

ENTRY = re.compile(r"(?P<names>[*\w.]+(?:, [*\w.]+)*): (?P<text>\S.*)")
LITERAL = re.compile(r"(``.+?``)")
MARKUP = re.compile(r"[\\*`|]|_(?=\W|$)")


def escaped(text: str) -> str:
    parts = LITERAL.split(text)
    return "".join(part if i % 2 else MARKUP.sub(r"\\\g<0>", part) for i, part in enumerate(parts))


def as_rst(lines: list[str]) -> list[str]:
    """Paragraphs stay; an entry becomes an item of a list, with the lines that are indented below it."""
    result: list[str] = []
    entry_indent = -1  # of the entry that the next lines may belong to
    previous_indent = 0
    for line in lines:
        text = line.strip()
        indent = len(line) - len(line.lstrip())
        if not text:
            entry_indent = -1
            result.append("")
        elif match := ENTRY.fullmatch(text):
            if entry_indent < 0:
                result.append("")
            names = ", ".join(f"``{name}``" for name in match["names"].split(", "))
            result.append(f"* {names}: {escaped(match['text'])}")
            entry_indent = indent
        elif 0 <= entry_indent < indent:
            result.append("  " + escaped(text))
        else:
            if entry_indent >= 0 or indent != previous_indent:
                result.append("")
            entry_indent = -1
            result.append(escaped(text))
        previous_indent = indent
    return result


def process(app: Sphinx, what: str, name: str, obj: Any, options: Any, lines: list[str]) -> None:
    lines[:] = as_rst(lines)


def setup(app: Sphinx) -> dict[str, bool]:
    app.connect("autodoc-process-docstring", process)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
