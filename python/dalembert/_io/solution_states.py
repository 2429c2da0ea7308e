"""Solution files of either format, and how their rows become states of a system."""

from __future__ import annotations

from typing import Any

import numpy as np

from dalembert._calls import checked
from dalembert._checks import FloatArray, as_array, check_system, check_type, shape_error
from dalembert._core import ConfigurationType, MainSolverImplicitSecondOrder, SimulationSettings
from dalembert._io.binary_solutions import MAGIC, LoadBinarySolutionFile
from dalembert._io.files import Path, file_to_read
from dalembert._io.solution_rows import COLUMNS
from dalembert._io.text_solutions import load_text_solution

_RESTART_MAGIC = b"#dalembert restart file"


@checked
def LoadSolutionFile(
    fileName: Path, safeMode: bool = False, maxRows: int = -1, verbose: bool = True, hasHeader: bool = True
) -> dict[str, Any]:
    """Read a solution file, text or binary, and return a dict with data, columnsExported, nColumns and nRows.

    data has one row per written step: time (s), then nColumns coordinates in the groups of columnsExported (ODE2,
    ODE2_t, ODE2_tt, ODE1, ODE1_t, AE, Data). safeMode leaves out damaged rows, maxRows limits their number (-1: all).
    ValueError with line or byte if the header is missing, or if a row is damaged or incomplete.
    """
    fileName = file_to_read("LoadSolutionFile: fileName", fileName)
    with open(fileName, "rb") as file:
        if file.read(len(MAGIC)) == MAGIC:
            return LoadBinarySolutionFile(fileName, maxRows, verbose, safeMode)
    return load_text_solution(fileName, safeMode, maxRows, verbose, hasHeader)


def _set_row(mbs: Any, row: FloatArray, columns: list[int], configuration: Any) -> None:
    """Set all coordinates of a configuration that a row holds."""
    groups = np.split(row[1:], np.cumsum(columns)[:-1])
    for name, group in zip(COLUMNS, groups, strict=True):
        if group.size or name == "ODE2Coordinates":
            getattr(mbs.systemData, f"Set{name}")(group, configuration)


def check_solution(where: str, solution: Any) -> None:
    """Raise an error if the value is not a solution, for example a file name."""
    if not isinstance(solution, dict) or not {"data", "nRows", "columnsExported"} <= solution.keys():
        raise shape_error(f"{where}: solution", "the result of LoadSolutionFile(fileName)", solution)


def check_solution_of(mbs: Any, where: str, solution: dict[str, Any]) -> None:
    """Refuse a solution without rows, with numbers that are not finite, or of another system."""
    data = as_array(f"{where}: solution['data']", solution["data"], "rows of numbers")
    columns = [int(n) for n in solution["columnsExported"]]
    if data.ndim != 2 or len(data) == 0:
        raise ValueError(f"{where}: solution: it has no rows")
    if data.shape[1] != 1 + sum(columns):
        numbers = f"{1 + sum(columns)} numbers, as columnsExported says"
        raise ValueError(f"{where}: solution: expected rows of {numbers}, received {data.shape[1]}")
    for name, count in zip(COLUMNS, columns, strict=True):
        wanted = len(getattr(mbs.systemData, f"Get{name}")(ConfigurationType.Visualization))
        if count != wanted and (count or name == "ODE2Coordinates"):  # further coordinates need not be exported
            raise ValueError(
                f"{where}: solution: it has {count} {name}, but the system has {wanted}: it belongs to another model, "
                "or items have come or gone since it was computed"
            )
    if not np.isfinite(data).all():
        row = int(np.argmin(np.isfinite(data).all(axis=1)))
        raise ValueError(f"{where}: solution: row {row} (time {data[row, 0]:g} s) has numbers that are not finite")


