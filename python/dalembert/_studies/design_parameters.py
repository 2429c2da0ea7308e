"""Parameters of exact sensitivities, and derivatives of the equations of a model with respect to them.

Derivatives are differences of fourth order of the equations at a fixed state. Each parameter changes few equations;
parameters
without common equations are varied together, in one set of copies of the model.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from dalembert import _core
from dalembert._checks import FloatArray, shape_error
from dalembert._core import testing
from dalembert._io.pickling import copier
from dalembert._studies.difference_formulas import BACKWARD, CENTRAL, FORWARD, STEP
from dalembert._studies.not_differentiable import NotDifferentiable
from dalembert._tools.found_items import find_item

_KINDS = ("Object", "Node", "Load", "Marker", "Sensor")
_IndexTypes = (_core.ObjectIndex, _core.NodeIndex, _core.LoadIndex, _core.MarkerIndex, _core.SensorIndex)
_ROUND_OFF = 1e-11  # of a residual, relative to its largest entry
_OF_MASS = {"physicsMass", "physicsInertia", "physicsCenterOfMass"}  # of bodies: they move no frame of a marker
Rows = NDArray[np.int_] | None  # None: any
END_TIME = "timeIntegration.endTime"


class DesignParameter:
    """One number that several places of a model depend on.

    value: the number.
    targets: a dictionary with (item, parameter) or (item, parameter, entry) as keys, and as values functions of the
        number, or factors. Without it, only outputs depend on the number, such as the frequency of a FrequencyResponse.
    """

    __module__ = "dalembert"

    def __init__(self, value: float, targets: Mapping[Any, Callable[[float], float] | float] | None = None) -> None:
        if isinstance(value, bool) or not isinstance(value, (int, float, np.number)) or not np.isfinite(value):
            raise shape_error("DesignParameter: value", "a finite number", value)
        if targets is not None and (not isinstance(targets, Mapping) or not targets):
            raise shape_error(
                "DesignParameter: targets",
                "a dictionary, such as {('bar', 'length'): 1.0, ('mass', 'physicsMass'): lambda x: 7850*x}",
                targets,
            )
        self.value, self.targets = float(value), dict(targets or {})


class _Target(NamedTuple):
    """A place that a parameter changes."""

    item: Any
    kind: str
    parameter: str
    entry: tuple[int, ...] | str | None  # str: a variable of a recorded function
    map: Callable[[float], float]

    def current(self, mbs: Any) -> Any:
        found = _get(mbs, self.kind, self.item, self.parameter)
        return found._Variables()[self.entry] if isinstance(self.entry, str) else found

    def restore(self, mbs: Any, value: Any) -> None:
        name = f"{self.parameter}.{self.entry}" if isinstance(self.entry, str) else self.parameter
        getattr(mbs, f"Set{self.kind}Parameter")(self.item, name, value)

    def set(self, mbs: Any, x: float) -> None:
        value = float(self.map(x))
        if self.entry is None or isinstance(self.entry, str):
            return self.restore(mbs, value)
        values = np.array(self.current(mbs), dtype=float)
        values[self.entry] = value
        return self.restore(mbs, values)

    def number(self, mbs: Any) -> float:
        now = self.current(mbs)
        return float(now if self.entry is None or isinstance(self.entry, str) else np.asarray(now)[self.entry])


def describe(mbs: Any, item: Any) -> str:
    """Return such as "object 3 'spring' (SpringDamper)"."""
    kind = item.GetTypeString().removesuffix("Index")
    data = getattr(mbs, f"Get{kind}")(item)
    return f"{kind.lower()} {int(item)} '{data['name']}' ({data[f'{kind.lower()}Type']})"


def _get(mbs: Any, kind: str, item: Any, parameter: str) -> Any:
    return getattr(mbs, f"Get{kind}Parameter")(item, parameter)


class Parameter:
    """A named parameter: its value, where it acts, and how large its differences are."""

    def __init__(self, mbs: Any, name: str, given: Any, settings: Any = None) -> None:
        self.name = name
        where = f"parameter '{name}'"
        self.is_end_time = given == END_TIME if isinstance(given, str) else False
        self.formula: dict[int, float] = {}
        if self.is_end_time:
            self.targets: list[_Target] = []
            self.value, self.step = float(settings.timeIntegration.endTime), 1.0
            return
        if isinstance(given, DesignParameter):
            self.targets = [_target(mbs, where, name, key, map_) for key, map_ in given.targets.items()]
            self.value = given.value
        else:
            self.targets = [
                _target(mbs, where, name, each, 1.0) for each in (given if isinstance(given, list) else [given])
            ]
            if not self.targets:
                raise ValueError(f"{where}: received an empty list, but expected at least one (item, parameter)")
            values = {target.number(mbs) for target in self.targets}
            if len(values) > 1:
                raise ValueError(
                    f"{where}: its places have different values {sorted(values)}; use a "
                    "DesignParameter with a function for each"
                )
            self.value = values.pop()
        self.step = STEP * self._size(mbs)

    def _size(self, mbs: Any) -> float:
        """Return a typical size: the value, the largest entry of its vector, or a length of the model."""
        if self.value != 0:
            return abs(self.value)
        largest = max((float(np.max(np.abs(target.current(mbs)), initial=0.0)) for target in self.targets), default=0.0)
        return largest if largest > 0 else min(1.0, float(testing.extent(mbs)))

    @property
    def changes_model(self) -> bool:
        """Whether equations or the initial state depend on it; the end time, and numbers of outputs alone, do not."""
        return bool(self.targets)

    def set(self, mbs: Any, x: float) -> None:
        for target in self.targets:
            target.set(mbs, x)

    def choose_formula(self, trial: Any) -> None:
        """Find the side to which the parameter may be varied, and check that it stands for what the model has."""
        if not self.changes_model:
            return
        now = [np.array(target.current(trial), dtype=float) for target in self.targets]
        with _named(self.name, self.targets[0], trial):
            self.set(trial, self.value)
        for target, before in zip(self.targets, now, strict=True):
            after = np.array(target.current(trial), dtype=float)
            if np.max(np.abs(after - before), initial=0.0) > 1e-9 * np.max(np.abs(before), initial=0.0) + 1e-12 * abs(
                self.value
            ):
                raise ValueError(
                    f"parameter '{self.name}': {target.parameter} of {describe(trial, target.item)} "
                    f"is {before.tolist()}, but the value of the "
                    f"DesignParameter makes it {after.tolist()}"
                )
        refused: Exception | None = None
        assembles = any(target.kind == "Node" for target in self.targets)
        for formula in (CENTRAL, FORWARD, BACKWARD):
            try:
                for multiple in (min(formula), max(formula)):
                    self.set(trial, self.value + multiple * self.step)
                    if assembles:
                        trial.Assemble()
            except (ValueError, RuntimeError) as error:
                refused = error
            else:
                self.formula = formula
                break
        for target, before in zip(self.targets, now, strict=True):
            target.restore(trial, before if np.ndim(before) else float(before))
        if assembles:
            trial.Assemble()
        if not trial.systemIsConsistent:
            raise NotDifferentiable(
                f"{self.targets[0].parameter} cannot change in an assembled model",
                item=describe(trial, self.targets[0].item),
                parameter=self.name,
            )
        if not self.formula:
            raise NotDifferentiable(
                f"it cannot be varied by {self.step:.3g} to any side ({refused})",
                item=describe(trial, self.targets[0].item),
                parameter=self.name,
            )


class _named:
    """Errors of setting a parameter name it."""

    def __init__(self, name: str, target: _Target, mbs: Any) -> None:
        self.name, self.target, self.mbs = name, target, mbs

    def __enter__(self) -> None:
        pass

    def __exit__(self, kind: Any, error: Any, trace: Any) -> None:
        if isinstance(error, (ValueError, TypeError, RuntimeError)) and not isinstance(error, NotDifferentiable):
            raise NotDifferentiable(
                f"{self.target.parameter} cannot be set ({error})",
                item=describe(self.mbs, self.target.item),
                parameter=self.name,
            ) from error


def _target(mbs: Any, where: str, name: str, given: Any, map_: Any) -> _Target:
    if isinstance(given, str):
        if not _is_setting(given):
            raise ValueError(
                f"{where}: received {given!r}, which is no setting of SimulationSettings, but expected "
                f"(item, parameter), such as ('{given}', 'stiffness'), or '{END_TIME}'"
            )
        raise NotDifferentiable(
            "it is a setting of the solver",
            item=given,
            parameter=name,
            advice=f"use '{END_TIME}', parameters of items, or processing.ComputeSensitivities",
        )
    if not isinstance(given, tuple) or len(given) not in (2, 3) or not isinstance(given[1], str):
        expected = "(item, parameter), (item, parameter, entry), a list of these, or a DesignParameter"
        raise ValueError(f"{where}: received {given!r}, but expected {expected}")
    item = find_item(mbs, given[0], _KINDS, where) if isinstance(given[0], str) else given[0]
    if not isinstance(item, _IndexTypes):
        raise ValueError(
            f"{where}: received {given[0]!r} as item, but expected its name, or the index that it got when it was added"
        )
    kind = item.GetTypeString().removesuffix("Index")
    try:
        now = _get(mbs, kind, item, given[1])
    except (ValueError, IndexError, KeyError, TypeError) as error:
        raise type(error)(f"{where}: {error}") from None
    text = describe(mbs, item)
    function = map_ if callable(map_) else lambda x, factor=float(map_): factor * x
    if isinstance(now, _core.symbolic.UserFunction):
        variables = now._Variables()
        if len(given) == 3 and isinstance(given[2], str) and given[2] in variables:
            return _Target(item, kind, given[1], given[2], function)
        advice = (
            f"pass (item, parameter, name) with one of {', '.join(variables)}"
            if variables
            else ("let it read a symbolic.Real with a name, or symbolic.variables")
        )
        raise ValueError(f"{where}: received {given!r}, but {given[1]} of {text} is a recorded function; {advice}")
    if isinstance(now, (bool, int, np.integer, np.bool_, str)) or not _is_real(now):
        what = "an integer" if isinstance(now, (int, np.integer)) and not isinstance(now, bool) else "not a real number"
        raise NotDifferentiable(f"{given[1]} is {what}: {now!r}", item=text, parameter=name)
    shape = np.shape(now)
    if len(given) == 2:
        if shape != ():
            raise ValueError(
                f"{where}: {given[1]} of {text} has the shape {shape}; pass (item, parameter, entry), "
                f"such as {(given[0], given[1], (0,) * len(shape) if len(shape) > 1 else 0)}"
            )
        entry = None
    else:
        entry = given[2] if isinstance(given[2], tuple) else (given[2],)
        fits = len(entry) == len(shape) and all(
            isinstance(i, (int, np.integer)) and 0 <= i < size for i, size in zip(entry, shape, strict=False)
        )
        if not fits:
            raise ValueError(f"{where}: received entry {given[2]!r} of {given[1]}, which has the shape {shape}")
    return _Target(item, kind, given[1], entry, function)


def _is_setting(path: str) -> bool:
    found: Any = _core.SimulationSettings()
    for name in path.split("."):
        if not hasattr(found, name):
            return False
        found = getattr(found, name)
    return True


def _is_real(value: Any) -> bool:
    try:
        numbers = np.asarray(value)
    except ValueError:
        return False
    return numbers.dtype.kind == "f" or (numbers.dtype.kind == "i" and isinstance(value, (list, np.ndarray)))


class Structure:
    """Equations that items act on."""

    def __init__(self, mbs: Any) -> None:
        self._mbs, data = mbs, mbs.systemData
        self._ode2, self._ode1 = data.ODE2Size(), data.ODE1Size()
        self._objects = [mbs.GetObject(i) for i in range(data.NumberOfObjects())]
        self._markers = [mbs.GetMarker(i) for i in range(data.NumberOfMarkers())]
        self._on_marker: dict[int, list[int]] = {}
        self._on_body: dict[int, list[int]] = {}
        for i, entries in enumerate(self._objects):
            for marker in _references(entries, _core.MarkerIndex):
                self._on_marker.setdefault(marker, []).append(i)
        for i, entries in enumerate(self._markers):
            for body in _references(entries, _core.ObjectIndex):
                self._on_body.setdefault(body, []).append(i)

    def of_object(self, number: int) -> set[int]:
        """Return equations, and with them coordinates, of an object alone."""
        data = self._mbs.systemData
        return (
            set(data.GetObjectLTGODE2(number))
            | {self._ode2 + i for i in data.GetObjectLTGODE1(number)}
            | {self._ode2 + self._ode1 + i for i in data.GetObjectLTGAE(number)}
        )

    def of_node(self, number: int) -> set[int]:
        data = self._mbs.systemData
        return (
            set(data.GetNodeLTGODE2(number))
            | {self._ode2 + i for i in data.GetNodeLTGODE1(number)}
            | {self._ode2 + self._ode1 + i for i in data.GetNodeLTGAE(number)}
        )

    def of_marker(self, number: int) -> set[int] | None:
        entries = self._markers[number]
        bodies, nodes = _references(entries, _core.ObjectIndex), _references(entries, _core.NodeIndex)
        if not bodies and not nodes:
            return None
        found: set[int] = set()
        for body in bodies:
            found |= self.of_object(body)
        for node in nodes:
            found |= self.of_node(node)
        return found

    def affected_by(self, item: Any, parameter: str) -> set[int] | None:
        """Return all equations that a parameter of an item may change; None: any."""
        number = int(item)
        if isinstance(item, _core.LoadIndex):
            markers = _references(self._mbs.GetLoad(item), _core.MarkerIndex)
            parts = [self.of_marker(marker) for marker in markers]
            return None if not parts or None in parts else set().union(*(part for part in parts if part is not None))
        if not isinstance(item, _core.ObjectIndex) or _references(self._objects[number], _core.ObjectIndex):
            return None
        found = self.of_object(number)
        if parameter in _OF_MASS:
            return found or None
        for marker in self._on_body.get(number, ()):
            for other in self._on_marker.get(marker, ()):
                found |= self.of_object(other)
        return found or None

    def of_sensor(self, number: int) -> set[int] | None:
        """Return coordinates that a sensor reads; None: any."""
        entries = self._mbs.GetSensor(number)
        found: set[int] = set()
        known = False
        for node in _references(entries, _core.NodeIndex):
            known, found = True, found | self.of_node(node)
        for body in _references(entries, _core.ObjectIndex):
            known, found = True, found | self.of_object(body)
        others = [*_references(entries, _core.SensorIndex), *_references(entries, _core.LoadIndex)]
        for marker in _references(entries, _core.MarkerIndex):
            part = self.of_marker(marker)
            if part is None:
                return None
            known, found = True, found | part
        return found if known and not others else None


def _references(entries: Mapping[str, Any], kind: type) -> list[int]:
    """Return numbers of items of a kind in the values of a dictionary."""
    found = []
    for value in entries.values():
        for each in value if isinstance(value, (list, tuple)) else [value]:
            if isinstance(each, kind):
                found.append(int(each))  # type: ignore[call-overload]
    return found


class Variant(NamedTuple):
    """A copy of the model with varied parameters."""

    mbs: Any
    derivatives: Any
    shift: FloatArray | None  # of displacements: total rotations of Lie-group nodes are the same in all copies
    start: FloatArray  # q, v and y at the start


class _Group(NamedTuple):
    """Parameters that are varied together, by one formula.

    rows: equations of the first parameter, then those of the second, ...; owners: for each of them, the parameter;
    begins: where those
    of each begin.
    """

    members: list[int]
    formula: dict[int, float]
    variants: dict[int, Variant]
    rows: Any
    owners: NDArray[np.int_]
    begins: NDArray[np.int_]


class Parameters:
    """All parameters of a computation, with the copies of the model in which they are varied."""

    def __init__(
        self,
        base: Any,
        parameters: Sequence[Parameter],
        sensors: Sequence[int],
        options: dict[str, Any],
        state: tuple[FloatArray, float],
        *,
        together: bool = True,
    ) -> None:
        """together: parameters without common equations are varied at the same time."""
        self.all, self._together = list(parameters), together
        self._options = options
        self.structure = Structure(base)
        size = base.systemData.SystemSize()
        self.rows: list[Rows] = []  # by parameter: equations
        self.sensors: list[set[int] | None] = []  # ... and sensors
        self.reads = {sensor: self.structure.of_sensor(sensor) for sensor in sensors}
        for parameter in self.all:
            affected = self._affected(parameter)
            self.rows.append(None if affected is None else np.array(sorted(affected), dtype=int))
            self.sensors.append(
                None
                if affected is None
                else {s for s, reads in self.reads.items() if reads is None or reads & affected}
            )
        self.size = size
        self._copied = copier(base)
        trial = self._copied()
        for parameter in self.all:
            parameter.choose_formula(trial)
        self._check_rows(trial, *state)
        self.steps = np.array([parameter.step for parameter in self.all])
        self.base = self._variant(base, base, [], 0)
        self.groups = [self._group(base, members) for members in self._colours()]

    def _check_rows(self, trial: Any, z: FloatArray, time: float) -> None:
        """Refuse parameters with a jump at their value, and those that act on equations of other items."""
        derivatives = testing.SystemDerivatives(trial, **self._options)
        count = len(z) - derivatives.sizes[3]
        moved = z.copy()
        moved[:count] += 1e-2 * np.cos(np.arange(count)) * (1e-2 + np.abs(z[:count]).max(initial=0.0))
        for parameter, rows in zip(self.all, self.rows, strict=True):
            if not parameter.changes_model or any(target.kind == "Node" for target in parameter.targets):
                continue
            before, near, far = self._at_distances(trial, parameter, derivatives, moved, time)
            noise = _ROUND_OFF * np.abs(before).max(initial=0.0)
            change = np.abs(far - before)
            if np.abs(near - before).max(initial=0.0) > 0.1 * change.max(initial=0.0) + noise:
                raise NotDifferentiable(
                    f"{parameter.targets[0].parameter} switches something on or off at {parameter.value:.6g}",
                    item=describe(trial, parameter.targets[0].item),
                    parameter=parameter.name,
                    advice="choose another value",
                )
            if rows is None:
                continue
            changed = np.flatnonzero(change > noise)
            own = np.zeros(self.size, dtype=bool)
            own[rows] = True
            others = changed[~own[changed]]
            if len(others):
                raise NotDifferentiable(
                    f"it acts on equations of other items, such as {testing.describe_row(trial, int(others[0]))}",
                    item=describe(trial, parameter.targets[0].item),
                    parameter=parameter.name,
                )

    def _at_distances(
        self, trial: Any, parameter: Parameter, derivatives: Any, z: FloatArray, time: float
    ) -> list[FloatArray]:
        """Return residuals at the value of a parameter, very close to it, and at the largest step from it."""
        largest = max(parameter.formula, key=abs) * parameter.step
        found = []
        for part in (0.0, 1e-3, 1.0):
            parameter.set(trial, parameter.value + part * largest)
            found.append(np.asarray(derivatives.residual(z, time, 1.0)))
        parameter.set(trial, parameter.value)
        return found

    def _affected(self, parameter: Parameter) -> set[int] | None:
        found: set[int] = set()
        for target in parameter.targets:
            part = self.structure.affected_by(target.item, target.parameter)
            if part is None:
                return None
            found |= part
        return found

    def _colours(self) -> Iterator[list[int]]:
        """Yield parameters without common equations or sensors, and with the same formula, together."""
        open_groups: list[tuple[list[int], set[int], set[int]]] = []
        for k, (parameter, rows, sensors) in enumerate(zip(self.all, self.rows, self.sensors, strict=True)):
            if not parameter.changes_model:
                continue
            if rows is None or sensors is None or not self._together:
                yield [k]
                continue
            own = set(rows.tolist())
            for members, used, measured in open_groups:
                same = self.all[members[0]].formula is parameter.formula
                if same and not own & used and not sensors & measured:
                    members.append(k)
                    used |= own
                    measured |= sensors
                    break
            else:
                open_groups.append(([k], own, set(sensors)))
        for members, _, _ in open_groups:
            yield members

    def _group(self, base: Any, members: list[int]) -> _Group:
        formula = self.all[members[0]].formula
        variants = {
            multiple: self.base if multiple == 0 else self._variant(base, self._copied(), members, multiple)
            for multiple in formula
        }
        if self.rows[members[0]] is None:
            return _Group(
                members, formula, variants, slice(None), np.full(self.size, members[0]), np.zeros(1, dtype=int)
            )
        rows = [np.asarray(self.rows[k]) for k in members]
        sizes = [len(each) for each in rows]
        begins = np.concatenate(([0], np.cumsum(sizes)[:-1]))
        return _Group(members, formula, variants, np.concatenate(rows), np.repeat(members, sizes), begins)

    def _variant(self, base: Any, made: Any, members: list[int], multiple: int) -> Variant:
        data, initial, reference = base.systemData, _core.ConfigurationType.Initial, _core.ConfigurationType.Reference

        def start(mbs: Any) -> FloatArray:
            d = mbs.systemData
            return np.concatenate(
                (d.GetODE2Coordinates(initial), d.GetODE2Coordinates_t(initial), d.GetODE1Coordinates(initial))
            )

        now = start(base)
        moved = np.zeros(data.ODE2Size())
        if members and not any(target.kind == "Node" for k in members for target in self.all[k].targets):
            for k in members:
                self.all[k].set(made, self.all[k].value + multiple * self.all[k].step)
        elif members:
            made.Assemble()
            from_nodes = start(made)  # users may have set other initial values
            for k in members:
                self.all[k].set(made, self.all[k].value + multiple * self.all[k].step)
            made.Assemble()
            now = now + (start(made) - from_nodes)
            moved = made.systemData.GetODE2Coordinates(reference) - data.GetODE2Coordinates(reference)
        derivatives = testing.SystemDerivatives(made, **self._options)
        turned = (np.array(derivatives.rotations, dtype=int)[:, None] + np.arange(3)).ravel()
        shift = np.zeros_like(moved)
        shift[turned] = -moved[turned]
        return Variant(made, derivatives, shift if shift.any() else None, now)

    @property
    def systems(self) -> list[Any]:
        """The SystemDerivatives of all copies of the model."""
        variants = (self.base, *(each for group in self.groups for each in group.variants.values()))
        return [variant.derivatives for variant in variants]

    def shifted(self, variant: Variant, z: FloatArray) -> FloatArray:
        """Return a state in the displacements of a copy."""
        if variant.shift is None:
            return z
        z = z.copy()
        z[: len(variant.shift)] += variant.shift
        return z

    def rates(self, evaluate: Callable[[_Group], FloatArray]) -> FloatArray:
        """Return derivatives of equations, from weighted sums for each group: a row per parameter."""
        found = np.zeros((len(self.all), self.size))
        for group in self.groups:
            rows = np.arange(self.size) if isinstance(group.rows, slice) else group.rows
            found[group.owners, rows] = evaluate(group)[group.rows] / self.steps[group.owners]
        return found

    def weighted_rates(self, evaluate: Callable[[_Group], FloatArray], weights: FloatArray) -> FloatArray:
        """Return products of weights, in rows, with these derivatives: a column per parameter."""
        found = np.zeros((len(weights), len(self.all)))
        for group in self.groups:
            products = weights[:, group.rows] * evaluate(group)[group.rows]
            found[:, group.members] = np.add.reduceat(products, group.begins, axis=1)
        return found / self.steps

    def scalar_rates(self, evaluate: Callable[[Variant], Any]) -> FloatArray:
        """Return derivatives of a number; parameters have to be varied one by one."""
        rates = np.zeros(len(self.all))
        for group in self.groups:
            rates[group.members[0]] = float(weighted(evaluate)(group))
        return rates / self.steps

    def weighted_rates_of(
        self, states: FloatArray, times: FloatArray, step_size: float, weights: FloatArray
    ) -> FloatArray:
        """Return sums over states of products of weights (states x outputs x equations) with derivatives.

        A column per parameter. Each copy of the model evaluates all states before the next one: it stays in the caches.
        """
        found = np.zeros((weights.shape[1], len(self.all)))
        for group in self.groups:
            total = np.zeros((weights.shape[1], self.size))
            for multiple, weight in group.formula.items():
                variant = group.variants[multiple]
                total += weight * variant.derivatives.weighted_residuals(
                    self._all_shifted(variant, states), times, step_size, weights
                )
            found[:, group.members] = np.add.reduceat(total[:, group.rows], group.begins, axis=1)
        return found / self.steps

    def rates_of(self, states: FloatArray, times: FloatArray, step_size: float) -> FloatArray:
        """Return derivatives of equations at several states: states x parameters x equations."""
        found = np.zeros((len(states), len(self.all), self.size))
        for group in self.groups:
            total = np.zeros((len(states), self.size))
            for multiple, weight in group.formula.items():
                variant = group.variants[multiple]
                total += weight * variant.derivatives.residuals(self._all_shifted(variant, states), times, step_size)
            rows = np.arange(self.size) if isinstance(group.rows, slice) else group.rows
            found[:, group.owners, rows] = total[:, group.rows] / self.steps[group.owners]
        return found

    def _all_shifted(self, variant: Variant, states: FloatArray) -> FloatArray:
        if variant.shift is None:
            return states
        states = states.copy()
        states[:, : len(variant.shift)] += variant.shift
        return states

    def residual_at(self, z: FloatArray, time: float, step_size: float) -> Callable[[_Group], FloatArray]:
        """Return what `rates` evaluates for the equations of motion at a state."""

        def evaluate(group: _Group) -> FloatArray:
            variants = [group.variants[multiple] for multiple in group.formula]
            systems, states = [v.derivatives for v in variants], [self.shifted(v, z) for v in variants]
            return testing.residual_sum(systems, list(group.formula.values()), states, time, step_size)

        return evaluate

    def sensor_rates(self, sensor: int, z: FloatArray, time: float) -> Iterator[tuple[int, FloatArray]]:
        """Yield explicit derivatives of the values of a sensor at a state."""
        for group in self.groups:
            concerned = [k for k in group.members if (known := self.sensors[k]) is None or sensor in known]
            if not concerned:
                continue
            (k,) = concerned  # parameters that act on one sensor are in different groups
            measure = weighted(lambda v: v.derivatives.sensor(sensor, self.shifted(v, z), time))
            total = measure(group)
            yield k, total / self.all[k].step


def weighted(evaluate: Callable[[Variant], FloatArray]) -> Callable[[_Group], FloatArray]:
    """Return the weighted sum of values for all variants of a group, as a function of the group."""

    def total(group: _Group) -> FloatArray:
        found: Any = 0.0
        for multiple, weight in group.formula.items():
            found = found + weight * evaluate(group.variants[multiple])
        return np.asarray(found)

    return total
