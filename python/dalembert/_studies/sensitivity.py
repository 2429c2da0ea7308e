"""Sensitivities of results with respect to parameters, varied one at a time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from dalembert._calls import checked
from dalembert._checks import FloatArray, as_array, as_number, as_vector, shape_error
from dalembert._studies.execution import (
    AddComputationIndexAndFunctionData,
    Function,
    ParameterSet,
    ProcessParameterList,
    check_names,
    check_study,
    write,
)

_SMALLEST_STEP = 1e-6


def _variation(name: str, value: Any) -> tuple[float, float, int]:
    """Return (reference, relative step, number of steps) from a number, (reference, step) or all three."""
    entries = (value,) if np.ndim(value) == 0 else tuple(value)
    if not 1 <= len(entries) <= 3:
        raise ValueError(
            f"ComputeSensitivities: {name!r} must be a reference value or (reference, relative step, number of steps), "
            f"not {value!r}"
        )
    defaults: tuple[Any, ...] = (None, 1e-3, 0)
    for entry in entries:
        as_number(f"ComputeSensitivities: {name!r}", entry)
    reference, step, steps = entries + defaults[len(entries) :]
    if step == 0 or int(steps) != steps or steps < 0:
        raise ValueError(
            f"ComputeSensitivities: {name!r} needs a step other than 0 and a number of steps >= 0, not {value!r}"
        )
    return reference, step, int(steps)


def _factors(steps: int) -> list[int]:
    """Return the multiples of the step: forward for 0 steps, otherwise -steps, ..., -1, 1, ..., steps."""
    return [1] if steps == 0 else [*range(-steps, 0), *range(1, steps + 1)]


def _varied(reference: float, step: float, factor: int) -> float:
    """Return the reference plus a multiple of the relative step; the step is absolute if the reference is 0."""
    if reference != 0:
        varied = reference * (1 + factor * step)
        return varied if varied != 0 else max(step, _SMALLEST_STEP)
    return factor * step


_ARGUMENTS = {
    "clusterHostNames", "keepFailures", "numberOfThreads", "restart", "resultsFile", "useDispyWebMonitor", "useMPI",
}  # fmt: skip


@checked
def ComputeSensitivities(
    parameterFunction: Function,
    parameters: Mapping[str, Any],
    scaledByReference: bool = False,
    debugMode: bool = False,
    addComputationIndex: bool = False,
    useMultiProcessing: Any = False,
    showProgress: bool = True,
    parameterFunctionData: Mapping[str, Any] = {},
    **kwargs: Any,
) -> list[Any]:
    """Return [parameter sets, reference values, values per parameter, sensitivities] by finite differences.

    parameterFunction: gets a dictionary of parameters and returns a number or a list of m numbers.
    parameters: (reference, relative step, number of steps n) per name; n=0: forward difference, otherwise n steps
        to each side and a central difference of the first ones. A number stands for (number, 1e-3, 0). The steps of
        a reference 0 are absolute.
    scaledByReference: multiply sensitivities by the reference: change of the result per relative change.
    Result: the list of parameter sets, the reference first; the m values at the reference; an array (2n x m, or
        1 x m) per name; sensitivities (row: parameter, column: value).
    addComputationIndex, parameterFunctionData: adds 'computationIndex' and 'functionData' to parameter sets.
    useMultiProcessing, showProgress, kwargs (clusterHostNames, keepFailures, numberOfThreads, restart, resultsFile,
        useMPI): see ProcessParameterList. Failed evaluations (keepFailures) are NaN.

    A DifferentiableModel as parameterFunction gives exact sensitivities: no differences are taken, and with n=0, only
    the reference is solved, so that the array of a name is empty.
    """
    check_names(ComputeSensitivities, kwargs, _ARGUMENTS)
    check_study(ComputeSensitivities, parameterFunction, parameters)
    variations = {name: _variation(name, value) for name, value in parameters.items()}
    exact = hasattr(parameterFunction, "slopes")
    factors = {name: [] if exact and steps == 0 else _factors(steps) for name, (_, _, steps) in variations.items()}
    sets: list[ParameterSet] = [{name: reference for name, (reference, _, _) in variations.items()}]
    for name, (reference, step, _) in variations.items():
        if debugMode:
            write(f"{name}: {len(factors[name])} variations of {reference} by {step}")
        sets += [sets[0] | {name: _varied(reference, step, factor)} for factor in factors[name]]
    for i, each in enumerate(sets):
        AddComputationIndexAndFunctionData(each, i, addComputationIndex, parameterFunctionData)

    values = ProcessParameterList(
        parameterFunction, sets, useMultiProcessing, showProgress=showProgress, parameters=variations, **kwargs
    )
    size = max(np.size(value) for value in values)
    table = np.array([np.broadcast_to(np.atleast_1d(value), size) for value in values], dtype=float)  # failures are NaN
    sensitivity = np.zeros((len(variations), table.shape[1]))
    if exact:
        sensitivity[:] = parameterFunction.slopes(sets[0], list(variations))  # type: ignore[attr-defined]
    values_sorted = {}
    first = 1
    for i, (name, (reference, _, steps)) in enumerate(variations.items()):
        if not exact:
            after, before = (first, 0) if steps == 0 else (first + steps, first + steps - 1)
            sensitivity[i] = (table[after] - table[before]) / (sets[after][name] - sets[before][name])
        if scaledByReference:
            sensitivity[i] *= reference
        last = first + len(factors[name])
        values_sorted[name] = table[first:last]
        first = last
    return [sets, values[0] if np.ndim(values[0]) else table[0], values_sorted, sensitivity]


def _per_parameter(fVar: float | Sequence[float] | None, n: int) -> list[float]:
    if fVar is None:
        return [1e-3] * n
    expected = "a finite number, or one for each parameter"
    steps = np.atleast_1d(as_array("PlotSensitivityResults: fVar", fVar, expected)).tolist()
    if not np.isfinite(steps).all():
        raise shape_error("PlotSensitivityResults: fVar", expected, fVar)
    if len(steps) == 1:
        return steps * n
    if len(steps) != n:
        raise ValueError(f"PlotSensitivityResults: fVar must have one entry per parameter ({n}), not {len(steps)}")
    return steps


def _table_of(name: str, table: Any, columns: int) -> FloatArray:
    """Return values at the steps below and above a reference, as rows."""
    found = as_array(name, table)
    if found.ndim != 2 or found.shape[1] != columns or (len(found) % 2 != 0 and len(found) > 1):
        raise shape_error(name, f"one row or an even number of them, with {columns} numbers each", table)
    return found


def PlotSensitivityResults(
    valRef: Sequence[float],
    valuesSorted: Mapping[str, Any],
    sensitivity: Any,
    fVar: float | Sequence[float] | None = None,
    strYAxis: Sequence[str] | None = None,
) -> list[Any]:
    """Plot values over variations in percent, with a subplot per value; return [figure, list of axes].

    valRef (m), valuesSorted and sensitivity (parameters x m) come from ComputeSensitivities; fVar: relative steps,
    one or one per parameter (default 1e-3); strYAxis: m labels, more are ignored.
    """
    import matplotlib.pyplot as plt

    where = "PlotSensitivityResults"
    if not isinstance(valuesSorted, Mapping) or not valuesSorted:
        raise shape_error(f"{where}: valuesSorted", "a dictionary of values, by names of parameters", valuesSorted)
    expected = f"numbers, a row for each of {len(valuesSorted)} parameters"
    sensitivity = np.atleast_2d(as_array(f"{where}: sensitivity", sensitivity, expected))
    m = sensitivity.shape[-1]
    if sensitivity.ndim != 2 or len(sensitivity) != len(valuesSorted) or m == 0:
        raise shape_error(f"{where}: sensitivity", expected, sensitivity)
    reference = as_vector(f"{where}: valRef", valRef, m)
    valuesSorted = {
        name: _table_of(f"{where}: valuesSorted[{name!r}]", table, m) for name, table in valuesSorted.items()
    }
    if not (strYAxis is None or (isinstance(strYAxis, (list, tuple)) and all(isinstance(t, str) for t in strYAxis))):
        raise shape_error(f"{where}: strYAxis", f"a list of {m} texts", strYAxis)
    labels = [""] * m if strYAxis is None else list(strYAxis)
    if len(labels) < m:
        raise ValueError(f"PlotSensitivityResults: strYAxis must have one entry per value ({m}), not {len(labels)}")
    steps = _per_parameter(fVar, len(valuesSorted))
    figure, grid = plt.subplots(m, squeeze=False)
    axes = list(grid[:, 0])
    for i, ax in enumerate(axes):
        for j, (name, table) in enumerate(valuesSorted.items()):
            percent = [100 * steps[j] * factor for factor in _factors(len(table) // 2)]
            center = len(table) // 2
            x, y = np.insert(percent, center, 0.0), np.insert(table[:, i], center, reference[i])
            ax.plot(x, y, "--", color="0.8")
            ax.plot(percent, table[:, i], "o", label=f"{name}, s={sensitivity[j, i]:.5g}")
        ax.plot(0, reference[i], "d", label="Ref")
        ax.set_ylabel(labels[i])
        ax.legend()
        ax.grid()
    axes[-1].set_xlabel("Variation in %")
    figure.tight_layout()
    return [figure, axes]
