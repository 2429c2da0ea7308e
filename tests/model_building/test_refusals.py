"""Values that do not fit are refused by name, and leave everything as it was."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from sample_values import CLASSES, FIXED, INDEX, SQUARE, rows, sample, wrong_type

import dalembert as exu
from codegen.model import Item, Parameter


def each_row(condition: Any) -> Any:
    pairs = list(rows(condition))
    return pytest.mark.parametrize(("item", "row"), pairs, ids=[f"{i.name}.{r.name}" for i, r in pairs])


def refuse(item: Item, row: Parameter, value: Any, error: Any = (TypeError, ValueError)) -> str:
    made = CLASSES[item.name]()
    with pytest.raises(error) as caught:
        setattr(made, row.name, value)
    assert made == CLASSES[item.name]()
    with pytest.raises(error) as again:
        CLASSES[item.name](**{row.name: value})
    text = str(caught.value)
    assert text == str(again.value)
    assert text.startswith(f"{item.name}, parameter '{row.name}': received ")
    assert "but expected " in text
    return text


@each_row(lambda row: row.type.storage != "opaque")
def test_wrong_type(item: Item, row: Parameter) -> None:
    refuse(item, row, wrong_type(row), TypeError)


@each_row(lambda row: row.type.storage in {*FIXED, *SQUARE, "vector", "matrix", "vector3s", "vector6s"})
@pytest.mark.parametrize("bad", [float("nan"), float("inf")])
def test_not_finite(item: Item, row: Parameter, bad: float) -> None:
    value = np.array(sample(row), dtype=float)
    value.flat[-1] = bad
    refuse(item, row, value, ValueError)
    refuse(item, row, value.tolist(), ValueError)


@each_row(lambda row: row.type.storage == "real")
@pytest.mark.parametrize("bad", [float("nan"), float("inf")])
def test_not_a_finite_number(item: Item, row: Parameter, bad: float) -> None:
    assert "a finite number" in refuse(item, row, bad, ValueError)


@each_row(lambda row: row.type.storage in {*FIXED, *SQUARE} or (row.type.shape and row.shape[0]))
def test_wrong_length(item: Item, row: Parameter) -> None:
    value = sample(row)
    refuse(item, row, value[:-1], ValueError)
    refuse(item, row, [*value, value[0]], ValueError)


@each_row(lambda row: row.type.storage in ("real", "integer") and row.effective_check != "none")
def test_sign(item: Item, row: Parameter) -> None:
    text = refuse(item, row, -3, ValueError)
    assert ("not negative" if row.effective_check == "non_negative" else "greater than zero") in text


@each_row(lambda row: row.type.storage in ("integer", "node", "object", "marker", "load", "sensor"))
def test_real_number_for_an_integer(item: Item, row: Parameter) -> None:
    refuse(item, row, 1.5, TypeError)
    refuse(item, row, np.float64(1), TypeError)


@each_row(lambda row: row.type.index and not row.type.shape)
def test_index_of_another_kind(item: Item, row: Parameter) -> None:
    for kind, index in INDEX.items():
        if kind != row.type.storage:
            text = refuse(item, row, index(0), TypeError)
            assert f"it counts {kind}s, not {row.type.storage}s" in text


@each_row(lambda row: row.type.index and row.type.shape)
def test_list_with_an_index_of_another_kind(item: Item, row: Parameter) -> None:
    own = row.type.storage.removesuffix("s")
    other = exu.LoadIndex(0) if own != "load" else exu.NodeIndex(0)
    text = refuse(item, row, [*sample(row)[:-1], other], TypeError)
    assert f"not {own}s" in text


@each_row(lambda row: row.type.storage == "boolean")
def test_truth_values(item: Item, row: Parameter) -> None:
    refuse(item, row, 2, ValueError)
    refuse(item, row, 0.5, TypeError)
    for value in (1, 0, True, np.True_):
        assert getattr(CLASSES[item.name](**{row.name: value}), row.name) is bool(value)


@pytest.mark.parametrize(
    ("make", "error", "text"),
    [
        (
            lambda: exu.NodePoint(referenceCoordinates=[1, 2]),
            ValueError,
            "NodePoint, parameter 'referenceCoordinates': received [1, 2] (list of length 2), but expected 3 finite numbers"
            " (unit m). The length is 2; pass a list or numpy array of length 3.",
        ),
        (
            lambda: exu.NodePoint("foot", [1, 2, "3"]),
            TypeError,
            "NodePoint 'foot', parameter 'referenceCoordinates': received [1, 2, '3'] (list of length 3), but expected"
            " 3 finite numbers (unit m). Entry 2 is '3' (str), not a number.",
        ),
        (
            lambda: exu.MassPoint(nodeNumber=exu.ObjectIndex(1)),
            TypeError,
            "ObjectMassPoint, parameter 'nodeNumber': received 1 (ObjectIndex), but expected a NodeIndex, an integer or a name."
            " The value is an ObjectIndex: it counts objects, not nodes. Pass what AddNode(...) returned.",
        ),
        (
            lambda: exu.MassPoint(physicsMass=-1),
            ValueError,
            "ObjectMassPoint, parameter 'physicsMass': received -1 (int), but expected a number that is not negative"
            " (unit kg).",
        ),
        (
            lambda: exu.SpringDamper(springForceUserFunction=1),
            TypeError,
            "ObjectConnectorSpringDamper, parameter 'springForceUserFunction': received 1 (int), but expected a function,"
            " or 0 for none. Pass the function itself, without calling it.",
        ),
        (
            lambda: exu.SensorNode(outputVariableType="Position"),
            TypeError,
            "SensorNode, parameter 'outputVariableType': received 'Position' (str), but expected a member of"
            " OutputVariableType. Write OutputVariableType.Position without quotes.",
        ),
        (
            lambda: exu.NodePoint(visualization={"colour": [1, 0, 0, 1]}),
            TypeError,
            "NodePoint, parameter 'visualization': there is no visualization parameter 'colour'; received"
            " {'colour': [1, 0, 0, 1]} (dict), but expected VNodePoint(...) or a dictionary. Did you mean 'color'?",
        ),
        (
            lambda: exu.NodePoint(visualization={"color": [1, 0, 0]}),
            ValueError,
            "NodePoint, parameter 'Vcolor': received [1, 0, 0] (list of length 3), but expected 4 finite numbers."
            " The length is 3; pass a list or numpy array of length 4.",
        ),
    ],
    ids=range(8),
)
def test_texts(make: Any, error: type[Exception], text: str) -> None:
    with pytest.raises(error) as caught:
        make()
    # Units are stated by the specs; the rest of the text is ours.
    assert str(caught.value).replace(" (unit 1)", "") == text or str(caught.value) == text.replace(
        " (unit m)", ""
    ).replace(" (unit kg)", "")
