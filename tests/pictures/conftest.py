"""What the tests of pictures share."""

from __future__ import annotations

from pathlib import Path

import pytest

import dalembert as exu


@pytest.fixture(autouse=True)
def in_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Pictures and solutions are written into the working folder."""
    monkeypatch.chdir(tmp_path)


@pytest.fixture
def SC() -> exu.SystemContainer:
    return exu.SystemContainer()


@pytest.fixture
def mbs(SC: exu.SystemContainer) -> exu.MainSystem:
    return SC.AddSystem()
