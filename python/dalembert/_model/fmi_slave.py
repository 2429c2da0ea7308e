"""The model in an exported FMU: one continuous solution, which waits at each communication point.

A solver runs in a thread of its own; its function after each step hands over outputs and waits for the next inputs.
The solution is therefore the same as that of model.solve, to the last bit, and no state is stored or restarted.
"""

from __future__ import annotations

import json
import sys
import threading
import weakref
from functools import partial
from pathlib import Path
from queue import SimpleQueue
from typing import Any
from xml.etree.ElementTree import SubElement

import numpy as np

from dalembert._core import ConfigurationType, DynamicSolverType, SystemContainer
from dalembert._model.fmi_signals import Output, Parameter

_STEPS = 2**31  # of a solution without a known end; a power of two, so that the step size is not rounded
_ON_TIME = 1e-6  # part of a step by which communication points may differ from ends of steps


class Slave:
    """The model in a folder with the files of export_fmu."""

    def __init__(self, folder: str) -> None:
        facts = json.loads(Path(folder, "signals.json").read_text("utf-8"))
        self.facts: dict[str, Any] = facts
        self.step_size = float(facts["stepSize"])
        self.time = 0.0
        self._mbs: Any = SystemContainer().AddSystem()
        self._settings: Any = self._mbs.Load(Path(folder, "model.json"), allowCode=True)
        self._mbs.Assemble()
        data, initial = self._mbs.systemData, ConfigurationType.Initial
        *state, accelerations = (np.array(each, dtype=float) for each in facts["state"])
        data.SetSystemState(state, initial)
        data.SetSystemState(state, ConfigurationType.Current)
        data.SetODE2Coordinates_tt(accelerations, initial)
        self._parameters = {name: Parameter.of(self._mbs, each) for name, each in facts["parameters"].items()}
        self._sources = [Output.of(self._mbs, each) for each in facts["outputs"]]
        self.values = {name: each.get() for name, each in self._parameters.items()}
        self._applied = dict(self.values)
        self._outputs: list[float] | None = None  # None: the solution has not begun
        self._commands: SimpleQueue[Any] = SimpleQueue()
        self._answers: SimpleQueue[Any] = SimpleQueue()
        self._moved = False

    # ---- called by the thread of the simulator

    def set(self, name: str, value: float) -> None:
        self.values[name] = value

    def output(self, number: int) -> float:
        if self._outputs is None:
            _apply(self._parameters, self._applied, self.values)
            return _read(self._sources)[number]
        return self._outputs[number]

    def start(self) -> None:
        """Begin the solution, with initial accelerations for the present inputs."""
        self.stop()
        _apply(self._parameters, self._applied, self.values)
        time = self._settings.timeIntegration
        time.startTime, time.numberOfSteps = self.time, _STEPS
        time.endTime = self.time + self.step_size * _STEPS
        self._commands, self._answers = SimpleQueue(), SimpleQueue()
        step = _Step(self)
        kind = DynamicSolverType[self.facts["method"]]
        arguments = (self._mbs, self._settings, kind, step, self._answers)
        thread = threading.Thread(target=_solve, args=arguments, name="dalembert FMU", daemon=True)
        thread.start()
        weakref.finalize(self, _end, self._commands, thread)
        self._outputs = self._answer()
        self._moved = False

    def do_step(self, time: float, step_size: float) -> None:
        count = step_size / self.step_size
        if abs(count - round(count)) > _ON_TIME or round(count) < 1:
            raise ValueError(
                f"the communication step is {step_size!r} s, but expected a multiple of the step size of the model, "
                f"{self.step_size!r} s"
            )
        late = abs(time - self.time) > _ON_TIME * self.step_size
        if self._moved and late:
            raise ValueError(f"the step begins at {time!r} s, but the model is at {self.time!r} s")
        if self._outputs is None or (not self._moved and (late or self.values != self._applied)):
            self.time = time  # pythonfmu3 does not pass the start time
            self.start()
        self._commands.put((time + step_size, dict(self.values)))
        self._outputs, self._moved = self._answer(), True
        self.time = time + step_size

    def stop(self) -> list[str]:
        """End the solution; return reasons not to trust it."""
        if self._outputs is None:
            return []
        self._outputs = None
        self._commands.put(None)
        return getattr(self._answers.get(), "doubts", [])

    def _answer(self) -> list[float]:
        answer = self._answers.get()
        if isinstance(answer, list):
            return answer
        self._outputs = None
        if isinstance(answer, BaseException):
            raise answer
        raise RuntimeError(f"the solution has ended after {self.time!r} s, by a user function of the model")


