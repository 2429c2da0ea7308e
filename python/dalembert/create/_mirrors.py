"""Data that Create functions inherit from the items of their parameters: checks, types, units and texts.

A Create function mirrors the parameters of items, and of their visualization, by their names; specs/ defines the items
and their parameters. Other arguments are described here, or by TEXTS of the function's module if the meaning is
specific
to it.
"""

from __future__ import annotations

import inspect
import re
import sys
from collections.abc import Callable
from enum import Enum
from functools import cache
from textwrap import indent
from typing import Any, NamedTuple

import numpy as np

from dalembert import itemInterface as items
from dalembert._core import _parameters_of
from dalembert._create_table import MIRRORS
from dalembert.create._arguments import (
    ANYTHING,
    FLAG,
    NOT_NEGATIVE,
    NUMBER,
    POSITIVE,
    TEXT,
    Check,
    color,
    matrix,
    rotation_matrix,
    unit_vector,
    vector,
)
from dalembert.create._examples import EXAMPLES


class Row(NamedTuple):
    """A parameter of an item: `facts` are check and unit in words, `aliases` its further names."""

    name: str
    type: str
    check: str
    facts: str
    text: str
    aliases: tuple[str, ...] = ()


# Arguments that have another name than the parameter.
RENAMED = {"axisVector": "discAxis", "graphicsDataList": "graphicsData"}
# Further names of arguments that are not parameters of an item, and of parameters in Create functions only.
OTHER_NAMES = {"bodyNumbers": "itemNumbers", "bodyNumber": "itemNumber", "radiusSphere": "sphereRadius"}
# Arguments that are not parameters of an item.
TEXTS = {
    "referencePosition": "position in the reference configuration, in the global frame (m)",
    "referenceRotationMatrix": "rotation in the reference configuration, from local to global axes",
    "initialDisplacement": "displacement at the start, from the reference position, in the global frame (m)",
    "initialVelocity": "velocity at the start, in the global frame (m/s)",
    "initialAngularVelocity": "angular velocity at the start, in the global frame (rad/s)",
    "initialRotationMatrix": "rotation at the start, from the right of the reference rotation; in 2D the total one",
    "inertia": "mass, centre of mass and inertia, such as InertiaCuboid(...)",
    "referenceHT": "reference position and rotation as exu.HT or 4 x 4 matrix, in place of the two arguments",
    "initialHT": "initial displacement and rotation, from the reference, as exu.HT or 4 x 4 matrix",
    "gravity": "acceleration of gravity (m/s^2); bodies on nodes get a load with their weight",
    "nodeType": "how rotations are described by coordinates",
    "create2D": "True: a body in the xy plane",
    "returnDict": "True: returns a dictionary with the numbers of all items that were added",
    "bodyNumbers": "the two bodies, nodes or markers that are joined, by their indices or names",
    "bodyOrNodeList": "former name of bodyNumbers, where nodes are given",
    "bodyList": "deprecated: use bodyNumbers",
    "bodyNumber": "body, or marker, on which the load acts, by its index or name",
    "localPosition": "point of action in the frame of the body (m)",
    "localPosition0": "point on the first body, in its frame (m)",
    "localPosition1": "point on the second body, in its frame (m)",
    "position": "position of the joint in the reference configuration (m), see useGlobalFrame; [] if a marker sets it",
    "axis": "axis of the joint in the reference configuration, of any length, see useGlobalFrame",
    "axis0": "pin of the cross in the first body, of any length, see useGlobalFrame",
    "axis1": "pin of the cross in the second body, perpendicular to axis0",
    "rotationMatrixJoint": "axes of the joint as columns, see useGlobalFrame",
    "rotationMatrixAxes": "axes of the joint as columns, see useGlobalFrame",
    "femInterface": "mesh with matrices and modes, a FEMinterface",
    "massProportionalDamping": "factor of the mass matrix in the damping matrix of the modes (1/s)",
    "stiffnessProportionalDamping": "factor of the stiffness matrix in the damping matrix of the modes (s)",
    "superElementRigidMarkersOffsets": "offset of each marker from the mean of its nodes, in the frame of the body (m)",
    "showMarkers": "True: markers are drawn",
    "verbose": "True: markers are printed",
    "listOfTreeLinks": "links from the base on; without parents, each link hangs on the one before",
    "jointRadius": "radius of drawn joints (m)",
    "jointWidth": "width of drawn joints and links (m)",
    "linkRoundness": "roundness of drawn links, from 0, a block, to 1, a cylinder",
    "colors": "RGBA color of all links, or a list with one for each",
    "colorsJoints": "RGBA color of all joints, or a list with one for each",
    "baseGraphicsDataList": "graphics of the base",
    "useGlobalFrame": "True: given in the global frame; False: in the frame of the first body",
    "unlimitedRotations": "True: adds a data node that counts turns",
    "coordinates": "index of the coordinate of each body, counted over its nodes; None for ground",
    "axisPosition": "centre of the disc in the frame of its body (m)",
    "quadPoints": "four points, one after the other around the quadrangle, in the frame of the second body (m)",
    "dataInitialCoordinates": "data at the start: gap, tangential speed, impact velocity and plastic overlap",
    "planePosition": "point of the plane in the frame of its body (m)",
}
# Requirements on arguments that neither an item nor a check defines.
TYPES = {
    "bodyNumber": "ObjectIndex, MarkerIndex or name",
    "position": "3 numbers",
    "section": "outline of a section",
    "referenceHT": "HT or 4 x 4 matrix",
    "initialHT": "HT or 4 x 4 matrix",
    "quadPoints": "4 points of 3 numbers",
    "superElementRigidMarkersOffsets": "list of 3 numbers each",
    "colors": "4 numbers, or a list of them",
    "colorsJoints": "4 numbers, or a list of them",
    "baseGraphicsDataList": "list of graphics data",
    "rigidBodyMarkerIndex": "MarkerIndex or name",
    "baseMarker": "MarkerIndex or name",
    "fileName": "str or Path",
    "packages": "str, Path, list or dict",
    "referenceConfiguration": "a number per joint",
    "forceUserFunction": "function, controller or 0",
}
_VECTOR, _MATRIX = re.compile(r"(\d+) numbers"), re.compile(r"(\d+) x \1 numbers")
_VECTORS = {"unit_vector": unit_vector, "color": color}
_NUMBERS = {"": NUMBER, "non_negative": NOT_NEGATIVE, "positive": POSITIVE}


