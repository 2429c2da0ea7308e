"""Rows of numbers that are recorded one after the other, such as the states of a motion."""

from __future__ import annotations

import math
import tempfile
from collections.abc import Iterator
from typing import Any

import numpy as np

from dalembert._checks import FloatArray

_BLOCK = 256  # rows that are read together


class Rows:
    """Rows of equal width, read by number or by slice. Those that would take too much memory go to a temporary file.

    maximum: bytes in memory; largest: largest magnitude in each column.
    """

    def __init__(self, width: int, maximum: float = math.inf) -> None:
        self.width, self._maximum = width, maximum
        self.largest: FloatArray = np.zeros(width)
        self._kept: list[FloatArray] = []
        self._file: Any = None
        self._count = 0

    def __del__(self) -> None:
        if self._file is not None:
            self._file.close()

    @staticmethod
    def of(row: FloatArray) -> Rows:
        """Return a single row."""
        made = Rows(len(row))
        made.append(row)
        return made

    def append(self, row: FloatArray) -> None:
        np.maximum(self.largest, np.abs(row), out=self.largest)
        if self._file is None and 8 * self.width * (self._count + 1) > self._maximum:
            self._file = tempfile.TemporaryFile()  # noqa: SIM115  (it lives as long as this object)
            for each in self._kept:
                self._file.write(each.tobytes())
            self._kept = []
        if self._file is None:
            self._kept.append(row)
        else:
            self._file.write(row.tobytes())
        self._count += 1

    def __len__(self) -> int:
        """Return the number of rows."""
        return self._count

    def __getitem__(self, key: int | slice) -> FloatArray:
        """Return a row, or the rows of a slice."""
        if not isinstance(key, slice):
            return self[key : key + 1 or self._count][0]
        begin, end, _ = key.indices(self._count)
        found = np.empty((max(end - begin, 0), self.width))
        if self._file is None:
            found[:] = self._kept[begin:end] if found.size else 0.0
            return found
        if found.size:
            self._file.seek(8 * self.width * begin)
            self._file.readinto(found.data.cast("B"))
        return found

    def blocks(self, begin: int = 0) -> Iterator[slice]:
        """Yield slices of some rows each, from a row to the last one."""
        for first in range(begin, self._count, _BLOCK):
            yield slice(first, min(first + _BLOCK, self._count))
