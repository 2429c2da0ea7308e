"""Filtering, differentiation, Fourier transform and interpolation of sampled signals. Times in s, frequencies in Hz."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import numpy.typing as npt
from scipy.signal import savgol_filter

from dalembert._checks import FloatArray, as_array, as_vector, shape_error


def _differences(where: str, x: FloatArray, forward: Any, backward: Any, derivative: int, central: bool) -> FloatArray:
    """Return finite differences of a signal, with the time steps after and before each sample."""
    if derivative == 1:
        ahead = np.diff(x, append=x[-1]) / forward
        return 0.5 * (ahead + np.diff(x, prepend=x[0]) / backward) if central else ahead
    if derivative != 2:
        raise shape_error(f"{where}: derivative", "1 or 2, if filterWindow is 0", derivative)
    second = np.diff(x, n=2, prepend=x[0], append=x[-1]) / forward**2
    if len(x) > 2:
        second[0], second[-1] = second[1], second[-2]
    return second


def _filtered(
    where: str,
    x: FloatArray,
    forward: Any,
    backward: Any,
    filterWindow: int,
    polyOrder: int,
    derivative: int,
    central: bool,
) -> FloatArray:
    if filterWindow == 0:
        if derivative != 0:
            return _differences(where, x, forward, backward, derivative, central)
        warnings.warn(f"{where}: neither filterWindow nor derivative is given, the signal is unchanged", stacklevel=3)
        return x.copy()
    if filterWindow % 2 != 1 or filterWindow < 1:
        raise shape_error(f"{where}: filterWindow", "0 or an odd number", filterWindow)
    smooth = savgol_filter(x, window_length=filterWindow, polyorder=polyOrder, deriv=derivative)
    return smooth / forward**derivative if derivative > 0 else smooth


def FilterSensorOutput(
    signal: npt.ArrayLike,
    filterWindow: int = 5,
    polyOrder: int = 3,
    derivative: int = 0,
    centralDifferentiate: bool = True,
) -> FloatArray:
    """Return a matrix like signal (time in column 0) with filtered or differentiated further columns.

    A Savitzky-Golay filter of odd window length and polyOrder is used; filterWindow = 0 takes finite differences for
    the first (central or forward) and second derivative.
    """
    data = as_array("FilterSensorOutput: signal", signal).copy()
    if data.ndim != 2 or data.shape[1] < 2:
        raise shape_error("FilterSensorOutput: signal", "a matrix with time and at least one more column", signal)
    steps = np.diff(data[:, 0])
    forward, backward = np.append(steps, steps[-1]), np.append(steps[0], steps)
    for column in data.T[1:]:
        column[:] = _filtered(
            "FilterSensorOutput",
            column.copy(),
            forward,
            backward,
            filterWindow,
            polyOrder,
            derivative,
            centralDifferentiate,
        )
    return data


def FilterSignal(
    signal: npt.ArrayLike,
    samplingRate: float = -1,
    filterWindow: int = 5,
    polyOrder: int = 3,
    derivative: int = 0,
    centralDifferentiate: bool = True,
) -> FloatArray:
    """Return a filtered or differentiated vector; samplingRate is the time step, needed for derivatives only.

    Filter and differences are those of FilterSensorOutput.
    """
    x = as_vector("FilterSignal: signal", signal)
    if derivative != 0 and samplingRate <= 0:
        raise shape_error("FilterSignal: samplingRate", "a positive time step for a derivative", samplingRate)
    where, dt = "FilterSignal", samplingRate
    return _filtered(where, x, dt, dt, filterWindow, polyOrder, derivative, centralDifferentiate)


def ComputeFFT(time: npt.ArrayLike, data: npt.ArrayLike) -> list[FloatArray]:
    """Return [frequency, magnitude, phase] of real data at equidistant times, up to half the sampling frequency.

    The magnitude of a frequency is its amplitude in the signal (twice the mean at frequency 0); phases are in rad.
    """
    t, x = as_vector("ComputeFFT: time", time), as_vector("ComputeFFT: data", data)
    if len(t) != len(x) or len(t) < 2:
        raise shape_error("ComputeFFT: data", f"a vector with as many (>= 2) entries as time, {len(t)}", data)
    n = len(x) // 2 + 1
    transform = np.fft.fft(x)[:n]
    frequency = np.arange(n) / (len(x) * (t[1] - t[0]))
    return [frequency, 2.0 * np.abs(transform) / len(x), np.angle(transform)]


def _column(name: str, array: npt.ArrayLike, index: int) -> FloatArray:
    a = np.asarray(array)
    if a.ndim == 1:
        return a
    if a.ndim != 2 or index == -1:
        raise shape_error(f"GetInterpolatedSignalValue: {name}Index", f"a column, as {name} is no vector", index)
    return a[:, index]


def GetInterpolatedSignalValue(
    time: float,
    dataArray: npt.ArrayLike,
    timeArray: npt.ArrayLike = [],
    dataArrayIndex: int = -1,
    timeArrayIndex: int = -1,
    rangeWarning: bool = True,
    tolerance: float = 1e-6,
) -> Any:
    """Return the linearly interpolated value at a time, of data sampled at equidistant times.

    Columns of matrices are chosen by the indices; an empty timeArray means that dataArray also has the times. Out of
    range, the first or last value is taken; this, and time steps that differ by tolerance, give a warning.
    """
    x = _column("dataArray", dataArray, dataArrayIndex)
    t = _column("timeArray", timeArray if np.size(timeArray) else dataArray, timeArrayIndex)
    if len(x) < 2 or len(t) < 2 or t[1] == t[0]:
        raise ValueError("GetInterpolatedSignalValue: expected at least two values at different times")
    dt = t[1] - t[0]
    index = int((time - t[0]) / dt)
    if time < t[0] or index >= len(x) - 1:
        if rangeWarning and (time < t[0] or time > t[-1]):
            warnings.warn(f"GetInterpolatedSignalValue: time {time} is not in [{t[0]}, {t[-1]}]", stacklevel=2)
        return x[0] if time < t[0] else x[-1]
    start = t[0] + index * dt
    if abs(start - t[index]) > tolerance or abs(start + dt - t[index + 1]) > tolerance:
        warnings.warn(
            "GetInterpolatedSignalValue: times are not equidistant; use numpy.interp or a larger tolerance",
            stacklevel=2,
        )
    part = (time - start) / dt
    return (1 - part) * x[index] + part * x[index + 1]
