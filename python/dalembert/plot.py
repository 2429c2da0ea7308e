"""Plots of sensors, frequency spectra and vector images with matplotlib."""

# ruff: noqa: B006  (the interface has these defaults; they are never written to)
from __future__ import annotations

import inspect
from collections.abc import Mapping, Sequence
from types import SimpleNamespace
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._calls import check_given, checked
from dalembert._checks import FloatArray, as_array, as_positive
from dalembert._io.files import file_to_write
from dalembert._io.result_files import FileStripSpaces, ParseOutputFileHeader
from dalembert._plots.images import LoadImage, PlotImage, save_figure, show_figure
from dalembert._plots.phase_and_spectrum import PlotPhase, PlotSensorFFT
from dalembert._plots.sensor_curves import (
    TIME,
    Of,
    componentNorm,
    coordinates,
    is_empty,
    is_list,
    make_curves,
    match_lengths,
    per_curve,
    shift_list,
)
from dalembert._plots.styles import check_axes, check_curves, check_figure, check_numbers, draw_legend, place_legend
from dalembert._tools.missing_names import nearest
from dalembert.advancedUtilities import PlotLineCode

__all__ = [
    "DataArrayFromSensorList",
    "FileStripSpaces",
    "LoadImage",
    "ParseOutputFileHeader",
    "PlotFFT",
    "PlotImage",
    "PlotPhase",
    "PlotSensor",
    "PlotSensorDefaults",
    "PlotSensorFFT",
    "componentNorm",
    "listMarkerStyles",
    "listMarkerStylesFilled",
]

listMarkerStylesFilled = list("x+*.dDsXPv^<>ophH")
listMarkerStyles = [style + " " for style in listMarkerStylesFilled]

_ORIGINAL_DEFAULTS: dict[str, Any] = {
    "xLabel": TIME, "yLabel": None, "fontSize": 16, "colors": [], "lineStyles": [], "lineWidths": [],
    "markerStyles": [], "markerSizes": [], "markerDensity": 0.08, "majorTicksX": 10, "majorTicksY": 10,
    "sizeInches": [6.4, 4.8],
}  # fmt: skip
_EXTRA_ARGUMENTS = {
    "minorTicksXon", "minorTicksYon", "logScaleX", "logScaleY", "fileCommentChar", "fileDelimiterChar",
    "continuousAngles",
}  # fmt: skip


class _Defaults(SimpleNamespace):
    def __repr__(self) -> str:
        return str(vars(self))


_defaults = _Defaults(**_ORIGINAL_DEFAULTS)


@checked
def PlotSensorDefaults() -> Any:
    """Return the default values of PlotSensor, as an object whose attributes may be changed for all later calls.

    An argument that equals the original default (fontSize=16) counts as not given.
    """
    return _defaults


def _default(name: str, value: Any) -> Any:
    """Return the current default instead of a value that equals the original one."""
    original = _ORIGINAL_DEFAULTS[name]
    if original == []:
        return getattr(_defaults, name) if is_empty(value) else value
    given = list(value) if is_list(value) else value
    return getattr(_defaults, name) if given == original else value


def _open_figure(plt: Any, newFigure: bool, figureName: str, subPlot: Any, sizeInches: Any) -> tuple[Any, Any]:
    """Return figure and axes to draw in."""
    if figureName:
        if newFigure and plt.fignum_exists(figureName):
            plt.close(figureName)
        figure = plt.figure(figureName)
    else:
        numbers = plt.get_fignums()
        figure = plt.figure() if newFigure or not numbers else plt.figure(numbers[-1])
    if is_empty(subPlot):
        figure.set_size_inches(*sizeInches, forward=True)
        return figure, figure.gca()
    columns, rows, position = subPlot
    figure.set_size_inches(columns * sizeInches[0], rows * sizeInches[1], forward=True)
    return figure, figure.add_subplot(rows, columns, position)


