"""Laws in Python as items of a package: spec and kernel, made from what was recorded."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from dalembert._tools.item_builds import BuildError, new
from dalembert.laws import Law

# ---- formulas --------------------------------------------------------------------------------------------------------
_STEPS = {"sign": "recorded::sign", "round": "recorded::round", "ceil": "std::ceil", "floor": "std::floor"}
_COMPARISONS = ("<", "<=", ">", ">=")
_FUNCTIONS = (
    *("abs", "exp", "sqrt", "log", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh"),
    *("asinh", "acosh", "atanh"),
)


class _Formulas:
    """Statements in C++ for the nodes of a recorded function. Vectors and matrices are lists of scalars, row by row."""

    def __init__(self, stored: Mapping[str, Any], arguments: Mapping[int, Sequence[str]]) -> None:
        self.lines: list[str] = []
        self._nodes, self._values, self._shapes = stored["nodes"], [], []
        inputs = {node: arguments.get(place, ()) for place, node in enumerate(stored["arguments"])}
        used = self._used(stored["result"])
        for number, node in enumerate(self._nodes):
            shape, values = self._made(number, node, inputs) if number in used else ((0, 0), [])
            self._shapes.append(shape)
            self._values.append(values)
        self.result: list[str] = self._values[stored["result"]]

    def _used(self, root: int) -> set[int]:
        used, open_nodes = set(), [root]
        while open_nodes:
            number = open_nodes.pop()
            if number not in used:
                used.add(number)
                open_nodes += self._operands(self._nodes[number])
        return used

    @staticmethod
    def _operands(node: Any) -> list[int]:
        if not isinstance(node, list):
            return []
        return node[1:-1] if node[0] in ("element", "replace", "gather") else node[1:]

    def _made(self, number: int, node: Any, inputs: Mapping[int, Sequence[str]]) -> tuple[tuple[int, int], list[str]]:
        if isinstance(node, float):
            return (0, 0), [_literal(node)]
        if isinstance(node, dict):
            shape = tuple(node["shape"])
            if number in inputs:
                return shape, list(inputs[number])
            return shape, [f"p.{node['name']}"] if node["name"] else [_literal(x) for x in node["values"]]
        operands = self._operands(node)
        shapes, values = [self._shapes[i] for i in operands], [self._values[i] for i in operands]
        name, last = node[0], node[-1]
        if name == "element":
            return (0, 0), [values[0][last]]
        if name == "gather":
            return tuple(last), [each[0] for each in values]
        if name == "replace":
            return shapes[0], [*values[0][:last], values[1][0], *values[0][last + 1 :]]
        shape, formulas = self._formulas(name, shapes, values)
        return shape, [self._stated(number, i, formula) for i, formula in enumerate(formulas)]

    def _stated(self, number: int, component: int, formula: str) -> str:
        name = f"x{number}" + (f"_{component}" if component else "")
        self.lines.append(f"const auto {name} = {formula};")
        return name

    def _formulas(self, name: str, shapes: Any, values: Any) -> tuple[tuple[int, int], list[str]]:
        first, second = values[0], values[1] if len(values) > 1 else []
        shape: tuple[int, int] = shapes[0]
        if name == "*":
            return self._product(shapes, first, second)
        if name in ("+", "-"):
            return shape, [f"{a} {name} {b}" for a, b in zip(first, second, strict=True)]
        if name == "multiply_components":
            return shape, [f"{a} * {b}" for a, b in zip(first, second, strict=True)]
        if name == "negate":
            return shape, [f"-{a}" for a in first]
        if name == "table":
            return (0, 0), [f"recorded::table({first[0]}, std::array<double, {len(second)}>{{{', '.join(second)}}})"]
        if name == "norm":
            return (0, 0), [f"recorded::root_of_squares({' + '.join(f'{a} * {a}' for a in first)})"]
        if name == "select":
            cases = zip(second, values[2], strict=True)
            return shapes[1], [f"value_of({first[0]}) != 0 ? S({a}) : S({b})" for a, b in cases]
        if name in ("==", "!="):
            tests = " && ".join(f"value_of({a}) == value_of({b})" for a, b in zip(first, second, strict=True))
            return (0, 0), [f"{tests} ? {'1.0 : 0.0' if name == '==' else '0.0 : 1.0'}"]
        return (0, 0), [self._scalar(name, first[0], second[0] if second else "")]

    @staticmethod
    def _product(shapes: Any, a: list[str], b: list[str]) -> tuple[tuple[int, int], list[str]]:
        left, right = shapes
        if left == (0, 0):
            return right, [f"{a[0]} * {each}" for each in b]
        rows, inner = left if left[1] else (1, left[0])
        columns = right[1] or 1
        entries = [
            " + ".join(f"{a[i * inner + k]} * {b[k * columns + j]}" for k in range(inner))
            for i in range(rows)
            for j in range(columns)
        ]
        shape = (
            (0, 0) if not left[1] and not right[1] else (rows, columns) if left[1] and right[1] else (len(entries), 0)
        )
        return shape, entries

    @staticmethod
    def _scalar(name: str, a: str, b: str) -> str:
        value_a, value_b = f"value_of({a})", f"value_of({b})"
        if name in _FUNCTIONS:
            return f"recorded::{name}({a})"
        if name in _STEPS:
            return f"{_STEPS[name]}({value_a})"
        if name in _COMPARISONS:
            return f"{value_a} {name} {value_b} ? 1.0 : 0.0"
        formulas = {
            "/": f"{a} / {b}",
            "pow": f"recorded::pow({a}, {b})",
            "atan2": f"atan2(S({a}), S({b}))",
            "min": f"{value_a} < {value_b} ? S({a}) : S({b})",
            "max": f"{value_a} > {value_b} ? S({a}) : S({b})",
            "mod": f"{a} - recorded::truncated_quotient({value_a}, {value_b}) * {b}",
            "%": f"{a} - recorded::floored_quotient({value_a}, {value_b}) * {b}",
            "//": f"recorded::floored_quotient({value_a}, {value_b})",
            "Not": f"{value_a} == 0 ? 1.0 : 0.0",
            "isfinite": f"std::isfinite({value_a}) ? 1.0 : 0.0",
        }
        return formulas[name]


def _literal(x: float) -> str:
    return f"({x!r})" if x < 0 else repr(x)


# ---- kinds of items --------------------------------------------------------------------------------------------------
class _Kind(NamedTuple):
    """What a kernel has around the formulas."""

    arguments: dict[int, Sequence[str]]  # place of an argument of the user function -> its numbers in C++
    port: str
    frame: str
    markers: str
    prepare: tuple[str, ...]  # variables that statements and outputs read
    result: Callable[[list[str]], str]
    outputs: dict[str, tuple[int, str, str, str]]  # size, unit, doc, formula
    power: tuple[str, str]


def _vector(name: str) -> list[str]:
    return [f"{name}[{i}]" for i in range(3)]


def _list(formula: str) -> str:
    return f"const Vec3<double> w = {formula}; values.assign(w.x.begin(), w.x.end());"


_KINDS = {
    "ObjectConnectorCartesianSpringDamper": _Kind(
        {0: ["t"], 2: _vector("u"), 3: _vector("v")},
        "PointPort",
        "PointFrame",
        "Position",
        ("const Vec3<S> u = m1.position - m0.position, v = m1.velocity - m0.velocity;",),
        lambda x: f"const Vec3<S> f{{S({x[0]}), S({x[1]}), S({x[2]})}};\n    return {{Force<S>{{f}}, Force<S>{{-f}}}};",
        {
            "Displacement": (3, "m", "global vector from marker m0 to marker m1", _list("m1.position - m0.position")),
            "Velocity": (3, "m/s", "rate of Displacement", _list("m1.velocity - m0.velocity")),
            "Force": (3, "N", "global force on marker m0", _list("forces<double>(p, c, m0, m1)[0].force")),
        },
        ("Force", "Velocity"),
    ),
    "ObjectConnectorCoordinateSpringDamper": _Kind(
        {0: ["t"], 2: ["u"], 3: ["v"]},
        "ScalarPort",
        "ScalarFrame",
        "Coordinate",
        ("const S u = m1.value - m0.value, v = m1.rate - m0.rate;",),
        lambda x: f"const S f({x[0]});\n    return {{ScalarForce<S>{{f}}, ScalarForce<S>{{-f}}}};",
        {
            "Displacement": (1, "various", "difference of the coordinates", "values = {m1.value - m0.value};"),
            "Velocity": (1, "various", "rate of Displacement", "values = {m1.rate - m0.rate};"),
            "Force": (
                1,
                "various",
                "force on the coordinate of m0",
                "values = {forces<double>(p, c, m0, m1)[0].force};",
            ),
        },
        ("Force", "Velocity"),
    ),
}
_EXAMPLES = {
    "PointPort": (
        "bodies = [mbs.AddObject(ObjectGround(referencePosition=at)) for at in ([0, 0, 0], {at})]",
        "markers = [mbs.AddMarker(MarkerBodyPosition(bodyNumber=body)) for body in bodies]",
    ),
    "ScalarPort": (
        "nodes = [mbs.AddNode(NodePointGround()), mbs.AddNode(Node1D(initialCoordinates=[{at}]))]",
        "mbs.AddObject(ObjectMass1D(nodeNumber=nodes[1], physicsMass=1))",
        "markers = [mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0)) for node in nodes]",
    ),
}


def law_named(reference: str) -> Law:
    """Return the law 'module:function'."""
    module, _, name = reference.partition(":")
    try:
        found = getattr(import_module(module), name)
    except (ImportError, AttributeError, ValueError) as error:
        raise BuildError(f"{reference!r}: {error}; expected module:function, such as my_laws:Hertz") from None
    if not isinstance(found, Law):
        raise BuildError(f"{reference}: {found!r} is not a law; decorate it with dalembert.laws.connector")
    if found.states or found.history:
        raise BuildError(
            f"{reference}: kernels can be made of laws without states; write a kernel with data coordinates, as in "
            "examples/item_packages/plastic_spring, or use the law itself"
        )
    if found.item not in _KINDS:
        known = "connector('points') and connector('coordinates')"
        raise BuildError(f"{reference}: kernels can be made of laws of {known}, not of {found.item}")
    return found


def from_law(directory: Path, reference: str) -> list[str]:
    """Add an item with a law to a package, which is made if there is none; return the paths of the files written."""
    law = law_named(reference)
    name = re.sub(r"(^|_)([a-z])", lambda match: match[2].upper(), law.function.__name__)
    made = new(directory, "connector", name)
    spec = next(directory / path for path in made if path.endswith(".toml") and path.startswith("specs/"))
    kernel = next(directory / path for path in made if path.endswith(".hpp"))
    full = next(line for line in spec.read_text("utf-8").splitlines() if line.startswith("name")).split('"')[1]
    kernel.write_text(_kernel(law, full, kernel.relative_to(directory / "kernels").with_suffix("").as_posix()), "utf-8")
    spec.write_text(_spec(law, full, spec.read_text("utf-8"), reference), "utf-8")
    return made


def _kernel(law: Law, full: str, stem: str) -> str:
    kind = _KINDS[law.item]
    (recorded,) = law.recorded.values()
    formulas = _Formulas(recorded._Stored(), kind.arguments)
    frame = kind.frame
    used = " ".join([*formulas.lines, *formulas.result])
    reads_time = re.search(r"\bt\b", used) is not None
    lines = [*kind.prepare, *(["const double t = c.time;"] if reads_time else []), *formulas.lines]
    cases = [
        f"      case OutputVariableType::{name}: {{ {formula} return true; }}"
        for name, (_, _, _, formula) in kind.outputs.items()
    ]
    body = "\n    ".join(f"[[maybe_unused]] {line}" if line in kind.prepare else line for line in lines)
    return f"""// {full}, specs/{stem}.toml
