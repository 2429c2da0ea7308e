"""Laws in Python: functions of relative displacement, relative velocity and time become springs, loads or constraints.

The decorated function is called once, with symbols instead of numbers; the operations are recorded. Items evaluate the
record in the core, without Python, in all threads, and with exact derivatives. Arguments with a default are constants
of the law: parameters of the item, which SetObjectParameter, variations and sensitivities can change.

    @connector("points")
    def Hertz(u, v, t, radius=1.0, stiffness=100.0):
        length = norm(u)
        depth = maximum(radius - length, 0.0)
        return -stiffness * depth**1.5 * u / length

    mbs.AddObject(Hertz([marker0, marker1], stiffness=500.0))
"""

from __future__ import annotations

import difflib
import inspect
import linecache
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import update_wrapper
from pathlib import Path
from types import TracebackType
from typing import Any, NamedTuple

import numpy as np

from dalembert import _core
from dalembert._checks import FloatArray
from dalembert._tools.item_packages import item_class
from dalembert._tools.symbolic_functions import _sizes

__all__ = [
    "Law",
    "atan2",
    "connector",
    "constraint",
    "forces_of_coordinates",
    "interpolate",
    "load",
    "maximum",
    "minimum",
    "norm",
    "sign",
    "where",
]

_symbolic: Any = _core.symbolic  # vectors are sequences of symbols here


class _Kind(NamedTuple):
    """An item with a user function, and which arguments of the function a law has."""

    item: str
    function: str
    arguments: dict[str, int]  # name -> place among the arguments of the user function
    results: tuple[str, ...]  # with three numbers each, or () for a number
    unused: tuple[str, ...]  # parameters of the item that only the usual law reads


_CONNECTORS = {
    "points": _Kind(
        "ObjectConnectorCartesianSpringDamper",
        "springForceUserFunction",
        {"u": 2, "v": 3, "t": 0},
        ("force",),
        ("stiffness", "damping"),
    ),
    "line": _Kind(
        "ObjectConnectorSpringDamper",
        "springForceUserFunction",
        {"L": 2, "L_t": 3, "t": 0},
        (),
        ("stiffness", "damping", "force", "velocityOffset"),
    ),
    "frames": _Kind(
        "ObjectConnectorRigidBodySpringDamper",
        "springForceTorqueUserFunction",
        {"u": 2, "phi": 3, "v": 4, "omega": 5, "t": 0},
        ("force", "torque"),
        ("stiffness", "damping", "offset"),
    ),
    "rotation": _Kind(
        "ObjectConnectorTorsionalSpringDamper",
        "springTorqueUserFunction",
        {"phi": 2, "omega": 3, "t": 0},
        (),
        ("stiffness", "damping", "offset", "velocityOffset", "torque"),
    ),
    "coordinates": _Kind(
        "ObjectConnectorCoordinateSpringDamper",
        "springForceUserFunction",
        {"q": 2, "q_t": 3, "t": 0},
        (),
        ("stiffness", "damping", "offset"),
    ),
}
_WITH_STATES = "ObjectConnectorLaw"
_FUNCTIONS_WITH_STATES = ("forceUserFunction", "stateRateUserFunction", "historyUserFunction")
_SIZES_WITH_STATES = {"coordinates": 1, "points": 3, "line": 3, "frames": 6, "rotation": 6}
_LOADS = {
    "force": _Kind("LoadForceVector", "loadVectorUserFunction", {"t": 0}, ("force",), ("loadVector",)),
    "torque": _Kind("LoadTorqueVector", "loadVectorUserFunction", {"t": 0}, ("torque",), ("loadVector",)),
    "acceleration": _Kind(
        "LoadMassProportional", "loadVectorUserFunction", {"t": 0}, ("acceleration",), ("loadVector",)
    ),
    "coordinate": _Kind("LoadCoordinate", "loadUserFunction", {"t": 0}, (), ("load",)),
}
_CONSTRAINT = "ObjectConnectorCoordinateVector"
_FUNCTIONS_OF_CONSTRAINT = ("constraintUserFunction", "jacobianUserFunction")
_LEFT_OUT = (
    "scalingMarker0",
    "scalingMarker1",
    "quadraticTermMarker0",
    "quadraticTermMarker1",
    "offset",
    "velocityLevel",
)


