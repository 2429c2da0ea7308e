"""Signals between a model and FMUs: parameters that are set from outside, and outputs that are read.

Both have a plain form, a list for JSON files and pickles, from which they are made again for a system.
"""

from __future__ import annotations

import re
import warnings
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from dalembert import _core
from dalembert._checks import FloatArray
from dalembert._model.handle import Handle, handle_of
from dalembert._model.solution import output_of
from dalembert._snake_case import snake_case
from dalembert._tools.item_facts import facts_of

_NAME = re.compile(r"[A-Za-z_]\w*(\.[A-Za-z_]\w*)*")


class Parameter:
    """A parameter of an item, or an entry of one that is a vector."""

    def __init__(self, handle: Any, name: str, entry: int | None = None) -> None:
        self.handle, self.name, self.entry = handle, name, entry

    def get(self) -> float:
        value = self.handle.parameters[self.name]
        return float(value if self.entry is None else value[self.entry])

    def set(self, value: float) -> None:
        if self.entry is None:
            self.handle.parameters[self.name] = value
            return
        vector = np.array(self.handle.parameters[self.name], dtype=float)
        vector[self.entry] = value
        self.handle.parameters[self.name] = vector.tolist()

    def plain(self) -> list[Any]:
        return [*_plain_item(self.handle), self.name, self.entry]

    @classmethod
    def of(cls, mbs: Any, plain: list[Any]) -> Parameter:
        return cls(_item(mbs, plain[:3]), *plain[3:])


class Output:
    """An output of an item or the values of a sensor, or one component."""

    def __init__(self, handle: Any, name: str, position: Any = None, entry: int | None = None) -> None:
        self.handle, self.name, self.position, self.entry = handle, name, position, entry

    def values(self) -> FloatArray:
        if self.handle._kind == "Sensor" or (self.handle._kind == "Load" and self.name == "value"):
            value = self.handle.value
        else:
            value = self.handle.output(self.name, local_position=self.position)
        all_values = np.ravel(np.asarray(value, dtype=float))
        return all_values if self.entry is None else all_values[self.entry : self.entry + 1]

    def plain(self) -> list[Any]:
        position = None if self.position is None else np.asarray(self.position, dtype=float).tolist()
        return [*_plain_item(self.handle), self.name, position, self.entry]

    @classmethod
    def of(cls, mbs: Any, plain: list[Any]) -> Output:
        return cls(_item(mbs, plain[:3]), *plain[3:])


def _plain_item(handle: Any) -> list[Any]:
    return [handle._kind, int(handle), handle.name]


def _item(mbs: Any, plain: list[Any]) -> Any:
    kind, number, name = plain
    if number < getattr(mbs.systemData, f"NumberOf{kind}s")():
        handle = handle_of(mbs, getattr(_core, f"{kind}Index")(number))
        if handle.name == name:
            return handle
    raise ReferenceError(f"{kind.lower()} {number} is not '{name}' any more: items were deleted or renamed")


def parameters_of(model: Any, given: Any, name: str, where: str) -> dict[str, Parameter]:
    """Return the parameters of (item, 'parameter'), (item, 'parameter', entry), or a load, by name.

    All entries of a vector are name[1], name[2] and so on.
    """
    handle, parameter, entry = _parts_of_parameter(model, given, where)
    if handle._kind == "Node":
        raise ValueError(f"{where}: {handle!r}: parameters of nodes do not act during a solution")
    try:
        value = handle.parameters[parameter]
    except KeyError as error:
        raise ValueError(f"{where}: {error.args[0]}") from None
    row = facts_of(handle._item).parameters.get(snake_case(parameter))
    constants = handle._constants(row.name) if row else []
    if row and (reason := handle._unread(row.name)):
        raise ValueError(f"{where}: {handle!r}: {reason}")
    if isinstance(value, float):
        parameter = constants[0] if constants else parameter
        if entry is not None:
            raise ValueError(f"{where}: {handle!r}: {parameter} is one number, without entry {entry!r}")
        return {name: Parameter(handle, parameter)}
    if not isinstance(value, np.ndarray) or value.ndim != 1:
        raise ValueError(f"{where}: {handle!r}: {parameter} is {value!r}, but expected a real number or a vector")
    if entry is None:
        return {f"{name}[{i + 1}]": Parameter(handle, parameter, i) for i in range(len(value))}
    return {name: Parameter(handle, parameter, _entry_of(entry, len(value), f"{where}: {handle!r}: {parameter}"))}


