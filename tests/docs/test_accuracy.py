"""The table of errors in the pages is what its script computes, and shows the order of the methods."""

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
    with open(ROOT / "docs/accuracy.csv", newline="", encoding="utf-8") as file:
        header, *rows = (tuple(row) for row in csv.reader(file))
    assert header == accuracy.HEADER and len(rows) == LEVELS * len(accuracy.CASES)
    return rows


def test_the_two_largest_steps() -> None:
    """Errors are far above round-off and the tolerance of Newton's method: three digits may differ in the last."""
    rows = stored()
    shown = [row for case in range(len(accuracy.CASES)) for row in rows[LEVELS * case : LEVELS * case + 2]]
    for row, computed in zip(shown, accuracy.rows(levels=2), strict=True):
        assert row[:3] == computed[:3]
        assert float(row[3]) == pytest.approx(float(computed[3]), rel=0.02), row


def test_orders() -> None:
    """Second order at the smallest steps; references with eight to ten digits are felt."""
    for row in stored()[LEVELS - 1 :: LEVELS]:
        assert float(row[4]) == pytest.approx(2, abs=0.2), row
