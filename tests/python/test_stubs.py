"""The stubs agree with the package at run time, correct models pass mypy --strict, and mistakes are found."""

import ast
import enum
import inspect
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

import dalembert as exu
from dalembert import _core

pytest.importorskip("mypy")

ROOT = Path(__file__).parents[2]
PACKAGE = Path(exu.__file__).parent
CONFIG = """
[mypy]
strict = true
{path}
cache_dir = {cache}

[mypy-dalembert.*]
follow_imports = silent
"""
# stubtest imports the modules that it compares; the parts of the stub of the compiled module are no modules at run
# time.
STUBTEST = """
import enum, sys, types
import dalembert
from dalembert import _core
from mypy import stubtest

def module(name, *values):
    sys.modules[name] = types.ModuleType(name)
    vars(sys.modules[name]).update(values)

entries = list(vars(_core).items())
items = dalembert.itemInterface._classes
module("dalembert._core_enums", *(e for e in entries if isinstance(e[1], enum.EnumMeta)))
module("dalembert._core_items", *(e for e in entries if e[0] in items))
module(
    "dalembert._core_settings",
    *(e for e in entries if hasattr(e[1], "GetDictionaryWithTypeInfo") and e[1].__name__ == e[0] != "SettingsNames"),
)
submodules = {f"_core_{name}": value for name, value in entries if isinstance(value, types.ModuleType)}
sys.modules.update({f"dalembert.{name}": value for name, value in submodules.items()})
names = ("_core", "itemInterface", "_core_enums", "_core_items", "_core_settings", *submodules)
sys.exit(stubtest.test_stubs(stubtest.parse_options([*(f"dalembert.{name}" for name in names), *sys.argv[1:]])))
"""


@pytest.fixture(scope="module")
def config(tmp_path_factory) -> Path:
    """Settings of mypy for a user of the package that the tests run with, installed or in the source tree."""
    folder = tmp_path_factory.mktemp("mypy")
    # If the package is installed, mypy finds it, and rejects a path to it.
    installed = (PACKAGE / "_core_items.pyi").exists()
    path = "" if installed else f"mypy_path = {PACKAGE.parent}:{ROOT / 'generated/python'}"
    file = folder / "mypy.ini"
    file.write_text(CONFIG.format(path=path, cache=folder / "cache"))
    return file


def run_mypy(config: Path, *arguments: Path | str) -> str:
    command = [sys.executable, "-m", "mypy", "--config-file", str(config), "--hide-error-context", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False, cwd=config.parent).stdout


def test_a_typed_model_passes_strict_checks(config):
    assert run_mypy(config, ROOT / "tests/data/typed_model.py").startswith("Success")
    assert run_mypy(config, ROOT / "tests/data/typed_handles.py").startswith("Success")


FIRST_MODELS = (
    "ball_bearing", "boom_crane", "driven_four_bar", "identified_damper", "quarter_car", "timing_belt", "tip_mass",
    "two_link_arm",
)  # fmt: skip


def test_first_models_of_new_users_pass(config):
    """They have no annotations; arguments and outputs are checked, as editors do."""
    files = [ROOT / f"examples/{name}.py" for name in FIRST_MODELS]
    assert all(len(file.read_text().splitlines()) < 40 for file in files)
    assert run_mypy(config, "--allow-untyped-defs", "--ignore-missing-imports", *files).startswith("Success")


def test_misspelt_names_of_handles_are_found(config, tmp_path):
    file = tmp_path / "mistakes.py"
    file.write_text(
        "import dalembert as db\n"
        "model = db.Model()\n"
        'spring = model.create_spring_damper(body_numbers=["ground", "mass"], colour="red")\n'
        "spring.stifness = 3\n"
        'spring.stiffness = "3"\n'
        "model.create_rigid_bdy()\n"
        'print(model.create_mass_point(mass=1).position + "m")\n'
    )
    found = re.findall(r"\.py:(\d+): error: .*\[([\w-]+)\]$", run_mypy(config, file), re.MULTILINE)
    assert [int(line) for line, _ in found] == [3, 4, 5, 6, 7]


@pytest.mark.parametrize("name", ["typed_model", "typed_handles"])
def test_the_typed_model_runs(name, tmp_path):
    environment = os.environ | {"MPLBACKEND": "Agg", "PYTHONPATH": str(PACKAGE.parent)}
    command = [sys.executable, str(ROOT / f"tests/data/{name}.py")]
    result = subprocess.run(command, capture_output=True, text=True, check=False, cwd=tmp_path, env=environment)
    assert result.returncode == 0, result.stderr
    assert "iterations:" in result.stdout


def test_mistakes_in_a_model_are_found(config):
    file = ROOT / "tests/data/typed_model_with_mistakes.py"
    expected = [
        (number, line.rpartition("  # ")[2])
        for number, line in enumerate(file.read_text().splitlines(), 1)
        if "  # " in line
    ]
    output = run_mypy(config, file)
    found = re.findall(r"\.py:(\d+): error: .*\[([\w-]+)\]$", output, re.MULTILINE)
    assert len(expected) > 15
    assert list(dict.fromkeys((int(line), code) for line, code in found)) == expected, output


