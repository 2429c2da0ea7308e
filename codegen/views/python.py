"""Python: annotations, defaults and docstrings of the stubs."""

from __future__ import annotations

from collections.abc import Iterable
from textwrap import indent
from typing import Any

from codegen.model import BODY_FOLDERS, Argument, Item, Parameter, Transformation, UserFunction
from codegen.model_settings import Enum, LeftOut, Planned
from codegen.views.cpp import one_line

# Types of attributes, by storage, if narrower than those of assignments.
_VALUES = {
    **{f"vector{n}": "Array" for n in ("", 2, 3, 4, 6, 7, 9)},
    "matrix": "Array",
    "matrix3": "Array",
    "matrix6": "Array",
    "integer_matrix": "NDArray[np.int32]",
    "matrix_container": "MatrixContainer",
    "vector3s": "Vector3DList",
    "vector6s": "Vector6DList",
    "matrix3s": "Matrix3DList",
    "integers": "list[int]",
    "joint_types": "list[JointType]",
    **{kind: f"{kind.capitalize()}Index" for kind in ("node", "object", "marker", "load", "sensor")},
    **{f"{kind}s": f"list[{kind.capitalize()}Index]" for kind in ("node", "object", "marker", "load", "sensor")},
}


def python_type(row: Parameter) -> str:
    return row.type.python


def argument_type(row: Parameter, item: Item) -> str:
    """Return the type of assignments to a parameter of an item."""
    function = next((f for f in item.user_functions if f.name == row.name), None)
    if function:
        return f"{_callable(function)} | Literal[0]"
    return row.type.python if row.named == "no" else f"{row.type.python} | str"


def value_type(row: Parameter, item: Item) -> str:
    """Return the type of a parameter of an item."""
    return _VALUES.get(row.type.storage) or argument_type(row, item).replace("Sequence[", "list[")


def setting_type(row: Parameter) -> str:
    """Return the type of a setting: lists instead of arrays."""
    if row.type.real and row.type.shape:
        return "list[float]" if len(row.type.shape) == 1 else "list[list[float]]"
    return _VALUES.get(row.type.storage, row.type.python)


def _callable(function: UserFunction) -> str:
    standard = {"mbs": "MainSystem", "t": "float", "itemNumber": "int"}
    arguments = [standard[name] for name in function.standard] + [a.type.python for a in function.arguments]
    return f"Callable[[{', '.join(arguments)}], {_accepted(function.returns)}]"


def has_arrays(function: UserFunction) -> bool:
    return any(argument.shape and argument.type.real for argument in function.arguments)


NODES, ASSEMBLE = -1, -2  # as in function_sizes.py.j2


def array_sizes(function: UserFunction, item: Item) -> list[int]:
    """The length of each array that the function receives."""
    open_size = NODES if item.folder in BODY_FOLDERS else ASSEMBLE
    return [a.shape[0] or open_size for a in function.arguments if a.shape and a.type.real]


def argument_sizes(function: UserFunction, item: Item) -> str:
    """`(3, 6, NODES)`: the same as text."""
    names = {NODES: "NODES", ASSEMBLE: "ASSEMBLE"}
    sizes = [names.get(size, str(size)) for size in array_sizes(function, item)]
    return f"({', '.join(sizes)}{',' * (len(sizes) == 1)})"


def _accepted(result: Argument) -> str:
    """Return the types of results of a user function."""
    if result.type.name == "MatrixContainer":
        return "MatrixLike"
    return "ArrayLike" if result.type.python == "Array" else result.type.python


def is_flag(enum: Enum) -> bool:
    """Whether values may be joined by `|`: more than two single bits and nothing else, except for zero."""
    bits = [value for value in enum.values if value.value.bit_count() == 1]
    return len(bits) > 2 and all(value.value.bit_count() <= 1 for value in enum.values)


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


def stub_default(row: Parameter) -> str:
    """Return the default of the run-time signature: None means an empty matrix."""
    return "None" if row.type.storage == "matrix_container" else python_default(row)


def _python_value(value: Any) -> Any:
    return -1 if value == "invalid" else value


def is_dotted_default(row: Parameter) -> bool:
    return python_default(row) == "..."


def shape_text(shape: tuple[int | None, ...]) -> str:
    """`3`, `3 x 3`, `n x 3`; '' for a scalar."""
    letters = iter("nmk")
    return " x ".join(str(length) if length is not None else next(letters) for length in shape)


def row_note(row: Parameter | Argument, more: str = "") -> str:
    """Return ` [3; m]`: size, unit and further notes for a docstring."""
    facts = [fact for fact in (shape_text(row.shape), row.unit, more) if fact]
    return f" [{'; '.join(facts)}]" if facts else ""


def doc_text(text: str) -> str:
    """Text for a docstring: one line, no backslash escapes, no closing quotes."""
    return " ".join(text.split()).replace("\\", "\\\\").replace('"""', "'''")


def aliases(item: Item) -> list[tuple[str, str]]:
    """Short names, and short names of the visualization class, with the classes that they stand for."""
    pairs = [(short, item.name) for short in item.short_names if short != item.name]
    return pairs + [(f"V{short}", f"V{target}") for short, target in pairs]


def left_out_entry(name: str, row: LeftOut) -> str:
    return f"{name!r}: {row.instead!r}"


def planned_entry(planned: Planned) -> str:
    return f"Planned({planned.what!r}, {planned.instead!r}, {planned.members!r})"


def arguments_of(item: Item) -> list[Parameter]:
    """Rows that are arguments of the constructor."""
    return [row for row in item.parameters if not row.internal]


def other_names(item: Item) -> list[tuple[Parameter, str]]:
    """Return further names of arguments of the constructor, with their rows."""
    return [(row, alias) for row in arguments_of(item) for alias in row.aliases]


def transformation_type(transformation: Transformation) -> str:
    return "Sequence[HT]" if transformation.name.endswith("s") else "HT | ArrayLike"


def transformation_text(transformation: Transformation) -> str:
    """Return the description of a transformation."""
    parts = " and ".join(f"``{part}``" for part in (transformation.position, transformation.rotation) if part)
    return f"{parts} as ``exu.HT``, or as 4 x 4 matrix"


def create_functions(items: Iterable[Item]) -> dict[str, list[Item]]:
    """The items that each Create function mirrors: objects before their nodes, spatial ones before planar ones."""
    found: dict[str, list[Item]] = {}
    for item in sorted(items, key=lambda item: (item.kind != "object", item.stem.endswith("_2d"), item.name)):
        for function in item.create_functions:
            found.setdefault(function, []).append(item)
    return dict(sorted(found.items()))


def signature(function: UserFunction) -> str:
    return f"{function.name}({', '.join(function.argument_names)})"


def further_help(item: Item) -> str:
    """Return the part of an item's docstring below its parameters and outputs."""
    parts = []
    if item.user_functions:
        functions = (f"    {signature(f)}\n        {one_line(f.doc)}" for f in item.user_functions)
        parts.append("\n".join(("User functions:", *functions)))
    if item.create_functions:
        parts.append("Created by: " + ", ".join(f"mbs.{name}(...)" for name in item.create_functions))
    if item.example:
        parts.append("Example:\n" + indent(item.example.code, "    "))
    parts.append(f"Page: reference/items/{item.stem}.html")
    return "".join(f"\n{part}\n" for part in parts)
