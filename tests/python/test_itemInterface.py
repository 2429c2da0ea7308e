"""Checks and copies that the module of items has besides the items."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from dalembert import itemInterface as items

WRONG: list[Any] = ["1", None, [1], np.nan, np.inf, -1, -0.5]
CHECKS = {
    "CheckForValidUInt": ([0, 3, np.int64(3)], [*WRONG, 1.5]),
    "CheckForValidPInt": ([1, np.int32(3)], [*WRONG, 1.5, 0]),
    "CheckForValidUReal": ([0, 0.0, 2.5, np.float32(2.5), 3], WRONG),
    "CheckForValidPReal": ([1, 1e-300, np.float64(2.5)], [*WRONG, 0, 0.0]),
}


@pytest.mark.parametrize("name", CHECKS)
def test_checks_return_valid_values_and_reject_others(name: str) -> None:
    valid, wrong = CHECKS[name]
    for value in valid:
        assert getattr(items, name)(value, "p", "Item") is value
    for value in wrong:
        with pytest.raises(ValueError, match=r"Item, parameter 'p': received .*, but expected a finite"):
            getattr(items, name)(value, "p", "Item")


def test_numbers() -> None:
    assert all(map(items.IsValidNumber, (1, 1.5, True, np.int8(1), np.float32(1))))
    assert not any(map(items.IsValidNumber, ("1", None, [1], np.array([1]), 1j)))


def test_arrays() -> None:
    assert items.CheckForValidNumpyArray(3) == 3
    assert items.CheckForValidNumpyArray([[1, 2], [3, 4]]).shape == (2, 2)
    with pytest.raises(ValueError, match="inhomogeneous"):
        items.CheckForValidNumpyArray([[1, 2], [3]])


def test_copies_of_one_level() -> None:
    array = np.eye(2)
    original: dict[str, Any] = {"list": [1, {"a": 1}], "dict": {"list": [1]}, "array": array}
    copied = items.CopyDictLevel1(original)
    assert copied == original
    copied["list"].append(2)
    copied["dict"]["more"] = 3
    assert len(original["list"]) == 2 and list(original["dict"]) == ["list"]
    assert copied["dict"]["list"] is original["dict"]["list"] and copied["array"] is array
