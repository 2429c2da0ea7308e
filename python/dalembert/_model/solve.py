"""model.solve and model.solve_static: settings by arguments, and the states in memory."""

from __future__ import annotations

import copy
import math
import os
import tempfile
import warnings
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from dalembert import _core
from dalembert._checks import as_number, shape_error
from dalembert._core import ConfigurationType, DynamicSolverType, SimulationSettings, testing
from dalembert._io.solution_states import LoadSolutionFile
from dalembert._model import words
from dalembert._model.assembly import assemble_if_needed, keep_as_initial_values
from dalembert._model.progress import progress as progress_bar
from dalembert._model.solution import Solution, SolutionWarning
from dalembert._solving.diagnosis import FinishedNotTrusted, SolverError
from dalembert._tools.item_facts import facts_of

if TYPE_CHECKING:
    from dalembert._studies.differentiable_model import DifferentiableModel

_FIXED_STEPS = {
    DynamicSolverType.GeneralizedAlpha,
    DynamicSolverType.TrapezoidalIndex2,
    DynamicSolverType.ExplicitEuler,
    DynamicSolverType.ExplicitMidpoint,
    DynamicSolverType.RK33,
    DynamicSolverType.RK44,
    DynamicSolverType.RK67,
    DynamicSolverType.VelocityVerlet,
}
_DEFAULT_FILE = SimulationSettings().solutionSettings.coordinatesSolutionFileName


def solve(
    model: Any,
    end_time: float,
    step_size: float | None = None,
    *,
    method: Any = "generalized_alpha",
    outputs: Sequence[Any] = (),
    every: float | None = None,
    start_time: float = 0.0,
    update_initial_values: bool = False,
    progress: bool | None = None,
    settings: SimulationSettings | None = None,
) -> Solution:
    where = "model.solve"
    used, kind = _dynamic_settings(where, end_time, step_size, method, start_time, settings)
    time, solution = used.timeIntegration, used.solutionSettings
    period = 0.0 if every is None else as_number(f"{where}: every", every, negative=False)
    solution.solutionWritePeriod = solution.sensorsWritePeriod = period
    if period > 0:
        used.denseOutput.atRequestedTimes = True
    wanted = _wanted(model, outputs, where)
    from dalembert._model.fmi_import import stepped

    with (
        _recorded(model, used, where, "dynamicSolver", kind.name) as run,
        stepped(model.system, used, kind, where),
        progress_bar(model.system, "dynamicSolver", time.startTime, end_time, time.verboseMode == 0 and progress),
    ):
        run(
            lambda: model.system.SolveDynamic(
                used, solverType=kind, updateInitialValues=update_initial_values, autoAssemble=False
            ),
            update_initial_values,
        )
    return _with_outputs(run.solution, wanted)


def solve_static(
    model: Any,
    *,
    outputs: Sequence[Any] = (),
    load_steps: int | None = None,
    update_initial_values: bool = False,
    settings: SimulationSettings | None = None,
) -> Solution:
    where = "model.solve_static"
    used = _settings(where, settings)
    used.staticSolver.verboseMode = 0 if settings is None else used.staticSolver.verboseMode
    if load_steps is not None:
        used.staticSolver.numberOfLoadSteps = load_steps
    used.solutionSettings.solutionWritePeriod = used.solutionSettings.sensorsWritePeriod = 0.0
    wanted = _wanted(model, outputs, where)
    with _recorded(model, used, where, "staticSolver", "Static") as run:
        try:
            run(
                lambda: model.system.SolveStatic(used, updateInitialValues=update_initial_values, autoAssemble=False),
                update_initial_values,
            )
        except SolverError as error:
            if model.system.systemData.ODE1Size() > 0:
                error.add_note(f"{_HELD}; without P, an integral part alone resists no motion")
            if free := _free_motion(model.system):
                error.add_note(
                    f"model.solve_static: nothing resists a motion of {free}, such as the rotation of a beam on hinges "
                    "about its own axis. Hold it by a support, a joint or a weak spring"
                )
            raise
    _warn_of_rates(model.system)
    return _with_outputs(run.solution, wanted)


_HELD = (
    "model.solve_static: states of first-order equations, such as the integral part of a controller, keep their "
    "initial values"
)


