"""Which compiled solver a DynamicSolverType stands for, and what it needs in the settings."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from dalembert._core import DynamicSolverType

IMPLICIT = {DynamicSolverType.GeneralizedAlpha, DynamicSolverType.TrapezoidalIndex2}
EXPLICIT = {
    DynamicSolverType.ExplicitEuler,
    DynamicSolverType.ExplicitMidpoint,
    DynamicSolverType.RK33,
    DynamicSolverType.RK44,
    DynamicSolverType.RK67,
    DynamicSolverType.ODE23,
    DynamicSolverType.DOPRI5,
    DynamicSolverType.DOP853,
    DynamicSolverType.VelocityVerlet,
}


def is_implicit(function: str, solverType: Any) -> bool:
    """Return whether it is an implicit method; ValueError, naming `function`, if it is no method at all."""
    if solverType not in IMPLICIT and solverType not in EXPLICIT:
        known = ", ".join(sorted(str(kind) for kind in IMPLICIT | EXPLICIT))
        is_name = isinstance(solverType, str) and solverType in DynamicSolverType.__members__
        advice = f". Write DynamicSolverType.{solverType} without quotes" if is_name else ""
        raise ValueError(f"{function}: solverType: expected one of {known}; received {solverType!r}{advice}")
    return solverType in IMPLICIT


@contextmanager
def trapezoidal_rule(settings: Any, active: bool) -> Iterator[None]:
    """Switch the implicit integrator to the trapezoidal rule with index 2 constraints while a solver runs."""
    integrator = settings.timeIntegration.generalizedAlpha
    before = integrator.useNewmark, integrator.useIndex2Constraints
    if active:
        integrator.useNewmark = integrator.useIndex2Constraints = True
    try:
        yield
    finally:
        integrator.useNewmark, integrator.useIndex2Constraints = before
