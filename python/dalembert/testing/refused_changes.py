"""An error of an assembled system names item and parameter; the system remains unchanged."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from codegen.model import Item, Parameter
from dalembert.testing.outputs import find
from dalembert.testing.scenes import UNDER_TEST, Scene, is_ground
from dalembert.testing.variants import variants_with

INDEX = {"node": exu.NodeIndex, "object": exu.ObjectIndex, "marker": exu.MarkerIndex, "load": exu.LoadIndex}
ROWS = [
    (item, row)
    for item in UNDER_TEST
    if item.kind != "sensor" and not is_ground((item.name, ""))
    for row in item.parameters
    if not row.internal and row.name != "name"
]
ids = lambda pairs: [f"{item.name}.{row.name}" for item, row in pairs]  # noqa: E731


def model(item: Item, row: Parameter | None = None) -> tuple[Scene, int]:
    """Arguments with the row's index set, if it is optional."""
    variants = variants_with(item)
    if row is not None and row.type.storage == "node":
        variants = [v for v in variants if v.data] or variants
    scene = variants[0].build(seed=71)
    return scene, find(scene, item)


def accessors(scene: Scene, item: Item) -> tuple[Any, Any]:
    return tuple(getattr(scene.mbs, f"{verb}{item.kind.title()}Parameter") for verb in ("Get", "Set"))


def snapshot(scene: Scene) -> tuple[str, Any]:
    mbs = scene.mbs
    return repr(mbs.GetDictionary()), [mbs.systemData.GetODE2Coordinates(), mbs.systemData.GetODE2Coordinates_t()]


def assert_unchanged(scene: Scene, before: tuple[str, Any]) -> None:
    after = snapshot(scene)
    assert after[0] == before[0]
    np.testing.assert_equal(after[1], before[1])
    assert scene.mbs.systemIsConsistent


def bad_values(row: Parameter) -> list[Any]:
    """Values of a wrong type or length, not a number, out of range, or an index of the wrong kind."""
    storage = row.type.storage
    bad: list[Any] = (
        [] if storage == "opaque" else [5 if storage == "text" else {"a": 1} if storage == "user_function" else "words"]
    )
    if storage == "real":
        bad += [float("nan"), [1.0, 2.0]]
    if storage.startswith(("vector", "matrix")) and storage != "matrix_container":
        bad.append(np.full([n or 3 for n in row.shape], np.nan))
        if row.shape[0]:
            bad += [np.zeros([n + 1 for n in row.shape]), np.zeros(row.shape[0] - 1)]
    if storage in ("real", "integer") and row.effective_check != "none":
        bad.append(-1)
    if row.effective_check == "positive":
        bad.append(0)
    bad = [
        value for value in bad if np.ndim(value) or value != (-1 if row.default == "invalid" else row.default)
    ]  # means: not set
    kind = storage.removesuffix("s")
    if kind in INDEX:
        others = [index(0) for name, index in INDEX.items() if name != kind]
        bad += [[other, other] for other in others] if storage != kind else others
    return bad


@pytest.mark.parametrize(("item", "row"), ROWS, ids=ids(ROWS))
def test_bad_values(item: Item, row: Parameter) -> None:
    scene, number = model(item)
    _, put = accessors(scene, item)
    before = snapshot(scene)
    for value in bad_values(row):
        with pytest.raises((TypeError, ValueError, IndexError)) as caught:
            put(number, row.name, value)
        text = str(caught.value)
        assert f"{item.kind} {number} " in text
        assert f"({item.name}), parameter '{row.name}': received " in text
        assert_unchanged(scene, before)


INDICES = [(item, row) for item, row in ROWS if row.type.index]


@pytest.mark.parametrize(("item", "row"), INDICES, ids=ids(INDICES))
@pytest.mark.parametrize("beyond", [0, 7])
def test_index_out_of_range_is_refused_at_assemble(item: Item, row: Parameter, beyond: int) -> None:
    scene, number = model(item, row)
    get, put = accessors(scene, item)
    kind = row.type.storage.removesuffix("s")
    count = len(scene.mbs.GetDictionary()[f"{kind}List"])
    value = get(number, row.name)
    several = row.type.storage.endswith("s")
    wrong = [*list(value)[:-1], count + beyond] if several else count + beyond
    put(number, row.name, wrong)
    text = rf"{item.kind} {number} '.*' \({item.name}\), parameter '{row.name}': received {count + beyond}, .*from 0 to {count - 1}"
    with pytest.raises(ValueError, match=text):
        scene.mbs.Assemble()
    assert not scene.mbs.systemIsConsistent
    put(number, row.name, value)
    scene.mbs.Assemble()
    assert scene.mbs.systemIsConsistent
