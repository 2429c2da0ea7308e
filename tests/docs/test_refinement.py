"""The table of refined steps is the output of its script: errors of Newton's method are below those of the steps."""

from __future__ import annotations

import csv
import sys
from itertools import pairwise
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "benchmarks"))

import refinement


def stored() -> dict[str, list[tuple[str, ...]]]:
    with open(ROOT / "docs/data/refinement.csv", newline="", encoding="utf-8") as file:
        header, *rows = (tuple(row) for row in csv.reader(file))
    assert header == refinement.HEADER
    lines = iter(rows)
    tables = {case.model: [next(lines) for _ in range(case.levels)] for case in refinement.CASES}
    assert next(lines, None) is None
    return tables


@pytest.mark.parametrize("case", refinement.CASES, ids=lambda case: case.model)
def test_refinement_converges(case: refinement.Case) -> None:
    """Second order at default tolerances: a quarter of the step leaves a sixteenth of the error. The cable, whose axial oscillations the
    coarser steps do not resolve, needs finer ones for that."""
    rows = stored()[case.model]
    errors = [float(row[2]) for row in rows]
    assert rows[0][0] == case.model
    for coarse, fine in pairwise(errors):
        assert fine < coarse / (2.5 if "Cable" in case.model else 14)
    if not case.modified_newton and "Cable" not in case.model:
        assert errors == pytest.approx([float(row[3]) for row in rows], rel=0.01)


@pytest.mark.parametrize("case", refinement.CASES, ids=lambda case: case.model)
def test_iterations_of_the_coarsest_steps(case: refinement.Case) -> None:
    """They depend on where a residual falls below the tolerance: rounding may shift a few."""
    first = stored()[case.model][0]
    assert refinement.solve(case, case.coarsest)[1] == pytest.approx(float(first[4]), rel=0.02)
