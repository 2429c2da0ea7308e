"""Many evaluations of a model: parameter variations, optimizations and sensitivities."""

# ruff: noqa: B006  (the interface has these defaults; they are never written to)
from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from dalembert._plots.images import show_figure
from dalembert._studies.execution import (
    AddComputationIndexAndFunctionData,
    FailedEvaluation,
    Function,
    GetVersionPlatformString,
    ParameterSet,
    ProcessParameterList,
    WriteToFile,
    check_names,
    number_of_threads,
    write,
)
from dalembert._studies.genetic import GeneticOptimization
from dalembert._studies.sensitivity import ComputeSensitivities, PlotSensitivityResults
from dalembert._studies.varied_model import FailedVariation, VariedModel

__all__ = [
    "AddComputationIndexAndFunctionData",
    "ComputeSensitivities",
    "FailedEvaluation",
    "FailedVariation",
    "GeneticOptimization",
    "GetVersionPlatformString",
    "Minimize",
    "ParameterVariation",
    "PlotOptimizationResults2D",
    "PlotSensitivityResults",
    "ProcessParameterList",
    "SingleIndex2SubIndices",
    "VariedModel",
    "WriteToFile",
]


def SingleIndex2SubIndices(i: int, subIndexRanges: Sequence[int]) -> list[int]:
    """Return the index per range for the number i of a combination; the last index runs fastest."""
    indices = []
    for size in reversed(subIndexRanges):
        i, index = divmod(i, size)
        indices.append(index)
    return indices[::-1]


def _values_of(name: str, given: Any, useLogSpace: bool) -> tuple[np.ndarray, Callable[[Any], Any]]:
    """Return the values of one parameter, and what they are converted to in parameter sets: int, float or as given."""

    def integer(value: Any) -> bool:
        return isinstance(value, (int, np.integer)) and not isinstance(value, bool)

    if isinstance(given, list):
        values = np.asarray(given)
        if values.size == 0:
            raise ValueError(f"ParameterVariation: the list of values of {name!r} is empty")
        if all(integer(value) for value in given):
            return values, int
        return values, float if values.dtype.kind in "fiu" else lambda value: value
    if not isinstance(given, tuple) or len(given) != 3:
        raise ValueError(
            f"ParameterVariation: {name!r} must be a range (begin, end, number of values) or a list of values, "
            f"not {given!r}"
        )
    begin, end, n = given
    if int(n) != n or n < 1 or begin > end:
        raise ValueError(
            f"ParameterVariation: range of {name!r} must be (begin, end, number of values) with begin <= end and a "
            f"number of at least 1, not {given!r}"
        )
    n = int(n)
    values = np.geomspace(begin, end, n) if useLogSpace else np.linspace(begin, end, n)
    steady = integer(begin) and integer(end) and (end - begin + 1) % n == 0
    if steady and np.allclose(values, np.round(values), rtol=1e-12, atol=0):
        return np.round(values), int
    return values, float


