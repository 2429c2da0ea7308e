"""Files that cannot be written make the solution fail, and previous contents remain."""

from __future__ import annotations

import errno
import os
import resource
import stat
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from oscillators import Oscillator, Variable, dynamic_settings, oscillator

import dalembert as exu
from dalembert.itemInterface import NodePoint, ObjectMassPoint, SensorNode

FULL = "full.txt"  # a link to a device on which every write fails as on a full disk


@pytest.fixture(autouse=True)
def full_disk(in_empty_folder: None) -> None:
    Path(FULL).symlink_to("/dev/full")


@contextmanager
def limited_files(size: int) -> Iterator[None]:
    """Let no file of this process grow beyond so many bytes."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


def model(**sensor: Any) -> Oscillator:
    made = oscillator()
    if sensor:
        made.mbs.AddSensor(SensorNode(nodeNumber=made.node, outputVariableType=Variable.Coordinates, **sensor))
    made.mbs.Assemble()
    return made


def settings_of(steps: int = 10, **solution: Any) -> Any:
    settings = dynamic_settings(0.1 * steps, steps, tolerance=1e-10)
    for name, value in {"writeSolutionToFile": False, "solutionWritePeriod": 0, **solution}.items():
        setattr(settings.solutionSettings, name, value)
    return settings


def solution_to(name: str, **more: Any) -> dict[str, Any]:
    return {"writeSolutionToFile": True, "coordinatesSolutionFileName": name, **more}


# ---- numbers ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("digits", [1, 2, 6, 10, 15, 16, 17])
def test_numbers_are_rounded_as_by_printf(digits: int) -> None:
    """Of all sizes, halves between two texts, powers of ten and their neighbours: Python's own text of each."""
    rng = np.random.default_rng(digits)
    sized = rng.uniform(-1, 1, 3000) * 10.0 ** rng.integers(-60, 40, 3000)
    halves = rng.integers(-(10**6), 10**6, 3000) / 2.0 ** rng.integers(0, 24, 3000)
    powers = 10.0 ** np.arange(-50, 30)
    edges = np.concatenate(
        [powers, np.nextafter(powers, 0), np.nextafter(powers, np.inf), [5e-324, 1.7e308, 9.5, 99.5]]
    )
    shown = np.concatenate([sized, halves, edges, -edges, [0.0, 0.0]])
    shown = shown[: len(shown) // 3 * 3]
    mbs = exu.SystemContainer().AddSystem()
    for place in shown.reshape(-1, 3):
        node = mbs.AddNode(NodePoint(initialCoordinates=list(place)))
        mbs.AddObject(ObjectMassPoint(physicsMass=1, nodeNumber=node))
    mbs.Assemble()
    settings = settings_of(1, **solution_to("solution.txt", outputPrecision=digits, writeFileHeader=False))
    mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.ExplicitEuler)
    first = Path("solution.txt").read_text().split("\n")[0].split(",")
    assert first[1 : 1 + len(shown)] == [f"{x:.{digits}g}" for x in shown]


# ---- a disk that is full ----------------------------------------------------------------------------------------------

KINDS: dict[str, Callable[[], tuple[Oscillator, Any]]] = {
    "solution file": lambda: (model(), settings_of(**solution_to(FULL))),
    "solution file, binary": lambda: (model(), settings_of(**solution_to(FULL, binarySolutionFile=True))),
    "file of sensor 1": lambda: (model(fileName=FULL), settings_of()),
    "solver information file": lambda: (model(), settings_of(solverInformationFileName=FULL)),
    "restart file": lambda: (model(), settings_of(writeRestartFile=True, restartFileName=FULL)),
}


@pytest.mark.parametrize("kind", KINDS)
def test_a_full_disk_fails_the_solution(kind: str) -> None:
    made, settings = KINDS[kind]()
    settings.timeIntegration.verboseModeFile = 2 if "information" in kind else 0
    with pytest.raises(OSError, match=f"{kind.split(',')[0]} cannot be written.*: No space left on device") as caught:
        made.mbs.SolveDynamic(settings)
    assert caught.value.errno == errno.ENOSPC
    assert caught.value.filename == ("/dev/full" if kind == "restart file" else FULL)
    solver = made.mbs.sys["dynamicSolver"]
    assert not solver.output.finishedSuccessfully
    assert caught.value.filename in solver.GetErrorString() and "No space left" in solver.GetErrorString()
    assert Path(FULL).is_symlink() and stat.S_ISCHR(os.stat(FULL).st_mode)


def test_a_full_disk_fails_static_solutions_as_well() -> None:
    with pytest.raises(OSError, match=FULL):
        model().mbs.SolveStatic(settings_of(**solution_to(FULL)))