class _Step:
    """Functions of the system at the ends of steps: outputs and inputs, and an event if a step passes the next point.

    Steps of equal size end at communication points, without an event. Others are cut there.
    """

    def __init__(self, slave: Slave) -> None:
        self.target, self.count = slave.time, 0
        self.tolerance = 1e-9 * slave.step_size
        self.parameters, self.applied, self.sources = slave._parameters, slave._applied, slave._sources
        self.commands, self.answers = slave._commands, slave._answers
        mbs = slave._mbs
        self.own = mbs.GetPostStepUserFunction(), mbs.GetEventsUserFunction(), mbs.GetEventActionUserFunction()

    def attach(self, mbs: Any) -> None:
        mbs.SetPostStepUserFunction(self.after_step)
        mbs.SetEventsUserFunction(self.values)
        if self.own[2] != 0:
            mbs.SetEventActionUserFunction(self.act)

    def detach(self, mbs: Any) -> None:
        mbs.SetPostStepUserFunction(self.own[0])
        mbs.SetEventsUserFunction(self.own[1])
        mbs.SetEventActionUserFunction(self.own[2])

    def values(self, mbs: Any, t: float) -> list[Any]:
        values = [t - self.target - 0.5 * self.margin(), -self.tolerance]
        if self.count % 2:  # solvers refuse events of one function in each step
            values.reverse()
        return values + ([] if self.own[1] == 0 else list(self.own[1](mbs, t)))

    def act(self, mbs: Any, t: float, event: int, direction: int) -> bool:
        return event < 2 or bool(self.own[2](mbs, t, event - 2, direction))

    def margin(self) -> float:
        return self.tolerance + 32 * sys.float_info.epsilon * abs(self.target)

    def after_step(self, mbs: Any, t: float) -> bool:
        if self.own[0] != 0 and not self.own[0](mbs, t):
            return False
        if t < self.target - self.margin():
            return True
        self.answers.put(_read(self.sources))
        command = self.commands.get()
        if command is None:
            return False
        self.target, values = command
        self.count += 1
        _apply(self.parameters, self.applied, values)
        return True


def _solve(mbs: Any, settings: Any, kind: DynamicSolverType, step: _Step, answers: Any) -> None:
    """Solve until the function after steps ends it; the last answer is the result, or an error."""
    step.attach(mbs)
    result: Any = None
    try:
        result = mbs.SolveDynamic(settings, solverType=kind, autoAssemble=False)
    except BaseException as error:  # also SystemExit of a user function
        result = error
    finally:
        step.detach(mbs)
        answers.put(result)


def _end(commands: Any, thread: threading.Thread) -> None:
    """End the solution of an instance that was not terminated; threads must not run when Python ends."""
    commands.put(None)
    if threading.current_thread() is not thread:
        thread.join()


def _apply(parameters: dict[str, Parameter], applied: dict[str, float], values: dict[str, float]) -> None:
    for name, value in values.items():
        if value != applied[name]:
            parameters[name].set(value)
            applied[name] = value


def _read(sources: list[Output]) -> list[float]:
    return [float(value) for each in sources for value in each.values()]


def with_initial_unknowns(description: Any) -> Any:
    """Return a model description that lists outputs as initial unknowns, which FMI 2.0 requires; pythonfmu does not."""
    outputs = description.find("ModelStructure/Outputs")
    if outputs is not None:
        SubElement(description.find("ModelStructure"), "InitialUnknowns").extend(outputs)
    return description


def connect(fmu: Any, package: Any, version: str) -> Slave:
    """Register the variables of the model at a slave of pythonfmu or pythonfmu3, and return the model."""
    slave = Slave(fmu.resources)
    real = package.Real if version == "2" else package.Float64
    causality, variability = (getattr(package, f"Fmi{version}{each}") for each in ("Causality", "Variability"))
    if version == "3":
        time = real("time", causality=causality.independent, getter=lambda: slave.time)
        fmu.register_variable(time, nested=False)
    for name in slave.facts["parameters"]:
        options = {"causality": causality.input, "getter": partial(slave.values.get, name)}
        if name in slave.facts["tunable"]:
            options |= {"causality": causality.parameter, "variability": variability.tunable}
        fmu.register_variable(real(name, setter=partial(slave.set, name), **options), nested=False)
    for number, name in enumerate(slave.facts["names"]):
        output = real(name, causality=causality.output, getter=partial(slave.output, number))
        fmu.register_variable(output, nested=False)
    fmu.default_experiment = package.DefaultExperiment(start_time=0.0, step_size=slave.step_size)
    return slave
