"""Python user functions recorded as symbolic ones."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from dalembert import _core
from dalembert._function_sizes import ASSEMBLE, NODES, SIZES
from dalembert._tools.item_packages import facts

_SYMBOLIC_TYPES = {
    "scalar": "Real",
    "boolean": "Bool",
    "integer": "Index",
    "vector": "StdVector",
    "matrix": "NumpyMatrix",
}


_MAIN_SYSTEM_FUNCTIONS = {"preStepUserFunction": "Bool", "postNewtonFunction": "StdVector2D"}


def _item_with_function(mbs: Any, itemIndex: Any) -> tuple[str, Any]:
    """Type name and dictionary of an item, e.g. ObjectConnectorSpringDamper."""
    kinds = ("Node", "Object", "Marker", "Load", "Sensor")
    kind = next((kind for kind in kinds if isinstance(itemIndex, getattr(_core, f"{kind}Index"))), None)
    if kind is None:
        raise TypeError(f"CreateSymbolicUserFunction: itemIndex must be an ObjectIndex or the like, not {itemIndex!r}")
    data = getattr(mbs, "Get" + kind)(itemIndex)
    name: str = data[kind.lower() + "Type"]
    return kind + name, data


def _sizes(item: str, function: str) -> Sequence[int]:
    """Return the sizes of the arrays that a user function receives, also for items of packages."""
    of_packages = {(name, own): sizes for table in facts("sizes") for name, own, sizes in table}
    return SIZES.get((item, function)) or of_packages.get((item, function), ())


def _coordinates_of_nodes(mbs: Any, data: Any) -> int:
    if data is None:
        raise ValueError(
            "ConvertFunctionToSymbolic: the number of coordinates is needed; pass itemIndex instead of itemTypeName"
        )
    numbers = data["nodeNumbers"] if "nodeNumbers" in data else [data["nodeNumber"]]
    return sum(len(mbs.GetNode(n)["referenceCoordinates"]) for n in numbers)


def ConvertFunctionToSymbolic(
    mbs: Any,
    function: Callable[..., Any],
    userFunctionName: str,
    itemIndex: Any = None,
    itemTypeName: str | None = None,
    verbose: int = 0,
) -> dict[str, Any]:
    """Call a Python user function once with symbolic arguments and record its operations.

    userFunctionName is the parameter of the item, e.g. 'springForceUserFunction'. Either itemIndex or itemTypeName
    (e.g. 'ObjectConnectorSpringDamper' or 'MainSystem') selects the item. The result is a dictionary with functionName,
    argList, argTypeList, returnValue and returnType, as UserFunction.SetUserFunctionFromDict(...) takes it.
    The function must be made of operators and of functions of exu.symbolic; 'if' cannot be recorded, use
    exu.symbolic.IfThenElse.
    """
    symbolic = _core.symbolic
    data = None
    if itemTypeName is None:
        if itemIndex is None:
            raise ValueError("ConvertFunctionToSymbolic: either itemIndex or itemTypeName is needed")
        itemTypeName, data = _item_with_function(mbs, itemIndex)
    elif itemIndex is not None:
        raise ValueError("ConvertFunctionToSymbolic: pass itemIndex or itemTypeName, but not both")
    if itemTypeName == "MainSystem":
        kinds = ["scalar"] if userFunctionName in _MAIN_SYSTEM_FUNCTIONS else None
        result_type = _MAIN_SYSTEM_FUNCTIONS.get(userFunctionName, "")
    else:
        signature = symbolic._signature(itemTypeName, userFunctionName)
        kinds, result_kind = signature if signature is not None else (None, "")
        result_type = _SYMBOLIC_TYPES.get(result_kind, result_kind)
    if kinds is None:
        raise ValueError(f"ConvertFunctionToSymbolic: {itemTypeName} has no user function '{userFunctionName}'")
    known = _sizes(itemTypeName, userFunctionName)
    sizes = iter(known)
    if ASSEMBLE in known:
        raise NotImplementedError(
            f"ConvertFunctionToSymbolic: {itemTypeName}, '{userFunctionName}': the sizes of its vectors are known at "
            "Assemble() only; pass the Python function itself"
        )
    names = list(inspect.signature(function).parameters)
    if len(names) != len(kinds) + 1:
        raise ValueError(
            f"ConvertFunctionToSymbolic: {itemTypeName}, '{userFunctionName}' is called with mbs and {len(kinds)} "
            f"further arguments, but the function has the parameters {', '.join(names)}"
        )
    arguments: list[Any] = [mbs]
    stored = symbolic.GetRecording()
    symbolic.SetRecording(True)
    try:
        for name, kind in zip(names[1:], kinds, strict=True):
            if kind not in ("vector", "matrix"):
                arguments.append(symbolic.Real(name, 0.0)._Open())
                continue
            size = next(sizes)
            n = _coordinates_of_nodes(mbs, data) if size == NODES else size
            zeros = np.zeros(n if kind == "vector" else (n, n))
            arguments.append((symbolic.Vector if kind == "vector" else symbolic.Matrix)(name, zeros)._Open())
        returned = function(*arguments)
        if isinstance(returned, (list, tuple)):
            nested = len(returned) > 0 and isinstance(returned[0], (list, tuple))
            returned = symbolic.Matrix(returned) if nested else symbolic.Vector(returned)
    finally:
        symbolic.SetRecording(stored)
    if verbose:
        _core.Print("return value=", returned)
    return {
        "functionName": function.__name__,
        "argList": arguments,
        "argTypeList": ["MainSystem", *(_SYMBOLIC_TYPES.get(kind, kind) for kind in kinds)],
        "returnValue": returned,
        "returnType": result_type,
    }


def CreateSymbolicUserFunction(
    mbs: Any,
    function: Callable[..., Any],
    userFunctionName: str,
    itemIndex: Any = None,
    itemTypeName: str | None = None,
    verbose: int = 0,
) -> Any:
    """Make a symbolic user function of a Python function, to be set as parameter of an item."""
    data = ConvertFunctionToSymbolic(mbs, function, userFunctionName, itemIndex, itemTypeName, verbose)
    symbolic_function = _core.symbolic.UserFunction()
    symbolic_function.SetUserFunctionFromDict(mbs, data, userFunctionName, itemIndex, str(itemTypeName))
    return symbolic_function
