"""Plots of two sensors over each other, and of the spectrum of a sensor."""

from __future__ import annotations

from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._plots.images import save_figure, show_figure
from dalembert._plots.sensor_curves import Curve, coordinates, make_curves


def _curve(mbs: Any, sensor: Any, component: int, where: str) -> tuple[Curve, FloatArray, FloatArray]:
    (curve,) = make_curves(mbs, [(sensor, component, -1)], True, "#", ",", continuousAngles=True)
    time, values = coordinates(curve, 0.0, 1.0)
    if len(time) < 2:
        raise ValueError(f"{where}: {curve.name} has {len(time)} rows, too few for a curve")
    return curve, time, values


def PlotPhase(
    mbs: Any, sensorX: Any, sensorY: Any, componentX: int = 0, componentY: int = 0, fileName: str = "", ax: Any = None
) -> Any:
    """Plot a component of one sensor over that of another, such as velocity over position; return the axes.

    sensorX, sensorY: indices or names, files or arrays, as of PlotSensor. Angles are continuous. ax: axes to draw in.
    """
    import matplotlib.pyplot as plt

    (x_curve, x_time, x), (y_curve, y_time, y) = (
        _curve(mbs, sensor, component, "PlotPhase")
        for sensor, component in ((sensorX, componentX), (sensorY, componentY))
    )
    if len(x_time) != len(y_time) or not np.allclose(x_time, y_time):
        raise ValueError(f"PlotPhase: {x_curve.name} and {y_curve.name} have values at different times")
    own = ax is None
    ax = plt.subplots()[1] if own else ax
    ax.plot(x, y)
    ax.set(xlabel=_title(x_curve), ylabel=_title(y_curve))
    ax.grid(True)
    return _shown(plt, ax, fileName, own, "PlotPhase")


def PlotSensorFFT(mbs: Any, sensor: Any, component: int = 0, fileName: str = "", ax: Any = None) -> Any:
    """Plot the amplitudes of the frequencies in a sensor; return the axes.

    sensor: its values have to be evenly spaced in time; an index or name, a file or an array, as of PlotSensor.
    """
    import matplotlib.pyplot as plt

    from dalembert.signalProcessing import ComputeFFT  # needs scipy

    curve, time, values = _curve(mbs, sensor, component, "PlotSensorFFT")
    steps = np.diff(time)
    if np.abs(steps - steps.mean()).max() > 1e-3 * steps.mean():
        raise ValueError(
            f"PlotSensorFFT: {curve.name} has steps from {steps.min():g} to {steps.max():g} s; set sensorsWritePeriod "
            "and constant steps, or interpolate"
        )
    frequency, magnitude, _ = ComputeFFT(time, values)
    own = ax is None
    ax = plt.subplots()[1] if own else ax
    ax.plot(frequency, magnitude)
    ax.set(xlabel="frequency (Hz)", ylabel=f"amplitude of {_title(curve)}")
    ax.grid(True)
    return _shown(plt, ax, fileName, own, "PlotSensorFFT")


def _title(curve: Curve) -> str:
    unit = f" ({curve.unit})" if curve.unit else ""
    return curve.label + unit


def _shown(plt: Any, ax: Any, fileName: str, own: bool, where: str) -> Any:
    figure = ax.get_figure()
    if own:
        figure.tight_layout()
        show_figure(plt, figure)
    save_figure(figure, fileName, where)
    return ax
