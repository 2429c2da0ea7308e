"""The specs agree with the reference: same items, rows, order, types, defaults, outputs, enumerations and settings."""

from __future__ import annotations

import ast
import json
import struct
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from plain_latex import plain_latex

from codegen.model import Item, Parameter
from codegen.model_settings import SettingsGroup, Specs

DATA = Path(__file__).parents[1] / "data/reference"
REFERENCE = {item["name"]: item for item in json.loads((DATA / "items.json").read_text())}

# Type names: the documentation repeats or misspells them, dictionaries of items use these (a type name names one item).
TYPE_NAMES = {
    "ObjectANCFBeam": "ANCFBeam",
    "ObjectBeamGeometricallyExact": "BeamGeometricallyExact",
    "ObjectConnectorHydraulicActuatorSimple": "ConnectorHydraulicActuatorSimple",
    "ObjectContactSphereTorus": "ContactSphereTorus",
    "ObjectContactSphereTriangle": "ContactSphereTriangle",
    "MarkerBodiesRelativeRotationCoordinate": "BodiesRelativeRotationCoordinate",
}
# Signatures that the documentation states wrongly: the type of the parameter says how many numbers are passed.
SIGNATURES = {
    ("ObjectConnectorCoordinateSpringDamper", "springForceUserFunction"): [
        "mbs", "t", "itemNumber", "displacement", "velocity", "stiffness", "damping", "offset",
    ],
}  # fmt: skip
# Symbols that contradict the description, or the notation of other items: wrong part, and its correction.
LOCAL, TURNED = r"\LU{0b}{\Rot}\pLocB", r"(\LU{0b}{\Rot}\cConfig - \LU{0b}{\Rot}\cRef) \pLocB"
MISPRINTS = {
    **{(f"NodePointSlope{n}", "Velocity"): (r"{\mathbf{a}}", r"{\mathbf{v}}") for n in ("1", "12", "23")},
    **{(f"ObjectRigidBody{n}", "Displacement"): (LOCAL, TURNED) for n in ("", "2D")},
    **{(f"ObjectRigidBody{n}", "Velocity"): (r"\pLocB\cConfig)", r"\pLocB)") for n in ("", "2D")},
    **{("ObjectANCFCable2D", f"Angular{n}"): (r"[0,\, ,0,", r"[0,\, 0,") for n in ("Velocity", "Acceleration")},
    ("ObjectANCFCable", "Position"): (r" + y\cdot {\mathbf{n}}\cConfig(x)", ""),
    **{
        ("ObjectContactFrictionCircleCable2D", name): ("n_{cs}}", "n_{cs}-1}")
        for name in ("Coordinates", "Coordinates_t", "ForceLocal")
    },
    ("ObjectConnectorRollingDiscPenalty", "ForceLocal"): (
        r"\LU{0}{[f_{t,x},\, f_{t,y},\, f_{n}]\tp}",
        r"[f_{t,x},\, f_{t,y},\, f_{n}]\tp",
    ),
    ("ObjectJointRollingDisc", "ForceLocal"): (
        r"\LU{0}{[f_0,\, f_1,\, f_2]\tp}= [-{\mathbf{z}}^T \LU{0}{{\mathbf{w}}_{lat}}, \, "
        r"-{\mathbf{z}}^T \LU{0}{{\mathbf{w}}_2}, \, -{\mathbf{z}}^T \LU{0}{{\mathbf{v}}_{PN}}]\tp",
        r"[f_0,\, f_1,\, f_2]\tp = -[\lambda_0,\, \lambda_1,\, \lambda_2]\tp",
    ),
}
# Orientation is asked for where there is friction, as models of the reference have it; the kernels see to that.
REQUESTED = {"ObjectContactSphereSphere": ["Position"], "ObjectContactSphereTriangle": ["Position"]}
# Sizes that contradict the type or the symbol of the row: six numbers, said to be three; markers of any number of
# circles.
WRONG_SIZES = {"Vector6D": "3", "ArrayMarkerIndex": "2"}
KINDS = {"Node": "node", "Object": "object", "Marker": "marker", "Load": "load", "Sensor": "sensor"}


@pytest.fixture(scope="module")
def items(specs: Specs) -> dict[str, Item]:
    return {item.name: item for item in specs.items}


def differences(items: Iterable[Item]) -> dict[str, set[str]]:
    """Differences between the specs and the reference: missing items, and additional ones without a description of the
    addition."""
    names = {item.name for item in items if item.beyond_reference is None}
    return {"missing": REFERENCE.keys() - names, "without `beyond_reference`": names - REFERENCE.keys()}


def test_the_items_are_those_of_the_reference(items: dict[str, Item]) -> None:
    assert differences(items.values()) == {"missing": set(), "without `beyond_reference`": set()}


def test_items_beyond_the_reference_describe_their_addition(items: dict[str, Item]) -> None:
    of_reference = items["ObjectMassPoint"]
    silent = replace(of_reference, name="ObjectMass", path="specs/bodies/mass.toml")
    told = replace(silent, beyond_reference="a mass without a place")
    assert differences([*items.values(), told]) == differences(items.values())
    assert differences([*items.values(), silent])["without `beyond_reference`"] == {"ObjectMass"}
    denied = items | {"ObjectMassPoint": replace(of_reference, beyond_reference="says to be none of the reference")}
    assert differences(denied.values())["missing"] == {"ObjectMassPoint"}


