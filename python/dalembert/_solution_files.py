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
from dalembert._files import Path, naming, numbers_of, read_table, refuse_line, require_last_line

_MAGIC = b"EXUBIN"
_RESTART_MAGIC = b"#dalembert restart file"
_HEADER_LINES = 5
_HEADER_TITLE = "#number of written coordinates"
_LARGE = 1 << 20  # bytes
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


def _rows(fileName: Path, columns: int | None, safeMode: bool) -> Iterator[list[float]]:
    """Give the rows of numbers, as many as `columns` says or, if that is None, the first row has.

    With a header, a row is complete when its line ends. Other rows are left out in safe mode, else refused.
    """
    has_header = columns is not None
    with open(fileName, encoding="utf-8", errors="replace") as text:
        for number, line in enumerate(text, 1):
            if line.startswith("#") or not line.strip():
                continue
            row = numbers_of(line, ",")
            columns = columns or (len(row) if row else None)
            if row is not None and len(row) == columns and (line.endswith("\n") or not has_header):
                yield row
            elif not safeMode:
                raise refuse_line(
                    fileName, number, f"{columns or ''} numbers separated by ',' in a complete line", line
                )


def LoadSolutionFile(
    fileName: Path, safeMode: bool = False, maxRows: int = -1, verbose: bool = True, hasHeader: bool = True
) -> dict[str, Any]:
    """Read a solution file, text or binary, and return a dict with data, columnsExported, nColumns and nRows.

    data has one row per written step: time (s), then nColumns coordinates in the groups of columnsExported (ODE2,
    ODE2_t, ODE2_tt, ODE1, ODE1_t, AE, Data). safeMode leaves out damaged rows, maxRows limits their number (-1: all).
    ValueError with line or byte if the header is missing, or if a row is damaged or incomplete.
    """
    with open(fileName, "rb") as file:
        if file.read(len(_MAGIC)) == _MAGIC:
            return LoadBinarySolutionFile(fileName, maxRows, verbose, safeMode)

    columns: list[int] = []
    expected = None
    if hasHeader:
        with open(fileName, encoding="utf-8", errors="replace") as text:
            columns = _columns_of_header(fileName, list(islice(text, _HEADER_LINES)))
        expected = sum(columns) + 1
    if safeMode or maxRows != -1:
        rows = islice(_rows(fileName, expected, safeMode), None if maxRows == -1 else maxRows)
        data = np.array(list(rows), dtype=float, ndmin=2)
    else:
        if hasHeader:
            require_last_line(fileName)
        data = read_table(fileName, columns=expected)
    if data.size == 0:
        raise ValueError(f"{os.fspath(fileName)}: no rows of data found")
    if verbose:
        Print(f"{os.fspath(fileName)}: {data.shape[0]} rows, {data.shape[1] - 1} columns {columns}")
    return _solution(data, columns)


def _solution(data: FloatArray, columns: list[int]) -> dict[str, Any]:
    return {"data": data, "columnsExported": columns, "nColumns": data.shape[1] - 1, "nRows": data.shape[0]}


def RecoverSolutionFile(fileName: Path, newFileName: Path, verbose: int = 0) -> None:
    """Copy a text solution file without the rows whose number of columns does not fit the header.

    verbose 1 reports rows left out, 2 all rows. ValueError if the header is missing, or if both names are one file's.
    """
    if os.path.exists(newFileName) and os.path.samefile(fileName, newFileName):
        raise ValueError(f"RecoverSolutionFile: newFileName: expected another file than {os.fspath(fileName)!r}")
    with open(fileName, encoding="utf-8", errors="replace") as source:
        expected = sum(_columns_of_header(fileName, list(islice(source, _HEADER_LINES)))) + 1
        source.seek(0)
        with naming(newFileName), open(newFileName, "w", encoding="utf-8") as target:
            for number, line in enumerate(source, 1):
                row = numbers_of(line, ",")
                columns = line.count(",") + 1
                keep = line.endswith("\n") and (line.startswith("#") or (row is not None and columns == expected))
                if keep:
                    target.write(line)
                if verbose >= (2 if keep else 1):
                    Print(f"line {number}: {'kept' if keep else f'left out, {columns} of {expected} columns'}")


# ---- binary files ---------------------------------------------------------------------------------------------------


def NumpyInt8ArrayToString(npArray: npt.ArrayLike) -> str:
    """Return the text of an array of character codes."""
    return "".join(chr(int(code)) for code in np.asarray(npArray))


