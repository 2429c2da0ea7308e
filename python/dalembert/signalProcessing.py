"""Filtering, differentiation, Fourier transform and interpolation of sampled signals. Times in s, frequencies in Hz."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import numpy.typing as npt
from scipy.interpolate import make_interp_spline
from scipy.signal import savgol_filter

from dalembert._checks import FloatArray, as_array, as_vector, shape_error

_EVEN = 1e-6  # relative differences of time steps that do not count
_ENTRIES = 1_000_000  # entries of matrices of local polynomials processed at a time


def _is_even(t: FloatArray) -> bool:
    if len(t) < 3:
        return True
    steps = np.diff(t)
    return bool(np.abs(steps - steps.mean()).max(initial=0.0) <= _EVEN * np.abs(steps).max(initial=0.0))


def _at_different_times(where: str, t: FloatArray) -> tuple[FloatArray, Any, Any]:
    """Return times that grow, the samples that have them, and which of these each sample has.

    Events write some times twice.
    """
    if not (np.isfinite(t).all() and (np.diff(t) >= 0).all()):
        raise ValueError(f"{where}: time: expected numbers that grow")
    different, first, which = np.unique(t, return_index=True, return_inverse=True)
    if len(different) < 2:
        raise ValueError(f"{where}: time: expected at least two different times, received {t.tolist()[:5]}")
    return different, first, which


def _differences(where: str, x: FloatArray, t: FloatArray, derivative: int, central: bool) -> FloatArray:
    """Return finite differences of a signal at different times; one-sided ones at the ends."""
    slopes, steps = np.diff(x) / np.diff(t), np.diff(t)
    if derivative == 1:
        if not central:
            return np.append(slopes, slopes[-1])
        edges: Any = min(2, len(x) - 1)
        return np.asarray(np.gradient(x, (t[-1] - t[0]) / (len(t) - 1) if _is_even(t) else t, edge_order=edges))
    if derivative != 2:
        raise shape_error(f"{where}: derivative", "1 or 2, if filterWindow is 0", derivative)
    if len(x) < 3:
        return np.zeros(len(x))
    second = 2 * np.diff(slopes) / (steps[1:] + steps[:-1])
    return np.concatenate([second[:1], second, second[-1:]])


def _local_polynomials(x: FloatArray, t: FloatArray, window: int, order: int, derivative: int) -> FloatArray:
    """Return values or derivatives of the polynomials that fit the samples around each time best.

    This is the filter of Savitzky and Golay for equidistant times, with the outermost polynomials up to the ends.
    """
    result = np.zeros(len(x))
    if derivative > order:
        return result
    powers, first = np.arange(order + 1), np.clip(np.arange(len(x)) - window // 2, 0, len(x) - window)
    factor = float(np.prod(np.arange(1, derivative + 1)))
    for part in np.array_split(np.arange(len(x)), 1 + len(x) * window * (order + 1) // _ENTRIES):
        numbers = first[part, None] + np.arange(window)
        away = t[numbers] - t[part, None]
        size = np.abs(away).max(axis=1)
        fits = np.linalg.pinv((away / size[:, None])[:, :, None] ** powers)
        result[part] = factor * np.einsum("ij,ij->i", fits[:, derivative], x[numbers]) / size**derivative
    return result


def _filtered(
    where: str,
    x: FloatArray,
    t: FloatArray,
    filterWindow: int,
    polyOrder: int,
    derivative: int,
    central: bool,
) -> FloatArray:
    if filterWindow == 0:
        if derivative != 0:
            return _differences(where, x, t, derivative, central)
        warnings.warn(f"{where}: neither filterWindow nor derivative is given, the signal is unchanged", stacklevel=3)
        return x.copy()
    if filterWindow % 2 != 1 or filterWindow < 1:
        raise shape_error(f"{where}: filterWindow", "0 or an odd number", filterWindow)
    if _is_even(t) or not polyOrder < filterWindow <= len(x):  # SciPy rejects the other case
        smooth = savgol_filter(x, window_length=filterWindow, polyorder=polyOrder, deriv=derivative)
        return np.asarray(smooth / ((t[-1] - t[0]) / (len(t) - 1)) ** derivative)
    return _local_polynomials(x, t, filterWindow, polyOrder, derivative)


def FilterSensorOutput(
    signal: npt.ArrayLike,
    filterWindow: int = 5,
    polyOrder: int = 3,
    derivative: int = 0,
    centralDifferentiate: bool = True,
) -> FloatArray:
    """Return a matrix like signal (time in column 0) with filtered or differentiated further columns.

    A Savitzky-Golay filter of odd window length and polyOrder is used; filterWindow = 0 takes finite differences for
    the first (central or forward) and second derivative. Both use the times of the samples, which may be uneven; if
    samples have the same time, the first is used. Differences
    are one-sided at the ends.
    """
    data = as_array("FilterSensorOutput: signal", signal).copy()
    if data.ndim != 2 or data.shape[1] < 2:
        raise shape_error("FilterSensorOutput: signal", "a matrix with time and at least one more column", signal)
    where = "FilterSensorOutput"
    t, first, which = _at_different_times(where, data[:, 0])
    for column in data.T[1:]:
        found = _filtered(where, column[first], t, filterWindow, polyOrder, derivative, centralDifferentiate)
        column[:] = found[which]
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
    t = np.arange(len(x), dtype=float) * (samplingRate if samplingRate > 0 else 1.0)
    return _filtered("FilterSignal", x, t, filterWindow, polyOrder, derivative, centralDifferentiate)


def ComputeFFT(time: npt.ArrayLike, data: npt.ArrayLike) -> list[FloatArray]:
    """Return [frequency, magnitude, phase] of real data at equidistant times, up to half the sampling frequency.

    Data at other times are interpolated by cubic splines, with a warning.
    The magnitude of a frequency is its amplitude in the signal (twice the mean at frequency 0); phases are in rad.
    """
    t, x = as_vector("ComputeFFT: time", time), as_vector("ComputeFFT: data", data)
    if len(t) != len(x) or len(t) < 2:
        raise shape_error("ComputeFFT: data", f"a vector with as many (>= 2) entries as time, {len(t)}", data)
    if not _is_even(t):
        different, first, _ = _at_different_times("ComputeFFT", t)
        warnings.warn(
            f"ComputeFFT: times are not equidistant: data are interpolated at {len(different)} equidistant times, "
            "which changes high frequencies; store results with a constant sensorsWritePeriod",
            stacklevel=2,
        )
        t = np.linspace(different[0], different[-1], len(different))
        x = make_interp_spline(different, x[first], k=min(3, len(different) - 1))(t)
    n = len(x) // 2 + 1
    transform = np.fft.fft(x)[:n]
    frequency = np.arange(n) / (len(x) * ((t[-1] - t[0]) / (len(t) - 1)))
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
