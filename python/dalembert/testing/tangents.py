"""The tangent is the derivative of the residual, along all weights, at random states of models around every item."""

from __future__ import annotations

import itertools
from collections.abc import Iterable
from typing import Any

import numpy as np
import pytest

from dalembert._core import testing
from dalembert.testing.exemptions import HOLDS_JACOBIAN
from dalembert.testing.scenes import Scene
from dalembert.testing.variants import ALL_VARIANTS, Variant

each_variant = pytest.mark.parametrize("variant", ALL_VARIANTS, ids=lambda variant: variant.id)
WEIGHTS = {
    "positions": {"cq": 1.0},
    "velocities": {"cq": 0.0, "cv": 1.0},
    "together": {"cq": 0.7, "cv": -1.3, "ca": 0.4, "cy": 1.1, "cy_t": 0.6},
}
STATES = range(3)
# Central differences, extrapolated from two steps: the error of third derivatives is a part of the difference of both,
# and
# rounding is eps / h of the terms that a row sums up. User functions have differences of their own inside.
STEP = 1e-4
LEFT, ROUNDING = 0.05, 5e-11
OF_FUNCTIONS = 2e-6


def random_state(scene: Scene, seed: int) -> testing.State:
    """Near the model's own, with everything moved: positions, multipliers, history."""
    rng = np.random.default_rng(seed)
    s = scene.state()
    s.q = testing.compose(scene.mbs, s, 0.1 * rng.normal(size=len(s.q)))
    s.v = s.v + rng.normal(size=len(s.v))
    s.a = s.a + rng.normal(size=len(s.a))
    s.y, s.y_t = s.y + rng.normal(size=len(s.y)), rng.normal(size=len(s.y))
    s.lam = rng.normal(size=len(s.lam))
    s.data = 0.3 * rng.normal(size=len(s.data))
    s.t, s.load_factor = 0.37, 0.8
    return s


def moved(mbs: Any, s: testing.State, kind: str, i: int, h: float, w: dict[str, float]) -> testing.State:
    other = s.copy()
    unit = {"q": len(s.q), "y": len(s.y), "lam": len(s.lam)}[kind]
    step = h * np.eye(unit)[i]
    if kind == "q":
        other.q = testing.compose(mbs, s, w.get("cq", 1.0) * step)
        other.v = s.v + w.get("cv", 0.0) * step
        other.a = s.a + w.get("ca", 0.0) * step
    elif kind == "y":
        other.y = s.y + w.get("cy", 1.0) * step
        other.y_t = s.y_t + w.get("cy_t", 0.0) * step
    else:
        other.lam = s.lam + step
    return other


def differences(mbs: Any, s: testing.State, w: dict[str, float], h: float) -> np.ndarray:
    columns = (
        [("q", i) for i in range(len(s.q))]
        + [("y", i) for i in range(len(s.y))]
        + [("lam", i) for i in range(len(s.lam))]
    )
    sides = [[testing.residual(mbs, moved(mbs, s, kind, i, x, w)) for x in (h, -h)] for kind, i in columns]
    matrix = np.array([(up - down) / (2 * h) for up, down in sides]).T
    first = len(s.q) + len(s.y)
    matrix[first:, :first] /= w.get("cq", 1.0) or w["cv"]
    return matrix


def check_tangent(variant: Variant, state: int, weights: Iterable[str] = WEIGHTS, exempt: bool = True) -> None:
    """Entry by entry: an entry of 1 has its own accuracy next to one of 1e4. Constraints by gaps, then by rates."""
    scene = variant.build(seed=3 + 10 * state)
    s = random_state(scene, seed=5 + 10 * state)
    if exempt and variant.item in HOLDS_JACOBIAN and variant.functions:
        s.lam = 0 * s.lam
        s.v = 0 * s.v
    for name, s.rate_level in itertools.product(weights, (False, True)):
        tangent = testing.tangent(scene.mbs, s, **WEIGHTS[name])
        fine, coarse = (differences(scene.mbs, s, WEIGHTS[name], h) for h in (STEP, 2 * STEP))
        wanted = fine + (fine - coarse) / 3
        terms = np.abs(wanted).max(axis=1, initial=1.0, keepdims=True)
        terms = terms + np.abs(testing.residual(scene.mbs, s))[:, None]
        allowed = LEFT * np.abs(fine - coarse) / 3 + ROUNDING * terms
        if variant.functions:
            allowed += OF_FUNCTIONS * terms
        wrong = np.argwhere(np.abs(tangent - wanted) > allowed)[:5]
        found = [(i, j, tangent[i, j], wanted[i, j], allowed[i, j]) for i, j in wrong]
        assert not found, (name, "rates" if s.rate_level else "gaps", found)


@each_variant
@pytest.mark.parametrize("state", STATES)
def test_tangent_is_the_derivative_of_the_residual(variant: Variant, state: int) -> None:
    check_tangent(variant, state)


@each_variant
def test_sparse_tangent_is_the_dense_one(variant: Variant) -> None:
    scene = variant.build(seed=4)
    s = random_state(scene, seed=6)
    dense, sparse = (testing.tangent(scene.mbs, s, **WEIGHTS["together"], dense=dense) for dense in (True, False))
    np.testing.assert_array_equal(sparse, dense)
    assert np.abs(dense).max() > 0
