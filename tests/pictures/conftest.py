"""Shared fixtures of the tests of pictures."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import dalembert as exu
from dalembert import graphics
from dalembert._live.viewer import Viewer, viewer_of
from dalembert.utilities import InertiaCuboid


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


@pytest.fixture
def swinging(mbs: Any) -> Any:
    """A brick that swings below a spring."""
    ground = mbs.CreateGround()
    body = mbs.CreateRigidBody(
        name="brick", referencePosition=[1, 0, 0], inertia=InertiaCuboid(1000, [0.4, 0.2, 0.1]), gravity=[0, -9.81, 0],
        graphicsDataList=[graphics.Brick(size=[0.4, 0.2, 0.1], color=graphics.color.orange)],
    )  # fmt: skip
    mbs.CreateSpringDamper(bodyNumbers=[ground, body], stiffness=1000, damping=1)
    mbs.Assemble()
    return mbs


@pytest.fixture
def viewer(SC: Any, swinging: Any, monkeypatch: pytest.MonkeyPatch) -> Iterator[Viewer]:
    monkeypatch.setenv("DALEMBERT_VIEWER", "on")
    assert SC.renderer.Start()
    found = viewer_of(SC)
    assert found is not None
    yield found
    SC.renderer.Stop()
    assert viewer_of(SC) is None and not SC.renderer.IsActive()


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Report at the end of all tests, not only in the list of skipped ones, which pictures were not compared."""
    import browser
    import test_exports

    for what, missing in (("pages", browser.MISSING), ("files of glTF", test_exports.MISSING)):
        skipped = [report for report in terminalreporter.stats.get("skipped", []) if missing in str(report.longrepr)]
        if skipped:
            terminalreporter.section(f"{what} were not tested", sep="!")
            terminalreporter.line(f"{len(skipped)} tests did not run: {missing}")
