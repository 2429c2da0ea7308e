"""Error texts for calls of compiled functions with wrong arguments."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

from dalembert import _core
from dalembert._tools.missing_names import nearest

# Objects as models call them, and how they are made.
_SPELT = {
    "SystemContainer": ("SC", "SC = exu.SystemContainer()"),
    "MainSystem": ("mbs", "mbs = SC.AddSystem()"),
    "SystemData": ("mbs.systemData", "mbs = SC.AddSystem()"),
    "Renderer": ("SC.renderer", "SC = exu.SystemContainer()"),
    "GeneralContact": ("contact", "contact = mbs.AddGeneralContact()"),
    "SimulationSettings": ("settings", "settings = exu.SimulationSettings()"),
    "VisualizationSettings": ("SC.visualizationSettings", "SC = exu.SystemContainer()"),
}
# Names of pybind11 for types, in words, and their Python types.
_TYPES: dict[str, tuple[str, tuple[type, ...]]] = {
    "typing.SupportsFloat | typing.SupportsIndex": ("a number", (int, float)),
    "float": ("a number", (int, float)),
    "typing.SupportsInt | typing.SupportsIndex": ("an integer", (int,)),
    "int": ("an integer", (int,)),
    "bool": ("True or False", (bool,)),
    "str": ("a text", (str,)),
    "dict": ("a dictionary", (dict,)),
    "list": ("a list", (list,)),
    "object": ("anything", (object,)),
}


class _Parameter(NamedTuple):
    name: str
    type: str
    default: str

    def __str__(self) -> str:
        return f"{self.name}={self.default}" if self.default else self.name

    @property
    def words(self) -> str:
        if "Sequence" in self.type or "Annotated" in self.type:
            return "a list or an array"
        return _TYPES[self.type][0] if self.type in _TYPES else self.type.split(".")[-1].rstrip("]")

    def takes(self, value: Any) -> bool:
        own = getattr(_core, self.type.split(".")[-1], None) if self.type.startswith("dalembert._core.") else None
        types = (own,) if isinstance(own, type) else _TYPES.get(self.type, ("", (object,)))[1]
        return isinstance(value, types) or (int in types and hasattr(value, "__index__"))


def _split(text: str) -> Iterator[str]:
    """Split at commas that are in no brackets."""
    depth, begin = 0, 0
    for i, letter in enumerate(text):
        depth += (letter in "([{") - (letter in ")]}")
        if letter == "," and depth == 0:
            yield text[begin:i].strip()
            begin = i + 1
    if text[begin:].strip():
        yield text[begin:].strip()


def _parameters(signature: str) -> list[_Parameter]:
    inner = signature[signature.index("(") + 1 : signature.rindex(")", 0, signature.find(" -> ") + 1 or None)]
    found = []
    for entry in _split(inner):
        name, _, rest = entry.partition(":")
        kind, _, default = rest.partition(" = ")
        found.append(_Parameter(name.strip(), kind.strip(), default.strip()))
    return found


def _property(value: Any, record: Any) -> str:
    """Return the name of the property that a compiled function sets."""
    for cls in type(value).__mro__:
        for name, found in vars(cls).items():
            setter = getattr(found, "fset", None) if isinstance(found, property) else None
            if getattr(getattr(setter, "__func__", setter), "__self__", None) is record:
                return name
    return "a property"


def in_words(text: str, values: Sequence[Any], names: Sequence[str], record: Any = None) -> str:
    """Return the error of a call, and the correct signature.

    text: message of pybind11, with the name of the function and its signatures
    values: positional arguments, followed by keyword arguments
    names: the names of the latter
    record: the record of pybind11 on the function
    """
    name = text.partition("(")[0]
    signatures = re.findall(r"^    \d+\. (.+)$", text, re.MULTILINE)
    count = len(values) - len(names)
    by_position, by_name = list(values[:count]), dict(zip(names, values[count:], strict=True))
    parameters = [_parameters(signature) for signature in signatures]
    if not name:
        owner, value = type(values[0]).__name__, values[-1]
        wanted = parameters[0][-1].words
        received = f"received {value!r} ({type(value).__name__}), but expected {wanted}"
        return f"{owner}.{_property(values[0], record)}: {received}"
    owner, call = "", name
    if parameters[0] and parameters[0][0].name == "self":
        owner = parameters[0][0].type.split(".")[-1]
        parameters = [each[1:] for each in parameters]
        spelt, made = _SPELT.get(owner, (owner[0].lower() + owner[1:], f"an object of {owner}"))
        call = f"{spelt}.{name}"
        if not by_position or not isinstance(by_position[0], getattr(_core, owner, object)):
            how = f"Make one, {made}, and call {_written(call, parameters)}"
            return f"{owner}.{name}(...) is a method of objects, and was called on their class. {how}"
        by_position = by_position[1:]
    elif name == "__init__":
        call = signatures[0].partition("(")[0].split(".")[-1]
        by_position = by_position[1:]
    problem = "arguments that none of its forms takes"
    if len(parameters) == 1:
        problem = _problem(parameters[0], by_position, by_name)
    stop = "" if problem.endswith("?") else "."
    return f"{call}(...): {problem}{stop} Call {_written(call, parameters)}"


def _written(call: str, parameters: list[list[_Parameter]]) -> str:
    return " or ".join(f"{call}({', '.join(map(str, each))})" for each in parameters)


def _problem(parameters: list[_Parameter], by_position: list[Any], by_name: dict[str, Any]) -> str:
    known = [each.name for each in parameters]
    if len(by_position) > len(parameters):
        counts = f"{len(parameters) or 'no'} argument{'s' if len(parameters) != 1 else ''}"
        return f"it takes {counts}, {len(by_position)} {'were' if len(by_position) > 1 else 'was'} given"
    given = dict(zip(known, by_position, strict=False))
    for name in by_name:
        if name not in known:
            return f"there is no argument '{name}'{nearest(name, known)}"
        if name in given:
            return f"the argument '{name}' was given twice"
    given |= by_name
    for each in parameters:
        if each.name not in given and not each.default:
            return f"the argument '{each.name}'{'' if each.type == 'object' else f', {each.words},'} is missing"
    wrong = [each for each in parameters if each.name in given and not each.takes(given[each.name])]
    if not wrong:
        return "an argument is of a wrong type"
    value = given[wrong[0].name]
    return f"the argument '{wrong[0].name}' must be {wrong[0].words}, received {value!r} ({type(value).__name__})"
