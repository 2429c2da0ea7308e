"""Filters are exact for polynomials, the Fourier transform finds amplitudes, interpolation is linear."""

import numpy as np
import pytest

from dalembert import signalProcessing as sp

T = np.linspace(0, 3, 61)


def test_filters_and_their_derivatives_are_exact_for_cubic_signals():
    cubic, derivatives = T**3 - T, [T**3 - T, 3 * T**2 - 1, 6 * T]
    for k, expected in enumerate(derivatives):
        columns = sp.FilterSensorOutput(np.column_stack([T, cubic]), 7, 3, derivative=k)
        np.testing.assert_allclose(columns[:, 1], expected, atol=1e-9)
        np.testing.assert_allclose(columns[:, 0], T)
        np.testing.assert_allclose(sp.FilterSignal(cubic, T[1], 7, 3, derivative=k), expected, atol=1e-9)


def test_finite_differences_are_exact_for_quadratic_signals_inside():
    data = np.column_stack([T, T**2])
    central = sp.FilterSensorOutput(data, 0, derivative=1)[1:-1, 1]
    forward = sp.FilterSensorOutput(data, 0, derivative=1, centralDifferentiate=False)[:-1, 1]
    np.testing.assert_allclose(central, 2 * T[1:-1], atol=1e-12)
    np.testing.assert_allclose(forward, 2 * T[:-1] + T[1], atol=1e-12)
    np.testing.assert_allclose(sp.FilterSignal(T**2, T[1], 0, derivative=2), 2, atol=1e-9)


def test_wrong_filters_are_refused():
    with pytest.raises(ValueError, match="filterWindow: expected 0 or an odd number, received 4"):
        sp.FilterSignal(T, 1, 4)
    with pytest.raises(ValueError, match="samplingRate: expected a positive time step"):
        sp.FilterSignal(T, derivative=1)
    with pytest.raises(ValueError, match="derivative: expected 1 or 2"):
        sp.FilterSignal(T, 1, 0, derivative=3)
    with pytest.raises(ValueError, match="signal: expected a matrix with time"):
        sp.FilterSensorOutput(T)
    with pytest.warns(UserWarning, match="unchanged"):
        assert (sp.FilterSignal(T, filterWindow=0) == T).all()


@pytest.mark.parametrize("n", [200, 201])
def test_spectrum_has_frequency_amplitude_and_phase(n):
    t = np.arange(n) * 0.01
    f = 10 / (n * 0.01)
    frequency, magnitude, phase = sp.ComputeFFT(t, 3 * np.cos(2 * np.pi * f * t + 0.4))
    assert len(frequency) == len(magnitude) == len(phase) == n // 2 + 1
    peak = np.argmax(magnitude)
    assert (frequency[peak], magnitude[peak], phase[peak]) == pytest.approx((f, 3, 0.4))
    assert np.delete(magnitude, peak).max() < 1e-10


def test_interpolation():
    data = np.column_stack([T, T**2, -T])
    for t in (0, 0.33, 2.999, 3):
        expected = np.interp(t, T, T**2)
        assert sp.GetInterpolatedSignalValue(t, T**2, T) == pytest.approx(expected)
        assert sp.GetInterpolatedSignalValue(t, data, dataArrayIndex=1, timeArrayIndex=0) == pytest.approx(expected)
    with pytest.warns(UserWarning, match="not in"):
        assert sp.GetInterpolatedSignalValue(9, T, T) == 3
    assert sp.GetInterpolatedSignalValue(-9, T, T, rangeWarning=False) == 0
    with pytest.warns(UserWarning, match="not equidistant"):
        sp.GetInterpolatedSignalValue(0.5, T, T**1.1)
    with pytest.raises(ValueError, match="dataArrayIndex: expected a column"):
        sp.GetInterpolatedSignalValue(1, data, T)


def test_differences_are_exact_for_quadratic_signals_at_the_ends_and_at_uneven_times():
    """A straight line had half of its slope at both ends."""
    uneven = np.sort(np.random.default_rng(1).uniform(0, 3, 50))
    for t in (T, uneven, T[:3], T[:2]):
        line = sp.FilterSensorOutput(np.column_stack([t, 5 + 7 * t]), 0, derivative=1)[:, 1]
        np.testing.assert_allclose(line, 7, rtol=1e-10)
        forward = sp.FilterSensorOutput(np.column_stack([t, 5 + 7 * t]), 0, derivative=1, centralDifferentiate=False)
        np.testing.assert_allclose(forward[:, 1], 7, rtol=1e-10)
    for t in (T, uneven):
        parabola = np.column_stack([t, t**2])
        np.testing.assert_allclose(sp.FilterSensorOutput(parabola, 0, derivative=1)[:, 1], 2 * t, atol=1e-8)
        np.testing.assert_allclose(sp.FilterSensorOutput(parabola, 0, derivative=2)[:, 1], 2, atol=1e-5)


def test_filters_take_uneven_times_as_they_are():
    """Cubic signals are exact, a sine is as good as at even times; the derivative was wrong by a factor of a thousand."""
    steps = np.random.default_rng(0).uniform(0.001, 0.01, 400)
    steps[100] = 1e-7  # an event
    t = np.cumsum(steps)
    cubic, derivatives = t**3 - t, [t**3 - t, 3 * t**2 - 1, 6 * t]
    for k, expected in enumerate(derivatives):
        found = sp.FilterSensorOutput(np.column_stack([t, cubic]), 11, 3, derivative=k)[:, 1]
        np.testing.assert_allclose(found, expected, atol=1e-8)
    sine = np.column_stack([t, np.sin(2 * np.pi * t)])
    found = sp.FilterSensorOutput(sine, 11, 3, derivative=1)[:, 1]
    # a cubic fit over a window w is wrong by some omega^4 w^3 / 4! < 0.02, on each side of the middle
    np.testing.assert_allclose(found, 2 * np.pi * np.cos(2 * np.pi * t), atol=0.02)


def test_samples_at_the_same_time():
    """Events write a time twice: the first sample counts, and both have its result."""
    t = np.array([0.0, 0.1, 0.2, 0.2, 0.3, 0.4])
    for window in (0, 3):
        found = sp.FilterSensorOutput(np.column_stack([t, 2 * t]), window, 1, derivative=1)[:, 1]
        np.testing.assert_allclose(found, 2, rtol=1e-9)
    with pytest.raises(ValueError, match="time: expected numbers that grow"):
        sp.FilterSensorOutput(np.column_stack([t[::-1], t]), 0, derivative=1)


def test_spectrum_of_uneven_times():
    """Data are interpolated, with a warning: frequency and amplitude are those of the signal, not of its samples."""
    t = np.sort(np.concatenate([np.linspace(0, 4, 801)[:-1], np.linspace(1, 1.5, 150)]))
    with pytest.warns(UserWarning, match="times are not equidistant: data are interpolated"):
        frequency, magnitude, _ = sp.ComputeFFT(t, 3 * np.sin(2 * np.pi * 5 * t))
    peak = np.argmax(magnitude)
    assert frequency[peak] == pytest.approx(5, rel=2e-3)  # the interval is shorter than 4 s by a sample
    assert magnitude[peak] == pytest.approx(3, rel=2e-3)
