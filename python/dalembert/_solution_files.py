"""Solution files, text or binary: read them, repair them, and put their rows into a system."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from itertools import islice
from typing import IO, Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray
from dalembert._core import ConfigurationType, MainSolverImplicitSecondOrder, Print

Path = str | os.PathLike[str]

_MAGIC = b"EXUBIN"
_RESTART_MAGIC = b"#dalembert restart file"
_HEADER_LINES = 5
_HEADER_TITLE = "#number of written coordinates"
_END_OF_FILE = -1  # length of a row that marks the end of a binary file

# What a row holds after the time, in the order of columnsExported, by the names of the functions that set it.
_COLUMNS = (
    "ODE2Coordinates",
    "ODE2Coordinates_t",
    "ODE2Coordinates_tt",
    "ODE1Coordinates",
    "ODE1Coordinates_t",
    "AECoordinates",
    "DataCoordinates",
)


# ---- text files -----------------------------------------------------------------------------------------------------


def _columns_of_header(fileName: Path, lines: list[str]) -> list[int]:
    """Return the numbers of written coordinates [ODE2, ODE2_t, ODE2_tt, ODE1, ODE1_t, AE, Data] from the header."""
    line = lines[_HEADER_LINES - 1] if len(lines) >= _HEADER_LINES else ""
    match = re.search(r"=\s*\[([\d,\s]*)\]", line) if line.startswith(_HEADER_TITLE) else None
    if match is None:
        raise ValueError(
            f"{os.fspath(fileName)}: expected '{_HEADER_TITLE} [...] = [...]' in line {_HEADER_LINES}, found "
            f"{line.strip()[:80]!r}; the file is empty or no solution file (hasHeader=False reads plain numbers)"
        )
    return [int(entry) for entry in match.group(1).split(",") if entry.strip()]


def _consistent_rows(lines: Iterator[str], columns: int | None) -> Iterator[list[float]]:
    """Give the rows with the expected number of numbers (that of the first row if None) and skip all others."""
    for line in lines:
        if line.startswith("#") or not line.strip():
            continue
        try:
            row = [float(entry) for entry in line.split(",")]
        except ValueError:
            continue
        columns = columns or len(row)
        if len(row) == columns:
            yield row


def LoadSolutionFile(
    fileName: Path, safeMode: bool = False, maxRows: int = -1, verbose: bool = True, hasHeader: bool = True
) -> dict[str, Any]:
    """Read a solution file, text or binary, and return a dict with data, columnsExported, nColumns and nRows.

    data has one row per written step: time (s), then nColumns coordinates in the groups of columnsExported (ODE2,
    ODE2_t, ODE2_tt, ODE1, ODE1_t, AE, Data). safeMode leaves out damaged rows, maxRows limits their number (-1: all).
    ValueError if the header is missing or does not fit the data.
    """
    with open(fileName, "rb") as file:
        if file.read(len(_MAGIC)) == _MAGIC:
            return LoadBinarySolutionFile(fileName, maxRows, verbose)

    columns: list[int] = []
    limit = None if maxRows == -1 else maxRows
    with open(fileName, encoding="utf-8") as text:
        if hasHeader:
            columns = _columns_of_header(fileName, list(islice(text, _HEADER_LINES)))
        if safeMode:
            expected = sum(columns) + 1 if hasHeader else None
            data = np.array(list(islice(_consistent_rows(text, expected), limit)), dtype=float)
        else:
            source = text if limit is None else islice((line for line in text if line[0] not in "#\n"), limit)
            data = np.loadtxt(source, comments="#", delimiter=",", ndmin=2)
    if data.size == 0:
        raise ValueError(f"{os.fspath(fileName)}: no rows of data found")
    if hasHeader and data.shape[1] != sum(columns) + 1:
        raise ValueError(
            f"{os.fspath(fileName)}: the header announces {sum(columns)} columns besides the time, "
            f"the rows have {data.shape[1] - 1}"
        )
    if verbose:
        Print(f"{os.fspath(fileName)}: {data.shape[0]} rows, {data.shape[1] - 1} columns {columns}")
    return _solution(data, columns)


def _solution(data: FloatArray, columns: list[int]) -> dict[str, Any]:
    return {"data": data, "columnsExported": columns, "nColumns": data.shape[1] - 1, "nRows": data.shape[0]}


def RecoverSolutionFile(fileName: Path, newFileName: Path, verbose: int = 0) -> None:
    """Copy a text solution file without the rows whose number of columns does not fit the header.

    verbose 1 reports rows left out, 2 all rows. ValueError if the header is missing.
    """
    with open(fileName, encoding="utf-8") as source:
        expected = sum(_columns_of_header(fileName, list(islice(source, _HEADER_LINES)))) + 1
        source.seek(0)
        with open(newFileName, "w", encoding="utf-8") as target:
            for number, line in enumerate(source, 1):
                columns = line.count(",") + 1
                keep = line.startswith("#") or columns == expected
                if keep:
                    target.write(line)
                if verbose >= (2 if keep else 1):
                    Print(f"line {number}: {'kept' if keep else f'left out, {columns} of {expected} columns'}")


# ---- binary files ---------------------------------------------------------------------------------------------------


def NumpyInt8ArrayToString(npArray: npt.ArrayLike) -> str:
    """Return the text of an array of character codes."""
    return "".join(chr(int(code)) for code in np.asarray(npArray))


def _read(file: IO[bytes], dtype: Any, count: int) -> npt.NDArray[Any]:
    size = np.dtype(dtype).itemsize
    data = file.read(size * max(count, 0))
    return np.frombuffer(data[: len(data) // size * size], dtype=dtype)


def BinaryReadIndex(file: IO[bytes], intType: Any) -> list[Any]:
    """Read an integer; return [value, whether the file ended before]."""
    data = _read(file, intType, 1)
    return [data[0], False] if data.size else [0, True]


def BinaryReadReal(file: IO[bytes], realType: Any) -> list[Any]:
    """Read a floating point number; return [value, whether the file ended before]."""
    return BinaryReadIndex(file, realType)


def BinaryReadArrayIndex(file: IO[bytes], intType: Any) -> list[Any]:
    """Read a length and as many integers; return [array, whether the file ended before]."""
    return BinaryReadRealVector(file, intType, intType)


def BinaryReadString(file: IO[bytes], intType: Any) -> list[Any]:
    """Read a length and as many characters; return [text, whether the file ended before]."""
    data, ended = BinaryReadRealVector(file, intType, np.uint8)
    return [NumpyInt8ArrayToString(data), ended]


def BinaryReadRealVector(file: IO[bytes], intType: Any, realType: Any) -> list[Any]:
    """Read a length and as many numbers; return [array, whether the file ended before]."""
    length, ended = BinaryReadIndex(file, intType)
    if ended:
        return [[], True]
    data = _read(file, realType, int(length))
    return [[], True] if data.size != length else [data, False]


def _number_type(kind: str, size: int, bigEndian: bool) -> np.dtype[Any]:
    if size not in (4, 8):
        raise ValueError(f"LoadBinarySolutionFile: numbers of {size} bytes are not supported")
    return np.dtype(f"{'>' if bigEndian else '<'}{kind}{size}")


def LoadBinarySolutionFile(fileName: Path, maxRows: int = -1, verbose: bool | int = True) -> dict[str, Any]:
    """Read a binary solution file; the result is that of LoadSolutionFile, verbose=2 prints the header.

    A file that ends early, e.g. while a solver still runs, gives its complete rows and a warning.
    """
    with open(fileName, "rb") as file:
        if file.read(len(_MAGIC)) != _MAGIC:
            raise ValueError(f"{os.fspath(fileName)}: no binary solution file, it does not start with {_MAGIC!r}")
        _, indexSize, realSize, _, bigEndian = (int(x) for x in _read(file, np.int8, 10)[:5])
        intType, realType = _number_type("i", indexSize, bool(bigEndian)), _number_type("f", realSize, bool(bigEndian))
        header: dict[str, Any] = {
            name: BinaryReadString(file, intType)[0] for name in ("version", "mode", "solver", "time")
        }
        header |= {name: BinaryReadArrayIndex(file, intType)[0] for name in ("sizes", "columns")}
        header |= {name: BinaryReadIndex(file, intType)[0] for name in ("coordinates", "steps")}
        header |= {name: BinaryReadString(file, intType)[0] for name in ("information", "end")}
        if header["end"] != "EndOfHeader":
            raise ValueError(f"{os.fspath(fileName)}: the binary header is damaged")
        columns = [int(n) for n in header["columns"]]

        rows: list[Any] = []
        complete = False
        while maxRows == -1 or len(rows) < maxRows:
            length, ended = BinaryReadIndex(file, intType)
            complete = not ended and length == _END_OF_FILE
            if ended or complete:
                break
            row = _read(file, realType, int(length))
            if row.size != length:
                break
            if length != sum(columns) + 1:
                raise ValueError(
                    f"{os.fspath(fileName)}: row {len(rows)} has {length} numbers, expected {sum(columns) + 1}"
                )
            rows.append(row)
    if not complete and maxRows == -1:
        Print(f"WARNING: {os.fspath(fileName)} ends early; {len(rows)} complete rows are used")
    if verbose:
        details = f", header: {header}" if int(verbose) > 1 else ""
        Print(f"{os.fspath(fileName)}: {len(rows)} rows, {sum(columns)} columns {columns}{details}")
    data = np.array(rows, dtype=float) if rows else np.zeros((0, sum(columns) + 1))
    return _solution(data, columns)


# ---- from rows to states --------------------------------------------------------------------------------------------


def _set_row(mbs: Any, row: FloatArray, columns: list[int], configuration: Any) -> None:
    """Set all coordinates of a configuration that a row holds."""
    groups = np.split(row[1:], np.cumsum(columns)[:-1])
    for name, group in zip(_COLUMNS, groups, strict=True):
        if group.size or name == "ODE2Coordinates":
            getattr(mbs.systemData, f"Set{name}")(group, configuration)


def SetSolutionState(
    mbs: Any,
    solution: dict[str, Any],
    row: int,
    configuration: Any = ConfigurationType.Current,
    sendRedrawSignal: bool = True,
) -> None:
    """Put row number `row` of a solution (of LoadSolutionFile) into a configuration of the system.

    The Visualization configuration gets the row's time too and is redrawn. IndexError if there is no such row.
    """
    if not -solution["nRows"] <= row < solution["nRows"]:
        raise IndexError(f"SetSolutionState: row {row} does not exist, the solution has {solution['nRows']} rows")
    data = np.asarray(solution["data"], dtype=float)[row]
    _set_row(mbs, data, list(solution["columnsExported"]), configuration)
    if configuration == ConfigurationType.Visualization:
        mbs.systemData.SetTime(float(data[0]), ConfigurationType.Visualization)
        if sendRedrawSignal:
            mbs.GetSystemContainer().renderer.SendRedrawSignal()


def InitializeFromRestartFile(mbs: Any, simulationSettings: Any, restartFileName: Path, verbose: bool = True) -> None:
    """Go on from a restart file, or from the last complete row of a solution file: current, initial and shown state.

    Its time becomes the start time of the settings. The system must be assembled and have the structure of the one
    that wrote the file; a solution file must hold velocities too. ValueError if the file does not fit.

    What a solver has besides the state, as generalized alpha its algorithmic accelerations, starts anew; with
    ContinueFromRestartFile of the solver, it goes on bit for bit.
    """
    with open(restartFileName, "rb") as file:
        of_solver = file.read(len(_RESTART_MAGIC)) == _RESTART_MAGIC
    if of_solver:
        MainSolverImplicitSecondOrder().ContinueFromRestartFile(mbs, os.fspath(restartFileName))
        time = mbs.systemData.GetTime(ConfigurationType.Initial)
        for configuration in (ConfigurationType.Current, ConfigurationType.Visualization):
            mbs.systemData.SetSystemState(mbs.systemData.GetSystemState(ConfigurationType.Initial), configuration)
            mbs.systemData.SetTime(time, configuration)
        simulationSettings.timeIntegration.startTime = time
        return
    solution = LoadSolutionFile(restartFileName, safeMode=True, verbose=verbose)
    state, columns = solution["data"][-1], solution["columnsExported"]
    if columns[0] != mbs.systemData.ODE2Size() or columns[1] != columns[0]:
        raise ValueError(
            f"{os.fspath(restartFileName)}: expected {mbs.systemData.ODE2Size()} ODE2 coordinates and as many "
            f"velocities, found {columns[0]} and {columns[1]}; does the file belong to this system?"
        )
    for configuration in (ConfigurationType.Current, ConfigurationType.Initial, ConfigurationType.Visualization):
        _set_row(mbs, state, columns, configuration)
        mbs.systemData.SetTime(float(state[0]), configuration)
    simulationSettings.timeIntegration.startTime = float(state[0])


def AnimateSolution(
    mbs: Any,
    solution: dict[str, Any],
    rowIncrement: int = 1,
    timeout: float = 0.04,
    createImages: bool = False,
    runLoop: bool = False,
) -> None:
    """Show every rowIncrement-th row of a solution, with a pause of `timeout` seconds; runLoop repeats until stopped.

    Without a render window the first row becomes the visualized state and the function returns.
    """
    rows = solution["nRows"]
    if rows == 0 or not 1 <= rowIncrement <= rows:
        raise ValueError(f"AnimateSolution: rowIncrement: expected 1 to {rows} (rows), received {rowIncrement}")
    container = mbs.GetSystemContainer()
    SetSolutionState(mbs, solution, 0, ConfigurationType.Visualization)
    if not container.renderer.IsActive():
        return
    mbs.SetRenderEngineStopFlag(False)
    while not mbs.GetRenderEngineStopFlag():
        for row in range(0, rows, rowIncrement):
            if mbs.GetRenderEngineStopFlag():
                break
            SetSolutionState(mbs, solution, row, ConfigurationType.Visualization)
            if createImages:
                container.renderer.RedrawAndSaveImage()
            container.renderer.DoIdleTasks(timeout)
        if not runLoop:
            break