def ParameterVariation(
    parameterFunction: Function,
    parameters: Mapping[str, Any],
    useLogSpace: bool = False,
    debugMode: bool = False,
    addComputationIndex: bool = False,
    useMultiProcessing: Any = False,
    showProgress: bool = True,
    parameterFunctionData: Mapping[str, Any] = {},
    clusterHostNames: Any = [],
    numberOfThreads: int | None = None,
    resultsFile: str = "",
    **kwargs: Any,
) -> list[Any]:
    """Evaluate a function for all combinations of parameters; return [parameters, values].

    parameterFunction: gets a dictionary with a value per name; what it returns is collected in the list of values.
    parameters: (begin, end, number of values) or a list of values per name; useLogSpace spaces ranges evenly on a
        logarithmic scale. Integers stay integers, others are float. The first result is a dictionary with an array
        per name, as long as the list of values; the last name varies fastest.
    addComputationIndex: adds 'computationIndex', e.g. for names of files; parameterFunctionData: if not empty, the
        function gets it as 'functionData'.
    useMultiProcessing, clusterHostNames, showProgress, numberOfThreads, resultsFile, useMPI, restart, keepFailures: see
        ProcessParameterList.

    The function may do anything, so it is called for every combination. Where only numbers of one model vary, it may
    be a VariedModel, which solves many combinations at once without Python in between.
    """
    check_names("ParameterVariation", kwargs, {"useMPI", "useDispyWebMonitor", "restart", "keepFailures"})
    if not parameters:
        raise ValueError("ParameterVariation: parameters must not be empty")
    values, convert = {}, {}
    for name, given in parameters.items():
        values[name], convert[name] = _values_of(name, given, useLogSpace)
    sizes = [len(value) for value in values.values()]
    n = int(np.prod(sizes))
    columns = {}
    for i, (name, value) in enumerate(values.items()):
        before, after = int(np.prod(sizes[:i])), int(np.prod(sizes[i + 1 :]))
        columns[name] = np.tile(np.repeat(value, after), before)
    if addComputationIndex:
        columns["computationIndex"], convert["computationIndex"] = np.arange(n), int
    sets = [{name: convert[name](column[i]) for name, column in columns.items()} for i in range(n)]
    for each in sets:
        AddComputationIndexAndFunctionData(each, 0, False, parameterFunctionData)
    if debugMode:
        write(f"number of variations = {n}, threads = {number_of_threads(numberOfThreads)}")
        write(f"parameters = {columns}")
    results = ProcessParameterList(
        parameterFunction, sets, useMultiProcessing, clusterHostNames, showProgress=showProgress,
        numberOfThreads=numberOfThreads, resultsFile=resultsFile, parameters=parameters, **kwargs,
    )  # fmt: skip
    return [columns, results]


class _Objective:
    """An objective function of a vector: named, within bounds, its values kept for the report of iterations."""

    def __init__(self, function: Function, names: Sequence[str], bounds: Any, index: bool) -> None:
        self.function, self.names, self.bounds, self.index = function, names, bounds, index
        self.evaluations = 0
        self._known: dict[bytes, Any] = {}

    def inside(self, x: Any) -> np.ndarray:
        """Return the point within bounds next to x."""
        return np.array(x, dtype=float) if self.bounds is None else np.clip(x, *self.bounds)

    def named(self, x: Any) -> ParameterSet:
        parameters: ParameterSet = dict(zip(self.names, self.inside(x).tolist(), strict=True))
        if self.index:
            parameters["computationIndex"] = self.evaluations
        return parameters

    def __call__(self, x: Any) -> Any:
        value = self.function(self.named(x))
        self.evaluations += 1
        self._known[self.inside(x).tobytes()] = value
        return value

    def value(self, x: Any) -> Any:
        """Return the value at x, evaluated only if it is not known."""
        key = self.inside(x).tobytes()
        return self._known[key] if key in self._known else self(x)


def _bounds(parameters: Mapping[str, Any]) -> np.ndarray:
    """Return lower and upper bounds, 2 x n."""
    for name, given in parameters.items():
        if np.ndim(given) != 1 or len(given) != 2:
            raise ValueError(f"Minimize: {name!r} must have bounds (begin, end), not {given!r}")
    return np.sort(np.array(list(parameters.values()), dtype=float), axis=1).T


