"""A model as a function of its parameters, for the studies in dalembert.processing: many sets are solved at once."""

# ruff: noqa: B006  (empty mappings as defaults; they are never written to)
from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dalembert._calls import check_given
from dalembert._checks import check_type, shape_error
from dalembert._core import DynamicSolverType, MainSystem, SimulationSettings
from dalembert._studies.execution import FailedEvaluation, ParameterSet, number_of_threads
from dalembert._studies.variations import SolveVariations, VariationResults
from dalembert._tools.found_items import find_item, index_of

_KINDS = ("Object", "Node", "Load", "Marker")
_PORTIONS = 50  # that a study is divided into, for its progress
_TOGETHER = 64  # minimum number of variations in a portion: some vector lanes for each thread


class _Target(NamedTuple):
    """Target of a name: a parameter of an item, one entry of it, or a setting."""

    item: Any  # None: a setting
    parameter: str
    entry: int | None


class FailedVariation(ValueError):
    """A variation that could not be solved; its text is the diagnosis of the solver."""

    __module__ = "dalembert"


class VariedModel:
    """One assembled model as a function of some of its parameters, which solves many parameter sets at once.

    mbs: the model; it may not contain Python functions, and does not change.
    parameters: keys are user-defined names, values are (item, parameter), (item, parameter, entry) for one entry of a
    vector, or the path
        of a setting, such as 'timeIntegration.endTime'; items are indices or names. A list of these gets one value.
    result: the name or index of a sensor, whose values at the end are returned, or a function that gets all
        VariationResults and the number of one variation, and returns the desired result.
    simulationSettings, solverType, and options such as storeHistories: see mbs.SolveVariations.

    Called with a dictionary, as objective functions are, it solves one variation. ParameterVariation,
    GeneticOptimization and ComputeSensitivities give it all sets that they know, and no processes are needed. Values
    takes arrays, as vectorized optimizers do.
    """

    def __init__(
        self,
        mbs: Any,
        parameters: Mapping[str, Any],
        result: Any,
        simulationSettings: Any = None,
        solverType: Any = None,
        numberOfThreads: int | None = None,
        **options: Any,
    ) -> None:
        check_given(VariedModel.__init__, locals().items())
        check_type("VariedModel: mbs", mbs, MainSystem)
        if not isinstance(parameters, Mapping):
            expected = "a dictionary, such as {'k': ('spring', 'stiffness')}"
            raise shape_error("VariedModel: parameters", expected, parameters)
        if not parameters:
            raise ValueError("VariedModel: parameters must not be empty")
        if simulationSettings is not None:
            check_type("VariedModel: simulationSettings", simulationSettings, SimulationSettings)
        if not (solverType is None or solverType == "static" or isinstance(solverType, DynamicSolverType)):
            raise shape_error("VariedModel: solverType", "a DynamicSolverType, 'static' or None", solverType)
        self.mbs, self.simulationSettings, self.numberOfThreads = mbs, simulationSettings, numberOfThreads
        self.targets = {name: _targets(mbs, name, given) for name, given in parameters.items()}
        self.result: Callable[[VariationResults, int], Any] = result if callable(result) else _values_of(mbs, result)
        self.options = options if solverType is None else {"solverType": solverType, **options}

    def __call__(self, parameterSet: ParameterSet) -> Any:
        """Return the result for one set of parameters; ValueError with the diagnosis if it cannot be solved."""
        (value,) = self.outcomes([parameterSet])
        if isinstance(value, FailedEvaluation):
            raise FailedVariation(value.message)
        return value

    def Values(self, parameters: Mapping[str, ArrayLike]) -> NDArray[Any]:
        """Return results for arrays of parameters, one row per entry; NaN where a variation could not be solved."""
        columns = {name: np.atleast_1d(np.asarray(values)) for name, values in parameters.items()}
        results = self._solve(columns)
        wanted = {int(k): self.result(results, int(k)) for k in np.flatnonzero(results.success)}
        shape = np.shape(next(iter(wanted.values()), 0.0))
        found = np.full((len(results.success), *shape), np.nan)
        for k, value in wanted.items():
            found[k] = value
        return found

    def outcomes(self, sets: Sequence[ParameterSet]) -> list[Any]:
        """Return results of all sets; a set that could not be solved is a FailedEvaluation."""
        results = self._solve({name: np.array([each[name] for each in sets]) for name in self._given(sets[0])})
        return [
            self.result(results, k) if results.success[k] else FailedEvaluation(results.messages[k])
            for k in range(len(sets))
        ]

    def in_portions(self, sets: Sequence[ParameterSet], threads: int | None) -> Iterator[Any]:
        """Yield results of all sets in order; portions are solved when they are asked for."""
        if threads is not None:
            self.numberOfThreads = threads
        least = _TOGETHER * number_of_threads(self.numberOfThreads)
        size = max(least, -(-len(sets) // _PORTIONS))
        for begin in range(0, len(sets), size):
            yield from self.outcomes(sets[begin : begin + size])

    def _given(self, names: Mapping[str, Any]) -> list[str]:
        given = [name for name in names if name not in ("computationIndex", "functionData")]
        for name in given:
            if name not in self.targets:
                known = ", ".join(self.targets)
                raise ValueError(f"VariedModel: received parameter '{name}', but expected one of {known}")
        return given

    def _solve(self, columns: Mapping[str, NDArray[Any]]) -> VariationResults:
        parameters: dict[tuple[Any, str], NDArray[Any]] = {}
        settings: dict[str, NDArray[Any]] = {}
        for name in self._given(columns):
            values = columns[name]
            for item, parameter, entry in self.targets[name]:
                if item is None:
                    settings[parameter] = values
                elif entry is None:
                    parameters[item, parameter] = values
                else:
                    if (item, parameter) not in parameters:
                        now = np.asarray(_parameter(self.mbs, item, parameter), dtype=float)
                        parameters[item, parameter] = np.tile(now, (len(values), 1))
                    parameters[item, parameter][:, entry] = values
        return SolveVariations(
            self.mbs, parameters, self.simulationSettings, settings=settings, numberOfThreads=self.numberOfThreads,
            **self.options,
        )  # fmt: skip


def _parameter(mbs: Any, item: Any, parameter: str) -> Any:
    kind = item.GetTypeString().removesuffix("Index")
    return getattr(mbs, f"Get{kind}Parameter")(item, parameter)


def _targets(mbs: Any, name: str, given: Any) -> list[_Target]:
    return [_target(mbs, name, each) for each in (given if isinstance(given, list) else [given])]


def _target(mbs: Any, name: str, given: Any) -> _Target:
    where = f"VariedModel: parameters['{name}']"
    if isinstance(given, str):
        return _Target(None, given, None)
    if not isinstance(given, tuple) or len(given) not in (2, 3) or not isinstance(given[1], str):
        expected = "(item, parameter), (item, parameter, entry), the path of a setting, or a list of these"
        raise ValueError(f"{where}: received {given!r}, but expected {expected}")
    item = find_item(mbs, given[0], _KINDS, where) if isinstance(given[0], str) else given[0]
    if not hasattr(item, "GetTypeString"):
        raise ValueError(f"{where}: received {given[0]!r} as item, but expected its name, or the index that it got")
    now = _parameter(mbs, item, given[1])
    if len(given) == 2:
        return _Target(item, given[1], None)
    if np.ndim(now) != 1 or not 0 <= given[2] < len(now):
        expected = f"an entry from 0 to {len(now) - 1}" if np.ndim(now) == 1 else "no entry, because it is not a vector"
        raise ValueError(f"{where}: received entry {given[2]!r} of '{given[1]}', but expected {expected}")
    return _Target(item, given[1], int(given[2]))


def _values_of(mbs: Any, sensor: Any) -> Callable[[VariationResults, int], Any]:
    sensor = index_of(mbs, "Sensor", sensor, "VariedModel: result")

    def values(results: VariationResults, variation: int) -> Any:
        found = results.SensorValues(sensor)[variation]
        return float(found[0]) if len(found) == 1 else found

    return values
