"""Files that are damaged or incomplete are refused, with the place; errors of output files have their names."""

from __future__ import annotations

import errno
import resource
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert import advancedUtilities, graphics, plot, utilities
from dalembert.itemInterface import SensorNode
from dalembert.processing import WriteToFile

NAMES = ("solution.txt", "solution.sol", "sensor.txt")


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    """Files of a short simulation."""
    folder = tmp_path_factory.mktemp("files")
    mbs = exu.SystemContainer().AddSystem()
    body = mbs.CreateMassPoint(referencePosition=[1, 2, 3], physicsMass=1, initialVelocity=[1 / 3, 1 / 7, 1e-5])
    node = mbs.GetObject(body)["nodeNumber"]
    mbs.AddSensor(
        SensorNode(
            nodeNumber=node,
            fileName=str(folder / "sensor.txt"),
            outputVariableType=exu.OutputVariableType.Position,
        )
    )
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = 5
    settings.timeIntegration.verboseMode = 0
    settings.solutionSettings.solutionWritePeriod = settings.solutionSettings.sensorsWritePeriod = 0.2
    settings.solutionSettings.writeFileFooter = False
    for name in NAMES[:2]:
        settings.solutionSettings.coordinatesSolutionFileName = str(folder / name)
        settings.solutionSettings.binarySolutionFile = name.endswith(".sol")
        mbs.SolveDynamic(settings)
    return {name: (folder / name).read_bytes() for name in NAMES}


@pytest.fixture(autouse=True)
def in_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def rows_of(name: str, content: bytes, **options: Any) -> np.ndarray:
    Path(name).write_bytes(content)
    return np.asarray(utilities.LoadSolutionFile(name, verbose=False, **options)["data"])


@pytest.mark.parametrize("name", NAMES[:2])
@pytest.mark.parametrize("safe", [False, True])
def test_a_solution_that_ends_early_gives_its_rows_or_is_refused(
    files: dict[str, bytes], name: str, safe: bool
) -> None:
    """Wherever it ends: the data read are identical, digit for digit."""
    content = files[name]
    whole = rows_of(name, content)
    assert whole.shape == (6, 10)
    lengths = set()
    for end in range(len(content)):
        try:
            rows = rows_of(name, content[:end], safeMode=safe)
        except ValueError as error:
            assert name in str(error)
            continue
        assert np.array_equal(rows, whole[: len(rows)])
        lengths.add(len(rows))
    assert lengths >= {1, 2, 3, 4, 5}


@pytest.mark.parametrize("safe", [False, True])
@pytest.mark.parametrize("limit", [-1, 4])
def test_a_damaged_row_is_refused_with_its_line(files: dict[str, bytes], safe: bool, limit: int) -> None:
    lines = files["solution.txt"].decode().splitlines(keepends=True)
    first = next(i for i, line in enumerate(lines) if not line.startswith("#"))
    for damage in ("0.4,1,2\n", "0.4," + "x," * 8 + "1\n", "\x00\xff\n"):
        content = "".join([*lines[: first + 2], damage, *lines[first + 3 :]]).encode("latin-1")
        if safe:
            assert len(rows_of("solution.txt", content, safeMode=True, maxRows=limit)) == (4 if limit == 4 else 5)
        else:
            with pytest.raises(ValueError, match=rf"solution\.txt, line {first + 3}: expected 10 numbers"):
                rows_of("solution.txt", content, maxRows=limit)


@pytest.mark.parametrize(
    ("at", "value", "message"),
    [
        (7, b"\x03", "byte 6: expected the sizes of numbers"),
        (16, b"\xff\xff\xff\x7f", "byte 16: the file ends inside of the header"),
        (5, b"\x0b", r"byte \d+: row 5: expected 10 numbers, it has 11 numbers"),
        (5, b"\xf0\xff\xff\xff", r"byte \d+: row 5: expected 10 numbers, it has -16 numbers"),
    ],
)
def test_a_damaged_binary_file_is_refused_with_the_byte(
    files: dict[str, bytes], at: int, value: bytes, message: str
) -> None:
    """Places up to 5 are rows: a length and ten numbers, of as many bytes as byte 8 says."""
    content = bytearray(files["solution.sol"])
    at = len(content) - (6 - at) * (4 + 10 * content[8]) if at < 6 else at
    content[at : at + len(value)] = value
    with pytest.raises(ValueError, match=rf"solution\.sol, {message}"):
        rows_of("solution.sol", bytes(content))


