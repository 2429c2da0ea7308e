"""Solution files in text: a header, then rows of numbers."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from itertools import islice
from typing import Any

import numpy as np

from dalembert._calls import checked
from dalembert._core import Print
from dalembert._io.files import (
    Path,
    file_to_read,
    file_to_write,
    numbers_of,
    read_table,
    refuse_line,
    replacing,
    require_last_line,
)
from dalembert._io.solution_rows import solution_of

_HEADER_LINES = 5
_HEADER_TITLE = "#number of written coordinates"


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

    If there is a header, a row is complete when its line ends. Other rows are skipped in safe mode, else rejected.
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


def load_text_solution(fileName: Path, safeMode: bool, maxRows: int, verbose: bool, hasHeader: bool) -> dict[str, Any]:
    """Read a solution file in text; see LoadSolutionFile."""
    columns: list[int] = []
    expected = None
    if hasHeader:
        with open(fileName, encoding="utf-8", errors="replace") as text:
            columns = _columns_of_header(fileName, list(islice(text, _HEADER_LINES)))
        expected = sum(columns) + 1
    if safeMode or maxRows != -1:
        rows = islice(_rows(fileName, expected, safeMode), None if maxRows == -1 else int(maxRows))
        data = np.array(list(rows), dtype=float, ndmin=2)
    else:
        if hasHeader:
            require_last_line(fileName)
        data = read_table(fileName, columns=expected)
    if data.size == 0:
        raise ValueError(f"{os.fspath(fileName)}: no rows of data found")
    if verbose:
        Print(f"{os.fspath(fileName)}: {data.shape[0]} rows, {data.shape[1] - 1} columns {columns}")
    return solution_of(data, columns)


@checked
def RecoverSolutionFile(fileName: Path, newFileName: Path, verbose: int = 0) -> None:
    """Copy a text solution file without the rows whose number of columns does not fit the header.

    verbose 1 reports rows left out, 2 all rows. ValueError if the header is missing, or if both names are one file's.
    """
    fileName = file_to_read("RecoverSolutionFile: fileName", fileName)
    newFileName = file_to_write("RecoverSolutionFile: newFileName", newFileName)
    if os.path.exists(newFileName) and os.path.samefile(fileName, newFileName):
        raise ValueError(f"RecoverSolutionFile: newFileName: expected another file than {fileName!r}")
    with open(fileName, encoding="utf-8", errors="replace") as source:
        expected = sum(_columns_of_header(fileName, list(islice(source, _HEADER_LINES)))) + 1
        source.seek(0)
        with replacing(newFileName) as written, open(written, "w", encoding="utf-8") as target:
            for number, line in enumerate(source, 1):
                row = numbers_of(line, ",")
                columns = line.count(",") + 1
                keep = line.endswith("\n") and (line.startswith("#") or (row is not None and columns == expected))
                if keep:
                    target.write(line)
                if verbose >= (2 if keep else 1):
                    Print(f"line {number}: {'kept' if keep else f'left out, {columns} of {expected} columns'}")
