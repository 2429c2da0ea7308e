"""Settings of tests whose steps follow from tolerances."""

from __future__ import annotations

from typing import Any


def by_tolerance(settings: Any, tolerance: float) -> Any:
    """Apply the tolerance to all solvers; returns the settings."""
    settings.timeIntegration.automaticStepSize = settings.stepSizeControl.implicitSolvers = True
    settings.timeIntegration.absoluteTolerance = settings.timeIntegration.relativeTolerance = tolerance
    return settings
