"""mbs.ComputeSensitivities: derivatives of outputs of a solution with respect to parameters of the model."""

from __future__ import annotations

import copy
import time as clock
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np

from dalembert import _core
from dalembert._checks import FloatArray, as_number, shape_error
from dalembert._core import DynamicSolverType, MainSystem, SimulationSettings
from dalembert._solving.quiet import assemble_if_needed, given_or_default
from dalembert._studies.design_parameters import Parameter, Parameters
from dalembert._studies.difference_formulas import STEP, derivative
from dalembert._studies.differentiable_outputs import COMPUTED, Context, Output, Sample, entries_read
from dalembert._studies.generalized_alpha import LinearStep, Turns, Variation, turns_of_steps
from dalembert._studies.moving_steps import Moving, Walk
from dalembert._studies.not_differentiable import NotDifferentiable
from dalembert._studies.recorded_motion import (
    Motion,
    check_steps,
    check_tangent,
    record,
    refuse_changed_velocities,
    refuse_settings,
    refuse_system,
    refuse_unit_lengths,
    silent,
)
from dalembert._studies.recorded_steps import Steps, find_steps, only_states_of_items, with_data
from dalembert._studies.runge_kutta_steps import RungeKuttaWalk, refuse_driven
from dalembert._studies.start_derivatives import Start
from dalembert._studies.stored_rows import Rows
from dalembert._tools.missing_names import nearest

Method = Literal["auto", "forward", "adjoint"]
_METHODS = ("auto", "forward", "adjoint")
_BLOCK = 64  # steps whose derivatives by parameters are computed together
_BLOCK_NUMBERS = 4_000_000


@dataclass(frozen=True, repr=False)
class Sensitivities:
    """Results of mbs.ComputeSensitivities.

    values: by output, a number, or an array if the output has several.
    matrix: derivatives, a row for each number of the outputs and a column for each parameter.
    outputs, parameters: names of rows and columns.
    method: 'forward' or 'adjoint'.
    exactness: 'differences': derivatives of the computed solution, in which those of the equations with respect to
        parameters are differences of fourth order; 'frozen steps': the same, with step sizes that are held fixed.
    cost: seconds by part: 'solution' and 'derivatives'.
    """

    values: dict[str, Any]
    matrix: FloatArray
    outputs: list[str]
    parameters: list[str]
    method: str
    exactness: str
    cost: dict[str, float]
    _rows: dict[str, slice]
    _histories: dict[str, tuple[FloatArray, FloatArray]] = field(default_factory=dict)
    _ends: FloatArray | None = None  # of steps that end at no event

    def __repr__(self) -> str:
        """Sizes and method."""
        sizes = f"{len(self._rows)} outputs with respect to {len(self.parameters)} parameters"
        return f"<Sensitivities of {sizes}, {self.method}>"

    def Derivative(self, output: str, parameter: str) -> Any:
        """Return the derivative of an output with respect to a parameter; an array if the output has several."""
        if output not in self._rows:
            raise ValueError(
                f"Derivative: received output '{output}', but there are "
                f"{', '.join(self._rows)}{nearest(output, list(self._rows))}"
            )
        if parameter not in self.parameters:
            raise ValueError(
                f"Derivative: received parameter '{parameter}', but there are "
                f"{', '.join(self.parameters)}{nearest(parameter, self.parameters)}"
            )
        column = self.matrix[self._rows[output], self.parameters.index(parameter)]
        return float(column[0]) if np.ndim(self.values[output]) == 0 else column

    def Histories(self, parameter: str) -> dict[str, FloatArray]:
        """Return derivatives of the values of each sensor, with time in the first column (storeHistories=True)."""
        if not self._histories:
            raise ValueError("Histories: there are none; call ComputeSensitivities with storeHistories=True")
        if parameter not in self.parameters:
            raise ValueError(f"Histories: received parameter '{parameter}', but there are {', '.join(self.parameters)}")
        k = self.parameters.index(parameter)
        return {name: np.column_stack((times, rates[:, k])) for name, (times, rates) in self._histories.items()}


