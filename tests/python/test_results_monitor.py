"""The monitor of results: files that grow, get shorter, come late, vanish, or are no results at all."""

from __future__ import annotations

import json
import math
import os
import threading
import time
from pathlib import Path
from typing import Any

import matplotlib.pyplot
import numpy as np
import pytest

import dalembert as exu
from dalembert import cli, resultsMonitor
from dalembert._io.growing_files import GrowingFile
from dalembert._live import opening
from dalembert._pictures import showing
from dalembert.processing import ParameterVariation
from dalembert.resultsMonitor import Monitor, Plots, thinned

SENSOR = b"#dalembert sensor output file\n#measure Node number = 0\n# OutputVariableType = Position\n# number of sensor values = 2\n"


@pytest.fixture(autouse=True)
def in_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Any:
    monkeypatch.chdir(tmp_path)
    yield
    matplotlib.pyplot.close("all")


def solved(binary: bool = False, **solution: Any) -> Path:
    """Write a solution of 51 rows with 1 + 9 columns."""
    mbs = exu.SystemContainer().AddSystem()
    mbs.CreateMassPoint(physicsMass=1, gravity=[1, -2, 0])
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = 50
    settings.solutionSettings.solutionWritePeriod = 0.02
    settings.solutionSettings.binarySolutionFile = binary
    for name, value in solution.items():
        setattr(settings.solutionSettings, name, value)
    mbs.SolveDynamic(settings)
    return Path("coordinatesSolution.sol" if binary else "coordinatesSolution.txt")


@pytest.mark.parametrize("step", [1, 7, 100, 10_000])
def test_a_text_that_comes_in_pieces_is_read_as_a_whole(step: int) -> None:
    whole = SENSOR + b"0,1,-2\r\n1e-3,nan,inf\n\n#a remark\n2e-3,3,4\n"
    file = GrowingFile("sensor.txt", [0, 2])
    with open("sensor.txt", "wb", buffering=0) as growing:
        for k in range(0, len(whole), step):
            growing.write(whole[k : k + step])
            assert file.look()
    assert file.column(0).tolist() == [0, 1e-3, 2e-3] and file.column(2).tolist() == [-2, math.inf, 4]
    assert file.names == ["time", "Position0", "Position1"] and (file.kind, file.state) == ("sensor", "3 rows")
    assert not file.look()


@pytest.mark.parametrize("binary", [False, True])
@pytest.mark.parametrize("step", [13, 500, 100_000])
def test_a_solution_that_comes_in_pieces(binary: bool, step: int) -> None:
    data = solved(binary).read_bytes()
    file, rows = GrowingFile("growing", [0, 2]), []
    with open("growing", "wb", buffering=0) as growing:
        for k in range(0, len(data), step):
            growing.write(data[k : k + step])
            file.look()
            rows.append(file.rows)
    assert rows == sorted(rows) and rows[-1] == 51 and file.state == "51 rows, finished"
    np.testing.assert_allclose(file.column(2), -(file.column(0) ** 2), atol=1e-12)
    assert file.names[:3] == (
        ["time", "ODE2Coordinates-0", "ODE2Coordinates-1"] if binary else ["time", "ODE2-0", "ODE2-1"]
    )


def test_files_are_shown_while_they_are_written() -> None:
    """If flushFilesImmediately is set, each row is in the file when the solver continues."""
    mbs = exu.SystemContainer().AddSystem()
    mbs.CreateMassPoint(physicsMass=1, gravity=[0, -2, 0])
    mbs.Assemble()
    file, seen = GrowingFile("coordinatesSolution.txt", [0]), []

    def look(mbs: Any, t: float) -> bool:
        file.look()
        seen.append((t, file.rows))
        return True

    mbs.SetPreStepUserFunction(look)
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = 10
    settings.solutionSettings.solutionWritePeriod = 0.1
    settings.solutionSettings.flushFilesImmediately = True
    mbs.SolveDynamic(settings)
    assert [rows for _, rows in seen] == list(range(1, 11)) and not file.finished
    assert file.look() and file.finished


@pytest.mark.parametrize("other", [b"0,9,9\n", b"0,9,9\n1,8,8\n2,9,9\n3,8,8\n", b"0,5,6\n1,7,9\n"])
def test_a_file_that_begins_anew_is_read_anew(other: bytes) -> None:
    """Shorter, longer, or of the same length."""
    Path("a.txt").write_bytes(b"0,5,6\n1,7,8\n")
    file = GrowingFile("a.txt", [0, 2])
    file.look()
    Path("a.txt").write_bytes(other)
    os.utime("a.txt", (1, 1))
    assert file.look()
    assert file.column(2).tolist() == [float(line.split(b",")[2]) for line in other.split()]


def test_a_file_that_was_cut_off_in_a_row() -> None:
    Path("a.txt").write_bytes(b"0,5\n1,6\n2,7\n")
    file = GrowingFile("a.txt", [1])
    file.look()
    os.truncate("a.txt", 9)
    assert file.look() and file.column(0 + 1).tolist() == [5, 6]
    with open("a.txt", "ab") as more:
        more.write(b",8\n")
    assert file.look() and file.column(1).tolist() == [5, 6, 8]


