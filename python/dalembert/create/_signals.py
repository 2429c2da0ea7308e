"""Quantities over time as arguments of Create functions: a number, a table, a file with a table, or a function of t.

They are recorded once, with the operations of dalembert.laws, so that solvers evaluate them without Python.
"""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable, Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from dalembert import laws
from dalembert._checks import FloatArray
from dalembert._core import symbolic
from dalembert._io.mat_files import read_mat
from dalembert.create._arguments import argument_error

Signal = (
    float
    | str
    | os.PathLike[str]
    | tuple[str | os.PathLike[str], *tuple[str, ...]]
    | Sequence[Sequence[float]]
    | FloatArray
    | Callable[[Any], Any]
)
_symbolic: Any = symbolic
_SAMPLES = 9  # of a spline in each part of a table, to find how far it goes beyond the values
_OVERSHOOT = 0.1  # of the range of the values: curves through samples of a sine, six a period, stay below
SIGNAL = (
    "a number, a table [[t, value], ...], the name of a CSV or MAT file with such columns, (file, 'time', 'force') for "
    "columns or variables by name, or a function of t"
)


def table_of(function: str, argument: str, given: Any) -> FloatArray:
    """Return a table with the columns time and value, from rows or from a file: MAT, or numbers (CSV, or with blanks).

    Lines that begin with letters before the first row, such as a header, and comments after # are skipped. In
    (file, 'time', 'force'), names are those of the header, or variables of a MAT file; (file, 'force') is one variable
    with both columns.
    """
    if isinstance(given, (str, os.PathLike)):
        given = (given,)
    if isinstance(given, (tuple, list)) and given and isinstance(given[0], (str, os.PathLike)):
        given = _read_columns(function, argument, Path(given[0]), given[1:])
    try:
        rows = np.asarray(given, dtype=float)
    except (TypeError, ValueError):
        rows = np.empty(0)
    if rows.ndim != 2 or rows.shape[1] != 2 or len(rows) < 2 or not np.isfinite(rows).all():
        raise argument_error(
            function, argument, "a table with two columns and at least two rows of finite numbers", given
        )
    if not (np.diff(rows[:, 0]) > 0).all():
        row = int(np.flatnonzero(np.diff(rows[:, 0]) <= 0)[0]) + 1
        raise argument_error(
            function, argument, f"a table with increasing times (row {row} does not)", rows[row].tolist()
        )
    return rows


def _read_columns(function: str, argument: str, path: Path, names: Any) -> Any:
    """Return the table in a file, or its columns with these names."""
    if len(names) > 2 or not all(isinstance(each, str) for each in names):
        raise argument_error(function, argument, "(file, 'time', 'force') or (file, 'matrix')", (str(path), *names))
    if path.suffix.lower() != ".mat":
        return _read(function, argument, path, names)
    where = f"MainSystem.{function}(...): argument '{argument}'"
    try:
        columns = read_mat(where, path, names)
    except OSError as error:
        raise _unreadable(function, argument, path, error) from None
    if len(names) < 2:
        return columns[0]
    if len({each.size for each in columns}) > 1 or any(each.size != max(each.shape, default=1) for each in columns):
        shapes = " and ".join(f"{each.shape} of '{name}'" for name, each in zip(names, columns, strict=True))
        raise ValueError(f"{where}: expected two vectors of one length in {path}, received the shapes {shapes}")
    return np.column_stack([np.ravel(each) for each in columns])


def _unreadable(function: str, argument: str, path: Path, error: OSError) -> ValueError:
    return argument_error(function, argument, "a file that can be read", f"{path}: {error.strerror or error}")


def _read(function: str, argument: str, path: Path, names: tuple[str, ...]) -> list[list[float]]:
    try:
        lines = path.read_text("utf-8-sig").splitlines()
    except OSError as error:
        raise _unreadable(function, argument, path, error) from None
    except UnicodeDecodeError:
        raise argument_error(function, argument, "a text file in UTF-8", str(path)) from None
    rows: list[list[float]] = []
    headers: list[list[str]] = []  # lines before the numbers: names, units, comments
    for number, line in enumerate(lines, 1):
        text, _, comment = map(str.strip, line.partition("#"))
        if not text or (not rows and (text[0].isalpha() or text[0] in '"_([')):
            if not rows and (text or comment):
                headers.append(_cells(text or comment))
            continue
        try:
            rows.append([float(each) for each in text.replace(";", " ").replace(",", " ").split()])
        except ValueError:
            raise argument_error(function, argument, f"numbers in line {number} of {path}", line) from None
    if len({len(row) for row in rows}) > 1:
        raise argument_error(function, argument, f"the same number of columns in all lines of {path}", "several")
    if not names:
        return rows
    header = next((each for each in reversed(headers) if set(names) <= set(each)), headers[-1] if headers else [])
    for name in names:
        if header.count(name) != 1 or len(names) < 2:
            columns = ", ".join(header) or "no header"
            expected = f"names of two columns of {path} ({columns}), such as (file, 'time', 'force')"
            raise argument_error(function, argument, expected, names)
    if rows and len(rows[0]) != len(header):
        raise argument_error(function, argument, f"{len(header)} columns as in the header of {path}", len(rows[0]))
    places = [header.index(name) for name in names]
    return [[row[place] for place in places] for row in rows]


