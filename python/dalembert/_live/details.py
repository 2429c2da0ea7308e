"""Panel of an item: its parameters and current outputs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from dalembert import _core
from dalembert._checks import FloatArray
from dalembert._core import ConfigurationType, OutputVariableType
from dalembert._tools.item_facts import facts_of
from dalembert._tools.sensor_facts import component_name, unit_of, usual_units, variable_of

KINDS = ("Node", "Object", "Marker", "Load", "Sensor")
LONGEST = 160  # characters of a value
POINTS = 1000  # of a curve
SHOWN = ConfigurationType.Visualization


def parameters(mbs: Any, kind: str, number: int, with_graphics: bool) -> list[list[str]]:
    """Return names and values, as texts; the lists of graphics data can be very long."""
    rows = []
    for name, value in getattr(mbs, f"Get{kind}")(number).items():
        if name.endswith("UserFunction") and not value:
            continue
        if with_graphics or name != "VgraphicsData":
            rows.append([str(name), text(value)])
    return rows


def numbers(mbs: Any, kind: str, number: int) -> dict[str, float]:
    """Return the parameters that pages may change while a solver runs: single numbers, and constants of functions."""
    given = dict(getattr(mbs, f"Get{kind}")(number))
    try:
        rows = facts_of(f"{kind}{given[f'{kind.lower()}Type']}").parameters.values()
    except KeyError:  # of a package that has no table
        return {}
    result = {}
    for row in rows:
        value = given.get(row.name)
        if isinstance(value, float) and "Assemble()" not in row.facts:
            result[row.name] = value
        elif isinstance(value, _core.symbolic.UserFunction):
            names = [f"{row.name}.{name}" for name in value._Variables()]
            get = getattr(mbs, f"Get{kind}Parameter")
            result |= {each: found for each in names if isinstance(found := get(number, each), float)}
    return result


def outputs(mbs: Any, kind: str, number: int) -> list[list[str]]:
    """Return the names of all outputs that an item has, and their values in the state that is shown."""
    if kind == "Load":
        return []
    names = ["values"] if kind == "Sensor" else [variable.name for variable in _variables()]
    return [[name, text(found)] for name in names if (found := output(mbs, kind, number, name)) is not None]


def output(mbs: Any, kind: str, number: int, name: str) -> Any:
    """Return the value of an output in the state that is shown, or None for outputs that the item does not have."""
    if kind == "Sensor":
        return _asked(lambda: mbs.GetSensorValues(number, SHOWN)) if name == "values" else None
    variable = OutputVariableType.__members__[name]
    if kind == "Object":
        found = _asked(lambda: mbs.GetObjectOutputBody(number, variable, [0, 0, 0], SHOWN))
        return _asked(lambda: mbs.GetObjectOutput(number, variable, SHOWN)) if found is None else found
    return _asked(lambda: getattr(mbs, f"Get{kind}Output")(number, variable, SHOWN))


def title(mbs: Any, kind: str, number: int) -> str:
    """Return a name for readers."""
    return f"{kind.lower()} {number} '{getattr(mbs, f'Get{kind}')(number)['name']}'"


def units(mbs: Any, kind: str, number: int) -> dict[str, dict[str, str]]:
    """Return the units of parameters and outputs, as far as they are known."""
    item = getattr(mbs, f"Get{kind}")(number)
    if kind == "Sensor":
        return {"parameters": {}, "outputs": {"values": unit_of(mbs, item)}}
    try:
        facts = facts_of(f"{kind}{item[f'{kind.lower()}Type']}")
    except KeyError:  # of a package that has no table
        return {"parameters": {}, "outputs": {}}
    rows = {row.spelled: row.facts.partition("unit ")[2].partition(";")[0] for row in facts.parameters.values()}
    usual = usual_units() | {"WrenchOnMarker0": "N, Nm", "WrenchOnMarker1": "N, Nm"}
    known = usual | {each.name: each.unit for each in facts.outputs.values()}
    return {what: {name: unit for name, unit in all_.items() if unit not in ("", "1", "various")}
            for what, all_ in (("parameters", rows), ("outputs", known))}  # fmt: skip


def curves(mbs: Any, kind: str, number: int, name: str, values: list[tuple[float, Any]]) -> dict[str, Any]:
    """Return a plot of an output over time: its title, and the curves of its components."""
    rows = values[:: -(-len(values) // POINTS)] if values else []
    columns = np.array([np.ravel(value) for _, value in rows], float).T
    variable = variable_of(mbs, mbs.GetSensor(number)) if kind == "Sensor" else name
    unit = units(mbs, kind, number)["outputs"].get(name, "")
    names = [component_name(variable, k, len(columns)) if len(columns) > 1 else "" for k in range(len(columns))]
    of = "" if kind == "Sensor" else f": {name}"
    return {
        "title": f"{title(mbs, kind, number)}{of}{f' ({unit})' if unit else ''}", "xLabel": "t (s)",
        "curves": [{"name": component, "x": [time for time, _ in rows], "y": finite(column)}
                   for component, column in zip(names, columns, strict=True)],
    }  # fmt: skip


def finite(values: FloatArray) -> list[float | None]:
    """Return numbers for a message, with None for infinite ones and NaN, which JSON does not have."""
    return [float(value) if np.isfinite(value) else None for value in values]


def _variables() -> list[Any]:
    return [variable for name, variable in OutputVariableType.__members__.items() if not name.startswith(("_", "End"))]


def _asked(ask: Callable[[], Any]) -> Any:
    try:
        value = ask()
    except (RuntimeError, ValueError, NotImplementedError, IndexError, TypeError):
        return None
    return value if np.size(value) else None


def text(value: Any) -> str:
    """Return a value in few characters."""
    if isinstance(value, (float, np.floating)):
        return f"{value:.6g}"
    if isinstance(value, np.ndarray):
        shown = np.round(value, 5) + 0.0 if value.dtype.kind == "f" and np.abs(value).max(initial=0.0) < 1e4 else value
        result = np.array2string(shown, precision=5, separator=", ", threshold=40, suppress_small=True)
    elif isinstance(value, (list, tuple)) and value and all(isinstance(entry, (int, float)) for entry in value):
        result = "[" + ", ".join(text(entry) for entry in value[:40]) + (", ...]" if len(value) > 40 else "]")
    elif isinstance(value, (list, Mapping)) and len(value) > 8:
        result = f"{type(value).__name__} with {len(value)} entries"
    else:
        result = str(value)
    return result if len(result) <= LONGEST else result[: LONGEST - 3] + "..."
