"""Shared fixtures of the tests of solvers."""

from __future__ import annotations

from pathlib import Path

import pytest


@pytest.fixture(autouse=True)
def in_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Solvers write their files into the working folder."""
    monkeypatch.chdir(tmp_path)
