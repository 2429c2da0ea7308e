"""Items as dictionaries, pickles and copies, for all specs."""

from __future__ import annotations

import copy
import json
import pickle
from typing import Any

import pytest
from sample_values import CLASSES, ITEMS, parameters, plain, sample

import dalembert as exu
from codegen.model import Item

each_item = pytest.mark.parametrize("item", ITEMS, ids=lambda item: item.name)


def filled(item: Item) -> Any:
    return CLASSES[item.name]("own name", *(sample(row) for row in parameters(item)), visualization={"show": False})


@each_item
def test_keys_of_the_dictionary(item: Item) -> None:
    keys = list(dict(CLASSES[item.name]()))
    expected = [
        f"{item.kind}Type",
        "name",
        *(r.name for r in parameters(item)),
        *("V" + r.name for r in item.visualization),
    ]
    assert keys == expected
    assert dict(CLASSES[item.name]())[f"{item.kind}Type"] == item.type_name


@each_item
@pytest.mark.parametrize("make", [filled, lambda item: CLASSES[item.name]()], ids=["filled", "default"])
def test_pickle_and_copies_are_equal(item: Item, make: Any) -> None:
    original = make(item)
    for other in (pickle.loads(pickle.dumps(original)), copy.copy(original), copy.deepcopy(original)):
        assert other == original
        assert type(other) is type(original)


@each_item
@pytest.mark.parametrize("make", [filled, lambda item: CLASSES[item.name]()], ids=["filled", "default"])
def test_dictionaries_and_json_bring_the_item_back(item: Item, make: Any) -> None:
    """JSON has no arrays, indices and enumerations: lists and numbers stand for them, and only members of enumerations have to
    be made of their numbers again. User functions are not data."""
    original = make(item)
    for row in item.rows:
        if row.type.function:
            setattr(original if row in item.parameters else original.visualization, row.name, 0)
    data = dict(original)
    text = json.dumps({key: plain(value) for key, value in data.items()}, default=int)
    read = json.loads(text)
    for row in item.parameters:
        if row.type.storage == "output_variable":
            read[row.name] = exu.OutputVariableType(read[row.name])
        elif row.type.storage == "joint_types":
            read[row.name] = [exu.JointType(number) for number in read[row.name]]
        elif row.type.opaque or row.type.storage == "beam_section":
            read[row.name] = data[row.name]  # sections of beams: objects of Python
    kind = item.kind.title()
    added = []
    if item.ready:
        for source in (data, read):
            mbs = exu.SystemContainer().AddSystem()
            number = getattr(mbs, f"Add{kind}")(source)
            graphics = {"addGraphicsData": True} if item.kind == "object" else {}
            added.append({key: plain(value) for key, value in getattr(mbs, f"Get{kind}")(number, **graphics).items()})
        names = {"name": added[0]["name"]}
        assert added[0] == added[1] == {key: plain(value) for key, value in data.items()} | names
    rows = [row.name for row in parameters(item)]
    again = CLASSES[item.name](
        data["name"], **{name: read[name] for name in rows}, visualization=dict(original.visualization)
    )
    assert again == original


@each_item
def test_visualization_pickles(item: Item) -> None:
    original = getattr(exu, "V" + item.name)(show=False)
    assert pickle.loads(pickle.dumps(original)) == original
    assert plain(list(dict(original).values())) == [plain(original[key]) for key in original.keys()]  # noqa: SIM118


@each_item
def test_defaults_by_type_name(item: Item, mbs: exu.MainSystem) -> None:
    get = getattr(mbs, f"Get{item.kind.title()}Defaults")
    defaults = {key: plain(value) for key, value in dict(CLASSES[item.name]()).items()}
    assert {key: plain(value) for key, value in get(item.type_name).items()} == defaults


@pytest.mark.parametrize("item", [item for item in ITEMS if item.ready], ids=lambda item: item.name)
def test_system_keeps_all_parameters(item: Item, mbs: exu.MainSystem) -> None:
    kind = item.kind.title()
    original = filled(item)
    number = getattr(mbs, f"Add{kind}")(original)
    assert type(number).__name__ == f"{kind}Index"
    graphics = {"addGraphicsData": True} if item.kind == "object" else {}
    stored = getattr(mbs, f"Get{kind}")(number, **graphics)
    assert {k: plain(v) for k, v in stored.items()} == {k: plain(v) for k, v in dict(original).items()}
    for row in parameters(item):
        assert plain(getattr(mbs, f"Get{kind}Parameter")(number, row.name)) == plain(sample(row))
    second = exu.SystemContainer().AddSystem()
    getattr(second, f"Add{kind}")(stored)
    assert plain(list(getattr(second, f"Get{kind}")(0, **graphics).values())) == plain(list(stored.values()))


@pytest.mark.parametrize("item", [item for item in ITEMS if not item.ready], ids=lambda item: item.name)
def test_planned_items_are_refused(item: Item, mbs: exu.MainSystem) -> None:
    with pytest.raises(
        NotImplementedError, match=rf"{item.name} is specified, but its physics is planned.*{item.path}"
    ):
        getattr(mbs, f"Add{item.kind.title()}")(CLASSES[item.name]())
