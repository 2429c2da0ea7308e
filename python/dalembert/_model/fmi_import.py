"""model.add_fmu: FMUs that are stepped with a model, at equal times, by the package fmpy.

At each communication time, the inputs of an FMU are measured, it advances by its step size, and its outputs become
parameters of the model, which are held until the next time. These times are events: steps of the solver end there,
accelerations are recomputed for the new parameters, and neither repeated nor refused steps advance the FMU.
"""

from __future__ import annotations

import copy
import math
import os
import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from dalembert import _core
from dalembert._checks import as_number, shape_error
from dalembert._io.files import file_to_read
from dalembert._model.assembly import assemble_if_needed
from dalembert._model.fmi_signals import (
    Output,
    Parameter,
    missing_package,
    parameters_of,
    signal_of,
    warn_of_inertia,
)
from dalembert._model.solve import _FIXED_STEPS
from dalembert._tools.missing_names import nearest

_REAL = {"2.0": "Real", "3.0": "Float64"}  # types of variables, which are also the ends of names of functions
_ON_TIME = 1e-6  # part of a step; there is no step at the end of a solution
_ERROR, _FATAL = 3, 4  # statuses of calls
_COMPUTED = ("output", "calculatedParameter", "independent")  # causalities of variables without start values


@dataclass(frozen=True)
class Fmu:
    """An FMU of a model. Inputs and outputs are plain forms of signals by variables."""

    file: str
    step_size: float
    values: dict[str, Any]
    inputs: dict[str, list[Any]]
    outputs: dict[str, list[Any]]

    @property
    def name(self) -> str:
        return os.path.basename(self.file)


class _Run:
    """An instance of an FMU during one solution."""

    def __init__(self, fmu: Fmu, mbs: Any, start_time: float, end_time: float) -> None:
        import fmpy

        self.fmu, self.start, self.end_time, self.count = fmu, start_time, end_time, 0
        self.sources = [Output.of(mbs, each) for each in fmu.inputs.values()]
        self.parameters = [Parameter.of(mbs, each) for each in fmu.outputs.values()]
        self.before = [each.get() for each in self.parameters]
        self.messages: list[str] = []
        self.initialized = self.failed = False
        self.instance: Any = None
        description = fmpy.read_model_description(fmu.file)
        self.description = description
        self.kind = _REAL[description.fmiVersion[:3]]
        references = {each.name: each.valueReference for each in description.modelVariables}
        self.input_references = [references[name] for name in fmu.inputs]
        self.output_references = [references[name] for name in fmu.outputs]
        self.files = tempfile.TemporaryDirectory(prefix="dalembert", ignore_cleanup_errors=True)
        self.folder = self.files.name
        fmpy.extract(fmu.file, self.folder)

    def _log(self, *arguments: Any) -> None:
        *_, status, _, message = arguments
        if status >= _ERROR and message:
            self.messages.append(message.decode("utf-8", "replace"))

    def _call(self, what: str, time: float, function: Callable[[], Any]) -> Any:
        """Call the FMU; errors have its name, the time and its messages."""
        self.messages.clear()
        try:
            return function()
        except Exception as error:
            self.failed = getattr(error, "status", _ERROR) >= _FATAL
            text = "; ".join([str(error).rstrip("."), *self.messages])
            raise RuntimeError(f"FMU '{self.fmu.name}': {what} at time {time:.9g} s: {text}") from error

    @property
    def next_time(self) -> float:
        return self.start + self.count * self.fmu.step_size

    def step(self) -> None:
        """Measure the inputs, advance by the step size, and set the outputs."""
        t = self.next_time
        sample = [float(each.values()[0]) for each in self.sources]
        if self.instance is None:
            self._call("initialization", t, lambda: self._initialize(sample))
        values = self._call("step", t, lambda: self._advance(t, sample))
        for parameter, value in zip(self.parameters, values, strict=True):
            parameter.set(float(value))
        self.count += 1

    def _initialize(self, sample: list[float]) -> None:
        from fmpy.simulation import apply_start_values, instantiate_fmu

        with self._own_module():
            instance = instantiate_fmu(
                self.folder, self.description, "CoSimulation", logger=self._log, debug_logging=True
            )
        self.instance = instance
        apply_start_values(instance, self.description, self.fmu.values)
        if self.kind == "Real":
            instance.setupExperiment(startTime=self.start)
            instance.enterInitializationMode()
        else:
            instance.enterInitializationMode(startTime=self.start)
        self._set(sample)
        instance.exitInitializationMode()
        self.initialized = True

    def _set(self, sample: list[float]) -> None:
        if sample:
            getattr(self.instance, f"set{self.kind}")(self.input_references, sample)

    def _advance(self, t: float, sample: list[float]) -> list[float]:
        self._set(sample)
        result = self.instance.doStep(currentCommunicationPoint=t, communicationStepSize=self.fmu.step_size)
        if self.kind == "Float64" and result[1]:
            raise RuntimeError("the FMU asks to end the simulation")
        if not self.output_references:
            return []
        return getattr(self.instance, f"get{self.kind}")(self.output_references)

    @contextmanager
    def _own_module(self) -> Iterator[None]:
        """Let an FMU of Python load its own module, also if another one of this name is loaded."""
        listed = Path(self.folder, "resources", "slavemodule.txt")
        name = listed.read_text("utf-8").strip() if listed.exists() else ""
        other = sys.modules.pop(name, None)
        try:
            yield
        finally:
            sys.modules.pop(name, None)
            if other is not None:
                sys.modules[name] = other

    def close(self) -> None:
        """Free the instance, and set the parameters back, so that the next solution has the same start."""
        for parameter, value in zip(self.parameters, self.before, strict=True):
            with suppress(Exception):  # of a system that has failed
                parameter.set(value)
        if self.instance is not None and not self.failed:  # nothing may be called after a fatal error
            with suppress(Exception):
                if self.initialized:
                    self.instance.terminate()
            with suppress(Exception):
                self.instance.freeInstance()
        inside = self.folder + os.sep  # of modules that the FMU has loaded
        sys.path[:] = [each for each in sys.path if not str(each).startswith(inside)]
        for name, module in list(sys.modules.items()):
            if str(getattr(module, "__file__", None)).startswith(inside):
                del sys.modules[name]
        self.files.cleanup()


