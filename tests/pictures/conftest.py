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
    """Say at the end of all tests, not only among those that were skipped, what nobody has looked at."""
    import browser
    import test_exports

    for what, missing in (("pages", browser.MISSING), ("files of glTF", test_exports.MISSING)):
        skipped = [report for report in terminalreporter.stats.get("skipped", []) if missing in str(report.longrepr)]
        if skipped:
            terminalreporter.section(f"{what} were not tested", sep="!")
            terminalreporter.line(f"{len(skipped)} tests did not run: {missing}")