def _free_motion(system: Any) -> str:
    """Return the coordinates with the largest share in a motion at the start that has no stiffness; empty: none."""
    import scipy.sparse
    import scipy.sparse.linalg

    state, n = testing.State(system), system.systemData.ODE2Size()
    state.q = system.systemData.GetODE2Coordinates(ConfigurationType.Initial)
    rows, columns, values = testing.tangent_entries(system, state)
    size = system.systemData.SystemSize()
    if len(values) == 0 or n == 0 or not np.isfinite(values).all():
        return ""
    tangent = scipy.sparse.csc_matrix((values, (rows, columns)), shape=(size, size))
    shift = 1e-14 * float(np.abs(values).max())
    try:
        factors = scipy.sparse.linalg.splu(tangent + shift * scipy.sparse.identity(size, format="csc"))
    except RuntimeError:
        return ""
    motion = np.sin(1 + 2.7 * np.arange(size))  # has components of all motions
    for _ in range(4):
        motion[n:] = 0
        motion = factors.solve(motion)
        motion /= np.linalg.norm(motion[:n])
    stiffness, shares = tangent[:n, :n], np.abs(motion[:n])
    if abs(motion[:n] @ (stiffness @ motion[:n])) > 1e-13 * float(shares @ (abs(stiffness) @ shares)):
        return ""
    return ", ".join(testing.describe_row(system, int(row)) for row in np.argsort(-shares)[:3])


def _warn_of_rates(system: Any) -> None:
    """Warn of first-order equations that are not in equilibrium, because static solvers do not change their states."""
    rates = np.abs(testing.rates(system, testing.State(system)))
    if not (rates > 1e-9).any():
        return
    largest = int(rates.argmax())
    for number in range(system.systemData.NumberOfNodes()):
        if largest in system.systemData.GetNodeLTGODE1(number):
            name = system.GetNode(number)["name"]
            text = (
                f"{_HELD}. The rate of '{name}' is {rates[largest]:.3g} 1/s, not zero: use model.solve until it rests"
            )
            warnings.warn(text, SolutionWarning, stacklevel=4)
            return


def _settings(where: str, settings: Any) -> Any:
    if settings is not None and not isinstance(settings, SimulationSettings):
        raise TypeError(f"{where}: settings: received {settings!r}, but expected db.SimulationSettings()")
    return SimulationSettings() if settings is None else copy.deepcopy(settings)


def _dynamic_settings(
    where: str, end_time: Any, step_size: Any, method: Any, start_time: Any, settings: Any
) -> tuple[SimulationSettings, DynamicSolverType]:
    used = _settings(where, settings)
    time = used.timeIntegration
    start = as_number(f"{where}: start_time", start_time, negative=False)
    duration = as_number(f"{where}: end_time", end_time) - start
    if duration <= 0:
        raise ValueError(f"{where}: end_time: received {end_time!r}, but expected a time after {start_time!r}")
    time.startTime, time.endTime = start, end_time
    kind = words.member(DynamicSolverType, method, f"{where}: method")
    if step_size is not None:
        step = as_number(f"{where}: step_size", step_size)
        if step <= 0:
            raise shape_error(f"{where}: step_size", "a positive number", step_size)
        time.numberOfSteps = max(1, math.ceil(duration / step * (1 - 1e-9)))
    elif settings is None and kind in _FIXED_STEPS:
        raise ValueError(f"{where}: step_size: {kind.name} has equal steps: give their size, such as step_size=1e-3")
    return used, kind


def differentiable(
    model: Any,
    parameters: Mapping[str, Any],
    outputs: Mapping[str, Any],
    end_time: float,
    step_size: float | None = None,
    *,
    method: Any = "generalized_alpha",
    steps: Literal["frozen", "replay"] = "frozen",
    start_time: float = 0.0,
    settings: SimulationSettings | None = None,
) -> DifferentiableModel:
    from dalembert._studies.differentiable_model import DifferentiableModel

    where = "model.differentiable"
    used, kind = _dynamic_settings(where, end_time, step_size, method, start_time, settings)
    if not isinstance(parameters, Mapping):
        raise TypeError(f"{where}: parameters: expected {{'k': (spring, 'stiffness')}}, received {parameters!r}")
    places = {name: _place(model, each, f"{where}: parameters['{name}']") for name, each in parameters.items()}
    assemble_if_needed(model.system)
    return DifferentiableModel(model.system, places, outputs, used, kind, steps=steps)