def _read(file: IO[bytes], dtype: Any, count: int) -> npt.NDArray[Any]:
    """Return `count` numbers, or those that the file still has."""
    size = np.dtype(dtype).itemsize
    wanted = size * max(count, 0)
    if wanted > _LARGE:  # a damaged length must not ask for more memory than the file has bytes
        here = file.tell()
        wanted = min(wanted, file.seek(0, os.SEEK_END) - here)
        file.seek(here)
    data = file.read(wanted)
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


def _binary_header(file: IO[bytes], fileName: Path) -> tuple[dict[str, Any], Any, Any]:
    """Return the header of a binary file, and the types of its integers and numbers."""

    def refuse(position: int, problem: str) -> ValueError:
        return ValueError(f"{os.fspath(fileName)}, byte {position}: {problem}; the binary header is damaged")

    def read(function: Any, *types: Any) -> Any:
        position = file.tell()
        value, ended = function(file, *types)
        if ended:
            raise refuse(position, "the file ends inside of the header")
        return value

    start = file.read(len(_MAGIC))
    if start != _MAGIC:
        raise ValueError(f"{os.fspath(fileName)}: no binary solution file, it does not start with {_MAGIC!r}")
    sizes = _read(file, np.int8, 10)
    if sizes.size != 10 or sizes[1] not in (4, 8) or sizes[2] not in (4, 8) or sizes[4] not in (0, 1):
        raise refuse(len(start), f"expected the sizes of numbers, received {sizes.tolist()}")
    order = ">" if sizes[4] else "<"
    intType, realType = np.dtype(f"{order}i{sizes[1]}"), np.dtype(f"{order}f{sizes[2]}")
    header: dict[str, Any] = {name: read(BinaryReadString, intType) for name in ("version", "mode", "solver", "time")}
    header |= {name: read(BinaryReadArrayIndex, intType) for name in ("sizes", "columns")}
    header |= {name: read(BinaryReadIndex, intType) for name in ("coordinates", "steps")}
    header |= {name: read(BinaryReadString, intType) for name in ("information", "end")}
    columns = [int(n) for n in header["columns"]]
    if header["end"] != "EndOfHeader":
        raise refuse(file.tell(), f"expected 'EndOfHeader' before, received {header['end'][:20]!r}")
    if len(columns) != len(_COLUMNS) or min(columns) < 0 or sum(columns) != header["coordinates"]:
        raise refuse(file.tell(), f"numbers of coordinates {columns} before do not make up {header['coordinates']}")
    return header, intType, realType


def LoadBinarySolutionFile(
    fileName: Path, maxRows: int = -1, verbose: bool | int = True, safeMode: bool = False
) -> dict[str, Any]:
    """Read a binary solution file; the result is that of LoadSolutionFile, verbose=2 prints the header.

    A file without its end, because a solver still runs, gives its rows and a warning. ValueError with the byte if it is
    damaged or ends inside of a row; safeMode takes the complete rows before.
    """
    with open(fileName, "rb") as file:
        header, intType, realType = _binary_header(file, fileName)
        columns = [int(n) for n in header["columns"]]
        width = sum(columns) + 1
        rows: list[Any] = []
        ended, complete = False, False
        while not complete and (maxRows == -1 or len(rows) < maxRows):
            position = file.tell()
            length, ended = BinaryReadIndex(file, intType)
            if ended and file.tell() == position:
                break
            complete = not ended and length == _END_OF_FILE
            row = _read(file, realType, width) if length == width and not ended else np.empty(0)
            if row.size == width:
                rows.append(row)
            elif not complete:
                if safeMode:
                    ended = True
                    break
                problem = "the file ends inside of this row" if length == width or ended else f"it has {length} numbers"
                raise ValueError(
                    f"{os.fspath(fileName)}, byte {position}: row {len(rows)}: expected {width} numbers, {problem}; "
                    "the file is damaged or still being written, safeMode=True takes the rows before"
                )
    if ended:
        Print(f"WARNING: {os.fspath(fileName)} ends early; {len(rows)} complete rows are used")
    if verbose:
        details = f", header: {header}" if int(verbose) > 1 else ""
        Print(f"{os.fspath(fileName)}: {len(rows)} rows, {sum(columns)} columns {columns}{details}")
    data = np.array(rows, dtype=float) if rows else np.zeros((0, width))
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
