"""Progress of long solutions: one line that is written over on a terminal, hardly any in a file, and nothing to go at the end."""

from __future__ import annotations

import os
import re
import subprocess
import sys

import pytest

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


def on_a_terminal() -> str:
    pty = pytest.importorskip("pty")
    main, side = pty.openpty()
    process = subprocess.Popen([sys.executable, "-c", MODEL], stdout=side, stderr=side, close_fds=True)
    os.close(side)
    text = b""
    while True:
        try:
            part = os.read(main, 4096)
        except OSError:  # the other side is closed
            break
        if not part:
            break
        text += part
    os.close(main)
    assert process.wait() == 0, text
    return text.decode().replace("\r\n", "\n")


def test_a_terminal_shows_one_line() -> None:
    lines = on_a_terminal().split("\n")
    (progress,) = (line for line in lines if "STEP" in line)
    passing, last = progress.split("\r")[1:-1], progress.split("\r")[-1]
    (first, *_) = (part for part in passing if part.strip())
    assert re.match(r"STEP\d+, t = 0\.\d+s \(\d+(\.\d)? %\), dt = 0\.0133\d*s, timeToGo = [\d.]+s$", first.rstrip())
    assert last.startswith("STEP75, t = 1s (100 %), dt = 0.0133") and "timeToGo" not in last


def test_a_file_has_the_last_line_alone() -> None:
    done = subprocess.run([sys.executable, "-c", MODEL], capture_output=True, text=True, check=True)
    assert "\r" not in done.stdout
    (line,) = (line for line in done.stdout.splitlines() if line.startswith("STEP"))
    assert "(100 %)" in line and "timeToGo" not in line
