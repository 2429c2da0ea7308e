"""The Create functions of MainSystem: nodes, bodies, markers, connectors, joints and loads in one call each."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from dalembert.create import bodies, connectors, joints, loads, trees
from dalembert.create._arguments import COMMON, Check, checked
from dalembert.create._mirrors import checks_of, documentation


def _made(function: Callable[..., Any], own: dict[str, Check]) -> Callable[..., Any]:
    """Return the function with checks and documentation of its arguments."""
    checks = checks_of(function) | COMMON | own
    made = checked(function, checks)
    made.__doc__ = documentation(function, checks)
    return made


# What MainSystem gets, by the name of the method.
functions: dict[str, Callable[..., Any]] = {
    name: _made(function, getattr(module, "CHECKS", {}).get(name, {}))
    for module in (bodies, connectors, joints, loads, trees)
    for name, function in vars(module).items()
    if name.startswith("Create")
}
