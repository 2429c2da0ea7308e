"""Names of later releases of Exudyn: specs and functions know them beside the ones of 1.11, in every place."""

from __future__ import annotations

import inspect
import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import dalembert as exu
from codegen.load import load
from codegen.model import Item
from dalembert import create
from dalembert.create._mirrors import other_names

ROOT = Path(__file__).parents[2]
NAMES = json.loads((ROOT / "tests/data/reference/later_names.json").read_text())
PAIRS = [(item, new, old) for item, names in NAMES["items"].items() for new, old in names.items()]
KINDS = ("Node", "Object", "Marker", "Load", "Sensor")


@pytest.fixture(scope="module")
def items() -> dict[str, Item]:
    return {item.name: item for item in load(ROOT).items}


@pytest.fixture
def mbs() -> exu.MainSystem:
    return exu.SystemContainer().AddSystem()


def test_specs_have_the_later_names_of_parameters(items: dict[str, Item]) -> None:
    found = {(item.name, alias, row.name) for item in items.values() for row in item.rows for alias in row.aliases}
    assert found == set(PAIRS)


def test_specs_have_the_later_output_variables(items: dict[str, Item]) -> None:
    declared = {name: {output.name for output in item.outputs} for name, item in items.items()}
    missing = {name: set(wanted) - declared[name] for name, wanted in NAMES["outputs"].items()}
    rolling = ("ObjectConnectorRollingDiscPenalty", "ObjectJointRollingDisc")  # the axes of contact are left-handed
    assert {name: lack for name, lack in missing.items() if lack} == {n: {"HomogeneousTransformation"} for n in rolling}


def test_values_of_later_output_variables() -> None:
    values = {f"OutputVariableType.{value.name}": value.value for value in exu.OutputVariableType}
    wanted = {name: value for name, value in NAMES["enum values"].items() if name.startswith("OutputVariableType")}
    assert {name: values.get(name) for name in wanted} == wanted


@pytest.mark.parametrize("path", NAMES["settings"])
def test_later_names_of_settings_are_accepted(path: str) -> None:
    settings: Any = exu.SimulationSettings()
    *groups, name = path.split(".")
    for group in groups:
        settings = getattr(settings, group)
    value = getattr(settings, name)
    setattr(settings, name, value)
    assert getattr(settings, name) == value


@pytest.mark.parametrize(
    ("function", "new", "old"), [(f, n, o) for f, a in NAMES["arguments"].items() for n, o in a.items()]
)
def test_create_functions_accept_the_later_names(function: str, new: str, old: str) -> None:
    method = create.functions[function]
    original = inspect.unwrap(method)
    assert other_names(original)[new] == old
    assert f"also named {new}" in (method.__doc__ or "")
    mbs = exu.SystemContainer().AddSystem()
    texts = []
    for name in (new, old):  # a value that no function accepts: both names reach the same check
        with pytest.raises((TypeError, ValueError)) as caught:
            method(mbs, **{name: object()})
        texts.append(str(caught.value).replace(repr(name), "'*'"))
    assert "unknown argument" not in texts[0]
    with pytest.raises(TypeError, match=f"argument '{old}' is given twice, also by its name '{new}'"):
        method(mbs, **{new: None, old: None})


def test_a_model_of_create_functions_with_later_names(mbs: exu.MainSystem) -> None:
    ground = mbs.CreateGround()
    mass = mbs.CreateMassPoint(mass=3, referencePosition=[1, 0, 0])
    spring = mbs.CreateSpringDamper(itemNumbers=[ground, mass], stiffness=12)
    mbs.CreateForce(itemNumber=mass, loadVector=[1, 0, 0])
    assert mbs.GetObjectParameter(mass, "physicsMass") == 3
    assert mbs.GetObjectParameter(spring, "referenceLength") == 1
    assert mbs.systemData.NumberOfLoads() == 1