def _cells(text: str) -> list[str]:
    """Return the names in a header."""
    separator = next((each for each in ",;\t" if each in text), None)
    return [each.strip().strip('"') for each in text.split(separator)]


def signal(function: str, argument: str, given: Any, smooth: bool, ramp: float = 0.0) -> Callable[[Any], Any]:
    """Return a function of t, also for symbols; errors name the Create function and its argument.

    smooth: tables are cubic splines, otherwise polygons. ramp: time in which the quantity grows smoothly from zero.
    """
    if callable(given):

        def of_time(t: Any) -> Any:
            return _called(function, argument, given, t)

    elif isinstance(given, (int, float, np.number)) and not isinstance(given, bool) and np.isfinite(given):
        number = float(given)

        def of_time(t: Any) -> Any:
            return number + 0 * t

    else:
        rows = table_of(function, argument, given)
        if smooth:
            _warn_of_overshoot(function, argument, rows)

        def of_time(t: Any) -> Any:
            return laws.interpolate(t, rows[:, 0], rows[:, 1], smooth)

    if ramp == 0:
        return of_time
    return lambda t: of_time(t) * (0.5 - 0.5 * np.cos(np.pi * laws.minimum(laws.maximum(t / ramp, 0.0), 1.0)))


def _called(function: str, argument: str, given: Callable[[Any], Any], t: Any) -> Any:
    """Return the value of a function of time; errors name its line, and the argument."""
    where = f"MainSystem.{function}(...): argument '{argument}'"
    try:
        value = given(t)
    except Exception as error:
        line = f"{laws._line_of(given, error.__traceback__)}: " if hasattr(given, "__code__") else ""
        raise laws._NotRecordedError(f"{where} cannot be recorded: {line}{laws._reason(error)}") from error
    if isinstance(value, bool) or not isinstance(value, (int, float, np.number, _symbolic.Real)):
        raise laws._NotRecordedError(f"{where}: expected a function of t that returns a number, received {value!r}")
    return value


def _warn_of_overshoot(function: str, argument: str, rows: FloatArray) -> None:
    """Warn of a spline that goes far beyond the values of its table, as it does at corners between long parts."""
    times, values = rows.T
    fine = np.unique(np.concatenate([np.linspace(a, b, _SAMPLES) for a, b in pairwise(times)]))
    curve = laws.interpolate(fine, times, values, True)
    low, high = float(values.min()), float(values.max())
    beyond = np.maximum(curve - high, low - curve)
    if beyond.max() > _OVERSHOOT * (high - low) and high > low:
        at = int(beyond.argmax())
        text = (
            f"{function}: {argument}: the spline through the table reaches {curve[at]:.4g} at t = {fine[at]:.4g} s, "
            f"beyond its values from {low:.4g} to {high:.4g}. Add rows near corners, or use smooth=False for lines "
            "between rows"
        )
        warnings.warn(text, stacklevel=6)


def rate(value: Any, t: Any) -> Any:
    """Return the derivative by t of what was recorded."""
    return _symbolic._Rate(value, [(t, 1.0)]) if isinstance(value, _symbolic.Real) else 0.0


def recorded(function: str, argument: str, item: str, row: str, compute: Callable[[Any], Any]) -> Any:
    """Return a recorded user function of time for a row of an item. `compute` returns a number, or a list of them."""
    kind = laws._Kind(item, row, {"t": 0}, (), ())
    with laws._recording():
        symbols = laws._arguments(kind)
        result = _run(function, argument, compute, symbols[0])
        numbers = [laws._number(each) for each in (result if isinstance(result, list) else [result])]
        value = _symbolic.Vector(numbers) if isinstance(result, list) else numbers[0]
        return laws._function(_named(compute, argument), symbols, value)


def _run(function: str, argument: str, compute: Callable[[Any], Any], t: Any) -> Any:
    try:
        return compute(t)
    except laws._NotRecordedError:
        raise
    except TypeError as error:
        reason = laws._reason(error)
        raise TypeError(f"MainSystem.{function}(...): argument '{argument}' cannot be recorded: {reason}") from error


def _named(compute: Callable[..., Any], name: str) -> Callable[..., Any]:
    def law(*arguments: Any) -> Any:
        return compute(*arguments)

    law.__name__ = name
    return law
