"""Docstrings of the package are plain text, not RST: lines `name: description` are a list.

autodoc hands each docstring to `as_rst`, which marks up these lists and escapes accidental RST markup.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

from sphinx.application import Sphinx

ENTRY = re.compile(r"(?P<names>[*\w.]+(?:, [*\w.]+)*): (?P<text>\S.*)")
LITERAL = re.compile(r"(``.+?``|`[^`]+`)")
MARKUP = re.compile(r"[\\*`|]|_(?=\W|$)")
# Parts of pybind11 signatures without information for readers.
SIGNATURE_NOISE = re.compile(r"\bself: [\w.]+(, )?|\bdalembert\._core\.|\btyping\.|\bcollections\.abc\.")


def escaped(text: str) -> str:
    """Markup becomes text, except names in backticks."""
    parts = LITERAL.split(text)
    return "".join(f"``{part.strip('`')}``" if i % 2 else MARKUP.sub(r"\\\g<0>", part) for i, part in enumerate(parts))


def indent_of(line: str) -> int:
    return len(line) - len(line.lstrip())


def entries(lines: list[str]) -> list[str] | None:
    """Return the entries in the lines; None if they are not a list."""
    indent = indent_of(lines[0])
    result: list[str] = []
    for line in lines:
        match = ENTRY.fullmatch(line.strip()) if indent_of(line) == indent else None
        if match:
            names = ", ".join(f"``{name}``" for name in match["names"].split(", "))
            result.append(f"* {names}: {escaped(match['text'])}")
        elif indent_of(line) > indent and result:
            result.append("  " + escaped(line.strip()))
        else:
            return None
    return result


def paragraph(lines: list[str]) -> list[str]:
    """Entries as a list, perhaps below lines of text that end with a colon; other lines as text."""
    for start in range(len(lines)):
        titled = start == 0 or lines[start - 1].endswith(":")
        if titled and (found := entries(lines[start:])):
            title = paragraph(lines[:start]) if start else []
            return [*title, *found, ""]
    return [*(escaped(line.strip()) for line in lines), ""]


def sections(lines: list[str]) -> Iterator[list[str]]:
    """Stretches between blank lines, and parted where the indentation falls back after a list with a title."""
    stretch: list[str] = []
    for line in [*lines, ""]:
        falls_back = len(stretch) > 1 and line.endswith(":") and indent_of(line) == indent_of(stretch[0])
        if stretch and (not line.strip() or falls_back):
            yield stretch
            stretch = []
        if line.strip():
            stretch.append(line)


def as_rst(lines: list[str]) -> list[str]:
    return [line for stretch in sections(lines) for line in paragraph(stretch)]


def process(app: Sphinx, what: str, name: str, obj: Any, options: Any, lines: list[str]) -> None:
    lines[:] = as_rst(lines)


def shorten(app: Sphinx, what: str, name: str, obj: Any, options: Any, signature: str, result: str) -> Any:
    return tuple(SIGNATURE_NOISE.sub("", text) if text else text for text in (signature, result))


def setup(app: Sphinx) -> dict[str, bool]:
    app.connect("autodoc-process-docstring", process)
    app.connect("autodoc-process-signature", shorten)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