def test_a_file_that_comes_late_and_vanishes() -> None:
    file = GrowingFile("a.txt", [1])
    assert file.look() and file.state == "is not there"
    assert not file.look()
    Path("a.txt").touch()
    assert file.look() and file.state == "has no rows yet"
    Path("a.txt").write_text("0,1\n")
    assert file.look() and file.state == "1 rows"
    os.remove("a.txt")
    assert file.look() and file.state == "is not there" and file.rows == 1
    Path("a.txt").write_text("0,2\n1,3\n")
    assert file.look() and file.column(1).tolist() == [2, 3]


def test_lines_between_that_are_no_rows_are_counted() -> None:
    Path("a.txt").write_text("0,1\nnonsense\n1\n1,2,3\n1,2\n")
    file = GrowingFile("a.txt", [1])
    file.look()
    assert file.column(1).tolist() == [1, 2] and file.state == "2 rows; 3 lines were skipped"


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b'{"time": [0, 1]}\n', r"line 1: expected numbers with commas between them, received '{\"time\": \[0, 1\]}'"),
        (b"#a remark\ntime;x\n", "line 2: expected numbers"),
        (b"time,x\n0,1\n", "line 1: expected numbers"),
        (bytes(range(256)), "expected numbers"),
        (b"\x89PNG\r\n\x1a\n" + b"\0" * 100, "expected numbers"),
        (b"0\n1\n", "has columns 0 to 0, but not 1"),
        (b"0,\n1,2\n", "line 1: expected numbers"),
        (b"x" * (1 << 25), "it has no lines"),
        (b"EXUBIN" + bytes(100), "expected the sizes of numbers"),
    ],
)
def test_other_files_are_rejected(data: bytes, words: str) -> None:
    Path("a.txt").write_bytes(data)
    with pytest.raises(ValueError, match=words) as caught:
        Monitor("a.txt")
    assert "a.txt" in str(caught.value) and len(str(caught.value)) < 300


def test_a_binary_solution_that_is_damaged() -> None:
    path = solved(binary=True)
    data = path.read_bytes()
    file = GrowingFile(str(path), [0])
    row = 4 + 8 * 10
    start = data.rindex(b"\xff\xff\xff\xff") - 51 * row  # the end of the rows
    assert int.from_bytes(data[start : start + 4], "little") == 10  # numbers of the first row
    path.write_bytes(data[: start + 3 * row] + b"\1" + data[start + 3 * row + 1 :])
    with pytest.raises(ValueError, match="expected 10 numbers in row 3, received 1"):
        file.look()
    with pytest.raises(ValueError, match="has columns 0 to 9, but not 10"):
        Plots(str(solved(binary=True)), [0], [10])


# ---- figures


def drawn(monitor: Monitor) -> list[list[Any]]:
    return [[line.get_xydata().tolist() for line, _ in lines] for lines in monitor._lines]


def test_a_figure_follows_its_file() -> None:
    Path("a.txt").write_text("0,1,2\n1,3,4\n2,")  # the last line is being written
    monitor = Monitor("a.txt", ycols=[1, 2], addMarker=True, logy=True)
    assert drawn(monitor) == [[[[0, 1], [1, 3]]], [[[0, 2], [1, 4]]]]
    assert not monitor.update()
    with open("a.txt", "a") as more:
        more.write("5,6\n")
    assert monitor.update() and drawn(monitor)[1][0][-1] == [2, 6]
    assert monitor._lines[0][0][1].get_xydata().tolist() == [[2, 5]]
    assert monitor.figure.get_suptitle() == "a.txt: 3 rows"
    Path("a.txt").write_text("something else\n")
    assert monitor.update() and "expected numbers" in monitor.figure.get_suptitle()
    Path("a.txt").write_text("0,7,8\n")
    assert monitor.update() and drawn(monitor) == [[[[0, 7]]], [[[0, 8]]]]


def test_a_figure_of_a_file_that_comes_late() -> None:
    with pytest.raises(FileNotFoundError, match="there is no such file"):
        Monitor("a.txt")
    monitor = Monitor("a.txt", wait=True)
    assert drawn(monitor) == [[]] and monitor.figure.get_suptitle() == "a.txt: is not there"
    Path("a.txt").write_text("0,1\n")
    assert monitor.update() and drawn(monitor) == [[[[0, 1]]]]


def test_variations_are_curves_of_their_own() -> None:
    ParameterVariation(
        lambda p: p["a"] + 10 * p["b"] + 100 * p["c"], {"a": (0, 2, 3), "b": (0, 1, 2), "c": [0, 1]},
        useMultiProcessing=False, resultsFile="study.txt", showProgress=False,
    )  # fmt: skip
    plain = Monitor("study.txt", [2], [1])
    assert len(drawn(plain)[0]) == 1 and len(drawn(plain)[0][0]) == 12
    monitor = Monitor("study.txt", [2], [1], colorVariations=True)
    assert sorted(drawn(monitor)[0]) == [
        [[a, a + b + c] for a in (0, 1, 2)] for b, c in ((0, 0), (10, 0), (0, 100), (10, 100))
    ]
    labels = [line.get_label() for line, _ in monitor._lines[0]]
    assert labels == ["b = 0, c = 0", "b = 0, c = 1", "b = 1, c = 0", "b = 1, c = 1"]
    chosen = Monitor("study.txt", [2], [1], colorVariations=True, variations=(1, 3))
    assert [line.get_label() for line, _ in chosen._lines[0]] == labels[1:3]