def _part_labels(figure: Any, ax: Any, ticks: int) -> None:
    """Take fewer ticks along x than there may be, until their labels stand apart; the layout has to be known."""
    from matplotlib.ticker import MaxNLocator

    for n in range(ticks, 1, -1):
        if n < ticks:
            figure.draw_without_rendering()
        boxes = [tick.label1.get_window_extent() for tick in ax.xaxis.get_major_ticks() if tick.label1.get_text()]
        gap = 0.3 * max((box.height for box in boxes), default=0)
        if all(left.x1 + gap <= right.x0 for left, right in zip(boxes, boxes[1:], strict=False)):
            return
        ax.xaxis.set_major_locator(MaxNLocator(n - 1))


def _set_axes(ax: Any, ticks: tuple[int, int], ranges: tuple[Any, Any], options: Mapping[str, Any]) -> None:
    """Set ticks, grid, scales and limits of both axes."""
    from matplotlib.ticker import AutoMinorLocator, MaxNLocator, NullLocator

    ax.grid(True, "major", "both")
    for name, axis, tick, limits in zip("xy", (ax.xaxis, ax.yaxis), ticks, ranges, strict=True):
        upper = name.upper()
        if options.get("logScale" + upper):
            getattr(ax, f"set_{name}scale")("log")
        else:
            axis.set_major_locator(MaxNLocator(tick))
        minor = options.get(f"minorTicks{upper}on")
        if minor is not None:
            axis.set_minor_locator(AutoMinorLocator() if minor else NullLocator())
        if not is_empty(limits):
            getattr(ax, f"set_{name}lim")(*limits)


def _marker_style(style: str, density: Any, points: int) -> dict[str, Any]:
    """Return matplotlib's arguments for a marker; a blank in the style makes it empty."""
    if not style:
        return {"marker": "", "markevery": None}
    every = density
    if isinstance(density, int):
        every = 1 + points // density if density else None
    fill = "none" if " " in style else "full"
    return {"marker": style.replace(" ", ""), "fillstyle": fill, "markevery": every}


