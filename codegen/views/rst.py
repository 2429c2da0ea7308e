"""RST: types, sizes, refusals and links of the reference pages."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from codegen.model import Argument, Item, Output, Parameter, UserFunction
from codegen.model_settings import Enum
from codegen.views.python import python_default, shape_text

FOLDER_TITLES = {
    "nodes": "Nodes",
    "bodies": "Objects: bodies",
    "super_elements": "Objects: super elements",
    "finite_elements": "Objects: finite elements",
    "connectors": "Objects: connectors",
    "contacts": "Objects: contacts",
    "constraints": "Objects: constraints",
    "joints": "Objects: joints",
    "markers": "Markers",
    "loads": "Loads",
    "sensors": "Sensors",
}


def underline(title: str, mark: str) -> str:
    return mark * len(title)


def rst_math(symbol: str) -> str:
    return f":math:`{symbol.strip()}`" if symbol.strip() else ""


def rst_indent(text: str, width: int) -> str:
    """Indent all lines but the first, so that a text stays in its table cell."""
    return text.strip().replace("\n", "\n" + " " * width)


def rst_type(row: Parameter) -> str:
    if row.type.storage in ("output_variable", "enumeration"):
        return f":ref:`{row.type.name} <enum-{row.type.name}>`"
    if row.type.function or row.type.name == "PyFunctionGraphicsData":
        return "user function"
    return row.type.name


def rst_size(row: Parameter | Argument) -> str:
    return shape_text(row.shape).replace(" x ", " × ")


def output_size(output: Output) -> str:
    return str(output.size)


def rst_default(row: Parameter) -> str:
    """The default; nothing is said of objects that are empty until given."""
    if row.type.index and not row.type.shape:
        return "not set"
    if row.type.function or row.type.name == "PyFunctionGraphicsData":
        return "none"
    if row.type.storage == "matrix6" and not any(map(any, row.default)):
        return "``numpy.zeros((6, 6))``"
    text = python_default(row)
    return f"``{text}``" if text != "..." else "default object"


_REFUSED_BY_CHECK = {
    "none": [],
    "non_negative": ["negative"],
    "positive": ["zero or negative"],
    "rotation": ["not orthogonal to 1e-8", "a reflection"],
    "orthogonal": ["not orthogonal to 1e-8"],
    "color": ["a component that is not from 0 to 1, unless red is negative"],
    "unit_vector": ["a length that differs from 1 by more than 1e-8"],
}


def refused(row: Parameter) -> str:
    """Return a description of rejected values."""
    reasons = _REFUSED_BY_CHECK[row.effective_check]
    if row.type.index:
        reasons = ["an index of another kind or out of range"]
    if row.type.real:
        reasons = [*reasons, "not finite"]
    if row.shape and row.shape != (None,) and row.shape != (None, None):
        reasons = [*reasons, "other sizes"]
    return ", ".join(reasons)


def remarks(row: Parameter) -> str:
    """Return remarks after the description: other accepted values, rejected values, and when a change takes effect."""
    facts = []
    if row.type.takes_number and not row.internal:
        facts.append("A number is taken as its one entry.")
    if words := refused(row):
        facts.append(f"Refused: {words}.")
    if row.needs_assemble:
        facts.append("A change takes effect at the next ``Assemble()``.")
    if row.internal:
        facts.append("Computed, read only.")
    if row.aliases:
        facts.append("Also accepted as " + ", ".join(f"``{alias}``" for alias in row.aliases) + ".")
    return " ".join(facts)


def described(row: Parameter) -> str:
    """Description and remarks as sentences."""
    doc = sentence(row.doc)
    return " ".join(part for part in (doc, remarks(row)) if part)


def sentence(text: str) -> str:
    """The phrase of a spec as a sentence; a name or a symbol at its start is left as it is."""
    text = text.strip()
    if re.match(r"[a-z]{2,}[ ,;:-]|[a-z]{3,}$|a ", text):
        text = text[0].upper() + text[1:]
    return text if not text or text.endswith((".", "!", "?", ":")) else text + "."


_C_TYPES = {"scalar": "double", "integer": "int64_t", "boolean": "int64_t"}


def c_declaration(function: UserFunction) -> str:
    """How a compiled function is declared in C; see core/include/dalembert/reflection/compiled_call.hpp."""
    standard = {"t": "double t", "itemNumber": "int64_t itemNumber"}
    parameters = [text for name, text in standard.items() if name in function.standard]
    for argument in function.arguments:
        parameters += _c_parameters(argument.type.kind, "const double*", argument.name)
    if function.returns.type.kind == "scalar":
        return f"double {function.name}({', '.join(parameters)})"
    parameters += _c_parameters(function.returns.type.kind, "double*", "result")
    return f"void {function.name}({', '.join(parameters)})"


def _c_parameters(kind: str, pointer: str, name: str) -> list[str]:
    size = [f"int64_t {name}_size"] if kind.startswith("open_") else []
    return [f"{_C_TYPES.get(kind, pointer)} {name}", *size]


def item_link(name: str) -> str:
    return f":ref:`{name} <item-{name}>`"


def items_that_run(folders: Mapping[str, list[Item]]) -> str:
    """`70 of 97`."""
    items = [item for group in folders.values() for item in group]
    return f"{sum(item.ready for item in items)} of {len(items)}"


def partners(item: Item, items: tuple[Item, ...], kind: str) -> list[Item]:
    """Return possible nodes or markers of the item: those of its kernel, or those with the requested capabilities.

    Ground nodes have no coordinates: a body can use one only if its kernel allows it.
    """
    if kind == "node" and item.nodes:
        return [other for other in items if other.name in item.nodes]
    wanted = set(item.requested_nodes if kind == "node" else item.requested_markers)
    found = [other for other in items if wanted and other.kind == kind and wanted <= set(other.provisions)]
    return [other for other in found if "Ground" not in other.provides] if kind == "node" else found


def item_facts(item: Item, items: tuple[Item, ...]) -> str:
    """Return the entry of an item in the table of dalembert.types, as a literal."""

    def facts_of(row: Parameter) -> dict[str, Any]:
        ranges = {"positive": "> 0", "non_negative": ">= 0"}
        return {
            "type": row.type.name,
            "size": shape_text(row.shape),
            "range": ranges.get(row.effective_check, ""),
            "default": python_default(row),
            "unit": row.unit,
            "description": " ".join(row.doc.split()),
        }

    facts: dict[str, Any] = {
        "kind": item.kind.capitalize(),
        "types": list(item.provisions),
        "requestedNodeTypes": list(item.requested_nodes),
        "requestedMarkerTypes": list(item.requested_markers),
        "outputVariables": [output.name for output in item.outputs],
        "parameters": {row.name: facts_of(row) for row in item.parameters if not row.internal},
        "visualization": {row.name: facts_of(row) for row in item.visualization},
        "otherNames": {alias: row.name for row in item.parameters for alias in row.aliases},
        "nodes": [other.name for other in partners(item, items, "node")],
        "markers": [other.name for other in partners(item, items, "marker")],
    }
    return repr(facts)


def users(item: Item, items: tuple[Item, ...]) -> list[Item]:
    """Items that this node or marker can serve."""
    if item.kind not in ("node", "marker"):
        return []
    return [other for other in items if item in partners(other, items, item.kind)]


def titled(folder: str) -> str:
    return FOLDER_TITLES[folder]


def enum_label(enum: Enum) -> str:
    return f"enum-{enum.name}"


def rst_type_link(row: Parameter, owner: str) -> str:
    """Return the type; a user function has a link to its section on the page of `owner`."""
    text = rst_type(row)
    return f":ref:`user function <function-{owner}-{row.name}>`" if text == "user function" else text


def shown_by(item: Item, items: tuple[Item, ...]) -> list[Item]:
    """Items whose mini examples use this one."""
    others = (other for other in items if other is not item and other.example)
    return [other for other in others if other.example and item.used_in(other.example.code)]
