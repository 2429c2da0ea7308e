"""Variables of a model that hold items, and codes of lines for plots."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from dalembert._calls import checked


@checked
def PlotLineCode(index: int) -> str:
    """Return a matplotlib colour and line code, e.g. 'r-'; 28 different ones, then 'k:' for larger indices."""
    colors, lines = "rgbkcmy", ("-", ":", "--", "-.")
    if index >= len(colors) * len(lines):
        return "k:"
    line, color = divmod(int(index) % (len(colors) * len(lines)), len(colors))
    return colors[color] + lines[line]


def _find_index(kind: str, i: Any, variables: Mapping[str, Any]) -> None:
    """Print the variables that hold item i; item index types are recognized by their name."""
    found = [
        name for name, value in variables.items() if type(value).__name__ == kind + "Index" and int(value) == int(i)
    ]
    for name in found:
        print(f"variable '{name}' links to {kind.lower()} {i}")
    if not found:
        print(f"no variable links to {kind.lower()} {i}")


def FindObjectIndex(i: Any, globalVariables: Mapping[str, Any]) -> None:
    """Print the names of the variables (e.g. of globals()) that hold the ObjectIndex i."""
    _find_index("Object", i, globalVariables)


def FindNodeIndex(i: Any, globalVariables: Mapping[str, Any]) -> None:
    """Print the names of the variables (e.g. of globals()) that hold the NodeIndex i."""
    _find_index("Node", i, globalVariables)
