"""Shared parts of the tests of whole models: settings, and orders of convergence."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

import dalembert as exu

Solver = exu.DynamicSolverType
Variable = exu.OutputVariableType


def new_system() -> exu.MainSystem:
    return exu.SystemContainer().AddSystem()


def settings(end: float, steps: int, spectral_radius: float = 0.9, tolerance: float = 1e-10) -> Any:
    """Newton's tolerances are far below the errors of the integrators, so that these can be measured."""
    s = exu.SimulationSettings()
    s.timeIntegration.endTime = end
    s.timeIntegration.numberOfSteps = steps
    s.timeIntegration.verboseMode = 0
    s.timeIntegration.generalizedAlpha.spectralRadius = spectral_radius
    s.timeIntegration.newton.relativeTolerance = tolerance
    s.timeIntegration.newton.absoluteTolerance = tolerance
    s.solutionSettings.writeSolutionToFile = False
    return s


def orders(error: Callable[[int], Any], steps: Sequence[int]) -> list[float]:
    """Observed orders between successive numbers of steps."""
    errors = [np.linalg.norm(error(n)) for n in steps]
    pairs = zip(steps[:-1], steps[1:], errors[:-1], errors[1:], strict=True)
    return [float(np.log(e0 / e1) / np.log(n1 / n0)) for n0, n1, e0, e1 in pairs]


def self_orders(result: Callable[[int], Any], coarsest: int) -> float:
    """Order without a reference, from the differences of results of n, 2n and 4n steps."""
    a, b, c = (np.asarray(result(coarsest * k)) for k in (1, 2, 4))
    return float(np.log2(np.linalg.norm(a - b) / np.linalg.norm(b - c)))
