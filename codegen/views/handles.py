"""Stubs of handles and of the create methods of Model; dalembert._model.handle makes the same classes at run time."""

from __future__ import annotations

import re
from collections.abc import Sequence

from codegen.load_create import CreateArgument, CreateFunction
from codegen.model import BODY_FOLDERS, Item, Output, Parameter
from codegen.names import snake_case
from codegen.views.python import argument_type, doc_text, value_type

# Outputs that are the same at each point of a body, as in dalembert._model.handle.
_OF_WHOLE_BODY = (
    "KineticEnergy",
    "PotentialEnergy",
    "Coordinates",
    "CoordinatesTotal",
    "Coordinates_t",
    "Coordinates_tt",
    "Force",
)
# Arguments that create methods of Model do not have, as in dalembert._model.model.
_OLD_ARGUMENTS = ("returnDict", "bodyList", "bodyOrNodeList")
_INDICES = ("NodeIndex", "ObjectIndex", "MarkerIndex", "LoadIndex", "SensorIndex")


def attribute_name(name: str) -> str:
    return snake_case(name)


def base_of_handle(item: Item) -> str:
    return f"{item.kind.capitalize()}Handle"


def handle_parameters(item: Item) -> list[tuple[str, Parameter]]:
    """Return the attributes of a handle that are parameters: snake_case names, those of the spec, and other names."""
    hidden = _ambiguous(item)
    found: dict[str, Parameter] = {}
    for row in item.parameters:
        for name in (row.name, *row.aliases):
            if snake_case(name) not in hidden and not row.internal:
                found.setdefault(snake_case(name), row)
                found.setdefault(name, row)
    return list(found.items())


def _ambiguous(item: Item) -> set[str]:
    """Return the names that could be a parameter or an output."""
    outputs = {snake_case(each.name) for each in item.outputs}
    names = {snake_case(name) for row in item.parameters for name in (row.name, *row.aliases)}
    return {name for name in names if {name, f"{name}_local"} & outputs}


def handle_outputs(item: Item) -> list[tuple[str, Output]]:
    """Return the attributes of a handle that are outputs."""
    hidden = _ambiguous(item)
    return [(snake_case(each.name), each) for each in item.outputs if snake_case(each.name) not in hidden]


def has_points(output: Output, item: Item) -> bool:
    """Return whether an output depends on the point of a body."""
    body = item.folder in BODY_FOLDERS
    return body and output.name not in _OF_WHOLE_BODY


def global_wrench(item: Item) -> list[tuple[str, str]]:
    """Return `force` and `torque`, with units, of items that have them in local axes only."""
    rows = {snake_case(row.name) for row in item.parameters}
    if "marker_numbers" not in rows:
        return []
    sizes = {snake_case(each.name): each.size for each in item.outputs}
    return [
        (name, unit)
        for name, unit in (("force", "N"), ("torque", "Nm"))
        if sizes.get(f"{name}_local") == 3 and name not in sizes and name not in rows
    ]


def output_type(output: Output) -> str:
    if output.name.startswith("HomogeneousTransformation"):
        return "HT"
    return "float" if output.size == 1 else "Array"


def handle_value_type(row: Parameter, item: Item) -> str:
    """Return the type of a parameter that is read."""
    text = value_type(row, item)
    for index in _INDICES:
        text = text.replace(index, index.replace("Index", "Handle"))
    if text == "list[float]":
        return "Array"
    return f"tuple[{text[5:-1]}, ...]" if text.startswith("list[") and "list" not in text[5:] else text


def handle_argument_type(row: Parameter, item: Item) -> str:
    """Return the type of values that a parameter can be set to: texts for enumerations, axes and colors too."""
    text = argument_type(row, item)
    worded = row.type.storage == "output_variable" or row.effective_check in ("color", "unit_vector")
    return f"{text} | str" if worded and "str" not in text else text


def method_arguments(function: CreateFunction) -> list[CreateArgument]:
    """Return the arguments of a create method: handles and body_numbers take the place of some older ones."""
    return [argument for argument in function.arguments if argument.name not in _OLD_ARGUMENTS]


def method_aliases(function: CreateFunction, items: Sequence[Item]) -> list[tuple[str, CreateArgument]]:
    """Return the further names of arguments, which are those of the parameters of the items."""
    known = {argument.name: argument for argument in function.arguments}
    made = [item for item in items if function.name in item.create_functions]
    found = {alias: row.name for item in made for row in item.parameters for alias in row.aliases}
    return [(alias, known[name]) for alias, name in found.items() if name in known and alias not in known]


def method_summary(function: CreateFunction) -> str:
    return doc_text(re.sub(r"(Object|Load|Sensor)Index", "handle", function.summary))


def method_type(function: CreateFunction, items: Sequence[Item]) -> str:
    """Return the type of the result of a create method: the handle of the item, or of any item of its kind."""
    if function.returns in ("ObjectIndex", "LoadIndex", "SensorIndex", "Any"):
        kind = function.returns.removesuffix("Index").lower()
        made = [item for item in items if kind in (item.kind, "any") and function.name in item.create_functions]
        spatial = sorted(made, key=lambda item: (item.kind != "object", item.stem.endswith("_2d"), item.name))
        if spatial:
            return f"handles.{spatial[0].name}"
        return "Any" if function.returns == "Any" else f"{kind.capitalize()}Handle"
    return function.returns.replace("ObjectIndex", "ObjectHandle")


def method_argument_type(argument: CreateArgument) -> str:
    """Return the type of an argument of a create method."""
    lower, text = argument.name.lower(), argument.annotation
    worded = lower.startswith("color") or "axis" in lower or "normal" in lower or argument.name == "nodeType"
    if argument.name == "nodeType":
        text = "NodeType"
    if argument.name.startswith(("bodyNumber", "bodyOrNode", "bodyList")) and "Sequence" in text:
        text = "Sequence[Connected | None]"
    return f"{text} | str" if worded and "float" not in text and "str" not in text else text
