"""The generated tests of items: `from dalembert.testing import *` in a test file of an item package.

Every item has the same tests: residual and tangent, invariance under rigid motion, action and reaction, work of
reactions, outputs and their rates, sensors, switching, repeated and varied solutions. They build random models around
the item; the [scene] table of its spec describes these. Needs pytest and the extra dalembert[items].
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import Any

from dalembert import _core

MODULES = (
    *("examples", "invariance", "mass", "momentum", "output_rates", "outputs", "parameters_act", "refused_changes"),
    *("repeated_solves", "sensors", "switching", "tangents", "virtual_work"),
)

try:
    import pytest
except ModuleNotFoundError:
    pass  # functions of the core do not need it
else:
    pytest.register_assert_rewrite(*(f"dalembert.testing.{module}" for module in MODULES))

    try:
        import codegen  # noqa: F401
    except ModuleNotFoundError:  # not in the repository: that of the wheel
        from dalembert._tools.item_builds import home

        sys.path.append(str(home()))

    @pytest.fixture(autouse=True)
    def in_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        """Change to an empty folder, because solvers write files into the working folder."""
        monkeypatch.chdir(tmp_path)


def _is_of_items(test: Callable[..., Any]) -> bool:
    """Whether a test is parametrized by items or models around them, and there are some."""
    marks = [mark for mark in getattr(test, "pytestmark", ()) if mark.name == "parametrize"]
    if not all(len(mark.args[1]) for mark in marks):
        return False
    names = {name for mark in marks for name in ([mark.args[0]] if isinstance(mark.args[0], str) else mark.args[0])}
    return bool(names & {"item", "variant"})


def __getattr__(name: str) -> Any:
    """Return a test of the items; they are collected at the first use, because that builds the list of models."""
    if name == "__all__":
        tests = {}
        for module in MODULES:
            for key, value in vars(import_module(f"dalembert.testing.{module}")).items():
                if key.startswith("test_") and _is_of_items(value):
                    tests[key] = value
        globals().update(tests)
        globals()["__all__"] = [*tests, "in_empty_folder"]
        return globals()["__all__"]
    return getattr(_core.testing, name)  # exu.testing: functions of the core for tests