@pytest.mark.parametrize("early", [True, False])
def test_the_last_completed_step_stays(early: bool) -> None:
    """With flushing, the header fails already, as the first row shows: nothing has been computed then."""
    made = model()
    with pytest.raises(OSError, match="No space left"):
        made.mbs.SolveDynamic(settings_of(**solution_to(FULL, flushFilesImmediately=early)))
    whole = model()
    whole.mbs.SolveDynamic(settings_of())
    reached = made.mbs.systemData.GetTime()
    assert reached == pytest.approx(0.0 if early else 1.0)
    assert made.position == (whole.table()[0, 1] if early else whole.position)


def test_a_disk_that_fills_up_ends_at_the_step_that_did_not_fit() -> None:
    """Rows that fit are in the file; the state is that of the first one that did not."""
    made = model()
    with limited_files(2000), pytest.raises(OSError, match=r"rows\.txt") as caught:
        made.mbs.SolveDynamic(settings_of(1000, **solution_to("rows.txt", flushFilesImmediately=True)))
    assert caught.value.errno == errno.EFBIG
    assert Path("rows.txt").stat().st_size == 2000
    complete = [line for line in Path("rows.txt").read_text().splitlines()[:-1] if not line.startswith("#")]
    reached = made.mbs.systemData.GetTime()
    assert 0 < reached < 100
    assert reached == pytest.approx(0.1 * len(complete))
    whole = model()
    whole.mbs.SolveDynamic(settings_of(len(complete)))
    assert made.position == pytest.approx(whole.position, abs=1e-12)  # the times of steps differ by rounding


def test_a_solver_that_fails_reports_its_own_reason(capfd: pytest.CaptureFixture[str]) -> None:
    """The file that is not written besides is a warning."""
    made = model()
    settings = settings_of(**solution_to(FULL))
    settings.timeIntegration.adaptiveStep = False
    settings.timeIntegration.discontinuous.maxIterations = 1
    settings.timeIntegration.discontinuous.ignoreMaxIterations = False
    made.mbs.SetPostNewtonUserFunction(lambda mbs, t: [2, -1])  # an error that never becomes smaller
    with pytest.raises(ValueError, match="discontinuous"):
        made.mbs.SolveDynamic(settings)
    assert f"Warning: solution file '{FULL}' cannot be written" in capfd.readouterr().out


def test_an_exception_of_the_model_comes_first(capfd: pytest.CaptureFixture[str]) -> None:
    made = model()

    def stop(mbs: Any, t: float) -> bool:
        raise ArithmeticError("mine")

    made.mbs.SetPostStepUserFunction(stop)
    with pytest.raises(ArithmeticError, match="mine"):
        made.mbs.SolveDynamic(settings_of(**solution_to(FULL)))
    assert f"Warning: solution file '{FULL}' cannot be written" in capfd.readouterr().out


# ---- names that cannot be opened --------------------------------------------------------------------------------------

BAD_NAMES = {"folder.txt": errno.EISDIR, "file.txt/inside.txt": errno.ENOTDIR, "n" * 300 + ".txt": errno.ENAMETOOLONG}


@pytest.mark.parametrize("name", BAD_NAMES, ids=lambda name: name[:20])
@pytest.mark.parametrize("kind", ["solution", "sensor", "restart"])
def test_files_that_cannot_be_opened_are_reported_before_the_first_step(kind: str, name: str) -> None:
    Path("folder.txt").mkdir()
    Path("file.txt").write_text("")
    steps: list[float] = []
    made = model(**({"fileName": name} if kind == "sensor" else {}))
    made.mbs.SetPreStepUserFunction(lambda mbs, t: not steps.append(t))
    options = {"solution": solution_to(name), "restart": {"writeRestartFile": True, "restartFileName": name}}
    with pytest.raises(OSError, match="cannot be opened") as caught:
        made.mbs.SolveDynamic(settings_of(**options.get(kind, {})))
    assert caught.value.errno == BAD_NAMES[name]
    assert steps == []


def test_a_file_that_is_written_twice_gives_a_warning(capfd: pytest.CaptureFixture[str]) -> None:
    made = model(fileName="same.txt")
    made.mbs.SolveDynamic(settings_of(**solution_to("same.txt")))
    assert "Warning: file 'same.txt' is written twice" in capfd.readouterr().out


# ---- restart files ----------------------------------------------------------------------------------------------------


def restart_settings(name: str = "restart.txt", steps: int = 4, period: float = 0.1) -> Any:
    return settings_of(steps, writeRestartFile=True, restartFileName=name, restartWritePeriod=period)


def time_of(name: str) -> float:
    made = model()
    exu.MainSolverImplicitSecondOrder().ContinueFromRestartFile(made.mbs, name)
    return float(made.mbs.systemData.GetTime(exu.ConfigurationType.Initial))


def test_the_restart_file_before_is_kept() -> None:
    model().mbs.SolveDynamic(restart_settings())
    assert sorted(path.name for path in Path().iterdir()) == [FULL, "restart.txt", "restart.txt.bck"]
    assert time_of("restart.txt") == pytest.approx(0.4)
    assert time_of("restart.txt.bck") == pytest.approx(0.3)


