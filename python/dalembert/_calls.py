"""Calls of public functions: numbers, counts and switches must have the types of the signature; otherwise they are
rejected by name.

Arrays, names and choices are checked in the functions.
"""

from __future__ import annotations

import functools
import inspect
import math
from collections.abc import Callable, Iterable
from typing import Any, ParamSpec, TypeVar

import numpy as np

from dalembert._checks import shape_error

P = ParamSpec("P")
R = TypeVar("R")


def _is_number(value: Any) -> bool:
    if isinstance(value, (str, bytes)) or getattr(value, "ndim", 0) != 0:
        return False
    try:
        return math.isfinite(float(value))
    except (TypeError, ValueError):
        return False
    except OverflowError:
        return True


def _is_integer(value: Any) -> bool:
    return _is_number(value) and (isinstance(value, int) or float(value).is_integer()) and abs(value) < LARGE


def _is_switch(value: Any) -> bool:
    return value is None or isinstance(value, (bool, np.bool_)) or _is_integer(value)


LARGE = 2**63  # integers of 64 bits are less
Check = tuple[str, Callable[[Any], bool], bool]  # expected value, test, whether None is allowed

KINDS: dict[str, tuple[str, Callable[[Any], bool]]] = {
    "float": ("a finite number", _is_number),
    "int": ("an integer", _is_integer),
    "bool": ("True or False", _is_switch),
    "bool | int": ("True, False or an integer", _is_switch),
}


def checked(function: Callable[P, R]) -> Callable[P, R]:
    """Decorate a function: arguments annotated as float, int, bool, or these or None, are checked; raises
    ValueError."""

    @functools.wraps(function)
    def call(*args: P.args, **kwargs: P.kwargs) -> R:
        check_given(function, zip(_checks_of(function)[0], args, strict=False))
        check_given(function, kwargs.items())
        return function(*args, **kwargs)

    return call


def check_given(function: Callable[..., Any], given: Iterable[tuple[str, Any]]) -> None:
    """Check arguments of a function like checked(), for functions in an import circle, which mypy cannot type."""
    checks = _checks_of(function)[1]
    for name, value in given:
        if name in checks:
            expected, fits, optional = checks[name]
            if not (fits(value) or (value is None and optional)):
                limit = f", of less than {LARGE}," if isinstance(value, int) else ""
                raise shape_error(f"{_title(function)}: {name}", f"{expected}{limit}", value)


def _title(function: Callable[..., Any]) -> str:
    """Return the name of a function, or of the class that it makes objects of."""
    return function.__qualname__.removesuffix(".__init__").rpartition(".")[2]


@functools.cache
def _checks_of(function: Callable[..., Any]) -> tuple[list[str], dict[str, Check]]:
    """Return the names of all parameters, and the checks of some; signatures are not read before the first call."""
    checks = {}
    for name, annotation in inspect.get_annotations(function).items():
        text = str(annotation)
        plain = text.removesuffix(" | None")
        if name != "return" and plain in KINDS:
            checks[name] = (*KINDS[plain], plain != text)
    return list(inspect.signature(function).parameters), checks
