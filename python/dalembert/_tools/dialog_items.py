"""Items of dialogs of interactive.InteractiveDialog: invalid ones are rejected before the simulation starts."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from dalembert._checks import as_number, check_integer, shape_error
from dalembert._tools.found_items import index_of

NEEDED = {  # required entries of dialog items, besides their type
    "label": ("text",),
    "button": ("callFunction",),
    "entry": ("variable",),
    "check": ("variable",),
    "slider": ("variable",),
    "radio": ("variable", "textValueList"),
}
CURVE = "[(sensor, component), (sensor, component), text, text], with the titles of both axes; component 0 is the time"


def check_items(where: str, items: Any) -> None:
    """Raise an error for items with an unknown type, missing entries, or invalid values."""
    if not isinstance(items, (list, tuple)) or not all(isinstance(item, dict) for item in items):
        raise shape_error(where, "a list of dictionaries", items)
    for number, item in enumerate(items):
        here, kind = f"{where}[{number}]", item.get("type")
        if not isinstance(kind, str) or kind not in NEEDED:
            raise shape_error(f"{here}: type", " or ".join(NEEDED), kind)
        if missing := [name for name in NEEDED[kind] if name not in item]:
            raise ValueError(f"{here}: a {kind} needs '{missing[0]}'")
        if "variable" in item and not (isinstance(item["variable"], str) and item["variable"]):
            raise shape_error(f"{here}: variable", "the name of a variable", item["variable"])
        if item.get("grid") is not None:
            _check_grid(f"{here}: grid", item["grid"])
        if kind in CHECKS:
            CHECKS[kind](here, item)


def _check_grid(where: str, grid: Any) -> None:
    expected = "(row, column) or (row, column, columns), or a list of these"
    places = grid if isinstance(grid, (list, tuple)) and grid and isinstance(grid[0], (list, tuple)) else [grid]
    for place in places:
        if not isinstance(place, (list, tuple)) or len(place) < 2:
            raise shape_error(where, expected, grid)
        for number in place:
            check_integer(where, number, 0)


def _check_button(here: str, item: dict[str, Any]) -> None:
    if not callable(item["callFunction"]):
        raise shape_error(f"{here}: callFunction", "a function without arguments", item["callFunction"])


def _check_value(here: str, item: dict[str, Any]) -> None:
    if not _is_plain(value := item.get("value", 0)):
        raise shape_error(f"{here}: value", "a number or a text", value)


def _check_slider(here: str, item: dict[str, Any]) -> None:
    ends = item.get("range", (0, 1))
    if not isinstance(ends, (list, tuple, np.ndarray)) or len(ends) != 2:
        raise shape_error(f"{here}: range", "two numbers", ends)
    low, high = (as_number(f"{here}: range", end) for end in ends)
    if not low < high:
        raise shape_error(f"{here}: range", "two numbers, the smaller one first", ends)
    as_number(f"{here}: value", item.get("value", low))
    check_integer(f"{here}: steps", item.get("steps", 1), 1)


def _check_radio(here: str, item: dict[str, Any]) -> None:
    pairs = item["textValueList"]
    expected = "a list of pairs (text, value), whose values are numbers or texts"
    if not isinstance(pairs, (list, tuple)) or not pairs:
        raise shape_error(f"{here}: textValueList", expected, pairs)
    for pair in pairs:
        if not isinstance(pair, (list, tuple)) or len(pair) != 2 or not _is_plain(pair[1]):
            raise shape_error(f"{here}: textValueList", expected, pair)
    _check_value(here, item)


CHECKS: dict[str, Callable[[str, dict[str, Any]], None]] = {
    "button": _check_button,
    "check": _check_value,
    "entry": _check_value,
    "slider": _check_slider,
    "radio": _check_radio,
}


def _is_plain(value: Any) -> bool:
    return isinstance(value, (bool, int, float, str, np.bool_, np.integer, np.floating))


def initial_value(item: dict[str, Any]) -> Any:
    """Return the value with which an item starts; sliders start in the middle if theirs is out of range."""
    value = item.get("value", 0.5 if item["type"] == "slider" else 0)
    value = value.item() if isinstance(value, (np.generic, np.ndarray)) else value  # converted for messages
    if item["type"] != "slider":
        return value
    low, high = item.get("range", (0, 1))
    return value if low <= value <= high else 0.5 * (low + high)


def check_plots(where: str, mbs: Any, plots: Any) -> None:
    """Raise an error for plots of unknown sensors or components."""
    if plots is None or (isinstance(plots, list) and not plots):
        return
    if not isinstance(plots, dict):
        raise shape_error(where, "a dictionary with 'sensors', or None", plots)
    curves = plots.get("sensors", [])
    if not isinstance(curves, (list, tuple)):
        raise shape_error(f"{where}['sensors']", f"a list of {CURVE}", curves)
    for number, curve in enumerate(curves):
        here = f"{where}['sensors'][{number}]"
        if not isinstance(curve, (list, tuple)) or len(curve) < 2:
            raise shape_error(here, CURVE, curve)
        for pair in curve[:2]:
            if not isinstance(pair, (list, tuple)) or len(pair) != 2:
                raise shape_error(here, CURVE, curve)
            check_integer(f"{here}: component", pair[1], 0)
            if pair[1] > 0:
                index_of(mbs, "Sensor", pair[0], f"{here}: sensor")
    check_integer(f"{where}['nPoints']", plots.get("nPoints", 1), 1)
