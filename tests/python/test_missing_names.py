"""Names that a module has not: imports and attributes suggest the nearest name, or its module."""

from __future__ import annotations

import pickle
import subprocess
import sys
from importlib import import_module
from pathlib import Path
from types import ModuleType

import cloudpickle
import pytest

import dalembert as exu

PACKAGE = Path(exu.__file__).parent
PUBLIC = sorted({f"dalembert.{name}" for name in exu._submodules} | {
    "dalembert." + ".".join(path.relative_to(PACKAGE).with_suffix("").parts)
    for path in PACKAGE.glob("robotics/[a-z]*.py")
})  # fmt: skip


def imported(module: str, name: str) -> str:
    with pytest.raises(ImportError) as caught:
        exec(f"from {module} import {name}", {})
    return str(caught.value)


def public_name(module: ModuleType) -> str:
    names = vars(module).get("__all__") or [n for n in dir(module) if not n.startswith("_")]
    return max(names, key=len)


@pytest.mark.parametrize("module", ["dalembert", *PUBLIC])
def test_imports_suggest_the_nearest_name(module: str) -> None:
    found = import_module(module)
    name = public_name(found)
    wrong = name[:-2] + name[-1] + name[-2] + "x"
    told = imported(module, wrong)
    assert told.startswith(f"cannot import name '{wrong}' from '{module}'. Did you mean '"), told
    hint = "" if module.endswith("itemInterface") else r"\. Did you mean"  # Python itself has one for readers
    with pytest.raises(AttributeError, match=rf"module '{module}' has no attribute '{wrong}'{hint}"):
        getattr(found, wrong)
    assert not hasattr(found, wrong) and getattr(found, "_no_name", 3) == 3


def test_names_of_other_modules() -> None:
    assert imported("dalembert.utilities", "ParameterVariation").endswith("; it belongs to dalembert.processing")
    assert imported("dalembert.graphics", "LoadSolutionFile").endswith("; it belongs to dalembert.utilities")
    assert imported("dalembert.utilities", "SystemContainer").endswith("; it belongs to dalembert")
    assert imported("dalembert.utilities", "CreateGround").endswith("it is a method of a system: mbs.CreateGround(...)")
    with pytest.raises(AttributeError, match="known are: AddEdges"):
        exu.graphics.Box  # noqa: B018
    for name in ("", "zzz", "__none__"):  # modules in packages are loaded with it
        assert __import__("dalembert.graphics", fromlist=[name]) is exu.graphics


def test_modules_that_are_not_there() -> None:
    with pytest.raises(
        ModuleNotFoundError, match=r"No module named 'dalembert\.utilties'\. Did you mean 'utilities'\?"
    ):
        import_module("dalembert.utilties")
    with pytest.raises(ModuleNotFoundError, match=r"No module named 'dalembert\.qqq'$"):
        import_module("dalembert.qqq")
    assert imported("dalembert", "utilties") == "No module named 'dalembert.utilties'. Did you mean 'utilities'?"


def test_packages_can_be_sent_to_processes() -> None:
    for module in (exu, exu.graphics, exu.robotics, exu.utilities):
        assert pickle.loads(cloudpickle.dumps(module)) is module


def test_private_names_are_not_suggested() -> None:
    told = imported("dalembert.utilities", "_LoadSolutionFile")
    assert told.startswith("cannot import name '_LoadSolutionFile' from 'dalembert.utilities' (/"), told
    assert "dalembert._checks" in sys.modules and "__getattr__" not in vars(sys.modules["dalembert._checks"])


@pytest.mark.parametrize(
    "expression",
    [
        "SystemContainer().AddSystem().CreateSphericalJont",
        "SolveDinamic",
        "OutputVariableType.Postion",
        "graphics.color.redd",
    ],
)
def test_one_hint_only(expression: str) -> None:
    """The interpreter adds a hint of its own to errors that name the object and have none."""
    script = f"import dalembert as exu; exu.{expression}"
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert run.stderr.splitlines()[-1].lower().count("did you mean") == 1