def _place(model: Any, given: Any, where: str) -> Any:
    """Return (item, parameter) with the name of the interface with indices for (spring, 'stiffness')."""
    if isinstance(given, list):
        return [_place(model, each, where) for each in given]
    if not isinstance(given, tuple) or len(given) not in (2, 3) or not isinstance(given[1], str):
        return given  # a DesignParameter, or refused there
    handle, (name, *entry) = model._item_of(given[0], where), given[1:]
    base, dot, constant = name.partition(".")
    known = facts_of(handle._item).parameters
    return handle, (known[base].spelled if base in known else base) + dot + constant, *entry


def _wanted(model: Any, outputs: Any, where: str) -> list[tuple[Any, str, Any]]:
    """Return items, output names and local positions of the argument `outputs`; errors name what exists."""
    from dalembert._model.solution import output_of

    if isinstance(outputs, (str, bytes)) or not isinstance(outputs, Sequence):
        raise TypeError(
            f"{where}: outputs: expected a list such as [(arm, 'position'), 'arm.velocity'], received {outputs!r}"
        )
    wanted = [output_of(model, each, f"{where}: outputs") for each in outputs]
    for handle, _, _ in wanted:
        if handle._kind == "Sensor" and not handle.store_internal:
            raise ValueError(f"{where}: outputs: {handle!r} stores no values: set its store_internal = True")
    return wanted


def _with_outputs(solution: Solution, wanted: list[tuple[Any, str, Any]]) -> Solution:
    solution._compute(wanted)
    return solution


class _Run:
    """Runs a solver once; the result is in `solution`."""

    def __init__(self, model: Any, settings: Any, slot: str, method: str, folder: str) -> None:
        self._model, self._settings, self._slot, self._method, self._folder = model, settings, slot, method, folder
        self.solution: Any = None
        assemble_if_needed(model.system)
        self._snapshot = copy.copy(model.system)  # before FMUs and solvers change parameters

    def __call__(self, solver: Any, updates: bool) -> None:
        system, solution = self._model.system, self._settings.solutionSettings
        temporary = solution.coordinatesSolutionFileName == _DEFAULT_FILE
        if temporary:
            solution.coordinatesSolutionFileName = os.path.join(self._folder, "states")
            solution.binarySolutionFile, solution.outputPrecision = True, 17
        solution.writeSolutionToFile, solution.appendToFile = True, False
        written: list[str] = []
        _core._collect_warnings(written)
        try:
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                finished = solver()
        finally:
            _core._collect_warnings(None)
            for text in written:
                warnings.warn(text, SolutionWarning, stacklevel=4)
        if updates:
            keep_as_initial_values(system)
        texts = [*written, *(str(each.message) for each in caught)]
        doubts = list(finished.doubts) if isinstance(finished, FinishedNotTrusted) else []
        for each in caught:
            warnings.warn(each.message, stacklevel=4)
        for text in doubts:
            warnings.warn(text, SolutionWarning, stacklevel=4)
        name = solution.coordinatesSolutionFileName
        ending = ".sol" if solution.binarySolutionFile else ".txt"
        name = name if os.path.splitext(name)[1] else name + ending
        states = LoadSolutionFile(name, verbose=False)
        self.solution = Solution._of(
            self._model, self._snapshot, states, self._method, [*texts, *doubts], statistics_of(system.sys[self._slot])
        )


@contextmanager
def _recorded(model: Any, settings: Any, where: str, slot: str, method: str) -> Iterator[_Run]:
    with tempfile.TemporaryDirectory(prefix="dalembert") as folder:
        yield _Run(model, settings, slot, method, folder)


def statistics_of(solver: Any) -> dict[str, Any]:
    """Return counts of a solver that has finished."""
    it = solver.it
    return {
        "steps": it.currentStepIndex - 1,  # the index is that of the next step
        "newton_iterations": it.newtonStepsCount,
        "jacobians": it.newtonJacobiCount,
        "discontinuous_iterations": it.discontinuousIterationsCount,
        "rejected_steps": it.rejectedNewtonSteps + it.rejectedAutomaticStepSizeSteps + it.rejectedDiscontinuousSteps,
        "finished": bool(solver.output.finishedSuccessfully),
        "stopped_by_user": bool(solver.output.simulationStoppedByUser or solver.output.simulationStoppedByUserFunction),
        "out_of_time": bool(solver.output.simulationTimeout),
    }
