"""Use objects that only __new__ has made, of every compiled class, in a process of its own."""

from __future__ import annotations

import contextlib
import copy
import inspect
import pickle
from collections.abc import Iterator
from types import ModuleType
from typing import Any

from dalembert import _core

OPERATIONS = (
    repr, str, len, hash, bool, iter, list, float, int, dir, abs, copy.copy, copy.deepcopy, pickle.dumps,
    lambda x: x == x, lambda x: x != 1, lambda x: x < x, lambda x: x[0], lambda x: x + x, lambda x: -x, lambda x: 2 * x,
    lambda x: x(), lambda x: type(x)(x), lambda x: _core.MainSystem().AddNode(x), lambda x: _core.MainSystem().AddObject(x),
    lambda x: _core.SystemContainer().Append(x), lambda x: x.__setitem__(0, 1), lambda x: _core.MainSolverStatic().SolveSystem(x, x),
)  # fmt: skip


def classes(module: ModuleType) -> Iterator[Any]:
    for value in vars(module).values():
        if isinstance(value, ModuleType) and value.__name__.startswith(module.__name__):
            yield from classes(value)
        elif inspect.isclass(value):
            yield value


def use(empty: Any) -> None:
    name = type(empty).__name__
    for number, operation in enumerate(OPERATIONS):
        print(name, "operation", number, flush=True)
        with contextlib.suppress(Exception):
            operation(empty)
    for attribute in dir(type(empty)):
        if attribute in ("__class__", "__new__", "__init__"):
            continue
        print(name, attribute, flush=True)
        with contextlib.suppress(Exception):
            value = getattr(empty, attribute)
            setattr(empty, attribute, value)
        with contextlib.suppress(Exception):
            getattr(empty, attribute)()


if __name__ == "__main__":
    for made in classes(_core):
        with contextlib.suppress(TypeError):  # of classes that make no objects
            use(made.__new__(made))