def unread_parameters(item: str, function: str, recorded: Any) -> tuple[str, ...]:
    """Return the parameters of an item that have no effect, as its recorded function is a law of this module."""
    for kind in (*_CONNECTORS.values(), *_LOADS.values()):
        if (kind.item, kind.function) == (item, function):
            stored = recorded._Stored()
            names = [stored["nodes"][node]["name"] for node in stored["arguments"]]
            return kind.unused if names == _names_of_arguments(kind) else ()
    return ()


class _NotRecordedError(TypeError):
    """A function cannot be recorded."""


class Law:
    """A recorded function; a call with markers makes an item: Hertz([marker0, marker1], stiffness=500.0).

    function: the decorated Python function, which also takes numbers
    constants: names and values of its constants
    recorded: user function of the item, or several by name
    states, history: names and start values of states
    """

    def __init__(
        self,
        function: Callable[..., Any],
        item: str,
        recorded: dict[str, Any],
        constants: dict[str, float],
        fixed: dict[str, Any],
        unused: Sequence[str],
        states: dict[str, float] | None = None,
        history: dict[str, float] | None = None,
    ) -> None:
        update_wrapper(self, function)
        self.function, self.item, self.recorded, self.constants = function, item, recorded, constants
        self._fixed, self._unused = fixed, tuple(unused)
        self.states, self.history = states or {}, history or {}

    def __call__(self, markers: Any, **parameters: Any) -> Any:
        """Make an item on these markers; `parameters` are constants of the law and parameters of the item."""
        cls = item_class(self.item)
        name = self.function.__name__
        constants = {key: parameters.pop(key) for key in self.constants if key in parameters}
        rows = [row for row in dict(cls()) if row not in (*self._unused, *self.recorded)]
        for key in parameters:
            if key in self._unused or key in self.recorded:
                raise TypeError(f"{name}(...): '{key}' of {self.item} has no effect, because the law replaces it")
            if key not in rows:
                near = difflib.get_close_matches(key, [*self.constants, *rows], 1)
                raise TypeError(
                    f"{name}(...): there is no constant or parameter '{key}'. "
                    + (f"Did you mean '{near[0]}'?" if near else f"The constants are {_listed(self.constants)}.")
                )
        if (self.states or self.history) and "nodeNumbers" not in parameters:
            raise TypeError(f"{name}(...): it has states; add nodeNumbers={name}.AddNodes(mbs)")
        functions = dict(self.recorded)
        for key, value in constants.items():
            number = _constant(f"{name}(...): {key}", value)
            for row, function in functions.items():
                if key in function._Variables():
                    functions[row] = function._WithVariable(key, number)
        place = "markerNumber" if self.item.startswith("Load") else "markerNumbers"
        return cls(**{place: markers}, **functions, **self._fixed, **parameters)

    def AddNodes(self, mbs: Any, **values: float) -> list[Any]:
        """Add the nodes of one item's states to mbs, and return their numbers; `values` are start values by name."""
        where = f"{self.function.__name__}.AddNodes(...)"
        if not self.states and not self.history:
            raise TypeError(f"{where}: the law has no states")
        for key in values:
            if key not in self.states and key not in self.history:
                raise TypeError(
                    f"{where}: there is no state '{key}'. States are {_listed([*self.states, *self.history])}."
                )
        start = {key: _constant(f"{where}: {key}", value) for key, value in values.items()}
        states, history = ([start.get(key, value) for key, value in own.items()] for own in (self.states, self.history))
        nodes: list[Any] = []
        if states:
            nodes.append(
                _core.NodeGenericODE1(
                    numberOfODE1Coordinates=len(states),
                    referenceCoordinates=[0.0] * len(states),
                    initialCoordinates=states,
                )
            )
        if history:
            nodes.append(_core.NodeGenericData(numberOfDataCoordinates=len(history), initialCoordinates=history))
        return [mbs.AddNode(node) for node in nodes]

    def __repr__(self) -> str:
        return f"<law {self.function.__name__}({_listed(self.constants)}) of {self.item}>"


def _listed(names: Sequence[str] | dict[str, Any]) -> str:
    return ", ".join(names) or "none"


