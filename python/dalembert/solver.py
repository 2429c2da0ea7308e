"""Solve static and dynamic problems, and look at the linearized system: matrices, eigenvalues, degrees of freedom."""

from __future__ import annotations

import functools
import inspect
import warnings
from collections.abc import Callable
from contextlib import nullcontext
from typing import TYPE_CHECKING, Any, TypeAlias

from dalembert import _core
from dalembert._core import ConfigurationType, DynamicSolverType, SimulationSettings
from dalembert._solving.diagnosis import CheckSolverInfoStatistics, FinishedNotTrusted, SolverError, SolverErrorMessage
from dalembert._solving.half_turns import warn_of_half_turns
from dalembert._solving.integrators import chosen_method, kind_of, trapezoidal_rule
from dalembert._solving.linearized import (
    ComputeLinearizedSystem,
    ComputeODE2Eigenvalues,
    ComputeSystemDegreeOfFreedom,
    gaps_at_start,
)
from dalembert._solving.quiet import (
    DeactivateWritingOfSolvers,
    RestoreSimulationSettings,
    assemble_if_needed,
    given_or_default,
)
from dalembert._tools.missing_names import nearest, paths_of_setting

__all__ = [
    "CheckSolverInfoStatistics",
    "ComputeLinearizedSystem",
    "ComputeODE2Eigenvalues",
    "ComputeSystemDegreeOfFreedom",
    "DeactivateWritingOfSolvers",
    "FinishedNotTrusted",
    "RestoreSimulationSettings",
    "SolveDynamic",
    "SolveStatic",
    "SolverError",
    "SolverErrorMessage",
    "SolverSuccess",
]

Finished: TypeAlias = "bool | FinishedNotTrusted"


def _run(function: str, solver: Any, mbs: Any, settings: Any, slot: str | None, showCausingItems: bool) -> Finished:
    """Run a compiled solver; SolverError with the diagnosis if it gives up, False if it has run out of time.

    `slot` is the key in mbs.sys that keeps the solver. An exception of a user function surfaces as itself, with the
    diagnosis as a note.
    """
    if slot is not None:
        mbs.sys[slot] = solver
        mbs.sys["simulationSettings"] = settings
    try:
        success: bool = solver.SolveSystem(mbs, settings)
    except Exception as error:
        where = SolverErrorMessage(solver, mbs, solver.IsStaticSolver())
        error.add_note(f"raised during mbs.{function}(...): {where}")
        raise
    if not success and not solver.output.simulationTimeout:
        raise SolverError.FromSolver(function, solver, showCausingItems).with_causes(gaps_at_start(mbs))
    doubts = solver.GetDoubts() if success else []
    return FinishedNotTrusted(doubts) if doubts else success


def _keep_as_initial_values(mbs: Any, accelerations: bool) -> None:
    """Make the current state the initial state of the next simulation."""
    data = mbs.systemData
    data.SetSystemState(systemStateList=data.GetSystemState(), configuration=ConfigurationType.Initial)
    if accelerations:
        data.SetODE2Coordinates_tt(coordinates=data.GetODE2Coordinates_tt(), configuration=ConfigurationType.Initial)


def _knows_settings(solve: Callable[..., Finished]) -> Callable[..., Finished]:
    """Make a function explain the right place of settings that are passed as its arguments."""
    signature = inspect.signature(solve)
    names = set(signature.parameters)

    @functools.wraps(solve)
    def call(*arguments: Any, **options: Any) -> Finished:
        if options and (unknown := next((name for name in options if name not in names), None)):
            groups = ("staticSolver", "timeIntegration")
            group, other = groups if solve.__name__ == "SolveStatic" else reversed(groups)
            paths = [path for path in paths_of_setting(unknown) if not path.startswith(f"{other}.")]
            paths.sort(key=lambda path: not path.startswith(group))
            hint = f"; it is a setting: simulationSettings.{paths[0]}" if paths else nearest(unknown, names)
            hint = hint or f"; known are: {', '.join(signature.parameters)}"
            raise TypeError(f"{solve.__name__}: unknown argument '{unknown}'{hint}")
        return solve(*arguments, **options)

    return call


