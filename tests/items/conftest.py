"""Shared fixtures of the tests of items."""

from __future__ import annotations

from pathlib import Path

import pytest

import dalembert as exu


@pytest.fixture(autouse=True)
def in_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Solvers write their files into the working folder."""
    monkeypatch.chdir(tmp_path)


@pytest.fixture
def mbs() -> exu.MainSystem:
    return exu.SystemContainer().AddSystem()
