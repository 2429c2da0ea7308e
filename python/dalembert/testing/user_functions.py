"""User functions of items, made from their signatures: smooth, and consistent where several belong together."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from codegen.model import Item, UserFunction
from dalembert import compiled


def smooth(function: UserFunction) -> Callable[..., Any]:
    """Fixed sums of sines of all arguments, of the shape that the function returns."""
    shape = function.returns.shape
    skip = len(function.standard)

    def value(*arguments: Any) -> Any:
        x = np.concatenate([np.ravel(a) for a in arguments[skip:]]).astype(float)
        size = shape[0] if shape and shape[0] else len(np.ravel(arguments[skip])) if shape else 1
        weights = np.cos(np.outer(1.0 + np.arange(size), 1.0 + np.arange(len(x))))
        result = 0.3 * weights @ np.sin(x) + 0.1 * np.sin(1 + np.arange(size))
        return result.tolist() if shape else float(result[0])

    return value


def prescribed(factor: float, size: int) -> tuple[Callable[..., Any], Callable[..., Any]]:
    """A motion in time, and its rate."""

    def amplitude(parameters: Any) -> float:
        return float(0.3 + 0.1 * np.sum(parameters))

    def offset(mbs: Any, t: float, item: int, parameters: Any) -> Any:
        values = amplitude(parameters) * np.sin(factor * t + 0.2 * np.arange(1, size + 1))
        return values.tolist() if size > 1 else float(values[0])

    def rate(mbs: Any, t: float, item: int, parameters: Any) -> Any:
        values = amplitude(parameters) * factor * np.cos(factor * t + 0.2 * np.arange(1, size + 1))
        return values.tolist() if size > 1 else float(values[0])

    return offset, rate


def coordinate_vector(equations: int, n: int) -> dict[str, Callable[..., Any]]:
    """Quadratic equations A q + B q^2."""
    a = np.cos(np.outer(1.0 + np.arange(equations), 1.0 + np.arange(n)))
    b = 0.5 * np.sin(np.outer(1.0 + np.arange(equations), 1.0 + np.arange(n)))

    def constraint(mbs: Any, t: float, item: int, q: Any, q_t: Any, velocity_level: bool) -> Any:
        q, q_t = np.array(q), np.array(q_t)
        return (a @ q_t + 2 * b @ (q * q_t) if velocity_level else a @ q + b @ q**2).tolist()

    def jacobian(mbs: Any, t: float, item: int, q: Any, q_t: Any, velocity_level: bool) -> Any:
        return a + 2 * b * np.array(q)

    return {"constraintUserFunction": constraint, "jacobianUserFunction": jacobian}


def generic_ode2() -> dict[str, Callable[..., Any]]:
    def force(mbs: Any, t: float, item: int, q: Any, q_t: Any) -> Any:
        return (-2 * np.array(q) ** 3 - 0.3 * np.array(q_t) ** 2).tolist()

    def mass(mbs: Any, t: float, item: int, q: Any, q_t: Any) -> Any:
        return (2 + np.sin(1.0)) * np.eye(len(q))

    def jacobian(mbs: Any, t: float, item: int, q: Any, q_t: Any, factor: float, factor_t: float) -> Any:
        return np.diag(6 * factor * np.array(q) ** 2 + 0.6 * factor_t * np.array(q_t))

    return {"forceUserFunction": force, "massMatrixUserFunction": mass, "jacobianUserFunction": jacobian}


def functions_of(item: Item, rows: dict[str, Any]) -> dict[str, Any]:
    """All user functions of an item with the given parameters."""
    names = {row.name for row in item.parameters}
    if "constraintUserFunction" in names:
        sizes = [rows[f"scalingMarker{i}"].shape for i in range(2)]
        return coordinate_vector(sizes[0][0], sizes[0][1] + sizes[1][1])
    if "massMatrixUserFunction" in names:
        made = {name: function for name, function in generic_ode2().items() if name in names}
        if {"massMatrixReduced", "massMatrixFF"} & names:
            # force on two coordinates, in addition to that of the body: a length of Euler parameters has no inertia
            made["massMatrixUserFunction"] = lambda mbs, t, item, q, q_t: np.diag([0.0] * (len(q) - 2) + [1.5, 2.5])
        return made
    made = {f.name: smooth(f) for f in item.user_functions if f.name in names}
    if "offsetUserFunction" in made:
        size = item.user_functions[0].returns.shape[0] if item.user_functions[0].returns.shape else 1
        made["offsetUserFunction"], made["offsetUserFunction_t"] = prescribed(1.5, size or 1)
    if "historyUserFunction" in made:
        size = next(int(node.values["numberOfODE1Coordinates"]) for node in item.scene.nodes)
        rate = made["stateRateUserFunction"]
        made["stateRateUserFunction"] = lambda *arguments: rate(*arguments)[:size]
        made["historyUserFunction"] = lambda *arguments: arguments[5][size:]
    if "postNewtonStepUserFunction" in made:
        made["postNewtonStepUserFunction"] = lambda *arguments: [0.0, -1.0, *arguments[3]]
    return made


def as_c_function(item: Item, function: UserFunction, python: Callable[..., Any]) -> Any:
    """A C function that hands its arguments to a Python function, with None for mbs."""

    def array(pointer: Any, kind: str, shape: tuple[int | None, ...], rest: Iterator[Any]) -> Any:
        sizes = [next(rest)] if kind.startswith("open_") else [size for size in shape if size is not None]
        return np.ctypeslib.as_array(pointer, tuple(sizes))

    def called(*numbers: Any) -> Any:
        rest = iter(numbers)
        arguments = [None, *(next(rest) for _ in function.standard[1:])]
        for argument in function.arguments:
            value = next(rest)
            kind = argument.type.kind
            is_array = kind.endswith(("vector", "matrix"))
            arguments.append(array(value, kind, argument.shape, rest).copy() if is_array else value)
        result = python(*arguments)
        if not function.returns.shape:
            return result
        kind = function.returns.type.kind
        array(next(rest), kind, function.returns.shape, rest)[:] = np.ravel(result)
        return None

    return compiled.ctypes_signature(item.name, function.name)(called)
