"""The mini example of every ready item gives the value that its spec states."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import dalembert as exu
import dalembert.itemInterface as items
from codegen.model import Item
from dalembert._tools.item_packages import item_classes
from dalembert.testing.scenes import UNDER_TEST

each_item = pytest.mark.parametrize("item", UNDER_TEST, ids=lambda item: item.name)


@each_item
def test_mini_example(item: Item, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert item.example is not None
    monkeypatch.chdir(tmp_path)
    container = exu.SystemContainer()
    names = {name: value for name, value in vars(items).items() if not name.startswith("_")}
    names |= {"exu": exu, "np": np, "SC": container, "mbs": container.AddSystem(), **item_classes()}
    exec(compile(item.example.code, item.path, "exec"), names)
    result = np.asarray(names["result"], dtype=float)
    np.testing.assert_allclose(result, item.example.value, rtol=0, atol=item.example.tolerance)
    uses = item.name in item.example.code or any(short in item.example.code for short in item.short_names)
    assert uses, "the example does not use the item"
