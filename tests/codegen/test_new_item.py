"""`python -m codegen new` starts an item that passes the generator at once, and whose files compile."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from codegen.__main__ import main
from codegen.load import load

CASES = [
    ("node", "Spin", "nodes", "NodeSpin", "spin"),
    ("object", "Top", "bodies", "ObjectTop", "top"),
    ("object", "ObjectConnectorRope2D", "connectors", "ObjectConnectorRope2D", "rope_2d"),
    ("object", "JointUniversal", "joints", "ObjectJointUniversal", "universal"),
    ("object", "Shell", "finite_elements", "ObjectShell", "shell"),
    ("marker", "BodyEdge", "markers", "MarkerBodyEdge", "body_edge"),
    ("load", "Wind", "loads", "LoadWind", "wind"),
    ("sensor", "Energy", "sensors", "SensorEnergy", "energy"),
]


@pytest.mark.parametrize(("kind", "name", "folder", "full", "stem"), CASES, ids=[case[3] for case in CASES])
def test_new_item(copy: Path, root: Path, kind: str, name: str, folder: str, full: str, stem: str) -> None:
    assert main(["--root", str(copy), "new", kind, name, "--folder", folder]) == 0
    item = next(item for item in load(copy).items if item.name == full)
    assert (item.stem, item.physics, item.kind) == (f"{folder}/{stem}", "planned", kind)
    assert main(["--root", str(copy)]) == 0
    assert main(["--root", str(copy), "--check"]) == 0
    sources = [copy / f"generated/src/{folder}/{stem}.cpp"]
    if kind != "sensor":
        kernel = copy / f"core/include/dalembert/items/{folder}/{stem}.hpp"
        assert kernel.read_text().startswith(f"// {full}, specs/{folder}/{stem}.toml\n")
        (copy / "kernel.cpp").write_text(f'#include "dalembert/items/{folder}/{stem}.hpp"\n')
        sources.append(copy / "kernel.cpp")
    compile_all(sources, copy, root)


def compile_all(sources: list[Path], copy: Path, root: Path) -> None:
    compiler = shutil.which("g++") or shutil.which("clang++")
    if compiler is None:
        pytest.skip("no C++ compiler")
    includes = [f"-I{root}/core/include", f"-I{copy}/generated/include", f"-I{copy}/core/include"]
    flags = ["-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror"]
    done = subprocess.run(
        [compiler, *flags, *includes, *map(str, sources)], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr


def test_existing_files_are_never_touched(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = (copy / "specs/bodies/mass_point.toml").read_text()
    assert main(["--root", str(copy), "new", "object", "MassPoint"]) == 1
    assert "specs/bodies/mass_point.toml: exists already" in capsys.readouterr().err
    assert (copy / "specs/bodies/mass_point.toml").read_text() == before


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            ["object", "Top", "--folder", "boddies"],
            "--folder: no folder 'boddies' of object items; did you mean 'bodies'?",
        ),
        (["load", "Wind", "--folder", "bodies"], "--folder: no folder 'bodies' of load items; known are loads"),
        (["object", "my top"], "name: 'my top' does not make the name of an item"),
        (["object", "Object"], "name: 'Object' does not make the name of an item"),
    ],
)
def test_refused(copy: Path, capsys: pytest.CaptureFixture[str], arguments: list[str], message: str) -> None:
    assert main(["--root", str(copy), "new", *arguments]) == 1
    assert capsys.readouterr().err.strip() == message
