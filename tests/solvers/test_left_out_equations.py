"""Equations that follow from others and are left out of a matrix: the minimum-norm multipliers, and the dropped
equations after a change."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.sparse as sp

from dalembert._core import testing

Parts = list[tuple[list[int], list[int]]]


class Model:
    """Masses held by equations; all entries of the pattern are there, such that equations may change."""

    def __init__(self, gradients: np.ndarray, seed: int = 1) -> None:
        self.rng = np.random.default_rng(seed)
        m, n = gradients.shape
        inertia = self.rng.normal(size=(n, n))
        self.mass = inertia @ inertia.T + n * np.eye(n)
        self.weights = self.rng.uniform(0.5, 2, size=m)
        self.pattern = sp.csc_array(np.ones((n + m, n + m)))
        self.gradients = gradients

    def data(self) -> np.ndarray:
        m = len(self.gradients)
        matrix = np.block([[self.mass, self.gradients.T], [self.gradients, np.zeros((m, m))]])
        return matrix.ravel(order="F")

    def leave_out(self, parts: Parts, dense: bool = False) -> testing.LeftOutEquations:
        return testing.LeftOutEquations(
            self.pattern.indptr, self.pattern.indices, parts, self.weights.tolist(), dense=dense
        )

    def smallest(self, multipliers: np.ndarray) -> np.ndarray:
        """Computed by the pseudo-inverse."""
        root = np.sqrt(self.weights)
        forces = self.gradients.T @ multipliers
        return np.asarray(np.linalg.pinv(self.gradients.T / root, rcond=1e-9) @ forces / root)

    def assert_smallest(self, left_out: testing.LeftOutEquations) -> None:
        multipliers = self.rng.normal(size=len(self.gradients))
        found = left_out.smallest(self.data(), multipliers.tolist())
        assert found is not None
        assert np.asarray(found) == pytest.approx(self.smallest(multipliers), abs=1e-10)


def doubled(seed: int = 2, n: int = 12) -> Model:
    """Ten equations. Number 3 follows from 0 to 2, number 4 from 1; number 9 from 7 and 8; 5 and 6 are alone."""
    gradients = np.random.default_rng(seed).normal(size=(10, n))
    gradients[3] = gradients[0] + 2 * gradients[1] - gradients[2]
    gradients[4] = -1.5 * gradients[1]
    gradients[9] = gradients[7] - gradients[8]
    return Model(gradients, seed)


PARTS: Parts = [([0, 1, 2, 3, 4], [3, 4]), ([7, 8, 9], [9])]


@pytest.mark.parametrize("dense", [False, True], ids=["sparse", "dense"])
def test_multipliers_become_the_smallest(dense: bool) -> None:
    model = doubled()
    left_out = model.leave_out(PARTS, dense)
    for _ in range(3):
        model.assert_smallest(left_out)
    assert left_out.better() == []
    assert left_out.solutions == 2  # numbers 3 and 4 have equations in common, number 9 has not


def test_one_solution_finds_independent_combinations() -> None:
    """Parts know which terms belong to which combination."""
    gradients = np.random.default_rng(3).normal(size=(9, 12))
    gradients[2], gradients[5], gradients[8] = gradients[0] + gradients[1], gradients[3] - gradients[4], gradients[7]
    model = Model(gradients)
    left_out = model.leave_out([([0, 1, 2], [2]), ([3, 4, 5], [5]), ([7, 8], [8])])
    model.assert_smallest(left_out)
    assert left_out.solutions == 1


def test_combinations_may_gain_equations() -> None:
    """The same occurs when a mechanism leaves a symmetric position: combinations without common equations have some
    then."""
    model = doubled()
    left_out = model.leave_out(PARTS)
    model.assert_smallest(left_out)
    model.gradients[9] = model.gradients[7] + model.gradients[5] - 0.3 * model.gradients[0]
    model.assert_smallest(left_out)
    model.gradients[4] = model.gradients[8]
    model.assert_smallest(left_out)
    assert left_out.solutions == 2  # numbers 3 and 9 have number 0 in common, number 4 has none of theirs


def test_equations_that_became_independent_are_reported() -> None:
    model = doubled()
    left_out = model.leave_out(PARTS)
    model.gradients[9] = np.random.default_rng(4).normal(size=12)
    assert left_out.smallest(model.data(), [1.0] * 10) is None
    model.gradients[9] = model.gradients[7] - model.gradients[8]
    model.assert_smallest(left_out)


def test_forces_may_miss_each_other_by_round_off_alone() -> None:
    """The residual of a combination is compared with the effect of each of its equations, to 1e-8."""
    for off, follows in ((1e-10, True), (1e-6, False)):
        model = doubled()
        model.gradients[9] += off * np.random.default_rng(4).normal(size=12)
        left_out = model.leave_out(PARTS)
        assert (left_out.smallest(model.data(), [1.0] * 10) is not None) == follows


def test_outgrown_equations_are_taken_for_others() -> None:
    """Errors of dropped equations grow with multipliers of others in their combination: more than 10 times are too
    many."""
    model = doubled()
    model.weights[:] = 1
    left_out = model.leave_out(PARTS)
    model.assert_smallest(left_out)
    assert left_out.better() == []
    model.gradients[9] *= 20
    model.assert_smallest(left_out)
    better = sorted(left_out.better())
    assert [part for part, _ in better] == [part for part, _ in PARTS]
    assert len(better[0][1]) == 2 and better[1][1] in ([7], [8])
    others = model.leave_out(better)
    model.assert_smallest(others)
    assert others.better() == []


@pytest.mark.parametrize("unit", [1e-11, 1e11])
def test_moments_may_be_measured_in_other_units(unit: float) -> None:
    """Terms are small relative to others by their weights, not by their values."""
    model = doubled()
    model.gradients[[1, 4, 7]] /= unit  # their multipliers are larger accordingly
    model.weights[[1, 4, 7]] /= unit**2
    left_out = model.leave_out(PARTS)
    multipliers = model.rng.normal(size=10)
    multipliers[[1, 4, 7]] *= unit
    found = left_out.smallest(model.data(), multipliers.tolist())
    assert found is not None
    assert found / np.sqrt(1 / model.weights) == pytest.approx(
        model.smallest(multipliers) / np.sqrt(1 / model.weights), abs=1e-9
    )


def test_equations_without_weight_have_a_part() -> None:
    """Conditions of unit length follow from joints that say the same of parameters of rotation."""
    model = doubled()
    model.gradients[9] = model.gradients[7] + model.gradients[5]
    model.weights[5] = 0
    left_out = model.leave_out(PARTS)
    multipliers = model.rng.normal(size=10)
    found = np.asarray(left_out.smallest(model.data(), multipliers.tolist()))
    assert model.gradients.T @ found == pytest.approx(model.gradients.T @ multipliers, abs=1e-10)
    idle = np.zeros(10)  # numbers 5, 7, 9
    idle[[5, 7, 9]] = 1, 1, -1
    assert (model.weights * found) @ idle == pytest.approx(0, abs=1e-10)


@pytest.mark.parametrize(("count", "found"), [(40, True), (60, False)])
def test_large_models_do_not_look_at_all_equations_for_each(count: int, found: bool) -> None:
    """Masses with separate constraints: the dropped equation follows from two others, one of which is outside of its
    part.
    Beyond a million terms, they are
    included again."""
    n = 20_000
    dependent = sp.coo_array(
        (np.ones(2 * count), (np.repeat(np.arange(count), 2), np.arange(2 * count))), shape=(count, n)
    )
    gradients = sp.vstack([sp.eye_array(n), dependent])
    matrix = sp.block_array([[sp.eye_array(n), gradients.T], [gradients, None]], format="csc")
    matrix.sort_indices()
    parts = [([2 * i, n + i], [n + i]) for i in range(count)]
    left_out = testing.LeftOutEquations(matrix.indptr, matrix.indices, parts, [1.0] * (n + count))
    multipliers = np.zeros(n + count)
    multipliers[n:] = 3.0
    smallest = left_out.smallest(matrix.data, multipliers.tolist())
    assert (smallest is not None) == found
    if smallest is not None:
        wanted = np.r_[np.ones(2 * count), np.zeros(n - 2 * count), np.full(count, 2.0)]
        np.testing.assert_allclose(smallest, wanted, rtol=0, atol=1e-12)
