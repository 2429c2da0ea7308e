"""Evaluation of a function for many parameter sets: in sequence, in processes, with MPI or on a Dask cluster."""

# ruff: noqa: B006  (the interface has these defaults; they are never written to)
from __future__ import annotations

import functools
import inspect
import os
import platform
import sys
import time
import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from numbers import Real
from typing import Any, NamedTuple

import numpy as np

from dalembert._calls import checked
from dalembert._checks import as_array, check_type, shape_error
from dalembert._io.files import file_to_write, naming
from dalembert._tools.missing_names import nearest

ParameterSet = dict[str, Any]
Function = Callable[[ParameterSet], Any]


def write(*arguments: Any, **options: Any) -> None:
    """Print, through the Print of the package if there is one: its output can be switched off or sent to a file."""
    package = sys.modules.get("dalembert")
    (getattr(package, "Print", None) or print)(*arguments, **options)


def check_names(function: Callable[..., Any], given: Iterable[str], known: Iterable[str]) -> None:
    """Refuse keyword arguments that a function does not have; TypeError names the nearest known one."""
    known = sorted(known)
    for name in given:
        if name not in known:
            named = [each for each in inspect.signature(function).parameters if each != "kwargs"]
            hint = nearest(name, [*known, *named]) or "; further arguments are " + ", ".join(known)
            raise TypeError(f"{function.__name__}: unknown argument {name!r}{hint}")


def check_study(study: Callable[..., Any], function: Any, parameters: Any) -> None:
    """Refuse a study without a function, or without parameters by name."""
    where, first = study.__name__, next(iter(inspect.signature(study).parameters))
    if not callable(function):
        raise TypeError(str(shape_error(f"{where}: {first}", "a function of a dictionary", function)))
    if not isinstance(parameters, Mapping):
        raise TypeError(str(shape_error(f"{where}: parameters", "a dictionary by name", parameters)))
    if not parameters:
        raise ValueError(f"{where}: parameters must not be empty")


def number_of_threads(given: int | None) -> int:
    """Return the number of processes to use: the given one, or all processors that this process may use."""
    if given is not None:
        if int(given) < 1:
            raise ValueError(f"numberOfThreads must be at least 1, not {given!r}")
        return int(given)
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def GetVersionPlatformString() -> str:
    """Return versions of package and Python, and the platform, for the documentation of results."""
    package = sys.modules.get("dalembert")
    config = getattr(package, "config", None)
    version = config.Version(True) if config is not None else "(no core) Python" + platform.python_version()
    system = platform.uname()
    parts = [f"dalembert version = {version}", system.system + system.release]
    parts += ["V" + system.version] if system.version else []
    return "; ".join([*parts, system.machine, system.processor])


def AddComputationIndexAndFunctionData(
    ind: ParameterSet, cnt: int, addComputationIndex: bool, parameterFunctionData: Mapping[str, Any]
) -> None:
    """Add 'computationIndex' (cnt) and 'functionData' to a parameter set, if asked for."""
    if not isinstance(ind, dict):
        raise shape_error("AddComputationIndexAndFunctionData: ind", "a dictionary", ind)
    if addComputationIndex:
        ind["computationIndex"] = cnt
    if parameterFunctionData:
        ind["functionData"] = parameterFunctionData


def check_sets(name: str, sets: Any) -> None:
    """Raise an error if the value is not a list of parameter sets."""
    if not hasattr(sets, "__len__") or not all(isinstance(each, Mapping) for each in sets):
        raise shape_error(name, "a list of dictionaries", sets)


def without_function_data(parameters: Mapping[str, Any]) -> ParameterSet:
    """Return a copy without 'functionData', which may be large."""
    return {name: value for name, value in parameters.items() if name != "functionData"}


def _header(resultsFile: str, parameters: Mapping[str, Any], columns: Iterable[str], fileType: str, mode: str) -> str:
    ranges = without_function_data(parameters)
    data = str(parameters["functionData"]).replace("\n", " ") if "functionData" in parameters else ""
    return "\n".join([
        f"#dalembert {fileType} results file:{resultsFile}",
        "#results stored columnwise for every parameter and individual",
        f"#{GetVersionPlatformString()}" + (f"(processing={mode})" if mode else ""),
        f"#functionData:{data}" if data else "#",
        "#columns:",
        "#" + ",".join(["globalIndex", "value", *columns]),
        '#parameter ranges [format: (begin, end, numberOfVariations) or list, parameters separated with ";"]:',
        "#" + ";".join(str(value) for value in ranges.values()),
        "",
    ])  # fmt: skip


