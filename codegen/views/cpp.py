"""C++: members, defaults, reflection rows."""

from __future__ import annotations

import json
import re
from typing import Any

from codegen.model import MARKER_CAPABILITIES, NODE_CAPABILITIES, Item, Output, Parameter, UserFunction
from codegen.model_settings import Enum
from codegen.names import snake_case
from codegen.types import ParameterType

# Enumerations whose name another C++ type of the namespace has.
ENUM_NAMES = {"ItemType": "ItemTypeCode"}  # struct ItemType is the run-time description of an item type

# Folder -> the template that makes physics of a kernel, and the header (dalembert/batches/) that has it.
_ITEM_PHYSICS = {
    "nodes": ("NodePhysicsOf", "node"),
    "bodies": ("BodyPhysics", "body"),
    "super_elements": ("BodyPhysics", "body"),
    "finite_elements": ("BodyPhysics", "body"),
    "connectors": ("ConnectorPhysics", "connector"),
    "contacts": ("ConnectorPhysics", "connector"),
    "constraints": ("ConstraintPhysics", "constraint"),
    "joints": ("ConstraintPhysics", "constraint"),
    "markers": ("MarkerPhysicsOf", "marker"),
    "loads": ("LoadPhysicsOf", "load"),
    "sensors": ("SensorPhysicsOf", "sensor"),
}
_SIZED_BODY = ("SizedBodyPhysics", "sized_body")


def _physics(item: Item) -> tuple[str, str]:
    return _SIZED_BODY if item.sized else _ITEM_PHYSICS[item.folder]


def cpp_string(text: str) -> str:
    return json.dumps(text, ensure_ascii=False)


def cpp_comment(text: str) -> str:
    """Return a line of plain text, without RST markup."""
    return " ".join(text.replace("``", "").replace(":math:", "").replace("\\", "").split())


_MATH = re.compile(r":math:`([^`]*)`")
_FRACTION = re.compile(r"\\tfrac\{(\w+)\}\{(\w+)\}")
_RATE = re.compile(r"\\dot(?: ?(\w)|\{(?:\\mathbf\{)?(\w)\}?\})")
_DECORATED = re.compile(r"\\(?:mathbf|boldsymbol|mathsf|mathrm|tilde)(?:\{([^{}]*)\}| ?(\w))")
_BRACED = re.compile(r"([_^])\{([^{}]*)\}")
_SIGNS = {r"\int": "∫", r"\times": "×", r"\partial": "∂", r"\psi": "ψ", r"\omega": "ω", r"\,": " ", "{}": ""}


def _plain(match: re.Match[str]) -> str:
    """Mathematics as a terminal shows it: J_xy = -∫ x y dm."""
    text = _RATE.sub(r"\1\2_t", _FRACTION.sub(r"\1/\2", match[1]))
    for sign, shown in _SIGNS.items():
        text = text.replace(sign, shown)
    while (simpler := _DECORATED.sub(lambda m: m[1] or m[2] or "", text)) != text:
        text = simpler
    return _BRACED.sub(r"\1\2", text)


def one_line(text: str) -> str:
    """A text for terminals: mathematics without markup."""
    return " ".join(_MATH.sub(_plain, text).split())


def cpp_output_text(output: Output) -> str:
    """An entry of a table of `OutputText`; its size is 0 where it depends on the item."""
    size = output.size if isinstance(output.size, int) else 0
    return f'{{"{output.name}", {size}, {cpp_string(output.unit)}, {cpp_string(one_line(output.doc))}}}'


def cpp_strings(texts: tuple[str, ...]) -> str:
    """The initializer of an array of string views."""
    return "{" + ", ".join(map(cpp_string, texts)) + "}"


def enum_cpp_name(enum: Enum) -> str:
    return ENUM_NAMES.get(enum.name, enum.name)


def cpp_type(type_: ParameterType) -> str:
    return ENUM_NAMES.get(type_.cpp, type_.cpp)


def cpp_member(row: Parameter) -> str:
    """`double physicsMass = 0.0;`"""
    value = cpp_value(row)
    return f"{cpp_type(row.type)} {row.name}{' = ' + value if value else ''};"


def cpp_value(row: Parameter) -> str:
    """The default as an initializer; '' where the type's own default says the same."""
    type_, default = row.type, row.default
    if type_.index and type_.shape:
        count = len(default) if default is not None else row.size or type_.shape[0] or 0
        return f"{type_.cpp}({count})" if count else ""
    if default is None or default == []:
        return ""
    if type_.storage in ("output_variable", "enumeration"):
        return f"{cpp_type(type_)}::{default}"
    return _literal(default, type_)


