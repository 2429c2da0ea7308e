"""Search for a minimum with generations of parameter sets."""

# ruff: noqa: B006  (the interface has these defaults; they are never written to)
from __future__ import annotations

import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from dalembert._calls import checked
from dalembert._checks import check_integer
from dalembert._studies.execution import (
    AddComputationIndexAndFunctionData,
    Function,
    ParameterSet,
    ProcessParameterList,
    WriteToFile,
    check_names,
    check_study,
    known_values,
    number_of_threads,
    results_file,
    scalar_objective,
    write,
)

Ranges = Mapping[str, tuple[float, float]]


@dataclass
class _Breeding:
    """How children are made from the survivors of a generation."""

    ranges: Ranges
    distribution: str
    crossover_probability: float

    def first(self, n: int) -> list[ParameterSet]:
        """Return n parameter sets, uniformly distributed."""
        return [{name: np.random.uniform(*limits[:2]) for name, limits in self.ranges.items()} for _ in range(n)]

    def _child(self, parent: ParameterSet, relative_range: float) -> ParameterSet:
        """Return a parameter set near its parent, within the ranges."""
        child = {}
        for name, (low, high, *_) in self.ranges.items():
            width = (high - low) * relative_range
            begin, end = max(parent[name] - 0.5 * width, low), min(parent[name] + 0.5 * width, high)
            child[name] = self._draw(begin, end, low, high)
        return child

    def _draw(self, begin: float, end: float, low: float, high: float) -> float:
        """Return a random number between low and high: uniform in [begin, end], or normal with it as 2 sigma."""
        if self.distribution == "uniform":
            return float(np.random.uniform(begin, end))
        while True:
            value = float(np.random.normal(loc=0.5 * (begin + end), scale=0.5 * (end - begin)))
            if low <= value <= high:
                return value

    def _parents(self, survivor: ParameterSet, survivors: list[ParameterSet]) -> list[ParameterSet]:
        """Return the survivor itself or, with the crossover probability, two survivors drawn at random.

        The draw per parameter belongs to the sequence of random numbers on which reference results rest.
        """
        if self.crossover_probability <= 0 or np.random.random() >= self.crossover_probability:
            return [survivor]
        pair = [survivors[np.random.randint(len(survivors))] for _ in range(2)]
        for _ in self.ranges:
            np.random.random()
        return pair

    def next(self, survivors: list[ParameterSet], n: int, relative_range: float) -> list[ParameterSet]:
        """Return n children; `relative_range`: width of their distribution relative to the ranges."""
        children: list[ParameterSet] = []
        while len(children) < n:
            for survivor in survivors:
                for parent in self._parents(survivor, survivors):
                    children.append(self._child(parent, relative_range))
        return children[:n]


def _survivors(generation: list[ParameterSet], order: list[int], n: int, distance: float, ranges: Ranges) -> list[int]:
    """Return the indices of the best n; a distance is the minimum relative distance from all better ones."""
    if distance == 0:
        return order[:n]
    names, widths = list(ranges), np.array([limits[1] - limits[0] for limits in ranges.values()])
    points = np.array([[individual[name] for name in names] for individual in generation]) / widths
    nearest = np.ones(len(generation))
    chosen: list[int] = []
    for i in order:
        if len(chosen) == n:
            break
        if nearest[i] > distance:
            chosen.append(i)
            nearest = np.minimum(nearest, np.sqrt(np.mean((points - points[i]) ** 2, axis=1)))
    return chosen


def _check_ranges(parameters: Ranges) -> None:
    for name, limits in parameters.items():
        if len(limits) < 2 or not limits[0] < limits[1]:
            raise ValueError(f"GeneticOptimization: range of {name!r} must be (begin, end), begin < end, not {limits}")
        if len(limits) > 2:
            text = f"GeneticOptimization: of the range {limits} of {name!r}, begin and end alone have an effect"
            warnings.warn(text, stacklevel=4)


def _number_of_survivors(elitistRatio: float, populationSize: int, extra: Mapping[str, Any]) -> int:
    for name in {"survivingIndividuals", "numberOfChildren"} & set(extra):
        warnings.warn(f"GeneticOptimization: {name} is deprecated: set populationSize and elitistRatio", stacklevel=4)
    n = int(extra.get("survivingIndividuals", int(elitistRatio * populationSize)))
    if n < 1:
        warnings.warn(
            f"GeneticOptimization: elitistRatio*populationSize = {elitistRatio * populationSize:g} leaves no "
            "survivors; one is taken",
            stacklevel=4,
        )
    return max(n, 1)


