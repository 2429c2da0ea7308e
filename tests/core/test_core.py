"""The C++ tests in this folder: each is a program that needs headers alone, and returns the number of its failures."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
PROGRAMS = sorted(HERE.glob("*.cpp"))
FLAGS = ["-std=c++20", "-O1", "-Wall", "-Wextra", "-Wno-restrict", "-Wno-psabi", "-Werror"]


@pytest.mark.parametrize("source", PROGRAMS, ids=lambda source: source.stem)
def test_program(source: Path, tmp_path: Path) -> None:
    compiler = os.environ.get("CXX") or shutil.which("g++") or shutil.which("clang++")
    assert compiler, "no C++ compiler; set CXX"
    program = tmp_path / source.stem
    includes = [f"-I{ROOT / folder}" for folder in ("core/include", "generated/include")]
    for command in ([compiler, *FLAGS, *includes, str(source), "-o", str(program)], [str(program)]):
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout + done.stderr


def test_there_are_programs() -> None:
    assert PROGRAMS
