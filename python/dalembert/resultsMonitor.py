"""A window, or a page in the browser, that shows a sensor, solution or study file while it is written.

Call it by: dalembert monitor FILE, or python -m dalembert.resultsMonitor FILE. Columns are plotted over each other,
and again whenever the file has grown, until the window is closed.
"""

from __future__ import annotations

import argparse
import itertools
import os
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._io.files import file_name, file_to_read
from dalembert._io.growing_files import GrowingFile

__all__ = ["Monitor", "main"]

POINTS = 2000  # points of a curve on a page
STYLES = ("-", "--", "-.", ":")


@dataclass
class Curve:
    """Plotted data: a name, "" for a single curve, and points."""

    name: str
    x: FloatArray
    y: FloatArray


class Plots:
    """The curves of a file, a list for each pair of columns."""

    def __init__(
        self,
        fileName: str,
        xcols: Sequence[int],
        ycols: Sequence[int],
        colorVariations: bool = False,
        variations: tuple[int, int] | None = None,
        wait: bool = False,
    ) -> None:
        argument = "resultsMonitor: fileName"
        self.fileName = file_name(argument, fileName) if wait else file_to_read(argument, fileName, empty=True)
        xcols = list(xcols) * (len(ycols) if len(xcols) == 1 else 1)
        if len(xcols) != len(ycols):
            raise ValueError(
                f"resultsMonitor: {len(xcols)} columns for x, but {len(ycols)} for y; give as many, or one x"
            )
        self.pairs = list(zip(xcols, ycols, strict=True))
        self._separate, self._chosen = colorVariations, variations
        self._file = self._opened([])
        self._look()

    def _opened(self, more: Sequence[int]) -> GrowingFile:
        return GrowingFile(self.fileName, [*itertools.chain(*self.pairs), *more])

    @property
    def state(self) -> str:
        """Return a message on the state of the file."""
        return self._file.state

    def look(self) -> bool:
        """Read new rows; return whether there are any. The state reports that the file has been replaced."""
        try:
            return self._look()
        except ValueError as error:
            self._file.state = str(error)
            return True

    def _look(self) -> bool:
        if not self._file.look():
            return False
        others = self._others()
        if not set(others) <= set(self._file.wanted):
            self._file = self._opened(others)
            self._file.look()
        return True

    def _others(self) -> list[int]:
        """Return the columns of the varied parameters, but for the first of them."""
        varied = self._separate and self._file.kind == "parameterVariation"
        return list(range(3, self._file.width)) if varied else []

    def label(self, column: int) -> str:
        """Return the name of a column."""
        names = self._file.names
        return names[column] if column < len(names) else f"column {column}"

    def curves(self) -> list[list[Curve]]:
        """Return the curves of each pair of columns."""
        file, others = self._file, self._others()
        if not file.rows:
            return [[] for _ in self.pairs]
        groups = [("", np.arange(file.rows))]
        if others:
            values, which = np.unique(np.column_stack([file.column(n) for n in others]), axis=0, return_inverse=True)
            names = [", ".join(f"{self.label(n)} = {v:g}" for n, v in zip(others, row, strict=True)) for row in values]
            groups = [(name, np.flatnonzero(which.ravel() == k)) for k, name in enumerate(names)]
            groups = groups[slice(*self._chosen)] if self._chosen else groups
        return [
            [Curve(name, file.column(x)[rows], file.column(y)[rows]) for name, rows in groups] for x, y in self.pairs
        ]