def _literal(value: Any, type_: ParameterType) -> str:
    if isinstance(value, list):
        flat = _flatten(value)
        if type_.shape[0] is not None and not any(flat):
            return "{}"
        return "{" + ", ".join(_literal(entry, type_) for entry in flat) + "}"
    if isinstance(value, bool):
        return str(value).lower()
    if value == "invalid":
        return "-1"
    return cpp_string(value) if isinstance(value, str) else repr(value)


def _flatten(value: list[Any]) -> list[Any]:
    if value and isinstance(value[0], list):
        return [entry for row in value for entry in _flatten(row)]
    return value


def cpp_row(row: Parameter, offset: str, role: str, enum_number: int | None = None) -> str:
    """The reflection row, with only those fields that differ from the default of `Row`."""
    fields = [
        f".name = {cpp_string(row.name)}",
        f".storage = Storage::{row.type.storage}",
        f".offset = {offset}",
        f".role = Role::{role}",
    ]
    if row.effective_check != "none":
        fields.append(f".check = Check::{row.effective_check}")
    if row.named != "no":
        fields.append(f".named = Named::{row.named}")
    if size := required_length(row):
        fields.append(f".size = {size}")
    if row.type.takes_number:
        fields.append(".takes_number = true")
    if row.internal:
        fields.append(".internal = true")
    if row.optional and row.type.index:
        fields.append(".optional = true")
    if row.needs_assemble and role == "parameter":
        fields.append(".needs_assemble = true")
    if row.unit:
        fields.append(f".unit = {cpp_string(row.unit)}")
    if row.aliases:
        fields.append(f".aliases = {row.name}_aliases")
    if row.type.function:
        fields.append(f".signature = &{row.name}_signature")
    if enum_number is not None:
        fields.append(f".enumeration = {enum_number}")
    return "{" + ", ".join(fields) + "}"


def required_length(row: Parameter) -> int:
    """Length that a std::vector must have; 0: any, or a type of fixed size."""
    if not row.type.cpp.startswith("std::vector"):
        return 0
    return row.size or row.type.shape[0] or 0


def cpp_signature(function: UserFunction) -> str:
    takes = {name: str(name in function.standard).lower() for name in ("t", "itemNumber")}
    result = f"Signature::Kind::{function.returns.type.kind}"
    fields = [
        f".arguments = {function.name}_arguments",
        f".takes_time = {takes['t']}",
        f".takes_item = {takes['itemNumber']}",
        f".result = {result}",
    ]
    if function.compilable:
        parameters = f"{function.name}_arguments, {takes['t']}, {takes['itemNumber']}, {result}"
        fields.append(f".compiled = &compiled_call<{parameters}>")
    return "{" + ", ".join(fields) + "}"


def core_functions(item: Item) -> list[UserFunction]:
    """User functions that the core calls; the others return graphics and are called by Python alone."""
    names = {row.name for row in item.rows if row.type.function}
    return [function for function in item.user_functions if function.name in names]


def cpp_capabilities(words: tuple[str, ...], table: dict[str, str | None]) -> str:
    capabilities = [f"Capability::{table[word]}" for word in words if table[word]]
    return " | ".join(capabilities) or "Capability::none"


def node_ports(item: Item) -> str:
    return cpp_capabilities(item.requested_nodes, NODE_CAPABILITIES)


def marker_ports(item: Item) -> str:
    return cpp_capabilities(item.requested_markers, MARKER_CAPABILITIES)


def type_variable(item: Item) -> str:
    """`object_mass_point_type`"""
    return f"{snake_case(item.name)}_type"


def tables_namespace(item: Item) -> str:
    """`object_mass_point`"""
    return snake_case(item.name)


def item_kind(item: Item) -> str:
    return f"ItemKind::{item.kind}"


def uses_enums(item: Item) -> bool:
    return any(row.type.storage in ("output_variable", "joint_types", "enumeration") for row in item.rows)


def kernel_header(item: Item) -> str:
    """The header of the kernel of an item of the core."""
    return f"dalembert/items/{item.stem}.hpp"


def physics_includes(item: Item, kernels: dict[str, str]) -> list[str]:
    """Headers that the instantiation of a ready item's physics needs, in alphabetical order; `kernels` by item."""
    if not item.ready or item.irregular:
        return []
    batch = _physics(item)[1]
    return sorted([f"dalembert/batches/{batch}.hpp", *(kernels[name] for name in (item.name, *item.nodes))])


def reflection_includes(item: Item) -> list[str]:
    """Headers that the rows need."""
    compiled = any(function.compilable for function in core_functions(item))
    return [f"dalembert/reflection/{name}.hpp" for name in (["compiled_call"] if compiled else []) + ["item_type"]]


def physics_expression(item: Item) -> str:
    """Return the expression that makes the item's physics; '' if it is planned."""
    if not item.ready:
        return ""
    if item.irregular:
        return f"{snake_case(item.name)}_physics()"
    return f"{_physics(item)[0]}<{', '.join((item.name, f'{item.name}Record', *item.nodes))}>{{}}"