def _constant(where: str, value: Any) -> float:
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, float, np.number)) or not np.isfinite(value):
        raise TypeError(f"{where}: received {value!r}, but constants of laws are finite numbers")
    return float(value)


# ---- decorators ------------------------------------------------------------------------------------------------------
def connector(
    kind: str, states: dict[str, float] | None = None, history: dict[str, float] | None = None
) -> Callable[[Callable[..., Any]], Law]:
    """Make a connector of a function. Its kind says which markers it connects, its arguments and its result.

    points: f(u, v, t) is the force on the first marker in global axes; u and v are position and velocity of the second
        marker relative to the first one. The second marker gets the opposite force.
    line: f(L, L_t, t) is the tension along the line between two points; L is their distance
    frames: f(u, phi, v, omega, t) gives force and torque on the first marker in its joint frame; phi: Tait-Bryan angles
    rotation: f(phi, omega, t) is the torque on the first marker about the z axis of its joint frame; phi is from -pi to
        pi, unless the item gets nodeNumber, a NodeGenericData with one coordinate that counts turns (without states)
    coordinates: f(q, q_t, t) is the generalized force on the first coordinate; q is the difference of two coordinates

    states, history: names and start values of further arguments, which follow t. The function returns its result, then
        the rate of each state, then the value of each history variable at the end of the step.
    """
    if states is None and history is None:
        return _decorator("connector", kind, _CONNECTORS)
    chosen = _chosen("connector", kind, _CONNECTORS)
    own = [_start_values(name, given) for name, given in (("states", states), ("history", history))]
    common = [*own[0], *own[1], *chosen.arguments]
    if twice := next((name for name in common if common.count(name) > 1), ""):
        raise ValueError(f"connector(...): '{twice}' is the name of two arguments")
    return lambda function: _with_states(function, kind, chosen, *own)


def load(kind: str) -> Callable[[Callable[..., Any]], Law]:
    """Make a load of a function f(t): 'force', 'torque', 'acceleration' (a vector each), or 'coordinate' (a number)."""
    return _decorator("load", kind, _LOADS)


def constraint(coordinates0: int, coordinates1: int) -> Callable[[Callable[..., Any]], Law]:
    """Make a constraint of a function g(q0, q1, t), which returns one equation g = 0, or several.

    q0 and q1 are the coordinates of both markers, whose numbers are the arguments of this decorator: 1 for
    MarkerNodeCoordinate, 0 for MarkerNodeCoordinates on a ground node. Derivatives of the equations follow from the
    record.
    """
    for number in (coordinates0, coordinates1):
        if isinstance(number, bool) or not isinstance(number, int) or number < 0:
            raise TypeError(f"constraint(...): received {number!r}, but expected the number of coordinates of a marker")

    def made(function: Callable[..., Any]) -> Law:
        names = {"q0": 0, "q1": 0, "t": 0}
        constants = _constants_of(function, names, _CONSTRAINT, _LEFT_OUT, "constraint")
        with _recording():
            return recorded_constraint(function, constants)

    def recorded_constraint(function: Callable[..., Any], constants: dict[str, float]) -> Law:
        t, item = _symbolic.Real("t", 0.0)._Open(), _symbolic.Real("itemNumber", 0.0)._Open()
        zeros = np.zeros(coordinates0 + coordinates1)
        if not zeros.size:
            raise TypeError("constraint(...): there are no coordinates")
        q, q_t = _symbolic.Vector("q", zeros)._Open(), _symbolic.Vector("q_t", zeros)._Open()
        level = _symbolic.Real("velocityLevel", 0.0)._Open()
        entries = np.array([*q, None], dtype=object)[:-1]
        returned = _run(function, [entries[:coordinates0], entries[coordinates0:], t], constants)
        equations = [_number(each) for each in _flat(function, returned, 0)]
        rates = [_symbolic._Rate(g, [(q, q_t), (t, 1.0)]) for g in equations]
        gaps = [_symbolic.IfThenElse(level, g_t, g) for g, g_t in zip(equations, rates, strict=True)]
        units = np.eye(len(zeros))
        gradient = [[_symbolic._Rate(g, [(q, unit)]) for unit in units] for g in equations]
        arguments = [t, item, q, q_t, level]
        recorded = {
            name: _function(function, arguments, value)
            for name, value in zip(
                _FUNCTIONS_OF_CONSTRAINT, (_symbolic.Vector(gaps), _symbolic.Matrix(gradient)), strict=True
            )
        }
        _require_read(function, constants, recorded["constraintUserFunction"])
        fixed = {"scalingMarker0": np.zeros((len(equations), 1))}
        return Law(function, _CONSTRAINT, recorded, constants, fixed, _LEFT_OUT)

    return made


