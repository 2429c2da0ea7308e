"""Checks of how PlotSensor draws, by the names of its arguments: matplotlib would refuse them in its own words."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from dalembert._checks import as_array, as_number, as_positive, check_integer, shape_error
from dalembert._plots.sensor_curves import is_empty


def check_figure(figureName: Any, sizeInches: Any, subPlot: Any) -> None:
    """Check the name of a figure, its size, and the place of a plot among others."""
    if not isinstance(figureName, str):
        raise shape_error("PlotSensor: figureName", "a text", figureName)
    expected = "two positive numbers, width and height"
    for length in _items("sizeInches", sizeInches, 2, expected):
        as_positive("PlotSensor: sizeInches", length)
    if not is_empty(subPlot):
        columns, rows, position = _items("subPlot", subPlot, 3, "[columns, rows, position]")
        for number in (columns, rows):
            check_integer("PlotSensor: subPlot", number, 1)
        check_integer("PlotSensor: subPlot", position, 1, int(columns) * int(rows))


def check_curves(colors: Sequence[Any], lines: Sequence[Any], markers: Sequence[Any]) -> None:
    """Check colors, and styles of lines and markers, one for each curve; None or empty selects those of matplotlib."""
    from matplotlib.colors import is_color_like
    from matplotlib.lines import Line2D

    _check_each("colors", colors, is_color_like, "colors of matplotlib, such as 'r', 'blue' or [1, 0, 0]")
    _check_each("lineStyles", lines, _taken(lambda style: Line2D([], [], linestyle=style)), "'-', '--', '-.' or ':'")
    marker = _taken(lambda style: Line2D([], [], marker=style.replace(" ", "")))
    _check_each("markerStyles", markers, marker, "markers of matplotlib, such as 'x' or 'o ', which is empty")


def check_numbers(widths: Sequence[Any], sizes: Sequence[Any], offsets: Sequence[Any], factors: Sequence[Any]) -> None:
    """Check widths of lines, sizes of markers, offsets and factors, one for each curve."""
    for name, values in (("lineWidths", widths), ("markerSizes", sizes)):
        for value in values:
            as_number(f"PlotSensor: {name}", value, negative=False)
    for name, values in (("offsets", offsets), ("factors", factors)):
        for value in values:
            if value is None:  # numpy would convert it to nan
                raise shape_error(f"PlotSensor: {name}", "numbers", values)
            as_array(f"PlotSensor: {name}", value)


def check_axes(ticks: dict[str, Any], ranges: dict[str, Any]) -> None:
    """Check numbers of ticks, and ranges, by the names of the arguments."""
    for name, number in ticks.items():
        check_integer(f"PlotSensor: {name}", number if isinstance(number, int) else int(number), 1)
    for name, limits in ranges.items():
        if not is_empty(limits):
            for limit in _items(name, limits, 2, "[minimum, maximum]"):
                if limit is not None:  # None: chosen by matplotlib
                    as_number(f"PlotSensor: {name}", limit)


def draw_legend(ax: Any, legendArgs: Any) -> None:
    """Draw the legend at a place, or as a dictionary of arguments says."""
    try:
        ax.legend(**(legendArgs if isinstance(legendArgs, dict) else {"loc": legendArgs}))
    except (TypeError, ValueError, AttributeError):
        expected = "a place such as 'upper left', or a dictionary of arguments of matplotlib's legend"
        raise shape_error("PlotSensor: legendArgs", expected, legendArgs) from None


def place_legend(ax: Any) -> bool:
    """Draw the legend within the axes if it hides no curve, otherwise outside: above, or to the right of a title.

    The layout of the figure has to be computed before. Returns whether the legend is outside of the axes, which
    invalidates the layout.
    """
    box = ax.legend().get_window_extent()
    curves = (line.get_transform().transform_path(line.get_path()) for line in ax.lines)
    if not any(curve.intersects_bbox(box, filled=False) for curve in curves):
        return False
    if ax.get_title():
        ax.legend(loc="upper left", bbox_to_anchor=(1, 1))
        return True
    for columns in range(len(ax.lines), 0, -1):
        box = ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncols=columns).get_window_extent()
        if box.width < ax.get_window_extent().width:
            break
    return True


def _items(name: str, value: Any, count: int, expected: str) -> list[Any]:
    try:
        found = [] if isinstance(value, str) else list(value)
    except TypeError:
        found = []
    if len(found) != count:
        raise shape_error(f"PlotSensor: {name}", expected, value)
    return found


def _check_each(name: str, values: Sequence[Any], fits: Callable[[Any], bool], expected: str) -> None:
    for value in values:
        if value is not None and not fits(value):
            raise shape_error(f"PlotSensor: {name}", expected, value)


def _taken(draw: Callable[[Any], object]) -> Callable[[Any], bool]:
    """Return whether matplotlib draws so."""

    def is_taken(style: Any) -> bool:
        try:
            draw(style)
        except (TypeError, ValueError, AttributeError):
            return False
        return True

    return is_taken