def ComputeSensitivities(
    mbs: MainSystem,
    parameters: Mapping[str, Any],
    outputs: Mapping[str, Any],
    simulationSettings: SimulationSettings | None = None,
    solverType: Any = DynamicSolverType.GeneralizedAlpha,
    method: Method = "auto",
    *,
    consistentStart: bool = False,
    storeHistories: bool = False,
    maximumMemory: float | None = None,
    autoAssemble: bool = True,
) -> Sensitivities:
    """Solve the system and return derivatives of outputs with respect to parameters.

    They are the derivatives of the computed solution, with its step size.

    parameters: by name, (item, parameter), (item, parameter, entry) for one entry of a vector or matrix, a list of
    these,
        which get the same value, or a DesignParameter. Items are indices or names.
    outputs: by name, exu.At, exu.Integral, exu.Final, exu.Reaction, exu.EventTime or exu.Function; with 'static',
        exu.At, exu.Reaction, exu.Eigenvalue, exu.BucklingLoad or exu.FrequencyResponse. The name of a sensor stands for
        At(sensor).
    simulationSettings, solverType: as in SolveDynamic: generalized alpha, the trapezoidal rule, ESDIRK43, or an
        explicit Runge-Kutta method of up to seven stages; 'static': as in SolveStatic. Contact and friction need
        simulationSettings.events.ofItems=True.
    method: 'forward': one linear solution per parameter and step; 'adjoint': one per number of the outputs and step;
        'auto': whichever needs less.
    consistentStart: initial values follow constraints that parameters change; otherwise they stay as they are, with a
    warning.
    storeHistories: also derivatives of sensors that outputs read, after each step (forward method).
    maximumMemory: bytes that the states of all steps may take in memory; more of them are kept in a temporary file.

    The model is copied and does not change. What cannot be differentiated raises NotDifferentiable. Newton's method is
    solved to round-off, whatever tolerances are set.
    """
    assemble_if_needed("ComputeSensitivities", mbs, autoAssemble)
    settings = given_or_default("ComputeSensitivities", simulationSettings)
    problem = Problem(mbs, parameters, outputs, settings, solverType, consistentStart, maximumMemory)
    if method not in _METHODS:
        raise ValueError(
            f"ComputeSensitivities: method: received {method!r}, but expected one of {', '.join(_METHODS)}"
        )
    return problem.solve(method, storeHistories)


def read_outputs(outputs: Mapping[str, Any]) -> dict[str, Output]:
    """Check outputs; names of sensors become their values at the end."""
    from dalembert._studies.differentiable_outputs import At

    if not isinstance(outputs, Mapping) or not outputs:
        raise shape_error(
            "ComputeSensitivities: outputs", "a dictionary, such as {'x': exu.At('tip', time=1.0)}", outputs
        )
    found: dict[str, Output] = {}
    for name, output in outputs.items():
        if isinstance(output, type) and issubclass(output, Output):
            raise shape_error(
                f"ComputeSensitivities: outputs['{name}']", f"{output.__name__}(...), with arguments", output
            )
        found[name] = output if isinstance(output, Output) else At(output)
    return found