class Monitor:
    """A figure with a subplot per pair of columns, updated by update().

    colorVariations: the file of a parameter variation has a curve over its first parameter for each combination of
    the other ones; `variations` (begin, end) selects some. `wait`: the file need not exist yet.
    """

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
        colorVariations: bool = False,
        variations: tuple[int, int] | None = None,
        wait: bool = False,
    ) -> None:
        import matplotlib.pyplot as plt

        self.plots = Plots(fileName, xcols, ycols, colorVariations, variations, wait)
        count = len(self.plots.pairs)
        self.figure, axes = plt.subplots(1, count, figsize=(size[0] * count, size[1]), squeeze=False)
        self.axes = list(axes[0])
        self._color, self._style, self._marks = color, style, addMarker
        self._lines: list[list[Any]] = [[] for _ in self.axes]
        for ax in self.axes:
            ax.set_xscale("log" if logx else "linear")
            ax.set_yscale("log" if logy else "linear")
            ax.grid(True)
        self._draw()

    def update(self) -> bool:
        """Plot what the file has now; return whether it has changed since the last time."""
        if not self.plots.look():
            return False
        self._draw()
        return True

    def _draw(self) -> None:
        curves = self.plots.curves()
        for (x, y), ax, lines, wanted in zip(self.plots.pairs, self.axes, self._lines, curves, strict=True):
            while len(lines) > len(wanted):
                for line in lines.pop():
                    line.remove()
            while len(lines) < len(wanted):
                lines.append(self._line(ax, len(lines), len(wanted)))
            for (line, last), curve in zip(lines, wanted, strict=True):
                line.set_data(curve.x, curve.y)
                line.set_label(curve.name)
                last.set_data(curve.x[-1:], curve.y[-1:])
            ax.set_xlabel(self.plots.label(x))
            ax.set_ylabel(self.plots.label(y))
            if wanted and wanted[0].name:
                ax.legend()
            ax.relim()
            ax.autoscale_view()
        self.figure.suptitle(f"{os.path.basename(self.plots.fileName)}: {self.plots.state}", fontsize="small")
        self.figure.canvas.draw_idle()

    def _line(self, ax: Any, number: int, count: int) -> tuple[Any, Any]:
        color = self._color if count == 1 else f"C{number % 10}"
        style = self._style if count == 1 else STYLES[number // 10 % len(STYLES)]
        (line,) = ax.plot([], [], color=color, linestyle=style)
        (last,) = ax.plot([], [], "ro" if self._marks else "")
        return line, last


class PageMonitor:
    """The same in the browser: pages of this machine show the curves, and get them anew whenever the file has grown."""

    def __init__(self, plots: Plots, logx: bool = False, logy: bool = False, addMarker: bool = False) -> None:
        from dalembert._live.opening import wanted_port
        from dalembert._live.server import PageServer

        self.plots, self._log, self._marks = plots, (logx, logy), addMarker
        self.server = PageServer(self._receive, wanted_port(), "monitor")
        self._message = self._made()

    def _receive(self, page: int, message: dict[str, Any]) -> None:
        if message["kind"] == "opened":
            self.server.tell(self._message, page)

    def update(self) -> bool:
        """Show what the file has now; return whether it has changed since the last time."""
        if not self.plots.look():
            return False
        self._message = self._made()
        self.server.tell(self._message)
        return True

    def _made(self) -> dict[str, Any]:
        name, (logx, logy) = os.path.basename(self.plots.fileName), self._log
        plots = []
        for (x, y), curves in zip(self.plots.pairs, self.plots.curves(), strict=True):
            points = [{"name": c.name, **dict(zip("xy", thinned(c.x, c.y), strict=True))} for c in curves]
            labels = {"xLabel": self.plots.label(x), "yLabel": self.plots.label(y)}
            plots.append({**labels, "logx": logx, "logy": logy, "marks": self._marks, "curves": points})
        return {"kind": "curves", "title": name, "state": self.plots.state, "plots": plots}


def thinned(x: FloatArray, y: FloatArray, most: int = POINTS) -> tuple[list[float | None], list[float | None]]:
    """Return some of many points, including the lowest and the highest of each group; None for values that are not
    finite."""
    if len(x) > most:
        groups = np.array_split(np.arange(len(x)), most // 4)
        finite = np.where(np.isfinite(y), y, np.nan)
        chosen = {0, len(x) - 1}
        for group in groups:
            part = finite[group]
            known = np.flatnonzero(~np.isnan(part))
            ends = [0, len(group) - 1]
            ends += [known[np.argmin(part[known])], known[np.argmax(part[known])]] if len(known) else []
            chosen.update(int(group[k]) for k in ends)
        rows = sorted(chosen)
        x, y = x[rows], y[rows]
    return _numbers(x), _numbers(y)


def _numbers(values: FloatArray) -> list[float | None]:
    return [value if np.isfinite(value) else None for value in values.tolist()]


def _columns(text: str) -> list[int]:
    return [int(entry) for entry in text.split(",")]


def _range(text: str) -> tuple[int, int]:
    begin, end = _columns(text)
    return begin, end


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options of the monitor to a parser."""
    parser.add_argument("file", help="of a sensor, a solution, or a study")
    parser.add_argument(
        "-xcols", "-x", "--x-cols", dest="xcols", type=_columns, default=[0], help="columns on the x-axes: 0,1"
    )
    parser.add_argument(
        "-ycols", "-y", "--y-cols", dest="ycols", type=_columns, default=[1], help="columns on the y-axes: 2,3"
    )
    parser.add_argument("-logx", "--log-x", dest="logx", action="store_true", help="logarithmic x-axes")
    parser.add_argument("-logy", "--log-y", dest="logy", action="store_true", help="logarithmic y-axes")
    parser.add_argument(
        "-colorVariations",
        "--color-variations",
        dest="colorVariations",
        action="store_true",
        help="a curve for each variation of other parameters",
    )
    parser.add_argument(
        "-variations",
        "--variations",
        dest="variations",
        type=_range,
        default=None,
        help="first one and the one after the last: 0,2",
    )
    parser.add_argument("-addMarker", "--marker", dest="addMarker", action="store_true", help="mark the last point")
    parser.add_argument("-sizex", "--size-x", dest="sizex", type=float, default=5, help="width of a plot in inches")
    parser.add_argument("-sizey", "--size-y", dest="sizey", type=float, default=5, help="height in inches")
    parser.add_argument(
        "-update", "-u", "--update", dest="update", type=float, default=1, help="seconds between two looks at the file"
    )
    parser.add_argument(
        "-color", "--color", dest="color", default="b", help="of the line in a window, as matplotlib names it"
    )
    parser.add_argument(
        "-style", "--style", dest="style", default="-", help="of the line in a window, as matplotlib names it"
    )
    parser.add_argument(
        "-browser", action="store_true", help="show it in the browser, although a window could be opened"
    )
    parser.add_argument("-wait", action="store_true", help="wait until the file is there")


def main(arguments: Sequence[str] | None = None) -> int:
    """Show a file until its window, or page, is closed."""
    parser = argparse.ArgumentParser(prog="dalembert.resultsMonitor", description="Show a results file while it grows.")
    add_arguments(parser)
    return show(parser.parse_args(arguments), parser)


def show(given: argparse.Namespace, parser: argparse.ArgumentParser) -> int:
    """Show the monitor according to the arguments."""
    import matplotlib

    from dalembert._pictures.showing import where_pages_open

    try:
        if matplotlib.get_backend().lower() != "agg" and not given.browser:
            return _in_window(given)
        plots, where = Plots(*_wanted(given)), where_pages_open()
        if where == "nowhere":
            plain = (
                "plot the file by PlotSensor(None, 'file.txt'), or set DALEMBERT_VIEWER=on for the address of a page"
            )
            raise ValueError(f"resultsMonitor: there is no display for a window; {plain}")
        return _in_browser(plots, given, where)
    except KeyboardInterrupt:
        return 0
    except (OSError, ValueError) as error:
        parser.exit(2, f"{error}\n")


def _wanted(given: argparse.Namespace) -> tuple[Any, ...]:
    return given.file, given.xcols, given.ycols, given.colorVariations, given.variations, given.wait


def _in_window(given: argparse.Namespace) -> int:
    import matplotlib.pyplot as plt

    name, x, y, *choice = _wanted(given)
    size = (given.sizex, given.sizey)
    monitor = Monitor(name, x, y, given.logx, given.logy, size, given.color, given.style, given.addMarker, *choice)
    plt.show(block=False)
    _repeat(monitor.update, given.update, lambda: plt.fignum_exists(monitor.figure.number), plt.pause)
    return 0


def _in_browser(plots: Plots, given: argparse.Namespace, where: str) -> int:
    from dalembert._live import opening

    monitor = PageMonitor(plots, given.logx, given.logy, given.addMarker)
    opening.bring(monitor.server, where)
    seen = time.monotonic() + opening.PATIENCE[where]

    def is_open() -> bool:
        nonlocal seen
        if monitor.server.pages:
            seen = time.monotonic() + opening.RETURN
        return time.monotonic() < seen

    _repeat(monitor.update, given.update, is_open, time.sleep)
    monitor.server.stop()
    return 0


def _repeat(
    update: Callable[[], bool], period: float, is_open: Callable[[], bool], wait: Callable[[float], None]
) -> None:
    """Look at the file now and then, as long as somebody looks at it."""
    while is_open():
        update()
        end = time.monotonic() + period
        while time.monotonic() < end and is_open():
            wait(0.05)


if __name__ == "__main__":
    raise SystemExit(main())