@checked
def WriteToFile(
    resultsFile: str,
    parameters: Mapping[str, Any],
    currentGeneration: Sequence[ParameterSet],
    values: Sequence[Any],
    globalCnt: int,
    writeHeader: bool = False,
    fileType: str = "genetic optimization",
    multiProcessingMode: str = "",
) -> int:
    """Append one row [number, value, parameters] per parameter set to a file; return the next number.

    `parameters` are the ranges in the header; `writeHeader` starts a new file. An empty file name has no effect.
    """
    if resultsFile in ("", None):
        return globalCnt
    check_type("WriteToFile: parameters", parameters, Mapping)
    check_sets("WriteToFile: currentGeneration", currentGeneration)
    if isinstance(values, str) or not hasattr(values, "__len__") or len(values) != len(currentGeneration):
        raise shape_error("WriteToFile: values", f"a list of {len(currentGeneration)} values, one for each set", values)
    resultsFile = file_to_write("WriteToFile: resultsFile", resultsFile, newFolder=True)
    if writeHeader:
        os.makedirs(os.path.dirname(resultsFile) or ".", exist_ok=True)
    with naming(resultsFile), open(resultsFile, "w" if writeHeader else "a") as file:
        if writeHeader:
            columns = without_function_data(currentGeneration[0] if currentGeneration else parameters)
            file.write(_header(resultsFile, parameters, columns, fileType, multiProcessingMode))
        for number, (individual, value) in enumerate(zip(currentGeneration, values, strict=True), int(globalCnt)):
            row = [number, value, *without_function_data(individual).values()]
            file.write(", ".join(map(str, row)) + "\n")
    return int(globalCnt) + len(values)


def results_file(function: str, arguments: Mapping[str, Any]) -> str:
    """Return the argument resultsFile of a study; "" if it is not given."""
    given = arguments.get("resultsFile", "")
    return "" if given in ("", None) else file_to_write(f"{function}: resultsFile", given, newFolder=True)


class FailedEvaluation(float):
    """Stands for the value of an evaluation that has failed: not a number, with the text of the error as message."""

    message: str

    def __new__(cls, message: str) -> FailedEvaluation:
        made = super().__new__(cls, "nan")
        made.message = message
        return made

    def __reduce__(self) -> Any:
        return FailedEvaluation, (self.message,)


class _KeepingFailures:
    """A function whose exceptions become values; processes can receive it."""

    def __init__(self, function: Function) -> None:
        self.function = function

    def __call__(self, parameters: ParameterSet) -> Any:
        try:
            return self.function(parameters)
        except Exception as error:
            return FailedEvaluation(f"{type(error).__name__}: {error}")


def known_values(resultsFile: str, sets: Sequence[ParameterSet], first: int = 0) -> list[float]:
    """Return the values in a results file for the first sets, from its row `first` on.

    The rest of the file, such as an incomplete last line, is removed.
    """
    if not resultsFile:
        raise ValueError("restart needs the resultsFile of the study to go on with")
    if not os.path.exists(resultsFile):
        return []
    with open(resultsFile, encoding="utf-8") as file:
        lines = [line for line in file if line.endswith("\n") and not line.startswith("#")]
    values = _checked_values(resultsFile, lines[first:], sets, first)
    if len(values) < len(sets):
        _cut_to_rows(resultsFile, first + len(values))
    return values


def _checked_values(resultsFile: str, lines: list[str], sets: Sequence[ParameterSet], first: int) -> list[float]:
    """Return the values in lines of a results file, which have to be those of the sets."""
    values: list[float] = []
    for number, (line, parameters) in enumerate(zip(lines, sets, strict=False), first):
        row, expected = line.rstrip("\n").split(", "), [str(v) for v in without_function_data(parameters).values()]
        if row[0] != str(number) or row[2:] != expected:
            raise ValueError(
                f"{resultsFile}: row {number} is of parameters {', '.join(row[2:])}, not of {', '.join(expected)}; "
                "to restart, parameters must be those of the file"
            )
        try:
            values.append(float(row[1]))
        except ValueError:
            raise ValueError(
                f"{resultsFile}: row {number} has the value {row[1]!r}; only studies whose values are numbers restart"
            ) from None
    return values


