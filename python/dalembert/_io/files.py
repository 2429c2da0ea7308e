"""Files of numbers and texts: what goes wrong with one is told with its name and, where there is one, the line."""

from __future__ import annotations

import errno
import os
from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np

from dalembert._checks import FloatArray

Path = str | os.PathLike[str]

_SHOWN = 60  # characters of a line that is refused
_AT_WORK = ".writing-"  # folders of files that are being written


@contextmanager
def naming(fileName: Path) -> Iterator[None]:
    """Give errors of the operating system, of a full disk for instance, the name of the file."""
    try:
        yield
    except OSError as error:
        if error.filename is None or _AT_WORK in str(error.filename):
            if error.errno is None:  # of a library, with a text of its own
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
    """Return the error of a line, counted from 1, that is not what it should be."""
    shown = received.rstrip("\n")
    shown = shown if len(shown) <= _SHOWN else shown[:_SHOWN] + "..."
    return ValueError(f"{os.fspath(fileName)}, line {number}: expected {expected}, received {shown!r}")


def numbers_of(line: str, delimiter: str | None) -> list[float] | None:
    """Return the numbers of a line, or None if something else stands there."""
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