def PlotSensor(
    mbs: Any,
    sensorNumbers: Any = [],
    components: Any = 0,
    xLabel: str = TIME,
    yLabel: str | None = None,
    labels: str | Sequence[str] = [],
    colorCodeOffset: int = 0,
    newFigure: bool = True,
    closeAll: bool = False,
    componentsX: Any = [],
    title: str = "",
    figureName: str = "",
    fontSize: float = 16,
    colors: Any = [],
    lineStyles: Any = [],
    lineWidths: Any = [],
    markerStyles: Any = [],
    markerSizes: Any = [],
    markerDensity: float | None = 0.08,
    rangeX: Sequence[float] = [],
    rangeY: Sequence[float] = [],
    majorTicksX: int = 10,
    majorTicksY: int = 10,
    offsets: Any = [],
    factors: Any = [],
    subPlot: Sequence[int] = [],
    sizeInches: Sequence[float] = [6.4, 4.8],
    fileName: str = "",
    useXYZcomponents: bool = True,
    legendArgs: Any = None,
    **kwargs: Any,
) -> list[Any]:
    """Plot values of sensors over time or over each other; return [pyplot, figure, axes, lines].

    Data:
        sensorNumbers: sensors (indices or names), names of sensor or solution files, or arrays with rows [time,
            values]; one or a list. Sensors need storeInternal=True or a file.
        components: number of the value per curve; -1: time, `componentNorm`: norm of all values. One component for
            several sensors, or several components of one sensor, are fine.
        componentsX: likewise for the x-axis; default: time.
        factors, offsets: y = factor * (value + offset); one for all or a list. An offset may be an array like the
            data of its sensor, e.g. to plot differences.
    Style:
        xLabel, yLabel, title, labels, fontSize, legendArgs: texts; legendArgs is a location or a dict of arguments.
            By default, the legend is outside of the axes if it would hide a curve within.
        colors, lineStyles, lineWidths, markerStyles, markerSizes: matplotlib's codes, one for all or a list; a blank
            in a marker style makes it empty. PlotLineCode(curve + colorCodeOffset) selects default colors.
        markerDensity: number of markers (int), distance relative to the diagonal (float) or one per point (None).
        rangeX, rangeY: [minimum, maximum]; majorTicksX, majorTicksY: largest number of ticks.
        useXYZcomponents: write X, Y, Z instead of 0, 1, 2 where it applies.
        newFigure, figureName, closeAll, subPlot=[columns, rows, position], sizeInches (per subplot): the figure.
        fileName: save the figure, e.g. as .pdf or .png.
        kwargs: minorTicksXon, minorTicksYon, logScaleX, logScaleY (bool), fileCommentChar, fileDelimiterChar (of
            files; default '#' and ','), continuousAngles (True: rotations go on beyond pi instead of jumping).

    Several systems are compared if mbs is a list: PlotSensor([mbs, other], 'tip'). The axes show the units of
    sensors, unless factors change that of y.
    """
    import matplotlib.pyplot as plt

    unknown = sorted(set(kwargs) - _EXTRA_ARGUMENTS)
    if unknown:
        raise ValueError(
            f"PlotSensor: unknown argument {unknown[0]!r}"
            + (
                nearest(unknown[0], inspect.signature(PlotSensor).parameters)
                or f"; further arguments are {sorted(_EXTRA_ARGUMENTS)}"
            )
        )
    style = {name: _default(name, value) for name, value in locals().items() if name in _ORIGINAL_DEFAULTS}
    if is_list(mbs):
        single = sensorNumbers if is_list(sensorNumbers) else [sensorNumbers]
        sensorNumbers = [Of(system, sensor, i) for i, system in enumerate(mbs) for sensor in single]
    if not isinstance(colorCodeOffset, (int, np.integer)):
        expected = "an integer, of the first color; colors=['red'] chooses colors by name"
        raise TypeError(f"PlotSensor: colorCodeOffset: received {colorCodeOffset!r}, but expected {expected}")
    check_given(PlotSensor, locals().items())
    if fileName not in ("", None):  # said before anything is drawn
        fileName = file_to_write("PlotSensor: fileName", fileName, newFolder=True)
    as_positive("PlotSensor: fontSize", style["fontSize"])
    check_figure(figureName, style["sizeInches"], subPlot)
    check_axes({name: style[name] for name in ("majorTicksX", "majorTicksY")}, {"rangeX": rangeX, "rangeY": rangeY})
    matched = match_lengths(sensorNumbers, components, componentsX)
    n = len(matched)
    if closeAll:
        plt.close("all")
    plt.rcParams.update({"font.size": style["fontSize"]})
    if n == 0:
        return [plt, None, None, None]

    comments, delimiter = kwargs.get("fileCommentChar", "#"), kwargs.get("fileDelimiterChar", ",")
    angles = kwargs.get("continuousAngles", False)
    curves = make_curves(mbs, matched, useXYZcomponents, comments, delimiter, angles)
    names = per_curve("labels", labels, n, None, (str,) if n == 1 else ())
    shifts, scales = shift_list("offsets", offsets, n, 0.0), shift_list("factors", factors, n, 1.0)
    numbers = (int, float, np.number)
    color_list = per_curve("colors", style["colors"], n, None, (str,))
    line_styles = per_curve("lineStyles", style["lineStyles"], n, None, (str,))
    line_widths = per_curve("lineWidths", style["lineWidths"], n, 1, numbers)
    marker_styles = per_curve("markerStyles", style["markerStyles"], n, "", (str,))
    marker_sizes = per_curve("markerSizes", style["markerSizes"], n, 6, numbers)

    check_curves(color_list, line_styles, marker_styles)
    check_numbers(line_widths, marker_sizes, shifts, scales)
    figure, ax = _open_figure(plt, newFigure, figureName, subPlot, style["sizeInches"])
    points = [coordinates(*each) for each in zip(curves, shifts, scales, strict=True)]
    line = None
    for i, (curve, (x, y)) in enumerate(zip(curves, points, strict=True)):
        code = PlotLineCode(i + colorCodeOffset)
        line = ax.plot(
            x,
            y,
            color=code[0] if color_list[i] is None else color_list[i],
            linestyle=code[1:] if line_styles[i] is None else line_styles[i],
            linewidth=line_widths[i],
            markersize=marker_sizes[i],
            label=curve.label if names[i] is None else names[i],
            **_marker_style(marker_styles[i], style["markerDensity"], len(x)),
        )
    across = ", ".join(dict.fromkeys(curve.title_x for curve in curves))
    ax.set_xlabel(across if style["xLabel"] == TIME else style["xLabel"])
    scaled = any(np.ndim(factor) or factor != 1 for factor in scales)  # then the unit is another one
    with_units = {curve.variable for curve in curves if curve.unit}  # files have no units
    variables = [
        curve.variable if scaled else curve.title for curve in curves if curve.unit or curve.variable not in with_units
    ]
    ax.set_ylabel(style["yLabel"] or ", ".join(dict.fromkeys(variables)))
    if title:
        ax.set_title(title)
    _set_axes(ax, (style["majorTicksX"], style["majorTicksY"]), (rangeX, rangeY), kwargs)
    if legendArgs is not None:
        draw_legend(ax, legendArgs)
    figure.tight_layout()
    if legendArgs is None and ax.get_legend_handles_labels()[0] and place_legend(ax):
        figure.tight_layout()
    if not kwargs.get("logScaleX"):
        _part_labels(figure, ax, style["majorTicksX"])
    show_figure(plt, figure)
    save_figure(figure, fileName, "PlotSensor")
    return [plt, figure, ax, line]