@checked
def GeneticOptimization(
    objectiveFunction: Function,
    parameters: Mapping[str, Any],
    populationSize: int = 100,
    numberOfGenerations: int = 10,
    elitistRatio: float = 0.1,
    crossoverProbability: float = 0.25,
    crossoverAmount: float = 0.5,
    rangeReductionFactor: float = 0.7,
    distanceFactor: float = 0.1,
    childDistribution: str = "uniform",
    distanceFactorGenerations: int = -1,
    debugMode: bool = False,
    addComputationIndex: bool = False,
    useMultiProcessing: Any = False,
    showProgress: bool = True,
    clusterHostNames: Any = [],
    parameterFunctionData: Mapping[str, Any] = {},
    **kwargs: Any,
) -> list[Any]:
    """Search the minimum of an objective function, and return [best parameters, best value, parameters, values].

    objectiveFunction: gets a dictionary of parameters and returns a number, or several whose norm counts.
    parameters: (begin, end) per name. The result has a dictionary of the best parameters, their objective, a
        dictionary with an array per parameter and the list of objectives for all parameter sets evaluated.
    populationSize, numberOfGenerations: sizes; initialPopulationSize (kwargs) is the size of the first generation.
    elitistRatio: part of a generation that survives; children are drawn around the survivors, in ranges that shrink
        by rangeReductionFactor per generation; childDistribution is 'uniform' or 'normal'.
    crossoverProbability: probability that a pair of random survivors replaces a single one; the children of
        a pair are drawn around both. crossoverAmount is accepted and has no effect.
    distanceFactor: survivors keep this distance, relative to the ranges, so that several minima are searched; 0: no
        distance. It is dropped from generation distanceFactorGenerations on (-1: never).
    addComputationIndex, parameterFunctionData: adds 'computationIndex' and 'functionData' to parameter sets.
    useMultiProcessing, clusterHostNames, showProgress, numberOfThreads, useMPI, keepFailures: see ProcessParameterList.
    kwargs: randomizerInitialization (int: reproducible results), resultsFile (written after each generation), restart
        (goes on with the resultsFile of the same search, which needs randomizerInitialization), and those named above.

    Failed evaluations (keepFailures) never survive.
    """
    known = {
        "initialPopulationSize", "keepFailures", "numberOfThreads", "numberOfChildren", "randomizerInitialization",
        "restart", "resultsFile", "survivingIndividuals", "useDispyWebMonitor", "useMPI",
    }  # fmt: skip
    check_names(GeneticOptimization, kwargs, known)
    check_study(GeneticOptimization, objectiveFunction, parameters)
    _check_ranges(parameters)
    if childDistribution not in ("uniform", "normal"):
        raise ValueError(
            f"GeneticOptimization: childDistribution must be 'uniform' or 'normal', not {childDistribution!r}"
        )
    populationSize, numberOfGenerations = int(populationSize), int(numberOfGenerations)
    check_integer("GeneticOptimization: populationSize", populationSize, 1)
    check_integer("GeneticOptimization: numberOfGenerations", numberOfGenerations, 1)
    n_survivors = _number_of_survivors(elitistRatio, populationSize, kwargs)
    if distanceFactor >= 1:
        warnings.warn(
            f"GeneticOptimization: distanceFactor = {distanceFactor} is too large; 0.5 is taken", stacklevel=3
        )
        distanceFactor = 0.5
    if distanceFactorGenerations < 0:
        distanceFactorGenerations = numberOfGenerations
    if "randomizerInitialization" in kwargs:
        np.random.seed(kwargs["randomizerInitialization"])
    restart = kwargs.get("restart", False)
    if restart and "randomizerInitialization" not in kwargs:
        raise ValueError(
            "GeneticOptimization: restart needs the randomizerInitialization that the search began with, so that its "
            "parameter sets are those of the resultsFile"
        )
    file, threads = results_file("GeneticOptimization", kwargs), number_of_threads(kwargs.get("numberOfThreads"))
    mode = f"processes, numberOfThreads={threads}" if useMultiProcessing else ""

    breeding = _Breeding(parameters, childDistribution, crossoverProbability)
    generation = breeding.first(kwargs.get("initialPopulationSize", populationSize))
    all_sets: list[ParameterSet] = []
    all_values: list[Any] = []
    survivors: list[ParameterSet] = []
    surviving_values: list[Any] = []
    best, best_value = {}, np.inf
    for number in range(numberOfGenerations):
        sets = [dict(individual) for individual in generation]
        for i, individual in enumerate(sets):
            AddComputationIndexAndFunctionData(individual, i, addComputationIndex, parameterFunctionData)
        values: list[Any] = [*known_values(file, sets, len(all_values))] if restart else []
        first, remaining = len(all_values) + len(values), sets[len(values) :]
        found = ProcessParameterList(
            objectiveFunction, remaining, useMultiProcessing, clusterHostNames, showProgress=showProgress,
            numberOfThreads=threads, useMPI=kwargs.get("useMPI", False), keepFailures=kwargs.get("keepFailures", False),
        )  # fmt: skip
        WriteToFile(file, parameters, remaining, found, first, first == 0, multiProcessingMode=mode)
        values += found
        all_sets += generation
        all_values += values
        candidates, candidate_values = generation + survivors, values + surviving_values
        objectives = np.array([scalar_objective("GeneticOptimization", value) for value in candidate_values])
        order = [int(i) for i in np.argsort(objectives, kind="stable")]
        best, best_value = candidates[order[0]], objectives[order[0]]
        if debugMode:
            write(f"generation {number}: best value {best_value:g} with {best}")
        if number == numberOfGenerations - 1:
            break
        distance = distanceFactor if number < distanceFactorGenerations else 0
        chosen = _survivors(candidates, order, n_survivors, distance, parameters)
        survivors, surviving_values = [candidates[i] for i in chosen], [candidate_values[i] for i in chosen]
        generation = breeding.next(survivors, populationSize, rangeReductionFactor ** (number + 1))
    if debugMode:
        write(f"total evaluations = {len(all_values)}")
    columns = {name: np.array([each[name] for each in all_sets], dtype=float) for name in parameters}
    return [dict(best), best_value, columns, all_values]