def forces_of_coordinates(
    function: Callable[..., Any], coordinates: int, constants: dict[str, float] | None = None
) -> Any:
    """Record a function as the forceUserFunction of ObjectGenericODE2 or ObjectKinematicTree.

    f(q, q_t, t, **constants) returns one force per coordinate; q and q_t are the coordinates of the object, relative to
    their reference values, and their rates.
    """
    with _recording():
        t, item = _symbolic.Real("t", 0.0)._Open(), _symbolic.Real("itemNumber", 0.0)._Open()
        q, q_t = (_symbolic.Vector(name, np.zeros(coordinates))._Open() for name in ("q", "q_t"))
        returned = _run(function, [_entries(q), _entries(q_t), t], constants or {})
        forces = [_number(each) for each in _flat(function, returned, coordinates)]
        recorded = _function(function, [t, item, q, q_t], _symbolic.Vector(forces))
        _require_read(function, constants or {}, recorded)
        return recorded


def _chosen(decorator: str, kind: str, kinds: dict[str, _Kind]) -> _Kind:
    if not isinstance(kind, str) or kind not in kinds:
        given = "a function" if callable(kind) else repr(kind)
        raise ValueError(f"{decorator}(...): received {given}, but expected one of {', '.join(map(repr, kinds))}")
    return kinds[kind]


def _start_values(where: str, given: Any) -> dict[str, float]:
    if given is None:
        return {}
    if (
        not isinstance(given, dict)
        or not given
        or not all(isinstance(name, str) and name.isidentifier() for name in given)
    ):
        raise TypeError(
            f"connector(...): {where}: received {given!r}, but expected names and start values, as in {{'s': 0.0}}"
        )
    return {name: _constant(f"connector(...): {where}: {name}", value) for name, value in given.items()}


def _decorator(decorator: str, kind: str, kinds: dict[str, _Kind]) -> Callable[[Callable[..., Any]], Law]:
    chosen = _chosen(decorator, kind, kinds)

    def made(function: Callable[..., Any]) -> Law:
        constants = _constants_of(function, chosen.arguments, chosen.item, chosen.unused, f"{decorator}({kind!r})")
        with _recording():
            return recorded_item(function, constants)

    def recorded_item(function: Callable[..., Any], constants: dict[str, float]) -> Law:
        arguments = _arguments(chosen)
        own = [arguments[place] for place in chosen.arguments.values()]
        returned = _run(function, [_entries(argument) for argument in own], constants)
        numbers = _flat(function, returned, 3 * len(chosen.results) or 1, chosen.results)
        result = _symbolic.Vector(numbers) if chosen.results else _number(numbers[0])
        recorded = _function(function, arguments, result)
        _require_read(function, constants, recorded)
        return Law(function, chosen.item, {chosen.function: recorded}, constants, {}, chosen.unused)

    return made


# ---- states ----------------------------------------------------------------------------------------------------------
def _with_states(
    function: Callable[..., Any], kind: str, chosen: _Kind, states: dict[str, float], history: dict[str, float]
) -> Law:
    """Record a function of the relative motion and of states for ObjectConnectorLaw."""
    names = dict.fromkeys((*chosen.arguments, *states, *history), 0)
    axes = () if _SIZES_WITH_STATES[kind] == 6 else ("rotationMarker0", "rotationMarker1")
    unused = ("numberOfCoordinates", *_FUNCTIONS_WITH_STATES, *axes)
    constants = _constants_of(function, names, _WITH_STATES, unused, f"connector({kind!r})")
    with _recording():
        recorded = _recorded_with_states(function, kind, chosen, states, history, constants)
    fixed = {"numberOfCoordinates": _SIZES_WITH_STATES[kind]}
    return Law(function, _WITH_STATES, recorded, constants, fixed, unused, states, history)


