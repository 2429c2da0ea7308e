"""A window that shows a sensor, solution or study file while it is written: python -m dalembert.resultsMonitor FILE.

Columns are plotted over each other, and again whenever the file has grown, until the window is closed.
"""

from __future__ import annotations

import argparse
import os
import time
from collections.abc import Sequence
from itertools import islice
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._io.files import file_to_read
from dalembert._io.result_files import ParseOutputFileHeader

__all__ = ["Monitor", "main"]


def _rows(fileName: str) -> tuple[FloatArray, list[str]]:
    """Return the complete rows of a file, and the names of its columns as far as its header tells them."""
    with open(fileName, encoding="utf-8", errors="replace") as file:
        header = ParseOutputFileHeader(list(islice(file, 20)))
        file.seek(0)
        lines = [line for line in file if line.endswith("\n") and line.strip() and not line.startswith("#")]
    rows: list[list[float]] = []
    for line in lines:
        try:
            row = [float(entry) for entry in line.split(",")]
        except ValueError:
            continue  # being written, or the end of a solution
        if not rows or len(row) == len(rows[0]):
            rows.append(row)
    return np.array(rows, dtype=float), [str(name) for name in header.get("columns", [])]


class Monitor:
    """A figure with a subplot per pair of columns, which update() brings up to date."""

    def __init__(
        self,
        fileName: str,
        xcols: Sequence[int] = (0,),
        ycols: Sequence[int] = (1,),
        logx: bool = False,
        logy: bool = False,
        size: tuple[float, float] = (5, 5),
        color: str = "b",
        style: str = "-",
        addMarker: bool = False,
    ) -> None:
        import matplotlib.pyplot as plt

        fileName = file_to_read("resultsMonitor: fileName", fileName, empty=True)
        xcols = list(xcols) * (len(ycols) if len(xcols) == 1 else 1)
        if len(xcols) != len(ycols):
            raise ValueError(
                f"resultsMonitor: {len(xcols)} columns for x, but {len(ycols)} for y; give as many, or one x"
            )
        self.fileName, self._pairs, self._size = fileName, list(zip(xcols, ycols, strict=True)), -1
        self.figure, axes = plt.subplots(1, len(ycols), figsize=(size[0] * len(ycols), size[1]), squeeze=False)
        self.axes = list(axes[0])
        self._lines: list[Any] = []
        for ax in self.axes:
            (line,) = ax.plot([], [], color=color, linestyle=style)
            (last,) = ax.plot([], [], "ro" if addMarker else "")
            self._lines.append((line, last))
            ax.set_xscale("log" if logx else "linear")
            ax.set_yscale("log" if logy else "linear")
            ax.grid(True)
        self.update()

    def update(self) -> bool:
        """Plot what the file has now; return whether it has changed since the last time."""
        size = os.path.getsize(self.fileName)
        if size == self._size:
            return False
        self._size = size
        data, names = _rows(self.fileName)
        for (x, y), ax, (line, last) in zip(self._pairs, self.axes, self._lines, strict=True):
            if not len(data):
                continue
            for column in (x, y):
                if not 0 <= column < data.shape[1]:
                    raise ValueError(
                        f"resultsMonitor: {self.fileName} has columns 0 to {data.shape[1] - 1}, but not {column}"
                    )
            line.set_data(data[:, x], data[:, y])
            last.set_data(data[-1:, x], data[-1:, y])
            ax.set_xlabel(names[x] if x < len(names) else f"column {x}")
            ax.set_ylabel(names[y] if y < len(names) else f"column {y}")
            ax.relim()
            ax.autoscale_view()
        self.figure.canvas.draw_idle()
        return True


def _columns(text: str) -> list[int]:
    return [int(entry) for entry in text.split(",")]


def main(arguments: Sequence[str] | None = None) -> int:
    """Show a file until its window is closed."""
    import matplotlib
    import matplotlib.pyplot as plt

    parser = argparse.ArgumentParser(prog="dalembert.resultsMonitor", description="Show a results file while it grows.")
    parser.add_argument("file")
    parser.add_argument("-xcols", type=_columns, default=[0], help="columns on the x-axes: 0,1")
    parser.add_argument("-ycols", type=_columns, default=[1], help="columns on the y-axes: 2,3")
    parser.add_argument("-logx", action="store_true")
    parser.add_argument("-logy", action="store_true")
    parser.add_argument("-addMarker", action="store_true", help="mark the last point")
    parser.add_argument("-sizex", type=float, default=5, help="width of a plot in inches")
    parser.add_argument("-sizey", type=float, default=5, help="height in inches")
    parser.add_argument("-update", type=float, default=1, help="seconds between two looks at the file")
    parser.add_argument("-color", default="b")
    parser.add_argument("-style", default="-")
    given = parser.parse_args(arguments)
    size = (given.sizex, given.sizey)
    try:
        monitor = Monitor(
            given.file,
            given.xcols,
            given.ycols,
            given.logx,
            given.logy,
            size,
            given.color,
            given.style,
            given.addMarker,
        )
    except (OSError, ValueError) as error:
        parser.exit(2, f"{error}\n")
    if matplotlib.get_backend().lower() == "agg":
        parser.exit(
            2, "resultsMonitor: there is no display for a window; plot the file by PlotSensor(None, 'file.txt')\n"
        )
    plt.show(block=False)
    while plt.fignum_exists(monitor.figure.number):
        monitor.update()
        end = time.monotonic() + given.update
        while time.monotonic() < end and plt.fignum_exists(monitor.figure.number):
            plt.pause(0.05)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
