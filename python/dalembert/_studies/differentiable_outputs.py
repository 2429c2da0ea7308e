"""Outputs of exact sensitivities: numbers that depend on sensors and coordinates at steps of a solution."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from dalembert import _core
from dalembert._checks import FloatArray, as_vector, shape_error
from dalembert._studies.difference_formulas import gradient
from dalembert._studies.not_differentiable import NotDifferentiable
from dalembert._tools.found_items import find_item, index_of

# A sensor by its number; "z" with an entry of the state [q, v, a, y, y_t, lambda]; "t" for the time; or a number
# that is computed of an equilibrium, with the mode, the number, or load, sensor, component and circular frequency.
Source = int | tuple[str, Any]
COMPUTED = ("eigenvalue", "buckling", "response")


class Sample(NamedTuple):
    """The values of a source at the end of a step; step 0 is the start."""

    step: int
    source: Source


class Seed(NamedTuple):
    """Derivatives of one number of an output with respect to the values of a sample."""

    row: int
    sample: Sample
    weights: FloatArray


class Context(NamedTuple):
    """The model, and the times of all steps.

    jumps: steps at whose ends events make the motion jump; moves: whether times of steps depend on parameters.
    """

    mbs: Any
    times: FloatArray
    static: bool
    jumps: tuple[int, ...] = ()
    moves: bool = False
    events: tuple[tuple[int, int], ...] = ()  # (step, object)

    def step(self, name: str, time: float | None) -> int:
        """Return the step that ends at a time."""
        if time is None:
            return len(self.times) - 1
        step = int(np.argmin(np.abs(self.times - time)))
        if not abs(self.times[step] - time) <= self._round_off:  # also if it is no number
            raise ValueError(
                f"output '{name}': no step ends at time {time:.10g} s; steps of {self._size:.10g} s go from "
                f"{self.times[0]:.10g} s to {self.times[-1]:.10g} s; {self._advice(time)}"
            )
        return step

    @property
    def _size(self) -> float:
        return float(np.max(np.diff(self.times))) if len(self.times) > 1 else 1.0

    @property
    def _round_off(self) -> float:
        return 1e-6 * self._size

    def _advice(self, time: float) -> str:
        inside = self.times[0] <= time <= self.times[-1]
        return "choose steps that end there" if inside else "it has to lie within the computed time"

    def steps_around(self, name: str, time: float) -> list[int]:
        """Return the step that ends at a time, or the steps whose values are interpolated there.

        They are up to four, and the motion is smooth between them.
        """
        step = int(np.argmin(np.abs(self.times - time)))
        exact = abs(self.times[step] - time) <= self._round_off
        if self.static or not self.times[0] - self._round_off <= time <= self.times[-1] + self._round_off:
            return [self.step(name, time)]
        if exact and (step in (0, len(self.times) - 1) or not self.moves):
            return [step]
        last = int(np.clip(np.searchsorted(self.times, time), 1, len(self.times) - 1))
        begin = max((jump for jump in self.jumps if jump < last), default=0)
        end = min((jump for jump in self.jumps if jump >= last), default=len(self.times) - 1)
        first = int(np.clip(last - 2, begin, max(begin, end - 3)))
        return list(range(first, min(first + 3, end) + 1))

    def sensor(self, name: str, sensor: Any) -> int:
        where = f"output '{name}'"
        found = find_item(self.mbs, sensor, ("Sensor",), where) if isinstance(sensor, str) else sensor
        return int(index_of(self.mbs, "Sensor", found, where))


Values = Mapping[Sample, FloatArray]


class Output(ABC):
    """One or more numbers."""

    __module__ = "dalembert"
    size = 1
    parameters: frozenset[str] = frozenset()  # names of parameters that the output itself reads

    @abstractmethod
    def samples(self, name: str, context: Context) -> Iterator[Sample]:
        """Yield what the output reads."""

    @abstractmethod
    def value(self, name: str, context: Context, values: Values) -> FloatArray:
        """Return the numbers."""

    @abstractmethod
    def seeds(self, name: str, context: Context, values: Values) -> Iterator[Seed]:
        """Yield derivatives of the numbers with respect to the samples."""


def _component(name: str, values: FloatArray, component: int) -> FloatArray:
    """Return the unit vector that selects one value of a sensor."""
    if not 0 <= component < len(values):
        raise ValueError(f"output '{name}': component: received {component}, but the sensor has {len(values)} values")
    unit = np.zeros(len(values))
    unit[component] = 1.0
    return unit


class At(Output):
    """One value of a sensor at a time, or at several times, in s; by default at the end.

    Between the ends of steps, it is the value of the cubic polynomial through the values at four steps. An EventTime as
    time is that of the event, wherever parameters move it.
    """

    __module__ = "dalembert"

    def __init__(self, sensor: Any, time: float | ArrayLike | EventTime | None = None, component: int = 0) -> None:
        self.sensor, self.component = sensor, component
        self.event = time if isinstance(time, EventTime) else None
        if time is None or isinstance(time, EventTime):
            self.times: list[float | None] = [None]
        elif np.ndim(time) == 0:
            self.times = [float(np.asarray(time))]
        else:
            self.times = list(as_vector("At: time", time))
            if not self.times:
                raise shape_error("At: time", "a time, or a list of at least one time", time)
        self.size = len(self.times)

    def _weights(self, name: str, context: Context, time: float | None) -> tuple[list[int], FloatArray, FloatArray]:
        """Return steps, weights of their values, and weights for the rate of the polynomial."""
        if self.event is not None:
            return [next(self.event.samples(name, context)).step], np.ones(1), np.zeros(1)
        steps = [context.step(name, None)] if time is None else context.steps_around(name, time)
        if len(steps) == 1 or time is None:
            return steps, np.ones(1), np.zeros(1)
        return steps, *interpolation_weights(context.times[steps], time)

    def samples(self, name: str, context: Context) -> Iterator[Sample]:
        sensor = context.sensor(name, self.sensor)
        for time in self.times:
            steps, _, _ = self._weights(name, context, time)
            yield from (Sample(step, sensor) for step in steps)
            if context.moves and len(steps) > 1:
                yield from (Sample(step, ("t", 0)) for step in steps)

    def value(self, name: str, context: Context, values: Values) -> FloatArray:
        sensor, found = context.sensor(name, self.sensor), []
        for time in self.times:
            steps, weights, _ = self._weights(name, context, time)
            parts = [values[Sample(step, sensor)] for step in steps]
            unit = _component(name, parts[0], self.component)
            found.append(sum(float(w * (unit @ part)) for w, part in zip(weights, parts, strict=True)))
        return np.array(found)

    def seeds(self, name: str, context: Context, values: Values) -> Iterator[Seed]:
        sensor = context.sensor(name, self.sensor)
        for row, time in enumerate(self.times):
            steps, weights, rates = self._weights(name, context, time)
            samples = [Sample(step, sensor) for step in steps]
            unit = _component(name, values[samples[0]], self.component)
            for sample, weight in zip(samples, weights, strict=True):
                yield Seed(row, sample, weight * unit)
            if context.moves and len(steps) > 1:  # where an end moves, the polynomial moves along its slope
                slope = sum(r * (unit @ values[sample]) for r, sample in zip(rates, samples, strict=True))
                for step, weight in zip(steps, weights, strict=True):
                    yield Seed(row, Sample(step, ("t", 0)), np.array([-weight * slope]))


def interpolation_weights(times: FloatArray, time: float) -> tuple[FloatArray, FloatArray]:
    """Return weights of values at some times for the value, and the rate, of the polynomial through them."""
    count = len(times)
    scale = times[-1] - times[0]
    powers = ((times - times[0]) / scale)[:, None] ** np.arange(count)
    x = (time - times[0]) / scale
    at = x ** np.arange(count)
    slope = np.concatenate(([0.0], np.arange(1, count) * x ** np.arange(count - 1))) / scale
    return np.linalg.solve(powers.T, at), np.linalg.solve(powers.T, slope)


class EventTime(Output):
    """The time at which an item switches, such as a contact that closes, in s; needs simulationSettings.events.ofItems.

    object: the item; number: of its event, beginning with 1 for the first one.
    """

    __module__ = "dalembert"

    def __init__(self, object: Any, number: int = 1) -> None:  # noqa: A002
        if isinstance(number, bool) or not isinstance(number, (int, np.integer)) or number < 1:
            raise shape_error("EventTime: number", "1, 2, ...", number)
        self.object, self.number = object, int(number)

    def samples(self, name: str, context: Context) -> Iterator[Sample]:
        where = f"output '{name}'"
        found = find_item(context.mbs, self.object, ("Object",), where) if isinstance(self.object, str) else self.object
        item = int(index_of(context.mbs, "Object", found, where))
        steps = [step for step, owner in context.events if owner == item]
        if len(steps) < self.number:
            raise ValueError(f"{where}: number: received {self.number}, but the object has {len(steps)} events")
        yield Sample(steps[self.number - 1], ("t", 0))

    def value(self, name: str, context: Context, values: Values) -> FloatArray:
        return np.concatenate([values[sample] for sample in self.samples(name, context)])

    def seeds(self, name: str, context: Context, values: Values) -> Iterator[Seed]:
        for sample in self.samples(name, context):
            yield Seed(0, sample, np.ones(1))


class Integral(Output):
    """The integral over time of a value of a sensor, or of a function of its values.

    It is computed by the trapezoidal rule over steps.

    function: gets the array of values and returns a number; without it, the value with the number `component` is taken.
    derivative: gets the same array and returns the gradient of the function; by default, it is found by differences.
    start, end: in s, by default those of the solution; steps have to end there.
    """

    __module__ = "dalembert"

    def __init__(
        self,
        sensor: Any,
        function: Callable[[FloatArray], float] | None = None,
        *,
        component: int = 0,
        derivative: Callable[[FloatArray], ArrayLike] | None = None,
        start: float | None = None,
        end: float | None = None,
    ) -> None:
        if function is not None and not callable(function):
            raise shape_error("Integral: function", "a function of the values of the sensor", function)
        self.sensor, self.function, self.component, self.derivative = sensor, function, component, derivative
        self.start, self.end = start, end

    def samples(self, name: str, context: Context) -> Iterator[Sample]:
        if context.static:
            raise NotDifferentiable(
                "a static solution has no integral over time", item=f"output '{name}'", advice="use At"
            )
        sensor = context.sensor(name, self.sensor)
        first = 0 if self.start is None else context.step(name, self.start)
        for step in range(first, context.step(name, self.end) + 1):
            yield Sample(step, sensor)
            if context.moves:
                yield Sample(step, ("t", 0))

    def _of_sensor(self, name: str, context: Context) -> list[Sample]:
        return [sample for sample in self.samples(name, context) if isinstance(sample.source, int)]

    def _weights(self, samples: Sequence[Sample], context: Context) -> FloatArray:
        times = context.times[[sample.step for sample in samples]]
        weights = np.zeros(len(times))
        weights[:-1] += 0.5 * np.diff(times)
        weights[1:] += 0.5 * np.diff(times)
        return weights

    def _integrand(self, name: str, x: FloatArray) -> float:
        if self.function is None:
            return float(_component(name, x, self.component) @ x)
        return _number(name, self.function(x))

    def value(self, name: str, context: Context, values: Values) -> FloatArray:
        samples = self._of_sensor(name, context)
        integrand = [self._integrand(name, values[sample]) for sample in samples]
        return np.array([self._weights(samples, context) @ integrand])

    def seeds(self, name: str, context: Context, values: Values) -> Iterator[Seed]:
        samples = self._of_sensor(name, context)
        if context.moves:  # sum of (t_k+1 - t_k) (f_k + f_k+1)/2
            f = [self._integrand(name, values[sample]) for sample in samples]
            pairs = 0.5 * (np.array(f[:-1]) + np.array(f[1:]))
            for sample, weight in zip(samples, -np.diff(np.concatenate(([0.0], pairs, [0.0]))), strict=True):
                yield Seed(0, Sample(sample.step, ("t", 0)), np.array([weight]))
        for sample, weight in zip(samples, self._weights(samples, context), strict=True):
            x = values[sample]
            if self.function is None:
                slope = _component(name, x, self.component)
            elif self.derivative is not None:
                slope = as_vector(f"output '{name}': derivative", self.derivative(x), len(x))
            else:
                slope = gradient(lambda at: self._integrand(name, at), x)
            yield Seed(0, sample, weight * slope)


class Final(Output):
    """An ODE2 coordinate of the system at the end; derivative: 1 for its velocity, 2 for its acceleration."""

    __module__ = "dalembert"

    def __init__(self, coordinate: int, derivative: int = 0) -> None:
        if derivative not in (0, 1, 2):
            raise shape_error("Final: derivative", "0, 1 or 2", derivative)
        self.coordinate, self.derivative = coordinate, derivative

    def samples(self, name: str, context: Context) -> Iterator[Sample]:
        size = context.mbs.systemData.ODE2Size()
        if not 0 <= self.coordinate < size:
            raise ValueError(
                f"output '{name}': coordinate: received {self.coordinate}, but the system has {size} ODE2 coordinates"
            )
        yield Sample(len(context.times) - 1, ("z", self.derivative * size + self.coordinate))

    def value(self, name: str, context: Context, values: Values) -> FloatArray:
        return np.concatenate([values[sample] for sample in self.samples(name, context)])

    def seeds(self, name: str, context: Context, values: Values) -> Iterator[Seed]:
        for sample in self.samples(name, context):
            yield Seed(0, sample, np.ones(1))


class Reaction(Output):
    """A Lagrange multiplier of a constraint or joint at a time, by default at the end.

    equation: number of its equation within the object.
    """

    __module__ = "dalembert"

    def __init__(self, object: Any, equation: int = 0, time: float | None = None) -> None:  # noqa: A002
        self.object, self.equation, self.time = object, equation, time

    def samples(self, name: str, context: Context) -> Iterator[Sample]:
        where, data = f"output '{name}'", context.mbs.systemData
        found = find_item(context.mbs, self.object, ("Object",), where) if isinstance(self.object, str) else self.object
        number = index_of(context.mbs, "Object", found, where)
        equations = data.GetObjectLTGAE(number)
        if not 0 <= self.equation < len(equations):
            raise ValueError(
                f"{where}: equation: received {self.equation}, but the object has {len(equations)} constraint equations"
            )
        before = 3 * data.ODE2Size() + 2 * data.ODE1Size()
        yield Sample(context.step(name, self.time), ("z", before + equations[self.equation]))

    def value(self, name: str, context: Context, values: Values) -> FloatArray:
        return np.concatenate([values[sample] for sample in self.samples(name, context)])

    def seeds(self, name: str, context: Context, values: Values) -> Iterator[Seed]:
        for sample in self.samples(name, context):
            yield Seed(0, sample, np.ones(1))


class _Computed(Output):
    """A number that is computed of an equilibrium."""

    @abstractmethod
    def source(self, name: str, context: Context) -> Source:
        """Return what it is."""

    def samples(self, name: str, context: Context) -> Iterator[Sample]:
        if not context.static:
            raise NotDifferentiable(
                f"{type(self).__name__} belongs to a static equilibrium",
                item=f"output '{name}'",
                advice="use solverType='static'",
            )
        yield Sample(0, self.source(name, context))

    def value(self, name: str, context: Context, values: Values) -> FloatArray:
        return np.concatenate([values[sample] for sample in self.samples(name, context)])

    def seeds(self, name: str, context: Context, values: Values) -> Iterator[Seed]:
        for sample in self.samples(name, context):
            yield Seed(0, sample, np.ones(1))


class Eigenvalue(_Computed):
    """An eigenvalue of the undamped system at its static equilibrium: the square of a circular frequency, in (rad/s)^2.

    mode: its number, beginning with 0 for the smallest one.
    """

    __module__ = "dalembert"

    def __init__(self, mode: int = 0) -> None:
        if isinstance(mode, bool) or not isinstance(mode, (int, np.integer)) or mode < 0:
            raise shape_error("Eigenvalue: mode", "a number of a mode, 0, 1, ...", mode)
        self.mode = int(mode)

    def source(self, name: str, context: Context) -> Source:
        return ("eigenvalue", self.mode)


class BucklingLoad(_Computed):
    """A buckling load: the factor of all loads at which the initial state buckles, as in mbs.ComputeBucklingLoads.

    number: beginning with 0 for the factor of the smallest magnitude.
    """

    __module__ = "dalembert"

    def __init__(self, number: int = 0) -> None:
        if isinstance(number, bool) or not isinstance(number, (int, np.integer)) or number < 0:
            raise shape_error("BucklingLoad: number", "0, 1, ...", number)
        self.number = int(number)

    def source(self, name: str, context: Context) -> Source:
        return ("buckling", self.number)


class FrequencyResponse(_Computed):
    """A frequency response: the amplitude of a value of a sensor under a harmonic load, about the static equilibrium.

    load: it oscillates about its value, with its value as amplitude; sensor, component: what responds.
    omega: circular frequency in rad/s, or the name of a parameter whose value it is.
    """

    __module__ = "dalembert"

    def __init__(self, load: Any, sensor: Any, omega: float | str, component: int = 0) -> None:
        if isinstance(omega, str):
            self.parameters = frozenset({omega})
        elif not isinstance(omega, (int, float, np.number)) or not np.isfinite(omega) or omega < 0:
            raise shape_error("FrequencyResponse: omega", "a circular frequency in rad/s, or a name", omega)
        self.load, self.sensor, self.component = load, sensor, component
        self.omega = omega if isinstance(omega, str) else float(omega)

    def source(self, name: str, context: Context) -> Source:
        where = f"output '{name}'"
        found = find_item(context.mbs, self.load, ("Load",), where) if isinstance(self.load, str) else self.load
        load = int(index_of(context.mbs, "Load", found, where))
        return ("response", (load, context.sensor(name, self.sensor), self.component, self.omega))


class Function(Output):
    """A number that is a function of other outputs, and of values of sensors at the end.

    function: gets an array for each of the sensors, and a number (or an array, if it has several) for each output.
    """

    __module__ = "dalembert"

    def __init__(
        self, function: Callable[..., float], sensors: Sequence[Any] = (), outputs: Sequence[Output] = ()
    ) -> None:
        if not callable(function):
            raise shape_error("Function: function", "a function", function)
        if not sensors and not outputs:
            raise ValueError(
                "Function: pass at least one of sensors, such as ['tip'], and outputs, such as [At('tip')]"
            )
        if not all(isinstance(output, Output) for output in outputs):
            raise shape_error("Function: outputs", "a list of outputs, such as [At('tip')]", outputs)
        self.function, self.sensors, self.outputs = function, list(sensors), list(outputs)
        self.parameters = frozenset().union(*(output.parameters for output in outputs))

    def _of_sensors(self, name: str, context: Context) -> list[Sample]:
        return [Sample(len(context.times) - 1, context.sensor(name, sensor)) for sensor in self.sensors]

    def samples(self, name: str, context: Context) -> Iterator[Sample]:
        yield from self._of_sensors(name, context)
        for output in self.outputs:
            yield from output.samples(name, context)

    def _arguments(self, name: str, context: Context, values: Values) -> list[FloatArray]:
        return [
            *(np.asarray(values[sample]) for sample in self._of_sensors(name, context)),
            *(output.value(name, context, values) for output in self.outputs),
        ]

    def _call(self, name: str, x: FloatArray, sizes: Sequence[int]) -> float:
        parts = np.split(x, np.cumsum(sizes)[:-1])
        arguments = [
            float(part[0]) if i >= len(self.sensors) and len(part) == 1 else part for i, part in enumerate(parts)
        ]
        return _number(name, self.function(*arguments))

    def value(self, name: str, context: Context, values: Values) -> FloatArray:
        arguments = self._arguments(name, context, values)
        return np.array([self._call(name, np.concatenate(arguments), [len(each) for each in arguments])])

    def seeds(self, name: str, context: Context, values: Values) -> Iterator[Seed]:
        arguments = self._arguments(name, context, values)
        sizes = [len(each) for each in arguments]
        by_all = gradient(lambda x: self._call(name, x, sizes), np.concatenate(arguments))
        slopes = np.split(by_all, np.cumsum(sizes)[:-1])
        for sample, slope in zip(self._of_sensors(name, context), slopes, strict=False):
            yield Seed(0, sample, slope)
        for output, slope in zip(self.outputs, slopes[len(self.sensors) :], strict=True):
            for seed in output.seeds(name, context, values):
                yield Seed(0, seed.sample, slope[seed.row] * seed.weights)


def _number(name: str, value: Any) -> float:
    """Return a number that a function of the user has computed."""
    if np.size(value) != 1 or np.asarray(value).dtype.kind not in "fiu" or not np.all(np.isfinite(value)):
        raise ValueError(f"output '{name}': its function returned {value!r}, but expected a finite number")
    return float(np.asarray(value).ravel()[0])


_POSITIONS = {
    _core.OutputVariableType.Position,
    _core.OutputVariableType.Displacement,
    _core.OutputVariableType.Rotation,
    _core.OutputVariableType.RotationMatrix,
    _core.OutputVariableType.Coordinates,
}
_VELOCITIES = {
    _core.OutputVariableType.Velocity,
    _core.OutputVariableType.VelocityLocal,
    _core.OutputVariableType.AngularVelocity,
    _core.OutputVariableType.AngularVelocityLocal,
    _core.OutputVariableType.Coordinates_t,
}


def entries_read(mbs: Any, sensor: int, coordinates: set[int] | None) -> list[int]:
    """Return entries of the state that a sensor may depend on; coordinates: [ODE2, ODE1, AE], None: any."""
    data = mbs.systemData
    n, n1, m = data.ODE2Size(), data.ODE1Size(), data.AEsize()
    known = set(range(n + n1 + m)) if coordinates is None else coordinates
    variable = mbs.GetSensor(sensor).get("outputVariableType")
    derivatives = 1 if variable in _POSITIONS else 2 if variable in _VELOCITIES else 3
    found = [i + k * n for i in known if i < n for k in range(derivatives)]
    found += [2 * n + i + k * n1 for i in known if n <= i < n + n1 for k in range(2)]
    found += [2 * n + n1 + i for i in known if i >= n + n1]
    return sorted(found)
