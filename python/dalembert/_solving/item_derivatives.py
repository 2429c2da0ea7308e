"""Numerical derivatives of outputs by the coordinates of items."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from dalembert._checks import FloatArray, shape_error
from dalembert._core import MainSystem, NodeIndex, ObjectIndex


def ItemODE2Coordinates(mbs: MainSystem, itemIndex: ObjectIndex | NodeIndex) -> list[int]:
    """Return the global numbers of the second-order coordinates of an object or a node."""
    data = mbs.systemData
    if isinstance(itemIndex, ObjectIndex):
        return [int(i) for i in data.GetObjectLTGODE2(itemIndex)]
    if isinstance(itemIndex, NodeIndex):
        return [int(i) for i in data.GetNodeLTGODE2(itemIndex)]
    raise shape_error("ItemODE2Coordinates: itemIndex", "an ObjectIndex or NodeIndex", itemIndex)


def NumericalJacobian(
    mbs: MainSystem,
    function: Callable[[], Any],
    coordinates: Sequence[int],
    velocities: bool = False,
    epsilon: float = 1e-6,
) -> FloatArray:
    """Return the derivative of function() by second-order coordinates, or by their rates, by central differences.

    Rows are the values of function, columns the coordinates; the state is the same afterwards.
    """
    data = mbs.systemData
    read, write = (
        (data.GetODE2Coordinates_t, data.SetODE2Coordinates_t)
        if velocities
        else (data.GetODE2Coordinates, data.SetODE2Coordinates)
    )
    start = np.array(read())
    columns = []
    try:
        for i in coordinates:
            ends = []
            for step in (epsilon, -epsilon):
                moved = start.copy()
                moved[i] += step
                write(moved)
                ends.append(np.array(function(), dtype=float).ravel())
            columns.append((ends[0] - ends[1]) / (2 * epsilon))
    finally:
        write(start)
    return np.array(columns).T
