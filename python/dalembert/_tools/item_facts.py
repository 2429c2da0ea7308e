"""Parameters and outputs of item types, from the tables of the core."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

from dalembert import _core
from dalembert._item_table import ITEMS
from dalembert._snake_case import snake_case
from dalembert._tools.item_packages import item_class

# Outputs that are the same at each point of a body.
OF_WHOLE_BODY = {"KineticEnergy", "PotentialEnergy", "Coordinates", "CoordinatesTotal", "Coordinates_t",
                  "Coordinates_tt", "Force"}  # fmt: skip


class Row(NamedTuple):
    """A parameter: name in the spec, type and check as the core describes them, unit and further facts, text.

    spelled: the name in the spec, or the further name, that the attribute is made of.
    """

    name: str
    type: str
    check: str
    facts: str
    text: str
    spelled: str = ""


class Output(NamedTuple):
    """An output variable: name, number of components (0: varies), unit and text.

    source, part: the output variable and its components that the output consists of, if it has another name.
    """

    name: str
    size: int
    unit: str
    text: str
    source: str = ""
    part: slice = slice(None)


class Facts(NamedTuple):
    """Parameters and outputs of an item type, by snake_case names."""

    parameters: dict[str, Row]
    visualization: dict[str, Row]
    outputs: dict[str, Output]
    ambiguous: dict[str, str]  # parameters that could be taken for an output, with this output


@cache
def facts_of(item: str) -> Facts:
    """Return the facts of an item type, given by the name of its class, such as 'ObjectMassPoint'."""
    cls = item_class(item)
    outputs = {snake_case(row[0]): Output(*row) for row in _core._outputs_of(cls)}
    parameters = _rows(cls)
    if "marker_numbers" in parameters:
        for k, (name, unit) in enumerate((("Force", "N"), ("Torque", "Nm"))):
            local = outputs.get(f"{name.lower()}_local")
            if local and local.size == 3 and not {name.lower()} & {*outputs, *parameters}:
                text = f"{name.lower()} on the first body, in global axes: WrenchOnMarker0"
                outputs[name.lower()] = Output(name, 3, unit, text, "WrenchOnMarker0", slice(3 * k, 3 * k + 3))
    meant = {name: [each for each in (name, f"{name}_local") if each in outputs] for name in parameters}
    ambiguous = {name: found[0] for name, found in meant.items() if found}
    return Facts(parameters, _rows(item_class(f"V{item}")), outputs, ambiguous)


def _rows(cls: type) -> dict[str, Row]:
    rows = _core._parameters_of(cls)
    return {snake_case(name): Row(*row[:5], spelled=name) for row in rows for name in (row[0], *row[5])}


def is_body(item: str) -> bool:
    """Return whether an object is a body: it has no markers."""
    facts = facts_of(item).parameters
    return item.startswith("Object") and "marker_numbers" not in facts and "slider_marker_number" not in facts


def is_constraint(item: str) -> bool:
    """Return whether an object is a joint or another constraint."""
    return "Constraint" in ITEMS.get(item, {"types": ()})["types"] or "Joint" in item
