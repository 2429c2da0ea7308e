"""Compiled user functions: C functions made by numba or by another compiler instead of Python functions.

A user function of an item may be a callback of numba (``numba.cfunc``), a function pointer of ctypes, or a
``scipy.LowLevelCallable``. It is called without Python, so its arguments are those of the Python function without
``mbs``, in C types: a number is a ``double``, an integer or a truth value an ``int64_t``, a vector or a matrix, row by
row, a ``const double*``. If the length of a vector or matrix depends on the model, an ``int64_t`` with the number of
its entries follows. A single number is returned; vectors and matrices are written to a last argument, ``double*
result``.
The page of each item shows its functions in this form.
"""

from __future__ import annotations

import ctypes
import importlib
import re
from typing import Any

from dalembert import _core

_CTYPES: dict[str, Any] = {
    "void": None,
    "double": ctypes.c_double,
    "int64": ctypes.c_int64,
    "double*": ctypes.POINTER(ctypes.c_double),
}
_FunctionPointer: type = ctypes.CFUNCTYPE(None).__mro__[1]  # the base class of all
_C_NAMES = {"long": "int64", "long long": "int64", "int64_t": "int64", "npy_int64": "int64"}


def c_signature(item: type | str, userFunction: str) -> str:
    """The C types of a user function, e.g. "double(double, int64, double, double)".

    item: class of the item or its name, e.g. exu.ObjectConnectorCoordinateSpringDamper; exu.MainSystem has the
        functions "PreStepUserFunction", "PostStepUserFunction" and "PostNewtonUserFunction", and "Controller" the
        function "desired" (see dalembert.control)
    userFunction: name of the parameter, e.g. "springForceUserFunction"
    returns: type of the result, and in brackets those of the arguments: double, int64 or double*
    raises ValueError if the item has no such user function, or if it cannot be a C function
    """
    name = _type_name(item)
    signature: str | None = _core._compiled_signature(name, userFunction)
    if signature is None:
        raise ValueError(f"compiled: {name} has no user function '{userFunction}'")
    if not signature:
        raise ValueError(f"compiled: '{userFunction}' of {name} cannot be a C function; pass a Python function")
    return signature


def numba_signature(item: type | str, userFunction: str) -> Any:
    """The signature for numba.cfunc(...); numba must be installed.

    item, userFunction: as in c_signature
    returns: numba.core.typing.Signature
    """
    try:
        types: Any = importlib.import_module("numba").types
    except ImportError as error:
        raise ImportError("compiled.numba_signature needs numba; install it, e.g. by 'pip install numba'") from error
    known = {
        "void": types.void,
        "double": types.float64,
        "int64": types.int64,
        "double*": types.CPointer(types.float64),
    }
    result, arguments = _types(c_signature(item, userFunction))
    return known[result](*(known[argument] for argument in arguments))


def ctypes_signature(item: type | str, userFunction: str) -> Any:
    """The function pointer type of ctypes: makes a C function from an address, or from a Python function for tests.

    item, userFunction: as in c_signature
    returns: the type of ctypes.CFUNCTYPE(...)
    """
    result, arguments = _types(c_signature(item, userFunction))
    return ctypes.CFUNCTYPE(_CTYPES[result], *(_CTYPES[argument] for argument in arguments))


def _type_name(item: type | str) -> str:
    """The full name of an item's class, which may be given by a short name or an alias such as exu.SpringDamper."""
    given = item if isinstance(item, str) else item.__name__
    return str(getattr(_core._item_classes().get(given), "__name__", given))


def _types(signature: str) -> tuple[str, list[str]]:
    result, arguments = re.fullmatch(r"(.*?)\((.*)\)", signature).groups()  # type: ignore[union-attr]
    return result, [argument.strip() for argument in arguments.split(",")]


def _recognized(value: Any) -> tuple[int, str] | None:
    """Address and C signature of a C function, "" if it is not declared; None: it is something else."""
    if type(value).__name__ == "LowLevelCallable":
        return _low_level_callable(value)
    if type(value).__module__.startswith("numba.") and hasattr(value, "address"):
        value = value.ctypes
    return _function_pointer(value) if isinstance(value, _FunctionPointer) else None


def _function_pointer(pointer: Any) -> tuple[int, str]:
    address = ctypes.cast(pointer, ctypes.c_void_p).value or 0
    if pointer.argtypes is None:
        return address, ""
    return address, f"{_ctype_name(pointer.restype)}({', '.join(map(_ctype_name, pointer.argtypes))})"


def _ctype_name(ctype: Any) -> str:
    if isinstance(ctype, type) and issubclass(ctype, ctypes._Pointer):
        return _ctype_name(ctype._type_) + "*"
    names = [name for name, known in _CTYPES.items() if known is ctype]
    return names[0] if names else str(getattr(ctype, "__name__", ctype))


def _low_level_callable(value: Any) -> tuple[int, str]:
    """The capsule has the address, its name is the declaration in C."""
    pointer = ctypes.pythonapi.PyCapsule_GetPointer
    pointer.restype, pointer.argtypes = ctypes.c_void_p, [ctypes.py_object, ctypes.c_char_p]
    declared = value.signature
    address = pointer(tuple(value)[0], declared.encode())
    result, arguments = _types(declared)
    names = [re.sub(r"\bconst\b|\s+(?=\*)", "", text).strip() for text in (result, *arguments)]
    result, *arguments = (_C_NAMES.get(name, name) for name in names)
    data = " with user data" if value.user_data is not None else ""
    return address, f"{result}({', '.join(arguments)}){data}"
