"""What the pages and the README show works: examples run, error texts are the real ones, the example item is complete."""

from __future__ import annotations

import doctest
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from codegen.load import load

ROOT = Path(__file__).parents[2]
EXAMPLES = sorted((ROOT / "examples").glob("*.py"))


@pytest.mark.parametrize("path", EXAMPLES, ids=[path.stem for path in EXAMPLES])
def test_example_runs_and_writes_its_plots(path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MPLBACKEND", "Agg")
    done = subprocess.run([sys.executable, str(path)], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    wanted = set(re.findall(r'fileName="(\w+\.png)"', path.read_text()))
    assert wanted and wanted == {plot.name for plot in tmp_path.glob("*.png")}


def test_readme_shows_the_first_example() -> None:
    (shown,) = re.findall(r"```python\n(.*?)```", (ROOT / "README.md").read_text(), re.DOTALL)
    assert (ROOT / "examples/first_model.py").read_text().endswith("\n\n" + shown)


def test_errors_page_shows_the_real_texts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    failed, tried = doctest.testfile(str(ROOT / "docs/tutorial/errors.rst"), module_relative=False)
    assert tried > 20 and failed == 0


def test_the_example_of_a_new_item_is_complete(tmp_path: Path) -> None:
    shutil.copytree(ROOT / "specs", tmp_path / "specs")
    shutil.copy(ROOT / "docs/developer/hertz_spring.toml", tmp_path / "specs/connectors")
    item = next(item for item in load(tmp_path).items if item.stem == "connectors/hertz_spring")
    kernel = (ROOT / "docs/developer/hertz_spring.hpp").read_text()
    assert kernel.startswith(f"// {item.name}, {item.path}\n")
    assert f"struct {item.name} " in kernel
