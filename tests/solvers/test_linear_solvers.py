"""The sparse factorization by itself: saddle-point matrices, pivots, singular matrices, repetition with other values."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.sparse as sp

import dalembert as exu
from dalembert._core import testing
from dalembert.utilities import InertiaCuboid

EPS = np.finfo(float).eps
INSTRUCTIONS = testing.instruction_sets()


def solver_of(matrix: sp.csc_array, **options: object) -> testing.LinearSolver:
    return testing.LinearSolver(matrix.indptr, matrix.indices, **options)


def csc(matrix: np.ndarray) -> sp.csc_array:
    return sp.csc_array(matrix)


def backward_error(matrix: sp.csc_array, x: np.ndarray, b: np.ndarray) -> float:
    """Error bound of Oettli and Prager, by norm: how much the matrix must change to have x as its exact solution."""
    residual = np.abs(b - matrix @ x).max()
    return float(residual / (abs(matrix).sum(axis=1).max() * np.abs(x).max() + np.abs(b).max()))


def chain(bodies: int, seed: int, coordinates: int = 7, joints: int = 5, scale: float = 1.0) -> sp.csc_array:
    """Bodies in a row with joints between neighbours, a condition per body, and an unsymmetric part; all coordinates first.

    `scale` multiplies the stiffness part, as the step size does where joints are equations of positions.
    """
    rng = np.random.default_rng(seed)
    n, m = bodies * coordinates, bodies * (joints + 1)
    matrix = np.zeros((n + m, n + m))
    for i in range(bodies):
        own = slice(i * coordinates, (i + 1) * coordinates)
        inertia = rng.normal(size=(coordinates, coordinates))
        matrix[own, own] = scale * (
            inertia @ inertia.T + 3 * np.eye(coordinates) + 0.1 * rng.normal(size=inertia.shape)
        )
        row = n + i * (joints + 1)
        for body, rows in ((i, slice(row, row + joints + 1)), (i - 1, slice(row, row + joints))):
            if body < 0:
                continue
            columns = slice(body * coordinates, (body + 1) * coordinates)
            gradient = rng.normal(size=(rows.stop - rows.start, coordinates))
            matrix[rows, columns] = gradient
            matrix[columns, rows] = gradient.T
    return csc(matrix)


def grid(side: int, seed: int) -> sp.csc_array:
    """Masses at the points of a square grid with three coordinates each, springs between neighbours, values not symmetric."""
    rng = np.random.default_rng(seed)
    line = sp.diags_array([np.ones(side - 1), np.ones(side - 1)], offsets=[-1, 1])
    eye = sp.eye_array(side)
    neighbours = sp.kron(line, eye) + sp.kron(eye, line) + sp.kron(eye, eye)
    matrix = sp.csc_array(sp.kron(neighbours, np.ones((3, 3))))
    matrix.data = rng.uniform(-1, 1, matrix.nnz)
    return sp.csc_array(matrix + sp.diags_array(np.full(matrix.shape[0], 8.0)))


@pytest.mark.parametrize("instructions", INSTRUCTIONS)
@pytest.mark.parametrize(
    "matrix", [chain(1, 1), chain(2, 2), chain(40, 3), chain(25, 4, 4, 2), grid(4, 5), grid(24, 6), grid(52, 7)]
)
def test_solutions_are_backward_stable(matrix: sp.csc_array, instructions: str) -> None:
    solver = solver_of(matrix, instructions=instructions)
    assert solver.factorize(matrix.data) == -1
    b = np.sin(np.arange(matrix.shape[0]) + 1.0)
    # Pivots are at least 1e-3 of their columns: a few digits may be lost, in the mean less than one.
    assert backward_error(matrix, solver.solve(b), b) < 200 * EPS


@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
def test_pivots_within_fronts_are_as_good_as_any(scale: float) -> None:
    """Errors are those of a backward error near round-off in each entry, as of dense factors with partial pivoting."""
    for seed in range(40):
        matrix = chain(12, seed, scale=scale)
        exact = np.ones(matrix.shape[0])
        solver = solver_of(matrix)
        assert solver.factorize(matrix.data) == -1
        error = np.abs(solver.solve(matrix @ exact) - exact)
        sensitivity = np.abs(np.linalg.inv(matrix.toarray())) @ (abs(matrix) @ exact)  # Skeel's condition
        assert error.max() < 5 * EPS * sensitivity.max()


def test_instruction_sets_differ_by_rounding() -> None:
    matrix = chain(30, 7)
    b = np.cos(np.arange(matrix.shape[0]))
    solutions = []
    for instructions in INSTRUCTIONS:
        solver = solver_of(matrix, instructions=instructions)
        solver.factorize(matrix.data)
        solutions.append(solver.solve(b))
    bound = 200 * EPS * np.linalg.cond(matrix.toarray()) * np.abs(solutions[0]).max()
    for x in solutions[1:]:
        np.testing.assert_allclose(x, solutions[0], rtol=0, atol=bound)


def test_unknown_instructions_are_refused() -> None:
    with pytest.raises(ValueError, match="received 'abacus', which this processor does not have"):
        solver_of(chain(1, 1), instructions="abacus")


def test_repetition_agrees_with_a_new_solver() -> None:
    first = chain(20, 8)
    solver = solver_of(first)
    solver.factorize(first.data)
    b = np.ones(first.shape[0])
    for seed in range(9, 14):
        matrix = first.copy()
        matrix.data = first.data * np.random.default_rng(seed).uniform(0.8, 1.2, first.nnz)
        solver.factorize(matrix.data)
        assert backward_error(matrix, solver.solve(b), b) < 200 * EPS
    assert solver.statistics["pivot_searches"] == 1
    assert solver.statistics["factorizations"] == 6


def test_the_same_values_give_the_same_bits() -> None:
    matrix = grid(12, 15)
    b = np.arange(matrix.shape[0], dtype=float)
    solver, other = solver_of(matrix), solver_of(matrix)
    solver.factorize(matrix.data)
    first = solver.solve(b)
    solver.factorize(2.5 * matrix.data)
    solver.factorize(matrix.data)
    other.factorize(matrix.data)
    np.testing.assert_array_equal(solver.solve(b), first)
    np.testing.assert_array_equal(other.solve(b), first)


@pytest.mark.parametrize("seed", range(4))
def test_the_order_of_the_unknowns_does_not_matter(seed: int) -> None:
    matrix = chain(15, 16)
    b = np.sin(np.arange(matrix.shape[0]))
    expected = np.linalg.solve(matrix.toarray(), b)
    p = np.random.default_rng(seed).permutation(matrix.shape[0])
    shuffled = csc(matrix.toarray()[np.ix_(p, p)])
    solver = solver_of(shuffled)
    assert solver.factorize(shuffled.data) == -1
    bound = 200 * EPS * np.linalg.cond(matrix.toarray()) * np.abs(expected).max()
    np.testing.assert_allclose(solver.solve(b[p]), expected[p], rtol=0, atol=bound)


def test_patterns_are_completed() -> None:
    """Rows in any order, entries without those opposite to them, a diagonal with gaps: the solution of the dense
    matrix."""
    rng = np.random.default_rng(33)
    n = 40
    dense = np.where(rng.uniform(size=(n, n)) < 0.1, rng.normal(size=(n, n)), 0) + np.diag([4.0, 0] * (n // 2))
    dense += np.diag(np.full(n - 1, 3.0), 1)
    columns = [rng.permutation(np.flatnonzero(dense[:, j])) for j in range(n)]
    starts = np.cumsum([0, *map(len, columns)])
    solver = testing.LinearSolver(starts, np.concatenate(columns))
    assert solver.factorize(np.concatenate([dense[rows, j] for j, rows in enumerate(columns)])) == -1
    b = np.cos(np.arange(n))
    assert backward_error(csc(dense), solver.solve(b), b) < 200 * EPS


def test_the_order_keeps_the_factors_of_a_chain_sparse() -> None:
    """Entries per body do not grow with the number of bodies."""
    entries = []
    for bodies in (50, 100):
        matrix = chain(bodies, 17)
        solver = solver_of(matrix)
        solver.factorize(matrix.data)
        entries.append(solver.statistics["entries"] / bodies)
    assert entries[1] == pytest.approx(entries[0], rel=0.05)  # the ends differ from the rest
    assert entries[0] < 2 * 13 * 18  # at most twice the entries of a front of one body and the joint to the next one


def rigid_chain(bodies: int) -> exu.MainSystem:
    """Rigid bodies with Euler parameters and revolute joints, straight along the first axis."""
    mbs = exu.SystemContainer().AddSystem()
    previous = mbs.CreateGround()
    for i in range(bodies):
        body = mbs.CreateRigidBody(inertia=InertiaCuboid(1000, [1, 0.1, 0.1]), referencePosition=[i + 0.5, 0, 0])
        axis = [0, 0, 1] if i % 2 else [0, 1, 0]
        mbs.CreateRevoluteJoint(bodyNumbers=[previous, body], position=[i, 0, 0], axis=axis)
        previous = body
    mbs.Assemble()
    return mbs


def test_the_order_keeps_the_factors_of_an_aligned_chain_sparse() -> None:
    """Many entries are zero if bodies are along the axes, among them the inertia of one Euler parameter."""
    entries = []
    for bodies in (50, 100):
        mbs = rigid_chain(bodies)
        still, moved = testing.State(mbs), testing.State(mbs)
        rng = np.random.default_rng(bodies)
        for name in ("q", "v", "a", "lam"):
            value = getattr(moved, name)
            setattr(moved, name, value + 0.1 * rng.normal(size=len(value)))
        weights = {"cq": 1e-6, "cv": 1e-3, "ca": 1.0}
        pattern = csc(testing.tangent(mbs, moved, **weights))
        matrix = on_pattern(pattern, testing.tangent(mbs, still, **weights))
        solver = solver_of(matrix)
        assert solver.factorize(matrix.data) == -1
        entries.append(solver.statistics["entries"] / bodies)
    assert entries[1] == pytest.approx(entries[0], rel=0.05)
    assert entries[0] < 2 * 13 * 20


@pytest.mark.parametrize("scale", [1e-10, 1e-6, 1e6, 1e12])
def test_badly_scaled_multipliers(scale: float) -> None:
    """Constraints of positions with tiny or large steps: each block of equations holds to its own accuracy."""
    matrix = chain(20, 18, scale=scale)
    n = 20 * 7
    exact = np.ones(matrix.shape[0])
    exact[n:] = scale
    b = matrix @ exact
    solver = solver_of(matrix)
    assert solver.factorize(matrix.data) == -1
    x = solver.solve(b)
    balance = np.ones(matrix.shape[0])
    balance[:n] = 1 / np.sqrt(scale)
    balance[n:] = np.sqrt(scale)
    condition = np.linalg.cond(balance[:, None] * matrix.toarray() * balance[None, :])
    np.testing.assert_allclose(x[:n], exact[:n], rtol=1e3 * EPS * condition)
    np.testing.assert_allclose(x[n:], exact[n:], rtol=1e3 * EPS * condition)


def test_unknowns_without_stiffness_get_their_pivots_from_the_constraints() -> None:
    """Mechanisms that constraints determine completely: no diagonal at all."""
    rng = np.random.default_rng(19)
    g = np.eye(30) + np.diag(rng.normal(size=29), 1) + np.diag(rng.normal(size=27), 3)
    matrix = csc(np.block([[np.zeros((30, 30)), g.T], [g, np.zeros((30, 30))]]))
    solver = solver_of(matrix)
    assert solver.factorize(matrix.data) == -1
    b = rng.normal(size=60)
    assert backward_error(matrix, solver.solve(b), b) < 200 * EPS


def on_pattern(pattern: sp.csc_array, dense: np.ndarray) -> sp.csc_array:
    """The entries of a dense matrix on a pattern."""
    matrix = pattern.copy()
    matrix.data = dense[matrix.indices, np.repeat(np.arange(matrix.shape[1]), np.diff(matrix.indptr))]
    return matrix


def test_pivots_that_vanish_are_searched_again() -> None:
    """Masses and gradients are nonzero in one matrix and zero in the other; the statistics count the second search."""
    matrix = chain(10, 20)
    solver = solver_of(matrix)
    solver.factorize(matrix.data)
    other = matrix.toarray()
    n = 10 * 7
    other[:n, :n] *= 1e-14
    for i in range(10):
        row, column = n + i * 6, i * 7
        other[row : row + 5, column : column + 7] = np.fliplr(other[row : row + 5, column : column + 7])
    changed = on_pattern(matrix, other)
    b = np.ones(matrix.shape[0])
    assert solver.factorize(changed.data) == -1
    assert solver.statistics == {**solver.statistics, "factorizations": 2, "pivot_searches": 2}
    # The search accepts a backward error of 1e-12 in the scaled matrix, whose multipliers count 1e14 times here.
    scale = np.ones(matrix.shape[0])
    scale[n:] = 1e-14
    scaled = sp.csc_array(sp.diags_array(scale) @ changed @ sp.diags_array(scale))
    assert backward_error(scaled, solver.solve(b) / scale, b * scale) < 2e-12
    solver.factorize(matrix.data)
    assert backward_error(matrix, solver.solve(b), b) < 2e-12


def test_a_zero_pivot_is_replaced() -> None:
    matrix = csc(np.array([[2.0, 1, 0], [1, 1, 1], [0, 1, 3]]))
    solver = solver_of(matrix)
    solver.factorize(matrix.data)
    dense = np.array([[0.0, 1, 0], [1, 1e-300, 1], [0, 1, 3]])
    assert solver.factorize(on_pattern(matrix, dense).data) == -1
    b = np.array([1.0, 2, 3])
    np.testing.assert_allclose(solver.solve(b), np.linalg.solve(dense, b), rtol=0, atol=20 * EPS)


def test_a_singular_matrix_names_an_unknown_that_is_free() -> None:
    """Two equal constraints: the column is one of the multipliers whose sum alone is determined."""
    dense = chain(5, 21).toarray()
    n = 5 * 7
    first, second = n + 8, n + 9
    dense[second] = dense[first]
    dense[:, second] = dense[:, first]
    matrix = csc(dense)
    solver = solver_of(matrix, pivot_threshold=1e-12)  # equal up to round-off of the elimination
    assert solver.factorize(matrix.data) in (first, second)


@pytest.mark.parametrize("loose", [0, 13, 34])
def test_an_unknown_without_equation_is_named(loose: int) -> None:
    dense = chain(5, 22).toarray()
    dense[loose] = 0
    dense[:, loose] = 0
    matrix = csc(dense)
    assert solver_of(matrix).factorize(matrix.data) == loose


def test_singular_matrices_can_be_solved_as_far_as_they_determine_the_unknowns() -> None:
    dense = chain(5, 23).toarray()
    n = 5 * 7
    first, second = n + 8, n + 9
    dense[second] = dense[first]
    dense[:, second] = dense[:, first]
    matrix = csc(dense)
    solver = solver_of(matrix, ignore_singular=True)
    exact = np.sin(np.arange(matrix.shape[0]))
    for scale in (1.0, 3.0):
        assert solver.factorize(scale * matrix.data) == -1
        x = solver.solve(scale * (matrix @ exact))
        bound = 1e-11  # condition of the regular part times round-off
        np.testing.assert_allclose(x[:n], exact[:n], rtol=0, atol=bound)
        assert x[first] + x[second] == pytest.approx(exact[first] + exact[second], abs=bound)
        assert 0 in (x[first], x[second])


def test_nothing_but_numbers_can_be_factorized() -> None:
    matrix = chain(3, 24)
    solver = solver_of(matrix)
    solver.factorize(matrix.data)
    data = matrix.data.copy()
    data[0] = np.nan
    assert solver.factorize(data) >= 0
    assert solver.factorize(matrix.data) == -1


@pytest.mark.parametrize("size", [1, 2, 3, 5, 8, 13, 40])
def test_dense_matrices(size: int) -> None:
    rng = np.random.default_rng(size)
    matrix = csc(rng.normal(size=(size, size)))
    solver = solver_of(matrix, dense=True)
    b = rng.normal(size=size)
    for _ in range(2):
        assert solver.factorize(matrix.data) == -1
        assert backward_error(matrix, solver.solve(b), b) < 50 * EPS


def test_pivots_of_dense_matrices_are_searched_again() -> None:
    first, second = np.diag([1.0, 2, 3, 4, 5]) + 0.1, np.fliplr(np.diag([1.0, 2, 3, 4, 5]))
    solver = solver_of(csc(first), dense=True)
    b = np.arange(5.0)
    for matrix, searches in ((first, 1), (2 * first, 1), (second, 2), (3 * second, 2)):
        assert solver.factorize(matrix.T.ravel()) == -1
        np.testing.assert_allclose(solver.solve(b), np.linalg.solve(matrix, b), rtol=0, atol=20 * EPS * 5)
        assert solver.statistics["pivot_searches"] == searches


@pytest.mark.parametrize("instructions", INSTRUCTIONS)
@pytest.mark.parametrize("size", [4, 5, 11, 17, 32])
def test_leaving_out_zeros_changes_no_digit(size: int, instructions: str) -> None:
    """The second solver has met a full matrix with the same pivots, and treats all entries as different from zero."""
    rng = np.random.default_rng(size)
    full = rng.uniform(-1, 1, size=(size, size)) + 20 * np.eye(size)[rng.permutation(size)]
    b = rng.normal(size=size)
    solvers = [solver_of(csc(full), dense=True, instructions=instructions) for _ in range(2)]
    solvers[1].factorize(full.T.ravel())
    kept = np.abs(full) > 2
    for share in (0.05, 0.1, 0.1):  # entries come and go
        matrix = np.where(kept | (rng.uniform(size=full.shape) < share), full, 0)
        for solver in solvers:
            assert solver.factorize(matrix.T.ravel()) == -1
        x = solvers[0].solve(b)
        np.testing.assert_array_equal(solvers[1].solve(b), x)
        np.testing.assert_allclose(x, np.linalg.solve(matrix, b), rtol=0, atol=100 * EPS * np.abs(b).max())


def test_singular_dense_matrices() -> None:
    """The third column is the sum of the first two."""
    matrix = csc(np.array([[1.0, 2, 3], [4, 1, 5], [1, 1, 2]]))
    assert solver_of(matrix, dense=True, pivot_threshold=1e-12).factorize(matrix.data) == 2
    solver = solver_of(matrix, dense=True, ignore_singular=True)
    assert solver.factorize(matrix.data) == -1
    b = matrix @ np.array([1.0, -1, 2])
    np.testing.assert_allclose(matrix @ solver.solve(b), b, rtol=0, atol=50 * EPS)


def test_zeros_of_the_pattern_take_no_part_before_they_change() -> None:
    """The masses of a net on the pattern of its tangent, then the tangent itself."""
    tangent = grid(20, 25)
    masses = tangent.copy()
    masses.data = np.where(np.abs(tangent.data) > 2, tangent.data, 0)
    b = np.sin(np.arange(tangent.shape[0]))
    solver = solver_of(tangent)
    for factor in (1.0, 2.0):
        assert solver.factorize(factor * masses.data) == -1
        # One division each.
        np.testing.assert_allclose(solver.solve(b), b / (factor * masses.diagonal()), rtol=2 * EPS)
    assert solver.statistics["entries"] < 10 * tangent.shape[0]
    assert solver.factorize(tangent.data) == -1
    assert backward_error(tangent, solver.solve(b), b) < 200 * EPS
    assert solver.statistics == {**solver.statistics, "factorizations": 3, "pivot_searches": 2}
    assert solver.factorize(masses.data) == -1
    assert backward_error(masses, solver.solve(b), b) < 200 * EPS


@pytest.mark.parametrize("orders", [3, 50], ids=["kept", "replaced"])
def test_orders_of_pivots_that_come_back_give_the_same_bits(orders: int) -> None:
    """Matrices whose pivots alternate, each twice in a row; lists of operations are kept for 32 orders."""
    rng = np.random.default_rng(7)
    pattern = rng.random((12, 12)) < 0.2
    matrices = [(pattern * rng.normal(size=(12, 12)) + 4 * np.eye(12))[rng.permutation(12)] for _ in range(orders)]
    full = csc(np.ones((12, 12)))
    solver, b = solver_of(full, dense=True), np.arange(12.0)
    for matrix in 3 * matrices:
        expected = solver_of(full, dense=True)
        expected.factorize(matrix.T.ravel())
        for _ in range(2):
            assert solver.factorize(matrix.T.ravel()) == -1
            np.testing.assert_array_equal(solver.solve(b), expected.solve(b))
    assert solver.statistics["pivot_searches"] == 3 * orders


@pytest.mark.parametrize("stays", [True, False])
def test_zeros_of_unsettled_matrices_take_part(stays: bool) -> None:
    """The whole net, then its masses: zeros are left out when they are those of the third matrix."""
    tangent = grid(20, 25)
    masses = tangent.copy()
    masses.data = np.where(np.abs(tangent.data) > 2, tangent.data, 0)
    b = np.sin(np.arange(tangent.shape[0]))
    solver = solver_of(tangent, unsettled_matrices=2)
    entries = []
    for matrix in (masses, tangent, masses if stays else tangent, tangent):
        assert solver.factorize(matrix.data) == -1
        assert backward_error(matrix, solver.solve(b), b) < 200 * EPS
        entries.append(solver.statistics["entries"])
    whole, fewer = entries[0], entries[2] < 0.2 * entries[0]
    assert entries == [whole, whole, entries[2], whole]
    assert fewer == stays
    assert solver.statistics == {**solver.statistics, "factorizations": 4, "pivot_searches": 3 if stays else 1}


@pytest.mark.parametrize("instructions", INSTRUCTIONS)
@pytest.mark.parametrize("multipliers", [0, 1])
def test_blocks_of_all_sizes(multipliers: int, instructions: str) -> None:
    """A star of dense blocks with 1 to 21 unknowns around 13 others: groups of pivots and rows below them of all lengths."""
    rng = np.random.default_rng(26)
    sizes = np.arange(1, 22)
    centre, ends = 13, np.cumsum(sizes)
    n = int(ends[-1]) + centre
    matrix = np.zeros((n, n))
    matrix[-centre:, -centre:] = rng.normal(size=(centre, centre)) + 30 * np.eye(centre)
    for size, end in zip(sizes, ends, strict=True):
        own, outer = slice(end - size, end), n - centre + np.arange(1 + size % centre)
        matrix[own, own] = rng.normal(size=(size, size)) + 2 * size * np.eye(size)
        matrix[own, outer] = rng.normal(size=(size, outer.size))
        matrix[outer, own] = rng.normal(size=(outer.size, size))
        if multipliers and size > 1:  # the last two are each other's pivots
            matrix[end - 1, end - 1] = matrix[end - 2, end - 2] = 0
            matrix[end - 1, end - 2] = matrix[end - 2, end - 1] = 5
    whole = csc(matrix)
    solver = solver_of(whole, instructions=instructions)
    for factor in (1.0, -3.0):
        assert solver.factorize(factor * whole.data) == -1
        for b in (np.ones(n), rng.normal(size=n)):
            assert backward_error(factor * whole, solver.solve(b), b) < 200 * EPS
    assert solver.statistics["pivot_searches"] == 1


def test_small_diagonal_entries_are_no_pivots() -> None:
    """Constraints with a compliance near round-off: no diagonal entry is zero, yet pivots must be exchanged."""
    matrix = chain(30, 27).toarray()
    n = 30 * 7
    matrix[range(n, matrix.shape[0]), range(n, matrix.shape[0])] = -1e-14
    compliant = csc(matrix)
    solver = solver_of(compliant)
    b = np.sin(np.arange(matrix.shape[0]))
    for _ in range(2):
        assert solver.factorize(compliant.data) == -1
        assert backward_error(compliant, solver.solve(b), b) < 200 * EPS


def sparse_on_dense_pattern(rng: np.random.Generator, n: int) -> sp.csc_array:
    """Unknowns with neighbours between others without, most entries of the pattern being zero."""
    matrix = np.diag(rng.uniform(1, 2, n))
    coupled = np.arange(2, n, 5)
    matrix[np.ix_(coupled, coupled)] += np.eye(coupled.size) * 3 + 0.2 * rng.normal(size=(coupled.size, coupled.size))
    return on_pattern(csc(np.ones((n, n))), matrix)


def test_unknowns_with_and_without_neighbours() -> None:
    rng = np.random.default_rng(28)
    matrix = sparse_on_dense_pattern(rng, 43)
    solver = solver_of(matrix)
    b = rng.normal(size=43)
    for factor in (1.0, 0.1):
        assert solver.factorize(factor * matrix.data) == -1
        exact = np.linalg.solve(factor * matrix.toarray(), b)
        np.testing.assert_allclose(solver.solve(b), exact, rtol=0, atol=100 * EPS * np.abs(exact).max())


@pytest.mark.parametrize("loose", [0, 7, 40])
def test_an_unknown_without_equation_or_neighbours(loose: int) -> None:
    dense = sparse_on_dense_pattern(np.random.default_rng(29), 43).toarray()
    dense[loose] = dense[:, loose] = 0
    matrix = on_pattern(csc(np.ones((43, 43))), dense)
    assert solver_of(matrix).factorize(matrix.data) == loose
    solver = solver_of(matrix, ignore_singular=True)
    assert solver.factorize(matrix.data) == -1
    exact = np.cos(np.arange(43))
    exact[loose] = 0
    np.testing.assert_allclose(solver.solve(dense @ exact), exact, rtol=0, atol=100 * EPS)


@pytest.mark.parametrize("noise", [0.0, 1e-27, 1e-15])
@pytest.mark.parametrize("seed", range(5))
def test_round_off_on_the_diagonal_is_not_a_scale(seed: int, noise: float) -> None:
    """Bodies with one spring each, as in static solutions. Unknowns were scaled by 1e-27 next to zeros with round-off,
    and solutions were wrong by 1e12 without a message."""
    bodies = 6
    matrix, n = chain(bodies, seed).toarray(), 7 * bodies
    matrix[:n, :n] = 0
    for i in range(bodies):
        matrix[7 * i, 7 * i] = 3e4
        matrix[7 * i + 3, 7 * i + 3], matrix[7 * i + 4, 7 * i + 4] = noise, -noise / 3
    pattern = csc((matrix != 0) | np.eye(len(matrix), dtype=bool))
    solver = solver_of(pattern)
    rows, columns = pattern.indices, np.repeat(np.arange(len(matrix)), np.diff(pattern.indptr))
    assert solver.factorize(matrix[rows, columns]) == -1
    right = np.random.default_rng(seed).normal(size=len(matrix))
    x = np.asarray(solver.solve(right))
    wanted = np.linalg.solve(matrix, right)
    assert np.abs(x - wanted).max() < EPS * np.linalg.cond(matrix) * np.abs(wanted).max()


def redundant_equations(seed: int) -> tuple[np.ndarray, np.ndarray, testing.ProximalSolver]:
    """A and G of 12 coordinates and 8 equations, three of which follow from others, and their factors; D is 1."""
    rng = np.random.default_rng(seed)
    root = rng.normal(size=(12, 12))
    independent = rng.normal(size=(5, 12))
    A, G = root @ root.T + np.eye(12), np.vstack([independent, rng.normal(size=(3, 5)) @ independent])
    matrix = csc(np.block([[A, G.T], [G, np.zeros((8, 8))]]))
    solver = testing.ProximalSolver(matrix.indptr, matrix.indices, np.ones(8))
    assert solver.factorize(matrix.data, 1e-9) == -1
    return A, G, solver


@pytest.mark.parametrize("seed", range(5))
def test_redundant_equations_are_fulfilled(seed: int) -> None:
    """x is that of the minimum of x^T A x / 2 - f^T x on the plane G x = g, by a basis of its directions."""
    A, G, solver = redundant_equations(seed)
    rng = np.random.default_rng(seed + 100)
    f, point = rng.normal(size=12), rng.normal(size=12)
    free = np.linalg.svd(G)[2][5:].T
    wanted = point + free @ np.linalg.solve(free.T @ A @ free, free.T @ (f - A @ point))
    x = solver.solve(np.concatenate([f, G @ point]))[:12]
    np.testing.assert_allclose(x, wanted, rtol=0, atol=1e-10 * np.abs(wanted).max())  # refined to 1e-12


@pytest.mark.parametrize("seed", range(5))
def test_the_misfit_is_what_no_motion_closes(seed: int) -> None:
    """It is g minus its closest values G x, in the metric D = 1; without it, gaps are closed exactly."""
    _, G, solver = redundant_equations(seed)
    gaps = np.random.default_rng(seed + 200).normal(size=8)
    closest = G @ np.linalg.lstsq(G, gaps, rcond=1e-12)[0]
    misfit = solver.misfit(gaps)
    x = solver.solve(np.concatenate([np.zeros(12), gaps]), fit=False)[:12]
    np.testing.assert_allclose(misfit, gaps - closest, rtol=0, atol=1000 * EPS)
    np.testing.assert_allclose(G @ x, closest, rtol=0, atol=1000 * EPS)