@cache
def _rows(name: str) -> tuple[Row, ...]:
    """Return the parameters of an item, and of its visualization."""
    return tuple(Row(*row) for prefix in ("", "V") for row in _parameters_of(getattr(items, prefix + name)))


@cache
def parameters(function: Callable[..., Any]) -> dict[str, inspect.Parameter]:
    """Return the parameters of a function by their names."""
    return dict(inspect.signature(function).parameters)


def of_module(function: Callable[..., Any], table: str) -> dict[str, Any]:
    """Return the entries of a table of the function's module, such as CHECKS, for its arguments."""
    tables = vars(sys.modules[function.__module__])  # getattr would search all modules for a hint on a missing name
    found: dict[str, Any] = tables.get(table, {}).get(function.__name__, {})
    return found


def texts(function: Callable[..., Any]) -> dict[str, str]:
    """Return the descriptions of arguments that are no parameters of items."""
    return TEXTS | of_module(function, "TEXTS")


@cache
def mirrored(function: Callable[..., Any]) -> dict[str, Row]:
    """Return the parameters of items that arguments of the function stand for."""
    rows: dict[str, Row] = {}
    for row in (row for name in MIRRORS.get(function.__name__, ()) for row in _rows(name)):
        rows.setdefault(row.name, row)
    names = {name: RENAMED.get(name, name) for name in parameters(function)}
    described = texts(function)
    return {name: rows[row] for name, row in names.items() if row in rows and name not in described}


