"""XML files with the line numbers of their elements, for error texts."""

from __future__ import annotations

import difflib
from collections.abc import Collection, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import NoReturn
from xml.parsers import expat

import numpy as np

from dalembert._checks import FloatArray


@dataclass
class Element:
    """An element with its attributes and children, and where it begins.

    model is the number of the attached model of an MJCF file that it belongs to; 0 for the file itself.
    """

    tag: str
    attributes: dict[str, str]
    file: str
    line: int
    children: list[Element] = field(default_factory=list)
    model: int = 0

    def fail(self, problem: str) -> NoReturn:
        """Raise the ValueError that names file, line and element."""
        raise ValueError(f"{self.file}, line {self.line}: <{self.tag}>: {problem}")

    def every(self, tag: str) -> Iterator[Element]:
        """Give the children of a kind."""
        return (child for child in self.children if child.tag == tag)

    def only(self, tag: str) -> Element | None:
        """Return the child of a kind, or None; there must not be two."""
        found = list(self.every(tag))
        if len(found) > 1:
            found[1].fail(f"there is one in line {found[0].line} already; expected one only")
        return found[0] if found else None

    def needed(self, tag: str) -> Element:
        """Return the child of a kind, which there must be."""
        found = self.only(tag)
        return found if found is not None else self.fail(f"expected an element <{tag}> in it")

    def refuse_misspelt(self, attributes: str, children: str = "") -> None:
        """Raise an error for attributes and children with a name similar to a known one; other unknown names are
        ignored."""
        self._refuse_nearly("attribute", self.attributes, attributes.split())
        for child in self.children if children else ():
            child._refuse_nearly("element", [child.tag], children.split())

    def _refuse_nearly(self, what: str, given: Collection[str], known: list[str]) -> None:
        for name in given:
            near = [] if name in known else difflib.get_close_matches(name, known, 1, 0.7)
            if near and near[0] not in given:  # otherwise it is a name of another program
                self.fail(f"there is no {what} '{name}'; did you mean '{near[0]}'?")

    def text(self, name: str, default: str | None = None) -> str:
        """Return an attribute; it must be there unless there is a default."""
        value = self.attributes.get(name, default)
        return value if value is not None else self.fail(f"expected the attribute '{name}'")

    def numbers(self, name: str, size: int | tuple[int, int], default: str | None = None) -> FloatArray:
        """Return an attribute of `size` finite numbers, or of a number of them between two."""
        text = self.text(name, default)
        least, most = size if isinstance(size, tuple) else (size, size)
        try:
            values = np.array([float(word) for word in text.split()])
        except ValueError:
            values = np.array([np.nan])
        if not (least <= len(values) <= most and np.isfinite(values).all()):
            count = f"{least}" if least == most else f"{least} to {most}"
            self.fail(f"{name}: expected {count} finite number{'s' * (most > 1)}, received '{text}'")
        return values

    def number(self, name: str, default: str | None = None) -> float:
        """Return an attribute that is a number."""
        return float(self.numbers(name, 1, default)[0])

    def amount(self, name: str, default: str | None = None) -> float:
        """Return an attribute that is a number and not negative."""
        value = self.number(name, default)
        return value if value >= 0 else self.fail(f"{name}: expected a number that is not negative, received {value:g}")


def read(fileName: str | Path, text: str | None = None) -> Element:
    """Return the root of an XML file, or of a text; invalid XML raises a ValueError with the line."""
    file = str(fileName)
    parser = expat.ParserCreate()
    root = Element("", {}, file, 0)
    path = [root]

    def start(tag: str, attributes: dict[str, str]) -> None:
        element = Element(tag, attributes, file, parser.CurrentLineNumber)
        path[-1].children.append(element)
        path.append(element)

    parser.StartElementHandler = start
    parser.EndElementHandler = lambda tag: path.pop()
    try:
        parser.Parse(Path(fileName).read_bytes() if text is None else text, True)
    except expat.ExpatError as error:
        raise ValueError(f"{file}, line {error.lineno}: no XML: {expat.ErrorString(error.code)}") from None
    return root.children[0]