class _Raised(NamedTuple):
    """Stands in place of a value if the function has raised an exception."""

    error: Any  # includes the traceback of its process


def _outcomes(function: Function, sets: Sequence[ParameterSet]) -> list[Any]:
    """Return the values of a portion of the sets, up to the first exception."""
    from multiprocessing.pool import ExceptionWithTraceback  # type: ignore[attr-defined]

    outcomes: list[Any] = []
    for parameters in sets:
        try:
            outcomes.append(function(parameters))
        except Exception as error:
            outcomes.append(_Raised(ExceptionWithTraceback(error, error.__traceback__)))
            break
    return outcomes


def _require_passable(function: Function, sets: Sequence[ParameterSet]) -> None:
    """Raise an error for arguments that cannot be pickled: a pool of Python 3.11 may wait for ever after such an
    error."""
    from multiprocessing.reduction import ForkingPickler

    ForkingPickler.dumps((function, list(sets)))


def _on_executor(executor: Any, function: Function, sets: Sequence[ParameterSet]) -> Iterator[Any]:
    from concurrent.futures import ProcessPoolExecutor

    if isinstance(executor, ProcessPoolExecutor):
        _require_passable(function, sets)
    yield from executor.map(function, sets)


def _in_processes(function: Function, sets: Sequence[ParameterSet], threads: int) -> Iterator[Any]:
    """Yield results in order. Processes take portions: passing one on may take as long as to evaluate a function.

    After an exception, running processes finish their portion: killing one that sends results would block the other
    ones.
    """
    from concurrent.futures import ProcessPoolExecutor
    from concurrent.futures.process import BrokenProcessPool

    _require_passable(function, sets)
    size = max(1, len(sets) // (100 * threads))  # small enough to show progress and to end together
    portions = [sets[i : i + size] for i in range(0, len(sets), size)]
    executor = ProcessPoolExecutor(threads)
    finished = False
    try:
        for outcomes in executor.map(functools.partial(_outcomes, function), portions):
            for outcome in outcomes:
                if isinstance(outcome, _Raised):
                    raise outcome.error
                yield outcome
        finished = True
    except BrokenProcessPool:
        raise RuntimeError(
            "a process has ended without a result: it has crashed, was killed, or there was not enough memory; "
            "useMultiProcessing=False shows where, and a smaller numberOfThreads takes less memory"
        ) from None
    finally:
        executor.shutdown(wait=finished, cancel_futures=True)


def _in_threads(function: Function, sets: Sequence[ParameterSet], threads: int) -> Iterator[Any]:
    """Yield results in order, from threads of this process: solvers leave the interpreter to others."""
    from concurrent.futures import ThreadPoolExecutor

    with ThreadPoolExecutor(threads) as executor:
        yield from executor.map(function, sets)


def _with_mpi(function: Function, sets: Sequence[ParameterSet]) -> Iterator[Any]:
    from mpi4py.futures import MPIPoolExecutor  # type: ignore[import-not-found,import-untyped,unused-ignore]

    with MPIPoolExecutor() as executor:
        yield from executor.map(function, sets)


def _is_client(cluster: Any) -> bool:
    return hasattr(cluster, "map") and hasattr(cluster, "gather")


def _on_cluster(function: Function, sets: Sequence[ParameterSet], cluster: Any) -> Iterator[Any]:
    """Yield results in order from a Dask client, from the scheduler at an address, or from hosts reached by ssh."""
    if _is_client(cluster):
        yield from (future.result() for future in cluster.map(function, sets, pure=False))
        return
    with ExitStack() as stack:
        client = _client_of(cluster, stack)
        yield from (future.result() for future in client.map(function, sets, pure=False))


def _client_of(cluster: Any, stack: ExitStack) -> Any:
    """Return a Dask client of the scheduler at an address, or of hosts reached by ssh, until the stack is left."""
    from dask.distributed import Client, SSHCluster

    address = cluster[0] if len(cluster) == 1 else stack.enter_context(SSHCluster(list(cluster)))
    return stack.enter_context(Client(address))


def _installed(module: str, purpose: str, level: int = 6) -> bool:
    try:
        __import__(module)
    except ImportError:
        warnings.warn(
            f"{purpose} needs the package {module}; processes of this machine are used instead", stacklevel=level
        )
        return False
    return True


def _has_cluster(hosts: Sequence[str]) -> bool:
    """Return whether hosts are those of a Dask cluster; a warning says if processes of this machine are used instead.

    A single name without a port is a host of dispy, which Exudyn 1.11 uses.
    """
    if len(hosts) == 0 or not _installed("dask.distributed", "clusterHostNames", 7):
        return False
    if len(hosts) == 1 and ":" not in str(hosts[0]):
        text = f"expected the address of a Dask scheduler, such as '{hosts[0]}:8786', received {hosts[0]!r}"
        warnings.warn(f"clusterHostNames: {text}; processes of this machine are used instead", stacklevel=6)
        return False
    return True


def _choose(
    function: Function, sets: Sequence[ParameterSet], parallel: Any, cluster: Any, use_mpi: bool, threads: int | None
) -> tuple[Iterator[Any], str]:
    """Return the results, evaluated on the way, and a word on how they are made."""
    from concurrent.futures import Executor

    if hasattr(function, "in_portions"):  # a VariedModel, which solves many sets at once
        return function.in_portions(sets, threads), "SolveVariations"
    if _is_client(parallel):
        parallel, cluster = True, parallel
    if isinstance(parallel, Executor):
        return _on_executor(parallel, function, sets), type(parallel).__name__
    if isinstance(parallel, str):
        if parallel not in ("threads", "processes"):
            expected = "a bool, 'processes', 'threads', a Dask client or an Executor of concurrent.futures"
            raise ValueError(f"useMultiProcessing: received {parallel!r}, but expected {expected}")
        if parallel == "threads":
            n = number_of_threads(threads)
            return _in_threads(function, sets, n), f"threads, numberOfThreads={n}"
    client = _is_client(cluster)
    if client or (parallel and _has_cluster(cluster)):
        return _on_cluster(function, sets, cluster), "dask"
    if parallel and use_mpi and _installed("mpi4py.futures", "useMPI"):
        return _with_mpi(function, sets), "mpi4py"
    if parallel:
        n = number_of_threads(threads)
        return _in_processes(function, sets, n), f"processes, numberOfThreads={n}"
    return map(function, sets), "serial"


def _named(results: Iterator[Any], sets: Sequence[ParameterSet], keep_failures: bool) -> Iterator[Any]:
    """Yield results; an exception gets a note that names the parameter set."""
    for i, parameters in enumerate(sets):
        try:
            value = next(results)
            if isinstance(value, FailedEvaluation) and not keep_failures:
                raise ValueError(value.message)
            yield value
        except Exception as error:
            error.add_note(f"in evaluation {i} of {len(sets)} with parameters {without_function_data(parameters)}")
            if "pickle" in str(error):
                error.add_note(
                    "Processes receive functions by name: define them with def in a file, outside of other functions, "
                    "or use useMultiProcessing='threads'."
                )
            raise


_PERIOD = 0.5  # s, between two lines of progress


def _with_progress(results: Iterator[Any], sets: Sequence[ParameterSet], serial: bool) -> Iterator[Any]:
    """Yield results and show how many are done: with tqdm, or by a line with the parameters of serial ones."""
    n = len(sets)
    if not serial:
        from tqdm.auto import tqdm

        yield from tqdm(results, total=n)
        return
    shown_at = -_PERIOD
    for i, value in enumerate(results):
        now = time.monotonic()
        if i < n - 1 and now - shown_at < _PERIOD:  # a file or a notebook keeps every line
            yield value
            continue
        shown_at = now
        shown = f", value = {value}" if isinstance(value, Real) else ""
        detail = f": parameters={without_function_data(sets[i])}" if serial else ""
        write(f"\rrun  {i + 1} / {n}{shown}{detail}", " " * 16, end="", flush=True)
        yield value
    write("", flush=True)


def ProcessParameterList(
    parameterFunction: Function,
    parameterList: Sequence[ParameterSet],
    useMultiProcessing: Any,
    clusterHostNames: Any = [],
    **kwargs: Any,
) -> list[Any]:
    """Evaluate a function for each parameter set of a list; return the results in the same order.

    If `useMultiProcessing` is True or 'processes', processes of this machine work in parallel; the function must be
    importable by them and must not write files of the same name. `clusterHostNames` makes it a Dask cluster: the
    address of a scheduler, several hosts that ssh reaches, or a dask.distributed.Client. Further arguments:
    showProgress, numberOfThreads (default: all), resultsFile (written row by row), parameters (ranges, for the header
    of that file), useMPI (mpi4py). useDispyWebMonitor is accepted and has no effect.

    useMultiProcessing may also be 'threads', for functions that spend their time in solvers, a Dask client, or an
    Executor of concurrent.futures.
    restart: values that the resultsFile already has are not evaluated again; they have to be numbers. keepFailures: an
    exception becomes a FailedEvaluation in its place: a float that is not a number, with the text as its message.
    """
    known = {"showProgress", "numberOfThreads", "resultsFile", "parameters", "useMPI", "useDispyWebMonitor", *_GUARDS}
    check_names(ProcessParameterList, kwargs, known)
    file, parameters = results_file("ProcessParameterList", kwargs), kwargs.get("parameters", {})
    values: list[Any] = []
    if kwargs.get("restart", False):
        values += known_values(file, parameterList)
    if not callable(parameterFunction):
        raise TypeError(f"parameterFunction: received {parameterFunction!r}, but expected a function of a dictionary")
    keeps = kwargs.get("keepFailures", False)
    at_once = hasattr(parameterFunction, "in_portions")
    function = _KeepingFailures(parameterFunction) if keeps and not at_once else parameterFunction
    check_sets("ProcessParameterList: parameterList", parameterList)
    remaining = parameterList[len(values) :]
    results, mode = _choose(
        function, remaining, useMultiProcessing, clusterHostNames, kwargs.get("useMPI", False),
        kwargs.get("numberOfThreads"),
    )  # fmt: skip
    results = _named(results, remaining, keeps)
    if kwargs.get("showProgress", False) and remaining:
        results = _with_progress(results, remaining, mode == "serial")
    for i, value in enumerate(results, len(values)):
        values.append(value)
        WriteToFile(file, parameters, [parameterList[i]], [value], i, i == 0, "parameter variation", mode)
    return values


@contextmanager
def kept_workers(
    useMultiProcessing: Any = False,
    clusterHostNames: Any = [],
    numberOfThreads: int | None = None,
    useMPI: bool = False,
) -> Iterator[Callable[[Function, Sequence[ParameterSet]], list[Any]]]:
    """Yield a function that evaluates another one for one list of sets after the other, on workers that stay."""
    from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor

    with ExitStack() as stack:
        kept: Any = useMultiProcessing
        if kept and useMPI and _installed("mpi4py.futures", "useMPI"):
            from mpi4py.futures import MPIPoolExecutor

            kept = stack.enter_context(MPIPoolExecutor())
        elif kept and _is_client(clusterHostNames):
            kept = clusterHostNames
        elif kept and _has_cluster(clusterHostNames):
            kept = _client_of(clusterHostNames, stack)
        elif kept is True or kept in ("processes", "threads"):
            pool = ThreadPoolExecutor if kept == "threads" else ProcessPoolExecutor
            kept = stack.enter_context(pool(number_of_threads(numberOfThreads)))
        yield lambda function, sets: ProcessParameterList(function, sets, kept, numberOfThreads=numberOfThreads)


# How a study meets failures, and its own end.
_GUARDS = ("restart", "keepFailures")


def _cut_to_rows(resultsFile: str, rows: int) -> None:
    """Drop a last line that was not written to its end."""
    with open(resultsFile, encoding="utf-8") as file:
        lines = file.readlines()
    header = sum(line.startswith("#") for line in lines)
    with naming(resultsFile), open(resultsFile, "w", encoding="utf-8") as file:
        file.writelines(lines[: header + rows])


def scalar_objective(where: str, value: Any) -> float:
    """Return a number to be minimized: the value itself, or the norm of several values."""
    name, expected = f"{where}: result of objectiveFunction", "a number, or several whose norm counts"
    if value is None:  # numpy would convert it to nan
        raise shape_error(name, expected, value)
    array = as_array(name, value, expected)
    return float(array) if array.ndim == 0 else float(np.linalg.norm(array.ravel()))
