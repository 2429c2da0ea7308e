"""Files of numbers and texts: errors have the name of the file and, if known, the line."""

from __future__ import annotations

import errno
import os
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

from dalembert._checks import FloatArray, shape_error

Path = str | os.PathLike[str]

_SHOWN = 60  # characters of a line that is refused
_AT_WORK = ".writing-"  # folders of files that are being written


def path_name(name: str, value: Any, expected: str = "the name of a file") -> str:
    """Return a string or path as string; TypeError or ValueError name the argument if it is neither, or no name."""
    if not isinstance(value, (str, os.PathLike)):
        raise TypeError(str(shape_error(name, expected, value)))
    path = os.fsdecode(value)
    if not path.strip() or "\0" in path:
        raise shape_error(name, expected, value)
    return path


def file_name(name: str, value: Any) -> str:
    """Return the name of a file, given as string or path; errors name the argument if it is invalid, or a folder."""
    path = path_name(name, value)
    if os.path.isdir(path):
        raise IsADirectoryError(errno.EISDIR, f"{name}: expected a file, but this is a folder", path)
    return path


def file_to_read(name: str, value: Any, empty: bool = False) -> str:
    """Return the name of a file that is there and, unless it may be empty, has content.

    Errors name the argument, and near files.
    """
    path = file_name(name, value)
    if not os.path.exists(path):
        from dalembert._tools.missing_names import nearest

        folder = os.path.dirname(os.path.abspath(path))
        text = f"there is no such file in the folder '{folder}'"
        if os.path.isdir(folder):
            text += nearest(os.path.basename(path), os.listdir(folder))
        else:
            text = f"there is no such file, nor the folder '{folder}'"
        raise FileNotFoundError(errno.ENOENT, f"{name}: {text}", path)
    if not empty and os.path.isfile(path) and os.path.getsize(path) == 0:
        raise ValueError(f"{name}: the file {path!r} is empty")
    return path


def file_to_write(name: str, value: Any, newFolder: bool = False) -> str:
    """Return the name of a file to write, whose folder is there, or will be made; errors name the argument."""
    path = file_name(name, value)
    folder = os.path.dirname(os.path.abspath(path))
    while newFolder and not os.path.exists(folder):
        folder = os.path.dirname(folder)
    if os.path.exists(folder) and not os.path.isdir(folder):
        raise NotADirectoryError(errno.ENOTDIR, f"{name}: '{folder}' is a file, no folder", path)
    if not os.path.isdir(folder):
        text = f"{name}: there is no folder '{folder}' for the file; make it first"
        raise FileNotFoundError(errno.ENOENT, text, path)
    return path


@contextmanager
def naming(fileName: Path) -> Iterator[None]:
    """Give errors of the operating system, of a full disk for instance, the name of the file."""
    try:
        yield
    except OSError as error:
        if error.filename is None or _AT_WORK in str(error.filename):
            if error.errno is None:  # errors of a library, with their own text
                raise OSError(f"{os.fspath(fileName)}: {error}") from error
            error.filename = os.fspath(fileName)
        raise


@contextmanager
def replacing(fileName: Path) -> Iterator[str]:
    """Give the name of a file to write, which takes the place of `fileName` when it is complete; until then that stays.

    It lies in the same folder and has the same ending. Devices and pipes are written to directly; links stay links.
    """
    import shutil
    import tempfile

    target = os.path.realpath(os.fspath(fileName))
    exists = os.path.exists(target)
    with naming(fileName):
        if exists and not os.path.isfile(target):
            yield os.fspath(fileName)
            return
        if exists and not os.access(target, os.W_OK):
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
        with tempfile.TemporaryDirectory(prefix=_AT_WORK, dir=os.path.dirname(target)) as folder:
            written = os.path.join(folder, os.path.basename(target))
            yield written
            if exists:
                shutil.copymode(target, written)
            os.replace(written, target)


def refuse_line(fileName: Path, number: int, expected: str, received: str) -> ValueError:
    """Return the error of an invalid line, counted from 1."""
    shown = received.rstrip("\n")
    shown = shown if len(shown) <= _SHOWN else shown[:_SHOWN] + "..."
    return ValueError(f"{os.fspath(fileName)}, line {number}: expected {expected}, received {shown!r}")


def numbers_of(line: str, delimiter: str | None) -> list[float] | None:
    """Return the numbers of a line, or None if it has other contents."""
    try:
        return [float(entry) for entry in line.split(delimiter)]
    except ValueError:
        return None


def _refuse_table(fileName: Path, comments: str, delimiter: str | None, columns: int | None) -> None:
    """Name the first line that is no row of the table."""
    with open(fileName, encoding="utf-8", errors="replace") as file:
        for number, line in enumerate(file, 1):
            content = line.partition(comments)[0] if comments else line
            if not content.strip():
                continue
            row = numbers_of(content, delimiter)
            columns = columns or (len(row) if row else None)
            if row is None or len(row) != columns:
                count = f"{columns} numbers" if columns else "numbers"
                raise refuse_line(fileName, number, f"{count} separated by {delimiter or 'blanks'!r}", line)


def require_last_line(fileName: Path) -> None:
    """Refuse a file whose last line does not end: its last number may have lost digits."""
    with open(fileName, "rb") as file:
        lines = 0
        last = b"\n"
        while chunk := file.read(1 << 20):
            lines += chunk.count(b"\n")
            last = chunk[-1:]
    if last != b"\n":
        raise ValueError(
            f"{os.fspath(fileName)}, line {lines + 1}: the file ends inside of this line; "
            "it is incomplete, or still being written"
        )


def read_table(
    fileName: Path, comments: str = "#", delimiter: str | None = ",", columns: int | None = None
) -> FloatArray:
    """Return the rows of a text file of numbers, all with as many columns (that number, if given)."""
    try:
        data: FloatArray = np.loadtxt(fileName, comments=comments, delimiter=delimiter, ndmin=2)
    except ValueError:
        _refuse_table(fileName, comments, delimiter, columns)
        raise
    if columns is not None and data.size and data.shape[1] != columns:
        _refuse_table(fileName, comments, delimiter, columns)
    return data
