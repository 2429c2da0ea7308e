"""JSON Schema of model files: the format of mbs.Save(...) and mbs.Load(...), for editors and other programs."""

from __future__ import annotations

import json
from typing import Any

from codegen.model import Item, Parameter
from codegen.model_settings import Setting, SettingsGroup, Specs
from codegen.names import FOLDERS
from codegen.types import ParameterType

KINDS = tuple(dict.fromkeys(kind for kind, _ in FOLDERS.values()))
_NPZ = {"type": "object", "required": ["npz"], "properties": {"npz": {"type": "string"}}, "additionalProperties": False}
_SCALARS = {"boolean": "boolean", "text": "string", "integer": "integer", "integers": "integer", "texts": "string"}
_SHAPE = {"type": "array", "items": {"type": "integer"}}
_FUNCTION = {
    "type": "object",
    "oneOf": [{"required": ["function"]}, {"required": ["source", "name"]}, {"required": ["recorded"]}],
    "description": "a user function by 'module:name', or its code, which are read only with permission; or recorded",
}
_DEFINITIONS: dict[str, Any] = {
    "npz": _NPZ | {"description": "an array in the file beside, with the ending .npz"},
    "sparse": {
        "type": "object",
        "required": ["sparse", "shape"],
        "properties": {"sparse": {}, "shape": _SHAPE},
        "description": "a sparse matrix: entries [row, column, value], and its shape",
    },
    "function": _FUNCTION,
    "index": {"type": ["integer", "string"], "minimum": -1, "description": "number of an item, or its name; -1: none"},
}


def schema_text(specs: Specs) -> str:
    return json.dumps(_schema(specs), indent=1, ensure_ascii=False)


def definitions(specs: Specs) -> dict[str, dict[str, Any]]:
    """The schemas of single items by their names."""
    enums = _names(specs)
    return {item.name: _item(item, enums) for item in specs.items if item.ready}


def _names(specs: Specs) -> dict[str, list[str]]:
    return {enum.name: [value.name for value in enum.values] for enum in specs.enums}


def _schema(specs: Specs) -> dict[str, Any]:
    enums = _names(specs)
    simulation = next(each for each in specs.settings if each.name == "SimulationSettings")
    lists = {f"{kind}s": {"type": "array", "items": _items(specs, kind)} for kind in KINDS}
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "$comment": "Generated from specs/ by codegen/views/schema.py. Do not edit; run `python -m codegen`.",
        "title": "dalembert model",
        "type": "object",
        "required": ["format", "formatVersion"],
        "additionalProperties": False,
        "properties": {
            "$schema": {"type": "string"},
            "format": {"const": "dalembert model"},
            "formatVersion": {"const": 1},
            "package": {"type": "string", "description": "version of the package that has written the file"},
            "itemPackages": {
                "type": "array",
                "items": {"type": "string"},
                "description": "modules of packages that items are from",
            },
            **lists,
            "generalContacts": {"type": "array", "items": {"$ref": "#/$defs/generalContact"}},
            "functions": {"type": "object", "description": "user functions of the system"},
            "variables": {"type": "object", "description": "mbs.variables"},
            "settings": _group(simulation.root, enums),
        },
        "$defs": _DEFINITIONS | {"generalContact": _general_contact()} | definitions(specs),
    }


def _columns(description: str, **kinds: dict[str, Any]) -> dict[str, Any]:
    """Numbers of several things, in columns of one length."""
    columns = {
        name: {"oneOf": [{"type": "array", "items": kind}, {"$ref": "#/$defs/npz"}]} for name, kind in kinds.items()
    }
    return {
        "type": "object",
        "description": description,
        "required": list(kinds),
        "additionalProperties": False,
        "properties": columns,
    }


def _general_contact() -> dict[str, Any]:
    """Columns and settings by the names of the arguments and attributes that bring them."""
    index, whole = {"$ref": "#/$defs/index"}, {"type": "integer", "minimum": 0}
    positive, not_negative = {"type": "number", "exclusiveMinimum": 0}, {"type": "number", "minimum": 0}
    surface = {"contactStiffness": positive, "contactDamping": not_negative, "frictionMaterialIndex": whole}
    number = {axis: {"type": "number"} for axis in "xyz"}
    of_points = dict.fromkeys("xyz", whole)
    plane = {kind + axis: {"type": "number"} for kind in ("normal", "point") for axis in "XYZ"}
    groups = {
        "spheres": _columns("spheres at markers", markerIndex=index, radius=positive, **surface),
        "cables": _columns("elements of planar cables", objectIndex=index, halfHeight=not_negative, **surface),
        "triangleBodies": _columns("markers whose frames carry triangles", rigidBodyMarkerIndex=index, **surface),
        "triangles": _columns(
            "corners of triangles in the frames of triangleBodies",
            contactRigidBodyIndex=whole,
            points=_array((3, 3), "number"),
        ),
        "convexShapes": _columns(
            "convex shapes: kinds (0: polytope, 1: capsule, 2: cylinder), numbers of convexPoints and convexTriangles",
            markerIndex=index,
            kind={"type": "integer", "minimum": 0, "maximum": 2},
            radius=not_negative,
            points=whole,
            triangles=whole,
            **surface,
        ),
        "convexPoints": _columns("corners of polytopes, or ends of axes, in the frames of their markers", **number),
        "convexTriangles": _columns(
            "corners of triangles, by their numbers among the points of the shape", **of_points
        ),
        "planes": _columns(
            "planes in the frames of markers: normals and points", rigidBodyMarkerIndex=index, **plane, **surface
        ),
    }
    flags = (
        "isActive sphereSphereContact sphereSphereFrictionRecycle excludeOverlappingTrigSphereContacts "
        "excludeDuplicatedTrigSphereContactPoints computeExactStaticTriangleBins computeContactForces "
        "ancfCableUseExactMethod"
    )
    counts = (
        "verboseMode resetSearchTreeInterval ancfCableNumberOfContactSegments ancfCableMeasuringSegments "
        "parallelTaskSplit parallelTaskSplitBoundingBoxes parallelTaskSplitThreshold "
        "parallelTaskSplitBoundingBoxesThreshold"
    )
    pairings = _array((None, None), "number") | {"description": "coefficients of friction of pairs of materials"}
    settings = {
        "frictionPairings": pairings,
        "frictionProportionalZone": positive | {"description": "slip up to which friction grows with it (m/s)"},
        "frictionBristles": _array((3,), "number")
        | {"description": "tangential springs: ratios of stiffness, of damping, and of static to sliding friction"},
        "minRelDistanceSpheresTriangles": not_negative,
        "searchTreeSize": _array((3,), "integer"),
        "searchTreeBox": _array((6,), "number"),
        **{name: {"type": "boolean"} for name in flags.split()},
        **{name: {"type": "integer"} for name in counts.split()},
    }
    return {
        "type": "object",
        "description": "contact of spheres and convex shapes with each other, with triangles, planes and planar cables",
        "additionalProperties": False,
        "properties": groups | settings,
    }


