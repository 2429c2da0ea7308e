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

# A sensor by its number; or ("z", entry of the state [q, v, a, y, y_t, lambda]) or ("eigenvalue", number).
Source = int | tuple[str, int]


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
    """The model, and the times of all steps."""

    mbs: Any
    times: FloatArray
    static: bool

    def step(self, name: str, time: float | None) -> int:
        """Return the step that ends at a time."""
        if time is None:
            return len(self.times) - 1
        size = self.times[1] - self.times[0] if len(self.times) > 1 else 1.0
        step = int(np.argmin(np.abs(self.times - time)))
        if abs(self.times[step] - time) > 1e-6 * size:
            inside = self.times[0] <= time <= self.times[-1]
            advice = "choose steps that end there" if inside else "it has to lie within the computed time"
            raise ValueError(
                f"output '{name}': no step ends at time {time:.10g} s; steps of {size:.10g} s go from "
                f"{self.times[0]:.10g} s to {self.times[-1]:.10g} s; {advice}"
            )
        return step

    def sensor(self, name: str, sensor: Any) -> int:
        where = f"output '{name}'"
        found = find_item(self.mbs, sensor, ("Sensor",), where) if isinstance(sensor, str) else sensor
        return int(index_of(self.mbs, "Sensor", found, where))


Values = Mapping[Sample, FloatArray]


class Output(ABC):
    """One or more numbers."""

    __module__ = "dalembert"
    size = 1

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

    Steps have to end at these times.
    """

    __module__ = "dalembert"

    def __init__(self, sensor: Any, time: float | ArrayLike | None = None, component: int = 0) -> None:
        self.sensor, self.component = sensor, component
        if time is None or np.ndim(time) == 0:
            self.times: list[float | None] = [None if time is None else float(np.asarray(time))]
        else:
            self.times = list(as_vector("At: time", time))
            if not self.times:
                raise shape_error("At: time", "a time, or a list of at least one time", time)
        self.size = len(self.times)

    def samples(self, name: str, context: Context) -> Iterator[Sample]:
        for time in self.times:
            yield Sample(context.step(name, time), context.sensor(name, self.sensor))

    def value(self, name: str, context: Context, values: Values) -> FloatArray:
        found = [values[sample] for sample in self.samples(name, context)]
        return np.array([_component(name, each, self.component) @ each for each in found])

    def seeds(self, name: str, context: Context, values: Values) -> Iterator[Seed]:
        for row, sample in enumerate(self.samples(name, context)):
            yield Seed(row, sample, _component(name, values[sample], self.component))


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

    def _weights(self, samples: Sequence[Sample], context: Context) -> FloatArray:
        times = context.times[[sample.step for sample in samples]]
        weights = np.zeros(len(times))
        weights[:-1] += 0.5 * np.diff(times)
        weights[1:] += 0.5 * np.diff(times)
        return weights

    def _integrand(self, name: str, x: FloatArray) -> float:
        if self.function is None:
            return float(_component(name, x, self.component) @ x)
        return float(self.function(x))

    def value(self, name: str, context: Context, values: Values) -> FloatArray:
        samples = list(self.samples(name, context))
        integrand = [self._integrand(name, values[sample]) for sample in samples]
        return np.array([self._weights(samples, context) @ integrand])

    def seeds(self, name: str, context: Context, values: Values) -> Iterator[Seed]:
        samples = list(self.samples(name, context))
        for sample, weight in zip(samples, self._weights(samples, context), strict=True):
            x = values[sample]
            if self.function is None:
                slope = _component(name, x, self.component)
            elif self.derivative is not None:
                slope = as_vector(f"output '{name}': derivative", self.derivative(x), len(x))
            else:
                slope = gradient(self.function, x)
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


class Eigenvalue(Output):
    """An eigenvalue of the undamped system at its static equilibrium: the square of a circular frequency, in (rad/s)^2.

    mode: its number, beginning with 0 for the smallest one.
    """

    __module__ = "dalembert"

    def __init__(self, mode: int = 0) -> None:
        if isinstance(mode, bool) or not isinstance(mode, (int, np.integer)) or mode < 0:
            raise shape_error("Eigenvalue: mode", "a number of a mode, 0, 1, ...", mode)
        self.mode = int(mode)

    def samples(self, name: str, context: Context) -> Iterator[Sample]:
        if not context.static:
            raise NotDifferentiable(
                "eigenvalues are those of a static equilibrium",
                item=f"output '{name}'",
                advice="use solverType='static'",
            )
        yield Sample(0, ("eigenvalue", self.mode))

    def value(self, name: str, context: Context, values: Values) -> FloatArray:
        return np.concatenate([values[sample] for sample in self.samples(name, context)])

    def seeds(self, name: str, context: Context, values: Values) -> Iterator[Seed]:
        for sample in self.samples(name, context):
            yield Seed(0, sample, np.ones(1))


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

    def _call(self, x: FloatArray, sizes: Sequence[int]) -> float:
        parts = np.split(x, np.cumsum(sizes)[:-1])
        arguments = [
            float(part[0]) if i >= len(self.sensors) and len(part) == 1 else part for i, part in enumerate(parts)
        ]
        return float(self.function(*arguments))

    def value(self, name: str, context: Context, values: Values) -> FloatArray:
        arguments = self._arguments(name, context, values)
        return np.array([self._call(np.concatenate(arguments), [len(each) for each in arguments])])

    def seeds(self, name: str, context: Context, values: Values) -> Iterator[Seed]:
        arguments = self._arguments(name, context, values)
        sizes = [len(each) for each in arguments]
        slopes = np.split(gradient(lambda x: self._call(x, sizes), np.concatenate(arguments)), np.cumsum(sizes)[:-1])
        for sample, slope in zip(self._of_sensors(name, context), slopes, strict=False):
            yield Seed(0, sample, slope)
        for output, slope in zip(self.outputs, slopes[len(self.sensors) :], strict=True):
            for seed in output.seeds(name, context, values):
                yield Seed(0, seed.sample, slope[seed.row] * seed.weights)


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