def test_many_points_become_few_with_all_peaks() -> None:
    x = np.linspace(0, 1, 100_000)
    y = np.zeros_like(x)
    y[[12_345, 70_000]] = [5, -7]
    y[50_000] = math.inf
    a, b = thinned(x, y)
    assert len(a) == len(b) <= 2010 and {5.0, -7.0} <= set(b) and (a[0], a[-1]) == (0, 1)
    assert json.loads(json.dumps(thinned(np.array([0.0, math.nan]), np.array([math.inf, 1.0])))) == [
        [0, None],
        [None, 1],
    ]


# ---- the command


def test_errors_of_the_command(capsys: pytest.CaptureFixture[str]) -> None:
    Path("a.txt").write_text("0,1\n")
    for arguments, words in (
        (["none.txt"], "there is no such file in the folder"),
        (["a.txt"], "there is no display for a window"),
        (["a.txt", "-ycols", "3"], "has columns 0 to 1, but not 3"),
        (["a.txt", "-xcols", "0,1,0", "-ycols", "1,1"], "3 columns for x, but 2 for y"),
        (["a.txt", "-ycols", "second"], "invalid _columns value"),
    ):
        for command in (lambda a: cli.main(["monitor", *a]), resultsMonitor.main):
            with pytest.raises(SystemExit) as caught:
                command(arguments)
            assert caught.value.code == 2 and words in capsys.readouterr().err


def test_the_command_shows_a_window_until_it_is_closed(monkeypatch: pytest.MonkeyPatch) -> None:
    plt = matplotlib.pyplot
    Path("a.txt").write_text("0,1\n")
    looks: list[str] = []

    def pause(seconds: float) -> None:
        time.sleep(0.001)
        looks.append(plt.gcf().get_suptitle())
        if len(looks) == 1:
            Path("a.txt").write_text("0,1\n1,2\n")
        if looks[-1].endswith("2 rows") or len(looks) > 1000:
            plt.close("all")

    monkeypatch.setattr("matplotlib.get_backend", lambda: "TkAgg")
    monkeypatch.setattr(plt, "show", lambda block: None)
    monkeypatch.setattr(plt, "pause", pause)
    assert cli.main(["monitor", "a.txt", "-update", "0.01"]) == 0
    assert (looks[0], looks[-1]) == ("a.txt: 1 rows", "a.txt: 2 rows")


def test_the_command_opens_a_browser_and_ends_with_its_page(monkeypatch: pytest.MonkeyPatch) -> None:
    """A stand-in for the browser: a client that gets the curves, sees them grow, and leaves."""
    from websockets.sync.client import connect

    Path("a.txt").write_text("0,1\n")
    got: list[dict[str, Any]] = []

    def browse(address: str) -> None:
        text = Path(address.removeprefix("file://")).read_text()
        port, token = text.partition("127.0.0.1:")[2].partition('"')[0].split("/#")

        def follow() -> None:
            with connect(f"ws://127.0.0.1:{port}/socket", origin=f"http://127.0.0.1:{port}") as page:
                page.send(json.dumps({"kind": "hello", "token": token}))
                got.append(json.loads(page.recv(timeout=10)))
                Path("a.txt").write_text("0,1\n1,nan\n")
                got.append(json.loads(page.recv(timeout=10)))

        threading.Thread(target=follow, daemon=True).start()

    monkeypatch.setattr(showing, "has_display", lambda: True)
    monkeypatch.setattr(opening, "RETURN", 0.3)
    monkeypatch.setattr(opening.webbrowser, "open", browse)
    assert cli.main(["monitor", "a.txt", "-browser", "-update", "0.05", "-logy"]) == 0
    assert [message["state"] for message in got] == ["1 rows", "2 rows"]
    (plot,) = got[1]["plots"]
    assert plot["curves"] == [{"name": "", "x": [0, 1], "y": [1, None]}] and plot["logy"] and not plot["logx"]


def test_options_by_the_names_of_1_13() -> None:
    """Both releases' names of an option mean the same."""
    import argparse

    from dalembert import resultsMonitor

    parser = argparse.ArgumentParser()
    resultsMonitor.add_arguments(parser)
    old = (
        "a.txt -xcols 1 -ycols 2,3 -logx -logy -colorVariations -variations 0,2 -addMarker -sizex 3 -sizey 4 -update 2"
    )
    new = "a.txt -x 1 --y-cols 2,3 --log-x --log-y --color-variations --variations 0,2 --marker --size-x 3 --size-y 4 -u 2"
    assert vars(parser.parse_args(old.split())) == vars(parser.parse_args(new.split()))
    assert parser.parse_args(["a.txt", "--color", "r"]).color == "r"
