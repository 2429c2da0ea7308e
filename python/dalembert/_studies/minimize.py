"""Search for a minimum with the methods of SciPy, whose evaluations go together where a method asks for several."""

# ruff: noqa: B006  (the interface has these defaults; they are never written to)
from __future__ import annotations

import time
import warnings
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from dalembert._calls import checked
from dalembert._checks import as_vector, check_type
from dalembert._studies.execution import (
    Function,
    ParameterSet,
    WriteToFile,
    check_names,
    check_study,
    kept_workers,
    results_file,
    write,
)
from dalembert._tools.missing_names import nearest

_GLOBAL = "differential_evolution"
# Methods of scipy.optimize.minimize that use gradients, with their finite-difference steps.
_SMALL = float(np.sqrt(np.finfo(float).eps))
_DIFFERENCES = {
    "bfgs": _SMALL, "cg": _SMALL, "l-bfgs-b": 1e-8, "newton-cg": _SMALL, "slsqp": _SMALL, "tnc": 1e-8,
    "trust-constr": _SMALL,
}  # fmt: skip
_METHODS = (*_DIFFERENCES, "nelder-mead", "powell", "cobyla", "cobyqa")
_VALUE_FIRST = ("slsqp", "trust-constr")  # the gradient is asked for at some points only
_WORKERS = {"useMultiProcessing", "clusterHostNames", "numberOfThreads", "useMPI"}


