"""Models as JSON files: exact round trips of all items, wrong files refused with the place inside, no code without permission."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest
from sample_values import CLASSES, ITEMS, parameters, sample

import dalembert as exu
from codegen.model import Item
from dalembert._io import model_files

READY = [item for item in ITEMS if item.ready]


def empty() -> Any:
    return exu.SystemContainer().AddSystem()


def same(a: Any, b: Any) -> bool:
    """Equality of type and of all bits."""
    if type(a) is not type(b):
        return False
    if isinstance(a, dict):
        return list(a) == list(b) and all(same(a[key], b[key]) for key in a)
    if isinstance(a, (list, tuple)):
        return len(a) == len(b) and all(map(same, a, b))
    if isinstance(a, np.ndarray):
        return a.shape == b.shape and a.dtype == b.dtype and a.tobytes() == b.tobytes()
    if isinstance(a, exu.MatrixContainer):
        return same(a.Convert2DenseMatrix(), b.Convert2DenseMatrix()) and a.UseDenseMatrix() == b.UseDenseMatrix()
    if hasattr(a, "GetDictionary"):
        return same(a.GetDictionary(), b.GetDictionary())
    if type(a).__name__.endswith("List"):
        return len(a) == len(b) and all(np.array_equal(x, y) for x, y in zip(a, b, strict=True))
    return bool(a == b)


def filled(item: Item) -> Any:
    view = {row.name: sample(row) for row in item.visualization}
    return CLASSES[item.name]("own name", *(sample(row) for row in parameters(item)), visualization=view)


def surrounded(item: Any) -> Any:
    """A system with the item, and with so many others that its indices are of items that exist."""
    mbs = empty()
    for _ in range(9):
        node = mbs.AddNode(exu.NodePoint())
        mbs.AddObject(exu.ObjectMassPoint(nodeNumber=node))
        mbs.AddMarker(exu.MarkerNodePosition(nodeNumber=node))
        mbs.AddLoad(exu.LoadForceVector(markerNumber=0))
        mbs.AddSensor(exu.SensorNode(nodeNumber=node))
    getattr(mbs, f"Add{item_kind(item)}")(item)
    return mbs


def item_kind(item: Any) -> str:
    return next(kind for kind in ("Node", "Object", "Marker", "Load", "Sensor") if type(item).__name__.startswith(kind))


@pytest.mark.parametrize("make", [filled, lambda item: CLASSES[item.name]()], ids=["filled", "default"])
@pytest.mark.parametrize("item", READY, ids=lambda item: item.name)
def test_round_trip(item: Item, make: Any, tmp_path: Path) -> None:
    mbs, other = surrounded(make(item)), empty()
    mbs.Save(tmp_path / "model.json")
    assert other.Load(tmp_path / "model.json", allowCode=True) is None
    assert same(dict(other.GetDictionary()), dict(mbs.GetDictionary()))
    other.Save(tmp_path / "again.json")
    assert (tmp_path / "again.json").read_text() == (tmp_path / "model.json").read_text()


def test_zeros_keep_their_sign(tmp_path: Path) -> None:
    mbs, other = empty(), empty()
    mbs.AddNode(exu.NodePoint(initialVelocities=[0.0, -0.0, 0.0]))
    mbs.Save(tmp_path / "model.json")
    other.Load(tmp_path / "model.json")
    assert np.signbit(other.GetNode(0)["initialVelocities"]).tolist() == [False, True, False]


@cache
def validator() -> Any:
    schema = json.loads(model_files.SCHEMA.read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


@pytest.mark.parametrize("item", [item for item in READY if item.example], ids=lambda item: item.name)
def test_files_of_examples_keep_to_the_schema(item: Item, tmp_path: Path) -> None:
    mbs = empty()
    exec("import dalembert as exu\nfrom dalembert.utilities import *\n" + item.example.code, {"mbs": mbs})
    for name in model_files.KINDS:
        for i in range(getattr(mbs.systemData, f"NumberOf{name}s")()):
            for key, value in getattr(mbs, f"Get{name}")(i).items():
                if callable(value):
                    getattr(mbs, f"Set{name}Parameter")(i, key, 0)
    for function in ("PreStep", "PostStep", "PostNewton"):
        getattr(mbs, f"Set{function}UserFunction")(0)
    mbs.Save(tmp_path / "model.json", exu.SimulationSettings())
    content = json.loads((tmp_path / "model.json").read_text())
    validator().validate(content)
    other = empty()
    other.Load(tmp_path / "model.json")
    if mbs.systemIsConsistent:
        other.Assemble()  # values computed from other parameters
    assert same(dict(other.GetDictionary())["objectList"], dict(mbs.GetDictionary())["objectList"])


@pytest.mark.parametrize(
    ("edit", "path", "words"),
    [
        ({"physicsMass": -3}, ["objects", 0, "physicsMass"], "less than the minimum"),
        ({"weight": 3}, ["objects", 0], "'weight' was unexpected"),
        ({"type": "ObjectMasPoint"}, ["objects", 0, "type"], "'ObjectMasPoint' is not one of"),
    ],
)
def test_the_schema_reports_faults_of_an_item(edit: Any, path: Any, words: str, tmp_path: Path) -> None:
    mbs = empty()
    mbs.CreateMassPoint(physicsMass=2)
    mbs.Save(tmp_path / "model.json")
    content = json.loads((tmp_path / "model.json").read_text())
    content["objects"][0].update(edit)
    with pytest.raises(jsonschema.ValidationError, match=words) as caught:
        validator().validate(content)
    assert list(caught.value.absolute_path) == path


def pendulum() -> Any:
    mbs = empty()
    ground = mbs.CreateGround(name="ground")
    mass = mbs.CreateMassPoint("mass", referencePosition=[0.1, 1 / 3, 0], physicsMass=2, gravity=[0, -9.81, 0])
    mbs.CreateSpringDamper("spring", bodyNumbers=[ground, mass], stiffness=800)
    return mbs


def test_solutions_are_the_same_bit_for_bit(tmp_path: Path) -> None:
    mbs, settings = pendulum(), exu.SimulationSettings()
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 0.3, 70
    settings.solutionSettings.writeSolutionToFile = False
    settings.linearSolverType = exu.LinearSolverType.EigenSparse
    mbs.Save(tmp_path / "model.json", settings)
    other = empty()
    again = other.Load(tmp_path / "model.json")
    assert str(again) == str(settings)
    for system, of_system in ((mbs, settings), (other, again)):
        system.Assemble()
        system.SolveDynamic(of_system)
    assert np.array_equal(mbs.systemData.GetODE2Coordinates(), other.systemData.GetODE2Coordinates())


def test_large_arrays_stand_beside(tmp_path: Path) -> None:
    mbs = empty()
    nodes = [mbs.AddNode(exu.NodePoint()) for _ in range(20)]
    stiffness = np.random.default_rng(1).random((60, 60))
    mbs.AddObject(exu.ObjectGenericODE2(nodeNumbers=nodes, massMatrix=np.eye(60), stiffnessMatrix=stiffness))
    mbs.Save(tmp_path / "model.json")
    assert (tmp_path / "model.npz").exists() and len((tmp_path / "model.json").read_text()) < 3000
    other = empty()
    other.Load(tmp_path / "model.json")
    assert np.array_equal(np.asarray(other.GetObject(0)["stiffnessMatrix"]), stiffness)
    (tmp_path / "model.npz").unlink()
    with pytest.raises(ValueError, match=r"objects\[0\].massMatrix: there is no array"):
        other.Load(tmp_path / "model.json")


def spring_law(mbs: Any, t: float, item: int, x: float, v: float, k: float, d: float, f: float) -> float:
    return 2 * k * x


def test_code_is_loaded_by_permission_only(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    mbs, file = pendulum(), tmp_path / "model.json"
    mbs.SetObjectParameter("spring", "springForceUserFunction", spring_law)
    mbs.Save(file)
    other = pendulum()
    before = dict(other.GetDictionary())
    with pytest.raises(ValueError, match=r"objects\[2\].springForceUserFunction: is the function .*allowCode=True"):
        other.Load(file)
    assert same(dict(other.GetDictionary()), before)
    other.Load(file, allowCode=True)
    assert other.GetObjectParameter("spring", "springForceUserFunction") is spring_law

    monkeypatch.setattr(spring_law, "__module__", "__main__")
    with pytest.raises(ValueError, match=r"objects\[2\].springForceUserFunction: .*is in no module"):
        mbs.Save(file)
    mbs.Save(file, sourceOfFunctions=True)
    with pytest.raises(ValueError, match="the code of function 'spring_law'"):
        other.Load(file)
    other.Load(file, allowCode=True)
    assert other.GetObjectParameter("spring", "springForceUserFunction")(other, 0, 2, 3, 0, 5, 0, 0) == 30

    class Law:
        def force(self, mbs: Any, t: float, number: int, u: float, v: float, k: float, d: float, f: float) -> float:
            return k * u

    mbs.SetObjectParameter("spring", "springForceUserFunction", Law().force)
    for with_source in (False, True):
        with pytest.raises(ValueError, match="Law.force' is a method of an object, which files of models do not have"):
            mbs.Save(file, sourceOfFunctions=with_source)


def test_files_written_by_hand_may_use_names(tmp_path: Path) -> None:
    content = {
        "format": "dalembert model", "formatVersion": 1,
        "nodes": [{"type": "NodePoint", "name": "n"}],
        "objects": [
            {"type": "ObjectMassPoint", "name": "mass", "nodeNumber": "n", "physicsMass": 3},
            {"type": "ObjectGround", "name": "ground"},
            {"type": "ObjectConnectorSpringDamper", "markerNumbers": ["on ground", "on mass"], "stiffness": 5},
        ],
        "markers": [
            {"type": "MarkerBodyPosition", "name": "on mass", "bodyNumber": "mass"},
            {"type": "MarkerBodyPosition", "name": "on ground", "bodyNumber": "object1", "localPosition": [1, 0, 0]},
        ],
    }  # fmt: skip
    (tmp_path / "model.json").write_text(json.dumps(content).replace("object1", "ground"))
    mbs = empty()
    mbs.Load(tmp_path / "model.json")
    assert [int(number) for number in mbs.GetObject(2)["markerNumbers"]] == [1, 0]
    mbs.Assemble()


WRONG: list[tuple[Any, str]] = [
    ({"format": "other"}, "format: expected 'dalembert model'"),
    ({"formatVersion": 2}, "formatVersion: received 2, but this package reads 1 to 1"),
    ({"objekts": []}, "unknown key 'objekts'"),
    ({"objects": {}}, "objects: expected a list"),
    ({"objects": [3]}, r"objects\[0\]: expected a JSON object"),
    ({"objects": [{"type": "ObjectMassPont"}]}, r"objects\[0\].type: .*did you mean 'ObjectMassPoint2?D?'"),
    ({"objects": [{"type": "ObjectGround"}, {"type": "ObjectMassPoint", "physicsMass": "heavy"}]}, r"objects\[1\].physicsMass: .*'heavy'"),
    ({"objects": [{"type": "ObjectMassPoint", "physicsMass": -1}]}, r"objects\[0\].physicsMass: .*expected"),
    ({"objects": [{"type": "ObjectMassPoint", "physicsMas": 1}]}, r"objects\[0\].physicsMas: .*Did you mean 'physicsMass'"),
    ({"objects": [{"type": "ObjectMassPoint", "nodeNumber": 4}]}, r"objects\[0\].nodeNumber: received 4, but the file has 1 nodes"),
    ({"objects": [{"type": "ObjectMassPoint", "nodeNumber": "foot"}]}, r"objects\[0\].nodeNumber: there is no node named 'foot'"),
    ({"objects": [{"type": "ObjectGround", "visualization": {"shown": True}}]}, r"objects\[0\].visualization.shown: "),
    ({"objects": [{"type": "ObjectGround", "visualization": 1}]}, r"objects\[0\].visualization: received 1"),
    ({"nodes": [{"type": "NodePoint", "name": "a"}, {"type": "NodePoint", "name": "a"}]}, r"nodes\[1\].name: 'a' is already the name of nodes\[0\]"),
    ({"nodes": [{"type": "NodePoint", "referenceCoordinates": [1, 2]}]}, r"nodes\[0\].referenceCoordinates: .*expected 3 finite numbers"),
    ({"sensors": [{"type": "SensorNode", "outputVariableType": "Positon"}]}, r"sensors\[0\].outputVariableType: received 'Positon'"),
    ({"settings": {"timeIntegration": {"endTim": 1}}}, "settings: .*endTim"),
    ({"settings": {"timeIntegration": 1}}, "settings.timeIntegration: expected a JSON object"),
    ({"settings": {"linearSolverType": "fast"}}, "settings.linearSolverType: received 'fast'"),
    ({"objects": [{"type": "ObjectGround", "visualization": {"graphicsData": [{"p": {"array": [1], "dtype": "O"}}]}}]}, r"objects\[0\].visualization.graphicsData: .*may hold code"),
]  # fmt: skip


@pytest.mark.parametrize(("change", "text"), WRONG, ids=[text for _, text in WRONG])
def test_wrong_files_are_refused_with_the_place(change: dict[str, Any], text: str, tmp_path: Path) -> None:
    file = tmp_path / "model.json"
    content = {"format": "dalembert model", "formatVersion": 1, "nodes": [{"type": "NodePoint"}], "objects": []}
    file.write_text(json.dumps(content | change))
    mbs = pendulum()
    before = dict(mbs.GetDictionary())
    with pytest.raises(ValueError, match=f"model.json: {text}"):
        mbs.Load(file)
    assert same(dict(mbs.GetDictionary()), before)


@pytest.mark.parametrize("text", ["", "{", "[]", '{"a": NaN}', '{"a": 1, "a": 2}', "[" * 100_000, "\x00\xff"])
def test_invalid_json_is_rejected(text: str, tmp_path: Path) -> None:
    (tmp_path / "model.json").write_text(text)
    with pytest.raises(ValueError, match="model.json"):
        pendulum().Load(tmp_path / "model.json")


def test_variables_and_graphics_come_back(tmp_path: Path) -> None:
    mbs = empty()
    shape = [{"type": "Line", "color": [1, 0, 0, 1], "data": np.arange(6.0)}, {"point": (1, 2)}, {3: "number as key"}]
    mbs.CreateGround(graphicsDataList=shape)
    mbs.variables["masses"] = {"a": [1, 2.5], "b": np.eye(2)}
    mbs.variables["file"] = open  # no data
    mbs.Save(tmp_path / "model.json")
    other = empty()
    other.Load(tmp_path / "model.json")
    assert same(other.GetObject(0, True)["VgraphicsData"], shape)
    assert list(other.variables) == ["masses"] and same(other.variables["masses"], mbs.variables["masses"])
