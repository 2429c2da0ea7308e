"""Solvers used as tools: without files and text, on an assembled system."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from dalembert import _core
from dalembert._solving.diagnosis import SolverError


def assemble_if_needed(function: str, mbs: Any, autoAssemble: bool) -> None:
    """Assemble a system that has changed since its last Assemble(), and say so; refused if the system is in use."""
    mbs._RequireIdle(function)
    if autoAssemble and not mbs.systemIsConsistent:
        _core.Print(f"WARNING: {function}: the system is not assembled, calling mbs.Assemble() first")
        mbs.Assemble()


def DeactivateWritingOfSolvers(simulationSettings: Any) -> dict[str, Any]:
    """Switch off text, solution and sensor files in the settings; return what RestoreSimulationSettings needs."""
    static, solution = simulationSettings.staticSolver, simulationSettings.solutionSettings
    store = {
        "verboseModeOld": static.verboseMode,
        "writeSolutionToFileOld": solution.writeSolutionToFile,
        "sensorsStoreAndWriteFilesOld": solution.sensorsStoreAndWriteFiles,
    }
    static.verboseMode = 0
    solution.writeSolutionToFile = solution.sensorsStoreAndWriteFiles = False
    return store


def RestoreSimulationSettings(simulationSettings: Any, store: dict[str, Any]) -> None:
    """Undo DeactivateWritingOfSolvers."""
    simulationSettings.staticSolver.verboseMode = store["verboseModeOld"]
    simulationSettings.solutionSettings.writeSolutionToFile = store["writeSolutionToFileOld"]
    simulationSettings.solutionSettings.sensorsStoreAndWriteFiles = store["sensorsStoreAndWriteFilesOld"]


@contextmanager
def quiet_static_solver(function: str, mbs: Any, simulationSettings: Any, autoAssemble: bool) -> Iterator[Any]:
    """Give an initialized static solver that writes nothing; the settings are as before afterwards, come what may."""
    settings = _core.SimulationSettings() if simulationSettings is None else simulationSettings
    assemble_if_needed(function, mbs, autoAssemble)
    store = DeactivateWritingOfSolvers(settings)
    solver = _core.MainSolverStatic()
    try:
        if not solver.InitializeSolver(mbs, settings):
            raise SolverError.FromSolver(function, solver)
        yield solver
        solver.FinalizeSolver(mbs, settings)
    finally:
        RestoreSimulationSettings(settings, store)
