"""Assemble systems of the interface with handles; initial states that a solver has found stay."""

from __future__ import annotations

import warnings
from typing import Any, NamedTuple

import numpy as np

from dalembert._checks import FloatArray
from dalembert._core import ConfigurationType

_KEY, _CHANGED = "initialState", "initialStateChanged"  # of MainSystem.sys


class _Kept(NamedTuple):
    """Initial states: that of the parameters of items, and that of the solver."""

    of_items: list[FloatArray]
    of_solver: list[FloatArray]


def _initial_state(system: Any) -> list[FloatArray]:
    return list(map(np.array, system.systemData.GetSystemState(ConfigurationType.Initial)))


def assemble(system: Any) -> None:
    """Assemble a system, and set its state to the initial one.

    After a solver with update_initial_values, this is the state that it found, except for initial values of items that
    have changed since. A warning says so if it is lost, because there are other coordinates.
    """
    kept = system.sys.pop(_KEY, None)
    system.sys.pop(_CHANGED, None)
    system.Assemble()
    if kept is None:
        return
    of_items = _initial_state(system)
    if [len(each) for each in of_items] != [len(each) for each in kept.of_items]:
        warnings.warn(
            "the initial state that update_initial_values has set is lost, because items with coordinates were added "
            "or deleted since: it is that of the items again",
            stacklevel=4,
        )
        return
    merged = [np.where(new == old, found, new) for new, old, found in zip(of_items, *kept, strict=True)]
    for configuration in (ConfigurationType.Initial, ConfigurationType.Current):
        system.systemData.SetSystemState(merged, configuration)
    system.sys[_KEY] = _Kept(of_items, merged)


def assemble_if_needed(system: Any) -> None:
    """Assemble a system that has changed since."""
    if not system.systemIsConsistent or _CHANGED in system.sys:
        assemble(system)


def needs_assembly(system: Any) -> None:
    """Note that initial values of items have changed: a system that is assembled goes on with the old ones."""
    system.sys[_CHANGED] = True


def state_of_items(system: Any) -> list[FloatArray]:
    """Return the initial state that the parameters of items have; the system is assembled."""
    return list(system.sys[_KEY].of_items) if _KEY in system.sys else _initial_state(system)


def keep_initial_state(system: Any, of_items: list[FloatArray]) -> None:
    """Keep the initial state that a solver has set when the system is assembled again."""
    system.sys[_KEY] = _Kept(of_items, _initial_state(system))