def Minimize(
    objectiveFunction: Function,
    parameters: Mapping[str, Any],
    initialGuess: Sequence[float] = [],
    method: str = "Nelder-Mead",
    tol: float | None = 1e-4,
    options: Mapping[str, Any] = {},
    enforceBounds: bool = True,
    debugMode: bool = False,
    showProgress: bool = True,
    addComputationIndex: bool = False,
    storeFunctionValues: bool = True,
    **kwargs: Any,
) -> list[Any]:
    """Minimize with scipy.optimize.minimize; return [best parameters, best value, parameters, values].

    objectiveFunction: gets a dictionary of parameters and returns a number.
    parameters: bounds (begin, end) per name; enforceBounds moves parameters to them, useScipyBounds=True (kwargs)
        passes them to the method instead. initialGuess: default is the middle of the bounds.
    method, tol, options: see scipy. The last two results hold, for each iteration, a list per name and the value of
        the objective (storeFunctionValues=False: no values).
    addComputationIndex: adds 'computationIndex', the number of the evaluation.
    kwargs: resultsFile (a row per iteration), useScipyBounds.
    """
    from scipy import optimize  # type: ignore[import-untyped,unused-ignore]

    check_names("Minimize", kwargs, {"resultsFile", "useScipyBounds"})
    if not parameters:
        raise ValueError("Minimize: parameters must not be empty")
    names, bounds = list(parameters), _bounds(parameters)
    scipy_bounds = kwargs.get("useScipyBounds", False)
    start = np.array(initialGuess, dtype=float) if len(initialGuess) else bounds.mean(axis=0)
    if start.shape != (len(names),):
        raise ValueError(f"Minimize: initialGuess must have {len(names)} entries, not {start.size}")
    objective = _Objective(
        objectiveFunction, names, bounds if enforceBounds and not scipy_bounds else None, addComputationIndex
    )
    file, file_type = kwargs.get("resultsFile", ""), f"optimization using scipy.optimize.minimize(method={method})"
    iterations = options.get("maxiter", 200 * len(names))
    history: dict[str, list[float]] = {name: [] for name in names}
    values: list[Any] = []
    begin = time.monotonic()
    shown = begin - 10

    def report(x: Any, last: bool = False) -> None:
        nonlocal shown
        point = objective.named(x)
        for name in names:
            history[name].append(point[name])
        done, now = len(history[names[0]]), time.monotonic()
        value = None
        if storeFunctionValues or file:
            value = objective.value(x)
            values.append(value)
            WriteToFile(file, parameters, [point], [value], done - 1, done == 1, file_type)
        if showProgress and (last or now - shown > 1):
            shown, spent = now, now - begin
            loss = "" if value is None else f", loss: {value:.3g}"
            remaining = spent / done * (iterations - done)
            write(f"iteration {done} / {iterations}, time = {spent:.2f} s / {remaining:.2f} s{loss}")

    result = optimize.minimize(
        objective, start, method=method, tol=tol, options=dict(options), callback=lambda x, *_: report(np.copy(x)),
        bounds=list(zip(*bounds, strict=True)) if scipy_bounds else None,
    )  # fmt: skip
    report(result["x"], last=True)
    if debugMode:
        write(result)
    best = dict(zip(names, objective.inside(result["x"]).tolist(), strict=True))
    return [best, result["fun"], history, values]


def PlotOptimizationResults2D(
    parameterList: Mapping[str, Sequence[float]],
    valueList: Sequence[float],
    xLogScale: bool = False,
    yLogScale: bool = False,
) -> list[Any]:
    """Plot values of the objective over each parameter, a figure per parameter; return [figures, axes].

    parameterList (a list per name) and valueList come from GeneticOptimization, Minimize or ParameterVariation. Open
    figures are closed.
    """
    import matplotlib.pyplot as plt
    from matplotlib.ticker import MaxNLocator

    for name, column in parameterList.items():
        if len(column) != len(valueList):
            raise ValueError(
                f"PlotOptimizationResults2D: {name!r} has {len(column)} entries, but there are {len(valueList)} values"
            )
    plt.close("all")
    figures, axes = [], []
    for name, column in parameterList.items():
        figure, ax = plt.subplots()
        ax.plot(column, valueList, "b.", label=name)
        ax.set_xlabel(name)
        ax.set_ylabel("value (objective function)")
        ax.grid(True, "major", "both")
        for axis, set_scale, logarithmic in (
            (ax.xaxis, ax.set_xscale, xLogScale),
            (ax.yaxis, ax.set_yscale, yLogScale),
        ):
            if logarithmic:
                set_scale("log")
            else:
                axis.set_major_locator(MaxNLocator(10))
        ax.legend()
        figure.tight_layout()
        show_figure(plt, figure)
        figures.append(figure)
        axes.append(ax)
    return [figures, axes]