@checked
def PlotFFT(
    frequency: npt.ArrayLike,
    data: npt.ArrayLike,
    xLabel: str = "frequency",
    yLabel: str = "magnitude",
    label: str = "",
    freqStart: float = 0,
    freqEnd: float = -1,
    logScaleX: bool = True,
    logScaleY: bool = True,
    majorGrid: bool = True,
    minorGrid: bool = True,
) -> Any:
    """Plot a spectrum, e.g. from ComputeFFT, into the current figure; return pyplot.

    frequency: n frequencies, in Hz if time was in s; data: n magnitudes or phases. Only frequencies from freqStart to
    freqEnd are shown (freqEnd=-1: all). A label makes a legend.
    """
    import matplotlib.pyplot as plt
    from matplotlib.ticker import MaxNLocator

    f, values = as_array("PlotFFT: frequency", frequency), as_array("PlotFFT: data", data)
    if f.ndim != 1 or f.shape != values.shape:
        raise ValueError(f"PlotFFT: frequency and data must be vectors of one length, not {f.shape} and {values.shape}")
    shown = (f >= freqStart) & ((f <= freqEnd) if freqEnd != -1 else True)
    ax = plt.gca()
    ax.plot(f[shown], values[shown], label=label or None)
    if label:
        ax.legend()
    ax.set_xlabel(xLabel)
    ax.set_ylabel(yLabel)
    for axis, set_scale, logarithmic in ((ax.xaxis, ax.set_xscale, logScaleX), (ax.yaxis, ax.set_yscale, logScaleY)):
        if logarithmic:
            set_scale("log")
        else:
            axis.set_major_locator(MaxNLocator(10))
    ax.minorticks_on()
    if majorGrid:
        ax.grid(visible=True, which="major", color="k", linestyle="-")
    if minorGrid:
        ax.grid(visible=True, which="minor", color="k", linestyle=":")
    figure = ax.get_figure()
    plt.tight_layout()
    show_figure(plt, figure)
    return plt


@checked
def DataArrayFromSensorList(
    mbs: Any, sensorNumbers: Sequence[Any], positionList: Sequence[float] = [], time: Any = ""
) -> FloatArray:
    """Return an array with one row per sensor: its position, followed by its current values.

    positionList: e.g. the axial positions of the sensors along a beam; default: 0, 1, 2, ... The time must be ''
    (current values).
    """
    if time != "":
        raise ValueError(f"DataArrayFromSensorList: time must be '' (current values), not {time!r}")
    positions = list(range(len(sensorNumbers))) if is_empty(positionList) else list(positionList)
    if len(positions) != len(sensorNumbers):
        raise ValueError(
            f"DataArrayFromSensorList: {len(sensorNumbers)} sensorNumbers, but {len(positions)} entries in positionList"
        )
    rows = [
        np.append(position, mbs.GetSensorValues(sensor))
        for position, sensor in zip(positions, sensorNumbers, strict=True)
    ]
    sizes = {row.size - 1 for row in rows}
    if len(sizes) > 1:
        raise ValueError(f"DataArrayFromSensorList: sensors must have equally many values, not {sorted(sizes)}")
    return np.array(rows, dtype=float)
