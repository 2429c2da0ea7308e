"""The Create functions of MainSystem: nodes, bodies, markers, connectors, joints and loads in one call each."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from dalembert.create import bodies, connectors, joints, loads
from dalembert.create._arguments import checked

# What MainSystem gets, by the name of the method.
functions: dict[str, Callable[..., Any]] = {
    name: checked(function, module.CHECKS[name])
    for module in (bodies, connectors, joints, loads)
    for name, function in vars(module).items()
    if name.startswith("Create")
}