def test_sensor_files_that_end_early_are_refused(files: dict[str, bytes]) -> None:
    content = files["sensor.txt"]
    Path("sensor.txt").write_bytes(content)
    whole = plot.PlotSensor(None, "sensor.txt", closeAll=True)[3][0].get_ydata()
    start = content.rindex(b"#\n") + 2
    for end in range(start + 1, len(content)):
        Path("sensor.txt").write_bytes(content[:end])
        if content[end - 1 : end] == b"\n":
            drawn = plot.PlotSensor(None, "sensor.txt", closeAll=True)[3][0].get_ydata()
            assert np.array_equal(drawn, whole[: content[start:end].count(b"\n")])
        else:
            with pytest.raises(
                ValueError, match=rf"sensor\.txt, line {content[:end].count(10) + 1}: the file ends inside"
            ):
                plot.PlotSensor(None, "sensor.txt", closeAll=True)
    Path("sensor.txt").write_bytes(content[:start] + b"0,1,2,3\n0.2,1,2\n")
    with pytest.raises(
        ValueError, match=r"sensor\.txt, line \d+: expected 4 numbers separated by ',', received '0\.2,1,2'"
    ):
        plot.PlotSensor(None, "sensor.txt", closeAll=True)


def test_text_images_with_damaged_numbers_are_refused() -> None:
    for damage in ("0,0", "0,0,x", ""):
        Path("image.txt").write_text(f"#text image export file\n#LINE\n0,0,0,1,0,0\n#LINE\n{damage}\n#END\n")
        with pytest.raises(ValueError, match=r"image\.txt, line 5: expected numbers separated by ',', 3 or a multiple"):
            plot.LoadImage("image.txt")


def test_a_file_is_not_repaired_onto_itself(files: dict[str, bytes]) -> None:
    Path("solution.txt").write_bytes(files["solution.txt"])
    Path("link.txt").symlink_to("solution.txt")
    for function in (utilities.RecoverSolutionFile, plot.FileStripSpaces):
        with pytest.raises(ValueError, match="newFileName|must differ"):
            function("solution.txt", "link.txt")
    assert Path("solution.txt").read_bytes() == files["solution.txt"]


# ---- output errors
# -----------------------------------------------------------------------------------------------------


@contextmanager
def limited_files() -> Iterator[None]:
    """No file grows beyond 64 bytes, and nothing is printed: the console may be a file."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    exu.config.printToConsole = False
    resource.setrlimit(resource.RLIMIT_FSIZE, (64, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
        exu.config.printToConsole = True


def save_figure(name: str) -> None:
    import matplotlib.pyplot as plt

    from dalembert._plots.images import save_figure as save

    figure = plt.figure()
    try:
        save(figure, name, "PlotSensor")
    finally:
        plt.close(figure)


def print_to(name: str) -> None:
    exu.SetWriteToFile(name)
    try:
        for _ in range(20):
            exu.Print("some words")
    finally:
        exu.SetWriteToFile("", False)


WRITERS = {
    "results.txt": lambda name: WriteToFile(name, {"a": (0, 1, 99)}, [{"a": i} for i in range(99)], range(99), 0, True),
    "solid.stl": lambda name: graphics.ExportSTL(graphics.Sphere(), name),
    "stripped.txt": lambda name: plot.FileStripSpaces(__file__, name),
    "printed.txt": print_to,
    "data.hdf5": lambda name: advancedUtilities.SaveDictToHDF5(name, {"a": np.ones(1000)}),
    "figure.png": save_figure,
}
GROWING = ("results.txt", "printed.txt")  # while their run goes on


@pytest.mark.parametrize("name", WRITERS)
def test_a_full_disk_is_reported_with_the_name_of_the_file(name: str) -> None:
    with pytest.raises(OSError, match=name) as caught, limited_files():
        WRITERS[name](name)
    assert caught.value.errno in (errno.EFBIG, None) and (caught.value.errno or "File too large" in str(caught.value))
    assert ".writing-" not in str(caught.value.filename)


@pytest.mark.parametrize("name", [name for name in WRITERS if name not in GROWING])
def test_failed_writes_leave_the_last_good_file(name: str) -> None:
    Path(name).write_text("of last week")
    with pytest.raises(OSError, match=name), limited_files():
        WRITERS[name](name)
    assert Path(name).read_text() == "of last week"
    assert [path.name for path in Path().iterdir()] == [name]
    Path(name).chmod(0o640)
    WRITERS[name](name)
    assert Path(name).stat().st_size > 64 and Path(name).stat().st_mode & 0o777 == 0o640


def test_files_are_written_through_links_and_into_devices(tmp_path: Path) -> None:
    Path("real").mkdir()
    Path("link.png").symlink_to("real/figure.png")
    save_figure("link.png")
    assert Path("link.png").is_symlink() and Path("real/figure.png").stat().st_size > 64
    Path("null.png").symlink_to("/dev/null")
    save_figure("null.png")
    assert Path("/dev/null").is_char_device()
    with pytest.raises(FileNotFoundError, match=r"'nowhere/figure\.h5'"):
        advancedUtilities.SaveDictToHDF5("nowhere/figure.h5", {})


def test_printing_reports_a_full_disk() -> None:
    """Once, by the Print that did not fit."""
    with limited_files():
        exu.SetWriteToFile("printed.txt", flagFlushAlways=True)
        exu.Print("x" * 60)
        with pytest.raises(OSError, match=r"printed\.txt"):
            exu.Print("y" * 60)
        assert not exu.config.printToFile
        exu.Print("more")
        exu.SetWriteToFile("", False)