def SolveStatic(
    mbs: Any,
    simulationSettings: SimulationSettings | None = None,
    updateInitialValues: bool = False,
    storeSolver: bool = True,
    showHints: bool = False,
    showCausingItems: bool = True,
    autoAssemble: bool = True,
) -> Finished:
    """Find the static equilibrium by the settings in staticSolver; return True, or FinishedNotTrusted with doubts.

    storeSolver keeps the solver in mbs.sys['staticSolver']; updateInitialValues starts the next simulation from the
    result. SolverError (a RuntimeError and a ValueError) carries the diagnosis if there is no solution, without items
    unless showCausingItems; its advice is there whether or not showHints is set. False, with a warning, if
    exu.special.solver.timeout has ended it early: the system is in the state of the last load step, and initial
    values stay.
    """
    settings = given_or_default("SolveStatic", simulationSettings)
    assemble_if_needed("SolveStatic", mbs, autoAssemble)
    slot = "staticSolver" if storeSolver else None
    static = settings.staticSolver
    if static.stabilizerODE2term > 0 and static.numberOfLoadSteps == 1:
        warnings.warn(
            "SolveStatic: staticSolver.stabilizerODE2term has no effect with a single load step: it fades out until "
            "the full load is reached. Set staticSolver.numberOfLoadSteps, to 20 for instance",
            stacklevel=3,
        )
    warn_of_half_turns("SolveStatic", mbs, ConfigurationType.Initial, "at the start")
    success = _run("SolveStatic", _core.MainSolverStatic(), mbs, settings, slot, showCausingItems)
    if success and updateInitialValues:
        _keep_as_initial_values(mbs, accelerations=False)
    return success


def new_solver(kind: str) -> Any:
    """Return a solver of a kind of methods (kind_of)."""
    if kind == "diagonally implicit":
        return _core.MainSolverDiagonallyImplicit()
    return _core.MainSolverImplicitSecondOrder() if kind == "implicit" else _core.MainSolverExplicit()


def integrate(
    solver: Any,
    mbs: Any,
    settings: SimulationSettings,
    solverType: DynamicSolverType,
    slot: str | None = "dynamicSolver",
    showCausingItems: bool = True,
) -> Finished:
    """Solve with a new solver for this type."""
    chosen: Any = nullcontext()
    if isinstance(solver, _core.MainSolverExplicit):
        settings.timeIntegration.explicitIntegration.dynamicSolverType = solverType
        chosen = chosen_method(settings, solverType)
    elif solverType == DynamicSolverType.TrapezoidalIndex2:
        chosen = trapezoidal_rule(settings)
    with chosen:
        return _run("SolveDynamic", solver, mbs, settings, slot, showCausingItems)


def SolveDynamic(
    mbs: Any,
    simulationSettings: SimulationSettings | None = None,
    solverType: DynamicSolverType | None = None,
    updateInitialValues: bool = False,
    storeSolver: bool = True,
    showHints: bool = False,
    showCausingItems: bool = True,
    autoAssemble: bool = True,
) -> Finished:
    """Integrate the equations of motion by the settings in timeIntegration; return True, or FinishedNotTrusted.

    solverType chooses among implicit (GeneralizedAlpha, TrapezoidalIndex2, ESDIRK43) and explicit methods; None:
    timeIntegration.solverType, whose default is GeneralizedAlpha. storeSolver keeps the solver in
    mbs.sys['dynamicSolver']; updateInitialValues starts the next simulation from the result. SolverError (a
    RuntimeError and a ValueError) carries the diagnosis if a step cannot be solved, without items unless
    showCausingItems; its advice is there whether or not showHints is set. False, with a warning, if
    exu.special.solver.timeout has ended it early: the system is in the state of the last completed step, and initial
    values stay. A simulation that is ended by a user function (PreStep, PostStep), by
    mbs.SetRenderEngineStopFlag(True) or in the render window returns True; mbs.sys['dynamicSolver'].output has the
    cause.
    """
    settings = given_or_default("SolveDynamic", simulationSettings)
    if solverType is None:
        solverType = settings.timeIntegration.solverType
    kind = kind_of("SolveDynamic", solverType)
    assemble_if_needed("SolveDynamic", mbs, autoAssemble)
    slot = "dynamicSolver" if storeSolver else None
    warn_of_half_turns("SolveDynamic", mbs, ConfigurationType.Initial, "at the start")
    allocations = _core.special.InfoStat(False)
    solver: Any = new_solver(kind)
    success = integrate(solver, mbs, settings, solverType, slot, showCausingItems)
    explicit = kind not in ("diagonally implicit", "implicit")
    evaluations = solver.it.currentStepIndex * solver.GetNumberOfStages() if explicit else solver.it.newtonStepsCount
    CheckSolverInfoStatistics(solver.GetSolverName(), allocations, evaluations)
    if success and updateInitialValues:
        _keep_as_initial_values(mbs, accelerations=True)
    return success


def SolverSuccess(solverStructure: Any) -> list[Any]:
    """Return [whether the solver finished, its error text] of a solver such as mbs.sys['dynamicSolver']."""
    return [solverStructure.output.finishedSuccessfully, solverStructure.GetErrorString()]


if not TYPE_CHECKING:  # type checkers find misspelt arguments themselves
    SolveStatic, SolveDynamic = _knows_settings(SolveStatic), _knows_settings(SolveDynamic)
