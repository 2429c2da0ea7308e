"""Solution files in binary form: a header with the sizes of numbers, then rows with their lengths."""

from __future__ import annotations

import os
import sys
from typing import IO, Any

import numpy as np
import numpy.typing as npt

from dalembert._calls import checked
from dalembert._checks import as_vector, shape_error
from dalembert._core import Print
from dalembert._io.files import Path, file_to_read
from dalembert._io.solution_rows import COLUMNS, solution_of

MAGIC = b"EXUBIN"
_LARGE = 1 << 20  # bytes
_END_OF_FILE = -1  # length of a row that marks the end of a binary file


def NumpyInt8ArrayToString(npArray: npt.ArrayLike) -> str:
    """Return the text of an array of character codes."""
    codes = as_vector("NumpyInt8ArrayToString: npArray", npArray)
    if not ((codes >= 0) & (codes <= sys.maxunicode) & (codes == np.floor(codes))).all():
        raise shape_error("NumpyInt8ArrayToString: npArray", "codes of characters, from 0", npArray)
    return "".join(chr(code) for code in codes.astype(int))


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


def _read_number(file: IO[bytes], dtype: Any) -> list[Any]:
    data = _read(file, dtype, 1)
    return [data[0], False] if data.size else [0, True]


def _read_numbers(file: IO[bytes], intType: Any, dtype: Any) -> list[Any]:
    length, ended = _read_number(file, intType)
    if ended:
        return [[], True]
    data = _read(file, dtype, int(length))
    return [[], True] if data.size != length else [data, False]


def _read_text(file: IO[bytes], intType: Any) -> list[Any]:
    data, ended = _read_numbers(file, intType, np.uint8)
    return [NumpyInt8ArrayToString(data), ended]


def _check_reading(where: str, file: Any, kinds: str = "i", **types: Any) -> None:
    """Raise an error for unreadable objects, and for number types of other numpy kinds."""
    if not all(hasattr(file, name) for name in ("read", "seek", "tell")) or hasattr(file, "encoding"):
        raise shape_error(f"{where}: file", "a file that is open for reading, by open(name, 'rb')", file)
    for (name, value), kind in zip(types.items(), kinds, strict=True):
        expected = "a type of integers, such as np.int32" if kind == "i" else "a type of numbers, such as np.float64"
        try:
            found = None if value is None else np.dtype(value)
        except (TypeError, ValueError):
            found = None
        if found is None or found.kind not in ("iu" if kind == "i" else "iuf"):
            raise shape_error(f"{where}: {name}", expected, value)


def BinaryReadIndex(file: IO[bytes], intType: Any) -> list[Any]:
    """Read an integer; return [value, whether the file ended before]."""
    _check_reading("BinaryReadIndex", file, intType=intType)
    return _read_number(file, intType)


def BinaryReadReal(file: IO[bytes], realType: Any) -> list[Any]:
    """Read a floating point number; return [value, whether the file ended before]."""
    _check_reading("BinaryReadReal", file, "f", realType=realType)
    return _read_number(file, realType)


def BinaryReadArrayIndex(file: IO[bytes], intType: Any) -> list[Any]:
    """Read a length and as many integers; return [array, whether the file ended before]."""
    _check_reading("BinaryReadArrayIndex", file, intType=intType)
    return _read_numbers(file, intType, intType)


def BinaryReadString(file: IO[bytes], intType: Any) -> list[Any]:
    """Read a length and as many characters; return [text, whether the file ended before]."""
    _check_reading("BinaryReadString", file, intType=intType)
    return _read_text(file, intType)


def BinaryReadRealVector(file: IO[bytes], intType: Any, realType: Any) -> list[Any]:
    """Read a length and as many numbers; return [array, whether the file ended before]."""
    _check_reading("BinaryReadRealVector", file, "if", intType=intType, realType=realType)
    return _read_numbers(file, intType, realType)


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

    start = file.read(len(MAGIC))
    if start != MAGIC:
        raise ValueError(f"{os.fspath(fileName)}: no binary solution file, it does not start with {MAGIC!r}")
    sizes = _read(file, np.int8, 10)
    if sizes.size != 10 or sizes[1] not in (4, 8) or sizes[2] not in (4, 8) or sizes[4] not in (0, 1):
        raise refuse(len(start), f"expected the sizes of numbers, received {sizes.tolist()}")
    order = ">" if sizes[4] else "<"
    intType, realType = np.dtype(f"{order}i{sizes[1]}"), np.dtype(f"{order}f{sizes[2]}")
    header: dict[str, Any] = {name: read(_read_text, intType) for name in ("version", "mode", "solver", "time")}
    header |= {name: read(_read_numbers, intType, intType) for name in ("sizes", "columns")}
    header |= {name: read(_read_number, intType) for name in ("coordinates", "steps")}
    header |= {name: read(_read_text, intType) for name in ("information", "end")}
    columns = [int(n) for n in header["columns"]]
    if header["end"] != "EndOfHeader":
        raise refuse(file.tell(), f"expected 'EndOfHeader' before, received {header['end'][:20]!r}")
    if len(columns) != len(COLUMNS) or min(columns) < 0 or sum(columns) != header["coordinates"]:
        raise refuse(file.tell(), f"numbers of coordinates {columns} before do not make up {header['coordinates']}")
    return header, intType, realType


@checked
def LoadBinarySolutionFile(
    fileName: Path, maxRows: int = -1, verbose: bool | int = True, safeMode: bool = False
) -> dict[str, Any]:
    """Read a binary solution file; the result is that of LoadSolutionFile, verbose=2 prints the header.

    A file without its end, because a solver still runs, gives its rows and a warning. ValueError with the byte if it is
    damaged or ends inside of a row; safeMode takes the complete rows before.
    """
    if maxRows < -1:
        raise shape_error("LoadBinarySolutionFile: maxRows", "an integer, -1 for all rows or more", maxRows)
    fileName = file_to_read("LoadBinarySolutionFile: fileName", fileName)
    with open(fileName, "rb") as file:
        header, intType, realType = _binary_header(file, fileName)
        columns = [int(n) for n in header["columns"]]
        width = sum(columns) + 1
        rows: list[Any] = []
        ended, complete = False, False
        while not complete and (maxRows == -1 or len(rows) < maxRows):
            position = file.tell()
            length, ended = _read_number(file, intType)
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
    return solution_of(data, columns)