@pytest.mark.parametrize("name", REFERENCE)
def test_item(items: dict[str, Item], name: str) -> None:
    item, fact = items[name], REFERENCE[name]
    assert item.kind == KINDS[fact["kind"]]
    assert item.object_type == fact["object_type"]
    assert item.type_name == TYPE_NAMES.get(name, fact["type_name"])
    assert list(item.short_names) == fact["short_names"]
    assert list(item.provides) == fact["provides"]
    assert list(item.requested_nodes) == fact["requested_node"]
    requested = [word for word in fact["requested_marker"] if word != "_None"]
    assert list(item.requested_markers) == REQUESTED.get(name, requested)


@pytest.mark.parametrize("table", ["parameters", "visualization"])
@pytest.mark.parametrize("name", REFERENCE)
def test_rows(items: dict[str, Item], name: str, table: str) -> None:
    rows = [row for row in getattr(items[name], table) if not row.beyond_reference]
    facts = REFERENCE[name][table]
    assert [row.name for row in rows] == [fact["name"] for fact in facts]
    for row, fact in zip(rows, facts, strict=True):
        assert row.type.name == {"bool": "Bool"}.get(fact["type"], fact["type"])
        assert row.optional == fact["optional"], row.name
        assert row.internal == (table == "parameters" and "python_default" not in fact), row.name
        assert fact["size"] in ("", WRONG_SIZES.get(row.type.name), str((row.shape or ("",))[0])), row.name
        if fact.get("symbol"):
            assert row.symbol == plain_latex(fact["symbol"]), row.name
        assert default_of(row) == expected_default(row, fact), row.name


def default_of(row: Parameter) -> Any:
    """The default as Python sees it; empty or unset values are None."""
    if row.default == "invalid":
        return -1
    return None if row.default in ([], None) or set(flat(row.default)) == {-1} and row.type.index else row.default


def expected_default(row: Parameter, fact: dict[str, Any]) -> Any:
    if row.type.complete:
        return None
    if row.type.storage == "output_variable":
        return "_None" if "_None" in fact["default"] else fact["default"]
    if "python_default" in fact:
        value = fact["python_default"]
    else:
        text = fact["default"].strip()
        value = [] if text in ("Matrix[]", "MatrixI[]") else ast.literal_eval(text)
    return None if value == [] else value


def flat(value: Any) -> list[Any]:
    return [entry for row in value for entry in flat(row)] if isinstance(value, list) else [value]


@pytest.mark.parametrize("name", REFERENCE)
def test_outputs(items: dict[str, Item], name: str) -> None:
    facts = REFERENCE[name]["output_variables"]
    outputs = [output for output in items[name].outputs if not output.beyond_reference]
    assert [output.name for output in outputs] == [fact["name"] for fact in facts]
    for output, fact in zip(outputs, facts, strict=True):
        if fact["symbol"]:
            wrong, right = MISPRINTS.get((name, output.name), ("", ""))
            assert wrong in fact["symbol"]
            assert output.symbol == plain_latex(fact["symbol"].replace(wrong, right)), output.name


@pytest.mark.parametrize("name", [name for name, fact in REFERENCE.items() if fact["user_functions"]])
def test_user_functions(items: dict[str, Item], name: str) -> None:
    functions = {function.name: function for function in items[name].user_functions}
    for text in REFERENCE[name]["user_functions"]:
        function, arguments = text.rstrip(")").split("(")
        words = [argument.split()[-1].replace("itemIndex", "itemNumber") for argument in arguments.split(",")]
        assert list(functions[function].argument_names) == SIGNATURES.get((name, function), words)


def test_enumerations(specs: Specs) -> None:
    values = {enum.name: {v.name: v.value for v in enum.values if v.beyond_reference is None} for enum in specs.enums}
    assert values == json.loads((DATA / "enums.json").read_text())


@pytest.mark.parametrize("stem", ["simulation_settings", "visualization_settings"])
def test_settings(specs: Specs, stem: str) -> None:
    facts = json.loads((DATA / f"{stem}.json").read_text())
    settings = next(s for s in specs.settings if s.stem == stem)
    rows = dict(all_rows(settings.root))
    assert sorted(rows) == sorted(facts)
    for path, fact in facts.items():
        row = rows[path]
        assert setting_kind(row) == fact["type"], path
        value = ast.literal_eval(fact["default"]) if fact["type"] == "list" else fact["default"]
        expected = value.split(".")[-1] if row.type.storage in ("enumeration", "output_variable") else value
        assert (single(row.default) if row.type.single else row.default) == expected, path


def all_rows(group: SettingsGroup) -> list[tuple[str, Parameter]]:
    """The settings that the reference has as well."""
    groups = [(path, each) for path, each in group.walk() if each.beyond_reference is None]
    return [
        (f"{path}.{row.name}".lstrip("."), row)
        for path, each in groups
        for row in each.rows
        if not row.beyond_reference
    ]


def setting_kind(row: Parameter) -> str:
    """The type as the dump of the reference names it."""
    if row.type.shape:
        return "list"
    return row.type.python


def single(value: Any) -> Any:
    """The value after a way through single precision."""
    if isinstance(value, list):
        return [single(entry) for entry in value]
    return struct.unpack("f", struct.pack("f", value))[0]
