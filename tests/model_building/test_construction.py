"""Item classes: arguments, defaults, attributes, names and signatures, for all specs."""

from __future__ import annotations

import inspect
from typing import Any

import numpy as np
import pytest
from sample_values import CLASSES, ITEMS, parameters, plain, rows, sample

import dalembert as exu
from codegen.model import Item, Parameter

each_item = pytest.mark.parametrize("item", ITEMS, ids=lambda item: item.name)


def each_row(*conditions: Any) -> Any:
    pairs = list(rows(*conditions))
    return pytest.mark.parametrize(("item", "row"), pairs, ids=[f"{i.name}.{r.name}" for i, r in pairs])


@each_item
def test_signature_is_that_of_the_spec(item: Item) -> None:
    signature = inspect.signature(CLASSES[item.name]).parameters
    named_only = [name for name, each in signature.items() if each.kind == each.KEYWORD_ONLY]
    aliases = [alias for row in parameters(item) for alias in row.aliases]
    assert named_only == [*aliases, *(each.name for each in item.transformations)]
    assert [*signature][: -len(named_only) or None] == [
        "name",
        *(row.name for row in parameters(item)),
        "visualization",
    ]


@each_item
def test_visualization_signature_is_that_of_the_spec(item: Item) -> None:
    names = list(inspect.signature(getattr(exu, "V" + item.name)).parameters)
    assert names == [row.name for row in item.visualization]


@each_item
def test_short_names(item: Item) -> None:
    for name in item.short_names:
        assert getattr(exu, name) is CLASSES[item.name]
        assert getattr(exu, "V" + name) is getattr(exu, "V" + item.name)


@each_row(lambda row: row.default is not None and row.default != "invalid" and not row.type.index)
def test_defaults_are_those_of_the_spec(item: Item, row: Parameter) -> None:
    value = plain(getattr(CLASSES[item.name](), row.name))
    wanted: Any = row.default
    if row.type.storage == "output_variable":
        wanted = getattr(exu.OutputVariableType, wanted)
    np.testing.assert_equal(np.ravel(value).tolist(), np.ravel(wanted).tolist())


@each_row(lambda row: row.type.index)
def test_indices_are_invalid_at_first(item: Item, row: Parameter) -> None:
    values = getattr(CLASSES[item.name](), row.name)
    assert all(int(value) == exu.InvalidIndex() for value in (values if row.type.shape else [values]))


@each_row(lambda row: row.type.takes_number)
@pytest.mark.parametrize(
    "number", [2, 0.5, np.float32(0.5), np.int64(2), np.array(0.5)], ids=lambda number: type(number).__name__
)
def test_a_number_is_the_one_entry(item: Item, row: Parameter, number: Any) -> None:
    """The data of a plate with one thickness."""
    assert getattr(CLASSES[item.name](**{row.name: number}), row.name).ravel().tolist() == [number]


@each_row()
def test_a_value_comes_in_by_name_and_goes_out_as_attribute(item: Item, row: Parameter) -> None:
    value = sample(row)
    made = CLASSES[item.name](**{row.name: value})
    assert plain(getattr(made, row.name)) == plain(value)
    changed = CLASSES[item.name]()
    setattr(changed, row.name, value)
    assert changed == made
    if plain(value) != plain(getattr(CLASSES[item.name](), row.name)):
        assert changed != CLASSES[item.name]()


@each_item
def test_arguments_by_position(item: Item) -> None:
    values = [sample(row) for row in parameters(item)]
    by_position = CLASSES[item.name]("own name", *values)
    by_name = CLASSES[item.name](name="own name", **{r.name: v for r, v in zip(parameters(item), values, strict=True)})
    assert by_position == by_name


@each_item
def test_visualization_by_class_dictionary_and_attribute(item: Item) -> None:
    show = not CLASSES[item.name]().visualization.show
    by_class = CLASSES[item.name](visualization=getattr(exu, "V" + item.name)(show=show))
    by_dictionary = CLASSES[item.name](visualization={"show": show})
    by_attribute = CLASSES[item.name]()
    by_attribute.visualization.show = show
    by_key = CLASSES[item.name]()
    by_key.visualization["show"] = show
    assert by_class == by_dictionary == by_attribute == by_key != CLASSES[item.name]()
    assert dict(by_class)["Vshow"] is show


@each_item
def test_unknown_argument_names_the_nearest(item: Item) -> None:
    known = (parameters(item) or item.parameters)[0].name
    with pytest.raises(TypeError, match=rf"{item.name}: there is no parameter '{known}x'\. Did you mean '{known}'\?"):
        CLASSES[item.name](**{known + "x": 0})


@each_item
def test_too_many_arguments(item: Item) -> None:
    with pytest.raises(TypeError, match=r"received \d+ positional arguments, but expected at most"):
        CLASSES[item.name](*[""] * (len(item.parameters) + 9))


def test_argument_given_twice() -> None:
    with pytest.raises(TypeError, match="NodePoint 'a', parameter 'name': given by position and by name"):
        exu.NodePoint("a", name="b")


def test_arrays_of_attributes_write_through() -> None:
    node = exu.NodePoint()
    node.referenceCoordinates[1] = 5
    assert node.referenceCoordinates.tolist() == [0, 5, 0]
    body = exu.ObjectGround()
    body.referenceRotation[0, 2] = 3
    assert dict(body)["referenceRotation"][0, 2] == 3


def test_lists_are_copied() -> None:
    markers = [1, 2]
    spring = exu.SpringDamper(markerNumbers=markers)
    markers.append(3)
    assert spring.markerNumbers == [1, 2]
    graphics: list[dict[str, Any]] = []
    body = exu.MassPoint(visualization=exu.VMassPoint(graphicsData=graphics))
    graphics.append({"type": "Line"})
    assert body.visualization.graphicsData == []


def test_misspelt_attribute_is_refused() -> None:
    node = exu.NodePoint()
    with pytest.raises(AttributeError, match=r"NodePoint: there is no parameter 'initialCoordinate'\. Did you mean"):
        node.initialCoordinate = [0, 0, 0]


def test_python_classes_may_derive_from_items() -> None:
    class Foot(exu.NodePoint):
        def __init__(self, height: float) -> None:
            super().__init__("foot", [0, 0, height])

    foot = Foot(2.0)
    assert foot.referenceCoordinates[2] == 2
    assert isinstance(foot, exu.NodePoint)


def test_repr_shows_differences_from_the_defaults() -> None:
    assert repr(exu.NodePoint("a", [1, 0, 0])) == "NodePoint(name='a', referenceCoordinates=[1.0, 0.0, 0.0])"
    assert repr(exu.VNodePoint(show=False)) == "VNodePoint(show=False)"


def test_items_are_not_hashable_because_they_change() -> None:
    with pytest.raises(TypeError):
        hash(exu.NodePoint())


def test_visualization_of_another_item_has_common_parameters() -> None:
    line = {"type": "Line", "data": [0, 0, 0, 1, 0, 0], "color": [1, 0, 0, 1]}
    point = exu.ObjectMassPoint2D(visualization=exu.VObjectRigidBody2D(graphicsData=[line], show=False))
    assert point.visualization.graphicsData == [line] and not point.visualization.show
    node = exu.NodePoint(visualization=exu.VObjectRigidBody2D(show=False))  # a node has no graphicsData
    assert not node.visualization.show
