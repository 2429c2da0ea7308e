"""Compiled solvers of DynamicSolverType, and their required settings."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, Literal

from dalembert._core import DynamicSolverType

IMPLICIT = {DynamicSolverType.GeneralizedAlpha, DynamicSolverType.TrapezoidalIndex2}
DIAGONALLY_IMPLICIT = {DynamicSolverType.ESDIRK43}
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


Kind = Literal["implicit", "diagonally implicit", "explicit"]
_KINDS: dict[DynamicSolverType, Kind] = {
    **dict.fromkeys(IMPLICIT, "implicit"),
    **dict.fromkeys(DIAGONALLY_IMPLICIT, "diagonally implicit"),
    **dict.fromkeys(EXPLICIT, "explicit"),
}


def kind_of(function: str, solverType: Any) -> Kind:
    """Return the kind of method; ValueError, naming `function`, if it is unknown."""
    if solverType not in _KINDS:
        known = ", ".join(sorted(str(kind) for kind in _KINDS))
        is_name = isinstance(solverType, str) and solverType in DynamicSolverType.__members__
        advice = f". Write DynamicSolverType.{solverType} without quotes" if is_name else ""
        raise ValueError(f"{function}: solverType: expected one of {known}; received {solverType!r}{advice}")
    return _KINDS[solverType]


@contextmanager
def chosen_method(settings: Any, solverType: DynamicSolverType) -> Iterator[None]:
    """Set timeIntegration.solverType while a solver runs."""
    before = settings.timeIntegration.solverType
    settings.timeIntegration.solverType = solverType
    try:
        yield
    finally:
        settings.timeIntegration.solverType = before


@contextmanager
def trapezoidal_rule(settings: Any) -> Iterator[None]:
    """Switch the implicit integrator to the trapezoidal rule with index 2 constraints while a solver runs."""
    integrator = settings.timeIntegration.generalizedAlpha
    before = integrator.useNewmark, integrator.useIndex2Constraints
    integrator.useNewmark = integrator.useIndex2Constraints = True
    try:
        yield
    finally:
        integrator.useNewmark, integrator.useIndex2Constraints = before
