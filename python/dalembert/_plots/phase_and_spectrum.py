"""Plots of two sensors over each other, and of the spectrum of a sensor."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from dalembert._calls import checked
from dalembert._checks import FloatArray, shape_error
from dalembert._plots.images import save_figure, show_figure
from dalembert._plots.sensor_curves import Curve, Of, coordinates, is_list, make_curves


class _Measured(NamedTuple):
    """A component of a sensor over time."""

    curve: Curve
    time: FloatArray
    values: FloatArray


def _curves(mbs: Any, sensor: Any, component: int, where: str) -> list[_Measured]:
    """Return the curve of a sensor, one for each system of a list; where: the function and its argument."""
    if is_list(mbs) and len(mbs) == 0:
        raise shape_error(f"{where.partition(':')[0]}: mbs", "a system, or a list of some", mbs)
    sensors = [Of(system, sensor, i) for i, system in enumerate(mbs)] if is_list(mbs) else [sensor]
    found = []
    matched = [(each, component, -1) for each in sensors]
    for curve in make_curves(mbs, matched, True, "#", ",", continuousAngles=True, where=where):
        time, values = coordinates(curve, 0.0, 1.0)
        if len(time) < 2:
            raise ValueError(f"{where}: {curve.name} has {len(time)} rows, too few for a curve")
        found.append(_Measured(curve, time, values))
    return found


@checked
def PlotPhase(
    mbs: Any, sensorX: Any, sensorY: Any, componentX: int = 0, componentY: int = 0, fileName: str = "", ax: Any = None
) -> Any:
    """Plot a component of one sensor over that of another, such as velocity over position; return the axes.

    mbs: a system, or a list of systems to compare. sensorX, sensorY: indices or names, files or arrays, as of
    PlotSensor. Angles are continuous. ax: axes to draw in.
    """
    import matplotlib.pyplot as plt

    pairs = list(
        zip(
            _curves(mbs, sensorX, componentX, "PlotPhase: sensorX"),
            _curves(mbs, sensorY, componentY, "PlotPhase: sensorY"),
            strict=True,
        )
    )
    for x, y in pairs:
        if len(x.time) != len(y.time) or not np.allclose(x.time, y.time):
            raise ValueError(f"PlotPhase: {x.curve.name} and {y.curve.name} have values at different times")
    own, ax = ax is None, _axes(plt, ax, "PlotPhase")
    for i, (x, y) in enumerate(pairs):
        ax.plot(x.values, y.values, label=f"system {i}")
    ax.set(xlabel=_title(pairs[0][0].curve), ylabel=_title(pairs[0][1].curve))
    return _shown(plt, ax, fileName, own, len(pairs), "PlotPhase")


@checked
def PlotSensorFFT(mbs: Any, sensor: Any, component: int = 0, fileName: str = "", ax: Any = None) -> Any:
    """Plot the amplitudes of the frequencies in a sensor; return the axes.

    mbs: a system, or a list of systems to compare. sensor: an index or name, a file or an array, as of PlotSensor; its
    values have to be evenly spaced in time.
    """
    import matplotlib.pyplot as plt

    from dalembert.signalProcessing import ComputeFFT  # needs scipy

    measured = _curves(mbs, sensor, component, "PlotSensorFFT: sensor")
    for curve, time, _ in measured:
        steps = np.diff(time)
        if np.abs(steps - steps.mean()).max() > 1e-3 * steps.mean():
            raise ValueError(
                f"PlotSensorFFT: {curve.name} has steps from {steps.min():g} to {steps.max():g} s; set "
                "sensorsWritePeriod and constant steps, or interpolate"
            )
    own, ax = ax is None, _axes(plt, ax, "PlotSensorFFT")
    for i, (_, time, values) in enumerate(measured):
        frequency, magnitude, _ = ComputeFFT(time, values)
        ax.plot(frequency, magnitude, label=f"system {i}")
    ax.set(xlabel="frequency (Hz)", ylabel=f"amplitude of {_title(measured[0].curve)}")
    return _shown(plt, ax, fileName, own, len(measured), "PlotSensorFFT")


def _axes(plt: Any, ax: Any, where: str) -> Any:
    """Return axes to draw in: the given ones, or new ones."""
    if ax is None:
        return plt.subplots()[1]
    if not all(hasattr(ax, name) for name in ("plot", "get_figure")):
        raise shape_error(f"{where}: ax", "axes of matplotlib, such as plt.subplots() has", ax)
    return ax


def _title(curve: Curve) -> str:
    unit = f" ({curve.unit})" if curve.unit else ""
    return curve.label.replace(" of system 0", "") + unit


def _shown(plt: Any, ax: Any, fileName: str, own: bool, curves: int, where: str) -> Any:
    figure = ax.get_figure()
    ax.grid(True)
    if curves > 1:
        ax.legend()
    if own:
        figure.tight_layout()
        show_figure(plt, figure)
    save_figure(figure, fileName, where)
    return ax
