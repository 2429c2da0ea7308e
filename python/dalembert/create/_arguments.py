"""Argument checks of the Create functions: one table of checks per function, and common error texts."""

from __future__ import annotations

import functools
from collections.abc import Callable, Sequence
from sys import float_info
from types import FunctionType
from typing import Any, Literal, NamedTuple, NoReturn

import numpy as np
import numpy.typing as npt

from dalembert._checks import COLOR, ROTATION, as_array, color_problem, rotation_problem, shape_error
from dalembert._core import (
    MarkerIndex,
    ModelError,
    NodeIndex,
    ObjectIndex,
    _is_plain_not_negative,
    _is_plain_number,
    _is_plain_positive,
    _item_counts,
    _plain_vectors,
    _problem_of,
)
from dalembert._tools.found_items import find_item
from dalembert._tools.missing_names import nearest
from dalembert.create._created import created

# Defaults that several functions share. They are passed on and never changed.
ZERO3 = [0.0, 0.0, 0.0]
NO_PAIR: list[Any] = [None, None]
DEFAULT_COLOR = [-1.0, -1.0, -1.0, -1.0]

# Types for callers; the checks below are stricter.
Vector = Sequence[float] | npt.NDArray[Any]
Matrix = Sequence[Vector] | npt.NDArray[Any]
Connected = ObjectIndex | NodeIndex | MarkerIndex | int | str  # bodies, nodes or markers by number or name
UserFunction = Callable[..., Any] | Literal[0]


class Check(NamedTuple):
    """Requirement on an argument: a test with its description, optionally a function that describes the fault.

    quick: a compiled function that accepts most valid values.
    """

    test: Callable[[Any], bool]
    expected: str
    problem: Callable[[Any], str] | None = None
    quick: Callable[[Any], bool] | None = None

    def optional(self) -> Check:
        """Return the check that also accepts None."""
        return Check(lambda value: value is None or self.test(value), self.expected + " or None", self.problem)


def _is_number(value: Any) -> bool:
    if type(value) in (float, int):
        return -float_info.max <= value <= float_info.max
    return isinstance(value, (int, float, np.integer, np.floating)) and bool(np.isfinite(value))


def _has_shape(value: Any, shape: tuple[int, ...]) -> bool:
    if isinstance(value, (str, bytes, dict)) or not hasattr(value, "__len__"):
        return False
    try:
        array = as_array("", value)  # rejects texts of numbers
    except ValueError:
        return False
    return array.shape == shape and bool(np.isfinite(array).all())


def vector(size: int) -> Check:
    """Return the check for a list or array of `size` finite numbers."""
    return Check(
        lambda value: _has_shape(value, (size,)),
        f"a vector with {size} finite components",
        quick=_plain_vectors(size),
    )


def matrix(size: int) -> Check:
    """Return the check for a square matrix of finite numbers."""
    return Check(lambda value: _has_shape(value, (size, size)), f"a {size}x{size} matrix of finite numbers")


def refined(check: Check, expected: str, problem: Callable[[Any], str]) -> Check:
    """Return the check for values that pass another one, and of which `problem` then says nothing."""

    def problem_of(value: Any) -> str:
        return problem(np.asarray(value, dtype=float)) if check.test(value) else ""

    return Check(lambda value: check.test(value) and not problem_of(value), expected, problem_of)


def rotation_matrix() -> Check:
    """Return the check for a 3x3 rotation matrix: no scaling, shear or reflection."""
    return refined(matrix(3), ROTATION, rotation_problem)


def unit_vector() -> Check:
    """Return the check for a vector with 3 components, of length 1."""
    return refined(vector(3), "a vector of length 1", lambda value: _problem_of("unit_vector", value))


def color() -> Check:
    """Return the check for red, green, blue and opacity from 0 to 1, or a negative red for a default color."""
    return refined(vector(4), COLOR, color_problem)


def require_axis(function: str, axis: Vector) -> None:
    """Raise a ValueError if there is no axis, or one of zero length."""
    if len(axis) != 3 or not any(axis):
        raise argument_error(function, "axis", "a vector with 3 components that is not zero", axis)


