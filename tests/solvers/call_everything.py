"""Call every method of a solver with all kinds of arguments, in a separate process: it must not end by a signal.

usage: call_everything.py SOLVER STATE
"""

from __future__ import annotations

import contextlib
import inspect
import os
import sys
import tempfile
from typing import Any

import numpy as np
from oscillators import dynamic_settings, oscillator

import dalembert as exu


def in_state(solver: Any, state: str, settings: Any) -> Any:
    """Bring the solver into the state and return the system that its methods are given."""
    model = oscillator()
    model.mbs.Assemble()
    if state == "solved":
        solver.SolveSystem(model.mbs, settings)
    elif state == "failed":
        empty = exu.SystemContainer().AddSystem()
        empty.Assemble()
        with contextlib.suppress(RuntimeError):
            solver.SolveSystem(empty, settings)
        return empty
    elif state != "new":
        solver.InitializeSolver(model.mbs, settings)
    if state == "assembled again":
        model.mbs.Assemble()
    elif state in ("orphaned", "of another system"):
        model = oscillator()
        model.mbs.Assemble()
    return model.mbs


def argument_lists(mbs: Any, settings: Any) -> list[tuple[Any, ...]]:
    matrix, vector = np.eye(1), np.ones(1)
    return [
        (), (mbs,), (settings,), (mbs, settings), (mbs, settings, 1), (mbs, 1.0), (mbs, 1.0, 1.0, 1.0), (mbs, print),
        (mbs, 0), (matrix,), (np.eye(3),), (vector,), (np.ones(3),), (1,), (0, "x"), (2, "x"), (None,), (None, None),
        (mbs, None), (mbs, "no such file"),
    ]  # fmt: skip


def call_all(solver_class: Any, state: str) -> None:
    settings = dynamic_settings(0.1, 2)
    names = [name for name, _ in inspect.getmembers(solver_class) if not name.startswith("__") or name == "__repr__"]
    for name in names:
        solver = solver_class()
        mbs = in_state(solver, state, settings)
        print(solver_class.__name__, state, name, flush=True)
        value = getattr(solver, name)
        if not callable(value):
            repr(value)
            with contextlib.suppress(AttributeError):  # some are only read
                setattr(solver, name, value)
            continue
        for arguments in argument_lists(mbs, settings):
            with contextlib.suppress(Exception):
                value(*arguments)
            if state != "solved":  # a call may have initialized it
                value = getattr(solver := solver_class(), name)
                mbs = in_state(solver, state, settings)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        call_all(getattr(exu, sys.argv[1]), sys.argv[2])
