"""Solvers used as tools: without files and text, on an assembled system."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from dalembert import _core
from dalembert._core import SimulationSettings
from dalembert._solving.diagnosis import SolverError


def require_system(function: str, mbs: Any) -> None:
    """Raise an error if mbs is not a system."""
    if not isinstance(mbs, _core.MainSystem):
        raise TypeError(f"{function}: mbs: received {mbs!r}, but expected a MainSystem; SC.AddSystem() makes one")


def assemble_if_needed(function: str, mbs: Any, autoAssemble: bool) -> None:
    """Assemble a system that has changed since its last Assemble(), and say so; refused if the system is in use."""
    require_system(function, mbs)
    mbs._RequireIdle(function)
    if autoAssemble and not mbs.systemIsConsistent:
        _core.Print(f"WARNING: {function}: the system is not assembled, calling mbs.Assemble() first")
        mbs.Assemble()


def given_or_default(function: str, simulationSettings: Any) -> SimulationSettings:
    """Return the settings, by default new ones; TypeError for other types."""
    if simulationSettings is None:
        return SimulationSettings()
    if isinstance(simulationSettings, SimulationSettings):
        return simulationSettings
    advice = ". Put parentheses behind the class" if simulationSettings is SimulationSettings else ""
    expected = f"exu.SimulationSettings(){advice}"
    raise TypeError(f"{function}: simulationSettings: received {simulationSettings!r}, but expected {expected}")


def DeactivateWritingOfSolvers(simulationSettings: Any) -> dict[str, Any]:
    """Switch off text, solution and sensor files in the settings; return the data for RestoreSimulationSettings."""
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


class _CurrentState:
    """The current state, which a solver that starts sets to the initial one."""

    _PARTS = (
        "ODE2Coordinates",
        "ODE2Coordinates_t",
        "ODE2Coordinates_tt",
        "ODE1Coordinates",
        "ODE1Coordinates_t",
        "AECoordinates",
        "DataCoordinates",
        "Time",
    )

    def __init__(self, mbs: Any) -> None:
        self._data = mbs.systemData
        self._values = {part: getattr(self._data, f"Get{part}")() for part in self._PARTS}

    def restore(self) -> None:
        for part, value in self._values.items():
            getattr(self._data, f"Set{part}")(value)


@contextmanager
def quiet_static_solver(function: str, mbs: Any, simulationSettings: Any, autoAssemble: bool) -> Iterator[Any]:
    """Give an initialized static solver that writes nothing; settings and current state are as before afterwards."""
    settings = given_or_default(function, simulationSettings)
    assemble_if_needed(function, mbs, autoAssemble)
    store = DeactivateWritingOfSolvers(settings)
    solver = _core.MainSolverStatic()
    state = _CurrentState(mbs)
    try:
        if not solver.InitializeSolver(mbs, settings):
            raise SolverError.FromSolver(function, solver)
        yield solver
        solver.FinalizeSolver(mbs, settings)
    finally:
        RestoreSimulationSettings(settings, store)
        state.restore()