@pytest.mark.parametrize(("name", "new", "old"), PAIRS)
def test_every_way_to_name_a_parameter(mbs: exu.MainSystem, name: str, new: str, old: str) -> None:
    cls = getattr(exu, name)
    default = getattr(cls(), old)
    value = _other(default)
    by_keyword, by_attribute = cls(**{new: value}), cls()
    setattr(by_attribute, new, value)
    assert by_keyword == by_attribute == cls(**{old: value}) != cls()
    assert np.array_equal(getattr(by_keyword, new), getattr(by_keyword, old))
    kind = next(kind for kind in KINDS if name.startswith(kind))
    entry = next(iter(dict(cls()).items()))
    number = getattr(mbs, f"Add{kind}")(dict([entry]) | {new: value})
    assert _same(getattr(mbs, f"Get{kind}Parameter")(number, new), value)
    assert _same(getattr(mbs, f"Get{kind}Parameter")(number, old), value)
    getattr(mbs, f"Set{kind}Parameter")(number, new, default)
    assert _same(getattr(mbs, f"Get{kind}Parameter")(number, old), default)
    getattr(mbs, f"Modify{kind}")(number, {new: value})
    content = getattr(mbs, f"Get{kind}")(number)
    assert _same(content[old], value)
    assert new not in content  # GetObject has the names of the reference pages
    assert new in dir(cls())
    assert f"also named {new}" in (cls.__doc__ or "")
    with pytest.raises(TypeError, match=f"{name}, parameter '{old}': given twice, by two of its names"):
        cls(**{new: value, old: value})
    with pytest.raises(TypeError, match=re.escape(f"there is no parameter '{new}x'. Did you mean '{new}'?")):
        cls(**{f"{new}x": value})


def _other(value: Any) -> Any:
    if isinstance(value, bool):
        return not value
    if isinstance(value, (int, float)):
        return 0.5
    array = np.array(value, dtype=float)
    if array.size == 0:
        return [0.25] if array.ndim == 1 and type(value) is np.ndarray else [np.eye(3)]
    return array + 0.125


def _same(a: Any, b: Any) -> bool:
    if hasattr(a, "GetPythonObject") or hasattr(b, "GetPythonObject"):
        return len(a) == len(b) and all(np.array_equal(x, y) for x, y in zip(a, b, strict=True))
    return np.array_equal(np.asarray(a), np.asarray(b))


def test_the_last_of_two_names_in_a_dictionary_counts(mbs: exu.MainSystem) -> None:
    """What GetObject returned, changed by the later name, is the changed item."""
    node = mbs.AddNode(exu.NodePoint())
    body = mbs.AddObject(exu.MassPoint(nodeNumber=node, mass=3))
    content = mbs.GetObject(body)
    content["mass"] = 5
    mbs.ModifyObject(body, content)
    assert mbs.GetObjectParameter(body, "physicsMass") == 5


def test_an_unknown_entry_of_a_dictionary_is_an_error(mbs: exu.MainSystem) -> None:
    node = mbs.AddNode(exu.NodePoint())
    text = "mbs.AddObject(...): ObjectMassPoint: there is no parameter 'masss'. Did you mean 'mass'?"
    with pytest.raises(exu.ModelError, match=re.escape(text)):
        mbs.AddObject({"objectType": "MassPoint", "masss": 3, "nodeNumber": node})
    assert mbs.systemData.NumberOfObjects() == 0


def test_variations_and_model_files_take_the_later_names(mbs: exu.MainSystem, tmp_path: Path) -> None:
    body = mbs.CreateMassPoint(mass=1, initialVelocity=[0, 0, 0], gravity=[0, 0, 0])
    mbs.CreateForce(itemNumber=body, loadVector=[2, 0, 0])
    mbs.AddSensor(exu.SensorBody(bodyNumber=body, outputVariableType=exu.OutputVariableType.Velocity))
    mbs.Assemble()
    results = mbs.SolveVariations({(body, "mass"): [1.0, 4.0]})
    # F t/m at t = 1 is exact for a constant force
    assert np.allclose(results.sensorValues[:, 0], [2, 0.5], rtol=0, atol=1e-9)
    file = tmp_path / "model.json"
    mbs.Save(file)
    text = file.read_text()
    assert '"physicsMass": 1' in text
    file.write_text(text.replace('"physicsMass": 1', '"mass": 7'))
    mbs.Load(file)
    assert mbs.GetObjectParameter(0, "mass") == 7
    file.write_text(text.replace('"physicsMass": 1', '"mass": 7, "physicsMass": 1'))
    with pytest.raises(exu.ModelFileError, match=r"the parameter physicsMass is given twice, by two of its names"):
        mbs.Load(file)


def test_the_schema_has_both_names() -> None:
    schema = json.loads((ROOT / "generated/python/dalembert/model.schema.json").read_text())
    for name, new, old in PAIRS:
        properties = schema["$defs"][name]["properties"]
        assert properties[new] == properties[old]