def _recorded_with_states(
    function: Callable[..., Any],
    kind: str,
    chosen: _Kind,
    states: dict[str, float],
    history: dict[str, float],
    constants: dict[str, float],
) -> dict[str, Any]:
    size, further = _SIZES_WITH_STATES[kind], len(states) + len(history)
    t, item = _symbolic.Real("t", 0.0)._Open(), _symbolic.Real("itemNumber", 0.0)._Open()
    u, v, x = (
        _symbolic.Vector(name, np.zeros(n))._Open() for name, n in (("u", size), ("v", size), ("states", further))
    )
    own, forces_of = _motion(kind, _entries(u), _entries(v))
    returned = _run(function, [*own, t, *_entries(x)], constants)
    if not isinstance(returned, (tuple, list)) or len(returned) != 1 + further:
        found = f"{len(returned)} values" if isinstance(returned, (tuple, list)) else "one value"
        expected = [
            "the result",
            *(f"the rate of {name}" for name in states),
            *(f"{name} after the step" for name in history),
        ]
        raise TypeError(f"the law {function.__name__} returned {found}, but expected a tuple of {', '.join(expected)}")
    result = _flat(function, returned[0], 3 * len(chosen.results) or 1, chosen.results)
    numbers = [_flat(function, each, 1)[0] for each in returned[1:]]
    parts = [forces_of([_number(each) for each in result]), numbers[: len(states)], numbers[len(states) :]]
    recorded = {
        name: _function(function, [t, item, u, v, x], _symbolic.Vector(list(part)))
        for name, part in zip(_FUNCTIONS_WITH_STATES, parts, strict=True)
        if len(part)
    }
    _require_read(function, constants, *recorded.values())
    return recorded


def _motion(kind: str, u: Any, v: Any) -> tuple[list[Any], Callable[[list[Any]], list[Any]]]:
    """Return the arguments of a kind of law, and a function from its result to components of force and torque."""
    if kind == "coordinates":
        return [u[0], v[0]], lambda force: force
    if kind == "points":
        return [u, v], lambda force: force
    if kind == "frames":
        return [u[:3], u[3:], v[:3], v[3:]], lambda force: force
    if kind == "rotation":
        return [u[5], v[5]], lambda torque: [*[_number(0.0)] * 5, *torque]
    length = norm(u)
    return [length, u @ v / length], lambda tension: [tension[0] * each / length for each in u]


# ---- recording -------------------------------------------------------------------------------------------------------
def _constants_of(
    function: Callable[..., Any], names: dict[str, int], item: str, unused: Sequence[str], decorator: str
) -> dict[str, float]:
    """Return the arguments with defaults; the other ones must be as many as the law is called with."""
    if not inspect.isfunction(function):
        raise TypeError(f"{decorator}: expected a function, but received {function!r}")
    name = function.__name__
    parameters = list(inspect.signature(function).parameters.values())
    own = [each for each in parameters if each.default is inspect.Parameter.empty]
    if len(own) != len(names) or any(
        each.kind not in (each.POSITIONAL_ONLY, each.POSITIONAL_OR_KEYWORD) for each in own
    ):
        raise TypeError(
            f"{decorator}: {name} is called with ({', '.join(names)}), but has ({', '.join(map(str, own))}); "
            "arguments with a default value are constants"
        )
    for given, wanted in zip((each.name for each in own), names, strict=True):
        if given != wanted and given in names:
            raise TypeError(
                f"{decorator}: {name} is called with ({', '.join(names)}) in this order, but '{given}' is in the place "
                f"of '{wanted}'"
            )
    rows = [row for row in dict(item_class(item)()) if row not in unused]
    constants = {}
    for each in parameters:
        if each.default is inspect.Parameter.empty:
            continue
        if each.name in rows:
            raise TypeError(f"{decorator}: {name}: '{each.name}' is a parameter of {item}; choose another name")
        constants[each.name] = _constant(f"{decorator}: {name}: {each.name}", each.default)
    return constants


@contextmanager
def _recording() -> Iterator[None]:
    before = _symbolic.GetRecording()
    _symbolic.SetRecording(True)
    try:
        yield
    finally:
        _symbolic.SetRecording(before)