class _Events:
    """Event functions of a system for the communication times of its FMUs, and those of the user.

    Each FMU has two functions for alternate times, because solvers refuse events of one function in each step.
    """

    def __init__(self, functions: Any, action: Any) -> None:
        self.fmus: list[Fmu] = []
        self.runs: list[_Run] = []  # while model.solve runs
        self._functions, self._action = functions, action

    def __getstate__(self) -> dict[str, Any]:
        return {**vars(self), "runs": []}

    def values(self, mbs: Any, t: float) -> list[Any]:
        values: list[Any] = []
        if len(self.runs) < len(self.fmus):
            names = ", ".join(f"'{each.name}'" for each in self.fmus)
            raise RuntimeError(f"the model has FMUs ({names}), which only model.solve(...) steps")
        for run in self.runs:
            later = run.next_time + run.fmu.step_size
            times = (run.next_time, later) if run.count % 2 == 0 else (later, run.next_time)
            values += [(t - each, 1) for each in times]
        return values + ([] if self._functions == 0 else list(self._functions(mbs, t)))

    def act(self, mbs: Any, t: float, event: int, direction: int) -> bool:
        own = event - 2 * len(self.runs)
        if own >= 0:
            return self._action == 0 or bool(self._action(mbs, t, own, direction))
        run = self.runs[event // 2]
        if t < run.end_time - _ON_TIME * run.fmu.step_size:
            run.step()
        return True


def events_of(system: Any) -> _Events | None:
    """Return the event functions of a system with FMUs; RuntimeError if one of them has been replaced."""
    given = (system.GetEventsUserFunction(), system.GetEventActionUserFunction())
    owners = [getattr(each, "__self__", None) for each in given]
    found = [each for each in owners if isinstance(each, _Events)]
    if len(found) == 1:
        raise RuntimeError(
            "the model has FMUs, but its Events or EventAction user function has been replaced; set own functions "
            "before model.add_fmu"
        )
    return found[0] if found else None


@contextmanager
def stepped(system: Any, settings: Any, kind: Any, where: str) -> Iterator[None]:
    """Have new instances of the FMUs of a system while a solver runs, and free them."""
    events = events_of(system)
    if events is None:
        yield
        return
    if settings.continuation.restartFileName or settings.continuation.ifAvailable:
        raise ValueError(f"{where}: settings.continuation: a solution with FMUs cannot be continued from a file")
    time = settings.timeIntegration
    duration, smallest = time.endTime - time.startTime, min(each.step_size for each in events.fmus)
    steps = math.ceil(duration / smallest * (1 - 1e-9))
    if time.numberOfSteps < steps and kind in _FIXED_STEPS:
        raise ValueError(
            f"{where}: step_size: steps of {duration / time.numberOfSteps:.9g} s are longer than {smallest:.9g} s, the "
            "step size of an FMU; expected at most as long ones"
        )
    time.numberOfSteps = max(time.numberOfSteps, steps)  # steps by tolerances are not longer, either
    try:
        for fmu in events.fmus:
            events.runs.append(_Run(fmu, system, time.startTime, time.endTime))
        _accelerate(system, settings)
        for run in events.runs:
            run.step()
        yield
    finally:
        while events.runs:
            events.runs.pop().close()


def _accelerate(system: Any, settings: Any) -> None:
    """Set the current state to the initial one with its accelerations and reactions, for the first measurement."""
    assemble_if_needed(system)
    quiet = copy.deepcopy(settings)
    quiet.timeIntegration.verboseMode = quiet.timeIntegration.verboseModeFile = 0
    quiet.solutionSettings.writeSolutionToFile = quiet.solutionSettings.sensorsStoreAndWriteFiles = False
    solver = _core.MainSolverImplicitSecondOrder()
    _core._collect_warnings([])  # the solver gives them again
    try:
        solver.InitializeSolver(system, quiet)
        solver.FinalizeSolver(system, quiet)
    finally:
        _core._collect_warnings(None)


def add_fmu(
    model: Any,
    file_name: str | os.PathLike[str],
    inputs: Mapping[str, Any],
    outputs: Mapping[str, Any],
    step_size: float,
    *,
    values: Mapping[str, Any] | None = None,
) -> Fmu:
    where = "model.add_fmu"
    file = os.path.abspath(file_to_read(f"{where}: file_name", file_name))
    step = as_number(f"{where}: step_size", step_size)
    if step <= 0:
        raise shape_error(f"{where}: step_size", "a positive number", step_size)
    variables = _variables(file, where)
    given = {"inputs": (inputs, "input"), "outputs": (outputs, "output"), "values": (values or {}, "")}
    for argument, (names, causality) in given.items():
        _check_variables(f"{where}: {argument}", names, causality, variables, os.path.basename(file))
    for name in values or {}:
        computed = variables[name].causality in _COMPUTED and variables[name].initial not in ("exact", "approx")
        if computed or name in inputs:
            reason = "the FMU computes it" if computed else "it is measured, as one of inputs"
            raise ValueError(f"{where}: values: a start value of '{name}' has no effect, because {reason}")
    measured: dict[str, Any] = {}
    set_by_fmu: dict[str, Parameter] = {}
    for name, each in inputs.items():
        source = signal_of(model, each, f"{where}: inputs['{name}']")
        if (size := len(source.values())) != 1:
            raise ValueError(
                f"{where}: inputs['{name}']: {source.handle!r}: {source.name} has {size} components; add the number of "
                "one, from 0, such as (sensor, 0)"
            )
        measured[name] = source.plain()
    for name, each in outputs.items():
        found = parameters_of(model, each, name, f"{where}: outputs['{name}']")
        if list(found) != [name]:
            one = next(iter(found.values()))
            raise ValueError(
                f"{where}: outputs['{name}']: {one.handle!r}: {one.name} has {len(found)} entries; write "
                f"('{one.handle.name}', '{one.name}', 0) for the first one"
            )
        set_by_fmu[name] = found[name]
    driven = {name: each.plain() for name, each in set_by_fmu.items()}
    others = events.fmus if (events := events_of(model.system)) else []
    taken = [plain for each in others for plain in each.outputs.values()]
    for name, plain in driven.items():
        if taken.count(plain) + list(driven.values()).count(plain) > 1:
            raise ValueError(f"{where}: outputs['{name}']: another output of an FMU sets {plain[3]} of '{plain[2]}'")
    warn_of_inertia(where, set_by_fmu.values())
    fmu = Fmu(file, step, dict(values or {}), measured, driven)
    if events is None:
        events = _Events(model.system.GetEventsUserFunction(), model.system.GetEventActionUserFunction())
        model.system.SetEventsUserFunction(events.values)
        model.system.SetEventActionUserFunction(events.act)
    events.fmus.append(fmu)
    return fmu


def _variables(file: str, where: str) -> dict[str, Any]:
    """Return the variables of an FMU by name; errors if it is none for co-simulation 2.0 or 3.0."""
    try:
        import fmpy
    except ImportError:
        raise missing_package(where, "fmpy") from None
    try:
        description = fmpy.read_model_description(file)
    except Exception as error:
        raise ValueError(f"{where}: file_name: '{file}' is no FMU that can be read: {error}") from error
    if description.fmiVersion[:3] not in _REAL:
        raise ValueError(f"{where}: '{file}' is of FMI {description.fmiVersion}, but expected 2.0 or 3.0")
    if description.coSimulation is None:
        raise ValueError(f"{where}: '{file}' is for model exchange, but expected an FMU for co-simulation")
    return {each.name: each for each in description.modelVariables}


def _check_variables(where: str, given: Any, causality: str, variables: dict[str, Any], file: str) -> None:
    if not isinstance(given, Mapping):
        raise TypeError(f"{where}: expected variables of the FMU by name, such as {{'u': ...}}, received {given!r}")
    known = [name for name, each in variables.items() if causality in ("", each.causality)]
    for name in given:
        if name not in known:
            hint = nearest(name, known) or (f"; it has {', '.join(known)}" if known else "; it has none")
            raise ValueError(f"{where}: FMU '{file}' has no {causality or 'variable'} '{name}'{hint}")
        if causality and (variables[name].type not in _REAL.values() or variables[name].dimensions):
            shape = " with dimensions" if variables[name].dimensions else ""
            raise ValueError(
                f"{where}: '{name}' of FMU '{file}' is {variables[name].type}{shape}, but expected one real number"
            )
