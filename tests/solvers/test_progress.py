"""Progress of long solutions: a line that is overwritten on a terminal, few in a file, and no remainder at the end."""

from __future__ import annotations

import contextlib
import os
import re
import subprocess
import sys

import pytest

import dalembert as exu

MODEL = """
import time
import dalembert as exu

mbs = exu.SystemContainer().AddSystem()
mbs.CreateMassPoint(physicsMass=1, gravity=[0, 0, -9.81])
mbs.Assemble()
mbs.SetPreStepUserFunction(lambda mbs, t: time.sleep(0.06) or True)
settings = exu.SimulationSettings()
settings.timeIntegration.numberOfSteps = 75
settings.timeIntegration.stepInformation = 1 + 16
settings.timeIntegration.verboseMode = 1
settings.solutionSettings.writeSolutionToFile = False
mbs.SolveDynamic(settings)
"""


@pytest.mark.parametrize("automatic", [True, False])
def test_steps_smaller_than_the_largest_are_reported(automatic: bool, capfd: pytest.CaptureFixture[str]) -> None:
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    mass = mbs.CreateMassPoint(referencePosition=[1, 0, 0], physicsMass=1, gravity=[0, 0, -9.81])
    mbs.CreateSpringDamper(bodyNumbers=[ground, mass], stiffness=100)
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    time = settings.timeIntegration
    time.numberOfSteps, time.verboseMode, time.automaticStepSize, time.initialStepSize = 20, 2, automatic, 1e-3
    mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.DOPRI5)
    lines = [line for line in capfd.readouterr().out.splitlines() if line.startswith("STEP") and "%" in line]
    told = [", dt = " in line for line in lines]
    assert len(lines) > 10 and not told[-1]  # the end is complete
    assert all(told[1:-1]) if automatic else not any(told)


def start(**streams: int) -> subprocess.Popen[bytes]:
    return subprocess.Popen([sys.executable, "-c", MODEL], close_fds=True, **streams)


def shown_on(main: int) -> str:
    """All that comes to a terminal until its other side is closed."""
    text = b""
    with contextlib.suppress(OSError):
        while part := os.read(main, 4096):
            text += part
    os.close(main)
    return text.decode().replace("\r\n", "\n")


def outputs() -> tuple[str, str]:
    """Output on a terminal and in a file; both solutions, at the same time, take some seconds, most of which they
    sleep."""
    pty = pytest.importorskip("pty")
    main, side = pty.openpty()
    of_file, of_terminal = start(stdout=subprocess.PIPE), start(stdout=side, stderr=side)
    os.close(side)
    on_terminal, in_file = shown_on(main), of_file.communicate()[0].decode()
    assert of_terminal.wait() == of_file.returncode == 0, on_terminal + in_file
    return on_terminal, in_file


def test_a_terminal_shows_one_line_and_a_file_has_the_last_alone() -> None:
    on_terminal, in_file = outputs()
    (progress,) = (line for line in on_terminal.split("\n") if "STEP" in line)
    passing, last = progress.split("\r")[1:-1], progress.split("\r")[-1]
    (first, *_) = (part for part in passing if part.strip())
    assert re.match(r"STEP\d+, t = 0\.\d+s \(\d+(\.\d)? %\), dt = 0\.0133\d*s, timeToGo = [\d.]+s$", first.rstrip())
    assert last.startswith("STEP75, t = 1s (100 %), dt = 0.0133") and "timeToGo" not in last

    assert "\r" not in in_file
    (line,) = (line for line in in_file.splitlines() if line.startswith("STEP"))
    assert "(100 %)" in line and "timeToGo" not in line


TALKATIVE = """
import sys
import dalembert as exu

mbs = exu.SystemContainer().AddSystem()
mbs.CreateMassPoint(physicsMass=1, gravity=[0, 0, -9.81])
mbs.Assemble()
settings = exu.SimulationSettings()
settings.timeIntegration.numberOfSteps = 2000
settings.timeIntegration.verboseMode = 2
settings.solutionSettings.writeSolutionToFile = False
mbs.SolveDynamic(settings)
print(mbs.systemData.GetTime(), file=sys.stderr)
exu.Print("more than anybody reads")
print("also what is left in a buffer")
"""


def test_a_reader_that_has_seen_enough_ends_no_solution() -> None:
    """Test of `python model.py | head -1`: the solution goes on to its end, files and all, and nothing is said."""
    with subprocess.Popen(
        [sys.executable, "-c", TALKATIVE], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as run:
        assert run.stdout is not None and run.stderr is not None
        assert run.stdout.readline()
        run.stdout.close()
        assert run.stderr.read() == "1.0\n"
    assert run.returncode == 0


def test_other_errors_of_the_output_stream_are_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    class Full:
        def write(self, text: str) -> None:
            raise OSError("no space is left")

    monkeypatch.setattr(sys, "stdout", Full())
    with pytest.raises(OSError, match="no space is left"):
        exu.Print("something")