def _names_of_arguments(kind: _Kind) -> list[str]:
    """Return the names of all arguments of the user function: those that a law does not have are argument1, ..."""
    names = {place: name for name, place in kind.arguments.items()}
    count = len(_symbolic._signature(kind.item, kind.function)[0])
    return [names.get(place, f"argument{place}") for place in range(count)]


def _arguments(kind: _Kind) -> list[Any]:
    """Return symbols for all arguments of the user function."""
    kinds, _ = _symbolic._signature(kind.item, kind.function)
    sizes = iter(_sizes(kind.item, kind.function))
    arguments = []
    for name, shape in zip(_names_of_arguments(kind), kinds, strict=True):
        if shape not in ("vector", "matrix"):
            arguments.append(_symbolic.Real(name, 0.0)._Open())
            continue
        n = int(next(sizes))
        zeros = np.zeros(n if shape == "vector" else (n, n))
        arguments.append((_symbolic.Vector if shape == "vector" else _symbolic.Matrix)(name, zeros)._Open())
    return arguments


def _entries(argument: Any) -> Any:
    """Return vectors as arrays, with the operators of numpy."""
    if not isinstance(argument, _symbolic.Vector):
        return argument
    array = np.empty(len(argument), dtype=object)
    array[:] = list(argument)
    return array


def _run(function: Callable[..., Any], arguments: list[Any], constants: dict[str, float]) -> Any:
    """Call the function with symbols."""
    symbols = {name: _symbolic.Real(name, value)._Open() for name, value in constants.items()}
    try:
        return function(*arguments, **symbols)
    except _NotRecordedError:  # a function that the law calls, which is named already
        raise
    except Exception as error:
        line = _line_of(function, error.__traceback__)
        raise TypeError(f"{line}: the law {function.__name__} cannot be recorded: {_reason(error)}") from error


def _line_of(function: Callable[..., Any], traceback: TracebackType | None) -> str:
    """Return file, number and text of the innermost line in the file of the function."""
    code = function.__code__
    line = code.co_firstlineno
    while traceback is not None:
        if traceback.tb_frame.f_code.co_filename == code.co_filename:
            line = traceback.tb_lineno
        traceback = traceback.tb_next
    text = linecache.getline(code.co_filename, line).strip()
    return f"{Path(code.co_filename).name}, line {line}" + (f" ('{text}')" if text else "")


def _reason(error: Exception) -> str:
    text = str(error)
    if "truth of" in text:
        return (
            "a comparison has no value yet, so that if, and, or, min and max cannot decide. Use where(condition, a, b),"
            " minimum(a, b), maximum(a, b) or interpolate(x, xs, ys) of dalembert.laws"
        )
    if "has no value while" in text:
        return (
            "a quantity has no value yet, so that float, int, and functions of math cannot be used. Use functions of "
            "numpy, such as np.sin(x), interpolate(x, xs, ys) of dalembert.laws in place of np.interp, and array "
            "entries in a list: np.array([a, b, c])"
        )
    if "no callable" in text or "ufunc" in text:
        return (
            f"{text}. Use operators, np.sin, np.sqrt, np.exp and the like, or where, minimum, maximum, norm, atan2, "
            "sign and interpolate of dalembert.laws"
        )
    return text


def _flat(function: Callable[..., Any], value: Any, size: int, results: Sequence[str] = ()) -> list[Any]:
    """Return the numbers of a result: a number, an array, or lists of them; `size` of them, or, if it is 0, any."""

    def numbers(value: Any) -> Iterator[Any]:
        if isinstance(value, _symbolic.Real) or (
            isinstance(value, (int, float, np.number)) and not isinstance(value, bool)
        ):
            yield value
        elif isinstance(value, (list, tuple, np.ndarray, _symbolic.Vector)):
            for each in value if np.ndim(value) or not isinstance(value, np.ndarray) else [value.item()]:
                yield from numbers(each)
        else:
            raise TypeError(f"the law {function.__name__} returned {value!r} instead of numbers")

    found = list(numbers(value))
    if len(found) != (size or len(found)) or not found:
        expected = " and ".join(f"a {name} with 3 numbers" for name in results) or (
            "1 number" if size else "an equation"
        )
        raise TypeError(f"the law {function.__name__} returned {len(found)} numbers, but expected {expected}")
    return found


def _number(value: Any) -> Any:
    return value if isinstance(value, _symbolic.Real) else _symbolic.Real(float(value))


