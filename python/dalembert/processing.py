"""Many evaluations of a model: parameter variations, optimizations and sensitivities."""

# ruff: noqa: B006  (the interface has these defaults; they are never written to)
from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from dalembert._calls import checked
from dalembert._checks import as_number, check_integer, check_type, shape_error
from dalembert._plots.images import show_figure
from dalembert._studies.execution import (
    AddComputationIndexAndFunctionData,
    FailedEvaluation,
    Function,
    GetVersionPlatformString,
    ProcessParameterList,
    WriteToFile,
    check_names,
    check_study,
    number_of_threads,
    results_file,
    write,
)
from dalembert._studies.genetic import GeneticOptimization
from dalembert._studies.minimize import Minimize
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
    if not isinstance(subIndexRanges, (list, tuple, np.ndarray)):
        raise shape_error("SingleIndex2SubIndices: subIndexRanges", "a list of numbers of values", subIndexRanges)
    for size in subIndexRanges:
        check_integer("SingleIndex2SubIndices: subIndexRanges", size, 1)
    check_integer("SingleIndex2SubIndices: i", i, 0)
    indices = []
    for size in reversed(subIndexRanges):
        i, index = divmod(i, size)
        indices.append(index)
    return indices[::-1]


def _values_of(name: str, given: Any, useLogSpace: bool) -> tuple[np.ndarray, Callable[[Any], Any]]:
    """Return the values of one parameter, and their conversion in parameter sets: to int, float or unchanged."""

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
    begin, end, n = (as_number(f"ParameterVariation: range of {name!r}", value) for value in given)
    if int(n) != n or n < 1 or begin > end:
        raise ValueError(
            f"ParameterVariation: range of {name!r} must be (begin, end, number of values) with begin <= end and a "
            f"number of at least 1, not {given!r}"
        )
    if useLogSpace and begin <= 0 <= end:
        raise ValueError(f"ParameterVariation: range of {name!r} must not contain 0 for useLogSpace, not {given!r}")
    n = int(n)
    values = np.geomspace(begin, end, n) if useLogSpace else np.linspace(begin, end, n)
    steady = integer(given[0]) and integer(given[1]) and (end - begin + 1) % n == 0
    if steady and np.allclose(values, np.round(values), rtol=1e-12, atol=0):
        return np.round(values), int
    return values, float


@checked
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

    parameterFunction: gets a dictionary with a value per name; its results are collected in the list of values.
    parameters: (begin, end, number of values) or a list of values per name; useLogSpace spaces ranges evenly on a
        logarithmic scale. Integers stay integers, others are float. The first result is a dictionary with an array
        per name, as long as the list of values; the last name varies fastest.
    addComputationIndex: adds 'computationIndex', e.g. for names of files; parameterFunctionData: if not empty, the
        function gets it as 'functionData'.
    useMultiProcessing, clusterHostNames, showProgress, numberOfThreads, resultsFile, useMPI, restart, keepFailures: see
        ProcessParameterList.

    The function may do anything, so it is called for every combination. If only numbers of one model vary, it may be
    a VariedModel, which solves many combinations at once in compiled code.
    """
    check_names(ParameterVariation, kwargs, {"useMPI", "useDispyWebMonitor", "restart", "keepFailures"})
    resultsFile = results_file("ParameterVariation", {"resultsFile": resultsFile})
    check_study(ParameterVariation, parameterFunction, parameters)
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


@checked
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

    check_type("PlotOptimizationResults2D: parameterList", parameterList, Mapping)
    if not hasattr(valueList, "__len__"):
        raise shape_error("PlotOptimizationResults2D: valueList", "a list of values", valueList)
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
