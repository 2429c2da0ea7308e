"""The table of errors on the page is the output of its script, and shows the order of the methods."""

from __future__ import annotations

import csv
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "benchmarks"))

import accuracy

LEVELS = 4


def stored() -> list[tuple[str, ...]]:
    with open(ROOT / "docs/data/accuracy.csv", newline="", encoding="utf-8") as file:
        header, *rows = (tuple(row) for row in csv.reader(file))
    assert header == accuracy.HEADER and len(rows) == LEVELS * len(accuracy.CASES)
    return rows


@pytest.fixture(scope="module")
def computed() -> list[tuple[str, ...]]:
    return list(accuracy.rows(LEVELS))


def test_the_table_is_computed_again(computed: list[tuple[str, ...]]) -> None:
    """Errors are far above round-off and the tolerance of Newton's method: three digits may differ in the last."""
    for row, again in zip(stored(), computed, strict=True):
        assert row[:3] == again[:3]
        assert float(row[3]) == pytest.approx(float(again[3]), rel=0.02), row


def test_orders(computed: list[tuple[str, ...]]) -> None:
    """Orders at the smallest steps; references with eight to ten digits are felt."""
    for case, row in zip(accuracy.CASES, computed[LEVELS - 1 :: LEVELS], strict=True):
        assert float(row[4]) == pytest.approx(case.order, abs=0.2), row
