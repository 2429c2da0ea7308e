"""The table of work against accuracy is the output of its script, and shows the most efficient methods."""

from __future__ import annotations

import csv
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "benchmarks"))

import radau
import work_precision


def stored() -> list[tuple[str, ...]]:
    with open(ROOT / "docs/data/work_precision.csv", newline="", encoding="utf-8") as file:
        header, *rows = (tuple(row) for row in csv.reader(file))
    assert header == work_precision.HEADER
    return rows


def test_the_table_is_complete() -> None:
    wanted = [
        (case.model, method.name, f"{tolerance:.0e}")
        for case in work_precision.CASES
        for method in case.methods
        for tolerance in case.tolerances
    ]
    assert [row[:3] for row in stored()] == wanted


@pytest.mark.parametrize("case", work_precision.CASES, ids=lambda case: case.model)
def test_a_row_is_computed_again(case: work_precision.Case) -> None:
    """The middle tolerance of the first and the last method; machines round differently, which moves steps a little."""
    tolerance = case.tolerances[len(case.tolerances) // 2 - 1]
    for method in (case.methods[0], case.methods[-1]):
        again = work_precision.run(case, method, tolerance)
        (row,) = (row for row in stored() if row[:3] == again[:3])
        assert int(row[3]) == pytest.approx(int(again[3]), rel=0.02, abs=2)
        assert row[6] != "stops" and float(row[6]) == pytest.approx(float(again[6]), rel=0.5)


def test_order_eight_pays_for_mechanisms() -> None:
    """DOP853 has a smaller error in the squeezer at a tolerance of 1e-8 than ODE23, with a tenth of its work."""
    lines = {row[1]: row for row in stored() if row[0] == work_precision.CASES[1].model and row[2] == "1e-08"}
    assert int(lines["DOP853"][5]) < 0.1 * int(lines["ODE23"][5])
    assert float(lines["DOP853"][6]) < float(lines["ODE23"][6])


def test_radau_takes_few_steps() -> None:
    """Errors fall by two orders while the tolerance does so, with less than three times the factorizations: 100^(1/5) = 2.5."""
    few, many = (radau.by_radau(work_precision.squeezer, 0.03, tolerance) for tolerance in (1e-6, 1e-8))
    assert few.error == pytest.approx(1.97e-6, rel=0.02)  # ratio of errors: method to iterations
    assert many.error == pytest.approx(6.76e-9, rel=0.02)
    assert many.factorizations < 3 * few.factorizations
