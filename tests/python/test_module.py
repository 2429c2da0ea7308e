"""Functions of the module: printing, switches, versions."""

from __future__ import annotations

import re
from importlib import metadata
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert import _core


@pytest.fixture(autouse=True)
def switches() -> Any:
    yield
    exu.SetWriteToFile("", False)
    exu.config.printToConsole = True
    exu.config.outputPrecision = 6


def test_print_is_like_python(capsys: pytest.CaptureFixture[str]) -> None:
    exu.Print("a", 1, np.eye(1), sep="-", end="|\n", flush=True)
    exu.Print()
    assert capsys.readouterr().out == "a-1-[[1.]]|\n\n"
    with pytest.raises(TypeError, match="unknown argument 'separator'"):
        exu.Print("a", separator="-")


def test_print_to_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "folder" / "log.txt"
    exu.SetWriteToFile(str(file))
    exu.config.printToConsole = False
    exu.Print("one")
    assert exu.config.printToFile and exu.config.printFileName == str(file)
    exu.SetWriteToFile("", False)
    exu.Print("two")
    exu.SetWriteToFile(str(file), flagAppend=True, flagFlushAlways=True)
    exu.Print("three")
    assert file.read_text() == "one\nthree\n"
    assert capsys.readouterr().out == ""
    with pytest.raises(ValueError, match="parameter 'filename': is empty"):
        exu.SetWriteToFile("")
    with pytest.raises(IsADirectoryError, match="cannot be opened"):
        exu.SetWriteToFile(str(tmp_path))


def test_switches() -> None:
    exu.config.outputPrecision = 9
    assert "outputPrecision = 9" in repr(exu.config)
    with pytest.raises(ValueError, match="1 to 17 digits"):
        exu.config.outputPrecision = -3
    with pytest.raises(AttributeError):
        exu.config.printToFile = True
    with pytest.raises(AttributeError):
        exu.config.unknown = 1
    assert exu.special.solver.timeout == -1
    exu.special.solver.timeout = 3
    assert exu.special.solver.timeout == 3
    exu.special.solver.timeout = -1
    assert exu.special.InfoStat(False) == [0] * 7
    assert exu.special.exceptions.dictionaryVersionMismatch is True


def test_version_is_said_once() -> None:
    """CMake, the metadata and the module have that of _version.py, and no other file says it."""
    assert _core.__version__ == metadata.version("dalembert") == exu.__version__
    root = Path(__file__).parents[2]
    for name in ("CMakeLists.txt", "pyproject.toml", "CITATION.cff"):
        assert not re.search(rf"(?i)\bversion\W+{re.escape(exu.__version__)}\b", (root / name).read_text()), name


def test_versions_and_dictionaries(capsys: pytest.CaptureFixture[str]) -> None:
    assert exu.config.Version() == exu.GetVersionString() == exu.__version__
    assert exu.config.Version(addDetails=True).startswith(exu.__version__ + "; Python3.")
    assert exu.InvalidIndex() == -1
    exu.variables["x"] = 3
    assert exu.variables.pop("x") == 3 and isinstance(exu.sys, dict)
    exu.Help()
    assert "SystemContainer" in capsys.readouterr().out
    assert exu.StartRenderer() is False and exu.StopRenderer() is None