class Problem:
    """A copy of a model, with parameters and outputs."""

    def __init__(
        self,
        mbs: MainSystem,
        parameters: Mapping[str, Any],
        outputs: Mapping[str, Any],
        settings: SimulationSettings,
        solverType: Any,
        consistent: bool,
        maximumMemory: float | None = None,
        ends: FloatArray | None = None,
    ) -> None:
        """ends: times at which steps end; error control then has no effect."""
        if not isinstance(parameters, Mapping) or not parameters:
            raise shape_error(
                "ComputeSensitivities: parameters", "a dictionary, such as {'k': ('spring', 'stiffness')}", parameters
            )
        self.outputs = read_outputs(outputs)
        if maximumMemory is not None and not as_number("ComputeSensitivities: maximumMemory", maximumMemory) > 0:
            raise shape_error("ComputeSensitivities: maximumMemory", "a number of bytes above 0", maximumMemory)
        self.memory = np.inf if maximumMemory is None else float(maximumMemory)
        self.static = solverType == "static"
        if not self.static:
            refuse_settings(settings, solverType)
            refuse_changed_velocities(mbs, settings, solverType)
        refuse_system(mbs)
        self.ends = ends
        self.mbs, self.settings, self.solverType, self.consistent = (
            copy.copy(mbs),
            silent(settings),
            solverType,
            consistent,
        )
        self.parameters = [Parameter(self.mbs, name, given, settings) for name, given in parameters.items()]
        self._check_names()
        data = mbs.systemData
        self.n, self.n1, self.m = data.ODE2Size(), data.ODE1Size(), data.AEsize()

    def _check_names(self) -> None:
        """Refuse names of parameters in outputs that do not exist, and parameters that nothing depends on."""
        known = [parameter.name for parameter in self.parameters]
        for name, output in self.outputs.items():
            for read in output.parameters - set(known):
                raise ValueError(
                    f"output '{name}': received '{read}', but the parameters are "
                    f"{', '.join(known)}{nearest(read, known)}"
                )
        read_names = frozenset().union(*(output.parameters for output in self.outputs.values()))
        for parameter in self.parameters:
            if not parameter.changes_model and not parameter.is_end_time and parameter.name not in read_names:
                raise ValueError(
                    f"parameter '{parameter.name}': a DesignParameter without targets, which no output reads"
                )

    def solve(self, method: Method, histories: bool = False) -> Sensitivities:
        if self.static:
            from dalembert._studies.static_derivatives import solve_static

            return solve_static(self, method)
        return _Integration(self).solve(method, histories)


