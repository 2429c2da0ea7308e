"""Python: annotations, defaults and docstrings of the stubs."""

from __future__ import annotations

from typing import Any

from codegen.model import Argument, Item, Parameter


def python_type(row: Parameter) -> str:
    return row.type.python


def python_default(row: Parameter) -> str:
    """The default as a user would write it; '...' for objects that have no short spelling."""
    type_, default = row.type, row.default
    if type_.index:
        count = len(default) if default is not None else row.size or (type_.shape[0] or 0 if type_.shape else 0)
        return repr([-1] * count) if type_.shape else "-1"
    if type_.storage in ("output_variable", "enumeration"):
        return f"{type_.name}.{default}"
    if type_.function or type_.python.endswith("Literal[0]"):
        return "0"
    if default is None:
        return "..." if not type_.shape else "[]"
    return repr(_python_value(default))


def _python_value(value: Any) -> Any:
    return -1 if value == "invalid" else value


def is_dotted_default(row: Parameter) -> bool:
    return python_default(row) == "..."


def shape_text(shape: tuple[int | None, ...]) -> str:
    """`3`, `3 x 3`, `n x 3`; '' for a scalar."""
    letters = iter("nmk")
    return " x ".join(str(length) if length is not None else next(letters) for length in shape)


def row_note(row: Parameter | Argument) -> str:
    """` [3; m]`: size and unit for a docstring."""
    facts = [fact for fact in (shape_text(row.shape), row.unit) if fact]
    return f" [{'; '.join(facts)}]" if facts else ""


def doc_text(text: str) -> str:
    """Text for a docstring: one line, no backslash escapes, no closing quotes."""
    return " ".join(text.split()).replace("\\", "\\\\").replace('"""', "'''")


def aliases(item: Item) -> list[tuple[str, str]]:
    """Short names, and short names of the visualization class, with the classes that they stand for."""
    pairs = [(short, item.name) for short in item.short_names if short != item.name]
    return pairs + [(f"V{short}", f"V{target}") for short, target in pairs]


def arguments_of(item: Item) -> list[Parameter]:
    """Rows that are arguments of the constructor."""
    return [row for row in item.parameters if not row.internal]
