"""Sweeps and smooth steps for excitations."""

from __future__ import annotations

from math import cos, pi, sin


def FrequencySweep(t: float, t1: float, f0: float, f1: float) -> float:
    """Return the frequency in Hz at time t of a linear sweep from f0 at time 0 to f1 at time t1."""
    return f0 + (f1 - f0) * t / t1


def _sweep_phase(t: float, t1: float, f0: float, f1: float) -> float:
    """Return the phase of the sweep in rad, the integral of its angular frequency."""
    return 2.0 * pi * t * (f0 + 0.5 * (f1 - f0) * t / t1)


def SweepSin(t: float, t1: float, f0: float, f1: float) -> float:
    """Return the sine sweep at time t with a frequency linear from f0 at time 0 to f1 (in Hz) at time t1."""
    return sin(_sweep_phase(t, t1, f0, f1))


def SweepCos(t: float, t1: float, f0: float, f1: float) -> float:
    """Return the cosine sweep at time t with a frequency linear from f0 at time 0 to f1 (in Hz) at time t1."""
    return cos(_sweep_phase(t, t1, f0, f1))


def SmoothStep(x: float, x0: float, x1: float, value0: float, value1: float) -> float:
    """Return value0 before x0, value1 after x1, and half a cosine wave between, with a continuous derivative."""
    if x <= x0:
        return value0
    if x >= x1:
        return value1
    return value0 + 0.5 * (value1 - value0) * (1.0 - cos(pi * (x - x0) / (x1 - x0)))


def SmoothStepDerivative(x: float, x0: float, x1: float, value0: float, value1: float) -> float:
    """Return the derivative of SmoothStep with respect to x."""
    if not x0 < x < x1:
        return 0.0
    width = x1 - x0
    return 0.5 * (value1 - value0) * pi / width * sin(pi * (x - x0) / width)