def _function(function: Callable[..., Any], arguments: list[Any], result: Any) -> Any:
    recorded = _symbolic.UserFunction()
    data = {"functionName": function.__name__, "argList": arguments, "returnValue": result}
    recorded.SetUserFunctionFromDict(None, data, function.__name__)
    return recorded


def _require_read(function: Callable[..., Any], constants: dict[str, float], *recorded: Any) -> None:
    unread = [name for name in constants if not any(name in each._Variables() for each in recorded)]
    if unread:
        raise TypeError(f"the law {function.__name__} does not read its constant '{unread[0]}'")


# ---- functions that can be recorded ----------------------------------------------------------------------------------
def _has_symbols(*values: Any) -> bool:
    return any(isinstance(value, _symbolic.Real) or np.asarray(value).dtype == object for value in values)


def _each(function: Callable[..., Any], *values: Any) -> Any:
    return np.frompyfunc(function, len(values), 1)(*values)


def where(condition: Any, a: Any, b: Any) -> Any:
    """a where the condition holds, else b; for numbers, arrays and recorded quantities."""
    return (
        _each(_symbolic.IfThenElse, condition, a, b) if _has_symbols(condition, a, b) else np.where(condition, a, b)[()]
    )


def minimum(a: Any, b: Any) -> Any:
    """The smaller one of two."""
    return _each(_symbolic.min, a, b) if _has_symbols(a, b) else np.minimum(a, b)


def maximum(a: Any, b: Any) -> Any:
    """The larger one of two."""
    return _each(_symbolic.max, a, b) if _has_symbols(a, b) else np.maximum(a, b)


def atan2(y: Any, x: Any) -> Any:
    """The angle of the direction (x, y)."""
    return _each(_symbolic.atan2, y, x) if _has_symbols(y, x) else np.arctan2(y, x)


def sign(x: Any) -> Any:
    """1, -1, or 0 at zero."""
    return _each(_symbolic.sign, x) if _has_symbols(x) else np.sign(x)


def norm(u: Any) -> Any:
    """The length of a vector; its derivative at zero is taken as zero."""
    return _symbolic.Vector(list(u)).NormL2() if _has_symbols(u) else float(np.linalg.norm(u))


def interpolate(
    x: Any, xs: Sequence[float] | FloatArray, ys: Sequence[float] | FloatArray, smooth: bool = False
) -> Any:
    """The value at x of the polygon through the points (xs, ys), as np.interp: constant beyond both ends.

    smooth: a cubic spline instead, whose first and second derivatives are continuous between the ends.
    """
    points, values = np.asarray(xs, dtype=float), np.asarray(ys, dtype=float)
    if points.ndim != 1 or points.shape != values.shape or len(points) < 2 or not (np.diff(points) > 0).all():
        raise ValueError("interpolate: expected two lists of the same length, the first one increasing")
    if not np.isfinite([points, values]).all():
        raise ValueError("interpolate: expected finite numbers")
    table = _spline(points, values) if smooth else _polygon(points, values)
    if _has_symbols(x):
        return _each(lambda each: _symbolic._Table(each, table), x)
    return _evaluated(points, table, x)


def _polygon(points: FloatArray, values: FloatArray) -> FloatArray:
    """Return points and coefficients of a polygon, as core/include/dalembert/math/piecewise_cubic.hpp lays them out."""
    zeros = np.zeros(len(points) - 1)
    coefficients = np.column_stack([values[:-1], np.diff(values) / np.diff(points), zeros, zeros])
    return np.concatenate([points, coefficients.ravel()])


def _spline(points: FloatArray, values: FloatArray) -> FloatArray:
    from scipy.interpolate import CubicSpline

    return np.concatenate([points, CubicSpline(points, values).c[::-1].T.ravel()])


def _evaluated(points: FloatArray, table: FloatArray, x: Any) -> Any:
    inside = np.clip(np.asarray(x, dtype=float), points[0], points[-1])
    number = np.clip(np.searchsorted(points, inside, side="right") - 1, 0, len(points) - 2)
    c, s = table[len(points) :].reshape(-1, 4)[number], inside - points[number]
    return (c[..., 0] + s * (c[..., 1] + s * (c[..., 2] + s * c[..., 3])))[()]