class Samples:
    """Values and gradients of everything that outputs read."""

    def __init__(self, problem: Problem, context: Context, states: Rows) -> None:
        self.context, self.states, self.problem = context, states, problem
        self.wanted: dict[Sample, None] = {}
        for name, output in problem.outputs.items():
            self.wanted.update(dict.fromkeys(output.samples(name, context)))
        self.sensors = sorted({sample.source for sample in self.wanted if isinstance(sample.source, int)})
        responding = {
            sample.source[1][1]
            for sample in self.wanted
            if not isinstance(sample.source, int) and sample.source[0] == "response"
        }
        self.read_by_outputs = sorted({*self.sensors, *responding})

    def read(self, parameters: Parameters, computed: Mapping[Any, tuple[float, FloatArray]] | None = None) -> None:
        """Evaluate all sensors; computed numbers come with their derivatives with respect to all parameters."""
        self.computed = computed or {}
        self.parameters = parameters
        derivatives = parameters.base.derivatives
        self.values: dict[Sample, FloatArray] = {}
        for sample in self.wanted:
            z, time = self.states[sample.step], float(self.context.times[sample.step])
            if isinstance(sample.source, int):
                self.values[sample] = np.asarray(derivatives.sensor(sample.source, z, time))
            elif sample.source[0] in COMPUTED:
                self.values[sample] = np.array([self.computed[sample.source][0]])
            elif sample.source[0] == "t":
                self.values[sample] = np.array([time])
            else:
                self.values[sample] = z[sample.source[1] : sample.source[1] + 1]
        self.entries = {s: entries_read(parameters.base.mbs, s, parameters.reads[s]) for s in self.sensors}
        self.steps = typical_steps(self.problem, self.states.largest)
        for sensor in self.sensors:
            self._check_entries(sensor)
        self.rows: dict[str, slice] = {}
        self.seeds: dict[Sample, list[tuple[int, FloatArray]]] = {}
        begin = 0
        for name, output in self.problem.outputs.items():
            self.rows[name] = slice(begin, begin + output.size)
            for seed in output.seeds(name, self.context, self.values):
                self.seeds.setdefault(seed.sample, []).append((begin + seed.row, seed.weights))
            begin += output.size
        self.size = begin
        self.by_step: dict[int, list[Sample]] = {}
        for sample in self.seeds:
            self.by_step.setdefault(sample.step, []).append(sample)

    def refuse_accelerations(self) -> None:
        """Refuse sensors of accelerations, which are no states of explicit methods."""
        n, n1 = self.problem.n, self.problem.n1
        for sample in self.seeds:
            entries, gradient = self.gradient(sample)
            moved = np.abs(gradient) * self.steps[entries]  # changes of values
            largest = moved.max(initial=0.0)
            for entry, column in zip(entries, moved.T, strict=True):
                if (2 * n <= entry < 3 * n or entry >= 3 * n + n1) and column.max(initial=0.0) > 1e-9 * largest:
                    name = (
                        self.problem.mbs.GetSensorParameter(sample.source, "name")
                        if isinstance(sample.source, int)
                        else ""
                    )
                    raise NotDifferentiable(
                        "accelerations of explicit methods are not available",
                        item=f"sensor '{name}'" if name else "output",
                        advice="use generalized alpha",
                    )

    def _check_entries(self, sensor: int) -> None:
        """Let a sensor read all entries if its gradient differs from a difference along a direction of all of them."""
        sample = next(sample for sample in self.wanted if sample.source == sensor)
        derivatives, time = self.parameters.base.derivatives, float(self.context.times[sample.step])
        z, n = self.states[sample.step], self.problem.n
        count = 3 * n + 2 * self.problem.n1 + self.problem.m
        direction = np.zeros(len(z))
        direction[:count] = np.cos(np.arange(count)) * self.steps[:count] / STEP

        def value(e: float) -> FloatArray:
            moved = z + e * direction
            moved[:n] = derivatives.compose(z[:n], e * direction[:n])
            return np.asarray(derivatives.sensor(sensor, moved, time))

        entries, gradient = self.gradient(sample)
        expected = derivative(value, STEP)
        size = np.abs(gradient * direction[entries]).sum(axis=1) + np.abs(self.values[sample])
        if np.any(np.abs(gradient @ direction[entries] - expected) > 1e-6 * size + 1e-12):
            self.entries[sensor] = list(range(count))

    def gradient(self, sample: Sample) -> tuple[list[int], FloatArray]:
        """Return entries of the state, and derivatives of the values with respect to them."""
        if not isinstance(sample.source, int):
            return ([sample.source[1]], np.ones((1, 1))) if sample.source[0] == "z" else ([], np.zeros((1, 0)))
        entries = self.entries[sample.source]
        z, time = self.states[sample.step], float(self.context.times[sample.step])
        steps = [float(self.steps[i]) for i in entries]
        return entries, self.parameters.base.derivatives.sensor_gradient(sample.source, z, time, entries, steps)

    def explicit(self, sample: Sample) -> FloatArray:
        """Return derivatives of the values with respect to the parameters at a fixed state."""
        rates = np.zeros((len(self.values[sample]), len(self.parameters.all)))
        if isinstance(sample.source, int):
            z, time = self.states[sample.step], float(self.context.times[sample.step])
            for k, rate in self.parameters.sensor_rates(sample.source, z, time):
                rates[:, k] = rate
        elif sample.source[0] in COMPUTED:
            rates[0] = self.computed[sample.source][1]
        return rates

    def moving_seeds(self, step: int, bar: Moving, matrix: FloatArray, walk: Walk) -> None:
        """Add derivatives of the outputs with respect to the state, time and data coordinates at a step."""
        self.add_seeds(step, bar.state, matrix)
        for sample in self.by_step.get(step, ()):
            by_time, by_data = self._moving_rates(sample, walk)
            for row, weights in self.seeds[sample]:
                bar.t[row] += weights @ by_time
                bar.data[row] += weights @ by_data

    def _moving_rates(self, sample: Sample, walk: Walk) -> tuple[FloatArray, FloatArray]:
        """Return derivatives of values with respect to time, at a fixed state, and to tracked data coordinates."""
        none = np.zeros((len(self.values[sample]), len(walk.tracked)))
        if not isinstance(sample.source, int):
            return np.full(1, float(sample.source[0] == "t")), none
        sensor, derivatives = sample.source, self.parameters.base.derivatives
        z, time = self.states[sample.step], float(self.context.times[sample.step])
        by_time = derivative(lambda e: np.asarray(derivatives.sensor(sensor, z, time + e)), STEP * walk.steps.regular)
        for column, entry in enumerate(walk.tracked):
            none[:, column] = walk._along_data(lambda at: derivatives.sensor(sensor, at, time), z, entry)
        return by_time, none

    def moving_variations(self, step: int, change: Moving, matrix: FloatArray, walk: Walk) -> None:
        """Add derivatives of the outputs by the variation of a step with respect to all parameters."""
        self.add_variations(step, change.state, matrix)
        for sample in self.by_step.get(step, ()):
            rates = self.moving_rates(sample, change, walk)
            for row, weights in self.seeds[sample]:
                matrix[row] += weights @ rates

    def moving_rates(self, sample: Sample, change: Moving, walk: Walk) -> FloatArray:
        """Return derivatives of values by the variation of time and data coordinates."""
        by_time, by_data = self._moving_rates(sample, walk)
        return np.outer(by_time, change.t) + by_data @ change.data.T

    def add_seeds(self, step: int, bar: Variation, matrix: FloatArray) -> None:
        """Add derivatives of the outputs with respect to the state at a step, and explicit ones."""
        for sample in self.by_step.get(step, ()):
            entries, gradient = self.gradient(sample)
            explicit = self.explicit(sample)
            for row, weights in self.seeds[sample]:
                z = np.zeros(self.states.width)
                z[entries] = weights @ gradient
                bar.add(row, z)
                matrix[row] += weights @ explicit

    def add_variations(self, step: int, change: Variation, matrix: FloatArray) -> None:
        """Add derivatives of the outputs by the variation of a state with respect to all parameters."""
        z = change.z if step in self.by_step else None
        for sample in self.by_step.get(step, ()):
            rates = self.rates(sample, z)
            for row, weights in self.seeds[sample]:
                matrix[row] += weights @ rates

    def rates(self, sample: Sample, z: Any) -> FloatArray:
        """Return derivatives of the values, for variations of the state in rows."""
        entries, gradient = self.gradient(sample)
        return np.asarray(gradient @ z[:, entries].T + self.explicit(sample))

    def outputs(self) -> dict[str, Any]:
        found = {}
        for name, output in self.problem.outputs.items():
            value = output.value(name, self.context, self.values)
            found[name] = float(value[0]) if output.size == 1 else value
        return found


