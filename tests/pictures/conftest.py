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


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Say at the end of all tests, not only among those that were skipped, that no browser has seen the pages."""
    from browser import MISSING

    skipped = [report for report in terminalreporter.stats.get("skipped", []) if MISSING in str(report.longrepr)]
    if skipped:
        terminalreporter.section("pages were not tested", sep="!")
        terminalreporter.line(f"{len(skipped)} tests did not run: {MISSING}")
