"""install("exudyn"): models that import exudyn get dalembert, with all of its submodules."""

import importlib
import subprocess
import sys

import pytest

import dalembert
from dalembert import alias

NAME = "some_other_name"


@pytest.fixture(autouse=True)
def clean():
    yield
    alias.uninstall(NAME)


def test_package_and_submodules_are_the_same_objects():
    alias.install(NAME)
    assert importlib.import_module(NAME) is dalembert
    for submodule in ("utilities", "graphics", "itemInterface", "graphics._solids", "solver"):
        assert importlib.import_module(f"{NAME}.{submodule}") is importlib.import_module(f"dalembert.{submodule}")
    assert importlib.import_module(f"{NAME}.exudynCPP") is dalembert._core


def test_modules_keep_their_own_spec():
    alias.install(NAME)
    module = importlib.import_module(f"{NAME}.physics")
    assert module.__name__ == module.__spec__.name == "dalembert.physics"


def test_from_imports():
    alias.install(NAME)
    names = {}
    code = f"from {NAME}.itemInterface import NodePoint\nfrom {NAME} import graphics\nimport {NAME}.utilities as u"
    exec(code, names)
    assert names["graphics"] is dalembert.graphics and names["u"] is dalembert.utilities


def test_installing_again_is_no_harm():
    finders = len(sys.meta_path)
    alias.install(NAME)
    alias.install(NAME)
    assert len(sys.meta_path) == finders + 1
    alias.uninstall(NAME)
    alias.uninstall(NAME)
    assert len(sys.meta_path) == finders and NAME not in sys.modules


def test_unknown_submodules_are_not_found():
    alias.install(NAME)
    with pytest.raises(ModuleNotFoundError, match=f"{NAME}.nonsense"):
        importlib.import_module(f"{NAME}.nonsense")


def test_another_package_of_that_name_is_not_mixed_in():
    with pytest.raises(RuntimeError, match="'json'.*already"):
        importlib.import_module("json")
        alias.install("json")


def test_import_is_light():
    code = "import sys, dalembert; print([m for m in ('matplotlib', 'scipy', 'networkx') if m in sys.modules])"
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert result.stdout.strip() == "[]"