@checked
def SetSolutionState(
    mbs: Any,
    solution: dict[str, Any],
    row: int,
    configuration: Any = ConfigurationType.Current,
    sendRedrawSignal: bool = True,
) -> None:
    """Put row number `row` of a solution (of LoadSolutionFile) into a configuration of the system.

    The Visualization configuration gets the row's time too and is redrawn. IndexError if there is no such row.
    """
    check_system("SetSolutionState: mbs", mbs)
    check_solution("SetSolutionState", solution)
    if not -solution["nRows"] <= row < solution["nRows"]:
        raise IndexError(f"SetSolutionState: row {row} does not exist, the solution has {solution['nRows']} rows")
    data = np.asarray(solution["data"], dtype=float)[int(row)]
    _set_row(mbs, data, list(solution["columnsExported"]), configuration)
    if configuration == ConfigurationType.Visualization:
        mbs.systemData.SetTime(float(data[0]), ConfigurationType.Visualization)
        if sendRedrawSignal:
            mbs.GetSystemContainer().renderer.SendRedrawSignal()


@checked
def InitializeFromRestartFile(mbs: Any, simulationSettings: Any, restartFileName: Path, verbose: bool = True) -> None:
    """Set the current, initial and visualization state from a restart file, or from the last complete row of a
    solution file.

    Its time becomes the start time of the settings. The system must be assembled and have the structure of the one
    that wrote the file; a solution file must hold velocities too. ValueError if the file does not fit.

    Internal data of the solver, such as algorithmic accelerations of generalized alpha, start anew;
    ContinueFromRestartFile of the solver continues bit for bit.
    """
    check_system("InitializeFromRestartFile: mbs", mbs)
    check_type("InitializeFromRestartFile: simulationSettings", simulationSettings, SimulationSettings)
    restartFileName = file_to_read("InitializeFromRestartFile: restartFileName", restartFileName)
    with open(restartFileName, "rb") as file:
        of_solver = file.read(len(_RESTART_MAGIC)) == _RESTART_MAGIC
    if of_solver:
        MainSolverImplicitSecondOrder().ContinueFromRestartFile(mbs, restartFileName)
        time = mbs.systemData.GetTime(ConfigurationType.Initial)
        for configuration in (ConfigurationType.Current, ConfigurationType.Visualization):
            mbs.systemData.SetSystemState(mbs.systemData.GetSystemState(ConfigurationType.Initial), configuration)
            mbs.systemData.SetTime(time, configuration)
        simulationSettings.timeIntegration.startTime = time
        return
    solution = LoadSolutionFile(restartFileName, safeMode=True, verbose=verbose)
    state, columns = solution["data"][-1], solution["columnsExported"]
    if columns[0] != mbs.systemData.ODE2Size() or columns[1] != columns[0]:
        raise ValueError(
            f"{restartFileName}: expected {mbs.systemData.ODE2Size()} ODE2 coordinates and as many "
            f"velocities, found {columns[0]} and {columns[1]}; does the file belong to this system?"
        )
    for configuration in (ConfigurationType.Current, ConfigurationType.Initial, ConfigurationType.Visualization):
        _set_row(mbs, state, columns, configuration)
        mbs.systemData.SetTime(float(state[0]), configuration)
    simulationSettings.timeIntegration.startTime = float(state[0])


@checked
def AnimateSolution(
    mbs: Any,
    solution: dict[str, Any],
    rowIncrement: int = 1,
    timeout: float = 0.04,
    createImages: bool = False,
    runLoop: bool = False,
) -> None:
    """Show every rowIncrement-th row of a solution, with a pause of `timeout` seconds; runLoop repeats until stopped.

    If there is no render window, the first row becomes the visualization state and the function returns.
    """
    check_system("AnimateSolution: mbs", mbs)
    check_solution("AnimateSolution", solution)
    rows, rowIncrement = solution["nRows"], int(rowIncrement)
    if rows == 0 or not 1 <= rowIncrement <= rows:
        raise ValueError(f"AnimateSolution: rowIncrement: expected 1 to {rows} (rows), received {rowIncrement}")
    container = mbs.GetSystemContainer()
    SetSolutionState(mbs, solution, 0, ConfigurationType.Visualization)
    if not container.renderer.IsActive():
        return
    mbs.SetRenderEngineStopFlag(False)
    while not mbs.GetRenderEngineStopFlag():
        for row in range(0, rows, rowIncrement):
            if mbs.GetRenderEngineStopFlag():
                break
            SetSolutionState(mbs, solution, row, ConfigurationType.Visualization)
            if createImages:
                container.renderer.RedrawAndSaveImage()
            container.renderer.DoIdleTasks(timeout)
        if not runLoop:
            break
