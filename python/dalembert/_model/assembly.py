"""Assemble systems of the interface with handles, and keep the states that solvers have found as initial values."""

from __future__ import annotations

from typing import Any

import numpy as np

from dalembert._core import ConfigurationType, NodeIndex

_CHANGED = "initialValuesChanged"  # of MainSystem.sys
_ROWS = ("initialCoordinates", "initialVelocities", "initialCoordinates_t")


def assemble(system: Any) -> None:
    """Assemble a system, and set its state to the initial values of the items."""
    system.sys.pop(_CHANGED, None)
    system.Assemble()


def assemble_if_needed(system: Any) -> None:
    """Assemble a system that has changed since."""
    if not system.systemIsConsistent or _CHANGED in system.sys:
        assemble(system)


def needs_assembly(system: Any) -> None:
    """Note that initial values of items have changed: a system that is assembled goes on with the old ones."""
    system.sys[_CHANGED] = True


def keep_as_initial_values(system: Any) -> None:
    """Write the initial state that a solver has set into the nodes, which keep it when the system is assembled."""
    data, initial = system.systemData, ConfigurationType.Initial
    q, v, y, states = (
        np.asarray(get(initial))
        for get in (
            data.GetODE2Coordinates,
            data.GetODE2Coordinates_t,
            data.GetODE1Coordinates,
            data.GetDataCoordinates,
        )
    )
    for number in range(data.NumberOfNodes()):
        node = NodeIndex(number)
        mechanical = data.GetNodeLTGODE2(node)
        values = [q[mechanical], v[mechanical]] if len(mechanical) else [y[data.GetNodeLTGODE1(node)]]
        if len(of_data := data.GetNodeLTGData(node)):
            values = [states[of_data]]
        rows = [row for row in _ROWS if row in system.GetNode(node)]
        for row, value in zip(rows, values, strict=False):
            if len(value):
                system.SetNodeParameter(node, row, value)