def _items(specs: Specs, kind: str) -> dict[str, Any]:
    """Return the schema of items by type, so that errors refer to the right type."""
    names = [item.name for item in specs.items if item.kind == kind and item.ready]
    choice = [{"if": {"properties": {"type": {"const": name}}}, "then": {"$ref": f"#/$defs/{name}"}} for name in names]
    return {"type": "object", "required": ["type"], "properties": {"type": {"enum": names}}, "allOf": choice}


def _item(item: Item, enums: dict[str, list[str]]) -> dict[str, Any]:
    visualization = {name: _row(row, enums) for row in item.visualization for name in (row.name, *row.aliases)}
    return {
        "type": "object",
        "description": item.summary,
        "required": ["type"],
        "additionalProperties": False,
        "properties": {
            "type": {"const": item.name},
            **{
                name: _row(row, enums)
                for row in item.parameters
                if not row.internal
                for name in (row.name, *row.aliases)
            },
            **{each.name: {"type": "array"} for each in item.transformations},
            "visualization": {"type": "object", "additionalProperties": False, "properties": visualization},
        },
    }


def _group(group: SettingsGroup, enums: dict[str, list[str]]) -> dict[str, Any]:
    rows = {row.name: _row(row, enums) for row in group.rows}
    return {
        "type": "object",
        "description": group.summary,
        "additionalProperties": False,
        "properties": rows | {child.name: _group(child, enums) for child in group.children},
    }


def _row(row: Parameter, enums: dict[str, list[str]]) -> dict[str, Any]:
    described = {"description": " ".join(row.doc.split()) + (f" ({row.unit})" if row.unit not in ("", "1") else "")}
    default = {} if row.default in (None, "invalid") else {"default": row.default}
    return described | default | _type(row, row.type, enums)


def _type(row: Parameter, type_: ParameterType, enums: dict[str, list[str]]) -> dict[str, Any]:
    storage = type_.storage
    if type_.function or type_.name.endswith("UserFunction") or type_.name == "PyFunctionGraphicsData":
        return {"oneOf": [{"const": 0}, {"$ref": "#/$defs/function"}]}
    if type_.index:
        index = {"$ref": "#/$defs/index"}
        return {"type": "array", "items": index} if type_.shape else index
    if storage == "joint_types":
        return {"type": "array", "items": {"enum": enums["JointType"]}}
    if type_.name in enums:
        return {"enum": enums[type_.name]}
    if storage in ("matrix_container", "matrix", "integer_matrix"):
        rows = {"type": "array", "items": {"type": "array", "items": {"type": "number"}}}
        sparse = [{"$ref": "#/$defs/sparse"}] if storage == "matrix_container" else []
        empty = {"type": "object", "required": ["array", "shape"]}
        return {"oneOf": [{"type": "null"}, rows, {"$ref": "#/$defs/npz"}, empty, *sparse]}
    if type_.opaque or storage == "beam_section":
        return {}
    scalar = _SCALARS.get(storage, "number")
    if not type_.shape:
        bounds = _bounds(row) if scalar in ("number", "integer") else {}
        number = {"type": scalar} | bounds
        return number if row.named == "no" else {"oneOf": [number, {"type": "string"}]}
    array = _array(row.shape, scalar)
    return {"oneOf": [array, {"$ref": "#/$defs/npz"}]} if None in row.shape else array


def _array(shape: tuple[int | None, ...], scalar: str) -> dict[str, Any]:
    if not shape:
        return {"type": scalar}
    sizes = {} if shape[0] is None else {"minItems": shape[0], "maxItems": shape[0]}
    return {"type": "array", "items": _array(shape[1:], scalar)} | sizes


def _bounds(row: Parameter) -> dict[str, Any]:
    if isinstance(row, Setting) and row.range:
        sides = {"lower": ("minimum", "exclusiveMinimum"), "upper": ("maximum", "exclusiveMaximum")}
        found = {}
        for side, words in sides.items():
            if abs(bound := getattr(row.range, side)) != float("inf"):
                found[words[getattr(row.range, f"{side}_open")]] = bound
        return found
    below = row.default is not None and row.default != "invalid" and row.default <= 0  # a default may say 'not set'
    checks = {"positive": {} if below else {"exclusiveMinimum": 0}, "non_negative": {"minimum": 0}}
    return checks.get(row.effective_check, {})