def require_two_bodies(function: str, bodyNumbers: Sequence[Any]) -> None:
    """Raise a ValueError if a joint is to be set between a body, or a marker, and itself."""
    first, second = bodyNumbers
    same_kind = is_body(first) == is_body(second) and isinstance(first, MarkerIndex) == isinstance(second, MarkerIndex)
    if first is not None and second is not None and same_kind and int(first) == int(second):
        raise argument_error(function, "bodyNumbers", "two different bodies or markers", bodyNumbers)


def require_two_points(function: str, numbers: Sequence[Any], localPositions: Sequence[Vector]) -> None:
    """Raise a ValueError if both ends of a connector are the same point of the same body, node or marker."""
    if (
        type(numbers[0]) is type(numbers[1])
        and numbers[0] == numbers[1]
        and np.array_equal(localPositions[0], localPositions[1])
    ):
        raise argument_error(function, "bodyNumbers", "two different points, or it does nothing", numbers)


def flags(size: int) -> Check:
    """Return the check for a list of `size` integers that are 0 or 1."""
    return Check(
        lambda value: _has_shape(value, (size,)) and bool(np.isin(value, (0, 1)).all()),
        f"a list with {size} flags, each 0 or 1",
    )


def list_of(size: int, what: str) -> Check:
    """Return the check for a list or tuple with `size` entries of any kind."""
    return Check(lambda value: isinstance(value, (list, tuple)) and len(value) == size, f"a list of {size} {what}")


ANYTHING = Check(lambda value: True, "anything")
TEXT = Check(lambda value: isinstance(value, str), "a string")
FLAG = Check(lambda value: isinstance(value, (bool, int, np.bool_, np.integer)), "a bool")
NUMBER = Check(_is_number, "a finite number", quick=_is_plain_number)
POSITIVE = Check(
    lambda value: _is_number(value) and value > 0, "a finite number greater than zero", quick=_is_plain_positive
)
NOT_NEGATIVE = Check(
    lambda value: _is_number(value) and value >= 0,
    "a finite number that is not negative",
    quick=_is_plain_not_negative,
)
GRAPHICS = Check(
    lambda value: isinstance(value, list) and all(isinstance(entry, (dict, list)) for entry in value),
    "a (possibly empty) list of graphics data, e.g. [graphics.Sphere(radius=0.1)]",
)
BODY_PAIR = list_of(2, "body, node or marker numbers")

# Arguments that mean the same in every function that has them, and are no parameters of items.
COMMON = {
    "useGlobalFrame": FLAG,
    "bodyNumbers": BODY_PAIR,
    "bodyOrNodeList": BODY_PAIR,
    "bodyList": BODY_PAIR,
    "localPosition": vector(3),
    "localPosition0": vector(3),
    "localPosition1": vector(3),
    "graphicsDataList": GRAPHICS,
}


# Arguments that refer to items.
REFERENCES = {"bodyNumber", "bodyNumbers", "bodyOrNodeList", "bodyList", "carrierNumber"}


def argument_error(function: str, argument: str, expected: str, received: Any) -> ValueError:
    """Return the error with function, argument, expected and received value."""
    return shape_error(f"MainSystem.{function}(...): argument '{argument}'", expected, received)