def test_stubtest_finds_no_difference(config):
    options = [
        "--concise",
        "--mypy-config-file",
        str(config),
        "--allowlist",
        str(ROOT / "tests/stubtest_allowlist.txt"),
    ]
    command = [sys.executable, "-c", STUBTEST, *options]
    environment = os.environ | {"PYTHONPATH": str(PACKAGE.parent)}
    result = subprocess.run(command, capture_output=True, text=True, check=False, cwd=config.parent, env=environment)
    assert result.returncode == 0, result.stdout + result.stderr


def test_type_information_is_installed():
    assert (PACKAGE / "py.typed").exists()


# ---- names and arguments of compiled methods: stubtest does not see the signatures of pybind11 -------------------------


def stub_classes() -> dict[str, dict[str, ast.stmt]]:
    """Methods and attributes by class, as the stubs written by hand have them, inherited ones included."""
    parts = ("_base", "_containers", "_system_data", "_solvers", "_general_contact", "_main_system", "")
    body = [node for part in parts for node in ast.parse((PACKAGE / f"_core{part}.pyi").read_text()).body]
    classes: dict[str, dict[str, ast.stmt]] = {}
    for node in (n for n in body if isinstance(n, ast.ClassDef)):
        members = classes[node.name] = {}
        for base in (b.id for b in node.bases if isinstance(b, ast.Name)):
            members.update(classes.get(base, {}))
        for child in node.body:
            if isinstance(child, ast.FunctionDef):
                members[child.name] = child
            elif isinstance(child, ast.AnnAssign) and isinstance(child.target, ast.Name):
                members[child.target.id] = child
            elif isinstance(child, ast.Assign) and isinstance(child.targets[0], ast.Name):
                members[child.targets[0].id] = child
    return classes


STUB = stub_classes()
BOUND = [name for name, value in vars(_core).items() if "pybind11" in type(value).__name__ and isinstance(value, type)]


@pytest.mark.parametrize("name", BOUND)
def test_stub_has_the_members_of_the_class(name):
    public = {member for member in vars(getattr(_core, name)) if not member.startswith("_")}
    assert public == {member for member in STUB[name] if not member.startswith("_")}


def described_arguments(docstring: str) -> list[str] | None:
    """Names of the arguments and their defaults in the first line of a docstring of pybind11; Return None if it is
    overloaded."""
    match = re.match(r"\w+\((.*)\) -> ", docstring.splitlines()[0])
    if match is None or "Overloaded function." in docstring:
        return None
    plain = re.sub(r"<(\w+\.\w+): \d+>", r"\1", match.group(1))
    while (shorter := re.sub(r": [^,=\[\]]*\[[^\[\]]*\][^,=\[\]]*", ": object", plain)) != plain:
        plain = shorter  # types in brackets contain commas
    return arguments_of(ast.parse(f"def f({plain.replace('dalembert::', '')}): ...").body[0])


def arguments_of(function: ast.stmt) -> list[str]:
    assert isinstance(function, ast.FunctionDef)
    arguments = function.args.posonlyargs + function.args.args + function.args.kwonlyargs
    names = [re.sub(r"^arg\d+$", "_", argument.arg) for argument in arguments]
    positional = len(function.args.posonlyargs)
    names[1:positional] = ["_"] * (positional - 1)
    return [*names, *(ast.unparse(value) for value in function.args.defaults)]


@pytest.mark.parametrize("name", BOUND)
def test_arguments_of_compiled_methods(name):
    for member, value in vars(getattr(_core, name)).items():
        if type(value).__name__ != "instancemethod" or member.startswith("_"):
            continue
        described = described_arguments(value.__doc__ or "")
        if described is not None:
            assert arguments_of(STUB[name][member]) == described, f"{name}.{member}"


def test_methods_of_main_system_written_in_python():
    methods = set(exu.mainSystemExtensions.methods)  # loads those that have not been used
    functions = {name for name, value in vars(exu.MainSystem).items() if inspect.isfunction(value)}
    # Two errors are of misspelt names; type checkers find them by themselves.
    attached = functions - {"__getattr__", "__setattr__"}
    assert attached == methods
    assert attached <= set(STUB["MainSystem"])


def test_every_submodule_is_known_to_type_checkers():
    tree = ast.parse((PACKAGE / "__init__.py").read_text())
    blocks = [n for n in tree.body if isinstance(n, ast.If) and ast.unparse(n.test) == "TYPE_CHECKING"]
    block = next(n for n in blocks if n.orelse)
    imported = {alias.asname for n in block.body if isinstance(n, ast.ImportFrom) for alias in n.names} - {"exudynCPP"}
    present = {name for name in exu._submodules if (PACKAGE / f"{name}.py").exists() or (PACKAGE / name).is_dir()}
    assert imported == present


def test_enumerations_that_are_flags_can_be_joined():
    for name, value in vars(_core).items():
        if isinstance(value, enum.EnumMeta):
            text = (PACKAGE / "_core_enums.pyi").read_text() if (PACKAGE / "_core_enums.pyi").exists() else ""
            base = "IntFlag" if issubclass(value, enum.IntFlag) else "IntEnum"
            assert not text or f"class {name}({base}):" in text