def other_names(function: Callable[..., Any]) -> dict[str, str]:
    """Return the further names of arguments: those of Create functions, and those of the parameters of items."""
    own = {OTHER_NAMES[name]: name for name in parameters(function) if name in OTHER_NAMES}
    return own | {alias: name for name, row in mirrored(function).items() for alias in row.aliases}


def check_of(row: Row) -> Check:
    """Return the check for values of a parameter; the item checks parameters without a simple check."""
    if row.type == "float":
        return _NUMBERS[row.check]
    if row.type == "bool":
        return FLAG
    if row.type == "str":
        return TEXT
    if match := _VECTOR.fullmatch(row.type):
        return _VECTORS[row.check]() if row.check in _VECTORS else vector(int(match[1]))
    if match := _MATRIX.fullmatch(row.type):
        return rotation_matrix() if row.check in ("rotation", "orthogonal") else matrix(int(match[1]))
    return ANYTHING


def checks_of(function: Callable[..., Any]) -> dict[str, Check]:
    """Return the checks of the arguments that are parameters; None is accepted if it is the default."""
    known = parameters(function)
    checks = {name: check_of(row) for name, row in mirrored(function).items()}
    return {name: check.optional() if known[name].default is None else check for name, check in checks.items()}


def _literal(value: Any) -> str:
    """Return how a default is written in a model; nothing, where a value has to be given."""
    if value is inspect.Parameter.empty:
        return ""
    if isinstance(value, np.ndarray):
        rows, columns = value.shape
        return f"np.eye({rows})" if value.any() else f"np.zeros(({rows}, {columns}))"
    if isinstance(value, list) and any(isinstance(entry, np.ndarray) for entry in value):
        return repr([entry.tolist() for entry in value])
    return str(value) if isinstance(value, Enum) else repr(value)


def _type_of(parameter: inspect.Parameter, check: Check | None) -> str:
    """Return the description of an argument that is not an item parameter."""
    if check is not None:
        return check.expected.removesuffix(" or None")
    if parameter.name in TYPES:
        return TYPES[parameter.name]
    if parameter.default in (None, inspect.Parameter.empty):
        return str(parameter.annotation).removesuffix(" | None")
    return type(parameter.default).__name__


class Argument(NamedTuple):
    """An argument of a Create function in words; `facts` are check and unit."""

    name: str
    type: str
    default: str
    facts: str
    text: str


def arguments(function: Callable[..., Any], checks: dict[str, Check]) -> list[Argument]:
    """Return the descriptions of the arguments of a Create function, after mbs."""
    rows, described, found = mirrored(function), texts(function), []
    for name, parameter in list(parameters(function).items())[1:]:
        row = rows.get(name)
        kind = row.type if row else _type_of(parameter, checks.get(name))
        text, facts = (row.text, row.facts) if row else (described[name], "")
        found.append(Argument(name, kind, _literal(parameter.default), facts, text))
    return found


def documentation(function: Callable[..., Any], checks: dict[str, Check]) -> str:
    """Return the docstring of a Create function with a list of its arguments and an example."""
    told = arguments(function, checks)
    values = [f" = {a.default}" if a.default else ", required" for a in told]
    own = {name: f"; also named {OTHER_NAMES[name]}" for name in parameters(function) if name in OTHER_NAMES}
    lines = [
        f"    {a.name}: {a.type}{v}{a.facts}{own.get(a.name, '')}\n        {a.text}"
        for a, v in zip(told, values, strict=True)
    ]
    example = indent(EXAMPLES[function.__name__].strip(), "    ")
    return "\n".join((f"{inspect.getdoc(function)}\n\nArguments:", *lines, f"\nExample:\n{example}\n"))
