"""timeIntegration.solverType chooses the method of SolveDynamic, and errors of solvers are of three built-in kinds."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu

METHODS = exu.DynamicSolverType


def oscillator(stiffness: float = 4.0) -> Any:
    """Return a system with q_tt + 4 q = 0, q(0) = 1."""
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(exu.Node1D(referenceCoordinates=[0], initialCoordinates=[1]))
    mbs.AddObject(exu.Mass1D(nodeNumber=node, mass=1))
    ground = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(exu.NodePointGround()), coordinate=0))
    marker = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
    mbs.AddObject(exu.CoordinateSpringDamper(markerNumbers=[ground, marker], stiffness=stiffness))
    mbs.Assemble()
    return mbs


def short_settings(steps: int = 100) -> Any:
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime = 1
    settings.timeIntegration.numberOfSteps = steps
    settings.solutionSettings.writeSolutionToFile = False
    return settings


def end_of(mbs: Any) -> float:
    return float(mbs.systemData.GetODE2Coordinates()[0])


@pytest.mark.parametrize(
    ("method", "name", "least", "most"),
    [
        (METHODS.GeneralizedAlpha, "implicit second order", 1e-5, 1e-4),  # w^3 t h^2/12 = 7e-5, times sin(2)
        (METHODS.RK44, "RK44", 1e-11, 1e-8),  # w^5 t h^4/120 = 3e-9
        (METHODS.ExplicitMidpoint, "ExplicitMidpoint", 1e-5, 3e-4),  # w^3 t h^2/6
        (METHODS.ESDIRK43, "ESDIRK43", 1e-12, 1e-7),
        (METHODS.TrapezoidalIndex2, "", 1e-5, 1e-4),  # w^3 t h^2/12
    ],
)
def test_the_setting_chooses_the_method(method: exu.DynamicSolverType, name: str, least: float, most: float) -> None:
    settings = short_settings()
    settings.timeIntegration.solverType = method
    by_setting, by_argument = oscillator(), oscillator()
    assert by_setting.SolveDynamic(settings)
    assert least < abs(end_of(by_setting) - np.cos(2)) < most
    assert name.lower() in by_setting.sys["dynamicSolver"].GetSolverName().lower()
    by_argument.SolveDynamic(short_settings(), solverType=method)
    assert end_of(by_setting) == end_of(by_argument)
    assert settings.timeIntegration.solverType == method


def test_an_argument_counts_more_than_the_setting() -> None:
    settings = short_settings()
    settings.timeIntegration.solverType = METHODS.RK44
    mbs, other = oscillator(), oscillator()
    mbs.SolveDynamic(settings, solverType=METHODS.RK33)
    other.SolveDynamic(short_settings(), solverType=METHODS.RK33)
    assert end_of(mbs) == end_of(other)
    assert settings.timeIntegration.solverType == METHODS.RK44


def test_the_default_is_generalized_alpha_whatever_the_explicit_method_is() -> None:
    settings = short_settings()
    assert settings.timeIntegration.solverType == METHODS.GeneralizedAlpha
    settings.timeIntegration.explicitIntegration.dynamicSolverType = METHODS.RK44
    mbs = oscillator()
    mbs.SolveDynamic(settings)
    assert 1e-5 < abs(end_of(mbs) - np.cos(2)) < 1e-4


def test_solvers_called_by_themselves_and_variations_read_it() -> None:
    settings = short_settings()
    settings.timeIntegration.solverType = METHODS.RK44
    mbs, same = oscillator(), oscillator()
    assert exu.MainSolverExplicit().SolveSystem(mbs, settings)
    same.SolveDynamic(settings)
    assert end_of(mbs) == end_of(same)
    varied = oscillator()
    found = varied.SolveVariations({(exu.ObjectIndex(1), "stiffness"): [4.0]}, settings, storeCoordinates=True)
    assert found.coordinates["ODE2"][0, 0] == end_of(same)


def test_a_failed_solution_is_caught_by_each_of_its_kinds() -> None:
    mbs = exu.SystemContainer().AddSystem()
    mbs.AddObject(exu.MassPoint(nodeNumber=mbs.AddNode(exu.NodePoint()), mass=0))
    mbs.Assemble()
    for kind in (ValueError, RuntimeError, exu.SolverError, exu.ExudynError):
        with pytest.raises(kind):
            mbs.SolveDynamic(short_settings())


def test_errors_of_models_are_errors_of_the_package_and_built_in_ones() -> None:
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(exu.NodePoint())
    refused: list[tuple[type[Exception], type[Exception], Any]] = [
        (exu.ModelError, ValueError, lambda: exu.MassPoint(mass=-1)),
        (exu.ModelError, ValueError, lambda: setattr(exu.SimulationSettings().timeIntegration, "endTime", -1)),
        (exu.ExudynTypeError, TypeError, lambda: exu.MassPoint(weight=1)),  # type: ignore[call-arg]
        (exu.ExudynIndexError, IndexError, lambda: mbs.GetNode(7)),
        (exu.ExudynAttributeError, AttributeError, lambda: setattr(exu.MassPoint(), "weight", 1)),
        (exu.StateError, RuntimeError, lambda: mbs.GetNodeOutput(node, exu.OutputVariableType.Velocity)),
    ]
    for own, built_in, call in refused:
        for kind in (own, built_in, exu.ExudynError):
            with pytest.raises(kind):
                call()
    assert issubclass(exu.ModelError, exu.ExudynValueError)
    assert issubclass(exu.NotImplementedFeatureError, NotImplementedError)
    assert issubclass(exu.InternalError, RuntimeError)
    assert issubclass(exu.ExudynArithmeticError, ArithmeticError)
