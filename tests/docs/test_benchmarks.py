"""The benchmarks that compare with Exudyn: their models are correct, and the limits of instructions include them."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np
import pytest

FOLDER = Path(__file__).parents[2] / "benchmarks"
sys.path.insert(0, str(FOLDER))

import instructions
import models

package = models.Package.load("dalembert")


@pytest.mark.parametrize("case", models.CASES)
def test_every_case_is_assembled(case: str) -> None:
    assert np.isfinite(models.CASES[case].build(package).result())


def test_oscillator() -> None:
    """Explicit Euler adds k h / (2 m) to the rate of decay d / (2 m); 10 000 steps in one second: the error is of
    second order in h."""
    stiffness, damping, mass, step = 200.0, 0.5, 2.0, 1e-4
    job = models.oscillator(package, 10_000)
    job.solve()
    decay = damping / (2 * mass) - stiffness * step / (2 * mass)
    frequency = np.sqrt(stiffness / mass - (damping / (2 * mass)) ** 2)
    exact = 0.1 * np.exp(-decay) * (np.cos(frequency) + damping / (2 * mass) / frequency * np.sin(frequency))
    assert job.result() == pytest.approx(exact, rel=2e-3)


def test_cantilever() -> None:
    """Elastica with P L^2 / EI = 1; the axial strain, below P / EA = 5e-5, and 32 elements leave less than 2e-4."""
    job = models.cantilever(package, 32, 5)
    job.solve()
    assert job.result() == pytest.approx(-2 * 0.3017207738, rel=2e-4)


def test_counts_are_stored_for_every_guarded_model() -> None:
    assert set(json.loads(instructions.STORED.read_text())) == set(instructions.CASES)
