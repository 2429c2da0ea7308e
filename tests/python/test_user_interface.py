"""Switches of windows and variables of the environment, as automated runs set them."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

import dalembert as exu
from dalembert._tools import user_interface
from dalembert.basicUtilities import UIWindowSuppressed


@pytest.fixture
def switches() -> Iterator[user_interface.UserInterface]:
    yield exu.special.userInterface
    exu.special.userInterface.SuppressAll(False)


def test_switches(switches: user_interface.UserInterface, capsys: pytest.CaptureFixture[str]) -> None:
    user_interface._told.clear()
    assert not UIWindowSuppressed("Plots")
    switches.suppressPlots = True
    assert (
        UIWindowSuppressed("Plots", "PlotSensor") and UIWindowSuppressed("Plots") and not UIWindowSuppressed("Dialogs")
    )
    assert capsys.readouterr().out.splitlines() == [
        "PlotSensor: no window, as exu.special.userInterface.suppressPlots is set"
    ]
    switches.SuppressAll()
    assert repr(switches).count("True") == 4
    with pytest.raises(
        ValueError, match="kind: expected Renderer, SolutionViewer, Plots or Dialogs, received 'Window'"
    ):
        UIWindowSuppressed("Window")
    with pytest.raises(AttributeError):
        switches.suppressPlot = True  # type: ignore[attr-defined]


def test_no_viewer_opens(switches: user_interface.UserInterface, monkeypatch: pytest.MonkeyPatch) -> None:
    from dalembert._pictures import showing

    for name in ("CI", "PYTEST_CURRENT_TEST"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("DALEMBERT_VIEWER", "on")
    assert showing.where_pages_open() == "address"
    switches.suppressRenderer = True
    assert showing.where_pages_open() == "nowhere"
    assert exu.SystemContainer().renderer.Start() is False


def test_no_solution_is_needed_where_viewers_are_suppressed(switches: user_interface.UserInterface) -> None:
    mbs = exu.SystemContainer().AddSystem()
    with pytest.raises(ValueError, match="no simulation has been run yet"):
        mbs.SolutionViewer()
    switches.suppressSolutionViewer = True
    mbs.SolutionViewer()


def run(script: str, folder: Path, **environment: str) -> str:
    return subprocess.run(
        [sys.executable, "-c", script],
        capture_output=True,
        text=True,
        check=True,
        cwd=folder,
        env=os.environ | environment,
    ).stdout


def test_variables_of_the_environment(tmp_path: Path) -> None:
    script = """
import dalembert as exu
from dalembert.utilities import *
mbs = exu.SystemContainer().AddSystem()
mbs.CreateMassPoint(physicsMass=1)
mbs.Assemble()
mbs.SolveDynamic(exu.SimulationSettings())
print(exu.special.userInterface)
"""
    out = run(script, tmp_path, EXUDYN_OUTPUTDIRECTORY="results", EXUDYN_SUPPRESS_UI_WINDOW_OPEN="1")
    assert out.splitlines()[-1].count("True") == 4
    assert [file.name for file in (tmp_path / "results").iterdir()] == ["coordinatesSolution.txt"]


def test_simulations_are_stopped_and_views_restored() -> None:
    container = exu.SystemContainer()
    mbs = container.AddSystem()
    mbs.CreateMassPoint(physicsMass=1, initialVelocity=[1, 0, 0])

    def stop(mbs: exu.MainSystem, t: float) -> bool:
        if t > 0.495:
            container.renderer.StopSimulation()
            time.sleep(0.05)  # solvers look at this flag a few times per second
        return True

    mbs.SetPreStepUserFunction(stop)
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    settings.timeIntegration.numberOfSteps = 100
    mbs.SolveDynamic(settings)
    assert 0.495 < mbs.systemData.GetTime() < 0.65
    exu.sys.pop("renderState", None)
    assert container.renderer.RestoreSavedState() is False
    exu.sys["renderState"] = {"zoom": 3.0}
    try:
        assert container.renderer.RestoreSavedState() is True
        assert container.renderer.GetState()["zoom"] == 3.0
    finally:
        del exu.sys["renderState"]


@pytest.mark.parametrize("module", ["basicUtilities", "advancedUtilities"])
def test_names_that_release_1_13_has_moved(module: str) -> None:
    """They are in these modules there, and in utilities before."""
    package = getattr(exu, module)
    for name in package._IN_UTILITIES:
        assert getattr(package, name) is getattr(exu.utilities, name)
    with pytest.raises(AttributeError, match="has no attribute 'LoadSolution'"):
        package.LoadSolution  # noqa: B018