def checked(function: FunctionType, checks: dict[str, Check], renamed: dict[str, str]) -> Callable[..., Any]:
    """Return the function with a check of the arguments that a caller gives, by `checks`.

    `renamed`: further names of arguments, with the names that `function` has.

    Raises ValueError for a wrong value and TypeError for an unknown argument, with the nearest known one, before any
    item has been added. If items refuse each other later, those that have been added are taken back.
    """
    names = function.__code__.co_varnames[: function.__code__.co_argcount]
    numbered = tuple(REFERENCES.intersection(names))
    table = {name: checks.get(name, ANYTHING) for name in names}
    tests = {name: check.quick or check.test for name, check in table.items()}
    anything = ANYTHING.test
    other_names = frozenset(renamed)

    def accepts(name: str, value: Any) -> bool:
        return name in table and table[name].quick is not None and table[name].test(value)

    def refuse(name: str, value: Any) -> NoReturn:
        if name in table:
            check = table[name]
            problem = check.problem(value) if check.problem is not None else ""
            error = argument_error(function.__name__, name, check.expected, value)
            raise ValueError(f"{error}. {problem}") if problem else error
        hint = nearest(name, [*names[1:], *renamed]) or f"; known are: {', '.join(names[1:])}"
        if "inertia" in names and name.lower().endswith("mass"):  # name of the parameter in items
            hint = ". Pass mass and inertia as inertia=InertiaCuboid(...) or another of the Inertia... functions"
        if name.startswith("markerNumber"):  # name of the parameter in items
            hint = (
                "".join(f". Pass markers as '{each}'" for each in names if each in ("bodyNumber", "bodyNumbers"))
                or hint
            )
        raise TypeError(f"MainSystem.{function.__name__}(...): unknown argument '{name}'{hint}")

    def with_own_names(args: tuple[Any, ...], kwargs: dict[str, Any]) -> dict[str, Any]:
        result = {name: value for name, value in kwargs.items() if name not in renamed}
        for name, value in kwargs.items():
            if name in renamed:
                own = renamed[name]
                if own in result or own in names[: len(args)]:
                    where = f"MainSystem.{function.__name__}(...)"
                    raise TypeError(f"{where}: argument '{own}' is given twice, also by its name '{name}'")
                result[own] = value
        return result

    @functools.wraps(function)
    def call(*args: Any, **kwargs: Any) -> Any:
        if not other_names.isdisjoint(kwargs):
            kwargs = with_own_names(args, kwargs)
        given = kwargs if len(args) < 2 else dict(zip(names, args, strict=False)) | kwargs
        for name, value in given.items():
            test = tests.get(name)
            if test is not anything and (test is None or not test(value)) and not accepts(name, value):
                refuse(name, value)
        for name in numbered:
            if name in given and _has_names(given[name]):
                given = {**given, name: with_indices(args[0], function.__name__, name, given[name])}
                args, kwargs = args[:1], {key: value for key, value in given.items() if key != names[0]}
        before = _item_counts(args[0])
        try:
            return created(args[0], function(*args, **kwargs))
        except BaseException as error:
            _take_back(args[0], before)
            _explain_name(function.__name__, given.get("name"), error)
            raise

    return call


def _explain_name(function: str, name: Any, error: BaseException) -> None:
    """Name the argument in the error of a part, such as the marker 'Marker0:belt' of the belt 'belt'."""
    text = str(error)
    if isinstance(error, ModelError) and name and "parameter 'name': received" in text and "MainSystem." not in text:
        named = f"MainSystem.{function}(...): argument 'name': expected a name that is not in use, received {name!r}"
        error.args = (f"{named}: {text}", *error.args[1:])


_DELETING = {
    "Sensor": {},
    "Load": {"deleteDependentMarkers": False},
    "Marker": {},
    "Object": {"deleteDependentItems": False},
    "Node": {},
}


def _take_back(mbs: Any, before: bytes) -> None:
    """Delete the items that have been added since there were so many of each kind."""
    now, then = (reversed(memoryview(counts).cast("i")) for counts in (_item_counts(mbs), before))
    for count, was, (kind, options) in zip(now, then, _DELETING.items(), strict=True):
        for number in range(count - 1, was - 1, -1):
            getattr(mbs, f"Delete{kind}")(number, suppressWarnings=True, **options)


def _has_names(value: Any) -> bool:
    return isinstance(value, str) or (isinstance(value, (list, tuple)) and any(isinstance(v, str) for v in value))


def with_indices(mbs: Any, function: str, argument: str, value: Any) -> Any:
    """Return the argument with indices instead of names of bodies, markers or nodes."""
    if not _has_names(value):
        return value
    if not isinstance(value, str):
        named = enumerate(value)
        return [with_indices(mbs, function, f"{argument}[{i}]", v) if isinstance(v, str) else v for i, v in named]
    if int(body := mbs.GetObjectNumber(value)) >= 0:
        return body
    if value == "ground" and len(grounds := _grounds(mbs)) == 1:
        return grounds[0]
    return find_item(mbs, value, ("Object", "Marker", "Node"), f"MainSystem.{function}(...): argument '{argument}'")


def _grounds(mbs: Any) -> list[ObjectIndex]:
    """Return all ground objects: the only one needs no name."""
    numbers = range(mbs.systemData.NumberOfObjects())
    return [ObjectIndex(i) for i in numbers if mbs.GetObject(i)["objectType"] == "Ground"]


def is_body(value: Any) -> bool:
    """Return whether the value can be the number of an object: an ObjectIndex or a plain integer."""
    if isinstance(value, (MarkerIndex, NodeIndex, bool)):
        return False
    return isinstance(value, (ObjectIndex, int, np.integer))
