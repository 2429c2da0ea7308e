"""The Create functions of MainSystem: an item with all that belongs to it, such as nodes and markers, in one call."""

from __future__ import annotations

from collections.abc import Callable
from types import FunctionType
from typing import Any

from dalembert.create import bodies, connectors, contacts, flexible, joints, loads, robots, sensors, trees
from dalembert.create._arguments import COMMON, Check, checked
from dalembert.create._mirrors import checks_of, documentation, of_module


def checks(function: Callable[..., Any]) -> dict[str, Check]:
    """Return the checks of the arguments of a Create function, by name."""
    return checks_of(function) | COMMON | of_module(function, "CHECKS")


def _made(function: FunctionType) -> Callable[..., Any]:
    """Return the function with checks and documentation of its arguments."""
    tests = checks(function)
    made = checked(function, tests)
    made.__doc__ = documentation(function, tests)
    return made


# Methods of MainSystem, by name.
functions: dict[str, Callable[..., Any]] = {
    name: _made(function)
    for module in (bodies, connectors, contacts, flexible, joints, loads, trees, sensors, robots)
    for name, function in vars(module).items()
    if name.startswith("Create")
}
