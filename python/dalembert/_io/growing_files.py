"""Files with results that are still being written: sensors, solutions, studies; as text, or binary solutions."""

from __future__ import annotations

import os
from array import array
from collections.abc import Sequence
from typing import IO

import numpy as np

from dalembert._checks import FloatArray
from dalembert._io.binary_solutions import MAGIC, _binary_header
from dalembert._io.result_files import ParseOutputFileHeader
from dalembert._io.solution_rows import COLUMNS

PORTION = 1 << 24  # bytes that are read at once
KNOWN = 256  # number of bytes at the start and before new data by which a file is recognised
HEADER = 20  # lines, at most
SIZES = len(MAGIC) + 10  # bytes of a binary file, with the sizes of its numbers


class GrowingFile:
    """Some columns of a file, as far as it has been written; look() reads what is new.

    A file that gets shorter, or begins with something else, is read anew; one that vanishes keeps its rows until it is
    back. `names` are those of all columns, `kind` is the type of ParseOutputFileHeader, `state` is a message on
    the file, and `skipped` the number of lines after the first row that were not rows.
    """

    def __init__(self, fileName: str, columns: Sequence[int]) -> None:
        self.fileName, self.wanted = fileName, sorted(set(columns))
        self._forget()
        self.state, self._seen = "has not been read", (-1, -1, -1)

    def _forget(self) -> None:
        self.names: list[str] = []
        self.kind, self.width, self.finished, self.skipped = "", 0, False, 0
        self._columns = {n: array("d") for n in self.wanted}
        self._header: list[str] = []
        self._first = self._last = self._rest = b""
        self._offset = self._line = 0
        self._binary = False

    @property
    def rows(self) -> int:
        """Return how many rows there are."""
        return len(self._columns[self.wanted[0]])

    def column(self, number: int) -> FloatArray:
        """Return a column."""
        return np.array(self._columns[number], dtype=float)

    def look(self) -> bool:
        """Read new rows; return whether there are any. Raises ValueError if the file has no results."""
        try:
            with open(self.fileName, "rb") as file:
                status = os.fstat(file.fileno())
                seen = status.st_ino, status.st_size, status.st_mtime_ns
                if seen == self._seen:
                    return False
                self._seen = seen
                anew = self._is_another(file, status.st_size)
                if anew:
                    self._forget()
                self._read(file)
        except FileNotFoundError:
            gone, self._seen = self._seen != (0, 0, 0), (0, 0, 0)
            self.state = "is not there"
            return gone
        self.state = self._words()
        return True

    def _is_another(self, file: IO[bytes], size: int) -> bool:
        """Return whether the bytes that have been read are there no more."""
        if size < self._offset:
            return True
        first = file.read(len(self._first))
        file.seek(max(self._offset - len(self._last), 0))
        return first != self._first or file.read(len(self._last)) != self._last

    def _read(self, file: IO[bytes]) -> None:
        file.seek(0)
        self._first = file.read(KNOWN)
        self._binary = self._first.startswith(MAGIC)
        if self._binary:
            self._take_binary(file)
        else:
            file.seek(self._offset)
            while portion := file.read(PORTION):
                self._offset += len(portion)
                self._last = (self._last + portion)[-KNOWN:]
                self._take_text(portion)
                if len(self._rest) > PORTION:
                    raise ValueError(f"{self.fileName}: no file with results, it has no lines")

    def _words(self) -> str:
        if not self.rows:
            return "has no rows yet"
        bad = f"; {self.skipped} lines were skipped" if self.skipped else ""
        return f"{self.rows} rows{', finished' if self.finished else ''}{bad}"

    # ---- text

    def _take_text(self, portion: bytes) -> None:
        *lines, self._rest = (self._rest + portion).split(b"\n")
        for line in lines:
            self._line += 1
            text = line.strip()
            if not text or text.startswith((b"#", b"functionData")):
                self._take_comment(text.decode("utf-8", "replace"))
            else:
                self._take_row(text)

    def _take_comment(self, text: str) -> None:
        if not self.rows and len(self._header) < HEADER:
            self._header.append(text)
        self.finished = self.finished or text.startswith("#simulation finished")

    def _take_row(self, text: bytes) -> None:
        entries = text.split(b",")
        if not self.width:
            self._begin(text, len(entries))
        try:
            if len(entries) != self.width:
                raise ValueError
            values = [float(entries[n]) for n in self.wanted]
        except ValueError:
            if not self.rows:
                raise self._wrong(text) from None
            self.skipped += 1
            return
        for n, value in zip(self.wanted, values, strict=True):
            self._columns[n].append(value)

    def _begin(self, text: bytes, width: int) -> None:
        """Take the width of the first row, and the names of its columns."""
        if self.wanted[-1] >= width or self.wanted[0] < 0:
            missing = next(n for n in self.wanted if not 0 <= n < width)
            try:
                [float(entry) for entry in text.split(b",")]
            except ValueError:
                raise self._wrong(text) from None
            raise ValueError(f"{self.fileName} has columns 0 to {width - 1}, but not {missing}")
        header = ParseOutputFileHeader(self._header)
        self.kind, self.names = str(header.get("type", "")), [str(name) for name in header.get("columns", [])]
        self.width = width

    def _wrong(self, text: bytes) -> ValueError:
        shown = text[:60].decode("utf-8", "replace")
        return ValueError(
            f"{self.fileName}, line {self._line}: expected numbers with commas between them, received {shown!r}; "
            "no file of sensors, solutions, or studies"
        )

    # ---- binary solutions

    def _take_binary(self, file: IO[bytes]) -> None:
        file.seek(0)
        try:
            header, int_type, real_type = _binary_header(file, self.fileName)
        except ValueError as error:
            if "ends inside" in str(error) or os.fstat(file.fileno()).st_size < SIZES:
                return  # it is being written
            raise
        if not self.width:
            sizes = [int(n) for n in header["columns"]]
            self.names = ["time"] + [f"{name}-{i}" for name, n in zip(COLUMNS, sizes, strict=True) for i in range(n)]
            self.kind = "solution"
            self._offset = file.tell()
            if self.wanted[-1] >= sum(sizes) + 1 or self.wanted[0] < 0:
                missing = next(n for n in self.wanted if not 0 <= n <= sum(sizes))
                raise ValueError(f"{self.fileName} has columns 0 to {sum(sizes)}, but not {missing}")
            self.width = sum(sizes) + 1
        row = np.dtype([("length", int_type), ("values", real_type, (self.width,))])
        file.seek(self._offset)
        left = b""
        while not left and (portion := file.read(max(PORTION // row.itemsize, 1) * row.itemsize)):
            rows = np.frombuffer(portion[: len(portion) // row.itemsize * row.itemsize], row)
            others = np.flatnonzero(rows["length"] != self.width)
            whole = int(others[0]) if len(others) else len(rows)
            for n in self.wanted:
                self._columns[n].extend(rows["values"][:whole, n].astype(float).tolist())
            self._offset += whole * row.itemsize
            left = portion[whole * row.itemsize :]
        if len(left) >= int_type.itemsize:
            length = int(np.frombuffer(left[: int_type.itemsize], int_type)[0])
            self.finished = length == -1
            if length not in (-1, self.width):
                raise ValueError(
                    f"{self.fileName}, byte {self._offset}: expected {self.width} numbers in row {self.rows}, "
                    f"received {length}; the file is damaged"
                )
