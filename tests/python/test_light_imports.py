"""The lines that each model begins with load no library that few models need."""

from __future__ import annotations

import subprocess
import sys
from importlib import import_module

import pytest

import dalembert as exu
from dalembert import create, mainSystemExtensions

HEAVY = ("scipy", "matplotlib", "PIL", "asyncio", "websockets", "h5py", "sympy", "gymnasium", "email", "socket")


@pytest.mark.parametrize(
    "line",
    [
        "import dalembert",
        "import dalembert.itemInterface",
        "from dalembert.utilities import *",
        "from dalembert.beams import *",
        "import dalembert.plot, dalembert.graphics, dalembert.solver, dalembert.rigidBodyUtilities",
        "import dalembert.FEM",
        "import dalembert; dalembert.SystemContainer().AddSystem().CreateGround()",
    ],
)
def test_heavy_libraries_are_not_loaded(line: str) -> None:
    script = f"import sys; {line}; print(*sorted({set(HEAVY)} & set(sys.modules)))"
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert run.stdout.split() == []


def test_mesh_functions_load_scipy_when_they_need_it() -> None:
    script = (
        "import sys; import dalembert.FEM; print(*(m for m in ('scipy.sparse', 'scipy.linalg') if m in sys.modules))"
    )
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert run.stdout.split() == []


def test_methods_are_in_the_modules_that_are_named() -> None:
    for name, module in mainSystemExtensions._MODULE_OF.items():
        assert getattr(import_module(f"dalembert.{module}"), name) is getattr(exu.MainSystem, name)
    for module, names in create.MODULES.items():
        there = import_module(f"dalembert.create.{module}")
        own = {
            name
            for name, value in vars(there).items()
            if name.startswith("Create") and value.__module__ == there.__name__
        }
        assert own == set(names)


def test_methods_are_loaded_when_they_are_first_used() -> None:
    script = """
import sys, dalembert
mbs = dalembert.SystemContainer().AddSystem()
print("dalembert.create.bodies" in sys.modules, "dalembert._solving.buckling" in sys.modules)
print(mbs.CreateGround(), mbs.CreateGround.__self__ is mbs, dalembert.MainSystem.CreateGround.__name__)
print("dalembert.create.bodies" in sys.modules, "dalembert._solving.buckling" in sys.modules)
"""
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert run.stdout.split() == ["False", "False", "0", "True", "CreateGround", "True", "False"]