class _Objective:
    """An objective function of a vector: named, within bounds, its values kept for the report of iterations."""

    def __init__(self, function: Function, names: Sequence[str], bounds: Any, index: bool, workers: Any) -> None:
        self.function, self.names, self.bounds, self.index, self.workers = function, names, bounds, index, workers
        self.evaluations = 0
        self._known: dict[bytes, Any] = {}

    def inside(self, x: Any) -> NDArray[np.float64]:
        """Return the point within bounds next to x."""
        return np.array(x, dtype=float) if self.bounds is None else np.clip(x, *self.bounds)

    def named(self, x: Any) -> ParameterSet:
        parameters: ParameterSet = dict(zip(self.names, self.inside(x).tolist(), strict=True))
        if self.index:
            parameters["computationIndex"] = self.evaluations
        return parameters

    def __call__(self, x: Any) -> Any:
        return self._keep(x, self.function(self.named(x)))

    def _keep(self, x: Any, value: Any) -> Any:
        if value is None or isinstance(value, (str, bytes)) or np.ndim(value) != 0:
            raise TypeError(f"Minimize: objectiveFunction returned {value!r}, but expected a number")
        self.evaluations += 1
        self._known[self.inside(x).tobytes()] = value
        return value

    def value(self, x: Any) -> Any:
        """Return the value at x, evaluated only if it is not known."""
        key = self.inside(x).tobytes()
        return self._known[key] if key in self._known else self(x)

    def values(self, points: Iterable[Any]) -> list[Any]:
        """Return the values at many points; new points are evaluated together."""
        points = list(points)
        unknown = {self.inside(x).tobytes(): x for x in points if self.inside(x).tobytes() not in self._known}
        sets = [self.named(x) for x in unknown.values()]
        if self.index:
            for i, parameters in enumerate(sets):
                parameters["computationIndex"] += i
        for x, value in zip(unknown.values(), self.workers(self.function, sets) if sets else [], strict=True):
            self._keep(x, value)
        return [self._known[self.inside(x).tobytes()] for x in points]

    def exact_gradient(self, x: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the gradient of a DifferentiableModel; it vanishes along parameters that are held at bounds."""
        point = self.inside(x)
        slopes = self.function.slopes(dict(zip(self.names, point.tolist(), strict=True)), self.names)  # type: ignore[attr-defined]
        return np.where(point == x, np.asarray(slopes)[:, 0], 0.0)

    def gradient(self, x: NDArray[np.float64], step: float, limits: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return differences over a step in each direction, backwards where it would leave the limits."""
        steps = np.where(x + step > limits[1], -step, step)
        points = x + np.diag(steps)
        here, *there = self.values([x, *points])
        taken = np.diag(points) - x  # steps after rounding
        return (np.array(there, dtype=float) - here) / taken


def _bounds(parameters: Mapping[str, Any]) -> NDArray[np.float64]:
    """Return lower and upper bounds, 2 x n."""
    for name, given in parameters.items():
        if np.ndim(given) != 1 or len(given) != 2:
            raise ValueError(f"Minimize: {name!r} must have bounds (begin, end), not {given!r}")
    return np.sort(np.array(list(parameters.values()), dtype=float), axis=1).T


class _Report:
    """Record of iterations: lists of points and values, rows of the results file, progress output."""

    def __init__(
        self, objective: _Objective, parameters: Mapping[str, Any], method: str, iterations: int, file: str,
        wants_values: bool, shows: bool,
    ) -> None:  # fmt: skip
        self.objective, self.parameters, self.file, self.shows = objective, parameters, file, shows
        function = _GLOBAL if method == _GLOBAL else "minimize"
        self.file_type = f"optimization using scipy.optimize.{function}(method={method})"
        self.iterations, self.wants_values = iterations, wants_values or bool(file)
        self.history: dict[str, list[float]] = {name: [] for name in objective.names}
        self.values: list[Any] = []
        self.begin = time.monotonic()
        self.shown = self.begin - 10

    def add(self, x: Any, last: bool = False) -> None:
        point = self.objective.named(x)
        for name, column in self.history.items():
            column.append(point[name])
        done, now = len(self.history[self.objective.names[0]]), time.monotonic()
        loss = ""
        if self.wants_values:
            value = self.objective.value(x)
            self.values.append(value)
            loss = f", loss: {value:.3g}"
            WriteToFile(self.file, self.parameters, [point], [value], done - 1, done == 1, self.file_type)
        if self.shows and (last or now - self.shown > 1):
            self.shown, spent = now, now - self.begin
            remaining = spent / done * max(self.iterations - done, 0)
            write(f"iteration {done} / {self.iterations}, time = {spent:.2f} s / {remaining:.2f} s{loss}")


@checked
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
    """Minimize with scipy.optimize; return [best parameters, best value, parameters, values].

    objectiveFunction: gets a dictionary of parameters and returns a number.
    parameters: bounds (begin, end) per name; enforceBounds moves parameters to them, useScipyBounds=True (kwargs)
        passes them to the method instead. initialGuess: default is the middle of the bounds.
    method: of scipy.optimize.minimize, or 'differential_evolution', which searches all of the bounds.
    tol, options: see scipy. The last two results hold, for each iteration, a list per name and the value of
        the objective (storeFunctionValues=False: no values).
    addComputationIndex: adds 'computationIndex', the number of the evaluation.
    kwargs: resultsFile (a row per iteration), useScipyBounds; useMultiProcessing, clusterHostNames, numberOfThreads and
        useMPI: see ProcessParameterList.

    Evaluations run together, on these workers or by a VariedModel, if a method requests several: a generation of
    differential_evolution, and the differences for gradients, which CG, BFGS, L-BFGS-B, TNC, SLSQP, Newton-CG and
    trust-constr use; options={'eps': ...} is the step of differences. Its default of 1e-8 (scipy) is too small for most
    solutions: use 1e-4 for parameters of the size 1. A DifferentiableModel with one number as output gives exact
    gradients instead. Other methods, such as Nelder-Mead, Powell and COBYLA, choose each point by the value of the last
    one.
    """
    check_names(Minimize, kwargs, {"resultsFile", "useScipyBounds", *_WORKERS})
    check_study(Minimize, objectiveFunction, parameters)
    if method != _GLOBAL and (not isinstance(method, str) or method.lower() not in _METHODS):
        hint = nearest(str(method), known := [_GLOBAL, *_METHODS]) or f"; known are: {', '.join(known)}"
        raise ValueError(f"Minimize: method: scipy.optimize has no {method!r}{hint}")
    check_type("Minimize: options", options, Mapping)
    file = results_file("Minimize", kwargs)
    names, bounds = list(parameters), _bounds(parameters)
    scipy_bounds = kwargs.get("useScipyBounds", False) or method == _GLOBAL
    given = as_vector("Minimize: initialGuess", initialGuess)
    start = given if len(given) else bounds.mean(axis=0)
    if start.shape != (len(names),):
        raise ValueError(f"Minimize: initialGuess must have {len(names)} entries, not {start.size}")
    workers = {name: kwargs[name] for name in _WORKERS & set(kwargs)}
    if workers.get("useMultiProcessing") and method != _GLOBAL and method.lower() not in _DIFFERENCES:
        warnings.warn(
            f"Minimize: method {method!r} chooses each point by the value of the last one; useMultiProcessing has an "
            f"effect on '{_GLOBAL}' and on methods with gradients, such as 'L-BFGS-B'",
            stacklevel=3,
        )
        workers = {}
    together = bool(workers.get("useMultiProcessing")) or hasattr(objectiveFunction, "in_portions")
    with kept_workers(**workers) as evaluate:
        inner = bounds if enforceBounds and not scipy_bounds else None
        objective = _Objective(objectiveFunction, names, inner, addComputationIndex, evaluate)
        iterations = options.get("maxiter", 1000 if method == _GLOBAL else 200 * len(names))
        report = _Report(objective, parameters, method, iterations, file, storeFunctionValues, showProgress)
        if method == _GLOBAL:
            guess = start if len(given) else None
            result = _evolve(objective, bounds, guess, tol, options, report)
        else:
            limits = bounds if scipy_bounds else None
            result = _follow(objective, start, limits, method, tol, options, report, together)
        report.add(result["x"], last=True)
    if debugMode:
        write(result)
    if not np.isfinite(result["fun"]):
        warnings.warn(
            f"Minimize: the best value is {result['fun']}: objectiveFunction has returned no finite number; "
            "check its values for the parameters in the result",
            stacklevel=3,
        )
    best = dict(zip(names, objective.inside(result["x"]).tolist(), strict=True))
    return [best, result["fun"], report.history, report.values]


def _follow(
    objective: _Objective, start: Any, limits: Any, method: str, tol: float | None, options: Mapping[str, Any],
    report: _Report, together: bool,
) -> Any:  # fmt: skip
    """Return the result of scipy.optimize.minimize; gradients, where evaluations go together, are made here."""
    from scipy import optimize  # type: ignore[import-untyped,unused-ignore]

    function: Any = objective
    gradient: Any = None
    name = method.lower()
    makes_it = together or name == "newton-cg"  # scipy has no finite differences for it
    if name in _DIFFERENCES and hasattr(objective.function, "slopes"):
        gradient = objective.exact_gradient
    elif makes_it and name in _DIFFERENCES and "finite_diff_rel_step" not in options:
        step = options.get("eps", _DIFFERENCES[name])
        inside = limits if limits is not None else objective.bounds
        if inside is None:
            inside = np.array([[-np.inf], [np.inf]])

        def slope(x: NDArray[np.float64]) -> NDArray[np.float64]:
            return objective.gradient(x, step, inside)

        def value_and_slope(x: NDArray[np.float64]) -> tuple[Any, NDArray[np.float64]]:
            found = slope(x)  # includes the value at x
            return objective.value(x), found

        function, gradient = (objective.value, slope) if name in _VALUE_FIRST else (value_and_slope, True)
    return optimize.minimize(
        function, start, method=method, tol=tol, options=dict(options), jac=gradient,
        callback=lambda x, *_: report.add(np.copy(x)),
        bounds=None if limits is None else list(zip(*limits, strict=True)),
    )  # fmt: skip


def _evolve(
    objective: _Objective, bounds: Any, start: Any, tol: float | None, options: Mapping[str, Any], report: _Report
) -> Any:
    """Return the result of scipy.optimize.differential_evolution, whose generations are evaluated together."""
    from scipy import optimize

    given = {"polish": False, "updating": "deferred"} | dict(options)
    if tol is not None:
        given.setdefault("tol", tol)
    return optimize.differential_evolution(
        objective.value, list(zip(*bounds, strict=True)), x0=start, callback=lambda x, *_, **__: report.add(np.copy(x)),
        workers=lambda _, points: objective.values(points), **given,
    )  # fmt: skip