def warn_of_inertia(where: str, parameters: Iterable[Parameter]) -> None:
    """Warn of rigid bodies whose mass or center of mass is set from outside, but not the inertia that belongs to it."""
    names: dict[Any, set[str]] = {}
    for each in parameters:
        row = facts_of(each.handle._item).parameters.get(snake_case(each.name))
        names.setdefault(each.handle, set()).add(row.name if row else each.name)
    for handle, given in names.items():
        changed = given & {"physicsMass", "physicsCenterOfMass"}
        if changed and "physicsInertia" not in given and "physics_inertia" in handle.parameters:
            name = " and ".join(sorted(snake_case(each.removeprefix("physics")) for each in changed))
            text = (
                f"{where}: {handle!r}: another {name} does not change the inertia (about the reference point). Add "
                f"('{handle.name}', 'inertia') to set it as well, or use a mass point for a payload"
            )
            warnings.warn(text, stacklevel=4)


def _parts_of_parameter(model: Any, given: Any, where: str) -> tuple[Any, str, Any]:
    if isinstance(given, (str, Handle)):
        handle = model._item_of(given, where)
        if handle._kind != "Load":
            example = "(item, 'stiffness')"
            raise ValueError(f"{where}: received {handle!r} without a parameter: write {example} for example")
        return handle, "load" if "load" in handle.parameters else "load_vector", None
    if not isinstance(given, tuple) or len(given) not in (2, 3) or not isinstance(given[1], (str, int, np.integer)):
        raise ValueError(
            f"{where}: expected a load, (item, 'parameter') or (item, 'parameter', entry), received {given!r}"
        )
    if isinstance(given[1], (int, np.integer)):
        return *_parts_of_parameter(model, given[0], where)[:2], given[1]
    return model._item_of(given[0], where), given[1], given[2] if len(given) == 3 else None


def _entry_of(entry: Any, size: int, where: str) -> int:
    if not isinstance(entry, (int, np.integer)) or isinstance(entry, bool) or not 0 <= entry < size:
        raise ValueError(f"{where}: received entry {entry!r}, but expected 0 to {size - 1}")
    return int(entry)


def signal_of(model: Any, given: Any, where: str) -> Output:
    """Return the output of a sensor, (item, 'output'), (item, 'output', point) or 'item.output'; an int selects.

    (sensor, 1) and (item, 'output', 1) are the component with this number.
    """
    entry = None
    if isinstance(given, tuple) and len(given) > 1 and isinstance(given[-1], (int, np.integer)):
        *rest, entry = given
        given = rest[0] if len(rest) == 1 else tuple(rest)
    output = Output(*output_of(model, given, where))
    if entry is not None:
        output.entry = _entry_of(entry, len(output.values()), f"{where}: {output.handle!r}: {output.name}")
    return output


def check_names(where: str, given: Any, example: str) -> None:
    """Raise an error if an argument has no names that FMI allows."""
    if not isinstance(given, Mapping):
        raise TypeError(f"{where}: expected {example}, received {given!r}")
    for name in given:
        if not isinstance(name, str) or not _NAME.fullmatch(name) or name == "time":
            raise ValueError(f"{where}: received the name {name!r}; expected letters, digits and _, but not 'time'")


def missing_package(where: str, package: str) -> ImportError:
    return ImportError(f"{where}: the package {package} is needed; install it with \"pip install 'dalembert[fmi]'\"")