def test_two_solutions_may_write_one_restart_file() -> None:
    """Outputs at the same time: the last one wins, none is disturbed, and nothing else is left."""
    models = [model() for _ in range(3)]
    with ThreadPoolExecutor(3) as pool:
        solved = list(pool.map(lambda made: made.mbs.SolveDynamic(restart_settings(steps=100, period=0)), models))
    assert solved == [True] * 3
    assert sorted(path.name for path in Path().iterdir()) == [FULL, "restart.txt", "restart.txt.bck"]
    assert time_of("restart.txt") == pytest.approx(10.0)


def test_the_last_good_restart_file_survives_a_full_disk() -> None:
    model().mbs.SolveDynamic(restart_settings())
    before = {path.name: path.read_bytes() for path in Path().glob("restart*")}
    with limited_files(50), pytest.raises(OSError, match="restart file cannot be written") as caught:
        model().mbs.SolveDynamic(restart_settings(steps=8))
    assert (caught.value.errno, caught.value.filename) == (errno.EFBIG, "restart.txt")
    assert {path.name: path.read_bytes() for path in Path().glob("restart*")} == before


def test_the_permissions_of_the_restart_file_stay() -> None:
    Path("restart.txt").write_text("")
    Path("restart.txt").chmod(0o640)
    model().mbs.SolveDynamic(restart_settings())
    assert stat.S_IMODE(Path("restart.txt").stat().st_mode) == 0o640


def test_a_link_to_the_restart_file_stays() -> None:
    Path("folder").mkdir()
    Path("restart.txt").symlink_to("folder/first.txt")
    Path("folder/first.txt").symlink_to("second.txt")
    model().mbs.SolveDynamic(restart_settings())
    assert Path("restart.txt").is_symlink() and Path("folder/first.txt").is_symlink()
    assert sorted(path.name for path in Path("folder").iterdir()) == ["first.txt", "second.txt", "second.txt.bck"]
    assert time_of("restart.txt") == pytest.approx(0.4)


def test_links_without_end_are_refused() -> None:
    Path("restart.txt").symlink_to("other.txt")
    Path("other.txt").symlink_to("restart.txt")
    with pytest.raises(OSError, match=r"restart\.txt") as caught:
        model().mbs.SolveDynamic(restart_settings())
    assert caught.value.errno == errno.ELOOP


def test_names_of_unfinished_files_follow_no_links() -> None:
    Path("precious.txt").write_text("precious")
    for i in range(3):
        Path(f"restart.txt.part{i}").symlink_to("precious.txt")
    model().mbs.SolveDynamic(restart_settings())
    assert Path("precious.txt").read_text() == "precious"
    assert time_of("restart.txt") == pytest.approx(0.4)


@pytest.mark.parametrize("make", [lambda path: path.mkdir(), lambda path: path.symlink_to("precious.txt")])
def test_devices_are_not_replaced_by_the_kept_file(make: Callable[[Path], None]) -> None:
    Path("precious.txt").write_text("precious")
    make(Path("restart.txt.bck"))
    with pytest.raises(OSError, match=r"restart\.txt\.bck"):
        model().mbs.SolveDynamic(restart_settings())
    assert Path("precious.txt").read_text() == "precious"
    assert Path("restart.txt.bck").is_symlink() or Path("restart.txt.bck").is_dir()


def test_a_pipe_is_written_to_and_never_replaced() -> None:
    os.mkfifo("pipe")
    received: list[bytes] = []

    def read() -> None:
        with open("pipe", "rb") as pipe:
            received.append(pipe.read())

    reader = threading.Thread(target=read)
    reader.start()
    model().mbs.SolveDynamic(restart_settings("pipe", steps=1))
    reader.join(timeout=10)
    assert stat.S_ISFIFO(os.stat("pipe").st_mode)
    assert received[0].startswith(b"#dalembert restart file")
    assert sorted(path.name for path in Path().iterdir()) == [FULL, "pipe"]


def test_damaged_restart_files_are_refused_with_the_line() -> None:
    model().mbs.SolveDynamic(restart_settings())
    text = Path("restart.txt").read_text()
    made = model()
    made.mbs.SolveDynamic(settings_of())
    before = made.mbs.systemData.GetSystemState(exu.ConfigurationType.Initial)
    digit = next(i for i in range(text.index("\nq "), len(text)) if text[i].isdigit())
    changed = text[:digit] + str((int(text[digit]) + 1) % 10) + text[digit + 1 :]
    for damaged in [*(text[:n] for n in range(len(text))), changed, text + "data 1\n"]:
        Path("damaged.txt").write_text(damaged)
        with pytest.raises(ValueError, match=r"restart file 'damaged\.txt', line \d+: expected .*damaged\.txt\.bck"):
            exu.MainSolverImplicitSecondOrder().ContinueFromRestartFile(made.mbs, "damaged.txt")
    for now, then in zip(made.mbs.systemData.GetSystemState(exu.ConfigurationType.Initial), before, strict=True):
        np.testing.assert_array_equal(now, then)