def typical_steps(problem: Problem, largest: FloatArray) -> FloatArray:
    """Return steps of differences for entries of the state, of which the largest values are known."""
    extent = min(1.0, float(_core.testing.extent(problem.mbs)))
    size = np.maximum(np.abs(largest), extent)
    size[: problem.n] = extent
    return np.asarray(STEP * size)


def chosen(method: Method, parameters: int, outputs: int) -> str:
    """Return the method that needs fewer linear solutions."""
    if method != "auto":
        return method
    return "forward" if parameters <= outputs else "adjoint"


class _Integration:
    """Derivatives of a time integration."""

    def __init__(self, problem: Problem) -> None:
        self.problem = problem
        begin = clock.perf_counter()
        solved = copy.copy(problem.mbs)
        self.motion: Motion = record(solved, problem.settings, problem.solverType, problem.memory, problem.ends)
        self.seconds = clock.perf_counter() - begin

    def solve(self, method: Method, histories: bool) -> Sensitivities:
        problem = self.problem
        begin = clock.perf_counter()
        motion = self.motion
        end_time = next((k for k, parameter in enumerate(problem.parameters) if parameter.is_end_time), None)
        rate_level = motion.scheme.newmark and (
            problem.solverType == DynamicSolverType.TrapezoidalIndex2
            or problem.settings.timeIntegration.generalizedAlpha.useIndex2Constraints
        )
        if rate_level:
            refuse_unit_lengths(problem.mbs)
        steps, context = self._steps(rate_level, end_time)
        samples = Samples(problem, context, motion.states)
        middle = len(motion.times) // 2
        parameters = Parameters(
            problem.mbs,
            problem.parameters,
            samples.read_by_outputs,
            {"rate_level": rate_level},
            (motion.states[middle], float(motion.times[middle])),
        )
        base, tableau = parameters.base.derivatives, motion.tableau
        if tableau is not None:
            for each in parameters.systems:
                each.acceleration_level = True
        motion = motion._replace(scheme=_with_rotations(motion, base))
        self.motion = motion
        if np.any(np.asarray(base.static_signs) > 0):
            row = int(np.flatnonzero(np.asarray(base.static_signs) > 0)[0])
            raise NotDifferentiable(
                "algebraic coordinates are not available",
                item=_core.testing.describe_row(problem.mbs, problem.n + problem.n1 + row),
            )
        if tableau is None:
            check_steps(motion, base, problem.n, steps)
        samples.read(parameters)
        state, data = motion.states[middle], base.sizes[3]
        if data and middle > 0:
            state = with_data(state, motion.states[middle - 1][-data:])
        check_tangent(base, state, float(motion.times[middle]), motion.scheme.h, samples.steps, problem.mbs)
        walk = None
        if steps is not None:
            typical = samples.steps
            kind = Walk if tableau is None else RungeKuttaWalk
            walk = kind(parameters, motion.times, motion.states, motion.scheme, steps, typical, end_time)
            if isinstance(walk, RungeKuttaWalk) and tableau is not None:
                time = problem.settings.timeIntegration
                walk.tableau = tableau
                if time.automaticStepSize and tableau.implicit:
                    walk.tolerance = time.absoluteTolerance, time.relativeTolerance
                if not tableau.implicit:
                    samples.refuse_accelerations()
            elif not walk.tracked and not steps.moves and end_time is None and motion.algorithmic is not None:
                walk = None
        start = Start(parameters, motion, problem.consistent).variations()
        how = "forward" if histories and method == "auto" else chosen(method, len(parameters.all), samples.size)
        if histories and how != "forward":
            raise ValueError("ComputeSensitivities: storeHistories=True needs method='forward'")
        kept: dict[str, tuple[FloatArray, FloatArray]] = {}
        if walk is not None:
            matrix = (
                self._move(walk, samples, start, kept if histories else None)
                if how == "forward"
                else self._move_back(walk, samples, start)
            )
        else:
            matrix = (
                self._forward(parameters, samples, start, kept if histories else None)
                if how == "forward"
                else self._adjoint(parameters, samples, start)
            )
        cost = {"solution": self.seconds, "derivatives": clock.perf_counter() - begin}
        return Sensitivities(
            samples.outputs(),
            matrix,
            row_names(problem.outputs),
            [p.name for p in parameters.all],
            how,
            "frozen steps" if steps is not None and motion.adaptive and not steps.equal else "differences",
            cost,
            samples.rows,
            kept,
            np.delete(
                motion.times, [i for i in steps.events if i + 1 < len(motion.times)] if steps is not None else []
            ),
        )

    def _steps(self, rate_level: bool, end_time: int | None) -> tuple[Steps | None, Context]:
        """Return the recorded steps if their sizes differ, data coordinates vary, or the end moves; otherwise None."""
        problem, motion = self.problem, self.motion
        derivatives = _core.testing.SystemDerivatives(problem.mbs, rate_level=rate_level)
        watches = problem.settings.events.ofItems and _has_switches(derivatives, motion)
        has_stages = motion.tableau is not None
        if has_stages:
            derivatives.acceleration_level = True
            refuse_driven(derivatives, problem.mbs, motion.states, motion.times, "with Runge-Kutta methods")
        plain = not watches and end_time is None and motion.algorithmic is not None
        if plain and (
            not derivatives.sizes[3]
            or only_states_of_items(motion.times, motion.states, motion.scheme.h, derivatives, problem.mbs)
        ):
            return None, Context(problem.mbs, motion.times, False)
        if watches and not has_stages and not motion.computes_start:
            raise NotDifferentiable(
                "accelerations after events are not computed",
                item="simulationSettings.timeIntegration.generalizedAlpha.computeInitialAccelerations",
                advice="set it to True",
            )
        if watches and not has_stages and not rate_level:
            refuse_driven(derivatives, problem.mbs, motion.states, motion.times, "together with events")
        scheme = _with_rotations(motion, derivatives)
        steps = find_steps(
            motion.times,
            motion.states,
            scheme,
            motion.scheme.h,
            derivatives,
            problem.mbs,
            watches=bool(watches),
            memory=problem.memory / 6,
            has_stages=has_stages,
            rate_level=rate_level,
            adaptive=motion.adaptive,
            prescribed=problem.ends is not None,
        )
        events = tuple((step, event.item) for step, event in sorted(steps.events.items()))
        moves = bool(events) or end_time is not None
        return steps, Context(problem.mbs, motion.times, False, tuple(steps.events), moves, events)

    def _move(self, walk: Walk, samples: Samples, start: Variation, kept: Any) -> FloatArray:
        """Carry variations along steps whose sizes depend on parameters."""
        matrix = np.zeros((samples.size, len(walk.parameters.all)))
        histories: dict[int, list[FloatArray]] = {sensor: [] for sensor in samples.sensors}
        for i, change in walk.forward(Moving.of(start, len(walk.tracked))):
            samples.moving_variations(i, change, matrix, walk)
            for sensor in samples.sensors if kept is not None else ():
                sample = Sample(i, sensor)
                if sample not in samples.values:
                    z, time = self.motion.states[i], float(self.motion.times[i])
                    samples.values[sample] = np.asarray(walk.derivatives.sensor(sensor, z, time))
                rates = samples.rates(sample, change.state.z) + samples.moving_rates(sample, change, walk)
                histories[sensor].append(rates.T)
        if kept is not None:
            for sensor, rows in histories.items():
                kept[self.problem.mbs.GetSensorParameter(sensor, "name")] = self.motion.times, np.array(rows)
        return matrix

    def _move_back(self, walk: Walk, samples: Samples, start: Variation) -> FloatArray:
        """Go back along steps whose sizes depend on parameters."""
        problem = self.problem
        matrix = np.zeros((samples.size, len(walk.parameters.all)))
        bar = Moving.of(Variation.zeros(samples.size, problem.n, problem.n1, problem.m), len(walk.tracked))

        def add_seeds(i: int, at: Moving, to: FloatArray) -> None:
            samples.moving_seeds(i, at, to, walk)

        bar = walk.backward(bar, matrix, add_seeds)
        samples.moving_seeds(0, bar, matrix, walk)
        return matrix + _products(bar.state, start)

    def _turns(self, states: FloatArray, first: int) -> Turns:
        """Return what steps between some states do to rotations; first: number of the first of these states."""
        motion, n = self.motion, self.problem.n
        assert motion.algorithmic is not None
        v, a, a_end = states[:-1, n : 2 * n], states[:-1, 2 * n : 3 * n], states[1:, 2 * n : 3 * n]
        return turns_of_steps(motion.scheme, v, a, motion.algorithmic[first : first + len(v)], a_end)

    def _linear_step(self, derivatives: Any, z: FloatArray, time: float, turns: Turns, transposed: bool) -> LinearStep:
        """Return the step to a state, with factors."""
        derivatives.linearize(z, time, self.motion.scheme.h)
        step = LinearStep(self.motion.scheme, derivatives, turns)
        failed = step.factorize(transposed)
        if failed >= 0:
            raise NotDifferentiable(
                "the matrix of the step is singular",
                item=_core.testing.describe_row(self.problem.mbs, failed),
                time=time,
            )
        return step

    def _forward(self, parameters: Parameters, samples: Samples, change: Variation, kept: Any) -> FloatArray:
        motion, problem = self.motion, self.problem
        matrix = np.zeros((samples.size, len(parameters.all)))
        samples.add_variations(0, change, matrix)
        histories: dict[int, list[FloatArray]] = {sensor: [] for sensor in samples.sensors}
        block = max(1, min(_BLOCK, _BLOCK_NUMBERS // (parameters.size * len(parameters.all))))
        for i in range(len(motion.times)):
            time = float(motion.times[i])
            if i > 0:
                k = (i - 1) % block
                if k == 0:
                    states = motion.states[i - 1 : i + block]
                    turns = self._turns(states, i - 1)
                    rates = parameters.rates_of(states[1:], motion.times[i : i + block], motion.scheme.h)
                step = self._linear_step(parameters.base.derivatives, states[k + 1], time, turns.of_step(k), False)
                change = step.forward(change, rates[k])
                samples.add_variations(i, change, matrix)
            for sensor in samples.sensors if kept is not None else ():
                sample = Sample(i, sensor)
                if sample not in samples.values:
                    samples.values[sample] = np.asarray(
                        parameters.base.derivatives.sensor(sensor, motion.states[i], time)
                    )
                histories[sensor].append(samples.rates(sample, change.z).T)
        if kept is not None:
            for sensor, rows in histories.items():
                kept[problem.mbs.GetSensorParameter(sensor, "name")] = motion.times, np.array(rows)
        return matrix

    def _adjoint(self, parameters: Parameters, samples: Samples, start: Variation) -> FloatArray:
        motion, problem = self.motion, self.problem
        matrix = np.zeros((samples.size, len(parameters.all)))
        bar = Variation.zeros(samples.size, problem.n, problem.n1, problem.m)
        samples_end = max(samples.by_step, default=0)
        block = max(1, min(_BLOCK, _BLOCK_NUMBERS // (parameters.size * samples.size)))
        for end in range(samples_end, 0, -block):
            begin = max(end - block, 0)
            states, times = motion.states[begin : end + 1], motion.times[begin : end + 1]
            turns = self._turns(states, begin)
            weights = np.zeros((end - begin, samples.size, parameters.size))
            for k in range(end - begin, 0, -1):
                samples.add_seeds(begin + k, bar, matrix)
                turn = turns.of_step(k - 1)
                step = self._linear_step(parameters.base.derivatives, states[k], float(times[k]), turn, True)
                bar, weights[k - 1] = step.backward(bar)
            matrix -= parameters.weighted_rates_of(states[1:], times[1:], motion.scheme.h, weights)
        samples.add_seeds(0, bar, matrix)
        return matrix + _products(bar, start)


def _products(bar: Variation, start: Variation) -> FloatArray:
    """Return products of derivatives with respect to the start with its variations."""
    names = ("q", "v", "a", "b", "y", "y_t", "lam")
    return np.asarray(sum(getattr(bar, name) @ getattr(start, name).T for name in names))


def _has_switches(derivatives: Any, motion: Motion) -> bool:
    return len(derivatives.switches(motion.states[0], float(motion.times[0]), motion.scheme.h)) > 0


def _with_rotations(motion: Motion, derivatives: Any) -> Any:
    from dataclasses import replace

    first = np.array(derivatives.rotations, dtype=int).reshape(-1, 1)
    return replace(motion.scheme, rotations=first + np.arange(3))


def row_names(outputs: Mapping[str, Output]) -> list[str]:
    return [
        name if output.size == 1 else f"{name}[{i}]" for name, output in outputs.items() for i in range(output.size)
    ]
