"""Properties of a sensor: output variable, unit, names of its components; and continuous angles."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np

from dalembert import _core
from dalembert._checks import FloatArray
from dalembert._tools.item_packages import item_class, item_classes

_XYZ_VARIABLES = {
    "Position", "Displacement", "Velocity", "Acceleration", "Rotation", "AngularVelocity", "AngularAcceleration",
    "Force", "Torque",
}  # fmt: skip
_ABOUT_Z = {"Rotation", "AngularVelocity", "AngularAcceleration"}  # planar items have one value
_TENSOR_VARIABLES = {"Strain", "Stress"}
ANGLES = {"Rotation"}


def variable_of(mbs: Any, sensor: Mapping[str, Any]) -> str:
    """Return the name of the quantity that a sensor measures."""
    if "outputVariableType" in sensor:
        return str(sensor["outputVariableType"]).removeprefix("OutputVariableType.")
    if sensor.get("sensorType") != "Load":
        return str(sensor.get("sensorType", ""))
    load_type = mbs.GetLoad(sensor["loadNumber"])["loadType"]
    return load_type.removesuffix("Vector") if load_type in ("ForceVector", "TorqueVector") else "Load"


def component_name(variable: str, component: int, size: int) -> str:
    """Return X, Y, Z where it applies, XX to XY of strains and stresses, and numbers otherwise."""
    base = variable.replace("Local", "")
    if base in _ABOUT_Z and size == 1:
        return "Z"
    if base in _XYZ_VARIABLES and 0 <= component < 3:
        return "XYZ"[component]
    if base in _TENSOR_VARIABLES and 0 <= component < 6:
        return ("XX", "YY", "ZZ", "YZ", "XZ", "XY")[component]
    return str(component)


def unit_of(mbs: Any, sensor: Mapping[str, Any]) -> str:
    """Return the unit of a sensor; '' if it depends on the component, or is unknown."""
    variable = variable_of(mbs, sensor)
    unit = "various"
    for kind in ("Node", "Object", "Body", "Marker", "Load"):
        number = sensor.get(f"{kind.lower()}Number")
        if number is None:
            continue
        kind = "Object" if kind == "Body" else kind
        item = getattr(mbs, f"Get{kind}")(number)
        name = kind + str(item[f"{kind.lower()}Type"])
        unit = _load_unit(name) if kind == "Load" else _units(name).get(variable) or usual_units().get(variable, "")
    return "" if unit in ("various", "1") else unit


@cache
def _units(name: str) -> dict[str, str]:
    """Return units of the output variables of an item type."""
    cls = item_classes().get(name)
    return {row[0]: row[2] for row in _core._outputs_of(cls)} if cls is not None else {}


@cache
def usual_units() -> dict[str, str]:
    """Return units of the variables that have the same in all items, for markers that pass on those of others."""
    found: dict[str, set[str]] = {}
    for name, cls in item_classes().items():
        if name == cls.__name__ and issubclass(cls, _core.Item):
            for row in _core._outputs_of(cls):
                found.setdefault(row[0], set()).add(row[2])
    return {variable: units.pop() for variable, units in found.items() if len(units) == 1}


@cache
def unit_on_bodies(variable: str) -> str:
    """Return the unit of an output variable of nodes and bodies; '' if they do not have the same."""
    markers = {
        name for name, cls in item_classes().items() if "markerNumbers" in {r[0] for r in _core._parameters_of(cls)}
    }
    names = [name for name in item_classes() if name.startswith(("Node", "Object")) and name not in markers]
    units = {unit for name in names if (unit := _units(name).get(variable))}
    return units.pop() if len(units) == 1 and not units & {"various", "1"} else ""


def _load_unit(name: str) -> str:
    facts = next((row[3] for row in _core._parameters_of(item_class(name)) if row[0] in ("load", "loadVector")), "")
    return facts.rpartition("unit ")[2]


def continuous(variable: str, values: FloatArray) -> FloatArray:
    """Return angles, rows over time, without jumps by a full turn; other values as they are."""
    return np.unwrap(values, axis=0) if variable in ANGLES else values