#pragma once

#include "dalembert/{stem}_parameters.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/enums.hpp"
#include "dalembert/frames.hpp"
#include "dalembert/laws/recorded.hpp"

namespace dalembert {{

struct {full} : NoPairHistory, NoConnectorForms {{
  using Parameters = {full}Parameters;
  using Port = {kind.port};

  template <class S>
  static auto forces([[maybe_unused]] const Parameters& p, [[maybe_unused]] const Context& c, const {frame}<S>& m0,
                     const {frame}<S>& m1) -> std::array<typename Port::template Force<S>, 2> {{
    {body}
    {kind.result(formulas.result)}
  }}

  static bool output(const Parameters& p, const Context& c, const {frame}<double>& m0, const {frame}<double>& m1,
                     OutputVariableType variable, std::vector<double>& values) {{
    switch (variable) {{
{chr(10).join(cases)}
      default: return false;
    }}
  }}
}};

}}  // namespace dalembert
"""


def _rows(law: Law) -> Iterator[str]:
    yield 'markerNumbers = { use = "connector" }'
    for name, value in law.constants.items():
        yield f'{name} = {{ type = "Real", default = {value!r}, unit = "various", doc = "constant {name} of the law" }}'
    yield 'activeConnector = { use = "connector" }'


def _spec(law: Law, full: str, skeleton: str, reference: str) -> str:
    """Return the skeleton with the parameters, outputs and example of the law."""
    kind = _KINDS[law.item]
    size = 3 if kind.port == "PointPort" else 1
    at: Any = [0.5, 0.25, 0.125] if size == 3 else 0.5
    given: list[Any] = [None, 0.0, 0, np.array(at), np.zeros(size)] if size == 3 else [None, 0.0, 0, at, 0.0]
    unread = [np.zeros(3)] * 3 if size == 3 else [0.0] * 3
    (recorded,) = law.recorded.values()
    expected = np.round(np.ravel(recorded(*given, *unread)), 12).tolist()
    outputs = [
        f'{name} = {{ size = {n}, unit = "{unit}", from = "kernel", doc = "{doc}" }}'
        for name, (n, unit, doc, _) in kind.outputs.items()
    ]
    example = [
        *(line.format(at=at) for line in _EXAMPLES[kind.port]),
        f"connector = mbs.AddObject({full}(markerNumbers=markers))",
        "mbs.Assemble()",
        "result = mbs.GetObjectOutput(connector, exu.OutputVariableType.Force)",
    ]
    head = skeleton[: skeleton.index("[parameters]")]
    summary = (law.function.__doc__ or f"The law {law.function.__name__}").strip().splitlines()[0].rstrip(".")
    head = re.sub(r'summary = ".*"', lambda _: f'summary = "{summary}"', head)
    head = re.sub(r"requested_markers = .*", lambda _: f'requested_markers = ["{kind.markers}"]', head)
    expect = expected if size == 3 else expected[0]
    return f"""{head}[parameters]
{chr(10).join(_rows(law))}

[visualization]
use = "shown"

[outputs]
{chr(10).join(outputs)}

[scene]
power = [["{kind.power[0]}", "{kind.power[1]}"]]

[docs]
equations = '''
The force is the law ``{reference}``, which was written in Python.
'''
quantities = []
examples = []

[example]
expect = {{ value = {expect!r}, tolerance = 1e-11 }}
code = '''
{chr(10).join(example)}
'''
"""
