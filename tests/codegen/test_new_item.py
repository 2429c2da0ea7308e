"""`python -m codegen new` starts an item of each kind that passes the generator at once, and whose files compile."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest
from repositories import bare_repository

from codegen.__main__ import main
from codegen.load import load
from codegen.new_item import KINDS

CASES = [
    ("node", "Spin", "nodes", "NodeSpin", "spin"),
    ("body", "Top", "bodies", "ObjectTop", "top"),
    ("super_element", "Truss", "super_elements", "ObjectTruss", "truss"),
    ("finite_element", "ObjectShell", "finite_elements", "ObjectShell", "shell"),
    ("connector", "ObjectConnectorRope2D", "connectors", "ObjectConnectorRope2D", "rope_2d"),
    ("contact", "Pads", "contacts", "ObjectContactPads", "pads"),
    ("constraint", "Gear", "constraints", "ObjectConnectorGear", "gear"),
    ("joint", "JointUniversal", "joints", "ObjectJointUniversal", "universal"),
    ("marker", "BodyEdge", "markers", "MarkerBodyEdge", "body_edge"),
    ("load", "Wind", "loads", "LoadWind", "wind"),
    ("sensor", "Energy", "sensors", "SensorEnergy", "energy"),
]


def test_every_kind_is_tested() -> None:
    assert [kind for kind, *_ in CASES] == list(KINDS)


@pytest.fixture(scope="module")
def with_new_items(root: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A repository with a new item of each kind, and all that is generated."""
    copy = bare_repository(root, tmp_path_factory.mktemp("new"))
    for kind, name, *_ in CASES:
        assert main(["--root", str(copy), "new", kind, name]) == 0
    assert main(["--root", str(copy)]) == 0
    assert main(["--root", str(copy), "--check"]) == 0
    return copy


@pytest.mark.parametrize(("kind", "name", "folder", "full", "stem"), CASES, ids=[case[3] for case in CASES])
def test_new_item(with_new_items: Path, root: Path, kind: str, name: str, folder: str, full: str, stem: str) -> None:
    """The spec passes, the kernel fits its contract, and the generated files compile."""
    item = next(item for item in load(with_new_items).items if item.name == full)
    assert (item.stem, item.physics) == (f"{folder}/{stem}", "ready")
    kernel = f"dalembert/items/{folder}/{stem}.hpp"
    assert (with_new_items / "core/include" / kernel).read_text().startswith(f"// {full}, specs/{folder}/{stem}.toml\n")
    generated = with_new_items / f"generated/src/{folder}/{stem}.cpp"
    both = with_new_items / f"{stem}.cpp"  # the kernel first: it includes everything it needs
    both.write_text(f'#include "{kernel}"\n#include "{generated}"\n')
    check_syntax(both, with_new_items, root)


def check_syntax(source: Path, copy: Path, root: Path) -> None:
    compiler = shutil.which("g++") or shutil.which("clang++")
    if compiler is None:
        pytest.skip("no C++ compiler")
    includes = [f"-I{root}/core/include", f"-I{copy}/generated/include", f"-I{copy}/core/include"]
    flags = ["-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror"]
    done = subprocess.run([compiler, *flags, *includes, str(source)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_existing_files_are_never_touched(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = (copy / "specs/bodies/mass_point.toml").read_text()
    assert main(["--root", str(copy), "new", "body", "MassPoint"]) == 1
    assert "specs/bodies/mass_point.toml: exists already" in capsys.readouterr().err
    assert (copy / "specs/bodies/mass_point.toml").read_text() == before


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["body", "my top"], "name: 'my top' does not make the name of an item"),
        (["body", "Object"], "name: 'Object' does not make the name of an item"),
        (["joint", "Joint"], "name: 'Joint' does not make the name of an item"),
    ],
)
def test_refused(copy: Path, capsys: pytest.CaptureFixture[str], arguments: list[str], message: str) -> None:
    assert main(["--root", str(copy), "new", *arguments]) == 1
    assert capsys.readouterr().err.strip() == message
